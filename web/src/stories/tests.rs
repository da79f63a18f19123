//! Every number in a story is that of its step's case, or of one that the step asks for.

use std::sync::OnceLock;

use serde_json::Value;
use standfast_cases::random::{ChanceRequest, Probability};

use crate::examples;
use crate::page::Page;

/// Where a number in the words comes from.
enum From {
    /// The program's answer, and by how much it is multiplied.
    Answer(&'static str, f64),
    /// A number of the case, as it is written.
    Case(&'static str),
    /// The step's case in a way of its own.
    Of(fn(&Page) -> f64),
    /// Not of the case: a count of the story, a year.
    Given,
}

use From::{Answer, Case, Given, Of};

const SLIDING: From = Answer("/situations/0/SF_sliding", 1.0);
const OVERTURNING: From = Answer("/situations/0/SF_overturning_net", 1.0);
const MOVES_AT: From = Answer("/situations/0/load_factor", 100.0);
const FORCE: From = Case("load[1].force");
const FRICTION: From = Case("body.friction");
const PEAK: From = Case("motion.base.horizontal.peak");
const PHI: From = Case("ground.friction_angle_deg");
const LEVEL: From = Case("load[1].elevation");

/// The numbers of a step, in the order in which they stand in headline, words and task.
type Facts = &'static [(&'static str, From)];

const TWO_FACTORS: [Facts; 6] = [
    &[
        ("1", Given),
        ("15", Case("body.width")),
        ("12", Case("body.height")),
        ("2000", FORCE),
        ("1.11", SLIDING),
        ("1.21", OVERTURNING),
    ],
    &[("1", Given), ("2400", FORCE), ("0.93", SLIDING), ("1.01", OVERTURNING)],
    &[
        ("0.90", OVERTURNING),
        ("1", Given),
        ("0.82", SLIDING),
        ("0.90", OVERTURNING),
        ("0.66", Of(|page| least_friction(page, "RO"))),
    ],
    &[("0.96", SLIDING), ("0.7", FRICTION), ("1", Given)],
    &[("3.7", OVERTURNING), ("7500", FORCE), ("1", LEVEL), ("0.3", FRICTION)],
    &[],
];

const K_MU: [Facts; 7] = [
    &[
        ("0.8", Of(|page| point(page)[0])),
        ("0.73", Of(|page| point(page)[2])),
        ("0.92", Of(|page| point(page)[1])),
        ("0.6", Of(|page| point(page)[3])),
    ],
    &[("0.65", Of(point_a))],
    &[
        ("1.25", Of(|page| 1.0 / point(page)[0])),
        ("1.36", Of(|page| 1.0 / (point(page)[0] * point(page)[1]))),
    ],
    &[("0.65", Of(point_a)), ("0.63", Of(far_end))],
    &[],
    &[("1", LEVEL)],
    &[("2.8", FRICTION), ("1895", Given), ("4", Given), ("3", Given)],
];

const BLOW: [Facts; 6] = [
    &[("112.5", MOVES_AT), ("112.5", MOVES_AT)],
    &[
        ("1.5", Of(|page| number_behind(page.text(), "factors = { wave = "))),
        ("8", Of(|page| 100.0 * slid(page))),
        ("1.6", Case("wave.history.duration")),
        ("0.58", Of(leaves)),
        ("1.25", Answer("/t_rest", 1.0)),
        ("0.085", Of(slid)),
    ],
    &[("0.78", Case("wave.history.duration")), ("0.021", Of(slid))],
    &[("3.1", Case("wave.history.duration")), ("0.34", Of(slid))],
    &[
        ("1.8", Case("body.height")),
        ("0.34", Of(steady)),
        ("0.9", PEAK),
        ("95", Answer("/max_theta_of_balance", 100.0)),
    ],
    &[("0.45", PEAK), ("2.1", Of(overturns)), ("0.4", Given)],
];

const ISLANDS: [Facts; 6] = [
    &[
        ("0.9", PEAK),
        ("0.6", Case("body.width")),
        ("1.8", Case("body.height")),
        ("17.5", Of(|page| answer(page, "/max_theta").to_degrees())),
    ],
    &[("1", PEAK), ("0.54", Of(|page| event(page, "impact"))), ("2.6", Of(overturns))],
    &[
        ("2", PEAK),
        ("1.26", Of(|page| event(page, "impact"))),
        ("6.7", Answer("/t_rest", 1.0)),
        ("2.4", Given),
    ],
    &[("2.4", PEAK), ("1.5", Of(overturns))],
    &[("1.6", PEAK), ("16", Given), ("1.5", Given)],
    &[("2", PEAK)],
];

