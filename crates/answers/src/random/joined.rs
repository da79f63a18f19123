//! Several sets of loads joined: whether *any* of them moves the body, all under the same draw.
//!
//! An earthquake shakes to both sides, so that a body rests only if it does so under each sign; forces that act alone, and
//! combinations, are each a case of its own, and the chance that any of them would move the body is at least that of the worst
//! and at most their sum. Along the number that is not sampled the body rests on the intervals that all of them have in common.

use standfast_probability::form::local_design_points;
use standfast_probability::problem::{Outcomes, Pieces};
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::answer::ChanceRequest;
use super::chances;
use super::error::ProbabilityError;
use super::problem::ChanceProblem;
use standfast_probability::method::{Method, by};

/// The chance that any of several sets of loads moves the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JoinedChance {
    /// Number of sets of loads.
    pub count: usize,
    /// Method by which it was found.
    pub method: Method,
    /// That the body does not stay at rest under one of them at least.
    pub not_rest: Estimate,
}

/// The body rests under all of them, or not.
const RESTS: usize = 0;
pub(super) const MOVES: usize = 1;

/// Problems with the same random numbers.
pub(super) struct AnyOf<'a>(pub(super) Vec<&'a ChanceProblem>);

impl Outcomes for AnyOf<'_> {
    fn count(&self) -> usize {
        2
    }

    fn line(&self) -> usize {
        self.0[0].line()
    }

    fn is_quick(&self, input: usize) -> bool {
        self.0[0].is_quick(input)
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        // Each interval with the problems that end it, for the probability has a kink where another one does.
        let mut common = vec![((f64::NEG_INFINITY, f64::INFINITY), [0, 0])];
        for (place, problem) in self.0.iter().enumerate() {
            let mut own = Pieces::default();
            problem.along(values, &mut own);
            pieces.branch(own.signature());
            let rests: Vec<(f64, f64)> = own
                .iter()
                .filter(|piece| piece.outcome == RESTS)
                .map(|piece| (piece.from, piece.to))
                .collect();
            common = common
                .iter()
                .flat_map(|&((from, to), by)| {
                    rests.iter().map(move |&(low, high)| {
                        let by =
                            [if low > from { place } else { by[0] }, if high < to { place } else { by[1] }];
                        ((from.max(low), to.min(high)), by)
                    })
                })
                .filter(|((from, to), _)| from < to)
                .collect();
        }
        standfast::order::by_number(&mut common, |one| one.0.0);
        let mut end = f64::NEG_INFINITY;
        for ((from, to), by) in common {
            pieces.push(end, from, MOVES);
            pieces.push(from, to, RESTS);
            by.into_iter().for_each(|by| pieces.branch(by as u64));
            end = to;
        }
        pieces.push(end, f64::INFINITY, MOVES);
    }

    fn at(&self, values: &[f64]) -> u64 {
        let rests = self.0.iter().all(|problem| problem.at(values) >> RESTS & 1 == 1);
        1 << if rests { RESTS } else { MOVES }
    }
}

/// The chance that any of the problems moves the body; none of a single one.
///
/// # Errors
/// If the method asked for does not take as many numbers.
pub(super) fn joined(
    problems: &[&ChanceProblem],
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Option<JoinedChance>, ProbabilityError> {
    let [first, _, ..] = problems else { return Ok(None) };
    let any = AnyOf(problems.to_vec());
    let points = local_design_points(first.laws(), &any, 1 << MOVES);
    let method = chances::method(first, request, &points)?;
    let about: Vec<Vec<f64>> = points.into_iter().map(|point| point.u).collect();
    let work = (request.effort.within(portion), first.cost());
    let found = by(method, first.laws(), &any, &[1 << MOVES], &about, work);
    portion.check()?;
    let not_rest = found.sampled.estimates[0];
    Ok(Some(JoinedChance { count: problems.len(), method: found.method, not_rest }))
}
