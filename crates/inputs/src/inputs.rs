//! Values of a case file, typed, under their keys and without its text: they are varied, millions of times if need be.

use standfast::{Ball, Modes, Scalar};

use std::sync::Arc;

use crate::code_file::CodeFile;
use crate::datum::{Datum, Frame};
use crate::key::{Id, Key, Kind, Table};
use crate::output::OutputUnits;
use crate::record::RecordFile;
use crate::units::{Dimension, Extent, GRAVITY_UNIT, ShownUnit, split_text};

/// A value under a key.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Value {
    /// A number in SI units, or without unit.
    Number(f64),
    /// A multiple of the acceleration of gravity.
    InGravity(f64),
    /// Words.
    Text(String),
    /// true or false.
    Truth(bool),
    /// One of the words of its key.
    Choice(&'static str),
    /// Numbers in SI units.
    Numbers(Vec<f64>),
    /// Names of loads, and the factor of each.
    Factors(Vec<(String, LoadFactor)>),
    /// Names of keys, and a value of each as it is written, to be [read](crate::parse::read) once the key is known.
    Settings(Vec<(String, String)>),
    /// Names, and a number of each.
    Ratios(Vec<(String, f64)>),
    /// Names, and a point of each in SI units.
    Places(Vec<(String, [f64; 2])>),
    /// Keys of criteria, and their bounds.
    Bounds(Vec<(Key, Value)>),
    /// A set of modes.
    Modes(Modes),
    /// A file that was read.
    Record(Arc<RecordFile>),
    /// A file of a code that was read.
    Code(Arc<CodeFile>),
}

/// Factor on a load: one, or two of which it is not known beforehand which is the worse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadFactor {
    /// One factor.
    One(f64),
    /// Two, of which each is tried.
    Pair([f64; 2]),
}

impl LoadFactor {
    /// The factors.
    pub fn all(&self) -> &[f64] {
        match self {
            LoadFactor::One(factor) => std::slice::from_ref(factor),
            LoadFactor::Pair(both) => both,
        }
    }
}

impl Value {
    /// The name of the file that it is, once it is read.
    pub fn file(&self) -> Option<&str> {
        match self {
            Value::Record(file) => Some(file.name()),
            Value::Code(file) => Some(file.name()),
            _ => None,
        }
    }

