//! A cross-section of parts: what it weighs, where, and what stands in water of it.
//!
//! ```text
//!          ┌──────┐            y ▲
//!          │ wall │ ~~~~~~       │    frame of the drawing: x from any
//!    ~~~~~~│      │  water       └──► origin, y from the base
//!    ┌─────┴──────┴───┐
//!    │    footing     │
//!    O────────────────O'
//! ```
//!
//! Of a polygon with the corners (x_i, y_i), counter-clockwise, with a_i = x_i y_{i+1} − x_{i+1} y_i (Green's theorem)
//!
//! ```text
//! A    = Σ a_i / 2
//! A x̄  = Σ (x_i + x_{i+1}) a_i / 6                        and ȳ alike
//! J_0  = Σ (x_i² + x_i x_{i+1} + x_{i+1}² + y_i² + y_i y_{i+1} + y_{i+1}²) a_i / 12
//! ```
//!
//! J_0 about the origin; I = Σ ρ J_0 − m |C|² about the centre of mass.
//!
//! Parts touch: they neither overlap nor leave gaps, so that a horizontal cut through the body is one piece, with one left and
//! one right end, x_l(y) and x_r(y). A cavity is a part of density 0. What water stands on the left of the body, above its
//! sloping side and its steps, presses down with
//!
//! ```text
//! V = ρ g ∫ (x_l − x_O) dy        M_O = ρ g ∫ (x_l² − x_O²)/2 dy        from 0 to its level
//! ```
//!
//! (x from O; upwards where the body overhangs), and sideways as on an upright wall. The right is its mirror image.

mod cut;
mod polygon;
mod slices;

pub use cut::{CutError, Piece, PlacedForce};

use crate::ball::COMPUTED;
use crate::body::{BaseEdges, Body};
use crate::error::InputError;
use crate::loads::{Action, BodyPoint, Load, LoadKind, LoadSource, StillWater};

use polygon::{Areas, areas, crossing, extent, within};
use slices::{Slice, slices};

/// A corner of a part's outline, m: to the right of the origin of the drawing, and above the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// To the right.
    pub x: f64,
    /// Above the base.
    pub y: f64,
}

/// A part of a section, all of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    outline: Vec<Vertex>,
    density: f64,
    density_below_water: f64,
}

/// Under which line the parts of a body are wet: straight from where the water at the left meets it to where that at the right
/// does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaterTable {
    /// Above the base at the left of the body, m.
    pub left: f64,
    /// Above the base at the right.
    pub right: f64,
}

/// Reason why an outline is no part, or parts are no section.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionError {
    /// A number that no length or density can be.
    #[error(transparent)]
    Input(#[from] InputError),
    /// Fewer than three corners, or corners in a line.
    #[error("the outline encloses no area")]
    NoArea,
    /// Sides that cross or touch.
    #[error("its sides {one} and {two} cross or touch")]
    Crossing {
        /// The side that begins at this corner, counted from one.
        one: usize,
        /// The other.
        two: usize,
    },
    /// A part that lies below the base, y = 0.
    #[error("it reaches {depth} m below the base, y = 0")]
    BelowBase {
        /// Depth below the base, m.
        depth: f64,
    },
    /// No part stands on the base along a length.
    #[error("the lowest part is {height} m above the base, y = 0, or touches it in a point")]
    NotOnBase {
        /// Of the lowest corner, m.
        height: f64,
    },
    /// Two parts in one place.
    #[error("parts {one} and {two} overlap at {at:?}")]
    Overlap {
        /// A part, counted from zero.
        one: usize,
        /// The other.
        two: usize,
        /// A place that both have.
        at: Vertex,
        /// Width of the overlap, m.
        by: f64,
    },
    /// A place between parts, or above them, that is in none.
    #[error("between parts there is a gap at {at:?}")]
    Gap {
        /// A place in it.
        at: Vertex,
        /// Width of the gap, or its height where nothing is beside it, m.
        by: f64,
    },
    /// Parts that stand on nothing, or on a corner.
    #[error("what lies above {at:?} stands on nothing")]
    Loose {
        /// A place on their underside.
        at: Vertex,
    },
}

