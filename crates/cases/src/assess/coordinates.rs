//! The report's diagram: the view that an answer has of it where body and loads allow, and the inequalities that decide.

use super::Assessed;
use crate::describe;
use crate::layout::{columns, digits, paragraph, row};

/// Reason why a load may be no point of the report's diagram.
pub const NO_POINT: &str = "The load is no point of the report's diagram, which needs a uniform body with one friction and no \
    added mass, pressed on its base and pushed sideways; it is answered by the general contact problem.";

/// Note on the coordinates of a load on ground that can fail.
const RIGID_PLANE: &str = "The report's diagram of these γ and k' is that of rigid ground: its inequalities, margins and changes of mode are not those \
    of this base, and are not given.";

/// Note on a load without coordinates, on ground that can fail.
const NO_POINT_ON_GROUND: &str = "The load is no point of the report's diagram; it is answered by the general contact problem on this base.";

pub(super) fn text(assessed: &Assessed) -> String {
    let effective = &assessed.outcome.full.effective;
    if assessed.is_on_ground() && effective.is_none() {
        return paragraph(NO_POINT_ON_GROUND, 2);
    }
    let Some(reduced) = &assessed.outcome.full.effective else { return paragraph(NO_POINT, 2) };
    let point = &reduced.point;
    let (k, k_prime) = match assessed.situation.in_air() {
        Some(_) if assessed.is_factored() => {
            (["k", "γ_F F/(m g), γ_F the factor of the combination"], ["k'", "(e − H)/H"])
        }
        Some(_) => (["k", "F/(m g)"], ["k'", "(e − H)/H"]),
        None => (["k_eff", "|X|/P"], ["k'_eff", "−M/(X H)"]),
    };
    let rows = [
        row!["γ", "H/B", digits(point.gamma())],
        row![k_prime[0], k_prime[1], digits(point.k_prime())],
        row![k[0], k[1], digits(point.k())],
        row!["μ", "", digits(point.mu())],
    ];
    let mut text = columns(&rows, 2, &[]);
    if assessed.is_on_ground() {
        return text + &paragraph(RIGID_PLANE, 2);
    }
    if reduced.mirrored {
        text += &paragraph(describe::MIRRORED, 2);
    }
    text
}
