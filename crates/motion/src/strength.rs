//! How much stronger, or weaker, the loads of a motion have to be for another verdict.
//!
//! Every history is multiplied by one factor s; what acts without end stays as it is. The factor at which a body at rest begins to move is
//! exact: each margin of rest is A + s B(t), so that
//!
//! ```text
//! s = min over t of −A/B, where B < 0        μ_s P ∓ X,   b₁P + (dX − M),   b₂P − (dX − M)
//! ```
//!
//! at the breaks of lines and at the extremes of sines. Whether a body overturns under a factor only its motion tells. Such verdicts may
//! change at many factors, in windows of any width: those that are [tried](Factors) are a sample, of which the nearest change and the
//! share that differs are told, with the step beside it.

use crate::error::MotionError;
use crate::forcing::{Channels, Forcing};
use crate::machine::{Keep, simulate};
use crate::outcome::{End, MotionOutcome};
use crate::problem::{Initial, MotionProblem};
use standfast::history::History;
use standfast_watch::Portion;

/// Factors at which a motion is tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Factors {
    /// Steps of 0.5 % up to 5 %, 1 % up to 10 %, 2 % up to 20 %, to both sides; then 1.35, 1.5 and 2, and one over these: 46 in all.
    #[default]
    Rungs,
    /// So many even ones within 20 %, half of them to either side, one more if they are odd; 1 is not among them.
    Even(usize),
}

impl Factors {
    /// The factors, rising.
    pub fn values(self) -> Vec<f64> {
        match self {
            Factors::Rungs => {
                let near = (1..=10).map(|step| 0.005 * f64::from(step));
                let next = (6..=10).map(|step| 0.01 * f64::from(step));
                let far = (6..=10).map(|step| 0.02 * f64::from(step));
                let steps: Vec<f64> = near.chain(next).chain(far).collect();
                let beyond = [1.35, 1.5, 2.0];
                let less = beyond.map(|factor| 1.0 / factor).into_iter().rev();
                let below = steps.iter().rev().map(|step| 1.0 - step);
                let above = steps.iter().map(|step| 1.0 + step);
                less.chain(below).chain(above).chain(beyond).collect()
            }
            Factors::Even(count) => {
                // Half of them to either side.
                let half = count.div_ceil(2).max(1);
                let step = 0.2 / half as f64;
                let places =
                    (1..=half).rev().map(|place| -(place as f64)).chain((1..=half).map(|place| place as f64));
                places.map(|place| 1.0 + step * place).collect()
            }
        }
    }
}

/// Motion under the loads times a factor, as far as a verdict asks.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Tried {
    /// The factor.
    pub factor: f64,
    /// True if the body overturns.
    pub overturned: bool,
    /// True if the motion was followed to its end.
    pub ended: bool,
    /// The largest |θ|.
    pub max_theta: f64,
    /// |slide| at the end.
    pub slide: f64,
}

impl Tried {
    /// That of a motion.
    pub fn of(factor: f64, outcome: &MotionOutcome) -> Tried {
        Tried {
            factor,
            overturned: outcome.overturned(),
            ended: matches!(outcome.end, End::AtRest | End::Overturned),
            max_theta: outcome.max_theta,
            slide: outcome.slide.abs(),
        }
    }

    /// That of a problem with its loads times a factor; what acts without end stays.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn under(problem: &MotionProblem, factor: f64) -> Result<Tried, MotionError> {
        simulate(&scaled(problem, factor), Keep::default()).map(|outcome| Tried::of(factor, &outcome))
    }

    /// True if the body does not come to rest within a distance of where it was: it slides farther, overturns, or is not followed so far.
    pub fn is_beyond(&self, distance: f64) -> bool {
        !self.ended || self.overturned || self.slide > distance
    }

    /// True if the body does not keep within an angle: it turns farther, overturns, or is not followed so far.
    pub fn is_turned_beyond(&self, angle: f64) -> bool {
        !self.ended || self.overturned || self.max_theta > angle
    }
}

/// Nearest factor found, to one side, at which a verdict is another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The factor of a motion with the other verdict.
    pub factor: f64,
    /// The factor nearest to it of a motion with the verdict of the case.
    pub same: f64,
}

/// How a verdict depends on the strength of the loads.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct VerdictStrength {
    /// The verdict of the case itself.
    pub verdict: bool,
    /// The nearest change found above 1.
    pub up: Option<Change>,
    /// The nearest change found below 1.
    pub down: Option<Change>,
    /// Of the factors within 5, 10 and 20 %, the share with the other verdict.
    pub share: [f64; 3],
    /// True if the verdict changes more than once among the factors on one side, or on both sides.
    pub windows: bool,
}

