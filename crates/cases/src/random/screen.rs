//! Probabilities on a screen: rows with bars, what matters, how they were found, and the draws in the plane of the case.

use serde::Serialize;
use standfast::Mode;
use standfast_figures::{Chance, tint_on_screen};
use standfast_probability::sample::Estimate;

use super::figures::{ChanceBar, Cloud, exceedance, groups, title};
use super::summary::{period, summary};
use super::text::{below_or, by_importance, how, notes, probability, slide_rows, within};
use super::{Chances, Probability};
use crate::Document;
use crate::layout::percent;
use crate::summary::Summary;

/// Probabilities as a screen shows them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChancesOnScreen {
    /// Top of the answer.
    pub summary: Summary,
    /// Whether the criterion for the probability is met, in a sentence.
    pub criteria: Option<String>,
    /// That the body does not rest, in per cent.
    pub percent: String,
    /// Shares of an event, in the colours of their modes as CSS: what a strip of them shows.
    pub strip: Vec<(f64, String)>,
    /// Under headings, each with its rows.
    pub groups: Vec<(String, Vec<ChanceOnScreen>)>,
    /// What is shown if one number were known: its words, and the probability of moving then.
    pub known: Vec<[String; 2]>,
    /// Sentences on that.
    pub matters: Vec<String>,
    /// Sentences on how it was found.
    pub how: Vec<String>,
    /// How far it slides in a life: words, value, interval.
    pub slides: Vec<Vec<String>>,
    /// The whole answer as text.
    pub text: String,
}

/// A probability with its words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChanceOnScreen {
    /// What it is of.
    pub words: String,
    /// Symbol of the mode; empty of what is none.
    pub symbol: &'static str,
    /// Colour of the mode as CSS.
    pub tint: Option<String>,
    /// The probability.
    pub share: f64,
    /// In digits.
    pub value: String,
    /// Its interval; empty of what was integrated.
    pub within: String,
}

/// Draws on a screen: in the report's plane of the case, or in a drawing of their own.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DrawsOnScreen {
    /// Force and friction of each, where slenderness and elevation of the force are those of the case.
    pub in_plane: Vec<(f64, f64)>,
    /// In words, what is drawn in the plane.
    pub words: String,
    /// Drawings of what the plane does not show: the name, and the SVG with colours as custom properties.
    pub figures: Vec<(String, String)>,
}

/// Probabilities on a screen, of the least safe set of loads; `None` of a storm without a body.
pub fn chances_on_screen(answer: &Probability) -> Option<ChancesOnScreen> {
    let worst = answer.situations.first()?;
    let summary = summary(answer);
    let moves = answer.joined.as_ref().map_or(worst.not_rest, |joint| joint.not_rest);
    let shown = groups(answer, worst);
    let strip = |(mode, _, chance): &ChanceBar| Some((chance.value, tint_on_screen((*mode)?)));
    let is_rest = |bar: &&ChanceBar| bar.0 == Some(Mode::Rest);
    let bars = shown.first().map_or(&[][..], |(_, bars)| bars);
    let ordered = bars.iter().filter(is_rest).chain(bars.iter().filter(|bar| !is_rest(bar)));
    let strip = ordered.filter_map(strip).collect();
    let rows = |(heading, bars): (String, Vec<ChanceBar>)| (heading, bars.into_iter().map(row).collect());
    let (known, matters) = known(answer, worst);
    let mut found = vec![format!("Probabilities {}: {}.", period(answer), how(answer, worst))];
    found.extend(notes(answer, worst));
    found.extend(answer.note.iter().map(|note| format!("Note: {note}.")));
    Some(ChancesOnScreen {
        criteria: summary.criteria.clone(),
        percent: percent_of(moves),
        strip,
        groups: shown.into_iter().map(rows).collect(),
        known,
        matters,
        how: found,
        slides: answer.sliding.as_ref().map_or_else(Vec::new, slide_rows),
        text: answer.text(&()),
        summary,
    })
}

/// Draws on a screen, where the case has any.
pub fn draws_on_screen(answer: &Probability) -> Option<DrawsOnScreen> {
    let (worst, problem) = answer.situations.first().zip(answer.problem.as_deref())?;
    let cloud = Cloud::of(problem, answer.request.effort.seed);
    // A case in time is answered at its first instant, of which the page has no plane.
    let is_one = answer.situations.len() == 1 && answer.note.is_none();
    let in_plane = cloud.as_ref().filter(|_| is_one).and_then(|cloud| cloud.in_plane(problem));
    let in_plane = in_plane.map_or_else(Vec::new, |(_, draws)| draws);
    let title = title(answer);
    let draws = cloud.filter(|_| in_plane.is_empty()).and_then(|cloud| cloud.figure(problem, worst, &title));
    let slides = answer.sliding.as_ref().and_then(|sliding| exceedance(sliding, &title));
    let figures = [("Draws", draws), ("How far it slides", slides)];
    let figures =
        figures.into_iter().filter_map(|(name, figure)| Some((name.to_owned(), figure?.svg_on_screen())));
    let words = match in_plane.len() {
        0 => String::new(),
        count => format!(
            "The ellipses in the plane are one and two standard deviations of {count} draws, the whiskers one; dots are the first of them, \
             for the eye only."
        ),
    };
    Some(DrawsOnScreen { in_plane, words, figures: figures.collect() })
}

/// A probability in per cent, to two digits.
fn percent_of(e: Estimate) -> String {
    let p = e.value;
    let two = |p: f64| crate::layout::significant(100.0 * p, 2);
    match p {
        0.0 if e.high > 0.0 => format!("below {} %", two(e.high)),
        p if p < 0.99 => format!("{} %", two(p)),
        p => percent(p),
    }
}

fn row((mode, words, chance): ChanceBar) -> ChanceOnScreen {
    let Chance { value, low, high } = chance;
    let estimate = Estimate { value, low, high };
    ChanceOnScreen {
        words: words.replace('\'', "′"),
        symbol: mode.map_or("", Mode::symbol),
        tint: mode.map(tint_on_screen),
        share: value,
        value: below_or(estimate),
        within: within(estimate, &probability).filter(|_| value > 0.0).unwrap_or_default(),
    }
}

/// What the probability would be if one number were known, that which matters most first.
fn known(answer: &Probability, worst: &Chances) -> (Vec<[String; 2]>, Vec<String>) {
    let several = worst.design_point.as_ref().filter(|_| answer.random.len() > 1);
    let order = several.map_or_else(Vec::new, by_importance);
    let row = |place: usize| Some([answer.random[place].words.clone(), below_or(*worst.known.get(place)?)]);
    let known: Vec<[String; 2]> = order.into_iter().filter_map(row).collect();
    let mut sentences: Vec<String> = summary(answer).near.into_iter().collect();
    if !known.is_empty() {
        sentences.push(format!(
            "Probability that it does not rest if the number were known to have its median, in place of {}.",
            below_or(worst.not_rest)
        ));
    }
    (known, sentences)
}
