//! The regions of the k–μ plane, its points and margins, against the decision and the curves that define them.

mod common;

use std::ops::Range;

use common::{Boundary, Random, tries};
use standfast::initiation::{Bounds, Chart, ChartCase, Crossing, NamedPoint, PointName, enumerate};
use standfast::{Diagram, Mode, Modes, Point};

/// Bodies and elevations of every case, thresholds and special values included.
fn charts() -> Vec<Chart> {
    let mut charts = Vec::new();
    for gamma in [0.05, 0.3, 0.5f64.sqrt(), 1.0, 2f64.sqrt(), 2.0, 3.0, 4.0, 10.0, 20.0] {
        let g2: f64 = gamma * gamma;
        let thresholds = [(1.0 + g2) / (3.0 * g2), (4.0 + g2) / (3.0 * g2), -(1.0 + g2) / (4.0 + g2)];
        let fixed =
            [-200.0, -3.0, -1.2, -1.0, -0.95, -0.6, -0.5, -0.2, -0.01, 0.0, 0.01, 0.4, 0.8, 1.0, 1.7, 200.0];
        charts.extend(fixed.into_iter().chain(thresholds).map(|k_prime| Chart::new(gamma, k_prime).unwrap()));
    }
    charts
}

fn close(left: f64, right: f64, size: f64) -> bool {
    (left - right).abs() <= 1e-9 * size
}

/// Regions cover the plane without overlap, and each holds its mode, checked at random points of the window and
/// far outside it.
#[test]
fn every_point_lies_in_the_region_of_its_mode() {
    let mut random = Random(31);
    for chart in charts() {
        let diagram = Diagram::of(chart);
        let window = diagram.window();
        for _ in 0..500 {
            let far = random.pick(&[0.3, 1.0, 20.0]);
            let (k, mu) = (random.uniform(0.0, far * window.k), random.uniform(0.0, far * window.mu));
            let mode = diagram.mode_at(k, mu).unwrap();
            let holders: Modes = diagram
                .regions()
                .iter()
                .filter(|region| region.contains(k, mu))
                .map(|region| region.mode)
                .collect();
            assert_eq!(holders, [mode].into_iter().collect(), "{chart:?} at ({k}, {mu})");
        }
    }
}

/// The window shows every named point the chart has, and each case has the points the report gives it.
#[test]
fn the_window_shows_all_named_points() {
    use PointName::{A, BPrime, C, CPrime, D, E, F};
    for chart in charts() {
        let window = Diagram::of(chart).window();
        for point in chart.points() {
            assert!(point.k < window.k && point.mu < window.mu, "{chart:?} {point:?} {window:?}");
        }
        // A fifth is left beside the farthest of them; of those on an axis, and where there is none, beside 1/γ.
        let farthest =
            |of: fn(&NamedPoint) -> f64| chart.points().iter().map(of).fold(1.0 / chart.gamma(), f64::max);
        for (edge, farthest) in [(window.k, farthest(|p| p.k)), (window.mu, farthest(|p| p.mu))] {
            assert!((0.8 * edge / farthest - 1.0).abs() < 1e-15, "{chart:?} {window:?}");
        }
        let expected = match chart.case() {
            ChartCase::OneA | ChartCase::OneB => vec![A, C, D],
            ChartCase::TwoThree => vec![A, C, D, E],
            ChartCase::DeltaPositive => vec![A, BPrime, CPrime, D, F],
            ChartCase::DeltaNotPositive => vec![A, CPrime, D, F],
            ChartCase::BelowBase => vec![A, D],
        };
        let absent = match chart.k_prime() {
            0.0 => vec![D],
            -1.0 => vec![A, CPrime],
            _ => vec![],
        };
        let expected: Vec<PointName> = expected.into_iter().filter(|name| !absent.contains(name)).collect();
        let found: Vec<PointName> = chart.points().iter().map(|point| point.name).collect();
        assert_eq!(found, expected, "{chart:?}");
    }
}

#[test]
fn strips_follow_one_another_and_do_not_cross() {
    for chart in charts() {
        for region in Diagram::of(chart).regions() {
            for pair in region.strips.windows(2) {
                assert_eq!(pair[0].to, pair[1].from, "{chart:?} {}", region.mode);
            }
            for strip in &region.strips {
                for i in 0..=20 {
                    let end = if strip.to.is_finite() { strip.to } else { 100.0 * (strip.from + 1.0) };
                    let k = strip.from + (end - strip.from) * f64::from(i) / 20.0;
                    let (low, high) =
                        (strip.lower.at(k), strip.upper.map_or(f64::INFINITY, |upper| upper.at(k)));
                    assert!(low <= high + 1e-9 * (1.0 + low.abs()), "{chart:?} {} at k = {k}", region.mode);
                    assert!(low >= -1e-9 * (1.0 + 1.0 / chart.gamma()), "{chart:?} {}", region.mode);
                }
            }
        }
    }
}

