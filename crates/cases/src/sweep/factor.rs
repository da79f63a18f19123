//! A number of a case that varies, and how its values are read: which key a name means, in which unit.

use miette::Diagnostic;
use thiserror::Error;

use crate::case::OF_PARTS;
use crate::couple::{Unknown, Variable};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Kind, Moves, Table};
use crate::suggest::closest;
use crate::units::{Dimension, Unit, UnitError, in_gravity};

/// A number of a case that varies.
#[derive(Debug, Clone)]
pub struct Factor {
    variable: Variable,
    unit: Counted,
}

/// What a plain number counts.
#[derive(Debug, Clone, Copy)]
enum Counted {
    /// SI units, or nothing.
    Si,
    /// Another unit.
    Unit(Unit),
    /// The acceleration of gravity.
    Gravity,
}

/// Why a name is no number that can vary.
#[derive(Debug, Clone, PartialEq, Eq, Error, Diagnostic)]
#[non_exhaustive]
pub enum NoFactor {
    /// There is no such key.
    #[error("the case has no number `{}`", .0.name)]
    #[diagnostic(help("{}", unknown(.0)))]
    Unknown(Unknown),
    /// A key that the file does not have, and for which nothing is taken.
    #[error(
        "the case file has no `{name}`: what varies is in the file, or has a value where the file is silent and moves nothing else"
    )]
    #[diagnostic(help("put it into the case file, with any value it may have; what it has is {}", names.join(", ")))]
    Absent {
        /// The key.
        name: String,
        /// The numbers of the case.
        names: Vec<String>,
    },
    /// A unit of something else.
    #[error("`{name}` in `{unit}`: the unit does not fit; expected {expected}")]
    Unit {
        /// The name.
        name: String,
        /// The unit.
        unit: String,
        /// The units understood.
        expected: String,
    },
}

fn unknown(unknown: &Unknown) -> String {
    let known = format!("its numbers are {}", unknown.names.join(", "));
    match &unknown.suggestion {
        Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
        None => known,
    }
}

impl Factor {
    /// The number of a case that is called `name`, as in [`Variable::find`], and besides one that the file leaves to what is
    /// taken for it, or a bound of the criteria. Plain numbers are in `unit`, or in that of the case file: SI, but for
    /// accelerations of the base, which count g.
    ///
    /// # Errors
    /// If there is no such number, or the unit is not one of it.
    pub fn find(name: &str, unit: Option<&str>, inputs: &Inputs) -> Result<Factor, NoFactor> {
        let variable = match Variable::find(name, inputs) {
            Ok(variable) => variable,
            Err(unknown) => match silent(inputs).find(|id| id.to_string() == name) {
                Some(id) => Variable::of(id, inputs),
                None if is_key(name) => {
                    return Err(NoFactor::Absent { name: name.to_owned(), names: unknown.names });
                }
                None => {
                    let more = silent(inputs).map(|id| id.to_string());
                    let names: Vec<String> = unknown.names.into_iter().chain(more).collect();
                    let nearest = || closest(name, names.iter().map(String::as_str)).map(str::to_owned);
                    let suggestion = unknown.suggestion.or_else(nearest);
                    return Err(NoFactor::Unknown(Unknown { suggestion, names, ..unknown }));
                }
            },
        };
        let gravity = variable.id().key.info().kind == Kind::InGravity;
        let unit = match (unit, variable.dimension()) {
            (None, _) if gravity => Counted::Gravity,
            (Some("g"), _) if gravity => Counted::Gravity,
            (None, _) | (Some("-" | "1" | ""), None) => Counted::Si,
            (Some(unit), dimension) => {
                let known = dimension.and_then(|dimension| dimension.unit(unit));
                let expected = || expected(dimension, gravity);
                let wrong =
                    || NoFactor::Unit { name: name.to_owned(), unit: unit.to_owned(), expected: expected() };
                Counted::Unit(known.ok_or_else(wrong)?)
            }
        };
        Ok(Factor { variable, unit })
    }

