//! From typed inputs to a body, its surroundings and its waves: what is missing, out of range, or does not go together is a fault
//! at its key.

use standfast::contact::opening::Drain;
use standfast::loads::{AddedMass, Earthquake, StillWater, Uplift};
use standfast::{Body, InputError, OpeningRule, Plan, Scalar, Section};
use standfast_motion::MotionError;

use super::{Foundation, Limit, Waves, Weight};
use crate::error::{Fault, Place, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Id, Key, Range, Table};

/// Difference up to which lengths count as equal, m.
pub(super) const SAME_LENGTH: f64 = 1e-6;

/// Difference up to which densities count as equal, kg/m³.
const SAME_DENSITY: f64 = 1e-6;

/// Inputs, read with what goes wrong.
#[derive(Clone, Copy)]
pub(crate) struct Reader<'a> {
    pub(crate) inputs: &'a Inputs,
}

impl Reader<'_> {
    /// Every number is in the range of its key.
    pub(crate) fn ranges(&self) -> Result<(), Fault> {
        for (id, number) in self.inputs.numbers() {
            let key = id.key;
            // A partial factor may divide an angle to less than one writes.
            let is_divided = || key.info().range() == Some(Range::SoilAngle) && self.inputs.is_divided(id);
            if let Some(range) = key.info().range().filter(|range| !range.contains(number) && !is_divided()) {
                return Err(Fault::new(Problem::out_of_range(key, range, number), id));
            }
        }
        Ok(())
    }

    /// Nothing is asked of a motion where there is none.
    pub(super) fn of_motion(&self) -> Result<(), Fault> {
        // A case is read by the million, and few keys are of a motion.
        let asked = Table::Criteria.keys().filter(|key| self.inputs.get(*key).is_some());
        match asked.into_iter().find(|key| key.is_of_motion()) {
            Some(key) if !self.inputs.is_in_time() => {
                let of = match key {
                    Key::GreatestSlide => "how far the body slides",
                    Key::GreatestTheta => "how far the body turns",
                    _ => "whether the body overturns in the end",
                };
                Err(Fault::new(Problem::Unanswerable { name: key.name(), of }, key))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn number(&self, key: Key) -> Option<f64> {
        self.inputs.number(key)
    }

    /// The number under a key, in any arithmetic.
    pub(crate) fn scalar<T: Scalar>(&self, key: Key) -> Option<T> {
        self.inputs.scalar(key)
    }

    /// The number under a key that has to be there, in any arithmetic.
    pub(crate) fn needed<T: Scalar>(&self, key: Key) -> Result<T, Fault> {
        self.scalar(key).ok_or_else(|| self.missing(key, 0))
    }

    pub(crate) fn required(&self, key: Key) -> Result<f64, Fault> {
        self.number(key).ok_or_else(|| self.missing(key, 0))
    }

    pub(crate) fn missing(&self, key: Key, index: usize) -> Fault {
        self.missing_in(Id::new(key, index))
    }

    pub(crate) fn missing_in(&self, id: Id) -> Fault {
        Fault::new(Problem::MissingKey { table: id.table, key: id.key }, Place::Table(id.table, id.index))
    }

    /// Reads a table, if there is one.
    pub(super) fn in_table<T>(
        &self,
        table: Table,
        read: impl FnOnce(&Self) -> Result<T, Fault>,
    ) -> Result<Option<T>, Fault> {
        self.inputs.has(table).then(|| read(self)).transpose()
    }

    /// Refusal by the library, shown at the key of a table that gives the quantity, or at the number that is too large.
    pub(super) fn blame(&self, table: Table, error: InputError) -> Fault {
        self.blame_one_of(table.keys(), 0, error)
            .unwrap_or_else(|| Fault::new(Problem::Mechanics(error), table))
    }

    pub(super) fn blame_one_of(
        &self,
        mut keys: impl Iterator<Item = Key>,
        index: usize,
        error: InputError,
    ) -> Option<Fault> {
        let gives = |key: Key| key.info().gives.contains(&error.quantity);
        let key = keys.find(|key| gives(*key) && self.inputs.get(Id::new(*key, index)).is_some());
        let id = key.map(|key| Id::new(key, index));
        let impossible = |id: Id| Fault::new(Problem::Impossible { key: id.key, error }, id);
        let says = |id: &Id| gives(id.key) && self.inputs.number(*id) == Some(error.value);
        if let Some(id) = id.filter(|id| says(id) || !error.is_about_size()) {
            return Some(impossible(id));
        }
        // No number of this table: one of another, or what several came to, shown at the one that is most out of size.
        let numbers = || self.inputs.numbers().filter(|(_, number)| *number != 0.0);
        let size = |number: f64| number.abs().log10().abs();
        let said = numbers().map(|(id, _)| id).find(says).map(impossible);
        let farthest = || numbers().max_by(|(_, one), (_, two)| size(*one).total_cmp(&size(*two)));
        said.or_else(|| Some(Fault::new(Problem::Mechanics(error), farthest()?.0)))
    }

    pub(super) fn kinetic_friction<T: Scalar>(&self, friction: T) -> Result<T, Fault> {
        let kinetic = self.scalar(Key::KineticFriction).unwrap_or_else(|| friction.clone());
        let [slips, sticks] = [&kinetic, &friction].map(T::value);
        if slips > sticks {
            let problem = Problem::KineticFriction { kinetic: slips, friction: sticks };
            return Err(Fault::new(problem, Key::KineticFriction));
        }
        Ok(kinetic)
    }

    pub(super) fn weight<T: Scalar>(
        &self,
        body: &Body<T>,
        section: Option<&Section>,
    ) -> Result<Weight<T>, Fault> {
        match (self.scalar(Key::BuoyantWeight), self.scalar::<T>(Key::WeightArm)) {
            (Some(force), Some(arm)) => Ok(Weight::Buoyant { force, arm }),
            (Some(force), None) => {
                let arm = section.and_then(|section| self.arm_of_parts(body, section));
                Ok(Weight::Buoyant { force, arm: arm.unwrap_or_else(|| body.heel_distance()) })
            }
            (None, None) => Ok(Weight::Total),
            (None, Some(_)) => Err(Fault::new(Problem::ArmWithoutWeight, Key::WeightArm)),
        }
    }

    /// The arm of the weight of parts less the water that they displace under the waves' still water.
    fn arm_of_parts<T: Scalar>(&self, body: &Body<T>, section: &Section) -> Option<T> {
        let (depth, density) = (self.still_water()?, self.number(self.sea_density_key())?);
        let [o, _] = section.base();
        let displaced = section.below(depth);
        let buoyancy = density * displaced.area;
        let (mass, arm) = (body.mass().value(), body.heel_distance().value());
        let weight = mass - buoyancy;
        (weight > 0.0).then(|| T::computed((mass * arm - buoyancy * (displaced.x - o)) / weight))
    }

    /// Key that gives the density of the sea: its own, or that of the water that stands beside the body.
    pub(super) fn sea_density_key(&self) -> Key {
        let by_water =
            self.number(Key::WaveWaterDensity).is_none() && self.number(Key::WaterDensity).is_some();
        if by_water { Key::WaterDensity } else { Key::WaveWaterDensity }
    }

    pub(super) fn water<T: Scalar>(
        &self,
        body: &Body<T>,
        wave: Option<&Waves>,
    ) -> Result<StillWater<T>, Fault> {
        let sides = (self.scalar::<T>(Key::Level), self.scalar(Key::WaterLeft), self.scalar(Key::WaterRight));
        let (left, right) = match sides {
            (Some(level), None, None) => (level.clone(), level),
            (None, Some(left), Some(right)) => (left, right),
            (None, None, None) => return Err(Fault::new(Problem::NoLevel, Table::Water)),
            (None, Some(_), None) => {
                return Err(Fault::new(Problem::OneLevel { missing: Key::WaterRight }, Table::Water));
            }
            (None, None, Some(_)) => {
                return Err(Fault::new(Problem::OneLevel { missing: Key::WaterLeft }, Table::Water));
            }
            (Some(_), _, _) => return Err(Fault::new(Problem::LevelAndSides, Key::Level)),
        };
        let of_wave = wave.map(|wave| wave.water_density);
        let density = match (self.scalar::<T>(Key::WaterDensity), of_wave) {
            (Some(density), Some(of_wave)) if (density.value() - of_wave).abs() > SAME_DENSITY => {
                let own = (Key::WaterDensity, density.value());
                return Err(disagree(own, (Key::WaveWaterDensity, of_wave)));
            }
            (Some(density), _) => density,
            (None, Some(_)) => self.needed(Key::WaveWaterDensity)?,
            (None, None) => return Err(Fault::new(Problem::NoWaterDensity, Table::Water)),
        };
        let right_key = if self.number(Key::Level).is_some() { Key::Level } else { Key::WaterRight };
        let levels = [&left, &right].map(T::value);
        let water = StillWater::new(body, left, right, density).map_err(|error| {
            let left_is_it = error.value == levels[0] && self.number(Key::WaterLeft).is_some();
            let key = if left_is_it { Key::WaterLeft } else { right_key };
            let blamed = [key, Key::WaterDensity].into_iter();
            let fault = self.blame_one_of(blamed, 0, error);
            fault.unwrap_or_else(|| Fault::new(Problem::Mechanics(error), Table::Water))
        })?;
        match wave.and_then(Waves::still_water) {
            Some(depth) if (depth - levels[1]).abs() > SAME_LENGTH => {
                Err(disagree((right_key, levels[1]), (self.still_water_key(), depth)))
            }
            _ => Ok(water),
        }
    }

    /// Refuses what is not worked out for a tilted floor, where there is one.
    pub(super) fn floor<T>(&self, weight: &Weight<T>, ground: Option<&Foundation>) -> Result<(), Fault> {
        let Some(slope) = self.number(Key::FloorDeg).filter(|slope| *slope != 0.0) else { return Ok(()) };
        const OTHERS: [(Table, &str); 8] = [
            (Table::Water, "still water"),
            (Table::Wave, "a wave"),
            (Table::AddedMass, "water that moves with the body"),
            (Table::Backfill, "soil beside the body"),
            (Table::Resistance, "a tie"),
            (Table::Motion, "the motion in time"),
            (Table::LoadHistory, "a load over time"),
            (Table::Storm, "a storm"),
        ];
        let others = OTHERS.iter().find(|(table, _)| self.inputs.has(*table)).map(|(_, what)| *what);
        let weight = matches!(weight, Weight::Buoyant { .. }).then_some("a buoyant weight");
        let fails = ground.is_some_and(|ground| matches!(ground.limit, Some(Limit::Ground(_))));
        match others.or(weight).or(fails.then_some("ground that fails")) {
            Some(what) => Err(Fault::new(Problem::TiltedFloor { slope, what }, Key::FloorDeg)),
            None => Ok(()),
        }
    }

    /// What water follows into a base that opens: steady loads where its levels differ, unless the file says otherwise, or the base is one
    /// whose opening is not followed.
    pub(super) fn opening(
        &self,
        body: &Body,
        ground: Option<&Foundation>,
    ) -> Result<Option<OpeningRule>, Fault> {
        let what = match ground {
            _ if body.plan() == Plan::Circle => Some("a cylinder"),
            Some(ground) if ground.strength().is_some() => Some("a base that crushes"),
            Some(ground) if ground.stiffness.is_some() => Some("an elastic base"),
            _ => None,
        };
        let asked = match self.inputs.choice(Key::OpeningOf) {
            Some("closed") => return Ok(None),
            Some("always") => Some(OpeningRule::Always),
            Some(_) => Some(OpeningRule::Steady),
            None => None,
        };
        match (what, asked) {
            (Some(what), Some(_)) => {
                let key = Key::OpeningOf;
                Err(Fault::new(Problem::OpeningNotFor { key, what }, key))
            }
            (Some(what), None) if self.inputs.has(Table::Drain) => {
                Err(Fault::new(Problem::OpeningNotFor { key: Key::DrainDistance, what }, Table::Drain))
            }
            (Some(_), None) => Ok(None),
            (None, asked) => Ok(Some(asked.unwrap_or(OpeningRule::Steady))),
        }
    }

    /// Drains under the base.
    pub(super) fn drain(&self, body: &Body) -> Result<Drain, Fault> {
        let drain = Drain {
            distance: self.required(Key::DrainDistance)?,
            efficiency: self.required(Key::DrainEfficiency)?,
        };
        match drain.distance < body.base_width() {
            true => Ok(drain),
            false => {
                let (distance, base) = (drain.distance, body.base_width());
                Err(Fault::new(Problem::DrainBesideBase { distance, base }, Key::DrainDistance))
            }
        }
    }

    pub(super) fn uplift<T: Scalar>(&self) -> Result<Uplift<T>, Fault> {
        let (left, right) = (self.needed::<T>(Key::UpliftLeft)?, self.needed(Key::UpliftRight)?);
        let at_left = left.value();
        let grows = self.inputs.truth(Key::UpliftGrows).unwrap_or(false);
        Uplift::new(left, right, grows).map_err(|error| {
            let key = if error.value == at_left { Key::UpliftLeft } else { Key::UpliftRight };
            Fault::new(Problem::Impossible { key, error }, key)
        })
    }

    pub(super) fn earthquake<T: Scalar>(&self) -> Result<Earthquake<T>, Fault> {
        let horizontal: T = self.needed(Key::Horizontal)?;
        let sideways = horizontal.value();
        let vertical = self.scalar(Key::Vertical).unwrap_or_else(|| T::of(0.0));
        let earthquake = Earthquake::new(horizontal, vertical).map_err(|error| {
            let key = if error.value == sideways { Key::Horizontal } else { Key::Vertical };
            Fault::new(Problem::Impossible { key, error }, key)
        })?;
        self.earthquake_across(earthquake)
    }

    pub(super) fn added_mass<T: Scalar>(
        &self,
        body: &Body<T>,
        water: Option<&StillWater<T>>,
        wave: Option<&Waves>,
    ) -> Result<AddedMass<T>, Fault> {
        match (self.scalar::<T>(Key::WaterMass), self.inputs.get(Key::WetSides)) {
            (Some(mass), None) => {
                let water = AddedMass::of(mass).and_then(|water| match self.scalar(Key::WaterElevation) {
                    Some(elevation) => water.at(elevation),
                    None => Ok(water),
                });
                water.map_err(|error| self.blame(Table::AddedMass, error))
            }
            (None, Some(_)) if self.number(Key::WaterElevation).is_some() => {
                let problem = Problem::Both { one: Key::WaterElevation, two: Key::WetSides };
                Err(Fault::new(problem, Key::WaterElevation))
            }
            (None, Some(_)) => {
                let Some((density, depths)) = self.moving_water(water, wave)? else {
                    return Err(Fault::new(Problem::SidesWithoutWater, Key::WetSides));
                };
                let side = body.plan().side(body.width()).value();
                let water = AddedMass::beside(density * side, &depths);
                water.map(AddedMass::computed).map_err(|error| self.blame(Table::AddedMass, error))
            }
            (None, None) => {
                let problem = Problem::Neither { one: Key::WaterMass, two: Key::WetSides };
                Err(Fault::new(problem, Table::AddedMass))
            }
            (Some(_), Some(_)) => {
                let problem = Problem::Both { one: Key::WaterMass, two: Key::WetSides };
                Err(Fault::new(problem, Key::WetSides))
            }
        }
    }

    /// The density of the water beside the body, and its depths on the sides on which it moves with it; `None` where no sides are said, or no
    /// water is.
    pub(super) fn moving_water<T: Scalar>(
        &self,
        water: Option<&StillWater<T>>,
        wave: Option<&Waves>,
    ) -> Result<Option<(f64, Vec<f64>)>, Fault> {
        let Some(sides) = self.inputs.get(Key::WetSides) else { return Ok(None) };
        // The sea, or the water at the right, and the water at the left.
        let depths = match (water, wave) {
            (Some(water), _) => {
                Some((water.density().value(), [water.right(), water.left()].map(|level| level.value())))
            }
            (None, Some(wave)) => wave.still_water().map(|level| (wave.water_density, [level; 2])),
            (None, None) => None,
        };
        let Some((density, depths)) = depths else { return Ok(None) };
        Ok(Some((density, self.wet(sides, depths)?)))
    }

    /// The depths of the water on the sides on which it moves with the body; `depths` are those at the right and at the left.
    fn wet(&self, sides: &Value, [right, left]: [f64; 2]) -> Result<Vec<f64>, Fault> {
        let dry = |side| Err(Fault::new(Problem::DrySide { side }, Key::WetSides));
        let is_filled = |side| self.is_filled(side);
        let filled = match sides {
            Value::Choice("both") | Value::Number(2.0) => {
                ["right", "left"].into_iter().find(|side| is_filled(side))
            }
            Value::Choice(side) => Some(*side).filter(|side| is_filled(side)),
            _ => None,
        };
        if let Some(side) = filled {
            return Err(Fault::new(Problem::FilledSide { side }, Key::WetSides));
        }
        match sides {
            // Beside soil there is no free water.
            Value::Number(1.0) if is_filled("right") && is_filled("left") => {
                Err(Fault::new(Problem::FilledSide { side: "right" }, Key::WetSides))
            }
            Value::Number(1.0) if is_filled("right") => Ok(vec![left]),
            Value::Number(1.0) if is_filled("left") => Ok(vec![right]),
            Value::Choice("right") if right == 0.0 => dry("right"),
            Value::Choice("left") if left == 0.0 => dry("left"),
            Value::Choice("both") if right == 0.0 => dry("right"),
            Value::Choice("both") if left == 0.0 => dry("left"),
            Value::Choice("right") => Ok(vec![right]),
            Value::Choice("left") => Ok(vec![left]),
            // So many sides, as long as it is plain which.
            Value::Number(1.0) if right > 0.0 && left > 0.0 && right != left => {
                Err(Fault::new(Problem::WhichSide { right, left }, Key::WetSides))
            }
            Value::Number(1.0) => Ok(vec![right.max(left)]),
            _ => Ok(vec![right, left]),
        }
    }

    /// True if soil stands beside a side of the body.
    fn is_filled(&self, side: &str) -> bool {
        let mut fills =
            (0..self.inputs.count(Table::Backfill)).map(|index| Id::new(Key::BackfillFace, index));
        fills.any(|face| self.inputs.choice(face) == Some(side))
    }

    /// The key that says how wide the base is.
    pub(super) fn base_key(&self) -> Key {
        let keys = [Key::BaseLeft, Key::BaseRight];
        keys.into_iter().find(|key| self.number(*key).is_some()).unwrap_or(Key::Width)
    }
}

/// Check that every number of inputs is in the range of its key.
///
/// # Errors
/// If one is not.
pub fn check_ranges(inputs: &Inputs) -> Result<(), Fault> {
    Reader { inputs }.ranges()
}

/// The body of inputs, in floating point; `None` if there is none such.
pub(crate) fn body_of(inputs: &Inputs) -> Option<Body> {
    Reader { inputs }.body::<f64>().ok().map(|(body, _)| body)
}

/// Refusal of the case of inputs by the motion, at the number that brings it about.
pub(crate) fn motion_fault(inputs: &Inputs, error: MotionError) -> Fault {
    Reader { inputs }.motion_refused(error)
}

/// Refusal of the case of inputs by the mechanics, at the number that brings it about.
pub fn blamed(inputs: &Inputs, error: InputError) -> Fault {
    Reader { inputs }.blame(Table::Top, error)
}

/// Two keys that have to agree and do not.
fn disagree((one, one_value): (Key, f64), (two, two_value): (Key, f64)) -> Fault {
    Fault::new(Problem::Disagree { one, one_value, two, two_value }, one).and(two)
}
