//! Copies of a motion: the same case with numbers a little other, many times, where one motion is no answer.
//!
//! Each copy multiplies every number by exp(σz), z standard normal and independent: the width, the height of the centre of mass, the moment of inertia,
//! friction, friction at impacts, the water that moves along, the strength of every history (of the base in both directions one), a ratio or what it
//! follows from, restitution, and the angle of a body that is released from a tilt. Gravity, times and directions are as they are.
//!
//! z of copy i and a name hangs on (seed, i, name) alone, so that more copies have the first ones among them, for any number of threads:
//!
//! ```text
//! s = seed;  s = mix(s ⊕ i·φ);  s = mix(s ⊕ hash(name)·φ)      φ = 0x9e3779b97f4a7c15
//! mix(s): s += φ;  s = (s ⊕ s≫30)·0xbf58476d1ce4e5b9;  s = (s ⊕ s≫27)·0x94d049bb133111eb;  s ⊕ s≫31
//! z = Φ⁻¹(((s ≫ 11) + ½)/2⁵³)                                  hash: FNV-1a, 64 bits
//! ```
//!
//! [`mix`] is splitmix64's.

use standfast_model::{CopiesAsked, Spread};
use standfast_motion::{Event, Impact, Keep, MotionError, MotionOutcome, MotionProblem, simulate};
use standfast_probability::normal;
use standfast_probability::sample::{Estimate, around_quantile};
use standfast_watch::Portion;

use super::spectrum::in_order;

/// Outcomes of copies.
#[derive(Debug, Clone, PartialEq)]
pub struct Copies {
    /// Copies that were asked for.
    pub asked: CopiesAsked,
    /// The names of the numbers that differ.
    pub names: Vec<String>,
    /// σ of each.
    pub spreads: Vec<f64>,
    /// Each copy, in its order.
    pub rows: Vec<Copy>,
    /// Number of copies whose ratio or restitution was cut at its limit.
    pub cut: usize,
    /// Copies that overturn: their share with its interval of Clopper and Pearson, 95 %.
    pub overturned: Estimate,
    /// Copies with the verdict of the case itself, overturned or not.
    pub same_verdict: Estimate,
    /// Earliest event whose reason or state differs from that of the case itself, over copies.
    pub differs: Option<Differs>,
}

/// A copy.
#[derive(Debug, Clone, PartialEq)]
pub struct Copy {
    /// Factor on each number.
    pub factors: Vec<f64>,
    /// True if it overturns.
    pub overturned: bool,
    /// The word for its end.
    pub end: &'static str,
    /// The largest |θ|; infinite of one that overturns.
    pub max_theta: f64,
    /// Its slide; `None` of one that overturns.
    pub slide: Option<f64>,
    /// Its largest |slide|; `None` of one that overturns.
    pub max_slide: Option<f64>,
    /// Place and time of the first event that differs from the case's own; `None` where none does.
    pub differs: Option<(usize, f64)>,
}

/// Earliest events that differ from those of the case itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differs {
    /// Number of copies that part from the case at any event.
    pub copies: usize,
    /// Place of the event among the case's, the median over these copies and the least.
    pub place: [usize; 2],
    /// Its time, the median and the least.
    pub t: [f64; 2],
}

/// A quantile over copies, with the interval that order statistics give where there are enough of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CopyQuantile {
    /// The share of copies below it.
    pub share: f64,
    /// The value.
    pub value: f64,
    /// Its interval, 95 %.
    pub interval: Option<[f64; 2]>,
}

/// The shares whose quantiles are told.
const SHARES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];
/// Fewer have no interval of 95 % about their outer quantiles.
const ENOUGH: usize = 59;

/// A number of a motion that differs from copy to copy.
struct Varied {
    name: String,
    /// Puts it times a factor, and says whether it was cut at its limit.
    put: fn(&mut MotionProblem, usize, f64) -> bool,
    /// Place of a history.
    place: usize,
}

