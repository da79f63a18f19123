//! A point of the plane of a base that crushes.

use serde::Serialize;
use standfast::ground::strength::{CrushMotion, CrushPoint};
use standfast::{Corner, Mode, Modes, Verdict};

use crate::layout::digits;

/// A point on a base that crushes, for a force to the left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crushing {
    pub(super) point: CrushPoint,
    /// True if the force points right, so that modes and motions are to be mirrored.
    pub(super) mirrored: bool,
}

impl Crushing {
    pub(super) fn verdict(&self) -> Verdict {
        let verdict = self.point.verdict();
        if self.mirrored { verdict.mirrored() } else { verdict }
    }

    pub(super) fn others(&self) -> Modes {
        let others = self.point.others();
        if self.mirrored { others.mirrored() } else { others }
    }

    pub(super) fn motion(&self) -> Option<CrushMotion> {
        let motion = self.point.motion()?;
        Some(if self.mirrored { motion.mirrored() } else { motion })
    }

    pub(super) fn base(&self) -> BaseNumbers {
        let omega = self.point.omega();
        let motion = self.motion();
        let neutral = motion.and_then(|motion| motion.neutral.map(|_| motion.pressed.width()));
        BaseNumbers {
            omega,
            // N = V as a turn begins.
            pivot: motion.map(|_| neutral.map_or(omega, |neutral| neutral / 2.0)),
            neutral,
            effective_width: motion.map(|motion| 2.0 * (1.0 - motion.motion.xi.abs())),
        }
    }
}

/// Numbers of the base, in B.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct BaseNumbers {
    omega: f64,
    /// From the edge, the reaction of a body that turns, or is about to.
    pivot: Option<f64>,
    /// From the edge about which the body turns.
    neutral: Option<f64>,
    effective_width: Option<f64>,
}

impl Crushing {
    /// Sentence on the part of the base that bears.
    pub(super) fn words(&self) -> String {
        let omega = self.point.omega();
        let share = digits(100.0 * omega);
        let Some(motion) = self.motion() else {
            return format!(
                "The base would need {share} % of its width to carry the weight alone (ω = {}): it cannot.",
                digits(omega)
            );
        };
        let width = motion.pressed.width();
        match self.verdict().mode().and_then(Mode::corner) {
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

    /// Sentences on the uniqueness of the answer.
    pub(super) fn uniqueness(&self) -> String {
        let bound = match self.point.bound() {
            infinite if infinite.is_infinite() => "one mode only is consistent under any friction".to_owned(),
            bound => format!("one mode only is consistent up to a friction of μ_P = {}", digits(bound)),
        };
        let others = self.others();
        if others.is_empty() {
            return format!("The answer is unique; with this ω {bound}.");
        }
        let list: Vec<_> = others.iter().map(|mode| format!("{mode} (the body {})", mode.words())).collect();
        let verb = if list.len() == 1 { "satisfies" } else { "satisfy" };
        format!(
            "The answer is not unique: {} {verb} the equations of motion, Coulomb's law and the contact conditions as well; with this \
         ω {bound}. {} is the first of them in the order of the decision, and a suddenly applied force favours it.",
            list.join(" and "),
            self.verdict(),
        )
    }
}
