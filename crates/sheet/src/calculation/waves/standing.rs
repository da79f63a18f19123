//! Sainflou's waves: height, wavelength, pressures, resultants.

use standfast::wave::{StandingWall, WavePhase};
use standfast_cases::Case;
use standfast_cases::case::StandingWaves;
use standfast_cases::key::Key;

use crate::measured::{ACCELERATION, DENSITY, KILONEWTON, KILOPASCAL, METRE, MOMENT, SECOND};
use crate::steps::SheetSteps;

const SAINFLOU: &str = "Sainflou";

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, waves: &StandingWaves) {
    let StandingWaves { sea, height_key, wall, wave } = waves;
    let StandingWall { base_depth, crest_height, width, uplift } = *wall;
    steps.know_all([
        ("h", sea.water_depth, METRE),
        ("T", sea.period, SECOND),
        ("ρ", sea.water_density, DENSITY),
        ("g", case.gravity, ACCELERATION),
        ("h'", base_depth, METRE),
        ("h_c", crest_height, METRE),
        ("B_c", width, METRE),
    ]);
    steps.heading("Standing wave");
    let given = match height_key {
        Key::WaveHeight => "as given in the case file".to_owned(),
        key => format!("the {} of the case file", if *key == Key::H13 { "H13" } else { "Hmax" }),
    };
    steps.told("Wave height", "H_s", wave.height, METRE, &given, "");
    let l0 = wave.deep_water_wavelength;
    steps.add("Wavelength in deep water", "linear theory", ["L0", "g T^2/(2 π)"], l0, METRE, "");
    // The dispersion relation is implicit: the formula is a check of the wavelength found.
    steps.know("L", wave.wavelength, METRE);
    let about = "Wavelength at the wall, the root of the dispersion relation, put back into it";
    steps.add(about, "linear theory", ["L", "L0 tanh(2 π h÷L)"], wave.wavelength, METRE, "");
    let formula = ["h_0", "π H_s^2/(L tanh(2 π h÷L))"];
    steps.add("Middle of the wave above still water", SAINFLOU, formula, wave.h0, METRE, "");
    steps.heading("Pressures beside still water");
    match wave.phase {
        WavePhase::Crest => crest(steps, waves),
        WavePhase::Trough => trough(steps, waves),
    }
    if !uplift {
        steps.note("By the case file, the waves do not press under the base.");
        return;
    }
    let about = "Uplift at the seaward toe, falling to zero at the heel; recalled, not read";
    steps.add(about, SAINFLOU, ["p_u", "p_b"], wave.pu, KILOPASCAL, "");
    steps.add("Uplift", SAINFLOU, ["U_w", "1/2 p_u B_c"], wave.uplift, KILONEWTON, "");
    let about = "Its moment about the heel";
    steps.add(about, SAINFLOU, ["M_Uw", "p_u B_c^2/3"], wave.uplift_moment, MOMENT, "");
}

fn crest(steps: &mut SheetSteps, StandingWaves { wave, .. }: &StandingWaves) {
    let add = |steps: &mut SheetSteps, about, formula, value, unit| {
        steps.add(about, SAINFLOU, formula, value, unit, "");
    };
    add(steps, "At the bed", ["p2", "ρ g H_s/cosh(2 π h÷L)"], wave.p2, KILOPASCAL);
    let formula = ["p1", "(p2 + ρ g h) (H_s + h_0)/(h + H_s + h_0)"];
    add(steps, "At still water", formula, wave.p1, KILOPASCAL);
    add(steps, "At the base", ["p_b", "p1 − (p1 − p2) h'/h"], wave.pb, KILOPASCAL);
    let about = "Height above still water of the loaded wall";
    add(steps, about, ["h_w", "min(H_s + h_0, h_c)"], wave.reach, METRE);
    add(steps, "Pressure at its top", ["p4", "p1 (1 − h_w/(H_s + h_0))"], wave.p4, KILOPASCAL);
    steps.heading("Resultants of the wave");
    let formula = ["P_w", "1/2 (p1 + p_b) h' + 1/2 (p1 + p4) h_w"];
    add(steps, "Horizontal force", formula, wave.force, KILONEWTON);
    let formula = ["M_w", "(2 p1 + p_b) h'^2/6 + (p1 + p4) h' h_w/2 + (p1 + 2 p4) h_w^2/6"];
    add(steps, "Its moment about the base", formula, wave.force_moment, MOMENT);
}

fn trough(steps: &mut SheetSteps, StandingWaves { wave, .. }: &StandingWaves) {
    let add = |steps: &mut SheetSteps, about, formula, value, unit| {
        steps.add(about, SAINFLOU, formula, value, unit, "");
    };
    add(steps, "Fall of the water at the wall", ["d_t", "H_s − h_0"], -wave.surface, METRE);
    let about = "At the surface of the trough; below zero, towards the sea";
    add(steps, about, ["p1", "0 − ρ g d_t"], wave.p1, KILOPASCAL);
    add(steps, "At the bed", ["p2", "0 − ρ g H_s/cosh(2 π h÷L)"], wave.p2, KILOPASCAL);
    let formula = ["p_b", "p1 + (p2 − p1) (h' − d_t)/(h − d_t)"];
    add(steps, "At the base", formula, wave.pb, KILOPASCAL);
    steps.heading("Resultants of the wave");
    let formula = ["P_w", "1/2 (p1 + p_b) (h' − d_t) + 1/2 p1 d_t"];
    add(steps, "Horizontal force, below zero towards the sea", formula, wave.force, KILONEWTON);
    let formula = ["M_w", "(2 p1 + p_b) (h' − d_t)^2/6 + 1/2 p1 d_t (h' − 2/3 d_t)"];
    add(steps, "Its moment about the base", formula, wave.force_moment, MOMENT);
}
