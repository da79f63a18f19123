//! Probabilities along a quantity, as lines with the bands of their intervals.

use standfast::Mode;

use super::{Chance, finished};
use crate::Figure;
use crate::axes::{Axes, COLUMN, LEFT, Plot};
use crate::below::Key;
use crate::caption::SMALL;
use crate::labels::spread;
use crate::motion::SpectrumAxis;
use crate::palette::{BAND, BAND_OF_MODE, BEHIND, FAINT, INK, MARK, symbol, texture, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture::Texture;

const HEIGHT: f64 = 280.0;
/// Right of the plot: the names of lines, at their ends.
const NAMES: f64 = 118.0;
/// Above the axes: the name of an axis, and what marks are.
const TOP: f64 = 30.0;
pub(crate) const MARKS: f64 = 22.0;

/// Look of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LineLook {
    /// In ink, with its band and, if there are few, its points.
    Answer,
    /// Dots, without line and band: too little to tell what lies between. In ink, or in the colour of a mode.
    Points(Option<Mode>),
    /// In the colour of a mode.
    Mode(Mode),
    /// In grey: something else beside the answer.
    Other,
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
    let higher = if chart.marks.is_empty() { 0.0 } else { MARKS };
    let right = COLUMN - NAMES;
    let plot = Plot::new([&chart.across, &chart.up], (LEFT, right), TOP + higher, HEIGHT);
    let axes = plot.axes;
    axes.grid(&mut scene, &plot.ticks);
    for line in chart.lines.iter().rev() {
        band(&mut scene, &axes, line);
    }
    for line in chart.lines.iter().rev() {
        stroke(&mut scene, &axes, line);
    }
    marks(&mut scene, &axes, chart.marks);
    let below = plot.draw(&mut scene, higher);
    let unnamed = at_ends(&mut scene, &axes, chart.lines);
    let below = swatches(&mut scene, chart.lines, &unnamed, (LEFT, COLUMN - LEFT), below + 12.0);
    finished(scene, (chart.title, chart.caption), (COLUMN, below + 8.0), &plot.description())
}

/// True if two lines lie on each other.
fn coincide(axes: &Axes, one: &ChanceLine<'_>, other: &ChanceLine<'_>) -> bool {
    let (one, other) = (seen(axes, &one.points), seen(axes, &other.points));
    one.len() == other.len()
        && one.iter().zip(&other).all(|(a, b)| (a.0 - b.0).abs() < 0.5 && (a.1 - b.1).abs() < 0.5)
}

/// Names of lines at their right ends, in as many rows of those that lie on each other; gives the lines to be told in the key: ended
/// before, or named by a symbol.
fn at_ends(scene: &mut Scene, axes: &Axes, lines: &[ChanceLine<'_>]) -> Vec<usize> {
    const NEAR: f64 = 3.0;
    let Rect { x1, y0, y1, .. } = axes.area;
    let mut unnamed = Vec::new();
    let mut named: Vec<(f64, Vec<String>)> = Vec::new();
    let mut done = vec![false; lines.len()];
    for (i, line) in lines.iter().enumerate() {
        let end = seen(axes, &line.points).last().copied().filter(|end| end.0 > x1 - 3.0);
        if done[i] {
            continue;
        }
        let same: Vec<usize> = (i..lines.len())
            .filter(|j| *j == i || (end.is_some() && coincide(axes, line, &lines[*j])))
            .collect();
        let fits = |name: &str| Text::inline(name, SMALL).width <= NAMES - LEFT - 12.0;
        // A mode is named by its symbol where its words are too long.
        let short = |line: &ChanceLine<'_>| match line.look {
            _ if fits(line.name) => Some(line.name.to_owned()),
            LineLook::Mode(mode) => Some(symbol(mode).to_owned()),
            _ => None,
        };
        let names: Option<Vec<String>> = same.iter().map(|j| short(&lines[*j])).collect();
        same.iter().for_each(|j| done[*j] = true);
        let is_told = |j: &usize| end.is_none() || !fits(lines[*j].name);
        unnamed.extend(same.iter().copied().filter(is_told));
        if let (Some((_, y)), Some(names)) = (end, names) {
            named.push((y, names));
        }
    }
    standfast::order::by_number(&mut named, |one| one.0);
    // Lines that lie on each other have their names in as many rows.
    let rows: Vec<(f64, &str)> =
        named.iter().flat_map(|(y, names)| names.iter().map(|name| (*y, name.as_str()))).collect();
    let wanted: Vec<(f64, f64)> = rows.iter().map(|(y, _)| (*y, 1.05 * SMALL)).collect();
    let Some(places) = spread(&wanted, y0 - 4.0, y1 + 10.0, 3.0) else {
        return (0..lines.len()).collect();
    };
    for ((at, name), y) in rows.into_iter().zip(places) {
        let moved = (at - y).abs() > NEAR;
        let left = x1 + if moved { 15.0 } else { 6.0 };
        if moved {
            scene.line((x1 + 2.0, at), (left - 2.0, y), Pen::solid(FAINT, 0.6));
        }
        scene.text(&Text::inline(name, SMALL), left, y + 4.0, INK);
    }
    unnamed
}

