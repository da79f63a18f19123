//! Files of an office's own code: the factors, divisors and criteria that its combinations share.

use crate::error::CaseError;
use crate::inputs::{Inputs, LoadFactor, Value};
use crate::key::{Id, Key};
use crate::parse::read_code;
use crate::units::Extent;

/// How the name of such a file ends, by which it is told from the sets that the program has.
const ENDING: &str = ".toml";

/// What a file of a code may say, each key with its meaning in a combination.
pub(crate) const OF_CODES: [Key; 5] = [
    Key::LoadFactors,
    Key::CombinationScale,
    Key::CombinationMaterials,
    Key::CombinationResist,
    Key::CombinationCriteria,
];

/// A file of a code, read.
#[derive(Debug, PartialEq)]
pub struct CodeFile {
    name: String,
    text: String,
    inputs: Inputs,
}

impl CodeFile {
    /// True of the name of a file.
    pub fn is_called(name: &str) -> bool {
        name.ends_with(ENDING)
    }

    /// Reads its text for a case of an extent; `name` is what errors call it.
    ///
    /// # Errors
    /// As [`CaseText::parse`](crate::CaseText::parse), and if it has a key that only a combination has.
    pub fn parse(name: &str, text: &str, units: Option<Extent>) -> Result<CodeFile, CaseError> {
        let inputs = read_code(name, text, units)?;
        Ok(CodeFile { name: name.to_owned(), text: text.to_owned(), inputs })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Factors on loads.
    pub fn factors(&self) -> &[(String, LoadFactor)] {
        self.inputs.factors(Id::from(Key::LoadFactors)).unwrap_or_default()
    }

    /// Numbers under names: of `scale`, `materials` or `resist`.
    pub fn ratios(&self, key: Key) -> &[(String, f64)] {
        self.inputs.ratios(Id::from(key)).unwrap_or_default()
    }

    /// Criteria with their bounds.
    pub fn bounds(&self) -> &[(Key, Value)] {
        self.inputs.bounds(Id::from(Key::CombinationCriteria)).unwrap_or_default()
    }
}
