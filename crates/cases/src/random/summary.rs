//! Top of the probabilities: criterion, the probability that was asked for with its period, and what it hangs on.

use standfast_answers::results::ResultValue;
use standfast_probability::sample::Estimate;

use super::text::{below_or, probability, within};
use super::{
    ChanceCriterion, Chances, Fragility, FragilityPoint, Happening, LifeChances, Overturning, PeakChances,
    Probability, Sliding, Stood,
};
use crate::json::RequiredBound;
use crate::key::Key;
use crate::layout::{apart, digits, factor, significant};
use crate::summary::{GoverningCriterion, Summary, ToldCriterion, criteria, listed, warned_of_case, years};
use standfast_model::Bound;

/// So few records tell nothing of how the next one differs.
pub(super) const FEW: usize = 3;

/// Share of what moves the body of which one mode alone is spoken.
const NEARLY_ALL: f64 = 0.99;

pub(super) fn summary(answer: &Probability) -> Summary {
    let told: Vec<ToldCriterion> = answer.criteria.iter().map(|check| told(answer, check)).collect();
    let (warnings, warned) = warned_of_case(&answer.warnings());
    Summary {
        criteria: criteria(&told),
        answer: asked(answer),
        met: (!answer.criteria.is_empty()).then(|| answer.criteria.iter().all(ChanceCriterion::is_met)),
        governing: answer.criteria.first().map(|check| GoverningCriterion {
            criterion: check.criterion.name(),
            situation: None,
            value: ResultValue::Number(check.counted),
            required: RequiredBound::Number(check.required()),
            utilisation: Some(check.utilisation()),
        }),
        near: near(answer),
        warnings,
        warned,
    }
}

/// A criterion with its value, the unsafe end of the interval.
fn told(answer: &Probability, check: &ChanceCriterion) -> ToldCriterion {
    let (counted, bound) = words(check);
    let least = matches!(check.criterion.bound, Bound::AtLeast(_));
    let (end, sign) = if least { ("lower", "≥") } else { ("upper", "≤") };
    let of = within(check.estimate, &probability)
        .map_or(String::new(), |_| format!(", the {end} end of its interval,"));
    let words = format!(
        "{} {}{of} is {counted}, {sign} {bound} is asked (utilisation {})",
        check.criterion.full_name(),
        period_of(answer, check),
        used_words(check.utilisation())
    );
    ToldCriterion { name: check.criterion.name(), met: check.is_met(), words }
}

/// A utilisation as it is read.
fn used_words(utilisation: f64) -> String {
    if utilisation.is_finite() { factor(utilisation) } else { "infinite".to_owned() }
}

/// The value that counts and the bound of a criterion, as they are read.
pub fn words(check: &ChanceCriterion) -> (String, String) {
    let [value, bound] = &apart(&[check.counted, check.required()])[..] else { unreachable!("of two") };
    let value = if check.counted.is_finite() { value.as_str() } else { "infinite" };
    (check.criterion.with_unit(value), check.criterion.with_unit(bound))
}

/// Period that a criterion is of: one event, a year, or the years of a life.
pub fn period_of(answer: &Probability, check: &ChanceCriterion) -> String {
    if check.criterion.key == Key::GreatestNotRest {
        return period(answer).to_owned();
    }
    let of_storms = answer.sliding.as_ref().map(|sliding| sliding.years);
    let of_life = || answer.problem.as_ref()?.years();
    // Of any of several bodies it is the life where there is one.
    of_storms.or_else(of_life).map_or(period(answer).to_owned(), |life| format!("over {}", years(life)))
}

/// Period that the probabilities of the modes are of.
pub fn period(answer: &Probability) -> &'static str {
    // A storm without a body has waves, and no event beside them.
    if answer.problem.is_none() {
        return "under any one wave of a storm";
    }
    crate::summary::period(answer.random.iter().any(|number| number.yearly))
}

/// The probability that was asked for.
fn asked(answer: &Probability) -> String {
    if let Some(overturning) = &answer.overturning {
        return overturns(overturning);
    }
    if let Some(fragility) = &answer.fragility {
        return along(answer, fragility);
    }
    match (&answer.sliding, answer.situations.first()) {
        (Some(sliding), _) => slides(sliding),
        (None, Some(worst)) => moves(answer, worst),
        (None, None) => "Nothing is random.".to_owned(),
    }
}

fn not_resting(answer: &Probability) -> String {
    let what =
        if answer.has_joints() { "not every joint stays at rest" } else { "the body does not stay at rest" };
    format!("The probability that {what} {}", period(answer))
}

