//! Waves: heights at the wall, Goda's pressures with Takahashi's impulsive coefficient, their resultants.

mod crown;
mod standing;

use standfast::wave::{BreakingTerms, CaissonSection, Goda, Heights, Impulsive, Sea};
use standfast_cases::Case;
use standfast_cases::case::{GodaWaves, WaveFormula, Waves};

use crate::measured::{
    ACCELERATION, DEGREE, DENSITY, KILONEWTON, KILOPASCAL, METRE, MOMENT, Measured, NONE, SECOND,
};
use crate::steps::{SheetStep, SheetSteps};

/// The title of the part.
pub(super) fn title(wave: &Waves) -> &'static str {
    match &wave.formula {
        WaveFormula::Goda(_) => "Waves and pressures (Goda, Takahashi)",
        WaveFormula::Sainflou(_) => "Standing waves and pressures (Sainflou)",
        WaveFormula::Crown(waves) => crown::title(waves),
    }
}

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, wave: &Waves) {
    match &wave.formula {
        WaveFormula::Goda(wave) => of_goda(steps, case, wave),
        WaveFormula::Sainflou(wave) => standing::steps(steps, case, wave),
        WaveFormula::Crown(wave) => crown::steps(steps, case, wave),
    }
}

fn of_goda(steps: &mut SheetSteps, case: &Case, wave: &GodaWaves) {
    let GodaWaves { sea, choices, goda, .. } = wave;
    given(steps, case, wave);
    steps.heading("Wavelength and wave heights");
    let l0 = goda.deep_water_wavelength;
    if let (Some(steepness), Heights::DeepWater(height)) = (wave.steepness, wave.heights) {
        steps.know("s_0", steepness, NONE);
        steps.know("H_0'", height, METRE);
        let about = "Period that goes with the height in deep water";
        steps.add(about, "deep water", ["T", "sqrt(2 π H_0'/(g s_0))"], sea.period, SECOND, "period");
    }
    steps.add("Wavelength in deep water", "Goda", ["L0", "g T^2/(2 π)"], l0, METRE, "deep_water_wavelength");
    // The dispersion relation is implicit: the formula is a check of the wavelength found.
    steps.know("L", goda.wavelength, METRE);
    let about = "Wavelength at the wall, the root of the dispersion relation, put back into it";
    steps.add(about, "linear theory", ["L", "L0 tanh(2 π h÷L)"], goda.wavelength, METRE, "wavelength");
    heights(steps, sea, wave);
    coefficients(steps, wave);
    pressures(steps, goda, choices.uplift);
    resultants(steps, goda);
}

/// The numbers of the sea and of the section.
fn given(steps: &mut SheetSteps, case: &Case, wave: &GodaWaves) {
    let GodaWaves { sea, section, choices, .. } = wave;
    let CaissonSection { base_depth, depth_above_berm, crest_height, berm_width, caisson_width } = *section;
    if wave.steepness.is_none() {
        steps.know("T", sea.period, SECOND);
    }
    steps.know_all([
        ("h", sea.water_depth, METRE),
        ("i", sea.sea_bottom_slope, NONE),
        ("ρ", sea.water_density, DENSITY),
        ("g", case.gravity, ACCELERATION),
        ("h'", base_depth, METRE),
        ("d_M", depth_above_berm, METRE),
        ("h_c", crest_height, METRE),
        ("B_M", berm_width, METRE),
        ("B_c", caisson_width, METRE),
        ("λ1", choices.lambda[0], NONE),
        ("λ2", choices.lambda[1], NONE),
        ("λ3", choices.lambda[2], NONE),
    ]);
}

fn coefficients(steps: &mut SheetSteps, wave: &GodaWaves) {
    let GodaWaves { choices, goda, .. } = wave;
    steps.heading("Coefficients");
    angle(steps, wave);
    let Goda { eta_star, h_c_star, alpha_1, alpha_2, alpha_3, alpha_4, .. } = *goda;
    let about = "Height above still water to which the pressure would reach";
    steps.add(about, "Goda", ["η*", "3/4 (1 + cos(β)) λ1 H_max"], eta_star, METRE, "eta_star");
    let formula = ["α1", "0.6 + 1/2 ((4 π h÷L)/sinh(4 π h÷L))^2"];
    steps.add("Pressure of slow waves", "Goda", formula, alpha_1, NONE, "alpha_1");
    let formula = ["α2", "min((h_b − d_M)/(3 h_b) (H_max/d_M)^2, 2 d_M/H_max)"];
    steps.add("Pressure over a shallow berm", "Goda", formula, alpha_2, NONE, "alpha_2");
    let formula = ["α3", "1 − h'/h (1 − 1/cosh(2 π h÷L))"];
    steps.add("Pressure at the base", "Goda", formula, alpha_3, NONE, "alpha_3");
    let about = "Height above still water of the loaded wall";
    steps.add(about, "Goda", ["h_c*", "min(η*, h_c)"], h_c_star, METRE, "h_c_star");
    let about = "Pressure at its top";
    if eta_star > 0.0 {
        steps.add(about, "Goda", ["α4", "1 − h_c*/η*"], alpha_4, NONE, "alpha_4");
    } else {
        steps.told(about, "α4", alpha_4, NONE, "nothing reaches above still water", "alpha_4");
    }
    impulsive(steps, goda, choices.impulsive);
}

