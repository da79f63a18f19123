//! A table of synthetic sea states for Goda's caisson: any number of storms, the same in every run.
//!
//! Illustrative numbers, not a climate: deep-water heights of 3 m and more by Weibull's distribution, periods that go with them, a
//! tide of 0.8 m about the level of the example, directions about that of the example.

use std::f64::consts::TAU;
use std::fmt::Write as _;

/// The names of the columns: a storm, and keys of `examples/goda-2000.toml`.
const HEADER: &str = "storm,wave.deep_water_height [m],wave.period [s],water_level [m],wave.angle_deg\n";

/// The first `count` sea states as CSV.
pub fn table(count: usize) -> String {
    let mut random = random();
    let mut text = HEADER.to_owned();
    for storm in 1..=count {
        let height = 3.0 + 1.6 * (-random().ln()).powf(1.0 / 1.3);
        // Periods scatter as far as steepness leaves them open.
        let period = 4.3 * height.sqrt() * (0.9 + 0.2 * random());
        let level = 7.1 + 0.8 * (TAU * random()).sin();
        let angle = (15.0 + 40.0 * (random() - 0.5)).abs();
        // Writing to memory never fails.
        let _ = writeln!(text, "{storm},{height:.2},{period:.1},{level:.2},{angle:.0}");
    }
    text
}

/// Numbers above 0 up to 1.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_example_is_the_beginning_of_the_table() {
        let example = include_str!("../../examples/sea-states.csv");
        assert_eq!(example, super::table(100));
        assert!(super::table(2000).starts_with(example));
    }
}
