//! Another case behind the one that is drawn, in dashes: A, which is pinned, behind B.
//!
//! Each type here is what a figure needs of A. It is made once, and drawn with every B.

use standfast::region::{Curve, Strip};
use standfast::{Diagram, Verdict};

use crate::canvas::Canvas;
use crate::chart::stretch;
use crate::labels::Board;
use crate::palette::{BEHIND, INK, MARK, PAPER};
use crate::plane::Plan;
use crate::plot::{Arc, View};
use crate::scene::{Path, Pen, Rect};
use crate::sheet::Style;
use crate::{LoadPlane, MotionPicture, Outline, Section, map};

/// The line in which A is drawn.
pub(crate) const PINNED: Pen = Pen { colour: INK, width: 1.2, dashes: "7 4" };
/// The line of its histories, behind those of B.
pub(crate) const PINNED_HISTORY: Pen = Pen { colour: BEHIND, width: 1.4, dashes: "6 3.4" };

/// Name of the case in dashes, and what it is of.
fn words(title: &str) -> String {
    match title.trim() {
        "" => "Dashed: A".to_owned(),
        title => format!("Dashed: A, {title}"),
    }
}

/// The same of a plane, in which it has a point.
fn words_of_plane(title: &str) -> String {
    words(title) + "; its full load is the hollow diamond"
}

/// Parts of a stretch that others leave.
fn left_by(stretch: (f64, f64), others: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut left = vec![stretch];
    for (from, to) in others {
        let cut = |(one, two): (f64, f64)| [(one, two.min(from)), (one.max(to), two)];
        left = left.into_iter().flat_map(cut).filter(|(one, two)| one < two).collect();
    }
    left
}

/// A body that is drawn in dashes in the section of another.
#[derive(Debug, Clone, PartialEq)]
pub struct PinnedBody {
    title: String,
    /// Its parts, m to the right of its corner O and above the base.
    parts: Vec<Vec<(f64, f64)>>,
}

impl PinnedBody {
    /// The body of a section.
    pub fn of(section: &Section<'_>) -> PinnedBody {
        let moved =
            |part: &Outline| part.vertices.iter().map(|(x, y)| (x - section.base.0, *y)).collect::<Vec<_>>();
        PinnedBody { title: section.title.to_owned(), parts: section.parts.iter().map(moved).collect() }
    }

    /// Edges with the corner O in that of another section, without what lies on edges of that.
    pub(crate) fn beside(&self, other: &Section<'_>) -> Vec<[(f64, f64); 2]> {
        let own: Vec<[(f64, f64); 2]> = other.parts.iter().flat_map(|part| edges(&part.vertices)).collect();
        let moved = |part: &Vec<(f64, f64)>| -> Vec<(f64, f64)> {
            part.iter().map(|(x, y)| (x + other.base.0, *y)).collect()
        };
        let all = self.parts.iter().flat_map(|part| edges(&moved(part)));
        all.flat_map(|edge| without(edge, &own)).collect()
    }

    pub(crate) fn words(&self) -> String {
        words(&self.title)
    }
}

/// The edges of an outline.
fn edges(corners: &[(f64, f64)]) -> Vec<[(f64, f64); 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| [*from, *to]).collect()
}

/// Parts of an edge that lie on none of others.
fn without([from, to]: [(f64, f64); 2], others: &[[(f64, f64); 2]]) -> Vec<[(f64, f64); 2]> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    // Along the edge as a share of it, and across in its unit.
    let place = |(x, y): (f64, f64)| {
        let (x, y) = (x - from.0, y - from.1);
        ((x * dx + y * dy) / length.powi(2), (x * dy - y * dx) / length.powi(2))
    };
    let on = others.iter().filter_map(|[one, two]| {
        let (one, two) = (place(*one), place(*two));
        let is_on = one.1.abs().max(two.1.abs()) < 1e-9;
        is_on.then(|| (one.0.min(two.0) - 1e-9, one.0.max(two.0) + 1e-9))
    });
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    left_by((0.0, 1.0), on).into_iter().map(|(one, two)| [at(one), at(two)]).collect()
}

/// Arcs without what lies on lines that are drawn.
pub(crate) fn arcs_beside(board: &Board, arcs: Vec<Arc>) -> Vec<Arc> {
    let height = board.axes.up.to - board.axes.up.from;
    let is_on = |own: &Arc, arc: &Arc| {
        let (from, to) = (own.from.max(arc.from), own.to.min(arc.to));
        let apart = |k: f64| (own.curve.at(k) - arc.curve.at(k)).abs();
        from < to && [from, (from + to) / 2.0, to].into_iter().all(|k| apart(k) < 1e-9 * height)
    };
    let left = |arc: Arc| {
        let on = board.arcs.iter().filter(|own| is_on(own, &arc)).map(|own| (own.from, own.to));
        let parts = left_by((arc.from, arc.to), on).into_iter();
        parts.map(|(from, to)| Arc { from, to, ..arc }).collect::<Vec<_>>()
    };
    arcs.into_iter().flat_map(left).collect()
}

