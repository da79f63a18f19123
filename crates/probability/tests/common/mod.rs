//! A limit state that several tests ask for, and means over a normal.
#![allow(dead_code)]

use standfast_probability::problem::{Outcomes, Pieces};

/// Fails where a resistance, the first input, is below the sum of the others; the line is one of them.
pub struct Fails {
    pub line: usize,
}

impl Outcomes for Fails {
    fn count(&self) -> usize {
        1
    }
    fn line(&self) -> usize {
        self.line
    }
    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        let loads: f64 = (1..values.len()).filter(|i| *i != self.line).map(|i| values[i]).sum();
        match self.line {
            0 => pieces.push(f64::NEG_INFINITY, loads, 0),
            _ => pieces.push(values[0] - loads, f64::INFINITY, 0),
        }
    }
    fn at(&self, values: &[f64]) -> u64 {
        u64::from(values[0] < values[1..].iter().sum())
    }
}

/// ∫ φ(z) f(z) dz by the trapezoidal rule; no code of the crate.
pub fn mean(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / 256.0;
    let density = |z: f64| (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
    (-2304..=2304).map(|i| f64::from(i) * h).map(|z| h * density(z) * f(z)).sum()
}
