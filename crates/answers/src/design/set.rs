//! For which values of a quantity is a target met? Stretches of values, each with both of its ends.
//!
//! The range is sampled, and every change between two samples halved down to a boundary: a stretch or a gap narrower than a
//! sample's distance may be missed, and nothing else is. An end that is printed is rounded into its stretch, read again as it is
//! printed, and assessed so.

use super::quantity::{DIGITS, Quantity, with_unit};
use super::target::{Binding, Target};
use super::{DesignError, Spelling, Varied, least, load_factor, overturning, sliding};
use crate::assess::{Assessed, Assessment};
use crate::digits::digits;
use crate::error::CaseError;
use crate::rounded::{Decimal, Towards};
use standfast_watch::{Portion, Stopped};

/// Relative distance of an end from a value that does not meet the target.
const NEAR: f64 = 1e-12;

/// Relative distance where each value takes a probability, which is not exact either.
const NEAR_OF_CHANCE: f64 = 1e-8;

/// Number of digits that a number has at most if it is no shorter than it has to be.
const ALL_DIGITS: usize = 17;

/// Values that are tried, about, until both ends of a stretch are found.
const HALVINGS: f64 = 80.0;

/// Search for the values that meet a target.
pub(super) struct Search<'a> {
    pub(super) varied: &'a Varied<'a>,
    pub(super) quantity: &'a Quantity,
    pub(super) target: Target,
    /// Into how many parts the range is cut.
    pub(super) parts: u32,
}

/// Neighbouring values of the range that all meet the target.
#[derive(Debug)]
pub struct Stretch {
    /// Its least value.
    pub least: End,
    /// Its greatest.
    pub greatest: End,
}

/// An end of a stretch.
#[derive(Debug)]
pub struct End {
    /// The outermost value that meets the target, at full precision.
    pub value: f64,
    /// The value that is printed: of a few digits, inside the stretch.
    pub rounded: f64,
    /// Printed value, with its unit.
    pub text: String,
    /// Assessment of the printed value.
    pub answer: Assessment,
    /// State just beyond.
    pub beyond: OuterState,
}

/// State just beyond an end.
#[derive(Debug)]
pub enum OuterState {
    /// It is an end of the range.
    Range,
    /// The target fails at this value.
    Fails(String, Binding),
    /// At this value the case makes no sense: in words, why.
    NoCase(String, String),
}

impl OuterState {
    /// Failure, in a sentence without its stop; `None` at an end of the range.
    pub fn words(&self) -> Option<String> {
        match self {
            OuterState::Range => None,
            OuterState::Fails(at, binding) => Some(format!("at {at}, {}", binding.words())),
            OuterState::NoCase(at, why) => Some(format!("at {at} the case makes no sense: {why}")),
        }
    }

    /// Failure as [`words`](OuterState::words) has it, without the condition that fails.
    pub fn brief(&self) -> Option<String> {
        match self {
            OuterState::Fails(at, binding) => Some(format!("at {at}, {}", binding.brief)),
            _ => self.words(),
        }
    }

    /// Failure, in a word; nothing at an end of the range.
    pub fn by(&self) -> Option<&'static str> {
        match self {
            OuterState::Range => None,
            OuterState::Fails(_, binding) => Some(binding.by),
            OuterState::NoCase(..) => Some("no case"),
        }
    }
}

/// A value with what it comes to, or why it does not.
pub(super) struct Trial {
    value: f64,
    pub(super) answer: Result<Assessment, CaseError>,
    pub(super) met: bool,
}

/// Values that were tried and do not meet the target.
#[derive(Default)]
pub(super) struct Tried {
    /// The one that comes nearest, the first of several, with its score.
    best: Option<(f64, Trial)>,
    /// The score of the one that is farthest from it.
    worst: Option<f64>,
    /// The first that makes no case, and why.
    refused: Option<(f64, String)>,
    count: usize,
}

impl Tried {
    pub(super) fn add(&mut self, trial: Trial, target: Target) {
        self.count += 1;
        match &trial.answer {
            Ok(answer) => {
                let score = target.score(answer);
                self.worst = Some(self.worst.map_or(score, |worst| worst.min(score)));
                if self.best.as_ref().is_none_or(|(best, _)| score > *best) {
                    self.best = Some((score, trial));
                }
            }
            Err(refused) => {
                self.refused.get_or_insert_with(|| (trial.value, refused.to_string()));
            }
        }
    }
}

/// An end before it is rounded: the outermost value that meets the target, and one beyond that does not.
pub(super) struct ExactEnd {
    pub(super) meets: f64,
    pub(super) fails: Option<f64>,
}

