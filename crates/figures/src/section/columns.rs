//! Columns beside the body, outwards: forces, pressures, heights, levels.

use super::paint::{Painter, THIN, side_of};
use super::{Arrow, LABEL, Level, Measure, Pressed, SectionArrow, SectionNumber, Side, tag};
use crate::labels::spread;
use crate::palette::{INK, MARK, PULL, PUSH, WET};
use crate::scene::{Path, Pen, Rect};
use crate::text::Text;

/// Room between the body and the first column, where the letters of the corners stand.
pub(super) const GAP: f64 = 26.0;
/// Room between columns, and between rows.
pub(super) const APART: f64 = 14.0;
/// Distance of the sign of water from the end of its surface.
const SIGN: f64 = 9.0;
/// The shortest arrow of a force that is seen.
const SHORTEST: f64 = 14.0;
/// Room between a thing and its label.
const NEAR: f64 = 6.0;
/// Room for a ring at the tail of an arrow.
const RING: f64 = 12.0;
/// Distance of the middle of a number above or below the end of a diagram.
const LETTER: f64 = 11.0;
/// A label that is moved farther than this has a line to its place.
pub(super) const MOVED: f64 = 3.0;
/// As far as labels may ever be moved.
pub(super) const ANYWHERE: f64 = 1e6;

/// The top and bottom of what stands on a side.
pub(super) struct Reach {
    pub top: f64,
    pub bottom: f64,
}

impl Reach {
    fn hold(&mut self, rect: &Rect) {
        self.top = self.top.min(rect.y0);
        self.bottom = self.bottom.max(rect.y1);
    }
}

/// A label for a place, and the place on the page.
pub(super) struct Spot {
    pub at: (f64, f64),
    pub text: Text,
    pub colour: &'static str,
    /// The thing whose number it is.
    pub of: Option<SectionNumber>,
    /// How much lower than the place the label wants to stand.
    pub lower: f64,
}