fn pens(look: LineLook) -> Vec<Pen> {
    match look {
        LineLook::Answer => vec![Pen::solid(INK, 1.6)],
        LineLook::Points(_) => Vec::new(),
        LineLook::Other => vec![Pen::solid(BEHIND, 2.2)],
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
    if let LineLook::Points(mode) = line.look {
        places.iter().for_each(|place| point(scene, *place, mode));
    }
    if line.look == LineLook::Answer && places.len() <= FEW {
        places.iter().for_each(|place| scene.dot(*place, 2.4, INK, None));
    }
}

fn point(scene: &mut Scene, place: (f64, f64), mode: Option<Mode>) {
    match mode {
        None => scene.dot(place, 2.6, INK, None),
        Some(mode) => scene.dot(place, 4.2, tint(mode), Some(Pen::solid(INK, 0.9))),
    }
}

fn band(scene: &mut Scene, axes: &Axes, line: &ChanceLine<'_>) {
    let points = || line.points.iter().filter(|(x, p)| axes.across.shows(*x) && p.high > 0.0);
    if matches!(line.look, LineLook::Fit | LineLook::Points(_))
        || points().all(|(_, p)| p.high - p.low <= 1e-6 * p.high)
    {
        return;
    }
    let upper = points().map(|(x, p)| axes.held(*x, p.high));
    let lower = points().map(|(x, p)| axes.held(*x, p.low));
    let mut path = Path::through(&upper.chain(lower.rev()).collect::<Vec<_>>());
    path.close();
    scene.fill(&path, if line.look == LineLook::Answer { BAND } else { BAND_OF_MODE });
}

/// Upright lines, and what they are above the axes.
pub(crate) fn marks(scene: &mut Scene, axes: &Axes, marks: &[ChanceMark<'_>]) {
    let mut shown: Vec<(f64, Text)> = marks
        .iter()
        .filter(|mark| axes.across.shows(mark.at))
        .map(|mark| (axes.x(mark.at), Text::inline(mark.words, SMALL)))
        .collect();
    standfast::order::by_number(&mut shown, |one| one.0);
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

/// The key: a stretch of each line that has no name at its end, and what the band is; returns the y below.
fn swatches(
    scene: &mut Scene,
    lines: &[ChanceLine<'_>],
    unnamed: &[usize],
    edges: (f64, f64),
    top: f64,
) -> f64 {
    let mut key = Key::new(edges, top);
    for line in unnamed.iter().map(|i| &lines[*i]) {
        let words = match line.look {
            LineLook::Mode(mode) => Text::inline(&format!("{} {}", symbol(mode), line.name), SMALL),
            _ => Text::inline(line.name, SMALL),
        };
        let (x, y) = key.entry(30.0 + words.width, 18.0);
        if let LineLook::Points(mode) = line.look {
            point(scene, (x + 12.0, y + 6.5), mode);
        }
        for pen in pens(line.look) {
            scene.line((x, y + 6.5), (x + 24.0, y + 6.5), pen);
        }
        scene.text(&words, x + 30.0, y + 10.5, INK);
    }
    let has_band = |line: &ChanceLine<'_>| {
        line.look == LineLook::Answer && line.points.iter().any(|(_, p)| p.high - p.low > 1e-6 * p.high)
    };
    if let Some(line) = lines.iter().find(|line| has_band(line)) {
        let paint = |scene: &mut Scene, patch: &Rect| scene.fill(&Path::rectangle(patch), BAND);
        let words = format!("interval of 95 %, {}", line.name);
        key.patch(scene, paint, &[Text::inline(&words, SMALL)]);
    }
    key.below()
}
