//! The calculation, step by step; every result is the library's.

mod acting;
mod balance;
mod body;
mod classical;
mod contact;
mod criteria;
mod ground;
mod holding;
mod joints;
mod loads;
mod mode;
mod motion;
mod opening;
mod path;
mod plan;
mod soil;
mod waves;

use std::collections::BTreeSet;

use maud::Markup;
use standfast_cases::assess::{shown, situation_title};
use standfast_cases::{Assessed, Assessment, AssessmentView, Inputs};

pub use classical::TARGET;

use crate::SheetError;
use crate::steps::SheetSteps;
use crate::together::Column;

/// Situations of a sheet: those calculated in full, and those that stand beside each other in a table.
pub struct Situations<'a> {
    pub full: Vec<&'a Assessed>,
    pub others: Vec<&'a Assessed>,
}

impl<'a> Situations<'a> {
    /// In full those in which a criterion is met worst, or the worst of all where there is no criterion; the worst first.
    pub fn of(assessment: &'a Assessment, view: &AssessmentView) -> Situations<'a> {
        let checks = assessment.all_checks();
        let governing: Vec<usize> = checks.iter().map(|check| check.assessed(assessment).index).collect();
        let worst = assessment.governing().index;
        let in_full = |one: &&Assessed| match governing.is_empty() {
            true => one.index == worst,
            false => governing.contains(&one.index),
        };
        let shown: Vec<usize> = shown(assessment, view).iter().map(|one| one.index).collect();
        let all = assessment.worst_first().into_iter();
        let all = all.filter(|one| in_full(one) || shown.contains(&one.index));
        let (full, others) = all.partition(in_full);
        Situations { full, others }
    }

    /// All, those in full first.
    pub fn all(&self) -> impl Iterator<Item = &'a Assessed> {
        self.full.iter().chain(&self.others).copied()
    }
}

/// The calculation of the situations shown.
pub fn steps(
    assessment: &Assessment,
    situations: &Situations<'_>,
    inputs: &Inputs,
    view: &AssessmentView,
) -> Result<Markup, SheetError> {
    let case = &assessment.case;
    let mut steps = SheetSteps::new("Body", case.output);
    body::steps(&mut steps, case, inputs);
    if let Some(wave) = &case.wave {
        steps.part(waves::title(wave), None);
        waves::steps(&mut steps, case, wave);
    }
    if !case.soils.is_empty() {
        steps.part("Pressure of soil", None);
        soil::steps(&mut steps, case);
    }
    let shown: Vec<&Assessed> = situations.all().collect();
    if !case.combinations.is_empty() {
        steps.part(
            if shown.len() > 1 { "Factors of the combinations" } else { "Factors of the combination" },
            None,
        );
        acting::factors(&mut steps, &shown);
    }
    let title = |one: &Assessed| situation_title(assessment, one);
    let known = steps.known();
    let altered: Vec<_> = shown.iter().map(|one| acting::altered(&steps, assessment, one)).collect();
    let elsewhere: BTreeSet<&String> = altered.iter().flatten().collect();
    for (assessed, own) in shown.iter().zip(&altered) {
        steps.forget_since(&known);
        steps.part(&title(assessed).unwrap_or_else(|| "Loads and response".to_owned()), Some(assessed.index));
        acting::changes(&mut steps, assessment, assessed);
        // What another situation has under another number.
        elsewhere.iter().filter(|name| !own.contains(**name)).for_each(|name| steps.know_again(name));
        situation(&mut steps, assessment, assessed, inputs, view)?;
    }
    if shown.len() < assessment.all.len() {
        steps.part("Situations that are not shown", None);
        steps.note(&format!(
            "Of {} situations {} are calculated here; all stand in the table of the summary.",
            assessment.all.len(),
            shown.len()
        ));
    }
    let column = |one: &&Assessed| Column { index: one.index, title: title(one).unwrap_or_default() };
    let others: Vec<Column> = situations.others.iter().map(column).collect();
    let what = if case.combinations.is_empty() { "loads" } else { "combinations" };
    let heading = match others.len() {
        1 => format!("The other {}", what.trim_end_matches('s')),
        _ => format!("The other {what}"),
    };
    Ok(steps.finish(&others, &heading)?)
}

fn situation(
    steps: &mut SheetSteps,
    assessment: &Assessment,
    assessed: &Assessed,
    inputs: &Inputs,
    view: &AssessmentView,
) -> Result<(), SheetError> {
    let case = assessment.case_of(assessed);
    let inputs = if std::ptr::eq(case, &assessment.case) { inputs } else { case.inputs() };
    let components = assessed.components();
    acting::steps(steps, assessment, assessed);
    soil::increments(steps, case, assessed);
    if let Some(answer) = &assessed.outcome.plan {
        plan::steps(steps, case, assessed, answer, &components);
        criteria::steps(steps, &assessment.case, assessed);
        return Ok(());
    }
    loads::steps(steps, case, assessed, &components);
    let held = classical::steps(steps, case, assessed, &components);
    ground::steps(steps, case, inputs, assessed, &components);
    if let Some(all) = &assessed.joints {
        joints::steps(steps, case, assessed, all, &components, view);
        criteria::steps(steps, &assessment.case, assessed);
        return Ok(());
    }
    let full = &assessed.outcome.full;
    let in_air = assessed.situation.in_air().is_some();
    match &full.effective {
        Some(reduced) => {
            match in_air {
                true => mode::in_air(steps, case, assessed, reduced),
                false => mode::effective(steps, reduced),
            }
            if !assessed.is_on_ground() {
                mode::decision(steps, assessed, reduced);
            }
        }
        None if assessed.is_on_ground() => {}
        None if assessed.outcome.held.is_some() => contact::held(steps, assessed),
        None => contact::steps(steps, &assessed.situation, &full.wrench)?,
    }
    if assessed.is_on_ground() {
        ground::decision(steps, assessed);
    }
    motion::steps(steps, case, assessed, held.motion);
    path::steps(steps, assessed, &components, view);
    criteria::steps(steps, &assessment.case, assessed);
    if let Some(reduced) = full.effective.as_ref().filter(|_| !assessed.is_on_ground()) {
        mode::changes(steps, reduced, in_air.then_some(case.body.mass() * case.gravity));
    }
    Ok(())
}
