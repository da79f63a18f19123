//! The base of a situation: how much it bears, and what is elastic of it.

use standfast::ground::bearing::{self, BearingPlane, Ground, LoadFactors, Reaction};
use standfast::ground::elastic::{ElasticBase, LargestMoment};
use standfast::ground::impact::{ElasticBody, ImpactResponse};
use standfast::ground::strength::{self, CrushMotion};
use standfast::{History, InputError, Outcome, Situation, Wrench};

mod because;

use crate::case::{Case, Foundation, Limit};

/// Response of the base in a situation.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseResponse {
    /// Limit of what the base can bear.
    pub limit: Option<Limit>,
    /// Reaction of a body at rest under the full load, per metre run; `None` if nothing presses.
    pub reaction: Option<Reaction>,
    /// ω = V/(2B q_u) of a base that crushes.
    pub omega: Option<f64>,
    /// Motion, and pressed part of the base, as the mode under the full load begins on a base that crushes.
    pub crush: Option<CrushMotion>,
    /// R, N per metre run or of the whole object: what the ground bears at the reaction's eccentricity and inclination.
    pub resistance: Option<f64>,
    /// R/V.
    pub factor: Option<f64>,
    /// R − V, N per metre run or of the whole object.
    pub margin: Option<f64>,
    /// Load factors at which R/V falls to 1 as the variable loads rise.
    pub load_factors: Option<LoadFactors>,
    /// |X|/V at which R/V is 1 if both X and the moment grow as they stand to each other under the full load.
    pub k_bf: Option<f64>,
    /// Elastic part of the response.
    pub elastic: Option<Elastic>,
}

/// Elastic part of the response of a base.
#[derive(Debug, Clone, PartialEq)]
pub struct Elastic {
    /// Under V of the full load, per metre run.
    pub base: ElasticBase,
    /// The moment of all loads about the middle of the base, N·m per metre run.
    pub moment: f64,
    /// By how much it turns the body, rad; `None` where no rotation bears it.
    pub rotation: Option<f64>,
    /// The most it bears if the load is raised slowly.
    pub largest: LargestMoment,
    /// |X|/V at which that is reached, as [`k_bf`](BaseResponse::k_bf).
    pub k_overturn: Option<f64>,
    /// Natural periods of sway and rocking, the longer first, and of heave, s; `None` where the centre of mass is off the middle of
    /// the base or there is no tangential stiffness.
    pub periods: Option<[f64; 3]>,
    /// The response to loads in time; `None` where none is given.
    pub impact: Option<ImpactResponse>,
    /// Point in the k–μ plane to which that moves the one of the full load: k and k'; `None` where other loads push or turn the body too.
    pub moved: Option<[f64; 2]>,
}

impl BaseResponse {
    /// The answer to a situation on the base of a case, and what that bears.
    pub(super) fn of(
        case: &Case,
        foundation: &Foundation,
        situation: &Situation,
    ) -> Result<(Outcome, BaseResponse), InputError> {
        let length = situation.body().plan().side(situation.body().width());
        let reaction = Reaction::of(situation, 1.0)?;
        let mut answer = BaseResponse {
            limit: foundation.limit,
            reaction,
            omega: None,
            crush: None,
            resistance: None,
            factor: None,
            margin: None,
            load_factors: None,
            k_bf: None,
            elastic: None,
        };
        let outcome = match foundation.limit {
            Some(Limit::Strength(strength)) => answer.crushing(situation, strength, length)?,
            Some(Limit::Ground(ground)) => answer.failing(situation, ground, length)?,
            None => situation.outcome()?,
        };
        // Partial factors on effects count against the resistance to the loads as they are.
        if let (Some(effects), Some(resistance)) = (situation.effects(), answer.resistance) {
            answer.factor = Some(resistance / effects.p);
            answer.margin = Some(resistance - effects.p);
        }
        if let (Some(stiffness), Some(reaction)) = (foundation.stiffness, reaction) {
            let elastic = Elastic::of(case, foundation, stiffness, situation, &reaction)?;
            answer.elastic = Some(elastic);
        }
        Ok((outcome, answer))
    }

    /// On ground that can fail.
    fn failing(&mut self, situation: &Situation, ground: Ground, length: f64) -> Result<Outcome, InputError> {
        let found = bearing::outcome(situation, ground)?;
        self.load_factors = Some(found.load_factors);
        let Some(reaction) = self.reaction else { return Ok(found.outcome) };
        self.bears(&reaction, ground.resistance(&reaction), ground.factor(&reaction), length);
        if let Some(ray) = ray(&reaction) {
            // Of G₁ = γ(1 + k') any γ and k' will do.
            let (gamma, k_prime) = match ray {
                0.0 => (1.0, -1.0),
                ray if ray < 0.0 => (-ray, -2.0),
                ray => (ray, 0.0),
            };
            let (half_width, p) = (reaction.half_width(), reaction.p());
            self.k_bf = Some(BearingPlane::new(ground, gamma, k_prime, half_width, p)?.k_bf());
        }
        Ok(found.outcome)
    }

