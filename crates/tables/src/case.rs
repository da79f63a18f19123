//! Rows that are cases: a case file, of which the columns of the table vary some numbers.

use std::fmt;
use std::sync::Arc;

use standfast_cases::couple::Variable;
use standfast_cases::key::Table;
use standfast_cases::results::{ResultKind, ResultValue};
use standfast_cases::suggest::{closest, key_meant};
use standfast_cases::sweep::{Factor, NoFactor, Sweep, SweepResult, heading};
use standfast_cases::units::ShownUnit;
use standfast_cases::{CaseError, CaseFile, Id};

use crate::results::{ColumnWords, FieldKind, NO_NAME, NO_WORD, ResultField, Values};
use crate::task::{Fault, Faults, RowFault};
use crate::{Interface, Mapping, TableError, TableOptions};

/// The case that the rows of a table vary, and what is computed of them.
#[derive(Debug, Clone)]
pub struct CaseTable {
    file: CaseFile,
    results: AskedResults,
}

/// The results that a table of cases has.
#[derive(Debug, Clone)]
enum AskedResults {
    /// All that the case has.
    All,
    /// Those that matter where nothing else is said.
    WhatMatters,
    /// These, in this order.
    These(Vec<SweepResult>),
}

impl CaseTable {
    /// A case with all its results.
    ///
    /// # Errors
    /// If the file's own values do not go together.
    pub fn of(file: CaseFile) -> Result<CaseTable, CaseError> {
        Sweep::of(&file, Vec::new())?;
        Ok(CaseTable { file, results: AskedResults::All })
    }

    /// The file that it is of.
    #[cfg(feature = "xlsx")]
    pub(crate) fn file(&self) -> &CaseFile {
        &self.file
    }

    /// Keeps these results only, in this order; all if there are none.
    #[must_use]
    pub fn with_results(self, results: Vec<SweepResult>) -> CaseTable {
        let results = if results.is_empty() { AskedResults::All } else { AskedResults::These(results) };
        CaseTable { results, ..self }
    }

    /// Keeps what matters: what happens, how near another answer is, and what the criteria ask for.
    #[must_use]
    pub fn with_what_matters(self) -> CaseTable {
        CaseTable { results: AskedResults::WhatMatters, ..self }
    }
}

/// Columns of a table that varied a case, and what went with them.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Varied {
    /// The columns and the keys that they vary.
    pub columns: Vec<VariedColumn>,
    /// Keys that went with them, in sentences.
    pub notes: Vec<String>,
    /// Warnings of columns that are likely to be slips.
    pub warnings: Vec<TableWarning>,
}

/// A column that varies a number of the case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VariedColumn {
    /// The column, as the table calls it.
    pub column: String,
    /// The key.
    pub key: String,
}

/// Warning of something possible in a table that may be a slip.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableWarning {
    /// A column that varies nothing has a name like that of a number of the case.
    ColumnLikeKey {
        /// The column.
        column: String,
        /// The key.
        key: String,
        /// The unit that the column has in round brackets, where it is one of the key.
        unit: Option<String>,
    },
    /// A column that varies nothing has the name of a number that the case file does not have.
    ColumnLikeAbsentKey {
        /// The column.
        column: String,
        /// The key.
        key: String,
    },
}

impl TableWarning {
    /// Its name, to be told apart by programs.
    pub fn name(&self) -> &'static str {
        match self {
            TableWarning::ColumnLikeKey { .. } | TableWarning::ColumnLikeAbsentKey { .. } => {
                "column-like-key"
            }
        }
    }

    /// Words of the warning for a caller of this interface; for none where columns have the names of keys only, and no option maps them.
    pub fn words(&self, interface: Option<Interface>) -> String {
        match self {
            TableWarning::ColumnLikeKey { column, key, unit } => {
                let how = how(column, key, unit.as_deref(), interface);
                format!("column {column} varies nothing; if it is meant to vary {key}, {how}")
            }
            TableWarning::ColumnLikeAbsentKey { column, key } => {
                format!(
                    "column {column} varies nothing: the case file has no {key}; if it is meant to vary, put it in, with any value \
                     it may have"
                )
            }
        }
    }
}

/// Advice on how to make a column vary a key: by its name, with the unit, or by an option.
fn how(column: &str, key: &str, unit: Option<&str>, interface: Option<Interface>) -> String {
    match (unit, interface) {
        (Some(unit), _) => format!("call it `{key} [{unit}]`"),
        (None, Some(interface)) => format!("say {}", interface.map(key, column)),
        (None, None) => format!("call it `{key}`"),
    }
}

