//! Top of the answer to a case.

use standfast::{Departure, Mode, Verdict};

use super::{AnyCheck, Assessed, Assessment, predicate, verdict};
use crate::json::CheckEntry;
use crate::layout::{self, percent};
use crate::summary::{GoverningCriterion, Summary, criteria, once, sentence};

pub(super) fn summary(assessment: &Assessment) -> Summary {
    let checks = assessment.all_checks();
    let words: Vec<(bool, String)> =
        checks.iter().map(|check| (check.is_met(), check_words(assessment, check))).collect();
    Summary {
        criteria: criteria(&words),
        answer: happens(assessment),
        met: assessment.met(),
        governing: checks.first().map(|check| {
            GoverningCriterion::of(CheckEntry::of(check), place(assessment, check.assessed(assessment)))
        }),
        near: near(assessment),
        warnings: once(assessment.case.warnings().iter().map(standfast_model::Warning::name)),
    }
}

/// The name of a situation, where there are several.
fn place(assessment: &Assessment, assessed: &Assessed) -> Option<String> {
    assessment.name(assessed).filter(|_| assessment.all.len() > 1)
}

/// A criterion with its value: "SF_sliding is 1.178, ≥ 1.2 is asked (utilisation 1.019), in storm".
fn check_words(assessment: &Assessment, check: &AnyCheck<'_>) -> String {
    let [required, value, utilisation, _] = check.cells();
    let place = place(assessment, check.assessed(assessment));
    let place = place.map_or(String::new(), |name| format!(", in {name}"));
    let used = if utilisation == "–" { String::new() } else { format!(" (utilisation {utilisation})") };
    format!("{} is {value}, {required} is asked{used}{place}", check.name())
}

/// What the body does under the full load; of several situations where it moves, and in how many it rests.
fn happens(assessment: &Assessment) -> String {
    let rests = |assessed: &Assessed| assessed.mode() == Some(Mode::Rest);
    let word = if assessment.case.combinations.is_empty() { "loads" } else { "combinations" };
    let count = assessment.all.len();
    let moving: Vec<&Assessed> = assessment.worst_first().into_iter().filter(|one| !rests(one)).collect();
    let place = match assessment.in_time {
        Some(_) => "At the first instant the",
        None => "The",
    };
    match moving.as_slice() {
        [] if count == 1 => format!("{place} body {}.", predicate(Some(Verdict::Begins(Mode::Rest)))),
        [] => format!(
            "{place} body {} under each of the {count} {word}.",
            predicate(Some(Verdict::Begins(Mode::Rest)))
        ),
        [one] if count == 1 => format!("{place} body {}.", predicate(one.verdict())),
        [one, rest @ ..] => {
            let name = assessment.name(one).unwrap_or_default();
            let more = match (rest.len(), count - moving.len()) {
                (0, 1) => "; under the other one it stays at rest".to_owned(),
                (0, others) => format!("; under the other {others} it stays at rest"),
                (more, 0) => format!("; under the other {more} it moves, too"),
                (more, others) => {
                    format!("; it moves under {more} more of the {count} {word}, and rests under {others}")
                }
            };
            format!("{place} body {} under {name}{more}.", predicate(one.verdict()))
        }
    }
}

/// How near another answer is: where the rising loads first move the body, and the least of all factors.
fn near(assessment: &Assessment) -> Option<String> {
    let assessed = assessment.least(|assessed| assessed.departure().load_factor());
    let place = place(assessment, assessed).map_or(String::new(), |name| format!("Under {name}, "));
    let loads = verdict::risen_loads(assessed);
    let departs = match assessed.departure() {
        Departure::AtOnce { permanent: true, verdict } => {
            format!("the permanent loads alone move it: it {}.", predicate(verdict))
        }
        Departure::AtOnce { permanent: false, .. } => format!("any share of {loads} moves it."),
        Departure::At { factor, verdict: Some(Verdict::BearingFailure) } => {
            let less = assessed.ground.as_ref().and_then(|ground| ground.load_factors?.less);
            let less = less.map_or(String::new(), |less| {
                format!(", and at {} with an angle of friction 2° less", percent(less))
            });
            format!("the ground fails at {} of {loads}{less}.", percent(factor))
        }
        Departure::At { factor, verdict } => {
            let goes = verdict
                .map_or_else(|| "it moves".to_owned(), |verdict| format!("it {}", predicate(Some(verdict))));
            format!("at {} of {loads} {goes}.", percent(factor))
        }
        Departure::Never if assessed.rises() => format!("no multiple of {loads} moves it."),
        Departure::Never => String::new(),
    };
    let factor = assessment
        .least(|assessed| verdict::least_factor(assessed).map_or(f64::INFINITY, |(least, _)| least));
    let factor = verdict::least_factor(factor).map_or(String::new(), |(least, against)| {
        format!(" The least safety factor is {}, against {against}.", layout::factor(least))
    });
    let points = match verdict::is_object(assessed) && assessment.in_time.is_none() {
        true => " What it does after the onset: `standfast simulate`.",
        false => "",
    };
    let departs = if departs.is_empty() { departs } else { sentence(&(place + &departs)) };
    let words = format!("{departs}{factor}{points}");
    let words = words.trim().to_owned();
    (!words.is_empty()).then_some(words)
}
