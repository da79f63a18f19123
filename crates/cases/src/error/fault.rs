//! Where something is wrong with a case, and the error that shows it in the file's own text.

use std::ops::Range as Span;

use miette::{Diagnostic, LabeledSpan, SourceCode};
use thiserror::Error;

use super::Problem;
use crate::excerpt::Excerpt;
use crate::key::{Id, Key, Table};

/// Where in a case something is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The value under a key.
    Key(Id),
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
    /// What is wrong.
    pub problem: Problem,
    /// Where.
    pub at: Place,
    /// The other place, where two do not agree.
    pub and: Option<Place>,
}

impl Fault {
    pub(crate) fn new(problem: Problem, at: impl Into<Place>) -> Fault {
        Fault { problem, at: at.into(), and: None }
    }

    pub(crate) fn and(self, place: impl Into<Place>) -> Fault {
        Fault { and: Some(place.into()), ..self }
    }
}

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{problem}")]
pub struct CaseError {
    problem: Problem,
    source_code: Box<Excerpt>,
    spans: Vec<Span<usize>>,
}

impl CaseError {
    pub(crate) fn new(name: &str, text: &str, problem: Problem, spans: Vec<Span<usize>>) -> CaseError {
        let spans = spans.into_iter().map(|span| first_line(text, span)).collect();
        let (source_code, spans) = Excerpt::new(name, text, spans);
        CaseError { problem, source_code: Box::new(source_code), spans }
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// The part of a span on its first line, so that a table is shown by its header and not as a whole.
fn first_line(text: &str, span: Span<usize>) -> Span<usize> {
    let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
    span.start..span.start + line.len()
}

impl Diagnostic for CaseError {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        let empty = matches!(self.problem, Problem::Empty { .. });
        (!empty).then_some(&*self.source_code as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.spans.iter().cloned().map(LabeledSpan::underline)))
    }

    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        Some(Box::new(self.problem.help()?))
    }
}
