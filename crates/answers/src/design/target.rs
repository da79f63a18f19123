//! Target of a design: a bound that it has to reach.

use std::fmt;
use std::str::FromStr;

use standfast::contact::stack::RestLimit;
use standfast::footprint::PlanLimit;
use standfast::{Mode, Verdict};
use thiserror::Error;

use super::error::DesignError;
use super::quantity::fault;
use super::subject::Subject;
use super::{least, load_factor, overturning, sliding};
use crate::assess::predicate;
use crate::assess::{Assessed, Assessment, CaseCheck};
use crate::case::Case;
use crate::criteria::Check;
use crate::digits::{digits, plain};
use crate::inputs::Value;
use crate::key::MOTION_CRITERIA;
use crate::key::{Key, Kind, Table};
use crate::motion::MotionCheck;
use crate::parse::read;
use crate::suggest::closest;
use crate::units::Extent;
use standfast_model::{Bound, CaseFile, Criterion, MotionCriterion};

/// Beyond any factor that a design aims at.
const FAR: f64 = 1e4;

/// Target that a design has to reach, in every situation of the case and under every acceleration of its base that is tried.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Target {
    /// The body rests under the full load.
    Rest,
    /// Both safety factors are at least this.
    Factor(f64),
    /// The body turns about no corner, neither under the full load at once nor while it rises.
    NoRock,
    /// The body slips at no corner, neither under the full load at once nor while it rises.
    NoSlide,
    /// A criterion as a case file has it.
    Criterion(Criterion),
    /// Criterion of the motion of a case in time.
    Motion(MotionCriterion),
    /// Of the bound of each criterion of the case this share is used at most; at 1 all are met.
    Utilisation(f64),
}

/// A text that is no target.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum TargetError {
    /// A word that names none.
    #[error("{}expected {}", .suggestion.map_or(String::new(), |word| format!("did you mean {word}? ")), known())]
    Unknown {
        /// A name that it is like.
        suggestion: Option<&'static str>,
    },
    /// The name of a target of a number, without one.
    #[error("{name} needs a value, as in {name}={example}")]
    NoValue {
        /// The target.
        name: &'static str,
        /// A value that it may have.
        example: String,
    },
    /// A value where none belongs.
    #[error("{name} takes no value")]
    Value {
        /// The target.
        name: &'static str,
    },
    /// A value that the target cannot have.
    #[error("{fault}; for example {name}={example}")]
    WrongValue {
        /// The target.
        name: &'static str,
        /// Fault of the value.
        fault: String,
        /// A value that it may have.
        example: String,
    },
    /// Target that an assessment does not compute.
    #[error("it asks for {of}, which an assessment of the first instant does not have")]
    Unanswerable {
        /// Result that it asks for.
        of: &'static str,
    },
}

/// Targets that are no criterion.
const WORDS: [&str; 6] = ["rest", "factor", "no-rock", "no-slide", "utilisation", "criteria"];

/// The targets, in a sentence.
fn known() -> String {
    let criteria: Vec<_> = Table::Criteria.keys().filter(|key| !key.is_of_motion()).map(Key::name).collect();
    format!(
        "rest, no-rock, no-slide, factor=1.2, criteria, utilisation=0.9, or a criterion as in bearing_max=300kPa: {}; of the motion of a case \
         in time {}",
        criteria.join(", "),
        MOTION_CRITERIA.join(", ")
    )
}

impl Target {
    /// The target that a case has of its own: its criteria, or without any that it rests, in time that it does not overturn.
    ///
    /// # Errors
    /// If the case makes no sense.
    pub fn own(file: &CaseFile) -> Result<Target, DesignError> {
        Ok(Subject::of(file)?.own_target())
    }
}

