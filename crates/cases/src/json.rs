//! JSON documents.

use serde::{Serialize, Serializer};
pub(crate) use standfast_answers::results::number_or_word;

/// The version of the documents.
pub(crate) const SCHEMA: u32 = 1;

/// A document as text, ended by a newline.
pub(crate) fn written(document: &impl Serialize) -> String {
    // Plain structs with string keys always serialise.
    serde_json::to_string_pretty(document).map_or_else(|error| error.to_string(), |json| json + "\n")
}

/// A number, `infinite`, or null.
pub(crate) fn optional_number_or_word<S: Serializer>(
    number: &Option<f64>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match number {
        Some(number) => number_or_word(number, serializer),
        None => serializer.serialize_none(),
    }
}
