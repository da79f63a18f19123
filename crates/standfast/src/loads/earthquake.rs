//! A base that is shaken, and the water that moves with the body.

use super::wave::added_mass_above;
use super::{Across, Action, Load, LoadKind, LoadSource};
use crate::ball::Scalar;
use crate::error::InputError;
use crate::quantity::Quantity;

/// An acceleration of the base, as forces of inertia: the motion that follows is the one relative to the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Earthquake<T = f64> {
    horizontal: T,
    vertical: T,
    away: T,
}

/// Water that a horizontal motion carries along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedMass<T = f64> {
    mass: T,
    height: Option<T>,
}

impl<T: Scalar> Earthquake<T> {
    /// `horizontal` to the right, so that the force of inertia points left, and `vertical` upwards (m/s²).
    ///
    /// # Errors
    /// If one of them is not finite.
    pub fn new(horizontal: T, vertical: T) -> Result<Earthquake<T>, InputError> {
        let acceleration = |value: T| InputError::finite(Quantity::Acceleration, value);
        let away = T::of(0.0);
        Ok(Earthquake { horizontal: acceleration(horizontal)?, vertical: acceleration(vertical)?, away })
    }

    /// Earthquake with an acceleration away from the viewer of the section, too (m/s²), on a base [seen from above](crate::footprint).
    ///
    /// # Errors
    /// If it is not finite.
    pub fn with_away(self, away: T) -> Result<Earthquake<T>, InputError> {
        Ok(Earthquake { away: InputError::finite(Quantity::Acceleration, away)?, ..self })
    }

    /// Earthquake with its accelerations times 1 or −1: to the other side, downwards for upwards, towards the viewer for away.
    pub fn turned(&self, [side, way, away]: [f64; 3]) -> Earthquake<T> {
        Earthquake {
            horizontal: self.horizontal() * T::of(side),
            vertical: self.vertical() * T::of(way),
            away: self.away() * T::of(away),
        }
    }

    /// To the right, m/s².
    pub fn horizontal(&self) -> T {
        self.horizontal.clone()
    }

    /// Upwards, m/s².
    pub fn vertical(&self) -> T {
        self.vertical.clone()
    }

    /// Away from the viewer of the section, m/s².
    pub fn away(&self) -> T {
        self.away.clone()
    }

    /// Inertia of the body; against the shaken wall, water presses as if its mass were shaken, too.
    pub fn loads(&self, water: &AddedMass<T>) -> Vec<Load<T>> {
        use LoadKind::{Horizontal, Weight};
        let zero = || T::of(0.0);
        let mut loads = Vec::new();
        if self.horizontal != zero() || self.away != zero() {
            let inertia = Action::Inertia { right: self.horizontal(), up: zero() };
            let load = Load::variable(LoadSource::HorizontalInertia, Horizontal, inertia);
            let across = || Across { away: self.away(), z: None };
            loads.push(if self.away == zero() { load } else { load.across(across()) });
            if let Some(height) = water.height() {
                let push = Action::horizontal(zero() - water.mass() * self.horizontal(), height);
                loads.push(Load::variable(LoadSource::ShakenWater, Horizontal, push));
            }
        }
        if self.vertical != zero() {
            let inertia = Action::Inertia { right: zero(), up: self.vertical() };
            loads.push(Load::variable(LoadSource::VerticalInertia, Weight, inertia));
        }
        loads
    }

    /// Earthquake in f64.
    pub fn rounded(&self) -> Earthquake {
        let [horizontal, vertical, away] = [&self.horizontal, &self.vertical, &self.away].map(T::value);
        Earthquake { horizontal, vertical, away }
    }
}

impl AddedMass {
    /// No water.
    pub const NONE: AddedMass = AddedMass { mass: 0.0, height: None };

    /// Added mass of numbers that were computed in f64, in any arithmetic; see [`Scalar::computed`].
    pub fn computed<T: Scalar>(self) -> AddedMass<T> {
        AddedMass { mass: T::computed(self.mass), height: self.height.map(T::computed) }
    }

    /// Water of `density` (kg/m³) beside a wall, as deep as `depths` (m) on one side or on each of both.
    ///
    /// # Errors
    /// If the density is not above zero, or a depth is negative or not finite.
    pub fn beside(density: f64, depths: &[f64]) -> Result<AddedMass, InputError> {
        AddedMass::beside_above(density, depths, 0.0)
    }

    /// The same beside what is above a `level` (m above the base), with its height above that.
    ///
    /// # Errors
    /// As [`beside`](AddedMass::beside).
    pub fn beside_above(density: f64, depths: &[f64], level: f64) -> Result<AddedMass, InputError> {
        let density = InputError::positive(Quantity::WaterDensity, density)?;
        for &depth in depths {
            InputError::not_negative(Quantity::WaterLevel, depth)?;
        }
        let masses = || depths.iter().map(|&depth| added_mass_above(density, depth, level));
        let mass: f64 = masses().map(|[mass, _]| mass).sum();
        let moment: f64 = masses().map(|[mass, height]| mass * height).sum();
        Ok(AddedMass { mass, height: (mass > 0.0).then(|| moment / mass) })
    }
}

impl<T: Scalar> AddedMass<T> {
    /// A mass (kg per metre run) whose height is not known: the water's pressure on a shaken wall is then no load.
    ///
    /// # Errors
    /// If it is negative or not finite.
    pub fn of(mass: T) -> Result<AddedMass<T>, InputError> {
        Ok(AddedMass { mass: InputError::not_negative(Quantity::AddedMass, mass)?, height: None })
    }

    /// Added mass pressing on a shaken wall at a height above the base (m).
    ///
    /// # Errors
    /// If it is negative or not finite.
    pub fn at(self, height: T) -> Result<AddedMass<T>, InputError> {
        let height = InputError::not_negative(Quantity::ForceElevation, height)?;
        Ok(AddedMass { height: (self.mass.value() > 0.0).then_some(height), ..self })
    }

    /// Its mass, kg per metre run.
    pub fn mass(&self) -> T {
        self.mass.clone()
    }

    /// Height above the base at which it presses on a shaken wall, m; `None` where the mass alone is given.
    pub fn height(&self) -> Option<T> {
        self.height.clone()
    }
}
