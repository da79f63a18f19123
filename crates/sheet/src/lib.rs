//! The calculation sheet of a case: what an engineer files and a checker signs.
//!
//! ```
//! use standfast_sheet::{Date, Sheet, SheetOptions};
//!
//! let text = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n[[load]]\nforce = 1e6\nelevation = 8\n";
//! let date: Date = "2026-11-21".parse()?;
//! let sheet = Sheet::of("case.toml", text, &SheetOptions { date: Some(date), ..SheetOptions::default() })?;
//! assert!(sheet.html().contains("the body stays at rest (RE)"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | question | module |
//! |---|---|
//! | What stands on the sheet, in which order? | `document`; on the one of a page `short` |
//! | What stands behind it, and what is not covered? | `method`, `references`, `limits` |
//! | What is computed, step by step? | `calculation` |
//! | How do several combinations share their formulas? | `together` |
//! | What becomes of the body in time? | `in_time` |
//! | How does a formula become symbols and numbers? | `formula`, `mathml`, `steps`, `symbols` |
//! | What keeps a sheet from being made with a gap? | `fault` |
//! | Who prints it? | [`browser`] |
//!
//! Every number is the library's; formulas stand beside it to be checked by hand. The sheet is one HTML file without scripts
//! that loads nothing. The same case, options and version of the program give the same bytes.

#![forbid(unsafe_code)]

#[cfg(feature = "print")]
pub mod browser;
mod calculation;
mod date;
mod displayed;
mod document;
mod fault;
mod formula;
mod in_time;
mod inputs;
mod limits;
mod mathml;
mod measured;
mod method;
mod probability;
mod references;
mod sensitivity;
mod short;
mod steps;
mod symbols;
mod together;
mod verdict;

use sha2::{Digest, Sha256};
use standfast::InputError;
use standfast_cases::motion::{Factors, FirstInstant, Follow, StrengthAsked};
use standfast_cases::{Assessment, AssessmentView, CaseError, CaseFile, Explained, Key, Portion, Stopped};
use thiserror::Error;

#[cfg(feature = "print")]
pub use browser::{Paper, PaperError, PrintError};
pub use date::{Date, DateError};
pub use displayed::Displayed;
pub use fault::SheetFault;
pub use formula::FormulaError;

/// Options of a sheet, beside its case.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetOptions {
    /// Entries that go before the case file's in the title block, under keys of
    /// [`TITLE_BLOCK`](standfast_cases::key::TITLE_BLOCK).
    pub title_block: Vec<(Key, String)>,
    /// The day the sheet bears; without it the sheet says that it is undated.
    pub date: Option<Date>,
    /// Multiple of the full load to which a rising load is followed.
    pub up_to: f64,
    /// True for one page: the verdict, the section, the inputs that decide, each criterion, signatures.
    pub short: bool,
}

impl Default for SheetOptions {
    /// Undated and in full, loads followed up to twice their value.
    fn default() -> SheetOptions {
        SheetOptions { title_block: Vec::new(), date: None, up_to: 2.0, short: false }
    }
}

/// Reason why there is no sheet.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SheetError {
    /// The case file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The case cannot be computed.
    #[error(transparent)]
    Mechanics(#[from] InputError),
    /// A part of the sheet cannot be drawn.
    #[error("the sheet cannot be drawn whole: {0}")]
    Fault(#[from] SheetFault),
}

impl Explained for SheetError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            SheetError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            SheetError::Fault(_) => Some(
                "this is a fault of the program, not of the case; no sheet is made, because one with a \
                 gap could be signed"
                    .into(),
            ),
            _ => None,
        }
    }
}

/// A calculation sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    html: String,
    #[cfg(feature = "print")]
    date: Option<Date>,
    #[cfg(feature = "print")]
    short: bool,
}

impl Sheet {
    /// The sheet of the case whose file is `text`. `name` is what errors call the file; the sheet shows the last part of it.
    ///
    /// # Errors
    /// If the case makes no sense, or anything on the sheet cannot be drawn: there is no sheet with a gap.
    pub fn of(name: &str, text: &str, options: &SheetOptions) -> Result<Sheet, SheetError> {
        Sheet::of_file(&CaseFile::parse(name, text)?, options, Portion::UNSEEN)
    }

    /// The sheet of a case file, as a portion of work that somebody may watch; of one in time that of its first instant, with its motion.
    ///
    /// # Errors
    /// As [`of`](Sheet::of), and if the motion cannot be followed, or the work is stopped.
    pub fn of_file(
        case_file: &CaseFile,
        options: &SheetOptions,
        portion: Portion<'_>,
    ) -> Result<Sheet, SheetError> {
        let strength = StrengthAsked::IfShort(Factors::Rungs);
        let follow = Follow { series: true, divergence: true, strength, ..Follow::default() };
        let [of_answer, of_chances] =
            portion.parts([1.0, if case_file.random().is_some() { 9.0 } else { 0.0 }]);
        let assessment = Assessment::following(case_file, Some(&follow), of_answer)?;
        match case_file.first_instant()? {
            Some(first) => {
                Sheet::made(&assessment, &first.file, Some((case_file, &first)), options, of_chances)
            }
            None => Sheet::made(&assessment, case_file, None, options, of_chances),
        }
    }

    fn made(
        assessment: &Assessment,
        case_file: &CaseFile,
        in_time: Option<(&CaseFile, &FirstInstant)>,
        options: &SheetOptions,
        portion: Portion<'_>,
    ) -> Result<Sheet, SheetError> {
        let name = case_file.name();
        let source = document::Source {
            file: name.rsplit(['/', '\\']).next().unwrap_or(name),
            case_file,
            in_time,
            hash: hash(case_file.text()),
            files: in_time
                .map_or(case_file, |(file, _)| file)
                .files()
                .map(|(name, text)| (name.to_owned(), hash(text)))
                .collect(),
            date: options.date,
            title_block: &options.title_block,
        };
        let view = AssessmentView { up_to: options.up_to, ..AssessmentView::default() };
        let html = match options.short {
            true => short::render(assessment, &source, &view, portion)?,
            false => document::render(assessment, &source, &view, portion)?,
        };
        portion.reached(1.0);
        Ok(Sheet {
            html,
            #[cfg(feature = "print")]
            date: options.date,
            #[cfg(feature = "print")]
            short: options.short,
        })
    }

    /// The sheet as an HTML document.
    pub fn html(&self) -> &str {
        &self.html
    }

    /// The sheet as a PDF that a browser of the Chromium family prints, dated as the sheet is. The same sheet and browser give the
    /// same bytes.
    ///
    /// # Errors
    /// If there is no such browser, or it does not print.
    #[cfg(feature = "print")]
    pub fn pdf(&self, paper: Paper) -> Result<Vec<u8>, PrintError> {
        browser::print(&self.html, paper, self.short, self.date)
    }
}

/// SHA-256 of the file's bytes, in hexadecimal digits.
fn hash(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
