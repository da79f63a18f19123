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
        answer: answer(design),
        met: Some(meets),
        governing: None,
        near: found.beyond.brief().map(|words| format!("Just beyond, {words}.")),
        warnings,
        warned,
    }
}

/// From where on the target is met: throughout, or where it is met by some of the values only, from where on by all that were tried, and by
/// which others.
fn answer(design: &Design) -> String {
    let Design { request, quantity, .. } = design;
    let (extreme, name, wanted) = (request.extreme, quantity.variable.name(), request.target.words());
    let at = &design.stretches[design.at];
    let found = design.found();
    let (first, last) = (design.stretches.first(), design.stretches.last());
    let (Some(first), Some(last)) = (first.filter(|_| design.stretches.len() > 1), last) else {
        return format!("The {extreme} {name} for which {wanted} is {}.", found.text);
    };
    let [(from, to), (fails_from, fails_to)] = match extreme {
        Extreme::Least => [(&last.least, &last.greatest), (&at.greatest, &last.least)],
        Extreme::Greatest => [(&first.least, &first.greatest), (&first.greatest, &at.least)],
    };
    format!(
        "With a {name} from {} to {} {wanted}, as far as was tried. The {extreme} {name} is {}, but between {} and {} it \
         fails in places.",
        from.text, to.text, found.text, fails_from.text, fails_to.text
    )
}
