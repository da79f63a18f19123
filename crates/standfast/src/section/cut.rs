//! A section cut at level joints: its pieces, what each weighs, where they touch, and what still water outside does to each.
//!
//! ```text
//!            ┌────────┐ ~~~~~~
//!            │ piece 2│        water on the ledge presses piece 1 down
//!     ┌──────┴─▲──▲───┴──┐
//!     │   piece 1        │     contact from the larger left end to the smaller right end
//!     └──────────────────┘
//! ```
//!
//! On a side that runs from (x₀, y₀) to (x₁, y₁), y₀ < y₁, water of the unit weight w up to the level l presses with
//!
//! ```text
//! F = w ∫(l − y) dy        at ȳ, and at the x of the side there        and downwards with F (x₁ − x₀)/(y₁ − y₀) on the left
//! ```

use super::polygon::within;
use super::slices::Slice;
use super::{Areas, Part, Section, SectionMass, Vertex, WaterTable, slack};

/// A piece of a section between two joints, or above the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// The joint below it, above the base, m.
    pub bottom: f64,
    /// The joint above it, or the crest.
    pub top: f64,
    /// What it weighs, per metre of length; places in the drawing.
    pub mass: SectionMass,
    /// The ends of the joint below it, m from the origin of the drawing.
    pub contact: [f64; 2],
}

/// A force at a place of the drawing, N per metre run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedForce {
    /// Place.
    pub at: Vertex,
    /// To the right.
    pub right: f64,
    /// Upwards.
    pub up: f64,
}

/// Reason why a section cannot be cut at a level.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CutError {
    /// A joint that is not inside the body.
    #[error("a joint at {level} m is not between the base and the crest, {crest} m above it")]
    OutsideBody {
        /// Its level, m.
        level: f64,
        /// The crest, m.
        crest: f64,
    },
    /// Two joints at one level.
    #[error("there are two joints at {level} m")]
    OneLevel {
        /// The level, m.
        level: f64,
    },
    /// Pieces that touch in a point.
    #[error("at {level} m the body above and the body below touch in a point")]
    NoContact {
        /// The level, m.
        level: f64,
    },
    /// A piece of cavities alone.
    #[error("the piece from {bottom} m to {top} m has no mass")]
    NoMass {
        /// Its lower end, m.
        bottom: f64,
        /// Its upper end, m.
        top: f64,
    },
}

impl Slice {
    /// Part of the slice between two levels.
    fn between(&self, from: f64, to: f64) -> Option<Slice> {
        let below = self.below(to)?;
        if from <= below.bottom {
            return Some(below);
        }
        let share = (from - below.bottom) / (below.top - below.bottom);
        let cut = |[bottom, top]: [f64; 2]| [bottom + share * (top - bottom), top];
        (share < 1.0).then(|| Slice { bottom: from, left: cut(below.left), right: cut(below.right), ..below })
    }
}

impl Section {
    /// The pieces between joints at these levels above the base (m), from the base up, with the parts under the water table wet.
    ///
    /// # Errors
    /// If a joint is outside the body or at the level of another, or what it parts touches in a point or has no mass.
    pub fn cut(&self, joints: &[f64], water: Option<WaterTable>) -> Result<Vec<Piece>, CutError> {
        let crest = self.height();
        let mut levels = joints.to_vec();
        levels.sort_by(f64::total_cmp);
        if let Some(level) = levels.iter().find(|level| !(0.0 < **level && **level < crest)) {
            return Err(CutError::OutsideBody { level: *level, crest });
        }
        if let Some(pair) = levels.windows(2).find(|pair| pair[1] - pair[0] <= slack(self.size)) {
            return Err(CutError::OneLevel { level: pair[0] });
        }
        let ends: Vec<f64> = [0.0].into_iter().chain(levels).chain([crest]).collect();
        ends.windows(2).map(|pair| self.piece(pair[0], pair[1], water)).collect()
    }

    /// All that is above a level, as one piece; see [`cut`](Section::cut).
    ///
    /// # Errors
    /// If the level is outside the body, or what it parts touches in a point, or has no mass.
    pub fn above(&self, level: f64, water: Option<WaterTable>) -> Result<Piece, CutError> {
        let crest = self.height();
        if !(0.0 < level && level < crest) {
            return Err(CutError::OutsideBody { level, crest });
        }
        self.piece(level, crest, water)
    }

