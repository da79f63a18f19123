//! Outcomes of bodies on joints: which joint leaves rest first as the variable loads rise, and how.
//!
//! Under the full load the bodies rest or not; where they do not, some joint has left rest before. Along a friction, or a number that the
//! loads are linear in, the answer changes only where a form is zero under no, under the full or under endless variable loads, or where two
//! forms are so at one load factor: all such values are known in closed form, and between two of them any value tells.

use standfast::contact::stack::RestLimit;
use standfast::contact::stack::first::{Carried, OnFriction, first_to_leave};
use standfast::ground::Base;
use standfast::{Departure, Verdict};
use standfast_probability::problem::Pieces;

use super::departure::{AT_ONCE, NEVER};
use super::lines::Line;
use super::mechanics::Mechanics;
use super::outcome::{BEARING_FAILURE, LIFTED, NOT_A_BODY, REST, nothing, of_joint, push_all, told_apart};
use super::problem::ChanceProblem;

/// What is asked of bodies on joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Asked {
    /// Whether they rest under the full load, and if not, which joint left rest first.
    Full,
    /// Which joint leaves rest first under loads that rise without end.
    Departure,
}

/// Joints under loads.
struct OnJoints {
    /// The joints that friction alone holds, from the base: all, or all above the base.
    joints: Vec<OnFriction>,
    /// The base, if there is more to it than friction.
    base: Option<OfBase>,
}

/// A base with more to it than friction.
#[derive(Clone, Copy)]
struct OfBase {
    /// λ at which the whole leaves it; infinite if it never does.
    leaves: f64,
    /// Outcome if it is the first.
    how: usize,
    /// True if the whole rests on it under the full load.
    rests: bool,
    /// True if nothing presses it under the full load.
    is_lifted: bool,
}

impl OfBase {
    /// None where the numbers do not go together.
    fn of(mechanics: &Mechanics) -> Option<OfBase> {
        let wrench = mechanics.wrench();
        let full = mechanics.base.decide(&mechanics.block, &wrench).ok()?;
        let departure = mechanics.departure()?;
        let how = match departure.verdict() {
            Some(Verdict::BearingFailure) => BEARING_FAILURE,
            verdict => {
                let mode = verdict.and_then(Verdict::mode);
                of_joint(0, mode.is_some_and(|mode| mode.corner().is_none()))
            }
        };
        let leaves = match departure {
            Departure::Never => f64::INFINITY,
            _ => departure.load_factor(),
        };
        let rests = full.verdict == Some(Verdict::REST);
        Some(OfBase { leaves, how, rests, is_lifted: wrench.p <= 0.0 })
    }
}

impl OnJoints {
    /// None where the numbers do not go together.
    fn of(mechanics: &Mechanics) -> Option<OnJoints> {
        let on = |one: &Mechanics| OnFriction::of(&one.block, &one.permanent, &one.variable);
        let above = mechanics.above.iter().map(on);
        Some(match mechanics.base {
            Base::Rigid => {
                OnJoints { joints: [on(mechanics)].into_iter().chain(above).collect(), base: None }
            }
            _ => OnJoints { joints: above.collect(), base: Some(OfBase::of(mechanics)?) },
        })
    }

    /// The outcome, and whether something is lifted, a bit for each.
    fn outcomes(&self, asked: Asked) -> u64 {
        let lifted = asked == Asked::Full
            && (self.base.is_some_and(|base| base.is_lifted)
                || self.joints.iter().any(|one| one.permanent.p + one.variable.p <= 0.0));
        1 << self.outcome(asked) | u64::from(lifted) << LIFTED
    }

