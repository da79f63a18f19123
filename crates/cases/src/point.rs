//! The answer to one point of the k–μ plane.

use std::fmt::Write;

use standfast::{Point, Reduced};

use crate::answer::Answer;
use crate::describe;
use crate::layout::{digits, paragraph};

/// The answer as one line of text, or with `explain` every step of the decision, the motion, and where the mode changes.
pub fn text(point: Point, explain: bool) -> String {
    let reduced = Reduced { point, mirrored: false };
    if explain { explanation(&reduced) } else { one_line(&reduced) }
}

/// The answer as a JSON document, complete and at full precision.
pub fn json(point: Point) -> String {
    crate::json(&Answer::of(&Reduced { point, mirrored: false }))
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
        let _ = writeln!(text, "  {} {verdict}", step.mode);
        text += &describe::relations(&step.relations, 4);
    }
    text += "\nSafety factors\n";
    text += &describe::safety_factors(reduced);
    text += "\nAt onset\n";
    text += &describe::motion(reduced, None);
    text += "\nChanges of mode\n";
    text += &describe::changes(reduced, None);
    text
}
