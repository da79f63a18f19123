//! From the text of a case file to typed [`Inputs`], driven by the table of [keys](crate::key).
//!
//! Nothing is guessed: a key, unit or value that is not understood is a [`CaseError`] that points at it.

mod option;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range as Span;
use std::sync::Arc;

use standfast::{Ball, Modes};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::code_file::{CodeFile, OF_CODES};
use crate::datum::{Datum, Frame, LevelFault, level_unit, split_level};
use crate::digits::shortened;
use crate::edit::random::line_of;
use crate::error::{CaseError, Fault, Place, Problem, expected_type, names};
use crate::inputs::{Inputs, LoadFactor, SEA, Value, dimension};
use crate::key::{Id, Key, Kind, Range, Table};
use crate::random::{self, RANDOM, Random, RandomProblem, RandomRecord};
use crate::record::{ReadFile, RecordFile};
use crate::units::{Dimension, Extent, UnitError, in_gravity, split_text};
pub use option::read;

/// A case file: what it says, and where it says it.
#[derive(Debug, Clone)]
pub struct CaseText {
    name: String,
    text: String,
    inputs: Inputs,
    entries: Vec<Entry>,
    headers: BTreeMap<(Table, usize), Span<usize>>,
    units: Option<Extent>,
    /// Name of the datum, the level of the base, and the sea above the base, where the file has them.
    datum: Option<(String, f64)>,
    sea: Option<f64>,
    random: Option<Random>,
    /// The files that [random] names, as they were read.
    beside: BTreeMap<String, Arc<RecordFile>>,
}

/// An entry of a case file.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The key; the first number's of a list.
    pub id: Id,
    /// Span of its value in the text; empty, at its end, of what follows from other entries.
    pub span: Span<usize>,
    /// Spans of the elements of a list.
    pub(crate) elements: Vec<Span<usize>>,
    /// The value as it would be written, of what follows from other entries.
    follows: Option<String>,
}

/// A problem and the place it is at.
struct PlacedProblem {
    problem: Problem,
    span: Span<usize>,
}

impl CaseText {
    /// Reads a case file; `name` is what errors call it.
    ///
    /// # Errors
    /// If the text is not TOML, or a key or value is not what a case file has.
    pub fn parse(name: &str, text: &str) -> Result<CaseText, CaseError> {
        CaseText::reading(name, text, |file| file.read_document(text, &document(name, text)?))
    }

    /// Reads a case file with the files that it names, which `read` reads; `name` is what errors call it.
    ///
    /// # Errors
    /// As [`parse`](CaseText::parse), and if a file cannot be read.
    pub fn read(name: &str, text: &str, read: &ReadFile<'_>) -> Result<CaseText, CaseError> {
        CaseText::parse(name, text)?.with_files(read)
    }

