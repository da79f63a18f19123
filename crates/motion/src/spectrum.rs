//! Many motions under one shaking of the base: over the size and slenderness of a block, over its yield ratio, over the strength of the
//! shaking. Each point is a motion of its own, so that they may be asked for in any order and on any number of threads.

use standfast::contact::Block;

use crate::error::MotionError;
use crate::machine::{Keep, simulate};
use crate::outcome::{End, MotionOutcome};
use crate::problem::{BaseMotion, Impact, LoadInTime, MotionProblem};
use standfast::history::History;

/// Response of a block of a rocking spectrum, or at a scale of the shaking.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rocked {
    /// Largest |θ|.
    pub max_theta: f64,
    /// Largest |θ| over the angle of balance, of the side to which that is less.
    pub of_balance: f64,
    /// Largest |displacement| of a touching corner.
    pub max_slide: f64,
    /// True if the body overturned.
    pub overturned: bool,
    /// Number of times that a corner met the base.
    pub impacts: usize,
    /// End of the motion.
    pub end: End,
}

impl Rocked {
    fn of(block: &Block, outcome: &MotionOutcome) -> Rocked {
        Rocked {
            max_theta: outcome.max_theta,
            of_balance: outcome.max_theta / (block.b1.min(block.b2) / block.d).atan(),
            max_slide: outcome.max_slide,
            overturned: outcome.overturned(),
            impacts: outcome.impacts,
            end: outcome.end,
        }
    }
}

/// Blocks of many sizes under one shaking: what they have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct RockingSpectrum {
    /// Friction to stick and to slip.
    pub friction: [f64; 2],
    /// g.
    pub gravity: f64,
    /// The shaking.
    pub base: BaseMotion,
    /// The law of impacts.
    pub impact: Impact,
    /// Restitution.
    pub restitution: f64,
}

impl RockingSpectrum {
    /// The uniform block whose corners are `radius` from its centre, and that is `slenderness` times as high as wide.
    pub fn block(&self, radius: f64, slenderness: f64) -> Block {
        let b = radius / 1f64.hypot(slenderness);
        let [mu_s, mu_k] = self.friction;
        Block {
            b1: b,
            b2: b,
            d: slenderness * b,
            rho2: radius * radius / 3.0,
            m_x: 1.0,
            m_y: 1.0,
            mu_s,
            mu_k,
        }
    }

    /// Response of the block of this radius and slenderness.
    ///
    /// # Errors
    /// If a number makes no block, or a measured ratio would give it energy.
    pub fn at(&self, radius: f64, slenderness: f64) -> Result<Rocked, MotionError> {
        let block = self.block(radius, slenderness);
        let mut problem = MotionProblem::new(block, self.gravity);
        (problem.base, problem.impact) = (self.base.clone(), self.impact);
        problem.restitution = self.restitution;
        simulate(&problem, Keep::default()).map(|outcome| Rocked::of(&block, &outcome))
    }
}

/// Displacement of a block that can only slide, by the side to which it can.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slid {
    /// The way of a block that can slide to the left only, as on a slope that falls to the left.
    pub left: f64,
    /// That of one that can slide to the right only.
    pub right: f64,
    /// Largest |displacement| of a block on level ground.
    pub both: f64,
    /// Its displacement at the end, to the right.
    pub residual: f64,
}

/// Newmark's block: it slides where the base's acceleration is above its yield acceleration.
#[derive(Debug, Clone, PartialEq)]
pub struct NewmarkSpectrum {
    base: History,
    peak: f64,
}

/// A side force that keeps a block from sliding up its slope, in units of the shaking's peak.
const SLOPE: f64 = 4.0;

impl NewmarkSpectrum {
    /// The spectrum of a horizontal shaking.
    pub fn new(base: History) -> NewmarkSpectrum {
        let peak = base.peak();
        NewmarkSpectrum { base, peak }
    }

