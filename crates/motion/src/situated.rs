//! The problem in time of a [`Situation`]: in SI units, lengths in metres, everything per mass of the body.
//!
//! Each load acts where it stands on the body: weight, forces and inertia keep their direction while the body turns, a pressure turns
//! with its wall ([`Action::forces`](standfast::loads::Action::forces)). A permanent load is there all the time; a variable one goes
//! with its history. Water that moves with the body presses on a shaken wall as if its mass were shaken, too.
//!
//! ```
//! use standfast::loads::{Action, Load, LoadKind, LoadSource};
//! use standfast::{Body, History, Situation};
//! use standfast_motion::{BaseMotion, Impact, Keep, MotionProblem, simulate};
//!
//! // 2 m by 3 m, 5 t/m³, friction 0.3, under 25 kN/m at 1.2 m that rises and is gone within a second.
//! let pulse = History::triangle(1.0, 0.5, 1.0)?;
//! let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-25e3, 1.2)).over_time(pulse);
//! let situation = Situation::new(Body::new(2.0, 3.0, 5e3)?, 0.3, 9.81)?.with_weight().with(push);
//! let problem = MotionProblem::of(&situation, BaseMotion::default(), Impact::Inelastic)?;
//! let outcome = simulate(&problem, Keep::default())?;
//! assert!(outcome.at_rest() && (outcome.slide + 0.1691).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use standfast::contact::Block;
use standfast::loads::{Action, Earthquake, Load, LoadSource, Pose};
use standfast::{History, Situation, Wrench};

use crate::error::MotionError;
use crate::problem::{BaseMotion, Impact, LoadInTime, MotionProblem};

impl MotionProblem {
    /// The problem of a situation whose base moves as `base` says (m/s²).
    ///
    /// # Errors
    /// If a variable load that amounts to anything has no history, the base moves to the sides beside water whose height is not
    /// known, or the problem is none.
    pub fn of(situation: &Situation, base: BaseMotion, impact: Impact) -> Result<MotionProblem, MotionError> {
        let mut problem = MotionProblem { impact, ..MotionProblem::standing(situation)? };
        let body = situation.body();
        for load in situation.loads().iter().filter(|load| !is_own_weight(load)) {
            if load.wrench(body, situation.gravity(), Pose::UPRIGHT) == Wrench::ZERO {
                continue;
            }
            let history = match (&load.history, load.permanent) {
                (_, true) => History::constant(1.0)?,
                (Some(history), false) => history.clone(),
                (None, false) => return Err(MotionError::NoHistory { load: load.id }),
            };
            problem.add(situation, load, &history);
        }
        if let Some(shaken) = &base.horizontal {
            problem.loads.extend(shaken_water(situation, shaken)?);
        }
        problem.base = base;
        problem.check()?;
        Ok(problem)
    }

    /// The body of a situation under its weight, where that is among the loads, and under nothing else.
    ///
    /// # Errors
    /// If the numbers of the body are out of range.
    pub fn standing(situation: &Situation) -> Result<MotionProblem, MotionError> {
        let gravity = situation.gravity();
        let mut problem = MotionProblem::new(block(situation), gravity);
        if !situation.loads().iter().any(is_own_weight) {
            // The weight comes as a load of its own: take off the one that the problem has.
            let history = History::constant(1.0)?;
            problem.loads.push(LoadInTime {
                at: [0.0, 0.0],
                direction: [0.0, gravity],
                follows: false,
                history,
            });
        }
        Ok(problem)
    }

    /// Adds a load of the situation with a history: its forces per mass of the body.
    pub fn add(&mut self, situation: &Situation, load: &Load, history: &History) {
        let mass = situation.body().mass();
        for force in load.forces(situation.body(), situation.gravity()) {
            let direction = force.size.map(|size| size / mass);
            self.loads.push(LoadInTime {
                at: force.at,
                direction,
                follows: force.follows,
                history: history.clone(),
            });
        }
    }
}

/// True if a load is the weight that a problem has of itself.
pub fn is_own_weight(load: &Load) -> bool {
    load.action == Action::Weight && load.factor == 1.0
}

/// The push of the water that moves with the body, on a base with the acceleration `shaken` to the right.
///
/// # Errors
/// If its height is not known.
pub fn shaken_water(situation: &Situation, shaken: &History) -> Result<Vec<LoadInTime>, MotionError> {
    let water = situation.moved_water();
    if water.mass() > 0.0 && water.height().is_none() {
        return Err(MotionError::WaterWithoutHeight { mass: water.mass() });
    }
    let mut pushed = MotionProblem::new(block(situation), situation.gravity());
    for load in Earthquake::new(1.0, 0.0)?.loads(water) {
        if load.source == LoadSource::ShakenWater {
            pushed.add(situation, &load, shaken);
        }
    }
    Ok(pushed.loads)
}

/// The block of a body, in metres and per its mass.
fn block(situation: &Situation) -> Block {
    let body = situation.body();
    Block {
        b1: body.heel_distance(),
        b2: body.toe_distance(),
        d: body.centroid_height(),
        rho2: body.moment_of_inertia() / body.mass(),
        m_x: 1.0 + situation.added_mass() / body.mass(),
        m_y: 1.0,
        mu_s: situation.static_friction(),
        mu_k: situation.kinetic_friction(),
    }
}
