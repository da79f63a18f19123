//! Criteria on the results, step by step.

use standfast_cases::Bound;
use standfast_cases::{Assessed, Case, CaseCheck, Key};

use crate::measured::{FACTOR, KILOPASCAL, METRE, MRAD, NONE, SheetUnit};
use crate::steps::SheetSteps;

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, assessed: &Assessed) {
    let checks = assessed.checks(case);
    if checks.is_empty() {
        return;
    }
    steps.heading("Criteria and their utilisation");
    for check in checks {
        one(steps, &check);
    }
}

fn one(steps: &mut SheetSteps, CaseCheck { check, assessed }: &CaseCheck<'_>) {
    let criterion = &check.criterion;
    let about = format!(
        "{}, {}: {}",
        standfast_cases::capital(criterion.words()),
        criterion.required(),
        check.met_words()
    );
    let name = format!("u_{}", letters(criterion.key));
    let (bound, least) = match criterion.bound {
        Bound::AtLeast(bound) => (bound, true),
        Bound::AtMost(bound) => (bound, false),
        Bound::NoneOf(_) => {
            steps.note(&format!("{about}; the body may take up: {}.", check.value_words(assessed)));
            return;
        }
    };
    if criterion.is_chance() {
        let words = format!("{} of {}, see Probability", check.value_words(assessed), criterion.required());
        return steps.told(&about, &name, check.utilisation.unwrap_or(f64::INFINITY), FACTOR, &words, "");
    }
    let (value, unit) = quantity(criterion.key);
    let utilisation = check.utilisation.unwrap_or(f64::INFINITY);
    if utilisation == f64::INFINITY {
        let value = match check.value_words(assessed).as_str() {
            "none" => "There is no value".to_owned(),
            words => format!("The value is {words}"),
        };
        let on_joint = check.on_joint(assessed);
        steps.note(&format!("{about}. {value}{on_joint}: the utilisation is infinite."));
        return;
    }
    if check.joint.is_some_and(|joint| joint > 0) {
        let words = format!("{}{}", check.value_words(assessed), check.on_joint(assessed));
        return steps.told(&about, &name, utilisation, FACTOR, &words, "");
    }
    if !assessed.is_reported {
        let words = format!("{}, in another of the ways that were tried", check.value_words(assessed));
        return steps.told(&about, &name, utilisation, FACTOR, &words, "");
    }
    if utilisation == 0.0 {
        return steps.told(&about, &name, utilisation, FACTOR, &check.value_words(assessed), "");
    }
    let required = format!("R_{}", letters(criterion.key));
    steps.know(&required, bound, unit);
    let formula = if least { format!("{required}/{value}") } else { format!("{value}/{required}") };
    steps.add(&about, "", [&name, &formula], utilisation, FACTOR, "");
}

/// The name under which the calculation has the value of a criterion, and its unit.
fn quantity(key: Key) -> (&'static str, SheetUnit) {
    match key {
        Key::LeastSliding => ("SF_sliding", FACTOR),
        Key::LeastOverturningNet => ("SF_overturning_net", FACTOR),
        Key::LeastOverturningGross => ("SF_overturning_gross", FACTOR),
        Key::LeastUplift => ("SF_uplift", FACTOR),
        Key::GreatestTipping => ("Λ_tip", FACTOR),
        Key::GreatestBearing => ("p_max", KILOPASCAL),
        Key::LeastContact => ("ψ", NONE),
        Key::GreatestEccentricity => ("ε", METRE),
        Key::LeastGround => ("F_R", FACTOR),
        Key::GreatestEffective => ("p_b", KILOPASCAL),
        Key::GreatestRotation => ("θ_b", MRAD),
        _ => ("λ_d", FACTOR),
    }
}

/// Letter that tells a criterion from others in an index.
fn letters(key: Key) -> &'static str {
    match key {
        Key::LeastSliding => "s",
        Key::LeastOverturningNet => "o",
        Key::LeastOverturningGross => "g",
        Key::LeastUplift => "u",
        Key::GreatestTipping => "t",
        Key::GreatestBearing => "p",
        Key::LeastContact => "c",
        Key::GreatestEccentricity => "e",
        Key::LeastGround => "R",
        Key::GreatestEffective => "b",
        Key::GreatestRotation => "θ",
        Key::GreatestNotRest => "P",
        Key::GreatestLife => "P_life",
        Key::GreatestAny => "P_any",
        Key::LeastLifeIndex => "β",
        Key::GreatestMeanSlide => "S",
        Key::GreatestSlidingOver => "S_P",
        _ => "λ",
    }
}
