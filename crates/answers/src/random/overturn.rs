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
//! Every body that is drawn is followed in time under every record at every peak; a vertical component of the case is scaled as its
//! horizontal one. What becomes of it is that of `simulate`, under its weight and the permanent loads of the case. Records are few and
//! shared by all bodies, bodies by all records: the interval of a chance is that of a further record and body
//! ([`Estimate::of_pairs`]). A lognormal curve is fitted as to any fragility.

use standfast::Wrench;
use standfast::loads::{Load, LoadSource, Pose};
use standfast_motion::record::{Record, RecordUnit};
use standfast_motion::{
    BaseMotion, History, Keep, LoadInTime, MotionError, MotionProblem, is_own_weight, shaken_water, simulate,
};
use standfast_probability::sample::{self, Estimate};
use standfast_watch::Portion;

use super::answer::ChanceRequest;
use super::error::ProbabilityError;
use super::fragility::{Fit, ValueRange};
use super::problem::ChanceProblem;
use super::quantity::{Bias, FrictionOf, RandomInput};
use super::subject::problems_of;
use crate::case::{Acting, Trial};
use crate::key::Table;
use crate::motion::in_order;
use crate::units::{Dimension, in_gravity};
use standfast_inputs::random::RandomRecord;
use standfast_model::load_words;
use standfast_model::{CaseFile, GivenBase};

/// A motion takes a millisecond or two: it counts as so many points of an effort.
const POINTS: u64 = 1 << 10;
/// So many bodies are drawn however few points there may be.
const LEAST: u64 = 16;

/// Motions of random bodies at each peak of the shaking.
#[derive(Debug, Clone, PartialEq)]
pub struct Overturning {
    /// The records, by their files; that of the case is called by its place.
    pub records: Vec<String>,
    /// Number of bodies drawn, each followed under every record.
    pub bodies: u64,
    /// Number of draws that were no body: those are counted as standing.
    pub not_a_body: u64,
    /// At each peak, rising.
    pub points: Vec<PeakChances>,
    /// A lognormal curve through the chances of overturning.
    pub fit: Option<Fit>,
    /// g of the case, m/s².
    pub gravity: f64,
}

/// Outcome for random bodies at one peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakChances {
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
    /// Follows the bodies of a file in time.
    ///
    /// # Errors
    /// If the base does not move, the case has loads beside its weight, or a motion is refused.
    pub fn of(
        file: &CaseFile,
        request: &ChanceRequest,
        over: &ValueRange,
    ) -> Result<Overturning, ProbabilityError> {
        Overturning::under(file, request, over, &[], Portion::UNSEEN)
    }

    /// As [`of`](Overturning::of), under records that are given in place of those of the file, whose base moves as in one of them, as a portion
    /// of work that somebody may watch.
    ///
    /// # Errors
    /// As [`of`](Overturning::of); if the work is stopped.
    pub fn under(
        file: &CaseFile,
        request: &ChanceRequest,
        over: &ValueRange,
        given: &[GivenBase],
        portion: Portion<'_>,
    ) -> Result<Overturning, ProbabilityError> {
        let wrong = |what: &str| over.wrong(what);
        let random = file.random().ok_or(ProbabilityError::NoRandom)?;
        if random.named.iter().any(|named| named.name.starts_with(Table::Earthquake.name())) {
            return Err(wrong("the peak of the shaking is random itself"));
        }
        let problem = &problems_of(file, None, Some(file))?[0];
        varies_not(problem, over)?;
        let motions = file.motions()?;
        let [motion] = &motions[..] else { return Err(wrong("the case has loads that act one by one")) };
        let motion = &motion.problem;
        let Some(own) = &motion.base.horizontal else {
            return Err(wrong("the base does not move to the sides; [motion.base] has no `horizontal`"));
        };
        let own = BaseMotion { horizontal: Some(own.clone()), vertical: motion.base.vertical.clone() };
        let (records, bases) = match given {
            [] => of_file(file, own, over)?,
            given => of_given(file, given)?,
        };
        for (record, base) in records.iter().zip(&bases) {
            if let Some((t_max, end)) = (MotionProblem { base: base.clone(), ..motion.clone() }).cut_short() {
                return Err(over.wrong(format!(
                    "`t_max` is {t_max} s, and {record} goes on to {end} s: whether a body overturns later is not known"
                )));
            }
        }
        let gravity = motion.gravity;
        let peaks = over.values(|text| peak(text, gravity))?;
        if let Some(still) = bases.iter().position(|base| peak_of(base) == 0.0) {
            return Err(over.wrong(format!("the record {} has no acceleration", records[still])));
        }
        let motions = (bases.len() * peaks.len()) as u64;
        let bodies = (request.effort.points / POINTS / motions).max(LEAST);
        let mut drawn: Vec<Option<Body>> = Vec::new();
        sample::draws(problem.laws(), request.effort.seed, bodies, |values| {
            drawn.push(Body::of(problem, values));
        });
        let followed =
            follow(&drawn, &bases, &peaks, request.effort.threads, portion).map_err(|error| match error {
                MotionError::Stopped(stopped) => stopped.into(),
                error => over.wrong(format!("a body cannot be followed: {error}")),
            })?;
        let chance = |at: &[Vec<[bool; 3]>], which: usize| {
            let of_record = |bodies: &Vec<[bool; 3]>| bodies.iter().map(|became| became[which]).collect();
            Estimate::of_pairs(&at.iter().map(of_record).collect::<Vec<Vec<bool>>>())
        };
        let points: Vec<PeakChances> = peaks
            .iter()
            .zip(&followed)
            .map(|(peak, at)| PeakChances {
                peak: *peak,
                moved: chance(at, MOVED),
                rocked: chance(at, ROCKED),
                overturned: chance(at, OVERTURNED),
            })
            .collect();
        let told: Vec<(f64, f64)> = points.iter().map(|at| (at.peak, at.overturned.value)).collect();
        let not_a_body = drawn.iter().filter(|body| body.is_none()).count() as u64;
        Ok(Overturning { records, bodies, not_a_body, points, fit: Fit::of(&told), gravity })
    }
}

