//! A freestanding block on a rough base under loads in time: rest, slide, rock, slide-rock, impacts, flight, to the end.

mod decide;
mod error;
mod forcing;
mod history;
mod impact;
mod machine;
mod outcome;
mod problem;
mod roots;
mod series;

pub use error::{MotionError, Problematic};
pub use history::{History, Piece};
pub use machine::{Keep, simulate};
pub use outcome::{End, Event, Outcome, Position, Step, Why};
pub use problem::{Base, Impact, Initial, Load, Problem};
