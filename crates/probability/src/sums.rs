//! Sums over lives: each year has many events, few of which add anything.
//!
//! For given values of all inputs an event adds something with a small chance, and then an amount that depends on how rare an event
//! it is. Two answers, of which the first needs no event at all:
//!
//! * the *mean* is linear in events and years: `E[sum] = years · events · E[amount of an event]`, an integral over the inputs;
//! * the *law* of the sum is that of lives drawn year by year. Of a year's events only those that add something are drawn: their
//!   number is binomial, their amounts those of the tail.

use crate::life::{Life, stream};
use crate::normal;
use crate::points::{Sobol, Stream};
use crate::problem::RandomVector;
use crate::sample::{Averages, Estimate, SCRAMBLES, Sampled, Work, shared_out};

/// Amounts that each event of one year may add.
pub trait Sums: Sync {
    /// Values of a year, prepared for its events.
    type Year;

    /// The year with these values; none if no event of it can add anything or be of the other kind.
    fn year(&self, values: &[f64]) -> Option<Self::Year>;

    /// Mean and chances of one event.
    fn of_event(&self, year: &Self::Year) -> EventMeans;

    /// The chances of one event that it adds anything, and that it is of the other kind: as [`of_event`](Sums::of_event) has them, which may
    /// take longer.
    fn chances(&self, year: &Self::Year) -> [f64; 2] {
        let EventMeans { adds, other, .. } = self.of_event(year);
        [adds, other]
    }

    /// Amount of an event than which this share in (0, 1) of those that add anything is rarer.
    fn amount(&self, year: &Self::Year, share: f64) -> f64;

    /// Function of a share in (0, 1) that gives the event of the other kind at that rarity; `None` where they are only
    /// counted, and nothing is drawn for them.
    fn other(&self, year: &Self::Year) -> Option<impl Fn(f64) -> OtherEvent> {
        let _ = year;
        None::<fn(f64) -> OtherEvent>
    }
}

/// Result of an event of the other kind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OtherEvent {
    /// Amount added.
    pub amount: f64,
    /// True if it ends the life.
    pub ends: bool,
}

/// Mean and chances of what one event adds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EventMeans {
    /// The mean of what it adds.
    pub mean: f64,
    /// The chance that it adds anything.
    pub adds: f64,
    /// The chance that it is of another kind, which adds nothing and is counted.
    pub other: f64,
}

/// Means of one year's events: what they add in all, the chance that one adds anything, and that one is of the other kind. The first
/// is what has to be as precise as the effort asks. A few years add most, far out in what is drawn: nine tenths of the points are
/// taken where a first look has found the sum to come from, and each is weighed by what it is taken too often.
pub fn expected<'w, S: Sums>(
    inputs: &RandomVector,
    sums: &S,
    events: f64,
    work: impl Into<Work<'w>>,
) -> Sampled {
    let work = work.into();
    let n = inputs.laws().len();
    let yearly = vec![false; n];
    let of = |values: &mut Values, u: &[f64]| {
        values.begin_at(u);
        sums.year(values.all()).map_or(EventMeans::default(), |year| sums.of_event(&year))
    };
    let about = Centre::found(n, work.effort.seed, |u| of(&mut Values::new(inputs, &yearly), u).mean);
    let averages = Averages { dimensions: n + 1, first: 128, cost: 1, count: 3, precise: 1 };
    averages.take(work, || {
        let mut values = Values::new(inputs, &yearly);
        let mut u = vec![0.0; n];
        let about = &about;
        move |_: usize, _: u64, coordinates: &[f64], totals: &mut [f64]| {
            u.iter_mut().zip(&coordinates[1..]).for_each(|(u, p)| *u = normal::quantile(*p));
            let weight = about.place(&mut u, coordinates[0]);
            let EventMeans { mean, adds, other } = of(&mut values, &u);
            totals.iter_mut().zip([events * mean, adds, other]).for_each(|(sum, of)| *sum += weight * of);
        }
    })
}

/// Centre and spread, in standard normals, of the function whose mean is taken.
struct Centre {
    centre: Vec<f64>,
    spread: Vec<f64>,
}

/// The share of points that are left about the origin.
const AT_ORIGIN: f64 = 0.1;

