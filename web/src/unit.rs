//! Units of the fields. All quantities are per metre run of the body.

use standfast_figures::significant;

/// A unit: its name, and how many SI units it is.
pub type PageUnit = (&'static str, f64);

/// The units of a kind of quantity; the first is that of a new page.
pub const LENGTHS: [PageUnit; 3] = [("m", 1.0), ("cm", 0.01), ("mm", 0.001)];
/// Of a mass per metre run, kg/m.
pub const MASSES: [PageUnit; 2] = [("t/m", 1e3), ("kg/m", 1.0)];
/// Of a force per metre run, N/m.
pub const FORCES: [PageUnit; 3] = [("kN/m", 1e3), ("MN/m", 1e6), ("N/m", 1.0)];
/// Of a pressure, Pa.
pub const PRESSURES: [PageUnit; 2] = [("kPa", 1e3), ("Pa", 1.0)];

/// The units chosen, as places in the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Units {
    /// In [`LENGTHS`].
    pub length: usize,
    /// In [`MASSES`].
    pub mass: usize,
    /// In [`FORCES`].
    pub force: usize,
    /// In [`PRESSURES`].
    pub pressure: usize,
}

/// Chooses a unit for `length`, `mass`, `force` or `pressure`; what is unknown changes nothing.
pub fn choose(units: &mut Units, quantity: &str, unit: &str) {
    let (table, chosen): (&[PageUnit], _) = match quantity {
        "length" => (&LENGTHS, &mut units.length),
        "mass" => (&MASSES, &mut units.mass),
        "force" => (&FORCES, &mut units.force),
        "pressure" => (&PRESSURES, &mut units.pressure),
        _ => return,
    };
    if let Some(found) = table.iter().position(|(name, _)| *name == unit) {
        *chosen = found;
    }
}

/// A value as a field shows it: no more digits than were meant. It can be typed back.
pub fn plain(value: f64) -> String {
    let rounded = crate::state::round_digits(value, 7);
    let text = if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    };
    text.replace('-', "−")
}

/// A value as the panel shows it, in HTML.
pub fn shown(value: f64) -> String {
    significant(value, 4).replace("10^{", "10<sup>").replace('}', "</sup>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_shown_with_true_signs() {
        assert_eq!(shown(-0.123_456), "−0.1235");
        assert_eq!(shown(1.5e9), "1.5 × 10<sup>9</sup>");
        assert_eq!(shown(f64::INFINITY), "∞");
        assert_eq!([plain(0.1 + 0.2), plain(-0.55), plain(1e-9)], ["0.3", "−0.55", "1e−9"]);
    }

    #[test]
    fn an_unknown_unit_changes_nothing() {
        let mut units = Units::default();
        choose(&mut units, "length", "cm");
        choose(&mut units, "length", "furlong");
        choose(&mut units, "colour", "red");
        assert_eq!(units, Units { length: 1, ..Units::default() });
    }
}
