//! Bodies under forces of any horizontal direction, on a base that is a polygon, feet or a disc.
//!
//! Seen from above, x to the right and z away from the viewer of the section, both from the point under the centre of mass C, at the depth
//! d below it. Vertices and edges are counted counter-clockwise:
//!
//! ```text
//!         z ▲      edge 3
//!     4 ────┼──────────── 3          X = (X_x, X_z)   horizontal force, N
//!       │   │           │            P                downward force, N
//! edge 4│   C───────────┼─► x        Q = P c          its moment, where c is the centre of pressure, N·m
//!       │               │ edge 2     T                moment about the vertical through C, N·m
//!     1 ─────────────── 2
//!            edge 1
//! ```
//!
//! A force at a place inside the base is a sum of forces at its vertices in the same direction, so that a base bears what its vertices
//! bear: feet and the polygon around them are the same. Without a moment about the vertical through the centre of pressure,
//! T_c = T − c × X = 0, a body rests if and only if
//!
//! ```text
//! c lies on the base: e_i × (Q − P v_i) ≥ 0 for every edge e_i from v_i        and        |X| ≤ μ P
//! ```
//!
//! whatever the pressure. Every load in a vertical plane through C is such a one: earthquakes, and most pushes. Under a horizontal force k m g
//! through C in a direction φ
//!
//! ```text
//! k(φ) = min(μ, R(φ)/d)        R(φ) from C to the edge in that direction
//! ```
//!
//! On a disc of the radius R about o also a moment about c has a closed form:
//!
//! ```text
//! |X|² + T_c²/(R² − |c − o|²) ≤ μ² P²
//! ```
//!
//! ```
//! use standfast::footprint::{BaseWrench, Footprint, PlanLimit};
//!
//! // A statue on a plinth of 2 by 2, three above the floor, pushed across an edge and towards a vertex.
//! let plinth = Footprint::polygon(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])?;
//! let weight = BaseWrench::pressing(1.0);
//! let push = |right: f64, away: f64| BaseWrench::force([right, away], 3.0);
//! let leaves = |push: BaseWrench| plinth.departure(0.7, &weight, &push).unwrap();
//! assert_eq!(leaves(push(1.0, 0.0)).load_factor, 1.0 / 3.0);
//! assert_eq!(leaves(push(1.0, 0.0)).limits, [PlanLimit::Tips { edge: 1 }]);
//! assert_eq!(leaves(push(1.0, 1.0)).load_factor, 1.0 / 3.0);
//! # Ok::<(), standfast::footprint::FootprintError>(())
//! ```

mod hull;
mod rest;

use crate::ball::Scalar;
use crate::error::InputError;
use crate::exact::Real;
use crate::quantity::Quantity;

pub(crate) use rest::Problem;
pub use rest::{PlanDeparture, PlanLimit, Torsion};

/// Where a body bears on its base, seen from above, lengths in m from the point under its centre of mass.
#[derive(Debug, Clone, PartialEq)]
pub struct Footprint<T = f64>(Shape<T>);

#[derive(Debug, Clone, PartialEq)]
enum Shape<T> {
    /// The vertices of a convex polygon, counter-clockwise, no three of them on a line; and the places of these in what was given.
    Polygon(Vec<[T; 2]>, Vec<usize>),
    Circle {
        centre: [T; 2],
        radius: T,
    },
}

/// Forces and moments on a body, carried over to the point of its base that is under its centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseWrench<T = f64> {
    /// Horizontal force to the right, N.
    pub x: T,
    /// Horizontal force away from the viewer of the section, N.
    pub z: T,
    /// Downward force, N.
    pub p: T,
    /// P times how far to the right the centre of pressure is, N·m.
    pub q_x: T,
    /// P times how far away the centre of pressure is, N·m.
    pub q_z: T,
    /// Moment about the vertical through the centre of mass, counter-clockwise from above, N·m.
    pub t: T,
}

/// Points or a radius on which no body stands.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FootprintError {
    /// A coordinate or a radius is no number of a size that counts.
    #[error(transparent)]
    Input(#[from] InputError),
    /// All points lie on a line.
    #[error("all points of the base lie on a line; expected three that do not")]
    Line,
}

impl<T: Scalar> Footprint<T> {
    /// The convex hull of points [x, z]: corners of a polygon, or feet.
    ///
    /// # Errors
    /// If all lie on a line, or one is no number.
    pub fn polygon(points: &[[T; 2]]) -> Result<Footprint<T>, FootprintError> {
        for length in points.iter().flatten() {
            InputError::finite(Quantity::BaseCorner, length.value())?;
        }
        let places = hull::places(points).ok_or(FootprintError::Line)?;
        let vertices = places.iter().map(|place| points[*place].clone()).collect();
        Ok(Footprint(Shape::Polygon(vertices, places)))
    }

