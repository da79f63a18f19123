//! The labels around the plot: values under the k axis and beside the μ axis, letters and formulas at the ends of
//! lines along the right and upper edges, the caption below.

use crate::axes::Axes;
use crate::labels::spread;
use crate::palette::{FAINT, INK};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const LEADER: Pen = Pen::solid(FAINT, 0.6);
const TICK: Pen = Pen::solid(INK, 0.9);

/// A label that belongs to a place on an edge of the plot, given by x or y on the page.
#[derive(Debug)]
pub(crate) struct Tab {
    pub at: f64,
    pub text: Text,
}

/// Displacement beyond which a leader joins a label to its place.
const NEAR: f64 = 3.0;

fn sorted(mut tabs: Vec<Tab>) -> Vec<Tab> {
    standfast::order::by_number(&mut tabs, |one| one.at);
    tabs
}

fn places(tabs: &[Tab], length: impl Fn(&Text) -> f64, low: f64, high: f64, gap: f64) -> Option<Vec<f64>> {
    let wanted: Vec<_> = tabs.iter().map(|tab| (tab.at, length(&tab.text))).collect();
    spread(&wanted, low, high, gap)
}

/// Ticks and labels under the k axis, `full` ones if they fit near their ticks, else `short` ones. Returns the y
/// below them, and whether the full ones were drawn.
pub(crate) fn under_k_axis(scene: &mut Scene, axes: &Axes, full: Vec<Tab>, short: Vec<Tab>) -> (f64, bool) {
    const FAR: f64 = 70.0;
    let Rect { x0, x1, y1, .. } = axes.area;
    let (full, short) = (sorted(full), sorted(short));
    let row = |tabs: &[Tab]| places(tabs, |text| text.width, x0 - 1.0, x1 + 10.0, 15.0);
    let moved = |tabs: &[Tab], at: &[f64]| {
        tabs.iter().zip(at).fold(0.0, |m: f64, (tab, x)| m.max((tab.at - x).abs()))
    };
    let fits = row(&full).filter(|at| moved(&full, at) <= FAR);
    let is_full = fits.is_some();
    let tabs = if is_full { full } else { short };
    let Some(at) = fits.or_else(|| row(&tabs)) else { return (y1 + 8.0, false) };
    let moved = moved(&tabs, &at) > NEAR;
    let top = y1 + if moved { 16.0 } else { 9.0 };
    // Labels with fractions hang from a common line through their letters.
    let rise = tabs.iter().fold(0.0, |m: f64, tab| m.max(tab.text.ascent));
    let mut bottom = y1 + 14.0;
    for (tab, x) in tabs.iter().zip(at) {
        scene.line((tab.at, y1), (tab.at, y1 + 4.0), TICK);
        if moved {
            let tip = top + rise - tab.text.ascent - 2.0;
            scene.stroke(
                &Path::through(&[(tab.at, y1 + 5.5), (x, y1 + 12.5), (x, tip.max(y1 + 13.5))]),
                LEADER,
            );
        }
        scene.text(&tab.text, x - tab.text.width / 2.0, top + rise, INK);
        bottom = bottom.max(top + rise + tab.text.descent);
    }
    (bottom, is_full)
}

/// True if labels beside the μ axis would stand so close that fractions among them read as one.
pub(crate) fn is_crowded(tabs: &[Tab]) -> bool {
    const APART: f64 = 9.0;
    let overlap = |one: &Tab, other: &Tab| {
        (one.at - other.at).abs() < (one.text.height() + other.text.height()) / 2.0 + APART
    };
    tabs.iter().enumerate().any(|(i, tab)| tabs[i + 1..].iter().any(|other| overlap(tab, other)))
}

/// The width that labels beside the μ axis take.
pub(crate) fn mu_width<'a>(tabs: impl Iterator<Item = &'a Tab>) -> f64 {
    tabs.fold(0.0, |m: f64, tab| m.max(tab.text.width)) + 17.0
}

/// Labels along an upright edge of the plot, each with the y where it finds room.
fn upright(tabs: Vec<Tab>, low: f64, high: f64) -> Option<impl Iterator<Item = (Tab, f64)>> {
    let tabs = sorted(tabs);
    let at = places(&tabs, Text::height, low, high, 5.0)?;
    Some(tabs.into_iter().zip(at))
}

