//! Pressures along faces, forces at points, and which of them act together.

use standfast::loads::{
    Action, BodyPoint, Face, HorizontalForce, Load, LoadKind, LoadSource, PressureAt, PressureDiagram,
};
use standfast::{Body, History, InputError, Quantity, Scalar, Slip, Wrench};

use super::history::HistoryOf;
use super::motion::CaseMotion;
use super::plan::Turned;
use super::reader::Reader;
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};

/// A pressure along a face.
#[derive(Debug, Clone, PartialEq)]
pub struct FacePressure<T = f64> {
    /// Its name.
    pub name: Option<String>,
    /// The face it presses on, inwards.
    pub face: Face,
    /// The pressure as it acts, scaled.
    pub diagram: PressureDiagram<T>,
    /// Factor on the pressures of the file.
    pub scale: T,
    /// True if it is there all the time.
    pub permanent: bool,
    /// True if it is too fast for water to follow it into a base that opens.
    pub is_fast: bool,
}

/// A force at a point of the body, or a couple.
#[derive(Debug, Clone, PartialEq)]
pub struct PointForce<T = f64> {
    /// Its name.
    pub name: Option<String>,
    /// The table that says it, and its place among these.
    pub of: (Table, usize),
    /// N per metre run; of a couple N·m.
    pub magnitude: T,
    /// Its direction.
    pub direction: Direction,
    /// Above the base, m; 0 of a couple.
    pub elevation: T,
    /// To the right of O, m; `None` at mid-width, and of a couple.
    pub distance: Option<T>,
    /// Its direction and place seen from above; `None` in the plane of the section, and of a couple.
    pub across: Option<Turned<T>>,
    /// What it stands on, where that may be beside or above the body.
    pub lever: Option<String>,
    /// True if it is there all the time.
    pub permanent: bool,
    /// True if it acts with all other loads, rather than alone of those that do.
    pub together: bool,
    /// True if it is too fast for water to follow it into a base that opens.
    pub is_fast: bool,
    /// Variation in time.
    pub history: Option<History>,
}

/// Direction of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Horizontally.
    Sideways(Slip),
    /// With the weight.
    Down,
    /// Against the weight.
    Up,
    /// A couple that turns the body to a side: counter-clockwise to the left.
    Turning(Slip),
}

impl<T: Scalar> FacePressure<T> {
    /// The load.
    pub fn load(&self) -> Load<T> {
        let load = Load::pressure(self.face, self.diagram.clone());
        let load = Load { permanent: self.permanent, is_fast: self.is_fast, ..load };
        match &self.name {
            Some(name) => load.named(name),
            None => load,
        }
    }
}

impl<T: Scalar> PointForce<T> {
    /// True if it is an alternative to the others that act alone.
    pub fn acts_alone(&self) -> bool {
        !self.permanent && !self.together
    }

    /// The load on `body`.
    pub fn load(&self, body: &Body<T>) -> Load<T> {
        let zero = || T::of(0.0);
        let from_middle = |distance: &T| distance.clone() - body.base_edges().left;
        let at =
            BodyPoint { x: self.distance.as_ref().map_or_else(zero, from_middle), y: self.elevation.clone() };
        let magnitude = self.magnitude.clone();
        let (permanent, is_fast) = (self.permanent, self.is_fast);
        let (right, up) = match self.direction {
            Direction::Turning(side) => {
                let turns = Wrench { x: zero(), p: zero(), m: T::of(-side.sign()) * magnitude };
                let load = Load::variable(LoadSource::Couple, LoadKind::Horizontal, Action::Resultant(turns));
                return Load { permanent, is_fast, name: self.name.clone(), ..load };
            }
            Direction::Sideways(side) => (T::of(side.sign()) * magnitude, zero()),
            Direction::Down => (zero(), -magnitude),
            Direction::Up => (zero(), magnitude),
        };
        let load = Load { permanent, is_fast, name: self.name.clone(), ..Load::force(at, right, up) };
        let load = match self.direction {
            // Without a magnitude it is still a push.
            Direction::Sideways(_) => Load { kind: LoadKind::Horizontal, ..load },
            _ => load,
        };
        match &self.across {
            Some(turned) => turned.turn(load, self.magnitude.clone()),
            None => load,
        }
    }
}

