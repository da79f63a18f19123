//! Exact integration: few inputs, panels of Gauss and Legendre between the kinks.
//!
//! The line is integrated in closed form. What is left are integrals over independent normals u, |u| ≤ 12, one within the other, and no
//! farther than there is probability enough to be seen in any answer.
//! Along each the pattern of the pieces is scanned, and where it changes, bisected to the last bit; an outer integral is parted
//! where the list of patterns along the inner one changes. Between the kinks panels are halved until Gauss's rule and Kronrod's about it
//! agree: that difference is the error stated, far more than that of the finer rule, which is the answer, where the scan met every kink.

use standfast_watch::Portion;
use thiserror::Error;

use crate::life::Life;
use crate::problem::{Frame, Outcomes, RandomVector, Scratch, mixed};
use crate::{REACH, legendre, normal};

/// The most inputs beside the line over which is integrated.
pub const MOST_DIMENSIONS: usize = 2;

/// Probabilities by integration.
#[derive(Debug, Clone, PartialEq)]
pub struct Integrated {
    /// Of each set of outcomes asked for.
    pub probabilities: Vec<f64>,
    /// The error of each: by what the two rules of all panels differ.
    pub errors: Vec<f64>,
    /// Number of times that the pieces of a line were asked for.
    pub evaluations: u64,
}

/// How far an integration goes.
#[derive(Clone, Copy)]
pub struct Within<'w> {
    /// Probability below which a contribution is negligible, whatever the integral.
    pub negligible: f64,
    /// The most times that the pieces of a line may be asked for: then no panel is halved any more, and each error is what it is.
    pub evaluations: u64,
    /// The portion of longer work that it is; a share of it is done as the same share of the evaluations is.
    pub portion: Portion<'w>,
}

impl Within<'static> {
    /// All digits, whatever that takes.
    pub const ALL_DIGITS: Within<'static> =
        Within { negligible: 1e-18, evaluations: u64::MAX, portion: Portion::UNSEEN };
}

/// Reason why there is no integral: its bounds were reached, or it was stopped, before each panel was integrated once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("{evaluations} evaluations do not reach over the whole of an integral")]
pub struct OutOfBounds {
    /// Number of evaluations that were allowed or, of one that was stopped, made.
    pub evaluations: u64,
}

/// The probability of each set of outcomes (a bit for each outcome; outcomes of one set exclude each other).
///
/// # Errors
/// If that is not within the bounds.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line.
pub fn integrate<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    within: Within<'_>,
) -> Result<Integrated, OutOfBounds> {
    Nest::of(&Frame::new(inputs, outcomes), sets, None, within)
}

/// Probability of each set, as [`integrate`] has it, with the input of this number known to have its median.
///
/// # Errors
/// As [`integrate`].
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line and the known one.
pub fn integrate_known<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    known: usize,
    within: Within<'_>,
) -> Result<Integrated, OutOfBounds> {
    Nest::of(&Frame::holding(inputs, outcomes, known), sets, None, within)
}

/// The probability that each set of outcomes is met at least once in a life, E[1 − (1 − p)ⁿ] with the yearly probability p for what
/// is drawn once, or E[1 − e^(−λnp)] of events. The line has to be drawn yearly, or in each event.
///
/// # Errors
/// As [`integrate`].
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line, a line that is drawn once, or a list of another length.
pub fn integrate_life<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    life: &Life,
    within: Within<'_>,
) -> Result<Integrated, OutOfBounds> {
    assert_eq!(life.yearly.len(), inputs.laws().len(), "an entry for each input");
    assert!(life.yearly[outcomes.line()], "the line is drawn yearly");
    let once = life.yearly.iter().filter(|yearly| !**yearly).count();
    assert!(life.clock != Some(outcomes.line()), "the line does not go with the time");
    let frame = Frame::ranked(inputs, outcomes, |input| {
        // What lasts, then the clock, then what each year draws.
        (life.yearly[input], life.clock != Some(input))
    });
    Nest::of(&frame, sets, Some((once, life)), within)
}

/// Integrals within integrals.
struct Nest<'f, 'a, 'w, O> {
    frame: &'f Frame<'a, O>,
    sets: &'f [u64],
    /// From which depth on a year is integrated, and how many years follow each other.
    life: Option<(usize, &'f Life)>,
    within: Within<'w>,
    scratch: Scratch,
    point: Vec<f64>,
    evaluations: u64,
    /// True if no more evaluations are allowed, or wanted.
    is_spent: bool,
    /// True once each panel of the outermost integral is integrated.
    has_all: bool,
}

/// An integral for each set, and its error.
#[derive(Clone)]
struct Sum {
    values: Vec<f64>,
    errors: Vec<f64>,
}

/// An integral over a panel, and by how much the coarser of its two rules differs.
struct Panel {
    sum: Sum,
    differs: Vec<f64>,
}

