//! The body, its loads one by one, and the classical checks, for reading.

use standfast::{Corner, HeelPressure};

use super::Assessed;
use crate::case::{Case, Weight};
use crate::describe::kilonewtons;
use crate::layout::{columns, digits, paragraph, row};

pub(super) fn body(case: &Case) -> String {
    let body = &case.body;
    let metres = |x: f64| format!("{} m", digits(x));
    let mut rows = vec![
        row!["width 2B", metres(body.width())],
        row!["height 2H", metres(body.height())],
        row!["mass m", format!("{} t/m", digits(body.mass() / 1e3))],
    ];
    let gravity = format!("g = {} m/s²", digits(case.gravity));
    rows.push(row!["weight m g", format!("{} ({gravity})", kilonewtons(body.mass() * case.gravity))]);
    if case.added_mass.mass > 0.0 {
        let mass = format!("{} t/m, moves with the body horizontally", digits(case.added_mass.mass / 1e3));
        rows.push(row!["added mass of water", mass]);
    }
    rows.push(row!["slenderness γ = H/B", digits(body.slenderness())]);
    if !body.is_uniform() {
        let place = format!(
            "{} above the base, {} right of O, {} left of O'",
            metres(body.centroid_height()),
            metres(body.heel_distance()),
            metres(body.toe_distance())
        );
        rows.push(row!["centre of mass", place]);
        let inertia = format!("{} t m²/m about it", digits(body.moment_of_inertia() / 1e3));
        rows.push(row!["moment of inertia", inertia]);
    }
    if case.kinetic_friction == case.friction {
        rows.push(row!["friction μ", digits(case.friction)]);
    } else {
        let pair = format!("{} to stick, {} to slip", digits(case.friction), digits(case.kinetic_friction));
        rows.push(row!["friction μ", pair]);
    }
    if let Some(water) = &case.water {
        let levels = if water.left == water.right {
            metres(water.left)
        } else {
            format!("{} at the left, {} at the right", metres(water.left), metres(water.right))
        };
        rows.push(row!["still water", format!("{levels} above the base; {} kg/m³", digits(water.density))]);
    }
    rows.push(row!["weight counted as", case.weight_words()]);
    columns(&rows, 2, &[])
}

impl Case {
    /// How water takes part in the weight, in words.
    pub fn weight_words(&self) -> &'static str {
        match (self.weight, &self.water) {
            (Weight::Buoyant { .. }, _) => "buoyant weight, as given",
            (Weight::Total, Some(_)) => "total weight with explicit pressures",
            (Weight::Total, None) => "total weight, no still water",
        }
    }
}

/// The loads one by one, and their sum under the full load.
pub(super) fn components(assessed: &Assessed) -> String {
    let mut rows =
        vec![row!["", "", "left", "down", "moment at C"], row!["load", "", "kN/m", "kN/m", "kN m/m"]];
    let numbers = |wrench: &standfast::contact::Wrench| {
        // `0.0 −` rather than `−`, so that nothing becomes −0.
        [0.0 - wrench.x, wrench.p, wrench.m].map(|x| digits(x / 1e3))
    };
    for component in &assessed.loaded.components {
        let share = if component.permanent { "permanent" } else { "variable" };
        let [left, down, moment] = numbers(&component.wrench);
        rows.push(row![component.name.as_str(), share, left, down, moment]);
    }
    let [left, down, moment] = numbers(&assessed.full.wrench);
    rows.push(row!["sum", "", left, down, moment]);
    let mut text = columns(&rows, 2, &[2, 3, 4]);
    text += &paragraph("Moments are counter-clockwise about the centre of mass C.", 2);
    text
}

/// The actions as a designer adds them up, both safety factors and the heel pressure.
pub(super) fn classical(assessed: &Assessed) -> String {
    let actions = &assessed.actions;
    let heel = match assessed.loaded.situation.heel(1.0) {
        Corner::O => "O",
        Corner::OPrime => "O'",
    };
    let kilonewton_metres = |x: f64| format!("{} kN m/m", digits(x / 1e3));
    let number =
        |x: f64, unit: &str| if x.is_finite() { format!("{}{unit}", digits(x)) } else { "none".into() };
    let rows = [
        row![
            "W'",
            kilonewtons(actions.buoyant_weight),
            format!("at t = {} from the heel {heel}", number(actions.weight_arm, " m"))
        ],
        row![
            "U",
            kilonewtons(actions.uplift),
            format!("M_U = {} about the heel", kilonewton_metres(actions.uplift_moment))
        ],
        row![
            "P",
            kilonewtons(actions.force),
            format!("M_p = {} about the base", kilonewton_metres(actions.force_moment))
        ],
    ];
    let mut text = columns(&rows, 2, &[]);

    let stability = &assessed.stability;
    let (pressure, words) = heel_pressure(stability.heel_pressure);
    let pressure = pressure.map_or("none".to_owned(), |pressure| format!("{} kPa", digits(pressure)));
    let factor = |factor: f64| if assessed.full.is_lifted() { "none".to_owned() } else { digits(factor) };
    let mut rows = vec![
        row!["sliding", "μ(W' − U)/P", factor(stability.sliding)],
        row!["overturning", "(W' t − M_U)/M_p", factor(stability.overturning)],
    ];
    if stability.overturning_about_toe.is_finite() && !assessed.full.is_lifted() {
        let formula = "(W'(B_c − t) − U B_c + M_U)/(−M_p), about the toe";
        rows.push(row!["", formula, factor(stability.overturning_about_toe)]);
    }
    let effective = assessed.full.effective.map(|reduced| reduced.point.safety_against_overturning());
    let classical = digits(stability.least_overturning());
    let effective = effective.filter(|effective| digits(*effective) != classical);
    if let Some(effective) = effective {
        rows.push(row!["", "1/(k_eff γ |1+k'_eff|)", digits(effective)]);
    }
    rows.push(row!["heel pressure", words, pressure]);
    if assessed.full.wrench.p > 0.0 {
        rows.push(row![
            "resultant",
            "t_e from the heel",
            number(stability.resultant_arm.unwrap_or(f64::NAN), " m")
        ]);
    }
    text += "\nSafety factors and heel pressure\n";
    text += &columns(&rows, 2, &[]);
    if effective.is_some() {
        let both = "The factor in effective coordinates counts uplift and eccentric weight as a load; the classical one \
             as less resistance. They differ except at 1, which they pass together.";
        text += &paragraph(both, 2);
    }
    if stability.least_overturning() == 0.0 && !assessed.full.is_lifted() {
        let turned = "An overturning factor of 0 says that uplift or eccentric weight turn the body without any \
             horizontal force.";
        text += &paragraph(turned, 2);
    }
    text
}

/// The heel pressure in kPa, and in words.
pub fn heel_pressure(heel: HeelPressure) -> (Option<f64>, &'static str) {
    match heel {
        HeelPressure::Pressed(pressure) => (Some(pressure / 1e3), "largest, at the heel"),
        HeelPressure::Unloaded => (None, "heel unloaded"),
        HeelPressure::OutsideBase => (None, "the resultant misses the base"),
        HeelPressure::Lifted => (None, "nothing presses on the base"),
    }
}
