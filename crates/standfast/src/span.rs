//! Every friction, in spans.

use crate::mode::{Mode, Modes};
use crate::neighbour::Neighbour;
use crate::verdict::Verdict;

/// Frictions with the same modes, on any base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The friction μ_s at which it begins; 0 for the first.
    pub from: f64,
    /// The friction at which it ends; infinite for the last.
    pub to: f64,
    /// The verdict reported.
    pub verdict: Option<Verdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
    /// The number of the condition or boundary at `from`; 0 for the first span. As long as verdicts, modes and numbers stay the
    /// same, the ends of the spans are smooth functions of block and wrench.
    pub boundary: usize,
}

impl Span {
    /// The mode reported; `None` where the ground fails, too.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict.and_then(Verdict::mode)
    }
}

impl Neighbour for Span {
    fn is_like(&self, next: &Span) -> bool {
        (self.verdict, self.modes) == (next.verdict, next.modes)
    }

    fn prolong(&mut self, next: &Span) {
        self.to = next.to;
    }
}
