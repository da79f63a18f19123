//! The verdict: in short at the top, in full at the end.

use maud::{Markup, html};
use standfast::{Mode, Stability};
use standfast_cases::describe;
use standfast_cases::layout::digits;
use standfast_cases::{Assessed, Assessment, Case, load_name};

use crate::calculation::TARGET;
use crate::quantity::{NONE, Quantity};

/// One load's verdict in numbers.
struct Line {
    name: String,
    mode: Option<Mode>,
    sliding: Option<f64>,
    overturning: Option<f64>,
    unique: bool,
    /// Where the body leaves rest, as a share of the load.
    leaves_rest: Option<f64>,
    /// How far the load was followed, if it was.
    looked_to: Option<f64>,
    into: Option<Mode>,
    sentences: Vec<String>,
}

fn lines(case: &Case, assessment: &Assessment<'_>) -> Vec<Line> {
    match assessment.situations() {
        [] => (0..case.loads.len()).map(|i| plain(case, i)).collect(),
        all => all.iter().map(|assessed| together(case, assessed)).collect(),
    }
}

fn plain(case: &Case, index: usize) -> Line {
    let reduced = &case.loads[index].reduced;
    let point = &reduced.point;
    let departure = point.margins().leaves_rest();
    Line {
        name: load_name(case, index),
        mode: Some(reduced.mode()),
        sliding: Some(point.safety_against_sliding()),
        overturning: Some(point.safety_against_overturning()),
        unique: point.is_unique(),
        leaves_rest: departure.filter(|_| point.k() > 0.0).map(|crossing| crossing.at / point.k()),
        looked_to: None,
        into: departure.map(|crossing| reduced.orient(crossing.to)),
        sentences: vec![describe::verdict(reduced), describe::uniqueness(reduced)],
    }
}

fn together(case: &Case, assessed: &Assessed) -> Line {
    let Stability { sliding, .. } = assessed.stability;
    let pressed = !assessed.full.is_lifted();
    let departure = assessed.departure();
    let mut sentences = assessed.full_load_words();
    sentences.extend(assessed.path_words());
    Line {
        name: assessed.loaded.load.map_or_else(|| "all loads".to_owned(), |load| load_name(case, load)),
        mode: assessed.full.mode,
        sliding: pressed.then_some(sliding),
        overturning: pressed.then(|| assessed.stability.least_overturning()),
        unique: assessed.full.is_unique(),
        leaves_rest: departure.map(|stage| stage.from),
        looked_to: (!assessed.path.is_empty()).then_some(assessed.up_to),
        into: departure.and_then(|stage| stage.mode),
        sentences,
    }
}

/// The verdict in short.
pub fn summary(case: &Case, assessment: &Assessment<'_>) -> Markup {
    let lines = lines(case, assessment);
    html! {
        section.summary {
            h2 { "Summary" }
            @for line in &lines {
                p.verdict data-mode=(line.mode.map_or("none", Mode::symbol)) {
                    @if lines.len() > 1 { (line.name) ": " }
                    @match line.mode {
                        Some(mode) => { "The body " strong { (mode.words()) } " (" (mode) ")." }
                        None => "The body has no consistent mode.",
                    }
                    @if !line.unique { " The answer is not unique; see the verdict." }
                }
            }
            (table(&lines))
            p.note { "Common practice asks for " (TARGET) " at least of both safety factors." }
            @if !case.warnings().is_empty() {
                p.note { "There are warnings about the range of the formulas; see section 7." }
            }
        }
    }
}

fn table(lines: &[Line]) -> Markup {
    let several = lines.len() > 1;
    html! {
        table.numbers data-table="summary" {
            thead {
                tr {
                    @if several { th { "Load" } }
                    th { "Mode" }
                    th.n { "Safety against sliding" }
                    th.n { "Safety against overturning" }
                    th.n { "Leaves rest at, % of the load" }
                    th { "Into" }
                    th { "Unique" }
                }
            }
            tbody {
                @for line in lines {
                    tr {
                        @if several { td { (line.name) } }
                        td { (line.mode.map_or("none", Mode::symbol)) }
                        td.n { (factor(line.sliding)) }
                        td.n { (factor(line.overturning)) }
                        td.n {
                            @match (line.leaves_rest, line.looked_to) {
                                (Some(share), _) => data value=(share) data-percent { (digits(100.0 * share)) },
                                (None, Some(share)) => { "> " data value=(share) data-percent { (digits(100.0 * share)) } }
                                (None, None) => "–",
                            }
                        }
                        td { (line.into.map_or("–", Mode::symbol)) }
                        td { @if line.unique { "yes" } @else { "no" } }
                    }
                }
            }
        }
    }
}

fn factor(factor: Option<f64>) -> Markup {
    html! {
        @match factor {
            Some(factor) => (Quantity::of(factor, NONE).html("")),
            None => "none",
        }
    }
}

/// The verdict in full.
pub fn full(case: &Case, assessment: &Assessment<'_>) -> Markup {
    let lines = lines(case, assessment);
    html! {
        @for line in &lines {
            @if lines.len() > 1 { h3 { (line.name) } }
            @for sentence in &line.sentences { p { (sentence) } }
        }
        (table(&lines))
        p.note { "The margins of every inequality stand at its step in section 3." }
    }
}
