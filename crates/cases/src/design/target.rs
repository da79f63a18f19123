//! What a design has to reach.

use std::fmt;
use std::str::FromStr;

use standfast::Mode;
use thiserror::Error;

use super::{least, load_factor, overturning, sliding};
use crate::assess::verdict::predicate;
use crate::assess::{Assessed, Assessment};
use crate::layout::digits;

/// Beyond any factor that a design aims at.
const FAR: f64 = 1e4;

/// What a design has to reach, in every situation of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// The body rests under the full load.
    Rest,
    /// Both safety factors are at least this.
    Factor(f64),
    /// The rising load moves the body at this factor at the earliest.
    LoadFactor(f64),
    /// The body turns about no corner, neither under the full load at once nor while it rises.
    NoRock,
    /// The body slips at no corner, neither under the full load at once nor while it rises.
    NoSlide,
}

/// A text that is no target.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("expected rest, factor=1.2, load-factor=1.2, no-rock or no-slide, with a number above zero")]
pub struct TargetError;

impl FromStr for Target {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Target, TargetError> {
        let number = |text: &str| {
            let value = text.trim().parse().ok().filter(|value| *value > 0.0 && *value < FAR);
            value.ok_or(TargetError)
        };
        match text.split_once('=') {
            None if text == "rest" => Ok(Target::Rest),
            None if text == "no-rock" => Ok(Target::NoRock),
            None if text == "no-slide" => Ok(Target::NoSlide),
            Some(("factor", value)) => Ok(Target::Factor(number(value)?)),
            Some(("load-factor", value)) => Ok(Target::LoadFactor(number(value)?)),
            _ => Err(TargetError),
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::Rest => f.write_str("rest"),
            Target::Factor(factor) => write!(f, "factor={factor}"),
            Target::LoadFactor(factor) => write!(f, "load-factor={factor}"),
            Target::NoRock => f.write_str("no-rock"),
            Target::NoSlide => f.write_str("no-slide"),
        }
    }
}

impl Target {
    /// Whether every situation meets it.
    pub(super) fn is_met(self, answer: &Assessment) -> bool {
        answer.tried().all(|assessed| self.is_met_by(assessed))
    }

    fn is_met_by(self, assessed: &Assessed) -> bool {
        let full = &assessed.outcome.full;
        match self {
            Target::Rest => full.mode == Some(Mode::Rest),
            Target::Factor(factor) => {
                // By uplift that turns it, a body may move with both factors above 1.
                let turns = factor >= 1.0 && full.mode != Some(Mode::Rest);
                sliding(assessed) >= factor && overturning(assessed) >= factor && !full.is_lifted() && !turns
            }
            Target::LoadFactor(factor) => load_factor(assessed) >= factor,
            Target::NoRock | Target::NoSlide => self.offending(assessed).is_none(),
        }
    }

    /// The mode that is not to be, under the full load or, with its load factor, before.
    fn offending(self, assessed: &Assessed) -> Option<(f64, Option<Mode>)> {
        let offends = |mode: Option<Mode>| match (self, mode) {
            (Target::NoRock, Some(mode)) => mode.corner().is_some() || mode == Mode::Flight,
            (Target::NoSlide, Some(mode)) => mode.slip().is_some() || mode == Mode::Flight,
            (_, None) => true,
            _ => false,
        };
        let stages = assessed.outcome.path.iter().filter(|stage| stage.from < 1.0);
        let mut candidates =
            stages.map(|stage| (stage.from, stage.mode)).chain([(1.0, assessed.outcome.full.mode)]);
        candidates.find(|(_, mode)| offends(*mode))
    }

    /// How good an outcome is, to tell how near a design came.
    pub(super) fn score(self, answer: &Assessment) -> f64 {
        match self {
            Target::Factor(_) => least(answer, sliding).min(least(answer, overturning)),
            _ => least(answer, load_factor),
        }
    }

    /// What keeps an outcome from meeting the target, in words.
    pub(super) fn binding(self, answer: &Assessment) -> String {
        let Some(assessed) = answer.tried().find(|assessed| !self.is_met_by(assessed)) else {
            return "nothing".to_owned();
        };
        match self {
            Target::Factor(_) if assessed.outcome.full.is_lifted() => {
                "nothing presses the body on its base: P > 0 fails".to_owned()
            }
            Target::Factor(factor) if sliding(assessed) < factor => {
                format!("sliding: μ(W' − U)/P ≥ {} fails", digits(factor))
            }
            Target::Factor(factor) => {
                format!("overturning: (W' t − M_U)/M_p ≥ {} fails", digits(factor))
            }
            Target::Rest => {
                format!("under the full load the body {}", moves(assessed, assessed.outcome.full.mode))
            }
            Target::LoadFactor(factor) => {
                let mode = assessed.departure().mode().or(assessed.outcome.full.mode);
                let at = digits(factor);
                format!("before {at} times the load, the body {}", moves(assessed, mode))
            }
            Target::NoRock | Target::NoSlide => {
                let (at, mode) = self.offending(assessed).unwrap_or_default();
                let when = if at < 1.0 {
                    format!("as the load rises, from {} % on", digits(100.0 * at))
                } else {
                    "under the full load at once".to_owned()
                };
                format!("{when}, the body {}", predicate(mode))
            }
        }
    }
}

/// A mode that ends rest, and which of the conditions of rest it breaks.
fn moves(assessed: &Assessed, mode: Option<Mode>) -> String {
    let Some(mode) = mode else { return "has no consistent mode".to_owned() };
    let condition = match (mode.corner(), mode.slip()) {
        (None, Some(_)) => "the friction is used up: |X| ≤ μ P fails",
        (Some(_), None) => "the resultant leaves the base: −b₁ P ≤ X d − M ≤ b₂ P fails",
        (Some(_), Some(_)) => "|X| ≤ μ P or −b₁ P ≤ X d − M ≤ b₂ P fails",
        _ => "nothing presses it on its base: P > 0 fails",
    };
    // Under the full load, the report's inequalities of rest say it with their numbers.
    let steps =
        assessed.outcome.full.effective.map(|reduced| reduced.point.explain().steps).unwrap_or_default();
    let rest = steps.into_iter().find(|step| step.mode == Mode::Rest && !step.holds);
    let failing = rest.and_then(|step| step.relations.into_iter().find(|relation| !relation.holds));
    let equation = failing.map_or(String::new(), |relation| {
        format!("; ({}) {} fails in effective coordinates", relation.equation, relation.statement())
    });
    format!("{} ({mode}): {condition}{equation}", mode.words())
}
