//! Boundaries between the verdicts of a plane: drawn where neighbours differ, as nothing is known of them but the strips of the regions.

use standfast::Verdict;
use standfast::region::{Curve, Strip};

use super::{Area, HEIGHT, Shaded};
use crate::canvas::Canvas;
use crate::pinned::{PINNED, arcs_beside, verticals_beside};
use crate::plot::{Arc, Piece, View, level};
use crate::scene::Pen;

/// What counts as one load factor, as a share of the window: far below a pixel.
const SAME: f64 = 1e-6;

/// A vertical boundary: load factor, and the μ it runs between.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Side {
    at: f64,
    low: f64,
    high: f64,
}

/// The μ at which the edges of a region begin, end, or change from one curve to another, within the plane.
pub(super) fn corners(strips: &[Strip], up_to: f64) -> Vec<f64> {
    let mut found = Vec::new();
    let edges = |strip: &Strip| [Some(strip.lower), strip.upper];
    let inner = |at: &f64| 0.0 < *at && *at < up_to;
    for (i, strip) in strips.iter().enumerate() {
        for (which, curve) in edges(strip).into_iter().enumerate() {
            let Some(curve) = curve else { continue };
            let follows =
                |other: Option<&Strip>| other.is_some_and(|other| edges(other)[which] == Some(curve));
            let before = i.checked_sub(1).and_then(|before| strips.get(before));
            let ends = [(strip.from, follows(before)), (strip.to, follows(strips.get(i + 1)))];
            let ends = ends.into_iter().filter(|(at, follows)| inner(at) && !follows);
            found.extend(ends.map(|(at, _)| curve.at(at)));
        }
    }
    found
}

/// Draws lines between different verdicts, and keeps labels off them.
pub(super) fn boundaries(canvas: &mut Canvas, regions: &[Shaded], areas: &[Area], pen: Pen) {
    let window = canvas.board.axes.view();
    canvas.arcs(edges(areas, &window), pen);
    let sides = sides(regions, areas, &window).into_iter();
    canvas.verticals(sides.map(|side| (side.at, side.low, side.high)), pen);
}

/// Draws those of another case, where they do not lie on lines that are drawn.
pub(super) fn pinned_boundaries(canvas: &mut Canvas, regions: &[Shaded], areas: &[Area]) {
    let window = canvas.board.axes.view();
    let arcs = arcs_beside(&canvas.board, edges(areas, &window));
    let sides = sides(regions, areas, &window).into_iter().map(|side| (side.at, side.low, side.high));
    let sides = verticals_beside(&canvas.board, sides.collect());
    canvas.arcs(arcs, PINNED);
    canvas.verticals(sides.into_iter(), PINNED);
}

/// The lower and upper edges of all areas, each once, as long as they run on.
pub(super) fn edges(areas: &[Area], window: &View) -> Vec<Arc> {
    let mut arcs: Vec<Arc> = Vec::new();
    let bare = |curve: &Curve| *curve == Curve::AXIS || *curve == level(window.mu_max);
    for edge in [|piece: &Piece| piece.lower, |piece: &Piece| piece.upper] {
        // What has been drawn from below need not be drawn from above.
        let drawn = arcs.clone();
        for piece in areas.iter().flat_map(|area| &area.pieces) {
            let (curve, middle) = (edge(piece), (piece.from + piece.to) / 2.0);
            let is_drawn = |arc: &Arc| arc.curve == curve && (arc.from..=arc.to).contains(&middle);
            if bare(&curve) || drawn.iter().any(is_drawn) {
                continue;
            }
            match arcs.iter_mut().find(|arc| arc.curve == curve && arc.to == piece.from) {
                Some(arc) => arc.to = piece.to,
                None => arcs.push(Arc { curve, from: piece.from, to: piece.to }),
            }
        }
    }
    arcs
}

