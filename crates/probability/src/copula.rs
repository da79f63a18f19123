//! Correlation of inputs by a normal copula: each input is a function of a standard normal z, and the z are correlated.
//!
//! Correlation of two inputs may be given of their z, of their ranks (Spearman), or of their values (Nataf, as
//! described by Liu and Der Kiureghian, Probabilistic Engineering Mechanics 1, 1986):
//!
//! ```text
//! ρ_z = 2 sin(πρ_rank/6)           ρ_value(ρ_z) = (E[x₁(z₁) x₂(z₂)] − m₁ m₂)/(s₁ s₂)
//! ```
//!
//! The second rises with ρ_z and is solved for it; not every correlation of values can be had.

use std::f64::consts::PI;

use crate::law::Distribution;
use crate::legendre;
use crate::normal;

/// Correlation of two inputs, by one of its measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CorrelationMeasure {
    /// Of the standard normals behind the values.
    Normal(f64),
    /// Spearman's, of the ranks.
    Rank(f64),
    /// Pearson's, of the values.
    Linear(f64),
}

impl CorrelationMeasure {
    /// The number given.
    pub fn value(self) -> f64 {
        match self {
            CorrelationMeasure::Normal(value)
            | CorrelationMeasure::Rank(value)
            | CorrelationMeasure::Linear(value) => value,
        }
    }

    /// Words for the quantities that are correlated.
    pub fn name(self) -> &'static str {
        match self {
            CorrelationMeasure::Normal(_) => "of the normals behind the values",
            CorrelationMeasure::Rank(_) => "of ranks, Spearman's",
            CorrelationMeasure::Linear(_) => "of values, Pearson's",
        }
    }
}

/// Two inputs, by their places, and how they are correlated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correlation {
    /// One input.
    pub first: usize,
    /// The other.
    pub second: usize,
    /// Correlation and its measure.
    pub measure: CorrelationMeasure,
}

/// Fault of a set of correlations.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CopulaError {
    /// A pair that is one input twice, or has an input that is not there.
    #[error("a correlation between inputs {first} and {second}: expected two different ones of {inputs}")]
    Pair {
        /// One place.
        first: usize,
        /// The other.
        second: usize,
        /// Number of inputs.
        inputs: usize,
    },
    /// A pair that is named twice.
    #[error("the correlation between inputs {first} and {second} is given twice")]
    Twice {
        /// One place.
        first: usize,
        /// The other.
        second: usize,
    },
    /// A correlation that these two laws, or the others' correlations, do not admit.
    #[error(
        "the correlation {value} between inputs {first} and {second}: expected a value above {from} and below {to}"
    )]
    Unattainable {
        /// One place.
        first: usize,
        /// The other.
        second: usize,
        /// The value given.
        value: f64,
        /// The least that can be approached.
        from: f64,
        /// The largest that can be approached.
        to: f64,
        /// True if the other correlations do not admit it, false if the two laws do not.
        beside_others: bool,
    },
    /// Correlations that contradict each other, and not by one of them alone.
    #[error(
        "the correlations contradict each other: no change of a single one of them makes the matrix positive definite"
    )]
    Contradictory,
}

/// The correlation matrix of the standard normals behind the inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Copula {
    matrix: Vec<Vec<f64>>,
}

impl Copula {
    /// Inputs that do not depend on each other.
    pub fn independent(inputs: usize) -> Copula {
        let row = |i: usize| (0..inputs).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        Copula { matrix: (0..inputs).map(row).collect() }
    }

    /// Inputs of these laws with these correlations; what is not named is independent.
    ///
    /// # Errors
    /// If a pair is not one of two inputs or is named twice, if two laws do not attain a correlation, or if the matrix is not
    /// positive definite: then of the last pair that alone could mend it.
    pub fn new(inputs: &[Distribution], correlations: &[Correlation]) -> Result<Copula, CopulaError> {
        let n = inputs.len();
        let mut copula = Copula::independent(n);
        let mut given: Vec<(usize, usize)> = Vec::new();
        for &Correlation { first, second, measure } in correlations {
            if first == second || first >= n || second >= n {
                return Err(CopulaError::Pair { first, second, inputs: n });
            }
            if given.contains(&(first, second)) || given.contains(&(second, first)) {
                return Err(CopulaError::Twice { first, second });
            }
            given.push((first, second));
            let pair = Pair::new(&inputs[first], &inputs[second], measure);
            let Some(rho) = pair.of_normals() else {
                return Err(pair.unattainable(first, second, pair.attainable(), false));
            };
            copula.set(first, second, rho);
        }
        if copula.factor(&natural(n)).is_some() {
            return Ok(copula);
        }
        // The last of the pairs that alone could mend it.
        for &Correlation { first, second, measure } in correlations.iter().rev() {
            if let Some((from, to)) = copula.admitted(first, second) {
                let pair = Pair::new(&inputs[first], &inputs[second], measure);
                return Err(pair.unattainable(first, second, (pair.measured(from), pair.measured(to)), true));
            }
        }
        Err(CopulaError::Contradictory)
    }

