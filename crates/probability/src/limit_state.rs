//! Limit states that are functions of the inputs: how likely is it that the function is below zero?
//!
//! Along one input the function is looked at in 192 steps of the input's law, an eighth of a standard normal each, and where its sign changes the root is found, also
//! where it only dips below zero between two steps, if it is smooth there. What else lies within one step is missed. So the methods of this crate have what they need, and published problems can be put
//! to them.
//!
//! ```
//! use standfast_probability::law::Law;
//! use standfast_probability::limit_state::{Asked, reliability};
//! use standfast_probability::problem::RandomVector;
//!
//! // A resistance less a load.
//! let inputs = RandomVector::independent(vec![Law::normal(0.6, 0.06)?.into(), Law::normal(0.3, 0.08)?.into()]);
//! let found = reliability(&inputs, &|x: &[f64]| x[0] - x[1], &Asked::default())?;
//! assert!((found.below_zero.value - 0.001349898).abs() < 1e-9); // Φ(−3)
//! assert!((found.design_points[0].beta - 3.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::borrow::Cow;
use std::sync::Mutex;

use standfast_watch::Portion;
use thiserror::Error;

use crate::form::{FormPoint, apart, boundary_points};
use crate::law::Distribution;
use crate::method::{Found, Method, by, by_known};
use crate::problem::{Outcomes, Pieces, RandomVector, scanned};
use crate::roots::Crossing;
use crate::sample::{Effort, Estimate};

/// A function of inputs, below zero where what is asked for happens. Any function of a list of values is one.
pub trait LimitFunction: Sync {
    /// The function at several points: of each input a column of its values, all of one length.
    fn each(&self, columns: &[Vec<f64>], found: &mut [f64]);
}

impl<F: Fn(&[f64]) -> f64 + Sync> LimitFunction for F {
    fn each(&self, columns: &[Vec<f64>], found: &mut [f64]) {
        let mut values = vec![0.0; columns.len()];
        for (row, found) in found.iter_mut().enumerate() {
            values.iter_mut().zip(columns).for_each(|(value, column)| *value = column[row]);
            *found = self(&values);
        }
    }
}

/// How a probability is asked for.
#[derive(Clone, Copy)]
pub struct Asked<'w> {
    /// The method; the one that suits where none is given.
    pub method: Option<Method>,
    /// Seed, precision, floor, points and threads.
    pub effort: Effort,
    /// The input along which roots are found; where none is given that which matters most at the nearest point.
    pub line: Option<usize>,
    /// The portion of longer work that it is.
    pub portion: Portion<'w>,
}

impl Default for Asked<'_> {
    fn default() -> Self {
        Asked { method: None, effort: Effort::default(), line: None, portion: Portion::UNSEEN }
    }
}

/// How likely a function is below zero.
#[derive(Debug, Clone)]
pub struct Reliability {
    /// That it is.
    pub below_zero: Estimate,
    /// Method by which it was found.
    pub method: Method,
    /// True if an integration was begun and given up.
    pub given_up: bool,
    /// Number of points, or evaluations of an integral.
    pub points: u64,
    /// True if it is as precise as asked.
    pub precise: bool,
    /// The input along which roots are found.
    pub line: usize,
    /// The nearest points at which the function is below zero; where it is so at the medians those at which it is not,
    /// [turned](FormPoint::turned). None if it has one sign everywhere.
    pub design_points: Vec<FormPoint>,
    /// The probability if an input were known to have its median, of each; empty of a single one.
    pub known: Vec<Estimate>,
}

/// Fault of a limit state.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LimitStateError {
    /// The function is not a number too often to be left out.
    #[error(
        "the limit state is not a number with a probability of {probability:.3e}, as at {values:?}; cut the laws to where it is one"
    )]
    NotANumber {
        /// How likely it is not.
        probability: f64,
        /// The values of the inputs at one such point.
        values: Vec<f64>,
    },
    /// More inputs than the method takes.
    #[error("{method} takes {most} random numbers at most, of {numbers}")]
    TooMany {
        /// The method.
        method: Method,
        /// So many it takes.
        most: usize,
        /// So many there are.
        numbers: usize,
    },
}

