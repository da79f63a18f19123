//! Rows of bodies alike: what is common to all of them, what each has of its own, and what happens to any of them.
//!
//! Twenty caissons under one sea are neither one caisson nor twenty that know nothing of each other. Given what is common to them, they
//! are independent: that none is moved has the product of their probabilities. In one event that is what a [`Life`] is with bodies for
//! years; over a life some numbers are common and yearly (the sea), others each body's own and drawn once (its friction), and the line is
//! united over what it stays the same for.

use crate::life::{Life, stream};
use crate::normal;
use crate::points::Stream;
use crate::problem::{Frame, Outcomes, RandomVector};
use crate::sample::{Averages, Sampled, Work};

/// The lives of one scramble that are taken first.
const FIRST: u64 = 16;
/// Largest dependence on another input that counts as none.
const NONE: f64 = 1e-12;

/// Bodies alike, each of which has some inputs of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Number of bodies.
    pub bodies: u64,
    /// Of each input, whether each body draws it for itself.
    pub own: Vec<bool>,
}

impl Row {
    /// One event as what is drawn for each body anew, which is what is drawn yearly of a life of as many years as there are bodies.
    pub fn of_one_event(&self) -> Life {
        Life { years: self.bodies as f64, yearly: self.own.clone(), events: None, clock: None }
    }

    /// Two inputs that are correlated as no row has it over a life: one that each body draws once, and one that all have in common each
    /// year, which would be another for each body.
    pub fn clash(&self, inputs: &RandomVector, life: &Life) -> Option<(usize, usize)> {
        let kinds = Kinds { row: self, life };
        let order = kinds.in_order();
        let factor = factor_of(inputs, &order);
        let pairs = (0..order.len()).flat_map(|place| (0..place).map(move |before| (place, before)));
        let of = |place: usize| kinds.of(order[place]);
        let clashes = |&(place, before): &(usize, usize)| {
            of(place) == Kind::CommonYearly
                && of(before) == Kind::OwnOnce
                && factor[place][before].abs() > NONE
        };
        pairs.filter(clashes).map(|(place, before)| (order[before], order[place])).next()
    }
}

/// For what an input stays the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// For all bodies, all years.
    CommonOnce,
    /// For one body, all years.
    OwnOnce,
    /// For all bodies, one year.
    CommonYearly,
    /// For one body, one year.
    OwnYearly,
}

impl Kind {
    /// True if another of this kind may change while one of the kind `self` stays the same.
    fn outlasts(self, other: Kind) -> bool {
        match self {
            Kind::CommonOnce => other != Kind::CommonOnce,
            Kind::OwnOnce => matches!(other, Kind::CommonYearly | Kind::OwnYearly),
            Kind::CommonYearly => matches!(other, Kind::OwnOnce | Kind::OwnYearly),
            Kind::OwnYearly => false,
        }
    }
}

struct Kinds<'a> {
    row: &'a Row,
    life: &'a Life,
}

impl Kinds<'_> {
    fn of(&self, input: usize) -> Kind {
        match (self.life.yearly[input], self.row.own[input]) {
            (false, false) => Kind::CommonOnce,
            (false, true) => Kind::OwnOnce,
            (true, false) => Kind::CommonYearly,
            (true, true) => Kind::OwnYearly,
        }
    }

    /// All inputs, the longest lasting first.
    fn in_order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.row.own.len()).collect();
        order.sort_by_key(|input| self.of(*input));
        order
    }
}

/// By how much each input depends on those before it in an order.
fn factor_of(inputs: &RandomVector, order: &[usize]) -> Vec<Vec<f64>> {
    inputs.copula().factor(order).expect("a copula is positive definite in any order")
}

