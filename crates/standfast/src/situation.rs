//! A body and all loads on it: what it does under the full load, and on the way there.
//!
//! Loads are of two kinds: *permanent* (the weight, still water) and *variable* (waves with their uplift, earthquakes,
//! forces), which grow together by a load factor λ. Two questions are answered, and are not the same: what begins if the
//! whole variable load is applied at once (the report's question), and where the body first leaves rest while it rises.
//!
//! # The report's diagram with effective coordinates
//!
//! For P > 0 only X/P and M/P matter. So for a uniform block **any** load is a point of the report's plane:
//!
//! ```text
//! k_eff = |X|/P        k'_eff = −M/(X H)
//! ```
//!
//! with all accelerations and reactions times P/(m g); if X points right, everything is mirrored.
//!
//! ```
//! use standfast::loads::{Action, Load, LoadKind, LoadSource};
//! use standfast::{Body, Departure, Mode, Situation, Verdict};
//!
//! // A caisson of 15 m by 12 m and 378 t/m, pushed with 1000 kN/m at 9 m.
//! let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-1e6, 9.0));
//! let situation = Situation::new(Body::new(15.0, 12.0, 378e3)?, 0.6, 9.81)?.with_weight().with(push);
//! let outcome = situation.outcome()?;
//! assert_eq!(outcome.full.mode(), Some(Mode::Rest));
//! let Departure::At { factor, verdict } = outcome.departure else { panic!() };
//! assert_eq!(verdict, Some(Verdict::Begins(Mode::SlideLeft)));
//! assert!((factor - 0.6 * 378e3 * 9.81 / 1e6).abs() < 1e-12);
//! # Ok::<(), standfast::InputError>(())
//! ```

use crate::ball::{Ball, Scalar};
use crate::body::Body;
use crate::contact::holding::Holding;
use crate::contact::path::stages;
use crate::contact::{self, Block, Choice, Solution, plane};
use crate::departure::Departure;
use crate::error::InputError;
use crate::exact::Real;
use crate::initiation::Point;
use crate::loads::{Action, AddedMass, HorizontalForce, Load, LoadId, LoadKind, LoadSource, Pose, Reduced};
use crate::mode::{Mode, Modes, Slip};
use crate::motion::Motion;
use crate::quantity::{Expected, Quantity};
use crate::region::Region;
use crate::relation::Relation;
use crate::stability::{self, ClassicalActions, GrossOverturning, Margins, Stability};
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

mod holding;
mod jointed;
mod on_plan;
mod opening;
mod written;

pub use holding::Held;
pub use jointed::{JointAnswer, JointDeparture, Jointed, OnJoint};
pub use on_plan::{PlanBase, PlanOutcome};
use opening::Opening;
pub use opening::{BaseOpening, OpeningRule};
pub use written::Boundary;
use written::{Written, WrittenChoice};

/// A body, its friction and its loads; SI units, per metre run.
#[derive(Debug, Clone, PartialEq)]
pub struct Situation<T = f64> {
    body: Body<T>,
    gravity: T,
    static_friction: T,
    kinetic_friction: T,
    added_mass: AddedMass<T>,
    loads: Vec<Load<T>>,
    /// Still water under the base, where it follows an opening.
    opening: Option<Opening>,
    /// What holds it beside friction.
    holding: Option<Holding>,
    /// The sum of its loads times partial factors that act on their effects alone, against which resistances count.
    effects: Option<Wrench>,
    /// Its base seen from above, where that is described.
    plan: Option<PlanBase<T>>,
    /// Its numbers as they are written, where they decide.
    written: Option<Box<Written>>,
}

/// Response of a body to a load that is applied at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// The total wrench at the centre of mass, N and N·m per metre run.
    pub wrench: Wrench,
    /// The verdict reported.
    pub verdict: Option<Verdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
    /// The wrench as a point of the report's plane, where it has one.
    pub effective: Option<Reduced>,
    /// Accelerations and reactions of the mode reported: m/s², rad/s², N per metre run, m.
    pub motion: Option<Motion>,
    /// The boundary that it stands on; `None` of one that stands on none, on a base that crushes, and where nobody has
    /// [asked](Situation::as_written).
    pub boundary: Option<Boundary>,
}

