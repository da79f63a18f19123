//! Sampling: scrambled Sobol' points with the line integrated, the same about design points, and plain Monte Carlo.
//!
//! Each number of points comes from the seed and its own number alone: the same answer on any number of threads, and more points
//! begin with the ones already taken.

mod crossed;
mod interval;

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

pub use interval::{Estimate, around_quantile};
use standfast_watch::Portion;

use crate::normal;
use crate::points::{Sobol, Stream};
use crate::problem::{Frame, Outcomes, RandomVector, Scratch};

/// Seed, precision and limits of a sampling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// The seed of all random numbers.
    pub seed: u64,
    /// Largest half-width of an interval, relative to the probability.
    pub precision: f64,
    /// Probabilities below this need not be precise.
    pub floor: f64,
    /// The most points that may be taken.
    pub points: u64,
    /// On how many threads; the answer does not depend on it.
    pub threads: usize,
}

impl Default for Effort {
    fn default() -> Effort {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        Effort { seed: 1, precision: 0.05, floor: 1e-6, points: 1 << 22, threads }
    }
}

/// An effort, and the portion of longer work that it is. A sampling that is stopped returns what it has, which is no answer; one that has
/// given enough, the answer before its points were last doubled.
#[derive(Clone, Copy)]
pub struct Work<'w> {
    /// The effort.
    pub effort: Effort,
    /// The portion.
    pub portion: Portion<'w>,
}

impl Effort {
    /// This effort as a portion of longer work.
    pub fn within(self, portion: Portion<'_>) -> Work<'_> {
        Work { effort: self, portion }
    }
}

impl From<&Effort> for Work<'static> {
    fn from(effort: &Effort) -> Work<'static> {
        effort.within(Portion::UNSEEN)
    }
}

/// Probabilities by sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampled {
    /// Of each set of outcomes asked for.
    pub estimates: Vec<Estimate>,
    /// Number of points taken.
    pub points: u64,
    /// True if every probability above the floor is as precise as asked.
    pub precise: bool,
    /// The estimates each time the points were doubled, the last those above, with their number of points.
    pub course: Vec<(u64, Vec<Estimate>)>,
}

impl Sampled {
    /// No probability is above 1.
    pub(crate) fn are_probabilities(&mut self) {
        let of_course = self.course.iter_mut().flat_map(|(_, estimates)| estimates);
        self.estimates.iter_mut().chain(of_course).for_each(|e| e.high = e.high.min(1.0));
    }
}

/// Number of scrambles of one sequence: the spread of their means is the interval.
pub const SCRAMBLES: usize = 32;
/// The points of one scramble that are taken first.
const FIRST: u64 = 256;
/// The points that one piece of work has.
const BLOCK: u64 = 1 << 14;

/// The probability of each set of outcomes (a bit for each outcome; outcomes of one set exclude each other), by scrambled Sobol'
/// points for all inputs but the line, and exact integration along the line.
///
/// # Panics
/// For more inputs than a Sobol' point has coordinates.
pub fn sobol<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    work: impl Into<Work<'w>>,
) -> Sampled {
    scrambles(&Frame::new(inputs, outcomes), sets, &[], work.into())
}

/// Probabilities with the input of this number held at its median; about the points given, as [`importance`] has them,
/// if there are any.
///
/// # Panics
/// For more inputs than a Sobol' point has coordinates.
pub fn sampled_known<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    known: usize,
    about: &[Vec<f64>],
    work: impl Into<Work<'w>>,
) -> Sampled {
    let frame = Frame::holding(inputs, outcomes, known);
    let about: Vec<Vec<f64>> = about.iter().map(|u| frame.others_of(u)).collect();
    scrambles(&frame, sets, &about, work.into())
}

