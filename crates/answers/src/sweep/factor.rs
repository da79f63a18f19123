//! A number of a case that varies, and how its values are read: which key a name means, in which unit.

use thiserror::Error;

use crate::case::{Bias, OF_PARTS, goes_with_waves};
use crate::couple::{Unknown, Variable};
use crate::explained::Explained;
use crate::inputs::Inputs;
use crate::key::{Id, Key, Kind, Moves, Table};
use crate::suggest::closest;
use crate::units::{Dimension, GRAVITY_UNIT, Unit, UnitError, in_gravity};
use standfast_inputs::typed::number_and_rest;

/// A number of a case that varies, or a factor on its loads.
#[derive(Debug, Clone)]
pub struct Factor {
    quantity: Varies,
    unit: Counted,
    /// True if plain numbers have to have a unit, and none is said: of the acceleration of a base.
    unsaid: bool,
    /// The acceleration of gravity of the case, m/s²; `None` if it varies as well.
    gravity: Option<f64>,
}

/// What varies.
#[derive(Debug, Clone, PartialEq)]
enum Varies {
    Number(Variable),
    Bias(Bias),
}

/// Unit that a plain number counts.
#[derive(Debug, Clone, Copy)]
enum Counted {
    /// SI units, or nothing.
    Si,
    /// Another unit.
    Unit(Unit),
    /// The acceleration of gravity.
    Gravity,
}

