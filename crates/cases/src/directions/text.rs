//! A case over all directions as text and CSV.

use std::fmt::Write;

use standfast::footprint::{BaseWrench, PlanDeparture};
use standfast_answers::directions::{DirectionAnswer, Directions, Orbit, OrbitExit, SituationDirections};

use crate::assess::plan::{direction_words, edge_numbers, edges, leaves, symbols};
use crate::assess::{Assessed, note, title, verdict};
use crate::case::CasePlan;
use crate::layout::{columns, digits, paragraph, percent, row, significant};
use crate::summary::{Summary, warning_words};

/// The convention of all directions.
pub(super) const DIRECTIONS: &str = "Directions are those of the force on the body, seen from above: 0° to the left, 90° away from the viewer, 180° to the right.";

/// Step of the directions that are printed, degrees.
const PRINTED: f64 = 15.0;

pub(super) fn summary(directions: &Directions) -> Summary {
    let governing = directions.governing();
    let assessed = directions.assessed(governing);
    let plan = plan(directions);
    let warnings = directions.assessment.case.warnings();
    let (answer, near) = sentences(plan, assessed, governing);
    Summary {
        criteria: None,
        answer,
        met: None,
        governing: None,
        near,
        warnings: warnings.iter().map(standfast_model::Warning::name).collect(),
        warned: warnings.iter().map(|warning| warning_words(warning.name(), warning)).collect(),
    }
}

fn plan(directions: &Directions) -> &CasePlan {
    directions.assessment.case.plan.as_ref().expect("directions are those of a base seen from above")
}

/// The answer and what stands beside it: of a record its course, which the peaks of both components, turned, are not.
fn sentences(plan: &CasePlan, assessed: &Assessed, of: &SituationDirections) -> (String, Option<String>) {
    let worst = worst(plan, assessed, of);
    match along_record(plan, of) {
        Some(along) => {
            let worst = worst.replacen("In the", "in the", 1);
            (along, Some(format!("Were the peaks of both components to act at once, and turned: {worst}")))
        }
        None => (worst, None),
    }
}

/// The answer along the record of each situation of a case that has one.
pub(super) fn along_records(directions: &Directions) -> Vec<String> {
    let plan = plan(directions);
    directions.all.iter().filter_map(|of| along_record(plan, of)).collect()
}

/// The sentence of the direction that bears least.
fn worst(plan: &CasePlan, assessed: &Assessed, of: &SituationDirections) -> String {
    let loads = verdict::risen_loads(assessed);
    let Some(worst) = &of.worst else {
        return "No horizontal load varies, so that there is nothing to turn.".to_owned();
    };
    let goes = leaves(plan, &worst.departure);
    match worst.load_factor() {
        0.0 if worst.departure.at_once && !worst.departure.rests => {
            format!("The permanent loads alone move the body: it {goes}.")
        }
        f64::INFINITY => format!("No multiple of {loads} moves the body, in whichever direction it pushes."),
        factor => {
            let share = verdict::share_of_loads(assessed, factor);
            match of.is_only_worst {
                true => {
                    format!("In the worst direction, {}, the body {goes} at {share}.", degrees(worst.degrees))
                }
                false => {
                    format!("In the worst direction the body {goes} at {share}; another direction is as bad.")
                }
            }
        }
    }
}

/// The sentences on a record.
fn along_record(plan: &CasePlan, of: &SituationDirections) -> Option<String> {
    let Orbit { exit, scale, strongest, .. } = of.orbit.as_ref()?;
    let goes = |exit: &OrbitExit| leaves(plan, &exit.departure);
    Some(match (exit, strongest) {
        (Some(exit), _) => format!(
            "Along the record the body first leaves rest at {} s: it {}. It would rest throughout at less than {} of the record.",
            digits(exit.time),
            goes(exit),
            percent(*scale)
        ),
        (None, Some(strongest)) => format!(
            "The body rests along the whole record; at {} of it, it {} at {} s.",
            percent(*scale),
            goes(strongest),
            digits(strongest.time)
        ),
        (None, None) => "The body rests along the whole record, however strong.".to_owned(),
    })
}