/// Outcome that the function is below zero, that it is not, and that it is not a number.
const BELOW: usize = 0;
const NOT_BELOW: usize = 1;
const NOT_A_NUMBER: usize = 2;

/// The outcome of a value of the function.
fn outcome(g: f64) -> usize {
    match g {
        g if g.is_nan() => NOT_A_NUMBER,
        g if g < 0.0 => BELOW,
        _ => NOT_BELOW,
    }
}

/// What the roots along a line cost, in decisions.
const COST: u64 = 64;
/// Of two numbers that a scan takes each, more are not integrated unless it is asked for.
const INTEGRATED: usize = 2;

/// How likely it is that a function of random inputs is below zero.
///
/// Where the function is not a number, next to never, it does not count as below zero.
///
/// # Errors
/// If the function is not a number with a probability that the precision asked for would show, or the method takes fewer inputs.
///
/// # Panics
/// For a line that is no input.
pub fn reliability<G: LimitFunction>(
    inputs: &RandomVector,
    function: &G,
    asked: &Asked<'_>,
) -> Result<Reliability, LimitStateError> {
    let first = (0..inputs.laws().len()).find(|input| !inputs.is_parent(*input)).unwrap_or(0);
    let mut state = LimitState::new(inputs, function, asked.line.unwrap_or(first));
    let points = boundary_points(inputs, &state, 1 << BELOW, 1 << NOT_BELOW);
    if let (None, Some(point)) = (asked.line, points.first()) {
        let may_be = |input: usize| !inputs.is_parent(input) && !inputs.laws()[input].is_discrete();
        let weight = |input: &usize| (may_be(*input), point.alpha[*input].abs());
        let first =
            |a: &usize, b: &usize| weight(a).partial_cmp(&weight(b)).unwrap_or(std::cmp::Ordering::Equal);
        let line = (0..point.alpha.len()).max_by(first).unwrap_or(0);
        state = LimitState::new(inputs, function, line);
    }
    let numbers = inputs.laws().len();
    let suited = || Method::suited(numbers, INTEGRATED, points.first().map(|point| point.beta));
    let method = asked.method.unwrap_or_else(suited);
    if let Some(most) = method.most_numbers().filter(|most| numbers > *most) {
        return Err(LimitStateError::TooMany { method, most, numbers });
    }
    let about = apart(points.iter().filter(|_| method == Method::Importance).cloned());
    let [whole, each] = asked.portion.parts([2.0, numbers as f64]);
    let work = (asked.effort.within(whole), COST);
    let Found { method, sampled, given_up } =
        by(method, inputs, &state, &[1 << BELOW, 1 << NOT_A_NUMBER], &about, work);
    let known = (0..numbers).filter(|_| numbers > 1);
    let known = known.map(|input| {
        // What would be gained is worth no more points than what is.
        let work = (asked.effort.within(each.part(input, numbers)), COST);
        by_known(inputs, &state, 1 << BELOW, input, (&about, sampled.points), work)
    });
    let [below_zero, not_a_number] = [sampled.estimates[0], sampled.estimates[1]];
    let known: Vec<Estimate> = known.collect();
    if let Some(values) = state.not_a_number.into_inner().unwrap_or_default() {
        let probability = not_a_number.value;
        if probability > asked.effort.precision * below_zero.value.max(asked.effort.floor) {
            return Err(LimitStateError::NotANumber { probability, values });
        }
    }
    let (points_taken, precise) = (sampled.points, sampled.precise);
    let line = state.line;
    Ok(Reliability {
        below_zero,
        method,
        given_up,
        points: points_taken,
        precise,
        line,
        design_points: points,
        known,
    })
}

/// A function whose sign tells, scanned along one input.
struct LimitState<'a, G> {
    inputs: &'a RandomVector,
    function: &'a G,
    line: usize,
    /// Values of the line at which the sign is looked at, rising; where its law depends on other inputs, those at their medians.
    grid: Vec<f64>,
    /// Values of the inputs at which the function is not a number, if there were any.
    not_a_number: Mutex<Option<Vec<f64>>>,
}

