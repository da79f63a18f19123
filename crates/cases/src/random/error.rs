//! Why there are no probabilities.

use std::fmt;

use miette::Diagnostic;
use thiserror::Error;

use super::answer::Method;
use super::storm::SlidingError;
use crate::error::CaseError;

/// Why there is no answer.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ProbabilityError {
    /// The case is not one, or a law is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// Nothing is random.
    #[error("the case file has no [random] table, which says what is random and by which law")]
    #[diagnostic(help("for example\n[random]\nfriction = {{ normal = {{ mean = 0.6, sd = 0.1 }} }}"))]
    NoRandom,
    /// Draws, or what there is along a number, of a storm without a body.
    #[error("the file is of a [storm] without a [body], of which this is not asked")]
    #[diagnostic(help("give the body, its loads and its [wave]"))]
    NoBody,
    /// More numbers than the method takes.
    #[error("{method} takes {most} random numbers at most, and the case has {numbers}")]
    #[diagnostic(help("without a method one is chosen that does"))]
    TooMany {
        /// The method.
        method: Method,
        /// How many it takes.
        most: usize,
        /// How many there are.
        numbers: usize,
    },
    /// A life of no whole number of years, of which some would have to be drawn.
    #[error("a life of {years} years; expected a whole number, because its years are drawn one by one")]
    #[diagnostic(help("up to three random numbers are integrated, over any number of years"))]
    PartOfYear {
        /// The years.
        years: f64,
    },
    /// Which of several situations is meant is not said.
    #[error("{}; the case has {}", HowAsked(asked.as_deref()), known.join("; "))]
    #[diagnostic(help("name one of them"))]
    Situation {
        /// What was asked for.
        asked: Option<String>,
        /// Those there are.
        known: Vec<String>,
    },
    /// A number along which there are no probabilities.
    #[error("no probabilities along `{name}`: {what}")]
    Over {
        /// The number.
        name: String,
        /// What is wrong.
        what: String,
    },
    /// Storms that cannot be answered.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Sliding(#[from] SlidingError),
    /// A life in which nothing is drawn each year.
    #[error("a life of {years} years, and no random number is drawn yearly")]
    #[diagnostic(help(
        "say `every = \"year\"` of what is drawn anew each year, such as the sea's largest wave"
    ))]
    NothingYearly {
        /// The years.
        years: f64,
    },
}

/// How a situation was asked for.
struct HowAsked<'a>(Option<&'a str>);

impl fmt::Display for HowAsked<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => f.write_str("several sets of loads act one by one"),
            Some(asked) => write!(f, "no situation is called \"{asked}\""),
        }
    }
}