/// Upright lines, each a value and the two between which it runs, without what lies on lines that are drawn.
pub(crate) fn verticals_beside(board: &Board, lines: Vec<(f64, f64, f64)>) -> Vec<(f64, f64, f64)> {
    let axes = board.axes;
    let left = |(at, low, high): (f64, f64, f64)| {
        let on = board.verticals.iter().filter(|(x, ..)| (x - axes.x(at)).abs() < 1e-6);
        let on = on.map(|(_, top, bottom)| (axes.up_at(*bottom), axes.up_at(*top)));
        let parts =
            left_by((low, high), on).into_iter().filter(|(low, high)| axes.y(*low) - axes.y(*high) > 0.5);
        parts.map(|(low, high)| (at, low, high)).collect::<Vec<_>>()
    };
    lines.into_iter().flat_map(left).collect()
}

/// The boundaries of a plane of load and friction, to be drawn in dashes in the plane of another case.
#[derive(Debug, Clone)]
pub struct PinnedPlane {
    title: String,
    pub(crate) regions: Vec<(Verdict, Vec<Strip>)>,
    pub(crate) corners: Vec<f64>,
    pub(crate) friction: f64,
}

impl PinnedPlane {
    /// The boundaries of a plane.
    pub fn of(plane: &LoadPlane<'_>) -> PinnedPlane {
        let Plan { regions, corners, friction, .. } = Plan::of(plane, None);
        let regions = regions.into_iter().map(|region| (region.verdict, region.strips)).collect();
        PinnedPlane { title: plane.title.to_owned(), regions, corners, friction }
    }

    pub(crate) fn words(&self) -> String {
        words_of_plane(&self.title)
    }
}

/// A plane in dashes, and the share of the drawn case's load to which its own full load amounts.
#[derive(Debug, Clone, Copy)]
pub struct PinnedLoad<'a> {
    /// The plane.
    pub plane: &'a PinnedPlane,
    /// Its full load as a share of the other's; 1 where each is followed in shares of its own.
    pub share: f64,
}

/// Strips whose first coordinate is so many times as large.
pub(crate) fn widened(strips: &[Strip], times: f64) -> Vec<Strip> {
    let curve = |curve: Curve| match curve {
        Curve::Line { slope, intercept } => Curve::Line { slope: slope / times, intercept },
        Curve::Hyperbola { a, b, c, d } => Curve::Hyperbola { a: a / times, b, c: c / times, d },
    };
    let widened = |strip: &Strip| Strip {
        from: times * strip.from,
        to: times * strip.to,
        lower: curve(strip.lower),
        upper: strip.upper.map(curve),
    };
    if times == 1.0 { strips.to_vec() } else { strips.iter().map(widened).collect() }
}

/// A k–μ diagram with its design point, to be drawn in dashes in that of another case.
#[derive(Debug, Clone, PartialEq)]
pub struct PinnedDiagram {
    /// Title of its case.
    pub title: String,
    /// The diagram.
    pub diagram: Diagram,
    /// Its design point: F/(m g).
    pub k: f64,
    /// Its friction.
    pub mu: f64,
}

impl PinnedDiagram {
    /// The view with room for what it shows itself.
    pub fn with_room(&self, view: View) -> View {
        let own = View::of(&self.diagram, self.k, self.mu);
        View { k_max: view.k_max.max(own.k_max), mu_max: view.mu_max.max(own.mu_max), ..view }
    }

    pub(crate) fn words(&self) -> String {
        words_of_plane(&self.title)
    }

    /// Draws the boundaries between its regions and its design point, which labels keep off.
    pub(crate) fn draw(&self, canvas: &mut Canvas) {
        let axes = canvas.board.axes;
        let view = axes.view();
        let chart = self.diagram.chart();
        let (sheet, _) = map::sheet(chart.case());
        for trace in sheet.traces.iter().filter(|trace| trace.style == Style::Solid) {
            match trace.line.vertical(chart) {
                Some((k, from)) => {
                    let from = from.max(axes.up.from);
                    let shown = axes.shows(k, from).then_some((k, from, axes.up.to));
                    let lines = verticals_beside(&canvas.board, shown.into_iter().collect());
                    canvas.verticals(lines.into_iter(), PINNED);
                }
                None => {
                    let arcs = arcs_beside(&canvas.board, stretch(&self.diagram, trace, &view));
                    canvas.arcs(arcs, PINNED);
                }
            }
        }
        reserve(canvas, (self.k, self.mu));
        design_point(canvas, (self.k, self.mu));
    }
}

