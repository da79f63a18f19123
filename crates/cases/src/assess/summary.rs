//! Top of the answer to a case.

use standfast::{Boundary, Departure, Mode, Verdict};

use super::{AnyCheck, Assessed, Assessment, Joints, ground, joints, plan, predicate, verdict};
use crate::json::CheckEntry;
use crate::layout::percent;
use crate::summary::{
    GoverningCriterion, Summary, ToldCriterion, capital, criteria, criterion_words, quoted, warned_of_case,
};

/// What a summary is about, where nothing else is said.
pub(super) const BODY: &str = "the body";

/// A body at rest.
const REST: Option<Verdict> = Some(Verdict::Begins(Mode::Rest));

pub(super) fn summary(assessment: &Assessment) -> Summary {
    let checks = assessment.all_checks();
    let told = |check: &AnyCheck<'_>| ToldCriterion {
        name: check.name(),
        met: check.is_met(),
        words: check_words(assessment, check),
    };
    let told: Vec<ToldCriterion> = checks.iter().map(told).collect();
    let (warnings, warned) = warned_of_case(&assessment.case.warnings());
    Summary {
        criteria: criteria(&told),
        answer: happens(assessment, BODY, predicate),
        met: assessment.met(),
        governing: checks.first().map(|check| {
            GoverningCriterion::of(CheckEntry::of(check), place(assessment, check.assessed(assessment)))
        }),
        near: near(assessment),
        warnings,
        warned,
    }
}

/// The name of a situation, where there are several.
fn place(assessment: &Assessment, assessed: &Assessed) -> Option<String> {
    assessment.name(assessed).filter(|_| assessment.all.len() > 1)
}

/// A criterion with its value, and under which loads: "SF_sliding is 1.178, ≥ 1.2 is asked (utilisation 1.019), under «storm»".
fn check_words(assessment: &Assessment, check: &AnyCheck<'_>) -> String {
    let place = place(assessment, check.assessed(assessment));
    let place = place.map_or(String::new(), |name| format!(", under {}", quoted(&name)));
    criterion_words(check, assessment.yearly) + &place
}

/// True of a body that rests under the full load and not under the permanent loads alone.
fn is_held(assessed: &Assessed) -> bool {
    matches!(assessed.departure(), Departure::AtOnce { permanent: true, .. })
        && assessed.mode() == Some(Mode::Rest)
}

/// What `who` does, the body, under the full load, each verdict told by `does`; of several situations where it moves, and in how many it
/// rests.
pub(super) fn happens(assessment: &Assessment, who: &str, does: fn(Option<Verdict>) -> String) -> String {
    let rests = |assessed: &Assessed| assessed.mode() == Some(Mode::Rest);
    // Where a situation is tried in several ways, one in which the body moves.
    fn moved(assessed: &Assessed) -> &Assessed {
        assessed.tried().find(|tried| tried.mode() != Some(Mode::Rest)).unwrap_or(assessed)
    }
    let word = if assessment.case.combinations.is_empty() { "loads" } else { "combinations" };
    let count = assessment.all.len();
    let all = assessment.worst_first().into_iter().map(moved);
    let moving: Vec<&Assessed> = all.filter(|one| !rests(one)).collect();
    let springs = assessment.all.iter().any(|assessed| ground::first_event(assessed).is_some());
    let place = match assessment.in_time {
        None if springs => format!("Under loads raised slowly {who}"),
        Some(_) => format!("With all loads held at their peaks {who}"),
        None => capital(who),
    };
    let each = match (count, assessment.case.combinations.is_empty()) {
        (1, _) => String::new(),
        (_, true) => format!(" under each of the {count} loads, which act one at a time"),
        (_, false) => format!(" under each of the {count} combinations"),
    };
    let is_exact = |assessed: &Assessed| assessed.outcome.full.boundary == Some(Boundary::Exact);
    // Of bodies on joints each joint is told of, in place of the whole.
    let on_joints = |clause: String| match who {
        BODY => capital(&clause),
        _ => format!("{place}: {clause}"),
    };
    let moves = |one: &Assessed| match &one.joints {
        Some(joints) => on_joints(joints.at_once(one)),
        None if one.outcome.plan.is_some() => format!("{place} does not stay at rest"),
        None => format!("{place} {}", does(one.verdict())),
    };
    let stays = match assessment.case.joints.is_empty() {
        true => format!("{place} {}", does(REST)),
        false => on_joints("every joint rests".to_owned()),
    };
    match moving.as_slice() {
        [] if assessment.all.iter().any(is_held) => {
            format!("{stays}{each}, but only while the variable loads act.")
        }
        [] if assessment.case.joints.is_empty() && assessment.all.iter().any(is_exact) => {
            format!("{stays}{each}, exactly on the boundary: the least more load moves it.")
        }
        [] => format!("{stays}{each}."),
        [one] if count == 1 => format!("{}.", moves(one)),
        [one, rest @ ..] => {
            let name = quoted(&assessment.name(one).unwrap_or_default());
            let [it_rests, it_moves, rests] = match assessment.case.joints.is_empty() {
                true => ["it stays at rest", "it moves", "rests"],
                false => ["every joint rests", "a joint moves", "all rest"],
            };
            let more = match (rest.len(), count - moving.len()) {
                (0, 1) => format!("; under the other one {it_rests}"),
                (0, others) => format!("; under the other {others} {it_rests}"),
                (more, 0) => format!("; under the other {more} {it_moves}, too"),
                (more, others) => {
                    format!(
                        "; {it_moves} under {more} more of the {count} {word}, and {rests} under {others}"
                    )
                }
            };
            format!("{} under {name}{more}.", moves(one))
        }
    }
}

