//! Many motions of one case: bodies with other numbers, each under one of many records, as rows of numbers.
//!
//! What a body is, is found once, and each record is made a history once for the bodies that stand under it; the rest is the motion.

use standfast::{History, HistoryError, HistoryTimes};
use standfast_model::{BlockCase, CaseFile, GivenBase, MotionWarning, motions};
use standfast_motion::BaseMotion;
use standfast_motion::record::{Record, RecordUnit};
use standfast_motion::strength::{Change, VerdictStrength};
use standfast_motion::{End, MotionError};
use standfast_probability::sample::Estimate;
use standfast_watch::Portion;
use thiserror::Error;

use super::spectrum::in_order;
use super::{ColumnError, CopiesOptions, Follow, FollowedMotion, MotionRows, RowFault};
use crate::error::CaseError;
use crate::explained::Explained;
use crate::key::Table;

/// Acceleration of the base over time, as numbers.
#[derive(Debug, Clone)]
pub struct ShakingArray<'a> {
    /// Its times.
    pub times: HistoryTimes,
    /// To the right.
    pub horizontal: &'a [f64],
    /// Upwards, if it moves so.
    pub vertical: Option<&'a [f64]>,
}

/// Motions that are asked for.
#[derive(Debug)]
pub struct MotionsAsked<'a> {
    /// The records.
    pub records: &'a [ShakingArray<'a>],
    /// Factor from their numbers to those of the case, m/s².
    pub unit: f64,
    /// The names of the numbers that vary from body to body, as columns of a table have them.
    pub names: &'a [String],
    /// Their values for every body, in the units of the names or else SI.
    pub bodies: &'a [Vec<f64>],
    /// Number of bodies: one, where nothing varies.
    pub count: usize,
    /// True for every body under every record; else they go together, or one of both is one.
    pub is_crossed: bool,
    /// What is asked for beside the motion itself.
    pub follow: Follow,
    /// Copies that are asked for.
    pub copies: &'a CopiesOptions,
    /// Number of threads.
    pub threads: usize,
}

/// Reason why motions cannot be followed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MotionsError {
    /// A name that varies nothing.
    #[error(transparent)]
    Column(#[from] ColumnError),
    /// The case.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The records and the bodies do not go together.
    #[error("{records} records and {bodies} bodies; expected as many of both, or one of either, or cross")]
    Lengths {
        /// Number of records.
        records: usize,
        /// Number of bodies.
        bodies: usize,
    },
    /// A body.
    #[error("body {body}: {problem}")]
    Body {
        /// Its place.
        body: usize,
        /// What is wrong.
        problem: String,
    },
    /// A record.
    #[error("record {record}: {problem}")]
    Record {
        /// Its place.
        record: usize,
        /// What is wrong.
        problem: String,
    },
    /// An option of copies where none are followed.
    #[error("{option} is of copies, and none are followed; expected copies")]
    NoCopies {
        /// The option.
        option: &'static str,
    },
    /// A number of the shaking that records stand in place of.
    #[error("{name} is of the base, whose motion is that of the records")]
    OfBase {
        /// The name.
        name: String,
    },
    /// A motion.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

impl Explained for MotionsError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            MotionsError::Column(error) => Some(error),
            MotionsError::Case(error) => Some(error),
            _ => None,
        }
    }
}

/// A motion of many: its record, its body, and what became of it in the worst situation.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionOf {
    /// Place of the record.
    pub record: usize,
    /// Place of the body.
    pub body: usize,
    /// Displacement along the base at the end, and the largest to either side.
    pub slide: f64,
    /// The largest displacement to either side.
    pub max_slide: f64,
    /// The largest |θ|.
    pub max_theta: f64,
    /// The same over the angle of balance.
    pub max_theta_of_balance: f64,
    /// Since when it rests.
    pub t_rest: Option<f64>,
    /// Energy that friction takes, per mass.
    pub friction_loss: f64,
    /// Energy that impacts take, per mass.
    pub impact_loss: f64,
    /// Number of times that a corner meets the base.
    pub impacts: usize,
    /// Its end.
    pub end: End,
    /// True if all criteria are met, of a case with some.
    pub met: Option<bool>,
    /// The divergence, if it was asked for.
    pub divergence: Option<f64>,
    /// The factor at which it begins to move, and the nearest above and below 1 with another verdict, if they were asked for.
    pub strength: [Option<f64>; 3],
    /// The share of copies that overturn, if they were asked for.
    pub overturned_share: Option<Estimate>,
}

impl MotionOf {
    fn of(record: usize, body: usize, followed: &FollowedMotion) -> MotionOf {
        let outcome = &followed.outcome;
        let strength = followed.strength.as_ref();
        let nearest = |of: fn(&VerdictStrength) -> Option<Change>| Some(of(&strength?.overturning)?.factor);
        MotionOf {
            record,
            body,
            slide: outcome.slide,
            max_slide: outcome.max_slide,
            max_theta: outcome.max_theta,
            max_theta_of_balance: followed.of_balance(),
            t_rest: outcome.t_rest,
            friction_loss: outcome.friction_loss,
            impact_loss: outcome.impact_loss,
            impacts: outcome.impacts,
            end: outcome.end,
            met: followed.met(),
            divergence: followed.divergence.map(|divergence| divergence.value),
            strength: [
                strength.and_then(|strength| strength.onset),
                nearest(|of| of.up),
                nearest(|of| of.down),
            ],
            overturned_share: followed.copies.as_ref().map(|copies| copies.overturned),
        }
    }
}

