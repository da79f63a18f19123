//! Top of a design: whether the present value meets the target, the value found, what fails just beyond it.

use super::{Design, Extreme};
use crate::summary::{Summary, warned_of_case};

pub(super) fn summary(design: &Design) -> Summary {
    let Design { request, quantity, .. } = design;
    let name = quantity.variable.name();
    let found = design.found();
    let meets = request.target.is_met(&design.present);
    let present = quantity.shown(quantity.present);
    let (warnings, warned) = warned_of_case(&found.answer.case.warnings());
    Summary {
        criteria: Some(match meets {
            true => format!("The present {name}, {present}, meets the target."),
            false => format!("The present {name}, {present}, does not meet the target."),
        }),
        answer: format!(
            "The {} {name} for which {} is {}.{}",
            request.extreme,
            request.target.words(),
            found.text,
            elsewhere(design)
        ),
        met: Some(meets),
        governing: None,
        near: found.beyond.brief().map(|words| format!("Just beyond, {words}.")),
        warnings,
        warned,
    }
}

/// That the target is not met by all values on the safe side of the one found, and from where on it is met by all that were tried.
fn elsewhere(design: &Design) -> String {
    let at = &design.stretches[design.at];
    let (Some(first), Some(last)) = (design.stretches.first(), design.stretches.last()) else {
        return String::new();
    };
    if design.stretches.len() == 1 {
        return String::new();
    }
    match design.request.extreme {
        Extreme::Least => format!(
            " Not all greater ones do: between {} and {} it fails in places. From {} to {} it is met throughout, as far as was tried.",
            at.greatest.text, last.least.text, last.least.text, last.greatest.text
        ),
        Extreme::Greatest => format!(
            " Not all lesser ones do: between {} and {} it fails in places. From {} to {} it is met throughout, as far as was tried.",
            first.greatest.text, at.least.text, first.least.text, first.greatest.text
        ),
    }
}
