//! One chart of the k–μ plane, from a [`Drawing`] to a [`Figure`].
//!
//! Drawing order: tints, hatching, drop lines, curves, axes, points, then labels: letters of points, design points,
//! the lens, names of regions, formulas. What finds no free place goes to the plot's edge, and then to the caption.

use standfast::initiation::NamedPoint;
use standfast::region::Strip;
use standfast::{Diagram, Mode, Verdict};

use crate::axes::{Axes, COLUMN, FRAME, LEFT, NUMBER, Names};
use crate::below::Words;
use crate::canvas::{Canvas, FORMULA};
use crate::caption::SIZE;
use crate::drawing::Drawing;
use crate::margins::{self, Tab};
use crate::palette::{FAINT, INK, PAPER, symbol, tint};
use crate::plot::{Arc, Fall, Piece, View, clip, clip_strips, hatch, level};
use crate::scene::{Pen, Rect, Scene};
use crate::sheet::{Line, Mark, Naming, Part, Style, Trace, k_markup, letter_markup};
use crate::text::Text;
use crate::{Figure, caption, inset};

pub(crate) const PLOT: (f64, f64) = (400.0, 310.0);
/// Height of a plane with numbers, and the room for letters and formulas at the right of it.
pub(crate) const HEIGHT: f64 = 310.0;
pub(crate) const ROOM: f64 = 46.0;
pub(crate) const TOP: f64 = 46.0;
/// The name of an axis stands above the letters at the ends of lines.
const HIGHER: f64 = 18.0;
pub(crate) const LETTER: f64 = 14.5;
pub(crate) const DROP: Pen = Pen { colour: FAINT, width: 0.7, dashes: "3.2 2.6" };

/// A shaded area as the window shows it.
struct Area {
    mode: Mode,
    pieces: Vec<Piece>,
    name: String,
    /// Number of the unresolved part, counted from zero.
    unresolved: Option<usize>,
}

/// The way of hatching: parts that touch differ in it.
fn way(which: usize) -> Fall {
    if which % 2 == 1 { Fall::Falling } else { Fall::Rising }
}

/// The drawing under way.
pub(crate) struct Draft<'a> {
    given: &'a Drawing<'a>,
    pub canvas: Canvas,
    areas: Vec<Area>,
    pub right: Vec<Tab>,
    pub above: Vec<Tab>,
    /// Names and formulas that go to the caption for want of room.
    legend: Vec<String>,
    /// Design points that carry a number in place of their name.
    numbered: Vec<usize>,
}

impl Drawing<'_> {
    /// Draws it.
    pub(crate) fn figure(&self) -> Figure {
        let mu_tabs = self.mu_marks();
        let axes = if self.numbered {
            plane(&self.window, TOP)
        } else {
            axes_at(margins::mu_width(mu_tabs.iter()).max(34.0) + 6.0, &self.window)
        };
        let mut draft = Draft::new(self, Canvas::new(axes));
        draft.tints();
        draft.drop_lines();
        draft.traces();
        let scene = &mut draft.canvas.scene;
        if self.numbered {
            axes.border(scene, FRAME);
        } else {
            axes.arrows(scene, &Names::PLANE);
            margins::beside_mu_axis(scene, &axes, mu_tabs);
        }
        draft.marks();
        draft.finish()
    }

    fn areas(&self) -> Vec<Area> {
        let k_e = self.diagram.chart().k_e();
        let area = |mode: Mode, strips: &[Strip], name: &str, unresolved| Area {
            mode,
            pieces: clip_strips(strips, &self.window),
            name: name.into(),
            unresolved,
        };
        let mut areas = Vec::new();
        for &part in self.sheet.shaded {
            let (mode, from, to) = match part {
                Part::Whole(mode) => (mode, 0.0, f64::INFINITY),
                Part::LeftOfE(mode) => (mode, 0.0, k_e),
                Part::RightOfE(mode) => (mode, k_e, f64::INFINITY),
                Part::Unresolved(mode) => {
                    let (_, parts) = self.diagram.before_resolution(mode);
                    for (i, part) in parts.iter().enumerate() {
                        let name = format!("${}$", part.name.replace("''", "″").replace('\'', "′"));
                        areas.push(area(mode, &part.strips, &name, Some(i)));
                    }
                    continue;
                }
            };
            let name = match self.sheet.naming {
                Naming::Symbols => symbol(mode),
                Naming::Words(words) => words,
            };
            let strips: Vec<Strip> = self.diagram.region(mode).map_or(Vec::new(), |region| {
                let cut =
                    |strip: &Strip| Strip { from: strip.from.max(from), to: strip.to.min(to), ..*strip };
                region.strips.iter().map(cut).collect()
            });
            areas.push(area(mode, &strips, name, None));
        }
        areas.retain(|area| !area.pieces.is_empty());
        areas
    }

    /// The named values beside the μ axis; fractions take a solidus where bars would pile up.
    fn mu_marks(&self) -> Vec<Tab> {
        let chart = self.diagram.chart();
        let marks = self.sheet.mu_marks.iter().filter_map(|mark| {
            let mu = mark.mu(chart).filter(|mu| (self.window.mu_min..self.window.mu_max).contains(mu))?;
            Some((axes_at(0.0, &self.window).y(mu), equation(mark.markup(chart))))
        });
        let marks: Vec<(f64, String)> = marks.collect();
        let tabs = |set: fn(&str, f64) -> Text| -> Vec<Tab> {
            marks.iter().map(|(at, markup)| Tab { at: *at, text: set(markup, FORMULA) }).collect()
        };
        let built = tabs(Text::new);
        if margins::is_crowded(&built) { tabs(Text::inline) } else { built }
    }

    /// The named points of the sheet, with their coordinates.
    pub(crate) fn named(&self) -> impl Iterator<Item = NamedPoint> {
        self.sheet.points.iter().filter_map(|&name| self.diagram.chart().point(name))
    }

    /// The lines that are drawn: with another diagram in dashes one that bounds nothing here would look like one of it.
    fn traces(&self) -> impl Iterator<Item = &'static Trace> {
        let alone = self.pinned.is_none();
        self.sheet.traces.iter().filter(move |trace| alone || trace.style != Style::Dashed)
    }

    fn stretch(&self, trace: &Trace) -> Vec<Arc> {
        stretch(self.diagram, trace, &self.window)
    }
}

