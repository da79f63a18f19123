//! Adhesion under a body, and forces with a limit that hold it, in the units of the [contact problem](super).
//!
//! ```text
//! rest       some r with 0 ≤ r ≤ R:   |X| ≤ μ_s P + c_a A',  the reaction on the base
//! A'         min(B, 3t) of what is pressed, or 2t of the effective width; t from the resultant to the nearer corner
//! motion     r = R where the motion drives the point of the force against it, 0 where it does not
//! ```
//!
//! The forces are rigid and then give way: where the point stays where it is although the body moves, r is what keeps it there; of a force
//! down on a body that slides, the least that keeps it on its base. Adhesion
//! counts for sticking alone: what slips has lost it, and a corner has no area. For each mode and each state of the forces (none, all,
//! between) the wrench is linear in the loads, so the boundaries along loads that rise are those of the plain problem under such
//! wrenches, the zeros of the points' accelerations, and for adhesion the roots of quadratics, (|X| − μP)P = 3c_a T.

use super::conditions::Rotation;
use super::polytope::{Constraint, boxed, choices, least, meeting};
use super::{Block, motion, numbers, path, rotation, solve, with_friction};
use crate::departure::Departure;
use crate::error::{InputError, LARGEST};
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::motion::Motion;
use crate::neighbour::Neighbour;
use crate::polynomial::quadratic_roots;
use crate::span::Span;
use crate::stage::Stage;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// The most forces that hold one body.
pub const MOST: usize = 4;

/// Adhesion between a body and its base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adhesion {
    /// c_a, force per length of the base.
    pub strength: f64,
    /// The length that counts.
    pub on: AdhesionArea,
}

/// Part of a base that adheres.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AdhesionArea {
    /// What is pressed, min(B, 3t).
    Pressed,
    /// The effective width, 2t.
    Effective,
}

impl AdhesionArea {
    /// The length that counts over the distance of the resultant from the nearer corner.
    fn reach(self) -> f64 {
        match self {
            AdhesionArea::Pressed => 3.0,
            AdhesionArea::Effective => 2.0,
        }
    }
}

/// A force with a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hold {
    /// Its point, right of and above the centre of mass.
    pub at: [f64; 2],
    /// Its direction on the body, to the right and upwards.
    pub direction: [f64; 2],
    /// R.
    pub limit: f64,
}

impl Hold {
    /// Its wrench for a force of one.
    pub fn unit(&self) -> Wrench {
        let ([x, y], [right, up]) = (self.at, self.direction);
        Wrench { x: right, p: 0.0 - up, m: x * up - y * right }
    }

    /// The acceleration of its point along it.
    fn along(&self, motion: &Motion) -> f64 {
        let ([x, y], [right, up]) = (self.at, self.direction);
        let α = motion.theta_ddot;
        right * (motion.x_ddot - y * α) + up * (motion.y_ddot + x * α)
    }
}

/// What holds a body beside friction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Holding {
    /// Adhesion.
    pub adhesion: Option<Adhesion>,
    holds: [Option<Hold>; MOST],
}

/// The consistent modes of a body that is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldSolution {
    /// Every consistent mode.
    pub modes: Modes,
    /// The mode reported.
    pub mode: Option<Mode>,
    /// Its motion.
    pub motion: Option<Motion>,
    /// The forces at rest, the least that will do; `None` where none hold it.
    pub needed: Option<[f64; MOST]>,
    /// The forces in the mode reported.
    pub used: [f64; MOST],
}

/// A force in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Its point gives way.
    Slack,
    /// Its point is driven against it.
    Full,
    /// Its point stays.
    Between,
}

impl Holding {
    /// Adhesion alone, or nothing.
    pub fn new(adhesion: Option<Adhesion>) -> Holding {
        Holding { adhesion, holds: [None; MOST] }
    }

    /// With one more force; as it is where it has as many as it may.
    pub fn with(mut self, hold: Hold) -> Holding {
        if let Some(free) = self.holds.iter_mut().find(|hold| hold.is_none()) {
            *free = Some(hold);
        }
        self
    }

