//! What a case comes to: the worst of its situations in each respect.

use standfast::{InputError, Mode, Stability};

use crate::assess::situation::Assessed;
use crate::case::Case;

/// How far a rising load is followed: beyond any factor that a design aims at.
pub(super) const FAR: f64 = 1e4;

/// The answers to a case's situations.
pub(super) struct Outcome {
    pub(super) all: Vec<Assessed>,
}

impl Outcome {
    pub(super) fn of(case: &Case) -> Result<Outcome, InputError> {
        let situations = case.situations().into_iter();
        Ok(Outcome { all: situations.map(|loaded| Assessed::of(loaded, FAR)).collect::<Result<_, _>>()? })
    }

    fn worst(&self, of: impl Fn(&Assessed) -> f64) -> f64 {
        self.all.iter().map(of).fold(f64::INFINITY, f64::min)
    }

    /// SF_sliding.
    pub(super) fn sliding(&self) -> f64 {
        self.worst(|assessed| assessed.stability.sliding)
    }

    /// SF_overturning.
    pub(super) fn overturning(&self) -> f64 {
        self.worst(|assessed| assessed.stability.overturning)
    }

    /// The smaller of both factors.
    pub(super) fn factor(&self) -> f64 {
        self.worst(|Assessed { stability: Stability { sliding, overturning, .. }, .. }| {
            sliding.min(*overturning)
        })
    }

    /// The load factor at which the body first leaves rest; infinite if it does not.
    pub(super) fn first_load_factor(&self) -> f64 {
        self.worst(first)
    }

    /// The situation that leaves rest first.
    pub(super) fn governing(&self) -> &Assessed {
        let worst = self.all.iter().min_by(|one, two| first(one).total_cmp(&first(two)));
        worst.expect("a case has a situation")
    }

    /// The mode under the full load, of the situation that leaves rest first.
    pub(super) fn mode(&self) -> Option<Mode> {
        self.governing().full.mode
    }

    /// The mode in which the body leaves rest.
    pub(super) fn first_mode(&self) -> Option<Mode> {
        self.governing().departure().and_then(|stage| stage.mode)
    }
}

/// Without a load that rises, the body moves at once or never.
pub(super) fn first(assessed: &Assessed) -> f64 {
    match assessed.departure() {
        Some(stage) => stage.from,
        None if assessed.full.mode == Some(Mode::Rest) => f64::INFINITY,
        None => 0.0,
    }
}