/// The unresolved parts are exactly where the enumeration finds more than one mode.
#[test]
fn unresolved_parts_are_where_several_modes_are_consistent() {
    let mut random = Random(32);
    let mut hits = 0;
    for chart in charts().into_iter().filter(|chart| (-1.0..0.0).contains(&chart.k_prime())) {
        let parts = Diagram::of(chart).unresolved();
        for _ in 0..tries(2000) {
            let k = random.uniform(0.0, 8.0 * chart.k_a().max(chart.k_b_prime()).min(1e3));
            let mu = random.uniform(0.0, 1.5 * (chart.upper_line().at(k) + 1.0));
            let point = Point::new(chart.gamma(), chart.k_prime(), k, mu).unwrap();
            let inside: Vec<_> = parts.iter().filter(|part| part.contains(k, mu)).collect();
            if point.is_unique() {
                assert!(inside.is_empty(), "{point:?}");
            } else {
                hits += 1;
                assert_eq!(inside.len(), 1, "{point:?}");
                assert_eq!(inside[0].modes, enumerate(&point), "{point:?}");
                assert_eq!(inside[0].resolved_as, point.mode());
            }
        }
    }
    assert!(hits > tries(1000), "{hits}");
}

#[test]
fn before_resolution_a_mode_claims_the_parts_it_loses() {
    let names = |diagram: &Diagram, mode| {
        let (region, parts) = diagram.before_resolution(mode);
        (region.is_some(), parts.iter().map(|part| part.name).collect::<Vec<_>>())
    };
    let positive = Diagram::new(4.0, -0.55).unwrap(); // Figs. 4.4a–4.6a
    assert_eq!(names(&positive, Mode::RockO), (true, vec!["BB'C'C", "CC'C''"]));
    assert_eq!(names(&positive, Mode::SlideRockOLeft), (true, vec!["BB'C'C", "CC'C''"]));
    assert_eq!(names(&positive, Mode::SlideRockOPrimeLeft), (true, vec![]));
    let negative = Diagram::new(1.0, -0.6).unwrap(); // Figs. 4.4b–4.6b
    assert_eq!(names(&negative, Mode::SlideRockOLeft), (false, vec!["BAC'C", "CC'C''"]));
    assert_eq!(names(&negative, Mode::SlideLeft), (true, vec![]));
    assert!(Diagram::new(1.0, -1.0).unwrap().unresolved().is_empty());
    assert!(Diagram::new(1.0, 0.5).unwrap().unresolved().is_empty());
}

#[test]
fn named_points_satisfy_the_curves_that_define_them() {
    for chart in charts() {
        let [a, b, c, d] = chart.coefficients();
        let (upper, lower, mu_star) = (chart.upper_line(), chart.lower_line(), chart.mu_star());
        for point in chart.points() {
            let on = |mu: f64, terms: f64| {
                let size = point.mu.abs() + terms.abs() + 1.0 / chart.gamma();
                assert!(close(point.mu, mu, size), "{chart:?} {point:?}: {mu}");
            };
            let along = point.k * chart.k_prime();
            match point.name {
                PointName::A => {
                    on(point.k, 0.0);
                    if chart.k_prime() < -1.0 {
                        on(lower.at(point.k), along);
                        on(chart.mu_star_star().at(point.k), 0.0);
                    } else {
                        on(upper.at(point.k), along);
                        on(mu_star.at(point.k), 0.0);
                    }
                }
                PointName::BPrime => {
                    on(upper.at(point.k), along);
                    on(mu_star.at(point.k), 0.0);
                    assert!(point.k > chart.k_a() && point.mu >= 4.0 / 3.0);
                }
                PointName::C => on(upper.at(0.0), 0.0),
                PointName::CPrime => {
                    on(lower.at(point.k), along);
                    on(mu_star.at(point.k), along);
                    assert!(point.k > chart.k_a() && point.k >= chart.k_b_prime() * (1.0 - 1e-12));
                }
                PointName::D => {
                    assert_eq!(point.mu, 0.0);
                    let line = if chart.k_prime() < 0.0 { lower } else { upper };
                    on(line.at(point.k), along);
                }
                PointName::E => assert!(close(a * point.k, -b, b) && point.k > chart.k_d()),
                PointName::F => assert!(close(a * point.k, b, b) && point.k < chart.k_d()),
            }
            assert!(c.is_finite() && d > 0.0);
        }
    }
}

