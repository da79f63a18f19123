//! A case: one body and the loads on it, from typed [`Inputs`] that go together.
//!
//! ```
//! use standfast_model::case::Trial;
//! use standfast_model::{Acting, CaseFile};
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
//! let outcome = case.situation(Acting::Alone(0), Trial::AS_GIVEN)?.outcome()?;
//! assert_eq!(outcome.full.mode(), Some(standfast::Mode::Rest));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Nothing here reads text, so that a case may be varied millions of times.

mod backfill;
mod bias;
mod code;
mod combination;
mod ground;
mod history;
mod joint;
mod loads;
mod motion;
mod office;
mod plan;
mod reader;
mod resistance;
mod section;
mod waves;

use std::sync::Arc;

use standfast::contact::holding::Adhesion;
use standfast::contact::opening::Drain;
use standfast::loads::{
    Action, AddedMass, BodyPoint, Earthquake, Face, Load, LoadId, LoadKind, LoadSource, StillWater, Uplift,
};
use standfast::section::{Part, Section, Vertex, WaterTable};
use standfast::{Ball, Body, InputError, OpeningRule, Scalar, Situation, Wrench};

pub(crate) use backfill::tables_of_layers;
pub use backfill::{Made, SoilFill, soil_of};
pub use bias::{Bias, Biases, biased};
pub use code::Code;
pub use combination::{ChangeBy, Combination, InputChange, Shaking, Trial};
pub use ground::{COUPLING, Foundation, Limit, T_H, T_M};
pub(crate) use history::HistoryOf;
pub use history::{course, history_shapes};
pub use joint::{BASE, CaseJoint, JointWater, called};
pub use loads::{Direction, FacePressure, PointForce};
pub(crate) use loads::{SLACK, ends};
pub use motion::CaseMotion;
pub use plan::{CasePlan, PlanOf, Turned};
pub(crate) use reader::{Reader, body_of, motion_fault};
pub use reader::{blamed, check_ranges};
pub use resistance::Resistance;
use section::OF_BLOCK;
pub use section::OF_PARTS;
pub use waves::{CrownWall, CrownWaves, GodaWaves, StandingWaves, WaveFormula, Waves, goes_with_waves};

use crate::criteria::Criterion;
use crate::error::{Fault, Place, Problem};
use crate::inputs::{GRAVITY, Inputs, LoadFactor};
use crate::key::{Key, Table};
use crate::units::Extent;
use standfast_inputs::OutputUnits;

/// A case: one body and the loads on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Case<T = f64> {
    /// Title of the case.
    pub title: Option<String>,
    /// Note on the source of its numbers.
    pub note: Option<String>,
    /// Acceleration of gravity, m/s².
    pub gravity: T,
    /// Extent of forces, masses and moments: a metre run or the whole body.
    pub extent: Extent,
    /// Units and digits in which its answers are written.
    pub output: OutputUnits,
    /// The body.
    pub body: Body<T>,
    /// Rise of the floor to the right, degrees; loads are those of a level one, and a situation has them in the frame of the base.
    pub floor_deg: f64,
    /// Its section, where it is made of parts.
    pub section: Option<Section>,
    /// Under which line they are wet.
    pub water_table: Option<WaterTable>,
    /// The names of its parts.
    pub part_names: Vec<Option<String>>,
    /// The groups of its parts.
    pub part_groups: Vec<Option<String>>,
    /// The joints above its base, from there up.
    pub joints: Vec<CaseJoint<T>>,
    /// Its base seen from above, where loads may come from any direction.
    pub plan: Option<CasePlan<T>>,
    /// Coulomb friction μ between body and base, to stick.
    pub friction: T,
    /// Coulomb friction μ to slip.
    pub kinetic_friction: T,
    /// Strength and stiffness of the base; `None` of one that is rigid.
    pub ground: Option<Foundation>,
    /// Part that water takes in the weight.
    pub weight: Weight<T>,
    /// Still water.
    pub water: Option<StillWater<T>>,
    /// Loads that still water follows into a base that opens; `None` where it follows none.
    pub opening: Option<OpeningRule>,
    /// Drains under the base, lengths in m.
    pub drain: Option<Drain>,
    /// Pressures under the base.
    pub uplift: Option<Uplift<T>>,
    /// Acceleration of the base, as given.
    pub earthquake: Option<Earthquake<T>>,
    /// True if it may be to the other side as well.
    pub both_sides: bool,
    /// True if it may be downwards as well as upwards.
    pub both_ways: bool,
    /// Waves.
    pub wave: Option<Waves>,
    /// Water that a horizontal motion carries along.
    pub added_mass: AddedMass<T>,
    /// Pressures along faces.
    pub pressures: Vec<FacePressure<T>>,
    /// Soil beside it.
    pub soils: Vec<SoilFill>,
    /// Forces, and couples behind them.
    pub forces: Vec<PointForce<T>>,
    /// Adhesion to the base, Pa.
    pub adhesion: Option<Adhesion>,
    /// Forces with a limit that hold it.
    pub resistances: Vec<Resistance>,
    /// Factors between what formulas give and what acts; no file says them, but draws and tables do.
    pub biases: Biases,
    /// Loads that act together, and their factors.
    pub combinations: Vec<Combination>,
    /// Criteria on the results.
    pub criteria: Vec<Criterion>,
    /// Its motion in time; `None` of one at rest, and of one whose histories are those of loads on springs.
    pub motion: Option<CaseMotion>,
    /// The cases of those combinations that change something, by their places.
    pub(crate) changed: Vec<Option<Arc<Case<T>>>>,
    /// Inputs it was made of, whose decimals decide where f64 cannot.
    pub(crate) inputs: Arc<Inputs>,
}

