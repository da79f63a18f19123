//! The k–μ plane of the report's block on a base that crushes: its points, its curves, and which mode holds where.

use super::CrushPoint;
use crate::error::InputError;
use crate::ground::roots::{between, real_roots};
use crate::initiation::{NamedPoint, PointName};
use crate::mode::Mode;
use crate::quantity::{Expected, Quantity};
use crate::region::Curve;
use crate::verdict::Verdict;

/// The k–μ plane for γ, k' and ω < 1.
///
/// The lines are the report's with the arm B(1 − ω); the curve between rock and slide-rock is given by the rotation α = |θ̈|:
///
/// ```text
/// k(α) = [Jα + R(α)]/(γ|1+k'|)        μ*(α) = |k ∓ γα|/N(α)        − for k' ≥ −1
/// ```
///
/// It begins at A with α = 0. For k' < k'_P = (1+γ²)/(3γ²), the centre of percussion, μ* rises without end; for k' > k'_P it falls
/// to zero at E and then rises: a force that is large enough always slide-rocks on a base that crushes.
///
/// ```
/// use standfast::initiation::PointName;
/// use standfast::ground::strength::CrushChart;
///
/// let chart = CrushChart::new(2.0, 0.8, 0.2)?;
/// let a = chart.point(PointName::A).unwrap();
/// assert!((a.k - 0.8 / 3.6).abs() < 1e-15 && a.k == a.mu);
/// let begin = chart.rock_at(0.0);
/// assert!((begin.k - a.k).abs() < 1e-15 && (begin.mu - a.mu).abs() < 1e-15);
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrushChart {
    gamma: f64,
    k_prime: f64,
    omega: f64,
}

/// A point of the curve between rock and slide-rock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RockEdgePoint {
    /// α = |θ̈|, in g/B.
    pub alpha: f64,
    /// k.
    pub k: f64,
    /// μ*.
    pub mu: f64,
}

/// A curve that bounds a region of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CrushEdge {
    /// A line μ(k).
    Line(Curve),
    /// μ*, from A on.
    Rock(CrushChart),
}

/// The part of a region between two values of k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrushStrip {
    /// Smallest k.
    pub from: f64,
    /// Largest k, possibly infinite.
    pub to: f64,
    /// The curve the strip lies above.
    pub lower: CrushEdge,
    /// The curve the strip lies below; `None` if it is open at the top.
    pub upper: Option<CrushEdge>,
}

/// Region of the plane in which a mode holds: strips in the order of k.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushRegion {
    /// The mode.
    pub mode: Mode,
    /// Its strips, never empty.
    pub strips: Vec<CrushStrip>,
}

/// The regions of the plane. The rigid one, to be drawn behind, is [`Diagram`](crate::Diagram)'s.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushMap {
    chart: CrushChart,
    regions: Vec<CrushRegion>,
}

impl CrushEdge {
    /// μ at k; μ* is not a number left of A.
    pub fn at(&self, k: f64) -> f64 {
        match self {
            CrushEdge::Line(line) => line.at(k),
            CrushEdge::Rock(chart) => chart.mu_star(k).unwrap_or(f64::NAN),
        }
    }
}

impl CrushStrip {
    /// True if (k, μ) lies in the strip or on its edge, in floating point. The mode that owns an edge is [`CrushPoint::verdict`]'s to say.
    pub fn contains(&self, k: f64, mu: f64) -> bool {
        let below = self.upper.is_none_or(|upper| mu <= upper.at(k));
        self.from <= k && k <= self.to && self.lower.at(k) <= mu && below
    }
}

impl CrushRegion {
    /// True if (k, μ) lies in the region or on its edge, in floating point.
    pub fn contains(&self, k: f64, mu: f64) -> bool {
        self.strips.iter().any(|strip| strip.contains(k, mu))
    }
}

impl CrushChart {
    /// The plane for γ, any real k', and ω from 0 to below 1.
    ///
    /// # Errors
    /// If a number is not finite, `gamma` is not above zero, or `omega` is not from 0 to below 1: beyond, the plane is all BF.
    pub fn new(gamma: f64, k_prime: f64, omega: f64) -> Result<CrushChart, InputError> {
        if omega.is_nan() || omega >= 1.0 {
            return Err(InputError::new(Quantity::Omega, omega, Expected::BelowOne));
        }
        Ok(CrushChart {
            gamma: InputError::positive(Quantity::Slenderness, gamma)?,
            k_prime: InputError::finite(Quantity::KPrime, k_prime)?,
            omega: InputError::not_negative(Quantity::Omega, omega)?,
        })
    }

