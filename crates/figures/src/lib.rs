//! The k–μ diagram and the report's figures, as SVG, PNG and PDF.
//!
//! ```
//! use standfast::Diagram;
//! use standfast_figures::{DesignPoint, FigureId, diagram, report_figure};
//!
//! let id: FigureId = "3.11".parse()?;
//! assert!(report_figure(id).svg().starts_with("<svg"));
//!
//! let body = Diagram::new(2.0, 0.3)?;
//! let storm = DesignPoint { k: 0.31, mu: 0.6, label: "storm".into(), mirrored: false };
//! let figure = diagram(&body, &[storm]);
//! assert!(figure.title().contains("γ = 2"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | question | module |
//! |---|---|
//! | What does a chart show? | `sheet`, `map` (all modes), `report` (the report's 26), `plane` (load factor and friction), `stack` (two numbers of a stack), `ground` (the k–μ plane where the base gives way), `rotation` (moment and rotation of an elastic base), `feasible` (two quantities of a design), [`directions`](fn@directions) (all horizontal directions) |
//! | What stands where, and what presses on it? | [`section`](fn@section) |
//! | How likely is each mode? | `chances`: points with intervals, what matters, lines with intervals, clouds of draws |
//! | What became of a body in time? | `motion`: histories, positions, a picture that moves |
//! | What does a chart show, as coordinates? | [`outlines`](mod@outlines) |
//! | Where does it lie on the page? | `axes`, `scale` (numbers of an axis), `plot`, `canvas`, `chart` (of a `drawing`), `inset` |
//! | Where do the words go? | `labels`, `margins`, `caption` |
//! | How is it written down? | `text`, `font`, `scene`, `render`, `pdf` |
//! | What does a reader move about in on a screen? | `screen`, `cases` (γ–k′), `free_body` |
//!
//! All geometry is the library's: curves and points of [`standfast::initiation::Chart`], regions of [`Diagram`].
//! Text is drawn as outlines, so a figure looks the same everywhere and needs no fonts; `<title>` and `<desc>` say
//! it in words. The same input gives the same bytes.

#![forbid(unsafe_code)]

mod axes;
mod below;
mod canvas;
mod caption;
mod cases;
mod chances;
mod chart;
mod directions;
mod drawing;
mod feasible;
mod font;
mod free_body;
mod ground;
mod inset;
mod labels;
mod map;
mod margins;
mod motion;
mod number;
pub mod outlines;
mod palette;
#[cfg(feature = "render")]
mod pdf;
mod pinned;
mod plane;
mod plot;
#[cfg(feature = "render")]
mod render;
mod report;
mod rotation;
mod scale;
mod scene;
mod screen;
mod section;
mod sheet;
mod stack;
mod text;
mod texture;

use standfast::contact::stack::plane::StackPlane;
use standfast::diagram::Window;
use standfast::ground::bearing::BearingPlane;
use standfast::ground::load_plane::{GroundLoadPlane, LoadEdge};
use standfast::ground::strength::CrushMap;
use standfast::region::Region;
use standfast::{Diagram, Stage};

use ground::GroundPlane;

pub use axes::{Axis, AxisNumbers, axis_numbers};
pub use cases::cases_on_screen;
pub use chances::{
    Chance, ChanceCloud, ChanceGroup, ChanceLine, ChanceLines, ChanceMark, ChanceRow, ChanceRows, CloudPanel,
    Importance, LineLook, Tornado, chance_cloud, chance_lines, chance_rows, chance_tornado, draws_over,
};
pub use directions::{DirectionsChart, directions, directions_on_screen};
pub use feasible::{
    FeasibleSet, SetAxis, SetColumn, SetEnd, SetStretch, feasible_set, feasible_set_on_screen,
};
pub use font::{ITALIC_FONT, UPRIGHT_FONT};
pub use free_body::{FreeBody, Pose, free_body};
pub use motion::{
    Course, MotionLoad, MotionOutline, MotionPicture, MotionPose, MotionStage, SpectrumAxis, SpectrumLines,
    SpectrumMap, StageLines, course_on_screen, motion_animation, motion_histories, motion_histories_beside,
    motion_histories_on_screen, motion_histories_on_screen_beside, motion_positions, motion_stage,
    spectrum_lines, spectrum_map, strength_strip,
};
pub use number::significant;
pub use outlines::outlines;
#[doc(hidden)]
pub use palette::colours;
pub use pinned::{PinnedBody, PinnedDiagram, PinnedLoad, PinnedMotion, PinnedPlane};
pub use plot::View;
#[cfg(feature = "render")]
pub use render::RenderError;
pub use report::{FigureId, UnknownFigure, report_figure, sketch_on_screen};
pub use rotation::{RotationCurve, rotation_curve};
#[doc(hidden)]
pub use scene::Label;
pub use scene::Rect;
pub use screen::{Map, Picture, tint_on_screen};
pub use section::{
    Arrow, Backfill, BaseReaction, FailureSketch, JointLine, Level, Material, Measure, Mound, Outline,
    PlanPlace, PlanView, Pressed, Section, SectionArrow, SectionFit, SectionNumber, SectionPicture, Side,
    Stated, section, section_as_fitted, section_beside, section_on_screen, section_on_screen_beside,
};

