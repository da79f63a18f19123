//! Criteria of a case: required factors, allowable pressures, modes not allowed, and how far a body may move.
//!
//! A criterion is a result with a bound, or the modes that are not allowed.

use std::fmt;

use standfast::{Mode, Modes};

use crate::digits::{digits, plain};
use crate::error::{Fault, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Key, MOTION_CRITERIA, Table};
use crate::units::ShownUnit;
use standfast_inputs::OutputUnits;

/// Criterion on a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criterion {
    /// The key under which it is asked; its name is that of the result, with `_max` behind it for one of the ground.
    pub key: Key,
    /// The bound.
    pub bound: Bound,
    /// The slide, m, of which the probability that it is exceeded is asked for; `None` of all others.
    pub over: Option<f64>,
    /// Units and digits in which it is read.
    pub output: OutputUnits,
}

/// The bound of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// It has to be at least this, in SI units.
    AtLeast(f64),
    /// It has to be at most this, in SI units.
    AtMost(f64),
    /// The body may take up none of these modes under the full load.
    NoneOf(Modes),
}

/// Criterion on a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionCriterion {
    /// The displacement along the base at the end is this at most, to either side.
    Slide(f64),
    /// |θ| is this at most, in radians.
    MaxTheta(f64),
    /// The body does not overturn.
    NotOverturned,
    /// The share of copies that overturn is this at most, at the upper end of its interval.
    OverturnedShare(f64),
}

/// Criteria on a number that has to be at least the bound; all others have to be at most that.
const AT_LEAST: [Key; 8] = [
    Key::LeastSliding,
    Key::LeastOverturningNet,
    Key::LeastOverturningGross,
    Key::LeastUplift,
    Key::LeastContact,
    Key::LeastGround,
    Key::LeastLoadFactor,
    Key::LeastLifeIndex,
];

/// Criteria that ask for a probability, or a mean over chance.
const OF_CHANCE: [Key; 6] = [
    Key::GreatestNotRest,
    Key::GreatestLife,
    Key::GreatestAny,
    Key::LeastLifeIndex,
    Key::GreatestMeanSlide,
    Key::GreatestSlidingOver,
];

impl Criterion {
    /// The criteria of a case.
    pub(crate) fn all(inputs: &Inputs) -> Vec<Criterion> {
        Table::Criteria
            .keys()
            .filter_map(|key| Some((key, inputs.get(key)?)))
            .flat_map(|(key, value)| Criterion::each_of(key, value, inputs.output()))
            .collect()
    }

    /// The criteria of a value under a key of `[criteria]`, read in these units: one, or of slides one for each; none if the key is none of
    /// these.
    pub fn each_of(key: Key, value: &Value, output: OutputUnits) -> Vec<Criterion> {
        match value {
            Value::Numbers(numbers) if key == Key::GreatestSlidingOver => {
                let each = numbers.chunks_exact(2).map(|pair| Criterion {
                    key,
                    bound: Bound::AtMost(pair[1]),
                    over: Some(pair[0]),
                    output,
                });
                each.collect()
            }
            _ => Criterion::of(key, value, output).into_iter().collect(),
        }
    }

    /// The criterion of a value under a key of `[criteria]`, read in these units; `None` if the key is none of these, or has several.
    pub fn of(key: Key, value: &Value, output: OutputUnits) -> Option<Criterion> {
        let bound = match value {
            Value::Number(_) if key.is_of_motion() => return None,
            Value::Number(bound) if AT_LEAST.contains(&key) => Bound::AtLeast(*bound),
            Value::Number(bound) => Bound::AtMost(*bound),
            Value::Modes(modes) => Bound::NoneOf(*modes),
            _ => return None,
        };
        Some(Criterion { key, bound, over: None, output })
    }

    /// True if it asks for a probability, or a mean over chance, which takes random numbers.
    pub fn is_chance(&self) -> bool {
        Criterion::is_of_chance(self.key)
    }

    /// True if a criterion under this key asks for that.
    pub fn is_of_chance(key: Key) -> bool {
        OF_CHANCE.contains(&key)
    }

