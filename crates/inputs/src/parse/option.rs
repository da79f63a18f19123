//! Values given at an option, which say there what they say behind their keys in a case file.

use std::borrow::Cow;

use toml::Spanned;
use toml::de::DeValue;

use super::{Field, PlacedProblem};
use crate::datum::Frame;
use crate::digits::shortened;
use crate::error::Problem;
use crate::inputs::{Value, dimension};
use crate::key::{Id, Kind};
use crate::units::UnitError;

/// The value that `written` says for a key that takes `kind` in a case with such units and levels: a number, a text or a list as in a file, but that a text may
/// stand without its quotes, which a command line takes away.
pub fn read<'a>(id: Id, kind: Kind, frame: impl Into<Frame<'a>>, written: &str) -> Result<Value, Problem> {
    let frame = frame.into();
    let parsed = DeValue::parse(written).ok();
    let text = Spanned::new(0..written.len(), DeValue::String(Cow::Borrowed(written)));
    let value = parsed.as_ref().unwrap_or(&text);
    Field { id, value, text: written, frame }.value(kind).map_err(|PlacedProblem { problem, .. }| {
        match problem {
            // Two numbers to the one, a decimal to the other.
            Problem::WrongType { .. } if written.replace(',', ".").parse::<f64>().is_ok() => {
                let dimension = dimension(id, frame.units);
                Problem::Unit {
                    key: id.key,
                    dimension,
                    written: shortened(written),
                    error: UnitError::Separator,
                }
            }
            other => other,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::Key;
    use crate::parse::CaseText;
    use crate::units::Extent;

    /// Texts say the same in a file, in quotes where they are not numbers, and at an option.
    #[test]
    fn an_option_says_what_a_file_says() {
        let keys =
            [Key::Width, Key::Mass, Key::Friction, Key::Horizontal, Key::GreatestBearing, Key::LeastContact];
        let texts = [
            "8",
            "8.5",
            "-8",
            "0",
            "+3e-2",
            "1_000",
            "0x10",
            "8 m",
            " 8 m ",
            "800 cm",
            "8m",
            "8,5",
            "8,5 m",
            "0.25 g",
            "0.25g",
            "2 m/s2",
            "300kPa",
            "300 kN/m2",
            "3 t/m",
            "inf",
            "nan",
            "m",
            "",
            "8 kg",
            "true",
            "0.5",
        ];
        for key in keys {
            for text in texts {
                let info = key.info();
                let header = info.table.name();
                let read_file = |value: &str| {
                    let text = format!("[{header}]\n{} = {value}\n", info.name);
                    CaseText::parse("t.toml", &text).map(|file| file.inputs().get(key).cloned())
                };
                let in_file = read_file(text).or_else(|_| read_file(&format!("\"{text}\""))).ok().flatten();
                assert_eq!(
                    read(key.into(), info.kind, Some(Extent::PerMetre), text).ok(),
                    in_file,
                    "{key} = {text}"
                );
            }
        }
    }

    #[test]
    fn what_is_wrong_is_said() {
        let read = |key: Key, text| read(key.into(), key.info().kind, Some(Extent::PerMetre), text);
        let comma = read(Key::Friction, "0,5");
        assert!(matches!(comma, Err(Problem::Unit { error: UnitError::Separator, .. })), "{comma:?}");
        let two = read(Key::Width, "8\ny = 3");
        assert!(two.is_err(), "{two:?}");
    }
}
