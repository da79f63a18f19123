//! Case files: a body, its friction and its loads as an engineer writes them, and the answers as text, JSON and figures.
//!
//! ```text
//! text ── CaseFile::read ──► Inputs ── Case::of ──► Case ─┬─ Assessment::of ──► Assessment ──► text, JSON, figures
//!          standfast-inputs    ▲      standfast-model     ├─ FollowedMotion::of_file ──► FollowedMotion ──► …
//!                              │                          └─ Probability::of ──► Probability ──► …
//!                              │                                 standfast-answers          written here: Document
//!                              └── typed values under their keys, varied without text: design, tables, random numbers
//! ```
//!
//! | question | start at |
//! |---|---|
//! | What does a case look like? | [`beginnings`], [`examples`] |
//! | What may stand in a case file? | [`key`], [`units`] |
//! | What does a file say, and where? | [`CaseFile`], [`Inputs`] |
//! | What is the answer to a case? | [`Assessment`]; its results by name: [`results`]; its criteria: [`criteria`] |
//! | How is an answer written? | [`Document`] |
//! | What do two cases differ in, and their answers? | [`CaseText::differences`], [`compare`] |
//! | What to change for a case to be safe? | [`design`]; what goes with a change: [`couple`] |
//! | What is the answer for many values of some numbers? | [`sweep`] |
//! | Which direction of the loads is worst? | [`directions`] |
//! | What becomes of a block in time? | [`motion`] |
//! | How likely is each mode if some numbers are random? | [`random`] |
//! | What is printed for one point? | [`point`] |
//! | What is printed for a stack in pure numbers? | [`stack`] |
//! | What does an error say, where, and how is it drawn? | [`Explained`], [`report`] |
//!
//! Nothing here reads or writes a file: those that a case names are read by whoever calls ([`ReadFile`]). All mechanics is `standfast`'s; all drawing is
//! `standfast-figures`'.

#![forbid(unsafe_code)]

pub mod assess;
pub mod beginnings;
pub mod compare;
pub mod describe;
pub mod design;
pub mod directions;
mod document;
pub mod examples;
mod interface;
mod json;
pub mod layout;
pub mod motion;
pub mod point;
pub mod random;
mod report;
pub mod stack;
mod summary;

pub use assess::{Assessed, Assessment, AssessmentView, UpToError, check_up_to};
pub use document::{AnswerFigure, Document};
pub use interface::Interface;
pub use json::RequiredBound;
pub use report::{coloured, report};
pub use standfast_answers::{CaseCheck, Check, criteria, results, sweep};
pub use standfast_inputs::{
    CaseError, CaseText, CodeFile, Difference, Entry, Excerpt, Explained, Fault, GRAVITY, Id, Inputs, Key,
    OutputUnits, Place, Problem, ReadFile, RecordFile, Value, key, suggest, typed, units,
};
pub use standfast_model::{Acting, Bound, Case, CaseFile, Criterion, Warning, case, couple};
pub use standfast_watch::{Portion, Stopped, Watch};
pub use summary::{GoverningCriterion, Summary, capital};

use standfast_inputs::{explained, record};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
