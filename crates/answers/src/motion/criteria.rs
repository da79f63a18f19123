//! Checks of the criteria on a motion: `slide`, `max_theta` and `overturned` under `[criteria]`.
//!
//! A bound is met by a motion that was followed to its end: of a body that still moves when the time is up nobody knows how far it gets.

use standfast_model::MotionCriterion;
use standfast_motion::End;

use super::{Copies, FollowedMotion};
use crate::criteria::{met_word, used_words};
use crate::digits::{apart, digits};

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

impl MotionCheck {
    /// Check of a criterion against a motion.
    pub fn of(criterion: MotionCriterion, followed: &FollowedMotion) -> MotionCheck {
        let FollowedMotion { case, outcome, copies, .. } = followed;
        let value = match criterion {
            MotionCriterion::OverturnedShare(_) => copies
                .as_ref()
                .map_or(MotionValue::None, |copies| MotionValue::Number(copies.overturned.high)),
            MotionCriterion::Slide(_) if outcome.overturned() => MotionValue::None,
            MotionCriterion::Slide(_) => MotionValue::Number(outcome.slide.abs()),
            MotionCriterion::MaxTheta(_) => MotionValue::Number(outcome.max_theta),
            MotionCriterion::NotOverturned => MotionValue::Truth(outcome.overturned()),
        };
        let within = match (value, criterion.bound()) {
            (MotionValue::Number(value), Some(bound)) => value <= bound,
            (MotionValue::Truth(overturned), _) => !overturned,
            _ => false,
        };
        // What is beyond a bound already stays a number; what is not may get there yet.
        let of_copies = matches!(criterion, MotionCriterion::OverturnedShare(_));
        let is_unknown =
            |copies: &Copies| copies.rows.len() > copies.ended(End::AtRest.word()) + copies.overturning();
        let followed = match copies.as_ref().filter(|_| of_copies) {
            Some(copies) => !is_unknown(copies),
            None => matches!(outcome.end, End::AtRest | End::Overturned),
        };
        let value = if within && !followed { MotionValue::None } else { value };
        let utilisation = match (value, criterion.bound()) {
            (MotionValue::Number(value), Some(bound)) => Some(value / bound),
            (MotionValue::None, Some(_)) => Some(f64::INFINITY),
            _ => None,
        };
        MotionCheck { criterion, value, utilisation, met: within && followed, end: outcome.end, si: case.si }
    }

    /// The value as it is read, with as many digits as tell it from the bound.
    pub fn value_words(&self) -> String {
        match (self.value, self.criterion.bound()) {
            (MotionValue::Number(value), Some(bound)) => {
                let at_most = if self.is_of_copies() { "at most " } else { "" };
                let text = if value == bound { digits(value) } else { apart(&[value, bound])[0].clone() };
                at_most.to_owned() + &text + self.criterion.unit(self.si)
            }
            (MotionValue::Number(value), None) => digits(value),
            (MotionValue::Truth(true), _) => "yes".to_owned(),
            (MotionValue::Truth(false), _) => "no".to_owned(),
            (MotionValue::None, _) if self.is_of_copies() => {
                "not known: copies are not followed to their end".to_owned()
            }
            (MotionValue::None, _) if self.end == End::Overturned => "none: the body overturns".to_owned(),
            (MotionValue::None, _) => "not known: the motion is not followed to its end".to_owned(),
        }
    }

    fn is_of_copies(&self) -> bool {
        matches!(self.criterion, MotionCriterion::OverturnedShare(_))
    }

    /// The utilisation as it is read.
    pub fn utilisation_words(&self) -> String {
        used_words(self.utilisation)
    }

    /// "met" or "not met".
    pub fn met_words(&self) -> &'static str {
        met_word(self.met)
    }

    /// Reason why it is not met: `slide is 0.1004 m, not ≤ 0.1 m`.
    pub fn failure(&self) -> String {
        let name = self.criterion.name();
        match (self.value, self.end) {
            (MotionValue::Number(_), _) => {
                format!("{name} is {}, not {}", self.value_words(), self.criterion.required(self.si))
            }
            _ if self.is_of_copies() => format!("{name} is {}", self.value_words()),
            (_, End::Overturned) => "the body overturns".to_owned(),
            _ => format!("{name} is not known: the motion is not followed to its end"),
        }
    }

    /// Urgency of the check: its utilisation, 1 at least of one that is not met, infinite where nothing is measured.
    pub fn urgency(&self) -> f64 {
        match (self.utilisation, self.met) {
            (Some(utilisation), true) => utilisation,
            (Some(utilisation), false) => utilisation.max(1.0),
            (None, true) => 0.0,
            (None, false) => f64::INFINITY,
        }
    }
}

/// Each criterion in the situation that meets it worst, with the place of that; the governing one first.
pub(crate) fn worst_checks(
    criteria: &[MotionCriterion],
    answers: &[FollowedMotion],
) -> Vec<(MotionCheck, usize)> {
    let worst = |criterion: &MotionCriterion| {
        let checks = answers.iter().enumerate().map(|(place, of)| (MotionCheck::of(*criterion, of), place));
        checks.reduce(|worst, next| if next.0.urgency() > worst.0.urgency() { next } else { worst })
    };
    let mut checks: Vec<_> = criteria.iter().filter_map(worst).collect();
    checks.sort_by(|(one, _), (two, _)| two.urgency().total_cmp(&one.urgency()));
    checks
}
