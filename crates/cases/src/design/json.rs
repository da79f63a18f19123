//! A design as one JSON document, at full precision. Units are SI. What is infinite is `null`.

use serde::Serialize;
use standfast::Mode;

use super::Design;
use super::outcome::Outcome;
use super::sensitivity::Sensitivity;
use crate::units::Quantity;

#[derive(Serialize)]
struct Document<'a> {
    title: Option<&'a str>,
    note: Option<&'a str>,
    vary: &'a str,
    unit: Option<&'static str>,
    target: String,
    bracket: [f64; 2],
    present: State,
    found: State,
    /// What fails just below the value found.
    binding: Option<&'a str>,
    /// Beyond this value the target fails again.
    holds_up_to: Option<f64>,
    notes: Vec<String>,
    sensitivity_per_percent: Vec<Change<'a>>,
}

#[derive(Serialize)]
struct State {
    value: f64,
    #[serde(rename = "SF_sliding")]
    sliding: f64,
    #[serde(rename = "SF_overturning")]
    overturning: f64,
    mode: Option<&'static str>,
    first_mode: Option<&'static str>,
    first_load_factor: f64,
}

#[derive(Serialize)]
struct Change<'a> {
    input: &'a str,
    value: f64,
    unit: Option<&'static str>,
    #[serde(rename = "SF_sliding")]
    sliding: Option<f64>,
    #[serde(rename = "SF_overturning")]
    overturning: Option<f64>,
    first_load_factor: Option<f64>,
}

pub(super) fn render(design: &Design) -> String {
    let Design { case, request, variable, bracket, present, found, sensitivities } = design;
    crate::json(&Document {
        title: case.title.as_deref(),
        note: case.note.as_deref(),
        vary: &variable.name,
        unit: variable.quantity.map(Quantity::si),
        target: request.target.to_string(),
        bracket: *bracket,
        present: State::of(variable.present, present),
        found: State::of(found.value, &found.outcome),
        binding: found.binding.as_deref(),
        holds_up_to: found.until.as_ref().map(|(value, _)| *value),
        notes: variable.notes(case),
        sensitivity_per_percent: sensitivities.iter().map(Change::of).collect(),
    })
}

impl State {
    fn of(value: f64, outcome: &Outcome) -> State {
        State {
            value,
            sliding: outcome.sliding(),
            overturning: outcome.overturning(),
            mode: outcome.mode().map(Mode::symbol),
            first_mode: outcome.first_mode().map(Mode::symbol),
            first_load_factor: outcome.first_load_factor(),
        }
    }
}

impl<'a> Change<'a> {
    fn of(sensitivity: &'a Sensitivity) -> Change<'a> {
        let Sensitivity { variable, sliding, overturning, first_load_factor } = sensitivity;
        Change {
            input: &variable.name,
            value: variable.present,
            unit: variable.quantity.map(Quantity::si),
            sliding: *sliding,
            overturning: *overturning,
            first_load_factor: *first_load_factor,
        }
    }
}