impl fmt::Display for TableWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words(Some(Interface::Program)))
    }
}

/// Sweep and results of rows of a table of cases.
#[derive(Debug)]
pub(crate) struct CaseRows {
    sweep: Sweep,
    results: Vec<SweepResult>,
    situations: Arc<[String]>,
    varied: Varied,
    /// True if the case asks something of its results.
    has_criteria: bool,
    /// The units of the results, where a table has them in its headings and the numbers are not SI.
    units: Vec<Option<ShownUnit>>,
    /// True if a text may be a plain number.
    plain_texts: bool,
}

impl ResultField {
    /// Column of the faults of rows.
    pub(crate) const PROBLEM: ResultField = ResultField {
        name: "problem",
        kind: FieldKind::Text,
        said: Some(ColumnWords { unit: None, words: "what is wrong with a row that has no results" }),
        has_heading: false,
    };
}

impl CaseRows {
    /// The case of the options, varied by the columns `found`, and the places of those that vary it.
    pub(crate) fn of(
        options: &TableOptions,
        case: &CaseTable,
        found: &[String],
    ) -> Result<(CaseRows, Vec<usize>), TableError> {
        let columns = Search { options, case, found }.columns()?;
        let places: Vec<_> = columns.iter().map(|(place, _)| *place).collect();
        let factors: Vec<_> = columns.into_iter().map(|(_, factor)| factor).collect();
        let of_columns = places
            .iter()
            .zip(&factors)
            .map(|(place, factor)| VariedColumn { column: found[*place].clone(), key: factor.key() });
        let of_columns: Vec<_> = of_columns.collect();
        let sweep = Sweep::of(&case.file, factors).map_err(TableError::Case)?;
        let results = asked(&sweep, case, options.interface)?;
        let warnings = column_warnings(&case.file, found, &places);
        let varied = Varied { columns: of_columns, notes: sweep.notes(), warnings };
        let situations = sweep.situations().into();
        let has_criteria = !sweep.case().all_criteria().is_empty();
        let units = results.iter().map(|_| None).collect();
        let plain_texts = options.plain_texts;
        Ok((CaseRows { sweep, results, situations, varied, has_criteria, units, plain_texts }, places))
    }

    /// Writes results in the units of the case, which stand in the headings.
    pub(crate) fn in_units(self) -> CaseRows {
        let output = self.sweep.case().output;
        let unit = |result: &SweepResult| match result.kind() {
            ResultKind::Number(Some(dimension)) => Some(output.unit(dimension)),
            _ => None,
        };
        CaseRows { units: self.results.iter().map(unit).collect(), ..self }
    }

    /// Digits that the case asks for.
    #[cfg(feature = "xlsx")]
    pub(crate) fn digits(&self) -> Option<usize> {
        self.sweep.case().output.digits()
    }

    pub(crate) fn varied(&self) -> Varied {
        self.varied.clone()
    }

    /// Number of situations of a row.
    #[cfg(feature = "memory")]
    pub(crate) fn situations(&self) -> usize {
        self.situations.len()
    }

    /// The columns of the results.
    pub(crate) fn fields(&self) -> Vec<ResultField> {
        self.results.iter().zip(&self.units).map(|(result, unit)| self.field(*result, *unit)).collect()
    }

    fn field(&self, result: SweepResult, unit: Option<ShownUnit>) -> ResultField {
        let extent = self.sweep.case().extent;
        let has_heading = unit.is_some();
        let (kind, si) = match result.kind() {
            _ if result == SweepResult::Situation => (FieldKind::Name(self.situations.clone()), None),
            ResultKind::Number(dimension) => {
                (FieldKind::Number, dimension.map(|dimension| extent.of(dimension).si()))
            }
            ResultKind::Word(words) => (FieldKind::Word(words), None),
            ResultKind::Truth => (FieldKind::Flag, None),
            ResultKind::Modes => (FieldKind::Modes, None),
            ResultKind::Names => (FieldKind::Text, None),
        };
        let unit = unit.map(ShownUnit::name).or(si);
        let said = Some(ColumnWords { unit, words: result.words() });
        ResultField { name: result.name(), kind, said, has_heading }
    }

    /// The value that a text in a column says, or what is wrong with it.
    pub(crate) fn read(&self, place: usize, text: &str) -> Result<f64, String> {
        let factor = &self.sweep.factors()[place];
        let (text, number) = text.strip_prefix(NUMBER).map_or((text, false), |number| (number, true));
        if !number && !self.plain_texts && text.trim().parse::<f64>().is_ok() {
            return Err(format!("it is a text without a unit; expected {}", factor.expected()));
        }
        factor.read(text).map_err(|error| format!("{error}; expected {}", factor.expected()))
    }