impl Search<'_> {
    /// The stretches, from the least values on.
    ///
    /// # Errors
    /// If the portion is stopped.
    pub(super) fn stretches(&self, portion: Portion<'_>) -> Result<Vec<Stretch>, Stopped> {
        let samples = self.samples();
        let [of_samples, of_ends] = portion.parts([samples.len() as f64, HALVINGS]);
        let steps = of_samples.steps(samples.len());
        let is_met = |value: &f64| {
            portion.check()?;
            let met = self.attempt(*value).met;
            steps.advance();
            Ok(met)
        };
        let met: Vec<bool> = samples.iter().map(is_met).collect::<Result<_, Stopped>>()?;
        let runs = met.chunk_by(|one, next| one == next);
        let ends = runs.scan(0, |begin, run| {
            let here = *begin..*begin + run.len();
            *begin = here.end;
            Some((run[0], here))
        });
        let stretch = |here: std::ops::Range<usize>, portion: Portion<'_>| {
            let [of_least, of_greatest] = portion.parts([1.0, 1.0]);
            let before = here.start.checked_sub(1).map(|before| samples[before]);
            let least = self.boundary(before, samples[here.start], of_least)?;
            let greatest =
                self.boundary(samples.get(here.end).copied(), samples[here.end - 1], of_greatest)?;
            let (from, to) = (least.meets, greatest.meets);
            Ok(Stretch {
                least: self.end(&least, Towards::More, to),
                greatest: self.end(&greatest, Towards::Less, from),
            })
        };
        let ends: Vec<_> = ends.filter(|(met, _)| *met).collect();
        let count = ends.len();
        let places = ends.into_iter().enumerate();
        places.map(|(place, (_, here))| stretch(here, of_ends.part(place, count))).collect()
    }

    /// The values tried first, rising; among them the present one, where it is in the range.
    pub(super) fn samples(&self) -> Vec<f64> {
        let Quantity { range: [from, to], present, .. } = *self.quantity;
        let share = |i: u32| f64::from(i) / f64::from(self.parts);
        let mut samples: Vec<f64> = (0..=self.parts).map(|i| from + (to - from) * share(i)).collect();
        if from < present && present < to {
            samples.push(present);
        }
        samples.sort_by(f64::total_cmp);
        samples.dedup();
        samples
    }

    pub(super) fn attempt(&self, value: f64) -> Trial {
        let answer = self.varied.answer_for(self.target, &self.quantity.variable, value);
        let met = answer.as_ref().is_ok_and(|answer| self.target.is_met(answer));
        Trial { value, answer, met }
    }

    /// Brings a value that fails, if there is one, and one that meets the target together.
    pub(super) fn boundary(
        &self,
        fails: Option<f64>,
        meets: f64,
        portion: Portion<'_>,
    ) -> Result<ExactEnd, Stopped> {
        let near = if self.target.asks_for_chance(self.varied.case()) { NEAR_OF_CHANCE } else { NEAR };
        self.halved(fails, meets, near, portion)
    }

    /// The same, to a relative distance.
    pub(super) fn halved(
        &self,
        fails: Option<f64>,
        mut meets: f64,
        near: f64,
        portion: Portion<'_>,
    ) -> Result<ExactEnd, Stopped> {
        let Some(mut fails) = fails else { return Ok(ExactEnd { meets, fails }) };
        let near = near * self.size_at(meets);
        let halvings = ((meets - fails).abs() / near).log2().ceil().max(1.0);
        let steps = portion.steps(halvings as usize);
        while (meets - fails).abs() > near {
            portion.check()?;
            let middle = fails + (meets - fails) / 2.0;
            if self.attempt(middle).met {
                meets = middle
            } else {
                fails = middle
            }
            steps.advance();
        }
        Ok(ExactEnd { meets, fails: Some(fails) })
    }

    /// What distances from a value are counted in: near zero, the size of the range.
    fn size_at(&self, value: f64) -> f64 {
        let [from, to] = self.quantity.range;
        value.abs().max(1e-3 * from.abs().max(to.abs()))
    }

    /// An end rounded `inwards`, not beyond the other end of its stretch, in as few digits from four on as it takes to meet the
    /// target: what is printed is read again and assessed.
    pub(super) fn end(&self, found: &ExactEnd, inwards: Towards, other: f64) -> End {
        let Quantity { variable, .. } = self.quantity;
        let is_inside = |value: f64| match inwards {
            Towards::More => value <= other,
            Towards::Less => value >= other,
        };
        let end = (DIGITS..=ALL_DIGITS).find_map(|count| {
            // It is rounded in the unit that is printed.
            let number = self.quantity.of_si(found.meets);
            let rounded = self.tight(Decimal::of(number, count, inwards), found, inwards.other());
            let in_si = |decimal: Decimal| self.quantity.in_si(decimal.value());
            let text = with_unit(in_si(rounded), variable, count);
            let value =
                variable.read(&text, &self.varied.subject.numbers).ok().filter(|value| is_inside(*value))?;
            let trial = self.attempt(value);
            let answer = trial.answer.ok().filter(|_| trial.met)?;
            let beyond = match found.fails {
                None => OuterState::Range,
                Some(fails) => self.beyond(fails, in_si(rounded.next(inwards.other())), count),
            };
            // A short number between the two last values tried, 4 beside 4.000000000003, is the boundary as far as it is known.
            let outermost = match inwards {
                Towards::More => value.min(found.meets),
                Towards::Less => value.max(found.meets),
            };
            Some(End { value: outermost, rounded: value, text, answer, beyond })
        });
        end.expect("all digits of a value that meets the target meet it")
    }

    /// One digit less, where the boundary is known to lie farther out only and that meets the target, too.
    fn tight(&self, rounded: Decimal, found: &ExactEnd, outwards: Towards) -> Decimal {
        let next = rounded.next(outwards);
        let value = self.quantity.in_si(next.value());
        let is_between = found.fails.is_some_and(|fails| match outwards {
            Towards::Less => fails < value,
            Towards::More => value < fails,
        });
        if is_between && self.attempt(value).met { next } else { rounded }
    }

    /// Reason why the nearest value that was tried beyond an end does not meet the target; said of the next printed value where that fails
    /// by the same.
    fn beyond(&self, fails: f64, next: f64, count: usize) -> OuterState {
        let why = |trial: Trial, count: usize| {
            let at = with_unit(trial.value, &self.quantity.variable, count);
            match trial.answer {
                Ok(answer) => OuterState::Fails(at, self.target.binding(&answer)),
                Err(error) => OuterState::NoCase(at, error.to_string()),
            }
        };
        let nearest = why(self.attempt(fails), ALL_DIGITS);
        let next = Some(self.attempt(next)).filter(|next| !next.met).map(|next| why(next, count));
        next.filter(|next| next.by() == nearest.by()).unwrap_or(nearest)
    }

    /// True if a variable load acts at any value that is tried.
    pub(super) fn rises(&self) -> bool {
        let rises = |answer: &Assessment| answer.tried().any(Assessed::rises);
        self.samples().into_iter().any(|value| self.attempt(value).answer.is_ok_and(|answer| rises(&answer)))
    }

    /// Failure that binds, in a word, where the target is nearest to be met.
    pub(super) fn nearest(&self) -> Option<&'static str> {
        let answers = self.samples().into_iter().filter_map(|value| self.attempt(value).answer.ok());
        let best = answers.max_by(|one, other| self.target.score(one).total_cmp(&self.target.score(other)));
        best.map(|answer| self.target.binding(&answer).by)
    }

    /// Reason why no value meets the target.
    pub(super) fn unmet(&self, spelling: &'static Spelling) -> DesignError {
        let mut tried = Tried::default();
        self.samples().into_iter().for_each(|value| tried.add(self.attempt(value), self.target));
        self.why_unmet(tried, spelling)
    }

    /// Reason why no value meets the target, from those that were tried.
    pub(super) fn why_unmet(&self, tried: Tried, spelling: &'static Spelling) -> DesignError {
        let Tried { best, worst, refused: error, count } = tried;
        let (name, target) = (self.quantity.variable.name().to_owned(), self.target);
        let range = self.quantity.range_words();
        let Some((score, Trial { value, answer: Ok(answer), .. })) = best else {
            let (at, why) = error.unwrap_or_default();
            return DesignError::NoCase { name, range, at: self.quantity.shown(at), why, spelling };
        };
        let binding = target.binding(&answer).words();
        // The same but for rounding.
        let worst = worst.unwrap_or(score);
        if score - worst <= 1e-9 * score.abs() || score == worst {
            return DesignError::NoInfluence { name, target, binding };
        }
        let reached = match target {
            Target::Criterion(_) | Target::Utilisation(_) | Target::Motion(_) => format!("where {binding}"),
            _ => format!(
                "with safety factors {} and {}, leaving rest at {} times the load",
                digits(least(&answer, sliding)),
                digits(least(&answer, overturning)),
                digits(least(&answer, load_factor)),
            ),
        };
        let best = format!("the best of {count} values tried is {}, {reached}", self.quantity.shown(value));
        DesignError::Unmet { name, range: range.into(), target, best: best.into(), spelling }
    }
}
