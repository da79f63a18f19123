//! Names of loads.

use standfast::loads::{Action, Load, LoadSource};

/// Name of a load; words on its source, if it has none.
pub fn load_words(load: &Load) -> String {
    if let Some(name) = &load.name {
        return name.clone();
    }
    let words = match load.source {
        LoadSource::Weight => "weight m g",
        LoadSource::Buoyancy => "buoyancy",
        LoadSource::StillWater => "still water on the sides",
        LoadSource::WaterOnLeft if lifts(load) => "water under the overhang at the left",
        LoadSource::WaterOnRight if lifts(load) => "water under the overhang at the right",
        LoadSource::WaterOnLeft => "water standing on the left side",
        LoadSource::WaterOnRight => "water standing on the right side",
        LoadSource::Uplift => "uplift",
        LoadSource::HorizontalInertia => "earthquake, horizontal",
        LoadSource::ShakenWater => "water on the shaken wall",
        LoadSource::VerticalInertia => "earthquake, vertical",
        LoadSource::WavePressure => "wave pressure",
        LoadSource::WaveUplift => "wave uplift",
        LoadSource::Force => "force",
        LoadSource::Couple => "couple",
        LoadSource::Pressure => "pressure",
        _ => "load",
    };
    words.to_owned()
}

/// True if a force points upwards.
fn lifts(load: &Load) -> bool {
    matches!(load.action, Action::Force { up, .. } if up > 0.0)
}
