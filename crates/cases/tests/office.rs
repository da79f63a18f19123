//! Files of an office's code against the sets that the program has, against combinations that write the same, and what is refused.

mod common;

use common::near;
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document, Explained};

const QUAY: &str = include_str!("../../../examples/quay-by-code.toml");
const WALL: &str = include_str!("../../../examples/l-wall.toml");
const RACK: &str = include_str!("../../../examples/rack-with-ties.toml");

const DA2: &str = "factors = { permanent = [1.35, 1], variable = [1.5, 0] }\n\
    resist = { sliding = 1.1, bearing = 1.4, passive = 1.4 }\ncriteria = { SF_sliding = 1.0, ground_factor = 1.0 }\n";
const DA1_2: &str = "factors = { permanent = 1, variable = [1.3, 0] }\n\
    materials = { friction = 1.25, adhesion = 1.25, friction_angle_deg = 1.25, cohesion = 1.25, strength = 1.4 }\n\
    criteria = { SF_sliding = 1.0, ground_factor = 1.0 }\n";

/// The answer to a case whose combinations may name `office.toml`.
fn assess(text: &str, office: &str) -> Result<Assessment, (String, String)> {
    let read = |name: &str| match name {
        "office.toml" => Ok(office.to_owned()),
        _ => Err("there is no such file".to_owned()),
    };
    let file = CaseFile::read("case.toml", text, &read);
    let answered = file.and_then(|file| Assessment::of_file(&file));
    answered.map_err(|error| (error.to_string(), error.help().unwrap_or_default()))
}

fn same(one: &Assessment, two: &Assessment, what: &str) {
    assert_eq!(one.all.len(), two.all.len(), "{what}");
    for (one, two) in one.all.iter().zip(&two.all) {
        for result in ResultName::ALL {
            match (result.of(one), result.of(two)) {
                (ResultValue::Number(one), ResultValue::Number(two)) => near(one, two, 1e-12),
                (one, two) => assert_eq!(one, two, "{what}: {}", result.name()),
            }
        }
    }
    let checks = |answer: &Assessment| {
        let checks = answer.checks().iter().map(|check| check.check.criterion.name()).collect::<Vec<_>>();
        (answer.met(), checks)
    };
    assert_eq!(checks(one), checks(two), "{what}");
}

/// A file that says what a set says gives its answer; of a case with soil, with water, with a part, on ground.
#[test]
fn a_file_is_the_set_that_it_says() {
    let ground = "[ground]\nfriction_angle_deg = 35\nunit_weight = \"10 kN/m3\"\ncohesion = \"5 kPa\"\n";
    for (code, office) in [("EN1997-DA2", DA2), ("EN1997-DA1-2", DA1_2)] {
        for (name, case) in [("quay", QUAY), ("wall", WALL)] {
            for ground in ["", ground] {
                // Without what another combination sets or undoes.
                let head = case.split("[[combination]]").next().unwrap();
                let factors = if name == "quay" { "factors = { earthquake = 0 }\n" } else { "" };
                let by = |code: &str| format!("{head}{ground}[[combination]]\ncode = \"{code}\"\n{factors}");
                let set = assess(&by(code), "").unwrap();
                let file = assess(&by("office.toml"), office).unwrap();
                same(&set, &file, &format!("{name}, {code}"));
            }
        }
    }
}

