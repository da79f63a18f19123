//! Criteria on the probability that a body does not stay at rest, against laws written out by hand.

use standfast_cases::design::{Design, DesignRequest, Extreme, Spelling};
use standfast_cases::motion::FollowedMotion;
use standfast_cases::random::{
    ChanceRequest, Draws, Effort, Estimate, Happening, Method, Overturning, Probability, ProbabilityError,
    ValueRange, WeighedDraws, template,
};
use standfast_cases::{Assessment, CaseFile, Document, Portion};
use standfast_probability::normal::{above, below, quantile_above};

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

fn answer(text: &str, request: ChanceRequest) -> Probability {
    Probability::of(&file(text), request)
        .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

/// A block in air that slides where the force exceeds μ m g, and is too wide to turn.
const BLOCK: &str = "[body]\nwidth = 12\nheight = 3\nmass = 60e3\nfriction = 0.5\n";
const PUSH: &str = "[[load]]\nname = \"push\"\nforce = 200e3\nelevation = 0.5\n";
const LAW: &str = "\"load.push.force\" = { normal = { sd = 20e3 } }\n";

/// P = 1 − Φ((μ m g − F)/s), with the mass that goes with the width: the least width at which that is 1e-3 is the quantile's.
#[test]
fn a_design_for_a_probability_is_that_of_the_law() {
    let text = format!("{BLOCK}{PUSH}[random]\n{LAW}");
    let case = file(&text);
    let request = DesignRequest {
        vary: "width".to_owned(),
        target: "p_not_rest=1e-3".parse().unwrap(),
        extreme: Extreme::Least,
        from: Some("5".to_owned()),
        to: Some("20".to_owned()),
        spelling: &Spelling::PROGRAM,
    };
    let design = Design::of(&case, request, Portion::UNSEEN).unwrap_or_else(|error| panic!("{error}"));
    let json: serde_json::Value = serde_json::from_str(&design.json(&(), &[])).unwrap();
    let found = json["found"]["value"].as_f64().unwrap();
    let resistance_per_metre = 0.5 * 60e3 / 12.0 * 9.81;
    let by_hand = (200e3 + quantile_above(1e-3) * 20e3) / resistance_per_metre;
    assert!((json["found"]["boundary"].as_f64().unwrap() / by_hand - 1.0).abs() < 1e-7, "{found} {by_hand}");
    assert!(
        found >= by_hand && found < by_hand + 1e-2,
        "{found} {by_hand}: to the safe side, in four digits"
    );
    // As it is printed.
    let printed = text.replace("width = 12", &format!("width = {found}"));
    let printed = printed.replace("mass = 60e3", &format!("mass = {}", 60e3 * found / 12.0));
    let at = |text: &str| answer(text, ChanceRequest::default()).situations[0].not_rest.high;
    assert!(at(&printed) <= 1e-3);
    let less = found - 1e-2;
    let less = text
        .replace("width = 12", &format!("width = {less}"))
        .replace("mass = 60e3", &format!("mass = {}", 60e3 * less / 12.0));
    assert!(at(&less) > 1e-3);
    let words: Vec<String> = design.text(&()).split_whitespace().map(str::to_owned).collect();
    assert!(words.join(" ").contains("the upper end of the interval of p_not_rest"), "{}", design.text(&()));
}

/// The upper end of the interval decides, not the estimate.
#[test]
fn a_criterion_counts_the_upper_end_of_the_interval() {
    let p = above((0.5 * 60e3 * 9.81 - 200e3) / 20e3);
    for (bound, met) in [(p * 1.001, true), (p * 0.999, false)] {
        let text = format!("{BLOCK}{PUSH}[criteria]\np_not_rest = {bound:e}\n[random]\n{LAW}");
        let assessment = Assessment::of_file(&file(&text)).unwrap();
        assert_eq!(assessment.met(), Some(met));
        assert_eq!(answer(&text, ChanceRequest::default()).criteria[0].is_met(), met);
    }
    // Drawn, the estimate may be below a bound that the interval is not.
    let request = ChanceRequest { method: Some(Method::MonteCarlo), ..ChanceRequest::default() };
    let text = format!("{BLOCK}{PUSH}[random]\n{LAW}");
    let Estimate { value, high, .. } = answer(&text.replace("20e3", "60e3"), request).situations[0].not_rest;
    let bound = 0.5 * (value + high);
    assert!(value < bound && bound < high);
    let text = text
        .replace("20e3", "60e3")
        .replace("[random]", &format!("[criteria]\np_not_rest = {bound}\n[random]"));
    let criterion = answer(&text, request).criteria[0];
    assert!(!criterion.is_met() && criterion.counted == high, "{criterion:?}");
}

/// The top of the answer says the probability of the law with its period, and the criterion with what is used of it.
#[test]
fn the_top_says_what_the_probability_is_of() {
    let p = above((0.5 * 60e3 * 9.81 - 200e3) / 20e3);
    let text = format!("{BLOCK}{PUSH}[criteria]\np_not_rest = {:e}\n[random]\n{LAW}", 2.0 * p);
    let top = answer(&text, ChanceRequest::default()).summary().unwrap();
    let governing = top.governing.unwrap();
    assert_eq!((top.met, governing.criterion), (Some(true), "p_not_rest"));
    assert!((governing.utilisation.unwrap() - 0.5).abs() < 1e-9, "{governing:?}");
    assert!(top.criteria.unwrap().ends_with("(utilisation 0.5000)."));
    let shown = |words: &str, after: &str| {
        let rest = words.split(after).nth(1).unwrap_or_else(|| panic!("{words}"));
        rest.split(['(', ' ']).next().unwrap().trim_end_matches('.').parse::<f64>().expect("a number")
    };
    let event = shown(&top.answer, "in one event is ");
    assert!((event / p - 1.0).abs() < 5e-4, "{} {p}", top.answer);
    assert!(top.answer.ends_with("It then slides to the left, SL."), "{}", top.answer);

    // Drawn anew each year, over ten of them.
    let yearly = text.replace("sd = 20e3 } }", "sd = 20e3 }, every = \"year\" }") + "years = 10\n";
    let top = answer(&yearly, ChanceRequest::default()).summary().unwrap();
    assert!((shown(&top.answer, "in one year is ") / p - 1.0).abs() < 5e-4, "{}", top.answer);
    let life = 1.0 - (1.0 - p).powi(10);
    assert!((shown(&top.answer, "At least once in 10 years: ") / life - 1.0).abs() < 5e-4, "{}", top.answer);
}

/// Two forces that act one by one, each with a law of its own: that any of them moves the body is 1 − (1 − p₁)(1 − p₂); with one
/// friction for both it is the chance of the worse.
#[test]
fn alternatives_are_joined_under_the_same_draw() {
    let both = format!("{BLOCK}{PUSH}[[load]]\nname = \"other\"\nforce = 220e3\nelevation = 0.5\n");
    let (resistance, s) = (0.5 * 60e3 * 9.81, 40e3);
    let laws = "[random]\n\"load.push.force\" = { normal = { sd = 40e3 } }\n\"load.other.force\" = { normal = { sd = 40e3 } }\n";
    let found = answer(&format!("{both}{laws}"), ChanceRequest::default());
    let rests = |force: f64| (below((resistance - force) / s) - below(-force / s)) / above(-force / s);
    let by_hand = 1.0 - rests(200e3) * rests(220e3);
    let joined = found.joined.unwrap();
    assert_eq!(joined.count, 2);
    assert!((joined.not_rest.value / by_hand - 1.0).abs() < 1e-9, "{joined:?} {by_hand}");
    let worst = found.situations[0].not_rest.value;
    assert!((worst / (1.0 - rests(220e3)) - 1.0).abs() < 1e-9);
    for method in [Method::Sobol, Method::MonteCarlo] {
        let request = ChanceRequest { method: Some(method), ..ChanceRequest::default() };
        let Estimate { low, high, .. } = answer(&format!("{both}{laws}"), request).joined.unwrap().not_rest;
        assert!(low <= by_hand && by_hand <= high, "{method}: {low} {by_hand} {high}");
    }
    let friction = "[random]\nfriction = { normal = { mean = 0.5, sd = 0.05 } }\n";
    let found = answer(&format!("{both}{friction}"), ChanceRequest::default());
    let by_hand = below((220.0 / (60.0 * 9.81) - 0.5) / 0.05);
    assert!((found.joined.unwrap().not_rest.value / by_hand - 1.0).abs() < 1e-9);
    // The criterion is of the worst of those that act one by one.
    let text = format!("{both}[criteria]\np_not_rest = 0.5\n{laws}");
    assert!((answer(&text, ChanceRequest::default()).criteria[0].counted / worst - 1.0).abs() < 1e-9);
}

/// A base shaken to both sides is one event: with a push to the left, resting takes rest under both signs.
#[test]
fn both_signs_of_an_earthquake_are_one_event() {
    let push = PUSH.replace("200e3", "50e3") + "permanent = true\n";
    let text = format!(
        "{BLOCK}{push}[earthquake]\nhorizontal = \"0.25 g\"\n[criteria]\np_not_rest = 0.5\n[random]\n\
         friction = {{ normal = {{ mean = 0.5, sd = 0.1 }} }}\n\"load.push.force\" = {{ normal = {{ sd = 10e3 }} }}\n"
    );
    let found = answer(&text, ChanceRequest::default());
    assert_eq!((found.situations.len(), found.joined.map(|joined| joined.count)), (2, Some(2)));
    // |F ± 0.25 m g| is the larger where both push to the left; only the other sign of F, beyond 5 s, would be otherwise.
    let joined = found.joined.unwrap().not_rest.value;
    let weight = 60e3 * 9.81;
    let (mean, sd) = ((50e3 + 0.25 * weight) / weight, 10e3 / weight);
    let by_hand = below((mean - 0.5) / f64::hypot(sd, 0.1));
    assert!((joined / by_hand - 1.0).abs() < 1e-5, "{joined} {by_hand}");
    assert_eq!(found.criteria[0].counted, found.joined.unwrap().not_rest.high);
}

#[test]
fn what_is_not_random_has_no_probability() {
    let text = format!("{BLOCK}{PUSH}[criteria]\np_not_rest = 0.001\n");
    let error = file(&text).case().unwrap_err().to_string();
    assert!(error.contains("p_not_rest") && error.contains("no [random] table"), "{error}");
    let wrong = CaseFile::parse("case.toml", &format!("{BLOCK}{PUSH}[criteria]\np_not_rest = 1.5\n"));
    let error = wrong.unwrap_err().to_string();
    assert!(error.contains("1.5") && error.contains("above zero and 1 at most"), "{error}");
}

/// A range along a number that falls is refused with its values, and one without inside.
#[test]
fn a_range_that_falls_is_refused() {
    let text = format!("{BLOCK}{PUSH}[random]\n{LAW}");
    for range in ["width=20 m..10 m:3", "width=10 m..10 m:3"] {
        let over = range.parse().unwrap();
        let error = Probability::along(&file(&text), ChanceRequest::default(), Some(&over)).unwrap_err();
        let (from, to) = range["width=".len()..].trim_end_matches(":3").split_once("..").unwrap();
        assert!(error.to_string().contains(&format!("from {from} to {to}")), "{error}");
    }
}

/// Chances of events that never happened have a bound, not 0.
#[test]
fn a_chance_if_known_that_was_never_met_is_a_bound() {
    let text = format!(
        "{BLOCK}{PUSH}[random]\n{LAW}friction = {{ normal = {{ sd = 0.001 }} }}\nmass = {{ normal = {{ cov = 0.0001 }} }}\n\
         bias.force = {{ lognormal = {{ cov = 0.0001 }} }}\n"
    );
    let found = answer(&text.replace("sd = 20e3", "sd = 30e3"), ChanceRequest::default());
    let printed = found.text(&());
    assert!(found.situations[0].known.iter().all(|known| known.high > 0.0), "{printed}");
    let known = printed.lines().find(|line| line.starts_with("  load.push.force")).unwrap();
    assert!(known.contains("below "), "{printed}");
}

/// Templates, appended to the case, are read and answered; every law has its source, and no source is said to be read.
#[test]
fn a_template_answers_with_every_example() {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut count = 0;
    for entry in std::fs::read_dir(examples).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let Ok(case) = CaseFile::parse(&name, &text) else { continue };
        let template = template(&case).unwrap();
        let laws: Vec<&str> =
            template.lines().filter(|line| !line.starts_with(['#', '[']) && !line.is_empty()).collect();
        assert!(!laws.is_empty(), "{name}");
        let lines: Vec<&str> = template.lines().collect();
        for pair in lines.windows(2).filter(|pair| laws.contains(&pair[1])) {
            let honest = pair[0].contains("not read in the original") || pair[0].contains("assumption");
            assert!(pair[0].starts_with("# ") && honest, "{name}: {pair:?}");
        }
        // Partial factors are not for probabilities.
        let by_code = case.case().unwrap().combinations.iter().any(|combination| combination.code.is_some());
        if case.random().is_some() || case.case().unwrap().ground.is_some() || by_code {
            continue;
        }
        let text = format!("{text}\n{template}");
        let draws = |situation: Option<&str>| Draws::of(&file(&text), situation, 40, 1);
        let found = match draws(None) {
            Err(ProbabilityError::Situation { known, .. }) => draws(Some(&known[0])),
            found => found,
        };
        let found = found.unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)));
        assert_eq!(found.inputs.len(), laws.len(), "{name}");
        let bodies = found.drawn.iter().filter(|drawn| drawn.happens != Happening::NotABody);
        assert!(bodies.count() > 30, "{name}");
        if name == "caisson-in-air.toml" {
            let all: f64 = answer(&text, ChanceRequest::default()).situations[0]
                .modes
                .iter()
                .map(|(_, e)| e.value)
                .sum();
            assert!((all - 1.0).abs() < 1e-12, "{name}");
        }
        count += 1;
    }
    assert!(count >= 8, "{count}");
}

