//! Warnings that a case has, and their limits.

use std::fmt;

use standfast::contact::opening::OpeningState;
use standfast::loads::earth::EarthState;
use standfast::loads::{Action, Face};
use standfast::wave::Heights;
use standfast::{BaseEdges, BaseOpening, Bearing, Outcome, Plan, Situation, Slip};

use super::Warning;
use crate::case::{
    Acting, Case, CaseJoint, CasePlan, CrownWaves, Direction, FacePressure, GodaWaves, Made, Resistance,
    SoilFill, Trial, WaveFormula, Weight, said_by, tables_of_layers,
};
use crate::criteria::Bound;
use crate::error::Place;
use crate::key::{Id, Key, Table};
use crate::units::Extent;

/// Usual range of a value, both ends included.
pub(crate) struct Usual {
    from: f64,
    to: f64,
}

/// Relative error of a number that was multiplied and divided again.
const ROUNDING: f64 = 1e-12;

impl Usual {
    pub(crate) fn contains(&self, value: f64) -> bool {
        (self.from * (1.0 - ROUNDING)..=self.to * (1.0 + ROUNDING)).contains(&value)
    }

    /// The limit that a value outside is beyond.
    pub(super) fn limit(&self, value: f64) -> f64 {
        if value < self.from { self.from } else { self.to }
    }
}

impl fmt::Display for Usual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {}", self.from, self.to)
    }
}

/// Of bodies that are built, from light concrete or cells filled with water to stone, kg/m³.
pub(super) const DENSITY: Usual = Usual { from: 1000.0, to: 3000.0 };

/// Of objects, from an empty cabinet or tank to bronze, kg/m³.
pub(super) const OBJECT: Usual = Usual { from: 50.0, to: 9000.0 };

/// Difference that a weight less buoyancy may have from that of the parts, as a share.
const OF_PARTS: f64 = 0.01;

/// Of water, from warm and fresh to brine, kg/m³.
pub(super) const WATER: Usual = Usual { from: 950.0, to: 1100.0 };

/// On the ground, wherever it is, m/s².
pub(super) const GRAVITY: Usual = Usual { from: 9.7, to: 9.9 };

/// Hmax/H13: 1.8 by Goda's practice; less where the largest waves break, more in a long storm.
pub(super) const HEIGHTS: Usual = Usual { from: 1.4, to: 2.2 };

/// The largest friction between a body and its base.
pub(super) const FRICTION: f64 = 1.0;

/// Peak accelerations of a base that is shaken, in multiples of that of gravity: from one that hardly anybody feels to more than any
/// that was recorded on the ground.
pub(crate) const SHAKING: Usual = Usual { from: 0.01, to: 3.0 };

/// Radius of gyration over the diagonal: 0.289 of a uniform rectangle, up to 0.5 of masses in the corners of one.
pub(super) const GYRATION: Usual = Usual { from: 0.2, to: 0.7 };

/// Height over width, from a raft to a mast.
pub(super) const SLENDER: Usual = Usual { from: 0.05, to: 50.0 };

/// Angle to the normal of the wall up to which data of Goda's formulas go, degrees.
pub(super) const OBLIQUE: f64 = 60.0;

/// The largest unit weight of ground less that of the water in it, kN/m³.
pub(super) const SUBMERGED: f64 = 13.0;

/// Unit weight of a soil under water less that of the water, kN/m³.
pub(super) const BUOYANT: Usual = Usual { from: 7.0, to: 13.0 };

/// A pressure below this is none of a structure, Pa.
const PRESSURE: f64 = 100.0;

/// A force below this share of the weight does next to nothing: the body would bear hundreds of it.
const FORCE: f64 = 2e-3;

/// Share of the least safety factor that a variable load is worth at least to be told of.
const FAVOUR: f64 = 1e-3;

/// A body with such factors is safe without the load, too.
const SAFE: f64 = 2.0;

/// Distance from the body's edge that a force on it may have by rounding, m.
const SLACK: f64 = 1e-6;

/// The smallest pressure that the ground of a structure is asked to bear, kPa: soft clay's.
pub(super) const BEARING: f64 = 20.0;

/// Strength at which a base crushes, from soft clay to the strongest stone, kPa.
pub(super) const STRENGTH: Usual = Usual { from: 20.0, to: 1e6 };

/// Undrained strength, from mud to the hardest clay, kPa.
pub(super) const UNDRAINED: Usual = Usual { from: 1.0, to: 2e3 };

/// Pressure over settlement, from the softest ground under a wide base to a joint in stone, MN/m³.
pub(super) const STIFFNESS: Usual = Usual { from: 0.1, to: 1e6 };

/// Effective unit weight of ground, from peat under water to dense gravel above it, kN/m³.
pub(super) const UNIT_WEIGHT: Usual = Usual { from: 1.0, to: 30.0 };

/// Error of a weight by the rounding of its digits, as a share of m g.
const ROUNDED: f64 = 1e-3;

/// Difference that the buoyancy taken off may have from that of the rectangle under water, as a share of it: toes, slots and
/// sloping faces change what a caisson displaces by less than a quarter, while to forget the buoyancy or to take it off twice
/// changes it by the whole. An error of a quarter of the buoyancy moves the factor against sliding of a caisson by some 15 %.
const SHAPE: f64 = 0.25;

/// Difference as a share of m g, for a body that stands in shallow water: there the buoyancy is less than what a rounded mass
/// is off.
const SHALLOW: f64 = 0.02;

impl Case {
    /// Warnings of unusual values in it.
    pub fn warnings(&self) -> Vec<Warning> {
        let of_case = self.of_all();
        let mut warnings = of_case.clone();
        for acting in self.acting() {
            let under = self.under(acting);
            if std::ptr::eq(under, self) {
                continue;
            }
            let name = self.acting_name(acting).unwrap_or_default();
            // What is told of the case is not told again; what is of all combinations together is not one's own.
            let new = under.of_all().into_iter().filter(|new| {
                !new.is_about_combinations() && !of_case.iter().any(|told| told.is_same_as(new))
            });
            let in_it = |warning| Warning::InCombination { name: name.clone(), warning: Box::new(warning) };
            warnings.extend(new.map(in_it));
        }
        warnings
    }

    /// Warnings of the numbers that it has for all situations.
    fn of_all(&self) -> Vec<Warning> {
        let mut warnings = self.base();
        warnings.extend(self.numbers());
        warnings.extend(self.buoyancy());
        warnings.extend(self.shaking());
        warnings.extend(self.waves());
        warnings.extend(self.forces());
        warnings.extend(self.pressures());
        warnings.extend(self.beside());
        warnings.extend(self.unanswered());
        warnings.extend(self.opened());
        warnings.extend(self.held());
        warnings.extend(self.joints_open());
        warnings.extend(self.recalled());
        warnings.extend(self.uplifted());
        warnings.extend(self.uplift_stays());
        warnings.extend(self.favourable());
        warnings.extend(self.asked());
        warnings.extend(self.ground());
        warnings.extend(self.unused().into_iter().filter_map(|place| match place {
            Place::Table(table, index) => Some(Warning::LoadInNoCombination { table, index }),
            Place::Key(_) | Place::Element(..) => None,
        }));
        warnings
    }