/// The table "Bodies that show every feature" of the figures' specification, to its digits.
#[test]
fn published_coordinates() {
    let at = |gamma, k_prime, name| {
        let point = Chart::new(gamma, k_prime).unwrap().point(name).unwrap();
        (format!("{:.4}", point.k), format!("{:.4}", point.mu))
    };
    let pair = |k: &str, mu: &str| (k.to_owned(), mu.to_owned());
    use PointName::{A, BPrime, C, CPrime, D, E, F};
    assert_eq!(at(1.0, 0.4, A), pair("0.7143", "0.7143"));
    assert_eq!(at(1.0, 0.4, C), pair("0.0000", "1.0000"));
    assert_eq!(at(1.0, 0.4, D), pair("2.5000", "0.0000"));
    assert_eq!(at(2.0, 0.55, A), pair("0.3226", "0.3226"));
    assert_eq!(at(2.0, 0.55, D), pair("0.9091", "0.0000"));
    assert_eq!(at(3.0, 0.8, A), pair("0.1852", "0.1852"));
    assert_eq!(at(3.0, 0.8, E), pair("1.0465", "0.0000"));
    assert_eq!(at(1.0, -0.6, A), pair("2.5000", "2.5000"));
    assert_eq!(at(1.0, -0.6, D), pair("1.6667", "0.0000"));
    assert_eq!(at(1.0, -0.6, F), pair("0.4412", "0.0000"));
    assert_eq!(at(1.0, -0.6, CPrime), pair("8.2855", "3.9713"));
    assert_eq!(at(4.0, -0.55, BPrime), pair("2.5758", "1.6667"));
    assert_eq!(at(4.0, -0.55, CPrime), pair("5.7071", "2.8889"));
    assert_eq!(at(4.0, -0.55, F), pair("0.2586", "0.0000"));

    let ratios = |gamma, k_prime| {
        let [a, b, c, d] = Chart::new(gamma, k_prime).unwrap().coefficients();
        [a.abs() / c, b / d, d / c].map(|ratio| format!("{ratio:.4}"))
    };
    assert_eq!(ratios(1.0, 0.4)[..2], ["0.9048", "0.6000"]);
    assert_eq!(ratios(2.0, 0.55)[..2], ["0.1505", "0.3529"]);
    assert_eq!(ratios(3.0, 0.8)[0], "0.5309");
    assert_eq!(ratios(1.0, -0.6)[0], "5.6667");
    assert_eq!(ratios(1.0, -0.6)[2], "4.1667");
}

#[test]
fn cases_change_at_the_reports_thresholds() {
    let case = |gamma, k_prime| Chart::new(gamma, k_prime).unwrap().case();
    assert_eq!(case(1.0, 0.4), ChartCase::OneA);
    assert_eq!(case(1.0, 1.0), ChartCase::OneB);
    assert_eq!(case(2.0, 0.55), ChartCase::OneB);
    assert_eq!(case(3.0, 0.8), ChartCase::TwoThree);
    assert_eq!(case(4.0, -0.55), ChartCase::DeltaPositive);
    assert_eq!(case(1.0, -0.6), ChartCase::DeltaNotPositive);
    assert_eq!(case(1.0, -1.0), ChartCase::DeltaNotPositive);
    assert_eq!(case(1.0, -1.5), ChartCase::BelowBase);
    // Cases 2 and 3 need γ > √2, case 1b γ > 1/√2, for a force on the body.
    assert_eq!(case(1.414, 1.0), ChartCase::OneB);
    assert_eq!(case(1.415, 1.0), ChartCase::TwoThree);
    assert_eq!(case(0.707, 1.0), ChartCase::OneA);
    assert_eq!(case(0.708, 1.0), ChartCase::OneB);
}

