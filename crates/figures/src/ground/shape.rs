//! What a plane on ground that gives way shows in a window: curves as lines between points that lie on them to the last digit.

use standfast::Verdict;
use standfast::region::{Curve, Strip};

use crate::outlines::{Mark, OutlinedLine, Polyline, Tick};
use crate::plot::View;

/// Regions, lines and named points.
pub(super) struct Shape {
    /// Where each verdict holds, between straight lines.
    pub areas: Vec<(Verdict, Vec<Strip>)>,
    /// The boundaries, and dashed lines that bound nothing.
    pub lines: Vec<OutlinedLine>,
    pub points: Vec<Mark>,
    pub k_marks: Vec<Tick>,
    pub mu_marks: Vec<Tick>,
}

/// How far a line between two points may be from the curve, in pixels of a figure.
const TOLERANCE: f64 = 0.05;

/// A curve given by a parameter, through all of `stops` (rising) and as many more as its bends take.
pub(crate) fn traced<T: Copy>(
    stops: &[f64],
    at: impl Fn(f64) -> T,
    place: impl Fn(&T) -> (f64, f64),
    view: &View,
) -> Vec<T> {
    let mut points = Vec::new();
    let Some(&first) = stops.first() else { return points };
    points.push(at(first));
    let page = |point: &T| {
        let (k, mu) = place(point);
        (k / view.width() * crate::chart::PLOT.0, mu / view.height() * crate::chart::PLOT.1)
    };
    for pair in stops.windows(2) {
        let (one, other) = (points[points.len() - 1], at(pair[1]));
        bend(&at, &page, (pair[0], one), (pair[1], other), 14, &mut points);
        points.push(other);
    }
    points
}

/// Adds the points that a curve takes between two of its points.
fn bend<T: Copy>(
    at: &impl Fn(f64) -> T,
    page: &impl Fn(&T) -> (f64, f64),
    (from, one): (f64, T),
    (to, other): (f64, T),
    depth: u32,
    points: &mut Vec<T>,
) {
    let ((x0, y0), (x1, y1)) = (page(&one), page(&other));
    let far = |x: f64, y: f64| !(-9.0..=2.0 * crate::chart::PLOT.0).contains(&x.max(y));
    if depth == 0 || (far(x0, y0) && far(x1, y1)) {
        return;
    }
    let middle = from + (to - from) / 2.0;
    let between = at(middle);
    let (x, y) = page(&between);
    let (dx, dy) = (x1 - x0, y1 - y0);
    let off = ((x - x0) * dy - (y - y0) * dx).abs() / dx.hypot(dy).max(1e-9);
    // A middle that is much nearer to one end hides a bend on the other side.
    let uneven = (x - x0).hypot(y - y0) > 4.0 * (x1 - x).hypot(y1 - y).max(1.0);
    if off > TOLERANCE || uneven {
        bend(at, page, (from, one), (middle, between), depth - 1, points);
        points.push(between);
        bend(at, page, (middle, between), (to, other), depth - 1, points);
    }
}

/// The line through two points of different k.
pub(crate) fn through((k0, mu0): (f64, f64), (k1, mu1): (f64, f64)) -> Curve {
    let slope = (mu1 - mu0) / (k1 - k0);
    // From the nearer to the axis, where less cancels.
    let intercept = if k0.abs() < k1.abs() { mu0 - slope * k0 } else { mu1 - slope * k1 };
    Curve::Line { slope, intercept }
}