    /// The forces.
    pub fn holds(&self) -> impl Iterator<Item = &Hold> {
        self.holds.iter().flatten()
    }

    /// True if nothing holds.
    pub fn is_empty(&self) -> bool {
        self.adhesion.is_none() && self.count() == 0
    }

    fn count(&self) -> usize {
        self.holds().count()
    }

    /// The wrench with forces.
    pub fn held(&self, wrench: &Wrench, forces: &[f64; MOST]) -> Wrench {
        let held = self.holds().zip(forces).map(|(hold, force)| hold.unit() * *force);
        held.fold(*wrench, |sum, held| sum + held)
    }

    /// A' under a wrench: the length of the base that adheres.
    pub fn adhering(&self, block: &Block, wrench: &Wrench) -> f64 {
        let Some(adhesion) = self.adhesion else { return 0.0 };
        let [at_o, at_o_prime] = moments(block, wrench);
        if wrench.p <= 0.0 {
            return 0.0;
        }
        (adhesion.on.reach() * at_o.min(at_o_prime) / wrench.p).clamp(0.0, block.b1 + block.b2)
    }

    /// True if a body rests under a wrench, whatever holds it included in that.
    fn rests_under(&self, block: &Block, wrench: &Wrench) -> Result<bool, InputError> {
        if solve(block, wrench)?.modes.contains(Mode::Rest) {
            return Ok(true);
        }
        let Some(adhesion) = self.adhesion else { return Ok(false) };
        let on_base = moments(block, wrench).iter().all(|moment| *moment >= 0.0) && wrench.p > 0.0;
        let stick = block.mu_s * wrench.p + adhesion.strength * self.adhering(block, wrench);
        Ok(on_base && wrench.x.abs() <= stick)
    }

