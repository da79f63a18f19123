//! JSON documents.

use serde::{Serialize, Serializer};
use standfast::Modes;
use standfast_answers::results::ResultValue;
pub(crate) use standfast_answers::results::number_or_word;
use standfast_model::Bound;

use crate::assess::{AnyCheck, CaseCheck};
use crate::motion::{MotionCheck, MotionValue};

/// The version of the documents.
pub(crate) const SCHEMA: u32 = 1;

/// A document as text, ended by a newline.
pub(crate) fn written(document: &impl Serialize) -> String {
    // Plain structs with string keys always serialise.
    serde_json::to_string_pretty(document).map_or_else(|error| error.to_string(), |json| json + "\n")
}

/// A number, `infinite`, or null.
pub(crate) fn optional_number_or_word<S: Serializer>(
    number: &Option<f64>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match number {
        Some(number) => number_or_word(number, serializer),
        None => serializer.serialize_none(),
    }
}

/// Bound of a criterion: a number in SI units, the modes that are not allowed, or `false` of what must not happen.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum RequiredBound {
    /// A number.
    Number(f64),
    /// Modes.
    Modes(Modes),
    /// True or false.
    Truth(bool),
}

/// A criterion in a document: its bound, its value and what is used of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct CheckEntry {
    pub name: &'static str,
    pub required: RequiredBound,
    pub value: ResultValue,
    /// Null for modes, which use no share of anything.
    #[serde(serialize_with = "optional_number_or_word")]
    pub utilisation: Option<f64>,
    pub met: bool,
    /// The joint that it is met worst at, from the base, which is 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<usize>,
}

impl CheckEntry {
    pub(crate) fn of(check: &AnyCheck<'_>) -> CheckEntry {
        match check {
            AnyCheck::Instant(CaseCheck { check, .. }) => CheckEntry {
                name: check.criterion.name(),
                required: match check.criterion.bound {
                    Bound::AtLeast(number) | Bound::AtMost(number) => RequiredBound::Number(number),
                    Bound::NoneOf(modes) => RequiredBound::Modes(modes),
                },
                value: check.value,
                utilisation: check.utilisation,
                met: check.met,
                joint: check.joint.map(|joint| joint + 1),
            },
            AnyCheck::Motion(check, _) => CheckEntry::of_motion(check),
        }
    }

    pub(crate) fn of_motion(check: &MotionCheck) -> CheckEntry {
        let MotionCheck { criterion, value, utilisation, met, .. } = *check;
        CheckEntry {
            name: criterion.name(),
            required: criterion.bound().map_or(RequiredBound::Truth(false), RequiredBound::Number),
            value: match value {
                MotionValue::Number(number) => ResultValue::Number(number),
                MotionValue::Truth(truth) => ResultValue::Truth(truth),
                MotionValue::None => ResultValue::Nothing,
            },
            utilisation,
            met,
            joint: None,
        }
    }
}