/// Share of a probability from which on what is not meant by it is told.
const NOTED: f64 = 1e-3;

/// Period of a life, as a heading.
pub fn over_life(life: &LifeChances) -> String {
    let events =
        life.events.map_or(String::new(), |rate| format!(" of {} events each on average", digits(rate)));
    format!("At least once in {}{events}", years(life.years))
}

/// What years at rest say of those that follow, in a sentence.
pub fn after_rest(life: &LifeChances) -> Option<String> {
    let Stood { years: stood, not_rest } = life.stood?;
    Some(format!(
        "That is of a body that is new. After {} at rest the probability in the next {} is {}.",
        years(stood),
        years(life.years),
        known(not_rest)
    ))
}

/// How far bodies of a row have things in common, in sentences.
pub fn of_row(answer: &Probability, worst: &Chances) -> Option<Vec<String>> {
    let row = answer.row?;
    let own = answer.random.iter().filter(|number| number.own).map(|number| number.name.clone());
    let own: Vec<String> = own.collect();
    let alone = answer.joined.as_ref().map_or(worst.not_rest, |joint| joint.not_rest).value;
    let bounds = |any: Estimate, alone: f64| {
        let apart = -((-alone).ln_1p() * row.bodies as f64).exp_m1();
        format!(
            "{}. Were all alike, it would be {}; had they nothing in common, {}",
            known(any),
            probability(alone),
            probability(apart)
        )
    };
    let event = format!(
        "At least one of {} bodies in a row, each with its own {}, does not stay at rest {}: {}.",
        row.bodies,
        listed(&own),
        period(answer),
        bounds(row.not_rest, alone)
    );
    let life = row.life.zip(worst.life.as_ref()).map(|(any, life)| {
        let stood = life
            .stood
            .map_or(String::new(), |stood| format!(", after {} at rest, all of them", years(stood.years)));
        // Of several sets of loads no life of one body is known.
        let told = match answer.joined {
            Some(_) => known(any),
            None => bounds(any, life.ahead().value),
        };
        format!("Over {}{stood}: {told}.", years(life.years))
    });
    Some(std::iter::once(event).chain(life).collect())
}

/// That the body moves in an event, and at least once in a life.
fn moves(answer: &Probability, worst: &Chances) -> String {
    let not_rest = answer.joined.as_ref().map_or(worst.not_rest, |joint| joint.not_rest);
    let place = match (&answer.joined, &worst.situation) {
        (Some(joint), _) => format!(" under any of the {} sets of loads", joint.count),
        (None, Some(situation)) => format!(" under {situation}"),
        (None, None) => String::new(),
    };
    let mut parts: Vec<_> = worst.modes.iter().filter(|(mode, _)| *mode != Happening::REST).collect();
    standfast::order::by_number(&mut parts, |one| -one.1.value);
    let most = parts.first().filter(|(_, e)| e.value >= NEARLY_ALL * worst.not_rest.value && e.value > 0.0);
    let goes = most.map_or(String::new(), |(mode, _)| match mode {
        Happening::First(_) => format!(" Then {}.", super::text::words(answer, *mode)),
        Happening::NoMode | Happening::NotABody => String::new(),
        _ => format!(" It then {}.", super::text::words(answer, *mode)),
    });
    let life = worst.life.as_ref().map_or(String::new(), |life| {
        let stood = life.stood.map_or(String::new(), |stood| {
            format!(", or {} after {} at rest", known(stood.not_rest), years(stood.years))
        });
        format!(" {}: {}{stood}.", over_life(life), known(life.not_rest))
    });
    let row = answer.row.map_or(String::new(), |row| {
        let of_life = row.life.zip(worst.life.as_ref());
        let life = of_life.map_or(String::new(), |(any, life)| {
            let stood = life.stood.map_or(String::new(), |stood| {
                format!(" after {} in which all of them rested", years(stood.years))
            });
            format!(", and {} over {}{stood}", known(any), years(life.years))
        });
        format!(" For any of {} in a row it is {} {}{life}.", row.bodies, known(row.not_rest), period(answer))
    });
    let impossible =
        worst.modes.iter().find(|(mode, _)| *mode == Happening::NotABody).map_or(0.0, |(_, e)| e.value);
    let impossible = match impossible > NOTED * worst.not_rest.value {
        true => format!(" Of it {} are draws that make no possible body.", probability(impossible)),
        false => String::new(),
    };
    format!("{} is {}{place}.{impossible}{goes}{life}{row}", not_resting(answer), known(not_rest))
}

