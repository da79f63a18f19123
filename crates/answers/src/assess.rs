//! A case answered: every situation of it with its outcome, and its criteria.

mod any_check;
mod balance;
mod because;
mod components;
pub mod ground;
pub mod joint_words;
mod joints;

use std::cmp::Ordering;

use standfast::loads::Earthquake;
use standfast::{Departure, InputError, Mode, Motion, Outcome, Situation, Stage, Verdict};
use standfast_model::{BlockCase, CaseFile, Criterion, FirstInstant, MotionCriterion};
use standfast_watch::Portion;

use crate::case::{Acting, Case, Trial};
use crate::criteria::Check;
use crate::error::CaseError;
use crate::explained::Explained;
use crate::motion::{Follow, FollowedMotion, MotionCheck, worst_checks as worst_motion_checks};
use crate::random::{AskedChances, ProbabilityError, Random, asked_of_file};
use crate::units::Extent;
pub use any_check::AnyCheck;
pub use balance::{Balance, BalancePart};
pub use components::Component;
pub use ground::{BaseResponse, Elastic};
pub use joints::{JointPlace, Joints, Together};
use standfast_inputs::OutputUnits;

/// The answer to a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessment {
    /// The case.
    pub case: Case,
    /// Its situations: one for each combination, or each force that acts alone, or the only one.
    pub all: Vec<Assessed>,
    /// The part of the answer in time, of a case with histories: [`of_file`](Assessment::of_file) has it.
    pub in_time: Option<MotionAssessment>,
    /// True if the probability that a criterion asks for is that of a year, and not of an event.
    pub yearly: bool,
}

/// A case in time beside its first instant.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionAssessment {
    /// A sentence, without its stop, on what is answered of the first instant.
    pub note: String,
    /// Criteria of the motion.
    pub criteria: Vec<MotionCriterion>,
    /// The motion in every situation, the worst first; empty where it was not followed, because nothing is asked of it.
    pub motions: Vec<FollowedMotion>,
}

/// A situation of a case with everything that is said about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Assessed {
    /// Its place among the situations of the case.
    pub index: usize,
    /// The loads of the case that act.
    pub acting: Acting,
    /// Extent of its forces and moments: a metre run or the whole body.
    pub extent: Extent,
    /// Units and digits in which it is written.
    pub output: OutputUnits,
    /// The way in which it is tried: signs of the acceleration of the base, factors of pairs.
    pub trial: Trial,
    /// The acceleration of the base.
    pub earthquake: Option<Earthquake>,
    /// True if that is the worst of those that are tried, which is reported.
    pub is_reported: bool,
    /// The body under its loads.
    pub situation: Situation,
    /// The answer on its base.
    pub outcome: Outcome,
    /// Its joints above the base, each with what is above it; `None` without any. The answer beside is then that of the whole as one body.
    pub joints: Option<Box<Joints>>,
    /// The share of its base in the answer, where the case says what that bears.
    pub ground: Option<BaseResponse>,
    /// What criteria ask of chance, under any acceleration of the base that is tried; `None` where nothing asks.
    pub chances: Option<Box<AskedChances>>,
    /// The answers in the other ways in which it is tried, none of them worse as a whole.
    pub others: Vec<Assessed>,
}

/// A criterion where it is met worst.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseCheck<'a> {
    /// The criterion and how far it is met.
    pub check: Check,
    /// The situation, in the way in which it is worst for this criterion.
    pub assessed: &'a Assessed,
}

impl Assessment {
    /// Answers a case.
    ///
    /// # Errors
    /// If the loads add up to what the mechanics cannot take.
    pub fn of(case: &Case) -> Result<Assessment, InputError> {
        Assessment::owning(case.clone())
    }

    /// Answers a case that is not needed elsewhere.
    ///
    /// # Errors
    /// As [`of`](Assessment::of).
    pub fn owning(case: Case) -> Result<Assessment, InputError> {
        let acting = case.acting().into_iter().enumerate();
        let all =
            acting.map(|(index, acting)| Assessed::of(&case, index, acting)).collect::<Result<_, _>>()?;
        Ok(Assessment { case, all, in_time: None, yearly: false })
    }

