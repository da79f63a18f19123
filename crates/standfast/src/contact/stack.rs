//! Bodies on bodies: which joint of a stack moves first, and every combination of modes that it can begin with.
//!
//! ```text
//!         ┌────────┐            body 2: C₂ at (x₂, y₂)
//!         │   C₂   │
//!      O₂ ▼────────▼ O'₂        joint 2: from l₂ to r₂ at the height h₂
//!     ┌────────────────┐
//!     │       C₁       │        body 1
//!  O₁ ▼────────────────▼ O'₁    joint 1: its base on the ground, body 0
//! ```
//!
//! Joint *i* lies between the bodies *i*−1 and *i*, level, with friction μ_s to stick and μ_k to slip, and without tension. Body *j* has the
//! inertias m_x, m_y and I about its centre, and there the wrench X to the right, P downwards with the weight and M counter-clockwise, each
//! permanent + λ variable. Any units that go together will do.
//!
//! # Rest
//!
//! While nothing moves each joint carries what stands above it, whatever the others do. With X, P the sums over the bodies above joint *i* and
//! G = Σ [M − X (y − h) − P x], their moment about (0, h), the stack rests if and only if for every joint
//!
//! ```text
//! μ_s P ± X ≥ 0        −G − l P ≥ 0, else it turns about O        r P + G ≥ 0, else about O'
//! ```
//!
//! These 4n forms are linear in λ: the load factor at which the stack leaves rest is the least zero among those that fall.
//!
//! # All at once
//!
//! q = (t, v, ω) of joint *i* is the acceleration of body *i* relative to the body below, right and up, of the point (0, h), and the relative
//! rotation; dual to it is the reaction (f, N, G) on body *i*. With 𝓜 the mass matrix in these coordinates and Q the loads, 𝓜 q = Q + R. Each
//! joint goes into one of the ten modes of the [contact problem](super), of motions B (q = B z) and of rows N with Nᵀ R = 0:
//!
//! | mode | motions | rows | conditions |
//! |---|---|---|---|
//! | rest | none | none | μ_sN ± f ≥ 0, G − lN ≥ 0, rN − G ≥ 0 |
//! | slide s = ±1 | (1, 0, 0) | (1, sμ_k, 0) | s t > 0, G − lN ≥ 0, rN − G ≥ 0 |
//! | rock about c | (0, −c, 1) | (0, −c, 1) | σω > 0, N ≥ 0, μ_sN ± f ≥ 0 |
//! | slide-rock about c, s | (1, 0, 0), (0, −c, 1) | (1, sμ_k, 0), (0, −c, 1) | σω > 0, N ≥ 0, s t > 0 |
//! | flight | all | all | v + lω ≥ 0, v + rω ≥ 0 |
//!
//! c = l and σ = 1 at O, c = r and σ = −1 at O'. A combination is one mode a joint, 10ⁿ in all; D = det(NᵀMB) is its *orientation*. For
//! μ_s = μ_k some combination is consistent for every load, and for almost every load the number of them with D > 0 is one more than of those
//! with D < 0; where D > 0 for all of them the answer is unique. With μ_k < μ_s there is one still.
//!
//! From rest, stick is tried before slip. Of the consistent combinations one is struck out
//!
//! * if another has slip in fewer joints: none slips that does not slip in the first, those that slip in both have the same mode, and one
//!   with μ_s > μ_k sticks there at the same contact;
//! * of those left, if a joint with μ_s > μ_k slides though friction would hold it, all else being the same; unless that leaves none.
//!
//! The one reported has D > 0 rather than D < 0 and, joint by joint from the ground up, the first of rest, slide, slide-rock, rock, flight, O
//! before O' and left before right.
//!
//! Signs are decided exactly for the f64 given. Under a base acceleration keep weight and inertia as products ([`Shaking`]): equal friction
//! then ties all joints, |X|/P being the same in each, and no product may be rounded.
//!
//! Limits: flat and rigid faces, level joints, the first instant. Races of joints that each would hold if another slipped first, and what is
//! above Painlevé's bound, which falls with the number of bodies, have several answers: all are listed.
//!
//! ```
//! use standfast::contact::stack::{Joint, Shaking, Stack, StackBody};
//!
//! // Two cubes of side 2 under a base that starts to the right with 0.8 g; friction 0.7 below and 0.3 between.
//! let cube = |y| StackBody { y, ..StackBody::of(1.0, 2.0 / 3.0) };
//! let joint = |h, mu| Joint { h, l: -1.0, r: 1.0, mu_s: mu, mu_k: mu };
//! let stack = Stack {
//!     bodies: vec![cube(1.0), cube(3.0)],
//!     joints: vec![joint(0.0, 0.7), joint(2.0, 0.3)],
//!     shaking: Shaking { gravity: 1.0, horizontal: 0.8, ..Shaking::default() },
//! };
//! let departure = stack.departure()?;
//! assert!((departure.load_factor - 0.375).abs() < 1e-15); // 0.3/0.8
//! assert_eq!(departure.joints(), [1]); // the upper joint
//! let symbols: Vec<_> = departure.answer.modes().iter().map(|mode| mode.symbol()).collect();
//! assert_eq!(symbols, ["RE", "SL"]);
//! # Ok::<(), standfast::contact::stack::StackError>(())
//! ```

