//! A case over all horizontal directions: the load factor at which the body leaves rest, were its variable loads turned, and where the orbit of
//! a record leaves rest first.
//!
//! Under loads through the vertical of the centre of mass the body rests where the horizontal force over what presses it lies in a polygon, or
//! a circle, cut by the circle of sliding. Both are convex, so an orbit of straight pieces is at rest between two points at which it is.

mod orbit;

use standfast::footprint::{self, BaseWrench, Footprint, PlanDeparture, PlanLimit};

use crate::assess::{Assessed, Assessment};
use crate::error::CaseError;
use crate::explained::Explained;
pub use orbit::{Orbit, OrbitExit};
use standfast_model::CaseFile;

/// Step between the directions that are answered, degrees, where no other is asked for.
pub const STEP: f64 = 5.0;

/// The least and the greatest step.
const STEPS: std::ops::RangeInclusive<f64> = 0.1..=90.0;

/// The step between the directions, if it divides a turn and is neither too small nor too large.
///
/// # Errors
/// If it is another; the error says what is expected.
pub fn check_step(step: f64) -> Result<f64, StepError> {
    let count = 360.0 / step;
    let is_whole = (count - count.round()).abs() < 1e-9 * count;
    if STEPS.contains(&step) && is_whole { Ok(step) } else { Err(StepError) }
}

/// Not a step between directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("expected a step from {} to {} degrees that divides 360, as {}", STEPS.start(), STEPS.end(), STEP)]
pub struct StepError;

/// One direction.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionAnswer {
    /// The direction of the variable horizontal force on the body, degrees from left over away from the viewer to right.
    pub degrees: f64,
    /// Where the body leaves rest, were its variable loads turned there.
    pub departure: PlanDeparture,
    /// Where it tips were it never to slide.
    pub tipping: PlanDeparture,
}

/// A situation over all directions.
#[derive(Debug, Clone, PartialEq)]
pub struct SituationDirections {
    /// The place of the situation among those of the case.
    pub index: usize,
    /// From 0° up at even steps, below 360°; empty where no horizontal load varies.
    pub all: Vec<DirectionAnswer>,
    /// Directions of the corners of the area of rest: of corners of the base, and both sides of where sliding gives way to tipping.
    pub corners: Vec<DirectionAnswer>,
    /// The direction that bears least; `None` where no horizontal load varies.
    pub worst: Option<DirectionAnswer>,
    /// True if only that direction bears so little; false where all slide alike, or several edges are as near.
    pub is_only_worst: bool,
    /// Forces and moments of the full load on the base.
    pub full: BaseWrench,
    /// The way of a record through the directions, where the base follows one.
    pub orbit: Option<Orbit>,
}

/// A case over all directions.
#[derive(Debug, Clone, PartialEq)]
pub struct Directions {
    /// The answer to the case; of one in time at the peaks of its records.
    pub assessment: Assessment,
    /// The situations, in their order.
    pub all: Vec<SituationDirections>,
    /// Step between the directions, degrees.
    pub step: f64,
}

/// Reason why a case has no directions.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DirectionsError {
    /// The case has no answer.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// It lies in the plane of its section.
    #[error(
        "the case lies in the plane of its section; expected a base seen from above: [base], `direction_deg`, `z`, `centroid_z` or \
         `horizontal_z`"
    )]
    InPlane,
    /// No horizontal load varies.
    #[error("no horizontal load varies, so that there is nothing to turn")]
    NothingTurns,
    /// Turned, the loads have a moment about the vertical.
    #[error(
        "turned to {degrees}°, the loads turn the body about the vertical; what a base bears of that is answered on a disc alone"
    )]
    Torsion {
        /// The direction.
        degrees: f64,
    },
    /// The step.
    #[error(transparent)]
    Step(#[from] StepError),
}

impl Explained for DirectionsError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            DirectionsError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            DirectionsError::Case(_) | DirectionsError::Step(_) => return None,
            DirectionsError::InPlane => {
                "direction_deg of a [[load]] or of [earthquake] makes the base one that is seen from above; it needs the `length` of the body".into()
            }
            DirectionsError::NothingTurns => {
                "add a [[load]] of any size with an elevation, or an [earthquake] with horizontal = \"0.1 g\"".into()
            }
            DirectionsError::Torsion { .. } => {
                "a load in the vertical plane through the centre of mass does not turn the body: `z` = `centroid_z`".into()
            }
        })
    }
}

impl Directions {
    /// The directions of every situation of a case, at even steps of so many degrees.
    ///
    /// # Errors
    /// If the case has no answer or lies in a plane, nothing turns, or what is turned has no answer.
    pub fn of_file(file: &CaseFile, step: f64) -> Result<Directions, DirectionsError> {
        let step = check_step(step)?;
        let assessment = Assessment::of_file(file)?;
        let all = of_all(&assessment, step, Orbit::of_file(file)?)?;
        if all.iter().all(|one| one.all.is_empty()) {
            return Err(DirectionsError::NothingTurns);
        }
        Ok(Directions { assessment, all, step })
    }

    /// The situation in which the worst direction bears least; of several the first.
    pub fn governing(&self) -> &SituationDirections {
        let least = |one: &&SituationDirections| {
            one.worst.as_ref().map_or(f64::INFINITY, DirectionAnswer::load_factor)
        };
        let governing = self.all.iter().min_by(|one, two| least(one).total_cmp(&least(two)));
        governing.expect("a case has a situation")
    }