    /// The least forces under which a body rests; `None` where none hold it. With several, the least sum of their shares.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn needed(&self, block: &Block, wrench: &Wrench) -> Result<Option<[f64; MOST]>, InputError> {
        let none = [0.0; MOST];
        if self.rests_under(block, wrench)? {
            return Ok(Some(none));
        }
        match self.count() {
            0 => Ok(None),
            1 => self.needed_of_one(block, wrench),
            _ => Ok(self.needed_of_several(block, wrench)),
        }
    }

    fn needed_of_one(&self, block: &Block, wrench: &Wrench) -> Result<Option<[f64; MOST]>, InputError> {
        let Some(hold) = self.holds().next().copied() else { return Ok(None) };
        let mut places = self.stick_ends(block, wrench, &hold.unit());
        places.extend([0.0, hold.limit]);
        places.retain(|force| (0.0..=hold.limit).contains(force));
        places.sort_by(f64::total_cmp);
        let rests = |force: f64| self.rests_under(block, &(*wrench + hold.unit() * force));
        for (place, force) in places.iter().enumerate() {
            let beyond = places.get(place + 1).map(|next| force + (next - force) / 2.0);
            if rests(*force)? || beyond.map_or(Ok(false), rests)? {
                return Ok(Some([*force, 0.0, 0.0, 0.0]));
            }
        }
        Ok(None)
    }

    /// Where a condition of rest may change its sign along `start` + s `slope`.
    fn stick_ends(&self, block: &Block, start: &Wrench, slope: &Wrench) -> Vec<f64> {
        let [o, o_slope] = [start, slope].map(|wrench| moments(block, wrench));
        let line = |at: f64, slope: f64| -at / slope;
        let mut ends = vec![line(o[0], o_slope[0]), line(o[1], o_slope[1]), line(start.p, slope.p)];
        let b = block.b1 + block.b2;
        for σ in [1.0, -1.0] {
            let pulled = |wrench: &Wrench| σ * wrench.x - block.mu_s * wrench.p;
            let [at, by] = [pulled(start), pulled(slope)];
            ends.push(line(at, by));
            let Some(Adhesion { strength, on }) = self.adhesion else { continue };
            ends.push(line(at - strength * b, by));
            for corner in 0..2 {
                let by_reach = strength * on.reach();
                let constant = at * start.p - by_reach * o[corner];
                let linear = at * slope.p + by * start.p - by_reach * o_slope[corner];
                ends.extend(quadratic_roots([constant, linear, by * slope.p]));
                ends.push(line(
                    on.reach() * o[corner] - b * start.p,
                    on.reach() * o_slope[corner] - b * slope.p,
                ));
            }
        }
        ends.retain(|end| end.is_finite());
        ends
    }

    /// The corner of the conditions' polytope that is least by the sum of the forces' shares of their limits.
    fn needed_of_several(&self, block: &Block, wrench: &Wrench) -> Option<[f64; MOST]> {
        let limits: Vec<f64> = self.holds().map(|hold| hold.limit).collect();
        let units: Vec<Wrench> = self.holds().map(Hold::unit).collect();
        let forces = least(resting(block, wrench, &units), &limits)?;
        let mut all = [0.0; MOST];
        all.iter_mut().zip(forces).for_each(|(to, force)| *to = force.max(0.0));
        Some(all)
    }

    /// Every mode under a wrench.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn solve(&self, block: &Block, wrench: &Wrench) -> Result<HeldSolution, InputError> {
        super::check(block, wrench)?;
        let needed = self.needed(block, wrench)?;
        let mut found: Vec<(Mode, [f64; MOST])> = needed.iter().map(|forces| (Mode::Rest, *forces)).collect();
        for states in self.states() {
            let is_new =
                |found: &[(Mode, [f64; MOST])], mode: Mode| found.iter().all(|(known, _)| *known != mode);
            if !states.contains(&State::Between) {
                // What is consistent under forces that are given, of which the motion has to agree with them.
                let forces = self.full(&states);
                let plain = solve(block, &self.held(wrench, &forces))?;
                for mode in plain.modes.iter().filter(|mode| *mode != Mode::Rest) {
                    let agrees = plain.motion(mode).is_some_and(|motion| self.moves_so(&states, &motion));
                    if agrees && is_new(&found, mode) {
                        found.push((mode, forces));
                    }
                }
                continue;
            }
            for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Rest) {
                if !is_new(&found, mode) {
                    continue;
                }
                let kept = match self.kept_on_base(block, mode, &states, wrench) {
                    Some(forces) => Some(forces),
                    None => self.kept_in_place(block, mode, &states, wrench)?,
                };
                found.extend(kept.map(|forces| (mode, forces)));
            }
        }
        let modes: Modes = found.iter().map(|(mode, _)| *mode).collect();
        let reported = found.into_iter().min_by_key(|(mode, _)| rank(block, *mode));
        let (mode, used) = reported.map_or((None, [0.0; MOST]), |(mode, forces)| (Some(mode), forces));
        let motion = mode.map(|mode| raw(block, mode, &self.held(wrench, &used)));
        Ok(HeldSolution { modes, mode, motion, needed, used })
    }

    /// All states that the forces may be in.
    fn states(&self) -> impl Iterator<Item = [State; MOST]> {
        let count = self.count();
        let each = [State::Slack, State::Full, State::Between];
        (0..3_usize.pow(count as u32)).map(move |mut number| {
            let mut states = [State::Slack; MOST];
            for state in states.iter_mut().take(count) {
                *state = each[number % 3];
                number /= 3;
            }
            states
        })
    }

    /// The least upright forces that keep a body on its base that slides, and would turn without them; those along the base are in their states.
    /// `None` of another mode, where none are needed, and where none will do.
    fn kept_on_base(
        &self,
        block: &Block,
        mode: Mode,
        states: &[State; MOST],
        wrench: &Wrench,
    ) -> Option<[f64; MOST]> {
        let slip = mode.slip().filter(|_| mode.corner().is_none())?;
        let mut full = [0.0; MOST];
        let mut upright: Vec<(usize, &Hold)> = Vec::new();
        for (place, hold) in self.holds().enumerate() {
            match (hold.direction[0] == 0.0, states[place]) {
                (true, State::Between) => upright.push((place, hold)),
                (false, State::Slack) => {}
                (false, State::Full) => full[place] = hold.limit,
                _ => return None,
            }
        }
        let held = self.held(wrench, &full);
        let units: Vec<Wrench> = upright.iter().map(|(_, hold)| hold.unit()).collect();
        let limits: Vec<f64> = upright.iter().map(|(_, hold)| hold.limit).collect();
        let forces = least(sliding(block, slip, &held, &units), &limits).filter(|_| !upright.is_empty())?;
        for ((place, _), force) in upright.iter().zip(forces) {
            full[*place] = force.max(0.0);
        }
        let acceleration = raw(block, mode, &self.held(wrench, &full)).x_ddot;
        let agrees =
            self.holds().enumerate().filter(|(_, hold)| hold.direction[0] != 0.0).all(|(place, hold)| {
                let along = hold.direction[0] * acceleration;
                if states[place] == State::Full { along < 0.0 } else { along >= 0.0 }
            });
        agrees.then_some(full)
    }

    /// The forces that are known by their states: those that act in full.
    fn full(&self, states: &[State; MOST]) -> [f64; MOST] {
        let mut forces = [0.0; MOST];
        for (place, hold) in self.holds().enumerate().filter(|(place, _)| states[*place] == State::Full) {
            forces[place] = hold.limit;
        }
        forces
    }

    /// True if a motion puts the forces in their states, but for those whose point stays.
    fn moves_so(&self, states: &[State; MOST], motion: &Motion) -> bool {
        let size = motion.x_ddot.abs() + motion.y_ddot.abs() + motion.theta_ddot.abs();
        self.holds().zip(states).all(|(hold, state)| {
            let along = hold.along(motion);
            let nothing = 1e-12 * size * (1.0 + hold.at[0].abs() + hold.at[1].abs());
            match state {
                State::Slack => along >= -nothing,
                State::Full => along < -nothing,
                State::Between => true,
            }
        })
    }

    /// The forces of a mode that keep points in their places while the body moves; `None` where none do. With one freedom to move, a point
    /// that stays leaves none.
    fn kept_in_place(
        &self,
        block: &Block,
        mode: Mode,
        states: &[State; MOST],
        wrench: &Wrench,
    ) -> Result<Option<[f64; MOST]>, InputError> {
        let turns_and_slips = mode.corner().is_some() && mode.slip().is_some();
        if !turns_and_slips && mode != Mode::Flight {
            return Ok(None);
        }
        let mut forces = self.full(states);
        let kept: Vec<(usize, &Hold)> =
            self.holds().enumerate().filter(|(place, _)| states[*place] == State::Between).collect();
        let along = |wrench: &Wrench| -> Vec<f64> {
            let motion = raw(block, mode, wrench);
            kept.iter().map(|(_, hold)| hold.along(&motion)).collect()
        };
        let columns: Vec<Vec<f64>> = kept.iter().map(|(_, hold)| along(&hold.unit())).collect();
        let constant = along(&self.held(wrench, &forces));
        let row = |row: usize| Constraint {
            constant: constant[row],
            factors: columns.iter().map(|column| column[row]).collect(),
            size: 0.0,
        };
        let rows: Vec<Constraint> = (0..kept.len()).map(row).collect();
        let Some(found) = meeting(&rows.iter().collect::<Vec<_>>()) else { return Ok(None) };
        for ((place, hold), force) in kept.iter().zip(found) {
            if !(force > 0.0 && force < hold.limit) {
                return Ok(None);
            }
            forces[*place] = force;
        }
        let held = self.held(wrench, &forces);
        let motion = raw(block, mode, &held);
        // Where a point that stays leaves no rotation, that is the edge of a mode without.
        let turns = |wrench: &Wrench| raw(block, mode, wrench).theta_ddot.abs();
        let of_forces: f64 = self.holds().map(|hold| hold.limit * turns(&hold.unit())).sum();
        let turns = motion.theta_ddot.abs() > 1e-9 * (turns(wrench) + of_forces);
        let agrees = turns && self.moves_so(states, &motion) && solve(block, &held)?.modes.contains(mode);
        Ok(agrees.then_some(forces))
    }

    /// The decision under a wrench.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn decide(&self, block: &Block, wrench: &Wrench) -> Result<Decision, InputError> {
        let found = self.solve(block, wrench)?;
        Ok(Decision { verdict: found.mode.map(Verdict::Begins), modes: found.modes })
    }

    /// The stages of variable loads that rise from nothing without end.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn stages(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<Vec<Stage>, InputError> {
        let ends = self.events(block, permanent, variable);
        stages_between(ends, |factor| self.decide(block, &(*permanent + *variable * factor)))
    }

    /// The departure under a load that rises from zero beside `permanent`.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn departure(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<Departure, InputError> {
        let begin = self.decide(block, permanent)?.verdict;
        Departure::along(begin, self.stages(block, permanent, variable)?.into_iter().map(Ok))
    }

    /// The spans of friction from zero without end, found by bisection; beyond `up_to`, or ten where that is infinite, none is looked for.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn friction_spans(
        &self,
        block: &Block,
        wrench: &Wrench,
        up_to: f64,
    ) -> Result<Vec<Span>, InputError> {
        const PARTS: u32 = 200;
        let last = up_to.min(10.0);
        let ends = (1..=PARTS).map(|part| last * f64::from(part) / f64::from(PARTS)).collect();
        let stages = stages_between(ends, |μ| self.decide(&with_friction(block, μ), wrench))?;
        let spans = stages.into_iter().enumerate().map(|(boundary, stage)| {
            let Stage { from, to, verdict, modes } = stage;
            Span { from, to, verdict, modes, boundary }
        });
        Ok(spans.collect())
    }

    /// The load factors at which anything may change, but for those at which a point begins to stay in its place while the body moves.
    fn events(&self, block: &Block, permanent: &Wrench, variable: &Wrench) -> Vec<f64> {
        let mut events = Vec::new();
        for states in self.states().filter(|states| !states.contains(&State::Between)) {
            let from = self.held(permanent, &self.full(&states));
            events.extend(path::crossings(block, &from, variable));
            events.extend(self.stick_ends(block, &from, variable));
            for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Rest) {
                let [one, two] = [&from, variable].map(|wrench| raw(block, mode, wrench));
                events.extend(self.holds().map(|hold| -hold.along(&one) / hold.along(&two)));
            }
        }
        events.extend(self.ends_of_rest(block, permanent, variable));
        events
    }

    /// The load factors at the corners of the polytopes of load factor and forces in which a body rests without adhesion, or slides.
    fn ends_of_rest(&self, block: &Block, permanent: &Wrench, variable: &Wrench) -> Vec<f64> {
        let limits: Vec<f64> = self.holds().map(|hold| hold.limit).collect();
        let mut units = vec![*variable];
        units.extend(self.holds().map(Hold::unit));
        let mut ends = Vec::new();
        let polytopes = [
            resting(block, permanent, &units),
            sliding(block, Slip::Left, permanent, &units),
            sliding(block, Slip::Right, permanent, &units),
        ];
        for mut constraints in polytopes {
            constraints.extend(boxed(&limits).into_iter().map(|mut constraint| {
                constraint.factors.insert(0, 0.0);
                constraint
            }));
            for active in choices(constraints.len(), units.len()) {
                let rows: Vec<&Constraint> = active.iter().map(|place| &constraints[*place]).collect();
                ends.extend(meeting(&rows).map(|found| found[0]));
            }
        }
        ends
    }
}

