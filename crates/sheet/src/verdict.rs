//! The verdict: in short at the top, in full at the end.

use maud::{Markup, html};
use standfast::{Departure, Verdict};
use standfast_cases::assess::{AnyCheck, criteria_met, shown, verdict};
use standfast_cases::layout::percent;
use standfast_cases::{Assessed, Assessment, AssessmentView, Document};

use crate::calculation::TARGET;
use crate::measured::{FACTOR, Measured};

fn name(assessment: &Assessment, assessed: &Assessed) -> String {
    assessment.name(assessed).unwrap_or_else(|| "all loads".to_owned())
}

/// The verdict in short.
pub fn summary(assessment: &Assessment) -> Markup {
    let several = is_named(assessment);
    html! {
        section.summary {
            h2 { "Summary" }
            @if let Some(in_time) = assessment.in_time.as_ref().filter(|in_time| !in_time.motions.is_empty()) {
                @if let Some(top) = in_time.motions.summary() {
                    p.verdict { strong { (top.answer) } }
                    @if let Some(near) = &top.near { p.note { (near) } }
                }
                p.note { "At the first instant, as if the peaks stayed:" }
            }
            @for assessed in shown(assessment, &AssessmentView::default()) {
                p.verdict data-mode=(assessed.verdict().map_or("none", Verdict::symbol)) {
                    @if several { (name(assessment, assessed)) ": " }
                    @match assessed.verdict() {
                        Some(begun) => {
                            "The body " strong { (begun.words()) } " (" (begun) ")"
                            @if let Some(factor) = verdict::factor_at_rest(assessed) { ", " (factor) }
                            "."
                        }
                        None => "The body has no consistent mode.",
                    }
                    @if !assessed.outcome.full.is_unique() { " The answer is not unique; see the verdict." }
                }
            }
            @if assessment.all_checks().is_empty() {
                (table(assessment))
                p.note {
                    "The case file has no [criteria]."
                    @if assessment.case.wave.is_some() {
                        " Common practice asks for " (TARGET) " at least of both safety factors."
                    }
                }
            } @else {
                (criteria(assessment))
                (table(assessment))
            }
            @if !assessment.case.warnings().is_empty() {
                @let moves = assessment.in_time.as_ref().is_some_and(|in_time| !in_time.motions.is_empty());
                p.note {
                    "There are warnings about numbers that are unusual or outside the range of the formulas; see section "
                    (7 + usize::from(moves)) "."
                }
            }
        }
    }
}

/// True if situations are told by name: several, or the only one of a combination.
fn is_named(assessment: &Assessment) -> bool {
    assessment.all.len() > 1 || !assessment.case.combinations.is_empty()
}

/// The columns of the table of criteria, and the one that says in which situation.
const ASKED: [&str; 5] = ["Criterion", "Required", "Value", "Utilisation", ""];
const PLACE: &str = "In";

fn criteria(assessment: &Assessment) -> Markup {
    let several = is_named(assessment);
    let checks = assessment.all_checks();
    let shaken = checks.iter().any(AnyCheck::is_of_another_shaking);
    html! {
        p.verdict data-met=(assessment.met().unwrap_or(true)) { (criteria_met(assessment)) }
        table.numbers data-table="criteria" {
            thead {
                tr {
                    @for (i, column) in ASKED.iter().enumerate() { th.n[i == 2 || i == 3] { (column) } }
                    @if several || shaken { th { (PLACE) } }
                }
            }
            tbody {
                @for check in &checks {
                    @let [required, value, utilisation, met] = check.cells();
                    tr {
                        td.name { (check.words()) " " code { (check.name()) } }
                        td data-label=(ASKED[1]) { (required) }
                        td.n data-label=(ASKED[2]) { (value) }
                        td.n data-label=(ASKED[3]) { (utilisation) }
                        td { span.yes[check.is_met()].no[!check.is_met()] { (met) } }
                        @if several || shaken {
                            td data-label=(PLACE) {
                                @if several { (name(assessment, check.assessed(assessment))) }
                                @if check.is_of_another_shaking() { " another acceleration of the base" }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The columns of the table of situations; on a narrow screen each stands before its value.
const COLUMNS: [&str; 6] = [
    "Mode",
    "Safety against sliding",
    "Safety against overturning",
    "Leaves rest at, % of the load",
    "Into",
    "Unique",
];
/// Columns that hold numbers.
const NUMBERS: std::ops::RangeInclusive<usize> = 1..=3;

fn table(assessment: &Assessment) -> Markup {
    let several = is_named(assessment);
    html! {
        table.numbers data-table="summary" {
            thead {
                tr {
                    @if several { th { "Situation" } }
                    @for (i, column) in COLUMNS.iter().enumerate() { th.n[NUMBERS.contains(&i)] { (column) } }
                }
            }
            tbody {
                @for assessed in assessment.worst_first() {
                    @let (full, stability) = (&assessed.outcome.full, &assessed.outcome.stability);
                    @let factors = [stability.sliding, stability.overturning()];
                    tr {
                        @if several { td.name data-label="Situation" { (name(assessment, assessed)) } }
                        td data-label=(COLUMNS[0]) { (assessed.verdict().map_or("none", Verdict::symbol)) }
                        @for (factor, column) in factors.into_iter().zip(&COLUMNS[1..]) {
                            td.n data-label=(column) {
                                @if full.is_lifted() { "none" } @else { (Measured::of(factor, FACTOR).html("")) }
                            }
                        }
                        td.n data-label=(COLUMNS[3]) { (departure(&assessed.departure())) }
                        td data-label=(COLUMNS[4]) { (assessed.departure().verdict().map_or("–", Verdict::symbol)) }
                        td data-label=(COLUMNS[5]) { @if assessed.outcome.full.is_unique() { "yes" } @else { "no" } }
                    }
                }
            }
        }
    }
}

fn departure(departure: &Departure) -> Markup {
    html! {
        @match *departure {
            Departure::At { factor, .. } => data value=(factor) data-percent { (percent(factor).trim_end_matches(" %")) },
            _ => (verdict::departure_word(departure)),
        }
    }
}

/// The verdict in full.
pub fn full(assessment: &Assessment, view: &AssessmentView) -> Markup {
    html! {
        @for assessed in shown(assessment, view) {
            @if is_named(assessment) { h3 { (name(assessment, assessed)) } }
            @for sentence in verdict::full_load(assessed) { p { (sentence) } }
            @for sentence in verdict::path(assessed) { p { (sentence) } }
        }
        (table(assessment))
        p.note { "The margins of every inequality stand at its step in section 3." }
    }
}
