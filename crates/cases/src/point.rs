//! The answer to one point of the k–μ plane: as text, and as a JSON document that stands alone or in the answer to a case.

mod crush;

use std::fmt::Write;

use serde::Serialize;
use standfast::ground::strength::CrushPoint;
use standfast::initiation::{Crossing, Step};
use standfast::loads::Reduced;
use standfast::relation::Relation;
use standfast::{InputError, Mode, Modes, Motion, Response, Verdict};

use self::crush::{BaseNumbers, Crushing};
use crate::describe::{self, Changes};
use crate::json::{SCHEMA, number_or_word, written};
use crate::layout::{columns, digits, factor, paragraph, row};

/// A point on its base. The report's force points left; one to the right is its mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedPoint {
    reduced: Reduced,
    /// The point on a base that crushes; `None` on a rigid one.
    crushing: Option<Crushing>,
}

impl PlacedPoint {
    /// A point on a base of ω; zero of a rigid one.
    ///
    /// # Errors
    /// If `omega` is negative or not finite.
    pub fn new(reduced: Reduced, omega: f64) -> Result<PlacedPoint, InputError> {
        if omega == 0.0 {
            return Ok(PlacedPoint { reduced, crushing: None });
        }
        let point = CrushPoint::of(reduced.point, omega)?;
        Ok(PlacedPoint { reduced, crushing: Some(Crushing { point, mirrored: reduced.mirrored }) })
    }

    fn verdict(&self) -> Verdict {
        self.crushing.map_or_else(|| Verdict::Begins(self.reduced.mode()), |crushing| crushing.verdict())
    }

    fn others(&self) -> Modes {
        self.crushing.map_or_else(|| self.reduced.others(), |crushing| crushing.others())
    }

    fn motion(&self) -> Option<Motion> {
        match self.crushing {
            Some(crushing) => crushing.motion().map(|begun| begun.motion),
            None => Some(self.reduced.motion()),
        }
    }

    /// The steps of the decision; none where the base cannot carry the weight.
    fn steps(&self) -> Vec<Step> {
        match self.crushing {
            Some(crushing) => crushing.point.explain().map_or_else(Vec::new, |trace| trace.steps),
            None => self.reduced.point.explain().steps,
        }
    }

    /// Changes of the mode along k and along μ, and the departure from rest.
    fn changes(&self) -> Changes {
        match self.crushing {
            None => Changes::of(&self.reduced),
            Some(crushing) => {
                let margins = crushing.point.margins();
                Changes {
                    leaves_rest: margins.leaves_rest(),
                    along_k: margins.along_k,
                    along_mu: margins.along_mu,
                    k: self.reduced.point.k(),
                    mu: self.reduced.point.mu(),
                    mirrored: self.reduced.mirrored,
                }
            }
        }
    }

    /// The safety factors against sliding and overturning, and the formula of the latter.
    fn factors(&self) -> (f64, f64, &'static str) {
        let rigid = &self.reduced.point;
        match self.crushing.map(|crushing| crushing.point) {
            Some(point) => {
                (point.safety_against_sliding(), point.safety_against_overturning(), "(1−ω)/(k γ |1+k'|)")
            }
            None => (rigid.safety_against_sliding(), rigid.safety_against_overturning(), "1/(k γ |1+k'|)"),
        }
    }
}

/// The answer as one line of text, or with `explain` every step of the decision, the motion, and where the mode changes.
pub fn text(placed: &PlacedPoint, explain: bool) -> String {
    if explain { explanation(placed) } else { one_line(placed) }
}

/// The answer as a JSON document, complete and at full precision.
pub fn json(placed: &PlacedPoint) -> String {
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
    let (sliding, overturning, _) = placed.factors();
    written(&Document { schema: SCHEMA, answer: PointDocument::of(placed), sliding, overturning })
}