/// Probabilities from points drawn where the outcomes are: nineteen twentieths as standard normals about the points
/// given, the others about the origin, each weighed by what it is drawn too often. The points are independent normals
/// in the order of the inputs, as [`FormPoint::u`](crate::form::FormPoint::u) has them.
///
/// # Panics
/// For more inputs than a Sobol' point has coordinates.
pub fn importance<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    about: &[Vec<f64>],
    work: impl Into<Work<'w>>,
) -> Sampled {
    let frame = Frame::new(inputs, outcomes);
    let about: Vec<Vec<f64>> = about.iter().map(|u| frame.others_of(u)).collect();
    scrambles(&frame, sets, &about, work.into())
}

/// The share of points that importance sampling leaves about the origin.
const AT_ORIGIN: f64 = 0.05;

fn scrambles<O: Outcomes>(frame: &Frame<O>, sets: &[u64], about: &[Vec<f64>], work: Work<'_>) -> Sampled {
    let dimensions = frame.dimensions();
    let picked = usize::from(!about.is_empty());
    let averages = Averages {
        dimensions: dimensions + picked,
        first: FIRST,
        cost: 1,
        count: sets.len(),
        precise: sets.len(),
    };
    // The first coordinates of a sequence are its most even: for the numbers that matter most at the nearest point. Which point is
    // taken is left to the last.
    let mut order: Vec<usize> = (0..dimensions).collect();
    if let Some(nearest) = about.first() {
        order.sort_by(|a, b| nearest[*b].abs().total_cmp(&nearest[*a].abs()));
    }
    let at_once = frame.outcomes.at_once().max(1);
    let mut sampled = averages.take(work, || Weighed {
        frame,
        sets,
        about,
        order: &order,
        scratches: (0..at_once).map(|_| frame.scratch()).collect(),
        points: vec![vec![0.0; dimensions]; at_once],
        weights: Vec::with_capacity(at_once),
    });
    sampled.are_probabilities();
    sampled
}

/// Points weighed by what they are drawn too often, so many at once as the outcomes like to be asked.
struct Weighed<'a, 'f, O> {
    frame: &'a Frame<'f, O>,
    sets: &'a [u64],
    about: &'a [Vec<f64>],
    /// The places of the coordinates.
    order: &'a [usize],
    scratches: Vec<Scratch>,
    /// Room for points that wait to be evaluated, and the weights of those that do.
    points: Vec<Vec<f64>>,
    weights: Vec<f64>,
}

impl<O: Outcomes> Worker for Weighed<'_, '_, O> {
    fn point(&mut self, _: usize, _: u64, coordinates: &[f64], sums: &mut [f64]) {
        let component = if self.about.is_empty() { 0.0 } else { coordinates[self.order.len()] };
        let point = &mut self.points[self.weights.len()];
        for (place, p) in self.order.iter().zip(coordinates) {
            point[*place] = normal::quantile(*p);
        }
        self.weights.push(displaced(point, component, self.about));
        if self.weights.len() == self.points.len() {
            self.finish(sums);
        }
    }

    fn finish(&mut self, sums: &mut [f64]) {
        match &self.points[..self.weights.len()] {
            [] => return,
            [point] => {
                self.frame.evaluate(point, &mut self.scratches[0]);
            }
            points => self.frame.evaluate_each(points, &mut self.scratches),
        }
        for (scratch, weight) in self.scratches.iter().zip(self.weights.drain(..)) {
            for (sum, set) in sums.iter_mut().zip(self.sets) {
                *sum += weight * scratch.of_set(*set);
            }
        }
    }
}

/// What adds to sums what points give, one by one; a function does.
pub(crate) trait Worker {
    /// Adds what a point of a scramble, by its number and its coordinates, gives, now or later.
    fn point(&mut self, scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]);

    /// Adds what points give that were left for later.
    fn finish(&mut self, sums: &mut [f64]) {
        let _ = sums;
    }
}

impl<F: FnMut(usize, u64, &[f64], &mut [f64])> Worker for F {
    fn point(&mut self, scramble: usize, index: u64, coordinates: &[f64], sums: &mut [f64]) {
        self(scramble, index, coordinates, sums);
    }
}

