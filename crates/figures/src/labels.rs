//! Places of labels: on free paper, near what they name, never on another label.
//!
//! A [`Board`] knows what is drawn: arcs, straight lines and boxes. Curves are monotone, so whether a box touches one
//! takes two evaluations; a few thousand candidate places cost well under a millisecond.

use crate::axes::Axes;
use crate::plot::{Arc, Piece};
use crate::scene::Rect;
use crate::text::Text;

/// A thin line from a label to what it names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leader {
    pub from: (f64, f64),
    pub to: (f64, f64),
}

impl Leader {
    /// Small boxes along it, from the end at the named thing on, without that end itself.
    fn dots(&self) -> impl Iterator<Item = Rect> + use<> {
        let Leader { from, to } = *self;
        let count = ((from.0 - to.0).hypot(from.1 - to.1) / 2.0).ceil().max(1.0);
        (1..=count as u32).map(move |i| {
            let share = f64::from(i) / count;
            Rect::around(to.0 + share * (from.0 - to.0), to.1 + share * (from.1 - to.1), 2.2, 2.2)
        })
    }
}

/// Treatment of lines by a leader: to a region's inside it must cross them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lines {
    Cross,
    Avoid,
}

/// From a point to its letter: right and left above first.
const DIRECTIONS: [(f64, f64); 8] =
    [(1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)];
/// Between them.
const SLANTS: [(f64, f64); 8] =
    [(1.0, -0.4), (-1.0, -0.4), (1.0, 0.4), (-1.0, 0.4), (0.4, -1.0), (-0.4, -1.0), (0.4, 1.0), (-0.4, 1.0)];

/// Rectangles for a text around a point, at each distance in turn.
fn places_around((x, y): (f64, f64), text: &Text, distances: &[f64], directions: &[(f64, f64)]) -> Vec<Rect> {
    let place = |distance: f64, (dx, dy): (f64, f64)| {
        let reach = if dx != 0.0 && dy != 0.0 { 0.75 * distance } else { distance };
        let (cx, cy) = (x + dx * (reach + text.width / 2.0), y + dy * (reach + text.height() / 2.0));
        Rect::around(cx, cy, text.width, text.height())
    };
    distances.iter().flat_map(|&distance| directions.iter().map(move |&way| place(distance, way))).collect()
}

/// Everything a label has to keep clear of.
#[derive(Debug)]
pub(crate) struct Board {
    pub axes: Axes,
    pub arcs: Vec<Arc>,
    /// Vertical lines: x and the y they run between.
    pub verticals: Vec<(f64, f64, f64)>,
    /// Letters of points: with a name close by on the same line they would read as one word.
    pub letters: Vec<Rect>,
    boxes: Vec<Rect>,
}

impl Board {
    pub(crate) fn new(axes: Axes) -> Board {
        Board { axes, arcs: Vec::new(), verticals: Vec::new(), letters: Vec::new(), boxes: Vec::new() }
    }

    /// Keeps later labels off a rectangle.
    pub(crate) fn reserve(&mut self, rect: Rect) {
        self.boxes.push(rect);
    }

    /// True if a rectangle lies in the plot, `margin` away from all boxes.
    fn off_boxes(&self, rect: &Rect, margin: f64) -> bool {
        let grown = rect.grown(margin);
        let Rect { x0, .. } = self.axes.area;
        // The μ axis is a drawn line, the other edges of the plot are not.
        x0 + 4.0 < rect.x0
            && self.axes.area.contains(&rect.grown(1.5))
            && !self.boxes.iter().any(|other| other.overlaps(&grown))
    }

    /// True if a rectangle is `margin` away from all lines.
    pub(crate) fn off_lines(&self, rect: &Rect, margin: f64) -> bool {
        let Rect { x0, y0, x1, y1 } = rect.grown(margin);
        let (k0, k1, high, low) =
            (self.axes.across_at(x0), self.axes.across_at(x1), self.axes.up_at(y0), self.axes.up_at(y1));
        let on_arc =
            |arc: &Arc| arc.range(k0, k1).is_some_and(|(least, greatest)| least < high && greatest > low);
        let on_vertical = |&(x, top, bottom): &(f64, f64, f64)| x0 < x && x < x1 && top < y1 && bottom > y0;
        !self.arcs.iter().any(on_arc) && !self.verticals.iter().any(on_vertical)
    }

