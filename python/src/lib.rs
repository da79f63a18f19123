//! The native module of the Python package `standfast`: numpy and Arrow arrays in and out of the library's batches,
//! and diagrams as numbers. What users call, with its documentation, is the Python beside it.

mod arrow_in;
mod arrow_out;
mod assess;
mod contact;
mod design;
mod diagram;
mod directions;
mod errors;
mod explain;
mod figure;
mod grid;
mod limits;
mod motions;
mod ndarray;
mod numbers;
mod onset;
mod operand;
mod probability;
mod reader;
mod reliability;
mod rows;
mod run;
mod sheet;
mod simulate;
mod spectrum;
mod stack;
mod table;
mod watch;

use std::borrow::Cow;

use numpy::PyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use standfast::{InputError, Mode, Verdict};
use standfast_cases::beginnings::BEGINNINGS;
use standfast_cases::examples::EXAMPLES;

use crate::errors::StandfastError;

/// All modes in the order of their codes and ground that fails, as (name, symbol, words).
#[pyfunction]
fn modes() -> Vec<(String, &'static str, &'static str)> {
    let modes = Mode::ALL.into_iter().map(|mode| (format!("{mode:?}"), mode.symbol(), mode.words()));
    let failure = Verdict::BearingFailure;
    modes.chain([(format!("{failure:?}"), failure.symbol(), failure.words())]).collect()
}

/// The names of the operands; of ω the points may have none.
const NAMES: [&str; 5] = ["gamma", "k_prime", "k", "mu", "omega"];

/// That there are as many operands as points have.
fn expect_numbers(found: usize) -> PyResult<()> {
    match found {
        4 | 5 => Ok(()),
        _ => Err(StandfastError::new_err(format!("{found} operands; expected 4, or 5 with omega"))),
    }
}

/// An invalid value as an exception, with its index if it has one.
fn invalid(error: InputError, index: &[usize]) -> PyErr {
    if index.is_empty() {
        return StandfastError::new_err(error.to_string());
    }
    let words = format!("{} at index {}; expected {}", error.given(), written(index), error.expected);
    at_index(StandfastError::new_err(words), index)
}

/// An index as Python writes it.
fn written(index: &[usize]) -> String {
    match index {
        [index] => index.to_string(),
        index => format!("({})", index.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// The exception with the attribute `index`, by which the Python beside this finds the label of a row.
fn at_index(error: PyErr, index: &[usize]) -> PyErr {
    Python::attach(|py| {
        let known = PyTuple::new(py, index).and_then(|index| error.value(py).setattr("index", index));
        known.err().unwrap_or(error)
    })
}

/// The cases to begin from, as (name, title, text).
#[pyfunction]
fn beginnings() -> Vec<(&'static str, &'static str, &'static str)> {
    BEGINNINGS.iter().map(|beginning| (beginning.name, beginning.title, beginning.text)).collect()
}

/// The examples: where each lies in their folder, and what it holds.
#[pyfunction]
fn examples() -> Vec<(&'static str, Cow<'static, [u8]>)> {
    EXAMPLES.iter().map(|(path, bytes)| (*path, Cow::Borrowed(*bytes))).collect()
}

type Codes<'py> = Bound<'py, PyArrayDyn<u8>>;

#[pymodule]
mod _standfast {
    #[pymodule_export]
    use super::arrow_in::{classify_columns, classify_table, onset_columns, onset_table};
    #[pymodule_export]
    use super::arrow_out::{ArrowArray, ArrowTable};
    #[pymodule_export]
    use super::assess::{CaseAnswer, assess};
    #[pymodule_export]
    use super::beginnings;
    #[pymodule_export]
    use super::contact::{contact_names, contact_rows};
    #[pymodule_export]
    use super::design::{boundary, design, minimum};
    #[pymodule_export]
    use super::diagram::{diagram_numbers, diagram_outlines, diagram_svg, failing_modes};
    #[pymodule_export]
    use super::motions::motions;
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "Python's name for it")]
    const __commit__: Option<&str> = option_env!("STANDFAST_COMMIT");
    #[pymodule_export]
    use super::directions::directions;
    #[pymodule_export]
    use super::errors::{CaseError, NoSolution, StandfastError};
    #[pymodule_export]
    use super::examples;
    #[pymodule_export]
    use super::explain::{contact_conditions, explain};
    #[pymodule_export]
    use super::figure::picture;
    #[pymodule_export]
    use super::limits::limit_states;
    #[pymodule_export]
    use super::probability::{ChanceAnswer, draws, plain_effort, probability};
    #[pymodule_export]
    use super::reliability::reliability;
    #[pymodule_export]
    use super::sheet::{sheet, title_block};
    #[pymodule_export]
    use super::simulate::{MotionAnswer, simulate};
    #[pymodule_export]
    use super::spectrum::spectrum;
    #[pymodule_export]
    use super::stack::stack;
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "Python's name for it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    const NUMBER: char = standfast_tables::NUMBER;
    #[pymodule_export]
    use super::modes;
    #[pymodule_export]
    use super::ndarray::{classify, classify_point, onset};
    #[pymodule_export]
    use super::numbers::{closest, heading, make_array, make_table, read_column, read_table, refuse_column};
    #[pymodule_export]
    use super::table::Sweep;
}
