//! What is to be said of the rows of a table once they are answered: warnings, and the worst row of each criterion.

use standfast_cases::assess::Assessment;

use crate::row_warning::{RowWarning, RowWarnings};

/// The row of a table that meets a criterion worst.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstRow {
    /// Name of the criterion.
    pub criterion: &'static str,
    /// Its bound in that row, as it is read: `≥ 1.2`.
    pub required: String,
    /// The value in that row, as it is read.
    pub value: String,
    /// What is used of the bound there, as it is read.
    pub utilisation: String,
    /// The situation of that row in which it is met worst, where the case has several.
    pub situation: Option<String>,
    /// True if it is met in that row, and so in all.
    pub is_met: bool,
    /// The row, counted from zero.
    pub row: u64,
    /// Number of rows in which it is not met.
    pub unmet: u64,
    /// Number of rows in which it is asked for.
    pub rows: u64,
    urgency: f64,
}

impl WorstRow {
    /// The row, counted from one as a table without lines counts them.
    pub fn number(&self) -> u64 {
        self.row + 1
    }
}

/// Warnings and worst rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct RowRemarks {
    pub(crate) warnings: RowWarnings,
    worst: Vec<WorstRow>,
}

impl RowRemarks {
    /// The criteria of a row.
    pub(crate) fn check(&mut self, assessment: &Assessment, row: usize) {
        // The worst first, where combinations ask for the same with bounds of their own.
        let mut seen: Vec<&str> = Vec::new();
        for check in assessment.checks() {
            let (urgency, criterion) = (check.check.urgency(), check.check.criterion.name());
            if seen.contains(&criterion) {
                continue;
            }
            seen.push(criterion);
            let found = || WorstRow {
                criterion,
                required: check.check.criterion.required(),
                value: check.check.value_words(check.assessed),
                utilisation: check.check.utilisation_words(),
                situation: assessment.name(check.assessed).filter(|_| assessment.all.len() > 1),
                is_met: check.check.met,
                row: row as u64,
                unmet: 0,
                rows: 0,
                urgency,
            };
            let worst = self.worst_of(criterion, urgency, found);
            worst.rows += 1;
            worst.unmet += u64::from(!check.check.met);
        }
    }

    /// Those of further rows, before which there are `before` others.
    pub(crate) fn append(&mut self, more: RowRemarks, before: u64) {
        self.warnings.append(more.warnings, before);
        for other in more.worst {
            let found = || WorstRow { row: before + other.row, unmet: 0, rows: 0, ..other.clone() };
            let worst = self.worst_of(other.criterion, other.urgency, found);
            worst.rows += other.rows;
            worst.unmet += other.unmet;
        }
    }

    /// The worst row of a criterion after another one, counted without it; only of a worse one are words made.
    fn worst_of(&mut self, criterion: &str, urgency: f64, found: impl FnOnce() -> WorstRow) -> &mut WorstRow {
        let known = self.worst.iter().position(|known| known.criterion == criterion);
        let place = known.unwrap_or(self.worst.len());
        match self.worst.get_mut(place) {
            None => self.worst.push(found()),
            Some(known) if urgency > known.urgency => {
                *known = WorstRow { unmet: known.unmet, rows: known.rows, ..found() };
            }
            Some(_) => {}
        }
        &mut self.worst[place]
    }

    pub(crate) fn into_parts(self) -> (Vec<RowWarning>, Vec<WorstRow>) {
        (self.warnings.into_warnings(), self.worst)
    }
}
