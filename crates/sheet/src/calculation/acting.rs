//! Loads that act, and accelerations of the base that were tried.

use maud::{Markup, html};
use standfast::Verdict;
use standfast::loads::Earthquake;
use standfast_cases::assess::verdict;
use standfast_cases::{Acting, Assessed, Assessment};

use crate::measured::{Measured, NONE, number};
use crate::steps::SheetSteps;

pub(super) fn steps(steps: &mut SheetSteps, assessment: &Assessment, assessed: &Assessed) {
    let case = &assessment.case;
    if let Acting::Combination(index) = assessed.acting {
        steps.note(
            "Factors of the combination. Loads that it does not name act as they are if they are permanent, and not at all if \
             they are variable.",
        );
        let factors = &case.combinations[index].factors;
        if factors.is_empty() {
            return steps.note("The combination names no load.");
        }
        steps.push(html! {
            table.numbers data-table="factors" {
                thead { tr { th { "Load" } th.n { "Factor" } } }
                tbody {
                    @for (name, factor) in factors {
                        tr { td { (name) } td.n { data value=(factor) { (number(*factor)) } } }
                    }
                }
            }
        });
    }
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
    steps.push(html! {
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
    });
}

fn accelerations(earthquake: &Earthquake) -> Markup {
    html! {
        @for value in [earthquake.horizontal(), earthquake.vertical()] {
            td.n { data value=(value) { (number(value)) } }
        }
    }
}