impl Centre {
    /// The moments of the function times the density, by two rounds of points: about the origin twice as wide, and then about what was
    /// found. Nothing is lost if they are rough, because every point is weighed.
    fn found(n: usize, seed: u64, f: impl Fn(&[f64]) -> f64) -> Centre {
        const POINTS: u64 = 2048;
        const WIDER: [f64; 2] = [2.0, 1.5];
        let mut about = Centre { centre: vec![0.0; n], spread: vec![1.0; n] };
        // No scramble of the points that follow.
        let sobol = Sobol::new(n, seed, u64::MAX);
        for wider in WIDER {
            let points: Vec<(f64, Vec<f64>)> = (1..=POINTS)
                .map(|index| {
                    let z: Vec<f64> = sobol.point(index).map(normal::quantile).collect();
                    let u: Vec<f64> =
                        (0..n).map(|i| about.centre[i] + wider * about.spread[i] * z[i]).collect();
                    let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
                    (f(&u) * (0.5 * (square(&z) - square(&u))).exp(), u)
                })
                .collect();
            let total: f64 = points.iter().map(|(weight, _)| weight).sum();
            if total.is_nan() || total <= 0.0 {
                break;
            }
            let mean =
                |of: &dyn Fn(&[f64]) -> f64| points.iter().map(|(w, u)| w * of(u)).sum::<f64>() / total;
            let centre: Vec<f64> = (0..n).map(|i| mean(&|u| u[i])).collect();
            // Not much narrower than the law: tails must not be missed.
            let spread = (0..n).map(|i| (1.2 * mean(&|u| (u[i] - centre[i]).powi(2)).sqrt()).max(0.5));
            about.spread = spread.collect();
            about.centre = centre;
        }
        about
    }

    /// Moves a standard normal point about the centre or leaves it, by a number in (0, 1), and gives its weight.
    fn place(&self, u: &mut [f64], component: f64) -> f64 {
        let sides = || self.centre.iter().zip(&self.spread);
        if component >= AT_ORIGIN {
            u.iter_mut().zip(sides()).for_each(|(u, (centre, spread))| *u = centre + spread * *u);
        }
        let parts = u
            .iter()
            .zip(sides())
            .map(|(u, (centre, spread))| 0.5 * (u * u - ((u - centre) / spread).powi(2)) - spread.ln());
        (AT_ORIGIN + (1.0 - AT_ORIGIN) * parts.sum::<f64>().exp()).recip()
    }
}

/// One life.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LifeSums {
    /// Sum of all amounts that its events have added.
    pub sum: f64,
    /// Number of events that added anything.
    pub adding: u64,
    /// Number of events of the other kind.
    pub others: u64,
    /// Sum added by events of the other kind, where they are more than counted.
    pub other_sum: f64,
    /// True if an event ended it: nothing adds anything thereafter.
    pub ended: bool,
}

/// Lives drawn year by year: as many in each of 32 groups, which are independent of each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Lives {
    /// The lives of each group.
    pub groups: Vec<Vec<LifeSums>>,
}

