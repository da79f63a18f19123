//! Probabilities along a quantity, as lines with the bands of their intervals.

use standfast::Mode;

use super::{Chance, LEFT, LOOK, finished, plot};
use crate::Figure;
use crate::axes::Axes;
use crate::below::Key;
use crate::caption::SMALL;
use crate::labels::spread;
use crate::motion::SpectrumAxis;
use crate::palette::{BAND, BAND_OF_MODE, FAINT, INK, MARK, texture, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture::Texture;

const PLOT: (f64, f64) = (470.0, 300.0);
/// Above the axes: the name of an axis, and what marks are.
const TOP: f64 = 30.0;
const MARKS: f64 = 22.0;

/// Look of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LineLook {
    /// In ink, with its band and, if there are few, its points.
    Answer,
    /// In the colour of a mode.
    Mode(Mode),
    /// Dashed: something that goes through the answer.
    Fit,
}

/// A line.
#[derive(Debug, Clone, PartialEq)]
pub struct ChanceLine<'a> {
    /// Name of the line, in markup, for the key.
    pub name: &'a str,
    /// Look of the line.
    pub look: LineLook,
    /// Its points, rising to the right.
    pub points: Vec<(f64, Chance)>,
}

/// A value of the quantity to the right that is marked by an upright line.
#[derive(Debug, Clone, PartialEq)]
pub struct ChanceMark<'a> {
    /// The value.
    pub at: f64,
    /// Quantity, in markup.
    pub words: &'a str,
}

/// Lines of probabilities along a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct ChanceLines<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The probability, upwards.
    pub up: SpectrumAxis<'a>,
    /// The lines, the first on top.
    pub lines: &'a [ChanceLine<'a>],
    /// Values that are marked.
    pub marks: &'a [ChanceMark<'a>],
}

/// So few points are dots.
const FEW: usize = 40;

/// Draws lines of probabilities.
pub fn chance_lines(chart: &ChanceLines<'_>) -> Figure {
    let mut scene = Scene::default();
    let top = if chart.marks.is_empty() { TOP } else { TOP + MARKS };
    let plot = plot([&chart.across, &chart.up], (LEFT, top), PLOT);
    let axes = plot.axes;
    axes.grid(&mut scene, &plot.ticks);
    for line in chart.lines.iter().rev() {
        band(&mut scene, &axes, line);
    }
    for line in chart.lines.iter().rev() {
        stroke(&mut scene, &axes, line);
    }
    marks(&mut scene, &axes, chart.marks);
    plot.draw(&mut scene, LOOK, 36.0, (LEFT, TOP - 12.0));
    let right = axes.area.x1 + 26.0;
    let below = swatches(&mut scene, chart.lines, (LEFT, right), axes.area.y1 + 50.0);
    finished(scene, (chart.title, chart.caption), (right, below + 8.0), &plot.description())
}

fn pens(look: LineLook) -> Vec<Pen> {
    match look {
        LineLook::Answer => vec![Pen::solid(INK, 1.6)],
        // A tint on paper is seen by its rim.
        LineLook::Mode(mode) => {
            // Its mirror image has the same tint.
            let dashes = if texture(mode) == Texture::Plain { "" } else { "9 4" };
            [(FAINT, 4.0), (tint(mode), 2.8)].map(|(colour, width)| Pen { colour, width, dashes }).to_vec()
        }
        LineLook::Fit => vec![Pen { colour: MARK, width: 1.4, dashes: "6 3.5" }],
    }
}

/// Points of a line within the axes: it stops at the edges.
fn seen(axes: &Axes, points: &[(f64, Chance)]) -> Vec<(f64, f64)> {
    let within = points.iter().filter(|(x, p)| axes.across.shows(*x) && axes.up.shows(p.value));
    within.map(|(x, p)| axes.held(*x, p.value)).collect()
}

fn stroke(scene: &mut Scene, axes: &Axes, line: &ChanceLine<'_>) {
    let places = seen(axes, &line.points);
    let path = Path::through(&places);
    pens(line.look).into_iter().for_each(|pen| scene.stroke(&path, pen));
    if line.look == LineLook::Answer && places.len() <= FEW {
        places.iter().for_each(|place| scene.dot(*place, 2.4, INK, None));
    }
}

fn band(scene: &mut Scene, axes: &Axes, line: &ChanceLine<'_>) {
    let points = || line.points.iter().filter(|(x, p)| axes.across.shows(*x) && p.high > 0.0);
    if line.look == LineLook::Fit || points().all(|(_, p)| p.high - p.low <= 1e-6 * p.high) {
        return;
    }
    let upper = points().map(|(x, p)| axes.held(*x, p.high));
    let lower = points().map(|(x, p)| axes.held(*x, p.low));
    let mut path = Path::through(&upper.chain(lower.rev()).collect::<Vec<_>>());
    path.close();
    scene.fill(&path, if line.look == LineLook::Answer { BAND } else { BAND_OF_MODE });
}

/// Upright lines, and what they are above the axes.
fn marks(scene: &mut Scene, axes: &Axes, marks: &[ChanceMark<'_>]) {
    let mut shown: Vec<(f64, Text)> = marks
        .iter()
        .filter(|mark| axes.across.shows(mark.at))
        .map(|mark| (axes.x(mark.at), Text::inline(mark.words, SMALL)))
        .collect();
    shown.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Rect { x0, x1, y0, y1 } = axes.area;
    for (x, _) in &shown {
        scene.line((*x, y0 - 4.0), (*x, y1), Pen { colour: MARK, width: 0.9, dashes: "3 2.6" });
    }
    let wanted: Vec<(f64, f64)> = shown.iter().map(|(x, text)| (*x, text.width)).collect();
    let Some(centres) = spread(&wanted, x0 - 10.0, x1 + 20.0, 12.0) else { return };
    for ((x, text), centre) in shown.iter().zip(centres) {
        if (centre - x).abs() > 3.0 {
            scene.line((*x, y0 - 4.0), (centre, y0 - 9.0), Pen::solid(FAINT, 0.6));
        }
        scene.text(text, centre - text.width / 2.0, y0 - 12.0, INK);
    }
}

/// The key: a stretch of each line with its name; returns the y below.
fn swatches(scene: &mut Scene, lines: &[ChanceLine<'_>], edges: (f64, f64), top: f64) -> f64 {
    let mut key = Key::new(edges, top);
    for line in lines {
        let words = Text::inline(line.name, SMALL);
        let (x, y) = key.entry(30.0 + words.width, 18.0);
        let has_band =
            line.look == LineLook::Answer && line.points.iter().any(|(_, p)| p.high - p.low > 1e-6 * p.high);
        if has_band {
            scene.fill(&Path::rectangle(&Rect { x0: x, x1: x + 24.0, y0: y + 1.0, y1: y + 12.0 }), BAND);
        }
        for pen in pens(line.look) {
            scene.line((x, y + 6.5), (x + 24.0, y + 6.5), pen);
        }
        scene.text(&words, x + 30.0, y + 10.5, INK);
    }
    key.below()
}