    /// The left and the right end of all that is above a level, m from the origin of the drawing.
    pub fn ends_above(&self, level: f64) -> [f64; 2] {
        let above = || self.slices.iter().filter_map(|slice| slice.between(level, f64::INFINITY));
        let [left, right] = [|slice: Slice| slice.left, |slice: Slice| slice.right];
        [
            above().flat_map(left).fold(f64::INFINITY, f64::min),
            above().flat_map(right).fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// The level of the top at a place, m from the origin of the drawing: the highest there that is of the section; `None` beside it.
    pub fn top_at(&self, x: f64) -> Option<f64> {
        let has = |slice: &Slice, share: f64| {
            let at = |[bottom, top]: [f64; 2]| bottom + share * (top - bottom);
            at(slice.left) <= x + slack(self.size) && x - slack(self.size) <= at(slice.right)
        };
        // Where the side of a slice leaves the place.
        let highest = |slice: &Slice| {
            let crossing = |[bottom, top]: [f64; 2]| (x - bottom) / (top - bottom);
            let shares = [1.0, crossing(slice.left), crossing(slice.right), 0.0].into_iter();
            let inside = shares.filter(|share| (0.0..=1.0).contains(share) && has(slice, *share));
            inside.fold(None, |most: Option<f64>, share| Some(most.map_or(share, |most| most.max(share))))
        };
        self.slices.iter().rev().find_map(|slice| {
            let share = highest(slice)?;
            Some(slice.bottom + share * (slice.top - slice.bottom))
        })
    }

    /// Masses of what of each part is above a level, centres from the origin of the drawing; see [`masses`](Section::masses).
    pub fn masses_above(&self, level: f64, water: Option<WaterTable>) -> Vec<SectionMass> {
        let of = |part: &Part| {
            let outline = within(&part.outline, |at| level - at.y);
            let mut sum = Areas::default();
            if outline.len() > 2 {
                for (areas, density) in self.dry_and_wet(&Part { outline, ..*part }, water) {
                    sum.add(&areas, density);
                }
            }
            if sum.area > 0.0 {
                return sum.mass();
            }
            SectionMass { mass: 0.0, centre: Vertex { x: 0.0, y: level }, moment_of_inertia: 0.0 }
        };
        self.parts.iter().map(of).collect()
    }

    fn piece(&self, bottom: f64, top: f64, water: Option<WaterTable>) -> Result<Piece, CutError> {
        // From the middle of the body, so that nothing is lost where the drawing begins far away.
        let [left, right] = self.ends();
        let middle = (left + right) / 2.0;
        let centred = self.moved(-middle);
        let mut sum = Areas::default();
        for part in &centred.parts {
            let outline = within(&within(&part.outline, |at| bottom - at.y), |at| at.y - top);
            if outline.len() < 3 {
                continue;
            }
            for (areas, density) in centred.dry_and_wet(&Part { outline, ..*part }, water) {
                sum.add(&areas, density);
            }
        }
        if sum.area <= 0.0 {
            return Err(CutError::NoMass { bottom, top });
        }
        let mut mass = sum.mass();
        mass.centre.x += middle;
        let contact = self.contact(bottom).ok_or(CutError::NoContact { level: bottom })?;
        Ok(Piece { bottom, top, mass, contact })
    }

    /// The ends of the section just below and just above a level; at the base both are those above it.
    fn sides_at(&self, level: f64) -> [[f64; 2]; 2] {
        let above =
            self.slices.iter().find(|slice| level < slice.top - slack(self.size)).or(self.slices.last());
        let below = self.slices.iter().rev().find(|slice| slice.bottom + slack(self.size) < level);
        let at = |slice: &Slice| {
            let share = ((level - slice.bottom) / (slice.top - slice.bottom)).clamp(0.0, 1.0);
            [slice.left, slice.right].map(|[bottom, top]| bottom + share * (top - bottom))
        };
        let above = above.map_or(self.base(), at);
        [below.map_or(above, at), above]
    }

    /// Where what is above a level touches what is below.
    fn contact(&self, level: f64) -> Option<[f64; 2]> {
        let [below, above] = self.sides_at(level);
        let [left, right] = [below[0].max(above[0]), below[1].min(above[1])];
        (right - left > slack(self.size)).then_some([left, right])
    }

    /// What still water outside does to a piece: pressures on its sides, its ledges and its overhangs, but for those of its joints. `levels` are
    /// those of the water at the left and at the right, m above the base; `unit_weight` is in N/m³.
    pub fn water_on(&self, piece: &Piece, levels: [f64; 2], unit_weight: f64) -> Vec<PlacedForce> {
        let mut forces = Vec::new();
        let [bottom, top] = [piece.bottom, piece.top];
        for (place, level) in levels.into_iter().enumerate() {
            // Inwards from the left is to the right.
            let inwards = if place == 0 { 1.0 } else { -1.0 };
            let side = |slice: &Slice| if place == 0 { slice.left } else { slice.right };
            let under = self.slices.iter().filter_map(|slice| slice.between(bottom, top.min(level)));
            for slice in under.collect::<Vec<_>>() {
                let (height, depths) = (slice.top - slice.bottom, [level - slice.bottom, level - slice.top]);
                let force = unit_weight * height * (depths[0] + depths[1]) / 2.0;
                // From the bottom of the slice, as a share of its height.
                let share = (depths[0] + 2.0 * depths[1]) / (3.0 * (depths[0] + depths[1]));
                let [x0, x1] = side(&slice);
                let at = Vertex { x: x0 + share * (x1 - x0), y: slice.bottom + share * height };
                let down = inwards * force * (x1 - x0) / height;
                forces.push(PlacedForce { at, right: inwards * force, up: 0.0 - down });
            }
            // Steps inside it; its ledge at the joint above, its overhang at the one below. The crest is none.
            let near = |one: f64, other: f64| (one - other).abs() <= slack(self.size);
            let steps = self.slices.split_last().map_or(&[][..], |(_, others)| others);
            for y in steps.iter().map(|slice| slice.top).filter(|y| *y < level) {
                let [below, above] = self.sides_at(y);
                // How far the section draws back above the level; below zero it overhangs.
                let ledge = inwards * (above[place] - below[place]);
                let is_own = match () {
                    () if near(y, top) => ledge > 0.0,
                    () if near(y, bottom) => ledge < 0.0,
                    () => bottom < y && y < top,
                };
                if is_own && ledge != 0.0 {
                    let at = Vertex { x: (above[place] + below[place]) / 2.0, y };
                    forces.push(PlacedForce { at, right: 0.0, up: 0.0 - unit_weight * (level - y) * ledge });
                }
            }
        }
        forces
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::loads::{Load, StillWater};

    fn part(corners: &[(f64, f64)], density: f64, below: f64) -> Part {
        Part::new(corners.iter().map(|(x, y)| Vertex { x: *x, y: *y }).collect(), density, below).unwrap()
    }

    /// A footing, a stem that leans, a cavity in it, and a wider cap.
    fn wall() -> Section {
        Section::new(vec![
            part(&[(0.0, 0.0), (9.0, 0.0), (9.0, 1.5), (0.0, 1.5)], 2400.0, 2400.0),
            part(&[(2.0, 1.5), (4.0, 1.5), (4.0, 5.0), (2.5, 5.0)], 2300.0, 2300.0),
            part(&[(4.0, 1.5), (5.0, 1.5), (5.0, 5.0), (4.0, 5.0)], 0.0, 1000.0),
            part(&[(5.0, 1.5), (7.0, 1.5), (6.0, 5.0), (5.0, 5.0)], 2300.0, 2300.0),
            part(&[(2.0, 5.0), (7.0, 5.0), (6.5, 7.0), (3.0, 7.0)], 2400.0, 2400.0),
        ])
        .unwrap()
    }

    #[test]
    fn pieces_add_up_to_the_section() {
        let section = wall();
        for (joints, water) in [
            (vec![1.5, 5.0], None),
            (vec![5.0, 3.2, 1.5], Some(WaterTable { left: 2.0, right: 6.0 })),
            (vec![0.7, 4.9, 6.1], Some(WaterTable { left: 4.0, right: 4.0 })),
        ] {
            let pieces = section.cut(&joints, water).unwrap();
            assert_eq!(pieces.len(), joints.len() + 1);
            let whole = section.mass(water);
            let sum = |of: fn(&SectionMass) -> f64| pieces.iter().map(|piece| of(&piece.mass)).sum::<f64>();
            let mass = sum(|mass| mass.mass);
            let (x, y) =
                (sum(|mass| mass.mass * mass.centre.x) / mass, sum(|mass| mass.mass * mass.centre.y) / mass);
            let inertia: f64 = pieces
                .iter()
                .map(|Piece { mass, .. }| {
                    let (dx, dy) = (mass.centre.x - x, mass.centre.y - y);
                    mass.moment_of_inertia + mass.mass * (dx * dx + dy * dy)
                })
                .sum();
            for (found, expected) in [
                (mass, whole.mass),
                (x, whole.centre.x),
                (y, whole.centre.y),
                (inertia, whole.moment_of_inertia),
            ] {
                assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
            }
        }
    }

    #[test]
    fn pieces_touch_where_both_are() {
        let pieces = wall().cut(&[1.5, 3.25, 5.0], None).unwrap();
        let contacts: Vec<[f64; 2]> = pieces.iter().map(|piece| piece.contact).collect();
        // On the footing, through the stem half way up, under the cap, which overhangs both ways.
        assert_eq!(contacts, [[0.0, 9.0], [2.0, 7.0], [2.25, 6.5], [2.5, 6.0]]);
    }

    #[test]
    fn what_cannot_be_cut_is_said() {
        let said = |joints: &[f64]| wall().cut(joints, None).unwrap_err().to_string();
        assert!(said(&[0.0]).contains("a joint at 0 m is not between the base and the crest, 7 m above it"));
        assert!(said(&[1.0, 7.0]).contains("a joint at 7 m"));
        assert!(said(&[f64::NAN]).contains("NaN"));
        assert!(said(&[2.0, 2.0]).contains("two joints at 2 m"));
        let hollow = Section::new(vec![
            part(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)], 2000.0, 2000.0),
            part(&[(0.0, 1.0), (2.0, 1.0), (2.0, 2.0), (0.0, 2.0)], 0.0, 0.0),
        ])
        .unwrap();
        assert!(hollow.cut(&[1.0], None).unwrap_err().to_string().contains("from 1 m to 2 m has no mass"));
    }

    /// Sums of forces: to the right, upwards, and counter-clockwise about the origin.
    fn sums(forces: &[PlacedForce]) -> [f64; 3] {
        forces.iter().fold([0.0; 3], |[right, up, moment], force| {
            let turns = force.at.x * force.up - force.at.y * force.right;
            [right + force.right, up + force.up, moment + turns]
        })
    }

    /// Water on all pieces is that on the whole: pressures on its sides, and what stands on its steps and slopes.
    #[test]
    fn water_on_the_pieces_is_that_on_the_whole() {
        let (section, gravity, density) = (wall(), 9.81, 1025.0);
        let body = section.body(None, 1.0).unwrap();
        let middle = 4.5;
        for levels in [[6.5, 3.0], [5.0, 5.0], [1.0, 6.9], [0.0, 1.5]] {
            let water = StillWater::new(&body, levels[0], levels[1], density).unwrap();
            let loads = water.loads(&body, gravity);
            let sides = loads.into_iter().filter(|load| !load.is_water_under_base());
            let loads: Vec<Load> = sides.chain(section.water_on_sides(&body, &water, gravity)).collect();
            let centre = section.mass(None).centre;
            let expected = loads.iter().fold([0.0; 3], |sum, load| {
                let wrench = load.upright(&body, gravity);
                let about = wrench.m - centre.x * wrench.p - centre.y * wrench.x;
                [sum[0] + wrench.x, sum[1] - wrench.p, sum[2] + about]
            });
            assert!((body.centroid_offset() - (centre.x - middle)).abs() < 1e-9);
            for joints in [vec![1.5, 5.0], vec![0.4, 3.3, 6.0], vec![1.5], vec![2.0, 4.0]] {
                let pieces = section.cut(&joints, None).unwrap();
                let each = pieces.iter().flat_map(|piece| section.water_on(piece, levels, density * gravity));
                let found = sums(&each.collect::<Vec<_>>());
                for (one, other) in found.into_iter().zip(expected) {
                    assert!(
                        (one - other).abs() < 1e-6 * (1.0 + other.abs()),
                        "{levels:?} {joints:?} {found:?} {expected:?}"
                    );
                }
            }
        }
    }

    /// Archimedes: a piece with water of one level all around, in its joints as well, is lifted by the water that it displaces, at its centre.
    #[test]
    fn a_piece_in_water_is_lifted_by_what_it_displaces() {
        let (section, level, weight) = (wall(), 6.0, 1e4);
        for joints in [vec![1.5, 5.0], vec![1.0, 2.5, 4.0]] {
            let pieces = section.cut(&joints, None).unwrap();
            for (place, piece) in pieces.iter().enumerate() {
                let mut forces = section.water_on(piece, [level; 2], weight);
                let faces = [(1.0, Some(piece)), (-1.0, pieces.get(place + 1))];
                for (sign, joint) in faces.into_iter().filter_map(|(sign, joint)| Some((sign, joint?))) {
                    let [left, right] = joint.contact;
                    let at = Vertex { x: (left + right) / 2.0, y: joint.bottom };
                    let up = sign * weight * (level - joint.bottom).max(0.0) * (right - left);
                    forces.push(PlacedForce { at, right: 0.0, up });
                }
                let [right, up, moment] = sums(&forces);
                // The same piece as one of water, to the water's level.
                let lower = section.below(piece.bottom);
                let upper = section.below(piece.top.min(level));
                let area = upper.area - lower.area;
                let x = (upper.area * upper.x - lower.area * lower.x) / area;
                assert!(
                    right.abs() < 1e-6 && (up / (weight * area) - 1.0).abs() < 1e-9,
                    "{piece:?} {up} {area}"
                );
                assert!((moment / up - x).abs() < 1e-9, "{piece:?} {} {x}", moment / up);
            }
        }
    }
}