impl Painter<'_> {
    /// Draws the columns of a side; says how far up and down they reach.
    pub(super) fn columns(&mut self, side: Side) -> Reach {
        let out = if side == Side::Left { -1.0 } else { 1.0 };
        let edge = if side == Side::Left { self.bounds.x0 } else { self.bounds.x1 };
        let (wall, base) = self.place(edge, 0.0);
        let mut reach = Reach { top: self.place(0.0, self.bounds.y1).1, bottom: base };
        let mut column = Column { wall, out, end: GAP.max(self.overhang(out) + APART) };
        self.forces(&mut column, &mut reach);
        let given = self.given;
        for (index, pressed) in given.pressures.iter().enumerate() {
            if side_of(pressed.face) == Some(side) {
                self.pressure_beside(&mut column, &mut reach, index, pressed);
            }
        }
        if side == Side::Left {
            given
                .heights
                .iter()
                .enumerate()
                .for_each(|(at, heights)| self.heights(&mut column, &mut reach, at, heights));
        }
        self.level_names(side, &mut column, &mut reach);
        reach
    }

    /// Length by which the forces within the body reach beyond a side of it.
    fn overhang(&self, out: f64) -> f64 {
        let longest = self.look.longest;
        let edge = if out < 0.0 { self.bounds.x0 } else { self.bounds.x1 };
        let inside = self.given.arrows.iter().filter(|arrow| arrow.is_inside);
        // A vertical one may be moved aside, a letter stands beside each.
        let reach = inside.map(|arrow| {
            let along =
                if arrow.towards.0 * out > 0.0 { longest } else { 1.6 * longest * arrow.towards.1.abs() };
            ((self.near_body(arrow.at).0 - edge) * self.scale) * out + along + APART
        });
        reach.fold(0.0, f64::max)
    }

    /// Forces that push on the side, and their sizes at their tails.
    fn forces(&mut self, column: &mut Column, reach: &mut Reach) {
        let given = self.given;
        let first = given.pressures.len();
        let pushes = |arrow: &Arrow| !arrow.is_inside && arrow.towards.0 * column.out < 0.0;
        let arrows: Vec<_> = given.arrows.iter().enumerate().filter(|(_, arrow)| pushes(arrow)).collect();
        if arrows.is_empty() {
            return;
        }
        let crest = self.place(0.0, self.bounds.y1).1;
        let longest = arrows.iter().map(|(_, arrow)| self.force_length(arrow.size)).fold(0.0, f64::max);
        // On a screen a ring to drag sits on each tail.
        let ring = if self.look.on_screen { RING } else { 0.0 };
        let start = column.end - GAP + longest + NEAR + ring;
        let mut spots = Vec::new();
        for (index, arrow) in arrows {
            let (_, level) = self.place(0.0, self.near_body(arrow.at).1);
            // It ends on the face that it pushes, and not where the body is widest.
            let face = self.place(self.face(self.near_body(arrow.at).1, column.out), 0.0).0;
            let tip = (face + column.out * 1.5, level);
            let tail = (tip.0 + column.out * self.force_length(arrow.size), level);
            if (column.x(start) - tail.0) * column.out > 2.0 * NEAR {
                self.line((tail.0 + column.out * 2.0, level), (column.x(start - 2.0), level), THIN);
            }
            if level < crest {
                let lever = Pen { colour: MARK, width: 0.8, dashes: "2.5 2.2" };
                self.line((column.wall, crest), (column.wall, level), lever);
            }
            self.drawn.scene.arrow(tail, tip, Pen::solid(MARK, 2.0));
            self.drawn.arrows.push(SectionArrow { index, tail, tip });
            let text = self.force_words(first + index, arrow);
            let of = Some(SectionNumber::Arrow(index));
            spots.push(Spot { at: (column.x(start - NEAR), level), text, colour: MARK, of, lower: 0.0 });
        }
        column.end = self.names(column, start, spots, reach);
    }

    /// A pressure as a diagram on a line of its own, with its numbers.
    fn pressure_beside(&mut self, column: &mut Column, reach: &mut Reach, index: usize, pressed: &Pressed) {
        let scale = self.pressure_scale();
        let reaches = |sign: f64| {
            pressed.points.iter().map(|(_, pressure, _)| sign * pressure * scale).fold(0.0, f64::max)
        };
        let (inwards, outwards) = (reaches(-1.0), reaches(1.0).max(8.0));
        let Some(last) = pressed.points.len().checked_sub(1) else { return };
        let text = |i: usize| Text::verbatim(&pressed.points[i].2, LABEL);
        // The numbers of both ends stand below and above the diagram, those between beside it.
        let is_end = |i: &usize| *i == 0 || *i == last;
        let has_numbers = self.look.numbers;
        let numbers = |pressed| numbers(pressed).filter(move |_| has_numbers);
        let widest =
            numbers(pressed).filter(is_end).map(|i| text(i).width).fold(inwards + outwards, f64::max);
        let line = column.end + (widest - inwards - outwards) / 2.0 + inwards;
        let middle = column.x(column.end + widest / 2.0);
        let stalk = |(position, pressure, _): &(f64, f64, String)| {
            let y = self.place(0.0, *position).1;
            let [foot, tip] = [line, line + pressure * scale].map(|distance| (column.x(distance), y));
            Stalk { foot, tip, pressure: *pressure }
        };
        let stalks: Vec<_> = pressed.points.iter().map(stalk).collect();
        self.diagram(&stalks);
        let mut top = stalks[last].foot.1 - LETTER;
        for i in numbers(pressed).filter(is_end) {
            let y = if i == 0 { stalks[0].foot.1 + LETTER } else { top };
            let rect = self.label(&text(i), (middle, y), INK);
            reach.hold(&rect);
            if i == last {
                top -= 1.5 * LETTER;
            }
        }
        let letter = Text::new(&format!("${}$", tag(index)), LABEL);
        let rect = self.label(&letter, (middle, top), INK);
        reach.hold(&rect);
        let side = if column.out < 0.0 { Side::Left } else { Side::Right };
        let between = numbers(pressed).filter(|i| !is_end(i)).map(|i| {
            let Stalk { foot, tip, pressure } = stalks[i];
            // What pulls is drawn towards the body: its line is nearer to the number.
            let (at, text) = (if pressure < 0.0 { foot } else { tip }, text(i));
            let lower = self.below_water(side, at.1, text.height());
            Spot { at, text, colour: INK, of: None, lower }
        });
        let spots: Vec<_> = between.collect();
        let end = column.end + widest;
        column.end = match spots.is_empty() {
            true => end + APART,
            false => self.names(column, end + NEAR, spots, reach),
        };
    }

    /// How much lower a label of this height has to stand so that the surface of water does not run through it.
    fn below_water(&self, side: Side, y: f64, height: f64) -> f64 {
        const OFF: f64 = 3.0;
        let surfaces = self.given.levels.iter().filter(|level| level.is_water && level.side == side);
        let surfaces = surfaces.map(|level| self.place(0.0, self.shown(level.elevation)).1);
        let meets = |surface: &f64| (y - surface).abs() < height / 2.0 + OFF;
        surfaces.filter(meets).map(|surface| surface - y + height / 2.0 + OFF).fold(0.0, f64::max)
    }

    /// Length to which a force is drawn: all to one scale, but none so short that it is not seen.
    pub(super) fn force_length(&self, size: f64) -> f64 {
        let reaction = self.given.reaction.iter().map(|reaction| reaction.size);
        let largest = self.given.arrows.iter().map(|arrow| arrow.size).chain(reaction).fold(0.0, f64::max);
        let tall = (self.bounds.y1 - self.bounds.y0) * self.scale;
        let longest = (0.4 * tall).max(2.0 * SHORTEST).min(self.look.longest);
        if largest > 0.0 { (longest * size / largest).max(SHORTEST) } else { SHORTEST }
    }

    /// Length to which a pascal is drawn.
    pub(super) fn pressure_scale(&self) -> f64 {
        let all = self.given.pressures.iter().flat_map(|pressed| &pressed.points);
        let largest = all.map(|(_, pressure, _)| pressure.abs()).fold(0.0, f64::max);
        if largest > 0.0 { self.look.longest / largest } else { 0.0 }
    }

    /// The area between a diagram and its line, with arrows the way it presses.
    pub(super) fn diagram(&mut self, stalks: &[Stalk]) {
        const STEP: f64 = 17.0;
        /// An arrow shorter than this is all head.
        const SHORT: f64 = 12.0;
        for pair in stalks.windows(2) {
            let [one, other] = [pair[0], pair[1]];
            let colour = if one.pressure + other.pressure < 0.0 { PULL } else { WET };
            let mut path = Path::through(&[one.foot, one.tip, other.tip, other.foot]);
            path.close();
            self.drawn.scene.fill(&path, colour);
            let length = (other.foot.0 - one.foot.0).hypot(other.foot.1 - one.foot.1);
            let count = (length / STEP).floor() as u32;
            let between = (0..count).map(|i| one.towards(&other, (f64::from(i) + 0.5) / f64::from(count)));
            for Stalk { foot, tip, .. } in between {
                if (foot.0 - tip.0).hypot(foot.1 - tip.1) > SHORT {
                    // Pressure is drawn outwards from its line and acts inwards; what pulls is drawn and acts the other way.
                    self.drawn.scene.arrow(tip, foot, Pen::solid(PUSH, 0.9));
                }
            }
        }
        let pen = Pen::solid(PUSH, 1.2);
        for pair in stalks.windows(2) {
            self.line(pair[0].tip, pair[1].tip, pen);
            self.line(pair[0].foot, pair[1].foot, pen);
        }
        for end in stalks.first().into_iter().chain(stalks.last()) {
            self.line(end.foot, end.tip, pen);
        }
    }

    /// Heights written out along a line.
    fn heights(&mut self, column: &mut Column, reach: &mut Reach, at: usize, heights: &[Measure]) {
        let x = column.x(column.end);
        let mut spots = Vec::new();
        for (place, Measure { ends, label }) in heights.iter().enumerate() {
            let [from, to] = [ends.0, ends.1].map(|height| (x, self.place(0.0, height).1));
            self.dimension(from, to);
            let (middle, of) = ((x, (from.1 + to.1) / 2.0), Some(SectionNumber::Height(at, place)));
            self.drawn.ends.push((SectionNumber::Height(at, place), to));
            spots.push(Spot { at: middle, text: Text::new(label, LABEL), colour: INK, of, lower: 0.0 });
        }
        column.end = self.names(column, column.end + NEAR, spots, reach);
    }

    /// A line between two ends with strokes across them.
    pub(super) fn dimension(&mut self, from: (f64, f64), to: (f64, f64)) {
        const STROKE: f64 = 3.5;
        let pen = Pen::solid(INK, 0.8);
        self.line(from, to, pen);
        for (x, y) in [from, to] {
            self.line((x - STROKE, y + STROKE), (x + STROKE, y - STROKE), Pen::solid(INK, 1.2));
        }
    }

    /// Labels in a column from `start` outwards; gives where the next column begins.
    fn names(&mut self, column: &Column, start: f64, spots: Vec<Spot>, reach: &mut Reach) -> f64 {
        const LINE: f64 = 4.0;
        /// A label that begins farther from its place than this has a line to it.
        const BESIDE: f64 = 15.0;
        let mut spots = spots;
        let wants = |spot: &Spot| spot.at.1 + spot.lower;
        standfast::order::by_number(&mut spots, wants);
        let wanted: Vec<_> = spots.iter().map(|spot| (wants(spot), spot.text.height())).collect();
        let Some(places) = spread(&wanted, -ANYWHERE, ANYWHERE, LINE) else { return start };
        let moved = spots.iter().zip(&places).any(|(spot, y)| (wants(spot) - y).abs() > MOVED);
        let start = if moved { start + APART } else { start };
        let mut width: f64 = 0.0;
        for (spot, y) in spots.iter().zip(places) {
            if moved || (spot.at.0 - column.x(start)).abs() > BESIDE {
                self.line(spot.at, (column.x(start - 2.0), y), THIN);
            }
            let centre = column.x(start + spot.text.width / 2.0);
            let rect = self.label(&spot.text, (centre, y), spot.colour);
            self.drawn.numbers.extend(spot.of.map(|of| (of, rect)));
            reach.hold(&rect);
            width = width.max(spot.text.width);
        }
        start + width + APART
    }

    fn levels(&self, side: Side) -> impl Iterator<Item = (usize, &Level)> {
        self.given.levels.iter().enumerate().filter(move |(_, level)| level.side == side)
    }

    /// The names of the levels, and their lines from the wall to them; the surface of water with its sign.
    fn level_names(&mut self, side: Side, column: &mut Column, reach: &mut Reach) {
        // A screen has room for those that the eye looks for; the body's own stand in its height.
        let twin = |level: &Level| {
            let others = &self.given.levels;
            side == Side::Right
                && others
                    .iter()
                    .any(|other| other.is_water && other.side == Side::Left && other.label == level.label)
        };
        let (look, given) = (self.look, self.given);
        let levels = self.levels(side).filter(|(_, level)| level.is_water || !look.on_screen);
        let levels: Vec<_> = levels
            .map(|(index, level)| (index, level.clone(), look.names && !(look.on_screen && twin(level))))
            .collect();
        // Ground that fails comes out on a side.
        let end = (column.end + NEAR).max(self.exit(column.out));
        let mut spots = Vec::new();
        for (index, Level { elevation, label, is_water, .. }, is_named) in levels {
            let (_, y) = self.place(0.0, self.shown(elevation));
            let pen = if is_water { Pen::solid(PUSH, 1.0) } else { THIN };
            let face = self.place(self.face(elevation, column.out), 0.0).0;
            self.level_line(y, (face, column.x(end)), pen);
            if is_water {
                // Beyond forces and pressures, which may stand on the surface.
                let x = column.x(end - SIGN);
                let mut sign = Path::through(&[(x, y), (x - 5.0, y - 8.0), (x + 5.0, y - 8.0)]);
                sign.close();
                self.drawn.scene.fill(&sign, PUSH);
            }
            if !is_named {
                continue;
            }
            let (text, of) = (Text::verbatim(&label, LABEL), Some(SectionNumber::Level(index)));
            spots.push(Spot { at: (column.x(end), y), text, colour: INK, of, lower: 0.0 });
        }
        for fill in given.backfills.iter().filter(|fill| fill.side == side) {
            let y = self.place(0.0, fill.top).1;
            let face = self.place(self.face(fill.top, column.out), 0.0).0;
            self.level_line(y, (face, column.x(end)), Pen::solid(INK, 1.2));
        }
        let names = match side {
            Side::Left => &mut self.drawn.names.0,
            Side::Right => &mut self.drawn.names.1,
        };
        *names = column.x(end);
        if !spots.is_empty() {
            column.end = self.names(column, end + NEAR, spots, reach);
        }
    }

    /// A level, but where a label stands or a force acts.
    fn level_line(&mut self, y: f64, (from, to): (f64, f64), pen: Pen) {
        const OFF: f64 = 4.0;
        let labels = self.labels_at(y).map(|rect| (rect.x0 - 3.0, rect.x1 + 3.0));
        let arrows = self
            .drawn
            .arrows
            .iter()
            .filter(|arrow| arrow.tail.1 == arrow.tip.1 && (arrow.tail.1 - y).abs() < OFF);
        let arrows = arrows.map(|SectionArrow { tail, tip, .. }| {
            (tail.0.min(tip.0) - 2.0 * OFF, tail.0.max(tip.0) + 2.0 * OFF)
        });
        let mut cuts: Vec<_> = labels.chain(arrows).collect();
        standfast::order::by_number(&mut cuts, |one| one.0);
        let (mut at, end) = (from.min(to), from.max(to));
        for (left, right) in cuts {
            if at < left.min(end) {
                self.line((at, y), (left.min(end), y), pen);
            }
            at = at.max(right);
        }
        if at < end {
            self.line((at, y), (end, y), pen);
        }
    }
}

