//! The actions as a designer adds them up, safety factors and bearing pressures.

use standfast::loads::Reduced;
use standfast::{Bearing, ClassicalActions, GrossOverturning, Outcome, Stability};

use super::{Assessed, holding};
use crate::layout::{self, columns, digits, paragraph, row};
use standfast_inputs::OutputUnits;

/// Reason why there is no bearing pressure, in words; `None` where there is one.
pub fn no_bearing(bearing: Bearing) -> Option<&'static str> {
    match bearing {
        Bearing::Pressed { .. } => None,
        Bearing::Lifted => Some("nothing presses on the base"),
        _ => Some("the resultant misses the base"),
    }
}

fn length(output: OutputUnits, x: f64) -> String {
    if x.is_finite() { output.length(x) } else { "none".into() }
}

pub(super) fn actions(assessed: &Assessed) -> String {
    let ClassicalActions { heel, buoyant_weight, weight_arm, uplift, uplift_moment, force, force_moment } =
        assessed.outcome.actions;
    let output = assessed.output;
    let rows = [
        row![
            "W'",
            output.force(buoyant_weight),
            format!("at t = {} from the heel {}", length(output, weight_arm), heel.letter())
        ],
        row!["U", output.force(uplift), format!("M_U = {} about the heel", output.moment(uplift_moment))],
        row!["P", output.force(force), format!("M_p = {} about the base", output.moment(force_moment))],
    ];
    columns(&rows, 2, &[])
}

pub(super) fn factors(assessed: &Assessed) -> String {
    let full = &assessed.outcome.full;
    let stability = &assessed.outcome.stability;
    let Stability { sliding, overturning_about_heel, overturning_about_toe, .. } = *stability;
    let output = assessed.output;
    let factor = |factor: f64| if full.is_lifted() { "none".to_owned() } else { output.factor(factor) };
    let gross = gross(assessed);
    let [heel_is_held, toe_is_held] = holding::hold_about(assessed);
    let goda = match (heel_is_held, gross.is_some()) {
        (true, true) => "(W' t − M_U + M_R)/M_p, net",
        (true, false) => "(W' t − M_U + M_R)/M_p",
        (false, true) => "(W' t − M_U)/M_p, net",
        (false, false) => "(W' t − M_U)/M_p",
    };
    let mut rows = vec![
        row!["sliding", holding::sliding_formula(assessed), factor(sliding)],
        row!["overturning", goda, factor(overturning_about_heel)],
    ];
    if overturning_about_toe.is_finite() && !full.is_lifted() {
        let formula = match toe_is_held {
            true => "(W'(B_c − t) − U B_c + M_U + M_R)/(−M_p), about the toe",
            false => "(W'(B_c − t) − U B_c + M_U)/(−M_p), about the toe",
        };
        rows.push(row!["", formula, factor(overturning_about_toe)]);
    }
    if let Some(gross) = gross {
        let corner = if gross.is_about_heel() { "heel" } else { "toe" };
        let by = format!("by gross moments, about the {corner}");
        rows.push(row!["", by, output.factor(gross.overturning())]);
    }
    rows.extend(bearing(assessed));
    let mut text = columns(&rows, 2, &[]);
    if let Some(gross) = gross {
        text += &paragraph(&gross_words(gross, assessed), 2);
    }
    if let Some(words) = no_factor(assessed) {
        text += &paragraph(words, 2);
    }
    if stability.overturning() == 0.0 && !full.is_lifted() {
        let turned = "The overturning factor is 0: uplift or eccentric weight alone turns the body, without any horizontal force.";
        text += &paragraph(turned, 2);
    }
    text
}

/// Reason why there is no factor against overturning of a body that is pressed off its middle all the same.
pub fn no_factor(assessed: &Assessed) -> Option<&'static str> {
    let stability = &assessed.outcome.stability;
    let base = assessed.situation.body().base_width();
    let is_off = stability.eccentricity(base).is_some_and(|eccentricity| eccentricity > 0.0);
    (stability.overturning() == f64::INFINITY && is_off).then_some(
        "No horizontal force turns the body, so there is no overturning factor. The load factor, the contact and the \
         eccentricity tell how far the vertical loads lie off the middle.",
    )
}

/// Factor against overturning in effective coordinates, where it is another than the net one.
pub(super) fn effective_factor(assessed: &Assessed) -> Option<(&Reduced, String)> {
    let reduced = assessed.outcome.full.effective.as_ref()?;
    let factor = layout::factor(reduced.point.safety_against_overturning());
    (factor != layout::factor(assessed.outcome.stability.overturning())).then_some((reduced, factor))
}

