//! Random problems.
#![allow(dead_code)]

pub mod stepping;

use standfast::contact::Block;
use standfast_motion::{BaseMotion, History, Impact, Initial, LoadInTime, MotionProblem};

/// A small generator of numbers, so that a test is the same everywhere.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn of(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }
}

pub fn block(random: &mut Random) -> Block {
    let γ = random.between(0.4, 4.0);
    let μ = random.between(0.05, 1.1);
    let mut block = Block::uniform(γ, μ);
    if random.of(3) == 0 {
        (block.b1, block.b2) = (random.between(0.6, 1.3), random.between(0.6, 1.3));
        block.rho2 *= random.between(0.8, 1.2);
    }
    if random.of(3) == 0 {
        (block.m_x, block.m_y) = (random.between(1.0, 1.6), random.between(1.0, 1.2));
    }
    if random.of(3) == 0 {
        block.mu_s *= random.between(1.0, 1.5);
    }
    block
}

pub fn history(random: &mut Random, peak: f64) -> History {
    let t = random.between(0.1, 3.0);
    let start = if random.of(2) == 0 { 0.0 } else { random.between(0.0, 2.0) };
    let history = match random.of(7) {
        0 => History::rect(peak, t),
        1 => History::triangle(peak, t * random.unit(), t),
        2 => History::decay(peak, t),
        3 => History::half_sine(peak, t),
        4 => History::sine(peak, random.between(1.0, 6.0), random.between(0.0, 1.0), t),
        5 => History::church_roof(peak, 0.1 * t, 0.3 * t, 0.3 * peak, t),
        _ => {
            let (mut times, mut values) = (vec![0.0], vec![0.0]);
            for _ in 0..12 {
                times.push(times[times.len() - 1] + random.between(0.05, 0.5));
                values.push(random.between(-1.0, 1.0));
            }
            History::points(&times, &values.iter().map(|v| v * peak).collect::<Vec<_>>())
        }
    };
    history.unwrap().starting(start).unwrap()
}

/// A block that rests at first, under forces or a base motion that may move it.
pub fn problem(random: &mut Random) -> MotionProblem {
    let block = block(random);
    let γ = block.d;
    let mut problem = MotionProblem::new(block, 1.0);
    let reach = (block.mu_s).min(1.0 / γ);
    match random.of(3) {
        0 => {
            let peak = reach * random.between(0.8, 4.0);
            problem.base.horizontal = Some(history(random, peak));
            if random.of(2) == 0 {
                let peak = random.between(-0.5, 0.5);
                problem.base.vertical = Some(history(random, peak));
            }
        }
        kind => {
            for _ in 0..kind {
                let peak = reach * random.between(0.5, 3.0);
                let angle =
                    random.between(-0.4, 0.4) + if random.of(2) == 0 { 0.0 } else { std::f64::consts::PI };
                let history = history(random, peak);
                problem.loads.push(LoadInTime {
                    at: [random.between(-1.0, 1.0), γ * random.between(-0.9, 0.9)],
                    direction: [angle.cos(), angle.sin()],
                    follows: random.of(3) == 0,
                    history,
                });
            }
        }
    }
    problem.impact = match random.of(6) {
        0 => Impact::Housner,
        1 => Impact::Ratio(random.between(0.3, 0.95) * problem.largest_ratio()),
        _ => Impact::Inelastic,
    };
    problem.t_max = Some(60.0);
    problem
}

/// Left and right exchanged.
pub fn mirrored(problem: &MotionProblem) -> MotionProblem {
    let mut other = problem.clone();
    (other.block.b1, other.block.b2) = (problem.block.b2, problem.block.b1);
    for load in &mut other.loads {
        load.at[0] = -load.at[0];
        load.direction[0] = -load.direction[0];
    }
    other.base.horizontal = problem.base.horizontal.clone().map(|h| h.times_factor(-1.0));
    let Initial { theta, omega, vx, .. } = problem.initial;
    other.initial = Initial { theta: -theta, omega: -omega, vx: vx.map(|v| -v), ..problem.initial };
    other
}

/// Base motion alone.
pub fn shaken(block: Block, horizontal: History) -> MotionProblem {
    let mut problem = MotionProblem::new(block, 1.0);
    problem.base = BaseMotion { horizontal: Some(horizontal), vertical: None };
    problem
}