/// The records of a file, with their names; its own base where it has none.
fn of_file(
    file: &CaseFile,
    own: BaseMotion,
    over: &ValueRange,
) -> Result<(Vec<String>, Vec<BaseMotion>), ProbabilityError> {
    let records = file.random().map_or(&[][..], |random| &random.records);
    if records.is_empty() {
        return Ok((vec!["that of the case".to_owned()], vec![own]));
    }
    if own.vertical.is_some() {
        return Err(over.wrong(
            "[random] has `records` and the base moves up and down, by another record; a record of its own is { horizontal = \"a.smc\", vertical = \"b.smc\" }",
        ));
    }
    let bases = records.iter().map(|record| base_of(file, &read(file, record, over)?));
    let names = records.iter().map(|record| record.horizontal.clone()).collect();
    Ok((names, bases.collect::<Result<_, _>>()?))
}

/// A record of a file.
fn read(file: &CaseFile, named: &RandomRecord, over: &ValueRange) -> Result<GivenBase, ProbabilityError> {
    let record = |name: &String| {
        let text =
            file.beside(name).ok_or_else(|| over.wrong(format!("cannot read {name}: it is not read yet")))?;
        let record = text.record(None, None).map_err(|error| over.wrong(error.to_string()))?;
        match record.unit {
            RecordUnit::Unnamed => Ok(record),
            unit if unit.is_acceleration() => Ok(record),
            _ => {
                Err(over
                    .wrong(format!("{name} is no record of an acceleration, as that of a base has to be")))
            }
        }
    };
    let horizontal = record(&named.horizontal)?;
    let vertical = named.vertical.as_ref().map(record).transpose()?;
    // One factor scales both, so that how they compare has to be known.
    let is_named = |record: &Record| record.unit != RecordUnit::Unnamed;
    if let (Some(name), Some(vertical)) = (&named.vertical, &vertical)
        && is_named(vertical) != is_named(&horizontal)
    {
        let (one, two) =
            if is_named(vertical) { (name, &named.horizontal) } else { (&named.horizontal, name) };
        return Err(over.wrong(format!("{one} says its unit, and {two} does not; expected both, or neither")));
    }
    Ok(GivenBase { horizontal: Some(horizontal), vertical })
}

/// Records that are given, called by their places.
fn of_given(
    file: &CaseFile,
    given: &[GivenBase],
) -> Result<(Vec<String>, Vec<BaseMotion>), ProbabilityError> {
    let names = (1..=given.len()).map(|place| format!("record {place}")).collect();
    Ok((names, given.iter().map(|given| base_of(file, given)).collect::<Result<_, _>>()?))
}

/// The base of a file as it moves by a record.
fn base_of(file: &CaseFile, given: &GivenBase) -> Result<BaseMotion, ProbabilityError> {
    let base = file.on_base(given).motions()?.swap_remove(0).problem.base;
    Ok(BaseMotion {
        horizontal: base.horizontal.filter(|_| given.horizontal.is_some()),
        vertical: base.vertical.filter(|_| given.vertical.is_some()),
    })
}

/// That beside the shaking nothing varies.
fn varies_not(problem: &ChanceProblem, over: &ValueRange) -> Result<(), ProbabilityError> {
    let Some((case, _)) = problem.case() else { return Err(ProbabilityError::NoBody) };
    let situation =
        case.situation(Acting::All, Trial::AS_GIVEN).map_err(|error| over.wrong(error.to_string()))?;
    let acts = |load: &&Load| {
        load.wrench(situation.body(), case.gravity, Pose::UPRIGHT) != Wrench::ZERO && !is_own_weight(load)
    };
    match situation.loads().iter().filter(acts).find(|load| !load.permanent) {
        Some(load) => Err(over.wrong(format!(
            "beside the shaking only what is permanent is followed, and `{}` varies; permanent = true if it is there all the time",
            load_words(load)
        ))),
        None => Ok(()),
    }
}

