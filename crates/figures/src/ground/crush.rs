//! The plane of a base that crushes.

use standfast::ground::strength::{CrushChart, CrushEdge, CrushMap, CrushPoint, CrushStrip, RockEdgePoint};
use standfast::initiation::PointName;
use standfast::region::{Curve, Strip};
use standfast::{Modes, Verdict};

use super::shape::{Shape, shown, through, traced};
use crate::outlines::{Mark, OutlinedLine, Polyline, Tick};
use crate::plot::{View, clip, level};
use crate::sheet::letter_markup;

pub(super) fn shape(map: &CrushMap, view: &View) -> Shape {
    let chart = map.chart();
    let curve = rock_curve(map, view);
    let areas = map.regions().iter().map(|region| {
        let strips = region.strips.iter().flat_map(|strip| straightened(strip, &curve, view));
        (Verdict::Begins(region.mode), strips.collect())
    });
    let at = |name: PointName| chart.point(name);
    let inside = |k: f64, mu: f64| view.shows(k, mu);
    let points = chart.points().into_iter().filter(|point| inside(point.k, point.mu)).map(|point| Mark {
        letter: point.name.letter(),
        markup: letter_markup(point.name),
        k: point.k,
        mu: point.mu,
    });
    let k_marks = [PointName::A, PointName::D, PointName::E].into_iter().filter_map(|name| {
        let point = at(name).filter(|point| point.k <= view.k_max)?;
        let markup = k_markup(name, chart.k_prime());
        Some(Tick { at: point.k, markup, of: Some((point.k, point.mu)) })
    });
    let mu_marks = [PointName::A, PointName::C].into_iter().filter_map(|name| {
        let point = at(name).filter(|point| point.mu < view.mu_max)?;
        let markup = match name {
            PointName::A => k_markup(name, chart.k_prime()).replacen("k_A", "μ_A", 1),
            _ => r"$μ_C = \frac{1−ω}{γ}$".to_owned(),
        };
        Some(Tick { at: point.mu, markup, of: Some((point.k, point.mu)) })
    });
    Shape {
        areas: areas.collect(),
        lines: lines(map, &curve, view),
        points: points.collect(),
        k_marks: k_marks.collect(),
        mu_marks: mu_marks.collect(),
    }
}

fn k_markup(name: PointName, k_prime: f64) -> String {
    match name {
        PointName::A if k_prime >= 0.0 => r"$k_A = \frac{1−ω}{γ(1+k′)}$",
        PointName::A if k_prime >= -1.0 => r"$k_A = \frac{1−ω}{γ(1−|k′|)}$",
        PointName::A => r"$k_A = \frac{1−ω}{γ(|k′|−1)}$",
        PointName::D if k_prime >= 0.0 => r"$k_D = \frac{1−ω}{γk′}$",
        PointName::D => r"$k_D = \frac{1−ω}{γ|k′|}$",
        _ => "$k_E$",
    }
    .to_owned()
}

/// The curve between rock and slide-rock as far as the window shows it, with all its corners: where strips end, and where it leaves
/// the window.
fn rock_curve(map: &CrushMap, view: &View) -> Vec<RockEdgePoint> {
    let chart = map.chart();
    let Some(last) = chart.rotation(view.k_max) else { return Vec::new() };
    let mut stops = vec![0.0, last];
    let ends = map.regions().iter().flat_map(|region| &region.strips).map(|strip| strip.from);
    stops.extend(ends.filter(|k| *k < view.k_max).filter_map(|k| chart.rotation(k)));
    stops.extend(chart.rock_crossings(level(view.mu_max)).into_iter().map(|point| point.alpha));
    stops.retain(|alpha| *alpha <= last);
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|later, earlier| *later - *earlier <= 1e-12 * last);
    traced(&stops, |alpha| chart.rock_at(alpha), |point| (point.k, point.mu), view)
}

/// A strip with lines in the place of curves.
fn straightened(strip: &CrushStrip, curve: &[RockEdgePoint], view: &View) -> Vec<Strip> {
    let is_rock = |edge: &CrushEdge| matches!(edge, CrushEdge::Rock(_));
    let line = |edge: &CrushEdge, from: (f64, f64), to: (f64, f64)| match edge {
        CrushEdge::Line(line) => *line,
        CrushEdge::Rock(_) => through(from, to),
    };
    if !is_rock(&strip.lower) && !strip.upper.as_ref().is_some_and(is_rock) {
        let (from, to) = ((0.0, 0.0), (1.0, 0.0));
        let upper = strip.upper.map(|edge| line(&edge, from, to));
        return vec![Strip { from: strip.from, to: strip.to, lower: line(&strip.lower, from, to), upper }];
    }
    let points = stretch(curve, strip.from, strip.to);
    let pairs = points.windows(2).filter(|pair| pair[1].0 - pair[0].0 > 1e-9 * view.width());
    pairs
        .map(|pair| Strip {
            from: pair[0].0,
            to: pair[1].0,
            lower: line(&strip.lower, pair[0], pair[1]),
            upper: strip.upper.map(|edge| line(&edge, pair[0], pair[1])),
        })
        .collect()
}

/// The points of the curve from one value of k to another, rounding at its corners apart.
fn stretch(curve: &[RockEdgePoint], from: f64, to: f64) -> Polyline {
    let range = from * (1.0 - 1e-9)..=to * (1.0 + 1e-9);
    curve.iter().filter(|point| range.contains(&point.k)).map(|point| (point.k, point.mu)).collect()
}

