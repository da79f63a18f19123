//! A case answered: its modes, margins and safety factors as text and JSON, and its figures.

mod plain;
pub mod situation;

use standfast::InputError;
use standfast_figures::Figure;

use crate::case::Case;
use crate::layout::paragraph;
use plain::Plain;
pub use situation::Assessed;

/// The answer to a case.
pub struct Assessment<'a> {
    case: &'a Case,
    answers: Answers<'a>,
}

/// What a case asks.
enum Answers<'a> {
    /// Each force is the report's problem.
    Plain(Plain<'a>),
    /// All loads act together, once with each of the alternative forces.
    Situations(Vec<Assessed>),
}

/// A figure of a case.
#[derive(Debug, Clone)]
pub struct CaseFigure {
    /// What tells it from the others of the case, to be appended to a file's name; may be empty.
    pub suffix: String,
    /// What it is.
    pub words: String,
    /// The figure.
    pub figure: Figure,
}

impl<'a> Assessment<'a> {
    /// Answers a case. The path of a rising load is followed up to `up_to` times the load.
    ///
    /// # Errors
    /// If the loads add up to what the mechanics cannot take.
    pub fn of(case: &'a Case, up_to: f64) -> Result<Assessment<'a>, InputError> {
        let answers = if case.is_plain() {
            Answers::Plain(Plain::of(case))
        } else {
            let situations = case.situations().into_iter();
            Answers::Situations(
                situations.map(|loaded| Assessed::of(loaded, up_to)).collect::<Result<_, _>>()?,
            )
        };
        Ok(Assessment { case, answers })
    }

    /// The situations of a case whose loads act together, one for each alternative force; none of a plain case.
    pub fn situations(&self) -> &[Assessed] {
        match &self.answers {
            Answers::Plain(_) => &[],
            Answers::Situations(all) => all,
        }
    }

    /// The answer for reading, in lines of at most 88 characters.
    pub fn text(&self) -> String {
        match &self.answers {
            Answers::Plain(plain) => plain.text(),
            Answers::Situations(all) => situation::text(self.case, all),
        }
    }

    /// The answer as one JSON document, at full precision; `files` are those of the [figures](Assessment::figures), in
    /// their order, as far as they were written.
    pub fn json(&self, files: &[String]) -> String {
        match &self.answers {
            Answers::Plain(plain) => plain.json(files),
            Answers::Situations(all) => situation::json(self.case, all, files),
        }
    }

    /// The figures: one k–μ diagram for every elevation of a force; where loads act together, one in effective coordinates
    /// and the load path for each alternative.
    ///
    /// # Errors
    /// If the loads add up to what the mechanics cannot take.
    pub fn figures(&self) -> Result<Vec<CaseFigure>, InputError> {
        match &self.answers {
            Answers::Plain(plain) => plain.figures(),
            Answers::Situations(all) => situation::figures(self.case, all),
        }
    }
}

/// The name of a load, or its number, counted from one.
pub fn load_name(case: &Case, index: usize) -> String {
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
