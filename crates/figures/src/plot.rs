//! Places of the k–μ plane on the page, and the parts of regions and curves that are seen.
//!
//! Regions and curves are clipped by their own formulas: a curve is monotone between its poles, so it leaves the
//! window where it takes the smallest or the largest μ, and nothing is sampled. Hyperbolas become cubic Béziers
//! through their end tangents, split until they are right to a hundredth of a pixel.

use standfast::region::{Curve, Strip};

use crate::axes::{Axes, Axis};
use crate::scene::{Path, Rect};
use crate::texture::Segment;

/// The rectangle of the plane that a plot shows: `k_min` ≤ k ≤ `k_max`, `mu_min` ≤ μ ≤ `mu_max`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Smallest k; not negative.
    pub k_min: f64,
    /// Largest k.
    pub k_max: f64,
    /// Smallest μ; not negative.
    pub mu_min: f64,
    /// Largest μ.
    pub mu_max: f64,
}

impl View {
    /// From the origin to (`k`, `mu`).
    pub(crate) fn from_origin(k: f64, mu: f64) -> View {
        View { k_min: 0.0, k_max: k, mu_min: 0.0, mu_max: mu }
    }

    pub(crate) fn is_from_origin(&self) -> bool {
        self.k_min == 0.0 && self.mu_min == 0.0
    }

    /// True if a point of the plane is in it.
    pub(crate) fn shows(&self, k: f64, mu: f64) -> bool {
        (self.k_min..=self.k_max).contains(&k) && (self.mu_min..=self.mu_max).contains(&mu)
    }

    /// The values to the right, and upwards.
    pub(crate) fn axes(&self) -> (Axis, Axis) {
        (Axis::linear(self.k_min, self.k_max), Axis::linear(self.mu_min, self.mu_max))
    }

    pub(crate) fn width(&self) -> f64 {
        self.k_max - self.k_min
    }

    pub(crate) fn height(&self) -> f64 {
        self.mu_max - self.mu_min
    }
}

/// A part of a curve that lies in the window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arc {
    pub curve: Curve,
    pub from: f64,
    pub to: f64,
}

impl Arc {
    /// The values of the curve over [`k0`, `k1`] as (least, greatest), if the arc has points there.
    pub(crate) fn range(&self, k0: f64, k1: f64) -> Option<(f64, f64)> {
        let (from, to) = (self.from.max(k0), self.to.min(k1));
        if from > to {
            return None;
        }
        let (start, end) = (self.curve.at(from), self.curve.at(to));
        Some((start.min(end), start.max(end)))
    }
}

/// A part of a region in the window, both edges in the window too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    pub from: f64,
    pub to: f64,
    pub lower: Curve,
    pub upper: Curve,
}

/// μ = `level`.
pub(crate) fn level(level: f64) -> Curve {
    Curve::Line { slope: 0.0, intercept: level }
}

/// The intervals of [`from`, `to`] between values of k where a curve may enter or leave the window.
fn intervals(curves: &[Curve], from: f64, to: f64, window: &View) -> Vec<(f64, f64)> {
    let (from, to) = (from.max(window.k_min), to.min(window.k_max));
    if from >= to {
        return Vec::new();
    }
    let mut cuts = vec![from, to];
    for curve in curves {
        let ends = [curve.k_at(window.mu_min), curve.k_at(window.mu_max), curve.pole()];
        cuts.extend(ends.into_iter().flatten().filter(|&k| from < k && k < to));
    }
    cuts.sort_by(f64::total_cmp);
    cuts.windows(2).map(|pair| (pair[0], pair[1])).filter(|(a, b)| a < b).collect()
}

/// The parts of a curve over [`from`, `to`] that lie in the window.
pub(crate) fn clip(curve: Curve, from: f64, to: f64, window: &View) -> Vec<Arc> {
    intervals(&[curve], from, to, window)
        .into_iter()
        .filter(|&(a, b)| (window.mu_min..=window.mu_max).contains(&curve.at((a + b) / 2.0)))
        .map(|(from, to)| Arc { curve, from, to })
        .collect()
}

/// An interval over which curves lie in the window, its ends pulled in by too little to be seen where rounding left them
/// on the wrong side of a pole or a cut.
fn settled(from: f64, to: f64, curves: [Curve; 2], window: &View) -> (f64, f64) {
    const PULLS: [f64; 6] = [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2];
    let slack = 1e-9 * window.height();
    let range = window.mu_min - slack..=window.mu_max + slack;
    let within = |k: f64| curves.iter().all(|curve| range.contains(&curve.at(k)));
    let middle = (from + to) / 2.0;
    let pulled = |end: f64| {
        let ends = PULLS.into_iter().map(|share| end + share * (middle - end));
        ends.into_iter().find(|&k| within(k)).unwrap_or(middle)
    };
    (pulled(from), pulled(to))
}

