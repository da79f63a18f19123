//! Lives: what is drawn once, what is drawn anew each year, and what happens at least once.
//!
//! A life is drawn year by year. Given everything else that is drawn once, an outcome is met at least once if the line lies in the
//! *union* of its intervals over all years; a line that is drawn yearly misses it with the product of the probabilities of the
//! years. So the line is not sampled here either. What is drawn once comes from scrambled Sobol' points, the years from a stream of
//! each life's own.

use crate::normal;
use crate::points::Stream;
use crate::problem::{Frame, Outcomes, RandomVector};
use crate::sample::{Averages, Sampled, Work};

/// The lives of one scramble that are taken first.
const FIRST: u64 = 16;
/// Largest dependence of the line on a yearly input that counts as none.
pub(crate) const NONE: f64 = 1e-12;

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

    /// For what an input of a number stays the same: rising where what lasts is first, and the clock before what is drawn in each year.
    pub(crate) fn rank(&self, input: usize) -> u8 {
        match (self.yearly[input], self.clock == Some(input)) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => 2,
        }
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
    let work @ Work { effort, .. } = work.into();
    life.check(inputs);
    let line = outcomes.line();
    let frame = &Frame::ranked(inputs, outcomes, |input| life.rank(input));
    let clock = life.clock.and_then(|clock| frame.order().iter().position(|input| *input == clock));
    let once = frame.order().iter().filter(|input| **input != line && !life.yearly[**input]).count();
    let others = frame.dimensions();
    // What is drawn yearly depends on what is drawn once. If that is the line, it has to be drawn before.
    let line_first = !life.yearly[line] && frame.line_on()[once..others].iter().any(|on| on.abs() > NONE);
    let drawn = DrawnLives { inputs, outcomes, sets, life };
    let times = (life.times().ceil() as u64).max(1);
    // One coordinate at least: a life is no fixed number, even if nothing is drawn once.
    let dimensions = (once + usize::from(line_first)).max(1);
    let averages = Averages { dimensions, first: FIRST, cost: times, count: sets.len(), precise: sets.len() };
    let mut sampled = if line_first {
        averages.take(work, || drawn.worker(effort.seed))
    } else {
        averages.take(work, || {
            let mut scratch = frame.scratch();
            let mut point = vec![0.0; others];
            let mut met: Vec<Vec<(f64, f64)>> = vec![Vec::new(); sets.len()];
            let mut missed = vec![0.0; sets.len()];
            move |scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]| {
                point[..once].iter_mut().zip(coordinates).for_each(|(u, p)| *u = normal::quantile(*p));
                let mut stream = stream(effort.seed, scramble, index);
                met.iter_mut().for_each(Vec::clear);
                missed.fill(0.0);
                let times = life.draw_times(&mut stream);
                for year in 0..times {
                    point[once..].iter_mut().for_each(|u| *u = normal::quantile(stream.draw()));
                    if let (Some(place), Some(time)) = (clock, life.clock_at(year, times)) {
                        point[place] = time;
                    }
                    if life.yearly[line] {
                        frame.evaluate(&point, &mut scratch);
                        for (missed, set) in missed.iter_mut().zip(sets) {
                            *missed += libm::log1p(-scratch.of_set(*set).min(1.0));
                        }
                    } else {
                        frame.intervals(&point, &mut scratch, |piece| {
                            let holds =
                                sets.iter().zip(&mut met).filter(|(set, _)| *set >> piece.outcome & 1 == 1);
                            holds.for_each(|(_, met)| met.push((piece.from, piece.to)));
                        });
                    }
                }
                for ((sum, met), missed) in sums.iter_mut().zip(&mut met).zip(&missed) {
                    *sum += if life.yearly[line] { -libm::expm1(*missed) } else { measure(met) };
                }
            }
        })
    };
    sampled.points *= times;
    sampled.course.iter_mut().for_each(|(points, _)| *points *= times);
    sampled.are_probabilities();
    sampled
}

/// The stream of a life. Those of plain draws have small numbers.
pub(crate) fn stream(seed: u64, scramble: usize, index: u64) -> Stream {
    Stream::new(seed, 1 << 63 | (scramble as u64) << 48 | index)
}

