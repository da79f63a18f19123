//! Lines of text and mathematics. A small markup becomes a measured box of glyphs and rules.
//!
//! | markup | result |
//! |---|---|
//! | `Rest region, $k ≤ k_A$` | upright text; mathematics between dollars |
//! | `k_A`, `k_{B′}`, `γ^2` | subscript, superscript |
//! | `\frac{b}{|a|}` | a built fraction |
//! | `\ddot{x}` | two dots above |
//! | `\up{RO}` | upright inside mathematics |
//!
//! In mathematics Latin and Greek letters are italic, the rest upright; relations and binary signs get their spaces,
//! and spaces in the source mean nothing.
//! Primes are ′ and minus signs −, never ' and -.

use crate::font::Face;

/// Size below which no subscript is set, if the letters it hangs on are larger: on a page as wide as a sheet's text it is six points.
const LEAST: f64 = 8.6;

/// Glyphs that share a face, a size and a baseline.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    pub face: Face,
    pub size: f64,
    /// Offset of the baseline from that of the line, downwards.
    pub drop: f64,
    /// Characters with their x.
    pub glyphs: Vec<(char, f64)>,
}

/// A horizontal bar: of a fraction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bar {
    pub x: f64,
    pub drop: f64,
    pub width: f64,
    pub thickness: f64,
}

/// A set line: its ink relative to the left end of the baseline, y down.
#[derive(Debug, Clone, Default)]
pub(crate) struct Text {
    pub width: f64,
    /// Extent of the ink above the baseline.
    pub ascent: f64,
    /// Extent of the ink below the baseline.
    pub descent: f64,
    pub runs: Vec<Run>,
    pub bars: Vec<Bar>,
    /// Text in plain characters.
    pub plain: String,
    /// True if fractions take a solidus instead of a bar, to keep the lines of a paragraph apart.
    inline: bool,
}

/// Kind of the item before, which decides the space that follows.
#[derive(Clone, Copy, PartialEq)]
enum Neighbour {
    Nothing,
    Ordinary,
    Operator,
}

impl Text {
    /// Sets `markup` at a type size.
    pub(crate) fn new(markup: &str, size: f64) -> Text {
        Text::default().set(markup, size)
    }

    /// Sets `markup` for a line among others: fractions take a solidus.
    pub(crate) fn inline(markup: &str, size: f64) -> Text {
        Text { inline: true, ..Text::default() }.set(markup, size)
    }

    fn set(mut self, markup: &str, size: f64) -> Text {
        let text = &mut self;
        for (i, part) in markup.split('$').enumerate() {
            if i % 2 == 0 {
                text.words(part, size);
            } else {
                text.mathematics(part, size, 0.0, true);
            }
        }
        self
    }

    /// Sets characters as they are, upright, with no markup.
    pub(crate) fn verbatim(characters: &str, size: f64) -> Text {
        let mut text = Text::default();
        text.words(characters, size);
        text
    }

    /// Adds a word at `x`, behind a space.
    pub(crate) fn push(&mut self, word: &Text, x: f64) {
        if !self.plain.is_empty() {
            self.plain.push(' ');
        }
        self.plain.push_str(&word.plain);
        self.append(word.clone(), x, 0.0);
        self.width = x + word.width;
    }

    /// The height of the ink.
    pub(crate) fn height(&self) -> f64 {
        self.ascent + self.descent
    }

    fn words(&mut self, characters: &str, size: f64) {
        for character in characters.chars().map(|c| if c.is_control() { ' ' } else { c }) {
            self.glyph(Face::Upright, character, size, 0.0);
            self.plain.push(character);
        }
    }

    fn glyph(&mut self, face: Face, character: char, size: f64, drop: f64) {
        let glyph = face.glyph(character);
        let scale = size / 1000.0;
        let x = self.width;
        self.width += glyph.advance * scale;
        if glyph.outline.is_empty() {
            return;
        }
        self.ascent = self.ascent.max(glyph.top * scale - drop);
        self.descent = self.descent.max(drop - glyph.bottom * scale);
        match self.runs.last_mut() {
            Some(run) if run.face == face && run.size == size && run.drop == drop => {
                run.glyphs.push((character, x))
            }
            _ => self.runs.push(Run { face, size, drop, glyphs: vec![(character, x)] }),
        }
    }

