//! What lies under the base: its reaction, pressures, the way in which the ground fails, and numbers that stand where they act.

use standfast::loads::Face;

use super::columns::{APART, GAP};
use super::paint::Painter;
use super::rows::DOWN;
use super::surroundings::{SHOULDER, SLOPE};
use super::{BaseReaction, LABEL, SectionNumber, Stated};
use crate::palette::{INK, MARK, PAPER, PUSH, WET};
use crate::scene::{Path, Pen, Rect};
use crate::text::Text;

/// Height of the block of pressure under the effective width.
const BAND: f64 = 7.0;
/// From the base to below the letters of the corners, where the rows begin.
const LETTERS: f64 = 20.0;
/// Height of a row of words, and of one with a field on a screen.
const ROW: f64 = 16.0;
const FIELD_ROW: f64 = 31.0;
/// Width of a field without its unit.
const FIELD: f64 = 58.0;
/// Room between words of a row, and beside an arrow or a line.
const BETWEEN: f64 = 5.0;
const BESIDE: f64 = 9.0;
/// Depth of a strip of soil under the bed or the floor, where nothing asks for more.
const EARTH: f64 = 22.0;
/// The most of the depth of a failure that is drawn, and as a share of the height of the body.
const DEEPEST: f64 = 130.0;
const SHARE: f64 = 0.6;
/// Room between the deepest point of a failure and the end of the soil.
const SPARE: f64 = 7.0;
/// The way in which the ground fails.
const FAILS: Pen = Pen { colour: MARK, width: 1.4, dashes: "6 4" };