/// What the combination writes goes before what the file says, by name; a load that is named before its kind.
#[test]
fn what_is_written_goes_before_the_file() {
    let head = QUAY.split("[[combination]]").next().unwrap();
    let office =
        "factors = { permanent = [1.35, 1], variable = 1.5, water = 1.2 }\nresist = { sliding = 1.1 }\n";
    let by_file = format!(
        "{head}[[combination]]\ncode = \"office.toml\"\nfactors = {{ sand = 1.1, earthquake = 0 }}\n"
    );
    let typed = format!(
        "{head}[[combination]]\nfactors = {{ sand = 1.1, earthquake = 0, weight = [1.35, 1], water = 1.2, \"sand.surcharge\" = 1.5 }}\n\
         resist = {{ sliding = 1.1 }}\n"
    );
    same(&assess(&by_file, office).unwrap(), &assess(&typed, "").unwrap(), "written");
    // Of two soils a name without places means both, and a tie is divided by its name.
    let ties = format!("{RACK}[[combination]]\ncode = \"office.toml\"\nfactors = {{ earthquake = 1 }}\n");
    let typed = format!(
        "{RACK}[[combination]]\nfactors = {{ weight = 1, earthquake = 1 }}\nresist = {{ \"strap to the right wall\" = 1.4 }}\n\
         materials = {{ \"body.friction\" = 1.25 }}\n"
    );
    let office = "factors = { permanent = 1, wave = 1.3 }\nmaterials = { friction = 1.25, \"backfill.friction_angle_deg\" = 1.25 }\n\
        scale = { \"wave.H13\" = 1.2 }\nresist = { \"strap to the right wall\" = 1.4 }\n";
    same(&assess(&ties, office).unwrap(), &assess(&typed, "").unwrap(), "ties");
}

/// Each refusal: the file, its words, and what helps.
#[test]
fn what_a_file_cannot_say_is_refused() {
    let case =
        format!("{}[[combination]]\ncode = \"office.toml\"\n", QUAY.split("[[combination]]").next().unwrap());
    for (office, words, help) in [
        (
            "name = \"DA2\"\n",
            "the file of a code has no `name`",
            "it has factors, scale, materials, resist, criteria",
        ),
        ("set = { \"water.level\" = 2 }\n", "the file of a code has no `set`", "stands in the combination"),
        ("factors = { crane = 1.5 }\n", "`factors` of office.toml names crane", "permanent, variable"),
        ("factors = { sand = -1 }\n", "expected a factor from 0 to 1000000", ""),
        ("factors = { weight = [1, 0] }\n", "weight", ""),
        ("materials = { fricton = 1.25 }\n", "`materials` of office.toml names fricton", "body.friction"),
        ("scale = { \"wave.H14\" = 1.25 }\n", "`scale` of office.toml names wave.H14", ""),
        ("resist = { slidin = 1.1 }\n", "`resist` of office.toml names slidin", "sliding, bearing, passive"),
        ("criteria = { SF_slide = 1.1 }\n", "SF_slide", "SF_sliding"),
        ("\n", "office.toml", ""),
        ("factors = \n", "", ""),
    ] {
        let (said, helped) = assess(&case, office).err().unwrap_or_else(|| panic!("{office}: not refused"));
        assert!(said.contains(words) && helped.contains(help), "{office}: {said} / {helped}");
    }
    let (said, _) = assess(&case.replace("office.toml", "offce.toml"), DA2).unwrap_err();
    assert_eq!(said, "cannot read offce.toml: there is no such file");
    let (said, _) = assess(&case.replace("office.toml", "office"), DA2).unwrap_err();
    assert!(said.contains("or a file of your own, \"office.toml\""), "{said}");
    // Of a text alone.
    let unread = CaseFile::parse("case.toml", &case).and_then(|file| Assessment::of_file(&file)).unwrap_err();
    assert_eq!(unread.to_string(), "cannot read office.toml: it is not read yet");
}

/// The file is told in text, JSON and in the list of files that a sheet hashes.
#[test]
fn the_file_is_told() {
    let case =
        format!("{}[[combination]]\ncode = \"office.toml\"\n", WALL.split("[[combination]]").next().unwrap());
    let file = CaseFile::read("case.toml", &case, &|_| Ok(DA2.to_owned())).unwrap();
    assert_eq!(file.files().collect::<Vec<_>>(), [("office.toml", DA2)]);
    let again = file.reread(&case.replace("5.4056 m\"\nfriction", "5.5 m\"\nfriction")).unwrap();
    assert_eq!(again.files().collect::<Vec<_>>(), [("office.toml", DA2)]);
    let answer = Assessment::of_file(&file).unwrap();
    let text = answer.text(&AssessmentView::default());
    assert!(text.contains("  code: office.toml\n") && !text.contains("recommended"), "{text}");
    assert!(answer.json(&AssessmentView::default(), &[]).contains("\"code\": \"office.toml\""));
}