/// The answer to a situation: on a rigid base, or on one that [crushes](crate::ground::strength::outcome) or on ground that
/// [fails](crate::ground::bearing::outcome).
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Under the full load, applied at once.
    pub full: Response,
    /// Departure from rest as the variable loads rise.
    pub departure: Departure,
    /// The stages of the rising variable loads, the last without end; none where all loads are permanent.
    pub path: Vec<Stage>,
    /// The classical actions under the full load.
    pub actions: ClassicalActions,
    /// Safety factors and bearing pressure under the full load. They mean nothing for a body that is
    /// [lifted](Response::is_lifted).
    pub stability: Stability,
    /// Overturning by gross moments; it means nothing either for a body that is lifted.
    pub gross: GrossOverturning,
    /// Margins of the inequalities of rest under the full load.
    pub margins: Margins,
    /// What holds the body beside friction; `None` where nothing does.
    pub held: Option<Held>,
    /// The answer of a base seen from above, which takes the place of what the plane knows; `None` without one.
    pub plan: Option<PlanOutcome>,
}

impl Response {
    /// The mode reported; `None` where the ground fails, too.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict.and_then(Verdict::mode)
    }

    /// True if one mode only is consistent.
    pub fn is_unique(&self) -> bool {
        self.modes.len() <= 1
    }

    /// The consistent modes beside the one reported.
    pub fn others(&self) -> Modes {
        self.modes.without(self.mode())
    }

    /// True if nothing presses the body on its base any more: P ≤ 0.
    pub fn is_lifted(&self) -> bool {
        self.wrench.p <= 0.0
    }
}

impl Outcome {
    /// The mode in which a body that left rest under the rising loads comes to the full load: one that it began with it
    /// keeps for as long as it is consistent.
    pub fn risen(&self) -> Option<Mode> {
        let stages = self.path.iter().filter(|stage| stage.from < 1.0);
        stages.fold(None, |mode: Option<Mode>, stage| match mode {
            Some(mode) if stage.modes.contains(mode) => Some(mode),
            _ => stage.mode(),
        })
    }
}

impl<T: Scalar> Situation<T> {
    /// A body without loads, not even its weight, with one coefficient of friction, at `gravity` (m/s²).
    ///
    /// # Errors
    /// If `friction` is negative or `gravity` not above zero, or one of them not finite.
    pub fn new(body: Body<T>, friction: T, gravity: T) -> Result<Situation<T>, InputError> {
        let friction = InputError::not_negative(Quantity::Friction, friction)?;
        Ok(Situation {
            body,
            gravity: InputError::positive(Quantity::Gravity, gravity)?,
            static_friction: friction.clone(),
            kinetic_friction: friction,
            added_mass: AddedMass::of(T::of(0.0))?,
            loads: Vec::new(),
            opening: None,
            holding: None,
            effects: None,
            plan: None,
            written: None,
        })
    }

    /// Situation with less friction to slip than to stick.
    ///
    /// # Errors
    /// If it is negative or more than to stick.
    pub fn with_kinetic_friction(self, friction: T) -> Result<Situation<T>, InputError> {
        let kinetic_friction = InputError::not_negative(Quantity::KineticFriction, friction)?;
        if kinetic_friction.value() > self.static_friction.value() {
            let expected = Expected::NotAboveStaticFriction;
            return Err(InputError::new(Quantity::KineticFriction, kinetic_friction.value(), expected));
        }
        Ok(Situation { kinetic_friction, ..self })
    }

    /// Situation with water that a horizontal motion carries along.
    pub fn with_added_mass(self, water: AddedMass<T>) -> Situation<T> {
        Situation { added_mass: water, written: None, ..self }
    }

    /// Situation with the body's weight.
    pub fn with_weight(self) -> Situation<T> {
        self.with(Load::permanent(LoadSource::Weight, LoadKind::Weight, Action::Weight))
    }

