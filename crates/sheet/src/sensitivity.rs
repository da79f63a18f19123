//! Effect on the safety of a small change of every number.

use maud::{Markup, html};
use standfast_cases::couple::STAYS;
use standfast_cases::design::{Sensitivity, SensitivityChange, change_words, sensitivities};
use standfast_cases::key::Table;
use standfast_cases::{CaseError, CaseFile};

use crate::measured::number;

pub fn table(file: &CaseFile) -> Result<Markup, CaseError> {
    let rows = sensitivities(file)?;
    // What a percent more of a table of pressures is, none of its numbers says.
    let untold = file.inputs().has(Table::Pressure);
    let stays = file.inputs().has(Table::Pressure) || file.inputs().has(Table::Load);
    let wet = match (file.inputs().has(Table::Wave), file.inputs().has(Table::Water)) {
        (false, false) => "",
        (false, true) => ", water included,",
        (true, _) => ", waves and water included,",
    };
    let is_lifted = rows.iter().any(|row| row.sliding == SensitivityChange::Lifted);
    Ok(html! {
        p.note {
            "Change of the safety factors and of the load factor at which the body leaves rest, if one input grows by 1 %, \
             with what has to go with it: the mass with the width, the crest with the height. The least of all loads counts in each \
             column. The whole case" (wet) " is computed anew for each, with the input 1 % larger. Where there is no number: " em { "unlimited" } ", a factor has no bound, as it is or then; " em { "at once" } ", the body moves without any \
             share of the load; " em { "no case" } ", an input 1 % larger makes no sense beside the others"
            @if is_lifted { "; " em { "lifted" } ", nothing presses the body on its base, or a joint, as it is or then, and there is no factor" }
            "."
        }
        @if stays { p.note { (STAYS) } }
        @if untold { p.note { "The pressures of a [[pressure]] have no row: they are lists, and no single input." } }
        table.numbers data-table="sensitivity" {
            thead {
                tr {
                    th { "Input" }
                    th.n { "Value" }
                    th.n { "Safety against sliding" }
                    th.n { "Safety against overturning" }
                    th.n { "Load factor" }
                }
            }
            tbody {
                @for row in &rows {
                    tr {
                        td { (row.variable.key().info().words) " " code { (row.variable.name()) } }
                        td.n { (value(row)) }
                        @for change in [row.sliding, row.overturning, row.load_factor] {
                            td.n { (signed(change)) }
                        }
                    }
                }
            }
        }
    })
}

/// The value of an input, with its unit.
pub fn value(row: &Sensitivity) -> Markup {
    html! {
        @match row.variable.shown_unit() {
            None => data value=(row.value) { (number(row.value)) },
            Some(unit) => {
                data value=(unit.of_si(row.value)) { (number(unit.of_si(row.value))) } "\u{a0}" span.unit { (unit.symbol()) }
            }
        }
    }
}

/// A change with its sign, or the word for one that is no number.
pub fn signed(change: SensitivityChange) -> Markup {
    let text = |change: f64| change_words(change).replace('-', "−");
    html! {
        @match change.number() {
            None => (change.words()),
            Some(change) => data value=(change) { (text(change)) },
        }
    }
}
