//! Figures of probabilities: points with their intervals, what matters, lines with their intervals, and clouds of draws.
//!
//! Figures are given by numbers and words. Everything that has a name has it beside the plot or in a key below, so that
//! no label lies on another, whatever the numbers are.

mod cloud;
mod lines;
mod over;
mod rows;
mod tornado;

pub use cloud::{ChanceCloud, CloudPanel, chance_cloud};
pub use lines::{ChanceLine, ChanceLines, ChanceMark, LineLook, chance_lines};
pub(crate) use lines::{MARKS, marks};
pub use over::draws_over;
pub use rows::{ChanceGroup, ChanceRow, ChanceRows, chance_rows};
pub use tornado::{Importance, Tornado, chance_tornado};

use crate::Figure;
use crate::axes::LEFT;
use crate::below::Words;
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

/// Title and caption below, and the figure, which ends at `right`. `description` is what a reader is told who does not see it.
fn finished(
    scene: Scene,
    (title, caption): (&str, &str),
    (right, top): (f64, f64),
    description: &str,
) -> Figure {
    let description = format!("{description} {caption}");
    Words::verbatim(title, caption).figure(scene, (LEFT, right - LEFT), top, LEFT, &description)
}