/// Loads of a case that act in a situation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Acting {
    /// All: the case leaves no choice.
    All,
    /// Of the forces that act alone this one, by its place, beside all other loads.
    Alone(usize),
    /// Those of a combination, by its place, times its factors.
    Combination(usize),
}

/// Meaning of the weight of the body: with or without buoyancy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight<T = f64> {
    /// m g; water under the base is a load of its own.
    Total,
    /// W', from which buoyancy is taken off already: that is a load of its own, too, the difference from m g.
    Buoyant {
        /// W', N per metre run.
        force: T,
        /// Its arm to O, m.
        arm: T,
    },
}

impl Case {
    /// The case of inputs.
    ///
    /// # Errors
    /// If a value is missing, out of its range, or does not go with the others.
    pub fn of(inputs: &Inputs) -> Result<Case, Fault> {
        Case::sharing(Arc::new(inputs.clone()))
    }

    /// The case of inputs that are shared.
    pub fn sharing(inputs: Arc<Inputs>) -> Result<Case, Fault> {
        let mut case = Case::in_scalars(inputs)?;
        case.changed = case.combined()?;
        case.criteria_fit_plan()?;
        case.no_torsion()?;
        Ok(case)
    }

    /// A [situation](Case::situation) in one of the ways in which it is [tried](Case::trials), decided by the numbers as they are written
    /// where f64 could put it on the other side of a boundary.
    ///
    /// # Errors
    /// If the numbers of a changed case are out of range.
    pub fn decided(&self, acting: Acting, trial: Trial) -> Result<Situation, InputError> {
        let situation = self.situation(acting, trial)?;
        Ok(if situation.is_near_boundary() { self.as_written(situation, acting, trial) } else { situation })
    }

    /// The body under the loads that act, in one of the ways in which they are tried.
    ///
    /// # Errors
    /// If the numbers of a changed case are out of range.
    ///
    /// # Panics
    /// If there is no such force or combination.
    pub fn situation(&self, acting: Acting, trial: Trial) -> Result<Situation, InputError> {
        let situation = self.loaded(acting, trial)?;
        let case = self.under(acting);
        let situation = match (case.opening, case.drain) {
            (Some(rule), drain) => situation.with_opening(rule, drain),
            (None, Some(drain)) => situation.with_drain(drain),
            (None, None) => situation,
        };
        let situation = situation.with_holding(case.holding());
        let loads = case.loads_tried(acting, trial);
        Ok(match self.effects(&situation, loads, acting, trial) {
            Some(effects) => situation.with_effects(effects),
            None => situation,
        })
    }

    /// The sum of the loads of a situation times the factors of its combination, where these act on effects; `loads` are all that may act.
    fn effects(
        &self,
        situation: &Situation,
        loads: Vec<(LoadOrigin, Load)>,
        acting: Acting,
        trial: Trial,
    ) -> Option<Wrench> {
        let Acting::Combination(index) = acting else { return None };
        let combination = self.combinations.get(index).filter(|combination| combination.effects)?;
        let case = self.under(acting);
        let factors = loads.into_iter().map(|(of, load)| case.factor(combination, of, &load, trial));
        let factors = factors.filter(|factor| *factor != 0.0);
        let sums = situation.loads().iter().zip(factors);
        Some(sums.map(|(load, factor)| situation.wrench_of(load) * factor).sum())
    }

