//! Soil beside the body, and the loads that it makes: its pressure, its surcharge, what an earthquake adds.

use standfast::loads::earth::{
    Backfill, EarthIncrement, EarthPressure, EarthState, GroundWater, PoreWater, Shaking, Soil, SoilLayer,
};
use standfast::loads::{Earthquake, Face, Load, LoadSource};
use standfast::section::WaterTable;
use standfast::{Body, Scalar};

use super::LoadOrigin;
use super::loads::{FacePressure, PointForce};
use super::reader::Reader;
use crate::error::{Fault, Place, Problem};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};

/// Soil beside the body, with the water that stands in it.
#[derive(Debug, Clone, PartialEq)]
pub struct SoilFill {
    /// Its name.
    pub name: String,
    /// The names of what it makes beside its pressure, in the order of [`Made`].
    made: [String; 2],
    /// The soil.
    pub soil: Backfill,
    /// Water in it.
    pub water: Option<GroundWater>,
    /// Its pressure on the body.
    pub pressure: EarthPressure,
}

/// What a soil makes beside its own pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Made {
    /// What its surcharge adds.
    Surcharge,
    /// What an earthquake adds.
    Earthquake,
}

impl Made {
    const ALL: [Made; 2] = [Made::Surcharge, Made::Earthquake];

    /// Name behind that of the soil.
    fn name(self) -> &'static str {
        match self {
            Made::Surcharge => "surcharge",
            Made::Earthquake => "earthquake",
        }
    }
}

/// The name of a soil that has none.
const UNNAMED: &str = "backfill";

/// Words behind the name of a soil for what it drags down.
const DRAG: &str = ", drag";

/// The name of the soil that a load is of, and what of it, where that is not its own pressure; `None` of another load.
pub fn soil_of(load: &Load) -> Option<(&str, Option<Made>)> {
    let name = load.name.as_deref()?;
    let name = match load.source {
        LoadSource::EarthPressure => name,
        LoadSource::EarthDrag => name.strip_suffix(DRAG)?,
        _ => return None,
    };
    // Its own pressure is there all the time, and the name of a soil may have any dots.
    let made = Made::ALL.into_iter().filter(|_| !load.permanent);
    let mut made = made.filter_map(|made| Some((name.strip_suffix(made.name())?.strip_suffix('.')?, made)));
    Some(made.next().map_or((name, None), |(name, made)| (name, Some(made))))
}

impl SoilFill {
    /// Name of what it makes.
    pub fn made(&self, made: Made) -> &str {
        &self.made[made as usize]
    }

    /// Name of the push of its water in an earthquake.
    pub fn pore_water(&self) -> String {
        format!("{}, pore water", self.name)
    }

    /// True if it resists the body, rather than loads it.
    pub fn is_passive(&self) -> bool {
        self.soil.state == EarthState::Passive
    }

