//! Spans of departures against the load path at single frictions and shares, and against the report's plane.

mod common;

use common::Random;
use standfast::contact::departure::{by_friction, by_share};
use standfast::contact::{Block, path};
use standfast::initiation::Chart;
use standfast::{Departure, Mode, Wrench};

fn wrench(random: &mut Random, sizes: [f64; 3]) -> Wrench {
    let [x, p, m] = sizes.map(|size| random.uniform(-size, size));
    Wrench { x, p, m }
}

/// The departure as the stages of the whole load path have it.
fn by_stages(block: &Block, permanent: &Wrench, variable: &Wrench) -> (bool, Option<Mode>) {
    let begin = standfast::contact::solve(block, permanent).unwrap().mode();
    let stages = path::stages(block, permanent, variable).unwrap();
    if begin != Some(Mode::Rest) {
        return (true, stages[0].mode().filter(|mode| *mode != Mode::Rest).or(begin));
    }
    match stages.iter().find(|stage| stage.mode() != Some(Mode::Rest)) {
        Some(stage) => (stage.from == 0.0, stage.mode()),
        None => (false, None),
    }
}

fn seen(departure: Departure) -> (bool, Option<Mode>) {
    (matches!(departure, Departure::AtOnce { .. }), departure.mode())
}

/// At random frictions and beside every end, for any block, any load, any ratio of slip to stick.
#[test]
fn by_friction_they_are_those_of_the_load_path() {
    let mut random = Random(57);
    for _ in 0..common::tries(3000) {
        let ratio = if random.uniform(0.0, 1.0) < 0.5 { 1.0 } else { random.uniform(0.0, 1.0) };
        let block = random.block(ratio);
        let mut permanent = wrench(&mut random, [0.3, 0.5, 0.3]);
        permanent.p += 0.8;
        let variable = wrench(&mut random, [2.0, 1.0, 3.0]);
        let spans = by_friction(&block, &permanent, &variable).unwrap();
        assert_eq!((spans[0].from, spans.last().unwrap().to), (0.0, f64::INFINITY));
        let asked = (0..8).map(|_| 10f64.powf(random.uniform(-1.5, 1.5)));
        let beside =
            spans.iter().skip(1).flat_map(|span| [span.from * (1.0 - 1e-8), span.from * (1.0 + 1e-8)]);
        for μ in asked.collect::<Vec<_>>().into_iter().chain(beside) {
            let span = spans.iter().find(|span| span.from <= μ && μ < span.to).unwrap();
            let thin = spans.iter().any(|span| (span.from / μ - 1.0).abs() < 1e-9);
            let there = by_stages(&Block { mu_s: μ, mu_k: μ * ratio, ..block }, &permanent, &variable);
            assert!(
                thin || seen(span.departure) == there,
                "{block:?} {permanent:?} {variable:?} μ = {μ}: {span:?} {there:?}"
            );
        }
    }
}

/// Spans along a share of the load.
#[test]
fn by_share_they_are_those_of_the_load_path() {
    let mut random = Random(58);
    for _ in 0..common::tries(3000) {
        let ratio = if random.uniform(0.0, 1.0) < 0.5 { 1.0 } else { random.uniform(0.0, 1.0) };
        let mut block = random.block(ratio);
        let μ = random.uniform(0.1, 1.5);
        (block.mu_s, block.mu_k) = (μ, μ * ratio);
        let mut permanent = wrench(&mut random, [0.1, 0.5, 0.1]);
        permanent.p += 0.8;
        let (without, with) = (wrench(&mut random, [1.0, 0.5, 1.5]), wrench(&mut random, [1.0, 0.5, 1.5]));
        let spans = by_share(&block, &permanent, &without, &with).unwrap();
        let asked: Vec<f64> = (0..8).map(|_| random.uniform(-4.0, 4.0)).collect();
        let beside = spans.iter().skip(1).flat_map(|span| [span.from - 1e-8, span.from + 1e-8]);
        for b in asked.into_iter().chain(beside) {
            let span = spans.iter().find(|span| span.from <= b && b < span.to).unwrap();
            let thin = spans.iter().any(|span| (span.from - b).abs() < 1e-9);
            let there = by_stages(&block, &permanent, &(without + with * b));
            assert!(thin || seen(span.departure) == there, "{block:?} b = {b}: {span:?} {there:?}");
        }
    }
}

/// In the report's plane a force that rises from zero slides the body below μ_A, and rocks it above: k_A parts rest from both.
#[test]
fn in_the_plane_the_point_a_parts_them() {
    let (γ, k_prime) = (0.8, 0.9167);
    let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    let force = Wrench { x: -1.0, p: 0.0, m: k_prime * γ };
    let spans = by_friction(&Block::uniform(γ, 1.0), &weight, &force).unwrap();
    let modes: Vec<_> = spans.iter().map(|span| span.departure.mode().unwrap()).collect();
    assert_eq!(modes, [Mode::SlideLeft, Mode::RockO]);
    assert!((spans[0].to - Chart::new(γ, k_prime).unwrap().k_a()).abs() < 1e-14);
}
