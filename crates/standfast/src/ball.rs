//! Numbers as they are written: decimals without rounding, and what is not rational within a bound.
//!
//! A case says "0.1", which no f64 is. People put round numbers exactly on a boundary, and mode, safety factor and departure must
//! not contradict each other there. So what an f64 stands for is taken to be the shortest decimal that reads as it, or the decimal
//! that was written, and is kept as a fraction of whole numbers. What comes from an angle, π or a wave's formulas enters with the
//! f64 that was computed and a radius around it, which every operation carries on:
//!
//! ```text
//! (a ± r) + (b ± s) = (a + b) ± (r + s)
//! (a ± r) (b ± s)   = ab ± (|a|s + |b|r + rs)
//! (a ± r) / (b ± s) = a/b ± (|a|s + |b|r) / (|b| (|b| − s))
//! ```
//!
//! Without a radius a sign is always known. It costs microseconds an operation: callers come here only where f64 cannot tell.

use std::cmp::Ordering;
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};
use num_integer::Integer;

use crate::approx::{Approx, Signed};
use crate::exact::{Exact, Real, scale};

/// The arithmetic in which bodies, loads and their wrenches can be had: f64, and [`Ball`] where a sign must not hang on rounding.
pub trait Scalar: Real + Div<Output = Self> + Debug + PartialEq {
    /// The nearest f64.
    fn value(&self) -> f64;

    /// The number that a person means by an f64: the shortest decimal that reads as it.
    fn written(x: f64) -> Self;

    /// A number that was written with more digits than an f64 has.
    fn of_decimal(decimal: &Ball) -> Self;

    /// A number that was computed in f64, to [some thirteen digits](COMPUTED).
    fn computed(x: f64) -> Self;

    /// The number itself as a fraction of whole numbers.
    fn ball(&self) -> Ball;

    /// Sum of two terms; in f64 zero where they cancel but for their rounding, 2⁻⁴⁹ of the first.
    fn plus(self, other: Self) -> Self;
}

/// Error of a term of a sum in f64, as a share of it.
pub(crate) const ROUNDED: f64 = 1.0 / (1u64 << 49) as f64;

/// Error of a number that was computed in f64, as a share of it: a hundred roundings and more, below the digits that any wave, angle or
/// strength is known to.
pub const COMPUTED: f64 = 1.0 / (1u64 << 44) as f64;

impl Scalar for f64 {
    #[inline(always)]
    fn value(&self) -> f64 {
        *self
    }

    #[inline(always)]
    fn written(x: f64) -> f64 {
        x
    }

    fn of_decimal(decimal: &Ball) -> f64 {
        decimal.value()
    }

    #[inline(always)]
    fn computed(x: f64) -> f64 {
        x
    }

    fn ball(&self) -> Ball {
        Ball::of(*self)
    }

    #[inline(always)]
    fn plus(self, other: f64) -> f64 {
        let sum = self + other;
        if sum.abs() <= ROUNDED * self.abs() { 0.0 } else { sum }
    }
}

/// A fraction of whole numbers, in lowest terms, and how far the number meant may be from it.
///
/// ```
/// use standfast::{Ball, Scalar};
///
/// let [tenth, fifth, third_tenth] = [0.1, 0.2, 0.3].map(Ball::written);
/// assert_eq!(tenth + fifth, third_tenth);
/// assert_ne!(0.1 + 0.2, 0.3);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ball {
    numerator: BigInt,
    /// Above zero.
    denominator: BigInt,
    radius: f64,
}

