//! A case's answer as one JSON document, at full precision. Units are SI.

use serde::Serialize;

use super::Plain;
use crate::answer::{Answer, Body, Onset, direction};
use crate::case::Load;
use crate::describe::Scale;

#[derive(Serialize)]
struct Document<'a> {
    title: Option<&'a str>,
    note: Option<&'a str>,
    gravity: f64,
    body: Body,
    loads: Vec<LoadAnswer<'a>>,
    diagrams: &'a [String],
}

#[derive(Serialize)]
struct LoadAnswer<'a> {
    name: Option<&'a str>,
    force: f64,
    elevation: f64,
    direction: &'static str,
    #[serde(flatten)]
    answer: Answer,
    motion_si: Onset,
    /// N per metre run; `null` if no force moves the body.
    leaves_rest_force: Option<f64>,
    diagram: Option<&'a str>,
}

pub(super) fn render(plain: &Plain<'_>, files: &[String]) -> String {
    let case = plain.case;
    let scale = Scale::of(&case.body, case.gravity);
    crate::json(&Document {
        title: case.title.as_deref(),
        note: case.note.as_deref(),
        gravity: case.gravity,
        body: Body::of(case),
        loads: case.loads.iter().map(|load| load_answer(plain, load, &scale, files)).collect(),
        diagrams: files,
    })
}

fn load_answer<'a>(
    plain: &'a Plain<'_>,
    load: &'a Load,
    scale: &Scale,
    files: &'a [String],
) -> LoadAnswer<'a> {
    let point = &load.reduced.point;
    let plane = plain.plane_of(point.k_prime());
    LoadAnswer {
        name: load.name.as_deref(),
        force: load.force.magnitude(),
        elevation: load.force.elevation(),
        direction: direction(load.force.direction()),
        answer: Answer::of(&load.reduced),
        motion_si: Onset::of(&scale.si(&load.reduced.motion())),
        leaves_rest_force: point.margins().leaves_rest().map(|crossing| crossing.at * scale.weight),
        diagram: plane.and_then(|plane| files.get(plane)).map(String::as_str),
    }
}
