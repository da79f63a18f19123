//! Warnings of rows that are unusual, and may be slips: counted, so that each is said once of a table.

use std::fmt;

/// A [warning](standfast_cases::Warning) about a case that rows of a table have.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowWarning {
    /// Its name.
    pub name: &'static str,
    /// Number of rows that have it.
    pub rows: u64,
    /// The first of them, counted from zero.
    pub first: u64,
    /// Words of the warning on that one.
    pub words: String,
}

impl RowWarning {
    /// The row that it was first met in, counted from one as a table without lines counts them.
    pub fn number(&self) -> u64 {
        self.first + 1
    }
}

impl fmt::Display for RowWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let RowWarning { rows, words, .. } = self;
        match rows {
            1 => write!(f, "in row {}: {words}", self.number()),
            rows => write!(f, "in {rows} rows, the first of them row {}: {words}", self.number()),
        }
    }
}

/// The warnings of some rows, in the order in which they were first met.
#[derive(Debug, Clone, Default)]
pub(crate) struct RowWarnings(Vec<RowWarning>);

impl RowWarnings {
    /// A warning of a row.
    pub(crate) fn add(&mut self, name: &'static str, row: usize, words: impl FnOnce() -> String) {
        match self.0.iter_mut().find(|known| known.name == name) {
            Some(known) => known.rows += 1,
            None => self.0.push(RowWarning { name, rows: 1, first: row as u64, words: words() }),
        }
    }

    /// Those of further rows, before which there are `before` others.
    pub(crate) fn append(&mut self, more: RowWarnings, before: u64) {
        for warning in more.0 {
            match self.0.iter_mut().find(|known| known.name == warning.name) {
                Some(known) => known.rows += warning.rows,
                None => self.0.push(RowWarning { first: before + warning.first, ..warning }),
            }
        }
    }

    pub(crate) fn into_warnings(self) -> Vec<RowWarning> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::RowWarnings;

    /// Whatever the pieces, the counts are those of all rows, and the first is the first.
    #[test]
    fn pieces_add_up() {
        let rows: [&[&'static str]; 6] = [&[], &["b"], &["a", "b"], &[], &["a"], &["c"]];
        let of = |range: std::ops::Range<usize>| {
            let mut minded = RowWarnings::default();
            for (row, names) in rows[range].iter().enumerate() {
                names.iter().for_each(|name| minded.add(name, row, || (*name).to_owned()));
            }
            minded
        };
        for cut in 0..=rows.len() {
            let mut minded = of(0..cut);
            minded.append(of(cut..rows.len()), cut as u64);
            let found = minded.into_warnings();
            let found: Vec<_> = found.iter().map(|one| (one.name, one.rows, one.first)).collect();
            assert_eq!(found, [("b", 2, 1), ("a", 2, 2), ("c", 1, 5)], "cut at {cut}");
        }
    }
}
