//! The sheet's numbers: those of the library, and those that its own formulas give when they are worked out by hand, here by an
//! evaluator of the MathML that a reader sees.

mod common;

use std::cell::Cell;
use std::collections::BTreeMap;

use common::{Step, cases, document, is_of_joint, select, si, steps, units_of_loads};
use scraper::ElementRef;
use serde_json::Value;
use standfast_cases::results::{ResultKind, ResultName};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document};

/// Numbers of the sea that the sheet shows under the names of the JSON.
const SEA: [&str; 18] = [
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
];

/// A number of the JSON, which may be the word for infinity; `None` where there is no such thing.
fn number(json: &Value) -> Option<f64> {
    if json == "infinite" { Some(f64::INFINITY) } else { json.as_f64() }
}

/// True if the situation is calculated in full, rather than in a column beside others.
fn is_in_full(html: &scraper::Html, situation: usize) -> bool {
    !select(html, &format!("section.part[data-load=\"{situation}\"]")).is_empty()
}

/// A number of the sheet in SI units; angles in degrees, as in the JSON.
fn in_si(element: ElementRef<'_>) -> f64 {
    let value = si(element, "value").unwrap();
    let degrees = element.attr("data-quantity") == Some("angle_deg");
    if degrees { value.to_degrees() } else { value }
}

fn attribute(element: ElementRef<'_>) -> f64 {
    element.attr("value").unwrap().parse().unwrap()
}

fn same(shown: f64, json: f64) -> bool {
    // Numbers shown in kN or in feet went through divisions and multiplications.
    shown == json || (shown - json).abs() <= 32.0 * f64::EPSILON * json.abs()
}

