//! What in a case is possible, but so unusual that it may be a slip: a name, and the value that triggered it.

use std::fmt;

use standfast::{BaseEdges, Slip, wave};

use crate::case::{Case, Weight};
use crate::layout::digits;

/// A warning about a case.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The base reaches beyond the body.
    BaseBeyondBody {
        /// On which side.
        side: Slip,
        /// How far the base reaches from mid-width, m.
        edge: f64,
        /// How far it reaches beyond the body, m.
        beyond: f64,
    },
    /// The buoyant weight acts beside the base.
    WeightBesideBase {
        /// Its arm, m.
        arm: f64,
        /// The width of the base, m.
        base: f64,
    },
    /// The waves leave the range of the formulas.
    Wave(wave::Warning),
}

impl Warning {
    /// Its name, to be told apart by programs.
    pub fn name(&self) -> &'static str {
        match self {
            Warning::BaseBeyondBody { .. } => "base-beyond-body",
            Warning::WeightBesideBase { .. } => "weight-beside-base",
            Warning::Wave(warning) => warning.name(),
        }
    }

    /// Whether it is about waves.
    pub fn is_about_waves(&self) -> bool {
        matches!(self, Warning::Wave(_))
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Warning::BaseBeyondBody { side, edge, beyond } => {
                let (key, side) = match side {
                    Slip::Left => ("base_left", "left"),
                    Slip::Right => ("base_right", "right"),
                };
                let (edge, beyond) = (digits(*edge), digits(*beyond));
                write!(f, "{key} = {edge} m: the base reaches {beyond} m beyond the body's {side} side")
            }
            Warning::WeightBesideBase { arm, base } => write!(
                f,
                "weight_arm = {} m is more than the base is wide, {} m: the body does not stand under its own weight",
                digits(*arm),
                digits(*base)
            ),
            Warning::Wave(warning) => warning.fmt(f),
        }
    }
}

impl Case {
    /// What is unusual about it.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let half = self.body.width() / 2.0;
        let BaseEdges { left, right } = self.body.base_edges();
        for (side, edge) in [(Slip::Left, left), (Slip::Right, right)] {
            if edge > half {
                warnings.push(Warning::BaseBeyondBody { side, edge, beyond: edge - half });
            }
        }
        let base = self.body.base_width();
        if let Weight::Buoyant { arm, .. } = self.weight
            && arm > base
        {
            warnings.push(Warning::WeightBesideBase { arm, base });
        }
        warnings
            .extend(self.wave.iter().flat_map(|wave| wave.goda.warnings.iter().copied().map(Warning::Wave)));
        warnings
    }
}
