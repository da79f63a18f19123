//! Joints: where a body is parted, what is above each, and the loads on that.

use standfast::loads::{
    AboveJoint, Action, AddedMass, BodyPoint, Earthquake, Face, Load, LoadKind, LoadSource, PressureDiagram,
    Uplift,
};
use standfast::section::{Piece, Section};
use standfast::{Ball, InputError, Jointed, OnJoint, Plan, Quantity, Scalar, Situation};

use super::reader::Reader;
use super::{Acting, Case, Direction, LoadOrigin, OF_BLOCK, PointForce, Trial, WaveFormula, Weight};
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};

/// A joint above the base.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseJoint<T = f64> {
    /// Its name.
    pub name: Option<String>,
    /// The place of its table.
    pub index: usize,
    /// Coulomb friction to stick.
    pub friction: T,
    /// Coulomb friction to slip.
    pub kinetic_friction: T,
    /// Water in it.
    pub water: JointWater<T>,
    /// Its left and its right end, to the right of the origin of the section; of O without parts.
    pub ends: [T; 2],
    /// All that is above it, as one body.
    pub above: AboveJoint<T>,
    /// The same of a section of parts.
    piece: Option<Piece>,
    /// Widths at its left and its right where the bodies meet and do not bear: water beside them stands there.
    gaps: [T; 2],
    /// Water that moves with what is above it.
    added_mass: AddedMass<T>,
}

/// Ends of a joint.
struct JointEnds<T> {
    /// To the right of the origin of the section.
    ends: [T; 2],
    /// As the body that is cut counts them.
    contact: [T; 2],
    /// What `left` and `right` cut off of where the bodies meet.
    gaps: [T; 2],
}

/// Water in a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointWater<T = f64> {
    /// None, which nobody has to say where no water reaches so high.
    Dry,
    /// From the pressure outside at one end to that at the other.
    Open,
    /// None, as it is said.
    Tight,
    /// As it is given.
    Given(Uplift<T>),
}

impl<T: Scalar> CaseJoint<T> {
    /// By its number and name, from its place among those above the base: `joint 3 (cap)`.
    pub fn called(&self, place: usize) -> String {
        called(place + 1, self.name.as_deref())
    }

    /// Its level above the base, m.
    pub fn level(&self) -> T {
        self.above.level()
    }
}

/// Name of the joint under the whole, which no other has.
pub const BASE: &str = "base";

/// A joint by its number and name, from its place from the base, which is the first.
pub fn called(place: usize, name: Option<&str>) -> String {
    let number = place + 1;
    name.map_or_else(|| format!("joint {number}"), |name| format!("joint {number} ({name})"))
}

/// The tables and keys that have no place beside joints, in words.
const NOT_BESIDE: [(Table, &str); 6] = [
    (Table::Motion, "the motion in time"),
    (Table::WaveHistory, "a wave over time"),
    (Table::LoadHistory, "a load over time"),
    (Table::Storm, "storms, whose waves slide a body"),
    (Table::Resistance, "a force with a limit that holds the body"),
    (Table::Block, "a body in pure numbers"),
];

