//! Moment and rotation of an elastic base: the numbers of its caption are those of the formulas, its labels keep apart, and it is drawn for
//! every kind of base.

use standfast::ground::elastic::ElasticBase;
use standfast_figures::{Figure, RotationCurve, rotation_curve};

fn drawn(omega: f64, kappa: f64, share: f64) -> Figure {
    // B = 5 m, P = 2 MN/m, d = 4 m.
    let (half, p, height) = (5.0, 2e6, 4.0);
    let base = ElasticBase::new(half, p, p * height / (kappa * half * half * half)).unwrap();
    let base = if omega > 0.0 { base.with_strength(p / (2.0 * half * omega)).unwrap() } else { base };
    let curve = RotationCurve { base, height, moment: -share * p * half, title: "Block" };
    rotation_curve(&curve).unwrap().unwrap()
}

/// The numbers behind words of a caption.
fn after(caption: &str, words: &str) -> f64 {
    let (_, rest) = caption.split_once(words).unwrap_or_else(|| panic!("{words} is not in: {caption}"));
    let number: String = rest.trim_start().chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    number.trim_end_matches('.').parse().unwrap_or_else(|_| panic!("{words}: {rest}"))
}

/// κ = 0.001 and no strength: joint ½, largest 1 − (3κ/2)^⅓ at (18κ²)^−⅓; full load ε = 0.2 in full contact, τ = 0.3.
#[test]
fn the_caption_has_the_numbers_of_the_formulas() {
    let kappa = 0.001;
    let figure = drawn(0.0, kappa, 0.2);
    let caption = figure.caption();
    // θ of τ = 1 is κB/d.
    let unit = kappa * 5.0 / 4.0 * 1e3;
    let near = |words: &str, expected: f64| {
        let found = after(caption, words);
        assert!((found / expected - 1.0).abs() < 6e-3, "{words}: {found}, {expected}: {caption}");
    };
    near("is 1 at", unit);
    near("full contact up to", 0.5 * unit);
    near("Full load (diamond): 0.2 at", 0.3 * unit);
    near("the largest is", 1.0 - (1.5 * kappa).cbrt());
    let at = format!("the largest is {} at", after(caption, "the largest is"));
    near(&at, (18.0 * kappa * kappa).powf(-1.0 / 3.0) * unit);
    assert!(!caption.contains("overturns"), "{caption}");

    // ω = 0.3: 1 − ω − (9κ²/256)^⅓/ω, with the joint at 1/(8ω²), if κ is small enough.
    let (omega, kappa) = (0.3, 0.02);
    let figure = drawn(omega, kappa, 0.69);
    let caption = figure.caption();
    let unit = kappa * 5.0 / 4.0 * 1e3;
    let near = |words: &str, expected: f64| {
        let found = after(caption, words);
        assert!((found / expected - 1.0).abs() < 6e-3, "{words}: {found}, {expected}: {caption}");
    };
    near("uplift up to", unit / (8.0 * omega * omega));
    near("the largest is", 1.0 - omega - (9.0 * kappa * kappa / 256.0_f64).cbrt() / omega);
    assert!(caption.contains("it overturns") && caption.contains("1 − ω = 0.7"), "{caption}");
}

#[test]
fn every_kind_of_base_is_drawn_with_labels_that_keep_apart() {
    for omega in [0.0, 1e-4, 0.05, 0.3, 0.5, 0.7, 0.97] {
        for kappa in [1e-7, 1e-4, 0.003, 0.05, 0.4, 0.7, 5.0] {
            for share in [0.0, 0.1, 0.33, 0.6, 0.95, 1.4] {
                let figure = drawn(omega, kappa, share);
                let labels = figure.labels();
                for (i, one) in labels.iter().enumerate() {
                    let inside = one.rect.x0 >= 0.0 && one.rect.x1 <= figure.size().0;
                    assert!(inside, "{omega} {kappa} {share}: {} leaves the page", one.text);
                    for other in &labels[i + 1..] {
                        let apart = !one.rect.overlaps(&other.rect);
                        assert!(apart, "{omega} {kappa} {share}: {} on {}", one.text, other.text);
                    }
                }
                assert!(
                    !figure.svg().contains("NaN") && !figure.svg().contains("inf"),
                    "{omega} {kappa} {share}"
                );
                assert_eq!(figure.svg(), drawn(omega, kappa, share).svg());
            }
        }
    }
}

/// A base that cannot carry the weight has no such curve.
#[test]
fn a_base_that_is_crushed_has_none() {
    let base = ElasticBase::new(5.0, 2e6, 1e8).unwrap().with_strength(2e5).unwrap();
    assert_eq!(rotation_curve(&RotationCurve { base, height: 4.0, moment: 0.0, title: "" }), Ok(None));
}
