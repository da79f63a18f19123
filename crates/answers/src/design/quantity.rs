//! Between which values is a quantity of a case varied?

use super::DesignError;
use crate::case::Case;
use crate::couple::Variable;
use crate::digits::significant;
use crate::error::Problem;
use crate::inputs::Inputs;

/// Number of digits where nothing asks for more.
pub const DIGITS: usize = 4;

/// A quantity that is varied.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// The number of the case.
    pub variable: Variable,
    /// Its present value, SI.
    pub present: f64,
    /// The least and the greatest value tried, SI.
    pub range: [f64; 2],
}

/// Ends of a range, as a user gives them.
pub(super) struct Ends<'a> {
    /// The options, lower end first.
    pub(super) options: [&'static str; 2],
    /// Text that stands there.
    pub(super) written: [Option<&'a str>; 2],
    /// Ratio of the upper end of the range to the present value, and of that to the lower end, where nothing stands there; no farther than
    /// the quantity can have.
    pub(super) spread: f64,
}

impl Quantity {
    pub(super) fn of(
        name: &str,
        inputs: &Inputs,
        case: &Case,
        ends: &Ends<'_>,
    ) -> Result<Quantity, DesignError> {
        let variable = Variable::find(name, inputs).map_err(DesignError::UnknownVariable)?;
        let present = variable.value(inputs, case);
        // No farther than the key takes numbers.
        let [least, greatest] = variable.range().ends();
        let [low, high] =
            [present / ends.spread, present * ends.spread].map(|end| end.clamp(least, greatest));
        let end = |which: usize, default: f64| match ends.written[which] {
            None => Ok(default),
            Some(written) => read(&variable, inputs, ends.options[which], written),
        };
        let range = [end(0, low.min(high))?, end(1, low.max(high))?];
        if range[0] < range[1] {
            return Ok(Quantity { variable, present, range });
        }
        let quantity = Quantity { variable, present, range };
        Err(DesignError::EmptyBracket { range: quantity.range_words(), options: ends.options })
    }

    /// Its range: "from 1 m to 5 m".
    pub fn range_words(&self) -> String {
        let [from, to] = self.range.map(|value| self.shown(value));
        format!("from {from} to {to}")
    }

    /// Its name and its range: "width is from 1 m to 5 m".
    pub(super) fn in_range_words(&self) -> String {
        format!("{} is {}", self.variable.name(), self.range_words())
    }

    /// A number in the unit that is shown, in SI units.
    pub(super) fn in_si(&self, shown: f64) -> f64 {
        self.variable.shown_unit().map_or(shown, |unit| unit.in_si(shown))
    }

    /// A value in the unit that is shown.
    pub(super) fn of_si(&self, si: f64) -> f64 {
        self.variable.shown_unit().map_or(si, |unit| unit.of_si(si))
    }

    /// A value of the case with its unit, to the digits that are given of most.
    pub fn shown(&self, value: f64) -> String {
        with_unit(value, &self.variable, GIVEN)
    }
}

/// Significant digits that few numbers of a case have more of.
const GIVEN: usize = 6;

/// A value in the unit of the file, in so many significant digits.
pub fn with_unit(value: f64, variable: &Variable, count: usize) -> String {
    match variable.shown_unit() {
        Some(unit) => format!("{} {}", significant(unit.of_si(value), count), unit.symbol()),
        None => significant(value, count),
    }
}

/// An end of a range, read as the case file reads the quantity. Zero is where a range may begin even if no value may be zero.
fn read(
    variable: &Variable,
    inputs: &Inputs,
    option: &'static str,
    written: &str,
) -> Result<f64, DesignError> {
    let value = variable.read(written, inputs).map_err(|problem| DesignError::Bracket {
        option,
        written: written.to_owned(),
        fault: fault(&problem),
        expected: expected(variable),
    })?;
    let range = variable.range();
    if value == 0.0 || range.contains(value) {
        return Ok(value);
    }
    Err(DesignError::Impossible {
        option,
        written: written.to_owned(),
        name: variable.name().to_owned(),
        expected: range.words(),
    })
}

/// Fault of a text at an option.
pub(super) fn fault(problem: &Problem) -> String {
    match problem {
        Problem::Unit { error, .. } => error.to_string(),
        Problem::WrongType { found, expected, .. } => format!("it is {found}; expected {expected}"),
        Problem::OutOfRange { expected, .. } => format!("expected {expected}"),
        other => other.to_string(),
    }
}

fn expected(variable: &Variable) -> String {
    match (variable.id().key.info().kind, variable.dimension()) {
        (kind, Some(dimension)) if kind.is_of_shaking() => {
            format!("expected a number with its unit, as \"0.2 g\": g, {}", dimension.understood())
        }
        (_, Some(dimension)) => {
            format!("expected a number in SI units, or with a unit: {}", dimension.understood())
        }
        (_, None) => "expected a number without unit".to_owned(),
    }
}