/// A peak as it is written, with its unit, as under [earthquake].
fn peak(text: &str, gravity: f64) -> Result<f64, String> {
    let share = in_gravity(text).map(|share| share * gravity);
    let value = share.or_else(|| Dimension::Acceleration.parse(text).ok());
    value.filter(|value| *value > 0.0 && value.is_finite()).ok_or_else(|| {
        format!("\"{text}\" is not a peak above zero with its unit, as \"0.2 g\" or \"2 m/s2\"")
    })
}

/// A body that was drawn.
struct Body {
    /// It under its permanent loads, on a base that does not move.
    still: MotionProblem,
    /// The water that moves along, per unit of the base's acceleration to the right; its history is to be that of the base.
    shaken: Vec<LoadInTime>,
}

impl Body {
    /// The body that values make; none if they do not go together.
    fn of(problem: &ChanceProblem, values: &[f64]) -> Option<Body> {
        let case = problem.case_with(values)?;
        let motion = case.motion.as_ref()?;
        let situation = case.situation(Acting::All, Trial::AS_GIVEN).ok()?;
        let mut still = MotionProblem::standing(&situation).ok()?;
        (still.impact, still.initial, still.t_max) = (motion.impact, motion.initial, motion.t_max);
        still.restitution = motion.restitution;
        let is_friction = |input: &RandomInput| input.friction_of() == Some(FrictionOf::Base);
        if let Some(place) = problem.random().iter().position(is_friction) {
            let ratio = if still.block.mu_s > 0.0 { still.block.mu_k / still.block.mu_s } else { 1.0 };
            (still.block.mu_s, still.block.mu_k) = (values[place], values[place] * ratio);
        }
        let bias = problem.bias(Bias::Force, values).unwrap_or(1.0);
        for load in situation.loads().iter().filter(|load| load.permanent && !is_own_weight(load)) {
            let size = if load.source == LoadSource::Force { bias } else { 1.0 };
            still.add(&situation, load, &History::constant(size).ok()?);
        }
        still.loads.retain(|load| load.direction != [0.0, 0.0]);
        let shaken = shaken_water(&situation, &History::constant(1.0).ok()?).ok()?;
        still.check().ok()?;
        Some(Body { still, shaken })
    }

    /// Outcome on a base that moves so, times a factor.
    fn under(&self, base: &BaseMotion, factor: f64) -> Result<[bool; 3], MotionError> {
        let mut motion = self.still.clone();
        let times = |history: &Option<History>| history.clone().map(|history| history.times_factor(factor));
        motion.base = BaseMotion { horizontal: times(&base.horizontal), vertical: times(&base.vertical) };
        if let Some(history) = &motion.base.horizontal {
            let along =
                self.shaken.iter().map(|load| LoadInTime { history: history.clone(), ..load.clone() });
            motion.loads.extend(along);
        }
        let outcome = simulate(&motion, Keep::default())?;
        let mut became = [false; 3];
        became[ROCKED] = outcome.max_theta > 0.0;
        became[MOVED] = became[ROCKED] || outcome.max_slide > 0.0;
        became[OVERTURNED] = outcome.overturned();
        Ok(became)
    }
}

/// Outcomes for a body, by their places in what [`Body::under`] tells.
const MOVED: usize = 0;
const ROCKED: usize = 1;
const OVERTURNED: usize = 2;

/// The largest |acceleration| of a base to the sides.
fn peak_of(base: &BaseMotion) -> f64 {
    base.horizontal.as_ref().map_or(0.0, |history| history.peak().abs())
}

/// Outcome for every body, under every record, at every peak, shared out to threads. A draw that is not a body stands.
fn follow(
    bodies: &[Option<Body>],
    bases: &[BaseMotion],
    peaks: &[f64],
    threads: usize,
    portion: Portion<'_>,
) -> Result<Vec<Vec<Vec<[bool; 3]>>>, MotionError> {
    let count = peaks.len() * bases.len() * bodies.len();
    let one = |which: &usize| {
        let (body, pair) = (which % bodies.len(), which / bodies.len());
        let (base, peak) = (&bases[pair % bases.len()], peaks[pair / bases.len()]);
        match &bodies[body] {
            Some(body) => body.under(base, peak / peak_of(base)),
            None => Ok([false; 3]),
        }
    };
    let all: Vec<usize> = (0..count).collect();
    let became = in_order(&all, threads, portion, one)?.into_iter().collect::<Result<Vec<_>, _>>()?;
    let of_record = |at: &[[bool; 3]]| at.chunks(bodies.len()).map(<[_]>::to_vec).collect();
    Ok(became.chunks(bodies.len() * bases.len()).map(of_record).collect())
}
