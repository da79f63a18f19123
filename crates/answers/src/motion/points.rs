//! Points of the body, where equipment stands: their accelerations, and the jumps of their velocities at impacts.
//!
//! With r = R(θ)p from C to the point, ẍ, ÿ and α of the body relative to the base and a_h, a_v of the base itself,
//!
//! ```text
//! a_x = ẍ − αr_y − ω²r_x + a_h      a_y = ÿ + αr_x − ω²r_y + a_v
//! f_along = a_x cosθ + (a_y + g) sinθ      f_up = −a_x sinθ + (a_y + g) cosθ
//! ```
//!
//! a is absolute; f is what an instrument there feels, in its own axes and with gravity. At an impact accelerations are infinite: what is told is
//! between impacts, and of each impact the jump of the velocity.

use standfast::History;
use standfast_model::{BlockCase, BodyPoint};
use standfast_motion::{Moment, MotionOutcome, Why};

/// Motion of a point at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMotion {
    /// Velocity relative to the base, to the right and upwards.
    pub velocity: [f64; 2],
    /// Absolute acceleration, to the right and upwards.
    pub acceleration: [f64; 2],
    /// What an instrument feels along the base of the body, to its right, and upwards along its side.
    pub felt: [f64; 2],
}

impl PointMotion {
    /// That of a point fixed in the body at a moment, the base accelerating by `ground`.
    pub fn of([px, py]: [f64; 2], moment: &Moment, ground: [f64; 2], gravity: f64) -> PointMotion {
        let (sin, cos) = moment.theta.sin_cos();
        let (rx, ry) = (px * cos - py * sin, px * sin + py * cos);
        let (ω, α) = (moment.omega, moment.alpha);
        let [ax, ay] = moment.acceleration;
        let acceleration = [ax - α * ry - ω * ω * rx + ground[0], ay + α * rx - ω * ω * ry + ground[1]];
        let [x, up] = [acceleration[0], acceleration[1] + gravity];
        PointMotion {
            velocity: [moment.velocity[0] - ω * ry, moment.velocity[1] + ω * rx],
            acceleration,
            felt: [x * cos + up * sin, up * cos - x * sin],
        }
    }

    /// a_x, a_y, f_along and f_up.
    pub fn numbers(&self) -> [f64; 4] {
        let ([a_x, a_y], [f_along, f_up]) = (self.acceleration, self.felt);
        [a_x, a_y, f_along, f_up]
    }
}

/// Acceleration of the base at a moment, to the right and upwards; where it jumps as it is before or after.
pub(super) fn ground(case: &BlockCase, t: f64, before: bool) -> [f64; 2] {
    let base = &case.problem.base;
    [&base.horizontal, &base.vertical].map(|history| {
        let value = if before { History::before } else { History::at };
        history.as_ref().map_or(0.0, |history| value(history, t))
    })
}

/// The least and the largest of a number over a motion, each with its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// The least value, and when.
    pub least: [f64; 2],
    /// The largest value, and when.
    pub largest: [f64; 2],
}

/// A point over a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct PointAnswer {
    /// The point.
    pub point: BodyPoint,
    /// Extremes of a_x, a_y, f_along and f_up, between impacts.
    pub extremes: [Extremes; 4],
    /// Places of events at which its velocity jumps, and by how much, to the right and upwards.
    pub jumps: Vec<(usize, [f64; 2])>,
}

/// Stretches into which a step is parted before an extreme in it is made exact.
const PARTS: usize = 4;

impl PointAnswer {
    /// The names of its numbers.
    pub const NAMES: [&str; 4] = ["a_x", "a_y", "f_along", "f_up"];