/// A side of the body under way: where the wall is, which way is outwards, and how far columns reach.
pub(super) struct Column {
    wall: f64,
    out: f64,
    end: f64,
}

impl Column {
    /// A distance from the wall as a place on the page.
    fn x(&self, distance: f64) -> f64 {
        self.wall + self.out * distance
    }
}

/// Points of a pressure that are written out: not those without pressure, nor a number twice running.
pub(super) fn numbers(pressed: &Pressed) -> impl Iterator<Item = usize> {
    let points = &pressed.points;
    let written = |i: &usize| {
        let (_, pressure, label) = &points[*i];
        let before = i.checked_sub(1).map(|before| &points[before].2);
        *pressure != 0.0 && before != Some(label)
    };
    (0..points.len()).filter(written)
}

/// A pressure at a place: its foot on the line of the diagram, and where it is drawn to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stalk {
    pub foot: (f64, f64),
    pub tip: (f64, f64),
    pub pressure: f64,
}

impl Stalk {
    /// The one at a share of the way to another.
    fn towards(&self, other: &Stalk, share: f64) -> Stalk {
        let mean = |one: f64, other: f64| one + share * (other - one);
        let between = |one: (f64, f64), other: (f64, f64)| (mean(one.0, other.0), mean(one.1, other.1));
        Stalk {
            foot: between(self.foot, other.foot),
            tip: between(self.tip, other.tip),
            pressure: mean(self.pressure, other.pressure),
        }
    }
}
