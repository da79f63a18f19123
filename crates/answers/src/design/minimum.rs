//! Several quantities at once: which values of them meet a target at the least cost?
//!
//! For values of all quantities but the first, held, the values of the first that meet the target are stretches, and the least cost
//! along it is at one of their ends, as the cost rises or falls with it throughout. So the cost is a function of the held ones alone. It
//! is sampled on a grid over the whole ranges, and on finer and finer ones about the best point, with the first quantity near its value
//! there. The point found is then moved on the grid of the numbers that are printed for as long as a neighbour costs less: the first
//! quantity is found anew at each, rounded and proven as for one quantity.

use standfast::Plan;
use standfast_model::CaseFile;
use standfast_watch::{Portion, Stopped};

use super::quantity::{DIGITS, Ends, Quantity};
use super::set::{End, Search};
use super::subject::Subject;
use super::target::Target;
use super::{DesignError, Spelling, Varied, answerable, with_unit};
use crate::assess::Assessment;
use crate::case::Case;
use crate::couple::Variable;
use crate::rounded::{Decimal, Towards};

/// The most quantities.
const MOST: usize = 3;

/// Number of parts that the range of the first quantity is cut into.
const PARTS: u32 = 40;

/// Number of parts of a narrow range about a value of it, and how narrow: from a share of it to as many times it.
const NEAR_PARTS: u32 = 8;
const NARROW: f64 = 1.25;

/// Number of parts of the range of each other one on the first grid, where there is one and where there are two.
const GRID: [usize; 2] = [30, 8];

/// How often a finer grid is laid about the best point, each half as wide as the one before.
const FINER: usize = 13;

/// How often the point found is moved to a neighbour at the most.
const MOVES: usize = 100;

/// Relative distance of an end of the first quantity from a value that does not meet the target, while the cost is looked for.
const NEAR: f64 = 1e-5;

/// What is to be least.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    /// The volume of the body without its cavities; per metre run the area of the section.
    Volume,
    /// The mass of the body.
    Mass,
}

impl Cost {
    /// All of them.
    pub const ALL: [Cost; 2] = [Cost::Volume, Cost::Mass];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Cost::Volume => "volume",
            Cost::Mass => "mass",
        }
    }

    /// That of a name.
    pub fn find(name: &str) -> Option<Cost> {
        Cost::ALL.into_iter().find(|cost| cost.name() == name)
    }

    /// The cost of a case: m³ or kg, per metre run where its masses are.
    pub fn of(self, case: &Case) -> f64 {
        let body = &case.body;
        match self {
            Cost::Mass => body.mass(),
            Cost::Volume => {
                let solid = |area: f64| match body.plan() {
                    Plan::Circle => std::f64::consts::FRAC_PI_4 * body.width() * area,
                    _ => area * body.plan().side(body.width()),
                };
                match &case.section {
                    Some(section) => {
                        let full = section
                            .parts()
                            .iter()
                            .filter(|part| part.density() != 0.0 || part.density_below_water() != 0.0);
                        solid(full.map(|part| part.area()).sum())
                    }
                    None => solid(body.width() * body.height()),
                }
            }
        }
    }
}

/// Request for the least cost.
#[derive(Debug, Clone)]
pub struct MinimumRequest {
    /// The quantities to vary.
    pub vary: Vec<String>,
    /// Target that they have to reach.
    pub target: Target,
    /// What is to be least.
    pub cost: Cost,
    /// Lower ends of their ranges, as the case file would have them; half the present value if not given, or an empty text.
    pub from: Vec<String>,
    /// Upper ends; twice the present value if not given.
    pub to: Vec<String>,
    /// Names by which errors call all this.
    pub spelling: &'static Spelling,
}

