//! Waves on a crown wall: run-up, forces, and the ranges of the formula.

use standfast_cases::Case;
use standfast_cases::case::{CrownWall, CrownWaves};

use crate::measured::{ACCELERATION, DEGREE, DENSITY, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE, SECOND};
use crate::steps::SheetSteps;
use standfast_cases::layout::digits;

/// The title of the part.
pub(super) fn title(waves: &CrownWaves) -> &'static str {
    match waves.wall {
        CrownWall::Pedersen(_) => "Waves on the crown wall (Pedersen)",
        CrownWall::VanGent(_) => "Waves on the crown wall (Van Gent)",
    }
}

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, waves: &CrownWaves) {
    let CrownWaves { sea, armour, wall, wave } = waves;
    let source = match wall {
        CrownWall::Pedersen(_) => "Pedersen",
        CrownWall::VanGent(_) => "Van Gent",
    };
    steps.know_all([
        ("H_13", sea.significant, METRE),
        ("T", sea.period, SECOND),
        ("ρ", sea.water_density, DENSITY),
        ("g", case.gravity, ACCELERATION),
        ("cot_α", armour.slope, NONE),
        ("A_c", armour.crest, METRE),
    ]);
    steps.heading("Run-up");
    let l = wave.wavelength;
    steps.add("Wavelength in deep water", "linear theory", ["L0", "g T^2/(2 π)"], l, METRE, "");
    let formula = ["ξ_m", "1/(cot_α sqrt(H_13/L0))"];
    steps.add("Breaker parameter", source, formula, wave.xi, NONE, "");
    let add = |steps: &mut SheetSteps, about: &str, formula: [&str; 2], value, unit| {
        steps.add(about, source, formula, value, unit, "");
    };
    match wall {
        CrownWall::Pedersen(wall) => {
            let (about, formula) = match wave.xi <= 1.5 {
                true => ("Run-up, for `ξ_m` ≤ 1.5", "1.12 H_13 ξ_m"),
                false => ("Run-up, for `ξ_m` > 1.5", "1.34 H_13 ξ_m^0.55"),
            };
            add(steps, about, ["R", formula], wave.run_up, METRE);
            let Some(terms) = wave.pedersen else { return };
            steps.know_all([
                ("B_a", wall.armour_width, METRE),
                ("h_p", wall.protected, METRE),
                ("f_c", wall.free, METRE),
                ("V_a", wall.volume_share, NONE),
            ]);
            let slope = (1.0 / armour.slope).atan().to_degrees();
            steps.told("Slope of the armour", "α_a", slope, DEGREE, "from its cotangent", "");
            steps.told("Angle of the wedge of run-up", "ε_w", 15.0, DEGREE, "as Pedersen has it", "");
            steps.heading("Forces that 0.1 % of the waves exceed");
            let formula = ["p_m", "ρ g max(R − A_c, 0)"];
            add(steps, "Pressure at the crest of the armour", formula, terms.pm, KILOPASCAL);
            let formula = ["y_r", "max(R − A_c, 0) sin(ε_w)/(sin(α_a) cos(α_a − ε_w))"];
            add(steps, "Height of the wedge of run-up", formula, terms.y, METRE);
            add(
                steps,
                "Half of it acts, no higher than the wall",
                ["y_e", "min(y_r/2, f_c)"],
                terms.y_eff,
                METRE,
            );
            let formula = ["P_w", "0.21 sqrt(L0/B_a) (1.6 p_m y_e + 1/2 V_a p_m h_p)"];
            add(steps, "Horizontal force", formula, wave.force, KILONEWTON);
            let formula = ["M_w", "0.55 (h_p + y_e) P_w"];
            add(steps, "Its moment about the base", formula, terms.moment, MOMENT);
            let formula = ["p_u", "V_a p_m"];
            add(steps, "Uplift at the seaward edge, none at the heel", formula, wave.pu, KILOPASCAL);
            steps.know("B_w", wall.base, METRE);
        }
        CrownWall::VanGent(wall) => {
            steps.know_all([
                ("β_g", sea.angle_deg, DEGREE),
                ("γ_f", wall.roughness, NONE),
                ("H_w", wall.height, METRE),
                ("B_w", wall.base, METRE),
                ("F_b", wall.freeboard, METRE),
            ]);
            let (about, slope) = match wave.xi < 1.724 {
                true => ("Run-up of 2 %, for `ξ_m` < 1.724", "1.45 ξ_m"),
                false => ("Run-up of 2 %, for `ξ_m` ≥ 1.724", "(5 − 6.25/(1.45 ξ_m))"),
            };
            let formula = format!("γ_f H_13 {slope} (1/2 cos(β_g)^2 + 1/2)");
            add(steps, about, ["z", &formula], wave.run_up, METRE);
            steps.heading("Forces that 2 % of the waves exceed");
            let formula = ["P_w", "ρ g H_w max(z − A_c, 0)"];
            add(steps, "Horizontal force", formula, wave.force, KILONEWTON);
            let about = "Half the height of the wall, at which it is taken to act; the formula gives none";
            add(steps, about, ["e_w", "H_w/2"], wave.elevation, METRE);
            let moment = wave.force * wave.elevation;
            add(steps, "Its moment about the base", ["M_w", "P_w e_w"], moment, MOMENT);
            let formula = ["U_w", "0.4 ρ g B_w max(z − 0.75 A_c, 0) max(1 − sqrt(F_b/A_c), 0)"];
            add(steps, "Uplift", formula, wave.uplift, KILONEWTON);
            let about = "As a triangle, from the seaward edge to nothing";
            add(steps, about, ["p_u", "2 U_w/B_w"], wave.pu, KILOPASCAL);
        }
    }
    if wave.pedersen.is_some() {
        add(steps, "Uplift", ["U_w", "1/2 p_u B_w"], wave.uplift, KILONEWTON);
    }
    let ranges = wave.ratios.iter().map(|ratio| {
        let place = if ratio.is_inside() { "in" } else { "outside" };
        let [value, low, high] = [ratio.value, ratio.low, ratio.high].map(digits);
        format!("{} {value}, {place} {low} to {high}", ratio.name)
    });
    let ranges: Vec<String> = ranges.collect();
    steps.note(&format!("Ranges of the tests behind the formula: {}.", ranges.join("; ")));
}
