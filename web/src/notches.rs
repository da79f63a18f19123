//! Notches on the line of a side of the body while it is held: where it begins to rest, and where it meets all that is asked.

use serde::{Deserialize, Serialize};
use standfast_cases::design::{End, Found, OuterState, SingleChanges, Target};
use standfast_cases::{CaseFile, Portion};
use standfast_inputs::key::Id;

use crate::asked::Question;
use crate::numbers;
use crate::page::Page;

/// A length of a side at which the answer changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Notch {
    /// Metres, as few digits as stay on the better side.
    pub length: f64,
    /// The length, and what begins or ends there.
    label: String,
}

/// The question for the notches of a side, which has one part.
#[derive(Debug)]
pub struct NotchesAsked(Option<(CaseFile, Id)>);

impl NotchesAsked {
    /// Those of a side, by its key.
    pub fn of(file: CaseFile, key: &str) -> NotchesAsked {
        let id = numbers::find(&file, key);
        NotchesAsked(id.map(|id| (file, id)))
    }
}

impl Question for NotchesAsked {
    fn next_part(&mut self) -> Option<String> {
        let (file, id) = self.0.take()?;
        serde_json::to_string(&notches(&file, id)).ok()
    }
}

/// The notches of a side, if they are found soon.
fn notches(file: &CaseFile, id: Id) -> Vec<Notch> {
    let mut found: Vec<Notch> = Vec::new();
    for (target, words) in [(Some(Target::Rest), "rests"), (None, "meets all")] {
        let Ok(changes) = SingleChanges::of(file, target) else { continue };
        // Without criteria both are one question.
        if changes.is_slow() || (target.is_none() && changes.target == Target::Rest) {
            continue;
        }
        let Some(variable) = changes.variables.iter().find(|variable| variable.id() == id) else { continue };
        let Ok(change) = changes.change(variable, Portion::UNSEEN) else { continue };
        let ends: Vec<End> = match change.found {
            Found::Helps(new) => vec![new.end],
            Found::Reserve(ends) => ends.into_iter().collect(),
            Found::Unmet(_) => Vec::new(),
        };
        let fails_beyond = |end: &End| matches!(end.beyond, OuterState::Fails(..));
        found.extend(
            ends.into_iter()
                .filter(fails_beyond)
                .map(|end| Notch { length: end.rounded, label: format!("{words}: {}", end.text) }),
        );
    }
    found
}

impl Page {
    /// Takes the notches of the side that is held, as JSON: near to one it halts.
    pub fn set_notches(&mut self, json: &str) {
        if let Some(held) = &mut self.held {
            held.notches = serde_json::from_str(json).unwrap_or_default();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use standfast::Verdict;
    use standfast_cases::Key;

    /// The side halts at the width from which on the body rests: there it does, and a little below it does not.
    #[test]
    fn a_side_halts_where_the_body_begins_to_rest() {
        let mut page = Page::default();
        page.section((560.0, 400.0), None);
        let (body, scale) = (page.drawn.body.unwrap(), page.drawn.scale.unwrap());
        page.grab();
        let json = NotchesAsked::of(page.settled().clone(), "body.width").next_part().unwrap();
        page.set_notches(&json);
        // 0.6 · 2.1 t/m³ · 9.81 m/s² · 12 m · b = 2700 kN/m, rounded up to the next centimetre.
        let least = 2700.0 / (0.6 * 2.1 * 9.81 * 12.0);
        let [notch] = &page.held.as_ref().unwrap().notches[..] else { panic!("{json}") };
        assert!(notch.length >= least && notch.length < least + 0.01, "{json}");
        assert_eq!(notch.label, format!("rests: {} m", notch.length));
        for (width, rests) in [(least + 2.5 / scale, true), (least - 8.0 / scale, false)] {
            page.drag_side("body.width", (body.x0 + width * scale, body.y1), false);
            let held = page.held.as_ref().unwrap();
            let is = held.answered.verdict().is_some_and(|verdict| verdict == Verdict::REST);
            assert_eq!(is, rests, "{width}");
        }
        // With the mass kept it would be another width.
        page.drag_side("body.width", (body.x0 + (least + 2.5 / scale) * scale, body.y1), true);
        assert_ne!(page.held.as_ref().unwrap().file.inputs().number(Key::Width), Some(18.21));
        page.drag_side("body.width", (body.x0 + (least + 2.5 / scale) * scale, body.y1), false);
        page.release();
        assert!(page.text().contains("width = \"18.21 m\""), "{}", page.text());
    }
}
