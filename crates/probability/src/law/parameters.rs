//! Laws by their parameters, which are checked.

use std::f64::consts::PI;

use super::atoms::Atoms;
use super::curve::Curve;
use super::mixture::Mixture;
use super::{Distribution, Kind, Law, LawError};

/// Euler's constant.
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

    /// The lognormal law of which the logarithm has this mean and standard deviation.
    ///
    /// # Errors
    /// Unless `mean` is a number and `sd` one above zero.
    pub fn lognormal_of_logs(mean: f64, sd: f64) -> Checked {
        let of = LawName("lognormal");
        of.number("log_mean", mean)?;
        of.positive("log_sd", sd)?;
        Ok(Law(Kind::LogNormal { mean, sd }))
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

    /// The law with these values at these standard normals, both rising: between them a cubic that rises as well, beyond them a straight line
    /// over the normal.
    ///
    /// # Errors
    /// Unless there are two or more, and both rise.
    pub fn quantiles(normals: &[f64], values: &[f64]) -> Checked {
        Curve::new(normals, values).map(Kind::Quantiles).map(Law)
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
}
