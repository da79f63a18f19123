//! A case's answer as one JSON document, at full precision. Units are SI.

use serde::Serialize;

use super::DrawnDiagram;
use crate::answer::{Answer, Onset, direction};
use crate::case::{Case, Load};
use crate::describe::Scale;

#[derive(Serialize)]
struct Document<'a> {
    title: Option<&'a str>,
    note: Option<&'a str>,
    gravity: f64,
    body: Body,
    loads: Vec<LoadAnswer<'a>>,
    diagrams: Vec<String>,
}

#[derive(Serialize)]
struct Body {
    width: f64,
    height: f64,
    mass: f64,
    weight: f64,
    friction: f64,
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
    diagram: Option<String>,
}

pub(super) fn render(case: &Case, diagrams: &[DrawnDiagram]) -> String {
    let scale = Scale::of(&case.body, case.gravity);
    crate::json(&Document {
        title: case.title.as_deref(),
        note: case.note.as_deref(),
        gravity: case.gravity,
        body: Body {
            width: case.body.width(),
            height: case.body.height(),
            mass: case.body.mass(),
            weight: scale.weight,
            friction: case.friction,
        },
        loads: case.loads.iter().map(|load| load_answer(load, &scale, diagrams)).collect(),
        diagrams: diagrams.iter().map(|drawn| drawn.path.display().to_string()).collect(),
    })
}

fn load_answer<'a>(load: &'a Load, scale: &Scale, diagrams: &[DrawnDiagram]) -> LoadAnswer<'a> {
    let point = &load.reduced.point;
    LoadAnswer {
        name: load.name.as_deref(),
        force: load.force.magnitude(),
        elevation: load.force.elevation(),
        direction: direction(load.force.direction()),
        answer: Answer::of(&load.reduced),
        motion_si: Onset::of(&scale.si(&load.reduced.motion())),
        leaves_rest_force: point.margins().leaves_rest().map(|crossing| crossing.at * scale.weight),
        diagram: diagrams
            .iter()
            .find(|drawn| drawn.k_prime == point.elevation())
            .map(|drawn| drawn.path.display().to_string()),
    }
}
