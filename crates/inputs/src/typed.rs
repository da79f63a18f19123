//! Meaning of a text that a person types for a number, and texts that have two.
//!
//! | in the text | meaning |
//! |---|---|
//! | one point or one comma | the decimal sign |
//! | spaces of any width, apostrophes | between groups of three digits before the decimal sign |
//! | `-` or `−`, `+`; `e3` | a sign; a power of ten |
//! | a unit behind the number | that unit, in place of the one that stands there |
//!
//! Nothing is guessed. `2,700` may be meant as 2.7 or as 2700, and `1.234,5` mixes two habits: both are refused, and the
//! message shows what to type instead. The point is always decimal, as in a case file: `2.700` is 2.7.

use crate::units::{Dimension, GRAVITY_UNIT};

/// A number as it was typed.
#[derive(Debug, Clone, PartialEq)]
pub struct Typed {
    /// The number.
    pub number: f64,
    /// The unit behind it, as a case file has it.
    pub unit: Option<&'static str>,
}

/// Units that a typed number may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TypedUnits {
    /// Those of a dimension; none of a plain number.
    pub dimension: Option<Dimension>,
    /// True if it may count the acceleration of gravity.
    pub gravity: bool,
}

impl TypedUnits {
    fn find(self, name: &str) -> Option<&'static str> {
        let names = self.dimension.into_iter().flat_map(Dimension::names);
        let mut names = names.chain(self.gravity.then_some(GRAVITY_UNIT));
        names.find(|known| known.chars().filter(|letter| !letter.is_whitespace()).eq(name.chars()))
    }

    fn understood(self) -> String {
        let gravity = if self.gravity { "g, " } else { "" };
        self.dimension.map_or(String::new(), |dimension| format!("{gravity}{}", dimension.understood()))
    }
}

/// The number in a text, and its unit where it names one of `units`.
///
/// ```
/// use standfast_inputs::typed::{TypedUnits, typed};
/// use standfast_inputs::units::Dimension;
///
/// let force = TypedUnits { dimension: Some(Dimension::Force), gravity: false };
/// let read = typed("2 700,5 kN/m", force)?;
/// assert_eq!((read.number, read.unit), (2700.5, Some("kN/m")));
/// # Ok::<(), String>(())
/// ```
///
/// # Errors
/// A sentence on the fault for the person who typed it: no number, or not one number only.
pub fn typed(text: &str, units: TypedUnits) -> Result<Typed, String> {
    let text = text.trim();
    if text.is_empty() {
        return Err("A number is missing.".to_owned());
    }
    let (number, unit) = number_and_rest(text)?;
    Ok(Typed { number, unit: known(unit, units)? })
}

/// The number at the beginning of a text, and what stands behind it, whatever that is.
///
/// # Errors
/// As [`typed`].
pub fn number_and_rest(text: &str) -> Result<(f64, &str), String> {
    let (number, rest) = text.split_at(end_of_number(text));
    let value = value(number.trim()).map_err(|fault| fault.sentence(number.trim(), text))?;
    Ok((value, rest))
}

/// Reason why a text is not one number.
enum Fault {
    NotANumber,
    TooLarge,
    /// The readings of a comma before three digits: as the decimal sign, and between thousands.
    Ambiguous(f64, f64),
    /// Points and commas that look like thousands, and the number then meant.
    Mixed(f64),
}

impl Fault {
    fn sentence(&self, number: &str, text: &str) -> String {
        match self {
            Fault::NotANumber => format!("“{text}” is not a number."),
            Fault::TooLarge => format!("“{number}” is too large a number."),
            Fault::Ambiguous(decimal, thousands) => {
                let (decimal, thousands) = (exact(*decimal), exact(*thousands));
                format!("“{number}” could be {decimal} or {thousands}: type {decimal} or {thousands}.")
            }
            Fault::Mixed(meant) => format!(
                "“{number}” has more than one point or comma: type {} if that is meant. One of them is the decimal sign; \
                 spaces may stand between thousands.",
                exact(*meant)
            ),
        }
    }
}

/// With all its digits, so that it is the number meant if it is typed.
fn exact(value: f64) -> String {
    value.to_string().replace('-', "−")
}

fn is_gap(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, '\'' | '’')
}

