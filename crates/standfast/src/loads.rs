//! Loads in SI units, each kept where it acts: what it amounts to at the centre of mass follows for any pose of the body.
//!
//! | question | start at |
//! |---|---|
//! | What acts where? | [`Action`], [`Load`] |
//! | What acts on a body above a joint? | [`AboveJoint`] |
//! | Still water on the sides and under the base | [`StillWater`] |
//! | Pressures under the base | [`Uplift`] |
//! | A base that is shaken; water that moves with the body | [`Earthquake`], [`AddedMass`] |
//! | Waves by Goda's formulas | [`wave`] |
//! | Soil beside the body | [`earth`] |
//! | One horizontal force in the report's numbers | [`HorizontalForce`] |
//!
//! Each kind of load is a small checked type whose `loads` a [`Situation`](crate::Situation) takes. What a load means (is it
//! there all the time? does it count as weight, uplift or push?) is decided here, once.

mod above;
mod action;
pub mod earth;
mod earthquake;
mod force;
mod uplift;
mod water;
pub mod wave;

pub use above::AboveJoint;
pub use action::{Action, BodyForce, BodyPoint, Face, Pose, PressureAt, PressureDiagram};
pub use earthquake::{AddedMass, Earthquake};
pub use force::{HorizontalForce, Reduced};
pub use uplift::Uplift;
pub use water::StillWater;

use crate::ball::Scalar;
use crate::body::Body;
use crate::history::History;
use crate::wrench::Wrench;

/// Kind of a load among the [classical actions](crate::ClassicalActions).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum LoadKind {
    /// Vertical: weight, buoyancy, vertical acceleration.
    Weight,
    /// Pressure under the base that is not buoyancy.
    Uplift,
    /// Horizontal: waves, water on the sides, forces, horizontal acceleration.
    Horizontal,
}

/// Source of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum LoadSource {
    /// m g.
    Weight,
    /// Still water under the base, or the part of the weight that it bears.
    Buoyancy,
    /// Still water on the sides.
    StillWater,
    /// Still water that stands on steps and slopes of the left side, or lifts where the body overhangs.
    WaterOnLeft,
    /// Still water that stands on steps and slopes of the right side, or lifts where the body overhangs.
    WaterOnRight,
    /// Pressures under the base, as given.
    Uplift,
    /// The body's inertia against a horizontal acceleration of the base.
    HorizontalInertia,
    /// Water against the shaken wall.
    ShakenWater,
    /// The body's inertia against a vertical acceleration of the base.
    VerticalInertia,
    /// Waves on the wall.
    WavePressure,
    /// Waves under the base.
    WaveUplift,
    /// Soil against a side.
    EarthPressure,
    /// Soil that drags a side down.
    EarthDrag,
    /// Water in a soil that is shaken.
    PoreWater,
    /// A force.
    Force,
    /// A couple.
    Couple,
    /// A pressure along a face, as given.
    Pressure,
    /// Anything else.
    Other,
}

/// A number by which whoever makes loads finds each again: two loads that are equal otherwise are told apart by it alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct LoadId(pub u64);

/// Share of a load out of the plane of the section, which counts on a base [seen from above](crate::footprint).
#[derive(Debug, Clone, PartialEq)]
pub struct Across<T = f64> {
    /// The force away from the viewer, N; of inertia the acceleration of the base that way, m/s².
    pub away: T,
    /// Where it acts along the length, away from its middle, m; `None` at the centre of mass.
    pub z: Option<T>,
}

/// A load on a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Load<T = f64> {
    /// Number among its maker's loads; 0 where nobody asks.
    pub id: LoadId,
    /// Source of the load.
    pub source: LoadSource,
    /// Kind of the load.
    pub kind: LoadKind,
    /// Name, where its source does not say it.
    pub name: Option<String>,
    /// True if it is there all the time, rather than grows with the load factor.
    pub permanent: bool,
    /// True if it is too fast for water to follow it into a base that opens.
    pub is_fast: bool,
    /// The partial factor by which it is multiplied; 1 for the load itself.
    pub factor: T,
    /// Action, with its place.
    pub action: Action<T>,
    /// Its share out of the plane of the section; `None` of a load in the vertical plane through the centre of mass.
    pub across: Option<Across<T>>,
    /// Course of its size in time, as a share of the action; `None` of a load of which nothing is said, which a problem of rest takes as it
    /// is.
    pub history: Option<History>,
}