mod check;
mod choice;
pub mod first;
mod laws;
pub mod plane;
mod recursion;
mod rest;
mod system;

use std::cell::OnceCell;

use crate::approx::Approx;
use crate::ball::{Ball, Scalar};
use crate::error::InputError;
use crate::exact::Real;
use crate::mode::Mode;
use crate::quantity::Quantity;
use crate::wrench::Wrench;

pub use check::StackError;
pub(crate) use rest::Leaving;
pub use rest::RestLimit;
use system::System;

/// The largest number of bodies whose combinations are enumerated: ten times as many with each.
pub const MOST: usize = 6;

/// A body of a stack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StackBody<T = f64> {
    /// m_x > 0: inertia against ẍ; with added mass more than the mass.
    pub m_x: T,
    /// m_y > 0: inertia against ÿ.
    pub m_y: T,
    /// I > 0: inertia against rotation, about the centre.
    pub inertia: T,
    /// The centre, to the right of the origin.
    pub x: T,
    /// The centre, above the origin.
    pub y: T,
    /// The loads at the centre that are there all the time.
    pub permanent: Wrench<T>,
    /// The loads at the centre that grow together.
    pub variable: Wrench<T>,
}

impl StackBody {
    /// A body of a mass and an inertia about its centre, which is at the origin, without loads.
    pub fn of(mass: f64, inertia: f64) -> StackBody {
        let none = Wrench::ZERO;
        StackBody { m_x: mass, m_y: mass, inertia, x: 0.0, y: 0.0, permanent: none, variable: none }
    }
}

/// A joint: the base of a body on the one below, or on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint<T = f64> {
    /// Its height.
    pub h: T,
    /// O, its left end.
    pub l: T,
    /// O', its right end, beyond the left one.
    pub r: T,
    /// μ_s ≥ μ_k: friction to stick.
    pub mu_s: T,
    /// μ_k ≥ 0: friction to slip.
    pub mu_k: T,
}

/// Weight and inertia of all bodies, as products that are not rounded.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shaking {
    /// g ≥ 0: adds m_y g (1 + `vertical`) to each P.
    pub gravity: f64,
    /// Acceleration of the base to the right, in g: adds −m_x g `horizontal` to each variable X.
    pub horizontal: f64,
    /// Acceleration of the base upwards, in g.
    pub vertical: f64,
    /// True if the horizontal one is there all the time: it adds to the permanent X.
    pub permanent: bool,
}

/// Bodies on joints, from the ground up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stack {
    /// The bodies.
    pub bodies: Vec<StackBody>,
    /// The joint below each body.
    pub joints: Vec<Joint>,
    /// Weight and inertia beside the loads of the bodies.
    pub shaking: Shaking,
}

/// The numbers of a stack in some arithmetic: weight and inertia are among the loads.
pub(crate) struct StackNumbers<T> {
    pub(crate) bodies: Vec<StackBody<T>>,
    pub(crate) joints: Vec<Joint<T>>,
}

/// Where a stack leaves rest as its variable loads rise from nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct StackDeparture {
    /// λ at which it does: zero if it moves at once, infinite if it never does.
    pub load_factor: f64,
    /// True if the permanent loads alone move it.
    pub at_once: bool,
    /// The limits that are reached, each with its joint from the ground up, from zero; where permanent loads alone move it, those that are
    /// passed.
    pub limits: Vec<(usize, RestLimit)>,
    /// The combinations that begin with any more load; none where it never leaves rest, and of a stack of more bodies than are
    /// [enumerated](MOST).
    pub answer: StackAnswer,
}

