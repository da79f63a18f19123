//! Other numbers in the text of a case: only the digits and the unit change; order and spaces stay as they are. A comment behind a
//! number that changes says what the number was, because it may be the source of that one alone. Of `[random]` whole laws are put
//! and taken away, and histories are put.

mod history;
pub(crate) mod random;

use std::ops::Range as Span;

use crate::datum::level_unit;
use crate::digits::decimal;
use crate::key::{Id, Kind};
use crate::parse::CaseText;
use crate::typed::TypedUnits;
use crate::units::split_text;

/// Beginning of a comment that says what the number before it was.
const WAS: &str = "was ";

/// A number as it stands in the text of a case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrittenNumber {
    /// Its digits.
    pub digits: String,
    /// Its unit; that of SI where none is written, and empty of a plain number.
    pub unit: String,
    /// Span of the value in the text, quotes and all.
    pub span: Span<usize>,
    /// Quote around it; `None` of a number without one.
    quote: Option<char>,
}

impl CaseText {
    /// The number under a key as it is written; `None` if none stands there.
    pub fn written_number(&self, id: Id) -> Option<WrittenNumber> {
        self.inputs().number(id)?;
        let span = self.number_span(id)?;
        let written = self.text().get(span.clone())?;
        let quote = written.chars().next().filter(|first| matches!(first, '"' | '\''));
        let inner = match quote {
            // Neither a text of several lines nor one with an escape is a number that is written plainly.
            Some(quote) => written.strip_prefix(quote)?.strip_suffix(quote)?,
            None => written,
        };
        // TOML has underscores between the digits of a bare number.
        let inner = if quote.is_none() { inner.replace('_', "") } else { inner.trim().to_owned() };
        let (digits, unit) = split_text(&inner).unwrap_or((&inner, ""));
        let unit = match (quote, self.inputs().dimension(id)) {
            (None, Some(dimension)) => dimension.si(),
            _ => unit.trim(),
        };
        Some(WrittenNumber { digits: digits.to_owned(), unit: unit.to_owned(), span, quote })
    }

    /// The text with another number under a key, in a unit of the key's; `None` if none stands there. It is parsed like any other.
    ///
    /// A comment behind the number is the source of what stood there: it then says so, until that stands there again.
    ///
    /// ```
    /// use standfast_inputs::{CaseText, Key};
    ///
    /// let file = CaseText::parse("case.toml", "[body]\nwidth = \"15 m\"  # drawing 12\n")?;
    /// let text = file.with_number(Key::Width.into(), 15.5, "m");
    /// assert_eq!(text.as_deref(), Some("[body]\nwidth = \"15.5 m\"  # was 15 m: drawing 12\n"));
    /// # Ok::<(), standfast_inputs::CaseError>(())
    /// ```
    pub fn with_number(&self, id: Id, number: f64, unit: &str) -> Option<String> {
        let written = self.written_number(id)?;
        let digits = toml_number(number);
        let is_plain = unit.is_empty() || (written.quote.is_none() && unit == written.unit);
        let value = match written.quote.unwrap_or('"') {
            _ if is_plain && written.quote.is_none() => digits,
            quote if unit.is_empty() => format!("{quote}{digits}{quote}"),
            quote => format!("{quote}{digits} {unit}{quote}"),
        };
        Some(self.replaced(written.span, &value))
    }

    /// The text with a line more in the table of a key that stands nowhere, in front of the others there; `None` where that table has no line of
    /// its own.
    pub fn with_line(&self, id: Id, value: &str) -> Option<String> {
        let first =
            self.entries().iter().filter(|entry| entry.id.table == id.table && entry.id.index == id.index);
        let start = first.map(|entry| entry.span.start).min()?;
        let text = self.text();
        let line = text[..start].rfind('\n').map_or(0, |feed| feed + 1);
        // In braces, or behind a dotted name, keys have no lines.
        let name = text[line..start].split('=').next()?.trim();
        let known = id.table.keys().any(|key| key.entry() == name);
        known.then(|| format!("{}{} = {value}\n{}", &text[..line], id.key.entry(), &text[line..]))
    }

    /// The text with another value in the place of one, and what a comment behind it says then.
    fn replaced(&self, span: Span<usize>, value: &str) -> String {
        let text = self.text();
        let Span { start, end } = span;
        let change = self.comment_behind(end).and_then(|comment| {
            let other = of_another(&text[comment.clone()], &text[start..end], value)?;
            Some((comment, other))
        });
        // Without a comment to change, nothing is changed behind the value.
        let (comment, other) = change.unwrap_or((end..end, String::new()));
        [&text[..start], value, &text[end..comment.start], &other, &text[comment.end..]].concat()
    }