#[test]
fn every_number_of_the_json_answer_is_on_the_sheet() {
    let compared = Cell::new(0);
    for (name, text) in cases() {
        let case = CaseFile::parse(&name, &text).unwrap().case().unwrap();
        let assessment = Assessment::of(&case).unwrap();
        let json: Value = serde_json::from_str(&assessment.json(&AssessmentView::default(), &[])).unwrap();
        let html = document(&name, &text);
        let outside = |selector: &str| {
            select(&html, selector).into_iter().filter(|data| !is_of_joint(*data)).collect::<Vec<_>>()
        };
        let all = |selector: &str| outside(selector).into_iter().map(in_si).collect::<Vec<_>>();
        // Of several with one name, the last.
        let by_name = |scope: &str| -> BTreeMap<_, _> {
            let data = outside(&format!("{scope} data[data-quantity]"));
            data.into_iter().map(|data| (data.attr("data-quantity").unwrap().to_owned(), data)).collect()
        };
        let compare = |shown: Option<f64>, json: &Value, what: &str| match (shown, number(json)) {
            (None, None) => {}
            (Some(shown), Some(json)) => {
                assert!(same(shown, json), "{name}: {what} is {shown}, and {json} in JSON");
                compared.set(compared.get() + 1);
            }
            other => panic!("{name}: {what} on the sheet and in JSON: {other:?}"),
        };
        let of_all = by_name("section.part:not([data-load])");
        for key in SEA.into_iter().filter(|_| !json["wave"].is_null()) {
            compare(of_all.get(key).copied().map(in_si), &json["wave"][key], key);
        }
        for (i, situation) in json["situations"].as_array().unwrap().iter().enumerate() {
            let scope = format!("[data-load=\"{i}\"]");
            let of_situation = by_name(&scope);
            let shown = |key: &str| of_situation.get(key).copied().map(in_si);
            let wave = &situation["combination"]["wave"];
            for key in SEA.into_iter().filter(|_| !wave.is_null()) {
                compare(shown(key), &wave[key], key);
            }
            for result in ResultName::ALL {
                if matches!(result.info().kind, ResultKind::Number(_)) {
                    let json = match result.in_ground() {
                        None => &situation[result.name()],
                        Some("periods") => {
                            &situation["ground"]["periods"][usize::from(*result == ResultName::Period2)]
                        }
                        Some(name) => &situation["ground"][name],
                    };
                    compare(shown(result.name()), json, result.name());
                }
            }
            // Of a motion what is zero is left out.
            let motion = situation["motion"].as_object().into_iter().flatten();
            for (key, value) in motion.filter(|(_, value)| number(value) != Some(0.0)) {
                compare(shown(&format!("motion.{key}")), value, key);
            }
            let path = situation["path"].as_array().unwrap();
            let in_full = is_in_full(&html, i);
            let ends: Vec<_> = path
                .iter()
                .flat_map(|stage| [&stage["from"], &stage["to"]])
                .map(|end| number(end).unwrap())
                .collect();
            assert_eq!(all(&format!("{scope} [data-table=path] data")), ends, "{name}");
            let parts = situation["components"].as_array().unwrap().iter();
            let parts: Vec<_> =
                parts.flat_map(|part| ["x", "p", "m"].map(|key| number(&part[key]).unwrap())).collect();
            let on_plan = situation["plan"].is_object();
            if in_full && on_plan {
                let table = outside(&format!("{scope} [data-table=plan-loads] data"));
                let parts = situation["components"].as_array().unwrap().iter();
                let parts: Vec<_> =
                    parts.flat_map(|part| ["x", "z", "p"].map(|key| number(&part[key]).unwrap())).collect();
                let shown =
                    table.chunks(5).flat_map(|row| row[..3].iter().map(|data| 1e3 * attribute(*data)));
                for (shown, json) in shown.zip(&parts) {
                    assert!(same(shown, *json), "{name}: {shown} {json}");
                }
                assert_eq!(table.len(), 5 * (parts.len() / 3 + 1), "{name}");
            } else if in_full {
                let table = outside(&format!("{scope} [data-table=components] data"));
                let units = units_of_loads(&html, &scope);
                let shown = table.iter().enumerate().map(|(place, data)| units[place % 3] * attribute(*data));
                for (shown, json) in shown.zip(&parts) {
                    assert!(same(shown, *json), "{name}: {shown} {json}");
                }
                assert_eq!(table.len(), parts.len() + 3, "{name}");
            } else {
                // Rows of its column, or of a situation in full if they are the same there.
                let results = "[data-table=components] data, .result data";
                let known: Vec<f64> =
                    select(&html, &format!("td{scope} data, {results}")).into_iter().map(in_si).collect();
                for json in &parts {
                    let found = known
                        .iter()
                        .any(|shown| same(shown.abs(), json.abs()) || same(1e3 * shown.abs(), json.abs()));
                    assert!(found || *json == 0.0, "{name}: {json} of situation {i}");
                }
            }
            let relations: Vec<&Value> = match &situation["report"]["trace"] {
                Value::Array(trace) => {
                    trace.iter().flat_map(|step| step["relations"].as_array().unwrap()).collect()
                }
                _ => Vec::new(),
            };
            let margins: Vec<_> =
                relations.iter().map(|relation| number(&relation["margin"]).unwrap().abs()).collect();
            if !margins.is_empty() {
                assert_eq!(all(&format!("{scope} data[data-quantity=margin]")), margins, "{name}");
            }
            compared.set(compared.get() + ends.len() + parts.len() + margins.len());
        }
    }
    assert!(compared.get() > 1300, "{compared:?}");
}

