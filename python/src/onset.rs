//! The columns of an onset that are asked for.

use pyo3::prelude::*;
use standfast::batch::{MOTION, OnsetColumns};

use crate::errors::StandfastError;

/// Code of no mode, in an array of codes where a point has no answer.
pub(crate) const NO_MODE: u8 = u8::MAX;

/// A column that is asked for, by its name.
#[derive(Debug, Clone, Copy, PartialEq)]
enum OnsetColumn {
    Mode,
    Unique,
    Others,
    /// By its place among those of the motion.
    Motion(usize),
}

impl OnsetColumn {
    fn all() -> impl Iterator<Item = OnsetColumn> {
        [OnsetColumn::Mode, OnsetColumn::Unique, OnsetColumn::Others]
            .into_iter()
            .chain((0..MOTION.len()).map(OnsetColumn::Motion))
    }

    fn name(self) -> &'static str {
        match self {
            OnsetColumn::Mode => "mode",
            OnsetColumn::Unique => "unique",
            OnsetColumn::Others => "others",
            OnsetColumn::Motion(place) => MOTION[place],
        }
    }
}

/// The columns asked for, in that order; each once.
pub(crate) struct Choice(Vec<OnsetColumn>);

impl<'py> FromPyObject<'_, 'py> for Choice {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Choice> {
        let names: Vec<String> = given.extract()?;
        let mut choice = Vec::new();
        for name in &names {
            let found = OnsetColumn::all().find(|asked| asked.name() == name).ok_or_else(|| {
                let all: Vec<&str> = OnsetColumn::all().map(OnsetColumn::name).collect();
                StandfastError::new_err(format!("columns has {name:?}; expected {}", all.join(", ")))
            })?;
            if choice.contains(&found) {
                return Err(StandfastError::new_err(format!("columns has {name:?} twice; expected it once")));
            }
            choice.push(found);
        }
        Ok(Choice(choice))
    }
}

impl Choice {
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> {
        self.0.iter().map(|asked| asked.name())
    }
}

/// Memory for the columns asked for.
pub(crate) struct Onset {
    mode: Option<Vec<u8>>,
    unique: Option<Vec<bool>>,
    others: Option<Vec<u16>>,
    motion: [Option<Vec<f64>>; 9],
}

/// A column of answers.
pub(crate) enum Column {
    Mode(Vec<u8>),
    Unique(Vec<bool>),
    Others(Vec<u16>),
    Motion(Vec<f64>),
}

impl Onset {
    pub(crate) fn new(Choice(asked): &Choice, length: usize) -> Onset {
        let motion = std::array::from_fn(|place| {
            asked.contains(&OnsetColumn::Motion(place)).then(|| vec![0.0; length])
        });
        Onset {
            mode: asked.contains(&OnsetColumn::Mode).then(|| vec![0; length]),
            unique: asked.contains(&OnsetColumn::Unique).then(|| vec![false; length]),
            others: asked.contains(&OnsetColumn::Others).then(|| vec![0; length]),
            motion,
        }
    }

    pub(crate) fn columns(&mut self) -> OnsetColumns<'_> {
        OnsetColumns {
            mode: self.mode.as_deref_mut(),
            unique: self.unique.as_deref_mut(),
            others: self.others.as_deref_mut(),
            motion: self.motion.each_mut().map(Option::as_deref_mut),
            ..OnsetColumns::default()
        }
    }

    /// Puts what is none of the answers where a point has no answer, and false and 0 where there is nothing like that.
    pub(crate) fn blank(&mut self, missing: &[bool]) {
        fn put<T: Copy>(column: Option<&mut [T]>, missing: &[bool], blank: T) {
            let places = column.into_iter().flatten().zip(missing).filter(|(_, missing)| **missing);
            places.for_each(|(value, _)| *value = blank);
        }
        let OnsetColumns { mode, unique, others, motion, .. } = self.columns();
        put(mode, missing, NO_MODE);
        put(unique, missing, false);
        put(others, missing, 0);
        motion.into_iter().for_each(|column| put(column, missing, f64::NAN));
    }

    /// The columns in the order in which they are asked for.
    pub(crate) fn in_order(mut self, Choice(asked): &Choice) -> impl Iterator<Item = Column> {
        asked.iter().map(move |asked| {
            let column = match asked {
                OnsetColumn::Mode => self.mode.take().map(Column::Mode),
                OnsetColumn::Unique => self.unique.take().map(Column::Unique),
                OnsetColumn::Others => self.others.take().map(Column::Others),
                OnsetColumn::Motion(place) => self.motion[*place].take().map(Column::Motion),
            };
            column.expect("a column that is asked for once")
        })
    }
}
