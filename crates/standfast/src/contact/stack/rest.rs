//! Rest of a stack: each joint carries what stands above it, and four forms a joint, linear in the load factor, say whether it can.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::{Decider, LoadPoint, StackBody, StackNumbers};
use crate::approx::{Signed, sign};
use crate::ball::Scalar;
use crate::exact::Real;
use crate::mode::{Corner, Mode, Slip};
use crate::wrench::Wrench;

/// What ends the rest of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RestLimit {
    /// Friction holds no more against a slide of what is above.
    Slides(Slip),
    /// The resultant of what is above has come to a corner.
    Turns(Corner),
}

impl RestLimit {
    /// The limits of a joint, in the order of its forms.
    pub const ALL: [RestLimit; 4] = [
        RestLimit::Slides(Slip::Left),
        RestLimit::Slides(Slip::Right),
        RestLimit::Turns(Corner::O),
        RestLimit::Turns(Corner::OPrime),
    ];

    /// The mode of what is above, did nothing else begin.
    pub fn mode(self) -> Mode {
        match self {
            RestLimit::Slides(Slip::Left) => Mode::SlideLeft,
            RestLimit::Slides(Slip::Right) => Mode::SlideRight,
            RestLimit::Turns(Corner::O) => Mode::RockO,
            RestLimit::Turns(Corner::OPrime) => Mode::RockOPrime,
        }
    }
}

/// A form `start` + λ `slope`, which is not below zero while a joint rests.
#[derive(Debug, Clone)]
pub(super) struct Line<T> {
    pub(super) start: T,
    pub(super) slope: T,
}

/// Where the stack leaves rest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Leaving {
    /// λ; zero where the permanent loads alone move it, infinite if it never does.
    pub(crate) load_factor: f64,
    /// True if the permanent loads alone move it.
    pub(crate) at_once: bool,
    /// The limits that are reached, each with its joint.
    pub(crate) limits: Vec<(usize, RestLimit)>,
}

/// The wrench of what is above a joint, with its moment about (0, h): X, P, G.
fn above<T: Real>(numbers: &StackNumbers<T>, wrench: impl Fn(&StackBody<T>) -> &Wrench<T>) -> Vec<[T; 3]> {
    let mut sums = [T::of(0.0), T::of(0.0), T::of(0.0)];
    let mut all: Vec<[T; 3]> = numbers
        .bodies
        .iter()
        .zip(&numbers.joints)
        .rev()
        .map(|(body, joint)| {
            let Wrench { x, p, m } = wrench(body).clone();
            let [sum_x, sum_p, about_origin] = sums.clone();
            let moment = m - x.clone() * body.y.clone() - p.clone() * body.x.clone();
            sums = [sum_x + x, sum_p + p, about_origin + moment];
            let [x, p, about_origin] = sums.clone();
            [x.clone(), p, about_origin + x * joint.h.clone()]
        })
        .collect();
    all.reverse();
    all
}

/// The forms of every joint, in the order of [`RestLimit::ALL`].
pub(super) fn forms<T: Real>(numbers: &StackNumbers<T>) -> Vec<[Line<T>; 4]> {
    let values = |loads: Vec<[T; 3]>| {
        numbers
            .joints
            .iter()
            .zip(loads)
            .map(|(joint, [x, p, g])| {
                let grip = joint.mu_s.clone() * p.clone();
                [
                    grip.clone() + x.clone(),
                    grip - x,
                    -g.clone() - joint.l.clone() * p.clone(),
                    joint.r.clone() * p + g,
                ]
            })
            .collect::<Vec<_>>()
    };
    let starts = values(above(numbers, |body| &body.permanent));
    let slopes = values(above(numbers, |body| &body.variable));
    let lines = |(starts, slopes): ([T; 4], [T; 4])| {
        let mut slopes = slopes.into_iter();
        starts.map(|start| Line { start, slope: slopes.next().expect("four") })
    };
    starts.into_iter().zip(slopes).map(lines).collect()
}

impl Decider<'_> {
    /// Where the stack leaves rest: at the least zero of the forms that fall.
    pub(crate) fn leaving(&self) -> Leaving {
        let approx = forms(&self.approx);
        let exact = std::cell::OnceCell::new();
        let exact = || exact.get_or_init(|| forms(self.exact()));
        let start = |(joint, form): (usize, usize)| {
            approx[joint][form].start.sign().unwrap_or_else(|| sign(&exact()[joint][form].start))
        };
        let slope = |(joint, form): (usize, usize)| {
            approx[joint][form].slope.sign().unwrap_or_else(|| sign(&exact()[joint][form].slope))
        };
        let places: Vec<(usize, usize)> =
            (self.skipped..approx.len()).flat_map(|joint| (0..4).map(move |form| (joint, form))).collect();
        let limits = |places: Vec<(usize, usize)>| {
            places.into_iter().map(|(joint, form)| (joint, RestLimit::ALL[form])).collect::<Vec<_>>()
        };
        let broken: Vec<_> = places.iter().copied().filter(|place| start(*place) == Less).collect();
        if !broken.is_empty() {
            return Leaving { load_factor: 0.0, at_once: true, limits: limits(broken) };
        }
        let falling: Vec<_> = places.into_iter().filter(|place| slope(*place) == Less).collect();
        // a/(−b) of one against that of another: a b' − a' b, as both slopes are below zero.
        let compared = |one: (usize, usize), two: (usize, usize)| {
            let [a, b] = [one, two].map(|(joint, form)| &approx[joint][form]);
            let tracked = b.start * a.slope - a.start * b.slope;
            tracked.sign().unwrap_or_else(|| {
                let [a, b] = [one, two].map(|(joint, form)| &exact()[joint][form]);
                sign(&(b.start.clone() * a.slope.clone() - a.start.clone() * b.slope.clone()))
            })
        };
        let mut first: Vec<(usize, usize)> = Vec::new();
        for place in falling {
            match first.first().map_or(Less, |least| compared(place, *least)) {
                Less => first = vec![place],
                Equal => first.push(place),
                Greater => {}
            }
        }
        let load_factor = first.first().map_or(f64::INFINITY, |(joint, form)| {
            let Line { start, slope } = &approx[*joint][*form];
            let rounded = start.value() / -slope.value();
            // Where rounding might put it beside nothing, or on the other side of the full load.
            if start.sign().is_some() && (rounded - 1.0).abs() > 1e-9 {
                return rounded;
            }
            let Line { start, slope } = &exact()[*joint][*form];
            match (sign(start), sign(&(start.clone() + slope.clone()))) {
                (Equal, _) => 0.0,
                (_, Equal) => 1.0,
                _ => (start.clone() / -slope.clone()).value(),
            }
        });
        Leaving { load_factor, at_once: false, limits: limits(first) }
    }

    /// Any load beyond where the stack leaves rest, without rounding; `None` if it never does.
    pub(super) fn point(&self, leaving: &Leaving) -> Option<LoadPoint> {
        if leaving.at_once {
            return Some(LoadPoint { beyond: true, ..LoadPoint::of(0.0) });
        }
        let (joint, limit) = leaving.limits.first()?;
        let form = RestLimit::ALL.iter().position(|other| other == limit)?;
        let Line { start, slope } = &forms(self.exact())[*joint][form];
        Some(LoadPoint { above: start.clone(), below: -slope.clone(), beyond: true })
    }
}
