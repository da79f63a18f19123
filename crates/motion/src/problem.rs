//! The problem: a block on its base, what acts on it in time, how it meets the base.

use standfast::Slip;
use standfast::contact::Block;
use standfast::history::History;

use crate::error::MotionError;
use crate::impact::CORNERS;
use crate::series::lever;

/// Law of the impact of a corner on the base.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Impact {
    /// No rebound at any closed corner, Coulomb friction on the impulses.
    #[default]
    Inelastic,
    /// The corner that meets the base sticks, whatever the friction.
    Housner,
    /// A measured ratio of the rates of rotation after and before, 0 to 1.
    Ratio(f64),
    /// Resultants of the reaction at this share of half the base on both sides of the middle, which give the ratio; 1 is Housner's.
    Contact(f64),
    /// An uneven base that touches at so many even points in turn, which give the ratio; two are Housner's.
    Points(u32),
    /// Poisson's hypothesis: the restitution's share of each impulse of a compression is given back.
    Poisson,
    /// The square of the restitution is given back of the work of compression, at one corner; where both have impulses, Poisson's hypothesis.
    Energetic,
}

impl Impact {
    /// The word of a case file.
    pub fn word(self) -> &'static str {
        match self {
            Impact::Inelastic => "inelastic",
            Impact::Housner => "housner",
            Impact::Ratio(_) | Impact::Contact(_) | Impact::Points(_) => "ratio",
            Impact::Poisson => "poisson",
            Impact::Energetic => "energetic",
        }
    }
}

/// A force with a history, at a point of the body.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInTime {
    /// Point of application from C, at θ = 0, fixed in the body.
    pub at: [f64; 2],
    /// Its direction; its length is a factor.
    pub direction: [f64; 2],
    /// True if its direction turns with the body.
    pub follows: bool,
    /// Force in units of mass times acceleration.
    pub history: History,
}

/// The ground's acceleration.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BaseMotion {
    /// To the right.
    pub horizontal: Option<History>,
    /// Upwards.
    pub vertical: Option<History>,
}

/// The largest acceleration of a base, in gravities: what shakes more is a slip of units.
const MOST_GRAVITIES: f64 = 1e6;

impl BaseMotion {
    fn check(&self, most: f64) -> Result<(), MotionError> {
        for (name, history) in [("horizontal", &self.horizontal), ("vertical", &self.vertical)] {
            let peak = history.as_ref().map_or(0.0, History::peak);
            if peak.is_nan() || peak > most {
                return Err(MotionError::Acceleration { name, peak, most });
            }
        }
        Ok(())
    }
}

/// Whether the corners that touch at the beginning slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Going {
    /// They stick.
    Sticks,
    /// They slip, or begin to.
    Slips(Slip),
}

/// Pose and rates at the beginning of the motion, or at a moment from which another one goes on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Initial {
    /// The moment, of the loads' time.
    pub time: f64,
    /// x of the centre of mass.
    pub x: f64,
    /// θ, counter-clockwise, rad.
    pub theta: f64,
    /// ω = θ̇.
    pub omega: f64,
    /// ẋ of the centre of mass; `None`: that of a body whose lower corner does not slip (in flight: 0).
    pub vx: Option<f64>,
    /// ẏ of the centre of mass; `None`: that of a body whose lower corner stays on the base (in flight: 0).
    pub vy: Option<f64>,
    /// Of the lower corner above the base.
    pub gap: f64,
    /// Whether O and O' touch, of a motion that goes on: these are on the base and stay there. `None`: the pose and the velocity tell.
    pub touching: Option<[bool; 2]>,
    /// Whether they slip; `None`: the velocity tells.
    pub going: Option<Going>,
    /// Displacement along the base of O and of O' so far; `None`: none so far.
    pub slide: Option<[f64; 2]>,
}

impl Initial {
    /// The same with what follows from the corners that touch left to them, so that it holds for a body a little other.
    pub fn put(self) -> Initial {
        let Some(touching) = self.touching.filter(|touching| *touching != [false, false]) else {
            return self;
        };
        let upright = if touching == [true, true] { 0.0 } else { 1.0 };
        let vx = self.vx.filter(|_| self.going != Some(Going::Sticks));
        Initial { theta: upright * self.theta, omega: upright * self.omega, vx, vy: None, gap: 0.0, ..self }
    }
}

/// The largest share of B, of √(gB), by which a corner that is said to touch may be off the base, or leave it.
const TOUCHES: f64 = 1e-9;

/// A block, what acts on it, and how it begins. Lengths in any unit, masses in that of the body, times and accelerations as they come.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionProblem {
    /// The block, of mass 1.
    pub block: Block,
    /// μ_i, friction at impacts; μ_k if `None`.
    pub mu_impact: Option<f64>,
    /// g, down.
    pub gravity: f64,
    /// Forces beside the weight.
    pub loads: Vec<LoadInTime>,
    /// The ground's acceleration.
    pub base: BaseMotion,
    /// The law of impacts.
    pub impact: Impact,
    /// e, the restitution: of `Poisson` and `Energetic`, and of landings from flight, which are Poisson's under the others.
    pub restitution: f64,
    /// Pose and rates at the beginning.
    pub initial: Initial,
    /// Time to stop at; `None`: 200 √(R/g) after the end of the loads.
    pub t_max: Option<f64>,
}

