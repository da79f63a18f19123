//! Tables of motions: a case in time of which the columns of a table vary numbers and words, a record's name among them.
//!
//! A column is called by the key that it varies, as in `block.mu_s`, `motion.base.horizontal.file` or `load[2].force`, or by a short
//! name. Numbers are varied as in every table of cases, with what goes with them; words stand in place of those of the file.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use standfast_model::{CaseFile, motions};
use standfast_motion::{End, MotionOutcome};
use thiserror::Error;

use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::{Follow, FollowedMotion};
use crate::case::{Bias, Case};
use crate::couple::{Unknown, Variable, vary};
use crate::error::{CaseError, Fault, Problem};
use crate::explained::Explained;
use crate::inputs::{Inputs, Value};
use crate::key::{Id, Key, Kind, Table, without_places};
use crate::parse::read;
use crate::record::{ReadFile, RecordFile};
use crate::suggest::closest;
use crate::sweep::{self, Factor, NoFactor, heading};

/// The results of a row, in their order.
pub const RESULTS: [&str; 19] = [
    "end",
    "slide",
    "max_slide",
    "max_theta",
    "max_theta_of_balance",
    "overturned",
    "past_balance",
    "impacts",
    "t_rest",
    "t_final",
    "unique",
    "overturned_share",
    "overturned_share_low",
    "overturned_share_high",
    "met",
    "utilisation",
    "criterion",
    "situation",
    "warnings",
];

/// Those of copies.
const OF_COPIES: [&str; 3] = ["overturned_share", "overturned_share_low", "overturned_share_high"];

/// Those that say how far the criteria are met.
const OF_CRITERIA: [&str; 3] = ["met", "utilisation", "criterion"];

/// Reason why a column varies nothing that it should.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ColumnError {
    /// It is not a number of the case, or its unit does not fit.
    #[error("column {column}: {error}")]
    NoFactor {
        /// The column.
        column: String,
        /// The error of the name or the unit.
        error: Box<NoFactor>,
    },
    /// It has the name of a key that the file does not have.
    #[error(
        "column {column}: the case file has no such key; if it is meant to vary, put it in, with any value it may have"
    )]
    Absent {
        /// The column.
        column: String,
    },
    /// A factor on loads, of which a motion has none.
    #[error("column {column}: a factor on loads varies with a case at rest; a motion has none")]
    Bias {
        /// The column.
        column: String,
    },
    /// It names a table, or a list.
    #[error(
        "column {column} is a table or a list of the case file; expected a key with one value, as in motion.base.horizontal.file"
    )]
    NoValue {
        /// The column.
        column: String,
    },
    /// Two columns vary one key.
    #[error("the columns {one} and {two} both vary {key}")]
    SameKey {
        /// A column.
        one: String,
        /// Another.
        two: String,
        /// The key.
        key: String,
    },
    /// The case makes no sense.
    #[error(transparent)]
    Case(#[from] CaseError),
}

impl Explained for ColumnError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            ColumnError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            ColumnError::NoFactor { error, .. } => error.help(),
            _ => None,
        }
    }
}

/// A row that has no answer: the places of the columns that are to blame, and what is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowFault {
    /// The columns.
    pub columns: Vec<usize>,
    /// Fault, in words.
    pub problem: String,
}

/// Entry that a column varies.
#[derive(Debug, Clone)]
enum Varied {
    /// A number, with what goes with it.
    Number(Box<Factor>, Variable),
    /// Words, true or false, or the name of a file.
    Word(Id),
}

impl Varied {
    fn id(&self) -> Id {
        match self {
            Varied::Number(_, variable) => variable.id(),
            Varied::Word(id) => *id,
        }
    }
}

