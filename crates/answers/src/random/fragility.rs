//! Probabilities along a number of the case: fragility over an acceleration, or P over a width.
//!
//! Each value makes a case of its own, with what goes with the number when it is varied; its laws are those of the file, and a mean
//! that is left out is that case's. A limit state that is lognormal along the number has the curve
//!
//! ```text
//! P(x) = Φ(ln(x/median)/dispersion)
//! ```
//!
//! of which the nearest is given where the number is an intensity ([`Lognormal::nearest`]); its largest difference from the probabilities
//! says whether it holds.

use std::cmp::Ordering;
use std::str::FromStr;

use standfast_probability::lognormal::Lognormal;
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::answer::{ChanceRequest, Happening, Probability};
use super::chances::event;
use super::criterion::{ChanceCriterion, of_life_and_slides};
use super::error::ProbabilityError;
use super::overturn::Overturning;
use super::problem::ChanceProblem;
use super::quantity::Coordinate;
use super::subject::{ChanceSubject, problems_of};
use crate::couple::{Variable, vary};
use crate::key::Id;
use crate::key::Key;
use crate::units::ShownUnit;
use standfast_model::{CaseFile, GivenBase};

/// The number and the values along which probabilities are asked for: `NAME=FROM..TO:COUNT`, or one by one, `NAME=VALUE,VALUE`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueRange {
    name: String,
    values: Values,
}

/// Values as they are written.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Values {
    Steps { from: String, to: String, count: usize },
    These(Vec<String>),
}

/// At most so many.
const MOST: usize = 10_000;

impl FromStr for ValueRange {
    type Err = String;

    fn from_str(text: &str) -> Result<ValueRange, String> {
        let parts = || {
            let (name, range) = text.split_once('=')?;
            let name = name.trim().to_owned();
            let Some((range, count)) = range.rsplit_once(':') else {
                let values: Vec<String> = range.split(',').map(|value| value.trim().to_owned()).collect();
                let several = (2..=MOST).contains(&values.len());
                return several.then_some(ValueRange { name, values: Values::These(values) });
            };
            let (from, to) = range.split_once("..")?;
            let count = count.trim().parse().ok().filter(|count| (2..=MOST).contains(count))?;
            let [from, to] = [from, to].map(|part| part.trim().to_owned());
            Some(ValueRange { name, values: Values::Steps { from, to, count } })
        };
        parts().ok_or_else(|| {
            "expected NAME=FROM..TO:COUNT or NAME=VALUE,VALUE with two values or more, as in width=12 m..20 m:9"
                .to_owned()
        })
    }
}

/// Probabilities along a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Fragility {
    /// The number's name.
    pub name: String,
    /// Its meaning in a few words.
    pub words: String,
    /// The unit in which it is asked for, or in which the file writes it; `None` of a plain number.
    pub shown: Option<ShownUnit>,
    /// The probabilities at each value.
    pub points: Vec<FragilityPoint>,
    /// The curve through the probabilities of not resting.
    pub fit: Option<Fit>,
}

/// The probabilities at one value, under the least safe set of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct FragilityPoint {
    /// The value, SI.
    pub value: f64,
    /// That the body does not stay at rest.
    pub not_rest: Estimate,
    /// The modes, which add up to one.
    pub modes: Vec<(Happening, Estimate)>,
    /// The criteria of the case on a life and on slides in storms, in their order.
    pub criteria: Vec<ChanceCriterion>,
}

/// A lognormal curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Its median, SI.
    pub median: f64,
    /// Its logarithmic standard deviation.
    pub dispersion: f64,
    /// The largest difference from the probabilities.
    pub misfit: f64,
}

/// Probabilities that are as near to each other, relatively, are the same.
const AS_LIKELY: f64 = 1e-9;

impl Fragility {
    /// The number's unit for reading, empty of a plain number.
    pub fn unit(&self) -> String {
        self.shown.map_or(String::new(), ShownUnit::symbol)
    }

    /// A value in that unit.
    pub fn in_unit(&self, value: f64) -> f64 {
        self.shown.map_or(value, |unit| unit.of_si(value))
    }
}

impl Fit {
    /// The curve through values with their chances of something; none where fewer than two tell anything, or they do not rise.
    pub(super) fn of(points: &[(f64, f64)]) -> Option<Fit> {
        let curve = Lognormal::nearest(points)?;
        let difference = |(value, chance): &(f64, f64)| (curve.at(*value) - chance).abs();
        let misfit = points.iter().map(difference).fold(0.0, f64::max);
        Some(Fit { median: curve.median, dispersion: curve.dispersion, misfit })
    }
}

