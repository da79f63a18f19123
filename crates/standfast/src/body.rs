//! A body in SI units, per metre run or as a whole: its geometry and its inertia.
//!
//! ```text
//!      ┌───────────────┐ ─┬─
//!      │               │  │
//!      │       C       │  │ 2H
//!      │       ┼ y_C   │  │
//!      └─O───────────O'┘ ─┴─
//!        b₁      b₂
//! ```

use crate::error::InputError;
use crate::plan::Plan;
use crate::quantity::{Expected, Quantity};

/// A rectangular body; uniform, and described per metre run of its length, unless told otherwise. Of a body of a given
/// [length](Body::with_length), and of a [cylinder](Body::cylinder), masses, forces and moments are those of the whole.
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
    plan: Plan,
}

/// How far a base reaches from mid-width, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseEdges {
    /// To the left, to O.
    pub left: f64,
    /// To the right, to O'.
    pub right: f64,
}

impl Body {
    /// A uniform body of `width` 2B (m), `height` 2H (m) and `mass` (kg per metre run).
    ///
    /// # Errors
    /// If one of them is not a finite number above zero.
    pub fn new(width: f64, height: f64, mass: f64) -> Result<Body, InputError> {
        let width = InputError::positive(Quantity::Width, width)?;
        let height = InputError::positive(Quantity::Height, height)?;
        let mass = InputError::positive(Quantity::Mass, mass)?;
        Ok(Body {
            width,
            height,
            mass,
            centroid_offset: 0.0,
            centroid_height: height / 2.0,
            base_left: width / 2.0,
            base_right: width / 2.0,
            moment_of_inertia: mass * (width * width + height * height) / 12.0,
            plan: Plan::PER_METRE,
        })
    }

    /// A uniform upright cylinder of `diameter` (m), `height` (m) and `mass` (kg).
    ///
    /// ```
    /// use standfast::{Body, Plan};
    ///
    /// let drum = Body::cylinder(2.0, 3.0, 25e3)?;
    /// assert_eq!(drum.plan(), Plan::Circle);
    /// // m (3 r² + h²)/12
    /// assert_eq!(drum.moment_of_inertia(), 25e3);
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    ///
    /// # Errors
    /// If one of them is not a finite number above zero.
    pub fn cylinder(diameter: f64, height: f64, mass: f64) -> Result<Body, InputError> {
        let body = Body::new(diameter, height, mass)?;
        let moment_of_inertia = mass * (0.75 * diameter * diameter + height * height) / 12.0;
        Ok(Body { moment_of_inertia, plan: Plan::Circle, ..body })
    }

    /// A uniform body of `width` (m), `height` (m) and `density` (kg/m³).
    ///
    /// # Errors
    /// If one of them, or the mass, is not a finite number above zero.
    pub fn of_density(width: f64, height: f64, density: f64) -> Result<Body, InputError> {
        let density = InputError::positive(Quantity::Density, density)?;
        Body::new(width, height, density * width * height)
    }

    /// The same body `length` long out of the plane (m): pressures act on that length, and its mass and all forces are those of
    /// the whole.
    ///
    /// # Errors
    /// If it is not a finite number above zero.
    pub fn with_length(self, length: f64) -> Result<Body, InputError> {
        let length = InputError::positive(Quantity::Length, length)?;
        Ok(Body { plan: Plan::Rectangle { length }, ..self })
    }

    /// The same body with its centre of mass `offset` to the right of mid-width and `height` above the base (m).
    ///
    /// # Errors
    /// If the centre of mass does not lie above the base, between O and O'.
    pub fn with_centroid(self, offset: f64, height: f64) -> Result<Body, InputError> {
        let body = Body {
            centroid_offset: InputError::finite(Quantity::CentroidOffset, offset)?,
            centroid_height: InputError::positive(Quantity::CentroidHeight, height)?,
            ..self
        };
        body.check()
    }

    /// The same body touching its base at `left` to the left of mid-width (O) and `right` to the right (O'), m. Of a body whose
    /// centre of mass is off mid-width, the base comes first where it is wider than the body.
    ///
    /// # Errors
    /// If one of them is not a finite number above zero, or the centre of mass does not lie between O and O'.
    pub fn with_base(self, left: f64, right: f64) -> Result<Body, InputError> {
        let body = Body {
            base_left: InputError::positive(Quantity::BaseLeft, left)?,
            base_right: InputError::positive(Quantity::BaseRight, right)?,
            ..self
        };
        body.check()
    }

    /// The same of a section of parts, whose base may lie on one side of mid-width: its centre of mass comes with it.
    pub(crate) fn standing(self, base: BaseEdges, offset: f64, height: f64) -> Result<Body, InputError> {
        let body = Body {
            centroid_offset: InputError::finite(Quantity::CentroidOffset, offset)?,
            centroid_height: InputError::positive(Quantity::CentroidHeight, height)?,
            base_left: base.left,
            base_right: base.right,
            ..self
        };
        body.check()
    }

    /// The same body with a moment of inertia about its centre of mass of `moment` (kg m² per metre run).
    ///
    /// # Errors
    /// If it is not a finite number above zero.
    pub fn with_moment_of_inertia(self, moment: f64) -> Result<Body, InputError> {
        Ok(Body { moment_of_inertia: InputError::positive(Quantity::MomentOfInertia, moment)?, ..self })
    }

    fn check(self) -> Result<Body, InputError> {
        if self.heel_distance() > 0.0 && self.toe_distance() > 0.0 {
            Ok(self)
        } else {
            Err(InputError::new(Quantity::CentroidOffset, self.centroid_offset, Expected::BetweenCorners))
        }
    }

    /// How far the base reaches to the left and to the right of mid-width; see [`with_base`](Body::with_base).
    pub fn base_edges(&self) -> BaseEdges {
        BaseEdges { left: self.base_left, right: self.base_right }
    }

    /// How it looks from above.
    pub fn plan(&self) -> Plan {
        self.plan
    }

    /// 2B, m.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// 2H, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// Whether it reaches up to an elevation (m above the base). One that is above its crest by four units in the last place at most
    /// is taken for the crest: that of parts is a sum of decimals, and 0.7 + 0.1 is less than 0.8.
    pub fn reaches(&self, elevation: f64) -> bool {
        elevation <= self.height * (1.0 + 4.0 * f64::EPSILON)
    }

    /// m, kg per metre run, or kg of a body of a given length.
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

    /// How far the centre of mass lies to the right of mid-width, m.
    pub fn centroid_offset(&self) -> f64 {
        self.centroid_offset
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

    /// The area of the base, m².
    pub fn base_area(&self) -> f64 {
        self.plan.area(self.base_width())
    }

    /// Whether the body is the report's: a uniform rectangle that touches its base over its whole width.
    pub fn is_uniform(&self) -> bool {
        let uniform = Body::new(self.width, self.height, self.mass);
        uniform.is_ok_and(|uniform| Body { plan: self.plan, ..uniform } == *self)
    }
}
