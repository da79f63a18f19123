//! The answer to a point of the plane of a base that crushes.

use std::fmt::Write;

use serde::Serialize;
use standfast::ground::strength::{CrushMotion, CrushPoint};
use standfast::initiation::{Crossing, Step, Trace};
use standfast::{Corner, Mode, Modes, Motion, Verdict};

use super::{Change, RelationDocument, TraceStep};
use crate::assess::SCHEMA;
use crate::describe::{self, Changes};
use crate::layout::{columns, digits, paragraph, row};
use crate::results::number_or_word;

/// A point on a base that crushes. The report's force points left; one to the right is its mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crushing {
    /// The point, for a force to the left.
    pub point: CrushPoint,
    /// Whether the force points right, so that modes and motions are to be mirrored.
    pub mirrored: bool,
}

impl Crushing {
    fn verdict(&self) -> Verdict {
        let verdict = self.point.verdict();
        if self.mirrored { verdict.mirrored() } else { verdict }
    }

    fn others(&self) -> Modes {
        let others = self.point.others();
        if self.mirrored { others.mirrored() } else { others }
    }

    fn motion(&self) -> Option<CrushMotion> {
        let motion = self.point.motion()?;
        Some(if self.mirrored { motion.mirrored() } else { motion })
    }

    fn orient(&self, mode: Mode) -> Mode {
        if self.mirrored { mode.mirrored() } else { mode }
    }

    fn base(&self) -> Base {
        let omega = self.point.omega();
        let motion = self.motion();
        let neutral = motion.and_then(|motion| motion.neutral.map(|_| motion.pressed.width()));
        Base {
            omega,
            // N = P as a turn begins.
            pivot: motion.map(|_| neutral.map_or(omega, |neutral| neutral / 2.0)),
            neutral,
            effective_width: motion.map(|motion| 2.0 * (1.0 - motion.motion.xi.abs())),
        }
    }
}

/// What the base does, in B.
#[derive(Debug, Clone, Copy, Serialize)]
struct Base {
    omega: f64,
    /// From the edge, the reaction of a body that turns, or is about to.
    pivot: Option<f64>,
    /// From the edge about which the body turns.
    neutral: Option<f64>,
    effective_width: Option<f64>,
}

/// The answer as text; see [`point::text`](super::text).
pub fn text(given: &Crushing, explain: bool) -> String {
    if explain { explanation(given) } else { format!("{}{}", one_line(given), paragraph(&on_base(given), 2)) }
}

fn one_line(given: &Crushing) -> String {
    let verdict = given.verdict();
    let others = given.others();
    let unique = match verdict {
        Verdict::BearingFailure => "no motion is given".to_owned(),
        _ if others.is_empty() => "unique".to_owned(),
        _ => format!("not unique, also {others}"),
    };
    format!("{verdict}  {}  ({unique})\n", verdict.words())
}

/// Where the base bears, in a sentence.
fn on_base(given: &Crushing) -> String {
    let omega = given.point.omega();
    let share = digits(100.0 * omega);
    let Some(motion) = given.motion() else {
        return format!(
            "The base would need {share} % of its width to carry the weight alone (ω = {}): it cannot.",
            digits(omega)
        );
    };
    let width = motion.pressed.width();
    match given.verdict().mode().and_then(Mode::corner) {
        Some(corner) => {
            let (edge, way) = match corner {
                Corner::O => ("O", "right"),
                Corner::OPrime => ("O'", "left"),
            };
            format!(
                "The base crushes: {} % of it at {edge}. The body turns about the neutral point, {} B {way} of {edge}, and the \
                 reaction acts in the middle of what is crushed, {} B from {edge} (ω = {}).",
                digits(50.0 * width),
                digits(width),
                digits(width / 2.0),
                digits(omega)
            )
        }
        None => format!(
            "The reaction acts on an effective width of {} B, {} % of the base; the weight needs {share} % of it \
             (ω = {}).",
            digits(2.0 * (1.0 - motion.motion.xi.abs())),
            digits(100.0 * (1.0 - motion.motion.xi.abs())),
            digits(omega)
        ),
    }
}

fn uniqueness(given: &Crushing) -> String {
    let bound = match given.point.bound() {
        infinite if infinite.is_infinite() => "one mode only is consistent under any friction".to_owned(),
        bound => format!("one mode only is consistent up to a friction of μ_P = {}", digits(bound)),
    };
    let others = given.others();
    if others.is_empty() {
        return format!("The answer is unique; with this ω {bound}.");
    }
    let list: Vec<_> = others.iter().map(|mode| format!("{mode} (the body {})", mode.words())).collect();
    let verb = if list.len() == 1 { "satisfies" } else { "satisfy" };
    format!(
        "The answer is not unique: {} {verb} the equations of motion, Coulomb's law and the contact conditions as well; with this \
         ω {bound}. {} is the first of them in the order of the decision, and a suddenly applied force favours it.",
        list.join(" and "),
        given.verdict(),
    )
}

