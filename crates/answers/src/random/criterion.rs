//! Criteria that `[criteria]` sets for probabilities and means over chance: of one event, of a life, of slides in storms.
//!
//! The unsafe end of the interval has to meet the bound, so that what is not known well enough does not pass. Of several sets of loads that
//! act one by one the worst counts; the accelerations of a base that is shaken both ways are one event, which moves the body if any of them
//! does.

use standfast_probability::form::generalized;
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;

use super::answer::{ChanceRequest, Chances};
use super::chances::{event, life_of};
use super::error::ProbabilityError;
use super::joined::joined;
use super::problem::ChanceProblem;
use super::row::{RowChances, row_of};
use super::storm::{self, Sliding};
use super::subject::problems_of;
use crate::case::Acting;
use crate::key::Key;
use standfast_model::{Bound, CaseFile, Criterion};

/// Criteria on a life, and on slides in storms.
pub(super) const OF_LIFE: [Key; 2] = [Key::GreatestLife, Key::LeastLifeIndex];
pub(super) const OF_SLIDES: [Key; 2] = [Key::GreatestMeanSlide, Key::GreatestSlidingOver];

/// Estimates that criteria ask for, under one set of loads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AskedChances {
    /// That the body does not stay at rest in one event.
    pub not_rest: Option<Estimate>,
    /// That it ever leaves rest over the years of a life.
    pub life: Option<Estimate>,
    /// That any of the bodies of a row ever leaves rest over a life or, where none is asked for, in an event.
    pub any: Option<Estimate>,
    /// Its mean slide over a life of storms, m.
    pub sliding_mean: Option<Estimate>,
    /// That its slides come to more than these, m.
    pub sliding_over: Vec<(f64, Estimate)>,
    /// The years of that life; `None` where none is asked for.
    pub years: Option<f64>,
}

impl AskedChances {
    /// The estimate that a criterion is on; `None` where it was not found, or is none of chance.
    pub fn of(&self, criterion: &Criterion) -> Option<Estimate> {
        match criterion.key {
            Key::GreatestNotRest => self.not_rest,
            Key::GreatestLife => self.life,
            Key::GreatestAny => self.any,
            // The likelier, the less reliable.
            Key::LeastLifeIndex => self.life.map(|Estimate { value, low, high }| Estimate {
                value: generalized(value),
                low: generalized(high),
                high: generalized(low),
            }),
            Key::GreatestMeanSlide => self.sliding_mean,
            Key::GreatestSlidingOver => {
                let asked = |(slide, _): &&(f64, Estimate)| Some(*slide) == criterion.over;
                self.sliding_over.iter().find(asked).map(|(_, chance)| *chance)
            }
            _ => None,
        }
    }

    /// The number that counts for a criterion: the unsafe end of the interval.
    pub fn counted(&self, criterion: &Criterion) -> Option<f64> {
        let estimate = self.of(criterion)?;
        Some(if matches!(criterion.bound, Bound::AtLeast(_)) { estimate.low } else { estimate.high })
    }
}

/// Criterion of chance beside its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChanceCriterion {
    /// The criterion.
    pub criterion: Criterion,
    /// What it is on, under the set of loads where that is worst.
    pub estimate: Estimate,
    /// The number that counts: the unsafe end of the interval.
    pub counted: f64,
}

impl ChanceCriterion {
    /// The bound.
    pub fn required(&self) -> f64 {
        match self.criterion.bound {
            Bound::AtLeast(bound) | Bound::AtMost(bound) => bound,
            Bound::NoneOf(_) => f64::NAN,
        }
    }

    /// True if it is met.
    pub fn is_met(&self) -> bool {
        match self.criterion.bound {
            Bound::AtLeast(least) => self.counted >= least,
            _ => self.counted <= self.required(),
        }
    }

    /// The share of the bound that is used; infinite of an index that is not above zero.
    pub fn utilisation(&self) -> f64 {
        match self.criterion.bound {
            Bound::AtLeast(least) if self.counted > 0.0 => (least / self.counted).max(0.0),
            Bound::AtLeast(_) => f64::INFINITY,
            _ => self.counted / self.required(),
        }
    }
}

/// What is known already of what criteria ask for.
pub(super) struct Known<'a> {
    /// The answers under each set of loads.
    pub(super) situations: &'a [Chances],
    /// Slides in storms.
    pub(super) sliding: Option<&'a Sliding>,
    /// Any of the bodies of a row, under any set of loads.
    pub(super) row: Option<&'a RowChances>,
}

/// The slides of which criteria ask how likely they are exceeded.
pub(super) fn slides_asked(criteria: &[Criterion]) -> Vec<f64> {
    criteria.iter().filter_map(|criterion| criterion.over).collect()
}

