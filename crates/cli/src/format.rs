//! Formats of an answer.

use clap::ValueEnum;
use standfast_cases::Document;

/// Format of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For reading, with four significant digits; times of events with seven
    #[default]
    Text,
    /// One JSON document, at full precision
    Json,
}

/// Part of an answer that is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// All of it.
    Whole(Format),
    /// Its top, for reading.
    Brief,
}

impl Shown {
    /// The top where `brief` asks for it, else all in a format.
    pub fn of(brief: bool, format: Format) -> Shown {
        if brief { Shown::Brief } else { Shown::Whole(format) }
    }

    /// This part of an answer; `figures` are the files of its figures.
    pub fn text<D: Document + ?Sized>(self, answer: &D, view: &D::View, figures: &[String]) -> String {
        match self {
            Shown::Whole(Format::Text) => answer.text(view),
            Shown::Whole(Format::Json) => answer.json(view, figures),
            Shown::Brief => answer.summary().map_or_else(|| answer.text(view), |summary| summary.alone()),
        }
    }
}
