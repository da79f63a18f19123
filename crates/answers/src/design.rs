//! Design: for which values of a quantity is a target met, which of them is the least or the greatest, and what does every
//! number of a case do to its safety?
//!
//! Nothing is linearised or scaled: for each value tried, everything that follows from it, waves and water included, is computed
//! anew from the typed inputs. What is printed is rounded to the safe side, read again as it is printed, and assessed so.

mod boundary;
mod error;
mod minimum;
mod quantity;
mod sensitivity;
mod set;
mod single;
mod subject;
mod target;

pub use boundary::{BoundaryRequest, Column, DesignBoundary};
pub use error::DesignError;
pub use minimum::{Cost, Minimum, MinimumPoint, MinimumRequest, Neighbour};
pub use quantity::{DIGITS, Quantity, with_unit};
pub use sensitivity::{Sensitivity, SensitivityChange, sensitivities};
pub use set::{End, OuterState, Stretch};
pub use single::{Found, NewValue, SingleChange, SingleChanges};
pub use target::{Target, TargetError};

use std::fmt;

use crate::assess::predicate;
use crate::assess::{Assessed, Assessment};
use crate::case::Case;
use crate::couple::{Variable, moved};
use crate::digits::{digits, plain};
use crate::error::CaseError;
use crate::inputs::Inputs;
use crate::motion::MotionValue;
use quantity::Ends;
use set::Search;
use standfast::{Departure, Mode};
use standfast_model::CaseFile;
use standfast_model::MotionCriterion;
use standfast_watch::Portion;
use subject::Subject;

/// Number of parts that a range is cut into to find where a target is met.
const PARTS: u32 = 400;

/// Number of parts for a target that asks for a probability, each of which takes long.
const CHANCE_PARTS: u32 = 24;

/// Wanted end of the values that meet a target.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extreme {
    /// The least of them all.
    #[default]
    Least,
    /// The greatest of them all.
    Greatest,
}

impl Extreme {
    /// The other end.
    pub fn other(self) -> Extreme {
        match self {
            Extreme::Least => Extreme::Greatest,
            Extreme::Greatest => Extreme::Least,
        }
    }

    /// Option that asks for it.
    fn spelled(self, spelling: &Spelling) -> &'static str {
        match self {
            Extreme::Least => spelling.least,
            Extreme::Greatest => spelling.greatest,
        }
    }

    /// That end of a stretch.
    pub fn of(self, stretch: &Stretch) -> &End {
        match self {
            Extreme::Least => &stretch.least,
            Extreme::Greatest => &stretch.greatest,
        }
    }

    /// The stretch that has it.
    fn outermost(self, stretches: &[Stretch]) -> Option<usize> {
        match self {
            Extreme::Least => (!stretches.is_empty()).then_some(0),
            Extreme::Greatest => stretches.len().checked_sub(1),
        }
    }
}

impl fmt::Display for Extreme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Extreme::Least => "least",
            Extreme::Greatest => "greatest",
        })
    }
}

/// Names that a user writes for the parts of a request, so that an error calls them what they were called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spelling {
    /// The quantity to vary.
    pub vary: &'static str,
    /// Option for the lower end of its range.
    pub from: &'static str,
    /// Option for the upper end of its range.
    pub to: &'static str,
    /// Another quantity.
    pub and: &'static str,
    /// Option for the lower end of that one's range.
    pub and_from: &'static str,
    /// Option for the upper end of that one's range.
    pub and_to: &'static str,
    /// That the least value is wanted.
    pub least: &'static str,
    /// That the greatest is.
    pub greatest: &'static str,
    /// Two quantities, as an example.
    pub two: &'static str,
}

impl Spelling {
    /// The options of the program.
    pub const PROGRAM: Spelling = Spelling {
        vary: "--vary",
        from: "--from",
        to: "--to",
        and: "--and",
        and_from: "--and-from",
        and_to: "--and-to",
        least: "--least",
        greatest: "--greatest",
        two: "--vary width --and friction",
    };
}