/// Load factors between which a stack that is loaded in proportion keeps its modes.
#[derive(Debug, Clone, PartialEq)]
pub struct StackStage {
    /// The load factor at which it begins.
    pub from: f64,
    /// The load factor at which it ends; infinite for the last.
    pub to: f64,
    /// The mode of each joint, from the ground up.
    pub modes: Vec<Mode>,
    /// Other combinations that are as consistent where it begins.
    pub others: Vec<Vec<Mode>>,
}

/// The combinations of modes that a stack can begin with.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StackAnswer {
    combinations: Vec<Combination>,
    motion: Option<StackMotion>,
}

/// A consistent combination.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Combination {
    /// The mode of each joint, from the ground up.
    pub modes: Vec<Mode>,
    /// True if its orientation D is above zero, as of all below Painlevé's bound.
    pub regular: bool,
    /// Joints that touch and are not pressed.
    unpressed: u8,
}

/// The first motion of a stack, in the units of its numbers; on a base that is shaken, relative to it.
#[derive(Debug, Clone, PartialEq)]
pub struct StackMotion {
    /// The joints, from the ground up.
    pub joints: Vec<JointMotion>,
    /// The bodies, from the ground up.
    pub bodies: Vec<BodyMotion>,
}

/// Acceleration and reaction of a joint: of the body above relative to the one below, and on the body above.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointMotion {
    /// Acceleration to the right along the joint.
    pub t: f64,
    /// Acceleration upwards of the point (0, h), which need not be on the body.
    pub v: f64,
    /// Angular acceleration, counter-clockwise.
    pub omega: f64,
    /// Friction, to the right.
    pub f: f64,
    /// Normal reaction, upwards.
    #[cfg_attr(feature = "serde", serde(rename = "N"))]
    pub n: f64,
    /// Where it acts, to the right of the origin; zero where there is none.
    pub xi: f64,
}

/// Accelerations of the centre of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BodyMotion {
    /// To the right.
    pub x_ddot: f64,
    /// Upwards.
    pub y_ddot: f64,
    /// Counter-clockwise.
    pub theta_ddot: f64,
}

impl StackDeparture {
    /// The joints whose limits are reached, from the ground up, from zero.
    pub fn joints(&self) -> Vec<usize> {
        let mut joints: Vec<usize> = self.limits.iter().map(|(joint, _)| *joint).collect();
        joints.dedup();
        joints
    }
}

impl StackAnswer {
    /// The combination reported, a mode for each joint from the ground up; empty where there is none.
    pub fn modes(&self) -> &[Mode] {
        self.combinations.first().map_or(&[], |first| &first.modes)
    }

    /// The other combinations that are as consistent.
    pub fn others(&self) -> impl Iterator<Item = &[Mode]> {
        self.combinations.iter().skip(1).map(|one| one.modes.as_slice())
    }

    /// True if there is one.
    pub fn is_unique(&self) -> bool {
        self.combinations.len() == 1
    }

    /// All of them, the one reported first.
    pub fn combinations(&self) -> &[Combination] {
        &self.combinations
    }

    /// The motion of the one reported.
    pub fn motion(&self) -> Option<&StackMotion> {
        self.motion.as_ref()
    }
}

impl Stack {
    /// Its numbers with weight and inertia among the loads.
    fn numbers<T: Real>(&self) -> StackNumbers<T> {
        let of = T::of;
        let wrench = |wrench: Wrench| Wrench { x: of(wrench.x), p: of(wrench.p), m: of(wrench.m) };
        let Shaking { gravity, horizontal, vertical, permanent } = self.shaking;
        let bodies = self.bodies.iter().map(|body| {
            let (mut steady, mut growing) = (wrench(body.permanent), wrench(body.variable));
            steady.p = steady.p + of(body.m_y) * of(gravity) * (of(1.0) + of(vertical));
            let push = -(of(body.m_x) * of(gravity) * of(horizontal));
            let pushed = if permanent { &mut steady.x } else { &mut growing.x };
            *pushed = pushed.clone() + push;
            StackBody {
                m_x: of(body.m_x),
                m_y: of(body.m_y),
                inertia: of(body.inertia),
                x: of(body.x),
                y: of(body.y),
                permanent: steady,
                variable: growing,
            }
        });
        let joints = self.joints.iter().map(|joint| Joint {
            h: of(joint.h),
            l: of(joint.l),
            r: of(joint.r),
            mu_s: of(joint.mu_s),
            mu_k: of(joint.mu_k),
        });
        StackNumbers { bodies: bodies.collect(), joints: joints.collect() }
    }

