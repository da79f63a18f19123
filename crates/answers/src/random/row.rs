//! Rows of bodies alike: that any of them leaves rest, in an event and over a life.

use standfast_probability::life::Life;
use standfast_probability::row::rows;
use standfast_probability::sample::{Effort, Estimate};
use standfast_watch::Portion;

use super::chances::{after, over_years};
use super::error::ProbabilityError;
use super::joined::{AnyOf, MOVES};
use super::problem::ChanceProblem;

/// That any of the bodies of a row leaves rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowChances {
    /// Number of bodies.
    pub bodies: u64,
    /// That one of them at least does not stay at rest in an event.
    pub not_rest: Estimate,
    /// That one of them at least ever leaves rest over the years of a life, after those through which all stayed at rest if there are any.
    pub life: Option<Estimate>,
    /// True if each is as precise as asked.
    pub precise: bool,
}

impl RowChances {
    /// What a criterion on any of them is on: the life where there is one, else the event.
    pub fn any(&self) -> Estimate {
        self.life.unwrap_or(self.not_rest)
    }
}

/// That any of the bodies of a row leaves rest under any of these problems, which have the same random numbers; none of a body that stands in
/// no row.
pub(super) fn row_of(
    problems: &[&ChanceProblem],
    effort: &Effort,
    portion: Portion<'_>,
) -> Result<Option<RowChances>, ProbabilityError> {
    let Some(row) = problems[0].row() else { return Ok(None) };
    let own: Option<Vec<ChanceProblem>> = problems.iter().map(|problem| problem.along_own()).collect();
    let own = own.expect("a row has a number of each body");
    let (along, any) = (AnyOf(own.iter().collect()), AnyOf(problems.to_vec()));
    let sets = [1 << MOVES];
    let life = problems[0].life();
    let [of_event, of_life] = portion.parts([1.0, if life.is_some() { 2.0 } else { 0.0 }]);
    let event = over_years(&own[0], &along, &any, &sets, &row.of_one_event(), (effort, of_event))?.sampled;
    portion.check()?;
    let laws = problems[0].laws();
    let over = |life: &Life, portion: Portion<'_>| {
        if let Some((own, common)) = row.clash(laws, life) {
            let name = |place: usize| problems[0].random()[place].name.clone();
            return Err(ProbabilityError::RowClash { own: name(own), common: name(common) });
        }
        if life.years.fract() != 0.0 && life.events.is_none() {
            return Err(ProbabilityError::PartOfYear { years: life.years });
        }
        let found = rows(laws, &any, &sets, &row, life, effort.within(portion));
        portion.check()?;
        Ok(found.estimates[0])
    };
    let survived = problems[0].lifetime().survived;
    match &life {
        None if survived.is_some() => return Err(ProbabilityError::NoLife),
        Some(life) if !life.yearly.contains(&true) => {
            return Err(ProbabilityError::NothingYearly { years: life.years });
        }
        _ => {}
    }
    let life = life.map(|life| match survived {
        None => over(&life, of_life),
        Some(survived) => after(survived, &life, of_life, over),
    });
    let life = life.transpose()?;
    let is_precise = |estimate: &Estimate| estimate.is_precise(effort.precision, effort.floor);
    let precise = is_precise(&event.estimates[0]) && life.as_ref().is_none_or(is_precise);
    Ok(Some(RowChances { bodies: row.bodies, not_rest: event.estimates[0], life, precise }))
}
