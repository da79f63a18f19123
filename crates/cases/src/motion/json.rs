//! The answer as JSON.

use serde::Serialize;
use standfast::Mode;
use standfast_motion::{End, MotionOutcome};

use super::criteria::{MotionCheck, MotionCriterion, MotionValue};
use super::{BlockCase, FollowedMotion, MotionWarning};
use crate::assess::optional_number_or_word;

/// Every key is there in every answer, as docs/simulate.schema.json has them: `null`, or an empty list, where there is no such thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    situation: Option<&'a str>,
    end: &'static str,
    slide: f64,
    max_slide: f64,
    t_max_slide: f64,
    max_theta: f64,
    t_max_theta: f64,
    max_theta_of_balance: f64,
    theta: f64,
    overturned: bool,
    past_balance: bool,
    at_rest: bool,
    impacts: usize,
    t_rest: Option<f64>,
    t_rest_is_bound: bool,
    t_final: f64,
    work: f64,
    friction_loss: f64,
    impact_loss: f64,
    kinetic: f64,
    potential: f64,
    energy_residual: f64,
    unique: bool,
    sensitivity: Option<f64>,
    met: Option<bool>,
    criteria: Vec<CriterionEntry>,
    events: Vec<EventEntry>,
    warnings: Vec<WarningEntry<'a>>,
    figures: &'a [String],
    others: Vec<Document<'a>>,
}

#[derive(Serialize)]
struct CriterionEntry {
    name: &'static str,
    required: MotionCriterion,
    value: MotionValue,
    #[serde(serialize_with = "optional_number_or_word")]
    utilisation: Option<f64>,
    met: bool,
}

impl From<MotionCheck> for CriterionEntry {
    fn from(MotionCheck { criterion, value, utilisation, met, .. }: MotionCheck) -> CriterionEntry {
        CriterionEntry { name: criterion.name(), required: criterion, value, utilisation, met }
    }
}

#[derive(Serialize)]
struct EventEntry {
    t: f64,
    why: &'static str,
    state: &'static str,
    also: Vec<&'static str>,
}

#[derive(Serialize)]
pub(super) struct WarningEntry<'a> {
    name: &'a str,
    message: &'a str,
}

impl<'a> From<&'a MotionWarning> for WarningEntry<'a> {
    fn from(warning: &'a MotionWarning) -> WarningEntry<'a> {
        WarningEntry { name: warning.name, message: &warning.words }
    }
}

/// End of a motion, in a word.
pub(super) fn end_word(end: End) -> &'static str {
    match end {
        End::AtRest => "rest",
        End::Overturned => "overturned",
        End::Time => "time",
        End::NoContinuation => "no-continuation",
        End::TooManyEvents => "too-many-events",
    }
}

/// The largest |θ| over that of balance, of the side to which it is nearer to it.
pub(super) fn of_balance(case: &BlockCase, outcome: &MotionOutcome) -> f64 {
    let block = &case.problem.block;
    outcome.max_theta / (block.b1.min(block.b2) / block.d).atan()
}

impl BlockCase {
    /// The answer as a JSON document, in the units of the case.
    pub fn json(&self, followed: &FollowedMotion) -> String {
        crate::json(&self.document(followed))
    }

    fn document<'a>(&'a self, followed: &'a FollowedMotion) -> Document<'a> {
        let outcome = &followed.outcome;
        let events = outcome.events.iter().map(|event| EventEntry {
            t: event.t,
            why: event.why.word(),
            state: event.state.symbol(),
            also: event.consistent.without(Some(event.state)).iter().map(Mode::symbol).collect(),
        });
        let warnings = followed.warnings.iter();
        Document {
            schema: 1,
            title: self.title.as_deref(),
            situation: self.situation.as_deref(),
            end: end_word(outcome.end),
            slide: outcome.slide,
            max_slide: outcome.max_slide,
            t_max_slide: outcome.t_max_slide,
            max_theta: outcome.max_theta,
            t_max_theta: outcome.t_max_theta,
            max_theta_of_balance: of_balance(self, outcome),
            theta: outcome.theta,
            overturned: outcome.overturned(),
            past_balance: outcome.past_balance,
            at_rest: outcome.at_rest(),
            impacts: outcome.impacts,
            t_rest: outcome.t_rest,
            t_rest_is_bound: outcome.t_rest_is_bound,
            t_final: outcome.t_final,
            work: outcome.work,
            friction_loss: outcome.friction_loss,
            impact_loss: outcome.impact_loss,
            kinetic: outcome.kinetic,
            potential: outcome.potential,
            energy_residual: outcome.energy_residual(),
            unique: outcome.unique,
            sensitivity: followed.sensitivity,
            met: self.met(outcome),
            criteria: self.checks(outcome).into_iter().map(CriterionEntry::from).collect(),
            events: events.collect(),
            warnings: warnings.map(WarningEntry::from).collect(),
            figures: &[],
            others: Vec::new(),
        }
    }
}

/// The answers to a case's situations as one JSON document: that of the first, with the `others` in it, and the files of its figures.
pub fn all_json(answers: &[(BlockCase, FollowedMotion)], figures: &[String]) -> String {
    let mut documents = answers.iter().map(|(case, followed)| case.document(followed));
    let Some(mut first) = documents.next() else { return crate::json(&Vec::<()>::new()) };
    first.others = documents.collect();
    first.figures = figures;
    crate::json(&first)
}