#[test]
fn a_curve_s_slope_and_inverse_agree_with_its_values() {
    let mut random = Random(33);
    for chart in charts() {
        for curve in [chart.upper_line(), chart.mu_star(), chart.mu_star_rising()] {
            let k = random.uniform(0.1, 3.0);
            let step = 1e-6 * k;
            let difference = (curve.at(k + step) - curve.at(k - step)) / (2.0 * step);
            let scale = curve.slope(k).abs() + curve.at(k).abs() / k;
            assert!((difference - curve.slope(k)).abs() <= 1e-5 * scale, "{chart:?} {curve:?}");
            if curve.slope(k).abs() > 1e-3 * curve.at(k).abs() / k {
                assert!(close(curve.k_at(curve.at(k)).unwrap(), k, 1e4 * k), "{chart:?} {curve:?}");
            }
        }
    }
}

/// Margins: the mode is constant between crossings, and changes at each.
#[test]
fn modes_change_at_the_crossings_and_nowhere_else() {
    let mut random = Random(34);
    for _ in 0..tries(20_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let margins = Point::new(gamma, k_prime, k, mu).unwrap().margins();
        for (crossings, along_k) in [(&margins.along_k, true), (&margins.along_mu, false)] {
            let mode = |value: f64| {
                let (k, mu) = if along_k { (value, mu) } else { (k, value) };
                Point::new(gamma, k_prime, k, mu).unwrap().mode()
            };
            for pair in crossings.windows(2) {
                assert_eq!(pair[0].to, pair[1].from);
                assert!(pair[0].at < pair[1].at);
            }
            for crossing in crossings.iter().filter(|crossing| crossing.at > 0.0) {
                assert_ne!(crossing.from, crossing.to);
                assert_eq!(
                    mode(crossing.at * (1.0 - 1e-9)),
                    crossing.from,
                    "{gamma} {k_prime} {k} {mu} {crossing:?}"
                );
                assert_eq!(
                    mode(crossing.at * (1.0 + 1e-9)),
                    crossing.to,
                    "{gamma} {k_prime} {k} {mu} {crossing:?}"
                );
            }
            let value = random.log(1e-3, 1e3);
            if crossings.iter().any(|crossing| close(crossing.at, value, value)) {
                continue;
            }
            let expected = crossings.iter().rev().find(|crossing| crossing.at < value);
            let expected = expected.map_or_else(|| mode(0.0), |crossing| crossing.to);
            assert_eq!(mode(value), expected, "{gamma} {k_prime} {k} {mu} at {value}: {crossings:?}");
        }
        let leaves = margins.leaves_rest().unwrap();
        assert_eq!(leaves.from, Mode::Rest);
        // Rest ends at μ or k_A, whichever is less.
        let k_a = Chart::new(gamma, k_prime).unwrap().k_a();
        assert!(close(leaves.at, mu.min(k_a), mu.min(k_a)));
    }
}

#[test]
fn safety_factors_are_one_where_rest_ends() {
    let mut random = Random(35);
    for _ in 0..tries(100_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let least = point.safety_against_sliding().min(point.safety_against_overturning());
        if (least - 1.0).abs() > 1e-12 {
            assert_eq!(point.mode() == Mode::Rest, least > 1.0, "{point:?}");
        }
    }
    let unloaded = Point::new(1.0, -1.0, 0.0, 0.0).unwrap();
    assert_eq!(unloaded.safety_against_sliding(), f64::INFINITY);
    assert_eq!(unloaded.safety_against_overturning(), f64::INFINITY);
}

/// A point's bounds enclose it in an interval of its own mode, on boundaries and at thresholds of k' too.
#[test]
fn a_point_lies_between_its_bounds() {
    let mut random = Random(37);
    for i in 0..tries(60_000) {
        let [gamma, k_prime, k, mu] = match i % 3 {
            0 => random.point(),
            1 => random.pick(&Boundary::ALL).point(&mut random),
            _ => {
                // μ* is level here, and the force at which it is crossed is lost to rounding.
                let gamma = random.uniform(0.8, 5.0);
                let k_prime = random.nudge((1.0 + gamma * gamma) / (3.0 * gamma * gamma));
                let mu = random.nudge(1.0 / (gamma * (1.0 + k_prime)));
                [gamma, k_prime, random.uniform(0.0, 3.0), mu]
            }
        };
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let margins = point.margins();
        for (value, Bounds { below, above }) in [(k, margins.k_bounds()), (mu, margins.mu_bounds())] {
            assert!(below.is_none_or(|crossing| crossing.at <= value * (1.0 + 1e-9)), "{point:?} {below:?}");
            assert!(above.is_none_or(|crossing| crossing.at >= value * (1.0 - 1e-9)), "{point:?} {above:?}");
            assert!(below.is_none_or(|crossing| crossing.to == point.mode()), "{point:?} {below:?}");
            assert!(above.is_none_or(|crossing| crossing.from == point.mode()), "{point:?} {above:?}");
        }
    }
}