fn one_line(placed: &PlacedPoint) -> String {
    let (verdict, others) = (placed.verdict(), placed.others());
    let unique = match verdict {
        Verdict::BearingFailure => "no motion is given".to_owned(),
        _ if others.is_empty() => "unique".to_owned(),
        _ => format!("not unique, also {others}"),
    };
    let line = format!("{verdict}  {}  ({unique})\n", verdict.words());
    line + &placed.crushing.map_or_else(String::new, |crushing| paragraph(&crushing.words(), 2))
}

fn explanation(placed: &PlacedPoint) -> String {
    let PlacedPoint { reduced, crushing } = placed;
    let (point, verdict, steps) = (&reduced.point, placed.verdict(), placed.steps());
    let mut text = paragraph(&format!("The body {} ({verdict}).", verdict.words()), 0);
    if let Some(crushing) = crushing {
        text += &paragraph(&crushing.words(), 0);
    }
    if steps.is_empty() {
        return text;
    }
    text += &paragraph(
        &crushing.map_or_else(|| describe::uniqueness(reduced), |crushing| crushing.uniqueness()),
        0,
    );
    if reduced.mirrored {
        text += &paragraph(describe::MIRRORED, 0);
    }
    let _ = write!(
        text,
        "\nPoint\n  γ = {}   k' = {}   k = {}   μ = {}",
        digits(point.gamma()),
        digits(point.k_prime()),
        digits(point.k()),
        digits(point.mu()),
    );
    text += &match crushing {
        Some(crushing) => format!("   ω = {}\n\nStep by step\n", digits(crushing.point.omega())),
        None => {
            let case = point.chart().case().words();
            format!("\n  {case}\n\nStep by step (report's equation numbers)\n")
        }
    };
    for step in &steps {
        let verdict = if step.holds { "holds" } else { "does not hold" };
        let _ = writeln!(text, "  {} {verdict}", reduced.orient(step.mode));
        text += &describe::relations(&step.relations, 4);
    }
    let (sliding, overturning, formula) = placed.factors();
    let rows = [row!["sliding", "μ/k", factor(sliding)], row!["overturning", formula, factor(overturning)]];
    text += "\nSafety factors\n";
    text += &columns(&rows, 2, &[]);
    if let Some(motion) = placed.motion() {
        text += "\nAt onset\n";
        text += &describe::motion(&motion);
    }
    let changes = placed.changes();
    text += "\nChanges of mode\n";
    text += &changes.as_k_grows();
    text += &format!("  as the friction grows, at k = {}:\n", digits(point.k()));
    text += &changes.as_mu_grows(4);
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
    mode: Verdict,
    mode_words: &'static str,
    unique: bool,
    also: Modes,
    /// The report's cases are those of a rigid base.
    case: Option<&'static str>,
    motion: Option<Motion>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<BaseNumbers>,
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
    /// The answer to a point.
    pub(crate) fn of(placed: &PlacedPoint) -> PointDocument {
        let PlacedPoint { reduced, crushing } = placed;
        let (point, verdict, also) = (&reduced.point, placed.verdict(), placed.others());
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
        let changes = placed.changes();
        PointDocument {
            gamma: point.gamma(),
            k_prime: point.k_prime(),
            k: point.k(),
            mu: point.mu(),
            mirrored: reduced.mirrored,
            mode: verdict,
            mode_words: verdict.words(),
            unique: also.is_empty(),
            also,
            case: crushing.is_none().then(|| point.chart().case().words()),
            motion: placed.motion(),
            ground: crushing.map(|crushing| crushing.base()),
            trace: placed.steps().iter().map(step).collect(),
            leaves_rest: changes.leaves_rest.as_ref().map(change),
            along_k: changes.along_k.iter().map(change).collect(),
            along_mu: changes.along_mu.iter().map(change).collect(),
        }
    }

    /// The document of a point on a rigid base with the modes of a response there, which other numbers than those of the point may decide.
    pub(crate) fn of_rigid(reduced: &Reduced, response: &Response) -> PointDocument {
        let point = PointDocument::of(&PlacedPoint { reduced: *reduced, crushing: None });
        let mode = response.verdict.unwrap_or(point.mode);
        let (unique, also) = (response.is_unique(), response.others());
        PointDocument { mode, mode_words: mode.words(), unique, also, ..point }
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
