//! The verdict: in short at the top, in full at the end.

use maud::{Markup, html};
use standfast::{Departure, Verdict};
use standfast_cases::assess::{AnyCheck, joints, pair_words, plan, verdict};
use standfast_cases::design::{overturning, sliding};
use standfast_cases::layout::percent;
use standfast_cases::random::Probability;
use standfast_cases::{Assessed, Assessment, Document, Summary};

use crate::calculation::{Situations, TARGET};
use crate::measured::{FACTOR, Measured};
use crate::probability::Chance;

fn name(assessment: &Assessment, assessed: &Assessed) -> String {
    assessment.name(assessed).unwrap_or_else(|| "all loads".to_owned())
}

/// Top of an answer, and what stands before it.
pub struct Top {
    lead: Option<&'static str>,
    summary: Summary,
}

/// Tops of the answers on a sheet, in the order they are read: probability, motion, and the case with its numbers as they are.
pub fn tops(assessment: &Assessment, chance: Option<&Probability>) -> Vec<Top> {
    let motion = assessment.in_time.as_ref().and_then(|in_time| in_time.motions.summary());
    let given = match (chance.is_some(), motion.is_some()) {
        (_, true) => Some("At the first instant, as if the peaks stayed:"),
        (true, false) => Some("With every number as the case file has it:"),
        (false, false) => None,
    };
    let chance = chance.and_then(Document::summary).map(|summary| Top { lead: None, summary });
    let motion = motion.map(|summary| {
        let lead = chance.is_some().then_some("With every number as the case file has it:");
        Top { lead, summary }
    });
    let assessed = assessment.summary().map(|summary| Top { lead: given, summary });
    [chance, motion, assessed].into_iter().flatten().collect()
}

impl Top {
    /// Whether the criteria are met and which governs, what happens, and how near another answer is.
    fn lines(&self) -> Markup {
        let Top { lead, summary: Summary { criteria, answer, met, near, .. } } = self;
        html! {
            @if let Some(lead) = lead { p.note { (lead) } }
            @if let Some(criteria) = criteria {
                p.verdict data-met=(met.unwrap_or(true)) { strong { (sentence(criteria)) } }
            }
            p.verdict { (sentence(answer)) }
            @if let Some(near) = near { p.near { (sentence(near)) } }
        }
    }
}

/// A sentence with what stands between backticks as code.
fn sentence(text: &str) -> Markup {
    html! {
        @for (i, part) in text.split('`').enumerate() {
            @if i % 2 == 0 { (part) } @else { code { (part) } }
        }
    }
}

/// The sentences of some answers, for measuring them.
pub fn words(tops: &[Top]) -> Vec<String> {
    let of = |top: &Top| {
        let Summary { criteria, answer, near, .. } = &top.summary;
        let lead = top.lead.map(str::to_owned);
        [lead, criteria.clone(), Some(answer.clone()), near.clone()].into_iter().flatten().collect::<Vec<_>>()
    };
    tops.iter().flat_map(of).collect()
}

/// The three lines of each answer, and the names of the warnings; `warned` says where their words are.
pub fn lines(tops: &[Top], warned: &str) -> Markup {
    let mut warnings: Vec<&str> = Vec::new();
    for name in tops.iter().flat_map(|top| &top.summary.warnings) {
        if !warnings.contains(name) {
            warnings.push(name);
        }
    }
    html! {
        @for top in tops { (top.lines()) }
        @if !warnings.is_empty() {
            p.note data-warnings {
                "Warnings, in words " (warned) ": "
                @for (i, name) in warnings.iter().enumerate() { @if i > 0 { ", " } code { (name) } }
                "."
            }
        }
    }
}

