//! Into which mode a block leaves rest under a load that rises, for every friction and for every share of one load.
//!
//! The wrench is `permanent` + λ `variable`. A departure is either by sliding, where |X| = μ_sP, or by turning, where the reaction
//! has come to a corner: at a load factor λ_t that friction does not touch. So along friction there is one change between the two,
//! at |X|/P at λ_t; above it the modes at λ_t part as ever. Which frictions can part departures is known in closed form;
//! between two of them one departure is decided exactly.
//!
//! In the same way along a number b on which the variable load depends linearly: in the plane of (λ, λb) rest is a convex
//! polygon, and the ray towards (1, b) leaves it by another mode where it meets a corner of a condition with one of rest.

use super::conditions::{COUNT, conditions};
use super::path::{departure, just_beyond};
use super::{Block, check, numbers, with_friction};
use crate::departure::{Departure, DepartureSpan};
use crate::error::InputError;
use crate::mode::{Mode, Slip};
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// Number of conditions of rest: pulled to the left and to the right, and the reaction on the base.
const REST: usize = 4;
/// Those of a reaction on the base.
const ON_BASE: [usize; 2] = [2, 3];
/// Beyond this no value is asked for: a condition whose share in it is all rounding crosses there.
const LARGEST: f64 = 1e9;
/// The departures for frictions from zero without end. The block's own μ_s and μ_k say by their ratio alone how slip follows stick.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn by_friction(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
) -> Result<Vec<DepartureSpan>, InputError> {
    check(block, permanent)?;
    check(block, variable)?;
    let at = |wrench: &Wrench| -> [f64; COUNT] { conditions(&numbers(block, wrench)) };
    let (start, slope) = (at(permanent), at(variable));
    let turning = ON_BASE
        .into_iter()
        .map(|i| -start[i] / slope[i])
        .filter(|λ| *λ > 0.0 && λ.is_finite())
        .fold(f64::INFINITY, f64::min);
    let there = turning.is_finite().then(|| *permanent + *variable * turning);
    let decide = |μ: f64| departure(&with_friction(block, μ), permanent, variable);
    let mut parting = Vec::new();
    // Rounding must not hide a change at the very friction at which both come together.
    let beyond = |μ: &f64, sliding: f64| *μ > sliding * (1.0 + 1e-9);
    if block.mu_k == block.mu_s && permanent.p > 0.0 && ON_BASE.iter().all(|i| start[*i] > 0.0) {
        // Where the permanent loads alone do not slide it, X/P rises or falls on the way to the load that turns it: it slides
        // before that if |X|/P there is above μ.
        let (at_rest, end) = (permanent.x.abs() / permanent.p, there.unwrap_or(*variable));
        let sliding = end.x.abs() / end.p;
        if end.p > 0.0 && sliding > at_rest && sliding < LARGEST {
            if let Some(there) = there {
                parting.extend(frictions(block, &there).filter(|μ| beyond(μ, sliding) && *μ < LARGEST));
            }
            let mut found = Vec::new();
            if at_rest > 0.0 {
                let below = frictions(block, permanent).filter(|μ| *μ > 0.0 && *μ < at_rest);
                found = DepartureSpan::between(0.0, below.chain([at_rest]).collect(), f64::INFINITY, decide)?;
                // What is beyond is told in what follows.
                found.pop();
            }
            let slip = if end.x < 0.0 { Slip::Left } else { Slip::Right };
            let μ = 0.5 * (at_rest + sliding);
            let pulled = |wrench: &Wrench| slip.sign() * wrench.x - μ * wrench.p;
            let factor = -pulled(permanent) / pulled(variable);
            let departure = Departure::At { factor, verdict: Some(Verdict::Begins(Mode::slide(slip))) };
            found.push(DepartureSpan { from: at_rest, to: sliding, departure });
            found.extend(DepartureSpan::between(sliding, parting, f64::INFINITY, |μ| match there {
                Some(_) => {
                    let verdict = just_beyond(&with_friction(block, μ), permanent, variable, turning)?;
                    Ok(Departure::At { factor: turning, verdict })
                }
                None => Ok(Departure::Never),
            })?);
            return Ok(found);
        }
    }
    parting.extend(frictions(block, permanent));
    if let Some(there) = there {
        let sliding = there.x.abs() / there.p;
        parting.push(sliding);
        parting.extend(frictions(block, &there).filter(|μ| *μ >= sliding * (1.0 - 1e-9)));
    } else {
        parting.extend(frictions(block, variable));
    }
    if block.mu_k < block.mu_s {
        parting.extend(along_sliding(block, permanent, variable));
    }
    parting.retain(|μ| *μ > 0.0 && *μ < LARGEST);
    DepartureSpan::between(0.0, parting, f64::INFINITY, decide)
}