/// How heavy a shaken body is says nothing of what shakes it, so that it has no law; records have their place where one direction is shaken.
#[test]
fn a_template_fits_what_is_shaken() {
    let body = "[body]\nwidth = \"0.6 m\"\nheight = \"2 m\"\ndensity = \"2.6 t/m3\"\nfriction = 0.5\n";
    let of = |more: &str| template(&file(&format!("{body}{more}"))).unwrap();
    let laws = |template: &str| -> Vec<String> {
        let lines = template.lines().filter(|line| !line.starts_with(['#', '[']));
        lines.filter_map(|line| Some(line.split_once(" =")?.0.to_owned())).collect()
    };
    let pulse = "{ shape = \"half-sine\", peak = \"4 m/s2\", duration = \"0.5 s\" }";
    let shaken = of(&format!("[motion.base]\nhorizontal = {pulse}\n"));
    let both = of(&format!("[motion.base]\nhorizontal = {pulse}\nvertical = {pulse}\n"));
    let held = of("[earthquake]\nhorizontal = \"0.2 g\"\n");
    let pushed = of("[[load]]\nforce = \"2 kN/m\"\nelevation = \"1 m\"\n");
    for (template, records) in [(&shaken, true), (&both, false), (&held, false), (&pushed, false)] {
        assert_eq!(template.contains("# records = ["), records, "{template}");
        assert!(!template.contains("rubble"), "{template}");
    }
    assert_eq!(laws(&shaken), ["friction"]);
    assert_eq!(laws(&held), ["friction"]);
    assert_eq!(laws(&pushed), ["friction", "mass", "bias.force"]);
    let placed = of("centroid_height = \"0.9 m\"\n[earthquake]\nhorizontal = \"0.2 g\"\n");
    assert_eq!(laws(&placed), ["friction", "body.centroid_height"]);
}

