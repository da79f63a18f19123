//! Waves on a crown wall, for reading.

use super::{kilopascals, metres};
use crate::case::{CrownWall, CrownWaves};
use crate::layout::{columns, digits, row};
use crate::units::Extent;

pub(super) fn sea(CrownWaves { sea, armour, wall, wave }: &CrownWaves) -> String {
    let period = match wall {
        CrownWall::Pedersen(_) => "mean period T_m",
        CrownWall::VanGent(_) => "period T_m-1,0",
    };
    let mut rows = vec![
        row!["significant height H_s", metres(sea.significant)],
        row![period, format!("{} s", digits(sea.period))],
        row!["wavelength L", format!("{} in deep water", metres(wave.wavelength))],
    ];
    if let CrownWall::VanGent(_) = wall {
        rows.push(row!["angle β", format!("{}°", digits(sea.angle_deg))]);
    }
    rows.extend(
        sea.water_depth.map(|depth| row!["water depth h", format!("{}, for the range alone", metres(depth))]),
    );
    rows.push(row!["water density", format!("{} kg/m³", digits(sea.water_density))]);
    rows.push(row!["slope of the armour", format!("cot α = {}", digits(armour.slope))]);
    rows.push(row!["crest of the armour A_c", format!("{} above still water", metres(armour.crest))]);
    match wall {
        CrownWall::Pedersen(wall) => rows.extend([
            row!["width of its crest B_a", metres(wall.armour_width)],
            row!["wall behind the armour h'", metres(wall.protected)],
            row!["wall above it f_c", metres(wall.free)],
            row!["share of the wedge V", digits(wall.volume_share)],
        ]),
        CrownWall::VanGent(wall) => rows.extend([
            row!["height of the wall H_w", metres(wall.height)],
            row!["width of its base B_w", metres(wall.base)],
            row!["its base above still water F_b", metres(wall.freeboard)],
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

pub(super) fn forces(CrownWaves { wall, wave, .. }: &CrownWaves, extent: Extent) -> String {
    let mut rows = vec![row!["ξ", digits(wave.xi), "breaker parameter"]];
    let run_up = if matches!(wall, CrownWall::Pedersen(_)) { "R" } else { "z" };
    rows.push(row![run_up, metres(wave.run_up), "run-up above still water"]);
    let mut place = format!("{} above the base", metres(wave.elevation));
    match wave.pedersen {
        Some(terms) => rows.extend([
            row!["p_m", kilopascals(terms.pm), "at the armour's crest"],
            row!["y", metres(terms.y), "wedge of run-up"],
            row!["y_eff", metres(terms.y_eff), "half of it, no more than f_c"],
        ]),
        None => place += ", half the wall: the formula gives no height",
    }
    rows.push(row!["P_w", extent.kilonewtons(wave.force), place]);
    if let Some(terms) = wave.pedersen {
        rows.push(row!["M", extent.kilonewton_metres(terms.moment), "about the base"]);
    }
    let uplift = match wave.pedersen {
        Some(_) => "under the seaward edge, none at the heel",
        None => "under the seaward edge, none at the heel: the formula gives U alone",
    };
    rows.push(row!["pu", kilopascals(wave.pu), uplift]);
    rows.push(row!["U_w", extent.kilonewtons(wave.uplift), "uplift"]);
    columns(&rows, 2, &[])
}