/// The stages between load factors at which a decision may change. Where one changes beside them after all, the place is found by bisection.
///
/// # Errors
/// As `decide`.
pub(crate) fn stages_between(
    mut ends: Vec<f64>,
    decide: impl Fn(f64) -> Result<Decision, InputError>,
) -> Result<Vec<Stage>, InputError> {
    ends.retain(|end| end.is_finite() && *end > 0.0 && *end < LARGEST / 4.0);
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|later, earlier| *later - *earlier <= 1e-13 * *later);
    ends.push(f64::INFINITY);
    let mut stages = Vec::new();
    let mut from = 0.0;
    let mut before: Option<(f64, Decision)> = None;
    for to in ends {
        let inside = match to {
            f64::INFINITY if from == 0.0 => 1.0,
            f64::INFINITY => 2.0 * from,
            to => from + (to - from) / 2.0,
        };
        let here = decide(inside)?;
        let mut begin = from;
        if let Some((earlier, was)) = before.filter(|(_, was)| *was != here) {
            // Nearly always at the end between both.
            let [below, above] =
                [from * (1.0 - 1e-9), from * (1.0 + 1e-9)].map(|at| at.clamp(earlier, inside));
            let is_there = decide(below)? == was && decide(above)? == here;
            let (mut low, mut high) = (earlier, inside);
            for _ in 0..if is_there { 0 } else { 60 } {
                let middle = low + (high - low) / 2.0;
                if decide(middle)? == was { low = middle } else { high = middle }
            }
            begin = if is_there { from } else { high };
            if let Some(last) = stages.last_mut() {
                let last: &mut Stage = last;
                last.to = begin;
            }
        }
        Stage { from: begin, to, verdict: here.verdict, modes: here.modes }.join(&mut stages);
        before = Some((inside, here));
        from = to;
    }
    Ok(stages)
}

