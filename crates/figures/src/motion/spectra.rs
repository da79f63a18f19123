//! Spectra of motions: a map of classes over two quantities, and lines over one.

use crate::Figure;
use crate::axes::{Axes, Axis, COLUMN, LEFT, Plot};
use crate::below::{Key, Words};
use crate::caption::SMALL;
use crate::chances::{ChanceMark, MARKS, marks};
use crate::palette::{FAINT, INK, MARK, OVERTURNS, PAPER, PUSH, ROCKING};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture;

const HEIGHT: f64 = 300.0;
const TOP: f64 = 30.0;
/// Right edge of a plot: half of its last number stands beyond.
const RIGHT: f64 = COLUMN - 26.0;
const LINES: [Pen; 3] = [
    Pen::solid(INK, 1.4),
    Pen { colour: PUSH, width: 1.3, dashes: "6 3" },
    Pen { colour: MARK, width: 1.3, dashes: "2 2.4" },
];

/// A quantity along an axis of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumAxis<'a> {
    /// Name of the quantity, in markup, with its unit.
    pub name: &'a str,
    /// At the axis's beginning.
    pub from: f64,
    /// At its end, greater.
    pub to: f64,
    /// True if equal steps are equal factors; then both are above zero.
    pub logarithmic: bool,
}

impl SpectrumAxis<'_> {
    pub(crate) fn axis(&self) -> Axis {
        let SpectrumAxis { from, to, logarithmic, .. } = *self;
        Axis { from, to, logarithmic }
    }
}

/// A map of classes over two quantities.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumMap<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The quantity upwards.
    pub up: SpectrumAxis<'a>,
    /// Outlines of the areas of each class but the first together with those after it, in the quantities of the axes; an outline in
    /// another is that of a hole.
    pub above: &'a [Vec<Vec<(f64, f64)>>],
    /// True for a class that occurs.
    pub occurs: [bool; 7],
    /// Words of each class, in markup: does not rock, four of rotations up to the angle of balance, beyond it, overturns.
    pub classes: [&'a str; 7],
}

/// The class whose area is striped, and the one whose edge is drawn the strongest.
const BACK: usize = 5;
const OVER: usize = 6;

/// Draws a map of classes.
pub fn spectrum_map(map: &SpectrumMap<'_>) -> Figure {
    let mut scene = Scene::default();
    let plot = plot(&map.across, &map.up, TOP);
    let axes = plot.axes;
    scene.fill(&Path::rectangle(&axes.area), ROCKING[0]);
    let areas: Vec<Vec<Vec<(f64, f64)>>> = map
        .above
        .iter()
        .map(|loops| loops.iter().map(|each| each.iter().map(|(x, y)| axes.held(*x, *y)).collect()).collect())
        .collect();
    // Each class lies on those before it, so that no paper is seen between two.
    for (class, loops) in areas.iter().enumerate().map(|(i, loops)| (i + 1, loops)) {
        scene.fill(&outlines(loops), ROCKING[class]);
        if class == BACK {
            texture::stripes(&mut scene, &loops.iter().map(Vec::as_slice).collect::<Vec<_>>());
        }
    }
    for (class, loops) in areas.iter().enumerate().map(|(i, loops)| (i + 1, loops)) {
        let pen = if class == OVER { Pen::solid(INK, 1.2) } else { Pen::solid(FAINT, 0.6) };
        scene.stroke(&within(&axes.area, loops), pen);
    }
    let mut key = Key::new((LEFT, COLUMN - LEFT), plot.draw(&mut scene, 0.0) + 12.0);
    for (class, words) in map.classes.iter().enumerate().filter(|(class, _)| map.occurs[*class]) {
        let paint = |scene: &mut Scene, patch: &Rect| {
            scene.fill(&Path::rectangle(patch), ROCKING[class]);
            if class == BACK {
                texture::stripes(scene, &[&patch.corners()]);
            }
        };
        key.patch(&mut scene, paint, &[Text::inline(words, SMALL)]);
    }
    finished(scene, &plot, key.below(), (map.title, map.caption))
}

/// Outlines as one path.
fn outlines(loops: &[Vec<(f64, f64)>]) -> Path {
    let mut path = Path::default();
    for each in loops {
        for (i, &(x, y)) in each.iter().enumerate() {
            if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path.close();
    }
    path
}

/// Outlines without what runs along the edges of the plot.
fn within(area: &Rect, loops: &[Vec<(f64, f64)>]) -> Path {
    let mut path = Path::default();
    for each in loops {
        let mut last = None;
        for (one, two) in each.iter().zip(each.iter().cycle().skip(1)) {
            let along = (one.0 == two.0 && (one.0 == area.x0 || one.0 == area.x1))
                || (one.1 == two.1 && (one.1 == area.y0 || one.1 == area.y1));
            if along {
                continue;
            }
            if last != Some(one) {
                path.move_to(one.0, one.1);
            }
            path.line_to(two.0, two.1);
            last = Some(two);
        }
    }
    path
}

/// Lines over a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumLines<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The quantity upwards.
    pub up: SpectrumAxis<'a>,
    /// At most three lines: their words in markup and their points. What is outside of the axes is left out; a point alone is a dot, and
    /// an end before a point without bound is a ring.
    pub lines: &'a [(&'a str, Vec<(f64, f64)>)],
    /// Stretches of the quantity to the right that are shaded, with their words.
    pub shaded: (&'a [[f64; 2]], &'a str),
    /// Values that are marked.
    pub marks: &'a [ChanceMark<'a>],
}