    /// True if a rectangle lies in the plot, `margin` away from all boxes and lines.
    pub(crate) fn clear(&self, rect: &Rect, margin: f64) -> bool {
        self.off_boxes(rect, margin) && self.off_lines(rect, margin)
    }

    /// True if a region's name in a rectangle reads apart from the letters of points.
    fn off_letters(&self, rect: &Rect) -> bool {
        const APART: (f64, f64) = (22.0, 9.0);
        let wide = Rect {
            x0: rect.x0 - APART.0,
            x1: rect.x1 + APART.0,
            y0: rect.y0 - APART.1,
            y1: rect.y1 + APART.1,
        };
        !self.letters.iter().any(|letter| letter.overlaps(&wide))
    }

    /// A place next to a point, clear of everything: eight directions, near first, then flatter and steeper ones.
    pub(crate) fn beside(&self, at: (f64, f64), text: &Text, gap: f64) -> Option<Rect> {
        let near = places_around(at, text, &[gap, gap + 3.0, gap + 7.0], &DIRECTIONS);
        let far = places_around(at, text, &[gap, gap + 3.0, gap + 7.0, gap + 12.0, gap + 16.0], &SLANTS);
        let clear =
            |margin: f64| move |rect: &&Rect| self.off_boxes(rect, 1.2) && self.off_lines(rect, margin);
        let found = near.iter().find(clear(1.2)).or_else(|| far.iter().find(clear(1.2)));
        found.or_else(|| near.iter().find(clear(0.2))).copied()
    }

    /// A place next to a point, on a line rather than not at all.
    pub(crate) fn over(&self, at: (f64, f64), text: &Text, gap: f64) -> Option<Rect> {
        let near = places_around(at, text, &[gap, gap + 3.0, gap + 7.0], &DIRECTIONS);
        near.into_iter().find(|rect| self.off_boxes(rect, 1.0))
    }

    /// The place inside a region with enough room around it that is nearest to the region's middle, for a box of
    /// this size; the place with the most room if there is not enough anywhere, and none if the box does not fit.
    pub(crate) fn inside(&self, pieces: &[Piece], across: f64, down: f64) -> Option<Rect> {
        const ACROSS: u32 = 28;
        const DOWN: u32 = 24;
        const ENOUGH: f64 = 15.0;
        let area = self.bounds(pieces)?;
        let (width, height) = (area.x1 - area.x0, area.y1 - area.y0);
        let place = |i: u32, j: u32| {
            let x = area.x0 + width * (f64::from(i) + 0.5) / f64::from(ACROSS);
            (x, area.y0 + height * (f64::from(j) + 0.5) / f64::from(DOWN))
        };
        let middle = self.middle(pieces);
        let off = |&(x, y): &(f64, f64)| (x - middle.0).powi(2) + (y - middle.1).powi(2);
        let mut places: Vec<_> = (0..ACROSS).flat_map(|i| (0..DOWN).map(move |j| (i, j))).collect();
        places.sort_by_cached_key(|&(i, j)| off(&place(i, j)) as u64);
        let mut best = None;
        let mut room = 3.0;
        for (i, j) in places {
            let (x, y) = place(i, j);
            let rect = Rect::around(x, y, across, down);
            let apart = self.off_letters(&rect);
            let fits =
                |margin: f64| apart && self.holds(pieces, &rect.grown(margin)) && self.clear(&rect, margin);
            while fits(room) {
                best = Some(rect);
                if room >= ENOUGH {
                    return best;
                }
                room += 1.0;
            }
        }
        best
    }