/// The weights of the draws, summed by mode, are the printed probabilities of plain Monte Carlo.
#[test]
fn weighed_draws_add_up_to_the_answer() {
    let text = format!(
        "{BLOCK}{PUSH}[[load]]\nname = \"other\"\nforce = 270e3\nelevation = 0.5\n[random]\nfriction = {{ normal = {{ sd = 0.05 }} }}\nbias.force = {{ normal = {{ cov = 0.1 }} }}\n"
    );
    let request = ChanceRequest { method: Some(Method::MonteCarlo), ..ChanceRequest::default() };
    let found = answer(&text, request);
    let draws = WeighedDraws::of(&file(&text), &found).unwrap();
    assert_eq!(draws.situations.len(), 2);
    for (place, chances) in found.situations.iter().enumerate() {
        for (happening, estimate) in &chances.modes {
            let rows = (0..draws.weights.len())
                .filter(|row| draws.of[*row] == place && draws.happens[*row] == *happening);
            let sum: f64 = rows.map(|row| draws.weights[row]).sum();
            assert!((sum - estimate.value).abs() < 1e-9, "{happening:?}: {sum} {estimate:?}");
        }
        // And each row is what the report makes of its numbers: it slides where F > μ m g.
        let force = if chances.situation.as_deref() == Some("push") { 200e3 } else { 270e3 };
        for row in (0..draws.weights.len()).filter(|row| draws.of[*row] == place).take(1000) {
            let [friction, bias] = [draws.values[0][row], draws.values[1][row]];
            let slides = force * bias > friction * 60e3 * 9.81;
            assert_eq!(draws.happens[row].name() == "SL", slides);
        }
    }
    // Of an answer that integrates friction they are the same ones, drawn by the laws: shares of them are its probabilities, within what
    // so many tell.
    let found = answer(&text, ChanceRequest::default());
    let integrated = WeighedDraws::of(&file(&text), &found).unwrap();
    let count = 1 << 16;
    assert_eq!(integrated.weights.len(), 2 * count);
    assert_eq!(integrated.values[0][..100], draws.values[0][..100]);
    for (place, chances) in found.situations.iter().enumerate() {
        assert_eq!(chances.method, Method::Integrate);
        let of_situation = || (0..integrated.weights.len()).filter(|row| integrated.of[*row] == place);
        let all: f64 = of_situation().map(|row| integrated.weights[row]).sum();
        assert!((all - 1.0).abs() < 1e-9);
        for (happening, Estimate { value: p, .. }) in &chances.modes {
            let hits = of_situation().filter(|row| integrated.happens[*row] == *happening).count();
            let spread = (p * (1.0 - p) / count as f64).sqrt();
            assert!(
                (hits as f64 / count as f64 - p).abs() <= 4.0 * spread + 1e-12,
                "{happening:?} {hits} {p}"
            );
        }
    }
    let few = Effort { points: 1000, ..Effort::default() };
    let found = answer(&text, ChanceRequest { effort: few, ..ChanceRequest::default() });
    assert_eq!(WeighedDraws::of(&file(&text), &found).unwrap().weights.len(), 2000);
}

