//! Verdicts on a base that crushes, for every friction: the same problem read along μ, for a fixed ratio of μ_k to μ_s.
//!
//! The modes change at a friction where one of these is so (b, σ of the edge, s of the slip, v and a of the
//! [turn](super::turning)):
//!
//! | boundary | μ |
//! |---|---|
//! | the body just sticks upright | \|X\|/P |
//! | its reaction as it slides is as near to an edge as the base bears it; a slide-rock begins from a = 0 | s(M − σ(bP − P²/2q))/(dP), to slip |
//! | it just sticks as it rocks; a slide-rock comes to rest on its edge | \|X + σ m_x d a\|/N at the root of rocking |
//! | two roots of a slide-rock's equation meet | −(I + c v³)/(f₁ v²), to slip |
//!
//! Of the last the slope of the equation, I + c v³ + f₁ μ v², and the equation itself are zero together, which is a quartic in v:
//!
//! ```text
//! (q/m_y)(1 − v)²(c v²/2 − I) − δ₀ v² − (P/(m_y z))(I + c v³) = 0
//! I = ρ²   c = m_y z²   z = b − P/q   f₁ = σ s d m_y z   δ₀ = σM − Pb + P²/2q
//! ```
//!
//! Between two neighbouring ones of all these what begins is decided exactly, once.

use super::conditions::{CORNERS, SLIPS, enumerate};
use super::edges::{reaction, turn};
use super::turning::orientation;
use super::{LoadedBlock, check, rest_range, solve};
use crate::contact::{Block, with_friction};
use crate::departure::{Departure, DepartureSpan, HELD, parting};
use crate::error::InputError;
use crate::ground::roots::real_roots;
use crate::mode::{Corner, Slip};
use crate::span::Span;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// Relative distance of two frictions that are one.
const ONE: f64 = 1e-13;
/// Beyond this no friction is asked for.
const LARGEST: f64 = 1e9;

/// The spans of friction from zero without end on a base that bears `strength` per length, as [`solve`] has it; beyond `up_to` none is
/// asked for, and the last span is as it is there. The block's own μ_s and μ_k say by their ratio alone how slip follows stick.
///
/// ```
/// use standfast::Wrench;
/// use standfast::contact::Block;
/// use standfast::ground::strength::friction_spans;
///
/// // γ = 0.8, k' = 0.9167, k = 0.65, ω = 0.08: it slides below μ = (1 − ω)/γ − kk', and slide-rocks or rocks above.
/// let wrench = Wrench { x: -0.65, p: 1.0, m: 0.65 * 0.9167 * 0.8 };
/// let spans = friction_spans(&Block::uniform(0.8, 1.0), &wrench, 1.0 / 0.16, 2.0)?;
/// assert_eq!(spans[0].verdict.unwrap().symbol(), "SL");
/// assert!((spans[0].to - (0.92 / 0.8 - 0.65 * 0.9167)).abs() < 1e-12);
/// # Ok::<(), standfast::InputError>(())
/// ```
///
/// # Errors
/// As [`solve`].
pub fn friction_spans(
    block: &Block,
    wrench: &Wrench,
    strength: f64,
    up_to: f64,
) -> Result<Vec<Span>, InputError> {
    check(block, wrench, strength)?;
    let on = |μ: f64| LoadedBlock { block: with_friction(block, μ), wrench: *wrench, strength };
    Span::between(boundaries(&on(1.0), up_to), up_to, |μ| Ok(enumerate(&on(μ))))
}