/// The probability that each set of outcomes (a bit for each outcome) is met by one body of a row at least, at least once in a life, for any
/// number of inputs. Points count years of one body.
///
/// # Panics
/// If years that follow each other are no whole number, a list is of another length than the inputs, or two inputs
/// [clash](Row::clash).
pub fn rows<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    row: &Row,
    life: &Life,
    work: impl Into<Work<'w>>,
) -> Sampled {
    let work @ Work { effort, .. } = work.into();
    life.check(inputs);
    assert_eq!(row.own.len(), inputs.laws().len(), "an entry for each input");
    assert!(row.clash(inputs, life).is_none(), "what is common is no other for each body");
    let kinds = Kinds { row, life };
    let line = outcomes.line();
    let frame = &Frame::ranked(inputs, outcomes, |input| (kinds.of(input), life.clock != Some(input)));
    let others = &frame.order()[..frame.dimensions()];
    let of_line = kinds.of(line);
    // What changes while the line stays the same must not depend on it: else the line is drawn, before.
    let depends = |(other, on): (&usize, &f64)| on.abs() > NONE && of_line.outlasts(kinds.of(*other));
    let line_first = others.iter().zip(frame.line_on()).any(depends);
    let once = others.iter().filter(|input| kinds.of(**input) == Kind::CommonOnce).count();
    let own = others.iter().filter(|input| row.own[**input]).count();
    // If nothing but the line is each body's own, all of them are as one.
    let is_one = !line_first && own == 0;
    let bodies = if is_one { 1 } else { row.bodies };
    // Where nothing but the line changes from year to year, each has the same chance.
    let changes = |input: &usize| matches!(kinds.of(*input), Kind::CommonYearly | Kind::OwnYearly);
    let is_same =
        !line_first && row.bodies == 1 && of_line == Kind::CommonYearly && !others.iter().any(changes);
    let times = if is_same { 1 } else { (life.times().ceil() as u64).max(1) };
    let cost = times.saturating_mul(bodies);
    let dimensions = (once + usize::from(line_first && of_line == Kind::CommonOnce)).max(1);
    let averages = Averages { dimensions, first: FIRST, cost, count: sets.len(), precise: sets.len() };
    let mut sampled = if line_first {
        averages.take(work, || {
            let order = kinds.in_order();
            let factor = factor_of(inputs, &order);
            let mut drawn = Drawn::new(&order, &kinds);
            let (mut normals, mut values) = (vec![0.0; order.len()], vec![0.0; order.len()]);
            move |scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]| {
                let mut stream = stream(effort.seed, scramble, index);
                let times = drawn.begin(life, bodies, coordinates, &mut stream);
                let mut met = 0;
                for body in 0..bodies {
                    for year in 0..times {
                        let u = drawn.of(body, year, &mut stream);
                        for (row, &input) in factor.iter().zip(&order) {
                            normals[input] = row.iter().zip(u).map(|(a, u)| a * u).sum();
                        }
                        inputs.put_values(&normals, &mut values);
                        met |= outcomes.at(&values);
                    }
                }
                for (sum, set) in sums.iter_mut().zip(sets) {
                    *sum += f64::from(u8::from(met & set != 0));
                }
            }
        })
    } else {
        let alike = if is_one && row.own[line] { row.bodies as f64 } else { 1.0 };
        let by_year = of_line == Kind::CommonYearly;
        // What stays the same for one body in one year alone has nothing to be united with.
        let is_alone = of_line == Kind::OwnYearly || by_year && bodies == 1;
        averages.take(work, || {
            let mut drawn = Drawn::new(others, &kinds);
            let mut scratch = frame.scratch();
            let mut met: Vec<Vec<(f64, f64)>> = vec![Vec::new(); sets.len()];
            let mut missed = vec![0.0; sets.len()];
            move |scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]| {
                let mut stream = stream(effort.seed, scramble, index);
                if is_same {
                    let point = drawn.once(coordinates);
                    frame.evaluate(point, &mut scratch);
                    for (sum, set) in sums.iter_mut().zip(sets) {
                        *sum += -libm::expm1(life.log_never(scratch.of_set(*set).min(1.0)));
                    }
                    return;
                }
                let times = drawn.begin(life, bodies, coordinates, &mut stream);
                missed.fill(0.0);
                met.iter_mut().for_each(Vec::clear);
                let (outer, inner) = if by_year { (times, bodies) } else { (bodies, times) };
                let close = |met: &mut Vec<Vec<(f64, f64)>>, missed: &mut Vec<f64>| {
                    for (missed, met) in missed.iter_mut().zip(met) {
                        *missed += libm::log1p(-measure(met));
                        met.clear();
                    }
                };
                for one in 0..outer {
                    for other in 0..inner {
                        let (body, year) = if by_year { (other, one) } else { (one, other) };
                        let point = drawn.of(body, year, &mut stream);
                        if is_alone {
                            frame.evaluate(point, &mut scratch);
                            for (missed, set) in missed.iter_mut().zip(sets) {
                                *missed += libm::log1p(-scratch.of_set(*set).min(1.0));
                            }
                            continue;
                        }
                        frame.intervals(point, &mut scratch, |piece| {
                            let holds =
                                sets.iter().zip(&mut met).filter(|(set, _)| *set >> piece.outcome & 1 == 1);
                            holds.for_each(|(_, met)| met.push((piece.from, piece.to)));
                        });
                    }
                    if of_line != Kind::CommonOnce {
                        close(&mut met, &mut missed);
                    }
                }
                close(&mut met, &mut missed);
                for (sum, missed) in sums.iter_mut().zip(&missed) {
                    *sum += -libm::expm1(alike * missed);
                }
            }
        })
    };
    sampled.points *= cost;
    sampled.course.iter_mut().for_each(|(points, _)| *points *= cost);
    sampled.are_probabilities();
    sampled
}