    /// Situation with a load.
    pub fn with(mut self, load: Load<T>) -> Situation<T> {
        self.written = None;
        self.loads.push(load);
        self
    }

    /// Situation with loads.
    pub fn with_all(mut self, loads: impl IntoIterator<Item = Load<T>>) -> Situation<T> {
        self.written = None;
        self.loads.extend(loads);
        self
    }

    /// The body.
    pub fn body(&self) -> &Body<T> {
        &self.body
    }

    /// g, m/s².
    pub fn gravity(&self) -> T {
        self.gravity.clone()
    }

    /// μ to stick.
    pub fn static_friction(&self) -> T {
        self.static_friction.clone()
    }

    /// μ to slip; no more than to stick.
    pub fn kinetic_friction(&self) -> T {
        self.kinetic_friction.clone()
    }

    /// Mass of water that a horizontal motion carries along, kg per metre run.
    pub fn added_mass(&self) -> T {
        self.added_mass.mass()
    }

    /// Water that a horizontal motion carries along, with the height at which it presses.
    pub fn moved_water(&self) -> &AddedMass<T> {
        &self.added_mass
    }

    /// All loads.
    pub fn loads(&self) -> &[Load<T>] {
        &self.loads
    }

    /// Wrench of a load at the centre of mass of the body on its base.
    pub fn wrench_of(&self, load: &Load<T>) -> Wrench<T> {
        load.upright(&self.body, self.gravity())
    }

    /// The wrenches of the permanent and of the variable loads, and what a kind of load adds up to under the full load.
    fn sums(&self) -> Sums<T> {
        let mut sums = Sums {
            permanent: Wrench::zero(),
            variable: Wrench::zero(),
            by_kind: std::array::from_fn(|_| Wrench::zero()),
            buoyancy: Wrench::zero(),
        };
        let add = |sum: &mut Wrench<T>, wrench: &Wrench<T>| *sum = sum.clone().plus(wrench.clone());
        for load in &self.loads {
            let wrench = self.wrench_of(load);
            add(if load.permanent { &mut sums.permanent } else { &mut sums.variable }, &wrench);
            add(&mut sums.by_kind[load.kind as usize], &wrench);
            if load.source == LoadSource::Buoyancy {
                add(&mut sums.buoyancy, &wrench);
            }
        }
        sums
    }
}

impl Situation {
    /// The total wrench under a load factor, for any pose of the body.
    pub fn wrench_at(&self, factor: f64, pose: Pose) -> Wrench {
        let [permanent, variable] = [true, false].map(|permanent| {
            let loads = self.loads.iter().filter(|load| load.permanent == permanent);
            loads.map(|load| load.wrench(&self.body, self.gravity, pose)).sum::<Wrench>()
        });
        permanent + variable * factor
    }

    /// Situation without the loads of a number.
    pub fn without(&self, id: LoadId) -> Situation {
        let loads = self.loads.iter().filter(|load| load.id != id).cloned().collect();
        Situation { loads, written: None, ..self.clone() }.reopened()
    }

    /// Situation whose resistances, which are those of its loads, count against other sums of these: X and P each times partial factors.
    pub fn with_effects(self, effects: Wrench) -> Situation {
        Situation { effects: Some(effects), written: None, ..self }
    }

    /// The sums against which resistances count, where they are others than those of the loads.
    pub fn effects(&self) -> Option<Wrench> {
        self.effects
    }

    /// The classical actions under the full load.
    fn actions(&self, by_kind: &[Wrench; 3]) -> ClassicalActions {
        let of = |kind: LoadKind| by_kind[kind as usize];
        let (weight, uplift, horizontal) =
            (of(LoadKind::Weight), of(LoadKind::Uplift), of(LoadKind::Horizontal));
        // A load of one kind may have a part of the other, as an earthquake has; that part acts at C.
        let vertical = Wrench { p: weight.p + horizontal.p, ..weight };
        let sideways = Wrench { x: horizontal.x + weight.x + uplift.x, ..horizontal };
        ClassicalActions::of(&self.body, &vertical, &uplift, &sideways)
    }