/// The vertical stretches with different modes on their sides.
fn sides(regions: &[Shaded], areas: &[Area], window: &View) -> Vec<Side> {
    // Half a pixel.
    const SHORT: f64 = 0.5 / HEIGHT;
    let near = SAME * window.k_max;
    let mut places: Vec<f64> = regions.iter().flat_map(|region| &region.strips).map(|s| s.from).collect();
    places.retain(|at| near < *at && *at < window.k_max - near);
    places.sort_by(f64::total_cmp);
    places.dedup_by(|later, earlier| *later - *earlier <= near);

    let spans = |is_there: &dyn Fn(&Piece) -> bool, end: fn(&Piece) -> f64| -> Vec<(f64, f64, Verdict)> {
        let pieces = areas.iter().flat_map(|area| area.pieces.iter().map(|piece| (piece, area.verdict)));
        let there = pieces.filter(|(piece, _)| is_there(piece));
        there
            .map(|(piece, verdict)| (piece.lower.at(end(piece)), piece.upper.at(end(piece)), verdict))
            .collect()
    };
    let mut sides: Vec<Side> = Vec::new();
    for at in places {
        let left = spans(&|p| (p.to - at).abs() <= near && p.from < at - near, |p| p.to);
        let right = spans(&|p| (p.from - at).abs() <= near && p.to > at + near, |p| p.from);
        let verdict = |spans: &[(f64, f64, Verdict)], mu: f64| {
            spans.iter().find(|(low, high, _)| (*low..=*high).contains(&mu)).map(|(.., verdict)| *verdict)
        };
        let mut cuts: Vec<f64> = left.iter().chain(&right).flat_map(|(low, high, _)| [*low, *high]).collect();
        cuts.iter_mut().for_each(|mu| *mu = mu.clamp(0.0, window.mu_max));
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let [before, after] = [&left, &right].map(|spans| verdict(spans, (low + high) / 2.0));
            if before.is_none() || after.is_none() || before == after || low == high {
                continue;
            }
            match sides.last_mut() {
                Some(last) if (last.at, last.high) == (at, low) => last.high = high,
                _ => sides.push(Side { at, low, high }),
            }
        }
    }
    sides.retain(|side| side.high - side.low > SHORT * window.mu_max);
    sides
}

#[cfg(test)]
mod tests {
    use standfast::Wrench;
    use standfast::contact::{Block, plane};

    use super::*;
    use crate::LoadPlane;
    use crate::plane::{Plan, areas, window};

    /// The report's γ = 3, k′ = 0.8 as a load plane: λ is k.
    fn in_air() -> Vec<standfast::region::Region> {
        let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let force = Wrench { x: -1.0, p: 0.0, m: 0.8 * 3.0 };
        plane::regions(&Block::uniform(3.0, 0.3), &weight, &force, 2.0).expect("a valid block")
    }

    fn plane(regions: &[standfast::region::Region]) -> LoadPlane<'_> {
        LoadPlane { regions, base: None, uncertain: None, up_to: 2.0, friction: 0.3, stages: &[], title: "" }
    }

    #[test]
    fn in_air_the_one_vertical_is_the_report_s() {
        let regions = in_air();
        let given = plane(&regions);
        let given = Plan::of(&given, None);
        let window = window(&given);
        let sides = sides(&given.regions, &areas(&given.regions, &window), &window);
        let k_a = 1.0 / (3.0 * 1.8);
        assert_eq!(sides.len(), 1, "{sides:?}");
        assert!((sides[0].at - k_a).abs() < 1e-12 && (sides[0].low - k_a).abs() < 1e-9);
        assert_eq!(sides[0].high, window.mu_max);
    }

    #[test]
    fn lines_part_different_modes() {
        let regions = in_air();
        let given = plane(&regions);
        let given = Plan::of(&given, None);
        let window = window(&given);
        let mode = |k: f64, mu: f64| regions.iter().find(|region| region.contains(k, mu)).map(|r| r.mode);
        for arc in edges(&areas(&given.regions, &window), &window) {
            for share in [0.1, 0.5, 0.9] {
                let k = arc.from + share * (arc.to - arc.from);
                let mu = arc.curve.at(k);
                assert_ne!(mode(k, mu - 1e-6), mode(k, mu + 1e-6), "{arc:?}");
            }
        }
    }
}