/// Independent normals of inputs in the order of their kinds: what lasts is drawn as a life begins, and the rest for each body in each year.
struct Drawn {
    /// Number of inputs of each kind.
    counts: [usize; 4],
    /// Normals of each body, and those of each year, one after the other.
    own: Vec<f64>,
    common: Vec<f64>,
    /// Place of the clock among what is common and yearly.
    clock: Option<usize>,
    point: Vec<f64>,
}

impl Drawn {
    fn new(order: &[usize], kinds: &Kinds<'_>) -> Drawn {
        let of = |kind: Kind| order.iter().filter(|input| kinds.of(**input) == kind).count();
        let counts = [Kind::CommonOnce, Kind::OwnOnce, Kind::CommonYearly, Kind::OwnYearly].map(of);
        let mut yearly = order.iter().filter(|input| kinds.of(**input) == Kind::CommonYearly);
        let clock = kinds.life.clock.and_then(|clock| yearly.position(|input| *input == clock));
        Drawn { counts, own: Vec::new(), common: Vec::new(), clock, point: vec![0.0; order.len()] }
    }

    /// Begins a life with the chances of what is common and drawn once, and gives how many years, or events, it has.
    fn begin(&mut self, life: &Life, bodies: u64, chances: &[f64], stream: &mut Stream) -> u64 {
        let times = life.draw_times(stream);
        let [once, own, yearly, _] = self.counts;
        self.point[..once].iter_mut().zip(chances).for_each(|(u, p)| *u = normal::quantile(*p));
        let fill = |list: &mut Vec<f64>, count: usize, stream: &mut Stream| {
            list.clear();
            list.extend((0..count).map(|_| normal::quantile(stream.draw())));
        };
        fill(&mut self.own, own * bodies as usize, stream);
        fill(&mut self.common, yearly * times as usize, stream);
        for (year, common) in (0..times).zip(self.common.chunks_exact_mut(yearly.max(1))) {
            if let (Some(place), Some(time)) = (self.clock, life.clock_at(year, times)) {
                common[place] = time;
            }
        }
        times
    }

    /// The normals of what is drawn once, where nothing else is.
    fn once(&mut self, chances: &[f64]) -> &[f64] {
        self.point.iter_mut().zip(chances).for_each(|(u, p)| *u = normal::quantile(*p));
        &self.point
    }

    /// The normals of a body in a year.
    fn of(&mut self, body: u64, year: u64, stream: &mut Stream) -> &[f64] {
        let [once, own, yearly, _] = self.counts;
        let part = |list: &[f64], which: u64, to: &mut [f64]| {
            let from = which as usize * to.len();
            to.copy_from_slice(&list[from..from + to.len()]);
        };
        let (lasting, each) = self.point[once..].split_at_mut(own + yearly);
        let (own, yearly) = lasting.split_at_mut(own);
        part(&self.own, body, own);
        part(&self.common, year, yearly);
        each.iter_mut().for_each(|u| *u = normal::quantile(stream.draw()));
        &self.point
    }
}

/// The probability that a standard normal lies in any of these intervals.
fn measure(intervals: &mut [(f64, f64)]) -> f64 {
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