    /// The text with other numbers in the list under a key, each in the unit that stands at its place, and the list as it is then written;
    /// `None` if no list of so many stands there. A comment behind it says what the list was.
    pub fn with_list(&self, id: Id, si: &[f64]) -> Option<(String, String)> {
        let entry = self.entries().iter().find(|entry| entry.id == id)?;
        let text = self.text();
        if entry.elements.len() != si.len() || self.inputs().list(id)?.len() != si.len() {
            return None;
        }
        let mut list = String::new();
        let mut end = entry.span.start;
        for (span, si) in entry.elements.iter().zip(si) {
            let written = text.get(span.clone())?;
            let quote = written.chars().next().filter(|first| matches!(first, '"' | '\''));
            let element = match quote {
                None => toml_number(decimal(*si)),
                Some(quote) => {
                    let (_, unit) = split_text(written.strip_prefix(quote)?.strip_suffix(quote)?)?;
                    let number = decimal(self.from_si(id, *si, unit.trim())?);
                    format!("{quote}{} {}{quote}", toml_number(number), unit.trim())
                }
            };
            list += text.get(end..span.start)?;
            list += &element;
            end = span.end;
        }
        list += text.get(end..entry.span.end)?;
        Some((self.replaced(entry.span.clone(), &list), list.replace(['"', '\''], "")))
    }

    /// A number in a unit of the key's, in SI units; `None` if the unit is not one of its.
    pub fn in_si(&self, id: Id, number: f64, unit: &str) -> Option<f64> {
        if let Some((unit, name)) = level_unit(unit) {
            return self.inputs().frame().length_at(id.key, unit.in_si(number), name).ok();
        }
        match self.inputs().dimension(id) {
            Some(_) => Some(self.inputs().unit_named(id, unit)?.in_si(number)),
            None => unit.is_empty().then_some(number),
        }
    }

    /// An SI value in a unit of the key's; `None` if the unit is not one of its.
    pub fn from_si(&self, id: Id, si: f64, unit: &str) -> Option<f64> {
        if let Some((unit, name)) = level_unit(unit) {
            return Some(unit.of_si(self.inputs().frame().level_at(id.key, si, name)?));
        }
        match self.inputs().dimension(id) {
            Some(_) => Some(self.inputs().unit_named(id, unit)?.of_si(si)),
            None => unit.is_empty().then_some(si),
        }
    }

    /// Units that a number under a key may be typed in.
    pub fn units_of(&self, id: Id) -> TypedUnits {
        let dimension = self.inputs().dimension(id);
        TypedUnits { dimension, gravity: id.key.info().kind.is_of_shaking() && dimension.is_some() }
    }

    /// Span of a number: of its entry, or of its element in a list.
    fn number_span(&self, id: Id) -> Option<Span<usize>> {
        let Id { table, index, key } = id;
        let entry = self.entries().iter().find(|entry| {
            let of = entry.id;
            (of.table, of.index, of.key.entry()) == (table, index, key.entry())
        })?;
        let place = match key.info().kind {
            Kind::OneOf(..) => {
                table.keys().filter(|other| other.entry() == key.entry()).position(|other| other == key)
            }
            _ => None,
        };
        match place {
            Some(place) => entry.elements.get(place).cloned(),
            None => (!entry.span.is_empty()).then(|| entry.span.clone()),
        }
    }
}

/// What a comment says behind `now` that said something of `before`, both as they are written; `None` if it stays.
fn of_another(comment: &str, before: &str, now: &str) -> Option<String> {
    let plain = |written: &str| written.trim_matches(['"', '\'', ' ']).to_owned();
    let (before, now) = (plain(before), plain(now));
    let is_same = |one: &str, two: &str| match (split_text(one), split_text(two)) {
        (Some((one, unit)), Some((two, other))) => {
            unit.trim() == other.trim() && one.parse::<f64>() == two.parse::<f64>()
        }
        _ => one == two,
    };
    let earlier = comment.strip_prefix(WAS).and_then(|rest| rest.split_once(": "));
    match earlier.filter(|(number, _)| split_text(number).is_some()) {
        Some((first, source)) => is_same(first, &now).then(|| source.to_owned()),
        None => (!is_same(&before, &now)).then(|| format!("{WAS}{before}: {comment}")),
    }
}

