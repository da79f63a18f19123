//! Laws fitted to values that were measured, and how sure their parameters are.
//!
//! The parameters are the likeliest. What so few values leave uncertain is told by the observed information, the second derivatives of the
//! log-likelihood there: parameters are about normal, scales and shapes above zero about lognormal, with the inverse of the information for
//! covariance.
//!
//! ```
//! use standfast_probability::fit::{Family, Fit};
//!
//! let heights = [4.1, 5.2, 3.8, 4.6, 6.0, 4.4, 3.9, 5.5, 4.9, 4.2];
//! let fit = Fit::of(Family::Gumbel, &heights, 0.0)?;
//! let [mode, scale] = &fit.parameters[..] else { unreachable!() };
//! assert!((mode.estimate - 4.3365).abs() < 1e-4 && (scale.estimate - 0.5402).abs() < 1e-4);
//! // The observed information; that of many values makes it 1.053 scale/√n and 0.78/√n.
//! assert!((mode.deviation - 0.1798).abs() < 1e-4 && (scale.deviation - 0.2588).abs() < 1e-4);
//! # Ok::<(), standfast_probability::fit::FitError>(())
//! ```

use thiserror::Error;

use crate::law::{Law, LawError};
use crate::simplex::simplex;

/// Family of laws, one of which is fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The normal law.
    Normal,
    /// The lognormal law.
    LogNormal,
    /// Gumbel's law of maxima.
    Gumbel,
    /// Weibull's law, from an origin on.
    Weibull,
    /// The generalised law of extreme values.
    Gev,
    /// The exponential law, from an origin on.
    Exponential,
    /// The generalised Pareto law, from an origin on: of peaks over a threshold.
    Pareto,
}

/// A parameter of a law that was fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedParameter {
    /// Its name, as in a case file.
    pub name: &'static str,
    /// The likeliest value.
    pub estimate: f64,
    /// Its standard deviation; of a parameter above zero that of its logarithm.
    pub deviation: f64,
    /// True if it is above zero, and its logarithm about normal.
    pub is_positive: bool,
    /// True if it is of the dimension of the values.
    pub has_dimension: bool,
}

impl FittedParameter {
    /// The law of what it may be.
    ///
    /// # Errors
    /// If its deviation is zero.
    pub fn law(&self) -> Result<Law, LawError> {
        if self.is_positive {
            Law::lognormal_of_logs(self.estimate.ln(), self.deviation)
        } else {
            Law::normal(self.estimate, self.deviation)
        }
    }
}

/// A law fitted to values.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The family.
    pub family: Family,
    /// Value from which on laws of some families have values.
    pub origin: f64,
    /// The parameters.
    pub parameters: Vec<FittedParameter>,
    /// Their correlation, or that of the logarithms of those above zero.
    pub correlation: Vec<Vec<f64>>,
    /// Number of values.
    pub count: usize,
}

/// Reason why nothing was fitted.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// Too few values, or all of them alike.
    #[error("{count} values, {different} of them different; expected {least} different ones or more")]
    Few {
        /// Number of values.
        count: usize,
        /// Number of those that differ.
        different: usize,
        /// The least number.
        least: usize,
    },
    /// A value that no law of the family has.
    #[error("the value {value}; expected values above {origin}")]
    Outside {
        /// The value.
        value: f64,
        /// Bound of the family.
        origin: f64,
    },
    /// The likelihood has no greatest value in the regular range of the shape.
    #[error(
        "no likeliest shape above −0.5 and below 1, where a law's likelihood is regular; expected values that another family fits"
    )]
    Shape,
    /// The likelihood has no greatest value.
    #[error("no likeliest parameters; expected values that scatter more, or that another family fits")]
    Flat,
}

/// The least number of values that differ.
const LEAST: usize = 5;
/// The shapes between which the likelihood is regular, and the law has a mean.
const SHAPES: [f64; 2] = [-0.5, 1.0];