    /// The shaking's largest |acceleration|.
    pub fn peak(&self) -> f64 {
        self.peak
    }

    /// Displacement of blocks that yield at this share of the peak.
    ///
    /// # Errors
    /// If the ratio is not above zero, or the shaking has no peak.
    pub fn at(&self, ratio: f64) -> Result<Slid, MotionError> {
        let gravity = self.peak;
        let mut problem = MotionProblem::new(Block::uniform(1.0, ratio), gravity);
        problem.base.horizontal = Some(self.base.clone());
        let mut slides = |friction: f64, force: f64| {
            // So low that nothing tips it.
            problem.block = Block::uniform(1e-3 / (1.0 + friction), friction);
            problem.loads.clear();
            if force != 0.0 {
                problem.loads.push(LoadInTime {
                    at: [0.0, -problem.block.d],
                    direction: [force, 0.0],
                    follows: false,
                    history: History::constant(gravity)?,
                });
            }
            simulate(&problem, Keep::default())
        };
        if !(ratio > 0.0 && ratio < 1e6) {
            return Err(MotionError::Value {
                name: "yield ratio",
                value: ratio,
                expected: "a number above zero",
            });
        }
        if gravity.is_nan() || gravity <= 0.0 {
            return Err(MotionError::Value {
                name: "peak",
                value: gravity,
                expected: "a shaking that is not zero",
            });
        }
        let level = slides(ratio, 0.0)?;
        Ok(Slid {
            left: slides(ratio + SLOPE, -SLOPE)?.max_slide,
            right: slides(ratio + SLOPE, SLOPE)?.max_slide,
            both: level.max_slide,
            residual: level.slide,
        })
    }
}

/// A body under a shaking that is made stronger and stronger.
#[derive(Debug, Clone, PartialEq)]
pub struct OverturningCurve<'a> {
    problem: &'a MotionProblem,
}

impl<'a> OverturningCurve<'a> {
    /// The curve of a problem, whose base moves.
    pub fn new(problem: &'a MotionProblem) -> OverturningCurve<'a> {
        OverturningCurve { problem }
    }

    /// Response of the body if the base's acceleration is multiplied by `scale`.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn at(&self, scale: f64) -> Result<Rocked, MotionError> {
        let mut problem = self.problem.clone();
        let times = |history: Option<History>| history.map(|history| history.times_factor(scale));
        problem.base =
            BaseMotion { horizontal: times(problem.base.horizontal), vertical: times(problem.base.vertical) };
        simulate(&problem, Keep::default()).map(|outcome| Rocked::of(&problem.block, &outcome))
    }

    /// Between two scales at one of which it overturns and at the other not: a scale at which one turns into the other, to a relative
    /// 1e-9. There may be more of them between; a scan tells.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn turn(&self, from: f64, to: f64) -> Result<f64, MotionError> {
        let (mut low, mut high) = (from, to);
        let first = self.at(from)?.overturned;
        while (high - low).abs() > 1e-9 * high.abs() {
            let middle = 0.5 * (low + high);
            if self.at(middle)?.overturned == first { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }
}

/// The scales at which a body overturns, from a scan: stretches from a turn to the next, the first and the last open where the scan ends.
pub fn overturning_stretches(scan: &[(f64, bool)], turn: impl Fn(f64, f64) -> f64) -> Vec<[f64; 2]> {
    let mut stretches: Vec<[f64; 2]> = Vec::new();
    let mut from = scan.first().filter(|(_, over)| *over).map(|(scale, _)| *scale);
    for pair in scan.windows(2) {
        let [(low, was), (high, is)] = [pair[0], pair[1]];
        match (was, is) {
            (false, true) => from = Some(turn(low, high)),
            (true, false) => stretches.extend(from.take().map(|from| [from, turn(low, high)])),
            _ => {}
        }
    }
    if let (Some(from), Some((last, _))) = (from, scan.last()) {
        stretches.push([from, *last]);
    }
    stretches
}