/// Means over scrambled Sobol' points, with the interval that their spread from scramble to scramble gives.
pub(crate) struct Averages {
    /// The coordinates of a point.
    pub(crate) dimensions: usize,
    /// The points of one scramble that are taken first.
    pub(crate) first: u64,
    /// Number of points of an [`Effort`] that each of these counts for.
    pub(crate) cost: u64,
    /// Number of quantities averaged.
    pub(crate) count: usize,
    /// Number of them, the first, that have to be precise.
    pub(crate) precise: usize,
}

impl Averages {
    /// Takes points until the means are as precise as asked.
    pub(crate) fn take<W: Worker>(
        &self,
        Work { effort, portion }: Work<'_>,
        worker: impl Fn() -> W + Sync,
    ) -> Sampled {
        let Averages { dimensions, first, cost, count, precise } = *self;
        let sequences: Vec<Sobol> =
            (0..SCRAMBLES as u64).map(|scramble| Sobol::new(dimensions, effort.seed, scramble)).collect();
        // No more than are allowed, but for one of each scramble.
        let each = (effort.points / (SCRAMBLES as u64 * cost)).max(1);
        let first = first.min(1 << each.ilog2());
        let mut sums = vec![vec![0.0; count]; SCRAMBLES];
        let mut taken = 0;
        let mut course: Vec<(u64, Vec<Estimate>)> = Vec::new();
        let pace = Pace::of(portion, effort.points / cost);
        loop {
            let next = if taken == 0 { first } else { 2 * taken };
            // One piece of work is a run of points of one scramble.
            let runs: Vec<(usize, u64, u64)> = (0..SCRAMBLES)
                .flat_map(|scramble| {
                    (taken..next)
                        .step_by(BLOCK as usize)
                        .map(move |from| (scramble, from, next.min(from + BLOCK)))
                })
                .collect();
            let results = shared_out(effort.threads, runs.len(), || {
                let mut work = worker();
                let mut point = vec![0.0; dimensions];
                let (runs, sequences, pace) = (&runs, &sequences, &pace);
                move |run: usize| {
                    let (scramble, from, to) = runs[run];
                    let mut sums = vec![0.0; count];
                    for index in (from..to).take_while(|_| !is_over(portion, taken)) {
                        point.iter_mut().zip(sequences[scramble].point(index)).for_each(|(x, p)| *x = p);
                        work.point(scramble, index, &point, &mut sums);
                    }
                    work.finish(&mut sums);
                    pace.advance(to - from);
                    sums
                }
            });
            if let Some((points, estimates)) = course.last().filter(|_| is_over(portion, taken)) {
                return Sampled { estimates: estimates.clone(), points: *points, precise: false, course };
            }
            for ((scramble, ..), result) in runs.iter().zip(results) {
                sums[*scramble].iter_mut().zip(result).for_each(|(sum, part)| *sum += part);
            }
            taken = next;
            let points = taken * SCRAMBLES as u64;
            let estimates: Vec<Estimate> = (0..count)
                .map(|which| {
                    let means: Vec<f64> = sums.iter().map(|sum| sum[which] / taken as f64).collect();
                    Estimate::of_means(&means, points)
                })
                .collect();
            let asked = &estimates[..precise];
            let precise = asked.iter().all(|e| e.is_precise(effort.precision, effort.floor));
            pace.reckon(asked, &effort, points);
            course.push((points, estimates.clone()));
            if precise || 2 * points * cost > effort.points || dimensions == 0 || portion.is_stopped() {
                return Sampled { estimates, points, precise, course };
            }
        }
    }
}

/// True if no more points are to be taken: of work that is stopped, and where what was taken already is enough.
fn is_over(portion: Portion<'_>, taken: u64) -> bool {
    if taken == 0 { portion.is_stopped() } else { portion.is_enough() }
}

