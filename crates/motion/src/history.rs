//! How a load or the ground's acceleration goes with time: pieces that are lines or sines, zero before the first and after the last.

use crate::error::{MotionError, Problematic};

/// A piece, over the time since it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// `value` + `slope` τ.
    Line {
        /// At its beginning.
        value: f64,
        /// Per time.
        slope: f64,
    },
    /// `peak` sin(`angular_frequency` τ + `phase`).
    Sine {
        /// The amplitude.
        peak: f64,
        /// In rad per time.
        angular_frequency: f64,
        /// At its beginning, rad.
        phase: f64,
    },
}

impl Piece {
    pub(crate) const ZERO: Piece = Piece::Line { value: 0.0, slope: 0.0 };

    /// Its value τ after its beginning.
    pub fn at(&self, τ: f64) -> f64 {
        match *self {
            Piece::Line { slope: 0.0, value } => value,
            Piece::Line { value, slope } => value + slope * τ,
            Piece::Sine { peak, angular_frequency, phase } => peak * (angular_frequency * τ + phase).sin(),
        }
    }
}

/// A function of time, made of pieces that follow each other.
///
/// ```
/// use standfast_motion::History;
/// let wave = History::triangle(1.725, 0.0771, 0.231)?;
/// assert_eq!(wave.at(0.0771), 1.725);
/// assert_eq!(wave.at(0.3), 0.0);
/// # Ok::<(), standfast_motion::MotionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// One more than there are pieces.
    times: Vec<f64>,
    pieces: Vec<Piece>,
}

fn finite(name: &'static str, value: f64) -> Result<f64, MotionError> {
    if value.is_finite() && value.abs() < 1e50 {
        Ok(value)
    } else {
        Err(MotionError::Value { name, value, expected: "a finite number" })
    }
}

fn positive(name: &'static str, value: f64) -> Result<f64, MotionError> {
    if value > 0.0 && value < 1e50 {
        Ok(value)
    } else {
        Err(MotionError::Value { name, value, expected: "a number above zero" })
    }
}

impl History {
    fn of(pieces: Vec<(f64, Piece)>, end: f64) -> History {
        let mut times: Vec<f64> = pieces.iter().map(|piece| piece.0).collect();
        times.push(end);
        History { times, pieces: pieces.into_iter().map(|piece| piece.1).collect() }
    }

    fn lines(points: &[(f64, f64)]) -> History {
        let pieces = points.windows(2).filter(|pair| pair[1].0 > pair[0].0);
        let pieces = pieces.map(|pair| {
            let [(t, value), (end, next)] = [pair[0], pair[1]];
            (t, Piece::Line { value, slope: (next - value) / (end - t) })
        });
        History::of(pieces.collect(), points.last().map_or(0.0, |last| last.0))
    }

