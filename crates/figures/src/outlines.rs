//! Content of a diagram as coordinates of the k–μ plane, for those who draw it with a tool of their own.
//!
//! The content, the window and the colours are those of [`diagram_with`](crate::diagram_with); curves become polylines that
//! stay within a two-thousandth of the window's height of the exact ones.

use standfast::diagram::Window;
use standfast::initiation::PointName;
use standfast::region::{Curve, Strip};
use standfast::{Diagram, Mode, Modes, Verdict};

use crate::ground::{GroundPlane, outlined};
use crate::map;
use crate::palette::{symbol, tint};
use crate::plot::{Piece, View, clip, clip_strips};
use crate::sheet::{Line, Style, k_markup, letter_markup};
use crate::{DiagramContent, KMuPlane};

/// (k, μ) one after another.
pub type Polyline = Vec<(f64, f64)>;

/// A diagram as coordinates. Strings called markup are LaTeX-like, with `\up{}` for upright letters, between dollars.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlines {
    /// The part of the plane that everything is clipped to.
    pub window: Window,
    /// The regions of the modes.
    pub areas: Vec<Area>,
    /// The parts of the indeterminate set, which lie over the areas.
    pub unresolved: Vec<UnresolvedArea>,
    /// The drawn lines, in the order in which they are drawn.
    pub lines: Vec<OutlinedLine>,
    /// Of a base that gives way, the boundaries on rigid ground: to be drawn behind.
    pub rigid: Vec<Polyline>,
    /// The named points in the window.
    pub points: Vec<Mark>,
    /// Values marked on the k axis.
    pub k_marks: Vec<Tick>,
    /// Values marked on the μ axis.
    pub mu_marks: Vec<Tick>,
}

/// The region of a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Verdict there: a mode, or BF on ground that fails.
    pub verdict: Verdict,
    /// Its symbol as markup.
    pub symbol: &'static str,
    /// Its colour, as `#rrggbb`.
    pub tint: &'static str,
    /// Its outline; more than one if the window cuts it apart, none if it lies outside. The last point is not
    /// the first again.
    pub polygons: Vec<Polyline>,
}

/// A part of the indeterminate set.
#[derive(Debug, Clone, PartialEq)]
pub struct UnresolvedArea {
    /// The report's name for it.
    pub name: &'static str,
    /// The mode the report resolves it to.
    pub resolved_as: Mode,
    /// All modes consistent inside.
    pub modes: Modes,
    /// Its outline, as in [`Area`].
    pub polygons: Vec<Polyline>,
}

/// A drawn line.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlinedLine {
    /// `OA`, `vertical at A`, `CD`, `AB`, `DC`, `mu*`, `mu**` or `asymptote`.
    pub name: &'static str,
    /// Its equation as markup; empty for verticals.
    pub formula: &'static str,
    /// A shorter name as markup, for where the equation does not fit; empty if it has none.
    pub short: &'static str,
    /// True if it bounds nothing and is drawn dashed.
    pub dashed: bool,
    /// Its parts in the window.
    pub parts: Vec<Polyline>,
}

/// A named point.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Its letter, e.g. `B'`.
    pub letter: &'static str,
    /// The letter as markup.
    pub markup: String,
    /// k.
    pub k: f64,
    /// μ.
    pub mu: f64,
}

/// A value marked on an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// The value.
    pub at: f64,
    /// Its name and formula as markup.
    pub markup: String,
    /// The point of the plane whose coordinate it is, if it is one's.
    pub of: Option<(f64, f64)>,
}

