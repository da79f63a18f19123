//! What is no stack, and why.

use super::{Joint, MOST, Shaking, Stack, StackBody};
use crate::error::InputError;
use crate::quantity::{Expected, Quantity};
use crate::wrench::Wrench;

/// Reason why there is no such stack.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StackError {
    /// Other numbers of bodies and joints, or none.
    #[error("bodies: {bodies}, joints: {joints}; expected one joint below each body, and one body at least")]
    Count {
        /// Number of bodies.
        bodies: usize,
        /// Number of joints.
        joints: usize,
    },
    /// A number of a body or a joint that makes no sense.
    #[error("{} {}{}: {error}", if *is_joint { "joint" } else { "body" }, place + 1, if *is_variable { ", variable load" } else { "" })]
    Number {
        /// True of a joint.
        is_joint: bool,
        /// Its place from the ground up, from zero.
        place: usize,
        /// True of a variable load.
        is_variable: bool,
        /// Reason.
        error: InputError,
    },
    /// A joint that is not above the one before.
    #[error("joint {} is at {above}, and joint {} below it at {below}; expected bodies and joints from the ground up", place + 1, place)]
    Order {
        /// Place of the upper one, from zero.
        place: usize,
        /// Its height.
        above: f64,
        /// Height of the joint before.
        below: f64,
    },
    /// A shaking in g where there is no gravity.
    #[error("{what} is {value}, in g, and gravity is 0; expected gravity above zero beside it")]
    NoGravity {
        /// The acceleration: horizontal or vertical.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number of the shaking that makes no sense.
    #[error("{0}: {1}")]
    Shaking(&'static str, InputError),
    /// A load factor that makes no sense.
    #[error(transparent)]
    LoadFactor(#[from] InputError),
    /// Another number of modes than of joints.
    #[error("there are {modes} modes and {joints} joints; expected a mode for each joint")]
    Modes {
        /// Number of modes.
        modes: usize,
        /// Number of joints.
        joints: usize,
    },
    /// More bodies than are enumerated.
    #[error(
        "there are {0} bodies; the modes of {MOST} at most are enumerated, their rest and departure of any number"
    )]
    TooMany(usize),
}

impl Stack {
    /// Refuses what no stack can be.
    pub(super) fn check(&self) -> Result<(), StackError> {
        let (bodies, joints) = (self.bodies.len(), self.joints.len());
        if bodies != joints || bodies == 0 {
            return Err(StackError::Count { bodies, joints });
        }
        for (place, body) in self.bodies.iter().enumerate() {
            for (is_variable, checked) in
                [(false, body.check()), (true, StackBody::check_load(body.variable))]
            {
                checked.map_err(|error| StackError::Number { is_joint: false, place, is_variable, error })?;
            }
        }
        for (place, joint) in self.joints.iter().enumerate() {
            joint.check().map_err(|error| StackError::Number {
                is_joint: true,
                place,
                is_variable: false,
                error,
            })?;
        }
        for (below, pair) in self.joints.windows(2).enumerate() {
            let [below_h, above] = [pair[0].h, pair[1].h];
            if above <= below_h {
                return Err(StackError::Order { place: below + 1, above, below: below_h });
            }
        }
        let Shaking { gravity, horizontal, vertical, .. } = self.shaking;
        InputError::not_negative(Quantity::Gravity, gravity)
            .map_err(|error| StackError::Shaking("gravity", error))?;
        for (what, value) in [("horizontal", horizontal), ("vertical", vertical)] {
            InputError::finite(Quantity::Acceleration, value)
                .map_err(|error| StackError::Shaking(what, error))?;
            if gravity == 0.0 && value != 0.0 {
                return Err(StackError::NoGravity { what, value });
            }
        }
        Ok(())
    }
}

impl StackBody {
    fn check(&self) -> Result<(), InputError> {
        InputError::positive(Quantity::InertiaX, self.m_x)?;
        InputError::positive(Quantity::InertiaY, self.m_y)?;
        InputError::positive(Quantity::MomentOfInertia, self.inertia)?;
        InputError::finite(Quantity::CentroidOffset, self.x)?;
        InputError::finite(Quantity::CentroidHeight, self.y)?;
        StackBody::check_load(self.permanent)
    }

    fn check_load(wrench: Wrench) -> Result<(), InputError> {
        InputError::finite(Quantity::WrenchX, wrench.x)?;
        InputError::finite(Quantity::WrenchP, wrench.p)?;
        InputError::finite(Quantity::WrenchM, wrench.m)?;
        Ok(())
    }
}

impl Joint {
    fn check(&self) -> Result<(), InputError> {
        InputError::finite(Quantity::JointHeight, self.h)?;
        InputError::finite(Quantity::JointLeft, self.l)?;
        InputError::finite(Quantity::JointRight, self.r)?;
        if self.r <= self.l {
            return Err(InputError::new(Quantity::JointRight, self.r, Expected::BeyondLeftEnd));
        }
        InputError::not_negative(Quantity::MuS, self.mu_s)?;
        InputError::not_negative(Quantity::MuK, self.mu_k)?;
        if self.mu_s < self.mu_k {
            return Err(InputError::new(Quantity::MuS, self.mu_s, Expected::NotBelowKineticFriction));
        }
        Ok(())
    }
}
