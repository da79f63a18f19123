//! Probabilities of modes as points with their intervals, on an axis of equal factors.

use standfast::{Mode, Verdict};

use super::{Chance, finished};
use crate::Figure;
use crate::axes::{Axes, Axis, FRAME, LEFT, NUMBER, PAGE, Tick};
use crate::caption::{SIZE, SMALL};
use crate::number::{digits, significant};
use crate::palette::{BEHIND, FAINT, INK, PAPER, symbol};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const TOP: f64 = 14.0;
const HEAD: f64 = 24.0;
const ROW: f64 = 38.0;
/// Height of the line of a row, and half the size of its point.
const TALL: f64 = 14.0;
const RADIUS: f64 = 5.5;
/// Right of the plot: a number, and its interval below it.
const VALUES: f64 = 132.0;
/// The widest range of an axis.
const LEAST: f64 = 1e-12;

/// A probability with what it is of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceRow<'a> {
    /// The mode, which gives symbol, words and colour.
    pub mode: Option<Mode>,
    /// Words for the event where it is not a mode; not markup.
    pub words: &'a str,
    /// The probability; 0 with an interval says that it was never met.
    pub chance: Chance,
}

/// Rows under one heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceGroup<'a> {
    /// The heading; not markup.
    pub heading: &'a str,
    /// The rows, from above.
    pub rows: &'a [ChanceRow<'a>],
}

/// Probabilities in rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceRows<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The groups, from above.
    pub groups: &'a [ChanceGroup<'a>],
}

/// Draws probabilities as points with whiskers on a logarithmic axis. They have places and no lengths: the axis begins anywhere.
pub fn chance_rows(chart: &ChanceRows<'_>) -> Figure {
    let mut scene = Scene::default();
    let rows = || chart.groups.iter().flat_map(|group| group.rows);
    let least = rows()
        .flat_map(|row| [row.chance.value, row.chance.low, row.chance.high])
        .filter(|p| *p > 0.0)
        .fold(0.1, f64::min);
    let from = 10f64.powf((0.5 * least.max(LEAST)).log10().floor());
    let (x0, x1) = (LEFT + 8.0, PAGE - VALUES);
    let heads = chart.groups.len() as f64 * HEAD;
    let bottom = TOP + heads + ROW * rows().count() as f64 + 4.0;
    let across = Axis { from, to: 1.0, logarithmic: true };
    let axes = Axes::over(Rect { x0, x1, y0: TOP, y1: bottom }, across);
    let ticks = [across.ticks(x1 - x0, false), Vec::new()];
    let mut y = TOP;
    for group in chart.groups {
        let heading = Text::verbatim(group.heading, SIZE);
        scene.text(&heading, LEFT, y + 12.0, INK);
        y += HEAD;
        for row in group.rows {
            draw(&mut scene, row, &axes, &ticks, y);
            y += ROW;
        }
    }
    scene.line((x0, bottom), (x1, bottom), FRAME);
    axes.below(&mut scene, &ticks[0]);
    axes.name_below(&mut scene, &Text::new("Probability", NUMBER));
    let description = "Probabilities as points with their intervals on a logarithmic axis.";
    finished(scene, (chart.title, chart.caption), (PAGE, bottom + 50.0), description)
}

/// The words of a row, and below them its line with the point.
fn draw(scene: &mut Scene, row: &ChanceRow<'_>, axes: &Axes, ticks: &[Vec<Tick>; 2], y: f64) {
    let Rect { x0, x1, .. } = axes.area;
    let words = Text::verbatim(&row.words.replace('\'', "′"), SMALL);
    let mut x = x0 + 5.0;
    if let Some(mode) = row.mode {
        let name = Text::new(symbol(mode), SMALL);
        scene.text(&name, x, y + 11.0, INK);
        x += name.width + 7.0;
    }
    scene.text(&words, x, y + 11.0, INK);
    let line = Rect { y0: y + 16.0, y1: y + 16.0 + TALL, ..axes.area };
    // The grid runs through the line alone, and not through words.
    Axes { area: line, ..*axes }.grid(scene, ticks);
    let middle = y + 16.0 + TALL / 2.0;
    scene.line((x0, middle), (x1, middle), Pen::solid(BEHIND, 0.35));
    point(scene, row, axes, middle);
    values(scene, row.chance, (x1 + 12.0, middle));
}

/// The point and its whiskers; of what was never met, an arrow downwards from the bound.
fn point(scene: &mut Scene, row: &ChanceRow<'_>, axes: &Axes, middle: f64) {
    let place = |p: f64| axes.held(p, 0.0).0;
    let Chance { value, low, high } = row.chance;
    let pen = Pen::solid(INK, 1.2);
    if value > 0.0 {
        if place(high) - place(low) > 1.2 {
            scene.line((place(low), middle), (place(high), middle), pen);
            for end in [place(low), place(high)] {
                scene.line((end, middle - 4.5), (end, middle + 4.5), pen);
            }
        }
        let half = RADIUS;
        let square = Rect::around(place(value), middle, 2.0 * half, 2.0 * half);
        match row.mode {
            Some(mode) => scene.area(&square.corners(), Verdict::Begins(mode)),
            None => scene.fill(&Path::rectangle(&square), PAPER),
        }
        scene.stroke(&Path::rectangle(&square), Pen::solid(INK, 1.1));
    } else if high > 0.0 {
        // Never met: somewhere below.
        let end = place(high);
        scene.line((end, middle - 5.0), (end, middle + 5.0), pen);
        scene.arrow((end, middle), (axes.area.x0 + 2.0, middle), Pen::solid(FAINT, 1.0));
    }
}

/// The number, and its interval below it.
fn values(scene: &mut Scene, Chance { value, low, high }: Chance, (x, middle): (f64, f64)) {
    let said = if value > 0.0 || high <= 0.0 {
        Text::new(&format!("${}$", significant(value, 4)), NUMBER)
    } else {
        Text::new(&format!("below ${}$", digits(high)), NUMBER)
    };
    scene.text(&said, x, middle + 4.0, INK);
    if value > 0.0 && high - low > 1e-6 * value {
        let text = format!("${}$ … ${}$", significant(low, 4), significant(high, 4));
        scene.text(&Text::new(&text, 10.5), x, middle + 18.0, FAINT);
    }
}