/// Draws lines over a quantity.
pub fn spectrum_lines(chart: &SpectrumLines<'_>) -> Figure {
    let mut scene = Scene::default();
    let higher = if chart.marks.is_empty() { 0.0 } else { MARKS };
    let plot = plot(&chart.across, &chart.up, TOP + higher);
    let (axes, area) = (plot.axes, plot.axes.area);
    for [from, to] in chart.shaded.0 {
        let [x0, x1] = [from, to].map(|value| axes.x(axes.across.held(*value)));
        // A stretch too narrow to be seen is seen all the same.
        let x1 = x1.max(x0 + 0.8);
        scene.fill(&Path::rectangle(&Rect { x0, x1, ..area }), OVERTURNS);
    }
    axes.grid(&mut scene, &plot.ticks);
    for ((_, points), pen) in chart.lines.iter().zip(LINES) {
        line(&mut scene, &axes, points, pen);
    }
    marks(&mut scene, &axes, chart.marks);
    let mut key = Key::new((LEFT, COLUMN - LEFT), plot.draw(&mut scene, higher) + 12.0);
    let mut swatch = |scene: &mut Scene, words: &str, draw: &dyn Fn(&mut Scene, f64, f64)| {
        let words = Text::inline(words, SMALL);
        let (x, y) = key.entry(28.0 + words.width, 16.0);
        draw(scene, x, y);
        scene.text(&words, x + 28.0, y + 10.5, INK);
    };
    for ((words, points), pen) in chart.lines.iter().zip(LINES) {
        let line = |scene: &mut Scene, x: f64, y: f64| scene.line((x, y + 6.0), (x + 24.0, y + 6.0), pen);
        swatch(&mut scene, words, &line);
        if points.iter().any(|(_, y)| y.is_infinite()) {
            let ring = |scene: &mut Scene, x: f64, y: f64| ring(scene, (x + 12.0, y + 6.0), pen);
            swatch(&mut scene, "last before it does not", &ring);
        }
    }
    if !chart.shaded.0.is_empty() {
        let patch = |scene: &mut Scene, x: f64, y: f64| {
            scene.fill(&Path::rectangle(&Rect { x0: x, y0: y, x1: x + 24.0, y1: y + 12.0 }), OVERTURNS);
        };
        swatch(&mut scene, chart.shaded.1, &patch);
    }
    finished(scene, &plot, key.below(), (chart.title, chart.caption))
}

/// A line through points, as far as the axes show them; a dot where it is a point alone, and rings where it ends before one without bound.
fn line(scene: &mut Scene, axes: &Axes, points: &[(f64, f64)], pen: Pen) {
    let seen = |(x, y): (f64, f64)| axes.across.shows(x) && axes.up.shows(y);
    let at = |i: usize| axes.at(points[i].0, points[i].1);
    let mut path = Path::default();
    let mut rings = Vec::new();
    let places: Vec<usize> = (0..points.len()).collect();
    for run in places.chunk_by(|i, j| seen(points[*i]) && seen(points[*j])) {
        let (first, last) = (run[0], run[run.len() - 1]);
        if !seen(points[first]) {
            continue;
        }
        for &i in run {
            if i == first { path.move_to(at(i).0, at(i).1) } else { path.line_to(at(i).0, at(i).1) }
        }
        let is_over =
            |i: Option<usize>| i.and_then(|i| points.get(i)).is_some_and(|point| point.1.is_infinite());
        rings.extend(is_over(first.checked_sub(1)).then_some(first));
        rings.extend(is_over(Some(last + 1)).then_some(last));
        if first == last {
            scene.dot(at(first), 1.6, pen.colour, None);
        }
    }
    scene.stroke(&path, pen);
    rings.dedup();
    rings.into_iter().for_each(|i| ring(scene, at(i), pen));
}

fn ring(scene: &mut Scene, place: (f64, f64), pen: Pen) {
    scene.dot(place, 3.0, PAPER, Some(Pen::solid(pen.colour, 1.2)));
}

/// The plot on the page.
fn plot(across: &SpectrumAxis<'_>, up: &SpectrumAxis<'_>, top: f64) -> Plot {
    Plot::new([across, up], (LEFT, RIGHT), top, HEIGHT)
}

/// The figure with its key and words below.
fn finished(scene: Scene, plot: &Plot, below: f64, (title, caption): (&str, &str)) -> Figure {
    let description = format!("{} {caption}", plot.description());
    Words::verbatim(title, caption).figure(scene, (LEFT, COLUMN - LEFT), below + 8.0, LEFT, &description)
}
