//! The report's diagram: the view that an answer has of it where body and loads allow, and the inequalities that decide.

use super::{Assessed, checks, opening};
use crate::describe;
use crate::layout::{columns, digits, paragraph, row};

/// Reason why a load may have no point in the report's diagram.
const NO_POINT: &str = "No k–μ diagram for this load: the diagram needs a uniform body with one friction and no added mass, pressed on \
    its base and pushed sideways. Solved as a general contact problem.";

/// Note on the coordinates of a load on ground that can fail.
const RIGID_PLANE: &str = "The report's diagram is for rigid ground. Its inequalities, margins and changes of mode do not hold on this base, and are \
    not given.";

/// Note on a load without coordinates, on ground that can fail.
const NO_POINT_ON_GROUND: &str =
    "No k–μ diagram for this load. Solved as a general contact problem on this base.";

/// Reason why a load has no point in the report's diagram on a base that opens.
const OPENED: &str = "No k–μ diagram for this load: the body moves, and the water that stands under it then is another than at rest. \
    Solved as a general contact problem, each mode with the water of its own contact.";

/// Reason why a load has no point in the report's diagram where more than friction holds the body.
const HELD: &str = "No k–μ diagram: the diagram knows no adhesion and no force with a limit. Solved as a general contact problem, with what holds \
    the body.";

/// Reason why a load has no point in the report's diagram.
pub fn no_point(assessed: &Assessed) -> &'static str {
    if assessed.outcome.held.is_some() {
        HELD
    } else if opening::told(assessed).is_some() && assessed.situation.body().is_uniform() {
        OPENED
    } else {
        NO_POINT
    }
}

pub(super) fn text(assessed: &Assessed) -> String {
    let effective = &assessed.outcome.full.effective;
    if assessed.is_on_ground() && effective.is_none() {
        return paragraph(NO_POINT_ON_GROUND, 2);
    }
    let Some(reduced) = &assessed.outcome.full.effective else { return paragraph(no_point(assessed), 2) };
    let point = &reduced.point;
    let (k, k_prime) = match assessed.situation.in_air() {
        Some(_) if assessed.is_factored() => {
            (["k", "γ_F F/(m g), γ_F the factor of the combination"], ["k'", "(e − H)/H"])
        }
        Some(_) => (["k", "F/(m g)"], ["k'", "(e − H)/H"]),
        None => (["k_eff", "|X|/V"], ["k'_eff", "−M/(X H)"]),
    };
    let mut rows = vec![
        row!["γ", "H/B", digits(point.gamma())],
        row![k_prime[0], k_prime[1], digits(point.k_prime())],
        row![k[0], k[1], digits(point.k())],
        row!["μ", "", digits(point.mu())],
    ];
    if assessed.is_on_ground() {
        return columns(&rows, 2, &[]) + &paragraph(RIGID_PLANE, 2);
    }
    let effective = checks::effective_factor(assessed);
    if let Some((_, factor)) = &effective {
        rows.push(row!["SF", "1/(k_eff γ |1+k'_eff|), overturning", factor.as_str()]);
    }
    let mut text = columns(&rows, 2, &[]);
    if let Some((reduced, _)) = effective {
        text += &paragraph(checks::two_factors(reduced), 2);
    }
    if reduced.mirrored {
        text += &paragraph(describe::MIRRORED, 2);
    }
    text
}