    /// The situation decided by the numbers as they are written.
    pub fn as_written(&self, situation: Situation, acting: Acting, trial: Trial) -> Situation {
        match self.written(acting).and_then(|written| written.loaded(acting, trial).ok()) {
            Some(written) => situation.as_written(&written),
            None => situation,
        }
    }

    /// The case of a situation in the numbers as they are written.
    fn written(&self, acting: Acting) -> Option<Case<Ball>> {
        let written = Case::<Ball>::in_scalars(Arc::clone(&self.under(acting).inputs)).ok();
        written.and_then(|case| case.biased(self.biases).ok())
    }

    /// Its waves by Goda's formulas; `None` without any, and of those by another formula.
    pub fn goda(&self) -> Option<&GodaWaves> {
        self.wave.as_ref()?.goda()
    }

    /// The case with other waves by Goda's formulas.
    pub fn with_goda(&self, waves: GodaWaves) -> Case {
        let wave = self.wave.clone().map(|wave| Waves { formula: WaveFormula::Goda(waves), ..wave });
        Case { wave, ..self.clone() }
    }

    /// True if still water stands under its base at different heads and follows an opening.
    pub fn follows_opening(&self) -> bool {
        self.opening.is_some() && self.water.is_some_and(|water| water.left() != water.right())
    }

    /// Part that water takes in the weight, in words.
    pub fn weight_words(&self) -> &'static str {
        match (self.weight, &self.water) {
            (Weight::Buoyant { .. }, _) => "total weight, and buoyancy as the buoyant weight says",
            (Weight::Total, Some(_)) => "total weight with explicit pressures",
            (Weight::Total, None) => "total weight, no still water",
        }
    }
}