    /// Adds the files that it names, which `read` reads.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn with_files(self, read: &ReadFile<'_>) -> Result<CaseText, CaseError> {
        self.with_some_files(read, &|_| true)
    }

    /// Adds the files under the keys that `which` picks, and those that `[random]` names.
    ///
    /// # Errors
    /// As [`with_files`](CaseText::with_files).
    pub fn with_some_files(
        mut self,
        read: &ReadFile<'_>,
        which: &dyn Fn(Id) -> bool,
    ) -> Result<CaseText, CaseError> {
        for (id, name) in self.wanted().into_iter().filter(|(id, _)| which(*id)) {
            let value = match read(&name) {
                Ok(text) if id.key == Key::CombinationCode => {
                    Value::Code(Arc::new(CodeFile::parse(&name, &text, self.units)?))
                }
                Ok(text) => Value::Record(Arc::new(RecordFile::of_text(name, text))),
                Err(why) => return Err(self.error(Fault::new(Problem::Unread { name, why }, id))),
            };
            self.inputs.put(id, value);
        }
        let records = self.random.as_ref().map_or_else(Vec::new, |random| random.records.clone());
        for name in records.iter().flat_map(RandomRecord::files).cloned() {
            let text = read(&name).map_err(|why| {
                let span = self.random.as_ref().map_or(0..0, |random| random.span.clone());
                let problem = Problem::Unread { name: name.clone(), why };
                CaseError::new(&self.name, &self.text, problem, vec![span])
            })?;
            self.beside.insert(name.clone(), Arc::new(RecordFile::of_text(name, text)));
        }
        Ok(self)
    }

    /// Takes the files that it names from a text that has read them.
    pub fn with_files_of(mut self, other: &CaseText) -> CaseText {
        let read: Vec<(Id, &Value)> =
            other.inputs.values().filter(|(_, value)| value.file().is_some()).collect();
        for (id, name) in self.wanted() {
            let same = read.iter().find(|(_, value)| value.file() == Some(&name));
            if let Some((_, value)) = same {
                self.inputs.put(id, (*value).clone());
            }
        }
        self.beside = other.beside.clone();
        self
    }

    /// A file that [random] names, once it is read.
    pub fn beside(&self, name: &str) -> Option<&Arc<RecordFile>> {
        self.beside.get(name)
    }

    /// The files that it names and that were read, with their texts: each once, by name.
    pub fn files(&self) -> impl Iterator<Item = (&str, &str)> {
        let of_keys = self.inputs.values().filter_map(|(_, value)| match value {
            Value::Record(file) => Some((file.name(), file.text()?)),
            Value::Code(file) => Some((file.name(), file.text())),
            _ => None,
        });
        let files = of_keys.chain(self.beside.values().filter_map(|file| Some((file.name(), file.text()?))));
        files.collect::<BTreeMap<_, _>>().into_iter()
    }

    /// The files that it names and that are not read yet, with the keys under which they stand.
    pub fn wanted(&self) -> Vec<(Id, String)> {
        let is_named = |id: Id| id.key.info().kind == Kind::File || id.key == Key::CombinationCode;
        let wanted = self.inputs.values().filter(|(id, _)| is_named(*id));
        wanted.filter_map(|(id, value)| Some((id, value.as_text()?.to_owned()))).collect()
    }

    fn reading(
        name: &str,
        text: &str,
        read: impl FnOnce(&mut CaseText) -> Result<(), PlacedProblem>,
    ) -> Result<CaseText, CaseError> {
        let mut file = CaseText {
            name: name.to_owned(),
            text: text.to_owned(),
            inputs: Inputs::default(),
            entries: Vec::new(),
            headers: BTreeMap::new(),
            units: Some(Extent::PerMetre),
            datum: None,
            sea: None,
            random: None,
            beside: BTreeMap::new(),
        };
        match read(&mut file) {
            Ok(()) => {
                file.entries.sort_by_key(|entry| entry.span.start);
                Ok(file)
            }
            Err(PlacedProblem { problem, span }) => Err(CaseError::new(name, text, problem, vec![span])),
        }
    }

    /// Its name in errors.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its inputs.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Copies the file with other values, as if they stood where those of the file do; an entry without value goes.
    pub fn varied(&self, inputs: Inputs) -> CaseText {
        let mut file = CaseText { inputs, ..self.clone() };
        file.entries.retain(|entry| file.inputs.get(entry.id).is_some());
        file
    }

    /// Adds an entry that follows from others, as it would be written.
    pub fn with_entry(mut self, id: Id, written: String) -> CaseText {
        let end = self.text.len();
        self.entries.push(Entry { id, span: end..end, elements: Vec::new(), follows: Some(written) });
        self
    }

    /// A fault of inputs, shown in the text.
    pub fn error(&self, Fault { problem, at, and }: Fault) -> CaseError {
        let spans = std::iter::once(at).chain(and).map(|place| self.span(place)).collect();
        CaseError::new(&self.name, &self.text, problem, spans)
    }

    /// Its random numbers, where it has some.
    pub fn random(&self) -> Option<&Random> {
        self.random.as_ref()
    }

    /// Fault of its random numbers, shown in the text.
    pub fn random_error(&self, problem: RandomProblem, span: Span<usize>) -> CaseError {
        CaseError::new(&self.name, &self.text, problem.into(), vec![span])
    }

    /// The tables that it has, with the places of their headers.
    pub fn headers(&self) -> impl Iterator<Item = (Table, Span<usize>)> {
        self.headers.iter().map(|((table, _), span)| (*table, span.clone()))
    }

    /// The place of the header of the `index`-th table of a kind, or of a table in braces.
    pub(crate) fn header(&self, table: Table, index: usize) -> Option<Span<usize>> {
        self.headers.get(&(table, index)).cloned()
    }

    /// Its entries in their order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The value of an entry as it is written, quotes and all.
    pub fn written<'a>(&'a self, entry: &'a Entry) -> &'a str {
        entry.follows.as_deref().unwrap_or_else(|| self.text.get(entry.span.clone()).unwrap_or_default())
    }

    /// The comment behind the value of an entry, on the line where it ends.
    pub fn comment(&self, entry: &Entry) -> Option<&str> {
        self.text.get(self.comment_behind(entry.span.end)?)
    }

    /// Place of what a comment says that is next behind a place, on its line.
    pub(crate) fn comment_behind(&self, place: usize) -> Option<Span<usize>> {
        let rest = self.text.get(place..)?.lines().next()?;
        let comment = rest.trim_start().strip_prefix('#')?.trim();
        let start = place + rest.find(comment)?;
        (!comment.is_empty()).then_some(start..start + comment.len())
    }

    /// Span of a place; a key that is not there, at its table.
    fn span(&self, place: Place) -> Span<usize> {
        let of_table = |table: Table, index| {
            let whole = 0..self.text.len();
            self.headers.get(&(table, index)).cloned().unwrap_or(whole)
        };
        let entry = |id: Id| {
            let list = id.key.entry();
            self.entries.iter().find(|entry| {
                let Id { table, index, key } = entry.id;
                (table, key.entry(), index) == (id.table, list, id.index)
            })
        };
        match place {
            Place::Table(table, index) => of_table(table, index),
            Place::Key(id) => {
                entry(id).map_or_else(|| of_table(id.table, id.index), |entry| entry.span.clone())
            }
            Place::Element(id, place) => {
                let element = entry(id).and_then(|entry| entry.elements.get(place).cloned());
                element.unwrap_or_else(|| self.span(Place::Key(id)))
            }
        }
    }

    fn read_document(&mut self, text: &str, document: &Spanned<DeTable<'_>>) -> Result<(), PlacedProblem> {
        let top = document.get_ref();
        self.headers.insert((Table::Top, 0), document.span());
        self.units = units(top);
        // Before what a [block] makes of the units of all others is said.
        if let (None, Some((joint, _))) = (self.units, top.get_key_value(Table::Joint.name())) {
            let problem = Problem::JointsNotFor { what: "a body in pure numbers, [block]" };
            return Err(PlacedProblem { problem, span: joint.span() });
        }
        self.datum = datum(text, top)?;
        self.sea = sea(text, top, frame(self.units, &self.datum, None))?;
        self.read_table(text, top, Table::Top, 0)?;
        if let Some(value) = top.get(RANDOM) {
            let read = random::read(value);
            self.random =
                Some(read.map_err(|(problem, span)| PlacedProblem { problem: problem.into(), span })?);
        }
        Ok(())
    }

    fn read_tables(
        &mut self,
        text: &str,
        value: &Spanned<DeValue<'_>>,
        table: Table,
        of: usize,
    ) -> Result<(), PlacedProblem> {
        const EXPECTED: &str = "one table for each, under a header in double brackets";
        let Some(list) = value.get_ref().as_array() else { return Err(no_table(value, table, EXPECTED)) };
        if list.is_empty() {
            return Err(PlacedProblem { problem: Problem::NoTables { table }, span: value.span() });
        }
        if list.len() > table.most() {
            let problem = Problem::TooManyTables { table, count: list.len() };
            return Err(PlacedProblem { problem, span: value.span() });
        }
        let from_base = if table == Table::Joint { self.places_from_base(text, list) } else { Vec::new() };
        for (place, value) in list.iter().enumerate() {
            let inner = as_table(value, table, EXPECTED)?;
            let index = from_base.get(place).copied().unwrap_or_else(|| table.index_in(of, place));
            self.begin(table, index, value.span());
            self.read_table(text, inner, table, index)?;
        }
        Ok(())
    }

    /// The number of each joint from the base up, in whatever order they stand; one whose elevation cannot be read stands last.
    fn places_from_base(&self, text: &str, joints: &[Spanned<DeValue<'_>>]) -> Vec<usize> {
        let elevation = |joint: &Spanned<DeValue<'_>>| {
            let key = Key::JointElevation;
            let value = joint.get_ref().as_table()?.get(key.name())?;
            let frame = frame(self.units, &self.datum, self.sea);
            match (Field { id: key.into(), value, text, frame }).value(key.info().kind) {
                Ok(Value::Number(number)) => Some(number),
                _ => None,
            }
        };
        let elevations: Vec<f64> =
            joints.iter().map(|joint| elevation(joint).unwrap_or(f64::INFINITY)).collect();
        let mut order: Vec<usize> = (0..joints.len()).collect();
        order.sort_by(|one, two| elevations[*one].total_cmp(&elevations[*two]));
        let mut numbers = vec![0; joints.len()];
        order.into_iter().enumerate().for_each(|(number, place)| numbers[place] = number);
        numbers
    }

    fn begin(&mut self, table: Table, index: usize, span: Span<usize>) {
        self.headers.insert((table, index), span);
        self.inputs.add_table(table);
    }

    /// Reads a table, the `index`-th of its kind, with the tables that stand in it.
    fn read_table(
        &mut self,
        text: &str,
        found: &DeTable<'_>,
        table: Table,
        index: usize,
    ) -> Result<(), PlacedProblem> {
        only(found, table)?;
        for (name, value) in found.iter() {
            let Some(key) = Key::find(table, name.get_ref()) else { continue };
            // A number, or a table of the same name.
            if value.get_ref().as_table().is_some()
                && table.children().any(|child| child.name() == key.name())
            {
                continue;
            }
            let id = Id::of(table, index, key);
            let field = Field { id, value, text, frame: frame(self.units, &self.datum, self.sea) };
            match key.info().kind {
                Kind::OneOf(count, range) => {
                    let keys = table.keys().filter(|other| other.entry() == key.entry());
                    for (key, number) in keys.zip(field.several(count, range)?) {
                        self.inputs.put(Id::of(table, index, key), Value::Number(number));
                    }
                }
                kind => {
                    self.inputs.put(id, field.value(kind)?);
                    // What is in g is put so; the gravity of the case may stand further down.
                    let unit = value.get_ref().as_str().and_then(|text| split_text(text.trim()));
                    let unit = unit.zip(field.dimension());
                    if let Some(unit) =
                        unit.and_then(|((_, name), dimension)| dimension.shown_unit(name.trim()))
                    {
                        self.inputs.put_unit(id, unit);
                    }
                    for (place, decimal) in field.long_decimals() {
                        self.inputs.put_decimal(id, place, decimal);
                    }
                }
            }
            let elements = match value.get_ref() {
                DeValue::Array(list) => list.iter().map(Spanned::span).collect(),
                DeValue::Table(named) => in_order(named)
                    .into_iter()
                    .map(|(name, value)| name.span().start..value.span().end)
                    .collect(),
                _ => Vec::new(),
            };
            self.entries.push(Entry { id, span: value.span(), elements, follows: None });
        }
        for child in table.children() {
            let Some(value) = found.get(child.name()) else { continue };
            if value.get_ref().as_table().is_none() && Key::find(table, child.name()).is_some() {
                continue;
            }
            if child.repeats() {
                self.read_tables(text, value, child, index)?;
                continue;
            }
            let expected = if child.is_history() { "a shape with its numbers, in braces" } else { "a table" };
            let inner = as_table(value, child, expected)?;
            self.begin(child, index, value.span());
            self.read_table(text, inner, child, index)?;
        }
        Ok(())
    }
}

