//! Outcomes of a block on its base, under one friction or along all.

use standfast::contact::Block;
use standfast::ground::bearing::BearingBlock;
use standfast::ground::{Base, strength};
use standfast::{InputError, Situation, Wrench};
use standfast_probability::problem::Pieces;

use super::outcome::{NOT_A_BODY, of_modes, push_all, told_apart};
use crate::case::{Foundation, Limit};

/// The base that a foundation is under the block of a situation. On one that is elastic and bears everything the modes are those on a
/// rigid one.
pub(super) fn under(situation: &Situation, foundation: Option<&Foundation>) -> Result<Base, InputError> {
    let holding = situation.reduced_holding();
    Ok(match foundation.and_then(|foundation| foundation.limit) {
        None => holding.map_or(Base::Rigid, Base::Held),
        Some(Limit::Strength(strength)) => Base::Crushing(strength::reduced_strength(situation, strength)?),
        Some(Limit::Ground(ground)) => Base::Failing(BearingBlock::of(ground, situation)?),
    })
}

/// The outcomes of a wrench: the verdict, and whether other modes are consistent too.
pub(super) fn outcomes(base: &Base, block: &Block, wrench: &Wrench) -> u64 {
    base.decide(block, wrench).map_or(1 << NOT_A_BODY, |found| of_modes(found.verdict, found.modes))
}

/// The outcomes of a wrench for every friction, μ_k in its proportion; beyond `up_to` none need be told.
pub(super) fn by_friction(
    base: &Base,
    block: &Block,
    wrench: &Wrench,
    up_to: f64,
    pieces: &mut Pieces,
) -> Result<(), InputError> {
    let spans = base.friction_spans(block, wrench, up_to)?.into_iter();
    let spans = spans.map(|span| (span.from, span.to, of_modes(span.verdict, span.modes), span.boundary));
    let spans = if *base == Base::Rigid { told_apart(spans) } else { spans.collect() };
    for (from, to, outcomes, boundary) in spans {
        pieces.branch(boundary as u64);
        push_all(pieces, from, to, outcomes);
    }
    Ok(())
}
