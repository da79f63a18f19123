//! What the body does under the full load at once, and while it rises, in words.

use standfast::Mode;
use standfast::contact::path::Stage;

use super::Assessed;
use crate::describe::kilonewtons;
use crate::layout::{columns, digits, row};

/// A mode, or the lack of one, as a predicate with its symbol.
pub(super) fn predicate(mode: Option<Mode>) -> String {
    match mode {
        Some(mode) => format!("{} ({mode})", mode.words()),
        None => "has no consistent mode".to_owned(),
    }
}

/// The state under the full load, in sentences.
pub(super) fn full_load(assessed: &Assessed) -> Vec<String> {
    let full = &assessed.full;
    let mut sentences = Vec::new();
    if full.is_lifted() {
        let lift = kilonewtons(0.0 - full.wrench.p);
        let lifted = if full.wrench.p == 0.0 {
            "The loads carry the whole weight: nothing presses the body on its base, and safety factors mean nothing."
                .to_owned()
        } else if full.mode == Some(Mode::Flight) {
            format!("The loads lift the body with {lift} more than its weight: safety factors mean nothing.")
        } else {
            format!(
                "The loads lift the body with {lift} more than its weight, but press one corner down by their moment; \
                 safety factors mean nothing."
            )
        };
        sentences.push(lifted);
    }
    sentences.push(format!("Applied at once, the full load: the body {}.", predicate(full.mode)));
    sentences.push(uniqueness(assessed));
    sentences
}

fn uniqueness(assessed: &Assessed) -> String {
    let full = &assessed.full;
    let mode = match full.mode {
        None => {
            return "That happens only where friction to stick is larger than friction to slip.".to_owned();
        }
        Some(_) if full.is_unique() => return "The answer is unique.".to_owned(),
        Some(mode) => mode,
    };
    let list: Vec<_> = full.others().iter().map(|mode| predicate(Some(mode))).collect();
    let verb = if list.len() == 1 { "satisfies" } else { "satisfy" };
    let mut text = format!(
        "The answer is not unique: that it {} {verb} the equations of motion, Coulomb's law and the contact \
         conditions as well. Rigid-body mechanics cannot choose; a suddenly applied load favours {mode}.",
        list.join(" and that it "),
    );
    if let Some(risen) = assessed.risen().filter(|risen| *risen != mode && *risen != Mode::Rest) {
        text += &format!(" Under a rising load the body comes there in {risen} and stays in it.");
    }
    text
}

/// The stages of the rising load.
pub(super) fn stages(assessed: &Assessed) -> String {
    let mut rows = vec![row!["from", "to", "mode", ""]];
    rows.extend(assessed.path.iter().map(|stage| {
        let mut others = stage.modes;
        if let Some(mode) = stage.mode {
            others.remove(mode);
        }
        let also = if others.is_empty() { String::new() } else { format!("not unique, also {others}") };
        row![digits(stage.from), digits(stage.to), stage.mode.map_or("none", Mode::symbol), also]
    }));
    columns(&rows, 2, &[0, 1])
}

/// Where the body leaves rest as the load rises.
pub(super) fn departure(assessed: &Assessed) -> String {
    match assessed.departure() {
        None => {
            format!("The body does not leave rest up to {} times the variable load.", digits(assessed.up_to))
        }
        Some(Stage { from: 0.0, mode, .. }) => {
            let permanent = assessed.loaded.situation.at(0.0).ok().and_then(|state| state.mode);
            if permanent == Some(Mode::Rest) {
                format!(
                    "Any share of the variable load, however small, moves the body: it {}.",
                    predicate(*mode)
                )
            } else {
                format!("The permanent loads alone move the body: it {}.", predicate(*mode))
            }
        }
        Some(Stage { from, mode, .. }) => {
            let into = mode.map_or("no consistent mode", Mode::symbol);
            format!(
                "The body first leaves rest at {} % of the variable load, into {into}.",
                digits(100.0 * from)
            )
        }
    }
}

/// The difference between the full load at once and a rising one.
pub(super) fn difference(assessed: &Assessed) -> String {
    let (full, path) = (assessed.full.mode, assessed.departure());
    let symbol = |mode: Option<Mode>| mode.map_or("no consistent mode", Mode::symbol);
    match path {
        Some(stage) if stage.from == 0.0 => {
            "With no rest to begin from, a rising load has no first departure.".to_owned()
        }
        Some(stage) if stage.from < 1.0 && full == Some(Mode::Rest) => format!(
            "At once, the full load leaves the body at rest; rising, it has moved it before, at {} %.",
            digits(100.0 * stage.from)
        ),
        _ if full == Some(Mode::Rest) => {
            "At once or rising, the full load leaves the body at rest.".to_owned()
        }
        Some(stage) if stage.mode == full => format!(
            "At once and rising, the body takes up the same mode, {}; rising, it moves from {} % on.",
            symbol(full),
            digits(100.0 * stage.from)
        ),
        Some(stage) => format!(
            "At once, the full load starts {}; rising, the load has started {} before, at {} %.",
            symbol(full),
            symbol(stage.mode),
            digits(100.0 * stage.from)
        ),
        None => format!("At once, the full load starts {}.", symbol(full)),
    }
}
