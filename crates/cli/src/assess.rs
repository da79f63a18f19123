//! `standfast assess`: a body and its loads from a case file.

mod json;
pub(crate) mod situation;
mod text;

use std::fs;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use standfast::{Diagram, InputError};
use thiserror::Error;

use crate::args::Format;
use crate::case::{Case, CaseError};
use crate::draw;
use crate::layout::paragraph;
use crate::write::{self, WriteError};
use standfast_figures::DesignPoint;

/// Why a case was not assessed.
#[derive(Debug, Error, Diagnostic)]
pub enum AssessError {
    /// The case file cannot be read.
    #[error("cannot read {}: {cause}", path.display())]
    Read {
        /// The case file.
        path: PathBuf,
        /// What the system says.
        cause: std::io::Error,
    },
    /// The case file is not text.
    #[error("{} is not UTF-8 text: line {line} has a byte that is no character", path.display())]
    #[diagnostic(help("save it as UTF-8"))]
    Encoding {
        /// The case file.
        path: PathBuf,
        /// The first line with such a byte, counted from one.
        line: usize,
    },
    /// The diagram would replace the case file.
    #[error("the diagram would be written over the case file {}", path.display())]
    #[diagnostic(help("rename the case file to end in .toml, or choose another directory with -o DIR"))]
    Overwrite {
        /// The case file.
        path: PathBuf,
    },
    /// The case file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// The diagram cannot be drawn.
    #[error(transparent)]
    Mechanics(#[from] InputError),
    /// The diagram cannot be written.
    #[error("{0}")]
    #[diagnostic(help("-o DIR puts the diagrams into another directory"))]
    Write(#[from] WriteError),
}

/// The answer to a case, and why a diagram of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct Answered {
    /// The answer to print.
    pub answer: String,
    /// What prevented a diagram.
    pub undrawn: Option<AssessError>,
}

/// Assesses a case file, and writes its diagrams into `directory` or else beside it. The path of a rising load is
/// followed up to `up_to` times the load.
///
/// # Errors
/// If the case file cannot be read or makes no sense.
pub fn assess(
    path: &Path,
    directory: Option<&Path>,
    up_to: f64,
    format: Format,
) -> Result<Answered, AssessError> {
    let text = read(path)?;
    let case = Case::parse(&path.display().to_string(), &text)?;
    if !case.is_plain() {
        return situation::assess(&case, path, directory, up_to, format);
    }
    let (diagrams, undrawn) = match draw_diagrams(&case, path, directory) {
        Ok(diagrams) => (diagrams, None),
        Err(error) => (Vec::new(), Some(error)),
    };
    let answer = match format {
        Format::Text => text::render(&case, &diagrams),
        Format::Json => json::render(&case, &diagrams),
    };
    Ok(Answered { answer, undrawn })
}

/// The text of a case file.
pub(crate) fn read(path: &Path) -> Result<String, AssessError> {
    let bytes = fs::read(path).map_err(|cause| AssessError::Read { path: path.to_owned(), cause })?;
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        AssessError::Encoding { path: path.to_owned(), line }
    })
}

/// Where the diagrams of a case go.
struct Place<'a> {
    case: &'a Path,
    directory: &'a Path,
}

impl<'a> Place<'a> {
    /// In `directory`, which is made if it is not there, or beside the case file.
    fn new(case: &'a Path, directory: Option<&'a Path>) -> Result<Place<'a>, AssessError> {
        if let Some(directory) = directory {
            write::make_directory(directory)?;
        }
        let beside = || case.parent().unwrap_or(Path::new(""));
        Ok(Place { case, directory: directory.unwrap_or_else(beside) })
    }

    /// The file of a diagram, named after the case and ended by `suffix`.
    fn file(&self, suffix: &str) -> Result<PathBuf, AssessError> {
        let stem = self.case.file_stem().unwrap_or_default().to_string_lossy();
        let file = self.directory.join(format!("{stem}{suffix}.svg"));
        if file.canonicalize().is_ok_and(|file| self.case.canonicalize().is_ok_and(|case| case == file)) {
            return Err(AssessError::Overwrite { path: self.case.to_owned() });
        }
        Ok(file)
    }
}

/// A diagram of a case, for all loads of one elevation.
struct DrawnDiagram {
    path: PathBuf,
    k_prime: f64,
}

/// One diagram for every distinct k'.
fn draw_diagrams(
    case: &Case,
    path: &Path,
    directory: Option<&Path>,
) -> Result<Vec<DrawnDiagram>, AssessError> {
    let mut groups: Vec<(f64, Vec<DesignPoint>)> = Vec::new();
    for (i, load) in case.loads.iter().enumerate() {
        let point = &load.reduced.point;
        let design = DesignPoint {
            k: point.force(),
            mu: point.friction(),
            label: load_name(case, i),
            mirrored: load.reduced.mirrored,
        };
        match groups.iter_mut().find(|(k_prime, _)| *k_prime == point.elevation()) {
            Some((_, points)) => points.push(design),
            None => groups.push((point.elevation(), vec![design])),
        }
    }

    let place = Place::new(path, directory)?;
    let several = groups.len() > 1;
    let mut drawn = Vec::new();
    for (i, (k_prime, points)) in groups.into_iter().enumerate() {
        let file = place.file(&if several { format!("-{}", i + 1) } else { String::new() })?;
        let diagram = Diagram::new(case.body.slenderness(), k_prime)?;
        draw::draw_case(&diagram, &points, &file)?;
        drawn.push(DrawnDiagram { path: file, k_prime });
    }
    Ok(drawn)
}

/// The name of a load, or its number.
fn load_name(case: &Case, index: usize) -> String {
    case.loads[index].name.clone().unwrap_or_else(|| format!("load {}", index + 1))
}

/// Title and note.
pub(crate) fn heading(case: &Case) -> String {
    let mut text = String::new();
    if let Some(title) = &case.title {
        text += &paragraph(title, 0);
        text += "\n";
    }
    if let Some(note) = &case.note {
        text += &paragraph(note, 2);
        text += "\n";
    }
    text
}
