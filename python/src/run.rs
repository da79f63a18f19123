//! Runs of a call over many points: threads, values that are no error, and progress.

use std::num::NonZero;

use pyo3::prelude::*;

use crate::grid::{Labour, Watch};
use crate::reader::Gaps;
use crate::watch::{Caller, Monitor};

/// Terms of a call, as Python gives them; `_run.Run` is its other side.
#[derive(FromPyObject)]
pub(crate) struct Run {
    /// Number of threads; all processors for `None`.
    threads: Option<NonZero<usize>>,
    /// True if a point with an impossible value has no answer, where it is an error otherwise.
    null_errors: bool,
    /// True if NaN says that a value is missing, where it is an impossible value otherwise.
    nan_is_missing: bool,
    /// True if the force points right, and modes and motions are to be mirrored.
    pub(crate) right: bool,
    /// Called with how many points are done and how many there are.
    progress: Option<Py<PyAny>>,
    /// Number of points, where that is known beforehand.
    total: Option<usize>,
}

impl Run {
    pub(crate) fn threads(&self) -> usize {
        self.threads.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZero::get)
    }

    pub(crate) fn gaps(&self) -> Gaps {
        Gaps { nan: self.nan_is_missing, errors: self.null_errors }
    }

    /// Terms of the work on a grid.
    pub(crate) fn labour<'a, 'w>(&self, watch: &'a mut Watch<'w>) -> Labour<'a, 'w> {
        Labour { threads: self.threads(), gaps: self.gaps(), right: self.right, watch }
    }

    /// Monitor of a call; `total` is the number of points, if the arrays tell it.
    pub(crate) fn monitor(&self, total: Option<usize>) -> Monitor<'_> {
        Monitor::of(Caller { progress: self.progress.as_ref(), total: total.or(self.total) })
    }
}