    /// About forces that miss the body.
    fn forces(&self) -> Vec<Warning> {
        let left = self.body.base_edges().left - self.body.width() / 2.0;
        let right = left + self.body.width();
        let beside_body = |distance: f64| (left - distance).max(distance - right);
        let off = self.forces.iter().filter_map(|force| {
            let lever = force.lever.clone()?;
            let above = force.elevation - self.body.height();
            let beside = force.distance.map_or(0.0, beside_body);
            let [above, beside] = [above, beside].map(|by| if by > SLACK { by } else { 0.0 });
            let id = Id::new(Key::LoadLever, force.of.1);
            (above > 0.0 || beside > 0.0).then_some(Warning::LoadOffTheBody { id, lever, above, beside })
        });
        let on_body = self.forces.iter().filter(|force| force.lever.is_none());
        let beside = on_body.filter_map(|force| {
            let distance = force.distance.filter(|_| !matches!(force.direction, Direction::Sideways(_)))?;
            let beside = beside_body(distance);
            let id = Id::new(Key::LoadDistance, force.of.1);
            (beside > SLACK).then_some(Warning::LoadBesideBody { id, distance, beside })
        });
        let mut warnings: Vec<Warning> = beside.chain(off).collect();
        let weight = self.body.mass() * self.gravity;
        let forces = self.forces.iter().map(|force| match force.direction {
            Direction::Turning(_) => (Table::Moment, force.of.1, force.magnitude, self.body.width()),
            _ => (Table::Load, force.of.1, force.magnitude, 1.0),
        });
        let limits = self.inputs.indices(Table::Resistance).into_iter().filter_map(|index| {
            let limit = self.inputs.number(Id::new(Key::ResistanceLimit, index))?;
            Some((Table::Resistance, index, limit, 1.0))
        });
        for (table, index, force, arm) in forces.chain(limits) {
            let share = force / (weight * arm);
            if force > 0.0 && share < FORCE {
                warnings.push(Warning::SmallForce { table, index, force, share });
            }
        }
        warnings
    }

    /// About pressures along faces.
    fn pressures(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        for keys in
            [&[Key::UpliftLeft, Key::UpliftRight][..], &[Key::Surcharge], &[Key::Cohesion], &[Key::Adhesion]]
        {
            let given = keys.iter().filter_map(|key| Some((*key, self.inputs.number(*key)?.abs())));
            let most = given.reduce(|most, next| if next.1 > most.1 { next } else { most });
            if let Some((key, pressure)) =
                most.filter(|(_, pressure)| *pressure > 0.0 && *pressure < PRESSURE)
            {
                warnings.push(Warning::SmallPressure { id: key.into(), pressure });
            }
        }
        for (index, given) in self.pressures.iter().enumerate() {
            let points = given.diagram.points();
            let pressure = points.iter().fold(0.0, |most: f64, point| most.max(point.pressure.abs()));
            if pressure > 0.0 && pressure < PRESSURE {
                warnings.push(Warning::SmallPressure { id: Id::new(Key::Pressures, index), pressure });
            }
            if let Some(water) = self.water.filter(|_| given.permanent) {
                let [here, beyond] = match given.face {
                    Face::Left => [water.left(), water.right()],
                    Face::Right => [water.right(), water.left()],
                    Face::Base | Face::Top => [0.0; 2],
                };
                if here < beyond {
                    let (face, low, high) = (given.face, here, beyond);
                    warnings.push(Warning::PressureAgainstWater { index, face, low, high });
                }
            }
            let upright = matches!(given.face, Face::Left | Face::Right);
            if let ([first, .., last], true) = (points, given.permanent && upright) {
                let lowest = if first.position <= last.position { [first, last] } else { [last, first] };
                let [foot, top] = lowest.map(|point| point.pressure);
                if foot < top {
                    warnings.push(Warning::PressureFallsWithDepth { index, foot, top });
                }
            }
        }
        warnings
    }

    /// About soil beside the body.
    fn beside(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let accelerations = self.accelerations();
        for (index, fill) in self.soils.iter().enumerate() {
            let name = || fill.name.clone();
            let own = |key| Id::of(Table::Backfill, index, key);
            let tables = tables_of_layers(&self.inputs, index);
            for (of, (table, place)) in fill.soil.layers.iter().zip(tables) {
                let id = |key| Id::of(table, place, key);
                for key in [Key::SoilWeight, Key::SaturatedWeight, Key::DryWeight] {
                    let value = self.inputs.number(id(key));
                    if let Some(value) = value.filter(|value| !UNIT_WEIGHT.contains(*value / 1e3)) {
                        warnings.push(Warning::UnusualGround { id: id(key), value });
                    }
                }
                for key in [Key::SoilCohesion, Key::SoilAdhesion] {
                    let pressure = self.inputs.number(id(key)).unwrap_or_default();
                    if pressure > 0.0 && pressure < PRESSURE {
                        warnings.push(Warning::SmallPressure { id: id(key), pressure });
                    }
                }
                let (wall, friction) = (of.soil.wall_friction_deg, of.soil.friction_angle_deg);
                // Along the slope of the ground it is that of the soil itself, on the upright through the heel.
                if wall > friction * (2.0 / 3.0) * (1.0 + ROUNDING) && wall != fill.soil.slope_deg {
                    warnings.push(Warning::WallFrictionHigh { id: id(Key::WallFriction), wall, friction });
                }
                if let Some(saturated) = of.soil.unit_weight_saturated {
                    let water = fill.water.map_or(9.81e3, |water| water.unit_weight);
                    let moist = of.soil.unit_weight;
                    if !BUOYANT.contains((saturated - water) / 1e3) || saturated < moist {
                        let id = id(Key::SaturatedWeight);
                        warnings.push(Warning::SaturatedWeightUnusual { id, saturated, moist, water });
                    }
                }
            }
            let pressure = fill.soil.surcharge;
            if pressure > 0.0 && pressure < PRESSURE {
                warnings.push(Warning::SurchargeSmall { id: own(Key::BackfillSurcharge), pressure });
            }
            let beside = |given: &FacePressure| given.permanent && given.face == fill.soil.face;
            if let Some(index) = self.pressures.iter().position(beside) {
                warnings.push(Warning::BackfillBesidePressure { name: name(), index });
            }
            if self.wave.is_some() && fill.soil.face == Face::Right {
                warnings.push(Warning::BackfillOnTheSeaSide { name: name() });
            }
            let shaken = accelerations.iter().filter_map(|given| fill.increment(given, self.gravity));
            let raised = shaken.flat_map(|increment| {
                let of_layers = increment.coefficients.into_iter().zip(&fill.pressure.coefficients);
                of_layers
                    .flat_map(|(both, still)| both.into_iter().flatten().map(|[k_e, _]| (still.k, k_e)))
                    .collect::<Vec<_>>()
            });
            if let Some((k, k_e)) = raised.max_by(|one, two| (one.1 / one.0).total_cmp(&(two.1 / two.0)))
                && k_e > 2.0 * k
            {
                warnings.push(Warning::StrongIncrement { name: name(), k, k_e });
            }
            if fill.soil.surcharge > 0.0 {
                let surcharge = fill.made(Made::Surcharge);
                let left_out = (0..self.combinations.len()).filter(|place| {
                    self.combinations[*place].factors.iter().all(|(named, _)| named != surcharge)
                });
                warnings.extend(left_out.map(|place| Warning::LoadNotActing {
                    name: surcharge.to_owned(),
                    combination: self.acting_name(Acting::Combination(place)).unwrap_or_default(),
                }));
            }
        }
        warnings
    }

