//! A load that rises: which modes a block goes through on the way to the full load and beyond.
//!
//! The wrench is `permanent` + λ `variable`, λ from zero. Every condition of the [contact problem](super) is linear in the
//! wrench, so each is crossed at one load factor at most, found to round-off; between two crossings the modes are
//! constant, and are decided exactly.

use super::conditions::{COUNT, conditions};
use super::{Block, Wrench, numbers, solve};
use crate::error::InputError;
use crate::mode::{Mode, Modes};

/// A stretch of load factors with the same modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// The load factor at which it begins.
    pub from: f64,
    /// The load factor at which it ends.
    pub to: f64,
    /// The mode reported.
    pub mode: Option<Mode>,
    /// All consistent modes.
    pub modes: Modes,
}

/// The stages of a load rising from zero to `up_to` times `variable`, beside `permanent`.
///
/// # Errors
/// As [`solve`]; or if `up_to` is not a number above zero.
pub fn stages(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    up_to: f64,
) -> Result<Vec<Stage>, InputError> {
    let up_to = InputError::positive("largest load factor", up_to)?;
    let mut ends: Vec<f64> = crossings(block, permanent, variable).filter(|λ| *λ < up_to).collect();
    ends.push(up_to);
    ends.sort_by(f64::total_cmp);
    // One crossing, computed from two conditions.
    ends.dedup_by(|later, earlier| *later - *earlier <= 16.0 * f64::EPSILON * *later);

    let mut stages: Vec<Stage> = Vec::new();
    let mut from = 0.0;
    for to in ends {
        let answer = solve(block, &(*permanent + *variable * (from + (to - from) / 2.0)))?;
        match stages.last_mut() {
            Some(last) if (last.mode, last.modes) == (answer.mode(), answer.modes) => last.to = to,
            _ => stages.push(Stage { from, to, mode: answer.mode(), modes: answer.modes }),
        }
        from = to;
    }
    Ok(stages)
}

/// The load factors above zero at which a condition changes its sign.
fn crossings(block: &Block, permanent: &Wrench, variable: &Wrench) -> impl Iterator<Item = f64> {
    let at = |wrench| -> [f64; COUNT] { conditions(&numbers(block, wrench)) };
    let (start, slope) = (at(permanent), at(variable));
    start.into_iter().zip(slope).map(|(start, slope)| -start / slope).filter(|λ| *λ > 0.0 && λ.is_finite())
}
