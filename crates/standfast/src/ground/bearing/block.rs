//! Ground that can fail under the block of a contact problem: what begins, for one friction or for all, and where it leaves rest.

use super::Ground;
use super::edges::MOST_INCLINED;
use super::path::{Footing, GroundPath};
use super::situated::SituatedGround;
use crate::contact::departure::by_friction;
use crate::contact::{self, Block, friction, path};
use crate::departure::{Departure, DepartureSpan, parting};
use crate::error::InputError;
use crate::ground::roots::between;
use crate::mode::{Mode, Slip};
use crate::neighbour::Neighbour;
use crate::plan::Plan;
use crate::quantity::{Expected, Quantity};
use crate::situation::Situation;
use crate::span::Span;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// Ground under a block whose lengths and forces are in units: the laws of the ground are not free of units, as those of the
/// [contact problem](crate::contact) are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingBlock {
    ground: Ground,
    length: f64,
    force: f64,
}

/// Step beyond a load factor, relative to it, at which the verdict just beyond is looked for.
const BEYOND: f64 = 1e-9;
/// Number of frictions looked at for one with which the ground bears a body that slides.
const STEPS: u32 = 16;

impl BearingBlock {
    /// The ground under a block of which a length of 1 is `length` (m), and a force of 1 is `force` (N per metre run).
    ///
    /// # Errors
    /// If one of them is not above zero.
    pub fn new(ground: Ground, length: f64, force: f64) -> Result<BearingBlock, InputError> {
        Ok(BearingBlock {
            ground,
            length: InputError::positive(Quantity::HalfWidth, length)?,
            force: InputError::positive(Quantity::WrenchP, force)?,
        })
    }

    /// The ground under a situation's [block](Situation::reduced_block), of which a length of 1 is B and a force of 1 is m g.
    ///
    /// # Errors
    /// If the base is round.
    pub fn of(ground: Ground, situation: &Situation) -> Result<BearingBlock, InputError> {
        let body = situation.body();
        let Plan::Rectangle { length } = body.plan() else {
            return Err(InputError::new(Quantity::Width, body.width(), Expected::RectangularBase));
        };
        BearingBlock::new(ground, body.width() / 2.0, body.mass() * situation.gravity() / length)
    }

    fn path(&self, block: &Block, permanent: &Wrench, variable: &Wrench) -> GroundPath {
        GroundPath::on(self.ground, Footing::under_block(block, self.length, self.force, permanent, variable))
    }

    /// The decision under a wrench, as [`bearing::outcome`](super::outcome) has it of a situation.
    ///
    /// # Errors
    /// As [`contact::solve`].
    pub fn decide(&self, block: &Block, wrench: &Wrench) -> Result<Decision, InputError> {
        let mode = contact::solve(block, wrench)?.mode();
        let path = self.path(block, wrench, &Wrench::ZERO);
        Ok(SituatedGround::new(path, block.mu_k).decide(mode, 0.0))
    }

    /// The spans of friction from zero without end: those of the rigid base, parted where the ground begins or ceases to bear a body
    /// that slides. It bears on one stretch of frictions: an eccentricity falls and rises again, an inclination only takes
    /// away. Beyond `up_to` none is asked for, and the last span is as it is there. The block's own μ_s and μ_k say by their ratio alone how
    /// slip follows stick.
    ///
    /// # Errors
    /// As [`contact::solve`].
    pub fn friction_spans(
        &self,
        block: &Block,
        wrench: &Wrench,
        up_to: f64,
    ) -> Result<Vec<Span>, InputError> {
        let ratio = contact::with_friction(block, 1.0).mu_k;
        let path = self.path(block, wrench, &Wrench::ZERO);
        let mut spans = Vec::new();
        for span in friction::spans(block, wrench)? {
            let mut add = |from: f64, to: f64, decision: Decision, boundary: usize| {
                let Decision { verdict, modes } = decision;
                Span { from, to, verdict, modes, boundary }.join(&mut spans);
            };
            let upright = |mode: Mode| mode.corner().is_none() && mode.slip().is_some();
            match span.mode() {
                Some(mode) if upright(mode) && ratio > 0.0 => {
                    let slip = if mode == Mode::SlideRight { Slip::Right } else { Slip::Left };
                    let borne = SlidingGround { path: &path, slip };
                    let stretch = borne.between(span.from * ratio, span.to * ratio);
                    let fails = Decision::from(Some(Verdict::BearingFailure));
                    match stretch {
                        None => add(span.from, span.to, fails, span.boundary),
                        Some([low, high]) => {
                            let (low, high) = (low.max(span.from * ratio), high.min(span.to * ratio));
                            let begins = Decision::from(span.verdict);
                            // An end that is none of the ground keeps its digits.
                            let end = |μ: f64, of: f64| if μ == of * ratio { of } else { μ / ratio };
                            let (from, to) = (end(low, span.from), end(high, span.to));
                            let side = |μ: f64| BORNE + usize::from(borne.is_behind(μ));
                            if from > span.from {
                                add(span.from, from, fails, span.boundary);
                            }
                            add(from, to, begins, if from > span.from { side(low) } else { span.boundary });
                            if to < span.to {
                                add(to, span.to, fails, side(high));
                            }
                        }
                    }
                }
                // At one friction as at any other: neither rest nor what turns asks the ground of it.
                mode => {
                    add(span.from, span.to, SituatedGround::new(path, 0.0).decide(mode, 0.0), span.boundary)
                }
            }
        }
        spans.truncate(spans.iter().take_while(|span| span.from < up_to).count().max(1));
        if let Some(last) = spans.last_mut() {
            last.to = f64::INFINITY;
        }
        Ok(spans)
    }

