//! The answer for reading.

use std::fmt::Write;

use standfast::{Mode, Slip};

use super::{Assessed, Assessment, GOVERNING, View, checks, coordinates, loads, sea, verdict};
use crate::case::Case;
use crate::describe::{self, Scale, kilonewtons};
use crate::layout::{columns, digits, paragraph, row};
use crate::warning::Warning;

pub(super) fn render(assessment: &Assessment, view: &View) -> String {
    let case = &assessment.case;
    let mut text = heading(case);
    text += "Body\n";
    text += &loads::body(case);
    text += &warnings(case, |warning| !warning.is_about_waves());
    if let Some(wave) = &case.wave {
        text += &sea::render(case, wave);
    }
    let several = assessment.all.len() > 1;
    if several {
        text += "\nSummary\n";
        text += &summary(assessment);
    }
    let shown = assessment.shown(view);
    if shown.len() < assessment.all.len() {
        text += "\n";
        let words = format!(
            "Of {} loads, the {GOVERNING} that leave rest first are shown one by one; --all shows every one.",
            assessment.all.len()
        );
        text += &paragraph(&words, 0);
    }
    for assessed in shown {
        text += "\n";
        if several {
            let _ = write!(text, "{}\n\n", "─".repeat(88));
        }
        text += &force(case, assessed, several);
        text += &details(case, assessed, view);
    }
    text
}

/// Title and note.
pub(crate) fn heading(case: &Case) -> String {
    let mut text = String::new();
    if let Some(title) = &case.title {
        text += &paragraph(title, 0);
        text += "\n";
    }
    if let Some(note) = &case.note {
        text += &paragraph(note, 2);
        text += "\n";
    }
    text
}

/// Warnings of a kind, each a paragraph.
pub(super) fn warnings(case: &Case, of: impl Fn(&Warning) -> bool) -> String {
    let warnings = case.warnings().into_iter().filter(|warning| of(warning));
    warnings.map(|warning| paragraph(&format!("Warning: {warning}."), 2)).collect()
}

/// One line for each alternative force.
fn summary(assessment: &Assessment) -> String {
    let case = &assessment.case;
    let mut rows = vec![
        row!["", "force", "at", "", "SF", "SF", "leaves", "", ""],
        row!["load", "kN/m", "m", "mode", "slide", "turn", "rest at", "into", "unique"],
    ];
    rows.extend(assessment.all.iter().filter_map(|assessed| {
        let index = assessed.force?;
        let outcome = &assessed.outcome;
        let force = &case.forces[index].force;
        Some(row![
            case.force_name(index),
            digits(force.magnitude() / 1e3),
            digits(force.elevation()),
            outcome.full.mode.map_or("none", Mode::symbol),
            if outcome.full.is_lifted() { "none".into() } else { digits(outcome.stability.sliding) },
            if outcome.full.is_lifted() { "none".into() } else { digits(outcome.stability.overturning()) },
            verdict::departure_word(&outcome.departure),
            outcome.departure.mode().map_or("", Mode::symbol),
            if outcome.full.is_unique() { "yes" } else { "no" },
        ])
    }));
    columns(&rows, 2, &[1, 2, 4, 5, 6])
}

/// The alternative force of a situation.
fn force(case: &Case, assessed: &Assessed, several: bool) -> String {
    let Some(index) = assessed.force else { return String::new() };
    let named = &case.forces[index];
    let title = match (&named.name, several) {
        (Some(name), true) => format!("Load {}: {name}", index + 1),
        (Some(name), false) => format!("Load: {name}"),
        (None, true) => format!("Load {}", index + 1),
        (None, false) => "Load".to_owned(),
    };
    let (arrow, towards) = match named.force.direction() {
        Slip::Left => ("←", "to the left"),
        Slip::Right => ("→", "to the right"),
    };
    let above = named.force.elevation() - case.body.centroid_height();
    let side = if above < 0.0 { "below" } else { "above" };
    let centre = format!("{} m {side} the centre of mass", digits(above.abs()));
    let rows = [
        row!["force F", format!("{} {arrow} {towards}", kilonewtons(named.force.magnitude()))],
        row!["elevation", format!("{} m above the base, {centre}", digits(named.force.elevation()))],
    ];
    paragraph(&title, 0) + &columns(&rows, 2, &[]) + "\n"
}

fn details(case: &Case, assessed: &Assessed, view: &View) -> String {
    let full = &assessed.outcome.full;
    let mut text = "Forces and moments\n".to_owned();
    text += &loads::components(case, assessed);
    for note in loads::added_mass_notes(case) {
        text += &paragraph(note, 2);
    }
    text += "\nActions\n";
    text += &checks::actions(assessed);
    text += "\nSafety factors and bearing pressure\n";
    text += &checks::factors(assessed);

    text += "\nVerdict\n";
    for sentence in verdict::full_load(assessed) {
        text += &paragraph(&sentence, 2);
    }
    text += match (full.effective.is_some(), assessed.situation.in_air().is_some()) {
        (true, false) => "\nIn the report's diagram, with effective coordinates\n",
        _ => "\nIn the report's diagram\n",
    };
    text += &coordinates::text(assessed);
    let because = assessed.because();
    if !because.is_empty() {
        text += "\nBecause\n";
        text += &describe::relations(&because, 2);
    }
    if let Some(motion) = &full.motion {
        text += "\nAt onset\n";
        text += &describe::real_motion(motion, &Scale::of(&case.body, case.gravity));
        if case.earthquake.is_some() {
            text += &paragraph(describe::RELATIVE, 2);
        }
    }
    text += &path(assessed, view);
    if let Some(reduced) = &full.effective {
        text += "\nChanges of mode as the friction grows, at this load\n";
        text += &describe::along_mu(reduced, 2);
    }
    text
}

fn path(assessed: &Assessed, view: &View) -> String {
    let mut text = if assessed.outcome.path.is_empty() {
        "\nLoad path\n".to_owned()
    } else {
        let title = "\nLoad path: the variable loads rise by a factor, the permanent ones stay\n";
        title.to_owned() + &verdict::stages(assessed, view)
    };
    for sentence in verdict::path(assessed) {
        text += &paragraph(&sentence, 2);
    }
    text
}
