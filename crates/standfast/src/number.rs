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

/// `x` with all its digits, as a person would write it: `1e300`, not three hundred digits.
pub fn exact(x: f64) -> String {
    let plain = x == 0.0 || !x.is_finite() || (1e-6..1e15).contains(&x.abs());
    if plain { x.to_string() } else { format!("{x:e}") }
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
    use super::significant;

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
