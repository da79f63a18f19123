//! Strength and stiffness of the base of a case.

use standfast::InputError;
use standfast::ground::bearing::{Ground, GroundLaw};
use standfast::{Body, History, Plan};

use super::history::ReadHistory;
use super::motion::CaseMotion;
use super::reader::Reader;
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};

/// Base that is not rigid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foundation {
    /// Its limit; `None` if nothing is said of that.
    pub limit: Option<Limit>,
    /// k_n, N/m³.
    pub stiffness: Option<f64>,
    /// k_t, N/m³.
    pub tangential_stiffness: Option<f64>,
}

/// Up to where a base bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// It crushes at this pressure, Pa.
    Strength(f64),
    /// The ground under it fails.
    Ground(Ground),
}

impl Foundation {
    /// The same with its resistance divided.
    pub(super) fn divided(self, by: f64) -> Foundation {
        let limit = self.limit.map(|limit| match limit {
            Limit::Strength(strength) => Limit::Strength(strength / by),
            Limit::Ground(ground) => Limit::Ground(ground.divided(by)),
        });
        Foundation { limit, ..self }
    }

    /// The pressure at which it crushes, Pa.
    pub fn strength(&self) -> Option<f64> {
        match self.limit {
            Some(Limit::Strength(strength)) => Some(strength),
            _ => None,
        }
    }

    /// The ground that fails.
    pub fn soil(&self) -> Option<Ground> {
        match self.limit {
            Some(Limit::Ground(ground)) => Some(ground),
            _ => None,
        }
    }
}

const SOIL: [Key; 4] = [Key::GroundAngle, Key::UnitWeight, Key::Surcharge, Key::Cohesion];
/// What clay that does not drain has no use for.
const DRAINED: [Key; 4] = [Key::GroundAngle, Key::UnitWeight, Key::Cohesion, Key::GroundLaw];
const ENVELOPE: [Key; 4] =
    [Key::CentricResistance, Key::EnvelopeHorizontal, Key::EnvelopeMoment, Key::EnvelopeCoupling];