    /// Departure under a load that rises from zero beside `permanent`: first motion of the block, or failure of the ground under it.
    ///
    /// # Errors
    /// As [`contact::solve`].
    pub fn departure(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<Departure, InputError> {
        self.departure_before(self.failure(block, permanent, variable), block, permanent, variable)
    }

    /// Departure where the [least load factor at which the ground fails](BearingBlock::failure) is known: it is one for all frictions.
    ///
    /// # Errors
    /// As [`contact::solve`].
    pub fn departure_before(
        &self,
        fails: f64,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<Departure, InputError> {
        let on = SituatedGround::new(self.path(block, permanent, variable), block.mu_k);
        let rigid = path::departure(block, permanent, variable)?;
        let verdict = |factor: f64| on.decide(rigid.mode(), factor).verdict;
        let failure = Some(Verdict::BearingFailure);
        Ok(match rigid {
            Departure::AtOnce { permanent, .. } => Departure::AtOnce { verdict: verdict(0.0), permanent },
            _ if fails == 0.0 => Departure::AtOnce { verdict: failure, permanent: true },
            Departure::At { factor, .. } if factor < fails => {
                Departure::At { factor, verdict: verdict(factor * (1.0 + BEYOND)) }
            }
            _ => Departure::from_rest(fails, failure),
        })
    }

    /// The departures for every friction, the same to stick and to slip, up to one beyond which none is asked for.
    ///
    /// # Errors
    /// As [`contact::solve`].
    pub fn departure_spans(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
        up_to: f64,
    ) -> Result<Vec<DepartureSpan>, InputError> {
        let end = self.failure(block, permanent, variable);
        let mut values = Vec::from(parting(permanent, variable, end));
        values.extend(by_friction(block, permanent, variable)?.iter().map(|span| span.from));
        DepartureSpan::by_friction(values, up_to, |μ| {
            self.departure_before(end, &Block { mu_s: μ, mu_k: μ, ..*block }, permanent, variable)
        })
    }

    /// The least load factor at which the ground fails under a body that friction holds; zero where it does under the permanent loads,
    /// infinite where it bears any multiple of the others.
    pub fn failure(&self, block: &Block, permanent: &Wrench, variable: &Wrench) -> f64 {
        self.path(block, permanent, variable).failure()
    }
}

/// The numbers of boundaries of the ground, beyond those of the conditions of contact.
const BORNE: usize = 64;

/// The ground under a body that slides, for each friction to slip.
struct SlidingGround<'a> {
    path: &'a GroundPath,
    slip: Slip,
}

impl SlidingGround<'_> {
    fn excess(&self, mu: f64) -> f64 {
        self.path.excess(Some((self.slip, mu)), 0.0)
    }

    /// True if the reaction lies against the push.
    fn is_behind(&self, mu: f64) -> bool {
        self.path.sliding_reaction(0.0, self.slip, mu).is_some_and(|at| at.x() * at.e() < 0.0)
    }

    /// Between which frictions of these the ground bears the body; none if with none.
    fn between(&self, from: f64, to: f64) -> Option<[f64; 2]> {
        // No formula bears a body that slides with more.
        let to = to.min(MOST_INCLINED.max(from));
        let bears = [from, to].map(|mu| self.excess(mu) >= 0.0);
        if bears == [true; 2] {
            return Some([from, to]);
        }
        let best = self.best(from, to);
        if self.excess(best) < 0.0 {
            return None;
        }
        let end = |low: f64, high: f64| between(|mu| self.excess(mu), low, high);
        let least = if bears[0] { Some(from) } else { end(from, best) };
        let most = if bears[1] { Some(to) } else { end(best, to) };
        Some([least.unwrap_or(best), most.unwrap_or(best)])
    }

    /// The friction with which the ground bears most, or one with which it bears the body.
    fn best(&self, from: f64, to: f64) -> f64 {
        let even = self.path.even_friction(self.slip, 0.0).filter(|mu| *mu > from && *mu < to);
        let grid = (0..=STEPS).map(|i| from + (to - from) * f64::from(i) / f64::from(STEPS));
        let better = |one: &f64, other: &f64| self.excess(*one).total_cmp(&self.excess(*other));
        let near = grid.chain(even).max_by(better).unwrap_or(from);
        if self.excess(near) >= 0.0 {
            return near;
        }
        let step = (to - from) / f64::from(STEPS);
        let (mut low, mut high) = ((near - step).max(from), (near + step).min(to));
        for _ in 0..60 {
            let third = (high - low) / 3.0;
            if self.excess(low + third) < self.excess(high - third) { low += third } else { high -= third }
        }
        let middle = low + (high - low) / 2.0;
        if self.excess(middle) > self.excess(near) { middle } else { near }
    }
}