impl Ball {
    /// The decimal that a text is: digits with a point, or a power of ten, or both. `None` for every other text, and for powers
    /// of ten out of all range.
    ///
    /// ```
    /// use standfast::{Ball, Scalar};
    ///
    /// assert_eq!(Ball::decimal("-12.50e-1"), Some(Ball::written(-1.25)));
    /// assert_eq!(Ball::decimal("1_000"), None);
    /// ```
    pub fn decimal(text: &str) -> Option<Ball> {
        let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, rest) = digits.split_once('.').unwrap_or((digits, ""));
        let power: i32 = power.strip_prefix('+').unwrap_or(power).parse().ok()?;
        if rest.starts_with(['+', '-']) || power.abs() > 400 || text.len() > 400 {
            return None;
        }
        let mantissa: BigInt = format!("{whole}{rest}").parse().ok().filter(|_| !text.contains('_'))?;
        let power = power - rest.len() as i32;
        let ten = |power: i32| BigInt::from(10).pow(power.unsigned_abs());
        Some(match power {
            0.. => Ball::fraction(mantissa * ten(power), BigInt::from(1), 0.0),
            _ => Ball::fraction(mantissa, ten(power), 0.0),
        })
    }

    /// Product with a power of ten.
    pub fn times_ten_to(self, power: i32) -> Ball {
        let ten = BigInt::from(10).pow(power.unsigned_abs());
        match power {
            0.. => Ball::fraction(self.numerator * &ten, self.denominator, self.radius * value(&ten)),
            _ => Ball::fraction(self.numerator, self.denominator * &ten, self.radius / value(&ten)),
        }
    }

    /// True if it is known without a bound.
    pub fn is_exact(&self) -> bool {
        self.radius == 0.0
    }

    /// Its parts above and below the line, whole numbers, the latter above zero; the radius goes with the former.
    pub(crate) fn parts(&self) -> [Ball; 2] {
        let whole = |number: &BigInt, radius: f64| Ball {
            numerator: number.clone(),
            denominator: BigInt::from(1),
            radius,
        };
        let radius = if self.is_exact() { 0.0 } else { up(self.radius * value(&self.denominator)) };
        [whole(&self.numerator, radius), whole(&self.denominator, 0.0)]
    }

    /// True if it is zero for certain.
    fn is_nothing(&self) -> bool {
        self.numerator.sign() == Sign::NoSign && self.is_exact()
    }

    fn is_one(&self) -> bool {
        self.is_exact() && self.numerator == self.denominator
    }

    /// The sign; `None` where it is within the radius.
    pub fn sign(&self) -> Option<Ordering> {
        Signed::sign(self)
    }

    /// The nearest f64 with a bound on how far the number meant may be from it.
    pub(crate) fn tracked(&self) -> Approx {
        let value = self.value();
        let rounding =
            if self.is_exact() && Ball::of(value) == *self { 0.0 } else { f64::EPSILON * value.abs() };
        Approx::around(value, up(self.radius + rounding))
    }

    fn fraction(numerator: BigInt, denominator: BigInt, radius: f64) -> Ball {
        // Of what is known to some digits no more need be kept.
        if radius > 0.0 && numerator.bits() + denominator.bits() > 2 * KEPT {
            return Ball::shortened(&numerator, &denominator, radius);
        }
        // What comes from f64 has powers of two below the line, which take no search for a divisor.
        if let Some(power) = power_of_two(&denominator) {
            let common = numerator.trailing_zeros().map_or(power, |zeros| zeros.min(power));
            return Ball { numerator: numerator >> common, denominator: denominator >> common, radius };
        }
        let divisor = numerator.gcd(&denominator);
        Ball { numerator: numerator / &divisor, denominator: denominator / divisor, radius }
    }

    /// The fraction with so many bits as are [kept](KEPT); what is left off joins the radius.
    fn shortened(numerator: &BigInt, denominator: &BigInt, radius: f64) -> Ball {
        let shift = KEPT as i64 - (numerator.bits() as i64 - denominator.bits() as i64);
        let power = BigInt::from(1) << shift.unsigned_abs();
        let (numerator, denominator) = match shift {
            0.. => ((numerator << shift.unsigned_abs()) / denominator, power),
            _ => ((numerator / (denominator << shift.unsigned_abs())) * power, BigInt::from(1)),
        };
        let zeros = numerator.trailing_zeros().unwrap_or(0).min(denominator.trailing_zeros().unwrap_or(0));
        let whole = Ball { numerator: numerator >> zeros, denominator: denominator >> zeros, radius };
        let lost = whole.magnitude() * scale(1.0, -(KEPT as i64 - 2));
        Ball { radius: up(radius + lost), ..whole }
    }

    /// No less than the magnitude of its middle.
    fn magnitude(&self) -> f64 {
        up(self.value().abs())
    }
}

/// Bits that are kept of a number that is not known exactly: more than twice those of an f64.
const KEPT: u64 = 128;

/// The power of two that a number above zero is.
fn power_of_two(number: &BigInt) -> Option<u64> {
    let zeros = number.trailing_zeros()?;
    (zeros + 1 == number.bits()).then_some(zeros)
}

/// A sum or product of magnitudes, no less than it would be without rounding.
fn up(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x * (1.0 + 8.0 * f64::EPSILON) + f64::MIN_POSITIVE }
}

/// The f64 nearest to a whole number.
fn value(whole: &BigInt) -> f64 {
    quotient(whole, &BigInt::from(1))
}

