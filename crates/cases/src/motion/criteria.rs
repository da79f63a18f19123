//! Criteria on a motion, and their checks: `slide`, `max_theta` and `overturned` under `[criteria]`.
//!
//! A bound is met by a motion that was followed to its end: of a body that still moves when the time is up nobody knows how far it gets.

use std::fmt;

use serde::{Serialize, Serializer};
use standfast_motion::{End, MotionOutcome};

use super::{BlockCase, FollowedMotion};
use crate::error::{Fault, Problem};
use crate::inputs::Inputs;
use crate::key::Key;
use crate::layout::{apart, digits, plain};

pub use standfast_inputs::key::MOTION_CRITERIA;

/// Criterion on a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionCriterion {
    /// The displacement along the base at the end is this at most, to either side.
    Slide(f64),
    /// |θ| is this at most, in radians.
    MaxTheta(f64),
    /// The body does not overturn.
    NotOverturned,
}

/// Value of a motion that a criterion is about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionValue {
    /// A length, or an angle in radians.
    Number(f64),
    /// True if it overturns.
    Truth(bool),
    /// There is none: the body has overturned, or was not followed to the end of its motion.
    None,
}

/// Check of a criterion against a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionCheck {
    /// The criterion.
    pub criterion: MotionCriterion,
    /// Value of the motion.
    pub value: MotionValue,
    /// Utilisation, value/required; infinite where there is no value that could meet it, `None` where nothing is measured.
    pub utilisation: Option<f64>,
    /// True if it is met.
    pub met: bool,
    /// End of the motion.
    pub end: End,
    /// True if quantities are in SI units.
    pub si: bool,
}

impl MotionCriterion {
    /// Its name: that of the result.
    pub fn name(self) -> &'static str {
        match self {
            MotionCriterion::Slide(_) => MOTION_CRITERIA[0],
            MotionCriterion::MaxTheta(_) => MOTION_CRITERIA[1],
            MotionCriterion::NotOverturned => MOTION_CRITERIA[2],
        }
    }

    /// The quantity that is asked for, in words.
    pub fn words(self) -> &'static str {
        match self {
            MotionCriterion::Slide(_) => "displacement along the base at the end, to either side",
            MotionCriterion::MaxTheta(_) => "largest angle to either side",
            MotionCriterion::NotOverturned => "whether the body overturns",
        }
    }

    /// Those that inputs ask for.
    ///
    /// # Errors
    /// If the body is asked to overturn.
    pub(crate) fn all(inputs: &Inputs) -> Result<Vec<MotionCriterion>, Fault> {
        let slide = inputs.number(Key::GreatestSlide).map(MotionCriterion::Slide);
        let theta = inputs.number(Key::GreatestTheta).map(MotionCriterion::MaxTheta);
        let stands = match inputs.truth(Key::NotOverturned) {
            Some(true) => return Err(Fault::new(Problem::AskedToOverturn, Key::NotOverturned)),
            asked => asked.map(|_| MotionCriterion::NotOverturned),
        };
        Ok([slide, theta, stands].into_iter().flatten().collect())
    }

    /// The bound, where it is a number.
    pub fn bound(self) -> Option<f64> {
        match self {
            MotionCriterion::Slide(bound) | MotionCriterion::MaxTheta(bound) => Some(bound),
            MotionCriterion::NotOverturned => None,
        }
    }

    fn unit(self, si: bool) -> &'static str {
        match self {
            MotionCriterion::Slide(_) if si => " m",
            MotionCriterion::MaxTheta(_) if si => " rad",
            _ => "",
        }
    }

    /// The bound as it is read: `≤ 0.1 m`.
    pub fn required(self, si: bool) -> String {
        match self.bound() {
            Some(bound) => format!("≤ {}{}", digits(bound), self.unit(si)),
            None => "no".to_owned(),
        }
    }

    /// Check of it against a motion.
    pub fn check(self, si: bool, outcome: &MotionOutcome) -> MotionCheck {
        let value = match self {
            MotionCriterion::Slide(_) if outcome.overturned() => MotionValue::None,
            MotionCriterion::Slide(_) => MotionValue::Number(outcome.slide.abs()),
            MotionCriterion::MaxTheta(_) => MotionValue::Number(outcome.max_theta),
            MotionCriterion::NotOverturned => MotionValue::Truth(outcome.overturned()),
        };
        let within = match (value, self.bound()) {
            (MotionValue::Number(value), Some(bound)) => value <= bound,
            (MotionValue::Truth(overturned), _) => !overturned,
            _ => false,
        };
        // What is beyond a bound already stays a number; what is not may get there yet.
        let followed = matches!(outcome.end, End::AtRest | End::Overturned);
        let value = if within && !followed { MotionValue::None } else { value };
        let utilisation = match (value, self.bound()) {
            (MotionValue::Number(value), Some(bound)) => Some(value / bound),
            (MotionValue::None, Some(_)) => Some(f64::INFINITY),
            _ => None,
        };
        MotionCheck { criterion: self, value, utilisation, met: within && followed, end: outcome.end, si }
    }
}

impl fmt::Display for MotionCriterion {
    /// As a target of a case with a body is written: `slide=0.1 m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.bound() {
            Some(bound) => write!(f, "{}={}{}", self.name(), plain(bound), self.unit(true)),
            None => write!(f, "{}=false", self.name()),
        }
    }
}

