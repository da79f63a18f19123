//! Spectra of a case: many motions under the shaking of its `[motion.base]`, over size and slenderness, over the yield ratio, or over the
//! strength of the shaking.

mod areas;

use std::str::FromStr;
use std::sync::atomic::{AtomicUsize, Ordering};

use standfast::number::exact;
use standfast_model::{BlockCase, MotionWarning};
use standfast_motion::MotionError;
use standfast_motion::spectrum::{
    NewmarkSpectrum, OverturningCurve, Rocked, RockingSpectrum, Slid, overturning_stretches,
};
use standfast_watch::{Portion, Stopped};
use thiserror::Error;

use crate::suggest::closest;

/// Values of a quantity, from one to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumSteps {
    /// The first.
    pub from: f64,
    /// The last, greater.
    pub to: f64,
    /// Number of them, two at least.
    pub count: usize,
}

/// At most so many motions in a spectrum.
const MOST: usize = 10_000_000;

impl SpectrumSteps {
    /// At equal steps.
    pub fn even(&self) -> Vec<f64> {
        let last = (self.count - 1) as f64;
        (0..self.count).map(|i| self.from + (self.to - self.from) * (i as f64 / last)).collect()
    }

    /// At equal factors.
    pub fn factors(&self) -> Vec<f64> {
        let last = (self.count - 1) as f64;
        let at = |i: usize| self.from * (self.to / self.from).powf(i as f64 / last);
        (0..self.count).map(|i| if i + 1 == self.count { self.to } else { at(i) }).collect()
    }
}

/// `FROM..TO` or `FROM..TO:COUNT`, or with commas `FROM,TO` or `FROM,TO,COUNT`; a count of 0 is one that was left out.
impl FromStr for SpectrumSteps {
    type Err = String;

    fn from_str(text: &str) -> Result<SpectrumSteps, String> {
        let expected = || {
            format!("{text} is none; expected FROM,TO or FROM,TO,COUNT with 0 < FROM < TO and COUNT from 2")
        };
        let by_commas = text.replacen("..", ",", 1).replacen(':', ",", 1);
        let parts: Vec<&str> = by_commas.split(',').map(str::trim).collect();
        let (&[from, to] | &[from, to, _]) = &parts[..] else { return Err(expected()) };
        let number = |part: &str| part.parse::<f64>().ok().filter(|value| *value > 0.0 && *value < 1e50);
        let (Some(from), Some(to)) = (number(from), number(to)) else { return Err(expected()) };
        let count = match parts.get(2) {
            Some(part) => {
                part.parse().ok().filter(|count| (2..=MOST).contains(count)).ok_or_else(expected)?
            }
            None => 0,
        };
        match from < to {
            true => Ok(SpectrumSteps { from, to, count }),
            false => {
                let why = if from > to { "is above" } else { "is the same as" };
                Err(format!(
                    "{text}: FROM, {from}, {why} TO, {to}; expected FROM,TO or FROM,TO,COUNT with 0 < FROM < TO"
                ))
            }
        }
    }
}

/// Values of a quantity: by equal steps, or by equal factors where that is how they are read, or as they are.
#[derive(Debug, Clone, PartialEq)]
pub enum SpectrumValues {
    /// From one to another.
    Steps(SpectrumSteps),
    /// These, rising and above zero.
    These(Vec<f64>),
}

impl From<SpectrumSteps> for SpectrumValues {
    fn from(steps: SpectrumSteps) -> SpectrumValues {
        SpectrumValues::Steps(steps)
    }
}

impl SpectrumValues {
    /// Values one by one.
    ///
    /// # Errors
    /// In words what is wrong with the first, if they do not rise from above zero, or are fewer than two.
    pub fn these(values: Vec<f64>) -> Result<SpectrumValues, String> {
        if !(2..=MOST).contains(&values.len()) {
            let count =
                if values.len() == 1 { "one value".to_owned() } else { format!("{} values", values.len()) };
            return Err(format!("{count}; expected two or more, {MOST} at most"));
        }
        let is_above = |(i, value): (usize, &f64)| *value > if i == 0 { 0.0 } else { values[i - 1] };
        match values.iter().enumerate().find(|at| !is_above(*at) || *at.1 >= 1e50) {
            None => Ok(SpectrumValues::These(values)),
            Some((i, value)) => {
                Err(format!("{} at index {i}; expected rising values, all above zero", exact(*value)))
            }
        }
    }
}

