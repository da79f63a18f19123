//! The figures of a case over all directions.

use standfast::Mode;
use standfast::footprint::{BaseWrench, PlanDeparture};
use standfast_answers::directions::{DirectionAnswer, Directions, Orbit, SituationDirections};
use standfast_figures::{DirectionsChart, Figure, directions, directions_on_screen};

use super::text::{DIRECTIONS, worst_words};
use crate::assess::{Assessed, Assessment};
use crate::document::AnswerFigure;
use crate::layout::digits;

/// Step of what is drawn, degrees: the chord is 4e-5 of a circle's radius beside it.
const DRAWN: f64 = 1.0;

pub(super) fn all(answer: &Directions) -> Vec<AnswerFigure> {
    let several = answer.all.len() > 1;
    let figures = answer.all.iter().filter_map(|of| {
        let suffix = if several { format!("-{}", of.index + 1) } else { String::new() };
        of_situation(&answer.assessment, answer.assessed(of), of.orbit.as_ref(), &suffix)
    });
    figures.collect()
}

/// The figure of a situation on a base seen from above, where something turns; none of one in the plane of its section.
pub(crate) fn of_assessed(
    assessment: &Assessment,
    assessed: &Assessed,
    suffix: &str,
) -> Option<AnswerFigure> {
    of_situation(assessment, assessed, None, suffix)
}

fn of_situation(
    assessment: &Assessment,
    assessed: &Assessed,
    orbit: Option<&Orbit>,
    suffix: &str,
) -> Option<AnswerFigure> {
    assessed.outcome.plan.as_ref()?;
    // As fine as is seen, whatever step is told.
    let of = SituationDirections::of(assessed, DRAWN).ok().filter(|of| !of.all.is_empty())?;
    let figure = with_chart(assessment, assessed, &of, orbit, directions)?;
    Some(AnswerFigure::new(format!("{suffix}-directions"), "Rest over all directions", figure))
}

fn place(wrench: &BaseWrench) -> (f64, f64) {
    (wrench.x / wrench.p, wrench.z / wrench.p)
}

/// The figure of a situation for a screen, about as large as `size`; `None` of one in the plane of its section, or where nothing turns.
pub fn on_screen(assessment: &Assessment, assessed: &Assessed, size: (f64, f64)) -> Option<Figure> {
    let of = SituationDirections::of(assessed, DRAWN).ok().filter(|of| !of.all.is_empty())?;
    with_chart(assessment, assessed, &of, None, |chart| directions_on_screen(chart, size))
}

fn with_chart(
    assessment: &Assessment,
    assessed: &Assessed,
    of: &SituationDirections,
    orbit: Option<&Orbit>,
    draw: impl FnOnce(&DirectionsChart<'_>) -> Figure,
) -> Option<Figure> {
    let plan = assessment.case.plan.as_ref()?;
    let name = assessment.name(assessed).map_or(String::new(), |name| format!(", {name}"));
    let title = assessment.case.title.as_deref().unwrap_or("A body");
    let mut around: Vec<&DirectionAnswer> = of.all.iter().chain(&of.corners).collect();
    standfast::order::by_number(&mut around, |one| one.degrees);
    let at = |departure: &PlanDeparture| departure.wrench.as_ref().map(place);
    let mode = |one: &DirectionAnswer| if one.tips() { Mode::RockO } else { Mode::SlideLeft };
    let rest = around.iter().filter_map(|one| Some((at(&one.departure)?, mode(one))));
    let rest: Vec<_> = rest.collect();
    let tipping: Vec<_> = around.iter().filter_map(|one| at(&one.tipping)).collect();
    let points: Vec<_> =
        orbit.map_or(Vec::new(), |orbit| orbit.points.iter().map(|[_, x, z]| (*x, *z)).collect());
    let [permanent, _] = assessed.situation.base_wrenches()?;
    let worst = of.worst.as_ref();
    let said = worst.map_or(String::new(), |worst| {
        format!(
            "In the worst direction, {}, at λ = {}. ",
            worst_words(plan, worst),
            digits(worst.load_factor())
        )
    });
    Some(draw(&DirectionsChart {
        title: &format!("{title}{name}: rest over all directions."),
        caption: &format!("{said}{DIRECTIONS}"),
        rest: &rest,
        tipping: &tipping,
        friction: assessed.situation.static_friction(),
        permanent: place(&permanent),
        full: place(&of.full),
        worst: worst.filter(|_| of.is_only_worst).and_then(|worst| at(&worst.departure)),
        orbit: &points,
        exit: orbit.and_then(|orbit| at(&orbit.exit.as_ref()?.departure)),
    }))
}
