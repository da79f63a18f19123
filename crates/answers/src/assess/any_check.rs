//! Criteria of the first instant and of the motion, side by side.

use super::{Assessed, Assessment, CaseCheck};
use crate::motion::MotionCheck;

/// A criterion of a case where it is met worst, be it of the first instant or of the motion.
#[derive(Debug, Clone, PartialEq)]
pub enum AnyCheck<'a> {
    /// Of the first instant.
    Instant(CaseCheck<'a>),
    /// Of the motion, and the place of the situation.
    Motion(MotionCheck, usize),
}

impl AnyCheck<'_> {
    /// The name of the criterion.
    pub fn name(&self) -> &'static str {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.criterion.name(),
            AnyCheck::Motion(check, _) => check.criterion.name(),
        }
    }

    /// What it is of, in one or two words.
    pub fn in_short(&self) -> &'static str {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.in_short(),
            AnyCheck::Motion(check, _) => check.criterion.in_short(),
        }
    }

    /// The quantity it asks for, in words.
    pub fn words(&self) -> &'static str {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.criterion.words(),
            AnyCheck::Motion(check, _) => check.criterion.words(),
        }
    }

    /// The joint at which it is met worst, as [`Check::on_joint`](crate::criteria::Check::on_joint); empty without joints, and of the motion.
    pub fn on_joint(&self) -> String {
        match self {
            AnyCheck::Instant(CaseCheck { check, assessed }) => check.on_joint(assessed),
            AnyCheck::Motion(..) => String::new(),
        }
    }

    /// Bound, value and utilisation as they are read, and whether it is met.
    pub fn cells(&self) -> [String; 4] {
        match self {
            AnyCheck::Instant(CaseCheck { check, assessed }) => [
                check.criterion.required(),
                check.value_words(assessed),
                check.utilisation_words(),
                check.met_words().to_owned(),
            ],
            AnyCheck::Motion(check, _) => [
                check.criterion.required(check.si),
                check.value_words(),
                check.utilisation_words(),
                check.met_words().to_owned(),
            ],
        }
    }

    /// Share of the bound that is used, 1 at most where it is met; `None` where nothing is measured.
    pub fn utilisation(&self) -> Option<f64> {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.utilisation,
            AnyCheck::Motion(check, _) => check.utilisation,
        }
    }

    /// True if it is met.
    pub fn is_met(&self) -> bool {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.met,
            AnyCheck::Motion(check, _) => check.met,
        }
    }

    /// The situation that meets it worst.
    pub fn assessed<'a>(&'a self, assessment: &'a Assessment) -> &'a Assessed {
        match self {
            AnyCheck::Instant(CaseCheck { assessed, .. }) => assessed,
            AnyCheck::Motion(_, place) => &assessment.all[*place],
        }
    }

    /// True if it is of another acceleration of the base, or of other factors of pairs, than those that are reported.
    pub fn is_of_another_trial(&self) -> bool {
        matches!(self, AnyCheck::Instant(CaseCheck { assessed, .. }) if !assessed.is_reported)
    }

    pub(super) fn urgency(&self) -> f64 {
        match self {
            AnyCheck::Instant(CaseCheck { check, .. }) => check.urgency(),
            AnyCheck::Motion(check, _) => check.urgency(),
        }
    }
}
