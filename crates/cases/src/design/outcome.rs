//! What a case comes to: the worst of its situations in each respect.

use standfast::{InputError, Mode};

use crate::assess::situation::Assessed;
use crate::case::Case;

/// How far a rising load is followed: beyond any factor that a design aims at.
pub(super) const FAR: f64 = 1e4;

/// The answers to a case's situations.
pub(super) struct Outcome {
    pub(super) all: Vec<Assessed>,
    /// What is unusual about the case.
    pub(super) warnings: Vec<String>,
}

impl Outcome {
    pub(super) fn of(case: &Case) -> Result<Outcome, InputError> {
        let situations = case.situations().into_iter();
        let all = situations.map(|loaded| Assessed::of(loaded, FAR)).collect::<Result<_, _>>()?;
        Ok(Outcome { all, warnings: case.warnings() })
    }

    /// The least of a number over all situations.
    fn worst(&self, of: fn(&Assessed) -> f64) -> f64 {
        of(self.governing(of))
    }

    /// The situation in which a number is least.
    pub(super) fn governing(&self, of: fn(&Assessed) -> f64) -> &Assessed {
        let worst = self.all.iter().min_by(|one, two| of(one).total_cmp(&of(two)));
        worst.expect("a case has a situation")
    }

    /// SF_sliding.
    pub(super) fn sliding(&self) -> f64 {
        self.worst(sliding)
    }

    /// SF_overturning, about either corner.
    pub(super) fn overturning(&self) -> f64 {
        self.worst(overturning)
    }

    /// The smaller of both factors.
    pub(super) fn factor(&self) -> f64 {
        self.sliding().min(self.overturning())
    }

    /// The load factor at which the body first leaves rest; infinite if it does not.
    pub(super) fn first_load_factor(&self) -> f64 {
        self.worst(first)
    }

    /// The mode under the full load, of the situation that leaves rest first.
    pub(super) fn mode(&self) -> Option<Mode> {
        self.governing(first).full.mode
    }

    /// The mode in which the body leaves rest.
    pub(super) fn first_mode(&self) -> Option<Mode> {
        self.governing(first).departure().and_then(|stage| stage.mode)
    }
}

pub(super) fn sliding(assessed: &Assessed) -> f64 {
    assessed.stability.sliding
}

/// About either corner.
pub(super) fn overturning(assessed: &Assessed) -> f64 {
    assessed.stability.least_overturning()
}

/// Where the rising load first moves the body. Without a load that rises, the body moves at once or never.
pub(super) fn first(assessed: &Assessed) -> f64 {
    match assessed.departure() {
        Some(stage) => stage.from,
        None if assessed.full.mode == Some(Mode::Rest) => f64::INFINITY,
        None => 0.0,
    }
}
