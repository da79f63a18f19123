//! Numbers as a caption shows them: three significant digits, a true minus sign, powers of ten when needed.

use standfast::initiation::Chart;

/// A number in markup that is the same in plain characters.
pub(crate) fn digits(number: f64) -> String {
    if number == 0.0 {
        return "0".into();
    }
    let scientific = format!("{number:.2e}");
    let (mantissa, exponent) = scientific.split_once('e').expect("the format has an exponent");
    let exponent: i32 = exponent.parse().expect("the exponent is a whole number");
    let text = if (-4..6).contains(&exponent) {
        let decimals = (2 - exponent).max(0) as usize;
        trimmed(&format!("{number:.decimals$}")).to_string()
    } else {
        format!("{} × 10^{{{exponent}}}", trimmed(mantissa))
    };
    text.replace('-', "−")
}

/// γ and k′ of a chart in markup.
pub(crate) fn body(chart: &Chart) -> String {
    format!("$γ = {}$, $k′ = {}$", digits(chart.slenderness()), digits(chart.elevation()))
}

fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn three_significant_digits() {
        let shown = [0.0, 0.714285, 2.5, -0.55, 12.04, 123456.0, 0.000123456, 1e7, -2.5e-9].map(digits);
        let expected =
            ["0", "0.714", "2.5", "−0.55", "12", "123456", "0.000123", "1 × 10^{7}", "−2.5 × 10^{−9}"];
        assert_eq!(shown, expected);
    }
}