    fn decider(&self) -> Result<Decider<'_>, StackError> {
        self.check()?;
        Ok(Decider::new(self.numbers(), Box::new(|| self.numbers())))
    }

    /// The same of a stack whose combinations are enumerated.
    fn enumerated(&self) -> Result<Decider<'_>, StackError> {
        let decider = self.decider()?;
        if decider.is_enumerable() { Ok(decider) } else { Err(StackError::TooMany(self.bodies.len())) }
    }

    /// Where it leaves rest as its variable loads rise from nothing, and into which modes.
    ///
    /// # Errors
    /// If it is no stack.
    pub fn departure(&self) -> Result<StackDeparture, StackError> {
        Ok(self.decider()?.departure())
    }

    /// What it begins with under the permanent loads and so many times the variable ones, applied at once.
    ///
    /// # Errors
    /// If it is no stack, or has more bodies than are [enumerated](MOST).
    pub fn answer(&self, load_factor: f64) -> Result<StackAnswer, StackError> {
        let at = LoadPoint::given(load_factor)?;
        Ok(self.enumerated()?.answer(&at))
    }

    /// The modes as the variable loads rise from nothing without end: a combination stays until one of its conditions fails.
    ///
    /// # Errors
    /// As [`answer`](Stack::answer).
    ///
    /// ```
    /// use standfast::contact::stack::{Joint, Stack, StackBody};
    /// use standfast::Wrench;
    ///
    /// // The lower of two flat slabs of weight 1 is pulled: both slide, then it is pulled from under the upper one.
    /// let slab = |y, x| StackBody {
    ///     y,
    ///     permanent: Wrench { x: 0.0, p: 1.0, m: 0.0 },
    ///     variable: Wrench { x, p: 0.0, m: 0.0 },
    ///     ..StackBody::of(1.0, 1.0)
    /// };
    /// let joint = |h| Joint { h, l: -5.0, r: 5.0, mu_s: 0.5, mu_k: 0.5 };
    /// let stack = Stack {
    ///     bodies: vec![slab(0.1, 1.0), slab(0.3, 0.0)],
    ///     joints: vec![joint(0.0), joint(0.2)],
    ///     ..Stack::default()
    /// };
    /// let path = stack.path()?;
    /// let stages: Vec<_> = path.iter().map(|stage| (stage.from, stage.modes[0].symbol(), stage.modes[1].symbol())).collect();
    /// assert_eq!(stages, [(0.0, "RE", "RE"), (1.0, "SL+", "RE"), (2.0, "SL+", "SL")]);
    /// # Ok::<(), standfast::contact::stack::StackError>(())
    /// ```
    pub fn path(&self) -> Result<Vec<StackStage>, StackError> {
        Ok(self.enumerated()?.path(f64::INFINITY))
    }

    /// Every combination whose conditions hold then, before stick is tried before slip, each motion once.
    ///
    /// # Errors
    /// As [`answer`](Stack::answer).
    pub fn every_combination(&self, load_factor: f64) -> Result<Vec<Combination>, StackError> {
        let at = LoadPoint::given(load_factor)?;
        Ok(self.enumerated()?.consistent(&at))
    }

    /// D = det(NᵀMB) of a combination, one mode a joint from the ground up, in the units of its numbers; no load changes it. Where it is
    /// above zero for all combinations the answer is unique under every load.
    ///
    /// # Errors
    /// If it is no stack, or has another number of joints than there are modes.
    pub fn orientation(&self, modes: &[Mode]) -> Result<f64, StackError> {
        let decider = self.decider()?;
        if modes.len() != self.joints.len() {
            return Err(StackError::Modes { modes: modes.len(), joints: self.joints.len() });
        }
        Ok(decider.orientation(modes))
    }
}

/// A load factor, as a fraction: what it is above and below the line, the latter above zero.
#[derive(Debug, Clone)]
struct LoadPoint {
    above: Ball,
    below: Ball,
    /// True of any load beyond it, however little: a condition that is zero there has the sign of its slope.
    beyond: bool,
}