impl<T: Scalar> Case<T> {
    /// The case of inputs in any arithmetic.
    fn in_scalars(shared: Arc<Inputs>) -> Result<Case<T>, Fault> {
        let inputs = &*shared;
        let given = Reader { inputs };
        given.ranges()?;
        let in_place = [Table::Block, Table::Point, Table::Storm].into_iter();
        if let Some(table) = in_place
            .filter(|table| inputs.has(*table))
            .find(|table| *table != Table::Storm || !inputs.has(Table::Body))
        {
            return Err(Fault::new(Problem::NoCase { table }, table));
        }
        given.of_motion()?;
        if !inputs.has(Table::Body) {
            return Err(Fault::new(Problem::MissingTable { table: Table::Body }, Table::Top));
        }
        let gravity = given.scalar(Key::Gravity).unwrap_or_else(|| T::written(GRAVITY));
        let (body, section) = given.body::<T>()?;
        let plan = given.footprint(&body, section.as_ref())?;
        let friction: T = given.needed(Key::Friction)?;
        let kinetic_friction = given.kinetic_friction(friction.clone())?;
        let weight = given.weight(&body, section.as_ref())?;
        let ground = given.in_table(Table::Ground, |given| given.ground(&body.rounded()))?;
        given.answerable(ground.as_ref())?;
        let mut motion = if inputs.is_in_time() { Some(given.motion(HistoryOf::Base)?) } else { None };
        let wave = given
            .in_table(Table::Wave, |given| given.waves(&body.rounded(), gravity.value(), motion.as_mut()))?;
        let water = match (inputs.has(Table::Water), &weight, &wave) {
            (true, Weight::Buoyant { .. }, _) => return Err(Fault::new(Problem::WaterTwice, Table::Water)),
            (false, Weight::Total, Some(_)) if given.sea_stands_beside() => {
                return Err(Fault::new(Problem::NoWater, Table::Wave));
            }
            (true, Weight::Total, wave) => Some(given.water(&body, wave.as_ref())?),
            (false, _, _) => None,
        };
        given.floor(&weight, ground.as_ref())?;
        let opening = given.opening(&body.rounded(), ground.as_ref())?;
        let drain = given.in_table(Table::Drain, |given| given.drain(&body.rounded()))?;
        let uplift = given.in_table(Table::Uplift, Reader::uplift)?;
        let earthquake = given.in_table(Table::Earthquake, Reader::earthquake)?;
        let added_mass = given
            .in_table(Table::AddedMass, |given| given.added_mass(&body, water.as_ref(), wave.as_ref()))?;
        // A body on a base that moves needs no load.
        const OTHER_LOADS: [Table; 8] = [
            Table::Water,
            Table::Uplift,
            Table::Earthquake,
            Table::Wave,
            Table::Pressure,
            Table::Backfill,
            Table::Moment,
            Table::Motion,
        ];
        if !inputs.has(Table::Load) && !OTHER_LOADS.iter().any(|table| inputs.has(*table)) {
            return Err(Fault::new(Problem::MissingTable { table: Table::Load }, Table::Top));
        }
        let every = |table| 0..inputs.count(table);
        let mut forces: Vec<_> = every(Table::Load)
            .map(|index| given.force(index, &body, motion.as_mut()))
            .collect::<Result<_, _>>()?;
        for index in every(Table::Moment) {
            forces.push(given.couple(index)?);
        }
        let pressures: Vec<_> =
            every(Table::Pressure).map(|index| given.pressure(index, &body)).collect::<Result<_, _>>()?;
        let table = given.water_table();
        let unit_weight = water.as_ref().map(|water| water.density().value());
        let unit_weight = unit_weight.or(wave.as_ref().map(|wave| wave.water_density));
        let in_soil = table.zip(unit_weight.map(|density| density * gravity.value()));
        let soils: Vec<_> = every(Table::Backfill)
            .map(|index| given.backfill(index, &body.rounded(), in_soil))
            .collect::<Result<_, _>>()?;
        given.no_made_name(&soils, &forces, &pressures)?;
        let adhesion = given.adhesion(&body.rounded(), ground.as_ref())?;
        let resistances = given.resistances(&body.rounded(), ground.as_ref(), &soils)?;
        let combinations = every(Table::Combination).map(|index| {
            given.combination(index, &body.rounded(), &forces, &pressures, &soils, &resistances)
        });
        let combinations = combinations.collect::<Result<_, _>>()?;
        let case = Case {
            title: inputs.text(Key::Title).map(str::to_owned),
            note: inputs.text(Key::Note).map(str::to_owned),
            gravity,
            extent: inputs.extent(),
            output: inputs.output(),
            body,
            floor_deg: inputs.number(Key::FloorDeg).unwrap_or(0.0),
            section,
            water_table: given.water_table(),
            part_names: given.of_parts(Key::PartName),
            part_groups: given.of_parts(Key::PartGroup),
            joints: Vec::new(),
            plan,
            friction,
            kinetic_friction,
            ground,
            weight,
            water,
            opening,
            drain,
            uplift,
            earthquake,
            both_sides: !inputs.truth(Key::HorizontalFixed).unwrap_or(false),
            both_ways: !inputs.truth(Key::VerticalFixed).unwrap_or(false),
            wave,
            added_mass: match added_mass {
                Some(water) => water,
                None => AddedMass::of(T::of(0.0)).map_err(|error| given.blame(Table::Body, error))?,
            },
            pressures,
            soils,
            forces,
            adhesion,
            resistances,
            biases: Biases::default(),
            combinations,
            criteria: Criterion::all(inputs),
            motion,
            changed: Vec::new(),
            inputs: Arc::clone(&shared),
        };
        case.bare().map_err(|error| given.blame(Table::Body, error))?;
        let case = Case { joints: given.joints(&case)?, ..case };
        given.soils_hold(&case.soils, &case.accelerations(), case.gravity.value())?;
        Ok(case)
    }

    /// The accelerations of the base that are tried, whatever acts: as given, and to the other side and down for up unless that is fixed.
    pub(crate) fn accelerations(&self) -> Vec<Earthquake> {
        let Some(given) = self.earthquake.as_ref().map(Earthquake::rounded) else { return Vec::new() };
        let shaken = self.ways(&given, [false; 3]).into_iter().filter_map(|shaking| self.shaken(shaking));
        shaken.map(|earthquake| earthquake.rounded()).collect()
    }

