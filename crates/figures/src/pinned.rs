//! Another case behind the one that is drawn, in dashes: A, which is pinned, behind B.
//!
//! Each type here is what a figure needs of A. It is made once, and drawn with every B.

use standfast::region::{Curve, Strip};
use standfast::{Diagram, Verdict};

use crate::canvas::{Canvas, FORMULA};
use crate::chart::stretch;
use crate::palette::{BEHIND, INK, MARK, PAPER};
use crate::plane::Plan;
use crate::plot::View;
use crate::scene::{Path, Pen, Rect};
use crate::sheet::Style;
use crate::text::Text;
use crate::{LoadPlane, MotionPicture, Outline, Section, map};

/// The line in which A is drawn.
pub(crate) const PINNED: Pen = Pen { colour: INK, width: 1.1, dashes: "6 4" };
/// The line of its histories, behind those of B.
pub(crate) const PINNED_HISTORY: Pen = Pen { colour: BEHIND, width: 1.4, dashes: "6 3.4" };

/// Name of the case in dashes, and what it is of.
fn words(title: &str) -> String {
    match title.trim() {
        "" => "Dashed: A".to_owned(),
        title => format!("Dashed: A, {title}"),
    }
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

    /// Outlines with their corner O in that of another section, without those that the section has as well.
    pub(crate) fn beside(&self, other: &Section<'_>) -> Vec<Vec<(f64, f64)>> {
        let moved = |part: &Vec<(f64, f64)>| -> Vec<(f64, f64)> {
            part.iter().map(|(x, y)| (x + other.base.0, *y)).collect()
        };
        let parts = self.parts.iter().map(moved);
        parts.filter(|part| !other.parts.iter().any(|own| is_same(&own.vertices, part))).collect()
    }

    pub(crate) fn words(&self) -> String {
        words(&self.title)
    }
}

/// True of outlines that no eye tells apart.
fn is_same(one: &[(f64, f64)], other: &[(f64, f64)]) -> bool {
    let size = one.iter().fold(0.0, |size: f64, (x, y)| size.max(x.abs()).max(y.abs()));
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-9 * size;
    one.len() == other.len()
        && one.iter().zip(other).all(|(one, other)| near(one.0, other.0) && near(one.1, other.1))
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
        words(&self.title)
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
        words(&self.title)
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
                    canvas.verticals(shown.into_iter(), PINNED);
                }
                None => canvas.arcs(stretch(&self.diagram, trace, &view), PINNED),
            }
        }
        design_point(canvas, (self.k, self.mu));
    }
}

/// Draws the design point of A, hollow, where it is seen, with its letter.
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
    canvas.board.reserve(Rect::around(x, y, 14.0, 14.0));
    canvas.design_label(&Text::verbatim("A", FORMULA), (x, y));
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