/// A diagram as coordinates, clipped to the window of what it is to show. The points themselves are not among them.
///
/// ```
/// use standfast::{Diagram, Mode};
/// use standfast_figures::{DiagramContent, outlines};
///
/// let shown = outlines(&Diagram::new(3.0, 0.8)?.into(), &DiagramContent::default());
/// let slide = shown.areas.iter().find(|area| area.verdict.mode() == Some(Mode::SlideLeft)).unwrap();
/// assert_eq!(slide.polygons[0][0], (0.0, 0.0));
/// # Ok::<(), standfast::InputError>(())
/// ```
pub fn outlines(plane: &KMuPlane, content: &DiagramContent<'_>) -> Outlines {
    match plane {
        KMuPlane::Rigid(diagram) => rigid(diagram, content),
        KMuPlane::Crushing(map) => outlined(GroundPlane::Crushing(map), content),
        KMuPlane::Failing(plane) => outlined(GroundPlane::Failing(plane), content),
    }
}

/// The coordinates of a diagram on a rigid base.
pub(crate) fn rigid(diagram: &Diagram, content: &DiagramContent<'_>) -> Outlines {
    let window = content.window_of(diagram);
    let view = View::from_origin(window.k, window.mu);
    let chart = diagram.chart();
    let (sheet, _) = map::sheet(chart.case());
    let shows = |k: f64, mu: f64| (0.0..=window.k).contains(&k) && (0.0..=window.mu).contains(&mu);

    let areas = diagram.regions().iter().map(|region| Area {
        verdict: Verdict::Begins(region.mode),
        symbol: symbol(region.mode),
        tint: tint(region.mode),
        polygons: polygons(&region.strips, &view),
    });
    let unresolved = diagram.unresolved().into_iter().map(|part| UnresolvedArea {
        name: part.name,
        resolved_as: part.resolved_as,
        modes: part.modes,
        polygons: polygons(&part.strips, &view),
    });
    let lines = sheet.traces.iter().map(|trace| {
        let parts = match (trace.line.curve(chart), trace.line.vertical(chart)) {
            (Some(curve), _) => clip(curve, trace.from.k(chart), trace.to.k(chart), &view)
                .into_iter()
                .map(|arc| along(&arc.curve, arc.from, arc.to, &view))
                .collect(),
            (None, Some((k, from))) if shows(k, from) => vec![vec![(k, from), (k, window.mu)]],
            (None, _) => Vec::new(),
        };
        let dashed = trace.style == Style::Dashed;
        OutlinedLine {
            name: name(trace.line, chart.k_prime()),
            formula: trace.line.formula(chart),
            short: trace.line.short().unwrap_or_default(),
            dashed,
            parts,
        }
    });
    let points = chart.points().into_iter().filter(|point| shows(point.k, point.mu)).map(|point| Mark {
        letter: point.name.letter(),
        markup: letter_markup(point.name),
        k: point.k,
        mu: point.mu,
    });
    let at = |name: PointName| chart.point(name).map(|point| (point.k, point.mu));
    let markup = |(name, value): (&str, &str)| {
        if value.is_empty() { format!("${name}$") } else { format!("${name} = {value}$") }
    };
    let k_marks = sheet.k_marks.iter().filter_map(|&name| {
        let of = at(name).filter(|&(k, _)| k <= window.k)?;
        Some(Tick { at: of.0, markup: markup(k_markup(name, chart)), of: Some(of) })
    });
    let mu_marks = sheet.mu_marks.iter().filter_map(|mark| {
        let mu = mark.mu(chart).filter(|&mu| (0.0..window.mu).contains(&mu))?;
        Some(Tick { at: mu, markup: markup(mark.markup(chart)), of: mark.point().and_then(at) })
    });
    Outlines {
        window,
        areas: areas.collect(),
        unresolved: unresolved.collect(),
        lines: lines.collect(),
        rigid: Vec::new(),
        points: points.collect(),
        k_marks: k_marks.collect(),
        mu_marks: mu_marks.collect(),
    }
}

/// Name of a line in plain characters.
fn name(line: Line, elevation: f64) -> &'static str {
    match line {
        Line::Diagonal => "OA",
        Line::VerticalA => "vertical at A",
        Line::VerticalE => "vertical at E",
        Line::Upper if elevation >= 0.0 => "CD",
        Line::Upper => "AB",
        Line::Lower => "DC",
        Line::Middle => "mu = k|k'|",
        Line::Mirror => "mu = -1/gamma + k k'",
        Line::MuStar | Line::MuStarRising => "mu*",
        Line::MuStarStar => "mu**",
        Line::Asymptote => "asymptote",
    }
}

