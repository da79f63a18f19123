//! Motions whose end is known in closed form, and those known by quadrature.

use standfast::Mode;
use standfast::contact::Block;
use standfast_motion::{
    BaseMotion, End, History, Impact, Initial, Keep, LoadInTime, MotionOutcome, MotionProblem, Why, simulate,
};

fn run(problem: &MotionProblem) -> MotionOutcome {
    simulate(problem, Keep::default()).expect("a problem")
}

/// A squat block that can only slide, g = 1, pulled to the left at C by `history`.
fn sliding(friction: f64, history: History) -> MotionOutcome {
    let mut problem = MotionProblem::new(Block::uniform(0.05, friction), 1.0);
    problem.loads.push(LoadInTime { at: [0.0, 0.0], direction: [-1.0, 0.0], follows: false, history });
    run(&problem)
}

fn same(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1e-3), "{found} {expected}");
}

/// To rounding, of the distance a body without friction would go.
fn same_slide(outcome: &MotionOutcome, expected: f64, free: f64) {
    assert!((-outcome.slide - expected).abs() <= 4e-16 * free, "{} {expected}", outcome.slide);
    assert!((outcome.max_slide - expected).abs() <= 4e-16 * free, "{} {expected}", outcome.max_slide);
    let largest = outcome.work.abs().max(outcome.friction_loss);
    assert!(outcome.energy_residual().abs() <= 1e-13 * largest, "{outcome:?}");
    assert_eq!(outcome.end, End::AtRest);
    let whys: Vec<Why> = outcome.events.iter().map(|event| event.why).collect();
    assert_eq!(whys[whys.len() - 2..], [Why::Stop, Why::Rest], "{whys:?}");
}

#[test]
fn rectangle_slides() {
    for (k, μ, t) in [(0.8_f64, 0.5_f64, 1.3_f64), (0.3, 0.2, 0.7), (3.0, 0.9, 0.1)] {
        same_slide(&sliding(μ, History::rect(k, t).unwrap()), (k - μ) * k * t * t / (2.0 * μ), k * t * t);
    }
}

#[test]
fn decay_slides() {
    for (k, μ, t) in [(0.8_f64, 0.5_f64, 1.3_f64), (0.9, 0.2, 0.7), (3.0, 0.9, 0.1), (0.5, 0.25, 2.0)] {
        let d = k - μ;
        let expected = if d <= μ {
            2.0 * t * t * d.powi(3) / (3.0 * k * k)
        } else {
            let (v, a) = (t * d * d / (2.0 * k), μ * t / k);
            let end = v - μ * μ * t / (2.0 * k);
            t * t * d.powi(3) / (3.0 * k * k) + v * a - k * a.powi(3) / (6.0 * t) + end * end / (2.0 * μ)
        };
        same_slide(&sliding(μ, History::decay(k, t).unwrap()), expected, k * t * t);
    }
}

#[test]
fn triangle_slides() {
    for (k, μ, t) in [(0.8_f64, 0.5_f64, 1.3_f64), (0.9, 0.2, 0.7), (3.0, 0.9, 0.1), (0.8, 0.5, 2.0)] {
        let d = k - μ;
        let expected = if d <= μ / 2f64.sqrt() {
            t * t * d.powi(3) / (k * k) * (0.25 + 1.0 / (3.0 * 2f64.sqrt()))
        } else {
            let (v, a) = (t * d * d / (2.0 * k), μ * t / (2.0 * k));
            let end = v - μ * μ * t / (4.0 * k);
            t * t * d.powi(3) / (4.0 * k * k) + v * a - k * a.powi(3) / (3.0 * t) + end * end / (2.0 * μ)
        };
        same_slide(&sliding(μ, History::triangle(k, t / 2.0, t).unwrap()), expected, k * t * t);
    }
}