/// The document of a text; `name` is what errors call it.
fn document<'a>(name: &str, text: &'a str) -> Result<Spanned<DeTable<'a>>, PlacedProblem> {
    if text.trim().is_empty() {
        return Err(PlacedProblem { problem: Problem::Empty { name: name.to_owned() }, span: 0..0 });
    }
    DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        let line = text[line_of(text, &(span.start..span.start))].trim_end().to_owned();
        PlacedProblem { problem: Problem::Syntax { message: error.message().to_owned(), line }, span }
    })
}

/// What the file of a code says, as the first combination of a case of such units.
pub(crate) fn read_code(name: &str, text: &str, units: Option<Extent>) -> Result<Inputs, CaseError> {
    let read = CaseText::reading(name, text, |file| {
        let document = document(name, text)?;
        let top = document.get_ref();
        let known = |key: &str| OF_CODES.iter().any(|of| of.name() == key);
        let others = top.keys().filter(|key| !known(key.get_ref()));
        if let Some(key) = others.min_by_key(|key| key.span().start) {
            let problem = Problem::NotOfCodes { name: key.get_ref().clone().into_owned() };
            return Err(PlacedProblem { problem, span: key.span() });
        }
        file.units = units;
        file.begin(Table::Combination, 0, document.span());
        file.read_table(text, top, Table::Combination, 0)
    })?;
    Ok(read.inputs)
}