/// Kind of spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpectrumKind {
    /// Uniform blocks over size and slenderness.
    Rocking,
    /// A block that can only slide, over its yield acceleration.
    Newmark,
    /// The body of the case, over the strength of the shaking.
    Overturning,
}

impl SpectrumKind {
    /// Each with its word.
    pub const ALL: [(&'static str, SpectrumKind); 3] = [
        ("rocking", SpectrumKind::Rocking),
        ("newmark", SpectrumKind::Newmark),
        ("overturning", SpectrumKind::Overturning),
    ];

    /// The word.
    pub fn word(self) -> &'static str {
        SpectrumKind::ALL.into_iter().find(|(_, kind)| *kind == self).map_or("", |(word, _)| word)
    }
}

impl FromStr for SpectrumKind {
    type Err = String;

    fn from_str(text: &str) -> Result<SpectrumKind, String> {
        let words = SpectrumKind::ALL.map(|(word, _)| word);
        SpectrumKind::ALL.into_iter().find(|(word, _)| *word == text).map(|(_, kind)| kind).ok_or_else(|| {
            let like =
                closest(text, words).map_or_else(String::new, |like| format!("; did you mean {like}?"));
            format!("expected {}{like}", words.join(", "))
        })
    }
}

/// Request for a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumRequest {
    /// Kind of the spectrum.
    pub kind: SpectrumKind,
    /// The half diagonals of a rocking spectrum; from a quarter of that of the case to its eightfold if left out.
    pub size: Option<SpectrumValues>,
    /// The slendernesses of a rocking spectrum, heights over widths; 2 to 8 if left out.
    pub slenderness: Option<SpectrumValues>,
    /// The yield accelerations over the peak of a Newmark spectrum; 0.02 to 0.98 if left out.
    pub ratio: Option<SpectrumValues>,
    /// The factors on the shaking of an overturning curve; 0.05 to 5 if left out.
    pub scale: Option<SpectrumValues>,
    /// True if the edges between classes of a rocking spectrum are located, for its figure; it takes at most half as many motions again.
    pub edges: bool,
    /// Number of threads that work; the answer does not depend on it.
    pub threads: usize,
}

impl SpectrumRequest {
    /// A spectrum with everything else left out, with its edges, on one thread.
    pub fn new(kind: SpectrumKind) -> SpectrumRequest {
        let (size, slenderness, ratio, scale) = (None, None, None, None);
        SpectrumRequest { kind, size, slenderness, ratio, scale, edges: true, threads: 1 }
    }
}

/// Reason why there is no spectrum of a case.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// The base does not move.
    #[error(
        "a spectrum is of bodies on a base that moves, and the case has no [motion.base] with `horizontal`"
    )]
    NoShaking,
    /// An option that belongs to another kind.
    #[error("{option} does not belong to the {kind} spectrum; it has {has}")]
    Foreign {
        /// The option given.
        option: &'static str,
        /// The kind.
        kind: &'static str,
        /// Options of that kind.
        has: &'static str,
    },
    /// Loads that belong to the one body of the case.
    #[error(
        "a rocking spectrum is of blocks of many sizes under the shaking alone, and the case has loads beside its weight"
    )]
    Loads,
    /// The motion begins other than at rest.
    #[error("a rocking spectrum is of blocks that stand at first, and the case has [motion.initial]")]
    Initial,
    /// Motions that would be left before the shaking ends.
    #[error(
        "`t_max` is {}, and the shaking goes on to {}: whether the body overturns later is not known", exact(*.t_max), exact(*.end)
    )]
    CutShort {
        /// The time up to which motions are followed.
        t_max: f64,
        /// The time at which the shaking ends.
        end: f64,
    },
    /// Too many motions.
    #[error("{count} motions are asked for; expected {MOST} at most")]
    Many {
        /// Number of motions.
        count: usize,
    },
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A motion that is refused.
    #[error("at {name} {}: {error}", exact(*.value))]
    Motion {
        /// The quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The error of the motion.
        error: MotionError,
    },
}

/// A spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Its kind.
    pub kind: SpectrumKind,
    /// The title of the case.
    pub title: Option<String>,
    /// True if it is in SI units.
    pub si: bool,
    /// g of the case.
    pub gravity: f64,
    /// The largest |acceleration| of the base to the sides.
    pub peak: f64,
    /// The points.
    pub points: SpectrumPoints,
    /// Warnings of possible slips, and of values outside the range of the model.
    pub warnings: Vec<MotionWarning>,
}

