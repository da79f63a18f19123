//! The numbers of a case file: all that were read, and some replaced by others, so that a design can be varied on the
//! whole way from the file to the answer.

use std::cell::RefCell;

use crate::units::Quantity;

/// Where a number stands in a case file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NumberId {
    /// The table with its brackets, e.g. `[body]`.
    pub table: &'static str,
    /// Its place among tables of that name.
    pub index: usize,
    /// The key.
    pub key: &'static str,
}

/// A number of a case file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// Where it stands.
    pub id: NumberId,
    /// Its value in SI units.
    pub value: f64,
    /// What it measures; `None` for a plain number.
    pub quantity: Option<Quantity>,
}

/// A value to be taken in place of the one in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Replacement {
    /// Where the number stands.
    pub id: NumberId,
    /// The value in SI units.
    pub value: f64,
}

impl NumberId {
    /// The number under `key` in the only table of its name.
    pub fn of(table: &'static str, key: &'static str) -> NumberId {
        NumberId { table, index: 0, key }
    }
}

/// The numbers read so far, and those that are replaced.
pub(super) struct Numbers<'a> {
    replaced: &'a [Replacement],
    noted: RefCell<Vec<Number>>,
}

impl<'a> Numbers<'a> {
    pub(super) fn new(replaced: &'a [Replacement]) -> Numbers<'a> {
        Numbers { replaced, noted: RefCell::default() }
    }

    /// Notes a number as it is in the file or, if it is replaced, as it is then; gives its value.
    pub(super) fn note(&self, number: Number) -> f64 {
        let replacement = self.replaced.iter().find(|replacement| replacement.id == number.id);
        let value = replacement.map_or(number.value, |replacement| replacement.value);
        self.noted.borrow_mut().push(Number { value, ..number });
        value
    }

    /// All numbers noted, in the order they were read.
    pub(super) fn into_noted(self) -> Vec<Number> {
        self.noted.into_inner()
    }
}
