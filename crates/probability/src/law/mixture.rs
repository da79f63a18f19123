//! One of several laws, as chance has it: two populations of storms, a gate that is open or shut.

use super::atoms::checked_shares;
use super::{Distribution, LawError, Tails};
use crate::roots::where_met;

/// Laws, and how likely each is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mixture(Vec<(f64, Distribution)>);

impl Mixture {
    pub(super) fn new(mut parts: Vec<(f64, Distribution)>) -> Result<Mixture, LawError> {
        let fault = |fault: String| LawError::List { law: "mixture", fault };
        if parts.len() < 2 {
            return Err(fault(format!("{} law; expected two or more", parts.len())));
        }
        let shares: Vec<f64> = parts.iter().map(|(share, _)| *share).collect();
        checked_shares(&shares).map_err(fault)?;
        let whole: f64 = shares.iter().sum();
        parts.iter_mut().for_each(|(share, _)| *share /= whole);
        Ok(Mixture(parts))
    }

    /// Its laws, and how likely each is.
    pub(super) fn parts(&self) -> &[(f64, Distribution)] {
        &self.0
    }

    pub(super) fn support(&self) -> (f64, f64) {
        let ends = self.0.iter().map(|(_, part)| part.support());
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), (a, b)| (from.min(a), to.max(b)))
    }

    pub(super) fn atoms(&self) -> Vec<f64> {
        rising(self.0.iter().flat_map(|(_, part)| part.atoms()))
    }

    /// Ends and breaks of its parts.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let ends = |part: &Distribution| [part.support().0, part.support().1];
        let own = self.0.iter().flat_map(|(_, part)| part.breaks().into_iter().chain(ends(part)));
        rising(own.filter(|x| x.is_finite()))
    }

    pub(super) fn tails(&self, x: f64) -> Tails {
        let of = self.0.iter().map(|(share, part)| (share, part.tails(x)));
        of.fold(Tails { below: 0.0, above: 0.0 }, |sum, (share, tails)| Tails {
            below: sum.below + share * tails.below,
            above: sum.above + share * tails.above,
        })
    }

    /// The value lies between those that the parts have.
    pub(super) fn value_at(&self, at: Tails) -> f64 {
        let (from, to) = self.support();
        if at.below <= 0.0 || at.above <= 0.0 {
            return if at.below <= 0.0 { from } else { to };
        }
        let values = self.0.iter().map(|(_, part)| part.value_at(at));
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let z = at.z();
        where_met(low, high, |x| self.tails(x).z() - z)
    }
}

/// Numbers in rising order, each once.
fn rising(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
}