    /// The value that a number in a column stands for, or what is wrong with it.
    #[cfg(feature = "memory")]
    pub(crate) fn value(&self, place: usize, number: f64) -> Result<f64, String> {
        let factor = &self.sweep.factors()[place];
        factor.value(number).map_err(|error| format!("{error}; expected {}", factor.expected()))
    }

    /// The unit that numbers in a column are in, where that is not the one of their values.
    #[cfg(feature = "columnar")]
    pub(crate) fn unit(&self, place: usize) -> Option<standfast_cases::units::Unit> {
        self.sweep.factors()[place].unit()
    }

    /// The results of rows; those marked in `skip` get none.
    pub(crate) fn answer(&self, columns: &[&[f64]], skip: &[bool], faults: &mut Faults) -> Vec<Values> {
        let rows = columns[0].len();
        let fields = self.fields().into_iter().map(|field| field.kind);
        let mut values: Vec<_> = fields.map(|kind| Values::empty(&kind, rows)).collect();
        let mut scratch = self.sweep.scratch();
        let mut row_values = vec![0.0; columns.len()];
        for row in 0..rows {
            let answer = if skip.get(row) == Some(&true) {
                None
            } else {
                row_values.iter_mut().zip(columns).for_each(|(value, column)| *value = column[row]);
                let answer = self.sweep.answer(&mut scratch, &row_values);
                let blame = |fault: standfast_cases::Fault| {
                    let columns = match self.sweep.blamed(&fault) {
                        none if none.is_empty() => (0..columns.len()).collect(),
                        some => some,
                    };
                    faults.add(Fault { row, wrong: RowFault::Case { columns, problem: fault.to_string() } });
                };
                answer.map_err(blame).ok()
            };
            let warnings = answer.as_ref().map(standfast_cases::sweep::Answer::warnings).unwrap_or_default();
            for (place, warning) in warnings.iter().enumerate() {
                if warnings[..place].iter().all(|other| other.name() != warning.name()) {
                    faults.minded.warnings.add(warning.name(), row, || warning.to_string());
                }
            }
            if let Some(answer) = answer.as_ref().filter(|_| self.has_criteria) {
                faults.minded.check(answer.assessment(), row);
            }
            for ((values, result), unit) in values.iter_mut().zip(&self.results).zip(&self.units) {
                if let Values::Text(texts) = values {
                    texts.push(answer.as_ref().and_then(|answer| answer.names(*result, &warnings)));
                    continue;
                }
                let value = answer.as_ref().map_or(ResultValue::Nothing, |answer| answer.get(*result));
                push(values, in_unit(value, *unit));
            }
        }
        values
    }
}

/// Stands before what was a number in a column of texts and numbers, where texts have their units.
pub const NUMBER: char = '\u{1}';

/// A number in a unit.
fn in_unit(value: ResultValue, unit: Option<ShownUnit>) -> ResultValue {
    match (value, unit) {
        (ResultValue::Number(si), Some(unit)) => ResultValue::Number(unit.of_si(si)),
        (value, _) => value,
    }
}

/// Appends the value of a row.
fn push(values: &mut Values, value: ResultValue) {
    match (values, value) {
        (Values::Number(numbers), ResultValue::Number(number)) => numbers.push(number),
        (Values::Number(numbers), _) => numbers.push(f64::NAN),
        (Values::Word(words, codes), ResultValue::Word(word)) => {
            let place = words.iter().position(|known| *known == word);
            codes.push(place.and_then(|place| u8::try_from(place).ok()).unwrap_or(NO_WORD));
        }
        (Values::Word(_, codes), _) => codes.push(NO_WORD),
        // Situations are told by their place.
        (Values::Name(_, places), ResultValue::Number(place)) => places.push(place as u32),
        (Values::Name(_, places), _) => places.push(NO_NAME),
        (Values::Flag(flags), ResultValue::Truth(truth)) => flags.push(Some(truth)),
        (Values::Flag(flags), _) => flags.push(None),
        (Values::Modes(sets), ResultValue::Modes(modes)) => sets.push(Some(modes)),
        (Values::Modes(sets), _) => sets.push(None),
        (Values::Text(_), _) => unreachable!("texts are made of the answer"),
    }
}

