//! Signs at the roots of a polynomial, and the roots themselves.
//!
//! The sign of a quadratic at a cubic's root decides if friction holds a rotation that solves the cubic. The root is
//! no f64; the sign is decided without it. In tracked floating point the root is caged: the cubic changes its sign, for
//! certain, between two numbers 2⁻⁴⁰ apart, and the quadratic keeps its own between them. Where that cannot tell, Tarski's
//! query does, in whole numbers: with the signed remainders of f and f'h (each the last but one, reduced by the last, with
//! its sign turned) the sign changes at 0 less those at ∞ count
//!
//! ```text
//! TaQ(h) = #{f = 0, h > 0} − #{f = 0, h < 0}      on (0, ∞), for f(0) ≠ 0
//! ```
//!
//! (Basu, Pollack, Roy, *Algorithms in Real Algebraic Geometry*, 2.2.) TaQ(1), TaQ(h) and TaQ(h²) give all three counts.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use crate::approx::{Approx, Signed};
use crate::exact::{Exact, Real};
use crate::polynomial::{product, value};
use crate::twofold::Twofold;

/// Numbers of roots of a polynomial above zero at which another polynomial is positive, zero and negative.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct RootSigns {
    pub(super) positive: usize,
    pub(super) zero: usize,
    pub(super) negative: usize,
}

impl RootSigns {
    pub(super) const NO_ROOT: RootSigns = RootSigns { positive: 0, zero: 0, negative: 0 };

    fn one(sign: Ordering) -> RootSigns {
        match sign {
            Greater => RootSigns { positive: 1, ..RootSigns::NO_ROOT },
            Equal => RootSigns { zero: 1, ..RootSigns::NO_ROOT },
            Less => RootSigns { negative: 1, ..RootSigns::NO_ROOT },
        }
    }
}

/// An arithmetic that can tell the signs of a polynomial at the roots of another, or say that it cannot.
pub(super) trait RootSigned: Signed {
    /// The signs of `h` at the roots above zero of `f`, which does not vanish at zero. Coefficients begin with the constant.
    /// `near` is where the only root is, if it is known that there is one only.
    fn at_roots(f: &[Self], h: &[Self], near: Option<f64>) -> Option<RootSigns>;
}

impl RootSigned for Approx {
    fn at_roots(f: &[Approx], h: &[Approx], near: Option<f64>) -> Option<RootSigns> {
        caged(f, h, near).map(RootSigns::one).or_else(|| counted(f, h))
    }
}

/// The sign of `h` at the root of `f` that is near, if it can be caged and the sign is certain.
fn caged(f: &[Approx], h: &[Approx], near: Option<f64>) -> Option<Ordering> {
    let root = near.filter(|root| *root > 0.0 && root.is_finite())?;
    let reach = root * CAGE;
    let sign = |x: f64| value(f, &Approx::of(x)).sign();
    let holds = sign(root - reach)? == Less && sign(root + reach)? == Greater;
    if holds { value(h, &Approx::around(root, 2.0 * reach)).sign() } else { None }
}

/// Half the width of the cage around a root, relatively.
const CAGE: f64 = 1.0 / (1u64 << 41) as f64;

impl RootSigned for Twofold {
    fn at_roots(f: &[Twofold], h: &[Twofold], _: Option<f64>) -> Option<RootSigns> {
        counted(f, h)
    }
}

impl RootSigned for Exact {
    fn at_roots(f: &[Exact], h: &[Exact], _: Option<f64>) -> Option<RootSigns> {
        counted(f, h)
    }
}

/// All roots of `f` above zero, by Tarski's query; `None` if a sign on the way is unknown.
fn counted<T: Signed>(f: &[T], h: &[T]) -> Option<RootSigns> {
    let f = trimmed(f.to_vec())?;
    if f.len() < 2 {
        return Some(RootSigns::NO_ROOT);
    }
    let all = tarski(&f, &[T::of(1.0)])?;
    if all == 0 {
        return Some(RootSigns::NO_ROOT);
    }
    let difference = tarski(&f, h)?;
    // Of one root the sign is the query's.
    let sum = if all == 1 { difference.abs() } else { tarski(&f, &product(h, h))? };
    let count = |n: isize| usize::try_from(n).expect("a number of roots");
    Some(RootSigns {
        positive: count((sum + difference) / 2),
        zero: count(all - sum),
        negative: count((sum - difference) / 2),
    })
}

