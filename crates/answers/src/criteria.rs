//! Checks of the criteria of a case against its [results](crate::results).
//!
//! The utilisation of a criterion is required/value where the value has
//! to be at least, value/required where it has to be at most: up to 1 it is met.

use standfast::{Bearing, Departure, Verdict};
use standfast_inputs::digits::factor;
use standfast_model::{Bound, Criterion, Key, listed_modes};

use crate::assess::Assessed;
use crate::results::{ResultName, ResultValue};

/// Check of a criterion in a situation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The criterion.
    pub criterion: Criterion,
    /// The joint that it is met worst at, from the base, from zero; `None` without joints, and of what is of all of them.
    pub joint: Option<usize>,
    /// The value of the result, [infinite](ResultValue::Number) or [none](ResultValue::Nothing) where it is that.
    pub value: ResultValue,
    /// Utilisation of the bound; infinite where there is no value that could meet it, `None` for modes.
    pub utilisation: Option<f64>,
    /// True if it is met.
    pub met: bool,
}

/// A utilisation as it is read.
pub(crate) fn used_words(utilisation: Option<f64>) -> String {
    match utilisation {
        Some(f64::INFINITY) => "infinite".to_owned(),
        // A number that rounds to 1 is not to be read as met when it is not.
        Some(utilisation) => factor(utilisation),
        None => "–".to_owned(),
    }
}

/// "met" or "not met".
pub(crate) fn met_word(met: bool) -> &'static str {
    if met { "met" } else { "not met" }
}

/// The results that criteria on numbers ask for.
const RESULTS: [(Key, ResultName); 12] = [
    (Key::LeastSliding, ResultName::SfSliding),
    (Key::LeastOverturningNet, ResultName::SfOverturningNet),
    (Key::LeastOverturningGross, ResultName::SfOverturningGross),
    (Key::LeastUplift, ResultName::SfUplift),
    (Key::GreatestTipping, ResultName::Tipping),
    (Key::GreatestBearing, ResultName::BearingMax),
    (Key::LeastContact, ResultName::ContactShare),
    (Key::GreatestEccentricity, ResultName::Eccentricity),
    (Key::LeastGround, ResultName::GroundFactor),
    (Key::GreatestEffective, ResultName::EffectivePressure),
    (Key::GreatestRotation, ResultName::Rotation),
    (Key::LeastLoadFactor, ResultName::LoadFactor),
];

/// The result that a criterion asks for; none where it asks for modes or a probability.
pub(crate) fn asked_for(criterion: Criterion) -> Option<ResultName> {
    RESULTS.iter().find(|(key, _)| *key == criterion.key).map(|(_, result)| *result)
}