/// The departures for all values of a number b of which the variable load is `without` + b `with`.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn by_share(
    block: &Block,
    permanent: &Wrench,
    without: &Wrench,
    with: &Wrench,
) -> Result<Vec<DepartureSpan>, InputError> {
    [permanent, without, with].into_iter().try_for_each(|wrench| check(block, wrench))?;
    let at = |wrench: &Wrench| -> [f64; COUNT] { conditions(&numbers(block, wrench)) };
    let (c, t, s) = (at(permanent), at(without), at(with));
    let mut parting: Vec<f64> = (0..REST).map(|i| -t[i] / s[i]).collect();
    // Conditions of rest: the first two hold below zero, the others above.
    let holds = |i: usize, t_at: f64, s_at: f64| {
        let terms = [c[i], t[i] * t_at, s[i] * s_at];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let sum: f64 = terms.iter().sum();
        (if i < 2 { -sum } else { sum }) >= -1e-9 * size
    };
    for i in 0..REST {
        for j in 0..COUNT {
            let determinant = t[i] * s[j] - t[j] * s[i];
            let (λ, λb) =
                ((c[j] * s[i] - c[i] * s[j]) / determinant, (t[j] * c[i] - t[i] * c[j]) / determinant);
            if i != j && λ > 0.0 && λ.is_finite() && λb.is_finite() && (0..REST).all(|i| holds(i, λ, λb))
            {
                parting.push(λb / λ);
            }
        }
    }
    parting.retain(|b| b.abs() < LARGEST);
    let decide = |b: f64| departure(block, permanent, &(*without + *with * b));
    DepartureSpan::between(f64::NEG_INFINITY, parting, f64::INFINITY, decide)
}

/// The frictions at which a condition changes its sign under a wrench.
fn frictions(block: &Block, wrench: &Wrench) -> impl Iterator<Item = f64> {
    let at = |μ| -> [f64; COUNT] { conditions(&numbers(&with_friction(block, μ), wrench)) };
    let (start, end) = (at(0.0), at(1.0));
    (0..COUNT).map(move |i| start[i] / (start[i] - end[i]))
}

/// The frictions at which a condition changes its sign at the very load at which sliding begins, μ = ±X/P: times P the condition is
/// a quadratic of λ. For less friction to slip than to stick, where what begins need not be the slide.
fn along_sliding(block: &Block, permanent: &Wrench, variable: &Wrench) -> Vec<f64> {
    let mut found = Vec::new();
    for sign in [-1.0, 1.0] {
        let at = |λ: f64| -> [f64; COUNT] {
            let wrench = *permanent + *variable * λ;
            let [none, all] = [0.0, 1.0]
                .map(|μ| -> [f64; COUNT] { conditions(&numbers(&with_friction(block, μ), &wrench)) });
            std::array::from_fn(|i| none[i] * wrench.p + sign * wrench.x * (all[i] - none[i]))
        };
        let [zero, one, two] = [0.0, 1.0, 2.0].map(at);
        for i in 0..COUNT {
            let square = 0.5 * (two[i] - 2.0 * one[i] + zero[i]);
            let linear = one[i] - zero[i] - square;
            let root = (linear * linear - 4.0 * square * zero[i]).sqrt();
            let half = -0.5 * (linear + linear.signum() * root);
            for λ in [half / square, zero[i] / half] {
                let wrench = *permanent + *variable * λ;
                if λ > 0.0 && λ.is_finite() && wrench.p > 0.0 {
                    found.push(sign * wrench.x / wrench.p);
                }
            }
        }
    }
    found
}