/// Progress of points that are taken until they are enough: how many that will be is reckoned anew at each doubling.
struct Pace<'w> {
    portion: Portion<'w>,
    /// The most that may be taken.
    most: u64,
    done: AtomicU64,
    expected: AtomicU64,
}

impl<'w> Pace<'w> {
    fn of(portion: Portion<'w>, most: u64) -> Pace<'w> {
        Pace { portion, most, done: AtomicU64::new(0), expected: AtomicU64::new(most) }
    }

    /// So many more are taken.
    fn advance(&self, points: u64) {
        let done = self.done.fetch_add(points, Ordering::Relaxed) + points;
        self.portion.reached(done as f64 / self.expected.load(Ordering::Relaxed) as f64);
    }

    /// Reckons how many points will be enough: the intervals shrink as with 1/√n at the slowest.
    fn reckon(&self, estimates: &[Estimate], effort: &Effort, points: u64) {
        let of = |e: &Estimate| 0.5 * (e.high - e.low) / (effort.precision * e.value);
        let imprecise = estimates.iter().filter(|e| !e.is_precise(effort.precision, effort.floor));
        let farthest = imprecise.map(of).fold(1.0, f64::max);
        let expected = points as f64 * farthest * farthest;
        self.expected.store((expected as u64).clamp(1, self.most.max(points)), Ordering::Relaxed);
    }
}

/// Moves a point about one of the centres, chosen by a number in (0, 1), and gives its weight.
fn displaced(point: &mut [f64], component: f64, about: &[Vec<f64>]) -> f64 {
    if about.is_empty() {
        return 1.0;
    }
    let share = (1.0 - AT_ORIGIN) / about.len() as f64;
    if component >= AT_ORIGIN {
        let which = (((component - AT_ORIGIN) / share) as usize).min(about.len() - 1);
        point.iter_mut().zip(&about[which]).for_each(|(u, centre)| *u += centre);
    }
    // The density of a normal about a centre, relative to that about the origin: exp(u·c − c²/2).
    let ratio =
        |centre: &Vec<f64>| point.iter().zip(centre).map(|(u, c)| u * c - 0.5 * c * c).sum::<f64>().exp();
    (AT_ORIGIN + share * about.iter().map(ratio).sum::<f64>()).recip()
}

/// The probability of each set of outcomes by plain Monte Carlo: every input drawn, nothing integrated, hits counted.
pub fn monte_carlo<'w, O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    work: impl Into<Work<'w>>,
) -> Sampled {
    let Work { effort, portion } = work.into();
    let mut hits = vec![0u64; sets.len()];
    let mut blocks = 0;
    let mut course: Vec<(u64, Vec<Estimate>)> = Vec::new();
    let pace = Pace::of(portion, effort.points);
    loop {
        let next = if blocks == 0 { (effort.points / BLOCK).clamp(1, 4) } else { 2 * blocks };
        let results = shared_out(effort.threads, (next - blocks) as usize, || {
            let pace = &pace;
            move |block: usize| {
                let mut hits = vec![0u64; sets.len()];
                if is_over(portion, blocks) {
                    return hits;
                }
                let mut count = |holds: u64| {
                    hits.iter_mut().zip(sets).for_each(|(hits, set)| *hits += u64::from(holds & set != 0));
                };
                let block = blocks + block as u64;
                if outcomes.at_once() > 1 {
                    let mut columns = vec![Vec::with_capacity(BLOCK as usize); inputs.laws().len()];
                    draw_block(inputs, effort.seed, block, |values| {
                        columns.iter_mut().zip(values).for_each(|(column, value)| column.push(*value));
                    });
                    let mut found = vec![0; BLOCK as usize];
                    outcomes.at_each(&columns, &mut found);
                    found.into_iter().for_each(count);
                } else {
                    draw_block(inputs, effort.seed, block, |values| count(outcomes.at(values)));
                }
                pace.advance(BLOCK);
                hits
            }
        });
        if let Some((points, estimates)) = course.last().filter(|_| is_over(portion, blocks)) {
            return Sampled { estimates: estimates.clone(), points: *points, precise: false, course };
        }
        for result in results {
            hits.iter_mut().zip(result).for_each(|(sum, part)| *sum += part);
        }
        blocks = next;
        let points = blocks * BLOCK;
        let estimates: Vec<Estimate> = hits.iter().map(|&hits| Estimate::of_hits(hits, points)).collect();
        let precise = estimates.iter().all(|e| e.is_precise(effort.precision, effort.floor));
        pace.reckon(&estimates, &effort, points);
        course.push((points, estimates.clone()));
        if precise || 2 * points > effort.points || portion.is_stopped() {
            return Sampled { estimates, points, precise, course };
        }
    }
}

