//! The joints of a situation in words.

use standfast::footprint::PlanLimit;
use standfast::{Corner, Mode, Verdict};

use super::{Assessed, Joints, predicate};
use crate::case::called;

/// Joints in a row: "joint 1", "joints 1, 2 and 4".
pub fn together(joints: &[usize]) -> String {
    let numbers: Vec<String> = joints.iter().map(|joint| (joint + 1).to_string()).collect();
    let word = if joints.len() == 1 { "joint" } else { "joints" };
    format!("{word} {}", listed(&numbers))
}

/// Words in a row: "a", "a and b", "a, b and c".
pub fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Modes from the base up: `RE / SL / RE`.
pub fn slashed(modes: &[Mode]) -> String {
    modes.iter().map(|mode| mode.symbol()).collect::<Vec<_>>().join(" / ")
}

/// What a joint in a mode does, with the symbol.
fn goes(mode: Mode) -> String {
    let end = |corner| if corner == Corner::O { "left end" } else { "right end" };
    let words = match (mode.corner(), mode.slip()) {
        _ if mode == Mode::Flight => "comes apart".to_owned(),
        (Some(corner), None) => format!("rocks about its {}", end(corner)),
        (Some(corner), Some(_)) => format!("slides and rocks about its {}", end(corner)),
        (None, Some(_)) => mode.words().to_owned(),
        (None, None) => return "rests".to_owned(),
    };
    format!("{words} ({mode})")
}

impl Joints {
    /// A joint by its number and name: `joint 3 (cap)`; the base is joint 1.
    pub fn called(&self, joint: usize) -> String {
        called(joint, self.places[joint].name.as_deref())
    }

    /// What all joints do, in a clause: "joint 3 (third) slides to the left (SL), joints 1, 2 and 4 rest".
    pub fn all_go(&self, modes: &[Mode]) -> String {
        let places = || modes.iter().copied().enumerate();
        let mut clauses: Vec<String> = places()
            .filter(|(_, mode)| *mode != Mode::Rest)
            .map(|(joint, mode)| format!("{} {}", self.called(joint), goes(mode)))
            .collect();
        let resting: Vec<usize> =
            places().filter(|(_, mode)| *mode == Mode::Rest).map(|(joint, _)| joint).collect();
        match resting.as_slice() {
            [] => {}
            all if all.len() == modes.len() => return EVERY.to_owned(),
            [one] => clauses.push(format!("{} rests", together(&[*one]))),
            several => clauses.push(format!("{} rest", together(several))),
        }
        clauses.join(", ")
    }

    /// What the joints do that do not rest, in a clause.
    pub fn moving(&self, modes: &[Mode]) -> String {
        let moving = modes.iter().copied().enumerate().filter(|(_, mode)| *mode != Mode::Rest);
        let clauses: Vec<String> =
            moving.map(|(joint, mode)| format!("{} {}", self.called(joint), goes(mode))).collect();
        if clauses.is_empty() { EVERY.to_owned() } else { clauses.join(", ") }
    }

    /// What begins under the full load, in a clause; `whole` is the situation whose joints they are.
    pub fn at_once(&self, whole: &Assessed) -> String {
        match self.modes() {
            Some([]) => "no joint has a consistent mode".to_owned(),
            Some(modes) => self.all_go(modes),
            // What does not rest under the full load is known to be one of them at least, and not which.
            None if self.rests(whole) => EVERY.to_owned(),
            None => format!("not every joint rests: first {}", self.departs(whole)),
        }
    }

    /// What begins as the loads pass where the first joint leaves rest, in a clause.
    pub fn departs(&self, whole: &Assessed) -> String {
        let first = self.leaves.joints();
        match (self.departing(), first.as_slice()) {
            ([], [one]) => {
                let verdict = whole.on_joints().nth(*one).and_then(|on| on.outcome.departure.verdict());
                let goes = match verdict {
                    Some(Verdict::Begins(mode)) => goes(mode),
                    Some(_) => "gives way: the ground fails (BF)".to_owned(),
                    None => "leaves rest".to_owned(),
                };
                format!("{} {goes}", self.called(*one))
            }
            ([], several) => format!("{} leave rest", together(several)),
            (modes, _) => self.all_go(modes),
        }
    }
}

impl Assessed {
    /// What begins under the full load, in a clause: of the body, or of its joints.
    pub fn at_once(&self) -> String {
        match &self.joints {
            Some(joints) => joints.at_once(self),
            None => match self.on_plan() {
                Some(_) if self.mode().is_none() => "the body does not rest".to_owned(),
                _ => format!("the body {}", predicate(self.verdict())),
            },
        }
    }

    /// What begins as the loads pass where it leaves rest, in a clause.
    pub fn departs(&self) -> String {
        match &self.joints {
            Some(joints) => joints.departs(self),
            None => match self.on_plan() {
                Some(Some(PlanLimit::Slides)) => "the body slides".to_owned(),
                Some(Some(PlanLimit::Turns)) => "the body slides and turns".to_owned(),
                Some(Some(PlanLimit::Tips { .. })) => "the body tips about an edge".to_owned(),
                Some(Some(PlanLimit::Lifts)) => "the body is lifted".to_owned(),
                Some(None) => "the body rests".to_owned(),
                None => format!("the body {}", predicate(self.departure().verdict())),
            },
        }
    }

    /// What ends rest on a base seen from above, if anything does; `None` in the plane of the section.
    pub fn on_plan(&self) -> Option<Option<PlanLimit>> {
        self.outcome.plan.as_ref().map(|plan| plan.departure.limits.first().copied())
    }
}

/// What joints do that all rest.
const EVERY: &str = "every joint rests";