impl Direction {
    /// As in a case file.
    pub fn word(self) -> &'static str {
        match self {
            Direction::Sideways(Slip::Left) | Direction::Turning(Slip::Left) => "left",
            Direction::Sideways(Slip::Right) | Direction::Turning(Slip::Right) => "right",
            Direction::Down => "down",
            Direction::Up => "up",
        }
    }
}

impl Reader<'_> {
    /// A force.
    pub(super) fn force<T: Scalar>(
        &self,
        index: usize,
        body: &Body<T>,
        motion: Option<&mut CaseMotion>,
    ) -> Result<PointForce<T>, Fault> {
        let id = |key| Id::new(key, index);
        let number = |key| self.inputs.scalar::<T>(id(key));
        let missing = |key| self.missing(key, index);
        let magnitude = number(Key::Force).ok_or_else(|| missing(Key::Force))?;
        let direction = match self.inputs.choice(id(Key::Towards)) {
            Some("right") => Direction::Sideways(Slip::Right),
            Some("down") => Direction::Down,
            Some("up") => Direction::Up,
            _ => Direction::Sideways(Slip::Left),
        };
        let (elevation, distance) = (number(Key::Elevation), number(Key::LoadDistance));
        let (elevation, distance) = match direction {
            Direction::Sideways(_) => (elevation.ok_or_else(|| missing(Key::Elevation))?, distance),
            _ => {
                let distance = distance.ok_or_else(|| missing(Key::LoadDistance))?;
                (elevation.unwrap_or_else(|| body.height()), Some(distance))
            }
        };
        let lever = self.inputs.text(id(Key::LoadLever)).map(str::to_owned);
        if lever.is_none() && !body.reaches(elevation.clone()) {
            let problem = Problem::AboveCrest { key: Key::Elevation, height: body.height().value() };
            return Err(Fault::new(problem, id(Key::Elevation)));
        }
        if let Direction::Sideways(side) = direction {
            // As a point of the report's plane it has to be within range.
            let force = HorizontalForce::new(magnitude.value(), elevation.value(), side);
            let friction = self.number(Key::Friction).unwrap_or(0.0);
            let reduced =
                force.and_then(|force| force.reduce(&body.rounded(), friction, self.inputs.gravity()));
            reduced.map_err(|error| self.blame_in(Table::Load, index, error))?;
        }
        let truth = |key| self.inputs.truth(id(key)).unwrap_or(false);
        let extent = self.inputs.extent();
        let history = self.history(Table::LoadHistory, index, HistoryOf::Force(magnitude.value(), extent))?;
        if history.is_some() && truth(Key::LoadPermanent) {
            let problem = Problem::HistoryOfPermanent { index };
            return Err(
                Fault::new(problem, Place::Table(Table::LoadHistory, index)).and(id(Key::LoadPermanent))
            );
        }
        let history = self.taken(history, motion, Table::LoadHistory, index)?;
        Ok(PointForce {
            name: self.inputs.text(id(Key::LoadName)).map(str::to_owned),
            of: (Table::Load, index),
            magnitude,
            direction,
            elevation,
            distance,
            across: self.turned(index, direction)?,
            lever,
            permanent: truth(Key::LoadPermanent),
            together: truth(Key::Together),
            is_fast: truth(Key::LoadFast) || history.is_some(),
            history,
        })
    }

    /// A couple.
    pub(super) fn couple<T: Scalar>(&self, index: usize) -> Result<PointForce<T>, Fault> {
        let id = |key| Id::new(key, index);
        if let Some(what) = self.in_time_words() {
            let problem = Problem::HoldsNot { holds: "a [[moment]]".to_owned(), what };
            return Err(Fault::new(problem, Place::Table(Table::Moment, index)));
        }
        let side = match self.inputs.choice(id(Key::MomentTowards)) {
            Some("right") => Slip::Right,
            _ => Slip::Left,
        };
        let truth = |key| self.inputs.truth(id(key)).unwrap_or(false);
        Ok(PointForce {
            name: self.inputs.text(id(Key::MomentName)).map(str::to_owned),
            of: (Table::Moment, index),
            magnitude: self.inputs.scalar(id(Key::Couple)).ok_or_else(|| self.missing(Key::Couple, index))?,
            direction: Direction::Turning(side),
            elevation: T::of(0.0),
            distance: None,
            across: None,
            lever: None,
            permanent: truth(Key::MomentPermanent),
            together: truth(Key::MomentTogether),
            is_fast: truth(Key::MomentFast),
            history: None,
        })
    }

    /// A pressure along a face.
    pub(super) fn pressure<T: Scalar>(&self, index: usize, body: &Body<T>) -> Result<FacePressure<T>, Fault> {
        let id = |key| Id::new(key, index);
        let face =
            self.inputs.choice(id(Key::PressedFace)).ok_or_else(|| self.missing(Key::PressedFace, index))?;
        let face = match face {
            "left" => Face::Left,
            "right" => Face::Right,
            "base" => Face::Base,
            _ => Face::Top,
        };
        let rounded = body.rounded();
        let (along, other, ends) = match ends(&rounded, face) {
            Some(ends) => (Key::PressureDistance, Key::PressureElevation, ends),
            None => (Key::PressureElevation, Key::PressureDistance, [0.0, rounded.height()]),
        };
        if self.inputs.list(id(other)).is_some() {
            return Err(Fault::new(Problem::WrongAlong { found: other, expected: along }, id(other)));
        }
        let list = |key| self.inputs.list(id(key)).ok_or_else(|| self.missing(key, index));
        let (positions, pressures) = (list(along)?, list(Key::Pressures)?);
        if positions.len() != pressures.len() || positions.len() < 2 {
            let problem = Problem::Lengths { along, positions: positions.len(), pressures: pressures.len() };
            return Err(Fault::new(problem, id(Key::Pressures)).and(id(along)));
        }
        let outside = |position: &&f64| **position < ends[0] - SLACK || **position > ends[1] + SLACK;
        if let Some(&position) = positions.iter().find(outside) {
            let problem = Problem::BesideFace { along, position, from: ends[0], to: ends[1] };
            return Err(Fault::new(problem, id(along)));
        }
        let scale = self.inputs.scalar(id(Key::PressureFactor)).unwrap_or_else(|| T::of(1.0));
        let points = positions.iter().zip(pressures).enumerate();
        let points = points.map(|(place, (&position, &pressure))| PressureAt {
            position: self.inputs.element(id(along), place, position),
            pressure: self.inputs.element::<T>(id(Key::Pressures), place, pressure) * scale.clone(),
        });
        let diagram = PressureDiagram::new(points.collect()).map_err(|error: InputError| {
            let key = match error.quantity {
                Quantity::PressurePosition => along,
                _ if scale.value().abs() > 1.0 => Key::PressureFactor,
                _ => Key::Pressures,
            };
            Fault::new(Problem::Impossible { key, error }, id(key))
        })?;
        if positions.first() == positions.last() {
            let problem = Problem::NoExtent { along, position: positions[0] };
            return Err(Fault::new(problem, id(along)));
        }
        let name = self.inputs.text(id(Key::PressureName)).map(str::to_owned);
        let permanent = self.inputs.truth(id(Key::PressurePermanent)).unwrap_or(false);
        let is_fast = self.inputs.truth(id(Key::PressureFast)).unwrap_or(false);
        Ok(FacePressure { name, face, diagram, scale, permanent, is_fast })
    }

    /// Refusal by the library, shown at the key of one of several tables.
    fn blame_in(&self, table: Table, index: usize, error: InputError) -> Fault {
        let fault = self.blame_one_of(table.keys(), index, error);
        fault.unwrap_or_else(|| Fault::new(Problem::Mechanics(error), Place::Table(table, index)))
    }
}

/// Distance by which a pressure may reach beyond its face through rounding, m.
pub(crate) const SLACK: f64 = 1e-6;

/// Ends of the base or the top, to the right of O, m; `None` of the sides.
pub(crate) fn ends(body: &Body, face: Face) -> Option<[f64; 2]> {
    match face {
        Face::Left | Face::Right => None,
        Face::Base => Some([0.0, body.base_width()]),
        Face::Top => {
            let left = body.base_edges().left - body.width() / 2.0;
            Some([left, left + body.width()])
        }
    }
}
