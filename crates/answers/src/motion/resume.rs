//! A motion that goes on from a row of a series: the keys of `[motion.initial]` that the row stands for.

use standfast::{Corner, Mode, Slip};
use thiserror::Error;

use crate::inputs::{Inputs, Value};
use crate::key::{Key, Table};

/// Reason why a row of a series begins no motion.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ResumeError {
    /// A column is not there.
    #[error("it has no column {column}; expected a series of `standfast simulate`, with all of its columns")]
    NoColumn {
        /// Its name.
        column: &'static str,
    },
    /// A cell is no number.
    #[error("its {column} is \"{cell}\"; expected a number")]
    NoNumber {
        /// The column.
        column: &'static str,
        /// The cell.
        cell: String,
    },
    /// A cell is no state.
    #[error("its state is \"{cell}\"; expected the symbol of a mode, as RO or SRO-")]
    NoState {
        /// The cell.
        cell: String,
    },
    /// The row is one just before an event.
    #[error("it is just before an event; take the row below it, which is just after")]
    BeforeAnEvent,
    /// The body has overturned.
    #[error("the body has overturned there, and what comes after is not followed")]
    Overturned,
}

/// Puts a row of a series, each column with its cell, in the place of `[motion.initial]`.
///
/// # Errors
/// If the row is none of a series.
pub fn resume(inputs: &mut Inputs, row: &[(String, String)]) -> Result<(), ResumeError> {
    let cell = |column: &'static str| {
        let found = row.iter().find(|(name, _)| name == column);
        found.map(|(_, cell)| cell.trim()).ok_or(ResumeError::NoColumn { column })
    };
    let number = |column: &'static str| {
        let cell = cell(column)?;
        let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| ResumeError::NoNumber { column, cell: cell.to_owned() })
    };
    if cell("side").is_ok_and(|side| side.parse() == Ok(-1.0)) {
        return Err(ResumeError::BeforeAnEvent);
    }
    let state = cell("state")?;
    let mode: Mode = state.parse().map_err(|_| ResumeError::NoState { cell: state.to_owned() })?;
    let touching = match (mode, mode.corner()) {
        (Mode::Flight, _) => "none",
        (_, Some(Corner::O)) => "O",
        (_, Some(Corner::OPrime)) => "O'",
        (_, None) => "both",
    };
    let slip = match mode.slip() {
        None => "none",
        Some(Slip::Left) => "left",
        Some(Slip::Right) => "right",
    };
    let theta = number("theta")?;
    // A row is rounded where it is written by others.
    if theta.abs() >= std::f64::consts::FRAC_PI_2 - 1e-9 {
        return Err(ResumeError::Overturned);
    }
    let flies = mode == Mode::Flight;
    let mut numbers = vec![
        (Key::InitialTime, number("t")?),
        (Key::InitialX, number("x")?),
        (Key::InitialTheta, theta),
        (Key::InitialOmega, number("omega")?),
        (Key::InitialSlideO, number("slide_O")?),
        (Key::InitialSlideOPrime, number("slide_O'")?),
    ];
    // What follows from the corners that touch is left to them, so that it holds for a body a little other.
    if flies || mode.slip().is_some() {
        numbers.push((Key::InitialVx, number("vx")?));
    }
    if flies {
        let gap = number("gap_O")?.min(number("gap_O'")?).max(0.0);
        numbers.extend([(Key::InitialVy, number("vy")?), (Key::InitialGap, gap)]);
    }
    inputs.remove_tables(|table| table == Table::Initial);
    for table in [Table::Motion, Table::Initial] {
        if !inputs.has(table) {
            inputs.add_table(table);
        }
    }
    numbers.into_iter().for_each(|(key, number)| inputs.set(key, number));
    inputs.put(Key::InitialTouching.into(), Value::Choice(touching));
    inputs.put(Key::InitialSlip.into(), Value::Choice(slip));
    Ok(())
}
