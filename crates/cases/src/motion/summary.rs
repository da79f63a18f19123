//! Top of the answer in time: criteria, what becomes of the body, how near another answer is.

use standfast_answers::assess::AnyCheck;
use standfast_answers::motion::{Copies, MotionCheck, Spread, Strength};
use standfast_motion::divergence::Divergence;
use standfast_motion::strength::{Change, Tried, VerdictStrength};
use standfast_probability::sample::Estimate;

use super::FollowedMotion;
use super::text::{far, verdict};
use crate::json::CheckEntry;
use crate::layout::{digits, significant};
use crate::summary::{GoverningCriterion, Summary, ToldCriterion, criteria, criterion_words, quoted, warned};

/// Relative spread of inputs of which nothing else is known.
const SPREAD: f64 = 1e-3;

/// The top of the answers to a case, which is that of the worst.
pub(super) fn summary(answers: &[FollowedMotion]) -> Option<Summary> {
    answers.first().map(|worst| of(worst, answers.len()))
}

/// The top of one of so many answers.
pub(super) fn of(worst: &FollowedMotion, count: usize) -> Summary {
    let checks = worst.checks();
    let told = |check: &MotionCheck| {
        let any = AnyCheck::Motion(*check, 0);
        ToldCriterion { name: any.name(), met: check.met, words: criterion_words(&any, false) }
    };
    let told: Vec<ToldCriterion> = checks.iter().map(told).collect();
    let situation = worst.case.situation.clone().filter(|_| count > 1);
    let place = situation
        .as_ref()
        .map_or(String::new(), |name| format!("Under {}, the worst of {count}: ", quoted(name)));
    let gives_way = worst.warnings.iter().any(|warning| warning.name == "ground-left-out");
    let rigid = if gives_way { "On a rigid base, as [ground] is not followed in time: " } else { "" };
    let (warnings, warned) = warned(&worst.warnings, |warning| (warning.name, &warning.words));
    Summary {
        criteria: criteria(&told),
        met: worst.met(),
        governing: checks
            .first()
            .map(|check| GoverningCriterion::of(CheckEntry::of_motion(check), situation.clone())),
        answer: format!("{place}{rigid}{}{}", verdict(worst), far(worst)),
        near: near(worst),
        warnings,
        warned,
    }
}

/// Sentence on how many copies overturn.
fn of_copies(copies: &Copies) -> String {
    let (count, overturning) = (copies.rows.len(), copies.overturning());
    let many = match overturning {
        0 => format!("none of {count} copies"),
        all if all == count => format!("all of {count} copies"),
        some => format!("{some} of {count} copies"),
    };
    let Estimate { low, high, .. } = copies.overturned;
    let percent = |share: f64| significant(100.0 * share, 2);
    let [low, high] = [low, high].map(percent);
    let spread = match &copies.asked.spread {
        Spread::Even(spread) => format!("by {} %", percent(*spread)),
        Spread::Named(named) => {
            let each = named.iter().map(|(name, spread)| format!("{name} by {} %", percent(*spread)));
            format!("in {}", each.collect::<Vec<_>>().join(", "))
        }
    };
    let open = if (1..count).contains(&overturning) { ": one motion does not decide this" } else { "" };
    format!("It overturns in {many} whose numbers differ {spread} ({low} to {high} %){open}.")
}

/// How near another answer is; `None` where it was not looked for.
pub(super) fn near(followed: &FollowedMotion) -> Option<String> {
    let strength = followed.strength.as_ref().map(|strength| stronger(followed, strength));
    let divergence = followed.divergence.as_ref().map(|divergence| parts(followed, divergence));
    let copies = followed.copies.as_ref().map(of_copies);
    let words: Vec<String> =
        [copies, strength, divergence].into_iter().flatten().filter(|words| !words.is_empty()).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// What drives the motion, in a word.
fn drive(followed: &FollowedMotion) -> &'static str {
    let base = &followed.case.problem.base;
    if base.horizontal.is_some() || base.vertical.is_some() { "shaking" } else { "load" }
}