impl FromStr for Target {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Target, TargetError> {
        let (name, value) = match text.split_once('=') {
            Some((name, value)) => (name.trim(), Some(value.trim())),
            None => (text.trim(), None),
        };
        let alone = |name, target| match value {
            None => Ok(target),
            Some(_) => Err(TargetError::Value { name }),
        };
        match name {
            "rest" => alone("rest", Target::Rest),
            "no-rock" => alone("no-rock", Target::NoRock),
            "no-slide" => alone("no-slide", Target::NoSlide),
            "criteria" => alone("criteria", Target::Utilisation(1.0)),
            "factor" => Ok(Target::Factor(plain_number("factor", value)?)),
            "utilisation" => Ok(Target::Utilisation(plain_number("utilisation", value)?)),
            name => criterion(name, value),
        }
    }
}

/// A number above zero, as a case file has a safety factor.
fn plain_number(name: &'static str, value: Option<&str>) -> Result<f64, TargetError> {
    match value_of(Key::LeastSliding, name, value)? {
        Target::Criterion(Criterion { bound: Bound::AtLeast(number), .. }) if number < FAR => Ok(number),
        _ => Err(TargetError::WrongValue {
            name,
            fault: format!("expected a number below {FAR}"),
            example: "1.2".to_owned(),
        }),
    }
}

fn criterion(name: &str, value: Option<&str>) -> Result<Target, TargetError> {
    // A spelling of before the one list of results.
    let name = if name == "load-factor" { "load_factor" } else { name };
    if let Some(place) = MOTION_CRITERIA.iter().position(|known| *known == name) {
        return motion_criterion(place, value);
    }
    if let Some(slide) = name.strip_prefix(Key::GreatestSlidingOver.name()).map(str::trim) {
        return sliding_over(slide, value);
    }
    match Key::find(Table::Criteria, name) {
        Some(key) => value_of(key, key.name(), value),
        None => {
            let names = WORDS.into_iter().chain(Table::Criteria.keys().map(Key::name));
            Err(TargetError::Unknown { suggestion: closest(name, names) })
        }
    }
}

/// The criterion on a probability of sliding over a length in parentheses: `(0.3 m)`, and the greatest that is allowed.
fn sliding_over(slide: &str, value: Option<&str>) -> Result<Target, TargetError> {
    let name = "p_sliding_over(0.3 m)";
    let example = || "0.1".to_owned();
    let wrong = |fault: String| TargetError::WrongValue { name, fault, example: example() };
    let number =
        |key: Key, written: &str| match read(key.into(), key.info().kind, Some(Extent::PerMetre), written) {
            Ok(Value::Number(number)) => Ok(number),
            Ok(_) => Err(wrong(format!("{written} is no number"))),
            Err(problem) => Err(wrong(fault(&problem))),
        };
    let inside = slide.strip_prefix('(').and_then(|slide| slide.strip_suffix(')'));
    let Some(inside) = inside else {
        return Err(wrong("expected a length in parentheses behind p_sliding_over".to_owned()));
    };
    let slide = number(Key::GreatestMeanSlide, inside.trim())?;
    let value = value.filter(|value| !value.is_empty());
    let written = value.ok_or_else(|| TargetError::NoValue { name, example: example() })?;
    let most = number(Key::GreatestLife, written)?;
    let value = Value::Numbers(vec![slide, most]);
    let criterion =
        Criterion::each_of(Key::GreatestSlidingOver, &value, Extent::PerMetre.into()).into_iter().next();
    criterion.map(Target::Criterion).ok_or_else(|| wrong("expected a length".to_owned()))
}

