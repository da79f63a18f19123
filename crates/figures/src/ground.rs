//! The k–μ plane where the base gives way: a base that crushes, with the rigid map dotted behind it, or ground that fails.
//!
//! All curves are lines between points that satisfy the library's equations to the last digit, so dense that no bend is seen.

mod crush;
pub(crate) mod shape;
mod soil;

use standfast::diagram::Window;
use standfast::ground::bearing::BearingPlane;
use standfast::ground::strength::{CrushMap, CrushPoint};
use standfast::{Diagram, Modes, Verdict};

use self::shape::{Shape, through};
use crate::axes::{COLUMN, FRAME, LEFT, NUMBER};
use crate::below::Words;
use crate::canvas::{Canvas, FORMULA};
use crate::caption::{self, SIZE, SMALL, Said, pair};
use crate::chart::{LETTER, named_plane, plane as plane_at};
use crate::margins;
use crate::number::digits;
use crate::outlines::{OutlinedLine, Outlines, polygons};
use crate::palette::{BEHIND, FAINT, INK, verdict_symbol, verdict_tint};
use crate::plot::{Arc, Fall, Piece, View, clip_strips, hatch};
use crate::scene::Pen;
use crate::text::Text;
use crate::{DesignPoint, DiagramContent, Figure, map, outlines};

const BOUNDARY: Pen = Pen::solid(INK, 1.5);
const DASHED: Pen = Pen { colour: INK, width: 0.9, dashes: "5 3.4" };
/// Above the plot: the name of the friction.
const TOP: f64 = 30.0;
/// The shortest line that carries its equation, in pixels.
const SHORTEST: f64 = 20.0;
/// Boundaries on rigid ground, behind those of a base that gives way.
pub(crate) const RIGID: Pen = Pen { colour: BEHIND, width: 1.3, dashes: "1.5 3" };
/// Their name.
pub(crate) const ON_RIGID: &str = "on rigid ground";
/// How their pen is told below a plane.
pub(crate) const DOTTED: &str = " Dotted: on rigid ground.";

