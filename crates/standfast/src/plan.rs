//! The plan of a body: how far it reaches out of the plane of its cross-section, and what a base of that plan bears.
//!
//! ```text
//!    rectangle               circle
//!    ┌─────────┐            . ─ ─ .          u, from the middle
//!    │         │ L        ╱    │c   ╲        c(u) = 2 √(r² − u²)
//!    O─────────O'        O─────┼─────O'
//!    │         │          ╲    │    ╱
//!    └─────────┘            ' ─ ─ '
//!        B_c                   2r
//! ```
//!
//! A body that is described per metre run is one metre long: forces, masses and moments of it are then those per metre.
//!
//! The pressure on a base that cannot pull is linear where it presses, p = p_max (u − u₀)/(r − u₀); on a circle
//!
//! ```text
//! resultant at e ≤ r/4:  p = W_e/(π r²) (1 ± 4 e/r)
//! beyond:                W_e = ∫ p c du,  W_e e = ∫ p u c du  from u₀ = r cos α to r, which give α and p_max
//! ```

use std::f64::consts::PI;

use crate::ball::Scalar;
use crate::loads::PressureAt;

/// Plan of a body: its outline seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Plan<T = f64> {
    /// As long everywhere.
    Rectangle {
        /// L, m; 1 for a body per metre run.
        length: T,
    },
    /// A circle, whose diameter is the width: an upright cylinder.
    Circle,
}

/// A pressure linear along a circle that is pressed by part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CirclePressure {
    /// At the edge that is pressed most, Pa.
    pub most: f64,
    /// At the other edge, Pa.
    pub least: f64,
    /// From the edge that is pressed most, m.
    pub contact: f64,
    /// The share of the circle's area that is pressed.
    pub share: f64,
}

impl Plan {
    /// One metre of a long body.
    pub const PER_METRE: Plan = Plan::Rectangle { length: 1.0 };
}

impl<T: Scalar> Plan<T> {
    /// The area of a base `width` wide, m².
    pub fn area(self, width: T) -> T {
        match self {
            Plan::Rectangle { length } => width * length,
            Plan::Circle => T::computed(PI) * width.clone() * width / T::of(4.0),
        }
    }

    /// The length of a side of a body `width` wide that pressures act on, m; of a cylinder that which is seen from there.
    pub fn side(self, width: T) -> T {
        match self {
            Plan::Rectangle { length } => length,
            Plan::Circle => width,
        }
    }

    /// ∫p dA (N) and ∫p s dA (N·m) of a pressure along a base that is `width` wide, s from its left edge.
    pub(crate) fn resultant(&self, points: &[PressureAt<T>], width: T) -> (T, T) {
        let pairs = points.windows(2).map(|pair| match self {
            Plan::Rectangle { length } => {
                let (force, moment) = strip(&pair[0], &pair[1]);
                (force * length.clone(), moment * length.clone())
            }
            Plan::Circle => {
                let [one, two] = [&pair[0], &pair[1]].map(PressureAt::rounded);
                let (force, moment) = across_circle(&one, &two, width.value() / 2.0);
                (T::computed(force), T::computed(moment))
            }
        });
        pairs.fold((T::of(0.0), T::of(0.0)), |sum, (force, moment)| (sum.0 + force, sum.1 + moment))
    }
}

/// ∫p ds and ∫p s ds between two points.
pub(crate) fn strip<T: Scalar>(one: &PressureAt<T>, two: &PressureAt<T>) -> (T, T) {
    let two_of = |x: &T| T::of(2.0) * x.clone();
    let [(s1, p1), (s2, p2)] = [one, two].map(|at| (&at.position, &at.pressure));
    let length = s2.clone() - s1.clone();
    let lever = p1.clone() * (two_of(s1) + s2.clone()) + p2.clone() * (s1.clone() + two_of(s2));
    ((p1.clone() + p2.clone()) / T::of(2.0) * length.clone(), lever / T::of(6.0) * length)
}

/// ∫ c du, ∫ u c du and ∫ u² c du of a circle of radius r from its middle to u.
fn moments(r: f64, u: f64) -> [f64; 3] {
    let u = u.clamp(-r, r);
    let half = ((r - u) * (r + u)).sqrt();
    let angle = (u / r).asin();
    [
        u * half + r * r * angle,
        -2.0 / 3.0 * half * half * half,
        (r.powi(4) * angle - u * half * (r * r - 2.0 * u * u)) / 4.0,
    ]
}

/// ∫p dA and ∫p s dA of a pressure that is linear between two points, on a circle of radius r.
fn across_circle(one: &PressureAt, two: &PressureAt, r: f64) -> (f64, f64) {
    if one.position == two.position {
        return (0.0, 0.0);
    }
    let slope = (two.pressure - one.pressure) / (two.position - one.position);
    let middle = one.pressure + slope * (r - one.position);
    let [m1, m2] = [one, two].map(|at| moments(r, at.position - r));
    let [a, s, i] = [0, 1, 2].map(|power| m2[power] - m1[power]);
    let (force, moment) = (middle * a + slope * s, middle * s + slope * i);
    (force, moment + force * r)
}

/// Pressure on a circle of radius `r` under W_e = `pressing`, which acts `eccentricity` beside its middle, less than r.
pub(crate) fn circle_pressure(pressing: f64, eccentricity: f64, r: f64) -> CirclePressure {
    let mean = pressing / (PI * r * r);
    let lean = 4.0 * eccentricity / r;
    if lean <= 1.0 {
        let [most, least] = [mean * (1.0 + lean), mean * (1.0 - lean)];
        return CirclePressure { most, least, contact: 2.0 * r, share: 1.0 };
    }
    let α = contact_angle(eccentricity / r);
    let sagitta = 2.0 * (α / 2.0).sin().powi(2);
    let [volume, _] = wedge(α);
    let share = (α - α.sin() * α.cos()) / PI;
    CirclePressure { most: pressing * sagitta / (r * r * volume), least: 0.0, contact: r * sagitta, share }
}

