//! Effect on the safety of a small change of every number.

use maud::{Markup, html};
use standfast_cases::couple::STAYS;
use standfast_cases::design::{Sensitivity, SensitivityChange, sensitivities};
use standfast_cases::key::Table;
use standfast_cases::{CaseError, CaseFile};

use crate::measured::number;

pub fn table(file: &CaseFile) -> Result<Markup, CaseError> {
    let rows = sensitivities(file)?;
    let stays = file.inputs().has(Table::Pressure) || file.inputs().has(Table::Load);
    let wet = match (file.inputs().has(Table::Wave), file.inputs().has(Table::Water)) {
        (false, false) => "",
        (false, true) => ", water included,",
        (true, _) => ", waves and water included,",
    };
    Ok(html! {
        p.note {
            "Change of the safety factors and of the load factor at which the body leaves rest, if one input grows by 1 %, \
             with what has to go with it: the mass with the width, the crest with the height. The least of all loads counts in each \
             column. The whole case" (wet) " is computed anew for each, with the input 1 % larger. Where there is no number: " em { "unlimited" } ", a factor has no bound, as it is or then; " em { "at once" } ", the body moves without any \
             share of the load; " em { "no case" } ", an input 1 % larger makes no sense beside the others."
        }
        @if stays { p.note { (STAYS) } }
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
                        td { code { (row.variable.name()) } }
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
        data value=(row.value) { (number(row.value)) }
        @if let Some(dimension) = row.variable.dimension() {
            "\u{a0}" span.unit { (dimension.symbol()) }
        }
    }
}

/// A change with its sign, or the word for one that is no number.
pub fn signed(change: SensitivityChange) -> Markup {
    let text = |change: f64| match format!("{change:+.5}").replace('-', "−") {
        zero if zero.ends_with("0.00000") => "0".to_owned(),
        text => text,
    };
    html! {
        @match change.number() {
            None => (change.words()),
            Some(change) => data value=(change) { (text(change)) },
        }
    }
}