/// The parts of a line of a diagram that a window shows; none of an upright one.
pub(crate) fn stretch(diagram: &Diagram, trace: &Trace, window: &View) -> Vec<Arc> {
    let chart = diagram.chart();
    let curve = trace.line.curve(chart);
    curve.map_or(Vec::new(), |curve| clip(curve, trace.from.k(chart), trace.to.k(chart), window))
}

/// Place of a k–μ plane with numbers, from `top` on.
pub(crate) fn plane(window: &View, top: f64) -> Axes {
    let (across, up) = window.axes();
    Axes::beside_numbers([across, up], (LEFT, COLUMN - ROOM), top, HEIGHT)
}

/// Numbers and names of a k–μ plane, with what else stands above or without; gives the y below and the x right of what stands above.
pub(crate) fn named_plane(scene: &mut Scene, axes: &Axes, is_labelled: bool) -> (f64, f64) {
    let [across, up] = ["Force over weight, $k$", "Friction, $μ$"].map(|words| Text::inline(words, NUMBER));
    axes.framed(scene, &axes.ticks());
    axes.name_above(scene, &up, LEFT, if is_labelled { HIGHER } else { 0.0 });
    (axes.name_below(scene, &across), LEFT + up.width)
}

/// A plot with its left edge at `left`.
fn axes_at(left: f64, window: &View) -> Axes {
    Axes::of(Rect { x0: left, y0: TOP, x1: left + PLOT.0, y1: TOP + PLOT.1 }, window)
}

/// `name = value` in markup; the value may be empty.
fn equation((name, value): (&str, &str)) -> String {
    if value.is_empty() { format!("${name}$") } else { format!("${name} = {value}$") }
}