    /// Its name: that of the result.
    pub fn name(&self) -> &'static str {
        self.key.name()
    }

    /// Its name with the slide that it is of: `p_sliding_over(0.3 m)`.
    pub fn full_name(&self) -> String {
        match self.over {
            Some(slide) => format!("{}({} m)", self.name(), plain(slide)),
            None => self.name().to_owned(),
        }
    }

    /// The quantity that is asked for, in words.
    pub fn words(&self) -> &'static str {
        let words = self.key.info().words;
        words.split_once(": ").map_or(words, |(_, words)| words)
    }

    /// Its quantity as it stands in a sentence, of one of chance.
    pub fn of_chance_words(&self) -> &'static str {
        match self.key {
            Key::GreatestLife => "the probability that the body ever leaves rest over the years of its life",
            Key::GreatestAny => "the probability that any of the bodies in a row leaves rest",
            Key::LeastLifeIndex => "the reliability index of a life, −Φ⁻¹(P)",
            Key::GreatestMeanSlide => "the mean slide over the years of its life",
            Key::GreatestSlidingOver => {
                "the probability that its slides come to more than that over the years of its life"
            }
            _ => "the probability that the body does not stay at rest",
        }
    }

    /// The bound as it is read: `≥ 1.2`, `≤ 400 kPa`, `none of RO, SRO-`.
    pub fn required(&self) -> String {
        match self.bound {
            Bound::AtLeast(least) => format!("≥ {}", self.with_unit(&self.output.bound(self.shown(least)))),
            Bound::AtMost(most) => format!("≤ {}", self.with_unit(&self.output.bound(self.shown(most)))),
            Bound::NoneOf(modes) => format!("none of {}", listed_modes(modes)),
        }
    }

    /// The unit in which its bound is read; `None` for plain numbers and modes.
    fn unit(&self) -> Option<ShownUnit> {
        self.key.info().dimension().map(|dimension| self.output.unit(dimension))
    }

    /// A number in the unit that it is read in.
    pub fn shown(&self, si: f64) -> f64 {
        self.unit().map_or(si, |unit| unit.of_si(si))
    }

    /// A number, as it is read, with its unit.
    pub fn with_unit(&self, number: &str) -> String {
        match self.unit() {
            None => number.to_owned(),
            Some(unit) => format!("{number} {}", unit.symbol()),
        }
    }
}

impl fmt::Display for Criterion {
    /// As a target is written: `SF_sliding=1.2`, `bearing_max=300 kPa`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bound = match self.bound {
            Bound::AtLeast(bound) | Bound::AtMost(bound) => self.with_unit(&plain(self.shown(bound))),
            Bound::NoneOf(modes) => {
                let quoted: Vec<_> = modes.iter().map(|mode| format!("\"{mode}\"")).collect();
                format!("[{}]", quoted.join(", "))
            }
        };
        write!(f, "{}={bound}", self.full_name())
    }
}

/// Modes by their symbols.
pub fn listed_modes(modes: Modes) -> String {
    modes.iter().map(Mode::symbol).collect::<Vec<_>>().join(", ")
}

impl MotionCriterion {
    /// Its name: that of the result.
    pub fn name(self) -> &'static str {
        match self {
            MotionCriterion::Slide(_) => MOTION_CRITERIA[0],
            MotionCriterion::MaxTheta(_) => MOTION_CRITERIA[1],
            MotionCriterion::NotOverturned => MOTION_CRITERIA[2],
            MotionCriterion::OverturnedShare(_) => MOTION_CRITERIA[3],
        }
    }

    /// What it is of, in one or two words.
    pub fn in_short(self) -> &'static str {
        match self {
            MotionCriterion::Slide(_) => "slide",
            MotionCriterion::MaxTheta(_) => "turn",
            MotionCriterion::NotOverturned => "overturning",
            MotionCriterion::OverturnedShare(_) => "copies",
        }
    }

    /// The quantity that is asked for, in words.
    pub fn words(self) -> &'static str {
        match self {
            MotionCriterion::Slide(_) => "displacement along the base at the end, to either side",
            MotionCriterion::MaxTheta(_) => "largest angle to either side",
            MotionCriterion::NotOverturned => "whether the body overturns",
            MotionCriterion::OverturnedShare(_) => {
                "share of copies that overturn, the upper end of its interval"
            }
        }
    }

    /// Those that inputs ask for.
    ///
    /// # Errors
    /// If the body is asked to overturn.
    pub fn all(inputs: &Inputs) -> Result<Vec<MotionCriterion>, Fault> {
        let slide = inputs.number(Key::GreatestSlide).map(MotionCriterion::Slide);
        let theta = inputs.number(Key::GreatestTheta).map(MotionCriterion::MaxTheta);
        let stands = match inputs.truth(Key::NotOverturned) {
            Some(true) => return Err(Fault::new(Problem::AskedToOverturn, Key::NotOverturned)),
            asked => asked.map(|_| MotionCriterion::NotOverturned),
        };
        let share = inputs.number(Key::GreatestOverturnedShare).map(MotionCriterion::OverturnedShare);
        Ok([slide, theta, stands, share].into_iter().flatten().collect())
    }

    /// The bound, where it is a number.
    pub fn bound(self) -> Option<f64> {
        match self {
            MotionCriterion::Slide(bound)
            | MotionCriterion::MaxTheta(bound)
            | MotionCriterion::OverturnedShare(bound) => Some(bound),
            MotionCriterion::NotOverturned => None,
        }
    }

    /// The unit of its bound, with a space before it; none of a body in pure numbers.
    pub fn unit(self, si: bool) -> &'static str {
        match self {
            MotionCriterion::Slide(_) if si => " m",
            MotionCriterion::MaxTheta(_) if si => " rad",
            _ => "",
        }
    }

    /// The bound as it is read: `≤ 0.1 m`.
    pub fn required(self, si: bool) -> String {
        match self.bound() {
            Some(bound) => format!("≤ {}{}", digits(bound), self.unit(si)),
            None => "no".to_owned(),
        }
    }
}

impl fmt::Display for MotionCriterion {
    /// As a target of a case with a body is written: `slide=0.1 m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.bound() {
            Some(bound) => write!(f, "{}={}{}", self.name(), plain(bound), self.unit(true)),
            None => write!(f, "{}=false", self.name()),
        }
    }
}
