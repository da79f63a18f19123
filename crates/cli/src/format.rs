//! How an answer is printed.

use clap::ValueEnum;

/// How an answer is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For reading, with four significant digits
    #[default]
    Text,
    /// One JSON document, at full precision
    Json,
}
