//! How a call over many points is run: threads, what is no error, and who is told how far it is.

use std::num::NonZero;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::grid::{Gaps, Labour, Watch};

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
        let progress = self.progress.as_ref();
        Monitor { progress, total: total.or(self.total), before: 0, last: Instant::now(), raised: None }
    }
}

/// Does long work on a thread of its own, so that Ctrl-C ends the call at once. The work itself cannot be stopped: its thread goes
/// on to its end, unheard.
pub(crate) fn patiently<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (tell, mut told) = mpsc::channel();
    std::thread::Builder::new().spawn(move || tell.send(work())).map_err(|error| {
        PyRuntimeError::new_err(format!("the system has no thread for the work: {error}"))
    })?;
    loop {
        // The receiver goes along and comes back, because it is not to be shared.
        let (heard, back) = py.detach(move || (told.recv_timeout(Monitor::PAUSE), told));
        told = back;
        match heard {
            Ok(done) => return Ok(done),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the work ended without an answer"));
            }
        }
    }
}

/// Lets Python interrupt a call (Ctrl-C), and tells its caller how far it is, while the GIL is released.
pub(crate) struct Monitor<'a> {
    progress: Option<&'a Py<PyAny>>,
    total: Option<usize>,
    /// Points done in earlier stretches.
    before: usize,
    last: Instant,
    raised: Option<PyErr>,
}

impl Monitor<'_> {
    /// Long enough not to be felt where another thread keeps the GIL for its five milliseconds, and short enough for a finger on
    /// Ctrl-C.
    const PAUSE: Duration = Duration::from_millis(100);

    /// Looks after signals and progress if the last time is a while ago; false if Python raised an exception.
    pub(crate) fn step(&mut self, done: usize) -> bool {
        self.look(Some(done))
    }

    /// As [`step`](Monitor::step), where nothing more is done.
    pub(crate) fn wait(&mut self) -> bool {
        self.look(None)
    }

    fn look(&mut self, done: Option<usize>) -> bool {
        if self.last.elapsed() < Self::PAUSE {
            return true;
        }
        let called = Python::attach(|py| {
            py.check_signals()?;
            done.map_or(Ok(()), |done| self.tell(py, done))
        });
        self.last = Instant::now();
        self.raised = called.err();
        self.raised.is_none()
    }

    fn tell(&self, py: Python<'_>, done: usize) -> PyResult<()> {
        let Some(progress) = self.progress else { return Ok(()) };
        progress.call1(py, (self.before + done, self.total)).map(drop)
    }

    /// So many more points are done.
    pub(crate) fn advance(&mut self, done: usize) {
        self.before += done;
    }

    /// The exception that [`step`](Monitor::step) met.
    pub(crate) fn raised(&mut self) -> Option<PyErr> {
        self.raised.take()
    }

    /// Says that everything is done.
    pub(crate) fn finish(mut self, py: Python<'_>) -> PyResult<()> {
        self.total = self.total.or(Some(self.before));
        self.tell(py, 0)
    }
}
