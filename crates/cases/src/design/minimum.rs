//! The least cost of several quantities, written: as text and as JSON.

use serde::Serialize;
use standfast::InputError;

use super::text::sentence;
use super::{Cost, DIGITS, Minimum, MinimumPoint, Neighbour, with_unit};
use crate::assess::{note, title};
use crate::case::Case;
use crate::document::{AnswerFigure, Document};
use crate::json::SCHEMA;
use crate::layout::{columns, paragraph, row, significant};
use crate::summary::{Summary, listed, warned_of_case};
use crate::units::{Dimension, Extent};

/// Significant digits of a cost, enough to tell neighbours apart.
const COST_DIGITS: usize = 6;

/// A cost as it is read.
fn cost_words(cost: Cost, case: &Case, value: f64) -> String {
    let (value, unit) = match (cost, case.extent) {
        (Cost::Volume, Extent::PerMetre) => (value, "m³/m"),
        (Cost::Volume, Extent::Whole) => (value, "m³"),
        (Cost::Mass, extent) => {
            let mass = extent.of(Dimension::Mass);
            (mass.shown_on_paper().of_si(value), mass.on_paper().0)
        }
    };
    format!("{} {unit}", significant(value, COST_DIGITS))
}

/// JSON as `docs/minimum.schema.json` has it.
impl Document for Minimum {
    type View = ();

    fn summary(&self) -> Option<Summary> {
        let Minimum { request, present, found, .. } = self;
        let meets = request.target.is_met(present);
        let (warnings, warned) = warned_of_case(&self.answer().case.warnings());
        let (name, wanted) = (request.cost.name(), request.target.words());
        let now = cost_words(request.cost, &present.case, request.cost.of(&present.case));
        let values = self.quantities.iter().zip(self.values());
        let values: Vec<_> =
            values.map(|(quantity, value)| format!("{} {value}", quantity.variable.name())).collect();
        Some(Summary {
            criteria: Some(match meets {
                true => format!("The present values, of {now}, meet the target."),
                false => format!("The present values, of {now}, do not meet the target."),
            }),
            answer: format!(
                "The least {name} for which {wanted} is {}, with {}.",
                cost_words(request.cost, &present.case, found.cost),
                listed(&values)
            ),
            met: Some(meets),
            governing: None,
            near: found
                .end
                .beyond
                .brief()
                .map(|words| format!("Just beyond, with {} {words}.", self.quantities[0].variable.name())),
            warnings,
            warned,
        })
    }

    fn text(&self, (): &()) -> String {
        let Minimum { request, present, found, quantities, .. } = self;
        let mut text = title(&present.case);
        text += &self.summary().map_or(String::new(), |summary| summary.text());
        text += "\n";
        text += &note(&present.case);
        text += &format!("Least {}\n", request.cost.name());
        let mut rows = vec![row!["", "at present", "found", "searched"]];
        rows.extend(quantities.iter().zip(self.values()).map(|(quantity, value)| {
            row![quantity.variable.name(), quantity.shown(quantity.present), value, quantity.range_words()]
        }));
        let cost = |value: f64| cost_words(request.cost, &present.case, value);
        rows.push(row![request.cost.name(), cost(request.cost.of(&present.case)), cost(found.cost)]);
        text += &columns(&rows, 2, &[1, 2]);
        for place in self.at_ends() {
            let name = quantities[place].variable.name();
            let words = format!(
                "Warning: {name} is found at an end of its range; beyond it the {} may be less.",
                request.cost.name()
            );
            text += &paragraph(&words, 2);
        }
        if let Some(words) = found.end.beyond.words() {
            text += &paragraph(&sentence(words), 2);
        }
        if !self.neighbours.is_empty() {
            text += "\nNeighbours, a digit away, none of which costs less\n";
            text += &neighbours(self);
        }
        for note in self.notes() {
            text += &paragraph(&note, 2);
        }
        text
    }

    fn json(&self, (): &(), _: &[String]) -> String {
        let Minimum { request, present, found, quantities, neighbours, .. } = self;
        let values = std::iter::once(found.end.rounded).chain(found.held.iter().copied());
        let entries = quantities.iter().zip(values).zip(self.values()).map(|((quantity, value), printed)| {
            QuantityEntry {
                vary: quantity.variable.name(),
                unit: quantity.variable.dimension().map(Dimension::si),
                bracket: quantity.range,
                present: quantity.present,
                value,
                printed,
            }
        });
        crate::json::written(&MinimumDocument {
            schema: SCHEMA,
            title: present.case.title.as_deref(),
            note: present.case.note.as_deref(),
            summary: self.summary(),
            minimise: request.cost.name(),
            target: request.target.to_string(),
            present: request.cost.of(&present.case),
            cost: found.cost,
            quantities: entries.collect(),
            binding: found.end.beyond.words(),
            neighbours: neighbours.iter().map(NeighbourEntry::of).collect(),
            notes: self.notes(),
        })
    }

    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(Vec::new())
    }
}

/// The neighbours of the point found, in columns.
fn neighbours(minimum: &Minimum) -> String {
    let others = &minimum.quantities[1..];
    let mut head: Vec<String> = others.iter().map(|other| other.variable.name().to_owned()).collect();
    head.extend([minimum.quantities[0].variable.name().to_owned(), minimum.request.cost.name().to_owned()]);
    let mut rows = vec![head];
    let MinimumPoint { held, end, cost } = &minimum.found;
    let written = |held: &[f64], first: &str, cost: String| {
        let held = others.iter().zip(held).map(|(other, value)| with_unit(*value, &other.variable, DIGITS));
        held.chain([first.to_owned(), cost]).collect::<Vec<_>>()
    };
    let cost_of = |cost: f64| cost_words(minimum.request.cost, &minimum.present.case, cost);
    let mut found = written(held, &end.text, cost_of(*cost));
    found.push("found".to_owned());
    rows.push(found);
    for Neighbour { held, first } in &minimum.neighbours {
        rows.push(match first {
            Some((first, cost)) => written(held, first, cost_of(*cost)),
            None => written(held, "none meets it", String::new()),
        });
    }
    let numbers: Vec<usize> = (0..=others.len() + 1).collect();
    columns(&rows, 2, &numbers)
}

#[derive(Serialize)]
struct MinimumDocument<'a> {
    schema: u32,
    title: Option<&'a str>,
    note: Option<&'a str>,
    summary: Option<Summary>,
    minimise: &'static str,
    target: String,
    present: f64,
    cost: f64,
    quantities: Vec<QuantityEntry<'a>>,
    binding: Option<String>,
    neighbours: Vec<NeighbourEntry>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct QuantityEntry<'a> {
    vary: &'a str,
    unit: Option<&'static str>,
    bracket: [f64; 2],
    present: f64,
    value: f64,
    printed: String,
}

#[derive(Serialize)]
struct NeighbourEntry {
    held: Vec<f64>,
    first: Option<String>,
    cost: Option<f64>,
}

impl NeighbourEntry {
    fn of(Neighbour { held, first }: &Neighbour) -> NeighbourEntry {
        let (first, cost) = first.clone().unzip();
        NeighbourEntry { held: held.clone(), first, cost }
    }
}