impl Copies {
    /// The copies of a motion, of which `outcome` is that of the case itself.
    ///
    /// # Errors
    /// If a copy is refused, or the work is stopped.
    pub fn of(
        problem: &MotionProblem,
        outcome: &MotionOutcome,
        asked: &CopiesAsked,
        threads: usize,
        portion: Portion<'_>,
    ) -> Result<Copies, MotionError> {
        let varied = scattered(problem, &asked.spread)?;
        let numbers: Vec<u64> = (1..=asked.number as u64).collect();
        let one = |number: &u64| -> Result<(Copy, bool), MotionError> {
            let mut copy = problem.clone();
            let mut is_cut = false;
            let mut factors = Vec::with_capacity(varied.len());
            for (varied, σ) in &varied {
                let factor = (σ * drawn(asked.seed, *number, &varied.name)).exp();
                is_cut |= (varied.put)(&mut copy, varied.place, factor);
                factors.push(factor);
            }
            Ok((Copy::of(&simulate(&copy, Keep::default())?, outcome, factors), is_cut))
        };
        let all = in_order(&numbers, threads, portion, one)?;
        let all = all.into_iter().collect::<Result<Vec<_>, _>>()?;
        let cut = all.iter().filter(|(_, is_cut)| *is_cut).count();
        let rows: Vec<Copy> = all.into_iter().map(|(row, _)| row).collect();
        let share = |of: &dyn Fn(&Copy) -> bool| {
            Estimate::two_sided(rows.iter().filter(|row| of(row)).count() as u64, rows.len() as u64)
        };
        let own = outcome.overturned();
        let (overturned, same_verdict) = (share(&|row| row.overturned), share(&|row| row.overturned == own));
        Ok(Copies {
            asked: asked.clone(),
            spreads: varied.iter().map(|(_, σ)| *σ).collect(),
            names: varied.into_iter().map(|(varied, _)| varied.name).collect(),
            cut,
            overturned,
            same_verdict,
            differs: Differs::of(&rows),
            rows,
        })
    }

    /// Number of copies that overturn.
    pub fn overturning(&self) -> usize {
        self.rows.iter().filter(|row| row.overturned).count()
    }

    /// Number of copies with this word for an end.
    pub fn ended(&self, end: &str) -> usize {
        self.rows.iter().filter(|row| row.end == end).count()
    }

    /// Every copy as a row of CSV: factors by their names, and outcomes.
    pub fn csv(&self) -> String {
        let results = ["end", "overturned", "max_theta", "slide", "max_slide"].map(str::to_owned);
        let head: Vec<String> =
            std::iter::once("copy".to_owned()).chain(self.names.iter().cloned()).chain(results).collect();
        let mut text = head.join(",") + "\n";
        for (place, row) in self.rows.iter().enumerate() {
            let mut cells = vec![(place + 1).to_string()];
            cells.extend(row.factors.iter().map(f64::to_string));
            cells.extend([row.end.to_owned(), row.overturned.to_string()]);
            let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
            cells.extend([
                number((!row.overturned).then_some(row.max_theta)),
                number(row.slide),
                number(row.max_slide),
            ]);
            text += &(cells.join(",") + "\n");
        }
        text
    }

    /// Quantiles of the largest |θ|.
    pub fn max_theta(&self) -> Vec<CopyQuantile> {
        quantiles(self.rows.iter().map(|row| row.max_theta).collect())
    }

    /// Quantiles of the |slide| of copies that do not overturn.
    pub fn slide(&self) -> Vec<CopyQuantile> {
        quantiles(self.rows.iter().filter_map(|row| Some(row.slide?.abs())).collect())
    }

    /// Quantiles of the largest |slide| of copies that do not overturn.
    pub fn max_slide(&self) -> Vec<CopyQuantile> {
        quantiles(self.rows.iter().filter_map(|row| row.max_slide).collect())
    }
}

impl Copy {
    fn of(outcome: &MotionOutcome, own: &MotionOutcome, factors: Vec<f64>) -> Copy {
        let overturned = outcome.overturned();
        let is_other = |(one, two): (&Event, &Event)| one.why != two.why || one.state != two.state;
        let pairs = outcome.events.iter().zip(&own.events);
        let differs = pairs.into_iter().position(is_other);
        // A list that goes on where the other ends differs there.
        let (few, many) = (outcome.events.len(), own.events.len());
        let differs = differs.or_else(|| (few != many).then(|| few.min(many)));
        let t = |place: usize| {
            let event = own.events.get(place).or_else(|| outcome.events.get(place));
            event.map_or(own.t_final, |event| event.t)
        };
        Copy {
            factors,
            overturned,
            end: outcome.end.word(),
            max_theta: if overturned { f64::INFINITY } else { outcome.max_theta },
            slide: (!overturned).then_some(outcome.slide),
            max_slide: (!overturned).then_some(outcome.max_slide),
            differs: differs.map(|place| (place, t(place))),
        }
    }
}

