//! The answer in words and numbers.

use std::fmt::Write;

use standfast::Mode;
use standfast_motion::{End, Event, Impact, MotionOutcome, Why};

use super::summary::near;
use super::{FollowedMotion, MotionView};
use crate::assess::met_words;
use crate::layout::{columns, digits, paragraph, row, significant};
use crate::summary::capital;
use crate::units::Dimension;
use standfast_answers::motion::{Copies, CopyQuantile, PointAnswer, Spread};
use standfast_probability::sample::Estimate;

/// So many events are shown one by one.
const SHOWN: usize = 24;

/// Rows of words, numbers and units.
pub type Rows = Vec<Vec<String>>;

/// The answer in words, then in numbers, in the units of the case; the view may show every event. Of one motion alone the words stand in its summary.
pub(super) fn render(followed: &FollowedMotion, view: &MotionView, alone: bool) -> String {
    let case = &followed.case;
    let mut text = String::new();
    if let Some(situation) = &case.situation {
        let _ = writeln!(text, "Under {situation}:\n");
    }
    if !alone {
        let _ = writeln!(text, "{}", paragraph(&verdict(followed), 0));
    }
    text += &columns(&number_rows(followed), 2, &[1]);
    let _ = write!(text, "\nEvents\n{}", events(followed, view));
    let _ = write!(
        text,
        "\nEnergy per mass{}\n{}",
        if case.si { ", J/kg" } else { "" },
        columns(&energy_rows(followed), 2, &[1])
    );
    let _ = writeln!(text, "\n{}", uniqueness(followed));
    if let Some(near) = near(followed).filter(|_| !alone) {
        text += &paragraph(&near, 0);
    }
    for warning in &followed.warnings {
        let _ = writeln!(text, "Note ({}): {}.", warning.name, warning.words);
    }
    for point in &followed.points {
        text += &of_point(followed, point);
    }
    if let Some(copies) = &followed.copies {
        text += &of_copies(followed, copies);
    }
    if !case.criteria.is_empty() {
        let _ = write!(text, "\nCriteria\n{}", criteria(followed));
    }
    text
}

/// Accelerations of a point of the body.
fn of_point(followed: &FollowedMotion, answer: &PointAnswer) -> String {
    let (case, outcome) = (&followed.case, &followed.outcome);
    let [m, s, rate, acceleration] = if case.si { [" m", " s", " m/s", " m/s²"] } else { [""; 4] };
    let mut rows = vec![row!["", "least", "at t =", "largest", "at t ="]];
    let words = [
        "acceleration to the right",
        "acceleration upwards",
        "felt along the base of the body",
        "felt along its side, with gravity",
    ];
    for (words, extremes) in words.into_iter().zip(answer.extremes) {
        let [least, largest] = [extremes.least, extremes.largest]
            .map(|[value, t]| [number(value) + acceleration, number(t) + s]);
        rows.push(vec![
            words.to_owned(),
            least[0].clone(),
            least[1].clone(),
            largest[0].clone(),
            largest[1].clone(),
        ]);
    }
    let [x, y] = answer.point.at;
    let head = format!(
        "\nPoint {}, {}{m} right of and {}{m} above the centre of mass\n",
        answer.point.name,
        number(x),
        number(y)
    );
    let jump = answer.largest_jump(outcome).map_or(String::new(), |[jump, t]| {
        let words = format!(
            "At an impact it is infinite: there the velocity of the point jumps, by {}{rate} at most, at t = {}{s}.",
            number(jump),
            number(t)
        );
        paragraph(&words, 2)
    });
    head + &columns(&rows, 2, &[1, 2, 3, 4]) + &jump
}

