//! Loads that act, and accelerations of the base that were tried.

use maud::{Markup, html};
use standfast::Verdict;
use standfast::loads::Earthquake;
use standfast_cases::assess::{Component, verdict};
use standfast_cases::{Acting, Assessed, Assessment};

use crate::measured::{Measured, NONE, number};
use crate::steps::SheetSteps;
use crate::together::Brief;

/// The factor of each load in each of the combinations, which are shown in this order.
pub(super) fn factors(steps: &mut SheetSteps, shown: &[&Assessed]) {
    let components: Vec<_> = shown.iter().map(|assessed| assessed.components()).collect();
    let mut names: Vec<(&str, bool)> = Vec::new();
    for Component { name, load, .. } in components.iter().flatten() {
        if !names.contains(&(name, load.permanent)) {
            names.push((name, load.permanent));
        }
    }
    let factor = |of: &[Component], (name, permanent): (&str, bool)| {
        let is_it = |one: &&Component| one.name == name && one.load.permanent == permanent;
        of.iter().find(is_it).map(|component| component.load.factor)
    };
    let number_of = |assessed: &Assessed| match assessed.acting {
        Acting::Combination(index) => index + 1,
        _ => assessed.index + 1,
    };
    steps.note(
        "Loads that a combination does not name act as they are if they are permanent, and not at all if they are variable. A dash \
         stands for a load that does not act.",
    );
    let full = html! {
        table.numbers data-table="factors" {
            thead {
                tr {
                    th { "Load" }
                    th {}
                    @for assessed in shown {
                        th.n { @if shown.len() > 1 { "Combination " (number_of(assessed)) } @else { "Factor" } }
                    }
                }
            }
            tbody {
                @for &(name, permanent) in &names {
                    tr {
                        td { (name) }
                        td { @if permanent { "permanent" } @else { "variable" } }
                        @for of in &components {
                            td.n {
                                @match factor(of, (name, permanent)) {
                                    Some(factor) => data value=(factor) { (number(factor)) },
                                    None => "–",
                                }
                            }
                        }
                    }
                }
            }
        }
    };
    steps.push(full, Brief::Each);
}

pub(super) fn steps(steps: &mut SheetSteps, assessment: &Assessment, assessed: &Assessed) {
    let case = &assessment.case;
    if assessed.others.is_empty() {
        return;
    }
    steps.note(
        "The base may be shaken to either side and either way, unless the case fixes a sign. These accelerations were tried; all \
         that follows is for the first, the worst.",
    );
    let factor = case.earthquake_factor(assessed.acting);
    if factor != 1.0 {
        steps.note("The accelerations act times the factor of the combination.");
    }
    let tried = assessed.tried().filter_map(|tried| Some((tried.earthquake?, tried)));
    let tried: Vec<_> = tried.collect();
    let full = html! {
        table.numbers data-table="earthquakes" {
            thead {
                tr {
                    th.n { "To the right, m/s²" }
                    th.n { "Upwards, m/s²" }
                    th { "Mode" }
                    th.n { "Safety against sliding" }
                    th.n { "Safety against overturning" }
                    th { "Leaves rest at" }
                }
            }
            tbody {
                @for (earthquake, tried) in &tried {
                    @let outcome = &tried.outcome;
                    tr {
                        (accelerations(earthquake))
                        td { (tried.verdict().map_or("none", Verdict::symbol)) }
                        @for factor in [outcome.stability.sliding, outcome.stability.overturning()] {
                            td.n { @if outcome.full.is_lifted() { "none" } @else { (Measured::of(factor, NONE).html("")) } }
                        }
                        td { (verdict::departure_word(&tried.departure())) }
                    }
                }
            }
        }
    };
    steps.push(full, Brief::Each);
}

fn accelerations(earthquake: &Earthquake) -> Markup {
    html! {
        @for value in [earthquake.horizontal(), earthquake.vertical()] {
            td.n { data value=(value) { (number(value)) } }
        }
    }
}