/// Values of several quantities that meet a target at the least cost.
pub struct Minimum {
    subject: Subject,
    /// What was asked.
    pub request: MinimumRequest,
    /// The quantities, in their order.
    pub quantities: Vec<Quantity>,
    /// The answer at their present values.
    pub present: Assessment,
    /// The point found.
    pub found: MinimumPoint,
    /// Its neighbours: other values of the quantities behind the first, a digit more or less.
    pub neighbours: Vec<Neighbour>,
}

/// Values of all quantities that meet the target.
pub struct MinimumPoint {
    /// The values of the quantities behind the first, as they are printed.
    pub held: Vec<f64>,
    /// End of the values of the first that costs least there.
    pub end: End,
    /// The cost.
    pub cost: f64,
}

/// A neighbour of the point found.
pub struct Neighbour {
    /// The values of the quantities behind the first.
    pub held: Vec<f64>,
    /// The value of the first that costs least there, as it is printed, and the cost; `None` where no value meets the target.
    pub first: Option<(String, f64)>,
}

impl Minimum {
    /// Finds the least cost for the case of a file, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// If the case makes no sense or lacks a quantity, there are none or too many or one twice, none of them changes the cost, or no values
    /// meet the target; if the work is stopped.
    pub fn of(
        file: &CaseFile,
        request: MinimumRequest,
        portion: Portion<'_>,
    ) -> Result<Minimum, DesignError> {
        let spelling = request.spelling;
        let ends = request.from.len().max(request.to.len());
        if ends > request.vary.len() {
            return Err(DesignError::MoreEnds { found: ends, quantities: request.vary.len(), spelling });
        }
        if request.vary.is_empty() || request.vary.len() > MOST {
            return Err(DesignError::Quantities { found: request.vary.len(), most: MOST, spelling });
        }
        let subject = Subject::of(file)?;
        let follows = subject.follows(request.target)?;
        answerable(request.target, &subject)?;
        if request.target.asks_for_chance(&subject.case) {
            return Err(DesignError::ChanceAtLeastCost { target: request.target });
        }
        let quantity = |(place, name): (usize, &String)| {
            let end = |ends: &[String]| ends.get(place).cloned().filter(|end| !end.is_empty());
            let ends = [end(&request.from), end(&request.to)];
            let written = [ends[0].as_deref(), ends[1].as_deref()];
            let options = [spelling.from, spelling.to];
            Quantity::of(name, &subject.numbers, &subject.case, &Ends { options, written, spread: 2.0 })
        };
        let quantities: Vec<Quantity> =
            request.vary.iter().enumerate().map(quantity).collect::<Result<_, _>>()?;
        for (place, one) in quantities.iter().enumerate() {
            if quantities[..place].iter().any(|other| other.variable.id() == one.variable.id()) {
                return Err(DesignError::SameQuantity { name: one.variable.id().to_string() });
            }
        }
        let present = Varied { subject: &subject, follows, held: &[] }.present(request.target)?;
        let space = Space { subject: &subject, follows, quantities: &quantities, request: &request };
        if !space.cost_changes(&present) {
            let names = quantities.iter().map(|quantity| quantity.variable.name().to_owned()).collect();
            return Err(DesignError::NoCost { names, cost: request.cost.name() });
        }
        let (found, neighbours) = space.least(portion)?;
        portion.reached(1.0);
        Ok(Minimum { subject, request, quantities, present, found, neighbours })
    }

    /// The answer at the values found.
    pub fn answer(&self) -> &Assessment {
        &self.found.end.answer
    }

    /// The values found, in words, in the order of the quantities.
    pub fn values(&self) -> Vec<String> {
        let held = self.quantities[1..].iter().zip(&self.found.held);
        let held = held.map(|(quantity, value)| with_unit(*value, &quantity.variable, DIGITS));
        std::iter::once(self.found.end.text.clone()).chain(held).collect()
    }

    /// Quantities whose value found is an end of their range, by their places: beyond it the cost may be less.
    pub fn at_ends(&self) -> Vec<usize> {
        let values = std::iter::once(self.found.end.rounded).chain(self.found.held.iter().copied());
        let is_at_end = |(place, value): (usize, f64)| {
            let [from, to] = self.quantities[place].range;
            (value <= from || value >= to).then_some(place)
        };
        values.enumerate().filter_map(is_at_end).collect()
    }

