//! Bases of a block of the [contact problem](crate::contact), in its units: each answers the same questions.

use super::bearing::BearingBlock;
use super::strength;
use crate::contact::holding::Holding;
use crate::contact::{self, Block, departure, friction, path};
use crate::departure::{Departure, DepartureSpan};
use crate::error::InputError;
use crate::span::Span;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// Base of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Base {
    /// It bears everything.
    Rigid,
    /// It crushes at this force per length, as [`strength::solve`] takes it.
    Crushing(f64),
    /// The ground under it can fail.
    Failing(BearingBlock),
    /// It bears everything, and more than friction holds the body on it.
    Held(Holding),
}

impl Base {
    /// The decision under a wrench.
    ///
    /// # Errors
    /// As [`contact::solve`] and [`strength::solve`], here and below.
    pub fn decide(&self, block: &Block, wrench: &Wrench) -> Result<Decision, InputError> {
        match self {
            Base::Rigid => contact::solve(block, wrench)
                .map(|found| Decision { verdict: found.mode().map(Verdict::Begins), modes: found.modes }),
            Base::Crushing(strength) => strength::solve(block, wrench, *strength)
                .map(|found| Decision { verdict: found.verdict(), modes: found.modes }),
            Base::Failing(ground) => ground.decide(block, wrench),
            Base::Held(holding) => holding.decide(block, wrench),
        }
    }

    /// The spans of friction from zero without end; beyond `up_to` none is asked for, and the last span is as it is there. The block's own
    /// μ_s and μ_k say by their ratio alone how slip follows stick.
    pub fn friction_spans(
        &self,
        block: &Block,
        wrench: &Wrench,
        up_to: f64,
    ) -> Result<Vec<Span>, InputError> {
        match self {
            Base::Rigid => friction::spans_up_to(block, wrench, up_to),
            Base::Crushing(strength) => strength::friction_spans(block, wrench, *strength, up_to),
            Base::Failing(ground) => ground.friction_spans(block, wrench, up_to),
            Base::Held(holding) => holding.friction_spans(block, wrench, up_to),
        }
    }

    /// The departure under a load that rises from zero beside `permanent`.
    pub fn departure(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<Departure, InputError> {
        match self {
            Base::Rigid => path::departure(block, permanent, variable),
            Base::Crushing(strength) => strength::departure(block, permanent, variable, *strength),
            Base::Failing(ground) => ground.departure(block, permanent, variable),
            Base::Held(holding) => holding.departure(block, permanent, variable),
        }
    }

    /// The departures for every friction; beyond `up_to` none is asked for. `None` where it is not known for certain which frictions part
    /// them: on a base that gives way, of a block with less friction to slip than to stick.
    pub fn departure_spans(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
        up_to: f64,
    ) -> Result<Option<Vec<DepartureSpan>>, InputError> {
        let spans = match self {
            Base::Rigid => departure::by_friction(block, permanent, variable),
            Base::Held(_) => return Ok(None),
            _ if block.mu_k != block.mu_s => return Ok(None),
            Base::Crushing(strength) => {
                strength::departure_spans(block, permanent, variable, *strength, up_to)
            }
            Base::Failing(ground) => ground.departure_spans(block, permanent, variable, up_to),
        };
        spans.map(Some)
    }
}
