//! Exact integration: few inputs, panels of Gauss and Legendre between the kinks.
//!
//! The line is integrated in closed form. What is left are integrals over independent normals u, |u| ≤ 12, one within the other.
//! Along each the pattern of the pieces is scanned, and where it changes, bisected to the last bit; an outer integral is parted
//! where the list of patterns along the inner one changes. Between the kinks panels are halved until both halves together agree
//! with the whole: that difference is the error stated.

use crate::problem::{Frame, Inputs, Outcomes, Scratch, mixed};
use crate::{REACH, legendre, normal};

/// The most inputs beside the line over which is integrated.
pub const MOST_DIMENSIONS: usize = 2;

/// Probabilities by integration.
#[derive(Debug, Clone, PartialEq)]
pub struct Integrated {
    /// Of each set of outcomes asked for.
    pub probabilities: Vec<f64>,
    /// The error of each: what the last refinement changed.
    pub errors: Vec<f64>,
    /// How often the pieces of a line were asked for.
    pub evaluations: u64,
}

/// The probability of each set of outcomes (a bit for each outcome; outcomes of one set exclude each other).
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line.
pub fn integrate<O: Outcomes>(inputs: &Inputs, outcomes: &O, sets: &[u64]) -> Integrated {
    Nest::of(&Frame::new(inputs, outcomes), sets, None)
}

/// The same if the input of this number is known to have its median.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line and the known one.
pub fn integrate_known<O: Outcomes>(inputs: &Inputs, outcomes: &O, sets: &[u64], known: usize) -> Integrated {
    Nest::of(&Frame::holding(inputs, outcomes, known), sets, None)
}

/// Inputs of which some are drawn anew each year, and the others once.
#[derive(Debug, Clone, PartialEq)]
pub struct Life {
    /// How many years; they need be no whole number.
    pub years: f64,
    /// Of each input, whether it is drawn yearly.
    pub yearly: Vec<bool>,
}