/// The largest |θ| over the angle of balance that parts a class of blocks from the next: does not rock, four of rotations up to that
/// angle, beyond it and back, overturns.
pub const ROCKING_LEVELS: [f64; 6] = [0.0, 0.1, 0.25, 0.5, 1.0, f64::MAX];

/// The largest |θ| over the angle of balance; of a block that overturned it has no bound.
fn rotation(block: &Rocked) -> f64 {
    if block.overturned { f64::INFINITY } else { block.of_balance }
}

/// Class of a block: the number of [`ROCKING_LEVELS`] that it exceeds.
pub fn rocking_class(block: &Rocked) -> usize {
    ROCKING_LEVELS.iter().filter(|level| rotation(block) > **level).count()
}

/// A distance in the plane of half diagonal and height over width, along one or the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RockingDistance {
    /// Factor on the half diagonal.
    pub factor: f64,
    /// Step of height over width.
    pub step: f64,
}

/// Areas of the plane of half diagonal and height over width in which blocks exceed a level.
#[derive(Debug, Clone, PartialEq)]
pub struct RockingEdges {
    /// Outlines of the area above each of [`ROCKING_LEVELS`], as (half diagonal, height over width); an outline in another is that of a
    /// hole.
    pub above: Vec<Vec<Vec<(f64, f64)>>>,
    /// Distance to which the edge of overturning is located.
    pub overturning: RockingDistance,
    /// Distance to which the other edges are.
    pub others: RockingDistance,
    /// Number of motions that it took, beside those of the blocks.
    pub motions: usize,
}

/// The points of a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub enum SpectrumPoints {
    /// Size by size, for every slenderness.
    Rocking {
        /// Half diagonals.
        sizes: Vec<f64>,
        /// Heights over widths.
        slendernesses: Vec<f64>,
        /// The blocks, size by size.
        blocks: Vec<Rocked>,
        /// Areas of their classes, if asked for.
        edges: Option<RockingEdges>,
    },
    /// Over the yield ratio.
    Newmark {
        /// Yield accelerations over the peak.
        ratios: Vec<f64>,
        /// Slides of the block.
        slides: Vec<Slid>,
    },
    /// Over the strength of the shaking.
    Overturning {
        /// Factors.
        scales: Vec<f64>,
        /// Motions of the body.
        bodies: Vec<Rocked>,
        /// The stretches of factors at which it overturns; there may be narrower ones between the factors.
        stretches: Vec<[f64; 2]>,
    },
}

impl Spectrum {
    /// Finds a spectrum of a case, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// If the case has no such spectrum, a motion is refused, or the work is stopped.
    pub fn of(
        case: &BlockCase,
        request: &SpectrumRequest,
        portion: Portion<'_>,
    ) -> Result<Spectrum, SpectrumError> {
        let Some(base) = &case.problem.base.horizontal else { return Err(SpectrumError::NoShaking) };
        foreign(request)?;
        let points = match request.kind {
            SpectrumKind::Rocking => rocking(case, request, portion)?,
            SpectrumKind::Newmark => {
                let ratios = values(
                    &request.ratio,
                    SpectrumSteps { from: 0.02, to: 0.98, count: 49 },
                    SpectrumSteps::even,
                );
                let spectrum = NewmarkSpectrum::new(base.clone());
                let at = |ratio: &f64| spectrum.at(*ratio);
                let slides = each(&ratios, request.threads, portion, "yield ratio", |ratio| *ratio, at)?;
                SpectrumPoints::Newmark { ratios, slides }
            }
            SpectrumKind::Overturning => overturning(case, request, portion)?,
        };
        Ok(Spectrum {
            kind: request.kind,
            title: case.title.clone(),
            si: case.si,
            gravity: case.problem.gravity,
            peak: base.peak(),
            points,
            warnings: case.warnings.clone(),
        })
    }
}

