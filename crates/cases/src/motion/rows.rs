//! Tables of motions: a case of which the columns of a table vary what stands in its file, a record's name among it.
//!
//! A column is called by the place of what it varies, as in `block.mu_s`, `motion.base.horizontal.file` or `load[2].force`. The value is put in its
//! place in the text, and the case is read as any other: what a row says is what a file would say. Only where a column varies a number
//! with which others go, as the mass goes with the width, are the numbers of the body, the water and the waves varied as `design` does.

use std::fmt::Write;
use std::ops::Range as Span;

use standfast_motion::Outcome;
use thiserror::Error;
use toml::de::{DeTable, DeValue};

use super::body::{BodyCaseError, body_cases_of, in_time, without_time};
use super::criteria::MOTION_CRITERIA;
use super::json::{end_word, of_balance};
use super::{BlockCase, Follow, GivenBase, ReadFile, cases_on, follow_all};
use crate::case::Case;
use crate::couple::{Variable, vary};
use crate::inputs::Inputs;
use crate::key::{Key, Moves, Table};
use crate::parse::CaseFile;
use crate::sweep;

/// The results of a row, in their order.
pub const RESULTS: [&str; 16] = [
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
    "met",
    "utilisation",
    "criterion",
    "situation",
    "warnings",
];

/// Those that say how far the criteria are met.
const OF_CRITERIA: [&str; 3] = ["met", "utilisation", "criterion"];

/// Keys whose values are texts, whatever they look like.
const TEXTS: [&str; 6] = ["file", "column", "shape", "law", "baseline", "title"];

/// Why a column varies nothing that it should.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ColumnError {
    /// The case file is not TOML.
    #[error("the case file is not valid TOML: {0}")]
    Toml(String),
    /// It has the name of a place that the file does not have.
    #[error(
        "column {column}: the case file has no such key; if it is meant to vary, put it in, with any value it may have"
    )]
    Absent {
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
    /// The case file is none.
    #[error("{0}")]
    Case(String),
}

/// Where the value of a column goes.
#[derive(Debug, Clone)]
enum Varied {
    /// Into the text of the file, at a place; and whether it is a text there.
    Text(Span<usize>, bool),
    /// A number of the case, with what goes with it.
    Number(Variable),
}

/// A case and what the columns of a table vary of it.
#[derive(Debug, Clone)]
pub struct MotionRows {
    name: String,
    text: String,
    /// The place of each column that varies something, and how.
    varied: Vec<(usize, Varied)>,
    /// What the file gives beside time, where a column varies a number of it.
    inputs: Option<Inputs>,
    /// What goes with what varies, in sentences.
    notes: Vec<String>,
}

