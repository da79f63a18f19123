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

/// The dots lie where the formulas have them, by the numbers along the axes: the joints at τ = ½ with ⅓, and the largest moment.
#[test]
fn dots_lie_on_the_curve() {
    let kappa = 0.001;
    let figure = drawn(0.0, kappa, 0.2);
    let unit = kappa * 5.0 / 4.0 * 1e3;
    // Numbers beside the axes by their places: those to the right of a plot stand below it.
    let numbers: Vec<(f64, f64, f64)> = figure
        .labels()
        .iter()
        .filter_map(|label| {
            let value = label.text.parse::<f64>().ok()?;
            Some((value, (label.rect.x0 + label.rect.x1) / 2.0, (label.rect.y0 + label.rect.y1) / 2.0))
        })
        .collect();
    let lowest = numbers.iter().map(|number| number.2).fold(0.0, f64::max);
    // θ of a place right of the axis of moments at `from`, and the moment of a height.
    let scale = |one: (f64, f64), other: (f64, f64), at: f64| {
        one.0 + (other.0 - one.0) * (at - one.1) / (other.1 - one.1)
    };
    let middle = figure.size().0 / 2.0;
    let along = |x: f64, right: bool| {
        let below = numbers.iter().filter(|number| number.2 > lowest - 4.0 && number.0 > 0.0);
        let own: Vec<_> = below.filter(|number| (number.1 > middle) == right).collect();
        let (first, last) = (own[0], own[own.len() - 1]);
        scale((first.0, first.1), (last.0, last.1), x)
    };
    let up = |y: f64| {
        let beside: Vec<_> = numbers.iter().filter(|number| number.2 < lowest - 4.0).collect();
        let [least, most] = [0.2, 1.0].map(|value| beside.iter().find(|number| number.0 == value).unwrap());
        scale((least.0, least.2), (most.0, most.2), y)
    };
    let dots: Vec<(f64, f64)> = figure
        .svg()
        .split("<circle cx=\"")
        .skip(1)
        .map(|circle| {
            let mut numbers = circle.split('"');
            let x = numbers.next().unwrap().parse().unwrap();
            (x, numbers.nth(1).unwrap().parse().unwrap())
        })
        .collect();
    let joint = (0.5 * unit, 1.0 / 3.0);
    let largest = ((18.0 * kappa * kappa).powf(-1.0 / 3.0) * unit, 1.0 - (1.5 * kappa).cbrt());
    assert_eq!(dots.len(), 3, "{dots:?}");
    for ((x, y), (turn, moment)) in dots.into_iter().zip([joint, joint, largest]) {
        let found = (along(x, x > middle), up(y));
        // Half a pixel, and a pixel of a number's box.
        let reach = if x > middle { 0.01 * largest.0 } else { 0.01 * unit };
        assert!((found.0 - turn).abs() < reach, "{found:?} {turn}");
        assert!((found.1 - moment).abs() < 0.01, "{found:?} {moment}");
    }
}
