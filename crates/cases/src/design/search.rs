//! The least value that meets a target.

use super::target::Target;
use super::{DesignError, Varied, least, load_factor, overturning, sliding, with_unit};
use crate::assess::Assessment;
use crate::couple::Variable;
use crate::layout::digits;

/// How many parts a bracket is cut into to find where the target is first met.
const PARTS: u32 = 400;

/// How near, relatively, the value found is to one that fails.
const NEAR: f64 = 1e-9;

/// The least value of a bracket that meets a target.
pub(super) struct Found {
    pub(super) value: f64,
    pub(super) answer: Assessment,
    /// What there is just below.
    pub(super) below: Below,
    /// Beyond this value the target fails again, within the bracket, and why.
    pub(super) until: Option<(f64, String)>,
}

/// What there is just below the value found.
pub(super) enum Below {
    /// It is the lower end of the bracket.
    End,
    /// The target fails: in words, why.
    Fails(String),
    /// The case makes no sense: in words, why.
    NoCase(String),
}

/// A value with what it comes to, or why it does not.
struct Trial {
    value: f64,
    answer: Result<Assessment, DesignError>,
    met: bool,
}

/// Cuts the bracket, takes the first part at whose end the target is met, and halves that.
pub(super) fn search(
    varied: &Varied<'_>,
    variable: &Variable,
    target: Target,
    [from, to]: [f64; 2],
) -> Result<Found, DesignError> {
    let attempt = |value: f64| {
        let answer = varied.answer(variable, value);
        let met = answer.as_ref().is_ok_and(|answer| target.is_met(answer));
        Trial { value, answer, met }
    };
    let mut scan: Vec<Trial> =
        (0..=PARTS).map(|i| attempt(from + (to - from) * (f64::from(i) / f64::from(PARTS)))).collect();
    let Some(first) = scan.iter().position(|trial| trial.met) else {
        return Err(unmet(scan, variable, target, [from, to]));
    };
    let size = from.abs().max(to.abs());

    // Beyond the first value that meets it, the target may fail again.
    let again = scan[first..].iter().position(|trial| !trial.met).map(|later| first + later);
    let until = again.map(|again| {
        let failing = scan.swap_remove(again);
        let meeting = attempt(scan[again - 1].value);
        let (failing, meeting) = halve(&attempt, size, failing, meeting);
        (meeting.value, why(&attempt, target, meeting.value, failing))
    });
    scan.truncate(first + 1);
    let met = scan.pop().expect("the trial that meets the target");
    let (met, below) = match scan.pop() {
        None => (met, Below::End),
        Some(below) => {
            let (failing, meeting) = halve(&attempt, size, below, met);
            let fails = failing.answer.is_ok();
            let why = why(&attempt, target, meeting.value, failing);
            (meeting, if fails { Below::Fails(why) } else { Below::NoCase(why) })
        }
    };
    Ok(Found { value: met.value, answer: met.answer?, below, until })
}

/// Brings a value that fails and one that meets the target together, in a bracket whose values are of a size.
fn halve(
    attempt: &impl Fn(f64) -> Trial,
    size: f64,
    mut failing: Trial,
    mut meeting: Trial,
) -> (Trial, Trial) {
    // Near zero, what counts is the size of the bracket.
    while (meeting.value - failing.value).abs() > NEAR * meeting.value.abs().max(1e-3 * size) {
        let middle = attempt(failing.value + (meeting.value - failing.value) / 2.0);
        if middle.met {
            meeting = middle;
        } else {
            failing = middle;
        }
    }
    // A round number as near is as good: 0 rather than 1e-15.
    let step = 10_f64.powf((2.0 * NEAR * meeting.value.abs().max(1e-3 * size)).log10().ceil());
    let round = attempt((meeting.value / step).round() * step + 0.0);
    if round.met { (failing, round) } else { (failing, meeting) }
}

/// Why a value beside `met` fails. Of a case that makes no sense it is said with a round value, a little farther away.
fn why(attempt: &impl Fn(f64) -> Trial, target: Target, met: f64, failing: Trial) -> String {
    let error = match failing.answer {
        Ok(answer) => return target.binding(&answer),
        Err(error) => error,
    };
    let step = 10_f64.powf(failing.value.abs().max(1e-12).log10().floor() - 3.0);
    let towards = if failing.value > met { f64::ceil } else { f64::floor };
    let round = attempt(towards(failing.value / step) * step);
    round.answer.err().unwrap_or(error).to_string()
}

fn unmet(scan: Vec<Trial>, variable: &Variable, target: Target, [from, to]: [f64; 2]) -> DesignError {
    let mut best: Option<(f64, f64, Assessment)> = None;
    let mut worst = f64::INFINITY;
    let mut first_error = None;
    for Trial { value, answer, .. } in scan {
        match answer {
            Ok(answer) => {
                let score = target.score(&answer);
                worst = worst.min(score);
                if best.as_ref().is_none_or(|(best, ..)| score > *best) {
                    best = Some((score, value, answer));
                }
            }
            Err(error) => {
                first_error.get_or_insert(error);
            }
        }
    }
    let Some((score, value, answer)) = best else {
        return first_error.expect("a trial without outcome has an error");
    };
    if score == worst {
        let name = variable.name().to_owned();
        let binding = target.binding(&answer);
        return DesignError::NoInfluence { name, target, binding };
    }
    let best = format!(
        "the best of {} values tried is {}, with safety factors {} and {}, leaving rest at {} times the load",
        PARTS + 1,
        with_unit(value, variable),
        digits(least(&answer, sliding)),
        digits(least(&answer, overturning)),
        digits(least(&answer, load_factor)),
    );
    let [from, to] = [from, to].map(|value| with_unit(value, variable));
    DesignError::Unmet { name: variable.name().to_owned(), from, to, target, best }
}