/// How far the body slides in a life.
fn slides(sliding: &Sliding) -> String {
    let metres = |slide: f64| format!("{} m", digits(slide));
    let over = sliding.exceedance.last().map_or(String::new(), |over| {
        format!(", and by more than {:.2} m {}", over.slide, below_or(over.probability))
    });
    format!(
        "In {} the body slides {} on average{}. The probability that it slides at all is {}{over}.",
        years(sliding.years),
        metres(sliding.mean.value),
        within(sliding.mean, &metres).map_or(String::new(), |within| format!(" ({within})")),
        known(sliding.ever)
    )
}

/// That the body overturns, over the peak of the shaking.
fn overturns(overturning: &Overturning) -> String {
    let Overturning { points, fit, gravity, .. } = overturning;
    let motions = overturning.records.len() as u64 * overturning.bodies;
    let share = |e: Estimate| match e.value {
        0.0 => format!("0 in {motions} motions"),
        _ => probability(e.value),
    };
    let at = |point: &PeakChances| (share(point.overturned), digits(point.peak / gravity) + " g");
    let median = fit.filter(|_| overturning.records.len() >= FEW).map_or(String::new(), |fit| {
        format!(" By a lognormal curve half overturn at {} g.", significant(fit.median / gravity, 3))
    });
    format!("The probability of overturning in one shaking is {}.{median}", from_to(points.iter().map(at)))
}

/// That the body moves, along a number of the case.
fn along(answer: &Probability, fragility: &Fragility) -> String {
    let unit = fragility.unit();
    let at = |point: &FragilityPoint| {
        let place = format!("{} = {} {unit}", fragility.name, digits(fragility.in_unit(point.value)));
        (below_or(point.not_rest), place.trim_end().to_owned())
    };
    format!("{} is {}.", not_resting(answer), from_to(fragility.points.iter().map(at)))
}

/// Probabilities at the first and the last place of a curve.
fn from_to(mut points: impl DoubleEndedIterator<Item = (String, String)>) -> String {
    let (first, last) = (points.next(), points.next_back());
    let at = |(p, place): (String, String)| format!("{p} at {place}");
    [first, last].into_iter().flatten().map(at).collect::<Vec<_>>().join(" and ")
}

/// What the answer hangs on: records where motions are followed, else the number that matters most.
fn near(answer: &Probability) -> Option<String> {
    if let Some(overturning) = &answer.overturning {
        return records(overturning.records.len());
    }
    let worst = answer.situations.first().filter(|_| answer.fragility.is_none())?;
    if answer.sliding.is_some() {
        let year = format!("{} is {}.", not_resting(answer), known(worst.not_rest));
        return Some(
            [Some(year), matters(answer, worst)].into_iter().flatten().collect::<Vec<_>>().join(" "),
        );
    }
    let beta =
        worst.generalized().map(|beta| format!("That is a reliability index of {}.", significant(beta, 3)));
    let sentences: Vec<String> = [beta, matters(answer, worst)].into_iter().flatten().collect();
    (!sentences.is_empty()).then(|| sentences.join(" "))
}

/// Sentence on what so many records tell.
pub(super) fn records(count: usize) -> Option<String> {
    match count {
        0 => None,
        1 => Some(
            "One record tells nothing of another one: the intervals are those of further bodies.".to_owned(),
        ),
        count if count < FEW => {
            Some("Two records tell nothing of how records differ: take ten or more.".to_owned())
        }
        count => Some(format!("The intervals are those of a further record like these {count}.")),
    }
}

/// Sentence on the number that matters most.
fn matters(answer: &Probability, worst: &Chances) -> Option<String> {
    let point = worst.design_point.as_ref().filter(|_| answer.random.len() > 1)?;
    let most =
        (0..answer.random.len()).max_by(|a, b| point.alpha[*a].abs().total_cmp(&point.alpha[*b].abs()))?;
    let (name, known) = (&answer.random[most].name, worst.known.get(most)?);
    // What would be the same were it known, or of which nothing less is known than this, hangs on nothing that is shown.
    let is_bound = known.value == 0.0 && known.high > worst.not_rest.value;
    if is_bound || below_or(*known) == below_or(worst.not_rest) {
        return None;
    }
    Some(format!("It hangs most on {name}: were that known, the probability would be {}.", below_or(*known)))
}

/// A probability with its interval, where it has one.
fn known(e: Estimate) -> String {
    let value = below_or(e);
    within(e, &probability)
        .filter(|_| e.value > 0.0)
        .map_or(value.clone(), |within| format!("{value} ({within})"))
}