const GROUND: [Facts; 6] = [
    &[("1.16", SLIDING), ("2.57", OVERTURNING), ("112.5", MOVES_AT)],
    &[("35", PHI), ("35", PHI), ("99.7", MOVES_AT), ("40", Given)],
    &[
        ("15", Case("body.width")),
        ("8.3", Answer("/situations/0/ground/effective_width", 1.0)),
        ("3.3", Answer("/situations/0/eccentricity", 1.0)),
        ("8.3", Answer("/situations/0/ground/effective_width", 1.0)),
        ("0.98", Answer("/situations/0/ground/factor", 1.0)),
    ],
    &[
        ("33", Given),
        (
            "93.7",
            Of(|page| {
                answer(&with(page, "ground.friction_angle_deg", "33"), "/situations/0/load_factor") * 100.0
            }),
        ),
        ("37", PHI),
        ("105.2", MOVES_AT),
        ("2", Given),
        ("33", Given),
        ("37", Given),
    ],
    &[("40", PHI), ("112.5", MOVES_AT), ("112.6", Answer("/situations/0/ground/load_factor_ground", 100.0))],
    &[
        ("3", Case("ground.strength")),
        ("82.2", MOVES_AT),
        ("82.4", Answer("/situations/0/SF_sliding", 100.0)),
        ("30", Given),
    ],
];

const SURE: [Facts; 6] = [
    &[("1.15", OVERTURNING), ("2", Case("earthquake.horizontal")), ("115.4", MOVES_AT)],
    &[
        ("0.3", Of(|page| number_behind(page.text(), "friction = { lognormal = { mean = "))),
        ("100", Given),
        ("8", Of(|_| 100.0 * chance("statue-random", "/not_rest/probability"))),
        ("0.3", FRICTION),
    ],
    &[
        ("0.4", Of(|_| 100.0 * known("statue-random", "friction", "probability_if_known"))),
        ("7.8", Of(|_| 100.0 * chance("statue-random", "/not_rest/probability"))),
        ("7.4", Of(|_| 100.0 * known("statue-random", "body.centroid_height", "probability_if_known"))),
    ],
    &[
        ("1", Given),
        ("40", Of(|_| 1.0 / chance("goda-2000-random", "/not_rest/probability"))),
        ("1.16", SLIDING),
        ("2.5", Of(|_| 100.0 * chance("goda-2000-random", "/not_rest/probability"))),
    ],
    &[
        ("55", Of(|_| 100.0 * known("goda-2000-random", "bias.P", "alpha2"))),
        ("35", Of(|_| 100.0 * known("goda-2000-random", "friction", "alpha2"))),
        ("6", Of(|_| 100.0 * known("goda-2000-random", "wave.deep_water_height", "alpha2"))),
    ],
    &[
        ("8192", Of(|_| chance("goda-2000-random", "/points"))),
        ("2.5", Of(|_| 100.0 * chance("goda-2000-random", "/not_rest/probability"))),
        ("2.46", Of(|_| 100.0 * chance("goda-2000-random", "/not_rest/low"))),
        ("2.52", Of(|_| 100.0 * chance("goda-2000-random", "/not_rest/high"))),
    ],
];

const FACTS: [(&str, &[Facts]); 6] = [
    ("two-factors", &TWO_FACTORS),
    ("k-mu", &K_MU),
    ("blow", &BLOW),
    ("islands", &ISLANDS),
    ("ground", &GROUND),
    ("sure", &SURE),
];

/// What the program's answer to a step's case says, so that words without numbers hold too.
const ANSWERS: [(&str, &[&str]); 6] = [
    (
        "two-factors",
        &[
            "stays at rest",
            "slides to the left (SL)",
            "(SRO-)",
            "rocks about O, the bottom left corner (RO)",
            "(SRO'-)",
            "(SRO-)",
        ],
    ),
    (
        "k-mu",
        &[
            "(SRO-)",
            "stays at rest",
            "slides to the left (SL)",
            "(RO)",
            "(SRO-)",
            "(SRO'-)",
            "slides to the left (SL)",
        ],
    ),
    (
        "blow",
        &[
            "stays at rest",
            "slides to the left",
            "slides to the left",
            "slides to the left",
            "comes to rest",
            "overturns",
        ],
    ),
    (
        "islands",
        &[
            "comes to rest",
            "overturns",
            "past its point of balance, and came back",
            "overturns",
            "overturns",
            "comes to rest",
        ],
    ),
    (
        "ground",
        &[
            "stays at rest",
            "ground that fails",
            "ground that fails",
            "stays at rest",
            "stays at rest",
            "(RO)",
        ],
    ),
    ("sure", &["stays at rest"; 6]),
];

