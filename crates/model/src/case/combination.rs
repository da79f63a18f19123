//! Combinations: loads that act together, each times a factor, in a case some of whose numbers may be others there, with resistances
//! divided and criteria of its own.
//!
//! The order is always the same: `set`, `scale`, `materials` and `resist` change the inputs, of which a [case of its own](Combination::of)
//! is made; its loads then get `factors`; what comes of it is held against `criteria`. Of a pair of factors each is tried, and the worse
//! counts.

use std::borrow::Cow;
use std::sync::Arc;

use standfast::loads::{Action, Face, Load, LoadSource};
use standfast::{Body, Scalar};

use super::backfill::of_all_layers;
use super::code::{Code, CodeLoad, NamedLoad, filled};
use super::loads::{FacePressure, PointForce};
use super::plan;
use super::reader::Reader;
use super::waves::keys_of_others;
use super::{Acting, Case, LoadOrigin, Made, Resistance, SoilFill};
use crate::couple::{Variable, spelled, vary};
use crate::criteria::Criterion;
use crate::digits::decimal;
use crate::error::{Fault, Place, Problem};
use crate::inputs::{Inputs, LoadFactor, Value};
use crate::key::{Id, Key, Table};
use crate::load_words::load_words;
use crate::parse::{read, words_for};

/// Loads that act together, each times a factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Combination {
    /// Its name.
    pub name: Option<String>,
    /// The factors by the names of loads, or of what tables make.
    pub factors: Vec<(String, LoadFactor)>,
    /// Numbers and choices of the case that are others in it, in the order in which they are changed.
    pub changes: Vec<InputChange>,
    /// Divisor of the resistance of the ground.
    pub bearing: f64,
    /// Divisors of forces with a limit, by their names.
    pub holds: Vec<(String, f64)>,
    /// Criteria in place of those of the case.
    pub criteria: Option<Vec<Criterion>>,
    /// Code that filled in what it does not write.
    pub code: Option<Code>,
    /// Criteria of the code that the case cannot answer.
    pub unanswered: Vec<Criterion>,
    /// True if the factors act on the effects of the loads.
    pub effects: bool,
}

/// A value of the case that is another in a combination.
#[derive(Debug, Clone, PartialEq)]
pub struct InputChange {
    /// Its key.
    pub id: Id,
    /// Name by which the combination calls it.
    pub name: String,
    /// Change that is made.
    pub by: ChangeBy,
}

/// Change of an input in a combination.
#[derive(Debug, Clone, PartialEq)]
pub enum ChangeBy {
    /// Another value, as it is written.
    Set(String),
    /// A factor.
    Scale(f64),
    /// A divisor of a strength; of an angle of its tangent.
    Material(f64),
    /// A divisor of the resistance to sliding.
    Resistance(f64),
}

/// One of the ways in which a situation is tried: the signs of the acceleration of the base, and of every pair of factors one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Trial {
    /// The way in which the base is shaken; `None` as it is given.
    pub shaking: Option<Shaking>,
    /// Places of the pairs of which the second factor is taken, as bits.
    pub second: u64,
}

/// One of the ways in which a base is shaken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shaking {
    /// Signs by which its acceleration is multiplied, to the sides, upwards, and away from the viewer.
    pub signs: [i8; 3],
    /// The edge, from zero, across which the body is pushed, where the worst of all directions is asked for.
    pub across: Option<u16>,
}

/// The most pairs of factors that a combination may have: 64 ways to try.
pub const PAIRS: usize = 6;

impl Trial {
    /// The accelerations as they are given, the first of every pair of factors.
    pub const AS_GIVEN: Trial = Trial { shaking: None, second: 0 };

    /// With the base shaken in one of its ways.
    pub fn shaken(shaking: Option<Shaking>) -> Trial {
        Trial { shaking, second: 0 }
    }
}

impl Combination {
    /// The factor under a name, where the combination has it.
    pub fn factor(&self, name: &str, trial: Trial) -> Option<f64> {
        let (place, (_, factor)) = self.factors.iter().enumerate().find(|(_, (named, _))| named == name)?;
        Some(match *factor {
            LoadFactor::One(factor) => factor,
            LoadFactor::Pair(both) => both[usize::from(trial.second >> self.pair(place) & 1 == 1)],
        })
    }

    /// The place among the pairs of a factor that is one.
    fn pair(&self, place: usize) -> usize {
        self.factors[..place].iter().filter(|(_, factor)| matches!(factor, LoadFactor::Pair(_))).count()
    }

    /// The number of pairs.
    pub fn pairs(&self) -> usize {
        self.pair(self.factors.len())
    }
}