    fn set(&mut self, i: usize, j: usize, rho: f64) {
        self.matrix[i][j] = rho;
        self.matrix[j][i] = rho;
    }

    /// The correlation of the standard normals behind two inputs.
    pub fn between(&self, first: usize, second: usize) -> f64 {
        self.matrix[first][second]
    }

    /// Number of inputs.
    #[allow(clippy::len_without_is_empty, reason = "a problem without inputs has no copula to ask")]
    pub fn len(&self) -> usize {
        self.matrix.len()
    }

    /// The standard normals of all inputs, in their order, from as many independent ones: z = L u.
    pub fn correlated(&self, u: &[f64]) -> Vec<f64> {
        self.natural_factor().iter().map(|row| row.iter().zip(u).map(|(a, b)| a * b).sum()).collect()
    }

    /// The independent normals behind correlated ones, in the same order: u = L⁻¹ z.
    pub fn independent_of(&self, z: &[f64]) -> Vec<f64> {
        let factor = self.natural_factor();
        let mut u = Vec::with_capacity(z.len());
        for (row, z) in factor.iter().zip(z) {
            let known: f64 = row.iter().zip(&u).map(|(a, b)| a * b).sum();
            u.push((z - known) / row[u.len()]);
        }
        u
    }

    /// True if no input depends on another.
    pub fn is_independent(&self) -> bool {
        self.matrix
            .iter()
            .enumerate()
            .all(|(i, row)| row.iter().enumerate().all(|(j, &rho)| i == j || rho == 0.0))
    }

    /// Cholesky's factor with the inputs in the order given.
    pub(crate) fn natural_factor(&self) -> Vec<Vec<f64>> {
        self.factor(&natural(self.len())).expect("a copula is positive definite")
    }

    /// Cholesky's factor of the matrix with the inputs in this order: z of `order[i]` is the sum over j ≤ i of `factor[i][j]`
    /// times the independent u with number j. None if the matrix is not positive definite.
    pub(crate) fn factor(&self, order: &[usize]) -> Option<Vec<Vec<f64>>> {
        let mut factor: Vec<Vec<f64>> = Vec::with_capacity(order.len());
        for (i, &at) in order.iter().enumerate() {
            let mut row = vec![0.0; i + 1];
            for (j, &other) in order.iter().enumerate().take(i) {
                let known: f64 = row[..j].iter().zip(&factor[j]).map(|(a, b)| a * b).sum();
                row[j] = (self.matrix[at][other] - known) / factor[j][j];
            }
            let rest = 1.0 - row[..i].iter().map(|a| a * a).sum::<f64>();
            // A matrix this near to singular has lost its digits.
            if rest <= 1e-12 {
                return None;
            }
            row[i] = rest.sqrt();
            factor.push(row);
        }
        Some(factor)
    }

    /// The correlations of one pair for which the matrix is positive definite, all others as they are: an interval, or none.
    fn admitted(&self, i: usize, j: usize) -> Option<(f64, f64)> {
        const STEPS: i32 = 2000;
        let holds = |rho: f64| {
            let mut with = self.clone();
            with.set(i, j, rho);
            with.factor(&natural(self.matrix.len())).is_some()
        };
        let inside =
            (1 - STEPS..STEPS).map(|step| f64::from(step) / f64::from(STEPS)).find(|rho| holds(*rho))?;
        let end = |sign: f64| {
            let (mut inside, mut outside) = (inside, sign);
            for _ in 0..50 {
                let middle = 0.5 * (inside + outside);
                if holds(middle) { inside = middle } else { outside = middle }
            }
            inside
        };
        Some((end(-1.0), end(1.0)))
    }
}

/// Inputs in the order given.
pub(crate) fn natural(n: usize) -> Vec<usize> {
    (0..n).collect()
}