/// The moments that hold the body down at O and at O'.
pub(crate) fn moments(block: &Block, Wrench { x, p, m }: &Wrench) -> [f64; 2] {
    let moment = x * block.d - m;
    [moment + block.b1 * p, block.b2 * p - moment]
}

/// The motion of a mode under a wrench, whether that is consistent or not: linear in the wrench.
fn raw(block: &Block, mode: Mode, wrench: &Wrench) -> Motion {
    let numbers = numbers(block, wrench);
    motion(&numbers, mode, |corner, slip| rotation(numbers, corner, slip))
}

/// The place of a mode in the order in which modes are reported.
fn rank(block: &Block, mode: Mode) -> u8 {
    let turns = |corner: Corner, slip: Option<Slip>| {
        Rotation::of(&numbers(block, &Wrench::ZERO), corner, slip).inertia > 0.0
    };
    match (mode, mode.corner(), mode.slip()) {
        (Mode::Rest, ..) => 0,
        (Mode::Flight, ..) => 5,
        (_, None, _) => 1,
        (_, Some(_), None) => 3,
        (_, Some(corner), slip) if turns(corner, slip) => 2,
        _ => 4,
    }
}

/// A condition, linear in a wrench, that is not to be below zero.
type Condition<'a> = &'a dyn Fn(&Wrench) -> f64;

