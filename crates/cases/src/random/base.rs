//! What a block stands on, in its units: what begins on it, for one friction or for all, and where it leaves rest.

use standfast::contact::departure::by_friction;
use standfast::contact::{Block, friction, path, solve};
use standfast::ground::bearing::BearingBlock;
use standfast::ground::strength;
use standfast::ground::{GroundDeparture, GroundVerdict};
use standfast::{Departure, InputError, Mode, Situation, Wrench};
use standfast_probability::problem::Pieces;

use super::outcome::{NOT_A_BODY, of_modes, push_all, told_apart};
use crate::case::{Foundation, Limit};

/// What a block stands on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Base {
    /// It bears everything.
    Rigid,
    /// It crushes at this force per length, in the units of the block.
    Crushing(f64),
    /// The ground under it fails.
    Failing(BearingBlock),
}

/// Departures, each from a friction to another.
type Departures = Vec<(f64, f64, GroundDeparture)>;

fn begins(mode: Option<Mode>) -> Option<GroundVerdict> {
    mode.map(GroundVerdict::Begins)
}

impl Base {
    /// What a foundation is under the block of a situation. On one that is elastic and bears everything the modes are those on a rigid one.
    pub(super) fn under(situation: &Situation, foundation: Option<&Foundation>) -> Result<Base, InputError> {
        Ok(match foundation.and_then(|foundation| foundation.limit) {
            None => Base::Rigid,
            Some(Limit::Strength(strength)) => {
                Base::Crushing(strength::reduced_strength(situation, strength)?)
            }
            Some(Limit::Ground(ground)) => Base::Failing(BearingBlock::of(ground, situation)?),
        })
    }

    /// What begins under a wrench, and whether other modes are consistent too, as outcomes.
    pub(super) fn outcomes(&self, block: &Block, wrench: &Wrench) -> u64 {
        let found = match self {
            Base::Rigid => solve(block, wrench).map(|found| (begins(found.mode()), found.modes)),
            Base::Crushing(strength) => {
                strength::solve(block, wrench, *strength).map(|found| (found.verdict(), found.modes))
            }
            Base::Failing(ground) => ground
                .verdict(block, wrench)
                .map(|verdict| (verdict, verdict.and_then(GroundVerdict::mode).into_iter().collect())),
        };
        found.map_or(1 << NOT_A_BODY, |(verdict, modes)| of_modes(verdict, modes))
    }

    /// The same for every friction, μ_k in its proportion; beyond `up_to` none need be told.
    pub(super) fn by_friction(
        &self,
        block: &Block,
        wrench: &Wrench,
        up_to: f64,
        pieces: &mut Pieces,
    ) -> Result<(), InputError> {
        let spans = match self {
            Base::Rigid => {
                let spans = friction::spans_up_to(block, wrench, up_to)?;
                let spans =
                    spans.iter().map(|s| (s.from, s.to, of_modes(begins(s.mode), s.modes), s.condition));
                for (from, to, outcomes, condition) in told_apart(spans) {
                    pieces.branch(condition as u64);
                    push_all(pieces, from, to, outcomes);
                }
                return Ok(());
            }
            Base::Crushing(strength) => strength::friction_spans(block, wrench, *strength, up_to)?,
            Base::Failing(ground) => ground.friction_spans(block, wrench)?,
        };
        let count = spans.iter().take_while(|span| span.from < up_to).count().max(1);
        for (place, span) in spans.into_iter().take(count).enumerate() {
            let to = if place + 1 == count { f64::INFINITY } else { span.to };
            pieces.branch(span.boundary as u64);
            push_all(pieces, span.from, to, of_modes(span.verdict, span.modes));
        }
        Ok(())
    }

    /// Where the block leaves rest as the variable load rises.
    pub(super) fn departure(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
    ) -> Result<GroundDeparture, InputError> {
        match self {
            Base::Rigid => path::departure(block, permanent, variable).map(of_rigid),
            Base::Crushing(strength) => strength::departure(block, permanent, variable, *strength),
            Base::Failing(ground) => ground.departure(block, permanent, variable),
        }
    }

    /// The departures for every friction up to one, from each friction to the next; none where it is not known for certain which frictions part
    /// them. With one friction to stick and to slip, up to the end of rest that friction does not touch the body slides
    /// if the load there is more than friction holds. With more friction what begins at the end turns about the edge that gives way, and sticks
    /// there: its rotation begins from nothing.
    pub(super) fn departures(
        &self,
        block: &Block,
        permanent: &Wrench,
        variable: &Wrench,
        up_to: f64,
    ) -> Result<Option<Departures>, InputError> {
        if block.mu_k != block.mu_s {
            return Ok(None);
        }
        let with = |μ: f64| Block { mu_s: μ, mu_k: μ, ..*block };
        let inclination = |wrench: &Wrench| wrench.x.abs() / wrench.p;
        let at = |end: f64| if end.is_finite() { *permanent + *variable * end } else { *variable };
        let mut parting = vec![inclination(permanent)];
        let found = |parting: Vec<f64>, decide: &dyn Fn(f64) -> Result<GroundDeparture, InputError>| {
            between(parting, up_to, decide).map(Some)
        };
        match self {
            Base::Rigid => Ok(None),
            Base::Crushing(strength) => {
                let end = strength::departure(&with(HELD), permanent, variable, *strength)?.load_factor();
                parting.push(inclination(&at(end)));
                found(parting, &|μ| strength::departure(&with(μ), permanent, variable, *strength))
            }
            Base::Failing(ground) => {
                let end = ground.failure(block, permanent, variable);
                parting.push(inclination(&at(end)));
                let spans = by_friction(block, permanent, variable)?;
                parting.extend(spans.iter().map(|span| span.from));
                found(parting, &|μ| ground.departure_before(end, &with(μ), permanent, variable))
            }
        }
    }
}

/// What is decided once between each two neighbouring of these frictions.
fn between(
    mut parting: Vec<f64>,
    up_to: f64,
    decide: impl Fn(f64) -> Result<GroundDeparture, InputError>,
) -> Result<Departures, InputError> {
    parting.retain(|μ| *μ > 0.0 && *μ < up_to.min(HELD));
    parting.sort_by(f64::total_cmp);
    parting.dedup_by(|later, earlier| *later - *earlier <= ONE * later.abs());
    let mut spans = Departures::new();
    let mut from = 0.0;
    for to in parting.into_iter().chain([f64::INFINITY]) {
        let end = to.min(up_to);
        let inside = if end.is_finite() { from + (end - from) / 2.0 } else { 2.0 * from + 1.0 };
        let departure = decide(inside)?;
        match spans.last_mut() {
            Some((_, last, before)) if is_like(before, &departure) => *last = to,
            _ => spans.push((from, to, departure)),
        }
        from = to;
    }
    Ok(spans)
}

fn is_like(one: &GroundDeparture, other: &GroundDeparture) -> bool {
    std::mem::discriminant(one) == std::mem::discriminant(other) && one.verdict() == other.verdict()
}

/// Relative distance of two frictions that are one.
const ONE: f64 = 1e-12;
/// A friction that holds everything.
const HELD: f64 = 1e9;

/// A departure on a base that bears everything.
pub(super) fn of_rigid(departure: Departure) -> GroundDeparture {
    match departure {
        Departure::Never => GroundDeparture::Never,
        Departure::AtOnce { mode, permanent } => GroundDeparture::AtOnce { verdict: begins(mode), permanent },
        Departure::At { factor, mode } => GroundDeparture::At { factor, verdict: begins(mode) },
    }
}