    /// Names of what it makes that a combination may name.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        let loads = !self.is_passive();
        let surcharge = (self.soil.surcharge > 0.0).then(|| self.made(Made::Surcharge));
        let names = [Some(&*self.name), surcharge, Some(self.made(Made::Earthquake))];
        names.into_iter().flatten().filter(move |_| loads)
    }

    /// What an acceleration of the base adds; `None` where it moves the body away from the soil, or the soil does not hold.
    pub fn increment(&self, earthquake: &Earthquake, gravity: f64) -> Option<EarthIncrement> {
        let shaking = shaking(self.soil.face, earthquake, gravity).filter(|_| !self.is_passive())?;
        self.soil.increment(self.water, shaking).ok()
    }

    /// The loads on `body`, beside the place of the table: of the soil and its surcharge, and of an earthquake.
    pub(super) fn loads(
        &self,
        index: usize,
        body: &Body,
        gravity: f64,
        earthquake: Option<&Earthquake>,
    ) -> Vec<(LoadOrigin, Load)> {
        let SoilFill { soil, pressure, .. } = self;
        let named = |loads: Vec<Load>, name: &str| -> Vec<Load> {
            let named = loads.into_iter().map(|load| match load.source {
                LoadSource::EarthDrag => load.named(format!("{name}{DRAG}")),
                _ => load.named(name),
            });
            named.collect()
        };
        let variable = |loads: Vec<Load>| -> Vec<Load> {
            loads.into_iter().map(|load| Load { permanent: false, ..load }).collect()
        };
        let mut loads: Vec<(LoadOrigin, Load)> = Vec::new();
        if self.is_passive() {
            return loads;
        }
        let mut add = |of: LoadOrigin, more: Vec<Load>| loads.extend(more.into_iter().map(|load| (of, load)));
        add(LoadOrigin::Soil(index, None), named(soil.loads(&pressure.soil), &self.name));
        if !pressure.surcharge.is_empty() {
            let of = soil.loads(&pressure.surcharge);
            let made = Made::Surcharge;
            add(LoadOrigin::Soil(index, Some(made)), variable(named(of, self.made(made))));
        }
        if let Some(increment) = earthquake.and_then(|earthquake| self.increment(earthquake, gravity)) {
            let made = Made::Earthquake;
            let of = LoadOrigin::Soil(index, Some(made));
            let shaken = variable(named(soil.loads(&increment.points), self.made(made)));
            add(of, shaken.into_iter().map(Load::fast).collect());
            if let Some(pore) = increment.pore_water {
                let pore = soil.pore_load(body, pore).named(self.pore_water());
                add(of, vec![pore.fast()]);
            }
        }
        loads
    }
}

/// An acceleration of the base as a soil at a face sees it; `None` where it moves the body away from the soil.
fn shaking(face: Face, earthquake: &Earthquake, gravity: f64) -> Option<Shaking> {
    let towards = match face {
        Face::Left => -earthquake.horizontal(),
        _ => earthquake.horizontal(),
    };
    let shaking = Shaking { horizontal: towards / gravity, gravity: 1.0 + earthquake.vertical() / gravity };
    (towards > 0.0 && shaking.gravity > 0.0).then_some(shaking)
}