    /// On a base that crushes at `strength`.
    fn crushing(&mut self, situation: &Situation, strength: f64, length: f64) -> Result<Outcome, InputError> {
        let found = strength::outcome(situation, strength)?;
        self.omega = Some(found.omega).filter(|_| self.reaction.is_some());
        self.load_factors = Some(LoadFactors { given: found.load_factor, less: None, more: None });
        self.crush = found.motion;
        if let Some(reaction) = self.reaction {
            let resistance = reaction.effective_width() * strength;
            self.bears(&reaction, resistance, resistance / reaction.p(), length);
            self.k_bf = ray(&reaction).map(|ray| (1.0 - found.omega).max(0.0) / ray.abs());
        }
        Ok(found.outcome)
    }

    /// Notes a resistance to a reaction, both per metre run, and their ratio.
    fn bears(&mut self, reaction: &Reaction, resistance: f64, factor: f64, length: f64) {
        self.resistance = Some(resistance * length);
        self.factor = Some(factor);
        self.margin = Some((resistance - reaction.p()) * length);
    }

    /// Distance of the reaction from the edge of a base that crushes, of a body that turns or is about to, m.
    pub fn pivot(&self) -> Option<f64> {
        let (omega, reaction) = (self.omega?, self.reaction?);
        match self.crush.as_ref().filter(|crush| crush.neutral.is_some()) {
            Some(crush) => Some(crush.pressed.width() / 2.0),
            // N = V as a turn begins.
            None => Some(omega * reaction.half_width()),
        }
    }

    /// Distance of the neutral point, about which a body turns, from the edge of a base that crushes, m; `None` of one that does not turn.
    pub fn neutral(&self) -> Option<f64> {
        self.crush.as_ref().filter(|crush| crush.neutral.is_some()).map(|crush| crush.pressed.width())
    }
}

/// ε/η: the eccentricity of a reaction in half widths by its inclination, G₁ of the report's block; negative where it lies against the push.
/// `None` of one that is upright.
fn ray(reaction: &Reaction) -> Option<f64> {
    let side = (reaction.x() * reaction.e()).signum();
    (reaction.x() != 0.0).then(|| side * reaction.eccentricity_share() / reaction.inclination())
}

impl Elastic {
    fn of(
        case: &Case,
        foundation: &Foundation,
        stiffness: f64,
        situation: &Situation,
        reaction: &Reaction,
    ) -> Result<Elastic, InputError> {
        let body = situation.body();
        let base = ElasticBase::new(reaction.half_width(), reaction.p(), stiffness)?;
        let base = match foundation.strength() {
            Some(strength) => base.with_strength(strength)?,
            None => base,
        };
        let moment = reaction.p() * reaction.e();
        let largest = base.largest_moment(body.centroid_height())?;
        let share = largest.moment / (reaction.p() * reaction.half_width());
        let centred = (body.heel_distance() - body.toe_distance()).abs() <= 1e-9 * body.base_width();
        let springs = foundation.tangential_stiffness.filter(|_| centred);
        let swaying = springs.map(|k_t| {
            let length = body.plan().side(body.width());
            let (mass, inertia) = (body.mass() / length, body.moment_of_inertia() / length);
            let body = ElasticBody::new(
                reaction.half_width(),
                body.centroid_height(),
                mass,
                inertia,
                stiffness,
                k_t,
            )?;
            let body = body.with_added_mass(situation.added_mass() / length)?;
            Ok::<_, InputError>((body, length))
        });
        let swaying = swaying.transpose()?;
        let periods =
            swaying.as_ref().map(|(body, _)| body.frequencies().map(|ω| std::f64::consts::TAU / ω));
        let impact = match &swaying {
            Some((body, length)) => response(case, foundation, situation, body, *length)?,
            None => None,
        };
        Ok(Elastic {
            base,
            moment,
            rotation: base.rotation(moment.abs()),
            largest,
            k_overturn: ray(reaction).map(|ray| share / ray.abs()),
            periods,
            moved: impact.as_ref().and_then(|impact| moved(situation, reaction, impact)),
            impact,
        })
    }
}

/// Point to which the loads in time move that of the full load, if nothing else pushes or turns the body.
fn moved(situation: &Situation, reaction: &Reaction, impact: &ImpactResponse) -> Option<[f64; 2]> {
    let others = situation.loads().iter().filter(|load| load.history.is_none());
    let alone = others.map(|load| situation.wrench_of(load)).all(|wrench| wrench.x == 0.0 && wrench.m == 0.0);
    // 1 + k' = M_O/(X d), both about the middle of the base.
    let (x, arm) = (reaction.x(), situation.body().centroid_height());
    let k_prime = reaction.e() * reaction.p() / (x * arm) - 1.0;
    let found = impact.moved(x.abs() / reaction.p(), k_prime).filter(|_| alone);
    found.filter(|moved| moved.iter().all(|number| number.is_finite()))
}

/// The response to the loads in time; those of which none is said are there all the time.
fn response(
    case: &Case,
    foundation: &Foundation,
    situation: &Situation,
    body: &ElasticBody,
    length: f64,
) -> Result<Option<ImpactResponse>, InputError> {
    // Where a motion is followed, histories are its own.
    if case.motion.is_some() {
        return Ok(None);
    }
    let mut standing = Wrench::ZERO;
    let mut timed: Vec<(Wrench, History)> = Vec::new();
    for load in situation.loads() {
        let wrench = situation.wrench_of(load) * (1.0 / length);
        match &load.history {
            Some(history) => timed.push((wrench, history.clone())),
            None => standing = standing + wrench,
        }
    }
    if timed.is_empty() || standing.p <= 0.0 {
        return Ok(None);
    }
    body.response(&standing, &timed, case.friction, foundation.strength()).map(Some)
}