/// Relative to an integral, by what the rules of one panel may differ. What the finer leaves is far less.
const PRECISION: f64 = 1e-9;
/// The share of it that may be left out beyond the ends of one integral, so that an answer of 1e-16 has its digits.
const LEFT_OUT: f64 = 1e-10;
/// Steps in u of the search for kinks: of the outermost integral, and of those inside.
const SCAN: f64 = 0.1875;
const INNER_SCAN: f64 = 0.375;
/// So many kinks within one step are a crowd: rounding makes the pattern change from one value to the next, in the tails, where a boundary is
/// the small difference of large terms, or where boundaries meet at the end of a law. Its ends are kinks, and between them is nothing to be seen.
const CROWDED: usize = 8;
/// Distance in u up to which kinks are listed: beyond lies 2e-21.
const LISTED: f64 = 9.375;
/// Width to which a kink is found: to the last bit, and coarsely.
const LAST_BIT: f64 = 2e-16;
const COARSE: f64 = 1e-7;
/// Largest change of a probability over a kink found coarsely: beyond this it is a step, and found to the last bit.
const STEP: f64 = 1e-5;
/// Largest such change for a rare outcome, relative to its probability, and the share of the negligible that may be
/// lost at it.
const RARE_STEP: f64 = 1e-2;
const UNSEEN: f64 = 1e-3;
/// The widest panel to begin with.
const WIDEST: f64 = 3.0;
/// Largest number of halvings of a panel.
const HALVINGS: u32 = 14;

impl<'f, 'a, 'w, O: Outcomes> Nest<'f, 'a, 'w, O> {
    fn of(
        frame: &'f Frame<'a, O>,
        sets: &'f [u64],
        life: Option<(usize, &'f Life)>,
        within: Within<'w>,
    ) -> Result<Integrated, OutOfBounds> {
        let n = frame.dimensions();
        assert!(n <= MOST_DIMENSIONS, "{n} inputs beside the line, at most {MOST_DIMENSIONS} are integrated");
        let mut nest = Nest {
            frame,
            sets,
            life,
            within,
            scratch: frame.scratch(),
            point: vec![0.0; n],
            evaluations: 0,
            is_spent: false,
            has_all: n == 0,
        };
        let Sum { values, errors } = nest.from(0, 1.0);
        let evaluations = nest.evaluations;
        let integrated = Integrated { probabilities: values, errors, evaluations };
        if nest.is_lost() { Err(OutOfBounds { evaluations }) } else { Ok(integrated) }
    }

    /// True if there will be no integral: what is evaluated then is not used.
    fn is_lost(&self) -> bool {
        self.is_spent && !self.has_all
    }

    /// One evaluation more.
    fn count(&mut self) {
        /// So many evaluations are told at once.
        const TOLD: u64 = 256;
        if self.is_lost() {
            return;
        }
        self.evaluations += 1;
        if self.evaluations.is_multiple_of(TOLD) {
            let Within { evaluations, portion, .. } = self.within;
            portion.reached(self.evaluations as f64 / evaluations as f64);
            self.is_spent |= portion.is_enough();
        }
        self.is_spent |= self.evaluations >= self.within.evaluations;
    }

    /// The integral over the normals from number `depth` on, those before being given; `weight` is the density already there.
    fn from(&mut self, depth: usize, weight: f64) -> Sum {
        let mut sum = if depth == self.point.len() { self.at_point() } else { self.over(depth, weight) };
        let Some((once, life)) = self.life else { return sum };
        // Of years that differ the logarithms of their complements add up.
        let by_years = life.clock.is_some() && life.events.is_none();
        let entries = sum.values.iter_mut().zip(&mut sum.errors);
        if by_years && depth == once + 1 {
            for (value, error) in entries {
                *error /= (1.0 - *value).max(f64::EPSILON);
                *value = -libm::log1p(-value.min(1.0 - f64::EPSILON));
            }
        } else if depth == once {
            for (value, error) in entries {
                let rate = if by_years { -libm::expm1(-*value) } else { *value };
                *error *= life.slope(rate);
                *value = -libm::expm1(life.log_never(rate));
            }
        }
        sum
    }

    fn at_point(&mut self) -> Sum {
        self.count();
        if self.is_lost() {
            let nothing = vec![0.0; self.sets.len()];
            return Sum { values: nothing.clone(), errors: nothing };
        }
        self.frame.evaluate(&self.point, &mut self.scratch);
        let values: Vec<f64> = self.sets.iter().map(|set| self.scratch.of_set(*set)).collect();
        Sum { errors: vec![0.0; values.len()], values }
    }

    /// Distance to which an integral has to go where the density is already `weight`: the rest is seen in no answer.
    fn reach(&self, weight: f64) -> f64 {
        let beyond = LEFT_OUT * self.within.negligible / weight;
        if beyond >= 0.5 { 0.0 } else { normal::quantile_above(beyond).min(REACH) }
    }

    fn over(&mut self, depth: usize, weight: f64) -> Sum {
        let reach = self.reach(weight);
        if reach <= 0.0 {
            let nothing = vec![0.0; self.sets.len()];
            return Sum { values: nothing.clone(), errors: nothing };
        }
        if self.frame.is_stepped(depth) {
            return self.steps(depth, weight, reach);
        }
        let ends = self.kinks(depth, weight, reach);
        let mut panels: Vec<(f64, f64, u32, Panel)> = Vec::new();
        for pair in ends.windows(2) {
            let parts = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0);
            let width = (pair[1] - pair[0]) / parts;
            for i in 0..parts as u32 {
                if self.is_lost() {
                    break;
                }
                let a = pair[0] + f64::from(i) * width;
                let panel = self.panel(depth, weight, a, a + width);
                panels.push((a, a + width, 0, panel));
            }
        }
        self.has_all |= depth == 0 && !self.is_lost();
        let count = self.sets.len();
        let scale: Vec<f64> = (0..count)
            .map(|k| PRECISION * panels.iter().map(|(.., panel)| panel.sum.values[k]).sum::<f64>())
            .collect();
        let floor = self.within.negligible / weight;
        let mut total = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        // From left to right, so that sums are added in one order.
        panels.reverse();
        while let Some((a, b, halvings, panel)) = panels.pop() {
            let done = (0..count).all(|k| panel.differs[k] <= scale[k].max(floor))
                || halvings == HALVINGS
                || self.is_spent
                || normal::between(a, b) <= floor;
            if done {
                for k in 0..count {
                    total.values[k] += panel.sum.values[k];
                    total.errors[k] += panel.differs[k] + panel.sum.errors[k];
                }
            } else {
                let middle = 0.5 * (a + b);
                let [left, right] = [(a, middle), (middle, b)].map(|(a, b)| self.panel(depth, weight, a, b));
                panels.push((middle, b, halvings + 1, right));
                panels.push((a, middle, halvings + 1, left));
            }
        }
        total
    }