impl<T: Scalar> Load<T> {
    /// A load that is there all the time.
    pub fn permanent(source: LoadSource, kind: LoadKind, action: impl Into<Action<T>>) -> Load<T> {
        Load {
            id: LoadId::default(),
            source,
            kind,
            name: None,
            permanent: true,
            is_fast: false,
            factor: T::of(1.0),
            action: action.into(),
            across: None,
            history: None,
        }
    }

    /// A load that grows with the load factor.
    pub fn variable(source: LoadSource, kind: LoadKind, action: impl Into<Action<T>>) -> Load<T> {
        Load { permanent: false, ..Load::permanent(source, kind, action) }
    }

    /// A pressure along a face, that varies: under the base it counts as uplift, on the top as weight, on a side as a push.
    pub fn pressure(face: Face, diagram: PressureDiagram<T>) -> Load<T> {
        let kind = match face {
            Face::Left | Face::Right => LoadKind::Horizontal,
            Face::Base => LoadKind::Uplift,
            Face::Top => LoadKind::Weight,
        };
        Load::variable(LoadSource::Pressure, kind, Action::Pressure { face, diagram })
    }

    /// A force at a place of the body (N per metre run, to the right and upwards), that varies: a vertical one counts as weight,
    /// any other as a push.
    pub fn force(at: BodyPoint<T>, right: T, up: T) -> Load<T> {
        let kind = if right == T::of(0.0) { LoadKind::Weight } else { LoadKind::Horizontal };
        Load::variable(LoadSource::Force, kind, Action::Force { at, right, up })
    }

    /// Load under a name.
    pub fn named(self, name: impl Into<String>) -> Load<T> {
        Load { name: Some(name.into()), ..self }
    }

    /// Load as one of its maker's loads.
    pub fn with_id(self, id: LoadId) -> Load<T> {
        Load { id, ..self }
    }

    /// True of still water under the base.
    pub fn is_water_under_base(&self) -> bool {
        let is_under = matches!(self.action, Action::Pressure { face: Face::Base, .. });
        self.source == LoadSource::Buoyancy && is_under
    }

    /// Load that is too fast for water to follow it.
    pub fn fast(self) -> Load<T> {
        Load { is_fast: true, ..self }
    }

    /// Load with a share out of the plane of the section.
    pub fn across(self, across: Across<T>) -> Load<T> {
        Load { across: Some(across), ..self }
    }

    /// Load with a history.
    pub fn over_time(self, history: History) -> Load<T> {
        Load { history: Some(history), ..self }
    }

    /// Load multiplied by a partial factor.
    pub fn times(self, factor: T) -> Load<T> {
        Load { factor: self.factor * factor, ..self }
    }

    /// Wrench at the centre of mass of `body`, upright, at the acceleration of gravity `gravity` (m/s²).
    pub fn upright(&self, body: &Body<T>, gravity: T) -> Wrench<T> {
        self.action.upright(body, gravity) * self.factor.clone()
    }
}

impl Load {
    /// Load of numbers that were computed in f64, in any arithmetic; see [`Scalar::computed`].
    pub fn computed<T: Scalar>(self) -> Load<T> {
        let Load { id, source, kind, name, permanent, is_fast, factor, action, across, history } = self;
        let (factor, action) = (T::computed(factor), action.computed());
        let across =
            across.map(|Across { away, z }| Across { away: T::computed(away), z: z.map(T::computed) });
        Load { id, source, kind, name, permanent, is_fast, factor, action, across, history }
    }

    /// Wrench at the centre of mass of `body` at the acceleration of gravity `gravity` (m/s²), for its pose.
    pub fn wrench(&self, body: &Body, gravity: f64, pose: Pose) -> Wrench {
        self.action.wrench(body, gravity, pose) * self.factor
    }

    /// The forces that it is made of, times its factor; see [`Action::forces`].
    pub fn forces(&self, body: &Body, gravity: f64) -> Vec<BodyForce> {
        let mut forces = self.action.forces(body, gravity);
        for force in &mut forces {
            force.size = force.size.map(|size| size * self.factor);
        }
        forces
    }
}