const GODA: &str = include_str!("../../../examples/goda-2000.toml");

fn storm(random: &str, waves: u32) -> String {
    let text = format!("{GODA}\n[random]\n{random}");
    text.replace("[wave]", &format!("[storm]\nwaves = {waves}\ntau0 = 1.5\ncut = false\n\n[wave]"))
}

/// Storms whose waves turn no body: nothing is followed, and the numbers are those without.
#[test]
fn following_rotations_changes_nothing_where_there_are_none() {
    let text = storm("friction = { uniform = { from = 0.35, to = 0.4 } }", 50).replace("cut = false\n", "");
    let effort = Effort { points: 1 << 12, ..Effort::default() };
    let count = answer(&text, ChanceRequest { effort, ..ChanceRequest::default() }).sliding.unwrap();
    let follow =
        answer(&text, ChanceRequest { effort, follow: true, ..ChanceRequest::default() }).sliding.unwrap();
    assert!(count.mean.value > 0.0 && count.rotating.wave.value == 0.0);
    assert_eq!(follow.followed.unwrap().slide.value, 0.0);
    assert_eq!(
        (count.mean, count.quantiles, count.exceedance),
        (follow.mean, follow.quantiles, follow.exceedance)
    );
}

/// Storms of 1000 waves, on so much friction that they turn the body: their slides, averaged over heights, are those
/// that `simulate` gives of the same case with the wave's height written into it.
#[test]
fn rotations_are_those_of_the_motion_in_time() {
    let random = "friction = { uniform = { from = 1.25, to = 1.2500001 } }\n";
    let text = storm(random, 1000).replace("2318.64 kN/m", "1300 kN/m").replace("tau0 = 1.5", "tau0 = 2.5");
    let effort = Effort { points: 1 << 13, ..Effort::default() };
    let found =
        answer(&text, ChanceRequest { effort, follow: true, ..ChanceRequest::default() }).sliding.unwrap();
    let followed = found.followed.unwrap();
    assert!(found.rotating.wave.value > 0.0, "{found:?}");
    // By hand: wave by wave of the Rayleigh law.
    let case = CaseFile::parse("case.toml", &text).unwrap().case().unwrap();
    let waves = case.goda().unwrap();
    let significant = waves.goda.h_13;
    let steps = 4000;
    let (mut slide, mut over, mut turning) = (0.0, 0.0, 0.0);
    for i in 0..steps {
        // Equal shares of all waves beyond the significant height, below which none turns it.
        let level = 1.416f64.powi(2) - ((f64::from(i) + 0.5) / f64::from(steps)).ln();
        let h = level.sqrt() * significant / 1.416;
        let chance = (-(1.416f64.powi(2))).exp() / f64::from(steps);
        let body = text[..text.find("[storm]").unwrap()].replace("friction = 0.6", "friction = 1.25");
        let sea = text[text.find("[wave]").unwrap()..text.find("[random]").unwrap()]
            .replace("deep_water_height = \"6.3 m\"", &format!("H13 = {significant}\nHmax = {h}"));
        let still = format!("{body}{sea}");
        let mode = Assessment::of(&file(&still).case().unwrap()).unwrap().all[0].mode().unwrap();
        if mode.corner().is_none() {
            continue;
        }
        turning += chance;
        let history = "history = { shape = \"triangle\", rise = 1.25, duration = 2.5 }\n";
        let timed = still.replace("[wave]\n", &format!("[wave]\n{history}"));
        let cases =
            file(&timed).motions().unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)));
        let outcome = FollowedMotion::of(cases[0].clone(), &Default::default()).unwrap().outcome;
        slide += chance * outcome.slide.abs();
        over += chance * f64::from(u8::from(outcome.overturned()));
    }
    assert!((turning / found.rotating.wave.value - 1.0).abs() < 2e-3, "{turning} {:?}", found.rotating);
    assert!(slide > 0.0, "{slide} {over}");
    // None overturns it, so that each of the 1000 adds its own.
    assert_eq!((over, followed.overturned.value), (0.0, 0.0));
    let (by_hand, e) = (1000.0 * slide, followed.slide);
    assert!(e.low <= by_hand && by_hand <= e.high, "{by_hand} {e:?}");
    assert!(e.high - e.low < 0.08 * by_hand, "{e:?}");
}