impl Case {
    /// The cases of its combinations, where they change something.
    pub(super) fn combined(&self) -> Result<Vec<Option<Arc<Case>>>, Fault> {
        (0..self.combinations.len()).map(|index| self.changed(index)).collect()
    }

    /// The case of a combination, by its place; `None` where it is that of all.
    fn changed(&self, index: usize) -> Result<Option<Arc<Case>>, Fault> {
        let Combination { changes, bearing, holds, .. } = &self.combinations[index];
        if changes.is_empty() && *bearing == 1.0 && holds.is_empty() {
            return Ok(None);
        }
        let name = || self.acting_name(Acting::Combination(index)).unwrap_or_default();
        let mut changed: Option<(Inputs, Case)> = None;
        // One step after another: what is multiplied has been set before.
        for key in
            [Key::CombinationSet, Key::CombinationScale, Key::CombinationMaterials, Key::CombinationResist]
        {
            let of_step: Vec<&InputChange> = changes.iter().filter(|change| change.by.key() == key).collect();
            if of_step.is_empty() {
                continue;
            }
            let (inputs, case) =
                changed.as_ref().map_or((&*self.inputs, self), |(inputs, case)| (inputs, case));
            let id = Id::new(key, index);
            let inputs = step(inputs, case, &of_step)
                .map_err(|(place, problem)| Fault::new(problem, Place::Element(id, place)))?;
            let case = Case::in_scalars(Arc::new(inputs.clone())).map_err(|fault| {
                let problem = Problem::InCombination { name: name(), problem: Box::new(fault.problem) };
                Fault::new(problem, id)
            })?;
            changed = Some((inputs, case));
        }
        let mut case = changed.map_or_else(|| self.clone(), |(_, case)| case);
        case.ground = case.ground.map(|ground| ground.divided(*bearing));
        for resistance in &mut case.resistances {
            let by = holds.iter().find(|(name, _)| *name == resistance.name);
            resistance.divisor = by.map_or(1.0, |(_, by)| *by);
        }
        Ok(Some(Arc::new(case)))
    }

