//! Exact integration: few inputs, panels of Gauss and Legendre between the kinks.
//!
//! The line is integrated in closed form. What is left are integrals over independent normals u, |u| ≤ 12, one within the other, and no
//! farther than there is probability enough to be seen in any answer.
//! Along each the pattern of the pieces is scanned, and where it changes, bisected to the last bit; an outer integral is parted
//! where the list of patterns along the inner one changes. Between the kinks panels are halved until Gauss's rule and Kronrod's about it
//! agree: that difference is the error stated, far more than that of the finer rule, which is the answer, where the scan met every kink.

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

/// The probability of each set of outcomes (a bit for each outcome; outcomes of one set exclude each other).
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line.
pub fn integrate<O: Outcomes>(inputs: &RandomVector, outcomes: &O, sets: &[u64]) -> Integrated {
    Nest::of(&Frame::new(inputs, outcomes), sets, None)
}

/// Probability of each set, as [`integrate`] has it, with the input of this number known to have its median.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line and the known one.
pub fn integrate_known<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    known: usize,
) -> Integrated {
    Nest::of(&Frame::holding(inputs, outcomes, known), sets, None)
}

/// Inputs of which some are drawn anew each year, and the others once.
#[derive(Debug, Clone, PartialEq)]
pub struct Life {
    /// Length of the life in years, not necessarily a whole number.
    pub years: f64,
    /// Of each input, whether it is drawn yearly.
    pub yearly: Vec<bool>,
}

/// The probability that each set of outcomes is met at least once in a life, E[1 − (1 − p)ⁿ] with the yearly probability p for what
/// is drawn once. The line has to be drawn yearly.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line, a line that is drawn once, or a list of another length.
pub fn integrate_life<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    life: &Life,
) -> Integrated {
    assert_eq!(life.yearly.len(), inputs.laws().len(), "an entry for each input");
    assert!(life.yearly[outcomes.line()], "the line is drawn yearly");
    let once = life.yearly.iter().filter(|yearly| !**yearly).count();
    Nest::of(&Frame::last(inputs, outcomes, |input| life.yearly[input]), sets, Some((once, life.years)))
}

/// Integrals within integrals.
struct Nest<'f, 'a, O> {
    frame: &'f Frame<'a, O>,
    sets: &'f [u64],
    /// From which depth on a year is integrated, and how many years follow each other.
    life: Option<(usize, f64)>,
    /// Probability below which a contribution is negligible, whatever the integral.
    negligible: f64,
    scratch: Scratch,
    point: Vec<f64>,
    evaluations: u64,
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

/// Probability of each set, as [`integrate`] has it, where those below `floor` need not be precise.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line.
pub fn integrate_above<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    floor: f64,
) -> Integrated {
    Nest::to(&Frame::new(inputs, outcomes), sets, None, NEGLIGIBLE.max(PRECISION * floor))
}

/// Relative to an integral, by what the rules of one panel may differ. What the finer leaves is far less.
const PRECISION: f64 = 1e-9;
/// Probability below which a contribution is negligible, whatever the integral.
const NEGLIGIBLE: f64 = 1e-18;
/// The share of it that may be left out beyond the ends of one integral, so that an answer of 1e-16 has its digits.
const LEFT_OUT: f64 = 1e-10;
/// Steps in u of the search for kinks: of the outermost integral, and of those inside.
const SCAN: f64 = 0.1875;
const INNER_SCAN: f64 = 0.375;
/// So many kinks within one step are none: rounding makes the pattern change from one value to the next, in the tails, where a boundary is the
/// small difference of large terms. Halving has to do there, and has nothing to do.
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

impl<'f, 'a, O: Outcomes> Nest<'f, 'a, O> {
    fn of(frame: &'f Frame<'a, O>, sets: &'f [u64], life: Option<(usize, f64)>) -> Integrated {
        Nest::to(frame, sets, life, NEGLIGIBLE)
    }

    fn to(
        frame: &'f Frame<'a, O>,
        sets: &'f [u64],
        life: Option<(usize, f64)>,
        negligible: f64,
    ) -> Integrated {
        let n = frame.dimensions();
        assert!(n <= MOST_DIMENSIONS, "{n} inputs beside the line, at most {MOST_DIMENSIONS} are integrated");
        let mut nest = Nest {
            frame,
            sets,
            life,
            negligible,
            scratch: frame.scratch(),
            point: vec![0.0; n],
            evaluations: 0,
        };
        let Sum { values, errors } = nest.from(0, 1.0);
        Integrated { probabilities: values, errors, evaluations: nest.evaluations }
    }

