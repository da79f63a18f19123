//! What a small change of every number of a case does to its safety.

use standfast::Departure;

use super::{Varied, least, load_factor, overturning, sliding};
use crate::assess::{Assessed, Assessment};
use crate::couple::Variable;
use crate::error::CaseError;
use crate::key::Key;
use crate::parse::CaseFile;

/// By how much, relatively, a number is varied to either side.
const STEP: f64 = 1e-4;

/// How both safety factors and the load factor change if a number grows by 1 %; `None` where they are infinite or the number
/// can grow or shrink no more.
#[derive(Debug, Clone)]
pub struct Sensitivity {
    /// The number.
    pub variable: Variable,
    /// Its present value, SI.
    pub value: f64,
    /// Of SF_sliding, the least of all situations.
    pub sliding: Option<f64>,
    /// Of SF_overturning, about either corner, the least of all situations.
    pub overturning: Option<f64>,
    /// Of the load factor at which the body first leaves rest, the least of all situations.
    pub load_factor: Option<f64>,
}

/// The sensitivity of the case of a file to every number of it but zeros. What has to go with a number goes with it: the mass
/// with the width, the crest with the height.
///
/// # Errors
/// If the case makes no sense.
pub fn sensitivities(file: &CaseFile) -> Result<Vec<Sensitivity>, CaseError> {
    let case = file.case()?;
    Ok(all(&Varied { file, case: &case }))
}

/// The sensitivity to every number but zeros, which have no percent.
pub(super) fn all(varied: &Varied<'_>) -> Vec<Sensitivity> {
    // The caisson's width is the body's.
    let variables = Variable::all(varied.inputs()).filter(|id| id.key != Key::CaissonWidth).map(Variable::of);
    variables.filter_map(|variable| of(varied, variable)).collect()
}

fn of(varied: &Varied<'_>, variable: Variable) -> Option<Sensitivity> {
    let value = variable.value(varied.inputs(), varied.case);
    if value == 0.0 {
        return None;
    }
    let at = |step: f64| varied.answer(&variable, value * (1.0 + step)).ok();
    let (above, below) = (at(STEP), at(-STEP));
    let change = |of: fn(&Assessed) -> f64| {
        let least = |answer: &Option<Assessment>| Some(least(answer.as_ref()?, of));
        let difference = least(&above)? - least(&below)?;
        Some(difference / (2.0 * STEP) / 100.0).filter(|change| change.is_finite())
    };
    // Where the body moves at once, there is no load factor to change.
    let has_factor = |answer: &Option<Assessment>| {
        answer
            .as_ref()
            .is_some_and(|answer| !matches!(answer.governing().departure(), Departure::AtOnce { .. }))
    };
    let load_factor = change(load_factor).filter(|_| has_factor(&above) && has_factor(&below));
    let (sliding, overturning) = (change(sliding), change(overturning));
    Some(Sensitivity { variable, value, sliding, overturning, load_factor })
}