/// The criteria on page 1 and at their steps, and the accelerations that were tried, are those of the JSON.
#[test]
fn criteria_and_earthquakes_are_those_of_the_json_answer() {
    let mut compared = 0;
    for (name, text) in cases() {
        let case = CaseFile::parse(&name, &text).unwrap().case().unwrap();
        let assessment = Assessment::of(&case).unwrap();
        let json: Value = serde_json::from_str(&assessment.json(&AssessmentView::default(), &[])).unwrap();
        let html = document(&name, &text);
        let words = |row: &ElementRef<'_>| row.text().collect::<Vec<_>>().join(" ");
        let criteria = json["criteria"].as_array().unwrap();
        let rows = select(&html, "[data-table=criteria] tbody tr");
        assert_eq!(rows.len(), criteria.len(), "{name}");
        for (row, criterion) in rows.iter().zip(criteria) {
            let row = words(row);
            assert!(row.contains(criterion["name"].as_str().unwrap()), "{name}: {row}");
            assert_eq!(row.contains("not met"), !criterion["met"].as_bool().unwrap(), "{name}: {row}");
            if let Some(used) = criterion["utilisation"].as_f64().filter(|used| *used > 0.0) {
                // Four digits are shown, or as many as tell it from 1.
                let shown = row
                    .split(|c: char| !(c.is_ascii_digit() || c == '.'))
                    .filter_map(|word| word.parse::<f64>().ok());
                assert!(
                    shown.into_iter().any(|shown| (shown / used - 1.0).abs() < 5e-4),
                    "{name}: {row} {used}"
                );
            }
            compared += 1;
        }
        for (i, situation) in json["situations"].as_array().unwrap().iter().enumerate() {
            let scope = format!("[data-load=\"{i}\"]");
            for criterion in situation["criteria"].as_array().unwrap() {
                let Some(used) = criterion["utilisation"].as_f64() else { continue };
                let results = select(&html, &format!("{scope} .result data, td{scope} data"));
                assert!(
                    results.into_iter().any(|result| same(attribute(result), used)),
                    "{name}: {criterion}"
                );
            }
            let combination = &situation["combination"];
            let factors = |of: &Value| -> Vec<f64> {
                let order = combination["factors"].as_object().into_iter().flatten();
                let pairs = order.filter(|(_, factor)| factor.is_array());
                pairs.map(|(name, _)| of[name].as_f64().unwrap()).collect()
            };
            let shaken = |of: &Value| {
                let parts = [&of["horizontal"], &of["vertical"]].into_iter().filter_map(Value::as_f64);
                // Seen from above there is a third part, which the document leaves out where it is zero.
                let away = || of["horizontal_z"].as_f64().unwrap_or(0.0);
                let away = (!situation["plan"].is_null() && of.is_object()).then(away);
                parts.chain(away).collect::<Vec<_>>()
            };
            let mut tried: Vec<Vec<f64>> = Vec::new();
            match combination["tried"].as_array() {
                Some(others) => {
                    tried.push(
                        [factors(&combination["factors_used"]), shaken(&situation["earthquake"])].concat(),
                    );
                    tried.extend(
                        others.iter().map(|of| [factors(&of["factors"]), shaken(&of["earthquake"])].concat()),
                    );
                }
                None => {
                    let others = situation["other_earthquakes"].as_array().unwrap();
                    let all = [&situation["earthquake"]].into_iter().chain(others);
                    tried.extend(all.take(others.len() * 2).map(shaken));
                }
            }
            let rows = select(&html, &format!("{scope} [data-table=tried] tbody tr"));
            // Before the mode, which is no number; factors in the order of the alphabet.
            let mut shown: Vec<Vec<f64>> = Vec::new();
            for row in &rows {
                let cells = row.select(&"td".try_into().unwrap()).collect::<Vec<_>>().into_iter();
                let numbers = cells.take_while(|cell| cell.value().attr("class") == Some("n"));
                let data =
                    |cell: ElementRef<'_>| cell.select(&"data".try_into().unwrap()).next().map(attribute);
                shown.push(numbers.filter_map(data).collect());
            }
            let rank = |of: &Vec<f64>| format!("{of:?}");
            let sorted = |mut all: Vec<Vec<f64>>| {
                all.iter_mut().for_each(|row| row.sort_by(f64::total_cmp));
                all.sort_by_key(rank);
                all
            };
            let (shown, tried) = (sorted(shown), sorted(tried));
            assert_eq!(shown, tried, "{name}");
            compared += tried.len();
        }
    }
    assert!(compared > 30, "{compared}");
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

/// A number put into a formula is an input, a factor of a combination, the result of a step, or a part of the motion.
#[test]
fn every_number_put_in_stands_elsewhere_on_the_sheet() {
    for (name, text) in cases() {
        let html = document(&name, &text);
        let known: Vec<f64> =
            select(&html, "[data-table=inputs] data, [data-table=factors] data, .result data, [data-table=motion] data, [data-side]")
                .into_iter()
                .map(|data| si(data, "value").unwrap().abs())
                .collect();
        // What a code asks for stands in no line of the case file.
        let asked = select(&html, "[data-table=criteria] [data-label=Required]").into_iter();
        let asked = asked.filter_map(|cell| {
            let text: String = cell.text().collect();
            text.trim_start_matches(['≥', '≤', ' ']).split(' ').next()?.parse::<f64>().ok()
        });
        // Of a joint the parts of loads stand in its table alone, in kN and kN m.
        let of_joints = select(&html, "[data-joint] [data-table=components] data").into_iter();
        let of_joints = of_joints.map(|data| 1e3 * attribute(data).abs());
        let known: Vec<f64> = known.into_iter().chain(asked).chain(of_joints).collect();
        for leaf in select(&html, ".numbers [data-value]") {
            let value = si(leaf, "data-value").unwrap();
            let found = known.iter().any(|known| (known - value).abs() <= 1e-12 * value);
            assert!(found || value == 0.0, "{name}: {value} comes from nowhere");
        }
    }
}

/// Parts whose centres and edges meet but for rounding, a uniform pressure on the middle of the top, and a head of water that is none.
const ROUNDED: [&str; 2] = [
    r#"
[body]
friction = 0.6
[[part]]
name = "first course"
left = "0.1 m"
width = "1.2 m"
bottom = 0
height = "0.6 m"
density = "2400 kg/m3"
[[part]]
name = "second course"
left = "0.2 m"
width = "1.0 m"
bottom = "0.6 m"
height = "0.6 m"
density = "2350 kg/m3"
[[part]]
name = "third course"
left = "0.35 m"
width = "0.7 m"
bottom = "1.2 m"
height = "0.6 m"
density = "2300 kg/m3"
[[pressure]]
name = "backfill"
face = "right"
elevation = ["0 m", "1.8 m"]
pressure = ["9.1 kPa", "0 kPa"]
[[pressure]]
name = "surcharge"
face = "top"
distance = ["0 m", "1.2 m"]
pressure = ["3.3 kPa", "3.3 kPa"]
permanent = true
"#,
    r#"
[body]
width = "18.7 m"
height = "15.1 m"
density = "2150 kg/m3"
friction = 0.6
[water]
level = "8.3 m"
density = "1030 kg/m3"
[[pressure]]
name = "trough"
face = "left"
elevation = ["0 m", "8.3 m"]
pressure = ["-29.3 kPa", "-29.3 kPa"]
[[pressure]]
name = "uplift"
face = "base"
distance = ["0 m", "18.7 m"]
pressure = ["17.3 kPa", "17.3 kPa"]
"#,
];

#[test]
fn what_cancels_is_zero() {
    let rounded = ROUNDED.iter().map(|text| ("rounded".to_owned(), (*text).to_owned()));
    for (name, text) in cases().into_iter().chain(rounded) {
        let warnings = CaseFile::parse(&name, &text).unwrap().case().unwrap().warnings();
        assert!(name != "rounded" || warnings.is_empty(), "{warnings:?}");
        let html = document(&name, &text);
        for data in select(&html, "data[value], [data-value]") {
            let shown = common::shown(data).abs();
            assert!(shown == 0.0 || shown > 1e-9, "{name}: {} stands for zero", data.html());
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