/// A drawing with its caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    svg: String,
    title: String,
    caption: String,
    labels: Vec<Label>,
    size: (f64, f64),
}

impl Figure {
    /// A figure that was drawn before, of what is kept of it: its SVG document, its title, every label with its box, and its size. For faces
    /// that hold figures as data.
    pub fn kept(svg: String, title: String, labels: Vec<Label>, size: (f64, f64)) -> Figure {
        Figure { svg, title, caption: String::new(), labels, size }
    }

    /// The SVG document; in a dark page it takes dark colours.
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// The SVG document for a page that is always light.
    pub fn svg_on_paper(&self) -> String {
        match (self.svg.split_once("<style>"), self.svg.split_once("</style>\n")) {
            (Some((before, _)), Some((_, after))) => before.to_owned() + after,
            _ => self.svg.clone(),
        }
    }

    /// The SVG document with colours as custom properties of CSS, for a page that sets them, and whose own page it shows.
    pub fn svg_on_screen(&self) -> String {
        let mut svg = self.svg_on_paper();
        for (property, light, _) in palette::colours() {
            svg = svg.replace(&format!("\"{light}\""), &format!("\"var(--{property},{light})\""));
        }
        svg
    }

    /// Title of the figure, in a line of plain characters: `Fig. 3.11 All modes, case 3, …`.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The body drawn and the coordinates of the named points, in plain characters; empty for a sketch.
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// Width and height in SVG units, of which 96 make an inch.
    pub fn size(&self) -> (f64, f64) {
        self.size
    }

    /// Every label with its box: what a PDF can be searched for.
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }
}

/// A load case to be marked in a diagram. It is drawn if k and μ are finite and not negative.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignPoint {
    /// F/(m g).
    pub k: f64,
    /// Coulomb friction.
    pub mu: f64,
    /// Its name; may be empty.
    pub label: String,
    /// True if its force points right: the diagram is that of the mirror image, and the caption names the mode of the
    /// real body.
    pub mirrored: bool,
}

impl DesignPoint {
    fn is_drawable(&self) -> bool {
        is_drawable(&(self.k, self.mu))
    }
}

fn is_drawable(&(k, mu): &(f64, f64)) -> bool {
    (0.0..f64::INFINITY).contains(&k) && (0.0..f64::INFINITY).contains(&mu)
}

/// Content of a diagram beside the regions of the modes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DiagramContent<'a> {
    /// The largest k and μ; see [`DiagramContent::window_of`].
    pub window: Option<Window>,
    /// Load cases, marked and named. One outside of the window is pointed at from its edge.
    pub points: &'a [DesignPoint],
    /// A cloud of points without names, as (k, μ), marked by dots. They are drawn if k and μ are finite and not negative.
    pub cloud: &'a [(f64, f64)],
}

impl DiagramContent<'_> {
    /// All points that are drawn.
    fn marked(&self) -> Vec<(f64, f64)> {
        let named = self.points.iter().map(|point| (point.k, point.mu));
        named.chain(self.cloud.iter().copied()).filter(is_drawable).collect()
    }

    /// The window asked for; if none is, that of A and the other named points that are not much farther away, and of all
    /// points to be marked.
    pub fn window_of(&self, diagram: &Diagram) -> Window {
        self.window.unwrap_or_else(|| {
            let View { k_max, mu_max, .. } = map::window(diagram, &self.marked());
            Window { k: k_max, mu: mu_max }
        })
    }
}

