//! Content of a chart. A [`Sheet`] says which regions are shaded, which lines are drawn and how, and what is named; the
//! geometry comes from the library's [`Chart`].

use standfast::Mode;
use standfast::initiation::{Chart, ChartCase, PointName};
use standfast::region::Curve;

use crate::plot::level;

/// The content of one chart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sheet {
    pub shaded: &'static [Part],
    pub traces: &'static [Trace],
    /// Points marked with a dot and their letter.
    pub points: &'static [PointName],
    /// Letters at the far ends of lines.
    pub ends: &'static [(&'static str, Line)],
    /// Points marked on the k axis.
    pub k_marks: &'static [PointName],
    /// Values marked on the μ axis.
    pub mu_marks: &'static [Mark],
    /// Lines labelled with their formula.
    pub formulas: &'static [Line],
    /// Areas that carry a remark of their own.
    pub notes: &'static [Note],
    /// Names of regions: the symbol of their mode, or the words of a picture with one region.
    pub naming: Naming,
    /// True if the lens between A and B′ is shown magnified.
    pub lens: bool,
}

impl Sheet {
    /// A sheet with nothing on it.
    pub(crate) const EMPTY: Sheet = Sheet {
        shaded: &[],
        traces: &[],
        points: &[],
        ends: &[],
        k_marks: &[],
        mu_marks: &[],
        formulas: &[],
        notes: &[],
        naming: Naming::Symbols,
        lens: false,
    };
}

/// Names of regions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Naming {
    Symbols,
    Words(&'static str),
}

/// A shaded part of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Part {
    /// The region of a mode.
    Whole(Mode),
    /// Its part left of E.
    LeftOfE(Mode),
    /// Its part right of E.
    RightOfE(Mode),
    /// Part that the conditions of a mode also cover but the report gives to another; hatched.
    Unresolved(Mode),
}

/// A remark in a band between two lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Note {
    pub markup: &'static str,
    pub lower: Line,
    pub upper: Line,
    pub from: Abscissa,
}

/// A line of the report's charts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Line {
    /// OA: μ = k.
    Diagonal,
    /// The vertical at A, upwards from A.
    VerticalA,
    /// The vertical at E, upwards from the axis.
    VerticalE,
    /// CD of chapter III, AB of chapter IV.
    Upper,
    /// DC of chapter IV.
    Lower,
    /// μ = k|k′|, where the sliding body's reaction is under the centre.
    Middle,
    /// CD mirrored in the k axis: the dotted line of Fig. 3.8.
    Mirror,
    MuStar,
    MuStarRising,
    MuStarStar,
    /// The limit of μ* for large k.
    Asymptote,
}

/// An abscissa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Abscissa {
    Zero,
    A,
    BPrime,
    D,
    E,
    F,
    /// The pole d/c of μ**.
    Pole,
    Far,
}

/// Style of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Style {
    /// A boundary.
    Solid,
    /// A line that bounds nothing here.
    Thin,
    Dashed,
    Dotted,
}

/// A drawn stretch of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trace {
    pub line: Line,
    pub from: Abscissa,
    pub to: Abscissa,
    pub style: Style,
}

/// Short for the tables.
pub(crate) const fn trace(line: Line, from: Abscissa, to: Abscissa, style: Style) -> Trace {
    Trace { line, from, to, style }
}

/// A value on the μ axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Mark {
    Of(PointName),
    /// The limit of μ*.
    Asymptote,
    /// μ* at k = 0.
    Start,
    /// Point at which AB of chapter IV meets the axis.
    Foot,
}

impl Line {
    /// The line as a curve over k; `None` for the verticals.
    pub(crate) fn curve(self, chart: &Chart) -> Option<Curve> {
        Some(match self {
            Line::VerticalA | Line::VerticalE => return None,
            Line::Diagonal => Curve::DIAGONAL,
            Line::Upper => chart.upper_line(),
            Line::Lower => chart.lower_line(),
            Line::Middle => chart.centre_line(),
            Line::Mirror => chart.turning_line(),
            Line::MuStar => chart.mu_star(),
            Line::MuStarRising => chart.mu_star_rising(),
            Line::MuStarStar => chart.mu_star_star(),
            Line::Asymptote => level(chart.mu_star_limit()),
        })
    }

    /// Abscissa and lowest μ of a vertical.
    pub(crate) fn vertical(self, chart: &Chart) -> Option<(f64, f64)> {
        match self {
            Line::VerticalA => Some((chart.k_a(), chart.k_a())),
            Line::VerticalE => Some((chart.k_e(), 0.0)),
            _ => None,
        }
    }