/// The probability that a standard normal lies in any of these intervals.
pub(crate) fn measure(intervals: &mut [(f64, f64)]) -> f64 {
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut sum, mut reached) = (0.0, f64::NEG_INFINITY);
    for &(from, to) in intervals.iter() {
        if to > reached {
            sum += normal::between(from.max(reached), to);
            reached = to;
        }
    }
    sum.min(1.0)
}

/// Lives of which everything is drawn.
struct DrawnLives<'a, O> {
    inputs: &'a RandomVector,
    outcomes: &'a O,
    sets: &'a [u64],
    life: &'a Life,
}

impl<O: Outcomes> DrawnLives<'_, O> {
    fn worker(&self, seed: u64) -> impl FnMut(usize, u64, &[f64], &mut [f64]) {
        let mut values = Values::of_life(self.inputs, self.life);
        move |scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]| {
            let mut stream = stream(seed, scramble, index);
            values.begin(coordinates);
            let times = self.life.draw_times(&mut stream);
            let met = (0..times).fold(0, |met, year| {
                met | self.outcomes.at(values.of_year(self.life.clock_at(year, times), &mut stream))
            });
            for (sum, set) in sums.iter_mut().zip(self.sets) {
                *sum += f64::from(u8::from(met & set != 0));
            }
        }
    }
}

/// Values of all inputs, what is drawn once apart from what is drawn yearly.
pub(crate) struct Values<'a> {
    inputs: &'a RandomVector,
    /// Those that are drawn once, and then the others.
    order: Vec<usize>,
    factor: Vec<Vec<f64>>,
    once: usize,
    /// The place of what goes with the time.
    clock: Option<usize>,
    u: Vec<f64>,
    values: Vec<f64>,
}

impl<'a> Values<'a> {
    pub(crate) fn new(inputs: &'a RandomVector, yearly: &[bool]) -> Values<'a> {
        let n = inputs.laws().len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|input| yearly[*input]);
        let factor = inputs.copula().factor(&order).expect("a copula is positive definite in any order");
        let once = yearly.iter().filter(|yearly| !**yearly).count();
        Values { inputs, order, factor, once, clock: None, u: vec![0.0; n], values: vec![0.0; n] }
    }

    /// Those of a life.
    pub(crate) fn of_life(inputs: &'a RandomVector, life: &Life) -> Values<'a> {
        let values = Values::new(inputs, &life.yearly);
        let clock = life.clock.and_then(|clock| values.order.iter().position(|input| *input == clock));
        Values { clock, ..values }
    }

    /// Begins a life with the chances of what is drawn once.
    pub(crate) fn begin(&mut self, chances: &[f64]) {
        self.u[..self.once].iter_mut().zip(chances).for_each(|(u, p)| *u = normal::quantile(*p));
        (0..self.once).for_each(|place| self.set(place));
    }

    /// Begins a life with the standard normals of what is drawn once.
    pub(crate) fn begin_at(&mut self, u: &[f64]) {
        self.u[..self.once].copy_from_slice(&u[..self.once]);
        (0..self.once).for_each(|place| self.set(place));
    }

    /// The values as they are.
    pub(crate) fn all(&self) -> &[f64] {
        &self.values
    }

    /// The values of the next year, at a time of the life, by its normal.
    pub(crate) fn of_year(&mut self, time: Option<f64>, stream: &mut Stream) -> &[f64] {
        for place in self.once..self.order.len() {
            self.u[place] = normal::quantile(stream.draw());
            if self.clock == Some(place) {
                self.u[place] = time.unwrap_or(self.u[place]);
            }
            self.set(place);
        }
        &self.values
    }

    fn set(&mut self, place: usize) {
        let input = self.order[place];
        let z = self.factor[place].iter().zip(&self.u[..=place]).map(|(a, u)| a * u).sum();
        self.values[input] = self.inputs.laws()[input].value(z);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unions_count_what_is_covered_once() {
        let whole = (f64::NEG_INFINITY, f64::INFINITY);
        assert_eq!(measure(&mut [whole, (0.0, 1.0)]), 1.0);
        let apart = normal::between(-1.0, 0.0) + normal::between(1.0, 2.0);
        assert!((measure(&mut [(1.0, 1.5), (-1.0, 0.0), (-0.5, -0.2), (1.2, 2.0)]) - apart).abs() < 1e-16);
        assert_eq!(measure(&mut []), 0.0);
    }
}
