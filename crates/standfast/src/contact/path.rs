//! A load that rises: which modes a block goes through on the way to the full load and beyond.
//!
//! The wrench is `permanent` + λ `variable`, λ from zero. Every condition of the [contact problem](super) is linear in the
//! wrench, so each is crossed at one load factor at most, found to round-off; between two crossings the modes are
//! constant, and are decided exactly.

use super::conditions::{COUNT, conditions};
use super::{Block, numbers, solve};
use crate::departure::Departure;
use crate::error::{InputError, LARGEST};
use crate::neighbour::Neighbour;
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// The stages of a load rising from zero without end, beside `permanent`; the last ends at infinity.
///
/// # Errors
/// As [`solve`].
pub fn stages(block: &Block, permanent: &Wrench, variable: &Wrench) -> Result<Vec<Stage>, InputError> {
    let mut stages = Vec::new();
    for piece in pieces(block, permanent, variable) {
        piece?.join(&mut stages);
    }
    Ok(stages)
}

/// The stretches between crossings, one by one; neighbours may have the same modes.
fn pieces(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
) -> impl Iterator<Item = Result<Stage, InputError>> {
    let mut ends: Vec<f64> = crossings(block, permanent, variable).collect();
    ends.sort_by(f64::total_cmp);
    // One crossing, computed from two conditions.
    ends.dedup_by(|later, earlier| *later - *earlier <= 16.0 * f64::EPSILON * *later);
    ends.push(f64::INFINITY);
    let mut from = 0.0;
    ends.into_iter().map(move |to| {
        // Beyond the last crossing any load factor will do.
        let inside = match to {
            f64::INFINITY if from == 0.0 => 1.0,
            f64::INFINITY => 2.0 * from,
            to => from + (to - from) / 2.0,
        };
        let solution = solve(block, &(*permanent + *variable * inside))?;
        let stage = Stage { from, to, verdict: solution.mode().map(Verdict::Begins), modes: solution.modes };
        from = to;
        Ok(stage)
    })
}

/// Departure under a load that rises from zero beside `permanent`: the first motion of the block, and nothing beyond it.
///
/// # Errors
/// As [`solve`].
pub fn departure(block: &Block, permanent: &Wrench, variable: &Wrench) -> Result<Departure, InputError> {
    let begin = solve(block, permanent)?.mode().map(Verdict::Begins);
    Departure::along(begin, pieces(block, permanent, variable))
}

/// The verdict just beyond a load factor.
pub(super) fn just_beyond(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    factor: f64,
) -> Result<Option<Verdict>, InputError> {
    let next = crossings(block, permanent, variable)
        .filter(|λ| *λ - factor > 1e-12 * factor)
        .fold(f64::INFINITY, f64::min);
    let inside = if next.is_finite() { factor + (next - factor) / 2.0 } else { 2.0 * factor };
    Ok(solve(block, &(*permanent + *variable * inside))?.mode().map(Verdict::Begins))
}

/// The load factors above zero at which a condition changes its sign. One so large that the load leaves the range of
/// [`InputError`] is none: it comes from a part of the load that is nothing beside the rest.
pub(super) fn crossings(block: &Block, permanent: &Wrench, variable: &Wrench) -> impl Iterator<Item = f64> {
    let at = |wrench| -> [f64; COUNT] { conditions(&numbers(block, wrench)) };
    let (start, slope) = (at(permanent), at(variable));
    let largest = variable.x.abs().max(variable.p.abs()).max(variable.m.abs());
    let in_range = move |λ: &f64| *λ > 0.0 && *λ * largest < LARGEST / 4.0;
    start.into_iter().zip(slope).map(|(start, slope)| -start / slope).filter(in_range)
}
