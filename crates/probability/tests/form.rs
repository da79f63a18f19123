//! Numbers of a design point, against tables of the normal law and the geometry of a half-space.

use standfast_probability::form::{FormPoint, generalized};

/// A half-space 2 away, towards (0.6, 0.8).
fn point() -> FormPoint {
    FormPoint {
        beta: 2.0,
        u: vec![1.2, 1.6],
        values: vec![3.0, 4.0],
        alpha: vec![0.6, 0.8],
        at_change: false,
        agreeing: 3,
        starts: 5,
    }
}

/// Seen from within, the same point is −β away, and u is still β α.
#[test]
fn a_point_from_the_other_side() {
    let turned = point().turned();
    assert_eq!(turned.beta, -2.0);
    for ((u, alpha), own) in turned.u.iter().zip(&turned.alpha).zip([1.2, 1.6]) {
        assert!((u - turned.beta * alpha).abs() < 1e-15 && *u == own);
    }
    assert_eq!(
        (&turned.values, turned.at_change, turned.agreeing, turned.starts),
        (&vec![3.0, 4.0], false, 3, 5)
    );
}

/// Held at its median, an input leaves the half-space β/√(1 − α²) away: 2/0.8 and 2/0.6.
#[test]
fn an_input_that_is_held() {
    let point = point();
    for (input, away) in [(0, 2.5), (1, 2.0 / 0.6)] {
        assert!((point.beta * point.omission(input) - away).abs() < 1e-14);
    }
    let alone = FormPoint { alpha: vec![1.0, 0.0], ..point };
    assert_eq!([alone.omission(0), alone.omission(1)], [f64::INFINITY, 1.0]);
}

/// Quantiles of the normal law from tables (Abramowitz and Stegun, 26.1 and 26.5).
#[test]
fn beta_and_probability() {
    for (beta, probability) in [
        (0.0, 0.5),
        (1.0, 0.158_655_253_931_457_05),
        (1.959_963_984_540_054, 0.025),
        (2.0, 0.022_750_131_948_179_21),
        (3.090_232_306_167_813, 1e-3),
        (-1.281_551_565_544_600_4, 0.9),
    ] {
        let of = FormPoint { beta, ..point() };
        assert!((of.first_order() - probability).abs() < 1e-14, "{beta}");
        assert!((generalized(probability) - beta).abs() < 1e-12, "{probability}");
    }
}