    /// Answers the case of a file: as [`of`](Assessment::of), and the probability that a criterion asks for. A case in time is answered at
    /// its first instant, and followed where something is asked of its motion.
    ///
    /// # Errors
    /// If the case makes no sense, its probability is not found, or its motion cannot be followed.
    pub fn of_file(file: &CaseFile) -> Result<Assessment, CaseError> {
        Assessment::following(file, None, Portion::UNSEEN)
    }

    /// Answers a case file with the motion of a case in time followed as `follow` says; not followed if that is `None`. It is a portion of
    /// work that somebody may watch.
    ///
    /// # Errors
    /// As [`of_file`](Assessment::of_file); if the work is stopped.
    pub fn following(
        file: &CaseFile,
        follow: Option<&Follow>,
        portion: Portion<'_>,
    ) -> Result<Assessment, CaseError> {
        if let Some(first) = file.first_instant()? {
            return Assessment::in_time(file, &first, follow, portion);
        }
        let case = file.case()?;
        let asked: Vec<Criterion> = case.all_criteria().into_iter().filter(Criterion::is_chance).collect();
        let assessment = Assessment::owning(case).map_err(|error| file.refused(error))?;
        if asked.is_empty() { Ok(assessment) } else { assessment.with_chance(file, &asked, portion) }
    }

    /// The answer of a file in time at its first instant, with what belongs to time: the criteria of the motion, which is followed where
    /// there are some, or where it is asked for.
    fn in_time(
        file: &CaseFile,
        first: &FirstInstant,
        follow: Option<&Follow>,
        portion: Portion<'_>,
    ) -> Result<Assessment, CaseError> {
        let [of_first, of_motions] = portion.parts([1.0, 1.0]);
        let mut assessment = Assessment::following(&first.file, None, of_first)?;
        let criteria = file.motion_criteria()?;
        let plain = Follow::default();
        // No motion is followed in space; whoever asks for one of its criteria is told so.
        let follow = follow.filter(|_| assessment.case.plan.is_none());
        let motions = match follow.or((!criteria.is_empty()).then_some(&plain)) {
            Some(follow) => {
                let all = FollowedMotion::of_all(file.motions()?, follow, of_motions);
                all.map_err(|error| file.motion_refused(error))?
            }
            None => Vec::new(),
        };
        assessment.in_time = Some(MotionAssessment { note: first.note.clone(), criteria, motions });
        Ok(assessment)
    }

    /// Adds to every situation what these criteria ask of chance; the file is that of the case.
    ///
    /// # Errors
    /// If it is not found.
    pub(crate) fn with_chance(
        mut self,
        file: &CaseFile,
        asked: &[Criterion],
        portion: Portion<'_>,
    ) -> Result<Assessment, CaseError> {
        let found = asked_of_file(file, asked, portion).map_err(|error| match error {
            ProbabilityError::Case(error) => error,
            other => file.no_chance_of(other.to_string(), other.help(), |key| other.is_about(key)),
        })?;
        for assessed in &mut self.all {
            let of = found.iter().find(|(acting, _)| *acting == assessed.acting);
            let of = of.map(|(_, chances)| Box::new(chances.clone()));
            assessed.others.iter_mut().for_each(|other| other.chances = of.clone());
            assessed.chances = of;
        }
        self.yearly = file.random().is_some_and(Random::is_yearly);
        Ok(self)
    }

    /// All situations under all accelerations of the base that were tried.
    pub fn tried(&self) -> impl Iterator<Item = &Assessed> {
        self.all.iter().flat_map(Assessed::tried)
    }

    /// Of all that was tried, where a number is least, the first of several.
    pub fn least(&self, of: impl Fn(&Assessed) -> f64) -> &Assessed {
        let least = self.tried().min_by(|one, two| of(one).total_cmp(&of(two)));
        least.expect("a case has a situation")
    }

