//! A case's answer for reading.

use std::fmt::Write;

use standfast::Slip;

use crate::assess::{heading, load_name};
use crate::case::{Case, Load};
use crate::describe::{self, Scale, kilonewtons};
use crate::layout::{columns, digits, paragraph, row};

pub(super) fn render(case: &Case) -> String {
    let scale = Scale::of(&case.body, case.gravity);
    let mut text = heading(case);
    text += "Body\n";
    text += &body(case, &scale);
    if case.loads.len() > 1 {
        text += "\nSummary\n";
        text += &summary(case, &scale);
    }
    for (i, load) in case.loads.iter().enumerate() {
        let several = case.loads.len() > 1;
        let title = match &load.name {
            Some(name) if several => format!("Load {}: {name}", i + 1),
            Some(name) => format!("Load: {name}"),
            None if several => format!("Load {}", i + 1),
            None => "Load".to_owned(),
        };
        if several {
            let _ = write!(text, "\n{}\n", "─".repeat(88));
        }
        text += "\n";
        text += &paragraph(&title, 0);
        text += &details(case, load, &scale);
    }
    text
}

fn body(case: &Case, scale: &Scale) -> String {
    let rows = [
        row!["width 2B", format!("{} m", digits(case.body.width()))],
        row!["height 2H", format!("{} m", digits(case.body.height()))],
        row!["mass m", format!("{} t/m", digits(case.body.mass() / 1e3))],
        row!["weight m g", format!("{} (g = {} m/s²)", kilonewtons(scale.weight), digits(case.gravity))],
        row!["slenderness γ = H/B", digits(case.body.slenderness())],
        row!["friction μ", digits(case.friction)],
    ];
    columns(&rows, 2, &[])
}

/// One line a load.
fn summary(case: &Case, scale: &Scale) -> String {
    let mut rows = vec![
        row!["", "force", "at", "", "", "", "SF", "SF", "leaves rest", ""],
        row!["load", "kN/m", "m", "k", "k'", "mode", "slide", "turn", "at kN/m", "unique"],
    ];
    rows.extend(case.loads.iter().enumerate().map(|(i, load)| {
        let point = &load.reduced.point;
        let leaves_rest = point.margins().leaves_rest().map(|crossing| crossing.at * scale.weight / 1e3);
        row![
            load_name(case, i),
            digits(load.force.magnitude() / 1e3),
            digits(load.force.elevation()),
            digits(point.k()),
            digits(point.k_prime()),
            load.reduced.mode().symbol(),
            digits(point.safety_against_sliding()),
            digits(point.safety_against_overturning()),
            leaves_rest.map_or("never".to_owned(), digits),
            if point.is_unique() { "yes" } else { "no" },
        ]
    }));
    columns(&rows, 2, &[1, 2, 3, 4, 6, 7, 8])
}

fn details(case: &Case, load: &Load, scale: &Scale) -> String {
    let point = &load.reduced.point;
    let (arrow, towards) = match load.force.direction() {
        Slip::Left => ("←", "to the left"),
        Slip::Right => ("→", "to the right"),
    };
    let above = load.force.elevation() - case.body.height() / 2.0;
    let side = if above < 0.0 { "below" } else { "above" };
    let rows = [
        row!["force F", format!("{} {arrow} {towards}", kilonewtons(load.force.magnitude()))],
        row!["elevation", format!("{} m above the base", digits(load.force.elevation()))],
        row!["k", format!("{} (of the weight)", digits(point.k()))],
        row![
            "k'",
            format!("{} ({} m {side} the centre of mass)", digits(point.k_prime()), digits(above.abs()))
        ],
    ];
    let mut text = columns(&rows, 2, &[]);
    if load.reduced.mirrored {
        text += "\n";
        text += &paragraph(describe::MIRRORED, 2);
    }

    text += "\nVerdict\n";
    text += &paragraph(&describe::verdict(&load.reduced), 2);
    text += &paragraph(&describe::uniqueness(&load.reduced), 2);
    text += "\nBecause\n";
    text += &describe::relations(point.explain().deciding(), 2);
    text += "\nSafety factors\n";
    text += &describe::safety_factors(&load.reduced);
    text += "\nAt onset\n";
    text += &describe::motion(&load.reduced, Some(scale));
    text += "\nChanges of mode\n";
    text += &describe::changes(&load.reduced, Some(scale));
    text
}
