//! A rectangular body in SI units.

use crate::error::InputError;

/// A uniform rectangular body, per metre run of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    width: f64,
    height: f64,
    mass: f64,
}

impl Body {
    /// A body of `width` 2B (m), `height` 2H (m) and `mass` (kg per metre run).
    ///
    /// # Errors
    /// If one of them is not a finite number above zero.
    pub fn new(width: f64, height: f64, mass: f64) -> Result<Body, InputError> {
        Ok(Body {
            width: InputError::positive("width", width)?,
            height: InputError::positive("height", height)?,
            mass: InputError::positive("mass", mass)?,
        })
    }

    /// A body of `width` (m), `height` (m) and `density` (kg/m³).
    ///
    /// # Errors
    /// If one of them, or the mass, is not a finite number above zero.
    pub fn of_density(width: f64, height: f64, density: f64) -> Result<Body, InputError> {
        let density = InputError::positive("density", density)?;
        Body::new(width, height, density * width * height)
    }

    /// 2B, m.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// 2H, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// m, kg per metre run.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// γ = H/B.
    pub fn slenderness(&self) -> f64 {
        self.height / self.width
    }

    /// I = m(B² + H²)/3 about the centre of mass, kg m² per metre run.
    pub fn moment_of_inertia(&self) -> f64 {
        self.mass * (self.width * self.width + self.height * self.height) / 12.0
    }
}