impl Check {
    /// What it is of, in one or two words.
    pub fn in_short(&self) -> &'static str {
        asked_for(self.criterion).map_or(self.criterion.name(), ResultName::in_short)
    }

    /// Check of a criterion in a situation: at the joint where it is met worst.
    pub fn of(criterion: Criterion, assessed: &Assessed) -> Check {
        let at_base = Check::on_one(criterion, assessed);
        let holds_everywhere = asked_for(criterion)
            .is_some_and(|result| result != ResultName::LoadFactor && !result.is_of_ground());
        let Some(joints) = assessed.joints.as_ref().filter(|_| holds_everywhere) else { return at_base };
        joints.above.iter().enumerate().fold(Check { joint: Some(0), ..at_base }, |worst, (place, above)| {
            let next = Check { joint: Some(place + 1), ..Check::on_one(criterion, above) };
            if next.urgency() > worst.urgency() { next } else { worst }
        })
    }

    /// Check of a criterion on one body.
    fn on_one(criterion: Criterion, assessed: &Assessed) -> Check {
        let result = asked_for(criterion);
        let value = match result {
            // Where a body that never leaves rest, or does not rest at all, would be is not a number of the list.
            Some(ResultName::LoadFactor) => ResultValue::Number(assessed.departure().load_factor()),
            Some(result) => result.of(assessed),
            None if criterion.is_chance() => {
                let counted = assessed.chances.as_ref().and_then(|chances| chances.counted(&criterion));
                counted.map_or(ResultValue::Nothing, ResultValue::Number)
            }
            None => match &assessed.joints {
                Some(joints) => joints.possible(assessed).map_or(ResultValue::Nothing, ResultValue::Modes),
                None => ResultValue::Modes(assessed.outcome.full.modes),
            },
        };
        let (utilisation, met) = match (criterion.bound, value) {
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
        Check { criterion, joint: None, value, utilisation, met }
    }

    /// True if rounding could put the value on the other side of the bound.
    pub(crate) fn is_near_bound(&self, assessed: &Assessed) -> bool {
        /// A part of the greatest pressure under an edge below which rounding could lift it.
        const EDGE: f64 = 1e-9;
        let on_joint = self.joint.and_then(|joint| assessed.on_joints().nth(joint)).unwrap_or(assessed);
        // A base that is pressed from edge to edge is on no bound, as long as both edges are.
        if let (Key::LeastContact, Bearing::Pressed { heel, toe, share: 1.0, .. }) =
            (self.criterion.key, on_joint.outcome.stability.bearing)
        {
            return heel.min(toe) <= EDGE * heel.max(toe);
        }
        match (self.criterion.bound, self.value) {
            (Bound::AtLeast(bound) | Bound::AtMost(bound), ResultValue::Number(value)) => {
                (value - bound).abs() <= 1e-12 * bound.abs()
            }
            _ => false,
        }
    }

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
                let output = criterion.output;
                let text = match criterion.key {
                    _ if !value.is_finite() => output.number(value),
                    Key::LeastSliding
                    | Key::LeastOverturningNet
                    | Key::LeastOverturningGross
                    | Key::LeastUplift
                    | Key::GreatestTipping
                    | Key::LeastGround
                    | Key::LeastLoadFactor => output.beside(value, against),
                    _ if value == against => output.number(value),
                    _ => output.apart(value, against),
                };
                if value.is_finite() { criterion.with_unit(&text) } else { text }
            }
            (ResultValue::Modes(modes), _) if modes.is_empty() => {
                assessed.verdict().map_or("none", Verdict::symbol).to_owned()
            }
            (ResultValue::Modes(modes), _) => listed_modes(modes),
            _ => "none".to_owned(),
        }
    }

    /// The utilisation as it is read.
    pub fn utilisation_words(&self) -> String {
        used_words(self.utilisation)
    }

    /// The joint that it is met worst at, as it stands behind the name of a result; empty without joints.
    pub fn on_joint(&self, assessed: &Assessed) -> String {
        let joint = assessed.joints.as_ref().zip(self.joint).map(|(joints, joint)| joints.called(joint));
        joint.map_or(String::new(), |joint| format!(" on {joint}"))
    }

    /// Reason why it is not met: `SF_sliding is 1.165, not ≥ 1.2`.
    pub fn failure(&self, assessed: &Assessed) -> String {
        let (name, value) = (self.criterion.name(), self.value_words(assessed));
        match self.criterion.bound {
            Bound::NoneOf(not) => {
                let who = if assessed.joints.is_some() { "joints" } else { "the body" };
                format!("of {name} {} {who} may take up {value}", listed_modes(not))
            }
            _ => format!("{name}{} is {value}, not {}", self.on_joint(assessed), self.criterion.required()),
        }
    }

    /// "met" or "not met".
    pub fn met_words(&self) -> &'static str {
        met_word(self.met)
    }

    /// Urgency of the check: modes that are not allowed first, then by utilisation.
    pub fn urgency(&self) -> f64 {
        match (self.utilisation, self.met) {
            // Where a base that is pressed throughout is asked for, it cannot be pressed more: that uses nothing up.
            (Some(1.0), true) if self.criterion.key == Key::LeastContact => 0.0,
            (Some(utilisation), _) => utilisation,
            (None, true) => 0.0,
            (None, false) => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_utilisation() {
        let words = [Some(0.5), Some(1.0), Some(2.0), Some(f64::INFINITY), None].map(used_words);
        assert_eq!(words, ["0.5000", "1.000", "2.000", "infinite", "–"]);
        // What rounds to 1 is told from it.
        for just in [1.0 + 1e-9, 1.0 - 1e-9] {
            assert_eq!(used_words(Some(just)).parse::<f64>().unwrap() > 1.0, just > 1.0);
            assert_ne!(used_words(Some(just)), "1.000");
        }
        assert_eq!([true, false].map(met_word), ["met", "not met"]);
    }
}