    /// The centre of a region's area on the page.
    fn middle(&self, pieces: &[Piece]) -> (f64, f64) {
        const SLICES: u32 = 16;
        let (mut area, mut x_moment, mut y_moment) = (0.0, 0.0, 0.0);
        for piece in pieces {
            let thin = (self.axes.x(piece.to) - self.axes.x(piece.from)) / f64::from(SLICES);
            for i in 0..SLICES {
                let k = piece.from + (piece.to - piece.from) * (f64::from(i) + 0.5) / f64::from(SLICES);
                let (top, bottom) = (self.axes.y(piece.upper.at(k)), self.axes.y(piece.lower.at(k)));
                let slice = thin * (bottom - top);
                area += slice;
                x_moment += slice * self.axes.x(k);
                y_moment += slice * (top + bottom) / 2.0;
            }
        }
        (x_moment / area, y_moment / area)
    }

    /// True if a rectangle on the page lies in a region.
    fn holds(&self, pieces: &[Piece], rect: &Rect) -> bool {
        /// A gap between pieces that is none, as a share of the window.
        const SEAM: f64 = 1e-6;
        if !self.axes.area.contains(rect) {
            return false;
        }
        let (k0, k1) = (self.axes.across_at(rect.x0), self.axes.across_at(rect.x1));
        let (low, high) = (self.axes.up_at(rect.y1), self.axes.up_at(rect.y0));
        let mut reached = k0;
        for piece in pieces.iter().filter(|piece| piece.to > k0 && piece.from < k1) {
            let (from, to) = (piece.from.max(k0), piece.to.min(k1));
            let lower = Arc { curve: piece.lower, from, to }.range(from, to);
            let upper = Arc { curve: piece.upper, from, to }.range(from, to);
            let inside =
                lower.is_some_and(|(_, most)| most <= low) && upper.is_some_and(|(least, _)| least >= high);
            if from > reached + SEAM * self.axes.view().width() || !inside {
                return false;
            }
            reached = to;
        }
        reached + SEAM * self.axes.view().width() >= k1
    }

    /// True if a corner, the middle of an edge, or the centre of a rectangle on the page lies in a region.
    pub(crate) fn touches(&self, pieces: &[Piece], rect: &Rect) -> bool {
        let (x, y) = rect.centre();
        let points = [rect.x0, x, rect.x1].into_iter().flat_map(|x| [rect.y0, y, rect.y1].map(|y| (x, y)));
        points.map(|(x, y)| (self.axes.across_at(x), self.axes.up_at(y))).any(|(k, mu)| {
            let holds = |piece: &Piece| {
                (piece.from..=piece.to).contains(&k) && (piece.lower.at(k)..=piece.upper.at(k)).contains(&mu)
            };
            pieces.iter().any(holds)
        })
    }

    fn bounds(&self, pieces: &[Piece]) -> Option<Rect> {
        let (first, last) = (pieces.first()?, pieces.last()?);
        let mut bounds = Rect {
            x0: self.axes.x(first.from),
            x1: self.axes.x(last.to),
            y0: f64::INFINITY,
            y1: f64::NEG_INFINITY,
        };
        for piece in pieces {
            for k in [piece.from, piece.to] {
                bounds.y0 = bounds.y0.min(self.axes.y(piece.upper.at(k)));
                bounds.y1 = bounds.y1.max(self.axes.y(piece.lower.at(k)));
            }
        }
        Some(bounds)
    }