    /// Appends mathematics; `spaced` is false in sub- and superscripts.
    fn mathematics(&mut self, source: &str, size: f64, drop: f64, spaced: bool) {
        let mut before = Neighbour::Nothing;
        let mut previous = None;
        let mut in_bars = false;
        let mut rest = source;
        while let Some(character) = rest.chars().next() {
            let tail = &rest[character.len_utf8()..];
            match character {
                '_' | '^' => {
                    let (argument, after) = argument(tail);
                    let (shift, mark) = match (character, argument) {
                        // A sign alone hangs beside the foot of the letter, or it reads as an underscore.
                        ('_', "−" | "+") => (0.12, "_"),
                        ('_', _) => (0.2, "_"),
                        _ => (-0.38, "^"),
                    };
                    if character == '_' && previous == Some('′') {
                        // Under the prime rather than behind it.
                        self.width -= 0.55 * Face::Upright.glyph('′').advance * size / 1000.0;
                    }
                    self.plain.push_str(&plain_script(mark, argument));
                    let plain = self.plain.len();
                    self.mathematics(
                        argument,
                        (0.72 * size).max(LEAST).min(size),
                        drop + shift * size,
                        false,
                    );
                    self.plain.truncate(plain);
                    rest = after;
                    before = Neighbour::Ordinary;
                }
                '\\' => {
                    rest = self.command(tail, size, drop);
                    before = Neighbour::Ordinary;
                }
                ' ' => rest = tail,
                '|' => {
                    in_bars = !in_bars;
                    before = self.bar(in_bars, before, size, drop);
                    rest = tail;
                }
                _ => {
                    before = self.character(character, before, size, drop, spaced);
                    rest = tail;
                }
            }
            previous = Some(character);
        }
    }

    /// A bar of an absolute value, kept off its neighbours by thin spaces, or |k′| would read as letters.
    fn bar(&mut self, opens: bool, before: Neighbour, size: f64, drop: f64) -> Neighbour {
        const THIN: f64 = 0.07;
        let behind_letter = !opens || before == Neighbour::Ordinary;
        self.width += if behind_letter { THIN * size } else { 0.0 };
        self.plain.push('|');
        self.glyph(Face::Upright, '|', size, drop);
        self.width += THIN * size;
        if opens { Neighbour::Nothing } else { Neighbour::Ordinary }
    }

    fn character(
        &mut self,
        character: char,
        before: Neighbour,
        size: f64,
        drop: f64,
        spaced: bool,
    ) -> Neighbour {
        let face = if character.is_alphabetic() && character != 'Δ' { Face::Italic } else { Face::Upright };
        let (space, after) = match character {
            '=' | '<' | '>' | '≤' | '≥' => (0.26, Neighbour::Operator),
            '+' | '−' | '×' if before == Neighbour::Ordinary => (0.16, Neighbour::Operator),
            '(' | '/' | ',' | '+' | '−' => (0.0, Neighbour::Nothing),
            _ => (0.0, Neighbour::Ordinary),
        };
        let space = if spaced { space * size } else { 0.0 };
        self.width += space;
        if space > 0.0 {
            self.plain.push(' ');
        }
        self.plain.push(character);
        self.glyph(face, character, size, drop);
        if face == Face::Italic {
            // A slanted letter leans into what follows.
            let glyph = face.glyph(character);
            self.width += (glyph.right - glyph.advance).max(0.0) * size / 1000.0;
        }
        self.width += space;
        if space > 0.0 {
            self.plain.push(' ');
        }
        if character == ',' && spaced {
            self.width += 0.2 * size;
            self.plain.push(' ');
        }
        after
    }

    /// A backslash command; returns what follows it.
    fn command<'a>(&mut self, source: &'a str, size: f64, drop: f64) -> &'a str {
        let (name, rest) = source.split_at(source.find('{').unwrap_or(source.len()));
        let (first, rest) = argument(rest);
        match name {
            "frac" => {
                let (second, rest) = argument(rest);
                self.fraction(first, second, size, drop);
                return rest;
            }
            "ddot" => {
                let start = self.width;
                self.mathematics(first, size, drop, true);
                // Over the middle of an x-height letter; a tall letter such as θ lifts the dots by its own height.
                let tall = first.chars().next().map_or(0.0, |c| Face::Italic.glyph(c).top) > 600.0;
                let lift = size * if tall { 0.2 } else { 0.0 };
                let dots = Face::Upright.glyph('¨').advance * size / 1000.0;
                let end = self.width;
                self.width = (start + end - dots) / 2.0 + 0.05 * size;
                self.glyph(Face::Upright, '¨', size, drop - lift);
                self.width = end;
                self.plain.push('\u{308}');
            }
            _ => {
                for character in first.chars() {
                    self.glyph(Face::Upright, character, size, drop);
                    self.plain.push(character);
                }
            }
        }
        rest
    }

    fn fraction(&mut self, above: &str, below: &str, size: f64, drop: f64) {
        if self.inline {
            let grouped =
                |part: &str| if part.chars().count() > 1 { format!("({part})") } else { part.into() };
            self.mathematics(&format!("{}/{}", grouped(above), grouped(below)), size, drop, true);
            return;
        }
        let small = 0.88 * size;
        let set = |source| {
            let mut part = Text::default();
            part.mathematics(source, small, 0.0, true);
            part
        };
        let (above, below) = (set(above), set(below));
        let axis = drop - 0.26 * size;
        let gap = 0.17 * size;
        let inner = above.width.max(below.width) + 0.16 * size;
        let x = self.width + 0.06 * size;
        let thickness = 0.05 * size;
        self.bars.push(Bar { x, drop: axis, width: inner, thickness });
        let (up, down) = (axis - gap - above.descent, axis + gap + below.ascent);
        self.plain.push_str(&format!("{}/{}", grouped(&above.plain), grouped(&below.plain)));
        let centred = |part: &Text| x + (inner - part.width) / 2.0;
        let (above_x, below_x) = (centred(&above), centred(&below));
        self.append(above, above_x, up);
        self.append(below, below_x, down);
        self.width = x + inner + 0.06 * size;
    }

    /// Adds a finished part at `x`, its baseline `drop` below.
    fn append(&mut self, part: Text, x: f64, drop: f64) {
        self.ascent = self.ascent.max(part.ascent - drop);
        self.descent = self.descent.max(part.descent + drop);
        self.runs.extend(part.runs.into_iter().map(|mut run| {
            run.drop += drop;
            run.glyphs.iter_mut().for_each(|glyph| glyph.1 += x);
            run
        }));
        self.bars.extend(part.bars.into_iter().map(|bar| Bar { x: bar.x + x, drop: bar.drop + drop, ..bar }));
    }
}

