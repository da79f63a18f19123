//! Progress of a run, on a terminal and for who interrupts it.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar, ProgressStyle};
use standfast_cases::motion::Progressed;
use standfast_tables::Progress;

/// Progress of a table.
pub struct Bar {
    rows: AtomicU64,
    start: Instant,
    bar: ProgressBar,
}

impl Bar {
    /// A bar on standard error, if that is a terminal. `bytes` is the length of the input, if it is known and counts.
    pub fn shown(bytes: Option<u64>) -> Bar {
        let bar = match bytes {
            Some(bytes) => ProgressBar::new(bytes).with_style(style(WITH_END)),
            None => ProgressBar::new_spinner().with_style(style(WITHOUT_END)),
        };
        Bar { rows: AtomicU64::new(0), start: Instant::now(), bar }
    }

    /// The rows answered up to now.
    pub(crate) fn rows(&self) -> u64 {
        self.rows.load(Ordering::Relaxed)
    }

    /// Takes the bar away.
    pub(crate) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Bar {
    fn expect(&self, length: u64) {
        self.bar.set_style(style(WITH_END));
        self.bar.set_length(length);
    }

    fn advance(&self, rows: u64, units: u64) {
        let rows = self.rows.fetch_add(rows, Ordering::Relaxed) + rows;
        let seconds = self.start.elapsed().max(Duration::from_millis(1)).as_secs_f64();
        let rate = HumanCount((rows as f64 / seconds) as u64);
        self.bar.set_message(format!("{} rows, {rate} rows/s", HumanCount(rows)));
        self.bar.inc(units);
    }
}

const WITH_END: &str = "{bar:40} {percent}%  {msg}, {eta} left";
const WITHOUT_END: &str = "{spinner} {msg}, {elapsed}";

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Progress of motions: the number followed.
pub struct Motions {
    done: AtomicU64,
    start: Instant,
    bar: ProgressBar,
}

impl Motions {
    /// A bar on standard error, if that is a terminal.
    pub(crate) fn shown() -> Motions {
        Motions {
            done: AtomicU64::new(0),
            start: Instant::now(),
            bar: ProgressBar::new(0).with_style(style(WITH_END)),
        }
    }

    pub(crate) fn tell(&self, progressed: Progressed) {
        match progressed {
            Progressed::Expect(count) => self.bar.inc_length(count as u64),
            Progressed::Done => {
                let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
                if done.is_multiple_of(16) {
                    let seconds = self.start.elapsed().max(Duration::from_millis(1)).as_secs_f64();
                    let rate = HumanCount((done as f64 / seconds) as u64);
                    self.bar.set_message(format!("{} motions, {rate} a second", HumanCount(done)));
                    self.bar.inc(16);
                }
            }
        }
    }

    pub(crate) fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    pub(crate) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
