//! What holds a body beside friction: adhesion, forces with a limit, a passive soil.

use standfast::contact::holding::{Adhesion, AdhesionArea, Hold, Holding, MOST};
use standfast::loads::Face;
use standfast::loads::earth::{EarthState, sums};
use standfast::{Body, Plan, Scalar, Slip};

use super::loads::Direction;
use super::reader::Reader;
use super::{Case, Foundation, SoilFill};
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};

/// A force with a limit that holds the body as far as rest needs it.
#[derive(Debug, Clone, PartialEq)]
pub struct Resistance {
    /// Its name.
    pub name: String,
    /// The table that says it: a resistance, or a soil, by its place.
    pub of: (Table, usize),
    /// The most that it holds, N per metre run or of the whole, before its share.
    pub limit: f64,
    /// How much of it is counted.
    pub share: f64,
    /// Divisor of a combination.
    pub divisor: f64,
    /// Where it holds the body to.
    pub direction: Direction,
    /// Above the base, m.
    pub elevation: f64,
    /// To the right of O, m; `None` at mid-width.
    pub distance: Option<f64>,
}

impl Resistance {
    /// R, the most that is counted, N per metre run or of the whole.
    pub fn counted(&self) -> f64 {
        self.limit * self.share / self.divisor
    }

    /// True of a soil.
    pub fn is_passive(&self) -> bool {
        self.of.0 == Table::Backfill
    }

    /// As the mechanics have it.
    fn hold(&self, body: &Body) -> Hold {
        let direction = match self.direction {
            Direction::Sideways(side) => [side.sign(), 0.0],
            _ => [0.0, -1.0],
        };
        let x = self.distance.map_or(-body.centroid_offset(), |distance| distance - body.heel_distance());
        Hold { at: [x, self.elevation - body.centroid_height()], direction, limit: self.counted() }
    }
}

impl<T: Scalar> Case<T> {
    /// What holds the body beside friction.
    pub fn holding(&self) -> Holding {
        let body = self.body.rounded();
        let length = body.plan().side(body.width());
        let adhesion = self.adhesion.filter(|adhesion| adhesion.strength > 0.0);
        let adhesion = adhesion.map(|adhesion| Adhesion { strength: adhesion.strength * length, ..adhesion });
        let holds = self.resistances.iter().map(|resistance| resistance.hold(&body));
        holds.fold(Holding::new(adhesion), Holding::with)
    }
}

/// Name of a resistance that has none.
const UNNAMED: &str = "resistance";

