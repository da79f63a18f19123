//! A case in time, one situation of it: a body in pure numbers, or one in metres with the loads that act together.

use standfast::Wrench;
use standfast::contact::Block;
use standfast::loads::{LoadSource, Pose};
use standfast_motion::{BaseMotion, LoadInTime, MotionError, MotionProblem, is_own_weight};

use crate::case::{Acting, Case, CaseMotion, Foundation, HistoryOf, Reader, Trial, said_by};
use crate::case_file::CaseFile;
use crate::criteria::MotionCriterion;
use crate::error::{CaseError, Fault, Place, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Id, Key, Table};
use crate::load_words::load_words;
use crate::parse::read;
use crate::slips::slips;
use crate::units::Extent;

/// A body with what acts on it in time; that of a `[body]` is in SI units, per its mass.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockCase {
    /// Its title.
    pub title: Option<String>,
    /// Name of the alternative load or combination that acts, where there are several.
    pub situation: Option<String>,
    /// The problem.
    pub problem: MotionProblem,
    /// The crest above the base, for its figures; of a `[block]` twice that of C.
    pub height: f64,
    /// True if water presses up on the base.
    pub uplift: bool,
    /// Its mass, kg or kg per metre run; 1 in pure numbers.
    pub mass: f64,
    /// True if it is in SI units.
    pub si: bool,
    /// The loads at their peaks, of a body.
    pub peaks: Vec<LoadPeak>,
    /// Criteria on the motion.
    pub criteria: Vec<MotionCriterion>,
    /// Points whose accelerations are told.
    pub points: Vec<BodyPoint>,
    /// Copies that are asked for.
    pub copies: Option<CopiesAsked>,
    /// Warnings of possible slips.
    pub warnings: Vec<MotionWarning>,
}

/// Point of the body, as where equipment stands.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyPoint {
    /// Its name.
    pub name: String,
    /// From the centre of mass to the right and upwards, fixed in the body.
    pub at: [f64; 2],
}

impl BodyPoint {
    /// A point as an option has it: two lengths with a comma between, and its name before them, or else its number.
    ///
    /// # Errors
    /// If it is none; what is wrong, in words.
    pub fn parse(text: &str, number: usize, units: Option<Extent>) -> Result<BodyPoint, String> {
        let (name, lengths) = match text.split_once('=') {
            Some((name, lengths)) => (name.trim().to_owned(), lengths),
            None => (number.to_string(), text),
        };
        if name.is_empty() {
            return Err("a name is missing before =".to_owned());
        }
        let (x, y) = lengths.split_once(',').ok_or("expected two lengths with a comma between")?;
        let length = |written: &str| {
            let written = written.trim();
            match read(Key::InitialX.into(), Key::InitialX.info().kind, units, written) {
                Ok(Value::Number(number)) => Ok(number),
                _ if units.is_none() => Err(format!("{written} is no number; a [block] has no units")),
                _ => Err(format!("{written} is no length, as 0.9, \"90 cm\" or \"0.9 m\"")),
            }
        };
        Ok(BodyPoint { name, at: [length(x)?, length(y)?] })
    }
}

/// Copies of a motion that are asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct CopiesAsked {
    /// Number of them, the case itself not counted.
    pub number: usize,
    /// How far their numbers scatter.
    pub spread: Spread,
    /// The seed.
    pub seed: u64,
}

/// σ, by which the logarithms of numbers scatter.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// One for all.
    Even(f64),
    /// That of each name; of others none.
    Named(Vec<(String, f64)>),
}

impl CopiesAsked {
    /// The spread where nothing is said: one in a thousand.
    pub const SPREAD: Spread = Spread::Even(1e-3);
    /// The seed where nothing is said.
    pub const SEED: u64 = 1;
    /// More copies would take hours.
    pub const MOST: usize = 1_000_000;
}