/// A criterion of the motion, by its place among them, with the value as a case file has it.
fn motion_criterion(place: usize, value: Option<&str>) -> Result<Target, TargetError> {
    let name = MOTION_CRITERIA[place];
    let example = ["0.10 m", "50 mrad", "false", "0.05"][place].to_owned();
    let Some(written) = value.filter(|value| !value.is_empty()) else {
        return Err(TargetError::NoValue { name, example });
    };
    if place == 2 {
        let fault = || "expected false: that the body does not overturn".to_owned();
        return match written {
            "false" => Ok(Target::Motion(MotionCriterion::NotOverturned)),
            _ => Err(TargetError::WrongValue { name, fault: fault(), example }),
        };
    }
    // As the criteria of the same dimension are read.
    let (key, criterion): (Key, fn(f64) -> MotionCriterion) = match place {
        0 => (Key::GreatestSlide, MotionCriterion::Slide),
        3 => (Key::GreatestOverturnedShare, MotionCriterion::OverturnedShare),
        _ => (Key::GreatestTheta, MotionCriterion::MaxTheta),
    };
    match read(key.into(), key.info().kind, Some(Extent::PerMetre), written) {
        Ok(Value::Number(bound)) => Ok(Target::Motion(criterion(bound))),
        Ok(_) => Err(TargetError::NoValue { name, example }),
        Err(problem) => Err(TargetError::WrongValue { name, fault: fault(&problem), example }),
    }
}

/// The criterion under a key, with the value as a case file has it; `name` is what the target is called.
fn value_of(key: Key, name: &'static str, value: Option<&str>) -> Result<Target, TargetError> {
    let info = key.info();
    let example = info.example.to_owned();
    let value = value.filter(|value| !value.is_empty());
    let Some(written) = value else { return Err(TargetError::NoValue { name, example }) };
    // No criterion is of a force or a mass.
    let value = read(key.into(), info.kind, Some(Extent::PerMetre), written);
    let value = value.map_err(|problem| TargetError::WrongValue {
        name,
        fault: fault(&problem),
        example: symbols(info.kind, written).unwrap_or_else(|| example.trim_matches('"').to_owned()),
    })?;
    Criterion::of(key, &value, Extent::PerMetre.into())
        .map(Target::Criterion)
        .ok_or(TargetError::NoValue { name, example })
}

/// The symbols of modes in a text as the list that a case file has of them, where it is made of such.
fn symbols(kind: Kind, written: &str) -> Option<String> {
    let parts = written.split(|c: char| c.is_whitespace() || matches!(c, ',' | ';' | '[' | ']' | '"'));
    let words: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    let are_modes = kind == Kind::ModeList && words.iter().all(|word| word.parse::<Mode>().is_ok());
    (are_modes && !words.is_empty()).then(|| format!("{words:?}"))
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::Rest => f.write_str("rest"),
            Target::Factor(factor) => write!(f, "factor={}", plain(*factor)),
            Target::NoRock => f.write_str("no-rock"),
            Target::NoSlide => f.write_str("no-slide"),
            Target::Criterion(criterion) => criterion.fmt(f),
            Target::Motion(criterion) => criterion.fmt(f),
            Target::Utilisation(1.0) => f.write_str("criteria"),
            Target::Utilisation(share) => write!(f, "utilisation={}", plain(*share)),
        }
    }
}

/// Failure that keeps an answer from meeting a target.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Binding {
    /// In a word: sliding, rocking, the name of a criterion.
    pub(super) by: &'static str,
    /// In a sentence without its stop.
    pub(super) brief: String,
    /// The condition that fails, where the sentence does not name it.
    pub(super) condition: Option<String>,
}

impl Binding {
    fn of(by: &'static str, brief: String) -> Binding {
        Binding { by, brief, condition: None }
    }

    fn because(by: &'static str, brief: String, condition: Option<String>) -> Binding {
        Binding { by, brief, condition }
    }

    /// The failure in a sentence without its stop, with the condition that fails.
    pub(super) fn words(&self) -> String {
        self.condition
            .as_ref()
            .map_or_else(|| self.brief.clone(), |condition| format!("{}: {condition}", self.brief))
    }
}