impl Part {
    /// A part with an outline, its corners one after the other in either sense, a density (kg/m³) where it is dry and one
    /// where it is under water. A cavity has density 0.
    ///
    /// # Errors
    /// If a number is not finite, a density is below zero, the outline encloses no area or crosses itself.
    pub fn new(
        mut outline: Vec<Vertex>,
        density: f64,
        density_below_water: f64,
    ) -> Result<Part, SectionError> {
        use crate::quantity::Quantity;
        for vertex in &outline {
            InputError::finite(Quantity::PartCorner, vertex.x)?;
            InputError::finite(Quantity::PartCorner, vertex.y)?;
        }
        let density = InputError::not_negative(Quantity::Density, density)?;
        let density_below_water = InputError::not_negative(Quantity::Density, density_below_water)?;
        if outline.len() > 1 && outline.first() == outline.last() {
            // A polygon that is closed by its first corner.
            outline.pop();
        }
        let size = extent(outline.iter());
        let area = areas(&outline).area;
        if outline.len() < 3 || area.abs() <= ROUNDING * size * size {
            return Err(SectionError::NoArea);
        }
        if let Some((one, two)) = crossing(&outline) {
            return Err(SectionError::Crossing { one: one + 1, two: two + 1 });
        }
        if area < 0.0 {
            outline.reverse();
        }
        Ok(Part { outline, density, density_below_water })
    }

    /// The area it encloses, m².
    pub fn area(&self) -> f64 {
        areas(&self.outline).area
    }

    /// Its corners, counter-clockwise.
    pub fn outline(&self) -> &[Vertex] {
        &self.outline
    }

    /// Outlines of what lies above a level and below it, m; one that is empty has fewer than three corners.
    pub fn cut_at(&self, level: f64) -> [Vec<Vertex>; 2] {
        [within(&self.outline, |at| level - at.y), within(&self.outline, |at| at.y - level)]
    }

    /// Density where it is dry, kg/m³.
    pub fn density(&self) -> f64 {
        self.density
    }

    /// Density where it is under water, kg/m³.
    pub fn density_below_water(&self) -> f64 {
        self.density_below_water
    }
}

/// A cross-section of parts that stand on a level base.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    parts: Vec<Part>,
    slices: Vec<Slice>,
    size: f64,
}

/// The part of a section that lies under a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Submerged {
    /// m².
    pub area: f64,
    /// Its centre to the right of the origin of the drawing, m; zero without an area.
    pub x: f64,
}

/// Mass, centre and inertia of a section, per metre of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionMass {
    /// kg/m.
    pub mass: f64,
    /// The centre of mass.
    pub centre: Vertex,
    /// About it, kg m²/m.
    pub moment_of_inertia: f64,
}

/// Areas, mass, centre and inertia of a part, per metre of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartMass {
    /// The area above the water table, or the whole where its density is the same below, m².
    pub dry: f64,
    /// The area below, m².
    pub wet: f64,
    /// kg/m.
    pub mass: f64,
    /// The centre of mass.
    pub centre: Vertex,
    /// About it, kg m²/m.
    pub moment_of_inertia: f64,
}

/// Error of lengths by rounding, as a share of the section's size.
const ROUNDING: f64 = 1e-9;

/// Distance, or overlap, up to which outlines touch, m: as drawings are given, to the millimetre; of a section less than a metre large, a
/// thousandth of that.
fn slack(size: f64) -> f64 {
    1e-3 * size.min(1.0)
}

impl Section {
    /// A section of parts.
    ///
    /// # Errors
    /// If they do not stand on the base y = 0 along a length, or overlap, or leave gaps.
    pub fn new(parts: Vec<Part>) -> Result<Section, SectionError> {
        let size = extent(parts.iter().flat_map(|part| &part.outline));
        let corners = || parts.iter().flat_map(|part| &part.outline);
        let lowest = corners().map(|vertex| vertex.y).fold(f64::INFINITY, f64::min);
        if lowest < -slack(size) {
            return Err(SectionError::BelowBase { depth: 0.0 - lowest });
        }
        if parts.is_empty() || lowest > slack(size) {
            return Err(SectionError::NotOnBase { height: lowest });
        }
        let slices = slices(&parts, size)?;
        if slices.is_empty() {
            // Parts so flat that their bottoms and tops are one level.
            return Err(SectionError::NoArea);
        }
        let section = Section { parts, slices, size };
        let [left, right] = section.base();
        if right - left <= slack(size) {
            return Err(SectionError::NotOnBase { height: lowest });
        }
        Ok(section)
    }

