//! What a case file describes: a body with its loads, or its motion in time, and what is asked of it.
//!
//! ```text
//! Inputs ── Case::of ──► Case ─┬─ Case::situation ──► standfast::Situation
//!    ▲                         └─ CaseFile::motions ──► BlockCase with its MotionProblem
//!    └── Variable: a number that is varied, with what goes with it
//! ```
//!
//! | question | start at |
//! |---|---|
//! | Do the values of a file go together, and what do they describe? | [`CaseFile`], [`Case`] |
//! | Which loads act together? | [`Acting`], [`Case::situation`] |
//! | What moves in time, and how? | [`BlockCase`], [`FirstInstant`] |
//! | What is asked of the results? | [`Criterion`], [`MotionCriterion`] |
//! | What is possible, but may be a slip? | [`Warning`] |
//! | What goes with a number that is varied? | [`couple`] |
//!
//! Nothing here reads text, and nothing is answered here.

#![forbid(unsafe_code)]

pub mod case;
mod case_file;
pub mod couple;
mod criteria;
mod first_instant;
mod load_words;
mod motion;
mod slips;
mod warning;

pub use case::{Acting, Case};
pub use case_file::CaseFile;
pub use criteria::{Bound, Criterion, MotionCriterion, listed_modes};
pub use first_instant::{FirstInstant, GivenBase, at_first_instant};
pub use load_words::load_words;
pub use motion::{
    BlockCase, BodyPoint, CopiesAsked, CopiesOptions, LoadPeak, MotionWarning, Spread, motions,
};
pub use standfast_inputs::{CaseError, Fault, Inputs, Key, Place, Problem, Value};
pub use warning::Warning;

use standfast_inputs::{digits, error, inputs, key, parse, record, suggest, units};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