impl LoadPoint {
    /// A load factor that a caller gives.
    fn given(factor: f64) -> Result<LoadPoint, InputError> {
        InputError::finite(Quantity::LoadFactor, factor).map(LoadPoint::of)
    }

    fn of(factor: f64) -> LoadPoint {
        LoadPoint { above: Ball::of(factor), below: Ball::of(1.0), beyond: false }
    }

    /// λ.
    fn factor(&self) -> Ball {
        self.above.clone() / self.below.clone()
    }
}

/// A stack in two arithmetics: rounding that is tracked, and none, where that cannot tell.
pub(crate) struct Decider<'a> {
    approx: StackNumbers<Approx>,
    /// Its numbers without rounding, made where they are asked for.
    make: Box<dyn Fn() -> StackNumbers<Ball> + 'a>,
    exact: OnceCell<StackNumbers<Ball>>,
    /// So many of the lowest joints are of no account for where it leaves rest: something else says that of them.
    skipped: usize,
    /// Their equations in full.
    system: OnceCell<System<Ball>>,
    tracked: OnceCell<System<Approx>>,
}

impl<'a> Decider<'a> {
    pub(crate) fn new(
        approx: StackNumbers<Approx>,
        make: Box<dyn Fn() -> StackNumbers<Ball> + 'a>,
    ) -> Decider<'a> {
        Decider {
            approx,
            make,
            exact: OnceCell::new(),
            skipped: 0,
            system: OnceCell::new(),
            tracked: OnceCell::new(),
        }
    }

    /// The stack, so many of the lowest joints of no account for where it leaves rest.
    pub(crate) fn above(self, skipped: usize) -> Decider<'a> {
        Decider { skipped, ..self }
    }

    fn exact(&self) -> &StackNumbers<Ball> {
        self.exact.get_or_init(&self.make)
    }

    /// True if its combinations are enumerated.
    pub(crate) fn is_enumerable(&self) -> bool {
        self.approx.bodies.len() <= MOST
    }

    /// Where the stack leaves rest.
    fn departure(&self) -> StackDeparture {
        let leaving = self.leaving();
        let at = self.point(&leaving);
        let answer = match &at {
            Some(at) if self.is_enumerable() => self.answer(at),
            _ => StackAnswer::default(),
        };
        let load_factor = at.map_or(f64::INFINITY, |at| at.factor().value());
        StackDeparture { load_factor, at_once: leaving.at_once, limits: leaving.limits, answer }
    }

    /// The combinations just beyond a point of the load where it leaves rest.
    pub(crate) fn departing(&self, leaving: &Leaving) -> StackAnswer {
        self.point(leaving).map_or_else(StackAnswer::default, |at| self.answer(&at))
    }

    /// The combinations under a load that is applied at once.
    pub(crate) fn at_once(&self, load_factor: f64) -> StackAnswer {
        self.answer(&LoadPoint::of(load_factor))
    }

    /// The modes reported under so many times the variable loads, without their motion; none where no combination is consistent.
    pub(crate) fn modes_at_once(&self, load_factor: f64) -> Vec<Mode> {
        let at = LoadPoint::of(load_factor);
        self.chosen(self.consistent(&at), &at).into_iter().next().map_or_else(Vec::new, |first| first.modes)
    }

    /// The stages of the variable loads that rise up to a factor, the last of which ends where it does.
    pub(crate) fn path(&self, up_to: f64) -> Vec<StackStage> {
        let mut stages: Vec<StackStage> = Vec::new();
        let mut next = Some(LoadPoint { beyond: true, ..LoadPoint::of(0.0) });
        while let Some(at) = next.take() {
            let combinations = self.chosen(self.consistent(&at), &at);
            let from = at.factor().value();
            let Some((first, others)) = combinations.split_first() else { break };
            next = self.fails(&first.modes, &at);
            let to = next.as_ref().map_or(f64::INFINITY, |at| at.factor().value());
            let others = others.iter().map(|one| one.modes.clone()).collect();
            stages.push(StackStage { from, to, modes: first.modes.clone(), others });
            next = next.filter(|_| to < up_to);
        }
        stages
    }

    /// The combinations under a load, and the motion of the one reported.
    fn answer(&self, at: &LoadPoint) -> StackAnswer {
        let combinations = self.chosen(self.consistent(at), at);
        let motion = combinations.first().and_then(|first| self.motion(&first.modes, at));
        StackAnswer { combinations, motion }
    }
}