impl Reader<'_> {
    /// The base.
    pub(super) fn ground(&self, body: &Body) -> Result<Foundation, Fault> {
        let has = |key: &Key| self.inputs.get(*key).is_some();
        let Some(first) = Table::Ground.keys().find(has) else {
            return Err(Fault::new(Problem::EmptyGround, Table::Ground));
        };
        if body.plan() == Plan::Circle {
            return Err(Fault::new(Problem::NotOfCylinder { key: first }, first));
        }
        let limit = match self.number(Key::Strength) {
            Some(strength) => {
                let others = [Key::UndrainedStrength, Key::GroundLaw];
                if let Some(with) = SOIL.iter().chain(&others).chain(&ENVELOPE).find(|key| has(key)) {
                    let problem = Problem::NotWith { key: Key::Strength, with: *with };
                    return Err(Fault::new(problem, Key::Strength).and(*with));
                }
                Some(Limit::Strength(strength))
            }
            None if has(&Key::UndrainedStrength) => {
                if let Some(with) = DRAINED.iter().chain(&ENVELOPE).find(|key| has(key)) {
                    let problem = Problem::NotWith { key: Key::UndrainedStrength, with: *with };
                    return Err(Fault::new(problem, Key::UndrainedStrength).and(*with));
                }
                Some(Limit::Ground(self.clay(body)?))
            }
            None if self.inputs.choice(Key::GroundLaw) == Some("envelope") => {
                if let Some(key) = SOIL.into_iter().find(has) {
                    return Err(Fault::new(Problem::OfEnvelope { key }, key).and(Key::GroundLaw));
                }
                Some(Limit::Ground(self.envelope(body)?))
            }
            None => {
                if let Some(key) = ENVELOPE.into_iter().find(has) {
                    return Err(Fault::new(Problem::NotEnvelope { key }, key));
                }
                let tells = has(&Key::GroundLaw) || SOIL.iter().any(has);
                tells.then(|| self.soil(body).map(Limit::Ground)).transpose()?
            }
        };
        let stiffness = self.number(Key::Stiffness);
        if has(&Key::TangentialStiffness) && stiffness.is_none() {
            return Err(Fault::new(
                Problem::MissingKey { table: Table::Ground, key: Key::Stiffness },
                Key::TangentialStiffness,
            ));
        }
        Ok(Foundation { limit, stiffness, tangential_stiffness: self.number(Key::TangentialStiffness) })
    }

    /// Ground with a friction angle.
    fn soil(&self, body: &Body) -> Result<Ground, Fault> {
        let (angle, weight) = (self.required(Key::GroundAngle)?, self.required(Key::UnitWeight)?);
        let law = match self.inputs.choice(Key::GroundLaw) {
            Some("hansen") => GroundLaw::Hansen,
            _ => GroundLaw::Ec7,
        };
        let ground = Ground::new(law, angle, weight)
            .and_then(|ground| ground.with_cohesion(self.number(Key::Cohesion).unwrap_or(0.0)))
            .and_then(|ground| self.beside(ground, body));
        ground.map_err(|error| self.blame(Table::Ground, error))
    }

    /// Clay that does not drain.
    fn clay(&self, body: &Body) -> Result<Ground, Fault> {
        let ground = Ground::undrained(self.required(Key::UndrainedStrength)?)
            .and_then(|ground| self.beside(ground, body));
        ground.map_err(|error| self.blame(Table::Ground, error))
    }

    /// Ground with what lies beside the base, and the length of the base where it is given.
    fn beside(&self, ground: Ground, body: &Body) -> Result<Ground, InputError> {
        let ground = ground.with_surcharge(self.number(Key::Surcharge).unwrap_or(0.0))?;
        match (self.number(Key::Length), body.plan()) {
            (Some(_), Plan::Rectangle { length }) => ground.with_length(length),
            _ => Ok(ground),
        }
    }

    /// Ground known by what it bears upright and in the middle; of an object of a given length that is for all of it.
    fn envelope(&self, body: &Body) -> Result<Ground, Fault> {
        let centric = self.required(Key::CentricResistance)? / body.plan().side(body.width());
        let or = |key, otherwise| self.number(key).unwrap_or(otherwise);
        let (t_h, t_m) = (or(Key::EnvelopeHorizontal, T_H), or(Key::EnvelopeMoment, T_M));
        let ground = Ground::envelope_with(centric, t_h, t_m, or(Key::EnvelopeCoupling, COUPLING));
        ground.map_err(|error| self.blame(Table::Ground, error))
    }

    /// The place at which a criterion is asked for: in `[criteria]`, or in the first combination that has it.
    fn asked_at(&self, key: Key) -> Option<Place> {
        let of_combinations = || {
            (0..self.inputs.count(Table::Combination)).find_map(|index| {
                let id = Id::new(Key::CombinationCriteria, index);
                let place = self.inputs.bounds(id)?.iter().position(|(asked, _)| *asked == key)?;
                Some(Place::Element(id, place))
            })
        };
        self.inputs.get(key).map(|_| key.into()).or_else(of_combinations)
    }

    /// Refuses criteria that the ground of the case cannot answer, and loads in time without the stiffnesses they need.
    pub(super) fn answerable(&self, ground: Option<&Foundation>) -> Result<(), Fault> {
        let limit = ground.is_some_and(|ground| ground.limit.is_some());
        let stiffness = ground.is_some_and(|ground| ground.stiffness.is_some());
        let tangential = ground.is_some_and(|ground| ground.tangential_stiffness.is_some());
        let asked = |key: Key| self.asked_at(key);
        if let Some(at) = asked(Key::LeastGround).filter(|_| !limit) {
            let (of, lacks) = (
                "what the ground bears",
                "[ground] has neither `strength` nor a friction angle nor an envelope",
            );
            let problem = Problem::NeedsGround { key: Key::LeastGround, of, lacks };
            return Err(Fault::new(problem, at));
        }
        if let Some(at) = asked(Key::GreatestRotation).filter(|_| !stiffness) {
            let (of, lacks) = ("how far the base lets the body turn", "[ground] has no `stiffness`");
            let problem = Problem::NeedsGround { key: Key::GreatestRotation, of, lacks };
            return Err(Fault::new(problem, at));
        }
        if self.inputs.is_in_time() {
            return Ok(());
        }
        let loads = (0..self.inputs.count(Table::Load)).map(|index| (Table::LoadHistory, index));
        let mut histories = loads.chain([(Table::WaveHistory, 0)]);
        match histories.find(|(table, index)| self.inputs.has_at(*table, *index)) {
            Some((table, index)) if !(stiffness && tangential) => {
                let lacks = if stiffness { "`tangential_stiffness`" } else { "`stiffness`" };
                Err(Fault::new(Problem::HistoryOnRigid { table, index, lacks }, Place::Table(table, index)))
            }
            _ => Ok(()),
        }
    }

    /// A history that was read, its warnings put beside those of the motion; on springs, the history if it is of straight lines.
    pub(super) fn taken(
        &self,
        read: Option<ReadHistory>,
        motion: Option<&mut CaseMotion>,
        table: Table,
        index: usize,
    ) -> Result<Option<History>, Fault> {
        match (read, motion) {
            (None, _) => Ok(None),
            (Some(read), Some(motion)) => Ok(Some(motion.take(read))),
            (Some(read), None) if read.history.corners().is_none() => {
                let id = Id::of(table, index, Key::HistoryShape);
                Err(Fault::new(Problem::SineOnSprings { table }, id))
            }
            (Some(read), None) => Ok(Some(read.history)),
        }
    }
}

/// Butterfield and Gottardi's slope of horizontal force.
pub const T_H: f64 = 0.52;
/// Theirs of moment.
pub const T_M: f64 = 0.35;
/// Their coupling of both.
pub const COUPLING: f64 = 0.22;
