//! The sheet's numbers: those of the library, and those that its own formulas give when they are worked out by hand, here by an
//! evaluator of the MathML that a reader sees.

mod common;

use common::{Step, cases, document, select, si, steps};
use scraper::ElementRef;
use serde_json::Value;
use standfast_cases::{Assessment, Case};

/// JSON keys of numbers that the sheet shows under the same name.
const KEYS: [&str; 33] = [
    "P",
    "M_p",
    "U",
    "M_U",
    "buoyant_weight",
    "weight_arm",
    "SF_sliding",
    "SF_overturning",
    "SF_overturning_about_toe",
    "heel_pressure",
    "resultant_arm",
    "k_eff",
    "k_prime_eff",
    "H13",
    "Hmax",
    "deep_water_wavelength",
    "wavelength",
    "h_b",
    "angle_deg",
    "eta_star",
    "h_c_star",
    "alpha_1",
    "alpha_2",
    "alpha_3",
    "alpha_4",
    "alpha_I",
    "alpha_star",
    "p1",
    "p3",
    "p4",
    "pu",
    "k",
    "k_prime",
];

fn attribute(element: ElementRef<'_>) -> f64 {
    element.attr("value").unwrap().parse().unwrap()
}

/// Compares a number of the sheet with one of the JSON, where `null` is infinite or missing; says whether there was one.
fn compare(shown: Option<f64>, json: Option<&Value>, what: &str) -> bool {
    let expected = json.and_then(Value::as_f64);
    match (shown, expected) {
        (None, None) => false,
        (Some(shown), None) if json.is_some() => {
            assert!(shown.is_infinite(), "{what} is {shown} on the sheet, and null in JSON");
            true
        }
        (shown, expected) => {
            assert_eq!(shown, expected, "{what}");
            true
        }
    }
}

#[test]
fn every_number_of_the_json_answer_is_on_the_sheet() {
    let mut compared = 0;
    for (name, text) in cases() {
        let case = Case::parse(&name, &text).unwrap();
        let json: Value = serde_json::from_str(&Assessment::of(&case, 2.0).unwrap().json(&[])).unwrap();
        let html = document(&name, &text);
        let all = |selector: &str| select(&html, selector).into_iter().map(attribute).collect::<Vec<_>>();
        let shown = |scope: &str, key: &str| all(&format!("{scope} data[data-quantity=\"{key}\"]")).pop();
        let loads = json["loads"].as_array().unwrap().clone();
        let answers = if loads.is_empty() { vec![json.clone()] } else { loads };
        for (i, answer) in answers.iter().enumerate() {
            let scope = format!("[data-load=\"{i}\"]");
            for key in KEYS {
                // The sea's numbers stand once for all loads.
                let number = answer.get(key).or(json.get(key));
                let shown = shown(&scope, key).or_else(|| shown("", key));
                compared += usize::from(compare(shown, number, &format!("{name}: {key}")));
            }
            for group in ["motion", "motion_si"] {
                let Some(motion) = answer.get(group).and_then(Value::as_object) else { continue };
                for (key, number) in motion {
                    let thousand = group == "motion_si" && matches!(key.as_str(), "f_x" | "f_y");
                    let expected = number.as_f64().unwrap() / if thousand { 1e3 } else { 1.0 } + 0.0;
                    assert_eq!(shown(&scope, &format!("{group}.{key}")), Some(expected), "{name}: {key}");
                    compared += 1;
                }
            }
            if let Some(factors) = answer.get("safety_factors") {
                for key in ["sliding", "overturning"] {
                    assert!(compare(shown(&scope, key), factors.get(key), key), "{name}: {key}");
                    compared += 1;
                }
            }
            if let Some(force) = answer.get("leaves_rest_force").and_then(Value::as_f64) {
                assert_eq!(shown(&scope, "leaves_rest_force"), Some(force / 1e3), "{name}");
            }
            if let Some(path) = answer.get("path").and_then(Value::as_array) {
                let ends = path.iter().flat_map(|stage| [&stage["from"], &stage["to"]]);
                let ends: Vec<_> = ends.map(|end| end.as_f64().unwrap()).collect();
                assert_eq!(all(&format!("{scope} [data-table=path] data")), ends, "{name}");
                let parts = answer["components"].as_array().unwrap().iter();
                let parts = parts.flat_map(|part| [&part["horizontal"], &part["vertical"], &part["moment"]]);
                let parts: Vec<_> = parts.map(|part| part.as_f64().unwrap() + 0.0).collect();
                let table = all(&format!("{scope} [data-table=components] data"));
                assert_eq!(table[..parts.len()], parts, "{name}");
                compared += ends.len() + parts.len();
            }
            if let Some(trace) = answer.get("trace").and_then(Value::as_array) {
                let relations = trace.iter().flat_map(|step| step["relations"].as_array().unwrap());
                let margins: Vec<_> = relations
                    .map(|relation| relation["margin"].as_f64().unwrap_or(f64::INFINITY).abs())
                    .collect();
                assert_eq!(all(&format!("{scope} data[data-quantity=margin]")), margins, "{name}");
                compared += margins.len();
            }
        }
    }
    assert!(compared > 800, "{compared}");
}

#[test]
fn every_formula_has_its_numbers_and_comes_out_as_the_result_says() {
    let mut evaluated = 0;
    for (name, text) in cases() {
        let html = document(&name, &text);
        for Step { name: step, symbols, numbers, result } in steps(&html) {
            let what = format!("{name}: {step}");
            assert!(symbols, "{what} has no formula");
            let (value, scale) = numbers.unwrap_or_else(|| panic!("{what} has no numbers"));
            let result = result.unwrap_or_else(|| panic!("{what} has no result"));
            let error = if value == result { 0.0 } else { (value - result).abs() };
            assert!(error <= 1e-9 * result.abs().max(scale), "{what}: {value}, and the result is {result}");
            evaluated += 1;
        }
    }
    assert!(evaluated > 900, "{evaluated}");
}

/// A number put into a formula is an input, the result of a step, or a part of the motion.
#[test]
fn every_number_put_in_stands_elsewhere_on_the_sheet() {
    for (name, text) in cases() {
        let html = document(&name, &text);
        let known: Vec<f64> =
            select(&html, "[data-table=inputs] data, .result data, [data-table=motion] data, [data-side]")
                .into_iter()
                .map(|data| si(data, "value").unwrap().abs())
                .collect();
        for leaf in select(&html, ".numbers [data-value]") {
            let value = si(leaf, "data-value").unwrap();
            let found = known.iter().any(|known| (known - value).abs() <= 1e-12 * value);
            assert!(found || value == 0.0, "{name}: {value} comes from nowhere");
        }
    }
}

#[test]
fn what_is_shown_is_what_is_meant() {
    for (name, text) in cases() {
        let html = document(&name, &text);
        for data in select(&html, "data[value], [data-value]") {
            let meant: f64 = data.attr("value").or(data.attr("data-value")).unwrap().parse().unwrap();
            let shown = common::shown(data);
            let percent = data.attr("data-percent").is_some();
            let shown = if percent { shown / 100.0 } else { shown };
            assert!(common::close(shown, meant), "{name}: {meant} is shown as {}", data.html());
        }
    }
}