fn degrees(degrees: f64) -> String {
    format!("{}°", significant(degrees, 5))
}

pub(super) fn text(directions: &Directions) -> String {
    let case = &directions.assessment.case;
    let plan = plan(directions);
    let mut text = title(case);
    text += &summary(directions).text();
    text += "\n";
    text += &note(case);
    let several = directions.all.len() > 1;
    for of in &directions.all {
        let assessed = directions.assessed(of);
        if several {
            let name = directions.assessment.name(assessed).unwrap_or_default();
            let _ = writeln!(text, "{name}");
            let (answer, near) = sentences(plan, assessed, of);
            text += &paragraph(&answer, 2);
            text += &near.map_or(String::new(), |words| paragraph(&words, 2));
        }
        let _ = writeln!(text, "Load factor λ of {} in each direction", verdict::risen_loads(assessed));
        text += &table(plan, directions.step, of);
        text += "\n";
    }
    text += &paragraph(DIRECTIONS, 2);
    let words = "All variable loads turn together about the vertical through C, each at its height. λ multiplies them; |X|/P is the horizontal \
                 over the vertical force on the base where rest ends.";
    text + &paragraph(words, 2)
}

fn table(plan: &CasePlan, step: f64, of: &SituationDirections) -> String {
    let mut rows = vec![row!["direction", "λ", "|X|/P", "what ends rest", "", "tips at λ"]];
    let is_printed = |answer: &&DirectionAnswer| {
        let turns = answer.degrees / PRINTED;
        step >= PRINTED || (turns - turns.round()).abs() < 1e-9
    };
    for answer in of.all.iter().filter(is_printed) {
        rows.push(cells(plan, answer, degrees(answer.degrees)));
    }
    if let Some(worst) = &of.worst {
        rows.push(cells(plan, worst, format!("worst, {}", degrees(worst.degrees))));
    }
    columns(&rows, 2, &[0, 1, 2, 5])
}

fn cells(plan: &CasePlan, answer: &DirectionAnswer, name: String) -> Vec<String> {
    let factor = |factor: f64| if factor == f64::INFINITY { "never".to_owned() } else { digits(factor) };
    let PlanDeparture { limits, wrench, .. } = &answer.departure;
    let ratio = wrench.map_or("–".to_owned(), |wrench| digits(wrench.horizontal() / wrench.p));
    let about = edges(plan, limits).join(" and ");
    let ends = symbols(&answer.departure);
    row![name, factor(answer.load_factor()), ratio, ends, about, factor(answer.tipping.load_factor)]
}

/// The directions as CSV; with the situation where there are several.
pub fn csv(directions: &Directions) -> String {
    let several = directions.all.len() > 1;
    let mut csv = String::from(if several { "situation," } else { "" });
    csv += "deg,load_factor,mode,edges,x_over_p,z_over_p,tipping_load_factor\n";
    for of in &directions.all {
        let name = directions.assessment.name(directions.assessed(of)).filter(|_| several);
        for answer in &of.all {
            if let Some(name) = &name {
                let _ = write!(csv, "\"{}\",", name.replace('"', "\"\""));
            }
            let PlanDeparture { load_factor, limits, wrench, .. } = &answer.departure;
            let [x, z] = wrench.map_or([String::new(), String::new()], |BaseWrench { x, z, p, .. }| {
                [x / p, z / p].map(|part| part.to_string())
            });
            let number = |factor: f64| {
                if factor == f64::INFINITY { "infinite".to_owned() } else { factor.to_string() }
            };
            let numbers: Vec<String> = edge_numbers(limits).iter().map(usize::to_string).collect();
            let _ = writeln!(
                csv,
                "{},{},{},{},{x},{z},{}",
                answer.degrees,
                number(*load_factor),
                symbols(&answer.departure).replace(", ", " "),
                numbers.join(" "),
                number(answer.tipping.load_factor)
            );
        }
    }
    csv
}

/// A direction and what ends rest there, in short.
pub(super) fn worst_words(plan: &CasePlan, answer: &DirectionAnswer) -> String {
    format!("{}, it {}", direction_words(answer.degrees), leaves(plan, &answer.departure))
}
