//! The numbers of the case as fields: typed one by one, or moved by steps.

use serde::Serialize;
use standfast_cases::CaseFile;
use standfast_cases::couple::{Variable, vary};
use standfast_inputs::key::{Id, Table};
use standfast_inputs::typed::typed;
use standfast_inputs::units::GRAVITY_UNIT;

use crate::page::Page;
use crate::text::units_of_script;

/// A number of the case, as a field shows it.
#[derive(Debug, Serialize)]
pub struct NumberField {
    /// Table and key.
    key: String,
    words: &'static str,
    /// The same in a few words.
    label: String,
    symbol: &'static str,
    digits: String,
    unit: String,
    /// Units that may be typed.
    units: Vec<&'static str>,
    range: &'static str,
}

/// The numbers of a table, which has its place among those of its kind.
#[derive(Debug, Serialize)]
pub struct NumberTable {
    header: String,
    words: &'static str,
    numbers: Vec<NumberField>,
}

/// The numbers that stand in a case file, table by table.
pub fn tables(file: &CaseFile) -> Vec<NumberTable> {
    let mut tables: Vec<((Table, usize), NumberTable)> = Vec::new();
    for (id, _) in file.inputs().numbers() {
        let Some(field) = NumberField::of(file, id) else { continue };
        match tables.last_mut().filter(|(of, _)| *of == (id.table, id.index)) {
            Some((_, table)) => table.numbers.push(field),
            None => {
                let header = if id.table == Table::Top { String::new() } else { id.table.path(id.index) };
                let words = id.table.words().split(';').next().unwrap_or_default();
                tables.push(((id.table, id.index), NumberTable { header, words, numbers: vec![field] }));
            }
        }
    }
    tables.into_iter().map(|(_, table)| table).collect()
}

impl NumberField {
    fn of(file: &CaseFile, id: Id) -> Option<NumberField> {
        let (digits, unit) = file.shown_number(id)?;
        let units = file.units_of(id);
        let names = units.dimension.into_iter().flat_map(standfast_inputs::units::Dimension::names);
        let info = id.key.info();
        Some(NumberField {
            key: id.to_string(),
            words: info.words,
            label: id.words(),
            symbol: info.symbol,
            digits: digits.replace('-', "−"),
            unit: if unit.is_empty() && info.name.ends_with("_deg") { "°".to_owned() } else { unit },
            units: names.chain(units.gravity.then_some(GRAVITY_UNIT)).collect(),
            range: info.range().map_or("", standfast_inputs::key::Range::words),
        })
    }
}

/// The number of a case under a key by its name.
pub fn find(file: &CaseFile, key: &str) -> Option<Id> {
    file.inputs().numbers().map(|(id, _)| id).find(|id| id.to_string() == key)
}

impl Page {
    /// Beginning and end of a number's value in the text, in UTF-16 units; empty of one that does not stand there.
    pub fn place_of(&self, key: &str) -> Vec<u32> {
        let file = self.settled();
        let entry = file.entries().iter().find(|entry| entry.id.to_string() == key);
        // Another text than the one that stands has other places.
        let span =
            entry.map(|entry| &entry.span).filter(|span| !span.is_empty() && file.text() == self.text());
        span.map_or_else(Vec::new, |span| units_of_script(file.text(), span).map(|unit| unit as u32).into())
    }

    /// Takes what was typed for a number: in the unit typed, or else in that which stands there.
    ///
    /// # Errors
    /// A sentence on what is wrong with it.
    pub fn set(&mut self, key: &str, text: &str) -> Result<(), String> {
        if let Some(name) = Page::random_name(key) {
            return self.set_deviation(name, text);
        }
        let file = self.settled();
        let id = find(file, key).ok_or_else(|| format!("The case has no number {key}."))?;
        let read = typed(text, file.units_of(id))?;
        let unit = match read.unit {
            Some(unit) => unit.to_owned(),
            None => file.written_number(id).map_or(String::new(), |written| written.unit),
        };
        let text = file.with_number(id, read.number, &unit);
        let text = text.ok_or_else(|| format!("{key} is not written as a number."))?;
        self.told = String::new();
        match self.take(text.clone()) {
            Ok(()) => Ok(()),
            // What has no answer alone has one with what goes with it, as the caisson of a wave with the body.
            Err(error) => self.set_coupled(id, &text).ok_or(error),
        }
    }

    /// Takes a text in which a number has changed, with what goes with that; `None` where nothing does, or where it has no answer even so.
    fn set_coupled(&mut self, id: Id, text: &str) -> Option<()> {
        let inputs = self.settled().inputs();
        let mut now = self.settled().reread(text).ok()?;
        let value = now.inputs().number(id)?;
        let varied = vary(inputs, self.settled_case()?, &[(&Variable::of(id, inputs), value)]);
        let goes: Vec<(Id, f64)> = varied
            .numbers()
            .filter(|(other, si)| *other != id && inputs.number(*other) != Some(*si))
            .collect();
        if goes.is_empty() {
            return None;
        }
        for (other, si) in &goes {
            let round = |number, _: &str| standfast_cases::layout::significant(number, 6).parse().ok();
            now = now.rewritten(*other, *si, round)?;
        }
        self.take(now.text().to_owned()).ok()?;
        let names: Vec<String> = goes.iter().map(|(other, _)| other.to_string()).collect();
        self.told = format!("With {id} went {}.", names.join(", "));
        Some(())
    }

