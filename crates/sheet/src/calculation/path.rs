//! The way to the full load.

use maud::html;
use standfast::contact::path;
use standfast::{Departure, Mode};
use standfast_cases::assess::verdict;
use standfast_cases::{Assessed, View};

use crate::measured::{NONE, number};
use crate::steps::Steps;

pub(super) fn steps(steps: &mut Steps, assessed: &Assessed, view: &View) {
    let stages = path::up_to(&assessed.outcome.path, view.up_to);
    steps.heading("Load path: the variable loads rise by a factor, the permanent ones stay");
    if !stages.is_empty() {
        steps.push(html! {
            table.numbers data-table="path" {
                thead { tr { th.n { "from" } th.n { "to" } th { "Mode" } th { "Also consistent" } } }
                tbody {
                    @for stage in &stages {
                        tr {
                            td.n { data value=(stage.from) { (number(stage.from)) } }
                            td.n { data value=(stage.to) { (number(stage.to)) } }
                            td { (stage.mode.map_or("none", Mode::symbol)) }
                            td { (stage.others()) }
                        }
                    }
                }
            }
        });
    }
    for sentence in verdict::path(assessed) {
        // Backticks would begin a formula.
        steps.note(&sentence.replace('`', "'"));
    }
    if let Departure::At { factor, .. } = *assessed.departure() {
        let words = "the least λ at which a condition of rest is crossed";
        steps.told("Load factor at which the body leaves rest", "λ_d", factor, NONE, words, "load_factor");
    }
}