#[test]
fn half_sine_slides() {
    for (k, μ, t) in [(0.8_f64, 0.5_f64, 1.3_f64), (0.8, 0.6, 1.3), (0.9, 0.2, 0.7), (3.0, 0.9, 0.1)] {
        let (w, φ) = (std::f64::consts::PI / t, (μ / k).asin());
        let v = |x: f64| (k * (φ.cos() - x.cos()) - μ * (x - φ)) / w;
        let s =
            |x: f64| (k * ((x - φ) * φ.cos() - x.sin() + φ.sin()) - μ * (x - φ) * (x - φ) / 2.0) / (w * w);
        let pi = std::f64::consts::PI;
        let expected = if μ / k <= 0.724611 {
            s(pi) + v(pi) * v(pi) / (2.0 * μ)
        } else {
            let (mut low, mut high) = (pi - φ, pi);
            for _ in 0..80 {
                let middle = 0.5 * (low + high);
                if v(middle) > 0.0 { low = middle } else { high = middle }
            }
            s(low)
        };
        same_slide(&sliding(μ, History::half_sine(k, t).unwrap()), expected, k * t * t);
    }
}

/// Thrust and uplift in one triangle on a body with added mass, and Goda's caisson with both times 1.5.
#[test]
fn thrust_with_uplift_slides() {
    // Per weight of the caisson, W' = 1: S = F_S/R.
    for (s, μ, uplift, added, duration) in
        [(1.2, 0.6, 0.2, 0.15, 1.0), (1.9, 0.6, 0.3, 0.2, 0.5), (1.5, 0.5, 0.0, 0.0, 2.0)]
    {
        let mut block = Block::uniform(0.05, μ);
        block.m_x = 1.0 + added;
        let mut problem = MotionProblem::new(block, 1.0);
        let r = μ;
        let thrust = s * r - μ * uplift;
        let history = History::triangle(1.0, duration / 2.0, duration).unwrap();
        let pull =
            |direction| LoadInTime { at: [0.0, 0.0], direction, follows: false, history: history.clone() };
        problem.loads = vec![pull([-thrust, 0.0]), pull([0.0, uplift])];
        let root = 2f64.sqrt();
        let shape = if s <= 1.0 + 1.0 / root {
            (0.25 + root / 6.0) * (s - 1.0_f64).powi(3) / (s * s)
        } else {
            (s - 1.0).powi(2) / 8.0 - 1.0 / (96.0 * s * s)
        };
        let outcome = run(&problem);
        same(-outcome.slide, shape * r * duration * duration / block.m_x, 1e-13);
    }
}

/// ∫ of a smooth function by Gauss–Legendre on many panels, for the quadratures below.
fn quadrature(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let nodes = [0.1834346424956498, 0.525532409916329, 0.7966664774136267, 0.9602898564975363];
    let weights = [0.362683783378362, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763];
    let panels = 400;
    let h = (to - from) / f64::from(panels);
    let mut sum = 0.0;
    for i in 0..panels {
        let middle = from + (f64::from(i) + 0.5) * h;
        for (x, w) in nodes.iter().zip(weights) {
            sum += w * (f(middle + 0.5 * h * x) + f(middle - 0.5 * h * x));
        }
    }
    sum * 0.5 * h
}

/// Released at θ₀, a block that does not slip meets the base after a time that a quadrature gives: θ̇² = 2p²(cos(α−θ) …) by energy.
#[test]
fn quarter_period_by_quadrature() {
    for (γ, θ0, eccentric) in [(2.264_f64, 0.2_f64, 1.0), (4.0, -0.1, 1.0), (3.0, 0.15, 1.3), (1.2, 0.4, 0.8)]
    {
        let mut block = Block::uniform(γ, 50.0);
        (block.b1, block.b2) = (eccentric, 2.0 - eccentric);
        let b = if θ0 > 0.0 { block.b1 } else { block.b2 };
        let mut problem = MotionProblem::new(block, 1.0);
        problem.initial.theta = θ0;
        problem.t_max = Some(50.0);
        let outcome = run(&problem);
        let inertia = block.rho2 + b * b + γ * γ;
        // Height of C: h(θ) = γ cosθ + b sin|θ|; with θ = θ₀ − s² the root at the start is smooth.
        let a = θ0.abs();
        let height = |θ: f64| γ * θ.cos() + b * θ.sin();
        let rate = |θ: f64| (2.0 * (height(a) - height(θ)) / inertia).sqrt();
        let time = quadrature(0.0, a.sqrt(), |s| {
            if s < 1e-5 {
                let slope = γ * -a.sin() + b * a.cos();
                2.0 / (2.0 * slope / inertia).sqrt()
            } else {
                2.0 * s / rate(a - s * s)
            }
        });
        let impact = outcome.events[1];
        assert_eq!(impact.why, Why::Impact);
        same(impact.t, time, 1e-10);
        assert!(outcome.energy_residual().abs() < 1e-12, "{}", outcome.energy_residual());
    }
}