/// The conditions of rest under `start` and wrenches times numbers.
fn resting(block: &Block, start: &Wrench, units: &[Wrench]) -> Vec<Constraint> {
    let conditions: [Condition<'_>; 4] = [
        &|wrench| block.mu_s * wrench.p - wrench.x,
        &|wrench| block.mu_s * wrench.p + wrench.x,
        &|wrench| moments(block, wrench)[0],
        &|wrench| moments(block, wrench)[1],
    ];
    constraints(&conditions, start, units)
}

/// The conditions of a slide.
fn sliding(block: &Block, slip: Slip, start: &Wrench, units: &[Wrench]) -> Vec<Constraint> {
    let s = slip.sign();
    let moment = |wrench: &Wrench| s * block.mu_k * block.d * wrench.p - wrench.m;
    let conditions: [Condition<'_>; 3] = [
        &|wrench| s * wrench.x - block.mu_s * wrench.p,
        &|wrench| moment(wrench) + block.b1 * wrench.p,
        &|wrench| block.b2 * wrench.p - moment(wrench),
    ];
    constraints(&conditions, start, units)
}

fn constraints(conditions: &[Condition<'_>], start: &Wrench, units: &[Wrench]) -> Vec<Constraint> {
    let size = start.x.abs() + start.p.abs() + start.m.abs();
    let of = |condition: Condition<'_>| Constraint {
        constant: condition(start),
        factors: units.iter().map(condition).collect(),
        size,
    };
    conditions.iter().map(|condition| of(*condition)).collect()
}
