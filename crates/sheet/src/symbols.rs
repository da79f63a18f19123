//! Symbol of a quantity that the case file may give more than once: that of its key, with the number of its table where
//! there are several, so that each symbol of a sheet stands for one thing.

use standfast_cases::key::Table;
use standfast_cases::{Id, Inputs};

/// The symbol of the table at `index`, from zero, of `count` tables of one kind: `F`, or `F_2`; `x_F`, or `x_F2`.
pub fn numbered(symbol: &str, index: usize, count: usize) -> String {
    let below = if symbol.contains('_') { "" } else { "_" };
    if count > 1 { format!("{symbol}{below}{}", index + 1) } else { symbol.to_owned() }
}

/// A symbol of one of several places of the soil at `index` of `count` soils: `φ_e1`, or `φ_e2a` where there are several soils.
pub fn of_soil(symbol: &str, index: usize, count: usize, place: usize) -> String {
    match count {
        0 | 1 => format!("{symbol}{}", place + 1),
        _ => format!("{symbol}{}{}", index + 1, char::from(b'a' + (place % 26) as u8)),
    }
}

/// A symbol of the key of an input, with the number of its table where there are several.
pub fn of_input(symbol: &str, inputs: &Inputs, id: Id) -> String {
    let count = inputs.count(Table::Backfill);
    match id.table {
        Table::Backfill => numbered(symbol, id.index, count),
        Table::BackfillLayer => {
            let [soil, place] = id.table.places(id.index);
            match inputs.tables_in(id.table, soil).len() {
                1 => numbered(symbol, soil, count),
                _ => of_soil(symbol, soil, count, place),
            }
        }
        // The base is the first of them.
        Table::Joint => format!("{symbol}{}", id.table.number(id.index)),
        _ => numbered(symbol, id.index, inputs.count(id.key.info().table)),
    }
}

/// The symbol of a point, from zero, of the pressure at `index`: `q_1`, or `q_2a` where there are several pressures.
pub fn point(symbol: &str, index: usize, count: usize, point: usize) -> String {
    if count > 1 {
        let letter = char::from(b'a' + (point % 26) as u8);
        format!("{symbol}_{}{letter}", index + 1)
    } else {
        format!("{symbol}_{}", point + 1)
    }
}
