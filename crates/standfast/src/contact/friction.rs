//! Modes that a block begins with, for every friction: the same problem read along μ.
//!
//! Every condition of the [contact problem](super) is linear in μ for a fixed ratio of μ_k to μ_s, so each changes its sign at
//! one friction at most; between two of these the modes are constant, and are decided exactly at one friction. For the report's
//! problem the frictions are its curves
//!
//! ```text
//! k      1/γ − kk'      −1/γ − kk'      |ak + b|/(ck + d)
//! ```
//!
//! Whoever knows the law of μ knows from these intervals the probability of each mode, and need not draw μ.

use std::cmp::Ordering;

use super::conditions::{self, COUNT, conditions};
use super::{Block, check, numbers, solve, with_friction};
use crate::error::InputError;
use crate::span::Span;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// The spans of friction from zero without end. The block's own μ_s and μ_k say by their ratio alone how slip follows stick.
///
/// ```
/// use standfast::Wrench;
/// use standfast::contact::{Block, friction};
///
/// // γ = 0.8, k' = 0.9, k = 0.45: slides below μ = k, rests above.
/// let wrench = Wrench { x: -0.45, p: 1.0, m: 0.45 * 0.9 * 0.8 };
/// let spans = friction::spans(&Block::uniform(0.8, 1.0), &wrench)?;
/// let ends: Vec<_> = spans.iter().map(|span| (span.mode().unwrap().to_string(), span.to)).collect();
/// assert_eq!(ends, [("SL".to_string(), 0.45), ("RE".to_string(), f64::INFINITY)]);
/// # Ok::<(), standfast::InputError>(())
/// ```
///
/// # Errors
/// As [`solve`].
pub fn spans(block: &Block, wrench: &Wrench) -> Result<Vec<Span>, InputError> {
    spans_up_to(block, wrench, LARGEST)
}

/// Spans of frictions up to this one alone, which is above zero; the last span is said to have no end.
///
/// # Errors
/// As [`solve`].
pub fn spans_up_to(block: &Block, wrench: &Wrench, up_to: f64) -> Result<Vec<Span>, InputError> {
    check(block, wrench)?;
    let up_to = up_to.min(LARGEST);
    let at = |μ| -> [f64; COUNT] { conditions(&numbers(&with_friction(block, μ), wrench)) };
    let (start, end) = (at(0.0), at(1.0));
    let mut crossings: Vec<(f64, usize)> = (0..COUNT)
        .map(|i| (start[i] / (start[i] - end[i]), i))
        .filter(|(μ, _)| *μ > 0.0 && *μ < up_to)
        .collect();
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    // One friction, computed from two conditions; the first of them names it.
    crossings.dedup_by(|later, earlier| {
        let same = later.0 - earlier.0 <= ONE * later.0.max(1.0);
        earlier.1 = if same { earlier.1.min(later.1) } else { earlier.1 };
        same
    });
    let up_to = if up_to < LARGEST { up_to } else { f64::INFINITY };
    Span::between(crossings, up_to, |μ| {
        let (mode, modes) = match signs(&start, &end, μ) {
            Some(signs) => {
                let conditions::Choice { mode, modes } = conditions::Choice::of_signs(&signs);
                (mode, modes)
            }
            None => {
                let solution = solve(&with_friction(block, μ), wrench)?;
                (solution.mode(), solution.modes)
            }
        };
        Ok(Decision { verdict: mode.map(Verdict::Begins), modes })
    })
}

/// The signs of the conditions at a friction between crossings, by what they are at 0 and 1; none where rounding could tell
/// another sign, and exact arithmetic has to.
fn signs(start: &[f64; COUNT], end: &[f64; COUNT], μ: f64) -> Option<[Ordering; COUNT]> {
    let mut signs = [Ordering::Equal; COUNT];
    let mut unsure = false;
    for ((sign, start), end) in signs.iter_mut().zip(start).zip(end) {
        let (value, size) = (start + (end - start) * μ, start.abs() + end.abs() * μ);
        // Without a way out: all at once is quicker than one after the other.
        unsure |= value.is_nan() | ((value.abs() <= UNSURE * size) & (size > 0.0));
        *sign = if value > 0.0 {
            Ordering::Greater
        } else if value < 0.0 {
            Ordering::Less
        } else {
            Ordering::Equal
        };
    }
    if unsure {
        return None;
    }
    Some(signs)
}

/// Below this share of its terms a condition is not told from zero: its products have lost some ten bits at most.
const UNSURE: f64 = 1e-9;

/// Beyond this no friction is asked for: a condition whose share in μ is all rounding crosses there.
const LARGEST: f64 = 1e9;
/// Distance of two crossings that are one, relative to the larger or to 1: where terms cancel, a small crossing is known no better.
const ONE: f64 = 1e-13;
