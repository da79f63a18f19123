//! The file of an office's code: what it fills in of a combination that the case does not write.
//!
//! A file serves many cases, so what it says of a word of the program that a case has no use for is left out. Any other word that the case
//! does not have is refused: it may be misspelt.

use standfast_inputs::CodeFile;

use crate::couple::Variable;
use crate::criteria::Criterion;
use crate::error::{Fault, Problem};
use crate::inputs::{Inputs, LoadFactor};
use crate::key::{Id, Key, Table, without_places};

use super::Resistance;
use super::backfill::of_all_layers;
use super::code::{Code, CodeLoad, Filled, NamedLoad};
use super::combination::{BEARING, ChangeBy, InputChange, PASSIVE, SLIDING, STRENGTHS, part_names};
use super::reader::Reader;

/// Loads that are there all the time, and the others, where the file does not name them one by one.
const KINDS: [&str; 2] = ["permanent", "variable"];

/// True if a name is that of a key, with its table or alone, wherever in a list.
fn is_of(id: Id, name: &str) -> bool {
    id.key.name() == name || without_places(&id.to_string()) == without_places(name)
}

/// A strength of the case, or of a soil of so many.
fn strengths(soils: usize) -> impl Iterator<Item = Id> {
    STRENGTHS.into_iter().flat_map(move |key| match key.info().table {
        Table::Soil => (0..soils).map(|soil| Id::of(Table::Backfill, soil, key)).collect(),
        _ => vec![Id::from(key)],
    })
}

/// The strengths of a case that a name means: of a name without places all of them.
fn strengths_called(inputs: &Inputs, name: &str) -> Vec<Id> {
    let is_there = |id: &Id| of_all_layers(inputs, *id).iter().any(|id| inputs.number(*id).is_some());
    let is_meant = |id: &Id| id.to_string() == name || !name.contains('[') && is_of(*id, name);
    strengths(inputs.count(Table::Backfill)).filter(|id| is_meant(id) && is_there(id)).collect()
}

impl Reader<'_> {
    /// What the file fills in of the combination whose `code` is at `at`, of a case whose loads have these names.
    pub(super) fn filled_by(
        &self,
        file: &CodeFile,
        at: Id,
        loads: Vec<NamedLoad>,
        names: &[&str],
        resistances: &[Resistance],
    ) -> Result<Filled, Fault> {
        let unknown = |key: Key, name: &str, names: Vec<String>| {
            let (file, name) = (file.name().into(), name.into());
            Fault::new(Problem::NameOfCode { file, key, name, names: names.into() }, at)
        };
        let (changes, of_resist) = (self.changes_by(file, at, unknown)?, file.ratios(Key::CombinationResist));
        let words = [SLIDING, BEARING, PASSIVE];
        let of = |name: &str| of_resist.iter().find(|(known, _)| known == name).map(|(_, by)| *by);
        let mut holds = Vec::new();
        for (name, by) in of_resist.iter().filter(|(name, _)| !words.contains(&name.as_str())) {
            if resistances.iter().all(|resistance| resistance.name != *name) {
                let known = resistances.iter().map(|resistance| resistance.name.as_str());
                let names = words.into_iter().chain(known).map(str::to_owned).collect();
                return Err(unknown(Key::CombinationResist, name, names));
            }
            holds.push((name.clone(), *by));
        }
        let output = self.inputs.output();
        let criteria = file.bounds().iter().map(|(key, bound)| {
            let criterion = Criterion::of(*key, bound, output).filter(|criterion| !criterion.is_chance());
            criterion.ok_or_else(|| Fault::new(Problem::CriterionOfAll { name: key.name() }, at))
        });
        Ok(Filled {
            code: Code::File(file.name().to_owned()),
            factors: factors(file, at, loads, names, unknown)?,
            changes,
            sliding: of(SLIDING),
            bearing: of(BEARING),
            passive: of(PASSIVE),
            ties: None,
            holds,
            criteria: criteria.collect::<Result<_, _>>()?,
        })
    }

    /// What it scales, and divides of strengths.
    fn changes_by(
        &self,
        file: &CodeFile,
        at: Id,
        unknown: impl Fn(Key, &str, Vec<String>) -> Fault,
    ) -> Result<Vec<InputChange>, Fault> {
        let mut changes = Vec::new();
        for (name, by) in file.ratios(Key::CombinationScale) {
            let found = self.key_called(name, Key::CombinationScale, |_| false);
            match found {
                Ok(id) if id.key.info().range().is_some() => {
                    changes.push(InputChange { id, name: id.to_string(), by: ChangeBy::Scale(*by) });
                }
                Ok(_) => return Err(Fault::new(Problem::NoNumber { name: name.clone() }, at)),
                Err(_) if numbers().any(|id| is_of(id, name)) => {}
                Err(_) => {
                    let names = Variable::all(self.inputs).map(|id| id.to_string()).collect();
                    return Err(unknown(Key::CombinationScale, name, names));
                }
            }
        }
        for (name, by) in file.ratios(Key::CombinationMaterials) {
            let found = strengths_called(self.inputs, name);
            if found.is_empty() && !strengths(1).any(|id| is_of(id, name)) {
                let names = strengths(1).map(|id| without_places(&id.to_string()));
                return Err(unknown(Key::CombinationMaterials, name, names.collect()));
            }
            let divided = found.into_iter().filter(|_| *by != 1.0);
            changes.extend(divided.map(|id| InputChange {
                id,
                name: id.to_string(),
                by: ChangeBy::Material(*by),
            }));
        }
        Ok(changes)
    }
}

/// The numbers that a case may have.
fn numbers() -> impl Iterator<Item = Id> {
    let ids = Table::ALL.into_iter().flat_map(|table| table.keys().map(move |key| Id::of(table, 0, key)));
    ids.filter(|id| id.key.info().range().is_some())
}

/// Its factors on loads of these names: of a load that it does not name those of its kind.
fn factors(
    file: &CodeFile,
    at: Id,
    loads: Vec<NamedLoad>,
    names: &[&str],
    unknown: impl Fn(Key, &str, Vec<String>) -> Fault,
) -> Result<Vec<(String, LoadFactor)>, Fault> {
    let given =
        |name: &str| file.factors().iter().find(|(known, _)| known == name).map(|(_, factor)| *factor);
    let [permanent, variable] = KINDS.map(given);
    let mut factors = Vec::new();
    for NamedLoad { name, kind } in loads {
        let of_kind = match kind {
            CodeLoad::Permanent | CodeLoad::Ground | CodeLoad::Water => permanent,
            CodeLoad::Variable | CodeLoad::ThroughGround => variable,
        };
        if let Some(factor) = given(&name).or(of_kind) {
            if name == "weight" && factor.all().contains(&0.0) {
                return Err(Fault::new(Problem::NoWeight, at));
            }
            factors.push((name, factor));
        }
    }
    let of_program = || {
        let of_table =
            |table: Table| table.in_combination().into_iter().chain(part_names(table).iter().copied());
        Table::ALL.into_iter().flat_map(of_table).chain(KINDS)
    };
    for (name, factor) in file.factors() {
        let is_new = factors.iter().all(|(known, _)| known != name);
        if names.contains(&name.as_str()) && is_new {
            factors.push((name.clone(), *factor));
        } else if is_new && !of_program().any(|word| word == name) {
            let names = of_program().chain(names.iter().copied()).map(str::to_owned);
            let mut once: Vec<String> = Vec::new();
            names.for_each(|name| {
                if !once.contains(&name) {
                    once.push(name)
                }
            });
            return Err(unknown(Key::LoadFactors, name, once));
        }
    }
    Ok(factors)
}