fn pressures(steps: &mut SheetSteps, goda: &Goda, uplift: bool) {
    steps.heading("Pressures");
    let formula = ["p1", "1/2 (1 + cos(β)) (λ1 α1 + λ2 α* cos(β)^2) ρ g H_max"];
    steps.add("At still water", "Goda", formula, goda.p1, KILOPASCAL, "p1");
    // No pressure is taken at the base if α₃ is negative.
    let positive = if goda.alpha_3 > 0.0 { "α3" } else { "max(α3, 0)" };
    steps.add("At the base", "Goda", ["p3", &format!("{positive} p1")], goda.p3, KILOPASCAL, "p3");
    steps.add("At the top of the loaded wall", "Goda", ["p4", "α4 p1"], goda.p4, KILOPASCAL, "p4");
    let formula = format!("1/2 (1 + cos(β)) λ3 α1 {positive} ρ g H_max");
    let about = "Uplift at the seaward toe, falling to zero at the heel";
    match uplift {
        true => steps.add(about, "Goda", ["p_u", &formula], goda.pu, KILOPASCAL, "pu"),
        false => steps.told(about, "p_u", goda.pu, KILOPASCAL, "none, as the case file says", "pu"),
    }
}

fn resultants(steps: &mut SheetSteps, goda: &Goda) {
    steps.heading("Resultants of the wave");
    let formula = ["P_w", "1/2 (p1 + p3) h' + 1/2 (p1 + p4) h_c*"];
    steps.add("Horizontal force", "Goda", formula, goda.force, KILONEWTON, "");
    let formula = ["M_w", "(2 p1 + p3) h'^2/6 + (p1 + p4) h' h_c*/2 + (p1 + 2 p4) h_c*^2/6"];
    steps.add("Its moment about the base", "Goda", formula, goda.force_moment, MOMENT, "");
    steps.add("Uplift", "Goda", ["U_w", "1/2 p_u B_c"], goda.uplift, KILONEWTON, "");
    let formula = ["M_Uw", "2/3 U_w B_c"];
    steps.add("Its moment about the heel", "Goda", formula, goda.uplift_moment, MOMENT, "");
}

fn heights(steps: &mut SheetSteps, sea: &Sea, GodaWaves { heights, goda, .. }: &GodaWaves) {
    let deep = match (heights, &goda.heights) {
        (Heights::DeepWater(height), Some(computed)) => Some((*height, computed)),
        _ => None,
    };
    let Some((height, computed)) = deep else {
        steps.know("H_13", goda.h_13, METRE);
        steps.know("H_max", goda.h_max, METRE);
        let given = "as given in the case file";
        steps.told("Significant wave height", "H_13", goda.h_13, METRE, given, "H13");
        steps.told("Maximum wave height", "H_max", goda.h_max, METRE, given, "Hmax");
        return breaking_depth(steps, goda);
    };
    steps.know("H_0'", height, METRE);
    let formula = ["K_s", "1/sqrt((1 + (4 π h÷L)/sinh(4 π h÷L)) tanh(2 π h÷L))"];
    steps.add("Shoaling", "linear theory", formula, computed.shoaling, NONE, "");
    if !computed.may_break {
        let ratio = sea.water_depth / goda.deep_water_wavelength;
        steps.note(&format!(
            "`h÷L0` = {ratio:.3} is not below 0.2: the heights are shoaled without breaking."
        ));
        let formula = ["H_13", "K_s H_0'"];
        steps.add("Significant wave height", "Goda", formula, goda.h_13, METRE, "H13");
        steps.add("Maximum wave height", "Goda", ["H_max", "1.8 K_s H_0'"], goda.h_max, METRE, "Hmax");
        return breaking_depth(steps, goda);
    }
    let significant = ["0.028", "0.52", "4.2", "0.92", "0.32"];
    terms(steps, "the significant height", "", significant, &computed.significant_terms);
    let formula = ["H_13", "min(β_0 H_0' + β_1 h, β_max H_0', K_s H_0')"];
    steps.add("Significant wave height", "Goda", formula, goda.h_13, METRE, "H13");
    breaking_depth(steps, goda);
    let maximum = ["0.052", "0.63", "3.8", "1.65", "0.53"];
    terms(steps, "the maximum height", "*", maximum, &computed.maximum_terms);
    let formula = ["H_max", "min(β_0* H_0' + β_1* h_b, β_max* H_0', 1.8 K_s H_0')"];
    steps.add("Maximum wave height", "Goda", formula, goda.h_max, METRE, "Hmax");
}