/// The probability that each set of outcomes is met at least once in a life, E[1 − (1 − p)ⁿ] with the yearly probability p for what
/// is drawn once. The line has to be drawn yearly.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line, a line that is drawn once, or a list of another length.
pub fn integrate_life<O: Outcomes>(inputs: &Inputs, outcomes: &O, sets: &[u64], life: &Life) -> Integrated {
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
    /// What is too little to look at, whatever the integral.
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

/// The same where probabilities below `floor` need not be precise.
///
/// # Panics
/// For more than [`MOST_DIMENSIONS`] inputs beside the line.
pub fn integrate_above<O: Outcomes>(inputs: &Inputs, outcomes: &O, sets: &[u64], floor: f64) -> Integrated {
    Nest::to(&Frame::new(inputs, outcomes), sets, None, NEGLIGIBLE.max(PRECISION * floor))
}

/// Relative to an integral, what a refinement of one panel may change it by. What both halves leave is far less.
const PRECISION: f64 = 1e-9;
/// What is too little to look at, whatever the integral.
const NEGLIGIBLE: f64 = 1e-22;
/// Into how many steps |u| ≤ 12 is cut in search of kinks, and where only their list is asked for.
const SCAN: usize = 128;
const INNER_SCAN: usize = 64;
/// How near a kink is found, and how near to tell what comes after it.
const LAST_BIT: f64 = 2e-16;
const COARSE: f64 = 1e-7;
/// How much a probability may change over a kink found coarsely: beyond this it is a step, and found to the last bit.
const STEP: f64 = 1e-5;
/// The widest panel to begin with.
const WIDEST: f64 = 3.0;
/// How often a panel may be halved.
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

    fn over(&mut self, depth: usize, weight: f64) -> Sum {
        let ends = self.kinks(depth);
        let mut panels: Vec<(f64, f64, u32, Sum)> = Vec::new();
        for pair in ends.windows(2) {
            let parts = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0);
            let width = (pair[1] - pair[0]) / parts;
            for i in 0..parts as u32 {
                let a = pair[0] + f64::from(i) * width;
                let sum = self.panel(depth, weight, a, a + width);
                panels.push((a, a + width, 0, sum));
            }
        }
        let count = self.sets.len();
        let scale: Vec<f64> = (0..count)
            .map(|k| PRECISION * panels.iter().map(|(.., sum)| sum.values[k]).sum::<f64>())
            .collect();
        let floor = self.negligible / weight;
        let mut total = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        // From left to right, so that sums are added in one order.
        panels.reverse();
        while let Some((a, b, halvings, whole)) = panels.pop() {
            let middle = 0.5 * (a + b);
            let halves = [self.panel(depth, weight, a, middle), self.panel(depth, weight, middle, b)];
            let changed = |k: usize| (halves[0].values[k] + halves[1].values[k] - whole.values[k]).abs();
            let done = (0..count).all(|k| changed(k) <= scale[k].max(floor)) || halvings == HALVINGS;
            if done {
                for k in 0..count {
                    total.values[k] += halves[0].values[k] + halves[1].values[k];
                    total.errors[k] += changed(k) + halves[0].errors[k] + halves[1].errors[k];
                }
            } else {
                let [left, right] = halves;
                panels.push((middle, b, halvings + 1, right));
                panels.push((a, middle, halvings + 1, left));
            }
        }
        total
    }

    /// One panel of the normal with number `depth`.
    fn panel(&mut self, depth: usize, weight: f64, a: f64, b: f64) -> Sum {
        let count = self.sets.len();
        let mut sum = Sum { values: vec![0.0; count], errors: vec![0.0; count] };
        for (u, share) in legendre::panel(a, b) {
            let share = share * normal::density(u);
            self.point[depth] = u;
            let inner = self.from(depth + 1, (weight * share).max(f64::MIN_POSITIVE));
            for k in 0..count {
                sum.values[k] += share * inner.values[k];
                sum.errors[k] += share * inner.errors[k];
            }
        }
        sum
    }

    /// Where the pattern changes along the normal with number `depth`, with the ends of its range. At a kink that is not quite met
    /// nothing is lost but the square of what it is missed by; a step is found to the last bit.
    fn kinks(&mut self, depth: usize) -> Vec<f64> {
        let (mut ends, mut last) = (vec![-REACH], self.pattern(depth, -REACH));
        for i in 1..=SCAN {
            let (a, b) = (step(i - 1, SCAN), step(i, SCAN));
            let here = self.pattern(depth, b);
            let mut found = Vec::new();
            self.part(depth, COARSE, (a, last), (b, here), &mut |kink, _| found.push(kink));
            for kink in found {
                let before = kink - COARSE * kink.abs().max(1.0);
                if self.is_step(depth, before, kink) {
                    let sides = [before, kink].map(|u| (u, self.pattern(depth, u)));
                    self.part(depth, LAST_BIT, sides[0], sides[1], &mut |kink, _| ends.push(kink));
                } else {
                    ends.push(kink);
                }
            }
            last = here;
        }
        ends.push(REACH);
        ends
    }

    /// Whether probabilities differ between two values that are next to each other.
    fn is_step(&mut self, depth: usize, a: f64, b: f64) -> bool {
        let [one, other] = [a, b].map(|u| {
            self.point[depth] = u;
            self.from(depth + 1, normal::density(u).max(f64::MIN_POSITIVE)).values
        });
        one.iter().zip(&other).any(|(one, other)| (one - other).abs() > STEP)
    }

    /// Finds every change of the pattern between two values, from left to right, and tells where it is and what follows. Where
    /// the patterns at both ends differ nothing between them is missed that is wider than the resolution.
    fn part(
        &mut self,
        depth: usize,
        resolution: f64,
        (a, before): (f64, u64),
        (b, after): (f64, u64),
        found: &mut impl FnMut(f64, u64),
    ) {
        if before == after {
            return;
        }
        let middle = 0.5 * (a + b);
        if middle <= a || middle >= b || b - a < resolution * a.abs().max(1.0) {
            return found(b, after);
        }
        let here = self.pattern(depth, middle);
        self.part(depth, resolution, (a, before), (middle, here), found);
        self.part(depth, resolution, (middle, here), (b, after), found);
    }

    /// The pattern at a value of the normal with number `depth`: the signature there, or the list of those along the next one.
    fn pattern(&mut self, depth: usize, u: f64) -> u64 {
        self.point[depth] = u;
        if depth + 1 == self.point.len() {
            self.evaluations += 1;
            return self.frame.evaluate(&self.point, &mut self.scratch);
        }
        let mut last = self.pattern(depth + 1, -REACH);
        let mut list = mixed(0, last);
        for i in 1..=INNER_SCAN {
            let (a, b) = (step(i - 1, INNER_SCAN), step(i, INNER_SCAN));
            let here = self.pattern(depth + 1, b);
            self.part(depth + 1, COARSE, (a, last), (b, here), &mut |_, then| list = mixed(list, then));
            last = here;
        }
        list
    }
}

/// The value after `i` of so many steps from −12 to 12.
fn step(i: usize, of: usize) -> f64 {
    REACH * (2.0 * i as f64 / of as f64 - 1.0)
}
