//! Outlines of characters. Two faces, upright and italic, parsed once from the embedded subsets.
//!
//! Units are thousandths of the type size, y up.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::LazyLock;

use ttf_parser::{Face as Parsed, OutlineBuilder};

/// A type face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Face {
    Upright,
    Italic,
}

/// A character's outline and measures.
#[derive(Debug, Default)]
pub(crate) struct Glyph {
    pub advance: f64,
    /// SVG path data; empty for a space.
    pub outline: String,
    /// Path data relative to the origin of the glyph, so that the glyphs of a line can be one path.
    pub relative: String,
    /// Lowest and highest y of the ink.
    pub bottom: f64,
    pub top: f64,
    /// Rightmost x of the ink, beyond `advance` for slanted letters.
    pub right: f64,
}

type Glyphs = BTreeMap<char, Glyph>;

/// The upright face as a TrueType font, for a page that sets its text in the figures' type.
pub static UPRIGHT_FONT: &[u8] = include_bytes!("../fonts/regular.ttf");
/// The italic face, likewise.
pub static ITALIC_FONT: &[u8] = include_bytes!("../fonts/italic.ttf");

static UPRIGHT: LazyLock<Glyphs> = LazyLock::new(|| read(UPRIGHT_FONT));
static ITALIC: LazyLock<Glyphs> = LazyLock::new(|| read(ITALIC_FONT));

impl Face {
    /// The glyph of a character: upright of a letter that the italic face lacks, and a question mark of one that both lack.
    pub(crate) fn glyph(self, character: char) -> &'static Glyph {
        let glyphs = match self {
            Face::Upright => &*UPRIGHT,
            Face::Italic => &*ITALIC,
        };
        let found = glyphs.get(&character).or_else(|| UPRIGHT.get(&character));
        found.unwrap_or_else(|| &UPRIGHT[&'?'])
    }

    /// The SVG id of a character. It names the outline, not the figure, so that several figures in one page agree.
    pub(crate) fn id(self, character: char) -> String {
        let face = if self == Face::Upright { 'r' } else { 'i' };
        format!("sf-{face}{:x}", character as u32)
    }
}

fn read(bytes: &[u8]) -> Glyphs {
    let font = Parsed::parse(bytes, 0).expect("the embedded font is a TrueType font");
    let mut characters = Vec::new();
    for table in font.tables().cmap.iter().flat_map(|cmap| cmap.subtables) {
        table.codepoints(|code| characters.extend(char::from_u32(code)));
    }
    let mut glyphs = Glyphs::new();
    for character in characters {
        let Some(id) = font.glyph_index(character) else { continue };
        let mut pen = Pen::default();
        let ink = font.outline_glyph(id, &mut pen);
        glyphs.insert(
            character,
            Glyph {
                advance: f64::from(font.glyph_hor_advance(id).unwrap_or(0)),
                outline: pen.absolute,
                relative: pen.relative,
                bottom: ink.map_or(0.0, |ink| f64::from(ink.y_min)),
                top: ink.map_or(0.0, |ink| f64::from(ink.y_max)),
                right: ink.map_or(0.0, |ink| f64::from(ink.x_max)),
            },
        );
    }
    glyphs
}

/// Path data under construction, in absolute and in relative coordinates.
#[derive(Default)]
struct Pen {
    absolute: String,
    relative: String,
    at: (f32, f32),
    start: (f32, f32),
}

impl Pen {
    fn put(&mut self, command: char, numbers: &[f32]) {
        self.absolute.push(command);
        self.relative.push(command.to_ascii_lowercase());
        for (i, pair) in numbers.chunks(2).enumerate() {
            // A quadratic point half way between two others may fall on half a unit; more is not in the font.
            let whole = |number: f32| (number * 2.0).round() / 2.0;
            let (x, y) = (whole(pair[0]), whole(pair[1]));
            write(&mut self.absolute, i > 0, x, y);
            write(&mut self.relative, i > 0, x - self.at.0, y - self.at.1);
            if 2 * (i + 1) == numbers.len() {
                self.at = (x, y);
            }
        }
        if command == 'M' {
            self.start = self.at;
        }
    }
}

/// Appends a pair of numbers; a minus sign parts them as well as a space.
fn write(path: &mut String, parted: bool, x: f32, y: f32) {
    let separator = |parted: bool, number: f32| if parted && number >= 0.0 { " " } else { "" };
    // Adding zero turns −0 into 0.
    let (x, y) = (x + 0.0, y + 0.0);
    write!(path, "{}{x}{}{y}", separator(parted, x), separator(true, y)).expect("writing to a string");
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.put('M', &[x, y]);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.put('L', &[x, y]);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.put('Q', &[x1, y1, x, y]);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.put('C', &[x1, y1, x2, y2, x, y]);
    }
    fn close(&mut self) {
        self.absolute.push('Z');
        self.relative.push('z');
        self.at = self.start;
    }
}
