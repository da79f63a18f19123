//! How likely each mode is: bars, what matters, lines with their intervals, and clouds of draws.
//!
//! What is drawn is given by numbers and words. Everything that has a name has it beside the plot or in a key below, so that no label
//! lies on another, whatever the numbers are.

mod bars;
mod cloud;
mod lines;
mod plot;
mod tornado;

use standfast::Mode;

pub use bars::{ChanceBar, ChanceBars, ChanceGroup, chance_bars};
pub use cloud::{ChanceCloud, CloudPanel, chance_cloud};
pub use lines::{ChanceLine, ChanceLines, ChanceMark, LineLook, chance_lines};
pub use tornado::{Importance, Tornado, chance_tornado};

use crate::Figure;
use crate::caption::{SIZE, SMALL, shortened};
use crate::margins;
use crate::palette::{FAINT, INK, symbol, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

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

fn rectangle(rect: &Rect) -> Path {
    let Rect { x0, y0, x1, y1 } = *rect;
    let mut path = Path::through(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)]);
    path.close();
    path
}

/// The modes with their tints and words, in rows between two edges; returns the y below.
fn key(scene: &mut Scene, modes: &[Mode], edges: (f64, f64), top: f64) -> f64 {
    let (mut x, mut y) = (edges.0, top);
    for &mode in modes {
        let [name, words] =
            [Text::new(symbol(mode), SMALL), Text::verbatim(&mode.words().replace('\'', "′"), SMALL)];
        let width = 16.0 + name.width + 6.0 + words.width;
        if x > edges.0 && x + width > edges.1 {
            (x, y) = (edges.0, y + 17.0);
        }
        let patch = Rect { x0: x, y0: y, x1: x + 12.0, y1: y + 12.0 };
        scene.fill(&rectangle(&patch), tint(mode));
        scene.stroke(&rectangle(&patch), Pen::solid(FAINT, 0.6));
        scene.text(&name, x + 16.0, y + 10.5, INK);
        scene.text(&words, x + 22.0 + name.width, y + 10.5, INK);
        x += width + 16.0;
    }
    if modes.is_empty() { y } else { y + 17.0 }
}

/// Title and caption below, and the figure. `description` is what a reader is told who does not see it.
fn finished(
    mut scene: Scene,
    (title, caption): (&str, &str),
    (right, top): (f64, f64),
    description: &str,
) -> Figure {
    let words = |text: &str, size: f64| -> Vec<Text> {
        text.split_whitespace().map(|word| Text::verbatim(&shortened(word), size)).collect()
    };
    let edges = (LEFT, right);
    let below = margins::paragraph(&mut scene, &words(title, SIZE), edges, top, SIZE);
    let below = margins::paragraph(&mut scene, &words(caption, SMALL), edges, below + 4.0, SMALL);
    let size = ((right + 14.0).ceil(), (below + 10.0).ceil());
    let (svg, labels) = scene.finish(size.0, size.1, title, &format!("{description} {caption}"));
    Figure { svg, title: title.to_owned(), caption: caption.to_owned(), labels, size }
}
