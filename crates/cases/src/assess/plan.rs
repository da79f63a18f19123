//! Words on a base seen from above: the edges by their names, the directions, what ends rest there.

use serde::Serialize;
use standfast::footprint::{BaseWrench, PlanDeparture, PlanLimit};
use standfast::{Bearing, Departure, Mode, PlanOutcome};

use standfast_answers::directions::{DirectionAnswer, SituationDirections};
use standfast_answers::results::number_or_word;

use super::{Assessed, Component, verdict};
use crate::case::{Case, CasePlan, PlanOf};
use crate::json::optional_number_or_word;
use crate::layout::{columns, digits, paragraph, percent, row};
use crate::summary::listed;
use crate::units::Dimension;

/// An edge of the base as it stands in a sentence: "its left edge", "the edge from foot 3 to foot 1".
pub fn edge_words(plan: &CasePlan, edge: usize) -> String {
    let given = plan.base.footprint.given();
    let corner = |place: usize| given[place % given.len()] + 1;
    let between =
        |what: &str| format!("the edge from {what} {} to {what} {}", corner(edge), corner(edge + 1));
    match plan.of {
        _ if given.is_empty() => "its rim".to_owned(),
        PlanOf::Body => {
            let names = [
                "its edge towards the viewer",
                "its right edge",
                "its edge away from the viewer",
                "its left edge",
            ];
            names[edge % names.len()].to_owned()
        }
        PlanOf::Feet(_) => between("foot"),
        PlanOf::Polygon(_) | PlanOf::Circle => between("corner"),
    }
}

/// A direction seen from above, as it stands in a sentence: "to the left", "towards 30°".
pub fn direction_words(degrees: f64) -> String {
    match degrees {
        0.0 => "to the left".to_owned(),
        90.0 => "away from the viewer".to_owned(),
        180.0 => "to the right".to_owned(),
        270.0 => "towards the viewer".to_owned(),
        degrees => format!("towards {}°", digits(degrees)),
    }
}

/// The edges about which a body tips, from zero.
fn tipped(limits: &[PlanLimit]) -> impl Iterator<Item = usize> + '_ {
    limits.iter().filter_map(|limit| match limit {
        PlanLimit::Tips { edge } => Some(*edge),
        _ => None,
    })
}

/// The same as they stand in a sentence.
pub(crate) fn edges(plan: &CasePlan, limits: &[PlanLimit]) -> Vec<String> {
    tipped(limits).map(|edge| edge_words(plan, edge)).collect()
}

/// The same from one.
pub(crate) fn edge_numbers(limits: &[PlanLimit]) -> Vec<usize> {
    tipped(limits).map(|edge| edge + 1).collect()
}

/// What a body does that leaves rest, as a predicate with its symbol: "tips about its left edge (RO)".
pub fn leaves(plan: &CasePlan, departure: &PlanDeparture) -> String {
    let direction = departure.wrench.and_then(|wrench| wrench.direction_deg());
    let towards = direction.map_or(String::new(), |degrees| format!(" {}", direction_words(degrees)));
    let edges = edges(plan, &departure.limits);
    let mut does = Vec::new();
    if departure.limits.contains(&PlanLimit::Slides) {
        does.push(format!("slides{towards} (SL)"));
    }
    if departure.limits.contains(&PlanLimit::Turns) {
        does.push(format!("slides{towards} and turns (SL)"));
    }
    if !edges.is_empty() {
        does.push(format!("tips about {} (RO)", listed(&edges)));
    }
    if departure.limits.contains(&PlanLimit::Lifts) {
        does.push("is lifted (FL)".to_owned());
    }
    does.join(" and ")
}

/// What ends rest, each symbol once.
pub(crate) fn modes(departure: &PlanDeparture) -> Vec<&'static str> {
    let mut symbols: Vec<&str> = departure.limits.iter().map(symbol).collect();
    symbols.dedup();
    symbols
}

