//! The boundaries of the plane of load factor and friction on a base that crushes.

use super::conditions::enumerate;
use super::turning::{Rate, Turn, orientation};
use super::{CrushProblem, LoadedBlock};
use crate::approx::Approx;
use crate::error::InputError;
use crate::exact::Exact;
use crate::ground::load_plane::{LoadEdge, Rising};
use crate::mode::{Corner, Slip};
use crate::plan::Plan;
use crate::quantity::{Expected, Quantity};
use crate::situation::Situation;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// A body under loads that rise, on a base that bears `strength` per length, in the situation's reduced units.
#[derive(Debug, Clone, Copy)]
pub(in crate::ground) struct CrushEdges {
    rising: Rising,
    strength: f64,
}

impl CrushEdges {
    pub(in crate::ground) fn new(situation: &Situation, strength: f64) -> Result<CrushEdges, InputError> {
        Ok(CrushEdges { rising: Rising::of(situation), strength: reduced_strength(situation, strength)? })
    }

    pub(in crate::ground) fn rising(&self) -> &Rising {
        &self.rising
    }

    fn given(&self, factor: f64, friction: f64) -> LoadedBlock {
        let (block, wrench) = (self.rising.block(friction), self.rising.wrench(factor));
        LoadedBlock { block, wrench, strength: self.strength }
    }

    pub(in crate::ground) fn verdict(
        &self,
        factor: f64,
        friction: f64,
    ) -> Result<Option<Verdict>, InputError> {
        let given = self.given(factor, friction);
        crate::contact::check(&given.block, &given.wrench)?;
        Ok(enumerate(&given).verdict)
    }

    pub(in crate::ground) fn at(&self, edge: LoadEdge, factor: f64) -> Option<f64> {
        let rising = &self.rising;
        match edge {
            LoadEdge::Friction { slips } => Some(rising.sticking(rising.inclination(factor)?, slips)),
            LoadEdge::Reaction { slip, corner } => {
                Some(rising.sticking(reaction(&self.given(factor, 0.0), slip, corner)?, true))
            }
            LoadEdge::Turn { corner, slips } => {
                Some(rising.sticking(turn(&self.given(factor, 0.0), corner)?, slips))
            }
            LoadEdge::Bearing { .. } => None,
        }
    }
}

/// The friction to slip with which a body that slides puts its reaction as near to a corner as the base bears it.
pub(super) fn reaction(given: &LoadedBlock, slip: Slip, corner: Corner) -> Option<f64> {
    let LoadedBlock { block, wrench: Wrench { p, m, .. }, strength } = given;
    let σ = orientation(corner);
    let b = if corner == Corner::O { block.b1 } else { block.b2 };
    let room = b * p - p * p / (2.0 * strength);
    (*p > 0.0).then(|| slip.sign() * (m - σ * room) / (block.d * p))
}

/// |X + m_x dθ̈|/N of a body that rocks about a corner; `None` of one that does not.
pub(super) fn turn(given: &LoadedBlock, corner: Corner) -> Option<f64> {
    let n = given.numbers::<f64>();
    // As of a motion, with exact digits where the turn begins.
    let surplus = Turn::about(&given.numbers::<Approx>(), corner, None).surplus.precise();
    let exactly = || Turn::about(&given.numbers::<Exact>(), corner, None).surplus.to_f64();
    let a = Rate::of(&n, corner, None, surplus.unwrap_or_else(exactly)).root()?;
    let [q0, q1] = n.q;
    let normal = q0 * (n.p + n.m_y * n.edge(corner) * a) / (q0 + q1 * n.m_y * a);
    (normal > 0.0).then(|| (n.x + n.m_x * n.d * orientation(corner) * a).abs() / normal)
}

/// A strength q_u (Pa) per length in the units of a situation's block, as [`solve`](super::solve) takes it: lengths in B, forces in m g.
///
/// # Errors
/// If it is not above zero, or the base is round.
pub fn reduced_strength(situation: &Situation, strength: f64) -> Result<f64, InputError> {
    let strength = InputError::positive(Quantity::Strength, strength)?;
    let body = situation.body();
    let Plan::Rectangle { length } = body.plan() else {
        return Err(InputError::new(Quantity::Width, body.width(), Expected::RectangularBase));
    };
    Ok(strength * length * (body.width() / 2.0) / (body.mass() * situation.gravity()))
}