    /// The words that it is.
    pub fn as_text(&self) -> Option<&str> {
        match self {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// The values of a case file.
///
/// ```
/// use standfast_inputs::{CaseText, Key};
///
/// let text = "[body]\nwidth = 1\nheight = 2\nmass = 5e3\nfriction = 0.6\n[[load]]\nforce = 7\nelevation = 1\n";
/// let mut inputs = CaseText::parse("case.toml", text)?.inputs().clone();
/// assert_eq!(inputs.number(Key::Width), Some(1.0));
/// inputs.set(Key::Width, 1.5);
/// assert_eq!(inputs.number(Key::Width), Some(1.5));
/// # Ok::<(), standfast_inputs::CaseError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Inputs {
    /// In the order of their keys.
    values: Vec<(Id, Value)>,
    /// Numbers with more decimals than an f64 says, as they are written, with their places in a list.
    decimals: Vec<((Id, usize), Ball)>,
    /// Units in which the file writes its numbers, where it writes one.
    written: Vec<(Id, ShownUnit)>,
    /// Numbers that a partial factor has divided: what people write may not be as small.
    divided: Vec<Id>,
    /// Number of tables of each kind, in the order of [`Table::ALL`].
    tables: [usize; Table::ALL.len()],
}

impl Default for Inputs {
    /// Of a file that says nothing.
    fn default() -> Inputs {
        Inputs {
            values: Vec::new(),
            decimals: Vec::new(),
            written: Vec::new(),
            divided: Vec::new(),
            tables: [0; Table::ALL.len()],
        }
    }
}

/// The same values; in which units they are written is no matter.
impl PartialEq for Inputs {
    fn eq(&self, other: &Inputs) -> bool {
        let Inputs { values, decimals, tables, divided: _, written: _ } = self;
        (values, decimals, tables) == (&other.values, &other.decimals, &other.tables)
    }
}

impl Inputs {
    /// The value under a key.
    pub fn get(&self, id: impl Into<Id>) -> Option<&Value> {
        let place = self.place(id.into()).ok()?;
        Some(&self.values[place].1)
    }

    /// The number under a key, in SI units.
    pub fn number(&self, id: impl Into<Id>) -> Option<f64> {
        match self.get(id)? {
            Value::Number(number) => Some(*number),
            // Where gravity is not given it is the standard one.
            Value::InGravity(share) => Some(share * self.gravity()),
            _ => None,
        }
    }

    /// The number under a key in any arithmetic: the decimal that its f64 stands for, or the longer one that was written.
    pub fn scalar<T: Scalar>(&self, id: impl Into<Id>) -> Option<T> {
        let id = id.into();
        match self.get(id)? {
            Value::Number(number) => Some(self.element(id, 0, *number)),
            Value::InGravity(share) => {
                let gravity = self.scalar(Key::Gravity).unwrap_or_else(|| T::written(GRAVITY));
                Some(self.element::<T>(id, 0, *share) * gravity)
            }
            _ => None,
        }
    }

    /// The number of which the f64 is `x`, at a place of the list under a key, in any arithmetic.
    pub fn element<T: Scalar>(&self, id: Id, place: usize, x: f64) -> T {
        match self.decimals.iter().find(|(of, _)| *of == (id, place)) {
            Some((_, decimal)) => T::of_decimal(decimal),
            None => T::written(x),
        }
    }

    /// Puts the decimal that was written beside its number, at a place of the list under a key; 0 of one number.
    pub fn put_decimal(&mut self, id: Id, place: usize, decimal: Ball) {
        self.decimals.push(((id, place), decimal));
    }

    /// Says in which unit the file writes a number.
    pub(crate) fn put_unit(&mut self, id: Id, unit: ShownUnit) {
        self.written.push((id, unit));
    }

    /// The unit of a name, where numbers under a key may have it.
    pub fn unit_named(&self, id: Id, name: &str) -> Option<ShownUnit> {
        let dimension = self.dimension(id)?;
        match id.key.info().kind {
            kind if kind.is_of_shaking() && name == GRAVITY_UNIT => Some(ShownUnit::gravity(self.gravity())),
            _ => dimension.shown_unit(name),
        }
    }

    /// The unit that a text writes behind a number of a key; `None` if it writes none.
    pub fn unit_in(&self, id: Id, text: &str) -> Option<ShownUnit> {
        self.unit_named(id, split_text(text.trim())?.1.trim())
    }

    /// The unit in which the file writes a number; that of SI, in which it takes one without, where it writes none.
    pub fn shown_unit(&self, id: Id) -> Option<ShownUnit> {
        let written = self.written.iter().find(|(of, _)| *of == id).map(|(_, unit)| *unit);
        match (written, self.get(id)) {
            (None, Some(Value::InGravity(_))) => Some(ShownUnit::gravity(self.gravity())),
            (None, _) => self.dimension(id).map(Dimension::shown_in_si),
            (written, _) => written,
        }
    }

    /// The words under a key.
    pub fn text(&self, id: impl Into<Id>) -> Option<&str> {
        match self.get(id)? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Truth value under a key.
    pub fn truth(&self, id: impl Into<Id>) -> Option<bool> {
        match self.get(id)? {
            Value::Truth(truth) => Some(*truth),
            _ => None,
        }
    }

    /// The word chosen under a key.
    pub fn choice(&self, id: impl Into<Id>) -> Option<&'static str> {
        match self.get(id)? {
            Value::Choice(word) => Some(word),
            _ => None,
        }
    }

    /// The list of numbers under a key, in SI units.
    pub fn list(&self, id: impl Into<Id>) -> Option<&[f64]> {
        match self.get(id)? {
            Value::Numbers(numbers) => Some(numbers),
            _ => None,
        }
    }

    /// The names of loads and their factors under a key.
    pub fn factors(&self, id: impl Into<Id>) -> Option<&[(String, LoadFactor)]> {
        match self.get(id)? {
            Value::Factors(factors) => Some(factors),
            _ => None,
        }
    }

    /// The names of keys and their values under a key.
    pub fn settings(&self, id: impl Into<Id>) -> Option<&[(String, String)]> {
        match self.get(id)? {
            Value::Settings(settings) => Some(settings),
            _ => None,
        }
    }

    /// The names and their numbers under a key.
    pub fn ratios(&self, id: impl Into<Id>) -> Option<&[(String, f64)]> {
        match self.get(id)? {
            Value::Ratios(ratios) => Some(ratios),
            _ => None,
        }
    }

    /// The names and their points under a key, in SI units.
    pub fn places(&self, id: impl Into<Id>) -> Option<&[(String, [f64; 2])]> {
        match self.get(id)? {
            Value::Places(places) => Some(places),
            _ => None,
        }
    }

    /// The criteria under a key.
    pub fn bounds(&self, id: impl Into<Id>) -> Option<&[(Key, Value)]> {
        match self.get(id)? {
            Value::Bounds(bounds) => Some(bounds),
            _ => None,
        }
    }

    /// The modes under a key.
    pub fn modes(&self, id: impl Into<Id>) -> Option<Modes> {
        match self.get(id)? {
            Value::Modes(modes) => Some(*modes),
            _ => None,
        }
    }

    /// The file under a key, once it is read.
    pub fn record(&self, id: impl Into<Id>) -> Option<&Arc<RecordFile>> {
        match self.get(id)? {
            Value::Record(record) => Some(record),
            _ => None,
        }
    }

    /// The file of a code under a key, once it is read.
    pub fn code(&self, id: impl Into<Id>) -> Option<&CodeFile> {
        match self.get(id)? {
            Value::Code(file) => Some(file),
            _ => None,
        }
    }

    /// All values with their keys.
    pub fn values(&self) -> impl Iterator<Item = (Id, &Value)> {
        self.values.iter().map(|(id, value)| (*id, value))
    }

    /// True if anything stands in a table, the `index`-th of its kind.
    pub fn has_at(&self, table: Table, index: usize) -> bool {
        self.values.iter().any(|(id, _)| (id.table, id.index) == (table, index))
    }

    /// Puts a number (SI) under a key. The key need not take such a number: who makes a case of the inputs refuses it.
    pub fn set(&mut self, id: impl Into<Id>, number: f64) {
        self.put(id.into(), Value::Number(number));
    }

    /// Puts a value under a key.
    pub fn put(&mut self, id: Id, value: Value) {
        self.decimals.retain(|((other, _), _)| *other != id);
        match self.place(id) {
            Ok(place) => self.values[place].1 = value,
            Err(place) => self.values.insert(place, (id, value)),
        }
    }

    /// Says that a partial factor has divided a number.
    pub fn put_divided(&mut self, id: Id) {
        self.divided.push(id);
    }

    /// True if a partial factor has divided a number.
    pub fn is_divided(&self, id: Id) -> bool {
        self.divided.contains(&id)
    }

    /// Takes away what stands under a key.
    pub fn remove(&mut self, id: Id) {
        self.values.retain(|(other, _)| *other != id);
    }

    fn place(&self, id: Id) -> Result<usize, usize> {
        self.values.binary_search_by_key(&id, |(id, _)| *id)
    }

    /// Number of tables of a kind.
    pub fn count(&self, table: Table) -> usize {
        self.tables[table as usize]
    }

    /// The numbers of the tables of a kind.
    pub fn indices(&self, table: Table) -> Vec<usize> {
        match table {
            Table::BackfillLayer => {
                (0..self.count(Table::Backfill)).flat_map(|of| self.tables_in(table, of)).collect()
            }
            _ => (0..self.count(table)).collect(),
        }
    }

    /// The numbers of the tables of a kind that stand in the `of`-th of another.
    pub fn tables_in(&self, table: Table, of: usize) -> Vec<usize> {
        // Each says something, or it could not be read.
        let mut indices: Vec<usize> = Vec::new();
        for (id, _) in self.values.iter().filter(|(id, _)| id.table == table) {
            if table.places(id.index)[0] == of && indices.last() != Some(&id.index) {
                indices.push(id.index);
            }
        }
        indices
    }

    /// The place of the table of a key among all of its kind, and the number of these.
    pub fn place_among(&self, id: Id) -> (usize, usize) {
        let indices = self.indices(id.table);
        (indices.iter().position(|index| *index == id.index).unwrap_or(id.index), indices.len())
    }

    /// True if there is a table of a kind.
    pub fn has(&self, table: Table) -> bool {
        self.count(table) > 0
    }

    /// Adds a table of a kind.
    pub fn add_table(&mut self, table: Table) {
        self.tables[table as usize] += 1;
    }

    /// Removes tables with all that they say.
    pub fn remove_tables(&mut self, of: impl Fn(Table) -> bool) {
        self.values.retain(|(id, _)| !of(id.table));
        Table::ALL.into_iter().filter(|table| of(*table)).for_each(|table| self.tables[table as usize] = 0);
    }

    /// True if loads or the base go with time, or the body is a `[block]`, so that there is a motion to follow. Histories of loads on a
    /// `[ground]`, and no `[motion]`, are those of an elastic base.
    pub fn is_in_time(&self) -> bool {
        let histories = [Table::WaveHistory, Table::LoadHistory];
        self.has(Table::Block)
            || self.has(Table::Motion)
            || (!self.has(Table::Ground) && histories.iter().any(|table| self.has(*table)))
    }

    /// Extent of its forces, masses and moments: the whole object where its length is given, or it is a cylinder.
    pub fn extent(&self) -> Extent {
        let whole = self.get(Key::Length).is_some() || self.choice(Key::Shape) == Some("cylinder");
        if whole { Extent::Whole } else { Extent::PerMetre }
    }

    /// Dimension of the numbers under a key; `None` for plain numbers and for what is not a number.
    pub fn dimension(&self, id: impl Into<Id>) -> Option<Dimension> {
        dimension(id.into(), self.units())
    }

    /// Zero of its levels.
    pub fn datum(&self) -> Option<Datum<'_>> {
        Some(Datum { name: self.text(Key::DatumName)?, base: self.number(Key::DatumBase)? })
    }

    /// The sea above the base, m, where it says so.
    pub fn sea(&self) -> Option<f64> {
        SEA.into_iter().find_map(|key| self.number(key))
    }

    /// What texts of its numbers are read against.
    pub fn frame(&self) -> Frame<'_> {
        Frame { units: self.units(), datum: self.datum(), sea: self.sea() }
    }

