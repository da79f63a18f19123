//! A load that rises, in stages.

use crate::mode::{Mode, Modes};
use crate::neighbour::Neighbour;
use crate::verdict::Verdict;

/// Load factors with the same modes, on any base.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Stage {
    /// The load factor at which it begins.
    pub from: f64,
    /// The load factor at which it ends; infinite for the last.
    pub to: f64,
    /// The verdict reported; written under the name `mode`, as in every answer.
    #[cfg_attr(feature = "serde", serde(rename = "mode"))]
    pub verdict: Option<Verdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
}

impl Stage {
    /// The mode reported; `None` where the ground fails, too.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict.and_then(Verdict::mode)
    }

    /// The consistent modes beside the one reported.
    pub fn others(&self) -> Modes {
        self.modes.without(self.mode())
    }

    /// The stages up to a load factor.
    pub fn up_to(stages: &[Stage], largest: f64) -> Vec<Stage> {
        let within = stages.iter().filter(|stage| stage.from < largest);
        within.map(|stage| Stage { to: stage.to.min(largest), ..*stage }).collect()
    }
}

impl Neighbour for Stage {
    fn is_like(&self, next: &Stage) -> bool {
        (self.verdict, self.modes) == (next.verdict, next.modes)
    }

    fn prolong(&mut self, next: &Stage) {
        self.to = next.to;
    }
}
