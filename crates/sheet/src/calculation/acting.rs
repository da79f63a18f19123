//! Loads that act, and accelerations of the base that were tried.

use std::collections::BTreeSet;

use maud::{Markup, html};
use standfast::Verdict;
use standfast::loads::Earthquake;
use standfast_cases::assess::{Component, combination_changes, pairs, verdict};
use standfast_cases::case::ChangeBy;
use standfast_cases::layout::plain;
use standfast_cases::units::Dimension;
use standfast_cases::{Acting, Assessed, Assessment, Id, Inputs, capital};

use crate::measured::{
    ACCELERATION, DEGREE, DENSITY, INERTIA, KILONEWTON, KILOPASCAL, MASS, METRE, MOMENT, MRAD, Measured,
    NONE, SECOND, STIFFNESS, SheetUnit, UNIT_WEIGHT, number,
};
use crate::steps::SheetSteps;
use crate::symbols::of_input;
use crate::together::Brief;

/// The factor of each load in each of the combinations, which are shown in this order.
pub(super) fn factors(steps: &mut SheetSteps, shown: &[&Assessed]) {
    let components: Vec<_> = shown.iter().map(|assessed| assessed.components()).collect();
    let mut names: Vec<(&str, bool)> = Vec::new();
    for Component { name, load, .. } in components.iter().flatten() {
        if !names.contains(&(name, load.permanent)) {
            names.push((name, load.permanent));
        }
    }
    let factor = |of: &[Component], (name, permanent): (&str, bool)| {
        let is_it = |one: &&Component| one.name == name && one.load.permanent == permanent;
        of.iter().find(is_it).map(|component| component.load.factor)
    };
    let number_of = |assessed: &Assessed| match assessed.acting {
        Acting::Combination(index) => index + 1,
        _ => assessed.index + 1,
    };
    steps.note(
        "Loads that a combination does not name act as they are if they are permanent, and not at all if they are variable. A dash \
         stands for a load that does not act.",
    );
    let full = html! {
        table.numbers data-table="factors" {
            thead {
                tr {
                    th { "Load" }
                    th {}
                    @for assessed in shown {
                        th.n { @if shown.len() > 1 { "Combination " (number_of(assessed)) } @else { "Factor" } }
                    }
                }
            }
            tbody {
                @for &(name, permanent) in &names {
                    tr {
                        td { (name) }
                        td { @if permanent { "permanent" } @else { "variable" } }
                        @for of in &components {
                            td.n {
                                @match factor(of, (name, permanent)) {
                                    Some(factor) => data value=(factor) { (number(factor)) },
                                    None => "–",
                                }
                            }
                        }
                    }
                }
            }
        }
    };
    steps.push(full, Brief::Each);
}

/// The quantities of the body and of the waves that are others in a situation than in the case, whose are `known`.
pub(super) fn altered(known: &SheetSteps, assessment: &Assessment, assessed: &Assessed) -> BTreeSet<String> {
    let before = known.known();
    let mut scratch = known.scratch();
    changes(&mut scratch, assessment, assessed);
    let after = scratch.known().into_iter();
    after.filter(|(name, value)| before.get(name) != Some(value)).map(|(name, _)| name).collect()
}

/// What is another in a combination than in the case, and what follows from that for its body and its waves.
pub(super) fn changes(steps: &mut SheetSteps, assessment: &Assessment, assessed: &Assessed) {
    let Acting::Combination(index) = assessed.acting else { return };
    let (of_all, case) = (&assessment.case, assessment.case_of(assessed));
    let combination = &of_all.combinations[index];
    for (key, words) in combination_changes(of_all, index) {
        steps.note(&format!("{key}: {words}."));
    }
    if std::ptr::eq(of_all, case) {
        return;
    }
    steps.heading("Numbers of this combination");
    let values: Vec<(Id, f64)> = of_all.values_in(index).collect();
    for (id, value) in values {
        let written = |number: f64, inputs: &Inputs| match inputs.dimension(id) {
            Some(dimension) => case.output.written(dimension, number),
            None => plain(number),
        };
        let of_file = of_all.inputs().number(id).map(|number| written(number, of_all.inputs()));
        let changes = combination.changes.iter().filter(|change| change.id == id);
        // One after another, as they are made.
        let chain = changes.fold(of_file.clone(), |words, change| {
            Some(match (&change.by, words) {
                (ChangeBy::Set(text), _) => text.trim_matches(['"', '\'']).to_owned(),
                (ChangeBy::Scale(by), words) => format!("{} × {}", words.unwrap_or_default(), plain(*by)),
                (ChangeBy::Material(by), words) if id.key.is_friction_angle() => {
                    format!("arctan(tan {}°/{})", words.unwrap_or_default(), plain(*by))
                }
                (ChangeBy::Material(by) | ChangeBy::Resistance(by), words) => {
                    format!("{}/{}", words.unwrap_or_default(), plain(*by))
                }
            })
        });
        let words = match (chain == of_file, of_file) {
            (true, Some(file)) => format!("with that, in place of {file}"),
            _ => chain.unwrap_or_else(|| "with that".to_owned()),
        };
        let name = of_input(id.key.info().symbol, of_all.inputs(), id);
        let unit = unit_of(case.inputs(), id);
        let about = capital(&id.words());
        steps.told(&about, &name, value, unit, &words, "");
    }
    if case.body != of_all.body || case.gravity != of_all.gravity {
        super::body::steps(steps, case, case.inputs());
    }
    steps.know("μ", case.friction, NONE);
    steps.know("μ_k", case.kinetic_friction, NONE);
    if let Some(wave) = case.wave.as_ref().filter(|_| case.wave != of_all.wave) {
        super::waves::steps(steps, case, wave);
    }
    if case.soils != of_all.soils {
        super::soil::steps(steps, case);
    }
}