impl Reader<'_> {
    /// Adhesion between body and base.
    pub(super) fn adhesion(
        &self,
        body: &Body,
        ground: Option<&Foundation>,
    ) -> Result<Option<Adhesion>, Fault> {
        let Some(strength) = self.number(Key::Adhesion) else {
            return match self.inputs.choice(Key::AdhesionOn) {
                Some(_) => Err(self.missing(Key::Adhesion, 0)),
                None => Ok(None),
            };
        };
        let what = match ground {
            _ if body.plan() == Plan::Circle => Some("a cylinder"),
            Some(ground) if ground.strength().is_some() => Some("a base that crushes"),
            _ => self.in_time_words(),
        };
        if let Some(what) = what {
            return Err(Fault::new(
                Problem::HoldsNot { holds: "`adhesion`".to_owned(), what },
                Key::Adhesion,
            ));
        }
        let on = match self.inputs.choice(Key::AdhesionOn) {
            Some("effective") => AdhesionArea::Effective,
            _ => AdhesionArea::Pressed,
        };
        Ok(Some(Adhesion { strength, on }))
    }

    /// In words, what follows a body in time, where something does.
    pub(super) fn in_time_words(&self) -> Option<&'static str> {
        match () {
            () if self.inputs.is_in_time() => Some("a body that is followed in time"),
            () if self.inputs.has(Table::Storm) => Some("storms, whose waves slide a body"),
            () => None,
        }
    }

    /// The forces with a limit, those of passive soils behind the others.
    pub(super) fn resistances(
        &self,
        body: &Body,
        ground: Option<&Foundation>,
        soils: &[SoilFill],
    ) -> Result<Vec<Resistance>, Fault> {
        let given = (0..self.inputs.count(Table::Resistance)).map(|index| self.resistance(index, body));
        let mut all = given.collect::<Result<Vec<_>, Fault>>()?;
        let passive = soils.iter().enumerate().filter(|(_, fill)| fill.soil.state == EarthState::Passive);
        for (index, fill) in passive {
            all.push(self.passive(index, fill, body)?);
        }
        let place = |resistance: &Resistance| Place::Table(resistance.of.0, resistance.of.1);
        if let Some(extra) = all.get(MOST) {
            return Err(Fault::new(
                Problem::TooManyResistances { count: all.len(), most: MOST },
                place(extra),
            ));
        }
        let Some(first) = all.first() else { return Ok(all) };
        let what = match ground {
            Some(_) => Some("a body on [ground]"),
            None => self.in_time_words(),
        };
        if let Some(what) = what {
            let holds = format!("the resistance \"{}\"", first.name);
            return Err(Fault::new(Problem::HoldsNot { holds, what }, place(first)));
        }
        if let (Some(second), true) = (all.get(1), self.number(Key::Adhesion).is_some_and(|a| a > 0.0)) {
            let holds = format!("the resistance \"{}\"", second.name);
            let what = "a body that adheres to its base and has another resistance";
            return Err(Fault::new(Problem::HoldsNot { holds, what }, place(second)));
        }
        for (later, resistance) in all.iter().enumerate() {
            if all[..later].iter().any(|earlier| earlier.name == resistance.name) {
                let problem = Problem::SameResistance { name: resistance.name.clone() };
                return Err(Fault::new(problem, place(resistance)));
            }
        }
        Ok(all)
    }

    fn resistance(&self, index: usize, body: &Body) -> Result<Resistance, Fault> {
        let id = |key| Id::new(key, index);
        let number = |key| self.inputs.number(id(key));
        let needed = |key| number(key).ok_or_else(|| self.missing(key, index));
        let direction = match self.inputs.choice(id(Key::ResistanceTowards)) {
            Some("right") => Direction::Sideways(Slip::Right),
            Some("left") => Direction::Sideways(Slip::Left),
            Some(_) => Direction::Down,
            None => return Err(self.missing(Key::ResistanceTowards, index)),
        };
        let (elevation, distance) = (number(Key::ResistanceElevation), number(Key::ResistanceDistance));
        let (elevation, distance) = match direction {
            Direction::Sideways(_) => (needed(Key::ResistanceElevation)?, distance),
            _ => (elevation.unwrap_or(0.0), Some(needed(Key::ResistanceDistance)?)),
        };
        if elevation > body.height() + 1e-9 * body.height() {
            let problem = Problem::AboveCrest { key: Key::ResistanceElevation, height: body.height() };
            return Err(Fault::new(problem, id(Key::ResistanceElevation)));
        }
        let name = self.inputs.text(id(Key::ResistanceName)).map(str::to_owned);
        let count = self.inputs.count(Table::Resistance);
        let unnamed = || if count > 1 { format!("{UNNAMED} {}", index + 1) } else { UNNAMED.to_owned() };
        Ok(Resistance {
            name: name.unwrap_or_else(unnamed),
            of: (Table::Resistance, index),
            limit: needed(Key::ResistanceLimit)?,
            share: number(Key::ResistanceShare).unwrap_or(1.0),
            divisor: 1.0,
            direction,
            elevation,
            distance,
        })
    }

    /// What a passive soil resists with.
    fn passive(&self, index: usize, fill: &SoilFill, body: &Body) -> Result<Resistance, Fault> {
        let id = |key| Id::new(key, index);
        let soil = &fill.soil;
        let share = self.inputs.number(id(Key::BackfillShare));
        let share = share.ok_or_else(|| {
            let problem = Problem::ShareMissing { name: fill.name.clone() };
            Fault::new(problem, Place::Table(Table::Backfill, index))
        })?;
        let odd = [
            (Key::BackfillSlope, soil.slope_deg != 0.0),
            (Key::BackfillBatter, soil.batter_deg != 0.0),
            (Key::BackfillSurcharge, soil.surcharge != 0.0),
        ];
        if let Some((key, _)) = odd.into_iter().find(|(_, is_there)| *is_there) {
            return Err(Fault::new(Problem::NotOfPassive { name: fill.name.clone(), key }, id(key)));
        }
        let [force, moment] = sums(&fill.pressure.soil, |point| point.normal);
        let side = if soil.face == Face::Right { Slip::Left } else { Slip::Right };
        Ok(Resistance {
            name: fill.name.clone(),
            of: (Table::Backfill, index),
            limit: force * body.plan().side(body.width()),
            share,
            divisor: 1.0,
            direction: Direction::Sideways(side),
            elevation: if force > 0.0 { moment / force } else { 0.0 },
            distance: None,
        })
    }
}
