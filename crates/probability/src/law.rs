//! Laws of one input, each by its closed form in both tails, and their truncation.
//!
//! A value and a standard normal z belong together: F(x) = Φ(z). All of this crate draws z and asks for x, or has a boundary x
//! and asks for z, so that sampling, correlation and exact integration share one path. Between the two stand [`Tails`], the
//! probability below and above, of which the smaller is exact: 1 − 1e-20 is 1, 1e-20 is not.
//!
//! A value with a probability of its own, as discrete laws and samples have, belongs to all z from that of the values below it on; the z of
//! a boundary at the value itself leaves it above. So an interval from a boundary on holds what lies at it.

use std::f64::consts::PI;

use crate::{beta, gamma, normal};
use atoms::Atoms;
use mixture::Mixture;
pub use truncated::Distribution;

mod atoms;
mod mixture;
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
    MaxOf {
        of: Box<Distribution>,
        count: f64,
    },
}

const EULER: f64 = 0.577_215_664_901_532_9;

type Checked = Result<Law, LawError>;

/// A parameter that has to be a number, or a number above zero.
struct LawName(&'static str);

impl LawName {
    fn number(&self, parameter: &'static str, value: f64) -> Result<(), LawError> {
        self.hold(parameter, value, value.is_finite(), "a number")
    }

    fn positive(&self, parameter: &'static str, value: f64) -> Result<(), LawError> {
        self.hold(parameter, value, value.is_finite() && value > 0.0, "a number above 0")
    }

    fn hold(
        &self,
        parameter: &'static str,
        value: f64,
        holds: bool,
        expected: &'static str,
    ) -> Result<(), LawError> {
        if holds { Ok(()) } else { Err(LawError::Parameter { law: self.0, parameter, value, expected }) }
    }
}

impl Law {
    /// The normal law.
    ///
    /// # Errors
    /// Unless `mean` is a number and `sd` one above zero.
    pub fn normal(mean: f64, sd: f64) -> Checked {
        let of = LawName("normal");
        of.number("mean", mean)?;
        of.positive("sd", sd)?;
        Ok(Law(Kind::Normal { mean, sd }))
    }

    /// The lognormal law of this mean and standard deviation: ln X has the variance ln(1 + (sd/mean)²).
    ///
    /// # Errors
    /// Unless both are numbers above zero.
    pub fn lognormal(mean: f64, sd: f64) -> Checked {
        let of = LawName("lognormal");
        of.positive("mean", mean)?;
        of.positive("sd", sd)?;
        let cov = sd / mean;
        let variance = libm::log1p(cov * cov);
        Ok(Law(Kind::LogNormal { mean: mean.ln() - 0.5 * variance, sd: variance.sqrt() }))
    }

    /// Gumbel's law of maxima, F = exp(−exp(−(x − mode)/scale)).
    ///
    /// # Errors
    /// Unless `mode` is a number and `scale` one above zero.
    pub fn gumbel(mode: f64, scale: f64) -> Checked {
        let of = LawName("gumbel");
        of.number("mode", mode)?;
        of.positive("scale", scale)?;
        Ok(Law(Kind::Gumbel { mode, scale }))
    }

    /// Gumbel's law of this mean and standard deviation: scale = sd √6/π, mode = mean − 0.5772 scale.
    ///
    /// # Errors
    /// Unless `mean` is a number and `sd` one above zero.
    pub fn gumbel_of_mean(mean: f64, sd: f64) -> Checked {
        let of = LawName("gumbel");
        of.number("mean", mean)?;
        of.positive("sd", sd)?;
        let scale = sd * 6f64.sqrt() / PI;
        Law::gumbel(mean - EULER * scale, scale)
    }

    /// Gumbel's law of yearly maxima by two values, each exceeded once in so many years on average: F(value) = 1 − 1/years.
    ///
    /// # Errors
    /// Unless both periods are above one year, and the longer has the larger value.
    pub fn gumbel_of_returns(first: (f64, f64), second: (f64, f64)) -> Checked {
        let of = LawName("gumbel");
        let reduced = |(years, value): (f64, f64)| {
            of.hold("years", years, years.is_finite() && years > 1.0, "a return period above 1 year")?;
            of.number("value", value)?;
            Ok::<_, LawError>(-(-libm::log1p(-1.0 / years)).ln())
        };
        let (y1, y2) = (reduced(first)?, reduced(second)?);
        of.hold("years", second.0, y1 != y2, "two return periods that differ")?;
        let scale = (second.1 - first.1) / (y2 - y1);
        of.hold("value", second.1, scale > 0.0, "the longer return period to have the larger value")?;
        Law::gumbel(first.1 - scale * y1, scale)
    }

    /// Weibull's law, 1 − F = exp(−((x − location)/scale)^shape).
    ///
    /// # Errors
    /// Unless `location` is a number, `scale` and `shape` are numbers above zero.
    pub fn weibull(scale: f64, shape: f64, location: f64) -> Checked {
        let of = LawName("weibull");
        of.positive("scale", scale)?;
        of.positive("shape", shape)?;
        of.number("location", location)?;
        Ok(Law(Kind::Weibull { location, scale, shape }))
    }

    /// The generalised law of maxima, F = exp(−(1 + ξ(x − location)/scale)^(−1/ξ)); a shape ξ above zero has a heavy upper tail,
    /// one below zero an end, zero is Gumbel's.
    ///
    /// # Errors
    /// Unless `location` and `shape` are numbers and `scale` one above zero.
    pub fn gev(location: f64, scale: f64, shape: f64) -> Checked {
        let of = LawName("gev");
        of.number("location", location)?;
        of.positive("scale", scale)?;
        of.number("shape", shape)?;
        if shape == 0.0 {
            Law::gumbel(location, scale)
        } else {
            Ok(Law(Kind::Gev { location, scale, shape }))
        }
    }

    /// Every value between two numbers alike.
    ///
    /// # Errors
    /// Unless `from` is below `to`.
    pub fn uniform(from: f64, to: f64) -> Checked {
        let of = LawName("uniform");
        of.number("from", from)?;
        of.number("to", to)?;
        of.hold("to", to, from < to, "a number above from")?;
        Ok(Law(Kind::Uniform { from, to }))
    }

    /// A density that rises from zero at `from` to `peak` and falls to zero at `to`.
    ///
    /// # Errors
    /// Unless `from` is below `to`, and `peak` is one of them or lies between.
    pub fn triangular(from: f64, peak: f64, to: f64) -> Checked {
        let of = LawName("triangular");
        of.number("from", from)?;
        of.number("to", to)?;
        of.hold("to", to, from < to, "a number above from")?;
        of.hold("mode", peak, from <= peak && peak <= to, "a number between from and to")?;
        Ok(Law(Kind::Triangular { from, peak, to }))
    }

    /// The gamma law from `location` on: its density goes with y^(shape − 1) e^(−y), y = (x − location)/scale.
    ///
    /// # Errors
    /// Unless `location` is a number, `scale` and `shape` are numbers above zero.
    pub fn gamma(scale: f64, shape: f64, location: f64) -> Checked {
        let of = LawName("gamma");
        of.positive("scale", scale)?;
        of.positive("shape", shape)?;
        of.number("location", location)?;
        Ok(Law(Kind::Gamma { location, scale, shape }))
    }

    /// The gamma law of this mean and standard deviation from `location` on.
    ///
    /// # Errors
    /// Unless `location` is a number, `mean` one above it, and `sd` one above zero.
    pub fn gamma_of_mean(mean: f64, sd: f64, location: f64) -> Checked {
        let of = LawName("gamma");
        of.number("location", location)?;
        of.hold(
            "mean",
            mean,
            mean.is_finite() && mean > location,
            "a number above location, which is 0 if not given",
        )?;
        of.positive("sd", sd)?;
        let (above, variance) = (mean - location, sd * sd);
        Law::gamma(variance / above, above * above / variance, location)
    }

    /// The beta law between two numbers: its density goes with y^(α − 1) (1 − y)^(β − 1), y = (x − from)/(to − from).
    ///
    /// # Errors
    /// Unless `from` is below `to`, and `alpha` and `beta` are numbers above zero.
    pub fn beta(alpha: f64, beta: f64, from: f64, to: f64) -> Checked {
        let of = LawName("beta");
        of.positive("alpha", alpha)?;
        of.positive("beta", beta)?;
        of.number("from", from)?;
        of.number("to", to)?;
        of.hold("to", to, from < to, "a number above from")?;
        Ok(Law(Kind::Beta { from, to, alpha, beta }))
    }

    /// The beta law of this mean and standard deviation between two numbers.
    ///
    /// # Errors
    /// Unless `from` is below `to`, `mean` lies between, and `sd` is above zero and below √((mean − from)(to − mean)).
    pub fn beta_of_mean(mean: f64, sd: f64, from: f64, to: f64) -> Checked {
        let of = LawName("beta");
        of.number("from", from)?;
        of.number("to", to)?;
        of.hold("to", to, from < to, "a number above from")?;
        of.hold("mean", mean, from < mean && mean < to, "a number between from and to")?;
        of.positive("sd", sd)?;
        let (below, above) = (mean - from, to - mean);
        of.hold("sd", sd, sd * sd < below * above, "less than √((mean − from)(to − mean))")?;
        let sum = below * above / (sd * sd) - 1.0;
        Law::beta(below / (to - from) * sum, above / (to - from) * sum, from, to)
    }

    /// The exponential law from `location` on, whose mean lies `scale` above it.
    ///
    /// # Errors
    /// Unless `location` is a number and `scale` one above zero.
    pub fn exponential(scale: f64, location: f64) -> Checked {
        let of = LawName("exponential");
        of.positive("scale", scale)?;
        of.number("location", location)?;
        Ok(Law(Kind::Pareto { location, scale, shape: 0.0 }))
    }

    /// The generalised Pareto law, of what exceeds a threshold: 1 − F = (1 + ξ(x − location)/scale)^(−1/ξ) from `location`, the threshold, on;
    /// a shape ξ above zero has a heavy tail, one below zero an end, zero is the exponential law.
    ///
    /// # Errors
    /// Unless `location` and `shape` are numbers and `scale` one above zero.
    pub fn pareto(location: f64, scale: f64, shape: f64) -> Checked {
        let of = LawName("gpd");
        of.number("location", location)?;
        of.positive("scale", scale)?;
        of.number("shape", shape)?;
        Ok(Law(Kind::Pareto { location, scale, shape }))
    }

    /// These values with these probabilities.
    ///
    /// # Errors
    /// Unless there are as many probabilities as values, all are numbers, no value stands twice, and the probabilities are above zero and add up to 1.
    pub fn discrete(values: &[f64], probabilities: &[f64]) -> Checked {
        Atoms::new(values, probabilities).map(Kind::Discrete).map(Law)
    }

    /// Each of these values as likely, as of a sample; one that stands several times is as often likelier.
    ///
    /// # Errors
    /// If there is no value, or one is not a number.
    pub fn sample(values: &[f64]) -> Checked {
        Atoms::sample(values).map(Kind::Sample).map(Law)
    }

    /// One of several laws, each with its probability.
    ///
    /// # Errors
    /// Unless there are two or more, whose probabilities are above zero and add up to 1.
    pub fn mixture(parts: Vec<(f64, Distribution)>) -> Checked {
        Mixture::new(parts).map(Kind::Mixture).map(Law)
    }

    /// The largest of `count` independent values.
    ///
    /// # Errors
    /// Unless `count` is at least 1.
    pub fn max_of(of: Distribution, count: f64) -> Checked {
        LawName("max_of").hold("count", count, count.is_finite() && count >= 1.0, "1 or more")?;
        Ok(Law(Kind::MaxOf { of: Box::new(of), count }))
    }

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
            Kind::Pareto { shape, .. } if shape == 0.0 => "exponential",
            Kind::Pareto { .. } => "gpd",
            Kind::Discrete(_) => "discrete",
            Kind::Sample(_) => "sample",
            Kind::Mixture(_) => "mixture",
            Kind::MaxOf { .. } => "max_of",
        }
    }

    /// The numbers between which the law has values.
    pub fn support(&self) -> (f64, f64) {
        match self.0 {
            Kind::Normal { .. } | Kind::Gumbel { .. } => (f64::NEG_INFINITY, f64::INFINITY),
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

    /// The values with a probability of their own, if it has no others.
    fn atoms(&self) -> Option<&Atoms> {
        match &self.0 {
            Kind::Discrete(atoms) | Kind::Sample(atoms) => Some(atoms),
            Kind::MaxOf { of, .. } => of.law().atoms(),
            _ => None,
        }
    }

    /// Values at which the law is not smooth, as [`Distribution::breaks`] has them.
    fn breaks(&self) -> Vec<f64> {
        match &self.0 {
            Kind::Triangular { peak, .. } => vec![*peak],
            Kind::Discrete(atoms) | Kind::Sample(atoms) => atoms.breaks(),
            Kind::Mixture(mixture) => mixture.breaks(),
            Kind::MaxOf { of, .. } => of.breaks(),
            _ => Vec::new(),
        }
    }

    /// True if a value has a probability of its own.
    fn has_atoms(&self) -> bool {
        match &self.0 {
            Kind::Mixture(mixture) => mixture.has_atoms(),
            _ => self.atoms().is_some(),
        }
    }

    /// The standard normal value that belongs to `x`.
    fn z(&self, x: f64) -> f64 {
        match self.0 {
            Kind::Normal { mean, sd } => (x - mean) / sd,
            Kind::LogNormal { .. } if x <= 0.0 => f64::NEG_INFINITY,
            Kind::LogNormal { mean, sd } => (x.ln() - mean) / sd,
            _ => self.tails(x).z(),
        }
    }

    /// The probabilities below `x`, and at or above it.
    fn tails(&self, x: f64) -> Tails {
        match self.0 {
            Kind::Normal { .. } | Kind::LogNormal { .. } => Tails::of(self.z(x)),
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
            _ => self.value_at(Tails::of(z)),
        }
    }

    /// The value with these probabilities below and above it.
    fn value_at(&self, tails: Tails) -> f64 {
        match self.0 {
            Kind::Normal { .. } | Kind::LogNormal { .. } => self.value(tails.z()),
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
