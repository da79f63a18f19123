//! The base of a case seen from above, and the directions and places of what acts on it.

use standfast::footprint::{Footprint, FootprintError, towards};
use standfast::loads::{Across, Action, Earthquake, Load};
use standfast::{Body, Plan, PlanBase, Scalar, Section};

use super::Case;
use super::loads::Direction;
use super::reader::Reader;
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};

/// A base seen from above.
#[derive(Debug, Clone, PartialEq)]
pub struct CasePlan<T = f64> {
    /// What asks for it.
    pub said_by: Place,
    /// Where the body bears, from the point under its centre of mass.
    pub base: PlanBase<T>,
    /// How the file says where it bears.
    pub of: PlanOf,
    /// True if the base is shaken in all directions, of which the worst counts.
    pub is_worst: bool,
    /// True if the base is shaken in one direction of its own.
    pub is_one_direction: bool,
}

/// Source of a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanOf {
    /// Width by length of the body, or its circle.
    Body,
    /// Corners of a polygon, so many.
    Polygon(usize),
    /// Feet, so many.
    Feet(usize),
    /// A disc.
    Circle,
}

/// Direction and place of a force seen from above.
#[derive(Debug, Clone, PartialEq)]
pub struct Turned<T = f64> {
    /// Degrees from left over away from the viewer to right; `None` of a force up or down, or in the plane.
    pub direction_deg: Option<f64>,
    /// Along the length, away from its middle, m.
    pub z: T,
}

impl<T> CasePlan<T> {
    /// Refusal of something that is not answered on a base seen from above.
    pub fn not_for(&self, what: &'static str) -> Fault {
        Fault::new(Problem::PlanNotFor { what }, self.said_by)
    }
}

impl<T: Scalar> CasePlan<T> {
    /// The acceleration of a base that pushes the body across an edge, as much as the one given to the side.
    pub(super) fn shaken_across(&self, edge: usize, given: &Earthquake<T>) -> Earthquake<T> {
        let normals = self.base.footprint.rounded().normals();
        let [x, z] = normals[edge].map(exact_or_computed);
        let size = T::of(0.0) - given.horizontal();
        let across = Earthquake::new(size.clone() * x, given.vertical());
        across.and_then(|across| across.with_away(size * z)).unwrap_or_else(|_| given.clone())
    }
}

/// A share of a length, which is exact where it is none or all of it.
fn exact_or_computed<T: Scalar>(share: f64) -> T {
    if share == 0.0 || share.abs() == 1.0 { T::of(share) } else { T::computed(share) }
}

impl<T: Scalar> Turned<T> {
    /// The load as it is seen from above.
    pub(super) fn turn(&self, load: Load<T>, magnitude: T) -> Load<T> {
        let z = Some(self.z.clone());
        let (Some(degrees), Action::Force { at, up, .. }) = (self.direction_deg, &load.action) else {
            return load.across(Across { away: T::of(0.0), z });
        };
        let [right, away] = towards(degrees).map(|share| exact_or_computed::<T>(share) * magnitude.clone());
        let action = Action::Force { at: at.clone(), right, up: up.clone() };
        Load { action, ..load }.across(Across { away, z })
    }
}

impl<T: Scalar> Case<T> {
    /// A load of still water, which acts in the middle of the length.
    pub(super) fn at_mid_length(&self, load: Load<T>) -> Load<T> {
        match &self.plan {
            Some(_) => load.across(Across { away: T::of(0.0), z: Some(T::of(0.0)) }),
            None => load,
        }
    }
}

/// Criteria that a base seen from above has an answer to.
pub(super) const CRITERIA: [Key; 7] = [
    Key::LeastSliding,
    Key::LeastOverturningNet,
    Key::LeastLoadFactor,
    Key::GreatestNotRest,
    Key::GreatestLife,
    Key::GreatestAny,
    Key::LeastLifeIndex,
];

impl Case {
    /// Refuses criteria that a base seen from above has no answer to.
    pub(super) fn criteria_fit_plan(&self) -> Result<(), Fault> {
        let Some(plan) = &self.plan else { return Ok(()) };
        let asked = self.all_criteria().into_iter().map(|criterion| criterion.key);
        let of_motion = Key::ALL.iter().copied().filter(|key| key.is_of_motion());
        let of_motion = of_motion.filter(|key| self.inputs().get(*key).is_some());
        match asked.chain(of_motion).find(|key| !CRITERIA.contains(key)) {
            Some(key) => {
                let at = match self.inputs().get(key) {
                    Some(_) => Place::Key(key.into()),
                    None => plan.said_by,
                };
                Err(Fault::new(Problem::PlanNotFor { what: key.name() }, at))
            }
            None => Ok(()),
        }
    }

