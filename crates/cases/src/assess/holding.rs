//! What holds a body beside friction, for reading and for programs.

use serde::Serialize;
use standfast::{Held, Mode};

use super::Assessed;
use crate::case::{Case, Direction, Resistance};
use crate::layout::{columns, paragraph, row};
use standfast_inputs::OutputUnits;

/// What holds a body of a situation beside friction: the resistances, each with its place, and the whole.
pub fn told<'a>(case: &'a Case, assessed: &Assessed) -> Option<(&'a [Resistance], Held)> {
    let held = assessed.outcome.held?;
    Some((&case.under(assessed.acting).resistances, held))
}

/// The formula of the factor against sliding.
pub(super) fn sliding_formula(assessed: &Assessed) -> &'static str {
    match assessed.outcome.held {
        Some(Held { adhesion, against, .. }) => match (adhesion > 0.0, against > 0.0) {
            (true, true) => "(μ(W' − U) + c_a A' + R)/P",
            (true, false) => "(μ(W' − U) + c_a A')/P",
            (false, true) => "(μ(W' − U) + R)/P",
            (false, false) => "μ(W' − U)/P",
        },
        None => "μ(W' − U)/P",
    }
}

/// True if resistances hold the body about its heel, and about its toe.
pub fn hold_about(assessed: &Assessed) -> [bool; 2] {
    assessed.outcome.held.map_or([false; 2], |held| held.moments.map(|moment| moment > 0.0))
}

/// Where a resistance holds the body to, and where it acts.
pub fn place(resistance: &Resistance, output: OutputUnits) -> String {
    match (resistance.direction, resistance.distance) {
        (Direction::Sideways(_), _) | (_, None) => {
            let side = resistance.direction.word();
            format!("to the {side} at {}", output.length(resistance.elevation))
        }
        (_, Some(distance)) => format!("down at {} from O", output.length(distance)),
    }
}

pub(super) fn render(case: &Case, assessed: &Assessed) -> String {
    let Some((resistances, held)) = told(case, assessed) else { return String::new() };
    let output = assessed.output;
    let mut rows = Vec::new();
    if case.under(assessed.acting).adhesion.is_some() {
        let words = format!("over A' = {} of the base", output.length(held.adhering));
        rows.push(row!["adhesion c_a A'", output.force(held.adhesion), words]);
    }
    for (index, resistance) in resistances.iter().enumerate() {
        let used = match held.needed {
            Some(needed) if needed[index] > 0.0 => format!("rest needs {}", output.force(needed[index])),
            Some(_) => "rest does not need it".to_owned(),
            None => "not enough for rest".to_owned(),
        };
        let words = format!("{}; {used}", place(resistance, output));
        rows.push(row![
            resistance.name.clone(),
            format!("R = {}", output.force(resistance.counted())),
            words
        ]);
    }
    let mut text = "\nHeld beside friction\n".to_owned() + &columns(&rows, 2, &[]);
    if !resistances.is_empty() {
        let counts = "A resistance counts in full in the factors: against sliding where it acts against the push, against overturning where it \
                      holds the corner. The pressure on the base is that with as much of it as brings the resultant nearest to the middle. The \
                      reactions at rest are those with the least that rest needs.";
        text += &paragraph(counts, 2);
    }
    if assessed.outcome.full.modes.contains(Mode::Rest)
        && !assessed.outcome.full.is_unique()
        && held.adhesion > 0.0
    {
        text += &paragraph(
            "Adhesion is lost with the first slip: from rest the body rests, and what slips already goes on.",
            2,
        );
    }
    text
}

/// A force with a limit as a program reads it.
#[derive(Debug, Clone, Serialize)]
pub struct ResistanceEntry {
    name: String,
    limit: f64,
    needed: Option<f64>,
    used: f64,
}

/// Adhesion as a program reads it.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct AdhesionEntry {
    length: f64,
    force: f64,
}

impl ResistanceEntry {
    pub(super) fn all(case: &Case, assessed: &Assessed) -> Vec<ResistanceEntry> {
        let Some((resistances, held)) = told(case, assessed) else { return Vec::new() };
        let each = resistances.iter().enumerate().map(|(index, resistance)| ResistanceEntry {
            name: resistance.name.clone(),
            limit: resistance.counted(),
            needed: held.needed.map(|needed| needed[index]),
            used: held.used[index],
        });
        each.collect()
    }
}

impl AdhesionEntry {
    pub(super) fn of(case: &Case, assessed: &Assessed) -> Option<AdhesionEntry> {
        let (_, held) = told(case, assessed)?;
        case.under(assessed.acting).adhesion?;
        Some(AdhesionEntry { length: held.adhering, force: held.adhesion })
    }
}
