//! Chapters II and III: force above the centre of mass.

use standfast::Mode::{Rest, RockO, SlideLeft, SlideRockOLeft, SlideRockORight};
use standfast::initiation::PointName;

use super::{Content, Entry, Sample, entry};
use crate::map::{CASE_1, CASE_2, CASE_2_3};
use crate::sheet::Abscissa::{A, D, E, Far, Zero};
use crate::sheet::Line::{Asymptote, Diagonal, Mirror, MuStar, MuStarRising, Upper, VerticalA, VerticalE};
use crate::sheet::Style::{Dashed, Dotted, Solid, Thin};
use crate::sheet::{Mark, Naming, Part, Sheet, Trace, trace};

const RISING: Sample = Sample { slenderness: 1.0, elevation: 0.4 };
const FALLING: Sample = Sample { slenderness: 2.0, elevation: 0.55 };
const SLENDER: Sample = Sample { slenderness: 3.0, elevation: 0.8 };

/// OA, AB and CD, the frame of every chart of the chapter.
const OA: Trace = trace(Diagonal, Zero, A, Solid);
const AB: Trace = trace(VerticalA, A, A, Solid);
const CD: Trace = trace(Upper, Zero, D, Solid);

const REST: Sheet = Sheet {
    shaded: &[Part::Whole(Rest)],
    traces: &[OA, trace(Diagonal, A, Far, Dashed), AB],
    points: &[PointName::A],
    ends: &[("B", VerticalA)],
    k_marks: &[PointName::A],
    mu_marks: &[Mark::Of(PointName::A)],
    formulas: &[Diagonal],
    naming: Naming::Words("Rest"),
    ..Sheet::EMPTY
};

const SLIDE: Sheet = Sheet {
    shaded: &[Part::Whole(SlideLeft)],
    traces: &[OA, AB, CD],
    points: &[PointName::A, PointName::C, PointName::D],
    k_marks: &[PointName::A, PointName::D],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C)],
    formulas: &[Upper, Diagonal],
    naming: Naming::Words("Slide"),
    ..REST
};

const ROCK_1: Sheet = Sheet {
    shaded: &[Part::Whole(RockO)],
    traces: &[
        trace(Asymptote, Zero, Far, Dashed),
        OA,
        AB,
        CD,
        trace(MuStar, Zero, A, Dotted),
        trace(MuStar, A, Far, Solid),
    ],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C), Mark::Asymptote, Mark::Start],
    formulas: &[MuStar, Upper, Diagonal],
    naming: Naming::Words("Rock"),
    ..SLIDE
};

const ROCK_2: Sheet = Sheet {
    shaded: &[Part::LeftOfE(RockO)],
    traces: &[OA, AB, CD, trace(MuStar, A, E, Solid), trace(VerticalE, E, E, Thin)],
    points: &[PointName::A, PointName::C, PointName::D, PointName::E],
    k_marks: &[PointName::A, PointName::D, PointName::E],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C)],
    ..ROCK_1
};

const ROCK_3: Sheet = Sheet {
    shaded: &[Part::RightOfE(RockO)],
    traces: &[
        trace(Asymptote, Zero, Far, Dashed),
        OA,
        AB,
        CD,
        trace(VerticalE, E, E, Dotted),
        trace(MuStarRising, E, Far, Solid),
    ],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C), Mark::Asymptote],
    formulas: &[MuStarRising, Upper, Diagonal],
    ..ROCK_2
};

const SLIDE_ROCK_1: Sheet = Sheet {
    shaded: &[Part::Whole(SlideRockOLeft)],
    traces: &[trace(Asymptote, Zero, Far, Dashed), OA, AB, CD, trace(MuStar, A, Far, Solid)],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::C), Mark::Asymptote],
    naming: Naming::Words("Slide-rock"),
    ..ROCK_1
};

