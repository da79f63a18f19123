//! The classical checks of a caisson: safety factors and heel pressure.
//!
//! ```text
//! SF_sliding = μ(W' − U)/P        SF_overturning = (W' t − M_U)/M_p, about the heel
//!                                 (W'(B_c − t) − U B_c + M_U)/(−M_p), about the toe, where the force turns that way
//! W_e = W' − U                    t_e = (W' t − M_U − M_p)/W_e
//! p_e = 2W_e/(3t_e)               for 0 < t_e ≤ B_c/3: the base is pressed near the heel only
//!       (2W_e/B_c)(2 − 3t_e/B_c)  up to 2B_c/3; beyond, the heel is unloaded, and beyond B_c there is no contact
//! ```
//!
//! They say whether the body stays at rest. Which mode begins when it does not, they cannot say.

/// Vertical and horizontal actions on a caisson as a designer adds them up; N and N·m per metre run, about the heel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actions {
    /// W', N/m: weight less buoyancy.
    pub buoyant_weight: f64,
    /// t, m: its arm to the heel.
    pub weight_arm: f64,
    /// U, N/m.
    pub uplift: f64,
    /// M_U, N·m/m: its moment about the heel.
    pub uplift_moment: f64,
    /// P, N/m: towards the heel.
    pub force: f64,
    /// M_p, N·m/m: its moment about the base.
    pub force_moment: f64,
}

/// How the base is pressed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HeelPressure {
    /// The largest pressure, at the heel, Pa.
    Pressed(f64),
    /// The resultant lies so far from the heel that the heel is unloaded.
    Unloaded,
    /// The resultant of all loads misses the base: the base cannot carry it at rest.
    OutsideBase,
    /// Nothing presses the body on its base: W' ≤ U.
    Lifted,
}

/// The classical results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stability {
    /// SF_sliding; infinite without a horizontal force.
    pub sliding: f64,
    /// SF_overturning, about the heel; infinite where no force turns the body that way, and zero where it turns without
    /// one, by uplift or eccentric weight alone.
    pub overturning: f64,
    /// The same about the other corner, the toe: a force far below the centre of mass turns the body about it.
    pub overturning_about_toe: f64,
    /// t_e, m: distance of the resultant from the heel; `None` if nothing presses.
    pub resultant_arm: Option<f64>,
    /// p_e.
    pub heel_pressure: HeelPressure,
}

impl Stability {
    /// The smaller of both factors against overturning.
    pub fn least_overturning(&self) -> f64 {
        self.overturning.min(self.overturning_about_toe)
    }
}

impl Actions {
    /// Safety factors with friction μ, and the heel pressure on a base `base_width` wide (m).
    pub fn stability(&self, friction: f64, base_width: f64) -> Stability {
        let Actions { buoyant_weight, weight_arm, uplift, uplift_moment, force, force_moment } = *self;
        let pressing = buoyant_weight - uplift;
        let resisting = buoyant_weight * weight_arm - uplift_moment;
        let about_toe = pressing * base_width - resisting;
        let ratio = |resistance: f64, action: f64| match () {
            () if action > 0.0 => resistance / action,
            () if resistance < 0.0 => 0.0,
            () => f64::INFINITY,
        };
        let resultant_arm = (pressing > 0.0).then(|| (resisting - force_moment) / pressing);
        let heel_pressure = match resultant_arm {
            Some(arm) if arm > 0.0 && arm <= base_width / 3.0 => {
                HeelPressure::Pressed(2.0 * pressing / (3.0 * arm))
            }
            Some(arm) if arm > 0.0 && arm < 2.0 * base_width / 3.0 => {
                HeelPressure::Pressed(2.0 * pressing / base_width * (2.0 - 3.0 * arm / base_width))
            }
            Some(arm) if arm > 0.0 && arm <= base_width => HeelPressure::Unloaded,
            Some(_) => HeelPressure::OutsideBase,
            None => HeelPressure::Lifted,
        };
        Stability {
            sliding: ratio(friction * pressing, force),
            overturning: ratio(resisting, force_moment),
            overturning_about_toe: ratio(about_toe, -force_moment),
            resultant_arm,
            heel_pressure,
        }
    }
}