    /// About what codes ask for and the case cannot answer.
    fn unanswered(&self) -> Vec<Warning> {
        let all = self.combinations.iter().enumerate();
        let unanswered = all.flat_map(|(index, combination)| {
            let name = self.acting_name(Acting::Combination(index)).unwrap_or_default();
            combination.unanswered.iter().map(move |criterion| Warning::CodeCriterionMissing {
                combination: name.clone(),
                code: combination.code.as_ref().map_or_else(String::new, |code| code.name().to_owned()),
                criterion: criterion.name(),
            })
        });
        unanswered.collect()
    }

    /// About water under a base that opens, in the situation of each set of loads that opens it most.
    fn opened(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if self.opening.is_none() {
            return warnings;
        }
        let base = self.body.base_width();
        let all = self.acting();
        // Under equal heads nothing follows.
        let may_open = |acting: &&Acting| {
            let case = self.under(**acting);
            case.follows_opening() || case.drain.is_some()
        };
        for acting in all.iter().filter(may_open).copied() {
            let tried = self.trials(acting).into_iter().filter_map(|trial| {
                self.situation(acting, trial).ok().and_then(|situation| situation.base_opening())
            });
            let least =
                |one: &BaseOpening, two: &BaseOpening| one.contact(base).total_cmp(&two.contact(base));
            let Some(opening) = tried.min_by(least) else { continue };
            let situation = self.acting_name(acting).filter(|_| all.len() > 1);
            let opens = opening.state != OpeningState::Closed;
            if opens {
                warnings.push(Warning::BaseOpens {
                    situation: situation.clone(),
                    contact: opening.contact(base),
                    base,
                    pressure: opening.open_pressure(),
                });
                if opening.is_held {
                    warnings.push(Warning::OpeningHeld { situation: situation.clone() });
                }
                if opening.drain_works() == Some(false) {
                    warnings.push(Warning::DrainLost { situation: situation.clone() });
                }
                let given = [
                    (Table::Uplift, self.uplift.is_some()),
                    (Table::Pressure, self.pressures.iter().any(|given| given.face == Face::Base)),
                ];
                for (table, _) in given.into_iter().filter(|(_, is_given)| *is_given) {
                    let warning = Warning::GivenUpliftDoesNotFollow { table };
                    if !warnings.contains(&warning) {
                        warnings.push(warning);
                    }
                }
            }
            if opening.would_run_through {
                warnings.push(Warning::OpeningWouldRunThrough { situation });
            }
        }
        warnings
    }

    /// About formulas that nobody here has read in their source.
    fn recalled(&self) -> Vec<Warning> {
        let standing = self.wave.as_ref().filter(|wave| matches!(wave.formula, WaveFormula::Sainflou(_)));
        let rests_on_slope =
            |fill: &SoilFill| fill.soil.state == EarthState::AtRest && fill.soil.slope_deg != 0.0;
        let all = [
            (
                standing.is_some_and(|wave| wave.uplift() != 0.0),
                "the uplift of standing waves, which falls to nothing at the heel,",
                "Sainflou",
            ),
            (
                self.drain.is_some(),
                "what drains take of the pressure under the base",
                "EM 1110-2-2200 (1995)",
            ),
            (
                self.soils.iter().any(rests_on_slope),
                "the pressure at rest of soil under a slope",
                "EN 1997-1:2004, 9.5.2",
            ),
        ];
        let all = all.into_iter().filter(|(is_there, ..)| *is_there);
        all.map(|(_, what, source)| Warning::FormulaRecalled { what, source }).collect()
    }

    /// About adhesion that carries most, and passive soils beside low factors, in the situation of each set of loads where they are worst.
    fn held(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if self.adhesion.is_none() && self.resistances.is_empty() {
            return warnings;
        }
        let all = self.acting();
        for acting in all.iter().copied() {
            let case = self.under(acting);
            let trials = self.trials(acting).into_iter();
            let outcomes = trials.filter_map(|trial| self.situation(acting, trial).ok()?.outcome().ok());
            let least =
                |one: &Outcome, two: &Outcome| one.stability.sliding.total_cmp(&two.stability.sliding);
            let Some(outcome) = outcomes.min_by(least) else { continue };
            let Some(held) = outcome.held else { continue };
            let situation = self.acting_name(acting).filter(|_| all.len() > 1);
            let friction = case.friction * outcome.full.wrench.p;
            let resistance = friction + held.adhesion + held.against;
            if held.adhesion > 0.0 && held.adhesion > 0.5 * resistance {
                let (situation, extent) = (situation.clone(), self.extent);
                warnings.push(Warning::AdhesionCarries {
                    situation,
                    adhesion: held.adhesion,
                    resistance,
                    extent,
                });
            }
            let factor = outcome.stability.sliding;
            let push = outcome.full.wrench.x;
            let against = |resistance: &&Resistance| match resistance.direction {
                Direction::Sideways(side) => resistance.is_passive() && side.sign() * push < 0.0,
                _ => false,
            };
            // A code asks for its own factor of a passive soil that it divides.
            let by_code = match acting {
                Acting::Combination(index) => self.combinations[index].code.is_some(),
                _ => false,
            };
            let soil = case.resistances.iter().find(against).filter(|_| factor < 2.0 && !by_code);
            if let Some(soil) = soil {
                let name = soil.name.clone();
                warnings.push(Warning::PassiveWithLowFactor { situation, name, factor });
            }
        }
        warnings
    }

    /// About joints with water at different pressures that are not pressed throughout, in the situation of each set of loads.
    fn joints_open(&self) -> Vec<Warning> {
        let all = self.acting();
        let mut warnings = Vec::new();
        for acting in all.iter().copied() {
            for (place, joint) in self.under(acting).joints.iter().enumerate() {
                let pressed = |trial: Trial| {
                    let situation = self.above_joint(place, acting, trial).ok()?;
                    let ends = situation.loads().iter().filter_map(|load| match &load.action {
                        Action::Pressure { face: Face::Base, diagram } => {
                            let [first, .., last] = diagram.points() else { return None };
                            Some([first, last].map(|at| at.pressure * load.factor))
                        }
                        _ => None,
                    });
                    let [left, right] = ends.fold([0.0; 2], |sum, ends| [sum[0] + ends[0], sum[1] + ends[1]]);
                    if (left - right).abs() <= 1e-9 * left.abs().max(right.abs()) {
                        return None;
                    }
                    match situation.outcome().ok()?.stability.bearing {
                        Bearing::Pressed { share, .. } => Some(share).filter(|share| *share < 1.0),
                        Bearing::OutsideBase => Some(0.0),
                        _ => None,
                    }
                };
                let least = self.trials(acting).into_iter().filter_map(pressed).reduce(f64::min);
                if let Some(share) = least {
                    let situation = self.acting_name(acting).filter(|_| all.len() > 1);
                    warnings.push(Warning::JointWouldOpen { situation, joint: joint.called(place), share });
                }
            }
        }
        warnings
    }

