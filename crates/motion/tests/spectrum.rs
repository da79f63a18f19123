//! Spectra against what is known of them: Newmark's block by another integration, the scales at which a pulse overturns a block.

mod common;

use standfast::contact::Block;
use standfast_motion::record::Record;
use standfast_motion::spectrum::{NewmarkSpectrum, OverturningCurve, RockingSpectrum, overturning_stretches};
use standfast_motion::{BaseMotion, History, Impact, Keep, MotionProblem, simulate};

/// Newmark's block on a slope, by the exact integral over each line of the record and halving for the ends of slip: it slides one way,
/// driven by what the acceleration exceeds `yields` by.
fn newmark(times: &[f64], values: &[f64], yields: f64) -> f64 {
    let (mut v, mut s) = (0.0_f64, 0.0_f64);
    // Driving acceleration over a stretch in which it has one sign.
    let mut over = |length: f64, a: f64, slope: f64| {
        let at = |x: f64| v + a * x + 0.5 * slope * x * x;
        let way = |x: f64| v * x + 0.5 * a * x * x + slope * x * x * x / 6.0;
        if at(length) >= 0.0 {
            (s, v) = (s + way(length), at(length));
            return;
        }
        let (mut low, mut high) = (0.0, length);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if at(middle) >= 0.0 { low = middle } else { high = middle }
        }
        (s, v) = (s + way(low), 0.0);
    };
    for (t, a) in times.windows(2).zip(values.windows(2)) {
        let length = t[1] - t[0];
        let (a, slope) = (a[0] - yields, (a[1] - a[0]) / length);
        let zero = -a / slope;
        if zero > 0.0 && zero < length {
            over(zero, a, slope);
            over(length - zero, 0.0, slope);
        } else {
            over(length, a, slope);
        }
    }
    over(1e3, -yields, 0.0);
    s
}

#[test]
fn newmark_slides_as_another_integration_has_it() {
    let text = include_str!("../../../examples/records/np01002p_4225c_a.smc");
    let record = Record::parse("a.smc", text, None, None).unwrap();
    let history = record.history(0.01).unwrap();
    let spectrum = NewmarkSpectrum::new(history);
    let times = &record.times;
    let mut slid = 0;
    for share in [0.05, 0.1, 0.17, 0.3, 0.45, 0.6, 0.8, 0.95] {
        let found = spectrum.at(share).unwrap();
        for (way, sign) in [(found.left, 1.0), (found.right, -1.0)] {
            let values: Vec<f64> = record.values.iter().map(|value| 0.01 * sign * value).collect();
            let expected = newmark(times, &values, share * spectrum.peak());
            assert!((way - expected).abs() <= 1e-9 * expected + 1e-13, "{share} {sign}: {way} {expected}");
            slid += usize::from(expected > 1e-4);
        }
        assert!(found.both >= found.residual.abs());
    }
    assert!(slid >= 10, "{slid}");
}

/// One sine of the base's acceleration, from where it first tips the block: the ranges of its amplitude that overturn.
#[test]
fn a_sine_overturns_in_two_ranges() {
    let α: f64 = 0.25;
    let γ = 1.0 / α.tan();
    let block = Block::uniform(γ, 50.0);
    let radius = 1f64.hypot(γ);
    let p = (0.75 / radius).sqrt();
    let ω = 5.0 * p;
    // The sine's beginning moves with its amplitude, so that each is a problem of its own; the curve is asked at one.
    let overturns = |amplitude: f64| {
        let ψ = (α.tan() / (amplitude * α)).asin();
        let pulse = History::sine(amplitude * α, ω, ψ, (std::f64::consts::TAU - ψ) / ω).unwrap();
        let mut problem = common::shaken(block, pulse);
        problem.impact = Impact::Ratio(0.9);
        OverturningCurve::new(&problem).at(1.0).unwrap().overturned
    };
    let scan: Vec<(f64, bool)> =
        (0..80).map(|i| 1.05 + 0.1 * f64::from(i)).map(|a| (a, overturns(a))).collect();
    let turn = |from: f64, to: f64| {
        let (mut low, mut high, was) = (from, to, overturns(from));
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if overturns(middle) == was { low = middle } else { high = middle }
        }
        low
    };
    let stretches = overturning_stretches(&scan, turn);
    assert_eq!(stretches.len(), 2, "{stretches:?}");
    for (found, expected) in stretches.iter().flatten().zip([3.03234, 6.74302, 7.49300, scan[79].0]) {
        assert!((found - expected).abs() < 6e-6, "{found} {expected}");
    }
}

/// The curve refines what it scans: the turn lies where a slightly weaker and a slightly stronger shaking differ.
#[test]
fn a_turn_is_where_the_verdict_changes() {
    let mut problem = common::shaken(Block::uniform(4.0, 0.6), History::half_sine(0.3, 2.0).unwrap());
    problem.impact = Impact::Ratio(0.9);
    let curve = OverturningCurve::new(&problem);
    let (low, high) = (0.5, 8.0);
    assert!(!curve.at(low).unwrap().overturned && curve.at(high).unwrap().overturned);
    let turn = curve.turn(low, high).unwrap();
    let [before, after] = [turn * (1.0 - 1e-8), turn * (1.0 + 1e-8)].map(|s| curve.at(s).unwrap().overturned);
    assert!(before != after, "{turn}");
}

/// A point of a rocking spectrum is the motion of that block; twice the size under a shaking stretched by √2 turns as far.
#[test]
fn a_rocking_spectrum_knows_its_scale() {
    let shaking = |time: f64| History::sine(0.5, 2.0 / time, 0.3, 3.0 * time).unwrap();
    let spectrum = |time: f64| RockingSpectrum {
        friction: [0.9, 0.9],
        gravity: 1.0,
        base: BaseMotion { horizontal: Some(shaking(time)), vertical: None },
        impact: Impact::Inelastic,
        restitution: 0.0,
    };
    let (small, large) = (spectrum(1.0), spectrum(2f64.sqrt()));
    for γ in [2.5, 3.0, 5.0] {
        let [one, two] = [small.at(3.0, γ).unwrap(), large.at(6.0, γ).unwrap()];
        assert!((one.max_theta - two.max_theta).abs() < 1e-10 && one.max_theta > 0.01, "{one:?} {two:?}");
        let block = small.block(3.0, γ);
        assert!((block.b1.hypot(block.d) - 3.0).abs() < 1e-15 && (block.d / block.b1 - γ).abs() < 1e-14);
        assert!((block.rho2 - 3.0).abs() < 1e-15);
        let mut problem = MotionProblem::new(block, 1.0);
        problem.base.horizontal = Some(shaking(1.0));
        assert_eq!(simulate(&problem, Keep::default()).unwrap().max_theta, one.max_theta);
    }
}
