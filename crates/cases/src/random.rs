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

mod along;
mod answer;
mod asked;
mod base;
mod chances;
mod criterion;
mod departure;
mod document;
mod draws;
mod error;
mod figures;
mod joined;
mod mechanics;
mod outcome;
mod over;
mod overturn;
mod point;
mod problem;
mod quantity;
mod resolve;
mod storm;
mod template;
mod text;

pub use answer::{
    Chances, FirstDeparture, Happening, LifeChances, Method, MethodAsked, Probability, RandomNumber, Request,
};
pub use criterion::ChanceCriterion;
pub(crate) use criterion::not_rest;
pub use draws::{Drawn, Draws, WeighedDraws};
pub use error::ProbabilityError;
pub use figures::ProbabilityFigure;
pub use joined::Joined;
pub use over::{Along, Fit, Fragility, Over};
pub use overturn::{AtPeak, Overturning};
pub use standfast_probability::sample::{Effort, Estimate};

pub use storm::{Exceeded, Followed, Pulse, Quantile, Rotating, Sliding, SlidingError, Storm, StormField};

pub use template::template;

pub use problem::Problem;
pub use quantity::{Bias, Coordinate, Quantity};
use standfast_inputs::random as read;
pub use standfast_inputs::random::{Named, RANDOM, Random, RandomProblem, Rate};
