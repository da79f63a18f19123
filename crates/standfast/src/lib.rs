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
//! | How far is each inequality from failing, as a limit state? | [`Point::limit_states`] |
//! | What does the whole k–μ plane look like? | [`Diagram`], [`initiation::Chart`] |
//! | My body has metres and my force kilonewtons | [`Body`], [`loads::HorizontalForce`] |
//! | Ten million points | [`batch`] |
//! | Water, waves, uplift, earthquakes, added mass: the whole situation | [`Situation`], [`loads`], [`wave`] |
//! | Safety factors and bearing pressure | [`Stability`] |
//! | A base that crushes, ground that fails, an elastic base under short loads | [`ground`] |
//! | Any wrench, added mass, μ_s ≠ μ_k, eccentric bodies | [`contact`] |
//! | Forces of any horizontal direction, on a polygon, feet or a disc | [`footprint`] |
//! | Bodies on bodies: which joint moves first, all combinations of modes | [`contact::stack`] |
//!
//! The symbols are those of the report this library implements, on vertical caisson breakwaters, after Shenton's
//! treatment of earthquakes (1996): γ = H/B, k = F/(m g), k' the height of the force above the centre of mass in H,
//! μ Coulomb friction. Numbers in parentheses are the report's equations. Modes are decided exactly for the f64
//! given; no decision has a tolerance.

mod approx;
mod ball;
pub mod batch;
mod body;
#[cfg(test)]
mod calculated_twice;
pub mod contact;
mod departure;
pub mod diagram;
mod error;
mod exact;
pub mod footprint;
pub mod ground;
pub mod history;
pub mod initiation;
pub mod loads;
mod mode;
mod motion;
mod neighbour;
pub mod number;
pub mod order;
pub mod plan;
mod polynomial;
mod quantity;
pub mod region;
pub mod relation;
pub mod section;
pub mod sign;
mod situation;
mod span;
mod stability;
mod stage;
mod twofold;
mod verdict;
mod wrench;

pub use ball::{Ball, COMPUTED, Scalar};
pub use body::{BaseEdges, Body};
pub use departure::{Departure, DepartureSpan};
pub use diagram::Diagram;
pub use error::InputError;
pub use history::{History, HistoryError, HistoryTimes};
pub use initiation::{Point, classify};
pub use loads::wave;
pub use mode::{Corner, Mode, Modes, ParseModeError, Slip};
pub use motion::{CornerAcceleration, Motion};
pub use plan::Plan;
pub use quantity::{Expected, Quantity};
pub use section::Section;
pub use situation::{
    BaseOpening, Boundary, Held, InHalfWidths, JointAnswer, JointDeparture, Jointed, OnJoint, OpeningRule,
    Outcome, PlanBase, PlanOutcome, Response, Situation,
};
pub use span::Span;
pub use stability::{Bearing, ClassicalActions, GrossOverturning, Margins, Stability};
pub use stage::Stage;
pub use verdict::{Decision, Verdict};
pub use wrench::Wrench;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
