//! The way to the full load.

use maud::html;
use standfast::Mode;
use standfast_cases::Assessed;

use crate::quantity::number;
use crate::steps::Steps;

pub(super) fn steps(steps: &mut Steps, assessed: &Assessed) {
    steps.heading("Load path: the variable loads rise by a factor, the permanent ones stay");
    if !assessed.path.is_empty() {
        steps.push(html! {
            table.numbers data-table="path" {
                thead { tr { th.n { "from" } th.n { "to" } th { "Mode" } th { "Also consistent" } } }
                tbody {
                    @for stage in &assessed.path {
                        @let others = stage.modes.iter().filter(|mode| Some(*mode) != stage.mode);
                        tr {
                            td.n { data value=(stage.from) { (number(stage.from)) } }
                            td.n { data value=(stage.to) { (number(stage.to)) } }
                            td { (stage.mode.map_or("none", Mode::symbol)) }
                            td { (others.map(Mode::symbol).collect::<Vec<_>>().join(" ")) }
                        }
                    }
                }
            }
        });
    }
    for sentence in assessed.path_words() {
        steps.note(&sentence);
    }
}
