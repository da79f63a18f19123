//! A design as one JSON document, at full precision. Units are SI; results stand under the names of the
//! [one list](crate::results).

use serde::Serialize;
use serde::ser::SerializeMap;

use super::search::Below;
use super::sensitivity::Sensitivity;
use super::{Design, load_factor};
use crate::assess::{Assessed, Assessment, SCHEMA};
use crate::results::{ResultName, ResultValue};
use crate::units::Dimension;

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    note: Option<&'a str>,
    vary: &'a str,
    unit: Option<&'static str>,
    target: String,
    bracket: [f64; 2],
    present: State<'a>,
    found: State<'a>,
    /// What fails just below the value found.
    binding: Option<&'a str>,
    /// What the value found brings about that the present one does not.
    warnings: Vec<String>,
    /// Beyond this value the target fails again.
    holds_up_to: Option<f64>,
    notes: Vec<String>,
    sensitivity_per_percent: Vec<Row<'a>>,
}

/// A value and what it comes to: of each result, that of the situation in which it is worst.
#[derive(Serialize)]
struct State<'a> {
    value: f64,
    #[serde(flatten)]
    results: Worst<'a>,
}

struct Worst<'a>(&'a Assessment);

impl Serialize for Worst<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // That which leaves rest first.
        let first = self.0.least(load_factor);
        let mut map = serializer.serialize_map(None)?;
        for result in [ResultName::SfSliding, ResultName::SfOverturning] {
            map.serialize_entry(result.name(), &least(self.0, result))?;
        }
        for result in
            [ResultName::Mode, ResultName::Departure, ResultName::LoadFactor, ResultName::DepartureMode]
        {
            map.serialize_entry(result.name(), &result.of(first))?;
        }
        map.end()
    }
}

/// The least of a result over all situations; nothing if one of them has no such thing.
fn least(assessment: &Assessment, result: ResultName) -> ResultValue {
    let of = |assessed: &Assessed| match result.of(assessed) {
        ResultValue::Number(number) => number,
        _ => f64::NEG_INFINITY,
    };
    result.of(assessment.least(of))
}

#[derive(Serialize)]
struct Row<'a> {
    input: &'a str,
    value: f64,
    unit: Option<&'static str>,
    #[serde(rename = "SF_sliding")]
    sliding: Option<f64>,
    #[serde(rename = "SF_overturning")]
    overturning: Option<f64>,
    load_factor: Option<f64>,
}

pub(super) fn render(design: &Design<'_>) -> String {
    let Design { request, variable, value, bracket, present, found, sensitivities, .. } = design;
    crate::json(&Document {
        schema: SCHEMA,
        title: present.case.title.as_deref(),
        note: present.case.note.as_deref(),
        vary: variable.name(),
        unit: variable.dimension().map(Dimension::si),
        target: request.target.to_string(),
        bracket: *bracket,
        present: State { value: *value, results: Worst(present) },
        found: State { value: found.value, results: Worst(&found.answer) },
        binding: match &found.below {
            Below::End => None,
            Below::Fails(why) | Below::NoCase(why) => Some(why),
        },
        warnings: design.new_warnings().iter().map(ToString::to_string).collect(),
        holds_up_to: found.until.as_ref().map(|(value, _)| *value),
        notes: design.notes(),
        sensitivity_per_percent: sensitivities.iter().map(Row::of).collect(),
    })
}

impl<'a> Row<'a> {
    fn of(sensitivity: &'a Sensitivity) -> Row<'a> {
        let Sensitivity { variable, value, sliding, overturning, load_factor } = sensitivity;
        Row {
            input: variable.name(),
            value: *value,
            unit: variable.dimension().map(Dimension::si),
            sliding: sliding.number(),
            overturning: overturning.number(),
            load_factor: load_factor.number(),
        }
    }
}