    /// The situation that is worst: see [`worst_first`](Assessment::worst_first).
    pub fn governing(&self) -> &Assessed {
        let severity = self.all.iter().map(|assessed| (assessed.severity(&self.case), assessed));
        let worst = severity.min_by(|(one, _), (two, _)| Severity::compare(one, two));
        worst.expect("a case has a situation").1
    }

    /// The situations, the worst first: by what is used of the criteria, then by where the body leaves rest, then by the lesser and
    /// the greater safety factor, then in their order.
    pub fn worst_first(&self) -> Vec<&Assessed> {
        let severity = self.all.iter().map(|assessed| (assessed.severity(&self.case), assessed));
        let mut severity: Vec<_> = severity.collect();
        severity.sort_by(|(one, _), (two, _)| Severity::compare(one, two));
        severity.into_iter().map(|(_, assessed)| assessed).collect()
    }

    /// The name of a situation: its force that acts alone, or its combination.
    pub fn name(&self, assessed: &Assessed) -> Option<String> {
        self.case.acting_name(assessed.acting)
    }

    /// The criteria, each where it is met worst; the governing one first.
    pub fn checks(&self) -> Vec<CaseCheck<'_>> {
        let asked = |criterion: &Criterion| {
            let of = self.all.iter().filter(|one| self.case.criteria_of(one.acting).contains(criterion));
            worst_check(criterion, of.flat_map(Assessed::tried))
        };
        by_urgency(self.case.all_criteria().iter().filter_map(asked).collect())
    }

    /// The case of a situation: that of its combination, where that changes something.
    pub fn case_of(&self, assessed: &Assessed) -> &Case {
        self.case.under(assessed.acting)
    }

    /// Other criteria than those of the case, each where it is met worst; the governing one first.
    pub fn checks_of(&self, criteria: &[Criterion]) -> Vec<CaseCheck<'_>> {
        worst_checks(criteria, || self.tried())
    }

    /// The criteria of the motion, each in the situation that meets it worst; the governing one first.
    pub fn motion_checks(&self) -> Vec<(MotionCheck, usize)> {
        self.in_time.as_ref().map_or_else(Vec::new, |in_time| self.motion_checks_of(&in_time.criteria))
    }

    /// Other criteria than those of the case, each in the situation whose motion meets it worst; the governing one first.
    pub(crate) fn motion_checks_of(&self, criteria: &[MotionCriterion]) -> Vec<(MotionCheck, usize)> {
        let Some(in_time) = &self.in_time else { return Vec::new() };
        let checks = worst_motion_checks(criteria, &in_time.motions).into_iter();
        checks.map(|(check, place)| (check, self.place_of(&in_time.motions[place].case))).collect()
    }

    /// The place among the situations of the one that a motion is of.
    fn place_of(&self, motion: &BlockCase) -> usize {
        self.all.iter().position(|assessed| self.name(assessed) == motion.situation).unwrap_or(0)
    }

    /// All criteria, of the first instant and of the motion; the governing one first.
    pub fn all_checks(&self) -> Vec<AnyCheck<'_>> {
        let motion = self.motion_checks().into_iter().map(|(check, place)| AnyCheck::Motion(check, place));
        let mut checks: Vec<_> = self.checks().into_iter().map(AnyCheck::Instant).chain(motion).collect();
        standfast::order::by_number(&mut checks, |one| -one.urgency());
        checks
    }

    /// The criteria of a situation, of the first instant and of the motion; the governing one first.
    pub fn checks_in<'a>(&'a self, assessed: &'a Assessed) -> Vec<AnyCheck<'a>> {
        let mut checks: Vec<_> = assessed.checks(&self.case).into_iter().map(AnyCheck::Instant).collect();
        for followed in self.in_time.iter().flat_map(|in_time| &in_time.motions) {
            if self.place_of(&followed.case) == assessed.index {
                let found = followed.checks().into_iter();
                checks.extend(found.map(|check| AnyCheck::Motion(check, assessed.index)));
            }
        }
        standfast::order::by_number(&mut checks, |one| -one.urgency());
        checks
    }

    /// True if all criteria are met; `None` where there is none.
    pub fn met(&self) -> Option<bool> {
        let checks = self.all_checks();
        (!checks.is_empty()).then(|| checks.iter().all(AnyCheck::is_met))
    }
}

