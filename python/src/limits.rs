//! Limit states of arrays of points.

use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use standfast::batch::LimitColumn;
use standfast::initiation::LimitState;

use crate::errors::StandfastError;
use crate::ndarray::{Arrays, Mask, broadcast, halted, mask_of, shaped};
use crate::run::Run;

/// Columns of numbers.
type Columns<'py> = Vec<Bound<'py, PyArrayDyn<f64>>>;

fn of_name(name: &str) -> PyResult<LimitState> {
    let found = LimitState::ALL.into_iter().find(|state| state.name() == name);
    found.ok_or_else(|| StandfastError::new_err(format!("there is no limit state {name:?}")))
}

/// The limit states of these names, and which points have none, if there are such.
#[pyfunction]
pub(crate) fn limit_states<'py>(
    py: Python<'py>,
    arrays: Arrays<'py>,
    mask: Option<Mask<'py>>,
    columns: Vec<String>,
    run: Run,
) -> PyResult<(Columns<'py>, Option<Mask<'py>>)> {
    let states = columns.iter().map(|name| of_name(name)).collect::<PyResult<Vec<_>>>()?;
    let grid = broadcast(&arrays, mask.as_ref())?;
    let axes = grid.axes();
    let along = grid.along(&axes);
    // By numpy, which asks the system for large pages.
    let flat: Vec<_> = states.iter().map(|_| PyArray1::<f64>::zeros(py, [grid.len()], false)).collect();
    let mut missing = along.gaps(run.gaps());
    let mut monitor = run.monitor(Some(grid.len()));
    let mut memory: Vec<_> = flat.iter().map(|column| column.readwrite()).collect();
    let out = states
        .iter()
        .zip(&mut memory)
        .map(|(state, memory)| {
            let state = if run.right { state.mirrored() } else { *state };
            Ok(LimitColumn { state, values: memory.as_slice_mut()? })
        })
        .collect::<PyResult<_>>()?;
    let mut watch = |done| monitor.step(done);
    let labour = run.labour(&mut watch);
    let done = py.detach(|| along.limit_states(out, &mut missing, labour));
    if let Err(halt) = done {
        return Err(halted(py, halt, &grid, &run, monitor));
    }
    for column in memory.iter_mut().filter(|_| missing.contains(&true)) {
        let gaps = column.as_slice_mut()?.iter_mut().zip(&missing).filter(|(_, missing)| **missing);
        gaps.for_each(|(value, _)| *value = f64::NAN);
    }
    drop(memory);
    monitor.advance(grid.len());
    monitor.finish(py)?;
    let arrays = flat.into_iter().map(|column| shaped(column, &grid, &axes)).collect::<PyResult<_>>()?;
    Ok((arrays, mask_of(py, missing, &grid, &axes)?))
}
