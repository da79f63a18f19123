//! How a call over many points is run: threads, what is no error, and who is told how far it is.

use std::num::NonZero;

use pyo3::prelude::*;

use crate::grid::{Labour, Watch};
use crate::reader::Gaps;
use crate::watch::{Caller, Monitor};

/// What Python says of a call; `_run.Run` is its other side.
#[derive(FromPyObject)]
pub(crate) struct Run {
    /// How many threads; all processors for `None`.
    threads: Option<NonZero<usize>>,
    /// Whether a point with an impossible value has no answer, where it is an error otherwise.
    null_errors: bool,
    /// Whether NaN says that a value is missing, where it is an impossible value otherwise.
    nan_is_missing: bool,
    /// Whether the force points right, and modes and motions are to be mirrored.
    pub(crate) right: bool,
    /// Called with how many points are done and how many there are.
    progress: Option<Py<PyAny>>,
    /// How many points there are, where that is known beforehand.
    total: Option<usize>,
}

impl Run {
    pub(crate) fn threads(&self) -> usize {
        self.threads.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZero::get)
    }

    pub(crate) fn gaps(&self) -> Gaps {
        Gaps { nan: self.nan_is_missing, errors: self.null_errors }
    }

    /// How a grid is to be worked on.
    pub(crate) fn labour<'a, 'w>(&self, watch: &'a mut Watch<'w>) -> Labour<'a, 'w> {
        Labour { threads: self.threads(), gaps: self.gaps(), right: self.right, watch }
    }

    /// Who looks after a call; `total` is how many points there are, if the arrays tell it.
    pub(crate) fn monitor(&self, total: Option<usize>) -> Monitor<'_> {
        Monitor::of(Caller { progress: self.progress.as_ref(), total: total.or(self.total) })
    }
}
