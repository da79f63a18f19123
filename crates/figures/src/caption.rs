//! Words below a chart, and for readers who do not see it.

use standfast::diagram::Unresolved;
use standfast::{Modes, Point, Verdict};

use crate::below::verbatim;
use crate::drawing::Drawing;
use crate::margins;
use crate::number::digits;
use crate::palette::{symbol, verdict_symbol};
use crate::plot::View;
use crate::sheet::{Part, letter_markup};
use crate::text::Text;
use crate::{DesignPoint, is_drawable};

/// Type sizes of the caption and of the details below it.
pub(crate) const SIZE: f64 = 13.0;
pub(crate) const SMALL: f64 = 11.7;
/// The least type size of a label: 6 pt where a page-wide figure is printed 170 mm wide, or 128 mm high.
pub(crate) const LEAST: f64 = 10.5;
/// The least type size on a screen, of which a unit is a pixel.
pub(crate) const READABLE: f64 = 12.0;
/// Largest number of design points listed.
const LISTED: usize = 12;

/// Heading and caption in plain characters.
pub(crate) fn title(drawing: &Drawing) -> String {
    format!("{} {}", drawing.heading.trim(), Text::inline(drawing.caption, SIZE).plain)
}

/// The body, the named points, `legend` (what found no room in the chart) and the design points, of which the
/// `numbered` ones carry a number in the chart, as words of a paragraph.
pub(crate) fn details(drawing: &Drawing, legend: &[String], numbered: &[usize]) -> Vec<Text> {
    // What lies outside the frame is not drawn.
    let shown = drawing.named().filter(|point| drawing.window.shows(point.k, point.mu));
    let named = shown.map(|point| format!("{}~{}", letter_markup(point.name), pair(point.k, point.mu)));
    let parts: Vec<_> = named.chain(legend.iter().cloned()).collect();
    let stop = if parts.is_empty() { "" } else { "." };
    let mut words = margins::words(&format!("{} {}{stop}", drawing.preface, parts.join(", ")), SMALL);
    if drawing.sheet.shaded.iter().any(|part| matches!(part, Part::Unresolved(_))) {
        words.extend(margins::words("Hatched: given to another mode in IV.7.", SMALL));
    }
    let chart = drawing.diagram.chart();
    let said = |point: &DesignPoint| {
        let at = Point::new(chart.gamma(), chart.k_prime(), point.k, point.mu).ok()?;
        Some(Said { verdict: Verdict::Begins(at.mode()), others: at.others() })
    };
    words.extend(of_points(drawing.points, drawing.cloud, &drawing.window, numbered, said));
    if let Some(pinned) = drawing.pinned {
        words.extend(verbatim(&(pinned.words() + "."), SMALL));
    }
    words
}

/// Verdict on a point whose force points left.
pub(crate) struct Said {
    pub verdict: Verdict,
    /// Modes that are consistent beside it.
    pub others: Modes,
}

/// The design points, of which the `numbered` ones carry a number in the chart, each with what `said` says of it; and the cloud.
pub(crate) fn of_points(
    points: &[DesignPoint],
    cloud: &[(f64, f64)],
    window: &View,
    numbered: &[usize],
    said: impl Fn(&DesignPoint) -> Option<Said>,
) -> Vec<Text> {
    let mut words = Vec::new();
    let shown = points.iter().enumerate().filter(|(_, point)| point.is_drawable());
    for (i, point) in shown.take(LISTED) {
        let name = match point.label.trim() {
            "" => format!("Point {}", i + 1),
            label if numbered.contains(&i) => format!("({}) {label}", i + 1),
            label => label.into(),
        };
        words.extend(name.split_whitespace().map(|word| Text::verbatim(&shortened(word), SMALL)));
        let outside = if window.shows(point.k, point.mu) { "" } else { ", outside the window" };
        words.extend(margins::words(&format!("{}{outside}:", pair(point.k, point.mu)), SMALL));
        if let Some(Said { verdict, others }) = said(point) {
            let (verdict, others, remark) = if point.mirrored {
                (verdict.mirrored(), others.mirrored(), " (to the right, mirrored)")
            } else {
                (verdict, others, "")
            };
            words.extend(margins::words(
                &format!("{}{}{remark}.", verdict_symbol(verdict), also(others)),
                SMALL,
            ));
        }
    }
    let beyond = points.iter().filter(|point| point.is_drawable()).count().saturating_sub(LISTED);
    if beyond > 0 {
        words.extend(margins::words(&format!("And {beyond} more."), SMALL));
    }
    words.extend(margins::words(&of_cloud(cloud, window), SMALL));
    words
}