/// A row beside the reaction: words, or numbers from left to right.
enum Line<'a> {
    Words(&'a str),
    Numbers(Vec<(&'a Stated, SectionNumber)>),
}

impl Painter<'_> {
    /// What lies under the base. Labels keep below `cellar`; gives the bottom of all.
    pub(super) fn below(&mut self, cellar: f64) -> f64 {
        let base = self.place(0.0, 0.0).1;
        let given = self.given;
        // Under the bed, and not in the mound.
        let bed = self.bed_line() + self.earth();
        let cellar = cellar.max(if self.bed.is_some() { bed + APART } else { bed });
        let mut y = if self.bed.is_some() { bed } else { bed.max(base + GAP - APART) };
        self.failure();
        if let Some(reaction) = &given.reaction {
            y = y.max(self.reaction(reaction));
        }
        y = y.max(self.rows_beside());
        y = y.max(self.failure_name(bed));
        for (index, pressed) in given.pressures.iter().enumerate() {
            if pressed.face == Face::Base {
                y = self.pressure_along(index, pressed, y + APART, cellar, DOWN);
            }
        }
        y.max(cellar)
    }

    /// The y of the bed, or of the base where there is none below it.
    fn bed_line(&self) -> f64 {
        self.place(0.0, self.bed.unwrap_or(0.0).min(0.0)).1
    }

    /// Depth of soil drawn under the bed or the floor, on the page: what stands in it has room.
    pub(super) fn earth(&self) -> f64 {
        if !self.given.is_on_soil {
            return 0.0;
        }
        let base = self.place(0.0, 0.0).1;
        let above = self.bed_line() - base;
        let tall = (self.bounds.y1 - self.bounds.y0) * self.scale;
        let deepest = self.sketched().iter().flatten().map(|at| -at.1 * self.scale).fold(0.0, f64::max);
        let fails =
            if deepest > 0.0 { deepest.min(DEEPEST).min(SHARE * tall).max(above) + SPARE } else { 0.0 };
        EARTH.max(fails - above).max(self.rows_height() - above)
    }

    /// The lines of the failure, in metres; none where none is drawn.
    fn sketched(&self) -> &[Vec<(f64, f64)>] {
        let sketch = self.given.reaction.as_ref().and_then(|reaction| reaction.failure.as_ref());
        sketch.map_or(&[], |sketch| &sketch.lines)
    }

    /// Room that ground takes beside the body where it fails and comes out on a side; no more than a share of the body's width.
    pub(super) fn exit(&self, out: f64) -> f64 {
        const MOST: f64 = 0.6;
        const BEYOND: f64 = 8.0;
        let sketch = self.given.reaction.as_ref().and_then(|reaction| reaction.failure.as_ref());
        let Some(surface) = sketch.filter(|sketch| sketch.out == out).and_then(|sketch| sketch.lines.first())
        else {
            return 0.0;
        };
        let edge = if out < 0.0 { self.bounds.x0 } else { self.bounds.x1 };
        let far = |at: &(f64, f64)| (at.0 - edge) * out;
        // Where the bed is lower than the base, it comes out before.
        let low = self.bed.unwrap_or(0.0).min(0.0);
        let last = surface.windows(2).last().map_or(0.0, |pair| {
            let share = if pair[1].1 > pair[0].1 { (low - pair[0].1) / (pair[1].1 - pair[0].1) } else { 1.0 };
            let (from, to) = (far(&pair[0]), far(&pair[1]));
            from + share.clamp(0.0, 1.0) * (to - from)
        });
        (last * self.scale + BEYOND).min(MOST * self.width())
    }

    /// The way in which the ground fails, as far as ground is drawn.
    fn failure(&mut self) {
        let Some(room) = &self.room else { return };
        let (west, east) = (room.ends.0, room.ends.1);
        let bottom = self.bed_line() + self.earth() - 1.0;
        let lines: Vec<Vec<(f64, f64)>> = self
            .sketched()
            .iter()
            .flat_map(|line| {
                let places: Vec<_> = line.iter().map(|&(x, y)| self.place(x, y)).collect();
                let inside =
                    |(x, y): (f64, f64)| west <= x && x <= east && y <= bottom && y >= self.surface(x) - 0.01;
                clipped(&places, inside)
            })
            .collect();
        for line in lines {
            self.drawn.scene.stroke(&Path::through(&line), FAILS);
        }
    }

    /// The surface of the ground at an x, both on the page: the base, the slopes of a mound, the bed.
    fn surface(&self, x: f64) -> f64 {
        let base = self.place(0.0, 0.0).1;
        let (Some(mound), true) = (self.given.mound, self.bed.is_some()) else { return base };
        let (left, right) = self.given.base;
        let west = self.place(left, 0.0).0 - SHOULDER;
        let east = self.place(right + self.berm_reach(&mound), 0.0).0;
        let beyond = (west - x).max(x - east).max(0.0);
        (base + beyond / SLOPE).min(self.bed_line())
    }

    /// Name of the sketch, below the ground on the side where it comes out; gives where the name ends.
    fn failure_name(&mut self, bottom: f64) -> f64 {
        let sketch = self.given.reaction.as_ref().and_then(|reaction| reaction.failure.as_ref());
        let Some(sketch) = sketch else { return bottom };
        let text = Text::verbatim(&sketch.label, LABEL);
        let near = self.place(sketch.near, 0.0).0;
        let y = bottom + 3.0 + text.height() / 2.0;
        let place = self.free(Rect::around(near, y, text.width, text.height()), sketch.out);
        self.label(&text, place.centre(), MARK).y1
    }

    /// The reaction with what bears it, and the neutral point; gives where its arrow ends.
    fn reaction(&mut self, reaction: &BaseReaction) -> f64 {
        let [(x, base), (from, _), (to, _)] =
            [reaction.at, reaction.pressed.0, reaction.pressed.1].map(|x| self.place(x, 0.0));
        if to > from {
            let corners = [(from, base), (to, base), (to, base + BAND), (from, base + BAND)];
            let mut band = Path::through(&corners);
            band.close();
            self.drawn.scene.fill(&band, WET);
            self.drawn.scene.stroke(&band, Pen::solid(PUSH, 1.0));
        }
        let tail = (x, base + BAND + 1.5 + self.force_length(reaction.size));
        self.drawn.scene.arrow(tail, (x, base + BAND + 1.5), Pen::solid(PUSH, 2.0));
        self.hold(&Rect { x0: from.min(x - 6.0), y0: base, x1: to.max(x + 6.0), y1: tail.1 });
        if let Some(neutral) = reaction.neutral {
            self.drawn.scene.dot(self.place(neutral, 0.0), 3.4, PAPER, Some(Pen::solid(PUSH, 1.4)));
        }
        tail.1
    }

    /// Rows beside the reaction, downwards: the friction on the base, the size of the reaction, the strength of the ground. On a screen, where
    /// they are fields, both numbers stand in a row.
    fn rows(&self) -> Vec<Line<'_>> {
        let given = self.given;
        let mut friction: Vec<_> =
            given.friction.iter().map(|number| (number, SectionNumber::Friction)).collect();
        let mut ground: Vec<_> = given.ground.iter().map(|number| (number, SectionNumber::Ground)).collect();
        if self.look.on_screen {
            friction.append(&mut ground);
        }
        let width = given
            .reaction
            .iter()
            .filter(|_| self.look.on_screen)
            .filter_map(|reaction| reaction.width.as_ref());
        let sizes = given.reaction.iter().flat_map(|reaction| &reaction.labels);
        let words = sizes.chain(width).map(|line| Line::Words(line));
        let numbers = |numbers: Vec<_>| {
            Some(Line::Numbers(numbers)).filter(|line| !matches!(line, Line::Numbers(all) if all.is_empty()))
        };
        numbers(friction).into_iter().chain(words).chain(numbers(ground)).collect()
    }

    fn row_height(&self, row: &Line<'_>) -> f64 {
        match row {
            Line::Numbers(..) if self.look.on_screen => FIELD_ROW,
            _ => ROW,
        }
    }

    /// Where rows of these heights begin, from the letters of the corners downwards and none across the bed; and where the last ends.
    fn row_tops(&self, heights: &[f64]) -> (Vec<f64>, f64) {
        let bed = self.bed_line();
        let mut y = self.place(0.0, 0.0).1 + LETTERS;
        let mut tops = Vec::new();
        for height in heights {
            if y < bed && bed < y + height {
                y = bed + 1.0;
            }
            tops.push(y);
            y += height;
        }
        (tops, y)
    }

    /// What the rows take from the base downwards.
    fn rows_height(&self) -> f64 {
        let heights: Vec<f64> = self.rows().iter().map(|row| self.row_height(row)).collect();
        self.row_tops(&heights).1 - self.place(0.0, 0.0).1
    }

    /// Draws the rows beside the reaction, on the side away from the failure or where there is more of the base; gives where they end.
    fn rows_beside(&mut self) -> f64 {
        let given = self.given;
        let middle = (given.base.0 + given.base.1) / 2.0;
        let (out, start) = match &given.reaction {
            Some(reaction) => {
                let roomier = if reaction.at > middle { -1.0 } else { 1.0 };
                let out = reaction.failure.as_ref().map_or(roomier, |sketch| -sketch.out);
                (out, self.place(reaction.at, 0.0).0 + out * BESIDE)
            }
            None => (1.0, self.place(middle, 0.0).0),
        };
        let rows: Vec<(f64, SetLine)> =
            self.rows().iter().map(|row| (self.row_height(row), self.pieces(row))).collect();
        let heights: Vec<f64> = rows.iter().map(|(height, _)| *height).collect();
        let (tops, end) = self.row_tops(&heights);
        for ((height, pieces), y) in rows.into_iter().zip(tops) {
            let farther = |one: f64, two: f64| if (two - one) * out > 0.0 { two } else { one };
            let lines = self.crossings((y, y + height)).map(|x| x + out * BESIDE);
            let from = lines.fold(start, farther);
            let left = if out > 0.0 { from } else { from - pieces.width };
            let rect = Rect { x0: left, y0: y + 1.0, x1: left + pieces.width, y1: y + height - 1.0 };
            let place = self.free(rect, out);
            for Word { text, from, width, of } in pieces.of {
                let rect =
                    self.label(&text, (place.x0 + from + width / 2.0, place.centre().1), pieces.colour);
                let field = Rect::around(rect.centre().0, rect.centre().1, width, height - 2.0);
                self.hold(&field);
                self.drawn.numbers.extend(of.map(|of| (of, field)));
            }
        }
        end
    }

    /// Where the line of the failure passes heights of the page.
    fn crossings(&self, (top, bottom): (f64, f64)) -> impl Iterator<Item = f64> {
        const LEVELS: u32 = 8;
        let line: Vec<_> =
            self.sketched().first().into_iter().flatten().map(|&(x, y)| self.place(x, y)).collect();
        let levels = (0..=LEVELS).map(move |i| top + (bottom - top) * f64::from(i) / f64::from(LEVELS));
        levels.flat_map(move |y| {
            let pairs = line.windows(2).filter(|pair| (pair[0].1 > y) != (pair[1].1 > y));
            let met = |pair: &[(f64, f64)]| {
                pair[0].0 + (y - pair[0].1) / (pair[1].1 - pair[0].1) * (pair[1].0 - pair[0].0)
            };
            pairs.map(met).collect::<Vec<_>>()
        })
    }

    /// A rectangle moved to a side until no label is in its way.
    fn free(&self, mut rect: Rect, out: f64) -> Rect {
        const STEP: f64 = 4.0;
        while self.touches(&rect.grown(2.0)) {
            rect = Rect { x0: rect.x0 + out * STEP, x1: rect.x1 + out * STEP, ..rect };
        }
        rect
    }

    /// A row set: words in one piece; numbers on a screen with room for their fields.
    fn pieces(&self, row: &Line<'_>) -> SetLine {
        let numbers = match row {
            Line::Words(words) => {
                let text = Text::verbatim(words, LABEL);
                return SetLine {
                    width: text.width,
                    of: vec![Word { width: text.width, text, from: 0.0, of: None }],
                    colour: PUSH,
                };
            }
            Line::Numbers(numbers) => numbers,
        };
        let mut set = SetLine { of: Vec::new(), width: 0.0, colour: INK };
        for (i, (Stated { name, symbol, value, unit }, of)) in numbers.iter().enumerate() {
            if i > 0 {
                set.width += 2.0 * BESIDE;
            }
            if !self.look.on_screen {
                set.add(Text::new(&format!("{name} = {value}{unit}"), LABEL), 0.0, Some(*of));
                continue;
            }
            // Of several the first alone has its name in words.
            let name = if self.look.names && i == 0 { name } else { symbol };
            set.add(Text::new(name, LABEL), 0.0, None);
            set.width += BETWEEN;
            let unit = Text::new(unit, LABEL).width;
            set.add(Text::new(value, LABEL), FIELD + unit + BETWEEN, Some(*of));
        }
        set
    }
}

