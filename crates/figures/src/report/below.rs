//! Chapter IV: force below the centre of mass.

use standfast::Mode::{Rest, RockO, SlideLeft, SlideRockOLeft, SlideRockOPrimeLeft};
use standfast::initiation::PointName;

use super::{Content, Entry, Sample, entry};
use crate::map::{DELTA_NOT_POSITIVE, DELTA_POSITIVE};
use crate::sheet::Abscissa::{A, BPrime, D, F, Far, Pole, Zero};
use crate::sheet::Line::{Diagonal, Lower, Middle, MuStar, MuStarStar, Upper, VerticalA};
use crate::sheet::Style::{Dashed, Dotted, Solid, Thin};
use crate::sheet::{Mark, Naming, Note, Part, Sheet, Trace, trace};

/// Δ > 0: the lens between A and B′ exists.
const LENS: Sample = Sample { slenderness: 4.0, elevation: -0.55 };
const NO_LENS: Sample = Sample { slenderness: 1.0, elevation: -0.6 };

const OA: Trace = trace(Diagonal, Zero, A, Solid);
const AE: Trace = trace(VerticalA, A, A, Solid);
const AB: Trace = trace(Upper, A, Far, Solid);
const DC: Trace = trace(Lower, D, Far, Solid);
const MU_STAR: Trace = trace(MuStar, A, Far, Solid);

const REST: Sheet = Sheet {
    shaded: &[Part::Whole(Rest)],
    traces: &[OA, AE],
    points: &[PointName::A],
    ends: &[("E", VerticalA)],
    k_marks: &[PointName::A],
    mu_marks: &[Mark::Of(PointName::A)],
    formulas: &[Diagonal],
    naming: Naming::Words("Rest"),
    ..Sheet::EMPTY
};

const SLIDE: Sheet = Sheet {
    shaded: &[Part::Whole(SlideLeft)],
    traces: &[trace(Upper, Zero, A, Dashed), OA, AE, AB, DC, trace(Middle, Zero, Far, Dotted)],
    points: &[PointName::A, PointName::D],
    ends: &[("E", VerticalA), ("B", Upper), ("C", Lower)],
    k_marks: &[PointName::A, PointName::D],
    mu_marks: &[Mark::Of(PointName::A), Mark::Foot],
    formulas: &[Upper, Middle, Lower, Diagonal],
    notes: &[
        Note { markup: "$ξ < 0$", lower: Middle, upper: Upper, from: A },
        Note { markup: "$ξ > 0$", lower: Lower, upper: Middle, from: D },
    ],
    naming: Naming::Words("Slide"),
    ..Sheet::EMPTY
};

const ROCK_B: Sheet = Sheet {
    shaded: &[Part::Whole(RockO), Part::Unresolved(RockO)],
    traces: &[OA, AE, AB, DC, MU_STAR],
    points: &[PointName::A, PointName::CPrime, PointName::D],
    ends: &[("E", VerticalA), ("B", Upper), ("C", Lower), ("C″", MuStar)],
    k_marks: &[PointName::A, PointName::D],
    mu_marks: &[Mark::Of(PointName::A)],
    formulas: &[MuStar, Upper, Lower, Diagonal],
    notes: &[],
    naming: Naming::Words("Rock"),
    ..SLIDE
};

const ROCK_A: Sheet = Sheet {
    points: &[PointName::A, PointName::BPrime, PointName::CPrime, PointName::D],
    k_marks: &[PointName::A, PointName::D, PointName::BPrime],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::BPrime)],
    lens: true,
    ..ROCK_B
};

const SLIDE_ROCK_A: Sheet = Sheet {
    shaded: &[Part::Whole(SlideRockOLeft), Part::Unresolved(SlideRockOLeft)],
    // Solid lines would cover the lens that they bound.
    traces: &[
        OA,
        AE,
        trace(Upper, A, BPrime, Thin),
        trace(Upper, BPrime, Far, Solid),
        DC,
        trace(MuStar, A, BPrime, Thin),
        trace(MuStar, BPrime, Far, Solid),
    ],
    naming: Naming::Symbols,
    ..ROCK_A
};

