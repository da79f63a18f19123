//! Top of a design: whether the present value meets the target, the value found, what fails just beyond it.

use super::Design;
use crate::summary::{Summary, once};

pub(super) fn summary(design: &Design) -> Summary {
    let Design { request, quantity, .. } = design;
    let name = quantity.variable.name();
    let found = design.found();
    let meets = request.target.is_met(&design.present);
    let present = quantity.shown(quantity.present);
    Summary {
        criteria: Some(match meets {
            true => format!("The present {name}, {present}, meets the target."),
            false => format!("The present {name}, {present}, does not meet the target."),
        }),
        answer: format!(
            "The {} {name} for which {} is {}.",
            request.extreme,
            request.target.words(),
            found.text
        ),
        met: Some(meets),
        governing: None,
        near: found.beyond.words().map(|words| format!("Just beyond, {words}.")),
        warnings: once(found.answer.case.warnings().iter().map(standfast_model::Warning::name)),
    }
}