    /// Ways in which the base is shaken that are tried: to both sides and both up and down, unless one is fixed, or it is zero and not `moved`
    /// from that; seen from above across each edge, where the worst direction is asked for.
    fn ways(&self, given: &Earthquake, moved: [bool; 3]) -> Vec<Shaking> {
        let signs = |both: bool, value: f64, moved: bool| {
            if both && (moved || value != 0.0) { &[1, -1][..] } else { &[1_i8] }
        };
        let ways = signs(self.both_ways, given.vertical(), moved[1]);
        if let Some(edges) = self.edges_to_shake() {
            let across = (0..edges).flat_map(|edge| ways.iter().map(move |way| (edge, *way)));
            return across.map(|(edge, way)| Shaking { signs: [1, way, 1], across: Some(edge) }).collect();
        }
        let along = self.plan.as_ref().is_some_and(|plan| plan.is_one_direction);
        let sideways = if along { given.horizontal().hypot(given.away()) } else { given.horizontal() };
        let sides = signs(self.both_sides, sideways, moved[0] || along && moved[2]);
        // In one direction both components turn together.
        let aways = |side: i8| {
            if along { vec![side] } else { signs(self.both_sides, given.away(), moved[2]).to_vec() }
        };
        let all = sides.iter().flat_map(|side| aways(*side).into_iter().map(move |away| (*side, away)));
        let all = all.flat_map(|(side, away)| ways.iter().map(move |way| [side, *way, away]));
        all.map(|signs| Shaking { signs, across: None }).collect()
    }

    /// The number of edges across which the base is shaken in turn, where the worst of all directions is asked for.
    fn edges_to_shake(&self) -> Option<u16> {
        let plan = self.plan.as_ref().filter(|plan| plan.is_worst)?;
        Some(plan.base.footprint.vertices().len().max(1) as u16)
    }

    /// The acceleration of the base in one of the ways in which it is shaken.
    pub fn shaken(&self, Shaking { signs, across }: Shaking) -> Option<Earthquake<T>> {
        let given = self.earthquake.as_ref()?.turned(signs.map(f64::from));
        let (Some(edge), Some(plan)) = (across, &self.plan) else { return Some(given) };
        Some(plan.shaken_across(usize::from(edge), &given))
    }

    /// The body under the loads that act, the water under its base as if it did not open.
    fn loaded(&self, acting: Acting, trial: Trial) -> Result<Situation<T>, InputError> {
        let case = self.under(acting);
        let loads = self.factored(case.loads_tried(acting, trial), &case.body, acting, trial);
        Ok(case.bare()?.with_all(loads))
    }

    /// Loads of a situation on `body`, its own or what is above a joint, times the factors of their combination; none that these leave out.
    fn factored(
        &self,
        loads: Vec<(LoadOrigin, Load<T>)>,
        body: &Body<T>,
        acting: Acting,
        trial: Trial,
    ) -> Vec<Load<T>> {
        let case = self.under(acting);
        let by_effects = match acting {
            Acting::Combination(index) => self.combinations[index].effects,
            _ => false,
        };
        let acting = loads.into_iter().filter_map(|(of, load)| {
            let factor = match acting {
                Acting::Combination(index) => case.factor_as_written(index, of, &load, trial),
                Acting::All | Acting::Alone(_) => T::of(1.0),
            };
            if factor == T::of(0.0) {
                return None;
            }
            let load = self.biases.on(load, body, case.gravity.clone());
            // Where factors act on effects the load is as it is.
            let factor = if by_effects { T::of(1.0) } else { factor };
            let load = load.times(factor).with_id(of.into());
            Some(match case.floor_deg {
                0.0 => load,
                slope => {
                    let action = load.action.on_slope(body, case.gravity.clone(), slope.to_radians());
                    Load { action, ..load }
                }
            })
        });
        acting.collect()
    }

    /// The body without loads.
    fn bare(&self) -> Result<Situation<T>, InputError> {
        let situation = Situation::new(self.body.clone(), self.friction.clone(), self.gravity.clone())?
            .with_kinetic_friction(self.kinetic_friction.clone())?;
        let situation = situation.with_added_mass(self.added_mass.clone());
        Ok(match &self.plan {
            Some(plan) => situation.with_plan(plan.base.clone()),
            None => situation,
        })
    }

    /// All loads but for alternatives to the one that acts, in one of the ways in which they are tried, and what each is of.
    fn loads_tried(&self, acting: Acting, trial: Trial) -> Vec<(LoadOrigin, Load<T>)> {
        let shaken = trial.shaking.and_then(|shaking| self.shaken(shaking));
        self.loads(acting, shaken.or_else(|| self.earthquake.clone()))
    }

