//! Quantities as people write them, "450 kN/m", to SI.
//!
//! Forces, masses and weights are per metre run of the body, as in a cross-section; those of an object of a given length, and of
//! a cylinder, are those of the whole.

use thiserror::Error;

use crate::digits::{decimal, digits, shortened};

/// Extent of forces, masses and moments of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Extent {
    /// One metre of a long body.
    PerMetre,
    /// The whole object.
    Whole,
}

impl Extent {
    /// In a word, as in the JSON.
    pub fn name(self) -> &'static str {
        match self {
            Extent::PerMetre => "per-metre",
            Extent::Whole => "whole",
        }
    }

    /// A force in kN.
    pub fn kilonewtons(self, force: f64) -> String {
        self.of(Dimension::Force).written(force)
    }

    /// A moment in kN m.
    pub fn kilonewton_metres(self, moment: f64) -> String {
        self.of(Dimension::Moment).written(moment)
    }

    /// A mass, in t per metre run or in kg.
    pub fn mass(self, mass: f64) -> String {
        self.of(Dimension::Mass).written(mass)
    }

    /// A moment of inertia, in t m² per metre run or in kg m².
    pub fn inertia(self, moment: f64) -> String {
        self.of(Dimension::Inertia).written(moment)
    }

    /// Dimension of a quantity in a case of this extent.
    pub const fn of(self, dimension: Dimension) -> Dimension {
        match (self, dimension) {
            (Extent::Whole, Dimension::Mass) => Dimension::WholeMass,
            (Extent::Whole, Dimension::Force) => Dimension::WholeForce,
            (Extent::Whole, Dimension::Inertia) => Dimension::WholeInertia,
            (Extent::Whole, Dimension::Moment) => Dimension::WholeMoment,
            (_, dimension) => dimension,
        }
    }
}

/// Dimension of a number, which has the units that fit it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// m.
    Length,
    /// kg per metre run.
    Mass,
    /// kg/m³.
    Density,
    /// N per metre run.
    Force,
    /// m/s².
    Acceleration,
    /// kg m² per metre run.
    Inertia,
    /// Pa.
    Pressure,
    /// s.
    Time,
    /// N·m per metre run.
    Moment,
    /// N/m³, of what weighs.
    UnitWeight,
    /// N/m³, pressure over displacement.
    Stiffness,
    /// rad.
    Angle,
    /// kg.
    WholeMass,
    /// N.
    WholeForce,
    /// kg m².
    WholeInertia,
    /// N·m.
    WholeMoment,
}

/// The name of a unit, and the power of ten that makes SI of it.
type NamedUnit = (&'static str, i32);

/// A unit of some dimension, by what makes SI of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// A power of ten.
    power: i32,
    /// A factor beside it; 1 of the units of SI.
    factor: f64,
}

impl Unit {
    /// That of SI times a power of ten.
    pub const fn of_power(power: i32) -> Unit {
        Unit { power, factor: 1.0 }
    }

    const fn of_factor(factor: f64) -> Unit {
        Unit { power: 0, factor }
    }

    /// The power of ten that makes SI of it, where nothing else does.
    pub fn power(self) -> Option<i32> {
        (self.factor == 1.0).then_some(self.power)
    }

    /// So many of it, in SI units: the f64 nearest to the decimal that `value` stands for, times a power of ten. "123 mm" is 0.123,
    /// just as the plain number is; of a unit with a factor, to fifteen digits: "3 ft" is 0.9144.
    pub fn si(self, value: f64) -> f64 {
        if self.factor != 1.0 {
            return decimal(value * self.factor);
        }
        // A whole number is multiplied, or divided, with one rounding.
        if self.power == 0 || value.fract() == 0.0 {
            let factor = 10f64.powi(self.power.abs());
            return if self.power < 0 { value / factor } else { value * factor };
        }
        let written = format!("{value:e}");
        let (digits, exponent) = written.split_once('e').unwrap_or((&written, "0"));
        let exponent = exponent.parse::<i32>().unwrap_or_default() + self.power;
        format!("{digits}e{exponent}").parse().unwrap_or(f64::NAN)
    }

    /// An SI value as a number of this unit.
    pub fn of_si(self, value: f64) -> f64 {
        if self.factor != 1.0 {
            return value / self.factor;
        }
        let factor = 10f64.powi(self.power.abs());
        if self.power < 0 { value * factor } else { value / factor }
    }
}

