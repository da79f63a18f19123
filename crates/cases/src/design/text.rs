//! A design for reading.

use standfast::Verdict;

use super::summary::summary;
use super::{
    DIGITS, Design, End, Extreme, OuterState, SensitivityChange, Stretch, Target, farthest, load_factor,
    overturning, overturns, sliding, steepest, with_unit,
};
use crate::assess::joint_words::slashed;
use crate::assess::verdict::departure_word;
use crate::assess::{Assessed, Assessment, note, title};
use crate::key::Key;
use crate::layout::{columns, digits, factor, paragraph, row, significant};
use crate::summary::capital;

pub(super) fn render(design: &Design) -> String {
    let Design { request, quantity, present, .. } = design;
    let mut text = title(&present.case);
    text += &summary(design).text();
    text += "\n";
    text += &note(&present.case);
    text += "Design\n";
    let range = quantity.range_words();
    let (extreme, name, wanted) = (request.extreme, quantity.variable.name(), request.target.words());
    text += &paragraph(&format!("The {extreme} {name} {range} for which {wanted}."), 2);
    text += "\n";
    text += &before_and_after(design);
    for warning in design.warnings() {
        text += &paragraph(&format!("Warning: {warning}."), 2);
    }
    text += "\nBinding\n";
    for sentence in binding(design) {
        text += &paragraph(&sentence, 2);
    }
    for note in design.notes() {
        text += &paragraph(&note, 2);
    }
    text += "\nSensitivity: change if one input grows by 1 %, with what has to go with it\n";
    text += &sensitivities(design);
    text
}

fn before_and_after(design: &Design) -> String {
    let Design { quantity, present, request, .. } = design;
    let found = design.found();
    let symbol = |verdict: Option<Verdict>| verdict.map_or("none", Verdict::symbol).to_owned();
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
    let of = |answer: &Assessment, of: fn(&Assessed) -> f64| {
        let worst = answer.least(of);
        let value = if worst.is_lifted() { "none".to_owned() } else { factor(of(worst)) };
        value + &under(answer, of)
    };
    let joints = !present.case.joints.is_empty();
    let mode = if joints { "modes under the full load" } else { "mode under the full load" };
    let both = |words: &str, of: &dyn Fn(&Assessment) -> String| row![words, of(present), of(&found.answer)];
    let mut rows = vec![
        row!["", "at present", "found"],
        row![quantity.variable.name(), quantity.shown(quantity.present), &found.text],
        both("SF sliding", &|answer| of(answer, sliding)),
        both("SF overturning", &|answer| of(answer, overturning)),
        both(mode, &|answer| {
            let worst = answer.least(load_factor);
            let modes = worst.joints.as_ref().map(|joints| joints.modes().map_or("–".to_owned(), slashed));
            modes.unwrap_or_else(|| symbol(worst.verdict())) + &under(answer, load_factor)
        }),
        both("leaves rest at", &|answer| {
            departure_word(&answer.least(load_factor).departure()) + &under(answer, load_factor)
        }),
        both("into", &|answer| {
            let worst = answer.least(load_factor);
            match &worst.joints {
                Some(joints) => slashed(joints.departing()),
                None => worst.departure().verdict().map_or("", Verdict::symbol).to_owned(),
            }
        }),
    ];
    rows.extend(asked(request.target, present, &found.answer));
    if overturns(present).is_some() {
        let number = |value: Option<f64>, unit: &str| {
            value.map_or_else(|| "none".to_owned(), |value| digits(value) + unit)
        };
        rows.push(both("slide at the end", &|answer| number(farthest(answer), " m")));
        rows.push(both("largest |θ|", &|answer| number(steepest(answer), " rad")));
        let yes = |answer: &Assessment| if overturns(answer) == Some(true) { "yes" } else { "no" };
        rows.push(both("overturns", &|answer| yes(answer).to_owned()));
    }
    let worst = names.into_iter().next().flatten().filter(|_| same);
    columns(&rows, 2, &[1, 2])
        + &worst.map_or(String::new(), |name| paragraph(&format!("The worst throughout: {name}."), 2))
}

