//! Sainflou's waves, for reading.

use standfast::wave::WavePhase;

use crate::case::StandingWaves;
use crate::key::Key;
use crate::layout::{columns, digits, row};
use standfast_inputs::OutputUnits;

/// The phase, in a word.
pub fn phase(phase: WavePhase) -> &'static str {
    match phase {
        WavePhase::Crest => "crest",
        WavePhase::Trough => "trough",
    }
}

pub(super) fn sea(
    StandingWaves { sea, height_key, wall, wave }: &StandingWaves,
    output: OutputUnits,
) -> String {
    let height = match height_key {
        Key::WaveHeight => output.length(wave.height),
        key => format!("{}, {}", output.length(wave.height), key.name()),
    };
    let rows = [
        row!["wave height H", height],
        row!["phase at the wall", phase(wave.phase)],
        row!["period T", format!("{} s", digits(sea.period))],
        row![
            "wavelength L",
            format!(
                "{} at the wall, L0 = {}",
                output.length(wave.wavelength),
                output.length(wave.deep_water_wavelength)
            )
        ],
        row!["water depth h", output.length(sea.water_depth)],
        row!["base depth h'", output.length(wall.base_depth)],
        row!["crest height h_c", format!("{} above still water", output.length(wall.crest_height))],
        row!["water density", format!("{} kg/m³", digits(sea.water_density))],
    ];
    columns(&rows, 2, &[])
}

pub(super) fn title(StandingWaves { wave, .. }: &StandingWaves) -> String {
    format!("Pressures on the wall (Sainflou, {}), beside still water", phase(wave.phase))
}

pub(super) fn pressures(StandingWaves { wave, wall, .. }: &StandingWaves, output: OutputUnits) -> String {
    let (side, at) = match wave.phase {
        WavePhase::Crest => ("above", "at still water"),
        WavePhase::Trough => ("below", "at the surface of the trough"),
    };
    let mut rows = vec![
        row!["h0", output.length(wave.h0), "middle of the wave above still water"],
        row!["surface", output.length(wave.surface.abs()), format!("{side} still water")],
        row!["p1", output.pressure(wave.p1), at],
        row!["p2", output.pressure(wave.p2), "at the bed"],
        row!["p_b", output.pressure(wave.pb), "at the base"],
    ];
    if wave.p4 > 0.0 {
        rows.push(row!["p4", output.pressure(wave.p4), "at the crest of the wall, where the wave is cut"]);
    }
    rows.push(row![
        "P_w",
        output.force(wave.force),
        format!("{} above the base", output.length(wave.force_moment / wave.force))
    ]);
    if wall.uplift {
        let words = "under the seaward toe, none at the heel (recalled, not read)";
        rows.push(row!["pu", output.pressure(wave.pu), words]);
        rows.push(row!["U_w", output.force(wave.uplift), "uplift"]);
    }
    columns(&rows, 2, &[])
}
