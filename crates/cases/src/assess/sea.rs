//! The sea, the waves and their pressures, for reading.

mod crown;
mod standing;

use standfast::wave::Heights;

use super::text::warnings;
use crate::case::{Case, GodaWaves, WaveFormula, Waves};
use crate::layout::{columns, digits, row};
use standfast_inputs::OutputUnits;
use standfast_model::Warning;

pub(super) fn render(case: &Case, wave: &Waves) -> String {
    let output = case.output;
    let sea = match &wave.formula {
        WaveFormula::Goda(wave) => sea(wave, output),
        WaveFormula::Sainflou(wave) => standing::sea(wave, output),
        WaveFormula::Crown(wave) => crown::sea(wave, output),
    };
    let warnings = warnings(case, Warning::is_about_waves);
    format!("\nSea and waves\n{sea}{warnings}\n{}", pressures(wave, output))
}

/// What the waves amount to, under a title.
pub(super) fn pressures(wave: &Waves, output: OutputUnits) -> String {
    match &wave.formula {
        WaveFormula::Goda(wave) => format!("Pressures on the wall (Goda)\n{}", of_goda(wave, output)),
        WaveFormula::Sainflou(wave) => {
            format!("{}\n{}", standing::title(wave), standing::pressures(wave, output))
        }
        WaveFormula::Crown(wave) => format!("{}\n{}", crown::title(wave), crown::forces(wave, output)),
    }
}

/// Where a period comes from that goes with the height.
fn of_steepness(steepness: Option<f64>) -> String {
    steepness.map_or(String::new(), |s| format!(", of the steepness H0'/L0 = {}", digits(s)))
}

fn sea(
    GodaWaves { sea, steepness, heights, section, choices, goda, .. }: &GodaWaves,
    output: OutputUnits,
) -> String {
    let mut rows = Vec::new();
    match *heights {
        Heights::DeepWater(height) => {
            rows.push(row!["deep-water height H0'", output.length(height)]);
            let from = "from H0' by shoaling and breaking";
            rows.push(row!["significant height H13", format!("{}, {from}", output.length(goda.h_13))]);
            rows.push(row!["maximum height Hmax", format!("{}, {from}", output.length(goda.h_max))]);
        }
        Heights::Local { .. } => {
            rows.push(row!["significant height H13", format!("{}, as given", output.length(goda.h_13))]);
            rows.push(row!["maximum height Hmax", format!("{}, as given", output.length(goda.h_max))]);
        }
    }
    let turned = match choices.turn_deg {
        0.0 => "as given, not turned towards the normal".to_owned(),
        turn => format!("{}° turned towards the normal by up to {}°", digits(sea.angle_deg), digits(turn)),
    };
    rows.extend([
        row!["period T13", format!("{} s{}", digits(sea.period), of_steepness(*steepness))],
        row![
            "wavelength L",
            format!(
                "{} at the wall, L0 = {}",
                output.length(goda.wavelength),
                output.length(goda.deep_water_wavelength)
            )
        ],
        row!["angle β", format!("{}° ({turned})", digits(goda.angle_deg))],
        row![
            "water depth h",
            format!("{}, bed slope {}", output.length(sea.water_depth), digits(sea.sea_bottom_slope))
        ],
        row!["depth h_b", format!("{} at 5 H13 in front of the wall", output.length(goda.h_b))],
        row![
            "depth above berm d",
            format!(
                "{}, berm width B_M = {}",
                output.length(section.depth_above_berm),
                output.length(section.berm_width)
            )
        ],
        row!["base depth h'", output.length(section.base_depth)],
        row!["crest height h_c", format!("{} above still water", output.length(section.crest_height))],
        row!["water density", format!("{} kg/m³", digits(sea.water_density))],
    ]);
    columns(&rows, 2, &[])
}

fn of_goda(GodaWaves { choices, goda, .. }: &GodaWaves, output: OutputUnits) -> String {
    let [λ1, λ2, λ3] = choices.lambda.map(digits);
    let impulsive = if choices.impulsive { "in use" } else { "not used" };
    let rows = [
        row![
            "η*",
            output.length(goda.eta_star),
            format!("acts up to h_c* = {} above still water", output.length(goda.h_c_star))
        ],
        row!["α1", digits(goda.alpha_1), format!("λ1, λ2, λ3 = {λ1}, {λ2}, {λ3}")],
        row!["α2", digits(goda.alpha_2)],
        row!["α_I", digits(goda.alpha_impulsive), format!("Takahashi's impulsive coefficient, {impulsive}")],
        row!["α*", digits(goda.alpha_star)],
        row!["α3", digits(goda.alpha_3)],
        row!["α4", digits(goda.alpha_4)],
        row!["p1", output.pressure(goda.p1), "at still water"],
        row!["p3", output.pressure(goda.p3), "at the base"],
        row!["p4", output.pressure(goda.p4), "at the top of the loaded wall"],
        row!["pu", output.pressure(goda.pu), "uplift at the seaward toe, none at the heel"],
    ];
    columns(&rows, 2, &[])
}
