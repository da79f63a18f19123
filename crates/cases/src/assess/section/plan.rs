//! The base of a case seen from above, as the section's figure draws it.

use standfast::Plan;
use standfast_figures::{PlanPlace, PlanView};

use super::super::plan::edge_words;
use super::super::{Assessed, Assessment};
use crate::case::{Case, PlanOf};

/// Corners of a circle as it is drawn.
const ROUND: u32 = 180;

/// The base of a case seen from above, with the force on it in a situation; `None` of a case in the plane of its section.
pub(super) fn view(assessment: &Assessment, assessed: &Assessed) -> Option<PlanView> {
    let case = &assessment.case;
    let plan = case.plan.as_ref()?;
    let answer = assessed.outcome.plan.as_ref()?;
    let footprint = &plan.base.footprint;
    let centroid = (case.body.centroid_offset(), plan.base.centroid_z);
    let placed = |[x, z]: [f64; 2]| (centroid.0 + x, centroid.1 + z);
    let base: Vec<PlanPlace> = match footprint.disc() {
        Some((centre, radius)) => round(placed(centre), radius),
        None => footprint.vertices().iter().map(|vertex| placed(*vertex)).collect(),
    };
    let normals = footprint.normals();
    let edges = match footprint.disc() {
        Some(_) => Vec::new(),
        None => base
            .iter()
            .zip(base.iter().cycle().skip(1))
            .zip(&normals)
            .map(|((from, to), out)| (((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0), (out[0], out[1])))
            .collect(),
    };
    let distances = footprint.distances().into_iter().zip(&normals);
    let (least, out) = distances.min_by(|one, two| one.0.total_cmp(&two.0))?;
    let nearest = placed([least * out[0], least * out[1]]);
    let output = assessed.output;
    let full = &answer.full;
    let size = full.horizontal();
    let force = (size > 0.0).then(|| ((full.x / size, full.z / size), output.force(size)));
    // One far off would make the picture small.
    let reach = footprint.size();
    let pressure = full.centre_of_pressure().filter(|[x, z]| x.hypot(*z) < 2.0 * reach).map(placed);
    Some(PlanView {
        body: body(case),
        base,
        feet: feet(case, plan.of),
        centroid,
        edges,
        governing: answer.edge.filter(|_| footprint.disc().is_none()),
        nearest: (nearest, format!("$h$ = {}", output.length(least))),
        force,
        pressure,
    })
}

/// What is drawn, in a sentence.
pub(super) fn words(case: &Case, assessed: &Assessed) -> Option<String> {
    let plan = case.plan.as_ref()?;
    let edge = assessed.outcome.plan.as_ref()?.edge.filter(|_| plan.base.footprint.disc().is_none());
    let about = edge.map_or(String::new(), |edge| {
        format!(
            " The edge drawn heavy, {}, has the least factor against overturning.",
            edge_words(plan, edge)
        )
    });
    Some(format!(
        "Below, the base seen from above, the viewer of the section at its lower side; h is the distance from below C to the nearest edge, \
         the other dot the centre of pressure.{about}"
    ))
}

fn round(centre: PlanPlace, radius: f64) -> Vec<PlanPlace> {
    let point = |step: u32| {
        let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / f64::from(ROUND)).sin_cos();
        (centre.0 + radius * cos, centre.1 + radius * sin)
    };
    (0..ROUND).map(point).collect()
}

fn body(case: &Case) -> Vec<PlanPlace> {
    let half = case.body.width() / 2.0;
    match case.body.plan() {
        Plan::Rectangle { length } => {
            let far = length / 2.0;
            vec![(-half, -far), (half, -far), (half, far), (-half, far)]
        }
        _ => round((0.0, 0.0), half),
    }
}

fn feet(case: &Case, of: PlanOf) -> Vec<PlanPlace> {
    let PlanOf::Feet(_) = of else { return Vec::new() };
    let origin = case.section.as_ref().map_or(0.0, |section| {
        let [left, right] = section.ends();
        (left + right) / 2.0
    });
    let numbers = case.inputs().list(crate::Key::BaseFeet).unwrap_or_default();
    numbers.chunks_exact(2).map(|pair| (pair[0] - origin, pair[1])).collect()
}