    fn outcome(&self, asked: Asked) -> usize {
        let rests =
            || self.base.is_none_or(|base| base.rests) && self.joints.iter().all(|one| one.rests(1.0));
        if asked == Asked::Full && rests() {
            return REST;
        }
        let of_base = self.base.map(|base| (base.leaves, base.how)).filter(|(leaves, _)| leaves.is_finite());
        let lowest = usize::from(self.base.is_some());
        let above = first_to_leave(&self.joints).map(|(leaves, place, limit)| {
            (leaves, of_joint(lowest + place, matches!(limit, RestLimit::Slides(_))))
        });
        let first = match (of_base, above) {
            (Some(base), Some(above)) => Some(if base.0 <= above.0 { base } else { above }),
            (base, above) => base.or(above),
        };
        match first {
            // Which forms are zero but for rounding.
            None if asked == Asked::Full => REST,
            None => NEVER,
            Some((0.0, _)) if asked == Asked::Departure => AT_ONCE,
            Some((_, how)) => how,
        }
    }
}

/// The outcomes of a draw, a bit for each.
pub(super) fn outcomes(mechanics: &Mechanics, asked: Asked) -> u64 {
    OnJoints::of(mechanics).map_or(1 << NOT_A_BODY, |on| on.outcomes(asked))
}

impl ChanceProblem {
    /// The joints of bodies along a load, whose value is of no account; none where the numbers do not go together.
    fn growing(&self, place: usize, values: &[f64]) -> Option<Growing> {
        let mut values = values.to_vec();
        let mut at = |value: f64| {
            values[place] = value;
            self.mechanics(&values)
        };
        Growing::of(&at(0.0)?, &at(1.0)?)
    }

    /// The outcomes of bodies on joints with these values, a bit for each.
    pub(super) fn of_joints(&self, values: &[f64], asked: Asked) -> u64 {
        let of = match self.line {
            // Loads are not assembled again for another value of one that they are linear in.
            Line::Load(place) => self.growing(place, values).map(|growing| growing.at(values[place], asked)),
            _ => self.mechanics(values).map(|mechanics| outcomes(&mechanics, asked)),
        };
        of.unwrap_or(1 << NOT_A_BODY)
    }

    /// The outcomes of bodies on joints along the line.
    pub(super) fn joints_along(&self, values: &[f64], asked: Asked, pieces: &mut Pieces) {
        match self.line {
            Line::Friction(place) => {
                let values: Vec<f64> = values
                    .iter()
                    .enumerate()
                    .map(|(i, value)| if i == place { 1.0 } else { *value })
                    .collect();
                let Some(mechanics) = self.mechanics(&values) else { return nothing(pieces) };
                pieces.branch(u64::from(mechanics.formulas));
                along_friction(&mechanics, self.friction_of(place).unwrap_or(0), asked, pieces);
            }
            Line::Load(place) => match self.growing(place, values) {
                Some(growing) => growing.along(asked, pieces),
                None => nothing(pieces),
            },
            Line::Scan(place) => self.scan(place, values, pieces, |values| self.of_joints(values, asked)),
        }
    }
}

/// The outcomes along the friction of a joint, from the base, which is zero; the base has friction alone.
fn along_friction(mechanics: &Mechanics, joint: usize, asked: Asked, pieces: &mut Pieces) {
    let Some(mut on) = OnJoints::of(mechanics) else { return nothing(pieces) };
    // Where another joint comes first, or a turn of this one.
    on.joints[joint].mu = f64::MAX;
    let other = first_to_leave(&on.joints).map(|(factor, ..)| factor);
    let OnFriction { permanent, variable, .. } = on.joints[joint];
    let needed = |carried: &Carried| carried.x.abs() / carried.p;
    let factors = [Some(0.0), Some(1.0), other].into_iter().flatten();
    let at = factors.map(|factor| needed(&permanent.plus(factor, &variable))).chain([needed(&variable)]);
    between(at.collect(), pieces, |mu| {
        on.joints[joint].mu = mu.max(0.0);
        on.outcomes(asked)
    });
}

/// Joints under loads that are linear in a number: each where the number is zero, and what every unit of it adds to the permanent and to the
/// variable loads.
struct Growing(Vec<(OnFriction, [Carried; 2])>);

