//! Round numbers along an axis, and their decimals.
//!
//! Steps are 1, 2 or 5 times a power of ten. All numbers of an axis have the same decimals, so that they tell apart
//! what the step tells apart; zero is `0`.

use crate::axes::NUMBER;
use crate::number;
use crate::text::Text;

/// The round numbers of an axis with equal steps.
///
/// ```text
/// Scale::new(0.0, 1.4, 7.0)   0  0.2  0.4  …  1.4, with a tick between two numbers at each 0.05
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    from: f64,
    to: f64,
    /// The step is `factor` times ten to the power of `exponent`.
    factor: u8,
    exponent: i32,
}

impl Scale {
    /// At most `most` steps between `from` and the greater `to`.
    pub(crate) fn new(from: f64, to: f64, most: f64) -> Scale {
        let range = to - from;
        let exponent = (range / most).log10().floor() as i32;
        let scale = |factor, exponent| Scale { from, to, factor, exponent };
        let fits = |scale: &Scale| range <= most * scale.step() * (1.0 + 1e-9);
        let steps = [1, 2, 5].map(|factor| scale(factor, exponent));
        steps.into_iter().find(fits).unwrap_or(scale(1, exponent + 1))
    }

    /// The distance between two numbers.
    fn step(&self) -> f64 {
        f64::from(self.factor) * 10f64.powi(self.exponent)
    }

    /// The numbers, rising, the ends of the axis among them if they are round.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        self.multiples(1).into_iter().map(|(_, number)| number).collect()
    }

    /// The places of smaller ticks between the numbers: halves, quarters or fifths of a step, themselves round.
    pub(crate) fn between(&self) -> Vec<f64> {
        let parts = if self.factor == 2 { 4 } else { 5 };
        let ticks = self.multiples(parts).into_iter();
        ticks.filter(|(count, _)| count % i64::from(parts) != 0).map(|(_, place)| place).collect()
    }

    /// Multiples of a part of a step on the axis: the number of parts, and the value.
    fn multiples(&self, parts: u8) -> Vec<(i64, f64)> {
        let part = self.step() / f64::from(parts);
        let (first, last) = ((self.from / part - 1e-9).ceil(), (self.to / part + 1e-9).floor());
        (first as i64..=last as i64).map(|count| (count, count as f64 * part)).collect()
    }

    /// A number of this axis as it is written.
    pub(crate) fn text(&self, number: f64) -> Text {
        Text::new(&self.markup(number), NUMBER)
    }

    /// A number of this axis in markup.
    pub(crate) fn markup(&self, number: f64) -> String {
        let decimals = (-self.exponent).max(0) as usize;
        if number.abs() < 1e-6 * self.step() {
            "$0$".into()
        } else if number.abs() >= 1e5 || decimals > 5 {
            format!("${}$", number::digits(number))
        } else {
            format!("${number:.decimals$}$").replace('-', "−")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Scale;

    fn written(scale: Scale) -> Vec<String> {
        scale.numbers().into_iter().map(|number| scale.markup(number).replace('$', "")).collect()
    }

    #[test]
    fn numbers_are_round_and_have_the_same_decimals() {
        assert_eq!(
            written(Scale::new(0.0, 1.43, 8.0)),
            ["0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2", "1.4"][..]
        );
        assert_eq!(written(Scale::new(0.0, 2.0, 4.0)), ["0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(written(Scale::new(-1.0, 1.0, 4.0)), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(written(Scale::new(0.3012, 0.3049, 4.0)), ["0.302", "0.303", "0.304"]);
        assert_eq!(written(Scale::new(0.0, 40.0, 4.0)), ["0", "10", "20", "30", "40"]);
        assert_eq!(written(Scale::new(0.0, 3e7, 3.0)).last().map(String::as_str), Some("3 × 10^{7}"));
    }

    #[test]
    fn never_more_steps_than_asked_for_and_never_fewer_than_two_in_five() {
        for i in 0..2000 {
            let to = 10f64.powf(f64::from(i) / 100.0 - 10.0);
            let steps = Scale::new(0.0, to, 7.0).numbers().len() - 1;
            assert!((2..=7).contains(&steps), "{steps} steps up to {to}");
        }
    }

    #[test]
    fn smaller_ticks_part_a_step_into_round_pieces() {
        let close = |ticks: Vec<f64>, expected: &[f64]| {
            assert_eq!(ticks.len(), expected.len(), "{ticks:?}");
            assert!(ticks.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12), "{ticks:?}");
        };
        close(Scale::new(0.0, 0.2, 1.0).between(), &[0.05, 0.1, 0.15]);
        close(Scale::new(0.0, 1.0, 1.0).between(), &[0.2, 0.4, 0.6, 0.8]);
        close(Scale::new(0.0, 5.0, 1.0).between(), &[1.0, 2.0, 3.0, 4.0]);
    }
}