const SLIDE_ROCK_2: Sheet = Sheet {
    shaded: &[Part::Whole(SlideRockOLeft)],
    traces: &[OA, AB, CD, trace(MuStar, A, E, Solid)],
    naming: Naming::Words("Slide-rock"),
    ..ROCK_2
};

const SLIDE_ROCK_3: Sheet = Sheet {
    shaded: &[Part::Whole(SlideRockORight)],
    traces: &[
        trace(Asymptote, Zero, Far, Dashed),
        CD,
        trace(Mirror, D, Far, Dotted),
        trace(MuStarRising, E, Far, Solid),
    ],
    points: &[PointName::C, PointName::D, PointName::E],
    ends: &[],
    k_marks: &[PointName::D, PointName::E],
    mu_marks: &[Mark::Of(PointName::C), Mark::Asymptote],
    formulas: &[MuStarRising, Mirror, Upper],
    naming: Naming::Words("Slide-rock"),
    ..ROCK_3
};

/// Figs. 2.1–3.11 in order.
pub(super) const FIGURES: [Entry; 15] = [
    Entry { number: "2.1", caption: "Model", content: Content::Sketch { above: true } },
    entry("3.1", "Rest region", REST, RISING, (1.9, 1.35)),
    entry("3.2", "Slide region", SLIDE, RISING, (3.2, 1.35)),
    entry(
        "3.3a",
        "Rock region, case 1, $0 ≤ k′ ≤ (1+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        ROCK_1,
        RISING,
        (3.2, 1.35),
    ),
    entry(
        "3.3b",
        "Rock region, case 1, $(1+γ^2)/(3γ^2) ≤ k′ ≤ (4+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        ROCK_1,
        FALLING,
        (1.25, 0.64),
    ),
    entry(
        "3.4",
        "Rock region, case 2, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≥ 0$, $a < 0$",
        ROCK_2,
        SLENDER,
        (1.3, 0.45),
    ),
    entry(
        "3.5",
        "Rock region, case 3, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≤ 0$, $a < 0$",
        ROCK_3,
        SLENDER,
        (2.25, 0.57),
    ),
    entry(
        "3.6a",
        r"Slide-rock region ($\ddot{x}_O < 0$), case 1, $0 ≤ k′ ≤ (1+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        SLIDE_ROCK_1,
        RISING,
        (3.2, 1.35),
    ),
    entry(
        "3.6b",
        r"Slide-rock region ($\ddot{x}_O < 0$), case 1, $(1+γ^2)/(3γ^2) ≤ k′ ≤ (4+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        SLIDE_ROCK_1,
        FALLING,
        (1.25, 0.64),
    ),
    entry(
        "3.7",
        r"Slide-rock region ($\ddot{x}_O < 0$), case 2, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≥ 0$, $a < 0$",
        SLIDE_ROCK_2,
        SLENDER,
        (1.3, 0.45),
    ),
    entry(
        "3.8",
        r"Slide-rock region ($\ddot{x}_O > 0$), case 3, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≤ 0$, $a < 0$",
        SLIDE_ROCK_3,
        SLENDER,
        (2.25, 0.57),
    ),
    entry(
        "3.9a",
        "All modes, case 1, $0 ≤ k′ ≤ (1+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        CASE_1,
        RISING,
        (3.2, 1.35),
    ),
    entry(
        "3.9b",
        "All modes, case 1, $(1+γ^2)/(3γ^2) ≤ k′ ≤ (4+γ^2)/(3γ^2)$, $f_x ≥ 0$, $a ≥ 0$",
        CASE_1,
        FALLING,
        (1.25, 0.64),
    ),
    entry(
        "3.10",
        "All modes, case 2, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≥ 0$, $a < 0$",
        CASE_2,
        SLENDER,
        (1.3, 0.45),
    ),
    entry(
        "3.11",
        "All modes, case 3, $(4+γ^2)/(3γ^2) < k′ ≤ 1$, $f_x ≤ 0$, $a < 0$",
        CASE_2_3,
        SLENDER,
        (2.25, 0.57),
    ),
];
