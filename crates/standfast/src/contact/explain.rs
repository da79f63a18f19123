//! The conditions of a consistent mode as inequalities between numbers of its motion.

use super::Block;
use crate::mode::{Corner, Mode, Slip};
use crate::motion::Motion;
use crate::relation::{Relation, Sign};

/// The conditions of `mode`, which begins with `motion`, where a body at rest adheres to its base with so much; see the table of the
/// [contact problem](super).
pub(crate) fn relations(block: &Block, mode: Mode, motion: &Motion, adhesion: f64) -> Vec<Relation> {
    use Sign::{Greater, GreaterOrEqual, Less, LessOrEqual};
    let Motion { theta_ddot: α, f_x, f_y, xi, slip, lift_o, lift_o_prime, .. } = *motion;
    let holds = |equation, (quantity, left), sign, (bound, right)| Relation {
        equation,
        quantity,
        left,
        sign,
        bound,
        right,
        holds: true,
    };
    let zero = ("0", 0.0);
    let friction = || holds("friction", ("|f_x|", f_x.abs()), LessOrEqual, ("μ_s f_y", block.mu_s * f_y));
    let pressed = || holds("contact", ("f_y", f_y), GreaterOrEqual, zero);
    let on_base = || {
        [
            holds("contact", ("ξ", xi), GreaterOrEqual, ("−b_1", -block.b1)),
            holds("contact", ("ξ", xi), LessOrEqual, ("b_2", block.b2)),
        ]
    };
    let slipping = |slides| {
        let sign = if slides == Slip::Left { Less } else { Greater };
        holds("slip", ("ẍ_O", slip), sign, zero)
    };
    let turning = |corner| {
        let sign = if corner == Corner::O { Greater } else { Less };
        holds("rotation", ("θ̈", α), sign, zero)
    };
    match (mode, mode.corner(), mode.slip()) {
        (Mode::Flight, ..) => vec![
            holds("separation", ("ÿ_O", lift_o), GreaterOrEqual, zero),
            holds("separation", ("ÿ_O'", lift_o_prime), GreaterOrEqual, zero),
        ],
        (_, None, None) if adhesion > 0.0 => {
            let stick = ("μ_s f_y + c_a A'", block.mu_s * f_y + adhesion);
            let friction = holds("friction", ("|f_x|", f_x.abs()), LessOrEqual, stick);
            [friction, pressed()].into_iter().chain(on_base()).collect()
        }
        (_, None, None) => [friction(), pressed()].into_iter().chain(on_base()).collect(),
        (_, None, Some(slides)) => [slipping(slides), pressed()].into_iter().chain(on_base()).collect(),
        (_, Some(corner), None) => vec![turning(corner), pressed(), friction()],
        (_, Some(corner), Some(slides)) => vec![turning(corner), pressed(), slipping(slides)],
    }
}