/// The boundaries: every one is the lower edge of the strip above it. And the line from C to A, dashed.
fn lines(map: &CrushMap, curve: &[RockEdgePoint], view: &View) -> Vec<OutlinedLine> {
    let chart = map.chart();
    let above = chart.k_prime() >= 0.0;
    let edges = [
        (CrushEdge::Rock(*chart), "mu*", "$μ = μ*(k)$", "$μ*(k)$"),
        (CrushEdge::Line(Curve::DIAGONAL), "OA", "$μ = k$", ""),
        if above {
            (CrushEdge::Line(chart.upper_line()), "CD", r"$μ = \frac{1−ω}{γ} − kk′$", "")
        } else {
            (CrushEdge::Line(chart.upper_line()), "AB", r"$μ = \frac{1−ω}{γ} + k|k′|$", "")
        },
        (CrushEdge::Line(chart.lower_line()), "DC", r"$μ = −\frac{1−ω}{γ} + k|k′|$", ""),
    ];
    let mut lines = Vec::new();
    for (edge, name, formula, short) in edges {
        let strips = map.regions().iter().flat_map(|region| &region.strips);
        let mut stretches: Vec<(f64, f64)> =
            strips.filter(|strip| strip.lower == edge).map(|strip| (strip.from, strip.to)).collect();
        standfast::order::by_number(&mut stretches, |one| one.0);
        let parts: Vec<Polyline> = joined(stretches)
            .into_iter()
            .flat_map(|(from, to)| match edge {
                CrushEdge::Line(line) => straight(line, from, to, view),
                CrushEdge::Rock(_) => shown(&stretch(curve, from, to), view),
            })
            .collect();
        if !parts.is_empty() {
            lines.push(OutlinedLine { name, formula, short, dashed: false, parts });
        }
    }
    let k_a = chart.k_a();
    if view.shows(k_a, k_a) {
        let parts = vec![vec![(k_a, k_a), (k_a, view.mu_max)]];
        lines.push(OutlinedLine { name: "vertical at A", formula: "", short: "", dashed: false, parts });
    }
    if above {
        let parts = straight(chart.upper_line(), 0.0, k_a, view);
        lines.push(OutlinedLine { name: "CA", formula: "", short: "", dashed: true, parts });
    }
    lines
}

/// Stretches that follow one another as one.
fn joined(stretches: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = Vec::new();
    for (from, to) in stretches {
        match all.last_mut() {
            Some(last) if last.1 >= from => last.1 = to,
            _ => all.push((from, to)),
        }
    }
    all
}

pub(super) fn straight(line: Curve, from: f64, to: f64, view: &View) -> Vec<Polyline> {
    let arcs = clip(line, from, to, view).into_iter();
    arcs.map(|arc| [arc.from, arc.to].map(|k| (k, line.at(k))).to_vec()).collect()
}

/// Where several modes are consistent, as the columns of a window show it, and the modes: decided point by point, so that it is
/// hatched where it is and nowhere else.
pub(super) fn undecided(chart: &CrushChart, view: &View) -> (Vec<Strip>, Modes) {
    const COLUMNS: u32 = 160;
    let mut found = (Vec::new(), Modes::NONE);
    for i in 0..COLUMNS {
        let edge = |i: u32| view.k_min + view.width() * f64::from(i) / f64::from(COLUMNS);
        let (from, to) = (edge(i), edge(i + 1));
        let k = (from + to) / 2.0;
        for (low, high) in several(chart, k, view) {
            let middle = (low + high) / 2.0;
            let point = CrushPoint::new(chart.gamma(), chart.k_prime(), k, middle, chart.omega());
            point.iter().flat_map(|point| point.enumerate().iter()).for_each(|mode| found.1.insert(mode));
            found.0.push(Strip { from, to, lower: level(low), upper: Some(level(high)) });
        }
    }
    found
}

/// The stretches of friction in which several modes are consistent under a force.
fn several(chart: &CrushChart, k: f64, view: &View) -> Vec<(f64, f64)> {
    const ROWS: u32 = 60;
    let is_several = |mu: f64| {
        let point = CrushPoint::new(chart.gamma(), chart.k_prime(), k, mu, chart.omega());
        point.is_ok_and(|point| !point.is_unique())
    };
    let row = |i: u32| view.mu_min + view.height() * (f64::from(i) + 0.5) / f64::from(ROWS);
    let between = |mut one: f64, mut other: f64| {
        let first = is_several(one);
        for _ in 0..12 {
            let middle = (one + other) / 2.0;
            if is_several(middle) == first { one = middle } else { other = middle }
        }
        (one + other) / 2.0
    };
    let mut stretches: Vec<(f64, f64)> = Vec::new();
    let mut before = false;
    for i in 0..ROWS {
        let now = is_several(row(i));
        match (before, now) {
            (false, true) => {
                let low = if i == 0 { view.mu_min } else { between(row(i - 1), row(i)) };
                stretches.push((low, view.mu_max));
            }
            (true, false) => {
                if let Some(last) = stretches.last_mut() {
                    last.1 = between(row(i - 1), row(i));
                }
            }
            _ => {}
        }
        before = now;
    }
    stretches
}