    /// The sum over an input that has a few values, each with its probability.
    fn steps(&mut self, depth: usize, weight: f64, reach: f64) -> Sum {
        let count = self.sets.len();
        let mut total = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        for (a, b) in self.stretches(depth, reach) {
            let share = normal::between(a, b);
            self.point[depth] = within(a, b);
            let inner = self.from(depth + 1, (weight * share).max(f64::MIN_POSITIVE));
            for k in 0..count {
                total.values[k] += share * inner.values[k];
                total.errors[k] += share * inner.errors[k];
            }
        }
        self.has_all |= depth == 0 && !self.is_lost();
        total
    }

    /// The stretches of the normal with number `depth` between which its input jumps or has a kink, in a range.
    fn stretches(&self, depth: usize, reach: f64) -> Vec<(f64, f64)> {
        let breaks = self.frame.breaks(depth, &self.point[..depth]);
        let mut ends = vec![-reach];
        ends.extend(breaks.into_iter().filter(|u| u.abs() < reach));
        ends.push(reach);
        ends.windows(2).map(|pair| (pair[0], pair[1])).filter(|(a, b)| a < b).collect()
    }

    /// One panel of the normal with number `depth`.
    fn panel(&mut self, depth: usize, weight: f64, a: f64, b: f64) -> Panel {
        let count = self.sets.len();
        let mut sum = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        let mut coarse = vec![0.0; count];
        for (u, of_fine, of_coarse) in legendre::nested(a, b) {
            let density = normal::density(u);
            let (share, of_coarse) = (of_fine * density, of_coarse * density);
            self.point[depth] = u;
            let inner = self.from(depth + 1, (weight * share).max(f64::MIN_POSITIVE));
            for (k, (value, error)) in inner.values.iter().zip(&inner.errors).enumerate() {
                sum.values[k] += share * value;
                sum.errors[k] += share * error;
                coarse[k] += of_coarse * value;
            }
        }
        let differs = sum.values.iter().zip(&coarse).map(|(fine, coarse)| (fine - coarse).abs()).collect();
        Panel { sum, differs }
    }

