//! The map of all modes, for any body and any elevation of the force: Figs. 3.9–3.11, 4.7, and below the base.

use crate::plot::View;
use standfast::Diagram;
use standfast::Mode::{
    Rest, RockO, RockOPrime, SlideLeft, SlideRockOLeft, SlideRockOPrimeLeft, SlideRockORight,
};
use standfast::initiation::{ChartCase, PointName};
use standfast::region::Curve;

use crate::sheet::Abscissa::{A, BPrime, D, E, Far, Zero};
use crate::sheet::Line::{
    Asymptote, Diagonal, Lower, MuStar, MuStarRising, MuStarStar, Upper, VerticalA, VerticalE,
};
use crate::sheet::Style::{Dashed, Solid, Thin};
use crate::sheet::{Mark, Part, Sheet, trace};

/// Opens the title of a map of all modes.
pub(crate) const HEADING: &str = "Modes of a block,";

/// Case 1 (Figs. 3.9a, 3.9b).
pub(crate) const CASE_1: Sheet = Sheet {
    shaded: &[Part::Whole(Rest), Part::Whole(SlideLeft), Part::Whole(RockO), Part::Whole(SlideRockOLeft)],
    traces: &[
        trace(Upper, Zero, A, Dashed),
        trace(Asymptote, Zero, Far, Dashed),
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Upper, A, D, Solid),
        trace(MuStar, A, Far, Solid),
    ],
    points: &[PointName::A, PointName::C, PointName::D],
    ends: &[("B", VerticalA)],
    k_marks: &[PointName::A, PointName::D],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C), Mark::Asymptote],
    formulas: &[MuStar, Diagonal, Upper],
    ..Sheet::EMPTY
};

/// Cases 2 and 3 together (Fig. 3.11).
pub(crate) const CASE_2_3: Sheet = Sheet {
    shaded: &[
        Part::Whole(Rest),
        Part::Whole(SlideLeft),
        Part::Whole(RockO),
        Part::Whole(SlideRockOLeft),
        Part::Whole(SlideRockORight),
    ],
    traces: &[
        trace(Upper, Zero, A, Dashed),
        trace(Asymptote, Zero, Far, Dashed),
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Upper, A, D, Solid),
        trace(MuStar, A, E, Solid),
        trace(MuStarRising, E, Far, Solid),
    ],
    points: &[PointName::A, PointName::C, PointName::D, PointName::E],
    k_marks: &[PointName::A, PointName::D, PointName::E],
    formulas: &[MuStarRising, MuStar, Diagonal, Upper],
    ..CASE_1
};

/// Case 2, f_x ≥ 0: nothing is claimed right of E (Fig. 3.10).
pub(crate) const CASE_2: Sheet = Sheet {
    shaded: &[Part::Whole(Rest), Part::Whole(SlideLeft), Part::LeftOfE(RockO), Part::Whole(SlideRockOLeft)],
    traces: &[
        trace(Upper, Zero, A, Dashed),
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Upper, A, D, Solid),
        trace(MuStar, A, E, Solid),
        trace(VerticalE, E, E, Thin),
    ],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C)],
    formulas: &[MuStar, Diagonal, Upper],
    ..CASE_2_3
};

/// Δ ≤ 0 (Fig. 4.7b).
pub(crate) const DELTA_NOT_POSITIVE: Sheet = Sheet {
    shaded: &[
        Part::Whole(Rest),
        Part::Whole(SlideLeft),
        Part::Whole(RockO),
        Part::Whole(SlideRockOPrimeLeft),
    ],
    traces: &[
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Upper, A, Far, Solid),
        trace(Lower, D, Far, Solid),
    ],
    points: &[PointName::A, PointName::D],
    ends: &[("E", VerticalA), ("B", Upper), ("C", Lower)],
    k_marks: &[PointName::A, PointName::D],
    mu_marks: &[Mark::Of(PointName::A)],
    formulas: &[Upper, Lower, Diagonal],
    ..Sheet::EMPTY
};

/// Δ > 0 (Fig. 4.7a).
pub(crate) const DELTA_POSITIVE: Sheet = Sheet {
    shaded: &[
        Part::Whole(Rest),
        Part::Whole(SlideLeft),
        Part::Whole(RockO),
        Part::Whole(SlideRockOLeft),
        Part::Whole(SlideRockOPrimeLeft),
    ],
    traces: &[
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Upper, A, Far, Solid),
        trace(Lower, D, Far, Solid),
        trace(MuStar, A, BPrime, Solid),
    ],
    points: &[PointName::A, PointName::BPrime, PointName::D],
    k_marks: &[PointName::A, PointName::D, PointName::BPrime],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::BPrime)],
    formulas: &[Upper, Lower, MuStar, Diagonal],
    lens: true,
    ..DELTA_NOT_POSITIVE
};

