//! Columns of numbers to columns of results.

use standfast::batch::{Columns, classify};
use standfast::{InputError, Mode, Modes};

use crate::problem::{Answer, MOST};
use crate::{ResultColumn, TableError, TableOptions, TableProblem};

/// What is computed of every row.
#[derive(Debug, Clone)]
pub(crate) struct Task {
    pub(crate) problem: TableProblem,
    pub(crate) results: Vec<ResultColumn>,
}

/// The code of a row without mode.
pub(crate) const NO_MODE: u8 = u8::MAX;

/// A column of results. A row that has none holds `NO_MODE`, `None` or NaN.
pub(crate) enum Values {
    Mode(Vec<u8>),
    Modes(Vec<Option<Modes>>),
    Flag(Vec<Option<bool>>),
    Number(Vec<f64>),
}

/// A row with a value that no problem can have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fault {
    pub(crate) row: usize,
    /// The place among the problem's columns.
    pub(crate) column: usize,
    pub(crate) expected: &'static str,
}

/// The rows without result.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Faults {
    pub(crate) count: u64,
    pub(crate) first: Option<Fault>,
}

impl Faults {
    pub(crate) fn add(&mut self, fault: Fault) {
        self.count += 1;
        if self.first.is_none_or(|first| fault.row < first.row) {
            self.first = Some(fault);
        }
    }
}

impl Task {
    /// # Errors
    /// If the options name a result that their problem does not have, or one twice.
    pub(crate) fn of(options: &TableOptions) -> Result<Task, TableError> {
        Ok(Task { problem: options.problem, results: options.results()? })
    }

    /// The line of a text that names the columns of the table and the results.
    pub(crate) fn header(&self, columns: &[u8], end: &[u8]) -> Vec<u8> {
        let mut line = columns.to_vec();
        for result in &self.results {
            line.push(b',');
            line.extend_from_slice(result.name().as_bytes());
        }
        line.extend_from_slice(end);
        line
    }

    /// The results for the problem's columns, in the order asked for. Rows marked in `skip`, which is as long as the
    /// columns or empty, get none.
    pub(crate) fn answer(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<Values> {
        let only_modes = self.results.iter().all(|&column| column == ResultColumn::Mode);
        if self.problem == TableProblem::Force && only_modes {
            let codes = self.codes(columns, skip, faults);
            return self.results.iter().map(|_| Values::Mode(codes.clone())).collect();
        }
        let rows = columns[0].len();
        let mut results: Vec<Values> =
            self.results.iter().map(|&column| Values::empty(column, rows)).collect();
        let moving = self.results.iter().any(|column| column.number().is_some());
        for row in 0..rows {
            let answer = self.row(columns, skip, row, faults);
            let motion = answer.as_ref().filter(|_| moving).and_then(Answer::motion);
            for (values, column) in results.iter_mut().zip(&self.results) {
                match values {
                    Values::Mode(codes) => codes.push(code(answer.as_ref())),
                    Values::Modes(sets) => sets.push(answer.as_ref().map(Answer::modes)),
                    Values::Flag(flags) => {
                        flags.push(answer.as_ref().map(|answer| answer.modes().is_empty()))
                    }
                    Values::Number(numbers) => numbers.push(match (column.number(), &motion) {
                        (Some(number), Some(motion)) => number(motion),
                        _ => f64::NAN,
                    }),
                }
            }
        }
        results
    }

    /// The codes of the modes under a force, by the library's kernel for columns.
    fn codes(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<u8> {
        // As far as one wrong value makes the rows go one by one.
        const BLOCK: usize = 4096;
        let mut codes = vec![NO_MODE; columns[0].len()];
        for (block, codes) in codes.chunks_mut(BLOCK).enumerate() {
            let start = block * BLOCK;
            let rows = start..start + codes.len();
            let [gamma, k_prime, k, mu] = std::array::from_fn(|column| &columns[column][rows.clone()]);
            let whole = !skip.get(rows.clone()).is_some_and(|skip| skip.contains(&true));
            let block = Columns { gamma, k_prime, k, mu };
            if !whole || classify(block, codes).is_err() {
                for (code_, row) in codes.iter_mut().zip(rows) {
                    *code_ = code(self.row(columns, skip, row, faults).as_ref());
                }
            }
        }
        codes
    }

    fn row(&self, columns: &[&[f64]], skip: &[bool], row: usize, faults: &mut Faults) -> Option<Answer> {
        if skip.get(row) == Some(&true) {
            return None;
        }
        let mut values = [0.0; MOST];
        for (value, column) in values.iter_mut().zip(columns) {
            *value = column[row];
        }
        let blame = |error: InputError| {
            faults.add(Fault { row, column: self.problem.blame(&error), expected: error.expected.words() });
        };
        self.problem.solve(values).map_err(blame).ok()
    }
}

fn code(answer: Option<&Answer>) -> u8 {
    answer.and_then(Answer::mode).map_or(NO_MODE, Mode::code)
}

impl Values {
    fn empty(column: ResultColumn, rows: usize) -> Values {
        match column {
            ResultColumn::Mode => Values::Mode(Vec::with_capacity(rows)),
            ResultColumn::Modes | ResultColumn::Also => Values::Modes(Vec::with_capacity(rows)),
            ResultColumn::Unique => Values::Flag(Vec::with_capacity(rows)),
            _ => Values::Number(Vec::with_capacity(rows)),
        }
    }

    /// Appends the result of a row to a line of text.
    pub(crate) fn push_text(&self, row: usize, line: &mut Vec<u8>) {
        match self {
            Values::Mode(codes) => {
                line.extend_from_slice(Mode::from_code(codes[row]).map_or("", Mode::symbol).as_bytes());
            }
            Values::Modes(sets) => {
                for (i, mode) in sets[row].iter().flat_map(|set| set.iter()).enumerate() {
                    if i > 0 {
                        line.push(b' ');
                    }
                    line.extend_from_slice(mode.symbol().as_bytes());
                }
            }
            Values::Flag(flags) => line.extend_from_slice(match flags[row] {
                Some(true) => b"true",
                Some(false) => b"false",
                None => b"",
            }),
            Values::Number(numbers) if numbers[row].is_nan() => {}
            Values::Number(numbers) => {
                line.extend_from_slice(ryu::Buffer::new().format_finite(numbers[row]).as_bytes());
            }
        }
    }
}
