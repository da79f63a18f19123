//! Formats of an answer.

use clap::ValueEnum;

/// Format of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For reading, with four significant digits
    #[default]
    Text,
    /// One JSON document, at full precision
    Json,
}
