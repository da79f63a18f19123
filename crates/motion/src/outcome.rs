//! Outcome of a motion.

use standfast::contact::Block;
use standfast::{Corner, Mode, Modes};

use crate::problem::Initial;
use crate::roots::value;
use crate::series::{Series, lever};

/// Reason why a state of motion ended and another began.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Why {
    /// The motion begins.
    Start,
    /// The load, as it grows, moves the body from rest.
    Load,
    /// A load jumps.
    Jump,
    /// Friction at a corner that stuck is exhausted.
    Cone,
    /// Slip ends.
    Stop,
    /// A corner, or the base, is no longer pressed.
    Unload,
    /// The reaction of a base that slides reaches a corner.
    Tip,
    /// A corner meets the base.
    Impact,
    /// Impacts that follow each other ever faster have ended the rotation.
    Settle,
    /// No slip could go on, and the corner grips.
    Grip,
    /// A quarter turn.
    Overturned,
    /// At rest for good.
    Rest,
    /// The time is up.
    End,
    /// No state satisfies all conditions.
    NoContinuation,
}

impl Why {
    /// The word in results.
    pub fn word(self) -> &'static str {
        match self {
            Why::Start => "start",
            Why::Load => "load",
            Why::Jump => "jump",
            Why::Cone => "cone",
            Why::Stop => "stop",
            Why::Unload => "unload",
            Why::Tip => "tip",
            Why::Impact => "impact",
            Why::Settle => "settle",
            Why::Grip => "grip",
            Why::Overturned => "overturned",
            Why::Rest => "rest",
            Why::End => "end",
            Why::NoContinuation => "no-continuation",
        }
    }

    /// The reason in words, as the end of "the state changes because …".
    pub fn words(self) -> &'static str {
        match self {
            Why::Start => "the motion begins",
            Why::Load => "the load moves it",
            Why::Jump => "a load jumps",
            Why::Cone => "friction is exhausted",
            Why::Stop => "slip ends",
            Why::Unload => "a corner is no longer pressed",
            Why::Tip => "the reaction reaches a corner",
            Why::Impact => "a corner meets the base",
            Why::Settle => "impacts ever faster end the rotation",
            Why::Grip => "slip cannot go on: the corner grips",
            Why::Overturned => "a quarter turn",
            Why::Rest => "at rest for good",
            Why::End => "the time is up",
            Why::NoContinuation => "no state satisfies all conditions",
        }
    }
}

/// A moment at which the state changes, or the motion ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Time.
    pub t: f64,
    /// Reason for the change of state.
    pub why: Why,
    /// The state that goes on.
    pub state: Mode,
    /// All states that satisfied every condition; more than one where the answer is not unique.
    pub consistent: Modes,
}

/// End of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// At rest, and nothing later moves it.
    AtRest,
    /// |θ| reached a quarter turn.
    Overturned,
    /// The time was up.
    Time,
    /// No state satisfies all conditions.
    NoContinuation,
    /// After so many events that no end is in sight.
    TooManyEvents,
}

impl End {
    /// The word in results.
    pub fn word(self) -> &'static str {
        match self {
            End::AtRest => "rest",
            End::Overturned => "overturned",
            End::Time => "time",
            End::NoContinuation => "no-continuation",
            End::TooManyEvents => "too-many-events",
        }
    }
}

/// Outcome of a motion, in the units of the problem.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MotionOutcome {
    /// End of the motion.
    pub end: End,
    /// Changes of state, in the order of time.
    pub events: Vec<Event>,
    /// Displacement along the base of the corner that touches at the end, of O if none does.
    pub slide: f64,
    /// The largest |displacement| on the way of the corner that touches, of O where none does.
    pub max_slide: f64,
    /// Time of the largest |displacement|.
    pub t_max_slide: f64,
    /// The largest |θ|.
    pub max_theta: f64,
    /// Time of the largest |θ|.
    pub t_max_theta: f64,
    /// θ at the end.
    pub theta: f64,
    /// Pose and rates of the body at the end.
    pub last: Initial,
    /// True if the centre of mass went beyond the corner it turned about, even if the body came back.
    pub past_balance: bool,
    /// Number of times that a corner met the base; of an infinite sequence those that were followed one by one.
    pub impacts: usize,
    /// Since when it rests for good.
    pub t_rest: Option<f64>,
    /// True if `t_rest` is a lower bound only: slower motion than can be followed was left.
    pub t_rest_is_bound: bool,
    /// The last event, or the end of the loads if that is later.
    pub t_final: f64,
    /// The last change of the loads, whether the motion was followed so far or not.
    pub loads_end: f64,
    /// Work of the loads, the weight left out, per mass.
    pub work: f64,
    /// Energy that friction took.
    pub friction_loss: f64,
    /// Energy that impacts took.
    pub impact_loss: f64,
    /// Kinetic energy at the end less that at the beginning.
    pub kinetic: f64,
    /// g times what the centre of mass rose.
    pub potential: f64,
    /// True if at every event one state only satisfied all conditions, and one impact.
    pub unique: bool,
    /// True if the impulse of a measured `ratio` acted outside the base.
    pub impulse_left_base: bool,
    /// Impacts at which a measured `ratio` would have given energy to a body that slips; there it is the largest that does not.
    pub reduced_impacts: usize,
    /// Number of impacts that end in flight.
    pub bounces: usize,
    /// The largest gap of the lower corner above the base, in flight; a fall that the motion begins with left out.
    pub max_gap: f64,
    /// Time of the largest gap.
    pub t_max_gap: f64,
    /// Number of impacts with a rebound whose outcome hangs on stiffnesses that no rigid law knows: of both corners at once, or one right after the
    /// other.
    pub undetermined: usize,
    /// Time of the first of these.
    pub t_undetermined: f64,
    /// The steps, if they were asked for.
    pub steps: Vec<MotionStep>,
    pub(crate) block: Block,
    pub(crate) feet: [[f64; 2]; 2],
    pub(crate) gravity: f64,
    /// y at the beginning.
    pub(crate) first_y: f64,
}