    /// About uplift that is greater on the side away from the push, under every set of loads.
    fn uplifted(&self) -> Option<Warning> {
        let uplift = self.uplift.as_ref()?;
        let (left, right) = (uplift.left(), uplift.right());
        if left == right || (self.earthquake.is_some() && self.both_sides) {
            return None;
        }
        let away = |acting: Acting| {
            let full = self.situation(acting, Trial::AS_GIVEN).and_then(|situation| situation.at(1.0));
            // To the left it is pushed from the right.
            full.is_ok_and(|full| full.wrench.x * (right - left) > 0.0)
        };
        self.acting().into_iter().all(away).then_some(Warning::UpliftAwayFromPush { left, right })
    }

    /// About uplift that nobody says to stay while a push grows. Beside a difference of water levels it is seepage, which stays; beside
    /// waves it has a warning of its own.
    fn uplift_stays(&self) -> Option<Warning> {
        let uplift = self.uplift.as_ref()?;
        let is_said = self.inputs.truth(Key::UpliftGrows).is_some();
        let seeps = self.water.is_some_and(|water| water.left() != water.right());
        if is_said || seeps || self.wave.is_some() || uplift.left() == uplift.right() {
            return None;
        }
        let forces = self
            .forces
            .iter()
            .map(|force| (force.of, force.permanent, matches!(force.direction, Direction::Sideways(_))));
        let pressures = self.pressures.iter().enumerate();
        let pressures = pressures.map(|(index, given)| {
            ((Table::Pressure, index), given.permanent, matches!(given.face, Face::Left | Face::Right))
        });
        let push = forces.chain(pressures).find(|(_, permanent, is_sideways)| !permanent && *is_sideways);
        push.map(|((table, index), ..)| Warning::UpliftStays { table, index })
    }

    /// About variable forces and pressures that hold the body, where it is nowhere looked at without one of them.
    fn favourable(&self) -> Vec<Warning> {
        let named = self.forces.iter().map(|force| force.permanent);
        if named.chain(self.pressures.iter().map(|pressure| pressure.permanent)).all(|permanent| permanent) {
            return Vec::new();
        }
        let tried = self.acting().into_iter().flat_map(|acting| {
            self.trials_of_pairs(acting).map(move |trial| (acting, trial)).collect::<Vec<_>>()
        });
        let situations: Vec<Situation> =
            tried.filter_map(|(acting, trial)| self.situation(acting, trial).ok()).collect();
        // What pulls against all others, or presses the body down, by its wrench alone: most loads push, and cost no more.
        let holding = situations.iter().flat_map(|situation| {
            let full = situation.at(1.0).ok().map(|full| full.wrench);
            let loads = situation.loads().iter().filter(|load| !load.permanent);
            loads.filter_map(move |load| {
                let Place::Table(table @ (Table::Load | Table::Moment | Table::Pressure), index) =
                    said_by(load.id)
                else {
                    return None;
                };
                let (own, full) = (situation.wrench_of(load), full?);
                let holds = own.p > 0.0 || own.x * full.x < 0.0 || own.m * full.m < 0.0;
                holds.then_some((situation, load.id, table, index))
            })
        });
        let holding: Vec<_> = holding.collect();
        if holding.is_empty() {
            return Vec::new();
        }
        let least = |situation: &Situation| {
            let stability = situation.outcome().ok()?.stability;
            Some(stability.sliding.min(stability.overturning()))
        };
        let with = situations.iter().filter_map(least).fold(f64::INFINITY, f64::min);
        let mut told = Vec::new();
        let mut warnings = Vec::new();
        for (situation, load, table, index) in holding {
            if told.contains(&load) {
                continue;
            }
            let without = least(&situation.without(load)).unwrap_or(f64::INFINITY);
            if without < SAFE && without < with * (1.0 - FAVOUR) {
                told.push(load);
                warnings.push(Warning::FavourableLoad { table, index, with, without });
            }
        }
        warnings
    }

    /// About what is asked of the results.
    fn asked(&self) -> Option<Warning> {
        let all = self.all_criteria();
        let mut bearing = all.iter().filter(|criterion| criterion.key == Key::GreatestBearing);
        bearing.find_map(|criterion| match criterion.bound {
            Bound::AtMost(pressure) if pressure < BEARING * 1e3 => Some(Warning::SmallBearing { pressure }),
            _ => None,
        })
    }

    /// About what the base bears.
    fn ground(&self) -> Vec<Warning> {
        let Some(ground) = &self.ground else { return Vec::new() };
        let given = [
            (Key::Strength, STRENGTH, 1e3, ground.strength()),
            (
                Key::UndrainedStrength,
                UNDRAINED,
                1e3,
                ground.soil().and_then(|soil| soil.undrained_strength()),
            ),
            (Key::UnitWeight, UNIT_WEIGHT, 1e3, ground.soil().and_then(|soil| soil.unit_weight())),
            (Key::Stiffness, STIFFNESS, 1e6, ground.stiffness),
            (Key::TangentialStiffness, STIFFNESS, 1e6, ground.tangential_stiffness),
        ];
        let unusual = given.into_iter().filter_map(|(key, usual, unit, value)| {
            let value = value.filter(|value| !usual.contains(*value / unit))?;
            Some(Warning::UnusualGround { id: key.into(), value })
        });
        let mut warnings: Vec<Warning> = unusual.collect();
        let wet = self.water.is_some() || self.wave.as_ref().is_some_and(|wave| wave.still_water().is_some());
        if let Some(unit_weight) = ground.soil().and_then(|soil| soil.unit_weight()).filter(|_| wet)
            && unit_weight > SUBMERGED * 1e3 * (1.0 + ROUNDING)
        {
            warnings.push(Warning::GroundUnderWater { unit_weight });
        }
        warnings
    }

    /// About a base seen from above that is so much larger than the body that its points may be in another unit.
    fn beyond(&self, plan: &CasePlan) -> Option<Warning> {
        /// Feet may stand on arms.
        const TIMES: f64 = 4.0;
        let footprint = plan.base.footprint.rounded();
        let extent = |axis: usize| {
            let values = || footprint.vertices().iter().map(|vertex| vertex[axis]);
            let of_points =
                values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
            footprint.disc().map_or(of_points, |(_, radius)| 2.0 * radius)
        };
        let width = self.body.width();
        let length = match self.body.plan() {
            Plan::Rectangle { length } => length,
            _ => width,
        };
        let both = [(extent(0), width), (extent(1), length)];
        let beyond = both.into_iter().find(|(base, body)| *base > TIMES * body);
        beyond.map(|(base, body)| Warning::PlanBeyondBody { base, body })
    }

    /// About what the body stands on.
    fn base(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let half = self.body.width() / 2.0;
        let BaseEdges { left, right } = self.body.base_edges();
        for (side, edge) in [(Slip::Left, left), (Slip::Right, right)] {
            // Half of a width that is typed is not always half of it to the last digit.
            if edge > half * (1.0 + 1e-9) {
                warnings.push(Warning::BaseBeyondBody { side, edge, beyond: edge - half });
            }
        }
        warnings.extend(self.plan.as_ref().and_then(|plan| self.beyond(plan)));
        let base = self.body.base_width();
        if let Weight::Buoyant { arm, .. } = self.weight
            && arm > base
        {
            warnings.push(Warning::WeightBesideBase { arm, base });
        }
        warnings
    }

