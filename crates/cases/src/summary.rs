//! Top of an answer: what is asked first, in three sentences.

use std::fmt;

use serde::Serialize;
use standfast_answers::assess::AnyCheck;
pub(crate) use standfast_answers::assess::joint_words::listed;
use standfast_answers::motion::MotionValue;
use standfast_answers::results::ResultValue;
use standfast_model::{Bound, Key, MotionCriterion, Warning};

use crate::json::{CheckEntry, RequiredBound, optional_number_or_word};
use crate::layout::{digits, paragraph};

/// Top of an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Whether the criteria are met and which governs, in a sentence; `None` where there is none.
    #[serde(skip)]
    pub criteria: Option<String>,
    /// What happens, in a sentence.
    pub answer: String,
    /// True if all criteria are met; `None` where there is none.
    pub met: Option<bool>,
    /// The governing criterion.
    pub governing: Option<GoverningCriterion>,
    /// How near another answer is, in a sentence; `None` where nothing tells.
    pub near: Option<String>,
    /// The names of the warnings.
    pub warnings: Vec<&'static str>,
    /// Their sentences.
    #[serde(skip)]
    pub warned: Vec<String>,
}

/// The criterion of which most is used.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoverningCriterion {
    /// Its name.
    pub criterion: &'static str,
    /// The loads under which it is met worst; `None` where there is one set of them.
    pub situation: Option<String>,
    /// Its value.
    pub value: ResultValue,
    /// Its bound.
    pub required: RequiredBound,
    /// Share of the bound that is used, 1 at most where it is met; `None` where nothing is measured.
    #[serde(serialize_with = "optional_number_or_word")]
    pub utilisation: Option<f64>,
}

impl GoverningCriterion {
    pub(crate) fn of(check: CheckEntry, situation: Option<String>) -> GoverningCriterion {
        let CheckEntry { name: criterion, required, value, utilisation, .. } = check;
        GoverningCriterion { criterion, situation, value, required, utilisation }
    }
}

impl Summary {
    /// The sentences, each a paragraph, and the names of the warnings, of which more is said below.
    pub fn text(&self) -> String {
        let mut text = self.sentences();
        if !self.warnings.is_empty() {
            text += &paragraph(&format!("Warnings: {}.", self.warnings.join(", ")), 0);
        }
        text
    }

    /// The sentences, each a paragraph, and the warnings with theirs: all that is said.
    pub fn alone(&self) -> String {
        let warned = self.warned.iter().map(|words| paragraph(words, 0));
        warned.fold(self.sentences(), |text, warning| text + &warning)
    }

    fn sentences(&self) -> String {
        let sentences = [self.criteria.as_ref(), Some(&self.answer), self.near.as_ref()];
        sentences.into_iter().flatten().map(|sentence| paragraph(sentence, 0)).collect()
    }
}

/// A warning by its name, with its sentence.
pub(crate) fn warning_words(name: &str, warning: &dyn fmt::Display) -> String {
    format!("Warning ({name}): {warning}.")
}

/// The names of warnings, and their sentences, each once; `told` gives the name and the words of one.
pub(crate) fn warned<'a, W>(
    all: &'a [W],
    told: impl Fn(&'a W) -> (&'static str, &'a dyn fmt::Display),
) -> (Vec<&'static str>, Vec<String>) {
    let all: Vec<_> = all.iter().map(told).collect();
    let words = all.iter().map(|(name, warning)| warning_words(name, warning));
    (once(all.iter().map(|(name, _)| *name)), once(words))
}

/// The same of warnings of a case.
pub(crate) fn warned_of_case(all: &[Warning]) -> (Vec<&'static str>, Vec<String>) {
    warned(all, |warning| (warning.name(), warning))
}

/// Texts, each once, in their order.
pub(crate) fn once<T: PartialEq>(texts: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    texts.for_each(|name| {
        if !found.contains(&name) {
            found.push(name);
        }
    });
    found
}

/// Words with a capital letter in front.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A name that somebody gave, in marks that no sentence runs into.
pub(crate) fn quoted(name: &str) -> String {
    format!("«{name}»")
}

/// A number of years in words.
pub(crate) fn years(years: f64) -> String {
    if years == 1.0 { "one year".to_owned() } else { format!("{} years", digits(years)) }
}

/// Period that a probability is of.
pub(crate) fn period(yearly: bool) -> &'static str {
    if yearly { "in one year" } else { "in one event" }
}