    /// Notes on the numbers that go with each quantity.
    pub fn notes(&self) -> Vec<String> {
        self.subject.notes(self.quantities.iter().map(|quantity| &quantity.variable), &self.present.case)
    }
}

/// Values of the quantities at which the target is met, and the cost there, to a few digits.
struct CostSample {
    held: Vec<f64>,
    first: f64,
    cost: f64,
}

/// The quantities in their ranges.
struct Space<'a> {
    subject: &'a Subject,
    follows: bool,
    quantities: &'a [Quantity],
    request: &'a MinimumRequest,
}

impl Space<'_> {
    fn others(&self) -> &[Quantity] {
        &self.quantities[1..]
    }

    /// Asks the search of a quantity, the first in a range, with the others held.
    fn at<T>(&self, first: &Quantity, parts: u32, held: &[f64], ask: impl FnOnce(&Search<'_>) -> T) -> T {
        let pairs: Vec<(&Variable, f64)> =
            self.others().iter().map(|quantity| &quantity.variable).zip(held.iter().copied()).collect();
        let varied = Varied { subject: self.subject, follows: self.follows, held: &pairs };
        ask(&Search { varied: &varied, quantity: first, target: self.request.target, parts })
    }

    /// The first quantity in a part of its range, about a value.
    fn near(&self, about: f64) -> Quantity {
        let Quantity { variable, present, range: [from, to] } = &self.quantities[0];
        let [less, more] = [about / NARROW, about * NARROW];
        let range = [less.min(more).max(*from), less.max(more).min(*to)];
        Quantity { variable: variable.clone(), present: *present, range }
    }

    /// True if some quantity changes the cost, or its ends make no case that would tell.
    fn cost_changes(&self, present: &Assessment) -> bool {
        let cost = self.request.cost.of(&present.case);
        let varied = Varied { subject: self.subject, follows: false, held: &[] };
        self.quantities.iter().any(|quantity| {
            quantity.range.iter().any(|end| {
                let answer = varied.answer(&quantity.variable, *end);
                answer.map_or(true, |answer| self.request.cost.of(&answer.case) != cost)
            })
        })
    }

    /// The sample of the first quantity that meets the target at the least cost, with the others held: its cost, its value, and the values
    /// beside it that do not meet the target, or make no case, and may cost less.
    fn cheapest(&self, search: &Search<'_>) -> Option<(f64, f64, Vec<f64>)> {
        let samples = search.samples();
        let tried: Vec<(bool, f64)> = samples
            .iter()
            .map(|value| {
                let trial = search.attempt(*value);
                let cost = trial.answer.as_ref().map(|answer| self.request.cost.of(&answer.case));
                // What makes no case has no cost that could be compared.
                (trial.met, cost.unwrap_or(f64::NEG_INFINITY))
            })
            .collect();
        let meeting = (0..samples.len()).filter(|place| tried[*place].0);
        // Along the quantity the cost rises or falls throughout, so that the sample that costs least is next to the end.
        let place = meeting.min_by(|one, other| tried[*one].1.total_cmp(&tried[*other].1))?;
        let beside = [place.checked_sub(1), Some(place + 1)].into_iter().flatten();
        let failing = beside
            .filter(|beside| tried.get(*beside).is_some_and(|(met, cost)| !met && *cost < tried[place].1));
        Some((tried[place].1, samples[place], failing.map(|beside| samples[beside]).collect()))
    }

    /// The least cost with the others held, to a few digits; `None` where no value of the first meets the target.
    fn sample(&self, first: &Quantity, parts: u32, held: &[f64]) -> Option<CostSample> {
        self.at(first, parts, held, |search| {
            let (cost, meets, failing) = self.cheapest(search)?;
            let ends = failing.into_iter().filter_map(|fails| {
                let end = search.halved(Some(fails), meets, NEAR, Portion::UNSEEN).ok()?;
                let answer = search.attempt(end.meets).answer.ok()?;
                Some((self.request.cost.of(&answer.case), end.meets))
            });
            let ends = std::iter::once((cost, meets)).chain(ends);
            let samples = ends.map(|(cost, first)| CostSample { held: held.to_vec(), first, cost });
            samples.min_by(|one, other| one.cost.total_cmp(&other.cost))
        })
    }

    /// The end of the first quantity that costs least near a value with the others held, proven.
    fn proven(&self, about: f64, held: &[f64]) -> Result<Option<MinimumPoint>, Stopped> {
        self.at(&self.near(about), NEAR_PARTS, held, |search| {
            let Some((_, meets, failing)) = self.cheapest(search) else { return Ok(None) };
            let sides = if failing.is_empty() { vec![None] } else { failing.into_iter().map(Some).collect() };
            let point = |fails: Option<f64>| {
                let end = search.boundary(fails, meets, Portion::UNSEEN)?;
                let inwards =
                    if fails.is_some_and(|fails| fails > meets) { Towards::Less } else { Towards::More };
                let [from, to] = search.quantity.range;
                let end = search.end(&end, inwards, if inwards == Towards::More { to } else { from });
                let cost = self.request.cost.of(&end.answer.case);
                Ok(MinimumPoint { held: held.to_vec(), end, cost })
            };
            Ok(least_cost(sides.into_iter().map(point).collect::<Result<Vec<_>, Stopped>>()?))
        })
    }

    /// The point of the least cost, and its neighbours.
    fn least(&self, portion: Portion<'_>) -> Result<(MinimumPoint, Vec<Neighbour>), DesignError> {
        let others = self.others();
        let [of_grid, of_finer, of_moves] = portion.parts([3.0, 3.0, 2.0]);
        let parts = GRID[usize::from(others.len() > 1)];
        let points = product(others.iter().map(|quantity| grid(quantity, parts)).collect());
        let least = |samples: Vec<CostSample>| {
            samples.into_iter().min_by(|one, other| one.cost.total_cmp(&other.cost))
        };
        let steps = of_grid.steps(points.len());
        let mut samples = Vec::new();
        for point in points {
            of_grid.check()?;
            samples.extend(self.sample(&self.quantities[0], PARTS, &point));
            steps.advance();
        }
        let Some(mut best) = least(samples) else {
            let middle: Vec<f64> =
                others.iter().map(|other| (other.range[0] + other.range[1]) / 2.0).collect();
            return Err(self.unmet(&middle));
        };
        let mut spans: Vec<f64> =
            others.iter().map(|quantity| (quantity.range[1] - quantity.range[0]) / parts as f64).collect();
        // One quantity alone has no grid that could be finer.
        let finer = if others.is_empty() { 0 } else { FINER };
        let steps = of_finer.steps(finer);
        for _ in 0..finer {
            of_finer.check()?;
            let about = |place: usize| {
                let [from, to] = others[place].range;
                [-1.0, 0.0, 1.0]
                    .map(|share| (best.held[place] + share * spans[place]).clamp(from, to))
                    .to_vec()
            };
            let points = product((0..others.len()).map(about).collect());
            let first = self.near(best.first);
            let samples = points.iter().filter_map(|point| self.sample(&first, NEAR_PARTS, point));
            best = least(samples.collect()).filter(|found| found.cost < best.cost).unwrap_or(best);
            spans.iter_mut().for_each(|span| *span /= 2.0);
            steps.advance();
        }
        self.moved(&best, of_moves)
    }

    /// The point of the grid of printed numbers that no neighbour betters, and its neighbours.
    fn moved(
        &self,
        sample: &CostSample,
        portion: Portion<'_>,
    ) -> Result<(MinimumPoint, Vec<Neighbour>), DesignError> {
        let CostSample { held, first, .. } = sample;
        let printed = |place: usize, towards: Towards| {
            let quantity = &self.others()[place];
            let decimal = Decimal::of(quantity.of_si(held[place]), DIGITS, towards);
            let [from, to] = quantity.range;
            quantity.in_si(decimal.value()).clamp(from, to)
        };
        let corners = (0..held.len())
            .map(|place| [Towards::Less, Towards::More].map(|way| printed(place, way)).to_vec());
        let corners = product(corners.collect());
        let points = corners.iter().map(|corner| self.proven(*first, corner));
        let points = points.collect::<Result<Vec<_>, Stopped>>()?;
        let Some(mut best) = least_cost(points.into_iter().flatten()) else { return Err(self.unmet(held)) };
        for _ in 0..MOVES {
            portion.check()?;
            let mut neighbours = Vec::new();
            let mut points = Vec::new();
            for held in self.around(&best.held) {
                let point = self.proven(best.end.rounded, &held)?;
                let first = point.as_ref().map(|point| (point.end.text.clone(), point.cost));
                neighbours.push(Neighbour { held, first });
                points.extend(point);
            }
            match least_cost(points).filter(|next| next.cost < best.cost) {
                None => return Ok((best, neighbours)),
                Some(next) => best = next,
            }
        }
        Ok((best, Vec::new()))
    }

    /// The points a digit away, in their ranges.
    fn around(&self, held: &[f64]) -> Vec<Vec<f64>> {
        let axis = |place: usize| {
            let quantity = &self.others()[place];
            let [from, to] = quantity.range;
            let decimal = Decimal::of(quantity.of_si(held[place]), DIGITS, Towards::Less);
            let beside = [Towards::Less, Towards::More].map(|way| quantity.in_si(decimal.next(way).value()));
            let mut axis: Vec<f64> = std::iter::once(held[place]).chain(beside).collect();
            axis.retain(|value| (from..=to).contains(value));
            axis
        };
        let points = product((0..held.len()).map(axis).collect());
        points.into_iter().filter(|point| point != held).collect()
    }

    /// Reason why no values meet the target.
    fn unmet(&self, held: &[f64]) -> DesignError {
        let spelling = self.request.spelling;
        let why = self.at(&self.quantities[0], PARTS, held, |search| search.unmet(spelling));
        if self.others().is_empty() {
            return why;
        }
        let others = self.others().iter().map(Quantity::in_range_words).collect::<Vec<_>>().join(" and ");
        let shown = self.others().iter().zip(held).map(|(other, value)| other.shown(*value));
        let at = shown.collect::<Vec<_>>().join(" and ");
        let Spelling { from, to, .. } = spelling;
        let help = format!("{from} and {to}, of each quantity, widen the ranges");
        DesignError::UnmetThroughout { others, at, why: why.to_string(), help }
    }
}

/// The first of those points that cost least.
fn least_cost(points: impl IntoIterator<Item = MinimumPoint>) -> Option<MinimumPoint> {
    points.into_iter().min_by(|one, other| one.cost.total_cmp(&other.cost))
}

/// Values of a quantity at equal distances, and the present one.
fn grid(quantity: &Quantity, parts: usize) -> Vec<f64> {
    let [from, to] = quantity.range;
    let mut values: Vec<f64> =
        (0..=parts).map(|place| from + (to - from) * place as f64 / parts as f64).collect();
    values.extend(Some(quantity.present).filter(|present| (from..=to).contains(present)));
    values
}

/// Every choice of one value from each axis; one without any of no axes.
fn product(axes: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    axes.into_iter().fold(vec![Vec::new()], |points, axis| {
        let with = |point: Vec<f64>| {
            axis.iter().map(move |value| point.iter().copied().chain([*value]).collect()).collect::<Vec<_>>()
        };
        points.into_iter().flat_map(with).collect()
    })
}
