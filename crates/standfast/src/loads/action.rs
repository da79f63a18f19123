//! Actions on a body, and their places: the wrench at the centre of mass follows, for any pose of the body.
//!
//! ```text
//!         ┌────────Top────────┐
//!         │                   │ ◄─ p(y)      y ▲
//!    Left │         C         │ ◄──            │   frame of the body:
//!         │                   │ ◄─── Right     └──► x, from mid-width
//!         └─O──────Base──────O'                     at the base
//!           ▲  ▲  ▲  ▲  ▲  ▲  p(s), s from O
//! ```
//!
//! Weight, forces and forces of inertia keep their direction in space while the body turns; pressures turn with the face
//! they press on.
//!
//! A pressure linear from p₁ at s₁ to p₂ at s₂ adds up, per metre of the body's [length](crate::Plan), to
//!
//! ```text
//! F = (p₁ + p₂)/2 (s₂ − s₁)        S = ∫p s ds = (s₂ − s₁)/6 [p₁(2s₁ + s₂) + p₂(s₁ + 2s₂)]
//! ```

use crate::ball::Scalar;
use crate::body::Body;
use crate::error::InputError;
use crate::plan::strip;
use crate::quantity::{Expected, Quantity};
use crate::wrench::Wrench;

/// A place on the body, in the frame of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyPoint<T = f64> {
    /// To the right of mid-width, m.
    pub x: T,
    /// Above the base, m.
    pub y: T,
}

/// Pose of a body: turned about its centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Rotation, counter-clockwise, rad.
    pub theta: f64,
}

impl Pose {
    /// On its base.
    pub const UPRIGHT: Pose = Pose { theta: 0.0 };
}

/// A face of the body. Pressure pushes against it, inwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Face {
    /// The left side; positions are heights above the base.
    Left,
    /// The right side; positions are heights above the base.
    Right,
    /// The base; positions are distances to the right of O.
    Base,
    /// The top; positions are distances to the right of O, as on the base.
    Top,
}

/// A pressure at a position on a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureAt<T = f64> {
    /// See [`Face`], m.
    pub position: T,
    /// Pa.
    pub pressure: T,
}

/// A pressure along a face, linear from point to point; nothing outside.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureDiagram<T = f64> {
    points: Vec<PressureAt<T>>,
}

impl<T: Scalar> PressureAt<T> {
    /// Pressure in f64.
    pub(crate) fn rounded(&self) -> PressureAt {
        PressureAt { position: self.position.value(), pressure: self.pressure.value() }
    }
}

impl<T: Scalar> PressureDiagram<T> {
    /// A pressure through these points.
    ///
    /// # Errors
    /// If a number is not finite, or a position lies before the one it follows. At one position the pressure may jump.
    pub fn new(points: Vec<PressureAt<T>>) -> Result<PressureDiagram<T>, InputError> {
        let mut before = f64::NEG_INFINITY;
        for PressureAt { position, pressure } in points.iter().map(PressureAt::rounded) {
            InputError::finite(Quantity::PressurePosition, position)?;
            InputError::finite(Quantity::Pressure, pressure)?;
            if position < before {
                return Err(InputError::new(Quantity::PressurePosition, position, Expected::InOrder));
            }
            before = position;
        }
        Ok(PressureDiagram { points })
    }

    /// A pressure through points that are known to be in order.
    pub(crate) fn through(points: impl IntoIterator<Item = (T, T)>) -> PressureDiagram<T> {
        let points = points.into_iter().map(|(position, pressure)| PressureAt { position, pressure });
        PressureDiagram { points: points.collect() }
    }

    /// The points.
    pub fn points(&self) -> &[PressureAt<T>] {
        &self.points
    }

    /// ∫p ds (N per metre run), and ∫p s ds (N·m per metre run), about the origin of positions.
    pub fn resultant(&self) -> (T, T) {
        let pairs = self.points.windows(2).map(|pair| strip(&pair[0], &pair[1]));
        pairs.fold((T::of(0.0), T::of(0.0)), |sum, (force, moment)| (sum.0 + force, sum.1 + moment))
    }

    /// ∫p dA (N) and ∫p s dA (N·m) on a face of `body`, about the origin of positions.
    pub fn resultant_on(&self, body: &Body<T>, face: Face) -> (T, T) {
        let plan = body.plan();
        match face {
            Face::Left | Face::Right => {
                let (force, moment) = self.resultant();
                let side = plan.side(body.width());
                (force * side.clone(), moment * side)
            }
            Face::Base | Face::Top => plan.resultant(&self.points, body.base_width()),
        }
    }
}