/// A criterion with its value, and how much of it is used: "SF_sliding is 1.178, ≥ 1.2 is asked (utilisation 1.019)". `yearly` if its
/// probability is that of a year.
pub(crate) fn criterion_words(check: &AnyCheck<'_>, yearly: bool) -> String {
    let [required, value, utilisation, _] = check.cells();
    let name = check.name();
    let used = if utilisation == "–" { String::new() } else { format!(" (utilisation {utilisation})") };
    match check {
        AnyCheck::Motion(found, _) if found.criterion == MotionCriterion::NotOverturned => {
            match found.value {
                MotionValue::Truth(false) => "the body does not overturn".to_owned(),
                MotionValue::Truth(true) => "the body overturns".to_owned(),
                _ => "whether the body overturns is not known: the motion is not followed to its end"
                    .to_owned(),
            }
        }
        AnyCheck::Motion(..) => format!("{name} is {value}, {required} is asked{used}"),
        AnyCheck::Instant(found) => {
            let criterion = &found.check.criterion;
            match (criterion.bound, found.check.value) {
                (Bound::NoneOf(_), _) => {
                    format!("{}, and {required} is allowed", found.assessed.at_once())
                }
                (_, ResultValue::Nothing) => {
                    format!("{name}{} has no value, {required} is asked", check.on_joint())
                }
                _ if criterion.key == Key::LeastLoadFactor
                    && found.check.utilisation == Some(f64::INFINITY) =>
                {
                    let who = if found.assessed.joints.is_some() { "a joint" } else { "the body" };
                    format!("{who} leaves rest at once, a {name} {required} is asked")
                }
                _ if criterion.is_chance() => {
                    let years = found.assessed.chances.as_ref().and_then(|chances| chances.years);
                    let period = match years.filter(|_| criterion.key != Key::GreatestNotRest) {
                        Some(life) => format!("over {}", self::years(life)),
                        None => period(yearly).to_owned(),
                    };
                    format!("{} is {value} {period}, {required} is asked{used}", criterion.full_name())
                }
                _ => {
                    format!("{name}{} is {value}, {required} is asked{used}", check.on_joint())
                }
            }
        }
    }
}

/// A criterion as the top tells it.
pub(crate) struct ToldCriterion {
    pub(crate) name: &'static str,
    pub(crate) met: bool,
    /// Reason of its being met or not.
    pub(crate) words: String,
}

/// Whether criteria are met, of which the first governs; and the names of those others that are not.
pub(crate) fn criteria(checks: &[ToldCriterion]) -> Option<String> {
    let ToldCriterion { words, .. } = checks.first()?;
    let failed: Vec<&ToldCriterion> = checks.iter().filter(|check| !check.met).collect();
    Some(match (checks.len(), failed.as_slice()) {
        (1, []) => format!("The criterion is met: {words}."),
        (2, []) => format!("Both criteria are met; the governing one: {words}."),
        (count, []) => format!("All {count} criteria are met; the governing one: {words}."),
        (_, [one]) => format!("Not met: {}.", one.words),
        (count, [one, others @ ..]) => {
            let names = once(others.iter().map(|other| other.name).filter(|name| *name != one.name));
            let too = match names.split_last() {
                None => String::new(),
                Some((name, [])) => format!(" {name} fails, too."),
                Some((last, rest)) => format!(" {} and {last} fail, too.", rest.join(", ")),
            };
            format!("Not met, {} of {count} criteria; the governing one: {}.{too}", failed.len(), one.words)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{ToldCriterion, criteria};

    #[test]
    fn every_criterion_that_fails_is_named_once() {
        let told = |checks: &[(&'static str, bool)]| {
            let told = |(name, met): &(&'static str, bool)| ToldCriterion {
                name,
                met: *met,
                words: format!("{name} is 1"),
            };
            criteria(&checks.iter().map(told).collect::<Vec<_>>()).unwrap()
        };
        assert_eq!(told(&[("a", false), ("b", true)]), "Not met: a is 1.");
        let two = [("a", false), ("a", false), ("b", false), ("c", true)];
        assert_eq!(told(&two), "Not met, 3 of 4 criteria; the governing one: a is 1. b fails, too.");
        let three = [("a", false), ("b", false), ("c", false), ("b", false)];
        assert_eq!(told(&three), "Not met, 4 of 4 criteria; the governing one: a is 1. b and c fail, too.");
        assert_eq!(told(&[("a", true), ("b", true)]), "Both criteria are met; the governing one: a is 1.");
    }
}