/// What options say of copies, in place of the case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CopiesOptions {
    /// Number of them.
    pub number: Option<usize>,
    /// How far their numbers scatter.
    pub spread: Option<Spread>,
    /// The seed.
    pub seed: Option<u64>,
}

impl CopiesOptions {
    /// Puts them in place of what a case says.
    ///
    /// # Errors
    /// The name of an option that is given where no copies are followed.
    pub fn put(&self, case: &mut BlockCase) -> Result<(), &'static str> {
        let own = case.copies.take();
        let Some(number) = self.number.or(own.as_ref().map(|own| own.number)) else {
            return match self {
                CopiesOptions { spread: Some(_), .. } => Err("spread"),
                CopiesOptions { seed: Some(_), .. } => Err("seed"),
                _ => Ok(()),
            };
        };
        let (spread, seed) =
            own.map_or((CopiesAsked::SPREAD, CopiesAsked::SEED), |own| (own.spread, own.seed));
        let (spread, seed) = (self.spread.clone().unwrap_or(spread), self.seed.unwrap_or(seed));
        case.copies = Some(CopiesAsked { number, spread, seed });
        Ok(())
    }
}

/// A load of a body at its peak, about its centre of mass.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPeak {
    /// Its name.
    pub name: String,
    /// True if it is there all the time.
    pub permanent: bool,
    /// The load, N and N·m, or per metre run; the greatest of its history times what the case has of it.
    pub wrench: Wrench,
}

/// Something that may be a slip, or leaves the range of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionWarning {
    /// Its name.
    pub name: &'static str,
    /// The finding, with its number.
    pub words: String,
}

/// Warnings of the shaking of a base.
const OF_SHAKING: [&str; 6] = [
    "strong-earthquake",
    "weak-earthquake",
    "coarse-record",
    "nothing-moves",
    "record-drift",
    "record-ends-abruptly",
];

impl BlockCase {
    /// The same under another shaking of the base, with points up to `step` apart; water that is shaken with the base goes with it.
    pub fn shaken(&self, base: &BaseMotion, step: f64) -> BlockCase {
        let mut case = self.clone();
        if let (Some(own), Some(other)) = (&self.problem.base.horizontal, &base.horizontal) {
            for load in case.problem.loads.iter_mut().filter(|load| load.history.is_same(own)) {
                load.history = other.clone();
            }
        }
        case.problem.base = base.clone();
        case.warnings.retain(|warning| !OF_SHAKING.contains(&warning.name));
        case.warnings.extend(slips(&case.problem, Some(step)));
        case.warnings.dedup();
        case
    }
}

impl CaseFile {
    /// The situations of a case in time: one for each of the loads, or combinations of them, that act alone.
    ///
    /// # Errors
    /// If the case is none, or a variable load has no history.
    pub fn motions(&self) -> Result<Vec<BlockCase>, CaseError> {
        if self.is_in_time() && !self.inputs().has(Table::Block) {
            self.case()?;
        }
        motions(self.inputs()).map_err(|fault| self.error(fault))
    }
}

/// The situations of inputs in time.
///
/// # Errors
/// As [`CaseFile::motions`].
pub fn motions(inputs: &Inputs) -> Result<Vec<BlockCase>, Fault> {
    if inputs.has(Table::Block) {
        return Ok(vec![block_case(&Reader { inputs })?]);
    }
    // Histories on a [ground] are those of a motion where one is followed.
    let mut moving = inputs.clone();
    if !inputs.is_in_time() {
        moving.add_table(Table::Motion);
    }
    let given = Reader { inputs: &moving };
    let mut case = Case::of(&moving)?;
    if let Some(plan) = &case.plan {
        return Err(
            plan.not_for("a motion in time; `standfast directions` follows the record as far as rest ends")
        );
    }
    let motion = match case.motion.take() {
        Some(motion) => motion,
        None => given.motion(HistoryOf::Base)?,
    };
    if let Some(strength) = case.ground.as_ref().and_then(Foundation::strength) {
        return Err(Fault::new(Problem::MovingOnCrushing { strength }, Key::Strength));
    }
    let acting = case.acting().into_iter();
    acting.map(|acts| body_case(&given, &case, &motion, acts)).collect()
}

