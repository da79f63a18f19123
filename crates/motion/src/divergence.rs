//! How far two motions part whose bodies differ by almost nothing.
//!
//! ```text
//! S = sup over t of max(|Δθ|/α_c, |Δslide|/B) / ε
//! ```
//!
//! Δ is against the motion of the same body with μ_s, μ_k and d more by a relative ε = 1e-7, α_c the angle of balance, B half the base. Both
//! motions are followed as long as both go on; one that has come to rest stays where it is. Of inputs that are known to a relative σ, S σ
//! above 1 says that one motion does not decide what becomes of the body. S is local: a verdict that changes at one factor on the loads a
//! few per cent away does not show in it, and [`strength`](crate::strength) looks for these.

use crate::error::MotionError;
use crate::machine::{Keep, simulate};
use crate::outcome::{End, MotionOutcome};
use crate::problem::MotionProblem;

/// Relative change of friction and of the height of the centre of mass.
const CHANGE: f64 = 1e-7;

/// Divergence of a motion from one of almost the same body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Divergence {
    /// S: the largest difference over time, in α_c or in B, over the relative change of the inputs.
    pub value: f64,
    /// The moment at which it is so large, s.
    pub t: f64,
    /// The quantity that differs so much.
    pub of: Diverging,
}

/// Quantity in which two motions differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Diverging {
    /// The angle.
    Theta,
    /// The slide.
    Slide,
}

impl Diverging {
    /// The word in results.
    pub fn word(self) -> &'static str {
        match self {
            Diverging::Theta => "theta",
            Diverging::Slide => "slide",
        }
    }
}

impl Divergence {
    /// The divergence of the motion of a problem, which `outcome` is, with its steps.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn of(problem: &MotionProblem, outcome: &MotionOutcome) -> Result<Divergence, MotionError> {
        let mut changed = problem.clone();
        let block = &mut changed.block;
        for number in [&mut block.mu_s, &mut block.mu_k, &mut block.d] {
            *number *= 1.0 + CHANGE;
        }
        let other = simulate(&changed, Keep { steps: true })?;
        let block = &problem.block;
        let balance = (block.b1.min(block.b2) / block.d).atan();
        let half_width = 0.5 * (block.b1 + block.b2);
        let last = [outcome, &other].map(followed);
        let last = if last == [f64::INFINITY; 2] { f64::INFINITY } else { last[0].min(last[1]) };
        let mut found = Divergence { value: 0.0, t: 0.0, of: Diverging::Theta };
        let ends = |motion: &MotionOutcome| {
            let steps = motion.steps.iter().flat_map(|step| [step.t, step.t + step.duration]);
            steps.collect::<Vec<f64>>()
        };
        for t in ends(outcome).into_iter().chain(ends(&other)).filter(|t| *t <= last) {
            let (Some(one), Some(two)) = (outcome.at(t), other.at(t)) else { continue };
            let parts = [
                ((two.theta - one.theta).abs() / balance, Diverging::Theta),
                ((two.slide - one.slide).abs() / half_width, Diverging::Slide),
            ];
            for (value, of) in parts.map(|(size, of)| (size / CHANGE, of)) {
                if value > found.value {
                    found = Divergence { value, t, of };
                }
            }
        }
        Ok(found)
    }
}

/// Time up to which a motion is known: one that has come to rest stays there.
fn followed(outcome: &MotionOutcome) -> f64 {
    match (outcome.end, outcome.steps.last()) {
        (End::AtRest, _) => f64::INFINITY,
        (_, Some(step)) => step.t + step.duration,
        (_, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Initial;
    use standfast::contact::Block;
    use standfast::history::History;

    fn divergence(problem: &MotionProblem) -> Divergence {
        Divergence::of(problem, &simulate(problem, Keep { steps: true }).unwrap()).unwrap()
    }

    /// A block that is thrown along the base stops after v²/(2μg): a relative change of μ by ε takes ε of that off, and a little more at
    /// no time before.
    #[test]
    fn of_a_block_that_slides_to_its_stop() {
        let (v, μ) = (0.4, 0.3);
        let mut problem = MotionProblem::new(Block::uniform(0.2, μ), 1.0);
        problem.initial = Initial { vx: Some(v), ..Initial::default() };
        let found = divergence(&problem);
        let way = v * v / (2.0 * μ);
        assert!((found.value / way - 1.0).abs() < 1e-5, "{found:?} {way}");
        assert_eq!(found.of, Diverging::Slide);
        assert!(found.t <= v / μ * (1.0 + 1e-6));
    }

    /// What rests, rests whatever is changed a little.
    #[test]
    fn of_a_block_that_rests() {
        let mut problem = MotionProblem::new(Block::uniform(2.0, 0.6), 1.0);
        problem.base.horizontal = Some(History::half_sine(0.1, 2.0).unwrap());
        assert_eq!(divergence(&problem).value, 0.0);
    }

    /// A slender block let go almost upside down on its corner: its angle leaves that of balance as exp(p t), so what differs by ε at
    /// first has grown by that at the end.
    #[test]
    fn of_a_block_that_is_let_go_near_balance() {
        let problem = MotionProblem::new(Block::uniform(10.0, 5.0), 1.0);
        let balance = (1.0f64 / 10.0).atan();
        let value = |off: f64| {
            let mut problem = problem.clone();
            problem.initial.theta = (1.0 - off) * balance;
            divergence(&problem).value
        };
        // Nearer to balance it takes longer to fall back, and parts from its neighbour by more.
        let found = [0.1, 0.01, 0.001].map(value);
        assert!(found[0] < found[1] && found[1] < found[2] && found[2] > 100.0, "{found:?}");
    }
}