/// Result that the target asks for, at present and as found, where the rows above do not have it.
fn asked(target: Target, present: &Assessment, found: &Assessment) -> Option<Vec<String>> {
    let value = |answer: &Assessment| {
        let checks = target.checks(answer);
        let motion = target.motion_checks(answer);
        let instant = checks.first().map_or(f64::NEG_INFINITY, |worst| worst.check.urgency());
        if let Some((worst, _)) = motion.first().filter(|(check, _)| check.urgency() > instant) {
            return Some(format!("{}, {}", worst.utilisation_words(), worst.criterion.name()));
        }
        let worst = checks.first()?;
        Some(match target {
            Target::Utilisation(_) => {
                format!("{}, {}", worst.check.utilisation_words(), worst.check.criterion.name())
            }
            _ => worst.check.value_words(worst.assessed),
        })
    };
    let name = match target {
        Target::Utilisation(_) => "utilisation",
        Target::Criterion(criterion) => match criterion.key {
            Key::LeastSliding | Key::LeastOverturningNet | Key::LeastLoadFactor => return None,
            _ => criterion.name(),
        },
        _ => return None,
    };
    Some(row![name, value(present)?, value(found)?])
}

/// Sentences on the end found: the failure that binds, its rounding, and the other values that meet the target.
fn binding(design: &Design) -> Vec<String> {
    let found = design.found();
    let mut sentences: Vec<_> = found.beyond.words().map(sentence).into_iter().collect();
    if found.rounded != found.value {
        let exact = with_unit_to(design, found);
        let side = match design.request.extreme {
            Extreme::Least => "up",
            Extreme::Greatest => "down",
        };
        sentences.push(format!(
            "The boundary is at {exact}; the value found is rounded {side} from it, and assessed as it is printed."
        ));
    }
    let other = design.request.extreme.other().of(&design.stretches[design.at]);
    if let Some(words) = other.beyond.words() {
        let side = match design.request.extreme {
            Extreme::Least => "up",
            Extreme::Greatest => "down",
        };
        sentences.push(format!("From the value found {side} to {} the target is met; {words}.", other.text));
    }
    let others = design.stretches.iter().enumerate().filter(|(place, _)| *place != design.at);
    sentences.extend(others.map(|(_, stretch)| apart(stretch)));
    sentences
}

/// The boundary in more digits than are printed of it.
fn with_unit_to(design: &Design, end: &End) -> String {
    let variable = &design.quantity.variable;
    let apart = (5..=12).find(|count| significant(end.value, *count) != significant(end.rounded, *count));
    with_unit(end.value, variable, apart.unwrap_or(5) + 1)
}

/// That the target is met elsewhere, too.
fn apart(Stretch { least, greatest }: &Stretch) -> String {
    let why = [least, greatest].into_iter().filter_map(|end| end.beyond.words()).collect::<Vec<_>>();
    let end = if matches!(greatest.beyond, OuterState::Range) { ", the end of the range" } else { "" };
    let why = if why.is_empty() { String::new() } else { format!("; {}", why.join("; ")) };
    format!("Apart from that the target is met from {} to {}{end}{why}.", least.text, greatest.text)
}

/// Words as a sentence of their own.
pub(super) fn sentence(words: String) -> String {
    capital(&words) + "."
}

/// A change with its sign, to five decimals.
pub fn change_words(change: f64) -> String {
    match format!("{change:+.5}") {
        zero if zero.ends_with("0.00000") => "0".to_owned(),
        text => text,
    }
}

fn sensitivities(design: &Design) -> String {
    let in_time = design.sensitivities.iter().any(|sensitivity| sensitivity.motion.is_some());
    let mut rows = vec![row!["input", "value", "SF sliding", "SF overturning", "load factor"]];
    if in_time {
        rows[0].extend(row!["slide", "|θ|"]);
    }
    let signed = |change: SensitivityChange| match change.number() {
        Some(change) => change_words(change),
        None => change.words().to_owned(),
    };
    rows.extend(design.sensitivities.iter().map(|sensitivity| {
        let variable = &sensitivity.variable;
        let mut row = row![
            variable.name(),
            with_unit(sensitivity.value, variable, DIGITS),
            signed(sensitivity.sliding),
            signed(sensitivity.overturning),
            signed(sensitivity.load_factor),
        ];
        row.extend(sensitivity.motion.into_iter().flatten().map(signed));
        row
    }));
    columns(&rows, 2, &[2, 3, 4, 5, 6])
}
