//! Random inputs: a law for each, how they are correlated, and laws that depend on what other inputs are.
//!
//! Correlation moves the standard normals behind the values ([`copula`](crate::copula)). A law that is *given* says more: of the period of waves
//! in a storm of this height, of a height whose law was fitted and has uncertain parameters. Its input has a normal of its own as any other, and
//! the value is that of the law at the values of those it depends on.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use crate::copula::Copula;
use crate::law::Distribution;

/// The law of an input, given the values of others.
#[derive(Clone)]
pub struct GivenLaw {
    on: Vec<usize>,
    law: Arc<LawOfValues>,
}

type LawOfValues = dyn Fn(&[f64]) -> Distribution + Send + Sync;

impl GivenLaw {
    /// The law that depends on the inputs with these numbers: a function of the values of all inputs, which reads those of these alone. It has
    /// no values with probabilities of their own, and no corners.
    pub fn new(on: Vec<usize>, law: impl Fn(&[f64]) -> Distribution + Send + Sync + 'static) -> GivenLaw {
        GivenLaw { on, law: Arc::new(law) }
    }

    /// The inputs that it depends on.
    pub fn on(&self) -> &[usize] {
        &self.on
    }
}

impl fmt::Debug for GivenLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "GivenLaw on {:?}", self.on)
    }
}

/// Random inputs: a law for each, and how they are correlated.
#[derive(Debug, Clone)]
pub struct RandomVector {
    laws: Vec<Distribution>,
    copula: Copula,
    given: Vec<Option<GivenLaw>>,
    /// All inputs, each after those its law depends on.
    sequence: Vec<usize>,
}

impl RandomVector {
    /// Inputs of these laws, correlated by a copula of as many.
    ///
    /// # Panics
    /// If the copula is of another number of inputs.
    pub fn new(laws: Vec<Distribution>, copula: Copula) -> RandomVector {
        assert_eq!(laws.len(), copula.len(), "a copula of as many inputs as there are laws");
        let (given, sequence) = (vec![None; laws.len()], (0..laws.len()).collect());
        RandomVector { laws, copula, given, sequence }
    }

    /// Independent inputs of these laws.
    pub fn independent(laws: Vec<Distribution>) -> RandomVector {
        let copula = Copula::independent(laws.len());
        RandomVector::new(laws, copula)
    }

    /// The same with laws that depend on other inputs, each with the number of its input.
    ///
    /// ```
    /// use standfast_probability::law::Law;
    /// use standfast_probability::problem::{GivenLaw, RandomVector};
    ///
    /// // Of waves of height h a period of about 4 √h.
    /// let (height, any) = (Law::uniform(1.0, 9.0)?.into(), Law::normal(0.0, 1.0)?.into());
    /// let period = GivenLaw::new(vec![0], |values| Law::lognormal(4.0 * values[0].sqrt(), 0.5).unwrap().into());
    /// let inputs = RandomVector::independent(vec![height, any]).with_given(vec![(1, period)]);
    /// assert_eq!(inputs.values_of(&[0.0, 0.0])[0], 5.0);
    /// assert_eq!(inputs.values_of(&[0.0, 0.0])[1], inputs.laws()[1].median());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Panics
    /// If one depends on itself, directly or not.
    pub fn with_given(mut self, given: Vec<(usize, GivenLaw)>) -> RandomVector {
        for (input, law) in given {
            self.given[input] = Some(law);
        }
        self.sequence.clear();
        while self.sequence.len() < self.laws.len() {
            let known = |input: &usize| self.sequence.contains(input);
            let is_next = |input: &usize| !known(input) && self.parents(*input).iter().all(known);
            let next = (0..self.laws.len()).find(is_next);
            self.sequence.push(next.expect("no law depends on itself"));
        }
        self.with_laws_at_medians()
    }

    /// The same with another law of one input.
    #[must_use]
    pub fn with_law(mut self, input: usize, law: Distribution) -> RandomVector {
        self.laws[input] = law;
        self.with_laws_at_medians()
    }

    fn with_laws_at_medians(mut self) -> RandomVector {
        let mut values = vec![0.0; self.laws.len()];
        for &input in &self.sequence {
            if let Some(given) = &self.given[input] {
                self.laws[input] = (given.law)(&values);
            }
            values[input] = self.laws[input].median();
        }
        self
    }

    /// The laws, in order; one that depends on other inputs is that at their medians.
    pub fn laws(&self) -> &[Distribution] {
        &self.laws
    }

    /// Correlation of the inputs.
    pub fn copula(&self) -> &Copula {
        &self.copula
    }

    /// The inputs that the law of one depends on.
    pub fn parents(&self, input: usize) -> &[usize] {
        self.given[input].as_ref().map_or(&[], GivenLaw::on)
    }

    /// True if the law of another input depends on this one: it can't be the line, along which the others have their values.
    pub fn is_parent(&self, input: usize) -> bool {
        self.given.iter().flatten().any(|given| given.on.contains(&input))
    }

    /// True if a law depends on the value of another input.
    pub fn has_given(&self) -> bool {
        self.given.iter().any(Option::is_some)
    }

    /// Place of an input among all, each after those its law depends on.
    pub(crate) fn rank(&self, input: usize) -> usize {
        self.sequence.iter().position(|other| *other == input).expect("all inputs are there")
    }

    /// The law of an input at these values of those it depends on.
    pub fn law_at(&self, input: usize, values: &[f64]) -> Cow<'_, Distribution> {
        match &self.given[input] {
            None => Cow::Borrowed(&self.laws[input]),
            Some(given) => Cow::Owned((given.law)(values)),
        }
    }

    /// The value of an input by its normal, at these values of those its law depends on.
    pub fn value(&self, input: usize, z: f64, values: &[f64]) -> f64 {
        match &self.given[input] {
            None => self.laws[input].value(z),
            Some(given) => (given.law)(values).value(z),
        }
    }

    /// The values of all inputs, by their normals, which are correlated.
    pub fn values_of(&self, z: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; z.len()];
        self.put_values(z, &mut values);
        values
    }

    /// Puts the values of all inputs in their places, by their normals.
    pub(crate) fn put_values(&self, z: &[f64], values: &mut [f64]) {
        for &input in &self.sequence {
            values[input] = self.value(input, z[input], values);
        }
    }
}
