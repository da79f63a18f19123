//! Symbol of a quantity that the case file may give more than once: that of its key, with the number of its table where
//! there are several, so that each symbol of a sheet stands for one thing.

/// The symbol of the table at `index`, from zero, of `count` tables of one kind: `F`, or `F_2`; `x_F`, or `x_F2`.
pub fn numbered(symbol: &str, index: usize, count: usize) -> String {
    let below = if symbol.contains('_') { "" } else { "_" };
    if count > 1 { format!("{symbol}{below}{}", index + 1) } else { symbol.to_owned() }
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