impl Target {
    /// Condition of a target, as it follows "for which".
    pub fn words(self) -> String {
        match self {
            Target::Rest => "the body rests under the full load".to_owned(),
            Target::Factor(factor) => {
                format!("the factors against sliding and net overturning are {} at least", digits(factor))
            }
            Target::NoRock => "the body turns about no corner, at once or while the load rises".to_owned(),
            Target::NoSlide => "the body slips at no corner, at once or while the load rises".to_owned(),
            Target::Criterion(criterion) if criterion.is_chance() => format!(
                "the {} end of the interval of {}, {}, is {}",
                if matches!(criterion.bound, Bound::AtLeast(_)) { "lower" } else { "upper" },
                criterion.full_name(),
                criterion.of_chance_words(),
                criterion.required()
            ),
            Target::Criterion(criterion) => format!("{} is {}", criterion.name(), criterion.required()),
            Target::Motion(MotionCriterion::NotOverturned) => "the body does not overturn".to_owned(),
            Target::Motion(criterion) => format!("{} is {}", criterion.name(), criterion.required(true)),
            Target::Utilisation(1.0) => "all criteria of the case are met".to_owned(),
            Target::Utilisation(share) => {
                format!("of all criteria of the case {} at most is used", digits(share))
            }
        }
    }

    /// True if all that was tried meets it.
    pub fn is_met(self, answer: &Assessment) -> bool {
        self.motion_checks(answer).iter().all(|(check, _)| self.is_met_in_time(check))
            && answer.tried().all(|assessed| self.is_met_by(answer, assessed))
    }

    /// The criteria of the motion that it is made of, each where it is met worst, the governing one first.
    pub fn motion_checks(self, answer: &Assessment) -> Vec<(MotionCheck, usize)> {
        match self {
            Target::Motion(criterion) => answer.motion_checks_of(&[criterion]),
            Target::Utilisation(_) => answer.motion_checks(),
            _ => Vec::new(),
        }
    }

    fn is_met_in_time(self, check: &MotionCheck) -> bool {
        match self {
            Target::Utilisation(share) if share != 1.0 => {
                check.met && check.utilisation.is_none_or(|used| used <= share)
            }
            _ => check.met,
        }
    }

    fn is_met_by(self, answer: &Assessment, assessed: &Assessed) -> bool {
        match self {
            Target::Rest => assessed.mode() == Some(Mode::Rest),
            Target::Factor(factor) => {
                // By uplift that turns it, a body may move with both factors above 1.
                let turns = factor >= 1.0 && assessed.mode() != Some(Mode::Rest);
                sliding(assessed) >= factor
                    && overturning(assessed) >= factor
                    && !assessed.is_lifted()
                    && !turns
            }
            Target::NoRock | Target::NoSlide => self.offending(&answer.case, assessed).is_none(),
            Target::Criterion(criterion) => Check::of(criterion, assessed).met,
            Target::Motion(_) => true,
            Target::Utilisation(share) => answer.case.criteria_of(assessed.acting).iter().all(|criterion| {
                let check = Check::of(*criterion, assessed);
                // Whether a bound is met is no matter of a rounded quotient.
                if share == 1.0 {
                    check.met
                } else {
                    check.utilisation.map_or(check.met, |used| used <= share)
                }
            }),
        }
    }

