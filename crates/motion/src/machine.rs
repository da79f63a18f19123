//! From event to event: the motion in power series, their first roots, and what happens there.

mod begin;
mod glide;
mod settle;
mod sliding;
mod step;

use standfast::contact::Block;
use standfast::{Corner, Mode, Modes, Slip};

use crate::decide::{
    Contact, DECIDING, Decider, Decision, Scales, Zero, base_moment, combined, on_base, turning,
};
use crate::error::MotionError;
use crate::forcing::{Channels, Forcing};
use crate::impact::{CORNERS, ImpactState, Law, kinetic, stuck};
use crate::moment::touching;
use crate::outcome::{End, Event, MotionOutcome, MotionStep, Why};
use crate::problem::{Initial, MotionProblem};
use crate::roots::{first_root, value};
use crate::series::{
    LEN, Motion, ORDER, Pose, Series, arm, derivative, flat, flying, gap_along, inertia_along, lever,
    rocking, slipping, velocity,
};

/// After so many events the motion is given up.
pub(crate) const MOST_EVENTS: usize = 100_000;

/// The share of a cone of friction by which an impulse on its edge may lie outside.
const EDGE: f64 = 1e-6;

/// The share of a radian, of B, that a step may leave.
const TOLERANCE: f64 = 1e-16;

/// Event that ends a step before its time.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Failure {
    Rest(Option<Zero>),
    Stop,
    Tip(Corner),
    Unload,
    Cone(Slip),
    Singular,
    Meet(Corner),
    Overturned,
}

/// Parts of a motion kept beside the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Keep {
    /// The steps, from which the position at any moment follows.
    pub steps: bool,
}

/// Follows the motion to its end by series of full length alone: a witness of [`simulate`], and the measure of its speed.
///
/// # Errors
/// As [`simulate`].
#[doc(hidden)]
pub fn simulate_at_length(problem: &MotionProblem, keep: Keep) -> Result<MotionOutcome, MotionError> {
    problem.check()?;
    in_general(problem, keep, false)
}

/// Follows the motion to its end.
///
/// # Errors
/// If the problem is none; see [`MotionProblem::check`].
pub fn simulate(problem: &MotionProblem, keep: Keep) -> Result<MotionOutcome, MotionError> {
    problem.check()?;
    match sliding::slides_only(problem) {
        // The numbers are the same whether the steps are kept or not.
        Some(plain) if keep.steps => {
            Ok(MotionOutcome { steps: in_general(problem, keep, true)?.steps, ..plain })
        }
        Some(plain) => Ok(plain),
        None => in_general(problem, keep, true),
    }
}

/// Follows the motion by the machine that knows all states; short series where nothing happens, or of full length throughout.
fn in_general(problem: &MotionProblem, keep: Keep, is_short: bool) -> Result<MotionOutcome, MotionError> {
    let forcing = Forcing::of(problem);
    let mut machine = Machine { is_short, ..Machine::new(problem, &forcing, keep) };
    let end = machine.run()?;
    Ok(machine.outcome(end))
}

struct Machine<'a> {
    block: &'a Block,
    law: Law,
    gravity: f64,
    forcing: &'a Forcing,
    initial: Initial,
    scales: Scales,
    t_max: f64,
    keep: Keep,
    /// True if D can vanish at any pose.
    singular: bool,

    t: f64,
    segment: usize,
    rockers: [glide::Rocker; 2],
    /// True if pieces in which nothing happens are followed by series that are as short as these.
    is_short: bool,
    /// c and h of a corner at an angle, as the last piece has left them.
    known_levers: Option<(Corner, f64, [f64; 2])>,
    mode: Mode,
    pose: Pose,
    /// In flight, the heights of O and O' above the base, apart from the pose, so that a low bounce keeps its digits.
    gaps: [f64; 2],
    /// True if the corner's slip is zero at this moment, up to rounding: a state of slip begins.
    slip_begins: bool,
    /// Condition that is zero at this moment beside it, and the state that failed.
    begins: (Option<Zero>, Option<Mode>),
    channels: Channels,
    motion: Motion,
    /// Room for the series of states that are tried.
    tried: Motion,

    events: Vec<Event>,
    steps: Vec<MotionStep>,
    /// Places of C and of each corner right of it at the beginning, apart, so that a small slide keeps its digits.
    feet: [[f64; 2]; 2],
    max_slide: [f64; 2],
    max_theta: [f64; 2],
    past_balance: bool,
    impacts: usize,
    t_rest_is_bound: bool,
    first: Pose,
    work: f64,
    friction_loss: f64,
    impact_loss: f64,
    unique: bool,
    impulse_left_base: bool,
    reduced_impacts: usize,
    /// Impacts that end in flight, and the largest gap of the lower corner, with its time.
    bounces: usize,
    max_gap: [f64; 2],
    /// Impacts of which only stiffness decides, and the first time of one; and the last landing: its time, and its corner.
    undetermined: (usize, f64),
    landing: Option<(f64, Corner)>,
    stuck_events: usize,
}