    /// The names of the loads that act in none of the trials of a combination, by its place.
    pub fn left_out(&self, index: usize) -> Vec<String> {
        let combination = &self.combinations[index];
        let loads = self.loads(Acting::Combination(index), self.earthquake);
        let mut names: Vec<String> = Vec::new();
        for (of, load) in loads.iter().filter(|(of, load)| !self.acts_in(combination, *of, load)) {
            let name = self.called(*of, load).next().map_or_else(|| load_words(load), Cow::into_owned);
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// The factor of a combination on a load of its situation; 1 of a situation that is none.
    pub fn factor_on(&self, acting: Acting, trial: Trial, load: &Load) -> f64 {
        let Acting::Combination(index) = acting else { return 1.0 };
        let case = self.under(acting);
        let combination = &case.combinations[index];
        let all = case.loads_tried(acting, trial);
        let is_it = |of: LoadOrigin, other: &Load| {
            (of.into(), other.source, &other.name) == (load.id, load.source, &load.name)
        };
        let found = all.iter().find(|(of, other)| is_it(*of, other));
        found.map_or(1.0, |(of, load)| case.factor(combination, *of, load, trial))
    }

    /// The inputs that it was made of.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// The numbers that are others in a combination, by its place, than in the case, with their keys: those that are named, and those that
    /// move with them.
    pub fn values_in(&self, index: usize) -> impl Iterator<Item = (Id, f64)> {
        let changed = self.changed.get(index).and_then(Option::as_deref);
        let numbers = changed.into_iter().flat_map(|case| case.inputs.numbers());
        numbers.filter(|(id, number)| self.inputs.number(*id) != Some(*number))
    }

    /// The factors of a situation, where some are pairs.
    pub fn pairs_in(&self, acting: Acting) -> Option<Id> {
        match acting {
            Acting::Combination(index) if self.combinations[index].pairs() > 0 => {
                Some(Id::new(Key::LoadFactors, index))
            }
            _ => None,
        }
    }

    /// True if a load acts in a combination, with any factor of a pair.
    pub(super) fn acts_in(&self, combination: &Combination, of: LoadOrigin, load: &Load) -> bool {
        (0..1_u64 << combination.pairs())
            .any(|second| self.factor(combination, of, load, Trial { shaking: None, second }) != 0.0)
    }

    /// The criteria of a situation.
    pub fn criteria_of(&self, acting: Acting) -> &[Criterion] {
        let of_combination = match acting {
            Acting::Combination(index) => self.combinations[index].criteria.as_deref(),
            _ => None,
        };
        of_combination.unwrap_or(&self.criteria)
    }

    /// The criteria of all situations, each once.
    pub fn all_criteria(&self) -> Vec<Criterion> {
        let mut all: Vec<Criterion> = Vec::new();
        for acting in self.acting() {
            let new = self.criteria_of(acting).iter().filter(|criterion| !all.contains(criterion));
            let new: Vec<_> = new.copied().collect();
            all.extend(new);
        }
        all
    }

    /// The ways in which a situation is tried under the acceleration of the base as it is given: with each factor of a pair.
    pub(crate) fn trials_of_pairs(&self, acting: Acting) -> impl Iterator<Item = Trial> + use<> {
        let pairs = match acting {
            Acting::Combination(index) => self.combinations[index].pairs(),
            _ => 0,
        };
        (0..1_u64 << pairs).map(|second| Trial { second, ..Trial::AS_GIVEN })
    }

    /// The ways in which a situation is tried: under each acceleration of the base, with each factor of a pair.
    pub fn trials(&self, acting: Acting) -> Vec<Trial> {
        let shakings = self.under(acting).shakings(acting);
        let shakings =
            if shakings.is_empty() { vec![None] } else { shakings.into_iter().map(Some).collect() };
        let with = |Trial { second, .. }| {
            shakings.iter().map(move |shaking| Trial { second, ..Trial::shaken(*shaking) })
        };
        self.trials_of_pairs(acting).flat_map(with).collect()
    }
}

impl<T: Scalar> Case<T> {
    /// The case of a situation: that of its combination, where that changes something.
    pub fn under(&self, acting: Acting) -> &Case<T> {
        let changed = match acting {
            Acting::Combination(index) => self.changed.get(index).and_then(Option::as_deref),
            _ => None,
        };
        changed.unwrap_or(self)
    }

    /// Factor of a combination on a load: one that it does not name acts as it is if it is permanent, and else not. The more precise
    /// name goes before.
    pub(super) fn factor(
        &self,
        combination: &Combination,
        of: LoadOrigin,
        load: &Load<T>,
        trial: Trial,
    ) -> f64 {
        let factor = self.called(of, load).find_map(|name| combination.factor(&name, trial));
        factor.unwrap_or(if load.permanent { 1.0 } else { 0.0 })
    }

    /// The same factor of a combination, by its place, with all its decimals.
    pub(super) fn factor_as_written(&self, index: usize, of: LoadOrigin, load: &Load<T>, trial: Trial) -> T {
        let combination = &self.combinations[index];
        let named = |name: Cow<str>| combination.factors.iter().position(|(known, _)| *known == name);
        let factor = self.factor(combination, of, load, trial);
        match self.called(of, load).find_map(named) {
            Some(place) if matches!(combination.factors[place].1, LoadFactor::One(_)) => {
                self.inputs.element(Id::new(Key::LoadFactors, index), place, factor)
            }
            _ => T::written(factor),
        }
    }

    /// The names by which a combination calls a load, the most precise first.
    pub(super) fn called<'a>(
        &'a self,
        of: LoadOrigin,
        load: &Load<T>,
    ) -> impl Iterator<Item = Cow<'a, str>> + use<'a, T> {
        let (part, whole) = match of {
            LoadOrigin::Group(index) => {
                let group = self.part_groups[index].as_deref().unwrap_or_default();
                let name = format!("{WEIGHT_OF}{group}");
                return [Some(name.into()), Table::Body.in_combination().map(Cow::from)]
                    .into_iter()
                    .flatten();
            }
            LoadOrigin::Table(table) => (part_name(table, load), table.in_combination()),
            LoadOrigin::Pressure(index) => (None, self.pressures[index].name.as_deref()),
            LoadOrigin::Soil(index, None) => (None, Some(&*self.soils[index].name)),
            LoadOrigin::Soil(index, Some(made)) => {
                let shaken = if made == Made::Earthquake { Table::Earthquake.in_combination() } else { None };
                (Some(self.soils[index].made(made)), shaken)
            }
            LoadOrigin::Force(index, _) => (None, self.forces[index].name.as_deref()),
            LoadOrigin::JointWater(side) => {
                let end = if side == Face::Left { "water.left" } else { "water.right" };
                (Some(end), Table::Water.in_combination())
            }
        };
        [part, whole].map(|name| name.map(Cow::from)).into_iter().flatten()
    }

    /// The groups of parts whose weight a combination names.
    pub(super) fn groups_in<'a>(&'a self, combination: &Combination) -> Vec<&'a str> {
        let mut groups: Vec<&str> = Vec::new();
        for group in self.part_groups.iter().flatten().map(String::as_str) {
            let is_named = |(name, _): &(String, LoadFactor)| name.strip_prefix(WEIGHT_OF) == Some(group);
            if !groups.contains(&group) && combination.factors.iter().any(is_named) {
                groups.push(group);
            }
        }
        groups
    }
}

