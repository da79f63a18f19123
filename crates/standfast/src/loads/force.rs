//! Horizontal forces in SI units, and their reduction to the report's k and k'.

use super::{BodyPoint, Load, LoadKind};
use crate::body::Body;
use crate::error::InputError;
use crate::initiation::Point;
use crate::mode::{Mode, Modes, Slip};
use crate::motion::Motion;
use crate::quantity::Quantity;

/// A horizontal force per metre run of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HorizontalForce {
    magnitude: f64,
    elevation: f64,
    direction: Slip,
}

impl HorizontalForce {
    /// A force of `magnitude` (N/m, zero or more) at `elevation` above the base (m), pointing in `direction`.
    ///
    /// # Errors
    /// If the magnitude is negative, or a number is not finite.
    pub fn new(magnitude: f64, elevation: f64, direction: Slip) -> Result<HorizontalForce, InputError> {
        Ok(HorizontalForce {
            magnitude: InputError::not_negative(Quantity::Force, magnitude)?,
            elevation: InputError::finite(Quantity::ForceElevation, elevation)?,
            direction,
        })
    }

    /// N per metre run.
    pub fn magnitude(&self) -> f64 {
        self.magnitude
    }

    /// Height above the base, m.
    pub fn elevation(&self) -> f64 {
        self.elevation
    }

    /// Direction in which it points.
    pub fn direction(&self) -> Slip {
        self.direction
    }

    /// The force as a load that varies.
    pub fn load(&self) -> Load {
        let at = BodyPoint { x: 0.0, y: self.elevation };
        Load { kind: LoadKind::Horizontal, ..Load::force(at, self.direction.sign() * self.magnitude, 0.0) }
    }

    /// The report's problem for this force on `body` with `friction` μ, at the acceleration of gravity `gravity`
    /// (m/s²).
    ///
    /// # Errors
    /// If `friction` is negative or not finite, `gravity` not above zero, or the reduced numbers overflow.
    pub fn reduce(&self, body: &Body, friction: f64, gravity: f64) -> Result<Reduced, InputError> {
        let gravity = InputError::positive(Quantity::Gravity, gravity)?;
        let half_height = body.height() / 2.0;
        let k = self.magnitude / (body.mass() * gravity);
        let k_prime = (self.elevation - half_height) / half_height;
        let point = Point::new(body.slenderness(), k_prime, k, friction)?;
        Ok(Reduced { point, mirrored: self.direction == Slip::Right })
    }
}

/// A force reduced to a point of the report's k–μ plane. The report's force points left; a force to the right is its
/// mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reduced {
    /// The point, for a force to the left.
    pub point: Point,
    /// True if the force points right, so that modes and motions are to be mirrored.
    pub mirrored: bool,
}

impl Reduced {
    /// The inverse of [`HorizontalForce::reduce`]: a body of `width` 2B (m) and `mass` (kg per metre run), and the force on
    /// it, that have these numbers at the acceleration of gravity `gravity` (m/s²).
    ///
    /// # Errors
    /// If one of them is not above zero, or a dimension overflows.
    pub fn with_size(
        &self,
        width: f64,
        mass: f64,
        gravity: f64,
    ) -> Result<(Body, HorizontalForce), InputError> {
        let gravity = InputError::positive(Quantity::Gravity, gravity)?;
        let body = Body::new(width, self.point.gamma() * width, mass)?;
        let direction = if self.mirrored { Slip::Right } else { Slip::Left };
        let magnitude = self.point.k() * mass * gravity;
        let elevation = (1.0 + self.point.k_prime()) * body.height() / 2.0;
        Ok((body, HorizontalForce::new(magnitude, elevation, direction)?))
    }

    /// The mode of the real body, mirrored if the force points right.
    pub fn mode(&self) -> Mode {
        self.orient(self.point.mode())
    }

    /// A mode of the report's problem as the real body shows it.
    pub fn orient(&self, mode: Mode) -> Mode {
        if self.mirrored { mode.mirrored() } else { mode }
    }

    /// Point in the f64 beside it whose mode is `mode`, where rounding has put it on the other side of a boundary; else as it is.
    pub(crate) fn beside(self, mode: Option<Mode>) -> Reduced {
        let moved = |steps: i32| {
            let k = self.point.k() * (1.0 + f64::from(steps) * f64::EPSILON);
            let point = Point::new(self.point.gamma(), self.point.k_prime(), k, self.point.mu()).ok()?;
            Some(Reduced { point, ..self }).filter(|reduced| Some(reduced.mode()) == mode)
        };
        (0..=16).flat_map(|steps| [-steps, steps]).find_map(moved).unwrap_or(self)
    }

    /// The other consistent modes of the real body, mirrored if the force points right.
    pub fn others(&self) -> Modes {
        let others = self.point.others();
        if self.mirrored { others.mirrored() } else { others }
    }

    /// The motion of the real body, mirrored if the force points right; non-dimensional.
    pub fn motion(&self) -> Motion {
        let motion = self.point.motion();
        if self.mirrored { motion.mirrored() } else { motion }
    }
}
