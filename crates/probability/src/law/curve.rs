//! A law known by some of its values: between them a cubic of each that rises as they do, over the standard normal.

use super::LawError;
use crate::roots::where_met;

/// Values over the normals that belong to them, both rising, and the slope at each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    normals: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

impl Curve {
    /// The curve through values that are moved and stretched.
    pub(super) fn mapped(&self, of: impl Fn(f64) -> f64) -> Option<Curve> {
        let values: Vec<f64> = self.values.iter().copied().map(of).collect();
        Curve::new(&self.normals, &values).ok()
    }

    pub(super) fn new(normals: &[f64], values: &[f64]) -> Result<Curve, LawError> {
        let fault = |fault: String| Err(LawError::List { law: "quantiles", fault });
        let n = values.len();
        if n < 2 || normals.len() != n {
            return fault(format!("{n} values for {} places; expected two or more of each", normals.len()));
        }
        for (what, list) in [("places", normals), ("values", values)] {
            let is_finite = list.iter().all(|x| x.is_finite());
            if let Some(pair) = list.windows(2).find(|pair| pair[0] >= pair[1] || !is_finite) {
                return fault(format!(
                    "{what} {} and {} follow each other; expected numbers that rise",
                    pair[0], pair[1]
                ));
            }
        }
        let step = |i: usize| normals[i + 1] - normals[i];
        let secant = |i: usize| (values[i + 1] - values[i]) / step(i);
        // The slope of the parabola through three points, but never so steep that the cubic turns (Hyman 1983).
        let slopes = (0..n).map(|i| match i {
            0 => secant(0),
            i if i == n - 1 => secant(n - 2),
            i => {
                let [before, after] = [secant(i - 1), secant(i)];
                let parabola = (before * step(i) + after * step(i - 1)) / (step(i - 1) + step(i));
                parabola.min(3.0 * before.min(after))
            }
        });
        Ok(Curve { slopes: slopes.collect(), normals: normals.to_vec(), values: values.to_vec() })
    }

    /// The value of a standard normal; beyond the ends along a straight line.
    pub(super) fn value(&self, z: f64) -> f64 {
        let last = self.normals.len() - 1;
        let end = if z <= self.normals[0] { Some(0) } else { (z >= self.normals[last]).then_some(last) };
        match end {
            Some(end) => self.values[end] + self.slopes[end] * (z - self.normals[end]),
            None => self.between(self.normals.partition_point(|normal| *normal <= z) - 1, z),
        }
    }

    fn between(&self, i: usize, z: f64) -> f64 {
        let width = self.normals[i + 1] - self.normals[i];
        let (t, rise) = ((z - self.normals[i]) / width, self.values[i + 1] - self.values[i]);
        let (from, to) = (self.slopes[i] * width, self.slopes[i + 1] * width);
        // Hermite's cubic, by what it departs from its chord.
        self.values[i] + t * rise + t * (1.0 - t) * ((1.0 - t) * (from - rise) - t * (to - rise))
    }

    /// The standard normal of a value.
    pub(super) fn z(&self, x: f64) -> f64 {
        let last = self.values.len() - 1;
        let end = if x <= self.values[0] { Some(0) } else { (x >= self.values[last]).then_some(last) };
        match end {
            Some(end) => self.normals[end] + (x - self.values[end]) / self.slopes[end],
            None => {
                let i = self.values.partition_point(|value| *value <= x) - 1;
                where_met(self.normals[i], self.normals[i + 1], |z| self.between(i, z) - x)
            }
        }
    }
}
