//! Faults of the program's own formulas and words, which keep a sheet from being drawn whole. They are errors, because
//! a sheet with a gap could be signed.

use thiserror::Error;

use crate::formula::FormulaError;

/// A fault of the program's own formulas and words.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SheetFault {
    /// Text that should be a formula and is none.
    #[error("{place}: {source}")]
    Formula {
        /// Place where it should stand: a step, an inequality, a sentence.
        place: String,
        /// Fault of the formula.
        source: FormulaError,
    },
    /// A name has no number that could be put in.
    #[error(
        "{place}: the formula `{formula}` needs a number for `{name}`, which no input and no step above gives"
    )]
    NoNumber {
        /// The step or inequality.
        place: String,
        /// The formula.
        formula: String,
        /// The name.
        name: String,
    },
    /// Formulas stand between two backticks in a sentence, and one backtick is left over.
    #[error(
        "the sentence “{text}”: expected backticks in pairs around formulas, found one without its partner"
    )]
    Unpaired {
        /// The sentence.
        text: String,
    },
}