/// Names of resistances that a combination may divide.
pub(super) const SLIDING: &str = "sliding";
pub(super) const BEARING: &str = "bearing";
pub(super) const PASSIVE: &str = "passive";

/// What stands before the name of a group of parts in that of its weight.
const WEIGHT_OF: &str = "weight.";

/// The name in a combination of a part of what a table makes.
fn part_name<T: Scalar>(table: Table, load: &Load<T>) -> Option<&'static str> {
    match (table, load.source, &load.action) {
        (Table::Water, LoadSource::Buoyancy, _) => Some("water.base"),
        (Table::Water, LoadSource::WaterOnLeft, _) => Some("water.left"),
        (Table::Water, LoadSource::WaterOnRight, _) => Some("water.right"),
        (Table::Water, LoadSource::StillWater, Action::Pressure { face: Face::Left, .. }) => {
            Some("water.left")
        }
        (Table::Water, LoadSource::StillWater, Action::Pressure { face: Face::Right, .. }) => {
            Some("water.right")
        }
        (Table::Wave, LoadSource::WavePressure, _) => Some("wave.thrust"),
        (Table::Wave, LoadSource::WaveUplift, _) => Some("wave.uplift"),
        _ => None,
    }
}

/// The names of the parts of what a table makes.
pub(super) fn part_names(table: Table) -> &'static [&'static str] {
    match table {
        Table::Water => &["water.left", "water.right", "water.base"],
        Table::Wave => &["wave.thrust", "wave.uplift"],
        _ => &[],
    }
}

impl ChangeBy {
    /// The key of a combination under which it stands.
    pub fn key(&self) -> Key {
        match self {
            ChangeBy::Set(_) => Key::CombinationSet,
            ChangeBy::Scale(_) => Key::CombinationScale,
            ChangeBy::Material(_) => Key::CombinationMaterials,
            ChangeBy::Resistance(_) => Key::CombinationResist,
        }
    }
}

/// What `materials` divides: of an angle the tangent.
pub(super) const STRENGTHS: [Key; 14] = [
    Key::Adhesion,
    Key::Friction,
    Key::KineticFriction,
    Key::JointFriction,
    Key::JointKineticFriction,
    Key::Strength,
    Key::GroundAngle,
    Key::Cohesion,
    Key::UndrainedStrength,
    Key::CentricResistance,
    Key::SoilFriction,
    Key::WallFriction,
    Key::SoilCohesion,
    Key::SoilAdhesion,
];

/// The divisor of the resistance to sliding as a change of an input.
fn of_sliding(id: Id, by: f64) -> InputChange {
    InputChange { id, name: SLIDING.to_owned(), by: ChangeBy::Resistance(by) }
}

/// What a combination divides resistances by.
struct Resisting {
    sliding: Option<f64>,
    bearing: Option<f64>,
    /// Forces with a limit, by their names.
    holds: Vec<(String, f64)>,
}

/// A strength after a partial factor.
fn divided(key: Key, value: f64, by: f64) -> f64 {
    match key.is_friction_angle() {
        true => (value.to_radians().tan() / by).atan().to_degrees(),
        false => value / by,
    }
}