    /// Takes a number some per cent greater or less, in no more than four digits.
    ///
    /// # Errors
    /// As [`set`](Page::set).
    pub fn step(&mut self, key: &str, percent: f64) -> Result<(), String> {
        if let Some(name) = Page::random_name(key) {
            return self.step_deviation(name, percent);
        }
        let file = self.settled();
        let written = find(file, key).and_then(|id| file.written_number(id));
        let Some(number) = written.and_then(|written| written.digits.parse::<f64>().ok()) else {
            return Ok(());
        };
        let next = standfast_cases::layout::significant(number * (1.0 + percent / 100.0), 4);
        self.set(key, &next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_takes_numbers_as_people_type_them() {
        let mut page = Page::default();
        for (key, typed, line) in [
            ("body.width", "12,5", "width = \"12.5 m\""),
            ("body.width", "1 250 cm", "width = \"1250 cm\""),
            ("body.density", "2 200 kg/m3", "density = \"2200 kg/m3\""),
            ("body.friction", "0,55", "friction = 0.55"),
            ("load[1].force", "2.9 MN/m", "force = \"2.9 MN/m\""),
            ("load[1].elevation", "11", "elevation = \"11 m\""),
        ] {
            assert_eq!(page.set(key, typed), Ok(()), "{key}");
            assert!(page.text().lines().any(|found| found == line), "{line} in {}", page.text());
        }
    }

    #[test]
    fn what_is_not_taken_leaves_all_as_it_was() {
        let mut page = Page::default();
        let before = page.text().to_owned();
        for (key, typed, message) in [
            ("body.width", "2,700", "“2,700” could be 2.7 or 2700: type 2.7 or 2700."),
            ("body.width", "0", "`width` is \"0 m\"; expected a finite number above zero"),
            ("body.width", "3 kg", "“kg” is not a unit of this field, which takes mm, cm, m, ft or in."),
            ("load[1].elevation", "99", "`elevation` is above the crest of the body, which is 12 m high"),
            ("body.mass", "3", "The case has no number body.mass."),
        ] {
            let error = page.set(key, typed).unwrap_err();
            assert!(error.starts_with(message), "{key}: {error}");
            assert_eq!((page.text(), page.can_undo()), (before.as_str(), false));
        }
    }

    #[test]
    fn a_number_is_found_in_the_text() {
        let mut page = Page::default();
        let text = format!("# größer\n{}", page.text());
        assert!(page.edit(&text));
        let units: Vec<u16> = text.encode_utf16().collect();
        let [from, to] = page.place_of("body.friction")[..] else { panic!("it stands there") };
        assert_eq!(String::from_utf16(&units[from as usize..to as usize]).unwrap(), "0.6");
        assert!(page.place_of("wave.period").is_empty());
        page.edit("nonsense");
        assert!(page.place_of("body.friction").is_empty());
    }

    /// A width or a height that has no answer alone takes with it what goes with it in `design`.
    #[test]
    fn what_has_no_answer_alone_is_not_refused() {
        let mut page = Page::default();
        assert!(page.open("goda.toml", include_str!("../../examples/goda-2000.toml")));
        page.set("body.width", "18").unwrap();
        // Mass and weight less buoyancy at the same density: 346.05 and 2318.64 times 18/15.
        for line in [
            "width = \"18 m\"",
            "mass = \"415.26 t/m\"",
            "buoyant_weight = \"2782.37 kN/m\"",
            "caisson_width = \"18 m\"",
        ] {
            assert!(page.text().lines().any(|found| found.starts_with(line)), "{line} in {}", page.text());
        }
        assert_eq!(page.told, "With body.width went body.mass, body.buoyant_weight, wave.caisson_width.");
        page.undo();
        assert_eq!(page.text(), include_str!("../../examples/goda-2000.toml"), "one step");
        page.set("body.height", "11 m").unwrap();
        assert!(page.text().contains("crest_height = \"3.9 m\""), "{}", page.text());
        // What stands alone goes alone.
        page.set("body.friction", "0.55").unwrap();
        assert_eq!(page.told, "");
    }

    #[test]
    fn steps_are_per_cent_of_what_stands_there() {
        let mut page = Page::default();
        page.step("load[1].force", 1.0).unwrap();
        page.step("body.friction", -10.0).unwrap();
        assert!(page.text().contains("force = \"2727 kN/m\"") && page.text().contains("friction = 0.54"));
    }
}
