//! Case files: a body, its friction and its loads as an engineer writes them, and the answers as text, JSON and figures.
//!
//! | question | start at |
//! |---|---|
//! | What is in a case file, and how do units become SI? | [`case`], [`units`] |
//! | What is the answer to a case? | [`Assessment`] |
//! | What to change for a case to be safe? | [`design`] |
//! | What is printed for one point? | [`point`]; [`describe`] as text, [`answer`] as JSON |
//!
//! ```
//! use standfast_cases::{Assessment, Case};
//!
//! let text = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n[[load]]\nforce = 1e6\nelevation = 8\n";
//! let case = Case::parse("case.toml", text)?;
//! let assessment = Assessment::of(&case, 2.0)?;
//! assert!(assessment.text().contains("The body stays at rest (RE)."));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing here reads or writes a file. All mechanics is `standfast`'s; all drawing is `standfast-figures`'.

#![forbid(unsafe_code)]

pub mod answer;
pub mod assess;
pub mod case;
pub mod describe;
pub mod design;
pub mod layout;
pub mod point;
pub mod suggest;
pub mod units;

pub use assess::{Assessed, Assessment, CaseFigure, load_name};
pub use case::{Case, CaseError};

use miette::Diagnostic;
use serde::Serialize;

/// A JSON document, ended by a newline.
fn json(document: &impl Serialize) -> String {
    // Plain structs with string keys always serialise.
    serde_json::to_string_pretty(document).map_or_else(|error| error.to_string(), |json| json + "\n")
}

/// An error as a user sees it: the message, the place in the file, and what to do.
pub fn report(error: &(dyn Diagnostic + 'static)) -> String {
    let theme = miette::GraphicalTheme::unicode_nocolor();
    let handler = miette::GraphicalReportHandler::new_themed(theme).with_width(90).with_links(false);
    let mut text = String::new();
    match handler.render_report(&mut text, error) {
        Ok(()) => text,
        Err(_) => format!("{error}\n"),
    }
}