    /// The number of the case.
    pub fn variable(&self) -> &Variable {
        &self.variable
    }

    /// Whether its values count the acceleration of gravity, and are not in SI units.
    pub fn counts_gravity(&self) -> bool {
        matches!(self.unit, Counted::Gravity)
    }

    /// The value that a plain number stands for: in SI units, or in multiples of the acceleration of gravity.
    pub fn value(&self, number: f64) -> f64 {
        // "-0.0" is zero, as it is in a file.
        0.0 + match self.unit {
            Counted::Si | Counted::Gravity => number,
            Counted::Unit(unit) => unit.si(number),
        }
    }

    /// The unit of plain numbers, where that is not the one of the values.
    pub fn unit(&self) -> Option<Unit> {
        match self.unit {
            Counted::Si | Counted::Gravity => None,
            Counted::Unit(unit) => Some(unit),
        }
    }

    /// The value that a text says: a plain number, or one with its unit.
    ///
    /// # Errors
    /// If it is neither.
    pub fn parse(&self, text: &str) -> Result<f64, UnitError> {
        match (text.trim().parse::<f64>(), self.unit, self.variable.dimension()) {
            (Ok(number), _, _) => Ok(self.value(number)),
            (_, Counted::Gravity, Some(dimension)) => {
                in_gravity(text).ok_or_else(|| match dimension.parse(text) {
                    Ok(_) => UnitError::Unknown(dimension.si().to_owned()),
                    Err(error) => error,
                })
            }
            (_, _, Some(dimension)) => Ok(0.0 + dimension.parse(text)?),
            // Two numbers to the one, a decimal to the other.
            (_, _, None) if text.trim().replace(',', ".").parse::<f64>().is_ok() => Err(UnitError::Comma),
            (_, _, None) => Err(UnitError::Number),
        }
    }

    /// What its values have to be, in words.
    pub fn expected(&self) -> String {
        match self.unit {
            Counted::Gravity => "a number, which counts g, or one with that unit".to_owned(),
            _ => match self.variable.dimension() {
                Some(dimension) => {
                    format!("a number, or {} in {}", dimension.words(), dimension.understood())
                }
                None => "a number".to_owned(),
            },
        }
    }
}

fn expected(dimension: Option<Dimension>, gravity: bool) -> String {
    match dimension {
        Some(dimension) if gravity => format!("g, {}", dimension.understood()),
        Some(dimension) => dimension.understood(),
        None => "no unit".to_owned(),
    }
}

/// Numbers that a file does not have, of which the case is none the less complete: what is taken for them is said, and nothing
/// goes with them; and bounds, where results are asked for.
fn silent(inputs: &Inputs) -> impl Iterator<Item = Id> {
    let open = |key: &&Key| {
        let info = key.info();
        let taken = info.silent.is_some() && info.moves == Moves::Alone;
        // Of parts, centre, inertia and base follow.
        let taken = taken && !(inputs.has(Table::Part) && OF_PARTS.contains(*key));
        info.range().is_some() && (taken || info.table == Table::Criteria)
    };
    Key::ALL.iter().filter(open).flat_map(move |key| {
        let table = key.info().table;
        let count = match table {
            Table::Top | Table::Criteria => 1,
            table => inputs.count(table),
        };
        let ids = (0..count).map(|index| Id { key: *key, index });
        ids.filter(move |id| table == Table::Criteria || inputs.get(*id).is_none())
    })
}

/// Whether some case has a number of this name.
fn is_key(name: &str) -> bool {
    let (table, key) = name.rsplit_once('.').unwrap_or(("", name));
    let table = table.split_once('[').map_or(table, |(table, _)| table);
    let is_it = |candidate: &&Key| candidate.name() == key && candidate.info().table.name() == table;
    Key::ALL.iter().any(|candidate| is_it(&candidate) && candidate.info().range().is_some())
}
