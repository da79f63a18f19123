//! Bodies on joints under loads: each joint carries all that is above it, as one body; and all joints together.
//!
//! What is above a joint is a [situation](Situation) of its own, so that its factors, its pressure and its departure are found as those of any
//! body. Of two that follow each other the difference is the body between: its mass, its centre and what acts on it. The sums stay sums of
//! products, so that nothing that is equal is told apart by rounding.

use std::cmp::Ordering;
use std::convert::Infallible;

use crate::approx::Approx;
use crate::ball::{Ball, Scalar};
use crate::contact::stack::first::{Carried, OnFriction, first_to_leave};
use crate::contact::stack::plane::{StackPlane, plane_of};
use crate::contact::stack::{
    Decider, Joint, Leaving, MOST, RestLimit, StackAnswer, StackBody, StackNumbers, StackStage,
};
use crate::departure::Departure;
use crate::exact::Real;
use crate::loads::AboveJoint;
use crate::mode::Mode;
use crate::wrench::Wrench;

use super::{SUMMED, Situation};

/// All that is above a joint, under its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct OnJoint<T = f64> {
    /// As one body.
    pub situation: Situation<T>,
    /// The joint above the base of the whole, m.
    level: T,
    /// Mid-width of the body to the right of that of the whole, m.
    shift: T,
}

/// Bodies on joints, from the base up: what is above each joint, the whole first.
#[derive(Debug, Clone, PartialEq)]
pub struct Jointed<T = f64>(Vec<OnJoint<T>>);

/// Where bodies on joints leave rest as their variable loads rise.
#[derive(Debug, Clone, PartialEq)]
pub struct JointDeparture {
    /// λ; zero where the permanent loads alone move them, infinite if they never leave rest.
    pub load_factor: f64,
    /// True if the permanent loads alone move them.
    pub at_once: bool,
    /// The limits that are reached, each with its joint from the base, from zero; of a base with more to it than friction none is named.
    pub limits: Vec<(usize, Option<RestLimit>)>,
}

/// What all joints do together.
#[derive(Debug, Clone, PartialEq)]
pub struct JointAnswer {
    /// What begins as the variable loads pass where the bodies leave rest.
    pub departing: StackAnswer,
    /// What begins under the full load, applied at once.
    pub full: StackAnswer,
}

impl JointDeparture {
    /// The joints whose limits are reached, from the base, from zero.
    pub fn joints(&self) -> Vec<usize> {
        let mut joints: Vec<usize> = self.limits.iter().map(|(joint, _)| *joint).collect();
        joints.dedup();
        joints
    }
}

impl<T: Scalar> OnJoint<T> {
    /// The whole on its base.
    pub fn whole(situation: Situation<T>) -> OnJoint<T> {
        OnJoint { situation, level: T::of(0.0), shift: T::of(0.0) }
    }

    /// What is above a joint, under its loads.
    pub fn above(joint: &AboveJoint<T>, situation: Situation<T>) -> OnJoint<T> {
        OnJoint { situation, level: joint.level(), shift: joint.shift() }
    }
}

impl<T: Scalar> Jointed<T> {
    /// Bodies on joints, what is above each from the base up.
    pub fn new(above: Vec<OnJoint<T>>) -> Jointed<T> {
        Jointed(above)
    }

    /// What is above each joint, from the base up.
    pub fn joints(&self) -> &[OnJoint<T>] {
        &self.0
    }

    /// True if what all joints do together is found: of six bodies at most.
    pub fn is_enumerable(&self) -> bool {
        self.0.len() <= MOST
    }
}

