//! A case: one body and the loads on it, from typed [`Inputs`] that go together.
//!
//! ```
//! use standfast_cases::{Acting, CaseFile};
//!
//! let text = r#"
//! [body]
//! width = "15 m"
//! height = "12 m"
//! density = "2.1 t/m3"
//! friction = 0.6
//!
//! [[load]]
//! force = "450 kN/m"
//! elevation = "8 m"
//! "#;
//! let case = CaseFile::parse("case.toml", text)?.case()?;
//! assert_eq!(case.body.mass(), 378_000.0);
//! assert_eq!(case.forces[0].magnitude, 450_000.0);
//! let outcome = case.situation(Acting::Alone(0), None)?.outcome()?;
//! assert_eq!(outcome.full.mode, Some(standfast::Mode::Rest));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing here reads text, so that a case may be varied millions of times.

mod loads;

use standfast::loads::{Action, AddedMass, Earthquake, Load, LoadKind, LoadSource, StillWater, Uplift};
use standfast::wave::{Choices, Goda, Heights, Sea, Section, goda};
use standfast::{Body, InputError, Situation};

pub use loads::{Combination, Direction, FacePressure, PointForce};

use crate::criteria::Criterion;
use crate::error::{Fault, Place, Problem};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};

/// How far lengths that have to be equal may differ, m.
const SAME_LENGTH: f64 = 1e-6;

/// How far densities that have to be equal may differ, kg/m³.
const SAME_DENSITY: f64 = 1e-6;

/// A case: one body and the loads on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// What the case is called.
    pub title: Option<String>,
    /// Where its numbers come from.
    pub note: Option<String>,
    /// Acceleration of gravity, m/s².
    pub gravity: f64,
    /// The body.
    pub body: Body,
    /// Coulomb friction μ between body and base, to stick.
    pub friction: f64,
    /// Coulomb friction μ to slip.
    pub kinetic_friction: f64,
    /// How water takes part in the weight.
    pub weight: Weight,
    /// Still water.
    pub water: Option<StillWater>,
    /// Pressures under the base.
    pub uplift: Option<Uplift>,
    /// Acceleration of the base, as given.
    pub earthquake: Option<Earthquake>,
    /// Whether it may be to the other side as well.
    pub both_sides: bool,
    /// Whether it may be downwards as well as upwards.
    pub both_ways: bool,
    /// Waves.
    pub wave: Option<Waves>,
    /// Water that a horizontal motion carries along.
    pub added_mass: AddedMass,
    /// Pressures along faces.
    pub pressures: Vec<FacePressure>,
    /// Forces.
    pub forces: Vec<PointForce>,
    /// Which loads act together, times which factors.
    pub combinations: Vec<Combination>,
    /// What is asked of the results.
    pub criteria: Vec<Criterion>,
}

/// Which of a case's loads act in a situation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Acting {
    /// All: the case leaves no choice.
    All,
    /// Of the forces that act alone this one, by its place, beside all other loads.
    Alone(usize),
    /// Those of a combination, by its place, times its factors.
    Combination(usize),
}

/// What the weight of the body stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight {
    /// m g; water under the base is a load of its own.
    Total,
    /// W', from which buoyancy is taken off already.
    Buoyant {
        /// W', N per metre run.
        force: f64,
        /// Its arm to O, m.
        arm: f64,
    },
}

/// Waves from the right, and what they amount to by Goda's formulas.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves {
    /// The sea.
    pub sea: Sea,
    /// The wave heights as they are given.
    pub heights: Heights,
    /// The caisson and its berm.
    pub section: Section,
    /// The choices in the formulas.
    pub choices: Choices,
    /// The pressures, forces and moments.
    pub goda: Goda,
}