impl Assessed {
    /// A situation in the worst of the ways in which it is tried.
    fn of(case: &Case, index: usize, acting: Acting) -> Result<Assessed, InputError> {
        let of = case.under(acting);
        let alone = |situation: Situation, trial: Trial, is_on_base: bool| {
            let earthquake = trial.shaking.and_then(|shaking| of.shaken(shaking));
            let (outcome, ground) = match of.ground.as_ref().filter(|_| is_on_base) {
                Some(foundation) => {
                    let (outcome, ground) = BaseResponse::of(of, foundation, &situation)?;
                    (outcome, Some(ground))
                }
                None => (situation.outcome()?, None),
            };
            let (extent, others) = (case.extent, Vec::new());
            Ok(Assessed {
                index,
                acting,
                extent,
                output: case.output,
                trial,
                earthquake,
                is_reported: true,
                situation,
                outcome,
                joints: None,
                ground,
                chances: None,
                others,
            })
        };
        let answer = |situation: Situation, trial: Trial| {
            let whole = alone(situation, trial, true)?;
            let joints = Joints::of(case, &whole, &|situation| alone(situation, trial, false))?;
            Ok(Assessed { joints: joints.map(Box::new), ..whole })
        };
        let answered = |trial: Trial| {
            let assessed: Assessed = answer(case.decided(acting, trial)?, trial)?;
            let is_near = |criterion: &Criterion| Check::of(*criterion, &assessed).is_near_bound(&assessed);
            // A factor on its bound, too, is told by the numbers as they are written.
            if assessed.situation.is_as_written() || !case.criteria_of(acting).iter().any(is_near) {
                return Ok(assessed);
            }
            answer(case.as_written(assessed.situation, acting, trial), trial)
        };
        let trials = case.trials(acting);
        if let [only] = trials[..] {
            return answered(only);
        }
        let tried = trials.into_iter().map(|trial| {
            let assessed = answered(trial)?;
            Ok((assessed.severity(case), assessed))
        });
        let mut tried: Vec<(Severity, Assessed)> = tried.collect::<Result<_, InputError>>()?;
        // Of two that are the same but for rounding the given one, which is the first, stays.
        let is_worse = |one: usize, than: usize| tried[one].0.is_worse_than(&tried[than].0);
        let worst = (1..tried.len()).fold(0, |worst, next| if is_worse(next, worst) { next } else { worst });
        let (_, worst) = tried.remove(worst);
        tried.sort_by(|(one, _), (two, _)| Severity::compare(one, two));
        let others = tried.into_iter().map(|(_, other)| Assessed { is_reported: false, ..other }).collect();
        Ok(Assessed { others, ..worst })
    }

    /// The verdict under the full load, applied at once; of bodies on joints none but rest.
    pub fn verdict(&self) -> Option<Verdict> {
        match &self.joints {
            Some(joints) => joints.rests(self).then_some(Verdict::REST),
            None => self.outcome.full.verdict,
        }
    }