/// Distances from 1 within which the share that differs is told.
pub const WITHIN: [f64; 3] = [0.05, 0.10, 0.20];

/// A motion under its loads times factors.
#[derive(Debug, Clone)]
pub struct Strengths<'a> {
    problem: &'a MotionProblem,
    itself: Tried,
    /// The motions that were tried, their factors rising; the case itself is not among them.
    pub tried: Vec<Tried>,
}

impl<'a> Strengths<'a> {
    /// Tries a problem, whose own motion is `outcome`, at factors on its loads.
    ///
    /// # Errors
    /// As [`simulate`]; if the portion is stopped.
    pub fn of(
        problem: &'a MotionProblem,
        outcome: &MotionOutcome,
        factors: Factors,
        portion: Portion<'_>,
    ) -> Result<Strengths<'a>, MotionError> {
        let values = factors.values();
        let steps = portion.steps(values.len());
        let one = |factor| {
            portion.check()?;
            let tried = Tried::under(problem, factor)?;
            steps.advance();
            Ok(tried)
        };
        let tried = values.into_iter().map(one).collect::<Result<_, MotionError>>()?;
        Ok(Strengths::of_tried(problem, outcome, tried))
    }

    /// The same of motions that were tried before, their factors rising.
    pub fn of_tried(problem: &'a MotionProblem, outcome: &MotionOutcome, tried: Vec<Tried>) -> Strengths<'a> {
        Strengths { problem, itself: Tried::of(1.0, outcome), tried }
    }

    /// How a verdict changes with the factor.
    ///
    /// # Errors
    /// As [`simulate`].
    pub fn verdict(&self, holds: impl Fn(&Tried) -> bool) -> Result<VerdictStrength, MotionError> {
        let verdict = holds(&self.itself);
        let above: Vec<&Tried> = self.tried.iter().filter(|tried| tried.factor > 1.0).collect();
        let below: Vec<&Tried> = self.tried.iter().rev().filter(|tried| tried.factor < 1.0).collect();
        let nearest = |side: &[&Tried]| -> Result<Option<Change>, MotionError> {
            let Some(place) = side.iter().position(|tried| holds(tried) != verdict) else { return Ok(None) };
            let same = if place == 0 { 1.0 } else { side[place - 1].factor };
            let mut change = Change { factor: side[place].factor, same };
            let near = 0.01 * (change.factor - same).abs();
            while (change.factor - change.same).abs() > near {
                let middle = 0.5 * (change.factor + change.same);
                match holds(&Tried::under(self.problem, middle)?) == verdict {
                    true => change.same = middle,
                    false => change.factor = middle,
                }
            }
            Ok(Some(change))
        };
        let [up, down] = [nearest(&above)?, nearest(&below)?];
        let share = WITHIN.map(|within| {
            let near = self.tried.iter().filter(|tried| (tried.factor - 1.0).abs() <= within + 1e-9);
            let near: Vec<bool> = near.map(|tried| holds(tried) != verdict).collect();
            near.iter().filter(|differs| **differs).count() as f64 / near.len().max(1) as f64
        });
        let turns = |side: &[&Tried]| {
            let verdicts: Vec<bool> =
                std::iter::once(verdict).chain(side.iter().map(|tried| holds(tried))).collect();
            verdicts.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        let turns = [turns(&above), turns(&below)];
        let windows = turns.iter().any(|turns| *turns > 1) || turns.iter().all(|turns| *turns > 0);
        Ok(VerdictStrength { verdict, up, down, share, windows })
    }
}

/// A problem with its loads times a factor; what acts without end stays.
fn scaled(problem: &MotionProblem, factor: f64) -> MotionProblem {
    let mut scaled = problem.clone();
    let times = |history: &mut History| {
        if history.end().is_finite() {
            *history = history.clone().times_factor(factor);
        }
    };
    scaled.loads.iter_mut().for_each(|load| times(&mut load.history));
    [&mut scaled.base.horizontal, &mut scaled.base.vertical].into_iter().flatten().for_each(times);
    scaled
}

/// The factor on the loads at which a body at rest begins to move; 0 if it does without them, `None` if no factor moves it, or if it does
/// not begin at rest.
///
/// # Errors
/// If the problem is refused.
pub fn onset(problem: &MotionProblem) -> Result<Option<f64>, MotionError> {
    problem.check()?;
    if problem.initial != Initial::default() {
        return Ok(None);
    }
    let [full, still] = [problem.clone(), scaled(problem, 0.0)].map(|problem| Forcing::new(&problem));
    let mut channels = Channels::EMPTY;
    let mut margins = |forcing: &Forcing, segment: usize, t: f64| {
        forcing.channels(segment, t, 2, &mut channels);
        let [x, p, m] = channels.wrench(0.0);
        let block = &problem.block;
        let moment = block.d * x - m;
        let margins = [block.mu_s * p - x, block.mu_s * p + x, block.b1 * p + moment, block.b2 * p - moment];
        (margins, channels.fastest)
    };
    let mut least = f64::INFINITY;
    for segment in 0..=full.breaks.len() {
        let (start, stop) = (full.start(segment), full.stop(segment));
        let fastest = margins(&full, segment, start).1;
        // The load factor of a margin at a moment: infinite where the loads do not lessen it.
        let mut at = |which: usize, t: f64| {
            let (with, without) = (margins(&full, segment, t).0[which], margins(&still, segment, t).0[which]);
            match with - without {
                _ if without < 0.0 => 0.0,
                more if more < 0.0 => -without / more,
                _ => f64::INFINITY,
            }
        };
        for which in 0..4 {
            let mut times = vec![start];
            if stop.is_finite() {
                let pieces =
                    if fastest > 0.0 { (16.0 * (stop - start) * fastest).ceil().max(1.0) } else { 1.0 };
                times.extend(
                    (1..=pieces as usize).map(|place| start + (stop - start) * place as f64 / pieces),
                );
            }
            let values: Vec<f64> = times.iter().map(|t| at(which, *t)).collect();
            least = values.iter().copied().fold(least, f64::min);
            for place in 1..values.len().saturating_sub(1) {
                if fastest > 0.0 && values[place] <= values[place - 1] && values[place] <= values[place + 1] {
                    least = least.min(lowest(|t| at(which, t), times[place - 1], times[place + 1]));
                }
            }
        }
    }
    Ok(Some(least).filter(|least| least.is_finite()))
}

/// The least value of a function with one minimum between two moments, by golden sections.
fn lowest(mut of: impl FnMut(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..60 {
        let [one, two] = [to - golden * (to - from), from + golden * (to - from)];
        if of(one) < of(two) { to = two } else { from = one }
    }
    of(0.5 * (from + to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use standfast::contact::Block;

    fn shaken(block: Block, history: History) -> MotionProblem {
        let mut problem = MotionProblem::new(block, 9.81);
        problem.base.horizontal = Some(history);
        problem
    }

    /// The factors between which a block under one pulse overturns or not, by halving alone.
    fn boundary(problem: &MotionProblem) -> [f64; 2] {
        let over = |factor: f64| simulate(&scaled(problem, factor), Keep::default()).unwrap().overturned();
        let (mut stands, mut falls) = (0.1, 20.0);
        for _ in 0..60 {
            let middle = 0.5 * (stands + falls);
            if over(middle) { falls = middle } else { stands = middle }
        }
        [stands, falls]
    }

    #[test]
    fn factors_rise_about_one() {
        for factors in [Factors::Rungs, Factors::Even(40), Factors::Even(7)] {
            let values = factors.values();
            assert!(values.windows(2).all(|pair| pair[0] < pair[1]) && !values.contains(&1.0), "{values:?}");
            let within = |share: f64| values.iter().filter(|x| (*x - 1.0).abs() <= share + 1e-9).count();
            match factors {
                Factors::Rungs => {
                    assert_eq!((values.len(), within(0.05), within(0.1), within(0.2)), (46, 20, 30, 40))
                }
                Factors::Even(count) => assert_eq!(values.len() / 2, count.div_ceil(2)),
            }
        }
        assert_eq!(Factors::Rungs.values()[0], 0.5);
    }

    /// A uniform block γ high slides beyond μ g and rocks beyond g/γ, under a peak of any shape, alone or with a push that stays.
    #[test]
    fn onset_by_hand() {
        let peak = 2.0;
        let shapes = [
            History::half_sine(peak, 0.7).unwrap(),
            History::sine(peak, 9.0, 0.3, 3.0).unwrap(),
            History::triangle(peak, 0.2, 0.5).unwrap(),
            History::rect(peak, 0.3).unwrap(),
            History::samples(0.1, &[0.0, 1.0, -2.0, 0.5]).unwrap(),
        ];
        for (d, μ) in [(3.0, 0.6), (0.5, 0.3), (2.0, 0.45)] {
            for shape in &shapes {
                let problem = shaken(Block::uniform(d, μ), shape.clone());
                let expected = 9.81 * μ.min(1.0 / d) / peak;
                let found = onset(&problem).unwrap().unwrap();
                assert!((found / expected - 1.0).abs() < 1e-9, "{shape:?} {d} {μ}: {found} {expected}");
            }
        }
        // A push of 0.1 g to the right stays; inertia against the base pushes to the left for a positive peak.
        let mut pushed = shaken(Block::uniform(0.5, 0.3), History::rect(peak, 0.3).unwrap());
        pushed.loads.push(crate::LoadInTime {
            at: [0.0, 0.0],
            direction: [1.0, 0.0],
            follows: false,
            history: History::constant(0.981).unwrap(),
        });
        let found = onset(&pushed).unwrap().unwrap();
        assert!((found - (0.3 + 0.1) * 9.81 / peak).abs() < 1e-9, "{found}");
        // No factor moves a body that nothing shakes; one that is pushed too much moves without.
        assert_eq!(onset(&MotionProblem::new(Block::uniform(1.0, 0.5), 9.81)).unwrap(), None);
        pushed.loads[0].history = History::constant(4.0).unwrap();
        assert_eq!(onset(&pushed).unwrap(), Some(0.0));
    }

    /// Where the first factor that is tried changes the verdict, the change lies between it and the case itself.
    #[test]
    fn a_change_next_to_the_case() {
        let problem = shaken(Block::uniform(4.0, 5.0), History::half_sine(5.0, 0.8).unwrap());
        let [stands, _] = boundary(&problem);
        let case = scaled(&problem, stands / 1.002);
        let outcome = simulate(&case, Keep::default()).unwrap();
        let found = Strengths::of(&case, &outcome, Factors::Rungs, Portion::UNSEEN).unwrap();
        let up = found.verdict(|tried| tried.overturned).unwrap().up.unwrap();
        assert!((1.0..=1.002).contains(&up.same) && (1.002..1.0021).contains(&up.factor), "{up:?}");
    }

    /// Just below the onset the body rests, just above it moves; with two sines, a base that goes up and down, and an eccentric body.
    #[test]
    fn onset_is_where_the_motion_begins() {
        let block = Block { b1: 0.9, b2: 1.1, d: 1.7, rho2: 1.3, m_x: 1.0, m_y: 1.0, mu_s: 0.5, mu_k: 0.4 };
        let mut problem = shaken(block, History::sine(3.0, 7.0, 0.4, 2.0).unwrap());
        problem.base.vertical = Some(History::sine(1.5, 11.0, 1.0, 2.5).unwrap());
        problem.loads.push(crate::LoadInTime {
            at: [0.3, 0.8],
            direction: [-0.7, 0.2],
            follows: false,
            history: History::half_sine(1.3, 0.9).unwrap(),
        });
        let found = onset(&problem).unwrap().unwrap();
        let moves = |factor: f64| {
            let outcome = simulate(&scaled(&problem, factor), Keep::default()).unwrap();
            outcome.events.iter().any(|event| event.state != standfast::Mode::Rest)
        };
        assert!(!moves(found * (1.0 - 1e-6)) && moves(found * (1.0 + 1e-6)), "{found}");
    }

    /// A block under one pulse overturns from a factor on that bisection by hand finds, too; weaker ones leave it standing.
    #[test]
    fn a_change_is_bracketed_by_motions() {
        let problem = shaken(Block::uniform(4.0, 5.0), History::half_sine(5.0, 0.8).unwrap());
        let [stands, falls] = boundary(&problem);
        // Seen from 2 % below the boundary and from 2 % above it.
        for (itself, verdict) in [(0.98 * stands, false), (1.02 * falls, true)] {
            let case = scaled(&problem, itself);
            let outcome = simulate(&case, Keep::default()).unwrap();
            let strengths = Strengths::of(&case, &outcome, Factors::Rungs, Portion::UNSEEN).unwrap();
            let found = strengths.verdict(|tried| tried.overturned).unwrap();
            assert_eq!(found.verdict, verdict);
            let change = if verdict { found.down } else { found.up }.unwrap();
            let [low, high] =
                [change.factor.min(change.same) * itself, change.factor.max(change.same) * itself];
            assert!(low <= stands && stands <= high, "{low} {stands} {high}");
            assert!((high / low - 1.0) < 1e-4, "{change:?}");
            assert_eq!(if verdict { found.up } else { found.down }, None);
            // Beyond the change all are the other: of 20, 30 and 40 factors those from 1.025 on, as 1/0.98 is more than 1.02; or from 0.98 down, as
            // 1/1.02 is more than that.
            let beyond = if verdict { [7.0, 12.0, 17.0] } else { [6.0, 11.0, 16.0] };
            assert_eq!(found.share, [beyond[0] / 20.0, beyond[1] / 30.0, beyond[2] / 40.0]);
            assert!(!found.windows);
        }
    }
}
