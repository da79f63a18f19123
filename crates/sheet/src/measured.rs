//! Numbers with their units, and how they are shown.

use maud::{Markup, PreEscaped, html};
use standfast::number::{Significant, apart, beside, significant};
use standfast_cases::OutputUnits;
use standfast_cases::units::Dimension;

/// Significant digits in the calculation where the case asks for no other, enough to follow it by hand.
const DIGITS: usize = 5;

/// A unit, and how many SI units make one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetUnit {
    /// As it is printed.
    pub text: &'static str,
    /// In SI units.
    pub si: f64,
    /// Dimension, where the unit is that of a quantity of case files.
    dimension: Option<Dimension>,
    /// True of a factor, which is compared with 1.
    is_factor: bool,
}

impl SheetUnit {
    /// That in which people read a quantity of case files.
    pub const fn of(dimension: Dimension) -> SheetUnit {
        let (text, si) = dimension.on_paper();
        SheetUnit { text, si, dimension: Some(dimension), is_factor: false }
    }

    /// One of what no case file gives.
    const fn other(text: &'static str) -> SheetUnit {
        SheetUnit { text, si: 1.0, dimension: None, is_factor: false }
    }
}

macro_rules! units {
    ($($name:ident = $unit:expr;)*) => {
        $(#[doc = concat!("`", stringify!($unit), "`")] pub const $name: SheetUnit = $unit;)*
    };
}

units! {
    NONE = SheetUnit::other("");
    FACTOR = SheetUnit { is_factor: true, ..SheetUnit::other("") };
    DEGREE = SheetUnit::other("°");
    AREA = SheetUnit::other("m²");
    ROTATION = SheetUnit::other("rad/s²");
    METRE = SheetUnit::of(Dimension::Length);
    SECOND = SheetUnit::of(Dimension::Time);
    MASS = SheetUnit::of(Dimension::Mass);
    KILONEWTON = SheetUnit::of(Dimension::Force);
    MOMENT = SheetUnit::of(Dimension::Moment);
    INERTIA = SheetUnit::of(Dimension::Inertia);
    KILOPASCAL = SheetUnit::of(Dimension::Pressure);
    DENSITY = SheetUnit::of(Dimension::Density);
    UNIT_WEIGHT = SheetUnit::of(Dimension::UnitWeight);
    STIFFNESS = SheetUnit::of(Dimension::Stiffness);
    MRAD = SheetUnit::of(Dimension::Angle);
    SPRING = SheetUnit::other("N/m²");
    SPRING_OF_OBJECT = SheetUnit::other("N/m");
    TURNING = SheetUnit::other("N");
    TURNING_OF_OBJECT = SheetUnit::other("N m");
    FORCE_SQUARED = SheetUnit { si: 1e6, ..SheetUnit::other("kN²/m²") };
    FORCE_SQUARED_OF_OBJECT = SheetUnit { si: 1e6, ..SheetUnit::other("kN²") };
    PER_SECOND = SheetUnit::other("1/s");
    SQUARE = SheetUnit::other("1/s²");
    FOURTH = SheetUnit::other("1/s⁴");
    ACCELERATION = SheetUnit::of(Dimension::Acceleration);
}

/// A number in the unit it is shown in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// In `unit`.
    pub value: f64,
    /// Unit that the number is shown in.
    pub unit: SheetUnit,
    /// Significant digits that are shown.
    digits: usize,
}

impl Measured {
    /// A value of the library, in SI units; an angle in degrees.
    pub fn of(si: f64, unit: SheetUnit) -> Measured {
        // `+ 0.0` turns −0 into 0.
        Measured { value: si / unit.si + 0.0, unit, digits: DIGITS }
    }

    /// Converts to the unit in which a case is written, where forces and masses are per metre run or of the whole.
    pub fn in_output(self, output: OutputUnits) -> Measured {
        let digits = output.digits().unwrap_or(DIGITS);
        let Some(dimension) = self.unit.dimension else { return Measured { digits, ..self } };
        let shown = output.unit(dimension);
        let unit = SheetUnit { text: shown.name(), si: shown.in_si(1.0), ..self.unit };
        Measured { value: self.value * (self.unit.si / unit.si), unit, digits }
    }

    /// The number at full precision for machines, rounded for people, with its unit. `name` says which number of the case it
    /// is, as the program's JSON calls it.
    pub fn html(&self, name: &str) -> Markup {
        html! { (self.number_html(name)) (self.unit_html()) }
    }

    /// The number without its unit.
    pub fn number_html(&self, name: &str) -> Markup {
        html! { data value=(self.value) data-quantity=[(!name.is_empty()).then_some(name)] { (self.text()) } }
    }

    /// The digits shown.
    fn digits(&self) -> Significant {
        match self.unit.is_factor {
            true => beside(self.value, 1.0, self.digits),
            false => significant(self.value, self.digits),
        }
    }

    fn text(&self) -> Markup {
        if self.value == f64::INFINITY { number(self.value) } else { shown(self.digits()) }
    }

    /// Number of letters of the number with its unit.
    pub fn letters(&self) -> usize {
        let Significant { mantissa, exponent } = self.digits();
        let power = if exponent.is_some() { 5 } else { 0 };
        mantissa.chars().count() + power + 1 + self.unit.text.chars().count()
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
        let Significant { mantissa, exponent } = (Measured { value: value.abs(), ..*self }).digits();
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
    shown(significant(x, DIGITS))
}

/// The left and the right side of an inequality, in as many digits as tell them apart.
pub fn sides(left: f64, right: f64) -> [Markup; 2] {
    let one = |x: f64, other: f64| if x.is_finite() { shown(apart(x, other, DIGITS)) } else { number(x) };
    [one(left, right), one(right, left)]
}

fn shown(Significant { mantissa, exponent }: Significant) -> Markup {
    let text = match exponent {
        None => mantissa,
        Some(exponent) => format!("{mantissa}·10<sup>{exponent}</sup>"),
    };
    PreEscaped(text.replace('-', "−"))
}