fn is_sign(letter: char) -> bool {
    matches!(letter, '+' | '-' | '−')
}

/// Place at which the number ends and its unit begins.
fn end_of_number(text: &str) -> usize {
    let rest = |at: usize| text[at..].chars().skip(1);
    let is_power = |at: usize| {
        let after_digit =
            text[..at].ends_with(|letter: char| letter.is_ascii_digit() || ".,".contains(letter));
        after_digit && rest(at).find(|letter| !is_sign(*letter)).is_some_and(|letter| letter.is_ascii_digit())
    };
    let belongs = |(at, letter): (usize, char)| match letter {
        'e' | 'E' => is_power(at),
        _ => letter.is_ascii_digit() || matches!(letter, '.' | ',') || is_gap(letter) || is_sign(letter),
    };
    text.char_indices().find(|found| !belongs(*found)).map_or(text.len(), |(at, _)| at)
}

fn value(number: &str) -> Result<f64, Fault> {
    let (mantissa, power) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let (sign, digits) = match mantissa.strip_prefix(is_sign) {
        Some(rest) => (if mantissa.starts_with('+') { "" } else { "-" }, rest),
        None => ("", mantissa),
    };
    let power = power.replace('−', "-");
    let number = |whole: &str, part: &str| -> Result<f64, Fault> {
        let digits = grouped(whole).ok_or(Fault::NotANumber)?;
        let text = format!("{sign}{digits}.{part}e{power}");
        let plain =
            part.chars().all(|letter| letter.is_ascii_digit()) && !(digits.is_empty() && part.is_empty());
        let value = text.parse::<f64>().ok().filter(|_| plain).ok_or(Fault::NotANumber)?;
        if value.is_finite() { Ok(value) } else { Err(Fault::TooLarge) }
    };

    let marks: Vec<char> = digits.chars().filter(|letter| matches!(letter, '.' | ',')).collect();
    match marks[..] {
        [] => number(digits, ""),
        [mark] => {
            let (whole, part) = digits.split_once(mark).unwrap_or((digits, ""));
            let decimal = number(whole, part)?;
            let like_thousands = (1..=3).contains(&whole.len()) && part.len() == 3 && !whole.starts_with('0');
            if mark == ',' && like_thousands {
                return Err(Fault::Ambiguous(decimal, number(&format!("{whole}{part}"), "")?));
            }
            Ok(decimal)
        }
        [.., last] => {
            // Marks of one kind stand between thousands; one of another kind behind them is decimal.
            let (whole, part) = match marks.iter().all(|mark| *mark == last) {
                true => (digits, ""),
                false => digits.rsplit_once(last).unwrap_or((digits, "")),
            };
            let meant = number(&whole.replace(marks[0], " "), part)?;
            Err(Fault::Mixed(meant))
        }
    }
}

/// The digits of a whole number without what stands between thousands; `None` if that stands elsewhere.
fn grouped(whole: &str) -> Option<String> {
    let groups: Vec<&str> = whole.split(is_gap).collect();
    let digits = groups.iter().all(|group| group.chars().all(|letter| letter.is_ascii_digit()));
    let [first, others @ ..] = &groups[..] else { return None };
    let thousands =
        others.is_empty() || (1..=3).contains(&first.len()) && others.iter().all(|group| group.len() == 3);
    (digits && thousands).then(|| groups.concat())
}

