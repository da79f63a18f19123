//! Places of faults in a case, and the error that shows them in the file's own text.

use std::ops::Range as Span;

use thiserror::Error;

use super::Problem;
use crate::explained::{Excerpt, Explained};
use crate::key::{Id, Key, Table};

/// Place of a fault in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The value under a key.
    Key(Id),
    /// A value of a list, or of a table in braces, under a key, by its place in it.
    Element(Id, usize),
    /// A table of its kind, by its place among them.
    Table(Table, usize),
}

impl From<Key> for Place {
    fn from(key: Key) -> Place {
        Place::Key(key.into())
    }
}

impl From<Id> for Place {
    fn from(id: Id) -> Place {
        Place::Key(id)
    }
}

impl From<Table> for Place {
    fn from(table: Table) -> Place {
        Place::Table(table, 0)
    }
}

/// A problem of typed inputs, and where it is.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct Fault {
    /// The problem.
    pub problem: Problem,
    /// Its place.
    pub at: Place,
    /// The other place, where two do not agree.
    pub and: Option<Place>,
}

impl Fault {
    /// A problem at a place.
    pub fn new(problem: Problem, at: impl Into<Place>) -> Fault {
        Fault { problem, at: at.into(), and: None }
    }

    /// The fault with another place, where two do not agree.
    pub fn and(self, place: impl Into<Place>) -> Fault {
        Fault { and: Some(place.into()), ..self }
    }
}

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{problem}")]
pub struct CaseError {
    problem: Problem,
    file: Box<File>,
}

/// The file of a case, with the places that an error is about.
#[derive(Debug)]
struct File {
    name: String,
    text: String,
    places: Vec<Span<usize>>,
}

impl CaseError {
    /// A problem at places of a text, of which each is cut to its first line; `name` is what the text is called.
    pub fn new(name: &str, text: &str, problem: Problem, spans: Vec<Span<usize>>) -> CaseError {
        let places = spans.into_iter().map(|span| first_line(text, span)).collect();
        let file = File { name: name.to_owned(), text: text.to_owned(), places };
        CaseError { problem, file: Box::new(file) }
    }

    /// The problem.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// The part of a span on its first line, so that a table is shown by its header and not as a whole.
fn first_line(text: &str, span: Span<usize>) -> Span<usize> {
    let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
    span.start..span.start + line.len()
}

impl Explained for CaseError {
    fn help(&self) -> Option<String> {
        self.problem.help()
    }

    fn excerpt(&self) -> Option<Excerpt<'_>> {
        let File { name, text, places } = &*self.file;
        let empty = matches!(self.problem, Problem::Empty { .. }) || places.is_empty();
        (!empty).then(|| Excerpt { name, text, places: places.clone() })
    }
}
