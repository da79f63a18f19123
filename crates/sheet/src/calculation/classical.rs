//! The classical checks: actions, both safety factors, heel pressure.

use standfast::contact::Wrench;
use standfast::{Actions, Corner, HeelPressure, LoadKind, Stability};
use standfast_cases::Assessed;
use standfast_cases::assess::situation::heel_pressure;

use super::loads::{grouped, parts, sum};
use crate::quantity::{KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE};
use crate::steps::Steps;

/// What common practice asks of both safety factors.
pub const TARGET: f64 = 1.2;

pub(super) fn steps(steps: &mut Steps, assessed: &Assessed) {
    let heel = assessed.loaded.situation.heel(1.0);
    let corner = if heel == Corner::O { "O" } else { "O′" };
    steps.heading("Classical checks");
    actions(steps, assessed, heel, corner);
    factors(steps, assessed);
    pressure(steps, assessed);
}

/// The sum of a part of the loads of some kinds, as a formula.
fn sum_of(assessed: &Assessed, kinds: &[LoadKind], which: usize, part: fn(&Wrench) -> f64) -> Option<String> {
    let components = assessed.loaded.components.iter().enumerate();
    let parts = components
        .filter(|(_, component)| kinds.contains(&component.kind))
        .map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench)));
    sum(parts)
}

fn actions(steps: &mut Steps, assessed: &Assessed, heel: Corner, corner: &str) {
    use LoadKind::{Horizontal, Uplift, Weight};
    let Actions { buoyant_weight, weight_arm, uplift, uplift_moment, force, force_moment } = assessed.actions;
    // The heel's distance from C, and the sign of a moment at C that turns the body about it.
    let (arm, sign, against) = if heel == Corner::O { ("b_1", "+", "−") } else { ("b_2", "−", "+") };
    let all = [Weight, Uplift, Horizontal];

    let about = "Weight less buoyancy";
    match sum_of(assessed, &[Weight, Horizontal], 1, |wrench| wrench.p) {
        Some(formula) => steps.add(about, "", ["W'", &formula], buoyant_weight, KILONEWTON, "buoyant_weight"),
        None => steps.told(about, "W'", buoyant_weight, KILONEWTON, "none", "buoyant_weight"),
    }
    let about = format!("Its arm to the heel, {corner}");
    match sum_of(assessed, &[Weight], 2, |wrench| wrench.m) {
        _ if buoyant_weight == 0.0 => steps.told(&about, "t", 0.0, METRE, "no weight left", "weight_arm"),
        Some(moments) => {
            let formula = format!("{arm} {against} {}/W'", grouped(&moments));
            steps.add(&about, "", ["t", &formula], weight_arm, METRE, "weight_arm");
        }
        None => steps.add(&about, "", ["t", arm], weight_arm, METRE, "weight_arm"),
    }
    match sum_of(assessed, &[Uplift], 1, |wrench| wrench.p) {
        Some(formula) => {
            steps.add("Uplift", "", ["U", &format!("−{}", grouped(&formula))], uplift, KILONEWTON, "U");
            let moments = sum_of(assessed, &[Uplift], 2, |wrench| wrench.m);
            let moments = moments.map_or(String::new(), |moments| format!(" {sign} {}", grouped(&moments)));
            let formula = format!("U {arm}{moments}");
            steps.add("Its moment about the heel", "", ["M_U", &formula], uplift_moment, MOMENT, "M_U");
        }
        None => {
            steps.told("Uplift", "U", uplift, KILONEWTON, "no load counts as uplift", "U");
            steps.told("Its moment about the heel", "M_U", uplift_moment, MOMENT, "none", "M_U");
        }
    }
    let about = "Horizontal force";
    match sum_of(assessed, &all, 0, |wrench| wrench.x) {
        Some(formula) => steps.add(about, "", ["P", &format!("|{formula}|")], force, KILONEWTON, "P"),
        None => steps.told(about, "P", force, KILONEWTON, "none", "P"),
    }
    let about = "Its moment about the base, towards the heel";
    let moments = sum_of(assessed, &[Horizontal], 2, |wrench| wrench.m);
    let lever = (force != 0.0).then(|| "X y_C".to_owned());
    let formula = match (heel, moments, lever) {
        (Corner::O, Some(moments), Some(lever)) => format!("{moments} − {lever}"),
        (Corner::O, Some(moments), None) => moments,
        (Corner::O, None, Some(lever)) => format!("−{lever}"),
        (Corner::OPrime, Some(moments), Some(lever)) => format!("{lever} − {}", grouped(&moments)),
        (Corner::OPrime, Some(moments), None) => format!("−{}", grouped(&moments)),
        (Corner::OPrime, None, Some(lever)) => lever,
        (_, None, None) => return steps.told(about, "M_p", force_moment, MOMENT, "none", "M_p"),
    };
    steps.add(about, "", ["M_p", &formula], force_moment, MOMENT, "M_p");
}