    /// The criteria that it is made of, each where it is met worst, the governing one first; none of a target that is none.
    pub fn checks(self, answer: &Assessment) -> Vec<CaseCheck<'_>> {
        match self {
            Target::Criterion(criterion) => answer.checks_of(&[criterion]),
            Target::Utilisation(_) => answer.checks(),
            _ => Vec::new(),
        }
    }

    /// True if it asks for a probability, alone or among the criteria of the case.
    pub(super) fn asks_for_chance(self, case: &Case) -> bool {
        !self.of_chance(case).is_empty()
    }

    /// The criteria of chance that it is, or that are among those of the case.
    pub(super) fn of_chance(self, case: &Case) -> Vec<Criterion> {
        let asked = match self {
            Target::Criterion(criterion) => vec![criterion],
            Target::Utilisation(_) => case.all_criteria(),
            _ => Vec::new(),
        };
        asked.into_iter().filter(Criterion::is_chance).collect()
    }

    /// True if it asks how far the variable loads may rise.
    pub(super) fn asks_for_rise(self) -> bool {
        matches!(self, Target::Criterion(Criterion { key: Key::LeastLoadFactor, .. }))
    }

    /// The mode that is not to be, under the full load or, with its load factor, before.
    fn offending(self, case: &Case, assessed: &Assessed) -> Option<(f64, Option<Verdict>)> {
        // Ground that fails lets the body turn and slip.
        let offends = |verdict: Option<Verdict>| match (self, verdict.and_then(Verdict::mode)) {
            (Target::NoRock, Some(mode)) => mode.corner().is_some() || mode == Mode::Flight,
            (Target::NoSlide, Some(mode)) => mode.slip().is_some() || mode == Mode::Flight,
            (_, None) => true,
            _ => false,
        };
        if let Some(joints) = &assessed.joints {
            let begin =
                |modes: &[Mode]| modes.iter().copied().map(Verdict::Begins).find(|one| offends(Some(*one)));
            let path = joints.path(case, assessed, 1.0).into_iter();
            let mut on_the_way = path.filter_map(|stage| Some((stage.from, Some(begin(&stage.modes)?))));
            let moves_before = assessed.departure().load_factor() < 1.0;
            return match joints.modes() {
                Some(modes) => on_the_way.next().or_else(|| Some((1.0, Some(begin(modes)?)))),
                // In which modes they move nobody knows.
                None if moves_before => Some((assessed.departure().load_factor(), None)),
                None => (assessed.mode() != Some(Mode::Rest)).then_some((1.0, None)),
            };
        }
        if assessed.on_plan().is_some() {
            // In which mode a body moves in space nobody knows.
            let rests = assessed.mode() == Some(Mode::Rest);
            return (!rests).then(|| (assessed.departure().load_factor().min(1.0), None));
        }
        let stages = assessed.outcome.path.iter().filter(|stage| stage.from < 1.0);
        let mut candidates =
            stages.map(|stage| (stage.from, stage.verdict)).chain([(1.0, assessed.verdict())]);
        candidates.find(|(_, verdict)| offends(*verdict))
    }

    /// Score of an outcome, to tell how near a design came.
    pub(super) fn score(self, answer: &Assessment) -> f64 {
        match self {
            Target::Factor(_) => least(answer, sliding).min(least(answer, overturning)),
            Target::Criterion(_) | Target::Utilisation(_) => {
                let instant = self.checks(answer).first().map_or(0.0, |worst| worst.check.urgency());
                let motion = self.motion_checks(answer).first().map_or(0.0, |(check, _)| check.urgency());
                -instant.max(motion)
            }
            Target::Motion(_) => {
                self.motion_checks(answer).first().map_or(0.0, |(check, _)| -check.urgency())
            }
            _ => least(answer, load_factor),
        }
    }

    /// Failure that keeps an answer from meeting it.
    pub(super) fn binding(self, answer: &Assessment) -> Binding {
        let worst = self.motion_checks(answer);
        let in_time = worst.iter().find(|(check, _)| !self.is_met_in_time(check));
        let failing = answer.tried().find(|assessed| !self.is_met_by(answer, assessed));
        let (assessed, in_time) = match (failing, in_time) {
            (Some(assessed), None) => (assessed, None),
            (Some(assessed), Some(in_time)) => {
                // Of both, what is farther from being met.
                let instant = self.checks(answer).first().map_or(0.0, |worst| worst.check.urgency());
                (assessed, Some(in_time).filter(|(check, _)| check.urgency() > instant))
            }
            (None, Some(in_time)) => (&answer.all[0], Some(in_time)),
            (None, None) => return Binding::of("", "nothing".to_owned()),
        };
        if let Some((check, place)) = in_time {
            return self.of_motion(answer, check, *place);
        }
        match self {
            Target::Factor(factor) => of_factors(assessed, factor),
            Target::Rest => full_load(assessed),
            Target::NoRock | Target::NoSlide => {
                let (at, verdict) = self.offending(&answer.case, assessed).unwrap_or_default();
                let when = if at < 1.0 {
                    format!("as the load rises, from {} % on", digits(100.0 * at))
                } else {
                    "under the full load at once".to_owned()
                };
                let does = match &assessed.joints {
                    Some(joints) if at < 1.0 => joints.departs(assessed),
                    Some(joints) => joints.at_once(assessed),
                    None if assessed.on_plan().is_some() => assessed.departs(),
                    None => format!("the body {}", predicate(verdict)),
                };
                Binding::of(motion(verdict), format!("{when}, {does}"))
            }
            Target::Criterion(_) | Target::Utilisation(_) => of_check(answer, &self.checks(answer)[0], self),
            Target::Motion(_) => Binding::of("", "nothing".to_owned()),
        }
    }

    /// Failure of a criterion of the motion where it is met worst.
    fn of_motion(self, answer: &Assessment, check: &MotionCheck, place: usize) -> Binding {
        let place = answer.name(&answer.all[place]).filter(|_| answer.all.len() > 1);
        let place = place.map_or(String::new(), |name| format!(", in {name}"));
        let words = match self {
            Target::Utilisation(share) if check.met => {
                let used = check.utilisation_words();
                format!("of {} {used} is used, not {} at most{place}", check.criterion, digits(share))
            }
            _ => check.failure() + &place,
        };
        Binding::of(check.criterion.name(), words)
    }
}

