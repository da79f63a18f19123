//! Still water on both sides of a body and under it.

use super::{Action, Face, Load, LoadKind, LoadSource, PressureDiagram};
use crate::body::Body;
use crate::error::InputError;
use crate::quantity::{Expected, Quantity};

/// Still water: its pressure on the sides, and under the base, where it is linear between the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StillWater {
    left: f64,
    right: f64,
    density: f64,
}

impl StillWater {
    /// Water of `density` (kg/m³) that stands `left` and `right` above the base on either side (m) of `body`.
    ///
    /// # Errors
    /// If a level is negative or above the crest, which would be under water, or the density is not above zero.
    pub fn new(body: &Body, left: f64, right: f64, density: f64) -> Result<StillWater, InputError> {
        let level = |level: f64| {
            let level = InputError::not_negative(Quantity::WaterLevel, level)?;
            if !body.reaches(level) {
                return Err(InputError::new(Quantity::WaterLevel, level, Expected::NotAboveCrest));
            }
            Ok(level)
        };
        let density = InputError::positive(Quantity::WaterDensity, density)?;
        Ok(StillWater { left: level(left)?, right: level(right)?, density })
    }

    /// Its level above the base at the left, m.
    pub fn left(&self) -> f64 {
        self.left
    }

    /// Its level above the base at the right, m.
    pub fn right(&self) -> f64 {
        self.right
    }

    /// Its density, kg/m³.
    pub fn density(&self) -> f64 {
        self.density
    }

    /// Buoyancy, and where the levels differ the push on the sides.
    pub fn loads(&self, body: &Body, gravity: f64) -> Vec<Load> {
        let unit_weight = self.density * gravity;
        let base = Action::base_pressure(body, unit_weight * self.left, unit_weight * self.right);
        let mut loads = vec![Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, base)];
        if self.left != self.right {
            let side = |face, level: f64| {
                let diagram = PressureDiagram::through([(0.0, unit_weight * level), (level, 0.0)]);
                let action = Action::Pressure { face, diagram };
                Load::permanent(LoadSource::StillWater, LoadKind::Horizontal, action)
            };
            loads.extend([side(Face::Left, self.left), side(Face::Right, self.right)]);
        }
        loads
    }
}