impl Reader<'_> {
    /// A combination: it names loads that there are, and keys, each of them once.
    pub(super) fn combination(
        &self,
        index: usize,
        body: &Body,
        forces: &[PointForce<impl Scalar>],
        pressures: &[FacePressure<impl Scalar>],
        soils: &[SoilFill],
        resistances: &[Resistance],
    ) -> Result<Combination, Fault> {
        let id = |key| Id::new(key, index);
        let tables = Table::ALL.into_iter().filter(|table| self.inputs.has(*table));
        let of_groups = self.weights_of_groups();
        let mut names: Vec<&str> = of_groups.iter().map(String::as_str).collect();
        for table in tables {
            names.extend(table.in_combination());
            names.extend(part_names(table));
        }
        if self.inputs.get(Key::BuoyantWeight).is_some() {
            names.extend(Table::Water.in_combination());
        }
        let own = names.len();
        let named =
            forces.iter().map(|force| &force.name).chain(pressures.iter().map(|pressure| &pressure.name));
        names.extend(named.flatten().map(String::as_str));
        names.extend(soils.iter().flat_map(SoilFill::names));
        let at = id(Key::CombinationCode);
        let loads = || self.named_loads(index, forces, pressures, soils);
        let filled = match (self.inputs.choice(at), self.inputs.code(at), self.inputs.text(at)) {
            (Some(code), ..) => {
                let passive = resistances.iter().any(Resistance::is_passive);
                Some(filled(self.inputs, code, index, loads()?, body.base_width(), passive)?)
            }
            (_, Some(file), _) => Some(self.filled_by(file, at, loads()?, &names, resistances)?),
            (.., Some(name)) => {
                let why = "it is not read yet".to_owned();
                return Err(Fault::new(Problem::Unread { name: name.to_owned(), why }, at));
            }
            _ => None,
        };
        let factors = self.inputs.factors(id(Key::LoadFactors));
        let factors = match &filled {
            Some(_) => factors.unwrap_or_default(),
            None => factors.ok_or_else(|| self.missing(Key::LoadFactors, index))?,
        };
        for (place, (name, factor)) in factors.iter().enumerate() {
            let problem = match names.iter().filter(|known| *known == name).count() {
                1 if name == "weight" && factor.all().contains(&0.0) => Problem::NoWeight,
                1 => continue,
                0 => {
                    let names = names.iter().map(|name| (*name).to_owned()).collect();
                    Problem::UnknownLoad { name: name.clone(), names }
                }
                _ if names[..own].contains(&name.as_str()) => Problem::TakenName { name: name.clone() },
                _ => Problem::SameName { name: name.clone() },
            };
            return Err(Fault::new(problem, Place::Element(id(Key::LoadFactors), place)));
        }
        let name = self.inputs.text(id(Key::CombinationName)).map(str::to_owned);
        let earlier = |index| self.inputs.text(Id::new(Key::CombinationName, index));
        if let Some(name) = name.clone().filter(|name| (0..index).any(|index| earlier(index) == Some(name))) {
            return Err(Fault::new(Problem::SameCombination { name }, id(Key::CombinationName)));
        }
        let Resisting { sliding, bearing, holds } = self.resisting(index, resistances)?;
        let mut changes = self.changes(index)?;
        let mut factors = factors.to_vec();
        let effects = self.inputs.truth(id(Key::CombinationEffects)).unwrap_or(false);
        let mut combination = Combination {
            name,
            factors: Vec::new(),
            changes: Vec::new(),
            bearing: bearing.unwrap_or(1.0),
            holds: Vec::new(),
            criteria: self.own_criteria(index)?,
            code: None,
            unanswered: Vec::new(),
            effects,
        };
        let mut sliding = sliding;
        let mut holds = holds;
        if let Some(filled) = filled {
            // What is written goes before what the code fills in.
            let is_new = |(name, _): &(String, LoadFactor)| factors.iter().all(|(known, _)| known != name);
            let new: Vec<_> = filled.factors.into_iter().filter(is_new).collect();
            factors.extend(new);
            let is_new = |change: &InputChange| {
                changes.iter().all(|known| known.id != change.id || known.by.key() != change.by.key())
            };
            let new: Vec<_> = filled.changes.into_iter().filter(is_new).collect();
            changes.extend(new);
            sliding = sliding.or(filled.sliding);
            let is_new = |(name, _): &(String, f64)| holds.iter().all(|(known, _)| known != name);
            let new: Vec<_> = filled.holds.into_iter().filter(is_new).collect();
            holds.extend(new);
            for resistance in resistances {
                let by = if resistance.is_passive() { filled.passive } else { filled.ties };
                let is_new = holds.iter().all(|(name, _)| *name != resistance.name);
                holds.extend(by.filter(|by| is_new && *by != 1.0).map(|by| (resistance.name.clone(), by)));
            }
            let has_bearing = self.has_bearing();
            combination.bearing = bearing.or(filled.bearing.filter(|_| has_bearing)).unwrap_or(1.0);
            combination.code = Some(filled.code);
            if combination.criteria.is_none() && !filled.criteria.is_empty() {
                let buoyant = self.inputs.get(Key::BuoyantWeight).is_some();
                let on_plan = self.seen_from_above().is_some();
                let (answered, unanswered) =
                    filled.criteria.into_iter().partition(|criterion: &Criterion| match criterion.key {
                        key if on_plan => plan::CRITERIA.contains(&key),
                        Key::LeastGround => has_bearing,
                        Key::LeastUplift | Key::GreatestTipping => !buoyant,
                        _ => true,
                    });
                (combination.criteria, combination.unanswered) = (Some(answered), unanswered);
            }
        }
        let keys = [Key::Friction, Key::Adhesion].map(Id::from);
        let keys = keys.into_iter().filter(|id| self.inputs.number(*id).is_some());
        changes.extend(sliding.into_iter().flat_map(|by| keys.clone().map(move |id| of_sliding(id, by))));
        let combination = Combination { factors, changes, holds, ..combination };
        match combination.pairs() {
            count if count > PAIRS => Err(Fault::new(Problem::TooManyPairs { count }, id(Key::LoadFactors))),
            _ => Ok(combination),
        }
    }

    /// The names of the weights of groups of parts, each once.
    fn weights_of_groups(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for group in self.of_parts(Key::PartGroup).into_iter().flatten() {
            let name = format!("{WEIGHT_OF}{group}");
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// What a combination sets, scales, and divides of strengths.
    fn changes(&self, index: usize) -> Result<Vec<InputChange>, Fault> {
        let mut changes: Vec<InputChange> = Vec::new();
        let set = self.inputs.settings(Id::new(Key::CombinationSet, index)).unwrap_or_default();
        let of_ratios = |key, by: fn(f64) -> ChangeBy| {
            let ratios = self.inputs.ratios(Id::new(key, index)).unwrap_or_default();
            ratios.iter().enumerate().map(move |(place, (name, ratio))| (place, name, by(*ratio)))
        };
        let set =
            set.iter().enumerate().map(|(place, (name, text))| (place, name, ChangeBy::Set(text.clone())));
        let all = set
            .chain(of_ratios(Key::CombinationScale, ChangeBy::Scale))
            .chain(of_ratios(Key::CombinationMaterials, ChangeBy::Material));
        for (place, name, by) in all {
            let key = by.key();
            let fault = |problem| Fault::new(problem, Place::Element(Id::new(key, index), place));
            let is_set = |id: &Id| changes.iter().any(|change| change.id == *id);
            let id = self.key_called(name, key, is_set).map_err(fault)?;
            let is_number = id.key.info().range().is_some();
            match by {
                ChangeBy::Scale(_) if !is_number => {
                    return Err(fault(Problem::NoNumber { name: name.clone() }));
                }
                ChangeBy::Material(_) if !STRENGTHS.contains(&id.key) => {
                    let of = Variable::all(self.inputs).filter(|id| STRENGTHS.contains(&id.key));
                    let names = of.map(|id| id.to_string()).collect();
                    return Err(fault(Problem::NoStrength { name: name.clone(), names }));
                }
                _ => {}
            }
            if changes.iter().any(|before| before.id == id && before.by.key() == key) {
                return Err(fault(Problem::NamedTwice { name: name.clone() }));
            }
            changes.push(InputChange { id, name: name.clone(), by });
        }
        Ok(changes)
    }

    /// The key that `set`, `scale` or `materials` calls by a name.
    pub(super) fn key_called(
        &self,
        name: &str,
        by: Key,
        is_set: impl Fn(&Id) -> bool,
    ) -> Result<Id, Problem> {
        if let Ok(variable) = Variable::find(name, self.inputs) {
            return Ok(variable.id());
        }
        let spelled = spelled(name, self.inputs);
        let name = spelled.as_deref().unwrap_or(name);
        let apart = |table: &Table| {
            !matches!(table, Table::Top | Table::Datum | Table::Output | Table::Combination | Table::Criteria)
        };
        let tables = Table::ALL.into_iter().filter(|table| self.inputs.has(*table)).filter(apart);
        let mut keys = tables.flat_map(|table| {
            let indices = self.inputs.indices(table).into_iter();
            indices.flat_map(move |index| table.keys().map(move |key| Id::of(table, index, key)))
        });
        let found = keys.find(|id| id.to_string() == name);
        // What the case does not say has no number to be multiplied; heights in deep water say those at the wall.
        let deep = self.inputs.number(Key::DeepWaterHeight).is_some();
        let at_wall = |id: &Id| deep && matches!(id.key, Key::H13 | Key::Hmax);
        let has = |id: &Id| self.inputs.get(*id).is_some() || is_set(id) || at_wall(id);
        let found = found.filter(|id| match by {
            Key::CombinationSet => true,
            Key::CombinationMaterials => of_all_layers(self.inputs, *id).iter().any(has),
            _ => has(id),
        });
        found.ok_or_else(|| {
            let names = Variable::all(self.inputs).map(|id| id.to_string()).collect();
            Problem::NoKeyCalled { name: name.to_owned(), by, names }
        })
    }

    /// What a combination divides resistances by.
    fn resisting(&self, index: usize, resistances: &[Resistance]) -> Result<Resisting, Fault> {
        let id = Id::new(Key::CombinationResist, index);
        let ratios = self.inputs.ratios(id).unwrap_or_default();
        let mut names = vec![SLIDING, BEARING];
        names.extend(resistances.iter().any(Resistance::is_passive).then_some(PASSIVE));
        names.extend(resistances.iter().map(|resistance| resistance.name.as_str()));
        for (place, (name, _)) in ratios.iter().enumerate() {
            let at = Place::Element(id, place);
            if !names.contains(&name.as_str()) {
                let names = names.iter().map(|name| (*name).to_owned()).collect();
                return Err(Fault::new(Problem::UnknownResistance { name: name.clone(), names }, at));
            }
            if name == BEARING && !self.has_bearing() {
                return Err(Fault::new(Problem::NoBearing, at));
            }
        }
        let of = |name: &str| ratios.iter().find(|(known, _)| known == name).map(|(_, ratio)| *ratio);
        // The more precise name goes before.
        let by = |resistance: &Resistance| {
            of(&resistance.name).or_else(|| of(PASSIVE).filter(|_| resistance.is_passive()))
        };
        let holds =
            resistances.iter().filter_map(|resistance| Some((resistance.name.clone(), by(resistance)?)));
        Ok(Resisting { sliding: of(SLIDING), bearing: of(BEARING), holds: holds.collect() })
    }

    /// True if what the base bears has a limit.
    fn has_bearing(&self) -> bool {
        [Key::Strength, Key::GroundAngle, Key::UndrainedStrength, Key::CentricResistance]
            .iter()
            .any(|key| self.inputs.get(*key).is_some())
    }

    /// The loads of the case as a code names them: each once, and all.
    fn named_loads(
        &self,
        index: usize,
        forces: &[PointForce<impl Scalar>],
        pressures: &[FacePressure<impl Scalar>],
        soils: &[SoilFill],
    ) -> Result<Vec<NamedLoad>, Fault> {
        let load = |name: &str, kind| NamedLoad { name: name.to_owned(), kind };
        let has = |table| self.inputs.has(table);
        let mut loads = vec![load("weight", CodeLoad::Permanent)];
        if has(Table::Water) || self.inputs.get(Key::BuoyantWeight).is_some() {
            loads.push(load("water", CodeLoad::Water));
        }
        if has(Table::Uplift) {
            let grows = self.inputs.truth(Key::UpliftGrows).unwrap_or(false);
            loads.push(load("uplift", if grows { CodeLoad::Variable } else { CodeLoad::Water }));
        }
        if has(Table::Wave) {
            loads.push(load("wave", CodeLoad::Variable));
        }
        if has(Table::Earthquake) {
            loads.push(load("earthquake", CodeLoad::ThroughGround));
        }
        for soil in soils.iter().filter(|soil| !soil.is_passive()) {
            loads.push(load(&soil.name, CodeLoad::Ground));
            if soil.soil.surcharge > 0.0 {
                loads.push(load(soil.made(Made::Surcharge), CodeLoad::ThroughGround));
            }
        }
        let named = forces.iter().map(|force| (force.of.0, force.of.1, (&force.name, force.permanent)));
        let pressed = pressures.iter().map(|pressure| (&pressure.name, pressure.permanent)).enumerate();
        let pressed = pressed.map(|(place, of)| (Table::Pressure, place, of));
        for (table, place, (name, permanent)) in named.chain(pressed) {
            let kind = if permanent { CodeLoad::Permanent } else { CodeLoad::Variable };
            match name {
                Some(name) => loads.push(load(name, kind)),
                None => {
                    let at = Place::Table(table, place);
                    return Err(
                        Fault::new(Problem::NamelessLoad, at).and(Id::new(Key::CombinationCode, index))
                    );
                }
            }
        }
        Ok(loads)
    }

    /// The criteria of a combination.
    fn own_criteria(&self, index: usize) -> Result<Option<Vec<Criterion>>, Fault> {
        let id = Id::new(Key::CombinationCriteria, index);
        let Some(bounds) = self.inputs.bounds(id) else { return Ok(None) };
        let criteria = bounds.iter().enumerate().map(|(place, (key, value))| {
            Criterion::of(*key, value, self.inputs.output())
                .filter(|criterion| !criterion.is_chance())
                .ok_or_else(|| {
                    let problem = Problem::CriterionOfAll { name: key.name() };
                    Fault::new(problem, Place::Element(id, place))
                })
        });
        criteria.collect::<Result<_, _>>().map(Some)
    }
}

/// The inputs after changes of one kind, with what goes with them; the place of the one that cannot be, and why.
fn step(inputs: &Inputs, case: &Case, changes: &[&InputChange]) -> Result<Inputs, (usize, Problem)> {
    let inputs = &*heights_at_wall(inputs, case, changes);
    let mut others = Vec::new();
    let (mut numbers, mut divisions) = (Vec::new(), Vec::new());
    for (place, change) in changes.iter().enumerate() {
        let present = inputs.number(change.id);
        let variable = match Variable::find(&change.name, inputs) {
            Ok(variable) => variable,
            Err(_) => Variable::of(change.id, inputs),
        };
        let value = match &change.by {
            ChangeBy::Set(text) => {
                let kind = change.id.key.info().kind;
                let unquoted = text.trim_matches(['"', '\'']);
                let is_word = words_for(change.id).contains(&unquoted);
                let is_number = change.id.key.info().range().is_some() && present.is_some() && !is_word;
                if !is_number {
                    let value = read(change.id, kind, inputs.frame(), text);
                    others.push((change.id, value.map_err(|problem| (place, problem))?));
                    continue;
                }
                variable.read(unquoted, inputs).map_err(|problem| (place, problem))?
            }
            // To fifteen digits: 0.011/1.1 is 0.01, as who writes it in decimals finds it.
            ChangeBy::Scale(by) => decimal(variable.value(inputs, case) * by),
            ChangeBy::Resistance(by) => {
                for id in of_all_joints(inputs, change.id, changes) {
                    let joint = Variable::of(id, inputs);
                    let value = decimal(divided(id.key, joint.value(inputs, case), *by));
                    numbers.push((joint, value));
                }
                decimal(divided(change.id.key, variable.value(inputs, case), *by))
            }
            ChangeBy::Material(by) => {
                for id in with_wall(inputs, change.id, changes) {
                    let Some(present) = inputs.number(id) else { continue };
                    divisions.push((Variable::of(id, inputs), decimal(divided(id.key, present, *by))));
                }
                continue;
            }
        };
        numbers.push((variable, value));
    }
    let strengths: Vec<Id> = divisions.iter().map(|(variable, _)| variable.id()).collect();
    numbers.extend(divisions);
    let numbers: Vec<(&Variable, f64)> = numbers.iter().map(|(variable, value)| (variable, *value)).collect();
    let mut changed = vary(inputs, case, &numbers);
    for (id, value) in others {
        // What another formula of the waves has no use for goes.
        if let (Key::WaveFormula, Value::Choice(formula)) = (id.key, &value) {
            keys_of_others(formula).for_each(|key| changed.remove(key.into()));
        }
        changed.put(id, value);
    }
    strengths.into_iter().for_each(|id| changed.put_divided(id));
    Ok(changed)
}

/// The inputs with the heights at the wall as they are found in place of one in deep water, where these are multiplied or set.
fn heights_at_wall<'a>(inputs: &'a Inputs, case: &Case, changes: &[&InputChange]) -> Cow<'a, Inputs> {
    let named = changes.iter().any(|change| matches!(change.id.key, Key::H13 | Key::Hmax));
    let is_deep = named && inputs.number(Key::DeepWaterHeight).is_some();
    let Some(heights) = is_deep.then(|| case.heights_at_wall()).flatten() else {
        return Cow::Borrowed(inputs);
    };
    let mut inputs = inputs.clone();
    inputs.remove(Key::DeepWaterHeight.into());
    // The heights are another sea's: its period stays.
    if let Some(waves) = case.goda().filter(|waves| waves.steepness.is_some()) {
        inputs.remove(Key::Steepness.into());
        inputs.set(Key::Period, waves.sea.period);
    }
    for (key, height) in [Key::H13, Key::Hmax].into_iter().zip(heights) {
        inputs.set(key, height);
    }
    Cow::Owned(inputs)
}

