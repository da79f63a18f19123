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

use crate::body::Body;
use crate::contact::path::{Stage, stages};
use crate::contact::plane;
use crate::contact::{self, Answer, Block, Wrench};
use crate::diagram::Region;
use crate::error::InputError;
use crate::initiation::Point;
use crate::load::Reduced;
use crate::mode::{Corner, Mode, Modes};
use crate::motion::Motion;
use crate::stability::Actions;

/// How a load counts among the classical [`Actions`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadKind {
    /// Vertical: weight, buoyancy, vertical acceleration.
    Weight,
    /// Pressure under the base that is not buoyancy.
    Uplift,
    /// Horizontal: waves, water on the sides, forces, horizontal acceleration.
    Horizontal,
}

/// A load on the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// How it counts.
    pub kind: LoadKind,
    /// Whether it is there all the time, or grows with the load factor.
    pub permanent: bool,
    /// Its wrench at the centre of mass, N and N·m per metre run.
    pub wrench: Wrench,
}

/// A body, its friction and its loads; SI units, per metre run.
#[derive(Debug, Clone, PartialEq)]
pub struct Situation {
    /// The body.
    pub body: Body,
    /// g, m/s².
    pub gravity: f64,
    /// μ to stick.
    pub static_friction: f64,
    /// μ to slip; no more than to stick.
    pub kinetic_friction: f64,
    /// Mass of water that a horizontal motion carries along, kg per metre run.
    pub added_mass: f64,
    /// All loads, the weight included.
    pub loads: Vec<Load>,
}

/// What happens under one load factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The total wrench at the centre of mass, N and N·m per metre run.
    pub wrench: Wrench,
    /// The mode reported.
    pub mode: Option<Mode>,
    /// All consistent modes.
    pub modes: Modes,
    /// The wrench as a point of the report's plane, where it has one.
    pub effective: Option<Reduced>,
    /// Accelerations and reactions of the mode reported: m/s², rad/s², N per metre run, m.
    pub motion: Option<Motion>,
}

impl State {
    /// Whether one mode only is consistent.
    pub fn is_unique(&self) -> bool {
        self.modes.len() <= 1
    }

    /// The consistent modes beside the one reported.
    pub fn others(&self) -> Modes {
        let mut others = self.modes;
        if let Some(mode) = self.mode {
            others.remove(mode);
        }
        others
    }

    /// Whether nothing presses the body on its base any more: P ≤ 0.
    pub fn is_lifted(&self) -> bool {
        self.wrench.p <= 0.0
    }
}

impl Situation {
    /// A body without loads, not even its weight, with one coefficient of friction.
    pub fn new(body: Body, friction: f64, gravity: f64) -> Situation {
        Situation {
            body,
            gravity,
            static_friction: friction,
            kinetic_friction: friction,
            added_mass: 0.0,
            loads: Vec::new(),
        }
    }

    /// Adds a load that is there all the time.
    pub fn permanent(mut self, kind: LoadKind, wrench: Wrench) -> Situation {
        self.loads.push(Load { kind, permanent: true, wrench });
        self
    }

    /// Adds a load that grows with the load factor.
    pub fn variable(mut self, kind: LoadKind, wrench: Wrench) -> Situation {
        self.loads.push(Load { kind, permanent: false, wrench });
        self
    }

    fn total(&self, share: impl Fn(&Load) -> f64) -> Wrench {
        self.loads.iter().fold(Wrench::ZERO, |sum, load| sum + load.wrench * share(load))
    }

    /// The wrenches of the permanent and of the variable loads.
    pub fn wrenches(&self) -> [Wrench; 2] {
        [true, false].map(|permanent| self.total(|load| if load.permanent == permanent { 1.0 } else { 0.0 }))
    }

    /// The total wrench under a load factor.
    pub fn wrench(&self, factor: f64) -> Wrench {
        let [permanent, variable] = self.wrenches();
        permanent + variable * factor
    }

    /// The classical actions under a load factor, and so [`Actions::stability`].
    pub fn actions(&self, factor: f64) -> Actions {
        let [vertical, uplift, sideways] = self.by_kind(factor);
        self.body.actions(&vertical, &uplift, &sideways)
    }

    /// The [heel](Body::heel) of the classical actions under a load factor.
    pub fn heel(&self, factor: f64) -> Corner {
        let [vertical, uplift, sideways] = self.by_kind(factor);
        self.body.heel(&vertical, &uplift, &sideways)
    }

