//! The columns a table has to have, and where they are.

use crate::problem::Column;
use crate::{ResultColumn, TableError, TableOptions};
use standfast_cases::suggest::{closest, similar};

/// One of our columns and the name it has in the table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mapping {
    /// Our name.
    pub ours: String,
    /// The table's.
    pub theirs: String,
}

impl std::str::FromStr for Mapping {
    type Err = String;

    fn from_str(text: &str) -> Result<Mapping, String> {
        let parts = text.split_once('=').map(|(ours, theirs)| (ours.trim(), theirs.trim()));
        match parts {
            Some((ours, theirs)) if !ours.is_empty() && !theirs.is_empty() => {
                Ok(Mapping { ours: ours.to_owned(), theirs: theirs.to_owned() })
            }
            _ => Err("expected our name and the table's, as in mu=friction".to_owned()),
        }
    }
}

impl TableOptions {
    /// Words for the columns that a table has to have.
    pub(crate) fn needed(&self) -> String {
        match &self.case {
            Some(_) => "one that varies the case".to_owned(),
            None => self.problem.needed(),
        }
    }

    /// Places of the problem's columns in a table with the columns `found`, in the problem's order; behind them those
    /// of the optional ones that it has.
    pub(crate) fn places(&self, found: &[String]) -> Result<Vec<usize>, TableError> {
        let name = || self.name.clone();
        let columns = self.problem.columns();
        let optional = self.problem.optional();
        let ours = || columns.iter().chain(optional).map(|column| column.name);
        for (i, Mapping { ours: our, .. }) in self.map.iter().enumerate() {
            if !ours().any(|name| name == our) {
                let suggestion = closest(our, ours()).map(str::to_owned);
                let needed = self.problem.needed();
                return Err(TableError::MapUnknown { ours: our.clone(), suggestion, needed });
            }
            if self.map[..i].iter().any(|earlier| earlier.ours == *our) {
                return Err(TableError::MapTwice { ours: our.clone() });
            }
        }
        let place = |column: &Column| {
            let mapped = self.map.iter().find(|mapping| mapping.ours == column.name);
            let wanted = mapped.map_or(column.name, |mapping| &mapping.theirs);
            let mut matches = found.iter().enumerate().filter(|(_, found)| *found == wanted);
            match (matches.next(), matches.next()) {
                (Some((place, _)), None) => Ok(place),
                (Some(_), Some(_)) => Err(TableError::TwoColumns { name: name(), column: wanted.to_owned() }),
                (None, _) => {
                    let found_names: Vec<&str> = found.iter().map(String::as_str).collect();
                    let meant = match mapped {
                        None => similar(column.name, &found_names, &ours().collect::<Vec<_>>()),
                        Some(_) => closest(wanted, found_names),
                    };
                    let help = meant.map_or_else(
                        || format!("the columns needed are {}, in any order", self.problem.needed()),
                        |found| {
                            format!(
                                "did you mean `{found}`? then say {}",
                                self.interface.map(column.name, found)
                            )
                        },
                    );
                    let column = wanted.to_owned();
                    Err(TableError::MissingColumn { name: name(), column, found: found.join(", "), help })
                }
            }
        };
        // The optional ones are in the order of their places, and there is one at most.
        let is_there = |column: &&Column| {
            let is_mapped = self.map.iter().any(|mapping| mapping.ours == column.name);
            is_mapped || found.iter().any(|found| found == column.name)
        };
        columns.iter().chain(optional.iter().filter(is_there)).map(place).collect()
    }

    /// Advice on how to say that an optional column of points is meant, if one was taken because of its name alone.
    pub(crate) fn omega_by_name(&self, places: &[usize]) -> Option<String> {
        let optional =
            self.problem.optional().first().filter(|_| places.len() > self.problem.columns().len())?;
        let is_said = self.map.iter().any(|mapping| mapping.ours == optional.name);
        (!is_said).then(|| self.interface.map(optional.name, optional.name))
    }

    /// Results to compute: the columns asked for, or all of the problem.
    pub(crate) fn results(&self) -> Result<Vec<ResultColumn>, TableError> {
        let all = self.problem.results();
        for (i, column) in self.columns.iter().enumerate() {
            if !all.contains(column) {
                let results = all.iter().map(|column| column.name()).collect();
                let option = self.interface.columns();
                return Err(TableError::NoSuchResult { option, column: column.name().to_owned(), results });
            }
            if self.columns[..i].contains(column) {
                return Err(TableError::ResultTwice {
                    option: self.interface.columns(),
                    column: column.name(),
                });
            }
        }
        Ok(if self.columns.is_empty() { all.to_vec() } else { self.columns.clone() })
    }
}
