//! A section cut into slices between the levels of its corners: where parts overlap, leave a gap or stand on nothing shows there, and
//! where the left and the right side run.

use super::polygon::{side, sides};
use super::{Part, SectionError, Vertex, slack};

/// Slice between two levels that hold no corner, cut across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slice {
    pub(super) bottom: f64,
    pub(super) top: f64,
    /// The left end at the bottom and at the top.
    pub(super) left: [f64; 2],
    /// The right end.
    pub(super) right: [f64; 2],
}

impl Slice {
    /// Part of the slice under a level.
    pub(super) fn below(&self, level: f64) -> Option<Slice> {
        if level <= self.bottom {
            return None;
        }
        let share = ((level - self.bottom) / (self.top - self.bottom)).min(1.0);
        let cut = |[bottom, top]: [f64; 2]| [bottom, bottom + share * (top - bottom)];
        Some(Slice { top: self.top.min(level), left: cut(self.left), right: cut(self.right), ..*self })
    }
}

/// Cut of a part by a level: from its left to its right side, at the bottom, in the middle and at the top of a slice.
struct Cut {
    part: usize,
    left: [f64; 3],
    right: [f64; 3],
}

/// The section cut into slices at all corners, which are in order if parts touch.
pub(super) fn slices(parts: &[Part], size: f64) -> Result<Vec<Slice>, SectionError> {
    let mut levels: Vec<f64> = parts.iter().flat_map(|part| &part.outline).map(|vertex| vertex.y).collect();
    levels.extend(crossings_between(parts));
    levels.sort_by(f64::total_cmp);
    levels.dedup_by(|next, before| *next - *before <= slack(size));
    let slices = levels.windows(2).map(|pair| slice(parts, pair[0], pair[1], size));
    let slices: Vec<Slice> = slices.collect::<Result<_, _>>()?;
    for pair in slices.windows(2) {
        let [under, over] = [pair[0], pair[1]];
        let (left, right) = (under.left[1].max(over.left[0]), under.right[1].min(over.right[0]));
        if right - left <= slack(size) {
            let x = (over.left[0] + over.right[0]) / 2.0;
            return Err(SectionError::Loose { at: Vertex { x, y: over.bottom } });
        }
    }
    Ok(slices)
}

/// The levels at which sides of different parts cross: parts that overlap, where a slice may not see it in its middle.
fn crossings_between(parts: &[Part]) -> Vec<f64> {
    let mut levels = Vec::new();
    for (i, one) in parts.iter().enumerate() {
        for two in &parts[i + 1..] {
            for (p, q) in sides(&one.outline) {
                for (r, s) in sides(&two.outline) {
                    let (a, b) = (side(p, q, r), side(p, q, s));
                    let (c, d) = (side(r, s, p), side(r, s, q));
                    if a * b < 0.0 && c * d < 0.0 {
                        levels.push(r.y + a / (a - b) * (s.y - r.y));
                    }
                }
            }
        }
    }
    levels
}

fn slice(parts: &[Part], bottom: f64, top: f64, size: f64) -> Result<Slice, SectionError> {
    let middle = (bottom + top) / 2.0;
    let mut cuts = Vec::new();
    for (part, Part { outline, .. }) in parts.iter().enumerate() {
        let crossed = sides(outline).filter(|(p, q)| (p.y < middle) != (q.y < middle));
        let mut crossed: Vec<[f64; 3]> = crossed
            .map(|(p, q)| [bottom, middle, top].map(|y| p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x)))
            .collect();
        crate::order::by_number(&mut crossed, |one| one[1]);
        let pairs = crossed.chunks_exact(2);
        cuts.extend(pairs.map(|pair| Cut { part, left: pair[0], right: pair[1] }));
    }
    crate::order::by_number(&mut cuts, |one| one.left[1]);
    for pair in cuts.windows(2) {
        let [one, two] = [&pair[0], &pair[1]];
        let apart = two.left[1] - one.right[1];
        let at = Vertex { x: (two.left[1] + one.right[1]) / 2.0, y: middle };
        if apart > slack(size) {
            return Err(SectionError::Gap { at, by: apart });
        }
        if apart < -slack(size) {
            let (first, second) = (one.part.min(two.part), one.part.max(two.part));
            // One within the other overlaps it by all of its width.
            let by = one.right[1].min(two.right[1]) - two.left[1];
            return Err(SectionError::Overlap { one: first, two: second, at, by });
        }
    }
    match (cuts.first(), cuts.last()) {
        (Some(first), Some(last)) => {
            let ends = |x: [f64; 3]| [x[0], x[2]];
            Ok(Slice { bottom, top, left: ends(first.left), right: ends(last.right) })
        }
        _ => {
            let x = parts[0].outline[0].x;
            Err(SectionError::Gap { at: Vertex { x, y: middle }, by: top - bottom })
        }
    }
}
