//! The case file: a body, its friction and the forces on it, as a designer writes them.
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
//! let case = standfast_cli::case::Case::parse("case.toml", text)?;
//! assert_eq!(case.body.mass(), 378_000.0);
//! assert_eq!(case.loads[0].force.magnitude(), 450_000.0);
//! # Ok::<(), standfast_cli::case::CaseError>(())
//! ```
//!
//! Nothing is guessed: a key, unit or value that is not understood is a [`CaseError`] that points at it.

mod error;
mod table;

pub use error::{CaseError, Problem};

use std::ops::Range;

use standfast::{Body, HorizontalForce, Reduced, Slip};
use toml::de::DeTable;

use crate::units::Quantity;
use table::{At, Field, Table};

/// Standard acceleration of gravity as engineers round it, m/s².
const GRAVITY: f64 = 9.81;

/// A case: one body and the forces on it, one by one.
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
    /// Coulomb friction μ between body and base.
    pub friction: f64,
    /// The forces; at least one.
    pub loads: Vec<Load>,
}

/// A force on the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What the force is called.
    pub name: Option<String>,
    /// The force.
    pub force: HorizontalForce,
    /// The force on this body as a point of the k–μ plane.
    pub reduced: Reduced,
}

impl Case {
    /// Reads a case file; `name` is what errors call it.
    ///
    /// # Errors
    /// If the text is not TOML, or a key or value is not what a case file has.
    pub fn parse(name: &str, text: &str) -> Result<Case, CaseError> {
        let parsed = if text.trim().is_empty() {
            Err(At { problem: Problem::Empty { name: name.to_owned() }, span: 0..0 })
        } else {
            read(text)
        };
        parsed.map_err(|At { problem, span }| CaseError::new(name, text, problem, span))
    }
}

fn read(text: &str) -> Result<Case, At> {
    let document = DeTable::parse(text).map_err(|error| {
        let problem = Problem::Syntax(error.message().to_owned());
        At { problem, span: error.span().unwrap_or(0..0) }
    })?;
    let top = Table::new(document.get_ref(), document.span(), "the case file", text);
    top.only(&["title", "note", "gravity", "body", "load"])?;

    let title = top.optional("title", Field::text)?;
    let note = top.optional("note", Field::text)?;
    let gravity = top.optional("gravity", |field| field.positive(Quantity::Acceleration))?.unwrap_or(GRAVITY);

    let (body, friction) = read_body(&top.required("body", |field| field.table("[body]"))?)?;
    let loads = top.required("load", |field| field.tables("[[load]]"))?;
    let loads = loads
        .into_iter()
        .map(|table| read_load(&table, &body, friction, gravity))
        .collect::<Result<_, _>>()?;
    Ok(Case { title, note, gravity, body, friction, loads })
}

fn read_body(table: &Table<'_>) -> Result<(Body, f64), At> {
    table.only(&["width", "height", "mass", "density", "friction"])?;
    let width = table.required("width", |field| field.positive(Quantity::Length))?;
    let height = table.required("height", |field| field.positive(Quantity::Length))?;
    let body = match (table.get("mass"), table.get("density")) {
        (Some(_), Some(density)) => return Err(density.problem(Problem::MassAndDensity)),
        (None, None) => return Err(table.problem(Problem::NoMass)),
        (Some(mass), None) => Body::new(width, height, mass.positive(Quantity::Mass)?),
        (None, Some(density)) => Body::of_density(width, height, density.positive(Quantity::Density)?),
    };
    let friction = table.required("friction", Field::friction)?;
    // Signs are fine; what remains is the library's range, for the numbers and what follows from them.
    Ok((body.map_err(|error| table.problem(Problem::Mechanics(error)))?, friction))
}

fn read_load(table: &Table<'_>, body: &Body, friction: f64, gravity: f64) -> Result<Load, At> {
    table.only(&["name", "force", "elevation", "direction"])?;
    let name = table.optional("name", Field::text)?;
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

/// A place in the text.
type Span = Range<usize>;
