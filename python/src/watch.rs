//! Long work: Ctrl-C ends it, and whoever wants to be told hears how far it is.
//!
//! Work on the caller's thread has a [`Monitor`] that it asks every few thousand points; work that is not made of points is done
//! [`aside`], on a thread of its own. Both ask the same [`Caller`], some ten times a second.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use standfast_cases::Portion;

/// Long enough not to be felt where another thread keeps the GIL for its five milliseconds, and short enough for a finger on
/// Ctrl-C.
const PAUSE: Duration = Duration::from_millis(100);

/// Python, who may interrupt a call, and may want to be told how far it is.
#[derive(Default)]
pub(crate) struct Caller<'a> {
    /// Called with what is done and all there is, where that is known.
    pub(crate) progress: Option<&'a Py<PyAny>>,
    pub(crate) total: Option<usize>,
}

impl Caller<'_> {
    /// Looks after signals and tells what is done, if that is known; fails with what Python raised.
    fn look(&self, py: Python<'_>, done: Option<usize>) -> PyResult<()> {
        py.check_signals()?;
        done.map_or(Ok(()), |done| self.tell(py, done))
    }

    fn tell(&self, py: Python<'_>, done: usize) -> PyResult<()> {
        let Some(progress) = self.progress else { return Ok(()) };
        progress.call1(py, (done, self.total)).map(drop)
    }
}

/// Progress of work that is done aside, and the wish to stop it.
#[derive(Default)]
pub(crate) struct Watch {
    done: AtomicU64,
    stopped: AtomicBool,
}

impl Watch {
    pub(crate) fn advance(&self, by: u64) {
        self.done.fetch_add(by, Ordering::Relaxed);
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    fn done(&self) -> Option<usize> {
        Some(self.done.load(Ordering::Relaxed) as usize)
    }
}

/// Parts in which the share of work is told that is not made of rows.
const PARTS: usize = 1000;

/// Shares are counted in [`PARTS`].
impl standfast_cases::Watch for Watch {
    fn reached(&self, share: f64) {
        self.done.fetch_max((share * PARTS as f64) as u64, Ordering::Relaxed);
    }

    fn is_stopped(&self) -> bool {
        self.is_stopped()
    }
}

/// As [`aside`], for work of which is known what share of it is done. Where it is stopped it ends soon, unheard.
pub(crate) fn watched<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(Portion<'_>) -> T + Send + 'static,
) -> PyResult<T> {
    let caller = Caller { progress, total: Some(PARTS) };
    aside(py, &caller, false, |watch| work(Portion::whole(watch)))
}

/// As [`watched`], for work on what belongs to the caller: it is waited for where it is stopped, too.
pub(crate) fn watched_within<T: Send>(
    py: Python<'_>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(Portion<'_>) -> T + Send,
) -> PyResult<T> {
    let caller = Caller { progress, total: Some(PARTS) };
    let (tell, mut told) = mpsc::channel();
    let watch = Watch::default();
    thread::scope(|scope| {
        let watched = &watch;
        let spawned =
            thread::Builder::new().spawn_scoped(scope, move || tell.send(work(Portion::whole(watched))));
        spawned.map_err(|error| {
            PyRuntimeError::new_err(format!("the system has no thread for the work: {error}"))
        })?;
        loop {
            let (heard, back) = py.detach(move || (told.recv_timeout(PAUSE), told));
            told = back;
            match heard {
                Ok(done) => return caller.tell(py, watch.done().unwrap_or_default()).map(|()| done),
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(raised) = caller.look(py, watch.done()) {
                        watch.stopped.store(true, Ordering::Relaxed);
                        py.detach(move || told.recv()).ok();
                        return Err(raised);
                    }
                }
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the work ended without an answer"));
                }
            }
        }
    })
}

/// Does work on a thread of its own, while the caller looks after Ctrl-C. Work that `stops` where its [`Watch`] says so is waited for
/// then; any other goes on to its end, unheard.
pub(crate) fn aside<T: Send + 'static>(
    py: Python<'_>,
    caller: &Caller<'_>,
    stops: bool,
    work: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<T> {
    let (tell, mut told) = mpsc::channel();
    let watch = Arc::new(Watch::default());
    let watched = Arc::clone(&watch);
    thread::Builder::new().spawn(move || tell.send(work(&watched))).map_err(|error| {
        PyRuntimeError::new_err(format!("the system has no thread for the work: {error}"))
    })?;
    loop {
        // The receiver goes along and comes back, because it is not to be shared.
        let (heard, back) = py.detach(move || (told.recv_timeout(PAUSE), told));
        told = back;
        match heard {
            Ok(done) => return caller.tell(py, watch.done().unwrap_or_default()).map(|()| done),
            Err(RecvTimeoutError::Timeout) => {
                if let Err(raised) = caller.look(py, watch.done()) {
                    watch.stopped.store(true, Ordering::Relaxed);
                    if stops {
                        py.detach(move || told.recv()).ok();
                    }
                    return Err(raised);
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the work ended without an answer"));
            }
        }
    }
}

/// As [`aside`], for work of which nobody knows how far it is, and that cannot be stopped.
pub(crate) fn patiently<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    aside(py, &Caller::default(), false, |_| work())
}

/// Asks the [`Caller`] from within work on its own thread, while the GIL is released.
pub(crate) struct Monitor<'a> {
    caller: Caller<'a>,
    /// Points done in earlier stretches.
    before: usize,
    last: Instant,
    raised: Option<PyErr>,
}

impl<'a> Monitor<'a> {
    pub(crate) fn of(caller: Caller<'a>) -> Monitor<'a> {
        Monitor { caller, before: 0, last: Instant::now(), raised: None }
    }

    /// Asks if the last time is a while ago; false if Python raised an exception.
    pub(crate) fn step(&mut self, done: usize) -> bool {
        self.look(Some(self.before + done))
    }

    /// As [`step`](Monitor::step), where nothing more is done.
    pub(crate) fn wait(&mut self) -> bool {
        self.look(None)
    }

    fn look(&mut self, done: Option<usize>) -> bool {
        if self.last.elapsed() < PAUSE {
            return true;
        }
        self.raised = Python::attach(|py| self.caller.look(py, done)).err();
        self.last = Instant::now();
        self.raised.is_none()
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
        self.caller.total = self.caller.total.or(Some(self.before));
        self.caller.tell(py, self.before)
    }
}
