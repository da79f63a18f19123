//! The least value that meets a target.

use super::outcome::Outcome;
use super::target::Target;
use super::vary::Variable;
use super::{Chain, DesignError, with_unit};
use crate::case::Case;
use crate::layout::digits;

/// How many parts a bracket is cut into to find where the target is first met.
const PARTS: u32 = 400;

/// How near, relatively, the value found is to one that fails.
const NEAR: f64 = 1e-9;

/// The least value of a bracket that meets a target.
pub(super) struct Found {
    pub(super) value: f64,
    pub(super) outcome: Outcome,
    /// What fails just below; `None` if the value is the bracket's lower end or the case makes no sense below.
    pub(super) binding: Option<String>,
    /// Whether it is the bracket's lower end.
    pub(super) at_lower_end: bool,
    /// Beyond this value the target fails again, within the bracket, and why.
    pub(super) until: Option<(f64, String)>,
}

/// A value with what it comes to, or why it does not.
struct Trial {
    value: f64,
    outcome: Result<Outcome, DesignError>,
    met: bool,
}

/// Cuts the bracket, takes the first part at whose end the target is met, and halves that.
pub(super) fn search(
    chain: &Chain<'_>,
    case: &Case,
    variable: &Variable,
    target: Target,
    [from, to]: [f64; 2],
) -> Result<Found, DesignError> {
    let attempt = |value: f64| {
        let outcome = chain.outcome(&variable.replacements(case, value));
        let met = outcome.as_ref().is_ok_and(|outcome| target.is_met(outcome));
        Trial { value, outcome, met }
    };
    let scan: Vec<Trial> =
        (0..=PARTS).map(|i| attempt(from + (to - from) * (f64::from(i) / f64::from(PARTS)))).collect();
    let Some(first) = scan.iter().position(|trial| trial.met) else {
        return Err(unmet(scan, variable, target, [from, to]));
    };

    let mut trials = scan.into_iter().skip(first.saturating_sub(1));
    let mut met = trials.next().expect("there is a trial");
    let (mut binding, at_lower_end) = (None, first == 0);
    if !at_lower_end {
        let below = met;
        let above = trials.next().expect("a trial that meets the target");
        let (failing, meeting) = halve(&attempt, below, above);
        binding = failing.outcome.ok().map(|outcome| target.binding(&outcome));
        met = meeting;
    }
    let mut last_met = Trial { value: met.value, outcome: chain.outcome(&[]), met: true };
    let mut until = None;
    for trial in trials {
        if trial.met {
            last_met = trial;
        } else {
            let (failing, meeting) = halve(&attempt, trial, last_met);
            let reason = match failing.outcome {
                Ok(outcome) => target.binding(&outcome),
                Err(error) => error.to_string(),
            };
            until = Some((meeting.value, reason));
            break;
        }
    }
    let Trial { value, outcome, .. } = met;
    Ok(Found { value, outcome: outcome?, binding, at_lower_end, until })
}

/// Brings a value that fails and one that meets the target together.
fn halve(attempt: &impl Fn(f64) -> Trial, mut failing: Trial, mut meeting: Trial) -> (Trial, Trial) {
    while (meeting.value - failing.value).abs() > NEAR * meeting.value.abs() {
        let middle = attempt(failing.value + (meeting.value - failing.value) / 2.0);
        if middle.met {
            meeting = middle;
        } else {
            failing = middle;
        }
    }
    (failing, meeting)
}

fn unmet(scan: Vec<Trial>, variable: &Variable, target: Target, [from, to]: [f64; 2]) -> DesignError {
    let mut best: Option<(f64, f64, Outcome)> = None;
    let mut first_error = None;
    for Trial { value, outcome, .. } in scan {
        match outcome {
            Ok(outcome) => {
                let score = target.score(&outcome);
                if best.as_ref().is_none_or(|(best, ..)| score > *best) {
                    best = Some((score, value, outcome));
                }
            }
            Err(error) => {
                first_error.get_or_insert(error);
            }
        }
    }
    let Some((_, value, outcome)) = best else {
        return first_error.expect("a trial without outcome has an error");
    };
    let best = format!(
        "the best is {}, with safety factors {} and {}, leaving rest at {} times the load",
        with_unit(value, variable),
        digits(outcome.sliding()),
        digits(outcome.overturning()),
        digits(outcome.first_load_factor()),
    );
    let [from, to] = [from, to].map(|value| with_unit(value, variable));
    DesignError::Unmet { name: variable.name.clone(), from, to, target, best }
}
