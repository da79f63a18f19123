//! A plane of two numbers of a stack, as k and μ: where each combination of modes is the one reported.
//!
//! No closed form is known of all boundaries. Along a column of one k the frictions at which the answer changes are found by halving, to a
//! millionth of the plane; columns are added until what is straight between two of them is off by no more than a thousandth.

use super::{Stack, StackError};
use crate::mode::Mode;
use crate::region::{Curve, Strip};

/// Samples of a column, and columns to begin with.
const SAMPLES: usize = 33;
const COLUMNS: usize = 9;
/// How near a change is found, and how far a straight piece may be off it, as a share of the plane.
const NEAR: f64 = 1e-6;
const STRAIGHT: f64 = 1e-3;

/// Where a combination is the one reported.
#[derive(Debug, Clone, PartialEq)]
pub struct StackRegion {
    /// The mode of each joint, from the ground up.
    pub modes: Vec<Mode>,
    /// Its strips, from left to right.
    pub strips: Vec<Strip>,
}

/// A plane of a stack.
#[derive(Debug, Clone, PartialEq)]
pub struct StackPlane {
    /// Its regions; a combination has one each, of parts that need not hang together.
    pub regions: Vec<StackRegion>,
    /// Boundaries that stand upright: k, and the μ they run between.
    pub uprights: Vec<[f64; 3]>,
}

/// What is reported along one k: the μ up to which, and the modes.
#[derive(Debug, Clone, PartialEq)]
struct Column {
    k: f64,
    parts: Vec<(f64, Vec<Mode>)>,
}

impl Column {
    fn is_like(&self, other: &Column) -> bool {
        self.parts.len() == other.parts.len()
            && self.parts.iter().zip(&other.parts).all(|((_, one), (_, two))| one == two)
    }

    fn at(&self, mu: f64) -> &[Mode] {
        let part = self.parts.iter().find(|(to, _)| mu <= *to).or(self.parts.last());
        part.map_or(&[], |(_, modes)| modes)
    }
}

/// The plane 0 ≤ k ≤ `k`, 0 ≤ μ ≤ `mu` of the stacks that `stack` makes of k and μ, under their full loads.
///
/// # Errors
/// If one of them is no stack.
pub fn plane(stack: impl Fn(f64, f64) -> Stack, size: [f64; 2]) -> Result<StackPlane, StackError> {
    plane_of(|k, mu| Ok(stack(k, mu).answer(1.0)?.modes().to_vec()), size)
}

/// The plane 0 ≤ k ≤ `k`, 0 ≤ μ ≤ `mu` of the modes that `decide` gives.
///
/// # Errors
/// If it cannot decide.
pub(crate) fn plane_of<E>(
    decide: impl Fn(f64, f64) -> Result<Vec<Mode>, E>,
    [k, mu]: [f64; 2],
) -> Result<StackPlane, E> {
    let plane = Plane { decide: &decide, size: [k, mu] };
    let mut found = Found { regions: Vec::new(), uprights: Vec::new() };
    let columns = (0..COLUMNS).map(|place| plane.column(k * place as f64 / (COLUMNS - 1) as f64));
    let columns: Vec<Column> = columns.collect::<Result<_, _>>()?;
    for pair in columns.windows(2) {
        plane.between(&pair[0], &pair[1], &mut found)?;
    }
    Ok(StackPlane { regions: found.regions, uprights: found.uprights })
}

struct Plane<'a, F> {
    decide: &'a F,
    size: [f64; 2],
}

struct Found {
    regions: Vec<StackRegion>,
    uprights: Vec<[f64; 3]>,
}

impl<E, F: Fn(f64, f64) -> Result<Vec<Mode>, E>> Plane<'_, F> {
    fn modes(&self, k: f64, mu: f64) -> Result<Vec<Mode>, E> {
        (self.decide)(k, mu)
    }

    fn column(&self, k: f64) -> Result<Column, E> {
        let mu = self.size[1];
        let samples = (0..SAMPLES).map(|place| {
            // Off the axis and off round numbers, on which boundaries lie.
            let at = mu * (place as f64 + 0.001) / (SAMPLES - 1) as f64;
            Ok((at, self.modes(k, at)?))
        });
        let samples: Vec<(f64, Vec<Mode>)> = samples.collect::<Result<_, E>>()?;
        let mut parts: Vec<(f64, Vec<Mode>)> = Vec::new();
        for pair in samples.windows(2) {
            self.changes(k, &pair[0], &pair[1], &mut parts)?;
        }
        let last = samples.into_iter().next_back().map(|(_, modes)| modes).unwrap_or_default();
        parts.push((mu, last));
        Ok(Column { k, parts })
    }

    /// Adds where the modes change between two frictions.
    fn changes(
        &self,
        k: f64,
        low: &(f64, Vec<Mode>),
        high: &(f64, Vec<Mode>),
        parts: &mut Vec<(f64, Vec<Mode>)>,
    ) -> Result<(), E> {
        if low.1 == high.1 {
            return Ok(());
        }
        let middle = (low.0 + high.0) / 2.0;
        if high.0 - low.0 <= NEAR * self.size[1] {
            parts.push((middle, low.1.clone()));
            return Ok(());
        }
        let middle = (middle, self.modes(k, middle)?);
        self.changes(k, low, &middle, parts)?;
        self.changes(k, &middle, high, parts)
    }

    /// Adds what lies between two columns.
    fn between(&self, left: &Column, right: &Column, found: &mut Found) -> Result<(), E> {
        let [k, mu] = self.size;
        let middle = self.column((left.k + right.k) / 2.0)?;
        if left.is_like(right) && left.is_like(&middle) {
            let ends = left.parts.iter().zip(&right.parts).zip(&middle.parts);
            let off = ends.map(|(((l, _), (r, _)), (m, _))| ((l + r) / 2.0 - m).abs()).fold(0.0, f64::max);
            if off <= STRAIGHT * mu {
                found.straight(left, right);
                return Ok(());
            }
        }
        if right.k - left.k > NEAR * k {
            self.between(left, &middle, found)?;
            return self.between(&middle, right, found);
        }
        // The modes change here: each side is as its own column.
        found.straight(left, &Column { k: middle.k, ..left.clone() });
        found.straight(&Column { k: middle.k, ..right.clone() }, right);
        let mut levels: Vec<f64> = left.parts.iter().chain(&right.parts).map(|(to, _)| *to).collect();
        levels.push(0.0);
        levels.sort_by(f64::total_cmp);
        for pair in levels.windows(2) {
            let inside = (pair[0] + pair[1]) / 2.0;
            if pair[1] - pair[0] > STRAIGHT * mu && left.at(inside) != right.at(inside) {
                found.uprights.push([middle.k, pair[0], pair[1]]);
            }
        }
        Ok(())
    }
}

