//! How a load varies in time, as a case file gives it: a shape in straight lines.

use standfast::InputError;
use standfast::ground::impact;

/// A load over time, zero before it begins and after its last moment; shares of the load's own size. What `simulate` reads under the same
/// key has the same course.
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
    /// A triangle that is never below a tail.
    ChurchRoof {
        /// When it is largest.
        rise: f64,
        /// When the triangle would be gone.
        impact_duration: f64,
        /// What the load is at least, from zero to the peak; not multiplied by that.
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

    /// Moments and shares of the peak.
    fn points(&self, peak: f64) -> Vec<[f64; 2]> {
        match *self {
            Course::Constant => vec![[0.0, 1.0]],
            Course::Rect { duration } => vec![[0.0, 1.0], [duration, 1.0], [duration, 0.0]],
            Course::Triangle { rise, duration } => vec![[0.0, 0.0], [rise, 1.0], [duration, 0.0]],
            Course::Decay { duration } => vec![[0.0, 1.0], [duration, 0.0]],
            Course::ChurchRoof { rise, impact_duration, tail, duration } => {
                let tail = if peak == 0.0 { 0.0 } else { tail / peak };
                vec![
                    [0.0, tail],
                    [rise * tail, tail],
                    [rise, 1.0],
                    [impact_duration - tail * (impact_duration - rise), tail],
                    [duration, tail],
                    [duration, 0.0],
                ]
            }
            Course::Points { ref points } => {
                let last = points.last().filter(|[_, share]| *share != 0.0);
                points.iter().copied().chain(last.map(|[t, _]| [*t, 0.0])).collect()
            }
        }
    }
}

impl TimeShape {
    /// The history that the mechanics takes.
    ///
    /// # Errors
    /// If moments do not rise or are before zero.
    pub fn history(&self) -> Result<impact::History, InputError> {
        let points = self.course.points(self.peak);
        let points: Vec<_> = points.iter().map(|[t, share]| [t + self.start, share * self.peak]).collect();
        impact::History::new(&points)
    }
}

#[cfg(test)]
mod tests {
    use standfast_motion::History;

    use super::*;

    /// `simulate` reads a history under the same key: at each moment both are the same, before, in, between and after the points.
    #[test]
    fn a_course_is_that_of_the_motion_in_time() {
        let points = vec![[0.02, 0.3], [0.05, 1.2], [0.11, 0.4]];
        let times: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let values: Vec<f64> = points.iter().map(|point| point[1]).collect();
        for peak in [1.0, 2.5, -1.5] {
            let tail = 0.4 * peak;
            let courses = [
                (Course::Constant, History::constant(peak)),
                (Course::Rect { duration: 0.1 }, History::rect(peak, 0.1)),
                (Course::Triangle { rise: 0.03, duration: 0.1 }, History::triangle(peak, 0.03, 0.1)),
                (Course::Triangle { rise: 0.0, duration: 0.1 }, History::triangle(peak, 0.0, 0.1)),
                (Course::Decay { duration: 0.1 }, History::decay(peak, 0.1)),
                (
                    Course::ChurchRoof { rise: 0.03, impact_duration: 0.08, tail, duration: 0.15 },
                    History::church_roof(peak, 0.03, 0.08, tail, 0.15),
                ),
                (
                    Course::Points { points: points.clone() },
                    History::points(&times, &values).map(|history| history.times_factor(peak)),
                ),
            ];
            for (course, motion) in courses {
                let motion = motion.and_then(|history| history.starting(0.01)).unwrap();
                let ours = TimeShape { course, peak, start: 0.01 };
                let history = ours.history().unwrap();
                for i in 0..400 {
                    let t = 0.0005 * f64::from(i) + 0.0001;
                    let (one, other) = (history.at(t), motion.at(t));
                    assert!((one - other).abs() < 1e-12, "{ours:?} at {t}: {one} {other}");
                }
            }
        }
    }
}