    /// Vertical, uplift and horizontal loads under a load factor.
    fn by_kind(&self, factor: f64) -> [Wrench; 3] {
        let of = |kind| {
            let share = |load: &Load| if load.permanent { 1.0 } else { factor };
            self.total(|load| if load.kind == kind { share(load) } else { 0.0 })
        };
        let (weight, uplift, horizontal) =
            (of(LoadKind::Weight), of(LoadKind::Uplift), of(LoadKind::Horizontal));
        // A load of one kind may have a part of the other, as an earthquake has; that part acts at C.
        let vertical = Wrench { p: weight.p + horizontal.p, x: 0.0, ..weight };
        let sideways = Wrench { x: horizontal.x + weight.x + uplift.x, p: 0.0, ..horizontal };
        [vertical, uplift, sideways]
    }

    /// The block of the [contact problem](crate::contact), with lengths in B and masses in m.
    pub fn block(&self) -> Block {
        let half_width = self.body.width() / 2.0;
        Block {
            b1: self.body.heel_distance() / half_width,
            b2: self.body.toe_distance() / half_width,
            d: self.body.centroid_height() / half_width,
            rho2: self.body.moment_of_inertia() / (self.body.mass() * half_width * half_width),
            m_x: 1.0 + self.added_mass / self.body.mass(),
            m_y: 1.0,
            mu_s: self.static_friction,
            mu_k: self.kinetic_friction,
        }
    }

    /// A wrench with forces in m g and lengths in B.
    pub fn reduced_wrench(&self, wrench: &Wrench) -> Wrench {
        let weight = self.body.mass() * self.gravity;
        let half_width = self.body.width() / 2.0;
        Wrench { x: wrench.x / weight, p: wrench.p / weight, m: wrench.m / (weight * half_width) }
    }

    /// The point of the report's plane for a wrench: (k_eff, k'_eff) of a uniform body that presses on its base (P > 0)
    /// and that a horizontal force acts on (X ≠ 0). `None` also where X is so small beside M or P that its elevation is
    /// out of all range.
    pub fn effective(&self, wrench: &Wrench) -> Option<Reduced> {
        let ordinary =
            self.body.is_uniform() && self.added_mass == 0.0 && self.static_friction == self.kinetic_friction;
        if !ordinary || wrench.p <= 0.0 || wrench.x == 0.0 {
            return None;
        }
        let k = wrench.x.abs() / wrench.p;
        let k_prime = -wrench.m / (wrench.x * (self.body.height() / 2.0));
        let point = Point::new(self.body.slenderness(), k_prime, k, self.static_friction).ok()?;
        Some(Reduced { point, mirrored: wrench.x > 0.0 })
    }

    /// What begins if the variable load, times `factor`, is applied at once.
    ///
    /// # Errors
    /// If a number is not finite, or friction is negative or smaller to stick than to slip.
    pub fn at(&self, factor: f64) -> Result<State, InputError> {
        InputError::positive("gravity", self.gravity)?;
        let wrench = self.wrench(InputError::finite("load factor", factor)?);
        let effective = self.effective(&wrench);
        let weight = self.body.mass() * self.gravity;
        let half_width = self.body.width() / 2.0;
        Ok(match effective {
            // The report's closed form, scaled by P.
            Some(reduced) => {
                let mut modes = reduced.others();
                modes.insert(reduced.mode());
                let acceleration = self.gravity * (wrench.p / weight);
                let motion = reduced.motion().scaled(acceleration, half_width, wrench.p);
                State { wrench, mode: Some(reduced.mode()), modes, effective, motion: Some(motion) }
            }
            None => {
                let answer: Answer = contact::solve(&self.block(), &self.reduced_wrench(&wrench))?;
                let motion = answer.mode().and_then(|mode| answer.motion(mode));
                let motion = motion.map(|motion| motion.scaled(self.gravity, half_width, weight));
                State { wrench, mode: answer.mode(), modes: answer.modes, effective, motion }
            }
        })
    }

    /// The stages of a variable load that rises from nothing to `up_to` times its value.
    ///
    /// # Errors
    /// As [`at`](Situation::at).
    pub fn path(&self, up_to: f64) -> Result<Vec<Stage>, InputError> {
        InputError::positive("gravity", self.gravity)?;
        let [permanent, variable] = self.wrenches().map(|wrench| self.reduced_wrench(&wrench));
        stages(&self.block(), &permanent, &variable, up_to)
    }

    /// The regions of the plane of load factor and static friction, up to a load factor; see [`plane`].
    ///
    /// # Errors
    /// As [`at`](Situation::at).
    pub fn plane(&self, up_to: f64) -> Result<Vec<Region>, InputError> {
        InputError::positive("gravity", self.gravity)?;
        let [permanent, variable] = self.wrenches().map(|wrench| self.reduced_wrench(&wrench));
        plane::regions(&self.block(), &permanent, &variable, up_to)
    }
}

/// The first stage of a path that is not rest: where the body leaves it, and into which mode.
pub fn first_departure(path: &[Stage]) -> Option<&Stage> {
    path.iter().find(|stage| stage.mode != Some(Mode::Rest))
}
