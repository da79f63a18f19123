//! Criteria on the results of a case, and their checks: required factors, allowable pressures, modes not allowed.
//!
//! A criterion is a result of the [one list](crate::results) with a bound, or the modes that are not allowed. Its utilisation is required/value where the value has
//! to be at least, value/required where it has to be at most: up to 1 it is met.

use std::fmt;

use standfast::{Departure, Mode, Modes, Verdict};

use crate::assess::Assessed;
use crate::inputs::{Inputs, Value};
use crate::key::{Key, Table};
use crate::layout::{apart, digits, plain};
use crate::results::{ResultName, ResultValue};
use crate::units::Dimension;

/// Criterion on a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criterion {
    /// The key under which it is asked; its name is that of the result, with `_max` behind it for one of the ground.
    pub key: Key,
    /// The bound.
    pub bound: Bound,
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

/// Check of a criterion in a situation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The criterion.
    pub criterion: Criterion,
    /// The value of the result, [infinite](ResultValue::Number) or [none](ResultValue::Nothing) where it is that.
    pub value: ResultValue,
    /// Utilisation of the bound; infinite where there is no value that could meet it, `None` for modes.
    pub utilisation: Option<f64>,
    /// True if it is met.
    pub met: bool,
}

/// A criterion of a number: which result it asks for.
struct NumberCriterion {
    key: Key,
    result: ResultName,
    bound: fn(f64) -> Bound,
}

impl NumberCriterion {
    /// The unit in which it is read, empty for plain numbers, and how many SI units make one.
    fn on_paper(&self) -> (&'static str, f64) {
        self.key.info().dimension().map_or(("", 1.0), Dimension::on_paper)
    }
}

const fn asked(key: Key, result: ResultName, bound: fn(f64) -> Bound) -> NumberCriterion {
    NumberCriterion { key, result, bound }
}

const NUMBERS: [NumberCriterion; 9] = [
    asked(Key::LeastSliding, ResultName::SfSliding, Bound::AtLeast),
    asked(Key::LeastOverturning, ResultName::SfOverturning, Bound::AtLeast),
    asked(Key::GreatestBearing, ResultName::BearingMax, Bound::AtMost),
    asked(Key::LeastContact, ResultName::ContactShare, Bound::AtLeast),
    asked(Key::GreatestEccentricity, ResultName::Eccentricity, Bound::AtMost),
    asked(Key::LeastGround, ResultName::GroundFactor, Bound::AtLeast),
    asked(Key::GreatestEffective, ResultName::EffectivePressure, Bound::AtMost),
    asked(Key::GreatestRotation, ResultName::Rotation, Bound::AtMost),
    asked(Key::LeastLoadFactor, ResultName::LoadFactor, Bound::AtLeast),
];

impl Criterion {
    /// The criteria of a case.
    pub(crate) fn all(inputs: &Inputs) -> Vec<Criterion> {
        Table::Criteria.keys().filter_map(|key| Criterion::of(key, inputs.get(key)?)).collect()
    }

    /// Criterion of a value under a key of `[criteria]`; `None` if the key is none of these.
    pub(crate) fn of(key: Key, value: &Value) -> Option<Criterion> {
        let bound = match value {
            Value::Number(bound) if key == Key::GreatestNotRest => Bound::AtMost(*bound),
            Value::Number(bound) => (NUMBERS.iter().find(|asked| asked.key == key)?.bound)(*bound),
            Value::Modes(modes) => Bound::NoneOf(*modes),
            _ => return None,
        };
        Some(Criterion { key, bound })
    }

    /// True if it asks for a probability, which takes random numbers.
    pub(crate) fn is_chance(&self) -> bool {
        self.key == Key::GreatestNotRest
    }