/// One situation of a body in metres.
fn body_case(given: &Reader<'_>, case: &Case, motion: &CaseMotion, acts: Acting) -> Result<BlockCase, Fault> {
    if let Some(at) = case.pairs_in(acts) {
        return Err(Fault::new(Problem::Pairs { of: "a motion in time" }, at));
    }
    let name = case.acting_name(acts);
    let situation =
        case.situation(acts, Trial::AS_GIVEN).map_err(|error| given.motion_refused(error.into()))?;
    let case = case.under(acts);
    let motion = case.motion.as_ref().unwrap_or(motion);
    let (body, gravity) = (situation.body(), situation.gravity());
    let acts_at_all = |wrench: Wrench| wrench != Wrench::ZERO;
    let problem = MotionProblem::of(&situation, motion.base.clone(), motion.impact).and_then(|problem| {
        let (initial, t_max, restitution) = (motion.initial, motion.t_max, motion.restitution);
        let problem = MotionProblem { initial, t_max, restitution, ..problem };
        checked(problem)
    });
    let problem = problem.map_err(|error| match error {
        MotionError::NoHistory { load } if said_by(load) == Place::Table(Table::Earthquake, 0) => {
            Fault::new(Problem::HeldShaking, Table::Earthquake)
        }
        MotionError::NoHistory { load } => Fault::new(Problem::Motion(error), said_by(load)),
        error => given.motion_refused(error),
    })?;
    let mut peaks = Vec::new();
    for load in situation.loads().iter().filter(|load| !is_own_weight(load)) {
        let wrench = situation.wrench_of(load);
        if acts_at_all(wrench) {
            let peak =
                load.history.as_ref().filter(|_| !load.permanent).map_or(1.0, |history| history.peak());
            peaks.push(LoadPeak { name: load_words(load), permanent: load.permanent, wrench: wrench * peak });
        }
    }
    let uplift = situation.loads().iter().any(|load| {
        matches!(load.source, LoadSource::WaveUplift | LoadSource::Uplift)
            && acts_at_all(load.wrench(body, gravity, Pose::UPRIGHT))
    });
    let mut warnings = motion.warnings.clone();
    let of_case = case.warnings().into_iter();
    warnings
        .extend(of_case.map(|warning| MotionWarning { name: warning.name(), words: warning.to_string() }));
    if case.ground.is_some() {
        let words =
            "the motion is that on a rigid base: what [ground] bears, and how it gives way, is left out"
                .to_owned();
        warnings.push(MotionWarning { name: "ground-left-out", words });
    }
    let shaken = problem.base.horizontal.is_some() || problem.base.vertical.is_some();
    if shaken && !case.soils.is_empty() {
        let words = "the backfill presses as it does at rest: what the shaking adds to its pressure is left out, and the motion is too small; \
                     `assess` with [earthquake] has that pressure"
            .to_owned();
        warnings.push(MotionWarning { name: "backfill-kept", words });
    }
    warnings.extend(slips(&problem, motion.step));
    Ok(BlockCase {
        title: case.title.clone(),
        situation: name,
        problem,
        height: case.body.height(),
        uplift,
        mass: body.mass(),
        si: true,
        peaks,
        criteria: motion.criteria.clone(),
        points: motion.points.clone(),
        copies: motion.copies.clone(),
        warnings,
    })
}