/// The frictions to stick up to one at which something may change, ascending, with their numbers; `given` has a friction to stick of 1.
fn boundaries(given: &LoadedBlock, up_to: f64) -> Vec<(f64, usize)> {
    let ratio = given.block.mu_k;
    let frictions = [false, true].map(|slips| if slips { ratio } else { 1.0 });
    let Wrench { x, p, .. } = given.wrench;
    let mut found = Vec::new();
    let mut add = |μ: Option<f64>, ratio: f64| {
        let number = found.len() + 1;
        found.push((μ.map_or(f64::NAN, |μ| μ / ratio), number));
    };
    for ratio in frictions {
        add((p > 0.0).then(|| x.abs() / p), ratio);
    }
    for corner in CORNERS {
        let turn = turn(given, corner);
        frictions.into_iter().for_each(|ratio| add(turn, ratio));
        for slip in SLIPS {
            add(reaction(given, slip, corner), ratio);
            let mut meet = meeting(given, corner, slip).into_iter();
            // As many as a quartic has at most, so that each boundary has its number.
            (0..4).for_each(|_| add(meet.next(), ratio));
        }
    }
    found.retain(|(μ, _)| *μ > 0.0 && *μ < up_to.min(LARGEST));
    found.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
    found.dedup_by(|later, earlier| {
        let same = later.0 - earlier.0 <= ONE * later.0;
        earlier.1 = if same { earlier.1.min(later.1) } else { earlier.1 };
        same
    });
    found
}

/// The frictions to slip at which two roots of a slide-rock's equation meet.
fn meeting(given: &LoadedBlock, corner: Corner, slip: Slip) -> Vec<f64> {
    let LoadedBlock { block, wrench: Wrench { p, m, .. }, strength: q } = *given;
    let Block { b1, b2, d, rho2: inertia, m_y, .. } = block;
    let (σ, b) = if corner == Corner::O { (1.0, b1) } else { (-1.0, b2) };
    debug_assert_eq!(σ, orientation(corner));
    let z = b - p / q;
    let per_friction = σ * slip.sign() * d * m_y * z;
    if per_friction >= 0.0 {
        return Vec::new();
    }
    let crush = m_y * z * z;
    let surplus = σ * m - p * b + p * p / (2.0 * q);
    let (soft, press) = (q / m_y, p / (m_y * z));
    let quartic = [
        -inertia * (soft + press),
        2.0 * soft * inertia,
        soft * (crush / 2.0 - inertia) - surplus,
        -crush * (soft + press),
        soft * crush / 2.0,
    ];
    // v from where the edge begins to be pressed, which is a = 0 for P > 0.
    let least = if p > 0.0 { 0.0 } else { -p / (m_y * b) };
    let most = 1.0 / (1.0 + m_y / q * least);
    let at = |v: f64| -(inertia + crush * v * v * v) / (v * v) / per_friction;
    real_roots(&quartic, 0.0, most).into_iter().filter(|v| *v > 0.0).map(at).collect()
}

/// Step beyond the load factor at which rest ends, relative to it, at which the verdict is looked for.
const BEYOND: f64 = 1e-9;

/// Departure under a load that rises from zero beside `permanent`: the end of rest in closed form, and the verdict just beyond it.
///
/// # Errors
/// As [`solve`].
pub fn departure(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
) -> Result<Departure, InputError> {
    let begin = solve(block, permanent, strength)?.verdict();
    if begin != Some(Verdict::REST) {
        return Ok(Departure::AtOnce { verdict: begin, permanent: true });
    }
    let range = rest_range(block, permanent, variable, strength)?;
    let factor = range.map_or(0.0, |range| range.to.max(0.0));
    if factor == f64::INFINITY {
        return Ok(Departure::Never);
    }
    let step = if factor > 0.0 { factor * (1.0 + BEYOND) } else { BEYOND };
    let verdict = solve(block, &(*permanent + *variable * step), strength)?.verdict();
    Ok(Departure::from_rest(factor, verdict))
}

/// The departures for every friction, the same to stick and to slip, up to one beyond which none is asked for. Up to the end of rest that
/// friction does not touch the body slides if the load there is more than friction holds. With more friction the body turns at that end
/// about the edge that gives way, and sticks there: its rotation begins from nothing.
///
/// # Errors
/// As [`solve`].
pub fn departure_spans(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    strength: f64,
    up_to: f64,
) -> Result<Vec<DepartureSpan>, InputError> {
    let decide = |μ: f64| departure(&Block { mu_s: μ, mu_k: μ, ..*block }, permanent, variable, strength);
    let parting = parting(permanent, variable, decide(HELD)?.load_factor());
    DepartureSpan::by_friction(parting.into(), up_to, decide)
}