/// Each pair of body and record by hand, at each peak: the draw's friction and width written into the case, the record scaled, followed by
/// `simulate`; alone, and with water that moves along and a permanent force, which is drawn too.
#[test]
fn overturning_is_that_of_the_motions_one_by_one() {
    let body = |width: f64, friction: f64| {
        format!("[body]\nwidth = {width}\nheight = 2\ndensity = 2600\nfriction = {friction}\n")
    };
    let shaken = |file: &str, peak: f64| {
        format!(
            "[motion]\nt_max = 20\n[motion.base]\nhorizontal = {{ shape = \"file\", file = \"{file}\", target_peak = \"{peak} m/s2\" }}\n"
        )
    };
    let record = |period: f64| {
        let value = |i: i32| {
            let t = f64::from(i) * 0.05;
            if t < 2.0 { (std::f64::consts::TAU * t / period).sin() } else { 0.0 }
        };
        let rows: Vec<String> = (0..=60).map(|i| format!("{},{}", f64::from(i) * 0.05, value(i))).collect();
        format!("time_s,a_g\n{}\n", rows.join("\n"))
    };
    let names = ["one.csv", "two.csv", "three.csv"];
    let files = |name: &str| match name {
        "one.csv" => Ok(record(1.0)),
        "two.csv" => Ok(record(0.6)),
        "three.csv" => Ok(record(0.9)),
        _ => Err("no such file".to_owned()),
    };
    let widths =
        "width = { uniform = { from = \"0.4 m\", to = \"0.8 m\" } }\nfriction = { normal = { sd = 0.05 } }\n";
    let listed = format!("[random]\nrecords = {names:?}\n{widths}");
    let force = |size: f64| {
        format!(
            "[water]\nlevel = 1\ndensity = 1000\n[added_mass]\nsides = 2\n[[load]]\nname = \"prop\"\nforce = {size}\nelevation = 0.5\npermanent = true\n"
        )
    };
    let biased = format!("{listed}bias.force = {{ uniform = {{ from = 0.5, to = 2 }} }}\n");
    let moving = format!(
        "{listed}motion.impact.ratio = {{ uniform = {{ from = 0.4, to = 0.95 }} }}\nmotion.initial.theta = {{ normal = {{ sd = 0.02 }} }}\n"
    );
    let of_motion = |ratio: f64, theta: f64| {
        format!("[motion.impact]\nlaw = \"ratio\"\nratio = {ratio}\n[motion.initial]\ntheta = {theta}\n")
    };
    const BODIES: usize = 20;
    let peaks = [2.0, 6.0, 10.0];
    let mut shares = Vec::new();
    for (random, extra, moves) in
        [(&listed, None, false), (&biased, Some(900.0), false), (&moving, None, true)]
    {
        let of_force = |size: f64| extra.map_or(String::new(), |force_of: f64| force(force_of * size));
        let of_motion = |ratio: f64, theta: f64| if moves { of_motion(ratio, theta) } else { String::new() };
        let more = of_force(1.0) + &of_motion(0.7, 0.02);
        let text = format!("{}{}{more}{random}", body(0.6, 0.6), shaken("one.csv", 3.0));
        let in_time = CaseFile::read("case.toml", &text, &files).unwrap();
        // A motion counts as 1024 points.
        let points = (BODIES * names.len() * peaks.len() * 1024) as u64;
        let effort = Effort { points, ..Effort::default() };
        let request = ChanceRequest { effort, ..ChanceRequest::default() };
        let over: ValueRange = "pga=2 m/s2..10 m/s2:3".parse().unwrap();
        let found = Overturning::of(&in_time, &request, &over).unwrap();
        assert_eq!((found.bodies, found.records.len(), found.points.len()), (BODIES as u64, 3, 3));
        let alone = ChanceRequest { effort: Effort { threads: 1, ..effort }, ..request };
        assert_eq!(Overturning::of(&in_time, &alone, &over).unwrap(), found);
        // A motion that is left before its record ends tells nothing of what becomes of the body.
        let cut = CaseFile::read("case.toml", &text.replace("t_max = 20", "t_max = 1.5"), &files).unwrap();
        let refused = Overturning::of(&cut, &request, &over).unwrap_err().to_string();
        assert!(refused.contains("`t_max` is 1.5 s, and one.csv goes on to 3 s"), "{refused}");
        let draws = Draws::of(&in_time, Some(&situation(&in_time)), BODIES as u64, 1).unwrap();
        for (point, peak) in found.points.iter().zip(peaks) {
            let mut became = [vec![], vec![], vec![]];
            for file in names {
                let of_record: Vec<[bool; 3]> = (0..BODIES)
                    .map(|i| {
                        let drawn = |place: usize| draws.values.get(place).map_or(1.0, |values| values[i]);
                        let case = body(drawn(0), drawn(1)) + &shaken(file, peak);
                        let case = case + &of_force(drawn(2)) + &of_motion(drawn(2), drawn(3));
                        let cases = CaseFile::read("case.toml", &case, &files).unwrap().motions().unwrap();
                        let outcome =
                            FollowedMotion::of(cases[0].clone(), &Default::default()).unwrap().outcome;
                        let turned = outcome.max_theta > 0.0;
                        [turned || outcome.max_slide > 0.0, turned, outcome.overturned()]
                    })
                    .collect();
                for (which, rows) in became.iter_mut().enumerate() {
                    rows.push(of_record.iter().map(|became| became[which]).collect::<Vec<bool>>());
                }
            }
            assert!((point.peak - peak).abs() < 1e-12);
            let found = [point.moved, point.rocked, point.overturned];
            assert_eq!(found, became.map(|rows| Estimate::of_pairs(&rows)), "{peak}");
        }
        shares.push(found.points[2].overturned);
        assert!(found.points[0].overturned.value < found.points[2].overturned.value, "{found:?}");
        // Three records tell little of a fourth.
        let plain = Estimate::of_hits((found.points[2].overturned.value * 60.0).round() as u64, 60);
        let e = found.points[2].overturned;
        assert!(e.low < plain.low && plain.high < e.high, "{e:?} {plain:?}");
    }
    assert!(shares[0] != shares[1] && shares[0] != shares[2], "{shares:?}");
    // Where no motion is followed its numbers are refused by name, and of the base they are scaled, not drawn.
    let text = |law: &str| {
        format!(
            "{}{}[motion.impact]\nlaw = \"ratio\"\nratio = 0.7\n[random]\n{law}\n",
            body(0.6, 0.6),
            shaken("one.csv", 3.0)
        )
    };
    let of_ratio =
        CaseFile::read("case.toml", &text("motion.impact.ratio = { normal = { sd = 0.1 } }"), &files)
            .unwrap();
    let of_peak = "motion.base.horizontal.target_peak = { normal = { sd = \"0.1 m/s2\" } }";
    let of_peak = CaseFile::read("case.toml", &text(of_peak), &files).unwrap();
    let over: ValueRange = "pga=2 m/s2..10 m/s2:3".parse().unwrap();
    for (file, over, name) in [
        (&of_ratio, None, "motion.impact.ratio"),
        (&of_peak, Some(&over), "motion.base.horizontal.target_peak"),
    ] {
        let error = Probability::along(file, ChanceRequest::default(), over).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("`{name}` is not a number of the case that can be random")),
            "{error}"
        );
        assert!(error.contains("[motion.impact] and [motion.initial]"), "{error}");
    }
    let text = format!("{}{}{listed}", body(0.6, 0.6), shaken("one.csv", 3.0));
    let over = "pga=2 m/s2..10 m/s2:3".parse().unwrap();
    for (load, said) in [
        (
            "[[load]]\nname = \"prop\"\nforce = 1e3\nelevation = 1\nhistory = { shape = \"triangle\", rise = 1, duration = 2 }\n",
            "varies",
        ),
        ("", "`friction`"),
    ] {
        let over: &ValueRange = if load.is_empty() { &"friction=0.5..0.6:3".parse().unwrap() } else { &over };
        let error = Probability::along(
            &CaseFile::read("case.toml", &format!("{text}{load}"), &files).unwrap(),
            ChanceRequest::default(),
            Some(over),
        );
        let error = error.unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
}

