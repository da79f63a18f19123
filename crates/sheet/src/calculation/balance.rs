//! What lifts the body against what presses it, what tips it against what holds it: where a criterion asks for it.

use standfast::Corner;
use standfast_cases::assess::{Balance, BalancePart, Component};
use standfast_cases::results::ResultName;
use standfast_cases::{Assessed, Case};

use super::loads::{parts, signed, sum};
use crate::measured::{FACTOR, KILONEWTON, MOMENT};
use crate::steps::SheetSteps;

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, components: &[Component]) {
    let criteria = case.criteria_of(assessed.acting);
    let is_asked = |result: ResultName| result.is_told(criteria);
    if !is_asked(ResultName::SfUplift) && !is_asked(ResultName::Tipping) {
        return;
    }
    let Some(balance) = assessed.balance() else {
        return steps.note(
            "Of a weight less buoyancy it is not known what acts down and what up: neither SF_uplift nor tipping is answered.",
        );
    };
    if is_asked(ResultName::SfUplift) {
        uplift(steps, &balance, components);
    }
    if is_asked(ResultName::Tipping) {
        tipping(steps, &balance);
    }
}

fn uplift(steps: &mut SheetSteps, balance: &Balance, components: &[Component]) {
    let [down, up] = balance.vertical();
    let of = |sign: f64| {
        let forces = components.iter().map(|component| (component.wrench.p * sign).max(0.0));
        sum(forces.enumerate().map(|(i, force)| (parts(i)[1].clone(), force)))
    };
    let (name, about) = ("SF_uplift", "Safety against uplift");
    let held = balance.held_down();
    if held > 0.0 {
        steps.told("Held down by resistances", "R_down", held, KILONEWTON, "each in full", "");
    }
    let pressing = match of(1.0) {
        Some(formula) if held > 0.0 => Some(format!("{formula} + R_down")),
        None if held > 0.0 => Some("R_down".to_owned()),
        pressing => pressing,
    };
    match pressing {
        Some(formula) => steps.add("All that acts down", "", ["V_down", &formula], down, KILONEWTON, ""),
        None => steps.told("All that acts down", "V_down", down, KILONEWTON, "nothing", ""),
    }
    match of(-1.0) {
        Some(formula) => {
            steps.add("All that acts up", "", ["V_up", &format!("−({formula})")], up, KILONEWTON, "");
            steps.add(about, "", [name, "V_down/V_up"], balance.uplift(), FACTOR, name);
        }
        None => steps.told(about, name, balance.uplift(), FACTOR, "nothing acts up", name),
    }
}

fn tipping(steps: &mut SheetSteps, balance: &Balance) {
    let corner = balance.corner();
    let letter = corner.letter().replace('\'', "′");
    steps.note(&format!(
        "Moments about {letter}, where tipping is the larger: of each load, its horizontal and its vertical part apart; above zero they tip the body."
    ));
    let (mut tips, mut holds) = (Vec::new(), Vec::new());
    for (place, part) in balance.parts().iter().enumerate() {
        let moment = part.tips(balance.body(), corner);
        if moment == 0.0 {
            continue;
        }
        let name = format!("T_{}", place + 1);
        one(steps, balance, part, corner, &name);
        if moment > 0.0 { tips.push(name) } else { holds.push(name) }
    }
    let held = balance.held_about(corner);
    if held > 0.0 {
        let words = "each that holds it there in full; below zero, as it holds";
        steps.told("Resistances", "T_R", -held, MOMENT, words, "");
        holds.push("T_R".to_owned());
    }
    let [tipping, holding] = balance.moments(corner);
    let about = "Moments that tip the body over those that hold it";
    if tips.is_empty() {
        return steps.told(about, "Λ_tip", balance.tipping(), FACTOR, "nothing tips it", "tipping");
    }
    steps.add("What tips it", "", ["T_tip", &tips.join(" + ")], tipping, MOMENT, "");
    if holds.is_empty() {
        return steps.told(about, "Λ_tip", balance.tipping(), FACTOR, "nothing holds it", "tipping");
    }
    steps.add("What holds it", "", ["T_hold", &format!("−({})", holds.join(" + "))], holding, MOMENT, "");
    steps.add(about, "", ["Λ_tip", "T_tip/T_hold"], balance.tipping(), FACTOR, "tipping");
}

/// The moment of one part.
fn one(steps: &mut SheetSteps, balance: &Balance, part: &BalancePart, corner: Corner, name: &str) {
    let [x, v, m] = parts(part.of);
    let moment = part.tips(balance.body(), corner);
    let about = format!("Load {}", part.of + 1);
    let about_o = corner == Corner::O;
    let arm = if about_o { "b_1" } else { "b_2" };
    if balance.parts().iter().filter(|other| other.of == part.of).count() > 1 {
        let words = if part.wrench.p == 0.0 { "of its horizontal part" } else { "of its vertical part" };
        return steps.told(&about, name, moment, MOMENT, words, "");
    }
    let terms = [
        (part.wrench.m, about_o, m),
        (part.wrench.x, !about_o, format!("{x} y_C")),
        (part.wrench.p, false, format!("{v} {arm}")),
    ];
    let terms = terms.into_iter().filter(|(value, ..)| *value != 0.0).map(|(_, plus, term)| (plus, term));
    steps.add(&about, "", [name, &signed(terms)], moment, MOMENT, "");
}
