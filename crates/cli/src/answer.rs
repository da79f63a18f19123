//! An answer that a command prints, with its figures.

use std::path::Path;

use standfast_cases::Document;

use crate::error::{CommandError, Result};
use crate::figures::{self, Figures};
use crate::files_read::FilesRead;
use crate::format::{Format, Shown};
use crate::write;

/// An answer to print, and why a figure of it could not be written, if it could not: the answer is not lost with it.
#[derive(Debug)]
pub struct PrintedAnswer {
    /// The answer to print.
    pub answer: String,
    /// Error that prevented a figure.
    pub undrawn: Option<CommandError>,
    /// True if all criteria are met; `None` where there are none.
    pub met: Option<bool>,
}

impl PrintedAnswer {
    /// An answer without figures and criteria.
    pub fn plain(answer: String) -> PrintedAnswer {
        PrintedAnswer { answer, undrawn: None, met: None }
    }

    /// The answer to a case file, its figures written over no file that was `read`.
    pub fn of<D: Document + ?Sized>(
        answer: &D,
        view: &D::View,
        shown: Shown,
        figures: Figures<'_>,
        (case, read): (&Path, &FilesRead),
    ) -> PrintedAnswer {
        let mut drawn = Vec::new();
        let undrawn = if figures.are_drawn() {
            let all = answer.figures(view).map_err(CommandError::from);
            let written = all.and_then(|all| figures.write(case, read, all, &mut drawn));
            written.err().map(|error| CommandError::Figure(Box::new(error)))
        } else {
            None
        };
        let said = figures::said(&drawn);
        let mut text = shown.text(answer, view, &figures::files(drawn));
        if shown != Shown::Whole(Format::Json) {
            let gap = if said.is_empty() && undrawn.is_none() || shown == Shown::Brief { "" } else { "\n" };
            text += gap;
            text += &said;
        }
        PrintedAnswer { answer: text, undrawn, met: None }
    }

    /// The answer with its figures and a table beside it, which is written to a file, if one is asked for; `what` it has is said with its file.
    ///
    /// # Errors
    /// If a figure or the table cannot be written.
    pub fn with_table<D: Document<View = ()>>(
        answer: &D,
        (what, table, csv): (&str, Option<&Path>, fn(&D) -> String),
        format: Format,
        figures: Figures<'_>,
        (case, read): (&Path, &FilesRead),
    ) -> Result<String> {
        let mut printed = PrintedAnswer::of(answer, &(), Shown::Whole(format), figures, (case, read));
        if let Some(error) = printed.undrawn {
            return Err(error);
        }
        if let Some(table) = table {
            write::write_file(table, csv(answer).as_bytes(), read)?;
            if format == Format::Text {
                printed.answer += &format!("{what} written to {}\n", table.display());
            }
        }
        Ok(printed.answer)
    }
}
