//! The k–μ plane as exact regions: which mode holds where, for one body and one elevation of the force.
//!
//! Every region is a row of [`Strip`]s between two values of k, bounded below and above by a line or a
//! hyperbola of the [`Chart`]. Nothing is sampled: a picture, an area or a containment test starts from the
//! formulas.
//!
//! ```
//! use standfast::{Diagram, Mode};
//!
//! let diagram = Diagram::new(3.0, 0.8)?; // Fig. 3.11
//! let modes: Vec<_> = diagram.regions().iter().map(|region| region.mode.symbol()).collect();
//! assert_eq!(modes, ["RE", "SL", "RO", "SRO-", "SRO+"]);
//! assert_eq!(diagram.mode_at(3.0, 0.1)?, Mode::SlideRockORight);
//! # Ok::<(), standfast::InputError>(())
//! ```

use crate::error::InputError;
use crate::initiation::{Chart, ChartCase, Point};
use crate::mode::{Mode, Modes};
use crate::region::{Curve, Region, Strip};

/// A part of the indeterminate set N, where three modes are consistent and the report's section IV.7 picks one.
#[derive(Debug, Clone, PartialEq)]
pub struct Unresolved {
    /// The report's name for it, a walk along its boundary: `BB'C'C`, `BAC'C` or `CC'C''`.
    pub name: &'static str,
    /// The mode the report resolves it to.
    pub resolved_as: Mode,
    /// All modes consistent inside.
    pub modes: Modes,
    /// Its strips.
    pub strips: Vec<Strip>,
}

/// The rectangle of the plane that a picture shows: 0 ≤ k ≤ `k`, 0 ≤ μ ≤ `mu`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Largest k.
    pub k: f64,
    /// Largest μ.
    pub mu: f64,
}

/// The regions of the k–μ plane for one body and one elevation of the force.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagram {
    chart: Chart,
    regions: Vec<Region>,
}

impl Unresolved {
    /// True if (k, μ) lies in the part or on its edge, in floating point.
    pub fn contains(&self, k: f64, mu: f64) -> bool {
        self.strips.iter().any(|strip| strip.contains(k, mu))
    }
}

impl Diagram {
    /// The diagram for γ and k', any real number.
    ///
    /// # Errors
    /// If a number is not finite or `gamma` is not above zero.
    pub fn new(gamma: f64, k_prime: f64) -> Result<Diagram, InputError> {
        Ok(Diagram::of(Chart::new(gamma, k_prime)?))
    }

    /// The diagram of a chart.
    pub fn of(chart: Chart) -> Diagram {
        let regions = match chart.case() {
            ChartCase::OneA | ChartCase::OneB | ChartCase::TwoThree => force_above(&chart),
            ChartCase::DeltaPositive | ChartCase::DeltaNotPositive => force_below(&chart),
            ChartCase::BelowBase => force_below_base(&chart),
        };
        let regions = regions
            .into_iter()
            .map(|(mode, strips)| Region {
                mode,
                strips: strips.into_iter().filter(|strip| strip.from < strip.to).collect(),
            })
            .filter(|region| !region.strips.is_empty())
            .collect();
        Diagram { chart, regions }
    }

    /// The curves and points of the plane.
    pub fn chart(&self) -> &Chart {
        &self.chart
    }

    /// The regions, as the report resolves them; each mode has at most one, and together they fill the plane.
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// The region of a mode, if it has one.
    pub fn region(&self, mode: Mode) -> Option<&Region> {
        self.regions.iter().find(|region| region.mode == mode)
    }

    /// The mode at (k, μ), exactly, boundaries included.
    ///
    /// # Errors
    /// If `k` or `mu` is negative or not finite.
    pub fn mode_at(&self, k: f64, mu: f64) -> Result<Mode, InputError> {
        Ok(Point::new(self.chart.gamma(), self.chart.k_prime(), k, mu)?.mode())
    }

    /// The indeterminate set N in the report's parts; empty unless −1 < k' < 0.
    pub fn unresolved(&self) -> Vec<Unresolved> {
        let chart = &self.chart;
        let name = match chart.case() {
            ChartCase::DeltaPositive => "BB'C'C",
            ChartCase::DeltaNotPositive if chart.k_prime() > -1.0 => "BAC'C",
            _ => return Vec::new(),
        };
        let start = chart.k_a().max(chart.k_b_prime());
        let crossing = chart.k_c_prime();
        let (ab, dc, mu_star) = (Some(chart.upper_line()), chart.lower_line(), chart.mu_star());
        vec![
            Unresolved {
                name,
                resolved_as: Mode::SlideLeft,
                modes: [Mode::RockO, Mode::SlideRockOLeft, Mode::SlideLeft].into_iter().collect(),
                strips: vec![strip(start, crossing, mu_star, ab), strip(crossing, f64::INFINITY, dc, ab)],
            },
            Unresolved {
                name: "CC'C''",
                resolved_as: Mode::SlideRockOPrimeLeft,
                modes: [Mode::RockO, Mode::SlideRockOLeft, Mode::SlideRockOPrimeLeft].into_iter().collect(),
                strips: vec![strip(crossing, f64::INFINITY, mu_star, Some(dc))],
            },
        ]
    }