/// A crossing is located even if μ* is level to the last digits and its force cannot be computed in floating point.
#[test]
fn a_crossing_of_a_level_curve_is_found() {
    let given = [4.655584828409483, 0.34871240981731433, 0.15925988661319604];
    let [gamma, k_prime, mu] = given;
    let margins = Point::new(gamma, k_prime, 1.0, mu).unwrap().margins();
    // k = (dμ − b)/(a − cμ) in rational arithmetic.
    let last = margins.along_k.last().unwrap();
    assert_eq!((last.from, last.to), (Mode::RockO, Mode::SlideRockOLeft), "{margins:?}");
    assert!((last.at - 0.702372142703078).abs() <= 1e-12, "{margins:?}");

    let mut random = Random(38);
    let mut beyond_a: u32 = 0;
    for i in 0..tries(20_000) {
        let gamma = random.uniform(0.8, 5.0);
        let level = (1.0 + gamma * gamma) / (3.0 * gamma * gamma);
        let shares = [0.0, 1e-15, 1e-14, 1e-12, 1e-9, 1e-6];
        let k_prime = level * (1.0 + random.pick(&shares) * random.uniform(-1.0, 1.0));
        let k_a = Chart::new(gamma, k_prime).unwrap().k_a();
        let mu = [random.nudge(k_a), k_a * (1.0 + random.pick(&shares) * random.uniform(-1.0, 1.0))]
            [usize::from(i % 2 == 0)];
        let point = Point::new(gamma, k_prime, random.uniform(0.0, 3.0), mu).unwrap();
        let margins = point.margins();
        assert_located(&margins.along_k, |k| Point::new(gamma, k_prime, k, mu).unwrap().mode());
        let k = point.k();
        assert_located(&margins.along_mu, |mu| Point::new(gamma, k_prime, k, mu).unwrap().mode());
        beyond_a += u32::from(margins.along_k.iter().any(|crossing| crossing.at > 1.01 * k_a));
    }
    assert!(beyond_a > tries(20_000) / 10, "{beyond_a} crossings away from A");
}

/// The mode is that of the list between its crossings and next to each, as near as crossings are told apart.
fn assert_located(crossings: &[Crossing], mode: impl Fn(f64) -> Mode) {
    const ASIDE: f64 = 1e-11;
    for (i, crossing) in crossings.iter().enumerate() {
        let before = i.checked_sub(1).map_or(0.0, |before| crossings[before].at);
        assert!(before <= crossing.at, "{crossings:?}");
        assert!(i == 0 || crossings[i - 1].to == crossing.from, "{crossings:?}");
        if crossing.at - before <= 4.0 * ASIDE * crossing.at {
            continue;
        }
        let from = if i == 0 { 0.0 } else { before * (1.0 + ASIDE) };
        let to = crossing.at * (1.0 - ASIDE);
        for value in [from, from + 0.01 * (to - from), (from + to) / 2.0, to] {
            assert_eq!(mode(value), crossing.from, "at {value}: {crossings:?}");
        }
    }
    if let Some(last) = crossings.last() {
        for value in [last.at * (1.0 + ASIDE), 1.5 * last.at, 1e3 * last.at] {
            assert_eq!(mode(value), last.to, "at {value}: {crossings:?}");
        }
    }
}

#[test]
fn no_force_through_the_base_overcomes_unbounded_friction() {
    let margins = Point::new(1.0, -1.0, 0.1, 1e50).unwrap().margins();
    assert_eq!(margins.leaves_rest(), None);
}

/// At k' = 0 the trace is chapter III's, at k' = −1 still chapter IV's, with its order of modes.
#[test]
fn chapters_begin_where_they_begin() {
    let tried = |k_prime: f64| {
        let trace = Point::new(1.0, k_prime, 2.0, 0.5).unwrap().explain();
        let first = trace.steps[0].relations[0].equation;
        (first, trace.steps.iter().map(|step| step.mode).collect::<Vec<_>>())
    };
    let third = ("3.4", vec![Mode::Rest, Mode::SlideLeft]);
    assert_eq!(tried(0.0), third);
    assert_eq!(tried(-0.0), third);
    let fourth = ("4.7", vec![Mode::Rest, Mode::SlideRockOPrimeLeft]);
    assert_eq!((tried(-1.0), tried(-0.9)), (fourth.clone(), fourth));
    assert_eq!(
        tried((-1.0_f64).next_down()).1,
        [Mode::Rest, Mode::SlideLeft, Mode::RockOPrime, Mode::SlideRockOPrimeLeft]
    );
    // Of sliding at k' = −1, both inequalities of chapter IV.
    let slides = Point::new(1.0, -1.0, 2.0, 1.5).unwrap().explain();
    let equations: Vec<_> = slides.deciding().iter().map(|relation| relation.equation).collect();
    assert_eq!(equations, ["4.23", "4.19", "4.18"]);
    // At k' = 0 those of chapter III alone.
    let slides = Point::new(1.0, 0.0, 2.0, 0.5).unwrap().explain();
    let equations: Vec<_> = slides.deciding().iter().map(|relation| relation.equation).collect();
    assert_eq!(equations, ["3.6", "after 3.8"]);
}