/// Draws lives with so many events a year, doubled until they are enough; at most as many as a power of two for each group that the points of
/// the effort are years for.
///
/// # Panics
/// If years that follow each other are no whole number, or the list of what is drawn yearly is of another length than the inputs.
pub fn lives<'w, S: Sums>(
    inputs: &RandomVector,
    sums: &S,
    events: u64,
    life: &Life,
    work: impl Into<Work<'w>>,
    are_enough: impl Fn(&Lives) -> bool,
) -> Lives {
    let Work { effort, portion } = work.into();
    life.check(inputs);
    let once = life.yearly.iter().filter(|yearly| !**yearly).count();
    let times = (life.times().ceil() as u64).max(1);
    let most = (effort.points / (times * SCRAMBLES as u64)).max(16);
    let each = 1 << most.ilog2();
    let sequences: Vec<Sobol> =
        (0..SCRAMBLES as u64).map(|scramble| Sobol::new(once, effort.seed, scramble)).collect();
    /// The lives of one scramble that are drawn first, and those that one piece of work has.
    const FIRST: u64 = 16;
    const RUN: u64 = 64;
    let steps = portion.steps(SCRAMBLES * (each as usize).div_ceil(RUN as usize));
    let mut all = Lives { groups: vec![Vec::new(); SCRAMBLES] };
    let mut taken = 0;
    loop {
        let next = if taken == 0 { FIRST.min(each) } else { 2 * taken };
        // A round has a run of every scramble, so that whole rounds are as good as all, but fewer.
        let runs: Vec<(usize, u64)> = (taken..next)
            .step_by(RUN as usize)
            .flat_map(|from| (0..SCRAMBLES).map(move |scramble| (scramble, from)))
            .collect();
        let results = shared_out(effort.threads, runs.len(), || {
            let mut values = Values::of_life(inputs, life);
            let mut point = vec![0.0; once];
            let (runs, sequences, steps) = (&runs, &sequences, &steps);
            move |run: usize| {
                let (scramble, from) = runs[run];
                if (taken > 0 || run >= SCRAMBLES) && portion.is_enough() {
                    return None;
                }
                let of_index = |index: u64| {
                    point.iter_mut().zip(sequences[scramble].point(index)).for_each(|(x, p)| *x = p);
                    values.begin(&point);
                    let mut stream = stream(effort.seed, scramble, index);
                    let mut of_life = LifeSums::default();
                    let times = life.draw_times(&mut stream);
                    for year in 0..times {
                        if of_life.ended || portion.is_stopped() {
                            break;
                        }
                        let time = life.clock_at(year, times);
                        if let Some(year) = sums.year(values.of_year(time, &mut stream)) {
                            draw(sums, &year, events, &mut stream, &mut of_life);
                        }
                    }
                    of_life
                };
                let lives = (from..next.min(from + RUN)).map(of_index).collect::<Vec<LifeSums>>();
                steps.advance();
                Some(lives)
            }
        });
        let is_whole = |round: &&[Option<Vec<LifeSums>>]| round.iter().all(Option::is_some);
        for round in results.chunks(SCRAMBLES).take_while(is_whole) {
            all.groups.iter_mut().zip(round).for_each(|(group, run)| group.extend(run.iter().flatten()));
        }
        taken = next;
        if taken >= each || portion.is_enough() || are_enough(&all) {
            return all;
        }
    }
}

/// The events of one year that add something, and how many are of the other kind.
fn draw<S: Sums>(sums: &S, year: &S::Year, events: u64, stream: &mut Stream, life: &mut LifeSums) {
    let [adds, other] = sums.chances(year);
    let adding = binomial(events, adds, stream);
    for _ in 0..adding {
        life.sum += sums.amount(year, stream.draw());
    }
    life.adding += adding;
    let others = binomial(events - adding, other / (1.0 - adds), stream);
    life.others += others;
    if let Some(other) = sums.other(year) {
        for _ in 0..others {
            let OtherEvent { amount, ends } = other(stream.draw());
            life.other_sum += amount;
            if ends {
                life.ended = true;
                break;
            }
        }
    }
}

/// Number of so many events that happen with this chance each: by the gaps between them, which are geometric.
fn binomial(events: u64, chance: f64, stream: &mut Stream) -> u64 {
    if chance.is_nan() || chance <= 0.0 {
        return 0;
    }
    if chance >= 1.0 {
        return events;
    }
    let log = libm::log1p(-chance);
    let (mut count, mut at) = (0, 0.0);
    loop {
        at += (stream.draw().ln() / log).floor() + 1.0;
        if at > events as f64 {
            return count;
        }
        count += 1;
    }
}

impl Lives {
    /// Number of lives.
    pub fn count(&self) -> usize {
        self.groups.iter().map(Vec::len).sum()
    }

    /// A mean of something over lives, with the interval that its spread from group to group gives.
    pub fn mean(&self, of: impl Fn(&LifeSums) -> f64) -> Estimate {
        let means: Vec<f64> =
            self.groups.iter().map(|group| group.iter().map(&of).sum::<f64>() / group.len() as f64).collect();
        Estimate::of_means(&means, self.count() as u64)
    }

    /// The chance of something, in [0, 1].
    pub fn chance(&self, of: impl Fn(&LifeSums) -> bool) -> Estimate {
        let e = self.mean(|life| f64::from(u8::from(of(life))));
        Estimate { high: e.high.min(1.0), ..e }
    }

