//! What keeps a sheet from being drawn whole: a fault of the program's own formulas and words. It is an error, because a sheet
//! with a gap could be signed.

use thiserror::Error;

use crate::formula::FormulaError;

/// A fault of the program's own formulas and words.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Fault {
    /// What should be a formula is none.
    #[error("{place}: {source}")]
    Formula {
        /// Where it should stand: a step, an inequality, a sentence.
        place: String,
        /// What is wrong with it.
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