impl Reader<'_> {
    /// The joints above the base, from there up; `case` has everything else.
    pub(super) fn joints<T: Scalar>(&self, case: &Case<T>) -> Result<Vec<CaseJoint<T>>, Fault> {
        if !self.inputs.has(Table::Joint) {
            return Ok(Vec::new());
        }
        self.fits_joints(case)?;
        let indices = 0..self.inputs.count(Table::Joint);
        let mut joints = indices.map(|index| self.joint(index, case)).collect::<Result<Vec<_>, Fault>>()?;
        standfast::order::by_number(&mut joints, |one| one.level().value());
        for pair in joints.windows(2) {
            let [below, above] = [&pair[0], &pair[1]];
            let apart = above.level().value() - below.level().value();
            let pieces = case.section.as_ref().map(|section| {
                section.cut(&[below.level().value(), above.level().value()], case.water_table)
            });
            let id = Id::new(Key::JointElevation, above.index);
            if apart <= 1e-3 * case.body.height().value().min(1.0) {
                let problem = Problem::SameLevel { level: above.level().value() };
                return Err(Fault::new(problem, id).and(Id::new(Key::JointElevation, below.index)));
            }
            if let Some(Err(error)) = pieces {
                return Err(Fault::new(Problem::Cut(error), id));
            }
        }
        for (place, joint) in joints.iter().enumerate() {
            let Some(name) = &joint.name else { continue };
            let other = joints[..place].iter().find(|other| other.name.as_ref() == Some(name));
            if other.is_some() || name == BASE {
                let problem = Problem::SameJoint { name: name.clone() };
                let fault = Fault::new(problem, Id::new(Key::JointName, joint.index));
                return Err(match other {
                    Some(other) => fault.and(Id::new(Key::JointName, other.index)),
                    None => fault,
                });
            }
        }
        Ok(joints)
    }

    /// Refuses what has no place beside joints.
    fn fits_joints<T: Scalar>(&self, case: &Case<T>) -> Result<(), Fault> {
        let refused = |what| Fault::new(Problem::JointsNotFor { what }, Table::Joint);
        if let Some((_, what)) = NOT_BESIDE.iter().find(|(table, _)| self.inputs.has(*table)) {
            return Err(refused(what));
        }
        let passive = case.soils.iter().any(|fill| fill.is_passive());
        let crown = matches!(case.wave.as_ref().map(|wave| &wave.formula), Some(WaveFormula::Crown(_)));
        let others = [
            (matches!(case.weight, Weight::Buoyant { .. }), "a buoyant weight, which no joint can part"),
            (case.floor_deg != 0.0, "a tilted floor"),
            (passive, "a soil that resists the body"),
            (crown, "waves on a crown wall, whose force is one"),
        ];
        if let Some((_, what)) = others.iter().find(|(is_so, _)| *is_so) {
            return Err(refused(what));
        }
        if let Some(key) = OF_BLOCK.into_iter().find(|key| self.inputs.number(*key).is_some()) {
            return Err(Fault::new(Problem::JointsOfBlock { key }, key).and(Table::Joint));
        }
        if self.inputs.number(Key::WaterMass).is_some() && self.inputs.number(Key::WaterElevation).is_none() {
            return Err(self.missing(Key::WaterElevation, 0).and(Table::Joint));
        }
        let couple = case.forces.iter().find(|force| {
            let is_couple = matches!(force.direction, Direction::Turning(_));
            is_couple && self.inputs.number(Id::new(Key::MomentElevation, force.of.1)).is_none()
        });
        match couple {
            Some(couple) => Err(self.missing(Key::MomentElevation, couple.of.1).and(Table::Joint)),
            None => Ok(()),
        }
    }

    fn joint<T: Scalar>(&self, index: usize, case: &Case<T>) -> Result<CaseJoint<T>, Fault> {
        let id = |key| Id::new(key, index);
        let number = |key| self.inputs.scalar::<T>(id(key));
        let needed = |key| number(key).ok_or_else(|| self.missing(key, index));
        let elevation = needed(Key::JointElevation)?;
        let friction = needed(Key::JointFriction)?;
        let kinetic_friction = number(Key::JointKineticFriction).unwrap_or_else(|| friction.clone());
        let [slips, sticks] = [&kinetic_friction, &friction].map(T::value);
        if slips > sticks {
            let problem = Problem::KineticFriction { kinetic: slips, friction: sticks };
            return Err(Fault::new(problem, id(Key::JointKineticFriction)));
        }
        let level = elevation.value();
        let crest = case.body.height().value();
        if level >= crest {
            let problem = Problem::JointAboveCrest { level, crest };
            return Err(Fault::new(problem, id(Key::JointElevation)));
        }
        let cut = |error| Fault::new(Problem::Cut(error), id(Key::JointElevation));
        let piece = match &case.section {
            Some(section) => Some(section.above(level, case.water_table).map_err(cut)?),
            None => None,
        };
        let JointEnds { ends, contact, gaps } = self.joint_ends(index, case, piece.as_ref())?;
        let above = match (&case.section, &piece) {
            (Some(section), Some(piece)) => {
                AboveJoint::of_section(&case.body, section, piece, elevation, contact)
            }
            _ => AboveJoint::of_block(&case.body, elevation, contact),
        };
        let above = above.map_err(|error| match error.quantity {
            Quantity::CentroidOffset => {
                let fault = |place: Place| Fault::new(Problem::BesideJoint { level }, place);
                match [Key::JointLeft, Key::JointRight].map(|key| number(key).map(|_| Id::new(key, index))) {
                    [Some(left), Some(right)] => fault(left.into()).and(right),
                    [Some(end), None] | [None, Some(end)] => fault(end.into()),
                    [None, None] => fault(Place::Table(Table::Joint, index)),
                }
            }
            _ => self.blame(Table::Body, error),
        })?;
        Ok(CaseJoint {
            name: self.inputs.text(id(Key::JointName)).map(str::to_owned),
            index,
            friction,
            kinetic_friction,
            water: self.joint_water(index, level, case)?,
            ends,
            gaps,
            added_mass: self.added_mass_above(&above, case)?,
            above,
            piece,
        })
    }

    /// The ends of a joint.
    fn joint_ends<T: Scalar>(
        &self,
        index: usize,
        case: &Case<T>,
        piece: Option<&Piece>,
    ) -> Result<JointEnds<T>, Fault> {
        let id = |key| Id::new(key, index);
        let keys = [Key::JointLeft, Key::JointRight];
        let given = keys.map(|key| self.inputs.scalar::<T>(id(key)));
        if let (Plan::Circle, Some(key)) =
            (case.body.plan(), keys.into_iter().find(|key| self.inputs.number(id(*key)).is_some()))
        {
            return Err(Fault::new(Problem::NotOfCylinder { key }, id(key)));
        }
        let half = case.body.width() / T::of(2.0);
        // Without parts, from O; the block counts from its mid-width.
        let origin = if piece.is_some() { T::of(0.0) } else { half.clone() };
        let scale = self.number(Key::WidthScale).map_or_else(|| T::of(1.0), T::written);
        let whole = match piece {
            Some(piece) => piece.contact.map(T::computed),
            None => [T::of(0.0), case.body.width()],
        };
        let [from, to] = whole.each_ref().map(T::value);
        let slack = 1e-6 * (to - from);
        let mut ends = whole.clone();
        for ((end, given), key) in ends.iter_mut().zip(given).zip(keys) {
            let Some(given) = given else { continue };
            let given = given * scale.clone();
            if given.value() < from - slack || given.value() > to + slack {
                let problem = Problem::BesideContact { key, value: given.value(), from, to };
                return Err(Fault::new(problem, id(key)));
            }
            *end = given;
        }
        let [left, right] = ends.each_ref().map(T::value);
        if right - left <= slack {
            let problem = Problem::NoJoint { left, right };
            return Err(Fault::new(problem, id(Key::JointRight)).and(id(Key::JointLeft)));
        }
        let contact = ends.each_ref().map(|end| end.clone() - origin.clone());
        let [from, to] = whole;
        // What rounding leaves of a number given where the contact ends is no gap.
        let gaps = [ends[0].clone() - from, to - ends[1].clone()]
            .map(|gap| if gap.value() > slack { gap } else { T::of(0.0) });
        Ok(JointEnds { ends, contact, gaps })
    }

    /// Water in a joint, which has to be said where something that may be water reaches above it.
    fn joint_water<T: Scalar>(
        &self,
        index: usize,
        level: f64,
        case: &Case<T>,
    ) -> Result<JointWater<T>, Fault> {
        let id = |key| Id::new(key, index);
        let given = [Key::JointUpliftLeft, Key::JointUpliftRight].map(|key| self.inputs.scalar::<T>(id(key)));
        match (self.inputs.choice(id(Key::JointUplift)), given) {
            (Some(_), [Some(_), _] | [_, Some(_)]) => {
                let (one, two) = (Key::JointUplift, Key::JointUpliftLeft);
                Err(Fault::new(Problem::Both { one, two }, id(one)))
            }
            (None, [Some(left), Some(right)]) => {
                let grows = self.inputs.truth(id(Key::JointGrows)).unwrap_or(false);
                let pressed = Uplift::new(left, right, grows);
                pressed.map(JointWater::Given).map_err(|error| {
                    Fault::new(
                        Problem::Impossible { key: Key::JointUpliftLeft, error },
                        id(Key::JointUpliftLeft),
                    )
                })
            }
            (None, [None, Some(_)]) => Err(self.missing(Key::JointUpliftLeft, index)),
            (None, [Some(_), None]) => Err(self.missing(Key::JointUpliftRight, index)),
            (_, [None, None]) if self.inputs.get(id(Key::JointGrows)).is_some() => {
                Err(self.missing(Key::JointUpliftLeft, index))
            }
            (Some("tight"), _) => Ok(JointWater::Tight),
            (Some(_), _) if case.water.is_none() && case.wave.is_none() => {
                Err(Fault::new(Problem::NothingOpen { level }, id(Key::JointUplift)))
            }
            (Some(_), _) => Ok(JointWater::Open),
            (None, _) => match case.reaches_above(level) {
                Some(what) => {
                    let problem = Problem::JointWater { level, what };
                    Err(Fault::new(problem, Place::Table(Table::Joint, index)))
                }
                None => Ok(JointWater::Dry),
            },
        }
    }

    /// Water that moves with what is above a joint.
    fn added_mass_above<T: Scalar>(
        &self,
        above: &AboveJoint<T>,
        case: &Case<T>,
    ) -> Result<AddedMass<T>, Fault> {
        let none = || AddedMass::NONE.computed();
        let level = above.level();
        if let (Some(mass), Some(elevation)) =
            (self.scalar::<T>(Key::WaterMass), self.scalar::<T>(Key::WaterElevation))
        {
            if !above.reaches(&elevation) {
                return Ok(none());
            }
            let water = AddedMass::of(mass).and_then(|water| water.at(elevation - level));
            return water.map_err(|error| self.blame(Table::AddedMass, error));
        }
        let Some((density, depths)) = self.moving_water(case.water.as_ref(), case.wave.as_ref())? else {
            return Ok(none());
        };
        let side = case.body.plan().side(case.body.width()).value();
        let water = AddedMass::beside_above(density * side, &depths, level.value());
        water.map(AddedMass::computed).map_err(|error| self.blame(Table::AddedMass, error))
    }
}

