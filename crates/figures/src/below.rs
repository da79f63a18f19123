//! Parts below a plot: a key, and the words that end a figure.

use standfast::{Mode, Verdict};

use crate::Figure;
use crate::caption::{READABLE, SIZE, SMALL, shortened};
use crate::margins;
use crate::palette::{FAINT, INK, symbol};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

/// Size of a patch: wide enough to show stripes.
const PATCH: (f64, f64) = (18.0, 12.0);

/// Height of a row.
const ROW: f64 = 17.0;
/// What the longest words of a mode take, with patch and symbol.
const ROOM: f64 = 450.0;

/// A key in rows between two edges.
pub(crate) struct Key {
    pub edges: (f64, f64),
    x: f64,
    pub y: f64,
}

impl Key {
    pub(crate) fn new(edges: (f64, f64), top: f64) -> Key {
        Key { edges, x: edges.0, y: top }
    }

    /// Place of an entry, on a new row where it does not fit; the next one is `apart` from it.
    pub(crate) fn entry(&mut self, width: f64, apart: f64) -> (f64, f64) {
        if self.x > self.edges.0 && self.x + width > self.edges.1 {
            (self.x, self.y) = (self.edges.0, self.y + ROW);
        }
        let place = (self.x, self.y);
        self.x += width + apart;
        place
    }

    /// A patch, painted as it is in the plot, and what it is.
    pub(crate) fn patch(&mut self, scene: &mut Scene, paint: impl FnOnce(&mut Scene, &Rect), words: &[Text]) {
        let gaps = 6.0 * (words.len() - 1) as f64;
        let width = PATCH.0 + 4.0 + words.iter().map(|text| text.width).sum::<f64>() + gaps;
        let (mut x, y) = self.entry(width, 16.0);
        let patch = Rect { x0: x, y0: y, x1: x + PATCH.0, y1: y + PATCH.1 };
        paint(scene, &patch);
        scene.stroke(&Path::rectangle(&patch), Pen::solid(FAINT, 0.5));
        x += PATCH.0 + 4.0;
        for text in words {
            scene.text(text, x, y + 10.5, INK);
            x += text.width + 6.0;
        }
    }

    /// The y below its rows.
    pub(crate) fn below(&self) -> f64 {
        if self.x > self.edges.0 { self.y + ROW } else { self.y }
    }
}

/// The modes with their tints and words, in rows between two edges; returns the y below.
pub(crate) fn modes_key(scene: &mut Scene, modes: &[Mode], edges: (f64, f64), top: f64) -> f64 {
    keyed(scene, modes, edges, top, (SMALL, true))
}

/// The same on a screen, without words where they would take much room.
pub(crate) fn modes_key_within(scene: &mut Scene, modes: &[Mode], edges: (f64, f64), top: f64) -> f64 {
    /// Rows that words may take.
    const ROWS: f64 = 2.0;
    let below = keyed(&mut Scene::default(), modes, edges, top, (READABLE, true));
    let has_room = below - top <= ROWS * ROW && edges.1 - edges.0 >= ROOM;
    keyed(scene, modes, edges, top, (READABLE, has_room))
}

fn keyed(
    scene: &mut Scene,
    modes: &[Mode],
    edges: (f64, f64),
    top: f64,
    (size, with_words): (f64, bool),
) -> f64 {
    let mut key = Key::new(edges, top);
    for &mode in modes {
        let words = Text::verbatim(&mode.words().replace('\'', "′"), size);
        let paint = |scene: &mut Scene, patch: &Rect| scene.area(&patch.corners(), Verdict::Begins(mode));
        let all = [Text::new(symbol(mode), size), words];
        key.patch(scene, paint, if with_words { &all } else { &all[..1] });
    }
    key.below()
}

/// Words of a figure: those on the page, and the same as plain characters.
pub(crate) struct Words {
    pub heading: Vec<Text>,
    pub details: Vec<Text>,
    /// Between the heading and the details.
    pub gap: f64,
    pub title: String,
    pub caption: String,
}

impl Words {
    pub(crate) fn new(heading: Vec<Text>, details: Vec<Text>) -> Words {
        let plain =
            |words: &[Text]| words.iter().map(|word| word.plain.as_str()).collect::<Vec<_>>().join(" ");
        Words { title: plain(&heading), caption: plain(&details), heading, details, gap: 5.0 }
    }

    /// A title and a caption that are no markup.
    pub(crate) fn verbatim(title: &str, caption: &str) -> Words {
        Words { gap: 4.0, ..Words::new(verbatim(title, SIZE), verbatim(caption, SMALL)) }
    }

    /// The figure, with the words in lines between two edges from `top` on, and so much of the page `beyond` the right edge. `description`
    /// is what a reader is told who does not see it.
    pub(crate) fn figure(
        self,
        mut scene: Scene,
        edges: (f64, f64),
        top: f64,
        beyond: f64,
        description: &str,
    ) -> Figure {
        let below = margins::paragraph(&mut scene, &self.heading, edges, top, SIZE);
        let below = margins::paragraph(&mut scene, &self.details, edges, below + self.gap, SMALL);
        let size = ((edges.1 + beyond).ceil(), (below + 10.0).ceil());
        let (svg, labels) = scene.finish(size.0, size.1, &self.title, description);
        Figure { svg, title: self.title, caption: self.caption, labels, size }
    }
}

/// Text that is no markup, in words that fit a line; powers of ten and symbols of modes are set as they are elsewhere.
pub(crate) fn verbatim(text: &str, size: f64) -> Vec<Text> {
    text.split_whitespace().map(|word| set(word, size)).collect()
}

fn set(word: &str, size: f64) -> Text {
    let is_around = |letter: char| "()[]«»,.;:".contains(letter);
    let inside = word.trim_matches(is_around);
    let Some(markup) = power(inside).or_else(|| mode_of(inside).map(|mode| symbol(mode).to_owned())) else {
        return Text::verbatim(&shortened(word), size);
    };
    let (before, after) = word.split_once(inside).unwrap_or_default();
    Text::inline(&format!("{before}{markup}{after}"), size)
}

/// A number such as `4.2e-14` as a power of ten.
fn power(word: &str) -> Option<String> {
    let (mantissa, exponent) = word.split_once('e')?;
    let is_number = mantissa.parse::<f64>().is_ok() && exponent.parse::<i32>().is_ok();
    is_number.then(|| format!("${mantissa} × 10^{{{}}}$", exponent.trim_start_matches('+')).replace('-', "−"))
}

/// The mode with this symbol, in the characters of a keyboard or with a prime and a minus.
fn mode_of(word: &str) -> Option<Mode> {
    let typed = word.replace('′', "'").replace('−', "-");
    Mode::ALL.into_iter().find(|mode| mode.symbol() == typed)
}