/// The results asked for, or all that the case has.
fn asked(sweep: &Sweep, case: &CaseTable, interface: Interface) -> Result<Vec<SweepResult>, TableError> {
    let all = sweep.results();
    let criteria = sweep.case().all_criteria();
    let these = match &case.results {
        AskedResults::All => {
            return Ok(all.into_iter().filter(|result| !result.is_by_name(&criteria)).collect());
        }
        AskedResults::WhatMatters => {
            return Ok(all.into_iter().filter(|result| result.matters(&criteria)).collect());
        }
        AskedResults::These(these) => these,
    };
    for (i, result) in these.iter().enumerate() {
        if !all.contains(result) {
            let results = all.iter().map(|result| result.name()).collect();
            let option = interface.columns();
            return Err(TableError::NoSuchResult { option, column: result.name().to_owned(), results });
        }
        if these[..i].contains(result) {
            return Err(TableError::ResultTwice { option: interface.columns(), column: result.name() });
        }
    }
    Ok(these.clone())
}

/// Looks for the columns that vary the case.
struct Search<'a> {
    options: &'a TableOptions,
    case: &'a CaseTable,
    found: &'a [String],
}

impl Search<'_> {
    fn interface(&self) -> Interface {
        self.options.interface
    }

    /// The columns that vary the case, by their places, and what they vary.
    fn columns(&self) -> Result<Vec<(usize, Factor)>, TableError> {
        self.check_map()?;
        let mut columns: Vec<(usize, Factor)> = Vec::new();
        for (place, column) in self.found.iter().enumerate() {
            let Some(factor) = self.factor(column)? else { continue };
            let key = factor.key();
            if let Some((earlier, _)) = columns.iter().find(|(_, factor)| factor.key() == key) {
                return Err(TableError::SameKey {
                    name: self.options.name.clone(),
                    one: self.found[*earlier].clone(),
                    two: column.clone(),
                    key,
                });
            }
            columns.push((place, factor));
        }
        if columns.is_empty() {
            let Search { options, case, found } = self;
            return Err(nothing_varies(&options.name, &case.file, found, Some(self.interface())));
        }
        Ok(columns)
    }

    /// Factor that a column varies, if any.
    fn factor(&self, column: &str) -> Result<Option<Factor>, TableError> {
        let (bare, unit) = heading(column);
        let mapped =
            self.options.map.iter().find(|mapping| mapping.theirs == column || mapping.theirs == bare);
        // Columns that have our name are others where one is mapped to it.
        let taken = self.options.map.iter().any(|mapping| mapping.ours == bare);
        let ours = match mapped {
            Some(mapping) => &mapping.ours,
            None if taken => return Ok(None),
            None => bare,
        };
        match Factor::find(ours, unit, self.case.file.inputs()) {
            Ok(factor) => Ok(Some(factor)),
            // A column may be called anything, but for what begins like a key.
            Err(NoFactor::Unknown(_)) if mapped.is_none() && !begins_like_key(bare) => Ok(None),
            Err(error) => {
                let name = self.options.name.clone();
                Err(TableError::NoFactor { name, column: column.to_owned(), error: Box::new(error) })
            }
        }
    }

    fn check_map(&self) -> Result<(), TableError> {
        let mut taken: Vec<(&String, &Mapping)> = Vec::new();
        for (i, mapping) in self.options.map.iter().enumerate() {
            if self.options.map[..i].iter().any(|earlier| earlier.ours == mapping.ours) {
                return Err(TableError::MapTwice { ours: mapping.ours.clone() });
            }
            let is_it = |column: &&String| **column == mapping.theirs || heading(column).0 == mapping.theirs;
            let fits: Vec<_> = self.found.iter().filter(is_it).collect();
            match fits[..] {
                [column] => {
                    if let Some((_, earlier)) = taken.iter().find(|(other, _)| *other == column) {
                        return Err(TableError::OneColumn {
                            name: self.options.name.clone(),
                            column: column.clone(),
                            one: earlier.ours.clone(),
                            two: mapping.ours.clone(),
                        });
                    }
                    taken.push((column, mapping));
                }
                [] => {
                    let nearest = closest(&mapping.theirs, self.found.iter().map(String::as_str));
                    return Err(TableError::MissingColumn {
                        name: self.options.name.clone(),
                        column: mapping.theirs.clone(),
                        found: self.found.join(", "),
                        help: nearest.map_or_else(
                            || {
                                format!(
                                    "{} is to name a column of the table",
                                    self.interface().map(&mapping.ours, "…")
                                )
                            },
                            |nearest| {
                                let said = self.interface().map(&mapping.ours, nearest);
                                format!("did you mean `{nearest}`? then say {said}")
                            },
                        ),
                    });
                }
                _ => {
                    let (name, column) = (self.options.name.clone(), mapping.theirs.clone());
                    return Err(TableError::TwoColumns { name, column });
                }
            }
        }
        Ok(())
    }
}