/// α at which the contact of a circle ends, u₀ = r cos α, where the resultant acts at `share` of the radius, from 1/4 to 1.
pub fn contact_angle(share: f64) -> f64 {
    // The narrower the contact, the farther out it carries: bisected in the angle, in which it is smooth at both ends.
    let (mut narrow, mut wide) = (0.0, PI);
    loop {
        let α = (narrow + wide) / 2.0;
        if α <= narrow || α >= wide {
            return α;
        }
        let [volume, moment] = wedge(α);
        if moment > share * volume { narrow = α } else { wide = α }
    }
}

/// ∫(u − u₀) c du and ∫(u − u₀) u c du from u₀ = cos α to 1, of a circle of radius 1: 2 ∫(cos φ − cos α) sin² φ dφ, and the same
/// times cos φ, from 0 to α.
fn wedge(α: f64) -> [f64; 2] {
    // Where the closed forms cancel, their series in α².
    const VOLUME: [f64; 8] = [
        2.0 / 15.0,
        -11.0 / 315.0,
        17.0 / 3780.0,
        -461.0 / 1247400.0,
        8303.0 / 389188800.0,
        -24911.0 / 27243216000.0,
        168151.0 / 5557616064000.0,
        -1513361.0 / 1900704693888000.0,
    ];
    const MOMENT: [f64; 8] = [
        2.0 / 15.0,
        -4.0 / 63.0,
        2.0 / 135.0,
        -68.0 / 31185.0,
        124.0 / 552825.0,
        -8.0 / 467775.0,
        10922.0 / 10854718875.0,
        -1028.0 / 21837140325.0,
    ];
    if α < 0.5 {
        let series = |terms: [f64; 8]| terms.iter().rev().fold(0.0, |sum, term| sum * α * α + term);
        return [VOLUME, MOMENT].map(|terms| α.powi(5) * series(terms));
    }
    let (sin, cos) = α.sin_cos();
    let volume = 2.0 / 3.0 * sin.powi(3) - cos * (α - sin * cos);
    let moment = α / 4.0 - (4.0 * α).sin() / 16.0 - 2.0 / 3.0 * cos * sin.powi(3);
    [volume, moment]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ f c du over a circle of radius r by the midpoint rule in the angle, in which it converges fast.
    fn over_circle(r: f64, from: f64, f: impl Fn(f64) -> f64) -> f64 {
        let end = (from / r).acos();
        let n = 20_000;
        let step = end / f64::from(n);
        let at = |i| {
            let φ = (f64::from(i) + 0.5) * step;
            2.0 * r * r * φ.sin().powi(2) * f(r * φ.cos()) * step
        };
        (0..n).map(at).sum()
    }

    /// The pressures add up to the resultant, act where it does, never pull, and go to zero where the contact ends.
    #[test]
    fn a_circle_bears_in_equilibrium() {
        let (pressing, r) = (7e5, 1.3);
        for i in 0..1000 {
            let eccentricity = f64::from(i) * 1e-3 * r;
            let CirclePressure { most, least, contact, share } = circle_pressure(pressing, eccentricity, r);
            assert!(most >= least && least >= 0.0 && contact <= 2.0 * r, "{eccentricity}");
            let begin = r - contact;
            let pressure = |u: f64| least + (most - least) * (u - begin) / contact;
            let sum = over_circle(r, begin, pressure);
            let moment = over_circle(r, begin, |u| u * pressure(u));
            assert!((sum / pressing - 1.0).abs() < 1e-7, "{eccentricity}: {sum}");
            assert!((moment / pressing - eccentricity).abs() < 1e-7 * r, "{eccentricity}: {moment}");
            let area = over_circle(r, begin, |_| 1.0) / (PI * r * r);
            assert!((area - share).abs() < 1e-7, "{eccentricity}: {share}");
        }
    }

    /// Series and closed form meet where one takes over.
    #[test]
    fn the_series_meets_the_closed_form() {
        let [below, above] = [0.5_f64.next_down(), 0.5].map(wedge);
        for (below, above) in below.into_iter().zip(above) {
            assert!((below / above - 1.0).abs() < 1e-12, "{below} {above}");
        }
    }

    /// A pressure on a circular base against the sum of its strips.
    #[test]
    fn a_pressure_on_a_circle_is_the_sum_of_its_strips() {
        let at = |position, pressure| PressureAt { position, pressure };
        let points = [at(0.2, 3e3), at(0.9, -1e3), at(0.9, 5e3), at(1.7, 2e3)];
        let (force, moment) = Plan::Circle.resultant(&points, 2.0);
        let (n, mut sum) = (400_000, (0.0, 0.0));
        for pair in points.windows(2).filter(|pair| pair[0].position < pair[1].position) {
            let ds = (pair[1].position - pair[0].position) / f64::from(n);
            for i in 0..n {
                let part = (f64::from(i) + 0.5) / f64::from(n);
                let s = pair[0].position + part * (pair[1].position - pair[0].position);
                let p = pair[0].pressure + part * (pair[1].pressure - pair[0].pressure);
                let da = 2.0 * (1.0 - (s - 1.0) * (s - 1.0)).sqrt() * ds;
                sum = (sum.0 + p * da, sum.1 + p * s * da);
            }
        }
        assert!((force - sum.0).abs() < 1e-6 * sum.0.abs(), "{force} {}", sum.0);
        assert!((moment - sum.1).abs() < 1e-6 * sum.1.abs(), "{moment} {}", sum.1);
    }
}
