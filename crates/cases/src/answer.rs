//! The answer to one point as a JSON document, at full precision.
//!
//! Keys are the report's symbols spelled out. Infinite numbers, which JSON lacks, are `null`: a safety factor
//! without bound, or a bound that no friction or force reaches.

use serde::Serialize;
use standfast::initiation::{Crossing, Relation, Step};
use standfast::{Mode, Motion, Reduced, Slip};

use crate::case::Case;

/// Everything that is known of one point.
#[derive(Debug, Serialize)]
pub struct Answer {
    gamma: f64,
    k_prime: f64,
    k: f64,
    mu: f64,
    mode: &'static str,
    mode_words: &'static str,
    unique: bool,
    also: Vec<&'static str>,
    case: &'static str,
    safety_factors: SafetyFactors,
    motion: Onset,
    trace: Vec<TraceStep>,
    margins: Margins,
}

#[derive(Debug, Serialize)]
struct SafetyFactors {
    sliding: f64,
    overturning: f64,
}

/// A case's body. Units are SI.
#[derive(Debug, Serialize)]
pub(crate) struct Body {
    width: f64,
    height: f64,
    mass: f64,
    weight: f64,
    friction: f64,
}

impl Body {
    pub(crate) fn of(case: &Case) -> Body {
        let body = &case.body;
        Body {
            width: body.width(),
            height: body.height(),
            mass: body.mass(),
            weight: body.mass() * case.gravity,
            friction: case.friction,
        }
    }
}

/// Accelerations and reactions.
#[derive(Debug, Serialize)]
pub(crate) struct Onset {
    pub(crate) x_ddot: f64,
    pub(crate) y_ddot: f64,
    pub(crate) theta_ddot: f64,
    pub(crate) f_x: f64,
    pub(crate) f_y: f64,
    pub(crate) xi: f64,
    /// ẍ_O = ẍ_O'.
    pub(crate) slip: f64,
    pub(crate) lift_o: f64,
    pub(crate) lift_o_prime: f64,
}

#[derive(Debug, Serialize)]
struct TraceStep {
    mode: &'static str,
    holds: bool,
    relations: Vec<TraceRelation>,
}

#[derive(Debug, Serialize)]
struct TraceRelation {
    equation: &'static str,
    statement: String,
    left: f64,
    sign: String,
    right: f64,
    holds: bool,
    margin: f64,
}

#[derive(Debug, Serialize)]
struct Margins {
    /// `null` if no force moves the body.
    leaves_rest: Option<Change>,
    along_k: Vec<Change>,
    along_mu: Vec<Change>,
}

#[derive(Debug, Serialize)]
struct Change {
    at: f64,
    from: &'static str,
    to: &'static str,
}

impl Answer {
    /// The answer for a reduced force, as the real body shows it.
    pub fn of(reduced: &Reduced) -> Answer {
        let point = &reduced.point;
        let mode = reduced.mode();
        let symbol = |mode: Mode| reduced.orient(mode).symbol();
        let step = |step: &Step| TraceStep {
            mode: symbol(step.mode),
            holds: step.holds,
            relations: step.relations.iter().map(TraceRelation::of).collect(),
        };
        let change = |crossing: &Crossing| Change {
            at: crossing.at,
            from: symbol(crossing.from),
            to: symbol(crossing.to),
        };
        let margins = point.margins();
        Answer {
            gamma: point.gamma(),
            k_prime: point.k_prime(),
            k: point.k(),
            mu: point.mu(),
            mode: mode.symbol(),
            mode_words: mode.words(),
            unique: point.is_unique(),
            also: reduced.others().iter().map(Mode::symbol).collect(),
            case: point.chart().case().words(),
            safety_factors: SafetyFactors {
                sliding: point.safety_against_sliding(),
                overturning: point.safety_against_overturning(),
            },
            motion: Onset::of(&reduced.motion()),
            trace: point.explain().steps.iter().map(step).collect(),
            margins: Margins {
                leaves_rest: margins.leaves_rest().as_ref().map(change),
                along_k: margins.along_k.iter().map(change).collect(),
                along_mu: margins.along_mu.iter().map(change).collect(),
            },
        }
    }
}

impl Onset {
    pub(crate) fn of(motion: &Motion) -> Onset {
        let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } = *motion;
        Onset { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime }
    }
}

impl TraceRelation {
    fn of(relation: &Relation) -> TraceRelation {
        let Relation { equation, left, sign, right, holds, .. } = *relation;
        let statement = relation.statement();
        TraceRelation {
            equation,
            statement,
            left,
            sign: sign.to_string(),
            right,
            holds,
            margin: relation.margin(),
        }
    }
}

/// Where a force points, as a case file says it.
pub(crate) fn direction(towards: Slip) -> &'static str {
    match towards {
        Slip::Left => "left",
        Slip::Right => "right",
    }
}
