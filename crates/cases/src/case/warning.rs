//! What in a case is possible, but so unusual that it may be a slip.

use super::{Case, Weight};
use crate::layout::digits;

impl Case {
    /// Warnings about the body and about the range of the wave formulas, in sentences, each with the value that triggered
    /// it.
    pub fn warnings(&self) -> Vec<String> {
        self.body_warnings().chain(self.wave_warnings()).collect()
    }

    pub(crate) fn body_warnings(&self) -> impl Iterator<Item = String> {
        let body = &self.body;
        let half = body.width() / 2.0;
        let (left, right) = body.base_edges();
        let beyond = [("base_left", left, "left"), ("base_right", right, "right")]
            .into_iter()
            .filter(move |(_, edge, _)| *edge > half)
            .map(move |(key, edge, side)| {
                let by = digits(edge - half);
                format!("{key} = {} m: the base reaches {by} m beyond the body's {side} side", digits(edge))
            });
        let base = body.base_width();
        let outside = match self.weight {
            Weight::Buoyant { arm, .. } if arm > base => Some(format!(
                "weight_arm = {} m is more than the base is wide, {} m: the body does not stand under its own weight",
                digits(arm),
                digits(base)
            )),
            _ => None,
        };
        beyond.chain(outside)
    }

    pub(crate) fn wave_warnings(&self) -> impl Iterator<Item = String> {
        self.wave.iter().flat_map(|wave| wave.goda.warnings.iter().map(ToString::to_string))
    }
}
