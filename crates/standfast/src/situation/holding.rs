//! Adhesion and forces with a limit, in the numbers of a situation.

use super::{Response, Situation};
use crate::contact::Block;
use crate::contact::holding::{Adhesion, HeldSolution, Hold, Holding, MOST, moments, stages_between};
use crate::contact::opening::OpeningState;
use crate::error::InputError;
use crate::mode::{Corner, Mode};
use crate::stability::{ClassicalActions, GrossOverturning, Margins, Stability};
use crate::stage::Stage;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// What holds a body beside friction, under the full load; N and m, of forces and lengths per metre run or of the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// Forces with a limit that rest needs, the least that will do; `None` where none hold it.
    pub needed: Option<[f64; MOST]>,
    /// These in the mode reported.
    pub used: [f64; MOST],
    /// These with which the base is pressed: of all with which the body rests, those that bring the resultant nearest to its middle.
    pub pressing: [f64; MOST],
    /// Sum of the limits of those that act against the push.
    pub against: f64,
    /// Sum of the limits of those that hold it down.
    pub down: f64,
    /// Moments with which they hold the body about its heel and about its toe, each that holds it there in full.
    pub moments: [f64; 2],
    /// A', the length of the base that adheres, m.
    pub adhering: f64,
    /// c_a A'.
    pub adhesion: f64,
}

impl Situation {
    /// Situation that something holds beside friction: lengths in m from the centre of mass, forces in N, adhesion in N per metre of its
    /// base's length.
    pub fn with_holding(self, holding: Holding) -> Situation {
        let holding = (!holding.is_empty()).then_some(holding);
        Situation { holding, written: None, ..self }
    }

    /// What holds it beside friction.
    pub fn holding(&self) -> Option<&Holding> {
        self.holding.as_ref()
    }

    /// The same in the units of the [reduced block](Situation::reduced_block).
    pub fn reduced_holding(&self) -> Option<Holding> {
        let holding = self.holding?;
        let (weight, half_width) = (self.body.mass() * self.gravity, self.body.width() / 2.0);
        let adhesion = holding.adhesion;
        let adhesion = adhesion
            .map(|Adhesion { strength, on }| Adhesion { strength: strength * half_width / weight, on });
        let reduced = |hold: &Hold| Hold {
            at: hold.at.map(|place| place / half_width),
            limit: hold.limit / weight,
            ..*hold
        };
        Some(holding.holds().map(reduced).fold(Holding::new(adhesion), Holding::with))
    }

    /// The answer under a load factor of a body that something holds; `None` of any other.
    fn held(&self, factor: f64) -> Result<Option<HeldSolution>, InputError> {
        let Some(holding) = self.reduced_holding() else { return Ok(None) };
        let block = self.reduced_block().0;
        // Where forces hold, they meet the water that stands there without them.
        let wrench = self.reduced_wrench(&self.total_at(factor));
        let held = holding.solve(&block, &wrench)?;
        let Some(opened) = self.followed(factor)?.filter(|_| holding.holds().next().is_none()) else {
            return Ok(Some(held));
        };
        // Each mode has the water of its own contact; what adheres lets it rest.
        let rests = held.modes.contains(Mode::Rest) && opened.state != OpeningState::Through;
        let mut modes = opened.modes;
        if rests {
            modes.insert(Mode::Rest);
        }
        Ok(Some(match rests {
            true => HeldSolution { modes, mode: Some(Mode::Rest), ..held },
            false => HeldSolution { modes, mode: opened.mode, motion: opened.motion, ..held },
        }))
    }

    fn decided_as_held(&self, factor: f64) -> Result<Option<Decision>, InputError> {
        let held = self.held(factor)?;
        Ok(held.map(|held| Decision { verdict: held.mode.map(Verdict::Begins), modes: held.modes }))
    }