/// A case in time and what the columns of a table vary of it.
#[derive(Debug)]
pub struct MotionRows {
    inputs: Inputs,
    /// The case of the inputs, by which numbers go together; none of a body in pure numbers.
    case: Option<Case>,
    /// The place of each column that varies something, and what.
    varied: Vec<(usize, Varied)>,
    /// True if there are criteria on the motion.
    asks: bool,
    /// Notes on the numbers that go with those that vary, in sentences.
    notes: Vec<String>,
    /// The files that rows name, each read once.
    records: Mutex<BTreeMap<String, Result<Arc<RecordFile>, String>>>,
}

impl MotionRows {
    /// The case of a file, with the files that it names, and the columns of a table. Those that have the name of no key vary nothing.
    ///
    /// # Errors
    /// If a column cannot vary what it names, or the case makes no sense.
    pub fn of(file: &CaseFile, columns: &[String]) -> Result<MotionRows, ColumnError> {
        let inputs = file.inputs();
        let mut varied: Vec<(usize, Varied)> = Vec::new();
        for (place, column) in columns.iter().enumerate() {
            let Some(found) = find(column, inputs)? else { continue };
            if let Some((earlier, _)) = varied.iter().find(|(_, other)| other.id() == found.id()) {
                let (one, two) = (columns[*earlier].clone(), column.clone());
                return Err(ColumnError::SameKey { one, two, key: found.id().to_string() });
            }
            varied.push((place, found));
        }
        let is_block = inputs.has(Table::Block);
        // A name of a file that rows replace need not be that of one.
        let named = |id: Id| varied.iter().any(|(_, other)| other.id() == id);
        let wanted = file.wanted().into_iter().any(|(id, _)| named(id));
        let case = if is_block { None } else { Some(file.case()) };
        let case = match case.transpose() {
            Err(error) if !wanted => return Err(error.into()),
            case => case.unwrap_or_default(),
        };
        let numbers = varied.iter().filter_map(|(_, how)| match how {
            Varied::Number(_, variable) => Some(variable),
            Varied::Word(_) => None,
        });
        let numbers: Vec<_> = numbers.collect();
        let notes = case.as_ref().map_or_else(Vec::new, |case| sweep::notes(&numbers, inputs, case));
        let asks =
            !file.motion_criteria()?.is_empty() || varied.iter().any(|(_, how)| how.id().key.is_of_motion());
        Ok(MotionRows { inputs: inputs.clone(), case, varied, asks, notes, records: Mutex::default() })
    }

    /// Notes on the numbers that go with those that vary, in sentences.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The results that the case has, in their order: of criteria and of copies only where it has some.
    pub fn results(&self) -> Vec<usize> {
        let copied = self.inputs.has(Table::Copies);
        let is_there = |place: &usize| {
            let name = &RESULTS[*place];
            (self.asks || !OF_CRITERIA.contains(name)) && (copied || !OF_COPIES.contains(name))
        };
        (0..RESULTS.len()).filter(is_there).collect()
    }

    /// The places of the columns that vary something, and the keys that they vary.
    pub fn varied(&self) -> impl Iterator<Item = (usize, String)> {
        self.varied.iter().map(|(place, how)| (*place, how.id().to_string()))
    }

    /// The inputs with the values of a row.
    fn with(&self, cells: &[&str], file: &ReadFile<'_>) -> Result<Inputs, RowFault> {
        let mut numbers = Vec::new();
        let mut words = Vec::new();
        for (place, how) in &self.varied {
            let cell = cells.get(*place).copied().unwrap_or_default().trim();
            let wrong = |problem: String| RowFault { columns: vec![*place], problem };
            match how {
                Varied::Number(factor, variable) => {
                    let value = factor.read(cell);
                    let value =
                        value.map_err(|error| wrong(format!("{error}; expected {}", factor.expected())))?;
                    let gravity = if factor.counts_gravity() { self.inputs.gravity() } else { 1.0 };
                    numbers.push((variable, value * gravity));
                }
                Varied::Word(id) if id.key.info().kind == Kind::File => {
                    words.push((*id, Value::Record(self.record(cell, file).map_err(wrong)?)));
                }
                Varied::Word(id) => {
                    let value = read(*id, id.key.info().kind, self.inputs.frame(), cell);
                    words.push((*id, value.map_err(|problem| wrong(problem.to_string()))?));
                }
            }
        }
        let mut inputs = self.varied_by(&numbers);
        words.into_iter().for_each(|(id, value)| inputs.put(id, value));
        Ok(inputs)
    }