impl<'a> Machine<'a> {
    fn new(problem: &'a MotionProblem, forcing: &'a Forcing, keep: Keep) -> Machine<'a> {
        let block = &problem.block;
        let length = block.b1.max(block.b2);
        let radius = length.hypot(block.d);
        let scales =
            Scales { time: (length / problem.gravity).sqrt(), length, acceleration: problem.gravity };
        let least = |b: f64| {
            let square = b * b + block.d * block.d;
            block.rho2 + 0.5 * block.m_y * square * (1.0 - (1.0 + block.mu_k * block.mu_k).sqrt())
        };
        let begin = problem.initial.time;
        Machine {
            block,
            law: Law {
                law: problem.impact,
                ratio: problem.ratio(),
                e: problem.restitution,
                μ: problem.impact_friction(),
            },
            gravity: problem.gravity,
            forcing,
            initial: problem.initial,
            scales,
            t_max: problem
                .t_max
                .unwrap_or(forcing.end().max(begin) + 200.0 * (radius / problem.gravity).sqrt()),
            keep,
            singular: least(block.b1).min(least(block.b2)) <= 0.0,
            t: begin,
            // What jumps at the moment itself has jumped.
            segment: forcing.breaks.partition_point(|t| *t <= begin),
            rockers: Machine::rockers(block, problem.gravity),
            is_short: true,
            known_levers: None,
            mode: Mode::Rest,
            pose: begin::started(block, &problem.initial),
            gaps: [0.0; 2],
            slip_begins: false,
            begins: (None, None),
            channels: Channels::EMPTY,
            motion: Motion::EMPTY,
            tried: Motion::EMPTY,
            events: Vec::new(),
            steps: Vec::new(),
            feet: [[0.0; 2]; 2],
            max_slide: [0.0, begin],
            max_theta: [0.0, begin],
            past_balance: false,
            impacts: 0,
            t_rest_is_bound: false,
            first: Pose::default(),
            work: 0.0,
            friction_loss: 0.0,
            impact_loss: 0.0,
            unique: true,
            impulse_left_base: false,
            reduced_impacts: 0,
            bounces: 0,
            max_gap: [0.0, begin],
            undetermined: (0, begin),
            landing: None,
            stuck_events: 0,
        }
    }

    fn run(&mut self) -> Result<End, MotionError> {
        if let Some(end) = self.begin()? {
            return Ok(end);
        }
        loop {
            if self.events.len() >= MOST_EVENTS {
                return Ok(End::TooManyEvents);
            }
            let stop = self.forcing.stop(self.segment);
            if self.t >= self.t_max {
                self.say(Why::End, Modes::NONE);
                return Ok(End::Time);
            }
            if self.t >= stop {
                let jump = self.forcing.jumps[self.segment];
                self.segment += 1;
                if jump && let Some(end) = self.jumped() {
                    return Ok(end);
                }
                continue;
            }
            let nothing_happens = match (self.is_short, self.mode, self.mode.corner()) {
                (true, Mode::Rest, _) => self.rests(stop),
                (true, _, Some(corner)) => self.glide(corner, stop),
                _ => false,
            };
            if nothing_happens {
                continue;
            }
            if let Some(end) = self.advance(stop) {
                return Ok(end);
            }
        }
    }

    fn outcome(mut self, end: End) -> MotionOutcome {
        if self.mode.slip().is_some() || self.mode == Mode::Flight {
            self.see_slide();
        }
        let slide = self.slide();
        let last = self.events.last().map_or(0.0, |event| event.t);
        let resting = end == End::AtRest;
        let since = self.events.iter().rposition(|event| event.state != Mode::Rest);
        let t_rest =
            resting.then(|| self.events.get(since.map_or(0, |i| i + 1)).map_or(last, |event| event.t));
        MotionOutcome {
            end,
            slide,
            // A corner that sticks is where it was seen before, but for rounding.
            max_slide: self.max_slide[0].max(slide.abs()),
            t_max_slide: self.max_slide[1],
            max_theta: self.max_theta[0],
            t_max_theta: self.max_theta[1],
            theta: self.pose.θ,
            last: self.last(last),
            past_balance: self.past_balance,
            impacts: self.impacts,
            t_rest,
            t_rest_is_bound: self.t_rest_is_bound,
            t_final: last.max(self.forcing.end().min(self.t_max)),
            loads_end: self.forcing.end(),
            work: self.work,
            friction_loss: self.friction_loss,
            impact_loss: self.impact_loss,
            kinetic: kinetic(self.block, &self.pose) - kinetic(self.block, &self.first),
            potential: self.gravity * (self.pose.y - self.first.y),
            unique: self.unique,
            impulse_left_base: self.impulse_left_base,
            reduced_impacts: self.reduced_impacts,
            bounces: self.bounces,
            max_gap: self.max_gap[0],
            t_max_gap: self.max_gap[1],
            undetermined: self.undetermined.0,
            t_undetermined: self.undetermined.1,
            events: self.events,
            steps: self.steps,
            block: *self.block,
            feet: self.feet,
            gravity: self.gravity,
            first_y: self.first.y,
        }
    }

    fn say(&mut self, why: Why, consistent: Modes) {
        self.events.push(Event { t: self.t, why, state: self.mode, consistent });
    }

    fn ended(&mut self, why: Why, end: End) -> End {
        self.say(why, Modes::NONE);
        end
    }

    fn decide(&mut self, contact: Contact) -> Decision {
        self.begins = (contact.zero, contact.failed);
        self.forcing.channels(self.segment, self.t, DECIDING, &mut self.channels);
        let motion = &mut self.tried;
        let (block, scales, pose) = (self.block, self.scales, self.pose);
        Decider { block, scales, channels: &self.channels, pose, contact, motion }.decide()
    }

    /// The closed corners of the present state, and the direction of their slip.
    fn contact(&self) -> ([bool; 2], Option<Slip>) {
        (touching(self.mode), self.mode.slip())
    }

    /// A load jumps: the state is decided afresh.
    fn jumped(&mut self) -> Option<End> {
        if self.mode == Mode::Flight {
            return None;
        }
        let (closed, slip) = self.contact();
        let decision = self.decide(Contact { closed, slip, failed: None, zero: None, jump: true });
        if decision.mode == Some(self.mode) {
            self.unique &= decision.modes.len() <= 1;
            return None;
        }
        self.go_on(Why::Jump, decision, slip, closed)
    }

    /// Goes on with these corners closed and this slip. `jump`: loads may have jumped.
    fn go_on_touching(&mut self, why: Why, closed: [bool; 2], slip: Option<Slip>, jump: bool) -> Option<End> {
        let decision = self.decide(Contact { closed, slip, failed: None, zero: None, jump });
        self.go_on(why, decision, slip, closed)
    }

    /// Takes the state that was decided; grips where there is none.
    fn go_on(&mut self, why: Why, decision: Decision, slip: Option<Slip>, closed: [bool; 2]) -> Option<End> {
        let Decision { mode, modes } = decision;
        if let Some(mode) = mode {
            self.unique &= modes.len() <= 1;
            self.take(mode, slip.is_none());
            self.say(why, modes);
            return None;
        }
        if slip.is_some()
            && let Some((after, corner)) = self.gripped(closed)
        {
            self.impact_loss += kinetic(self.block, &self.pose) - kinetic(self.block, &after);
            self.pose = after;
            let closed = CORNERS.map(|other| other == corner);
            let decision = self.decide(Contact { closed, slip: None, failed: None, zero: None, jump: false });
            if let Some(mode) = decision.mode {
                self.unique &= decision.modes.len() <= 1;
                self.take(mode, true);
                if why == Why::Start || why == Why::Impact {
                    self.say(why, decision.modes);
                }
                self.say(Why::Grip, decision.modes);
                return None;
            }
        }
        Some(self.ended(Why::NoContinuation, End::NoContinuation))
    }

    fn take(&mut self, mode: Mode, slip_begins: bool) {
        self.mode = mode;
        self.slip_begins = slip_begins && mode.slip().is_some();
        if mode == Mode::Flight {
            // Its lower corner has just left the base.
            self.gaps = self.gaps_above(0.0);
        }
        if mode.corner().is_none() && mode != Mode::Flight {
            self.pose = Pose { θ: 0.0, ω: 0.0, y: self.block.d, vy: 0.0, ..self.pose };
            if mode == Mode::Rest || self.slip_begins {
                self.pose.vx = 0.0;
            }
        }
        self.see_slide();
    }

    /// Gaps of a body whose lower corner is so high.
    fn gaps_above(&self, height: f64) -> [f64; 2] {
        let rise = (self.block.b1 + self.block.b2) * self.pose.θ.sin();
        [height + (-rise).max(0.0), height + rise.max(0.0)]
    }

    /// The impulse by which a corner that slips grips: the corner that leaves the other one no way into the base. It is within μ_k, as D ≤ 0
    /// says; where slip ends because D vanishes, on its edge but for rounding.
    fn gripped(&self, closed: [bool; 2]) -> Option<(Pose, Corner)> {
        let both = closed == [true, true];
        CORNERS.into_iter().zip(closed).filter(|(_, closed)| *closed).find_map(|(corner, _)| {
            let after = stuck(self.block, lever(self.block, corner, self.pose.θ), &self.pose);
            let normal = self.block.m_y * (after.vy - self.pose.vy);
            let tangential = self.block.m_x * (after.vx - self.pose.vx);
            let leaves = !both || turning(corner) * after.ω > 0.0;
            let cone = self.block.mu_k * normal * (1.0 + EDGE);
            (leaves && normal > 0.0 && tangential.abs() <= cone).then_some((after, corner))
        })
    }

    /// The impact of corners on the base; books its energy.
    fn meet(&mut self, touching: [bool; 2], landing: bool) -> Option<ImpactState> {
        let before = self.pose;
        let after = self.law.after(self.block, &self.pose, touching, landing);
        let after = after.or_else(|| if landing { self.touched(touching) } else { None })?;
        self.impact_loss += kinetic(self.block, &self.pose) - kinetic(self.block, &after.pose);
        self.pose = after.pose;
        self.unique &= !after.others;
        self.impulse_left_base |= !after.on_base;
        self.reduced_impacts += usize::from(after.reduced);
        self.impacts += 1;
        self.see_rebound(&before, &after, touching, landing);
        Some(after)
    }

    /// After a flight so low that nothing but rounding is left of the velocity at which it ends: no impulse.
    fn touched(&self, touching: [bool; 2]) -> Option<ImpactState> {
        let tiny = 1e-10 * self.scales.length / self.scales.time;
        let up = CORNERS.map(|corner| velocity(self.block, corner, &self.pose)[1]);
        if (0..2).any(|i| touching[i] && up[i].abs() > tiny) {
            return None;
        }
        let mut pose = self.pose;
        let corner = CORNERS[(0..2).find(|i| touching[*i])?];
        if touching == [true, true] {
            (pose.ω, pose.vy) = (0.0, 0.0);
        } else {
            pose.vy = -lever(self.block, corner, pose.θ)[0] * pose.ω;
        }
        let [along, _] = velocity(self.block, corner, &pose);
        Some(ImpactState {
            pose,
            closed: touching,
            slip: direction(along, tiny),
            others: false,
            on_base: true,
            reduced: false,
        })
    }

    /// Displacement along the base of the corner that touches, of O if none or both do.
    fn slide(&self) -> f64 {
        self.slide_of(self.mode.corner().unwrap_or(Corner::O))
    }

    fn slide_of(&self, corner: Corner) -> f64 {
        let [x, c] = self.feet[corner as usize];
        (self.pose.x - x) + (lever(self.block, corner, self.pose.θ)[0] - c)
    }

    fn see_slide(&mut self) {
        let slide = self.slide().abs();
        if slide > self.max_slide[0] {
            self.max_slide = [slide, self.t];
        }
    }
}

/// Direction of a slip, `None` if it is within rounding of zero.
fn direction(along: f64, tiny: f64) -> Option<Slip> {
    match along {
        u if u > tiny => Some(Slip::Right),
        u if u < -tiny => Some(Slip::Left),
        _ => None,
    }
}
