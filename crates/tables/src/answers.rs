//! Columns of numbers to columns of results.

use standfast::batch::{Columns, classify, classify_on_base};
use standfast::{InputError, Verdict};

use crate::problem::{Answer, MOST};
use crate::results::{NO_WORD, SYMBOLS, Values};
use crate::task::{Fault, Faults, RowFault};
use crate::{ResultColumn, TableProblem};

/// Problem and results of rows of points.
#[derive(Debug, Clone)]
pub(crate) struct Points {
    pub(crate) problem: TableProblem,
    pub(crate) results: Vec<ResultColumn>,
    /// Advice on how to say that a column is ω, if one is taken for it because of its name alone.
    pub(crate) omega_by_name: Option<String>,
}

impl Points {
    /// The results for the problem's columns, in the order asked for. Rows marked in `skip`, which is as long as the
    /// columns or empty, get none.
    pub(crate) fn answer(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<Values> {
        self.mind_omega(columns, skip, faults);
        let only_modes = self.results.iter().all(|&column| column == ResultColumn::Mode);
        if self.problem == TableProblem::Force && only_modes {
            let codes = self.codes(columns, skip, faults);
            return self.results.iter().map(|_| Values::Word(&SYMBOLS, codes.clone())).collect();
        }
        let rows = columns[0].len();
        let mut results: Vec<Values> =
            self.results.iter().map(|column| Values::empty(&column.kind(), rows)).collect();
        let moving = self.results.iter().any(|column| column.number().is_some());
        for row in 0..rows {
            let answer = self.row(columns, skip, row, faults);
            let motion = answer.as_ref().filter(|_| moving).and_then(Answer::motion);
            for (values, column) in results.iter_mut().zip(&self.results) {
                match values {
                    Values::Word(_, codes) => codes.push(code(answer.as_ref())),
                    Values::Modes(sets) => sets.push(answer.as_ref().map(Answer::modes)),
                    Values::Flag(flags) => {
                        flags.push(answer.as_ref().map(|answer| answer.modes().is_empty()))
                    }
                    Values::Number(numbers) => numbers.push(match (column.number(), &motion) {
                        (Some(number), Some(motion)) => number(motion),
                        _ => f64::NAN,
                    }),
                    Values::Name(..) | Values::Text(_) => unreachable!("no result of a point"),
                }
            }
        }
        results
    }

    /// Says that a column of that name is not taken for an angular frequency.
    fn mind_omega(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) {
        let (Some(said), Some(omega)) = (&self.omega_by_name, columns.get(4)) else { return };
        for (row, &value) in omega.iter().enumerate() {
            if value != 0.0 && value.is_finite() && skip.get(row) != Some(&true) {
                faults.minded.warnings.add("omega-as-share", row, || {
                    format!(
                        "the column omega, here {value}, is taken for ω = V/(2B q_u), the share of the base that V crushes, 0 for a rigid \
                         base, and not for an angular frequency; {said} says that it is ω"
                    )
                });
            }
        }
    }

    /// The codes of the modes under a force, by the library's kernel for columns.
    fn codes(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<u8> {
        // As far as one wrong value makes the rows go one by one.
        const BLOCK: usize = 4096;
        let mut codes = vec![NO_WORD; columns[0].len()];
        for (block, codes) in codes.chunks_mut(BLOCK).enumerate() {
            let start = block * BLOCK;
            let rows = start..start + codes.len();
            let [gamma, k_prime, k, mu] = std::array::from_fn(|column| &columns[column][rows.clone()]);
            let omega = columns.get(4).map(|omega| &omega[rows.clone()]);
            let whole = !skip.get(rows.clone()).is_some_and(|skip| skip.contains(&true));
            let block = Columns { gamma, k_prime, k, mu };
            let known = match omega {
                None => whole && classify(block, codes).is_ok(),
                Some(omega) => whole && classify_on_base(block, omega, codes).is_ok(),
            };
            if !known {
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
            let column = self.problem.blame(&error);
            faults.add(Fault { row, wrong: RowFault::Value { column, expected: error.expected.words() } });
        };
        self.problem.solve(values).map_err(blame).ok()
    }
}

fn code(answer: Option<&Answer>) -> u8 {
    answer.and_then(Answer::verdict).map_or(NO_WORD, Verdict::code)
}