    /// Values at which the pattern changes along the normal with number `depth`, with the ends of its range. At a kink
    /// that is not quite met nothing is lost but the square of what it is missed by; a step is found to the last bit.
    fn kinks(&mut self, depth: usize, weight: f64, reach: f64) -> Vec<f64> {
        let (mut ends, mut last) = (vec![-reach], (-reach, self.pattern(depth, -reach)));
        let stretches = self.stretches(depth, reach);
        ends.extend(stretches.iter().map(|(_, end)| *end));
        for (_, b) in stretches.into_iter().flat_map(|(a, b)| steps(a, b, SCAN)) {
            let here = (b, self.pattern(depth, b));
            for kink in self.changes(depth, COARSE, last, here) {
                let before = kink - COARSE * kink.abs().max(1.0);
                if self.is_step(depth, weight, before, kink) {
                    let [below, above] = [before, kink].map(|u| (u, self.pattern(depth, u)));
                    ends.extend(self.changes(depth, LAST_BIT, below, above));
                } else {
                    ends.push(kink);
                }
            }
            last = here;
        }
        // Changes that lie closer than the resolution are found in any order.
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends
    }

    /// Every change of the pattern between two values, from left to right; of a crowd of them its two ends.
    fn changes(&mut self, depth: usize, resolution: f64, below: (f64, u64), above: (f64, u64)) -> Vec<f64> {
        let mut found = Vec::new();
        let is_all = self.part(depth, resolution, below, above, &mut |at, _| {
            found.push(at);
            found.len() < CROWDED
        });
        if is_all {
            return found;
        }
        let (mut from, mut to) = (found[0], above.0);
        while to - from >= resolution * from.abs().max(1.0) {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                break;
            }
            if self.pattern(depth, middle) == above.1 { to = middle } else { from = middle }
        }
        vec![found[0], to]
    }

    /// True if probabilities differ between two values that are next to each other.
    fn is_step(&mut self, depth: usize, weight: f64, a: f64, b: f64) -> bool {
        let [one, other] = [a, b].map(|u| {
            self.point[depth] = u;
            self.from(depth + 1, normal::density(u).max(f64::MIN_POSITIVE)).values
        });
        // Of a rare outcome a small step is all there is: what is lost at it counts as far as an answer sees it.
        let seen =
            UNSEEN * self.within.negligible / (weight * normal::density(b) * (b - a)).max(f64::MIN_POSITIVE);
        one.iter().zip(&other).any(|(one, other)| {
            let change = (one - other).abs();
            change > STEP || change > seen.max(RARE_STEP * one.max(*other))
        })
    }

    /// Finds every change of the pattern between two values, from left to right, and tells where it is and what follows. Where
    /// the patterns at both ends differ nothing between them is missed that is wider than the resolution. Ends, with false, where it is told
    /// that enough is found.
    fn part(
        &mut self,
        depth: usize,
        resolution: f64,
        (a, before): (f64, u64),
        (b, after): (f64, u64),
        found: &mut impl FnMut(f64, u64) -> bool,
    ) -> bool {
        if before == after {
            return true;
        }
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b || b - a < resolution * a.abs().max(1.0) {
            return found(b, after);
        }
        let here = self.pattern(depth, middle);
        self.part(depth, resolution, (a, before), (middle, here), found)
            && self.part(depth, resolution, (middle, here), (b, after), found)
    }

    /// The pattern at a value of the normal with number `depth`: the signature there, or the list of those along the next one.
    fn pattern(&mut self, depth: usize, u: f64) -> u64 {
        self.point[depth] = u;
        if depth + 1 == self.point.len() {
            self.count();
            if self.is_lost() {
                return 0;
            }
            return self.frame.evaluate(&self.point, &mut self.scratch);
        }
        if self.frame.is_stepped(depth + 1) {
            let stretches = self.stretches(depth + 1, LISTED);
            return stretches
                .into_iter()
                .fold(0, |list, (a, b)| mixed(list, self.pattern(depth + 1, within(a, b))));
        }
        let mut last = self.pattern(depth + 1, -LISTED);
        let mut list = mixed(0, last);
        let stretches = self.stretches(depth + 1, LISTED);
        for (a, b) in stretches.into_iter().flat_map(|(a, b)| steps(a, b, INNER_SCAN)) {
            let here = self.pattern(depth + 1, b);
            let (before, mut changes) = (list, 0);
            self.part(depth + 1, COARSE, (a, last), (b, here), &mut |_, then| {
                list = mixed(list, then);
                changes += 1;
                changes < CROWDED
            });
            if changes == CROWDED {
                list = mixed(before, 0);
            }
            last = here;
        }
        list
    }
}

/// Steps from `from` to `to`, about so wide and even.
fn steps(from: f64, to: f64, wide: f64) -> impl Iterator<Item = (f64, f64)> {
    let count = ((to - from) / wide).ceil().max(1.0);
    let at =
        move |i: u32| if f64::from(i) >= count { to } else { from + (to - from) * (f64::from(i) / count) };
    (0..count as u32).map(move |i| (at(i), at(i + 1)))
}

/// A normal between two, the likeliest but for the very ends.
fn within(a: f64, b: f64) -> f64 {
    0f64.clamp(a + 0.25 * (b - a), b - 0.25 * (b - a))
}
