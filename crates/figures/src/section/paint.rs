//! The body, and the order in which all is drawn.

use standfast::loads::Face;

use super::surroundings::Room;
use super::{
    Arrow, LABEL, MARGIN, Material, Mound, Outline, Painting, Section, SectionLook, Side, legend, tag,
};
use crate::axes::COLUMN;
use crate::below::verbatim;
use crate::caption::{READABLE, SMALL};
use crate::margins;
use crate::palette::{CONCRETE, FAINT, FILL, INK, MARK, PAPER};
use crate::pinned::PINNED;
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture;

/// Largest depth below the base at which the bed is drawn; a deeper one is drawn there.
const DEEPEST: f64 = 120.0;
/// Largest distance from the wall to which the berm is drawn.
const FARTHEST: f64 = 190.0;
/// Least width of the legend.
const LEGEND: f64 = COLUMN - 2.0 * MARGIN;

pub(super) const THIN: Pen = Pen::solid(FAINT, 0.7);

/// The line of thrust.
const THRUST: Pen = Pen { colour: MARK, width: 1.4, dashes: "5 3" };

/// Draws a section at an origin: the place of mid-width at the base.
pub(super) struct Painter<'a> {
    pub given: &'a Section<'a>,
    pub drawn: Painting,
    /// Units of the page for a metre.
    pub scale: f64,
    pub origin: (f64, f64),
    /// Room for water and ground, once it is known.
    pub room: Option<Room>,
    pub look: SectionLook<'a>,
    /// The bounds of all bodies that are drawn, m.
    pub bounds: Rect,
    /// The body's own, m.
    pub own: Rect,
    /// Edges that are drawn in dashes.
    pinned: Vec<[(f64, f64); 2]>,
    /// The bed, m above the base as it is drawn.
    pub bed: Option<f64>,
    /// Labels with their places, to be laid over all lines.
    labels: Vec<(Text, Rect, &'static str)>,
}