/// A record with its vertical partner: the chances are those of a case whose own base moves so. One factor scales both, whatever units
/// they are in; where only one says its own, nothing says how they compare.
#[test]
fn a_record_may_have_a_vertical_partner() {
    let wave = |head: &str, times: f64, period: f64| {
        let value =
            |t: f64| times * (std::f64::consts::TAU * t / period).sin() * f64::from(u8::from(t < 2.0));
        let rows: Vec<String> =
            (0..=60).map(|i| f64::from(i) * 0.05).map(|t| format!("{t},{}", value(t))).collect();
        format!("time_s,{head}\n{}\n", rows.join("\n"))
    };
    let files = |name: &str| match name {
        "side.csv" => Ok(wave("a_g", 1.0, 0.9)),
        "up.csv" => Ok(wave("a_g", 0.8, 0.3)),
        "up-si.csv" => Ok(wave("a_m_s2", 0.8 * 9.81, 0.3)),
        "up-bare.csv" => Ok(wave("a", 0.8, 0.3)),
        "push.csv" => Ok(wave("push_kN", 0.8, 0.3)),
        _ => Err("no such file".to_owned()),
    };
    let of = |vertical: &str, records: &str| {
        let text = format!(
            "[body]\nwidth = 0.6\nheight = 2\ndensity = 2600\nfriction = 0.6\n[motion]\nt_max = 20\n[motion.base]\n\
             horizontal = {{ shape = \"file\", file = \"side.csv\" }}\n{vertical}[random]\n{records}friction = {{ normal = {{ sd = 0.05 }} }}\n\
             width = {{ normal = {{ sd = 0.05 }} }}\n"
        );
        let file = CaseFile::read("case.toml", &text, &files).unwrap();
        let effort = Effort { points: 60 * 1024, ..Effort::default() };
        let over: ValueRange = "pga=0.3 g..0.9 g:3".parse().unwrap();
        Overturning::of(&file, &ChanceRequest { effort, ..ChanceRequest::default() }, &over)
    };
    let own = of("vertical = { shape = \"file\", file = \"up.csv\" }\n", "").unwrap();
    let paired = |vertical: &str| {
        of("", &format!("records = [{{ horizontal = \"side.csv\", vertical = \"{vertical}\" }}]\n"))
    };
    let chances =
        |found: &Overturning| found.points.iter().map(|at| at.overturned.value).collect::<Vec<f64>>();
    assert_eq!(chances(&paired("up.csv").unwrap()), chances(&own));
    assert_eq!(chances(&paired("up-si.csv").unwrap()), chances(&own));
    let alone = of("", "records = [\"side.csv\"]\n").unwrap();
    assert_ne!(chances(&alone), chances(&own));
    let refused = paired("up-bare.csv").unwrap_err().to_string();
    assert!(refused.contains("side.csv says its unit, and up-bare.csv does not"), "{refused}");
    let refused = paired("push.csv").unwrap_err().to_string();
    assert!(refused.contains("push.csv is no record of an acceleration"), "{refused}");
}