    /// The block of the [contact problem](crate::contact), with lengths in B and masses in m.
    pub fn reduced_block(&self) -> InHalfWidths {
        let half_width = self.body.width() / 2.0;
        InHalfWidths(Block {
            b1: self.body.heel_distance() / half_width,
            b2: self.body.toe_distance() / half_width,
            d: self.body.centroid_height() / half_width,
            rho2: self.body.moment_of_inertia() / (self.body.mass() * half_width * half_width),
            m_x: 1.0 + self.added_mass() / self.body.mass(),
            m_y: 1.0,
            mu_s: self.static_friction,
            mu_k: self.kinetic_friction,
        })
    }

    /// A wrench with forces in m g and lengths in B.
    pub fn reduced_wrench(&self, wrench: &Wrench) -> Wrench {
        let weight = self.body.mass() * self.gravity;
        let half_width = self.body.width() / 2.0;
        Wrench { x: wrench.x / weight, p: wrench.p / weight, m: wrench.m / (weight * half_width) }
    }

    /// The point of the report's plane for a total wrench: (k_eff, k'_eff) of a uniform body that presses on its base (P > 0)
    /// and that a horizontal force acts on (X ≠ 0). `None` also where X is so small beside M or P that its elevation is
    /// out of all range.
    pub fn effective(&self, wrench: &Wrench) -> Option<Reduced> {
        if !self.is_ordinary() || wrench.p <= 0.0 || wrench.x == 0.0 {
            return None;
        }
        let k = wrench.x.abs() / wrench.p;
        let k_prime = -wrench.m / (wrench.x * (self.body.height() / 2.0));
        let point = Point::new(self.body.slenderness(), k_prime, k, self.static_friction).ok()?;
        Some(Reduced { point, mirrored: wrench.x > 0.0 })
    }

    /// True if the body is the report's: uniform, with one friction, without water that moves with it.
    fn is_ordinary(&self) -> bool {
        self.body.is_uniform() && self.added_mass() == 0.0 && self.static_friction == self.kinetic_friction
    }

    /// The report's problem itself, where the situation is nothing else: one horizontal force beside the weight. Its numbers
    /// are those of the force, without the rounding that a moment about C would bring in.
    pub fn in_air(&self) -> Option<Reduced> {
        let [
            Load { action: Action::Weight, permanent: true, factor: 1.0, .. },
            Load { action, permanent: false, factor, .. },
        ] = self.loads.as_slice()
        else {
            return None;
        };
        let Action::Force { at, right, up: 0.0 } = *action else { return None };
        let direction = if right > 0.0 { Slip::Right } else { Slip::Left };
        let force = HorizontalForce::new(right.abs() * factor, at.y, direction).ok()?;
        force.reduce(&self.body, self.static_friction, self.gravity).ok().filter(|_| self.is_ordinary())
    }

    /// Response if the variable load, times `factor`, is applied at once.
    ///
    /// # Errors
    /// If a number is out of range.
    pub fn at(&self, factor: f64) -> Result<Response, InputError> {
        let factor = InputError::finite(Quantity::LoadFactor, factor)?;
        let wrench = self.total_at(factor);
        let lone = self.in_air().filter(|_| factor == 1.0);
        self.response(factor, wrench, lone.or_else(|| self.effective(&wrench)))
    }