    /// All loads of the case but for alternatives to the one that acts, and what each is of.
    fn loads(&self, acting: Acting, earthquake: Option<Earthquake<T>>) -> Vec<(LoadOrigin, Load<T>)> {
        let mut loads = self.weights(acting, None);
        let mut add = |of, more: Vec<Load<T>>| loads.extend(more.into_iter().map(|load| (of, load)));
        let over_time = |load: Load<T>, history: &Option<standfast::History>| match history {
            Some(history) => load.over_time(history.clone()),
            None => load,
        };
        add(LoadOrigin::Table(Table::Water), self.lift().into_iter().collect());
        if let Some(water) = &self.water {
            let loads = water
                .loads(&self.body, self.gravity.clone())
                .into_iter()
                .map(|load| self.at_mid_length(load));
            add(LoadOrigin::Table(Table::Water), loads.collect());
            if let Some(section) = &self.section {
                let (body, gravity) = (self.body.rounded(), self.gravity.value());
                let on_sides = section.water_on_sides(&body, &water.rounded(), gravity).into_iter();
                add(LoadOrigin::Table(Table::Water), on_sides.map(Load::computed).collect());
            }
        }
        if let Some(uplift) = &self.uplift {
            add(LoadOrigin::Table(Table::Uplift), vec![uplift.load(&self.body)]);
        }
        let shaken = earthquake.as_ref().map(Earthquake::rounded);
        if let Some(earthquake) = earthquake {
            let of_base = earthquake.loads(&self.added_mass).into_iter().map(Load::fast);
            add(LoadOrigin::Table(Table::Earthquake), of_base.collect());
        }
        if let Some(wave) = &self.wave {
            let waves = wave.loads(&self.body.rounded()).into_iter().map(Load::computed);
            let waves = waves.map(|load| over_time(load, &wave.history).fast());
            add(LoadOrigin::Table(Table::Wave), waves.collect());
        }
        for (index, pressure) in self.pressures.iter().enumerate() {
            add(LoadOrigin::Pressure(index), vec![pressure.load()]);
        }
        for (index, soil) in self.soils.iter().enumerate() {
            let (body, shaken) = (self.body.rounded(), shaken.as_ref());
            let of_soil = soil.loads(index, &body, self.gravity.value(), shaken);
            of_soil.into_iter().for_each(|(of, load)| add(of, vec![load.computed()]));
        }
        for (index, force) in self.forces.iter().enumerate() {
            let replaced = matches!(acting, Acting::Alone(alone) if alone != index && force.acts_alone());
            if !replaced {
                let of = LoadOrigin::Force(index, force.of);
                add(of, vec![over_time(force.load(&self.body), &force.history)]);
            }
        }
        loads
    }

    /// The weight of the body, or of what is above a joint; where a combination names groups of its parts, that of each of these, and that of
    /// the rest.
    fn weights(&self, acting: Acting, joint: Option<&CaseJoint<T>>) -> Vec<(LoadOrigin, Load<T>)> {
        let groups = self.weighed_apart(acting);
        let weight = |action| Load::permanent(LoadSource::Weight, LoadKind::Weight, action);
        let whole = || (LoadOrigin::Table(Table::Body), weight(Action::Weight));
        let Some(section) = self.section.as_ref().filter(|_| !groups.is_empty()) else {
            return vec![whole()];
        };
        let masses: Vec<(f64, Vertex)> = match joint {
            None => {
                section.masses(self.water_table).into_iter().map(|part| (part.mass, part.centre)).collect()
            }
            Some(joint) => {
                let [left, right] = section.ends();
                let masses = section.masses_above(joint.level().value(), self.water_table).into_iter();
                let from_middle = |at: Vertex| Vertex { x: at.x - (left + right) / 2.0, ..at };
                masses.map(|part| (part.mass, from_middle(part.centre))).collect()
            }
        };
        let length = self.body.plan().side(self.body.width()).value();
        let of = |group: Option<&str>| {
            let members = self.members(&groups, group);
            let mass: f64 = members.iter().map(|part| masses[*part].0).sum();
            if mass <= 0.0 {
                return None;
            }
            let moment = |along: fn(&Vertex) -> f64| -> f64 {
                members.iter().map(|part| masses[*part].0 * along(&masses[*part].1)).sum()
            };
            let [x, y] = [moment(|at| at.x), moment(|at| at.y)].map(|sum| sum / mass);
            let down = -(length * mass * self.gravity.value());
            let at = BodyPoint { x: T::computed(x), y: T::computed(y) };
            let at = joint.map_or_else(|| at.clone(), |joint| joint.above.place(&at));
            let action = Action::Force { at, right: T::of(0.0), up: T::computed(down) };
            let load = Load::permanent(LoadSource::Weight, LoadKind::Weight, action);
            let (of, name) = match group {
                Some(group) => (LoadOrigin::Group(members[0]), format!("weight of {group}")),
                None => (LoadOrigin::Table(Table::Body), "weight of the rest".to_owned()),
            };
            Some((of, load.named(name)))
        };
        groups.iter().copied().map(Some).chain([None]).filter_map(of).collect()
    }

