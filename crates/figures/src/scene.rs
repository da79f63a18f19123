//! Drawings as SVG: paths, rules and glyphs in drawing order, coordinates in pixels, y down.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write;

use crate::font::Face;
use crate::palette::{self, INK, PAPER};
use crate::text::Text;
use crate::texture;
use standfast::Verdict;

/// An axis-parallel rectangle, `x0 ≤ x1`, `y0 ≤ y1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rect {
    /// Left.
    pub x0: f64,
    /// Top.
    pub y0: f64,
    /// Right.
    pub x1: f64,
    /// Bottom.
    pub y1: f64,
}

impl Rect {
    /// A rectangle around a centre.
    pub(crate) fn around(x: f64, y: f64, width: f64, height: f64) -> Rect {
        Rect { x0: x - width / 2.0, y0: y - height / 2.0, x1: x + width / 2.0, y1: y + height / 2.0 }
    }

    /// True if the two share inner points.
    pub fn overlaps(&self, other: &Rect) -> bool {
        self.x0 < other.x1 && other.x0 < self.x1 && self.y0 < other.y1 && other.y0 < self.y1
    }

    /// True if `other` lies inside.
    pub fn contains(&self, other: &Rect) -> bool {
        self.x0 <= other.x0 && other.x1 <= self.x1 && self.y0 <= other.y0 && other.y1 <= self.y1
    }

    /// Grown by `by` on all sides.
    pub(crate) fn grown(&self, by: f64) -> Rect {
        Rect { x0: self.x0 - by, y0: self.y0 - by, x1: self.x1 + by, y1: self.y1 + by }
    }

    /// The corners, clockwise on the page.
    pub(crate) fn corners(&self) -> [(f64, f64); 4] {
        let Rect { x0, y0, x1, y1 } = *self;
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    }

    /// The centre.
    pub fn centre(&self) -> (f64, f64) {
        ((self.x0 + self.x1) / 2.0, (self.y0 + self.y1) / 2.0)
    }
}

/// A piece of text as it was placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// Its plain characters.
    pub text: String,
    /// The box of its ink.
    pub rect: Rect,
    /// Type size of its largest letters, in SVG units.
    pub size: f64,
}

/// Stroke of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pen {
    pub colour: &'static str,
    pub width: f64,
    /// SVG dash array; empty for a solid line.
    pub dashes: &'static str,
}

impl Pen {
    pub(crate) const fn solid(colour: &'static str, width: f64) -> Pen {
        Pen { colour, width, dashes: "" }
    }
}

/// SVG path data under construction.
#[derive(Debug, Clone, Default)]
pub(crate) struct Path(String);

impl Path {
    pub(crate) fn rectangle(rect: &Rect) -> Path {
        let mut path = Path::through(&rect.corners());
        path.close();
        path
    }

    pub(crate) fn move_to(&mut self, x: f64, y: f64) {
        self.put('M', &[x, y]);
    }

    pub(crate) fn line_to(&mut self, x: f64, y: f64) {
        self.put('L', &[x, y]);
    }

    pub(crate) fn cubic_to(&mut self, x1: f64, y1: f64, x2: f64, y2: f64, x: f64, y: f64) {
        self.put('C', &[x1, y1, x2, y2, x, y]);
    }

    pub(crate) fn close(&mut self) {
        self.0.push('Z');
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A polyline.
    pub(crate) fn through(points: &[(f64, f64)]) -> Path {
        let mut path = Path::default();
        for (i, &(x, y)) in points.iter().enumerate() {
            if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path
    }

    fn put(&mut self, command: char, numbers: &[f64]) {
        self.0.push(command);
        for (i, &number) in numbers.iter().enumerate() {
            if i > 0 {
                self.0.push(' ');
            }
            decimal(&mut self.0, number);
        }
    }
}

/// A drawing: the body of an SVG, the outlines it uses and the labels it carries.
#[derive(Debug, Default)]
pub(crate) struct Scene {
    /// True if colours are custom properties, for a page to set; false if they are fixed.
    themed: bool,
    body: String,
    /// Rules beside those of dark pages.
    rules: String,
    used: BTreeSet<(Face, char)>,
    labels: Vec<Label>,
}

impl Scene {
    /// A drawing whose colours are custom properties of CSS, and whose page is transparent.
    pub(crate) fn themed() -> Scene {
        Scene { themed: true, ..Scene::default() }
    }

    /// True of a drawing for a screen.
    pub(crate) fn is_themed(&self) -> bool {
        self.themed
    }

    /// A colour as it is written: itself, or in a themed drawing its property.
    pub(crate) fn paint<'a>(&self, colour: &'a str) -> Cow<'a, str> {
        if self.themed { palette::themed(colour) } else { Cow::Borrowed(colour) }
    }