/// The friction of the joints that a divisor of that of the base divides as well: all that are not named themselves.
fn of_all_joints(inputs: &Inputs, id: Id, changes: &[&InputChange]) -> Vec<Id> {
    let of_joint = match id.key {
        Key::Friction => Key::JointFriction,
        Key::KineticFriction => Key::JointKineticFriction,
        _ => return Vec::new(),
    };
    let joints = (0..inputs.count(Table::Joint)).map(|index| Id::new(of_joint, index));
    let is_named = |id: &Id| changes.iter().any(|change| change.id == *id);
    joints.filter(|id| inputs.number(*id).is_some() && !is_named(id)).collect()
}

/// What a divisor of a strength divides: of a soil in all its layers, and with its angle of friction that on the wall, unless that is
/// divided by itself.
fn with_wall(inputs: &Inputs, id: Id, changes: &[&InputChange]) -> Vec<Id> {
    let mut ids = of_all_layers(inputs, id);
    ids.extend(of_all_joints(inputs, id, changes));
    if id.key == Key::SoilFriction {
        let is_named =
            |wall: Id| changes.iter().any(|change| of_all_layers(inputs, change.id).contains(&wall));
        let walls = ids.iter().map(|id| Id { key: Key::WallFriction, ..*id });
        let walls: Vec<Id> = walls.filter(|wall| !is_named(*wall)).collect();
        ids.extend(walls);
    }
    ids
}
