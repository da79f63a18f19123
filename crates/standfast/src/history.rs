//! Course of a load, or of the acceleration of the ground, in time: pieces that are lines or sines, zero before the first and after the
//! last.

use std::sync::Arc;

use thiserror::Error;

use crate::ball::Scalar;
use crate::number::exact;

/// The fault of one point of a history.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointFault {
    /// Its time is not a finite number.
    Time,
    /// Its value is not a finite number.
    Value,
    /// Its time is not above that before it.
    NotRising,
}

/// A history that cannot be.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum HistoryError {
    /// A number of a shape.
    #[error("{name} is {}; expected {expected}", exact(*.value))]
    Value {
        /// Its name in a case file.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Values that it may have.
        expected: &'static str,
    },
    /// Lists of points that differ in length.
    #[error("{times} times and {values} values; expected as many of each")]
    Lengths {
        /// Times.
        times: usize,
        /// Values.
        values: usize,
    },
    /// Fewer than two points.
    #[error("{count} points; expected two at least")]
    FewPoints {
        /// Number of points.
        count: usize,
    },
    /// A point.
    #[error("point {}: {}", index + 1, words(*fault, *value))]
    Point {
        /// Index of the point, from 0.
        index: usize,
        /// The number.
        value: f64,
        /// Fault of the point.
        fault: PointFault,
    },
}

fn words(fault: PointFault, value: f64) -> String {
    let value = exact(value);
    match fault {
        PointFault::Time => format!("its time is {value}; expected a finite number"),
        PointFault::Value => format!("its value is {value}; expected a finite number"),
        PointFault::NotRising => format!("its time is {value}; expected one after that of the point before"),
    }
}

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
    /// Nothing.
    pub const ZERO: Piece = Piece::Line { value: 0.0, slope: 0.0 };

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
/// use standfast::History;
/// let wave = History::triangle(1.725, 0.0771, 0.231)?;
/// assert_eq!(wave.at(0.0771), 1.725);
/// assert_eq!(wave.at(0.3), 0.0);
/// # Ok::<(), standfast::HistoryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// One more than there are pieces.
    times: Arc<[f64]>,
    pieces: Arc<[Piece]>,
    peak: f64,
}

