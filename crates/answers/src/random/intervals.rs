//! The modes as intervals along the number that is not sampled.

use std::cell::RefCell;

use standfast::contact::path;
use standfast_probability::problem::{Outcomes, Pieces};

use super::base;
use super::lines::Line;
use super::outcome::{LIFTED, NOT_A_BODY, NOT_UNIQUE, nothing, of_modes, push_all, told_apart};
use super::problem::ChanceProblem;
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
        let input_of = &self.random()[input];
        input_of.variable().is_none() && !input_of.is_beside_keys() || self.is_apart(input)
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
        if self.is_of_plane() {
            // The report's own decision is fifty times as fast as that of any block, for plain draws.
            return self.point_with(values).map_or(1 << NOT_A_BODY, |point| {
                let mode = point.mode();
                1 << mode as usize | u64::from(!point.others_beside(mode).is_empty()) << NOT_UNIQUE
            });
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
        let law = self.laws().law_at(place, values);
        let values = RefCell::new(values.to_vec());
        pieces.scan(&law, &[], |x| {
            let mut values = values.borrow_mut();
            values[place] = x;
            at(&values)
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use standfast_model::CaseFile;
    use standfast_probability::sample::draws;

    /// The report's decision at a point, and that of any block, over all elevations.
    #[test]
    fn a_point_is_decided_as_the_block_is() {
        let text = "[point]\ngamma = 0.8\nk_prime = 0\nk = 1\nmu = 0.5\n[random]\ngamma = { uniform = { from = 0.2, to = 4 } }\n\
                    k_prime = { uniform = { from = -3, to = 2 } }\nk = { uniform = { from = 0, to = 3 } }\nmu = { uniform = { from = 0, to = 2 } }\n";
        let problem = &ChanceProblem::of_file(&CaseFile::parse("case", text).unwrap()).unwrap()[0];
        let mut met = 0;
        draws(problem.laws(), 1, 50_000, |values| {
            let outcomes = problem.at(values);
            assert_eq!(outcomes, problem.mechanics(values).unwrap().outcomes(), "{values:?}");
            met |= outcomes;
        });
        assert_eq!(met >> NOT_UNIQUE & 1, 1);
        assert!(met.count_ones() >= 7, "{met:b}");
        assert_eq!(problem.at(&[0.8, 0.0, -1.0, 0.5]), 1 << NOT_A_BODY);
    }
}