impl PressureDiagram {
    /// A pressure of numbers that were computed in f64, in any arithmetic.
    fn computed<T: Scalar>(self) -> PressureDiagram<T> {
        let of = T::computed;
        PressureDiagram::through(self.points.iter().map(|at| (of(at.position), of(at.pressure))))
    }
}

/// Action on a body, and its place.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Action<T = f64> {
    /// m g, at the centre of mass.
    Weight,
    /// A force at a place of the body, its direction fixed in space; N per metre run.
    Force {
        /// Place at which it acts.
        at: BodyPoint<T>,
        /// To the right.
        right: T,
        /// Upwards.
        up: T,
    },
    /// A pressure on a face.
    Pressure {
        /// The face.
        face: Face,
        /// Along it.
        diagram: PressureDiagram<T>,
    },
    /// A force down along a side, which turns with it; per metre of height.
    Drag {
        /// The side, at the edge of the base.
        face: Face,
        /// How far the side leans towards the body, as a share of its height.
        batter: T,
        /// Along it, downwards.
        diagram: PressureDiagram<T>,
    },
    /// The body's inertia against an acceleration of its base, m/s²: its motion is then the one relative to the base.
    Inertia {
        /// Of the base, to the right.
        right: T,
        /// Of the base, upwards.
        up: T,
    },
    /// Any wrench at the centre of mass, its direction fixed in space.
    Resultant(Wrench<T>),
}

impl<T> From<Wrench<T>> for Action<T> {
    fn from(wrench: Wrench<T>) -> Action<T> {
        Action::Resultant(wrench)
    }
}

impl<T: Scalar> Action<T> {
    /// A horizontal force `right` (N per metre run, to the right) at `elevation` above the base (m).
    pub fn horizontal(right: T, elevation: T) -> Action<T> {
        Action::Force { at: BodyPoint { x: T::of(0.0), y: elevation }, right, up: T::of(0.0) }
    }

    /// A vertical force `down` (N per metre run) at `arm` to the right of O (m) and at the height of the centre of mass.
    pub fn vertical(body: &Body<T>, down: T, arm: T) -> Action<T> {
        let at = BodyPoint { x: arm - body.base_edges().left, y: body.centroid_height() };
        Action::Force { at, right: T::of(0.0), up: -down }
    }

    /// A pressure under the base, linear between `left` at O and `right` at O' (Pa).
    pub fn base_pressure(body: &Body<T>, left: T, right: T) -> Action<T> {
        let diagram = PressureDiagram::through([(T::of(0.0), left), (body.base_width(), right)]);
        Action::Pressure { face: Face::Base, diagram }
    }

    /// The force that a weight, a force or an inertia is; nothing of what is a pressure or a wrench.
    fn force(&self, body: &Body<T>, gravity: T) -> BodyForce<T> {
        let zero = || T::of(0.0);
        let (at, size) = match self {
            Action::Weight => ([zero(), zero()], [zero(), -body.mass() * gravity]),
            Action::Force { at, right, up } => {
                let at = [at.x.clone() - body.centroid_offset(), at.y.clone() - body.centroid_height()];
                (at, [right.clone(), up.clone()])
            }
            Action::Inertia { right, up } => {
                let of = |acceleration: &T| zero() - body.mass() * acceleration.clone();
                ([zero(), zero()], [of(right), of(up)])
            }
            Action::Pressure { .. } | Action::Drag { .. } | Action::Resultant(_) => {
                ([zero(), zero()], [zero(), zero()])
            }
        };
        BodyForce { at, size, follows: false }
    }

