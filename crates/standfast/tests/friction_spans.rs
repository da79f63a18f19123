//! Spans of friction against the contact problem at single frictions, and against the report's curves.

mod common;

use common::Random;
use standfast::contact::{
    Block,
    friction::{spans, spans_up_to},
    solve,
};
use standfast::initiation::Chart;
use standfast::{Mode, Wrench};

/// At random frictions, and just beside every end, the span is what the contact problem says there: any block, any wrench, any
/// ratio of slip to stick.
#[test]
fn spans_are_the_contact_problem_at_every_friction() {
    let mut random = Random(23);
    for _ in 0..common::tries(4000) {
        let ratio = if random.uniform(0.0, 1.0) < 0.5 { 1.0 } else { random.uniform(0.0, 1.0) };
        let block = random.block(ratio);
        let signed = |random: &mut Random, size: f64| random.uniform(-size, size);
        let wrench =
            Wrench { x: signed(&mut random, 2.0), p: signed(&mut random, 1.5), m: signed(&mut random, 3.0) };
        let spans = spans(&block, &wrench).unwrap();
        assert_eq!((spans[0].from, spans.last().unwrap().to), (0.0, f64::INFINITY));
        assert!(spans.windows(2).all(|pair| pair[0].to == pair[1].from && pair[0].from < pair[0].to));
        // Up to a friction they are the same, and what is beyond it is not asked for.
        let up_to = 10f64.powf(signed(&mut random, 1.5));
        let first = spans_up_to(&block, &wrench, up_to).unwrap();
        assert!(first.iter().all(|span| span.from < up_to) && first.last().unwrap().to == f64::INFINITY);
        let within = spans.iter().take_while(|span| span.from < up_to);
        assert!(first.iter().map(|s| (s.from, s.mode(), s.modes)).eq(within.map(|s| (
            s.from,
            s.mode(),
            s.modes
        ))));
        let asked = (0..8).map(|_| 10f64.powf(signed(&mut random, 1.5)));
        let beside =
            spans.iter().skip(1).flat_map(|span| [span.from * (1.0 - 1e-9), span.from * (1.0 + 1e-9)]);
        for μ in asked.chain(beside) {
            let span = spans.iter().find(|span| span.from <= μ && μ < span.to).unwrap();
            let thin = spans.iter().any(|span| (span.from / μ - 1.0).abs() < 1e-10);
            let there = solve(&Block { mu_s: μ, mu_k: μ * ratio, ..block }, &wrench).unwrap();
            assert!(
                thin || (span.mode(), span.modes) == (there.mode(), there.modes),
                "{block:?} {wrench:?} μ = {μ}: {span:?}"
            );
        }
    }
}

/// The ends are the report's curves: k and the turning line below k_A, μ* above.
#[test]
fn ends_are_the_curves_of_the_report() {
    let (γ, k_prime) = (0.8, 0.9167);
    let chart = Chart::new(γ, k_prime).unwrap();
    let at = |k: f64| spans(&Block::uniform(γ, 1.0), &Wrench { x: -k, p: 1.0, m: k * k_prime * γ }).unwrap();
    let modes = |k: f64| at(k).iter().map(|span| span.mode().unwrap()).collect::<Vec<_>>();
    assert_eq!(modes(0.45), [Mode::SlideLeft, Mode::Rest]);
    let k = 0.8;
    assert!(k > chart.k_a());
    assert_eq!(modes(k), [Mode::SlideLeft, Mode::SlideRockOLeft, Mode::RockO]);
    let ends: Vec<f64> = at(k).iter().map(|span| span.to).collect();
    assert!((ends[0] - (1.0 / γ - k * k_prime)).abs() < 1e-14);
    assert!((ends[1] - chart.mu_star().at(k)).abs() < 1e-14);
}
