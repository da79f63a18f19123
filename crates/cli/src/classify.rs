//! `standfast classify`: one point of the k–μ plane.

use std::fmt::Write;

use standfast::{Point, Reduced};

use crate::answer::Answer;
use crate::args::Format;
use crate::describe;
use crate::layout::{digits, paragraph};

/// The answer to one point, as text or JSON.
pub fn classify(point: Point, explain: bool, format: Format) -> String {
    let reduced = Reduced { point, mirrored: false };
    match format {
        Format::Json => crate::json(&Answer::of(&reduced)),
        Format::Text if explain => explanation(&reduced),
        Format::Text => one_line(&reduced),
    }
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
        digits(point.slenderness()),
        digits(point.elevation()),
        digits(point.force()),
        digits(point.friction()),
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