    /// About numbers that are unusual by themselves.
    fn numbers(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let area = match &self.section {
            Some(section) => section.area() * self.body.plan().side(self.body.width()),
            None => self.body.plan().area(self.body.width()) * self.body.height(),
        };
        let (density, extent) = (self.body.mass() / area, self.extent);
        let usual = if extent == Extent::PerMetre { DENSITY } else { OBJECT };
        if !usual.contains(density) {
            let of_parts = self.section.is_some();
            warnings.push(Warning::MeanDensity { density, extent, of_parts });
        }
        warnings.extend(self.parts().enumerate().flat_map(|(index, (_, part))| {
            let of = |key, density: f64| {
                let is_it = density != 0.0 && !usual.contains(density);
                is_it.then_some(Warning::PartDensity { id: Id::new(key, index), density, extent })
            };
            let below = part.density_below_water();
            let wet = (below != part.density()).then_some(below);
            of(Key::PartDensity, part.density())
                .into_iter()
                .chain(wet.and_then(|below| of(Key::PartDensityBelow, below)))
                .collect::<Vec<_>>()
        }));
        let of_wave = self.wave.as_ref().map(|wave| (wave.density_key, wave.water_density));
        let water = of_wave.or(self.water.map(|water| (Key::WaterDensity, water.density())));
        if let Some((key, density)) = water.filter(|(_, density)| !WATER.contains(*density)) {
            warnings.push(Warning::WaterDensity { key, density });
        }
        if self.section.is_none() {
            let (height, crest) = (self.body.centroid_height(), self.body.height());
            if height > crest * (1.0 + ROUNDING) {
                warnings.push(Warning::CentroidOutsideBody { height, crest });
            }
            let inertia = self.body.moment_of_inertia();
            let gyration = (inertia / self.body.mass()).sqrt();
            let share = gyration / self.body.width().hypot(self.body.height());
            // That which the formula of a body gives is no slip.
            let is_given = self.inputs.number(Key::MomentOfInertia).is_some();
            if is_given && !GYRATION.contains(share) {
                warnings.push(Warning::MomentOfInertia { inertia, extent, share });
            }
        }
        let slenderness = self.body.height() / self.body.width();
        if !SLENDER.contains(slenderness) {
            warnings.push(Warning::Slenderness { slenderness });
        }
        let frictions = [(Id::from(Key::Friction), self.friction)].into_iter();
        let of_joints = |joint: &CaseJoint| (Id::new(Key::JointFriction, joint.index), joint.friction);
        for (id, friction) in frictions.chain(self.joints.iter().map(of_joints)) {
            if friction > FRICTION {
                warnings.push(Warning::HighFriction { id, friction });
            }
        }
        if !GRAVITY.contains(self.gravity) {
            warnings.push(Warning::UnusualGravity { gravity: self.gravity });
        }
        warnings
    }

    /// About a weight from which buoyancy is taken off already.
    fn buoyancy(&self) -> Option<Warning> {
        let Weight::Buoyant { force: buoyant, .. } = self.weight else { return None };
        let extent = self.extent;
        let weight = self.body.mass() * self.gravity;
        if buoyant > weight * (1.0 + ROUNDED) {
            return Some(Warning::BuoyantAboveWeight { buoyant, weight, extent });
        }
        let wave = self.wave.as_ref()?;
        let (unit_weight, depth) = (wave.water_density * self.gravity, wave.still_water()?);
        if let Some(parts) = &self.section {
            let of_parts = weight - unit_weight * parts.below(depth).area;
            let off = (buoyant / of_parts - 1.0).abs();
            return (off > OF_PARTS).then_some(Warning::BuoyantBesideParts { buoyant, of_parts });
        }
        let displaced = unit_weight * self.body.base_area() * depth;
        let off = (weight - displaced - buoyant).abs();
        let near = (SHAPE * displaced).max(SHALLOW * weight);
        (off > near).then_some(Warning::BuoyantBesideDisplacement { buoyant, weight, displaced, extent })
    }

    /// About an earthquake.
    fn shaking(&self) -> Vec<Warning> {
        let Some(earthquake) = self.earthquake else { return Vec::new() };
        let mut warnings = Vec::new();
        let horizontal = earthquake.horizontal();
        for (key, acceleration) in [(Key::Horizontal, horizontal), (Key::Vertical, earthquake.vertical())] {
            let share = acceleration / self.gravity;
            match share.abs() {
                0.0 => {}
                much if much > SHAKING.to => {
                    warnings.push(Warning::StrongEarthquake { key, acceleration, share })
                }
                little if !SHAKING.contains(little) => {
                    warnings.push(Warning::WeakEarthquake { key, acceleration, share })
                }
                _ => {}
            }
        }
        // W' says that there is water, too; waves come with one or the other.
        let still = self.water.is_some_and(|water| water.left() > 0.0 || water.right() > 0.0);
        let wet = still || self.weight != Weight::Total;
        if wet && horizontal != 0.0 && self.added_mass.mass() == 0.0 {
            warnings.push(Warning::EarthquakeWithoutAddedMass { acceleration: horizontal });
        }
        warnings
    }

    /// About waves.
    fn waves(&self) -> Vec<Warning> {
        let Some(wave) = &self.wave else { return Vec::new() };
        let mut warnings = Vec::new();
        match &wave.formula {
            WaveFormula::Goda(GodaWaves { heights, sea, .. }) => {
                if let Heights::Local { significant, maximum } = *heights
                    && !HEIGHTS.contains(maximum / significant)
                {
                    warnings.push(Warning::WaveHeightRatio { maximum, significant });
                }
                if sea.angle_deg > OBLIQUE {
                    warnings.push(Warning::WaveAngle { degrees: sea.angle_deg });
                }
            }
            WaveFormula::Sainflou(_) => {}
            WaveFormula::Crown(CrownWaves { wall, .. }) => {
                let (wall, body) = (wall.height(), self.body.height());
                if (wall - body).abs() > SLACK {
                    warnings.push(Warning::CrownWallHeight { wall, body });
                }
            }
        }
        // Where λ3 takes it away, it is not there twice.
        let of_waves = wave.uplift();
        if let Some(uplift) = self.uplift.filter(|uplift| uplift.left().max(uplift.right()) > 0.0)
            && of_waves > 0.0
        {
            let given = [uplift.left(), uplift.right()];
            warnings.push(Warning::UpliftBesideWave { given, of_waves });
        }
        warnings.extend(wave.warnings().into_iter().map(Warning::Wave));
        warnings
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CaseFile;

    /// A case whose numbers are all usual; in water, shaken, under waves, each a variant of it.
    const BLOCK: &str = "[body]\nwidth = 10\nheight = 10\nmass = 230e3\nfriction = 0.6\n";
    const FORCE: &str = "[[load]]\nforce = 1e5\nelevation = 3\n";
    const WATER_TABLE: &str = "[water]\nlevel = 6\ndensity = 1000\n";
    const SHAKEN: &str = "[earthquake]\nhorizontal = \"0.2 g\"\n";
    const SEA: &str = "[wave]\nH13 = 3\nHmax = 5.4\nperiod = 10\nsea_bottom_slope = 0.01\nwater_depth = 9\n\
        depth_above_berm = 5.5\nbase_depth = 6\ncrest_height = 4\nberm_width = 5\nangle_deg = 0\nwater_density = 1030\n";

    fn warnings(text: &str) -> Vec<Warning> {
        let file = CaseFile::parse("t.toml", text).unwrap();
        file.case().unwrap_or_else(|error| panic!("{error}\n{text}")).warnings()
    }

    fn names(text: &str) -> Vec<&'static str> {
        let of_formulas = |warning: &Warning| matches!(warning, Warning::Wave(_));
        let warnings = warnings(text);
        warnings.iter().filter(|warning| !of_formulas(warning)).map(Warning::name).collect()
    }

