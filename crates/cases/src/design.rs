//! Design: for which values of a quantity is a target met, which of them is the least or the greatest, and what does every
//! number of a case do to its safety?
//!
//! Nothing is linearised or scaled: for each value tried, everything that follows from it, waves and water included, is computed
//! anew from the typed inputs. What is printed is rounded to the safe side, read again as it is printed, and assessed so.

mod boundary;
mod error;
mod json;
mod quantity;
mod sensitivity;
mod set;
mod target;
mod text;

pub use boundary::{Boundary, BoundaryRequest};
pub use error::DesignError;
pub use sensitivity::{Change, Sensitivity, sensitivities};
pub use target::{Target, TargetError};

use std::fmt;

use crate::assess::verdict::predicate;
use crate::assess::{Assessed, Assessment, InTime};
use crate::case::Case;
use crate::couple::{Variable, vary};
use crate::inputs::Inputs;
use crate::layout::digits;
use crate::motion::{BodyCaseError, Follow, MotionCriterion, MotionValue, Timed};
use crate::parse::CaseFile;
use quantity::{Ends, Quantity};
use set::{Beyond, End, Search, Stretch};
use standfast::Mode;
use standfast::ground::GroundDeparture;

/// How many parts a range is cut into to find where a target is met.
const PARTS: u32 = 400;

/// The same for a target that asks for a probability, each of which takes long.
const CHANCE_PARTS: u32 = 24;

/// Which end of the values that meet a target is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extreme {
    /// The least of them all.
    #[default]
    Least,
    /// The greatest of them all.
    Greatest,
}

impl Extreme {
    /// The end on the other side.
    fn other(self) -> Extreme {
        match self {
            Extreme::Least => Extreme::Greatest,
            Extreme::Greatest => Extreme::Least,
        }
    }

    /// What asks for it.
    fn spelled(self, spelling: &Spelling) -> &'static str {
        match self {
            Extreme::Least => spelling.least,
            Extreme::Greatest => spelling.greatest,
        }
    }

    /// The end of a stretch.
    fn of(self, stretch: &Stretch) -> &End {
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

/// What a user writes for the parts of a request, so that an error calls them what they were called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spelling {
    /// The quantity to vary.
    pub vary: &'static str,
    /// Where it begins.
    pub from: &'static str,
    /// Where it ends.
    pub to: &'static str,
    /// Another quantity.
    pub and: &'static str,
    /// Where that begins.
    pub and_from: &'static str,
    /// Where that ends.
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

/// What to design.
#[derive(Debug, Clone)]
pub struct Request {
    /// The quantity to vary.
    pub vary: String,
    /// What it has to reach.
    pub target: Target,
    /// Which end of the values that do is wanted.
    pub extreme: Extreme,
    /// Where to begin, as the case file would have it; a fifth of the present value if not given.
    pub from: Option<String>,
    /// Where to end; five times the present value if not given.
    pub to: Option<String>,
    /// What errors call all this.
    pub spelling: &'static Spelling,
}

impl Request {
    /// The quantity, between its ends.
    fn quantity(&self, file: &CaseFile, case: &Case) -> Result<Quantity, DesignError> {
        let ends = Ends {
            options: [self.spelling.from, self.spelling.to],
            written: [self.from.as_deref(), self.to.as_deref()],
            spread: 5.0,
        };
        Quantity::of(&self.vary, file.inputs(), case, &ends)
    }

    /// Refuses a target that the case cannot be asked for.
    fn answerable(&self, file: &CaseFile, case: &Case, timed: Option<&Timed<'_>>) -> Result<(), DesignError> {
        let asks = timed.is_some_and(|timed| !timed.criteria().is_empty());
        match self.target {
            target @ Target::Utilisation(_) if case.criteria.is_empty() && !asks => {
                Err(DesignError::NoCriteria { target })
            }
            target if target.asks_for_chance(case) && file.random().is_none() => {
                Err(DesignError::NothingRandom { target })
            }
            _ => Ok(()),
        }
    }
}

/// A case whose motion is followed for each value that is tried.
struct Moving<'a> {
    timed: &'a Timed<'a>,
    /// The case without peaks of the base in place of its motion.
    case: Case,
}