    /// γ = H/B.
    pub fn gamma(&self) -> f64 {
        self.gamma
    }

    /// k'.
    pub fn k_prime(&self) -> f64 {
        self.k_prime
    }

    /// ω.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// k'_P = (1+γ²)/(3γ²): a force at the centre of percussion rocks the body without friction.
    pub fn percussion(&self) -> f64 {
        let square = self.gamma * self.gamma;
        (1.0 + square) / (3.0 * square)
    }

    /// J = (1 + 4γ²)/3.
    fn inertia(&self) -> f64 {
        (1.0 + 4.0 * self.gamma * self.gamma) / 3.0
    }

    /// γ|1 + k'|, G₁ of the edge the force tips the body about.
    fn lever(&self) -> f64 {
        self.gamma * (1.0 + self.k_prime).abs()
    }

    /// γ, or −γ for k' < −1.
    fn signed_slenderness(&self) -> f64 {
        if self.k_prime < -1.0 { -self.gamma } else { self.gamma }
    }

    /// N(α) = (1+α)/(1+2ωα).
    pub fn normal(&self, alpha: f64) -> f64 {
        (1.0 + alpha) / (1.0 + 2.0 * self.omega * alpha)
    }

    /// R(α) = N(1 − ωN): the moment of the reaction about the centre of mass.
    pub fn resistance(&self, alpha: f64) -> f64 {
        let normal = self.normal(alpha);
        normal * (1.0 - self.omega * normal)
    }

    /// k − γα, the reaction f_x of rocking (k + γα for k' < −1), without the difference of large numbers.
    fn pull(&self, alpha: f64) -> f64 {
        let lever = self.lever();
        let g = self.signed_slenderness();
        ((self.inertia() - g * lever) * alpha + self.resistance(alpha)) / lever
    }

    /// The point of the curve between rock and slide-rock at the rotation `alpha` ≥ 0, in g/B.
    pub fn rock_at(&self, alpha: f64) -> RockEdgePoint {
        let k = (self.inertia() * alpha + self.resistance(alpha)) / self.lever();
        RockEdgePoint { alpha, k, mu: self.pull(alpha).abs() / self.normal(alpha) }
    }

    /// α of a body that rocks under k; `None` up to k_A.
    pub fn rotation(&self, k: f64) -> Option<f64> {
        let excess = |alpha: f64| self.inertia() * alpha + self.resistance(alpha) - k * self.lever();
        // R ≥ R(0) > 0: the root is no larger than on a base that gives nothing.
        let most = k * self.lever() / self.inertia();
        if excess(0.0) < 0.0 { between(excess, 0.0, most) } else { None }
    }

    /// μ* at k; `None` left of A.
    pub fn mu_star(&self, k: f64) -> Option<f64> {
        if k < self.k_a() {
            return None;
        }
        Some(self.rock_at(self.rotation(k).unwrap_or(0.0)).mu)
    }

    /// (1−ω)/γ − k k': on it the sliding body's reaction is as near to O as the base bears it.
    pub fn upper_line(&self) -> Curve {
        Curve::Line { slope: -self.k_prime, intercept: (1.0 - self.omega) / self.gamma }
    }

    /// −(1−ω)/γ − k k': the same at O'.
    pub fn lower_line(&self) -> Curve {
        Curve::Line { slope: -self.k_prime, intercept: (self.omega - 1.0) / self.gamma }
    }

    /// k_A = μ_A = (1−ω)/(γ|1+k'|); infinite for k' = −1.
    pub fn k_a(&self) -> f64 {
        (1.0 - self.omega) / self.lever()
    }

    /// k_D = (1−ω)/(γ|k'|); infinite for k' = 0.
    pub fn k_d(&self) -> f64 {
        (1.0 - self.omega) / (self.gamma * self.k_prime.abs())
    }