    /// The sum that a share of all lives stays below or at, with the interval that the groups' own give.
    pub fn quantile(&self, share: f64) -> Estimate {
        let total = |life: &LifeSums| life.sum + life.other_sum;
        let of = |sums: &mut Vec<f64>| {
            sums.sort_by(f64::total_cmp);
            sums[((share * sums.len() as f64).ceil() as usize).clamp(1, sums.len()) - 1]
        };
        let mut all: Vec<f64> = self.groups.iter().flatten().map(total).collect();
        let value = of(&mut all);
        let each: Vec<f64> =
            self.groups.iter().map(|group| of(&mut group.iter().map(total).collect())).collect();
        Estimate::about(value, &each)
    }

    /// Share of all sums that comes of the worst lives, of which these are a share.
    pub fn of_worst(&self, share: f64) -> f64 {
        let mut all: Vec<f64> = self.groups.iter().flatten().map(|life| life.sum + life.other_sum).collect();
        all.sort_by(|a, b| b.total_cmp(a));
        let total: f64 = all.iter().sum();
        let worst = (share * all.len() as f64).round() as usize;
        if total > 0.0 { all[..worst].iter().sum::<f64>() / total } else { 0.0 }
    }
}

/// Values of all inputs, what is drawn once apart from what is drawn yearly.
struct Values<'a> {
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
    fn new(inputs: &'a RandomVector, yearly: &[bool]) -> Values<'a> {
        let n = inputs.laws().len();
        let mut order: Vec<usize> = (0..n).collect();
        // Without laws that are given that is the order of the inputs.
        order.sort_by_key(|input| (yearly[*input], inputs.rank(*input)));
        let factor = inputs.copula().factor(&order).expect("a copula is positive definite in any order");
        let once = yearly.iter().filter(|yearly| !**yearly).count();
        Values { inputs, order, factor, once, clock: None, u: vec![0.0; n], values: vec![0.0; n] }
    }

    /// Those of a life.
    fn of_life(inputs: &'a RandomVector, life: &Life) -> Values<'a> {
        let values = Values::new(inputs, &life.yearly);
        let clock = life.clock.and_then(|clock| values.order.iter().position(|input| *input == clock));
        Values { clock, ..values }
    }

    /// Begins a life with the chances of what is drawn once.
    fn begin(&mut self, chances: &[f64]) {
        self.u[..self.once].iter_mut().zip(chances).for_each(|(u, p)| *u = normal::quantile(*p));
        (0..self.once).for_each(|place| self.set(place));
    }

    /// Begins a life with the standard normals of what is drawn once.
    fn begin_at(&mut self, u: &[f64]) {
        self.u[..self.once].copy_from_slice(&u[..self.once]);
        (0..self.once).for_each(|place| self.set(place));
    }

    /// The values as they are.
    fn all(&self) -> &[f64] {
        &self.values
    }

    /// The values of the next year, at a time of the life, by its normal.
    fn of_year(&mut self, time: Option<f64>, stream: &mut Stream) -> &[f64] {
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
        self.values[input] = self.inputs.value(input, z, &self.values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts of a binomial law: their frequencies against n!/(k!(n−k)!) pᵏ(1−p)ⁿ⁻ᵏ, and their mean where all or none are likely.
    #[test]
    fn gaps_make_the_binomial_law() {
        let mut stream = Stream::new(1, 0);
        let (n, p, draws) = (10u64, 0.3, 200_000);
        let mut counted = [0u32; 11];
        (0..draws).for_each(|_| counted[binomial(n, p, &mut stream) as usize] += 1);
        let mut expected = 0.7f64.powi(10);
        for (k, counted) in counted.into_iter().enumerate() {
            let share = f64::from(counted) / f64::from(draws);
            let error = (expected * (1.0 - expected) / f64::from(draws)).sqrt();
            assert!((share - expected).abs() < 5.0 * error, "{k}: {share} {expected}");
            expected *= (n - k as u64) as f64 / (k as f64 + 1.0) * p / (1.0 - p);
        }
        assert_eq!(binomial(7, 0.0, &mut stream), 0);
        assert_eq!(binomial(7, 1.0, &mut stream), 7);
        let rare: u64 = (0..100_000).map(|_| binomial(1000, 1e-5, &mut stream)).sum();
        assert!((rare as f64 / 1e5 - 0.01).abs() < 5.0 * (0.01f64 / 1e5).sqrt());
    }
}
