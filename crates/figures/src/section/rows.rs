//! Rows above and below the body: forces and pressures on the top, widths.

use standfast::loads::Face;

use super::columns::{ANYWHERE, APART, MOVED, Spot, Stalk, numbers};
use super::paint::{Painter, THIN};
use super::{Arrow, LABEL, Measure, Pressed, SectionArrow, SectionNumber, tag};
use crate::labels::spread;
use crate::palette::{INK, MARK};
use crate::scene::Pen;
use crate::text::Text;

/// Room between the words of a row.
const WORDS: f64 = 10.0;
/// Room between a thing and the row of its labels.
const NEAR: f64 = 4.0;

/// Direction in which rows follow each other on the page, y down.
const UP: f64 = -1.0;
pub(super) const DOWN: f64 = 1.0;

impl Painter<'_> {
    /// Forces and pressures on the top. Labels keep above `roof`, the top of what stands beside the body.
    pub(super) fn above(&mut self, roof: f64) {
        let crest = self.place(0.0, self.bounds.y1).1;
        let given = self.given;
        let first = given.pressures.len();
        let mut y = crest - 2.0;
        let stands = |arrow: &Arrow| !arrow.is_inside && arrow.towards.1 != 0.0;
        let arrows: Vec<_> = given.arrows.iter().enumerate().filter(|(_, arrow)| stands(arrow)).collect();
        let mut spots = Vec::new();
        for (index, arrow) in arrows {
            let x = self.place(self.near_body(arrow.at).0, 0.0).0;
            let top = self.place(0.0, self.top(self.near_body(arrow.at).0)).1;
            let (near, far) = ((x, top - 1.5), (x, top - 1.5 - self.force_length(arrow.size)));
            let (tail, tip) = if arrow.towards.1 < 0.0 { (far, near) } else { (near, far) };
            self.drawn.scene.arrow(tail, tip, Pen::solid(MARK, 2.0));
            self.drawn.arrows.push(SectionArrow { index, tail, tip });
            let text = self.force_words(first + index, arrow);
            spots.push(Spot {
                at: far,
                text,
                colour: MARK,
                of: Some(SectionNumber::Arrow(index)),
                lower: 0.0,
            });
            y = y.min(far.1);
        }
        if !spots.is_empty() {
            y = self.row(spots, y.min(roof), UP);
        }
        for (index, pressed) in given.pressures.iter().enumerate() {
            if pressed.face == Face::Top {
                y = self.pressure_along(index, pressed, y - APART, roof, UP);
            }
        }
    }

    /// A pressure on the base or the top as a diagram on a line of its own, beginning at `start`; gives where it ends.
    pub(super) fn pressure_along(
        &mut self,
        index: usize,
        pressed: &Pressed,
        start: f64,
        limit: f64,
        way: f64,
    ) -> f64 {
        let scale = self.pressure_scale();
        let reaches = |sign: f64| {
            pressed.points.iter().map(|(_, pressure, _)| sign * pressure * scale).fold(0.0, f64::max)
        };
        let (inwards, outwards) = (reaches(-1.0), reaches(1.0).max(8.0));
        let line = start + way * inwards;
        let left = self.given.base.0;
        let stalk = |(position, pressure, _): &(f64, f64, String)| {
            let x = self.place(left + position, 0.0).0;
            Stalk { foot: (x, line), tip: (x, line + way * pressure * scale), pressure: *pressure }
        };
        let stalks: Vec<_> = pressed.points.iter().map(stalk).collect();
        self.diagram(&stalks);
        let letter = Text::new(&format!("${}$", tag(index)), LABEL);
        let first = stalks.first().map_or(0.0, |stalk| stalk.foot.0);
        self.label(&letter, (first - 9.0, line + way * outwards / 2.0), INK);
        let spots = numbers(pressed).map(|i| Spot {
            at: stalks[i].tip,
            text: Text::verbatim(&pressed.points[i].2, LABEL),
            colour: INK,
            of: None,
            lower: 0.0,
        });
        let end = line + way * outwards;
        let end = if way < 0.0 { end.min(limit) } else { end.max(limit) };
        self.row(spots.collect(), end, way)
    }

    /// Labels in a row from `start` on, up or down; gives where the row ends.
    fn row(&mut self, mut spots: Vec<Spot>, start: f64, way: f64) -> f64 {
        standfast::order::by_number(&mut spots, |one| one.at.0);
        let wanted: Vec<_> = spots.iter().map(|spot| (spot.at.0, spot.text.width)).collect();
        let Some(places) = spread(&wanted, -ANYWHERE, ANYWHERE, WORDS) else { return start };
        let away =
            |spot: &Spot, x: f64| (spot.at.0 - x).abs() > MOVED || (spot.at.1 - start).abs() > 2.0 * APART;
        let moved = spots.iter().zip(&places).any(|(spot, x)| away(spot, *x));
        let near = start + way * if moved { APART } else { NEAR };
        let tall = spots.iter().map(|spot| spot.text.height()).fold(0.0, f64::max);
        for (spot, x) in spots.iter().zip(places) {
            if away(spot, x) {
                self.line(spot.at, (x, near - way * 2.0), THIN);
            }
            let rect = self.label(&spot.text, (x, near + way * tall / 2.0), spot.colour);
            self.drawn.numbers.extend(spot.of.map(|of| (of, rect)));
        }
        near + way * tall
    }

    /// Rows of widths, from `start` downwards.
    pub(super) fn widths(&mut self, start: f64) {
        let given = self.given;
        let mut y = start;
        let bears = given.reaction.as_ref().filter(|_| !self.look.on_screen);
        if let Some((ends, label)) =
            bears.and_then(|reaction| Some((reaction.pressed, reaction.width.as_ref()?)))
        {
            let measures = [Measure { ends, label: label.clone() }];
            y = self.row_of_widths(&measures, y, |_| None);
        }
        for (row, measures) in given.widths.iter().enumerate() {
            y = self.row_of_widths(measures, y, |place| Some(SectionNumber::Width(row, place)));
        }
    }

    /// A row of widths below `start`; gives where it ends.
    fn row_of_widths(
        &mut self,
        measures: &[Measure],
        start: f64,
        of: impl Fn(usize) -> Option<SectionNumber>,
    ) -> f64 {
        let y = start + 1.5 * APART;
        let mut spots = Vec::new();
        for (place, Measure { ends, label }) in measures.iter().enumerate() {
            let [from, to] = [ends.0, ends.1].map(|x| (self.place(x, 0.0).0, y));
            self.dimension(from, to);
            let (at, text) = (((from.0 + to.0) / 2.0, y), Text::verbatim(label, LABEL));
            self.drawn.ends.extend(of(place).map(|of| (of, to)));
            spots.push(Spot { at, text, colour: INK, of: of(place), lower: 0.0 });
        }
        self.row(spots, y + NEAR, DOWN)
    }
}
