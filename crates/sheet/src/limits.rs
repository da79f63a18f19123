//! Limits of the calculation: what it does not cover, and what leaves the range of its formulas.

use maud::{Markup, html};
use standfast_cases::Case;

/// Surroundings of a body, which say what else could happen to it.
pub struct Setting {
    /// Waves come.
    pub waves: bool,
    /// Water stands beside it or presses under it.
    pub water: bool,
    /// It is a structure in water or soil, rather than an object on a floor.
    pub structure: bool,
}

impl Setting {
    /// That of a case.
    pub fn of(case: &Case) -> Setting {
        let waves = case.wave.is_some();
        let buoyant = matches!(case.weight, standfast_cases::case::Weight::Buoyant { .. });
        let water = waves || buoyant || case.water.is_some() || case.uplift.is_some();
        let water = water || case.added_mass.mass() > 0.0;
        Setting { waves, water, structure: water || !case.pressures.is_empty() }
    }
}

/// Warnings, and what is not covered; `moves` if the motion is followed in time.
pub fn words(case: &Case, moves: bool) -> Markup {
    let warnings = case.warnings();
    let setting = Setting::of(case);
    html! {
        @if warnings.is_empty() && moves {
            p { "No warning of the loads as they are held; those of the motion stand with it in section 5." }
        } @else if warnings.is_empty() {
            p { "No warning: nothing leaves the ranges that the program checks." }
        } @else {
            p { "Outside the range of the formulas, or unusual:" }
            ul.warnings { @for warning in &warnings { li { (warning) " (" code { (warning.name()) } ")." } } }
        }
        p { "The following is not part of this calculation and has to be shown separately where it matters:" }
        ul { @for item in not_covered(case, &setting, moves) { li { (item) } } }
        p {
            "Friction between body and base is the least certain input. It enters the factor against sliding in proportion"
            @if case.plan.is_none() { "; the modes on either side of the value used stand in the calculation and in the figures" }
            ". Safety factors do not say how \
             probable a failure is. Nothing here replaces an engineer’s judgement."
        }
    }
}

/// Failures that the case could meet with and that are not computed.
fn not_covered(case: &Case, setting: &Setting, moves: bool) -> Vec<String> {
    let given =
        if case.pressures.is_empty() { "" } else { ", but for the pressures given under [[pressure]]" };
    let bears = case.ground.is_some_and(|ground| ground.limit.is_some());
    let springs = case.ground.is_some_and(|ground| ground.stiffness.is_some());
    let mut items = vec![
        match setting {
            Setting { waves: true, .. } if bears => {
                "effects that the formula of the ground leaves out, see there; sliding within the rubble mound; settlement;"
            }
            _ if bears => "effects that the formula of the ground leaves out, see there; settlement;",
            Setting { waves: true, .. } => {
                "bearing capacity and sliding within the rubble mound, the foundation or the soil beneath; settlement and tilt;"
            }
            Setting { structure: true, .. } => {
                "bearing capacity and sliding within the foundation or the soil beneath; settlement and tilt;"
            }
            _ => "strength and stiffness of the floor or ground that the body stands on; settlement and tilt;",
        }
        .to_owned(),
    ];
    if setting.water {
        items.push("pore pressure in the foundation, built up or drained while the load acts;".to_owned());
        items.push(match setting.waves {
            true => "scour, loss of base area, stability of the armour;".to_owned(),
            false => format!("waves and overtopping{given}; scour, loss of base area;"),
        });
    }
    if setting.waves {
        items.push(
            "overtopping, and the pressures that it relieves or adds; impulsive pressures beyond the formulas used;".to_owned(),
        );
        items.push(format!(
            "wave troughs, seaward loads, and waves of other heights, periods and water levels than those given{given};"
        ));
    }
    if springs {
        items.push("damping of the ground, and the change of its stiffness with the load;".to_owned());
    }
    items.push("strength of the body itself, and of its base where a corner alone carries it;".to_owned());
    items.push(match setting.structure {
        _ if case.plan.is_some() => {
            "how the body moves once it leaves rest: sliding, rolling and turning in space; neighbouring bodies;".to_owned()
        }
        true => "three-dimensional effects: oblique loads along the structure, corners, joints, neighbouring bodies;".to_owned(),
        false => "three-dimensional effects: loads out of the plane, turning about a vertical axis, neighbouring bodies;".to_owned(),
    });
    if !moves {
        items.push("duration: how far the body moves once it has left rest;".to_owned());
    }
    if let Some(last) = items.last_mut().filter(|last| last.ends_with(';')) {
        last.pop();
        last.push('.');
    }
    items
}
