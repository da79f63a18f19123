//! An elastic base: how far a moment turns the body, and the largest moment it stands.
//!
//! ```text
//!      ┌──────────┐           M/(PB)
//!      │    P     │ ⟲ θ        1 ┤            ______ 1 − ω
//!      │    ▼     │              │        .-'
//!      └──────────┘            ⅓ ┤     .'   uplift
//!       ╪ ╪ ╪ ╪ ╪  k_n           │  .' full contact
//!                                └─────────────── τ = θ k_n B²/P
//! ```
//!
//! Springs of k_n per area that do not pull and yield at q_u, under a rigid body on a base 2B wide. With τ = θk_nB²/P and ω = P/(2Bq_u),
//! the moment of the reaction about the middle of the base is, in P B,
//!
//! | M/(PB) | from | to |
//! |---|---|---|
//! | ⅔τ | 0 | min(½, (1/ω−1)/2): full contact; the kern, ε = ⅓, ends at τ = ½ |
//! | 1 − √(2/(9τ)) | ½ | 1/(8ω²), for ω < ½: uplift |
//! | ((1−ω)/ω)[1 − √(2(1−ω)/(9ωτ))] | (1/ω−1)/2 | 1/(8ω(1−ω)), for ω > ½: yield, full contact |
//! | 1 − ω − 1/(192ω³τ²) | there | without end: uplift and yield |
//!
//! The pieces meet with one slope. Raised slowly, the weight's own moment grows with the rotation: at the height d above the base it
//! takes κτ, κ = Pd/(k_nB³), off the moment that is left for the load. What is left is largest where the slope is κ:
//!
//! ```text
//! 1 − (3κ/2)^⅓                      if it is uplift there, (18κ²)^−⅓ ≤ 1/(8ω²)
//! A (1 − (3κ/2)^⅓), A = (1−ω)/ω     if it is yield with full contact there
//! 1 − ω − (9κ²/256)^⅓/ω             on the last piece
//! 0                                 for κ ≥ ⅔: it does not stand at all
//! ```
//!
//! k_n → ∞ gives the [base of strength](super::strength), 1 − ω; q_u → ∞ the corner. No stiffness moves the load of gross sliding,
//! |X| = μP.
//!
//! | symbol | identifier | unit |
//! |---|---|---|
//! | k_n | `stiffness` | N/m³ |
//! | q_u | `strength` | Pa, infinite if it does not yield |
//! | B, P, d | `half_width`, `p`, `height` | m, N per metre run, m |
//!
//! Limits: k_n is no constant of a soil; it depends on the width and on the load. Loading only: what has yielded does not come back.
//! Reference: the uplift–yield problem of Allotey & El Naggar 2003, seen in abstract; derived here.
//!
//! ```
//! use standfast::ground::elastic::ElasticBase;
//!
//! let base = ElasticBase::new(7.5, 2.2e6, 50e6)?;
//! let kern = base.rotation(base.half_width() * base.p() / 3.0).unwrap();
//! assert!((kern - 0.5 * 2.2e6 / (50e6 * 7.5 * 7.5)).abs() < 1e-15); // τ = ½
//! # Ok::<(), standfast::InputError>(())
//! ```

use crate::error::InputError;
use crate::quantity::Quantity;

/// A base of springs under a load P; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticBase {
    half_width: f64,
    p: f64,
    stiffness: f64,
    omega: f64,
}

/// State of the contact between base and ground as the body turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum ContactState {
    /// All of it, elastically.
    Full,
    /// Part of it lifts.
    Uplift,
    /// All of it, its edge yields.
    Yield,
    /// Part of it lifts, and its edge yields.
    UpliftAndYield,
}

/// The most a body on an elastic base stands under a load that is raised slowly.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LargestMoment {
    /// The moment about the middle of the base, N·m per metre run; zero if the body does not stand.
    pub moment: f64,
    /// The rotation it is reached at, rad.
    pub rotation: f64,
    /// State of the contact there.
    pub state: ContactState,
}

impl ElasticBase {
    /// A base of `half_width` B (m) with the `stiffness` k_n (N/m³) that does not yield, pressed by `p` (N per metre run).
    ///
    /// # Errors
    /// If one of them is not above zero.
    pub fn new(half_width: f64, p: f64, stiffness: f64) -> Result<ElasticBase, InputError> {
        Ok(ElasticBase {
            half_width: InputError::positive(Quantity::HalfWidth, half_width)?,
            p: InputError::positive(Quantity::WrenchP, p)?,
            stiffness: InputError::positive(Quantity::Stiffness, stiffness)?,
            omega: 0.0,
        })
    }