/// The coefficients of f((τ − p)/w) wⁿ with n the degree of `f`, as a polynomial in τ: f from where p + w x = 0 on.
pub(super) fn shifted<T: Real>(f: &[T], p: &T, w: &T) -> Vec<T> {
    let factor = [-p.clone(), T::of(1.0)];
    let mut power = T::of(1.0);
    let mut sum: Vec<T> = Vec::new();
    for coefficient in f.iter().rev() {
        sum = if sum.is_empty() { Vec::new() } else { product(&sum, &factor) };
        let scaled = coefficient.clone() * power.clone();
        match sum.first_mut() {
            Some(constant) => *constant = constant.clone() + scaled,
            None => sum.push(scaled),
        }
        power = power * w.clone();
    }
    sum
}

/// Without leading coefficients that are zero; nothing is left of zero.
fn trimmed<T: Signed>(mut f: Vec<T>) -> Option<Vec<T>> {
    while let Some(leading) = f.last() {
        if leading.sign()? != Equal {
            break;
        }
        f.pop();
    }
    Some(f)
}

/// The remainder of f by g times a positive number, so that nothing is divided.
fn remainder<T: Signed>(mut f: Vec<T>, g: &[T]) -> Option<Vec<T>> {
    let leading = g[g.len() - 1].clone();
    let scale = if leading.sign()? == Less { -leading.clone() } else { leading.clone() };
    while f.len() >= g.len() {
        // f·|leading| − sign(leading)·(leading of f)·xⁿ g, in which the leading terms cancel.
        let by = f.pop().expect("f is not shorter than g");
        let by = if leading.sign()? == Less { -by } else { by };
        let shift = f.len() + 1 - g.len();
        f.iter_mut().for_each(|coefficient| *coefficient = coefficient.clone() * scale.clone());
        for (i, coefficient) in g[..g.len() - 1].iter().enumerate() {
            f[shift + i] = f[shift + i].clone() - by.clone() * coefficient.clone();
        }
        f = trimmed(f)?;
    }
    Some(f)
}

/// TaQ(h) for f on (0, ∞); `None` if a sign is unknown.
fn tarski<T: Signed>(f: &[T], h: &[T]) -> Option<isize> {
    let slope: Vec<T> = f.iter().enumerate().skip(1).map(|(i, c)| c.clone() * T::of(i as f64)).collect();
    let (mut one, mut two) = (f.to_vec(), remainder(trimmed(product(&slope, h))?, f)?);
    let (mut at_zero, mut at_infinity) = (vec![one[0].sign()?], vec![one[one.len() - 1].sign()?]);
    while !two.is_empty() {
        at_zero.push(two[0].sign()?);
        at_infinity.push(two[two.len() - 1].sign()?);
        let next = remainder(one, &two)?.into_iter().map(|coefficient| -coefficient).collect();
        (one, two) = (two, next);
    }
    Some(changes(&at_zero) - changes(&at_infinity))
}

/// Number of changes of sign along a row, zeros left out.
fn changes(signs: &[Ordering]) -> isize {
    let signs: Vec<&Ordering> = signs.iter().filter(|sign| **sign != Equal).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count() as isize
}

/// The real roots of a polynomial between `low` and `high`, ascending, each to round-off: between the roots of its derivative
/// it is monotone. A root where it does not change its sign may be missing.
pub(super) fn real_roots(f: &[f64], low: f64, high: f64) -> Vec<f64> {
    if f.len() < 2 {
        return Vec::new();
    }
    let slope: Vec<f64> = f.iter().enumerate().skip(1).map(|(i, c)| c * i as f64).collect();
    let mut ends = vec![low];
    ends.extend(real_roots(&slope, low, high));
    ends.push(high);
    let at = |x: f64| value(f, &x);
    ends.windows(2).filter_map(|pair| between(at, pair[0], pair[1])).collect()
}