/// The f64 nearest to a fraction.
fn quotient(numerator: &BigInt, denominator: &BigInt) -> f64 {
    // So many bits that the last is far below what f64 keeps; whether anything is left sticks to it.
    let shift = 70 - (numerator.bits() as i64 - denominator.bits() as i64);
    let magnitude = numerator.magnitude().clone();
    let denominator = denominator.magnitude();
    let (whole, rest) = match shift {
        0.. => (magnitude << shift).div_rem(denominator),
        _ => magnitude.div_rem(&(denominator << -shift)),
    };
    let sticky = u128::from(rest != num_bigint::BigUint::ZERO);
    let bits = u128::try_from(whole).expect("71 bits") | sticky;
    let size = scale(bits as f64, -shift);
    if numerator.sign() == Sign::Minus { -size } else { size }
}

impl Real for Ball {
    fn of(x: f64) -> Ball {
        let (mantissa, exponent) = Exact::of(x).parts();
        let power = BigInt::from(1) << exponent.unsigned_abs();
        match exponent {
            0.. => Ball::fraction(mantissa * power, BigInt::from(1), 0.0),
            _ => Ball::fraction(mantissa, power, 0.0),
        }
    }
}

impl Scalar for Ball {
    fn value(&self) -> f64 {
        quotient(&self.numerator, &self.denominator)
    }

    fn written(x: f64) -> Ball {
        // The shortest digits that read as it.
        Ball::decimal(&format!("{x:e}")).unwrap_or_else(|| Ball::of(x))
    }

    fn of_decimal(decimal: &Ball) -> Ball {
        decimal.clone()
    }

    fn computed(x: f64) -> Ball {
        Ball { radius: up(x.abs() * COMPUTED), ..Ball::of(x) }
    }

    fn ball(&self) -> Ball {
        self.clone()
    }

    fn plus(self, other: Ball) -> Ball {
        self + other
    }
}

impl Signed for Ball {
    fn sign(&self) -> Option<Ordering> {
        let known = self.radius == 0.0 || self.value().abs() * (1.0 - f64::EPSILON) > self.radius;
        known.then(|| match self.numerator.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        })
    }
}

impl Add for Ball {
    type Output = Ball;
    fn add(self, other: Ball) -> Ball {
        // Most terms of a matrix are nothing.
        if self.is_nothing() {
            return other;
        }
        if other.is_nothing() {
            return self;
        }
        let numerator = self.numerator * &other.denominator + other.numerator * &self.denominator;
        Ball::fraction(numerator, self.denominator * other.denominator, up(self.radius + other.radius))
    }
}

impl Neg for Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        Ball { numerator: -self.numerator, ..self }
    }
}

impl Sub for Ball {
    type Output = Ball;
    fn sub(self, other: Ball) -> Ball {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Ball;
    fn mul(self, other: Ball) -> Ball {
        if self.is_nothing() || other.is_one() {
            return self;
        }
        if other.is_nothing() || self.is_one() {
            return other;
        }
        let radius = match self.is_exact() && other.is_exact() {
            true => 0.0,
            false => up(self.magnitude() * other.radius
                + other.magnitude() * self.radius
                + self.radius * other.radius),
        };
        Ball::fraction(self.numerator * other.numerator, self.denominator * other.denominator, radius)
    }
}

impl Div for Ball {
    type Output = Ball;