impl MotionRows {
    /// The case file `text`, called `name`, and the columns of a table. Those whose names have no point and are no place of the file
    /// vary nothing.
    ///
    /// # Errors
    /// If a column cannot vary what it names.
    pub fn of(name: &str, text: &str, columns: &[String]) -> Result<MotionRows, ColumnError> {
        let document = DeTable::parse(text).map_err(|error| ColumnError::Toml(error.message().to_owned()))?;
        let (mut varied, mut moves) = (Vec::new(), false);
        for (place, column) in columns.iter().enumerate() {
            let wrong = |make: fn(String) -> ColumnError| Err(make(column.clone()));
            let (Some((path, key)), Some(table)) = (column.rsplit_once('.'), column.split(['.', '[']).next())
            else {
                continue;
            };
            let Some(value) = find(document.get_ref(), path, key) else {
                if document.get_ref().contains_key(table) || table == "motion" {
                    return wrong(|column| ColumnError::Absent { column });
                }
                continue;
            };
            if matches!(value.get_ref(), DeValue::Table(_) | DeValue::Array(_)) {
                return wrong(|column| ColumnError::NoValue { column });
            }
            let known = Table::ALL
                .into_iter()
                .find(|known| known.name() == table && path.split('[').next() == Some(table));
            let known = known.and_then(|known| Key::find(known, key));
            // Friction to slip goes with that to stick of itself where it is left out.
            let alone = |key: Key| match key.info().moves {
                Moves::Alone => true,
                Moves::Friction => find(document.get_ref(), path, "kinetic_friction").is_none(),
                _ => false,
            };
            moves |= known.is_some_and(|key| !alone(key));
            varied.push((place, Varied::Text(value.span(), TEXTS.contains(&key))));
        }
        let (name, text) = (name.to_owned(), text.to_owned());
        if !moves {
            return Ok(MotionRows { name, text, varied, inputs: None, notes: Vec::new() });
        }
        let none = |error: BodyCaseError| ColumnError::Case(error.to_string());
        let of_time = in_time(document.get_ref(), &text)
            .map_err(|wrong| none(BodyCaseError::Motion(wrong.in_file(&name, &text))))?;
        let file = CaseFile::parse(&name, &without_time(document.get_ref(), &text, &of_time));
        let file = file.map_err(|error| none(error.into()))?;
        let case = file.case().map_err(|error| none(error.into()))?;
        for (place, how) in &mut varied {
            if let Ok(variable) = Variable::find(&columns[*place], file.inputs()) {
                *how = Varied::Number(variable);
            }
        }
        let variables = varied.iter().filter_map(|(_, how)| match how {
            Varied::Number(variable) => Some(variable),
            Varied::Text(..) => None,
        });
        let notes = sweep::notes(&variables.collect::<Vec<_>>(), file.inputs(), &case);
        Ok(MotionRows { name, text, varied, inputs: Some(file.inputs().clone()), notes })
    }

    /// What goes with what varies, in sentences.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The results that the case has, in their order: of criteria only where it has some.
    pub fn results(&self) -> Vec<usize> {
        let document = DeTable::parse(&self.text).ok();
        let asked = document.as_ref().and_then(|document| document.get_ref().get("criteria"));
        let asked = asked.and_then(|value| value.get_ref().as_table());
        let asks = asked.is_some_and(|table| MOTION_CRITERIA.iter().any(|key| table.contains_key(*key)));
        let of_criteria = |place: &usize| OF_CRITERIA.contains(&RESULTS[*place]);
        (0..RESULTS.len()).filter(|place| asks || !of_criteria(place)).collect()
    }

    /// The places of the columns that vary something.
    pub fn varied(&self) -> impl Iterator<Item = usize> {
        self.varied.iter().map(|(place, ..)| *place)
    }

    /// The text of the case with the values of a row.
    fn with(&self, cells: &[&str]) -> String {
        let mut pieces: Vec<(&Span<usize>, String)> = Vec::new();
        for (place, how) in &self.varied {
            let Varied::Text(span, text) = how else { continue };
            let cell = cells.get(*place).copied().unwrap_or_default().trim();
            let plain =
                !text && (cell == "true" || cell == "false" || cell.parse::<f64>().is_ok_and(f64::is_finite));
            pieces.push((span, if plain { number(cell) } else { quoted(cell) }));
        }
        pieces.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
        let mut text = self.text.clone();
        for (span, value) in pieces {
            text.replace_range(span.clone(), &value);
        }
        text
    }

    /// The cases of a row, whose text is as given.
    fn cases(&self, cells: &[&str], text: &str, file: &ReadFile<'_>) -> Result<Vec<BlockCase>, String> {
        let given = GivenBase::default();
        let Some(inputs) = &self.inputs else {
            return cases_on(&self.name, text, file, &given).map_err(|error| error.to_string());
        };
        let mut changes = Vec::new();
        for (place, how) in &self.varied {
            let Varied::Number(variable) = how else { continue };
            let cell = cells.get(*place).copied().unwrap_or_default().trim();
            changes.push((variable, variable.read(cell, inputs).map_err(|problem| problem.to_string())?));
        }
        let case = |rest: &str| {
            let file = CaseFile::parse(&self.name, rest)?;
            let inputs = vary(file.inputs(), &file.case()?, &changes);
            Case::of(&inputs).map_err(|fault| file.error(fault))
        };
        body_cases_of(&self.name, text, file, &given, &case).map_err(|error| error.to_string())
    }