/// The largest magnitude of pieces that begin and end at these times.
fn peak_of(times: &[f64], pieces: &[Piece]) -> f64 {
    let ends = times.windows(2).zip(pieces).map(|(t, piece)| match piece {
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

/// Times at which many histories have values, checked once.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryTimes {
    times: Arc<[f64]>,
    longest: f64,
}

impl HistoryTimes {
    /// Times that rise.
    ///
    /// # Errors
    /// If there are fewer than two, one is not finite, or they do not rise.
    pub fn new(times: Vec<f64>) -> Result<HistoryTimes, HistoryError> {
        if times.len() < 2 {
            return Err(HistoryError::FewPoints { count: times.len() });
        }
        for (index, t) in times.iter().enumerate() {
            let at = |fault| Err(HistoryError::Point { index, value: *t, fault });
            if !(t.is_finite() && t.abs() < 1e50) {
                return at(PointFault::Time);
            }
            if index > 0 && *t <= times[index - 1] {
                return at(PointFault::NotRising);
            }
        }
        let longest = times.windows(2).fold(0.0, |longest: f64, pair| longest.max(pair[1] - pair[0]));
        Ok(HistoryTimes { times: times.into(), longest })
    }

    /// Times at even steps from 0 on.
    ///
    /// # Errors
    /// If the step is not above zero, or there are fewer than two.
    pub fn even(step: f64, count: usize) -> Result<HistoryTimes, HistoryError> {
        let step = positive("dt", step)?;
        HistoryTimes::new((0..count).map(|i| i as f64 * step).collect())
    }

    /// The times.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The longest step between two of them.
    pub fn longest(&self) -> f64 {
        self.longest
    }
}

fn finite(name: &'static str, value: f64) -> Result<f64, HistoryError> {
    if value.is_finite() && value.abs() < 1e50 {
        Ok(value)
    } else {
        Err(HistoryError::Value { name, value, expected: "a finite number" })
    }
}

fn positive(name: &'static str, value: f64) -> Result<f64, HistoryError> {
    if value > 0.0 && value < 1e50 {
        Ok(value)
    } else {
        Err(HistoryError::Value { name, value, expected: "a number above zero" })
    }
}

impl History {
    fn of(pieces: Vec<(f64, Piece)>, end: f64) -> History {
        let mut times: Vec<f64> = pieces.iter().map(|piece| piece.0).collect();
        times.push(end);
        let pieces: Vec<Piece> = pieces.into_iter().map(|piece| piece.1).collect();
        let peak = peak_of(&times, &pieces);
        History { times: times.into(), pieces: pieces.into(), peak }
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
    pub fn constant(peak: f64) -> Result<History, HistoryError> {
        Ok(History::of(vec![(0.0, Piece::Line { value: finite("peak", peak)?, slope: 0.0 })], f64::INFINITY))
    }

    /// `peak` over `duration`.
    ///
    /// # Errors
    /// If the duration is not above zero, or a number is not finite.
    pub fn rect(peak: f64, duration: f64) -> Result<History, HistoryError> {
        let piece = Piece::Line { value: finite("peak", peak)?, slope: 0.0 };
        Ok(History::of(vec![(0.0, piece)], positive("duration", duration)?))
    }

    /// From 0 to `peak` at `rise`, and back to 0 at `duration`.
    ///
    /// # Errors
    /// As [`History::rect`]; or if not 0 ≤ rise ≤ duration.
    pub fn triangle(peak: f64, rise: f64, duration: f64) -> Result<History, HistoryError> {
        let (peak, duration) = (finite("peak", peak)?, positive("duration", duration)?);
        if !(0.0..=duration).contains(&rise) {
            return Err(HistoryError::Value {
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
    pub fn decay(peak: f64, duration: f64) -> Result<History, HistoryError> {
        History::triangle(peak, 0.0, duration)
    }

    /// Half a sine over `duration`.
    ///
    /// # Errors
    /// As [`History::rect`].
    pub fn half_sine(peak: f64, duration: f64) -> Result<History, HistoryError> {
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
    ) -> Result<History, HistoryError> {
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
    ) -> Result<History, HistoryError> {
        History::triangle(peak, rise, positive("impact_duration", impact_duration)?)?;
        let duration = positive("duration", duration)?;
        if impact_duration > duration {
            let expected = "a time not above the duration";
            return Err(HistoryError::Value { name: "impact_duration", value: impact_duration, expected });
        }
        let share = if peak == 0.0 { if tail == 0.0 { 0.0 } else { f64::NAN } } else { tail / peak };
        if !(0.0..=1.0).contains(&share) {
            return Err(HistoryError::Value {
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
    pub fn points(times: &[f64], values: &[f64]) -> Result<History, HistoryError> {
        if times.len() != values.len() {
            return Err(HistoryError::Lengths { times: times.len(), values: values.len() });
        }
        History::at_times(&HistoryTimes::new(times.to_vec())?, values, 1.0)
    }

    /// Lines between values at times that many histories have, times a factor.
    ///
    /// # Errors
    /// If there are not as many values as times, or one is not finite.
    pub fn at_times(times: &HistoryTimes, values: &[f64], factor: f64) -> Result<History, HistoryError> {
        let times = &times.times;
        if times.len() != values.len() {
            return Err(HistoryError::Lengths { times: times.len(), values: values.len() });
        }
        let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let is_wrong = |value: &f64| !(value.is_finite() && value.abs() < 1e50);
        if let Some(index) = values.iter().position(is_wrong) {
            return Err(HistoryError::Point { index, value: values[index], fault: PointFault::Value });
        }
        let pieces = times.windows(2).zip(values.windows(2)).map(|(t, value)| {
            let slope = (value[1] - value[0]) / (t[1] - t[0]);
            Piece::Line { value: value[0] * factor, slope: slope * factor }
        });
        Ok(History { times: Arc::clone(times), pieces: pieces.collect(), peak: largest * factor.abs() })
    }

    /// Lines between points, each a time and a value; two of one time are a step.
    ///
    /// # Errors
    /// As [`History::points`], but that times may stand still.
    pub fn stepped(points: &[[f64; 2]]) -> Result<History, HistoryError> {
        if points.len() < 2 {
            return Err(HistoryError::FewPoints { count: points.len() });
        }
        for (i, [t, value]) in points.iter().enumerate() {
            let at = |value, fault| Err(HistoryError::Point { index: i, value, fault });
            if !(t.is_finite() && t.abs() < 1e50) {
                return at(*t, PointFault::Time);
            }
            if !(value.is_finite() && value.abs() < 1e50) {
                return at(*value, PointFault::Value);
            }
            if i > 0 && *t < points[i - 1][0] {
                return at(*t, PointFault::NotRising);
            }
        }
        let points: Vec<(f64, f64)> = points.iter().map(|[t, value]| (*t, *value)).collect();
        let history = History::lines(&points);
        if history.pieces.is_empty() { Err(HistoryError::FewPoints { count: 1 }) } else { Ok(history) }
    }

    /// Values `step` apart, the first at time 0, with lines between them.
    ///
    /// # Errors
    /// As [`History::points`]; or if the step is not above zero.
    pub fn samples(step: f64, values: &[f64]) -> Result<History, HistoryError> {
        History::at_times(&HistoryTimes::even(step, values.len())?, values, 1.0)
    }

    /// Pieces that follow each other: when each begins, and when the last ends.
    ///
    /// # Errors
    /// If there is no piece, a number is not finite, or the times do not rise.
    pub fn of_pieces(pieces: &[(f64, Piece)], end: f64) -> Result<History, HistoryError> {
        let history = History::of(pieces.to_vec(), end);
        if pieces.is_empty() {
            return Err(HistoryError::FewPoints { count: 0 });
        }
        for (i, pair) in history.times.windows(2).enumerate() {
            if !(pair[0].is_finite() && pair[0] < pair[1]) {
                return Err(HistoryError::Point {
                    index: i + 1,
                    value: pair[1],
                    fault: PointFault::NotRising,
                });
            }
        }
        for piece in &*history.pieces {
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

    /// History that begins `start` later.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn starting(self, start: f64) -> Result<History, HistoryError> {
        match finite("start", start)? {
            0.0 => Ok(self),
            start => Ok(History { times: self.times.iter().map(|t| t + start).collect(), ..self }),
        }
    }

    /// History times a factor.
    #[must_use]
    pub fn times_factor(self, factor: f64) -> History {
        if factor == 1.0 {
            return self;
        }
        let scaled = |piece: &Piece| match *piece {
            Piece::Line { value, slope } => Piece::Line { value: value * factor, slope: slope * factor },
            Piece::Sine { peak, angular_frequency, phase } => {
                Piece::Sine { peak: peak * factor, angular_frequency, phase }
            }
        };
        History { pieces: self.pieces.iter().map(scaled).collect(), peak: self.peak * factor.abs(), ..self }
    }

    /// Moments at which pieces begin, and at which the last ends.
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
        self.peak
    }

    /// Moments and values between which it is a line, two of one moment where it jumps, from the first piece to what is left after
    /// the last; `None` of one with sines.
    pub fn corners(&self) -> Option<Vec<[f64; 2]>> {
        let mut corners: Vec<[f64; 2]> = Vec::with_capacity(2 * self.pieces.len() + 1);
        for (t, piece) in self.times.windows(2).zip(&*self.pieces) {
            let Piece::Line { value, slope } = *piece else { return None };
            // A step of rounding alone is none.
            if corners.last().is_none_or(|last| last[0] != t[0] || last[1].plus(-value) != 0.0) {
                corners.push([t[0], value]);
            }
            if t[1].is_finite() {
                corners.push([t[1], if slope == 0.0 { value } else { value.plus(slope * (t[1] - t[0])) }]);
            }
        }
        let last = corners.last().copied().filter(|last| last[1] != 0.0 && last[0] == self.end());
        corners.extend(last.map(|[t, _]| [t, 0.0]));
        Some(corners)
    }

    /// Moment at which the last piece ends; infinite of one without end.
    pub fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// Jumps and bends, moment by moment: the history is the sum of what they add from there on; `None` of one with sines.
    pub fn changes(&self) -> Option<Vec<HistoryChange>> {
        let corners = self.corners()?;
        let Some(&[first, value]) = corners.first() else { return Some(Vec::new()) };
        let mut changes = vec![HistoryChange { at: first, step: value, slope: 0.0 }];
        let mut slope = 0.0;
        for pair in corners.windows(2) {
            let ([from, low], [to, high]) = (pair[0], pair[1]);
            if to == from {
                changes.push(HistoryChange { at: to, step: high - low, slope: 0.0 });
                continue;
            }
            let next = high.plus(-low) / (to - from);
            changes.push(HistoryChange { at: from, step: 0.0, slope: next.plus(-slope) });
            slope = next;
        }
        let last = corners[corners.len() - 1][0];
        changes.push(HistoryChange { at: last, step: 0.0, slope: -slope });
        Some(changes)
    }

    /// True if it jumps at a moment, by more than rounding.
    pub fn jumps_at(&self, t: f64) -> bool {
        let (before, after) = (self.before(t), self.at(t));
        (after - before).abs() > 1e-12 * self.size_near(t)
    }

    /// True if it is the same one in memory, or a clone of it: equal without a look at its pieces.
    pub fn is_same(&self, other: &History) -> bool {
        Arc::ptr_eq(&self.times, &other.times) && Arc::ptr_eq(&self.pieces, &other.pieces)
    }

    /// The moments at which it jumps, rising.
    pub fn jumps(&self) -> impl Iterator<Item = f64> {
        let times = &self.times;
        let is_jump = |i: &usize| {
            let before = i.checked_sub(1).map_or(0.0, |last| self.pieces[last].at(times[*i] - times[last]));
            let after = self.pieces.get(*i).map_or(0.0, |piece| piece.at(0.0));
            before != after && (after - before).abs() > 1e-12 * self.size_beside(*i)
        };
        (0..times.len()).filter(is_jump).map(|i| times[i])
    }

    /// The size of the pieces on both sides of a moment.
    fn size_near(&self, t: f64) -> f64 {
        self.size_beside(self.times.partition_point(|time| *time < t))
    }

    /// The size of the pieces before and from a place on.
    fn size_beside(&self, i: usize) -> f64 {
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

/// Change that is added to a history from a moment on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryChange {
    /// The moment, s.
    pub at: f64,
    /// Step that is added at once.
    pub step: f64,
    /// Slope that is added, 1/s.
    pub slope: f64,
}