impl<'a> Moving<'a> {
    /// Of a target that asks for the motion; `None` of another.
    fn of(target: Target, timed: Option<&'a Timed<'a>>) -> Result<Option<Moving<'a>>, DesignError> {
        let Some(timed) = timed else {
            return match target {
                Target::Motion(criterion) => Err(DesignError::NotInTime { name: criterion.name() }),
                _ => Ok(None),
            };
        };
        let asks = match target {
            Target::Motion(_) => true,
            Target::Utilisation(_) => !timed.criteria().is_empty(),
            _ => false,
        };
        Ok(if asks { Some(Moving { timed, case: timed.moving().case()? }) } else { None })
    }

    /// The motion in every situation, with numbers changed.
    fn in_time(&self, changes: &[(&Variable, f64)]) -> Result<InTime, BodyCaseError> {
        let file = self.timed.moving();
        let case = || {
            let inputs = vary(file.inputs(), &self.case, changes);
            Case::of(&inputs).map_err(|fault| file.error(fault))
        };
        let motions = self.timed.follow_case(&case, &Follow::default())?;
        let (note, criteria) = (self.timed.note().to_owned(), self.timed.criteria().to_vec());
        Ok(InTime { note, criteria, motions })
    }
}

/// A case that is varied.
struct Varied<'a> {
    file: &'a CaseFile,
    case: &'a Case,
    /// Its motion, where that is asked for.
    moving: Option<&'a Moving<'a>>,
    /// Another quantity that is held at a value.
    held: Option<(&'a Variable, f64)>,
}

impl Varied<'_> {
    fn inputs(&self) -> &Inputs {
        self.file.inputs()
    }

    fn answer(&self, variable: &Variable, value: f64) -> Result<Assessment, BodyCaseError> {
        let (inputs, changes) = self.varied(variable, value);
        let case = Case::of(&inputs).map_err(|fault| self.file.error(fault))?;
        self.assess(case, &changes)
    }

    /// The same with the probability that a target asks for.
    fn answer_for(
        &self,
        target: Target,
        variable: &Variable,
        value: f64,
    ) -> Result<Assessment, BodyCaseError> {
        let answer = self.answer(variable, value)?;
        match target.asks_for_chance(self.case) {
            true => Ok(answer.with_chance(&self.file.with_inputs(self.varied(variable, value).0))?),
            false => Ok(answer),
        }
    }

    fn varied<'v>(&'v self, variable: &'v Variable, value: f64) -> (Inputs, Vec<(&'v Variable, f64)>) {
        let changes: Vec<_> = [(variable, value)].into_iter().chain(self.held).collect();
        (vary(self.inputs(), self.case, &changes), changes)
    }

    /// The answer without any change, with what a target asks for.
    fn present(&self, target: Target) -> Result<Assessment, BodyCaseError> {
        let present = self.assess(self.case.clone(), &[])?;
        Ok(if target.asks_for_chance(self.case) { present.with_chance(self.file)? } else { present })
    }

    fn assess(&self, case: Case, changes: &[(&Variable, f64)]) -> Result<Assessment, BodyCaseError> {
        let mut answer = Assessment::owning(case).map_err(|error| self.file.refused(error))?;
        answer.in_time = self.moving.map(|moving| moving.in_time(changes)).transpose()?;
        Ok(answer)
    }
}

/// SF_sliding of a situation.
fn sliding(assessed: &Assessed) -> f64 {
    assessed.outcome.stability.sliding
}

/// SF_overturning of a situation, about either corner.
fn overturning(assessed: &Assessed) -> f64 {
    assessed.outcome.stability.overturning()
}

/// Up to which multiple of its variable loads a situation leaves the body at rest.
fn load_factor(assessed: &Assessed) -> f64 {
    assessed.departure().load_factor()
}

/// The least of a number over all situations.
fn least(assessment: &Assessment, of: fn(&Assessed) -> f64) -> f64 {
    of(assessment.least(of))
}

/// The largest displacement along the base at the end, of all situations; none if the body overturns in one, or its motion is not
/// followed to the end.
fn farthest(answer: &Assessment) -> Option<f64> {
    worst_of(answer, MotionCriterion::Slide(f64::MAX))
}

/// The largest angle of all situations; none of a body that overturns, or whose motion is not followed to the end.
fn steepest(answer: &Assessment) -> Option<f64> {
    if overturns(answer)? { None } else { worst_of(answer, MotionCriterion::MaxTheta(f64::MAX)) }
}

/// Whether the body overturns in any situation; none if no motion was followed.
fn overturns(answer: &Assessment) -> Option<bool> {
    let motions = answer.in_time.as_ref().map(|in_time| &in_time.motions).filter(|all| !all.is_empty())?;
    Some(motions.iter().any(|(_, followed)| followed.outcome.overturned()))
}

fn worst_of(answer: &Assessment, criterion: MotionCriterion) -> Option<f64> {
    match answer.motion_checks_of(&[criterion]).first()?.0.value {
        MotionValue::Number(value) => Some(value),
        _ => None,
    }
}

