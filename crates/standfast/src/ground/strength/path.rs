//! A load that rises on a base that crushes: where the body leaves rest, and what follows.
//!
//! The wrench is `permanent` + λ `variable`. Friction is linear in it; the condition at an edge, b P ∓ (Xd − M) − P²/2q ≥ 0, is a
//! concave quadratic in λ: it is crossed twice at most, in closed form, and the load factors at which the body rests are
//! one interval. Where modes that turn change, the load factors are zeros of [resultants](super::events), near which the decision is bisected to
//! neighbouring numbers. What holds between two neighbouring ones of all these is decided exactly, once.

use std::ops::Range;

use super::conditions::{CORNERS, SLIPS, enumerate};
use super::events::events;
use super::{LoadedBlock, check};
use crate::contact::Block;
use crate::error::{InputError, LARGEST};
use crate::mode::{Corner, Slip};
use crate::neighbour::Neighbour;
use crate::stage::Stage;
use crate::verdict::Decision;
use crate::wrench::Wrench;

/// a + bλ + cλ².
#[derive(Clone, Copy)]
struct Quadratic([f64; 3]);

impl Quadratic {
    /// Zeros, ascending, without cancellation; one that does not exist is not a number.
    fn zeros(self) -> [f64; 2] {
        let [a, b, c] = self.0;
        let sum = -(b + b.signum() * (b * b - 4.0 * a * c).sqrt()) / 2.0;
        let (one, two) = (a / sum, sum / c);
        if two < one { [two, one] } else { [one, two] }
    }
}

/// The conditions of rest as quadratics in λ, none of which is negative there: friction both ways, both edges; then those of the
/// slides at both edges, and whether the base carries P at all.
fn conditions(block: &Block, permanent: &Wrench, variable: &Wrench, strength: f64) -> Vec<Quadratic> {
    let Block { b1, b2, d, mu_s, mu_k, .. } = *block;
    let line = |f: &dyn Fn(&Wrench) -> f64| [f(permanent), f(variable), 0.0];
    let crush = [permanent.p * permanent.p, 2.0 * permanent.p * variable.p, variable.p * variable.p]
        .map(|square| square / (2.0 * strength));
    let edge = |corner: Corner, about: &dyn Fn(&Wrench) -> f64| {
        let line = match corner {
            Corner::O => line(&|w| b1 * w.p + about(w)),
            Corner::OPrime => line(&|w| b2 * w.p - about(w)),
        };
        Quadratic(std::array::from_fn(|i| line[i] - crush[i]))
    };
    let mut all: Vec<Quadratic> =
        SLIPS.map(|slip| Quadratic(line(&|w| mu_s * w.p - slip.sign() * w.x))).into();
    all.extend(CORNERS.map(|corner| edge(corner, &|w| w.x * d - w.m)));
    for slip in SLIPS {
        let friction = |w: &Wrench| Slip::sign(slip) * mu_k * d * w.p - w.m;
        all.extend(CORNERS.map(|corner| edge(corner, &friction)));
    }
    all.push(Quadratic(line(&|w| w.p)));
    if strength.is_finite() {
        all.push(Quadratic([strength * (b1 + b2) - permanent.p, -variable.p, 0.0]));
    }
    all
}

/// Number of the [`conditions`] that are those of rest.
const REST: usize = 4;

/// A stretch of load factors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoadRange {
    /// The least.
    pub from: f64,
    /// The largest, possibly infinite.
    pub to: f64,
}

/// The load factors, of any sign, at which the body can rest under `permanent` + λ `variable`: one stretch, in closed form; `None` if
/// it rests under none. Where an input is at the edge of it, rounding decides; [`solve`](super::solve) has no rounding.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn rest_range(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
) -> Result<Option<LoadRange>, InputError> {
    range(block, permanent, variable, strength, 0..REST)
}

/// Load factors at which the base bears the reaction of a body that friction holds: the conditions at both edges alone.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn bearing_range(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
) -> Result<Option<LoadRange>, InputError> {
    range(block, permanent, variable, strength, SLIPS.len()..REST)
}