/// The criteria of chance, the one of which most is used first.
pub(super) fn checked(
    criteria: &[Criterion],
    problems: &[ChanceProblem],
    known: &Known<'_>,
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Vec<ChanceCriterion>, ProbabilityError> {
    let found = asked(criteria, problems, known, request, portion)?;
    let worst = |criterion: &Criterion| {
        let each = found.iter().filter_map(|(_, chances)| {
            let (estimate, counted) = (chances.of(criterion)?, chances.counted(criterion)?);
            Some(ChanceCriterion { criterion: *criterion, estimate, counted })
        });
        each.reduce(|one, two| if two.utilisation() > one.utilisation() { two } else { one })
    };
    let mut checked: Vec<ChanceCriterion> = criteria.iter().filter_map(worst).collect();
    standfast::order::by_number(&mut checked, |one| -one.utilisation());
    Ok(checked)
}

/// The criteria of a case file on a life and on slides in storms, in their order: what is told along a number beside its event.
pub(super) fn of_life_and_slides(
    file: &CaseFile,
    problems: &[ChanceProblem],
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Vec<ChanceCriterion>, ProbabilityError> {
    let criteria: Vec<Criterion> = file.case()?.all_criteria();
    let of_life = |criterion: &Criterion| criterion.is_chance() && criterion.key != Key::GreatestNotRest;
    let criteria: Vec<Criterion> = criteria.into_iter().filter(of_life).collect();
    let [of_storm, of_chances] = portion.parts([40.0, 2.0]);
    let sliding = slides_of(file, &criteria, problems, request, of_storm)?;
    let known = Known { situations: &[], sliding: sliding.as_ref(), row: None };
    let found = checked(&criteria, problems, &known, request, of_chances)?;
    let of = |criterion: &Criterion| found.iter().find(|check| check.criterion == *criterion).copied();
    Ok(criteria.iter().filter_map(of).collect())
}

/// Slides of a case in its storms, where criteria ask for them.
fn slides_of(
    file: &CaseFile,
    criteria: &[Criterion],
    problems: &[ChanceProblem],
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Option<Sliding>, ProbabilityError> {
    let asks = criteria.iter().any(|criterion| OF_SLIDES.contains(&criterion.key));
    let storm = storm::storm(file.inputs()).map_err(|fault| file.error(fault))?.filter(|_| asks);
    let sliding =
        storm.map(|storm| storm::of_case(&storm, problems, request, &slides_asked(criteria), portion));
    Ok(sliding.transpose()?)
}

/// What criteria ask for, for each set of loads that act together; under any of the accelerations of the base that are tried.
fn asked(
    criteria: &[Criterion],
    problems: &[ChanceProblem],
    known: &Known<'_>,
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Vec<(Acting, AskedChances)>, ProbabilityError> {
    let asks = |keys: &[Key]| criteria.iter().any(|criterion| keys.contains(&criterion.key));
    let slides = match known.sliding {
        _ if !asks(&OF_SLIDES) => None,
        None => return Err(ProbabilityError::NoStorm),
        sliding => sliding,
    };
    let over = slides_asked(criteria).into_iter().filter_map(|slide| {
        let exceeded = slides?.exceedance.iter().find(|exceeded| exceeded.slide == slide)?;
        Some((slide, exceeded.probability))
    });
    let of_slides = AskedChances {
        sliding_mean: slides.map(|slides| slides.mean),
        sliding_over: over.collect(),
        years: slides.map(|slides| slides.years),
        ..AskedChances::default()
    };
    let mut found: Vec<(Acting, AskedChances)> = Vec::new();
    let acting = problems.iter().filter_map(ChanceProblem::case).map(|(_, acting)| acting);
    for (place, acting) in acting.enumerate() {
        let [of_event, of_life, of_row] = portion.part(place, problems.len()).parts([1.0; 3]);
        if found.iter().any(|(known, _)| *known == acting) {
            continue;
        }
        let is_same = |problem: &&ChanceProblem| problem.case().is_some_and(|(_, of)| of == acting);
        let same: Vec<&ChanceProblem> = problems.iter().filter(is_same).collect();
        let mut chances = of_slides.clone();
        // Of one problem the answer is there already.
        let answered = known.situations.first().filter(|_| problems.len() == 1);
        if asks(&[Key::GreatestNotRest]) {
            let answered = answered.map(|chances| chances.not_rest);
            chances.not_rest = Some(match answered {
                Some(not_rest) => not_rest,
                None => not_rest_of(&same, request, of_event)?,
            });
        }
        if asks(&OF_LIFE) {
            let answered = answered.and_then(|chances| Some(chances.life.as_ref()?.ahead()));
            chances.years = problems[0].years();
            chances.life = Some(answered.map_or_else(|| life_of(&same, &request.effort, of_life), Ok)?);
        }
        if asks(&[Key::GreatestAny]) {
            chances.years = problems[0].years();
            // Of one set of loads it is there already.
            let answered = known.row.copied().filter(|_| same.len() == problems.len());
            let row = answered.map_or_else(|| row_of(&same, &request.effort, of_row), |row| Ok(Some(row)))?;
            chances.any = Some(row.ok_or(ProbabilityError::NoRow)?.any());
        }
        found.push((acting, chances));
    }
    Ok(found)
}

/// That any of these problems moves the body, which have the same random numbers.
fn not_rest_of(
    problems: &[&ChanceProblem],
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Estimate, ProbabilityError> {
    match joined(problems, request, portion)? {
        Some(joined) => Ok(joined.not_rest),
        None => Ok(event(problems[0], request, portion)?.1),
    }
}

/// What criteria ask of the chance of a case file, for each set of loads that act together.
///
/// # Errors
/// As [`Probability::of`](super::Probability::of); if a life or storms are asked for that the case does not have.
pub(crate) fn asked_of_file(
    file: &CaseFile,
    criteria: &[Criterion],
    portion: Portion<'_>,
) -> Result<Vec<(Acting, AskedChances)>, ProbabilityError> {
    let problems = problems_of(file, None, None)?;
    let request = ChanceRequest::default();
    let [of_storm, of_chances] = portion.parts([40.0, 2.0]);
    let sliding = slides_of(file, criteria, &problems, &request, of_storm)?;
    let known = Known { situations: &[], sliding: sliding.as_ref(), row: None };
    asked(criteria, &problems, &known, &request, of_chances)
}
