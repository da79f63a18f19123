//! The table `[wave]`.

use standfast::Body;
use standfast::wave::{Choices, Goda, Heights, Sea, Section, goda};

use super::loads::SAME_LENGTH;
use super::table::{At, Field, Table};
use super::{Problem, impossible};
use crate::units::Quantity;

/// Waves from the right, and what they amount to by Goda's formulas.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveLoad {
    /// The sea.
    pub sea: Sea,
    /// The wave heights as they are given.
    pub heights: Heights,
    /// The caisson and its berm.
    pub section: Section,
    /// The choices in the formulas.
    pub choices: Choices,
    /// The pressures, forces and moments.
    pub goda: Goda,
}

const KEYS: &[&str] = &[
    "deep_water_height",
    "H13",
    "Hmax",
    "period",
    "sea_bottom_slope",
    "water_depth",
    "depth_above_berm",
    "base_depth",
    "crest_height",
    "berm_width",
    "caisson_width",
    "angle_deg",
    "turn_deg",
    "water_density",
    "impulsive",
    "lambda",
];

/// The names of the three factors.
const LAMBDA: [&str; 3] = ["lambda[1]", "lambda[2]", "lambda[3]"];

/// The library's names of what is given here.
const QUANTITIES: &[(&str, &str)] = &[
    ("depth above the berm", "depth_above_berm"),
    ("crest height", "crest_height"),
    ("maximum wave height", "Hmax"),
    ("wave angle", "angle_deg"),
    ("turn of the waves", "turn_deg"),
    ("factor lambda1", "lambda"),
];

pub(super) fn read(table: &Table<'_>, body: &Body, gravity: f64) -> Result<WaveLoad, At> {
    table.only(KEYS)?;
    let positive = |key| table.required(key, |field| field.positive(Quantity::Length));
    let sea = Sea {
        water_depth: positive("water_depth")?,
        sea_bottom_slope: table.required("sea_bottom_slope", Field::ratio)?,
        period: table.required("period", |field| field.positive(Quantity::Time))?,
        angle_deg: table.required("angle_deg", Field::ratio)?,
        water_density: table.required("water_density", |field| field.positive(Quantity::Density))?,
        gravity,
    };
    let heights = heights(table)?;
    let caisson_width = body.base_width();
    if let Some(width) = table.optional("caisson_width", |field| field.positive(Quantity::Length))?
        && (width - caisson_width).abs() > SAME_LENGTH
    {
        let problem = Problem::CaissonWidth { width, base: caisson_width };
        return Err(table.problem_at("caisson_width", problem));
    }
    let section = Section {
        base_depth: positive("base_depth")?,
        depth_above_berm: positive("depth_above_berm")?,
        crest_height: table.required("crest_height", |field| field.finite(Quantity::Length))?,
        berm_width: table.required("berm_width", |field| field.not_negative(Quantity::Length))?,
        caisson_width,
    };
    let default = Choices::default();
    let choices = Choices {
        lambda: table.optional("lambda", |field| field.three(LAMBDA))?.unwrap_or(default.lambda),
        impulsive: table.optional("impulsive", Field::truth)?.unwrap_or(default.impulsive),
        turn_deg: table.optional("turn_deg", Field::ratio)?.unwrap_or(default.turn_deg),
    };
    let goda =
        goda(&sea, &heights, &section, &choices).map_err(|error| impossible(table, QUANTITIES, error))?;
    let Section { base_depth, crest_height, .. } = section;
    if (base_depth + crest_height - body.height()).abs() > SAME_LENGTH {
        let problem = Problem::Height { base_depth, crest_height, height: body.height() };
        return Err(table.problem_at("crest_height", problem));
    }
    Ok(WaveLoad { sea, heights, section, choices, goda })
}

fn heights(table: &Table<'_>) -> Result<Heights, At> {
    let height = |key| table.optional(key, |field| field.positive(Quantity::Length));
    match (height("deep_water_height")?, height("H13")?, height("Hmax")?) {
        (Some(height), None, None) => Ok(Heights::DeepWater(height)),
        (None, Some(significant), Some(maximum)) => Ok(Heights::Local { significant, maximum }),
        (Some(_), _, _) => Err(table.problem_at("deep_water_height", Problem::DeepAndLocal)),
        (None, None, None) => Err(table.problem(Problem::NoWaveHeight)),
        (None, Some(_), None) => Err(table.problem_at("H13", Problem::OneWaveHeight { missing: "Hmax" })),
        (None, None, Some(_)) => Err(table.problem_at("Hmax", Problem::OneWaveHeight { missing: "H13" })),
    }
}