/// The k–μ plane of a base that gives way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum GroundPlane<'a> {
    /// A base that crushes.
    Crushing(&'a CrushMap),
    /// Ground that fails.
    Failing(&'a BearingPlane),
}

/// The figure of the plane, with the lines of the rigid map dotted behind.
pub(crate) fn diagram(plane: GroundPlane<'_>, content: &DiagramContent<'_>) -> Figure {
    Draft::new(plane, content).figure(plane, content)
}

/// The plane as coordinates; see [`outlines`](fn@crate::outlines). Curves go through points that satisfy the library's equations to the
/// last digit.
pub(crate) fn outlined(plane: GroundPlane<'_>, content: &DiagramContent<'_>) -> Outlines {
    let window = plane.window_of(content);
    let view = View::from_origin(window.k, window.mu);
    let Shape { areas, lines, points, k_marks, mu_marks } = plane.shape(&view);
    let areas = areas.iter().map(|(verdict, strips)| outlines::Area {
        verdict: *verdict,
        symbol: verdict_symbol(*verdict),
        tint: verdict_tint(*verdict),
        polygons: polygons(strips, &view),
    });
    Outlines {
        window,
        areas: areas.collect(),
        unresolved: Vec::new(),
        lines,
        rigid: plane.rigid_lines(window),
        points,
        k_marks,
        mu_marks,
    }
}

impl GroundPlane<'_> {
    fn body(&self) -> (f64, f64) {
        match self {
            GroundPlane::Crushing(map) => (map.chart().gamma(), map.chart().k_prime()),
            GroundPlane::Failing(plane) => (plane.gamma(), plane.k_prime()),
        }
    }

    /// The plane on rigid ground.
    fn rigid(&self) -> Diagram {
        let (gamma, k_prime) = self.body();
        Diagram::new(gamma, k_prime).expect("a plane has been made of these numbers")
    }

    /// The window asked for; if none is, one that shows both this plane and the rigid one behind it, and all points.
    fn window_of(&self, content: &DiagramContent<'_>) -> Window {
        content.window.unwrap_or_else(|| {
            let View { k_max, mu_max, .. } = map::window(&self.rigid(), &[]);
            // Where little is left of the plane, the rigid one gives way.
            let share = match self {
                GroundPlane::Crushing(map) => (2.5 * (1.0 - map.chart().omega())).min(1.0),
                GroundPlane::Failing(plane) => {
                    let (k_bf, unit) = (plane.k_bf(), map::unit(&self.rigid()));
                    if k_bf > 0.0 { (3.0 * k_bf / unit).min(1.0) } else { 1.0 }
                }
            };
            let corner = match self {
                GroundPlane::Crushing(_) => map::unit(&self.rigid()),
                GroundPlane::Failing(plane) => plane.k_bf(),
            };
            let most = (share * k_max, share * mu_max);
            let View { k_max: k, mu_max: mu, .. } = map::framed(most, (corner, corner), &content.marked());
            Window { k, mu }
        })
    }

    fn shape(&self, view: &View) -> Shape {
        match self {
            GroundPlane::Crushing(map) => crush::shape(map, view),
            GroundPlane::Failing(plane) => soil::shape(plane, view),
        }
    }

    /// The boundaries on rigid ground.
    fn rigid_lines(&self, window: Window) -> Vec<outlines::Polyline> {
        let content = DiagramContent { window: Some(window), ..DiagramContent::default() };
        let lines = outlines::rigid(&self.rigid(), &content).lines.into_iter();
        lines.filter(|line| !line.dashed).flat_map(|line| line.parts).collect()
    }

    fn said(&self, point: &DesignPoint) -> Option<Said> {
        match self {
            GroundPlane::Crushing(map) => {
                let chart = map.chart();
                let at =
                    CrushPoint::new(chart.gamma(), chart.k_prime(), point.k, point.mu, chart.omega()).ok()?;
                Some(Said { verdict: at.verdict(), others: at.others() })
            }
            GroundPlane::Failing(plane) => {
                let verdict = plane.at(point.k, point.mu).ok()?.verdict;
                Some(Said { verdict, others: Modes::NONE })
            }
        }
    }

    fn heading(&self) -> &'static str {
        match self {
            GroundPlane::Crushing(_) => "Modes on a base that crushes,",
            GroundPlane::Failing(_) => "Rest, sliding and bearing failure,",
        }
    }

    /// What the plane is of, in markup.
    fn given(&self) -> String {
        let (gamma, k_prime) = self.body();
        let body = format!("$γ = {}$, $k′ = {}$", digits(gamma), digits(k_prime));
        match self {
            GroundPlane::Crushing(map) => format!("{body}, $ω = {}$", digits(map.chart().omega())),
            GroundPlane::Failing(_) => body,
        }
    }
}

/// The figure under way.
struct Draft {
    canvas: Canvas,
    shape: Shape,
    window: Window,
    areas: Vec<(Verdict, Vec<Piece>)>,
    /// What is said below of lines and hatching, in markup.
    legend: Vec<String>,
}

impl Draft {
    fn new(plane: GroundPlane<'_>, content: &DiagramContent<'_>) -> Draft {
        let window = plane.window_of(content);
        let view = View::from_origin(window.k, window.mu);
        let shape = plane.shape(&view);
        let canvas = Canvas::new(plane_at(&view, TOP));
        let areas = shape.areas.iter().map(|(verdict, strips)| (*verdict, clip_strips(strips, &view)));
        let areas = areas.filter(|(_, pieces)| !pieces.is_empty()).collect();
        Draft { canvas, shape, window, areas, legend: Vec::new() }
    }