    /// `peak` from time 0 on, without end.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn constant(peak: f64) -> Result<History, MotionError> {
        Ok(History::of(vec![(0.0, Piece::Line { value: finite("peak", peak)?, slope: 0.0 })], f64::INFINITY))
    }

    /// `peak` over `duration`.
    ///
    /// # Errors
    /// If the duration is not above zero, or a number is not finite.
    pub fn rect(peak: f64, duration: f64) -> Result<History, MotionError> {
        let piece = Piece::Line { value: finite("peak", peak)?, slope: 0.0 };
        Ok(History::of(vec![(0.0, piece)], positive("duration", duration)?))
    }

    /// From 0 to `peak` at `rise`, and back to 0 at `duration`.
    ///
    /// # Errors
    /// As [`History::rect`]; or if not 0 ≤ rise ≤ duration.
    pub fn triangle(peak: f64, rise: f64, duration: f64) -> Result<History, MotionError> {
        let (peak, duration) = (finite("peak", peak)?, positive("duration", duration)?);
        if !(0.0..=duration).contains(&rise) {
            return Err(MotionError::Value {
                name: "rise",
                value: rise,
                expected: "a time from zero to the duration",
            });
        }
        Ok(History::lines(&[(0.0, 0.0), (rise, peak), (duration, 0.0)]))
    }

    /// From `peak` at once, along a line to 0 at `duration`.
    ///
    /// # Errors
    /// As [`History::rect`].
    pub fn decay(peak: f64, duration: f64) -> Result<History, MotionError> {
        History::triangle(peak, 0.0, duration)
    }

    /// Half a sine over `duration`.
    ///
    /// # Errors
    /// As [`History::rect`].
    pub fn half_sine(peak: f64, duration: f64) -> Result<History, MotionError> {
        let duration = positive("duration", duration)?;
        History::sine(peak, std::f64::consts::PI / duration, 0.0, duration)
    }

    /// `peak` sin(`angular_frequency` t + `phase`) over `duration`.
    ///
    /// # Errors
    /// As [`History::rect`]; or if the angular frequency is not above zero.
    pub fn sine(
        peak: f64,
        angular_frequency: f64,
        phase: f64,
        duration: f64,
    ) -> Result<History, MotionError> {
        let angular_frequency = positive("angular_frequency", angular_frequency)?;
        let piece =
            Piece::Sine { peak: finite("peak", peak)?, angular_frequency, phase: finite("phase", phase)? };
        Ok(History::of(vec![(0.0, piece)], positive("duration", duration)?))
    }

    /// A breaking wave: a triangle from 0 to `peak` at `rise` and to 0 at `impact_duration`, but never below the `tail`, which ends at
    /// `duration`.
    ///
    /// # Errors
    /// As [`History::triangle`]; if the tail is not between 0 and the peak, or the impact outlasts the duration.
    pub fn church_roof(
        peak: f64,
        rise: f64,
        impact_duration: f64,
        tail: f64,
        duration: f64,
    ) -> Result<History, MotionError> {
        History::triangle(peak, rise, positive("impact_duration", impact_duration)?)?;
        let duration = positive("duration", duration)?;
        if impact_duration > duration {
            let expected = "a time not above the duration";
            return Err(MotionError::Value { name: "impact_duration", value: impact_duration, expected });
        }
        let share = if peak == 0.0 { if tail == 0.0 { 0.0 } else { f64::NAN } } else { tail / peak };
        if !(0.0..=1.0).contains(&share) {
            return Err(MotionError::Value {
                name: "tail",
                value: tail,
                expected: "a number between zero and the peak",
            });
        }
        let fall = impact_duration - (impact_duration - rise) * share;
        Ok(History::lines(&[(0.0, tail), (rise * share, tail), (rise, peak), (fall, tail), (duration, tail)]))
    }

    /// Lines between points.
    ///
    /// # Errors
    /// If there are fewer than two points, not as many times as values, a number is not finite, or the times do not rise.
    pub fn points(times: &[f64], values: &[f64]) -> Result<History, MotionError> {
        if times.len() != values.len() {
            return Err(MotionError::Lengths { times: times.len(), values: values.len() });
        }
        if times.len() < 2 {
            return Err(MotionError::FewPoints { count: times.len() });
        }
        for (i, (t, value)) in times.iter().zip(values).enumerate() {
            let at = |value, problem| Err(MotionError::Point { index: i, value, problem });
            if !(t.is_finite() && t.abs() < 1e50) {
                return at(*t, Problematic::Time);
            }
            if !(value.is_finite() && value.abs() < 1e50) {
                return at(*value, Problematic::Value);
            }
            if i > 0 && *t <= times[i - 1] {
                return at(*t, Problematic::NotRising);
            }
        }
        let pieces = times.windows(2).zip(values.windows(2)).map(|(t, value)| {
            (t[0], Piece::Line { value: value[0], slope: (value[1] - value[0]) / (t[1] - t[0]) })
        });
        Ok(History::of(pieces.collect(), times[times.len() - 1]))
    }

    /// Values `step` apart, the first at time 0, with lines between them.
    ///
    /// # Errors
    /// As [`History::points`]; or if the step is not above zero.
    pub fn samples(step: f64, values: &[f64]) -> Result<History, MotionError> {
        let step = positive("dt", step)?;
        let times: Vec<f64> = (0..values.len()).map(|i| i as f64 * step).collect();
        History::points(&times, values)
    }

    /// Pieces that follow each other: when each begins, and when the last ends.
    ///
    /// # Errors
    /// If there is no piece, a number is not finite, or the times do not rise.
    pub fn of_pieces(pieces: &[(f64, Piece)], end: f64) -> Result<History, MotionError> {
        let history = History::of(pieces.to_vec(), end);
        if pieces.is_empty() {
            return Err(MotionError::FewPoints { count: 0 });
        }
        for (i, pair) in history.times.windows(2).enumerate() {
            if !(pair[0].is_finite() && pair[0] < pair[1]) {
                return Err(MotionError::Point {
                    index: i + 1,
                    value: pair[1],
                    problem: Problematic::NotRising,
                });
            }
        }
        for piece in &history.pieces {
            match *piece {
                Piece::Line { value, slope } => {
                    finite("value", value)?;
                    finite("slope", slope)?;
                }
                Piece::Sine { peak, angular_frequency, phase } => {
                    finite("peak", peak)?;
                    positive("angular_frequency", angular_frequency)?;
                    finite("phase", phase)?;
                }
            }
        }
        Ok(history)
    }

    /// The same, `start` later.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn starting(mut self, start: f64) -> Result<History, MotionError> {
        let start = finite("start", start)?;
        self.times.iter_mut().for_each(|t| *t += start);
        Ok(self)
    }

    /// The same times a factor.
    #[must_use]
    pub fn times_factor(mut self, factor: f64) -> History {
        for piece in &mut self.pieces {
            match piece {
                Piece::Line { value, slope } => {
                    *value *= factor;
                    *slope *= factor;
                }
                Piece::Sine { peak, .. } => *peak *= factor,
            }
        }
        self
    }

    /// When pieces begin, and when the last ends.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Its value at a moment; at a jump that after it.
    pub fn at(&self, t: f64) -> f64 {
        let i = self.times.partition_point(|time| *time <= t);
        if i == 0 || i == self.times.len() { 0.0 } else { self.pieces[i - 1].at(t - self.times[i - 1]) }
    }

    /// Its value just before a moment.
    pub fn before(&self, t: f64) -> f64 {
        let i = self.times.partition_point(|time| *time < t);
        if i == 0 || i == self.times.len() { 0.0 } else { self.pieces[i - 1].at(t - self.times[i - 1]) }
    }

    /// The largest magnitude at the ends of pieces and at crests of sines.
    pub fn peak(&self) -> f64 {
        let ends = self.times.windows(2).zip(&self.pieces).map(|(t, piece)| match piece {
            Piece::Sine { peak, angular_frequency, phase } => {
                let turns = |angle: f64| ((angle / std::f64::consts::PI) - 0.5).floor();
                let last = phase + angular_frequency * (t[1] - t[0]);
                if turns(last) > turns(*phase) {
                    peak.abs()
                } else {
                    piece.at(0.0).abs().max(piece.at(t[1] - t[0]).abs())
                }
            }
            Piece::Line { slope: 0.0, value } => value.abs(),
            Piece::Line { .. } => piece.at(0.0).abs().max(piece.at(t[1] - t[0]).abs()),
        });
        ends.fold(0.0, f64::max)
    }

    /// Whether it jumps at a moment, by more than rounding.
    pub(crate) fn jumps_at(&self, t: f64) -> bool {
        let (before, after) = (self.before(t), self.at(t));
        (after - before).abs() > 1e-12 * self.size_near(t)
    }

    /// The size of the pieces on both sides of a moment.
    fn size_near(&self, t: f64) -> f64 {
        let i = self.times.partition_point(|time| *time < t);
        let size = |i: usize| match self.pieces.get(i) {
            Some(Piece::Sine { peak, .. }) => peak.abs(),
            Some(piece @ Piece::Line { value, slope }) => {
                let length = self.times[i + 1] - self.times[i];
                if *slope == 0.0 { value.abs() } else { value.abs().max(piece.at(length).abs()) }
            }
            None => 0.0,
        };
        size(i).max(if i > 0 { size(i - 1) } else { 0.0 })
    }
}