impl Growing {
    /// From what they are where the number is zero and where it is one; none where the numbers do not go together. The base has friction alone.
    fn of(at_zero: &Mechanics, at_one: &Mechanics) -> Option<Growing> {
        let (zero, one) = (OnJoints::of(at_zero)?, OnJoints::of(at_one)?);
        let adds = |zero: &OnFriction, one: &OnFriction| {
            [one.permanent.plus(-1.0, &zero.permanent), one.variable.plus(-1.0, &zero.variable)]
        };
        Some(Growing(
            zero.joints.iter().zip(&one.joints).map(|(zero, one)| (*zero, adds(zero, one))).collect(),
        ))
    }

    /// The outcomes where the number has a value, a bit for each.
    fn at(&self, value: f64, asked: Asked) -> u64 {
        let with = |(zero, [permanent, variable]): &(OnFriction, [Carried; 2])| OnFriction {
            permanent: zero.permanent.plus(value, permanent),
            variable: zero.variable.plus(value, variable),
            ..*zero
        };
        OnJoints { joints: self.0.iter().map(with).collect(), base: None }.outcomes(asked)
    }

    /// The outcomes along the number.
    fn along(&self, asked: Asked, pieces: &mut Pieces) {
        match Envelope::of(&self.0, asked) {
            Some(envelope) => envelope.push(pieces),
            None => between(changes(&self.0), pieces, |value| self.at(value, asked)),
        }
    }
}

/// A number that no permanent load depends on: 1/λ of every limit is a straight line over it, and the highest is that of the first limit.
struct Envelope {
    /// 1/λ at zero, its slope and the outcome where that is the highest; what is where none is high enough comes first.
    lines: Vec<(f64, f64, usize)>,
    /// Ends between which every joint is pressed.
    pressed: Option<(f64, f64)>,
}

impl Envelope {
    /// `None` where the permanent loads depend on the number, or take a joint to its limit.
    fn of(joints: &[(OnFriction, [Carried; 2])], asked: Asked) -> Option<Envelope> {
        let mut lines = vec![match asked {
            Asked::Full => (1.0, 0.0, REST),
            Asked::Departure => (0.0, 0.0, NEVER),
        }];
        for (place, (zero, [permanent, variable])) in joints.iter().enumerate() {
            let rests = zero.permanent.forms(zero.mu);
            if permanent.forms(zero.mu) != [0.0; 4] || rests.iter().any(|form| *form <= 0.0) {
                return None;
            }
            let (starts, slopes) = (zero.variable.forms(zero.mu), variable.forms(zero.mu));
            for (form, limit) in RestLimit::ALL.into_iter().enumerate() {
                let [start, slope] = [starts[form], slopes[form]].map(|part| -part / rests[form]);
                lines.push((start, slope, of_joint(place, matches!(limit, RestLimit::Slides(_)))));
            }
        }
        let mut pressed = (f64::NEG_INFINITY, f64::INFINITY);
        for (zero, [_, variable]) in joints.iter().filter(|_| asked == Asked::Full) {
            let (start, slope) = (zero.permanent.p + zero.variable.p, variable.p);
            match slope {
                up if up > 0.0 => pressed.0 = pressed.0.max(-start / up),
                down if down < 0.0 => pressed.1 = pressed.1.min(-start / down),
                _ if start <= 0.0 => pressed.1 = f64::NEG_INFINITY,
                _ => {}
            }
        }
        Some(Envelope { lines, pressed: (pressed.0 < pressed.1).then_some(pressed) })
    }