    /// Action in the frame of a base that rises to the right by `slope` radians: weight, forces and accelerations keep their directions in
    /// space, pressures press on their faces.
    ///
    /// ```text
    /// along the base  x cos ε + y sin ε        across it  y cos ε − x sin ε
    /// ```
    #[must_use]
    pub fn on_slope(self, body: &Body<T>, gravity: T, slope: f64) -> Action<T> {
        let (sin, cos) = slope.sin_cos();
        let (sin, cos) = (T::computed(sin), T::computed(cos));
        let turned = |right: T, up: T| {
            let along = right.clone() * cos.clone() + up.clone() * sin.clone();
            (along, up * cos.clone() - right * sin.clone())
        };
        match self {
            Action::Weight => {
                let at = BodyPoint { x: body.centroid_offset(), y: body.centroid_height() };
                let (right, up) = turned(T::of(0.0), -body.mass() * gravity);
                Action::Force { at, right, up }
            }
            Action::Force { at, right, up } => {
                let (right, up) = turned(right, up);
                Action::Force { at, right, up }
            }
            Action::Inertia { right, up } => {
                let (right, up) = turned(right, up);
                Action::Inertia { right, up }
            }
            Action::Resultant(Wrench { x, p, m }) => {
                let (x, up) = turned(x, -p);
                Action::Resultant(Wrench { x, p: -up, m })
            }
            pressed @ (Action::Pressure { .. } | Action::Drag { .. }) => pressed,
        }
    }

    /// The wrench at the centre of mass of `body`, upright, at the acceleration of gravity `gravity` (m/s²).
    pub fn upright(&self, body: &Body<T>, gravity: T) -> Wrench<T> {
        match self {
            // As it is given, without the rounding of forces and couples.
            Action::Resultant(wrench) => wrench.clone(),
            Action::Pressure { face, diagram } => pressed(body, *face, diagram),
            Action::Drag { face, batter, diagram } => dragged(body, *face, batter.clone(), diagram),
            _ => Wrench::zero() + self.force(body, gravity).upright(),
        }
    }
}

impl Action {
    /// The forces on a `body` at the acceleration of gravity `gravity` (m/s²) that it amounts to, whatever the pose: weight,
    /// forces and inertia keep their direction in space, a pressure turns with its face. A moment without force is a couple.
    pub fn forces(&self, body: &Body, gravity: f64) -> Vec<BodyForce> {
        match self {
            Action::Pressure { face, diagram } => pressing(body, *face, diagram),
            Action::Drag { face, batter, diagram } => dragging(body, *face, *batter, diagram),
            Action::Resultant(Wrench { x, p, m }) => {
                let force = BodyForce { at: [0.0; 2], size: [*x, 0.0 - p], follows: false };
                [force].into_iter().chain(couple(*m).into_iter().flatten()).collect()
            }
            Action::Weight | Action::Force { .. } | Action::Inertia { .. } => vec![self.force(body, gravity)],
        }
    }

    /// The wrench at the centre of mass of `body` at the acceleration of gravity `gravity` (m/s²), for its pose.
    pub fn wrench(&self, body: &Body, gravity: f64, pose: Pose) -> Wrench {
        match self {
            _ if pose == Pose::UPRIGHT => self.upright(body, gravity),
            Action::Resultant(wrench) => *wrench,
            Action::Pressure { .. } | Action::Drag { .. } => {
                self.forces(body, gravity).iter().map(|force| force.wrench(pose)).sum()
            }
            _ => Wrench::ZERO + self.force(body, gravity).wrench(pose),
        }
    }

    /// Action of numbers that were computed in f64, in any arithmetic; see [`Scalar::computed`].
    pub fn computed<T: Scalar>(self) -> Action<T> {
        let of = T::computed;
        match self {
            Action::Weight => Action::Weight,
            Action::Force { at, right, up } => {
                Action::Force { at: BodyPoint { x: of(at.x), y: of(at.y) }, right: of(right), up: of(up) }
            }
            Action::Pressure { face, diagram } => Action::Pressure { face, diagram: diagram.computed() },
            Action::Drag { face, batter, diagram } => {
                Action::Drag { face, batter: of(batter), diagram: diagram.computed() }
            }
            Action::Inertia { right, up } => Action::Inertia { right: of(right), up: of(up) },
            Action::Resultant(Wrench { x, p, m }) => {
                Action::Resultant(Wrench { x: of(x), p: of(p), m: of(m) })
            }
        }
    }
}

/// A force on a body, per metre of its length where the body is so long.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyForce<T = f64> {
    /// Point at which it acts, from the centre of mass while the body stands upright, to the right and upwards, m; the place moves with the
    /// body.
    pub at: [T; 2],
    /// To the right and upwards while the body stands upright, N.
    pub size: [T; 2],
    /// True if its direction turns with the body.
    pub follows: bool,
}

