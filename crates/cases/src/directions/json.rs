//! A case over all directions as JSON.

use serde::Serialize;
use standfast::footprint::{BaseWrench, PlanDeparture};
use standfast_answers::directions::{DirectionAnswer, Directions, Orbit, OrbitExit, SituationDirections};
use standfast_answers::results::number_or_word;

use crate::assess::plan::{edge_numbers, modes};
use crate::json::{SCHEMA, written};

/// Every key is there in every answer, as docs/directions.schema.json has them: `null` where there is no such thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    step_deg: f64,
    summary: crate::summary::Summary,
    situations: Vec<Situation>,
    figures: &'a [String],
}

#[derive(Serialize)]
struct Situation {
    name: Option<String>,
    friction: f64,
    height: f64,
    /// The full load: horizontal over vertical force, to the right and away.
    full: Option<[f64; 2]>,
    worst_direction_deg: Option<f64>,
    unique_in_direction: bool,
    #[serde(serialize_with = "crate::json::optional_number_or_word")]
    load_factor: Option<f64>,
    worst: Option<Direction>,
    directions: Vec<Direction>,
    record: Option<Record>,
}

#[derive(Serialize)]
struct Direction {
    deg: f64,
    #[serde(serialize_with = "number_or_word")]
    load_factor: f64,
    mode: Vec<&'static str>,
    edges: Vec<usize>,
    /// Horizontal over vertical force at which rest ends: to the right, and away.
    at: Option<[f64; 2]>,
    #[serde(serialize_with = "number_or_word")]
    tipping_load_factor: f64,
}

#[derive(Serialize)]
struct Record {
    /// The part of the record at which rest ends.
    #[serde(serialize_with = "number_or_word")]
    scale: f64,
    first_exit: Option<Exit>,
    strongest: Option<Exit>,
}

#[derive(Serialize)]
struct Exit {
    time: f64,
    direction_deg: Option<f64>,
    mode: Vec<&'static str>,
    edges: Vec<usize>,
}

fn over(wrench: &BaseWrench) -> [f64; 2] {
    [wrench.x / wrench.p, wrench.z / wrench.p]
}

impl Direction {
    fn of(answer: &DirectionAnswer) -> Direction {
        let PlanDeparture { load_factor, limits, wrench, .. } = &answer.departure;
        Direction {
            deg: answer.degrees,
            load_factor: *load_factor,
            mode: modes(&answer.departure),
            edges: edge_numbers(limits),
            at: wrench.as_ref().map(over),
            tipping_load_factor: answer.tipping.load_factor,
        }
    }
}

impl Exit {
    fn of(exit: &OrbitExit) -> Exit {
        Exit {
            time: exit.time,
            direction_deg: exit.departure.wrench.and_then(|wrench| wrench.direction_deg()),
            mode: modes(&exit.departure),
            edges: edge_numbers(&exit.departure.limits),
        }
    }
}

impl Record {
    fn of(orbit: &Orbit) -> Record {
        Record {
            scale: orbit.scale,
            first_exit: orbit.exit.as_ref().map(Exit::of),
            strongest: orbit.strongest.as_ref().map(Exit::of),
        }
    }
}

pub(super) fn json(directions: &Directions, figures: &[String]) -> String {
    let situation = |of: &SituationDirections| {
        let assessed = directions.assessed(of);
        let situation = &assessed.situation;
        let worst = of.worst.as_ref();
        Situation {
            name: directions.assessment.name(assessed),
            friction: situation.static_friction(),
            height: situation.body().centroid_height(),
            full: (of.full.p > 0.0).then(|| over(&of.full)),
            worst_direction_deg: worst.map(|worst| worst.degrees),
            unique_in_direction: of.is_only_worst,
            load_factor: worst.map(DirectionAnswer::load_factor),
            worst: worst.map(Direction::of),
            directions: of.all.iter().map(Direction::of).collect(),
            record: of.orbit.as_ref().map(Record::of),
        }
    };
    written(&Document {
        schema: SCHEMA,
        title: directions.assessment.case.title.as_deref(),
        step_deg: directions.step,
        summary: super::text::summary(directions),
        situations: directions.all.iter().map(situation).collect(),
        figures,
    })
}