/// The values of a law at which the sign is looked at.
fn grid(law: &Distribution) -> Vec<f64> {
    let mut grid = scanned(law, &[]);
    grid.retain(|x| x.is_finite());
    grid.dedup();
    grid
}

/// A change of the outcome on a line.
struct Change {
    line: usize,
    /// The outcome before it.
    from: usize,
    /// The outcome behind it.
    to: usize,
    crossing: Crossing,
}

impl Change {
    fn new(line: usize, low: (f64, f64), high: (f64, f64)) -> Change {
        let [from, to] = [low, high].map(|(_, g)| outcome(g));
        let at_ends = Crossing::new((low.0, -1.0), (high.0, 1.0));
        let mut change = Change { line, from, to, crossing: at_ends };
        let [low, high] = [low, high].map(|(x, g)| (x, change.above(g)));
        change.crossing = Crossing::new(low, high);
        change
    }

    /// A number that is above zero behind the change, for a value of the function: itself or its negative where it has a sign on both sides.
    fn above(&self, g: f64) -> f64 {
        match (self.from, self.to) {
            (BELOW, NOT_BELOW) if !g.is_nan() => g,
            (NOT_BELOW, BELOW) if !g.is_nan() => -g,
            (from, _) => {
                if outcome(g) == from {
                    -1.0
                } else {
                    1.0
                }
            }
        }
    }
}

/// Where a function that has one sign at three values, and is nearest to zero at the middle one, has the other between them, with its value there: by
/// parabolas through three points, each nearer than the last.
fn dip(mut x: [f64; 3], mut y: [f64; 3], g: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    /// A parabola that comes no nearer to zero than this share of the middle value does not reach it.
    const NEAR: f64 = 0.5;
    let sign = y[1].signum();
    y = y.map(|y| sign * y);
    for _ in 0..12 {
        let is_lowest = y[0] >= y[1] && y[2] >= y[1] && y[1] > 0.0;
        if !is_lowest {
            return None;
        }
        let [left, right] = [x[1] - x[0], x[2] - x[1]];
        let (falls, rises) = ((y[1] - y[0]) / left, (y[2] - y[1]) / right);
        let bend = (rises - falls) / (left + right);
        let slope = (falls * right + rises * left) / (left + right);
        let (step, depth) = (-slope / (2.0 * bend), slope * slope / (4.0 * bend));
        let at = x[1] + step;
        if y[1] - depth > NEAR * y[1] || at.is_nan() || at <= x[0] || at >= x[2] || at == x[1] {
            return None;
        }
        let found = sign * g(at);
        if found < 0.0 {
            return Some((at, sign * found));
        }
        // The three about the lowest.
        let (lower, higher) = ((at, found), (x[1], y[1]));
        let (middle, other) = if found < y[1] { (lower, higher) } else { (higher, lower) };
        if other.0 < middle.0 {
            (x[0], y[0]) = other;
        } else {
            (x[2], y[2]) = other;
        }
        (x[1], y[1]) = middle;
    }
    None
}

impl<'a, G: LimitFunction> LimitState<'a, G> {
    fn new(inputs: &'a RandomVector, function: &'a G, line: usize) -> LimitState<'a, G> {
        LimitState {
            inputs,
            function,
            line,
            grid: grid(&inputs.laws()[line]),
            not_a_number: Mutex::new(None),
        }
    }

    /// The values at which the sign is looked at on a line, at these values of the others.
    fn grid_at(&self, values: &[f64]) -> Cow<'_, [f64]> {
        match self.inputs.law_at(self.line, values) {
            Cow::Borrowed(_) => Cow::Borrowed(&self.grid),
            Cow::Owned(law) => Cow::Owned(grid(&law)),
        }
    }

    /// The function on lines, each at values of its own: `at` of them in all, with the number of the line of each.
    fn found(&self, lines: &[Vec<f64>], at: &[(usize, f64)]) -> Vec<f64> {
        let column = |input: usize| {
            let of = |(line, x): &(usize, f64)| if input == self.line { *x } else { lines[*line][input] };
            at.iter().map(of).collect::<Vec<f64>>()
        };
        self.of(&(0..lines[0].len()).map(column).collect::<Vec<_>>(), at.len())
    }

    /// The function at so many points, by columns.
    fn of(&self, columns: &[Vec<f64>], count: usize) -> Vec<f64> {
        let mut found = vec![0.0; count];
        self.function.each(columns, &mut found);
        if let Some(place) = found.iter().position(|g| g.is_nan())
            && let Ok(mut first) = self.not_a_number.lock()
        {
            first.get_or_insert(columns.iter().map(|column| column[place]).collect());
        }
        found
    }
}