impl<T: Scalar> BodyForce<T> {
    /// Its wrench at the centre of mass of a body that stands upright.
    fn upright(self) -> Wrench<T> {
        let ([x, y], [right, up]) = (self.at, self.size);
        Wrench { x: right.clone(), p: T::of(0.0) - up.clone(), m: (x * up).plus(-(y * right)) }
    }
}

impl BodyForce {
    /// Its wrench at the centre of mass for a pose of the body.
    pub fn wrench(&self, pose: Pose) -> Wrench {
        let (sin, cos) = pose.theta.sin_cos();
        let turned = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        let [x, y] = turned(self.at);
        let [right, up] = if self.follows { turned(self.size) } else { self.size };
        let m = if self.follows {
            // The moment about C does not change.
            self.at[0] * self.size[1] - self.at[1] * self.size[0]
        } else {
            x * up - y * right
        };
        Wrench { x: right, p: 0.0 - up, m }
    }
}

/// Two forces that add up to nothing but a moment, counter-clockwise, that the body's turning does not change.
fn couple(moment: f64) -> Option<[BodyForce; 2]> {
    let force = |x: f64, up: f64| BodyForce { at: [x, 0.0], size: [0.0, up], follows: true };
    (moment != 0.0).then(|| [force(1.0, moment), force(0.0, 0.0 - moment)])
}

/// The resultant of a pressure where it acts on its face, or the couple that is left where it has none.
fn pressing(body: &Body, face: Face, diagram: &PressureDiagram) -> Vec<BodyForce> {
    let Wrench { x, p, m } = pressed(body, face, diagram);
    let up = 0.0 - p;
    let at = match face {
        Face::Left | Face::Right if x != 0.0 => {
            let side = if face == Face::Left { -0.5 } else { 0.5 };
            Some([side * body.width() - body.centroid_offset(), -m / x])
        }
        Face::Base if up != 0.0 => Some([m / up, -body.centroid_height()]),
        Face::Top if up != 0.0 => Some([m / up, body.height() - body.centroid_height()]),
        _ => None,
    };
    match at {
        Some(at) => vec![BodyForce { at, size: [x, up], follows: true }],
        None => couple(m).into_iter().flatten().collect(),
    }
}

/// The wrench of a drag along a side of a body that stands upright.
fn dragged<T: Scalar>(body: &Body<T>, face: Face, batter: T, diagram: &PressureDiagram<T>) -> Wrench<T> {
    let (force, moment) = diagram.resultant_on(body, face);
    let lean = batter * moment;
    // Down at the right of C turns clockwise.
    let m = match face {
        Face::Left => (force.clone() * body.heel_distance()).plus(-lean),
        _ => lean.plus(-(force.clone() * body.toe_distance())),
    };
    Wrench { x: T::of(0.0), p: force, m }
}

/// The resultant of a drag where it acts on its side, or the couple that is left where it has none.
fn dragging(body: &Body, face: Face, batter: f64, diagram: &PressureDiagram) -> Vec<BodyForce> {
    let Wrench { p, m, .. } = dragged(body, face, batter, diagram);
    if p == 0.0 {
        return couple(m).into_iter().flatten().collect();
    }
    let (force, moment) = diagram.resultant_on(body, face);
    let at = [0.0 - m / p, moment / force - body.centroid_height()];
    vec![BodyForce { at, size: [0.0, 0.0 - p], follows: true }]
}