impl Jointed {
    /// Where the bodies leave rest. `of_base` is where the whole leaves its base, if more than friction has to do with that: the lowest joint is
    /// then of no account. `written` has the same in the numbers as they are written, which decide where f64 cannot.
    pub fn departure(
        &self,
        of_base: Option<&Departure>,
        written: &dyn Fn() -> Option<Jointed<Ball>>,
    ) -> JointDeparture {
        let Leaving { load_factor, at_once, limits } =
            self.decider(written).above(usize::from(of_base.is_some())).leaving();
        let limits = limits.into_iter().map(|(joint, limit)| (joint, Some(limit)));
        let above = JointDeparture { load_factor, at_once, limits: limits.collect() };
        let Some(base) = of_base else { return above };
        let permanent = matches!(base, Departure::AtOnce { permanent: true, .. });
        let of_base =
            JointDeparture { load_factor: base.load_factor(), at_once: permanent, limits: vec![(0, None)] };
        let order = |departure: &JointDeparture| (!departure.at_once, departure.load_factor);
        match order(&of_base).partial_cmp(&order(&above)) {
            _ if of_base.load_factor == f64::INFINITY => above,
            Some(Ordering::Less) => of_base,
            Some(Ordering::Equal) => {
                JointDeparture { limits: [of_base.limits, above.limits].concat(), ..above }
            }
            _ => above,
        }
    }

    /// What all joints do together, of [so many bodies](Jointed::is_enumerable); `written` as in [`departure`](Jointed::departure).
    pub fn answer(&self, written: &dyn Fn() -> Option<Jointed<Ball>>) -> JointAnswer {
        let decider = self.decider(written);
        JointAnswer { departing: decider.departing(&decider.leaving()), full: decider.at_once(1.0) }
    }

    /// The stages of the variable loads that rise up to a factor, of [so many bodies](Jointed::is_enumerable); none where all loads are
    /// permanent. `written` as in [`departure`](Jointed::departure).
    pub fn path(&self, up_to: f64, written: &dyn Fn() -> Option<Jointed<Ball>>) -> Vec<StackStage> {
        let varies = self.0.iter().any(|on| on.situation.loads.iter().any(|load| !load.permanent));
        let stages = if varies { self.decider(written).path(up_to) } else { Vec::new() };
        let within = stages.into_iter().filter(|stage| stage.from < up_to);
        within.map(|stage| StackStage { to: stage.to.min(up_to), ..stage }).collect()
    }

    /// Where which joint is the first to leave rest, and how: over the load factor up to `up_to`, and over the friction of the base up to
    /// `friction`, that of the other joints in proportion. `None` of a base without friction.
    ///
    /// Forces and moments of each joint are linear in λ, and its two limits of friction in μ.
    pub fn departures(&self, [up_to, friction]: [f64; 2]) -> Option<StackPlane> {
        let of_base = self.0.first()?.situation.static_friction();
        let all: Vec<OnFriction> = self.0.iter().map(|on| on.sum().on_friction()).collect();
        let decide = |factor: f64, mu: f64| {
            let joints: Vec<OnFriction> =
                all.iter().map(|joint| OnFriction { mu: joint.mu * mu / of_base, ..*joint }).collect();
            let first = first_to_leave(&joints);
            let mut found = vec![Mode::Rest; joints.len()];
            if let Some((_, joint, limit)) = first.filter(|(at, ..)| *at < factor) {
                found[joint] = limit.mode();
            }
            Ok::<_, Infallible>(found)
        };
        if of_base <= 0.0 {
            return None;
        }
        plane_of(decide, [up_to, friction]).ok()
    }

    /// What all joints do under the full load times λ, applied at once, over λ up to `up_to` and the friction of the base up to `friction`, that of
    /// the other joints in proportion. `None` of a base without friction, and of more than two bodies.
    pub fn all_at_once(&self, [up_to, friction]: [f64; 2]) -> Option<StackPlane> {
        let of_base = self.0.first()?.situation.static_friction();
        if of_base <= 0.0 || self.0.len() > MOST_IN_PLANE {
            return None;
        }
        let all: Vec<Sum<Approx>> = self.0.iter().map(OnJoint::tracked).collect();
        let decide = |factor: f64, mu: f64| {
            let ratio = mu / of_base;
            let scaled = |sum: &Sum<Approx>| {
                let mut sum = sum.clone();
                for friction in [&mut sum.joint.mu_s, &mut sum.joint.mu_k] {
                    let value = friction.value() * ratio;
                    *friction = Approx::around(value, f64::EPSILON * value);
                }
                sum
            };
            let sums: Vec<Sum<Approx>> = all.iter().map(scaled).collect();
            let exact = || numbers(&as_they_are(&sums));
            let decider = Decider::new(numbers(&sums), Box::new(exact));
            Ok::<_, Infallible>(decider.modes_at_once(factor))
        };
        plane_of(decide, [up_to, friction]).ok()
    }