impl Differs {
    fn of(rows: &[Copy]) -> Option<Differs> {
        let mut all: Vec<(usize, f64)> = rows.iter().filter_map(|row| row.differs).collect();
        all.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let middle = *all.get((all.len().max(1) - 1) / 2)?;
        Some(Differs { copies: all.len(), place: [middle.0, all[0].0], t: [middle.1, all[0].1] })
    }
}

/// Quantiles of values: of so many the ones at their places, and the order statistics that enclose the quantile with 95 %.
fn quantiles(mut values: Vec<f64>) -> Vec<CopyQuantile> {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    let of = |share: f64| {
        let place = ((share * n as f64).ceil() as usize).clamp(1, n);
        let places = if n >= ENOUGH { around_quantile(share, n as u64) } else { None };
        let interval = places.map(|places| places.map(|place| values[place as usize - 1]));
        CopyQuantile { share, value: values[place - 1], interval }
    };
    if n == 0 { Vec::new() } else { SHARES.map(of).to_vec() }
}

/// The numbers of a motion that scatter, each with its σ.
fn scattered(problem: &MotionProblem, spread: &Spread) -> Result<Vec<(Varied, f64)>, MotionError> {
    let all = varied(problem);
    let named = match spread {
        Spread::Even(σ) => return Ok(all.into_iter().map(|varied| (varied, *σ)).collect()),
        Spread::Named(named) => named,
    };
    if let Some((name, _)) = named.iter().find(|(name, _)| all.iter().all(|varied| varied.name != *name)) {
        let names: Vec<&str> = all.iter().map(|varied| varied.name.as_str()).collect();
        return Err(MotionError::NoSpread { name: name.clone(), names: names.join(", ") });
    }
    let σ = |varied: &Varied| named.iter().find(|(name, _)| *name == varied.name).map(|(_, σ)| *σ);
    Ok(all.into_iter().filter_map(|varied| σ(&varied).map(|σ| (varied, σ))).collect())
}

/// The numbers of a motion that differ from copy to copy, each with its name.
fn varied(problem: &MotionProblem) -> Vec<Varied> {
    type Put = fn(&mut MotionProblem, usize, f64) -> bool;
    let mut all = Vec::new();
    let mut add = |is_there: bool, name: &str, place: usize, put: Put| {
        if is_there {
            all.push(Varied { name: name.to_owned(), put, place });
        }
    };
    add(true, "width", 0, |problem, _, factor| {
        problem.block.b1 *= factor;
        problem.block.b2 *= factor;
        false
    });
    add(true, "height", 0, |problem, _, factor| {
        problem.block.d *= factor;
        false
    });
    add(true, "inertia", 0, |problem, _, factor| {
        problem.block.rho2 *= factor;
        false
    });
    add(problem.block.mu_s > 0.0, "friction", 0, |problem, _, factor| {
        problem.block.mu_s *= factor;
        problem.block.mu_k *= factor;
        false
    });
    add(problem.mu_impact.is_some_and(|μ| μ > 0.0), "mu_impact", 0, |problem, _, factor| {
        problem.mu_impact = problem.mu_impact.map(|μ| μ * factor);
        false
    });
    add(problem.block.m_x != problem.block.m_y, "added_mass", 0, |problem, _, factor| {
        let block = &mut problem.block;
        block.m_x = block.m_y + (block.m_x - block.m_y) * factor;
        false
    });
    let base = &problem.base;
    add(base.horizontal.is_some() || base.vertical.is_some(), "base", 0, |problem, _, factor| {
        let own = problem.base.horizontal.clone();
        for load in &mut problem.loads {
            // Water that is shaken along with the base.
            if Some(&load.history) == own.as_ref() {
                load.history = load.history.clone().times_factor(factor);
            }
        }
        for history in [&mut problem.base.horizontal, &mut problem.base.vertical].into_iter().flatten() {
            *history = history.clone().times_factor(factor);
        }
        false
    });
    for place in 0..histories(problem).len() {
        add(true, &format!("history[{}]", place + 1), place, |problem, place, factor| {
            let own = histories(problem)[place].clone();
            for load in problem.loads.iter_mut().filter(|load| load.history == own) {
                load.history = load.history.clone().times_factor(factor);
            }
            false
        });
    }
    let law = problem.impact;
    add(matches!(law, Impact::Ratio(_) | Impact::Contact(_)), "ratio", 0, |problem, _, factor| {
        let largest = problem.largest_ratio();
        match &mut problem.impact {
            Impact::Ratio(ratio) => {
                *ratio *= factor;
                let is_cut = *ratio > largest;
                *ratio = ratio.min(largest);
                is_cut
            }
            Impact::Contact(share) => {
                *share *= factor;
                let is_cut = *share > 1.0;
                *share = share.min(1.0);
                is_cut
            }
            _ => false,
        }
    });
    add(problem.restitution > 0.0, "e", 0, |problem, _, factor| {
        problem.restitution *= factor;
        let is_cut = problem.restitution > 1.0;
        problem.restitution = problem.restitution.min(1.0);
        is_cut
    });
    add(problem.initial.theta != 0.0, "theta", 0, |problem, _, factor| {
        problem.initial.theta *= factor;
        false
    });
    all
}