/// Failing one of both safety factors, or the reason why neither means anything.
fn of_factors(assessed: &Assessed, factor: f64) -> Binding {
    let at_least = digits(factor);
    if assessed.is_lifted() {
        let what = if assessed.outcome.full.is_lifted() { "the body on its base" } else { "a joint" };
        let brief = format!("nothing presses {what}");
        Binding::because("uplift", brief, Some("V > 0 fails".to_owned()))
    } else if sliding(assessed) < factor {
        let brief = format!("the factor of the body against sliding is less than {at_least}");
        Binding::because("sliding", brief, Some(format!("μ(W' − U)/P ≥ {at_least} fails")))
    } else if overturning(assessed) < factor {
        let brief = format!("the factor of the body against net overturning is less than {at_least}");
        Binding::because("overturning", brief, Some(format!("(W' t − M_U)/M_p ≥ {at_least} fails")))
    } else {
        full_load(assessed)
    }
}

/// Mode that ends rest under the full load.
fn full_load(assessed: &Assessed) -> Binding {
    let brief = format!("under the full load {}", assessed.at_once());
    match of_first(assessed) {
        Some(by) => Binding::of(by, brief),
        None => {
            let verdict = assessed.verdict();
            Binding::because(motion(verdict), brief, condition(assessed, verdict))
        }
    }
}

/// Failure of a criterion where it is met worst.
fn of_check(answer: &Assessment, worst: &CaseCheck<'_>, target: Target) -> Binding {
    let CaseCheck { check, assessed } = worst;
    let place = answer.name(assessed).filter(|_| answer.all.len() > 1);
    let place = place.map_or(String::new(), |name| format!(", in {name}"));
    let verdict = assessed.departure().verdict().or(assessed.verdict());
    let by = match check.criterion.key {
        Key::LeastSliding => "sliding",
        Key::LeastOverturningNet | Key::LeastOverturningGross | Key::GreatestTipping => "overturning",
        Key::LeastUplift => "uplift",
        Key::GreatestBearing => "bearing",
        Key::LeastContact => "contact",
        Key::GreatestEccentricity => "eccentricity",
        Key::ModesNot => of_first(assessed).unwrap_or_else(|| motion(assessed.verdict())),
        Key::LeastGround | Key::GreatestEffective => GROUND,
        Key::GreatestRotation => "rotation",
        Key::GreatestNotRest | Key::GreatestLife | Key::GreatestAny | Key::LeastLifeIndex => "probability",
        Key::GreatestMeanSlide | Key::GreatestSlidingOver => "sliding in storms",
        _ => of_first(assessed).unwrap_or_else(|| motion(verdict)),
    };
    let words = match (check.met, target) {
        (true, Target::Utilisation(share)) => {
            format!(
                "of {} {} is used, not {} at most{place}",
                check.criterion,
                check.utilisation_words(),
                digits(share)
            )
        }
        _ if check.criterion.key == Key::LeastLoadFactor => {
            // Of joints it is told which leaves rest and how.
            let is_one = assessed.joints.is_none() && assessed.on_plan().is_none();
            let why = condition(assessed, verdict).filter(|_| is_one);
            let why = why.map_or(String::new(), |why| format!(": {why}"));
            format!("{}{place}: {}{why}", check.failure(assessed), assessed.departs())
        }
        _ => check.failure(assessed) + &place,
    };
    Binding::of(by, words)
}