    /// The mode that begins under the full load; none where the ground fails, and of bodies on joints none but rest.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict().and_then(Verdict::mode)
    }

    /// Accelerations and reactions of the mode that begins.
    pub fn motion(&self) -> Option<&Motion> {
        self.outcome.full.motion.as_ref()
    }

    /// The departure from rest as the variable loads rise: of the first joint to do so.
    pub fn departure(&self) -> Departure {
        self.joints.as_ref().map_or(self.outcome.departure, |joints| joints.departure())
    }

    /// True if a load of the situation varies.
    pub fn rises(&self) -> bool {
        match &self.outcome.plan {
            Some(_) => self.situation.loads().iter().any(|load| !load.permanent),
            None => !self.outcome.path.is_empty(),
        }
    }

    /// The stages of the rising variable loads up to a load factor.
    pub fn path_up_to(&self, largest: f64) -> Vec<Stage> {
        Stage::up_to(&self.outcome.path, largest)
    }

    /// True if the base decides the response: it crushes, or the ground under it fails.
    pub fn is_on_ground(&self) -> bool {
        self.ground.as_ref().is_some_and(|ground| ground.limit.is_some())
    }

    /// True if a combination multiplies a load by another factor than 1.
    pub fn is_factored(&self) -> bool {
        self.situation.loads().iter().any(|load| load.factor != 1.0)
    }

    /// This and the other ways in which it was tried.
    pub fn tried(&self) -> impl Iterator<Item = &Assessed> {
        std::iter::once(self).chain(&self.others)
    }

    /// The criteria of the case, each under the acceleration of the base that meets it worst; the governing one first.
    pub fn checks(&self, case: &Case) -> Vec<CaseCheck<'_>> {
        worst_checks(case.criteria_of(self.acting), || self.tried())
    }

    fn severity(&self, case: &Case) -> Severity {
        // Which acceleration of the base is worst does not hang on a chance, which is that of all of them.
        let asked = case.criteria_of(self.acting).iter();
        let asked = asked.filter(|criterion| {
            let found =
                |criterion| self.chances.as_ref().is_some_and(|chances| chances.of(criterion).is_some());
            !criterion.is_chance() || found(criterion)
        });
        let used = asked.map(|criterion| Check::of(*criterion, self).urgency()).fold(0.0, f64::max);
        let [sliding, overturning] = match self.is_lifted() {
            true => [0.0; 2],
            false => [self.least_sliding(), self.least_overturning()],
        };
        let factors = [sliding.min(overturning), sliding.max(overturning)];
        Severity([-used, self.departure().load_factor(), factors[0], factors[1]])
    }
}

/// A mode, ground that fails, or the lack of both, as a predicate with its symbol.
pub fn predicate(verdict: Option<Verdict>) -> String {
    match verdict {
        Some(verdict) => format!("{} ({verdict})", verdict.words()),
        None => "has no consistent mode".to_owned(),
    }
}

/// Each criterion where it is met worst of all that was tried.
fn worst_checks<'a, T: Iterator<Item = &'a Assessed>>(
    criteria: &[Criterion],
    tried: impl Fn() -> T,
) -> Vec<CaseCheck<'a>> {
    by_urgency(criteria.iter().filter_map(|criterion| worst_check(criterion, tried())).collect())
}

/// A criterion where it is met worst of what was tried.
fn worst_check<'a>(
    criterion: &Criterion,
    tried: impl Iterator<Item = &'a Assessed>,
) -> Option<CaseCheck<'a>> {
    let checks = tried.map(|assessed| CaseCheck { check: Check::of(*criterion, assessed), assessed });
    checks.reduce(|worst, next| if next.check.urgency() > worst.check.urgency() { next } else { worst })
}

/// Checks, the governing one first.
fn by_urgency(mut checks: Vec<CaseCheck<'_>>) -> Vec<CaseCheck<'_>> {
    standfast::order::by_number(&mut checks, |one| -one.check.urgency());
    checks
}

/// Severity of a situation; the lesser the worse, the first number that differs counts.
struct Severity([f64; 4]);

impl Severity {
    /// Relative difference up to which two numbers are the same but for rounding.
    const ROUNDING: f64 = 1e-9;

    fn compare(one: &Severity, two: &Severity) -> Ordering {
        let pairs = one.0.iter().zip(two.0);
        pairs.map(|(one, two)| one.total_cmp(&two)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    }

    fn is_worse_than(&self, other: &Severity) -> bool {
        let differs = |one: f64, two: f64| {
            one != two && (one - two).abs() > Severity::ROUNDING * one.abs().max(two.abs()).min(f64::MAX)
        };
        let first = self.0.iter().zip(other.0).find(|(one, two)| differs(**one, *two));
        first.is_some_and(|(one, two)| *one < two)
    }
}