/// k′ < −1.
const BELOW_BASE: Sheet = Sheet {
    shaded: &[
        Part::Whole(Rest),
        Part::Whole(SlideLeft),
        Part::Whole(RockOPrime),
        Part::Whole(SlideRockOPrimeLeft),
    ],
    traces: &[
        trace(Diagonal, Zero, A, Solid),
        trace(VerticalA, A, A, Solid),
        trace(Lower, D, A, Solid),
        trace(MuStarStar, A, Far, Solid),
    ],
    ends: &[],
    formulas: &[MuStarStar, Lower, Diagonal],
    ..DELTA_NOT_POSITIVE
};

/// The sheet of a diagram, and a sentence on its force and its condition in markup.
pub(crate) fn sheet(case: ChartCase) -> (&'static Sheet, &'static str) {
    match case {
        ChartCase::OneA => (&CASE_1, "Force above the centre of mass, case 1: $0 ≤ k′ ≤ (1+γ^2)/(3γ^2)$."),
        ChartCase::OneB => {
            (&CASE_1, "Force above the centre of mass, case 1: $(1+γ^2)/(3γ^2) < k′ ≤ (4+γ^2)/(3γ^2)$.")
        }
        ChartCase::TwoThree => {
            (&CASE_2_3, "Force above the centre of mass, cases 2 and 3: $k′ > (4+γ^2)/(3γ^2)$.")
        }
        ChartCase::DeltaPositive => {
            (&DELTA_POSITIVE, "Force below the centre of mass: $|k′| < (1+γ^2)/(4+γ^2)$.")
        }
        ChartCase::DeltaNotPositive => {
            (&DELTA_NOT_POSITIVE, "Force below the centre of mass: $|k′| ≥ (1+γ^2)/(4+γ^2)$.")
        }
        ChartCase::BelowBase => (&BELOW_BASE, "Effective force below the base: $k′ < −1$."),
    }
}

/// k_A, or k_D where A is at infinity or next to it.
pub(crate) fn unit(diagram: &Diagram) -> f64 {
    let chart = diagram.chart();
    Some(chart.k_a()).filter(|&k| k < 1e6 / chart.gamma()).unwrap_or(chart.k_d())
}

/// The window of a diagram: A, unless it is at infinity or next to it, the other named points up to some times its distance, and all
/// points to be marked, given as (k, μ).
pub(crate) fn window(diagram: &Diagram, points: &[(f64, f64)]) -> View {
    // With points to be read off, what is far from them would squeeze them into the corner.
    let far = if points.is_empty() { 7.0 } else { 4.0 };
    let chart = diagram.chart();
    let unit = 1.0 / chart.gamma();
    let (k_a, k_d) = (chart.k_a(), chart.k_d());
    let a = Some(k_a).filter(|&k| k < 1e6 * unit);
    let base = a.unwrap_or(k_d);
    // Fig. 3.9 reads best with A about a quarter along the axis.
    let mut k = if a.is_some() { 2.2 * base } else { 3.5 * base };
    let mut mu = 1.5 * base;
    let shown = diagram.chart().points().into_iter();
    for point in shown.filter(|point| point.name != PointName::F && point.name != PointName::CPrime) {
        if point.k <= far * base && point.mu <= far * base {
            k = k.max(1.28 * point.k);
            mu = mu.max(1.2 * point.mu);
        }
    }
    if let Some(limit) =
        Mark::Asymptote.mu(chart).filter(|limit| *limit < 3.0 * base && chart.k_prime() >= 0.0)
    {
        mu = mu.max(1.15 * limit);
    }
    // See rising lines that bound the regions rise across the picture, but not A squeezed into a corner.
    let rises = |curve: Curve| curve.at(k).min(3.0 * base);
    match chart.case() {
        ChartCase::DeltaPositive | ChartCase::DeltaNotPositive => {
            mu = mu.max(1.05 * rises(chart.upper_line()))
        }
        ChartCase::BelowBase => mu = mu.max(1.3 * rises(chart.mu_star_star())),
        _ => {}
    }
    let corner = (base, base);
    framed((k, mu), corner, points)
}

/// A window of at most this size that shows points to be read off: not much farther than three times them, and the corner where
/// regions meet.
pub(crate) fn framed((k, mu): (f64, f64), corner: (f64, f64), points: &[(f64, f64)]) -> View {
    const AROUND: f64 = 3.0;
    const CORNER: f64 = 1.35;
    let farthest = points.iter().fold((0.0, 0.0), |far: (f64, f64), at| (far.0.max(at.0), far.1.max(at.1)));
    let side = |most: f64, point: f64, corner: f64| {
        let framed = if points.is_empty() { most } else { most.min((AROUND * point).max(CORNER * corner)) };
        framed.max(1.12 * point)
    };
    View::from_origin(side(k, farthest.0, corner.0), side(mu, farthest.1, corner.1))
}