/// Peak of a multiple of the shaking, in brackets; none of a load, and of a body in pure numbers.
fn amount(followed: &FollowedMotion, factor: f64) -> String {
    let problem = &followed.case.problem;
    let Some(shaking) = problem.base.horizontal.as_ref().filter(|_| followed.case.si) else {
        return String::new();
    };
    let sideways = if problem.base.vertical.is_some() { " to the sides" } else { "" };
    format!(" ({} g{sideways})", significant(factor * shaking.peak() / problem.gravity, 3))
}

/// Sentences on the strength at which the verdict changes.
fn stronger(followed: &FollowedMotion, strength: &Strength) -> String {
    let drive = drive(followed);
    let mut sentences = Vec::new();
    match strength.onset {
        Some(onset) if onset > 0.0 => {
            let (times, amount) = (significant(onset, 3), amount(followed, onset));
            sentences.push(format!("It begins to move at {times} times this {drive}{amount}."));
        }
        None if followed.outcome.max_theta == 0.0 && followed.outcome.max_slide == 0.0 => {
            sentences.push(format!("No multiple of this {drive} moves it."));
        }
        _ => {}
    }
    let overturns = ["overturns it", "leaves it standing"];
    sentences.push(change(followed, &strength.overturning, overturns, |tried| tried.overturned));
    // What overturns is beyond every bound: that needs no sentence of its own.
    let is_news = |verdict: &&(f64, VerdictStrength)| {
        nearest(&verdict.1).is_none_or(|change| nearest(&strength.overturning) != Some(change))
    };
    if let Some((bound, verdict)) = strength.slide.as_ref().filter(is_news) {
        let metres = if followed.case.si { " m" } else { "" };
        let too_far = format!("slides it beyond {}{metres}", digits(*bound));
        let within = format!("keeps it within {}{metres}", digits(*bound));
        sentences.push(change(followed, verdict, [&too_far, &within], |tried| tried.is_beyond(*bound)));
    }
    if let Some((bound, verdict)) = strength.max_theta.as_ref().filter(is_news) {
        let degrees = significant(bound.to_degrees(), 3);
        let too_far = format!("turns it beyond {degrees}°");
        let within = format!("keeps it within {degrees}°");
        sentences
            .push(change(followed, verdict, [&too_far, &within], |tried| tried.is_turned_beyond(*bound)));
    }
    if verdicts(strength).any(is_open) {
        sentences.push("One motion does not decide this.".to_owned());
    }
    sentences.join(" ")
}

/// The verdicts on a motion that were looked for.
fn verdicts(strength: &Strength) -> impl Iterator<Item = &VerdictStrength> {
    let bounded = [&strength.slide, &strength.max_theta].into_iter().flatten().map(|(_, verdict)| verdict);
    std::iter::once(&strength.overturning).chain(bounded)
}

/// The change of a verdict that is nearest to the loads as they are.
fn nearest(verdict: &VerdictStrength) -> Option<Change> {
    match (verdict.up, verdict.down) {
        (Some(up), Some(down)) if 1.0 - down.factor < up.factor - 1.0 => Some(down),
        (Some(up), _) => Some(up),
        (None, down) => down,
    }
}

/// True if what is known of a load does not decide a verdict by one motion: a change as near as loads are never known, one to either side
/// that is near, or several within what is tried densely.
fn is_open(verdict: &VerdictStrength) -> bool {
    let within = |change: Option<Change>, distance: f64| {
        change.is_some_and(|change| (change.factor - 1.0).abs() <= distance + 1e-9)
    };
    let either = |distance: f64| within(nearest(verdict), distance);
    either(0.02)
        || (within(verdict.up, 0.05) && within(verdict.down, 0.05))
        || (verdict.windows && either(0.2))
}

