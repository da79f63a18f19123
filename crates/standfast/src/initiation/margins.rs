//! Distance of a point from another mode: the forces and the frictions at which the mode changes.

use super::{Chart, ChartCase, Point};
use crate::error::LARGEST;
use crate::mode::Mode;
use crate::region::Curve;

/// A change of mode along a line of the k–μ plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// The critical value of the quantity that varies, right to 1e-12 of itself.
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
/// let first = margins.leaves_rest().unwrap();
/// assert_eq!((first.at, first.to.symbol()), (0.6, "SL"));
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PointMargins {
    /// As the force k grows from zero, at the point's friction.
    pub along_k: Vec<Crossing>,
    /// As the friction μ grows from zero, at the point's force.
    pub along_mu: Vec<Crossing>,
    point: Point,
}

/// The changes of mode on either side of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The nearest below, if there is one.
    pub below: Option<Crossing>,
    /// The nearest above, if there is one.
    pub above: Option<Crossing>,
}

impl PointMargins {
    pub(super) fn of(point: &Point) -> PointMargins {
        let Point { k, mu, .. } = *point;
        let curves = boundary_curves(&point.chart());
        let mode = |k, mu| Point { k, mu, ..*point }.mode();

        // Every boundary is a line or a hyperbola a k + b = μ (c k + d): linear in k, and linear in μ.
        let forces = curves.iter().filter_map(|curve| curve.k_at(mu)).chain([point.chart().k_a()]);
        let frictions = curves.iter().map(|curve| curve.at(k));
        PointMargins {
            along_k: crossings(forces, k, |k| mode(k, mu)),
            along_mu: crossings(frictions, mu, |mu| mode(k, mu)),
            point: *point,
        }
    }

    /// Crossing at which the body first leaves rest as the force grows, and the mode beyond it. `None` if no force up to 1e50 moves it: one
    /// through the base (k' = −1) against as much friction.
    pub fn leaves_rest(&self) -> Option<Crossing> {
        self.along_k.first().copied()
    }

    /// The nearest changes of mode below and above the point's force. A point on a boundary is at the end of the
    /// interval whose mode it has.
    pub fn k_bounds(&self) -> Bounds {
        bounds(&self.along_k, self.point.k, self.point.mode())
    }

    /// The nearest changes of mode below and above the point's friction, likewise.
    pub fn mu_bounds(&self) -> Bounds {
        bounds(&self.along_mu, self.point.mu, self.point.mode())
    }
}

fn bounds(crossings: &[Crossing], value: f64, mode: Mode) -> Bounds {
    // One at the value itself lies below it if it leads into the point's mode.
    let is_below = |crossing: &Crossing| crossing.at < value || crossing.at == value && crossing.to == mode;
    let above = crossings.iter().position(|crossing| !is_below(crossing)).unwrap_or(crossings.len());
    Bounds { below: above.checked_sub(1).map(|below| crossings[below]), above: crossings.get(above).copied() }
}

/// Two values of k or μ that are this close, relatively, may be one crossing computed in two ways.
const NEAR: f64 = 16.0 * f64::EPSILON;

/// Distance to either side of a crossing, relatively, at which its modes are asked for: farther off, the computed crossing is not one.
const ASIDE: f64 = 1e-12;

/// Every curve that bounds a region of this chart, the vertical at A excepted.
fn boundary_curves(chart: &Chart) -> Vec<Curve> {
    let mut curves = vec![Curve::DIAGONAL, chart.upper_line(), chart.lower_line()];
    match chart.case() {
        ChartCase::BelowBase => curves.push(chart.mu_star_star()),
        ChartCase::TwoThree => curves.extend([chart.mu_star(), chart.mu_star_rising()]),
        _ => curves.push(chart.mu_star()),
    }
    curves
}

/// The changes of `mode` from zero upwards, which happen at `candidates` or where rounding has moved them from.
///
/// The mode is asked for, exactly, between neighbouring candidates, at `value` itself and far out; between two such
/// samples that differ lies a crossing, at the candidate between them if the mode changes there. A candidate where the
/// mode does not change is dropped, so it does no harm that a curve also runs where it bounds nothing. Candidates that
/// are one crossing computed in two ways (at A, four curves meet) are taken as one. Where a curve is nearly level, its
/// candidate is lost to rounding; then bisection finds the crossing.
fn crossings(candidates: impl Iterator<Item = f64>, value: f64, mode: impl Fn(f64) -> Mode) -> Vec<Crossing> {
    let mut at: Vec<f64> =
        candidates.filter(|at| at.is_finite() && *at > 0.0 && *at < LARGEST).chain([0.0]).collect();
    at.sort_by(f64::total_cmp);
    at.dedup_by(|later, earlier| *later - *earlier <= NEAR * *later);

    let between = at.windows(2).map(|pair| pair[0] + (pair[1] - pair[0]) / 2.0);
    let last = 2.0 * at[at.len() - 1] + f64::MIN_POSITIVE;
    let mut samples: Vec<f64> = between.chain([0.0, value, last.min(LARGEST), LARGEST]).collect();
    samples.sort_by(f64::total_cmp);

    let mut crossings = Vec::new();
    let mut previous = Sample { at: 0.0, mode: mode(0.0) };
    for sample in samples {
        let next = Sample { at: sample, mode: mode(sample) };
        if next.mode != previous.mode {
            let known = at.iter().copied().rfind(|at| (previous.at..=sample).contains(at));
            changes(previous, next, known, &mode, &mut crossings);
        }
        previous = next;
    }
    crossings
}

/// A value and the mode there.
#[derive(Clone, Copy)]
struct Sample {
    at: f64,
    mode: Mode,
}

/// Records the changes between two samples of different modes: at the candidate, if the mode below it is that of the
/// lower sample and another one above it, and by bisection for what is then left, with each mode on the way.
fn changes(
    mut low: Sample,
    high: Sample,
    known: Option<f64>,
    mode: &impl Fn(f64) -> Mode,
    crossings: &mut Vec<Crossing>,
) {
    if let Some(at) = known {
        let asked = |at: f64| match at {
            _ if at <= low.at => low,
            _ if at >= high.at => high,
            _ => Sample { at, mode: mode(at) },
        };
        let (below, above) = (asked(at * (1.0 - ASIDE)), asked(at.max(f64::MIN_POSITIVE) * (1.0 + ASIDE)));
        if below.mode == low.mode && above.mode != low.mode {
            crossings.push(Crossing { at, from: low.mode, to: above.mode });
            low = above;
        }
    }
    while low.mode != high.mode {
        let next = bisect(low, high, mode);
        crossings.push(Crossing { at: next.at, from: low.mode, to: next.mode });
        low = next;
    }
}

/// The first value with another mode than that of `low`, between it and `high`, to the last bit.
fn bisect(mut low: Sample, mut high: Sample, mode: &impl Fn(f64) -> Mode) -> Sample {
    loop {
        let at = low.at + (high.at - low.at) / 2.0;
        if at <= low.at || at >= high.at {
            return high;
        }
        let middle = Sample { at, mode: mode(at) };
        if middle.mode == low.mode {
            low = middle;
        } else {
            high = middle;
        }
    }
}
