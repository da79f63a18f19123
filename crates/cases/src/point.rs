//! The answer to one point of the k–μ plane: as text, and as a JSON document that stands alone or in the answer to a case.

mod crush;

use std::fmt::Write;

use serde::Serialize;
use standfast::initiation::{Crossing, Step};
use standfast::loads::Reduced;
use standfast::relation::Relation;
use standfast::{Mode, Modes, Motion};

use crate::assess::SCHEMA;
use crate::describe;
use crate::layout::{digits, paragraph};
use crate::results::number_or_word;

pub use crush::{Crushing, json as crush_json, text as crush_text};

/// The answer as one line of text, or with `explain` every step of the decision, the motion, and where the mode changes.
pub fn text(reduced: &Reduced, explain: bool) -> String {
    if explain { explanation(reduced) } else { one_line(reduced) }
}

/// The answer as a JSON document, complete and at full precision.
pub fn json(reduced: &Reduced) -> String {
    #[derive(Serialize)]
    struct Document {
        schema: u32,
        #[serde(flatten)]
        answer: PointDocument,
        #[serde(rename = "SF_sliding", serialize_with = "number_or_word")]
        sliding: f64,
        #[serde(rename = "SF_overturning", serialize_with = "number_or_word")]
        overturning: f64,
    }
    let point = &reduced.point;
    crate::json(&Document {
        schema: SCHEMA,
        answer: PointDocument::of(reduced),
        sliding: point.safety_against_sliding(),
        overturning: point.safety_against_overturning(),
    })
}

fn one_line(reduced: &Reduced) -> String {
    let mode = reduced.mode();
    let others = reduced.others();
    let unique = if others.is_empty() { "unique".to_owned() } else { format!("not unique, also {others}") };
    format!("{mode}  {}  ({unique})\n", mode.words())
}

fn explanation(reduced: &Reduced) -> String {
    let point = &reduced.point;
    let trace = point.explain();
    let mut text = paragraph(&describe::verdict(reduced), 0);
    text += &paragraph(&describe::uniqueness(reduced), 0);
    if reduced.mirrored {
        text += &paragraph(describe::MIRRORED, 0);
    }

    let _ = writeln!(
        text,
        "\nPoint\n  γ = {}   k' = {}   k = {}   μ = {}\n  {}",
        digits(point.gamma()),
        digits(point.k_prime()),
        digits(point.k()),
        digits(point.mu()),
        point.chart().case().words(),
    );
    text += "\nStep by step (report's equation numbers)\n";
    for step in &trace.steps {
        let verdict = if step.holds { "holds" } else { "does not hold" };
        let _ = writeln!(text, "  {} {verdict}", reduced.orient(step.mode));
        text += &describe::relations(&step.relations, 4);
    }
    text += "\nSafety factors\n";
    text += &describe::safety_factors(point);
    text += "\nAt onset\n";
    text += &describe::motion(&reduced.motion());
    text += "\nChanges of mode\n";
    text += &describe::along_k(reduced);
    text += &format!("  as the friction grows, at k = {}:\n", digits(point.k()));
    text += &describe::along_mu(reduced, 4);
    text
}

/// Everything that is known of a point. Lengths are in B, accelerations in g, θ̈ in g/B, forces in m g; modes and motion are
/// those of the real body, mirrored where the force points right.
#[derive(Debug, Serialize)]
pub(crate) struct PointDocument {
    gamma: f64,
    k_prime: f64,
    k: f64,
    mu: f64,
    mirrored: bool,
    mode: Mode,
    mode_words: &'static str,
    unique: bool,
    also: Modes,
    case: &'static str,
    motion: Motion,
    trace: Vec<TraceStep>,
    /// `null` if no force moves the body.
    leaves_rest: Option<Change>,
    along_k: Vec<Change>,
    along_mu: Vec<Change>,
}

#[derive(Debug, Serialize)]
struct TraceStep {
    mode: Mode,
    holds: bool,
    relations: Vec<RelationDocument>,
}

/// An inequality with its numbers.
#[derive(Debug, Serialize)]
pub(crate) struct RelationDocument {
    equation: &'static str,
    statement: String,
    #[serde(serialize_with = "number_or_word")]
    left: f64,
    sign: String,
    #[serde(serialize_with = "number_or_word")]
    right: f64,
    holds: bool,
    #[serde(serialize_with = "number_or_word")]
    margin: f64,
}

#[derive(Debug, Serialize)]
struct Change {
    at: f64,
    from: Mode,
    to: Mode,
}

impl PointDocument {
    /// The answer for a reduced force.
    pub(crate) fn of(reduced: &Reduced) -> PointDocument {
        let point = &reduced.point;
        let mode = reduced.mode();
        let step = |step: &Step| TraceStep {
            mode: reduced.orient(step.mode),
            holds: step.holds,
            relations: step.relations.iter().map(RelationDocument::of).collect(),
        };
        let change = |crossing: &Crossing| Change {
            at: crossing.at,
            from: reduced.orient(crossing.from),
            to: reduced.orient(crossing.to),
        };
        let margins = point.margins();
        PointDocument {
            gamma: point.gamma(),
            k_prime: point.k_prime(),
            k: point.k(),
            mu: point.mu(),
            mirrored: reduced.mirrored,
            mode,
            mode_words: mode.words(),
            unique: point.is_unique(),
            also: reduced.others(),
            case: point.chart().case().words(),
            motion: reduced.motion(),
            trace: point.explain().steps.iter().map(step).collect(),
            leaves_rest: margins.leaves_rest().as_ref().map(change),
            along_k: margins.along_k.iter().map(change).collect(),
            along_mu: margins.along_mu.iter().map(change).collect(),
        }
    }
}

impl RelationDocument {
    pub(crate) fn of(relation: &Relation) -> RelationDocument {
        let Relation { equation, left, sign, right, holds, .. } = *relation;
        RelationDocument {
            equation,
            statement: relation.statement(),
            left,
            sign: sign.to_string(),
            right,
            holds,
            margin: relation.margin(),
        }
    }
}
