//! Least single changes: for each number of a case that a person can change, the change nearest to its present value with which the case is
//! satisfactory; or, of one that is, how far each may go.
//!
//! The values tried are those of a design of the same quantity, from the present one outwards, so that both find the same boundary; no more
//! are tried than it takes.

use super::quantity::{Ends, Quantity};
use super::set::{End, ExactEnd, OuterState, Search, Tried};
use super::subject::Subject;
use super::{CHANCE_PARTS, DesignError, PARTS, Spelling, Target, Varied, answerable};
use crate::assess::{Assessed, Assessment};
use crate::couple::{Variable, moved, vary};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};
use crate::rounded::Towards;
use standfast_model::CaseFile;
use standfast_watch::{Portion, Stopped};

/// Significant digits of a number that goes with the one that is changed; more where the target takes more.
const COUPLED_DIGITS: usize = 6;

/// Significant digits that tell two numbers apart.
const ALL_DIGITS: usize = 17;

/// A case whose numbers are changed one at a time.
pub struct SingleChanges {
    subject: Subject,
    follows: bool,
    /// What is asked of the case.
    pub target: Target,
    /// The answer as it is.
    pub present: Assessment,
    /// True if it meets the target as it is.
    pub is_met: bool,
    /// The numbers that a person can change, as the file has them.
    pub variables: Vec<Variable>,
}

/// The least change of a number.
pub struct SingleChange {
    /// The number.
    pub quantity: Quantity,
    /// What its change does.
    pub found: Found,
}

/// What the change of a number does.
pub enum Found {
    /// From this value on the target is met.
    Helps(Box<NewValue>),
    /// The target is met as it is, down to the one and up to the other.
    Reserve(Box<[End; 2]>),
    /// No value of its range meets the target.
    Unmet(DesignError),
}

/// A value to be put into a case.
pub struct NewValue {
    /// The end of the values that meet the target.
    pub end: End,
    /// True if that is the least of them, false if it is the greatest.
    pub is_least: bool,
    /// The text of the case with it, and with what goes with it; `None` if it cannot be written.
    pub text: Option<String>,
    /// The other numbers that are written there, with their units.
    pub coupled: Vec<(Id, String)>,
}

impl SingleChanges {
    /// The numbers of a case that can be changed, for a target; without one for its criteria, or where it has none that it rests, or in time
    /// that it does not overturn.
    ///
    /// # Errors
    /// If the case makes no sense, or has no such target.
    pub fn of(file: &CaseFile, target: Option<Target>) -> Result<SingleChanges, DesignError> {
        let widened = with_width_scale(file);
        let subject = Subject::of(widened.as_ref().unwrap_or(file))?;
        let target = target.unwrap_or_else(|| subject.own_target());
        let follows = subject.follows(target)?;
        answerable(target, &subject)?;
        let varied = Varied { subject: &subject, follows, held: &[] };
        let present = varied.present(target)?;
        if target.asks_for_rise() && !present.tried().any(Assessed::rises) {
            return Err(DesignError::NothingRises { target });
        }
        let (written, case) = subject.written();
        let inputs = written.inputs();
        let variables = Variable::all(inputs)
            .filter(|id| is_free(*id) && written.written_number(*id).is_some())
            .map(|id| Variable::of(id, inputs))
            // From nothing no step leads anywhere.
            .filter(|variable| variable.value(inputs, case) != 0.0);
        let variables = variables.collect();
        let is_met = target.is_met(&present);
        Ok(SingleChanges { follows, target, present, is_met, variables, subject })
    }

    /// The least change of a number of the case, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// If the work is stopped, or the number has no range.
    pub fn change(&self, variable: &Variable, portion: Portion<'_>) -> Result<SingleChange, DesignError> {
        let subject = &self.subject;
        let ends = Ends { options: ["", ""], written: [None, None], spread: 5.0 };
        let quantity = Quantity::of(variable.name(), &subject.numbers, &subject.case, &ends)?;
        let varied = Varied { subject, follows: self.follows, held: &[] };
        let parts = if self.target.asks_for_chance(&subject.case) { CHANCE_PARTS } else { PARTS };
        let search = Search { varied: &varied, quantity: &quantity, target: self.target, parts };
        let outwards = Outwards::of(&search, portion);
        // A value on its bound may be met as it stands, and not as it is computed anew.
        let found = match self.is_met && outwards.meets(outwards.at)? {
            true => Found::Reserve(Box::new(outwards.reserve()?)),
            false => match outwards.nearest()? {
                Ok((end, is_least)) => Found::Helps(Box::new(self.written(variable, end, is_least))),
                Err(tried) => Found::Unmet(search.why_unmet(tried, &Spelling::PROGRAM)),
            },
        };
        Ok(SingleChange { quantity, found })
    }

    /// True if each value is decided by a motion.
    pub fn follows_motions(&self) -> bool {
        self.follows
    }

