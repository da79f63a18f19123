//! The motion in time of a case: what it is asked of, what becomes of the body, and what the model leaves out.

use maud::{Markup, html};
use standfast::{InputError, Wrench};
use standfast_cases::assess::MotionAssessment;
use standfast_cases::directions::along_records;
use standfast_cases::layout::digits;
use standfast_cases::motion::{self, BlockCase, FirstInstant, FollowedMotion, LoadPeak, MotionView, Rows};
use standfast_cases::units::Dimension;
use standfast_cases::{AnswerFigure, Case, CaseFile, Document};

/// At most so many situations are shown one by one.
const SHOWN: usize = 8;

/// The lines of the case file that belong to time.
///
/// On a base seen from above no motion is followed; what is told there is where rest ends along the record.
pub fn inputs(file: &CaseFile, first: &FirstInstant, is_on_plan: bool) -> Markup {
    let along = if is_on_plan { along_records(file) } else { Vec::new() };
    html! {
        h3 { "In time" }
        p.note { "These lines of the case file give the course of the loads, the motion of the base, and the criteria on the motion:" }
        pre.written data-table="in-time" { @for line in file.lines_in_time() { (line) "\n" } }
        @if is_on_plan {
            p.note { "In sections 2 to 4, " (first.of_instant()) "; no motion is followed." }
            @for words in &along { p { (words) } }
        } @else {
            p.note { "In sections 2 to 4, " (first.of_instant()) "; section 5 follows the motion in time." }
        }
    }
}

/// Motions of the body, in each situation.
pub fn motions(in_time: &MotionAssessment, case: &Case) -> Markup {
    let all = &in_time.motions;
    html! {
        p.note {
            "The motion is followed event by event from rest to its end, by closed forms and power series between events that are roots of \
             them. Slide is to the right, θ counter-clockwise; moments are about the centre of mass. Energies are per mass, the weight \
             left out of the work."
        }
        @for followed in all.iter().take(SHOWN) { (motion_of(followed, case)) }
        @if all.len() > SHOWN { p.note { "Of " (all.len()) " situations the " (SHOWN) " worst are shown here." } }
    }
}

fn motion_of(followed: &FollowedMotion, case: &Case) -> Markup {
    let block = &followed.case;
    html! {
        @if let Some(situation) = &block.situation { h3 { "Motion under " (situation) } }
        p.verdict data-motion=(followed.outcome.overturned()) { (motion::verdict(followed)) }
        h4 { "Loads at their peaks" }
        (peaks(block, case))
        h4 { "Results" }
        (table("in-time-results", &[], &motion::number_rows(followed)))
        h4 { "Events" }
        (table("in-time-events", &["When", "Why", "State that goes on"], &motion::event_rows(followed)))
        h4 { "Energy per mass, J/kg" }
        (table("in-time-energy", &[], &motion::energy_rows(followed)))
        p { (motion::uniqueness(followed)) }
        @for warning in &followed.warnings { p { "Note (" code { (warning.name) } "): " (warning.words) "." } }
    }
}

/// Every load at the peak of its history, and the base at that of its acceleration.
fn peaks(block: &BlockCase, case: &Case) -> Markup {
    let base = &block.problem.base;
    let shaken = [("to the right", &base.horizontal), ("upwards", &base.vertical)];
    let output = case.output;
    let [force, moment] = [Dimension::Force, Dimension::Moment].map(|dimension| output.symbol(dimension));
    let written = |wrench: &Wrench| {
        [(-wrench.x, Dimension::Force), (wrench.p, Dimension::Force), (wrench.m, Dimension::Moment)]
            .map(|(value, dimension)| output.value(dimension, value + 0.0))
    };
    html! {
        @if !block.peaks.is_empty() {
            table.numbers data-table="in-time-peaks" {
                thead {
                    tr {
                        th { "Load" } th.n { "To the left, " (force) } th.n { "Down, " (force) }
                        th.n { "Moment, " (moment) } th {}
                    }
                }
                tbody {
                    @for LoadPeak { name, permanent, wrench } in &block.peaks {
                        tr {
                            td.name { (name) }
                            @for value in written(wrench) { td.n { (value) } }
                            td { @if *permanent { "all the time" } }
                        }
                    }
                }
            }
        }
        @for (direction, history) in shaken {
            @if let Some(history) = history {
                p {
                    "The base moves: its acceleration " (direction) " reaches " (digits(history.peak())) " m/s², "
                    (digits(history.peak() / case.gravity)) " of gravity."
                }
            }
        }
    }
}

fn table(name: &str, head: &[&str], rows: &Rows) -> Markup {
    html! {
        table.numbers data-table=(name) {
            @if !head.is_empty() { thead { tr { @for cell in head { th { (cell) } } } } }
            tbody {
                @for row in rows { tr { @for (i, cell) in row.iter().enumerate() { td.n[head.is_empty() && i == 1] { (cell) } } } }
            }
        }
    }
}

/// Histories and positions of the worst situation; what moves has no place on paper.
///
/// # Errors
/// If a figure's numbers are out of range.
pub fn figures(in_time: &MotionAssessment) -> Result<Vec<AnswerFigure>, InputError> {
    let figures = in_time.motions.figures(&MotionView::default())?;
    Ok(figures.into_iter().filter(|figure| figure.suffix != "-animation").collect())
}

/// Limits of the motion in time.
pub fn limits() -> Markup {
    html! {
        p { "The motion in time assumes further:" }
        ul {
            li { "body and base are rigid and flat, the motion is plane, and the body stands on two corners;" }
            li { "the ground does not settle or fail, and there is no pressure of pore water;" }
            li { "water that moves with the body does so as if it did not turn, and the water under a lifted base presses as before;" }
            li { "at an impact the body does not bounce, unless a measured ratio is given; and a body that rocks under a record is \
                  sensitive to every number, so that one motion is an example of what may happen." }
        }
    }
}
