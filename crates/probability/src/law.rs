//! Laws of one input, each by its closed form in both tails, and their truncation.
//!
//! A value and a standard normal z belong together: F(x) = Φ(z). All of this crate draws z and asks for x, or has a boundary x
//! and asks for z, so that sampling, correlation and exact integration share one path. Between the two stand [`Tails`], the
//! probability below and above, of which the smaller is exact: 1 − 1e-20 is 1, 1e-20 is not.

use std::f64::consts::PI;

use crate::normal;

/// The probability below a value and that above it. They add up to 1; the smaller has all its digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tails {
    /// P(X < x).
    pub below: f64,
    /// P(X > x).
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
    Normal { mean: f64, sd: f64 },
    LogNormal { mean: f64, sd: f64 },
    Gumbel { mode: f64, scale: f64 },
    Weibull { location: f64, scale: f64, shape: f64 },
    Gev { location: f64, scale: f64, shape: f64 },
    Uniform { from: f64, to: f64 },
    Triangular { from: f64, peak: f64, to: f64 },
    MaxOf { of: Box<Distribution>, count: f64 },
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
            Kind::MaxOf { .. } => "max_of",
        }
    }

    /// The numbers between which the law has values.
    pub fn support(&self) -> (f64, f64) {
        match self.0 {
            Kind::Normal { .. } | Kind::Gumbel { .. } => (f64::NEG_INFINITY, f64::INFINITY),
            Kind::LogNormal { .. } => (0.0, f64::INFINITY),
            Kind::Weibull { location, .. } => (location, f64::INFINITY),
            Kind::Gev { location, scale, shape } if shape > 0.0 => (location - scale / shape, f64::INFINITY),
            Kind::Gev { location, scale, shape } => (f64::NEG_INFINITY, location - scale / shape),
            Kind::Uniform { from, to } | Kind::Triangular { from, to, .. } => (from, to),
            Kind::MaxOf { ref of, .. } => of.support(),
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

    /// The probabilities below and above `x`.
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
        let (at_lower, at_upper) = (law.tails(lower), law.tails(upper));
        let mass = if at_lower.below > 0.5 {
            at_lower.above - at_upper.above
        } else {
            at_upper.below - at_lower.below
        };
        // A mass that is NaN comes of a bound that is.
        if mass.is_nan() || mass <= 0.0 || lower >= upper {
            return Err(LawError::Empty { lower, upper });
        }
        let cut = Tails { below: at_lower.below, above: at_upper.above };
        Ok(Distribution { law, bounds: Some(Bounds { lower, upper, cut, mass }) })
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

    /// The probabilities below and above `x`.
    pub fn tails(&self, x: f64) -> Tails {
        let t = self.law.tails(x);
        let Some(b) = self.bounds else { return t };
        if x <= b.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        if x >= b.upper {
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

    /// The value that is exceeded as often as not.
    pub fn median(&self) -> f64 {
        self.value(0.0)
    }
}