    /// Opens a group with attributes, to be closed by [`close`](Scene::close).
    pub(crate) fn open(&mut self, attributes: &str) {
        self.write(format_args!("<g {attributes}>\n"));
    }

    /// Adds a rule to the style of the drawing.
    pub(crate) fn rule(&mut self, rule: &str) {
        self.rules.push_str(rule);
    }

    /// Writes elements as they are.
    pub(crate) fn put(&mut self, elements: &str) {
        self.body.push_str(elements);
    }

    /// Closes a group.
    pub(crate) fn close(&mut self) {
        self.body.push_str("</g>\n");
    }

    /// Fills a path.
    pub(crate) fn fill(&mut self, path: &Path, colour: &str) {
        let colour = self.paint(colour);
        if !path.is_empty() {
            self.write(format_args!("<path d=\"{}\" fill=\"{colour}\"/>\n", path.0));
        }
    }

    /// Fills a polygon as a verdict, with its tint and its texture.
    pub(crate) fn area(&mut self, corners: &[(f64, f64)], verdict: Verdict) {
        let mut path = Path::through(corners);
        path.close();
        self.fill(&path, palette::verdict_tint(verdict));
        texture::over_polygon(self, corners, verdict);
    }

    /// Draws a path as a line.
    pub(crate) fn stroke(&mut self, path: &Path, pen: Pen) {
        if path.is_empty() {
            return;
        }
        let Pen { colour, width, dashes } = pen;
        let colour = self.paint(colour);
        self.write(format_args!(
            "<path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"",
            path.0
        ));
        if !dashes.is_empty() {
            // A dash of no length with a round cap is a dot.
            let cap = if dashes.starts_with("0 ") { " stroke-linecap=\"round\"" } else { "" };
            self.write(format_args!(" stroke-dasharray=\"{dashes}\"{cap}"));
        }
        self.body.push_str("/>\n");
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), pen: Pen) {
        self.stroke(&Path::through(&[from, to]), pen);
    }

    /// An arrow.
    pub(crate) fn arrow(&mut self, from: (f64, f64), tip: (f64, f64), pen: Pen) {
        let (dx, dy) = (tip.0 - from.0, tip.1 - from.1);
        let length = dx.hypot(dy);
        // The line ends inside the head, not at its tip.
        let end = (tip.0 - 6.0 * dx / length, tip.1 - 6.0 * dy / length);
        self.line(from, end, pen);
        self.arrowhead(tip, (dx, dy), pen.colour);
    }

    /// A filled arrowhead with its tip at `tip`, pointing along (`dx`, `dy`).
    pub(crate) fn arrowhead(&mut self, tip: (f64, f64), (dx, dy): (f64, f64), colour: &str) {
        let length = dx.hypot(dy);
        let (ux, uy) = (dx / length, dy / length);
        let at =
            |along: f64, across: f64| (tip.0 - along * ux - across * uy, tip.1 - along * uy + across * ux);
        let mut path = Path::through(&[tip, at(8.5, 2.7), at(6.8, 0.0), at(8.5, -2.7)]);
        path.close();
        self.fill(&path, colour);
    }

    /// A filled circle with a rim.
    pub(crate) fn dot(&mut self, (x, y): (f64, f64), radius: f64, fill: &str, rim: Option<Pen>) {
        let fill = self.paint(fill);
        let mut circle = String::from("<circle cx=\"");
        decimal(&mut circle, x);
        circle.push_str("\" cy=\"");
        decimal(&mut circle, y);
        self.write(format_args!("{circle}\" r=\"{radius}\" fill=\"{fill}\""));
        if let Some(Pen { colour, width, .. }) = rim {
            let colour = self.paint(colour);
            self.write(format_args!(" stroke=\"{colour}\" stroke-width=\"{width}\""));
        }
        self.body.push_str("/>\n");
    }

    /// Text with the left end of its baseline at (`x`, `y`).
    pub(crate) fn text(&mut self, text: &Text, x: f64, y: f64, colour: &str) {
        if text.runs.is_empty() {
            return;
        }
        self.labels.push(Label {
            text: text.plain.clone(),
            rect: Rect { x0: x, y0: y - text.ascent, x1: x + text.width, y1: y + text.descent },
            size: text.runs.iter().map(|run| run.size).fold(0.0, f64::max),
        });
        self.letters(text, x, y, colour);
    }

    /// Text that is no label: one of several that are seen in turn at one place.
    pub(crate) fn letters(&mut self, text: &Text, x: f64, y: f64, colour: &str) {
        for run in &text.runs {
            // The group is in units of the font, y up, so that the outlines stay as they are in it.
            self.body.push_str("<g transform=\"translate(");
            decimal(&mut self.body, x);
            self.body.push(' ');
            decimal(&mut self.body, y + run.drop);
            let scale = run.size / 1000.0;
            self.write(format_args!(") scale({scale:.5} {:.5})\"", -scale));
            if colour != INK {
                self.write(format_args!(" fill=\"{}\"", self.paint(colour)));
            }
            self.body.push('>');
            if self.themed {
                // One path is drawn much faster than a reference for each letter.
                self.body.push_str("<path d=\"");
                for &(character, offset) in &run.glyphs {
                    let outline = &run.face.glyph(character).relative;
                    self.write(format_args!("M{:.0} 0{outline}", offset / scale));
                }
                self.body.push_str("\"/></g>\n");
                continue;
            }
            for &(character, offset) in &run.glyphs {
                self.used.insert((run.face, character));
                self.write(format_args!(
                    "<use href=\"#{}\" x=\"{:.0}\"/>",
                    run.face.id(character),
                    offset / scale
                ));
            }
            self.body.push_str("</g>\n");
        }
        for bar in &text.bars {
            let (from, to) = ((x + bar.x, y + bar.drop), (x + bar.x + bar.width, y + bar.drop));
            let width = (bar.thickness * 100.0).round() / 100.0;
            self.stroke(&Path::through(&[from, to]), Pen { colour: INK, width, dashes: "" });
        }
    }

    /// Text with its ink centred in a rectangle.
    pub(crate) fn text_in(&mut self, text: &Text, rect: &Rect, colour: &str) {
        let (x, y) = rect.centre();
        self.text(text, x - text.width / 2.0, y + (text.ascent - text.descent) / 2.0, colour);
    }

    /// The SVG document and the labels in it. `title` and `description` are for readers who do not see it.
    pub(crate) fn finish(
        self,
        width: f64,
        height: f64,
        title: &str,
        description: &str,
    ) -> (String, Vec<Label>) {
        let (width, height) = (width.ceil(), height.ceil());
        let paper = if self.themed {
            String::new()
        } else {
            format!("<path d=\"M0 0H{width}V{height}H0Z\" fill=\"{PAPER}\"/>\n")
        };
        let root = format!("{paper}<g fill=\"{}\" stroke-linejoin=\"round\">\n", self.paint(INK));
        let style = if self.themed {
            String::new()
        } else {
            format!("<style>{}{}</style>\n", self.rules, palette::dark_style(&(root.clone() + &self.body)))
        };
        let mut svg = String::with_capacity(self.body.len() + 24_000);
        let put =
            |svg: &mut String, text: std::fmt::Arguments| svg.write_fmt(text).expect("writing to a string");
        put(
            &mut svg,
            format_args!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
                 viewBox=\"0 0 {width} {height}\" role=\"img\" class=\"standfast\">\n<title>{}</title>\n<desc>{}</desc>\n{style}<defs>\n",
                escaped(title),
                escaped(description)
            ),
        );
        for &(face, character) in &self.used {
            let glyph = face.glyph(character);
            put(&mut svg, format_args!("<path id=\"{}\" d=\"{}\"/>\n", face.id(character), glyph.outline));
        }
        put(&mut svg, format_args!("</defs>\n{root}{}</g>\n</svg>\n", self.body));
        (svg, self.labels)
    }

    fn write(&mut self, text: std::fmt::Arguments) {
        self.body.write_fmt(text).expect("writing to a string");
    }
}

/// Two decimals, without trailing zeros and without a negative zero.
fn decimal(out: &mut String, number: f64) {
    let hundredths = (number * 100.0).round() as i64;
    let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let sign = if hundredths < 0 { "-" } else { "" };
    let done = match part {
        0 => write!(out, "{sign}{whole}"),
        _ if part % 10 == 0 => write!(out, "{sign}{whole}.{}", part / 10),
        _ => write!(out, "{sign}{whole}.{part:02}"),
    };
    done.expect("writing to a string");
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
