//! Rows of bodies alike: that any of them leaves rest, against integrals written out here.

mod common;

use common::{POINT, chances_at_point, file, mean, try_chances};
use standfast_cases::design::{Design, DesignRequest, Extreme, Spelling};
use standfast_cases::random::{Probability, ProbabilityError};
use standfast_cases::{Assessment, Document, Portion};
use standfast_probability::normal::below;

const OWN: &str = "mu = { normal = { mean = 0.5, sd = 0.04 }, each = \"body\" }\n";

fn try_answer(text: &str) -> Result<Probability, ProbabilityError> {
    try_chances(text, 0.02)
}

fn answer(random: &str) -> Probability {
    chances_at_point(random, 0.02)
}

fn slides(k: f64) -> f64 {
    below((k - 0.5) / 0.04)
}

/// One sea, and as many frictions as bodies: E[1 − (1 − P(μ < k))ⁿ] in an event; over a life the largest of the yearly seas counts.
#[test]
fn any_of_a_row_slides_where_the_least_friction_does() {
    let k = |z: f64| 0.3 + 0.05 * z;
    let random = format!(
        "bodies = 12\nyears = 25\n{OWN}k = {{ normal = {{ mean = 0.3, sd = 0.05 }}, every = \"year\" }}\n"
    );
    let found = answer(&random);
    let row = found.row.unwrap();
    let any = |z: f64| 1.0 - (1.0 - slides(k(z))).powi(12);
    let event = mean(any);
    assert_eq!(row.bodies, 12);
    assert!((row.not_rest.value / event - 1.0).abs() < 1e-6, "{row:?} {event}");
    let life = mean(|z| 25.0 * below(z).powi(24) * any(z));
    let of_life = row.life.unwrap();
    assert!((of_life.value - life).abs() < of_life.high - of_life.low, "{row:?} {life}");
    assert!(of_life.high - of_life.low < 0.1 * life, "{row:?} {life}");
    // What each body does alone is as without a row.
    let alone = answer(&random.replace("bodies = 12\n", "").replace(", each = \"body\"", ""));
    assert_eq!(alone.situations[0].not_rest, found.situations[0].not_rest);
    assert_eq!(alone.row, None);

    let words = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains(
            "At least one of 12 bodies in a row, each with its own mu, does not stay at rest in one year:"
        ),
        "{words}"
    );
    let json: serde_json::Value = serde_json::from_str(&found.json(&(), &[])).unwrap();
    assert_eq!(json["row"]["bodies"], 12);
    assert_eq!(json["row"]["life"]["probability"].as_f64().unwrap(), of_life.value);
}

/// Years at rest of all of them: P(T + t) − P(T) over 1 − P(T), of the whole row.
#[test]
fn a_row_that_has_stood() {
    let random = format!(
        "bodies = 6\nyears = 10\nsurvived = 15\n{OWN}k = {{ normal = {{ mean = 0.3, sd = 0.06 }}, every = \"year\" }}\n"
    );
    let row = answer(&random).row.unwrap();
    let over = |years: i32| {
        mean(|z| {
            let any = 1.0 - (1.0 - slides(0.3 + 0.06 * z)).powi(6);
            f64::from(years) * below(z).powi(years - 1) * any
        })
    };
    let expected = (over(25) - over(15)) / (1.0 - over(15));
    let words = answer(&random).text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("over 10 years after 15 years in which all of them rested"), "{words}");
    let life = row.life.unwrap();
    assert!(life.low <= expected && expected <= life.high, "{life:?} {expected}");
}

const BLOCK: &str = "[body]\nwidth = 12\nheight = 3\nmass = 60e3\nfriction = 0.5\n\
                     [[load]]\nname = \"push\"\nforce = 200e3\nelevation = 1\n";

/// Each of two pushes acts alone, and the base shakes to both sides: any body under any of them.
#[test]
fn several_sets_of_loads_are_joined() {
    let random = "[random]\nbodies = 5\nfriction = { normal = { mean = 0.5, sd = 0.05 }, each = \"body\" }\n\
                  earthquake.horizontal = { normal = { mean = \"0.3 g\", sd = \"0.08 g\" }, lower = \"0 g\" }\n";
    let text = format!(
        "{}[earthquake]\nhorizontal = \"0.3 g\"\n{random}",
        &BLOCK[..BLOCK.find("[[load]]").unwrap()]
    );
    let row = try_answer(&text).unwrap().row.unwrap();
    // Both sides are one: a body moves to the one or the other.
    let cut = below(-0.3 / 0.08);
    let event = mean(|z| {
        let a = 0.3 + 0.08 * z;
        if a < 0.0 { 0.0 } else { 1.0 - (1.0 - below((a - 0.5) / 0.05)).powi(5) }
    }) / (1.0 - cut);
    assert!((row.not_rest.value / event - 1.0).abs() < 1e-4, "{row:?} {event}");
}