    /// The integral over the normals from number `depth` on, those before being given; `weight` is the density already there.
    fn from(&mut self, depth: usize, weight: f64) -> Sum {
        let mut sum = if depth == self.point.len() { self.at_point() } else { self.over(depth, weight) };
        if let Some((_, years)) = self.life.filter(|(from, _)| *from == depth) {
            for (value, error) in sum.values.iter_mut().zip(&mut sum.errors) {
                let never = years * libm::log1p(-value.min(1.0));
                *error *= years * (never * (1.0 - 1.0 / years)).exp();
                *value = -libm::expm1(never);
            }
        }
        sum
    }

    fn at_point(&mut self) -> Sum {
        self.evaluations += 1;
        self.frame.evaluate(&self.point, &mut self.scratch);
        let values: Vec<f64> = self.sets.iter().map(|set| self.scratch.of_set(*set)).collect();
        Sum { errors: vec![0.0; values.len()], values }
    }

    /// Distance to which an integral has to go where the density is already `weight`: the rest is seen in no answer.
    fn reach(&self, weight: f64) -> f64 {
        let beyond = LEFT_OUT * self.negligible / weight;
        if beyond >= 0.5 { 0.0 } else { normal::quantile_above(beyond).min(REACH) }
    }

    fn over(&mut self, depth: usize, weight: f64) -> Sum {
        let reach = self.reach(weight);
        if reach <= 0.0 {
            let nothing = vec![0.0; self.sets.len()];
            return Sum { values: nothing.clone(), errors: nothing };
        }
        let ends = self.kinks(depth, weight, reach);
        let mut panels: Vec<(f64, f64, u32, Panel)> = Vec::new();
        for pair in ends.windows(2) {
            let parts = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0);
            let width = (pair[1] - pair[0]) / parts;
            for i in 0..parts as u32 {
                let a = pair[0] + f64::from(i) * width;
                let panel = self.panel(depth, weight, a, a + width);
                panels.push((a, a + width, 0, panel));
            }
        }
        let count = self.sets.len();
        let scale: Vec<f64> = (0..count)
            .map(|k| PRECISION * panels.iter().map(|(.., panel)| panel.sum.values[k]).sum::<f64>())
            .collect();
        let floor = self.negligible / weight;
        let mut total = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        // From left to right, so that sums are added in one order.
        panels.reverse();
        while let Some((a, b, halvings, panel)) = panels.pop() {
            let done = (0..count).all(|k| panel.differs[k] <= scale[k].max(floor))
                || halvings == HALVINGS
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
        let (mut ends, mut last) = (vec![-reach], self.pattern(depth, -reach));
        for (a, b) in steps(reach, SCAN) {
            let here = self.pattern(depth, b);
            let mut found = Vec::new();
            self.part(depth, COARSE, (a, last), (b, here), &mut |kink, _| {
                found.push(kink);
                found.len() < CROWDED
            });
            if found.len() == CROWDED {
                found.clear();
            }
            for kink in found {
                let before = kink - COARSE * kink.abs().max(1.0);
                if self.is_step(depth, weight, before, kink) {
                    let sides = [before, kink].map(|u| (u, self.pattern(depth, u)));
                    self.part(depth, LAST_BIT, sides[0], sides[1], &mut |kink, _| {
                        ends.push(kink);
                        true
                    });
                } else {
                    ends.push(kink);
                }
            }
            last = here;
        }
        ends.push(reach);
        ends
    }

    /// True if probabilities differ between two values that are next to each other.
    fn is_step(&mut self, depth: usize, weight: f64, a: f64, b: f64) -> bool {
        let [one, other] = [a, b].map(|u| {
            self.point[depth] = u;
            self.from(depth + 1, normal::density(u).max(f64::MIN_POSITIVE)).values
        });
        // Of a rare outcome a small step is all there is: what is lost at it counts as far as an answer sees it.
        let seen = UNSEEN * self.negligible / (weight * normal::density(b) * (b - a)).max(f64::MIN_POSITIVE);
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
            self.evaluations += 1;
            return self.frame.evaluate(&self.point, &mut self.scratch);
        }
        let mut last = self.pattern(depth + 1, -LISTED);
        let mut list = mixed(0, last);
        for (a, b) in steps(LISTED, INNER_SCAN) {
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

/// Steps from −`reach` to `reach`, about so wide and even.
fn steps(reach: f64, wide: f64) -> impl Iterator<Item = (f64, f64)> {
    let count = (2.0 * reach / wide).ceil().max(1.0);
    let at =
        move |i: u32| if f64::from(i) >= count { reach } else { reach * (2.0 * f64::from(i) / count - 1.0) };
    (0..count as u32).map(move |i| (at(i), at(i + 1)))
}
