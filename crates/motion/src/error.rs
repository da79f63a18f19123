//! What is wrong with a problem or a history.

use standfast::InputError;
use standfast::number::exact;
use thiserror::Error;

/// What is wrong with a point of a history.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Problematic {
    /// Its time is not a finite number.
    Time,
    /// Its value is not a finite number.
    Value,
    /// Its time is not above that before it.
    NotRising,
}

/// Why a motion cannot be followed.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number of the contact problem.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A number of a history or of the motion.
    #[error("{name} is {}; expected {expected}", exact(*.value))]
    Value {
        /// Its name in a case file.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be.
        expected: &'static str,
    },
    /// A history of points whose lists differ in length.
    #[error("{times} times and {values} values; expected as many of each")]
    Lengths {
        /// Times.
        times: usize,
        /// Values.
        values: usize,
    },
    /// A history of fewer than two points.
    #[error("{count} points; expected two at least")]
    FewPoints {
        /// How many there are.
        count: usize,
    },
    /// A point of a history.
    #[error("point {}: {}", index + 1, words(*problem, *value))]
    Point {
        /// Which point, from 0.
        index: usize,
        /// The number.
        value: f64,
        /// What is wrong with it.
        problem: Problematic,
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
    /// A body that does not rest under the loads that act before time 0.
    #[error("the body floats: the net load that presses it down before the motion is {}; expected one above zero", exact(*.pressing))]
    Floats {
        /// P.
        pressing: f64,
    },
}

fn words(problem: Problematic, value: f64) -> String {
    let value = exact(value);
    match problem {
        Problematic::Time => format!("its time is {value}; expected a finite number"),
        Problematic::Value => format!("its value is {value}; expected a finite number"),
        Problematic::NotRising => format!("its time is {value}; expected one after that of the point before"),
    }
}