impl Fit {
    /// The likeliest law of a family for these values. Those of Weibull's, the exponential and the Pareto law lie above `origin`.
    ///
    /// # Errors
    /// If there are too few values, one lies outside of what the family has, or the shape is not regular.
    pub fn of(family: Family, values: &[f64], origin: f64) -> Result<Fit, FitError> {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        if sorted.len() < LEAST {
            return Err(FitError::Few { count: values.len(), different: sorted.len(), least: LEAST });
        }
        let origin = if family.has_origin() { origin } else { 0.0 };
        let is_inside = |value: f64| match family {
            Family::Weibull | Family::LogNormal => value > origin,
            // A value at a threshold is over it.
            Family::Exponential | Family::Pareto => value >= origin,
            Family::Normal | Family::Gumbel | Family::Gev => true,
        };
        if let Some(value) = values.iter().find(|value| !(value.is_finite() && is_inside(**value))) {
            return Err(FitError::Outside { value: *value, origin });
        }
        // In units in which they are about one, or have the deviation one about zero; of logarithms for the lognormal law.
        let of_logs = family == Family::LogNormal;
        let plain: Vec<f64> = values.iter().map(|x| if of_logs { x.ln() } else { x - origin }).collect();
        let n = plain.len() as f64;
        let mean = plain.iter().sum::<f64>() / n;
        let sd = (plain.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
        let (from, unit) = if family.has_location() { (mean, sd) } else { (0.0, mean) };
        let scaled: Vec<f64> = plain.iter().map(|x| (x - from) / unit).collect();
        let mut f = |at: &[f64]| -> f64 {
            let sum: f64 = scaled.iter().map(|x| family.log_density(at, *x)).sum();
            if sum.is_nan() { f64::INFINITY } else { -sum }
        };
        let mut best = simplex(&mut f, family.start(), 0.2).1;
        for _ in 0..4 {
            best = simplex(&mut f, &best, 0.05).1;
        }
        if let Some(shape) = family.shape(&best)
            && !(SHAPES[0] < shape && shape < SHAPES[1])
        {
            return Err(FitError::Shape);
        }
        let has_shape = family.shape(&best).is_some();
        let none = || if has_shape { FitError::Shape } else { FitError::Flat };
        let covariance = inverse(information(&mut f, &mut best)).ok_or_else(none)?;
        let parameters = family.parameters().iter().enumerate().map(|(i, &(name, kind))| {
            let deviation = covariance[i][i].sqrt();
            let (estimate, deviation) = match kind {
                Kind::Location => (from + unit * best[i], unit * deviation),
                Kind::Scale => (unit * best[i].exp(), deviation),
                Kind::LogScale | Kind::Above => (best[i].exp(), deviation),
                Kind::Plain => (best[i], deviation),
            };
            // Of logarithms that were divided by their deviation.
            let estimate = if kind == Kind::LogScale { unit * estimate } else { estimate };
            FittedParameter {
                name,
                estimate,
                deviation,
                is_positive: matches!(kind, Kind::Scale | Kind::LogScale | Kind::Above),
                has_dimension: matches!(kind, Kind::Location | Kind::Scale) && !of_logs,
            }
        });
        let correlation = |i: usize, j: usize| {
            if i == j { 1.0 } else { covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt() }
        };
        let count = covariance.len();
        Ok(Fit {
            family,
            origin,
            parameters: parameters.collect(),
            correlation: (0..count).map(|i| (0..count).map(|j| correlation(i, j)).collect()).collect(),
            count: values.len(),
        })
    }

    /// The likeliest law.
    ///
    /// # Errors
    /// If a parameter is not a number.
    pub fn likeliest(&self) -> Result<Law, LawError> {
        let estimates: Vec<f64> = self.parameters.iter().map(|parameter| parameter.estimate).collect();
        self.family.law(&estimates, self.origin)
    }
}

/// Kind of a parameter, by the coordinate in which it is about normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Of the dimension of the values, itself.
    Location,
    /// Of the dimension of the values, above zero.
    Scale,
    /// Deviation of logarithms.
    LogScale,
    /// A shape above zero.
    Above,
    /// A shape of either sign.
    Plain,
}

impl Family {
    /// All of them.
    pub const ALL: [Family; 7] = [
        Family::Normal,
        Family::LogNormal,
        Family::Gumbel,
        Family::Weibull,
        Family::Gev,
        Family::Exponential,
        Family::Pareto,
    ];