    /// The line's equation in markup.
    pub(crate) fn formula(self, chart: &Chart) -> &'static str {
        let above = chart.k_prime() >= 0.0;
        let falls_to_zero = chart.case() == ChartCase::TwoThree;
        match self {
            Line::Diagonal => "$μ = k$",
            Line::VerticalA | Line::VerticalE => "",
            Line::Upper if above => r"$μ = \frac{1}{γ} − kk′$",
            Line::Upper => r"$μ = \frac{1}{γ} + k|k′|$",
            Line::Lower => r"$μ = −\frac{1}{γ} + k|k′|$",
            Line::Middle => "$μ = k|k′|$",
            Line::Mirror => r"$μ = −\frac{1}{γ} + kk′$",
            Line::MuStar if falls_to_zero => r"$μ = μ*(k) = \frac{−|a|k+b}{ck+d}$",
            Line::MuStar => r"$μ = μ*(k) = \frac{ak+b}{ck+d}$",
            Line::MuStarRising => r"$μ = μ*(k) = \frac{|a|k−b}{ck+d}$",
            Line::MuStarStar => r"$μ = μ**(k) = \frac{ak−b}{d−ck}$",
            Line::Asymptote => asymptote_markup(chart),
        }
    }

    /// The letters of its ends in markup.
    pub(crate) fn name(self, chart: &Chart) -> &'static str {
        match self {
            Line::Diagonal => "$OA$",
            Line::Upper if chart.k_prime() >= 0.0 => "$CD$",
            Line::Upper => "$AB$",
            Line::Lower => "$DC$",
            _ => "dotted",
        }
    }

    /// A shorter name for where the equation does not fit.
    pub(crate) fn short(self) -> Option<&'static str> {
        match self {
            Line::MuStar | Line::MuStarRising => Some("$μ*(k)$"),
            Line::MuStarStar => Some("$μ**(k)$"),
            _ => None,
        }
    }
}

impl Abscissa {
    /// Its k; infinite if the chart does not have it.
    pub(crate) fn k(self, chart: &Chart) -> f64 {
        match self {
            Abscissa::Zero => 0.0,
            Abscissa::A => chart.k_a(),
            Abscissa::BPrime => chart.k_b_prime(),
            Abscissa::D => chart.k_d(),
            Abscissa::E => chart.k_e(),
            Abscissa::F => chart.point(PointName::F).map_or(f64::INFINITY, |point| point.k),
            Abscissa::Pole => chart.mu_star_star().pole().filter(|&k| k > 0.0).unwrap_or(f64::INFINITY),
            Abscissa::Far => f64::INFINITY,
        }
    }
}

impl Mark {
    /// The point whose μ it is, if it is one's.
    pub(crate) fn point(self) -> Option<PointName> {
        match self {
            Mark::Of(name) => Some(name),
            Mark::Asymptote | Mark::Start | Mark::Foot => None,
        }
    }

    /// Its μ, if the chart has it.
    pub(crate) fn mu(self, chart: &Chart) -> Option<f64> {
        match self {
            Mark::Of(name) => chart.point(name).map(|point| point.mu),
            Mark::Asymptote => Some(chart.mu_star_limit()).filter(|mu| mu.is_finite()),
            Mark::Start => Some(chart.mu_star().at(0.0)),
            Mark::Foot => Some(chart.upper_line().at(0.0)),
        }
    }

    /// Symbol and value in markup; the value may be empty.
    pub(crate) fn markup(self, chart: &Chart) -> (&'static str, &'static str) {
        match self {
            Mark::Of(PointName::A) => ("μ_A", k_markup(PointName::A, chart).1),
            Mark::Of(PointName::C) => ("μ_C", r"\frac{1}{γ}"),
            Mark::Of(PointName::BPrime) => ("μ_{B′}", r"\frac{4+γ^2}{3γ}"),
            Mark::Of(PointName::CPrime) => ("μ_{C′}", ""),
            Mark::Of(_) => ("0", ""),
            Mark::Asymptote => (asymptote_markup(chart).trim_matches('$'), ""),
            Mark::Start => (r"\frac{b}{d}", ""),
            Mark::Foot => (r"\frac{1}{γ}", ""),
        }
    }
}

/// Symbol and value of a point's abscissa in markup.
pub(crate) fn k_markup(name: PointName, chart: &Chart) -> (&'static str, &'static str) {
    let k_prime = chart.k_prime();
    match name {
        PointName::A if k_prime >= 0.0 => ("k_A", r"\frac{1}{γ(1+k′)}"),
        PointName::A if k_prime >= -1.0 => ("k_A", r"\frac{1}{γ(1−|k′|)}"),
        PointName::A => ("k_A", r"\frac{1}{γ(|k′|−1)}"),
        PointName::BPrime => ("k_{B′}", r"\frac{1+γ^2}{3γ|k′|}"),
        PointName::C => ("0", ""),
        PointName::CPrime => ("k_{C′}", ""),
        PointName::D if k_prime >= 0.0 => ("k_D", r"\frac{1}{γk′}"),
        PointName::D => ("k_D", r"\frac{1}{γ|k′|}"),
        PointName::E => ("k_E", r"\frac{b}{|a|}"),
        PointName::F => ("k_F", r"\frac{b}{a}"),
    }
}

/// A point's letter in markup.
pub(crate) fn letter_markup(name: PointName) -> String {
    format!("${}$", name.letter().replace('\'', "′"))
}

fn asymptote_markup(chart: &Chart) -> &'static str {
    if chart.case() == ChartCase::TwoThree
        || chart.case() == ChartCase::BelowBase && chart.coefficients()[0] < 0.0
    {
        r"$\frac{|a|}{c}$"
    } else if chart.case() == ChartCase::BelowBase {
        r"$\frac{a}{|c|}$"
    } else {
        r"$\frac{a}{c}$"
    }
}