/// kgf, lbf and their like: 9.80665 N by definition, and 0.45359237 kg times that.
const KGF: f64 = 9.80665;
const LBF: f64 = 4.448_221_615_260_5;
/// The foot and the inch, m.
const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;

/// A unit by its name, in which a number is shown to people.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownUnit {
    name: &'static str,
    of: ShownScale,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum ShownScale {
    Unit(Unit),
    Gravity(f64),
}

impl ShownUnit {
    /// The acceleration of gravity of a case, m/s².
    pub(crate) fn gravity(gravity: f64) -> ShownUnit {
        ShownUnit { name: GRAVITY_UNIT, of: ShownScale::Gravity(gravity) }
    }

    /// Its name, as a file has it.
    pub fn name(self) -> &'static str {
        self.name
    }

    /// Its name with powers raised, for reading.
    pub fn symbol(self) -> String {
        raised(self.name)
    }

    /// So many of it, in SI units.
    pub fn in_si(self, number: f64) -> f64 {
        match self.of {
            ShownScale::Unit(unit) => unit.si(number),
            ShownScale::Gravity(gravity) => number * gravity,
        }
    }

    /// The unit of moments of forces in this unit: their arms are in metres, or in feet beside lbf and kip.
    pub(crate) fn of_moments(self) -> Option<ShownUnit> {
        let (force, per) = self.name.split_once('/').map_or((self.name, ""), |(force, _)| (force, "/"));
        let moments = if per.is_empty() { Dimension::WholeMoment } else { Dimension::Moment };
        let of_force = |name: &&str| name.split_once(' ').is_some_and(|(unit, _)| unit == force);
        moments.names().find(of_force).and_then(|name| moments.shown_unit(name))
    }

    /// An SI value as a number of this unit.
    pub fn of_si(self, si: f64) -> f64 {
        match self.of {
            ShownScale::Unit(unit) => unit.of_si(si),
            ShownScale::Gravity(gravity) => si / gravity,
        }
    }
}