/// Histories of loads that end, each once, but for that of the base.
fn histories(problem: &MotionProblem) -> Vec<&standfast::History> {
    let mut found: Vec<&standfast::History> = Vec::new();
    for load in &problem.loads {
        let history = &load.history;
        let is_base = problem.base.horizontal.as_ref() == Some(history);
        if history.end().is_finite() && !is_base && !found.contains(&history) {
            found.push(history);
        }
    }
    found
}

/// A standard normal that hangs on a seed, the number of a copy and a name alone.
fn drawn(seed: u64, copy: u64, name: &str) -> f64 {
    const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
    let mix = |state: u64| {
        let state = state.wrapping_add(STEP);
        let state = (state ^ state >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let state = (state ^ state >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        state ^ state >> 31
    };
    let hash = name
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    let state = mix(seed ^ copy.wrapping_mul(STEP));
    let state = mix(state ^ hash.wrapping_mul(STEP));
    normal::quantile(((state >> 11) as f64 + 0.5) / (1u64 << 53) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use standfast::History;
    use standfast::contact::Block;
    use standfast_motion::Initial;

    fn scattering(problem: &MotionProblem, number: usize, spread: Spread, threads: usize) -> Copies {
        let outcome = simulate(problem, Keep::default()).unwrap();
        let asked = CopiesAsked { number, spread, seed: 1 };
        Copies::of(problem, &outcome, &asked, threads, Portion::UNSEEN).unwrap()
    }

    fn copies(problem: &MotionProblem, number: usize, threads: usize) -> Copies {
        scattering(problem, number, Spread::Even(0.01), threads)
    }

    /// Under names of their own numbers scatter as they would with all others, and these not at all; a name that is none is refused.
    #[test]
    fn numbers_scatter_by_name() {
        let mut problem = MotionProblem::new(Block::uniform(0.2, 0.3), 1.0);
        problem.initial = Initial { vx: Some(0.4), ..Initial::default() };
        let named = |name: &str, σ: f64| Spread::Named(vec![(name.to_owned(), σ)]);
        let [all, one] =
            [Spread::Even(0.01), named("friction", 0.01)].map(|spread| scattering(&problem, 50, spread, 1));
        assert_eq!((one.names, one.spreads), (vec!["friction".to_owned()], vec![0.01]));
        for (all, one) in all.rows.iter().zip(&one.rows) {
            assert_eq!(all.factors[3], one.factors[0]);
            assert!((one.slide.unwrap() * 0.6 * one.factors[0] / 0.16 - 1.0).abs() < 1e-12);
        }
        let outcome = simulate(&problem, Keep::default()).unwrap();
        let asked = CopiesAsked { number: 2, spread: named("base", 0.1), seed: 1 };
        let refused = Copies::of(&problem, &outcome, &asked, 1, Portion::UNSEEN).unwrap_err().to_string();
        assert!(
            refused.contains("base") && refused.contains("width, height, inertia, friction"),
            "{refused}"
        );
    }

    /// Its first values, which a program of another hand must have too.
    #[test]
    fn draws_hang_on_seed_copy_and_name_alone() {
        let first =
            [drawn(1, 1, "width"), drawn(1, 2, "width"), drawn(1, 1, "friction"), drawn(2, 1, "width")];
        for (found, expected) in first.into_iter().zip(EXPECTED) {
            assert!((found - expected).abs() < 1e-12, "{first:?}");
        }
        let (mut sum, mut squares) = (0.0, 0.0);
        for copy in 0..100_000 {
            let z = drawn(7, copy, "height");
            (sum, squares) = (sum + z, squares + z * z);
        }
        assert!((sum / 1e5).abs() < 0.02 && (squares / 1e5 - 1.0).abs() < 0.02, "{sum} {squares}");
    }

    /// By Python: splitmix64 and FNV-1a as they are published, and the quantile of the standard library.
    const EXPECTED: [f64; 4] =
        [0.5800521679657105, -0.837595868683463, -2.237791532941676, -0.37976353533243096];

    /// A block that is thrown along the base slides v²/(2μg): over copies that is as 1/μ, whatever else differs.
    #[test]
    fn slides_scatter_as_friction_does() {
        let mut problem = MotionProblem::new(Block::uniform(0.2, 0.3), 1.0);
        problem.initial = Initial { vx: Some(0.4), ..Initial::default() };
        let found = copies(&problem, 200, 2);
        let place = found.names.iter().position(|name| name == "friction").unwrap();
        assert_eq!(found.names, ["width", "height", "inertia", "friction"]);
        for row in &found.rows {
            let expected = 0.16 / (0.6 * row.factors[place]);
            assert!((row.slide.unwrap() / expected - 1.0).abs() < 1e-9);
            assert_eq!((row.overturned, row.differs), (false, None));
        }
        assert_eq!((found.overturning(), found.differs), (0, None));
        assert!(found.overturned.high < 0.02 && found.same_verdict.low > 0.98);
        let enclosed = |one: &CopyQuantile| {
            one.interval.is_some_and(|[low, high]| low <= one.value && one.value <= high && low < high)
        };
        assert!(found.slide().iter().all(enclosed));
        // More of them than products of the share can be told from nothing for.
        assert!(copies(&problem, 400, 2).slide().iter().all(enclosed));
        let median = found.slide()[2];
        let [low, high] = median.interval.unwrap();
        assert!(
            low < median.value && median.value < high && (median.value / (0.16 / 0.6) - 1.0).abs() < 3e-3
        );
    }

    /// Forty copies are the first of four hundred, on any number of threads.
    #[test]
    fn more_copies_have_the_first_among_them() {
        let mut problem = MotionProblem::new(Block::uniform(4.0, 0.7), 1.0);
        problem.base.horizontal = Some(History::half_sine(0.45, 2.2).unwrap());
        let (few, many) = (copies(&problem, 40, 1), copies(&problem, 400, 3));
        assert_eq!(few.rows[..], many.rows[..40]);
        assert!(few.names.contains(&"base".to_owned()));
    }

    /// Near a change of the verdict some copies overturn and others do not, with an interval by hand.
    #[test]
    fn a_verdict_near_its_change_has_both_answers() {
        let shaken = |peak: f64| {
            let mut problem = MotionProblem::new(Block::uniform(4.0, 2.0), 1.0);
            problem.base.horizontal = Some(History::half_sine(peak, 3.0).unwrap());
            problem
        };
        let overturns = |peak: f64| simulate(&shaken(peak), Keep::default()).unwrap().overturned();
        let (mut stands, mut falls) = (0.25, 1.5);
        assert!(!overturns(stands) && overturns(falls));
        for _ in 0..40 {
            let middle = 0.5 * (stands + falls);
            if overturns(middle) { falls = middle } else { stands = middle }
        }
        let found = copies(&shaken(stands), 100, 2);
        let share = found.overturning() as f64 / 100.0;
        assert!((0.25..0.75).contains(&share), "{share}");
        // Clopper and Pearson about a half of a hundred: 0.40 to 0.60.
        assert!((found.overturned.high - found.overturned.low - 0.2).abs() < 0.03, "{:?}", found.overturned);
        assert!(found.differs.is_some_and(|differs| differs.copies > 20));
    }
}