    /// The results of a row, in the order of [`RESULTS`]: those of the worst situation.
    ///
    /// # Errors
    /// What is wrong with the row, in words.
    pub fn answer(&self, cells: &[&str], file: &ReadFile<'_>) -> Result<Vec<String>, String> {
        let text = self.with(cells);
        let cases = self.cases(cells, &text, file)?;
        let answers = follow_all(cases, &Follow::default()).map_err(|error| error.to_string())?;
        let Some((case, followed)) = answers.first() else { return Err("no situation".to_owned()) };
        let outcome: &Outcome = &followed.outcome;
        let checks = case.checks(outcome);
        let governing = checks.first();
        let names: Vec<&str> = followed.warnings.iter().map(|warning| warning.name).collect();
        Ok(vec![
            end_word(outcome.end).to_owned(),
            outcome.slide.to_string(),
            outcome.max_slide.to_string(),
            outcome.max_theta.to_string(),
            of_balance(case, outcome).to_string(),
            outcome.overturned().to_string(),
            outcome.past_balance.to_string(),
            outcome.impacts.to_string(),
            outcome.t_rest.map_or_else(String::new, |t| t.to_string()),
            outcome.t_final.to_string(),
            outcome.unique.to_string(),
            case.met(outcome).map_or_else(String::new, |met| met.to_string()),
            governing.and_then(|check| check.utilisation).map_or_else(String::new, |used| used.to_string()),
            governing.map_or("", |check| check.criterion.name()).to_owned(),
            case.situation.clone().unwrap_or_default(),
            names.join(" "),
        ])
    }
}

/// A number as TOML has it: digits before and after the point.
fn number(cell: &str) -> String {
    match cell.parse::<f64>() {
        Ok(value) => format!("{value:?}"),
        Err(_) => cell.to_owned(),
    }
}

fn quoted(cell: &str) -> String {
    let mut text = String::from("\"");
    for c in cell.chars() {
        let _ = match c {
            '"' | '\\' => write!(text, "\\{c}"),
            c if c.is_control() => write!(text, "\\u{:04X}", u32::from(c)),
            c => write!(text, "{c}"),
        };
    }
    text + "\""
}

