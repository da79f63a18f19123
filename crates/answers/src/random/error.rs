//! Reasons why there are no probabilities.

use std::fmt;

use standfast_watch::Stopped;
use thiserror::Error;

use super::criterion::{OF_LIFE, OF_SLIDES};
use super::storm::SlidingError;
use crate::error::CaseError;
use crate::explained::Explained;
use crate::key::Key;
use standfast_model::Criterion;
use standfast_probability::method::Method;

/// Reason why there are no probabilities.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProbabilityError {
    /// The case is not one, or a law is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// Nothing is random.
    #[error("the case file has no [random] table, which says what is random and by which law")]
    NoRandom,
    /// Draws, or what there is along a number, of a storm without a body.
    #[error("the file is of a [storm] without a [body], of which this is not asked")]
    NoBody,
    /// More numbers than the method takes.
    #[error("{method} takes {most} random numbers at most, and the case has {numbers}")]
    TooMany {
        /// The method.
        method: Method,
        /// Number of random numbers that the method takes at most.
        most: usize,
        /// Number of random numbers there are.
        numbers: usize,
    },
    /// A life of no whole number of years, of which some would have to be drawn.
    #[error("a life of {years} years; expected a whole number, because its years are drawn one by one")]
    PartOfYear {
        /// The years.
        years: f64,
    },
    /// Missing or unknown name of a situation, where there are several.
    #[error("{}; the case has {}", SituationAsked(asked.as_deref()), known.join("; "))]
    Situation {
        /// Situation that was asked for.
        asked: Option<String>,
        /// Those there are.
        known: Vec<String>,
    },
    /// A number along which there are no probabilities.
    #[error("no probabilities along `{name}`: {what}")]
    Over {
        /// The number.
        name: String,
        /// Reason why there are none.
        what: String,
    },
    /// Storms that cannot be answered.
    #[error(transparent)]
    Sliding(#[from] SlidingError),
    /// A life that is asked for, and has no length.
    #[error("a life is asked for, and nothing says how many years it has")]
    NoLife,
    /// Slides that are asked for, of no storm.
    #[error("slides over a life are asked for, and the case has no [storm]")]
    NoStorm,
    /// A life in which nothing is drawn each year.
    #[error("a life of {years} years, and no random number is drawn yearly")]
    NothingYearly {
        /// The years.
        years: f64,
    },
    /// A row that is asked for, of one body.
    #[error("it is asked for any of the bodies in a row, and nothing says how many there are")]
    NoRow,
    /// Over a life, a number of each body that is correlated with one that is common to all each year.
    #[error(
        "`{own}` is each body's own for life, and correlated with `{common}`, which is common to all each year: it would be another for each body"
    )]
    RowClash {
        /// Number of each body.
        own: String,
        /// Number that is common to all, and yearly.
        common: String,
    },
}

impl ProbabilityError {
    /// True if it is the criterion under this key that asks for what is not found.
    pub(crate) fn is_about(&self, key: Key) -> bool {
        match self {
            ProbabilityError::NoStorm | ProbabilityError::Sliding(_) => OF_SLIDES.contains(&key),
            ProbabilityError::NoLife | ProbabilityError::NothingYearly { .. } => OF_LIFE.contains(&key),
            ProbabilityError::NoRow => key == Key::GreatestAny,
            _ => Criterion::is_of_chance(key),
        }
    }
}

impl Explained for ProbabilityError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            ProbabilityError::Case(error) => Some(error),
            ProbabilityError::Sliding(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            ProbabilityError::NoRandom => {
                "for example\n[random]\nfriction = { normal = { mean = 0.6, sd = 0.1 } }".into()
            }
            ProbabilityError::NoBody => "give the body, its loads and its [wave]".into(),
            ProbabilityError::TooMany { .. } => "without a method one is chosen that does".into(),
            ProbabilityError::PartOfYear { .. } => {
                "up to three random numbers of one body are integrated, over any number of years".into()
            }
            ProbabilityError::Situation { .. } => "name one of them".into(),
            ProbabilityError::NoLife => "for example\n[random]\nyears = 50".into(),
            ProbabilityError::NoRow => {
                "for example\n[random]\nbodies = 20\nfriction = { normal = { mean = 0.6, sd = 0.06 }, each = \"body\" }".into()
            }
            ProbabilityError::RowClash { .. } => {
                "leave out `years`, the correlation, or `each = \"body\"` of that number".into()
            }
            ProbabilityError::NoStorm => "for example\n[storm]\nwaves = 1000\ntau0 = \"shimosako-takahashi\"".into(),
            ProbabilityError::NothingYearly { .. } => {
                "give `every = \"year\"` to a number that is drawn anew each year, such as the sea's largest wave"
                    .into()
            }
            _ => return None,
        };
        Some(help)
    }
}

/// Beginning of the message on a situation that is not known, as it was asked for.
struct SituationAsked<'a>(Option<&'a str>);

impl fmt::Display for SituationAsked<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => f.write_str("several sets of loads act one by one"),
            Some(asked) => write!(f, "no situation is called \"{asked}\""),
        }
    }
}