    /// Loads that turn the body about the vertical, on a base that has no one answer to that, are refused.
    pub(super) fn no_torsion(&self) -> Result<(), Fault> {
        if self.plan.is_none() {
            return Ok(());
        }
        for acting in self.acting() {
            for trial in self.trials(acting) {
                let Ok(situation) = self.situation(acting, trial) else { continue };
                let Some(torsion) = situation.torsion() else { continue };
                let inputs = self.inputs();
                let keys = [Key::LoadZ, Key::LoadDirectionDeg, Key::CentroidZ];
                let given = |id: &Id| inputs.get(*id).is_some();
                let mut said = keys.into_iter().flat_map(|key| {
                    let count = inputs.count(key.info().table);
                    (0..count).map(move |index| Id::new(key, index))
                });
                let at = said.find(given).map_or(Place::Table(Table::Top, 0), Place::Key);
                return Err(Fault::new(Problem::TorsionNotFor { moment: torsion.moment }, at));
            }
        }
        Ok(())
    }
}

impl Reader<'_> {
    /// The key or table for which the base is seen from above; `None` of a case in the plane of its section.
    pub(super) fn seen_from_above(&self) -> Option<Place> {
        let tables =
            [Table::Footprint, Table::BaseHorizontalZ].into_iter().filter(|table| self.inputs.has(*table));
        let keys = [Key::CentroidZ, Key::HorizontalZ, Key::EarthquakeDirection].map(Id::from);
        let of_loads = (0..self.inputs.count(Table::Load))
            .flat_map(|index| [Key::LoadDirectionDeg, Key::LoadZ].map(|key| Id::new(key, index)));
        let keys = keys.into_iter().chain(of_loads).filter(|id| self.inputs.get(*id).is_some());
        tables.map(|table| Place::Table(table, 0)).chain(keys.map(Place::Key)).next()
    }

    /// The base seen from above, of a case that asks for it.
    pub(super) fn footprint<T: Scalar>(
        &self,
        body: &Body<T>,
        section: Option<&Section>,
    ) -> Result<Option<CasePlan<T>>, Fault> {
        let Some(place) = self.seen_from_above() else { return Ok(None) };
        self.goes_with_plan(place)?;
        let half = || T::of(2.0);
        let is_disc = body.plan() == Plan::Circle;
        let length = match body.plan() {
            Plan::Rectangle { length } if self.inputs.get(Key::Length).is_some() => Some(length),
            _ if is_disc => None,
            _ => return Err(Fault::new(Problem::PlanNeedsLength, place)),
        };
        // From mid-width, or from the origin of the section of parts.
        let origin = section.map_or(0.0, |section| {
            let [left, right] = section.ends();
            (left + right) / 2.0
        });
        let centroid_z: T = self.scalar(Key::CentroidZ).unwrap_or_else(|| T::of(0.0));
        let x_c = exact_or_computed::<T>(origin) + body.centroid_offset();
        let from_c = |[x, z]: [T; 2]| [x - x_c.clone(), z - centroid_z.clone()];
        let mid = || exact_or_computed::<T>(origin);
        let given =
            [Key::BasePolygon, Key::BaseFeet, Key::BaseCircle].map(|key| self.inputs.get(key).is_some());
        let two = |one, two| Err(Fault::new(Problem::Both { one, two }, Id::from(two)));
        let (footprint, of, key) = match given {
            [true, true, _] => return two(Key::BasePolygon, Key::BaseFeet),
            [true, _, true] => return two(Key::BasePolygon, Key::BaseCircle),
            [_, true, true] => return two(Key::BaseFeet, Key::BaseCircle),
            [false, false, true] => {
                let radius = self.needed::<T>(Key::BaseCircle)? / half();
                let disc = Footprint::circle(from_c([mid(), T::of(0.0)]), radius);
                (disc, PlanOf::Circle, Some(Key::BaseCircle))
            }
            [false, false, false] => {
                if self.inputs.has(Table::Footprint) {
                    let problem = Problem::Neither { one: Key::BasePolygon, two: Key::BaseFeet };
                    return Err(Fault::new(problem, Table::Footprint));
                }
                let edges = body.base_edges();
                let of_body = match length {
                    Some(length) => {
                        let (left, right) = (mid() - edges.left, mid() + edges.right);
                        let far = length / half();
                        let near = T::of(0.0) - far.clone();
                        let corners = [(&left, &near), (&right, &near), (&right, &far), (&left, &far)];
                        let corners = corners.map(|(x, z)| from_c([x.clone(), z.clone()]));
                        Footprint::polygon(&corners)
                    }
                    None => Footprint::circle(from_c([mid(), T::of(0.0)]), body.base_width() / half()),
                };
                (of_body, PlanOf::Body, None)
            }
            [is_polygon, _, _] => {
                let key = if is_polygon { Key::BasePolygon } else { Key::BaseFeet };
                let numbers = self.inputs.list(key).unwrap_or_default();
                let element = |place: usize| self.inputs.element::<T>(key.into(), place, numbers[place]);
                let points: Vec<[T; 2]> = (0..numbers.len() / 2)
                    .map(|pair| from_c([element(2 * pair), element(2 * pair + 1)]))
                    .collect();
                let of = if is_polygon { PlanOf::Polygon(points.len()) } else { PlanOf::Feet(points.len()) };
                (Footprint::polygon(&points), of, Some(key))
            }
        };
        if let Some(other) =
            [Key::BaseLeft, Key::BaseRight].into_iter().find(|key| self.number(*key).is_some())
            && key.is_some()
        {
            return Err(Fault::new(Problem::PlanNotFor { what: other.name() }, Id::from(other)));
        }
        let at = key.map_or(place, |key| Place::Key(key.into()));
        let footprint =
            footprint.map_err(|error: FootprintError| Fault::new(Problem::PlanShape { error }, at))?;
        let rounded = footprint.rounded();
        let beside = rounded.distances().into_iter().fold(f64::INFINITY, f64::min);
        if beside <= 0.0 {
            return Err(Fault::new(Problem::CentroidBesideBase { beside: -beside }, at));
        }
        let direction = self.inputs.get(Key::EarthquakeDirection);
        let is_worst = self.inputs.choice(Key::EarthquakeDirection).is_some();
        if is_worst && self.inputs.get(Key::HorizontalFixed).is_some() {
            let problem = Problem::Both { one: Key::HorizontalFixed, two: Key::EarthquakeDirection };
            return Err(Fault::new(problem, Id::from(Key::HorizontalFixed)));
        }
        Ok(Some(CasePlan {
            said_by: place,
            base: PlanBase { footprint, centroid_z },
            of,
            is_worst,
            is_one_direction: direction.is_some() && !is_worst,
        }))
    }

    /// Refuses what is not answered on a plan, where there is one.
    fn goes_with_plan(&self, place: Place) -> Result<(), Fault> {
        const OTHERS: [(Table, &str); 14] = [
            (Table::Wave, "[wave]"),
            (Table::Uplift, "[uplift]"),
            (Table::Pressure, "[[pressure]]"),
            (Table::Backfill, "[[backfill]]"),
            (Table::Resistance, "[[resistance]]"),
            (Table::Moment, "[[moment]]"),
            (Table::Joint, "[[joint]]"),
            (Table::Ground, "[ground]"),
            (Table::AddedMass, "[added_mass]"),
            (Table::Drain, "a drain"),
            (Table::Impact, "[motion.impact]"),
            (Table::Initial, "[motion.initial]"),
            (Table::LoadHistory, "a load over time"),
            (Table::Storm, "[storm]"),
        ];
        let table = OTHERS.iter().find(|(table, _)| self.inputs.has(*table)).map(|(_, what)| *what);
        let has = |key: Key| self.inputs.get(key).is_some();
        let keys = [Key::Adhesion, Key::FloorDeg, Key::BuoyantWeight, Key::TMax];
        let key = keys.into_iter().find(|key| has(*key));
        let heads = has(Key::WaterLeft) || has(Key::WaterRight);
        let refused = table.or(key.map(Key::name)).or(heads.then_some("water levels of both sides"));
        match refused {
            Some(what) => Err(Fault::new(Problem::PlanNotFor { what }, place)),
            None => Ok(()),
        }
    }

    /// The direction and the place of a force seen from above.
    pub(super) fn turned<T: Scalar>(
        &self,
        index: usize,
        direction: Direction,
    ) -> Result<Option<Turned<T>>, Fault> {
        if self.seen_from_above().is_none() {
            return Ok(None);
        }
        let id = |key| Id::new(key, index);
        let given = self.inputs.number(id(Key::LoadDirectionDeg));
        if given.is_some() && self.inputs.get(id(Key::Towards)).is_some() {
            let problem = Problem::Both { one: Key::Towards, two: Key::LoadDirectionDeg };
            return Err(Fault::new(problem, id(Key::LoadDirectionDeg)));
        }
        let z = self.inputs.scalar(id(Key::LoadZ)).unwrap_or_else(|| T::of(0.0));
        let direction_deg = given.filter(|_| matches!(direction, Direction::Sideways(_)));
        Ok(Some(Turned { direction_deg, z }))
    }

    /// An earthquake with its share out of the plane of the section.
    pub(super) fn earthquake_across<T: Scalar>(&self, given: Earthquake<T>) -> Result<Earthquake<T>, Fault> {
        let away: Option<T> = self.scalar(Key::HorizontalZ);
        let turned = self.number(Key::EarthquakeDirection);
        if away.is_some() && self.inputs.get(Key::EarthquakeDirection).is_some() {
            let problem = Problem::Both { one: Key::HorizontalZ, two: Key::EarthquakeDirection };
            return Err(Fault::new(problem, Key::EarthquakeDirection));
        }
        let across = match (away, turned) {
            (Some(away), _) => given.with_away(away),
            (None, Some(degrees)) => {
                // The body is pushed against the acceleration of its base.
                let size = T::of(0.0) - given.horizontal();
                let [x, z] = towards(degrees).map(exact_or_computed::<T>);
                let turned = Earthquake::new(size.clone() * x, given.vertical());
                turned.and_then(|turned| turned.with_away(size * z))
            }
            (None, None) => Ok(given),
        };
        across.map_err(|error| {
            Fault::new(Problem::Impossible { key: Key::HorizontalZ, error }, Key::HorizontalZ)
        })
    }
}