    fn push(&self, pieces: &mut Pieces) {
        let infinite = f64::INFINITY;
        let (from, to) = self.pressed.unwrap_or((infinite, infinite));
        pieces.push(-infinite, from, LIFTED);
        pieces.push(to.max(from), infinite, LIFTED);
        // From the left: the flattest falls from the highest, and one that is steeper takes its place where it first crosses it.
        let steeper = |one: &(f64, f64, usize), other: &(f64, f64, usize)| {
            one.1.total_cmp(&other.1).then(other.0.total_cmp(&one.0))
        };
        let Some(mut highest) = self.lines.iter().min_by(|one, other| steeper(one, other)) else { return };
        let mut stretches = Vec::new();
        let mut left = -infinite;
        loop {
            let crossing = |other: &(f64, f64, usize)| (highest.0 - other.0) / (other.1 - highest.1);
            let next = self.lines.iter().filter(|other| other.1 > highest.1);
            let next = next.map(|other| (crossing(other).max(left), other)).min_by(
                |(at, one), (other_at, other)| at.total_cmp(other_at).then(other.1.total_cmp(&one.1)),
            );
            let right = next.map_or(infinite, |(at, _)| at);
            stretches.push((left, right, 1 << highest.2, highest.2));
            let Some((at, other)) = next else { break };
            (left, highest) = (at, other);
        }
        for (from, to, outcomes, _) in told_apart(stretches.into_iter()) {
            push_all(pieces, from, to, outcomes);
        }
    }
}

/// Values of the number at which the answer may change.
fn changes(joints: &[(OnFriction, [Carried; 2])]) -> Vec<f64> {
    // Of every form a + a′x of the permanent loads, and b + b′x of the variable ones.
    let forms: Vec<[[f64; 2]; 2]> = joints
        .iter()
        .flat_map(|(zero, adds)| {
            let [permanent, variable] = [(&zero.permanent, &adds[0]), (&zero.variable, &adds[1])]
                .map(|(zero_of, adds)| [zero_of.forms(zero.mu), adds.forms(zero.mu)]);
            let line = |of: [[f64; 4]; 2], form: usize| [of[0][form], of[1][form]];
            [0, 1, 2, 3].map(|form| [line(permanent, form), line(variable, form)])
        })
        .collect();
    let root = |[start, slope]: [f64; 2]| -start / slope;
    let sum = |one: [f64; 2], two: [f64; 2]| [one[0] + two[0], one[1] + two[1]];
    let mut at: Vec<f64> = forms.iter().flat_map(|[a, b]| [root(*a), root(sum(*a, *b)), root(*b)]).collect();
    at.extend(
        joints
            .iter()
            .map(|(zero, adds)| root(sum([zero.permanent.p, adds[0].p], [zero.variable.p, adds[1].p]))),
    );
    for (place, [a, b]) in forms.iter().enumerate() {
        for [other_a, other_b] in &forms[..place] {
            // (a + a′x)(B + B′x) = (A + A′x)(b + b′x): both are zero at one λ.
            let product = |one: &[f64; 2], two: &[f64; 2]| {
                [one[0] * two[0], one[0] * two[1] + one[1] * two[0], one[1] * two[1]]
            };
            let (one, two) = (product(a, other_b), product(other_a, b));
            at.extend(roots([0, 1, 2].map(|power| one[power] - two[power])));
        }
    }
    at
}

/// The zeros of c₀ + c₁x + c₂x², without loss of digits.
fn roots([c0, c1, c2]: [f64; 3]) -> [f64; 2] {
    let half = -0.5 * (c1 + (c1 * c1 - 4.0 * c0 * c2).sqrt().copysign(c1));
    [half / c2, c0 / half]
}

/// The outcomes of a line that change at some of these values and nowhere else.
pub(super) fn between(mut at: Vec<f64>, pieces: &mut Pieces, mut outcomes: impl FnMut(f64) -> u64) {
    at.retain(|value| value.is_finite());
    at.sort_by(f64::total_cmp);
    at.dedup();
    let beyond = |value: f64, way: f64| value + way * value.abs().max(1.0);
    let mut from = f64::NEG_INFINITY;
    let mut held = outcomes(at.first().map_or(0.0, |first| beyond(*first, -1.0)));
    for (place, end) in at.iter().enumerate() {
        let next = at.get(place + 1).map_or_else(|| beyond(*end, 1.0), |next| 0.5 * (end + next));
        let holds = outcomes(next);
        if holds != held {
            push_all(pieces, from, *end, held);
            (from, held) = (*end, holds);
        }
    }
    push_all(pieces, from, f64::INFINITY, held);
}