impl MotionProblem {
    /// A block at rest with its weight alone, in any units that go together; that of a body in SI units is [`MotionProblem::of`].
    pub fn new(block: Block, gravity: f64) -> MotionProblem {
        MotionProblem {
            block,
            mu_impact: None,
            gravity,
            loads: Vec::new(),
            base: BaseMotion::default(),
            impact: Impact::default(),
            restitution: 0.0,
            initial: Initial::default(),
            t_max: None,
        }
    }

    /// μ_i.
    pub fn impact_friction(&self) -> f64 {
        self.mu_impact.unwrap_or(self.block.mu_k)
    }

    /// The time up to which the motion is followed and the end of what moves the body, where that is later; what acts without end has none.
    pub fn cut_short(&self) -> Option<(f64, f64)> {
        let ends = self.histories().map(History::end).filter(|end| end.is_finite());
        let end = ends.fold(0.0, f64::max);
        self.t_max.filter(|t_max| *t_max < end).map(|t_max| (t_max, end))
    }

    /// The histories of the base and of the loads.
    pub fn histories(&self) -> impl Iterator<Item = &History> {
        let base = [&self.base.horizontal, &self.base.vertical].into_iter().flatten();
        base.chain(self.loads.iter().map(|load| &load.history))
    }

    /// Refuses what no problem can have.
    ///
    /// # Errors
    /// See [`MotionError`].
    pub fn check(&self) -> Result<(), MotionError> {
        let block = &self.block;
        standfast::contact::solve(block, &standfast::Wrench { x: 0.0, p: 1.0, m: 0.0 })?;
        let value = |name, value, expected| Err(MotionError::Value { name, value, expected });
        if !(self.gravity > 0.0 && self.gravity < 1e50) {
            return value("gravity", self.gravity, "a number above zero");
        }
        if let Some(μ) = self.mu_impact.filter(|μ| !(0.0..1e50).contains(μ)) {
            return value("mu_impact", μ, "a number not below zero");
        }
        if let Some(t) = self.t_max.filter(|t| !(*t > 0.0 && *t < 1e50)) {
            return value("t_max", t, "a time above zero");
        }
        if !(0.0..=1.0).contains(&self.restitution) {
            return value("e", self.restitution, "a number from 0 to 1");
        }
        if self.restitution > 0.0 && self.impact == Impact::Inelastic {
            return value(
                "e",
                self.restitution,
                "0, or a law with a rebound: poisson, energetic, or that of landings beside housner and ratio",
            );
        }
        match self.impact {
            Impact::Contact(share) if !(share > 0.0 && share <= 1.0) => {
                return value("contact", share, "a number above 0, at most 1");
            }
            Impact::Points(count) if count < 2 => {
                return value("points", f64::from(count), "a whole number, 2 or more");
            }
            Impact::Contact(_) | Impact::Points(_) => {
                let same = |one: f64, other: f64| (one - other).abs() <= 1e-9 * other;
                if !same(block.b1, block.b2) {
                    return value(
                        "b1",
                        block.b1,
                        "as much as b2: a ratio by points or by contact is that of a symmetric body",
                    );
                }
                if !same(block.m_x, block.m_y) {
                    return value(
                        "m_x",
                        block.m_x,
                        "as much as m_y: a ratio by points or by contact is that of a body whose masses are one",
                    );
                }
            }
            _ => {}
        }
        if let Some(ratio) = self.ratio() {
            if !(0.0..=1.0).contains(&ratio) {
                return value("ratio", ratio, "a number from 0 to 1");
            }
            let largest = self.largest_ratio();
            if ratio > largest {
                return Err(MotionError::Ratio { ratio, largest });
            }
        }
        let Initial { time, x, theta, omega, vx, vy, gap, .. } = self.initial;
        if !(0.0..1e50).contains(&time) {
            return value("time", time, "a time not below zero");
        }
        if let Some(t) = self.t_max.filter(|t| *t <= time) {
            return value("t_max", t, "a time after that at which the motion begins");
        }
        if theta.is_nan() || theta.abs() >= std::f64::consts::FRAC_PI_2 {
            return value("theta", theta, "an angle within a quarter turn");
        }
        if !(0.0..1e50).contains(&gap) {
            return value("gap", gap, "a number not below zero");
        }
        let [slide, other] = self.initial.slide.unwrap_or_default();
        let finite = [
            ("x", x),
            ("omega", omega),
            ("vx", vx.unwrap_or(0.0)),
            ("vy", vy.unwrap_or(0.0)),
            ("slide", slide),
            ("slide", other),
        ];
        for (name, number) in finite {
            if !(-1e50..1e50).contains(&number) {
                return value(name, number, "a finite number");
            }
        }
        self.check_touching()?;
        self.base.check(MOST_GRAVITIES * self.gravity)?;
        for load in &self.loads {
            for (name, numbers) in [("at", load.at), ("direction", load.direction)] {
                if let Some(number) = numbers.into_iter().find(|number| !(-1e50..1e50).contains(number)) {
                    return value(name, number, "a finite number");
                }
            }
        }
        Ok(())
    }