/// A body in pure numbers.
fn block_case(given: &Reader<'_>) -> Result<BlockCase, Fault> {
    let inputs = given.inputs;
    alone(inputs)?;
    given.ranges()?;
    let mut problem = MotionProblem::new(block(given)?, given.required(Key::BlockGravity)?);
    problem.mu_impact = given.number(Key::MuImpact);
    let mut motion = given.motion(HistoryOf::Pure)?;
    for index in 0..inputs.count(Table::BlockLoad) {
        let number = |key| inputs.number(Id::new(key, index));
        let pair = |x, y| Some([number(x)?, number(y)?]);
        let lacks = || given.missing(Key::DirectionX, index);
        let direction = pair(Key::DirectionX, Key::DirectionY).ok_or_else(lacks)?;
        let read = given.history(Table::BlockLoadHistory, index, HistoryOf::Pure)?;
        let read = read.ok_or_else(|| {
            let problem =
                Problem::MissingTableIn { table: Table::BlockLoad, missing: Table::BlockLoadHistory };
            Fault::new(problem, crate::error::Place::Table(Table::BlockLoad, index))
        })?;
        problem.loads.push(LoadInTime {
            at: pair(Key::AtX, Key::AtY).unwrap_or([0.0, 0.0]),
            direction,
            follows: inputs.truth(Id::new(Key::Follows, index)).unwrap_or(false),
            history: motion.take(read),
        });
    }
    problem.base = motion.base;
    (problem.impact, problem.initial, problem.t_max) = (motion.impact, motion.initial, motion.t_max);
    problem.restitution = motion.restitution;
    let problem = checked(problem).map_err(|error| given.motion_refused(error))?;
    let mut warnings = motion.warnings;
    warnings.extend(slips(&problem, motion.step));
    let height = 2.0 * problem.block.d;
    let title = inputs.text(Key::Title).map(str::to_owned);
    let criteria = motion.criteria;
    Ok(BlockCase {
        title,
        situation: None,
        problem,
        height,
        uplift: false,
        mass: 1.0,
        si: false,
        peaks: Vec::new(),
        criteria,
        points: motion.points,
        copies: motion.copies,
        warnings,
    })
}

/// A problem that may be followed, with what corners that touch say of its beginning left to them.
fn checked(problem: MotionProblem) -> Result<MotionProblem, MotionError> {
    problem.check()?;
    let initial = problem.initial.put();
    Ok(MotionProblem { initial, ..problem })
}

/// Refuses what does not go with a body in pure numbers.
fn alone(inputs: &Inputs) -> Result<(), Fault> {
    let of_block = |table: Table| {
        table.is_of_motion()
            || matches!(table, Table::Top | Table::Block | Table::BlockLoad | Table::BlockLoadHistory)
    };
    let goes = |id: Id| match id.table {
        Table::Top => matches!(id.key, Key::Title | Key::Note),
        Table::Criteria => id.key.is_of_motion(),
        table => of_block(table),
    };
    let table = Table::ALL
        .into_iter()
        .find(|table| inputs.has(*table) && *table != Table::Criteria && !of_block(*table));
    if let Some(table) = table {
        return Err(Fault::new(Problem::NotOfBlock { path: table.path(0) }, table));
    }
    match inputs.values().find(|(id, _)| !goes(*id)) {
        Some((id, _)) => Err(Fault::new(Problem::NotOfBlock { path: id.to_string() }, id)),
        None => Ok(()),
    }
}

fn block(given: &Reader<'_>) -> Result<Block, Fault> {
    let or = |key, other: f64| given.number(key).unwrap_or(other);
    let (b1, b2, d) = (given.required(Key::B1)?, given.required(Key::B2)?, given.required(Key::D)?);
    let rho2 = match given.number(Key::Rho2) {
        Some(rho2) => rho2,
        None if b1 == 1.0 && b2 == 1.0 => (1.0 + d * d) / 3.0,
        None => return Err(Fault::new(Problem::NoInertia, Table::Block)),
    };
    let mu_s = given.required(Key::MuS)?;
    Ok(Block {
        b1,
        b2,
        d,
        rho2,
        m_x: or(Key::Mx, 1.0),
        m_y: or(Key::My, 1.0),
        mu_s,
        mu_k: or(Key::MuK, mu_s),
    })
}
