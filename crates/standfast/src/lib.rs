//! A freestanding body stands on a rough base; a force comes. Does it stay at rest, slide, rock, or slide and rock?
//!
//! ```text
//!          2B
//!      ┌──────────┐
//!      │          │ ◄── F = k m g      k' H above C
//!  2H  │    C     │
//!      │          │        y ▲   ⟲ θ
//!      O──────────O'         └─► x
//!  ▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒▒   friction μ
//! ```
//!
//! | question | start at |
//! |---|---|
//! | Which mode begins, with what motion, and is the answer unique? | [`Point`] |
//! | At which force or friction does it change? Why this mode? | [`Point::margins`], [`Point::explain`] |
//! | What does the whole k–μ plane look like? | [`Diagram`], [`initiation::Chart`] |
//! | My body has metres and my force kilonewtons | [`Body`], [`HorizontalForce`] |
//! | Ten million points | [`batch`] |
//! | Water, waves, uplift, earthquakes, added mass: the whole situation | [`Situation`], [`wave`] |
//! | Safety factors and heel pressure | [`Actions`] |
//! | Any wrench, added mass, μ_s ≠ μ_k, eccentric bodies | [`contact`] |
//!
//! The symbols are those of the report this library implements, on vertical caisson breakwaters, after Shenton's
//! treatment of earthquakes (1996): γ = H/B, k = F/(m g), k' the height of the force above the centre of mass in H,
//! μ Coulomb friction. Numbers in parentheses are the report's equations. Modes are decided exactly for the f64
//! given; no decision has a tolerance.

mod approx;
pub mod batch;
mod body;
pub mod contact;
pub mod diagram;
mod error;
mod exact;
pub mod initiation;
mod load;
mod mode;
mod motion;
pub mod sign;
mod situation;
mod stability;
pub mod wave;

pub use body::{Body, StillWater};
pub use diagram::Diagram;
pub use error::InputError;
pub use initiation::{Point, classify};
pub use load::{HorizontalForce, Reduced};
pub use mode::{Corner, Mode, Modes, Slip};
pub use motion::Motion;
pub use situation::{Load, LoadKind, Situation, State, first_departure};
pub use stability::{Actions, HeelPressure, Stability};
