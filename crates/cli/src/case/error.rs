//! What can be wrong with a case file, shown in the file's own text.

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use standfast::InputError;
use thiserror::Error;

use super::Span;
use crate::units::{Quantity, UnitError};

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Problem {
    /// There is nothing in the file.
    #[error("{name} is empty")]
    Empty {
        /// The file.
        name: String,
    },
    /// The text is not TOML.
    #[error("this is not valid TOML: {0}")]
    Syntax(String),
    /// A key that no case file has.
    #[error("{table} has no key `{key}`")]
    UnknownKey {
        /// The key.
        key: String,
        /// The table it is in.
        table: &'static str,
        /// The allowed key it resembles.
        suggestion: Option<&'static str>,
        /// The keys the table may have.
        allowed: &'static [&'static str],
    },
    /// A key that has to be there.
    #[error("{table} lacks `{key}`")]
    MissingKey {
        /// The key.
        key: &'static str,
        /// The table it should be in.
        table: &'static str,
    },
    /// A value of another type.
    #[error("`{key}` is {found}; expected {expected}")]
    WrongType {
        /// The key.
        key: &'static str,
        /// The type found.
        found: &'static str,
        /// The type expected.
        expected: &'static str,
    },
    /// A text that is no quantity of the kind needed.
    #[error("`{key}` is {written}, and {error}; expected {}", quantity.words())]
    Unit {
        /// The key.
        key: &'static str,
        /// The value as it stands in the file.
        written: String,
        /// What the value should measure.
        quantity: Quantity,
        /// What is wrong with it.
        error: UnitError,
    },
    /// A value that the quantity cannot have.
    #[error("`{key}` is {written}; expected {expected}")]
    OutOfRange {
        /// The key.
        key: &'static str,
        /// The value as it stands in the file.
        written: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// The force does not hit the body.
    #[error("`elevation` is above the crest of the body, which is {height} m high")]
    AboveCrest {
        /// Height of the body, m.
        height: f64,
    },
    /// Both are given.
    #[error("[body] has both `mass` and `density`")]
    MassAndDensity,
    /// None is given.
    #[error("[body] has neither `mass` nor `density`")]
    NoMass,
    /// `load = []`.
    #[error("the case file has no load")]
    NoLoad,
    /// Numbers beyond what can be computed, by themselves or together.
    #[error("these numbers are too large or too small to be computed with: {} is {:e}; expected {}", .0.quantity, .0.value, .0.expected)]
    Mechanics(InputError),
}

impl Problem {
    fn help(&self) -> Option<String> {
        const SKELETON: &str = "a case file has a body and one or more loads, for example:\n\n\
            [body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6\n\n\
            [[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"";
        let help = match self {
            Problem::Empty { .. } | Problem::NoLoad => SKELETON.to_owned(),
            Problem::UnknownKey { suggestion, allowed, .. } => {
                let known = format!("the keys understood here: {}", allowed.join(", "));
                match suggestion {
                    Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
                    None => known,
                }
            }
            Problem::MissingKey { key, .. } => {
                return example(key).map(|line| format!("add for example\n{line}"));
            }
            Problem::Unit { quantity, error, .. } => {
                let units = format!("the units understood here: {}", quantity.understood());
                match error {
                    UnitError::Missing => format!("{units}; a number without quotes is in {}", quantity.si()),
                    _ => units,
                }
            }
            Problem::WrongType { key, .. } | Problem::OutOfRange { key, .. } => {
                return example(key).map(|line| format!("for example\n{line}"));
            }
            Problem::AboveCrest { .. } => {
                "the elevation is measured from the base, in m if it has no unit".into()
            }
            Problem::MassAndDensity => "keep one of them; the other follows from width and height".into(),
            Problem::NoMass => "add one of them, for example density = \"2.1 t/m3\"".into(),
            Problem::Syntax(message) if message.contains("missing value") || message.contains("quot") => {
                "texts and numbers with a unit stand in quotes, e.g. width = \"15 m\"".into()
            }
            Problem::Syntax(_) | Problem::Mechanics(_) => return None,
        };
        Some(help)
    }
}

/// A line of a case file that has `key` right.
fn example(key: &str) -> Option<&'static str> {
    Some(match key {
        "title" => "title = \"Caisson in air\"",
        "note" => "note = \"numbers from the preliminary design\"",
        "gravity" => "gravity = \"9.81 m/s2\"",
        "body" => "[body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6",
        "width" => "width = \"15 m\"",
        "height" => "height = \"12 m\"",
        "mass" => "mass = \"370 t/m\"",
        "density" => "density = \"2.1 t/m3\"",
        "friction" => "friction = 0.6",
        "load" => "[[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"",
        "name" => "name = \"breaking wave\"",
        "force" => "force = \"450 kN/m\"",
        "elevation" => "elevation = \"8 m\"",
        "direction" => "direction = \"left\"",
        _ => return None,
    })
}

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{problem}")]
pub struct CaseError {
    problem: Problem,
    source_code: Box<NamedSource<String>>,
    span: Span,
}

impl CaseError {
    pub(super) fn new(name: &str, text: &str, problem: Problem, span: Span) -> CaseError {
        let span = first_line(text, span);
        let source_code = Box::new(NamedSource::new(name, text.to_owned()));
        CaseError { problem, source_code, span }
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// The part of a span on its first line, so that a table is shown by its header and not as a whole.
fn first_line(text: &str, span: Span) -> Span {
    let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
    span.start..span.start + line.len()
}

impl Diagnostic for CaseError {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        let empty = matches!(self.problem, Problem::Empty { .. });
        (!empty).then_some(&*self.source_code as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = LabeledSpan::underline(self.span.clone());
        Some(Box::new(std::iter::once(label)))
    }

    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        Some(Box::new(self.problem.help()?))
    }
}
