//! The case file: a body, its friction and its loads, as a designer writes them.
//!
//! ```
//! let text = r#"
//! [body]
//! width = "15 m"
//! height = "12 m"
//! density = "2.1 t/m3"
//! friction = 0.6
//!
//! [[load]]
//! force = "450 kN/m"
//! elevation = "8 m"
//! "#;
//! let case = standfast_cases::Case::parse("case.toml", text)?;
//! assert_eq!(case.body.mass(), 378_000.0);
//! assert_eq!(case.loads[0].force.magnitude(), 450_000.0);
//! assert!(case.is_plain());
//! # Ok::<(), standfast_cases::CaseError>(())
//! ```
//!
//! A case with nothing but a uniform body and forces in air is *plain*: each force is the report's problem. Any other
//! has [`situations`](Case::situations), in which all loads act together.
//!
//! Nothing is guessed: a key, unit or value that is not understood is a [`CaseError`] that points at it.

mod body;
mod error;
mod input;
mod loads;
mod number;
mod situation;
mod table;
mod warning;
mod wave;

pub use error::{CaseError, Problem};
pub use input::{Input, inputs};
pub use number::{Number, NumberId, Replacement};
pub use situation::{Component, LoadedBody, Origin};
pub use wave::WaveLoad;

use std::ops::Range;

use standfast::{Body, HorizontalForce, InputError, Reduced};
use toml::de::DeTable;

use crate::units::Quantity;
use body::ReadBody;
use number::Numbers;
use table::{At, Field, Source, Table};

/// Standard acceleration of gravity as engineers round it, m/s².
const GRAVITY: f64 = 9.81;

/// A case: one body and the loads on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What the case is called.
    pub title: Option<String>,
    /// Where its numbers come from.
    pub note: Option<String>,
    /// Acceleration of gravity, m/s².
    pub gravity: f64,
    /// The body.
    pub body: Body,
    /// Coulomb friction μ between body and base, to stick.
    pub friction: f64,
    /// Coulomb friction μ to slip.
    pub kinetic_friction: f64,
    /// How water takes part in the weight.
    pub weight: Weight,
    /// Still water.
    pub water: Option<Water>,
    /// Pressures under the base.
    pub uplift: Option<Uplift>,
    /// Acceleration of the base.
    pub earthquake: Option<Earthquake>,
    /// Waves.
    pub wave: Option<WaveLoad>,
    /// Water that a horizontal motion carries along.
    pub added_mass: AddedMass,
    /// Forces, each an alternative to the others; all other loads act together with each.
    pub loads: Vec<Load>,
    /// Every number of the file, in the order they were read.
    pub numbers: Vec<Number>,
    plain: bool,
}

/// What the weight of the body stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight {
    /// m g; water under the base is a load of its own.
    Total,
    /// W', from which buoyancy is taken off already.
    Buoyant {
        /// W', N per metre run.
        force: f64,
        /// Its arm to O, m.
        arm: f64,
    },
}

/// Still water on both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Water {
    /// Its level above the base at the left, m.
    pub left: f64,
    /// Its level above the base at the right, m.
    pub right: f64,
    /// Its density, kg/m³.
    pub density: f64,
}

/// A pressure under the base, linear from corner to corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uplift {
    /// At O, Pa.
    pub left: f64,
    /// At O', Pa.
    pub right: f64,
    /// Whether it grows with the variable load.
    pub grows: bool,
}

/// Water that a horizontal motion carries along.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AddedMass {
    /// Its mass, kg per metre run.
    pub mass: f64,
    /// Height above the base at which it presses, m; `None` where the mass alone is given.
    pub height: Option<f64>,
}

/// An acceleration of the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earthquake {
    /// To the right, so that the force of inertia points left, m/s².
    pub horizontal: f64,
    /// Upwards, m/s².
    pub vertical: f64,
}

/// A force on the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What the force is called.
    pub name: Option<String>,
    /// The force.
    pub force: HorizontalForce,
    /// The force, alone and in air, on a uniform body, as a point of the k–μ plane.
    pub reduced: Reduced,
}

impl Case {
    /// Reads a case file; `name` is what errors call it.
    ///
    /// # Errors
    /// If the text is not TOML, or a key or value is not what a case file has.
    pub fn parse(name: &str, text: &str) -> Result<Case, CaseError> {
        Case::parse_with(name, text, &[])
    }

