//! The table `[body]`.

use standfast::Body;

use super::table::{At, Field, Table};
use super::{Problem, Weight, impossible};
use crate::units::Quantity;

/// What the table says.
pub(super) struct ReadBody {
    pub(super) body: Body,
    pub(super) friction: f64,
    pub(super) kinetic_friction: f64,
    pub(super) weight: Weight,
    /// Whether it is a uniform body in air with one friction.
    pub(super) plain: bool,
}

const KEYS: &[&str] = &[
    "width",
    "height",
    "mass",
    "density",
    "friction",
    "kinetic_friction",
    "centroid_offset",
    "centroid_height",
    "moment_of_inertia",
    "base_left",
    "base_right",
    "buoyant_weight",
    "weight_arm",
];

/// The keys of a plain body are the first.
const PLAIN: usize = 5;

pub(super) fn read(table: &Table<'_>) -> Result<ReadBody, At> {
    table.only(KEYS)?;
    let width = table.required("width", |field| field.positive(Quantity::Length))?;
    let height = table.required("height", |field| field.positive(Quantity::Length))?;
    let body = match (table.get("mass"), table.get("density")) {
        (Some(_), Some(density)) => return Err(density.problem(Problem::MassAndDensity)),
        (None, None) => return Err(table.problem(Problem::NoMass)),
        (Some(mass), None) => Body::new(width, height, mass.positive(Quantity::Mass)?),
        (None, Some(density)) => Body::of_density(width, height, density.positive(Quantity::Density)?),
    };
    let friction = table.required("friction", Field::ratio)?;
    // Signs are fine; what remains is the library's range, for the numbers and what follows from them.
    let body = body.map_err(|error| table.problem(Problem::Mechanics(error)))?;
    let kinetic_friction = table.optional("kinetic_friction", Field::ratio)?.unwrap_or(friction);
    if kinetic_friction > friction {
        let problem = Problem::KineticFriction { kinetic: kinetic_friction, friction };
        return Err(table.problem_at("kinetic_friction", problem));
    }
    let body = shape(table, body)?;
    let weight = weight(table, &body)?;
    let plain = !KEYS[PLAIN..].iter().any(|key| table.has(key));
    Ok(ReadBody { body, friction, kinetic_friction, weight, plain })
}

/// The body with the centre of mass, inertia and base that are given.
fn shape(table: &Table<'_>, mut body: Body) -> Result<Body, At> {
    const KEYS: &[(&str, &str)] = &[
        ("offset of the centre of mass", "centroid_offset"),
        ("height of the centre of mass", "centroid_height"),
        ("moment of inertia", "moment_of_inertia"),
    ];
    let failed = |error| impossible(table, KEYS, error);
    let half = body.width() / 2.0;
    let left = table.optional("base_left", |field| field.positive(Quantity::Length))?.unwrap_or(half);
    let right = table.optional("base_right", |field| field.positive(Quantity::Length))?.unwrap_or(half);
    let offset = table.optional("centroid_offset", |field| field.finite(Quantity::Length))?;
    let height = table.optional("centroid_height", |field| field.positive(Quantity::Length))?;
    body = body.with_base(left, right).map_err(failed)?;
    let height = height.unwrap_or(body.centroid_height());
    body = body.with_centroid(offset.unwrap_or(0.0), height).map_err(failed)?;
    match table.optional("moment_of_inertia", |field| field.positive(Quantity::Inertia))? {
        Some(moment) => body.with_moment_of_inertia(moment).map_err(failed),
        None => Ok(body),
    }
}

fn weight(table: &Table<'_>, body: &Body) -> Result<Weight, At> {
    let force = table.optional("buoyant_weight", |field| field.positive(Quantity::Force))?;
    let arm = table.optional("weight_arm", |field| field.positive(Quantity::Length))?;
    match (force, arm) {
        (Some(force), arm) => Ok(Weight::Buoyant { force, arm: arm.unwrap_or(body.heel_distance()) }),
        (None, None) => Ok(Weight::Total),
        (None, Some(_)) => Err(table.problem_at("weight_arm", Problem::ArmWithoutWeight)),
    }
}