/// Extent of a document, a metre run or the whole body, on which its units depend wherever they stand; see [`Inputs::units`].
fn units(top: &DeTable<'_>) -> Option<Extent> {
    if top.contains_key(Table::Block.name()) {
        return None;
    }
    let body = top.get(Table::Body.name()).and_then(|body| body.get_ref().as_table());
    let has = |key: Key| body.and_then(|body| body.get(key.name()));
    let cylinder = has(Key::Shape).is_some_and(|shape| shape.get_ref().as_str() == Some("cylinder"));
    Some(if has(Key::Length).is_some() || cylinder { Extent::Whole } else { Extent::PerMetre })
}

/// The datum of a document, on which its levels depend wherever they stand: its name, and the level of the base.
fn datum(text: &str, top: &DeTable<'_>) -> Result<Option<(String, f64)>, PlacedProblem> {
    let Some(value) = top.get(Table::Datum.name()) else { return Ok(None) };
    let table = as_table(value, Table::Datum, "a table with `base` and `name`, in braces")?;
    only(table, Table::Datum)?;
    let field = |key: Key| {
        let missing = Problem::MissingKey { table: Table::Datum, key };
        let found = table.get(key.name());
        let found = found.ok_or(PlacedProblem { problem: missing, span: value.span() })?;
        let field = Field { id: key.into(), value: found, text, frame: Some(Extent::PerMetre).into() };
        field.value(key.info().kind).map_err(|problem| match problem.problem {
            Problem::Level { .. } => {
                field.out_of_range("the level of the base in metres; the name of the datum stands in `name`")
            }
            _ => problem,
        })
    };
    let (Value::Number(base), Value::Text(name)) = (field(Key::DatumBase)?, field(Key::DatumName)?) else {
        return Ok(None);
    };
    match level_unit(&format!("m{name}")) {
        Some((_, found)) if found == name => Ok(Some((name, base))),
        _ => {
            let expected =
                "a name that stands behind a unit: a capital letter first, then letters and digits";
            let problem = Problem::OutOfRange { key: Key::DatumName, written: shortened(&name), expected };
            let span = table.get(Key::DatumName.name()).map_or_else(|| value.span(), Spanned::span);
            Err(PlacedProblem { problem, span })
        }
    }
}

/// What the numbers of a document are read against.
fn frame(units: Option<Extent>, datum: &Option<(String, f64)>, sea: Option<f64>) -> Frame<'_> {
    Frame { units, datum: datum.as_ref().map(|(name, base)| Datum { name, base: *base }), sea }
}

/// The sea of a document above the base, where it says so. A level that cannot be read is told at once: others are counted from it.
fn sea(text: &str, top: &DeTable<'_>, frame: Frame<'_>) -> Result<Option<f64>, PlacedProblem> {
    for key in SEA {
        let id = Id::from(key);
        let table = top.get(id.table.name()).and_then(|table| table.get_ref().as_table());
        let Some(value) = table.and_then(|table| table.get(key.name())) else { continue };
        match (Field { id, value, text, frame }).value(key.info().kind) {
            Ok(Value::Number(level)) => return Ok(Some(level)),
            Err(PlacedProblem { problem: Problem::Level { fault: LevelFault::NoSea, .. }, .. }) => {}
            Err(problem) => return Err(problem),
            Ok(_) => {}
        }
    }
    Ok(None)
}

/// Words in one line, as names stand in tables.
fn one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Refuses every name that a table does not have; the first in the text is reported.
fn only(found: &DeTable<'_>, table: Table) -> Result<(), PlacedProblem> {
    let allowed = names(table);
    let unknown = found.keys().filter(|key| !allowed.contains(&key.get_ref().as_ref()));
    match unknown.min_by_key(|key| key.span().start) {
        None => Ok(()),
        Some(key) => {
            let name: &str = key.get_ref();
            let problem = Problem::UnknownKey { table, name: name.to_owned() };
            Err(PlacedProblem { problem, span: key.span() })
        }
    }
}

fn as_table<'a>(
    value: &'a Spanned<DeValue<'a>>,
    table: Table,
    expected: &'static str,
) -> Result<&'a DeTable<'a>, PlacedProblem> {
    value.get_ref().as_table().ok_or_else(|| no_table(value, table, expected))
}

fn no_table(value: &Spanned<DeValue<'_>>, table: Table, expected: &'static str) -> PlacedProblem {
    PlacedProblem {
        problem: Problem::NoTable { table, found: type_of(value.get_ref()), expected },
        span: value.span(),
    }
}

/// Type of a value of a document, in words.
pub fn type_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(integer) if integer.radix() != 10 => "a number that is not decimal",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// A plain TOML number; `None` for every other type, and for integers that are no decimals (hexadecimal etc.).
pub fn plain_number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

/// The word for formulas of Shimosako and Takahashi by which the waves give the duration of an impulsive one.
pub const BY_WAVES: &str = "shimosako-takahashi";

/// The word for the direction in which a body bears least.
pub const WORST: &str = "worst";

/// Words that stand in place of the number under a key: the formulas by which waves give a duration, the heights that they have anyway.
pub fn words_for(id: Id) -> &'static [&'static str] {
    match (id.table, id.key) {
        (Table::WaveHistory, Key::HistoryDuration) | (Table::Storm, Key::StormTau0) => &[BY_WAVES],
        (Table::Wave, Key::WaveHeight) => &["Hmax", "H13"],
        (Table::Earthquake, Key::EarthquakeDirection) => &[WORST],
        _ => &[],
    }
}

/// The entries of a table in the order in which they stand in the text.
fn in_order<'a, 'b>(table: &'a DeTable<'b>) -> Vec<(&'a Spanned<Cow<'b, str>>, &'a Spanned<DeValue<'b>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries
}

/// A value under a key.
struct Field<'a> {
    id: Id,
    value: &'a Spanned<DeValue<'a>>,
    text: &'a str,
    frame: Frame<'a>,
}

