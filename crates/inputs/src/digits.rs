//! Numbers and written words in few characters.

use standfast::number;

/// Four significant digits, without trailing zeros.
pub fn digits(x: f64) -> String {
    significant(x, 4)
}

/// A safety factor, or a ratio that is compared with 1, in four digits; in more where it takes them to tell it from 1, as far as it is
/// known.
pub fn factor(x: f64) -> String {
    factor_in(x, 4)
}

/// The same in `count` digits.
pub(crate) fn factor_in(x: f64, count: usize) -> String {
    // A quotient of sums is not known to its last bits.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let x = if (x - 1.0).abs() <= ROUNDING { 1.0 } else { x };
    if x == f64::INFINITY { "unlimited".to_owned() } else { number::beside(x, 1.0, count).to_string() }
}

/// A share of a whole in per cent; in more than four digits where it takes them to tell it from the whole.
pub fn percent(share: f64) -> String {
    let whole = 100.0;
    let text = if share == 1.0 { digits(whole) } else { apart(&[whole * share, whole]).swap_remove(0) };
    format!("{text} %")
}

/// Different numbers in as few significant digits, four at least, as tell them apart.
pub fn apart(numbers: &[f64]) -> Vec<String> {
    let mut texts = Vec::new();
    for count in 4..=17 {
        texts = numbers.iter().map(|x| significant(*x, count)).collect();
        if texts.windows(2).all(|pair| pair[0] != pair[1]) {
            break;
        }
    }
    texts
}

/// A number in `count` significant digits, without trailing zeros; "unlimited" for infinity.
pub fn significant(x: f64, count: usize) -> String {
    if x == f64::INFINITY { "unlimited".to_owned() } else { number::significant(x, count).to_string() }
}

/// A number to all its digits, but for what binary fractions add behind the fifteenth.
pub fn plain(x: f64) -> String {
    significant(x, 15)
}

/// A product or a quotient of decimals without what rounding leaves behind their digits: 3 times 0.3048 is 0.9144.
pub fn decimal(x: f64) -> f64 {
    format!("{x:.14e}").parse().unwrap_or(x)
}

/// Words from a file, shortened where they would fill the screen.
pub fn shortened(written: &str) -> String {
    const MOST: usize = 120;
    match written.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &written[..end]),
        None => written.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{digits, factor, percent};

    #[test]
    fn numbers_in_text() {
        assert_eq!([digits(1.0 / 3.0), digits(-0.0), digits(f64::INFINITY)], ["0.3333", "0", "unlimited"]);
        assert_eq!([factor(1.0), factor(0.99998), factor(f64::INFINITY)], ["1.000", "0.99998", "unlimited"]);
        assert_eq!([factor(1.0 + f64::EPSILON), factor(1.0 - 1e-12)], ["1.000", "0.999999999999"]);
        assert_eq!([percent(1.0), percent(0.7), percent(0.999_984)], ["100 %", "70 %", "99.998 %"]);
    }
}
