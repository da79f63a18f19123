//! Typed access to TOML values that remembers where each stands in the text.

use standfast::Slip;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Problem, Span};
use crate::suggest::closest;
use crate::units::Quantity;

/// A problem and the place it is at.
pub(super) struct At {
    pub(super) problem: Problem,
    pub(super) span: Span,
}

/// A table of the file.
pub(super) struct Table<'a> {
    table: &'a DeTable<'a>,
    span: Span,
    name: &'static str,
    text: &'a str,
}

/// A value of a table.
pub(super) struct Field<'a> {
    value: &'a Spanned<DeValue<'a>>,
    key: &'static str,
    text: &'a str,
}

impl<'a> Table<'a> {
    pub(super) fn new(table: &'a DeTable<'a>, span: Span, name: &'static str, text: &'a str) -> Table<'a> {
        Table { table, span, name, text }
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
        self.table.get(key).map(|value| Field { value, key, text: self.text })
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
        self.text.get(self.value.span()).unwrap_or_default().to_owned()
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
        Ok(text.to_owned())
    }

    pub(super) fn table(&self, header: &'static str) -> Result<Table<'a>, At> {
        let table = self.value.get_ref().as_table().ok_or_else(|| self.wrong_type("a table"))?;
        Ok(Table::new(table, self.value.span(), header, self.text))
    }

    pub(super) fn tables(&self, header: &'static str) -> Result<Vec<Table<'a>>, At> {
        const EXPECTED: &str = "one table for each load, under [[load]] in double brackets";
        let list = self.value.get_ref().as_array().ok_or_else(|| self.wrong_type(EXPECTED))?;
        if list.is_empty() {
            return Err(self.problem(Problem::NoLoad));
        }
        list.iter().map(|value| Field { value, key: self.key, text: self.text }.table(header)).collect()
    }

    /// A plain TOML number; `None` for every other type, and for integers that are no decimals (hexadecimal etc.).
    fn plain_number(&self) -> Option<f64> {
        match self.value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => None,
        }
    }

    fn quantity(&self, quantity: Quantity) -> Result<f64, At> {
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

    fn checked(&self, value: f64, expected: &'static str, ok: bool) -> Result<f64, At> {
        if ok && value.is_finite() {
            // A written "-0.0" is zero.
            Ok(value + 0.0)
        } else {
            Err(self.problem(Problem::OutOfRange { key: self.key, written: self.as_written(), expected }))
        }
    }

    pub(super) fn positive(&self, quantity: Quantity) -> Result<f64, At> {
        let value = self.quantity(quantity)?;
        self.checked(value, "a finite number above zero", value > 0.0)
    }

    pub(super) fn not_negative(&self, quantity: Quantity) -> Result<f64, At> {
        let value = self.quantity(quantity)?;
        self.checked(value, "a finite number, zero or more", value >= 0.0)
    }

    pub(super) fn friction(&self) -> Result<f64, At> {
        let value = self.plain_number().ok_or_else(|| self.wrong_type("a number without unit or quotes"))?;
        self.checked(value, "a finite number, zero or more", value >= 0.0)
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
