//! Rows of the general contact problem.

use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use standfast::batch::MOTION;
use standfast::{Mode, Motion, contact};

use crate::rows::{self, Answer, OutputColumns, RowFault};
use crate::run::Run;

/// The names of the numbers of a problem, in their order, and those of the numbers of its answer, by their places.
#[pyfunction]
pub(crate) fn contact_names() -> (Vec<&'static str>, Vec<&'static str>) {
    (contact::INPUTS.map(|(name, _)| name).to_vec(), MOTION.to_vec())
}

type Flags<'py> = PyReadwriteArray1<'py, bool>;

/// Writes modes, all consistent modes and motions of contact problems into columns. A row without mode has the code 255.
#[pyfunction]
pub(crate) fn contact_rows(
    py: Python<'_>,
    arrays: [PyReadonlyArray1<'_, f64>; contact::INPUTS.len()],
    sets: (Option<PyReadwriteArray1<'_, u8>>, Option<PyReadwriteArray1<'_, u16>>),
    mut numbers: Vec<(usize, PyReadwriteArray1<'_, f64>)>,
    mut wrong: Option<Flags<'_>>,
    run: Run,
) -> PyResult<RowFault> {
    let (mut mode, mut modes) = sets;
    let inputs = rows::columns(&arrays)?;
    let numbers = rows::numbers(&mut numbers, inputs[0].len())?;
    let moving = !numbers.is_empty();
    let out = OutputColumns {
        mode: mode.as_mut().map(|mode| mode.as_slice_mut()).transpose()?,
        modes: modes.as_mut().map(|modes| modes.as_slice_mut()).transpose()?,
        numbers,
        wrong: wrong.as_mut().map(|wrong| wrong.as_slice_mut()).transpose()?,
    };
    let solve = |row| {
        let solution = contact::solve_row(row)?;
        let mode = solution.mode();
        let motion = mode.filter(|_| moving).and_then(|mode| solution.motion(mode));
        let mut numbers = Answer::NONE.numbers;
        if let Some(motion) = motion {
            numbers = values(&motion);
        }
        Ok(Answer { mode: mode.map_or(u8::MAX, Mode::code), modes: solution.modes.bits(), numbers })
    };
    Ok(rows::said(py.detach(|| rows::answer(inputs, out, run.threads(), &solve))))
}

/// The numbers of a motion in the order of [`MOTION`].
fn values(motion: &Motion) -> [f64; MOTION.len()] {
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } = *motion;
    [x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime]
}