/// One point of every mode in every chapter: what a reader of the trace sees, equation by equation.
#[test]
fn the_trace_in_words() {
    let deciding = |gamma, k_prime, k, mu| {
        let trace = Point::new(gamma, k_prime, k, mu).unwrap().explain();
        let relations: Vec<String> = trace.deciding().iter().map(ToString::to_string).collect();
        format!("{}: {}", trace.steps.last().unwrap().mode, relations.join("; "))
    };
    // k_A = 1/1.4 = 0.714286; 1/γ − k k' = 1 − 0.4 k; a = 3.8, b = 3, c = 4.2, d = 5.
    assert_eq!(
        deciding(1.0, 0.4, 0.5, 0.6),
        "RE: (3.4) μ ≥ k: 0.6 ≥ 0.5, holds by 0.1; (3.5) k ≤ 1/(γ|1+k'|): 0.5 ≤ 0.714286, holds by 0.214286"
    );
    assert_eq!(
        deciding(1.0, 0.4, 1.0, 0.5),
        "SL: (3.6) μ < k: 0.5 < 1, holds by 0.5; (after 3.8) μ ≤ 1/γ − k k': 0.5 ≤ 0.6, holds by 0.1"
    );
    assert_eq!(
        deciding(1.0, 0.4, 1.0, 0.8),
        "RO: (3.17) k > 1/(γ|1+k'|): 1 > 0.714286, holds by 0.285714; \
         (3.24) μ ≥ |a k + b|/(c k + d): 0.8 ≥ 0.73913, holds by 0.0608696"
    );
    assert_eq!(
        deciding(1.0, 0.4, 1.0, 0.7),
        "SRO-: (3.35) μ > 1/γ − k k': 0.7 > 0.6, holds by 0.1; \
         (3.40) μ < (a k + b)/(c k + d): 0.7 < 0.73913, holds by 0.0391304"
    );
    // a = −8.6, b = 9, c = 16.2, d = 37; −1/3 + 0.8·3 = 2.06667; 16.8/85.6 = 0.196262.
    assert_eq!(
        deciding(3.0, 0.8, 3.0, 0.1),
        "SRO+: (3.44) μ ≤ −1/γ + k k': 0.1 ≤ 2.06667, holds by 1.96667; \
         (3.45) μ < −(a k + b)/(c k + d): 0.1 < 0.196262, holds by 0.0962617"
    );
    // q = 0.6: k_A = 2.5; lines ±1 + 0.6 k; a = 6.8, b = 3, c = 1.2, d = 5.
    assert_eq!(
        deciding(1.0, -0.6, 2.0, 2.5),
        "RE: (4.7) μ ≥ k: 2.5 ≥ 2, holds by 0.5; (4.10) k ≤ 1/(γ|1+k'|): 2 ≤ 2.5, holds by 0.5"
    );
    assert_eq!(
        deciding(1.0, -0.6, 2.0, 1.0),
        "SL: (4.23) μ < k: 1 < 2, holds by 1; (4.19) μ ≤ 1/γ − k k': 1 ≤ 2.2, holds by 1.2; \
         (4.18) μ ≥ −1/γ − k k': 1 ≥ 0.2, holds by 0.8"
    );
    assert_eq!(deciding(1.0, -0.6, 2.0, 0.1), "SRO'-: (4.92) μ < −1/γ − k k': 0.1 < 0.2, holds by 0.1");
    assert_eq!(
        deciding(1.0, -0.6, 3.0, 4.0),
        "RO: (4.37) k > 1/(γ|1+k'|): 3 > 2.5, holds by 0.5; \
         (4.40) μ ≥ |a k + b|/(c k + d): 4 ≥ 2.72093, holds by 1.27907"
    );
    // γ = 10, q = 0.05: at k = 10, 0.1 + 0.5 = 0.6; a = 119, b = 30, c = 28.5, d = 401; 1220/686 = 1.77843.
    assert_eq!(
        deciding(10.0, -0.05, 10.0, 1.0),
        "SRO-: (4.67) μ > 1/γ − k k': 1 > 0.6, holds by 0.4; \
         (4.77) μ < (a k + b)/(c k + d): 1 < 1.77843, holds by 0.778426"
    );
    // k' = −2: k_A = 1; −1 + 2k; a = 11, b = 3, c = −3, d = 5.
    assert_eq!(
        deciding(1.0, -2.0, 0.9, 0.85),
        "SL: (4.23) μ < k: 0.85 < 0.9, holds by 0.05; (4.18) μ ≥ −1/γ − k k': 0.85 ≥ 0.8, holds by 0.05"
    );
    assert_eq!(
        deciding(1.0, -2.0, 2.0, 3.0),
        "RO': (4.57) k > 1/(γ|1+k'|): 2 > 1, holds by 1; \
         (4.96 about O') μ ≥ (a k − b)/(d − c k): 3 ≥ 1.72727, holds by 1.27273"
    );
    assert_eq!(
        deciding(1.0, -2.0, 2.0, 1.0),
        "SRO'-: (4.92) μ < −1/γ − k k': 1 < 3, holds by 2; \
         (4.96) μ < (a k − b)/(d − c k): 1 < 1.72727, holds by 0.727273"
    );
}

