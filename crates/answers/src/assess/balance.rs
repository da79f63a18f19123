//! What tips a body against what holds it, and what lifts it against what presses, load by load.

use standfast::loads::{Action, Load, LoadSource};
use standfast::{Body, Corner, Wrench};

use super::Assessed;

/// The loads' horizontal and vertical parts on a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Balance {
    body: Body,
    parts: Vec<BalancePart>,
    /// What forces with a limit hold it with, in full: moments about O and O', and down.
    held: [f64; 2],
    held_down: f64,
}

/// The horizontal or the vertical part of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalancePart {
    /// The place of the load among the [components](Assessed::components).
    pub of: usize,
    /// At the centre of mass.
    pub wrench: Wrench,
}

impl BalancePart {
    /// The moment by which it tips `body` about a corner; below zero where it holds it.
    pub fn tips(&self, body: &Body, corner: Corner) -> f64 {
        let Wrench { x, p, m } = self.wrench;
        let about_base = m - x * body.centroid_height();
        match corner {
            Corner::O => about_base - p * body.heel_distance(),
            Corner::OPrime => -(about_base + p * body.toe_distance()),
        }
    }
}

impl Assessed {
    /// The parts of the loads; `None` under a weight that is given less buoyancy, as what acts down and what up is not known.
    pub fn balance(&self) -> Option<Balance> {
        let body = *self.situation.body();
        let mut parts = Vec::new();
        for (of, component) in self.components().iter().enumerate() {
            if is_lift(&component.load) {
                return None;
            }
            let whole = component.wrench;
            let forces = component.load.forces(&body, self.situation.gravity());
            match &forces[..] {
                // Of one force each part has its own moment.
                [force] if whole.x != 0.0 && whole.p != 0.0 => {
                    let ([x, y], [right, up]) = (force.at, force.size);
                    let sideways = Wrench { x: right, p: 0.0, m: -(y * right) };
                    let upright = Wrench { x: 0.0, p: -up, m: x * up };
                    parts.extend([sideways, upright].map(|wrench| BalancePart { of, wrench }));
                }
                _ => parts.push(BalancePart { of, wrench: whole }),
            }
        }
        let [heel, toe] = self.outcome.held.map_or([0.0; 2], |held| held.moments);
        let held = if self.outcome.actions.heel == Corner::O { [heel, toe] } else { [toe, heel] };
        let held_down = self.outcome.held.map_or(0.0, |held| held.down);
        Some(Balance { body, parts, held, held_down })
    }
}

/// True if a load is what lacks to m g where the case gives the weight less buoyancy.
fn is_lift(load: &Load) -> bool {
    load.source == LoadSource::Buoyancy && !matches!(load.action, Action::Pressure { .. })
}

impl Balance {
    /// Moments that tip the body about a corner, and those that hold it, N·m per metre run.
    pub fn moments(&self, corner: Corner) -> [f64; 2] {
        let [tips, holds] = by_sign(self.parts.iter().map(|part| part.tips(&self.body, corner)));
        [tips, holds + self.held_about(corner)]
    }

    /// The moments about a corner of the forces with a limit that hold the body there, each in full.
    pub fn held_about(&self, corner: Corner) -> f64 {
        self.held[usize::from(corner == Corner::OPrime)]
    }

    /// The forces with a limit that hold the body down, in full.
    pub fn held_down(&self) -> f64 {
        self.held_down
    }

    /// The sum of the moments that tip the body about a corner over that of those that hold it. Zero where nothing tips it, infinite where
    /// nothing holds it.
    pub fn about(&self, corner: Corner) -> f64 {
        match self.moments(corner) {
            [0.0, _] => 0.0,
            [tips, holds] => tips / holds,
        }
    }

    /// The corner about which that is the larger.
    pub fn corner(&self) -> Corner {
        if self.about(Corner::OPrime) > self.about(Corner::O) { Corner::OPrime } else { Corner::O }
    }

    /// The larger of both: from 1 on the resultant misses the base.
    pub fn tipping(&self) -> f64 {
        self.about(self.corner())
    }

    /// Forces that act down, and those that act up, N per metre run.
    pub fn vertical(&self) -> [f64; 2] {
        let [down, up] = by_sign(self.parts.iter().map(|part| part.wrench.p));
        [down + self.held_down(), up]
    }

    /// All that acts down over all that acts up; infinite where nothing lifts.
    pub fn uplift(&self) -> f64 {
        match self.vertical() {
            [_, 0.0] => f64::INFINITY,
            [down, up] => down / up,
        }
    }

    /// The parts, in the order of the loads.
    pub fn parts(&self) -> &[BalancePart] {
        &self.parts
    }

    /// The body.
    pub fn body(&self) -> &Body {
        &self.body
    }
}

/// The sum of what is above zero, and that of what is below it, without its sign.
fn by_sign(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([0.0; 2], |[above, below], value| match value > 0.0 {
        true => [above + value, below],
        false => [above, below - value],
    })
}