/// A place of the plane in markup.
pub(crate) fn pair(k: f64, mu: f64) -> String {
    format!("$({},{})$", digits(k), digits(mu))
}

/// Number of points without names, in and out of the window.
fn of_cloud(cloud: &[(f64, f64)], window: &View) -> String {
    let points = || cloud.iter().filter(|point| is_drawable(point));
    let outside = points().filter(|&&(k, mu)| !window.shows(k, mu)).count();
    match (points().count(), outside) {
        (0, _) => String::new(),
        (count, 0) => format!("Dots: {count} points."),
        (count, outside) => format!("Dots: {count} points, {outside} of them outside the window."),
    }
}

/// The modes that are consistent beside the one reported, as a remark behind it in markup.
pub(crate) fn also(others: Modes) -> String {
    if others.is_empty() { String::new() } else { format!(" (also {})", symbols(others)) }
}

/// The symbols of modes in markup.
pub(crate) fn symbols(modes: Modes) -> String {
    modes.iter().map(symbol).collect::<Vec<_>>().join(", ")
}

/// Words for the hatching: the parts of the indeterminate set, and the modes consistent in each.
pub(crate) fn hatching(parts: &[Unresolved]) -> Option<String> {
    let modes = parts.iter().map(|part| format!("one of {}", symbols(part.modes)));
    let parts = modes.collect::<Vec<_>>().join(" or ");
    (!parts.is_empty()).then(|| format!("hatched: {parts}"))
}

/// A word that fits a line.
pub(crate) fn shortened(word: &str) -> String {
    cut(word, 32)
}

/// Words of so many letters at most.
pub(crate) fn cut(words: &str, longest: usize) -> String {
    if words.chars().count() <= longest {
        words.into()
    } else {
        words.chars().take(longest - 1).chain(['…']).collect()
    }
}

/// A region in words, for readers who do not see it: its symbol in markup, and what the body does there.
pub(crate) fn region(symbol: &str, words: &str) -> String {
    format!("{}, where the body {}", Text::inline(symbol, SMALL).plain, words.replace('\'', "′"))
}

/// A chart in words: the friction over another quantity, and what is shaded.
pub(crate) fn chart(over: &str, view: &View, shaded: impl Iterator<Item = String>) -> String {
    let View { k_min, k_max, mu_min, mu_max } = *view;
    let [k_min, k_max, mu_min, mu_max] = [k_min, k_max, mu_min, mu_max]
        .map(|value| Text::inline(&format!("${}$", digits(value)), SMALL).plain);
    format!(
        "Chart of the friction coefficient μ, upwards from {mu_min} to {mu_max}, over {over}, to the right from {k_min} to {k_max}. \
         Shaded: {}.",
        shaded.collect::<Vec<_>>().join("; ")
    )
}

/// The chart in words: axes, shaded regions, and the `details` below it.
pub(crate) fn description(drawing: &Drawing, details: &str) -> String {
    let shaded = drawing.sheet.shaded.iter().map(|part| match *part {
        Part::Whole(mode) | Part::LeftOfE(mode) | Part::RightOfE(mode) => region(symbol(mode), mode.words()),
        Part::Unresolved(mode) => {
            let symbol = Text::inline(symbol(mode), SMALL).plain;
            format!("hatched, where the conditions of {symbol} and of other modes hold together")
        }
    });
    format!("{} {details}", chart("the force k", &drawing.window, shaded))
}