    /// Places in which the conditions of `mode` alone hold, before IV.7 compares it with the others (Figs. 4.3–4.6): its own region, then
    /// the unresolved parts that its conditions also cover but the report gives to another mode.
    pub fn before_resolution(&self, mode: Mode) -> (Option<&Region>, Vec<Unresolved>) {
        let mut parts = self.unresolved();
        parts.retain(|part| part.modes.contains(mode) && part.resolved_as != mode);
        (self.region(mode), parts)
    }

    /// The smallest window with a margin that shows every named point of the chart.
    pub fn window(&self) -> Window {
        let points = self.chart.points();
        let largest =
            |of: fn(f64, f64) -> f64, start: f64| points.iter().fold(start, |m, p| m.max(of(p.k, p.mu)));
        let unit = 1.0 / self.chart.gamma();
        Window { k: 1.25 * largest(|k, _| k, unit), mu: 1.25 * largest(|_, mu| mu, unit) }
    }
}

type Row = (Mode, Vec<Strip>);

/// Chapter III, k' ≥ 0 (Figs. 3.9–3.11).
fn force_above(chart: &Chart) -> Vec<Row> {
    let (k_a, k_d, k_e) = (chart.k_a(), chart.k_d(), chart.k_e());
    let (cd, falling, rising) = (chart.upper_line(), chart.mu_star(), chart.mu_star_rising());
    let inf = f64::INFINITY;
    vec![
        (Mode::Rest, vec![strip(0.0, k_a, Curve::DIAGONAL, None)]),
        (
            Mode::SlideLeft,
            vec![strip(0.0, k_a, Curve::AXIS, Some(Curve::DIAGONAL)), strip(k_a, k_d, Curve::AXIS, Some(cd))],
        ),
        (Mode::RockO, vec![strip(k_a, k_e, falling, None), strip(k_e, inf, rising, None)]),
        (
            Mode::SlideRockOLeft,
            vec![strip(k_a, k_d, cd, Some(falling)), strip(k_d, k_e, Curve::AXIS, Some(falling))],
        ),
        (Mode::SlideRockORight, vec![strip(k_e, inf, Curve::AXIS, Some(rising))]),
    ]
}

/// Chapter IV, −1 ≤ k' < 0, as IV.7 resolves it (Figs. 4.7a, 4.7b).
fn force_below(chart: &Chart) -> Vec<Row> {
    let (k_a, k_d) = (chart.k_a(), chart.k_d());
    let (ab, dc, mu_star) = (chart.upper_line(), chart.lower_line(), chart.mu_star());
    // Only a B' to the right of A bounds anything; for Δ ≤ 0 the lens from A to B' is empty.
    let k_b = if chart.case() == ChartCase::DeltaPositive { chart.k_b_prime().max(k_a) } else { k_a };
    let inf = f64::INFINITY;
    // D lies left of A if |k'| > 1/2, right of it otherwise.
    let (left, right) = (k_a.min(k_d), k_a.max(k_d));
    let between = if k_d < k_a {
        strip(left, right, dc, Some(Curve::DIAGONAL))
    } else {
        strip(left, right, Curve::AXIS, Some(ab))
    };
    vec![
        (Mode::Rest, vec![strip(0.0, k_a, Curve::DIAGONAL, None)]),
        (
            Mode::SlideLeft,
            vec![
                strip(0.0, left, Curve::AXIS, Some(Curve::DIAGONAL)),
                between,
                strip(right, inf, dc, Some(ab)),
            ],
        ),
        (Mode::RockO, vec![strip(k_a, k_b, mu_star, None), strip(k_b, inf, ab, None)]),
        (Mode::SlideRockOLeft, vec![strip(k_a, k_b, ab, Some(mu_star))]),
        (Mode::SlideRockOPrimeLeft, vec![strip(k_d, inf, Curve::AXIS, Some(dc))]),
    ]
}

/// k' < −1: D, A and μ** part the plane, and O' is the corner.
fn force_below_base(chart: &Chart) -> Vec<Row> {
    let (k_a, k_d) = (chart.k_a(), chart.k_d());
    let (dc, mu_star_star) = (chart.lower_line(), chart.mu_star_star());
    let inf = f64::INFINITY;
    vec![
        (Mode::Rest, vec![strip(0.0, k_a, Curve::DIAGONAL, None)]),
        (
            Mode::SlideLeft,
            vec![
                strip(0.0, k_d, Curve::AXIS, Some(Curve::DIAGONAL)),
                strip(k_d, k_a, dc, Some(Curve::DIAGONAL)),
            ],
        ),
        (Mode::RockOPrime, vec![strip(k_a, inf, mu_star_star, None)]),
        (
            Mode::SlideRockOPrimeLeft,
            vec![strip(k_d, k_a, Curve::AXIS, Some(dc)), strip(k_a, inf, Curve::AXIS, Some(mu_star_star))],
        ),
    ]
}

fn strip(from: f64, to: f64, lower: Curve, upper: Option<Curve>) -> Strip {
    Strip { from, to, lower, upper }
}