    fn response(
        &self,
        factor: f64,
        wrench: Wrench,
        effective: Option<Reduced>,
    ) -> Result<Response, InputError> {
        if self.plan.is_some() {
            return Ok(Response::unknown(wrench));
        }
        if let Some(response) = self.response_as_held(factor, wrench)? {
            return Ok(response);
        }
        if let Some(response) = self.response_as_it_opens(factor, wrench)? {
            return Ok(response);
        }
        let weight = self.body.mass() * self.gravity;
        let half_width = self.body.width() / 2.0;
        let scaled = |motion: Motion| motion.scaled(self.gravity, half_width, weight);
        Ok(match (&self.written, effective) {
            (Some(written), _) => {
                let factor = Ball::of(factor);
                let WrittenChoice { choice: Choice { modes, mode }, boundary } = written.choice(&factor);
                let motion = mode.map(|mode| scaled(written.motion(&factor, mode)));
                let effective = effective.map(|reduced| reduced.beside(mode));
                Response { wrench, verdict: mode.map(Verdict::Begins), modes, effective, motion, boundary }
            }
            // The report's closed form, scaled by P.
            (None, Some(reduced)) => {
                let mut modes = reduced.others();
                modes.insert(reduced.mode());
                let acceleration = self.gravity * (wrench.p / weight);
                let motion = reduced.motion().scaled(acceleration, half_width, wrench.p);
                let (verdict, motion) = (Some(Verdict::Begins(reduced.mode())), Some(motion));
                Response { wrench, verdict, modes, effective, motion, boundary: None }
            }
            (None, None) => {
                let solution = self.solve(&wrench)?;
                let motion = solution.mode().and_then(|mode| solution.motion(mode)).map(scaled);
                let verdict = solution.mode().map(Verdict::Begins);
                Response { wrench, verdict, modes: solution.modes, effective, motion, boundary: None }
            }
        })
    }

    /// The conditions of the mode of a response of this situation, with the numbers of its motion. Where written numbers decide, those
    /// that f64 cannot tell from their boundary are said to be on it.
    pub fn explain(&self, response: &Response) -> Vec<Relation> {
        let Some(mode) = response.mode() else { return Vec::new() };
        let by_motion = self.is_as_written() || self.opening.is_some() || self.holding.is_some();
        let (true, Some(motion)) = (by_motion, &response.motion) else {
            return self
                .solve(&response.wrench)
                .map_or_else(|_| Vec::new(), |solution| solution.explain(mode));
        };
        let [weight, half_width] = [self.body.mass() * self.gravity, self.body.width() / 2.0];
        let motion = motion.scaled(1.0 / self.gravity, 1.0 / half_width, 1.0 / weight);
        let block = self.reduced_block().0;
        let adhesion = self.reduced_holding().map_or(0.0, |holding| {
            let held = Wrench {
                x: 0.0 - motion.f_x,
                p: motion.f_y,
                m: -(motion.f_x * block.d + motion.f_y * motion.xi),
            };
            holding.adhesion.map_or(0.0, |adhesion| adhesion.strength * holding.adhering(&block, &held))
        });
        let relations = contact::relations(&block, mode, &motion, adhesion);
        relations.into_iter().map(|relation| self.settled(relation)).collect()
    }

    /// The inequality with both sides on one number, where written numbers decide and f64 cannot tell the sides apart.
    pub fn settled(&self, relation: Relation) -> Relation {
        if self.is_as_written() { written::settled(relation) } else { relation }
    }

    /// True if the numbers that were written decide it.
    pub fn is_as_written(&self) -> bool {
        self.written.is_some()
    }

    /// True if rounding in f64 could put it on the other side of a boundary, under its permanent loads or under the full load: it is then
    /// worth saying what its numbers are [as they are written](Situation::as_written).
    pub fn is_near_boundary(&self) -> bool {
        written::is_near(self)
    }

    /// Situation decided by the same one in the numbers that were written.
    /// What holds it beside friction is not told by these.
    pub fn as_written(self, exact: &Situation<Ball>) -> Situation {
        if self.holding.is_some() {
            return self;
        }
        Situation { written: Some(Box::new(Written::of(exact))), ..self }
    }

    /// The contact problem under a total wrench, in the units of [`reduced_block`](Situation::reduced_block).
    ///
    /// # Errors
    /// If a number is out of range.
    pub fn solve(&self, wrench: &Wrench) -> Result<Solution, InputError> {
        contact::solve(&self.reduced_block().0, &self.reduced_wrench(wrench))
    }