/// Reason why a name is not a number that can vary.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum NoFactor {
    /// There is no such key.
    #[error("the case has no number `{}`", .0.name)]
    Unknown(Unknown),
    /// A key that the file does not have, and for which nothing is taken.
    #[error(
        "the case file has no `{name}`: what varies is in the file, or has a value where the file is silent and moves nothing else"
    )]
    Absent {
        /// The key.
        name: String,
        /// The numbers of the case.
        names: Vec<String>,
    },
    /// A factor on loads that the case does not have.
    #[error("the case has {lacks} for `{}` to be a factor on", bias.name())]
    NoLoad {
        /// The factor.
        bias: Bias,
        /// What it lacks.
        lacks: &'static str,
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

impl Explained for NoFactor {
    fn help(&self) -> Option<String> {
        let help = match self {
            NoFactor::Unknown(it) => unknown(it),
            NoFactor::Absent { names, .. } => format!(
                "put it into the case file, with any value it may have; what it has is {}",
                names.join(", ")
            ),
            _ => return None,
        };
        Some(help)
    }
}

fn unknown(unknown: &Unknown) -> String {
    let known = format!("its numbers are {}", unknown.names.join(", "));
    match &unknown.suggestion {
        Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
        None => known,
    }
}

/// What stands in brackets where a number has no unit.
pub const PLAIN: [&str; 3] = ["-", "1", ""];

/// The name that heads a column, and the unit in brackets behind it. As in `load[2].force` the bracket is part of the name where
/// nothing parts the two.
pub fn heading(column: &str) -> (&str, Option<&str>) {
    let parts = column.strip_suffix(']').and_then(|rest| rest.rsplit_once('['));
    match parts.filter(|(name, _)| name.ends_with(char::is_whitespace)) {
        Some((name, unit)) => (name.trim_end(), Some(unit.trim())),
        None => (column, None),
    }
}

impl Factor {
    /// The number of a case that is called `name`, as in [`Variable::find`], and besides one that the file leaves to what is
    /// taken for it, or a bound of the criteria. Plain numbers are in `unit`, or in SI units; those of accelerations of the base
    /// need one, as in the case file.
    ///
    /// # Errors
    /// If there is no such number, or the unit is not one of it.
    pub fn find(name: &str, unit: Option<&str>, inputs: &Inputs) -> Result<Factor, NoFactor> {
        if let Some(bias) = Bias::find(name) {
            return Factor::of_bias(bias, unit, inputs);
        }
        let variable = match Variable::find(name, inputs) {
            Ok(variable) => variable,
            Err(unknown) => match silent(inputs).find(|id| id.to_string() == name) {
                Some(id) => Variable::of(id, inputs),
                None => {
                    let names = Factor::names(inputs);
                    let nearest = || closest(name, names.iter().map(String::as_str)).map(str::to_owned);
                    let suggestion = unknown.suggestion.or_else(nearest);
                    // Of a name that is right but for its capitals, that in the file is meant.
                    let is_meant = |other: &String| other.to_lowercase() == name.to_lowercase();
                    if let Some(name) = known(name).filter(|_| !suggestion.as_ref().is_some_and(is_meant)) {
                        return Err(NoFactor::Absent { name, names });
                    }
                    return Err(NoFactor::Unknown(Unknown { suggestion, names, ..unknown }));
                }
            },
        };
        let gravity = is_shaking(&variable);
        let unsaid = unit.is_none() && gravity;
        let unit = match (unit, variable.dimension()) {
            (None | Some("g"), _) if gravity => Counted::Gravity,
            (None, _) => Counted::Si,
            (Some(unit), None) if PLAIN.contains(&unit) => Counted::Si,
            (Some(unit), dimension) => {
                let known = dimension.and_then(|dimension| dimension.unit(unit));
                let expected = || expected(dimension, gravity);
                let wrong =
                    || NoFactor::Unit { name: name.to_owned(), unit: unit.to_owned(), expected: expected() };
                Counted::Unit(known.ok_or_else(wrong)?)
            }
        };
        Ok(Factor { quantity: Varies::Number(variable), unit, unsaid, gravity: Some(inputs.gravity()) })
    }

    fn of_bias(bias: Bias, unit: Option<&str>, inputs: &Inputs) -> Result<Factor, NoFactor> {
        if let Some(lacks) = bias.lacks(inputs) {
            return Err(NoFactor::NoLoad { bias, lacks });
        }
        if let Some(unit) = unit.filter(|unit| !PLAIN.contains(unit)) {
            let (name, unit, expected) = (bias.name().to_owned(), unit.to_owned(), expected(None, false));
            return Err(NoFactor::Unit { name, unit, expected });
        }
        Ok(Factor { quantity: Varies::Bias(bias), unit: Counted::Si, unsaid: false, gravity: None })
    }

    /// What of a case can vary: the numbers that its file has, those that it leaves to what is taken for them, and factors on its loads.
    pub fn names(inputs: &Inputs) -> Vec<String> {
        let biases = Bias::ALL.into_iter().filter(|bias| bias.lacks(inputs).is_none());
        let numbers = Variable::all(inputs).chain(silent(inputs)).map(|id| id.to_string());
        numbers.chain(biases.map(|bias| bias.name().to_owned())).collect()
    }

    /// The key that a name means which is right but for its table and its capitals, of a table that the case has, and which the case
    /// file does not have: to be put into it.
    pub fn absent(name: &str, inputs: &Inputs) -> Option<String> {
        let is_it = |key: &&Key| {
            let info = key.info();
            let has_table = info.table == Table::Top || inputs.has(info.table);
            let called = [info.name.to_lowercase(), Id::from(**key).to_string().to_lowercase()];
            has_table && info.range().is_some() && called.contains(&name.to_lowercase())
        };
        let found = Key::ALL
            .iter()
            .copied()
            .filter(|key| key.info().table != Table::Criteria)
            .find(|key| is_it(&key))?;
        inputs.get(found).is_none().then(|| Id::from(found).to_string())
    }

    /// The factor where gravity varies as well: multiples of gravity are then not said in other units.
    pub(super) fn under_any_gravity(self) -> Factor {
        Factor { gravity: None, ..self }
    }

    /// The number of the case; `None` of a factor on its loads.
    pub fn variable(&self) -> Option<&Variable> {
        match &self.quantity {
            Varies::Number(variable) => Some(variable),
            Varies::Bias(_) => None,
        }
    }

    /// The factor on loads of the case, if it is one.
    pub fn bias(&self) -> Option<Bias> {
        match self.quantity {
            Varies::Number(_) => None,
            Varies::Bias(bias) => Some(bias),
        }
    }

    /// The key of the number of the case; `None` of a factor on its loads.
    pub fn id(&self) -> Option<Id> {
        self.variable().map(Variable::id)
    }

    /// The key of what varies, as a case file writes it.
    pub fn key(&self) -> String {
        match &self.quantity {
            Varies::Number(variable) => variable.id().to_string(),
            Varies::Bias(bias) => bias.name().to_owned(),
        }
    }

    /// True if it is the number under this key.
    pub(super) fn is(&self, key: Key) -> bool {
        self.id().is_some_and(|id| id.key == key)
    }

    fn dimension(&self) -> Option<Dimension> {
        self.variable().and_then(Variable::dimension)
    }

    /// True if its values count the acceleration of gravity, and are not in SI units.
    pub fn counts_gravity(&self) -> bool {
        matches!(self.unit, Counted::Gravity)
    }

    /// The value that a plain number stands for: in SI units, or in multiples of the acceleration of gravity.
    ///
    /// # Errors
    /// If it has to have a unit: an acceleration of the base that is not zero.
    pub fn value(&self, number: f64) -> Result<f64, UnitError> {
        // "-0.0" is zero, as it is in a file.
        Ok(0.0
            + match self.unit {
                _ if self.unsaid && number != 0.0 => return Err(UnitError::Missing),
                Counted::Si | Counted::Gravity => number,
                Counted::Unit(unit) => unit.si(number),
            })
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
        let unknown = |dimension: Dimension| UnitError::Unknown(dimension.si().to_owned());
        match (text.trim().parse::<f64>(), self.unit, self.dimension()) {
            (Ok(number), _, _) => self.value(number),
            (_, unit, Some(dimension)) => {
                let in_g = in_gravity(text).filter(|_| self.variable().is_some_and(is_shaking));
                Ok(0.0
                    + match (in_g, unit) {
                        (Some(share), Counted::Gravity) => share,
                        (Some(share), _) => share * self.gravity.ok_or_else(|| unknown(dimension))?,
                        (None, Counted::Gravity) => {
                            let acceleration = dimension.parse(text)?;
                            share(acceleration, self.gravity.ok_or_else(|| unknown(dimension))?)
                        }
                        (None, _) => dimension.parse(text)?,
                    })
            }
            // Two numbers to the one, a decimal to the other.
            (_, _, None) if text.trim().replace(',', ".").parse::<f64>().is_ok() => Err(UnitError::Separator),
            (_, _, None) => Err(match text.trim().split_once(char::is_whitespace) {
                Some((number, unit)) if number.parse::<f64>().is_ok() => {
                    UnitError::Unknown(unit.trim().to_owned())
                }
                _ => UnitError::Number,
            }),
        }
    }

    /// The same of the cell of a table, which may have a decimal comma.
    ///
    /// # Errors
    /// If it is neither, or its comma may be one between thousands: in words.
    pub fn read(&self, text: &str) -> Result<f64, String> {
        match self.parse(text) {
            Err(_) if text.contains(',') => {
                let (number, unit) = number_and_rest(text.trim())?;
                self.of(number, unit.trim()).map_err(|error| error.to_string())
            }
            parsed => parsed.map_err(|error| error.to_string()),
        }
    }

    /// The value of a number with a unit, or without one.
    fn of(&self, number: f64, unit: &str) -> Result<f64, UnitError> {
        let unknown = || UnitError::Unknown(unit.to_owned());
        if unit.is_empty() {
            return self.value(number);
        }
        let dimension = self.dimension().ok_or_else(unknown)?;
        let in_g = unit == GRAVITY_UNIT && self.variable().is_some_and(is_shaking);
        Ok(match (in_g, self.unit) {
            (true, Counted::Gravity) => number,
            (true, _) => number * self.gravity.ok_or_else(unknown)?,
            (false, counted) => {
                let si = dimension.unit(unit).ok_or_else(unknown)?.si(number);
                match counted {
                    Counted::Gravity => share(si, self.gravity.ok_or_else(unknown)?),
                    _ => si,
                }
            }
        })
    }

    /// Values that it takes, in words.
    pub fn expected(&self) -> String {
        let name = self.key();
        match self.unit {
            Counted::Gravity if self.gravity.is_none() => {
                format!("a number with the unit g, as gravity varies as well; or the name `{name} [g]`")
            }
            _ if self.unsaid => {
                let units = Dimension::Acceleration.understood();
                format!("a number with its unit, g, {units}; or the unit behind the name, as `{name} [g]`")
            }
            Counted::Gravity => {
                let units = Dimension::Acceleration.understood();
                format!("a number, which counts g, or one with its unit: g, {units}")
            }
            _ => match self.dimension() {
                Some(dimension) => {
                    format!("a number, or {} in {}", dimension.words(), dimension.understood())
                }
                None => "a number".to_owned(),
            },
        }
    }
}

/// True if it is an acceleration of the base, which g counts.
fn is_shaking(variable: &Variable) -> bool {
    variable.id().key.info().kind.is_of_shaking() && variable.dimension().is_some()
}

/// Acceleration as a multiple of that of gravity: the share that gives it back, where a float does.
fn share(acceleration: f64, gravity: f64) -> f64 {
    let share = acceleration / gravity;
    let near = [share, share.next_up(), share.next_down()];
    0.0 + near.into_iter().find(|near| near * gravity == acceleration).unwrap_or(share)
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
    let open = |key: &Key| {
        let info = key.info();
        // What is said of a list stands with the first of its numbers.
        let taken =
            (info.silent.is_some() || matches!(info.kind, Kind::OneOf(..))) && info.moves == Moves::Alone;
        // Of parts, centre, inertia and base follow.
        let taken =
            taken && !(inputs.has(Table::Part) && OF_PARTS.contains(key)) && goes_with_waves(inputs, *key);
        info.range().is_some() && (taken || info.table == Table::Criteria)
    };
    let in_tables = Table::ALL.into_iter().flat_map(|table| table.keys().map(move |key| (table, key)));
    in_tables.filter(move |(table, key)| *table != Table::History && open(key)).flat_map(
        move |(table, key)| {
            let count = match table {
                Table::Top | Table::Criteria => 1,
                table if table.is_history() => table.parent().map_or(0, |parent| inputs.count(parent)),
                table => inputs.count(table),
            };
            let there = move |index: &usize| !table.is_history() || inputs.has_at(table, *index);
            let ids = (0..count).filter(there).map(move |index| Id::of(table, index, key));
            ids.filter(move |id| table == Table::Criteria || inputs.get(*id).is_none())
        },
    )
}

/// The name as some case has it: right but for capitals.
fn known(name: &str) -> Option<String> {
    let (table, key) = name.rsplit_once('.').unwrap_or(("", name));
    let (bare, place) = table.split_once('[').map_or((table, ""), |(bare, _)| (bare, &table[bare.len()..]));
    let is_it = |candidate: &&Key| {
        let info = candidate.info();
        info.range().is_some()
            && info.name.to_lowercase() == key.to_lowercase()
            && info.table.name() == bare.to_lowercase()
    };
    let found = Key::ALL.iter().find(|candidate| is_it(candidate))?.info();
    Some(match found.table {
        Table::Top => found.name.to_owned(),
        table => format!("{}{place}.{}", table.name(), found.name),
    })
}

#[cfg(test)]
mod tests {
    use super::Factor;
    use crate::sweep::Sweep;
    use crate::units::UnitError;
    use standfast_model::CaseFile;

    const SHAKEN: &str =
        "[body]\nwidth = 1\nheight = 2\nmass = 4800\nfriction = 0.7\n[earthquake]\nhorizontal = \"0.2 g\"\n";

    /// A text in m/s² is the share of g whose product is that acceleration: as near as a float comes.
    #[test]
    fn accelerations_of_the_base_in_either_unit() {
        let file = CaseFile::parse("case.toml", SHAKEN).unwrap();
        let factor = Factor::find("earthquake.horizontal", None, file.inputs()).unwrap();
        assert_eq!(factor.parse("0.25 g"), Ok(0.25));
        assert_eq!(factor.parse("0.25"), Err(UnitError::Missing));
        assert_eq!(factor.parse("0"), Ok(0.0));
        let named = Factor::find("earthquake.horizontal", Some("g"), file.inputs()).unwrap();
        assert_eq!((named.parse("0.25"), named.value(0.25)), (Ok(0.25), Ok(0.25)));
        for hundredths in -300..300 {
            let acceleration = f64::from(hundredths) / 100.0;
            let share = factor.parse(&format!("{acceleration} m/s2")).unwrap();
            assert!(
                (share * 9.81 - acceleration).abs() <= f64::EPSILON * acceleration.abs(),
                "{acceleration}"
            );
        }
        let gravity = Factor::find("gravity", None, file.inputs()).unwrap();
        let sweep = Sweep::of(&file, vec![factor, gravity]).unwrap();
        assert!(sweep.factors()[0].parse("2 m/s2").is_err() && sweep.factors()[0].parse("0.2 g") == Ok(0.2));
    }

    #[test]
    fn names_that_are_right_but_for_their_capitals() {
        let file = CaseFile::parse("case.toml", SHAKEN).unwrap();
        assert_eq!(Factor::absent("VERTICAL", file.inputs()).as_deref(), Some("earthquake.vertical"));
        assert_eq!(Factor::absent("width", file.inputs()), None, "it is there");
        assert_eq!(Factor::absent("Hmax", file.inputs()), None, "the case has no waves");
        let names = Factor::names(file.inputs());
        assert!(names.iter().any(|name| name == "gravity") && names.iter().any(|name| name == "body.width"));
    }
}
