//! Bars of probabilities with their intervals, on an axis of equal factors.

use standfast::Mode;

use super::{Chance, LEFT, LOOK, across_ticks, finished};
use crate::Figure;
use crate::axes::{Axes, Axis, NUMBER};
use crate::caption::{SIZE, SMALL};
use crate::number::{digits, significant};
use crate::palette::{BEHIND, FAINT, INK, symbol, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const WIDE: f64 = 430.0;
const ROW: f64 = 38.0;
const THICK: f64 = 13.0;
/// Right of the plot: a number, and its interval below it.
const VALUES: f64 = 132.0;
/// The widest range of an axis.
const LEAST: f64 = 1e-12;

/// A probability with what it is of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceBar<'a> {
    /// The mode, which gives symbol, words and colour.
    pub mode: Option<Mode>,
    /// Words for the event where it is no mode; not markup.
    pub words: &'a str,
    /// The probability; 0 with an interval says that it was never met.
    pub chance: Chance,
}

/// Bars under one heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceGroup<'a> {
    /// The heading; not markup.
    pub heading: &'a str,
    /// The bars, from above.
    pub bars: &'a [ChanceBar<'a>],
}

/// Bars of probabilities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceBars<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The groups, from above.
    pub groups: &'a [ChanceGroup<'a>],
}

/// Draws bars of probabilities: each from the left end of a logarithmic axis to its value, with its interval.
pub fn chance_bars(chart: &ChanceBars<'_>) -> Figure {
    let mut scene = Scene::default();
    let bars = || chart.groups.iter().flat_map(|group| group.bars);
    let least = bars()
        .flat_map(|bar| [bar.chance.value, bar.chance.low, bar.chance.high])
        .filter(|p| *p > 0.0)
        .fold(0.1, f64::min);
    // A bar has a length, however small its probability is beside the others.
    let from = 10f64.powf((0.5 * least.max(LEAST)).log10().floor());
    let (x0, x1) = (LEFT + 8.0, LEFT + 8.0 + WIDE);
    let heads = chart.groups.len() as f64 * 24.0;
    let bottom = 14.0 + heads + ROW * bars().count() as f64 + 4.0;
    let across = Axis { from, to: 1.0, logarithmic: true };
    let axes = Axes::over(Rect { x0, x1, y0: 14.0, y1: bottom }, across);
    let ticks = [across_ticks(&across, WIDE), Vec::new()];
    axes.grid(&mut scene, &ticks);
    let mut y = 14.0;
    for group in chart.groups {
        let heading = Text::verbatim(group.heading, SIZE);
        // The grid does not run through words.
        let behind = Rect { x0: x0 - 4.0, x1: x1 + 2.0, y0: y - 2.0, y1: y + 20.0 };
        scene.fill(&Path::rectangle(&behind), crate::palette::PAPER);
        scene.text(&heading, LEFT, y + 12.0, INK);
        y += 24.0;
        for bar in group.bars {
            row(&mut scene, bar, &axes, y);
            y += ROW;
        }
    }
    scene.line((x0, bottom), (x1, bottom), Pen::solid(INK, 0.9));
    scene.line((x0, 36.0), (x0, bottom), Pen::solid(INK, 0.9));
    axes.below(&mut scene, &ticks[0], LOOK);
    axes.name_below(&mut scene, &Text::new("probability", NUMBER), 36.0);
    let right = x1 + VALUES;
    let description = "Bars of probabilities on a logarithmic axis.";
    finished(scene, (chart.title, chart.caption), (right, bottom + 50.0), description)
}

fn row(scene: &mut Scene, bar: &ChanceBar<'_>, axes: &Axes, y: f64) {
    let Rect { x0, x1, .. } = axes.area;
    let place = |p: f64| axes.held(p, 0.0).0;
    let words = Text::verbatim(&bar.words.replace('\'', "′"), SMALL);
    let name = bar.mode.map(|mode| Text::new(symbol(mode), SMALL));
    let width = name.as_ref().map_or(0.0, |name| name.width + 7.0) + words.width;
    let behind = Rect { x0: x0 + 1.0, x1: x0 + 9.0 + width, y0: y, y1: y + 15.0 };
    scene.fill(&Path::rectangle(&behind), crate::palette::PAPER);
    let mut x = x0 + 5.0;
    if let Some(name) = name {
        scene.text(&name, x, y + 11.0, INK);
        x += name.width + 7.0;
    }
    scene.text(&words, x, y + 11.0, INK);
    let Chance { value, low, high } = bar.chance;
    let (top, middle) = (y + 17.0, y + 17.0 + THICK / 2.0);
    if value > 0.0 {
        let filled = Rect { x0, x1: place(value).max(x0 + 0.8), y0: top, y1: top + THICK };
        scene.fill(&Path::rectangle(&filled), bar.mode.map_or(BEHIND, tint));
        scene.stroke(&Path::rectangle(&filled), Pen::solid(FAINT, 0.7));
        if place(high) - place(low) > 1.2 {
            let pen = Pen::solid(INK, 1.2);
            scene.line((place(low), middle), (place(high), middle), pen);
            for end in [place(low), place(high)] {
                scene.line((end, middle - 3.5), (end, middle + 3.5), pen);
            }
        }
    } else if high > 0.0 {
        // Never met: somewhere below.
        let end = place(high);
        scene.line((end, top + 1.0), (end, top + THICK - 1.0), Pen::solid(INK, 1.2));
        scene.arrow((end, middle), (x0 + 2.0, middle), Pen::solid(FAINT, 1.0));
    }
    let said = if value > 0.0 || high <= 0.0 {
        Text::new(&format!("${}$", significant(value, 4)), NUMBER)
    } else {
        Text::new(&format!("below ${}$", digits(high)), NUMBER)
    };
    scene.text(&said, x1 + 12.0, middle + 4.0, INK);
    let wide = value > 0.0 && high - low > 1e-6 * value;
    if wide {
        let text = format!("${}$ … ${}$", significant(low, 4), significant(high, 4));
        scene.text(&Text::new(&text, 10.5), x1 + 12.0, middle + 18.0, FAINT);
    }
}
