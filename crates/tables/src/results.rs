//! Columns of results: what they are called, what they hold, and their values.

use std::sync::Arc;

use standfast::{Mode, Modes, Verdict};

use crate::text::Separators;

/// A column of results.
#[derive(Debug, Clone)]
pub(crate) struct ResultField {
    pub(crate) name: &'static str,
    pub(crate) kind: FieldKind,
    /// The unit of its numbers, and what it is; said where a format has room for it.
    pub(crate) said: Option<ColumnWords>,
    /// True if its heading has the unit, behind the name.
    pub(crate) has_heading: bool,
}

impl ResultField {
    /// The heading of the column: its name, and in brackets the unit.
    pub(crate) fn heading(&self) -> String {
        match self.said.and_then(|said| said.unit).filter(|_| self.has_heading) {
            Some(unit) => format!("{} [{unit}]", self.name),
            None => self.name.to_owned(),
        }
    }
}

/// Unit and words of a column, where a format has room for them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ColumnWords {
    /// `None` for what has no unit.
    pub(crate) unit: Option<&'static str>,
    #[cfg_attr(not(feature = "memory"), expect(dead_code, reason = "CSV has no room for it"))]
    pub(crate) words: &'static str,
}

/// Kind of the values of a column of results.
#[derive(Debug, Clone)]
pub(crate) enum FieldKind {
    /// One of these words.
    Word(&'static [&'static str]),
    /// One of these names.
    Name(Arc<[String]>),
    /// Sets of modes.
    Modes,
    /// true or false.
    Flag,
    /// Numbers.
    Number,
    /// Words of their own for each row.
    Text,
}

/// The symbols of all modes, in the order of their codes, and that of ground that fails.
pub(crate) const SYMBOLS: [&str; Mode::ALL.len() + 1] = {
    let mut symbols = [Verdict::BearingFailure.symbol(); Mode::ALL.len() + 1];
    let mut place = 0;
    while place < Mode::ALL.len() {
        symbols[place] = Mode::ALL[place].symbol();
        place += 1;
    }
    symbols
};

/// The code of a row without word.
pub const NO_WORD: u8 = u8::MAX;

/// The place of a row without name.
pub const NO_NAME: u32 = u32::MAX;

/// A column of results. A row that has none holds [`NO_WORD`], [`NO_NAME`], `None` or NaN.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Values {
    /// Of these words, by their places.
    Word(&'static [&'static str], Vec<u8>),
    /// Of these names, by their places.
    Name(Arc<[String]>, Vec<u32>),
    /// Sets of modes.
    Modes(Vec<Option<Modes>>),
    /// true or false.
    Flag(Vec<Option<bool>>),
    /// Numbers.
    Number(Vec<f64>),
    /// Words of their own: which warnings a row has, or what is wrong with it.
    Text(Vec<Option<String>>),
}

impl Values {
    pub(crate) fn empty(kind: &FieldKind, rows: usize) -> Values {
        match kind {
            FieldKind::Word(words) => Values::Word(words, Vec::with_capacity(rows)),
            FieldKind::Name(names) => Values::Name(names.clone(), Vec::with_capacity(rows)),
            FieldKind::Modes => Values::Modes(Vec::with_capacity(rows)),
            FieldKind::Flag => Values::Flag(Vec::with_capacity(rows)),
            FieldKind::Number => Values::Number(Vec::with_capacity(rows)),
            FieldKind::Text => Values::Text(Vec::with_capacity(rows)),
        }
    }

    /// Appends results of the same kind.
    #[cfg(feature = "memory")]
    pub(crate) fn append(&mut self, more: Values) {
        match (self, more) {
            (Values::Word(_, codes), Values::Word(_, more)) => codes.extend(more),
            (Values::Name(_, places), Values::Name(_, more)) => places.extend(more),
            (Values::Modes(sets), Values::Modes(more)) => sets.extend(more),
            (Values::Flag(flags), Values::Flag(more)) => flags.extend(more),
            (Values::Number(numbers), Values::Number(more)) => numbers.extend(more),
            (Values::Text(texts), Values::Text(more)) => texts.extend(more),
            _ => unreachable!("a column of results keeps its kind"),
        }
    }

    /// Appends the result of a row to a line of CSV.
    pub(crate) fn push_field(&self, row: usize, separators: Separators, line: &mut Vec<u8>) {
        let start = line.len();
        self.push_text(row, line);
        if let (Values::Number(_), b',') = (self, separators.decimal) {
            line[start..].iter_mut().filter(|byte| **byte == b'.').for_each(|byte| *byte = b',');
        }
        // Words of our own need no quotation marks.
        let foreign = matches!(self, Values::Name(..) | Values::Text(_));
        let is_special = |byte: &u8| matches!(byte, b'"' | b'\n' | b'\r') || *byte == separators.column;
        if foreign && line[start..].iter().any(is_special) {
            let text = line.split_off(start);
            line.push(b'"');
            for byte in text {
                line.extend_from_slice(if byte == b'"' { b"\"\"" } else { std::slice::from_ref(&byte) });
            }
            line.push(b'"');
        }
    }

    /// Appends the result of a row to a text.
    pub(crate) fn push_text(&self, row: usize, text: &mut Vec<u8>) {
        match self {
            Values::Word(words, codes) => {
                text.extend_from_slice(words.get(usize::from(codes[row])).unwrap_or(&"").as_bytes());
            }
            Values::Name(names, places) => {
                text.extend_from_slice(names.get(places[row] as usize).map_or("", String::as_str).as_bytes());
            }
            Values::Modes(sets) => {
                for (i, mode) in sets[row].iter().flat_map(|set| set.iter()).enumerate() {
                    if i > 0 {
                        text.push(b' ');
                    }
                    text.extend_from_slice(mode.symbol().as_bytes());
                }
            }
            Values::Flag(flags) => text.extend_from_slice(match flags[row] {
                Some(true) => b"true",
                Some(false) => b"false",
                None => b"",
            }),
            Values::Number(numbers) if numbers[row].is_nan() => {}
            // An infinite one is "inf", which what reads CSV takes for a number.
            Values::Number(numbers) => {
                text.extend_from_slice(ryu::Buffer::new().format(numbers[row]).as_bytes());
            }
            Values::Text(texts) => {
                text.extend_from_slice(texts[row].as_deref().unwrap_or_default().as_bytes());
            }
        }
    }
}