/// Relation of the net factor against overturning to that in effective coordinates, in words.
pub fn two_factors(reduced: &Reduced) -> &'static str {
    match reduced.point.k_prime() <= -1.0 {
        false => {
            "This factor counts uplift and eccentric weight as a load; the net one counts them as less resistance. The two differ, \
             but pass 1 together."
        }
        true => {
            "This factor counts uplift and eccentric weight as a load; the net one counts them as less resistance. With \
             k'_eff ≤ −1 all loads together turn the body about another corner than the horizontal ones alone. The two factors \
             are then of different corners, and do not pass 1 together."
        }
    }
}

/// Overturning by gross moments, where it tells something else than the net factor: water presses under the base.
fn gross(assessed: &Assessed) -> Option<&GrossOverturning> {
    let Outcome { full, actions, stability, gross, .. } = &assessed.outcome;
    let wet = gross.buoyancy != 0.0 || actions.uplift > 0.0;
    let differs = layout::factor(gross.overturning()) != layout::factor(stability.overturning());
    (wet && differs && !full.is_lifted()).then_some(gross)
}

/// The factor by gross moments as a formula; `uplift` is U, and `held` what resistances add to the moments that hold the body.
pub fn gross_formula(gross: &GrossOverturning, uplift: f64, held: &str) -> String {
    // What is sucked down resists.
    let formula = match (gross.is_about_heel(), gross.buoyancy != 0.0, uplift < 0.0) {
        (true, true, true) => "(W' t + M_s − M_U)/(M_s + M_p)",
        (true, true, false) => "(W' t + M_s)/(M_s + M_U + M_p)",
        (true, false, true) => "(W' t − M_U)/M_p",
        (true, false, false) => "W' t/(M_U + M_p)",
        (false, true, true) => "((W' + U_s − U) B_c − W' t − M_s + M_U)/(U_s B_c − M_s − M_p)",
        (false, true, false) => "((W' + U_s) B_c − W' t − M_s)/((U_s + U) B_c − M_s − M_U − M_p)",
        (false, false, true) => "((W' − U) B_c − W' t + M_U)/(−M_p)",
        (false, false, false) => "W' (B_c − t)/(U B_c − M_U − M_p)",
    };
    with_numerator(formula, held)
}

/// A fraction with more in its numerator.
fn with_numerator(formula: &str, more: &str) -> String {
    let mut depth = 0;
    let slash = formula.char_indices().find(|(_, letter)| {
        depth += match letter {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        *letter == '/' && depth == 0
    });
    match slash.filter(|_| !more.is_empty()) {
        Some((at, _)) => match formula[..at].strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
            // One sum, not a product of sums.
            Some(sum) if !sum.contains('(') => format!("({sum}{more}){}", &formula[at..]),
            _ => format!("({}{more}){}", &formula[..at], &formula[at..]),
        },
        None => formula.to_owned(),
    }
}

/// Words on the factor by gross moments, with its formula.
fn gross_words(gross: &GrossOverturning, assessed: &Assessed) -> String {
    let [heel_is_held, toe_is_held] = holding::hold_about(assessed);
    let is_held = if gross.is_about_heel() { heel_is_held } else { toe_is_held };
    let held = if is_held { " + M_R" } else { "" };
    let formula = gross_formula(gross, assessed.outcome.actions.uplift, held);
    let buoyancy = match gross.buoyancy {
        0.0 => String::new(),
        force => {
            let force = assessed.output.force(force);
            let moment = assessed.output.moment(gross.buoyancy_moment);
            format!(", with buoyancy U_s = {force} and M_s = {moment} about the heel")
        }
    };
    format!(
        "The net factor takes the water under the base off the moment of the weight. By gross moments that water turns the body: \
         {formula}{buoyancy}."
    )
}

fn bearing(assessed: &Assessed) -> Vec<Vec<String>> {
    let Stability { bearing, resultant_arm, .. } = assessed.outcome.stability;
    let output = assessed.output;
    let base = assessed.situation.body().base_width();
    let mut rows = Vec::new();
    match bearing {
        Bearing::Pressed { heel, toe, contact, share } => {
            let larger =
                |one: f64, other: f64| match one > other && output.pressure(one) != output.pressure(other) {
                    true => ", the larger",
                    false => "",
                };
            rows.push(row!["bearing", "at the heel", output.pressure(heel) + larger(heel, toe)]);
            rows.push(row!["", "at the toe", output.pressure(toe) + larger(toe, heel)]);
            let share = format!("{} ({} % of the base)", output.length(contact), digits(100.0 * share));
            rows.push(row!["", "contact", share]);
        }
        other => rows.push(row!["bearing", no_bearing(other).unwrap_or_default(), "none"]),
    }
    if let Some(arm) = resultant_arm {
        rows.push(row!["resultant", "t_e from the heel", length(output, arm)]);
    }
    if let (Bearing::Pressed { .. }, Some(eccentricity)) =
        (bearing, assessed.outcome.stability.eccentricity(base))
    {
        rows.push(row!["", "eccentricity |B_c/2 − t_e|", length(output, eccentricity)]);
    }
    rows
}
