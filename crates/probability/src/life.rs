//! Lives: what is drawn once, what is drawn anew each year, and what happens at least once.
//!
//! A life is drawn year by year. Given everything else that is drawn once, an outcome is met at least once if the line lies in the
//! *union* of its intervals over all years; a line that is drawn yearly misses it with the product of the probabilities of the
//! years. So the line is not sampled here either. What is drawn once comes from scrambled Sobol' points, the years from a stream of
//! each life's own.

use crate::normal;
use crate::points::Stream;
use crate::problem::{Outcomes, RandomVector};
use crate::row::{Row, rows};
use crate::sample::{Sampled, Work};

/// Inputs of which some are drawn anew each year, or in each event, and the others once.
#[derive(Debug, Clone, PartialEq)]
pub struct Life {
    /// Length of the life in years, not necessarily a whole number.
    pub years: f64,
    /// Of each input, whether it is drawn yearly.
    pub yearly: Vec<bool>,
    /// Number of events a year on average, by Poisson's law, in each of which these are drawn anew; `None` of one each year.
    pub events: Option<f64>,
    /// An input, one of those, that goes with the time: over a life it runs from the beginning to the end of its law, so that of years that follow each
    /// other each has its own value. It is correlated with no other input.
    pub clock: Option<usize>,
}

impl Life {
    /// The normal of the clock in one of so many years; `None` of events, which come at any time.
    pub(crate) fn clock_at(&self, year: u64, times: u64) -> Option<f64> {
        self.events.is_none().then(|| normal::quantile((year as f64 + 0.5) / times as f64))
    }

    /// The logarithm of the chance that what has this probability each time is never met.
    pub(crate) fn log_never(&self, probability: f64) -> f64 {
        match self.events {
            None => self.years * libm::log1p(-probability.min(1.0)),
            Some(rate) => -rate * self.years * probability,
        }
    }

    /// By how much the chance that it is met at least once grows with this probability.
    pub(crate) fn slope(&self, probability: f64) -> f64 {
        let log_never = self.log_never(probability);
        match self.events {
            None => self.years * (log_never * (1.0 - 1.0 / self.years)).exp(),
            Some(rate) => rate * self.years * log_never.exp(),
        }
    }

    /// Number of times that what is drawn yearly is drawn in a life, on average.
    pub fn times(&self) -> f64 {
        self.years * self.events.unwrap_or(1.0)
    }

    /// Panics unless years are whole, where they follow each other, and the list is of as many inputs.
    pub(crate) fn check(&self, inputs: &RandomVector) {
        assert_eq!(self.yearly.len(), inputs.laws().len(), "an entry for each input");
        let lasts = |parent: &usize, input: usize| !self.yearly[*parent] || self.yearly[input];
        let is_given = |input: usize| inputs.parents(input).iter().all(|parent| lasts(parent, input));
        assert!((0..self.yearly.len()).all(is_given), "what a law depends on lasts as long as its value");
        let is_whole = self.years >= 1.0 && self.years.fract() == 0.0;
        assert!(is_whole || self.events.is_some(), "whole years");
        assert!(self.clock.is_none_or(|clock| self.yearly[clock]), "time passes from year to year");
    }

    /// Number of times that it is drawn in one life.
    pub(crate) fn draw_times(&self, stream: &mut Stream) -> u64 {
        let mean = match self.events {
            None => return self.years as u64,
            Some(rate) => rate * self.years,
        };
        // The gaps of a Poisson process are exponential.
        let (mut count, mut at) = (0, -stream.draw().ln());
        while at <= mean {
            count += 1;
            at -= stream.draw().ln();
        }
        count
    }
}

/// The probability that each set of outcomes (a bit for each outcome) is met at least once in a life, for any number of inputs.
/// Points count years, or events.
///
/// # Panics
/// If years that follow each other are no whole number, or the list of what is drawn yearly is of another length than the inputs.
pub fn lives<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    life: &Life,
    work: impl Into<Work<'w>>,
) -> Sampled {
    let alone = Row { bodies: 1, own: vec![false; inputs.laws().len()] };
    rows(inputs, outcomes, sets, &alone, life, work)
}

/// The stream of a life. Those of plain draws have small numbers.
pub(crate) fn stream(seed: u64, scramble: usize, index: u64) -> Stream {
    Stream::new(seed, 1 << 63 | (scramble as u64) << 48 | index)
}
