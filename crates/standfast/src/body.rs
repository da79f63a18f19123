//! A body in SI units, per metre run: its geometry, its inertia, and what loads on it amount to at its centre of mass.
//!
//! ```text
//!      ┌───────────────┐ ─┬─
//!      │               │  │
//!      │       C       │  │ 2H
//!      │       ┼ y_C   │  │
//!      └─O───────────O'┘ ─┴─
//!        b₁      b₂
//! ```

use crate::contact::Wrench;
use crate::error::InputError;
use crate::mode::Corner;
use crate::stability::Actions;

/// A rectangular body, per metre run of its length; uniform unless told otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    width: f64,
    height: f64,
    mass: f64,
    centroid_offset: f64,
    centroid_height: f64,
    base_left: f64,
    base_right: f64,
    moment_of_inertia: f64,
}

/// What still water amounts to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StillWater {
    /// Its pressure on both sides.
    pub sides: Wrench,
    /// Its pressure under the base: buoyancy, and the moment of a head difference.
    pub base: Wrench,
}

impl Body {
    /// A uniform body of `width` 2B (m), `height` 2H (m) and `mass` (kg per metre run).
    ///
    /// # Errors
    /// If one of them is not a finite number above zero.
    pub fn new(width: f64, height: f64, mass: f64) -> Result<Body, InputError> {
        let width = InputError::positive("width", width)?;
        let height = InputError::positive("height", height)?;
        let mass = InputError::positive("mass", mass)?;
        Ok(Body {
            width,
            height,
            mass,
            centroid_offset: 0.0,
            centroid_height: height / 2.0,
            base_left: width / 2.0,
            base_right: width / 2.0,
            moment_of_inertia: mass * (width * width + height * height) / 12.0,
        })
    }

    /// A uniform body of `width` (m), `height` (m) and `density` (kg/m³).
    ///
    /// # Errors
    /// If one of them, or the mass, is not a finite number above zero.
    pub fn of_density(width: f64, height: f64, density: f64) -> Result<Body, InputError> {
        let density = InputError::positive("density", density)?;
        Body::new(width, height, density * width * height)
    }

    /// The same body with its centre of mass `offset` to the right of mid-width and `height` above the base (m).
    ///
    /// # Errors
    /// If the centre of mass does not lie above the base, between O and O'.
    pub fn with_centroid(self, offset: f64, height: f64) -> Result<Body, InputError> {
        let body = Body {
            centroid_offset: InputError::finite("offset of the centre of mass", offset)?,
            centroid_height: InputError::positive("height of the centre of mass", height)?,
            ..self
        };
        body.check()
    }

    /// The same body touching its base at `left` to the left of mid-width (O) and `right` to the right (O'), m.
    ///
    /// # Errors
    /// If the centre of mass does not lie between O and O'.
    pub fn with_base(self, left: f64, right: f64) -> Result<Body, InputError> {
        let body = Body {
            base_left: InputError::finite("left half of the base", left)?,
            base_right: InputError::finite("right half of the base", right)?,
            ..self
        };
        body.check()
    }

    /// The same body with a moment of inertia about its centre of mass of `moment` (kg m² per metre run).
    ///
    /// # Errors
    /// If it is not a finite number above zero.
    pub fn with_moment_of_inertia(self, moment: f64) -> Result<Body, InputError> {
        Ok(Body { moment_of_inertia: InputError::positive("moment of inertia", moment)?, ..self })
    }

    fn check(self) -> Result<Body, InputError> {
        let expected = "one that lies between O and O'";
        if self.heel_distance() > 0.0 && self.toe_distance() > 0.0 {
            Ok(self)
        } else {
            let quantity = "offset of the centre of mass";
            Err(InputError { quantity, value: self.centroid_offset, expected })
        }
    }

