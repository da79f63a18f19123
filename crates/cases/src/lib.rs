//! Case files: a body, its friction and its loads as an engineer writes them, and the answers as text, JSON and figures.
//!
//! ```text
//! text ── CaseFile::read ──► Inputs ── Case::of ──► Case ─┬─ Assessment::of ──► Assessment ──► text, JSON, figures
//!                             ▲                          ├─ CaseFile::motions ──► MotionProblem ──► Followed ──► …
//!                             │                          └─ Probability::of ──► Probability ──► …
//!                             └── typed values under their keys, varied without text: design, tables, random numbers
//! ```
//!
//! | question | start at |
//! |---|---|
//! | What may stand in a case file? | [`key`], [`units`] |
//! | What does a file say, and where? | [`CaseFile`], [`Inputs`] |
//! | What is the answer to a case? | [`Assessment`]; its results by name: [`results`]; what is asked of them: [`criteria`] |
//! | What to change for a case to be safe? | [`design`]; what goes with a change: [`couple`] |
//! | What is the answer for many values of some numbers? | [`sweep`] |
//! | What becomes of a block in time? | [`motion`] |
//! | How likely is each mode if some numbers are random? | [`random`] |
//! | What is printed for one point? | [`point`] |
//! | What does an error say, where, and how is it drawn? | [`Explained`], [`report`] |
//!
//! ```
//! use standfast_cases::{Assessment, AssessmentView, CaseFile};
//!
//! let text = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n[[load]]\nforce = 1e6\nelevation = 8\n";
//! let case = CaseFile::parse("case.toml", text)?.case()?;
//! let assessment = Assessment::of(&case)?;
//! assert!(assessment.text(&AssessmentView::default()).contains("the body stays at rest (RE)"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing here reads or writes a file: those that a case names are read by whoever calls ([`ReadFile`]). All mechanics is `standfast`'s; all drawing is `standfast-figures`'.

#![forbid(unsafe_code)]

pub mod assess;
pub mod case;
mod case_file;
pub mod couple;
pub mod criteria;
pub mod describe;
pub mod design;
mod interface;
pub mod layout;
pub mod motion;
pub mod point;
pub mod random;
mod report;
pub mod results;
mod rounded;
pub mod sweep;
mod warning;

pub use assess::{
    Assessed, Assessment, AssessmentView, CaseCheck, CaseFigure, FigureKind, UpToError, check_up_to,
};
pub use case::{Acting, Case};
pub use case_file::CaseFile;
pub use criteria::{Check, Criterion};
pub use interface::Interface;
pub use report::{coloured, report};
pub use standfast_inputs::{
    CaseError, CaseText, Entry, Excerpt, Explained, Fault, GRAVITY, Id, Inputs, Key, Place, Problem,
    ReadFile, RecordFile, Value, key, suggest, units,
};
pub use warning::Warning;

use serde::Serialize;
use standfast_inputs::{error, explained, inputs, parse, record};

/// A JSON document, ended by a newline.
fn json(document: &impl Serialize) -> String {
    // Plain structs with string keys always serialise.
    serde_json::to_string_pretty(document).map_or_else(|error| error.to_string(), |json| json + "\n")
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
