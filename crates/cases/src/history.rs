//! How a load varies in time, as a case file gives it: a shape in straight lines.

use standfast::InputError;
use standfast::ground::impact;

/// A load over time, from zero before it begins; shares of the load's own size.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeShape {
    /// Its course.
    pub course: Course,
    /// What all of it is multiplied by.
    pub peak: f64,
    /// When it begins, s.
    pub start: f64,
}

/// The course of a load in time; moments count from its start, s.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Course {
    /// It comes at once and stays.
    Constant,
    /// It comes at once, stays, and is gone at once.
    Rect {
        /// When it is gone.
        duration: f64,
    },
    /// It rises and falls.
    Triangle {
        /// When it is largest.
        rise: f64,
        /// When it is gone.
        duration: f64,
    },
    /// It comes at once and falls.
    Decay {
        /// When it is gone.
        duration: f64,
    },
    /// A triangle that never falls below a tail.
    ChurchRoof {
        /// When it is largest.
        rise: f64,
        /// When the triangle would be gone.
        impact_duration: f64,
        /// The share that stays.
        tail: f64,
        /// When all of it is gone.
        duration: f64,
    },
    /// Straight lines between moments.
    Points {
        /// Moments and shares.
        points: Vec<[f64; 2]>,
    },
}

impl Course {
    /// The names of the courses in a file, and what each takes beside `peak` and `start`.
    pub const NAMES: [(&'static str, &'static [&'static str]); 6] = [
        ("constant", &[]),
        ("rect", &["duration"]),
        ("triangle", &["rise", "duration"]),
        ("decay", &["duration"]),
        ("church-roof", &["rise", "impact_duration", "tail", "duration"]),
        ("points", &["times", "values"]),
    ];

    /// Its name in a file.
    pub fn name(&self) -> &'static str {
        let place = match self {
            Course::Constant => 0,
            Course::Rect { .. } => 1,
            Course::Triangle { .. } => 2,
            Course::Decay { .. } => 3,
            Course::ChurchRoof { .. } => 4,
            Course::Points { .. } => 5,
        };
        Course::NAMES[place].0
    }

    /// Moments and shares.
    fn points(&self) -> Vec<[f64; 2]> {
        match *self {
            Course::Constant => vec![[0.0, 1.0]],
            Course::Rect { duration } => vec![[0.0, 1.0], [duration, 1.0], [duration, 0.0]],
            Course::Triangle { rise, duration } => vec![[0.0, 0.0], [rise, 1.0], [duration, 0.0]],
            Course::Decay { duration } => vec![[0.0, 1.0], [duration, 0.0]],
            Course::ChurchRoof { rise, impact_duration, tail, duration } => vec![
                [0.0, 0.0],
                [rise, 1.0],
                [impact_duration - tail * (impact_duration - rise), tail],
                [duration, tail],
                [duration, 0.0],
            ],
            Course::Points { ref points } => points.clone(),
        }
    }
}

impl TimeShape {
    /// The history that the mechanics takes.
    ///
    /// # Errors
    /// If moments do not rise or are before zero.
    pub fn history(&self) -> Result<impact::History, InputError> {
        let points = self.course.points();
        let points: Vec<_> = points.iter().map(|[t, share]| [t + self.start, share * self.peak]).collect();
        impact::History::new(&points)
    }
}
