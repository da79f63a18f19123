//! Case files as typed values: what may stand under which key, in which unit and range, and what is wrong with what does.
//!
//! ```text
//! text ── CaseText::parse ──► Inputs: values under keys, each with the place where it stands
//!                    └──────► CaseError: what is wrong, where, and what helps
//! ```
//!
//! Text is parsed here, once, and nowhere else; everything that comes after varies [`Inputs`]. Nothing here knows what a case is worth: whether
//! values go together is said where a body and its loads are made of them.
//!
//! ```
//! use standfast_inputs::{CaseText, Key};
//!
//! let file = CaseText::parse("case.toml", "[body]\nwidth = \"1500 cm\"\n")?;
//! assert_eq!(file.inputs().number(Key::Width), Some(15.0));
//! let error = CaseText::parse("case.toml", "[body]\nwidth = \"15 kg\"\n").unwrap_err();
//! assert_eq!(error.to_string(), "`width` is \"15 kg\", and the unit `kg` does not fit; expected a length");
//! # Ok::<(), standfast_inputs::CaseError>(())
//! ```

#![forbid(unsafe_code)]

mod code_file;
pub mod datum;
mod differences;
pub mod digits;
mod edit;
pub mod error;
pub mod explained;
pub mod inputs;
pub mod key;
mod list;
pub mod output;
pub mod parse;
pub mod random;
pub mod record;
pub mod suggest;
pub mod typed;
pub mod units;

pub use code_file::CodeFile;
pub use differences::Difference;
pub use edit::WrittenNumber;
pub use error::{CaseError, Cure, Fault, Place, Problem};
pub use explained::{Excerpt, Explained};
pub use inputs::{GRAVITY, Inputs, Value};
pub use key::{Id, Key};
pub use output::OutputUnits;
pub use parse::{CaseText, Entry};
pub use record::{ReadFile, RecordFile};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