/// The sentence on one verdict: what a motion does of which it holds, and what one of which it does not.
fn change(
    followed: &FollowedMotion,
    verdict: &VerdictStrength,
    does: [&str; 2],
    holds: impl Fn(&Tried) -> bool,
) -> String {
    let drive = drive(followed);
    let tried: &[Tried] = followed.strength.as_ref().map_or(&[], |strength| &strength.tried);
    let other = if verdict.verdict { does[1] } else { does[0] };
    let count = tried.len();
    let (from, to) = (tried[0].factor, tried[count - 1].factor);
    let Some(nearest) = nearest(verdict) else {
        return format!(
            "None of {count} factors from {} to {} on this {drive} {other}.",
            digits(from),
            digits(to)
        );
    };
    let off = nearest.factor - 1.0;
    let size = significant(100.0 * off.abs(), 2);
    let way = if off > 0.0 { "stronger" } else { "weaker" };
    let amount = amount(followed, nearest.factor);
    /// Between two that are tried a window of this width may lie unseen.
    const SEEN: f64 = 0.05;
    let head = match verdict.windows || off.abs() <= SEEN {
        true => format!("A {drive} {size} % {way}{amount} {other}{}", before(followed, nearest, way)),
        false => format!("Of {count} strengths tried, the nearest that {other} is {size} % {way}{amount}"),
    };
    let differ = |tried: &&Tried| holds(tried) != verdict.verdict;
    if verdict.windows {
        let near: Vec<&Tried> =
            tried.iter().filter(|tried| (tried.factor - 1.0).abs() <= 0.2 + 1e-9).collect();
        let others = near.iter().filter(|tried| differ(tried)).count();
        return match others {
            0 => format!("{head}; none of {} within 20 % does.", near.len()),
            1 => format!("{head}, as does 1 of {} within 20 %.", near.len()),
            _ => format!("{head}, as do {others} of {} within 20 %.", near.len()),
        };
    }
    let behind: Vec<&Tried> = tried.iter().filter(|tried| (tried.factor - 1.0) * off < 0.0).collect();
    let (side, end) = if off > 0.0 {
        ("weaker", format!("down to {}", digits(from)))
    } else {
        ("stronger", format!("up to {}", digits(to)))
    };
    format!("{head}; none of {} {side} ones, {end}, does.", behind.len())
}

/// The motion between the loads as they are and a change that is nearest to this and as they are, where it is so far from it that the
/// change may well come before.
fn before(followed: &FollowedMotion, Change { factor, same }: Change, way: &str) -> String {
    /// As many parts of the loads nobody tells apart.
    const NEAR: f64 = 0.02;
    let off = same - 1.0;
    if (factor - same).abs() <= NEAR || off * (factor - 1.0) <= 0.0 {
        return String::new();
    }
    format!(", one {} % {way}{} does not", significant(100.0 * off.abs(), 2), amount(followed, same))
}

/// Sentence on how far two motions part whose inputs differ a little.
fn parts(followed: &FollowedMotion, divergence: &Divergence) -> String {
    let outcome = &followed.outcome;
    if outcome.max_theta == 0.0 && outcome.max_slide == 0.0 {
        return String::new();
    }
    let value = significant(divergence.value, 2);
    let is_decided = followed.strength.as_ref().is_some_and(|strength| !verdicts(strength).any(is_open));
    match (divergence.value * SPREAD > 1.0, is_decided) {
        (true, true) => {
            format!("Divergence {value}: inputs known to 0.1 % do not tell when and how far it moves.")
        }
        (true, false) => {
            let more = if followed.copies.is_none() { " `--copies 40` says how often." } else { "" };
            format!(
                "Divergence {value}: of inputs known to 0.1 % one motion does not decide what becomes of the body.{more}"
            )
        }
        (false, _) => {
            let percent = significant(100.0 * divergence.value * SPREAD, 2);
            let unit = match divergence.of {
                standfast_motion::divergence::Diverging::Theta => "of the angle of balance",
                standfast_motion::divergence::Diverging::Slide => "of half the width",
            };
            format!(
                "Divergence {value}: 0.1 % more friction and height shift the motion by up to about {percent} % {unit}."
            )
        }
    }
}
