//! Numbers as a caption shows them: three significant digits, a true minus sign, powers of ten when needed.

use standfast::initiation::Chart;
use standfast::number::{self, Significant};

/// A number in markup that is the same in plain characters.
pub(crate) fn digits(number: f64) -> String {
    significant(number, 3)
}

/// A number with more than three significant digits if it takes them to tell it from its `neighbours`.
pub(crate) fn distinct_digits(number: f64, neighbours: &[f64]) -> String {
    const MOST: usize = 9;
    let tells = |count: &usize| {
        let shown = significant(number, *count);
        neighbours.iter().all(|&other| other == number || significant(other, *count) != shown)
    };
    significant(number, (3..MOST).find(tells).unwrap_or(MOST))
}

/// A number with `count` significant digits, a true minus sign, and a power of ten as `10^{7}` when needed.
pub fn significant(number: f64, count: usize) -> String {
    if number.is_infinite() {
        return if number > 0.0 { "∞" } else { "−∞" }.into();
    }
    let Significant { mantissa, exponent } = number::significant(number, count);
    let text = match exponent {
        None => mantissa,
        Some(exponent) => format!("{mantissa} × 10^{{{exponent}}}"),
    };
    text.replace('-', "−")
}

/// γ and k′ of a chart in markup.
pub(crate) fn body(chart: &Chart) -> String {
    format!("$γ = {}$, $k′ = {}$", digits(chart.gamma()), digits(chart.k_prime()))
}

#[cfg(test)]
mod tests {
    use super::{digits, distinct_digits};

    #[test]
    fn three_significant_digits() {
        let shown = [0.0, 0.714285, 2.5, -0.55, 12.04, 123456.0, 0.000123456, 1e7, -2.5e-9].map(digits);
        let expected =
            ["0", "0.714", "2.5", "−0.55", "12", "123000", "0.000123", "1 × 10^{7}", "−2.5 × 10^{−9}"];
        assert_eq!(shown, expected);
    }

    #[test]
    fn neighbours_are_told_apart() {
        assert_eq!(distinct_digits(0.83, &[0.0, 1.2]), "0.83");
        assert_eq!(distinct_digits(0.99961, &[0.7, 1.0]), "0.9996");
        assert_eq!(distinct_digits(1.0, &[1.0 + 1e-12]), "1");
    }
}
