//! The same calculation in an arithmetic that tracks its error and in rational arithmetic, for the tests of such arithmetics.

use dashu_ratio::Relaxed as Rational;

use crate::exact::Real;

/// A number of both.
#[derive(Clone)]
pub(crate) struct Both<T> {
    pub(crate) tracked: T,
    pub(crate) exact: Rational,
}

impl<T: Real> Both<T> {
    pub(crate) fn of(x: f64) -> Both<T> {
        Both { tracked: T::of(x), exact: rational(x) }
    }

    pub(crate) fn add(&self, other: &Both<T>) -> Both<T> {
        Both { tracked: self.tracked.clone() + other.tracked.clone(), exact: &self.exact + &other.exact }
    }

    pub(crate) fn sub(&self, other: &Both<T>) -> Both<T> {
        Both { tracked: self.tracked.clone() - other.tracked.clone(), exact: &self.exact - &other.exact }
    }

    pub(crate) fn mul(&self, other: &Both<T>) -> Both<T> {
        Both { tracked: self.tracked.clone() * other.tracked.clone(), exact: &self.exact * &other.exact }
    }
}

pub(crate) fn rational(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// How far two numbers are apart.
pub(crate) fn distance(one: &Rational, other: &Rational) -> Rational {
    let apart = one - other;
    if apart < rational(0.0) { -apart } else { apart }
}

/// Numbers whose sums and products round by as much as half a unit in the last place, cancel, or underflow.
pub(crate) fn operands<T: Real>() -> Vec<Both<T>> {
    let ε = f64::EPSILON;
    let sizes = [1.0, 1.0 + ε, 1.0 - ε / 2.0, 1.5 + ε, 2.0 - ε, 0.1, 1.0 / 3.0, ε / 2.0, 0.75 * ε];
    let far = [1e-3, 12345.678, 1e17, 1e150, 1e-150, 3e-200, f64::MIN_POSITIVE, 5e-324];
    sizes.into_iter().chain(far).flat_map(|x| [x, -x]).map(Both::of).collect()
}
