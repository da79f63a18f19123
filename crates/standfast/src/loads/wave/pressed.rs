//! A wall under a diagram of pressures from its base through still water to the top of its loaded part: what Goda's formulas and Sainflou's
//! have in common.

use crate::body::Body;
use crate::loads::{Action, Face, Load, LoadKind, LoadSource, PressureDiagram};

/// Horizontal force, and its moment about the base, of the pressures at the base, at still water `depth` above it, and at the top, `reach`
/// above still water; straight lines between.
pub(super) fn resultants([foot, p1, top]: [f64; 3], depth: f64, reach: f64) -> [f64; 2] {
    let force = 0.5 * (p1 + foot) * depth + 0.5 * (p1 + top) * reach;
    let moment = (2.0 * p1 + foot) * depth * depth / 6.0
        + (p1 + top) * depth * reach / 2.0
        + (p1 + 2.0 * top) * reach * reach / 6.0;
    [force, moment]
}

/// Pressures on the right side of `body`, as places above its base with what presses there, and under its base, `pu` at the seaward edge and
/// none at the heel, where they press there.
pub(super) fn loads(body: &Body, wall: [(f64, f64); 3], pu: f64) -> Vec<Load> {
    let wall = Action::Pressure { face: Face::Right, diagram: PressureDiagram::through(wall) };
    let mut loads = vec![Load::variable(LoadSource::WavePressure, LoadKind::Horizontal, wall)];
    if pu != 0.0 {
        let base = Action::base_pressure(body, 0.0, pu);
        loads.push(Load::variable(LoadSource::WaveUplift, LoadKind::Uplift, base));
    }
    loads
}

/// A number and flags behind it as one number.
pub(super) fn numbered(number: u32, flags: &[bool]) -> u32 {
    flags.iter().fold(number, |number, flag| 2 * number + u32::from(*flag))
}