impl<G: LimitFunction> Outcomes for LimitState<'_, G> {
    fn count(&self) -> usize {
        3
    }

    fn line(&self) -> usize {
        self.line
    }

    fn at_once(&self) -> usize {
        64
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        self.along_each(&[values.to_vec()], std::slice::from_mut(pieces));
    }

    fn along_each(&self, lines: &[Vec<f64>], pieces: &mut [Pieces]) {
        let grids: Vec<Cow<'_, [f64]>> = lines.iter().map(|values| self.grid_at(values)).collect();
        let on_grid = |(line, grid): (usize, &Cow<'_, [f64]>)| -> Vec<(usize, f64)> {
            grid.iter().map(|x| (line, *x)).collect()
        };
        let at: Vec<(usize, f64)> = grids.iter().enumerate().flat_map(on_grid).collect();
        let all = self.found(lines, &at);
        let mut crossings: Vec<Change> = Vec::new();
        let mut rest = &all[..];
        for (line, grid) in grids.iter().enumerate() {
            let found;
            (found, rest) = rest.split_at(grid.len());
            let mut last = (grid[0], found[0]);
            let mut pass = |next: (f64, f64)| {
                if outcome(next.1) != outcome(last.1) {
                    crossings.push(Change::new(line, last, next));
                }
                last = next;
            };
            for i in 1..grid.len() {
                let here = (grid[i], found[i]);
                if let (Some(&[x0, x1, x2]), Some(&[y0, y1, y2])) =
                    (grid.get(i - 1..i + 2), found.get(i - 1..i + 2))
                {
                    let dip = dip([x0, x1, x2], [y0, y1, y2], |x| self.found(lines, &[(line, x)])[0]);
                    if let Some(dip) = dip {
                        let mut passed = [dip, here];
                        passed.sort_by(|a, b| a.0.total_cmp(&b.0));
                        passed.into_iter().for_each(&mut pass);
                        continue;
                    }
                }
                pass(here);
            }
        }
        loop {
            let asked = crossings.iter().enumerate();
            let asked: Vec<(usize, f64)> = asked.filter_map(|(i, c)| Some((i, c.crossing.next()?))).collect();
            if asked.is_empty() {
                break;
            }
            let at: Vec<(usize, f64)> = asked.iter().map(|(i, x)| (crossings[*i].line, *x)).collect();
            for ((i, x), g) in asked.into_iter().zip(self.found(lines, &at)) {
                let above = crossings[i].above(g);
                crossings[i].crossing.met(x, above);
            }
        }
        let mut crossings = crossings.into_iter().peekable();
        let mut first = 0;
        for ((line, pieces), grid) in pieces.iter_mut().enumerate().zip(&grids) {
            let (mut from, mut holds) = (f64::NEG_INFINITY, outcome(all[first]));
            first += grid.len();
            while let Some(change) = crossings.next_if(|change| change.line == line) {
                pieces.push(from, change.crossing.root(), holds);
                (from, holds) = (change.crossing.root(), change.to);
            }
            pieces.push(from, f64::INFINITY, holds);
        }
    }

    fn at_each(&self, columns: &[Vec<f64>], found: &mut [u64]) {
        let values = self.of(columns, found.len());
        found.iter_mut().zip(values).for_each(|(found, g)| *found = 1 << outcome(g));
    }

    fn at(&self, values: &[f64]) -> u64 {
        1 << outcome(self.of(&values.iter().map(|value| vec![*value]).collect::<Vec<_>>(), 1)[0])
    }
}