/// The trace ends with the mode, its relations hold, every earlier step fails, and bounds are the curves' values.
#[test]
fn the_trace_explains_the_mode() {
    let mut random = Random(36);
    for i in 0..tries(60_000) {
        let [gamma, k_prime, k, mu] = match i % 4 {
            0 | 1 => random.point(),
            2 => random.pick(&Boundary::ALL).point(&mut random),
            // Slide-rock to the right under forces far above the body.
            _ => [
                random.uniform(1.0, 20.0),
                random.log(1.0, 1e20),
                random.log(1e-20, 1.0),
                random.pick(&[0.0, 1e-9]),
            ],
        };
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let trace = point.explain();
        let last = trace.steps.last().unwrap();
        assert_eq!((last.mode, last.holds), (point.mode(), true));
        for step in &trace.steps {
            assert_eq!(
                step.holds,
                step.relations.iter().all(|relation| relation.holds),
                "{point:?} {step:?}"
            );
            for relation in &step.relations {
                let margin = relation.margin();
                let size = relation.left.abs() + relation.right.abs();
                if margin.is_finite() && margin.abs() > 1e-9 * (size + 1.0 / gamma) {
                    assert_eq!(relation.holds, margin > 0.0, "{point:?} {relation}");
                }
            }
        }
        assert!(trace.steps.iter().rev().skip(1).all(|step| !step.holds));
    }
}

#[test]
fn bad_charts_are_refused() {
    assert_eq!(
        Diagram::new(0.0, 0.5).unwrap_err().to_string(),
        "slenderness γ is 0; expected a number above zero, from 1e-50 to 1e50"
    );
    assert_eq!(
        Diagram::new(1.0, f64::INFINITY).unwrap_err().to_string(),
        "elevation k' is inf; expected a number from -1e50 to 1e50"
    );
    assert!(Diagram::new(1.0, 0.5).unwrap().mode_at(-1.0, 0.5).is_err());
}

/// Erratum 7: γ = 1, k' = 1 is case 1b although (4+γ²)/(3γ²) = 5/3 > 1, and μ* falls there.
#[test]
fn case_1b_exists_without_the_caption_s_condition() {
    let chart = Chart::new(1.0, 1.0).unwrap();
    assert_eq!(chart.case(), ChartCase::OneB);
    assert!(chart.mu_star().slope(chart.k_a()) < 0.0);
}

/// (4.22): on μ = −k k' the sliding body's reaction acts below its centre; above it, towards O.
#[test]
fn the_reaction_is_below_the_centre_on_its_line() {
    let chart = Chart::new(1.0, -0.6).unwrap();
    let slide = |mu| Point::new(1.0, -0.6, 3.0, mu).unwrap();
    let on_line = chart.centre_line().at(3.0);
    assert_eq!(slide(on_line).mode(), Mode::SlideLeft);
    assert!(slide(on_line).motion().xi.abs() < 1e-15);
    assert!(slide(on_line + 0.1).motion().xi < 0.0 && slide(on_line - 0.1).motion().xi > 0.0);
}