impl<T: Scalar> Case<T> {
    /// What may be water and reaches above a level, in words.
    fn reaches_above(&self, level: f64) -> Option<&'static str> {
        let water = |level: f64| {
            let levels = self.water.as_ref().map(|water| [water.left().value(), water.right().value()]);
            levels.is_some_and(|levels| levels.into_iter().any(|side| side > level))
        };
        let on_side = |face: Face| matches!(face, Face::Left | Face::Right);
        let highest = |diagram: &PressureDiagram| {
            diagram.points().last().map_or(f64::NEG_INFINITY, |point| point.position)
        };
        let wave = self.wave.as_ref().is_some_and(|wave| {
            let loads = wave.loads(&self.body.rounded()).into_iter();
            loads.map(|load| load.action).any(|action| {
                matches!(&action, Action::Pressure { face, diagram } if on_side(*face) && highest(diagram) > level)
            })
        });
        let pressure = self.pressures.iter().any(|pressure| {
            let top = pressure.diagram.points().last().map(|point| point.position.value());
            on_side(pressure.face) && top.is_some_and(|top| top > level)
        });
        match () {
            () if water(level) => Some("water reaches"),
            () if wave => Some("waves reach"),
            () if pressure => Some("a [[pressure]], which may be of water, reaches"),
            () => None,
        }
    }

    /// What is above each joint under the loads that act, the whole first; `None` of a body without joints.
    fn jointed(&self, acting: Acting, trial: Trial) -> Result<Option<Jointed<T>>, InputError> {
        let case = self.under(acting);
        if case.joints.is_empty() {
            return Ok(None);
        }
        let mut all = vec![OnJoint::whole(self.loaded(acting, trial)?)];
        for joint in &case.joints {
            all.push(OnJoint::above(&joint.above, self.loaded_above(joint, acting, trial)?));
        }
        Ok(Some(Jointed::new(all)))
    }

    /// What is above a joint under the loads that act.
    fn loaded_above(
        &self,
        joint: &CaseJoint<T>,
        acting: Acting,
        trial: Trial,
    ) -> Result<Situation<T>, InputError> {
        let case = self.under(acting);
        let situation =
            Situation::new(joint.above.body().clone(), joint.friction.clone(), case.gravity.clone())?
                .with_kinetic_friction(joint.kinetic_friction.clone())?
                .with_added_mass(joint.added_mass.clone());
        let shaken =
            trial.shaking.and_then(|shaking| case.shaken(shaking)).or_else(|| case.earthquake.clone());
        let loads = case.loads_above(joint, acting, shaken);
        Ok(situation.with_all(self.factored(loads, joint.above.body(), acting, trial)))
    }

    /// All loads above a joint but for alternatives to the one that acts, and what each is of.
    fn loads_above(
        &self,
        joint: &CaseJoint<T>,
        acting: Acting,
        earthquake: Option<Earthquake<T>>,
    ) -> Vec<(LoadOrigin, Load<T>)> {
        let mut loads = self.weights(acting, Some(joint));
        let water = LoadOrigin::Table(Table::Water);
        for (of, load) in self.loads(acting, earthquake.clone()) {
            match load.source {
                // Of what is above these are others.
                LoadSource::Weight | LoadSource::WaterOnLeft | LoadSource::WaterOnRight => {}
                LoadSource::ShakenWater => {
                    let of_base = earthquake.iter().flat_map(|base| base.loads(&joint.added_mass));
                    let shaken = of_base.filter(|load| load.source == LoadSource::ShakenWater);
                    loads.extend(shaken.map(|load| (of, load.fast())));
                }
                _ => {
                    let acts = match of {
                        LoadOrigin::Force(index, _) => self.acts_above(joint, &self.forces[index]),
                        _ => true,
                    };
                    let part = if acts { joint.above.load(&self.body, &load) } else { None };
                    loads.extend(part.map(|load| (of, load)));
                }
            }
        }
        if let (Some(still), Some(section), Some(piece)) = (&self.water, &self.section, &joint.piece) {
            let still = still.rounded();
            let unit_weight = still.density() * self.gravity.value();
            let on_sides =
                joint.above.water_on_sides(section, piece, [still.left(), still.right()], unit_weight);
            loads.extend(on_sides.into_iter().map(|load| (water, load)));
        }
        loads.extend(self.water_in(joint));
        loads
    }

    /// True if a force may act above a joint, where not its elevation alone says so: a couple acts where it is said to, a vertical force of which
    /// no elevation is said on the top there, which of a ledge at the joint is below it.
    fn acts_above(&self, joint: &CaseJoint<T>, force: &PointForce<T>) -> bool {
        let given = |key: Key| self.inputs.scalar::<T>(Id::of(force.of.0, force.of.1, key));
        match (force.direction, given(Key::Elevation), &self.section) {
            (Direction::Turning(_), ..) => {
                given(Key::MomentElevation).is_none_or(|elevation| joint.above.reaches(&elevation))
            }
            (Direction::Down | Direction::Up, None, Some(section)) => {
                let [left, _] = section.base();
                let x = force.distance.as_ref().map(|distance| left + distance.value());
                let level = joint.level().value();
                x.and_then(|x| section.top_at(x)).is_none_or(|top| top > level * (1.0 + 1e-9))
            }
            _ => true,
        }
    }

    /// Water in a joint and in the gaps beside it.
    fn water_in(&self, joint: &CaseJoint<T>) -> Vec<(LoadOrigin, Load<T>)> {
        let body = joint.above.body();
        let mut loads = Vec::new();
        let mut still = |side: Face, action: Action<T>| {
            let load = Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, action);
            loads.push((LoadOrigin::JointWater(side), load));
        };
        let pressures = self.still_pressures(joint.level());
        let waves = self.wave_pressures(&joint.level());
        // In an open joint still water from each end to nothing at the other, so that each has the factors of what makes it.
        if joint.water == JointWater::Open {
            let [left, right] = pressures.clone();
            let zero = || T::of(0.0);
            for (side, [left, right]) in [(Face::Left, [left, zero()]), (Face::Right, [zero(), right])] {
                if (left.value(), right.value()) != (0.0, 0.0) {
                    still(side, Action::base_pressure(body, left, right));
                }
            }
        }
        for (side, pressure) in [Face::Left, Face::Right].into_iter().zip(pressures) {
            if let Some(action) = joint.lift_in_gap(side, pressure) {
                still(side, action);
            }
        }
        let mut wave = |action: Action<T>| {
            let load = Load::variable(LoadSource::WaveUplift, LoadKind::Uplift, action);
            loads.push((LoadOrigin::Table(Table::Wave), load.fast()));
        };
        if joint.water == JointWater::Open && waves != [0.0, 0.0] {
            let [left, right] = waves.map(T::computed);
            wave(Action::base_pressure(body, left, right));
        }
        for (side, pressure) in [Face::Left, Face::Right].into_iter().zip(waves) {
            if let Some(action) = joint.lift_in_gap(side, T::computed(pressure)) {
                wave(action);
            }
        }
        if let JointWater::Given(uplift) = &joint.water {
            loads.push((LoadOrigin::Table(Table::Uplift), uplift.load(body)));
        }
        loads
    }

    /// The pressures of still water beside a level, left and right.
    fn still_pressures(&self, level: T) -> [T; 2] {
        let Some(still) = &self.water else { return [T::of(0.0), T::of(0.0)] };
        let unit_weight = still.density() * self.gravity.clone();
        [still.left(), still.right()].map(|surface| {
            let depth = surface - level.clone();
            if depth.value() > 0.0 { unit_weight.clone() * depth } else { T::of(0.0) }
        })
    }

    /// The pressures of waves beside a level, left and right.
    fn wave_pressures(&self, level: &T) -> [f64; 2] {
        let Some(wave) = &self.wave else { return [0.0, 0.0] };
        let loads = wave.loads(&self.body.rounded());
        [Face::Left, Face::Right].map(|face| {
            let at = loads.iter().filter_map(|load| match &load.action {
                Action::Pressure { face: on, diagram } if *on == face => Some(diagram.at(&level.value())),
                _ => None,
            });
            at.sum()
        })
    }
}

