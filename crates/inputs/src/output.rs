//! Units and digits in which answers are written: those of `[output]`, else the ones in which people read them.

use standfast::number;

use crate::digits::{factor_in, significant};
use crate::units::{Dimension, Extent, ShownUnit};

/// Significant digits of numbers in text where the case asks for no other.
const DIGITS: usize = 4;

/// Units and digits in which the answers of a case are written. It goes along with every criterion and is small: units are places among
/// the [names](Dimension::names) of their dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutputUnits {
    extent: Extent,
    force: Option<u8>,
    pressure: Option<u8>,
    length: Option<u8>,
    digits: Option<u8>,
}

impl From<Extent> for OutputUnits {
    /// The units in which people read the quantities of a case of this extent.
    fn from(extent: Extent) -> OutputUnits {
        OutputUnits { extent, force: None, pressure: None, length: None, digits: None }
    }
}

impl OutputUnits {
    /// With the units of these names, where a case of its extent has them, and so many digits.
    pub(crate) fn with(self, named: [Option<&str>; 3], digits: Option<usize>) -> OutputUnits {
        let place = |dimension, name: Option<&str>| {
            let dimension = self.extent.of(dimension);
            let shown = dimension.shown_raised(name?)?;
            dimension
                .names()
                .position(|known| known == shown.name())
                .and_then(|place| u8::try_from(place).ok())
        };
        let [force, pressure, length] = named;
        OutputUnits {
            force: place(Dimension::Force, force),
            pressure: place(Dimension::Pressure, pressure),
            length: place(Dimension::Length, length),
            digits: digits.and_then(|digits| u8::try_from(digits).ok()),
            ..self
        }
    }

    /// Extent of forces, masses and moments.
    pub fn extent(self) -> Extent {
        self.extent
    }

    /// The unit of a quantity, of the whole body or per metre run as the case has it. That of moments goes with that of forces.
    pub fn unit(self, dimension: Dimension) -> ShownUnit {
        let named = |dimension, place: Option<u8>| {
            let dimension = self.extent.of(dimension);
            dimension.names().nth(usize::from(place?)).and_then(|name| dimension.shown_unit(name))
        };
        let asked = match dimension {
            Dimension::Force | Dimension::WholeForce => named(Dimension::Force, self.force),
            Dimension::Moment | Dimension::WholeMoment => {
                named(Dimension::Force, self.force).and_then(ShownUnit::of_moments)
            }
            Dimension::Pressure => named(dimension, self.pressure),
            Dimension::Length => named(dimension, self.length),
            _ => None,
        };
        asked.unwrap_or_else(|| self.extent.of(dimension).shown_on_paper())
    }

    /// The name of that unit, for reading.
    pub fn symbol(self, dimension: Dimension) -> String {
        self.unit(dimension).symbol()
    }

    /// An SI value in its unit, without the unit.
    pub fn value(self, dimension: Dimension, si: f64) -> String {
        self.number(self.unit(dimension).of_si(si))
    }

    /// An SI value with its unit.
    pub fn written(self, dimension: Dimension, si: f64) -> String {
        let unit = self.unit(dimension);
        format!("{} {}", self.number(unit.of_si(si)), unit.symbol())
    }

    /// A number without unit.
    pub fn number(self, x: f64) -> String {
        significant(x, self.count())
    }

    /// A number that somebody asks for: in six digits at least, so that no rounding changes it.
    pub fn bound(self, x: f64) -> String {
        significant(x, self.count().max(6))
    }

    /// A factor that is compared with 1, in more digits where it takes them to tell it from 1.
    pub fn factor(self, x: f64) -> String {
        factor_in(x, self.count())
    }

    /// A number that is compared with another, in more digits where it takes them to tell it from that.
    pub fn apart(self, x: f64, other: f64) -> String {
        number::apart(x, other, self.count()).to_string()
    }

    /// A factor that is compared with another, in more digits where it takes them to tell it from that.
    pub fn beside(self, x: f64, other: f64) -> String {
        number::beside(x, other, self.count()).to_string()
    }

    /// Digits that the case asks for.
    pub fn digits(self) -> Option<usize> {
        self.digits.map(usize::from)
    }

    fn count(self) -> usize {
        self.digits().unwrap_or(DIGITS)
    }

    /// A length, m.
    pub fn length(self, si: f64) -> String {
        self.written(Dimension::Length, si)
    }

    /// A force, N or N/m.
    pub fn force(self, si: f64) -> String {
        self.written(Dimension::Force, si)
    }

    /// A moment, N m or N m/m.
    pub fn moment(self, si: f64) -> String {
        self.written(Dimension::Moment, si)
    }

    /// A pressure, Pa.
    pub fn pressure(self, si: f64) -> String {
        self.written(Dimension::Pressure, si)
    }

    /// A mass, in t per metre run or in kg.
    pub fn mass(self, si: f64) -> String {
        self.written(Dimension::Mass, si)
    }

    /// A moment of inertia, in t m² per metre run or in kg m².
    pub fn inertia(self, si: f64) -> String {
        self.written(Dimension::Inertia, si)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of every unit of forces there is one of moments, whose size is that of the force times the length that it has.
    #[test]
    fn moments_go_with_forces() {
        for extent in [Extent::PerMetre, Extent::Whole] {
            for name in extent.of(Dimension::Force).names() {
                let units = OutputUnits::from(extent).with([Some(name), None, None], Some(6));
                let moment = units.unit(Dimension::Moment);
                let arm = if name.contains("lbf") || name.contains("kip") { 0.3048 } else { 1.0 };
                let expected = units.unit(Dimension::Force).of_si(1.0) / arm;
                assert!((moment.of_si(1.0) / expected - 1.0).abs() < 1e-12, "{name}: {moment:?}");
                assert!(moment.name().starts_with(name.split('/').next().unwrap()), "{name}: {moment:?}");
            }
        }
    }

    #[test]
    fn numbers_are_written_in_the_units_asked_for() {
        let metric = OutputUnits::from(Extent::PerMetre);
        assert_eq!(metric.force(231_840.12), "231.8 kN/m");
        let other = metric.with([Some("tf/m"), Some("kgf/cm2"), Some("cm")], Some(5));
        assert_eq!(other.force(9_806.65), "1 tf/m");
        assert_eq!(other.moment(19_613.3), "2 tf m/m");
        assert_eq!(other.pressure(98_066.5 * 2.345_678), "2.3457 kgf/cm²");
        assert_eq!(other.length(0.123_456), "12.346 cm");
        assert_eq!(other.mass(370e3), "370 t/m");
        // A unit of the whole object is none of a case per metre run.
        assert_eq!(metric.with([Some("kN"), None, None], None).force(1e3), "1 kN/m");
    }
}
