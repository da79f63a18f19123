//! Contents of a `[storm]` table.

use standfast::number::exact;

use super::{Pulse, Storm, Tau0};
use crate::case::check_ranges;
use crate::error::{Fault, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Key, Table};
use standfast_inputs::random::RandomProblem;

/// The storm of inputs, where they have one.
///
/// # Errors
/// If it lacks something, or its waves are no whole number.
pub(in crate::random) fn storm(inputs: &Inputs) -> Result<Option<Storm>, Fault> {
    if !inputs.has(Table::Storm) {
        return Ok(None);
    }
    check_ranges(inputs)?;
    let other = |words: &str| Problem::from(RandomProblem::Other(words.to_owned()));
    let lacks = |words: &str| Fault::new(other(&format!("[storm] lacks {words}")), Table::Storm);
    let number = |key| inputs.number(key);
    let (count, key) = match (number(Key::StormWaves), number(Key::StormDuration), number(Key::StormPeriod)) {
        (Some(waves), None, None) => (waves, Key::StormWaves),
        (None, Some(duration), Some(period)) => ((duration / period).round(), Key::StormDuration),
        _ => return Err(lacks("either `waves`, their number in a storm, or `duration` and `period`")),
    };
    if count < 1.0 || count.fract() != 0.0 || count > 1e9 {
        let (what, expected) = ("`waves`".to_owned(), "a whole number of waves".to_owned());
        let problem = RandomProblem::Value { what, written: exact(count), expected };
        return Err(Fault::new(problem.into(), key));
    }
    let tau0 = match inputs.get(Key::StormTau0) {
        Some(Value::Choice(_)) => Tau0::Formula,
        Some(Value::Number(tau0)) => Tau0::Given(*tau0),
        _ => return Err(lacks("`tau0`, the duration of a wave's pulse, or \"shimosako-takahashi\"")),
    };
    let asked = inputs.choice(Key::StormPulse);
    let pulse = Pulse::ALL.into_iter().find(|pulse| Some(pulse.name()) == asked).unwrap_or_default();
    let is_cut = inputs.truth(Key::StormCut).unwrap_or(true);
    Ok(Some(Storm { waves: count as u64, tau0, pulse, is_cut }))
}