    fn figure(mut self, plane: GroundPlane<'_>, content: &DiagramContent<'_>) -> Figure {
        let axes = self.canvas.board.axes;
        for (verdict, pieces) in &self.areas {
            self.canvas.region(pieces, *verdict);
        }
        self.hatching(plane, content);
        for part in plane.rigid_lines(self.window) {
            self.canvas.line(&part, RIGID);
        }
        for line in std::mem::take(&mut self.shape.lines) {
            for part in &line.parts {
                self.canvas.line(part, if line.dashed { DASHED } else { BOUNDARY });
            }
            self.shape.lines.push(line);
        }
        axes.border(&mut self.canvas.scene, FRAME);
        let numbered = self.marks(plane, content);
        self.finish(plane, content, &numbered)
    }

    /// Hatches where several modes are consistent, if a point lies there.
    fn hatching(&mut self, plane: GroundPlane<'_>, content: &DiagramContent<'_>) {
        let GroundPlane::Crushing(map) = plane else { return };
        let chart = map.chart();
        let is_several = |&(k, mu): &(f64, f64)| {
            let point = CrushPoint::new(chart.gamma(), chart.k_prime(), k, mu, chart.omega());
            point.is_ok_and(|point| !point.is_unique())
        };
        if !content.marked().iter().any(is_several) {
            return;
        }
        let axes = self.canvas.board.axes;
        let (strips, modes) = crush::undecided(chart, &axes.view());
        let pieces = clip_strips(&strips, &axes.view());
        self.canvas.scene.stroke(&hatch(&axes, &pieces, 9.0, Fall::Rising), Pen::solid(FAINT, 0.4));
        for (verdict, own) in &self.areas {
            self.canvas.hatched.push((common(&pieces, own), verdict_tint(*verdict)));
        }
        self.legend.push(format!("hatched: one of {}", caption::symbols(modes)));
    }

    /// Letters, points, names of regions and formulas. Gives the points that carry numbers.
    fn marks(&mut self, plane: GroundPlane<'_>, content: &DiagramContent<'_>) -> Vec<usize> {
        let axes = self.canvas.board.axes;
        self.canvas.cloud(content.cloud);
        for point in &self.shape.points {
            self.canvas.dot(axes.at(point.k, point.mu), 2.6, 6.5);
        }
        for point in &self.shape.points {
            self.canvas.letter(&Text::new(&point.markup, LETTER), axes.at(point.k, point.mu));
        }
        let numbered = self.canvas.design_points(content.points);
        for (verdict, pieces) in &self.areas {
            self.canvas.name(pieces, verdict_symbol(*verdict), 15.5, None);
        }
        for line in std::mem::take(&mut self.shape.lines) {
            self.formula(&line);
            self.shape.lines.push(line);
        }
        self.name_rigid(plane);
        numbered
    }

    /// The name of the boundaries on rigid ground, beside the longest that has room for it.
    fn name_rigid(&mut self, plane: GroundPlane<'_>) {
        let mut arcs: Vec<Arc> = plane.rigid_lines(self.window).iter().flat_map(|part| arcs(part)).collect();
        standfast::order::by_number(&mut arcs, |one| -(one.to - one.from));
        self.canvas.beside_line(&arcs, &Text::inline(ON_RIGID, NUMBER));
    }

    /// A line's equation beside it, or near it with a leader, or in the caption.
    fn formula(&mut self, line: &OutlinedLine) {
        if line.formula.is_empty() || line.parts.is_empty() {
            return;
        }
        let axes = self.canvas.board.axes;
        let longest = line.parts.iter().max_by(|one, other| length(one).total_cmp(&length(other)));
        let Some(part) = longest else { return };
        // What is too short to be seen is not to be named.
        let seen = part.first().zip(part.last()).map(|(one, other)| {
            let ((x0, y0), (x1, y1)) = (axes.at(one.0, one.1), axes.at(other.0, other.1));
            (x1 - x0).hypot(y1 - y0)
        });
        if seen.is_none_or(|length| length < SHORTEST) {
            return;
        }
        // From a little beyond the middle of the line outwards.
        let mut arcs = arcs(part);
        let (from, to) = (part[0].0, part[part.len() - 1].0);
        let middle = from + 0.6 * (to - from);
        arcs.sort_by(|one, other| {
            let off = |arc: &Arc| ((arc.from + arc.to) / 2.0 - middle).abs();
            off(one).total_cmp(&off(other))
        });
        let places = || [2, 3, 4, 1].map(|i| part[(part.len() - 1) * i / 5]).map(|(k, mu)| axes.at(k, mu));
        for markup in [line.formula, line.short] {
            let text = Text::new(markup, FORMULA);
            if !markup.is_empty()
                && (self.canvas.beside_line(&arcs, &text) || self.canvas.joined(places(), &text))
            {
                return;
            }
        }
        self.legend.push(format!("{}: {}", line.name.replace("mu", "μ"), line.formula));
    }

