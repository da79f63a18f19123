//! A design for reading.

use standfast::Mode;

use super::outcome::Outcome;
use super::search::Found;
use super::{Design, Target, with_unit};
use crate::assess::heading;
use crate::layout::{columns, digits, paragraph, row};

pub(super) fn render(design: &Design) -> String {
    let Design { case, request, variable, bracket, found, .. } = design;
    let mut text = heading(case);
    text += "Design\n";
    let [from, to] = bracket.map(|value| with_unit(value, variable));
    let wanted = words(request.target);
    text += &paragraph(&format!("The least {} from {from} to {to} for which {wanted}.", variable.name), 2);
    text += "\n";
    text += &before_and_after(design);
    text += "\nBinding\n";
    text += &paragraph(&binding(found), 2);
    if let Some((until, reason)) = &found.until {
        let until = with_unit(*until, variable);
        text += &paragraph(&format!("Beyond {until} the target fails again: {reason}."), 2);
    }
    for note in variable.notes(case) {
        text += &paragraph(&note, 2);
    }
    text += "\nSensitivity: change if one input grows by 1 %, with what has to go with it\n";
    text += &sensitivities(design);
    text
}

fn words(target: Target) -> String {
    match target {
        Target::Rest => "the body rests under the full load".to_owned(),
        Target::Factor(factor) => format!("both safety factors are {} at least", digits(factor)),
        Target::LoadFactor(factor) => {
            format!("the rising load moves the body at {} times its value at the earliest", digits(factor))
        }
        Target::NoRock => "the body turns about no corner, at once or while the load rises".to_owned(),
        Target::NoSlide => "the body slips at no corner, at once or while the load rises".to_owned(),
    }
}

fn before_and_after(design: &Design) -> String {
    let Design { variable, present, found, .. } = design;
    let symbol = |mode: Option<Mode>| mode.map_or("none", Mode::symbol);
    let factor = |outcome: &Outcome| match outcome.first_load_factor() {
        f64::INFINITY => "never".to_owned(),
        factor => format!("{} %", digits(100.0 * factor)),
    };
    let both = |words: &str, of: &dyn Fn(&Outcome) -> String| row![words, of(present), of(&found.outcome)];
    let rows = [
        row!["", "at present", "found"],
        row![variable.name.as_str(), with_unit(variable.present, variable), with_unit(found.value, variable)],
        both("SF sliding", &|outcome| digits(outcome.sliding())),
        both("SF overturning", &|outcome| digits(outcome.overturning())),
        both("mode under the full load", &|outcome| symbol(outcome.mode()).to_owned()),
        both("leaves rest at", &factor),
        both("into", &|outcome| outcome.first_mode().map_or("", Mode::symbol).to_owned()),
    ];
    columns(&rows, 2, &[1, 2])
}

fn binding(found: &Found) -> String {
    match &found.binding {
        Some(binding) => format!("Just below the value found: {binding}."),
        None if found.at_lower_end => {
            "The lower end of the range meets the target already; nothing binds.".to_owned()
        }
        None => "Below the value found the case makes no sense.".to_owned(),
    }
}

fn sensitivities(design: &Design) -> String {
    let mut rows = vec![row!["input", "value", "SF sliding", "SF overturning", "first load factor"]];
    let signed = |change: Option<f64>| match change {
        Some(change) => format!("{change:+.5}"),
        None => "–".to_owned(),
    };
    rows.extend(design.sensitivities.iter().map(|sensitivity| {
        let variable = &sensitivity.variable;
        row![
            variable.name.as_str(),
            with_unit(variable.present, variable),
            signed(sensitivity.sliding),
            signed(sensitivity.overturning),
            signed(sensitivity.first_load_factor),
        ]
    }));
    columns(&rows, 2, &[2, 3, 4])
}
