//! Pictures for a screen, where a reader moves about: the k–μ diagram in a window of any place and size.
//!
//! They are drawn by the same hand as the figures on paper, with these differences: axes have numbers, since the window
//! need not start at the origin; there is no caption; colours are custom properties of CSS (`--ink`, `--rock`, …), so that
//! a page can change its theme without drawing anew. [`Picture`] knows which values lie where.

use standfast::diagram::{Unresolved, Window};
use standfast::{Diagram, Mode};

use crate::axes::{Axes, Axis, NUMBER, Names};
use crate::canvas::Canvas;
use crate::chart::Draft;
use crate::drawing::Drawing;
use crate::margins;
use crate::number;
use crate::palette::INK;
use crate::pinned::PinnedDiagram;
use crate::plot::{View, clip};
use crate::scene::{Rect, Scene};
use crate::sheet::Sheet;
use crate::text::Text;
use crate::{DesignPoint, DiagramContent, Figure, FigureId, caption, map, report};

/// A drawing for the screen and where its values lie.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The drawing.
    pub figure: Figure,
    /// Its plot, in units of the drawing.
    pub plot: Rect,
    /// The values to the right.
    pub across: Axis,
    /// The values upwards.
    pub up: Axis,
}

impl Picture {
    /// Place of a pair of values in the drawing.
    pub fn place(&self, across: f64, up: f64) -> (f64, f64) {
        self.axes().at(across, up)
    }

    /// The pair of values at a place in the drawing.
    pub fn values(&self, x: f64, y: f64) -> (f64, f64) {
        let axes = self.axes();
        (axes.across_at(x), axes.up_at(y))
    }

    pub(crate) fn axes(&self) -> Axes {
        Axes { area: self.plot, across: self.across, up: self.up }
    }
}

impl View {
    /// The view that shows a diagram best; a larger one if the point (`k`, `mu`) lies outside.
    pub fn of(diagram: &Diagram, k: f64, mu: f64) -> View {
        let view = map::window(diagram, &[]);
        if k <= view.k_max && mu <= view.mu_max {
            return view;
        }
        let Window { k, mu } =
            DiagramContent { cloud: &[(k, mu)], ..DiagramContent::default() }.window_of(diagram);
        View::from_origin(k, mu)
    }

    /// The view of a chart of the report; `None` for its sketches.
    pub fn of_figure(id: FigureId) -> Option<View> {
        report::chart(id).map(|(_, _, Window { k, mu })| View::from_origin(k, mu))
    }

    /// The view `factor` times as large (so 0.5 is twice as near), with (`k`, `mu`) staying where it is, as far as no
    /// negative value comes into view. What is too small or too large to be drawn is left as it was.
    pub fn zoomed(&self, factor: f64, k: f64, mu: f64) -> View {
        let zoomed = View {
            k_min: k + factor * (self.k_min - k),
            k_max: k + factor * (self.k_max - k),
            mu_min: mu + factor * (self.mu_min - mu),
            mu_max: mu + factor * (self.mu_max - mu),
        };
        zoomed.in_quadrant().filter(View::is_drawable).unwrap_or(*self)
    }

    /// The view moved by shares of its width and height, as far as no negative value comes into view.
    pub fn moved(&self, right: f64, up: f64) -> View {
        let (right, up) = (right * self.width(), up * self.height());
        let moved = View {
            k_min: self.k_min + right,
            k_max: self.k_max + right,
            mu_min: self.mu_min + up,
            mu_max: self.mu_max + up,
        };
        moved.in_quadrant().filter(View::is_drawable).unwrap_or(*self)
    }

    fn in_quadrant(self) -> Option<View> {
        let (right, up) = ((-self.k_min).max(0.0), (-self.mu_min).max(0.0));
        let numbers = [self.k_min, self.k_max, self.mu_min, self.mu_max];
        numbers.iter().all(|number| number.is_finite()).then_some(View {
            k_min: self.k_min + right,
            k_max: self.k_max + right,
            mu_min: self.mu_min + up,
            mu_max: self.mu_max + up,
        })
    }

    /// True if the view is neither empty nor so small or far out that its ticks could not be told apart.
    pub fn is_drawable(&self) -> bool {
        let sensible = |least: f64, greatest: f64| {
            least >= 0.0 && greatest < 1e9 && greatest - least > 1e-9 && greatest - least > 1e-3 * greatest
        };
        sensible(self.k_min, self.k_max) && sensible(self.mu_min, self.mu_max)
    }
}

/// Margins around the plot: for the numbers and names of the axes, and for labels at the ends of lines.
const LEFT: f64 = 54.0;
const RIGHT: f64 = 46.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 44.0;

/// The map of all modes, or a chart of the report, in a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map<'a> {
    /// Diagram that is shown; the indeterminate set N is hatched.
    pub diagram: &'a Diagram,
    /// A chart of the report to be shown instead, if the body is that of its drawing.
    pub figure: Option<FigureId>,
    /// The window.
    pub view: &'a View,
    /// Width and height of the whole picture.
    pub size: (f64, f64),
}

/// Height of a line of words below a map.
const LINE: f64 = 20.0;

/// Content of a map.
struct Content {
    sheet: &'static Sheet,
    heading: String,
    caption: String,
    unresolved: Vec<Unresolved>,
}