impl Dimension {
    fn units(self) -> &'static [NamedUnit] {
        match self {
            Dimension::Length => &[("mm", -3), ("cm", -2), ("m", 0)],
            Dimension::Mass => &[("kg/m", 0), ("t/m", 3)],
            Dimension::Density => &[("kg/m3", 0), ("t/m3", 3), ("kg/m³", 0), ("t/m³", 3)],
            Dimension::Force => &[("N/m", 0), ("kN/m", 3), ("MN/m", 6)],
            Dimension::Acceleration => &[("m/s2", 0), ("m/s²", 0), ("cm/s2", -2), ("Gal", -2)],
            Dimension::Inertia => &[("kg m2/m", 0), ("t m2/m", 3), ("kg m²/m", 0), ("t m²/m", 3)],
            Dimension::Pressure => &[
                ("Pa", 0),
                ("kPa", 3),
                ("MPa", 6),
                ("bar", 5),
                ("kN/m2", 3),
                ("kN/m²", 3),
                ("kN/m^2", 3),
                ("MN/m2", 6),
                ("MN/m²", 6),
                ("N/mm2", 6),
                ("N/mm²", 6),
            ],
            Dimension::UnitWeight => &[("N/m3", 0), ("kN/m3", 3), ("N/m³", 0), ("kN/m³", 3), ("kN/m^3", 3)],
            Dimension::Stiffness => {
                &[("N/m3", 0), ("kN/m3", 3), ("MN/m3", 6), ("N/m³", 0), ("kN/m³", 3), ("MN/m³", 6)]
            }
            Dimension::Angle => &[("rad", 0), ("mrad", -3)],
            Dimension::Time => &[("s", 0), ("ms", -3)],
            Dimension::Moment => &[("N m/m", 0), ("kN m/m", 3), ("MN m/m", 6)],
            Dimension::WholeMass => &[("kg", 0), ("t", 3)],
            Dimension::WholeForce => &[("N", 0), ("kN", 3), ("MN", 6)],
            Dimension::WholeInertia => &[("kg m2", 0), ("t m2", 3), ("kg m²", 0), ("t m²", 3)],
            Dimension::WholeMoment => &[("N m", 0), ("kN m", 3), ("MN m", 6)],
        }
    }

    /// Units that are none of SI times a power of ten, with their size in SI.
    fn others(self) -> &'static [(&'static str, f64)] {
        match self {
            Dimension::Length => &[("ft", FOOT), ("in", INCH)],
            Dimension::Mass => &[("slug/ft", LBF / FOOT / FOOT)],
            Dimension::Density => &[("pcf", LBF / KGF / (FOOT * FOOT * FOOT))],
            Dimension::Force => {
                &[("kgf/m", KGF), ("tf/m", 1e3 * KGF), ("lbf/ft", LBF / FOOT), ("kip/ft", 1e3 * LBF / FOOT)]
            }
            Dimension::Acceleration => &[("ft/s2", FOOT)],
            Dimension::Pressure => &[
                ("tf/m2", 1e3 * KGF),
                ("tf/m²", 1e3 * KGF),
                ("kgf/cm2", 1e4 * KGF),
                ("kgf/cm²", 1e4 * KGF),
                ("psf", LBF / (FOOT * FOOT)),
                ("ksf", 1e3 * LBF / (FOOT * FOOT)),
                ("psi", LBF / (INCH * INCH)),
            ],
            Dimension::UnitWeight => &[("tf/m3", 1e3 * KGF), ("pcf", LBF / (FOOT * FOOT * FOOT))],
            Dimension::Angle => &[("deg", std::f64::consts::PI / 180.0), ("°", std::f64::consts::PI / 180.0)],
            Dimension::Moment => {
                &[("kgf m/m", KGF), ("tf m/m", 1e3 * KGF), ("lbf ft/ft", LBF), ("kip ft/ft", 1e3 * LBF)]
            }
            Dimension::WholeMass => &[("slug", LBF / FOOT)],
            Dimension::WholeForce => &[("kgf", KGF), ("tf", 1e3 * KGF), ("lbf", LBF), ("kip", 1e3 * LBF)],
            Dimension::WholeMoment => {
                &[("kgf m", KGF), ("tf m", 1e3 * KGF), ("lbf ft", LBF * FOOT), ("kip ft", 1e3 * LBF * FOOT)]
            }
            Dimension::Stiffness | Dimension::Inertia | Dimension::WholeInertia | Dimension::Time => &[],
        }
    }

    /// The dimension in words.
    pub fn words(self) -> &'static str {
        match self {
            Dimension::Length => "a length",
            Dimension::Mass => "a mass per metre run",
            Dimension::Density => "a density",
            Dimension::Force => "a force per metre run",
            Dimension::Acceleration => "an acceleration",
            Dimension::Inertia => "a moment of inertia per metre run",
            Dimension::Pressure => "a pressure",
            Dimension::Time => "a time",
            Dimension::Moment => "a moment per metre run",
            Dimension::UnitWeight => "a unit weight",
            Dimension::Stiffness => "a stiffness, pressure over displacement",
            Dimension::Angle => "an angle",
            Dimension::WholeMass => "a mass of the whole object",
            Dimension::WholeForce => "a force on the whole object",
            Dimension::WholeInertia => "a moment of inertia of the whole object",
            Dimension::WholeMoment => "a moment on the whole object",
        }
    }

    /// The unit of a plain number.
    pub fn si(self) -> &'static str {
        match self {
            Dimension::Length => "m",
            Dimension::Mass => "kg/m",
            Dimension::Density => "kg/m3",
            Dimension::Force => "N/m",
            Dimension::Acceleration => "m/s2",
            Dimension::Inertia => "kg m2/m",
            Dimension::Pressure => "Pa",
            Dimension::Time => "s",
            Dimension::Moment => "N m/m",
            Dimension::UnitWeight | Dimension::Stiffness => "N/m3",
            Dimension::Angle => "rad",
            Dimension::WholeMass => "kg",
            Dimension::WholeForce => "N",
            Dimension::WholeInertia => "kg m2",
            Dimension::WholeMoment => "N m",
        }
    }

    /// The SI unit with powers raised, for reading.
    pub fn symbol(self) -> String {
        raised(self.si())
    }

    /// The unit in which people read it, and how many SI units make one.
    pub const fn on_paper(self) -> (&'static str, f64) {
        match self {
            Dimension::Mass => ("t/m", 1e3),
            Dimension::Force => ("kN/m", 1e3),
            Dimension::Pressure => ("kPa", 1e3),
            Dimension::Moment => ("kN m/m", 1e3),
            Dimension::UnitWeight => ("kN/m³", 1e3),
            Dimension::Stiffness => ("MN/m³", 1e6),
            Dimension::Angle => ("mrad", 1e-3),
            Dimension::Inertia => ("t m²/m", 1e3),
            Dimension::Density => ("kg/m³", 1.0),
            Dimension::Acceleration => ("m/s²", 1.0),
            Dimension::Length => ("m", 1.0),
            Dimension::Time => ("s", 1.0),
            Dimension::WholeMass => ("kg", 1.0),
            Dimension::WholeForce => ("kN", 1e3),
            Dimension::WholeInertia => ("kg m²", 1.0),
            Dimension::WholeMoment => ("kN m", 1e3),
        }
    }

    /// A value as people read it.
    pub fn written(self, si: f64) -> String {
        let (unit, scale) = self.on_paper();
        format!("{} {unit}", digits(si / scale))
    }

    /// The units understood, e.g. `mm, cm, m, ft or in`.
    pub fn understood(self) -> String {
        let names: Vec<_> = self.names().collect();
        match names.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
            _ => names.concat(),
        }
    }

    /// The SI value of a text such as "450 kN/m".
    ///
    /// # Errors
    /// If the text does not begin with a number, or its unit is missing or does not fit.
    pub fn parse(self, text: &str) -> Result<f64, UnitError> {
        let (value, unit) = self.split(text)?;
        Ok(unit.si(value))
    }

    /// The number of a text such as "450 kN/m", and its unit.
    pub fn split(self, text: &str) -> Result<(f64, Unit), UnitError> {
        let (value, unit) = split(text.trim()).ok_or(UnitError::Number)?;
        if unit.is_empty() {
            return Err(UnitError::Missing);
        }
        if unit.starts_with(|c: char| c == ',' || c.is_ascii_digit()) {
            return Err(UnitError::Separator);
        }
        let known = self.unit(unit).ok_or_else(|| UnitError::Unknown(unit.to_owned()))?;
        Ok((value, known))
    }

    /// The unit of a name, where it fits, to show numbers in.
    pub(crate) fn shown_unit(self, name: &str) -> Option<ShownUnit> {
        let name = self.names().find(|known| *known == name)?;
        Some(ShownUnit { name, of: ShownScale::Unit(self.unit(name)?) })
    }

    /// The unit of a name by its name with powers raised.
    pub(crate) fn shown_raised(self, name: &str) -> Option<ShownUnit> {
        self.shown_unit(&raised(&name.replace('^', ""))).or_else(|| self.shown_unit(name))
    }

    /// The unit in which people read it.
    pub fn shown_on_paper(self) -> ShownUnit {
        let name = self.on_paper().0;
        self.shown_unit(name).unwrap_or_else(|| self.shown_in_si())
    }

    /// The unit of plain numbers.
    pub fn shown_in_si(self) -> ShownUnit {
        ShownUnit { name: self.si(), of: ShownScale::Unit(Unit::of_power(0)) }
    }

    /// The names of its units.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let of_si = self.units().iter().map(|(name, _)| *name);
        of_si.chain(self.others().iter().map(|(name, _)| *name))
    }

    /// The unit of a name, where it fits.
    pub fn unit(self, name: &str) -> Option<Unit> {
        let of_si = self.units().iter().find(|(known, _)| *known == name);
        let other = || self.others().iter().find(|(known, _)| *known == name);
        match of_si {
            Some((_, power)) => Some(Unit::of_power(*power)),
            None => other().map(|(_, factor)| Unit::of_factor(*factor)),
        }
    }
}