/// A number as TOML has it, that is read as the same.
fn toml_number(number: f64) -> String {
    let number = number + 0.0;
    match number == 0.0 || (1e-4..1e9).contains(&number.abs()) {
        true => number.to_string(),
        false => format!("{number:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::{Key, Table};

    const TEXT: &str = "# A wall\ngravity = 9.80 # here\n[body]\nwidth = \"150 cm\" # drawing 12\nheight = 2\nmass = '5 t/m'\n\
                        friction = 0.6\n\n[wave]\nlambda = [ 1.0, # slowly varying\n  0.5,\n  1 ]\n[[load]]\nforce = 7\nelevation = 1\n\
                        [[load]]\nname = \"n # 2\"   # push\nforce = \"1 kN/m\"\nelevation = 1_0.5\n[earthquake]\nhorizontal = \"0.25 g\"\n";

    fn file() -> CaseText {
        CaseText::parse("t.toml", TEXT).unwrap()
    }

    /// Whatever number is written, only its own line differs, and the case read again has it.
    #[test]
    fn only_the_line_of_the_number_differs() {
        let file = file();
        let numbers: Vec<Id> = file.inputs().numbers().map(|(id, _)| id).collect();
        assert_eq!(numbers.len(), 13);
        for id in numbers {
            let written = file.written_number(id).unwrap();
            for number in [1.25, 0.3, 1.0 / 3.0, 1e-7, 12345678.9] {
                let text = file.with_number(id, number, &written.unit).unwrap();
                let differ: Vec<_> = TEXT.lines().zip(text.lines()).filter(|(one, two)| one != two).collect();
                assert_eq!((TEXT.lines().count(), differ.len()), (text.lines().count(), 1), "{id}: {text}");
                let again = CaseText::parse("t.toml", &text).unwrap();
                let si = file.in_si(id, number, &written.unit).unwrap();
                let found = again.inputs().number(id).unwrap();
                assert!(found == si || id.key == Key::Horizontal, "{id}: {found}, not {si}");
                let back = file.from_si(id, si, &written.unit).unwrap();
                assert!((back - number).abs() <= 1e-15 * number, "{id}");
                let back = again.with_number(id, written.digits.parse().unwrap(), &written.unit).unwrap();
                assert_eq!(comments(&back), comments(TEXT), "{id}");
            }
        }
    }

    fn comments(text: &str) -> Vec<&str> {
        text.lines().filter_map(|line| line.split_once('#')).map(|(_, comment)| comment).collect()
    }

    /// A comment may be the source of the number that stood there: it says of which, however often that changes.
    #[test]
    fn a_comment_says_what_the_number_was() {
        let line = |file: &CaseText, id: Id, number, unit: &str| {
            let text = file.with_number(id, number, unit).unwrap();
            let changed = text.lines().zip(file.text().lines()).find(|(one, two)| one != two);
            (
                changed.map(|(line, _)| line.to_owned()).unwrap_or_default(),
                CaseText::parse("t.toml", &text).unwrap(),
            )
        };
        let width = Key::Width.into();
        let (text, once) = line(&file(), width, 155.0, "cm");
        assert_eq!(text, "width = \"155 cm\" # was 150 cm: drawing 12");
        let (text, twice) = line(&once, width, 1.6, "m");
        assert_eq!(text, "width = \"1.6 m\" # was 150 cm: drawing 12");
        let (text, back) = line(&twice, width, 150.0, "cm");
        assert_eq!((text.as_str(), back.text()), ("width = \"150 cm\" # drawing 12", TEXT));
        // The same number is no change, however it is written.
        assert_eq!(line(&file(), Key::Gravity.into(), 9.8, "m/s2").0, "gravity = 9.8 # here");
        let second = Table::Wave.keys().find(|key| key.name() == "lambda[1]").unwrap();
        assert_eq!(line(&file(), second.into(), 0.9, "").0, "lambda = [ 0.9, # slowly varying");
        // What begins with the same word and is no number is a comment as any other.
        let own = CaseText::parse("t.toml", "[body]\nwidth = \"15 m\" # was wider: see drawing 3\n").unwrap();
        assert_eq!(line(&own, width, 14.0, "m").0, "width = \"14 m\" # was 15 m: was wider: see drawing 3");
    }

    #[test]
    fn numbers_stand_as_they_are_written() {
        let file = file();
        let shown = |id: Id| {
            let written = file.written_number(id).unwrap();
            format!("{}|{}", written.digits, written.unit)
        };
        let keys = [Key::Gravity, Key::Width, Key::Height, Key::Mass, Key::Friction, Key::Horizontal];
        assert_eq!(
            keys.map(|key| shown(key.into())),
            ["9.80|m/s2", "150|cm", "2|m", "5|t/m", "0.6|", "0.25|g"]
        );
        let loads = [(Key::Force, 0), (Key::Force, 1), (Key::Elevation, 1)];
        assert_eq!(loads.map(|(key, index)| shown(Id::new(key, index))), ["7|N/m", "1|kN/m", "10.5|m"]);
        let second = Table::Wave.keys().find(|key| key.name() == "lambda[2]").unwrap();
        assert_eq!(shown(second.into()), "0.5|");
        assert_eq!(file.written_number(Key::Length.into()), None);
        assert_eq!(file.written_number(Key::LoadName.into()), None);
    }

    #[test]
    fn another_unit_is_written_with_its_quotes() {
        let file = file();
        let line = |id: Id, number, unit| {
            let text = file.with_number(id, number, unit).unwrap();
            let changed = TEXT.lines().zip(text.lines()).find(|(one, two)| one != two).unwrap().1.to_owned();
            assert!(CaseText::parse("t.toml", &text).is_ok(), "{text}");
            changed
        };
        assert_eq!(line(Key::Width.into(), 1.5, "m"), "width = \"1.5 m\" # was 150 cm: drawing 12");
        assert_eq!(line(Key::Height.into(), 2.5, "m"), "height = 2.5");
        assert_eq!(line(Key::Height.into(), 250.0, "cm"), "height = \"250 cm\"");
        assert_eq!(line(Key::Mass.into(), 4.0, "t/m"), "mass = '4 t/m'");
        assert_eq!(line(Key::Horizontal.into(), 2.0, "m/s2"), "horizontal = \"2 m/s2\"");
        assert_eq!(line(Id::new(Key::Force, 1), 1e12, "N/m"), "force = \"1e12 N/m\"");
    }
}
