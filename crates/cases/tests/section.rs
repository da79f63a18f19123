//! The section of a case shows the numbers of the case.

use std::path::Path;

use standfast::Verdict;
use standfast_cases::layout::digits;
use standfast_cases::{Assessment, AssessmentView, Case, CaseFile, Document};
use standfast_figures::Figure;

fn case(name: &str, text: &str) -> Case {
    CaseFile::parse(name, text).unwrap().case().unwrap()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn section(case: &Case) -> Figure {
    let figures = Assessment::of(case).unwrap().figures(&AssessmentView::default()).unwrap();
    let mut sections = figures.into_iter().filter(|figure| figure.is_section());
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

/// The reaction lies under the base where equilibrium has it: 8 m × 6 m × 2 t/m³ under a force at half its height, at e = X d/P from the middle, on the
/// side that the force pushes to; the effective width reaches the edge there.
#[test]
fn the_reaction_lies_where_equilibrium_has_it() {
    let drawn = |angle: u32, weight: f64, share: f64, towards: &str| {
        let force = share * 8.0 * 6.0 * 2e3 * 10.0;
        let text = format!(
            "gravity = 10\n[body]\nwidth = 8\nheight = 6\ndensity = 2e3\nfriction = 0.9\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = {weight}\n\
             [[load]]\nforce = {force}\nelevation = 3\ndirection = \"{towards}\"\n"
        );
        let case = case("block.toml", &text);
        let fails = Assessment::of(&case).unwrap().governing().verdict() == Some(Verdict::BearingFailure);
        let figure = section(&case);
        let at = |text: &str| {
            let label = figure.labels().iter().find(|label| label.text == text);
            let rect = label.unwrap_or_else(|| panic!("{text} in {:?}", texts(&figure))).rect;
            (rect.x0 + rect.x1) / 2.0
        };
        // e = 3 m × share; the numbers of both lengths stand in their middle.
        let wide = 8.0 - 6.0 * share;
        (at("960 kN/m") - at("8 m"), at(&format!("B′ {} m", digits(wide))) - at("8 m"), fails)
    };
    // Ground that bears the body, and ground that fails under it.
    for (angle, weight) in [(45, 2e4), (20, 1e3)] {
        let (near, width, fails) = drawn(angle, weight, 0.1, "left");
        assert_eq!(fails, angle == 20);
        let (far, _, _) = drawn(angle, weight, 0.2, "left");
        assert!(near < 0.0 && (near - width).abs() < 1.0, "{near} {width}");
        assert!((far / near - 2.0).abs() < 0.05, "{far} {near}");
        let (other, _, _) = drawn(angle, weight, 0.2, "right");
        assert!((other + far).abs() < 1.0, "{other} {far}");
    }
}
