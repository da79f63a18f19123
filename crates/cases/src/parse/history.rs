//! What a `history` says: a shape with its numbers, in braces.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{At, Field, plain_number};
use crate::error::Problem;
use crate::error::expected_type;
use crate::history::{Course, TimeShape};
use crate::key::{Kind, Range};
use crate::suggest::closest;
use crate::units::Dimension;

/// A `history` as it stands in a file.
struct Written<'a> {
    field: &'a Field<'a>,
    table: &'a DeTable<'a>,
    shape: &'static str,
}

impl Field<'_> {
    /// How a load varies in time.
    pub(super) fn history(&self) -> Result<TimeShape, At> {
        let table = self.value.get_ref().as_table();
        let table = table.ok_or_else(|| self.wrong_type(expected_type(Kind::History)))?;
        let names = || Course::NAMES.iter().map(|(name, _)| *name);
        let found = table.get("shape").ok_or_else(|| self.lacks("shape", "shape = \"triangle\""))?;
        let word = found.get_ref().as_str().unwrap_or_default();
        let Some((shape, takes)) = Course::NAMES.iter().find(|(name, _)| *name == word) else {
            let problem =
                Problem::HistoryShape { written: self.written(found), suggestion: closest(word, names()) };
            return Err(At { problem, span: found.span() });
        };
        let known = |name: &str| ["shape", "peak", "start"].contains(&name) || takes.contains(&name);
        if let Some(key) = table.keys().filter(|key| !known(key.get_ref())).min_by_key(|key| key.span().start)
        {
            let name: &str = key.get_ref();
            let problem = Problem::HistoryKey { shape, name: name.to_owned(), takes };
            return Err(At { problem, span: key.span() });
        }
        Written { field: self, table, shape }.read()
    }

    fn lacks(&self, name: &'static str, example: &'static str) -> At {
        self.problem(Problem::HistoryLacks { name, example })
    }
}

impl Written<'_> {
    fn read(&self) -> Result<TimeShape, At> {
        let seconds = |name| self.number(name, Some(Dimension::Time), Range::Positive);
        let rise = || self.number("rise", Some(Dimension::Time), Range::NotNegative);
        let or = |name, dimension, range, otherwise| match self.table.get(name) {
            Some(_) => self.number(name, dimension, range),
            None => Ok(otherwise),
        };
        let peak = or("peak", None, Range::Finite, 1.0)?;
        let start = or("start", Some(Dimension::Time), Range::NotNegative, 0.0)?;
        let course = match self.shape {
            "constant" => Course::Constant,
            "rect" => Course::Rect { duration: seconds("duration")? },
            "triangle" => {
                let (rise, duration) = (rise()?, seconds("duration")?);
                self.in_order(rise, "duration", duration, "no less than `rise`")?;
                Course::Triangle { rise, duration }
            }
            "decay" => Course::Decay { duration: seconds("duration")? },
            "church-roof" => {
                let (rise, impact_duration) = (rise()?, seconds("impact_duration")?);
                self.in_order(rise, "impact_duration", impact_duration, "no less than `rise`")?;
                let tail = or("tail", None, Range::Finite, 0.0)?;
                if !(0.0..=peak.abs()).contains(&(tail * peak.signum())) {
                    return Err(self.wrong("tail", self.found("tail")?, "a number from zero to `peak`"));
                }
                let duration = seconds("duration")?;
                self.in_order(impact_duration, "duration", duration, "no less than `impact_duration`")?;
                Course::ChurchRoof { rise, impact_duration, tail, duration }
            }
            _ => Course::Points { points: self.points()? },
        };
        Ok(TimeShape { course, peak, start })
    }

    fn in_order(
        &self,
        before: f64,
        name: &'static str,
        value: f64,
        expected: &'static str,
    ) -> Result<(), At> {
        if value >= before && value > 0.0 {
            return Ok(());
        }
        let found = self.found(name)?;
        Err(self.wrong(name, found, expected))
    }

    fn found(&self, name: &'static str) -> Result<&Spanned<DeValue<'_>>, At> {
        let example = match name {
            "duration" => "duration = \"0.1 s\"",
            "rise" => "rise = \"0.05 s\"",
            "impact_duration" => "impact_duration = \"0.2 s\"",
            "tail" => "tail = 0.4",
            "times" => "times = [0, 0.05, 0.1]",
            _ => "values = [0, 1, 0]",
        };
        self.table.get(name).ok_or_else(|| self.field.lacks(name, example))
    }

    fn wrong(&self, name: &'static str, found: &Spanned<DeValue<'_>>, expected: &'static str) -> At {
        let problem = Problem::HistoryValue { name, written: self.field.written(found), expected };
        At { problem, span: found.span() }
    }

    /// A number of the shape, with its unit if it has one.
    fn number(&self, name: &'static str, dimension: Option<Dimension>, range: Range) -> Result<f64, At> {
        let found = self.found(name)?;
        self.value(name, found, dimension, range)
    }

    fn value(
        &self,
        name: &'static str,
        found: &Spanned<DeValue<'_>>,
        dimension: Option<Dimension>,
        range: Range,
    ) -> Result<f64, At> {
        let text = || found.get_ref().as_str().zip(dimension);
        let number =
            plain_number(found.get_ref()).or_else(|| text().and_then(|(text, of)| of.parse(text).ok()));
        let expected = match dimension {
            Some(_) => "a time in s",
            None => "a number without unit",
        };
        let number = number.ok_or_else(|| self.wrong(name, found, expected))?;
        if range.contains(number) { Ok(number + 0.0) } else { Err(self.wrong(name, found, range.words())) }
    }

    /// Moments that do not fall, and as many shares.
    fn points(&self) -> Result<Vec<[f64; 2]>, At> {
        let list = |name: &'static str, dimension, range| {
            let found = self.found(name)?;
            let list = found.get_ref().as_array().filter(|list| !list.is_empty());
            let list = list.ok_or_else(|| self.wrong(name, found, "a list of numbers"))?;
            list.iter()
                .map(|element| self.value(name, element, dimension, range))
                .collect::<Result<Vec<f64>, At>>()
        };
        let times = list("times", Some(Dimension::Time), Range::NotNegative)?;
        let values = list("values", None, Range::Finite)?;
        if times.len() != values.len() {
            return Err(self.wrong("values", self.found("values")?, "as many numbers as `times` has"));
        }
        if times.len() < 2 {
            return Err(self.wrong("times", self.found("times")?, "two moments or more"));
        }
        if times.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err(self.wrong("times", self.found("times")?, "times that do not fall"));
        }
        Ok(times.into_iter().zip(values).map(|(time, value)| [time, value]).collect())
    }
}
