//! Files that histories name, as they were read.

use std::sync::OnceLock;

use standfast_motion::record::{Record, RecordError};

/// Reads the text of a file that a case names, or says why it cannot.
pub type ReadFile<'a> = dyn Fn(&str) -> Result<String, String> + 'a;

/// A file that a history names, or a record in its place.
#[derive(Debug)]
pub struct RecordFile {
    name: String,
    content: Content,
}

#[derive(Debug)]
enum Content {
    /// Its text, and the record that was last made of it, for a column and a step.
    Text(String, OnceLock<(Chosen, Result<Record, RecordError>)>),
    /// A record whose numbers are in the units of the case.
    Record(Record),
}

/// Column of the file, and the step from value to value.
type Chosen = (Option<String>, Option<f64>);

impl RecordFile {
    /// The text of a file.
    pub fn of_text(name: impl Into<String>, text: String) -> RecordFile {
        RecordFile { name: name.into(), content: Content::Text(text, OnceLock::new()) }
    }

    /// A record in the units of the case.
    pub fn of_record(name: impl Into<String>, record: Record) -> RecordFile {
        RecordFile { name: name.into(), content: Content::Record(record) }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its text, of a file.
    pub fn text(&self) -> Option<&str> {
        match &self.content {
            Content::Text(text, _) => Some(text),
            Content::Record(_) => None,
        }
    }

    /// The record, of a column and with a step where the file leaves them open.
    ///
    /// # Errors
    /// If the file is not a record.
    pub fn record(&self, column: Option<&str>, dt: Option<f64>) -> Result<Record, RecordError> {
        match &self.content {
            Content::Record(record) => Ok(record.clone()),
            Content::Text(text, known) => {
                let read = || Record::parse(&self.name, text, column, dt);
                let (chosen, record) = known.get_or_init(|| ((column.map(str::to_owned), dt), read()));
                if chosen.0.as_deref() == column && chosen.1 == dt { record.clone() } else { read() }
            }
        }
    }
}

impl PartialEq for RecordFile {
    fn eq(&self, other: &RecordFile) -> bool {
        let same = match (&self.content, &other.content) {
            (Content::Text(one, _), Content::Text(two, _)) => one == two,
            (Content::Record(one), Content::Record(two)) => one == two,
            _ => false,
        };
        same && self.name == other.name
    }
}