/// The part of a region that lies in the window.
pub(crate) fn clip_strips(strips: &[Strip], window: &View) -> Vec<Piece> {
    let (bottom, top) = (level(window.mu_min), level(window.mu_max));
    let mut pieces = Vec::new();
    for strip in strips {
        let upper = strip.upper.unwrap_or(top);
        for (from, to) in intervals(&[strip.lower, upper], strip.from, strip.to, window) {
            let middle = (from + to) / 2.0;
            let (low, high) = (strip.lower.at(middle), upper.at(middle));
            if low < high && low < window.mu_max && high > window.mu_min {
                let lower = if low < window.mu_min { bottom } else { strip.lower };
                let upper = if high > window.mu_max { top } else { upper };
                let (from, to) = settled(from, to, [lower, upper], window);
                if from < to {
                    pieces.push(Piece { from, to, lower, upper });
                }
            }
        }
    }
    pieces
}

/// Appends a curve from `from` to `to` (either way) to a path that already stands at its start.
fn follow(path: &mut Path, axes: &Axes, curve: &Curve, from: f64, to: f64) {
    if let Curve::Line { .. } = curve {
        let (x, y) = axes.at(to, curve.at(to));
        path.line_to(x, y);
    } else {
        let y = |k: f64| axes.y(curve.at(k));
        hermite(path, &|k| (axes.x(k), y(k), axes.tilt(curve.slope(k))), from, to, 12);
    }
}

/// Appends the graph of a function, given as k ↦ (x, y, dy/dx) on the page, as cubics with the right end tangents.
pub(crate) fn hermite(
    path: &mut Path,
    graph: &dyn Fn(f64) -> (f64, f64, f64),
    from: f64,
    to: f64,
    depth: u32,
) {
    const TOLERANCE: f64 = 0.01;
    let ((x0, y0, t0), (x1, y1, t1)) = (graph(from), graph(to));
    let third = (x1 - x0) / 3.0;
    let cubic = |s: f64| {
        let r = 1.0 - s;
        r * r * r * y0
            + 3.0 * r * r * s * (y0 + third * t0)
            + 3.0 * r * s * s * (y1 - third * t1)
            + s * s * s * y1
    };
    let off = |s: f64| (cubic(s) - graph(from + s * (to - from)).1).abs();
    if depth > 0 && [0.25, 0.5, 0.75].into_iter().any(|s| off(s) > TOLERANCE) {
        let middle = (from + to) / 2.0;
        hermite(path, graph, from, middle, depth - 1);
        hermite(path, graph, middle, to, depth - 1);
    } else {
        // Too steep to be resolved, next to a pole, a tangent must not leave the box of its ends.
        let held = |y: f64| if depth == 0 { y.clamp(y0.min(y1), y0.max(y1)) } else { y };
        path.cubic_to(x0 + third, held(y0 + third * t0), x1 - third, held(y1 - third * t1), x1, y1);
    }
}

/// Arcs as a path.
pub(crate) fn arcs_path(axes: &Axes, arcs: &[Arc]) -> Path {
    let mut path = Path::default();
    for arc in arcs {
        let (x, y) = axes.at(arc.from, arc.curve.at(arc.from));
        path.move_to(x, y);
        follow(&mut path, axes, &arc.curve, arc.from, arc.to);
    }
    path
}

/// The outline of a region: out along the lower edges, back along the upper ones.
pub(crate) fn outline(axes: &Axes, pieces: &[Piece]) -> Path {
    let mut path = Path::default();
    for row in pieces.chunk_by(|left, right| left.to == right.from) {
        let (first, last) = (row[0], row[row.len() - 1]);
        let (x, y) = axes.at(first.from, first.lower.at(first.from));
        path.move_to(x, y);
        let line_to = |path: &mut Path, k: f64, mu: f64| {
            let (x, y) = axes.at(k, mu);
            path.line_to(x, y);
        };
        for (i, piece) in row.iter().enumerate() {
            if i > 0 {
                line_to(&mut path, piece.from, piece.lower.at(piece.from));
            }
            follow(&mut path, axes, &piece.lower, piece.from, piece.to);
        }
        line_to(&mut path, last.to, last.upper.at(last.to));
        for (i, piece) in row.iter().rev().enumerate() {
            if i > 0 {
                line_to(&mut path, piece.to, piece.upper.at(piece.to));
            }
            follow(&mut path, axes, &piece.upper, piece.to, piece.from);
        }
        path.close();
    }
    path
}