/// Random numbers are called by their words in pictures, and not by their keys; β stands in a sentence.
#[test]
fn figures_call_numbers_by_their_words() {
    let text = include_str!("../../../examples/goda-2000-random.toml");
    let effort = Effort { points: 1 << 14, ..Effort::default() };
    let request = ChanceRequest { effort, ..ChanceRequest::default() };
    let answer = Probability::of(&file(text), request).unwrap();
    let figures = answer.figures(&()).unwrap();
    let figure = |suffix: &str| &figures.iter().find(|figure| figure.suffix == suffix).unwrap().figure;
    let labels: Vec<&str> = figure("-matters").labels().iter().map(|label| label.text.as_str()).collect();
    for words in ["factor on the thrust of the wave", "Coulomb friction between body and base"] {
        assert!(labels.contains(&words), "{words}: {labels:?}");
    }
    assert!(
        labels
            .iter()
            .all(|label| !label.contains('.') || label.parse::<f64>().is_ok() || label.contains(' '))
    );
    let caption = figure("-modes").caption();
    assert!(caption.contains("The reliability index β is ") && !caption.contains('Φ'), "{caption}");
    let straight =
        caption.find("For comparison: first-order reliability, which takes the limit of rest as straight");
    assert!(straight.is_some() && caption.contains("Not drawn, each rarer than "), "{caption}");
    // An axis has words and the unit that people read, kN for N.
    let text = "[body]\nwidth = 8\nheight = 14\nmass = 200e3\nfriction = 0.6\n[[load]]\nname = \"push\"\nforce = 700e3\nelevation = 9\n\
        [random]\nfriction = { normal = { sd = 0.08 }, lower = 0 }\n";
    let over = "load.push.force=600 kN/m..900 kN/m:4".parse::<ValueRange>().unwrap();
    let answer = Probability::along(&file(text), ChanceRequest::default(), Some(&over)).unwrap();
    let figures = answer.figures(&()).unwrap();
    let figure = &figures.iter().find(|figure| figure.suffix == "-fragility").unwrap().figure;
    let labels: Vec<&str> = figure.labels().iter().map(|label| label.text.as_str()).collect();
    for words in ["Force, load 1 (kN/m)", "600", "900"] {
        assert!(labels.contains(&words), "{words}: {labels:?}");
    }
}

/// Every figure there is of answers of many kinds: no label lies on another or leaves the page; draws have the modes behind them.
#[test]
fn figures_of_answers_are_tidy() {
    let tall = "[body]\nwidth = 8\nheight = 14\nmass = 200e3\nfriction = 0.6\n[[load]]\nname = \"push\"\nforce = 700e3\nelevation = 9\n\
        direction = \"right\"\n[random]\nfriction = { normal = { sd = 0.08 }, lower = 0 }\nwidth = { normal = { sd = 0.4 } }\n\
        \"load.push.force\" = { gumbel = { cov = 0.15 }, every = \"year\" }\n\"load.push.elevation\" = { uniform = { from = 6, to = 11 } }\n";
    let plinth = include_str!("../../cli/tests/cmd/probability.in/plinth.toml");
    let statue = include_str!("../../../examples/statue-random.toml");
    let sea = include_str!("../../../examples/goda-2000-storm.toml");
    let plane = "[point]\ngamma = 0.8\nk_prime = 0.9\n[random]\nk = { uniform = { from = 0.3, to = 1.2 } }\nmu = { normal = { mean = 0.6, sd = 0.1 } }\n\
        gamma = { normal = { mean = 0.8, sd = 0.1 } }\n";
    let cases: [(&str, Option<&str>, &[&str]); 5] = [
        (tall, None, &["-draws", "-modes", "-matters", "-convergence"]),
        (plinth, Some("pga=0.3 g..0.9 g:3"), &["-draws", "-modes", "-overturns"]),
        (
            statue,
            Some("earthquake.horizontal=1.5 m/s2..2.75 m/s2:6"),
            &["-draws", "-modes", "-matters", "-fragility"],
        ),
        (sea, None, &["-draws", "-modes", "-matters", "-sliding"]),
        (plane, Some("k_prime=0.1..0.9:3"), &["-draws", "-modes", "-matters", "-fragility"]),
    ];
    for (text, over, expected) in cases {
        let over: Option<ValueRange> = over.map(|over| over.parse().unwrap());
        let effort = Effort { points: 1 << 17, ..Effort::default() };
        let method = (text == plane).then_some(Method::Sobol);
        let years = text.contains("every").then_some(50.0);
        let request = ChanceRequest { effort, years, method, ..ChanceRequest::default() };
        let file = file(text);
        let found = Probability::along(&file, request, over.as_ref())
            .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)));
        let figures = found.figures(&()).unwrap();
        let suffixes: Vec<&str> = figures.iter().map(|figure| &*figure.suffix).collect();
        assert_eq!(suffixes, expected);
        for figure in &figures {
            if figure.suffix == "-overturns" {
                // One shaking: points, without a line through them or a band, and the reason.
                let (_, band, _) = standfast_figures::colours().find(|colour| colour.0 == "band").unwrap();
                let caption = figure.figure.caption();
                assert!(caption.ends_with("It tells nothing of another one."), "{caption}");
                assert!(!figure.figure.svg().contains(&format!("fill=\"{band}\"")), "{caption}");
                assert!(!figure.figure.labels().iter().any(|label| label.text.contains("lognormal")));
            }
            let (width, height) = figure.figure.size();
            let labels = figure.figure.labels();
            for (i, label) in labels.iter().enumerate() {
                let of = (&*figure.suffix, figure.figure.title());
                let rect = label.rect;
                let within =
                    rect.x0 >= 1.0 && rect.y0 >= 1.0 && rect.x1 <= width - 1.0 && rect.y1 <= height - 1.0;
                assert!(within, "{label:?} leaves the page of {of:?}");
                let over = labels[i + 1..].iter().find(|other| rect.overlaps(&other.rect));
                assert!(over.is_none(), "{label:?} touches {over:?} in {of:?}");
            }
        }
    }
}

/// The first of a case's sets of loads, as it is called.
fn situation(file: &CaseFile) -> String {
    match Draws::of(file, None, 1, 1) {
        Err(ProbabilityError::Situation { known, .. }) => known[0].clone(),
        other => panic!("{other:?}"),
    }
}