impl Map<'_> {
    /// The map for a screen.
    pub fn on_screen(&self) -> Picture {
        self.draw(Scene::themed(), None, None)
    }

    /// The same with another diagram in dashes.
    pub fn on_screen_beside(&self, pinned: Option<&PinnedDiagram>) -> Picture {
        self.draw(Scene::themed(), None, pinned)
    }

    /// Picture for paper: colours are fixed, and the design point is marked.
    pub fn on_paper(&self, point: &DesignPoint) -> Figure {
        self.on_paper_beside(point, None)
    }

    /// The same with another diagram in dashes, and a line of words on it.
    pub fn on_paper_beside(&self, point: &DesignPoint, pinned: Option<&PinnedDiagram>) -> Figure {
        self.draw(Scene::default(), Some(point), pinned).figure
    }

    /// Every curve of the map within the window, by its equation in plain characters: `count` points on each stretch.
    pub fn curves(&self, count: usize) -> Vec<(String, Vec<(f64, f64)>)> {
        let content = self.content();
        let chart = self.diagram.chart();
        let traces = content.sheet.traces.iter().flat_map(|trace| {
            let curve = trace.line.curve(chart);
            let arcs = curve
                .map_or(Vec::new(), |curve| clip(curve, trace.from.k(chart), trace.to.k(chart), self.view));
            arcs.into_iter().map(|arc| {
                let k = |i: usize| arc.from + (arc.to - arc.from) * i as f64 / (count.max(2) - 1) as f64;
                let points = (0..count.max(2)).map(|i| (k(i), arc.curve.at(k(i)))).collect();
                (Text::inline(trace.line.formula(chart), NUMBER).plain, points)
            })
        });
        traces.collect()
    }

    fn content(&self) -> Content {
        let chart = self.diagram.chart();
        let body = (chart.gamma(), chart.k_prime());
        let of_report = self.figure.and_then(|id| Some((id, report::chart(id)?)));
        match of_report.filter(|(_, (_, drawn, _))| *drawn == body) {
            Some((id, (sheet, ..))) => Content {
                sheet,
                heading: format!("Fig. {id}"),
                caption: report::caption(id).to_owned(),
                unresolved: Vec::new(),
            },
            None => {
                let (sheet, _) = map::sheet(chart.case());
                Content {
                    sheet,
                    heading: map::HEADING.to_owned(),
                    caption: number::body(chart),
                    unresolved: self.diagram.unresolved(),
                }
            }
        }
    }

    fn draw(&self, scene: Scene, point: Option<&DesignPoint>, pinned: Option<&PinnedDiagram>) -> Picture {
        let Map { diagram, view, size: (width, height), .. } = *self;
        let Content { sheet, heading, caption, unresolved } = self.content();
        let drawing = Drawing {
            diagram,
            sheet,
            window: *view,
            heading: &heading,
            caption: &caption,
            preface: "",
            points: point.map_or(&[], std::slice::from_ref),
            cloud: &[],
            hatched: &unresolved,
            pinned,
            numbered: true,
        };
        let area = Rect {
            x0: LEFT,
            y0: TOP,
            x1: (width - RIGHT).max(LEFT + 60.0),
            y1: (height - BOTTOM).max(TOP + 60.0),
        };
        let axes = Axes::of(area, view);
        let mut canvas = Canvas::new(axes);
        canvas.scene = scene;
        let mut draft = Draft::new(&drawing, canvas);
        draft.tints();
        draft.traces();
        let scene = &mut draft.canvas.scene;
        let names = if view.is_from_origin() { &Names::NUMBERED } else { &Names::AWAY_FROM_ORIGIN };
        axes.arrows(scene, names);
        axes.round_numbers(scene);
        let name = Text::new("force $k = F/(mg)$", NUMBER);
        scene.text(&name, area.x1 - name.width, area.y1 + 36.0, INK);
        draft.marks();
        let scene = &mut draft.canvas.scene;
        // A formula too long for the margin is left out; a letter or a short name is not.
        let mut right = std::mem::take(&mut draft.right);
        right.retain(|tab| tab.text.width < RIGHT - 17.0);
        margins::right_of(scene, &axes, right);
        margins::above(scene, &axes, std::mem::take(&mut draft.above), area.x0);

        let words = pinned.map(|pinned| format!("{}.", pinned.words()));
        let height = match words.as_ref().filter(|_| point.is_some()) {
            Some(words) => {
                scene.text(&Text::verbatim(words, caption::SMALL), area.x0, height + 8.0, INK);
                height + LINE
            }
            None => height,
        };
        let title = caption::title(&drawing);
        let named = [Some(named_points(&drawing)), words].into_iter().flatten().collect::<Vec<_>>();
        let description = caption::description(&drawing, &named.join(" "));
        let (svg, labels) = draft.canvas.scene.finish(width, height, &title, &description);
        let (across, up) = view.axes();
        let figure = Figure { svg, title, caption: String::new(), labels, size: (width, height) };
        Picture { figure, plot: area, across, up }
    }
}

fn named_points(drawing: &Drawing) -> String {
    let digits = |value: f64| Text::inline(&format!("${}$", number::digits(value)), NUMBER).plain;
    let point = |point: standfast::initiation::NamedPoint| {
        format!("{} ({}, {})", point.name.letter().replace('\'', "′"), digits(point.k), digits(point.mu))
    };
    format!("Named points: {}.", drawing.named().map(point).collect::<Vec<_>>().join(", "))
}

/// The tint of a mode as CSS, for legends beside a picture.
pub fn tint_on_screen(mode: Mode) -> String {
    crate::palette::themed(crate::palette::tint(mode)).into_owned()
}
