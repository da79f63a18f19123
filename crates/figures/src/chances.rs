//! Figures of probabilities: points with their intervals, what matters, lines with their intervals, and clouds of draws.
//!
//! Figures are given by numbers and words. Everything that has a name has it beside the plot or in a key below, so that
//! no label lies on another, whatever the numbers are.

mod cloud;
mod lines;
mod rows;
mod tornado;

pub use cloud::{ChanceCloud, CloudPanel, chance_cloud};
pub use lines::{ChanceLine, ChanceLines, ChanceMark, LineLook, chance_lines};
pub use rows::{ChanceGroup, ChanceRow, ChanceRows, chance_rows};
pub use tornado::{Importance, Tornado, chance_tornado};

use crate::Figure;
use crate::axes::{Axis, Look, Plot, Tick, room};
use crate::below::Words;
use crate::motion::SpectrumAxis;
use crate::scene::Scene;

/// A number with its interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chance {
    /// The number.
    pub value: f64,
    /// The interval's lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

/// Left and right edge of what stands above, beside and below plots.
const LEFT: f64 = 16.0;
const LOOK: Look = Look { tick: 0.8, drop: 18.0 };

/// Ticks below a plot, as many as an axis of this length has room for.
fn across_ticks(axis: &Axis, length: f64) -> Vec<Tick> {
    axis.ticks(room(length, 58.0, 9.0))
}

/// A plot of two quantities, with as many numbers as have room.
fn plot(quantities: [&SpectrumAxis<'_>; 2], (left, top): (f64, f64), size: (f64, f64)) -> Plot {
    let up = quantities[1].axis().ticks(room(size.1, 38.0, 8.0));
    let ticks = [across_ticks(&quantities[0].axis(), size.0), up];
    Plot::new(quantities, ticks, (left + 9.0, top), size)
}

/// Title and caption below, and the figure. `description` is what a reader is told who does not see it.
fn finished(
    scene: Scene,
    (title, caption): (&str, &str),
    (right, top): (f64, f64),
    description: &str,
) -> Figure {
    let description = format!("{description} {caption}");
    Words::verbatim(title, caption).figure(scene, (LEFT, right), top, 14.0, &description)
}
