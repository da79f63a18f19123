//! Still water on both sides of a body and under it.

use super::{Action, Face, Load, LoadKind, LoadSource, PressureDiagram};
use crate::ball::Scalar;
use crate::body::Body;
use crate::error::InputError;
use crate::quantity::{Expected, Quantity};

/// Still water: its pressure on the sides, and under the base, where it is linear between the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StillWater<T = f64> {
    left: T,
    right: T,
    density: T,
}

impl<T: Scalar> StillWater<T> {
    /// Water of `density` (kg/m³) that stands `left` and `right` above the base on either side (m) of `body`.
    ///
    /// # Errors
    /// If a level is negative or above the crest, which would be under water, or the density is not above zero.
    pub fn new(body: &Body<T>, left: T, right: T, density: T) -> Result<StillWater<T>, InputError> {
        let level = |level: T| {
            let level = InputError::not_negative(Quantity::WaterLevel, level)?;
            if !body.reaches(level.clone()) {
                return Err(InputError::new(Quantity::WaterLevel, level.value(), Expected::NotAboveCrest));
            }
            Ok(level)
        };
        let density = InputError::positive(Quantity::WaterDensity, density)?;
        Ok(StillWater { left: level(left)?, right: level(right)?, density })
    }

    /// Its level above the base at the left, m.
    pub fn left(&self) -> T {
        self.left.clone()
    }

    /// Its level above the base at the right, m.
    pub fn right(&self) -> T {
        self.right.clone()
    }

    /// Its density, kg/m³.
    pub fn density(&self) -> T {
        self.density.clone()
    }

    /// Still water in f64.
    pub fn rounded(&self) -> StillWater {
        StillWater { left: self.left.value(), right: self.right.value(), density: self.density.value() }
    }

    /// Buoyancy, and where the levels differ the push on the sides.
    pub fn loads(&self, body: &Body<T>, gravity: T) -> Vec<Load<T>> {
        let unit_weight = self.density() * gravity;
        let under = |level: &T| unit_weight.clone() * level.clone();
        let base = Action::base_pressure(body, under(&self.left), under(&self.right));
        let mut loads = vec![Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, base)];
        if self.left != self.right {
            let side = |face, level: &T| {
                let points = [(T::of(0.0), under(level)), (level.clone(), T::of(0.0))];
                let action = Action::Pressure { face, diagram: PressureDiagram::through(points) };
                Load::permanent(LoadSource::StillWater, LoadKind::Horizontal, action)
            };
            loads.extend([side(Face::Left, &self.left), side(Face::Right, &self.right)]);
        }
        loads
    }
}
