//! What a small change of every number of a case does to its safety.

use super::Chain;
use super::outcome::Outcome;
use super::vary::Variable;
use crate::case::{Case, Number};

/// By how much, relatively, a number is varied to either side.
const STEP: f64 = 1e-4;

/// How both safety factors and the first load factor change if a number grows by 1 %; `None` where they are
/// infinite or the number can grow or shrink no more.
pub(super) struct Sensitivity {
    pub(super) variable: Variable,
    pub(super) sliding: Option<f64>,
    pub(super) overturning: Option<f64>,
    pub(super) first_load_factor: Option<f64>,
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