fn stories() -> Vec<Value> {
    serde_json::from_str(&super::json()).expect("stories are JSON")
}

fn steps(story: &Value) -> &[Value] {
    story["steps"].as_array().expect("steps")
}

/// The case of a step, as the page opens it.
fn told(story: &Value, step: &Value) -> Page {
    let mut page = Page::default();
    let name = step["case"].as_str().expect("a case");
    match story["cases"][name].as_array() {
        Some(lines) => {
            let lines: Vec<&str> = lines.iter().filter_map(Value::as_str).collect();
            assert!(page.open("story.toml", &lines.join("\n")), "{name}: {:?}", page.fault());
        }
        None => {
            let example = examples::find(name).unwrap_or_else(|| panic!("no example {name}"));
            assert!(page.open(&example.file(), example.text));
        }
    }
    for (key, value) in step["set"].as_object().into_iter().flatten() {
        page.set(key, value.as_str().expect("a text"))
            .unwrap_or_else(|fault| panic!("{name}, {key}: {fault}"));
    }
    page
}

fn with(page: &Page, key: &str, value: &str) -> Page {
    let mut other = Page::default();
    assert!(other.open(page.name(), page.text()));
    other.set(key, value).unwrap_or_else(|fault| panic!("{key}: {fault}"));
    other
}

fn json(page: &Page) -> Value {
    serde_json::from_str(&page.answered().json()).expect("an answer is JSON")
}

fn answer(page: &Page, pointer: &str) -> f64 {
    json(page).pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {pointer}"))
}

fn number(page: &Page, key: &str) -> Option<f64> {
    let said: Value = serde_json::from_str(&crate::said::json(page)).ok()?;
    let numbers = said["tables"]
        .as_array()?
        .iter()
        .flat_map(|table| table["numbers"].as_array().cloned().unwrap_or_default());
    let found = numbers.into_iter().find(|one| one["key"] == key)?;
    found["digits"].as_str()?.replace('−', "-").parse().ok()
}

fn number_behind(text: &str, words: &str) -> f64 {
    let rest = text.split(words).nth(1).unwrap_or_else(|| panic!("no {words}"));
    let digits: String = rest.chars().take_while(|one| one.is_ascii_digit() || *one == '.').collect();
    digits.parse().expect("a number")
}

/// γ, k′, k and μ.
fn point(page: &Page) -> [f64; 4] {
    let point = page.answered().point().expect("a point").point;
    [point.gamma(), point.k_prime(), point.k(), point.mu()]
}

/// Where rest, slide and rock meet: 1/(γ(1 + k′)).
fn point_a(page: &Page) -> f64 {
    let [gamma, k_prime, ..] = point(page);
    1.0 / (gamma * (1.0 + k_prime))
}

/// The friction to which the curve μ* of rocking tends, a/c.
fn far_end(page: &Page) -> f64 {
    let [gamma, k_prime, ..] = point(page);
    (4.0 + gamma * gamma - 3.0 * gamma * gamma * k_prime) / (3.0 * gamma * (1.0 + k_prime))
}

/// The least friction in hundredths with which the body begins in a mode, from that of the case on.
fn least_friction(page: &Page, mode: &str) -> f64 {
    let from = (100.0 * number(page, "body.friction").expect("friction")).round() as u32;
    let is_it = |hundredths: &u32| {
        let other = with(page, "body.friction", &format!("{}", f64::from(*hundredths) / 100.0));
        json(&other)["situations"][0]["mode"] == mode
    };
    (from..300).find(is_it).map(|hundredths| f64::from(hundredths) / 100.0).expect("some friction")
}

fn slid(page: &Page) -> f64 {
    answer(page, "/slide").abs()
}