/// The next argument: a braced group or one character; and what follows.
fn argument(source: &str) -> (&str, &str) {
    let Some(inside) = source.strip_prefix('{') else {
        return source.split_at(source.chars().next().map_or(0, char::len_utf8));
    };
    let mut depth = 1;
    for (at, character) in inside.char_indices() {
        depth += match character {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if depth == 0 {
            return (&inside[..at], &inside[at + 1..]);
        }
    }
    (inside, "")
}

fn plain_script(mark: &str, argument: &str) -> String {
    match (mark, argument) {
        ("^", "2") => "²".into(),
        ("_", "−") => "₋".into(),
        ("_", "+") => "₊".into(),
        _ => {
            let upright = argument.strip_prefix(r"\up{").and_then(|rest| rest.strip_suffix('}'));
            format!("{mark}{}", upright.unwrap_or(argument))
        }
    }
}

/// In parentheses if a solidus would otherwise bind it wrongly.
fn grouped(plain: &str) -> String {
    let single =
        plain.chars().count() == 1 || plain.starts_with('|') && plain.ends_with('|') && plain.len() == 3;
    if single { plain.into() } else { format!("({plain})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_characters_read_as_the_formula() {
        let text = Text::new(r"line $μ*(k) = \frac{ak+b}{ck+d}$, $γ^2 ≤ −1$", 12.0);
        assert_eq!(text.plain, "line μ*(k) = (ak + b)/(ck + d), γ² ≤ −1");
        assert_eq!(Text::new(r"$\up{SRO}′_−$", 12.0).plain, "SRO′₋");
        assert_eq!(Text::new(r"$\ddot{x}_O < 0$", 12.0).plain, "x\u{308}_O < 0");
    }

    #[test]
    fn a_sign_that_begins_is_not_spaced_like_one_that_joins() {
        let [unary, binary] = ["$−1$", "$k−1$"].map(|m| Text::new(m, 10.0));
        let k = Text::new("$k$", 10.0);
        assert!((binary.width - unary.width - k.width - 3.2).abs() < 1e-9);
    }

    #[test]
    fn bars_keep_off_their_neighbours() {
        let width = |markup: &str| Text::new(markup, 10.0).width;
        let bar = Face::Upright.glyph('|').advance / 100.0;
        assert!((width("$k|k′|$") - width("$k$") - width("$k′$") - 2.0 * bar - 4.0 * 0.7).abs() < 1e-9);
        assert_eq!(Text::new("$k|k′|$", 10.0).plain, "k|k′|");
        assert_eq!(Text::new("$−|a|k + b$", 10.0).plain, "−|a|k + b");
    }

    #[test]
    fn a_fraction_is_taller_than_its_line_and_as_wide_as_its_wider_half() {
        let fraction = Text::new(r"$\frac{1}{γ(1+k′)}$", 12.0);
        assert!(fraction.height() > 20.0 && fraction.height() < 32.0);
        assert_eq!(fraction.bars.len(), 1);
        assert!(fraction.width < Text::new("$1/γ(1+k′)$", 12.0).width);
    }

    #[test]
    fn markup_signs_in_verbatim_text_are_characters() {
        assert_eq!(Text::verbatim("$k_A$ {x}", 12.0).plain, "$k_A$ {x}");
    }
}