/// The way of lines on the page, from left to right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fall {
    Rising,
    Falling,
    Level,
}

impl Fall {
    /// dy/dx on the page, y down.
    pub(crate) fn slope(self) -> f64 {
        match self {
            Fall::Rising => -1.0,
            Fall::Falling => 1.0,
            Fall::Level => 0.0,
        }
    }
}

/// Hatching: lines that rise or fall at 45° on the page, `spacing` apart, cut where they leave the pieces.
pub(crate) fn hatch(axes: &Axes, pieces: &[Piece], spacing: f64, fall: Fall) -> Path {
    let mut path = Path::default();
    for (from, to) in ruled(axes, pieces, spacing, fall) {
        path.move_to(from.0, from.1);
        path.line_to(to.0, to.1);
    }
    path
}

/// Lines at 45° on the page or level, `spacing` apart, cut where they leave the pieces.
pub(crate) fn ruled(axes: &Axes, pieces: &[Piece], spacing: f64, fall: Fall) -> Vec<Segment> {
    let mut segments = Vec::new();
    let (Rect { x0, y0, x1, y1 }, window) = (axes.area, axes.view());
    let slope = fall.slope();
    // On the page y = start + slope (x − x0); all starts whose line meets the plot.
    let (first, last) = (y0 - slope.max(0.0) * (x1 - x0), y1 - slope.min(0.0) * (x1 - x0));
    for step in 0..=((last - first) / spacing) as usize {
        let start = first + spacing * step as f64;
        let mu = |k: f64| axes.up_at(start + slope * (axes.x(k) - x0));
        let slope = (mu(window.k_max) - mu(window.k_min)) / window.width();
        let line = (mu(window.k_min) - slope * window.k_min, slope);
        for piece in pieces {
            let mut cuts = vec![piece.from, piece.to];
            let meets = [piece.lower, piece.upper].into_iter().flat_map(|curve| crossings(&curve, line));
            cuts.extend(meets.filter(|&k| piece.from < k && k < piece.to));
            cuts.sort_by(f64::total_cmp);
            for pair in cuts.windows(2) {
                let middle = (pair[0] + pair[1]) / 2.0;
                if (piece.lower.at(middle)..=piece.upper.at(middle)).contains(&mu(middle)) {
                    segments.push((axes.at(pair[0], mu(pair[0])), axes.at(pair[1], mu(pair[1]))));
                }
            }
        }
    }
    segments
}

/// The values of k where a curve meets the line μ = `at_zero` + `slope` k.
fn crossings(curve: &Curve, (at_zero, slope): (f64, f64)) -> Vec<f64> {
    // c·slope k² + (d·slope + c·at_zero − a) k + d·at_zero − b = 0
    let (a, b, c, d) = match *curve {
        Curve::Line { slope, intercept } => (slope, intercept, 0.0, 1.0),
        Curve::Hyperbola { a, b, c, d } => (a, b, c, d),
    };
    let (two, one, zero) = (c * slope, d * slope + c * at_zero - a, d * at_zero - b);
    let root = (one * one - 4.0 * two * zero).sqrt();
    let half = -0.5 * (one + root.copysign(one));
    [half / two, zero / half].into_iter().filter(|k| k.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view() -> View {
        View::from_origin(4.0, 2.0)
    }

    #[test]
    fn a_curve_with_a_pole_is_cut_at_the_windows_edge() {
        let curve = Curve::Hyperbola { a: 1.0, b: 0.0, c: -1.0, d: 3.0 }; // k/(3 − k)
        let arcs = clip(curve, 0.0, f64::INFINITY, &view());
        assert_eq!(arcs.len(), 1);
        assert!((arcs[0].to - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_region_is_cut_at_the_windows_edge() {
        let strip = Strip { from: 1.0, to: f64::INFINITY, lower: Curve::DIAGONAL, upper: None };
        let pieces = clip_strips(&[strip], &view());
        assert_eq!(pieces.len(), 1);
        assert_eq!((pieces[0].from, pieces[0].to, pieces[0].upper), (1.0, 2.0, level(2.0)));
    }

    #[test]
    fn hatch_lines_end_on_the_curves() {
        let curve = Curve::Hyperbola { a: 2.0, b: 1.0, c: 1.0, d: 3.0 };
        let line = (0.2, 0.3);
        for k in crossings(&curve, line) {
            assert!((curve.at(k) - (line.0 + line.1 * k)).abs() < 1e-12);
        }
        assert_eq!(crossings(&Curve::DIAGONAL, (1.0, 0.5)), [2.0]);
    }
}
