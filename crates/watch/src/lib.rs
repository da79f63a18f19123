//! How far is long work, and is it to go on?
//!
//! Work is handed a [`Portion`]: from which share of the whole it begins, and to which it leads. What has parts hands each a portion of its
//! own; what counts tells [`reached`](Portion::reached). Whoever waits is a [`Watch`], who may stop the work between two steps.
//!
//! ```
//! use std::sync::Mutex;
//! use standfast_watch::{Portion, Watch};
//!
//! #[derive(Default)]
//! struct Told(Mutex<Vec<f64>>);
//!
//! impl Watch for Told {
//!     fn reached(&self, share: f64) {
//!         self.0.lock().unwrap().push(share);
//!     }
//! }
//!
//! let told = Told::default();
//! let [quick, slow] = Portion::whole(&told).parts([1.0, 3.0]);
//! quick.reached(1.0);
//! (1..=2).for_each(|done| slow.part(done - 1, 2).reached(1.0));
//! assert_eq!(told.0.into_inner().unwrap(), [0.25, 0.625, 1.0]);
//! ```

#![forbid(unsafe_code)]

use std::sync::atomic::{AtomicUsize, Ordering};

use thiserror::Error;

/// Listener of long work; of several threads, if that has them.
pub trait Watch: Sync {
    /// Hears that this share of the whole is done. Shares may come out of order where threads tell them.
    fn reached(&self, share: f64);

    /// True if the work is to stop.
    fn is_stopped(&self) -> bool {
        false
    }

    /// True if an answer is wanted as good as it has become: what gets better the longer it takes ends at the next step that leaves one.
    fn is_enough(&self) -> bool {
        false
    }
}

/// Reason why there is no answer: whoever watches has stopped the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("stopped by whoever watches the work")]
pub struct Stopped;

/// Part of long work: its share of the whole, and who is told.
#[derive(Clone, Copy)]
pub struct Portion<'w> {
    watch: Option<&'w dyn Watch>,
    from: f64,
    to: f64,
}

impl<'w> Portion<'w> {
    /// Work that nobody watches.
    pub const UNSEEN: Portion<'static> = Portion { watch: None, from: 0.0, to: 1.0 };

    /// The whole of what is watched.
    pub fn whole(watch: &'w dyn Watch) -> Portion<'w> {
        Portion { watch: Some(watch), from: 0.0, to: 1.0 }
    }

    /// Portions one after the other, each as long as its weight is of their sum.
    pub fn parts<const N: usize>(self, weights: [f64; N]) -> [Portion<'w>; N] {
        let whole: f64 = weights.iter().sum();
        let mut before = 0.0;
        weights.map(|weight| {
            let begins = before;
            before += weight;
            self.between(begins / whole, before / whole)
        })
    }

    /// One of so many portions of the same length.
    pub fn part(self, place: usize, count: usize) -> Portion<'w> {
        self.between(place as f64 / count as f64, (place + 1) as f64 / count as f64)
    }

    fn between(self, from: f64, to: f64) -> Portion<'w> {
        Portion { from: self.at(from), to: self.at(to), ..self }
    }

    fn at(self, share: f64) -> f64 {
        self.from + share.clamp(0.0, 1.0) * (self.to - self.from)
    }

    /// Says that this share of the portion is done; nothing of work that is stopped.
    pub fn reached(self, share: f64) {
        if let Some(watch) = self.watch.filter(|watch| !watch.is_stopped()) {
            watch.reached(self.at(share));
        }
    }

    /// True if the work is to stop: what comes of it then is no answer.
    pub fn is_stopped(self) -> bool {
        self.watch.is_some_and(Watch::is_stopped)
    }

    /// True if what gets better the longer it takes is to end with the answer it has; so is work that is stopped.
    pub fn is_enough(self) -> bool {
        self.watch.is_some_and(|watch| watch.is_enough() || watch.is_stopped())
    }

    /// Goes on unless the work is stopped.
    ///
    /// # Errors
    /// If it is.
    pub fn check(self) -> Result<(), Stopped> {
        if self.is_stopped() { Err(Stopped) } else { Ok(()) }
    }

    /// Count of so many equal steps, on any threads.
    pub fn steps(self, count: usize) -> Steps<'w> {
        Steps { portion: self, count, done: AtomicUsize::new(0) }
    }
}

/// Equal steps of a portion.
pub struct Steps<'w> {
    portion: Portion<'w>,
    count: usize,
    done: AtomicUsize,
}

impl Steps<'_> {
    /// Says that one more is done.
    pub fn advance(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        self.portion.reached(done as f64 / self.count as f64);
    }
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[derive(Default)]
    struct Told {
        shares: Mutex<Vec<f64>>,
        most: f64,
    }

    impl Watch for Told {
        fn reached(&self, share: f64) {
            self.shares.lock().unwrap().push(share);
        }

        fn is_stopped(&self) -> bool {
            self.shares.lock().unwrap().last().is_some_and(|share| *share >= self.most)
        }
    }

    #[test]
    fn portions_of_portions_make_up_the_whole() {
        let told = Told { most: 0.75, ..Told::default() };
        let [first, none, rest] = Portion::whole(&told).parts([1.0, 0.0, 1.0]);
        let steps = first.steps(2);
        steps.advance();
        steps.advance();
        none.reached(1.0);
        assert_eq!(rest.check(), Ok(()));
        rest.part(0, 2).reached(7.0);
        assert_eq!(rest.check(), Err(Stopped));
        assert_eq!(told.shares.into_inner().unwrap(), [0.25, 0.5, 0.5, 0.75]);
    }

    #[test]
    fn nobody_is_told_and_nobody_stops() {
        let [portion, _] = Portion::UNSEEN.parts([1.0, 1.0]);
        portion.reached(0.5);
        assert!(!portion.is_stopped());
    }
}