/// The outline of strips in a window: out along the lower edges, back along the upper ones.
pub(crate) fn polygons(strips: &[Strip], view: &View) -> Vec<Polyline> {
    let pieces = clip_strips(strips, view);
    let rows = pieces.chunk_by(|left, right| left.to == right.from);
    rows.map(|row| {
        let edge = |piece: &Piece, curve: &Curve| along(curve, piece.from, piece.to, view);
        let lower = row.iter().flat_map(|piece| edge(piece, &piece.lower));
        let upper = row.iter().rev().flat_map(|piece| edge(piece, &piece.upper).into_iter().rev());
        let mut outline: Polyline = lower.chain(upper).collect();
        outline.dedup();
        if outline.len() > 1 && outline.first() == outline.last() {
            outline.pop();
        }
        outline
    })
    .collect()
}

/// A curve from `from` to `to` as a polyline, its values held in the window.
fn along(curve: &Curve, from: f64, to: f64, view: &View) -> Polyline {
    let at = |k: f64| (k, curve.at(k).clamp(view.mu_min, view.mu_max));
    let mut points = vec![at(from)];
    if let Curve::Hyperbola { .. } = curve {
        bend(&at, from, to, view.height() / 2000.0, 12, &mut points);
    }
    points.push(at(to));
    points
}

/// Appends points between `from` and `to` until the polyline is within `tolerance`.
fn bend(
    at: &dyn Fn(f64) -> (f64, f64),
    from: f64,
    to: f64,
    tolerance: f64,
    depth: u32,
    points: &mut Polyline,
) {
    let middle = (from + to) / 2.0;
    let straight = (at(from).1 + at(to).1) / 2.0;
    if depth > 0 && (at(middle).1 - straight).abs() > tolerance {
        bend(at, from, middle, tolerance, depth - 1, points);
        points.push(at(middle));
        bend(at, middle, to, tolerance, depth - 1, points);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area by the shoelace formula; the fills of all regions together are the window.
    fn twice_area(polygon: &Polyline) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        polygon.iter().zip(next).map(|(&(k0, m0), &(k1, m1))| k0 * m1 - k1 * m0).sum::<f64>().abs()
    }

    #[test]
    fn the_areas_of_a_diagram_fill_its_window() {
        for gamma in [0.3, 1.0, 2.0, 4.0] {
            for k_prime in [-1.5, -1.0, -0.6, -0.55, -0.2, 0.0, 0.4, 0.55, 0.8, 1.0, 3.0] {
                let shown = rigid(&Diagram::new(gamma, k_prime).unwrap(), &DiagramContent::default());
                let filled: f64 =
                    shown.areas.iter().flat_map(|area| &area.polygons).map(twice_area).sum::<f64>() / 2.0;
                let window = shown.window.k * shown.window.mu;
                assert!(
                    (filled / window - 1.0).abs() < 2e-3,
                    "γ = {gamma}, k' = {k_prime}: {filled}, {window}"
                );
            }
        }
    }

    #[test]
    fn lines_and_points_lie_in_the_window() {
        for (gamma, k_prime) in [(1.0, 0.4), (3.0, 0.8), (4.0, -0.55), (1.0, -0.6), (1.0, -2.0)] {
            let content =
                DiagramContent { window: Some(Window { k: 1.5, mu: 1.0 }), ..DiagramContent::default() };
            let shown = rigid(&Diagram::new(gamma, k_prime).unwrap(), &content);
            let lines = shown.lines.iter().flat_map(|line| line.parts.iter().flatten().copied());
            for (k, mu) in lines.chain(shown.points.iter().map(|point| (point.k, point.mu))) {
                assert!((0.0..=1.5).contains(&k) && (0.0..=1.0).contains(&mu), "({k}, {mu})");
            }
        }
    }
}