    /// Refuses a column that varies nothing.
    pub(super) fn all_vary(&self, columns: &[String]) -> Result<(), ColumnError> {
        let idle =
            columns.iter().enumerate().find(|(place, _)| self.varied.iter().all(|(of, _)| of != place));
        let Some((_, column)) = idle else { return Ok(()) };
        let (name, unit) = heading(column);
        match Factor::find(name, unit, &self.inputs) {
            Err(error) => Err(ColumnError::NoFactor { column: column.clone(), error: Box::new(error) }),
            Ok(_) => Ok(()),
        }
    }

    /// The inputs with numbers in place of those that vary, each in the unit of its column.
    pub(super) fn with_numbers(&self, values: &[f64]) -> Result<Inputs, RowFault> {
        let mut numbers = Vec::new();
        for (place, how) in &self.varied {
            let wrong = |problem: String| RowFault { columns: vec![*place], problem };
            let Varied::Number(factor, variable) = how else {
                return Err(wrong(format!("{} is no number", how.id())));
            };
            let value = factor.value(values[*place]);
            let value = value.map_err(|error| wrong(format!("{error}; expected {}", factor.expected())))?;
            let gravity = if factor.counts_gravity() { self.inputs.gravity() } else { 1.0 };
            numbers.push((variable, value * gravity));
        }
        Ok(self.varied_by(&numbers))
    }

    /// The inputs with numbers changed, and with what goes with them.
    fn varied_by(&self, numbers: &[(&Variable, f64)]) -> Inputs {
        match &self.case {
            Some(case) => vary(&self.inputs, case, numbers),
            None => {
                let mut inputs = self.inputs.clone();
                numbers.iter().for_each(|(variable, value)| inputs.set(variable.id(), *value));
                inputs
            }
        }
    }

    /// A file that a row names, read once.
    fn record(&self, name: &str, file: &ReadFile<'_>) -> Result<Arc<RecordFile>, String> {
        let known = self.records.lock().unwrap_or_else(PoisonError::into_inner).get(name).cloned();
        known.unwrap_or_else(|| {
            let read = file(name).map(|text| Arc::new(RecordFile::of_text(name, text)));
            let read = read.map_err(|why| Problem::Unread { name: name.to_owned(), why }.to_string());
            let mut records = self.records.lock().unwrap_or_else(PoisonError::into_inner);
            records.insert(name.to_owned(), read.clone());
            read
        })
    }

    /// A fault of the inputs of a row, by the columns that vary what it is about; by all if none does.
    fn blame(&self, fault: &Fault) -> RowFault {
        let is_it = |id: Id| std::iter::once(fault.at).chain(fault.and).any(|place| place == id.into());
        let blamed: Vec<usize> =
            self.varied.iter().filter(|(_, how)| is_it(how.id())).map(|(place, _)| *place).collect();
        let all = || self.varied.iter().map(|(place, _)| *place).collect();
        RowFault { columns: if blamed.is_empty() { all() } else { blamed }, problem: fault.to_string() }
    }