    /// A disc about [x, z].
    ///
    /// # Errors
    /// If its radius is not above zero, or one is no number.
    pub fn circle(centre: [T; 2], radius: T) -> Result<Footprint<T>, FootprintError> {
        for length in &centre {
            InputError::finite(Quantity::BaseCentre, length.value())?;
        }
        let radius = InputError::positive(Quantity::BaseRadius, radius)?;
        Ok(Footprint(Shape::Circle { centre, radius }))
    }

    /// The vertices of the polygon, counter-clockwise from the first given; none of a disc.
    pub fn vertices(&self) -> &[[T; 2]] {
        match &self.0 {
            Shape::Polygon(vertices, _) => vertices,
            Shape::Circle { .. } => &[],
        }
    }

    /// The places of the vertices among the points given; the others lie within the polygon, or on its edges.
    pub fn given(&self) -> &[usize] {
        match &self.0 {
            Shape::Polygon(_, places) => places,
            Shape::Circle { .. } => &[],
        }
    }

    /// Centre and radius of a disc.
    pub fn disc(&self) -> Option<([T; 2], T)> {
        match &self.0 {
            Shape::Polygon(..) => None,
            Shape::Circle { centre, radius } => Some((centre.clone(), radius.clone())),
        }
    }

    /// The footprint with its numbers rounded to f64.
    pub fn rounded(&self) -> Footprint {
        self.map(T::value)
    }
}

impl<T> Footprint<T> {
    pub(crate) fn map<U>(&self, of: impl Fn(&T) -> U) -> Footprint<U> {
        Footprint(match &self.0 {
            Shape::Polygon(vertices, places) => {
                let vertices = vertices.iter().map(|vertex| vertex.each_ref().map(&of));
                Shape::Polygon(vertices.collect(), places.clone())
            }
            Shape::Circle { centre, radius } => {
                Shape::Circle { centre: centre.each_ref().map(&of), radius: of(radius) }
            }
        })
    }
}

impl Footprint {
    /// The distance of each edge from the point under the centre of mass, m; below zero of one beyond which that lies. Of a disc that of its rim
    /// where it is nearest.
    pub fn distances(&self) -> Vec<f64> {
        match &self.0 {
            Shape::Polygon(vertices, _) => {
                let edges = edges(vertices);
                edges.map(|[[x1, z1], [x2, z2]]| (x1 * z2 - z1 * x2) / (x2 - x1).hypot(z2 - z1)).collect()
            }
            Shape::Circle { centre: [x, z], radius } => vec![radius - x.hypot(*z)],
        }
    }

    /// The directions [x, z] across the edges, of length one, outwards; of a disc that towards its rim where it is nearest.
    pub fn normals(&self) -> Vec<[f64; 2]> {
        match &self.0 {
            Shape::Polygon(vertices, _) => {
                let across = |[[x1, z1], [x2, z2]]: [&[f64; 2]; 2]| {
                    let length = (x2 - x1).hypot(z2 - z1);
                    [(z2 - z1) / length, (x1 - x2) / length]
                };
                edges(vertices).map(across).collect()
            }
            Shape::Circle { centre: [x, z], .. } => {
                let length = x.hypot(*z);
                vec![if length > 0.0 { [-x / length, -z / length] } else { [-1.0, 0.0] }]
            }
        }
    }

    /// R: how far it is from the point under the centre of mass to the edge in a direction [x, z] of length one, m; zero if that point is not on the
    /// base.
    pub fn reach(&self, [x, z]: [f64; 2]) -> f64 {
        let reach = match &self.0 {
            Shape::Polygon(..) => {
                let edges = self.normals().into_iter().zip(self.distances());
                let towards = edges.map(|([n_x, n_z], distance)| (n_x * x + n_z * z, distance));
                let reaches = towards.filter(|(along, distance)| *along > 0.0 || *distance < 0.0);
                reaches.map(|(along, distance)| distance / along.max(0.0)).fold(f64::INFINITY, f64::min)
            }
            Shape::Circle { centre: [c_x, c_z], radius } => {
                let along = c_x * x + c_z * z;
                let inside = radius * radius - c_x * c_x - c_z * c_z;
                if inside < 0.0 { 0.0 } else { along + (along * along + inside).sqrt() }
            }
        };
        reach.max(0.0)
    }
}

impl<T: Real> BaseWrench<T> {
    /// Nothing.
    pub fn zero() -> BaseWrench<T> {
        let zero = || T::of(0.0);
        BaseWrench { x: zero(), z: zero(), p: zero(), q_x: zero(), q_z: zero(), t: zero() }
    }