/// Draws the design point of A, hollow, where it is seen.
pub(crate) fn design_point(canvas: &mut Canvas, (across, up): (f64, f64)) {
    let axes = canvas.board.axes;
    if !axes.shows(across, up) {
        return;
    }
    let (x, y) = axes.at(across, up);
    let mut diamond = Path::through(&[(x, y - 6.4), (x + 6.4, y), (x, y + 6.4), (x - 6.4, y)]);
    diamond.close();
    canvas.scene.fill(&diamond, PAPER);
    canvas.scene.stroke(&diamond, Pen::solid(MARK, 1.6));
}

/// Keeps labels off the design point of A.
pub(crate) fn reserve(canvas: &mut Canvas, (across, up): (f64, f64)) {
    let axes = canvas.board.axes;
    if axes.shows(across, up) {
        let (x, y) = axes.at(across, up);
        canvas.board.reserve(Rect::around(x, y, 14.0, 14.0));
    }
}

/// The histories of a motion, to be drawn in dashes behind those of another.
#[derive(Debug, Clone, PartialEq)]
pub struct PinnedMotion {
    title: String,
    length_unit: String,
    /// The first load, which goes to the side.
    pub(crate) load: Vec<(f64, f64)>,
    pub(crate) slide: Vec<(f64, f64)>,
    pub(crate) theta: Vec<(f64, f64)>,
}

impl PinnedMotion {
    /// The histories of a motion.
    pub fn of(picture: &MotionPicture<'_>) -> PinnedMotion {
        let within = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
            points.iter().copied().filter(|(t, _)| *t <= picture.end).collect()
        };
        PinnedMotion {
            title: picture.title.to_owned(),
            length_unit: picture.length_unit.to_owned(),
            load: picture.loads.first().map_or_else(Vec::new, |load| within(load.points)),
            slide: within(picture.slide),
            theta: within(picture.theta),
        }
    }

    /// True if its lengths are in the unit of another motion.
    pub(crate) fn is_like(&self, picture: &MotionPicture<'_>) -> bool {
        self.length_unit == picture.length_unit
    }

    pub(crate) fn words(&self) -> String {
        words(&self.title)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_others_leave_of_a_stretch() {
        let left = |others: &[(f64, f64)]| left_by((1.0, 4.0), others.iter().copied());
        assert_eq!(left(&[]), [(1.0, 4.0)]);
        assert_eq!(left(&[(2.0, 3.0)]), [(1.0, 2.0), (3.0, 4.0)]);
        assert_eq!(left(&[(0.0, 2.0), (3.5, 9.0)]), [(2.0, 3.5)]);
        assert_eq!(left(&[(0.0, 2.0), (1.5, 5.0)]), []);
        assert_eq!(left(&[(5.0, 6.0)]), [(1.0, 4.0)]);
    }

    /// A body 15 m wide in one of 17.6 m, as high, corner O on corner O: its right edge alone is drawn. In one that is lower the top as well,
    /// and of the left edge what stands out.
    #[test]
    fn edges_that_both_have_are_not_drawn_twice() {
        let block =
            |left: f64, right: f64, top: f64| vec![(left, 0.0), (right, 0.0), (right, top), (left, top)];
        let narrow = block(-8.8, 6.2, 12.0);
        let beside = |other: Vec<(f64, f64)>| -> Vec<[(f64, f64); 2]> {
            edges(&narrow).into_iter().flat_map(|edge| without(edge, &edges(&other))).collect()
        };
        assert_eq!(beside(block(-8.8, 8.8, 12.0)), [[(6.2, 0.0), (6.2, 12.0)]]);
        assert!(beside(narrow.clone()).is_empty());
        let lower = beside(block(-8.8, 8.8, 9.0));
        assert_eq!(lower.len(), 3);
        assert_eq!(lower[..2], [[(6.2, 0.0), (6.2, 12.0)], [(6.2, 12.0), (-8.8, 12.0)]]);
        let [from, to] = lower[2];
        assert!((from.1 - 12.0).abs() < 1e-6 && (to.1 - 9.0).abs() < 1e-6 && from.0 == -8.8, "{lower:?}");
    }

    /// The boundary of a load half as large lies at half the share: at twice the value it has what it had.
    #[test]
    fn strips_are_widened_with_their_curves() {
        let strip = Strip {
            from: 0.2,
            to: 0.8,
            lower: Curve::Line { slope: 0.5, intercept: 0.1 },
            upper: Some(Curve::Hyperbola { a: 2.0, b: 1.0, c: 3.0, d: 4.0 }),
        };
        let [wide] = widened(&[strip], 2.0)[..] else { panic!("one strip") };
        assert_eq!((wide.from, wide.to), (0.4, 1.6));
        for k in [0.2, 0.5, 0.8] {
            assert!((wide.lower.at(2.0 * k) - (0.5 * k + 0.1)).abs() < 1e-15);
            let upper = wide.upper.map_or(f64::NAN, |curve| curve.at(2.0 * k));
            assert!((upper - (2.0 * k + 1.0) / (3.0 * k + 4.0)).abs() < 1e-15);
        }
    }
}