/// The name of a unit with powers raised.
fn raised(name: &str) -> String {
    name.replace("m2", "m²").replace("m3", "m³").replace("s2", "s²")
}

/// The unit that counts the acceleration of gravity.
pub const GRAVITY_UNIT: &str = "g";

/// The multiple of the acceleration of gravity that a text such as "0.25 g" says.
pub fn in_gravity(text: &str) -> Option<f64> {
    split(text.trim()).filter(|(_, unit)| *unit == GRAVITY_UNIT).map(|(share, _)| share)
}

/// Reason why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum UnitError {
    /// There is no number at its beginning.
    #[error("it does not begin with a number")]
    Number,
    /// A comma follows the number, or a space and more digits.
    #[error("it has a comma or a space among its digits; write 2.5, not 2,5, and 2700, not 2 700")]
    Separator,
    /// There is a number only.
    #[error("it has no unit")]
    Missing,
    /// The unit is unknown, or that of another quantity.
    #[error("the unit `{}` does not fit", shortened(.0))]
    Unknown(String),
}

/// The longest number at the beginning of `text`, and what follows it.
fn split(text: &str) -> Option<(f64, &str)> {
    let (number, rest) = split_text(text)?;
    Some((number_of(number)?, rest.trim_start()))
}

/// The number that a text is; its minus sign may be the one that answers are written with.
pub fn number_of(text: &str) -> Option<f64> {
    match text.strip_prefix('−') {
        Some(size) if size.starts_with(|c: char| c.is_ascii_digit() || c == '.') => {
            size.parse::<f64>().ok().map(|size| -size)
        }
        Some(_) => None,
        None => text.parse().ok(),
    }
}