/// The map of all modes of one body and one elevation of the force, with design points, in a window that holds them.
pub fn diagram(diagram: &Diagram, points: &[DesignPoint]) -> Figure {
    rigid_diagram(diagram, &DiagramContent { points, ..DiagramContent::default() })
}

/// The k–μ plane of a body on a base.
#[derive(Debug, Clone, PartialEq)]
pub enum KMuPlane {
    /// On a rigid base.
    Rigid(Diagram),
    /// On a base that crushes.
    Crushing(CrushMap),
    /// On ground that fails.
    Failing(BearingPlane),
}

impl From<Diagram> for KMuPlane {
    fn from(diagram: Diagram) -> KMuPlane {
        KMuPlane::Rigid(diagram)
    }
}

/// The k–μ plane of one body, one elevation of the force and one base. Where the base gives way, lines of the rigid plane lie behind, dotted.
///
/// The indeterminate set N, where several modes are consistent, is hatched if a point lies in it.
///
/// ```
/// use standfast::ground::strength::CrushMap;
/// use standfast_figures::{DesignPoint, DiagramContent, KMuPlane, diagram_with};
///
/// let plane = KMuPlane::Crushing(CrushMap::new(0.8, 0.9167, 0.08)?);
/// let storm = [DesignPoint { k: 0.61, mu: 0.6, label: "storm".into(), mirrored: false }];
/// let content = DiagramContent { points: &storm, ..DiagramContent::default() };
/// let figure = diagram_with(&plane, &content);
/// assert!(figure.caption().contains("storm (0.61, 0.6): RO."));
/// # Ok::<(), standfast::InputError>(())
/// ```
pub fn diagram_with(plane: &KMuPlane, content: &DiagramContent<'_>) -> Figure {
    match plane {
        KMuPlane::Rigid(diagram) => rigid_diagram(diagram, content),
        KMuPlane::Crushing(map) => ground::diagram(GroundPlane::Crushing(map), content),
        KMuPlane::Failing(plane) => ground::diagram(GroundPlane::Failing(plane), content),
    }
}

/// The map of all modes with that of another case in dashes, and the design point of that, hollow; the window holds both.
pub fn diagram_beside(diagram: &Diagram, content: &DiagramContent<'_>, pinned: &PinnedDiagram) -> Figure {
    rigid_diagram_beside(diagram, content, Some(pinned))
}

fn rigid_diagram(diagram: &Diagram, content: &DiagramContent<'_>) -> Figure {
    rigid_diagram_beside(diagram, content, None)
}

fn rigid_diagram_beside(
    diagram: &Diagram,
    content: &DiagramContent<'_>,
    pinned: Option<&PinnedDiagram>,
) -> Figure {
    let (sheet, condition) = map::sheet(diagram.chart().case());
    let unresolved = diagram.unresolved();
    let within = |&(k, mu): &(f64, f64)| unresolved.iter().any(|part| part.contains(k, mu));
    let undecided = content.marked().iter().any(within);
    let window = content.window_of(diagram);
    let window = View::from_origin(window.k, window.mu);
    drawing::Drawing {
        diagram,
        sheet,
        window: pinned.map_or(window, |pinned| pinned.with_room(window)),
        heading: map::HEADING,
        caption: &number::body(diagram.chart()),
        preface: condition,
        points: content.points,
        cloud: content.cloud,
        hatched: if undecided { &unresolved } else { &[] },
        pinned,
        numbered: true,
    }
    .figure()
}

/// The plane of load factor and friction of any block, on any base, and the way of a rising load through it.
///
/// `regions` are those of [`Situation::plane`](standfast::Situation::plane) up to the same load factor, `stages` those of its
/// [`Outcome`](standfast::Outcome), which are cut there.
#[derive(Debug, Clone, Copy)]
pub struct LoadPlane<'a> {
    /// Regions of the modes on rigid ground.
    pub regions: &'a [Region],
    /// The plane of a base that gives way, up to the same load factor: boundaries on rigid ground are then drawn behind, dotted.
    pub base: Option<&'a GroundLoadPlane>,
    /// The load factors at which the ground fails at an angle of friction 2° less and more: a band, hatched; `None` where there is none.
    pub uncertain: Option<[f64; 2]>,
    /// The largest load factor; above zero.
    pub up_to: f64,
    /// The body's friction to stick: the load path runs along it.
    pub friction: f64,
    /// The stages along the load path.
    pub stages: &'a [Stage],
    /// Title, the body under load, in a line; not markup.
    pub title: &'a str,
}