/// Outcomes of copies: how many end how, quantiles, and when they part from the case itself.
fn of_copies(followed: &FollowedMotion, copies: &Copies) -> String {
    let [m, rad] = if followed.case.si { [" m", " rad"] } else { ["", ""] };
    let quantile = |quantile: &CopyQuantile, unit: &str| {
        let shown =
            |value: f64| if value.is_finite() { number(value) + unit } else { "overturned".to_owned() };
        let within = quantile
            .interval
            .map_or(String::new(), |[low, high]| format!("{} … {}", shown(low), shown(high)));
        (shown(quantile.value), within)
    };
    let mut rows = vec![row!["copies", "", "95 %"]];
    let share = |share: &Estimate| format!("{} … {}", number(share.low), number(share.high));
    rows.push(row!["  overturn", copies.overturning().to_string(), share(&copies.overturned)]);
    rows.push(row![
        "  have the verdict above",
        number(copies.same_verdict.value),
        share(&copies.same_verdict)
    ]);
    for (what, quantiles, unit) in [
        ("largest |θ|", copies.max_theta(), rad),
        ("|slide|", copies.slide(), m),
        ("largest slide", copies.max_slide(), m),
    ] {
        if quantiles.iter().all(|one| one.value == 0.0) {
            if !quantiles.is_empty() {
                rows.push(row![format!("  {what}, at least 95 % of them"), format!("0{unit}"), ""]);
            }
            continue;
        }
        for one in &quantiles {
            let (value, within) = quantile(one, unit);
            rows.push(row![format!("  {what}, {} % stay below", number(100.0 * one.share)), value, within]);
        }
    }
    let mut sentences = Vec::new();
    if let Some(differs) = &copies.differs {
        sentences.push(format!(
            "Of {} copies an event differs from those above, at t = {}{} in the median and at t = {}{} at the earliest.",
            differs.copies,
            number(differs.t[0]),
            seconds(followed),
            number(differs.t[1]),
            seconds(followed)
        ));
    }
    if copies.cut > 0 {
        sentences.push(format!("In {} copies a ratio or a restitution is cut at its limit.", copies.cut));
    }
    let each = copies.names.iter().zip(&copies.spreads);
    let (by, names): (String, Vec<String>) = match copies.asked.spread {
        Spread::Even(spread) => (format!(", by {} %", number(100.0 * spread)), copies.names.clone()),
        Spread::Named(_) => {
            (String::new(), each.map(|(name, σ)| format!("{name} by {} %", number(100.0 * σ))).collect())
        }
    };
    let names = names.join(", ");
    sentences.push(format!("Numbers that differ{by} (seed {}): {names}.", copies.asked.seed));
    let head = format!("\nOf {} copies\n", copies.rows.len());
    head + &columns(&rows, 2, &[1]) + &sentences.iter().map(|words| paragraph(words, 2)).collect::<String>()
}

/// The unit of times, with a space before it, if they have one.
fn seconds(followed: &FollowedMotion) -> &'static str {
    if followed.case.si { " s" } else { "" }
}

fn number(x: f64) -> String {
    digits(x)
}

/// How far the body got, behind the verdict; nothing of one that rests, or that is gone.
pub(super) fn far(followed: &FollowedMotion) -> String {
    let (outcome, case) = (&followed.outcome, &followed.case);
    let slide = outcome.slide;
    let moved = outcome.events.iter().any(|event| event.state != Mode::Rest);
    if !moved || outcome.overturned() {
        return String::new();
    }
    let mut parts = Vec::new();
    if slide != 0.0 {
        let metres = if case.si { " m" } else { "" };
        let way = if slide < 0.0 { "left" } else { "right" };
        parts.push(format!("it has slid {}{metres} to the {way}", number(slide.abs())));
    }
    if outcome.max_theta > 0.0 {
        parts.push(format!(
            "it turned by {}° at most, {} % of the angle at which it tips over",
            significant(outcome.max_theta.to_degrees(), 3),
            significant(100.0 * followed.of_balance(), 3)
        ));
    }
    if parts.is_empty() { String::new() } else { format!(" {}.", capital(&parts.join("; "))) }
}

/// Outcome for the body, in a sentence.
pub fn verdict(followed: &FollowedMotion) -> String {
    outcome_words(followed, number)
}

/// Outcome for the body, in a sentence, with the digits that a caption has.
pub(super) fn caption(followed: &FollowedMotion) -> String {
    outcome_words(followed, |time| significant(time, 4))
}