    /// The response of a body that something holds; `None` of any other.
    pub(super) fn response_as_held(
        &self,
        factor: f64,
        wrench: Wrench,
    ) -> Result<Option<Response>, InputError> {
        let Some(held) = self.held(factor)? else { return Ok(None) };
        let (weight, half_width) = (self.body.mass() * self.gravity, self.body.width() / 2.0);
        Ok(Some(Response {
            wrench,
            verdict: held.mode.map(Verdict::Begins),
            modes: held.modes,
            // The report's plane knows no adhesion, and no force that gives way.
            effective: None,
            motion: held.motion.map(|motion| motion.scaled(self.gravity, half_width, weight)),
            boundary: None,
        }))
    }

    /// The mode under the permanent loads alone of a body that something holds; `None` of any other.
    pub(super) fn begins_as_held(&self) -> Result<Option<Option<Mode>>, InputError> {
        Ok(self.held(0.0)?.map(|held| held.mode))
    }

    /// The stages of the rising loads on a body that something holds; `None` of any other.
    pub(super) fn path_as_held(&self) -> Result<Option<Vec<Stage>>, InputError> {
        let Some(holding) = self.reduced_holding() else { return Ok(None) };
        let opened = self.path_as_it_opens()?;
        let Some(opened) = opened else {
            let sums = self.sums();
            let [permanent, variable] =
                [sums.permanent, sums.variable].map(|wrench| self.reduced_wrench(&wrench));
            return holding.stages(&self.reduced_block().0, &permanent, &variable).map(Some);
        };
        // No condition is linear in the load: each stretch is searched.
        let mut ends: Vec<f64> = opened.iter().map(|stage| stage.to).filter(|to| to.is_finite()).collect();
        let opening = self.base_opening();
        ends.extend(opening.iter().flat_map(|opening| [opening.opens_at, opening.tips_at]).flatten());
        let last = ends.iter().copied().fold(1.0, f64::max);
        ends.extend((1..=SEARCHED).map(|part| last * 4.0 * f64::from(part) / f64::from(SEARCHED)));
        let none = Decision { verdict: None, modes: crate::Modes::NONE };
        stages_between(ends, |factor| Ok(self.decided_as_held(factor)?.unwrap_or(none))).map(Some)
    }

    fn block_at_c(&self) -> Block {
        let body = &self.body;
        let [b1, b2, d] = [body.heel_distance(), body.toe_distance(), body.centroid_height()];
        Block {
            b1,
            b2,
            d,
            rho2: 1.0,
            m_x: 1.0,
            m_y: 1.0,
            mu_s: self.static_friction,
            mu_k: self.kinetic_friction,
        }
    }

    /// What holds the body beside friction under the full load; `None` where nothing does.
    pub(super) fn held_at_full(&self, wrench: &Wrench, heel: Corner) -> Result<Option<Held>, InputError> {
        let (Some(holding), Some(found)) = (self.holding, self.held(1.0)?) else { return Ok(None) };
        let weight = self.body.mass() * self.gravity;
        let in_newton = |forces: [f64; MOST]| forces.map(|force| force * weight);
        let block = self.block_at_c();
        let against = holding.holds().filter(|hold| hold.direction[0] * wrench.x < 0.0);
        let against = against.map(|hold| hold.limit).sum();
        let down = holding.holds().map(|hold| hold.unit().p * hold.limit).sum();
        let (needed, used) = (found.needed.map(in_newton), in_newton(found.used));
        let pressing = needed.map_or(used, |needed| pressing(&holding, &block, wrench, needed));
        let adhering = holding.adhering(&block, &holding.held(wrench, &pressing));
        let adhesion = holding.adhesion.map_or(0.0, |adhesion| adhesion.strength) * adhering;
        let mut moments = [0.0; 2];
        for hold in holding.holds() {
            let [at_o, at_o_prime] = holding_moments(&block, hold).map(|moment| moment * hold.limit);
            let by_corner = if heel == Corner::O { [at_o, at_o_prime] } else { [at_o_prime, at_o] };
            for (sum, moment) in moments.iter_mut().zip(by_corner) {
                *sum += moment.max(0.0);
            }
        }
        Ok(Some(Held { needed, used, pressing, against, down, moments, adhering, adhesion }))
    }