    /// The groups of parts whose weights are loads of their own in a situation.
    fn weighed_apart(&self, acting: Acting) -> Vec<&str> {
        match acting {
            Acting::Combination(index) => self.groups_in(&self.combinations[index]),
            _ => Vec::new(),
        }
    }

    /// The parts of a group, by their places; those in none of `groups`.
    fn members(&self, groups: &[&str], group: Option<&str>) -> Vec<usize> {
        let is_it = |of: Option<&str>| match group {
            Some(group) => of == Some(group),
            None => of.is_none_or(|of| !groups.contains(&of)),
        };
        (0..self.part_groups.len()).filter(|part| is_it(self.part_groups[*part].as_deref())).collect()
    }

    /// The parts of which a load of a situation is the weight, by their places, where it is that of some.
    pub fn parts_weighed(&self, acting: Acting, load: &Load<T>) -> Option<Vec<usize>> {
        let groups = self.weighed_apart(acting);
        let is_weight = load.source == LoadSource::Weight && !groups.is_empty();
        is_weight.then(|| match said_by(load.id) {
            Place::Table(Table::Part, first) => self.members(&groups, self.part_groups[first].as_deref()),
            _ => self.members(&groups, None),
        })
    }

    /// Buoyancy under a weight that is given less it: what lacks to m g, and to its moment about O.
    fn lift(&self) -> Option<Load<T>> {
        let Weight::Buoyant { force, arm } = self.weight.clone() else { return None };
        let weight = self.body.mass() * self.gravity.clone();
        let centre = self.body.heel_distance();
        let lift = weight.clone() - force.clone();
        let action = match (lift == T::of(0.0), arm == centre) {
            (true, true) => return None,
            (true, false) => {
                let turns = force * (arm - centre);
                Action::from(Wrench { x: T::of(0.0), p: T::of(0.0), m: -turns })
            }
            (false, true) => Action::vertical(&self.body, -lift, centre),
            (false, false) => {
                let at = (weight * centre - force * arm) / lift.clone();
                Action::vertical(&self.body, -lift, at)
            }
        };
        Some(Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, action))
    }
}

impl Case {
    /// True if its base may crush, or the ground under it fail.
    pub fn gives_way(&self) -> bool {
        self.ground.is_some_and(|ground| ground.limit.is_some())
    }

    /// Loads that act together: in each combination; or else beside each force that acts alone; or else all.
    pub fn acting(&self) -> Vec<Acting> {
        if !self.combinations.is_empty() {
            return (0..self.combinations.len()).map(Acting::Combination).collect();
        }
        let alone = self.forces.iter().enumerate().filter(|(_, force)| force.acts_alone());
        let alone: Vec<_> = alone.map(|(index, _)| Acting::Alone(index)).collect();
        if alone.is_empty() { vec![Acting::All] } else { alone }
    }

    /// The accelerations of the base that are tried: as given, and unless that is fixed to the other side, and down for up; none
    /// where no earthquake acts.
    pub fn earthquakes(&self, acting: Acting) -> Vec<Earthquake> {
        self.shakings(acting).into_iter().filter_map(|shaking| self.shaken(shaking)).collect()
    }

    /// The ways in which the base is shaken in turn; none where no earthquake acts.
    pub fn shakings(&self, acting: Acting) -> Vec<Shaking> {
        self.shakings_if(acting, [false; 3])
    }

    /// The same where the acceleration to the sides, upwards or away may be another than the case's, which may be zero.
    pub fn shakings_if(&self, acting: Acting, moved: [bool; 3]) -> Vec<Shaking> {
        let given = self.earthquake.filter(|_| self.is_shaken(acting));
        given.map_or(Vec::new(), |given| self.ways(&given, moved))
    }

