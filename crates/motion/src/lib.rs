//! A freestanding block on a rough base under loads in time: rest, slide, rock, slide-rock, impacts, flight, to the end.
//!
//! State: position and velocity of the centre of mass C relative to the ground, θ and θ̇; which corners touch; stick or slip. A corner r
//! (−b₁ at O, b₂ at O') is at a lever c(θ) and a depth h(θ) of C,
//!
//! ```text
//! c = r cosθ + d sinθ      h = d cosθ − r sinθ      gap y − h      u_x = ẋ + hθ̇      u_y = ẏ + cθ̇
//! ```
//!
//! and where it touches, with N and T of the base on the body, X, P, M as in the [contact problem](standfast::contact):
//!
//! ```text
//! m_x ẍ = X + T      m_y ÿ = N − P      ρ² θ̈ = cN + hT + M
//! ```
//!
//! with y = h(θ), and ẋ = −hθ̇ where it sticks or T = −sμ_kN where it slips. What ends each state, and which follows:
//!
//! | state | ends where |
//! |---|---|
//! | rest | μ_sP = \|X\|; the reaction is at a corner; P = 0 |
//! | slide | slip ends; the reaction is at a corner; P = 0 |
//! | rock | θ = 0, an impact; N = 0; μ_sN = \|T\| |
//! | slide-rock | θ = 0; N = 0; slip ends; no slip can go on (Painlevé), and the corner grips |
//! | flight | a corner meets the base |
//!
//! The state that follows is one whose conditions hold just after, by the first of their derivatives that is not zero; if several do, the
//! first of rest, slide, slide-rock, rock, flight, and [`Event::consistent`] has them all.
//!
//! Lengths, masses and times are in any units that go together; the mass is 1.

#![allow(clippy::needless_range_loop, reason = "a coefficient is called by its power")]

mod decide;
pub mod divergence;
mod error;
mod forcing;
pub mod ground;
mod impact;
mod machine;
mod moment;
mod outcome;
mod problem;
mod rebound;
pub mod record;
mod roots;
mod series;
mod situated;
pub mod spectrum;
pub mod strength;

pub use error::MotionError;
#[doc(hidden)]
pub use machine::simulate_at_length;
pub use machine::{Keep, simulate};
pub use moment::Moment;
pub use outcome::{End, Event, MotionOutcome, MotionStep, Position, Why};
pub use problem::{ActingLoad, BaseMotion, Going, Impact, Initial, LoadInTime, MotionProblem};

pub use situated::{is_own_weight, shaken_water};
pub use standfast::history::{History, HistoryError, HistoryTimes, Piece};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
