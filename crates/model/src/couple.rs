//! Numbers of a case that are varied, one or several at once, and what goes with them for the case to make sense.
//!
//! One rule, so that the order of names does not matter:
//!
//! 1. The named numbers are set.
//! 2. What is coupled by *level* is added: the sea's level moves depths, crest and buoyancy, wherever they stand; only a named
//!    number that moves others itself keeps its value.
//! 3. What goes with the body's size is added or multiplied, unless it is named: the mass with the width, at constant density, the weight
//!    less buoyancy with the height.
//! 4. A pressure on base or top that ends at an edge stretches with it, as the body's dimensions along the base do.

use std::fmt;

use standfast::Plan;
use standfast::loads::Face;
use standfast::section::WaterTable;

use crate::case::{Case, FacePressure, SLACK, Weight, body_of, ends};
use crate::error::Problem;
use crate::inputs::{Inputs, Value, dimension};
use crate::key::{Id, Key, Kind, Moves, Range, Table};
use crate::parse::read;
use crate::suggest::closest_key;
use crate::units::{Dimension, Extent, ShownUnit};

/// A number of a case that is varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    name: String,
    id: Id,
    moves: Moves,
    /// The mass where the file gives the density.
    by_density: bool,
    /// True if a level of the sea moves the water on the other side as well.
    both_sides: bool,
    /// Extent of its forces and masses; `None` where numbers have no units.
    units: Option<Extent>,
    /// The unit in which the file writes it; `None` of a plain number.
    shown: Option<ShownUnit>,
}

/// A name that is not a number of a case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unknown {
    /// The name.
    pub name: String,
    /// The one it resembles.
    pub suggestion: Option<String>,
    /// The numbers of the case.
    pub names: Vec<String>,
    /// The line to write for it, where it is a number that the case may have and does not write; with the table for that.
    pub unwritten: Option<(Table, String)>,
}

/// Note on the numbers that stay when the body or the water is changed.
pub const STAYS: &str = "Loads and pressures keep their elevations above the base, their distances from O and their values. A \
    pressure on base or top that ends at an edge stretches with it.";

/// Short names, and the numbers they may stand for, the first that a case has.
const SHORT_NAMES: [(&str, &[Key]); 6] = [
    ("width", &[Key::Width]),
    ("height", &[Key::Height]),
    ("mass", &[Key::Mass, Key::Density]),
    ("friction", &[Key::Friction]),
    ("water_level", &[Key::Level, Key::WaterRight, Key::BaseDepth, Key::StillWaterLevel]),
    ("crest_height", &[Key::CrestHeight]),
];

impl Variable {
    /// The number of a case that is called `name`: a short name, or table and key as in `wave.period`, `load[2].force` or, of a load called
    /// so, `load.crane.force`.
    ///
    /// # Errors
    /// If there is no such number.
    pub fn find(name: &str, inputs: &Inputs) -> Result<Variable, Unknown> {
        let spelled = spelled(name, inputs);
        let name = spelled.as_deref().unwrap_or(name);
        let short = SHORT_NAMES.iter().find(|(short, _)| *short == name);
        let by_short = short.and_then(|(_, keys)| keys.iter().find(|key| inputs.number(**key).is_some()));
        let by_key =
            || Variable::all(inputs).chain(Variable::implied(inputs)).find(|id| id.to_string() == name);
        if let Some(id) = by_short.map(|key| Id::from(*key)).or_else(by_key) {
            let variable = Variable { name: name.to_owned(), ..Variable::of(id, inputs) };
            return Ok(match name {
                "water_level" => Variable { moves: Moves::WaterLevel, both_sides: true, ..variable },
                "mass" => Variable { by_density: id.key == Key::Density, ..variable },
                _ => variable,
            });
        }
        let names: Vec<_> = Variable::all(inputs).map(|id| id.to_string()).collect();
        let candidates = SHORT_NAMES.iter().map(|(short, _)| *short).chain(names.iter().map(String::as_str));
        let suggestion = closest_key(name, candidates.filter(|candidate| *candidate != name));
        let numbers = Table::ALL.into_iter().filter(|table| inputs.has(*table)).flat_map(|table| {
            let numbers = table.keys().filter(|key| key.info().range().is_some());
            numbers.map(move |key| Id::of(table, 0, key))
        });
        let mut numbers = numbers.filter(|id| id.to_string() == name);
        let unwritten = numbers.next().map(|id| (id.table, id.key.info().line()));
        Err(Unknown { name: name.to_owned(), suggestion, names, unwritten })
    }