impl MotionCheck {
    /// The value as it is read, with as many digits as tell it from the bound.
    pub fn value_words(&self) -> String {
        match (self.value, self.criterion.bound()) {
            (MotionValue::Number(value), Some(bound)) => {
                let text = if value == bound { digits(value) } else { apart(&[value, bound])[0].clone() };
                text + self.criterion.unit(self.si)
            }
            (MotionValue::Number(value), None) => digits(value),
            (MotionValue::Truth(true), _) => "yes".to_owned(),
            (MotionValue::Truth(false), _) => "no".to_owned(),
            (MotionValue::None, _) if self.end == End::Overturned => "none: the body overturns".to_owned(),
            (MotionValue::None, _) => "not known: the motion is not followed to its end".to_owned(),
        }
    }

    /// The utilisation as it is read.
    pub fn utilisation_words(&self) -> String {
        match self.utilisation {
            Some(f64::INFINITY) => "infinite".to_owned(),
            // A number that rounds to 1 is not to be read as met when it is not.
            Some(utilisation) if utilisation != 1.0 => apart(&[utilisation, 1.0])[0].clone(),
            Some(utilisation) => digits(utilisation),
            None => "–".to_owned(),
        }
    }

    /// "met" or "not met".
    pub fn met_words(&self) -> &'static str {
        if self.met { "met" } else { "not met" }
    }

    /// Reason why it is not met: `slide is 0.1004 m, not ≤ 0.1 m`.
    pub fn failure(&self) -> String {
        let name = self.criterion.name();
        match (self.value, self.end) {
            (MotionValue::Number(_), _) => {
                format!("{name} is {}, not {}", self.value_words(), self.criterion.required(self.si))
            }
            (_, End::Overturned) => "the body overturns".to_owned(),
            _ => format!("{name} is not known: the motion is not followed to its end"),
        }
    }

    /// Urgency of the check: its utilisation, 1 at least of one that is not met, infinite where nothing is measured.
    pub(crate) fn urgency(&self) -> f64 {
        match (self.utilisation, self.met) {
            (Some(utilisation), true) => utilisation,
            (Some(utilisation), false) => utilisation.max(1.0),
            (None, true) => 0.0,
            (None, false) => f64::INFINITY,
        }
    }
}

impl BlockCase {
    /// The criteria of the case, the governing one first.
    pub fn checks(&self, outcome: &MotionOutcome) -> Vec<MotionCheck> {
        self.checks_of(&self.criteria, outcome)
    }

    /// Checks of other criteria than those of the case, the governing one first.
    pub(crate) fn checks_of(
        &self,
        criteria: &[MotionCriterion],
        outcome: &MotionOutcome,
    ) -> Vec<MotionCheck> {
        let mut checks: Vec<_> = criteria.iter().map(|criterion| criterion.check(self.si, outcome)).collect();
        checks.sort_by(|one, two| two.urgency().total_cmp(&one.urgency()));
        checks
    }

    /// True if all criteria are met; `None` where there is none.
    pub fn met(&self, outcome: &MotionOutcome) -> Option<bool> {
        (!self.criteria.is_empty()).then(|| self.checks(outcome).iter().all(|check| check.met))
    }
}

/// Each criterion in the situation that meets it worst, with the place of that; the governing one first.
pub(crate) fn worst_checks(
    criteria: &[MotionCriterion],
    answers: &[(BlockCase, FollowedMotion)],
) -> Vec<(MotionCheck, usize)> {
    let worst = |criterion: &MotionCriterion| {
        let checks = answers.iter().enumerate();
        let checks =
            checks.map(|(place, (case, followed))| (criterion.check(case.si, &followed.outcome), place));
        checks.reduce(|worst, next| if next.0.urgency() > worst.0.urgency() { next } else { worst })
    };
    let mut checks: Vec<_> = criteria.iter().filter_map(worst).collect();
    checks.sort_by(|(one, _), (two, _)| two.urgency().total_cmp(&one.urgency()));
    checks
}

/// Sentence on how many criteria are met, or which are not.
pub(crate) fn met_words<'a>(checks: impl Iterator<Item = (&'a str, bool)>) -> String {
    let checks: Vec<_> = checks.collect();
    let failed: Vec<_> = checks.iter().filter(|(_, met)| !met).map(|(name, _)| *name).collect();
    match (checks.len(), failed.as_slice()) {
        (1, []) => "The criterion is met.".to_owned(),
        (2, []) => "Both criteria are met.".to_owned(),
        (count, []) => format!("All {count} criteria are met."),
        (_, failed) => format!("Not met: {}.", failed.join(", ")),
    }
}

impl Serialize for MotionValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            MotionValue::Number(number) => serializer.serialize_f64(*number),
            MotionValue::Truth(truth) => serializer.serialize_bool(*truth),
            MotionValue::None => serializer.serialize_none(),
        }
    }
}

/// The bound in a document: a number, or `false` of what is not to be.
impl Serialize for MotionCriterion {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.bound() {
            Some(bound) => serializer.serialize_f64(bound),
            None => serializer.serialize_bool(false),
        }
    }
}