impl Case {
    /// The case of inputs.
    ///
    /// # Errors
    /// If a value is missing, out of its range, or does not go with the others.
    pub fn of(inputs: &Inputs) -> Result<Case, Fault> {
        let given = Given { inputs };
        given.ranges()?;
        if !inputs.has(Table::Body) {
            return Err(Fault::new(Problem::MissingTable { table: Table::Body }, Table::Top));
        }
        let gravity = inputs.gravity();
        let body = given.body()?;
        let friction = given.required(Key::Friction)?;
        let kinetic_friction = given.kinetic_friction(friction)?;
        let weight = given.weight(&body)?;
        let wave = given.in_table(Table::Wave, |given| given.waves(&body, gravity))?;
        let water = match (inputs.has(Table::Water), weight, &wave) {
            (true, Weight::Buoyant { .. }, _) => return Err(Fault::new(Problem::WaterTwice, Table::Water)),
            (false, Weight::Total, Some(_)) => return Err(Fault::new(Problem::NoWater, Table::Wave)),
            (true, Weight::Total, wave) => Some(given.water(&body, wave.as_ref())?),
            (false, _, _) => None,
        };
        let uplift = given.in_table(Table::Uplift, Given::uplift)?;
        let earthquake = given.in_table(Table::Earthquake, Given::earthquake)?;
        let added_mass =
            given.in_table(Table::AddedMass, |given| given.added_mass(water.as_ref(), wave.as_ref()))?;
        const OTHER_LOADS: [Table; 5] =
            [Table::Water, Table::Uplift, Table::Earthquake, Table::Wave, Table::Pressure];
        if !inputs.has(Table::Load) && !OTHER_LOADS.iter().any(|table| inputs.has(*table)) {
            return Err(Fault::new(Problem::MissingTable { table: Table::Load }, Table::Top));
        }
        let every = |table| 0..inputs.count(table);
        let forces: Vec<_> =
            every(Table::Load).map(|index| given.force(index, &body)).collect::<Result<_, _>>()?;
        let pressures: Vec<_> =
            every(Table::Pressure).map(|index| given.pressure(index, &body)).collect::<Result<_, _>>()?;
        let combinations =
            every(Table::Combination).map(|index| given.combination(index, &forces, &pressures));
        let combinations = combinations.collect::<Result<_, _>>()?;
        let case = Case {
            title: inputs.text(Key::Title).map(str::to_owned),
            note: inputs.text(Key::Note).map(str::to_owned),
            gravity,
            body,
            friction,
            kinetic_friction,
            weight,
            water,
            uplift,
            earthquake,
            both_sides: !inputs.truth(Key::HorizontalFixed).unwrap_or(false),
            both_ways: !inputs.truth(Key::VerticalFixed).unwrap_or(false),
            wave,
            added_mass: added_mass.unwrap_or(AddedMass::NONE),
            pressures,
            forces,
            combinations,
            criteria: Criterion::all(inputs),
        };
        case.bare().map_err(|error| given.blame(Table::Body, error))?;
        Ok(case)
    }

    /// Which loads act together: in each combination; or else beside each force that acts alone; or else all.
    pub fn acting(&self) -> Vec<Acting> {
        if !self.combinations.is_empty() {
            return (0..self.combinations.len()).map(Acting::Combination).collect();
        }
        let alone = self.forces.iter().enumerate().filter(|(_, force)| force.acts_alone());
        let alone: Vec<_> = alone.map(|(index, _)| Acting::Alone(index)).collect();
        if alone.is_empty() { vec![Acting::All] } else { alone }
    }

    /// The accelerations of the base that are tried: as given, and unless that is fixed to the other side, and down for up.
    pub fn earthquakes(&self) -> Vec<Earthquake> {
        let Some(given) = self.earthquake else { return Vec::new() };
        let signs = |both: bool, value: f64| if both && value != 0.0 { &[1.0, -1.0][..] } else { &[1.0] };
        let (sides, ways) =
            (signs(self.both_sides, given.horizontal()), signs(self.both_ways, given.vertical()));
        let turned = sides.iter().flat_map(|side| ways.iter().map(move |way| given.turned(*side, *way)));
        turned.collect()
    }