/// When the first event of a kind is.
fn event(page: &Page, why: &str) -> f64 {
    let json = json(page);
    let events = json["events"].as_array().expect("events");
    let found = events.iter().find(|event| event["why"] == why);
    found
        .and_then(|event| event["t"].as_f64().or(event["time"].as_f64()))
        .unwrap_or_else(|| panic!("no {why}"))
}

fn leaves(page: &Page) -> f64 {
    event(page, "load")
}

fn overturns(page: &Page) -> f64 {
    event(page, "overturned")
}

/// The acceleration in g that turns the body over if it lasts, in hundredths and upwards: a steady force over its slenderness.
fn steady(page: &Page) -> f64 {
    let ratio = number(page, "body.width").expect("a width") / number(page, "body.height").expect("a height");
    (100.0 * ratio).ceil() / 100.0
}

/// The program's probability of an example.
fn chances(name: &str) -> Value {
    static ALL: OnceLock<[(&str, Value); 2]> = OnceLock::new();
    let all = ALL.get_or_init(|| {
        ["statue-random", "goda-2000-random"].map(|name| {
            let example = examples::find(name).expect("an example");
            let file = standfast_cases::CaseFile::parse(&example.file(), example.text).expect("a case");
            let answer = Probability::of(&file, ChanceRequest::default()).expect("a probability");
            use standfast_cases::Document;
            (name, serde_json::from_str(&answer.json(&Default::default(), &[])).expect("JSON"))
        })
    });
    all.iter().find(|one| one.0 == name).map(|one| one.1.clone()).expect("asked of these two alone")
}

fn chance(name: &str, pointer: &str) -> f64 {
    chances(name).pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {pointer}"))
}

/// What the answer says of one random number.
fn known(name: &str, input: &str, what: &str) -> f64 {
    let all = chances(name);
    let found = all["importance"].as_array().and_then(|list| list.iter().find(|one| one["name"] == input));
    found.and_then(|one| one[what].as_f64()).unwrap_or_else(|| panic!("no {what} of {input}"))
}

/// The numbers in a text as they stand there.
fn tokens(text: &str) -> Vec<&str> {
    let is_of_one = |one: char| one.is_ascii_digit() || one == '.';
    text.split(|one: char| !is_of_one(one))
        .map(|token| token.trim_matches('.'))
        .filter(|token| !token.is_empty())
        .collect()
}

/// True if the value, rounded as the token is, is the token.
fn is_shown(value: f64, token: &str) -> bool {
    let decimals = token.split_once('.').map_or(0, |(_, behind)| behind.len());
    format!("{value:.decimals$}") == token
}

fn words(step: &Value) -> String {
    ["head", "words", "do"].map(|part| step[part].as_str().unwrap_or_default()).join(" ")
}

#[test]
fn every_number_of_a_story_is_that_of_its_case() {
    let stories = stories();
    assert_eq!(stories.len(), FACTS.len());
    for (story, (id, facts)) in stories.iter().zip(FACTS) {
        assert_eq!(story["id"], id);
        assert_eq!(steps(story).len(), facts.len(), "{id}");
        for (i, (step, facts)) in steps(story).iter().zip(facts).enumerate() {
            let words = words(step);
            let of_facts: Vec<&str> = facts.iter().map(|fact| fact.0).collect();
            assert_eq!(tokens(&words), of_facts, "{id} {}: {words}", i + 1);
            let page = told(story, step);
            for (token, from) in *facts {
                let value = match from {
                    Answer(pointer, times) => answer(&page, pointer) * times,
                    Case(key) => number(&page, key).unwrap_or_else(|| panic!("{id} {}: no {key}", i + 1)),
                    Of(compute) => compute(&page),
                    Given => continue,
                };
                assert!(is_shown(value, token), "{id} {}: {token} is {value}", i + 1);
            }
        }
    }
}

#[test]
fn every_step_has_the_answer_that_its_words_tell() {
    for (story, (id, answers)) in stories().iter().zip(ANSWERS) {
        assert_eq!(steps(story).len(), answers.len(), "{id}");
        for (i, (step, expected)) in steps(story).iter().zip(answers).enumerate() {
            let answer = told(story, step).answered().summary().expect("an answer").answer;
            assert!(answer.contains(expected), "{id} {}: {answer}", i + 1);
        }
    }
}

