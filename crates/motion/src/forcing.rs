//! Loads and base motion over the pieces of time in which all of them are lines or sines.

use std::cell::RefCell;
use std::rc::Rc;

use crate::problem::{BaseMotion, MotionProblem};
use crate::series::{LEN, Series};
use standfast::history::{History, Piece};

/// Share of a history in X, P or M; fixed, times cosθ or times sinθ.
#[derive(Debug, Clone, Copy)]
struct Share {
    history: usize,
    to: [usize; 2],
    factor: f64,
}

/// Everything that acts, cut at every moment at which anything changes its law.
#[derive(Debug, Clone)]
pub(crate) struct Forcing {
    /// Moments after 0 at which a piece ends and another begins.
    pub breaks: Vec<f64>,
    /// True at the breaks where something jumps.
    pub jumps: Vec<bool>,
    /// Of each history, the pieces between the breaks, one more than there are breaks.
    pieces: Vec<Vec<Local>>,
    shares: Vec<Share>,
    turn: bool,
    gravity: f64,
    /// P of the weight and the loads that act without end.
    pub pressing: f64,
}

/// A history between two breaks, over the time since the first.
#[derive(Debug, Clone, Copy)]
enum Local {
    Line { value: f64, slope: f64 },
    Sine { peak: f64, ω: f64, phase: f64 },
}

/// X, P, M as series of time: fixed parts, parts times cosθ, parts times sinθ.
#[derive(Debug, Clone)]
pub(crate) struct Channels {
    pub series: [[Series; 3]; 3],
    pub turn: bool,
    /// True if nothing is a sine.
    linear: bool,
    /// The fastest sine.
    pub fastest: f64,
}

impl Channels {
    pub(crate) const EMPTY: Channels =
        Channels { series: [[[0.0; LEN]; 3]; 3], turn: false, linear: true, fastest: 0.0 };

    /// The highest power of a wrench that acts on a body that turns, for an order n.
    #[inline]
    pub(crate) fn degree(&self, n: usize) -> usize {
        if self.turn { n } else { self.degree_flat(n) }
    }

    /// Highest power of a wrench that acts on a body that does not turn.
    #[inline]
    pub(crate) fn degree_flat(&self, n: usize) -> usize {
        if self.linear { 1 } else { n }
    }

    #[inline]
    pub(crate) fn fixed(&self, wrench: &mut [Series; 3]) {
        for (total, [fixed, ..]) in wrench.iter_mut().zip(&self.series) {
            *total = *fixed;
        }
    }

    /// X, P, M at the start of the series.
    pub(crate) fn wrench(&self, θ: f64) -> [f64; 3] {
        let (sin, cos) = θ.sin_cos();
        self.series.each_ref().map(|[fixed, c, s]| fixed[0] + c[0] * cos + s[0] * sin)
    }
}

/// X, P and M of a piece in which all of them are lines and keep their directions: at a moment, and their slopes.
pub(crate) type Lines = [[f64; 2]; 3];

thread_local! {
    /// The shaking of the last motion, where nothing but the base moved: many bodies follow each other under one record.
    static LAST: RefCell<Option<(BaseMotion, f64, Rc<Forcing>)>> = const { RefCell::new(None) };
}

impl Forcing {
    /// That of a problem; of one that has the same shaking as the problem before, and no loads, it is the same one.
    pub(crate) fn of(problem: &MotionProblem) -> Rc<Forcing> {
        if !problem.loads.is_empty() {
            return Rc::new(Forcing::new(problem));
        }
        let same = |one: &Option<History>, other: &Option<History>| match (one, other) {
            (Some(one), Some(other)) => one.is_same(other),
            (one, other) => one.is_none() && other.is_none(),
        };
        LAST.with_borrow_mut(|last| {
            if let Some((base, gravity, forcing)) = last
                && *gravity == problem.gravity
                && same(&base.horizontal, &problem.base.horizontal)
                && same(&base.vertical, &problem.base.vertical)
            {
                return forcing.clone();
            }
            let forcing = Rc::new(Forcing::new(problem));
            *last = Some((problem.base.clone(), problem.gravity, forcing.clone()));
            forcing
        })
    }

    /// The lines from t on in a piece; `None` where something is a sine, or turns with the body.
    #[inline]
    pub(crate) fn lines(&self, segment: usize, t: f64) -> Option<Lines> {
        if self.turn {
            return None;
        }
        let τ = t - self.start(segment);
        let mut lines = [[0.0; 2], [self.gravity, 0.0], [0.0; 2]];
        for share in &self.shares {
            let Local::Line { value, slope } = self.pieces[share.history][segment] else { return None };
            let line = &mut lines[share.to[0]];
            line[0] += share.factor * (value + slope * τ);
            line[1] += share.factor * slope;
        }
        Some(lines)
    }

