//! Loads that have no point in the report's diagram: the general contact problem and the conditions of its modes.

use standfast::contact::Block;
use standfast::relation::Relation;
use standfast::{InputError, Situation, Wrench};
use standfast_cases::Assessed;

use crate::measured::{Measured, NONE};
use crate::steps::{SheetStep, SheetSteps};

pub(super) fn steps(steps: &mut SheetSteps, situation: &Situation, total: &Wrench) -> Result<(), InputError> {
    steps.heading("Mode of response: the general contact problem");
    steps.note(
        "The report's k–μ diagram needs a uniform body with one friction and no added mass, pressed on its base and pushed \
         sideways; this load has no point there. Every mode is tried: its motion has to satisfy the equations of motion, Coulomb's \
         law and non-penetration at both corners. Forces are in m g, lengths in B, accelerations in g: `φ_x` and `φ_y` are the reactions \
         of the base, `ζ` is where `φ_y` acts, right of the centre of mass.",
    );
    let (block, wrench) = (situation.reduced_block().0, situation.reduced_wrench(total));
    let Block { b1, b2, d, rho2, m_x, .. } = block;
    let mut add = |about: &str, name: &str, formula: &str, value: f64| {
        let result = Measured::of(value, NONE);
        steps.step(&SheetStep { about, reference: "", name, formula, result, key: "" });
    };
    add("The wrench in these units", "x", "X/(m g)", wrench.x);
    add("", "p", "V/(m g)", wrench.p);
    add("", "q", "M/(m g B)", wrench.m);
    add("The body in these units", "r_1", "b_1/B", b1);
    add("", "r_2", "b_2/B", b2);
    add("", "d_C", "y_C/B", d);
    add("", "ρ_C", "sqrt(I/(m B^2))", rho2.sqrt());
    if m_x != 1.0 {
        add("Inertia against horizontal motion", "m_x", "1 + m_a/m", m_x);
    }
    let answer = situation.solve(total)?;
    if answer.modes.is_empty() {
        steps.note("No mode is consistent; that happens only where friction to stick is larger than friction to slip.");
    }
    for mode in answer.modes.iter() {
        let reported = if answer.mode() == Some(mode) { "" } else { ", not the one reported" };
        steps.heading(&format!("Consistent{reported}: the body {} ({mode})", mode.words()));
        if let Some(motion) = answer.motion(mode) {
            steps.know("φ_y", motion.f_y, NONE);
        }
        for relation in answer.explain(mode) {
            steps.relation(&reduced(relation));
        }
    }
    Ok(())
}

/// The conditions of the mode of a body that more than friction holds.
pub(super) fn held(steps: &mut SheetSteps, assessed: &Assessed) {
    steps.heading("Mode of response: the general contact problem, with what holds the body");
    steps.note(
        "The report's k–μ diagram knows no adhesion and no force that gives way. Every mode is tried with every state of the resistances: one whose \
         point the motion drives against it acts in full, one whose point gives way does not act. Rest takes as much as it needs. Forces are in \
         m g, lengths in B, accelerations in g: `φ_x` and `φ_y` are the reactions of the base, `ζ` is where `φ_y` acts, right of the \
         centre of mass.",
    );
    let situation = &assessed.situation;
    let Block { b1, b2, .. } = situation.reduced_block().0;
    for (name, value) in [("r_1", b1), ("r_2", b2)] {
        steps.know(name, value, NONE);
    }
    let response = &assessed.outcome.full;
    let Some((mode, motion)) = assessed.mode().zip(response.motion) else {
        return steps.note("No mode is consistent.");
    };
    steps.know("φ_y", motion.f_y / (situation.body().mass() * situation.gravity()), NONE);
    let held = assessed.outcome.held.filter(|held| held.adhesion > 0.0);
    if let Some(held) = held {
        let result = Measured::of(held.adhesion / (situation.body().mass() * situation.gravity()), NONE);
        let about = "What adheres in these units";
        steps.step(&SheetStep { about, reference: "", name: "χ", formula: "C_a/(m g)", result, key: "" });
    }
    steps.heading(&format!("Consistent: the body {} ({mode})", mode.words()));
    for relation in situation.explain(response) {
        steps.relation(&reduced(relation));
    }
    let others = response.others().to_string();
    if !others.is_empty() {
        steps.note(&format!("Consistent as well, and not the one reported: {others}."));
    }
}

/// A condition of the contact problem in the symbols of its units; the library's are those of any units.
fn reduced(relation: Relation) -> Relation {
    let symbol = |text: &'static str| match text {
        "|f_x|" => "|φ_x|",
        "f_y" => "φ_y",
        "ξ" => "ζ",
        "θ̈" => "θ̈ B/g",
        "ẍ_O" => "ẍ_O/g",
        "ÿ_O" => "ÿ_O/g",
        "ÿ_O'" => "ÿ_O'/g",
        "μ_s f_y" => "μ φ_y",
        "μ_s f_y + c_a A'" => "μ φ_y + χ",
        "−b_1" => "−r_1",
        "b_2" => "r_2",
        other => other,
    };
    Relation { quantity: symbol(relation.quantity), bound: symbol(relation.bound), ..relation }
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
        assert!(steps(&mut SheetSteps::new("Loads", Extent::PerMetre.into()), &situation, &wrench).is_err());
        Ok(())
    }
}
