//! The accelerations and reactions at the moment a mode begins.

use crate::mode::Corner;

/// The acceleration of a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerAcceleration {
    /// Along the base, to the right.
    pub along: f64,
    /// Upwards.
    pub up: f64,
}

/// Accelerations and reactions at initiation.
///
/// In the report's problem lengths are in B, accelerations in g, θ̈ in g/B and forces in m g; in the
/// [general contact problem](crate::contact) they have the units of its input.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motion {
    /// ẍ of the centre of mass, to the right.
    pub x_ddot: f64,
    /// ÿ of the centre of mass, upwards.
    pub y_ddot: f64,
    /// θ̈, counter-clockwise.
    pub theta_ddot: f64,
    /// f_x, the horizontal reaction on the body, to the right.
    pub f_x: f64,
    /// f_y, the vertical reaction on the body, upwards.
    pub f_y: f64,
    /// ξ, the distance of f_y to the right of the centre of mass; zero where there is no reaction.
    pub xi: f64,
    /// ẍ_O = ẍ_O', the acceleration of the base along the ground, to the right.
    pub slip: f64,
    /// ÿ_O, upwards.
    pub lift_o: f64,
    /// ÿ_O', upwards.
    pub lift_o_prime: f64,
}

impl Motion {
    /// The acceleration of a corner.
    pub fn at(&self, corner: Corner) -> CornerAcceleration {
        let up = match corner {
            Corner::O => self.lift_o,
            Corner::OPrime => self.lift_o_prime,
        };
        CornerAcceleration { along: self.slip, up }
    }

    /// The motion in other units: accelerations times `acceleration`, lengths times `length`, forces times `force`,
    /// and θ̈ times `acceleration`/`length`.
    pub fn scaled(&self, acceleration: f64, length: f64, force: f64) -> Motion {
        Motion {
            x_ddot: self.x_ddot * acceleration,
            y_ddot: self.y_ddot * acceleration,
            theta_ddot: self.theta_ddot * (acceleration / length),
            f_x: self.f_x * force,
            f_y: self.f_y * force,
            xi: self.xi * length,
            slip: self.slip * acceleration,
            lift_o: self.lift_o * acceleration,
            lift_o_prime: self.lift_o_prime * acceleration,
        }
    }

    /// The motion seen in a mirror: x to the left, θ clockwise, O and O' exchanged.
    pub fn mirrored(&self) -> Motion {
        // `0.0 − x` rather than `−x`, so that nothing becomes −0.
        Motion {
            x_ddot: 0.0 - self.x_ddot,
            y_ddot: self.y_ddot,
            theta_ddot: 0.0 - self.theta_ddot,
            f_x: 0.0 - self.f_x,
            f_y: self.f_y,
            xi: 0.0 - self.xi,
            slip: 0.0 - self.slip,
            lift_o: self.lift_o_prime,
            lift_o_prime: self.lift_o,
        }
    }
}
