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

use crate::ball::Scalar;
use crate::error::InputError;
use crate::plan::Plan;
use crate::quantity::{Expected, Quantity};

/// A rectangular body; uniform, and described per metre run of its length, unless told otherwise. Of a body of a given
/// [length](Body::with_length), and of a [cylinder](Body::cylinder), masses, forces and moments are those of the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body<T = f64> {
    width: T,
    height: T,
    mass: T,
    centroid_offset: T,
    centroid_height: T,
    base_left: T,
    base_right: T,
    moment_of_inertia: T,
    plan: Plan<T>,
}

/// Reach of a base from mid-width, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseEdges<T = f64> {
    /// To the left, to O.
    pub left: T,
    /// To the right, to O'.
    pub right: T,
}

impl<T: Scalar> Body<T> {
    /// A uniform body of `width` 2B (m), `height` 2H (m) and `mass` (kg per metre run).
    ///
    /// # Errors
    /// If one of them is not a finite number above zero.
    pub fn new(width: T, height: T, mass: T) -> Result<Body<T>, InputError> {
        let width = InputError::positive(Quantity::Width, width)?;
        let height = InputError::positive(Quantity::Height, height)?;
        let mass = InputError::positive(Quantity::Mass, mass)?;
        let half = |length: &T| length.clone() / T::of(2.0);
        Ok(Body {
            centroid_offset: T::of(0.0),
            centroid_height: half(&height),
            base_left: half(&width),
            base_right: half(&width),
            moment_of_inertia: mass.clone() * (square(&width) + square(&height)) / T::of(12.0),
            plan: Plan::Rectangle { length: T::of(1.0) },
            width,
            height,
            mass,
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
    pub fn cylinder(diameter: T, height: T, mass: T) -> Result<Body<T>, InputError> {
        let body = Body::new(diameter.clone(), height.clone(), mass.clone())?;
        let squares = T::of(0.75) * diameter.clone() * diameter + square(&height);
        let moment_of_inertia = mass * squares / T::of(12.0);
        Ok(Body { moment_of_inertia, plan: Plan::Circle, ..body })
    }

    /// A uniform body of `width` (m), `height` (m) and `density` (kg/m³).
    ///
    /// # Errors
    /// If one of them, or the mass, is not a finite number above zero.
    pub fn of_density(width: T, height: T, density: T) -> Result<Body<T>, InputError> {
        let density = InputError::positive(Quantity::Density, density)?;
        let mass = density * width.clone() * height.clone();
        Body::new(width, height, mass)
    }

    /// Body `length` long out of the plane (m): pressures act on that length, and its mass and all forces are those of the whole.
    ///
    /// # Errors
    /// If it is not a finite number above zero.
    pub fn with_length(self, length: T) -> Result<Body<T>, InputError> {
        let length = InputError::positive(Quantity::Length, length)?;
        Ok(Body { plan: Plan::Rectangle { length }, ..self })
    }

    /// Body with its centre of mass `offset` to the right of mid-width and `height` above the base (m).
    ///
    /// # Errors
    /// If the centre of mass does not lie above the base, between O and O'.
    pub fn with_centroid(self, offset: T, height: T) -> Result<Body<T>, InputError> {
        let body = Body {
            centroid_offset: InputError::finite(Quantity::CentroidOffset, offset)?,
            centroid_height: InputError::positive(Quantity::CentroidHeight, height)?,
            ..self
        };
        body.check()
    }

    /// Body that touches its base at `left` to the left of mid-width (O) and `right` to the right (O'), m. If its centre of mass is off
    /// mid-width, the base comes first where it is wider than the body.
    ///
    /// # Errors
    /// If one of them is not a finite number above zero, or the centre of mass does not lie between O and O'.
    pub fn with_base(self, left: T, right: T) -> Result<Body<T>, InputError> {
        let body = Body {
            base_left: InputError::positive(Quantity::BaseLeft, left)?,
            base_right: InputError::positive(Quantity::BaseRight, right)?,
            ..self
        };
        body.check()
    }

    /// Body of a section of parts, whose base may lie on one side of mid-width: its centre of mass comes with it.
    pub(crate) fn standing(self, base: BaseEdges<T>, offset: T, height: T) -> Result<Body<T>, InputError> {
        let body = Body {
            centroid_offset: InputError::finite(Quantity::CentroidOffset, offset)?,
            centroid_height: InputError::positive(Quantity::CentroidHeight, height)?,
            base_left: base.left,
            base_right: base.right,
            ..self
        };
        body.check()
    }

    /// Body with a moment of inertia about its centre of mass of `moment` (kg m² per metre run).
    ///
    /// # Errors
    /// If it is not a finite number above zero.
    pub fn with_moment_of_inertia(self, moment: T) -> Result<Body<T>, InputError> {
        Ok(Body { moment_of_inertia: InputError::positive(Quantity::MomentOfInertia, moment)?, ..self })
    }

    fn check(self) -> Result<Body<T>, InputError> {
        if self.heel_distance().value() > 0.0 && self.toe_distance().value() > 0.0 {
            Ok(self)
        } else {
            let offset = self.centroid_offset.value();
            Err(InputError::new(Quantity::CentroidOffset, offset, Expected::BetweenCorners))
        }
    }

    /// Reach of the base to the left and to the right of mid-width; see [`with_base`](Body::with_base).
    pub fn base_edges(&self) -> BaseEdges<T> {
        BaseEdges { left: self.base_left.clone(), right: self.base_right.clone() }
    }

    /// Plan: the body seen from above.
    pub fn plan(&self) -> Plan<T> {
        self.plan.clone()
    }

    /// 2B, m.
    pub fn width(&self) -> T {
        self.width.clone()
    }

    /// 2H, m.
    pub fn height(&self) -> T {
        self.height.clone()
    }

    /// True if it reaches up to an elevation (m above the base). One that is above its crest by four units in the last place at most is
    /// taken for the crest: that of parts is a sum of decimals, and 0.7 + 0.1 is less than 0.8.
    pub fn reaches(&self, elevation: T) -> bool {
        elevation.value() <= self.height.value() * (1.0 + 4.0 * f64::EPSILON)
    }

    /// m, kg per metre run, or kg of a body of a given length.
    pub fn mass(&self) -> T {
        self.mass.clone()
    }

    /// γ = H/B.
    pub fn slenderness(&self) -> T {
        self.height.clone() / self.width.clone()
    }

    /// I about the centre of mass, kg m² per metre run; m(B² + H²)/3 of a uniform body.
    pub fn moment_of_inertia(&self) -> T {
        self.moment_of_inertia.clone()
    }

    /// Offset of the centre of mass to the right of mid-width, m.
    pub fn centroid_offset(&self) -> T {
        self.centroid_offset.clone()
    }

    /// Height of the centre of mass above the base, m.
    pub fn centroid_height(&self) -> T {
        self.centroid_height.clone()
    }

    /// b₁, distance of O to the left of the centre of mass, m.
    pub fn heel_distance(&self) -> T {
        self.base_left.clone() + self.centroid_offset.clone()
    }

    /// b₂, distance of O' to the right of the centre of mass, m.
    pub fn toe_distance(&self) -> T {
        self.base_right.clone() - self.centroid_offset.clone()
    }

    /// Distance from O to O', m.
    pub fn base_width(&self) -> T {
        self.base_left.clone() + self.base_right.clone()
    }

    /// The area of the base, m².
    pub fn base_area(&self) -> T {
        self.plan().area(self.base_width())
    }

    /// True if the body is the report's: a uniform rectangle that touches its base over its whole width.
    pub fn is_uniform(&self) -> bool {
        let uniform = Body::new(self.width(), self.height(), self.mass());
        uniform.is_ok_and(|uniform| Body { plan: self.plan(), ..uniform } == *self)
    }

    /// Body in f64.
    pub fn rounded(&self) -> Body {
        self.map(T::value)
    }

    /// The body whose numbers were computed in f64, in any arithmetic; see [`Scalar::computed`].
    pub fn computed(body: &Body) -> Body<T> {
        body.map(|number| T::computed(*number))
    }

    fn map<U>(&self, of: impl Fn(&T) -> U) -> Body<U> {
        Body {
            width: of(&self.width),
            height: of(&self.height),
            mass: of(&self.mass),
            centroid_offset: of(&self.centroid_offset),
            centroid_height: of(&self.centroid_height),
            base_left: of(&self.base_left),
            base_right: of(&self.base_right),
            moment_of_inertia: of(&self.moment_of_inertia),
            plan: match &self.plan {
                Plan::Rectangle { length } => Plan::Rectangle { length: of(length) },
                Plan::Circle => Plan::Circle,
            },
        }
    }
}

fn square<T: Scalar>(x: &T) -> T {
    x.clone() * x.clone()
}