impl<'a> Draft<'a> {
    pub(crate) fn new(given: &'a Drawing<'a>, canvas: Canvas) -> Draft<'a> {
        Draft {
            given,
            canvas,
            areas: given.areas(),
            right: Vec::new(),
            above: Vec::new(),
            legend: Vec::new(),
            numbered: Vec::new(),
        }
    }

    pub(crate) fn tints(&mut self) {
        let axes = self.canvas.board.axes;
        for area in &self.areas {
            self.canvas.region(&area.pieces, Verdict::Begins(area.mode));
        }
        for area in &self.areas {
            if let Some(which) = area.unresolved {
                let lines = hatch(&axes, &area.pieces, 9.0, way(which));
                self.canvas.scene.stroke(&lines, Pen::solid(INK, 0.45));
            }
        }
        for (i, part) in self.given.hatched.iter().enumerate() {
            let pieces = clip_strips(&part.strips, &axes.view());
            let lines = hatch(&axes, &pieces, 9.0, way(i));
            self.canvas.scene.stroke(&lines, Pen::solid(FAINT, 0.4));
            self.canvas.hatched.push((pieces, tint(part.resolved_as)));
        }
    }

    pub(crate) fn drop_lines(&mut self) {
        let axes = self.canvas.board.axes;
        for point in self.given.named().filter(|point| axes.shows(point.k, point.mu)) {
            let (x, y) = axes.at(point.k, point.mu);
            if self.given.sheet.k_marks.contains(&point.name) && point.mu > 0.0 {
                self.canvas.scene.line((x, y), (x, axes.area.y1), DROP);
                self.canvas.board.verticals.push((x, y, axes.area.y1));
            }
            if self.given.sheet.mu_marks.contains(&Mark::Of(point.name)) && point.k > 0.0 {
                self.canvas.scene.line((axes.area.x0, y), (x, y), DROP);
                self.canvas.board.arcs.push(Arc { curve: level(point.mu), from: 0.0, to: point.k });
            }
        }
    }

    pub(crate) fn traces(&mut self) {
        let axes = self.canvas.board.axes;
        for trace in self.given.traces() {
            let pen = match trace.style {
                Style::Solid => Pen::solid(INK, 1.5),
                Style::Thin => Pen::solid(INK, 0.7),
                Style::Dashed => Pen { colour: INK, width: 0.9, dashes: "5 3.4" },
                Style::Dotted => Pen { colour: INK, width: 1.5, dashes: "0 3.6" },
            };
            if let Some((k, from)) = trace.line.vertical(self.given.diagram.chart()) {
                let from = from.max(axes.up.from);
                if axes.shows(k, from) {
                    let (x, y) = axes.at(k, from);
                    self.canvas.scene.line((x, y), (x, axes.area.y0), pen);
                    self.canvas.board.verticals.push((x, axes.area.y0, y));
                }
                continue;
            }
            self.canvas.arcs(self.given.stretch(trace), pen);
        }
    }

    /// Draws the marks over the lines: letters, points, the lens, names, notes and formulas, the later where the
    /// earlier leave room.
    pub(crate) fn marks(&mut self) {
        if let Some(pinned) = self.given.pinned {
            pinned.draw(&mut self.canvas);
        }
        self.canvas.cloud(self.given.cloud);
        self.letters();
        self.numbered = self.canvas.design_points(self.given.points);
        self.lens();
        self.names();
        self.notes();
        self.formulas();
    }

    /// Dots and letters of named points, letters at the ends of lines.
    fn letters(&mut self) {
        let axes = self.canvas.board.axes;
        let shown: Vec<_> = self.given.named().filter(|point| axes.shows(point.k, point.mu)).collect();
        for point in &shown {
            self.canvas.dot(axes.at(point.k, point.mu), 2.6, 6.5);
        }
        for point in &shown {
            let text = Text::new(&letter_markup(point.name), LETTER);
            self.canvas.letter(&text, axes.at(point.k, point.mu));
        }
        for &(letter, line) in self.given.sheet.ends {
            let text = Text::new(&format!("${letter}$"), LETTER);
            self.at_edge(line, text);
        }
        let has_asymptote = self.given.sheet.mu_marks.contains(&Mark::Asymptote);
        if self.given.numbered && self.given.pinned.is_none() && has_asymptote {
            let text = Text::new(Line::Asymptote.formula(self.given.diagram.chart()), FORMULA);
            self.at_edge(Line::Asymptote, text);
        }
    }

    /// Puts a label where a line leaves the window; gives it back if the line ends inside.
    fn at_edge(&mut self, line: Line, text: Text) -> Option<Text> {
        let Rect { x1, y0, .. } = self.canvas.board.axes.area;
        let Some((x, y)) = self.exit(line) else { return Some(text) };
        if x > x1 - 0.5 {
            self.right.push(Tab { at: y, text });
        } else if y < y0 + 0.5 {
            self.above.push(Tab { at: x, text });
        } else {
            return Some(text);
        }
        None
    }

    /// End of a drawn line on the page.
    fn exit(&self, line: Line) -> Option<(f64, f64)> {
        let axes = self.canvas.board.axes;
        if let Some((k, from)) = line.vertical(self.given.diagram.chart()) {
            return axes.shows(k, from.max(axes.up.from)).then(|| (axes.x(k), axes.area.y0));
        }
        let traces = self.given.traces().filter(|trace| trace.line == line);
        let arc = traces.flat_map(|trace| self.given.stretch(trace)).max_by(|a, b| a.to.total_cmp(&b.to))?;
        Some(axes.at(arc.to, arc.curve.at(arc.to)))
    }

    fn lens(&mut self) {
        if self.given.sheet.lens {
            inset::draw(&mut self.canvas.scene, &mut self.canvas.board, self.given.diagram);
        }
    }

    fn names(&mut self) {
        for area in std::mem::take(&mut self.areas) {
            let (largest, patch) = if area.unresolved.is_some() { (13.5, Some(PAPER)) } else { (15.5, None) };
            self.canvas.name(&area.pieces, &area.name, largest, patch);
        }
    }

    fn notes(&mut self) {
        let chart = self.given.diagram.chart();
        for note in self.given.sheet.notes {
            let (Some(lower), upper) = (note.lower.curve(chart), note.upper.curve(chart)) else { continue };
            let strip = Strip { from: note.from.k(chart), to: f64::INFINITY, lower, upper };
            let text = Text::new(note.markup, FORMULA);
            let pieces = clip_strips(&[strip], &self.given.window);
            let place = self.canvas.board.inside(&pieces, text.width, text.height());
            self.canvas.place(&text, place, INK);
        }
    }

    fn formulas(&mut self) {
        for &line in self.given.sheet.formulas {
            let traces = self.given.traces().filter(|trace| trace.line == line);
            let mut arcs: Vec<_> = traces.flat_map(|trace| self.given.stretch(trace)).collect();
            standfast::order::by_number(&mut arcs, |one| -(one.to - one.from));
            if !arcs.is_empty() {
                self.formula(line, &arcs);
            }
        }
    }

    /// A line's equation: beside it, near it with a leader, at its end, or, for want of room, in the caption.
    fn formula(&mut self, line: Line, arcs: &[Arc]) {
        let chart = self.given.diagram.chart();
        let markup = line.formula(chart);
        let text = Text::new(markup, FORMULA);
        let axes = self.canvas.board.axes;
        let longest = &arcs[0];
        let places = [0.5, 0.7, 0.3].map(|share| {
            let k = longest.from + share * (longest.to - longest.from);
            axes.at(k, longest.curve.at(k))
        });
        if self.canvas.beside_line(arcs, &text) || self.canvas.joined(places, &text) {
            return;
        }
        let Some(short) = line.short() else {
            // Letters stand at the ends of lines, and the caption may speak of the line by its letters.
            let is_lettered = self.given.sheet.ends.iter().any(|&(_, lettered)| lettered == line);
            if is_lettered || self.at_edge(line, text).is_some() {
                self.legend.push(format!("{}: {markup}", line.name(chart)));
            }
            return;
        };
        let text = Text::new(short, FORMULA);
        if !self.canvas.beside_line(arcs, &text) {
            self.at_edge(line, text);
        }
        self.legend.push(markup.into());
    }

    /// The named values under the k axis; their formulas in the caption for want of room. Returns the y below.
    fn k_marks(&mut self) -> f64 {
        let axes = self.canvas.board.axes;
        let chart = self.given.diagram.chart();
        let marks = self.given.sheet.k_marks.iter().filter_map(|&name| {
            let k = chart.point(name)?.k;
            (axes.across.from..=axes.across.to).contains(&k).then(|| (axes.x(k), k_markup(name, chart)))
        });
        let marks: Vec<_> = marks.collect();
        let tabs = |full: bool| {
            let text = |&(name, value)| Text::new(&equation((name, if full { value } else { "" })), FORMULA);
            marks.iter().map(|(at, markup)| Tab { at: *at, text: text(markup) }).collect()
        };
        let (bottom, full) = margins::under_k_axis(&mut self.canvas.scene, &axes, tabs(true), tabs(false));
        if !full {
            self.legend.extend(marks.iter().map(|(_, markup)| equation(*markup)));
        }
        bottom
    }

    /// Edges, caption, and the document.
    fn finish(mut self) -> Figure {
        let axes = self.canvas.board.axes;
        self.legend.extend(caption::hatching(self.given.hatched));
        let scene = &mut self.canvas.scene;
        let (bottom, above) = if self.given.numbered {
            named_plane(scene, &axes, !self.above.is_empty())
        } else {
            (self.k_marks(), axes.area.x0)
        };
        let right = std::mem::take(&mut self.right);
        let right = margins::right_of(&mut self.canvas.scene, &axes, right).unwrap_or(axes.area.x1);
        margins::above(&mut self.canvas.scene, &axes, std::mem::take(&mut self.above), above);

        let width = (right + 12.0).max(axes.area.x1 + ROOM);
        let mut words = vec![Text::verbatim(self.given.heading, SIZE)];
        words.extend(margins::words(self.given.caption, SIZE));
        let details = caption::details(self.given, &self.legend, &self.numbered);
        let edges = (16.0, width - 16.0);
        let words = Words { title: caption::title(self.given), ..Words::new(words, details) };
        let description = caption::description(self.given, &words.caption);
        words.figure(self.canvas.scene, edges, bottom + 16.0, 16.0, &description)
    }
}