    /// The body under the loads that act, the base shaken in one of the ways that are tried or else as given.
    ///
    /// # Errors
    /// If the numbers of a changed case are out of range.
    ///
    /// # Panics
    /// If there is no such force or combination.
    pub fn situation(&self, acting: Acting, earthquake: Option<Earthquake>) -> Result<Situation, InputError> {
        let mut situation = self.bare()?;
        for (of, load) in self.loads(earthquake.or(self.earthquake)) {
            let factor = match (acting, of) {
                (Acting::Combination(index), of) => self.factor(&self.combinations[index], of, &load),
                (Acting::Alone(alone), Of::Force(index))
                    if index != alone && self.forces[index].acts_alone() =>
                {
                    0.0
                }
                _ => 1.0,
            };
            if factor != 0.0 {
                situation = situation.with(load.times(factor));
            }
        }
        Ok(situation)
    }

    /// The body without loads.
    fn bare(&self) -> Result<Situation, InputError> {
        Situation::new(self.body, self.friction, self.gravity)?
            .with_kinetic_friction(self.kinetic_friction)?
            .with_added_mass(self.added_mass.mass())
    }

    /// All loads of the case, and what each is of.
    fn loads(&self, earthquake: Option<Earthquake>) -> Vec<(Of, Load)> {
        let weight = match self.weight {
            Weight::Total => Load::permanent(LoadSource::Weight, LoadKind::Weight, Action::Weight),
            Weight::Buoyant { force, arm } => {
                let action = Action::vertical(&self.body, force, arm);
                Load::permanent(LoadSource::BuoyantWeight, LoadKind::Weight, action)
            }
        };
        let mut loads = vec![(Of::Named("weight"), weight)];
        let mut add = |of, more: Vec<Load>| loads.extend(more.into_iter().map(|load| (of, load)));
        if let Some(water) = &self.water {
            add(Of::Named("water"), water.loads(&self.body, self.gravity));
        }
        if let Some(uplift) = &self.uplift {
            add(Of::Named("uplift"), vec![uplift.load(&self.body)]);
        }
        if let Some(earthquake) = earthquake {
            add(Of::Named("earthquake"), earthquake.loads(&self.added_mass));
        }
        if let Some(Waves { goda, section, .. }) = &self.wave {
            add(Of::Named("wave"), goda.loads(&self.body, section.base_depth).into());
        }
        for (index, pressure) in self.pressures.iter().enumerate() {
            add(Of::Pressure(index), vec![pressure.load()]);
        }
        for (index, force) in self.forces.iter().enumerate() {
            add(Of::Force(index), vec![force.load(&self.body)]);
        }
        loads
    }

    /// What a combination multiplies a load by: one that it does not name acts as it is if it is permanent, and else not.
    fn factor(&self, combination: &Combination, of: Of, load: &Load) -> f64 {
        let name = match of {
            Of::Named(name) => Some(name),
            Of::Pressure(index) => self.pressures[index].name.as_deref(),
            Of::Force(index) => self.forces[index].name.as_deref(),
        };
        let named = combination.factors.iter().find(|(named, _)| Some(named.as_str()) == name);
        named.map_or(if load.permanent { 1.0 } else { 0.0 }, |(_, factor)| *factor)
    }

    /// What a situation is called: its force that acts alone or its combination, or the number of it, counted from one.
    pub fn acting_name(&self, acting: Acting) -> Option<String> {
        match acting {
            Acting::All => None,
            Acting::Alone(index) => {
                Some(self.forces[index].name.clone().unwrap_or_else(|| format!("load {}", index + 1)))
            }
            Acting::Combination(index) => {
                let name = &self.combinations[index].name;
                Some(name.clone().unwrap_or_else(|| format!("combination {}", index + 1)))
            }
        }
    }
}

/// What a load is of: what a combination calls it by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Of {
    /// A table of the case, under this name.
    Named(&'static str),
    /// A pressure, by its place.
    Pressure(usize),
    /// A force, by its place.
    Force(usize),
}

