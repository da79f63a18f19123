//! Time of motions under a record of 4000 points, as ratios in one run: to the time that reading the record takes, and
//! to the time stepping of the tests.
//!
//! `cargo bench -p standfast-motion --bench ratios`

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::{Duration, Instant};

use common::Random;
use common::stepping::stepped;
use standfast::contact::Block;
use standfast_motion::record::Record;
use standfast_motion::{Event, History, Impact, Keep, MotionProblem, simulate, simulate_at_length};

const POINTS: usize = 4000;
const STEP: f64 = 0.005;

/// The least time of some runs.
fn least(runs: usize, mut work: impl FnMut()) -> Duration {
    let mut once = || {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..runs).map(|_| once()).min().unwrap_or_default()
}

/// A shaking of 20 s, a sum of sines under an envelope.
fn shaking() -> Vec<f64> {
    let mut random = Random::new(5);
    let sines: Vec<[f64; 3]> = (0..40)
        .map(|_| [random.between(2.0, 50.0), random.between(0.0, 6.3), random.between(0.3, 1.0)])
        .collect();
    let at = |t: f64| {
        let envelope = (t / 3.0).min(1.0) * (-(t - 8.0).max(0.0) / 5.0).exp();
        envelope * sines.iter().map(|[w, phase, size]| size * (w * t + phase).sin()).sum::<f64>()
    };
    let values: Vec<f64> = (0..POINTS).map(|i| at(i as f64 * STEP)).collect();
    let peak = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    values.into_iter().map(|value| value * 0.4 * 9.81 / peak).collect()
}

/// Blocks of many sizes that rock under the record of the examples: short series beside those of full length.
fn rocking() {
    let text = include_str!("../../../examples/records/np01002p_4225c_a.smc");
    let history = Record::parse("a.smc", text, None, None).unwrap().history(1.0).unwrap();
    let pieces = history.pieces().len();
    let mut random = Random::new(17);
    let problems: Vec<MotionProblem> = (0..40)
        .map(|_| {
            let (half, α) = (random.between(0.3, 6.0), random.between(0.08, 0.25));
            let mut block = Block::uniform(1.0 / α, 50.0);
            (block.b1, block.b2, block.d) = (half * α, half * α, half);
            block.rho2 *= (half * α).powi(2);
            let mut problem = MotionProblem::new(block, 9.81);
            problem.base.horizontal = Some(history.clone().times_factor(0.013));
            problem.impact = Impact::Housner;
            problem
        })
        .collect();
    let time = |follow: &dyn Fn(&MotionProblem) -> usize| {
        let mut events = 0;
        let time = least(10, || events = problems.iter().map(follow).sum());
        (time / problems.len() as u32, events / problems.len())
    };
    let (short, events) = time(&|problem| simulate(problem, Keep::default()).unwrap().events.len());
    let (long, _) = time(&|problem| simulate_at_length(problem, Keep::default()).unwrap().events.len());
    println!(
        "rocks under {pieces} points of a record: {short:?}, {:.0} ns a piece, {events} events; {:.2} of series of full length",
        short.as_secs_f64() * 1e9 / pieces as f64,
        short.as_secs_f64() / long.as_secs_f64()
    );
}

fn main() {
    let values = shaking();
    let history = History::samples(STEP, &values).unwrap();
    let lines: String = values.iter().map(|value| format!("{value:.9}\n")).collect();
    let text = format!("a_m_s2\n{lines}");
    let file = least(40, || {
        let record = Record::parse("a.csv", black_box(&text), None, Some(STEP)).unwrap();
        black_box(record.history(1.0).unwrap());
    });
    let made = least(200, || {
        black_box(History::samples(STEP, black_box(&values)).unwrap());
    });
    let look = least(400, || {
        black_box(black_box(&values).iter().fold(0.0, |most: f64, value| most.max(value.abs())));
    });
    println!(
        "a file of {POINTS} points is read in {file:?}, a history of numbers made in {made:?}, each looked at in {look:?}"
    );
    rocking();
    let block = |half: f64, slenderness: f64, friction: f64| {
        let mut block = Block::uniform(slenderness, friction);
        (block.b1, block.b2, block.d) = (half, half, half * slenderness);
        block.rho2 *= half * half;
        let mut problem = MotionProblem::new(block, 9.81);
        problem.base.horizontal = Some(history.clone());
        problem.impact = Impact::Inelastic;
        problem
    };
    // It sticks until it rocks, and slips at impacts.
    let mut slippery = block(0.5, 4.0, 0.5);
    slippery.block.mu_k = 0.1;
    for (name, problem, runs) in [
        ("slides", block(0.5, 0.3, 0.12), 400),
        ("rocks", block(0.5, 4.0, 0.9), 40),
        ("slides and rocks", slippery, 40),
        ("rests", block(0.5, 1.0, 0.9), 400),
    ] {
        let outcome = simulate(&problem, Keep::default()).unwrap();
        let time = least(runs, || {
            black_box(simulate(black_box(&problem), Keep::default()).unwrap());
        });
        // As in the tests, where B and g are 1.
        let step = 1e-3 * (problem.block.b1 / problem.gravity).sqrt();
        let steps = least(3, || {
            black_box(stepped(black_box(&problem), outcome.t_final, step));
        });
        let ratio = |one: Duration, two: Duration| one.as_secs_f64() / two.as_secs_f64();
        if name == "slides and rocks" {
            let both = |event: &Event| event.state.slip().is_some() && event.state.corner().is_some();
            let counted = outcome.events.iter().filter(|event| both(event)).count();
            assert!(
                counted > 10 && outcome.max_slide > 1e-3 && outcome.max_theta > 1e-3,
                "it slides and rocks"
            );
        }
        println!(
            "{name}: {time:?}; {} events, slide {:.4} m, |θ| {:.4}; {:.3} of reading the file, {:.1} of making the history, {:.1} of \
             looking; the time stepping of the tests, at {:.2} ms, takes {:.0} times as long",
            outcome.events.len(),
            outcome.max_slide,
            outcome.max_theta,
            ratio(time, file),
            ratio(time, made),
            ratio(time, look),
            1e3 * step,
            ratio(steps, time)
        );
    }
}