    /// With a number changed, the warnings of a case that has none.
    fn with(text: &str, line: &str, other: &str) -> Vec<&'static str> {
        assert!(text.contains(line), "{line}");
        assert_eq!(names(text), [""; 0]);
        names(&text.replace(line, other))
    }

    /// On and inside a limit nothing is said; just outside the warning of that name, and no other.
    fn limits(text: &str, line: &str, name: &str, inside: &[&str], outside: &[&str]) {
        for other in inside {
            assert_eq!(with(text, line, other), [""; 0], "{other}");
        }
        for other in outside {
            assert_eq!(with(text, line, other), [name], "{other}");
        }
    }

    #[test]
    fn numbers_by_themselves() {
        let dry = format!("{BLOCK}{FORCE}");
        let mass = "mass = 230e3";
        limits(
            &dry,
            mass,
            "mean-density",
            &["mass = 100e3", "mass = 300e3"],
            &["mass = 99.99e3", "mass = 300.1e3"],
        );
        let density = ["density = 1000", "density = 3000", "density = \"2.4 t/m3\""];
        limits(&dry, mass, "mean-density", &density, &["density = 2.4", "density = 3001"]);
        // 1000 kg/m³ × 0.1 m × 3.7 m and back are not quite 1000 kg/m³.
        let rounded =
            dry.replace("width = 10\nheight = 10\nmass = 230e3", "width = 0.1\nheight = 3.7\ndensity = 1000");
        assert_eq!(names(&rounded), [""; 0]);
        let friction = "friction = 0.6";
        limits(&dry, friction, "high-friction", &["friction = 1"], &["friction = 1.001"]);
        let gravity = |g: &str| dry.replace("[body]", &format!("gravity = {g}\n[body]"));
        for (g, expected) in [
            ("9.7", None),
            ("9.9", None),
            ("9.69", Some("unusual-gravity")),
            ("9.91", Some("unusual-gravity")),
        ] {
            assert_eq!(names(&gravity(g)), Vec::from_iter(expected), "{g}");
        }
        let wet = format!("{BLOCK}{WATER_TABLE}");
        let water = ["density = 950", "density = 1100"];
        limits(&wet, "density = 1000", "water-density", &water, &["density = 949", "density = 1101"]);
        let sea = format!("{}{SEA}", BLOCK.replace("mass", "buoyant_weight = 1650e3\nmass"));
        let water = ["water_density = 1000", "water_density = 1100"];
        limits(&sea, "water_density = 1030", "water-density", &water, &["water_density = 1101"]);
        // The sea without a density has that of [water], and the key to blame is that of [water].
        let shared =
            format!("{BLOCK}[water]\nlevel = 6\ndensity = 1101\n{}", SEA.replace("water_density = 1030", ""));
        assert!(
            warnings(&shared).iter().any(|warning| warning.to_string().starts_with("water.density = 1101"))
        );
        let [warning] = &warnings(&sea.replace("density = 1030", "density = 1101"))[..] else { panic!() };
        assert!(
            warning.is_about_waves() && warning.to_string().starts_with("wave.water_density = 1101 kg/m³")
        );
    }

    #[test]
    fn an_earthquake() {
        let name = "strong-earthquake";
        let shaken = format!("{BLOCK}{SHAKEN}vertical = \"0.1 g\"\n");
        let [horizontal, vertical] = ["horizontal = \"0.2 g\"", "vertical = \"0.1 g\""];
        let usual = [
            "horizontal = \"3 g\"",
            "horizontal = \"-0.01 g\"",
            "horizontal = \"29 m/s2\"",
            "horizontal = 0",
        ];
        limits(&shaken, horizontal, name, &usual, &["horizontal = \"3.01 g\"", "horizontal = \"-30 m/s2\""]);
        limits(&shaken, vertical, name, &["vertical = \"-3 g\""], &["vertical = \"-3.01 g\""]);
        let weak = ["horizontal = \"0.009 g\"", "horizontal = \"-0.09 m/s2\""];
        limits(&shaken, horizontal, "weak-earthquake", &usual, &weak);

        // In water its share has to be said, whatever says that there is water.
        let name = "earthquake-without-added-mass";
        let sea = format!("{}{SEA}", BLOCK.replace("mass", "buoyant_weight = 1650e3\nmass"));
        let weight = format!("{}{SHAKEN}", BLOCK.replace("mass", "buoyant_weight = 1650e3\nmass"));
        let level = "level = 6";
        for wet in [&format!("{BLOCK}{WATER_TABLE}{SHAKEN}"), &format!("{sea}{SHAKEN}"), &weight] {
            assert_eq!(names(wet), [name], "{wet}");
            assert_eq!(names(&format!("{wet}[added_mass]\nmass = 20e3\n")), [""; 0], "{wet}");
            assert_eq!(
                names(&wet.replace("horizontal = \"0.2 g\"", "horizontal = 0\nvertical = \"0.1 g\"")),
                [""; 0]
            );
        }
        let still = format!("{BLOCK}{WATER_TABLE}{SHAKEN}");
        assert_eq!(names(&still.replace(level, "left = 0\nright = 0.01")), [name]);
        assert_eq!(names(&still.replace(level, "left = 0.01\nright = 0")), [name]);
        assert_eq!(names(&still.replace(level, "level = 0")), [""; 0]);
    }

    /// By hand: μ(W + V)/H, with the crane's V and without; and what another combination tells is not told again.
    #[test]
    fn a_load_that_holds_the_body() {
        let name = "favourable-load";
        // 1.2·10⁶ N/m of earth against 0.6 · 2256.3 kN/m: 1.128 without the crane, 1.428 with 600 kN/m of it.
        let earth = "[[load]]\nname = \"earth\"\nforce = 1.2e6\nelevation = 3\npermanent = true\n";
        let crane = "[[load]]\nname = \"crane\"\nforce = 600e3\ndirection = \"down\"\ndistance = 5\n";
        let quay = format!("{BLOCK}{earth}{crane}");
        let [warning] = &warnings(&quay)[..] else { panic!("{:?}", names(&quay)) };
        let Warning::FavourableLoad { table: Table::Load, index: 1, with, without } = warning else {
            panic!("{warning}");
        };
        let weight = 230e3 * 9.81;
        assert!((without / (0.6 * weight / 1.2e6) - 1.0).abs() < 1e-9, "{without}");
        assert!((with / (0.6 * (weight + 600e3) / 1.2e6) - 1.0).abs() < 1e-9, "{with}");
        assert!(
            warning.to_string().contains("without it the least safety factor is 1.128, not 1.428"),
            "{warning}"
        );
        // It pushes; it is there all the time; the body is safe without it.
        assert_eq!(names(&quay.replace("\"down\"", "\"up\"")), [""; 0]);
        assert_eq!(names(&quay.replace("distance = 5", "distance = 5\npermanent = true")), [""; 0]);
        assert_eq!(names(&quay.replace("1.2e6", "0.6e6")), [""; 0]);
        let combined = "[[combination]]\nname = \"with\"\nfactors = { crane = 1 }\n[[combination]]\nname = \"without\"\nfactors = { earth = 1 }\n";
        assert_eq!(names(&format!("{quay}{combined}")), [""; 0]);
        let alone = combined.split("[[combination]]\nname = \"without\"").next().unwrap();
        assert_eq!(names(&format!("{quay}{alone}")), [name]);
    }

    #[test]
    fn slips_of_place_and_size() {
        let dry = format!("{BLOCK}{FORCE}");
        let mass = "mass = 230e3";
        let with_mass = |more: &str| format!("{mass}\n{more}");
        let inside = ["centroid_height = 10"].map(with_mass);
        let outside = ["centroid_height = 10.01", "centroid_height = \"17 m\""].map(with_mass);
        let [inside, outside] =
            [&inside[..], &outside[..]].map(|all| all.iter().map(String::as_str).collect::<Vec<_>>());
        limits(&dry, mass, "centroid-outside-body", &inside, &outside);
        // m r² with r of the diagonal of 200 m².
        let inertia =
            |share: f64| with_mass(&format!("moment_of_inertia = {}", 230e3 * share * share * 200.0));
        let [inside, outside] = [[0.201, 0.699], [0.199, 0.701]].map(|shares| shares.map(inertia));
        let [inside, outside] = [&inside, &outside].map(|all| all.each_ref().map(String::as_str));
        limits(&dry, mass, "moment-of-inertia", &inside, &outside);
        let sizes = "width = 10\nheight = 10\nmass = 230e3";
        let size = |width: f64, height: f64| {
            format!("width = {width}\nheight = {height}\nmass = {}", 2300.0 * width * height)
        };
        let [inside, outside] = [[size(100.0, 5.0), size(0.2, 10.0)], [size(100.0, 4.9), size(0.1, 5.1)]];
        let [inside, outside] = [&inside, &outside].map(|all| all.each_ref().map(String::as_str));
        limits(&dry, sizes, "slenderness", &inside, &outside);
        // 2e-3 of m g = 2256.3 kN/m.
        limits(&dry, "force = 1e5", "small-force", &["force = 4513", "force = 0"], &["force = 4512"]);
        let sea = format!("{BLOCK}[water]\nlevel = 6\n{SEA}");
        limits(&sea, "angle_deg = 0", "wave-angle", &["angle_deg = 60"], &["angle_deg = 61"]);
        let soil = "[ground]\nfriction_angle_deg = 35\nunit_weight = 10e3\n";
        let light = "unit_weight = 10e3";
        limits(
            &format!("{sea}{soil}"),
            light,
            "ground-under-water",
            &["unit_weight = 13e3"],
            &["unit_weight = 18e3"],
        );
        let above = format!("{dry}{soil}").replace(light, "unit_weight = 18e3");
        assert_eq!(names(&above), [""; 0], "above water it may weigh so much");
        let backfill =
            "[[pressure]]\nface = \"right\"\nelevation = [0, 9]\npressure = [54e3, 0]\npermanent = true\n";
        let filled = format!("{dry}{backfill}");
        let given = "pressure = [54e3, 0]";
        limits(&filled, given, "small-pressure", &["pressure = [100, 0]"], &["pressure = [54, 0]"]);
        let name = "small-pressure";
        let founded = format!("{dry}{soil}surcharge = 15e3\ncohesion = 5e3\n");
        limits(
            &founded,
            "surcharge = 15e3",
            name,
            &["surcharge = 0", "surcharge = 100"],
            &["surcharge = 15"],
        );
        limits(
            &founded,
            "cohesion = 5e3",
            name,
            &["cohesion = 0", "cohesion = \"5 kPa\""],
            &["cohesion = 5"],
        );
        let lifted = format!("{dry}[uplift]\ngrows = false\nleft = 0\nright = 30e3\n");
        limits(&lifted, "right = 30e3", name, &["right = 100"], &["right = 30"]);
        let name = "pressure-falls-with-depth";
        limits(
            &filled,
            given,
            name,
            &["pressure = [54e3, 54e3]"],
            &["pressure = [0, 54e3]", "pressure = [-54e3, 0]"],
        );
        // What varies may be a wave's.
        assert_eq!(
            names(&filled.replace(given, "pressure = [0, 54e3]").replace("permanent = true", "")),
            [""; 0]
        );
        let upside = filled.replace("elevation = [0, 9]", "elevation = [9, 0]");
        assert!(
            CaseFile::parse("t.toml", &upside).and_then(|file| file.case()).is_err()
                || names(&upside) == [name]
        );
    }

    /// Soil and uplift on the wrong side; what is pushed both ways, or by nothing, has none.
    #[test]
    fn loads_on_the_wrong_side() {
        let dry = format!("{BLOCK}{FORCE}[uplift]\ngrows = false\nleft = 5e3\nright = 20e3\n");
        let given = "left = 5e3\nright = 20e3";
        limits(
            &dry,
            given,
            "uplift-away-from-push",
            &["left = 20e3\nright = 20e3"],
            &["left = 20.1e3\nright = 20e3", "left = 20e3\nright = 5e3"],
        );
        let slip = dry.replace(given, "left = 20e3\nright = 5e3");
        assert_eq!(names(&slip.replace("elevation = 3", "elevation = 3\ndirection = \"right\"")), [""; 0]);
        assert_eq!(names(&slip.replace("force = 1e5", "force = 0")), [""; 0]);
        let quay = format!(
            "{BLOCK}[water]\nleft = 6\nright = 6.5\ndensity = 1030\n[[pressure]]\nface = \"right\"\nelevation = [0, 9]\n\
             pressure = [54e3, 0]\npermanent = true\n"
        );
        limits(
            &quay,
            "left = 6\nright = 6.5",
            "pressure-against-water",
            &["left = 6\nright = 6"],
            &["left = 6.6\nright = 6.5"],
        );
        assert_eq!(names(&quay.replace("\"right\"", "\"left\"")), ["pressure-against-water"]);
        assert_eq!(names(&quay.replace("\"right\"", "\"left\"").replace("permanent = true", "")), [""; 0]);
    }

    /// Uplift that may be a wave's: not where the case says so, under a level pressure, beside seepage or beside what is permanent or hangs.
    #[test]
    fn uplift_that_is_not_said_to_grow() {
        let case = format!("{BLOCK}{FORCE}[uplift]\nleft = 5e3\nright = 20e3\n");
        let name = "uplift-stays";
        let but = |line: &str, other: &str| names(&case.replace(line, other));
        assert_eq!(names(&case), [name]);
        for said in ["grows = true", "grows = false"] {
            assert_eq!(names(&format!("{case}{said}\n")), [""; 0], "{said}");
        }
        assert_eq!(but("right = 20e3", "right = 5e3"), [""; 0]);
        assert_eq!(but("elevation = 3", "elevation = 3\npermanent = true"), [""; 0]);
        assert_eq!(but("elevation = 3", "distance = 3\ndirection = \"down\""), [""; 0]);
        let pressed =
            but(FORCE, "[[pressure]]\nface = \"right\"\nelevation = [0, 5]\npressure = [9e3, 9e3]\n");
        assert_eq!(pressed, [name]);
        let seeping = "[water]\nleft = 1\nright = 3\ndensity = 1000\nopening = \"closed\"\n";
        assert_eq!(names(&format!("{case}{seeping}")), [""; 0]);
    }

    #[test]
    fn heights_that_do_not_go_together() {
        let sea = format!("{BLOCK}[water]\nlevel = 6\n{SEA}");
        let name = "wave-height-ratio";
        limits(&sea, "Hmax = 5.4", name, &["Hmax = 4.2", "Hmax = 6.6"], &["Hmax = 4.19", "Hmax = 6.61"]);
        // From deep water the formulas say both.
        assert_eq!(with(&sea, "H13 = 3\nHmax = 5.4", "deep_water_height = 3"), [""; 0]);
    }

    /// m g = 2256.3 kN/m; the section displaces 10 m × 6 m of 1030 kg/m³, 606.3 kN/m; W' = 1650.0 kN/m.
    #[test]
    fn a_buoyant_weight_that_is_none() {
        let block = BLOCK.replace("mass", "buoyant_weight = 1650e3\nmass");
        let weight = "buoyant_weight = 1650e3";
        // A quarter of 606.3 kN/m to either side.
        let inside = ["buoyant_weight = 1800e3", "buoyant_weight = 1500e3"];
        let outside = ["buoyant_weight = 1803e3", "buoyant_weight = 1497e3", "buoyant_weight = 2256e3"];
        limits(&format!("{block}{SEA}"), weight, "buoyant-beside-displacement", &inside, &outside);
        // Without waves nothing says how deep it stands.
        let above = ["buoyant_weight = 2259e3", "buoyant_weight = 2400e3"];
        let inside = ["buoyant_weight = 2256.5e3", "buoyant_weight = 100e3"];
        limits(&format!("{block}{FORCE}"), weight, "buoyant-above-weight", &inside, &above);
        limits(&format!("{block}{SEA}"), weight, "buoyant-above-weight", &[], &above);
        // In shallow water the rounding of the mass counts: 2 % of m g, 45.1 kN/m, about 2256.3 − 70.7 = 2185.6 kN/m.
        let shallow = format!("{block}{SEA}").replace("base_depth = 6", "base_depth = 0.7");
        let shallow = shallow
            .replace("crest_height = 4", "crest_height = 9.3")
            .replace(weight, "buoyant_weight = 2185e3");
        let (inside, outside) = (["buoyant_weight = 2141e3"], ["buoyant_weight = 2140e3"]);
        limits(&shallow, "buoyant_weight = 2185e3", "buoyant-beside-displacement", &inside, &outside);
    }

    #[test]
    fn uplift_that_is_counted_twice() {
        let sea = format!("{BLOCK}[water]\nlevel = 6\n{SEA}");
        let uplift = "[uplift]\ngrows = false\nleft = 0\nright = 20e3\n";
        assert_eq!(names(&format!("{BLOCK}{FORCE}{uplift}")), [""; 0]);
        assert_eq!(names(&format!("{sea}{}", uplift.replace("20e3", "0"))), [""; 0]);
        assert_eq!(names(&format!("{sea}{uplift}")), ["uplift-beside-wave"]);
        assert_eq!(
            names(&format!("{sea}{}", uplift.replace("left = 0", "left = 1"))),
            ["uplift-beside-wave"]
        );
    }

    /// The base's own, which have no number that is a limit.
    #[test]
    fn a_base_that_is_not_under_the_body() {
        let dry = format!("{BLOCK}{FORCE}");
        limits(
            &dry,
            "mass",
            "base-beyond-body",
            &["base_left = 5\nmass"],
            &["base_left = 5.1\nmass", "base_right = 6\nmass"],
        );
        let arm = |arm: &str| format!("buoyant_weight = 1650e3\nweight_arm = {arm}\nmass");
        limits(&dry, "mass", "weight-beside-base", &[&arm("10")], &[&arm("10.1")]);
    }

    /// No example is suspected of a slip; for published cases see the program's tests.
    #[test]
    fn the_examples_are_no_slips() {
        for text in [
            include_str!("../../../../examples/block-two-loads.toml"),
            include_str!("../../../../examples/caisson-in-air.toml"),
            include_str!("../../../../examples/goda-2000.toml"),
            include_str!("../../../../examples/goda-lower-berm.toml"),
            include_str!("../../../../examples/monument.toml"),
            include_str!("../../../../examples/seismic-block.toml"),
        ] {
            assert_eq!(names(text), [""; 0], "{text}");
        }
        assert_eq!(names(include_str!("../../../../examples/head-difference.toml")), ["base-opens"]);
    }

    /// Each says its value with unit, what is usual, and its key; a value beside its limit is told apart from it.
    #[test]
    fn messages_have_the_value_the_usual_and_the_key() {
        let [schema, page] = [
            include_str!("../../../../docs/answer.schema.json"),
            include_str!("../../../../docs/reference/warnings.md"),
        ];
        let dry = format!("{BLOCK}{FORCE}");
        let sea = format!("{BLOCK}[water]\nlevel = 6\n{SEA}");
        for (text, parts) in [
            (
                dry.replace("mass = 230e3", "mass = 240"),
                ["2.4 kg/m³", "1000 to 3000 kg/m³", "mass or density"],
            ),
            (
                dry.replace("mass = 230e3", "mass = 300.004e3"),
                ["3000.04 kg/m³", "1000 to 3000 kg/m³", "mass or density"],
            ),
            (dry.replace("friction = 0.6", "friction = 6"), ["friction = 6", "it is 1 at most", "friction"]),
            (
                dry.replace("[body]", "gravity = 32.2\n[body]"),
                ["gravity = 32.2 m/s²", "9.7 to 9.9 m/s²", "gravity"],
            ),
            (
                format!("{BLOCK}{WATER_TABLE}").replace("1000", "1.03"),
                ["water.density = 1.03 kg/m³", "950 to 1100 kg/m³", ""],
            ),
            (
                format!("{BLOCK}{SHAKEN}vertical = \"-4 g\"\n"),
                ["earthquake.vertical = -39.24 m/s² is -4 g", "usual peaks: 0.01 to 3 g", ""],
            ),
            (
                sea.replace("Hmax = 5.4", "Hmax = 9"),
                ["Hmax = 9 m is 3 times H13 = 3 m", "1.4 to 2.2 times is usual", ""],
            ),
            (
                format!("{BLOCK}{WATER_TABLE}{SHAKEN}"),
                ["earthquake.horizontal = 1.962 m/s²", "[added_mass]", "sides = \"right\" or \"both\""],
            ),
            (
                format!("{sea}[uplift]\ngrows = false\nleft = 0\nright = 20e3\n"),
                ["0 kPa at the left and 20 kPa at the right", "pu = ", "[uplift]"],
            ),
            (
                dry.replace("mass", "buoyant_weight = 2400e3\nmass"),
                ["buoyant_weight = 2400 kN/m", "m g = 2256 kN/m", ""],
            ),
            (
                format!("{}{SEA}", BLOCK.replace("mass", "buoyant_weight = 2250e3\nmass")),
                ["buoyant_weight = 2250 kN/m", "base_depth = 606.3 kN/m", "is 1650 kN/m"],
            ),
        ] {
            let warning = &warnings(&text)[0];
            let said = warning.to_string();
            assert!(schema.contains(&format!("\"{}\"", warning.name())), "{warning}");
            assert!(page.contains(&format!("| `{}` |", warning.name())), "{warning}");
            assert!(parts.iter().all(|part| said.contains(part)), "{said}");
        }
    }
}
