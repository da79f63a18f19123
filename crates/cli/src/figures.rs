//! Figures that are written beside a case file, or into a directory of their own.

use std::path::Path;

use standfast_cases::AnswerFigure;

use crate::case_file;
use crate::error::Result;
use crate::files_read::FilesRead;
use crate::write;

/// Place of the figures of a case.
#[derive(Debug, Clone, Copy)]
pub enum Figures<'a> {
    /// Beside the case file; those of a case from standard input, `-`, into the current directory.
    Beside,
    /// Into this directory, which is made if it is not there.
    Into(&'a Path),
    /// Nowhere: none are drawn.
    None,
}

impl<'a> Figures<'a> {
    /// Place that the options `--output` and `--no-figures` ask for.
    pub fn asked(output: Option<&'a Path>, none: bool) -> Figures<'a> {
        match output {
            _ if none => Figures::None,
            Some(directory) => Figures::Into(directory),
            None => Figures::Beside,
        }
    }

    /// True if any are drawn.
    pub fn are_drawn(self) -> bool {
        !matches!(self, Figures::None)
    }

    /// Writes figures, over no file that was `read`, each with its words and what its file's name has behind that of the case; `drawn` gets those that were written.
    ///
    /// # Errors
    /// If one cannot be written; those before it are.
    pub fn write(
        self,
        case: &Path,
        read: &FilesRead,
        figures: Vec<AnswerFigure>,
        drawn: &mut Vec<FigureFile>,
    ) -> Result<()> {
        let directory = match self {
            Figures::Beside => case.parent().unwrap_or(Path::new("")),
            Figures::Into(directory) => {
                write::make_directory(directory)?;
                directory
            }
            Figures::None => return Ok(()),
        };
        let stem = case_file::stem(case);
        for AnswerFigure { suffix, words, figure } in figures {
            let file = directory.join(format!("{stem}{suffix}.svg"));
            write::write_file(&file, figure.svg().as_bytes(), read)?;
            drawn.push(FigureFile { words, file: file.display().to_string() });
        }
        Ok(())
    }
}

/// A figure in its file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FigureFile {
    /// Words for the figure.
    pub words: String,
    /// The file.
    pub file: String,
}

/// A line for each file that was written.
pub fn said(drawn: &[FigureFile]) -> String {
    drawn.iter().map(|FigureFile { words, file }| format!("{words} written to {file}\n")).collect()
}

/// The files that were written.
pub fn files(drawn: Vec<FigureFile>) -> Vec<String> {
    drawn.into_iter().map(|drawn| drawn.file).collect()
}
