//! Regions of a plane, between lines and hyperbolas: where one mode holds. The plane is the report's, of force k and friction
//! μ, or for any load that of load factor λ and friction μ.

use crate::mode::Mode;

/// A curve μ(k).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// μ = slope·k + intercept.
    Line {
        /// dμ/dk.
        slope: f64,
        /// μ at k = 0.
        intercept: f64,
    },
    /// μ = (a k + b)/(c k + d).
    Hyperbola {
        /// Coefficient of k above.
        a: f64,
        /// Constant above.
        b: f64,
        /// Coefficient of k below.
        c: f64,
        /// Constant below.
        d: f64,
    },
}

impl Curve {
    /// The k axis, μ = 0.
    pub const AXIS: Curve = Curve::Line { slope: 0.0, intercept: 0.0 };
    /// The line OA, μ = k.
    pub const DIAGONAL: Curve = Curve::Line { slope: 1.0, intercept: 0.0 };

    /// μ at k; not finite at a pole.
    pub fn at(&self, k: f64) -> f64 {
        match *self {
            Curve::Line { slope, intercept } => slope * k + intercept,
            Curve::Hyperbola { a, b, c, d } => (a * k + b) / (c * k + d),
        }
    }

    /// The k at which a hyperbola has its vertical asymptote, if it has one: d/c for μ** (4.97).
    pub fn pole(&self) -> Option<f64> {
        match *self {
            Curve::Hyperbola { c, d, .. } => Some(-d / c).filter(|k| k.is_finite()),
            Curve::Line { .. } => None,
        }
    }

    /// dμ/dk at k (3.24, 4.47).
    pub fn slope(&self, k: f64) -> f64 {
        match *self {
            Curve::Line { slope, .. } => slope,
            Curve::Hyperbola { a, b, c, d } => (a * d - b * c) / (c * k + d).powi(2),
        }
    }

    /// The k at which the curve has the value `mu`, if there is one.
    pub fn k_at(&self, mu: f64) -> Option<f64> {
        let k = match *self {
            Curve::Line { slope, intercept } => (mu - intercept) / slope,
            Curve::Hyperbola { a, b, c, d } => (b - mu * d) / (mu * c - a),
        };
        k.is_finite().then_some(k)
    }
}

/// The part of a region between two values of k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Smallest k.
    pub from: f64,
    /// Largest k, possibly infinite.
    pub to: f64,
    /// The curve the strip lies above.
    pub lower: Curve,
    /// The curve the strip lies below; `None` if it is open at the top.
    pub upper: Option<Curve>,
}

impl Strip {
    /// True if (k, μ) lies in the strip or on its edge, in floating point. The mode that owns an edge is
    /// [`Diagram::mode_at`](crate::Diagram::mode_at)'s to say, exactly.
    pub fn contains(&self, k: f64, mu: f64) -> bool {
        let below = self.upper.is_none_or(|upper| mu <= upper.at(k));
        self.from <= k && k <= self.to && self.lower.at(k) <= mu && below
    }
}

/// A connected region of a plane: strips from left to right, each beginning where the last ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// The mode that holds in it.
    pub mode: Mode,
    /// Its strips, never empty.
    pub strips: Vec<Strip>,
}

impl Region {
    /// True if (k, μ) lies in the region or on its edge, in floating point.
    pub fn contains(&self, k: f64, mu: f64) -> bool {
        self.strips.iter().any(|strip| strip.contains(k, mu))
    }
}
