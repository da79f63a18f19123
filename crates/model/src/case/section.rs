//! From typed inputs to the section of a body and the body itself: one block, a cylinder, or parts.

use standfast::section::{Part, Section, SectionError, Vertex, WaterTable};
use standfast::{Body, Plan, Scalar};

use super::reader::Reader;
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};
use crate::units::Extent;

/// Keys of the body table that follow from its parts.
pub const OF_PARTS: [Key; 9] = [
    Key::Width,
    Key::Height,
    Key::Mass,
    Key::Density,
    Key::BaseLeft,
    Key::BaseRight,
    Key::CentroidOffset,
    Key::CentroidHeight,
    Key::MomentOfInertia,
];

/// Keys of the body table that say more of a block than that it is uniform.
pub(super) const OF_BLOCK: [Key; 5] =
    [Key::BaseLeft, Key::BaseRight, Key::CentroidOffset, Key::CentroidHeight, Key::MomentOfInertia];

/// Keys that give a part as a rectangle or trapezoid, the first four always.
const TRAPEZOID: [Key; 6] =
    [Key::PartLeft, Key::PartWidth, Key::PartBottom, Key::PartHeight, Key::PartTopLeft, Key::PartTopWidth];

impl Reader<'_> {
    /// The body, and its section where it is made of parts.
    pub(super) fn body<T: Scalar>(&self) -> Result<(Body<T>, Option<Section>), Fault> {
        if self.inputs.extent() == Extent::Whole && self.inputs.has(Table::Wave) {
            return Err(Fault::new(Problem::WavesOnObject, Table::Wave));
        }
        if self.is_cylinder() {
            self.fits_cylinder()?;
        }
        if !self.inputs.has(Table::Part) {
            if self.number(Key::WidthScale).is_some() {
                return Err(Fault::new(Problem::ScaleWithoutParts, Key::WidthScale));
            }
            return Ok((self.block()?, None));
        }
        if let Some(key) = OF_PARTS.into_iter().find(|key| self.number(*key).is_some()) {
            return Err(Fault::new(Problem::FollowsFromParts { key }, key));
        }
        let section = self.section()?;
        let body = section.body(self.water_table(), self.number(Key::Length).unwrap_or(1.0));
        let body =
            body.map_err(|error| Fault::new(Problem::Parts(error.into()), Place::Table(Table::Part, 0)))?;
        Ok((Body::computed(&body), Some(section)))
    }

    fn is_cylinder(&self) -> bool {
        self.inputs.choice(Key::Shape) == Some("cylinder")
    }

    fn plan<T: Scalar>(&self) -> Plan<T> {
        Plan::Rectangle { length: self.scalar(Key::Length).unwrap_or_else(|| T::of(1.0)) }
    }

    /// Refuses what a cylinder does not have.
    fn fits_cylinder(&self) -> Result<(), Fault> {
        const KEYS: [Key; 5] = [Key::Length, Key::BaseLeft, Key::BaseRight, Key::WaterLeft, Key::WetSides];
        if let Some(key) = KEYS.into_iter().find(|key| self.number(*key).is_some()) {
            return Err(Fault::new(Problem::NotOfCylinder { key }, key));
        }
        match self.inputs.has(Table::Part) {
            true => Err(Fault::new(Problem::PartsOfCylinder, Table::Part)),
            false => Ok(()),
        }
    }

    /// A block or a cylinder, uniform but for what the file says.
    fn block<T: Scalar>(&self) -> Result<Body<T>, Fault> {
        let (width, height): (T, T) = (self.needed(Key::Width)?, self.needed(Key::Height)?);
        let of = |mass: T| {
            let (width, height) = (width.clone(), height.clone());
            match self.is_cylinder() {
                true => Body::cylinder(width, height, mass),
                false => match self.scalar(Key::Length) {
                    Some(length) => Body::new(width, height, mass)?.with_length(length),
                    None => Body::new(width, height, mass),
                },
            }
        };
        let area = if self.is_cylinder() { Plan::Circle } else { self.plan() }.area(width.clone());
        let body = match (self.scalar(Key::Mass), self.scalar::<T>(Key::Density)) {
            (Some(_), Some(_)) => {
                let problem = Problem::Both { one: Key::Mass, two: Key::Density };
                return Err(Fault::new(problem, Key::Density));
            }
            (None, None) => {
                let problem = Problem::Neither { one: Key::Mass, two: Key::Density };
                return Err(Fault::new(problem, Table::Body));
            }
            (Some(mass), None) => of(mass),
            // In this order, which the one metre of a long body has always had.
            (None, Some(density)) => of(density * area * height.clone()),
        };
        let half = || width.clone() / T::of(2.0);
        let shaped = body.and_then(|body| {
            let left = self.scalar(Key::BaseLeft).unwrap_or_else(half);
            let right = self.scalar(Key::BaseRight).unwrap_or_else(half);
            let offset = self.scalar(Key::CentroidOffset).unwrap_or_else(|| T::of(0.0));
            let height = self.scalar(Key::CentroidHeight).unwrap_or_else(|| body.centroid_height());
            let body = body.with_base(left, right)?.with_centroid(offset, height)?;
            match self.scalar(Key::MomentOfInertia) {
                Some(moment) => body.with_moment_of_inertia(moment),
                None => Ok(body),
            }
        });
        shaped.map_err(|error| self.blame(Table::Body, error))
    }

    /// Under which line the parts are wet: the still water at both sides, or that of the waves.
    pub(super) fn water_table(&self) -> Option<WaterTable> {
        let level = self.number(Key::Level).or(self.still_water());
        match (self.number(Key::WaterLeft), self.number(Key::WaterRight)) {
            (Some(left), Some(right)) => Some(WaterTable { left, right }),
            _ => level.map(|level| WaterTable { left: level, right: level }),
        }
    }

    fn section(&self) -> Result<Section, Fault> {
        let count = self.inputs.count(Table::Part);
        let parts = (0..count).map(|index| self.part(index)).collect::<Result<Vec<_>, _>>()?;
        Section::new(parts).map_err(|error| {
            let fault = |index| Fault::new(Problem::Parts(error), Place::Table(Table::Part, index));
            match error {
                SectionError::Overlap { one, two, .. } => fault(one).and(Place::Table(Table::Part, two)),
                SectionError::BelowBase { .. } | SectionError::NotOnBase { .. } => fault(self.lowest_part()),
                _ => fault(0),
            }
        })
    }

    /// The words under a key of the parts.
    pub(super) fn of_parts(&self, key: Key) -> Vec<Option<String>> {
        let words = (0..self.inputs.count(Table::Part))
            .map(|index| self.inputs.text(Id::new(key, index)).map(str::to_owned));
        words.collect()
    }

    fn part(&self, index: usize) -> Result<Part, Fault> {
        let at = |key| Id::new(key, index);
        let density =
            match (self.inputs.number(at(Key::PartDensity)), self.inputs.number(at(Key::PartUnitWeight))) {
                (Some(density), None) => density,
                (None, Some(weight)) => weight / self.inputs.gravity(),
                (None, None) => return Err(self.missing(Key::PartDensity, index)),
                (Some(_), Some(_)) => {
                    let (one, two) = (Key::PartUnitWeight, Key::PartDensity);
                    return Err(Fault::new(Problem::Both { one, two }, at(one)).and(at(two)));
                }
            };
        let below = self.inputs.number(at(Key::PartDensityBelow)).unwrap_or(density);
        let scale = self.number(Key::WidthScale).unwrap_or(1.0);
        let mut outline = self.outline(index)?;
        outline.iter_mut().for_each(|corner| corner.x *= scale);
        Part::new(outline, density, below)
            .map_err(|error| Fault::new(Problem::Part { index, error }, Place::Table(Table::Part, index)))
    }

    /// The corners of a part, before its width is scaled.
    fn outline(&self, index: usize) -> Result<Vec<Vertex>, Fault> {
        let at = |key| Id::new(key, index);
        let list = |key| self.inputs.list(at(key));
        let of_trapezoid = TRAPEZOID.into_iter().find(|key| self.inputs.number(at(*key)).is_some());
        match (list(Key::PartX), list(Key::PartY), of_trapezoid) {
            (Some(x), Some(y), None) if x.len() == y.len() => {
                Ok(x.iter().zip(y).map(|(&x, &y)| Vertex { x, y }).collect())
            }
            (Some(x), Some(y), None) => {
                let problem = Problem::Corners { x: x.len(), y: y.len() };
                Err(Fault::new(problem, at(Key::PartX)).and(at(Key::PartY)))
            }
            (Some(_), None, None) => Err(self.missing(Key::PartY, index)),
            (None, Some(_), None) => Err(self.missing(Key::PartX, index)),
            (None, None, None) => {
                let place = Place::Table(Table::Part, index);
                Err(Fault::new(Problem::NoOutline, place))
            }
            (None, None, Some(_)) => self.trapezoid(index),
            (x, _, Some(two)) => {
                let one = if x.is_some() { Key::PartX } else { Key::PartY };
                Err(Fault::new(Problem::Both { one, two }, at(two)))
            }
        }
    }

    fn trapezoid(&self, index: usize) -> Result<Vec<Vertex>, Fault> {
        let at = |key| self.inputs.number(Id::new(key, index));
        let needed = |key| at(key).ok_or_else(|| self.missing(key, index));
        let (left, width) = (needed(Key::PartLeft)?, needed(Key::PartWidth)?);
        let (bottom, height) = (needed(Key::PartBottom)?, needed(Key::PartHeight)?);
        let top = bottom + height;
        let top_left = at(Key::PartTopLeft).unwrap_or(left);
        let top_width = at(Key::PartTopWidth).unwrap_or(width);
        let mut corners = vec![
            Vertex { x: left, y: bottom },
            Vertex { x: left + width, y: bottom },
            Vertex { x: top_left + top_width, y: top },
        ];
        if top_width > 0.0 {
            corners.push(Vertex { x: top_left, y: top });
        }
        Ok(corners)
    }

    /// The part that reaches lowest.
    fn lowest_part(&self) -> usize {
        let lowest = |index: &usize| {
            let corners = self.outline(*index).unwrap_or_default();
            corners.iter().map(|corner| corner.y).fold(f64::INFINITY, f64::min)
        };
        let parts = 0..self.inputs.count(Table::Part);
        parts.min_by(|one, two| lowest(one).total_cmp(&lowest(two))).unwrap_or(0)
    }
}
