//! Parts below a plot: the key of modes, title and caption.

use standfast::Mode;

use crate::caption::{SIZE, SMALL, shortened};
use crate::margins;
use crate::palette::{FAINT, INK, symbol, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

/// The modes with their tints and words, in rows between two edges; returns the y below.
pub(crate) fn modes_key(scene: &mut Scene, modes: &[Mode], edges: (f64, f64), top: f64) -> f64 {
    let (mut x, mut y) = (edges.0, top);
    for &mode in modes {
        let [name, words] =
            [Text::new(symbol(mode), SMALL), Text::verbatim(&mode.words().replace('\'', "′"), SMALL)];
        let width = 16.0 + name.width + 6.0 + words.width;
        if x > edges.0 && x + width > edges.1 {
            (x, y) = (edges.0, y + 17.0);
        }
        let patch = Path::rectangle(&Rect { x0: x, y0: y, x1: x + 12.0, y1: y + 12.0 });
        scene.fill(&patch, tint(mode));
        scene.stroke(&patch, Pen::solid(FAINT, 0.5));
        scene.text(&name, x + 16.0, y + 10.5, INK);
        scene.text(&words, x + 22.0 + name.width, y + 10.5, INK);
        x += width + 16.0;
    }
    if modes.is_empty() { y } else { y + 17.0 }
}

/// Title and caption, in lines between two edges; returns the y below.
pub(crate) fn title_and_caption(
    scene: &mut Scene,
    (title, caption): (&str, &str),
    edges: (f64, f64),
    top: f64,
) -> f64 {
    let words = |text: &str, size: f64| -> Vec<Text> {
        text.split_whitespace().map(|word| Text::verbatim(&shortened(word), size)).collect()
    };
    let below = margins::paragraph(scene, &words(title, SIZE), edges, top, SIZE);
    margins::paragraph(scene, &words(caption, SMALL), edges, below + 4.0, SMALL)
}