    /// Base with the strength q_u (Pa).
    ///
    /// # Errors
    /// If it is not above zero.
    pub fn with_strength(self, strength: f64) -> Result<ElasticBase, InputError> {
        let strength = InputError::positive(Quantity::Strength, strength)?;
        Ok(ElasticBase { omega: self.p / (2.0 * self.half_width * strength), ..self })
    }

    /// B, m.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// P, N per metre run.
    pub fn p(&self) -> f64 {
        self.p
    }

    /// ω = P/(2Bq_u); zero if the base does not yield. From 1 on it does not bear P, and no moment.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// θ of τ = 1: P/(k_nB²), rad.
    pub fn unit_rotation(&self) -> f64 {
        self.p / (self.stiffness * self.half_width * self.half_width)
    }

    /// The rotations (rad), rising, at which the way in which the base is pressed changes: one where it does not yield, two where it does,
    /// none from ω = 1 on.
    ///
    /// ```
    /// use standfast::ground::elastic::ElasticBase;
    ///
    /// let base = ElasticBase::new(7.5, 2.2e6, 50e6)?;
    /// assert_eq!(base.joints(), [0.5 * base.unit_rotation()]);
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    pub fn joints(&self) -> Vec<f64> {
        let real = joints(self.omega).into_iter().filter(|τ| *τ > 0.0 && τ.is_finite());
        real.map(|τ| τ * self.unit_rotation()).collect()
    }

    /// The moment about the middle of the base at a `rotation` (rad), N·m per metre run; of the same sign.
    ///
    /// # Errors
    /// If `rotation` is not finite.
    pub fn moment(&self, rotation: f64) -> Result<f64, InputError> {
        let rotation = InputError::finite(Quantity::Rotation, rotation)?;
        let share = moment(self.omega, rotation.abs() / self.unit_rotation());
        Ok(share.copysign(rotation) * self.p * self.half_width + 0.0)
    }

    /// State of the contact at a `rotation` (rad).
    ///
    /// # Errors
    /// If `rotation` is not finite.
    pub fn state(&self, rotation: f64) -> Result<ContactState, InputError> {
        let rotation = InputError::finite(Quantity::Rotation, rotation)?;
        Ok(state(self.omega, rotation.abs() / self.unit_rotation()))
    }

    /// The rotation (rad) under a moment about the middle of the base (N·m per metre run); `None` from P B (1 − ω) on, which no rotation
    /// bears.
    pub fn rotation(&self, moment: f64) -> Option<f64> {
        let τ = rotation(self.omega, moment.abs() / (self.p * self.half_width))?;
        Some(τ.copysign(moment) * self.unit_rotation() + 0.0)
    }

    /// The largest moment of a load that is raised slowly while P, at `height` d above the base (m), leans with the body: P–Δ.
    ///
    /// # Errors
    /// If `height` is not above zero.
    pub fn largest_moment(&self, height: f64) -> Result<LargestMoment, InputError> {
        let height = InputError::positive(Quantity::D, height)?;
        let kappa = self.p * height / (self.stiffness * self.half_width.powi(3));
        let τ = steepness_reached(self.omega, kappa);
        Ok(LargestMoment {
            moment: (moment(self.omega, τ) - kappa * τ).max(0.0) * self.p * self.half_width,
            rotation: τ * self.unit_rotation(),
            state: state(self.omega, τ),
        })
    }

    /// k_overturn: the force, in P, whose moment about the base is the largest the body stands; for γ and k' of the report, of which P acts
    /// at H above the base. Infinite for k' = −1.
    ///
    /// # Errors
    /// If `gamma` is not above zero or `k_prime` not finite.
    pub fn k_overturn(&self, gamma: f64, k_prime: f64) -> Result<f64, InputError> {
        let gamma = InputError::positive(Quantity::Slenderness, gamma)?;
        let k_prime = InputError::finite(Quantity::KPrime, k_prime)?;
        let largest = self.largest_moment(gamma * self.half_width)?.moment / (self.p * self.half_width);
        Ok(largest / (gamma * (1.0 + k_prime).abs()))
    }