    /// A point well inside a region, and the narrower of the region's extents there, in pixels.
    pub(crate) fn heart(&self, pieces: &[Piece]) -> Option<((f64, f64), f64)> {
        let width = self.bounds(pieces).map(|bounds| bounds.x1 - bounds.x0)?;
        let sample = |piece: &Piece, share: f64| {
            let k = piece.from + share * (piece.to - piece.from);
            let (top, bottom) = (self.axes.y(piece.upper.at(k)), self.axes.y(piece.lower.at(k)));
            ((self.axes.x(k), (top + bottom) / 2.0), (bottom - top).min(width))
        };
        pieces
            .iter()
            .flat_map(|piece| (1..12).map(move |i| sample(piece, f64::from(i) / 12.0)))
            .max_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// Free paper for a rectangle of this size near a point, and the leader that joins the two: rings of candidates,
    /// 12 pixels apart. The leader ends `reach` before the point, and runs over no label and, if `lines` says so, over no line.
    pub(crate) fn near(
        &self,
        to: (f64, f64),
        reach: f64,
        size: (f64, f64),
        rings: u32,
        lines: Lines,
    ) -> Option<(Rect, Leader)> {
        let ring = |radius: f64| {
            (0..16).map(move |i| {
                let angle = f64::from(i) * std::f64::consts::TAU / 16.0 - 1.0;
                let across = (radius + size.0 / 2.0) * angle.cos();
                Rect::around(to.0 + across, to.1 + (radius + size.1 / 2.0) * angle.sin(), size.0, size.1)
            })
        };
        let places = (1..=rings).flat_map(|step| ring(reach + 12.0 * f64::from(step)));
        // Drawn up to the label, a leader would lengthen the minus of a subscript; what is between belongs to it.
        let leader = |rect: &Rect, short: f64| {
            let Rect { x0, y0, x1, y1 } = rect.grown(short);
            let from = (to.0.clamp(x0, x1), to.1.clamp(y0, y1));
            let share = reach / (from.0 - to.0).hypot(from.1 - to.1).max(reach).max(f64::MIN_POSITIVE);
            Leader { from, to: (to.0 + share * (from.0 - to.0), to.1 + share * (from.1 - to.1)) }
        };
        let runs_free = |rect: &Rect| {
            let whole = leader(rect, 0.0);
            let on_box =
                whole.dots().any(|dot| self.boxes.iter().any(|other| other.overlaps(&dot.grown(1.5))));
            let on_line = || whole.dots().skip(1).any(|dot| !self.off_lines(&dot, 0.0));
            !on_box && (lines == Lines::Cross || !on_line())
        };
        let mut free = places.filter(|rect| self.clear(rect, 2.5) && runs_free(rect));
        free.next().map(|rect| (rect, leader(&rect, 3.5)))
    }

    /// Keeps later labels off a leader.
    pub(crate) fn reserve_leader(&mut self, leader: &Leader) {
        self.boxes.extend(leader.dots());
    }

    /// A place for a curve's formula: along it, on either side.
    pub(crate) fn along(&self, arc: &Arc, text: &Text) -> Option<Rect> {
        const PLACES: [f64; 13] = [0.6, 0.7, 0.5, 0.8, 0.4, 0.65, 0.55, 0.75, 0.3, 0.88, 0.45, 0.2, 0.1];
        let beside = |share: f64, gap: f64, side: f64, centred: f64| {
            let k = arc.from + share * (arc.to - arc.from);
            let (x, y) = self.axes.at(k, arc.curve.at(k));
            let step = (arc.to - arc.from) * 1e-3;
            let ahead = self.axes.at(k + step, arc.curve.at(k + step));
            let (dx, dy) = (ahead.0 - x, ahead.1 - y);
            // The normal on the asked side; the label's corner or edge touches its tip.
            let (nx, ny) = (side * dy / dx.hypot(dy), -side * dx / dx.hypot(dy));
            let across = if centred > 0.0 { 0.0 } else { nx.signum() * text.width / 2.0 };
            let (tip_x, tip_y) = (x + nx * gap, y + ny * gap);
            let rect = Rect::around(
                tip_x + across,
                tip_y + ny.signum() * text.height() / 2.0,
                text.width,
                text.height(),
            );
            // Nothing may run between the curve and its label.
            let (across, down) = (0.8 * nx.abs() * gap, 0.8 * ny.abs() * gap);
            let between = Rect::around(x + 0.6 * nx * gap, y + 0.6 * ny * gap, across, down);
            (rect, between)
        };
        for (gap, margin, apart) in [(6.0, 4.0, 14.0), (5.0, 2.5, 6.0), (12.0, 2.5, 2.5)] {
            for share in PLACES {
                for side in [1.0, -1.0] {
                    for centred in [1.0, 0.0] {
                        let (rect, between) = beside(share, gap, side, centred);
                        let free = self.off_boxes(&rect, apart) && self.off_lines(&rect, margin);
                        if free && self.off_lines(&between, 0.0) {
                            return Some(rect);
                        }
                    }
                }
            }
        }
        None
    }
}

/// Spreads labels along an edge: centres as near as possible to the wanted ones (least squares), `gap` between
/// labels, all between `low` and `high`. `wanted` holds (centre, length), sorted by centre. `None` if they cannot fit.
pub(crate) fn spread(wanted: &[(f64, f64)], low: f64, high: f64, gap: f64) -> Option<Vec<f64>> {
    let total: f64 = wanted.iter().map(|(_, length)| length + gap).sum();
    if total - gap > high - low {
        return None;
    }
    // Clusters of touching labels: first label, count, and start; a cluster sits at the mean of its members' wishes.
    struct Cluster {
        wishes: f64,
        count: f64,
        length: f64,
        start: f64,
    }
    let mut clusters: Vec<Cluster> = Vec::new();
    for &(centre, length) in wanted {
        let start = centre - length / 2.0;
        clusters.push(Cluster { wishes: start, count: 1.0, length, start });
        loop {
            let last = clusters.len() - 1;
            let cluster = &mut clusters[last];
            cluster.start = (cluster.wishes / cluster.count).clamp(low, (high - cluster.length).max(low));
            if last == 0 || clusters[last - 1].start + clusters[last - 1].length + gap <= clusters[last].start
            {
                break;
            }
            let joined = clusters.pop().expect("there are two");
            let before = &mut clusters[last - 1];
            before.wishes += joined.wishes - joined.count * (before.length + gap);
            before.count += joined.count;
            before.length += gap + joined.length;
        }
    }
    let mut centres = Vec::with_capacity(wanted.len());
    let mut labels = wanted.iter();
    for cluster in clusters {
        let mut at = cluster.start;
        for (_, length) in labels.by_ref().take(cluster.count as usize) {
            centres.push(at + length / 2.0);
            at += length + gap;
        }
    }
    Some(centres)
}

#[cfg(test)]
mod tests {
    use standfast::Diagram;