impl<T: Scalar> CaseJoint<T> {
    /// What a pressure beside the joint lifts where the bodies do not bear at a side.
    fn lift_in_gap(&self, side: Face, pressure: T) -> Option<Action<T>> {
        let [left, right] = self.gaps.clone();
        let (body, half) = (self.above.body(), |gap: &T| gap.clone() / T::of(2.0));
        let edges = body.base_edges();
        let (gap, x) = match side {
            Face::Left => (left.clone(), T::of(0.0) - edges.left - half(&left)),
            _ => (right.clone(), edges.right + half(&right)),
        };
        if gap.value() <= 0.0 || pressure.value() == 0.0 {
            return None;
        }
        let up = pressure * gap * body.plan().side(body.width());
        Some(Action::Force { at: BodyPoint { x, y: T::of(0.0) }, right: T::of(0.0), up })
    }
}

impl Case {
    /// What is above a joint, by its place, under the loads that act, as one body; as [`situation`](Case::situation) has the whole.
    ///
    /// # Errors
    /// If the numbers of a changed case are out of range.
    ///
    /// # Panics
    /// If there is no such joint.
    pub fn above_joint(&self, place: usize, acting: Acting, trial: Trial) -> Result<Situation, InputError> {
        let case = self.under(acting);
        let joint = &case.joints[place];
        let situation = self.loaded_above(joint, acting, trial)?;
        let shaken = trial.shaking.and_then(|shaking| case.shaken(shaking)).or(case.earthquake);
        let loads = case.loads_above(joint, acting, shaken);
        Ok(match self.effects(&situation, loads, acting, trial) {
            Some(effects) => situation.with_effects(effects),
            None => situation,
        })
    }

