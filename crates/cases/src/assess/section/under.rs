//! What lies under the base of a case: the reaction, how much of it is borne, how the ground fails, and the numbers that act there.

use standfast::ground::bearing::FailureShape;
use standfast::{BaseEdges, Mode, Verdict};
use standfast_figures::{BaseReaction, FailureSketch, Stated};

use super::super::{Assessed, Assessment, BaseResponse};
use crate::case::{Case, Limit};
use crate::key::Key;
use crate::layout::digits;

const FAILS: &str = "ground fails this way (a sketch)";
const WOULD_FAIL: &str = "ground would fail this way (a sketch)";
const PRANDTL: &str = "Dashed: a sketch of how the ground fails, with the angles of Prandtl’s wedge and spiral for φ and the inclination of the \
    load; nothing is calculated of it.";
const WITHOUT_ANGLE: &str = "Dashed: a sketch of how ground without friction fails, at 45° and along a circle, as neither clay that does not drain nor an envelope has an angle; \
    nothing is calculated of it.";

/// Reaction of the base as the mode under the full load begins; `None` if nothing presses, the resultant misses the base, or the body
/// flies.
pub(super) fn reaction(case: &Case, assessed: &Assessed, ground: &BaseResponse) -> Option<BaseReaction> {
    let body = &case.body;
    let BaseEdges { left, right } = body.base_edges();
    let (centre, middle) = (body.centroid_offset(), (right - left) / 2.0);
    let standing = ground.reaction.filter(|reaction| reaction.effective_width() > 0.0);
    let (at, force) = match assessed.motion() {
        Some(motion) if motion.f_y > 0.0 => (centre + motion.xi, motion.f_y),
        Some(_) => return None,
        None => {
            let reaction = standing?;
            let length = body.plan().side(body.width());
            (middle + reaction.e(), reaction.p() * length)
        }
    };
    let crush = ground.crush.as_ref().filter(|crush| crush.neutral.is_some());
    let pressed = match crush {
        Some(crush) => (centre + crush.pressed.from, centre + crush.pressed.to),
        None => {
            let half = (body.base_width() / 2.0 - (at - middle).abs()).max(0.0);
            (at - half, at + half)
        }
    };
    let neutral = crush.and_then(|crush| crush.neutral).map(|neutral| centre + neutral);
    let labels = labels(case, assessed, ground, force);
    let name = if neutral.is_some() { "crushed" } else { "B′" };
    let wide = pressed.1 - pressed.0;
    let width = (wide > 0.0).then(|| format!("{name} {}", case.output.length(wide)));
    let failure = failure(case, assessed, ground);
    Some(BaseReaction { at, size: force.abs(), pressed, neutral, labels, width, failure })
}

/// What comes on the base, and what of it is borne where that is known: under a body that stays, or that the ground does not bear.
fn labels(case: &Case, assessed: &Assessed, ground: &BaseResponse, force: f64) -> Vec<String> {
    let written = |force: f64| case.output.force(force);
    let bears = match assessed.verdict() {
        Some(Verdict::BearingFailure) => "is borne",
        Some(Verdict::Begins(Mode::Rest)) => "can be borne",
        _ => return vec![written(force)],
    };
    match ground.resistance {
        Some(resistance) => {
            vec![format!("{} comes,", written(force)), format!("{} {bears}", written(resistance))]
        }
        None => vec![written(force)],
    }
}

/// True if the ground is what limits a body: it fails, or does so first as the loads rise, or its factor is the criterion that governs.
fn ground_governs(case: &Case, assessed: &Assessed) -> bool {
    let fails = Some(Verdict::BearingFailure);
    let first = assessed.checks(case).into_iter().next();
    assessed.verdict() == fails
        || assessed.departure().verdict() == fails
        || first.is_some_and(|check| check.check.criterion.name() == Key::LeastGround.info().name)
}

/// The way in which the ground fails, where it is what limits the body.
fn failure(case: &Case, assessed: &Assessed, ground: &BaseResponse) -> Option<FailureSketch> {
    let Some(Limit::Ground(soil)) = ground.limit else { return None };
    if !ground_governs(case, assessed) {
        return None;
    }
    let shape = FailureShape::of(&ground.reaction?, soil.friction_angle_deg().unwrap_or(0.0))?;
    let BaseEdges { left, right } = case.body.base_edges();
    let middle = (right - left) / 2.0;
    let moved = |line: Vec<(f64, f64)>| line.into_iter().map(|(x, y)| (middle + x, y)).collect();
    let label = if assessed.verdict() == Some(Verdict::BearingFailure) { FAILS } else { WOULD_FAIL };
    Some(FailureSketch {
        lines: shape.lines().into_iter().map(moved).collect(),
        near: middle + shape.near.0,
        out: (shape.near.0 - shape.far.0).signum(),
        label: label.to_owned(),
    })
}

/// Words on the sketch, below the drawing.
pub(super) fn failure_words(ground: &BaseResponse) -> String {
    let has_angle = matches!(ground.limit, Some(Limit::Ground(soil)) if soil.friction_angle_deg().is_some());
    if has_angle { PRANDTL } else { WITHOUT_ANGLE }.to_owned()
}

/// The friction of the base.
pub(super) fn friction(case: &Case) -> Stated {
    stated("friction", Key::Friction, digits(case.friction), "")
}

/// What the ground is known by: its angle of friction, or the strength of a base that crushes.
pub(super) fn ground(case: &Case) -> Option<Stated> {
    let pressure = |name: &str, key: Key, pressure: f64| {
        let written = case.output.pressure(pressure);
        let (value, unit) = written.split_once(' ').unwrap_or((&written, ""));
        stated(name, key, value.to_owned(), &format!(" {unit}"))
    };
    match case.ground.as_ref()?.limit? {
        Limit::Strength(strength) => Some(pressure("strength", Key::Strength, strength)),
        Limit::Ground(soil) => match soil.undrained_strength() {
            Some(strength) => Some(pressure("undrained strength", Key::UndrainedStrength, strength)),
            None => {
                Some(stated("angle of friction", Key::GroundAngle, digits(soil.friction_angle_deg()?), "°"))
            }
        },
    }
}

fn stated(name: &str, key: Key, value: String, unit: &str) -> Stated {
    let symbol = format!("${}$", key.info().symbol);
    Stated { name: format!("{name} {symbol}"), symbol, value, unit: unit.to_owned() }
}

/// Words on the reaction, below the drawing.
pub(super) fn reaction_words(
    assessment: &Assessment,
    assessed: &Assessed,
    reaction: Option<&BaseReaction>,
) -> String {
    let of = assessment.name(assessed).map_or(String::new(), |name| format!(" of {name}"));
    let Some(reaction) = reaction else {
        return format!("Under the full load{of} no reaction of the base holds the body: none is drawn.");
    };
    let bears = match (reaction.neutral, reaction.pressed.1 > reaction.pressed.0) {
        (Some(_), _) => {
            ", the part of the base that it crushes, and as a circle the neutral point about which the body turns"
        }
        (None, true) => " and the effective width that has it in its middle",
        (None, false) => ", at the edge about which the body turns",
    };
    let when = match assessed.verdict() {
        Some(Verdict::BearingFailure) => "; the ground does not bear it",
        Some(Verdict::Begins(Mode::Rest)) | None => "",
        Some(Verdict::Begins(_)) => ", as the motion begins",
    };
    format!("Blue, under the base: the reaction to the full load{of}{bears}{when}.")
}