impl Reader<'_> {
    /// The names of soils, and of what they make; the place of the table of each.
    pub(super) fn soil_name(&self, index: usize) -> String {
        let name = self.inputs.text(Id::of(Table::Backfill, index, Key::BackfillName));
        name.unwrap_or(UNNAMED).to_owned()
    }

    /// A soil beside `body`, in water up to the line of `water` whose unit weight is `unit_weight`.
    pub(super) fn backfill(
        &self,
        index: usize,
        body: &Body,
        water: Option<(WaterTable, f64)>,
    ) -> Result<SoilFill, Fault> {
        let id = |key| Id::of(Table::Backfill, index, key);
        let number = |key| self.inputs.number(id(key));
        let name = self.soil_name(index);
        let face = match self.inputs.choice(id(Key::BackfillFace)) {
            Some("left") => Face::Left,
            Some(_) => Face::Right,
            None => return Err(self.missing_in(id(Key::BackfillFace))),
        };
        let top = number(Key::BackfillTop).unwrap_or(body.height());
        if !body.reaches(top) {
            let problem = Problem::AboveCrest { key: Key::BackfillTop, height: body.height() };
            return Err(Fault::new(problem, id(Key::BackfillTop)));
        }
        let water = water.map(|(table, unit_weight)| GroundWater {
            level: if face == Face::Left { table.left } else { table.right },
            unit_weight,
        });
        let soil = Backfill {
            face,
            top,
            state: match self.inputs.choice(id(Key::BackfillState)) {
                Some("rest") => EarthState::AtRest,
                Some("passive") => EarthState::Passive,
                _ => EarthState::Active,
            },
            slope_deg: number(Key::BackfillSlope).unwrap_or(0.0),
            batter_deg: number(Key::BackfillBatter).unwrap_or(0.0),
            surcharge: number(Key::BackfillSurcharge).unwrap_or(0.0),
            layers: self.layers(index, top)?,
            pore_water: match self.inputs.choice(id(Key::PoreWaterMoves)) {
                Some("with-soil") => PoreWater::WithSoil,
                _ => PoreWater::Free,
            },
            increment_at: number(Key::IncrementAt).unwrap_or(0.6),
        };
        self.stands(index, &soil, water)?;
        if soil.state != EarthState::Passive && number(Key::BackfillShare).is_some() {
            return Err(Fault::new(Problem::ShareOfPush { name }, id(Key::BackfillShare)));
        }
        let made = Made::ALL.map(|made| format!("{name}.{}", made.name()));
        let pressure = soil.pressure(water);
        Ok(SoilFill { name, made, soil, water, pressure })
    }

    /// No load is called as the program calls what it makes of a soil, or as what holds the body.
    pub(super) fn no_made_name(
        &self,
        soils: &[SoilFill],
        forces: &[PointForce<impl Scalar>],
        pressures: &[FacePressure<impl Scalar>],
    ) -> Result<(), Fault> {
        let of_forces = forces.iter().map(|force| {
            let key = if force.of.0 == Table::Load { Key::LoadName } else { Key::MomentName };
            (&force.name, Id::new(key, force.of.1))
        });
        let of_pressures = pressures.iter().enumerate();
        let of_pressures =
            of_pressures.map(|(index, pressure)| (&pressure.name, Id::new(Key::PressureName, index)));
        let resistances =
            (0..self.inputs.count(Table::Resistance)).map(|index| Id::new(Key::ResistanceName, index));
        let resistances: Vec<(&str, Id)> =
            resistances.filter_map(|id| Some((self.inputs.text(id)?, id))).collect();
        let named = of_forces.chain(of_pressures).filter_map(|(name, id)| Some((name.as_deref()?, id)));
        for (name, id) in named.chain(resistances.iter().copied()) {
            if soils.iter().any(|soil| soil.made.iter().any(|made| made == name)) {
                return Err(Fault::new(Problem::MadeName { name: name.to_owned() }, id));
            }
            let soil = soils.iter().any(|soil| soil.name == name);
            let held = id.key != Key::ResistanceName && resistances.iter().any(|(other, _)| *other == name);
            if held || soil && id.key == Key::ResistanceName {
                return Err(Fault::new(Problem::SameName { name: name.to_owned() }, id));
            }
        }
        Ok(())
    }

    /// The layers of a soil as high as `height`: its own keys, or its tables of layers.
    fn layers(&self, index: usize, height: f64) -> Result<Vec<SoilLayer>, Fault> {
        let tables = self.inputs.tables_in(Table::BackfillLayer, index);
        if tables.is_empty() {
            let soil = self.soil_in(Table::Backfill, index)?;
            return Ok(vec![SoilLayer { soil, thickness: height }]);
        }
        let own = self.inputs.values().map(|(id, _)| id).find(|id| {
            (id.table, id.index) == (Table::Backfill, index) && id.key.info().table == Table::Soil
        });
        if let Some(id) = own {
            let problem = Problem::SoilBesideLayers { name: self.soil_name(index), key: id.key };
            return Err(Fault::new(problem, id));
        }
        let layer = |place: &usize| {
            let id = Id::of(Table::BackfillLayer, *place, Key::LayerThickness);
            let thickness = self.inputs.number(id).ok_or_else(|| self.missing_in(id))?;
            Ok(SoilLayer { soil: self.soil_in(Table::BackfillLayer, *place)?, thickness })
        };
        let layers = tables.iter().map(layer).collect::<Result<Vec<_>, Fault>>()?;
        let thickness: f64 = layers.iter().map(|layer| layer.thickness).sum();
        if thickness < height - 1e-6 {
            let problem = Problem::LayersShort { name: self.soil_name(index), thickness, height };
            return Err(Fault::new(problem, Place::Table(Table::Backfill, index)));
        }
        Ok(layers)
    }

    fn soil_in(&self, table: Table, index: usize) -> Result<Soil, Fault> {
        let id = |key| Id::of(table, index, key);
        let number = |key| self.inputs.number(id(key));
        let needed = |key| number(key).ok_or_else(|| self.missing_in(id(key)));
        Ok(Soil {
            friction_angle_deg: needed(Key::SoilFriction)?,
            wall_friction_deg: number(Key::WallFriction).unwrap_or(0.0),
            unit_weight: needed(Key::SoilWeight)?,
            unit_weight_saturated: number(Key::SaturatedWeight),
            unit_weight_dry: number(Key::DryWeight),
            cohesion: number(Key::SoilCohesion).unwrap_or(0.0),
            adhesion: number(Key::SoilAdhesion).unwrap_or(0.0),
            ocr: number(Key::Overconsolidation).unwrap_or(1.0),
        })
    }

    /// What of a soil goes together.
    fn stands(&self, index: usize, soil: &Backfill, water: Option<GroundWater>) -> Result<(), Fault> {
        let tables = tables_of_layers(self.inputs, index);
        for (layer, (SoilLayer { soil: of, .. }, (table, place))) in
            soil.layers.iter().zip(tables).enumerate()
        {
            let id = |key| Id::of(table, place, key);
            let φ = of.friction_angle_deg;
            if soil.slope_deg >= φ {
                let problem = Problem::SlopeBeyondFriction {
                    name: self.soil_name(index),
                    slope: soil.slope_deg,
                    friction: φ,
                };
                let slope = Id::of(Table::Backfill, index, Key::BackfillSlope);
                return Err(Fault::new(problem, slope).and(id(Key::SoilFriction)));
            }
            if of.wall_friction_deg.abs() > φ {
                let problem =
                    Problem::WallFrictionBeyondFriction { wall: of.wall_friction_deg, friction: φ };
                return Err(Fault::new(problem, id(Key::WallFriction)).and(id(Key::SoilFriction)));
            }
            let Some(GroundWater { level, unit_weight }) =
                water.filter(|water| soil.is_wet(layer, water.level))
            else {
                continue;
            };
            match of.unit_weight_saturated {
                None => {
                    let problem = Problem::SaturatedWeightMissing { level };
                    return Err(Fault::new(problem, Place::Table(table, place)));
                }
                Some(saturated) if saturated <= unit_weight => {
                    let problem = Problem::SoilFloats { saturated, water: unit_weight };
                    return Err(Fault::new(problem, id(Key::SaturatedWeight)));
                }
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// Every soil holds under the accelerations of the base that are tried.
    pub(super) fn soils_hold(
        &self,
        soils: &[SoilFill],
        tried: &[Earthquake],
        gravity: f64,
    ) -> Result<(), Fault> {
        for (index, fill) in soils.iter().enumerate() {
            for earthquake in tried {
                let Some(shaking) = shaking(fill.soil.face, earthquake, gravity) else { continue };
                if let Err(steep) = fill.soil.increment(fill.water, shaking) {
                    let problem = Problem::TooSteepForEarthquake {
                        name: fill.name.clone(),
                        horizontal: shaking.horizontal,
                        greatest: steep.greatest,
                    };
                    let at = Place::Table(Table::Backfill, index);
                    return Err(Fault::new(problem, Key::Horizontal).and(at));
                }
            }
        }
        Ok(())
    }
}

/// The tables that say the layers of a fill, from the top, with their places: its own, or one for each layer.
pub(crate) fn tables_of_layers(inputs: &Inputs, index: usize) -> Vec<(Table, usize)> {
    match inputs.tables_in(Table::BackfillLayer, index) {
        layers if layers.is_empty() => vec![(Table::Backfill, index)],
        layers => layers.into_iter().map(|place| (Table::BackfillLayer, place)).collect(),
    }
}

/// The keys of the soil of a fill, of all its layers, that are one angle or strength by name: those of the fill itself, or of each layer.
pub(super) fn of_all_layers(inputs: &Inputs, id: Id) -> Vec<Id> {
    if id.table != Table::Backfill || id.key.info().table != Table::Soil {
        return vec![id];
    }
    tables_of_layers(inputs, id.index)
        .into_iter()
        .map(|(table, place)| Id::of(table, place, id.key))
        .collect()
}