    /// The results of a row, in the order of [`RESULTS`]: those of the worst situation.
    ///
    /// # Errors
    /// Fault of the row.
    pub fn answer(&self, cells: &[&str], file: &ReadFile<'_>) -> Result<Vec<String>, RowFault> {
        let inputs = self.with(cells, file)?;
        let cases = motions(&inputs).map_err(|fault| self.blame(&fault))?;
        let any =
            |problem: String| RowFault { columns: self.varied().map(|(place, _)| place).collect(), problem };
        let answers = FollowedMotion::of_all(cases, &Follow::default(), Portion::UNSEEN)
            .map_err(|error| any(error.to_string()))?;
        let Some(followed) = answers.first() else { return Err(any("no situation".to_owned())) };
        let outcome: &MotionOutcome = &followed.outcome;
        let copies = followed.copies.as_ref().map(|copies| copies.overturned);
        let share = |of: fn(Estimate) -> f64| copies.map_or_else(String::new, |share| of(share).to_string());
        let checks = followed.checks();
        let governing = checks.first();
        let names: Vec<&str> = followed.warnings.iter().map(|warning| warning.name).collect();
        Ok(vec![
            outcome.end.word().to_owned(),
            outcome.slide.to_string(),
            outcome.max_slide.to_string(),
            outcome.max_theta.to_string(),
            followed.of_balance().to_string(),
            // What becomes of a body that still moves when the time is up nobody knows.
            if outcome.end == End::Time { String::new() } else { outcome.overturned().to_string() },
            outcome.past_balance.to_string(),
            outcome.impacts.to_string(),
            outcome.t_rest.map_or_else(String::new, |t| t.to_string()),
            outcome.t_final.to_string(),
            outcome.unique.to_string(),
            share(|share| share.value),
            share(|share| share.low),
            share(|share| share.high),
            followed.met().map_or_else(String::new, |met| met.to_string()),
            governing.and_then(|check| check.utilisation).map_or_else(String::new, |used| used.to_string()),
            governing.map_or("", |check| check.criterion.name()).to_owned(),
            followed.case.situation.clone().unwrap_or_default(),
            names.join(" "),
        ])
    }
}

/// Entry that a column varies, if any.
fn find(column: &str, inputs: &Inputs) -> Result<Option<Varied>, ColumnError> {
    let (name, unit) = heading(column);
    let named = || inputs.values().map(|(id, _)| id).find(|id| id.to_string() == name);
    match Factor::find(name, unit, inputs) {
        Ok(factor) => match factor.variable().cloned() {
            Some(variable) => Ok(Some(Varied::Number(Box::new(factor), variable))),
            None => Err(ColumnError::Bias { column: column.to_owned() }),
        },
        Err(NoFactor::Unknown(unknown)) => match named() {
            Some(id) if word(id.key.info().kind) => Ok(Some(Varied::Word(id))),
            Some(_) => Err(ColumnError::NoValue { column: column.to_owned() }),
            None => no_key(name, column, inputs, unknown).map(|()| None),
        },
        Err(NoFactor::Absent { .. }) => Err(ColumnError::Absent { column: column.to_owned() }),
        Err(error) => Err(ColumnError::NoFactor { column: column.to_owned(), error: Box::new(error) }),
    }
}

/// True if entries of a kind are words.
fn word(kind: Kind) -> bool {
    matches!(kind, Kind::Text | Kind::File | Kind::Truth | Kind::Choice { .. } | Kind::Unit(_))
}

/// Refuses the name of a table of the case, or what begins like a key and is none of it.
fn no_key(name: &str, column: &str, inputs: &Inputs, unknown: Unknown) -> Result<(), ColumnError> {
    let paths = |table: Table| (0..inputs.count(table).max(1)).map(move |index| table.path(index));
    let tables = || Table::ALL.into_iter().filter(|table| table.parent().is_some());
    if tables().any(|table| inputs.has(table) && paths(table).any(|path| path == name)) {
        return Err(ColumnError::NoValue { column: column.to_owned() });
    }
    let first = name.split(['.', '[']).next().unwrap_or_default();
    let begins = name.contains('.')
        && tables().any(|table| table.parent() == Some(Table::Top) && table.name() == first);
    let listed = inputs.values().any(|(id, _)| id.key.name() != id.key.entry() && entry(id) == name);
    let is_word = Key::ALL.iter().any(|key| {
        word(key.info().kind) && without_places(&Id::from(*key).to_string()) == without_places(name)
    });
    match () {
        () if listed => Err(ColumnError::NoValue { column: column.to_owned() }),
        () if begins && is_word => Err(ColumnError::Absent { column: column.to_owned() }),
        () if begins => {
            let words = inputs.values().map(|(id, _)| id).filter(|id| word(id.key.info().kind));
            let words = words.map(|id| id.to_string());
            // A motion has no factors on loads.
            let numbers = unknown.names.into_iter().filter(|name| Bias::find(name).is_none());
            let names: Vec<String> = numbers.chain(words).collect();
            let suggestion = closest(name, names.iter().map(String::as_str)).map(str::to_owned);
            let unknown = Unknown { suggestion: suggestion.or(unknown.suggestion), names, ..unknown };
            Err(ColumnError::NoFactor {
                column: column.to_owned(),
                error: Box::new(NoFactor::Unknown(unknown)),
            })
        }
        () => Ok(()),
    }
}