    fn decider<'a>(&'a self, written: &'a dyn Fn() -> Option<Jointed<Ball>>) -> Decider<'a> {
        let rounded = || self.0.iter().map(OnJoint::tracked).collect::<Vec<_>>();
        let make = move || {
            let exact = written().map(|jointed| jointed.0.iter().map(OnJoint::sum).collect::<Vec<_>>());
            // Without others these are the numbers.
            let exact = exact.unwrap_or_else(|| as_they_are(&rounded()));
            numbers(&exact)
        };
        Decider::new(numbers(&rounded()), Box::new(make))
    }
}

/// All that is above a joint in numbers of the whole's frame: to the right of mid-width, above the base.
#[derive(Debug, Clone)]
struct Sum<T> {
    mass: T,
    /// Of the water that moves with it.
    added: T,
    /// About its centre.
    inertia: T,
    centre: [T; 2],
    joint: Joint<T>,
    /// At its centre.
    permanent: Wrench<T>,
    variable: Wrench<T>,
}

impl<T> Sum<T> {
    fn map<U>(&self, of: impl Fn(&T) -> U) -> Sum<U> {
        let wrench = |wrench: &Wrench<T>| Wrench { x: of(&wrench.x), p: of(&wrench.p), m: of(&wrench.m) };
        let Joint { h, l, r, mu_s, mu_k } = &self.joint;
        Sum {
            mass: of(&self.mass),
            added: of(&self.added),
            inertia: of(&self.inertia),
            centre: self.centre.each_ref().map(&of),
            joint: Joint { h: of(h), l: of(l), r: of(r), mu_s: of(mu_s), mu_k: of(mu_k) },
            permanent: wrench(&self.permanent),
            variable: wrench(&self.variable),
        }
    }
}

impl Sum<f64> {
    fn on_friction(&self) -> OnFriction {
        let ([x, y], Joint { h, l, r, mu_s, .. }) = (self.centre, &self.joint);
        let carried = |wrench: &Wrench| Carried::of(wrench, [x - l, r - x], y - h);
        OnFriction { permanent: carried(&self.permanent), variable: carried(&self.variable), mu: *mu_s }
    }
}

impl<T: Scalar> OnJoint<T> {
    fn sum(&self) -> Sum<T> {
        let OnJoint { situation, level, shift } = self;
        let body = situation.body();
        let sums = situation.sums();
        let edges = body.base_edges();
        Sum {
            mass: body.mass(),
            added: situation.added_mass(),
            inertia: body.moment_of_inertia(),
            centre: [shift.clone() + body.centroid_offset(), level.clone() + body.centroid_height()],
            joint: Joint {
                h: level.clone(),
                l: shift.clone() - edges.left,
                r: shift.clone() + edges.right,
                mu_s: situation.static_friction(),
                mu_k: situation.kinetic_friction(),
            },
            permanent: sums.permanent,
            variable: sums.variable,
        }
    }
}

