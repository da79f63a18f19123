//! A boundary as text, JSON and CSV.

use serde::Serialize;
use standfast::number::exact;

use super::DesignBoundary;
use crate::assess::heading;
use crate::design::json::MetRange;
use crate::design::{Column, End, Extreme, Quantity};
use crate::json::SCHEMA;
use crate::layout::{columns, paragraph, plain, row};
use crate::units::Dimension;

pub(super) fn text(boundary: &DesignBoundary) -> String {
    let DesignBoundary { request, up, across, present, .. } = boundary;
    let [name, other] = [up, across].map(|quantity| quantity.variable.name());
    let [range, other_range] = [up, across].map(Quantity::range_words);
    let mut text = heading(&present.case);
    text += "Design\n";
    text += &paragraph(
        &format!(
            "The {} {name} {range}, for {other} {other_range}, for which {}.",
            request.extreme,
            request.target.words()
        ),
        2,
    );
    text += &paragraph(&format!("At present, {}.", at_present(boundary)), 2);
    text += "\n";
    text += &table(boundary);
    if let Some(sentence) = gaps(boundary) {
        text += &paragraph(&sentence, 2);
    }
    for note in boundary.notes() {
        text += &paragraph(&note, 2);
    }
    text
}

/// The present values and whether they meet the target.
pub(super) fn at_present(boundary: &DesignBoundary) -> String {
    let [up, across] = [&boundary.up, &boundary.across]
        .map(|one| format!("{} {}", one.variable.name(), one.shown(one.present)));
    let met = if boundary.request.target.is_met(&boundary.present) { "is met" } else { "is not met" };
    format!("with {up} and {across}, the target {met}")
}

/// The round columns: the end that is wanted, and what binds there.
fn table(boundary: &DesignBoundary) -> String {
    let DesignBoundary { request, up, across, .. } = boundary;
    let mut rows = vec![row![
        across.variable.name(),
        format!("{} {}", request.extreme, up.variable.name()),
        "binding",
        ""
    ]];
    let round = boundary.columns.iter().filter(|column| boundary.round.contains(&column.at));
    rows.extend(round.map(|column| {
        let present = if column.at == across.present { "present" } else { "" };
        let at = unit(across, &plain(column.at));
        match ordered(column, request.extreme).first() {
            Some((end, _)) => row![at, &*end.text, end.beyond.by().unwrap_or("end of the range"), present],
            None => row![at, "none", column.none.unwrap_or("no case"), present],
        }
    }));
    columns(&rows, 2, &[0, 1])
}

/// Sentence on the columns of more than one stretch; `None` if there are none.
fn gaps(boundary: &DesignBoundary) -> Option<String> {
    let several = boundary.columns.iter().filter(|column| column.stretches.len() > 1).count();
    (several > 0).then(|| {
        format!(
            "At {several} of {} values of {} the target is met, fails and is met again: the JSON and the CSV have all stretches.",
            boundary.columns.len(),
            boundary.across.variable.name()
        )
    })
}

fn unit(quantity: &Quantity, number: &str) -> String {
    match quantity.variable.dimension() {
        Some(dimension) => format!("{number} {}", dimension.si()),
        None => number.to_owned(),
    }
}

/// The stretches of a column as pairs of ends, the wanted one first.
fn ordered(column: &Column, extreme: Extreme) -> Vec<(&End, &End)> {
    match extreme {
        Extreme::Least => column.stretches.iter().map(|one| (&one.least, &one.greatest)).collect(),
        Extreme::Greatest => column.stretches.iter().rev().map(|one| (&one.greatest, &one.least)).collect(),
    }
}

/// A row for each stretch: the value of the one quantity, the wanted end of the other, the other end if it is more than an end of
/// the range, and what binds at each. A value without any
/// has a row of its own, with what binds where the target is nearest to be met.
pub fn csv(boundary: &DesignBoundary) -> String {
    let DesignBoundary { request, up, across, .. } = boundary;
    let [name, other] = [up, across].map(|quantity| quantity.variable.key_name());
    let mut text = format!("{other},{name},binding,until,until_binding\n");
    for column in &boundary.columns {
        let at = exact(column.at);
        let stretches = ordered(column, request.extreme);
        if stretches.is_empty() {
            text += &format!("{at},,{},,\n", column.none.unwrap_or_default());
        }
        for (wanted, until) in stretches {
            let by = |end: &End| end.beyond.by().unwrap_or_default();
            let beyond = until.beyond.by().map_or(String::new(), |_| exact(until.rounded));
            text += &format!("{at},{},{},{beyond},{}\n", exact(wanted.rounded), by(wanted), by(until));
        }
    }
    text
}

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    note: Option<&'a str>,
    target: String,
    wanted: String,
    vary: Varied<'a>,
    and: Varied<'a>,
    present_meets: bool,
    columns: Vec<Values>,
    notes: Vec<String>,
}

/// A quantity and its range.
#[derive(Serialize)]
struct Varied<'a> {
    name: &'a str,
    unit: Option<&'static str>,
    present: f64,
    bracket: [f64; 2],
}

/// Values that meet the target at a value of the quantity `and`.
#[derive(Serialize)]
struct Values {
    value: f64,
    met: Vec<MetRange>,
    /// Failure that binds, in a word, where it is nearest to be met, if it is nowhere.
    binds: Option<&'static str>,
}

pub(super) fn json(boundary: &DesignBoundary) -> String {
    let DesignBoundary { request, up, across, present, .. } = boundary;
    let [vary, and] = [up, across].map(|quantity| Varied {
        name: quantity.variable.name(),
        unit: quantity.variable.dimension().map(Dimension::si),
        present: quantity.present,
        bracket: quantity.range,
    });
    crate::json::written(&Document {
        schema: SCHEMA,
        title: present.case.title.as_deref(),
        note: present.case.note.as_deref(),
        target: request.target.to_string(),
        wanted: request.extreme.to_string(),
        vary,
        and,
        present_meets: request.target.is_met(present),
        columns: boundary
            .columns
            .iter()
            .map(|column| Values {
                value: column.at,
                met: column.stretches.iter().map(MetRange::of).collect(),
                binds: column.none,
            })
            .collect(),
        notes: boundary.notes(),
    })
}