impl Probability {
    /// The answer to a file as [`of`](Probability::of) has it, and along a number if one is asked for; along the peak of a shaking, the
    /// bodies are followed in time.
    ///
    /// # Errors
    /// As [`of`](Probability::of) and [`Overturning::of`]; or if the number is none of the case, or random itself.
    pub fn along(
        file: &CaseFile,
        request: ChanceRequest,
        over: Option<&ValueRange>,
    ) -> Result<Probability, ProbabilityError> {
        Probability::under(file, request, over, &[], Portion::UNSEEN)
    }

    /// As [`along`](Probability::along), with records that are given in place of those of the file, as a portion of work that somebody may
    /// watch.
    ///
    /// # Errors
    /// As [`along`](Probability::along); if the work is stopped.
    pub fn under(
        file: &CaseFile,
        request: ChanceRequest,
        over: Option<&ValueRange>,
        records: &[GivenBase],
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        let shaken = records.first().map(|record| file.on_base(record));
        let file = shaken.as_ref().unwrap_or(file);
        let mut asked = ChanceSubject::of(file, request.years)?;
        let mut of_peak = None;
        if let ChanceSubject::Case { note: Some(_), moving, .. } = &mut asked {
            of_peak = over.filter(|over| over.is_of_peak());
            *moving = moving.take().filter(|_| of_peak.is_some());
        }
        let along = over.filter(|_| of_peak.is_none());
        let weights =
            [along.map_or(0.0, |over| over.count() as f64), 3.0, if of_peak.is_some() { 30.0 } else { 0.0 }];
        let [of_values, of_itself, of_motions] = portion.parts(weights);
        let fragility = along.map(|over| over.fragility(&asked, &request, of_values)).transpose()?;
        let answer =
            Probability { fragility, ..Probability::of_asked(file.name(), &asked, request, of_itself)? };
        let overturning =
            of_peak.map(|over| Overturning::under(file, &request, over, records, of_motions)).transpose()?;
        portion.reached(1.0);
        let title = file.inputs().text(Key::Title).map(str::to_owned);
        Ok(Probability { title, overturning, ..answer })
    }
}

/// True if a number says how strong what acts is: the more of it the likelier a failure, and none at zero, as a lognormal curve has it.
fn is_intensity(key: Key) -> bool {
    matches!(
        key,
        Key::K
            | Key::Horizontal
            | Key::Force
            | Key::H13
            | Key::Hmax
            | Key::HistoryPeak
            | Key::TargetPeak
            | Key::RecordFactor
    )
}

impl ValueRange {
    /// True if it asks for overturning over the peak of a shaking, which is none of the numbers of a case.
    pub fn is_of_peak(&self) -> bool {
        self.name == "pga"
    }

    /// Its values, read one by one.
    pub(super) fn values(
        &self,
        read: impl Fn(&str) -> Result<f64, String>,
    ) -> Result<Vec<f64>, ProbabilityError> {
        let read = |text: &String| read(text).map_err(|what| self.wrong(what));
        let (texts, values) = match &self.values {
            Values::These(texts) => (texts.clone(), texts.iter().map(read).collect::<Result<_, _>>()?),
            Values::Steps { from, to, .. } => (vec![from.clone(), to.clone()], vec![read(from)?, read(to)?]),
        };
        // Twice one value has no curve through it, and a fall is more likely a slip than meant.
        let rises = |i: usize| values[i - 1].total_cmp(&values[i]) == Ordering::Less && !values[i].is_nan();
        if let Some(i) = (1..values.len()).find(|i| !rises(*i)) {
            let (from, to) = (&texts[i - 1], &texts[i]);
            return Err(self.wrong(format!("it does not rise from {from} to {to}; expected rising values")));
        }
        Ok(match &self.values {
            Values::These(_) => values,
            Values::Steps { count, .. } => {
                let (from, to, last) = (values[0], values[1], (count - 1) as f64);
                (0..*count).map(|i| from + (to - from) * (i as f64 / last)).collect()
            }
        })
    }

    /// The first value, as it is written.
    fn first(&self) -> &str {
        match &self.values {
            Values::Steps { from, .. } => from,
            Values::These(values) => values.first().map_or("", String::as_str),
        }
    }

    /// Number of values.
    fn count(&self) -> usize {
        match &self.values {
            Values::Steps { count, .. } => *count,
            Values::These(values) => values.len(),
        }
    }

    pub(super) fn wrong(&self, what: impl Into<String>) -> ProbabilityError {
        ProbabilityError::Over { name: self.name.clone(), what: what.into() }
    }