    /// Puts what holds the body beside friction into factors and margins.
    pub(super) fn strengthen(
        &self,
        held: &Held,
        wrench: &Wrench,
        actions: &ClassicalActions,
        (margins, stability, gross): (&mut Margins, &mut Stability, &mut GrossOverturning),
    ) {
        let Some(holding) = self.holding else { return };
        let block = self.block_at_c();
        let [about_heel, about_toe] = held.moments;
        margins.overturning_about_heel += about_heel;
        margins.overturning_about_toe += about_toe;
        if about_heel + about_toe > 0.0 {
            (stability.overturning_about_heel, stability.overturning_about_toe) =
                actions.overturning(&self.body, [about_heel, about_toe]);
            *gross = gross.held_by(&self.body, actions, [about_heel, about_toe]);
        }
        let total = holding.held(wrench, &held.pressing);
        if total.p > 0.0 && held.pressing.iter().any(|force| *force > 0.0) {
            let [at_o, at_o_prime] = moments(&block, &total);
            let from_heel = if actions.heel == Corner::O { at_o } else { at_o_prime };
            stability.bear(&self.body, total.p, from_heel / total.p);
        }
    }
}

/// Places along a load path at which it is searched for what changes, up to four times its last known change.
const SEARCHED: u32 = 64;

/// Of forces between those that rest needs and all of what holds the corner that the body is nearest to tipping about, those that bring the
/// resultant nearest to the middle of the base. Friction bears no more than it can.
fn pressing(holding: &Holding, block: &Block, wrench: &Wrench, needed: [f64; MOST]) -> [f64; MOST] {
    let start = holding.held(wrench, &needed);
    let corner = usize::from(tipping(block, &start) == Corner::OPrime);
    let mut all = needed;
    for (place, hold) in holding.holds().enumerate() {
        if holding_moments(block, hold)[corner] > 0.0 {
            all[place] = hold.limit;
        }
    }
    let end = holding.held(wrench, &all);
    let adheres =
        holding.adhesion.map_or(0.0, |adhesion| adhesion.strength * holding.adhering(block, &start));
    let off_middle = |wrench: &Wrench| {
        let [at_o, at_o_prime] = moments(block, wrench);
        at_o - at_o_prime
    };
    // All are linear on the way from the one to the other.
    let middle = reaches_zero(off_middle(&start), off_middle(&end));
    let slips = [1.0, -1.0].map(|side| {
        let left = |wrench: &Wrench| block.mu_s * wrench.p + adheres - side * wrench.x;
        match left(&end) < 0.0 {
            true => reaches_zero(left(&start).max(0.0), left(&end)),
            false => 1.0,
        }
    });
    let share = middle.min(slips[0]).min(slips[1]);
    let mut forces = needed;
    for (force, all) in forces.iter_mut().zip(all) {
        *force += share * (all - *force);
    }
    forces
}

/// The share of the way from one number to another at which a straight line is zero; all of it where it is not.
fn reaches_zero(from: f64, to: f64) -> f64 {
    if from == 0.0 {
        return 0.0;
    }
    let share = from / (from - to);
    if (0.0..1.0).contains(&share) { share } else { 1.0 }
}

/// The moments about O and O' with which a force of one holds the body.
fn holding_moments(block: &Block, hold: &Hold) -> [f64; 2] {
    moments(block, &hold.unit())
}

/// The corner that the resultant is nearer to.
fn tipping(block: &Block, wrench: &Wrench) -> Corner {
    let [at_o, at_o_prime] = moments(block, wrench);
    if at_o <= at_o_prime { Corner::O } else { Corner::OPrime }
}