    /// The numbers of a case that can be varied.
    pub fn all(inputs: &Inputs) -> impl Iterator<Item = Id> {
        let varied = |id: &Id| {
            let apart = matches!(
                id.table,
                Table::Criteria | Table::Storm | Table::Point | Table::Datum | Table::Output
            );
            id.key.info().range().is_some() && !apart
        };
        inputs.numbers().map(|(id, _)| id).filter(varied)
    }

    /// The numbers of a case that are 1 where its file does not say them, and that can be varied all the same: the factor on the widths of
    /// parts, and those on pressures.
    pub fn implied(inputs: &Inputs) -> impl Iterator<Item = Id> {
        let scales = (0..inputs.count(Table::Pressure)).map(|index| Id::new(Key::PressureFactor, index));
        let widths = inputs.has(Table::Part).then_some(Id::from(Key::WidthScale));
        widths.into_iter().chain(scales).filter(|id| inputs.get(*id).is_none())
    }

    /// The number under a key of inputs.
    pub fn of(id: Id, inputs: &Inputs) -> Variable {
        Variable { shown: inputs.shown_unit(id), ..Variable::under(id, inputs.units()) }
    }

    fn under(id: Id, units: Option<Extent>) -> Variable {
        let moves = id.key.info().moves;
        let both_sides = id.key == Key::Level;
        Variable { name: id.to_string(), id, moves, by_density: false, both_sides, units, shown: None }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The key that it is under.
    pub fn id(&self) -> Id {
        self.id
    }

    /// The key whose words, symbol and unit are its own: the mass's where the file gives the density.
    pub fn key(&self) -> Key {
        if self.by_density { Key::Mass } else { self.id.key }
    }

    /// The name of its key, where it is that number with what goes with it; else what it is called.
    pub fn key_name(&self) -> String {
        let by_key =
            Variable { name: self.name.clone(), shown: self.shown, ..Variable::under(self.id, self.units) };
        if by_key == *self { self.id.to_string() } else { self.name.clone() }
    }

    /// The unit in which people read it: as the file writes it; `None` of a plain number.
    pub fn shown_unit(&self) -> Option<ShownUnit> {
        // The mass is not written where the density is.
        if self.by_density { self.dimension().map(Dimension::shown_in_si) } else { self.shown }
    }

    /// Its dimension; `None` for a plain number.
    pub fn dimension(&self) -> Option<Dimension> {
        dimension(Id { key: self.key(), ..self.id }, self.units)
    }

    /// Its value in a case, SI.
    pub fn value(&self, inputs: &Inputs, case: &Case) -> f64 {
        match inputs.number(self.id) {
            _ if self.by_density => case.body.mass(),
            Some(number) => number,
            None if matches!(self.id.key, Key::WidthScale | Key::PressureFactor) => 1.0,
            None => 0.0,
        }
    }

    /// True if the base or the top may end elsewhere when it varies.
    fn moves_edges(&self) -> bool {
        let of_body = matches!(self.id.key, Key::BaseLeft | Key::BaseRight);
        let of_part =
            matches!(self.id.key, Key::PartLeft | Key::PartWidth | Key::PartTopLeft | Key::PartTopWidth);
        self.moves == Moves::Width || of_body || of_part
    }

    /// The value that a text says behind its key in the case file that `inputs` are of, SI. It need not be in the range of the key.
    ///
    /// # Errors
    /// If it is not a number, or its unit does not fit.
    pub fn read(&self, text: &str, inputs: &Inputs) -> Result<f64, Problem> {
        let key = self.key();
        let kind = match key.info().kind {
            Kind::Measured(dimension, _) => Kind::Measured(dimension, Range::Finite),
            Kind::InGravity => Kind::InGravity,
            Kind::Reached => Kind::Reached,
            _ => Kind::Plain(Range::Finite),
        };
        Ok(match read(Id { key, ..self.id }, kind, inputs.frame(), text)? {
            Value::InGravity(share) => share * inputs.gravity(),
            Value::Number(number) => number,
            // A word may stand in place of a number, but is none to be varied.
            _ => {
                return Err(Problem::OutOfRange {
                    key,
                    written: text.to_owned(),
                    expected: self.range().words(),
                });
            }
        })
    }

    /// Range of the values of its key.
    pub fn range(&self) -> Range {
        self.id.key.info().range().unwrap_or(Range::Finite)
    }

    /// Notes on the numbers that go with it, in sentences.
    pub fn notes(&self, inputs: &Inputs, case: &Case) -> Vec<String> {
        let has = |key: Key| inputs.number(key).is_some();
        let mut notes = Vec::new();
        let buoyant = matches!(case.weight, Weight::Buoyant { .. });
        match self.moves {
            Moves::Width => {
                if has(Key::Mass) {
                    notes.push("The mass goes with the width: the density is kept.");
                }
                if buoyant {
                    notes.push("The buoyant weight goes with the width, and its arm as well.");
                }
            }
            Moves::Length if has(Key::Mass) => {
                notes.push("The mass goes with the length: the density is kept.");
            }
            Moves::Height | Moves::BaseDepth => {
                if has(Key::Mass) {
                    notes.push("The mass goes with the height: the mean density is kept.");
                }
                if buoyant {
                    notes.push("The buoyant weight takes up the weight added or taken away.");
                }
            }
            Moves::Mass if buoyant => {
                notes.push("The buoyant weight takes up the weight added or taken away.");
            }
            Moves::WaterLevel => {
                if case.wave.is_some() {
                    notes.push(
                        "The sea rises or falls: depths change with the level, the crest stays where it is.",
                    );
                }
                if case.water.is_some_and(|water| water.left() != water.right()) {
                    notes.push(match self.both_sides {
                        true => "The level named is that at the right; the one at the left moves with it.",
                        false => {
                            "The level at the left stays: water_level in place of water.right moves both."
                        }
                    });
                }
            }
            Moves::WaterDensity if has(Key::WaterDensity) && has(Key::WaveWaterDensity) => {
                notes.push("Still water and the sea have one density.");
            }
            Moves::Friction if inputs.number(slipping(self.id)).is_some() => {
                notes.push("Friction to slip goes with friction to stick, in proportion.");
            }
            _ => {}
        }
        let shaped = matches!(
            self.moves,
            Moves::Width
                | Moves::Height
                | Moves::Length
                | Moves::WaterLevel
                | Moves::BaseDepth
                | Moves::WaterDensity
        );
        let shaped = shaped || self.moves_edges();
        let placed = case.forces.iter().any(|force| force.distance.is_some());
        if shaped && (placed || !case.pressures.is_empty()) {
            notes.push(STAYS);
        }
        let resized = matches!(self.moves, Moves::Width | Moves::Height | Moves::Mass | Moves::Length);
        if has(Key::MomentOfInertia) && resized {
            notes.push("The moment of inertia goes with the mass: the radius of gyration is kept.");
        }
        notes.into_iter().map(str::to_owned).collect()
    }
}

/// The key of a load, a pressure or a part by its name, with its place in that of the name.
pub(crate) fn spelled(name: &str, inputs: &Inputs) -> Option<String> {
    const NAMED: [(Table, Key); 7] = [
        (Table::Load, Key::LoadName),
        (Table::Moment, Key::MomentName),
        (Table::Resistance, Key::ResistanceName),
        (Table::Pressure, Key::PressureName),
        (Table::Backfill, Key::BackfillName),
        (Table::Part, Key::PartName),
        (Table::Joint, Key::JointName),
    ];
    NAMED.into_iter().find_map(|(table, of)| {
        let rest = name.strip_prefix(table.name())?.strip_prefix('.')?;
        // Of a layer the name is followed by its place.
        let key = |index: usize| rest.strip_prefix(inputs.text(Id::new(of, index))?)?.strip_prefix('.');
        let keys = (0..inputs.count(table)).filter_map(|index| Some((index, key(index)?)));
        let (place, key) = keys.min_by_key(|(_, key)| key.len())?;
        Some(format!("{}.{key}", table.path(place)))
    })
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

/// The inputs with some numbers changed, and what goes with them; `case` is the case of the unchanged `inputs`.
pub fn vary(inputs: &Inputs, case: &Case, changes: &[(&Variable, f64)]) -> Inputs {
    let mut varied = inputs.clone();
    change(&mut varied, inputs, case, changes.iter().copied());
    varied
}

/// Changes numbers of `varied`, which has those of `inputs` that [`moved`] names, and what goes with them.
pub fn change<'a>(
    varied: &mut Inputs,
    inputs: &Inputs,
    case: &Case,
    changes: impl Iterator<Item = (&'a Variable, f64)> + Clone,
) {
    let mut moved = CoupledChanges::default();
    for (variable, value) in changes.clone() {
        let present = variable.value(inputs, case);
        if variable.by_density {
            let density = inputs.number(variable.id).unwrap_or(0.0);
            varied.set(variable.id, density * (value / present));
        } else {
            varied.set(variable.id, value);
        }
        moved.add(variable, case, present, value);
    }
    let named = |key: Key| changes.clone().any(|(variable, _)| variable.id == Id::from(key));
    for (key, by) in moved.levels {
        if let Some(value) = varied.number(key).filter(|_| !named(key) || key.info().moves == Moves::Alone) {
            varied.set(key, value + by);
        }
    }
    for (key, by) in moved.sizes {
        if let Some(value) = varied.number(key).filter(|_| !named(key)) {
            varied.set(key, value + by);
        }
    }
    for (id, ratio) in moved.scales {
        let is_named = changes.clone().any(|(variable, _)| variable.id == id);
        if let Some(value) = varied.number(id).filter(|_| !is_named) {
            varied.set(id, value * ratio);
        }
    }
    for (variable, value) in changes.clone().filter(|(variable, _)| variable.moves == Moves::Mass) {
        weigh(varied, inputs, case, &changes, variable, value);
    }
    for (variable, _) in changes.clone().filter(|(variable, _)| variable.by_density) {
        // The mass that is named is that of the body as wide, long and high as it has become.
        let volume = |inputs: &Inputs| {
            let of = |key| inputs.number(key).unwrap_or(1.0);
            let across = if case.body.plan() == Plan::Circle { of(Key::Width) } else { of(Key::Length) };
            of(Key::Width) * across * of(Key::Height)
        };
        if let Some(density) = varied.number(variable.id) {
            varied.set(variable.id, density * (volume(inputs) / volume(varied)));
        }
    }
    if changes.into_iter().any(|(variable, _)| variable.moves_edges()) {
        stretch(varied, case);
    }
}

/// Stretches the pressures on base and top that end at an edge with the face of the body as it has become. A body that cannot be is left
/// to whoever reads it.
fn stretch(varied: &mut Inputs, case: &Case) {
    let stretching: Vec<Id> = stretching(case).collect();
    let Some(body) = (!stretching.is_empty()).then(|| body_of(varied)).flatten() else { return };
    for id in stretching {
        let face = case.pressures[id.index].face;
        let (Some(from), Some(to)) = (ends(&case.body.rounded(), face), ends(&body, face)) else { continue };
        let Some(positions) = varied.list(id).filter(|_| from != to) else { continue };
        let ratio = (to[1] - to[0]) / (from[1] - from[0]);
        let place = |position: f64| match () {
            () if (position - from[0]).abs() <= SLACK => to[0],
            () if (position - from[1]).abs() <= SLACK => to[1],
            () => to[0] + (position - from[0]) * ratio,
        };
        let places = positions.iter().map(|position| place(*position)).collect();
        varied.put(id, Value::Numbers(places));
    }
}

/// Where the pressures on base and top stand that end at an edge which moves when the body is resized. O itself is where distances begin.
fn stretching(case: &Case) -> impl Iterator<Item = Id> {
    let ends_there = |pressure: &FacePressure| {
        let Some([from, to]) = ends(&case.body.rounded(), pressure.face) else { return false };
        let positions = pressure.diagram.points().iter().map(|point| point.position);
        let near = |end: f64, position: f64| (position - end).abs() <= SLACK;
        let first = pressure.face == Face::Top;
        positions.into_iter().any(|position| near(to, position) || first && near(from, position))
    };
    let places = case.pressures.iter().enumerate().filter(move |(_, pressure)| ends_there(pressure));
    places.map(|(index, _)| Id::new(Key::PressureDistance, index))
}

/// Moves weight and inertia with a named mass or density, beside what its body's size has moved already.
fn weigh<'a>(
    varied: &mut Inputs,
    inputs: &Inputs,
    case: &Case,
    changes: &(impl Iterator<Item = (&'a Variable, f64)> + Clone),
    variable: &Variable,
    value: f64,
) {
    let named = |key: Key| changes.clone().any(|(variable, _)| variable.id == Id::from(key));
    let mut sized = CoupledChanges::default();
    for (variable, value) in changes.clone().filter(|(variable, _)| variable.moves != Moves::Mass) {
        sized.add(variable, case, variable.value(inputs, case), value);
    }
    let of_size: f64 =
        sized.scales.iter().filter(|(id, _)| *id == Id::from(Key::Mass)).map(|(_, ratio)| ratio).product();
    let coupled = case.body.mass() * of_size;
    let ratio = match variable.key() {
        Key::Density => value / variable.value(inputs, case),
        _ => value / coupled,
    };
    if let Some(weight) = varied.number(Key::BuoyantWeight).filter(|_| !named(Key::BuoyantWeight)) {
        varied.set(Key::BuoyantWeight, weight + coupled * (ratio - 1.0) * case.gravity);
    }
    if let Some(inertia) = varied.number(Key::MomentOfInertia).filter(|_| !named(Key::MomentOfInertia)) {
        varied.set(Key::MomentOfInertia, inertia * ratio);
    }
}

/// The keys of a case whose numbers go with these when they are varied, each once; one of them that is varied itself among
/// them only if it is moved all the same.
pub fn moved(inputs: &Inputs, case: &Case, variables: &[&Variable]) -> Vec<Id> {
    let mut moved = CoupledChanges::default();
    for variable in variables {
        let present = variable.value(inputs, case);
        moved.add(variable, case, present, present);
    }
    let named = |id: Id| variables.iter().any(|variable| variable.id == id);
    let levels = moved.levels.iter().map(|(key, _)| Id::from(*key));
    let levels = levels.filter(|id| !named(*id) || id.key.info().moves == Moves::Alone);
    let sizes = moved.sizes.iter().map(|(key, _)| Id::from(*key));
    let sized = sizes.chain(moved.scales.iter().map(|(id, _)| *id)).filter(|id| !named(*id));
    let mut ids: Vec<Id> = levels.chain(sized).filter(|id| inputs.number(*id).is_some()).collect();
    ids.sort();
    ids.dedup();
    if variables.iter().any(|variable| variable.moves_edges()) {
        ids.extend(stretching(case));
    }
    ids
}

/// The friction to slip beside a friction to stick: of the base, or of the same joint.
fn slipping(id: Id) -> Id {
    match id.key {
        Key::JointFriction => Id::new(Key::JointKineticFriction, id.index),
        _ => Id::from(Key::KineticFriction),
    }
}

/// Numbers that go with varied ones, and their changes.
#[derive(Default)]
struct CoupledChanges {
    levels: Vec<(Key, f64)>,
    sizes: Vec<(Key, f64)>,
    scales: Vec<(Id, f64)>,
}

impl CoupledChanges {
    fn add(&mut self, variable: &Variable, case: &Case, present: f64, value: f64) {
        let (by, ratio) = (value - present, value / present);
        match variable.moves {
            Moves::Alone => {}
            Moves::Width => {
                self.scale(
                    ratio,
                    &[
                        Key::Width,
                        Key::CaissonWidth,
                        Key::BaseLeft,
                        Key::BaseRight,
                        Key::CentroidOffset,
                        Key::WeightArm,
                    ],
                );
                // A cylinder is as long as it is wide.
                let weight = if case.body.plan() == Plan::Circle { ratio * ratio } else { ratio };
                self.scale(weight, &[Key::Mass, Key::BuoyantWeight, Key::MomentOfInertia]);
                if case.body.plan() == Plan::Circle {
                    self.scale(weight, &[Key::WaterMass]);
                }
            }
            Moves::Length => {
                self.scale(ratio, &[Key::Mass, Key::BuoyantWeight, Key::MomentOfInertia, Key::WaterMass])
            }
            Moves::Height => {
                self.level(by, &[Key::CrestHeight, Key::Height]);
                self.heighten(case, by);
            }
            // Weight and inertia follow from the mass that the size alone would give; see `weigh`.
            Moves::Mass => {
                self.scale(ratio, &[Key::Mass, Key::Density]);
                self.scale(1.0, &[Key::MomentOfInertia]);
                self.level(0.0, &[Key::BuoyantWeight]);
            }
            Moves::Friction => self.scales.push((slipping(variable.id), ratio)),
            Moves::WaterDensity => self.scale(ratio, &[Key::WaterDensity, Key::WaveWaterDensity]),
            Moves::WaterLevel => {
                self.level(by, &[Key::Level, Key::WaterRight]);
                if variable.both_sides {
                    self.level(by, &[Key::WaterLeft]);
                }
                let depths = [Key::BaseDepth, Key::StillWaterLevel, Key::WaterDepth, Key::DepthAboveBerm];
                self.level(by, &depths);
                self.level(-by, &[Key::CrestHeight, Key::ArmourCrest, Key::BaseFreeboard]);
                self.drown(case, by);
            }
            Moves::BaseDepth => {
                self.level(by, &[Key::Level, Key::WaterRight, Key::Height, Key::StillWaterLevel]);
                self.heighten(case, by);
                self.drown(case, by);
            }
        }
    }

    fn level(&mut self, by: f64, keys: &[Key]) {
        self.levels.extend(keys.iter().map(|key| (*key, by)));
    }

    fn scale(&mut self, ratio: f64, keys: &[Key]) {
        self.scales.extend(keys.iter().map(|key| (Id::from(*key), ratio)));
    }

    /// Makes the body higher, at its density.
    fn heighten(&mut self, case: &Case, by: f64) {
        let body = &case.body;
        let ratio = (body.height() + by) / body.height();
        self.scale(ratio, &[Key::Mass, Key::CentroidHeight, Key::MomentOfInertia]);
        self.sizes.push((Key::BuoyantWeight, body.mass() * (ratio - 1.0) * case.gravity));
    }

    /// Takes the buoyancy of more water off a given buoyant weight.
    fn drown(&mut self, case: &Case, by: f64) {
        let Some((wave, depth)) = case.wave.as_ref().and_then(|wave| Some((wave, wave.still_water()?)))
        else {
            return;
        };
        let unit_weight = wave.water_density * case.gravity;
        let Some(section) = &case.section else {
            return self.level(-unit_weight * by * case.body.base_area(), &[Key::BuoyantWeight]);
        };
        // Of parts, more is wet as well.
        let weight = |depth: f64| {
            let wet = section.mass(Some(WaterTable { left: depth, right: depth }));
            wet.mass * case.gravity - unit_weight * section.below(depth).area
        };
        self.level(weight(depth + by) - weight(depth), &[Key::BuoyantWeight]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CaseFile;

    const CAISSON: &str = "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\nkinetic_friction = 0.5\n\
        buoyant_weight = 2318640\n[wave]\nH13 = 5.8\nHmax = 8.05\nperiod = 11.4\nsea_bottom_slope = 0.01\n\
        water_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\n\
        caisson_width = 15\nangle_deg = 15\nwater_density = 1030\n";

    fn varied(changes: &[(&str, f64)]) -> Inputs {
        let file = CaseFile::parse("t.toml", CAISSON).unwrap();
        let case = file.case().unwrap();
        let variables: Vec<_> =
            changes.iter().map(|(name, _)| Variable::find(name, file.inputs()).unwrap()).collect();
        let changes: Vec<_> = variables.iter().zip(changes.iter().map(|(_, value)| *value)).collect();
        vary(file.inputs(), &case, &changes)
    }

    fn close(inputs: &Inputs, expected: &[(Key, f64)]) {
        for &(key, value) in expected {
            let found = inputs.number(key).unwrap();
            assert!((found - value).abs() <= 1e-9 * value.abs(), "{key}: {found}, expected {value}");
        }
    }

    #[test]
    fn the_width_takes_the_mass_along() {
        let wider = varied(&[("width", 18.0)]);
        close(
            &wider,
            &[
                (Key::Width, 18.0),
                (Key::CaissonWidth, 18.0),
                (Key::Mass, 346050.0 * 1.2),
                (Key::BuoyantWeight, 2318640.0 * 1.2),
                (Key::Height, 10.5),
            ],
        );
        assert!(Case::of(&wider).is_ok());
    }

    #[test]
    fn the_sea_moves_depths_crest_and_buoyancy() {
        let higher = varied(&[("water_level", 8.1)]);
        close(
            &higher,
            &[
                (Key::BaseDepth, 8.1),
                (Key::WaterDepth, 11.1),
                (Key::DepthAboveBerm, 6.6),
                (Key::CrestHeight, 2.4),
                (Key::BuoyantWeight, 2318640.0 - 1030.0 * 9.81 * 15.0),
            ],
        );
        assert!(Case::of(&higher).is_ok());
    }

    /// Whatever the value, the two agree to the rounding of the product.
    #[test]
    fn a_density_given_twice_stays_one() {
        let weight = "buoyant_weight = 2318640\n";
        let text = CAISSON.replace(weight, "[water]\nlevel = 7.1\ndensity = 1030\n");
        let file = CaseFile::parse("t.toml", &text).unwrap();
        let case = file.case().unwrap();
        for name in ["water.density", "wave.water_density"] {
            let density = Variable::find(name, file.inputs()).unwrap();
            for value in 900..1200 {
                let varied = vary(file.inputs(), &case, &[(&density, f64::from(value))]);
                close(
                    &varied,
                    &[(Key::WaterDensity, f64::from(value)), (Key::WaveWaterDensity, f64::from(value))],
                );
                assert!(Case::of(&varied).is_ok(), "{name} = {value}");
            }
        }
    }

    /// A mass that is named and is the one that the size alone would give changes nothing, whatever else is given.
    #[test]
    fn naming_the_mass_that_follows_changes_nothing() {
        let heavy = |changes: &[(&str, f64)], text: &str| {
            let file = CaseFile::parse("t.toml", text).unwrap();
            let case = file.case().unwrap();
            let variables: Vec<_> =
                changes.iter().map(|(name, _)| Variable::find(name, file.inputs()).unwrap()).collect();
            let changes: Vec<_> = variables.iter().zip(changes.iter().map(|(_, value)| *value)).collect();
            vary(file.inputs(), &case, &changes)
        };
        let inertia = CAISSON.replace("mass = 346050", "mass = 346050\nmoment_of_inertia = 9e6");
        let by_density = inertia.replace("mass = 346050", "density = 2197.142857142857");
        for text in [inertia, by_density] {
            for size in [[("width", 18.0), ("friction", 0.6)], [("height", 12.0), ("width", 12.0)]] {
                let alone = heavy(&size, &text);
                let mass = Case::of(&alone).unwrap().body.mass();
                let named = heavy(&[size[0], ("mass", mass), size[1]], &text);
                for (id, expected) in alone.numbers() {
                    let found = named.number(id).unwrap();
                    assert!(
                        (found - expected).abs() <= 1e-9 * expected.abs(),
                        "{id}: {found}, expected {expected}"
                    );
                }
                // A tonne more weighs as much more.
                let more = heavy(&[size[0], ("mass", mass + 1e3), size[1]], &text);
                let weight = |inputs: &Inputs| inputs.number(Key::BuoyantWeight).unwrap();
                assert!((weight(&more) - weight(&alone) - 9810.0).abs() < 1e-3);
            }
        }
    }

    /// Several at once: named first, then levels, then scales, in whatever order they are named.
    #[test]
    fn the_order_of_names_does_not_matter() {
        let changes = [
            ("width", 18.0),
            ("water_level", 8.1),
            ("mass", 400e3),
            ("friction", 0.3),
            ("wave.water_depth", 12.0),
        ];
        let forth = varied(&changes);
        let mut reversed = changes;
        reversed.reverse();
        assert_eq!(forth.numbers().collect::<Vec<_>>(), varied(&reversed).numbers().collect::<Vec<_>>());
        close(
            &forth,
            &[
                // Named, and not scaled with the width.
                (Key::Mass, 400e3),
                // Named, and raised with the sea.
                (Key::WaterDepth, 13.0),
                (Key::KineticFriction, 0.25),
                // The water displaced, then as much wider, and the weight added to what is as wide.
                (
                    Key::BuoyantWeight,
                    (2318640.0 - 1030.0 * 9.81 * 15.0) * 1.2 + (400e3 - 346050.0 * 1.2) * 9.81,
                ),
            ],
        );
        // What is named does not grow with the body.
        for (size, value) in [("height", 11.5), ("width", 18.0)] {
            close(&varied(&[(size, value), ("body.buoyant_weight", 2.5e6)]), &[(Key::BuoyantWeight, 2.5e6)]);
        }
        // A number that moves others keeps its own value.
        close(
            &varied(&[("height", 12.0), ("crest_height", 3.0)]),
            &[(Key::Height, 12.0), (Key::CrestHeight, 3.0)],
        );
    }
}
