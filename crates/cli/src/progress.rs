//! Progress of a run, on a terminal and for who interrupts it.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Once};
use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar, ProgressDrawTarget, ProgressStyle};
use standfast_cases::{Portion, Watch};
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

/// Work that is not counted in rows: its share that is done.
struct Work {
    start: Instant,
    bar: ProgressBar,
    shown: Once,
    /// True once an answer is wanted as good as it has become.
    is_enough: AtomicBool,
}

/// Parts of the bar of [`Work`].
const PARTS: u64 = 1000;
/// Work that is done sooner has no bar.
const SOON: Duration = Duration::from_millis(500);

impl Watch for Work {
    fn reached(&self, share: f64) {
        if self.start.elapsed() > SOON {
            self.shown.call_once(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
        self.bar.set_position(((share * PARTS as f64) as u64).max(self.bar.position()));
    }

    fn is_enough(&self) -> bool {
        self.is_enough.load(Ordering::Relaxed)
    }
}

/// Outcome of an interrupt.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Interrupt {
    /// The program ends.
    Ends,
    /// The first is answered with what there is by then.
    Answers,
}

/// Does long work, with a bar on standard error if that is a terminal. An interrupt ends the program and says how far the work was: it
/// writes nothing before it is done.
pub fn watched<T>(work: impl FnOnce(Portion<'_>) -> T) -> T {
    with_bar(Interrupt::Ends, work)
}

/// Does long work, as [`watched`] does, whose answer becomes better the longer it takes: an interrupt has it answered as it is, another one
/// ends the program.
pub fn refined<T>(work: impl FnOnce(Portion<'_>) -> T) -> T {
    with_bar(Interrupt::Answers, work)
}

fn with_bar<T>(interrupt: Interrupt, work: impl FnOnce(Portion<'_>) -> T) -> T {
    let bar = ProgressBar::with_draw_target(Some(PARTS), ProgressDrawTarget::hidden());
    let bar = bar.with_style(style("{bar:40} {percent}%  {eta} left"));
    let is_enough = AtomicBool::new(false);
    let watch = Arc::new(Work { start: Instant::now(), bar, shown: Once::new(), is_enough });
    let interrupted = Arc::clone(&watch);
    // Without a handler the program ends all the same.
    let _ = ctrlc::set_handler(move || {
        let percent = 100 * interrupted.bar.position() / PARTS;
        if interrupt == Interrupt::Answers && !interrupted.is_enough.swap(true, Ordering::Relaxed) {
            let words = "the answer follows as precise as it is; interrupt again to end without one";
            interrupted.bar.suspend(|| {
                let _ = writeln!(io::stderr(), "interrupted at {percent} %: {words}");
            });
            return;
        }
        // What is done may be being written.
        if !interrupted.bar.is_finished() {
            interrupted.bar.finish_and_clear();
            let _ = writeln!(io::stderr(), "interrupted at {percent} %; nothing was written");
        }
        std::process::exit(130);
    });
    let done = work(Portion::whole(&*watch));
    watch.bar.finish_and_clear();
    done
}