fn outcome_words(followed: &FollowedMotion, number: impl Fn(f64) -> String) -> String {
    let (outcome, s) = (&followed.outcome, seconds(followed));
    let at = |event: Option<&Event>| event.map_or_else(|| "0".to_owned(), |event| number(event.t)) + s;
    let moves = outcome.events.iter().find(|event| event.state != Mode::Rest);
    let goes_on = || format!("the loads go on to t = {}{s}", number(outcome.loads_end));
    let Some(first) = moves else {
        return match outcome.is_cut_off() {
            true => {
                format!("The body stays at rest until t = {}{s}; {}.", number(outcome.t_final), goes_on())
            }
            false if outcome.end == End::Time => {
                format!(
                    "The body stays at rest until t = {}{s}, when the time is up.",
                    number(outcome.t_final)
                )
            }
            false => "The body stays at rest.".to_owned(),
        };
    };
    let begins = match first.why {
        Why::Start if first.t > 0.0 => format!("From t = {}{s} on the body", number(first.t)),
        Why::Start => "From the start the body".to_owned(),
        _ => format!("At t = {}{s} the body leaves rest: it", number(first.t)),
    };
    let last = outcome.events.last();
    let ends = match outcome.end {
        End::AtRest => {
            format!("It comes to rest at t = {}{s}.", number(outcome.t_rest.unwrap_or(outcome.t_final)))
        }
        End::Overturned => format!("It overturns at t = {}.", at(last)),
        End::Time => {
            let moves =
                if last.is_some_and(|event| event.state == Mode::Rest) { "rests" } else { "still moves" };
            let more = if outcome.is_cut_off() { format!("; {}", goes_on()) } else { String::new() };
            format!("It {moves} at t = {}, when the time is up{more}.", at(last))
        }
        End::NoContinuation => {
            format!(
                "At t = {} no state satisfies all conditions, and the motion is not followed further.",
                at(last)
            )
        }
        End::TooManyEvents => {
            format!(
                "After {} events, at t = {}, the motion is not followed further.",
                outcome.events.len(),
                at(last)
            )
        }
    };
    let past = if outcome.past_balance && outcome.end != End::Overturned {
        " It was past its point of balance, and came back."
    } else {
        ""
    };
    format!("{begins} {}. {ends}{past}", first.state.words())
}

/// Criteria on the motion as text, the governing one first.
fn criteria(followed: &FollowedMotion) -> String {
    let checks = followed.checks();
    let mut rows = vec![row!["criterion", "required", "value", "utilisation", ""]];
    rows.extend(checks.iter().map(|check| {
        row![
            check.criterion.name(),
            check.criterion.required(check.si),
            check.value_words(),
            check.utilisation_words(),
            check.met_words(),
        ]
    }));
    let met = met_words(checks.iter().map(|check| (check.criterion.name(), check.met)));
    columns(&rows, 2, &[3]) + &paragraph(&met, 2)
}

/// Words on a number that is not zero; none if it is.
fn when(number: f64, words: impl Fn() -> String) -> String {
    if number == 0.0 { String::new() } else { words() }
}

/// How the body bounces, and the ratio that was used, where the law has it follow from something.
fn impacts(followed: &FollowedMotion) -> String {
    let (outcome, problem) = (&followed.outcome, &followed.case.problem);
    let mut parts = Vec::new();
    if let (Some(ratio), Impact::Contact(_) | Impact::Points(_)) = (problem.ratio(), problem.impact) {
        parts.push(format!("each leaves {} of the rate of rotation", number(ratio)));
    }
    if outcome.bounces > 0 {
        let times =
            if outcome.bounces == 1 { "once".to_owned() } else { format!("{} times", outcome.bounces) };
        let gap = match followed.case.si {
            true => Dimension::Length.written(outcome.max_gap),
            false => number(outcome.max_gap),
        };
        parts.push(format!("it bounces {times}, at most {gap} above the base"));
    }
    parts.join("; ")
}

