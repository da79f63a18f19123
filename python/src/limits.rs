//! Limit states of rows of points.

use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use standfast::Point;
use standfast::initiation::LimitState;

use crate::rows::{self, Answer, NUMBERS, OutputColumns, RowFault};
use crate::run::Run;

const _: () = assert!(LimitState::ALL.len() <= NUMBERS);

/// The names of the limit states, by their places.
#[pyfunction]
pub(crate) fn limit_state_names() -> Vec<&'static str> {
    LimitState::ALL.into_iter().map(LimitState::name).collect()
}

/// Writes limit states of points into columns.
#[pyfunction]
pub(crate) fn limit_states(
    py: Python<'_>,
    arrays: [PyReadonlyArray1<'_, f64>; 4],
    mut numbers: Vec<(usize, PyReadwriteArray1<'_, f64>)>,
    mut wrong: Option<PyReadwriteArray1<'_, bool>>,
    run: Run,
) -> PyResult<RowFault> {
    let inputs = rows::columns(&arrays)?;
    let numbers = rows::numbers(&mut numbers, inputs[0].len())?;
    let wrong = wrong.as_mut().map(|wrong| wrong.as_slice_mut()).transpose()?;
    let side = |state: LimitState| if run.right { state.mirrored() } else { state };
    let asked: Vec<_> = numbers.iter().map(|(place, _)| (*place, side(LimitState::ALL[*place]))).collect();
    let out = OutputColumns { mode: None, modes: None, numbers, wrong };
    let solve = |[gamma, k_prime, k, mu]: [f64; 4]| {
        let point = Point::new(gamma, k_prime, k, mu)?;
        let mut numbers = Answer::NONE.numbers;
        asked.iter().for_each(|(place, state)| numbers[*place] = state.at(&point));
        Ok(Answer { numbers, ..Answer::NONE })
    };
    Ok(rows::said(py.detach(|| rows::answer(inputs, out, run.threads(), &solve))))
}
