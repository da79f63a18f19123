//! Units and digits of answers: the same text in other units, the same JSON.

mod common;

use common::{assess, near, number, refused};
use standfast_cases::results::ResultName;
use standfast_cases::{AssessmentView, Document};

/// Cases with loads of every kind that are told in text.
const CASES: [&str; 6] = [
    "[body]\nwidth = 7.5\nheight = 11\ndensity = 2300\nfriction = 0.6\n[water]\nleft = 9\nright = 9.5\ndensity = 1025\n[[backfill]]\nname = \"sand\"\n\
     face = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 22\nunit_weight = 18e3\nunit_weight_saturated = 20e3\nsurcharge = 20e3\n\
     [[combination]]\nname = \"all\"\nfactors = { sand = [1.35, 1], \"sand.surcharge\" = 1.5 }\nset = { \"backfill.sand.surcharge\" = 21e3 }\n\
     criteria = { SF_sliding = 1, bearing_max = 600e3 }\n",
    "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 7.1\ndensity = 1030\n[wave]\nH13 = 5.8\nHmax = 8\nperiod = 11.4\n\
     sea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\nangle_deg = 15\n\
     water_density = 1030\n[criteria]\nSF_sliding = 1.2\nbearing_max = 400e3\neccentricity = 3\n",
    "[body]\nwidth = 16\nheight = 17\nmass = 598e3\nfriction = 0.6\n[water]\nlevel = 11\ndensity = 1030\n[wave]\nformula = \"sainflou\"\n\
     height = 4.5\nphase = \"crest\"\nperiod = 9\nwater_depth = 14\nstill_water = 11\ncrest_height = 6\nwater_density = 1030\n",
    "[body]\nwidth = 8\nheight = 3.5\nmass = 66e3\nfriction = 0.6\n[wave]\nformula = \"pedersen\"\nH13 = 4\nperiod = 8.6\nwater_density = 1025\n\
     armour_slope = 2\narmour_crest = 4\narmour_width = 5\nprotected_height = 2\nfree_height = 1.5\n",
    "[body]\nwidth = 6\nheight = 10\nmass = 122e3\nfriction = 0.5\nadhesion = 20e3\n[[load]]\nforce = 590e3\nelevation = 7\ntogether = true\n\
     [[moment]]\nmoment = 90e3\ntogether = true\n[[resistance]]\nname = \"tie\"\nlimit = 180e3\ndirection = \"right\"\nelevation = 9\n",
    "[body]\nwidth = 5\nheight = 9\ndensity = 2400\nfriction = 0.7\n[water]\nleft = 1\nright = 8\ndensity = 1000\n\
     drain = { distance = 2.5, efficiency = 0.5 }\n[[load]]\nname = \"ice\"\nforce = 20e3\nelevation = 8\n",
];

/// Units and their size, those of two words first; written here again, as a witness.
const UNITS: [(&str, f64); 9] = [
    ("kip ft/ft", 4_448.221_615_260_5),
    ("kN m/m", 1e3),
    ("kip/ft", 14_593.902_937_206_36),
    ("kN/m", 1e3),
    ("kgf/cm²", 98_066.5),
    ("kPa", 1e3),
    ("ft", 0.3048),
    ("m", 1.0),
    ("%", 0.01),
];

/// Every number with a unit of these, in SI units, in its order.
fn measured(text: &str) -> Vec<(f64, String)> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let bare = |word: &str| word.trim_matches(['(', ')', ',', ';', ':', '.']).to_owned();
    let mut found = Vec::new();
    for at in 0..words.len() {
        let Ok(number) = bare(words[at]).parse::<f64>() else { continue };
        let behind =
            |count: usize| words[at + 1..].iter().take(count).map(|word| bare(word)).collect::<Vec<_>>();
        let unit = UNITS.iter().find(|(unit, _)| behind(unit.split(' ').count()).join(" ") == *unit);
        found.extend(unit.map(|(unit, size)| (number * size, format!("{number} {unit}"))));
    }
    found
}