    /// The name of its laws, as in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Family::Normal => "normal",
            Family::LogNormal => "lognormal",
            Family::Gumbel => "gumbel",
            Family::Weibull => "weibull",
            Family::Gev => "gev",
            Family::Exponential => "exponential",
            Family::Pareto => "gpd",
        }
    }

    /// True if its laws begin at an origin.
    pub fn has_origin(self) -> bool {
        matches!(self, Family::Weibull | Family::Exponential | Family::Pareto)
    }

    fn has_location(self) -> bool {
        !self.has_origin()
    }

    fn parameters(self) -> &'static [(&'static str, Kind)] {
        match self {
            Family::Normal => &[("mean", Kind::Location), ("sd", Kind::Scale)],
            Family::LogNormal => &[("log_mean", Kind::Location), ("log_sd", Kind::LogScale)],
            Family::Gumbel => &[("mode", Kind::Location), ("scale", Kind::Scale)],
            Family::Weibull => &[("scale", Kind::Scale), ("shape", Kind::Above)],
            Family::Gev => &[("location", Kind::Location), ("scale", Kind::Scale), ("shape", Kind::Plain)],
            Family::Exponential => &[("scale", Kind::Scale)],
            Family::Pareto => &[("scale", Kind::Scale), ("shape", Kind::Plain)],
        }
    }

    /// The law with these parameters, in their order.
    ///
    /// # Errors
    /// If a parameter is none that the law has.
    pub fn law(self, parameters: &[f64], origin: f64) -> Result<Law, LawError> {
        match (self, parameters) {
            (Family::Normal, &[mean, sd]) => Law::normal(mean, sd),
            (Family::LogNormal, &[mean, sd]) => Law::lognormal_of_logs(mean, sd),
            (Family::Gumbel, &[mode, scale]) => Law::gumbel(mode, scale),
            (Family::Weibull, &[scale, shape]) => Law::weibull(scale, shape, origin),
            (Family::Gev, &[location, scale, shape]) => Law::gev(location, scale, shape),
            (Family::Exponential, &[scale]) => Law::exponential(scale, origin),
            (Family::Pareto, &[scale, shape]) => Law::pareto(origin, scale, shape),
            _ => Law::normal(f64::NAN, f64::NAN),
        }
    }

    /// Coordinates of parameters of values in their units: locations and shapes of either sign themselves, others by their logarithms.
    fn start(self) -> &'static [f64] {
        match self {
            Family::Normal | Family::LogNormal => &[0.0, 0.0],
            Family::Gumbel => &[-0.45, -0.25],
            Family::Weibull => &[0.1, 0.5],
            Family::Gev => &[-0.45, -0.25, 0.01],
            Family::Exponential => &[0.0],
            Family::Pareto => &[0.0, 0.01],
        }
    }

    /// The shape of either sign among coordinates.
    fn shape(self, at: &[f64]) -> Option<f64> {
        matches!(self, Family::Gev | Family::Pareto).then(|| at[at.len() - 1])
    }

    /// The logarithm of the density at a value, in its unit; −∞ where there is none.
    fn log_density(self, at: &[f64], x: f64) -> f64 {
        match (self, at) {
            (Family::Normal | Family::LogNormal, &[mean, log]) => {
                let z = (x - mean) * (-log).exp();
                -0.5 * z * z - log
            }
            (Family::Gumbel, &[mode, log]) => {
                let z = (x - mode) * (-log).exp();
                -z - (-z).exp() - log
            }
            (Family::Weibull, &[log, log_shape]) => {
                let shape = log_shape.exp();
                let rate = x.ln() - log;
                log_shape - log + (shape - 1.0) * rate - (shape * rate).exp()
            }
            (Family::Gev, &[location, log, shape]) => {
                let z = (x - location) * (-log).exp();
                let reduced = reduced(z, shape);
                -(1.0 + shape) * reduced - (-reduced).exp() - log
            }
            (Family::Exponential, &[log]) => -x * (-log).exp() - log,
            (Family::Pareto, &[log, shape]) => -(1.0 + shape) * reduced(x * (-log).exp(), shape) - log,
            _ => f64::NAN,
        }
    }
}

/// ln(1 + ξz)/ξ, z where ξ is zero; not a number where there is no density.
fn reduced(z: f64, shape: f64) -> f64 {
    if shape == 0.0 { z } else { libm::log1p(shape * z) / shape }
}

/// The second derivatives of a function at its minimum, which is moved there by a few of Newton's steps.
fn information(f: &mut impl FnMut(&[f64]) -> f64, at: &mut [f64]) -> Vec<Vec<f64>> {
    /// Step of differences, of coordinates about one.
    const STEP: f64 = 1e-3;
    let n = at.len();
    let mut moved = |at: &[f64], steps: &[(usize, f64)]| {
        let mut at = at.to_vec();
        steps.iter().for_each(|(i, step)| at[*i] += step * STEP);
        f(&at)
    };
    let mut second = Vec::new();
    for _ in 0..3 {
        let here = moved(at, &[]);
        // Of the fourth order, as the parameters are told to six digits.
        let mut of = |i: usize, j: usize| {
            if i == j {
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|step| moved(at, &[(i, step)]));
                return (-a + 16.0 * b - 30.0 * here + 16.0 * c - d) / (12.0 * STEP * STEP);
            }
            let mut mixed = |h: f64| {
                let [a, b, c, d] = [(h, h), (h, -h), (-h, h), (-h, -h)]
                    .map(|(one, other)| moved(at, &[(i, one), (j, other)]));
                (a - b - c + d) / (4.0 * h * h * STEP * STEP)
            };
            (4.0 * mixed(1.0) - mixed(2.0)) / 3.0
        };
        second = (0..n).map(|i| (0..n).map(|j| of(i.max(j), i.min(j))).collect()).collect();
        let slope: Vec<f64> = (0..n)
            .map(|i| {
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|step| moved(at, &[(i, step)]));
                (a - 8.0 * b + 8.0 * c - d) / (12.0 * STEP)
            })
            .collect();
        let Some(inverse) = inverse(second.clone()) else { break };
        for (at, row) in at.iter_mut().zip(&inverse) {
            *at -= row.iter().zip(&slope).map(|(a, b)| a * b).sum::<f64>();
        }
    }
    second
}

/// The inverse of a matrix that is symmetric; `None` unless it is positive definite.
fn inverse(mut matrix: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let mut inverse: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect();
    for i in 0..n {
        // Gauss and Jordan; pivots of a positive definite matrix are above zero.
        let pivot = matrix[i][i];
        if pivot.is_nan() || pivot <= 0.0 || pivot.is_infinite() {
            return None;
        }
        for k in 0..n {
            matrix[i][k] /= pivot;
            inverse[i][k] /= pivot;
        }
        for j in (0..n).filter(|j| *j != i) {
            let factor = matrix[j][i];
            for k in 0..n {
                matrix[j][k] -= factor * matrix[i][k];
                inverse[j][k] -= factor * inverse[i][k];
            }
        }
    }
    Some(inverse)
}
