//! Which joint leaves rest first, in f64: for planes and for draws, of which there are many.
//!
//! Of what is above a joint, as one body, four forms are linear in the load factor, and in any number that the loads are linear in.

use super::RestLimit;
use crate::contact::Block;
use crate::wrench::Wrench;

/// What presses a joint: X to the right, P down, and the moments of both that press it down about O and about O'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// X.
    pub x: f64,
    /// P.
    pub p: f64,
    /// About O, and about O'; below zero where it turns.
    pub about: [f64; 2],
}

/// What is above a joint, as one body, at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnFriction {
    /// What the permanent loads make the joint carry.
    pub permanent: Carried,
    /// What the variable loads add at λ = 1.
    pub variable: Carried,
    /// Friction to stick.
    pub mu: f64,
}

/// Limits that are nearer to each other than this share of their load factor are reached together: equal friction ties all joints of a stack
/// that is shaken, and rounding does not untie them.
const TIED: f64 = 1e-12;

impl Carried {
    /// What a wrench at a centre, `b1` to the right of O, `b2` to the left of O' and `d` above both, makes a joint carry.
    pub fn of(wrench: &Wrench, [b1, b2]: [f64; 2], d: f64) -> Carried {
        let Wrench { x, p, m } = *wrench;
        Carried { x, p, about: [p * b1 + x * d - m, p * b2 - x * d + m] }
    }

    /// The sum with so many times another.
    pub fn plus(&self, factor: f64, other: &Carried) -> Carried {
        let sum = |own: f64, other: f64| own + factor * other;
        let about = [0, 1].map(|end| sum(self.about[end], other.about[end]));
        Carried { x: sum(self.x, other.x), p: sum(self.p, other.p), about }
    }

    /// The forms of a joint of this friction in the order of [`RestLimit::ALL`]; none is below zero while it rests.
    pub fn forms(&self, mu: f64) -> [f64; 4] {
        let [o, o_prime] = self.about;
        [mu * self.p + self.x, mu * self.p - self.x, o, o_prime]
    }
}

impl OnFriction {
    /// A block on a joint, under its loads.
    pub fn of(block: &Block, permanent: &Wrench, variable: &Wrench) -> OnFriction {
        let Block { b1, b2, d, mu_s, .. } = *block;
        let carried = |wrench: &Wrench| Carried::of(wrench, [b1, b2], d);
        OnFriction { permanent: carried(permanent), variable: carried(variable), mu: mu_s }
    }

    /// True if it rests under so many times the variable loads.
    pub fn rests(&self, factor: f64) -> bool {
        let forms = self.permanent.plus(factor, &self.variable).forms(self.mu);
        forms.iter().all(|form| *form >= 0.0)
    }
}

/// The joint whose limit is reached first as the variable loads rise, from zero in the order given, with λ, zero where the permanent loads alone
/// do it; `None` if all rest under any multiple. Of joints that reach their limits together the first is told, and of its limits the first.
pub fn first_to_leave<'a>(
    joints: impl IntoIterator<Item = &'a OnFriction>,
) -> Option<(f64, usize, RestLimit)> {
    let mut first: Option<(f64, usize, RestLimit)> = None;
    for (place, joint) in joints.into_iter().enumerate() {
        let (starts, slopes) = (joint.permanent.forms(joint.mu), joint.variable.forms(joint.mu));
        for ((start, slope), limit) in starts.into_iter().zip(slopes).zip(RestLimit::ALL) {
            if start >= 0.0 && slope >= 0.0 {
                continue;
            }
            let at = if start < 0.0 { 0.0 } else { -start / slope };
            if first.is_none_or(|(least, ..)| at < least * (1.0 - TIED)) {
                first = Some((at, place, limit));
            }
        }
    }
    first
}