/// A row that is set.
struct SetLine {
    of: Vec<Word>,
    width: f64,
    colour: &'static str,
}

impl SetLine {
    /// Adds a text in the middle of a room, or of its own width if that is more.
    fn add(&mut self, text: Text, room: f64, of: Option<SectionNumber>) {
        let width = text.width.max(room);
        self.of.push(Word { text, from: self.width, width, of });
        self.width += width;
    }
}

/// A text in a row: where it begins, and the room in whose middle it stands.
struct Word {
    text: Text,
    from: f64,
    width: f64,
    of: Option<SectionNumber>,
}

/// The parts of a line that lie inside, ended where it leaves.
fn clipped(line: &[(f64, f64)], inside: impl Fn((f64, f64)) -> bool) -> Vec<Vec<(f64, f64)>> {
    const STEPS: u32 = 16;
    let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut part: Vec<(f64, f64)> = Vec::new();
    for (pair, i) in line.windows(2).flat_map(|pair| (0..STEPS).map(move |i| (pair, i))) {
        let at = |share: f64| {
            let mean = |one: f64, other: f64| one + share * (other - one);
            (mean(pair[0].0, pair[1].0), mean(pair[0].1, pair[1].1))
        };
        let [from, to] = [i, i + 1].map(|i| f64::from(i) / f64::from(STEPS));
        let [here, there] = [from, to].map(|share| inside(at(share)));
        if here && part.is_empty() {
            part.push(at(from));
        }
        if here != there {
            let (mut one, mut other) = (from, to);
            for _ in 0..20 {
                let middle = (one + other) / 2.0;
                if inside(at(middle)) == here { one = middle } else { other = middle }
            }
            part.push(at(if here { one } else { other }));
        }
        if here && !there {
            parts.push(std::mem::take(&mut part));
        } else if there && i + 1 == STEPS {
            part.push(at(to));
        }
    }
    parts.push(part);
    parts.retain(|part| part.len() > 1);
    parts
}
