//! The exceptions of the package. All are `ValueError`s, which they were before they had names; what is of a wrong type is a `TypeError`, a
//! column that is not there a `KeyError`, as elsewhere in Python.

use pyo3::PyErr;
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use standfast_cases::design::DesignError;
use standfast_cases::motion::MotionsError;
use standfast_cases::random::ProbabilityError;
use standfast_cases::{CaseError as Fault, report};
use standfast_sheet::SheetError;

create_exception!(
    standfast,
    StandfastError,
    PyValueError,
    "What standfast refuses of a value, in a case, a table, a range, a record or a point, or finds no answer to."
);
create_exception!(
    standfast,
    CaseError,
    StandfastError,
    "A case that is not understood, or whose numbers do not go together: the message shows where, and what is expected."
);
create_exception!(
    standfast,
    NoSolution,
    StandfastError,
    "No value of a quantity meets the target of a design, or every value does."
);

/// A fault of a case.
pub(crate) fn of_case(error: &Fault) -> PyErr {
    CaseError::new_err(report(error))
}

/// A case without a design: a fault of it, a target that no value meets, or a request that is not understood.
pub(crate) fn of_design(error: &DesignError) -> PyErr {
    match error {
        DesignError::Case(error) => of_case(error),
        error if error.is_without_solution() => NoSolution::new_err(report(error)),
        error => StandfastError::new_err(report(error)),
    }
}

/// Motions that cannot be followed.
pub(crate) fn of_motions(error: &MotionsError) -> PyErr {
    match error {
        MotionsError::Case(error) => of_case(error),
        error => StandfastError::new_err(report(error)),
    }
}

/// A case without probabilities.
pub(crate) fn of_chance(error: &ProbabilityError) -> PyErr {
    match error {
        ProbabilityError::Case(error) => of_case(error),
        error => StandfastError::new_err(report(error)),
    }
}

/// A case without a sheet.
pub(crate) fn of_sheet(error: &SheetError) -> PyErr {
    match error {
        SheetError::Case(error) => of_case(error),
        error => StandfastError::new_err(report(error)),
    }
}