    /// The stages of the variable loads that rise from nothing without end.
    ///
    /// # Errors
    /// If a number is out of range.
    pub fn path(&self) -> Result<Vec<Stage>, InputError> {
        if self.plan.is_some() {
            return Ok(Vec::new());
        }
        if let Some(stages) = self.path_as_held()? {
            return Ok(stages);
        }
        if let Some(stages) = self.path_as_it_opens()? {
            return Ok(stages);
        }
        if let Some(written) = &self.written {
            return Ok(written.path());
        }
        let Sums { permanent, variable, .. } = self.sums();
        stages(&self.reduced_block().0, &self.reduced_wrench(&permanent), &self.reduced_wrench(&variable))
    }

    /// The regions of the plane of load factor and static friction, up to a load factor; see [`plane`].
    ///
    /// # Errors
    /// If a number is out of range, or `up_to` is not above zero.
    pub fn plane(&self, up_to: f64) -> Result<Vec<Region>, InputError> {
        if self.plan.is_some() {
            return Ok(Vec::new());
        }
        let Sums { permanent, variable, .. } = self.sums();
        let [permanent, variable] = [permanent, variable].map(|wrench| self.reduced_wrench(&wrench));
        plane::regions(&self.reduced_block().0, &permanent, &variable, up_to)
    }

    /// Everything: under the full load, on the way there, and by the classical checks.
    ///
    /// # Errors
    /// If a number is out of range.
    pub fn outcome(&self) -> Result<Outcome, InputError> {
        if let Some(outcome) = self.outcome_on_plan()? {
            return Ok(outcome);
        }
        let sums = self.sums();
        let wrench = sums.permanent.plus(sums.variable);
        let full = self.response(1.0, wrench, self.in_air().or_else(|| self.effective(&wrench)))?;
        let varies = self.loads.iter().any(|load| !load.permanent);
        let path = if varies { self.path()? } else { Vec::new() };
        let departure = self.departure(&path, &sums.permanent)?;
        let actions = self.actions(&sums.by_kind);
        let mut margins = actions.margins(self.static_friction, &self.body);
        let mut stability = actions.stability(self.static_friction, &self.body);
        let mut gross = GrossOverturning::of(&self.body, &actions, &sums.buoyancy);
        let held = self.held_at_full(&wrench, actions.heel)?;
        if let Some(held) = &held {
            self.strengthen(held, &wrench, &actions, (&mut margins, &mut stability, &mut gross));
        }
        if self.effects.is_some() || held.is_some() {
            let more = held.map_or(0.0, |held| held.adhesion + held.against);
            let resistance = self.static_friction * (actions.buoyant_weight - actions.uplift) + more;
            let push = self.effects.map_or(actions.force, |effects| effects.x.abs());
            stability.sliding = stability::ratio(resistance, push);
            margins.sliding = resistance - push;
        }
        if let Some(written) = &self.written {
            written.settle(&self.body, actions.heel, (&mut margins, &mut stability, &mut gross));
        }
        Ok(Outcome { full, departure, path, actions, stability, gross, margins, held, plan: None })
    }

    fn departure(&self, path: &[Stage], permanent: &Wrench) -> Result<Departure, InputError> {
        if let Some(begin) = self.begins_as_held()? {
            return Departure::along(begin.map(Verdict::Begins), path.iter().copied().map(Ok));
        }
        let begin = match (self.followed(0.0)?, &self.written) {
            (Some(found), _) => found.mode,
            (None, Some(written)) => written.choice(&Ball::of(0.0)).choice.mode,
            (None, None) if self.opening.is_some() => self.solve(&self.total_at(0.0))?.mode(),
            (None, None) => self.solve(permanent)?.mode(),
        };
        Departure::along(begin.map(Verdict::Begins), path.iter().copied().map(Ok))
    }
}

/// Error of a number that was made of few in f64, as a share of the sizes of its parts.
const SUMMED: f64 = 1e-13;

/// A block with lengths in B, half the width of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InHalfWidths(pub Block);

/// Sums of the loads.
struct Sums<T> {
    permanent: Wrench<T>,
    variable: Wrench<T>,
    /// In the order of [`LoadKind`].
    by_kind: [Wrench<T>; 3],
    /// Of the kind of the weight, what buoyancy is.
    buoyancy: Wrench<T>,
}