    /// True if each value takes long: a motion, a probability, a base that crushes.
    pub fn is_slow(&self) -> bool {
        let crushes = self.subject.case.ground.is_some_and(|ground| ground.strength().is_some());
        self.follows || crushes || self.target.asks_for_chance(&self.subject.case)
    }

    /// Notes on the numbers that go with one.
    pub fn notes(&self, variable: &Variable) -> Vec<String> {
        variable.notes(self.subject.file.inputs(), &self.present.case)
    }

    /// A value as it is written into the text, with what goes with it in as few digits as meet the target.
    fn written(&self, variable: &Variable, end: End, is_least: bool) -> NewValue {
        let found = (COUPLED_DIGITS..=ALL_DIGITS).find_map(|count| self.written_to(variable, &end, count));
        let (text, coupled) = found.map_or((None, Vec::new()), |(text, coupled)| (Some(text), coupled));
        NewValue { end, is_least, text, coupled }
    }

    /// The same, to so many digits of what goes with it; `None` where that does not meet the target.
    fn written_to(
        &self,
        variable: &Variable,
        end: &End,
        count: usize,
    ) -> Option<(String, Vec<(Id, String)>)> {
        let (file, case) = self.subject.written();
        let mut inputs = vary(file.inputs(), case, &[(variable, end.rounded)]);
        let own = variable.id();
        let changed: Vec<(Id, f64)> = inputs
            .numbers()
            .filter(|(id, si)| *id == own || file.inputs().number(*id) != Some(*si))
            .collect();
        let (mut now, mut coupled) = (file.clone(), Vec::new());
        for (id, si) in changed {
            now = now.rewritten(id, si, |number, unit| {
                if id == own {
                    return end.text.split(' ').next()?.parse().ok();
                }
                let number = format!("{:.*e}", count - 1, number).parse().ok()?;
                let digits = crate::digits::significant(number, count);
                coupled.push((id, format!("{digits} {unit}").trim_end().to_owned()));
                Some(number)
            })?;
            // What is written is what is proven.
            inputs.set(id, now.inputs().number(id)?);
        }
        for id in moved(file.inputs(), case, &[variable]) {
            let Some(list) = inputs.list(id).filter(|list| file.inputs().list(id) != Some(*list)) else {
                continue;
            };
            let (rewritten, text) = now.relisted(id, list)?;
            now = rewritten;
            coupled.push((id, text));
            inputs.put(id, now.inputs().get(id)?.clone());
        }
        self.meets(inputs).then(|| (now.text().to_owned(), coupled))
    }

    fn meets(&self, inputs: Inputs) -> bool {
        let chance = self.target.of_chance(&self.subject.case);
        let answer = self.subject.answer_as_written(inputs, self.follows, &chance);
        answer.is_ok_and(|answer| self.target.is_met(&answer))
    }
}

/// The file of a section of parts with the factor on its widths written, where that is silent: all of them together are a number that a person
/// can change.
fn with_width_scale(file: &CaseFile) -> Option<CaseFile> {
    let id = Id::from(Key::WidthScale);
    let is_silent = file.inputs().has(Table::Part) && file.inputs().get(id).is_none();
    file.reread(&file.with_line(id, "1").filter(|_| is_silent)?).ok()
}

/// True of a number that a person can change: no constant of nature, of a place or of a formula, nothing that goes with another number, and no part
/// alone, which would leave a gap.
fn is_free(id: Id) -> bool {
    use Key::{
        BlockGravity, BuoyantWeight, CaissonWidth, EnvelopeCoupling, EnvelopeHorizontal, EnvelopeMoment,
        Gravity, HistoryStart, JointElevation, KineticFriction, Lambda1, Lambda2, Lambda3, MomentOfInertia,
        MuImpact, MuK, PartDensity, PartDensityBelow, PartUnitWeight, Phase, RecordStep, SeaBottomSlope,
        TMax, TurnDeg, WaterDensity, WaterDepth, WaterMass, WaveWaterDensity, WeightArm,
    };
    let bound = matches!(
        id.key,
        Gravity
            | BlockGravity
            | WaterDensity
            | WaveWaterDensity
            | WaterDepth
            | WaterMass
            | SeaBottomSlope
            | TurnDeg
            | Lambda1
            | Lambda2
            | Lambda3
            | EnvelopeHorizontal
            | EnvelopeMoment
            | EnvelopeCoupling
            | CaissonWidth
            | JointElevation
            | BuoyantWeight
            | WeightArm
            | MomentOfInertia
            | KineticFriction
            | MuK
            | MuImpact
            | TMax
            | HistoryStart
            | Phase
            | RecordStep
    );
    !bound && (id.table != Table::Part || matches!(id.key, PartDensity | PartDensityBelow | PartUnitWeight))
}

/// Values of a search, from the present one outwards.
struct Outwards<'a> {
    search: &'a Search<'a>,
    samples: Vec<f64>,
    /// The place of the present value among them.
    at: usize,
    portion: Portion<'a>,
}