/// The parts of a polyline within a window; points of the polyline lie where it crosses the window's edges.
pub(super) fn shown(points: &[(f64, f64)], view: &View) -> Vec<Polyline> {
    // Rounding at the crossings.
    let slack = |length: f64| 1e-9 * length;
    let (k, mu) = (slack(view.width()), slack(view.height()));
    let within = |&(a, b): &(f64, f64)| {
        (view.k_min - k..=view.k_max + k).contains(&a) && (view.mu_min - mu..=view.mu_max + mu).contains(&b)
    };
    let middle = |one: (f64, f64), other: (f64, f64)| ((one.0 + other.0) / 2.0, (one.1 + other.1) / 2.0);
    let mut parts: Vec<Polyline> = Vec::new();
    let mut runs = false;
    for pair in points.windows(2) {
        let is_in = within(&pair[0]) && within(&pair[1]) && within(&middle(pair[0], pair[1]));
        if is_in {
            match parts.last_mut() {
                Some(part) if runs => part.push(pair[1]),
                _ => parts.push(pair.to_vec()),
            }
        }
        runs = is_in;
    }
    parts
}

/// The inside of a polygon, and the slabs between its corners, as strips.
pub(super) fn strips_of(polygon: &[(f64, f64)], view: &View) -> Vec<Strip> {
    let mut cuts: Vec<f64> = polygon.iter().map(|point| point.0).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|later, earlier| *later - *earlier <= 1e-9 * view.width());
    let mut strips = Vec::new();
    for slab in cuts.windows(2) {
        let middle = (slab[0] + slab[1]) / 2.0;
        let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        let spanning = edges.filter(|(one, other)| (one.0 < middle) != (other.0 < middle));
        let mut lines: Vec<Curve> = spanning.map(|(one, other)| through(*one, *other)).collect();
        standfast::order::by_number(&mut lines, |one| one.at(middle));
        for pair in lines.chunks_exact(2) {
            strips.push(Strip { from: slab[0], to: slab[1], lower: pair[0], upper: Some(pair[1]) });
        }
    }
    strips
}

/// The same strips, those that continue one another in a row.
pub(super) fn chained(strips: Vec<Strip>, view: &View) -> Vec<Strip> {
    let mut chains: Vec<Vec<Strip>> = Vec::new();
    let near = 1e-9 * view.height();
    let meets = |one: Option<Curve>, other: Option<Curve>, k: f64| match (one, other) {
        (Some(one), Some(other)) => (one.at(k) - other.at(k)).abs() <= near,
        (None, None) => true,
        _ => false,
    };
    for strip in strips {
        let follows = |chain: &Vec<Strip>| {
            chain.last().is_some_and(|last| {
                let lower = meets(Some(last.lower), Some(strip.lower), strip.from);
                last.to == strip.from && lower && meets(last.upper, strip.upper, strip.from)
            })
        };
        match chains.iter().position(follows) {
            Some(place) => chains[place].push(strip),
            None => chains.push(vec![strip]),
        }
    }
    chains.concat()
}

/// What none of `taken` covers, between the values of k at which any of them begins or ends.
pub(super) fn rest_of(taken: &[&[Strip]]) -> Vec<Strip> {
    let all: Vec<&Strip> = taken.iter().flat_map(|strips| strips.iter()).collect();
    let mut cuts: Vec<f64> = all.iter().flat_map(|strip| [strip.from, strip.to]).chain([0.0]).collect();
    cuts.retain(|k| k.is_finite());
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    cuts.push(f64::INFINITY);
    let mut left = Vec::new();
    for slab in cuts.windows(2) {
        let (from, to) = (slab[0], slab[1]);
        let middle = if to.is_finite() { (from + to) / 2.0 } else { 2.0 * from + 1.0 };
        let mut here: Vec<&&Strip> =
            all.iter().filter(|strip| strip.from < middle && middle < strip.to).collect();
        standfast::order::by_number(&mut here, |one| one.lower.at(middle));
        let mut lower = Some(Curve::AXIS);
        for strip in here {
            if let Some(lower) = lower.filter(|lower| strip.lower.at(middle) - lower.at(middle) > 1e-9) {
                left.push(Strip { from, to, lower, upper: Some(strip.lower) });
            }
            lower = strip.upper;
        }
        if let Some(lower) = lower {
            left.push(Strip { from, to, lower, upper: None });
        }
    }
    left
}
