//! Means and deviations of laws, and the same law with others: what a probability's slopes along them are taken for.
//!
//! Laws that are given by a mean and a deviation keep their family: normal, lognormal, Gumbel's, uniform, gamma from its location on, and beta between
//! its ends. All others are moved and stretched as they are. Mean and deviation are those before a law is cut; the bounds stay.

use super::mixture::Mixture;
use super::{Distribution, Kind, Law};
use crate::normal;

/// Mean and standard deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub sd: f64,
}

impl Law {
    /// Its mean and standard deviation; `None` where there are none.
    pub fn moments(&self) -> Option<Moments> {
        match self.0 {
            Kind::Normal { mean, sd } => Some(Moments { mean, sd }),
            Kind::LogNormal { mean, sd } => {
                let variance = sd * sd;
                let mean = (mean + 0.5 * variance).exp();
                Some(Moments { mean, sd: mean * libm::expm1(variance).sqrt() })
            }
            _ if self.has_deviation() => Some(self.integrated()),
            _ => None,
        }
    }

    /// True unless its tail is too heavy for a deviation.
    fn has_deviation(&self) -> bool {
        match &self.0 {
            Kind::Pareto { shape, .. } | Kind::Gev { shape, .. } => *shape < 0.5,
            Kind::Mixture(mixture) => mixture.parts().iter().all(|(_, part)| part.law().has_deviation()),
            Kind::MaxOf { of, .. } => of.law().has_deviation(),
            _ => true,
        }
    }

    /// ∫ x φ(z) dz and the deviation, by the trapezoidal rule, or the sum over few values.
    fn integrated(&self) -> Moments {
        /// Steps of the rule for each unit of z, and how far it goes.
        const STEPS: i32 = 64;
        const REACH: i32 = 9;
        let weighed: Vec<(f64, f64)> = match &self.0 {
            Kind::Discrete(atoms) | Kind::Sample(atoms) => atoms.shares().collect(),
            _ => (-STEPS * REACH..=STEPS * REACH)
                .map(|step| {
                    let z = f64::from(step) / f64::from(STEPS);
                    (self.value(z), normal::density(z) / f64::from(STEPS))
                })
                .collect(),
        };
        let whole: f64 = weighed.iter().map(|(_, weight)| weight).sum();
        let mean = weighed.iter().map(|(x, weight)| x * weight).sum::<f64>() / whole;
        let variance = weighed.iter().map(|(x, weight)| (x - mean).powi(2) * weight).sum::<f64>() / whole;
        Moments { mean, sd: variance.sqrt() }
    }

    /// The law with this mean and deviation in the place of its own; `None` where it has values with probabilities of their own, which a
    /// probability would jump at, or no such law exists.
    fn with_moments(&self, own: Moments, Moments { mean, sd }: Moments) -> Option<Law> {
        match self.0 {
            Kind::Normal { .. } => Law::normal(mean, sd).ok(),
            Kind::LogNormal { .. } => Law::lognormal(mean, sd).ok(),
            Kind::Gamma { location, .. } => Law::gamma_of_mean(mean, sd, location).ok(),
            Kind::Beta { from, to, .. } => Law::beta_of_mean(mean, sd, from, to).ok(),
            _ => self.mapped(Map { from: own.mean, to: mean, factor: sd / own.sd }),
        }
    }

    fn mapped(&self, map: Map) -> Option<Law> {
        let Map { factor, .. } = map;
        let of = |x: f64| map.of(x);
        Some(Law(match self.0 {
            Kind::Gumbel { mode, scale } => Kind::Gumbel { mode: of(mode), scale: factor * scale },
            Kind::Weibull { location, scale, shape } => {
                Kind::Weibull { location: of(location), scale: factor * scale, shape }
            }
            Kind::Gev { location, scale, shape } => {
                Kind::Gev { location: of(location), scale: factor * scale, shape }
            }
            Kind::Pareto { location, scale, shape } => {
                Kind::Pareto { location: of(location), scale: factor * scale, shape }
            }
            Kind::Uniform { from, to } => Kind::Uniform { from: of(from), to: of(to) },
            Kind::Triangular { from, peak, to } => {
                Kind::Triangular { from: of(from), peak: of(peak), to: of(to) }
            }
            Kind::Normal { mean, sd } => Kind::Normal { mean: of(mean), sd: factor * sd },
            Kind::Gamma { location, scale, shape } => {
                Kind::Gamma { location: of(location), scale: factor * scale, shape }
            }
            Kind::Beta { from, to, alpha, beta } => Kind::Beta { from: of(from), to: of(to), alpha, beta },
            Kind::Quantiles(ref curve) => Kind::Quantiles(curve.mapped(of)?),
            Kind::Mixture(ref mixture) => {
                let part = |(share, part): &(f64, Distribution)| Some((*share, part.mapped(map)?));
                Kind::Mixture(Mixture::new(mixture.parts().iter().map(part).collect::<Option<_>>()?).ok()?)
            }
            Kind::MaxOf { ref of, count } => Kind::MaxOf { of: Box::new(of.mapped(map)?), count },
            // The logarithm of a moved one is another law.
            Kind::LogNormal { .. } | Kind::Discrete(_) | Kind::Sample(_) => return None,
        }))
    }
}

/// A straight map of values.
#[derive(Clone, Copy)]
struct Map {
    from: f64,
    to: f64,
    factor: f64,
}

impl Map {
    fn of(self, x: f64) -> f64 {
        self.to + self.factor * (x - self.from)
    }
}

impl Distribution {
    /// The law with this mean and deviation, before it is cut, in the place of `own`, between the same bounds; `None` where there is none, or a
    /// probability would jump.
    pub fn with_moments(&self, own: Moments, moments: Moments) -> Option<Distribution> {
        let law = self.law().with_moments(own, moments)?;
        let (lower, upper) = self.bounds();
        Distribution::truncated(law, lower, upper).ok()
    }

    /// Moved with its bounds.
    fn mapped(&self, map: Map) -> Option<Distribution> {
        let law = self.law().mapped(map)?;
        let (lower, upper) = self.bounds();
        Distribution::truncated(law, map.of(lower), map.of(upper)).ok()
    }
}