/// The text of the longest number at the beginning of `text`, and what follows it.
pub fn split_text(text: &str) -> Option<(&str, &str)> {
    // Only these, so that Rust's "inf", "nan" and "infinity" are not numbers.
    let end = text
        .find(|c: char| !matches!(c, '0'..='9' | '+' | '-' | '−' | '.' | 'e' | 'E'))
        .unwrap_or(text.len());
    let is_number = |end: &usize| text.get(..*end).and_then(number_of).is_some();
    (1..=end).rev().find(is_number).map(|end| text.split_at(end))
}

#[cfg(test)]
mod tests {
    use super::{Dimension, Extent, UnitError, in_gravity};

    #[test]
    fn multiples_of_gravity() {
        for (text, share) in [("0.25 g", 0.25), (" -1e-1g ", -0.1), ("1 g", 1.0)] {
            assert_eq!(in_gravity(text), Some(share), "{text}");
        }
        for text in ["0.25", "g", "0.25 gal", "0.25 m/s2", "0,25 g"] {
            assert_eq!(in_gravity(text), None, "{text}");
        }
    }

    #[test]
    fn units_convert() {
        let cases = [
            (Dimension::Length, "15 m", 15.0),
            (Dimension::Length, "123 mm", 0.123),
            (Dimension::Length, "15cm", 0.15),
            (Dimension::Mass, "370 t/m", 370e3),
            (Dimension::Mass, "1 kg/m", 1.0),
            (Dimension::Density, "2.1 t/m³", 2100.0),
            (Dimension::Density, "2400 kg/m3", 2400.0),
            (Dimension::Force, "450 kN/m", 450e3),
            (Dimension::Force, "4.5e2 kN/m", 450e3),
            (Dimension::Force, " -1.5 MN/m ", -1.5e6),
            (Dimension::Force, "−1.5 MN/m", -1.5e6),
            (Dimension::Force, "7 N/m", 7.0),
            (Dimension::Acceleration, "9.81 m/s2", 9.81),
            (Dimension::Acceleration, "9.81 m/s²", 9.81),
            (Dimension::Inertia, "9500 t m2/m", 9.5e6),
            (Dimension::Pressure, "65.7 kPa", 65.7e3),
            (Dimension::Pressure, "65.7 kN/m2", 65.7e3),
            (Dimension::Time, "11.4 s", 11.4),
            (Dimension::Pressure, "3 MPa", 3e6),
            (Dimension::UnitWeight, "10 kN/m³", 10e3),
            (Dimension::Stiffness, "50 MN/m3", 50e6),
            (Dimension::Angle, "2 mrad", 2e-3),
            (Dimension::Pressure, "0.3 N/mm2", 0.3e6),
            (Dimension::Pressure, "2 MN/m2", 2e6),
            (Dimension::Pressure, "65.7 kN/m^2", 65.7e3),
            (Dimension::Pressure, "2 bar", 2e5),
            (Dimension::UnitWeight, "18 kN/m^3", 18e3),
            (Dimension::Acceleration, "250 Gal", 2.5),
            (Dimension::Time, "250 ms", 0.25),
            (Dimension::Length, "3 ft", 0.9144),
            (Dimension::Length, "10 in", 0.254),
            (Dimension::Force, "2 tf/m", 19613.3),
            (Dimension::WholeForce, "3 kgf", 29.41995),
            (Dimension::Pressure, "1 kgf/cm2", 98066.5),
        ];
        for (quantity, text, expected) in cases {
            assert_eq!(quantity.parse(text), Ok(expected), "{text}");
        }
    }

