//! The answer for reading.

use std::fmt::Write;

use standfast::Mode;

use super::{
    AnyCheck, Assessed, Assessment, AssessmentView, GOVERNING, acting, checks, combination, coordinates,
    ground, holding, joints, loads, opening, plan, sea, soil, verdict,
};
use crate::case::Case;
use crate::describe::{self, Scale};
use crate::layout::{columns, digits, paragraph, row};
use crate::summary::warning_words;
use standfast_model::Warning;

pub(super) fn render(assessment: &Assessment, view: &AssessmentView) -> String {
    let case = &assessment.case;
    let mut text = title(case);
    text += &super::summary::summary(assessment).text();
    text += "\n";
    text += &note(case);
    text += "Body\n";
    text += &loads::body(case);
    text += &warnings(case, |warning| !warning.is_about_waves());
    if let Some(wave) = &case.wave {
        text += &sea::render(case, wave);
    }
    if !case.soils.is_empty() {
        text += "\n";
        text += soil::render(case).trim_end_matches('\n');
        text += "\n";
    }
    let several = assessment.all.len() > 1;
    if several {
        text += "\nSummary\n";
        text += &acting::summary(assessment);
    }
    let shown = super::shown(assessment, view);
    if shown.len() < assessment.all.len() {
        text += "\n";
        let words = format!(
            "Of {} situations, the {GOVERNING} worst are shown one by one; {} shows all.",
            assessment.all.len(),
            view.interface.all()
        );
        text += &paragraph(&words, 0);
    }
    for (place, assessed) in shown.into_iter().enumerate() {
        text += "\n";
        if several {
            let _ = write!(text, "{}\n\n", "─".repeat(88));
        }
        text += &acting::heading(assessment, assessed);
        text += &details(case, assessed, view, place == 0);
    }
    let checks = assessment.all_checks();
    if !checks.is_empty() {
        if several {
            let _ = write!(text, "\n{}\n", "─".repeat(88));
        }
        text += "\nCriteria\n";
        text += &criteria(assessment, &checks);
    }
    if let Some(in_time) = &assessment.in_time {
        text += &format!("\n{}", paragraph(&format!("Note: {}.", in_time.note), 0));
    }
    text
}

/// Criteria as text, the governing one first.
fn criteria(assessment: &Assessment, checks: &[AnyCheck<'_>]) -> String {
    let several = assessment.all.len() > 1;
    let mut rows = vec![row!["criterion", "required", "value", "utilisation", "", ""]];
    rows.extend(checks.iter().map(|check| {
        let assessed = check.assessed(assessment);
        let situation = assessment.name(assessed).filter(|_| several).map(|name| format!("in {name}"));
        let shaken = assessed.earthquake.filter(|_| check.is_of_another_trial()).map(|earthquake| {
            let [right, up] =
                [earthquake.horizontal(), earthquake.vertical()].map(|a| digits(a / assessment.case.gravity));
            format!("shaken with {right} g, {up} g")
        });
        let pairs = combination::pair_words(&assessment.case, assessed);
        let pairs = pairs.filter(|_| check.is_of_another_trial()).map(|words| format!("with {words}"));
        let joint = Some(check.on_joint().trim().to_owned()).filter(|joint| !joint.is_empty());
        let place: Vec<_> = joint.into_iter().chain(situation).chain(pairs).chain(shaken).collect();
        let [required, value, utilisation, met] = check.cells();
        row![check.name(), required, value, utilisation, met, place.join(", ")]
    }));
    columns(&rows, 2, &[3]) + &paragraph(&criteria_met(assessment), 2)
}

/// Sentence on the criteria that are met, or not.
pub fn criteria_met(assessment: &Assessment) -> String {
    met_words(assessment.all_checks().iter().map(|check| (check.name(), check.is_met())))
}

/// Sentence on how many criteria are met, or which are not.
pub(crate) fn met_words<'a>(checks: impl Iterator<Item = (&'a str, bool)>) -> String {
    let checks: Vec<_> = checks.collect();
    let failed: Vec<_> = checks.iter().filter(|(_, met)| !met).map(|(name, _)| *name).collect();
    match (checks.len(), failed.as_slice()) {
        (1, []) => "The criterion is met.".to_owned(),
        (2, []) => "Both criteria are met.".to_owned(),
        (count, []) => format!("All {count} criteria are met."),
        (_, failed) => format!("Not met: {}.", failed.join(", ")),
    }
}

