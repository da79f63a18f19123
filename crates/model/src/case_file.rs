//! A case file: its text, and what can be asked of it.

use std::ops::Deref;

use standfast::InputError;
use standfast_inputs::{CaseText, ReadFile};
use standfast_motion::MotionError;

use crate::case::{Case, blamed, motion_fault};
use crate::criteria::Criterion;
use crate::error::{CaseError, Fault, Problem};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};

/// A case file: what it says, where it says it ([`CaseText`]), and what it describes.
#[derive(Debug, Clone)]
pub struct CaseFile(CaseText);

impl Deref for CaseFile {
    type Target = CaseText;

    fn deref(&self) -> &CaseText {
        &self.0
    }
}

impl From<CaseText> for CaseFile {
    fn from(text: CaseText) -> CaseFile {
        CaseFile(text)
    }
}

impl CaseFile {
    /// Reads a case file; `name` is what errors call it.
    ///
    /// # Errors
    /// As [`CaseText::parse`].
    pub fn parse(name: &str, text: &str) -> Result<CaseFile, CaseError> {
        CaseText::parse(name, text).map(CaseFile)
    }

    /// Reads a case file with the files that it names, which `read` reads; `name` is what errors call it.
    ///
    /// # Errors
    /// As [`CaseText::read`].
    pub fn read(name: &str, text: &str, read: &ReadFile<'_>) -> Result<CaseFile, CaseError> {
        CaseText::read(name, text, read).map(CaseFile)
    }

    /// The case file with the files that it names, which `read` reads.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn with_files(self, read: &ReadFile<'_>) -> Result<CaseFile, CaseError> {
        self.0.with_files(read).map(CaseFile)
    }

    /// The case file with the files under some keys.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn with_some_files(
        self,
        read: &ReadFile<'_>,
        which: &dyn Fn(Id) -> bool,
    ) -> Result<CaseFile, CaseError> {
        self.0.with_some_files(read, which).map(CaseFile)
    }

    /// The case file with other values, as if they stood where those of the file do; an entry without value goes.
    pub fn varied(&self, inputs: Inputs) -> CaseFile {
        CaseFile(self.0.varied(inputs))
    }

    /// The case file with another text, and the files of this one that it names as well.
    ///
    /// # Errors
    /// If the text is no case file.
    pub fn reread(&self, text: &str) -> Result<CaseFile, CaseError> {
        Ok(CaseFile(CaseText::parse(self.name(), text)?.with_files_of(&self.0)))
    }

    /// The case file with another number written into its text, in the unit that stands there and as `round` leaves it in that;
    /// `None` of one that is not written so, or that is refused.
    pub fn rewritten(
        &self,
        id: Id,
        si: f64,
        round: impl FnOnce(f64, &str) -> Option<f64>,
    ) -> Option<CaseFile> {
        let unit = self.written_number(id)?.unit;
        let number = round(self.from_si(id, si, &unit)?, &unit)?;
        self.reread(&self.with_number(id, number, &unit)?).ok()
    }

    /// The case file with other numbers in a list of it, and the list as it is then written; `None` of one that is not written so, or that
    /// is refused.
    pub fn relisted(&self, id: Id, si: &[f64]) -> Option<(CaseFile, String)> {
        let (text, list) = self.with_list(id, si)?;
        Some((self.reread(&text).ok()?, list))
    }

    /// The case file with an entry that follows from others, as it would be written.
    pub(crate) fn with_entry(self, id: Id, written: String) -> CaseFile {
        CaseFile(self.0.with_entry(id, written))
    }

    /// The case it describes.
    ///
    /// # Errors
    /// If the values do not go together.
    pub fn case(&self) -> Result<Case, CaseError> {
        let case = Case::of(self.inputs()).map_err(|fault| self.error(fault))?;
        if self.random().is_none() && case.all_criteria().iter().any(Criterion::is_chance) {
            return Err(
                self.no_chance("the case has no [random] table, which says what is random".to_owned())
            );
        }
        Ok(case)
    }

    /// Error that what a criterion asks of chance is not found, shown at the first of them.
    pub fn no_chance(&self, why: String) -> CaseError {
        self.no_chance_of(why, None, Criterion::is_of_chance)
    }

    /// The same, shown at the first for whose key this holds, with help of its own.
    pub fn no_chance_of(&self, why: String, help: Option<String>, holds: impl Fn(Key) -> bool) -> CaseError {
        let mut asked = Table::Criteria.keys().filter(|key| self.inputs().get(*key).is_some() && holds(*key));
        let key = asked.next().unwrap_or(Key::GreatestNotRest);
        self.error(Fault::new(Problem::NoChance { name: key.name(), why, help }, key))
    }

    /// Refusal of the case by the mechanics, shown at the number that brings it about.
    pub fn refused(&self, error: InputError) -> CaseError {
        self.error(blamed(self.inputs(), error))
    }

    /// Refusal of the case by the motion, shown at the number that brings it about.
    pub fn motion_refused(&self, error: MotionError) -> CaseError {
        self.error(motion_fault(self.inputs(), error))
    }
}