    /// Points of the curve of moment and rotation from zero to `rotation` (rad), for a figure: `[θ, M]` in rad and N·m per metre run, its
    /// joints among them.
    ///
    /// # Errors
    /// If `rotation` is not above zero.
    pub fn curve(&self, rotation: f64) -> Result<Vec<[f64; 2]>, InputError> {
        let rotation = InputError::positive(Quantity::Rotation, rotation)?;
        let end = rotation / self.unit_rotation();
        let mut at: Vec<f64> = (0..=200).map(|i| end * f64::from(i) / 200.0).collect();
        at.extend(joints(self.omega).into_iter().filter(|τ| *τ < end));
        at.sort_by(f64::total_cmp);
        let scale = self.p * self.half_width;
        Ok(at.into_iter().map(|τ| [τ * self.unit_rotation(), moment(self.omega, τ) * scale]).collect())
    }
}

/// τ at which full elastic contact ends, and at which both uplift and yield begin.
fn joints(omega: f64) -> [f64; 2] {
    match omega {
        0.0 => [0.5, f64::INFINITY],
        ω if ω < 0.5 => [0.5, 0.125 / (ω * ω)],
        ω if ω < 1.0 => [0.5 * (1.0 / ω - 1.0), 0.125 / (ω * (1.0 - ω))],
        _ => [0.0, 0.0],
    }
}

fn state(omega: f64, τ: f64) -> ContactState {
    let [first, last] = joints(omega);
    match () {
        () if τ <= first => ContactState::Full,
        () if τ > last => ContactState::UpliftAndYield,
        () if omega < 0.5 => ContactState::Uplift,
        () => ContactState::Yield,
    }
}

/// M/(PB) at τ ≥ 0.
fn moment(omega: f64, τ: f64) -> f64 {
    if omega >= 1.0 {
        return 0.0;
    }
    let ω = omega;
    match state(omega, τ) {
        ContactState::Full => 2.0 / 3.0 * τ,
        ContactState::Uplift => 1.0 - (2.0 / (9.0 * τ)).sqrt(),
        ContactState::Yield => {
            let room = (1.0 - ω) / ω;
            room * (1.0 - (2.0 * room / (9.0 * τ)).sqrt())
        }
        ContactState::UpliftAndYield => 1.0 - ω - 1.0 / (192.0 * ω.powi(3) * τ * τ),
    }
}

/// τ at M/(PB) ≥ 0; `None` if there is none.
fn rotation(omega: f64, share: f64) -> Option<f64> {
    let ω = omega;
    if share.is_nan() || share >= 1.0 - ω {
        return None;
    }
    let [first, last] = joints(ω);
    Some(match () {
        () if share <= 2.0 / 3.0 * first => 1.5 * share,
        () if share > moment(ω, last) => (192.0 * ω.powi(3) * (1.0 - ω - share)).sqrt().recip(),
        () if ω < 0.5 => 2.0 / (9.0 * (1.0 - share).powi(2)),
        () => {
            let room = (1.0 - ω) / ω;
            2.0 * room / (9.0 * (1.0 - share / room).powi(2))
        }
    })
}