/// The plane of load factor λ and friction μ, with the load path: a line at the body's friction, a tick with the load
/// factor at every change of mode, and a diamond at the full load, λ = 1.
///
/// ```
/// use standfast::ground::load_plane::GroundLoadPlane;
/// use standfast::ground::strength::outcome;
/// use standfast::loads::{Action, Load, LoadKind, LoadSource};
/// use standfast::{Body, Situation};
/// use standfast_figures::{LoadPlane, load_plane};
///
/// let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-1e6, 5.2));
/// let situation = Situation::new(Body::new(15.0, 10.5, 346_050.0)?, 0.6, 9.81)?.with_weight().with(push);
/// let figure = load_plane(&LoadPlane {
///     regions: &situation.plane(2.0)?,
///     base: None,
///     uncertain: None,
///     up_to: 2.0,
///     friction: situation.static_friction(),
///     stages: &situation.path()?,
///     title: "Caisson in air",
/// });
/// assert!(figure.caption().contains("Full load (λ = 1, diamond): RE"));
///
/// // On a base that crushes at 3 MPa, under a force that moves it.
/// let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-2.7e6, 11.5));
/// let situation = Situation::new(Body::new(15.0, 12.0, 378e3)?, 0.6, 9.81)?.with_weight().with(push);
/// let figure = load_plane(&LoadPlane {
///     regions: &situation.plane(2.0)?,
///     base: Some(&GroundLoadPlane::crushing(&situation, 3e6, 2.0)?),
///     uncertain: None,
///     up_to: 2.0,
///     friction: situation.static_friction(),
///     stages: &outcome(&situation, 3e6)?.outcome.path,
///     title: "Caisson on stone",
/// });
/// assert!(figure.caption().contains("Full load (λ = 1, diamond): RO"));
/// # Ok::<(), standfast::InputError>(())
/// ```
pub fn load_plane(plane: &LoadPlane<'_>) -> Figure {
    plane::figure(plane, None)
}

/// The plane of two numbers of a stack of bodies.
#[derive(Debug, Clone)]
pub struct StackMap<'a> {
    /// Its regions.
    pub plane: &'a StackPlane,
    /// The largest k and μ shown.
    pub window: [f64; 2],
    /// Name of k, in markup.
    pub across: &'a str,
    /// Name of μ, in markup.
    pub up: &'a str,
    /// Boundaries known in closed form, as μ of k: points of each.
    pub curves: &'a [Vec<(f64, f64)>],
    /// A point with its name, as that of the full load; `None` of a map of stacks in general.
    pub point: Option<DesignPoint>,
    /// What its regions tell, in a sentence; that they are the modes of all joints, if nothing is said.
    pub regions: Option<&'a str>,
    /// What each region is, in words for the key, in the order of the plane's; `None` of stacks in general, whose key has patterns.
    pub words: Option<&'a [String]>,
    /// Title, in a line; not markup.
    pub title: &'a str,
}

/// The plane of two numbers of a stack: each region is named by the modes of its joints from the ground up, has the colour of the lowest joint
/// that moves, and a pattern for which joints those are. Boundaries known in closed form are dotted over.
pub fn stack_map(map: &StackMap<'_>) -> Figure {
    stack::figure(map)
}

/// The same with the boundaries of another case in dashes, and its full load hollow; the window holds both.
pub fn load_plane_beside(plane: &LoadPlane<'_>, pinned: Option<PinnedLoad<'_>>) -> Figure {
    plane::figure(plane, pinned)
}

/// The lines between different verdicts that [`load_plane`] draws of a base that gives way, through points of their curves; verticals
/// apart.
#[doc(hidden)]
pub fn load_lines(plane: &LoadPlane<'_>) -> Vec<(LoadEdge, outlines::Polyline)> {
    plane::lines(plane)
}

/// Figure of [`load_plane`] for a screen, with a plot of some width and height and colours as custom properties of CSS.
pub fn load_plane_on_screen(plane: &LoadPlane<'_>, plot: (f64, f64)) -> Picture {
    plane::figure_on_screen(plane, None, plot)
}

/// The same with the boundaries of another case in dashes, and its full load hollow; the window holds both.
pub fn load_plane_on_screen_beside(
    plane: &LoadPlane<'_>,
    pinned: Option<PinnedLoad<'_>>,
    plot: (f64, f64),
) -> Picture {
    plane::figure_on_screen(plane, pinned, plot)
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