/// Request for a design.
#[derive(Debug, Clone)]
pub struct DesignRequest {
    /// The quantity to vary.
    pub vary: String,
    /// Target that it has to reach.
    pub target: Target,
    /// Wanted end of the values that reach it.
    pub extreme: Extreme,
    /// Lower end of the range, as the case file would have it; a fifth of the present value if not given.
    pub from: Option<String>,
    /// Upper end of the range; five times the present value if not given.
    pub to: Option<String>,
    /// Names by which errors call all this.
    pub spelling: &'static Spelling,
}

impl DesignRequest {
    /// The quantity, between its ends.
    fn quantity(&self, subject: &Subject) -> Result<Quantity, DesignError> {
        let ends = Ends {
            options: [self.spelling.from, self.spelling.to],
            written: [self.from.as_deref(), self.to.as_deref()],
            spread: 5.0,
        };
        Quantity::of(&self.vary, &subject.numbers, &subject.case, &ends)
    }
}

/// Refuses a target that the case cannot be asked for.
fn answerable(target: Target, subject: &Subject) -> Result<(), DesignError> {
    let Subject { file, case, .. } = subject;
    match target {
        Target::Utilisation(_) if case.all_criteria().is_empty() && !subject.asks_of_motion() => {
            Err(DesignError::NoCriteria { target })
        }
        _ if target.asks_for_chance(case) && file.random().is_none() => {
            Err(DesignError::NothingRandom { target })
        }
        _ => Ok(()),
    }
}

/// A case that is varied.
struct Varied<'a> {
    subject: &'a Subject,
    /// True if its motion is followed.
    follows: bool,
    /// Other quantities that are held at values.
    held: &'a [(&'a Variable, f64)],
}

impl Varied<'_> {
    /// The numbers of the case at rest.
    fn inputs(&self) -> &Inputs {
        self.subject.file.inputs()
    }

    fn case(&self) -> &Case {
        &self.subject.case
    }

    fn answer(&self, variable: &Variable, value: f64) -> Result<Assessment, CaseError> {
        self.subject.answer(&self.changes(variable, value), self.follows)
    }

    /// Assessment with the probability that a target asks for.
    fn answer_for(&self, target: Target, variable: &Variable, value: f64) -> Result<Assessment, CaseError> {
        let answer = self.answer(variable, value)?;
        let asked = target.of_chance(self.case());
        match asked.is_empty() {
            false => answer.with_chance(
                &self.subject.with(&self.changes(variable, value))?,
                &asked,
                Portion::UNSEEN,
            ),
            true => Ok(answer),
        }
    }

    fn changes<'v>(&'v self, variable: &'v Variable, value: f64) -> Vec<(&'v Variable, f64)> {
        [(variable, value)].into_iter().chain(self.held.iter().copied()).collect()
    }

    /// The answer without any change, with what a target asks for.
    fn present(&self, target: Target) -> Result<Assessment, CaseError> {
        let present = self.subject.answer(&[], self.follows)?;
        let asked = target.of_chance(self.case());
        Ok(match asked.is_empty() {
            false => present.with_chance(&self.subject.file, &asked, Portion::UNSEEN)?,
            true => present,
        })
    }
}

/// SF_sliding of a situation, the least of its joints.
pub fn sliding(assessed: &Assessed) -> f64 {
    assessed.least_sliding()
}

/// SF_overturning_net of a situation, about either corner, the least of its joints.
pub fn overturning(assessed: &Assessed) -> f64 {
    assessed.least_overturning()
}

/// Up to which multiple of its variable loads a situation leaves the body at rest.
pub fn load_factor(assessed: &Assessed) -> f64 {
    assessed.departure().load_factor()
}

/// The least of a number over all situations.
pub fn least(assessment: &Assessment, of: fn(&Assessed) -> f64) -> f64 {
    of(assessment.least(of))
}

/// The largest displacement along the base at the end, of all situations; none if the body overturns in one, or its motion is not
/// followed to the end.
pub fn farthest(answer: &Assessment) -> Option<f64> {
    worst_of(answer, MotionCriterion::Slide(f64::MAX))
}

