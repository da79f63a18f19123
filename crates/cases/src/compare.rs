//! Two cases side by side: A, which is pinned, and B, which is in hand.

use standfast::Departure;
use standfast_answers::motion::FollowedMotion;
use standfast_inputs::{Difference, Key};
use standfast_motion::End;

use crate::assess::pinned::lone_force;
use crate::assess::{Assessed, Assessment, happens, verdict};
use crate::layout::{digits, percent};
use crate::summary::Summary;

/// A case of two, with its answer.
#[derive(Debug, Clone, Copy)]
pub struct Compared<'a> {
    /// At rest, or its first instant.
    pub rest: Option<&'a Assessment>,
    /// Its motions, the worst first.
    pub motions: &'a [FollowedMotion],
    /// The top of its answer.
    pub summary: Option<&'a Summary>,
}

/// The answers to two cases, in sentences on both.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Comparison {
    /// What each does.
    pub answer: String,
    /// Whether their criteria are met; empty where there are none.
    pub criteria: String,
    /// Up to which load each rests; empty where no load rises.
    pub near: String,
}

impl Comparison {
    /// The answers to two cases that differ.
    pub fn of(a: &Compared<'_>, b: &Compared<'_>, differences: &[Difference]) -> Comparison {
        let one = a.does("A");
        let other = b.does(&named(differences));
        let does = |sentence: &str, who: &str| sentence.strip_prefix(who).map(str::to_owned);
        // Of two that do the same the second does it, too.
        let is_same = does(&one, "A").is_some_and(|does| does.starts_with(' ') && other.ends_with(&does));
        let other = match other.strip_suffix('.').filter(|_| is_same) {
            Some(words) => format!("{words}, too."),
            None => other,
        };
        Comparison { answer: format!("{one} {other}"), criteria: criteria(a, b), near: near(a, b) }
    }
}

/// B by what was changed, if that is one number.
fn named(differences: &[Difference]) -> String {
    let mut that_count = differences.iter().filter(|difference| !difference.is_label());
    let (Some(one), None) = (that_count.next(), that_count.next()) else { return "B".to_owned() };
    let (Some(key), [_, Some(value)]) = (one.number(), &one.written) else { return "B".to_owned() };
    let what = match key {
        Key::Width => format!("{value} wide"),
        Key::Height => format!("{value} high"),
        _ => {
            let name = key.name().replace('_', " ");
            match name.strip_suffix(" deg") {
                Some(angle) => format!("with {angle} {value}°"),
                None => format!("with {name} {value}"),
            }
        }
    };
    format!("B, {},", what.replace('-', "−"))
}

impl Compared<'_> {
    /// What it does, in a sentence on `who`.
    fn does(&self, who: &str) -> String {
        match (self.motions.first(), self.rest) {
            (Some(worst), _) => format!("{who} {}.", becomes(worst)),
            (None, Some(rest)) => happens(rest, who),
            (None, None) => format!("{who} has no answer."),
        }
    }

    /// Where it leaves rest as its loads rise, under the loads under which that is first.
    fn departure(&self) -> Option<&Assessed> {
        let rest = self.rest.filter(|_| self.motions.is_empty())?;
        Some(rest.least(|assessed| assessed.departure().load_factor())).filter(|assessed| assessed.rises())
    }

    /// Where it leaves rest, in a few words; `None` where no load rises.
    pub fn leaves_rest(&self) -> Option<String> {
        let assessed = self.departure()?;
        Some(match assessed.departure() {
            Departure::Never => "never".to_owned(),
            Departure::AtOnce { .. } => "at once".to_owned(),
            Departure::At { factor, .. } => at(assessed, factor),
        })
    }
}

/// A multiple of the loads of a situation: as a force where they are one.
fn at(assessed: &Assessed, factor: f64) -> String {
    match lone_force(assessed) {
        Some(force) => assessed.output.force(factor * force.abs()),
        None => percent(factor),
    }
}

/// What becomes of a body in time, in a few words.
fn becomes(worst: &FollowedMotion) -> String {
    let outcome = &worst.outcome;
    let s = if worst.case.si { " s" } else { "" };
    let last = outcome.events.last().map_or(0.0, |event| event.t);
    if !outcome.events.iter().any(|event| event.state != standfast::Mode::Rest) {
        return "stays at rest".to_owned();
    }
    match outcome.end {
        End::AtRest => {
            format!(
                "moves, and comes to rest at t = {}{s}",
                digits(outcome.t_rest.unwrap_or(outcome.t_final))
            )
        }
        End::Overturned => format!("overturns at t = {}{s}", digits(last)),
        _ => format!("is followed up to t = {}{s}", digits(last)),
    }
}

/// Whether each meets its criteria, and which of those of B governs.
fn criteria(a: &Compared<'_>, b: &Compared<'_>) -> String {
    let [of_a, of_b] = [a, b].map(|one| one.summary.and_then(|summary| summary.met));
    let first = match of_a {
        Some(true) => "A meets its criteria.",
        Some(false) => "A does not meet its criteria.",
        None if of_b.is_some() => "A has no criteria.",
        None => "",
    };
    // "Of B not met: …", "Of B both criteria are met; …"
    let second = b.summary.and_then(|summary| summary.criteria.as_deref()).map(|words| {
        let mut letters = words.chars();
        let first = letters.next().into_iter().flat_map(char::to_lowercase);
        format!("Of B {}", first.chain(letters).collect::<String>())
    });
    [Some(first.to_owned()).filter(|words| !words.is_empty()), second]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(" ")
}

/// Up to which load each rests.
fn near(a: &Compared<'_>, b: &Compared<'_>) -> String {
    let both = [("A", a.departure()), ("B", b.departure())];
    let loads = both.map(|(_, assessed)| assessed.map(verdict::risen_loads));
    let of = |i: usize| match (&both[i].1, &loads[i]) {
        (Some(assessed), Some(loads)) if lone_force(assessed).is_none() => format!(" of {loads}"),
        _ => String::new(),
    };
    if let [(_, Some(one)), (_, Some(two))] = both
        && let (Departure::At { factor: first, .. }, Departure::At { factor: second, .. }) =
            (one.departure(), two.departure())
    {
        let (of_one, of_two) = (of(0), of(1));
        let of_two = if of_one == of_two { String::new() } else { of_two };
        let (first, second) = (at(one, first), at(two, second));
        if first == second && of_two.is_empty() {
            return format!("Both rest up to {first}{of_one}.");
        }
        return format!("A rests up to {first}{of_one}, B up to {second}{of_two}.");
    }
    let said = both.iter().zip(&loads).enumerate().filter_map(|(i, ((who, assessed), loads))| {
        let (assessed, loads) = ((*assessed)?, loads.as_ref()?);
        Some(match assessed.departure() {
            Departure::At { factor, .. } => format!("{who} rests up to {}{}.", at(assessed, factor), of(i)),
            Departure::AtOnce { permanent: true, .. } => format!("The permanent loads alone move {who}."),
            Departure::AtOnce { permanent: false, .. } => format!("Any share of {loads} moves {who}."),
            Departure::Never => format!("No multiple of {loads} moves {who}."),
        })
    });
    said.collect::<Vec<_>>().join(" ")
}