/// Load factors at which these of the conditions hold.
fn range(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
    which: Range<usize>,
) -> Result<Option<LoadRange>, InputError> {
    // Numbers out of range are refused.
    check(block, permanent, strength)?;
    check(block, variable, strength)?;
    Ok(hold(&conditions(block, permanent, variable, strength)[which]))
}

/// The load factors at which none of the conditions is negative: one stretch, as each is concave.
fn hold(conditions: &[Quadratic]) -> Option<LoadRange> {
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for condition in conditions {
        let [a, b, c] = condition.0;
        let (least, largest) = match condition.zeros() {
            _ if b == 0.0 && c == 0.0 => {
                let all = if a >= 0.0 { f64::INFINITY } else { f64::NAN };
                (-all, all)
            }
            _ if c == 0.0 && b > 0.0 => (-a / b, f64::INFINITY),
            _ if c == 0.0 => (f64::NEG_INFINITY, -a / b),
            [one, two] => (one, two),
        };
        if least.is_nan() || largest.is_nan() {
            return None;
        }
        (from, to) = (from.max(least), to.min(largest));
    }
    (from <= to).then_some(LoadRange { from, to })
}

/// The stages of a load rising from zero without end, beside `permanent`, on a base that bears `strength` per length; the last ends
/// at infinity.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn stages(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
) -> Result<Vec<Stage>, InputError> {
    check(block, permanent, strength)?;
    check(block, variable, strength)?;
    let largest = variable.x.abs().max(variable.p.abs()).max(variable.m.abs());
    let closed = conditions(block, permanent, variable, strength).into_iter().flat_map(Quadratic::zeros);
    let turning = events(block, permanent, variable, strength);
    let mut ends: Vec<End> = closed.map(|at| End { at, is_closed: true }).collect();
    ends.extend(turning.into_iter().map(|at| End { at, is_closed: false }));
    ends.retain(|end| end.at > 0.0 && end.at * largest < LARGEST / 4.0);
    // Of two that are one the closed one stays.
    ends.sort_by(|one, other| one.at.total_cmp(&other.at).then(other.is_closed.cmp(&one.is_closed)));
    ends.dedup_by(|later, earlier| {
        let one = later.at - earlier.at <= 16.0 * f64::EPSILON * later.at;
        if one && later.is_closed && !earlier.is_closed {
            *earlier = *later;
        }
        one
    });

    let at = |λ: f64| {
        let wrench = *permanent + *variable * λ;
        enumerate(&LoadedBlock { block: *block, wrench, strength })
    };
    let mut stages = Vec::new();
    let mut add = |from: f64, to: f64, Decision { verdict, modes }: Decision| {
        Stage { from, to, verdict, modes }.join(&mut stages);
    };
    // Between two ends, and beyond the last.
    let middle = |from: f64, to: f64| from + (to - from) / 2.0;
    let beyond = ends.last().map_or(1.0, |last| 2.0 * last.at);
    let mut place = ends.first().map_or(beyond, |first| middle(0.0, first.at));
    let (mut from, mut now) = (0.0, at(place));
    for (i, end) in ends.iter().enumerate() {
        let next = ends.get(i + 1).map_or(beyond, |next| middle(end.at, next.at));
        let then = at(next);
        if then != now {
            let to = if end.is_closed { end.at } else { end_of(place, next, |λ| at(λ) == now) };
            add(from, to, now);
            from = to;
        }
        (place, now) = (next, then);
    }
    add(from, f64::INFINITY, now);
    Ok(stages)
}

/// A load factor at which a mode may begin or end.
#[derive(Debug, Clone, Copy)]
struct End {
    at: f64,
    /// True if it is the zero of a condition that stands alone.
    is_closed: bool,
}

/// End of a stretch on which `holds` is true at `low` and not at `high`: a number at which it is not, and is at the one before.
fn end_of(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return high;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}
