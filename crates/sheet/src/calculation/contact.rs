//! Loads that are no point of the report's diagram: the general contact problem and the conditions of its modes.

use standfast::contact::Block;
use standfast::{InputError, Situation, Wrench};

use crate::measured::{METRE, Measured, NONE};
use crate::steps::{Step, Steps};

pub(super) fn steps(steps: &mut Steps, situation: &Situation, total: &Wrench) -> Result<(), InputError> {
    steps.heading("Mode of response: the general contact problem");
    steps.note(
        "The load is no point of the report's diagram, which needs a uniform body with one friction and no added mass, pressed \
         on its base and pushed sideways. Every mode is tried: its motion has to satisfy the equations of motion, Coulomb's \
         law and non-penetration at both corners. Forces are in m g, lengths in B, accelerations in g.",
    );
    let (block, wrench) = (situation.block(), situation.reduced_wrench(total));
    let Block { b1, b2, d, rho2, m_x, .. } = block;
    let mut add = |about: &str, name: &str, formula: &str, value: f64| {
        let result = Measured::of(value, NONE);
        steps.step(&Step { about, reference: "", name, formula, result, key: "" });
    };
    add("The wrench in these units", "x", "X/(m g)", wrench.x);
    add("", "p", "V/(m g)", wrench.p);
    add("", "q", "M/(m g B)", wrench.m);
    add("The body in these units", "β_1", "b_1/B", b1);
    add("", "β_2", "b_2/B", b2);
    add("", "d", "y_C/B", d);
    add("", "ρ_C", "sqrt(I/(m B^2))", rho2.sqrt());
    if m_x != 1.0 {
        add("Inertia against horizontal motion", "m_x", "1 + M_a/m", m_x);
    }
    let answer = situation.solve(total)?;
    if answer.modes.is_empty() {
        steps.note("No mode is consistent; that happens only where friction to stick is larger than friction to slip.");
    }
    steps.know("b_1", b1, NONE);
    steps.know("b_2", b2, NONE);
    for mode in answer.modes.iter() {
        let reported = if answer.mode() == Some(mode) { "" } else { ", not the one reported" };
        steps.heading(&format!("Consistent{reported}: the body {} ({mode})", mode.words()));
        if let Some(motion) = answer.motion(mode) {
            steps.know("f_y", motion.f_y, NONE);
        }
        for relation in answer.explain(mode) {
            steps.relation(&relation);
        }
    }
    let body = situation.body();
    steps.know("b_1", body.heel_distance(), METRE);
    steps.know("b_2", body.toe_distance(), METRE);
    Ok(())
}

#[cfg(test)]
mod tests {
    use standfast::Body;

    use standfast_cases::units::Extent;

    use super::*;

    #[test]
    fn a_contact_problem_without_an_answer_leaves_no_sheet() -> Result<(), InputError> {
        let situation = Situation::new(Body::new(6.0, 7.0, 100e3)?, 0.6, 9.81)?;
        let wrench = Wrench { x: f64::NAN, p: 981e3, m: 0.0 };
        assert!(steps(&mut Steps::new("Loads", Extent::PerMetre), &situation, &wrench).is_err());
        Ok(())
    }
}