impl OnJoint {
    /// Its numbers with how far rounding may have moved them.
    fn tracked(&self) -> Sum<Approx> {
        let body = self.situation.body();
        let reach = body.width() + body.height() + body.base_width();
        let sum = self.sum();
        let lengths = sum.joint.h.abs() + sum.joint.l.abs().max(sum.joint.r.abs()) + reach;
        let rough = |value: &f64, size: f64| Approx::around(*value, SUMMED * size);
        let mut sizes = [Wrench::ZERO; 2];
        for load in &self.situation.loads {
            let wrench = self.situation.wrench_of(load);
            let [x, p] = [wrench.x.abs(), wrench.p.abs()];
            let size = Wrench { x, p, m: wrench.m.abs() + (x + p) * reach };
            let sum = &mut sizes[usize::from(!load.permanent)];
            *sum = *sum + size;
        }
        let wrench = |wrench: &Wrench, size: Wrench| Wrench {
            x: rough(&wrench.x, size.x),
            p: rough(&wrench.p, size.p),
            m: rough(&wrench.m, size.m),
        };
        let same = |value: &f64| rough(value, value.abs());
        let length = |value: &f64| if *value == 0.0 { Approx::ZERO } else { rough(value, lengths) };
        let Joint { h, l, r, mu_s, mu_k } = sum.joint;
        Sum {
            mass: same(&sum.mass),
            added: same(&sum.added),
            inertia: same(&sum.inertia),
            centre: sum.centre.each_ref().map(length),
            joint: Joint {
                h: length(&h),
                l: length(&l),
                r: length(&r),
                mu_s: Approx::around(mu_s, f64::EPSILON * mu_s),
                mu_k: Approx::around(mu_k, f64::EPSILON * mu_k),
            },
            permanent: wrench(&sum.permanent, sizes[0]),
            variable: wrench(&sum.variable, sizes[1]),
        }
    }
}

/// Tracked numbers without how far rounding may have moved them.
fn as_they_are(sums: &[Sum<Approx>]) -> Vec<Sum<Ball>> {
    sums.iter().map(|sum| sum.map(|number: &Approx| Ball::of(number.value()))).collect()
}

/// Number of bodies up to which what all joints do is found over a plane: in a third of a second, where three take ten times as long.
const MOST_IN_PLANE: usize = 2;

/// The bodies between the joints, each what is above its joint less what is above the next.
fn numbers<T: Real + std::ops::Div<Output = T>>(above: &[Sum<T>]) -> StackNumbers<T> {
    let next = above.iter().skip(1).map(Some).chain([None]);
    let bodies = above.iter().zip(next).map(|(own, next)| between(own, next));
    StackNumbers { bodies: bodies.collect(), joints: above.iter().map(|own| own.joint.clone()).collect() }
}

fn between<T: Real + std::ops::Div<Output = T>>(own: &Sum<T>, next: Option<&Sum<T>>) -> StackBody<T> {
    let Some(next) = next else {
        let [x, y] = own.centre.clone();
        return StackBody {
            m_x: own.mass.clone() + own.added.clone(),
            m_y: own.mass.clone(),
            inertia: own.inertia.clone(),
            x,
            y,
            permanent: own.permanent.clone(),
            variable: own.variable.clone(),
        };
    };
    let mass = own.mass.clone() - next.mass.clone();
    let first = |along: usize| {
        let moment = |sum: &Sum<T>| sum.mass.clone() * sum.centre[along].clone();
        (moment(own) - moment(next)) / mass.clone()
    };
    let centre = [first(0), first(1)];
    // From the centre of the body: what is far away from it costs digits.
    let about = |sum: &Sum<T>| {
        let apart = |along: usize| sum.centre[along].clone() - centre[along].clone();
        let [x, y] = [apart(0), apart(1)];
        sum.inertia.clone() + sum.mass.clone() * (x.clone() * x + y.clone() * y)
    };
    let load = |of: fn(&Sum<T>) -> &Wrench<T>| {
        let at_centre = |sum: &Sum<T>| {
            let Wrench { x, p, m } = of(sum).clone();
            let [right, up] = [0, 1].map(|along| sum.centre[along].clone() - centre[along].clone());
            let m = m - right * p.clone() - up * x.clone();
            Wrench { x, p, m }
        };
        let (own, next) = (at_centre(own), at_centre(next));
        Wrench { x: own.x - next.x, p: own.p - next.p, m: own.m - next.m }
    };
    let [x, y] = centre.clone();
    StackBody {
        m_x: mass.clone() + own.added.clone() - next.added.clone(),
        m_y: mass.clone(),
        inertia: about(own) - about(next),
        x,
        y,
        permanent: load(|sum| &sum.permanent),
        variable: load(|sum| &sum.variable),
    }
}