/// The unit in which a sheet has the numbers under a key.
fn unit_of(inputs: &Inputs, id: Id) -> SheetUnit {
    match inputs.dimension(id) {
        Some(Dimension::Length) => METRE,
        Some(Dimension::Force | Dimension::WholeForce) => KILONEWTON,
        Some(Dimension::Moment | Dimension::WholeMoment) => MOMENT,
        Some(Dimension::Inertia | Dimension::WholeInertia) => INERTIA,
        Some(Dimension::Pressure) => KILOPASCAL,
        Some(Dimension::Density) => DENSITY,
        Some(Dimension::UnitWeight) => UNIT_WEIGHT,
        Some(Dimension::Stiffness) => STIFFNESS,
        Some(Dimension::Angle) => MRAD,
        Some(Dimension::Mass | Dimension::WholeMass) => MASS,
        Some(Dimension::Acceleration) => ACCELERATION,
        Some(Dimension::Time) => SECOND,
        None if id.key.name().ends_with("_deg") => DEGREE,
        None => NONE,
    }
}

pub(super) fn steps(steps: &mut SheetSteps, assessment: &Assessment, assessed: &Assessed) {
    let case = &assessment.case;
    if assessed.others.is_empty() {
        return;
    }
    let of_pairs = pairs(case, assessed.acting, assessed.trial);
    if assessed.earthquake.is_some() {
        steps.note(
            "The base may be shaken to either side and either way, unless the case fixes a sign. These accelerations were tried; all \
             that follows is for the first, the worst.",
        );
        if case.earthquake_factor(assessed.acting, assessed.trial) != 1.0 {
            steps.note("The accelerations act times the factor of the combination.");
        }
    }
    if !of_pairs.is_empty() {
        steps.note(
            "Each factor of a pair was tried; all that follows is for the first row, the worst. Each criterion stands where it is met worst.",
        );
    }
    let full = html! {
        table.numbers data-table="tried" {
            thead {
                tr {
                    @for (name, _) in &of_pairs { th.n { "Factor on " (name) } }
                    @if assessed.earthquake.is_some() {
                        th.n { "To the right, m/s²" }
                        th.n { "Upwards, m/s²" }
                        @if case.plan.is_some() { th.n { "Away, m/s²" } }
                    }
                    th { "Mode" }
                    th.n { "Safety against sliding" }
                    th.n { "Safety against overturning" }
                    th { "Leaves rest at" }
                }
            }
            tbody {
                @for tried in assessed.tried() {
                    @let outcome = &tried.outcome;
                    tr {
                        @for (_, factor) in pairs(case, tried.acting, tried.trial) {
                            td.n { data value=(factor) { (number(factor)) } }
                        }
                        @if let Some(earthquake) = &tried.earthquake { (accelerations(earthquake, case.plan.is_some())) }
                        td { (tried.verdict().map_or("none", Verdict::symbol)) }
                        @for factor in [outcome.stability.sliding, outcome.stability.overturning()] {
                            td.n { @if outcome.full.is_lifted() { "none" } @else { (Measured::of(factor, NONE).html("")) } }
                        }
                        td { (verdict::departure_word(&tried.departure())) }
                    }
                }
            }
        }
    };
    steps.push(full, Brief::Each);
}

fn accelerations(earthquake: &Earthquake, is_on_plan: bool) -> Markup {
    let away = is_on_plan.then(|| earthquake.away());
    html! {
        @for value in [earthquake.horizontal(), earthquake.vertical()].into_iter().chain(away) {
            td.n { data value=(value) { (number(value)) } }
        }
    }
}
