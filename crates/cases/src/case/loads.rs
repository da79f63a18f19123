//! The tables of water, uplift, earthquakes, added mass and forces.

use standfast::wave;
use standfast::{Body, HorizontalForce, Slip};

use super::table::{At, Field, Table};
use super::{Earthquake, Load, Problem, Uplift, Water, WaveLoad, impossible};
use crate::units::Quantity;

/// How far lengths that have to be equal may differ, m.
pub(super) const SAME_LENGTH: f64 = 1e-6;

pub(super) fn water(
    table: &Table<'_>,
    body: &Body,
    gravity: f64,
    wave: Option<&WaveLoad>,
) -> Result<Water, At> {
    table.only(&["level", "left", "right", "density"])?;
    let level = |key| table.optional(key, |field| field.not_negative(Quantity::Length));
    let (left, right) = match (level("level")?, level("left")?, level("right")?) {
        (Some(level), None, None) => (level, level),
        (None, Some(left), Some(right)) => (left, right),
        (None, None, None) => return Err(table.problem(Problem::NoLevel)),
        (None, Some(_), None) => return Err(table.problem(Problem::OneLevel { missing: "right" })),
        (None, None, Some(_)) => return Err(table.problem(Problem::OneLevel { missing: "left" })),
        (Some(_), _, _) => return Err(table.problem_at("level", Problem::LevelAndSides)),
    };
    let given = table.optional("density", |field| field.positive(Quantity::Density))?;
    let density = match (given, wave.map(|wave| wave.sea.water_density)) {
        (Some(density), Some(of_wave)) if density != of_wave => {
            return Err(table.problem_at("density", Problem::Densities { density, of_wave }));
        }
        (Some(density), _) | (None, Some(density)) => density,
        (None, None) => return Err(table.problem(Problem::NoWaterDensity)),
    };

    let right_key = if table.has("level") { "level" } else { "right" };
    let key = if table.has("left") && left > body.height() { "left" } else { right_key };
    body.still_water(left, right, density * gravity)
        .map_err(|error| impossible(table, &[("water level", key)], error))?;
    if let Some(wave) = wave.filter(|wave| (wave.section.base_depth - right).abs() > SAME_LENGTH) {
        let problem =
            Problem::LevelOfWave { key: right_key, level: right, base_depth: wave.section.base_depth };
        return Err(table.problem_at(right_key, problem));
    }
    Ok(Water { left, right, density })
}

pub(super) fn uplift(table: &Table<'_>) -> Result<Uplift, At> {
    table.only(&["left", "right", "grows"])?;
    let left = table.required("left", |field| field.not_negative(Quantity::Pressure))?;
    let right = table.required("right", |field| field.not_negative(Quantity::Pressure))?;
    let grows = table.optional("grows", Field::truth)?.unwrap_or(false);
    Ok(Uplift { left, right, grows })
}

pub(super) fn earthquake(table: &Table<'_>, gravity: f64) -> Result<Earthquake, At> {
    table.only(&["horizontal", "vertical"])?;
    let horizontal = table.required("horizontal", |field| field.acceleration(gravity))?;
    let vertical = table.optional("vertical", |field| field.acceleration(gravity))?.unwrap_or(0.0);
    Ok(Earthquake { horizontal, vertical })
}

pub(super) fn added_mass(
    table: &Table<'_>,
    water: Option<&Water>,
    wave: Option<&WaveLoad>,
) -> Result<f64, At> {
    table.only(&["mass", "sides"])?;
    let mass = table.optional("mass", |field| field.not_negative(Quantity::Mass))?;
    let sides = table.optional("sides", Field::sides)?;
    // The sea, or the water at the right, and the water at the left.
    let depths = match (water, wave) {
        (Some(water), _) => Some((water.density, water.right, water.left)),
        (None, Some(WaveLoad { sea, section, .. })) => {
            Some((sea.water_density, section.base_depth, section.base_depth))
        }
        (None, None) => None,
    };
    match (mass, sides, depths) {
        (Some(mass), None, _) => Ok(mass),
        (None, Some(1), Some((density, right, _))) => Ok(wave::added_mass(1, density, right)),
        (None, Some(_), Some((density, right, left))) => {
            Ok(wave::added_mass(1, density, right) + wave::added_mass(1, density, left))
        }
        (None, Some(_), None) => Err(table.problem_at("sides", Problem::SidesWithoutWater)),
        (None, None, _) => Err(table.problem(Problem::NoAddedMass)),
        (Some(_), Some(_), _) => Err(table.problem_at("sides", Problem::MassAndSides)),
    }
}

pub(super) fn force(table: &Table<'_>, body: &Body, friction: f64, gravity: f64) -> Result<Load, At> {
    table.only(&["name", "force", "elevation", "direction"])?;
    let name = table.optional("name", Field::text)?;
    // One line, as it stands in tables.
    let name = name.map(|name| name.split_whitespace().collect::<Vec<_>>().join(" "));
    let magnitude = table.required("force", |field| field.not_negative(Quantity::Force))?;
    let elevation = table.required("elevation", |field| {
        let elevation = field.not_negative(Quantity::Length)?;
        if elevation <= body.height() {
            Ok(elevation)
        } else {
            Err(field.problem(Problem::AboveCrest { height: body.height() }))
        }
    })?;
    let direction = table.optional("direction", Field::direction)?.unwrap_or(Slip::Left);
    let mechanics = |error| table.problem(Problem::Mechanics(error));
    let force = HorizontalForce::new(magnitude, elevation, direction).map_err(mechanics)?;
    let reduced = force.reduce(body, friction, gravity).map_err(mechanics)?;
    Ok(Load { name, force, reduced })
}