    /// Factor on the earthquake: that of a combination, which may be zero.
    pub fn earthquake_factor(&self, acting: Acting, trial: Trial) -> f64 {
        match (acting, Table::Earthquake.in_combination()) {
            (Acting::Combination(index), Some(name)) => {
                self.combinations[index].factor(name, trial).unwrap_or(0.0)
            }
            _ => 1.0,
        }
    }

    /// True if an earthquake acts, with any factor of a pair.
    fn is_shaken(&self, acting: Acting) -> bool {
        match (acting, Table::Earthquake.in_combination()) {
            (Acting::Combination(index), Some(name)) => {
                let factors = &self.combinations[index].factors;
                let of_soil =
                    |named: &str| self.soils.iter().any(|soil| soil.made(Made::Earthquake) == named);
                let acts = |factor: &LoadFactor| factor.all().iter().any(|factor| *factor != 0.0);
                factors.iter().any(|(named, factor)| (named == name || of_soil(named)) && acts(factor))
            }
            _ => true,
        }
    }

    /// The parts of the body, with their names.
    pub fn parts(&self) -> impl Iterator<Item = (Option<&str>, &Part)> {
        let parts = self.section.iter().flat_map(Section::parts);
        self.part_names.iter().map(Option::as_deref).zip(parts)
    }

    /// Variable loads that act in no combination: the table each is of, and its place.
    pub(crate) fn unused(&self) -> Vec<Place> {
        if self.combinations.is_empty() {
            return Vec::new();
        }
        let loads = self.loads(Acting::All, self.earthquake);
        let unused = loads.iter().filter(|(of, load)| {
            let mut combinations = self.combinations.iter();
            // What is made of soil is told of by itself.
            let made = matches!(of, LoadOrigin::Soil(..));
            !made && !load.permanent && !combinations.any(|combination| self.acts_in(combination, *of, load))
        });
        let mut places: Vec<_> = unused.map(|(of, _)| of.place()).collect();
        places.dedup();
        places
    }

    /// The name of a situation: its force that acts alone or its combination, or the number of it, counted from one.
    pub fn acting_name(&self, acting: Acting) -> Option<String> {
        match acting {
            Acting::All => None,
            Acting::Alone(index) => {
                let (table, place) = self.forces[index].of;
                let unnamed = || format!("{} {}", table.name(), place + 1);
                Some(self.forces[index].name.clone().unwrap_or_else(unnamed))
            }
            Acting::Combination(index) => {
                let name = &self.combinations[index].name;
                Some(name.clone().unwrap_or_else(|| format!("combination {}", index + 1)))
            }
        }
    }
}

/// Source of a load, by which a combination names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum LoadOrigin {
    /// A table of the case.
    Table(Table),
    /// A group of parts, by the place of its first.
    Group(usize),
    /// A pressure, by its place.
    Pressure(usize),
    /// A soil, by its place, or something else that it makes.
    Soil(usize, Option<Made>),
    /// A force or a couple, by its place among all, and the table that says it.
    Force(usize, (Table, usize)),
    /// Still water in a joint, from the side at which it stands.
    JointWater(Face),
}

impl LoadOrigin {
    /// The table of the file that says it, and its place among these.
    fn table(self) -> (Table, usize) {
        match self {
            LoadOrigin::Table(table) => (table, 0),
            LoadOrigin::Group(index) => (Table::Part, index),
            LoadOrigin::Pressure(index) => (Table::Pressure, index),
            LoadOrigin::Soil(index, _) => (Table::Backfill, index),
            LoadOrigin::Force(_, of) => of,
            LoadOrigin::JointWater(_) => (Table::Water, 0),
        }
    }

    fn place(self) -> Place {
        let (table, index) = self.table();
        Place::Table(table, index)
    }
}

/// The table that says a load is the upper half of its number, the place of the table the lower.
impl From<LoadOrigin> for LoadId {
    fn from(of: LoadOrigin) -> LoadId {
        let (table, index) = of.table();
        LoadId((table as u64) << 32 | index as u64)
    }
}

/// The table of the file that says a load of a [situation](Case::situation).
pub fn said_by(LoadId(id): LoadId) -> Place {
    let table = Table::ALL.into_iter().find(|table| *table as u64 == id >> 32).unwrap_or(Table::Top);
    Place::Table(table, (id & u64::from(u32::MAX)) as usize)
}