    /// The answer to a situation.
    pub fn assessed(&self, of: &SituationDirections) -> &Assessed {
        &self.assessment.all[of.index]
    }
}

fn of_all(
    assessment: &Assessment,
    step: f64,
    orbits: Vec<Orbit>,
) -> Result<Vec<SituationDirections>, DirectionsError> {
    let mut orbits = orbits.into_iter();
    let of = |assessed| {
        Ok(SituationDirections { orbit: orbits.next(), ..SituationDirections::of(assessed, step)? })
    };
    assessment.all.iter().map(of).collect()
}

impl DirectionAnswer {
    /// λ at which the body leaves rest.
    pub fn load_factor(&self) -> f64 {
        self.departure.load_factor
    }

    /// True if tipping ends rest.
    pub fn tips(&self) -> bool {
        matches!(self.departure.limits.first(), Some(PlanLimit::Tips { .. }))
    }
}

impl SituationDirections {
    /// The directions of a situation at even steps of so many degrees.
    ///
    /// # Errors
    /// If it lies in a plane, or turned loads have no answer.
    pub fn of(assessed: &Assessed, step: f64) -> Result<SituationDirections, DirectionsError> {
        let situation = &assessed.situation;
        let (Some([permanent, variable]), Some(plan)) = (situation.base_wrenches(), situation.plan()) else {
            return Err(DirectionsError::InPlane);
        };
        let full = permanent.plus(variable);
        let none = SituationDirections {
            index: assessed.index,
            all: Vec::new(),
            corners: Vec::new(),
            worst: None,
            is_only_worst: false,
            full,
            orbit: None,
        };
        let Some(own) = variable.direction_deg() else { return Ok(none) };
        let footprint = &plan.footprint;
        let friction = situation.static_friction();
        let at = |degrees: f64| {
            answer(footprint, friction, [&permanent, &variable.turned(degrees - own)], degrees)
        };
        let count = (360.0 / step).round();
        let all =
            (0..).map(f64::from).take_while(|place| *place < count).map(|place| at(360.0 * place / count));
        let all = all.collect::<Result<Vec<_>, _>>()?;
        // The least of a convex boundary lies across an edge, or where the permanent load points to, or is slid against.
        let across = footprint.normals().into_iter().map(footprint::degrees);
        let against = permanent.direction_deg().into_iter().flat_map(|degrees| [degrees, degrees + 180.0]);
        let candidates = across.chain(against).map(|degrees| at(degrees.rem_euclid(360.0)));
        let candidates = candidates.collect::<Result<Vec<_>, _>>()?;
        let near = |one: &DirectionAnswer, two: &DirectionAnswer| {
            (one.load_factor() - two.load_factor()).abs() <= 1e-9 * one.load_factor().abs()
        };
        let both = || candidates.iter().chain(&all);
        let worst = both().min_by(|one, two| one.load_factor().total_cmp(&two.load_factor()));
        // Of those that are alike the first: an edge before a direction beside it.
        let worst = worst.and_then(|least| both().find(|one| near(one, least))).cloned();
        let is_only_worst = worst.as_ref().is_some_and(|worst| {
            let turned = |one: &DirectionAnswer| {
                let by = (one.degrees - worst.degrees).rem_euclid(360.0);
                by.min(360.0 - by) > 1e-6
            };
            !both().any(|one| near(one, worst) && turned(one))
        });
        let start = permanent.centre_of_pressure().unwrap_or_default();
        let to_corner = |vertex: &[f64; 2]| footprint::degrees([vertex[0] - start[0], vertex[1] - start[1]]);
        let corners = footprint.vertices().iter().map(|vertex| at(to_corner(vertex)));
        let mut corners = corners.collect::<Result<Vec<_>, _>>()?;
        corners.extend(changes(&all, &corners, at)?);
        Ok(SituationDirections { all, corners, worst, is_only_worst, ..none })
    }
}

/// Directions next to each other, nearer than is seen, of which the body slides in one and tips in the other; between these.
fn changes(
    all: &[DirectionAnswer],
    corners: &[DirectionAnswer],
    at: impl Fn(f64) -> Result<DirectionAnswer, DirectionsError>,
) -> Result<Vec<DirectionAnswer>, DirectionsError> {
    const NEAR: f64 = 1e-6;
    let mut around: Vec<&DirectionAnswer> = all.iter().chain(corners).collect();
    standfast::order::by_number(&mut around, |one| one.degrees);
    let mut found = Vec::new();
    for (place, one) in around.iter().enumerate() {
        let two = around[(place + 1) % around.len()];
        if one.tips() == two.tips() {
            continue;
        }
        let width = (two.degrees - one.degrees).rem_euclid(360.0);
        let (mut low, mut high) = (0.0, width);
        while high - low > NEAR {
            let middle = 0.5 * (low + high);
            if at((one.degrees + middle) % 360.0)?.tips() == one.tips() {
                low = middle
            } else {
                high = middle
            }
        }
        for by in [low, high] {
            found.push(at((one.degrees + by) % 360.0)?);
        }
    }
    Ok(found)
}

fn answer(
    footprint: &Footprint,
    friction: f64,
    [permanent, turned]: [&BaseWrench; 2],
    degrees: f64,
) -> Result<DirectionAnswer, DirectionsError> {
    let torsion = |_| DirectionsError::Torsion { degrees };
    let departure = footprint.departure(friction, permanent, turned).map_err(torsion)?;
    let tipping = footprint.departure_held(permanent, turned).map_err(torsion)?;
    Ok(DirectionAnswer { degrees, departure, tipping })
}