/// The first `count` draws of a seed: each the values of all inputs, in their order.
pub fn draws(inputs: &RandomVector, seed: u64, count: u64, mut each: impl FnMut(&[f64])) {
    let mut left = count;
    let mut block = 0;
    while left > 0 {
        draw_block(inputs, seed, block, |values| {
            if left > 0 {
                each(values);
                left -= 1;
            }
        });
        block += 1;
    }
}

/// Number of draws made at once.
const AT_ONCE: usize = 128;

fn draw_block(inputs: &RandomVector, seed: u64, block: u64, mut each: impl FnMut(&[f64])) {
    let mut stream = Stream::new(seed, block);
    let (laws, n) = (inputs.laws(), inputs.laws().len());
    let is_plain = inputs.copula().is_independent() && !inputs.has_given();
    let factor = (!is_plain).then(|| inputs.copula().natural_factor());
    let (mut normals, mut values) = (vec![0.0; n], vec![0.0; n]);
    // The numbers of one draw after another, as the stream has them; and those of one input after another.
    let (mut numbers, mut columns) = (vec![0.0; n * AT_ONCE], vec![0.0; n * AT_ONCE]);
    for _ in 0..BLOCK as usize / AT_ONCE {
        stream.fill(&mut numbers);
        if let Some(factor) = &factor {
            normal::quantiles(&mut numbers);
            for u in numbers.chunks(n) {
                for (z, row) in normals.iter_mut().zip(factor) {
                    *z = row.iter().zip(u).map(|(a, u)| a * u).sum();
                }
                inputs.put_values(&normals, &mut values);
                each(&values);
            }
            continue;
        }
        for (input, (column, law)) in columns.chunks_mut(AT_ONCE).zip(laws).enumerate() {
            column.iter_mut().zip(numbers.iter().skip(input).step_by(n)).for_each(|(x, p)| *x = *p);
            law.values_of_chances(column);
        }
        for draw in 0..AT_ONCE {
            values.iter_mut().zip(columns.chunks(AT_ONCE)).for_each(|(x, column)| *x = column[draw]);
            each(&values);
        }
    }
}

/// Does pieces of work on so many threads, each with a worker of its own, and gives the results in the order of the pieces.
pub(crate) fn shared_out<R: Send, W: FnMut(usize) -> R>(
    threads: usize,
    pieces: usize,
    worker: impl Fn() -> W + Sync,
) -> Vec<R> {
    if threads <= 1 || pieces <= 1 {
        return (0..pieces).map(worker()).collect();
    }
    let next = AtomicUsize::new(0);
    let results: Mutex<Vec<Option<R>>> = Mutex::new((0..pieces).map(|_| None).collect());
    std::thread::scope(|scope| {
        for _ in 0..threads.min(pieces) {
            scope.spawn(|| {
                let mut work = worker();
                loop {
                    let piece = next.fetch_add(1, Ordering::Relaxed);
                    if piece >= pieces {
                        break;
                    }
                    let result = work(piece);
                    results.lock().expect("no worker panics while it holds the list")[piece] = Some(result);
                }
            });
        }
    });
    let results = results.into_inner().expect("no worker panics while it holds the list");
    results.into_iter().map(|result| result.expect("every piece is taken once")).collect()
}
