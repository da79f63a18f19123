//! Faults of a problem.

use standfast::loads::LoadId;
use standfast::number::exact;
use standfast::{Corner, HistoryError, InputError};
use standfast_watch::Stopped;
use thiserror::Error;

/// Reason why a motion cannot be followed.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number of the contact problem.
    #[error(transparent)]
    Input(#[from] InputError),
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A history.
    #[error(transparent)]
    History(#[from] HistoryError),
    /// A number of the motion.
    #[error("{name} is {}; expected {expected}", exact(*.value))]
    Value {
        /// Its name in a case file.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Range of values allowed.
        expected: &'static str,
    },
    /// A base that no ground shakes like.
    #[error("the acceleration `{name}` of the base has a peak of {}; expected {} at most, a million times gravity", exact(*.peak), exact(*.most))]
    Acceleration {
        /// Its name in a case file.
        name: &'static str,
        /// Its largest magnitude.
        peak: f64,
        /// The largest that is taken.
        most: f64,
    },
    /// A variable load of which nothing is said in time.
    #[error("a load that varies has no history: nothing says how it goes with time")]
    NoHistory {
        /// The load.
        load: LoadId,
    },
    /// Water that is shaken with the body, and presses nobody knows where.
    #[error("{} kg of water move with the body on a base that is shaken, and nothing says how high their push acts", exact(*.mass))]
    WaterWithoutHeight {
        /// The mass, kg, or per metre run.
        mass: f64,
    },
    /// A measured ratio that would give energy to the body.
    #[error(
        "ratio is {}; expected {} at most: with that of the corners' distances from C an impact would give the body energy",
        exact(*.ratio), exact(*.largest)
    )]
    Ratio {
        /// The ratio.
        ratio: f64,
        /// The largest for either direction.
        largest: f64,
    },
    /// A corner that is said to touch, and does not.
    #[error(
        "touching names {}, which is {} off the base in this pose; expected one on it, within 1e-9 of half the base",
        corner.letter(), exact(*.gap)
    )]
    Apart {
        /// The corner.
        corner: Corner,
        /// Its gap.
        gap: f64,
    },
    /// Copies of a motion whose numbers scatter under a name that is none of it.
    #[error("{name} is no number of this motion that differs from copy to copy; expected one of {names}")]
    NoSpread {
        /// The name.
        name: String,
        /// The names of the motion.
        names: String,
    },
    /// A criterion on copies of a motion that has none.
    #[error(
        "overturned_share is that of copies, and none are asked for; expected [motion.copies], or --copies"
    )]
    NoCopies,
    /// A slip of corners that do not touch, or of which nothing is said.
    #[error("slip is that of corners that touch; expected some in `touching`")]
    SlipOfNone,
    /// A body that does not rest under the loads that act before time 0.
    #[error("the body floats: the net load that presses it down before the motion is {}; expected one above zero", exact(*.pressing))]
    Floats {
        /// P.
        pressing: f64,
    },
}