    pub(crate) fn new(problem: &MotionProblem) -> Forcing {
        let mut histories: Vec<&History> = Vec::new();
        let mut shares: Vec<Share> = Vec::new();
        let mut add = |history: usize, to: [usize; 2], factor: f64| {
            if factor != 0.0 {
                shares.push(Share { history, to, factor });
            }
        };
        for load in &problem.loads {
            let ([px, py], [ux, uy]) = (load.at, load.direction);
            let (moment, quarter) = (px * uy - py * ux, -(px * ux + py * uy));
            let i = histories.len();
            histories.push(&load.history);
            if load.follows {
                // R(θ)u: (ux cosθ − uy sinθ, ux sinθ + uy cosθ)
                for (to, factor) in
                    [([0, 1], ux), ([0, 2], -uy), ([1, 1], -uy), ([1, 2], -ux), ([2, 0], moment)]
                {
                    add(i, to, factor);
                }
            } else {
                // r × u with r = R(θ)p
                for (to, factor) in [([0, 0], ux), ([1, 0], -uy), ([2, 1], moment), ([2, 2], quarter)] {
                    add(i, to, factor);
                }
            }
        }
        for (history, to, factor) in
            [(&problem.base.horizontal, [0, 0], -1.0), (&problem.base.vertical, [1, 0], 1.0)]
        {
            if let Some(history) = history {
                add(histories.len(), to, factor);
                histories.push(history);
            }
        }
        // Each is in order; the pieces without end and before the beginning part nothing.
        let mut breaks: Vec<f64> =
            Vec::with_capacity(histories.iter().map(|history| history.times().len()).sum());
        for history in &histories {
            let times = history.times();
            let (from, to) = (times.partition_point(|t| *t <= 0.0), times.partition_point(|t| t.is_finite()));
            breaks.extend_from_slice(&times[from.min(to)..to]);
        }
        if histories.len() > 1 {
            breaks.sort_by(f64::total_cmp);
        }
        breaks.dedup();
        let pieces: Vec<Vec<Local>> = histories.iter().map(|history| localised(history, &breaks)).collect();
        let mut jumps = vec![false; breaks.len()];
        for t in histories.iter().flat_map(|history| history.jumps()) {
            if let Ok(place) = breaks.binary_search_by(|other| other.total_cmp(&t)) {
                jumps[place] = true;
            }
        }
        let turn = shares.iter().any(|share| share.to[1] != 0);
        let permanent = problem.loads.iter().filter(|load| load.history.end() == f64::INFINITY);
        let pressing =
            problem.gravity - permanent.map(|load| load.direction[1] * load.history.at(0.0)).sum::<f64>();
        Forcing { breaks, jumps, pieces, shares, turn, gravity: problem.gravity, pressing }
    }

    /// The last moment at which anything changes its law; 0 if nothing ever does.
    pub(crate) fn end(&self) -> f64 {
        self.breaks.last().copied().unwrap_or(0.0)
    }

    /// Beginning of a piece between breaks.
    #[inline]
    pub(crate) fn start(&self, segment: usize) -> f64 {
        if segment == 0 { 0.0 } else { self.breaks[segment - 1] }
    }

    /// End of a piece between breaks; infinite for the last.
    #[inline]
    pub(crate) fn stop(&self, segment: usize) -> f64 {
        self.breaks.get(segment).copied().unwrap_or(f64::INFINITY)
    }

    /// The series of everything at t in a piece, to the order n.
    pub(crate) fn channels(&self, segment: usize, t: f64, n: usize, channels: &mut Channels) {
        let τ = t - self.start(segment);
        (channels.turn, channels.linear, channels.fastest) = (self.turn, true, 0.0);
        // Of a line the two first coefficients; what sines left above them is swept below.
        let sines =
            self.shares.iter().any(|share| matches!(self.pieces[share.history][segment], Local::Sine { .. }));
        let kinds = if self.turn { 3 } else { 1 };
        for row in &mut channels.series {
            for series in &mut row[..kinds] {
                series.fill(0.0);
            }
        }
        channels.series[1][0][0] = self.gravity;
        for share in &self.shares {
            let [i, j] = share.to;
            let series = &mut channels.series[i][j];
            match self.pieces[share.history][segment] {
                Local::Line { value, slope } => {
                    series[0] += share.factor * (value + slope * τ);
                    series[1] += share.factor * slope;
                }
                Local::Sine { peak, ω, phase } => {
                    let (sin, cos) = (ω * τ + phase).sin_cos();
                    let mut factor = share.factor * peak;
                    // Derivatives of sin: sin, cos, −sin, −cos.
                    for (k, value) in [sin, cos, -sin, -cos].iter().cycle().take(n + 1).enumerate() {
                        series[k] += factor * value;
                        factor *= ω / (k + 1) as f64;
                    }
                    channels.fastest = channels.fastest.max(ω);
                }
            }
        }
        channels.linear = !sines;
    }
}

/// A history between breaks that include all of its own.
fn localised(history: &History, breaks: &[f64]) -> Vec<Local> {
    let mut found = Vec::with_capacity(breaks.len() + 1);
    let times = history.times();
    let mut i = 0; // times[i] is the first moment of the history after the start of the piece
    for start in std::iter::once(0.0).chain(breaks.iter().copied()) {
        while i < times.len() && times[i] <= start {
            i += 1;
        }
        let piece = if i == 0 || i == times.len() { Piece::ZERO } else { history.pieces()[i - 1] };
        let τ = if i == 0 { 0.0 } else { start - times[i - 1] };
        found.push(match piece {
            Piece::Line { value, slope } => {
                Local::Line { value: if slope == 0.0 { value } else { value + slope * τ }, slope }
            }
            Piece::Sine { peak, angular_frequency: ω, phase } => {
                Local::Sine { peak, ω, phase: phase + ω * τ }
            }
        });
    }
    found
}