/// Of fifty years with a force that is drawn each year P = 1 − (1 − p)⁵⁰, and β = −Φ⁻¹(P); a design for them is that for the p of a year.
/// Of a base that is shaken to both sides a year moves the body if either does, which of a like body is the same year.
#[test]
fn a_life_is_a_criterion() {
    let law =
        "years = 50\n\"load.push.force\" = { normal = { mean = 200e3, sd = 20e3 }, every = \"year\" }\n";
    let p = above((0.5 * 60e3 * 9.81 - 200e3) / 20e3);
    let of_life = |p: f64| -(50.0 * (-p).ln_1p()).exp_m1();
    let text = |criteria: &str| format!("{BLOCK}{PUSH}[criteria]\n{criteria}\n[random]\n{law}");
    let found = answer(&text("p_life = 1e-3\nbeta_life = 3"), ChanceRequest::default());
    let of = |name: &str| found.criteria.iter().find(|check| check.criterion.name() == name).unwrap();
    assert!((of("p_life").counted / of_life(p) - 1.0).abs() < 1e-9, "{:?} {}", of("p_life"), of_life(p));
    assert!((of("beta_life").counted / quantile_above(of_life(p)) - 1.0).abs() < 1e-9);
    assert_eq!(
        (of("p_life").is_met(), of("beta_life").is_met()),
        (of_life(p) <= 1e-3, of_life(p) <= above(3.0))
    );
    let words = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("over 50 years is"), "{words}");
    let assessed = Assessment::of_file(&file(&text("beta_life = 2"))).unwrap();
    assert!(assessed.all_checks()[0].is_met());

    for target in ["p_life=0.01", "beta_life=2.3263478740408408"] {
        let request = DesignRequest {
            vary: "width".to_owned(),
            target: target.parse().unwrap(),
            extreme: Extreme::Least,
            from: Some("5".to_owned()),
            to: Some("20".to_owned()),
            spelling: &Spelling::PROGRAM,
        };
        let design = Design::of(&file(&text("p_life = 0.5")), request, Portion::UNSEEN);
        let design = design.unwrap_or_else(|error| panic!("{error}"));
        let json: serde_json::Value = serde_json::from_str(&design.json(&(), &[])).unwrap();
        let yearly = -((-0.01f64).ln_1p() / 50.0).exp_m1();
        let by_hand = (200e3 + quantile_above(yearly) * 20e3) / (0.5 * 60e3 / 12.0 * 9.81);
        let boundary = json["found"]["boundary"].as_f64().unwrap();
        assert!((boundary / by_hand - 1.0).abs() < 1e-6, "{target}: {boundary} {by_hand}");
    }

    let shaken = "[body]\nwidth = 12\nheight = 3\nmass = 60e3\nfriction = 0.5\n[earthquake]\nhorizontal = \"0.2 g\"\n[criteria]\n\
                  p_life = 0.1\n[random]\nyears = 50\nearthquake.horizontal = { normal = { mean = \"0.2 g\", sd = \"0.1 g\" }, every = \"year\", lower = \"0 g\" }\n";
    let found = answer(shaken, ChanceRequest::default());
    let yearly = above(3.0) / above(-2.0);
    assert_eq!(found.situations.len(), 2);
    assert!((found.criteria[0].counted / of_life(yearly) - 1.0).abs() < 1e-6, "{:?}", found.criteria);
}

/// The slides of storms as criteria: the mean and chances that the answer has, at the slides that are asked for; refused where there is no
/// storm, no life, or no table that has them.
#[test]
fn slides_in_storms_are_criteria() {
    let storm = include_str!("../../../examples/goda-2000-storm.toml");
    let asked = "\n[criteria]\nsliding_mean = \"0.10 m\"\np_sliding_over = [{ slide = \"20 cm\", at_most = 0.02 }, { slide = 0.3, at_most = 0.01 }]\n";
    let request =
        ChanceRequest { effort: Effort { points: 1 << 20, ..Effort::default() }, ..ChanceRequest::default() };
    let found = answer(&format!("{storm}{asked}"), request);
    let sliding = found.sliding.as_ref().unwrap();
    let slides: Vec<f64> = sliding.exceedance.iter().map(|exceeded| exceeded.slide).collect();
    assert_eq!(slides, [0.1, 0.2, 0.3]);
    let chances: Vec<f64> = sliding.exceedance.iter().map(|exceeded| exceeded.probability.value).collect();
    assert!(chances[0] > chances[1] && chances[1] > chances[2]);
    let names: Vec<String> = found.criteria.iter().map(|check| check.criterion.full_name()).collect();
    assert_eq!(names.len(), 3);
    for check in &found.criteria {
        let estimate = match check.criterion.over {
            None => sliding.mean,
            Some(slide) => {
                sliding.exceedance[slides.iter().position(|one| *one == slide).unwrap()].probability
            }
        };
        assert_eq!(check.counted, estimate.high);
        assert_eq!(check.is_met(), estimate.high <= check.required(), "{check:?}");
        assert!(found.criteria[0].utilisation() >= check.utilisation());
    }
    let report = |text: &str| match Assessment::of_file(&file(text)) {
        Ok(_) => panic!("{text}"),
        Err(error) => standfast_cases::report(&error),
    };
    let push = format!("{BLOCK}{PUSH}[criteria]\n");
    let random = format!("[random]\n{LAW}");
    for (criterion, said) in [
        ("p_life = 0.1", "nothing says how many years it has"),
        ("sliding_mean = 0.1", "the case has no [storm]"),
        ("p_sliding_over = { slide = 0.1, at_most = 0.2 }", "the case has no [storm]"),
    ] {
        let text = format!("{push}{criterion}\n{random}");
        let error = report(&text);
        assert!(error.contains(said) && error.contains(criterion), "{error}");
        assert!(report(&format!("{push}{criterion}\n")).contains("no [random] table"));
    }
    for wrong in [
        "{ slide = 0.1 }",
        "0.1",
        "[]",
        "{ slide = 0, at_most = 0.1 }",
        "{ slide = \"0.1 m\", at_most = 1.5 }",
        "{ slide = 1, most = 0.1 }",
    ] {
        assert!(
            CaseFile::parse("case.toml", &format!("{push}p_sliding_over = {wrong}\n{random}")).is_err(),
            "{wrong}"
        );
    }
}