/// How near another answer is: where the rising loads first move the body, and the least of all factors.
fn near(assessment: &Assessment) -> Option<String> {
    let assessed = assessment.least(|assessed| assessed.departure().load_factor());
    let head = place(assessment, assessed).map_or(String::new(), |name| format!("Under {}, ", quoted(&name)));
    let loads = verdict::risen_loads(assessed);
    let departs = match &assessed.joints {
        Some(joints) => near_on_joints(assessed, joints, &loads),
        None => match (&assessment.case_of(assessed).plan, &assessed.outcome.plan) {
            (Some(plan), Some(answer)) => plan::near(plan, assessed, answer, &loads),
            _ => near_as_one(assessed, &loads),
        },
    };
    let least = assessment
        .least(|assessed| verdict::least_factor(assessed).map_or(f64::INFINITY, |(least, _)| least));
    let under = match place(assessment, least).filter(|_| least.index != assessed.index) {
        Some(name) => format!(", under {}", quoted(&name)),
        None => String::new(),
    };
    let factor = verdict::least_factor(least).map_or(String::new(), |(factor, against)| {
        format!(" The least safety factor is {}, against {against}{under}.", least.output.factor(factor))
    });
    let is_followed =
        assessment.in_time.is_none() && assessed.joints.is_none() && assessed.outcome.plan.is_none();
    let points = match verdict::is_object(assessed) && is_followed {
        true => {
            " What it does after the onset, a shaking in time tells: [motion.base] with a record or a shape."
        }
        false => "",
    };
    let departs = if departs.is_empty() { departs } else { capital(&(head + &departs)) };
    let words = format!("{departs}{factor}{points}");
    let in_time = in_time(assessment);
    let slowly = in_time.as_ref().filter(|_| !assessment.case.criteria.is_empty());
    let slowly = slowly.map(|_| "Criteria are those of loads raised slowly.".to_owned());
    let words: Vec<String> = [in_time, Some(words.trim().to_owned()), slowly]
        .into_iter()
        .flatten()
        .filter(|words| !words.is_empty())
        .collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// Where the rising `loads` first move a joint.
fn near_on_joints(assessed: &Assessed, joints: &Joints, loads: &str) -> String {
    let clause = joints.departs(assessed);
    match assessed.departure() {
        Departure::AtOnce { permanent: true, .. } => {
            format!("the permanent loads alone move a joint: {clause}.")
        }
        Departure::AtOnce { permanent: false, .. } => {
            format!("any share of {loads} moves a joint: {clause}.")
        }
        Departure::At { factor, .. } => {
            let glued = joints::glued_words(assessed);
            format!("at {} {clause}. {glued}", verdict::share_of_loads(assessed, factor))
        }
        Departure::Never if assessed.rises() => format!("no multiple of {loads} moves a joint."),
        Departure::Never => String::new(),
    }
}

/// Where the rising `loads` first move one body.
fn near_as_one(assessed: &Assessed, loads: &str) -> String {
    let factors = assessed.ground.as_ref().and_then(|ground| ground.load_factors);
    let [less, more] = [factors.and_then(|factors| factors.less), factors.and_then(|factors| factors.more)];
    match assessed.departure() {
        Departure::AtOnce { permanent: true, verdict } => {
            format!("the permanent loads alone move it: it {}.", predicate(verdict))
        }
        Departure::AtOnce { permanent: false, .. } => format!("any share of {loads} moves it."),
        Departure::At { factor, verdict: Some(Verdict::BearingFailure) } => {
            let range = match (less, more) {
                (Some(less), Some(more)) if more.is_finite() => {
                    format!(" ({} to {} for φ ± 2°)", percent(less), percent(more))
                }
                (Some(less), _) => format!(" ({} for φ − 2°)", percent(less)),
                _ => String::new(),
            };
            let rigid = on_rigid_ground(assessed).unwrap_or_default();
            format!("the ground fails at {}{range}.{rigid}", verdict::share_of_loads(assessed, factor))
        }
        Departure::At { factor, verdict } => {
            let goes = verdict
                .map_or_else(|| "it moves".to_owned(), |verdict| format!("it {}", predicate(Some(verdict))));
            let less = less.filter(|less| *less < factor).map_or(String::new(), |less| {
                format!("; with an angle of friction 2° less the ground fails before, at {}", percent(less))
            });
            format!("at {} {goes}{less}.", verdict::share_of_loads(assessed, factor))
        }
        Departure::Never if assessed.rises() => format!("no multiple of {loads} moves it."),
        Departure::Never => String::new(),
    }
}

/// What would first happen if the ground bore everything.
fn on_rigid_ground(assessed: &Assessed) -> Option<String> {
    match assessed.situation.outcome().ok()?.departure {
        Departure::At { factor, verdict } => {
            Some(format!(" On rigid ground it {} at {}.", predicate(verdict), percent(factor)))
        }
        Departure::Never => Some(" On rigid ground nothing moves it.".to_owned()),
        Departure::AtOnce { .. } => None,
    }
}

/// What first happens on springs in time, under the loads under which it takes the least of them.
fn in_time(assessment: &Assessment) -> Option<String> {
    let events =
        assessment.all.iter().filter_map(|assessed| Some((assessed, ground::first_event(assessed)?)));
    let (assessed, event) =
        events.min_by(|(_, one), (_, two)| one.load_factor.total_cmp(&two.load_factor))?;
    let head = place(assessment, assessed).map_or(String::new(), |name| format!("under {}, ", quoted(&name)));
    Some(capital(&(head + &ground::in_time(event))))
}
