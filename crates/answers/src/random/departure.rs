//! Into which mode a body leaves rest first as its variable loads rise, as intervals along the number that is not sampled.

use std::cell::RefCell;

use standfast::contact::departure::by_share;
use standfast::ground::Base;
use standfast::{Departure, DepartureSpan};
use standfast_probability::problem::{Outcomes, Pieces};

use super::lines::Line;
use super::mechanics::Mechanics;
use super::outcome::{NOT_A_BODY, nothing, of_verdict};
use super::problem::ChanceProblem;
use super::stack::Asked;

/// The body rests under any multiple of the variable loads.
pub(super) const NEVER: usize = 16;
/// It moves as soon as any share of the variable loads acts, or under the permanent loads alone.
pub(super) const AT_ONCE: usize = 17;

/// First departures of a problem in place of modes under the full load.
pub(super) struct Departures<'a>(pub(super) &'a ChanceProblem);

fn outcome(departure: Departure) -> usize {
    match departure {
        Departure::Never => NEVER,
        Departure::AtOnce { .. } => AT_ONCE,
        Departure::At { verdict, .. } => of_verdict(verdict),
    }
}

/// Identity of spans: a problem by its number, block and wrenches in their order, and the base.
type Key = (u64, [f64; 15], Base);

thread_local! {
    /// The spans that were asked for last. Where all that is random leaves the direction of the loads, they are the same.
    static LAST: RefCell<Option<(Key, Option<Vec<DepartureSpan>>)>> = const { RefCell::new(None) };
}

impl Departures<'_> {
    /// The outcomes that exclude each other and add up to one.
    pub(super) fn exclusive(&self) -> impl Iterator<Item = usize> {
        let moved = self.0.moving();
        moved.chain([NEVER, AT_ONCE])
    }

    fn scan(&self, place: usize, values: &[f64], pieces: &mut Pieces) {
        self.0.scan(place, values, pieces, |values| self.at(values));
    }

    /// The spans along friction, for block and loads as they were last or anew.
    fn along_friction(&self, place: usize, mechanics: &Mechanics, values: Vec<f64>, pieces: &mut Pieces) {
        let Mechanics { block, base, permanent, variable, .. } = mechanics;
        let of = [block.b1, block.b2, block.d, block.rho2, block.m_x, block.m_y, block.mu_s, block.mu_k];
        let mut numbers = [0.0; 15];
        numbers[..8].copy_from_slice(&of);
        for (place, wrench) in [(8, permanent), (11, variable)] {
            numbers[place..place + 3].copy_from_slice(&[wrench.x, wrench.p, wrench.m]);
        }
        let key = (self.0.id(), numbers, *base);
        let known = LAST.with_borrow_mut(|last| {
            if !last.as_ref().is_some_and(|(of, _)| *of == key) {
                let spans = base.departure_spans(block, permanent, variable, self.0.reach(place));
                *last = spans.ok().map(|spans| (key, spans));
            }
            match last {
                Some((_, Some(spans))) => push(spans, pieces),
                Some((_, None)) => return false,
                None => nothing(pieces),
            }
            true
        });
        if !known {
            self.scan(place, &values, pieces);
        }
    }
}

fn push(spans: &[DepartureSpan], pieces: &mut Pieces) {
    spans.iter().for_each(|span| pieces.push(span.from, span.to, outcome(span.departure)));
}

impl Outcomes for Departures<'_> {
    fn count(&self) -> usize {
        self.0.outcomes()
    }

    fn line(&self) -> usize {
        self.0.line()
    }

    fn is_quick(&self, input: usize) -> bool {
        self.0.is_quick(input)
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        if self.0.has_joints() {
            return self.0.joints_along(values, Asked::Departure, pieces);
        }
        if self.0.is_on_plan() {
            return self.0.plan_along(values, Asked::Departure, pieces);
        }
        let mut values = values.to_vec();
        match self.0.line {
            Line::Friction(place) => {
                values[place] = 1.0;
                let Some(mechanics) = self.0.departing(&values) else { return nothing(pieces) };
                pieces.branch(u64::from(mechanics.formulas));
                self.along_friction(place, &mechanics, values, pieces);
            }
            Line::Load(place) => {
                values[place] = 0.0;
                let without = self.0.mechanics(&values);
                values[place] = 1.0;
                let (Some(without), Some(with)) = (without, self.0.mechanics(&values)) else {
                    return nothing(pieces);
                };
                pieces.branch(u64::from(with.formulas));
                if with.permanent != without.permanent {
                    return self.scan(place, &values, pieces);
                }
                let slope = with.variable + without.variable * -1.0;
                match by_share(&with.block, &with.permanent, &without.variable, &slope) {
                    Ok(spans) => push(&spans, pieces),
                    Err(_) => nothing(pieces),
                }
            }
            Line::Scan(place) => self.scan(place, &values, pieces),
        }
    }

    fn at(&self, values: &[f64]) -> u64 {
        if self.0.has_joints() {
            return self.0.of_joints(values, Asked::Departure);
        }
        if self.0.is_on_plan() {
            return self.0.on_plan(values, Asked::Departure);
        }
        let departing = self.0.departing(values).and_then(|mechanics| mechanics.departure());
        1 << departing.map_or(NOT_A_BODY, outcome)
    }
}
