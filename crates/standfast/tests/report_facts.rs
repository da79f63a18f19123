//! What the report says of its curves beside its numbered equations, at random bodies: orders of points, slopes, and the three products
//! behind "exactly one mode".

mod common;

use common::Random;
use standfast::initiation::{Chart, PointName};

/// A body, and a force of an elevation between these.
fn chart(random: &mut Random, from: f64, to: f64) -> Chart {
    let gamma = random.uniform(-3.0, 3.0).exp();
    Chart::new(gamma, random.uniform(from, to)).unwrap()
}

/// (4 + γ²)/(3γ), the friction of B', is 4/3 for γ = 2 and more for every other body.
#[test]
fn the_friction_of_b_prime_is_least_at_slenderness_two() {
    let at = |gamma| Chart::new(gamma, -0.5).unwrap().mu_b_prime();
    assert!((at(2.0) - 4.0 / 3.0).abs() < 1e-15);
    let mut random = Random(41);
    for _ in 0..10_000 {
        let gamma = random.uniform(-3.0, 3.0).exp();
        assert!(at(gamma) >= at(2.0) && (gamma - 2.0).abs() < 1e-3 || at(gamma) > at(2.0), "{gamma}");
    }
}

/// D lies left of A for q > ½, right of it for q < ½, and above or below the same k for q = ½.
#[test]
fn d_and_a_change_sides_at_half_the_height_below_the_centre() {
    let mut random = Random(42);
    for _ in 0..10_000 {
        let chart = chart(&mut random, -0.999, -0.001);
        let q = -chart.k_prime();
        if (q - 0.5).abs() > 1e-9 {
            assert_eq!(chart.k_d() < chart.k_a(), q > 0.5, "{chart:?}");
        }
        let half = Chart::new(chart.gamma(), -0.5).unwrap();
        assert!((half.k_d() / half.k_a() - 1.0).abs() < 1e-14);
    }
}

/// F lies left of D, by (4 + γ²)/(aγq).
#[test]
fn f_lies_left_of_d() {
    let mut random = Random(43);
    for _ in 0..10_000 {
        let chart = chart(&mut random, -0.999, -0.001);
        let (gamma, [a, ..]) = (chart.gamma(), chart.coefficients());
        let f = chart.point(PointName::F).expect("a force below the centre has it").k;
        let apart = (4.0 + gamma * gamma) / (a * gamma * -chart.k_prime());
        assert!(f < chart.k_d() && (chart.k_d() - f - apart).abs() < 1e-12 * chart.k_d(), "{chart:?}");
    }
}

/// Rest narrows as the body gets more slender, and widens as the force comes lower.
#[test]
fn rest_widens_with_lower_bodies_and_lower_forces() {
    let mut random = Random(44);
    for _ in 0..10_000 {
        let chart = chart(&mut random, -0.999, 3.0);
        let (gamma, k_prime) = (chart.gamma(), chart.k_prime());
        assert!(Chart::new(1.01 * gamma, k_prime).unwrap().k_a() < chart.k_a());
        assert!(Chart::new(gamma, k_prime + 0.01).unwrap().k_a() < chart.k_a());
    }
}

/// While f_x ≥ 0, that is while a k + b ≥ 0, a higher force makes rocking easier: μ* falls with k'.
#[test]
fn a_higher_force_rocks_at_less_friction_while_the_base_pushes_back() {
    let mut random = Random(45);
    let mut seen = 0;
    while seen < 10_000 {
        let chart = chart(&mut random, -0.999, 3.0);
        let higher = Chart::new(chart.gamma(), chart.k_prime() + 1e-3).unwrap();
        let k = chart.k_a() * random.uniform(1.0, 20.0);
        let [here, there] = [chart, higher].map(|chart| chart.mu_star().at(k));
        if there > 0.0 {
            seen += 1;
            assert!(there < here, "{chart:?} {k}");
        }
    }
}

/// The products that tell where two boundaries change their order.
#[test]
fn boundaries_change_their_order_where_the_products_say() {
    let mut random = Random(46);
    for _ in 0..20_000 {
        let chart = chart(&mut random, -0.999, 3.0);
        let (gamma, k_prime, k_a) = (chart.gamma(), chart.k_prime(), chart.k_a());
        let [a, b, c, d] = chart.coefficients();
        let k = k_a * random.uniform(0.01, 20.0);
        let size = (a * k).abs() + b + (c * k + d) * (k + 1.0 / gamma + (k * k_prime).abs());
        let close = |left: f64, right: f64| {
            assert!((left - right).abs() <= 1e-12 * size, "{chart:?} {k}: {left} {right}");
        };
        // μ* against μ = k.
        close(a * k + b - k * (c * k + d), -c * (k - k_a) * (k + gamma));
        // μ* against the upper line.
        let upper = chart.upper_line().at(k);
        let zero = (1.0 + gamma * gamma) / (3.0 * gamma);
        close(a * k + b - upper * (c * k + d), c * (k - k_a) * (k * k_prime + zero));
        // μ** against the lower line, for a force below the centre.
        if k_prime < 0.0 {
            let q = -k_prime;
            let product = (1.0 + gamma * k * (1.0 - q)) * (1.0 + gamma * gamma + 3.0 * q * gamma * k) / gamma;
            close(a * k - b - chart.lower_line().at(k) * (d - c * k), product);
            assert!(product > 0.0);
        }
    }
}
