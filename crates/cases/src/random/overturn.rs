//! Overturning by records and random bodies: the same bodies under a shaking scaled to each of many peaks.
//!
//! ```toml
//! [motion.base]
//! horizontal = { shape = "file", file = "one.smc" }
//!
//! [random]
//! records = ["one.smc", "two.smc"]      # if there are several, each as likely; scaled to the peak that is asked for
//! friction = { normal = { sd = 0.05 } }
//! ```
//!
//! Body i is drawn once and followed in time under record i, in turn, at every peak; a vertical component of the case is scaled as its
//! horizontal one. What becomes of it is that of `simulate`. The chance of overturning has the interval of Clopper and Pearson, and a
//! lognormal curve is fitted as to any fragility.

use standfast_motion::record::Record;
use standfast_motion::spectrum::{OverturningCurve, Rocked};
use standfast_motion::{Base, Problem as Motion};
use standfast_probability::sample::{self, Estimate};

use super::answer::{Probability, Request};
use super::asked::problems_of;
use super::error::ProbabilityError;
use super::over::{Fit, Over};
use super::problem::{Input, Problem};
use crate::case::{Acting, Case};
use crate::key::Table;
use crate::layout::paragraph;
use crate::motion::{ReadFile, block, body_cases, still_case};
use crate::parse::CaseFile;
use crate::units::{Dimension, in_gravity};

/// How many bodies are drawn where the points of an effort allow it.
const BODIES: u64 = 256;

/// What becomes of random bodies at each peak of the shaking.
#[derive(Debug, Clone, PartialEq)]
pub struct Overturning {
    /// The records, by their files; that of the case is called by its place.
    pub records: Vec<String>,
    /// How many bodies were drawn, each under one of the records.
    pub bodies: u64,
    /// How many draws were no body: those are counted as standing.
    pub not_a_body: u64,
    /// At each peak, rising.
    pub points: Vec<AtPeak>,
    /// A lognormal curve through the chances of overturning.
    pub fit: Option<Fit>,
    /// g of the case, m/s².
    pub gravity: f64,
}

/// What becomes of random bodies at one peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtPeak {
    /// The largest |acceleration| of the base to the sides, m/s².
    pub peak: f64,
    /// That the body slips or turns at all.
    pub moved: Estimate,
    /// That it turns.
    pub rocked: Estimate,
    /// That it overturns.
    pub overturned: Estimate,
}

impl Overturning {
    /// Follows the bodies of a case in time. `text` is that of the case, `still` the same at the first instant, `file` reads records.
    ///
    /// # Errors
    /// If the base does not move, the case has loads beside its weight, or a motion is refused.
    pub fn of(
        name: &str,
        text: &str,
        still: &str,
        request: &Request,
        over: &Over,
        file: &ReadFile<'_>,
    ) -> Result<Overturning, ProbabilityError> {
        let wrong = |what: &str| over.wrong(what);
        let case_file = CaseFile::parse(name, still)?;
        let problem = &problems_of(&case_file, None)?[0];
        let shaken = |input: &Input| {
            input.variable().is_some_and(|variable| variable.id().key.info().table == Table::Earthquake)
        };
        if problem.random().iter().any(shaken) {
            return Err(wrong("the peak of the shaking is random itself"));
        }
        let motions = body_cases(name, text, file)?;
        let [motion] = &motions[..] else { return Err(wrong("the case has loads that act one by one")) };
        let motion = &motion.problem;
        let Some(own) = &motion.base.horizontal else {
            return Err(wrong("the base does not move to the sides; [motion.base] has no `horizontal`"));
        };
        if !motion.loads.is_empty() {
            return Err(wrong("the case has loads beside its weight, and a shaking alone is followed"));
        }
        let random = case_file.random().ok_or(ProbabilityError::NoRandom)?;
        if !random.records.is_empty() && motion.base.vertical.is_some() {
            return Err(wrong("[random] has `records` and the base moves up and down, by another record"));
        }
        let mut bases = Vec::new();
        for record in &random.records {
            let text = file(record).map_err(|why| over.wrong(format!("cannot read {record}: {why}")))?;
            let record = Record::parse(record, &text, None, None);
            let record = record.map_err(|error| over.wrong(error.to_string()))?;
            let history = record.history(1.0).map_err(|error| over.wrong(error.to_string()))?;
            bases.push(Base { horizontal: Some(history), vertical: None });
        }
        let records =
            if bases.is_empty() { vec!["that of the case".to_owned()] } else { random.records.clone() };
        if bases.is_empty() {
            bases.push(Base { horizontal: Some(own.clone()), vertical: motion.base.vertical.clone() });
        }
        let gravity = motion.gravity;
        let peaks = over.values(|text| peak(text, gravity))?;
        let bodies = BODIES.min(request.effort.points / peaks.len() as u64).max(bases.len() as u64);
        let mut drawn: Vec<Option<Motion>> = Vec::new();
        sample::draws(problem.laws(), request.effort.seed, bodies, |values| {
            let base = &bases[drawn.len() % bases.len()];
            drawn.push(body(problem, motion, values, base));
        });
        let followed = follow(&drawn, &peaks, request.effort.threads)
            .map_err(|error| over.wrong(format!("a body cannot be followed: {error}")))?;
        let chance = |at: &[Option<Rocked>], holds: &dyn Fn(&Rocked) -> bool| {
            let hits = at.iter().flatten().filter(|rocked| holds(rocked)).count();
            Estimate::of_hits(hits as u64, bodies)
        };
        let points: Vec<AtPeak> = peaks
            .iter()
            .zip(&followed)
            .map(|(peak, at)| AtPeak {
                peak: *peak,
                moved: chance(at, &|rocked| rocked.max_theta > 0.0 || rocked.max_slide > 0.0),
                rocked: chance(at, &|rocked| rocked.max_theta > 0.0),
                overturned: chance(at, &|rocked| rocked.overturned),
            })
            .collect();
        let told: Vec<(f64, f64)> = points.iter().map(|at| (at.peak, at.overturned.value)).collect();
        let not_a_body = drawn.iter().filter(|motion| motion.is_none()).count() as u64;
        Ok(Overturning { records, bodies, not_a_body, points, fit: Fit::of(&told), gravity })
    }
}