    /// The quotient; by what may be zero, zero with an infinite radius: nothing is known of it.
    fn div(self, other: Ball) -> Ball {
        if other.sign().is_none_or(Ordering::is_eq) {
            return Ball { radius: f64::INFINITY, ..Ball::of(0.0) };
        }
        let radius = match self.is_exact() && other.is_exact() {
            true => 0.0,
            false => {
                let least = other.value().abs() * (1.0 - f64::EPSILON) - other.radius;
                let off = self.magnitude() * other.radius + other.magnitude() * self.radius;
                up(off / (other.value().abs() * least))
            }
        };
        if power_of_two(&self.denominator).is_some() && power_of_two(&other.denominator).is_some() {
            // Among whole numbers a quotient is mostly one: that takes no search either.
            let (whole, rest) = self.numerator.div_rem(&other.numerator);
            if rest.sign() == Sign::NoSign {
                return Ball::fraction(whole * &other.denominator, self.denominator, radius);
            }
        }
        let (numerator, denominator) =
            (self.numerator * &other.denominator, self.denominator * &other.numerator);
        match denominator.sign() {
            Sign::Minus => Ball::fraction(-numerator, -denominator, radius),
            _ => Ball::fraction(numerator, denominator, radius),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_f64_comes_back() {
        for x in [0.0, 1.0, -0.1, 1.0 / 3.0, 1e300, -1e-300, f64::MAX, f64::MIN_POSITIVE, 1e-320, 264.87e3] {
            assert_eq!(Ball::of(x).value(), x, "{x:e}");
            assert_eq!(Ball::written(x).value(), x, "{x:e}");
        }
        // Rust reads decimals to the nearest f64.
        for text in ["0.1", "123456789.123456789123456789", "-7e-13", "0.3333333333333333333333", "1e23"] {
            assert_eq!(Ball::decimal(text).unwrap().value(), text.parse::<f64>().unwrap(), "{text}");
        }
        // Halfway between two, and a little beside it.
        let half = "1.00000000000000011102230246251565404236316680908203125";
        assert_eq!(Ball::decimal(half).unwrap().value(), 1.0);
        assert_eq!(Ball::decimal(&format!("{half}0001")).unwrap().value(), 1.0 + f64::EPSILON);
    }

    #[test]
    fn decimals_are_what_they_say() {
        let tenth = |n: f64| Ball::of(n) / Ball::of(10.0);
        for (text, expected) in
            [("0.1", tenth(1.0)), ("-.5", tenth(-5.0)), ("+3e-1", tenth(3.0)), ("7.E+0", tenth(70.0))]
        {
            assert_eq!(Ball::decimal(text), Some(expected), "{text}");
        }
        for text in ["", ".", "e5", "1.-5", "0x10", "1e", "inf", "NaN", "1 2", "1e401"] {
            assert_eq!(Ball::decimal(text), None, "{text}");
        }
        assert_eq!(Ball::decimal("2.5").unwrap().times_ten_to(3), Ball::written(2500.0));
        assert_eq!(Ball::decimal("2.5").unwrap().times_ten_to(-3), Ball::written(0.0025));
    }

    /// The corners of two intervals: what an operation gives for each lies within the ball that it gives for both.
    #[test]
    fn a_ball_holds_what_it_may_be() {
        let ball = |x: f64, radius: f64| Ball { radius, ..Ball::of(x) };
        let ends = |ball: &Ball| {
            [-1.0, 1.0]
                .map(|side| ball.clone() + Ball::of(side * ball.radius))
                .map(|end| Ball { radius: 0.0, ..end })
        };
        let inside = |exact: Ball, ball: &Ball| {
            let off = exact - Ball { radius: 0.0, ..ball.clone() };
            let off = if off.sign() == Some(Ordering::Less) { -off } else { off };
            (Ball::of(ball.radius) - off).sign() != Some(Ordering::Less)
        };
        let balls = [ball(3.0, 0.25), ball(-7.0, 1e-9), ball(0.1, 0.0), ball(-1e-3, 9e-4), ball(1e9, 3.0)];
        for one in &balls {
            for two in &balls {
                let (sum, product, quotient) =
                    (one.clone() + two.clone(), one.clone() * two.clone(), one.clone() / two.clone());
                for a in ends(one) {
                    for b in ends(two) {
                        assert!(inside(a.clone() + b.clone(), &sum), "{one:?} + {two:?}");
                        assert!(inside(a.clone() * b.clone(), &product), "{one:?} {two:?}");
                        assert!(inside(a.clone() / b.clone(), &quotient), "{one:?} / {two:?}");
                    }
                }
            }
        }
    }

    /// What is known to some digits is kept to no more bits than tell them, and holds what it was.
    #[test]
    fn what_is_not_exact_is_kept_short() {
        let mut product = Ball::computed(1.0 / 3.0);
        let mut exact = Ball::of(1.0 / 3.0);
        for factor in [1e-30, -7.0, 0.1, 1e40, 1.0 / 7.0].iter().cycle().take(40) {
            (product, exact) = (product * Ball::written(*factor), exact * Ball::written(*factor));
            assert!(product.numerator.bits() + product.denominator.bits() <= 2 * KEPT + 200);
        }
        assert!(exact.numerator.bits() + exact.denominator.bits() > 3 * KEPT);
        assert_eq!(product.value(), exact.value());
        assert!(product.radius < 2.0 * COMPUTED * product.magnitude());
        assert_eq!((product - exact.clone()).sign(), None);
        assert!(exact.is_exact());
    }

    #[test]
    fn a_sign_within_the_radius_is_not_known() {
        let near = Ball::computed(1.0) - Ball::of(1.0);
        assert_eq!((near.sign(), near.is_exact()), (None, false));
        assert_eq!((Ball::computed(1.0) - Ball::of(1.0 + 1e-12)).sign(), Some(Ordering::Less));
        assert_eq!((Ball::written(0.1) * Ball::of(3.0) - Ball::written(0.3)).sign(), Some(Ordering::Equal));
        assert_eq!((Ball::of(1.0) / Ball::of(0.0)).sign(), None);
    }
}