/// Title and note.
pub(crate) fn heading(case: &Case) -> String {
    title(case) + &note(case)
}

pub(crate) fn title(case: &Case) -> String {
    case.title.as_ref().map_or(String::new(), |title| paragraph(title, 0) + "\n")
}

pub(crate) fn note(case: &Case) -> String {
    case.note.as_ref().map_or(String::new(), |note| paragraph(note, 2) + "\n")
}

/// Warnings of a kind, each a paragraph.
pub(super) fn warnings(case: &Case, of: impl Fn(&Warning) -> bool) -> String {
    let warnings = case.warnings().into_iter().filter(|warning| of(warning));
    warnings.map(|warning| paragraph(&warning_words(warning.name(), &warning), 2)).collect()
}

/// The answer to one situation; `first` has the notes that hold for all.
fn details(case: &Case, assessed: &Assessed, view: &AssessmentView, first: bool) -> String {
    let full = &assessed.outcome.full;
    let under = case.under(assessed.acting);
    let mut text = if under.soils == case.soils { String::new() } else { soil::render(under) };
    if let Some(wave) = under.wave.as_ref().filter(|_| under.wave != case.wave) {
        text += &sea::pressures(wave, case.output);
        text += "\n";
    }
    text += "Forces and moments\n";
    text += &loads::components(assessed);
    if first {
        if case.plan.is_none() {
            text += &paragraph("Moments are counter-clockwise about the centre of mass C.", 2);
        }
        for note in loads::left_out(under) {
            text += &paragraph(note, 2);
        }
        text += &acting::notes(case, assessed);
    }
    if let Some(earthquake) = &assessed.earthquake {
        text += &soil::increments(under, earthquake);
    }
    if let Some(answer) = &assessed.outcome.plan {
        text += &plan::factors(under, assessed, answer);
        text += "\nVerdict\n";
        text += &plan::verdict(under, assessed, answer);
        return text + &acting::tried(case, assessed);
    }
    text += "\nActions\n";
    text += &checks::actions(assessed);
    text += "\nSafety factors and bearing pressure\n";
    text += &checks::factors(assessed);
    text += &opening::render(assessed);
    text += &holding::render(case, assessed);
    text += &ground::render(under, assessed);
    text += &joints::render(assessed);

    text += "\nVerdict\n";
    for sentence in verdict::full_load(assessed) {
        text += &paragraph(&sentence, 2);
    }
    text += &acting::tried(case, assessed);
    if assessed.joints.is_some() {
        text += &joints::motion(assessed);
        text += &path(case, assessed, view);
        return text;
    }
    text += match (full.effective.is_some(), assessed.situation.in_air().is_some()) {
        _ if assessed.is_on_ground() => "\nCoordinates\n",
        (true, false) => "\nIn the report's diagram, with effective coordinates\n",
        _ => "\nIn the report's diagram\n",
    };
    text += &coordinates::text(assessed);
    let because = assessed.because();
    if !because.is_empty() {
        text += "\nBecause\n";
        text += &describe::relations(&because, 2);
    }
    // Of a body at rest all of it is zero but the weight.
    if let Some(motion) = assessed.motion().filter(|_| assessed.mode() != Some(Mode::Rest)) {
        text += "\nAt onset\n";
        text += &describe::real_motion(motion, &Scale::of(under));
        if assessed.earthquake.is_some() {
            text += &paragraph(describe::RELATIVE, 2);
        }
    }
    text += &path(case, assessed, view);
    if let Some(reduced) = full.effective.as_ref().filter(|_| !assessed.is_on_ground()) {
        text += "\nChanges of mode as the friction grows, at this load\n";
        text += &describe::along_mu(reduced, 2);
    }
    text
}

fn path(case: &Case, assessed: &Assessed, view: &AssessmentView) -> String {
    let mut text = if !assessed.rises() {
        "\nLoad path\n".to_owned()
    } else {
        let title = "\nLoad path: the variable loads rise by a factor, the permanent ones stay\n";
        let stages = match &assessed.joints {
            Some(joints) => joints::stages(case, assessed, joints, view),
            None => verdict::stages(assessed, view),
        };
        title.to_owned() + &stages
    };
    for sentence in verdict::path(assessed) {
        text += &paragraph(&sentence, 2);
    }
    text
}