/// A peak as it is written: a number is a share of g, as under [earthquake].
fn peak(text: &str, gravity: f64) -> Result<f64, String> {
    let share = text.parse::<f64>().ok().or_else(|| in_gravity(text)).map(|share| share * gravity);
    let value = share.or_else(|| Dimension::Acceleration.parse(text).ok());
    value
        .filter(|value| *value > 0.0 && value.is_finite())
        .ok_or_else(|| format!("\"{text}\" is no peak above zero, as 0.2, \"0.2 g\" or \"2 m/s2\""))
}

/// The body that values make, on a base that moves so; none if they do not go together.
fn body(problem: &Problem, motion: &Motion, values: &[f64], base: &Base) -> Option<Motion> {
    let case: Case = problem.case_with(values)?;
    let situation = case.situation(Acting::All, None).ok()?;
    let mut own = Motion { block: block(situation.body(), &situation), base: base.clone(), ..motion.clone() };
    if let Some(place) = problem.random().iter().position(Input::is_friction) {
        let ratio = if own.block.mu_s > 0.0 { own.block.mu_k / own.block.mu_s } else { 1.0 };
        (own.block.mu_s, own.block.mu_k) = (values[place], values[place] * ratio);
    }
    own.check().ok()?;
    Some(own)
}

/// Every body at every peak, shared out to threads.
fn follow(
    bodies: &[Option<Motion>],
    peaks: &[f64],
    threads: usize,
) -> Result<Vec<Vec<Option<Rocked>>>, standfast_motion::MotionError> {
    let own_peak =
        |motion: &Motion| motion.base.horizontal.as_ref().map_or(1.0, |history| history.peak().abs());
    let at = |motion: &Option<Motion>, peak: f64| {
        let Some(motion) = motion else { return Ok(None) };
        OverturningCurve::new(motion).at(peak / own_peak(motion)).map(Some)
    };
    let all: Vec<(usize, usize)> =
        (0..peaks.len()).flat_map(|peak| (0..bodies.len()).map(move |body| (peak, body))).collect();
    let share = all.len().div_ceil(threads.max(1)).max(1);
    let at = &at;
    let parts: Vec<Result<Vec<_>, _>> = std::thread::scope(|scope| {
        let work = all.chunks(share).map(|part| {
            scope.spawn(move || part.iter().map(|&(peak, body)| at(&bodies[body], peaks[peak])).collect())
        });
        let work: Vec<_> = work.collect();
        work.into_iter().map(|thread| thread.join().expect("no motion panics")).collect()
    });
    let mut found = Vec::with_capacity(all.len());
    for part in parts {
        found.extend(part?);
    }
    Ok(found.chunks(bodies.len()).map(<[_]>::to_vec).collect())
}

/// The answer to a file that may say how its loads go with time, which is asked at the first instant, as `assess` asks it; over the peak of
/// its shaking the bodies are followed.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstInstant {
    /// The answer.
    pub answer: Probability,
    /// The text of the case at the first instant.
    pub still: String,
    /// That it is of the first instant, in a sentence; none of a case that says nothing of time.
    pub note: Option<String>,
}

impl FirstInstant {
    /// Answers a file; `file` reads the records that it names.
    ///
    /// # Errors
    /// As [`Probability::along`] and [`Overturning::of`].
    pub fn of(
        name: &str,
        text: &str,
        request: Request,
        over: Option<&Over>,
        file: &ReadFile<'_>,
    ) -> Result<FirstInstant, ProbabilityError> {
        let (still, note) = match still_case(name, text, file)? {
            Some((still, note)) => (still, Some(note)),
            None => (text.to_owned(), None),
        };
        let of_peak = over.filter(|over| note.is_some() && over.is_of_peak());
        let mut answer = Probability::along(name, &still, request, over.filter(|_| of_peak.is_none()))?;
        if let Some(over) = of_peak {
            answer.overturning = Some(Overturning::of(name, text, &still, &request, over, file)?);
        }
        Ok(FirstInstant { answer, still, note })
    }

    /// The answer for reading.
    pub fn text(&self) -> String {
        let note = self.note.as_ref().map(|note| format!("\n{}", paragraph(&format!("Note: {note}."), 0)));
        self.answer.text() + &note.unwrap_or_default()
    }
}