fn breaking_depth(steps: &mut SheetSteps, goda: &Goda) {
    let about = "Depth five significant heights in front of the wall";
    steps.add(about, "Goda", ["h_b", "h + 5 H_13 i"], goda.h_b, METRE, "h_b");
}

/// The terms of a breaking height; `star` tells those of the maximum height, as Goda does.
fn terms(
    steps: &mut SheetSteps,
    of: &str,
    star: &str,
    [c0, c1, s1, least, c_max]: [&str; 5],
    terms: &BreakingTerms,
) {
    let BreakingTerms { beta_0, beta_1, beta_max } = *terms;
    let [name_0, name_1, name_max] = ["β_0", "β_1", "β_max"].map(|name| format!("{name}{star}"));
    let formula = format!("{c0} (H_0'÷L0)^(−0.38) exp(20 i^1.5)");
    let about = format!("Terms of breaking of {of}");
    steps.add(&about, "Goda", [&name_0, &formula], beta_0, NONE, "");
    steps.add("", "Goda", [&name_1, &format!("{c1} exp({s1} i)")], beta_1, NONE, "");
    let formula = format!("max({least}, {c_max} (H_0'÷L0)^(−0.29) exp(2.4 i))");
    steps.add("", "Goda", [&name_max, &formula], beta_max, NONE, "");
}

fn angle(steps: &mut SheetSteps, GodaWaves { sea, choices, goda, .. }: &GodaWaves) {
    steps.know("β_g", sea.angle_deg, DEGREE);
    let about = "Angle of the waves from the wall's normal";
    let turned = choices.turn_deg > 0.0;
    if turned {
        steps.know("Δβ", choices.turn_deg, DEGREE);
    }
    let (about, formula) = match turned {
        true => (format!("{about}, turned towards it"), "max(β_g − Δβ, 0)"),
        false => (format!("{about}, as given"), "β_g"),
    };
    let result = Measured::of(goda.angle_deg, DEGREE);
    steps.step(&SheetStep { about: &about, reference: "", name: "β", formula, result, key: "angle_deg" });
}

/// Takahashi's coefficient and α*.
fn impulsive(steps: &mut SheetSteps, goda: &Goda, used: bool) {
    const TAKAHASHI: &str = "Takahashi";
    let Impulsive { delta_11, delta_22, delta_1, delta_2, alpha_i0, alpha_i1 } = goda.impulsive;
    let formula = ["δ_11", "0.93 (B_M/L − 0.12) + 0.36 ((h − d_M)/h − 0.6)"];
    steps.add("Impulsive breaking: shape of the berm", TAKAHASHI, formula, delta_11, NONE, "");
    let formula = ["δ_22", "0.93 ((h − d_M)/h − 0.6) − 0.36 (B_M/L − 0.12)"];
    steps.add("", TAKAHASHI, formula, delta_22, NONE, "");
    let formula = if delta_11 <= 0.0 { "20 δ_11" } else { "15 δ_11" };
    let about = if delta_11 <= 0.0 { "for `δ_11` ≤ 0" } else { "for `δ_11` > 0" };
    steps.add(about, TAKAHASHI, ["δ_1", formula], delta_1, NONE, "");
    let formula = if delta_22 <= 0.0 { "4.9 δ_22" } else { "3 δ_22" };
    let about = if delta_22 <= 0.0 { "for `δ_22` ≤ 0" } else { "for `δ_22` > 0" };
    steps.add(about, TAKAHASHI, ["δ_2", formula], delta_2, NONE, "");
    let formula = ["α_I0", "min(H_max/d_M, 2)"];
    steps.add("", TAKAHASHI, formula, alpha_i0, NONE, "");
    let (about, formula) = match delta_2 <= 0.0 {
        true => ("for `δ_2` ≤ 0", "cos(δ_2)/cosh(δ_1)"),
        false => ("for `δ_2` > 0", "1/(cosh(δ_1) sqrt(cosh(δ_2)))"),
    };
    steps.add(about, TAKAHASHI, ["α_I1", formula], alpha_i1, NONE, "");
    let formula = ["α_I", "α_I0 α_I1"];
    steps.add("Impulsive coefficient", TAKAHASHI, formula, goda.alpha_impulsive, NONE, "alpha_I");
    let (about, formula) = match used {
        true => ("Coefficient used", "max(α2, α_I)"),
        false => ("Coefficient used, without the impulsive one, as the case file asks", "α2"),
    };
    steps.add(about, TAKAHASHI, ["α*", formula], goda.alpha_star, NONE, "alpha_star");
}