/// A measure of correlation between two laws.
struct Pair<'a> {
    laws: [&'a Distribution; 2],
    measure: CorrelationMeasure,
    /// Mean and standard deviation of each, where the values' correlation asks for them.
    moments: [(f64, f64); 2],
    /// The normals at which the value of each jumps or has a kink.
    breaks: [Vec<f64>; 2],
}

impl<'a> Pair<'a> {
    fn new(first: &'a Distribution, second: &'a Distribution, measure: CorrelationMeasure) -> Pair<'a> {
        let moments = match measure {
            CorrelationMeasure::Linear(_) => [moments(first), moments(second)],
            _ => [(0.0, 1.0); 2],
        };
        let laws = [first, second];
        Pair { laws, measure, moments, breaks: laws.map(Distribution::breaks_of_normal) }
    }

    /// The correlation of the normals that has the one given, if there is one.
    fn of_normals(&self) -> Option<f64> {
        match self.measure {
            CorrelationMeasure::Normal(rho) => Some(rho).filter(|rho| rho.abs() < 1.0),
            CorrelationMeasure::Rank(rank) => {
                Some(2.0 * (PI * rank / 6.0).sin()).filter(|_| rank.abs() < 1.0)
            }
            CorrelationMeasure::Linear(0.0) => Some(0.0),
            CorrelationMeasure::Linear(linear) => {
                let (mut low, mut high) = (-1.0 + 1e-9, 1.0 - 1e-9);
                if !(self.measured(low) < linear && linear < self.measured(high)) {
                    return None;
                }
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if self.measured(middle) < linear { low = middle } else { high = middle }
                }
                Some(0.5 * (low + high))
            }
        }
    }

    /// That the measure given does not lie between these.
    fn unattainable(
        &self,
        first: usize,
        second: usize,
        (from, to): (f64, f64),
        beside_others: bool,
    ) -> CopulaError {
        CopulaError::Unattainable { first, second, value: self.measure.value(), from, to, beside_others }
    }

    fn attainable(&self) -> (f64, f64) {
        (self.measured(-1.0), self.measured(1.0))
    }

    /// Measured correlation of two inputs whose normals have the correlation `rho`.
    fn measured(&self, rho: f64) -> f64 {
        match self.measure {
            CorrelationMeasure::Normal(_) => rho,
            CorrelationMeasure::Rank(_) => 6.0 / PI * (rho / 2.0).asin(),
            CorrelationMeasure::Linear(_) => {
                let [(m1, s1), (m2, s2)] = self.moments;
                let across = (1.0 - rho * rho).max(0.0).sqrt();
                let [first, second] = self.laws;
                let [outer, inner] = &self.breaks;
                let product = if across == 0.0 {
                    // One normal moves both.
                    let breaks = outer.iter().copied().chain(inner.iter().map(|z| rho * z)).collect();
                    expected(breaks, |z| (first.value(z) - m1) * (second.value(rho * z) - m2))
                } else {
                    expected(outer.clone(), |z| {
                        let breaks = inner.iter().map(|b| (b - rho * z) / across).collect();
                        (first.value(z) - m1) * expected(breaks, |w| second.value(rho * z + across * w) - m2)
                    })
                };
                product / (s1 * s2)
            }
        }
    }
}

/// Mean and standard deviation of the values of a distribution.
fn moments(law: &Distribution) -> (f64, f64) {
    let breaks = law.breaks_of_normal();
    let mean = expected(breaks.clone(), |z| law.value(z));
    (mean, expected(breaks, |z| (law.value(z) - mean).powi(2)).sqrt())
}

/// The mean of a function of a standard normal that is smooth between these of its values.
fn expected(breaks: Vec<f64>, f: impl Fn(f64) -> f64) -> f64 {
    const REACH: f64 = 9.0;
    const WIDEST: f64 = 3.0;
    let mut ends = breaks;
    ends.retain(|z| z.abs() < REACH);
    ends.extend([-REACH, REACH]);
    ends.sort_by(f64::total_cmp);
    let mut sum = 0.0;
    for pair in ends.windows(2) {
        let panels = ((pair[1] - pair[0]) / WIDEST).ceil();
        let width = (pair[1] - pair[0]) / panels;
        for i in 0..panels as u32 {
            let a = pair[0] + f64::from(i) * width;
            let nodes = legendre::panel(a, a + width);
            sum += nodes.into_iter().map(|(z, weight)| weight * normal::density(z) * f(z)).sum::<f64>();
        }
    }
    sum
}