/// Under a sudden force that lasts, rocking reaches its crest where the work equals the rise: k[1 − cosθ₁ + (1+k')γ sinθ₁] in B.
#[test]
fn rectangular_pulse_overturns_beyond_its_energy() {
    let (γ, k_prime, k) = (2.5_f64, 0.4_f64, 0.9_f64);
    let block = Block::uniform(γ, 50.0);
    let pulse = |duration: f64| {
        let mut problem = MotionProblem::new(block, 1.0);
        problem.loads.push(LoadInTime {
            at: [0.0, k_prime * γ],
            direction: [-1.0, 0.0],
            follows: false,
            history: History::rect(k, duration).unwrap(),
        });
        run(&problem)
    };
    let (mut low, mut high) = (0.1, 5.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if pulse(middle).overturned() { high = middle } else { low = middle }
    }
    // θ at the end of the least pulse: that of the work that lifts C to R.
    let mut problem = MotionProblem::new(block, 1.0);
    problem.loads.push(LoadInTime {
        at: [0.0, k_prime * γ],
        direction: [-1.0, 0.0],
        follows: false,
        history: History::rect(k, low).unwrap(),
    });
    let outcome = simulate(&problem, Keep { steps: true }).unwrap();
    let θ = outcome.at(low).unwrap().theta;
    let work = k * (1.0 - θ.cos() + (1.0 + k_prime) * γ * θ.sin());
    same(work, (1.0 + γ * γ).sqrt() - γ, 1e-8);
    same(outcome.max_theta, (1.0_f64 / γ).atan(), 1e-3);
}

/// The ratio of rates at an impact of a uniform block, with friction that suffices and that does not.
#[test]
fn impact_of_a_uniform_block() {
    for (γ, μ) in [(3.0_f64, 0.5), (3.0, 0.2), (1.5, 0.3), (2.0, 0.36), (2.0, 0.1)] {
        // Enough to rock without slip before, and not so much that slip after could not go on.
        let mut problem = MotionProblem::new(Block::uniform(γ, 1.0), 1.0);
        problem.mu_impact = Some(μ);
        problem.initial.theta = 0.1;
        problem.t_max = Some(30.0);
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let impact = outcome.events.iter().find(|event| event.why == Why::Impact).unwrap().t;
        let i = outcome.steps.iter().position(|step| step.t == impact).unwrap();
        let before = outcome.at(impact - 1e-9).unwrap().omega;
        let after = outcome.at(outcome.steps[i].t).unwrap().omega;
        let square = γ * γ;
        let least = 3.0 * γ / (1.0 + 4.0 * square);
        let inertia = (1.0 + square) / 3.0;
        let expected = if μ >= least {
            (2.0 * square - 1.0) / (2.0 * (1.0 + square))
        } else {
            1.0 - 2.0 * (1.0 - μ * γ) / (inertia + 1.0 - μ * γ)
        };
        assert!((after / before - expected).abs() < 1e-7, "γ {γ} μ {μ}: {} {expected}", after / before);
    }
}

