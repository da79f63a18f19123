//! Answers to rows of numbers, one after another: problems that have no kernel for columns.
//!
//! Python cuts arrays into blocks, so that an interrupt is obeyed between two of them; here a block is shared among threads.

use std::thread;

use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use standfast::InputError;
use standfast::batch::MOTION;

use crate::errors::StandfastError;

/// How many numbers an answer has: those of a motion.
pub(crate) const NUMBERS: usize = MOTION.len();

/// The answer to a row.
pub(crate) struct Answer {
    pub(crate) mode: u8,
    pub(crate) modes: u16,
    pub(crate) numbers: [f64; NUMBERS],
}

impl Answer {
    /// That of a row which has none.
    pub(crate) const NONE: Answer = Answer { mode: u8::MAX, modes: 0, numbers: [f64::NAN; NUMBERS] };
}

/// Columns for answers, as long as a block.
pub(crate) struct OutputColumns<'a> {
    pub(crate) mode: Option<&'a mut [u8]>,
    pub(crate) modes: Option<&'a mut [u16]>,
    /// Numbers by their place in an [`Answer`].
    pub(crate) numbers: Vec<(usize, &'a mut [f64])>,
    /// Marks rows that no body, force or friction can have; without it, the first of them is an error.
    pub(crate) wrong: Option<&'a mut [bool]>,
}

impl<'a> OutputColumns<'a> {
    fn split_at(self, middle: usize) -> (OutputColumns<'a>, OutputColumns<'a>) {
        fn halves<T>(column: Option<&mut [T]>, middle: usize) -> (Option<&mut [T]>, Option<&mut [T]>) {
            column.map(|column| column.split_at_mut(middle)).unzip()
        }
        let (mode, mode_rest) = halves(self.mode, middle);
        let (modes, modes_rest) = halves(self.modes, middle);
        let (wrong, wrong_rest) = halves(self.wrong, middle);
        let split = |(place, column): (usize, &'a mut [f64])| {
            let (column, rest) = column.split_at_mut(middle);
            ((place, column), (place, rest))
        };
        let (numbers, numbers_rest) = self.numbers.into_iter().map(split).unzip();
        (
            OutputColumns { mode, modes, numbers, wrong },
            OutputColumns { mode: mode_rest, modes: modes_rest, numbers: numbers_rest, wrong: wrong_rest },
        )
    }
}

/// A row that has no answer, and why.
pub(crate) type RowError = (usize, InputError);

/// Answers rows on threads; the first wrong row where nobody marks them.
pub(crate) fn answer<const N: usize>(
    inputs: [&[f64]; N],
    out: OutputColumns<'_>,
    threads: usize,
    solve: &(impl Fn([f64; N]) -> Result<Answer, InputError> + Sync),
) -> Option<RowError> {
    let rows = inputs[0].len();
    let part = rows.div_ceil(threads).max(1);
    thread::scope(|scope| {
        let mut rest = out;
        let mut parts = Vec::new();
        let mut start = 0;
        while start < rows {
            let length = part.min(rows - start);
            let (own, others) = rest.split_at(length);
            rest = others;
            let inputs = inputs.map(|column| &column[start..start + length]);
            let at = start;
            start += length;
            if start == rows {
                // The last part needs no thread of its own.
                return own_then(parts, run(inputs, own, at, solve));
            }
            parts.push(scope.spawn(move || run(inputs, own, at, solve)));
        }
        None
    })
}

/// The first wrong row of parts in their order, the last of which is done.
fn own_then(
    parts: Vec<thread::ScopedJoinHandle<'_, Option<RowError>>>,
    last: Option<RowError>,
) -> Option<RowError> {
    let ended = parts.into_iter().map(|part| part.join().expect("answering a row does not panic"));
    ended.chain([last]).flatten().min_by_key(|(row, _)| *row)
}

fn run<const N: usize>(
    inputs: [&[f64]; N],
    mut out: OutputColumns<'_>,
    start: usize,
    solve: &impl Fn([f64; N]) -> Result<Answer, InputError>,
) -> Option<RowError> {
    for row in 0..inputs[0].len() {
        let answer = match (solve(inputs.map(|column| column[row])), &mut out.wrong) {
            (Ok(answer), _) => answer,
            (Err(_), Some(wrong)) => {
                wrong[row] = true;
                Answer::NONE
            }
            (Err(error), None) => return Some((start + row, error)),
        };
        if let Some(mode) = &mut out.mode {
            mode[row] = answer.mode;
        }
        if let Some(modes) = &mut out.modes {
            modes[row] = answer.modes;
        }
        for (place, column) in &mut out.numbers {
            column[row] = answer.numbers[*place];
        }
    }
    None
}

/// A wrong row for Python: its place, the quantity with its value, and what is expected.
pub(crate) type RowFault = Option<(usize, String, String)>;

pub(crate) fn said(wrong: Option<RowError>) -> RowFault {
    wrong.map(|(row, error)| (row, error.given(), error.expected.to_string()))
}

/// The columns of a block, which are of one length and without gaps.
pub(crate) fn columns<'a, const N: usize>(
    arrays: &'a [PyReadonlyArray1<'_, f64>; N],
) -> PyResult<[&'a [f64]; N]> {
    let mut columns = [&[][..]; N];
    for (column, array) in columns.iter_mut().zip(arrays) {
        *column = array.as_slice()?;
    }
    if columns.iter().any(|column| column.len() != columns[0].len()) {
        return Err(StandfastError::new_err("columns of different lengths"));
    }
    Ok(columns)
}

/// Columns for numbers, by their place in an [`Answer`].
pub(crate) fn numbers<'a>(
    given: &'a mut [(usize, PyReadwriteArray1<'_, f64>)],
    rows: usize,
) -> PyResult<Vec<(usize, &'a mut [f64])>> {
    given
        .iter_mut()
        .map(|(place, column)| match column.as_slice_mut()? {
            column if column.len() == rows && *place < NUMBERS => Ok((*place, column)),
            _ => Err(StandfastError::new_err("a column of another length, or no such number")),
        })
        .collect()
}
