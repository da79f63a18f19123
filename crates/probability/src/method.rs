//! Methods by their names, each with what it takes; an integration that its bounds leave too coarse gives way to Sobol' points.

use std::fmt;

use standfast_watch::Portion;

use crate::integrate::{Integrated, MOST_DIMENSIONS, OutOfBounds, Within, integrate, integrate_known};
use crate::points::MOST_COORDINATES;
use crate::problem::{Outcomes, RandomVector};
use crate::sample::{Effort, Estimate, Sampled, Work, importance, monte_carlo, sampled_known, sobol};

/// Method by which probabilities are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Integration between the kinks: all digits, three random numbers at most.
    Integrate,
    /// Scrambled Sobol' points.
    Sobol,
    /// Scrambled Sobol' points about the design points.
    Importance,
    /// Everything drawn, nothing integrated.
    MonteCarlo,
}

/// Index above which probabilities are looked for about the design points.
const FAR: f64 = 2.5;

impl Method {
    /// All of them.
    pub const ALL: [Method; 4] = [Method::Integrate, Method::Sobol, Method::Importance, Method::MonteCarlo];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Method::Integrate => "integrate",
            Method::Sobol => "sobol",
            Method::Importance => "importance",
            Method::MonteCarlo => "monte-carlo",
        }
    }

    /// The method of a name.
    pub fn find(name: &str) -> Option<Method> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }

    /// The most random numbers that it takes; `None` where there is no bound.
    pub fn most_numbers(self) -> Option<usize> {
        match self {
            Method::Integrate => Some(MOST_DIMENSIONS + 1),
            Method::Sobol | Method::Importance => Some(MOST_COORDINATES),
            Method::MonteCarlo => None,
        }
    }

    /// The one that suits so many numbers, of which so many may be integrated, and an outcome with this index.
    pub fn suited(numbers: usize, integrated: usize, beta: Option<f64>) -> Method {
        match beta {
            _ if numbers <= integrated => Method::Integrate,
            Some(beta) if beta > FAR => Method::Importance,
            _ => Method::Sobol,
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Probabilities of sets of outcomes, and the method by which they were found.
#[derive(Debug, Clone)]
pub struct Found {
    /// Method that was taken.
    pub method: Method,
    /// Its probabilities.
    pub sampled: Sampled,
    /// True if an integration was begun and given up.
    pub given_up: bool,
}

/// The probabilities of sets of outcomes by a method; about these points where it takes any. `cost` is what the pieces of a line cost, in decisions. An
/// integration that its bounds do not leave as precise as asked is given up for Sobol' points.
///
/// # Panics
/// For more inputs than the method takes.
pub fn by<O: Outcomes>(
    method: Method,
    laws: &RandomVector,
    outcomes: &O,
    sets: &[u64],
    about: &[Vec<f64>],
    (work, cost): (Work<'_>, u64),
) -> Found {
    let sampled = match method {
        Method::Integrate => {
            let [integral, points] = work.portion.parts([1.0, 1.0]);
            let integrated = integrate(laws, outcomes, sets, within(&work.effort, cost, integral));
            return integral_or(integrated, &work.effort, || {
                sobol(laws, outcomes, sets, work.effort.within(points))
            });
        }
        Method::Sobol => sobol(laws, outcomes, sets, work),
        Method::Importance => importance(laws, outcomes, sets, about, work),
        Method::MonteCarlo => monte_carlo(laws, outcomes, sets, work),
    };
    Found { method, sampled, given_up: false }
}

/// The probability of one set with the input of this number held at its median: integrated where there are few inputs, else drawn, about the points, with
/// so many at most.
pub fn by_known<O: Outcomes>(
    laws: &RandomVector,
    outcomes: &O,
    set: u64,
    known: usize,
    (about, most): (&[Vec<f64>], u64),
    (work, cost): (Work<'_>, u64),
) -> Estimate {
    let effort = Effort { points: most.min(work.effort.points), ..work.effort };
    let drawn = || sampled_known(laws, outcomes, &[set], known, about, effort.within(work.portion));
    let sampled = if laws.laws().len() <= MOST_DIMENSIONS + 1 {
        let within = within(&work.effort, cost, work.portion);
        integral_or(integrate_known(laws, outcomes, &[set], known, within), &work.effort, drawn).sampled
    } else {
        drawn()
    };
    sampled.estimates[0]
}

/// Bounds of an integration: a floor of a millionth leaves a probability of 1e-16 its digits.
pub fn within<'w>(effort: &Effort, cost: u64, portion: Portion<'w>) -> Within<'w> {
    /// The most evaluations of an integral of which each costs no more than one decision: seldom more than a second. What takes more is as
    /// precise as it is asked to be by far fewer Sobol' points.
    const MOST: u64 = 1 << 19;
    /// Digits below the floor that are sought.
    const BELOW_FLOOR: f64 = 1e-12;
    let evaluations = (effort.points.min(MOST) / cost).max(1);
    Within { negligible: BELOW_FLOOR * effort.floor, evaluations, portion }
}

/// An integral where it is as precise as asked, or what takes its place.
pub fn integral_or(
    integrated: Result<Integrated, OutOfBounds>,
    effort: &Effort,
    otherwise: impl FnOnce() -> Sampled,
) -> Found {
    let found = integrated.map(|integrated| estimates(&integrated)).ok();
    let precise = |sampled: &Sampled| {
        sampled.estimates.iter().all(|estimate| estimate.is_precise(effort.precision, effort.floor))
    };
    match found.filter(precise) {
        Some(sampled) => Found { method: Method::Integrate, sampled, given_up: false },
        None => Found { method: Method::Sobol, sampled: otherwise(), given_up: true },
    }
}

/// Integrals with their errors as intervals.
pub fn estimates(integrated: &Integrated) -> Sampled {
    let with = |(value, error): (&f64, &f64)| {
        let value = value.clamp(0.0, 1.0);
        Estimate { value, low: (value - error).max(0.0), high: (value + error).min(1.0) }
    };
    Sampled {
        estimates: integrated.probabilities.iter().zip(&integrated.errors).map(with).collect(),
        points: integrated.evaluations,
        precise: true,
        course: Vec::new(),
    }
}