/// Many motions, and the kinds of their warnings: the words of the first that has one, and how many have it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotionsFound {
    /// The motions, record by record.
    pub motions: Vec<MotionOf>,
    /// The warnings.
    pub warnings: Vec<(MotionWarning, usize)>,
}

impl MotionsFound {
    fn warn(&mut self, warning: MotionWarning, count: usize) {
        match self.warnings.iter_mut().find(|(known, _)| known.name == warning.name) {
            Some((_, known)) => *known += count,
            None => self.warnings.push((warning, count)),
        }
    }
}

/// So many records of one body are a piece of work.
const PIECE: usize = 32;

/// Follows many motions of a case, in the order of the records, and under each of the bodies.
///
/// # Errors
/// If the case, a name, a body or a record makes no sense, or the work is stopped.
pub fn motions_of(
    file: &CaseFile,
    asked: &MotionsAsked<'_>,
    portion: Portion<'_>,
) -> Result<MotionsFound, MotionsError> {
    let (records, bodies) = (asked.records.len(), asked.count);
    if !asked.is_crossed && records != bodies && records != 1 && bodies != 1 {
        return Err(MotionsError::Lengths { records, bodies });
    }
    let has_vertical = asked.records.iter().any(|record| record.vertical.is_some());
    let file = &file.on_base(&still_base(file, has_vertical));
    let rows = MotionRows::of(file, asked.names)?;
    rows.all_vary(asked.names)?;
    if let Some((place, _)) = rows.varied().find(|(_, key)| key.starts_with("motion.base.")) {
        return Err(MotionsError::OfBase { name: asked.names[place].clone() });
    }
    // Of each piece the body, and the records under which it stands.
    let pieces: Vec<(usize, Vec<usize>)> = match (asked.is_crossed, records == 1, bodies == 1) {
        (false, false, false) => (0..bodies).map(|both| (both, vec![both])).collect(),
        (_, _, true) => {
            let all: Vec<usize> = (0..records).collect();
            all.chunks(PIECE).map(|records| (0, records.to_vec())).collect()
        }
        _ => (0..bodies).map(|body| (body, (0..records).collect())).collect(),
    };
    // One body of many under one record: its history is made once for all.
    let shared = if records == 1 { Some(base(asked, 0)?) } else { None };
    let one = |(body, records): &(usize, Vec<usize>)| -> Result<MotionsFound, MotionsError> {
        let wrong = |problem: String| MotionsError::Body { body: *body, problem };
        let values: Vec<f64> = asked.bodies.iter().map(|values| values[*body]).collect();
        let inputs = rows.with_numbers(&values).map_err(|RowFault { problem, .. }| wrong(problem))?;
        let mut cases = motions(&inputs).map_err(|fault| match asked.names.is_empty() {
            true => MotionsError::Case(file.error(fault)),
            false => wrong(fault.to_string()),
        })?;
        for case in &mut cases {
            asked.copies.put(case).map_err(|option| MotionsError::NoCopies { option })?;
        }
        let mut found = MotionsFound::default();
        for record in records {
            let base = match &shared {
                Some(base) => base.clone(),
                None => base(asked, *record)?,
            };
            let step = asked.records[*record].times.longest();
            let shaken = cases.iter().map(|case| case.shaken(&base, step)).collect::<Vec<BlockCase>>();
            let mut all = FollowedMotion::of_all(shaken, &asked.follow, Portion::UNSEEN)
                .map_err(|error| wrong(error.to_string()))?;
            let worst = all.swap_remove(0);
            found.motions.push(MotionOf::of(*record, *body, &worst));
            worst.warnings.into_iter().for_each(|warning| found.warn(warning, 1));
        }
        Ok(found)
    };
    let found = in_order(&pieces, asked.threads, portion, one).map_err(MotionError::from)?;
    let mut all = MotionsFound::default();
    for piece in found {
        let MotionsFound { motions, warnings } = piece?;
        all.motions.extend(motions);
        warnings.into_iter().for_each(|(warning, count)| all.warn(warning, count));
    }
    all.motions.sort_by_key(|motion| (motion.record, motion.body));
    Ok(all)
}

/// A base that does not move, in the place of which each record is put.
pub fn still_base(file: &CaseFile, has_vertical: bool) -> GivenBase {
    let unit = match file.inputs().has(Table::Block) {
        true => RecordUnit::Unnamed,
        false => RecordUnit::MetrePerSecondSquared,
    };
    let record = Record { times: vec![0.0, 1.0], values: vec![0.0, 0.0], unit };
    GivenBase { horizontal: Some(record.clone()), vertical: has_vertical.then_some(record) }
}

/// The base's motion under a record.
fn base(asked: &MotionsAsked<'_>, record: usize) -> Result<BaseMotion, MotionsError> {
    let ShakingArray { times, horizontal, vertical } = &asked.records[record];
    let history = |values: &[f64]| {
        History::at_times(times, values, asked.unit).map_err(|error| {
            // Places in arrays are counted from 0.
            let problem = match error {
                HistoryError::Point { index, value, .. } => {
                    let value = if value.is_nan() { "nan".to_owned() } else { value.to_string() };
                    format!("value {index} is {value}; expected a finite number")
                }
                error => error.to_string(),
            };
            MotionsError::Record { record, problem }
        })
    };
    Ok(BaseMotion { horizontal: Some(history(horizontal)?), vertical: vertical.map(history).transpose()? })
}
