//! Stripes and dots over a tint: they tell a mode from its mirror image, ground that fails, and soil from what is solid, where colours
//! are not seen.

use crate::axes::Axes;
use crate::palette::{self, FAINT};
use crate::plot::{Fall, Piece, ruled};
use crate::scene::{Path, Pen, Scene};
use standfast::Verdict;

/// What lies over a tint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Texture {
    /// Nothing.
    Plain,
    /// Stripes that fall to the right.
    Stripes,
    /// Dots.
    Dots,
    /// Finer dots.
    Grains,
}

const STRIPES: (f64, Pen) = (6.0, Pen::solid(FAINT, 1.15));
const DOTS: (f64, Pen) = (8.0, Pen { colour: FAINT, width: 2.0, dashes: "0 8" });
const GRAINS: (f64, Pen) = (5.5, Pen { colour: FAINT, width: 1.0, dashes: "0 5.5" });

impl Texture {
    /// The direction of its lines, their distance and their pen.
    fn lines(self) -> Option<(Fall, f64, Pen)> {
        match self {
            Texture::Plain => None,
            Texture::Stripes => Some((Fall::Falling, STRIPES.0, STRIPES.1)),
            Texture::Dots => Some((Fall::Level, DOTS.0, DOTS.1)),
            Texture::Grains => Some((Fall::Level, GRAINS.0, GRAINS.1)),
        }
    }

    fn draw(self, scene: &mut Scene, segments: impl FnOnce(Fall, f64) -> Vec<Segment>) {
        let Some((fall, spacing, pen)) = self.lines() else { return };
        let mut path = Path::default();
        for (from, to) in segments(fall, spacing) {
            // Dots lie in columns, whatever the edges are.
            let is_dotted = matches!(self, Texture::Dots | Texture::Grains);
            let first = if is_dotted { (from.0 / spacing).ceil() * spacing } else { from.0 };
            if first <= to.0 {
                path.move_to(first, from.1);
                path.line_to(to.0.max(first + 0.01), to.1);
            }
        }
        scene.stroke(&path, pen);
    }
}

/// From and to on the page.
pub(crate) type Segment = ((f64, f64), (f64, f64));

/// Draws the texture of a verdict over the pieces of its region.
pub(crate) fn over_pieces(scene: &mut Scene, axes: &Axes, pieces: &[Piece], verdict: Verdict) {
    laid_over(scene, axes, pieces, palette::verdict_texture(verdict));
}

/// Draws a texture over the pieces of a region.
pub(crate) fn laid_over(scene: &mut Scene, axes: &Axes, pieces: &[Piece], texture: Texture) {
    texture.draw(scene, |fall, spacing| ruled(axes, pieces, spacing, fall));
}

/// Draws a texture over an area within outlines, less its holes.
pub(crate) fn laid_within(scene: &mut Scene, outlines: &[&[(f64, f64)]], texture: Texture) {
    texture.draw(scene, |fall, spacing| across(outlines, spacing, fall));
}

/// Draws the texture of a verdict over a polygon.
pub(crate) fn over_polygon(scene: &mut Scene, corners: &[(f64, f64)], verdict: Verdict) {
    laid_within(scene, &[corners], palette::verdict_texture(verdict));
}

/// Draws grains over a polygon: soil, and what is filled in.
pub(crate) fn grains(scene: &mut Scene, corners: &[(f64, f64)]) {
    laid_within(scene, &[corners], Texture::Grains);
}

/// Draws stripes over an area within outlines, less its holes.
pub(crate) fn stripes(scene: &mut Scene, outlines: &[&[(f64, f64)]]) {
    laid_within(scene, outlines, Texture::Stripes);
}

/// Lines across an area on the page, which lie where they lie for every area.
fn across(outlines: &[&[(f64, f64)]], spacing: f64, fall: Fall) -> Vec<Segment> {
    // How far below the line through the page's corner a point lies.
    let below = |(x, y): (f64, f64)| y - fall.slope() * x;
    let ends = outlines.iter().copied().flatten().map(|corner| below(*corner));
    let (least, most) =
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(at), most.max(at)));
    let mut segments = Vec::new();
    let first = (least / spacing).ceil();
    for step in 0..((most - least) / spacing + 1.0) as usize {
        let level = (first + step as f64) * spacing;
        let around = |corners: &'_ [(f64, f64)]| -> Vec<_> {
            corners.iter().copied().zip(corners.iter().copied().cycle().skip(1)).collect()
        };
        let edges = outlines.iter().flat_map(|corners| around(corners));
        let crossed = edges.filter_map(|(one, other)| {
            let (from, to) = (below(one) - level, below(other) - level);
            let share = from / (from - to);
            let mean = |a: f64, b: f64| a + share * (b - a);
            ((from > 0.0) != (to > 0.0)).then(|| (mean(one.0, other.0), mean(one.1, other.1)))
        });
        let mut places: Vec<(f64, f64)> = crossed.collect();
        standfast::order::by_number(&mut places, |one| one.0);
        segments.extend(places.chunks_exact(2).map(|pair| (pair[0], pair[1])));
    }
    segments
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stripes across a square begin and end on its edges, and are as far apart as they should be.
    #[test]
    fn lines_end_on_the_edges_of_a_polygon() {
        let square = [(1.0, 2.0), (13.0, 2.0), (13.0, 14.0), (1.0, 14.0)];
        let segments = across(&[&square], 6.0, Fall::Falling);
        // y − x runs from −11 to 13, with −6, 0, 6 and 12 among it.
        assert_eq!(segments.len(), 4, "{segments:?}");
        for (from, to) in segments {
            assert!((to.0 - from.0 - (to.1 - from.1)).abs() < 1e-12);
            for (x, y) in [from, to] {
                let is_on_edge = [x - 1.0, x - 13.0, y - 2.0, y - 14.0].iter().any(|off| off.abs() < 1e-12);
                assert!(is_on_edge && ((y - x) / 6.0).fract().abs() < 1e-12, "({x}, {y})");
            }
        }
        assert_eq!(across(&[&square], 6.0, Fall::Level).len(), 2);
        // A hole parts a line in two.
        let hole = [(5.0, 5.0), (9.0, 5.0), (9.0, 11.0), (5.0, 11.0)];
        assert_eq!(across(&[&square, &hole], 6.0, Fall::Level).len(), 3);
    }
}