/// The same in words.
pub fn symbols(departure: &PlanDeparture) -> String {
    modes(departure).join(", ")
}

/// How near another answer is: where the rising `loads` first move the body.
pub(super) fn near(plan: &CasePlan, assessed: &Assessed, answer: &PlanOutcome, loads: &str) -> String {
    let goes = leaves(plan, &answer.departure);
    match assessed.departure() {
        Departure::AtOnce { permanent: true, .. } => format!("the permanent loads alone move it: it {goes}."),
        Departure::AtOnce { permanent: false, .. } => format!("any share of {loads} moves it: it {goes}."),
        Departure::At { factor, .. } => {
            format!("at {} it {goes}.", verdict::share_of_loads(assessed, factor))
        }
        Departure::Never if assessed.rises() => format!("no multiple of {loads} moves it."),
        Departure::Never => String::new(),
    }
}

/// The base, as the body's own list tells it.
pub(super) fn base(case: &Case) -> Option<String> {
    let plan = case.plan.as_ref()?;
    let output = case.output;
    let footprint = &plan.base.footprint;
    let least = footprint.distances().into_iter().fold(f64::INFINITY, f64::min);
    let of = match plan.of {
        PlanOf::Body if footprint.disc().is_some() => "the circle of the body".to_owned(),
        PlanOf::Body => "width by length".to_owned(),
        PlanOf::Circle => format!("a disc of {}", output.length(2.0 * footprint.disc()?.1)),
        PlanOf::Polygon(count) => hull(count, footprint.given().len(), "corners"),
        PlanOf::Feet(count) => hull(count, footprint.given().len(), "feet"),
    };
    Some(format!("{of}; its nearest edge is {} from below C", output.length(least)))
}

fn hull(count: usize, used: usize, what: &str) -> String {
    match count - used {
        0 => format!("{count} {what}"),
        inside => format!("{count} {what}, {inside} of them within the hull of the others"),
    }
}

/// The loads, each with its share to the left, away from the viewer and down.
pub(super) fn components(assessed: &Assessed) -> String {
    let output = assessed.output;
    let force = output.symbol(Dimension::Force);
    let force = force.as_str();
    let mut rows = vec![row!["", "", "left", "away", "down"], row!["load", "", force, force, force]];
    let number = |number: f64| output.value(Dimension::Force, number);
    for Component { name, load, wrench } in assessed.components() {
        let away = assessed.situation.away(&load);
        let share = if load.permanent { "permanent" } else { "variable" };
        rows.push(row![name, share, number(0.0 - wrench.x), number(away), number(wrench.p)]);
    }
    if let Some(PlanOutcome { full, .. }) = &assessed.outcome.plan {
        rows.push(row!["sum", "", number(0.0 - full.x), number(full.z), number(full.p)]);
    }
    columns(&rows, 2, &[2, 3, 4])
}

