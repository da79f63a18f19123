//! A case whose loads act together, for reading.

use std::fmt::Write;

use standfast::Mode;

use super::{Assessed, loads, sea, verdict};
use crate::assess::{heading, load_name};
use crate::case::Case;
use crate::describe;
use crate::layout::{columns, digits, paragraph, row};

/// What added mass leaves out.
const ADDED_MASS: &str = "Added mass counts against horizontal acceleration of the centre of mass; that it acts at \
    another height, and so couples sway and rotation, is left out.";

/// What an earthquake does to water, and is not counted where the added mass is given as such.
const SHAKEN_WATER: &str = "The pressure of the water on the shaken wall is not among the loads, because its height is \
    not given: give sides in [added_mass] in place of the mass, or add it as a [[load]].";

/// What added mass leaves out, in sentences; empty without it.
pub fn added_mass_notes(case: &Case) -> Vec<&'static str> {
    let mut notes = Vec::new();
    if case.added_mass.mass > 0.0 {
        notes.push(ADDED_MASS);
        if case.earthquake.is_some() && case.added_mass.height.is_none() {
            notes.push(SHAKEN_WATER);
        }
    }
    notes
}

pub(in crate::assess) fn render(case: &Case, all: &[Assessed]) -> String {
    let mut text = heading(case);
    text += "Body\n";
    text += &loads::body(case);
    text += &warnings(case.body_warnings());
    if let Some(wave) = &case.wave {
        text += &sea::render(case, wave);
    }
    let several = all.len() > 1;
    if several {
        text += "\nSummary\n";
        text += &summary(case, all);
    }
    for assessed in all {
        if let Some(load) = assessed.loaded.load.filter(|_| several) {
            let _ = write!(text, "\n{}\n\n", "─".repeat(88));
            text += &paragraph(&format!("With load {}: {}", load + 1, load_name(case, load)), 0);
        }
        text += &details(case, assessed);
    }
    text
}

/// Warnings, each a paragraph.
pub(super) fn warnings(warnings: impl Iterator<Item = String>) -> String {
    warnings.map(|warning| paragraph(&format!("Warning: {warning}."), 2)).collect()
}

/// One line for each alternative force.
fn summary(case: &Case, all: &[Assessed]) -> String {
    let mut rows = vec![
        row!["", "", "SF", "SF", "leaves rest", "", ""],
        row!["load", "mode", "slide", "turn", "at %", "into", "unique"],
    ];
    rows.extend(all.iter().map(|assessed| {
        let departure = assessed.departure();
        row![
            assessed.loaded.load.map(|load| load_name(case, load)).unwrap_or_default(),
            assessed.full.mode.map_or("none", Mode::symbol),
            digits(assessed.stability.sliding),
            digits(assessed.stability.least_overturning()),
            departure.map_or_else(|| beyond(assessed), |stage| digits(100.0 * stage.from)),
            departure.and_then(|stage| stage.mode).map_or("", Mode::symbol),
            if assessed.full.is_unique() { "yes" } else { "no" },
        ]
    }));
    columns(&rows, 2, &[2, 3, 4])
}

/// Where a body that does not leave rest on the path may leave it.
fn beyond(assessed: &Assessed) -> String {
    if assessed.path.is_empty() { "–".to_owned() } else { format!("> {}", digits(100.0 * assessed.up_to)) }
}

fn details(case: &Case, assessed: &Assessed) -> String {
    let mut text = "\nForces and moments\n".to_owned();
    text += &loads::components(assessed);
    for note in added_mass_notes(case) {
        text += &paragraph(note, 2);
    }
    text += "\nActions\n";
    text += &loads::classical(assessed);

    text += "\nVerdict\n";
    for sentence in assessed.full_load_words() {
        text += &paragraph(&sentence, 2);
    }
    match &assessed.full.effective {
        Some(reduced) => {
            text += "\nIn the report's diagram, with effective coordinates\n";
            let point = &reduced.point;
            let rows = [
                row!["k_eff", "|X|/P", digits(point.k())],
                row!["k'_eff", "−M/(X H)", digits(point.k_prime())],
                row!["μ", "", digits(point.mu())],
            ];
            text += &columns(&rows, 2, &[]);
            if reduced.mirrored {
                text += &paragraph(describe::MIRRORED, 2);
            }
            text += "\nBecause\n";
            text += &describe::relations(point.explain().deciding(), 2);
        }
        None => {
            text += &paragraph(
                "The load is no point of the report's diagram, which needs a uniform body with one friction and no \
                 added mass, pressed on its base and pushed sideways; it is answered by the general contact problem.",
                2,
            );
        }
    }
    if let Some(motion) = &assessed.full.motion {
        text += "\nAt onset\n";
        text += &describe::motion_si(motion);
    }
    if assessed.path.is_empty() {
        text += "\nLoad path\n";
    } else {
        text += "\nLoad path: the variable loads rise by a factor, the permanent ones stay\n";
        text += &verdict::stages(assessed);
    }
    for sentence in assessed.path_words() {
        text += &paragraph(&sentence, 2);
    }
    text
}
