//! Laws cut at bounds.

use super::{Kind, Law, LawError, Tails};
use crate::normal;

/// A law, truncated where bounds are given and renormalised between them. Parameters of the law are those before truncation.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution {
    law: Law,
    bounds: Option<Bounds>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Bounds {
    lower: f64,
    upper: f64,
    /// Below the lower bound, and above the upper.
    cut: Tails,
    /// Between the bounds.
    mass: f64,
}

impl From<Law> for Distribution {
    fn from(law: Law) -> Distribution {
        Distribution { law, bounds: None }
    }
}

impl Distribution {
    /// A law between two bounds; −∞ and ∞ are none.
    ///
    /// # Errors
    /// If a bound is NaN, or nothing of the law lies between them.
    pub fn truncated(law: Law, lower: f64, upper: f64) -> Result<Distribution, LawError> {
        if lower == f64::NEG_INFINITY && upper == f64::INFINITY {
            return Ok(law.into());
        }
        // A value at a bound that has a probability of its own is within.
        let (at_lower, at_upper) =
            (law.tails(lower), law.tails(if law.atoms().is_empty() { upper } else { upper.next_up() }));
        let mass = if at_lower.below > 0.5 {
            at_lower.above - at_upper.above
        } else {
            at_upper.below - at_lower.below
        };
        // A mass that is NaN comes of a bound that is.
        if mass.is_nan() || mass <= 0.0 || lower > upper {
            return Err(LawError::Empty { lower, upper });
        }
        let cut = Tails { below: at_lower.below, above: at_upper.above };
        Ok(Distribution { law, bounds: Some(Bounds { lower, upper, cut, mass }) })
    }

    /// The bounds at which it is cut, infinite where it is not.
    pub(super) fn bounds(&self) -> (f64, f64) {
        self.bounds.map_or((f64::NEG_INFINITY, f64::INFINITY), |bounds| (bounds.lower, bounds.upper))
    }

    /// The law before truncation.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// The numbers between which there are values.
    pub fn support(&self) -> (f64, f64) {
        let (from, to) = self.law.support();
        self.bounds.map_or((from, to), |b| (b.lower.max(from), b.upper.min(to)))
    }

    /// Probability cut away by truncation, of the law's probability 1.
    pub fn cut(&self) -> f64 {
        self.bounds.map_or(0.0, |b| b.cut.below + b.cut.above)
    }

    /// The probabilities below `x`, and at or above it.
    pub fn tails(&self, x: f64) -> Tails {
        let t = self.law.tails(x);
        let Some(b) = self.bounds else { return t };
        if x <= b.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        if x > b.upper {
            return Tails { below: 1.0, above: 0.0 };
        }
        // Each as a difference in the tail that is nearer, so that what is small keeps its digits.
        let below = if t.below < 0.5 { t.below - b.cut.below } else { b.mass - (t.above - b.cut.above) };
        let above = if t.below < 0.5 { b.mass - (t.below - b.cut.below) } else { t.above - b.cut.above };
        Tails { below: below.max(0.0) / b.mass, above: above.max(0.0) / b.mass }
    }

    /// The standard normal value that belongs to `x`; ∓∞ at the ends of the support and beyond.
    pub fn z(&self, x: f64) -> f64 {
        if self.bounds.is_none() { self.law.z(x) } else { self.tails(x).z() }
    }

    /// The value of a standard normal `z`.
    pub fn value(&self, z: f64) -> f64 {
        if self.bounds.is_none() { self.law.value(z) } else { self.value_at(Tails::of(z)) }
    }

    /// The value with these probabilities below and above it.
    pub fn value_at(&self, tails: Tails) -> f64 {
        let Some(b) = self.bounds else { return self.law.value_at(tails) };
        let whole =
            Tails { below: b.cut.below + tails.below * b.mass, above: b.cut.above + tails.above * b.mass };
        self.law.value_at(whole).clamp(b.lower, b.upper)
    }

    /// The value below which a share `p` of the law lies, 0 < p < 1.
    pub fn value_of_chance(&self, p: f64) -> f64 {
        match (&self.law.0, self.bounds) {
            (Kind::Normal { .. } | Kind::LogNormal { .. }, None) => self.law.value(normal::quantile(p)),
            _ => self.value_at(Tails { below: p, above: 1.0 - p }),
        }
    }

    /// Replaces each probability by its value, as [`value_of_chance`](Self::value_of_chance) gives it.
    pub fn values_of_chances(&self, chances: &mut [f64]) {
        if let (Kind::Normal { .. } | Kind::LogNormal { .. }, None) = (&self.law.0, self.bounds) {
            normal::quantiles(chances);
            chances.iter_mut().for_each(|x| *x = self.law.value(*x));
        } else {
            chances.iter_mut().for_each(|p| *p = self.value_of_chance(*p));
        }
    }

    /// Values at which the law is not smooth, rising: those with a probability of their own, with the next number above each, ends of what a mixture is
    /// made of, and corners of a density. The value as a function of the normal jumps, or has a kink, there and nowhere else.
    pub fn breaks(&self) -> Vec<f64> {
        let mut breaks = self.law.breaks();
        let (from, to) = self.support();
        breaks.retain(|x| from <= *x && *x <= to);
        breaks
    }

    /// The normals that belong to the [`breaks`](Self::breaks), each once.
    pub fn breaks_of_normal(&self) -> Vec<f64> {
        let mut breaks: Vec<f64> =
            self.breaks().into_iter().map(|x| self.z(x)).filter(|z| z.is_finite()).collect();
        breaks.dedup();
        breaks
    }

    /// True if each of its values has a probability of its own.
    pub fn is_discrete(&self) -> bool {
        self.law.is_discrete()
    }

    /// The values with a probability of their own, rising.
    pub fn atoms(&self) -> Vec<f64> {
        let mut atoms = self.law.atoms();
        let (from, to) = self.support();
        atoms.retain(|x| from <= *x && *x <= to);
        atoms
    }

    /// The value that is exceeded as often as not.
    pub fn median(&self) -> f64 {
        self.value(0.0)
    }
}
