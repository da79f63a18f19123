//! Contents of a `[storm]` table.

use standfast::number::exact;

use super::{Pulse, Storm, StormPart, Tau0};
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
    let combination = inputs.text(Key::StormCombination).map(str::to_owned);
    Ok(Some(Storm { waves: count as u64, tau0, pulse, is_cut, parts: parts(inputs)?, combination }))
}

/// The equal parts of the storm.
fn parts(inputs: &Inputs) -> Result<Vec<StormPart>, Fault> {
    let refused =
        |message: &str, key: Key| Err(Fault::new(RandomProblem::Other(message.to_owned()).into(), key));
    let [heights, rises] = [Key::StormFactors, Key::StormRises].map(|key| inputs.list(key));
    if let Some(heights) = heights {
        let largest = heights.iter().copied().fold(0.0, f64::max);
        if let Some(height) = heights.iter().find(|height| **height <= 0.0) {
            let message = format!(
                "`height_factors` of [storm] has {}; expected factors above 0, the largest of them 1, which is the peak",
                exact(*height)
            );
            return refused(&message, Key::StormFactors);
        }
        if largest != 1.0 {
            let message = format!(
                "`height_factors` of [storm] has {} for its largest; expected factors above 0, the largest of them 1, which is the peak",
                exact(largest)
            );
            return refused(&message, Key::StormFactors);
        }
    }
    if let (Some(heights), Some(rises)) = (heights, rises)
        && heights.len() != rises.len()
    {
        let message = format!(
            "[storm] has {} height_factors and {} level_rises; expected as many, one for each equal part of the storm",
            heights.len(),
            rises.len()
        );
        return refused(&message, Key::StormRises);
    }
    let count = heights.or(rises).map_or(1, <[f64]>::len);
    if count == 0 {
        return refused("[storm] has no parts; expected a number for each", Key::StormFactors);
    }
    let part = |place: usize| StormPart {
        height: heights.map_or(1.0, |heights| heights[place]),
        rise: rises.map_or(0.0, |rises| rises[place]),
    };
    Ok((0..count).map(part).collect())
}