/// What the base carries and its safety factors.
pub(super) fn factors(case: &Case, assessed: &Assessed, answer: &PlanOutcome) -> String {
    let Some(plan) = &case.plan else { return String::new() };
    let output = assessed.output;
    let full = &answer.full;
    let mut rows = vec![row!["P", output.force(full.p), "downwards"]];
    let towards = full.direction_deg().map_or(String::new(), direction_words);
    rows.push(row!["|X|", output.force(full.horizontal()), towards]);
    let at = match full.centre_of_pressure() {
        Some([x, z]) => {
            let beside = |place: f64, [below, above]: [&str; 2]| {
                let words = if place < 0.0 { below } else { above };
                (place != 0.0).then(|| format!("{} {words}", output.length(place.abs())))
            };
            let x = beside(x, ["to the left of C", "to the right of C"]);
            let z = beside(z, ["towards the viewer", "away from the viewer"]);
            let both: Vec<String> = x.into_iter().chain(z).collect();
            if both.is_empty() { "below C".to_owned() } else { both.join(", ") }
        }
        None => "none: nothing presses the body on its base".to_owned(),
    };
    rows.push(row!["c", at, ""]);
    let torsion = full.torsion();
    if on_a_disc_turns(plan, full) {
        rows.push(row![
            "T",
            output.moment(torsion),
            "about the vertical through c, counter-clockwise from above"
        ]);
    }
    let mut text = "\nOn the base\n".to_owned() + &columns(&rows, 2, &[]);
    text += "\nSafety factors\n";
    let stability = &assessed.outcome.stability;
    let factor = |factor: f64| match stability.bearing {
        Bearing::Lifted => "none".to_owned(),
        _ => output.factor(factor),
    };
    let about = match answer.edge {
        Some(edge) => format!("about {}", edge_words(plan, edge)),
        None => "no horizontal force turns the body".to_owned(),
    };
    let sliding = match on_a_disc_turns(plan, full) {
        true => "μP/√(X² + T²/(R² − c²))",
        false => "μP/|X|",
    };
    let rows = [
        row!["sliding", sliding, factor(stability.sliding)],
        row!["overturning", about, factor(stability.overturning())],
    ];
    text + &columns(&rows, 2, &[])
}

/// True if the loads turn the body about the vertical, which only a disc bears.
fn on_a_disc_turns(plan: &CasePlan, full: &BaseWrench) -> bool {
    plan.base.footprint.on_friction(full) > full.horizontal()
}

/// The verdict under the full load and on the way there.
pub(super) fn verdict(case: &Case, assessed: &Assessed, answer: &PlanOutcome) -> String {
    let Some(plan) = &case.plan else { return String::new() };
    let directions =
        "Directions are seen from above: 0° to the left, 90° away from the viewer, 180° to the right."
            .to_owned();
    let sentences = sentences(plan, assessed, answer).into_iter().chain([directions]);
    sentences.map(|sentence| paragraph(&sentence, 2)).collect()
}

/// Sentences on the full load and on the way there.
pub fn sentences(plan: &CasePlan, assessed: &Assessed, answer: &PlanOutcome) -> Vec<String> {
    let rests = assessed.mode() == Some(Mode::Rest);
    let full = match rests {
        true => {
            let factor =
                verdict::factor_at_rest(assessed).map_or(String::new(), |factor| format!(", {factor}"));
            format!("Under the full load, applied suddenly, the body stays at rest (RE){factor}.")
        }
        false => "The body does not rest under the full load. How it then moves in space is not computed."
            .to_owned(),
    };
    let goes = leaves(plan, &answer.departure);
    let loads = if assessed.rises() { verdict::risen_loads(assessed) } else { String::new() };
    let departs = match assessed.departure() {
        Departure::Never if loads.is_empty() => "No variable load acts, so no load rises.".to_owned(),
        Departure::Never => format!("No multiple of {loads} moves the body."),
        Departure::AtOnce { permanent: true, .. } => {
            format!("The permanent loads alone move the body: it {goes}.")
        }
        Departure::AtOnce { .. } => {
            format!("Any share of {loads}, however small, moves the body: it {goes}.")
        }
        Departure::At { factor, .. } => {
            format!("As {loads} rises, the body {goes} from {} on.", percent(factor))
        }
    };
    vec![full, departs]
}

