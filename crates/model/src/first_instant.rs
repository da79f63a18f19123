//! A case in time at its first instant: what `assess`, `design`, probabilities and the sheet have of it.
//!
//! Every load acts at its own value, which its history reaches where its peak is 1, and the peaks of the base's acceleration act as
//! an `[earthquake]`.

use std::sync::Arc;

use standfast_motion::record::Record;

use crate::case::Case;
use crate::case_file::CaseFile;
use crate::criteria::MotionCriterion;
use crate::digits::plain;
use crate::error::{CaseError, Fault};
use crate::inputs::{Inputs, Value};
use crate::key::{Id, Key, Table};
use crate::record::RecordFile;

/// Ends the sentence of what is answered of the first instant.
const FOLLOWED: &str = "; the motion in time is what `standfast simulate` follows";

/// Ends the same sentence of a base seen from above.
const IN_DIRECTIONS: &str = "; where rest ends along the records is what `standfast directions` says";

/// Accelerations of the base that are given beside a case, in place of those it names: in their units, or where those are unnamed in
/// m/s² or in the units of a `[block]`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GivenBase {
    /// To the right.
    pub horizontal: Option<Record>,
    /// Upwards.
    pub vertical: Option<Record>,
}

/// A case file at its first instant.
#[derive(Debug, Clone)]
pub struct FirstInstant {
    /// The case of it, without what is said of time.
    pub file: CaseFile,
    /// A sentence without its stop that says what is answered of it.
    pub note: String,
}

impl FirstInstant {
    /// The sentence without what follows the motion.
    pub fn of_instant(&self) -> &str {
        let stripped = [FOLLOWED, IN_DIRECTIONS].iter().find_map(|end| self.note.strip_suffix(end));
        stripped.unwrap_or(&self.note)
    }
}

impl CaseFile {
    /// True if its loads or its base go with time, so that there is a motion to follow.
    pub fn is_in_time(&self) -> bool {
        self.inputs().is_in_time()
    }

    /// The file with a base that moves as is given, in place of what it says of that.
    pub fn on_base(&self, given: &GivenBase) -> CaseFile {
        let mut file = self.clone();
        let records = [(Table::BaseHorizontal, &given.horizontal), (Table::BaseVertical, &given.vertical)];
        for (table, record) in records {
            let Some(record) = record else { continue };
            let mut inputs = file.inputs().clone();
            inputs.remove_tables(|other| other == table);
            for table in [Table::Motion, Table::Base, table] {
                if !inputs.has(table) {
                    inputs.add_table(table);
                }
            }
            inputs.put(Id::of(table, 0, Key::HistoryShape), Value::Choice("file"));
            let name = format!("the {} record", table.name());
            let record = Arc::new(RecordFile::of_record(name, record.clone()));
            inputs.put(Id::of(table, 0, Key::RecordFile), Value::Record(record));
            file = file.varied(inputs);
        }
        file
    }

    /// A case in time at its first instant; `None` of one that says nothing of time.
    ///
    /// # Errors
    /// If what it says of time makes no sense.
    pub fn first_instant(&self) -> Result<Option<FirstInstant>, CaseError> {
        if !self.is_in_time() {
            return Ok(None);
        }
        let (inputs, peaks) = at_first_instant(self.inputs()).map_err(|fault| self.error(fault))?;
        let mut file = self.varied(inputs);
        let on_plan = self.case().is_ok_and(|case| case.plan.is_some());
        let end = if on_plan { IN_DIRECTIONS } else { FOLLOWED };
        let mut note =
            format!("the loads are taken at their own values, all at once, as if at rest until then{end}");
        if !peaks.is_empty() {
            for (key, peak) in peaks {
                file = file.with_entry(key.into(), format!("\"{} m/s2\"", plain(peak)));
            }
            note = format!("the peaks of the base's acceleration act at once, as an [earthquake]; {note}");
        }
        Ok(Some(FirstInstant { file, note }))
    }

    /// The lines of the file that say how loads go with time, how the base moves, and what is asked of the motion.
    pub fn lines_in_time(&self) -> Vec<&str> {
        let of_time = |id: Id| id.table.is_history() || id.table.is_of_motion() || id.key.is_of_motion();
        let spans = self.entries().iter().filter(|entry| of_time(entry.id)).map(|entry| entry.span.clone());
        let spans: Vec<_> = spans.collect();
        let mut lines = Vec::new();
        let mut start = 0;
        let headers = self.headers().filter(|(table, _)| table.is_history() || table.is_of_motion());
        let headers = headers.map(|(_, span)| span.start..span.start + 1);
        let spans: Vec<_> = spans.into_iter().chain(headers).collect();
        for line in self.text().split_inclusive('\n') {
            let here = start..start + line.len();
            if spans.iter().any(|span| span.start < here.end && here.start < span.end)
                && !line.trim().is_empty()
            {
                lines.push(line.trim());
            }
            start = here.end;
        }
        lines
    }
}

/// The inputs of a case in time at its first instant, and the peaks of the base that are among them.
///
/// # Errors
/// If the case makes no sense.
pub fn at_first_instant(inputs: &Inputs) -> Result<(Inputs, Vec<(Key, f64)>), Fault> {
    let motion = Case::of(inputs)?.motion;
    let (base, away) = motion.map(|motion| (motion.base, motion.away)).unwrap_or_default();
    let peaks =
        [(Key::Horizontal, base.horizontal), (Key::Vertical, base.vertical), (Key::HorizontalZ, away)];
    let peaks: Vec<_> = peaks.into_iter().filter_map(|(key, history)| Some((key, history?.peak()))).collect();
    let mut still = without_time(inputs);
    if !peaks.is_empty() {
        still.add_table(Table::Earthquake);
        peaks.iter().for_each(|(key, peak)| still.put((*key).into(), Value::Number(*peak)));
    }
    Ok((still, peaks))
}

/// Inputs without what is said of time.
fn without_time(inputs: &Inputs) -> Inputs {
    let mut still = inputs.clone();
    still.remove_tables(|table| table.is_history() || table.is_of_motion());
    Key::ALL.iter().filter(|key| key.is_of_motion()).for_each(|key| still.remove((*key).into()));
    still
}

impl CaseFile {
    /// Criteria on the motion.
    ///
    /// # Errors
    /// If the body is asked to overturn.
    pub fn motion_criteria(&self) -> Result<Vec<MotionCriterion>, CaseError> {
        MotionCriterion::all(self.inputs()).map_err(|fault| self.error(fault))
    }
}
