//! Every friction, in spans.

use crate::error::InputError;
use crate::mode::{Mode, Modes};
use crate::neighbour::Neighbour;
use crate::verdict::{Decision, Verdict};

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
    /// The spans of friction from zero without end between ascending boundaries with their numbers, each decided at one friction inside.
    /// Beyond `up_to` none is asked for, and the last span is as it is there.
    pub(crate) fn between(
        boundaries: Vec<(f64, usize)>,
        up_to: f64,
        decide: impl Fn(f64) -> Result<Decision, InputError>,
    ) -> Result<Vec<Span>, InputError> {
        let mut spans = Vec::new();
        let mut begin = (0.0, 0);
        for next in boundaries.into_iter().map(Some).chain([None]) {
            let (from, boundary) = begin;
            let to = next.map_or(f64::INFINITY, |(μ, _)| μ);
            let end = to.min(up_to);
            // Beyond the last boundary any friction will do.
            let inside = if end.is_finite() { from + (end - from) / 2.0 } else { 2.0 * from + 1.0 };
            let Decision { verdict, modes } = decide(inside)?;
            Span { from, to, verdict, modes, boundary }.join(&mut spans);
            begin = next.unwrap_or(begin);
        }
        Ok(spans)
    }

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
