//! Strength of the base: when the ground under a body changes its verdict.
//!
//! ```text
//!        rigid              strength             ground             stiffness
//!      ┌───────┐            ┌───────┐           ┌───────┐           ┌───────┐
//!      │       │            │       │           │       │           │       │
//!      └───────┘            └───────┘           └───────┘           └───────┘
//!    ▒▒▒▒▒▒▒▒▒▒▒▒▒        ▒▒▲▲▒▒▒▒▒▒▒▒▒       ╲▒▒▒▒▒▒▒▒▒╱▒▒         ╪ ╪ ╪ ╪ ╪
//!      the corner         q_u, neutral         ╲_______╱          k_n, k_t
//!                            point                BF
//! ```
//!
//! | question | start at |
//! |---|---|
//! | Which mode begins on a base that crushes at q_u? The k–μ plane of it? | [`strength`] |
//! | Does the ground fail before the body slides or rocks? | [`bearing`] |
//! | How far does an elastic base let the body turn, and when does it topple? | [`elastic`] |
//! | When is a short peak force not a static one? | [`impact`] |
//! | What begins at which load factor and friction? | [`load_plane`] |
//! | What begins on any of these, for every friction, and where does rest end? | [`Base`] |
//!
//! Everything else of this library stands on rigid ground. No partial factor is applied here.

mod base;
pub mod bearing;
pub mod elastic;
pub mod impact;
pub mod load_plane;
mod roots;
pub mod strength;

pub use base::Base;
