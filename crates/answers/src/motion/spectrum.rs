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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumRequest {
    /// Kind of the spectrum.
    pub kind: SpectrumKind,
    /// The half diagonals of a rocking spectrum; from a quarter of that of the case to its eightfold if left out.
    pub size: Option<SpectrumSteps>,
    /// The slendernesses of a rocking spectrum, heights over widths; 2 to 8 if left out.
    pub slenderness: Option<SpectrumSteps>,
    /// The yield accelerations over the peak of a Newmark spectrum; 0.02 to 0.98 if left out.
    pub ratio: Option<SpectrumSteps>,
    /// The factors on the shaking of an overturning curve; 0.05 to 5 if left out.
    pub scale: Option<SpectrumSteps>,
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
    /// Finds a spectrum of a case; `progress` is told how many motions there are, and of each that is done.
    ///
    /// # Errors
    /// If the case has no such spectrum, or a motion is refused.
    pub fn of(
        case: &BlockCase,
        request: &SpectrumRequest,
        progress: &(dyn Fn(Progressed) + Sync),
    ) -> Result<Spectrum, SpectrumError> {
        let Some(base) = &case.problem.base.horizontal else { return Err(SpectrumError::NoShaking) };
        foreign(request)?;
        let points = match request.kind {
            SpectrumKind::Rocking => rocking(case, request, progress)?,
            SpectrumKind::Newmark => {
                let ratios = steps(request.ratio, SpectrumSteps { from: 0.02, to: 0.98, count: 49 }).even();
                let spectrum = NewmarkSpectrum::new(base.clone());
                let slides = each(&ratios, request.threads, progress, |ratio| spectrum.at(*ratio)).map_err(
                    |(ratio, error)| SpectrumError::Motion { name: "yield ratio", value: *ratio, error },
                )?;
                SpectrumPoints::Newmark { ratios, slides }
            }
            SpectrumKind::Overturning => overturning(case, request, progress)?,
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
    progress: &(dyn Fn(Progressed) + Sync),
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
    let sizes =
        steps(request.size, SpectrumSteps { from: 0.25 * radius, to: 8.0 * radius, count: 41 }).factors();
    let slendernesses = steps(request.slenderness, SpectrumSteps { from: 2.0, to: 8.0, count: 31 }).even();
    let count = sizes.len().saturating_mul(slendernesses.len());
    if count > MOST {
        return Err(SpectrumError::Many { count });
    }
    let spectrum = RockingSpectrum {
        friction: [block.mu_s, block.mu_k],
        gravity: problem.gravity,
        base: problem.base.clone(),
        impact: problem.impact,
    };
    let pairs: Vec<[f64; 2]> =
        sizes.iter().flat_map(|size| slendernesses.iter().map(move |slender| [*size, *slender])).collect();
    let follow = |pairs: &[[f64; 2]]| {
        each(pairs, request.threads, progress, |[size, slender]| spectrum.at(*size, *slender))
            .map_err(|([size, _], error)| SpectrumError::Motion { name: "size", value: *size, error })
    };
    let blocks = follow(&pairs)?;
    let edges = request.edges.then(|| edges(&sizes, &slendernesses, &blocks, follow)).transpose()?;
    Ok(SpectrumPoints::Rocking { sizes, slendernesses, blocks, edges })
}

/// Areas of the classes between and beside the blocks of a grid.
fn edges(
    sizes: &[f64],
    slendernesses: &[f64],
    blocks: &[Rocked],
    mut follow: impl FnMut(&[[f64; 2]]) -> Result<Vec<Rocked>, SpectrumError>,
) -> Result<RockingEdges, SpectrumError> {
    // The grid's lines are at equal factors and at equal steps.
    let share = |values: &[f64], cells: f64| cells / (values.len() - 1) as f64;
    let (first, last) = (sizes[0], sizes[sizes.len() - 1]);
    let (low, high) = (slendernesses[0], slendernesses[slendernesses.len() - 1]);
    let size = |cells: f64| first * (last / first).powf(share(sizes, cells));
    let slender = |cells: f64| low + (high - low) * share(slendernesses, cells);
    let values: Vec<f64> = blocks.iter().map(rotation).collect();
    let mut motions = 0;
    let ask = |places: &[areas::Place]| {
        motions += places.len();
        let place = |(x, y): &areas::Place| areas::cells((f64::from(*x), f64::from(*y)));
        let pairs: Vec<[f64; 2]> = places.iter().map(place).map(|(x, y)| [size(x), slender(y)]).collect();
        Ok(follow(&pairs)?.iter().map(rotation).collect())
    };
    let grid = (sizes.len(), slendernesses.len());
    let found = areas::areas(grid, &values, &ROCKING_LEVELS, blocks.len() / 2, ask)?;
    let place = |place: &(f64, f64)| {
        let (x, y) = areas::cells(*place);
        (size(x), slender(y))
    };
    let outlines =
        |loops: &Vec<areas::Loop>| loops.iter().map(|each| each.iter().map(place).collect()).collect();
    let [overturning, others] = found
        .located
        .map(|cells| RockingDistance { factor: size(cells) / first, step: slender(cells) - low });
    Ok(RockingEdges { above: found.above.iter().map(outlines).collect(), overturning, others, motions })
}

fn overturning(
    case: &BlockCase,
    request: &SpectrumRequest,
    progress: &(dyn Fn(Progressed) + Sync),
) -> Result<SpectrumPoints, SpectrumError> {
    let scales = steps(request.scale, SpectrumSteps { from: 0.05, to: 5.0, count: 199 }).even();
    if let Some((t_max, end)) = case.problem.cut_short() {
        return Err(SpectrumError::CutShort { t_max, end });
    }
    let curve = OverturningCurve::new(&case.problem);
    let at = |name, value: f64| move |error| SpectrumError::Motion { name, value, error };
    let bodies = each(&scales, request.threads, progress, |scale| curve.at(*scale))
        .map_err(|(scale, error)| at("scale", *scale)(error))?;
    let scan: Vec<(f64, bool)> =
        scales.iter().zip(&bodies).map(|(scale, body)| (*scale, body.overturned)).collect();
    let turns: Vec<[f64; 2]> =
        scan.windows(2).filter(|pair| pair[0].1 != pair[1].1).map(|pair| [pair[0].0, pair[1].0]).collect();
    let found = each(&turns, request.threads, progress, |[from, to]| curve.turn(*from, *to))
        .map_err(|([from, _], error)| at("scale", *from)(error))?;
    let turn = |from: f64, to: f64| {
        let known = turns.iter().position(|[low, high]| (*low, *high) == (from, to));
        known.map_or(from, |i| found[i])
    };
    let stretches = overturning_stretches(&scan, turn);
    Ok(SpectrumPoints::Overturning { scales, bodies, stretches })
}

/// Progress of a spectrum under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progressed {
    /// So many more motions are to be followed.
    Expect(usize),
    /// One is done.
    Done,
}

fn steps(given: Option<SpectrumSteps>, silent: SpectrumSteps) -> SpectrumSteps {
    given.map_or(silent, |steps| SpectrumSteps {
        count: if steps.count == 0 { silent.count } else { steps.count },
        ..steps
    })
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

/// The work on every item, on so many threads; the first error in the order of the items.
fn each<'a, I: Sync, T: Send>(
    items: &'a [I],
    threads: usize,
    progress: &(dyn Fn(Progressed) + Sync),
    work: impl Fn(&I) -> Result<T, MotionError> + Sync,
) -> Result<Vec<T>, (&'a I, MotionError)> {
    let all = in_order(items, threads, progress, work).into_iter().zip(items);
    all.map(|(result, item)| result.map_err(|error| (item, error))).collect()
}

/// The work on every item, in their order, on so many threads; `progress` is told of each.
pub fn in_order<I: Sync, T: Send>(
    items: &[I],
    threads: usize,
    progress: &(dyn Fn(Progressed) + Sync),
    work: impl Fn(&I) -> T + Sync,
) -> Vec<T> {
    progress(Progressed::Expect(items.len()));
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(i) else { return done };
            done.push((i, work(item)));
            progress(Progressed::Done);
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
    all.sort_by_key(|(i, _)| *i);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
