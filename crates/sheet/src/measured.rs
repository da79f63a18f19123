//! Numbers with their units, and how they are shown.

use maud::{Markup, PreEscaped, html};
use standfast::number::{Significant, significant};
use standfast_cases::units::{Dimension, Extent};

/// Significant digits in the calculation, enough to follow it by hand.
const DIGITS: usize = 5;

/// A unit, and how many SI units make one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// As it is printed.
    pub text: &'static str,
    /// In SI units.
    pub si: f64,
    /// Dimension, where the unit is that of a quantity of case files.
    dimension: Option<Dimension>,
}

impl Unit {
    /// That in which people read a quantity of case files.
    const fn of(dimension: Dimension) -> Unit {
        let (text, si) = dimension.on_paper();
        Unit { text, si, dimension: Some(dimension) }
    }

    /// One of what no case file gives.
    const fn other(text: &'static str) -> Unit {
        Unit { text, si: 1.0, dimension: None }
    }
}

macro_rules! units {
    ($($name:ident = $unit:expr;)*) => {
        $(#[doc = concat!("`", stringify!($unit), "`")] pub const $name: Unit = $unit;)*
    };
}

units! {
    NONE = Unit::other("");
    DEGREE = Unit::other("°");
    AREA = Unit::other("m²");
    ROTATION = Unit::other("rad/s²");
    METRE = Unit::of(Dimension::Length);
    SECOND = Unit::of(Dimension::Time);
    MASS = Unit::of(Dimension::Mass);
    KILONEWTON = Unit::of(Dimension::Force);
    MOMENT = Unit::of(Dimension::Moment);
    INERTIA = Unit::of(Dimension::Inertia);
    KILOPASCAL = Unit::of(Dimension::Pressure);
    DENSITY = Unit::of(Dimension::Density);
    UNIT_WEIGHT = Unit::of(Dimension::UnitWeight);
    STIFFNESS = Unit::of(Dimension::Stiffness);
    MRAD = Unit::of(Dimension::Angle);
    SPRING = Unit::other("N/m²");
    SPRING_OF_OBJECT = Unit::other("N/m");
    TURNING = Unit::other("N");
    TURNING_OF_OBJECT = Unit::other("N m");
    PER_SECOND = Unit::other("1/s");
    SQUARE = Unit::other("1/s²");
    FOURTH = Unit::other("1/s⁴");
    ACCELERATION = Unit::of(Dimension::Acceleration);
}

/// A number in the unit it is shown in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// In `unit`.
    pub value: f64,
    /// Unit that the number is shown in.
    pub unit: Unit,
}

impl Measured {
    /// A value of the library, in SI units; an angle in degrees.
    pub fn of(si: f64, unit: Unit) -> Measured {
        // `+ 0.0` turns −0 into 0.
        Measured { value: si / unit.si + 0.0, unit }
    }

    /// Converts to the unit of a case of this extent, where forces and masses are per metre run or of the whole.
    pub fn in_extent(self, extent: Extent) -> Measured {
        let Some(dimension) = self.unit.dimension else { return self };
        let unit = Unit::of(extent.of(dimension));
        Measured { value: self.value * (self.unit.si / unit.si), unit }
    }

    /// The number at full precision for machines, rounded for people, with its unit. `name` says which number of the case it
    /// is, as the program's JSON calls it.
    pub fn html(&self, name: &str) -> Markup {
        html! {
            data value=(self.value) data-quantity=[(!name.is_empty()).then_some(name)] { (number(self.value)) }
            (self.unit_html())
        }
    }

    /// The unit behind a number.
    pub fn unit_html(&self) -> Markup {
        html! {
            @if self.unit.text == "°" { "°" }
            @else if !self.unit.text.is_empty() { "\u{a0}" span.unit { (no_break(self.unit.text)) } }
        }
    }

    /// The number and its unit in MathML; negative numbers in parentheses unless they stand alone.
    pub fn mathml(&self, alone: bool) -> String {
        let value = self.value;
        let Significant { mantissa, exponent } = significant(value.abs(), DIGITS);
        let digits = match exponent {
            None => format!("<mn data-value=\"{}\">{mantissa}</mn>", value.abs()),
            Some(exponent) => format!(
                "<mrow data-value=\"{}\"><mn>{mantissa}</mn><mo>⋅</mo><msup><mn>10</mn><mn>{}</mn></msup></mrow>",
                value.abs(),
                exponent.to_string().replace('-', "−"),
            ),
        };
        let unit = match self.unit.text {
            "" => String::new(),
            "°" => "<mtext>°</mtext>".to_owned(),
            unit => format!("<mtext>\u{a0}{}</mtext>", no_break(unit)),
        };
        match (value < 0.0, alone) {
            (false, _) => format!("<mrow>{digits}{unit}</mrow>"),
            (true, true) => format!("<mrow><mo form=\"prefix\">−</mo>{digits}{unit}</mrow>"),
            (true, false) => {
                format!("<mrow><mo>(</mo><mo form=\"prefix\">−</mo>{digits}{unit}<mo>)</mo></mrow>")
            }
        }
    }
}

fn no_break(text: &str) -> String {
    text.replace(' ', "\u{202f}")
}

/// A number as text: a true minus sign, powers of ten written out.
pub fn number(x: f64) -> Markup {
    if x == f64::INFINITY {
        return html! { "unlimited" };
    }
    let Significant { mantissa, exponent } = significant(x, DIGITS);
    let text = match exponent {
        None => mantissa,
        Some(exponent) => format!("{mantissa}·10<sup>{exponent}</sup>"),
    };
    PreEscaped(text.replace('-', "−"))
}
