//! The lines, curves and named points of the k–μ plane of one body and one elevation of the force.

use std::ops::Range;

use crate::error::InputError;
use crate::quantity::Quantity;
use crate::region::Curve;

/// The k–μ plane for a slenderness γ and an elevation k': coefficients, curves and named points.
///
/// ```
/// use standfast::initiation::{Chart, PointName};
///
/// let chart = Chart::new(1.0, 0.4)?;
/// let a = chart.point(PointName::A).unwrap();
/// assert!((a.k - 0.714286).abs() < 1e-6);
/// assert!((chart.mu_star().at(a.k) - a.mu).abs() < 1e-15); // μ* passes through A
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chart {
    gamma: f64,
    k_prime: f64,
}

/// The report's cases of force above (k' ≥ 0) and below (k' < 0) the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ChartCase {
    /// 0 ≤ k' ≤ (1+γ²)/(3γ²): μ* rises from A (Figs. 3.3a, 3.6a, 3.9a).
    OneA,
    /// (1+γ²)/(3γ²) < k' ≤ (4+γ²)/(3γ²): μ* falls from A (Figs. 3.3b, 3.6b, 3.9b).
    OneB,
    /// k' > (4+γ²)/(3γ²), so a < 0: μ* falls from A to zero at E and rises again. The report treats k ≤ k_E as
    /// case 2 (Figs. 3.4, 3.7, 3.10) and k ≥ k_E as case 3 (Figs. 3.5, 3.8, 3.11).
    TwoThree,
    /// −1 ≤ k' < 0 and Δ > 0: μ* leaves A steeper than AB and crosses it at B' (Figs. 4.4a–4.7a).
    DeltaPositive,
    /// −1 ≤ k' < 0 and Δ ≤ 0: μ* stays below AB (Figs. 4.4b–4.7b).
    DeltaNotPositive,
    /// k' < −1: effective loads only; O' takes the part of O. Outside the report.
    BelowBase,
}

impl ChartCase {
    /// All cases, from the lowest elevation of the force to the highest.
    pub const ALL: [ChartCase; 6] = [
        ChartCase::BelowBase,
        ChartCase::DeltaNotPositive,
        ChartCase::DeltaPositive,
        ChartCase::OneA,
        ChartCase::OneB,
        ChartCase::TwoThree,
    ];

    /// The k' between which a body of slenderness γ is in this case: (1+γ²)/(3γ²), (4+γ²)/(3γ²) and −(1+γ²)/(4+γ²)
    /// part them, beside 0 and −1.
    ///
    /// # Errors
    /// If `gamma` is not above zero.
    pub fn k_primes(self, gamma: f64) -> Result<Range<f64>, InputError> {
        let square = InputError::positive(Quantity::Slenderness, gamma)?.powi(2);
        let (level, zero) = ((1.0 + square) / (3.0 * square), (4.0 + square) / (3.0 * square));
        let steep = -(1.0 + square) / (4.0 + square);
        Ok(match self {
            ChartCase::BelowBase => f64::NEG_INFINITY..-1.0,
            ChartCase::DeltaNotPositive => -1.0..steep,
            ChartCase::DeltaPositive => steep..0.0,
            ChartCase::OneA => 0.0..level,
            ChartCase::OneB => level..zero,
            ChartCase::TwoThree => zero..f64::INFINITY,
        })
    }

    /// The case's short name: `1a`, `1b`, `2–3`, `Δ > 0`, `Δ ≤ 0`, `k' < −1`.
    pub fn name(self) -> &'static str {
        match self {
            ChartCase::OneA => "1a",
            ChartCase::OneB => "1b",
            ChartCase::TwoThree => "2–3",
            ChartCase::DeltaPositive => "Δ > 0",
            ChartCase::DeltaNotPositive => "Δ ≤ 0",
            ChartCase::BelowBase => "k' < −1",
        }
    }

    /// The case in words and symbols.
    pub fn words(self) -> &'static str {
        match self {
            ChartCase::OneA => "case 1a, force above the centre: k' ≤ (1+γ²)/(3γ²)",
            ChartCase::OneB => "case 1b, force above the centre: (1+γ²)/(3γ²) < k' ≤ (4+γ²)/(3γ²)",
            ChartCase::TwoThree => "cases 2 and 3, force above the centre: k' > (4+γ²)/(3γ²)",
            ChartCase::DeltaPositive => "force below the centre, Δ > 0: |k'| < (1+γ²)/(4+γ²)",
            ChartCase::DeltaNotPositive => "force below the centre, Δ ≤ 0: |k'| ≥ (1+γ²)/(4+γ²)",
            ChartCase::BelowBase => "effective force below the base: k' < −1",
        }
    }
}

