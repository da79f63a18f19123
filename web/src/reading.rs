//! Everything that the page shows of a state.

use serde::Serialize;
use standfast::Mode;
use standfast::region::Strip;

use crate::answer::PageAnswer;
use crate::field::Field;
use crate::state::State;
use crate::text::{letter, mathematics};
use crate::unit::{FORCES, LENGTHS, MASSES, PRESSURES, PageUnit, shown};
use crate::verdict::PageVerdict;

/// Everything the page shows but the drawings. Strings are HTML unless named `plain`.
#[derive(Debug, Serialize)]
pub struct Reading {
    #[serde(flatten)]
    verdict: PageVerdict,
    /// Of which loads the diagram is, if there are others than the force, or why there is none.
    map_note: String,
    case: String,
    points: Vec<[String; 3]>,
    /// Every field's text.
    fields: Vec<(&'static str, String)>,
    /// Every slider's place.
    sliders: Vec<(&'static str, f64)>,
    /// The units to choose from, and the one chosen, by kind.
    units: Vec<(&'static str, Vec<&'static str>, &'static str)>,
    /// True if the force points right.
    mirrored: bool,
    /// True if there is water or uplift beside the force.
    with_water: bool,
    figure: Option<&'static str>,
    /// True if a chart of the plane is shown, not a sketch.
    is_map: bool,
    /// True if there is a diagram or a sketch at all.
    is_drawn: bool,
    numbers: Numbers,
}

/// The answer in numbers, non-dimensional; infinite ones are null.
#[derive(Debug, Serialize)]
struct Numbers {
    /// γ, k', k, μ of the force.
    given: [f64; 4],
    /// γ, k', k, μ of all loads, if these are a point of the report's plane.
    all_loads: Option<[f64; 4]>,
    /// γ and k' of the diagram drawn.
    diagram: Option<[f64; 2]>,
    /// ẍ, ÿ, θ̈, f_x, f_y, ξ, ẍ_O, ÿ_O, ÿ_O' in g, B and m g.
    motion: Option<[f64; 9]>,
    /// Against sliding and overturning; none where the loads lift the body.
    factors: Option<[f64; 2]>,
    /// The other consistent modes.
    others: Vec<&'static str>,
}

impl Reading {
    /// The reading of a state.
    pub fn of(state: &State) -> Reading {
        let answer = PageAnswer::of(state);
        let unit = |units: &[PageUnit], chosen: usize| {
            (units.iter().map(|unit| unit.0).collect::<Vec<_>>(), units[chosen].0)
        };
        let units = &state.units;
        let units = [
            ("length", unit(&LENGTHS, units.length)),
            ("mass", unit(&MASSES, units.mass)),
            ("force", unit(&FORCES, units.force)),
            ("pressure", unit(&PRESSURES, units.pressure)),
        ];
        let diagram = state.diagram();
        let points = diagram.as_ref().map_or(Vec::new(), |diagram| diagram.chart().points());
        let is_sketch = state.figure.is_some_and(|id| id.body().is_none());
        Reading {
            verdict: PageVerdict::of(state, &answer),
            map_note: map_note(state),
            case: case(state),
            points: points
                .iter()
                .map(|point| [letter(point.name), shown(point.k), shown(point.mu)])
                .collect(),
            fields: Field::ALL.map(|(name, field)| (name, field.text(state))).into(),
            sliders: Field::ALL
                .iter()
                .filter_map(|(name, field)| Some((*name, field.share(state)?)))
                .collect(),
            units: units.map(|(kind, (names, chosen))| (kind, names, chosen)).into(),
            mirrored: state.mirrored,
            with_water: !state.waters.are_none(),
            figure: state.figure.map(|id| id.number()),
            is_map: diagram.is_some() && !is_sketch,
            is_drawn: diagram.is_some(),
            numbers: Numbers::of(state, answer.as_ref().ok()),
        }
    }
}

impl Numbers {
    fn of(state: &State, answer: Option<&PageAnswer>) -> Numbers {
        let four = |point: standfast::Point| [point.gamma(), point.k_prime(), point.k(), point.mu()];
        Numbers {
            given: four(state.point()),
            all_loads: answer.and_then(|answer| answer.point).map(|reduced| four(reduced.point)),
            diagram: state.diagram().map(|diagram| {
                let chart = diagram.chart();
                [chart.gamma(), chart.k_prime()]
            }),
            motion: answer.map(|PageAnswer { motion, .. }| {
                [
                    motion.x_ddot,
                    motion.y_ddot,
                    motion.theta_ddot,
                    motion.f_x,
                    motion.f_y,
                    motion.xi,
                    motion.slip,
                    motion.lift_o,
                    motion.lift_o_prime,
                ]
            }),
            factors: answer.and_then(|answer| answer.factors),
            others: answer.map_or(Vec::new(), |answer| answer.others.iter().map(Mode::symbol).collect()),
        }
    }
}

/// Of which loads the diagram is, or why there is none; nothing for the force alone.
fn map_note(state: &State) -> String {
    if state.waters.are_none() {
        return String::new();
    }
    if state.figure.is_some() {
        return "This figure is of a force in air. Under all loads, with water and uplift, the body has no place in it."
            .to_owned();
    }
    match state.all_loads() {
        Some(reduced) => format!(
            "Drawn for all loads, water and uplift included: <i>k</i> on its axis is <i>k</i><sub>eff</sub>, all that pushes              sideways over all that presses down, and the diagram is that of <i>k</i>′<sub>eff</sub> = {}. It changes with              the force; <i>k</i> and <i>k</i>′ of the sliders are those of the force alone.",
            shown(reduced.point.k_prime())
        ),
        None => "No diagram: under all loads, water and uplift included, there is nothing that pushes sideways on a                  pressed base."
            .to_owned(),
    }
}

/// Case of the report that the diagram shows.
fn case(state: &State) -> String {
    let Some(diagram) = state.diagram() else { return String::new() };
    let view = state.view(&diagram);
    let seen = |strip: &Strip| strip.from < view.k_max && strip.lower.at(strip.from) < view.mu_max;
    let parts = diagram.unresolved();
    let hatched = state.figure.is_none() && parts.iter().any(|part| part.strips.iter().any(seen));
    let remark = if hatched { " Hatched: the answer is not unique." } else { "" };
    let who = if state.waters.are_none() { "The force points" } else { "All loads together point" };
    let mirror = match state.design_point() {
        Some(reduced) if reduced.mirrored => {
            format!(" {who} right: the diagram is that of the mirror image.")
        }
        _ => String::new(),
    };
    format!("This body: {}.{remark}{mirror}", mathematics(diagram.chart().case().words()))
}