/// The line of (3.44) is CD mirrored in the k axis, and μ* tends to its limit.
#[test]
fn lines_drawn_only_are_where_they_should_be() {
    let chart = Chart::new(3.0, 0.8).unwrap();
    assert_eq!(chart.turning_line().at(2.0), -chart.upper_line().at(2.0));
    assert!((chart.mu_star_rising().at(1e9) - chart.mu_star_limit()).abs() < 1e-6);
    let below = Chart::new(1.0, -0.6).unwrap();
    assert!((below.mu_star_star().pole().unwrap() - 25.0 / 6.0).abs() < 1e-12); // d/c = 5/1.2
}

#[test]
fn the_k_primes_of_the_cases_tile_the_axis_as_the_chart_decides() {
    for gamma in [0.05, 0.3, 0.7, 1.0, 1.4, 2.0, 4.5, 10.0, 20.0] {
        let ranges = ChartCase::ALL.map(|case| case.k_primes(gamma).unwrap());
        assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start && pair[0].start < pair[0].end));
        for (case, Range { start: least, end: greatest }) in ChartCase::ALL.into_iter().zip(ranges) {
            let (least, greatest) = (least.max(-3.0), greatest.min(least.max(0.0) + 500.0));
            for share in [1e-6, 0.25, 0.5, 0.999_999] {
                let k_prime = least + share * (greatest - least);
                assert_eq!(Chart::new(gamma, k_prime).unwrap().case(), case, "γ = {gamma}, k' = {k_prime}");
            }
        }
    }
    assert!(ChartCase::OneA.k_primes(0.0).is_err());
}

/// The report's words for the cases and letters for the points, each once; what a chart does not have is at infinity.
#[test]
fn cases_and_points_have_names() {
    let names = ChartCase::ALL.map(ChartCase::name);
    assert_eq!(names, ["k' < −1", "Δ ≤ 0", "Δ > 0", "1a", "1b", "2–3"]);
    // Each says its own condition on k' last.
    let conditions = ChartCase::ALL.map(|case| case.words().split(": ").nth(1).unwrap());
    assert_eq!(
        conditions,
        [
            "k' < −1",
            "|k'| ≥ (1+γ²)/(4+γ²)",
            "|k'| < (1+γ²)/(4+γ²)",
            "k' ≤ (1+γ²)/(3γ²)",
            "(1+γ²)/(3γ²) < k' ≤ (4+γ²)/(3γ²)",
            "k' > (4+γ²)/(3γ²)"
        ]
    );
    use PointName::{A, BPrime, C, CPrime, D, E, F};
    assert_eq!([A, BPrime, C, CPrime, D, E, F].map(PointName::letter), ["A", "B'", "C", "C'", "D", "E", "F"]);

    // Δ is the slope of μ* at A less that of AB.
    for chart in charts().into_iter().filter(|chart| chart.k_prime() > -1.0) {
        let slopes = chart.mu_star().slope(chart.k_a()) - chart.upper_line().slope(0.0);
        assert!(close(chart.delta(), slopes, 1.0 + chart.k_prime().abs()), "{chart:?}");
    }

    let inf = f64::INFINITY;
    let chart = |gamma, k_prime| Chart::new(gamma, k_prime).unwrap();
    assert_eq!((chart(2.0, 0.3).gamma(), chart(2.0, 0.3).k_prime()), (2.0, 0.3));
    assert_eq!((chart(1.0, 0.4).k_e(), chart(1.0, -0.6).k_e()), (inf, inf));
    assert_eq!((chart(1.0, 0.0).k_b_prime(), chart(1.0, 0.4).k_b_prime()), (inf, inf));
    for k_prime in [-1.5, -1.0, 0.0, 0.4] {
        assert_eq!(chart(1.0, k_prime).k_c_prime(), inf);
    }
    assert_eq!((chart(1.0, -1.0).k_a(), chart(1.0, 0.0).k_d()), (inf, inf));
    // 6.8/1.2, from the published coefficients.
    assert!((chart(1.0, -0.6).mu_star_limit() - 6.8 / 1.2).abs() < 1e-14);
    assert_eq!(chart(1.0, -1.0).mu_star_limit(), inf);
    // A point farther than 1e100 counts as none.
    assert!(chart(1.0, 1e-99).point(D).is_some() && chart(1.0, 1e-101).point(D).is_none());
    assert_eq!(chart(1.0, 0.4).upper_line().pole(), None);
}
