//! How far a run is, on a terminal and for who interrupts it.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar, ProgressStyle};

/// What is done of a table.
pub struct Progress {
    rows: AtomicU64,
    start: Instant,
    bar: ProgressBar,
}

impl Progress {
    /// Shows nothing.
    pub fn hidden() -> Progress {
        Progress { rows: AtomicU64::new(0), start: Instant::now(), bar: ProgressBar::hidden() }
    }

    /// A bar on standard error, if that is a terminal. `bytes` is the length of the input, if it is known and counts.
    pub fn shown(bytes: Option<u64>) -> Progress {
        let bar = match bytes {
            Some(bytes) => ProgressBar::new(bytes).with_style(style(WITH_END)),
            None => ProgressBar::new_spinner().with_style(style(WITHOUT_END)),
        };
        Progress { bar, ..Progress::hidden() }
    }

    /// Counts in other units than bytes: there are `length` of them.
    pub(super) fn expect(&self, length: u64) {
        self.bar.set_style(style(WITH_END));
        self.bar.set_length(length);
    }

    pub(super) fn advance(&self, rows: u64, units: u64) {
        let rows = self.rows.fetch_add(rows, Ordering::Relaxed) + rows;
        let seconds = self.start.elapsed().max(Duration::from_millis(1)).as_secs_f64();
        let rate = HumanCount((rows as f64 / seconds) as u64);
        self.bar.set_message(format!("{} rows, {rate} rows/s", HumanCount(rows)));
        self.bar.inc(units);
    }

    /// The rows answered up to now.
    pub(super) fn rows(&self) -> u64 {
        self.rows.load(Ordering::Relaxed)
    }

    /// Takes the bar away.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

const WITH_END: &str = "{bar:40} {percent}%  {msg}, {eta} left";
const WITHOUT_END: &str = "{spinner} {msg}, {elapsed}";

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
