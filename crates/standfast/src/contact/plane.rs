//! The plane of load factor λ and friction μ of any block: which mode holds where, from the block's own boundaries.
//!
//! For a uniform block under one force this is the report's k–μ plane with λ for k. In general the wrench turns as the
//! load grows, and no single (γ, k') describes it; but every condition is linear in the wrench and in μ, so every
//! boundary is a line or a hyperbola
//!
//! ```text
//! (α₀ + α₁λ) + μ (β₀ + β₁λ) = 0
//! ```
//!
//! or a vertical. Their crossings cut the plane into strips; between neighbouring curves of a strip the mode is constant
//! and is decided exactly, at one point. A strip narrower than 1e-9 of the range, where crossings coincide up to rounding,
//! is joined to its neighbour, and boundaries whose coefficients differ by less than 3e-7 of their size are taken as one: this
//! is a picture's precision, not that of a mode.

use super::conditions::{COUNT, conditions};
use super::{Block, numbers, solve, with_friction};
use crate::error::InputError;
use crate::mode::Mode;
use crate::polynomial::quadratic_roots;
use crate::quantity::Quantity;
use crate::region::{Curve, Region, Strip};
use crate::wrench::Wrench;

/// A boundary (α₀ + α₁λ) + μ (β₀ + β₁λ) = 0.
#[derive(Clone, Copy)]
struct Boundary {
    alpha: [f64; 2],
    beta: [f64; 2],
}

/// A mode between two neighbouring boundaries of a strip.
#[derive(Clone, Copy)]
struct Cell {
    mode: Mode,
    strip: Strip,
}

/// The regions of the plane 0 ≤ λ ≤ `up_to`, μ ≥ 0 for a load that grows as `permanent` + λ `variable`.
///
/// μ is the friction to stick; the ratio of slip to stick is the block's. Strips run over λ, and curves are μ(λ).
///
/// # Errors
/// As [`solve`]; or if `up_to` is not a number above zero.
pub fn regions(
    block: &Block,
    permanent: &Wrench,
    variable: &Wrench,
    up_to: f64,
) -> Result<Vec<Region>, InputError> {
    let up_to = InputError::positive(Quantity::LoadFactor, up_to)?;
    // In t = λ/up_to, so that the boundaries' coefficients are of one size whatever the load is measured in.
    let variable = *variable * up_to;
    let boundaries = boundaries(block, permanent, &variable);
    let curves: Vec<Curve> = boundaries.iter().filter_map(Boundary::curve).collect();

    let mode = |t: f64, μ: f64| -> Result<Option<Mode>, InputError> {
        Ok(solve(&with_friction(block, μ), &(*permanent + variable * t))?.mode())
    };
    let mut regions: Vec<Region> = Vec::new();
    let mut from = 0.0;
    for to in breakpoints(&boundaries) {
        if to - from > NARROW {
            for cell in cells(&curves, from, to, mode)? {
                attach(&mut regions, cell);
            }
            from = to;
        }
    }
    for strip in regions.iter_mut().flat_map(|region| &mut region.strips) {
        *strip = stretched(strip, up_to);
    }
    Ok(regions)
}

/// Strips narrower than this share of the range are joined to a neighbour.
const NARROW: f64 = 1e-9;

/// A strip over t as one over λ = t · `up_to`.
fn stretched(strip: &Strip, up_to: f64) -> Strip {
    let curve = |curve: Curve| match curve {
        // The axis; every boundary is a hyperbola.
        Curve::Line { .. } => curve,
        Curve::Hyperbola { a, b, c, d } => Curve::Hyperbola { a: a / up_to, b, c: c / up_to, d },
    };
    Strip {
        from: strip.from * up_to,
        to: strip.to * up_to,
        lower: curve(strip.lower),
        upper: strip.upper.map(curve),
    }
}

/// Every condition as a boundary of the plane, duplicates left out.
fn boundaries(block: &Block, permanent: &Wrench, variable: &Wrench) -> Vec<Boundary> {
    let at = |μ, wrench| -> [f64; COUNT] { conditions(&numbers(&with_friction(block, μ), wrench)) };
    let corners = [permanent, variable].map(|wrench| [0.0, 1.0].map(|μ| at(μ, wrench)));
    let mut found: Vec<Boundary> = Vec::new();
    for i in 0..COUNT {
        let [[p0, p1], [v0, v1]] = corners.map(|values| values.map(|values| values[i]));
        let boundary = Boundary { alpha: [p0, v0], beta: [p1 - p0, v1 - v0] };
        let is_zero = boundary.coefficients() == [0.0; 4];
        if !is_zero && !found.iter().any(|other| other.is_same(&boundary)) {
            found.push(boundary);
        }
    }
    found
}

impl Boundary {
    fn coefficients(&self) -> [f64; 4] {
        [self.alpha[0], self.alpha[1], self.beta[0], self.beta[1]]
    }

    /// True if the other boundary is this one times a factor, up to rounding.
    fn is_same(&self, other: &Boundary) -> bool {
        let (ours, theirs) = (self.coefficients(), other.coefficients());
        let norm = |c: [f64; 4]| c.iter().map(|x| x * x).sum::<f64>();
        let product: f64 = ours.iter().zip(theirs).map(|(a, b)| a * b).sum();
        product * product >= (1.0 - 1e-13) * norm(ours) * norm(theirs)
    }

