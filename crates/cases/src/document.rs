//! Answers as documents: for reading, as JSON, and as figures.

use standfast::InputError;
use standfast_figures::Figure;

use crate::summary::Summary;

/// Answer that is written down.
///
/// ```
/// use standfast_cases::{Assessment, AssessmentView, CaseFile, Document};
///
/// let text = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n[[load]]\nforce = 1e6\nelevation = 8\n";
/// let assessment = Assessment::of_file(&CaseFile::parse("case.toml", text)?)?;
/// let view = AssessmentView::default();
/// assert!(assessment.text(&view).contains("the body stays at rest (RE)"));
/// assert!(assessment.json(&view, &[]).contains("\"mode\": \"RE\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Document {
    /// View of the answer: how much of it is shown, where there is a choice.
    type View: Default;

    /// The top of the answer; `None` of one that is a curve or a table.
    fn summary(&self) -> Option<Summary> {
        None
    }

    /// The answer for reading, in lines of at most 88 characters, its summary first.
    fn text(&self, view: &Self::View) -> String;

    /// The answer as one JSON document at full precision, in SI units, or those of a `[block]`; `figures` are the files of its figures, where
    /// they were written.
    fn json(&self, view: &Self::View, figures: &[String]) -> String;

    /// The figures for which the answer has numbers.
    ///
    /// # Errors
    /// If a figure's numbers are out of range.
    fn figures(&self, view: &Self::View) -> Result<Vec<AnswerFigure>, InputError>;
}

/// A figure of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct AnswerFigure {
    /// Suffix of a file's name that tells it from the others of the answer; may be empty.
    pub suffix: String,
    /// Its content, in words.
    pub words: String,
    /// The figure.
    pub figure: Figure,
}

impl AnswerFigure {
    /// True if it is the section of the body, to scale.
    pub fn is_section(&self) -> bool {
        self.suffix == "-section"
    }

    pub(crate) fn new(suffix: impl Into<String>, words: impl Into<String>, figure: Figure) -> AnswerFigure {
        AnswerFigure { suffix: suffix.into(), words: words.into(), figure }
    }
}
