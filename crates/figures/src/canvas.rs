//! A drawing under way: what is on the page already, and the labels, leaders and marks that keep off it.

use standfast::Verdict;

use crate::axes::Axes;
use crate::ground::arcs;
use crate::labels::{Board, Leader, Lines};
use crate::palette::{INK, MARK, PAPER, verdict_texture, verdict_tint};
use crate::plot::{Arc, Piece, arcs_path, outline};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture::{self, Texture};
use crate::{DesignPoint, is_drawable};

/// The type size of formulas and of the names of design points.
pub(crate) const FORMULA: f64 = 13.0;

/// A scene and the board that knows what is drawn in its plot.
pub(crate) struct Canvas {
    pub scene: Scene,
    pub board: Board,
    /// Light hatching over regions and their tints, which labels are laid on.
    pub hatched: Vec<(Vec<Piece>, &'static str)>,
}

impl Canvas {
    pub(crate) fn new(axes: Axes) -> Canvas {
        Canvas { scene: Scene::default(), board: Board::new(axes), hatched: Vec::new() }
    }

    /// Fills the region of a verdict; labels on its texture are laid on its tint.
    pub(crate) fn region(&mut self, pieces: &[Piece], verdict: Verdict) {
        let axes = self.board.axes;
        let tint = verdict_tint(verdict);
        self.scene.fill(&outline(&axes, pieces), tint);
        texture::over_pieces(&mut self.scene, &axes, pieces, verdict);
        if verdict_texture(verdict) != Texture::Plain {
            self.hatched.push((pieces.to_vec(), tint));
        }
    }

    /// Sets a label, if there is a place for it, and keeps others off.
    pub(crate) fn place(&mut self, text: &Text, place: Option<Rect>, colour: &str) -> bool {
        if let Some(rect) = place {
            let under = self.hatched.iter().find(|(pieces, _)| self.board.touches(pieces, &rect));
            if let Some(&(_, tint)) = under.filter(|_| self.board.off_lines(&rect, 1.5)) {
                self.patch(&rect, 1.5, tint);
            }
            self.board.reserve(rect);
            self.scene.text_in(text, &rect, colour);
        }
        place.is_some()
    }

    /// The letter of a point: beside it, or on a line rather than not at all.
    pub(crate) fn letter(&mut self, text: &Text, at: (f64, f64)) {
        const GAP: f64 = 5.0;
        let found = self.beside(at, text, GAP).or_else(|| self.board.over(at, text, GAP));
        self.place(text, found, INK);
        self.board.letters.extend(found);
    }

    /// Places the name of a design point as [`letter`](Canvas::letter) does, but never on a line.
    pub(crate) fn design_label(&mut self, text: &Text, at: (f64, f64)) -> bool {
        let found = self.beside(at, text, 8.0);
        // Two numbers side by side would read as one.
        found.iter().for_each(|rect| self.board.reserve(rect.grown(4.0)));
        self.place(text, found, MARK)
    }

    /// A place beside a point that is clear of all else, or farther away with a leader, which is drawn.
    fn beside(&mut self, at: (f64, f64), text: &Text, gap: f64) -> Option<Rect> {
        if let Some(rect) = self.board.beside(at, text, gap) {
            return Some(rect);
        }
        let size = (text.width, text.height());
        let near = |lines| self.board.near(at, gap - 1.5, size, 5, lines);
        let (rect, leader) = near(Lines::Avoid).or_else(|| near(Lines::Cross))?;
        self.leader(&leader);
        Some(rect)
    }

    /// Draws a leader and keeps labels off it.
    pub(crate) fn leader(&mut self, leader: &Leader) {
        self.scene.line(leader.from, leader.to, Pen::solid(INK, 0.6));
        self.board.reserve_leader(leader);
    }

    /// Clears the paper behind a label on hatching.
    fn patch(&mut self, rect: &Rect, margin: f64, colour: &str) {
        self.scene.fill(&Path::rectangle(&rect.grown(margin)), colour);
    }

    /// Draws parts of curves, and keeps labels off them.
    pub(crate) fn arcs(&mut self, arcs: Vec<Arc>, pen: Pen) {
        self.scene.stroke(&arcs_path(&self.board.axes, &arcs), pen);
        self.board.arcs.extend(arcs);
    }

    /// Draws upright lines at values between two others, and keeps labels off them.
    pub(crate) fn verticals(&mut self, lines: impl Iterator<Item = (f64, f64, f64)>, pen: Pen) {
        let axes = self.board.axes;
        let mut path = Path::default();
        for (at, low, high) in lines {
            let (x, top, bottom) = (axes.x(at), axes.y(high), axes.y(low));
            path.move_to(x, top);
            path.line_to(x, bottom);
            self.board.verticals.push((x, top, bottom));
        }
        self.scene.stroke(&path, pen);
    }

    /// Draws a line through values, and keeps labels off it.
    pub(crate) fn line(&mut self, points: &[(f64, f64)], pen: Pen) {
        let axes = self.board.axes;
        let places: Vec<_> = points.iter().map(|&(across, up)| axes.at(across, up)).collect();
        self.scene.stroke(&Path::through(&places), pen);
        let upright = places.windows(2).filter(|pair| (pair[1].0 - pair[0].0).abs() < 1e-6);
        self.board
            .verticals
            .extend(upright.map(|pair| (pair[0].0, pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1))));
        self.board.arcs.extend(arcs(points));
    }

    /// A dot that labels keep off, itself and the room about it.
    pub(crate) fn dot(&mut self, at: (f64, f64), radius: f64, room: f64) {
        self.scene.dot(at, radius, INK, None);
        self.board.reserve(Rect::around(at.0, at.1, room, room));
    }