/// A label that begins at `left`, centred at `y`.
fn level(scene: &mut Scene, text: &Text, left: f64, y: f64) {
    scene.text(text, left, y + (text.ascent - text.descent) / 2.0, INK);
}

/// A tick at the left of the plot and its label at `y`.
pub(crate) fn beside(scene: &mut Scene, axes: &Axes, tab: &Tab, y: f64) {
    let x0 = axes.area.x0;
    scene.line((x0 - 4.0, tab.at), (x0, tab.at), TICK);
    let moved = (tab.at - y).abs() > NEAR;
    let right = x0 - if moved { 15.0 } else { 8.0 };
    if moved {
        scene.line((x0 - 5.0, tab.at), (right + 2.0, y), LEADER);
    }
    level(scene, &tab.text, right - tab.text.width, y);
}

/// Ticks and labels beside the μ axis.
pub(crate) fn beside_mu_axis(scene: &mut Scene, axes: &Axes, tabs: Vec<Tab>) {
    for (tab, y) in upright(tabs, axes.area.y0, axes.area.y1 - 2.0).into_iter().flatten() {
        beside(scene, axes, &tab, y);
    }
}

/// Labels right of the plot, at the ends of lines. Returns the x right of them, and whether they fitted.
pub(crate) fn right_of(scene: &mut Scene, axes: &Axes, tabs: Vec<Tab>) -> Option<f64> {
    let Rect { x1, y0, y1, .. } = axes.area;
    let mut right = x1;
    for (tab, y) in upright(tabs, y0 + 1.0, y1 - 12.0)? {
        let moved = (tab.at - y).abs() > NEAR;
        let left = x1 + if moved { 15.0 } else { 6.0 };
        if moved {
            scene.line((x1 + 1.0, tab.at), (left - 2.0, y), LEADER);
        }
        level(scene, &tab.text, left, y);
        right = right.max(left + tab.text.width);
    }
    Some(right)
}

/// Labels above the plot and right of `from`, at the ends of lines; `None` if they do not fit.
pub(crate) fn above(scene: &mut Scene, axes: &Axes, tabs: Vec<Tab>, from: f64) -> Option<()> {
    let Rect { x1, y0, .. } = axes.area;
    let tabs = sorted(tabs);
    let at = places(&tabs, |text| text.width, from + 8.0, x1, 8.0)?;
    for (tab, x) in tabs.iter().zip(at) {
        let moved = (tab.at - x).abs() > NEAR;
        let bottom = y0 - if moved { 11.0 } else { 5.0 };
        if moved {
            scene.line((tab.at, y0 - 1.0), (x, bottom + 2.0), LEADER);
        }
        scene.text(&tab.text, x - tab.text.width / 2.0, bottom - tab.text.descent, INK);
    }
    Some(())
}

/// A paragraph between `left` and `right` with its first line's top at `top`; breaks at the spaces of words.
/// Returns the y below it.
pub(crate) fn paragraph(
    scene: &mut Scene,
    words: &[Text],
    (left, right): (f64, f64),
    top: f64,
    size: f64,
) -> f64 {
    let mut baseline = top + 0.8 * size;
    let (mut line, mut x) = (Text::default(), left);
    for word in words {
        if !line.runs.is_empty() && x + word.width > right {
            scene.text(&line, left, baseline, INK);
            baseline += 1.38 * size;
            (line, x) = (Text::default(), left);
        }
        line.push(word, x - left);
        x += word.width + 0.27 * size;
    }
    if !line.runs.is_empty() {
        scene.text(&line, left, baseline, INK);
    }
    baseline + 0.35 * size
}

/// Markup cut into words at the spaces outside mathematics; a tilde is a space at which no line breaks.
pub(crate) fn words(markup: &str, size: f64) -> Vec<Text> {
    let mut inside = false;
    let between = |character: char| {
        inside ^= character == '$';
        character == ' ' && !inside
    };
    markup
        .split(between)
        .filter(|word| !word.is_empty())
        .map(|word| Text::inline(&word.replace('~', " "), size))
        .collect()
}