impl Found {
    /// Adds strips between two columns that are alike.
    fn straight(&mut self, left: &Column, right: &Column) {
        let line = |from: f64, to: f64| {
            let slope = (to - from) / (right.k - left.k);
            Curve::Line { slope, intercept: from - slope * left.k }
        };
        let mut lower = Curve::AXIS;
        for (place, ((l, modes), (r, _))) in left.parts.iter().zip(&right.parts).enumerate() {
            let upper = line(*l, *r);
            let is_open = place + 1 == left.parts.len();
            let strip = Strip { from: left.k, to: right.k, lower, upper: (!is_open).then_some(upper) };
            lower = upper;
            match self.regions.iter_mut().find(|region| region.modes == *modes) {
                Some(region) => region.strips.push(strip),
                None => self.regions.push(StackRegion { modes: modes.clone(), strips: vec![strip] }),
            }
        }
    }
}

impl StackPlane {
    /// The combination at a place, in floating point.
    pub fn at(&self, k: f64, mu: f64) -> Option<&[Mode]> {
        let is_there = |region: &&StackRegion| region.strips.iter().any(|strip| strip.contains(k, mu));
        self.regions.iter().find(is_there).map(|region| region.modes.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Joint, Shaking, StackBody};
    use super::*;
    use crate::contact::{Block, plane, solve};
    use crate::wrench::Wrench;

    /// A block in air under a force at half of its height above the centre: the report's γ = 2, k′ = ½.
    fn block(k: f64, mu: f64) -> Stack {
        let push = Wrench { x: -k, p: 1.0, m: k };
        Stack {
            bodies: vec![StackBody { y: 2.0, permanent: push, ..StackBody::of(1.0, 5.0 / 3.0) }],
            joints: vec![Joint { h: 0.0, l: -1.0, r: 1.0, mu_s: mu, mu_k: mu }],
            shaking: Shaking::default(),
        }
    }

    /// For one body the plane is that of the contact problem, in closed form.
    #[test]
    fn the_plane_of_one_body_is_the_report_s() {
        let found = super::plane(block, [1.5, 1.2]).unwrap();
        let (weight, force) = (Wrench { x: 0.0, p: 1.0, m: 0.0 }, Wrench { x: -1.0, p: 0.0, m: 1.0 });
        let regions = plane::regions(&Block::uniform(2.0, 0.3), &weight, &force, 1.5).unwrap();
        let mut seen = 0;
        for i in 0..60 {
            for j in 0..60 {
                let (k, mu) = (1.5 * (f64::from(i) + 0.37) / 60.0, 1.2 * (f64::from(j) + 0.41) / 60.0);
                // Not next to a boundary, from which a straight piece may be off.
                let inside = [-1.0, 1.0].into_iter().all(|side| {
                    let near = |k: f64, mu: f64| {
                        regions.iter().find(|region| region.contains(k, mu)).map(|r| r.mode)
                    };
                    near(k + 0.003 * side, mu) == near(k, mu) && near(k, mu + 0.003 * side) == near(k, mu)
                });
                if inside {
                    seen += 1;
                    let wrench = weight + force * k;
                    let mode = solve(&Block::uniform(2.0, mu), &wrench).unwrap().mode().unwrap();
                    assert_eq!(found.at(k, mu), Some(&[mode][..]), "{k} {mu}");
                }
            }
        }
        assert!(seen > 3000);
        // Its one upright boundary, between rest and rocking, is at 1/(γ (1 + k′)).
        assert_eq!(found.uprights.len(), 1, "{:?}", found.uprights);
        let [k, low, high] = found.uprights[0];
        assert!((k - 1.0 / 3.0).abs() < 1e-5 && (low - 1.0 / 3.0).abs() < 1e-4 && high == 1.2);
    }
}
