//! Laws of one input, each by its closed form in both tails, and their truncation.
//!
//! A value and a standard normal z belong together: F(x) = Φ(z). All of this crate draws z and asks for x, or has a boundary x
//! and asks for z, so that sampling, correlation and exact integration share one path. Between the two stand [`Tails`], the
//! probability below and above, of which the smaller is exact: 1 − 1e-20 is 1, 1e-20 is not.
//!
//! A value with a probability of its own, as discrete laws and samples have, belongs to all z from that of the values below it on; the z of
//! a boundary at the value itself leaves it above. So an interval from a boundary on holds what lies at it.

use crate::{beta, gamma, normal};
use atoms::Atoms;
use curve::Curve;
use mixture::Mixture;
pub use moments::Moments;
pub use truncated::Distribution;

mod atoms;
mod curve;
mod mixture;
mod moments;
mod parameters;
mod standard;
mod truncated;

/// The probability below a value, and that at or above it. They add up to 1; the smaller has all its digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tails {
    /// P(X < x).
    pub below: f64,
    /// P(X ≥ x).
    pub above: f64,
}

impl Tails {
    /// Those of a standard normal value.
    pub fn of(z: f64) -> Tails {
        Tails { below: normal::below(z), above: normal::above(z) }
    }

    /// The standard normal value with these tails.
    pub fn z(self) -> f64 {
        if self.below < self.above {
            normal::quantile(self.below)
        } else {
            normal::quantile_above(self.above)
        }
    }
}

/// Fault of a law.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LawError {
    /// A parameter outside what the law allows.
    #[error("{parameter} = {value} of the law {law}: expected {expected}")]
    Parameter {
        /// The law's name, as in a case file.
        law: &'static str,
        /// The parameter's name.
        parameter: &'static str,
        /// The value given.
        value: f64,
        /// Range of values allowed.
        expected: &'static str,
    },
    /// Values and probabilities that make no law.
    #[error("the law {law}: {fault}")]
    List {
        /// The law's name, as in a case file.
        law: &'static str,
        /// Part of the lists that is wrong, with its value.
        fault: String,
    },
    /// Nothing of the law lies between the bounds.
    #[error("nothing of the law lies between {lower} and {upper}")]
    Empty {
        /// The lower bound.
        lower: f64,
        /// The upper bound.
        upper: f64,
    },
}

/// A law of probability of one number.
#[derive(Debug, Clone, PartialEq)]
pub struct Law(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Normal {
        mean: f64,
        sd: f64,
    },
    LogNormal {
        mean: f64,
        sd: f64,
    },
    Gumbel {
        mode: f64,
        scale: f64,
    },
    Weibull {
        location: f64,
        scale: f64,
        shape: f64,
    },
    Gev {
        location: f64,
        scale: f64,
        shape: f64,
    },
    Uniform {
        from: f64,
        to: f64,
    },
    Triangular {
        from: f64,
        peak: f64,
        to: f64,
    },
    Gamma {
        location: f64,
        scale: f64,
        shape: f64,
    },
    Beta {
        from: f64,
        to: f64,
        alpha: f64,
        beta: f64,
    },
    /// The generalised Pareto law; a shape of zero is the exponential.
    Pareto {
        location: f64,
        scale: f64,
        shape: f64,
    },
    Discrete(Atoms),
    Sample(Atoms),
    Mixture(Mixture),
    Quantiles(Curve),
    MaxOf {
        of: Box<Distribution>,
        count: f64,
    },
}