    /// Reads a case file as if some of its numbers were others.
    ///
    /// # Errors
    /// As [`parse`](Case::parse), the replaced numbers included.
    pub fn parse_with(name: &str, text: &str, replaced: &[Replacement]) -> Result<Case, CaseError> {
        let parsed = if text.trim().is_empty() {
            Err(At { problem: Problem::Empty { name: name.to_owned() }, span: 0..0 })
        } else {
            read(text, replaced)
        };
        parsed.map_err(|At { problem, span }| CaseError::new(name, text, problem, span))
    }

    /// Whether there is nothing but a uniform body in air, and forces.
    pub fn is_plain(&self) -> bool {
        self.plain
    }
}

const TABLES: &[&str] =
    &["title", "note", "gravity", "body", "load", "water", "uplift", "earthquake", "wave", "added_mass"];

/// The tables beside which a case needs no [[load]].
const OTHER_LOADS: [&str; 4] = ["water", "uplift", "earthquake", "wave"];

fn read(text: &str, replaced: &[Replacement]) -> Result<Case, At> {
    let document = DeTable::parse(text).map_err(|error| {
        let problem = Problem::Syntax(error.message().to_owned());
        At { problem, span: error.span().unwrap_or(0..0) }
    })?;
    let numbers = Numbers::new(replaced);
    let source = Source { text, numbers: &numbers };
    let top = Table::new(document.get_ref(), document.span(), "the case file", source);
    let case = read_tables(&top)?;
    Ok(Case { numbers: numbers.into_noted(), ..case })
}

fn read_tables(top: &Table<'_>) -> Result<Case, At> {
    top.only(TABLES)?;
    let title = top.optional("title", Field::text)?;
    let note = top.optional("note", Field::text)?;
    let gravity = top.optional("gravity", |field| field.positive(Quantity::Acceleration))?.unwrap_or(GRAVITY);

    let body_table = top.required("body", |field| field.table("[body]"))?;
    let ReadBody { body, friction, kinetic_friction, weight, plain } = body::read(&body_table)?;
    let table = |key, header| top.optional(key, |field| field.table(header));

    let wave = table("wave", "[wave]")?;
    let wave = wave.map(|table| wave::read(&table, &body, gravity)).transpose()?;
    let water = table("water", "[water]")?;
    let water = match (water, weight, &wave) {
        (Some(table), Weight::Buoyant { .. }, _) => return Err(table.problem(Problem::WaterTwice)),
        (None, Weight::Total, Some(_)) => return Err(top.problem_at("wave", Problem::NoWater)),
        (Some(table), Weight::Total, wave) => Some(loads::water(&table, &body, gravity, wave.as_ref())?),
        (None, _, _) => None,
    };
    let uplift = table("uplift", "[uplift]")?.map(|table| loads::uplift(&table)).transpose()?;
    let earthquake = table("earthquake", "[earthquake]")?;
    let earthquake = earthquake.map(|table| loads::earthquake(&table, gravity)).transpose()?;
    let added_mass = table("added_mass", "[added_mass]")?;
    let added_mass = added_mass
        .map(|table| loads::added_mass(&table, water.as_ref(), wave.as_ref()))
        .transpose()?
        .unwrap_or_default();
    let loads = if OTHER_LOADS.iter().any(|key| top.has(key)) {
        top.optional("load", |field| field.tables("[[load]]"))?.unwrap_or_default()
    } else {
        top.required("load", |field| field.tables("[[load]]"))?
    };
    let loads = loads
        .into_iter()
        .map(|table| loads::force(&table, &body, friction, gravity))
        .collect::<Result<_, _>>()?;

    let plain = plain && !OTHER_LOADS.iter().any(|key| top.has(key)) && !top.has("added_mass");
    Ok(Case {
        title,
        note,
        gravity,
        body,
        friction,
        kinetic_friction,
        weight,
        water,
        uplift,
        earthquake,
        wave,
        added_mass,
        loads,
        numbers: Vec::new(),
        plain,
    })
}

/// A problem that the library finds: shown at the key of its quantity, if it is a matter of that alone.
fn impossible(table: &Table<'_>, keys: &[(&str, &'static str)], error: InputError) -> At {
    match keys.iter().find(|(quantity, _)| *quantity == error.quantity) {
        Some((_, key)) => table.problem_at(key, Problem::Impossible { key, error }),
        None => table.problem(Problem::Mechanics(error)),
    }
}

/// A place in the text.
type Span = Range<usize>;