/// Word for a failure of the ground.
const GROUND: &str = "ground";

/// The motion with which the first joint, or a body on a plan, leaves rest, in a word; `None` of another body.
fn of_first(assessed: &Assessed) -> Option<&'static str> {
    if let Some(ended_by) = assessed.on_plan() {
        return Some(match ended_by {
            Some(PlanLimit::Slides | PlanLimit::Turns) => "sliding",
            Some(PlanLimit::Tips { .. }) => "rocking",
            Some(PlanLimit::Lifts) => "uplift",
            None => "rest",
        });
    }
    let joints = assessed.joints.as_ref()?;
    Some(match joints.leaves.limits.first() {
        Some((_, Some(RestLimit::Slides(_)))) => "sliding",
        Some((_, Some(RestLimit::Turns(_)))) => "rocking",
        _ => motion(assessed.outcome.departure.verdict()),
    })
}

/// The motion of a mode in a word, or the ground that fails.
fn motion(verdict: Option<Verdict>) -> &'static str {
    if verdict == Some(Verdict::BearingFailure) {
        return GROUND;
    }
    match verdict.and_then(Verdict::mode).map(|mode| (mode.corner().is_some(), mode.slip().is_some(), mode)) {
        None => "no mode",
        Some((_, _, Mode::Flight)) => "uplift",
        Some((true, true, _)) => "slide-rocking",
        Some((true, false, _)) => "rocking",
        Some((false, true, _)) => "sliding",
        Some((false, false, _)) => "rest",
    }
}

/// Condition of rest that a mode breaks; `None` where none is consistent.
fn condition(assessed: &Assessed, verdict: Option<Verdict>) -> Option<String> {
    let mode = match verdict {
        Some(Verdict::Begins(mode)) => mode,
        Some(_) => return Some("R ≥ V fails".to_owned()),
        None => return None,
    };
    let (ends, edges) = match assessed.is_on_ground() {
        true => ("the base crushes under an edge", "−b₁V + V²/2q ≤ X d − M ≤ b₂V − V²/2q"),
        false => ("the resultant leaves the base", "−b₁ V ≤ X d − M ≤ b₂ V"),
    };
    let condition = match (mode.corner(), mode.slip()) {
        (None, Some(_)) => "the friction is used up: |X| ≤ μ V fails".to_owned(),
        (Some(_), None) => format!("{ends}: {edges} fails"),
        (Some(_), Some(_)) => format!("|X| ≤ μ V or {edges} fails"),
        _ => "nothing presses it on its base: V > 0 fails".to_owned(),
    };
    if assessed.is_on_ground() {
        return Some(condition);
    }
    // Under the full load, the report's inequalities of rest say it with their numbers.
    let steps =
        assessed.outcome.full.effective.map(|reduced| reduced.point.explain().steps).unwrap_or_default();
    let rest = steps.into_iter().find(|step| step.mode == Mode::Rest && !step.holds);
    let failing = rest.and_then(|step| step.relations.into_iter().find(|relation| !relation.holds));
    let equation = failing.map_or(String::new(), |relation| {
        format!("; ({}) {} fails in effective coordinates", relation.equation, relation.statement())
    });
    Some(condition + &equation)
}