const SLIDE_ROCK_B: Sheet =
    Sheet { shaded: &[Part::Unresolved(SlideRockOLeft)], naming: Naming::Symbols, ..ROCK_B };

const ABOUT_O_PRIME_B: Sheet = Sheet {
    shaded: &[Part::Whole(SlideRockOPrimeLeft)],
    traces: &[
        OA,
        trace(Upper, A, Far, Thin),
        trace(MuStar, A, Far, Thin),
        DC,
        trace(MuStarStar, F, Pole, Solid),
    ],
    points: &[PointName::A, PointName::D, PointName::F],
    ends: &[("B", Upper), ("C", Lower)],
    k_marks: &[PointName::A, PointName::D, PointName::F],
    formulas: &[Upper, MuStarStar, Lower, MuStar, Diagonal],
    naming: Naming::Words("Slide-rock"),
    ..ROCK_B
};

const ABOUT_O_PRIME_A: Sheet = Sheet {
    points: &[PointName::A, PointName::BPrime, PointName::D, PointName::F],
    ends: &[("B", Upper), ("μ*", MuStar), ("C", Lower)],
    mu_marks: &[Mark::Of(PointName::A), Mark::Of(PointName::BPrime)],
    lens: true,
    ..ABOUT_O_PRIME_B
};

/// The inset shows μ*, so that its formula beside the thin lens would only crowd it.
const ALL_MODES_A: Sheet = Sheet { formulas: DELTA_NOT_POSITIVE.formulas, ..DELTA_POSITIVE };

/// Figs. 4.1–4.7b in order.
pub(super) const FIGURES: [Entry; 11] = [
    Entry { number: "4.1", caption: "Model", content: Content::Sketch { above: false } },
    entry("4.2", "Rest region", REST, NO_LENS, (4.4, 4.2)),
    entry("4.3", "Slide region", SLIDE, NO_LENS, (6.0, 4.72)),
    entry(
        "4.4a",
        "Rock region (about $O$), $|k′| < (1+γ^2)/(4+γ^2)$, before resolution",
        ROCK_A,
        LENS,
        (7.9, 4.2),
    ),
    entry(
        "4.4b",
        "Rock region (about $O$), $|k′| > (1+γ^2)/(4+γ^2)$, before resolution",
        ROCK_B,
        NO_LENS,
        (14.0, 8.5),
    ),
    entry(
        "4.5a",
        r"Slide-rock region (about $O$, $\ddot{x}_O < 0$), $|k′| < (1+γ^2)/(4+γ^2)$, before resolution",
        SLIDE_ROCK_A,
        LENS,
        (7.9, 4.2),
    ),
    entry(
        "4.5b",
        r"Slide-rock region (about $O$, $\ddot{x}_O < 0$), $|k′| > (1+γ^2)/(4+γ^2)$, before resolution",
        SLIDE_ROCK_B,
        NO_LENS,
        (14.0, 8.5),
    ),
    entry(
        "4.6a",
        r"Slide-rock region (about $O′$, $\ddot{x}_{O′} < 0$), $|k′| < (1+γ^2)/(4+γ^2)$",
        ABOUT_O_PRIME_A,
        LENS,
        (3.6, 2.3),
    ),
    entry(
        "4.6b",
        r"Slide-rock region (about $O′$, $\ddot{x}_{O′} < 0$), $|k′| > (1+γ^2)/(4+γ^2)$",
        ABOUT_O_PRIME_B,
        NO_LENS,
        (6.0, 4.6),
    ),
    entry("4.7a", "All modes, $|k′| < (1+γ^2)/(4+γ^2)$", ALL_MODES_A, LENS, (4.7, 2.98)),
    entry("4.7b", "All modes, $|k′| ≥ (1+γ^2)/(4+γ^2)$", DELTA_NOT_POSITIVE, NO_LENS, (6.0, 4.72)),
];