    /// Units and digits in which its answers are written.
    pub fn output(&self) -> OutputUnits {
        let named = [Key::OutputForce, Key::OutputPressure, Key::OutputLength];
        let digits = self.number(Key::OutputDigits).map(|digits| digits as usize);
        OutputUnits::from(self.extent()).with(named.map(|key| self.choice(key)), digits)
    }

    /// Extent of its numbers with units; `None` of a body in pure numbers, which have no units.
    pub fn units(&self) -> Option<Extent> {
        (!self.has(Table::Block)).then(|| self.extent())
    }

    /// The acceleration of gravity, m/s².
    pub fn gravity(&self) -> f64 {
        match self.get(Key::Gravity) {
            Some(Value::Number(gravity)) => *gravity,
            _ => GRAVITY,
        }
    }

    /// All numbers with their keys, in SI units: table by table, and load by load.
    pub fn numbers(&self) -> impl Iterator<Item = (Id, f64)> {
        self.values.iter().filter_map(|(id, _)| Some((*id, self.number(*id)?)))
    }
}

/// Keys that say how high the sea stands above the base.
pub(crate) const SEA: [Key; 4] = [Key::StillWaterLevel, Key::Level, Key::WaterRight, Key::BaseDepth];

/// Dimension of the numbers under a key in a case with such units.
pub fn dimension(id: Id, units: Option<Extent>) -> Option<Dimension> {
    let of_base = matches!(id.table, Table::BaseHorizontal | Table::BaseVertical | Table::BaseHorizontalZ);
    let dimension = match id.key.info().kind {
        Kind::Reached => of_base.then_some(Dimension::Acceleration),
        _ => id.key.info().dimension(),
    };
    Some(units?.of(dimension?))
}

/// Standard acceleration of gravity as engineers round it, m/s².
pub const GRAVITY: f64 = 9.81;