    /// Units of other systems, by their definitions as they are printed in tables.
    #[test]
    fn other_units_have_their_printed_size() {
        for (quantity, text, expected) in [
            (Dimension::WholeForce, "1 lbf", 4.448_221_615_260_5),
            (Dimension::Force, "1 kip/ft", 14_593.902_937),
            (Dimension::Pressure, "1 psf", 47.880_258_980_4),
            (Dimension::Pressure, "1 ksf", 47_880.258_980_4),
            (Dimension::Pressure, "1 psi", 6_894.757_293),
            (Dimension::UnitWeight, "1 pcf", 157.087_463_846),
            (Dimension::Density, "1 pcf", 16.018_463_374_0),
            (Dimension::WholeMass, "1 slug", 14.593_902_94),
            (Dimension::WholeMoment, "1 kip ft", 1_355.817_948),
            (Dimension::Angle, "180 deg", std::f64::consts::PI),
        ] {
            let found: f64 = quantity.parse(text).unwrap();
            assert!((found / expected - 1.0).abs() < 3e-10, "{text}: {found}");
            let unit = quantity.unit(text.split_once(' ').unwrap().1).unwrap();
            // To fifteen digits.
            assert!((unit.of_si(unit.si(2.5)) - 2.5).abs() < 1e-13, "{text}");
        }
    }

    /// Units on paper are understood, each with its size.
    #[test]
    fn units_on_paper_are_understood() {
        use Dimension::{
            Acceleration, Angle, Density, Force, Inertia, Length, Mass, Moment, Pressure, Stiffness, Time,
            UnitWeight,
        };
        let per_metre = [
            Length,
            Mass,
            Density,
            Force,
            Acceleration,
            Inertia,
            Pressure,
            Time,
            Moment,
            UnitWeight,
            Stiffness,
            Angle,
        ];
        for dimension in per_metre.into_iter().chain(per_metre.map(|dimension| Extent::Whole.of(dimension))) {
            let (unit, scale) = dimension.on_paper();
            assert_eq!(dimension.parse(&format!("1 {unit}")), Ok(scale), "{unit}");
        }
    }

    /// Units that answers may be written in have a name with powers raised, of the same size.
    #[test]
    fn units_of_answers_have_raised_names() {
        for dimension in [Dimension::Force, Dimension::WholeForce, Dimension::Pressure, Dimension::Length] {
            for name in dimension.names() {
                let (shown, unit) = (dimension.shown_raised(name).unwrap(), dimension.unit(name).unwrap());
                assert!(!shown.name().contains(['2', '3', '^']), "{name}: {}", shown.name());
                assert_eq!(shown.in_si(1.0), unit.si(1.0), "{name}");
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_an_error() {
        let unknown = |unit: &str| UnitError::Unknown(unit.to_owned());
        let cases = [
            (Dimension::Force, "450 kN", unknown("kN")),
            (Dimension::Length, "15 kg", unknown("kg")),
            (Dimension::Length, "15 M", unknown("M")),
            (Dimension::Length, "15", UnitError::Missing),
            (Dimension::Stiffness, "50", UnitError::Missing),
            (Dimension::Stiffness, "50 MPa", unknown("MPa")),
            (Dimension::Length, "m", UnitError::Number),
            (Dimension::Length, "", UnitError::Number),
            (Dimension::Length, "inf m", UnitError::Number),
            (Dimension::Length, "NaN m", UnitError::Number),
            (Dimension::Length, "1,5 m", UnitError::Separator),
            (Dimension::Force, "2 700 kN/m", UnitError::Separator),
            (Dimension::Force, "2,700 kN/m", UnitError::Separator),
            (Dimension::Length, "1.5.2 m", unknown(".2 m")),
            (Dimension::Length, "−−1 m", UnitError::Number),
            (Dimension::Length, "−+1 m", UnitError::Number),
        ];
        for (quantity, text, expected) in cases {
            assert_eq!(quantity.parse(text), Err(expected), "{text}");
        }
    }
}