/// The name of the list that a number stands in: `block.load[1].at`.
fn entry(id: Id) -> String {
    format!("{}.{}", id.table.path(id.index), id.key.entry())
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: &str = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.4\ngravity = 1\n[motion]\nimpact = { law = \"ratio\", ratio = 0.9 }\n\
        [motion.base]\nhorizontal = { shape = \"half-sine\", peak = 0.6, duration = 2 }\n";

    fn rows(text: &str, columns: &[String]) -> Result<MotionRows, ColumnError> {
        MotionRows::of(&CaseFile::parse("case.toml", text).unwrap(), columns)
    }

    fn no_file(file: &str) -> Result<String, String> {
        Err(format!("no file {file}"))
    }

    fn columns(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn a_row_says_what_a_file_would_say() {
        let names = ["site", "motion.base.horizontal.peak", "block.mu_s", "motion.impact.ratio"];
        let rows = rows(CASE, &columns(&names)).unwrap();
        assert_eq!(rows.varied().map(|(place, _)| place).collect::<Vec<_>>(), [1, 2, 3]);
        let inputs = rows.with(&["here", "0.45", "1", "8e-1"], &no_file).unwrap();
        let expected = CASE.replace("peak = 0.6", "peak = 0.45").replace("mu_s = 0.4", "mu_s = 1.0");
        let expected = expected.replace("ratio = 0.9", "ratio = 0.8");
        assert_eq!(inputs, *CaseFile::parse("case.toml", &expected).unwrap().inputs());
        let found = rows.answer(&["here", "0.45", "1", "0.8"], &no_file).unwrap();
        assert_eq!((found.len(), found[0].as_str(), found[5].as_str()), (RESULTS.len(), "rest", "false"));
        let words = rows.answer(&["", "much", "1", "0.8"], &no_file).unwrap_err();
        let expected = "it does not begin with a number; expected a number";
        assert_eq!(words, RowFault { columns: vec![1], problem: expected.to_owned() });
    }

    #[test]
    fn histories_make_a_motion_where_no_ground_takes_them() {
        let body = "[body]\nwidth = 1\nheight = 2\nmass = 1000\nfriction = 0.4\n";
        let load =
            "[[load]]\nforce = 6e3\nelevation = 1\nhistory = { shape = \"half-sine\", duration = 0.5 }\n";
        let still = "[[load]]\nforce = 6e3\nelevation = 1\n";
        let is_in_time = |tables: &[&str]| {
            CaseFile::parse("case.toml", &[&[body], tables].concat().concat()).unwrap().is_in_time()
        };
        assert!(is_in_time(&[load]) && is_in_time(&[still, load]) && !is_in_time(&[still]));
        assert!(!is_in_time(&[load, "[ground]\nstiffness = 5e7\n"]));
    }

    /// A wider body is a heavier one: the row is what a file with the width and the mass that goes with it would say.
    #[test]
    fn what_goes_with_a_number_goes_with_it_in_a_row() {
        let case = |width: &str, mass: &str, peak: &str| {
            format!(
                "[body]\nwidth = {width}\nheight = 2\nmass = {mass}\nfriction = 0.4\n[motion.base]\n\
                 horizontal = {{ shape = \"half-sine\", peak = \"{peak} m/s2\", duration = 0.7 }}\n\
                 [[load]]\nforce = \"6 kN/m\"\nelevation = \"1 m\"\nhistory = {{ shape = \"half-sine\", duration = \"0.5 s\" }}\n"
            )
        };
        let columns = columns(&["body.width", "motion.base.horizontal.peak [m/s2]"]);
        let table = rows(&case("1", "1000", "3"), &columns).unwrap();
        assert!(table.notes().iter().any(|note| note.contains("body.mass")), "{:?}", table.notes());
        for (cell, width, mass) in [("1.5 m", "1.5", "1500"), ("0.8", "0.8", "800"), ("1", "1", "1000")] {
            let found = table.answer(&[cell, "4"], &no_file).unwrap();
            let written = rows(&case(width, mass, "4"), &columns[1..]).unwrap();
            let expected = written.answer(&["4"], &no_file).unwrap();
            let slide = |answer: &[String]| answer[1].parse::<f64>().unwrap();
            assert!(slide(&expected).abs() > 1e-3, "{expected:?}");
            assert!((slide(&found) - slide(&expected)).abs() < 1e-12, "{found:?} {expected:?}");
        }
        let words = table.answer(&["2 kg", "4"], &no_file).unwrap_err();
        assert_eq!(words.columns, [0], "{words:?}");
        // The mass that is named in the same row is the mass.
        let columns = ["body.width".to_owned(), "body.mass".to_owned()];
        let table = rows(&case("1", "1000", "4"), &columns).unwrap();
        let found = table.answer(&["1.5", "1000"], &no_file).unwrap();
        let written = rows(&case("1.5", "1000", "4"), &columns[..0]).unwrap();
        assert_eq!(found[1], written.answer(&[], &no_file).unwrap()[1]);
    }

    #[test]
    fn columns_that_vary_nothing_they_name_are_refused() {
        let of = |name: &str, text: &str| rows(text, &columns(&[name])).unwrap_err();
        assert!(matches!(of("block.rho2", CASE), ColumnError::Absent { .. }));
        assert!(matches!(of("motion.base.horizontal", CASE), ColumnError::NoValue { .. }));
        assert_eq!(rows(CASE, &columns(&["a.b"])).unwrap().varied().count(), 0);
    }

    /// A short name and a unit in the heading mean in a table of motions what they mean in every other: with friction 0.3, 0.5 and 0.9
    /// a body under one pulse slides as in three files that say so.
    #[test]
    fn short_names_and_units_in_headings_vary_what_they_name() {
        let case = |friction: &str, force: &str, height: &str| {
            format!(
                "[body]\nwidth = 2\nheight = {height}\ndensity = 800\nfriction = {friction}\n[[load]]\nforce = {force}\n\
                 elevation = 1.2\nhistory = {{ shape = \"triangle\", rise = 0.5, duration = 1 }}\n"
            )
        };
        let columns = columns(&["friction", "load[1].force [kN/m]", "height [cm]"]);
        let table = rows(&case("0.3", "25e3", "3"), &columns).unwrap();
        let mut slides = Vec::new();
        for (friction, force, height) in [("0.3", "25", "300"), ("0.2", "25", "300"), ("0.2", "30", "280")] {
            let found = table.answer(&[friction, force, height], &no_file).unwrap();
            let force = format!("{force}e3");
            let height = format!("{}", height.parse::<f64>().unwrap() / 100.0);
            let written = rows(&case(friction, &force, &height), &[]).unwrap().answer(&[], &no_file).unwrap();
            assert_eq!(found, written, "{friction} {force} {height}");
            slides.push(found[1].clone());
        }
        slides.dedup();
        assert_eq!(slides.len(), 3, "{slides:?}");
    }
}
