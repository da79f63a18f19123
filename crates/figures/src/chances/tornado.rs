//! Importance of each number: its share α² in the direction of the design point, and the probability if it were known.

use super::finished;
use crate::Figure;
use crate::axes::{Axes, Axis, LEFT, NUMBER, PAGE};
use crate::caption::{SMALL, cut};
use crate::number::{digits, significant};
use crate::palette::{BEHIND, FAINT, INK, LOWERS, MARK, RAISES};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const ROW: f64 = 26.0;
const THICK: f64 = 13.0;
const SHARES: f64 = 120.0;
/// Letters of a name.
const LONGEST: usize = 42;
/// Right of the plots: a number.
const VALUES: f64 = 96.0;
const TOP: f64 = 44.0;
const LEAST: f64 = 1e-12;

/// A random number and what it does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Importance<'a> {
    /// Its name; not markup.
    pub name: &'a str,
    /// α².
    pub alpha2: f64,
    /// The probability if it were known to have its median.
    pub known: f64,
}

/// Importance of several random numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tornado<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The probability as it is.
    pub probability: f64,
    /// The numbers, from above.
    pub numbers: &'a [Importance<'a>],
}

/// Draws what matters: bars of α², and beside them bars from the probability to what it would be if the number were known.
pub fn chance_tornado(chart: &Tornado<'_>) -> Figure {
    let mut scene = Scene::default();
    let names: Vec<Text> =
        chart.numbers.iter().map(|n| Text::verbatim(&cut(n.name, LONGEST), NUMBER)).collect();
    let widest = names.iter().fold(60.0, |most: f64, name| most.max(name.width));
    let (a0, gap) = (LEFT + widest + 56.0, 48.0);
    let (k0, k1) = (a0 + SHARES + gap, PAGE - VALUES);
    let all = || chart.numbers.iter().map(|n| n.known).chain([chart.probability]);
    let least = all().filter(|p| *p > 0.0).fold(1.0, f64::min).max(LEAST);
    let most = all().fold(least, f64::max);
    let from = 10f64.powf((0.6 * least).log10().floor());
    let to = 10f64.powf((1.5 * most).log10().ceil()).min(1.0);
    let bottom = TOP + ROW * chart.numbers.len() as f64 + 4.0;
    let over = |x0: f64, x1: f64, axis: Axis| Axes::over(Rect { x0, x1, y0: TOP, y1: bottom }, axis);
    let shares = over(a0, a0 + SHARES, Axis::linear(0.0, 1.0));
    let known = over(k0, k1, Axis { from, to, logarithmic: true });
    let share = |value: f64| shares.held(value, 0.0).0;
    let place = |p: f64| known.held(p, 0.0).0;
    for axes in [&shares, &known] {
        let [ticks, _] = axes.ticks();
        let ticks = [ticks, Vec::new()];
        axes.grid(&mut scene, &ticks);
        axes.framed(&mut scene, &ticks);
    }
    for (i, (number, name)) in chart.numbers.iter().zip(&names).enumerate() {
        let y = TOP + 4.0 + ROW * i as f64;
        let middle = y + ROW / 2.0 - 2.0;
        let bar = |x: f64, to: f64| Rect {
            x0: x.min(to),
            x1: x.max(to).max(x.min(to) + 0.8),
            y0: middle - THICK / 2.0,
            y1: middle + THICK / 2.0,
        };
        scene.text(name, LEFT, middle + 4.0, INK);
        let text = Text::new(&format!("${:.2}$", number.alpha2), NUMBER);
        scene.text(&text, a0 - 12.0 - text.width, middle + 4.0, INK);
        let parts = [(bar(a0, share(number.alpha2)), BEHIND), {
            let colour = if number.known <= chart.probability { LOWERS } else { RAISES };
            (bar(place(chart.probability), place(number.known)), colour)
        }];
        for (rect, colour) in parts {
            scene.fill(&Path::rectangle(&rect), colour);
            scene.stroke(&Path::rectangle(&rect), Pen::solid(FAINT, 0.6));
        }
        let text = Text::new(&format!("${}$", significant(number.known, 3)), NUMBER);
        scene.text(&text, k1 + 10.0, middle + 4.0, INK);
    }
    let x = place(chart.probability);
    scene.line((x, TOP - 3.0), (x, bottom), Pen::solid(MARK, 1.4));
    let said = Text::new(&format!("$P = {}$", digits(chart.probability)), SMALL);
    let left = (x - said.width / 2.0).clamp(k0, (k1 - said.width).max(k0));
    scene.text(&said, left, TOP - 8.0, MARK);
    for (axes, name) in [(&shares, "Share, $α^2$"), (&known, "Probability if it were known")] {
        axes.name_below(&mut scene, &Text::new(name, NUMBER));
    }
    let description = "Bars of the shares of random numbers, and of the probability if each were known.";
    finished(scene, (chart.title, chart.caption), (PAGE, bottom + 50.0), description)
}
