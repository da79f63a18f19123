//! Values that each have a probability of their own.

use super::{LawError, Tails};

/// Values, rising, and how likely each is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Atoms {
    values: Vec<f64>,
    /// Of each value the probabilities below it, and at or above it.
    tails: Vec<Tails>,
}

/// How far from 1 probabilities may add up: they are written with few digits.
pub(super) const ADD_UP: f64 = 1e-6;

impl Atoms {
    /// These values with these probabilities, in any order.
    pub(super) fn new(values: &[f64], probabilities: &[f64]) -> Result<Atoms, LawError> {
        let fault = |fault: String| LawError::List { law: "discrete", fault };
        if values.is_empty() || values.len() != probabilities.len() {
            let (values, probabilities) = (values.len(), probabilities.len());
            let message = format!(
                "{values} values and {probabilities} probabilities; expected one probability for each value"
            );
            return Err(fault(message));
        }
        checked_shares(probabilities).map_err(fault)?;
        let atoms =
            Atoms::of("discrete", values.iter().copied().zip(probabilities.iter().copied()).collect())?;
        match atoms.values.len() < values.len() {
            true => Err(fault("a value stands twice; expected each once".to_owned())),
            false => Ok(atoms),
        }
    }

    /// Each of these values as likely.
    pub(super) fn sample(values: &[f64]) -> Result<Atoms, LawError> {
        if values.is_empty() {
            return Err(LawError::List {
                law: "sample",
                fault: "no values; expected one or more".to_owned(),
            });
        }
        Atoms::of("sample", values.iter().map(|value| (*value, 1.0)).collect())
    }

    fn of(law: &'static str, mut shares: Vec<(f64, f64)>) -> Result<Atoms, LawError> {
        if let Some((value, _)) = shares.iter().find(|(value, _)| !value.is_finite()) {
            return Err(LawError::List { law, fault: format!("a value is {value}; expected numbers") });
        }
        shares.sort_by(|a, b| a.0.total_cmp(&b.0));
        shares.dedup_by(|next, kept| {
            let is_same = next.0 == kept.0;
            kept.1 += if is_same { next.1 } else { 0.0 };
            is_same
        });
        let whole: f64 = shares.iter().map(|(_, share)| share).sum();
        let mut tails = Vec::with_capacity(shares.len());
        let mut below = 0.0;
        for (_, share) in &shares {
            tails.push(Tails { below: below / whole, above: 0.0 });
            below += share;
        }
        let mut above = 0.0;
        for ((_, share), tails) in shares.iter().zip(&mut tails).rev() {
            above += share;
            tails.above = above / whole;
        }
        Ok(Atoms { values: shares.into_iter().map(|(value, _)| value).collect(), tails })
    }

    /// The least and the greatest.
    pub(super) fn support(&self) -> (f64, f64) {
        (self.values[0], self.values[self.values.len() - 1])
    }

    /// The values.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Each with its probability.
    pub(super) fn shares(&self) -> impl Iterator<Item = (f64, f64)> {
        let below = |place: usize| self.tails.get(place).map_or(1.0, |tails| tails.below);
        (0..self.values.len()).map(move |place| (self.values[place], below(place + 1) - below(place)))
    }

    pub(super) fn tails(&self, x: f64) -> Tails {
        let place = self.values.partition_point(|value| *value < x);
        self.tails.get(place).copied().unwrap_or(Tails { below: 1.0, above: 0.0 })
    }

    pub(super) fn value_at(&self, at: Tails) -> f64 {
        let is_reached = |tails: &Tails| {
            if at.below < at.above { tails.below <= at.below } else { tails.above >= at.above }
        };
        self.values[self.tails.partition_point(is_reached).max(1) - 1]
    }
}

/// Probabilities that are above zero and add up to 1, or the fault.
pub(super) fn checked_shares(shares: &[f64]) -> Result<(), String> {
    if let Some(share) = shares.iter().find(|share| !(**share > 0.0 && **share <= 1.0)) {
        return Err(format!("a probability is {share}; expected more than 0 and at most 1"));
    }
    let sum: f64 = shares.iter().sum();
    if (sum - 1.0).abs() <= ADD_UP {
        Ok(())
    } else {
        Err(format!("the probabilities add up to {sum}; expected 1"))
    }
}
