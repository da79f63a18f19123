//! A design as one JSON document, at full precision. Units are SI; results stand under the names of the
//! [one list](crate::results).

use serde::Serialize;
use serde::ser::SerializeMap;

use super::{
    Design, End, Sensitivity, SensitivityChange, Stretch, farthest, load_factor, overturns, steepest,
};
use crate::assess::{Assessed, Assessment};
use crate::json::SCHEMA;
use crate::results::{ResultName, ResultValue};
use crate::summary::Summary;
use crate::units::Dimension;

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    note: Option<&'a str>,
    summary: Summary,
    vary: &'a str,
    unit: Option<&'static str>,
    target: String,
    wanted: String,
    bracket: [f64; 2],
    present: Present<'a>,
    found: FoundValue<'a>,
    /// Failure just beyond the value found.
    binding: Option<String>,
    /// Warnings on the value found.
    warnings: Vec<String>,
    /// All values that meet the target.
    met: Vec<MetRange>,
    notes: Vec<String>,
    sensitivity_per_percent: Vec<Row<'a>>,
}

/// The present value and what it comes to.
#[derive(Serialize)]
struct Present<'a> {
    value: f64,
    #[serde(flatten)]
    results: Worst<'a>,
}

/// The value found as it is printed, on the safe side of the boundary, and what it comes to.
#[derive(Serialize)]
struct FoundValue<'a> {
    value: f64,
    boundary: f64,
    printed: &'a str,
    #[serde(flatten)]
    results: Worst<'a>,
}

/// Neighbouring values that meet the target.
#[derive(Serialize)]
pub(super) struct MetRange {
    from: Bound,
    to: Bound,
}

/// An end of them.
#[derive(Serialize)]
struct Bound {
    value: f64,
    boundary: f64,
    binds: Option<&'static str>,
    binding: Option<String>,
}

impl MetRange {
    pub(super) fn of(stretch: &Stretch) -> MetRange {
        MetRange { from: Bound::of(&stretch.least), to: Bound::of(&stretch.greatest) }
    }
}

impl Bound {
    fn of(end: &End) -> Bound {
        Bound { value: end.rounded, boundary: end.value, binds: end.beyond.by(), binding: end.beyond.words() }
    }
}

/// Results at a value: of each, that of the situation in which it is worst.
struct Worst<'a>(&'a Assessment);

impl Serialize for Worst<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // That which leaves rest first.
        let first = self.0.least(load_factor);
        let mut map = serializer.serialize_map(None)?;
        for (result, sign) in WORST {
            map.serialize_entry(result.name(), &worst(self.0, result, sign))?;
        }
        for result in
            [ResultName::Mode, ResultName::Departure, ResultName::LoadFactor, ResultName::DepartureMode]
        {
            map.serialize_entry(result.name(), &result.of(first))?;
        }
        map.serialize_entry("slide", &farthest(self.0))?;
        map.serialize_entry("max_theta", &steepest(self.0))?;
        map.serialize_entry("overturned", &overturns(self.0))?;
        map.end()
    }
}

/// Results that are worst where they are least, 1, or greatest, −1.
const WORST: [(ResultName, f64); 5] = [
    (ResultName::SfSliding, 1.0),
    (ResultName::SfOverturningNet, 1.0),
    (ResultName::BearingMax, -1.0),
    (ResultName::ContactShare, 1.0),
    (ResultName::Eccentricity, -1.0),
];

/// A result where it is worst of all that was tried; nothing if there is no such thing somewhere.
fn worst(assessment: &Assessment, result: ResultName, sign: f64) -> ResultValue {
    let of = |assessed: &Assessed| match result.of(assessed) {
        ResultValue::Number(number) => sign * number,
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
    #[serde(rename = "SF_overturning_net")]
    overturning: Option<f64>,
    load_factor: Option<f64>,
    slide: Option<f64>,
    max_theta: Option<f64>,
}

pub(super) fn render(design: &Design) -> String {
    let Design { request, quantity, present, stretches, sensitivities, .. } = design;
    let found = design.found();
    crate::json::written(&Document {
        schema: SCHEMA,
        title: present.case.title.as_deref(),
        note: present.case.note.as_deref(),
        summary: super::summary::summary(design),
        vary: quantity.variable.name(),
        unit: quantity.variable.dimension().map(Dimension::si),
        target: request.target.to_string(),
        wanted: request.extreme.to_string(),
        bracket: quantity.range,
        present: Present { value: quantity.present, results: Worst(present) },
        found: FoundValue {
            value: found.rounded,
            boundary: found.value,
            printed: &found.text,
            results: Worst(&found.answer),
        },
        binding: found.beyond.words(),
        warnings: design.warnings(),
        met: stretches.iter().map(MetRange::of).collect(),
        notes: design.notes(),
        sensitivity_per_percent: sensitivities.iter().map(Row::of).collect(),
    })
}

impl<'a> Row<'a> {
    fn of(sensitivity: &'a Sensitivity) -> Row<'a> {
        let Sensitivity { variable, value, sliding, overturning, load_factor, motion } = sensitivity;
        let [slide, max_theta] = motion.map_or([None; 2], |motion| motion.map(SensitivityChange::number));
        Row {
            input: variable.name(),
            value: *value,
            unit: variable.dimension().map(Dimension::si),
            sliding: sliding.number(),
            overturning: overturning.number(),
            load_factor: load_factor.number(),
            slide,
            max_theta,
        }
    }
}
