//! The modes as intervals along the number that is not sampled.

use std::cell::RefCell;

use standfast::contact::path;
use standfast_probability::problem::{Outcomes, Pieces};

use super::base;
use super::outcome::{LIFTED, NOT_A_BODY, nothing, of_modes, push_all, told_apart};
use super::problem::{ChanceProblem, Line};
use super::stack::Asked;

impl Outcomes for ChanceProblem {
    fn count(&self) -> usize {
        self.outcomes()
    }

    fn line(&self) -> usize {
        match self.line {
            Line::Friction(place) | Line::Load(place) | Line::Scan(place) => place,
        }
    }

    fn is_quick(&self, input: usize) -> bool {
        // Formulas of waves and bodies are not worked out again.
        self.random()[input].variable().is_none() || self.is_apart(input)
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        if self.has_joints() {
            return self.joints_along(values, Asked::Full, pieces);
        }
        if self.is_on_plan() {
            return self.plan_along(values, Asked::Full, pieces);
        }
        let mut values = values.to_vec();
        let everywhere =
            |pieces: &mut Pieces, outcome| pieces.push(f64::NEG_INFINITY, f64::INFINITY, outcome);
        match self.line {
            Line::Friction(place) => {
                values[place] = 1.0;
                let Some(mechanics) = self.mechanics(&values) else {
                    return nothing(pieces);
                };
                let (block, wrench) = (mechanics.block, mechanics.wrench());
                pieces.branch(u64::from(mechanics.formulas));
                if wrench.p <= 0.0 {
                    everywhere(pieces, LIFTED);
                }
                if base::by_friction(&mechanics.base, &block, &wrench, self.reach(place), pieces).is_err() {
                    nothing(pieces);
                }
            }
            Line::Load(place) => {
                values[place] = 0.0;
                let without = self.mechanics(&values);
                values[place] = 1.0;
                let (Some(without), Some(with)) = (without, self.mechanics(&values)) else {
                    return nothing(pieces);
                };
                pieces.branch(u64::from(with.formulas));
                let (block, start) = (with.block, without.wrench());
                let slope = with.wrench() + start * -1.0;
                let level = -start.p / slope.p;
                match (start.p > 0.0, level > 0.0) {
                    (true, true) => pieces.push(level, f64::INFINITY, LIFTED),
                    (false, true) => pieces.push(f64::NEG_INFINITY, level, LIFTED),
                    (false, false) => everywhere(pieces, LIFTED),
                    (true, false) => {}
                }
                let Ok(stages) = path::stages(&block, &start, &slope) else {
                    return nothing(pieces);
                };
                let stages = stages
                    .iter()
                    .map(|stage| (stage.from, stage.to, of_modes(stage.verdict, stage.modes), 0));
                for (from, to, outcomes, _) in told_apart(stages) {
                    push_all(pieces, from, to, outcomes);
                }
            }
            Line::Scan(place) => self.scan(place, &values, pieces, |values| self.at(values)),
        }
    }

    fn at(&self, values: &[f64]) -> u64 {
        if self.has_joints() {
            return self.of_joints(values, Asked::Full);
        }
        if self.is_on_plan() {
            return self.on_plan(values, Asked::Full);
        }
        match self.mechanics(values) {
            Some(mechanics) => mechanics.outcomes(),
            None => 1 << NOT_A_BODY,
        }
    }
}

impl ChanceProblem {
    /// The outcomes along a number of which no boundary is known in closed form; `at` has them for all values, a bit for each.
    pub(super) fn scan(&self, place: usize, values: &[f64], pieces: &mut Pieces, at: impl Fn(&[f64]) -> u64) {
        let values = RefCell::new(values.to_vec());
        pieces.scan(&self.laws().laws()[place], |x| {
            let mut values = values.borrow_mut();
            values[place] = x;
            at(&values)
        });
    }
}
