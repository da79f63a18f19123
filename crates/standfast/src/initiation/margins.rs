//! How far a point is from another mode: the forces and the frictions at which the mode changes.

use super::{Case, Chart, Curve, Point};
use crate::mode::Mode;

/// A change of mode along a line of the k–μ plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The critical value of the quantity that varies.
    pub at: f64,
    /// The mode just below it; at zero, the mode there.
    pub from: Mode,
    /// The mode just above it.
    pub to: Mode,
}

/// All changes of mode when one of k and μ varies and everything else stays as it is.
///
/// ```
/// use standfast::Point;
///
/// // γ = 1, k' = 0.4, μ = 0.6: rest ends at k = μ, where sliding begins.
/// let margins = Point::new(1.0, 0.4, 0.5, 0.6)?.margins();
/// let first = margins.leaves_rest();
/// assert_eq!((first.at, first.to.symbol()), (0.6, "SL"));
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Margins {
    /// As the force k grows from zero, at the point's friction. Never empty: without bound, some force moves
    /// every body.
    pub along_force: Vec<Crossing>,
    /// As the friction μ grows from zero, at the point's force.
    pub along_friction: Vec<Crossing>,
    force: f64,
    friction: f64,
}

impl Margins {
    pub(super) fn of(point: &Point) -> Margins {
        let Point { gamma, k_prime, k, mu } = *point;
        let curves = boundary_curves(&point.chart());
        let mode = |k, mu| Point { gamma, k_prime, k, mu }.mode();

        // Every boundary is a line or a hyperbola a k + b = μ (c k + d): linear in k, and linear in μ.
        let forces = curves.iter().filter_map(|curve| curve.k_at(mu)).chain([point.chart().k_a()]);
        let frictions = curves.iter().map(|curve| curve.at(k));
        Margins {
            along_force: crossings(forces, |k| mode(k, mu)),
            along_friction: crossings(frictions, |mu| mode(k, mu)),
            force: k,
            friction: mu,
        }
    }

    /// Where the body first leaves rest as the force grows, and into which mode.
    pub fn leaves_rest(&self) -> Crossing {
        self.along_force[0]
    }

    /// The nearest changes of mode below and above the point's force.
    pub fn force_bounds(&self) -> (Option<Crossing>, Option<Crossing>) {
        bounds(&self.along_force, self.force)
    }

    /// The nearest changes of mode below and above the point's friction.
    pub fn friction_bounds(&self) -> (Option<Crossing>, Option<Crossing>) {
        bounds(&self.along_friction, self.friction)
    }
}

fn bounds(crossings: &[Crossing], value: f64) -> (Option<Crossing>, Option<Crossing>) {
    let below = crossings.iter().rev().find(|crossing| crossing.at < value);
    let above = crossings.iter().find(|crossing| crossing.at >= value);
    (below.copied(), above.copied())
}

/// Every curve that bounds a region of this chart, the vertical at A excepted.
fn boundary_curves(chart: &Chart) -> Vec<Curve> {
    let mut curves = vec![Curve::DIAGONAL, chart.upper_line(), chart.lower_line()];
    match chart.case() {
        Case::BelowBase => curves.push(chart.mu_star_star()),
        Case::TwoThree => curves.extend([chart.mu_star(), chart.mu_star_rising()]),
        _ => curves.push(chart.mu_star()),
    }
    curves
}

/// The changes of `mode` over (0, ∞), which can happen at `candidates` only.
///
/// Between neighbouring candidates the mode is constant and is asked for once, exactly; a candidate where it does
/// not change is dropped, so it does no harm that a curve also runs where it bounds nothing. Candidates that are
/// one crossing computed in two ways (at A, four curves meet) have no f64 or a span of a few ulps between them,
/// which is passed over.
fn crossings(candidates: impl Iterator<Item = f64>, mode: impl Fn(f64) -> Mode) -> Vec<Crossing> {
    let mut at: Vec<f64> =
        candidates.filter(|value| value.is_finite() && *value > 0.0).chain([0.0]).collect();
    at.sort_by(f64::total_cmp);
    at.dedup_by(|later, earlier| *later - *earlier <= 16.0 * f64::EPSILON * *later);

    let mut crossings = Vec::new();
    let mut from = mode(0.0);
    for (i, &value) in at.iter().enumerate() {
        // Past the last candidate anything larger will do; 1 serves when there is none but zero.
        let end = if value > 0.0 { 2.0 * value } else { 1.0 };
        let beyond = at.get(i + 1).map_or(end.min(f64::MAX), |next| value + (next - value) / 2.0);
        let to = mode(beyond);
        if to != from {
            crossings.push(Crossing { at: value, from, to });
            from = to;
        }
    }
    crossings
}