    /// Its name: that of the result.
    pub fn name(&self) -> &'static str {
        self.key.name()
    }

    /// The quantity that is asked for, in words.
    pub fn words(&self) -> &'static str {
        let words = self.key.info().words;
        words.split_once(": ").map_or(words, |(_, words)| words)
    }

    /// The bound as it is read: `≥ 1.2`, `≤ 400 kPa`, `none of RO, SRO-`.
    pub fn required(&self) -> String {
        match self.bound {
            Bound::AtLeast(least) => format!("≥ {}", self.with_unit(&digits(self.shown(least)))),
            Bound::AtMost(most) => format!("≤ {}", self.with_unit(&digits(self.shown(most)))),
            Bound::NoneOf(modes) => format!("none of {}", listed(modes)),
        }
    }

    /// True if rounding could put the value in a situation on the other side of the bound.
    pub(crate) fn is_near(self, assessed: &Assessed) -> bool {
        match (self.bound, self.check(assessed).value) {
            (Bound::AtLeast(bound) | Bound::AtMost(bound), ResultValue::Number(value)) => {
                (value - bound).abs() <= 1e-12 * bound.abs()
            }
            _ => false,
        }
    }

    /// Check of it in a situation.
    pub fn check(self, assessed: &Assessed) -> Check {
        let value = match self.asked().map(|asked| asked.result) {
            // Where a body that never leaves rest, or does not rest at all, would be is no number of the list.
            Some(ResultName::LoadFactor) => ResultValue::Number(assessed.departure().load_factor()),
            Some(result) => result.of(assessed),
            None if self.is_chance() => {
                assessed.not_rest.map_or(ResultValue::Nothing, |not_rest| ResultValue::Number(not_rest.high))
            }
            None => ResultValue::Modes(assessed.outcome.full.modes),
        };
        let (utilisation, met) = match (self.bound, value) {
            (Bound::AtLeast(least), ResultValue::Number(value)) => {
                // Neither a quotient by zero nor a rounded one decides.
                (Some(if value > 0.0 { least / value } else { f64::INFINITY }), value >= least)
            }
            (Bound::AtMost(most), ResultValue::Number(value)) => (Some(value / most), value <= most),
            (Bound::NoneOf(not), ResultValue::Modes(modes)) => {
                // Where several modes are consistent, none of them may be one of these.
                (None, !modes.is_empty() && modes.iter().all(|mode| !not.contains(mode)))
            }
            _ => (Some(f64::INFINITY), false),
        };
        Check { criterion: self, value, utilisation, met }
    }

    /// Number that it asks for; `None` where that is no number.
    fn asked(&self) -> Option<&'static NumberCriterion> {
        NUMBERS.iter().find(|asked| asked.key == self.key)
    }

    /// A number in the unit that it is read in.
    fn shown(&self, si: f64) -> f64 {
        self.asked().map_or(si, |asked| si / asked.on_paper().1)
    }

    fn with_unit(&self, number: &str) -> String {
        match self.asked().map_or("", |asked| asked.on_paper().0) {
            "" => number.to_owned(),
            unit => format!("{number} {unit}"),
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
        write!(f, "{}={bound}", self.name())
    }
}

/// Modes by their symbols.
fn listed(modes: Modes) -> String {
    modes.iter().map(Mode::symbol).collect::<Vec<_>>().join(", ")
}

impl Check {
    /// The value as it is read, with as many digits as tell it from the bound.
    pub fn value_words(&self, assessed: &Assessed) -> String {
        let criterion = &self.criterion;
        let against = match criterion.bound {
            Bound::AtLeast(bound) | Bound::AtMost(bound) => criterion.shown(bound),
            Bound::NoneOf(_) => 0.0,
        };
        match (self.value, assessed.departure()) {
            (ResultValue::Number(_), Departure::Never) if criterion.key == Key::LeastLoadFactor => {
                "never leaves rest".to_owned()
            }
            (ResultValue::Number(_), Departure::AtOnce { .. }) if criterion.key == Key::LeastLoadFactor => {
                "leaves rest at once".to_owned()
            }
            (ResultValue::Number(value), _) => {
                let value = criterion.shown(value);
                let text = if value == against { digits(value) } else { apart(&[value, against])[0].clone() };
                if value.is_finite() { criterion.with_unit(&text) } else { text }
            }
            (ResultValue::Modes(modes), _) if modes.is_empty() => {
                assessed.verdict().map_or("none", Verdict::symbol).to_owned()
            }
            (ResultValue::Modes(modes), _) => listed(modes),
            _ => "none".to_owned(),
        }
    }

    /// The utilisation as it is read.
    pub fn utilisation_words(&self) -> String {
        match self.utilisation {
            // A number that rounds to 1 is not to be read as met when it is not.
            Some(utilisation) if utilisation.is_finite() && utilisation != 1.0 => {
                apart(&[utilisation, 1.0])[0].clone()
            }
            Some(f64::INFINITY) => "infinite".to_owned(),
            Some(utilisation) => digits(utilisation),
            None => "–".to_owned(),
        }
    }

    /// Reason why it is not met: `SF_sliding is 1.165, not ≥ 1.2`.
    pub fn failure(&self, assessed: &Assessed) -> String {
        let (name, value) = (self.criterion.name(), self.value_words(assessed));
        match self.criterion.bound {
            Bound::NoneOf(not) => format!("of {name} {} the body may take up {value}", listed(not)),
            _ => format!("{name} is {value}, not {}", self.criterion.required()),
        }
    }

    /// "met" or "not met".
    pub fn met_words(&self) -> &'static str {
        if self.met { "met" } else { "not met" }
    }

    /// Urgency of the check: modes that are not allowed first, then by utilisation.
    pub(crate) fn urgency(&self) -> f64 {
        match (self.utilisation, self.met) {
            (Some(utilisation), _) => utilisation,
            (None, true) => 0.0,
            (None, false) => f64::INFINITY,
        }
    }
}
