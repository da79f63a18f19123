//! A table of a case of motion, read key by key; what it does not have is refused.

use std::ops::Range as Span;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use standfast_motion::record::STANDARD_GRAVITY;

use super::error::Wrong;
use crate::layout::shortened;
use crate::parse::{plain_number, type_of};
use crate::suggest::closest;
use crate::units::{Dimension, Extent, in_gravity};

/// A table with its name, as errors call it, and its place.
pub(crate) struct Section<'a> {
    pub name: String,
    table: &'a DeTable<'a>,
    pub span: Span<usize>,
    text: &'a str,
    units: Units,
    /// The force of the load that it is the history of, and what that is of.
    force: Option<(f64, Extent)>,
}

/// Whether texts with units are numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Units {
    /// Lengths, times and accelerations as they come.
    None,
    /// SI.
    Si,
    /// SI, and the peak a factor on a load's own force.
    SiOfLoad,
}

impl<'a> Section<'a> {
    /// A table that has only these keys.
    pub(crate) fn new(
        name: impl Into<String>,
        table: &'a DeTable<'a>,
        span: Span<usize>,
        text: &'a str,
        keys: &[&str],
    ) -> Result<Section<'a>, Wrong> {
        let name = name.into();
        let unknown = table.keys().filter(|key| !keys.contains(&key.get_ref().as_ref()));
        if let Some(key) = unknown.min_by_key(|key| key.span().start) {
            let found = key.get_ref().as_ref();
            let known = format!("the keys understood here: {}", keys.join(", "));
            let help = match closest(found, keys.iter().copied()) {
                Some(like) => format!("did you mean `{like}`? {known}"),
                None => known,
            };
            return Err(
                Wrong::new(format!("{name} has no key `{}`", shortened(found)), key.span()).help(help)
            );
        }
        Ok(Section { name, table, span, text, units: Units::None, force: None })
    }

    /// A table of which only some keys are read here.
    pub(crate) fn shared(
        name: &str,
        table: &'a DeTable<'a>,
        span: Span<usize>,
        text: &'a str,
    ) -> Section<'a> {
        Section { name: name.to_owned(), table, span, text, units: Units::None, force: None }
    }

    /// The same where quantities may have units.
    pub(crate) fn measured(self) -> Section<'a> {
        Section { units: Units::Si, ..self }
    }

    /// The same of the history of a load.
    pub(crate) fn of_load(self) -> Section<'a> {
        Section { units: Units::SiOfLoad, ..self }
    }

    /// The same of a load of this force.
    pub(crate) fn of_force(&self, force: f64, extent: Extent) -> Section<'a> {
        Section { force: Some((force, extent)), name: self.name.clone(), span: self.span.clone(), ..*self }
    }

    /// The force of the load that it is the history of, and what that is of.
    pub(crate) fn force(&self) -> Option<(f64, Extent)> {
        self.force
    }

    /// Whether numbers are in SI units.
    pub(crate) fn is_measured(&self) -> bool {
        self.units != Units::None
    }

    /// Whether it is the history of a load that has a force of its own.
    pub(crate) fn is_of_load(&self) -> bool {
        self.units == Units::SiOfLoad
    }

    /// What the number under a key measures, where it may have a unit.
    fn dimension(&self, key: &str) -> Option<Dimension> {
        match key {
            _ if self.units == Units::None => None,
            "start" | "duration" | "rise" | "period" | "impact_duration" | "times" | "dt" | "t_max" => {
                Some(Dimension::Time)
            }
            "peak" | "tail" | "target_peak" if self.units == Units::Si => Some(Dimension::Acceleration),
            "gap" | "slide" => Some(Dimension::Length),
            "theta" | "max_theta" | "phase" => Some(Dimension::Angle),
            _ => None,
        }
    }

    pub(crate) fn get(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }

    /// Where the value of a key stands; the table if it is not there.
    pub(crate) fn place(&self, key: &str) -> Span<usize> {
        self.get(key).map_or_else(|| self.span.clone(), Spanned::span)
    }

    pub(crate) fn lacks(&self, key: &str) -> Wrong {
        Wrong::new(format!("{} lacks `{key}`", self.name), self.span.clone())
    }

    fn wrong_type(&self, key: &str, value: &Spanned<DeValue<'_>>, expected: &str) -> Wrong {
        Wrong::new(format!("`{key}` is {}; expected {expected}", type_of(value.get_ref())), value.span())
    }

    fn finite(&self, key: &str, value: &Spanned<DeValue<'_>>, expected: &str) -> Result<f64, Wrong> {
        if let (Some(dimension), Some(written)) = (self.dimension(key), value.get_ref().as_str()) {
            if let (Dimension::Acceleration, Some(share)) = (dimension, in_gravity(written)) {
                return Ok(share * STANDARD_GRAVITY);
            }
            return dimension.parse(written).map_err(|error| {
                let (what, units) = (dimension.words(), dimension.understood());
                let message = format!("`{key}` is \"{}\", and {error}; expected {what}", shortened(written));
                Wrong::new(message, value.span()).help(format!("the units understood: {units}"))
            });
        }
        let number = plain_number(value.get_ref()).ok_or_else(|| self.wrong_type(key, value, expected))?;
        if number.is_finite() {
            return Ok(number + 0.0);
        }
        let written = shortened(self.text.get(value.span()).unwrap_or_default());
        Err(Wrong::new(format!("`{key}` is {written}; expected a finite number"), value.span()))
    }

    pub(crate) fn number(&self, key: &str) -> Result<Option<f64>, Wrong> {
        self.get(key).map(|value| self.finite(key, value, "a number without unit or quotes")).transpose()
    }

    pub(crate) fn needed(&self, key: &str) -> Result<f64, Wrong> {
        self.number(key)?.ok_or_else(|| self.lacks(key))
    }

    pub(crate) fn truth(&self, key: &str) -> Result<Option<bool>, Wrong> {
        let read = |value: &Spanned<DeValue<'_>>| {
            value.get_ref().as_bool().ok_or_else(|| self.wrong_type(key, value, "true or false"))
        };
        self.get(key).map(read).transpose()
    }

    pub(crate) fn words(&self, key: &str) -> Result<Option<&'a str>, Wrong> {
        let read = |value: &'a Spanned<DeValue<'a>>| {
            value.get_ref().as_str().ok_or_else(|| self.wrong_type(key, value, "a text in quotes"))
        };
        self.get(key).map(read).transpose()
    }

    /// One of some words.
    pub(crate) fn choice<T: Copy>(&self, key: &str, choices: &[(&str, T)]) -> Result<Option<T>, Wrong> {
        let Some(written) = self.words(key)? else { return Ok(None) };
        if let Some((_, choice)) = choices.iter().find(|(word, _)| *word == written) {
            return Ok(Some(*choice));
        }
        let words: Vec<String> = choices.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        let message = format!("`{key}` is \"{}\"; expected {}", shortened(written), words.join(", "));
        let wrong = Wrong::new(message, self.place(key));
        Err(match closest(written, choices.iter().map(|(word, _)| *word)) {
            Some(like) => wrong.help(format!("did you mean \"{like}\"?")),
            None => wrong,
        })
    }

    pub(crate) fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>, Wrong> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let expected = "a list of numbers";
        let list = value.get_ref().as_array().ok_or_else(|| self.wrong_type(key, value, expected))?;
        let numbers = list.iter().map(|value| self.finite(key, value, expected));
        numbers.collect::<Result<Vec<f64>, Wrong>>().map(Some)
    }

    pub(crate) fn pair(&self, key: &str) -> Result<Option<[f64; 2]>, Wrong> {
        let Some(numbers) = self.numbers(key)? else { return Ok(None) };
        match numbers[..] {
            [x, y] => Ok(Some([x, y])),
            _ => Err(Wrong::new(
                format!("`{key}` has {} numbers; expected two, x and y", numbers.len()),
                self.place(key),
            )),
        }
    }

    /// A table within this one.
    pub(crate) fn section(
        &self,
        key: &str,
        name: String,
        keys: &[&str],
    ) -> Result<Option<Section<'a>>, Wrong> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let table = value.get_ref().as_table().ok_or_else(|| self.wrong_type(key, value, "a table"))?;
        let section = Section::new(name, table, value.span(), self.text, keys)?;
        Ok(Some(Section { units: self.units, ..section }))
    }

    /// Tables of a list within this one.
    pub(crate) fn sections(&self, key: &str, name: &str, keys: &[&str]) -> Result<Vec<Section<'a>>, Wrong> {
        let Some(value) = self.get(key) else { return Ok(Vec::new()) };
        let expected = "one table for each, under a header in double brackets";
        let list = value.get_ref().as_array().ok_or_else(|| self.wrong_type(key, value, expected))?;
        list.iter()
            .map(|value| {
                let table =
                    value.get_ref().as_table().ok_or_else(|| self.wrong_type(key, value, expected))?;
                Section::new(name, table, value.span(), self.text, keys)
            })
            .collect()
    }
}
