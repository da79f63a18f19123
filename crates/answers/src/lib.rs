//! Answers to a case: what becomes of the body, what would change that, how it moves, and how likely each outcome is.
//!
//! ```text
//! CaseFile ─┬─ Assessment::of_file ──► the situations with their results, and the criteria
//!           ├─ FollowedMotion::of_file ──► the motion in time; Spectrum, MotionRows: of many
//!           ├─ Design::of, DesignBoundary::of ──► the value of a number that meets a target
//!           ├─ Probability::of ──► how likely each outcome is
//!           └─ Sweep::of ──► the answers for many values of some numbers
//! ```
//!
//! | question | start at |
//! |---|---|
//! | What is the answer to a case? | [`Assessment`]; its results by name: [`results`]; its criteria: [`criteria`] |
//! | What to change for a case to be safe? | [`design`] |
//! | What is the answer for many values of some numbers? | [`sweep`] |
//! | What becomes of a body in time? | [`motion`] |
//! | How likely is each mode if some numbers are random? | [`random`] |
//!
//! Answers are data: `standfast-cases` writes them as text, JSON and figures.

#![forbid(unsafe_code)]

pub mod assess;
pub mod criteria;
pub mod design;
pub mod directions;
pub mod motion;
pub mod random;
pub mod results;
mod rounded;
pub mod sweep;

pub use assess::{Assessed, Assessment, CaseCheck};
pub use criteria::Check;

use standfast_inputs::{digits, error, explained, inputs, key, parse, record, suggest, units};
use standfast_model::{case, couple};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