fn rocking(
    case: &BlockCase,
    request: &SpectrumRequest,
    portion: Portion<'_>,
) -> Result<SpectrumPoints, SpectrumError> {
    let problem = &case.problem;
    if !problem.loads.is_empty() {
        return Err(SpectrumError::Loads);
    }
    if problem.initial != standfast_motion::Initial::default() {
        return Err(SpectrumError::Initial);
    }
    let block = &problem.block;
    let radius = block.b1.max(block.b2).hypot(block.d);
    let of_sizes = SpectrumSteps { from: 0.25 * radius, to: 8.0 * radius, count: 41 };
    let sizes = values(&request.size, of_sizes, SpectrumSteps::factors);
    let of_slendernesses = SpectrumSteps { from: 2.0, to: 8.0, count: 31 };
    let slendernesses = values(&request.slenderness, of_slendernesses, SpectrumSteps::even);
    let count = sizes.len().saturating_mul(slendernesses.len());
    if count > MOST {
        return Err(SpectrumError::Many { count });
    }
    let spectrum = RockingSpectrum {
        friction: [block.mu_s, block.mu_k],
        gravity: problem.gravity,
        base: problem.base.clone(),
        impact: problem.impact,
        restitution: problem.restitution,
    };
    let pairs: Vec<[f64; 2]> =
        sizes.iter().flat_map(|size| slendernesses.iter().map(move |slender| [*size, *slender])).collect();
    let [of_grid, of_edges] = portion.parts([1.0, if request.edges { 0.5 } else { 0.0 }]);
    let follow = |pairs: &[[f64; 2]], portion: Portion<'_>| {
        let at = |[size, slender]: &[f64; 2]| spectrum.at(*size, *slender);
        each(pairs, request.threads, portion, "size", |[size, _]| *size, at)
    };
    let blocks = follow(&pairs, of_grid)?;
    let edges =
        request.edges.then(|| edges([&sizes, &slendernesses], &blocks, of_edges, follow)).transpose()?;
    portion.reached(1.0);
    Ok(SpectrumPoints::Rocking { sizes, slendernesses, blocks, edges })
}