/// The value under a key of a table; `name[2]` is the second of a list.
fn find<'a>(document: &'a DeTable<'a>, path: &str, key: &str) -> Option<&'a toml::Spanned<DeValue<'a>>> {
    let mut table = document;
    for part in path.split('.') {
        let (name, place) = match part.strip_suffix(']').and_then(|part| part.split_once('[')) {
            Some((name, place)) => (name, Some(place.parse::<usize>().ok()?.checked_sub(1)?)),
            None => (part, None),
        };
        let value = table.get(name)?.get_ref();
        table = match place {
            Some(place) => value.as_array()?.get(place)?.get_ref().as_table()?,
            None => value.as_table()?,
        };
    }
    table.get(key)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: &str = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.4\ngravity = 1\n[motion]\nimpact = { law = \"ratio\", ratio = 0.9 }\n\
        [motion.base]\nhorizontal = { shape = \"half-sine\", peak = 0.6, duration = 2 }\n";

    fn columns(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn a_row_says_what_a_file_would_say() {
        let names = ["site", "motion.base.horizontal.peak", "block.mu_s", "motion.impact.ratio"];
        let rows = MotionRows::of("case.toml", CASE, &columns(&names)).unwrap();
        assert_eq!(rows.varied().collect::<Vec<_>>(), [1, 2, 3]);
        let text = rows.with(&["here", "0.45", "1", "8e-1"]);
        let expected = CASE.replace("peak = 0.6", "peak = 0.45").replace("mu_s = 0.4", "mu_s = 1.0");
        assert_eq!(text, expected.replace("ratio = 0.9", "ratio = 0.8"));
        let file = |file: &str| Err(format!("no file {file}"));
        let found = rows.answer(&["here", "0.45", "1", "0.8"], &file).unwrap();
        assert_eq!((found.len(), found[0].as_str(), found[5].as_str()), (RESULTS.len(), "rest", "false"));
        let words = rows.answer(&["", "much", "1", "0.8"], &file).unwrap_err();
        assert!(words.contains("`peak`"), "{words}");
    }

    #[test]
    fn histories_make_a_motion_where_no_ground_takes_them() {
        let body = "[body]\nwidth = 1\nheight = 2\nmass = 1000\nfriction = 0.4\n";
        let load =
            "[[load]]\nforce = 6e3\nelevation = 1\nhistory = { shape = \"half-sine\", duration = 0.5 }\n";
        let still = "[[load]]\nforce = 6e3\nelevation = 1\n";
        let is_in_time = |tables: &[&str]| super::super::is_in_time(&([&[body], tables].concat().concat()));
        assert!(is_in_time(&[load]) && is_in_time(&[still, load]) && !is_in_time(&[still]));
        assert!(!is_in_time(&[load, "[ground]\nstiffness = 5e7\n"]));
    }

    /// A wider body is a heavier one: the row is what a file with the width and the mass that goes with it would say.
    #[test]
    fn what_goes_with_a_number_goes_with_it_in_a_row() {
        let case = |width: &str, mass: &str, peak: &str| {
            format!(
                "[body]\nwidth = {width}\nheight = 2\nmass = {mass}\nfriction = 0.4\n[motion.base]\n\
                 horizontal = {{ shape = \"half-sine\", peak = {peak}, duration = 0.7 }}\n\
                 [[load]]\nforce = \"6 kN/m\"\nelevation = \"1 m\"\nhistory = {{ shape = \"half-sine\", duration = \"0.5 s\" }}\n"
            )
        };
        let file = |file: &str| Err(format!("no file {file}"));
        let columns = columns(&["body.width", "motion.base.horizontal.peak"]);
        let rows = MotionRows::of("case.toml", &case("1", "1000", "3"), &columns).unwrap();
        assert!(rows.notes().iter().any(|note| note.contains("body.mass")), "{:?}", rows.notes());
        for (cell, width, mass) in [("1.5 m", "1.5", "1500"), ("0.8", "0.8", "800"), ("1", "1", "1000")] {
            let found = rows.answer(&[cell, "4"], &file).unwrap();
            let written = MotionRows::of("case.toml", &case(width, mass, "4"), &columns[1..]).unwrap();
            let expected = written.answer(&["4"], &file).unwrap();
            let slide = |answer: &[String]| answer[1].parse::<f64>().unwrap();
            assert!(slide(&expected).abs() > 1e-3, "{expected:?}");
            assert!((slide(&found) - slide(&expected)).abs() < 1e-12, "{found:?} {expected:?}");
        }
        let words = rows.answer(&["2 kg", "4"], &file).unwrap_err();
        assert!(words.contains("2 kg"), "{words}");
        // The mass that is named in the same row is the mass.
        let columns = ["body.width".to_owned(), "body.mass".to_owned()];
        let rows = MotionRows::of("case.toml", &case("1", "1000", "4"), &columns).unwrap();
        let found = rows.answer(&["1.5", "1000"], &file).unwrap();
        let written = MotionRows::of("case.toml", &case("1.5", "1000", "4"), &columns[..0]).unwrap();
        assert_eq!(found[1], written.answer(&[], &file).unwrap()[1]);
    }

    #[test]
    fn columns_that_vary_nothing_they_name_are_refused() {
        let of = |name: &str, text: &str| MotionRows::of("case.toml", text, &columns(&[name])).unwrap_err();
        assert!(matches!(of("block.mu_k", CASE), ColumnError::Absent { .. }));
        assert!(matches!(of("motion.base.horizontal", CASE), ColumnError::NoValue { .. }));
        assert_eq!(MotionRows::of("case.toml", CASE, &columns(&["a.b"])).unwrap().varied().count(), 0);
    }
}