    /// The situation of what is above a joint, decided by the numbers as they are written.
    pub fn above_as_written(
        &self,
        situation: Situation,
        place: usize,
        acting: Acting,
        trial: Trial,
    ) -> Situation {
        let written = self.written(acting).and_then(|written| {
            let joint = written.joints.get(place)?;
            written.loaded_above(joint, acting, trial).ok()
        });
        match written {
            Some(written) => situation.as_written(&written),
            None => situation,
        }
    }

    /// What is above each joint under the loads that act, the whole first; `None` of a body without joints.
    ///
    /// # Errors
    /// If the numbers of a changed case are out of range.
    pub fn on_joints(&self, acting: Acting, trial: Trial) -> Result<Option<Jointed>, InputError> {
        self.jointed(acting, trial)
    }

    /// The same in the numbers as they are written.
    pub fn on_joints_as_written(&self, acting: Acting, trial: Trial) -> Option<Jointed<Ball>> {
        self.written(acting)?.jointed(acting, trial).ok().flatten()
    }

    /// Levels at which its parts could be parted by a joint and are not, m above the base.
    pub fn glued_at(&self) -> Vec<f64> {
        let joints: Vec<f64> = self.joints.iter().map(CaseJoint::level).collect();
        self.section.as_ref().map_or_else(Vec::new, |section| seams(section, &joints))
    }
}

/// Levels at which parts of a body end that are as wide as all that is there: where a joint could be, and is not.
fn seams(section: &Section, joints: &[f64]) -> Vec<f64> {
    let crest = section.height();
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-3 * crest.min(1.0);
    let mut levels: Vec<f64> =
        section.parts().iter().flat_map(|part| part.outline()).map(|corner| corner.y).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup_by(|one, two| near(*one, *two));
    let crossed = |level: f64| {
        section.parts().iter().any(|part| {
            let y = || part.outline().iter().map(|corner| corner.y);
            let (low, high) = (y().fold(f64::INFINITY, f64::min), y().fold(f64::NEG_INFINITY, f64::max));
            low < level && level < high && !near(low, level) && !near(high, level)
        })
    };
    levels.retain(|level| {
        let inside = *level > 0.0 && *level < crest && !near(*level, 0.0) && !near(*level, crest);
        inside && !crossed(*level) && !joints.iter().any(|joint| near(*joint, *level))
    });
    levels
}
