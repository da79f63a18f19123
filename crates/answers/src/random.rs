//! Random numbers of a case: the `[random]` table, and what comes of it.
//!
//! ```text
//! [random] ── read ──► Random ── ChanceProblem::of ──► ChanceProblem ── Probability::of ──► Probability ──► text, JSON
//!                       names and laws   │  laws and correlations as `standfast-probability` takes them,
//!                                        └─ and the modes as intervals of one of them
//! ```
//!
//! No uncertainty is applied unless it is written. For given other numbers each mode is an interval of the friction between curves
//! known in closed form, so that friction is not sampled; where it is certain, a number takes its place in which the loads are
//! linear.

mod answer;
mod base;
mod chances;
mod criterion;
mod departure;
mod design_values;
mod draws;
mod error;
mod fragility;
mod intervals;
mod joined;
mod lines;
mod mechanics;
mod outcome;
mod overturn;
mod own;
mod plan;
mod point;
mod problem;
mod quantity;
mod resolve;
mod row;
mod spread;
mod stack;
mod storm;
mod subject;
mod template;

pub use answer::{
    ChanceRequest, Chances, FirstDeparture, FirstJoint, Happening, LifeChances, MethodAsked, Probability,
    RandomNumber, Stood,
};
pub(crate) use criterion::asked_of_file;
pub use criterion::{AskedChances, ChanceCriterion};
pub use design_values::{DesignValue, DesignValues};
pub use draws::{Draw, DrawInPlane, Draws, WeighedDraws};
pub use error::ProbabilityError;
pub use fragility::{Fit, Fragility, FragilityPoint, ValueRange};
pub use joined::JoinedChance;
pub use overturn::{Overturning, PeakChances};
pub use row::RowChances;
pub use standfast_probability::method::Method;
pub use standfast_probability::sample::{Effort, Estimate};
pub use standfast_probability::slopes::Slopes;

pub use storm::{
    Exceedance, FollowedWaves, Pulse, Quantile, RotatingWaves, Sliding, SlidingError, Storm, StormField,
};

pub use spread::{Spread, spreads};
pub use template::{ProposedLaw, template};

pub use own::{OwnNumbers, own_laws};
pub use problem::ChanceProblem;
pub use quantity::{Bias, Coordinate, Quantity};
pub use standfast_inputs::random::{Lifetime, RANDOM, Random, RandomEntry, RandomProblem, Rate};