/// The report's letters for points of the k–μ plane. Letters that change their meaning between chapters III and
/// IV (B, C, E as far ends of lines) are drawn by the figures; these are points with coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PointName {
    /// Point at which rest, slide and rock meet: k = μ = 1/(γ|1+k'|).
    A,
    /// μ* crosses AB (4.48, 4.49); chapter IV with Δ > 0.
    BPrime,
    /// (0, 1/γ): foot of the line CD; chapter III.
    C,
    /// μ* crosses DC; chapter IV, 0 < |k'| < 1.
    CPrime,
    /// (1/(γ|k'|), 0): where CD (chapter III) or DC (chapter IV) meets the k axis.
    D,
    /// (b/|a|, 0): zero of μ*; chapter III with a < 0.
    E,
    /// (b/a, 0): zero of μ**; chapter IV.
    F,
}

impl PointName {
    /// The letter, e.g. `B'`.
    pub fn letter(self) -> &'static str {
        match self {
            PointName::A => "A",
            PointName::BPrime => "B'",
            PointName::C => "C",
            PointName::CPrime => "C'",
            PointName::D => "D",
            PointName::E => "E",
            PointName::F => "F",
        }
    }
}

/// A named point of the k–μ plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedPoint {
    /// Its letter.
    pub name: PointName,
    /// Its abscissa.
    pub k: f64,
    /// Its ordinate.
    pub mu: f64,
}

impl Chart {
    /// The plane for γ and k', any real number.
    ///
    /// # Errors
    /// If a number is not finite or `gamma` is not above zero.
    pub fn new(gamma: f64, k_prime: f64) -> Result<Chart, InputError> {
        Ok(Chart {
            gamma: InputError::positive(Quantity::Slenderness, gamma)?,
            k_prime: InputError::finite(Quantity::KPrime, k_prime)?,
        })
    }

    pub(super) fn of_valid(gamma: f64, k_prime: f64) -> Chart {
        Chart { gamma, k_prime }
    }

    /// γ = H/B.
    pub fn gamma(&self) -> f64 {
        self.gamma
    }

    /// k'.
    pub fn k_prime(&self) -> f64 {
        self.k_prime
    }

    /// a, b, c, d of μ* (3.18–3.21, 4.42–4.45): a = 4 + γ² − 3γ²k', b = 3γ, c = 3γ(1+k'), d = 1 + 4γ².
    pub fn coefficients(&self) -> [f64; 4] {
        let Chart { gamma: γ, k_prime } = *self;
        [4.0 + γ * γ - 3.0 * γ * γ * k_prime, 3.0 * γ, 3.0 * γ * (1.0 + k_prime), 1.0 + 4.0 * γ * γ]
    }

    /// The report's case, computed in f64: within rounding of a threshold, where neighbouring cases draw the same
    /// picture, it may be either. Modes do not depend on it.
    pub fn case(&self) -> ChartCase {
        let Chart { gamma: γ, k_prime } = *self;
        if k_prime < -1.0 {
            ChartCase::BelowBase
        } else if k_prime < 0.0 {
            if self.delta() > 0.0 { ChartCase::DeltaPositive } else { ChartCase::DeltaNotPositive }
        } else if 3.0 * γ * γ * k_prime <= 1.0 + γ * γ {
            ChartCase::OneA
        } else if 3.0 * γ * γ * k_prime <= 4.0 + γ * γ {
            ChartCase::OneB
        } else {
            ChartCase::TwoThree
        }
    }

    /// Δ = [(1+γ²) + k'(4+γ²)]/[4(1+γ²)], the slope of μ* at A less that of AB (IV.3).
    pub fn delta(&self) -> f64 {
        let Chart { gamma: γ, k_prime } = *self;
        ((1.0 + γ * γ) + k_prime * (4.0 + γ * γ)) / (4.0 * (1.0 + γ * γ))
    }

    /// μ = 1/γ − k k': CD of chapter III, AB of chapter IV. On it the sliding body's reaction is at O.
    pub fn upper_line(&self) -> Curve {
        Curve::Line { slope: -self.k_prime, intercept: 1.0 / self.gamma }
    }

    /// μ = −1/γ − k k': DC of chapter IV. On it the sliding body's reaction is at O'.
    pub fn lower_line(&self) -> Curve {
        Curve::Line { slope: -self.k_prime, intercept: -1.0 / self.gamma }
    }

    /// μ = −k k', in chapter IV μ = k|k'| (4.22): on it the sliding body's reaction is below C, ξ = 0.
    pub fn centre_line(&self) -> Curve {
        Curve::Line { slope: -self.k_prime, intercept: 0.0 }
    }

    /// μ = −1/γ + k k' (3.44): below it the body turns about O with friction pushing to the left.
    pub fn turning_line(&self) -> Curve {
        Curve::Line { slope: self.k_prime, intercept: -1.0 / self.gamma }
    }