/// The error of a table none of whose columns varies the case, with advice; see [`TableWarning::words`] for the interface.
pub(crate) fn nothing_varies(
    name: &str,
    file: &CaseFile,
    found: &[String],
    interface: Option<Interface>,
) -> TableError {
    let near = column_warnings(file, found, &[]).into_iter().next();
    // Factors on loads vary with cases at rest.
    let is_own = |name: &String| interface.is_some() || !name.starts_with("bias.");
    let keys = Factor::names(file.inputs()).into_iter().filter(is_own).collect::<Vec<_>>().join(", ");
    let meant = match near {
        None => {
            let or = interface.map(|interface| format!(", or say {}", interface.map("KEY", "COLUMN")));
            format!("a column varies the number whose key it is called by{}", or.unwrap_or_default())
        }
        Some(TableWarning::ColumnLikeKey { column, key, unit }) => {
            format!("did you mean `{key}`? then {}", how(&column, &key, unit.as_deref(), interface))
        }
        Some(TableWarning::ColumnLikeAbsentKey { key, .. }) => {
            format!("`{key}` is not in the case file: put it in, with any value it may have")
        }
    };
    let help = format!("{meant}; the numbers of the case that can vary are {keys}");
    TableError::NothingVaries { name: name.to_owned(), found: found.join(", "), help }
}

/// True if a name begins as the keys of a table of case files do.
fn begins_like_key(column: &str) -> bool {
    let table = column.split_once(['.', '[']).map(|(table, _)| table);
    let of_top = |known: &Table| known.parent() == Some(Table::Top);
    let known =
        |table: &str| Table::ALL.iter().filter(|table| of_top(table)).any(|known| known.name() == table);
    // Factors on loads, which stand in no table of a case.
    table.is_some_and(|table| table == "bias" || known(table))
}

/// Columns that vary nothing and have almost the name of a number of the case, or that of its last part; or the name of one that the
/// file does not have.
pub fn column_warnings(file: &CaseFile, found: &[String], places: &[usize]) -> Vec<TableWarning> {
    let inputs = file.inputs();
    let ids: Vec<Id> = Variable::all(inputs).collect();
    let keys: Vec<String> = ids.iter().map(ToString::to_string).collect();
    let all = Factor::names(inputs);
    let last = |key: &str| key.rsplit_once('.').map_or(key, |(_, last)| last).to_owned();
    let lasts: Vec<String> = keys.iter().map(|key| last(key)).collect();
    let others = found.iter().enumerate().filter(|(place, _)| !places.contains(place));
    others
        .filter_map(|(_, column)| {
            let (bare, unit) = in_round_brackets(column).unwrap_or((heading(column).0, None));
            let bare = bare.trim();
            // "hmax" is Hmax, not h.
            let same =
                |names: &[String]| names.iter().position(|name| name.to_lowercase() == bare.to_lowercase());
            let place_in = |names: &[String]| {
                let found = closest(bare, names.iter().map(String::as_str))?;
                names.iter().position(|name| name == found)
            };
            let exact = same(&lasts).or_else(|| same(&keys));
            if exact.is_none() {
                // Keys that have no value in the case file, and a silent one, vary all the same.
                let silent = ids.len()..all.len();
                if let Some(place) =
                    silent.into_iter().find(|place| all[*place].to_lowercase() == bare.to_lowercase())
                {
                    let (column, key) = (column.clone(), all[place].clone());
                    return Some(TableWarning::ColumnLikeKey { column, key, unit: None });
                }
                if let Some(key) = Factor::absent(key_meant(bare).unwrap_or(bare), inputs) {
                    return Some(TableWarning::ColumnLikeAbsentKey { column: column.clone(), key });
                }
            }
            let meant = || lasts.iter().position(|last| key_meant(bare) == Some(last));
            let place = exact.or_else(meant).or_else(|| place_in(&lasts)).or_else(|| place_in(&keys))?;
            let dimension = Variable::of(ids[place], inputs).dimension();
            let unit = unit.filter(|unit| dimension.is_some_and(|dimension| dimension.unit(unit).is_some()));
            let (column, key) = (column.clone(), keys[place].clone());
            Some(TableWarning::ColumnLikeKey { column, key, unit: unit.map(str::to_owned) })
        })
        .collect()
}

/// A column's name, and what stands in round brackets behind it.
fn in_round_brackets(column: &str) -> Option<(&str, Option<&str>)> {
    let (name, unit) = column.trim_end().strip_suffix(')')?.rsplit_once('(')?;
    Some((name.trim_end(), Some(unit.trim())))
}