/// The numbers of the answer: what each is, the number with its unit, and when or how much of what it is.
pub fn number_rows(followed: &FollowedMotion) -> Rows {
    let (case, outcome) = (&followed.case, &followed.outcome);
    let s = seconds(followed);
    let [m, rad] = if case.si { [" m", " rad"] } else { ["", ""] };
    let row = |words: &str, value: f64, unit: &str, more: String| {
        vec![words.to_owned(), number(value) + unit, more]
    };
    vec![
        {
            let slide = outcome.slide;
            let way = if slide < 0.0 { "to the left" } else { "to the right" };
            row("slide", slide.abs(), m, when(slide, || way.to_owned()))
        },
        row(
            "largest slide",
            outcome.max_slide,
            m,
            when(outcome.max_slide, || format!("at t = {}{s}", number(outcome.t_max_slide))),
        ),
        row(
            "largest |θ|",
            outcome.max_theta,
            rad,
            when(outcome.max_theta, || {
                let share = significant(100.0 * followed.of_balance(), 3);
                let degrees = significant(outcome.max_theta.to_degrees(), 3);
                let at = number(outcome.t_max_theta);
                format!("{degrees}°, {share} % of the angle at which it tips over; at t = {at}{s}")
            }),
        ),
        row("θ at the end", outcome.theta, rad, String::new()),
        vec!["impacts".to_owned(), outcome.impacts.to_string(), impacts(followed)],
    ]
}

fn events(followed: &FollowedMotion, view: &MotionView) -> String {
    let how = format!("; {} shows them", view.interface.all());
    columns(&events_shown(followed, view.all, &how), 2, &[])
}

/// The events: when, why, and the state that goes on; of more than 24 the first and the last.
pub fn event_rows(followed: &FollowedMotion) -> Rows {
    events_shown(followed, false, "")
}

/// The events, of many the first and the last; `how` says how to see the others.
fn events_shown(followed: &FollowedMotion, all: bool, how: &str) -> Rows {
    let s = seconds(followed);
    let events = &followed.outcome.events;
    // Impacts follow each other ever faster: where four digits do not tell them apart, a fifth tells most, and more would be noise.
    let at = |event: &Event, digits: usize| significant(event.t, digits);
    let hidden = |pair: &[Event]| pair[0].t != pair[1].t && at(&pair[0], 4) == at(&pair[1], 4);
    let digits = if events.windows(2).any(hidden) { 5 } else { 4 };
    let row = |event: &Event| {
        let others = event.consistent.without(Some(event.state));
        let also = if others.is_empty() { String::new() } else { format!(" (or {others})") };
        vec![
            format!("t = {}{s}", at(event, digits)),
            event.why.words().to_owned(),
            format!("{}{also}", event.state.symbol()),
        ]
    };
    if all || events.len() <= SHOWN {
        return events.iter().map(row).collect();
    }
    let (head, tail) = (SHOWN * 2 / 3, SHOWN / 3);
    let mut rows: Vec<Vec<String>> = events[..head].iter().map(row).collect();
    let left = events.len() - head - tail;
    rows.push(vec!["…".to_owned(), format!("{left} more{how}"), String::new()]);
    rows.extend(events[events.len() - tail..].iter().map(row));
    rows
}

/// The balance of energy, J/kg of a body.
pub fn energy_rows(followed: &FollowedMotion) -> Rows {
    let outcome = &followed.outcome;
    let row = |words: &str, value: f64| vec![words.to_owned(), number(value)];
    vec![
        row("work of the loads", outcome.work),
        row("lost to friction", outcome.friction_loss),
        row("lost at impacts", outcome.impact_loss),
        row("gained as motion", outcome.kinetic),
        row("gained as height", outcome.potential),
        vec!["unaccounted for".to_owned(), lacks(outcome)],
    ]
}

/// Residual of the balance of energy; not the rounding errors, which are others on another machine.
fn lacks(outcome: &MotionOutcome) -> String {
    let terms =
        [outcome.work, outcome.friction_loss, outcome.impact_loss, outcome.kinetic, outcome.potential];
    let largest = terms.into_iter().fold(0.0, |most: f64, term| most.max(term.abs()));
    let lacks = outcome.energy_residual();
    if lacks.abs() <= 1e-12 * largest { "0".to_owned() } else { format!("{lacks:.1e}") }
}

/// Sentence on the uniqueness of the answer.
pub fn uniqueness(followed: &FollowedMotion) -> String {
    if followed.outcome.unique {
        return "The motion is unique.".to_owned();
    }
    "The motion is not unique: at an event several states satisfy all conditions. It goes on with the first of rest, slide, \
     slide-rock, rock, flight."
        .to_owned()
}