/// The answer of a base seen from above, as JSON tells it.
#[derive(Debug, Serialize)]
pub(super) struct PlanEntry {
    /// True if the full load is borne at rest.
    rests: bool,
    load_factor: Option<f64>,
    /// With the pressure that is best, and with that which is worst; the same where the loads do not turn the body about the vertical, and on a
    /// disc.
    load_factor_possible: Option<f64>,
    load_factor_certain: Option<f64>,
    pressure_matters: bool,
    /// What ends rest: `SL`, `RO` or `FL`.
    mode: Option<&'static str>,
    /// The edge about which the body tips, from one, or the rim.
    contact: Option<String>,
    /// All edges about which it does.
    edges: Vec<usize>,
    /// The direction in which it slides, degrees.
    slip_deg: Option<f64>,
    /// The direction of the horizontal force where rest ends, degrees.
    direction_deg: Option<f64>,
    worst_direction_deg: Option<f64>,
    #[serde(serialize_with = "optional_number_or_word")]
    load_factor_worst: Option<f64>,
    /// False if another direction bears as little.
    unique_in_direction: Option<bool>,
    /// Angular acceleration, which is not found.
    alpha: Option<[f64; 3]>,
    /// [x, z] from below the centre of mass, m, under the full load.
    centre_of_pressure: Option<[f64; 2]>,
    /// The moment about the vertical through it.
    moment_about_it: f64,
    /// The full load: to the right and away, and downwards.
    horizontal: [f64; 2],
    vertical: f64,
    /// The edge with the least factor against overturning, from one; the rim of a disc is one too.
    governing_edge: Option<usize>,
    /// h_i, m.
    edge_distances: Vec<f64>,
}

/// A direction among the others.
#[derive(Debug, Serialize)]
pub(super) struct DirectionEntry {
    deg: f64,
    #[serde(serialize_with = "number_or_word")]
    load_factor: f64,
    mode: Option<&'static str>,
}

/// Step of the directions of a situation, degrees.
const STEP: f64 = 15.0;

impl PlanEntry {
    pub(super) fn of(assessed: &Assessed) -> Option<(PlanEntry, Vec<DirectionEntry>)> {
        let PlanOutcome { departure, full, edge } = assessed.outcome.plan.as_ref()?;
        let footprint = &assessed.situation.plan()?.footprint;
        let load_factor = match assessed.departure() {
            Departure::At { factor, .. } => Some(factor),
            _ => None,
        };
        let direction_deg = departure.wrench.and_then(|wrench| wrench.direction_deg());
        let edges = edge_numbers(&departure.limits);
        let mode = modes(departure).first().copied();
        let contact = edges.first().filter(|_| mode == Some("RO")).map(|edge| match footprint.disc() {
            Some(_) => "rim".to_owned(),
            None => format!("edge {edge}"),
        });
        // Turned, they may have a moment about the vertical that no polygon has an answer to.
        let directions = SituationDirections::of(assessed, STEP).ok();
        let all = directions.iter().flat_map(|directions| &directions.all).map(|answer| DirectionEntry {
            deg: answer.degrees,
            load_factor: answer.load_factor(),
            mode: modes(&answer.departure).first().copied(),
        });
        let all = all.collect();
        let worst = directions.as_ref().and_then(|directions| directions.worst.as_ref());
        let entry = PlanEntry {
            rests: departure.rests,
            load_factor,
            load_factor_possible: load_factor,
            load_factor_certain: load_factor,
            pressure_matters: false,
            mode,
            contact,
            edges,
            slip_deg: direction_deg.filter(|_| mode == Some("SL")),
            direction_deg,
            worst_direction_deg: worst.map(|worst| worst.degrees),
            load_factor_worst: worst.map(DirectionAnswer::load_factor),
            unique_in_direction: worst.and(directions.as_ref()).map(|directions| directions.is_only_worst),
            alpha: None,
            centre_of_pressure: full.centre_of_pressure(),
            moment_about_it: full.torsion(),
            horizontal: [full.x, full.z],
            vertical: full.p,
            governing_edge: edge.map(|edge| edge + 1),
            edge_distances: footprint.distances(),
        };
        Some((entry, all))
    }
}

fn symbol(limit: &PlanLimit) -> &'static str {
    match limit {
        PlanLimit::Slides | PlanLimit::Turns => "SL",
        PlanLimit::Tips { .. } => "RO",
        PlanLimit::Lifts => "FL",
    }
}