impl Law {
    /// The law's name, as in a case file.
    pub fn name(&self) -> &'static str {
        match self.0 {
            Kind::Normal { .. } => "normal",
            Kind::LogNormal { .. } => "lognormal",
            Kind::Gumbel { .. } => "gumbel",
            Kind::Weibull { .. } => "weibull",
            Kind::Gev { .. } => "gev",
            Kind::Uniform { .. } => "uniform",
            Kind::Triangular { .. } => "triangular",
            Kind::Gamma { .. } => "gamma",
            Kind::Beta { .. } => "beta",
            Kind::Pareto { shape: 0.0, .. } => "exponential",
            Kind::Pareto { .. } => "gpd",
            Kind::Discrete(_) => "discrete",
            Kind::Sample(_) => "sample",
            Kind::Mixture(_) => "mixture",
            Kind::Quantiles(_) => "quantiles",
            Kind::MaxOf { .. } => "max_of",
        }
    }

    /// The numbers between which the law has values.
    pub fn support(&self) -> (f64, f64) {
        match self.0 {
            Kind::Normal { .. } | Kind::Gumbel { .. } | Kind::Quantiles(_) => {
                (f64::NEG_INFINITY, f64::INFINITY)
            }
            Kind::LogNormal { .. } => (0.0, f64::INFINITY),
            Kind::Weibull { location, .. } | Kind::Gamma { location, .. } => (location, f64::INFINITY),
            Kind::Pareto { location, scale, shape } if shape < 0.0 => (location, location - scale / shape),
            Kind::Pareto { location, .. } => (location, f64::INFINITY),
            Kind::Beta { from, to, .. } => (from, to),
            Kind::Discrete(ref atoms) | Kind::Sample(ref atoms) => atoms.support(),
            Kind::Mixture(ref mixture) => mixture.support(),
            Kind::Gev { location, scale, shape } if shape > 0.0 => (location - scale / shape, f64::INFINITY),
            Kind::Gev { location, scale, shape } => (f64::NEG_INFINITY, location - scale / shape),
            Kind::Uniform { from, to } | Kind::Triangular { from, to, .. } => (from, to),
            Kind::MaxOf { ref of, .. } => of.support(),
        }
    }

    /// True if each of its values has a probability of its own.
    fn is_discrete(&self) -> bool {
        match &self.0 {
            Kind::Discrete(_) | Kind::Sample(_) => true,
            Kind::MaxOf { of, .. } => of.is_discrete(),
            _ => false,
        }
    }

    /// The values with a probability of their own, rising.
    fn atoms(&self) -> Vec<f64> {
        match &self.0 {
            Kind::Discrete(atoms) | Kind::Sample(atoms) => atoms.values().to_vec(),
            Kind::Mixture(mixture) => mixture.atoms(),
            Kind::MaxOf { of, .. } => of.atoms(),
            _ => Vec::new(),
        }
    }

    /// Values at which the law is not smooth, as [`Distribution::breaks`] has them.
    fn breaks(&self) -> Vec<f64> {
        match &self.0 {
            Kind::Triangular { peak, .. } => vec![*peak],
            Kind::Discrete(_) | Kind::Sample(_) => {
                self.atoms().into_iter().flat_map(|value| [value, value.next_up()]).collect()
            }
            Kind::Mixture(mixture) => mixture.breaks(),
            Kind::MaxOf { of, .. } => of.breaks(),
            _ => Vec::new(),
        }
    }

    /// The standard normal value that belongs to `x`.
    fn z(&self, x: f64) -> f64 {
        match self.0 {
            Kind::Normal { mean, sd } => (x - mean) / sd,
            Kind::LogNormal { .. } if x <= 0.0 => f64::NEG_INFINITY,
            Kind::LogNormal { mean, sd } => (x.ln() - mean) / sd,
            Kind::Quantiles(ref curve) => curve.z(x),
            _ => self.tails(x).z(),
        }
    }

    /// The probabilities below `x`, and at or above it.
    fn tails(&self, x: f64) -> Tails {
        match self.0 {
            Kind::Normal { .. } | Kind::LogNormal { .. } | Kind::Quantiles(_) => Tails::of(self.z(x)),
            Kind::Gumbel { mode, scale } => of_rate((-(x - mode) / scale).exp()),
            Kind::Weibull { location, scale, shape } => {
                let t = of_rate(((x - location).max(0.0) / scale).powf(shape));
                Tails { below: t.above, above: t.below }
            }
            Kind::Gev { location, scale, shape } => {
                let reach = (1.0 + shape * (x - location) / scale).max(0.0);
                of_rate(reach.powf(-1.0 / shape))
            }
            Kind::Uniform { from, to } => {
                let x = x.clamp(from, to);
                Tails { below: (x - from) / (to - from), above: (to - x) / (to - from) }
            }
            Kind::Triangular { from, peak, to } => {
                let (x, width, rise, fall) = (x.clamp(from, to), to - from, peak - from, to - peak);
                // Sums of what is positive, also on the far side of the peak.
                if x < peak {
                    let y = x - from;
                    Tails {
                        below: y * y / (width * rise),
                        above: (rise * fall + (peak - x) * (rise + y)) / (width * rise),
                    }
                } else if fall > 0.0 {
                    let y = to - x;
                    Tails {
                        below: (rise * fall + (x - peak) * (fall + y)) / (width * fall),
                        above: y * y / (width * fall),
                    }
                } else {
                    Tails { below: 1.0, above: 0.0 }
                }
            }
            Kind::Gamma { location, scale, shape } => gamma::tails(shape, (x - location) / scale),
            Kind::Beta { from, to, alpha, beta: b } => {
                let x = x.clamp(from, to);
                beta::tails(alpha, b, (x - from) / (to - from), (to - x) / (to - from))
            }
            Kind::Pareto { location, scale, shape } => {
                let y = ((x - location) / scale).max(0.0);
                let rate = if shape == 0.0 { y } else { libm::log1p((shape * y).max(-1.0)) / shape };
                Tails { below: -libm::expm1(-rate), above: (-rate).exp() }
            }
            Kind::Discrete(ref atoms) | Kind::Sample(ref atoms) => atoms.tails(x),
            Kind::Mixture(ref mixture) => mixture.tails(x),
            Kind::MaxOf { ref of, count } => {
                let one = of.tails(x);
                Tails {
                    below: one.below.powf(count),
                    above: -libm::expm1(
                        count * if one.above < 0.5 { libm::log1p(-one.above) } else { one.below.ln() },
                    ),
                }
            }
        }
    }

    /// The value of a standard normal z.
    fn value(&self, z: f64) -> f64 {
        match self.0 {
            Kind::Normal { mean, sd } => mean + sd * z,
            Kind::LogNormal { mean, sd } => (mean + sd * z).exp(),
            Kind::Quantiles(ref curve) => curve.value(z),
            _ => self.value_at(Tails::of(z)),
        }
    }

    /// The value with these probabilities below and above it.
    fn value_at(&self, tails: Tails) -> f64 {
        match self.0 {
            Kind::Normal { .. } | Kind::LogNormal { .. } | Kind::Quantiles(_) => self.value(tails.z()),
            Kind::Gumbel { mode, scale } => mode - scale * rate(tails).ln(),
            Kind::Weibull { location, scale, shape } => {
                let turned = Tails { below: tails.above, above: tails.below };
                location + scale * rate(turned).powf(1.0 / shape)
            }
            Kind::Gev { location, scale, shape } => {
                location + scale * libm::expm1(-shape * rate(tails).ln()) / shape
            }
            Kind::Uniform { from, to } => {
                if tails.below < tails.above {
                    from + tails.below * (to - from)
                } else {
                    to - tails.above * (to - from)
                }
            }
            Kind::Triangular { from, peak, to } => {
                if tails.below * (to - from) < peak - from {
                    from + (tails.below * (to - from) * (peak - from)).sqrt()
                } else {
                    to - (tails.above * (to - from) * (to - peak)).sqrt()
                }
            }
            Kind::Gamma { location, scale, shape } => location + scale * standard::gamma_value(shape, tails),
            Kind::Beta { from, to, alpha, beta } => {
                let (below, above) = standard::beta_value(alpha, beta, tails);
                if below < above { from + below * (to - from) } else { to - above * (to - from) }
            }
            Kind::Pareto { location, scale, shape } => {
                // The rate −ln(1 − F).
                let rate = rate(Tails { below: tails.above, above: tails.below });
                let reach = if shape == 0.0 { rate } else { libm::expm1(shape * rate) / shape };
                location + scale * reach
            }
            Kind::Discrete(ref atoms) | Kind::Sample(ref atoms) => atoms.value_at(tails),
            Kind::Mixture(ref mixture) => mixture.value_at(tails),
            Kind::MaxOf { ref of, count } => {
                let log =
                    if tails.above < 0.5 { libm::log1p(-tails.above) } else { tails.below.ln() } / count;
                of.value_at(Tails { below: log.exp(), above: -libm::expm1(log) })
            }
        }
    }
}

/// The tails of F = exp(−rate).
fn of_rate(rate: f64) -> Tails {
    Tails { below: (-rate).exp(), above: -libm::expm1(-rate) }
}

/// The rate −ln F of F = exp(−rate).
fn rate(tails: Tails) -> f64 {
    if tails.above < 0.5 { -libm::log1p(-tails.above) } else { -tails.below.ln() }
}