impl<'a> Painter<'a> {
    pub(super) fn new(
        given: &'a Section<'a>,
        look: SectionLook<'a>,
        shift: (f64, f64),
        room: Option<Room>,
    ) -> Painter<'a> {
        let corners = given.parts.iter().flat_map(|part| &part.vertices);
        let ends = [(given.base.0, 0.0), (given.base.1, 0.0)];
        let nothing = Rect { x0: f64::INFINITY, y0: 0.0, x1: f64::NEG_INFINITY, y1: 0.0 };
        let held = |bounds: Rect, &(x, y): &(f64, f64)| Rect {
            x0: bounds.x0.min(x),
            x1: bounds.x1.max(x),
            y1: bounds.y1.max(y),
            ..bounds
        };
        let own = corners.chain(&ends).fold(nothing, held);
        let pinned = look.pinned.map_or_else(Vec::new, |pinned| pinned.beside(given));
        let bounds = pinned.iter().flatten().fold(own, held);
        let scale = (look.body.0 / (bounds.x1 - bounds.x0)).min(look.body.1 / bounds.y1);
        let bed = given.mound.map(|mound| mound.bed.max(-DEEPEST / scale));
        let extent = Rect { x0: shift.0, y0: shift.1, x1: shift.0, y1: shift.1 };
        let scene = if look.on_screen { Scene::themed() } else { Scene::default() };
        let names = (shift.0, shift.0);
        let drawn = Painting {
            scene,
            extent,
            names,
            labels: Vec::new(),
            numbers: Vec::new(),
            ends: Vec::new(),
            arrows: Vec::new(),
        };
        Painter {
            given,
            drawn,
            scale,
            origin: shift,
            room,
            look,
            bounds,
            own,
            pinned,
            bed,
            labels: Vec::new(),
        }
    }

    /// Draws everything.
    pub(super) fn paint(mut self) -> Painting {
        self.surroundings();
        self.body();
        self.joints();
        self.pinned_body();
        let left = self.columns(Side::Left);
        let right = self.columns(Side::Right);
        self.above(left.top.min(right.top));
        let bottom = self.below(left.bottom.max(right.bottom));
        self.widths(bottom);
        self.inside();
        self.plan();
        self.labels();
        // On a screen the words stand beside the drawing, for people to choose.
        if !self.look.on_screen {
            self.legend();
        }
        self.drawn
    }

    /// Width of the body on the page.
    pub(super) fn width(&self) -> f64 {
        (self.bounds.x1 - self.bounds.x0) * self.scale
    }

    /// Place on the page of a place of the section.
    pub(super) fn place(&self, x: f64, y: f64) -> (f64, f64) {
        (self.origin.0 + x * self.scale, self.origin.1 - y * self.scale)
    }

    /// Sees that the page holds a rectangle.
    pub(super) fn hold(&mut self, rect: &Rect) {
        let extent = &mut self.drawn.extent;
        extent.x0 = extent.x0.min(rect.x0);
        extent.y0 = extent.y0.min(rect.y0);
        extent.x1 = extent.x1.max(rect.x1);
        extent.y1 = extent.y1.max(rect.y1);
    }

    pub(super) fn line(&mut self, from: (f64, f64), to: (f64, f64), pen: Pen) {
        self.hold(&Rect {
            x0: from.0.min(to.0),
            y0: from.1.min(to.1),
            x1: from.0.max(to.0),
            y1: from.1.max(to.1),
        });
        self.drawn.scene.line(from, to, pen);
    }

    /// A label around a point, to be drawn over all lines.
    pub(super) fn label(&mut self, text: &Text, centre: (f64, f64), colour: &'static str) -> Rect {
        let rect = Rect::around(centre.0, centre.1, text.width, text.height());
        self.hold(&rect);
        self.labels.push((text.clone(), rect, colour));
        rect
    }

    /// Draws the labels, each on a halo of paper.
    fn labels(&mut self) {
        let scene = &mut self.drawn.scene;
        let paper = scene.paint(PAPER).into_owned();
        // In units of the font, a thousand to the type size.
        scene.open(&format!(
            "stroke=\"{paper}\" stroke-width=\"240\" stroke-linejoin=\"round\" paint-order=\"stroke\""
        ));
        for (text, rect, colour) in self.labels.drain(..) {
            scene.text_in(&text, &rect, colour);
            self.drawn.labels.push(rect);
        }
        scene.close();
    }

    /// The labels that a horizontal line at `y` would strike through.
    pub(super) fn labels_at(&self, y: f64) -> impl Iterator<Item = &Rect> {
        self.labels.iter().map(|(_, rect, _)| rect).filter(move |rect| rect.y0 - 2.0 < y && y < rect.y1 + 2.0)
    }

    pub(super) fn touches(&self, rect: &Rect) -> bool {
        self.labels.iter().any(|(_, other, _)| other.overlaps(rect))
    }

    /// The level at which something is drawn: that of the bed at the lowest, and no farther above the body than a quarter of it, or than
    /// leaves room for numbers.
    pub(super) fn shown(&self, elevation: f64) -> f64 {
        const NUMBERS: f64 = 56.0;
        let top = self.bounds.y1;
        let elevation = elevation.min(top + (0.25 * top).max(NUMBERS / self.scale));
        self.bed.map_or(elevation, |bed| elevation.max(bed))
    }

    pub(super) fn polygon(&self, vertices: &[(f64, f64)]) -> Path {
        let mut path = Path::through(&vertices.iter().map(|&(x, y)| self.place(x, y)).collect::<Vec<_>>());
        path.close();
        path
    }

    /// How far the body reaches to a side at a height, m; its widest there where it has none.
    pub(super) fn face(&self, height: f64, out: f64) -> f64 {
        let widest = if out < 0.0 { self.bounds.x0 } else { self.bounds.x1 };
        // At a corner the part below counts.
        let level = height.min(self.bounds.y1) - 1e-6 * self.bounds.y1;
        let met = self.crossed(|(x, y)| (y, x), level);
        met.into_iter().reduce(|one, two| if (two - one) * out > 0.0 { two } else { one }).unwrap_or(widest)
    }

    /// The top of the body at a distance from mid-width, m above the base.
    pub(super) fn top(&self, x: f64) -> f64 {
        self.crossed(|corner| corner, x).into_iter().reduce(f64::max).unwrap_or(self.bounds.y1)
    }

    /// Where the outlines cross a line on which the first coordinate is `level`.
    fn crossed(&self, turned: impl Fn((f64, f64)) -> (f64, f64), level: f64) -> Vec<f64> {
        let mut met = Vec::new();
        for part in self.given.parts {
            let ends = part.vertices.iter().zip(part.vertices.iter().cycle().skip(1));
            for (one, other) in ends.map(|(one, other)| (turned(*one), turned(*other))) {
                if (one.0 > level) != (other.0 > level) {
                    met.push(one.1 + (level - one.0) / (other.0 - one.0) * (other.1 - one.1));
                }
            }
        }
        met
    }

    /// True if the bed, the end of the berm or a force lies farther off than it is drawn.
    fn is_cut(&self) -> bool {
        let mound = self.given.mound.is_some_and(|mound| {
            self.bed.is_some_and(|bed| bed > mound.bed) || self.berm_reach(&mound) < mound.berm_width
        });
        let wave = self.given.wave_crest.is_some_and(|crest| self.shown(crest) < crest);
        mound || wave || self.given.arrows.iter().any(|arrow| self.near_body(arrow.at) != arrow.at)
    }

    /// Place at which a force is drawn that may act far off: no farther from the body than half its size.
    pub(super) fn near_body(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let Rect { x0, y0, x1, y1 } = self.bounds;
        let (across, up) = ((x1 - x0) / 2.0, (y1 - y0) / 2.0);
        (x.clamp(x0 - across, x1 + across), y.clamp(y0 - up, y1 + up))
    }

    /// Width to which the berm is drawn, m.
    pub(super) fn berm_reach(&self, mound: &Mound) -> f64 {
        // On a screen the body is what the room is for.
        let body = (self.bounds.x1 - self.bounds.x0) * self.scale;
        let farthest = if self.look.on_screen { FARTHEST.min(0.4 * body) } else { FARTHEST };
        mound.berm_width.min(farthest / self.scale)
    }

    /// The parts, fill first, the corners and the centre of mass.
    fn body(&mut self) {
        let parts = || self.given.parts.iter();
        // Solids are drawn over the fill that they hold.
        let ordered = [Material::Cavity, Material::Fill, Material::Solid]
            .into_iter()
            .flat_map(|material| parts().filter(move |part| part.material == material));
        let ordered: Vec<&Outline> = ordered.collect();
        for part in ordered {
            let path = self.polygon(&part.vertices);
            let colour = match part.material {
                Material::Solid => CONCRETE,
                Material::Fill => FILL,
                Material::Cavity => PAPER,
            };
            self.drawn.scene.fill(&path, colour);
            if part.material == Material::Fill {
                let places: Vec<_> = part.vertices.iter().map(|&(x, y)| self.place(x, y)).collect();
                texture::grains(&mut self.drawn.scene, &places);
            }
            self.drawn.scene.stroke(&path, Pen::solid(INK, 1.5));
        }
        for (x, markup, out) in [(self.given.base.0, "$O$", -1.0), (self.given.base.1, "$O′$", 1.0)] {
            let corner = self.place(x, 0.0);
            self.drawn.scene.dot(corner, 2.2, INK, None);
            let text = Text::new(markup, LABEL);
            self.label(&text, (corner.0 + out * CORNER, corner.1 + CORNER), INK);
        }
        let Rect { x0, y0, x1, y1 } = self.bounds;
        let (low, high) = (self.place(x0, y0), self.place(x1, y1));
        self.hold(&Rect { x0: low.0, y0: high.1, x1: high.0, y1: low.1 });
    }

    /// The joints with their ends, the governing one heavy, and the line of thrust: where the resultant of all that is above each passes it.
    fn joints(&mut self) {
        /// A resultant is drawn no farther beside its joint, as a share of the width of the body.
        const BESIDE: f64 = 0.25;
        let joints = self.given.joints.clone();
        let Rect { x0, x1, .. } = self.own;
        let reach = BESIDE * (x1 - x0);
        let mut thrust: Vec<(f64, f64)> = Vec::new();
        for joint in &joints {
            let [from, to] = [joint.ends.0, joint.ends.1].map(|x| self.place(x, joint.elevation));
            if joint.number > 1 || joint.governs {
                self.line(from, to, Pen::solid(INK, if joint.governs { 4.5 } else { 1.8 }));
            }
            for end in [from, to] {
                self.drawn.scene.dot(end, 2.2, INK, None);
            }
            let within = joint.resultant.filter(|x| *x > x0 - reach && *x < x1 + reach);
            thrust.extend(within.map(|x| self.place(x, joint.elevation)));
        }
        for pair in thrust.windows(2) {
            self.line(pair[0], pair[1], THRUST);
        }
        for at in thrust {
            self.drawn.scene.dot(at, 3.0, MARK, Some(Pen::solid(PAPER, 1.0)));
        }
    }

    /// The body behind, in dashes.
    fn pinned_body(&mut self) {
        for [from, to] in self.pinned.clone() {
            self.line(self.place(from.0, from.1), self.place(to.0, to.1), PINNED);
        }
    }

    /// The centre of mass with the forces on it, and the names of the parts where there is room.
    fn inside(&mut self) {
        let centre = self.place(self.given.centroid.0, self.given.centroid.1);
        let mut taken = vec![Rect::around(centre.0, centre.1, 8.0, 8.0)];
        // No letter stands on a joint.
        taken.extend(self.given.joints.iter().filter(|joint| joint.number > 1).map(|joint| {
            let [(x0, y), (x1, _)] = [joint.ends.0, joint.ends.1].map(|x| self.place(x, joint.elevation));
            Rect { x0, x1, y0: y - 2.0, y1: y + 2.0 }
        }));
        let first = self.given.pressures.len();
        let mut lines: Vec<f64> = Vec::new();
        let arrows = self.given.arrows.iter().enumerate().filter(|(_, arrow)| arrow.is_inside);
        for (index, arrow) in arrows {
            let markup = format!("${}$", tag(first + index));
            let text = Text::new(&markup, LABEL);
            let at = self.near_body(arrow.at);
            let at = self.place(at.0, at.1);
            let mut from = at;
            if arrow.towards.1 != 0.0 {
                // Two that act along one line are drawn side by side.
                while lines.iter().any(|line| (line - from.0).abs() < BESIDE / 2.0) {
                    from.0 += BESIDE;
                }
                lines.push(from.0);
            }
            self.inner_arrow(arrow, from, &text, &mut taken);
        }
        self.drawn.scene.dot(centre, 2.6, INK, None);
        self.near(&Text::new("$C$", LABEL), (centre.0 - 10.0, centre.1 - 11.0), INK, &mut taken);
        for joint in self.given.joints.iter().filter(|joint| joint.number > 1) {
            let (x, y) = self.place(joint.ends.1, joint.elevation);
            self.near(&Text::new(&joint.number.to_string(), LABEL), (x - 10.0, y - 8.0), INK, &mut taken);
        }
        for part in self.given.parts.iter().filter(|part| !part.label.is_empty()) {
            self.part_name(part, &mut taken);
        }
    }

    /// The letter of a force, and its size where there is room.
    pub(super) fn force_words(&self, index: usize, arrow: &Arrow) -> Text {
        let size = if self.look.numbers { format!(" {}", arrow.label) } else { String::new() };
        Text::new(&format!("${}${size}", tag(index)), LABEL)
    }

    fn inner_arrow(&mut self, arrow: &Arrow, from: (f64, f64), text: &Text, taken: &mut Vec<Rect>) {
        /// Room for a letter beside the tip.
        const OFF: f64 = 10.0;
        let length = self.force_length(arrow.size);
        let tip = (from.0 + arrow.towards.0 * length, from.1 - arrow.towards.1 * length);
        self.drawn.scene.arrow(from, tip, Pen::solid(MARK, 2.0));
        self.hold(&Rect::around(tip.0, tip.1, 6.0, 6.0));
        let beside = if arrow.towards.1 == 0.0 { (tip.0, tip.1 - OFF) } else { (tip.0 + OFF, tip.1) };
        taken.push(Rect {
            x0: from.0.min(tip.0) - 4.0,
            y0: from.1.min(tip.1) - 4.0,
            x1: from.0.max(tip.0) + 4.0,
            y1: from.1.max(tip.1) + 4.0,
        });
        self.near(text, beside, MARK, taken);
    }

    /// A letter at a place, or as near to it as there is room.
    fn near(&mut self, text: &Text, place: (f64, f64), colour: &'static str, taken: &mut Vec<Rect>) {
        const AROUND: u32 = 16;
        const STEP: f64 = 4.0;
        let rings = (0_u32..).flat_map(|ring| (0..AROUND).map(move |i| (f64::from(ring) * STEP, i)));
        let mut places = rings.map(|(distance, i)| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
            Rect::around(place.0 + distance * cos, place.1 + distance * sin, text.width, text.height())
        });
        let others = || taken.iter().chain(self.labels.iter().map(|(_, rect, _)| rect));
        // The rings grow beyond all that is drawn.
        if let Some(rect) = places.find(|rect| !others().any(|other| other.overlaps(&rect.grown(2.5)))) {
            self.label(text, rect.centre(), colour);
            taken.push(rect);
        }
    }

    /// Writes a part's name into it: near its middle, where it is clear of its edges and of all else.
    fn part_name(&mut self, part: &Outline, taken: &mut Vec<Rect>) {
        const STEPS: u32 = 16;
        let text = Text::verbatim(&part.label, if self.look.on_screen { READABLE } else { SMALL });
        let corners: Vec<_> = part.vertices.iter().map(|&(x, y)| self.place(x, y)).collect();
        let ends = |of: fn(&(f64, f64)) -> f64| {
            let all = corners.iter().map(of);
            (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
        };
        let ((x0, x1), (y0, y1)) = (ends(|corner| corner.0), ends(|corner| corner.1));
        let middle = ((x0 + x1) / 2.0, (y0 + y1) / 2.0);
        let share = |i: u32| (f64::from(i) + 0.5) / f64::from(STEPS);
        let places = (0..STEPS * STEPS).map(|i| {
            let (x, y) = (x0 + (x1 - x0) * share(i % STEPS), y0 + (y1 - y0) * share(i / STEPS));
            Rect::around(x, y, text.width, text.height())
        });
        let fits = |rect: &Rect| {
            let Rect { x0, y0, x1, y1 } = rect.grown(3.0);
            let inside = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].iter().all(|&at| is_inside(&corners, at));
            inside && !taken.iter().any(|other| other.overlaps(&rect.grown(2.0))) && !self.touches(rect)
        };
        let far = |rect: &Rect| (rect.centre().0 - middle.0).hypot(rect.centre().1 - middle.1);
        let nearest = places.filter(fits).min_by(|one, other| far(one).total_cmp(&far(other)));
        if let Some(rect) = nearest {
            self.label(&text, rect.centre(), INK);
            taken.push(rect);
        } else {
            self.part_name_beside(&text, middle, taken);
        }
    }

    /// Writes a part's name beside the body with a leader to the part; not at all where there is no room.
    fn part_name_beside(&mut self, text: &Text, heart: (f64, f64), taken: &mut Vec<Rect>) {
        const AROUND: u32 = 24;
        const STEP: f64 = 6.0;
        const RINGS: u32 = 14;
        let bodies: Vec<Vec<(f64, f64)>> = self
            .given
            .parts
            .iter()
            .map(|part| part.vertices.iter().map(|&(x, y)| self.place(x, y)).collect())
            .collect();
        let base = self.place(0.0, 0.0).1;
        let places = (2..RINGS).flat_map(|ring| (0..AROUND).map(move |i| (f64::from(ring) * STEP, i)));
        let rects = places.map(|(distance, i)| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
            let (x, y) = (heart.0 + distance * cos, heart.1 - distance * sin);
            // It grows away from the part.
            let centre = x + cos.signum() * text.width / 2.0;
            Rect::around(centre, y, text.width, text.height())
        });
        let clear = |rect: &Rect| {
            let Rect { x0, y0, x1, y1 } = rect.grown(4.0);
            let across = |share: f64| (x0 + share * (x1 - x0), (y0 + y1) / 2.0);
            let points = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), across(0.25), across(0.5), across(0.75)];
            let outside = points.iter().all(|&at| !bodies.iter().any(|body| is_inside(body, at)));
            outside
                && y1 < base
                && !taken.iter().any(|other| other.overlaps(rect))
                && !self.touches(&rect.grown(2.0))
        };
        let Some(rect) = { rects }.find(clear) else { return };
        let from = (heart.0.clamp(rect.x0, rect.x1), heart.1.clamp(rect.y0, rect.y1));
        self.line(from, heart, THIN);
        self.drawn.scene.dot(heart, 1.3, INK, None);
        self.label(text, rect.centre(), INK);
        taken.push(rect);
    }

    /// The loads in words, and the sentences below them.
    fn legend(&mut self) {
        let Rect { x0, x1, y1, .. } = self.drawn.extent;
        let right = x1.max(x0 + LEGEND);
        let mut top = y1 + 14.0;
        for (index, line) in legend(self.given).iter().enumerate() {
            let tag = tag(index);
            let letter = Text::new(&format!("${tag}$"), SMALL);
            let words = verbatim(line[tag.len()..].trim_start(), SMALL);
            let colour = if index < self.given.pressures.len() { INK } else { MARK };
            self.drawn.scene.text(&letter, x0, top + 0.8 * SMALL, colour);
            top = margins::paragraph(&mut self.drawn.scene, &words, (x0 + INDENT, right), top, SMALL) + 2.0;
        }
        let cut = self.is_cut().then(|| CUT.to_owned());
        let pinned = self.look.pinned.map(|pinned| pinned.words() + ".");
        for note in self.given.notes.iter().cloned().chain(cut).chain(pinned) {
            top = margins::paragraph(&mut self.drawn.scene, &verbatim(&note, SMALL), (x0, right), top, SMALL)
                + 2.0;
        }
        self.hold(&Rect { x0, y0: y1, x1: right, y1: top });
    }
}

const CUT: &str = "What lies far off is drawn nearer than to scale; its numbers hold.";
/// Distance of the letters of the corners from them, along each axis.
const CORNER: f64 = 12.0;
/// The distance of forces within the body that act along one line.
const BESIDE: f64 = 24.0;
/// Distance of the words of the legend behind their letters.
const INDENT: f64 = 18.0;

/// True if a point lies in a polygon.
fn is_inside(corners: &[(f64, f64)], (x, y): (f64, f64)) -> bool {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed = edges
        .filter(|((x0, y0), (x1, y1))| (*y0 > y) != (*y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0));
    crossed.count() % 2 == 1
}

/// The side on which a face is; `None` for base and top.
pub(super) fn side_of(face: Face) -> Option<Side> {
    match face {
        Face::Left => Some(Side::Left),
        Face::Right => Some(Side::Right),
        Face::Base | Face::Top => None,
    }
}