/// The largest angle of all situations; none of a body that overturns, or whose motion is not followed to the end.
pub fn steepest(answer: &Assessment) -> Option<f64> {
    if overturns(answer)? { None } else { worst_of(answer, MotionCriterion::MaxTheta(f64::MAX)) }
}

/// True if the body overturns in any situation; none if no motion was followed.
pub fn overturns(answer: &Assessment) -> Option<bool> {
    let motions = answer.in_time.as_ref().map(|in_time| &in_time.motions).filter(|all| !all.is_empty())?;
    Some(motions.iter().any(|followed| followed.outcome.overturned()))
}

fn worst_of(answer: &Assessment, criterion: MotionCriterion) -> Option<f64> {
    match answer.motion_checks_of(&[criterion]).first()?.0.value {
        MotionValue::Number(value) => Some(value),
        _ => None,
    }
}

/// The least or the greatest value that meets a target, with what it rests on.
pub struct Design {
    subject: Subject,
    /// What was asked.
    pub request: DesignRequest,
    /// The quantity that is varied.
    pub quantity: Quantity,
    /// The answer at its present value.
    pub present: Assessment,
    /// All values that meet the target.
    pub stretches: Vec<Stretch>,
    /// Index of the one that has the wanted end.
    pub at: usize,
    /// Changes of the answer with 1 % of each number.
    pub sensitivities: Vec<Sensitivity>,
}

impl Design {
    /// Designs the case of a file, as a portion of work that somebody may watch; of one in time, what asks for its motion is asked of the
    /// motion, everything else of its first instant.
    ///
    /// # Errors
    /// If the case makes no sense or lacks the quantity, or the target cannot be met, or is met without an end on the side that is
    /// wanted; if the work is stopped.
    pub fn of(file: &CaseFile, request: DesignRequest, portion: Portion<'_>) -> Result<Design, DesignError> {
        let subject = Subject::of(file)?;
        let varied = Varied { subject: &subject, follows: subject.follows(request.target)?, held: &[] };
        answerable(request.target, &subject)?;
        let quantity = request.quantity(&subject)?;
        let present = varied.present(request.target)?;
        let parts = if request.target.asks_for_chance(&subject.case) { CHANCE_PARTS } else { PARTS };
        let search = Search { varied: &varied, quantity: &quantity, target: request.target, parts };
        if request.target.asks_for_rise() && !search.rises() {
            return Err(DesignError::NothingRises { target: request.target });
        }
        let [of_search, of_changes] = portion.parts([10.0, 1.0]);
        let stretches = search.stretches(of_search)?;
        let Some(at) = request.extreme.outermost(&stretches) else {
            return Err(search.unmet(request.spelling));
        };
        if matches!(request.extreme.of(&stretches[at]).beyond, OuterState::Range) {
            return Err(no_end(&request, &quantity, &stretches[at]));
        }
        let sensitivities = sensitivity::all(&varied, Some(&present), of_changes)?;
        portion.reached(1.0);
        Ok(Design { subject, request, quantity, present, stretches, at, sensitivities })
    }

    /// The end that is wanted.
    pub fn found(&self) -> &End {
        self.request.extreme.of(&self.stretches[self.at])
    }

    /// Warnings on the value found: that the body moves though the target is met, that nothing rises where it asks for a rise, and what is
    /// unusual about the case and is not at present.
    pub fn warnings(&self) -> Vec<String> {
        let present = self.present.case.warnings();
        let new =
            self.found().answer.case.warnings().into_iter().filter(|warning| !present.contains(warning));
        let of_motion = matches!(self.request.target, Target::Motion(_));
        let moves = if of_motion { None } else { moves_though_met(&self.found().answer) };
        moves.into_iter().chain(self.unrisen()).chain(new.map(|warning| warning.to_string())).collect()
    }

    /// That of a target that asks how far the loads may rise nothing is said where none does.
    fn unrisen(&self) -> Option<String> {
        let answer = &self.found().answer;
        let still = answer.all.iter().filter(|assessed| !assessed.rises());
        let names: Vec<_> = still.filter_map(|assessed| answer.name(assessed)).collect();
        let asked = self.request.target.asks_for_rise() && !names.is_empty();
        asked.then(|| {
            format!("in {} no variable load acts: there the target is met by rest", names.join(", "))
        })
    }

