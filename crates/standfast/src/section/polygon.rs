//! Polygons: areas and their moments, sides that cross, and what lies on one side of a line.

use super::{SectionMass, Vertex};

/// ∫dA, ∫x dA, ∫y dA and ∫(x² + y²) dA; or the same times a density.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Areas {
    pub(super) area: f64,
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) polar: f64,
}

impl Areas {
    pub(super) fn add(&mut self, of: &Areas, density: f64) {
        self.area += density * of.area;
        self.x += density * of.x;
        self.y += density * of.y;
        self.polar += density * of.polar;
    }

    pub(super) fn less(&self, part: &Areas) -> Areas {
        let mut rest = *self;
        rest.add(part, -1.0);
        rest
    }

    /// Of areas times densities.
    pub(super) fn mass(&self) -> SectionMass {
        let centre = Vertex { x: self.x / self.area, y: self.y / self.area };
        let about_centre = self.polar - self.area * (centre.x * centre.x + centre.y * centre.y);
        SectionMass { mass: self.area, centre, moment_of_inertia: about_centre }
    }
}

pub(super) fn sides(outline: &[Vertex]) -> impl Iterator<Item = (Vertex, Vertex)> + '_ {
    outline.iter().copied().zip(outline.iter().copied().cycle().skip(1))
}

pub(super) fn areas(outline: &[Vertex]) -> Areas {
    let mut sum = Areas::default();
    for (p, q) in sides(outline) {
        let a = p.x * q.y - q.x * p.y;
        sum.area += a / 2.0;
        sum.x += (p.x + q.x) * a / 6.0;
        sum.y += (p.y + q.y) * a / 6.0;
        let squares = p.x * p.x + p.x * q.x + q.x * q.x + p.y * p.y + p.y * q.y + q.y * q.y;
        sum.polar += squares * a / 12.0;
    }
    sum
}

/// The size of what has these corners, m.
pub(super) fn extent<'a>(corners: impl Iterator<Item = &'a Vertex>) -> f64 {
    let mut ends = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    for Vertex { x, y } in corners {
        ends = [ends[0].min(*x), ends[1].max(*x), ends[2].min(*y), ends[3].max(*y)];
    }
    (ends[1] - ends[0]).max(ends[3] - ends[2]).max(0.0)
}

/// On which side of the line from p to q a place is: left above zero.
pub(super) fn side(p: Vertex, q: Vertex, at: Vertex) -> f64 {
    (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x)
}

/// Two sides of an outline that meet where they should not.
pub(super) fn crossing(outline: &[Vertex]) -> Option<(usize, usize)> {
    let n = outline.len();
    let sides: Vec<_> = sides(outline).collect();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let meets = |(i, j): &(usize, usize)| {
        let ((p, q), (r, s)) = (sides[*i], sides[*j]);
        let neighbours = *j == i + 1 || (*i == 0 && *j == n - 1);
        if neighbours {
            // They share a corner; they must not fold back, nor be of no length.
            let (before, shared, after) = if *j == i + 1 { (p, q, s) } else { (r, s, q) };
            let back = side(before, shared, after) == 0.0
                && (shared.x - before.x) * (after.x - shared.x)
                    + (shared.y - before.y) * (after.y - shared.y)
                    <= 0.0;
            return back;
        }
        let (a, b, c, d) = (side(p, q, r), side(p, q, s), side(r, s, p), side(r, s, q));
        let on = |p: Vertex, q: Vertex, at: Vertex, side: f64| {
            let within = |a: f64, b: f64, at: f64| a.min(b) <= at && at <= a.max(b);
            side == 0.0 && within(p.x, q.x, at.x) && within(p.y, q.y, at.y)
        };
        (a * b < 0.0 && c * d < 0.0) || on(p, q, r, a) || on(p, q, s, b) || on(r, s, p, c) || on(r, s, q, d)
    };
    pairs.into_iter().find(meets)
}

/// Part of an outline on one side of a straight line, where `above` is not above zero, by cutting its sides at the line.
pub(super) fn within(outline: &[Vertex], above: impl Fn(Vertex) -> f64) -> Vec<Vertex> {
    let mut cut = Vec::with_capacity(outline.len() + 2);
    for (p, q) in sides(outline) {
        let (of_p, of_q) = (above(p), above(q));
        if of_p <= 0.0 {
            cut.push(p);
        }
        if (of_p < 0.0) != (of_q < 0.0) && of_p != of_q {
            let share = of_p / (of_p - of_q);
            cut.push(Vertex { x: p.x + share * (q.x - p.x), y: p.y + share * (q.y - p.y) });
        }
    }
    cut
}