fn factors(steps: &mut Steps, assessed: &Assessed) {
    if assessed.full.is_lifted() {
        return steps.note("Nothing presses the body on its base: safety factors mean nothing.");
    }
    let Stability { sliding, overturning, overturning_about_toe, .. } = assessed.stability;
    let Actions { force, force_moment, .. } = assessed.actions;
    let about = "Safety against sliding";
    if force > 0.0 {
        steps.add(about, "", ["SF_sliding", "μ (W' − U)/P"], sliding, NONE, "SF_sliding");
    } else {
        steps.told(about, "SF_sliding", sliding, NONE, "no horizontal force acts", "SF_sliding");
    }
    let about = "Safety against overturning, about the heel";
    let formula = ["SF_overturning", "(W' t − M_U)/M_p"];
    if force_moment > 0.0 {
        steps.add(about, "", formula, overturning, NONE, "SF_overturning");
    } else if overturning == 0.0 {
        let words = "uplift or eccentric weight turn the body without any horizontal force";
        steps.told(about, "SF_overturning", overturning, NONE, words, "SF_overturning");
    } else {
        steps.told(
            about,
            "SF_overturning",
            overturning,
            NONE,
            "no force turns the body that way",
            "SF_overturning",
        );
    }
    if overturning_about_toe.is_finite() {
        let about = "Safety against overturning, about the other corner, the toe";
        let key = "SF_overturning_about_toe";
        if force_moment < 0.0 {
            let formula = ["SF_toe", "(W' (B_c − t) − U B_c + M_U)/(−M_p)"];
            steps.add(about, "", formula, overturning_about_toe, NONE, key);
        } else {
            let words = "uplift or eccentric weight turn the body without any horizontal force";
            steps.told(about, "SF_toe", overturning_about_toe, NONE, words, key);
        }
    }
    let met = |factor: f64| if factor >= TARGET { "met" } else { "not met" };
    steps.note(&format!(
        "Common practice asks for {TARGET} at least: against sliding {}, against overturning {}.",
        met(sliding),
        met(assessed.stability.least_overturning())
    ));
}

fn pressure(steps: &mut Steps, assessed: &Assessed) {
    let Stability { resultant_arm, heel_pressure: heel, .. } = assessed.stability;
    if let Some(arm) = resultant_arm {
        let formula = ["t_e", "(W' t − M_U − M_p)/(W' − U)"];
        steps.add("Resultant of all loads, from the heel", "", formula, arm, METRE, "resultant_arm");
    }
    match (heel, resultant_arm) {
        (HeelPressure::Pressed(pressure), Some(arm)) => {
            let third = arm <= assessed.loaded.situation.body.base_width() / 3.0;
            let (about, formula) = match third {
                true => {
                    ("Heel pressure, for `t_e` ≤ `B_c÷3`: pressed near the heel only", "2 (W' − U)/(3 t_e)")
                }
                false => (
                    "Heel pressure, for `t_e` > `B_c÷3`: the whole base is pressed",
                    "2 (W' − U)/B_c (2 − 3 t_e/B_c)",
                ),
            };
            steps.add(about, "", ["p_e", formula], pressure, KILOPASCAL, "heel_pressure");
        }
        _ => steps.note(&format!("Heel pressure: none; {}.", heel_pressure(heel).1)),
    }
}