impl MotionOutcome {
    /// True if the body overturned.
    pub fn overturned(&self) -> bool {
        self.end == End::Overturned
    }

    /// True if the body rests at the end, and nothing later moves it; of one that rests when the time is up nobody knows.
    pub fn at_rest(&self) -> bool {
        self.end == End::AtRest
    }

    /// True if the time was up while loads still went on.
    pub fn is_cut_off(&self) -> bool {
        self.end == End::Time && self.t_final < self.loads_end
    }

    /// Residual of the balance of energy: kinetic + potential + losses − work.
    pub fn energy_residual(&self) -> f64 {
        self.kinetic + self.potential + self.friction_loss + self.impact_loss - self.work
    }

    /// The kept step at a moment and the time since its beginning: at a moment at which something changes that which begins there, or ends.
    pub(crate) fn step_at(&self, t: f64, before: bool) -> Option<(&MotionStep, f64)> {
        // The time of an event and the beginning of a step may differ by rounding, where a plainer way has found the events.
        let slack = 4.0 * f64::EPSILON * t.abs();
        let i =
            self.steps.partition_point(|step| if before { step.t < t - slack } else { step.t <= t + slack });
        let step = self.steps.get(i.saturating_sub(1))?;
        Some((step, (t - step.t).clamp(0.0, step.duration)))
    }

    /// Displacement along the base of the corner that touches in a state, of O if none or both do.
    pub(crate) fn slide_in(&self, state: Mode, x: f64, theta: f64) -> f64 {
        self.slide_of(state.corner().unwrap_or(Corner::O), x, theta)
    }

    pub(crate) fn slide_of(&self, corner: Corner, x: f64, theta: f64) -> f64 {
        let [x0, c0] = self.feet[corner as usize];
        (x - x0) + (lever(&self.block, corner, theta)[0] - c0)
    }

    /// The position at a moment, if the [steps](MotionOutcome::steps) were kept: x and y of the centre of mass and θ; that at the nearest end
    /// outside of the time that was followed.
    pub fn at(&self, t: f64) -> Option<Position> {
        let (step, τ) = self.step_at(t, false)?;
        let at = |powers: &Series| value(powers, τ);
        let (x, theta) = (at(&step.x), at(&step.θ));
        let slide = self.slide_in(step.state, x, theta);
        Some(Position { t, slide, x, y: at(&step.y), theta, omega: at(&step.ω), state: step.state })
    }
}

/// Pose and rates of the body at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// The moment.
    pub t: f64,
    /// Displacement along the base of the corner that touches, of O if none or both do.
    pub slide: f64,
    /// x of the centre of mass, from where it was at the beginning of the problem.
    pub x: f64,
    /// y of the centre of mass above the base.
    pub y: f64,
    /// θ.
    pub theta: f64,
    /// θ̇.
    pub omega: f64,
    /// The state.
    pub state: Mode,
}

/// A stretch of time over which the motion is a power series.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStep {
    /// Beginning of the step.
    pub t: f64,
    /// Duration of the step.
    pub duration: f64,
    /// The state.
    pub state: Mode,
    pub(crate) θ: Series,
    pub(crate) ω: Series,
    pub(crate) x: Series,
    pub(crate) y: Series,
    /// X, P, M.
    pub(crate) wrench: [Series; 3],
    /// Work, what friction and what impacts took, up to its beginning.
    pub(crate) spent: [f64; 3],
}