    fn fragility(
        &self,
        asked: &ChanceSubject,
        request: &ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Fragility, ProbabilityError> {
        let (id, shown, points) = match asked {
            ChanceSubject::Point(of) => {
                let coordinate = Coordinate::ALL.into_iter().find(|c| c.name() == self.name);
                let Some(coordinate) = coordinate else {
                    return Err(self.wrong("it is none of gamma, k_prime, k and mu"));
                };
                if of.random.named.iter().any(|named| named.name == self.name) {
                    return Err(self.wrong("it is random itself"));
                }
                let at = |value: f64| {
                    if !coordinate.range().contains(value) {
                        return Err(self.wrong(format!("{value} is not {}", coordinate.range().words())));
                    }
                    let mut moved = of.point;
                    moved[coordinate as usize] = value;
                    Ok((vec![of.problem(moved, None)?], None))
                };
                let read =
                    |text: &str| text.parse::<f64>().map_err(|_| format!("\"{text}\" is not a number"));
                let points = self.points(self.values(read)?, (request, portion), at)?;
                (Id::from(coordinate.key()), None, points)
            }
            ChanceSubject::Storm(_) => return Err(ProbabilityError::NoBody),
            ChanceSubject::Case { file, .. } => {
                let case = file.case()?;
                let unknown = if self.is_of_peak() {
                    "it is the peak of a shaking, and the case has no [motion.base]; that of an [earthquake] is earthquake.horizontal"
                } else {
                    "it is not a number of the case; a load is named by its name, as in load.push.force"
                };
                let variable =
                    Variable::find(&self.name, file.inputs()).map_err(|found| match found.suggestion {
                        Some(meant) if !self.is_of_peak() => {
                            self.wrong(format!("{unknown}; did you mean `{meant}`?"))
                        }
                        _ => self.wrong(unknown),
                    })?;
                let read =
                    |text: &str| variable.read(text, file.inputs()).map_err(|problem| problem.to_string());
                // The problems as they are, for what is random.
                let random = problems_of(file, request.years, None)?;
                let same =
                    |problem: &ChanceProblem| problem.random().iter().any(|input| input.is_of(&variable));
                if random.iter().any(same) {
                    return Err(self.wrong("it is random itself"));
                }
                let at = |value: f64| {
                    let changed = file.varied(vary(file.inputs(), &case, &[(&variable, value)]));
                    Ok((problems_of(&changed, request.years, None)?, Some(changed)))
                };
                let points = self.points(self.values(read)?, (request, portion), at)?;
                // In the unit that is asked in, or else in that of the file.
                let asked_in = file.inputs().unit_in(variable.id(), self.first());
                (variable.id(), asked_in.or(variable.shown_unit()), points)
            }
        };
        let told: Vec<(f64, f64)> = points.iter().map(|point| (point.value, point.not_rest.value)).collect();
        let fit = Fit::of(&told).filter(|_| is_intensity(id.key));
        Ok(Fragility { name: self.name.clone(), words: id.words(), shown, points, fit })
    }

    fn points(
        &self,
        values: Vec<f64>,
        (request, portion): (&ChanceRequest, Portion<'_>),
        at: impl Fn(f64) -> Result<(Vec<ChanceProblem>, Option<CaseFile>), ProbabilityError>,
    ) -> Result<Vec<FragilityPoint>, ProbabilityError> {
        values
            .into_iter()
            .enumerate()
            .map(|(place, value)| {
                let portion = portion.part(place, self.count());
                let mut worst: Option<FragilityPoint> = None;
                let (problems, file) = at(value)?;
                let [of_event, of_life] = portion.parts([1.0, if file.is_some() { 1.0 } else { 0.0 }]);
                for (place, problem) in problems.iter().enumerate() {
                    let (modes, not_rest) = event(problem, request, of_event.part(place, problems.len()))?;
                    // Of what is as likely but for rounding, as under a shaking to either side, the first along all values.
                    let above =
                        |worst: &FragilityPoint| not_rest.value > worst.not_rest.value * (1.0 + AS_LIKELY);
                    if worst.as_ref().is_none_or(above) {
                        worst = Some(FragilityPoint { value, not_rest, modes, criteria: Vec::new() });
                    }
                }
                let mut worst = worst.ok_or_else(|| self.wrong("the case has no loads"))?;
                if let Some(file) = &file {
                    worst.criteria = of_life_and_slides(file, &problems, request, of_life)?;
                }
                portion.reached(1.0);
                Ok(worst)
            })
            .collect()
    }
}