    /// A point over a motion whose steps were kept.
    pub(super) fn of(case: &BlockCase, outcome: &MotionOutcome, point: &BodyPoint) -> PointAnswer {
        let gravity = case.problem.gravity;
        let at = |t: f64, before: bool| {
            let moment = outcome.moment(t, before)?;
            Some(PointMotion::of(point.at, &moment, ground(case, t, before), gravity))
        };
        let none = Extremes { least: [f64::INFINITY, 0.0], largest: [f64::NEG_INFINITY, 0.0] };
        let mut extremes = [none; 4];
        for step in &outcome.steps {
            let time = |part: usize| step.t + step.duration * part as f64 / PARTS as f64;
            let samples: Vec<[f64; 4]> = (0..=PARTS)
                .filter_map(|part| at(time(part), part > 0).map(|motion| motion.numbers()))
                .collect();
            for (which, extreme) in extremes.iter_mut().enumerate() {
                for (part, sample) in samples.iter().enumerate() {
                    extreme.see(sample[which], time(part));
                }
                // Where a sample is above both of its neighbours, or at an end above one, a peak is about it.
                for part in 0..samples.len() {
                    let [from, to] = [part.saturating_sub(1), (part + 1).min(samples.len() - 1)];
                    let [before, here, after] = [from, part, to].map(|part| samples[part][which]);
                    for side in [1.0, -1.0] {
                        let is_peak = side * here >= side * before && side * here >= side * after;
                        let differ = (before - here).abs().max((after - here).abs());
                        if is_peak && differ > 0.0 && extreme.is_near(side, here, differ) {
                            let value =
                                |t: f64| at(t, t > step.t).map_or(f64::NAN, |motion| motion.numbers()[which]);
                            let t = peak([time(from), time(to)], |t| side * value(t));
                            extreme.see(value(t), t);
                        }
                    }
                }
            }
        }
        // Nothing is felt in a fall, but for rounding.
        for extreme in extremes.iter_mut().flat_map(|extreme| [&mut extreme.least, &mut extreme.largest]) {
            if extreme[0].abs() < 1e-13 * gravity {
                extreme[0] = 0.0;
            }
        }
        let mut jumps = Vec::new();
        for (place, event) in outcome.events.iter().enumerate() {
            let is_sudden = matches!(event.why, Why::Impact | Why::Settle | Why::Grip);
            let of_a_moment = place > 0 && outcome.events[place - 1].t == event.t;
            let [before, after] = [true, false].map(|before| at(event.t, before));
            if let (true, false, Some(before), Some(after)) = (is_sudden, of_a_moment, before, after) {
                jumps.push((place, [0, 1].map(|i| after.velocity[i] - before.velocity[i])));
            }
        }
        PointAnswer { point: point.clone(), extremes, jumps }
    }

    /// The largest jump of its velocity at an impact, in magnitude, and when.
    pub fn largest_jump(&self, outcome: &MotionOutcome) -> Option<[f64; 2]> {
        let sizes = self.jumps.iter().map(|(place, [x, y])| [x.hypot(*y), outcome.events[*place].t]);
        sizes.reduce(|largest, next| if next[0] > largest[0] { next } else { largest })
    }
}

impl Extremes {
    fn see(&mut self, value: f64, t: f64) {
        if value < self.least[0] {
            self.least = [value, t];
        }
        if value > self.largest[0] {
            self.largest = [value, t];
        }
    }

    /// True if a peak about a sample may be beyond what was found, for samples that differ so much.
    fn is_near(&self, side: f64, sample: f64, differ: f64) -> bool {
        match side > 0.0 {
            true => sample + differ >= self.largest[0],
            false => sample - differ <= self.least[0],
        }
    }
}

/// Where a function is largest that has one peak between two moments.
fn peak([mut low, mut high]: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut at = inner(low, high);
    let mut values = at.map(&value);
    // The top of a parabola is known to half of the digits, its value to all.
    for _ in 0..40 {
        if values[0] > values[1] {
            high = at[1];
            at = [high - GOLDEN * (high - low), at[0]];
            values = [value(at[0]), values[0]];
        } else {
            low = at[0];
            at = [at[1], low + GOLDEN * (high - low)];
            values = [values[1], value(at[1])];
        }
    }
    at[usize::from(values[1] > values[0])]
}
