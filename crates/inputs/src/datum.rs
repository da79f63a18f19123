//! Levels of a chart, and what they are at the body: heights above its base, depths under the sea.
//!
//! | a key is | from a level |
//! |---|---|
//! | a height above the base | level − base |
//! | a depth under the sea | sea − level |
//! | a height above the sea | level − sea |

use crate::digits::{decimal, digits};
use crate::key::Key;
use crate::units::{Dimension, Extent, ShownUnit, number_of, split_text};

/// Zero of a chart at a body: the level of its base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Datum<'a> {
    /// Name behind the unit of a level, as CD.
    pub name: &'a str,
    /// The level of the base, m.
    pub base: f64,
}

impl Datum<'_> {
    /// A height above the base as a level, in words: +4.1 mCD.
    pub fn written(&self, elevation: f64) -> String {
        let level = decimal(elevation + self.base);
        let sign = match level {
            0.0 => "±",
            level if level < 0.0 => "−",
            _ => "+",
        };
        format!("{sign}{} m{}", digits(level.abs()), self.name)
    }
}

/// What a length counts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CountedFrom {
    /// Up from the base.
    Base,
    /// Down from the sea.
    UnderSea,
    /// Up from the sea.
    AboveSea,
}

impl Key {
    /// What its lengths count from; `None` of those between two points of the body, which are no levels.
    pub fn counted_from(self) -> Option<CountedFrom> {
        match self {
            Key::Height
            | Key::CentroidHeight
            | Key::PartBottom
            | Key::PartY
            | Key::Level
            | Key::WaterLeft
            | Key::WaterRight
            | Key::StillWaterLevel
            | Key::WaterElevation
            | Key::PressureElevation
            | Key::BackfillTop
            | Key::Elevation
            | Key::ResistanceElevation => Some(CountedFrom::Base),
            Key::WaterDepth | Key::BaseDepth | Key::DepthAboveBerm => Some(CountedFrom::UnderSea),
            Key::CrestHeight | Key::ArmourCrest | Key::BaseFreeboard => Some(CountedFrom::AboveSea),
            _ => None,
        }
    }
}

/// What texts of numbers are read against: the extent of forces and masses, and the levels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame<'a> {
    /// `None` of a body in pure numbers.
    pub units: Option<Extent>,
    /// Zero of the chart, where the file has one.
    pub datum: Option<Datum<'a>>,
    /// The sea above the base, m, where the file says so.
    pub sea: Option<f64>,
}

impl From<Option<Extent>> for Frame<'_> {
    fn from(units: Option<Extent>) -> Self {
        Frame { units, datum: None, sea: None }
    }
}

/// Reason why a text is no level of a key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LevelFault {
    /// The file has no datum; the level has this one.
    NoDatum(String),
    /// It has one of another name.
    Other(String),
    /// The key is a length between points of the body.
    NoLevel,
    /// It is counted from the sea, and the file does not say how high that stands.
    NoSea,
}

/// The number, the unit of length and the name of a datum in a text such as "+4.10 mCD"; `None` of another.
pub(crate) fn split_level(text: &str) -> Option<(f64, ShownUnit, &str)> {
    let (number, unit) = split_text(text.trim())?;
    let (unit, name) = level_unit(unit.trim())?;
    Some((number_of(number)?, unit, name))
}

/// The unit of length and the name of a datum in such a unit as mCD, or "m CD".
pub(crate) fn level_unit(unit: &str) -> Option<(ShownUnit, &str)> {
    if Dimension::Length.unit(unit).is_some() {
        return None;
    }
    let mut names: Vec<&str> = Dimension::Length.names().collect();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    names.into_iter().find_map(|name| {
        let datum = unit.strip_prefix(name)?.trim_start();
        let is_name = datum.starts_with(char::is_uppercase) && datum.chars().all(char::is_alphanumeric);
        is_name.then_some((Dimension::Length.shown_unit(name)?, datum))
    })
}

impl Frame<'_> {
    /// The length that a level, m, is under a key.
    pub(crate) fn length_at(&self, key: Key, level: f64, name: &str) -> Result<f64, LevelFault> {
        let datum = self.datum.ok_or_else(|| LevelFault::NoDatum(name.to_owned()))?;
        if datum.name != name {
            return Err(LevelFault::Other(datum.name.to_owned()));
        }
        let elevation = level - datum.base;
        let sea = || self.sea.ok_or(LevelFault::NoSea);
        Ok(decimal(match key.counted_from().ok_or(LevelFault::NoLevel)? {
            CountedFrom::Base => elevation,
            CountedFrom::UnderSea => sea()? - elevation,
            CountedFrom::AboveSea => elevation - sea()?,
        }))
    }

    /// The level, m, that a length is under a key; the inverse of `length_at`.
    pub(crate) fn level_at(&self, key: Key, length: f64, name: &str) -> Option<f64> {
        let datum = self.datum.filter(|datum| datum.name == name)?;
        Some(decimal(
            datum.base
                + match key.counted_from()? {
                    CountedFrom::Base => length,
                    CountedFrom::UnderSea => self.sea? - length,
                    CountedFrom::AboveSea => self.sea? + length,
                },
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_told_from_lengths() {
        for (text, number, unit, name) in [
            ("+4.10 mCD", 4.1, "m", "CD"),
            ("-8.2 m NHN", -8.2, "m", "NHN"),
            ("−8.2 mCD", -8.2, "m", "CD"),
            ("13.5 ftMLLW", 13.5, "ft", "MLLW"),
        ] {
            let (found, of, datum) = split_level(text).unwrap();
            assert_eq!((found, of.name(), datum), (number, unit, name));
        }
        for text in ["4.1 m", "4.1 mm", "4.1", "4.1 metres", "mCD", "4.1 kN/m", "4.1 m-CD"] {
            assert_eq!(split_level(text), None, "{text}");
        }
    }

    #[test]
    fn a_level_is_a_height_or_a_depth_and_back() {
        let frame = Frame { units: None, datum: Some(Datum { name: "CD", base: -8.2 }), sea: Some(12.3) };
        for (key, level, length) in [
            (Key::Level, 4.1, 12.3),
            (Key::Elevation, -8.2, 0.0),
            (Key::WaterDepth, -11.0, 15.1),
            (Key::CrestHeight, 7.6, 3.5),
        ] {
            assert_eq!(frame.length_at(key, level, "CD"), Ok(length));
            assert_eq!(frame.level_at(key, length, "CD"), Some(level));
        }
        assert_eq!(frame.length_at(Key::Width, 1.0, "CD"), Err(LevelFault::NoLevel));
        assert_eq!(frame.length_at(Key::Level, 1.0, "NN"), Err(LevelFault::Other("CD".to_owned())));
        let dry = Frame { sea: None, ..frame };
        assert_eq!(dry.length_at(Key::WaterDepth, 1.0, "CD"), Err(LevelFault::NoSea));
        assert_eq!(frame.datum.unwrap().written(8.2), "±0 mCD");
        assert_eq!(frame.datum.unwrap().written(1.2), "−7 mCD");
    }
}