    /// Refuses a pose, or rates, in which the corners that are said to touch do not.
    fn check_touching(&self) -> Result<(), MotionError> {
        let (block, initial) = (&self.block, &self.initial);
        let Some(touching) = initial.touching else {
            let slips = matches!(initial.going, Some(Going::Slips(_)));
            return if slips { Err(MotionError::SlipOfNone) } else { Ok(()) };
        };
        if touching == [false, false] && matches!(initial.going, Some(Going::Slips(_))) {
            return Err(MotionError::SlipOfNone);
        }
        let value = |name, value, expected| Err(MotionError::Value { name, value, expected });
        let length = TOUCHES * block.b1.max(block.b2);
        let speed = TOUCHES * (self.gravity * block.b1.max(block.b2)).sqrt();
        let levers = CORNERS.map(|corner| lever(block, corner, initial.theta));
        let y = levers[0][1].max(levers[1][1]) + initial.gap;
        for (corner, [c, h]) in
            CORNERS.into_iter().zip(levers).filter(|(corner, _)| touching[*corner as usize])
        {
            if (y - h).abs() > length {
                return Err(MotionError::Apart { corner, gap: y - h });
            }
            if let Some(vy) = initial.vy.filter(|vy| (vy + c * initial.omega).abs() > speed) {
                return value("vy", vy, "that of a corner that touches and stays; left out it is that");
            }
            let sticks = initial.going == Some(Going::Sticks);
            if let Some(vx) = initial.vx.filter(|vx| sticks && (vx + h * initial.omega).abs() > speed) {
                return value(
                    "vx",
                    vx,
                    "that of a corner that touches and does not slip; left out it is that",
                );
            }
        }
        if touching == [true, true] && initial.omega.abs() * block.b1.max(block.b2) > speed {
            return value("omega", initial.omega, "0 where both corners touch");
        }
        Ok(())
    }

    /// Ratio of the rates of rotation after and before an impact on the other corner, of a law that has one.
    pub fn ratio(&self) -> Option<f64> {
        let Block { b2: b, d, rho2, m_x, .. } = self.block;
        let inertia = rho2 / m_x + d * d;
        match self.impact {
            Impact::Ratio(ratio) => Some(ratio),
            Impact::Contact(share) => {
                let square = (share * b).powi(2);
                Some((inertia - square) / (inertia + square))
            }
            Impact::Points(count) => {
                let at = |place: u32| b * (2.0 * f64::from(place) / f64::from(count - 1) - 1.0);
                let factors = (1..count).map(|place| {
                    let (here, before) = (at(place), at(place - 1));
                    (inertia + before * here) / (inertia + here * here)
                });
                Some(factors.product())
            }
            Impact::Inelastic | Impact::Housner | Impact::Poisson | Impact::Energetic => None,
        }
    }

    /// √(I_old/I_new), with I about the corners at θ = 0, for the direction in which it is less.
    pub fn largest_ratio(&self) -> f64 {
        let Block { b1, b2, d, rho2, m_x, m_y, .. } = self.block;
        let [one, two] = [b1, b2].map(|b| rho2 + m_y * b * b + m_x * d * d);
        (one.min(two) / one.max(two)).sqrt()
    }
}

/// Loads on the body while it stands upright, at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActingLoad {
    /// The moment; twice where something jumps.
    pub t: f64,
    /// To the right, in units of mass times acceleration: the forces, and the base's acceleration reversed.
    pub x: f64,
    /// Upwards, the weight left out.
    pub up: f64,
}

impl MotionProblem {
    /// Loads from 0 to `end`: at every moment at which something changes its law, before and after it, and at `count`
    /// even steps.
    pub fn acting(&self, end: f64, count: usize) -> Vec<ActingLoad> {
        let base = [&self.base.horizontal, &self.base.vertical];
        let histories = self.loads.iter().map(|load| &load.history).chain(base.into_iter().flatten());
        let breaks = histories.flat_map(|history| history.times().iter().copied());
        let even = (0..=count).map(|i| end * i as f64 / count.max(1) as f64);
        let mut moments: Vec<f64> = breaks.filter(|t| (0.0..=end).contains(t)).chain(even).collect();
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        let at = |t: f64, value: fn(&History, f64) -> f64| {
            let of = |history: &Option<History>| history.as_ref().map_or(0.0, |history| value(history, t));
            let mut acting = ActingLoad { t, x: -of(&self.base.horizontal), up: -of(&self.base.vertical) };
            for load in &self.loads {
                let f = value(&load.history, t);
                acting.x += f * load.direction[0];
                acting.up += f * load.direction[1];
            }
            acting
        };
        let mut all = Vec::with_capacity(2 * moments.len());
        for t in moments {
            let (before, after) = (at(t, History::before), at(t, History::at));
            if t > 0.0 && before != after {
                all.push(before);
            }
            all.push(after);
        }
        all
    }
}