/// The least or the greatest value that meets a target, with what it rests on.
pub struct Design<'a> {
    file: &'a CaseFile,
    request: Request,
    quantity: Quantity,
    present: Assessment,
    /// All values that meet the target.
    stretches: Vec<Stretch>,
    /// Which of them has the end that is wanted.
    at: usize,
    sensitivities: Vec<Sensitivity>,
    /// Of a case in time, what is answered of its first instant.
    note: Option<String>,
}

impl<'a> Design<'a> {
    /// Designs the case of a file.
    ///
    /// # Errors
    /// If the case makes no sense or lacks the quantity, or the target cannot be met, or is met without an end on the side that is
    /// wanted.
    pub fn of(file: &'a CaseFile, request: Request) -> Result<Design<'a>, DesignError> {
        Design::in_time(file, None, request)
    }

    /// Designs a case in time: what asks for its motion is asked of the motion, everything else of its first instant.
    ///
    /// # Errors
    /// As [`of`](Design::of), and if the motion cannot be followed.
    pub fn of_timed(timed: &'a Timed<'a>, request: Request) -> Result<Design<'a>, DesignError> {
        Design::in_time(timed.still(), Some(timed), request)
    }

    fn in_time(
        file: &'a CaseFile,
        timed: Option<&'a Timed<'a>>,
        request: Request,
    ) -> Result<Design<'a>, DesignError> {
        let case = file.case()?;
        let moving = Moving::of(request.target, timed)?;
        let varied = Varied { file, case: &case, moving: moving.as_ref(), held: None };
        request.answerable(file, &case, timed)?;
        let quantity = request.quantity(file, &case)?;
        let present = varied.present(request.target)?;
        let parts = if request.target.asks_for_chance(&case) { CHANCE_PARTS } else { PARTS };
        let search = Search { varied: &varied, quantity: &quantity, target: request.target, parts };
        if request.target.asks_for_rise() && !search.rises() {
            return Err(DesignError::NothingRises { target: request.target });
        }
        let stretches = search.stretches();
        let Some(at) = request.extreme.outermost(&stretches) else {
            return Err(search.unmet(request.spelling));
        };
        if matches!(request.extreme.of(&stretches[at]).beyond, Beyond::Range) {
            return Err(no_end(&request, &quantity, &stretches[at]));
        }
        let sensitivities = sensitivity::all(&varied, Some(&present));
        let note = timed.map(|timed| timed.note().to_owned());
        Ok(Design { file, request, quantity, present, stretches, at, sensitivities, note })
    }

    /// The end that is wanted.
    fn found(&self) -> &End {
        self.request.extreme.of(&self.stretches[self.at])
    }

    /// What is to be minded of the value found: that the body moves though the target is met, that nothing rises where it asks for
    /// a rise, and what is unusual about the case and is not at present.
    fn warnings(&self) -> Vec<String> {
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

    fn notes(&self) -> Vec<String> {
        let mut notes = self.quantity.variable.notes(self.file.inputs(), &self.present.case);
        notes.extend(self.note.as_deref().map(in_time_note));
        notes
    }

    /// The design for reading.
    pub fn text(&self) -> String {
        text::render(self)
    }

    /// The design as one JSON document, at full precision.
    pub fn json(&self) -> String {
        json::render(self)
    }
}

/// What is answered of the first instant of a case in time, as a sentence.
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
    let (when, verdict) = match assessed.departure() {
        GroundDeparture::At { factor, verdict } if factor < 1.0 => {
            (format!("from {} % of the variable load on", digits(100.0 * factor)), verdict)
        }
        GroundDeparture::AtOnce { verdict, permanent: true } => {
            ("under the permanent loads alone".to_owned(), verdict)
        }
        GroundDeparture::AtOnce { verdict, .. } => {
            ("under any share of the variable load".to_owned(), verdict)
        }
        _ => ("under the full load at once".to_owned(), assessed.verdict()),
    };
    Some(format!("the target is met, but not by a body at rest{place}: {when} it {}", predicate(verdict)))
}

/// That a target is met as far as the range reaches, and which option finds a boundary.
fn no_end(request: &Request, quantity: &Quantity, stretch: &Stretch) -> DesignError {
    let [from, to] = quantity.range.map(|value| quantity.shown(value));
    let spelling = request.spelling;
    let farther = match request.extreme {
        Extreme::Least => format!("{} looks farther down", spelling.from),
        Extreme::Greatest => format!("{} looks farther up", spelling.to),
    };
    let across = request.extreme.other();
    let boundary = across.of(stretch);
    let (met, help) = match boundary.beyond {
        Beyond::Range => (format!("from {from} to {to}, in the whole range"), farther),
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
    DesignError::NoEnd { name, extreme: request.extreme, target: request.target, met, help }
}