    /// |a|/|c|, the limit of μ* (and of μ**) for large k (4.46); infinite for k' = −1.
    pub fn mu_star_limit(&self) -> f64 {
        let [a, _, c, _] = self.coefficients();
        (a / c).abs()
    }

    /// μ*(k) = (a k + b)/(c k + d) (3.24, 4.40), signed: right of E (a < 0) it is negative and the bound is
    /// [`mu_star_rising`](Chart::mu_star_rising).
    pub fn mu_star(&self) -> Curve {
        let [a, b, c, d] = self.coefficients();
        Curve::Hyperbola { a, b, c, d }
    }

    /// −μ*(k): the branch |a k + b|/(c k + d) right of E, chapter III case 3.
    pub fn mu_star_rising(&self) -> Curve {
        let [a, b, c, d] = self.coefficients();
        Curve::Hyperbola { a: -a, b: -b, c, d }
    }

    /// μ**(k) = (a k − b)/(d − c k) (4.96, 4.97): a bound for k' < −1 only.
    pub fn mu_star_star(&self) -> Curve {
        let [a, b, c, d] = self.coefficients();
        Curve::Hyperbola { a, b: -b, c: -c, d }
    }

    /// k_A = μ_A = 1/(γ|1+k'|); infinite for k' = −1.
    pub fn k_a(&self) -> f64 {
        1.0 / (self.gamma * (1.0 + self.k_prime).abs())
    }

    /// k_D = 1/(γ|k'|); infinite for k' = 0.
    pub fn k_d(&self) -> f64 {
        1.0 / (self.gamma * self.k_prime.abs())
    }

    /// k_E = b/|a|, the zero of μ*, for k' > 0 and a < 0; infinite otherwise.
    pub fn k_e(&self) -> f64 {
        let [a, b, ..] = self.coefficients();
        if self.case() == ChartCase::TwoThree { -b / a } else { f64::INFINITY }
    }

    /// k_B' = (1+γ²)/(3γ|k'|) (4.48), for k' < 0; it lies right of A only if Δ > 0. Infinite for k' ≥ 0.
    pub fn k_b_prime(&self) -> f64 {
        let Chart { gamma: γ, k_prime } = *self;
        if k_prime < 0.0 { (1.0 + γ * γ) / (-3.0 * γ * k_prime) } else { f64::INFINITY }
    }

    /// μ_B' = (4+γ²)/(3γ) (4.49): Painlevé's bound on the friction, never below 4/3.
    pub fn mu_b_prime(&self) -> f64 {
        (4.0 + self.gamma * self.gamma) / (3.0 * self.gamma)
    }

    /// k_C', where μ* crosses DC; infinite unless −1 < k' < 0.
    pub fn k_c_prime(&self) -> f64 {
        let Chart { gamma: γ, k_prime } = *self;
        let q = -k_prime;
        if !(q > 0.0 && q < 1.0) {
            return f64::INFINITY;
        }
        // The positive root of 3γq(1−q) k² − T k − (1+7γ²)/γ = 0; T > 3, so nothing cancels.
        let t = 7.0 + γ * γ - q * (4.0 + γ * γ);
        let root = (t * t + 12.0 * q * (1.0 - q) * (1.0 + 7.0 * γ * γ)).sqrt();
        (t + root) / (6.0 * γ * q * (1.0 - q))
    }

    /// The named point, if this chart has it. A point beyond 1e100, as D for k' next to zero, counts as none.
    pub fn point(&self, name: PointName) -> Option<NamedPoint> {
        let case = self.case();
        let below = matches!(case, ChartCase::DeltaPositive | ChartCase::DeltaNotPositive);
        let (k, mu) = match name {
            PointName::A => (self.k_a(), self.k_a()),
            PointName::C if self.k_prime >= 0.0 => (0.0, 1.0 / self.gamma),
            PointName::D => (self.k_d(), 0.0),
            PointName::E if case == ChartCase::TwoThree => (self.k_e(), 0.0),
            PointName::BPrime if case == ChartCase::DeltaPositive => (self.k_b_prime(), self.mu_b_prime()),
            PointName::CPrime if below => (self.k_c_prime(), self.lower_line().at(self.k_c_prime())),
            PointName::F if below => {
                let [a, b, ..] = self.coefficients();
                (b / a, 0.0)
            }
            _ => return None,
        };
        (k < 1e100 && mu < 1e100).then_some(NamedPoint { name, k, mu })
    }

    /// All named points this chart has.
    pub fn points(&self) -> Vec<NamedPoint> {
        use PointName::{A, BPrime, C, CPrime, D, E, F};
        [A, BPrime, C, CPrime, D, E, F].into_iter().filter_map(|name| self.point(name)).collect()
    }
}