/// The wrench of a pressure on a body that stands upright.
fn pressed<T: Scalar>(body: &Body<T>, face: Face, diagram: &PressureDiagram<T>) -> Wrench<T> {
    let zero = || T::of(0.0);
    let (force, moment) = diagram.resultant_on(body, face);
    // About C: of a side by its height, of the base and the top by the distance to the right.
    let about = |distance: T| moment.clone().plus(-(force.clone() * distance));
    match face {
        Face::Left => Wrench { m: zero() - about(body.centroid_height()), x: force, p: zero() },
        Face::Right => Wrench { m: about(body.centroid_height()), x: zero() - force, p: zero() },
        Face::Base => Wrench { m: about(body.heel_distance()), x: zero(), p: zero() - force },
        Face::Top => Wrench { m: zero() - about(body.heel_distance()), x: zero(), p: force },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body() -> Body {
        Body::new(10.0, 8.0, 1e5).unwrap().with_base(4.0, 5.0).unwrap().with_centroid(0.5, 3.0).unwrap()
    }

    fn close(one: Wrench, two: Wrench) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + b.abs());
        near(one.x, two.x) && near(one.p, two.p) && near(one.m, two.m)
    }

    /// A pressure cut into many small forces that turn with the body has the wrench of the diagram, at any pose.
    #[test]
    fn a_pressure_is_the_sum_of_its_parts() {
        let body = body();
        let points = [(0.5, 3e3), (2.0, -1e3), (2.0, 5e3), (7.0, 2e3)];
        let diagram = PressureDiagram::through(points);
        let pressure = |s: f64| {
            let pair = points.windows(2).find(|pair| pair[0].0 < s && s < pair[1].0);
            pair.map_or(0.0, |pair| {
                let ((s1, p1), (s2, p2)) = (pair[0], pair[1]);
                p1 + (p2 - p1) * (s - s1) / (s2 - s1)
            })
        };
        for face in [Face::Left, Face::Right, Face::Base, Face::Top] {
            for theta in [0.0, 0.3, -1.1] {
                let parts = 16_000;
                let sum = (0..parts).map(|i| {
                    let ds = 8.0 / f64::from(parts);
                    let s = (f64::from(i) + 0.5) * ds;
                    let force = pressure(s) * ds;
                    let (at, right, up) = match face {
                        Face::Left => (BodyPoint { x: -5.0, y: s }, force, 0.0),
                        Face::Right => (BodyPoint { x: 5.0, y: s }, -force, 0.0),
                        Face::Base => (BodyPoint { x: s - 4.0, y: 0.0 }, 0.0, force),
                        Face::Top => (BodyPoint { x: s - 4.0, y: 8.0 }, 0.0, -force),
                    };
                    let (sin, cos) = f64::sin_cos(theta);
                    let turned =
                        Action::Force { at, right: right * cos - up * sin, up: right * sin + up * cos };
                    turned.wrench(&body, 9.81, Pose { theta })
                });
                let whole = Action::Pressure { face, diagram: diagram.clone() };
                let (sum, whole) = (sum.sum::<Wrench>(), whole.wrench(&body, 9.81, Pose { theta }));
                let near = |a: f64, b: f64| (a - b).abs() < 1e-3 * 1e4;
                assert!(
                    near(sum.x, whole.x) && near(sum.p, whole.p) && near(sum.m, whole.m),
                    "{face:?} {theta}"
                );
                // The middle points of linear pieces are exact but at the pieces' ends.
                assert!((sum.m - whole.m).abs() < 2.0, "{face:?} {theta}: {} {}", sum.m, whole.m);
            }
        }
    }

    /// A force, the weight and inertia keep their direction; a quarter turn moves the arm of a force.
    #[test]
    fn forces_keep_their_direction() {
        let body = body();
        let quarter = Pose { theta: std::f64::consts::FRAC_PI_2 };
        // 2 m above C: turned by 90° it lies 2 m to the left of C, where a push to the left has no moment.
        let upright = Action::Force { at: BodyPoint { x: 0.5, y: 5.0 }, right: -100.0, up: 0.0 };
        assert!(close(upright.wrench(&body, 9.81, Pose::UPRIGHT), Wrench { x: -100.0, p: 0.0, m: 200.0 }));
        assert!(close(upright.wrench(&body, 9.81, quarter), Wrench { x: -100.0, p: 0.0, m: 0.0 }));
        let lift = Action::Force { at: BodyPoint { x: 0.5, y: 5.0 }, right: 0.0, up: 100.0 };
        assert!(close(lift.wrench(&body, 9.81, quarter), Wrench { x: 0.0, p: -100.0, m: -200.0 }));
        for action in [Action::Weight, Action::Inertia { right: 2.0, up: -1.0 }] {
            assert_eq!(action.wrench(&body, 9.81, quarter), action.wrench(&body, 9.81, Pose::UPRIGHT));
        }
    }

    #[test]
    fn positions_have_to_rise() {
        let at = |position, pressure| PressureAt { position, pressure };
        assert!(PressureDiagram::new(vec![at(0.0, 1.0), at(1.0, 2.0), at(1.0, 0.0)]).is_ok());
        let error = PressureDiagram::new(vec![at(1.0, 1.0), at(0.5, 2.0)]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "position of a pressure is 0.5; expected positions that rise from point to point"
        );
        assert!(PressureDiagram::new(vec![at(0.0, f64::NAN)]).is_err());
    }
}