    fn finish(mut self, plane: GroundPlane<'_>, content: &DiagramContent<'_>, numbered: &[usize]) -> Figure {
        let axes = self.canvas.board.axes;
        let (bottom, _) = named_plane(&mut self.canvas.scene, &axes, false);
        let edges = (LEFT, COLUMN - LEFT);
        let heading = margins::words(&format!("{} {}", plane.heading(), plane.given()), SIZE);
        // What lies outside the frame is not drawn.
        let shown = self.shape.points.iter().filter(|point| axes.shows(point.k, point.mu));
        let parts = shown.map(|point| format!("{}~{}", point.markup, pair(point.k, point.mu)));
        let parts: Vec<String> = parts.chain(std::mem::take(&mut self.legend)).collect();
        let stop = if parts.is_empty() { "" } else { "." };
        let known = format!("{}{stop}{DOTTED} {}", parts.join(", "), self.remark(plane));
        let mut details = margins::words(known.trim(), SMALL);
        let view = axes.view();
        let said = |point: &DesignPoint| plane.said(point);
        details.extend(caption::of_points(content.points, content.cloud, &view, numbered, said));
        let words = Words::new(heading, details);
        let description = self.description(&words.caption);
        words.figure(self.canvas.scene, edges, bottom + 16.0, 16.0, &description)
    }

    /// What is to be known of the whole plane, in markup.
    fn remark(&self, plane: GroundPlane<'_>) -> String {
        let GroundPlane::Failing(plane) = plane else { return String::new() };
        let law = match plane.ground().law_name() {
            "ec7" => "EN 1997-1, Annex D",
            "hansen" => "Brinch Hansen",
            "undrained" => "EN 1997-1, Annex D, undrained",
            _ => "an envelope",
        };
        let takes = format!(
            "Ground by {law}; the weight takes $u = V/V_0 = {}$ of what it bears.",
            digits(plane.share())
        );
        if plane.k_bf() > 0.0 { takes } else { takes + " It does not bear the body alone." }
    }

    fn description(&self, caption: &str) -> String {
        let shaded =
            self.areas.iter().map(|(verdict, _)| caption::region(verdict_symbol(*verdict), verdict.words()));
        format!("{} {caption}", caption::chart("the force k", &self.canvas.board.axes.view(), shaded))
    }
}

fn length(part: &[(f64, f64)]) -> f64 {
    part.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum()
}

/// A polyline as what labels keep off.
pub(crate) fn arcs(part: &[(f64, f64)]) -> Vec<Arc> {
    let rising = part
        .windows(2)
        .map(|pair| if pair[0].0 < pair[1].0 { (pair[0], pair[1]) } else { (pair[1], pair[0]) });
    let flat = rising.filter(|(one, other)| one.0 < other.0);
    flat.map(|(one, other)| Arc { curve: through(one, other), from: one.0, to: other.0 }).collect()
}

/// What two sets of pieces share.
fn common(some: &[Piece], others: &[Piece]) -> Vec<Piece> {
    let mut shared = Vec::new();
    for one in some {
        for other in others {
            let (from, to) = (one.from.max(other.from), one.to.min(other.to));
            let middle = (from + to) / 2.0;
            if from < to
                && one.lower.at(middle) < other.upper.at(middle)
                && other.lower.at(middle) < one.upper.at(middle)
            {
                shared.push(Piece { from, to, ..*one });
            }
        }
    }
    shared
}