/// What a step asks the reader to do has the outcome that it promises.
#[test]
fn what_a_step_asks_for_comes_true() {
    let stories = stories();
    let page = |story: usize, step: usize| told(&stories[story], &steps(&stories[story])[step - 1]);
    let mode = |page: &Page| page.answered().verdict().expect("a verdict").symbol();
    // Two factors: 4, however hard it is pushed; 5, until it slides.
    for force in ["2500", "4000", "9000", "50000"] {
        assert_eq!(mode(&with(&page(0, 4), "load[1].force", force)), "RO", "{force}");
    }
    assert!((31..100).any(|mu| mode(&with(&page(0, 5), "body.friction", &format!("0.{mu}"))) == "SL"));
    // In the plane of the sixth step there are these four, and no other.
    let mut found: Vec<&str> = Vec::new();
    for force in (100..9000).step_by(100) {
        let pushed = with(&page(0, 6), "load[1].force", &force.to_string());
        for mu in 1..12 {
            let symbol = mode(&with(&pushed, "body.friction", &format!("{}", f64::from(mu) / 10.0)));
            if !found.contains(&symbol) {
                found.push(symbol);
            }
        }
    }
    found.sort_unstable();
    assert_eq!(found, ["RE", "RO", "SL", "SRO-"]);
    // Where three motions fit, and that less friction leads out.
    let three = page(1, 7);
    assert_eq!(json(&three)["situations"][0]["also"].as_array().map(Vec::len), Some(2));
    assert!(json(&with(&three, "body.friction", "0.9"))["situations"][0]["unique"] == true);
    // A blow: less, and the column stands.
    let end = |page: &Page| page.answered().summary().expect("an answer").answer;
    assert!(end(&with(&page(2, 6), "motion.base.horizontal.peak", "0.4 g")).contains("comes to rest"));
    // The way grows with the square of the time.
    for (step, times) in [(3, 0.25), (4, 4.0)] {
        assert!((slid(&page(2, step)) / slid(&page(2, 2)) / times - 1.0).abs() < 1e-3, "{step}");
    }
    // The ground: 40°, and hard stone.
    assert!(end(&with(&page(4, 2), "ground.friction_angle_deg", "40")).contains("stays at rest"));
    assert_eq!(mode(&with(&page(4, 6), "ground.strength", "30 MPa")), "SRO-");
    // The statue slides where friction is low enough.
    assert_ne!(mode(&with(&page(5, 1), "body.friction", "0.15")), "RE");
}

/// The strip of the fifth step has the gap that its words tell.
#[test]
fn the_island_is_in_the_strip() {
    let stories = stories();
    let mut page = told(&stories[3], &steps(&stories[3])[4]);
    while page.try_strength() {}
    let strength = page.answered().motions[0].strength.clone().expect("a strength");
    let overturned = |factor: f64| {
        let nearest = strength
            .tried
            .iter()
            .min_by(|one, other| (one.factor - factor).abs().total_cmp(&(other.factor - factor).abs()));
        let nearest = nearest.expect("some");
        assert!((nearest.factor - factor).abs() < 0.006, "{factor}: {}", nearest.factor);
        nearest.overturned
    };
    assert_eq!([0.5, 1.14, 1.16, 1.2, 1.5, 2.0].map(overturned), [false, true, false, false, true, true]);
}

/// A step names things that there are: a plate of its case, a drawing, a figure, keys that stand in its text.
#[test]
fn steps_name_what_there_is() {
    for story in &stories() {
        for step in steps(story) {
            let page = told(story, step);
            let head = step["head"].as_str().expect("a headline");
            if let Some(plate) = step["plate"].as_str() {
                assert!(page.plates().contains(&plate), "{head}: {plate}");
            }
            if let Some(figure) = step["figure"].as_str() {
                assert!(standfast_figures::FigureId::ALL.iter().any(|id| id.number() == figure), "{head}");
            }
            assert!(step["plate"].is_string() || step["figure"].is_string(), "{head}");
            for key in step["hold"].as_array().into_iter().flatten() {
                assert!(number(&page, key.as_str().expect("a key")).is_some(), "{head}: {key}");
            }
            let body = step["body"].as_str().expect("a drawing");
            assert!(page.body_on_paper(body).starts_with("<svg"), "{head}: {body}");
            for sentence in words(step).split(['.', '?', '!']).filter(|one| one.starts_with(' ')) {
                assert!(sentence.split_whitespace().count() <= 26, "too long: {sentence}");
            }
        }
    }
}
