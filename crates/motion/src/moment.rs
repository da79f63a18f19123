//! All that is known of a motion at a moment: derivatives of the polynomials that were kept, never differences of theirs.

use standfast::{Corner, Mode};

use crate::impact::{CORNERS, kinetic};
use crate::outcome::{MotionOutcome, MotionStep};
use crate::problem::{Going, Initial};
use crate::roots::value;
use crate::series::{LEN, ORDER, Pose, Series, arm, derivative, lever};

/// Pose, rates, reactions and energies at a moment, in the units of the problem, forces and energies per mass.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Moment {
    /// The moment.
    pub t: f64,
    /// The state.
    pub state: Mode,
    /// Displacement along the base of the corner that touches, of O if none or both do.
    pub slide: f64,
    /// x of the centre of mass, from where it was at the beginning of the problem.
    pub x: f64,
    /// y of the centre of mass above the base.
    pub y: f64,
    /// θ.
    pub theta: f64,
    /// Velocity of the centre of mass, to the right and upwards.
    pub velocity: [f64; 2],
    /// θ̇.
    pub omega: f64,
    /// Acceleration of the centre of mass relative to the base, to the right and upwards.
    pub acceleration: [f64; 2],
    /// θ̈.
    pub alpha: f64,
    /// Reaction upwards at O and at O'.
    pub normal: [f64; 2],
    /// Reaction to the right at O and at O'; `None` where both touch, which of them takes it is not determined.
    pub tangential: Option<[f64; 2]>,
    /// Reaction to the right of both.
    pub friction: f64,
    /// Displacement along the base of O and of O'.
    pub slides: [f64; 2],
    /// Height of O and O' above the base.
    pub gaps: [f64; 2],
    /// Loads about C: X to the right, P downwards with the weight, M counter-clockwise.
    pub loads: [f64; 3],
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy, from that at the beginning on.
    pub potential: f64,
    /// Work of the loads so far, the weight left out.
    pub work: f64,
    /// Energy that friction has taken so far.
    pub friction_loss: f64,
    /// Energy that impacts have taken so far.
    pub impact_loss: f64,
}

/// ∫₀^τ a b dt.
fn integral(a: &Series, b: &Series, τ: f64) -> f64 {
    let mut product = [0.0; 2 * LEN];
    for (i, a) in a.iter().enumerate().take(ORDER + 1) {
        for (j, b) in b.iter().enumerate().take(ORDER + 1) {
            product[i + j] += a * b;
        }
    }
    product.iter().enumerate().rev().fold(0.0, |sum, (k, a)| sum * τ + a / (k + 1) as f64) * τ
}

impl Moment {
    /// The moment as the beginning of a motion that goes on from there.
    pub fn initial(&self) -> Initial {
        let (touching, slip) = (touching(self.state), self.state.slip());
        let flies = touching == [false, false];
        let [vx, vy] = self.velocity;
        Initial {
            time: self.t,
            x: self.x,
            theta: self.theta,
            omega: self.omega,
            vx: (flies || slip.is_some()).then_some(vx),
            vy: flies.then_some(vy),
            gap: if flies { self.gaps[0].min(self.gaps[1]).max(0.0) } else { 0.0 },
            touching: Some(touching),
            going: Some(slip.map_or(Going::Sticks, Going::Slips)),
            slide: Some(self.slides),
        }
    }
}

/// Whether O and O' touch in a state.
pub fn touching(state: Mode) -> [bool; 2] {
    match state.corner() {
        Some(corner) => CORNERS.map(|other| other == corner),
        None => [state != Mode::Flight; 2],
    }
}

impl MotionOutcome {
    /// Everything at a moment, if the [steps](MotionOutcome::steps) were kept; at a moment at which something changes as it is afterwards, or
    /// before. That at the nearest end outside of the time that was followed.
    pub fn moment(&self, t: f64, before: bool) -> Option<Moment> {
        let (step, τ) = self.step_at(t, before)?;
        Some(self.in_step(step, t, τ))
    }

    fn in_step(&self, step: &MotionStep, t: f64, τ: f64) -> Moment {
        let block = &self.block;
        let [vx, vy] = [derivative(&step.x), derivative(&step.y)];
        let ω = step.ω;
        let at = |powers: &Series| value(powers, τ);
        let (x, y, theta, omega) = (at(&step.x), at(&step.y), at(&step.θ), at(&ω));
        let velocity = [at(&vx), at(&vy)];
        let acceleration = [&vx, &vy].map(|velocity| at(&derivative(velocity)));
        let alpha = at(&derivative(&ω));
        let loads = step.wrench.each_ref().map(at);
        let [force, pressing, moment] = loads;
        // Of a body in flight the base has no part; of one at rest, or that slides, moments about C part the reaction.
        let flies = step.state == Mode::Flight;
        let all = if flies { 0.0 } else { pressing + block.m_y * acceleration[1] };
        let friction = if flies { 0.0 } else { block.m_x * acceleration[0] - force };
        let (normal, tangential) = match step.state.corner() {
            Some(corner) => {
                let at_corner = |one: f64| CORNERS.map(|other| if other == corner { one } else { 0.0 });
                (at_corner(all), Some(at_corner(friction)))
            }
            None if flies => ([0.0; 2], Some([0.0; 2])),
            None => {
                let turns = moment + block.d * friction;
                let width = block.b1 + block.b2;
                ([(block.b2 * all + turns) / width, (block.b1 * all - turns) / width], None)
            }
        };
        let gaps = CORNERS.map(|corner| y - lever(block, corner, theta)[1]);
        let energy = |[vx, vy]: [f64; 2], ω: f64| kinetic(block, &Pose { vx, vy, ω, ..Pose::default() });
        let (kinetic, potential) = (energy(velocity, omega), self.gravity * (y - self.first_y));
        let mut lift = step.wrench[1];
        lift[0] -= self.gravity;
        let added =
            integral(&step.wrench[0], &vx, τ) - integral(&lift, &vy, τ) + integral(&step.wrench[2], &ω, τ);
        // Within a step there are no impacts: what is not left of the work has gone into friction.
        let start = energy([vx[0], vy[0]], ω[0]) + self.gravity * (step.y[0] - self.first_y);
        let slips = step.state.slip().is_some();
        let rubbed = if slips { added - (kinetic + potential - start) } else { 0.0 };
        let [work, friction_loss, impact_loss] = step.spent;
        Moment {
            t,
            state: step.state,
            slide: self.slide_in(step.state, x, theta),
            x,
            y,
            theta,
            velocity,
            omega,
            acceleration,
            alpha,
            normal,
            tangential,
            friction,
            slides: CORNERS.map(|corner| self.slide_of(corner, x, theta)),
            gaps: gaps.map(|gap| if gap.abs() < 1e-12 * arm(block, Corner::OPrime) { 0.0 } else { gap }),
            loads,
            kinetic,
            potential,
            work: work + added,
            friction_loss: friction_loss + rubbed,
            impact_loss,
        }
    }
}