    /// A downward force through the centre of mass.
    pub fn pressing(force: T) -> BaseWrench<T> {
        BaseWrench { p: force, ..BaseWrench::zero() }
    }

    /// A horizontal force [right, away] in a vertical plane through the centre of mass, so high above the base.
    pub fn force([right, away]: [T; 2], height: T) -> BaseWrench<T> {
        let zero = || T::of(0.0);
        BaseWrench::force_at([right, away], zero(), [zero(), height, zero()])
    }

    /// A force to the right, away and downwards at a place [x, y, z] from the point of the base under the centre of mass.
    pub fn force_at([right, away]: [T; 2], down: T, [x, y, z]: [T; 3]) -> BaseWrench<T> {
        BaseWrench {
            q_x: right.clone() * y.clone() + down.clone() * x.clone(),
            q_z: away.clone() * y + down.clone() * z.clone(),
            t: x * away.clone() - z * right.clone(),
            x: right,
            z: away,
            p: down,
        }
    }

    /// The sum with another.
    pub fn plus(self, other: BaseWrench<T>) -> BaseWrench<T> {
        BaseWrench {
            x: self.x + other.x,
            z: self.z + other.z,
            p: self.p + other.p,
            q_x: self.q_x + other.q_x,
            q_z: self.q_z + other.q_z,
            t: self.t + other.t,
        }
    }

    /// So many times it.
    pub fn times(self, factor: T) -> BaseWrench<T> {
        self.map(|part| part.clone() * factor.clone())
    }
}

impl<T> BaseWrench<T> {
    pub(crate) fn map<U>(&self, of: impl Fn(&T) -> U) -> BaseWrench<U> {
        let BaseWrench { x, z, p, q_x, q_z, t } = self;
        BaseWrench { x: of(x), z: of(z), p: of(p), q_x: of(q_x), q_z: of(q_z), t: of(t) }
    }
}

impl BaseWrench {
    /// The magnitude of its horizontal force, N.
    pub fn horizontal(&self) -> f64 {
        self.x.hypot(self.z)
    }

    /// The direction of its horizontal force, degrees from 0 to 360; `None` without one.
    pub fn direction_deg(&self) -> Option<f64> {
        (self.horizontal() > 0.0).then(|| degrees([self.x, self.z]))
    }

    /// Its centre of pressure [x, z] from the point under the centre of mass, m; `None` where nothing presses.
    pub fn centre_of_pressure(&self) -> Option<[f64; 2]> {
        (self.p > 0.0).then(|| [self.q_x / self.p, self.q_z / self.p])
    }

    /// T_c: its moment about the vertical through its centre of pressure, counter-clockwise from above, N·m; about C where nothing presses.
    pub fn torsion(&self) -> f64 {
        let [x, z] = self.centre_of_pressure().unwrap_or_default();
        self.t - (x * self.z - z * self.x)
    }

    /// The wrench with its horizontal forces and their moments turned so many degrees from left over away to right.
    pub fn turned(&self, degrees: f64) -> BaseWrench {
        let (sin, cos) = exact_angle(degrees);
        // From −x towards +z is clockwise from above.
        let turn = |x: f64, z: f64| [x * cos + z * sin, z * cos - x * sin];
        let ([x, z], [q_x, q_z]) = (turn(self.x, self.z), turn(self.q_x, self.q_z));
        BaseWrench { x, z, q_x, q_z, ..*self }
    }
}

/// The direction of [x, z], degrees from 0, to the left, over 90, away, to below 360.
pub fn degrees([x, z]: [f64; 2]) -> f64 {
    let angle = z.atan2(-x).to_degrees();
    // −0.0 is 0, and what rounds to a whole turn is none.
    let angle = if angle < 0.0 { angle + 360.0 } else { angle + 0.0 };
    if angle >= 360.0 { 0.0 } else { angle }
}

/// [x, z] of length one in a direction in degrees, exact in quarters of a turn.
pub fn towards(degrees: f64) -> [f64; 2] {
    let (sin, cos) = exact_angle(degrees);
    [0.0 - cos, sin]
}

/// Sine and cosine of degrees; those of quarters of a turn without rounding.
fn exact_angle(degrees: f64) -> (f64, f64) {
    let whole = degrees.rem_euclid(360.0);
    match whole {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => whole.to_radians().sin_cos(),
    }
}

/// The edges of a polygon, each from a vertex to the next.
fn edges<V>(vertices: &[V]) -> impl Iterator<Item = [&V; 2]> {
    vertices.iter().zip(vertices.iter().cycle().skip(1)).map(|(from, to)| [from, to])
}
