//! Errors as data: the message, where it is about, and what helps.

use std::error::Error;
use std::ops::Range;

use standfast::InputError;

/// An error with what a reader needs besides its message.
pub trait Explained: Error {
    /// The error to be explained in place of this one, which only passes it on.
    fn passed_on(&self) -> Option<&dyn Explained> {
        None
    }

    /// Advice. The first line is a sentence; those after it are an example, to be copied.
    fn help(&self) -> Option<String> {
        None
    }

    /// The text in which something is wrong, and where.
    fn excerpt(&self) -> Option<Excerpt<'_>> {
        None
    }
}

/// A text with the places in it that an error is about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt<'a> {
    /// Name of the text, as that of its file.
    pub name: &'a str,
    /// The whole text.
    pub text: &'a str,
    /// The places, in bytes, of which there is one at least: that of the error, and those with which it has to do. An empty one is
    /// between characters.
    pub places: Vec<Range<usize>>,
}

impl Explained for InputError {}

impl<'a, E: Explained + 'a> From<E> for Box<dyn Explained + 'a> {
    fn from(error: E) -> Self {
        Box::new(error)
    }
}