/// Zero of a function that is monotone from `low` to `high`, between neighbouring numbers; `None` if its sign is the same at both.
/// A zero at `low` does not count.
///
/// The function is tried where its secant vanishes, a little towards the middle so that the far end comes near as well (Oliveira and
/// Takahashi's ITP, 2020); after [`TRIED`] tries that have not halved the bracket, in the middle. The zero is between both ends throughout.
pub(super) fn between(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> Option<f64> {
    let (mut at_low, mut at_high) = (f(low), f(high));
    if at_high == 0.0 {
        return Some(high);
    }
    if at_low == 0.0 || at_low.is_sign_negative() == at_high.is_sign_negative() {
        return None;
    }
    let whole = high - low;
    let (mut tried, mut halved) = (0, whole);
    loop {
        let width = high - low;
        let middle = low + width / 2.0;
        if middle <= low || middle >= high {
            return Some(middle);
        }
        if width <= halved {
            (tried, halved) = (0, width / 2.0);
        }
        tried += 1;
        let secant = low + width * (at_low / (at_low - at_high));
        let nudge = 0.2 * width * (width / whole);
        let guess = if secant < middle { (secant + nudge).min(middle) } else { (secant - nudge).max(middle) };
        // Of values without a secant too.
        let guess = if tried > TRIED || guess.is_nan() { middle } else { guess };
        let at = guess.clamp(low.next_up(), high.next_down());
        match f(at) {
            value if value * at_high.signum() > 0.0 => (high, at_high) = (at, value),
            value if value * at_high.signum() < 0.0 => (low, at_low) = (at, value),
            _ => return Some(at),
        }
    }
}

/// Tries by secants until the bracket is to be half of what it was.
const TRIED: u32 = 2;

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(f: &[f64]) -> Vec<Exact> {
        f.iter().map(|x| Exact::of(*x)).collect()
    }

    fn counts(f: &[f64], h: &[f64]) -> (usize, usize, usize) {
        let RootSigns { positive, zero, negative } = Exact::at_roots(&exact(f), &exact(h), None).unwrap();
        (positive, zero, negative)
    }

    /// Polynomials with known roots: (x − 1)(x − 2)(x + 3), x² − 2, a double root, none.
    #[test]
    fn signs_at_known_roots() {
        let f = [6.0, -7.0, 0.0, 1.0];
        assert_eq!(counts(&f, &[-1.5, 1.0]), (1, 0, 1));
        assert_eq!(counts(&f, &[-1.0, 1.0]), (1, 1, 0));
        assert_eq!(counts(&f, &[2.0, -3.0, 1.0]), (0, 2, 0));
        assert_eq!(counts(&f, &[0.0, -1.0, -1.0]), (0, 0, 2));
        // √2 against the two f64 beside it, and against itself.
        let root = 2f64.sqrt();
        assert!(root * root > 2.0);
        assert_eq!(counts(&[-2.0, 0.0, 1.0], &[-root, 1.0]), (0, 0, 1));
        assert_eq!(counts(&[-2.0, 0.0, 1.0], &[-root.next_down(), 1.0]), (1, 0, 0));
        assert_eq!(counts(&[-2.0, 0.0, 1.0], &[-2.0, 0.0, 1.0]), (0, 1, 0));
        // (x − 1)² (x − 4), a line, leading zeros, no root.
        assert_eq!(counts(&[-4.0, 9.0, -6.0, 1.0], &[-2.0, 1.0]), (1, 0, 1));
        assert_eq!(counts(&[-1.0, 2.0, 0.0, 0.0], &[-1.0, 2.0]), (0, 1, 0));
        assert_eq!(counts(&[1.0, 2.0, 3.0, 4.0], &[1.0]), (0, 0, 0));
        assert_eq!(counts(&[5.0], &[1.0]), (0, 0, 0));
    }

    /// A cage is refused where the root is not in it, and where the sign is not certain.
    #[test]
    fn a_cage_holds_its_root() {
        let approx = |f: &[f64]| f.iter().map(|x| Approx::of(*x)).collect::<Vec<_>>();
        let (f, h) = (approx(&[-2.0, 0.0, 1.0]), approx(&[-1.4, 1.0]));
        let root = 2f64.sqrt();
        let one = RootSigns { positive: 1, zero: 0, negative: 0 };
        assert_eq!(Approx::at_roots(&f, &h, Some(root)), Some(one));
        assert_eq!(caged(&f, &h, Some(root)), Some(Greater));
        assert_eq!(caged(&f, &h, Some(root * (1.0 + 1e-11))), None);
        assert_eq!(caged(&f, &approx(&[-root, 1.0]), Some(root)), None);
        // Without a cage the roots are counted; a sign that rounding hides is unknown.
        assert_eq!(Approx::at_roots(&f, &h, None), Some(one));
        assert_eq!(Approx::at_roots(&f, &approx(&[-root, 1.0]), Some(root)), None);
    }

    #[test]
    fn a_shifted_polynomial_has_its_values() {
        // 1 + 2x + 3x² at x = (τ − 5)/2, times 4.
        let f = shifted(&[1.0, 2.0, 3.0], &5.0, &2.0);
        for τ in [0.0, 1.0, 7.5] {
            let x = (τ - 5.0) / 2.0;
            assert_eq!(value(&f, &τ), 4.0 * (1.0 + 2.0 * x + 3.0 * x * x));
        }
    }

    #[test]
    fn real_roots_are_all_found() {
        let roots = real_roots(&[-6.0, 11.0, -6.0, 1.0], 0.5, 10.0);
        assert!(roots.iter().zip([1.0, 2.0, 3.0]).all(|(root, at)| (root - at).abs() < 1e-14), "{roots:?}");
        assert_eq!(roots.len(), 3);
        assert_eq!(real_roots(&[1.0, 0.0, 1.0], -5.0, 5.0), []);
    }
}
