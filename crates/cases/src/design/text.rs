//! A design for reading.

use standfast::Mode;

use super::search::{Below, Found};
use super::{Change, Design, Target, least, load_factor, overturning, sliding, with_unit};
use crate::assess::verdict::departure_word;
use crate::assess::{Assessed, Assessment, heading};
use crate::layout::{columns, digits, paragraph, row};

pub(super) fn render(design: &Design) -> String {
    let Design { request, variable, bracket, found, present, .. } = design;
    let mut text = heading(&present.case);
    text += "Design\n";
    let [from, to] = bracket.map(|value| with_unit(value, variable));
    let wanted = words(request.target);
    text += &paragraph(&format!("The least {} from {from} to {to} for which {wanted}.", variable.name()), 2);
    text += "\n";
    text += &before_and_after(design);
    text += "\nBinding\n";
    text += &paragraph(&binding(found), 2);
    if let Some((until, reason)) = &found.until {
        let until = with_unit(*until, variable);
        text += &paragraph(&format!("Beyond {until} the target fails again: {reason}."), 2);
    }
    for warning in design.new_warnings() {
        text += &paragraph(&format!("Warning: {warning}."), 2);
    }
    for note in design.notes() {
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
    let Design { variable, value, present, found, .. } = design;
    let symbol = |mode: Option<Mode>| mode.map_or("none", Mode::symbol).to_owned();
    // Of several situations, the one in which it is worst: said once where it is the same throughout.
    let name = |answer: &Assessment, of: fn(&Assessed) -> f64| {
        answer.name(answer.least(of)).filter(|_| answer.all.len() > 1)
    };
    let names: Vec<_> = [present, &found.answer]
        .into_iter()
        .flat_map(|answer| [sliding, overturning, load_factor].map(|of| name(answer, of)))
        .collect();
    let same = names.iter().all(|name| *name == names[0]);
    let under = |answer: &Assessment, of: fn(&Assessed) -> f64| {
        name(answer, of).filter(|_| !same).map_or(String::new(), |name| format!(", {name}"))
    };
    let both = |words: &str, of: &dyn Fn(&Assessment) -> String| row![words, of(present), of(&found.answer)];
    let rows = [
        row!["", "at present", "found"],
        row![variable.name(), with_unit(*value, variable), with_unit(found.value, variable)],
        both("SF sliding", &|answer| digits(least(answer, sliding)) + &under(answer, sliding)),
        both("SF overturning", &|answer| digits(least(answer, overturning)) + &under(answer, overturning)),
        both("mode under the full load", &|answer| {
            symbol(answer.least(load_factor).outcome.full.mode) + &under(answer, load_factor)
        }),
        both("leaves rest at", &|answer| {
            departure_word(answer.least(load_factor).departure()) + &under(answer, load_factor)
        }),
        both("into", &|answer| {
            answer.least(load_factor).departure().mode().map_or("", Mode::symbol).to_owned()
        }),
    ];
    let worst = names.into_iter().next().flatten().filter(|_| same);
    columns(&rows, 2, &[1, 2])
        + &worst.map_or(String::new(), |name| paragraph(&format!("The worst throughout: {name}."), 2))
}

fn binding(found: &Found) -> String {
    match &found.below {
        Below::End => "The lower end of the range meets the target already; nothing binds.".to_owned(),
        Below::Fails(why) => format!("Just below the value found: {why}."),
        Below::NoCase(why) => format!("Just below the value found the case makes no sense: {why}."),
    }
}

fn sensitivities(design: &Design) -> String {
    let mut rows = vec![row!["input", "value", "SF sliding", "SF overturning", "load factor"]];
    let signed = |change: Change| match change.number() {
        Some(change) => format!("{change:+.5}"),
        None => change.words().to_owned(),
    };
    rows.extend(design.sensitivities.iter().map(|sensitivity| {
        let variable = &sensitivity.variable;
        row![
            variable.name(),
            with_unit(sensitivity.value, variable),
            signed(sensitivity.sliding),
            signed(sensitivity.overturning),
            signed(sensitivity.load_factor),
        ]
    }));
    columns(&rows, 2, &[2, 3, 4])
}