    /// μ(λ); `None` for a vertical.
    fn curve(&self) -> Option<Curve> {
        let ([a0, a1], [b0, b1]) = (self.alpha, self.beta);
        (b0 != 0.0 || b1 != 0.0).then_some(Curve::Hyperbola { a: -a1, b: -a0, c: b1, d: b0 })
    }
}

/// The t at which the order of the curves can change: verticals, poles, zeros and crossings; ended by 1.
fn breakpoints(boundaries: &[Boundary]) -> Vec<f64> {
    let root = |[c0, c1]: [f64; 2]| -c0 / c1;
    let mut at = vec![1.0];
    for (i, one) in boundaries.iter().enumerate() {
        at.extend([root(one.alpha), root(one.beta)]);
        for two in &boundaries[i + 1..] {
            // α(λ) δ(λ) = γ(λ) β(λ) for the boundaries α + μβ and γ + μδ.
            let ([a0, a1], [b0, b1]) = (one.alpha, one.beta);
            let ([c0, c1], [d0, d1]) = (two.alpha, two.beta);
            let square = a1 * d1 - c1 * b1;
            let linear = a0 * d1 + a1 * d0 - c0 * b1 - c1 * b0;
            at.extend(quadratic_roots([a0 * d0 - c0 * b0, linear, square]));
        }
    }
    // One too close to the end would leave the end uncovered.
    at.retain(|t| (0.0..1.0 - NARROW).contains(t) || *t == 1.0);
    at.sort_by(f64::total_cmp);
    at.dedup();
    at
}

/// The cells of the strip between two breakpoints, from the axis upwards.
fn cells(
    curves: &[Curve],
    from: f64,
    to: f64,
    mode: impl Fn(f64, f64) -> Result<Option<Mode>, InputError>,
) -> Result<Vec<Cell>, InputError> {
    let middle = from + (to - from) / 2.0;
    let mut above: Vec<(f64, Curve)> = curves.iter().map(|curve| (curve.at(middle), *curve)).collect();
    above.retain(|(μ, _)| μ.is_finite() && *μ > 0.0);
    crate::order::by_number(&mut above, |one| one.0);

    let mut cells: Vec<Cell> = Vec::new();
    let mut lower = (0.0, Curve::AXIS);
    let uppers = above.into_iter().map(Some).chain([None]);
    for upper in uppers {
        let sample = upper.map_or(2.0 * lower.0 + 1.0, |(μ, _)| lower.0 + (μ - lower.0) / 2.0);
        let next = upper.map(|(_, curve)| curve);
        if let Some(mode) = mode(middle, sample)? {
            match cells.last_mut() {
                Some(last) if last.mode == mode => last.strip.upper = next,
                _ => cells.push(Cell { mode, strip: Strip { from, to, lower: lower.1, upper: next } }),
            }
        }
        if let Some(upper) = upper {
            lower = upper;
        }
    }
    Ok(cells)
}

/// Adds a cell to the region of its mode that ends where the cell begins and touches it there, or begins a region.
fn attach(regions: &mut Vec<Region>, Cell { mode, strip }: Cell) {
    let span = |strip: &Strip, λ: f64| {
        let upper = strip.upper.map_or(f64::INFINITY, |upper| upper.at(λ));
        (strip.lower.at(λ), if upper.is_nan() { f64::INFINITY } else { upper })
    };
    let touches = |last: &Strip| {
        let ((low, high), (next_low, next_high)) = (span(last, strip.from), span(&strip, strip.from));
        last.to == strip.from && low < next_high && next_low < high
    };
    let before =
        regions.iter_mut().find(|region| region.mode == mode && region.strips.last().is_some_and(touches));
    match before {
        Some(region) => {
            let last = region.strips.last_mut().expect("a region has strips");
            if (last.lower, last.upper) == (strip.lower, strip.upper) {
                last.to = strip.to;
            } else {
                region.strips.push(strip);
            }
        }
        None => regions.push(Region { mode, strips: vec![strip] }),
    }
}

#[cfg(test)]
mod tests {
    use super::quadratic_roots;

    /// Roots of very different sizes, of either sign: both to the last digits, by Vieta.
    #[test]
    fn roots_keep_their_digits() {
        for (large, small) in
            [(1e8, 1e-8), (-1e8, 1e-8), (1e8, -1e-8), (-3e5, -2e-6), (2.0, 2.0), (5.0, -5.0)]
        {
            let mut roots = quadratic_roots([3.0 * large * small, -3.0 * (large + small), 3.0]);
            if roots[0].abs() < roots[1].abs() {
                roots.swap(0, 1);
            }
            assert!(roots[0].abs() == f64::abs(large) || (roots[0] / large - 1.0).abs() < 1e-12, "{roots:?}");
            assert!((roots[0] * roots[1] / (large * small) - 1.0).abs() < 1e-12, "{roots:?} {large} {small}");
        }
        assert!(quadratic_roots([1.0, 0.0, 1.0]).iter().all(|root| root.is_nan()));
        // A line has one root.
        let [none, root] = quadratic_roots([-3.0, 2.0, 0.0]);
        assert!(!none.is_finite() && root == 1.5);
    }
}