    /// The rotation at E, where μ* is zero: (1+α)(1−ω+ωα) = γ²(k'−k'_P) α (1+2ωα)². `None` for k' ≤ k'_P.
    fn rotation_at_e(&self) -> Option<f64> {
        let fall = self.lever() * self.gamma - self.inertia();
        if self.k_prime < -1.0 || fall <= 0.0 {
            return None;
        }
        // R/α falls from infinity to zero, once.
        let excess = |alpha: f64| self.resistance(alpha) - fall * alpha;
        // R ≤ 1/(4ω), and R ≤ 1 + α.
        let soft = 0.25 / (self.omega * fall);
        let rigid = if fall > 1.0 { 1.0 / (fall - 1.0) } else { f64::INFINITY };
        let most = soft.min(rigid).min(1e100);
        between(excess, 0.0, most * (1.0 + 1e-9))
    }

    /// k_E, the zero of μ*; infinite for k' ≤ k'_P.
    pub fn k_e(&self) -> f64 {
        self.rotation_at_e().map_or(f64::INFINITY, |alpha| self.rock_at(alpha).k)
    }

    /// The named point, if the plane has it: A, C (k' ≥ 0), D, E. A point beyond 1e100 counts as none.
    pub fn point(&self, name: PointName) -> Option<NamedPoint> {
        let (k, mu) = match name {
            PointName::A => (self.k_a(), self.k_a()),
            PointName::C if self.k_prime >= 0.0 => (0.0, self.upper_line().at(0.0)),
            PointName::D => (self.k_d(), 0.0),
            PointName::E => (self.k_e(), 0.0),
            _ => return None,
        };
        (k < 1e100 && mu < 1e100).then_some(NamedPoint { name, k, mu })
    }

    /// All named points of the plane.
    pub fn points(&self) -> Vec<NamedPoint> {
        use PointName::{A, C, D, E};
        [A, C, D, E].into_iter().filter_map(|name| self.point(name)).collect()
    }

    /// Points at which μ* crosses a line of the plane, right of A and from left to right: the roots of a polynomial of the fourth degree in
    /// α. Of a hyperbola it is the tangent at k = 0.
    pub fn rock_crossings(&self, line: Curve) -> Vec<RockEdgePoint> {
        let (slope, intercept) = (line.slope(0.0), line.at(0.0));
        let times = |f: &[f64], g: &[f64]| {
            let mut all = vec![0.0; f.len() + g.len() - 1];
            for (i, a) in f.iter().enumerate() {
                g.iter().enumerate().for_each(|(j, b)| all[i + j] += a * b);
            }
            all
        };
        let ω = self.omega;
        let (one, u) = ([1.0, 1.0], [1.0, 2.0 * ω]);
        let square = times(&u, &u);
        // k G₁ u²
        let mut force = times(&[0.0, self.inertia()], &square);
        times(&one, &[1.0 - ω, ω]).iter().zip(&mut force).for_each(|(r, f)| *f += r);
        let lever = self.lever();
        // ±(k ∓ γα)/N = slope k + intercept, times (1+α) G₁ u²
        let pull = times(&[0.0, -self.signed_slenderness() * lever], &square);
        let pull: Vec<f64> = force.iter().zip(&pull).map(|(k, f)| k + f).collect();
        let mut right: Vec<f64> = force.iter().map(|k| slope * k).collect();
        square.iter().zip(&mut right).for_each(|(s, r)| *r += intercept * lever * s);
        let (left, right) = (times(&pull, &u), times(&right, &one));
        let mut at: Vec<f64> = Vec::new();
        for branch in [1.0, -1.0] {
            let mut f: Vec<f64> = left.iter().zip(&right).map(|(l, r)| branch * l - r).collect();
            let size = left.iter().chain(&right).fold(0.0, |size: f64, c| size.max(c.abs()));
            // At A, where the curve begins, it meets the line AB: the root α = 0 is divided out.
            if f[0].abs() <= 1e-13 * size {
                f.remove(0);
            }
            // A small leading coefficient is that of a crossing far away: on a base that hardly crushes it counts.
            while f.last() == Some(&0.0) {
                f.pop();
            }
            let Some(leading) = f.last() else { continue };
            let most = 1.0 + f.iter().map(|c| (c / leading).abs()).fold(0.0, f64::max);
            at.extend(real_roots(&f, 0.0, most));
        }
        at.sort_by(f64::total_cmp);
        at.into_iter().map(|alpha| self.rock_at(alpha)).collect()
    }
}