/// A base that slides where no state with slip satisfies all conditions: the corner grips.
#[test]
fn grip() {
    for (γ, μ, v) in [(2.0_f64, 3.0, 0.4), (2.0, 3.0, -0.4), (3.0, 2.5, 0.1)] {
        let block = Block::uniform(γ, μ);
        let mut problem = MotionProblem::new(block, 1.0);
        problem.initial = Initial { vx: Some(v), ..Initial::default() };
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let events: Vec<Why> = outcome.events.iter().map(|event| event.why).collect();
        assert_eq!(events[..2], [Why::Start, Why::Grip], "{γ} {μ}");
        let ω = outcome.at(0.0).unwrap().omega;
        let expected = γ * v.abs() / (block.rho2 + 1.0 + γ * γ);
        same(ω.abs(), expected, 1e-14);
        assert_eq!(outcome.events[1].state, if v > 0.0 { Mode::RockOPrime } else { Mode::RockO });
    }
}

/// Slip whose inertia D vanishes as the body turns ends in a grip: nothing is left of the corner's velocity, the moment of momentum about
/// the corner is that before, and energy is booked.
#[test]
fn slip_grips_where_its_inertia_vanishes() {
    let block = Block::uniform(0.6573676837640116, 1.8420933769674237);
    let mut problem = MotionProblem::new(block, 1.0);
    for (at, history) in [
        ([1.0, -0.22067149144541764], History::decay(3.3364840908840914, 3.842980680714501)),
        ([0.0, -0.5956715006040095], History::half_sine(2.450279401831512, 5.27125398162278)),
    ] {
        let history = history.unwrap();
        problem.loads.push(LoadInTime { at, direction: [-1.0, 0.0], follows: false, history });
    }
    problem.initial = Initial { vx: Some(-0.09300327017199594), ..Initial::default() };
    for impact_friction in [None, Some(1.1)] {
        problem.mu_impact = impact_friction;
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let grip = outcome.events.iter().find(|event| event.why == Why::Grip).expect("a grip").t;
        let θ = outcome.at(grip).unwrap().theta;
        let (c, h) = (-θ.cos() + block.d * θ.sin(), block.d * θ.cos() + θ.sin());
        let inertia = block.rho2 + c * (c + block.mu_k * h);
        assert!(inertia.abs() < 2e-9 * block.rho2, "{inertia}");
        // The corner stays on the base: ẏ = −cω.
        let [before, after] = [grip - 1e-12, grip].map(|t| {
            let (vx, ω) = (outcome.moment(t, false).unwrap().velocity[0], outcome.at(t).unwrap().omega);
            [vx + h * ω, (block.rho2 + c * c) * ω - h * vx]
        });
        assert!(before[0] < -0.1 && after[0].abs() < 1e-12, "{before:?} {after:?}");
        same(after[1], before[1], 1e-9);
        assert!(outcome.energy_residual().abs() <= 1e-10 * outcome.work);
        assert!(outcome.max_slide >= outcome.slide.abs());
    }
}

/// One sine of base acceleration: overturning is not monotone in its amplitude.
#[test]
fn one_sine_pulse_overturns_in_two_ranges() {
    let (α, μ, r) = (0.25_f64, 50.0, 0.9);
    let γ = 1.0 / α.tan();
    let block = Block::uniform(γ, μ);
    // p² = 3g/(4R), ω/p = 5.
    let p = (3.0 / (4.0 * (1.0 + γ * γ).sqrt())).sqrt();
    let ω = 5.0 * p;
    let overturns = |amplitude: f64| {
        let sine = α.tan() / (amplitude * α);
        let phase = sine.asin();
        let duration = (2.0 * std::f64::consts::PI - phase) / ω;
        let mut problem = MotionProblem::new(block, 1.0);
        problem.impact = Impact::Ratio(r);
        problem.base = BaseMotion {
            horizontal: Some(History::sine(amplitude * α, ω, phase, duration).unwrap()),
            vertical: None,
        };
        run(&problem).overturned()
    };
    for (amplitude, expected) in [
        (2.0, false),
        (3.0323, false),
        (3.0324, true),
        (5.0, true),
        (6.7429, true),
        (6.7431, false),
        (7.4929, false),
        (7.4931, true),
        (9.0, true),
    ] {
        assert_eq!(overturns(amplitude), expected, "A = {amplitude}");
    }
}
