//! The calculation, step by step; every result is the library's.

mod acting;
mod body;
mod classical;
mod contact;
mod criteria;
mod ground;
mod loads;
mod mode;
mod motion;
mod path;
mod waves;

use maud::Markup;
use standfast_cases::assess::{shown, situation_title};
use standfast_cases::{Assessed, Assessment, AssessmentView, Inputs};

pub use classical::TARGET;
pub use mode::capital;

use crate::SheetError;
use crate::steps::SheetSteps;

/// The calculation of the situations shown.
pub fn steps(assessment: &Assessment, inputs: &Inputs, view: &AssessmentView) -> Result<Markup, SheetError> {
    let case = &assessment.case;
    let mut steps = SheetSteps::new("Body", case.extent);
    body::steps(&mut steps, case, inputs);
    if let Some(wave) = &case.wave {
        steps.part("Waves and pressures (Goda, Takahashi)", None);
        waves::steps(&mut steps, case, wave);
    }
    let shown = shown(assessment, view);
    for assessed in &shown {
        let title = situation_title(assessment, assessed).unwrap_or_else(|| "Loads and response".to_owned());
        steps.part(&title, Some(assessed.index));
        situation(&mut steps, assessment, assessed, inputs, view)?;
    }
    if shown.len() < assessment.all.len() {
        steps.part("Other situations", None);
        steps.note(&format!(
            "Of {} situations the {} worst are calculated here; all stand in the table of the summary.",
            assessment.all.len(),
            shown.len()
        ));
    }
    Ok(steps.finish()?)
}

fn situation(
    steps: &mut SheetSteps,
    assessment: &Assessment,
    assessed: &Assessed,
    inputs: &Inputs,
    view: &AssessmentView,
) -> Result<(), SheetError> {
    let case = &assessment.case;
    let components = assessed.components();
    acting::steps(steps, assessment, assessed);
    loads::steps(steps, case, assessed, &components);
    classical::steps(steps, case, assessed, &components);
    ground::steps(steps, case, inputs, assessed, &components);
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
        None => contact::steps(steps, &assessed.situation, &full.wrench)?,
    }
    if assessed.is_on_ground() {
        ground::decision(steps, assessed);
    }
    motion::steps(steps, case, assessed);
    path::steps(steps, assessed, &components, view);
    criteria::steps(steps, case, assessed);
    if let Some(reduced) = full.effective.as_ref().filter(|_| !assessed.is_on_ground()) {
        mode::changes(steps, reduced, in_air.then_some(case.body.mass() * case.gravity));
    }
    Ok(())
}
