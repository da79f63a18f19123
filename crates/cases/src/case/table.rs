//! Typed access to TOML values that remembers where each stands in the text.

use standfast::Slip;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Problem, Span};
use crate::case::number::{Number, NumberId, Numbers};
use crate::suggest::closest;
use crate::units::Quantity;

/// A problem and the place it is at.
pub(super) struct At {
    pub(super) problem: Problem,
    pub(super) span: Span,
}

/// What every table and value of a file refers to.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) text: &'a str,
    /// The numbers read so far, and those that are replaced.
    pub(super) numbers: &'a Numbers<'a>,
}

/// A table of the file.
pub(super) struct Table<'a> {
    table: &'a DeTable<'a>,
    span: Span,
    name: &'static str,
    /// Its place among tables of that name.
    index: usize,
    source: Source<'a>,
}

/// A value of a table.
pub(super) struct Field<'a> {
    value: &'a Spanned<DeValue<'a>>,
    key: &'static str,
    table: (&'static str, usize),
    source: Source<'a>,
}

const ABOVE_ZERO: &str = "a finite number above zero";
const NOT_NEGATIVE: &str = "a finite number, zero or more";

impl<'a> Table<'a> {
    pub(super) fn new(
        table: &'a DeTable<'a>,
        span: Span,
        name: &'static str,
        source: Source<'a>,
    ) -> Table<'a> {
        Table { table, span, name, index: 0, source }
    }

    /// Refuses every key that is not one of `allowed`; the first in the text is reported.
    pub(super) fn only(&self, allowed: &'static [&'static str]) -> Result<(), At> {
        let unknown = self.table.keys().filter(|key| !allowed.contains(&key.get_ref().as_ref()));
        match unknown.min_by_key(|key| key.span().start) {
            None => Ok(()),
            Some(key) => {
                let name = key.get_ref().to_string();
                let suggestion = closest(&name, allowed.iter().copied());
                let problem = Problem::UnknownKey { key: name, table: self.name, suggestion, allowed };
                Err(At { problem, span: key.span() })
            }
        }
    }

    pub(super) fn get(&self, key: &'static str) -> Option<Field<'a>> {
        let table = (self.name, self.index);
        self.table.get(key).map(|value| Field { value, key, table, source: self.source })
    }

    pub(super) fn has(&self, key: &'static str) -> bool {
        self.table.contains_key(key)
    }

    /// A problem of a value, or of the table if it does not have it.
    pub(super) fn problem_at(&self, key: &'static str, problem: Problem) -> At {
        match self.get(key) {
            Some(field) => field.problem(problem),
            None => self.problem(problem),
        }
    }

    pub(super) fn optional<T>(
        &self,
        key: &'static str,
        read: impl FnOnce(&Field<'a>) -> Result<T, At>,
    ) -> Result<Option<T>, At> {
        self.get(key).map(|field| read(&field)).transpose()
    }

    pub(super) fn required<T>(
        &self,
        key: &'static str,
        read: impl FnOnce(&Field<'a>) -> Result<T, At>,
    ) -> Result<T, At> {
        match self.get(key) {
            Some(field) => read(&field),
            None => Err(self.problem(Problem::MissingKey { key, table: self.name })),
        }
    }

    /// A problem of the table as a whole, shown at its header.
    pub(super) fn problem(&self, problem: Problem) -> At {
        At { problem, span: self.span.clone() }
    }
}

impl<'a> Field<'a> {
    pub(super) fn problem(&self, problem: Problem) -> At {
        At { problem, span: self.value.span() }
    }

    /// The value as it stands in the file.
    fn as_written(&self) -> String {
        self.source.text.get(self.value.span()).unwrap_or_default().to_owned()
    }

    fn wrong_type(&self, expected: &'static str) -> At {
        let found = match self.value.get_ref() {
            DeValue::String(_) => "a text",
            DeValue::Integer(integer) if integer.radix() != 10 => "a number that is not decimal",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date or time",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        self.problem(Problem::WrongType { key: self.key, found, expected })
    }

    pub(super) fn text(&self) -> Result<String, At> {
        let text = self.value.get_ref().as_str().ok_or_else(|| self.wrong_type("a text in quotes"))?;
        // A terminal would obey them.
        if text.chars().any(|c| c.is_control() && !c.is_whitespace()) {
            return Err(self.wrong_type("one without control characters"));
        }
        Ok(text.to_owned())
    }

    pub(super) fn table(&self, header: &'static str) -> Result<Table<'a>, At> {
        let table = self.value.get_ref().as_table().ok_or_else(|| self.wrong_type("a table"))?;
        Ok(Table::new(table, self.value.span(), header, self.source))
    }

    pub(super) fn tables(&self, header: &'static str) -> Result<Vec<Table<'a>>, At> {
        const EXPECTED: &str = "one table for each load, under [[load]] in double brackets";
        let list = self.value.get_ref().as_array().ok_or_else(|| self.wrong_type(EXPECTED))?;
        if list.is_empty() {
            return Err(self.problem(Problem::NoLoad));
        }
        let tables = list.iter().enumerate().map(|(index, value)| {
            let table = Field { value, ..*self }.table(header)?;
            Ok(Table { index, ..table })
        });
        tables.collect()
    }

    /// A plain TOML number; `None` for every other type, and for integers that are no decimals (hexadecimal etc.).
    fn plain_number(&self) -> Option<f64> {
        match self.value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        }
    }

    /// A number with a unit, or without one in SI units.
    fn written(&self, quantity: Quantity) -> Result<f64, At> {
        if let Some(value) = self.plain_number() {
            return Ok(value);
        }
        match self.value.get_ref().as_str() {
            Some(text) => quantity.parse(text).map_err(|error| {
                self.problem(Problem::Unit { key: self.key, written: self.as_written(), quantity, error })
            }),
            None => Err(self.wrong_type("a number, or a text with a number and its unit")),
        }
    }

    /// Notes the number under this key, or takes the one that replaces it.
    fn noted(&self, key: &'static str, value: f64, quantity: Option<Quantity>) -> f64 {
        let (table, index) = self.table;
        let id = NumberId { table, index, key };
        self.source.numbers.note(Number { id, value, quantity })
    }

    fn checked(&self, value: f64, expected: &'static str, ok: impl Fn(f64) -> bool) -> Result<f64, At> {
        if ok(value) && value.is_finite() {
            // A written "-0.0" is zero.
            Ok(value + 0.0)
        } else {
            Err(self.problem(Problem::OutOfRange { key: self.key, written: self.as_written(), expected }))
        }
    }

    fn quantity(
        &self,
        quantity: Quantity,
        expected: &'static str,
        ok: impl Fn(f64) -> bool,
    ) -> Result<f64, At> {
        let value = self.checked(self.written(quantity)?, expected, &ok)?;
        self.checked(self.noted(self.key, value, Some(quantity)), expected, ok)
    }

    fn plain(&self, expected: &'static str, ok: impl Fn(f64) -> bool) -> Result<f64, At> {
        let value = self.plain_number().ok_or_else(|| self.wrong_type("a number without unit or quotes"))?;
        let value = self.checked(value, expected, &ok)?;
        self.checked(self.noted(self.key, value, None), expected, ok)
    }

    pub(super) fn finite(&self, quantity: Quantity) -> Result<f64, At> {
        self.quantity(quantity, "a finite number", |_| true)
    }

    pub(super) fn positive(&self, quantity: Quantity) -> Result<f64, At> {
        self.quantity(quantity, ABOVE_ZERO, |value| value > 0.0)
    }

    pub(super) fn not_negative(&self, quantity: Quantity) -> Result<f64, At> {
        self.quantity(quantity, NOT_NEGATIVE, |value| value >= 0.0)
    }

    /// A number without unit, zero or more.
    pub(super) fn ratio(&self) -> Result<f64, At> {
        self.plain(NOT_NEGATIVE, |value| value >= 0.0)
    }

    /// An acceleration, where a number without unit counts `gravity` (m/s²).
    pub(super) fn acceleration(&self, gravity: f64) -> Result<f64, At> {
        let value = match self.plain_number() {
            Some(shares) => shares * gravity,
            None => self.written(Quantity::Acceleration)?,
        };
        let value = self.checked(value, "a finite number", |_| true)?;
        Ok(self.noted(self.key, value, Some(Quantity::Acceleration)))
    }

    /// Three numbers without unit in a list; they are noted under `keys`.
    pub(super) fn three(&self, keys: [&'static str; 3]) -> Result<[f64; 3], At> {
        const EXPECTED: &str = "a list of three numbers";
        let list = self.value.get_ref().as_array().ok_or_else(|| self.wrong_type(EXPECTED))?;
        if list.len() != keys.len() {
            let problem =
                Problem::OutOfRange { key: self.key, written: self.as_written(), expected: EXPECTED };
            return Err(self.problem(problem));
        }
        let mut numbers = [0.0; 3];
        for ((number, value), key) in numbers.iter_mut().zip(list.iter()).zip(keys) {
            let field = Field { value, ..*self };
            let plain = field.plain_number().ok_or_else(|| field.wrong_type("a list of numbers"))?;
            let written = field.checked(plain, NOT_NEGATIVE, |value| value >= 0.0)?;
            *number = field.noted(key, written, None);
        }
        Ok(numbers)
    }

    pub(super) fn truth(&self) -> Result<bool, At> {
        self.value.get_ref().as_bool().ok_or_else(|| self.wrong_type("true or false"))
    }

    /// 1 or 2.
    pub(super) fn sides(&self) -> Result<u8, At> {
        let value = self.plain_number().ok_or_else(|| self.wrong_type("1 or 2"))?;
        let value = self.checked(value, "1 or 2", |value| value == 1.0 || value == 2.0)?;
        Ok(if value == 1.0 { 1 } else { 2 })
    }

    pub(super) fn direction(&self) -> Result<Slip, At> {
        match self.text()?.as_str() {
            "left" => Ok(Slip::Left),
            "right" => Ok(Slip::Right),
            _ => {
                let problem = Problem::OutOfRange {
                    key: self.key,
                    written: self.as_written(),
                    expected: "\"left\" or \"right\"",
                };
                Err(self.problem(problem))
            }
        }
    }
}