#[test]
fn the_text_says_the_same_in_other_units() {
    let mut compared = 0;
    for case in CASES {
        let text = |output: &str| assess(&format!("{output}{case}")).text(&AssessmentView::default());
        let metric = text("[output]\ndigits = 12\n");
        let feet =
            text("[output]\nforce = \"kip/ft\"\npressure = \"kgf/cm2\"\nlength = \"ft\"\ndigits = 12\n");
        let [metric, feet] = [metric, feet].map(|text| measured(&text));
        assert_eq!(metric.len(), feet.len(), "{metric:?}\n{feet:?}");
        for ((one, said), (other, of)) in metric.iter().zip(&feet) {
            assert!((one - other).abs() <= 1e-9 * one.abs(), "{said} is not {of}: {metric:?}\n{feet:?}");
            compared += 1;
        }
        let has = |words: &str| feet.iter().any(|(_, said)| said.ends_with(words));
        assert!(has(" kip/ft") && has(" ft") && !has(" kN/m"), "{feet:?}");
    }
    assert!(compared > 200, "{compared}");
}

/// Digits of what has a unit, and of factors.
#[test]
fn digits_are_those_asked_for() {
    for digits in [3, 7] {
        let assessment = assess(&format!("[output]\ndigits = {digits}\n{}", CASES[1]));
        let text = assessment.text(&AssessmentView::default());
        let last = |words: &str| {
            let line = text.lines().find(|line| line.contains(words)).unwrap_or_else(|| panic!("{text}"));
            line.split_whitespace().last().unwrap().to_owned()
        };
        let of = |words: &str| {
            let line = text.lines().find(|line| line.trim_start().starts_with(words)).unwrap();
            line.split_whitespace().nth(1).unwrap().to_owned()
        };
        for (shown, value) in [
            (of("P  "), number(assessment.governing(), ResultName::P) / 1e3),
            (last("μ(W' − U)/P"), number(assessment.governing(), ResultName::SfSliding)),
        ] {
            let place = value.log10().floor() as i32 - digits + 1;
            near(shown.parse().unwrap(), value, 0.500_001 * 10f64.powi(place));
            assert_eq!(shown.chars().filter(char::is_ascii_digit).count() as i32, digits, "{shown}");
        }
    }
}

/// What programs read stays in SI units.
#[test]
fn the_json_stays_as_it_is() {
    for case in CASES {
        let json = |output: &str| assess(&format!("{output}{case}")).json(&AssessmentView::default(), &[]);
        let of_numbers = |text: String| -> serde_json::Value {
            let mut json: serde_json::Value = serde_json::from_str(&text).unwrap();
            // Sentences and bounds are read by people.
            json["summary"].take();
            json["criteria"].take();
            for situation in json["situations"].as_array_mut().unwrap() {
                for words in ["criteria", "combination", "sentences"] {
                    situation[words].take();
                }
            }
            json
        };
        let plain = of_numbers(json(""));
        let other = of_numbers(json("[output]\nforce = \"MN/m\"\npressure = \"psi\"\nlength = \"mm\"\n"));
        assert_eq!(plain, other);
    }
}

#[test]
fn what_is_no_unit_of_answers_is_refused() {
    let body =
        "[body]\nwidth = 1\nheight = 2\nmass = 2e3\nfriction = 0.5\n[[load]]\nforce = 1e3\nelevation = 1\n";
    for (output, words) in [
        ("force = \"kN\"", "the unit `kN` does not fit; expected a force per metre run"),
        ("force = \"kPa\"", "the unit `kPa` does not fit"),
        ("pressure = 5", "`pressure` is a number; expected a text in quotes"),
        ("digits = 2", "expected a whole number from 3 to 12"),
        ("digits = 4.5", "expected a whole number from 3 to 12"),
        ("mass = \"t/m\"", "[output] has no key `mass`"),
    ] {
        let error = refused(&format!("[output]\n{output}\n{body}"));
        assert!(error.contains(words), "{output}: {error}");
    }
    // Of an object forces are those of the whole.
    let whole = body.replace("height = 2", "height = 2\nlength = 1");
    assess(&format!("[output]\nforce = \"kN\"\n{whole}"));
    let error = refused(&format!("[output]\nforce = \"kN/m\"\n{whole}"));
    assert!(error.contains("a force on the whole object"), "{error}");
}
