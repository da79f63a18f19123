//! The section of a case shows the numbers of the case.

use std::path::Path;

use standfast_cases::layout::digits;
use standfast_cases::{Assessment, Case, CaseFile, Drawn, View};
use standfast_figures::Figure;

fn case(name: &str, text: &str) -> Case {
    CaseFile::parse(name, text).unwrap().case().unwrap()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn section(case: &Case) -> Figure {
    let figures = Assessment::of(case).unwrap().figures(&View::default()).unwrap();
    let mut sections = figures.into_iter().filter(|figure| figure.drawn == Drawn::Section);
    let section = sections.next().unwrap();
    assert_eq!(section.suffix, "-section");
    section.figure
}

fn texts(figure: &Figure) -> Vec<String> {
    figure.labels().iter().map(|label| label.text.clone()).collect()
}

/// Goda's worked example: pressures as published (validation/goda.toml), levels by hand from the depths of the file.
#[test]
fn goda_s_pressures_and_levels_stand_in_the_section() {
    let figure = section(&case("goda-2000.toml", &example("goda-2000.toml")));
    let texts = texts(&figure);
    let number = |text: &str| text.split(' ').next().unwrap().parse::<f64>().ok();
    let pressures: Vec<f64> =
        texts.iter().filter(|text| text.ends_with(" kPa")).filter_map(|text| number(text)).collect();
    let published = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/goda.toml");
    let published = std::fs::read_to_string(published).unwrap();
    // The first case of the file is the worked example.
    let expected = |key: &str| {
        let line = published.lines().find_map(|line| line.strip_prefix(&format!("{key} = ")));
        line.unwrap().parse::<f64>().unwrap()
    };
    for key in ["p1", "p3", "p4", "pu"] {
        let found = pressures.iter().any(|shown| (shown / expected(key) - 1.0).abs() < 4e-4);
        assert!(found, "{key} {} in {pressures:?}", expected(key));
    }
    // 7.1 m to the base, 5.6 m to the berm, 10.1 m to the bed.
    for level in ["crest +10.5 m", "base ±0 m", "still water +7.1 m", "berm +1.5 m", "sea bed −3 m"] {
        assert!(texts.iter().any(|text| text == level), "{level} in {texts:?}");
    }
    assert!(texts.iter().any(|text| text == "15 m"));
}

/// Every pressure and force of every example, as the library has it.
#[test]
fn every_load_of_the_case_is_drawn_with_its_value() {
    let mut shown = 0;
    for name in ["quay", "trough", "monument", "head-difference", "eccentric-caisson", "block-two-loads"] {
        let case = case(name, &example(&format!("{name}.toml")));
        let figure = section(&case);
        let texts = texts(&figure);
        let mut has = |wanted: String| {
            assert!(texts.iter().any(|text| text.ends_with(&wanted)), "{name}: {wanted} in {texts:?}");
            shown += 1;
        };
        for pressure in &case.pressures {
            for at in pressure.diagram.points().iter().filter(|at| at.pressure != 0.0) {
                has(format!("{} kPa", digits(at.pressure / 1e3)).replace('-', "−"));
            }
            let name = pressure.name.as_ref().unwrap();
            let size = digits(pressure.diagram.resultant().0.abs() / 1e3);
            assert!(figure.caption().contains(&format!("{name}, {size} kN/m")), "{}", figure.caption());
        }
        for force in &case.forces {
            has(format!("{} kN/m", digits(force.magnitude / 1e3)));
            let place = match force.distance {
                Some(distance) => format!("{} m right of O", digits(distance)),
                None => format!("{} m above the base", digits(force.elevation)),
            };
            assert!(figure.caption().contains(&place), "{place} in {}", figure.caption());
        }
        has(format!("crest +{} m", digits(case.body.height())));
        if let Some(water) = &case.water {
            has(format!("water +{} m", digits(water.left())));
            has(format!("water +{} m", digits(water.right())));
            // The bottom of the base at O.
            let pressure = water.density() * case.gravity * water.left() / 1e3;
            has(format!("{} kPa", digits(pressure)));
        }
    }
    assert!(shown > 25, "{shown}");
}

#[test]
fn what_lies_off_the_middle_is_written_out() {
    let texts = texts(&section(&case("monument.toml", &example("monument.toml"))));
    for expected in ["O–C 0.4 m", "C–O′ 0.5 m", "base 0.9 m", "1.1 m", "C 1.7 m", "3.2 m"] {
        assert!(texts.iter().any(|text| text == expected), "{expected} in {texts:?}");
    }
}
