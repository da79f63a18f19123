//! A freestanding block on a rough base under loads in time: rest, slide, rock, slide-rock, impacts, flight, to the end.

mod decide;
mod error;
mod forcing;
mod history;
mod impact;
mod machine;
mod outcome;
mod problem;
pub mod record;
mod roots;
mod series;

pub use error::{MotionError, Problematic};
pub use history::{History, Piece};
pub use machine::{Keep, simulate};
pub use outcome::{End, Event, Outcome, Position, Step, Why};
pub use problem::{Base, Impact, Initial, Load, Problem};

/// How much slide, in B, and the largest |θ| change with friction and the height of C: the larger of their changes over a relative change
/// of 1e-7 of μ_s, μ_k and d.
///
/// # Errors
/// As [`simulate`].
pub fn sensitivity(problem: &Problem) -> Result<f64, MotionError> {
    const CHANGE: f64 = 1e-7;
    let one = simulate(problem, Keep::default())?;
    let mut changed = problem.clone();
    let block = &mut changed.block;
    for number in [&mut block.mu_s, &mut block.mu_k, &mut block.d] {
        *number *= 1.0 + CHANGE;
    }
    let length = block.b1.max(block.b2);
    let two = simulate(&changed, Keep::default())?;
    let slide = (two.slide - one.slide).abs() / length;
    let turn = (two.max_theta - one.max_theta).abs();
    Ok(slide.max(turn) / CHANGE)
}