fn known(unit: &str, units: TypedUnits) -> Result<Option<&'static str>, String> {
    let unit: String = unit.split_whitespace().collect();
    if unit.is_empty() {
        return Ok(None);
    }
    match units.find(&unit) {
        Some(name) => Ok(Some(name)),
        None if units.dimension.is_none() => {
            Err(format!("“{unit}” is no part of a number, and this one has no unit."))
        }
        None => Err(format!("“{unit}” is not a unit of this field, which takes {}.", units.understood())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: TypedUnits = TypedUnits { dimension: None, gravity: false };

    fn of(dimension: Dimension) -> TypedUnits {
        TypedUnits { dimension: Some(dimension), gravity: false }
    }

    fn read(text: &str, units: TypedUnits) -> Result<(f64, Option<&'static str>), String> {
        typed(text, units).map(|read| (read.number, read.unit))
    }

    #[test]
    fn either_decimal_sign_and_gaps_between_thousands_are_read() {
        let cases = [
            ("0,6", 0.6),
            ("0.6", 0.6),
            ("10,5", 10.5),
            (",5", 0.5),
            ("5.", 5.0),
            ("2.700", 2.7),
            ("0,600", 0.6),
            ("1234,567", 1234.567),
            ("1 234,5", 1234.5),
            ("1\u{202f}234\u{a0}567", 1_234_567.0),
            ("1\u{2009}234.5", 1234.5),
            ("12’345", 12345.0),
            ("1'234,567", 1234.567),
            (" −0,55 ", -0.55),
            ("-3", -3.0),
            ("+3", 3.0),
            ("1e−9", 1e-9),
            ("2,5E3", 2500.0),
        ];
        for (typed, expected) in cases {
            assert_eq!(read(typed, PLAIN), Ok((expected, None)), "{typed}");
        }
    }

    #[test]
    fn a_unit_behind_the_number_counts() {
        let cases = [
            ("12 m", 12.0, "m"),
            ("12m", 12.0, "m"),
            ("150 cm", 150.0, "cm"),
            ("1 500\u{a0}mm", 1500.0, "mm"),
            ("1e3 cm", 1000.0, "cm"),
        ];
        for (typed, value, unit) in cases {
            assert_eq!(read(typed, of(Dimension::Length)), Ok((value, Some(unit))), "{typed}");
        }
        assert_eq!(read("2700 kN / m", of(Dimension::Force)), Ok((2700.0, Some("kN/m"))));
        assert_eq!(read("9500 t m2/m", of(Dimension::Inertia)), Ok((9500.0, Some("t m2/m"))));
        let shaken = TypedUnits { dimension: Some(Dimension::Acceleration), gravity: true };
        assert_eq!(read("0,25g", shaken), Ok((0.25, Some("g"))));
        // Milli is not mega.
        for (typed, units, message) in [
            (
                "3 mN/m",
                of(Dimension::Force),
                "“mN/m” is not a unit of this field, which takes N/m, kN/m, MN/m, kgf/m, tf/m, lbf/ft or kip/ft.",
            ),
            (
                "3 yd",
                of(Dimension::Length),
                "“yd” is not a unit of this field, which takes mm, cm, m, ft or in.",
            ),
            ("0.6 m", PLAIN, "“m” is no part of a number, and this one has no unit."),
        ] {
            assert_eq!(read(typed, units), Err(message.to_owned()));
        }
    }

    #[test]
    fn what_could_be_two_numbers_is_refused_with_both() {
        let cases = [
            ("2,700", "“2,700” could be 2.7 or 2700: type 2.7 or 2700."),
            ("−12,345", "“−12,345” could be −12.345 or −12345: type −12.345 or −12345."),
            ("2,700 kN/m", "“2,700” could be 2.7 or 2700: type 2.7 or 2700."),
        ];
        for (typed, message) in cases {
            assert_eq!(read(typed, of(Dimension::Force)), Err(message.to_owned()));
        }
        for (typed, meant) in [
            ("1.234,5", "1234.5"),
            ("1,234.5", "1234.5"),
            ("1,234,567", "1234567"),
            ("1.234.567,8", "1234567.8"),
        ] {
            let message = read(typed, PLAIN).unwrap_err();
            assert!(
                message.starts_with(&format!("“{typed}” has more than one point or comma: type {meant} "))
            );
        }
    }

    #[test]
    fn what_is_no_number_is_said() {
        for typed in [
            "abc", "inf", "NaN", ".", ",", "-", "1-2", "--1", "12 34", "1 2345", "1.5 000", "1,2,3", "1..2",
            "1.2,3,4", "' 5", "1e2e3", "x5",
        ] {
            let message = read(typed, PLAIN).unwrap_err();
            assert!(
                message.contains("is not a number") || message.contains("no part of a number"),
                "{typed}: {message}"
            );
        }
        assert_eq!(read(" \u{a0} ", PLAIN), Err("A number is missing.".to_owned()));
        assert_eq!(read("1e999", PLAIN), Err("“1e999” is too large a number.".to_owned()));
    }
}
