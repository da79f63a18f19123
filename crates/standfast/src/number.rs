//! Numbers rounded for people, once for every face: text, figures, sheet and page differ in signs and type only.

use std::fmt;

/// A number in some significant digits, without trailing zeros; see [`significant`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Significant {
    /// The digits with a plain minus sign: the whole number, or what stands before the power of ten. `inf`, `-inf` and
    /// `NaN` for what has no digits.
    pub mantissa: String,
    /// The power of ten, for numbers that would be long without one.
    pub exponent: Option<i32>,
}

/// `x` rounded to `count` significant digits; a power of ten below 10⁻⁴ and from 10⁷ on. −0 is 0.
///
/// ```
/// use standfast::number::significant;
///
/// assert_eq!(significant(-3708.18, 4).to_string(), "-3708");
/// assert_eq!(significant(1.23456e12, 4).to_string(), "1.235e12");
/// ```
pub fn significant(x: f64, count: usize) -> Significant {
    let scientific = format!("{x:.*e}", count.max(1) - 1);
    // `+ 0.0` turns −0 into 0. The largest numbers may round to more than there are, but keep their digits below.
    let rounded: f64 = scientific.parse().unwrap_or(x) + 0.0;
    let plain = rounded == 0.0 || !x.is_finite() || (1e-4..1e7).contains(&rounded.abs());
    match scientific.split_once('e') {
        Some((mantissa, exponent)) if !plain => {
            let short = mantissa.contains('.').then(|| mantissa.trim_end_matches('0').trim_end_matches('.'));
            Significant { mantissa: short.unwrap_or(mantissa).to_owned(), exponent: exponent.parse().ok() }
        }
        _ => Significant { mantissa: rounded.to_string(), exponent: None },
    }
}

/// `x` rounded to `count` significant digits with its zeros at the end, and to as many more as tell it from a `bound` it is compared
/// with: 1.000 is 1, and 0.99998 is less.
///
/// ```
/// use standfast::number::beside;
///
/// assert_eq!(beside(1.1, 1.0, 4).to_string(), "1.100");
/// assert_eq!(beside(0.999983, 1.0, 4).to_string(), "0.99998");
/// ```
pub fn beside(x: f64, bound: f64, count: usize) -> Significant {
    let count = telling(x, bound, count);
    let shown = significant(x, count);
    let rounded: f64 = shown.mantissa.parse().unwrap_or(x);
    if shown.exponent.is_some() || rounded == 0.0 || !rounded.is_finite() {
        return shown;
    }
    let decimals = (count as i32 - 1 - rounded.abs().log10().floor() as i32).max(0) as usize;
    Significant { mantissa: format!("{rounded:.decimals$}"), exponent: None }
}

/// `x` rounded to `count` significant digits, and to as many more as tell it from another number.
pub fn apart(x: f64, other: f64, count: usize) -> Significant {
    significant(x, telling(x, other, count))
}

/// Significant digits, `count` at least, that tell two numbers apart; `count` if they are the same.
fn telling(x: f64, other: f64, count: usize) -> usize {
    /// Digits of an f64.
    const MOST: usize = 17;
    let tells = |count: &usize| x == other || significant(x, *count) != significant(other, *count);
    (count..MOST).find(tells).unwrap_or(MOST)
}

/// `x` with all its digits, as a person would write it: `1e300`, not three hundred digits.
pub fn exact(x: f64) -> String {
    let plain = x == 0.0 || !x.is_finite() || (1e-6..1e15).contains(&x.abs());
    if plain { x.to_string() } else { format!("{x:e}") }
}

/// `x` as [`exact`] has it, without what arithmetic left behind its ninth digit: −0.001, not −0.00099999999999989. A whole number is not
/// rounded to, as it may be the bound that `x` misses.
pub fn reached(x: f64) -> String {
    /// Digits that people write, and those of a number that was computed.
    const WRITTEN: usize = 15;
    let all = exact(x);
    let mantissa = all.split_once('e').map_or(all.as_str(), |(mantissa, _)| mantissa);
    let count = mantissa.trim_start_matches(['-', '0', '.']).chars().filter(char::is_ascii_digit).count();
    let rounded = significant(x, 9);
    let whole = rounded.to_string().parse().is_ok_and(|rounded: f64| rounded.fract() == 0.0);
    if count <= WRITTEN || whole { all } else { rounded.to_string() }
}

impl fmt::Display for Significant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.exponent {
            None => f.write_str(&self.mantissa),
            Some(exponent) => write!(f, "{}e{exponent}", self.mantissa),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{beside, reached, significant};

    #[test]
    fn what_arithmetic_leaves_is_not_shown() {
        assert_eq!(reached(9.0 - 9.001), "-0.001");
        assert_eq!(reached(3.4 + (7.1 - 10.51)), "-0.01");
        assert_eq!([reached(0.3), reached(-2.5e-9), reached(1e300)], ["0.3", "-2.5e-9", "1e300"]);
        // What a person wrote stands as written, and what misses a bound does not look like it.
        assert_eq!(
            [reached(0.123_456_789_012_345), reached(1.0 + f64::EPSILON)],
            ["0.123456789012345", "1.0000000000000002"]
        );
    }

    #[test]
    fn a_compared_number_is_told_from_its_bound() {
        let cases = [
            (1.0, "1.000"),
            (1.1, "1.100"),
            (278.04, "278.0"),
            (0.58334, "0.5833"),
            (9.99996, "10.00"),
            (1.0 - 4e-9, "0.999999996"),
            (1.0 + f64::EPSILON, "1.0000000000000002"),
            (123_456.0, "123500"),
            (0.0, "0"),
            (2e8, "2e8"),
            (f64::INFINITY, "inf"),
        ];
        for (x, expected) in cases {
            assert_eq!(beside(x, 1.0, 4).to_string(), expected);
        }
    }

    #[test]
    fn four_digits() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (0.6, "0.6"),
            (1.0 / 3.0, "0.3333"),
            (-3708.18, "-3708"),
            (378_000.0, "378000"),
            (12345.6, "12350"),
            (9.81, "9.81"),
            (0.99996, "1"),
            (9_999_999.0, "1e7"),
            (2.5e-7, "2.5e-7"),
            (-1.23456e12, "-1.235e12"),
            (1e-4, "0.0001"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
        ];
        for (x, expected) in cases {
            assert_eq!(significant(x, 4).to_string(), expected);
        }
        assert_eq!(significant(f64::NAN, 4).to_string(), "NaN");
        assert_eq!(significant(123.456, 1).to_string(), "100");
    }
}