/// τ at which the slope of M/(PB) has fallen to κ: zero for κ ≥ ⅔, where it never is above.
fn steepness_reached(omega: f64, kappa: f64) -> f64 {
    let ω = omega;
    if kappa >= 2.0 / 3.0 || ω >= 1.0 {
        return 0.0;
    }
    let [_, last] = joints(ω);
    let middle = if ω < 0.5 {
        (18.0 * kappa * kappa).powf(-1.0 / 3.0)
    } else {
        let room = (1.0 - ω) / ω;
        (room.powi(3) / (18.0 * kappa * kappa)).cbrt()
    };
    if middle <= last { middle } else { 1.0 / (ω * (96.0 * kappa).cbrt()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The base as what it is: a pressure that is cut at zero and at its strength, in equilibrium with P; by quadrature of 4000 strips.
    fn by_strips(omega: f64, τ: f64) -> f64 {
        // x from −1 to 1 in B; p in P/(2B): between 0 and 1/ω; slope 2τ.
        let n = 4000;
        let places: Vec<f64> = (0..n).map(|i| (f64::from(i) + 0.5) * 2.0 / f64::from(n) - 1.0).collect();
        let most = if omega > 0.0 { 1.0 / omega } else { f64::INFINITY };
        let pressure = |level: f64, x: f64| (level + 2.0 * τ * x).clamp(0.0, most);
        let (mut low, mut high) = (-2.0 * τ - 1.0, 2.0 * τ + 1.0 + 4.0 * (1.0 + τ).sqrt());
        for _ in 0..100 {
            let level = (low + high) / 2.0;
            let sum: f64 = places.iter().map(|x| pressure(level, *x)).sum::<f64>() / f64::from(n);
            if sum < 1.0 { low = level } else { high = level }
        }
        places.iter().map(|x| x * pressure(low, *x)).sum::<f64>() / f64::from(n)
    }

    #[test]
    fn the_curve_is_that_of_the_strips() {
        for ω in [0.0, 0.1, 0.3, 0.49, 0.5, 0.6, 0.8, 0.95] {
            for τ in [0.01, 0.1, 0.3, 0.5, 0.7, 1.0, 2.0, 5.0, 20.0] {
                let (ours, theirs) = (moment(ω, τ), by_strips(ω, τ));
                assert!((ours - theirs).abs() < 2e-3 * ours.max(0.05), "{ω} {τ}: {ours} {theirs}");
            }
        }
    }

    /// Value and slope are the same on either side of each joint, and the inverse gives the rotation back.
    #[test]
    fn the_curve_is_smooth_and_has_its_inverse() {
        for ω in [0.0, 0.05, 0.2, 0.4999, 0.5, 0.5001, 0.7, 0.95] {
            for joint in joints(ω).into_iter().filter(|joint| joint.is_finite()) {
                let h = 1e-5 * joint;
                let [a, b, c] = [joint - h, joint, joint + h].map(|τ| moment(ω, τ));
                assert!((c - a) < 3.0 * h, "{ω} at {joint}: a step");
                let slopes = [(b - a) / h, (c - b) / h];
                assert!((slopes[0] / slopes[1] - 1.0).abs() < 1e-3, "{ω} at {joint}: {slopes:?}");
            }
            let mut last = 0.0;
            for i in 1..400 {
                let τ = 1.03f64.powi(i) * 1e-3;
                let share = moment(ω, τ);
                assert!(share > last && share < 1.0 - ω);
                last = share;
                if share < (1.0 - ω) * 0.999 {
                    assert!((rotation(ω, share).unwrap() / τ - 1.0).abs() < 1e-9, "{ω} {τ}");
                }
            }
            assert_eq!(rotation(ω, 1.0 - ω), None);
        }
    }

    /// The largest of M/(PB) − κτ by search, and by the specification's formulas.
    #[test]
    fn the_largest_moment_is_the_largest() {
        for ω in [0.0, 0.1, 0.3, 0.5, 0.7, 0.9] {
            for κ in [1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.6] {
                let τ = steepness_reached(ω, κ);
                let ours = moment(ω, τ) - κ * τ;
                let left = |τ: f64| moment(ω, τ) - κ * τ;
                let search = (0..4000).map(|i| left(1.01f64.powi(i) * 1e-6)).fold(0.0, f64::max);
                assert!(ours >= search - 1e-15 && ours <= search + 1e-4, "{ω} {κ}: {ours} {search}");
                if state(ω, τ) == ContactState::Uplift {
                    assert!((ours - (1.0 - (1.5 * κ).cbrt())).abs() < 1e-12);
                }
                if state(ω, τ) == ContactState::UpliftAndYield {
                    assert!((ours - (1.0 - ω - (9.0 * κ * κ / 256.0).cbrt() / ω)).abs() < 1e-12);
                }
            }
            assert_eq!(steepness_reached(ω, 2.0 / 3.0), 0.0);
            // k_n → ∞: the base of strength.
            let stiff = steepness_reached(ω, 1e-18);
            assert!((moment(ω, stiff) - 1e-18 * stiff - (1.0 - ω)).abs() < 2e-6);
        }
    }

    #[test]
    fn a_base_in_metres() {
        let base = ElasticBase::new(7.5, 2.2e6, 50e6).unwrap().with_strength(600e3).unwrap();
        assert!((base.omega() - 2.2e6 / (15.0 * 600e3)).abs() < 1e-15);
        let θ = base.rotation(5e6).unwrap();
        assert!((base.moment(θ).unwrap() / 5e6 - 1.0).abs() < 1e-12);
        assert_eq!(base.moment(-θ).unwrap(), -base.moment(θ).unwrap());
        assert_eq!(base.rotation(2.2e6 * 7.5), None);
        let most = base.largest_moment(5.25).unwrap();
        assert!(most.moment < 2.2e6 * 7.5 * (1.0 - base.omega()) && most.moment > 0.0);
        let k = base.k_overturn(0.7, 0.2).unwrap();
        assert!((k * 2.2e6 * 5.25 * 1.2 / most.moment - 1.0).abs() < 1e-12);
        let curve = base.curve(0.01).unwrap();
        assert!(curve.windows(2).all(|pair| pair[0][0] < pair[1][0] && pair[0][1] < pair[1][1]));
        assert_eq!(ElasticBase::new(7.5, 0.0, 1.0).unwrap_err().quantity, Quantity::WrenchP);
    }
}