    /// Notes on the numbers that go with the quantity, and on what is answered of a case in time.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = self.quantity.variable.notes(self.subject.file.inputs(), &self.present.case);
        notes.extend(self.lists_with_it());
        notes.extend(self.subject.note().as_deref().map(in_time_note));
        notes
    }

    /// What becomes of lists that go with the value found, as sentences.
    fn lists_with_it(&self) -> Vec<String> {
        let (file, variable) = (&self.subject.file, &self.quantity.variable);
        let Ok(found) = self.subject.with(&[(variable, self.found().rounded)]) else { return Vec::new() };
        let lists = moved(file.inputs(), &self.subject.case, &[variable]).into_iter();
        let lists = lists.filter_map(|id| {
            let places = found.inputs().list(id)?.iter().map(|place| format!("{} m", plain(*place)));
            Some(format!("With it {id} becomes {}.", places.collect::<Vec<_>>().join(", ")))
        });
        lists.collect()
    }
}

/// Sentence on the answer for the first instant of a case in time.
fn in_time_note(note: &str) -> String {
    format!("Factors, modes and what else is of the first instant: {note}.")
}

/// That a target is met by a body that does not stay at rest, where the worst situation is one of these.
fn moves_though_met(answer: &Assessment) -> Option<String> {
    let moving = |assessed: &Assessed| load_factor(assessed) < 1.0 || assessed.mode() != Some(Mode::Rest);
    let worst = answer.least(load_factor);
    let assessed = if moving(worst) { worst } else { answer.tried().find(|assessed| moving(assessed))? };
    let place = answer.name(assessed).filter(|_| answer.all.len() > 1);
    let place = place.map_or(String::new(), |name| format!(" in {name}"));
    let (when, verdict, clause) = match assessed.departure() {
        Departure::At { factor, verdict } if factor < 1.0 => {
            let when = format!("from {} % of the variable load on", digits(100.0 * factor));
            (when, verdict, assessed.departs())
        }
        Departure::AtOnce { verdict, permanent: true } => {
            ("under the permanent loads alone".to_owned(), verdict, assessed.departs())
        }
        Departure::AtOnce { verdict, .. } => {
            ("under any share of the variable load".to_owned(), verdict, assessed.departs())
        }
        _ => ("under the full load at once".to_owned(), assessed.verdict(), assessed.at_once()),
    };
    Some(match assessed.joints {
        Some(_) => format!("the target is met, but not by joints at rest{place}: {when} {clause}"),
        None => {
            format!("the target is met, but not by a body at rest{place}: {when} it {}", predicate(verdict))
        }
    })
}

/// That a target is met as far as the range reaches, and which option finds a boundary.
fn no_end(request: &DesignRequest, quantity: &Quantity, stretch: &Stretch) -> DesignError {
    let [from, to] = quantity.range.map(|value| quantity.shown(value));
    let spelling = request.spelling;
    let farther = match request.extreme {
        Extreme::Least => format!("{} looks farther down", spelling.from),
        Extreme::Greatest => format!("{} looks farther up", spelling.to),
    };
    let across = request.extreme.other();
    let boundary = across.of(stretch);
    let (met, help) = match boundary.beyond {
        OuterState::Range => (format!("from {from} to {to}, in the whole range"), farther),
        _ => {
            let met = match request.extreme {
                Extreme::Least => format!("from {from}, where the range begins, to {}", boundary.text),
                Extreme::Greatest => format!("from {} to {to}, where the range ends", boundary.text),
            };
            (
                met,
                format!(
                    "{} gives the boundary on the other side, {}; {farther}",
                    across.spelled(spelling),
                    boundary.text
                ),
            )
        }
    };
    let name = quantity.variable.name().to_owned();
    let (met, help) = (met.into(), help.into());
    DesignError::NoEnd { name, extreme: request.extreme, target: request.target, met, help }
}