impl Field<'_> {
    fn problem(&self, problem: Problem) -> PlacedProblem {
        PlacedProblem { problem, span: self.value.span() }
    }

    fn wrong_type(&self, expected: &'static str) -> PlacedProblem {
        self.problem(Problem::WrongType { key: self.id.key, found: type_of(self.value.get_ref()), expected })
    }

    /// A value as it stands in the file, shortened where it would fill the screen.
    fn written(&self, value: &Spanned<DeValue<'_>>) -> String {
        shortened(self.text.get(value.span()).unwrap_or_default())
    }

    fn out_of_range(&self, expected: &'static str) -> PlacedProblem {
        self.problem(Problem::OutOfRange { key: self.id.key, written: self.written(self.value), expected })
    }

    fn in_range(&self, number: f64, range: Range) -> Result<f64, PlacedProblem> {
        // A written "-0.0" is zero.
        if range.contains(number) { Ok(number + 0.0) } else { Err(self.out_of_range(range.words())) }
    }

    fn value(&self, kind: Kind) -> Result<Value, PlacedProblem> {
        let wrong_type = || self.wrong_type(expected_type(kind));
        let number = plain_number(self.value.get_ref());
        Ok(match kind {
            Kind::Text | Kind::File => Value::Text(self.words()?),
            Kind::Measured(..) | Kind::Plain(_) if self.word().is_some() => {
                Value::Choice(self.word().unwrap_or_default())
            }
            Kind::Measured(_, range) => {
                let number = number.map_or_else(|| self.measured(), Ok)?;
                Value::Number(self.in_range(number, range)?)
            }
            Kind::Reached if self.dimension().is_none() => {
                let plain = || self.wrong_type(expected_type(Kind::Plain(Range::Finite)));
                Value::Number(self.in_range(number.ok_or_else(plain)?, Range::Finite)?)
            }
            Kind::InGravity | Kind::Reached => match number {
                Some(number) => {
                    self.bare_acceleration(Some(number))?;
                    Value::Number(self.in_range(number, Range::Finite)?)
                }
                None => match self.value.get_ref().as_str().and_then(in_gravity) {
                    Some(share) => Value::InGravity(self.in_range(share, Range::Finite)?),
                    None => Value::Number(self.in_range(self.measured()?, Range::Finite)?),
                },
            },
            Kind::Plain(range) => {
                let wrong = || match words_for(self.id) {
                    [] => wrong_type(),
                    _ => self.wrong_type("a number of degrees without unit or quotes, or \"worst\""),
                };
                Value::Number(self.in_range(number.ok_or_else(wrong)?, range)?)
            }
            Kind::OneOf(..) => return Err(wrong_type()),
            Kind::Truth => Value::Truth(self.value.get_ref().as_bool().ok_or_else(wrong_type)?),
            // How many sides, as long as it is plain which.
            Kind::Choice { words, .. } if self.id.key == Key::WetSides && number.is_some() => {
                match number.unwrap_or(0.0) {
                    number if number == 1.0 || number == 2.0 => Value::Number(number),
                    _ => return Err(self.out_of_range(words)),
                }
            }
            Kind::Choice { of, words } => {
                let word = self.words()?;
                match of.iter().find(|choice| **choice == word) {
                    Some(choice) => Value::Choice(choice),
                    None if self.id.key == Key::CombinationCode && CodeFile::is_called(&word) => {
                        Value::Text(word)
                    }
                    None => return Err(self.out_of_range(words)),
                }
            }
            Kind::Unit(dimension) => {
                let unit = self.words()?;
                let dimension = self.frame.units.unwrap_or(Extent::PerMetre).of(dimension);
                let unknown = || Problem::Unit {
                    key: self.id.key,
                    dimension: Some(dimension),
                    written: self.written(self.value),
                    error: UnitError::Unknown(unit.clone()),
                };
                let named = dimension.names().find(|name| *name == unit);
                Value::Choice(named.ok_or_else(|| self.problem(unknown()))?)
            }
            Kind::List(_) => {
                let numbers = self.elements(kind)?.map(|field| {
                    let number = plain_number(field.value.get_ref()).map_or_else(|| field.measured(), Ok)?;
                    field.in_range(number, Range::Finite)
                });
                Value::Numbers(numbers.collect::<Result<_, _>>()?)
            }
            Kind::Pairs(_) => {
                let mut numbers = Vec::new();
                for pair in self.elements(kind)? {
                    let both = pair.value.get_ref().as_array().filter(|both| both.len() == 2);
                    for value in both.ok_or_else(|| pair.wrong_type("a pair [x, z]"))? {
                        let field = Field { value, ..pair };
                        let number =
                            plain_number(field.value.get_ref()).map_or_else(|| field.measured(), Ok)?;
                        numbers.push(field.in_range(number, Range::Finite)?);
                    }
                }
                Value::Numbers(numbers)
            }
            Kind::Plains => {
                let numbers = self.elements(kind)?.map(|field| {
                    let number = plain_number(field.value.get_ref());
                    let number = number.ok_or_else(|| field.wrong_type("a number without unit or quotes"))?;
                    field.in_range(number, Range::Finite)
                });
                Value::Numbers(numbers.collect::<Result<_, _>>()?)
            }
            Kind::Factors => Value::Factors(self.named(kind, |field| field.factor())?),
            Kind::Settings => {
                let written =
                    |field: &Field<'_>| self.text.get(field.value.span()).unwrap_or_default().to_owned();
                Value::Settings(self.named(kind, |field| Ok(written(field)))?)
            }
            Kind::Ratios => Value::Ratios(self.named(kind, |field| field.ratio())?),
            Kind::Spreads => match self.value.get_ref().as_table() {
                None => Value::Number(self.share()?),
                Some(table) if table.is_empty() => {
                    return Err(self.out_of_range("one name with a share at least"));
                }
                Some(_) => Value::Ratios(self.named(kind, |field| field.share())?),
            },
            Kind::Places => Value::Places(self.named(kind, |field| field.point())?),
            Kind::Bounds => Value::Bounds(self.bounds()?),
            Kind::Exceedances => Value::Numbers(self.exceedances()?),
            Kind::ModeList => {
                let mut modes = Modes::NONE;
                for field in self.elements(kind)? {
                    let mode = field.words()?.parse();
                    modes.insert(mode.map_err(|_| {
                        field.out_of_range("one of RE, SL, SL+, RO, RO', SRO-, SRO+, SRO'-, SRO'+ and FL")
                    })?);
                }
                Value::Modes(modes)
            }
        })
    }

    /// The elements of a list that is not empty.
    fn elements(&self, kind: Kind) -> Result<impl Iterator<Item = Field<'_>>, PlacedProblem> {
        let list = self.value.get_ref().as_array().ok_or_else(|| self.wrong_type(expected_type(kind)))?;
        if list.is_empty() {
            return Err(self.out_of_range("a list that is not empty"));
        }
        Ok(list.iter().map(|value| Field { value, ..*self }))
    }

    /// Names in the order in which they stand, each once, and what `read` makes of their values.
    fn named<T>(
        &self,
        kind: Kind,
        read: impl Fn(&Field<'_>) -> Result<T, PlacedProblem>,
    ) -> Result<Vec<(String, T)>, PlacedProblem> {
        let table = self.value.get_ref().as_table();
        let table = table.ok_or_else(|| self.wrong_type(expected_type(kind)))?;
        let mut named: Vec<(String, T)> = Vec::new();
        for (name, value) in in_order(table) {
            let name = one_line(name.get_ref());
            if named.iter().any(|(before, _)| *before == name) {
                return Err(self.out_of_range("each name once"));
            }
            let read = read(&Field { value, ..*self })?;
            named.push((name, read));
        }
        Ok(named)
    }

    /// A factor on a load, or two in a list.
    fn factor(&self) -> Result<LoadFactor, PlacedProblem> {
        const EXPECTED: &str =
            "numbers without unit or quotes, or two of them in a list; a name with a dot stands in quotes";
        let number = |field: &Field<'_>| {
            let number = plain_number(field.value.get_ref()).ok_or_else(|| self.wrong_type(EXPECTED))?;
            // Beyond, the factor would be the load.
            match (0.0..=1e6).contains(&number) {
                true => Ok(number + 0.0),
                false => Err(field.out_of_range("a factor from 0 to 1000000")),
            }
        };
        let Some(list) = self.value.get_ref().as_array() else { return Ok(LoadFactor::One(number(self)?)) };
        match &list[..] {
            [one, two] => {
                let [one, two] = [one, two].map(|value| number(&Field { value, ..*self }));
                Ok(LoadFactor::Pair([one?, two?]))
            }
            _ => Err(self.out_of_range("a factor, or two of which the worse counts")),
        }
    }

    /// A number above zero.
    fn ratio(&self) -> Result<f64, PlacedProblem> {
        const EXPECTED: &str = "numbers without unit or quotes; a name with a dot stands in quotes";
        let number = plain_number(self.value.get_ref()).ok_or_else(|| self.wrong_type(EXPECTED))?;
        match number > 0.0 && number <= 1e6 {
            true => Ok(number),
            false => Err(self.out_of_range("a number above zero, 1000000 at most")),
        }
    }

    /// A share from 0 to 1, or in per cent.
    fn share(&self) -> Result<f64, PlacedProblem> {
        let percent = |text: &str| text.trim().strip_suffix('%')?.trim().parse::<f64>().ok();
        let value = self.value.get_ref();
        let number = match (plain_number(value), value.as_str().and_then(percent)) {
            (Some(number), _) => number,
            (None, Some(percent)) => 0.01 * percent,
            (None, None) => {
                return Err(self.wrong_type("a share, as 0.02 or \"2%\", or names with such shares"));
            }
        };
        self.in_range(number, Range::ZeroToOne)
    }

    /// A point, of lengths.
    fn point(&self) -> Result<[f64; 2], PlacedProblem> {
        let list = self.value.get_ref().as_array().filter(|both| both.len() == 2);
        let list = list.ok_or_else(|| self.wrong_type("a point [x, y] of each name"))?;
        let mut point = [0.0; 2];
        for (place, value) in point.iter_mut().zip(list) {
            let field = Field { value, ..*self };
            let number = match (plain_number(value.get_ref()), value.get_ref().as_str(), self.frame.units) {
                (Some(number), ..) => number,
                (None, Some(text), Some(_)) => Dimension::Length.parse(text).map_err(|error| {
                    let written = field.written(value);
                    let dimension = Some(Dimension::Length);
                    field.problem(Problem::Unit { key: self.id.key, dimension, written, error })
                })?,
                _ => return Err(field.wrong_type("a point [x, y] of each name")),
            };
            *place = field.in_range(number, Range::Finite)?;
        }
        Ok(point)
    }

    /// Criteria under their names.
    fn bounds(&self) -> Result<Vec<(Key, Value)>, PlacedProblem> {
        let table = self.value.get_ref().as_table();
        let table = table.ok_or_else(|| self.wrong_type(expected_type(Kind::Bounds)))?;
        only(table, Table::Criteria)?;
        let bounds = in_order(table).into_iter().filter_map(|(name, value)| {
            let key = Key::find(Table::Criteria, name.get_ref())?;
            let field = Field { id: key.into(), value, ..*self };
            Some(field.value(key.info().kind).map(|value| (key, value)))
        });
        bounds.collect()
    }

    /// Slides with the probability of each that may be exceeded: slide, probability, slide and so on.
    fn exceedances(&self) -> Result<Vec<f64>, PlacedProblem> {
        let wrong = |field: &Field<'_>| field.wrong_type(expected_type(Kind::Exceedances));
        let all: Vec<Field<'_>> = match self.value.get_ref().as_array() {
            Some(_) => self.elements(Kind::Exceedances)?.collect(),
            None => vec![Field { ..*self }],
        };
        let mut numbers = Vec::new();
        for one in all {
            let table = one.value.get_ref().as_table().filter(|table| table.len() == 2);
            let table = table.ok_or_else(|| wrong(&one))?;
            let field = |name: &str| {
                let value = table.get(name).ok_or_else(|| wrong(&one))?;
                Ok(Field { value, ..one })
            };
            let (slide, at_most) = (field("slide")?, field("at_most")?);
            let length = match slide.value.get_ref().as_str() {
                Some(text) => Dimension::Length.parse(text).map_err(|error| {
                    let written = slide.written(slide.value);
                    slide.problem(Problem::Unit {
                        key: self.id.key,
                        dimension: Some(Dimension::Length),
                        written,
                        error,
                    })
                })?,
                None => plain_number(slide.value.get_ref()).ok_or_else(|| wrong(&slide))?,
            };
            let share = plain_number(at_most.value.get_ref()).ok_or_else(|| wrong(&at_most))?;
            numbers
                .extend([slide.in_range(length, Range::Positive)?, at_most.in_range(share, Range::Share)?]);
        }
        Ok(numbers)
    }

    /// Words; the name of a load in one line, as it stands in tables.
    fn words(&self) -> Result<String, PlacedProblem> {
        let words = self.value.get_ref().as_str();
        let words = words.ok_or_else(|| self.wrong_type(expected_type(Kind::Text)))?;
        // A terminal would obey them.
        if words.chars().any(|c| c.is_control() && !c.is_whitespace()) {
            return Err(self.wrong_type("one without control characters"));
        }
        Ok(match self.id.key {
            Key::LoadName
            | Key::PressureName
            | Key::CombinationName
            | Key::PartName
            | Key::MomentName
            | Key::ResistanceName => match one_line(words) {
                name if name.is_empty() => return Err(self.out_of_range("a name that is not empty")),
                name => name,
            },
            _ => words.to_owned(),
        })
    }

    /// The word that stands in place of a number.
    fn word(&self) -> Option<&'static str> {
        let found = self.value.get_ref().as_str()?;
        words_for(self.id).iter().copied().find(|word| *word == found)
    }

    fn dimension(&self) -> Option<Dimension> {
        dimension(self.id, self.frame.units)
    }

    /// Refuses an acceleration without unit, which one would take for g and another for m/s²; zero is zero in both.
    fn bare_acceleration(&self, number: Option<f64>) -> Result<(), PlacedProblem> {
        match number {
            Some(number) if number.is_finite() && number != 0.0 => Err(self.problem(Problem::Unit {
                key: self.id.key,
                dimension: self.dimension(),
                written: self.written(self.value),
                error: UnitError::Missing,
            })),
            _ => Ok(()),
        }
    }

    /// A number with its unit.
    fn measured(&self) -> Result<f64, PlacedProblem> {
        let kind = match self.frame.units {
            None => Kind::Plain(Range::Finite),
            Some(_) => self.id.key.info().kind,
        };
        let (Some(text), Some(dimension)) = (self.value.get_ref().as_str(), self.dimension()) else {
            return Err(self.wrong_type(expected_type(kind)));
        };
        if let Some(length) = self.level(text) {
            return length;
        }
        dimension.parse(text).map_err(|error| {
            let written = self.written(self.value);
            self.problem(Problem::Unit { key: self.id.key, dimension: Some(dimension), written, error })
        })
    }

    /// The length that a level is; `None` of a text that is none.
    fn level(&self, text: &str) -> Option<Result<f64, PlacedProblem>> {
        let is_length = self.dimension() == Some(Dimension::Length);
        let (number, unit, name) = split_level(text).filter(|_| is_length)?;
        let length = self.frame.length_at(self.id.key, unit.in_si(number), name);
        Some(length.map_err(|fault| {
            let (key, written) = (self.id.key, self.written(self.value));
            self.problem(Problem::Level { key, written, fault })
        }))
    }

    /// The decimals of the numbers, by their places in a list, that have more digits than an f64 can say.
    fn long_decimals(&self) -> Vec<(usize, Ball)> {
        let values: Vec<&Spanned<DeValue<'_>>> = match self.value.get_ref() {
            // Pairs one after the other.
            DeValue::Array(list) => list
                .iter()
                .flat_map(|value| match value.get_ref() {
                    DeValue::Array(pair) => pair.iter().collect(),
                    _ => vec![value],
                })
                .collect(),
            DeValue::Table(table) => in_order(table).into_iter().map(|(_, value)| value).collect(),
            _ => vec![self.value],
        };
        let fields = values.into_iter().map(|value| Field { value, ..*self }).enumerate();
        fields.filter_map(|(place, field)| Some((place, field.long_decimal()?))).collect()
    }

    /// The decimal as it is written, in SI units or in g, of a number that has more digits than an f64 can say.
    fn long_decimal(&self) -> Option<Ball> {
        let (text, power) = match self.value.get_ref() {
            DeValue::Integer(integer) if integer.radix() == 10 => (integer.as_str(), 0),
            DeValue::Float(float) => (float.as_str(), 0),
            DeValue::String(text) => {
                if self.level(text).is_some() {
                    return None;
                }
                let unit = self.dimension().and_then(|dimension| dimension.split(text).ok());
                (split_text(text.trim())?.0, unit.map_or(Some(0), |(_, unit)| unit.power())?)
            }
            _ => return None,
        };
        let digits = text.chars().filter(char::is_ascii_digit).count();
        (digits > f64::DIGITS as usize).then(|| Ball::decimal(text))?.map(|number| number.times_ten_to(power))
    }

    /// So many numbers without unit in a list.
    fn several(&self, count: usize, range: Range) -> Result<Vec<f64>, PlacedProblem> {
        let expected = expected_type(Kind::OneOf(count, range));
        let list = self.value.get_ref().as_array().ok_or_else(|| self.wrong_type(expected))?;
        if list.len() != count {
            return Err(self.out_of_range(expected));
        }
        let numbers = list.iter().map(|value| {
            let field = Field { value, ..*self };
            let plain = plain_number(value.get_ref()).ok_or_else(|| field.wrong_type("a list of numbers"))?;
            field.in_range(plain, range)
        });
        numbers.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Explained;

    /// What is typed by habit is answered by what to type instead.
    #[test]
    fn a_slip_is_answered_by_what_to_type() {
        for (text, help) in [
            (
                "[[load]]\nforce = \"45 t/m\"",
                "t is a mass: a force of so many tonnes is in tf, tf/m or tf/m2",
            ),
            (
                "[[pressure]]\npressure = [\"4 kg/cm2\", 0]",
                "kg is a mass: a force of so many is in kgf, kgf/m or kgf/cm2",
            ),
            ("[[load]]\nforce = \"45 lb/ft\"", "a force is in lbf, lbf/ft or psf"),
            ("[body]\nmass = \"3 ton/m\"", "a ton may be 1000 kg, 2000 lb or 2240 lb"),
            ("[body]\nfriction = 0,6", "a point, with a digit on each side: friction = 0.6"),
            ("[body]\nfriction = .6", "friction = 0.6"),
            ("[body]\nwidth = 12,5 m   # 3\" pipe", "stand in quotes, e.g. width = \"12.5 m\""),
            ("[body]\nwidth = 1e3 m", "width = \"1000 m\""),
            ("[body]\nwidth = 1,000", "a point stands before decimals, nothing between thousands"),
            ("[body]\nwidth = 1.000,5 m", "a point stands before decimals, nothing between thousands"),
            ("[body]\nwidth = “12 m”", "quotes are straight"),
            ("title = \"Wall #3", "a quote is missing"),
            ("[motion base]", "a point between its parts: [body], [[load]], [motion.base]"),
            ("[body]\nwidth = 1\n[body]\nheight = 2", "under one header"),
            ("[[load]]\nfriction = 0.6", "`friction` belongs in [body], [[joint]] or [storm]"),
            ("[body]\nlevel = 3", "`level` belongs in [water]"),
            ("waves = 3", "did you mean `wave`?"),
            ("[body]\nfricton = 0.6", "did you mean `friction`?"),
            ("[body]\ndensity = \"25 kN/m3\"", "a unit weight over gravity is a density, \"2.548 t/m3\""),
        ] {
            let error = CaseText::parse("t.toml", text).map(drop).unwrap_err();
            let found = error.help().unwrap_or_default();
            assert!(found.contains(help), "{text}: {found}");
        }
        // What is no slip of these has no help that misleads.
        for text in ["title = \"Wall #3\" x", "[body]\nwidth : 3"] {
            assert_eq!(CaseText::parse("t.toml", text).map(drop).unwrap_err().help(), None, "{text}");
        }
    }

    #[test]
    fn entries_are_as_written_with_their_comments() {
        let text = "gravity = \"9.81 m/s2\"\ntitle = \"t # no comment\"\n[body]\nwidth = \"150 cm\" # drawing 12\nheight = 2\n\
                    mass = 5e3#\nfriction = 0.6\n[[load]]\nforce = 7\nelevation = 1\n[[load]]\nname = \"n # 2\"   # push\n\
                    force = \"1 kN/m\"\nelevation = 1\n";
        let file = CaseText::parse("t.toml", text).unwrap();
        let lines: Vec<_> = file
            .entries()
            .iter()
            .map(|entry| {
                let number = file.inputs().number(entry.id);
                format!("{} {} {:?} {number:?}", entry.id, file.written(entry), file.comment(entry))
            })
            .collect();
        assert_eq!(
            lines,
            [
                "gravity \"9.81 m/s2\" None Some(9.81)",
                "title \"t # no comment\" None None",
                "body.width \"150 cm\" Some(\"drawing 12\") Some(1.5)",
                "body.height 2 None Some(2.0)",
                "body.mass 5e3 None Some(5000.0)",
                "body.friction 0.6 None Some(0.6)",
                "load[1].force 7 None Some(7.0)",
                "load[1].elevation 1 None Some(1.0)",
                "load[2].name \"n # 2\" Some(\"push\") None",
                "load[2].force \"1 kN/m\" None Some(1000.0)",
                "load[2].elevation 1 None Some(1.0)",
            ]
        );
    }

    /// An acceleration in g counts the gravity of the case.
    #[test]
    fn a_share_of_gravity_may_have_its_unit() {
        let shaken = |value: &str| {
            let text = format!(
                "gravity = 9.8\n[body]\nwidth = 1\nheight = 2\nmass = 5e3\nfriction = 0.6\n[earthquake]\nhorizontal = {value}\n"
            );
            let read = CaseText::parse("t.toml", &text);
            read.map(|file| file.inputs().number(Key::Horizontal)).map_err(|error| error.to_string())
        };
        assert_eq!(shaken("\"0.25 g\""), Ok(Some(0.25 * 9.8)));
        assert_eq!(shaken("\"-0.25g\""), Ok(Some(-0.25 * 9.8)));
        assert_eq!(shaken("\"0.25 m/s2\""), Ok(Some(0.25)));
        assert_eq!(shaken("0"), Ok(Some(0.0)));
        for bare in ["0.25", "-1", "\"0.25\""] {
            let error = shaken(bare).unwrap_err();
            assert!(error.contains("has no unit"), "{error}");
        }
    }

    /// Numbers are listed table by table, whatever the order of the file.
    #[test]
    fn numbers_are_in_the_order_of_the_tables() {
        let text = "[[load]]\nelevation = 1\nforce = 7\n[[load]]\nforce = 8\nelevation = 2\n[water]\nlevel = 1\n\
                    [body]\nfriction = 0.6\nwidth = 1\n";
        let file = CaseText::parse("t.toml", text).unwrap();
        let names: Vec<_> = file.inputs().numbers().map(|(id, _)| id.to_string()).collect();
        let expected = "body.width body.friction water.level load[1].force load[1].elevation load[2].force \
                        load[2].elevation";
        assert_eq!(names.join(" "), expected);
    }
}