    /// How far the base reaches to the left and to the right of mid-width, m; see [`with_base`](Body::with_base).
    pub fn base_edges(&self) -> (f64, f64) {
        (self.base_left, self.base_right)
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

    /// I about the centre of mass, kg m² per metre run; m(B² + H²)/3 of a uniform body.
    pub fn moment_of_inertia(&self) -> f64 {
        self.moment_of_inertia
    }

    /// Height of the centre of mass above the base, m.
    pub fn centroid_height(&self) -> f64 {
        self.centroid_height
    }

    /// b₁, distance of O to the left of the centre of mass, m.
    pub fn heel_distance(&self) -> f64 {
        self.base_left + self.centroid_offset
    }

    /// b₂, distance of O' to the right of the centre of mass, m.
    pub fn toe_distance(&self) -> f64 {
        self.base_right - self.centroid_offset
    }

    /// Distance from O to O', m.
    pub fn base_width(&self) -> f64 {
        self.base_left + self.base_right
    }

    /// Whether the body is the report's: uniform, and touching its base over its whole width.
    pub fn is_uniform(&self) -> bool {
        Body::new(self.width, self.height, self.mass) == Ok(*self)
    }

    /// The weight at the acceleration of gravity `gravity` (m/s²), N per metre run.
    pub fn weight(&self, gravity: f64) -> Wrench {
        Wrench { x: 0.0, p: self.mass * gravity, m: 0.0 }
    }

    /// A horizontal force `force` to the right (N per metre run) at `elevation` above the base (m).
    pub fn horizontal_force(&self, force: f64, elevation: f64) -> Wrench {
        Wrench { x: force, p: 0.0, m: -force * (elevation - self.centroid_height) }
    }

    /// A vertical force `force` downwards (N per metre run) at `arm` to the right of O (m).
    pub fn vertical_force(&self, force: f64, arm: f64) -> Wrench {
        Wrench { x: 0.0, p: force, m: -force * (arm - self.heel_distance()) }
    }

    /// Pressure under the base, linear between `left` at O and `right` at O' (Pa).
    pub fn base_pressure(&self, left: f64, right: f64) -> Wrench {
        let width = self.base_width();
        let force = (left + right) / 2.0 * width;
        let about_o = (left + 2.0 * right) / 6.0 * width * width;
        Wrench { x: 0.0, p: -force, m: about_o - force * self.heel_distance() }
    }

    /// Acceleration of the base by `horizontal` to the right and `vertical` upwards (m/s²), as forces of inertia: the
    /// body's motion is then the one relative to its base.
    pub fn base_acceleration(&self, horizontal: f64, vertical: f64) -> Wrench {
        Wrench { x: -self.mass * horizontal, p: self.mass * vertical, m: 0.0 }
    }

    /// Still water at `left` and `right` above the base on either side (m), of `unit_weight` ρg (N/m³): its pressure on
    /// the sides, and under the base, where it is linear between the two.
    ///
    /// # Errors
    /// If a level is negative or above the crest, which would be under water.
    pub fn still_water(&self, left: f64, right: f64, unit_weight: f64) -> Result<StillWater, InputError> {
        InputError::positive("unit weight of water", unit_weight)?;
        let mut sides = Wrench::ZERO;
        for (level, towards) in [(left, 1.0), (right, -1.0)] {
            let level = InputError::not_negative("water level", level)?;
            if level > self.height {
                let expected =
                    "no more than the height of the body: its crest has to stand above still water";
                return Err(InputError { quantity: "water level", value: level, expected });
            }
            sides = sides + self.horizontal_force(towards * unit_weight * level * level / 2.0, level / 3.0);
        }
        Ok(StillWater { sides, base: self.base_pressure(unit_weight * left, unit_weight * right) })
    }

    /// The corner that the classical checks call the heel: O, or O' if the horizontal force points right (without one, if
    /// the moment turns the body that way).
    pub fn heel(&self, weight: &Wrench, uplift: &Wrench, horizontal: &Wrench) -> Corner {
        let right = horizontal.x > 0.0 || horizontal.x == 0.0 && weight.m + uplift.m + horizontal.m < 0.0;
        if right { Corner::OPrime } else { Corner::O }
    }

    /// The classical actions about the [heel](Body::heel), from vertical, uplift and horizontal loads. The other corner is
    /// not looked at, as is the custom; a body can also turn about it where a load pulls below its base or far outside.
    pub fn actions(&self, weight: &Wrench, uplift: &Wrench, horizontal: &Wrench) -> Actions {
        let (σ, arm) = match self.heel(weight, uplift, horizontal) {
            Corner::O => (1.0, self.heel_distance()),
            Corner::OPrime => (-1.0, self.toe_distance()),
        };
        // Clockwise about O, or counter-clockwise about O'.
        let resisting = |wrench: &Wrench| wrench.p * arm - σ * wrench.m;
        Actions {
            buoyant_weight: weight.p,
            weight_arm: if weight.p == 0.0 { 0.0 } else { resisting(weight) / weight.p },
            uplift: 0.0 - uplift.p,
            uplift_moment: 0.0 - resisting(uplift),
            force: horizontal.x.abs(),
            force_moment: σ * (horizontal.m - horizontal.x * self.centroid_height),
        }
    }
}