    use super::*;
    use crate::plot::{View, clip_strips};

    #[test]
    fn a_name_placed_in_a_region_lies_in_it() {
        for (slenderness, k_prime) in
            [(1.0, 0.4), (3.0, 0.8), (1.0, -0.6), (4.0, -0.3), (1.2, -1.7), (2.0, 0.0)]
        {
            let diagram = Diagram::new(slenderness, k_prime).expect("a valid body");
            let whole = diagram.window();
            let window = View::from_origin(whole.k, whole.mu);
            let axes = Axes::of(Rect { x0: 60.0, y0: 40.0, x1: 460.0, y1: 350.0 }, &window);
            let mut placed = 0;
            for region in diagram.regions() {
                let pieces = clip_strips(&region.strips, &window);
                let Some(rect) = Board::new(axes).inside(&pieces, 30.0, 12.0) else { continue };
                for (x, y) in [(rect.x0, rect.y0), (rect.x1, rect.y0), (rect.x0, rect.y1), (rect.x1, rect.y1)]
                {
                    assert_eq!(diagram.mode_at(axes.across_at(x), axes.up_at(y)), Ok(region.mode));
                }
                placed += 1;
            }
            assert!(placed >= 3, "{placed} names for γ = {slenderness}, k' = {k_prime}");
        }
    }

    #[test]
    fn labels_that_do_not_touch_stay_where_they_want_to_be() {
        assert_eq!(spread(&[(10.0, 4.0), (30.0, 4.0)], 0.0, 100.0, 2.0), Some(vec![10.0, 30.0]));
    }

    #[test]
    fn labels_that_touch_part_evenly_and_stay_within_the_edge() {
        assert_eq!(spread(&[(10.0, 8.0), (10.0, 8.0)], 0.0, 100.0, 2.0), Some(vec![5.0, 15.0]));
        assert_eq!(spread(&[(1.0, 8.0), (1.0, 8.0)], 0.0, 100.0, 2.0), Some(vec![4.0, 14.0]));
        assert_eq!(spread(&[(1.0, 8.0), (1.0, 8.0)], 0.0, 17.0, 2.0), None);
        assert_eq!(spread(&[(50.0, 10.0), (99.0, 8.0)], 0.0, 100.0, 0.0), Some(vec![50.0, 96.0]));
    }
}
