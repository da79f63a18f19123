//! What a small change of every number of a case does to its safety.

use super::Chain;
use super::outcome::Outcome;
use super::vary::Variable;
use crate::case::{Case, CaseError, Number};
use crate::units::Quantity;

/// By how much, relatively, a number is varied to either side.
const STEP: f64 = 1e-4;

/// How both safety factors and the first load factor change if a number grows by 1 %; `None` where they are
/// infinite or the number can grow or shrink no more.
#[derive(Debug, Clone)]
pub struct Sensitivity {
    pub(super) variable: Variable,
    /// Of SF_sliding, the least of all situations.
    pub sliding: Option<f64>,
    /// Of SF_overturning, about either corner, the least of all situations.
    pub overturning: Option<f64>,
    /// Of the load factor at which the body first leaves rest, the least of all situations.
    pub first_load_factor: Option<f64>,
}

impl Sensitivity {
    /// The number's table and key, e.g. `wave.period`.
    pub fn name(&self) -> &str {
        &self.variable.name
    }

    /// Its present value in SI units.
    pub fn value(&self) -> f64 {
        self.variable.present
    }

    /// What it measures; `None` for a plain number.
    pub fn quantity(&self) -> Option<Quantity> {
        self.variable.quantity
    }
}

/// The sensitivity of the case whose file is `text` to every number of it but zeros; `name` is what errors call the file.
/// What has to go with a number goes with it: the mass with the width, the crest with the height.
///
/// # Errors
/// If the case makes no sense.
pub fn sensitivities(name: &str, text: &str) -> Result<Vec<Sensitivity>, CaseError> {
    let chain = Chain { name, text };
    let case = chain.case(&[])?;
    Ok(all(&chain, &case))
}

/// The sensitivity to every number but zeros, which have no percent.
pub(super) fn all(chain: &Chain<'_>, case: &Case) -> Vec<Sensitivity> {
    // The caisson's width is the body's.
    let counts = |number: &&Number| number.value != 0.0 && number.id.key != "caisson_width";
    let numbers = case.numbers.iter().filter(counts);
    numbers.map(|number| of(chain, case, Variable::of(*number))).collect()
}

fn of(chain: &Chain<'_>, case: &Case, variable: Variable) -> Sensitivity {
    let at = |step: f64| chain.outcome(&variable.replacements(case, variable.present * (1.0 + step))).ok();
    let (above, below) = (at(STEP), at(-STEP));
    let change = |of: fn(&Outcome) -> f64| {
        let difference = of(above.as_ref()?) - of(below.as_ref()?);
        Some(difference / (2.0 * STEP) / 100.0).filter(|change| change.is_finite())
    };
    let sliding = change(Outcome::sliding);
    let overturning = change(Outcome::overturning);
    let first_load_factor = change(Outcome::first_load_factor);
    Sensitivity { variable, sliding, overturning, first_load_factor }
}
