//! Random numbers of a case: the `[random]` table, and what comes of it.
//!
//! ```text
//! [random] ── read ──► Random ── Problem::of ──► Problem ── Probability::of ──► Probability ──► text, JSON
//!                       names and laws   │  laws and correlations as `standfast-probability` takes them,
//!                                        └─ and the modes as intervals of one of them
//! ```
//!
//! No uncertainty is applied unless it is written. For given other numbers each mode is an interval of the friction between curves
//! known in closed form, so that friction is not sampled; where it is certain, a number takes its place in which the loads are
//! linear.

mod answer;
mod departure;
mod document;
mod draws;
mod figures;
mod mechanics;
mod over;
mod point;
mod problem;
mod read;
mod resolve;
mod storm;
mod text;

pub use answer::{
    Chances, FirstDeparture, Happening, LifeChances, Method, Probability, ProbabilityError, Request,
};
pub use draws::{Drawn, Draws};
pub use figures::ProbabilityFigure;
pub use over::{Along, Fit, Fragility, Over};
pub use standfast_probability::sample::{Effort, Estimate};

pub use storm::{Exceeded, Pulse, Quantile, Rotating, Sliding, SlidingError, Storm, StormField};
pub(crate) use storm::{STORM, read as read_storm};

pub use problem::{Bias, Coordinate, Problem, Quantity};
pub(crate) use read::read;
pub use read::{Named, Random, RandomProblem, Rate};

/// The name of the table.
pub(crate) const RANDOM: &str = "random";
