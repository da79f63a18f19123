//! The one answer of the page: what the body does under all loads entered.
//!
//! In air that is the report's problem. With water or uplift it is the situation's, under the full load applied at once; where that is
//! a point of the report's plane, in effective coordinates, the report's inequalities decide it.

use standfast::initiation::{PointMargins, Step};
use standfast::loads::Reduced;
use standfast::relation::Relation;
use standfast::{Mode, Modes, Motion, Outcome, Situation};

use crate::field::sentence;
use crate::loads;
use crate::state::{GRAVITY, State};

/// The answer of a state.
#[derive(Debug)]
pub struct PageAnswer {
    /// The mode reported.
    pub mode: Mode,
    /// The other consistent modes.
    pub others: Modes,
    /// Accelerations in g, θ̈ in g/B, reactions in m g, ξ in B.
    pub motion: Motion,
    /// Motion in SI units, if the dimensions are within range.
    pub real: Option<Motion>,
    /// Against sliding and overturning; none where the loads lift the body.
    pub factors: Option<[f64; 2]>,
    /// The inequalities of the mode.
    pub relations: Vec<Relation>,
    /// The modes tried before, and why they fail.
    pub tried: Vec<Step>,
    /// The point of the report's plane, if the loads have one.
    pub point: Option<Reduced>,
    /// With water or uplift, all loads.
    pub full: Option<(Situation, Outcome)>,
}

impl PageAnswer {
    /// The answer of a state.
    ///
    /// # Errors
    /// A sentence that says that a dimension is out of range, or that water stands above the crest.
    pub fn of(state: &State) -> Result<PageAnswer, String> {
        if state.waters.are_none() { Ok(PageAnswer::in_air(state)) } else { PageAnswer::with_water(state) }
    }

    fn in_air(state: &State) -> PageAnswer {
        let reduced = state.reduced();
        let (point, motion) = (reduced.point, reduced.motion());
        let (relations, tried) = explained(&reduced);
        let scaled =
            |body: &standfast::Body| motion.scaled(GRAVITY, body.width() / 2.0, body.mass() * GRAVITY);
        PageAnswer {
            mode: reduced.mode(),
            others: reduced.others(),
            motion,
            real: state.real().map(|(body, _)| scaled(&body)),
            factors: Some([point.safety_against_sliding(), point.safety_against_overturning()]),
            relations,
            tried,
            point: Some(reduced),
            full: None,
        }
    }

    fn with_water(state: &State) -> Result<PageAnswer, String> {
        let said = |error: standfast::InputError| sentence(&error.to_string());
        let situation = loads::situation(state).map_err(said)?;
        let outcome = situation.outcome().map_err(said)?;
        let full = outcome.full;
        let none = || "No mode satisfies all laws under these loads.".to_owned();
        let (mode, real) = full.mode().zip(full.motion).ok_or_else(none)?;
        let (relations, tried) = match full.effective {
            Some(reduced) => explained(&reduced),
            None => {
                let solution = situation.solve(&full.wrench).map_err(said)?;
                (solution.explain(mode), Vec::new())
            }
        };
        let half_width = situation.body().width() / 2.0;
        let weight = situation.body().mass() * GRAVITY;
        Ok(PageAnswer {
            mode,
            others: full.others(),
            motion: real.scaled(1.0 / GRAVITY, 1.0 / half_width, 1.0 / weight),
            real: Some(real),
            factors: (!full.is_lifted())
                .then(|| [outcome.stability.sliding, outcome.stability.overturning()]),
            relations,
            tried,
            point: full.effective,
            full: Some((situation, outcome)),
        })
    }

    /// The changes of mode beside the point, if the loads have one.
    pub fn margins(&self) -> Option<PointMargins> {
        self.point.map(|reduced| reduced.point.margins())
    }
}

/// The inequalities of the mode, and the modes tried before it.
fn explained(reduced: &Reduced) -> (Vec<Relation>, Vec<Step>) {
    let mut steps = reduced.point.explain().steps;
    let relations = steps.pop().map_or(Vec::new(), |step| step.relations);
    (relations, steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wet(sea: f64, lee: f64, uplift: f64, state: State) -> State {
        State { waters: loads::Waters { sea, lee, uplift }, ..state }
    }

    #[test]
    fn water_and_uplift_are_in_the_answer() {
        let state = State { force: 0.5, ..State::default() };
        assert_eq!(PageAnswer::of(&state).unwrap().mode, Mode::Rest);
        let answer = PageAnswer::of(&wet(8.0, 8.0, 60e3, state)).unwrap();
        assert_eq!(answer.mode, Mode::SlideRockOLeft);
        // k_eff = F/(m g − ρ g 8 B_c − 60 kPa B_c/2) = 1854.09/(3708.18 − 1212.516 − 450).
        let k_eff = answer.point.unwrap().point.k();
        assert!((k_eff / (1854.09 / 2045.664) - 1.0).abs() < 1e-12, "{k_eff}");
    }

    #[test]
    fn the_motion_has_the_forces_and_accelerations_of_the_true_weight() {
        // At rest both reactions balance the loads: f_y = P, f_x = F.
        let state = wet(8.0, 8.0, 0.0, State { force: 0.1, elevation: -0.5, ..State::default() });
        let answer = PageAnswer::of(&state).unwrap();
        assert_eq!(answer.mode, Mode::Rest);
        let real = answer.real.unwrap();
        assert!((real.f_y / (378e3 * GRAVITY - 1030.0 * GRAVITY * 8.0 * 15.0) - 1.0).abs() < 1e-12);
        assert!((answer.motion.f_x - 0.1).abs() < 1e-12);
        // Sliding: ẍ = (μ P − F)/m.
        let state = State { friction: 0.0, ..state };
        let answer = PageAnswer::of(&state).unwrap();
        assert!((answer.real.unwrap().x_ddot + 0.1 * GRAVITY).abs() < 1e-12);
        assert!((answer.motion.x_ddot + 0.1).abs() < 1e-12);
    }

    #[test]
    fn a_body_that_is_lifted_or_under_water_has_no_point() {
        let lifted = PageAnswer::of(&wet(0.0, 0.0, 800e3, State { force: 0.0, ..State::default() })).unwrap();
        assert!(lifted.point.is_none() && lifted.full.unwrap().1.full.is_lifted());
        // Equal levels without a force: vertical loads only.
        let still = PageAnswer::of(&wet(5.0, 5.0, 0.0, State { force: 0.0, ..State::default() })).unwrap();
        assert!(still.point.is_none() && still.mode == Mode::Rest);
        assert!(!still.relations.is_empty() && still.relations.iter().all(|relation| relation.holds));
        let drowned = PageAnswer::of(&wet(40.0, 0.0, 0.0, State::default())).unwrap_err();
        assert!(drowned.starts_with("Water level is 40;"));
    }
}
