//! What is wrong with a case of motion, shown in its text.

use std::ops::Range as Span;

use miette::{Diagnostic, LabeledSpan, SourceCode};
use thiserror::Error;

use crate::excerpt::Excerpt;

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{message}")]
pub struct MotionCaseError {
    message: String,
    help: Option<String>,
    excerpt: Option<Box<Excerpt>>,
    spans: Vec<Span<usize>>,
}

/// A problem and the place it is at.
#[derive(Debug)]
pub(crate) struct Wrong {
    pub message: String,
    pub help: Option<String>,
    pub span: Option<Span<usize>>,
}

impl Wrong {
    pub(crate) fn new(message: impl Into<String>, span: Span<usize>) -> Wrong {
        Wrong { message: message.into(), help: None, span: Some(span) }
    }

    pub(crate) fn help(self, help: impl Into<String>) -> Wrong {
        Wrong { help: Some(help.into()), ..self }
    }

    pub(crate) fn in_file(self, name: &str, text: &str) -> MotionCaseError {
        let first_line = |span: Span<usize>| {
            let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
            span.start..span.start + line.len()
        };
        let Some(span) = self.span.map(first_line) else {
            return MotionCaseError {
                message: self.message,
                help: self.help,
                excerpt: None,
                spans: Vec::new(),
            };
        };
        let (excerpt, spans) = Excerpt::new(name, text, vec![span]);
        MotionCaseError { message: self.message, help: self.help, excerpt: Some(Box::new(excerpt)), spans }
    }
}

impl Diagnostic for MotionCaseError {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.excerpt.as_deref().map(|excerpt| excerpt as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.spans.iter().cloned().map(LabeledSpan::underline)))
    }

    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        Some(Box::new(self.help.as_ref()?))
    }
}