    /// The parts.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The left and the right end of all parts, m.
    pub fn ends(&self) -> [f64; 2] {
        let x = || self.parts.iter().flat_map(|part| &part.outline).map(|vertex| vertex.x);
        [x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The corners of the base O and O', m from the origin of the drawing.
    pub fn base(&self) -> [f64; 2] {
        let lowest = self.slices[0];
        [lowest.left[0], lowest.right[0]]
    }

    /// Of the highest corner above the base, m.
    pub fn height(&self) -> f64 {
        self.slices.last().map_or(0.0, |slice| slice.top)
    }

    /// The area of all parts, m².
    pub fn area(&self) -> f64 {
        self.parts.iter().map(Part::area).sum()
    }

    /// Area under a level, cavities with it: the area that displaces water.
    pub fn below(&self, level: f64) -> Submerged {
        let slices = self.slices.iter().filter_map(|slice| slice.below(level));
        let sum = slices.fold((0.0, 0.0), |(area, moment), slice| {
            let thickness = slice.top - slice.bottom;
            let [l, r] = [slice.left, slice.right];
            let squares = |[a, b]: [f64; 2]| a * a + a * b + b * b;
            (
                area + thickness * (r[0] - l[0] + r[1] - l[1]) / 2.0,
                moment + thickness * (squares(r) - squares(l)) / 6.0,
            )
        });
        let (area, moment) = sum;
        Submerged { area, x: if area == 0.0 { 0.0 } else { moment / area } }
    }

    /// Its mass with the parts under the water table wet, or with all dry.
    pub fn mass(&self, water: Option<WaterTable>) -> SectionMass {
        let mut sum = Areas::default();
        for part in &self.parts {
            for (areas, density) in self.dry_and_wet(part, water) {
                sum.add(&areas, density);
            }
        }
        sum.mass()
    }

    /// Masses of its parts one by one, centres counted from mid-width. A cavity has its centre where its area has it.
    pub fn masses(&self, water: Option<WaterTable>) -> Vec<PartMass> {
        let [left, right] = self.ends();
        // As in `body`, so that they add up to its.
        self.moved(-(left + right) / 2.0).masses_here(water)
    }

    fn masses_here(&self, water: Option<WaterTable>) -> Vec<PartMass> {
        let masses = self.parts.iter().map(|part| {
            let [(dry, density), (wet, below)] = self.dry_and_wet(part, water);
            let mut sum = Areas::default();
            sum.add(&dry, density);
            sum.add(&wet, below);
            let weightless = sum.area == 0.0;
            let SectionMass { mass, centre, moment_of_inertia } =
                if weightless { areas(&part.outline).mass() } else { sum.mass() };
            let [mass, moment_of_inertia] = if weightless { [0.0; 2] } else { [mass, moment_of_inertia] };
            PartMass { dry: dry.area, wet: wet.area, mass, centre: self.middled(centre), moment_of_inertia }
        });
        masses.collect()
    }

    /// Dry and wet area of a part, with the density of each; all is dry where both are the same.
    fn dry_and_wet(&self, part: &Part, water: Option<WaterTable>) -> [(Areas, f64); 2] {
        let whole = areas(&part.outline);
        let wet = match water.filter(|_| part.density != part.density_below_water) {
            Some(water) => self.wet(part, water),
            None => Areas::default(),
        };
        [(whole.less(&wet), part.density), (wet, part.density_below_water)]
    }

    /// Area of a part under the water table.
    fn wet(&self, part: &Part, water: WaterTable) -> Areas {
        let flat = |level: f64| move |at: Vertex| at.y - level;
        if water.left == water.right {
            return areas(&within(&part.outline, flat(water.left)));
        }
        let [left, right] = [self.ends_at(water.left)[0], self.ends_at(water.right)[1]];
        let slope = (water.right - water.left) / (right - left);
        let sloping = move |at: Vertex| at.y - water.left - slope * (at.x - left);
        // Beside the water table is open water, as high as it stands there.
        let at_left = within(&within(&part.outline, move |at| at.x - left), flat(water.left));
        let at_right = within(&within(&part.outline, move |at| right - at.x), flat(water.right));
        let between = within(&within(&part.outline, move |at| left - at.x), move |at| at.x - right);
        let mut sum = areas(&within(&between, sloping));
        sum.add(&areas(&at_left), 1.0);
        sum.add(&areas(&at_right), 1.0);
        sum
    }

    /// Points at which a level cuts the left and the right side; above the section, its ends at the top.
    fn ends_at(&self, level: f64) -> [f64; 2] {
        let slice = self.slices.iter().find(|slice| level <= slice.top).or(self.slices.last());
        let cut = slice.and_then(|slice| slice.below(level.max(slice.bottom + ROUNDING * self.size)));
        cut.map_or(self.ends(), |slice| [slice.left[1], slice.right[1]])
    }

    /// The body of this section, `length` long out of the plane (m; 1 for a body per metre run), with the parts under the water
    /// table wet.
    ///
    /// # Errors
    /// If it has no mass, the length is none, or its centre of mass does not lie between the corners of the base.
    pub fn body(&self, water: Option<WaterTable>, length: f64) -> Result<Body, InputError> {
        let ([left, right], height) = (self.ends(), self.height());
        // From the middle of the body, so that nothing is lost where the drawing begins far away.
        let middle = (left + right) / 2.0;
        let centred = self.moved(-middle);
        let SectionMass { mass, centre, moment_of_inertia } = centred.mass(water);
        let centre = self.middled(centre);
        let body = Body::new(right - left, height, mass * length)?.with_length(length)?;
        if self.is_uniform() {
            // As the report's body, to the last bit.
            return Ok(body);
        }
        // The base of a body that is as wide as it has the body's corners, and not those but for rounding.
        let half = body.width() / 2.0;
        let edge =
            |distance: f64| if (distance - half).abs() > COMPUTED * self.size { distance } else { half };
        let [o, o_prime] = centred.base();
        let base = BaseEdges { left: edge(0.0 - o), right: edge(o_prime) };
        body.standing(base, centre.x, centre.y)?.with_moment_of_inertia(moment_of_inertia * length)
    }

    /// A centre from mid-width, on mid-width where only rounding parts it from there.
    fn middled(&self, centre: Vertex) -> Vertex {
        let is_off = centre.x.abs() > COMPUTED * self.size;
        Vertex { x: if is_off { centre.x } else { 0.0 }, ..centre }
    }

    /// True if it is an upright rectangle of one density, wet or dry.
    fn is_uniform(&self) -> bool {
        let [left, right] = self.ends();
        let near = |one: f64, two: f64| (one - two).abs() <= ROUNDING * self.size;
        let first = &self.parts[0];
        self.parts
            .iter()
            .all(|part| part.density == first.density && part.density_below_water == first.density)
            && self.slices.iter().all(|slice| {
                slice.left.iter().all(|x| near(*x, left)) && slice.right.iter().all(|x| near(*x, right))
            })
    }

    /// Section with everything so much farther right, m.
    fn moved(&self, by: f64) -> Section {
        let mut moved = self.clone();
        let outlines = moved.parts.iter_mut().flat_map(|part| &mut part.outline);
        outlines.for_each(|vertex| vertex.x += by);
        for slice in &mut moved.slices {
            slice.left.iter_mut().chain(&mut slice.right).for_each(|x| *x += by);
        }
        moved
    }

    /// The water that stands on the steps and slopes of the body's sides and presses them down: its weight, or the lift where
    /// the body overhangs; none on upright sides.
    pub fn water_on_sides(&self, body: &Body, water: &StillWater, gravity: f64) -> Vec<Load> {
        let unit_weight = water.density() * gravity * body.plan().side(body.width());
        let [o, o_prime] = self.base();
        let sides: [(LoadSource, f64, f64, [Standing; 2]); 2] = [
            (
                LoadSource::WaterOnLeft,
                water.left(),
                1.0,
                self.standing(water.left(), |slice| slice.left.map(|x| x - o)),
            ),
            (
                LoadSource::WaterOnRight,
                water.right(),
                -1.0,
                self.standing(water.right(), |slice| slice.right.map(|x| o_prime - x)),
            ),
        ];
        let [edge_left, edge_right] = [0.0 - body.base_edges().left, body.base_edges().right];
        let each = sides.into_iter().flat_map(|(source, level, to_right, standing)| {
            standing.map(|standing| (source, level, to_right, standing))
        });
        let loads = each.filter_map(|(source, level, to_right, Standing { area, moment })| {
            // What rounding leaves of an upright side is no water.
            if area.abs() <= ROUNDING * self.size * level {
                return None;
            }
            let corner = if to_right > 0.0 { edge_left } else { edge_right };
            let at = BodyPoint { x: corner + to_right * moment / area, y: level };
            let action = Action::Force { at, right: 0.0, up: 0.0 - unit_weight * area };
            Some(Load::permanent(source, LoadKind::Weight, action))
        });
        loads.collect()
    }

    /// The area between a side and the upright through its corner of the base, and its moment about that, up to a level: where the
    /// side lies within the base and water stands on it; and, below zero, where it overhangs.
    fn standing(&self, level: f64, from_corner: impl Fn(&Slice) -> [f64; 2]) -> [Standing; 2] {
        let mut sums = [Standing { area: 0.0, moment: 0.0 }; 2];
        for slice in self.slices.iter().filter_map(|slice| slice.below(level)) {
            let ([a, b], thickness) = (from_corner(&slice), slice.top - slice.bottom);
            // Where the side crosses the upright.
            let share = if a * b < 0.0 { a / (a - b) } else { 1.0 };
            let cut = if a * b < 0.0 { 0.0 } else { b };
            for ([a, b], thickness) in [([a, cut], share * thickness), ([cut, b], (1.0 - share) * thickness)]
            {
                let sum = &mut sums[usize::from(a + b < 0.0)];
                // ∫a²/2 dy; over an area below zero it lies beside the body.
                sum.area += thickness * (a + b) / 2.0;
                sum.moment += thickness * (a * a + a * b + b * b) / 6.0;
            }
        }
        sums
    }
}

/// An area beside an upright line, m², and its moment about it, m³.
#[derive(Debug, Clone, Copy)]
struct Standing {
    area: f64,
    moment: f64,
}
