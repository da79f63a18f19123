//! What the program says where a command does not end as asked.

use std::io;
use std::path::PathBuf;

use standfast::InputError;
use standfast_cases::design::DesignError;
use standfast_cases::directions::DirectionsError;
use standfast_cases::motion::{MotionError, SpectrumError};
use standfast_cases::random::ProbabilityError;
use standfast_cases::{CaseError, Explained, Stopped};
use standfast_sheet::{PrintError, SheetError};
use standfast_tables::TableError;
use thiserror::Error;

use crate::features::LeftOut;
use crate::files_read::WouldReplace;

/// Result of a command, or of a part of it.
pub type Result<T, E = CommandError> = std::result::Result<T, E>;

/// Reason why a command did not end as asked.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CommandError {
    /// A number that mechanics cannot take.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The case makes no sense.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// There is no design.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// There are no probabilities.
    #[error(transparent)]
    Probability(#[from] ProbabilityError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The case has no such spectrum.
    #[error(transparent)]
    Spectrum(#[from] SpectrumError),
    /// The case has no directions.
    #[error(transparent)]
    Directions(#[from] DirectionsError),
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The table is wrong.
    #[error(transparent)]
    Table(#[from] TableError),
    /// There is no sheet.
    #[error(transparent)]
    Sheet(#[from] SheetError),
    /// The sheet cannot be printed.
    #[error(transparent)]
    Print(#[from] PrintError),
    /// Something is asked for that this build leaves out.
    #[error(transparent)]
    LeftOut(#[from] LeftOut),
    /// An output would replace what was read.
    #[error(transparent)]
    WouldReplace(#[from] WouldReplace),
    /// A file cannot be read.
    #[error("cannot read {name}: {cause}")]
    Read {
        /// The file.
        name: String,
        /// Cause, in words.
        cause: String,
    },
    /// A case file is not text.
    #[error("{name} is not UTF-8 text: line {line} has a byte that is not a character")]
    Encoding {
        /// The case file.
        name: String,
        /// The first line with such a byte, counted from one.
        line: usize,
    },
    /// A file that is to be new is there already.
    #[error("{} is there already, and may have been worked in: it is not written over", path.display())]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// There are no criteria to check.
    #[error("--check finds no [criteria]{of} in {}", path.display())]
    NothingToCheck {
        /// The case file.
        path: PathBuf,
        /// Subject of the criteria, in words.
        of: &'static str,
        /// Criteria as an example.
        example: &'static str,
    },
    /// The series has a name that tells no format.
    #[error("cannot tell the format of {} from its extension", path.display())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// Two tables are to go into one file.
    #[error("--series and --csv both write to {}", path.display())]
    OneTable {
        /// The file.
        path: PathBuf,
    },
    /// Several figures are to go into one file.
    #[error("{} is one file, for one figure: give the number of one, or a folder for several", path.display())]
    OneFile {
        /// The file.
        path: PathBuf,
    },
    /// An option that only a least cost takes several times.
    #[error("{option} is given several times; expected once, without --minimise")]
    Several {
        /// The option.
        option: &'static str,
    },
    /// There is no boundary to be drawn.
    #[error("there is no boundary to draw: the target is met up to both ends of the range in every column")]
    NoBoundary,
    /// An option of copies where none are followed.
    #[error("--{option} is of copies, and none are followed")]
    NoCopies {
        /// The option.
        option: &'static str,
    },
    /// A spread of a number that is none.
    #[error("--spread: {problem}")]
    Spread {
        /// What is wrong.
        problem: String,
    },
    /// A point that is none.
    #[error("--at {written}: {problem}")]
    Point {
        /// What was written.
        written: String,
        /// What is wrong.
        problem: String,
    },
    /// A row from which no motion goes on.
    #[error("row {row} of {} begins no motion: {problem}", path.display())]
    From {
        /// The series.
        path: PathBuf,
        /// The row.
        row: usize,
        /// What is wrong.
        problem: String,
    },
    /// An option that tables of motions do not have.
    #[error("{option} does not go with a table of motions")]
    Option {
        /// The option.
        option: &'static str,
    },
    /// A picture cannot be converted.
    #[cfg(feature = "pictures")]
    #[error("cannot draw {}: {cause}", path.display())]
    Render {
        /// The picture's file.
        path: PathBuf,
        /// Error of the renderer.
        cause: standfast_figures::RenderError,
    },
    /// A file cannot be written.
    #[error("cannot write {}: {cause}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        cause: io::Error,
    },
    /// A figure of an answer cannot be written.
    #[error("{0}")]
    Figure(Box<CommandError>),
    /// The answer cannot be printed.
    #[error("cannot write to standard output: {0}")]
    Printed(io::Error),
}

impl Explained for CommandError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        Some(match self {
            CommandError::Case(error) => error,
            CommandError::Design(error) => error,
            CommandError::Directions(error) => error,
            CommandError::Probability(error) => error,
            CommandError::Table(error) => error,
            CommandError::Sheet(error) => error,
            CommandError::Print(error) => error,
            CommandError::LeftOut(error) => error,
            CommandError::WouldReplace(error) => error,
            _ => return None,
        })
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            CommandError::Encoding { .. } => "save it as UTF-8".into(),
            CommandError::NothingToCheck { example, .. } => format!("add for example\n[criteria]\n{example}"),
            CommandError::Extension { .. } => {
                "expected .csv or .txt, .parquet or .pq, .arrow, .ipc or .feather, .arrows, .xlsx".into()
            }
            CommandError::NoCopies { .. } => "--copies N follows some, or `number` of [motion.copies]".into(),
            CommandError::Point { .. } => {
                "a point is two lengths from the centre of mass, to the right and upwards: --at 0,0.9 or --at \"rack=0 m,90 cm\"".into()
            }
            CommandError::OneTable { .. } => "give the rows of the copies a file of their own".into(),
            CommandError::Several { .. } => {
                "--and takes a second quantity; --minimise volume several, for the least of it".into()
            }
            CommandError::NoBoundary => {
                "--from and --to widen the range; -o FILE.csv writes the values".into()
            }
            CommandError::Figure(_) => "-o DIR puts the figures into another directory".into(),
            _ => return None,
        })
    }
}
