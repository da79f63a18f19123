//! Waves on a crown wall, for reading.

use crate::case::{CrownWall, CrownWaves};
use crate::layout::{columns, digits, row};
use standfast_inputs::OutputUnits;

pub(super) fn sea(CrownWaves { sea, armour, wall, wave }: &CrownWaves, output: OutputUnits) -> String {
    let period = match wall {
        CrownWall::Pedersen(_) => "mean period T_m",
        CrownWall::VanGent(_) => "period T_m-1,0",
    };
    let mut rows = vec![
        row!["significant height H_s", output.length(sea.significant)],
        row![period, format!("{} s", digits(sea.period))],
        row!["wavelength L", format!("{} in deep water", output.length(wave.wavelength))],
    ];
    if let CrownWall::VanGent(_) = wall {
        rows.push(row!["angle β", format!("{}°", digits(sea.angle_deg))]);
    }
    rows.extend(
        sea.water_depth
            .map(|depth| row!["water depth h", format!("{}, for the range alone", output.length(depth))]),
    );
    rows.push(row!["water density", format!("{} kg/m³", digits(sea.water_density))]);
    rows.push(row!["slope of the armour", format!("cot α = {}", digits(armour.slope))]);
    rows.push(row!["crest of the armour A_c", format!("{} above still water", output.length(armour.crest))]);
    match wall {
        CrownWall::Pedersen(wall) => rows.extend([
            row!["width of its crest B_a", output.length(wall.armour_width)],
            row!["wall behind the armour h'", output.length(wall.protected)],
            row!["wall above it f_c", output.length(wall.free)],
            row!["share of the wedge V", digits(wall.volume_share)],
        ]),
        CrownWall::VanGent(wall) => rows.extend([
            row!["height of the wall H_w", output.length(wall.height)],
            row!["width of its base B_w", output.length(wall.base)],
            row!["its base above still water F_b", output.length(wall.freeboard)],
            row!["roughness factor γ_f", digits(wall.roughness)],
        ]),
    }
    columns(&rows, 2, &[])
}

pub(super) fn title(CrownWaves { wall, .. }: &CrownWaves) -> String {
    let formula = match wall {
        CrownWall::Pedersen(_) => "Pedersen, exceeded by 0.1 % of the waves",
        CrownWall::VanGent(_) => "Van Gent, exceeded by 2 % of the waves",
    };
    format!("Forces on the wall ({formula})")
}

pub(super) fn forces(CrownWaves { wall, wave, .. }: &CrownWaves, output: OutputUnits) -> String {
    let mut rows = vec![row!["ξ", digits(wave.xi), "breaker parameter"]];
    let run_up = if matches!(wall, CrownWall::Pedersen(_)) { "R" } else { "z" };
    rows.push(row![run_up, output.length(wave.run_up), "run-up above still water"]);
    let mut place = format!("{} above the base", output.length(wave.elevation));
    match wave.pedersen {
        Some(terms) => rows.extend([
            row!["p_m", output.pressure(terms.pm), "at the armour's crest"],
            row!["y", output.length(terms.y), "wedge of run-up"],
            row!["y_eff", output.length(terms.y_eff), "half of it, no more than f_c"],
        ]),
        None => place += ", half the wall: the formula gives no height",
    }
    rows.push(row!["P_w", output.force(wave.force), place]);
    if let Some(terms) = wave.pedersen {
        rows.push(row!["M", output.moment(terms.moment), "about the base"]);
    }
    let uplift = match wave.pedersen {
        Some(_) => "under the seaward edge, none at the heel",
        None => "under the seaward edge, none at the heel: the formula gives U alone",
    };
    rows.push(row!["pu", output.pressure(wave.pu), uplift]);
    rows.push(row!["U_w", output.force(wave.uplift), "uplift"]);
    columns(&rows, 2, &[])
}