fn explanation(given: &Crushing) -> String {
    let rigid = given.point.point();
    let verdict = given.verdict();
    let mut text = paragraph(&format!("The body {} ({verdict}).", verdict.words()), 0);
    text += &paragraph(&on_base(given), 0);
    let Some(Trace { steps, .. }) = given.point.explain() else { return text };
    text += &paragraph(&uniqueness(given), 0);
    if given.mirrored {
        text += &paragraph(describe::MIRRORED, 0);
    }
    let _ = writeln!(
        text,
        "\nPoint\n  γ = {}   k' = {}   k = {}   μ = {}   ω = {}\n\nStep by step",
        digits(rigid.gamma()),
        digits(rigid.k_prime()),
        digits(rigid.k()),
        digits(rigid.mu()),
        digits(given.point.omega()),
    );
    for step in &steps {
        let verdict = if step.holds { "holds" } else { "does not hold" };
        let _ = writeln!(text, "  {} {verdict}", given.orient(step.mode));
        text += &describe::relations(&step.relations, 4);
    }
    text += "\nSafety factors\n";
    let rows = [
        row!["sliding", "μ/k", digits(given.point.safety_against_sliding())],
        row!["overturning", "(1−ω)/(k γ |1+k'|)", digits(given.point.safety_against_overturning())],
    ];
    text += &columns(&rows, 2, &[]);
    if let Some(CrushMotion { motion, .. }) = given.motion() {
        text += "\nAt onset\n";
        text += &describe::motion(&motion);
    }
    let margins = given.point.margins();
    let changes = Changes {
        leaves_rest: margins.leaves_rest(),
        along_k: &margins.along_k,
        along_mu: &margins.along_mu,
        k: rigid.k(),
        mu: rigid.mu(),
        mirrored: given.mirrored,
    };
    text += "\nChanges of mode\n";
    text += &changes.as_k_grows();
    text += &format!("  as the friction grows, at k = {}:\n", digits(rigid.k()));
    text += &changes.as_mu_grows(4);
    text
}

/// The answer as a JSON document, complete and at full precision; the keys are those of a point on a rigid base, and `ground`.
pub fn json(given: &Crushing) -> String {
    #[derive(Serialize)]
    struct Document {
        schema: u32,
        gamma: f64,
        k_prime: f64,
        k: f64,
        mu: f64,
        mirrored: bool,
        mode: Verdict,
        mode_words: &'static str,
        unique: bool,
        also: Modes,
        /// The report's cases are those of a rigid base.
        case: Option<&'static str>,
        motion: Option<Motion>,
        ground: Base,
        trace: Vec<TraceStep>,
        leaves_rest: Option<Change>,
        along_k: Vec<Change>,
        along_mu: Vec<Change>,
        #[serde(rename = "SF_sliding", serialize_with = "number_or_word")]
        sliding: f64,
        #[serde(rename = "SF_overturning", serialize_with = "number_or_word")]
        overturning: f64,
    }
    let rigid = given.point.point();
    let verdict = given.verdict();
    let also = given.others();
    let change = |crossing: &Crossing| Change {
        at: crossing.at,
        from: given.orient(crossing.from),
        to: given.orient(crossing.to),
    };
    let step = |step: &Step| TraceStep {
        mode: given.orient(step.mode),
        holds: step.holds,
        relations: step.relations.iter().map(RelationDocument::of).collect(),
    };
    let margins = given.point.margins();
    crate::json(&Document {
        schema: SCHEMA,
        gamma: rigid.gamma(),
        k_prime: rigid.k_prime(),
        k: rigid.k(),
        mu: rigid.mu(),
        mirrored: given.mirrored,
        mode: verdict,
        mode_words: verdict.words(),
        unique: also.is_empty(),
        also,
        case: None,
        motion: given.motion().map(|motion| motion.motion),
        ground: given.base(),
        trace: given.point.explain().iter().flat_map(|trace| &trace.steps).map(step).collect(),
        leaves_rest: margins.leaves_rest().as_ref().map(change),
        along_k: margins.along_k.iter().map(change).collect(),
        along_mu: margins.along_mu.iter().map(change).collect(),
        sliding: given.point.safety_against_sliding(),
        overturning: given.point.safety_against_overturning(),
    })
}