impl CrushMap {
    /// The map for γ, k' and ω; see [`CrushChart::new`].
    ///
    /// # Errors
    /// As [`CrushChart::new`].
    pub fn new(gamma: f64, k_prime: f64, omega: f64) -> Result<CrushMap, InputError> {
        Ok(CrushMap::of(CrushChart::new(gamma, k_prime, omega)?))
    }

    /// The map of a chart: between any two neighbouring curves of a strip the mode is decided at one point, exactly. Strips narrower
    /// than 1e-9 of their k, where crossings coincide up to rounding, are joined to a neighbour.
    pub fn of(chart: CrushChart) -> CrushMap {
        let (upper, lower) = (chart.upper_line(), chart.lower_line());
        let mut ends = vec![chart.k_a(), chart.k_d(), chart.k_e()];
        if chart.k_a().is_finite() {
            let crossings = [upper, lower].map(|line| chart.rock_crossings(line));
            ends.extend(crossings.into_iter().flatten().map(|point| point.k));
        }
        ends.retain(|k| k.is_finite() && *k > 0.0);
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|later, earlier| *later - *earlier <= 1e-9 * *later);
        ends.push(f64::INFINITY);

        let mut regions: Vec<CrushRegion> = Vec::new();
        let mut from = 0.0;
        for to in ends {
            let middle = match to {
                f64::INFINITY if from == 0.0 => 1.0 / chart.gamma(),
                f64::INFINITY => 2.0 * from,
                to => from + (to - from) / 2.0,
            };
            let mut curves =
                vec![CrushEdge::Line(Curve::DIAGONAL), CrushEdge::Line(upper), CrushEdge::Line(lower)];
            if middle > chart.k_a() {
                curves.push(CrushEdge::Rock(chart));
            }
            for (mode, strip) in cells(&chart, &curves, from, to, middle) {
                attach(&mut regions, mode, strip);
            }
            from = to;
        }
        regions.sort_by_key(|region| region.mode.code());
        CrushMap { chart, regions }
    }

    /// Points and curves of the plane.
    pub fn chart(&self) -> &CrushChart {
        &self.chart
    }

    /// The regions, in the order of their modes' codes; together they fill the plane.
    pub fn regions(&self) -> &[CrushRegion] {
        &self.regions
    }
}

/// The modes between k = `from` and `to`, from the axis upwards, as they are at `middle`.
fn cells(
    chart: &CrushChart,
    curves: &[CrushEdge],
    from: f64,
    to: f64,
    middle: f64,
) -> Vec<(Mode, CrushStrip)> {
    let mut above: Vec<(f64, CrushEdge)> = curves.iter().map(|curve| (curve.at(middle), *curve)).collect();
    above.retain(|(mu, _)| mu.is_finite() && *mu > 0.0);
    crate::order::by_number(&mut above, |one| one.0);
    let mut cells: Vec<(Mode, CrushStrip)> = Vec::new();
    let mut lower = (0.0, CrushEdge::Line(Curve::AXIS));
    for next in above.into_iter().map(Some).chain([None]) {
        let mu = next.map_or(2.0 * lower.0 + 1.0, |(mu, _)| lower.0 + (mu - lower.0) / 2.0);
        let upper = next.map(|(_, curve)| curve);
        let point = CrushPoint::new(chart.gamma, chart.k_prime, middle, mu, chart.omega);
        if let Some(Verdict::Begins(mode)) = point.ok().map(|point| point.verdict()) {
            match cells.last_mut() {
                Some((last, strip)) if *last == mode => strip.upper = upper,
                _ => cells.push((mode, CrushStrip { from, to, lower: lower.1, upper })),
            }
        }
        lower = next.unwrap_or(lower);
    }
    cells
}

/// Adds a strip to the region of its mode, or continues its last strip where that has the same edges.
fn attach(regions: &mut Vec<CrushRegion>, mode: Mode, strip: CrushStrip) {
    let Some(region) = regions.iter_mut().find(|region| region.mode == mode) else {
        regions.push(CrushRegion { mode, strips: vec![strip] });
        return;
    };
    match region.strips.last_mut() {
        Some(last) if last.to == strip.from && (last.lower, last.upper) == (strip.lower, strip.upper) => {
            last.to = strip.to;
        }
        _ => region.strips.push(strip),
    }
}