/// Areas of the classes between and beside the blocks of a grid.
fn edges(
    [sizes, slendernesses]: [&[f64]; 2],
    blocks: &[Rocked],
    portion: Portion<'_>,
    follow: impl Fn(&[[f64; 2]], Portion<'_>) -> Result<Vec<Rocked>, SpectrumError>,
) -> Result<RockingEdges, SpectrumError> {
    // Between two lines of the grid sizes grow by factors, and slendernesses by steps.
    let between = |values: &[f64], cells: f64| {
        let line = (cells.max(0.0) as usize).min(values.len() - 2);
        (values[line], values[line + 1], cells - line as f64)
    };
    let size = |cells: f64| {
        let (low, high, share) = between(sizes, cells);
        low * (high / low).powf(share)
    };
    let slender = |cells: f64| {
        let (low, high, share) = between(slendernesses, cells);
        low + (high - low) * share
    };
    let values: Vec<f64> = blocks.iter().map(rotation).collect();
    let budget = blocks.len() / 2;
    let mut motions = 0;
    let ask = |places: &[areas::Place]| {
        let rest = budget.saturating_sub(motions + places.len());
        let [_, now, _] = portion.parts([motions, places.len(), rest].map(|count| count as f64));
        motions += places.len();
        let place = |(x, y): &areas::Place| areas::cells((f64::from(*x), f64::from(*y)));
        let pairs: Vec<[f64; 2]> = places.iter().map(place).map(|(x, y)| [size(x), slender(y)]).collect();
        Ok::<_, SpectrumError>(follow(&pairs, now)?.iter().map(rotation).collect())
    };
    let grid = (sizes.len(), slendernesses.len());
    let found = areas::areas(grid, &values, &ROCKING_LEVELS, budget, ask)?;
    let place = |place: &(f64, f64)| {
        let (x, y) = areas::cells(*place);
        (size(x), slender(y))
    };
    let outlines =
        |loops: &Vec<areas::Loop>| loops.iter().map(|each| each.iter().map(place).collect()).collect();
    let widest = sizes.windows(2).map(|pair| pair[1] / pair[0]).fold(1.0, f64::max);
    let highest = slendernesses.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    let [overturning, others] =
        found.located.map(|cells| RockingDistance { factor: widest.powf(cells), step: highest * cells });
    Ok(RockingEdges { above: found.above.iter().map(outlines).collect(), overturning, others, motions })
}

fn overturning(
    case: &BlockCase,
    request: &SpectrumRequest,
    portion: Portion<'_>,
) -> Result<SpectrumPoints, SpectrumError> {
    let of_scales = SpectrumSteps { from: 0.05, to: 5.0, count: 199 };
    let mut scales = values(&request.scale, of_scales, SpectrumSteps::even);
    if let Some((t_max, end)) = case.problem.cut_short() {
        return Err(SpectrumError::CutShort { t_max, end });
    }
    let curve = OverturningCurve::new(&case.problem);
    // A turn is halved some fifty times, and a curve has a few.
    let [of_scan, of_more, of_turns] = portion.parts([scales.len() as f64, 300.0, 200.0]);
    let follow = |scales: &[f64], portion| {
        each(scales, request.threads, portion, "scale", |scale| *scale, |scale| curve.at(*scale))
    };
    let mut bodies = follow(&scales, of_scan)?;
    // Where nobody says at which factors, they are nearer to each other from a little below the first that overturns the body: a stretch
    // that is missed there is the least.
    let mut more = if request.scale.is_none() { finer(&scales, &bodies) } else { Vec::new() };
    let mut to_come = of_more;
    while !more.is_empty() {
        let [now, after] = to_come.parts([3.0, 1.0]);
        to_come = after;
        let mut all: Vec<_> = scales.into_iter().zip(bodies).collect();
        all.extend(more.iter().copied().zip(follow(&more, now)?));
        all.sort_by(|(one, _), (two, _)| one.total_cmp(two));
        (scales, bodies) = all.into_iter().unzip();
        more = finer(&scales, &bodies);
    }
    let scan: Vec<(f64, bool)> =
        scales.iter().zip(&bodies).map(|(scale, body)| (*scale, body.overturned)).collect();
    let turns: Vec<[f64; 2]> =
        scan.windows(2).filter(|pair| pair[0].1 != pair[1].1).map(|pair| [pair[0].0, pair[1].0]).collect();
    let at = |[from, to]: &[f64; 2]| curve.turn(*from, *to);
    let found = each(&turns, request.threads, of_turns, "scale", |[from, _]| *from, at)?;
    let turn = |from: f64, to: f64| {
        let known = turns.iter().position(|[low, high]| (*low, *high) == (from, to));
        known.map_or(from, |i| found[i])
    };
    let stretches = overturning_stretches(&scan, turn);
    Ok(SpectrumPoints::Overturning { scales, bodies, stretches })
}

/// Distance of two factors from [`OVERTURNING_FROM`] of the least that overturns the body on, as a share of the factor.
const NEAR: f64 = 0.005;
/// The share of the least factor that overturns the body from which on factors are near to each other.
pub const OVERTURNING_FROM: f64 = 0.8;

/// Factors that part every step above [`OVERTURNING_FROM`] of the least that overturns the body into steps no longer than [`NEAR`].
fn finer(scales: &[f64], bodies: &[Rocked]) -> Vec<f64> {
    let least = scales.iter().zip(bodies).find(|(_, body)| body.overturned);
    let from = least.map_or(f64::INFINITY, |(scale, _)| OVERTURNING_FROM * scale);
    let steps = scales.windows(2).filter(|pair| pair[1] > from);
    steps
        .flat_map(|pair| {
            let (low, step) = (pair[0], pair[1] - pair[0]);
            // By rounding a part may be longer than it should be.
            let parts = (step / (NEAR * low) - 1e-9).ceil().max(1.0) as u32;
            (1..parts).map(move |part| low + step * f64::from(part) / f64::from(parts))
        })
        .collect()
}

/// The values given, or those where nothing is said; of steps, `parted`, as many as there if their number is left out.
fn values(
    given: &Option<SpectrumValues>,
    silent: SpectrumSteps,
    parted: fn(&SpectrumSteps) -> Vec<f64>,
) -> Vec<f64> {
    match given {
        None => parted(&silent),
        Some(SpectrumValues::These(values)) => values.clone(),
        Some(SpectrumValues::Steps(steps)) => {
            let count = if steps.count == 0 { silent.count } else { steps.count };
            parted(&SpectrumSteps { count, ..*steps })
        }
    }
}

/// Refuses an option that does not belong to the kind.
fn foreign(request: &SpectrumRequest) -> Result<(), SpectrumError> {
    let SpectrumRequest { kind, size, slenderness, ratio, scale, .. } = request;
    let given = [
        ("--size", size.is_some(), SpectrumKind::Rocking),
        ("--slenderness", slenderness.is_some(), SpectrumKind::Rocking),
        ("--ratio", ratio.is_some(), SpectrumKind::Newmark),
        ("--scale", scale.is_some(), SpectrumKind::Overturning),
    ];
    let has = match kind {
        SpectrumKind::Rocking => "--size and --slenderness",
        SpectrumKind::Newmark => "--ratio",
        SpectrumKind::Overturning => "--scale",
    };
    match given.into_iter().find(|(_, given, of)| *given && of != kind) {
        Some((option, ..)) => Err(SpectrumError::Foreign { option, kind: kind.word(), has }),
        None => Ok(()),
    }
}

/// The motion of every item, on so many threads; the first error in the order of the items, with the value of `name` at which it is.
fn each<I: Sync, T: Send>(
    items: &[I],
    threads: usize,
    portion: Portion<'_>,
    name: &'static str,
    value: impl Fn(&I) -> f64,
    work: impl Fn(&I) -> Result<T, MotionError> + Sync,
) -> Result<Vec<T>, SpectrumError> {
    let all = in_order(items, threads, portion, work)?.into_iter().zip(items);
    let refused = |item, error| SpectrumError::Motion { name, value: value(item), error };
    all.map(|(result, item)| result.map_err(|error| refused(item, error))).collect()
}

/// The work on every item, in their order, on so many threads.
///
/// # Errors
/// If the portion is stopped.
pub fn in_order<I: Sync, T: Send>(
    items: &[I],
    threads: usize,
    portion: Portion<'_>,
    work: impl Fn(&I) -> T + Sync,
) -> Result<Vec<T>, Stopped> {
    let steps = portion.steps(items.len());
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(i).filter(|_| !portion.is_stopped()) else { return done };
            done.push((i, work(item)));
            steps.advance();
        }
    };
    let mut all: Vec<(usize, T)> = if threads <= 1 {
        worker()
    } else {
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..threads.min(items.len())).map(|_| scope.spawn(worker)).collect();
            workers
                .into_iter()
                .flat_map(|worker| worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
                .collect()
        })
    };
    if all.len() < items.len() {
        return Err(Stopped);
    }
    portion.reached(1.0);
    all.sort_by_key(|(i, _)| *i);
    Ok(all.into_iter().map(|(_, result)| result).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stretch that a coarse step leaps over below the first factor that overturns is the least: there the steps are as fine.
    #[test]
    fn factors_are_near_from_a_little_below_the_first_that_overturns() {
        let islands = [(2.02, 2.033), (2.4, 3.0)];
        let body = |scale: &f64| Rocked {
            max_theta: 0.0,
            of_balance: 0.0,
            max_slide: 0.0,
            overturned: islands.iter().any(|(from, to)| (from..=to).contains(&scale)),
            impacts: 0,
            end: standfast_motion::End::Time,
        };
        let mut scales = SpectrumSteps { from: 0.05, to: 5.0, count: 100 }.even();
        let first = |scales: &[f64]| scales.iter().copied().find(|scale| body(scale).overturned);
        assert_eq!(first(&scales), Some(2.4), "the coarse ones leap over the lower stretch");
        loop {
            let more = finer(&scales, &scales.iter().map(body).collect::<Vec<_>>());
            if more.is_empty() {
                break;
            }
            scales.extend(more);
            scales.sort_by(f64::total_cmp);
        }
        let least = first(&scales).unwrap();
        assert!((2.02..2.033).contains(&least), "{least}");
        for pair in scales.windows(2).filter(|pair| pair[1] > OVERTURNING_FROM * least) {
            assert!(pair[1] / pair[0] <= 1.005 + 1e-9, "{pair:?}");
        }
    }

    #[test]
    fn values_rise_from_above_zero() {
        assert_eq!(SpectrumValues::these(vec![0.5, 2.0]), Ok(SpectrumValues::These(vec![0.5, 2.0])));
        for (wrong, at) in [
            (vec![0.0, 1.0], "0 at index 0"),
            (vec![1.0, 3.0, 2.0], "2 at index 2"),
            (vec![1.0, 1.0], "1 at index 1"),
            (vec![1.0, f64::NAN], "NaN at index 1"),
            (vec![1.0, f64::INFINITY], "inf at index 1"),
            (vec![1.0], "one value; expected two or more"),
        ] {
            assert!(SpectrumValues::these(wrong.clone()).unwrap_err().starts_with(at), "{wrong:?}");
        }
    }

    #[test]
    fn steps_are_read_or_refused_with_what_is_expected() {
        assert_eq!("0.5, 2,4".parse(), Ok(SpectrumSteps { from: 0.5, to: 2.0, count: 4 }));
        assert_eq!(SpectrumSteps { from: 0.5, to: 2.0, count: 3 }.factors(), [0.5, 1.0, 2.0]);
        assert_eq!(SpectrumSteps { from: 0.5, to: 2.0, count: 4 }.even(), [0.5, 1.0, 1.5, 2.0]);
        for wrong in ["", "1", "2,1", "1,2,1", "0,2", "1,nan", "1,2,3,4", "1,inf"] {
            assert!(wrong.parse::<SpectrumSteps>().unwrap_err().contains("expected FROM,TO"), "{wrong}");
        }
    }
}