/// Inputs, read with what goes wrong.
#[derive(Clone, Copy)]
struct Given<'a> {
    inputs: &'a Inputs,
}

impl Given<'_> {
    /// Every number is in the range of its key.
    fn ranges(&self) -> Result<(), Fault> {
        for (id, number) in self.inputs.numbers() {
            let key = id.key;
            if let Some(range) = key.info().range().filter(|range| !range.contains(number)) {
                return Err(Fault::new(Problem::out_of_range(key, range, number), id));
            }
        }
        Ok(())
    }

    fn number(&self, key: Key) -> Option<f64> {
        self.inputs.number(key)
    }

    fn required(&self, key: Key) -> Result<f64, Fault> {
        self.number(key).ok_or_else(|| self.missing(key, 0))
    }

    fn missing(&self, key: Key, index: usize) -> Fault {
        Fault::new(Problem::MissingKey { key }, Place::Table(key.info().table, index))
    }

    /// What a table says, if there is one.
    fn in_table<T>(
        &self,
        table: Table,
        read: impl FnOnce(&Self) -> Result<T, Fault>,
    ) -> Result<Option<T>, Fault> {
        self.inputs.has(table).then(|| read(self)).transpose()
    }

    /// What the library refuses, shown at the key of a table that gives the quantity, or at the number that is too large.
    fn blame(&self, table: Table, error: InputError) -> Fault {
        self.blame_one_of(table.keys(), 0, error)
            .unwrap_or_else(|| Fault::new(Problem::Mechanics(error), table))
    }

    fn blame_one_of(
        &self,
        mut keys: impl Iterator<Item = Key>,
        index: usize,
        error: InputError,
    ) -> Option<Fault> {
        let gives = |key: Key| key.info().gives.contains(&error.quantity);
        let key = keys.find(|key| gives(*key) && self.inputs.get(Id { index, key: *key }).is_some());
        let id = key.map(|key| Id { index, key });
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

    fn body(&self) -> Result<Body, Fault> {
        let (width, height) = (self.required(Key::Width)?, self.required(Key::Height)?);
        let body = match (self.number(Key::Mass), self.number(Key::Density)) {
            (Some(_), Some(_)) => {
                let problem = Problem::Both { one: Key::Mass, two: Key::Density };
                return Err(Fault::new(problem, Key::Density));
            }
            (None, None) => {
                let problem = Problem::Neither { one: Key::Mass, two: Key::Density };
                return Err(Fault::new(problem, Table::Body));
            }
            (Some(mass), None) => Body::new(width, height, mass),
            (None, Some(density)) => Body::of_density(width, height, density),
        };
        let half = width / 2.0;
        let shaped = body.and_then(|body| {
            let left = self.number(Key::BaseLeft).unwrap_or(half);
            let right = self.number(Key::BaseRight).unwrap_or(half);
            let offset = self.number(Key::CentroidOffset).unwrap_or(0.0);
            let height = self.number(Key::CentroidHeight).unwrap_or(body.centroid_height());
            let body = body.with_base(left, right)?.with_centroid(offset, height)?;
            match self.number(Key::MomentOfInertia) {
                Some(moment) => body.with_moment_of_inertia(moment),
                None => Ok(body),
            }
        });
        shaped.map_err(|error| self.blame(Table::Body, error))
    }

    fn kinetic_friction(&self, friction: f64) -> Result<f64, Fault> {
        let kinetic = self.number(Key::KineticFriction).unwrap_or(friction);
        if kinetic > friction {
            return Err(Fault::new(Problem::KineticFriction { kinetic, friction }, Key::KineticFriction));
        }
        Ok(kinetic)
    }

    fn weight(&self, body: &Body) -> Result<Weight, Fault> {
        match (self.number(Key::BuoyantWeight), self.number(Key::WeightArm)) {
            (Some(force), arm) => Ok(Weight::Buoyant { force, arm: arm.unwrap_or(body.heel_distance()) }),
            (None, None) => Ok(Weight::Total),
            (None, Some(_)) => Err(Fault::new(Problem::ArmWithoutWeight, Key::WeightArm)),
        }
    }

    fn water(&self, body: &Body, wave: Option<&Waves>) -> Result<StillWater, Fault> {
        let sides = (self.number(Key::Level), self.number(Key::WaterLeft), self.number(Key::WaterRight));
        let (left, right) = match sides {
            (Some(level), None, None) => (level, level),
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
        let of_wave = wave.map(|wave| wave.sea.water_density);
        let density = match (self.number(Key::WaterDensity), of_wave) {
            (Some(density), Some(of_wave)) if (density - of_wave).abs() > SAME_DENSITY => {
                return Err(disagree((Key::WaterDensity, density), (Key::WaveWaterDensity, of_wave)));
            }
            (Some(density), _) | (None, Some(density)) => density,
            (None, None) => return Err(Fault::new(Problem::NoWaterDensity, Table::Water)),
        };
        let right_key = if self.number(Key::Level).is_some() { Key::Level } else { Key::WaterRight };
        let water = StillWater::new(body, left, right, density).map_err(|error| {
            let left_is_it = error.value == left && self.number(Key::WaterLeft).is_some();
            let key = if left_is_it { Key::WaterLeft } else { right_key };
            let blamed = [key, Key::WaterDensity].into_iter();
            let fault = self.blame_one_of(blamed, 0, error);
            fault.unwrap_or_else(|| Fault::new(Problem::Mechanics(error), Table::Water))
        })?;
        match wave.map(|wave| wave.section.base_depth) {
            Some(depth) if (depth - right).abs() > SAME_LENGTH => {
                Err(disagree((right_key, right), (Key::BaseDepth, depth)))
            }
            _ => Ok(water),
        }
    }

    fn uplift(&self) -> Result<Uplift, Fault> {
        let (left, right) = (self.required(Key::UpliftLeft)?, self.required(Key::UpliftRight)?);
        let grows = self.inputs.truth(Key::UpliftGrows).unwrap_or(false);
        Uplift::new(left, right, grows).map_err(|error| {
            let key = if error.value == left { Key::UpliftLeft } else { Key::UpliftRight };
            Fault::new(Problem::Impossible { key, error }, key)
        })
    }

    fn earthquake(&self) -> Result<Earthquake, Fault> {
        let horizontal = self.required(Key::Horizontal)?;
        let vertical = self.number(Key::Vertical).unwrap_or(0.0);
        Earthquake::new(horizontal, vertical).map_err(|error| {
            let key = if error.value == horizontal { Key::Horizontal } else { Key::Vertical };
            Fault::new(Problem::Impossible { key, error }, key)
        })
    }

    fn added_mass(&self, water: Option<&StillWater>, wave: Option<&Waves>) -> Result<AddedMass, Fault> {
        // The sea, or the water at the right, and the water at the left.
        let depths = match (water, wave) {
            (Some(water), _) => Some((water.density(), [water.right(), water.left()])),
            (None, Some(Waves { sea, section, .. })) => Some((sea.water_density, [section.base_depth; 2])),
            (None, None) => None,
        };
        match (self.number(Key::WaterMass), self.number(Key::WetSides), depths) {
            (Some(mass), None, _) => AddedMass::of(mass).map_err(|error| self.blame(Table::AddedMass, error)),
            (None, Some(sides), Some((density, depths))) => {
                let depths = if sides == 1.0 { &depths[..1] } else { &depths };
                AddedMass::beside(density, depths).map_err(|error| self.blame(Table::AddedMass, error))
            }
            (None, Some(_), None) => Err(Fault::new(Problem::SidesWithoutWater, Key::WetSides)),
            (None, None, _) => {
                let problem = Problem::Neither { one: Key::WaterMass, two: Key::WetSides };
                Err(Fault::new(problem, Table::AddedMass))
            }
            (Some(_), Some(_), _) => {
                let problem = Problem::Both { one: Key::WaterMass, two: Key::WetSides };
                Err(Fault::new(problem, Key::WetSides))
            }
        }
    }

    fn waves(&self, body: &Body, gravity: f64) -> Result<Waves, Fault> {
        let sea = Sea {
            water_depth: self.required(Key::WaterDepth)?,
            sea_bottom_slope: self.required(Key::SeaBottomSlope)?,
            period: self.required(Key::Period)?,
            angle_deg: self.required(Key::AngleDeg)?,
            water_density: self.required(Key::WaveWaterDensity)?,
            gravity,
        };
        let heights = self.heights()?;
        let caisson_width = body.base_width();
        let given_width = self.number(Key::CaissonWidth);
        if let Some(width) = given_width.filter(|width| (width - caisson_width).abs() > SAME_LENGTH) {
            let problem = Problem::CaissonWidth { width, base: caisson_width };
            return Err(Fault::new(problem, Key::CaissonWidth).and(self.base_key()));
        }
        let section = Section {
            base_depth: self.required(Key::BaseDepth)?,
            depth_above_berm: self.required(Key::DepthAboveBerm)?,
            crest_height: self.required(Key::CrestHeight)?,
            berm_width: self.required(Key::BermWidth)?,
            caisson_width,
        };
        let default = Choices::default();
        let factor = |key, default| self.number(key).unwrap_or(default);
        let choices = Choices {
            lambda: [
                factor(Key::Lambda1, default.lambda[0]),
                factor(Key::Lambda2, default.lambda[1]),
                factor(Key::Lambda3, default.lambda[2]),
            ],
            impulsive: self.inputs.truth(Key::Impulsive).unwrap_or(default.impulsive),
            turn_deg: factor(Key::TurnDeg, default.turn_deg),
            uplift: self.inputs.truth(Key::WaveUplift).unwrap_or(default.uplift),
        };
        let goda =
            goda(&sea, &heights, &section, &choices).map_err(|error| self.blame(Table::Wave, error))?;
        let Section { base_depth, crest_height, .. } = section;
        if (base_depth + crest_height - body.height()).abs() > SAME_LENGTH {
            let problem = Problem::Height { base_depth, crest_height, height: body.height() };
            return Err(Fault::new(problem, Key::CrestHeight).and(Key::Height));
        }
        Ok(Waves { sea, heights, section, choices, goda })
    }

    /// The key that says how wide the base is.
    fn base_key(&self) -> Key {
        let keys = [Key::BaseLeft, Key::BaseRight];
        keys.into_iter().find(|key| self.number(*key).is_some()).unwrap_or(Key::Width)
    }

    fn heights(&self) -> Result<Heights, Fault> {
        let one = |missing, at: Key| Err(Fault::new(Problem::OneWaveHeight { missing }, at));
        match (self.number(Key::DeepWaterHeight), self.number(Key::H13), self.number(Key::Hmax)) {
            (Some(height), None, None) => Ok(Heights::DeepWater(height)),
            (None, Some(significant), Some(maximum)) => Ok(Heights::Local { significant, maximum }),
            (Some(_), _, _) => Err(Fault::new(Problem::DeepAndLocal, Key::DeepWaterHeight)),
            (None, None, None) => Err(Fault::new(Problem::NoWaveHeight, Table::Wave)),
            (None, Some(_), None) => one(Key::Hmax, Key::H13),
            (None, None, Some(_)) => one(Key::H13, Key::Hmax),
        }
    }
}

/// What the mechanics refuses of the case of inputs, at the number that brings it about.
pub(crate) fn fault(inputs: &Inputs, error: InputError) -> Fault {
    Given { inputs }.blame(Table::Top, error)
}

/// Two keys that have to agree and do not.
fn disagree((one, one_value): (Key, f64), (two, two_value): (Key, f64)) -> Fault {
    Fault::new(Problem::Disagree { one, one_value, two, two_value }, one).and(two)
}