/// The verdict in short; `warned` says where the words of the warnings are.
pub fn summary(assessment: &Assessment, tops: &[Top], chance: Option<&Chance<'_>>, warned: &str) -> Markup {
    html! {
        section.summary {
            h2 { "Summary" }
            @if let Some(why) = chance.and_then(Chance::why_not) { p.note { "No probability is found: " (why) "." } }
            (lines(tops, warned))
            @if assessment.all_checks().is_empty() {
                (table(assessment, usize::MAX))
                p.note {
                    "The case file has no [criteria]."
                    @if assessment.case.goda().is_some() {
                        " Common practice asks for " (TARGET) " at least of both safety factors."
                    }
                }
            } @else {
                (criteria(assessment))
                (table(assessment, usize::MAX))
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

/// The way in which a criterion is met worst, where that is not the one that is worst as a whole.
fn other_trial(assessment: &Assessment, check: &AnyCheck<'_>) -> String {
    match pair_words(&assessment.case, check.assessed(assessment)) {
        Some(words) => format!(" with {words}"),
        None => " another acceleration of the base".to_owned(),
    }
}

fn criteria(assessment: &Assessment) -> Markup {
    let several = is_named(assessment);
    let checks = assessment.all_checks();
    let shaken = checks.iter().any(AnyCheck::is_of_another_trial);
    html! {
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
                        td.name { (check.words()) " " code { (check.name()) } (check.on_joint()) }
                        td data-label=(ASKED[1]) { (required) }
                        td.n data-label=(ASKED[2]) { (value) }
                        td.n data-label=(ASKED[3]) { (utilisation) }
                        td { span.yes[check.is_met()].no[!check.is_met()] { (met) } }
                        @if several || shaken {
                            td data-label=(PLACE) {
                                @if several { (name(assessment, check.assessed(assessment))) }
                                @if check.is_of_another_trial() { (other_trial(assessment, check)) }
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

/// The table of the situations, the worst first, of at most so many.
pub fn table(assessment: &Assessment, most: usize) -> Markup {
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
                @for assessed in assessment.worst_first().into_iter().take(most) {
                    @let factors = [sliding(assessed), overturning(assessed)];
                    tr {
                        @if several { td.name data-label="Situation" { (name(assessment, assessed)) } }
                        td data-label=(COLUMNS[0]) {
                            @match &assessed.joints {
                                Some(joints) => (joints::symbols(assessed, joints)),
                                None => (assessed.verdict().map_or("none", Verdict::symbol)),
                            }
                        }
                        @for (factor, column) in factors.into_iter().zip(&COLUMNS[1..]) {
                            td.n data-label=(column) {
                                @if assessed.is_lifted() { "none" } @else { (Measured::of(factor, FACTOR).html("")) }
                            }
                        }
                        td.n data-label=(COLUMNS[3]) { (departure(&assessed.departure())) }
                        td data-label=(COLUMNS[4]) {
                            @match (joints::first_words(assessed), &assessed.outcome.plan) {
                                (Some(joint), _) => (joint),
                                (None, Some(answer)) => (plan::symbols(&answer.departure)),
                                (None, None) => (assessed.departure().verdict().map_or("–", Verdict::symbol)),
                            }
                        }
                        td data-label=(COLUMNS[5]) {
                            @match assessed.is_unique() { Some(true) => "yes", Some(false) => "no", None => "–" }
                        }
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

/// The sentences on the full load and on the way there.
fn sentences(assessment: &Assessment, assessed: &Assessed) -> Vec<String> {
    match (&assessment.case_of(assessed).plan, &assessed.outcome.plan) {
        (Some(of_case), Some(answer)) => plan::sentences(of_case, assessed, answer),
        _ => verdict::full_load(assessed).into_iter().chain(verdict::path(assessed)).collect(),
    }
}

/// The verdict in full.
pub fn full(assessment: &Assessment, situations: &Situations<'_>) -> Markup {
    html! {
        @for assessed in situations.all() {
            p {
                @if is_named(assessment) { strong { (name(assessment, assessed)) ":" } " " }
                @for sentence in sentences(assessment, assessed) { (sentence) " " }
            }
        }
        p.note { "The table of the summary has the factors of every situation; the margins of every inequality stand at its step in section 3." }
    }
}