/// The criterion on any of a row, of one event, of a life, and as what a design aims at.
#[test]
fn any_of_a_row_is_a_criterion() {
    let law = "[random]\nbodies = 8\nfriction = { normal = { mean = 0.5, sd = 0.04 }, each = \"body\" }\n\
               \"load.push.force\" = { normal = { mean = 200e3, sd = 20e3 } }\n";
    let of_width = |width: f64| {
        let weight = 60e3 / 12.0 * width * 9.81;
        mean(|z| 1.0 - (1.0 - below(((200e3 + 20e3 * z) / weight - 0.5) / 0.04)).powi(8))
    };
    let text = |most: f64| format!("{BLOCK}[criteria]\np_any = {most}\n{law}");
    let found = try_answer(&text(1e-3)).unwrap();
    assert!((found.criteria[0].counted / of_width(12.0) - 1.0).abs() < 1e-6, "{:?}", found.criteria);
    let words = found.text(&()).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("p_any in one event is"), "{words}");
    let assessed = Assessment::of_file(&file(&text(1.0 - 1e-9))).unwrap();
    assert!(assessed.all_checks()[0].is_met());
    let request = DesignRequest {
        vary: "width".to_owned(),
        target: "p_any=0.01".parse().unwrap(),
        extreme: Extreme::Least,
        from: Some("5".to_owned()),
        to: Some("20".to_owned()),
        spelling: &Spelling::PROGRAM,
    };
    let design = Design::of(&file(&text(0.5)), request, Portion::UNSEEN).unwrap();
    let json: serde_json::Value = serde_json::from_str(&design.json(&(), &[])).unwrap();
    let boundary = json["found"]["boundary"].as_f64().unwrap();
    assert!((of_width(boundary) / 0.01 - 1.0).abs() < 1e-5, "{boundary} {}", of_width(boundary));

    let life = found_text_of_life(&text(1e-3));
    assert!(life.contains("p_any over 30 years"), "{life}");
}

fn found_text_of_life(text: &str) -> String {
    let text = text
        .replace("bodies = 8\n", "bodies = 8\nyears = 30\n")
        .replace("sd = 20e3 } }", "sd = 20e3 }, every = \"year\" }");
    try_answer(&text).unwrap().text(&()).split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn what_makes_no_row_is_refused() {
    let k = "k = { normal = { mean = 0.3, sd = 0.05 } }\n";
    for (random, expected) in [
        (format!("bodies = 12\n{k}"), "`bodies` counts bodies in a row, and no number has each = \"body\""),
        (format!("{OWN}{k}"), "`mu` is drawn for each body; expected `bodies`, how many stand in the row"),
        (format!("bodys = 12\n{OWN}{k}"), "did you mean `bodies`?"),
        (format!("sensitivity = true\n{k}"), "did you mean `sensitivities`?"),
        (format!("bodies = 1\n{OWN}"), "`bodies` is 1; expected a whole number from 2 to 1000"),
        (format!("bodies = 2.5\n{OWN}"), "`bodies` is 2.5; expected a whole number from 2 to 1000"),
        (format!("bodies = \"12\"\n{OWN}"), "`bodies` is a text; expected a number without unit or quotes"),
        (
            format!("bodies = 12\n{}", OWN.replace("\"body\"", "\"caisson\"")),
            "`each` is \"caisson\"; expected \"body\"",
        ),
        (
            format!(
                "bodies = 12\nyears = 10\n{OWN}{}[[random.correlation]]\nbetween = [\"mu\", \"k\"]\nnormal = 0.3\n",
                k.replace(" } }", " }, every = \"year\" }")
            ),
            "`mu` is each body's own for life, and correlated with `k`, which is common to all each year",
        ),
    ] {
        let text = format!("{POINT}{random}");
        let error = try_answer(&text).expect_err(&text);
        assert!(error.to_string().contains(expected), "{random}\n{error}");
    }
    let stood = try_answer(&format!("{POINT}bodies = 3\nsurvived = 9\n{OWN}{k}")).unwrap_err();
    assert!(stood.to_string().contains("nothing says how many years it has"), "{stood}");
    let text = format!(
        "{BLOCK}[criteria]\np_any = 0.1\n[random]\nfriction = {{ normal = {{ mean = 0.5, sd = 0.05 }} }}\n"
    );
    let error = try_answer(&text).unwrap_err().to_string();
    assert!(error.contains("nothing says how many there are"), "{error}");
}