    /// A design point.
    pub(crate) fn diamond(&mut self, (x, y): (f64, f64)) {
        let mut diamond = Path::through(&[(x, y - 5.2), (x + 5.2, y), (x, y + 5.2), (x - 5.2, y)]);
        diamond.close();
        self.scene.stroke(&diamond, Pen::solid(PAPER, 2.4));
        self.scene.fill(&diamond, MARK);
        self.board.reserve(Rect::around(x, y, 11.0, 11.0));
    }

    /// An arrow at the edge of the plot towards a design point outside.
    pub(crate) fn pointer(&mut self, (x, y): (f64, f64), to: (f64, f64)) {
        let (dx, dy) = (to.0 - x, to.1 - y);
        let (ux, uy) = (dx / dx.hypot(dy), dy / dx.hypot(dy));
        let corner = |along: f64, across: f64| (x + along * ux - across * uy, y + along * uy + across * ux);
        let mut arrow = Path::through(&[corner(6.5, 0.0), corner(-4.5, 5.2), corner(-4.5, -5.2)]);
        arrow.close();
        self.scene.stroke(&arrow, Pen::solid(PAPER, 2.4));
        self.scene.fill(&arrow, MARK);
        self.board.reserve(Rect::around(x, y, 11.0, 11.0));
    }

    /// A cloud of points, small and as one path.
    pub(crate) fn dots(&mut self, places: &[(f64, f64)]) {
        let mut path = Path::default();
        for &(x, y) in places {
            path.move_to(x, y);
            path.line_to(x + 0.1, y);
        }
        self.scene.stroke(&path, Pen { colour: MARK, width: 2.2, dashes: "0 9" });
    }

    /// Points without names, given as (k, μ), as far as the window shows them.
    pub(crate) fn cloud(&mut self, points: &[(f64, f64)]) {
        let axes = self.board.axes;
        let seen = points.iter().filter(|point| is_drawable(point) && axes.shows(point.0, point.1));
        let places: Vec<_> = seen.map(|&(k, mu)| axes.at(k, mu)).collect();
        self.dots(&places);
    }

    /// Design points with their names. What lies outside is pointed at from the nearest place of the edge. Gives the points that carry a
    /// number in place of their name, for want of room.
    pub(crate) fn design_points(&mut self, points: &[DesignPoint]) -> Vec<usize> {
        let axes = self.board.axes;
        let at = |point: &DesignPoint| {
            let ((x, y), Rect { x0, y0, x1, y1 }) = (axes.at(point.k, point.mu), axes.area.grown(-7.0));
            if axes.shows(point.k, point.mu) { (x, y) } else { (x.clamp(x0, x1), y.clamp(y0, y1)) }
        };
        for point in points.iter().filter(|point| point.is_drawable()) {
            if axes.shows(point.k, point.mu) {
                self.diamond(at(point));
            } else {
                self.pointer(at(point), axes.at(point.k, point.mu));
            }
        }
        let mut numbered = Vec::new();
        for (i, point) in points.iter().enumerate().filter(|(_, point)| point.is_drawable()) {
            let label = point.label.trim();
            if label.is_empty() || self.design_label(&Text::verbatim(label, FORMULA), at(point)) {
                continue;
            }
            // No room for the name: a number, which the caption explains.
            let number = Text::verbatim(&(i + 1).to_string(), FORMULA);
            if self.design_label(&number, at(point)) {
                numbered.push(i);
            }
        }
        numbered
    }

    /// Places the name of a line in a clear place along one of its arcs; false if there is none.
    pub(crate) fn beside_line(&mut self, arcs: &[Arc], text: &Text) -> bool {
        let place = arcs.iter().find_map(|arc| self.board.along(arc, text));
        self.place(text, place, INK)
    }

    /// Places the name of a line near one of some places on it, joined by a leader; false if there is no room.
    pub(crate) fn joined(&mut self, places: impl IntoIterator<Item = (f64, f64)>, text: &Text) -> bool {
        let size = (text.width, text.height());
        let found = places.into_iter().find_map(|to| self.board.near(to, 0.0, size, 6, Lines::Avoid));
        let Some((rect, leader)) = found else { return false };
        self.leader(&leader);
        self.place(text, Some(rect), INK)
    }

    /// Names a region: inside it, or beside it with a leader; not at all if it is too small to be seen. `patch` is the
    /// colour laid behind a name on hatching. True if it is named.
    pub(crate) fn name(&mut self, pieces: &[Piece], name: &str, largest: f64, patch: Option<&str>) -> bool {
        let Some((heart, width)) = self.board.heart(pieces) else { return false };
        if width < 1.0 {
            return false;
        }
        let sizes = [largest, 0.85 * largest];
        let fitting = sizes.into_iter().find_map(|size| {
            let text = Text::new(name, size);
            let rect = self.board.inside(pieces, text.width, text.height())?;
            Some((text, rect))
        });
        let (text, rect) = match fitting {
            Some(fitting) => fitting,
            None => {
                let text = Text::new(name, 0.85 * largest);
                let Some((rect, leader)) =
                    self.board.near(heart, 0.0, (text.width, text.height()), 13, Lines::Cross)
                else {
                    return false;
                };
                self.leader(&leader);
                self.scene.dot(heart, 1.3, INK, None);
                (text, rect)
            }
        };
        if let Some(colour) = patch {
            self.patch(&rect, 2.5, colour);
        }
        self.place(&text, Some(rect), INK)
    }
}