impl<'a> Outwards<'a> {
    fn of(search: &'a Search<'a>, portion: Portion<'a>) -> Outwards<'a> {
        let samples = search.samples();
        let distance = |value: f64| (value - search.quantity.present).abs();
        let at =
            (0..samples.len()).min_by(|one, two| distance(samples[*one]).total_cmp(&distance(samples[*two])));
        Outwards { search, samples, at: at.unwrap_or(0), portion }
    }

    fn distance(&self, place: usize) -> f64 {
        (self.samples[place] - self.search.quantity.present).abs()
    }

    fn meets(&self, place: usize) -> Result<bool, Stopped> {
        self.portion.check()?;
        Ok(self.search.attempt(self.samples[place]).met)
    }

    /// The next place from one on, upwards or downwards.
    fn next(&self, place: usize, up: bool) -> Option<usize> {
        if up { Some(place + 1).filter(|next| *next < self.samples.len()) } else { place.checked_sub(1) }
    }

    /// The end nearest to the present value of the values that meet the target, and whether it is the least of its stretch; or what was
    /// tried.
    fn nearest(&self) -> Result<Result<(End, bool), Tried>, Stopped> {
        let mut tried = Tried::default();
        let mut ends = [self.next(self.at, false), self.next(self.at, true)];
        let steps = self.portion.steps(self.samples.len());
        tried.add(self.search.attempt(self.samples[self.at]), self.search.target);
        loop {
            let nearer = match ends {
                [None, None] => return Ok(Err(tried)),
                [Some(_), None] => 0,
                [None, Some(_)] => 1,
                [Some(down), Some(up)] => usize::from(self.distance(up) < self.distance(down)),
            };
            let Some(place) = ends[nearer] else { return Ok(Err(tried)) };
            self.portion.check()?;
            steps.advance();
            let trial = self.search.attempt(self.samples[place]);
            if !trial.met {
                tried.add(trial, self.search.target);
                ends[nearer] = self.next(place, nearer == 1);
                continue;
            }
            let found = self.end(place, nearer == 1)?;
            // On the other side the next value tried lies farther away, but its boundary may be nearer.
            if let Some(other) = ends[1 - nearer]
                && self.meets(other)?
            {
                let end = self.end(other, nearer == 0)?;
                let far = |end: &End| (end.value - self.search.quantity.present).abs();
                if far(&end) < far(&found) {
                    return Ok(Ok((end, nearer == 0)));
                }
            }
            return Ok(Ok((found, nearer == 1)));
        }
    }

    /// The inner end of a stretch, of which a place is the first that was found, above the present value or below it.
    fn end(&self, place: usize, up: bool) -> Result<End, Stopped> {
        /// So many values farther out no rounding reaches.
        const FAR: usize = 2;
        let inner = self.next(place, !up).map(|inner| self.samples[inner]);
        let found = self.search.boundary(inner, self.samples[place], Portion::UNSEEN)?;
        let other = self.last_met(place, up, FAR)?.meets;
        Ok(self.search.end(&found, if up { Towards::More } else { Towards::Less }, other))
    }

    /// The outermost value that meets the target, from a place that does on, upwards or downwards, and not farther than so many places.
    fn last_met(&self, mut place: usize, up: bool, most: usize) -> Result<ExactEnd, Stopped> {
        for _ in 0..most {
            let Some(next) = self.next(place, up) else { break };
            if !self.meets(next)? {
                return self.search.boundary(Some(self.samples[next]), self.samples[place], Portion::UNSEEN);
            }
            place = next;
        }
        Ok(ExactEnd { meets: self.samples[place], fails: None })
    }

    /// How far down and up the target is met.
    fn reserve(&self) -> Result<[End; 2], Stopped> {
        let present = self.samples[self.at];
        let end = |up: bool| {
            let exact = self.last_met(self.at, up, self.samples.len())?;
            Ok(self.search.end(&exact, if up { Towards::Less } else { Towards::More }, present))
        };
        Ok([end(false)?, end(true)?])
    }
}

impl SingleChange {
    /// The relative change that helps, or that is left at least; `None` of a number that does not help, or on which nothing hangs.
    pub fn share(&self) -> Option<f64> {
        let share = |end: &End| end.rounded / self.quantity.present - 1.0;
        match &self.found {
            Found::Helps(new) => Some(share(&new.end)),
            Found::Reserve(_) => self.limit().map(share),
            Found::Unmet(_) => None,
        }
    }

    /// The nearest end of a reserve beyond which the target is not met; `None` where only the range ends, or what makes a case.
    pub fn limit(&self) -> Option<&End> {
        let Found::Reserve(ends) = &self.found else { return None };
        let far = |end: &End| (end.value - self.quantity.present).abs();
        let limits = ends.iter().filter(|end| matches!(end.beyond, OuterState::Fails(..)));
        limits.min_by(|one, two| far(one).total_cmp(&far(two)))
    }
}
