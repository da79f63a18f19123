//! The way to the full load.

use maud::{Markup, html};
use standfast::{Departure, Verdict, Wrench};
use standfast_cases::assess::{Component, verdict};
use standfast_cases::{Assessed, AssessmentView};

use super::loads::{parts, sum};
use super::opening;
use crate::measured::{FACTOR, KILONEWTON, MOMENT, number};
use crate::steps::SheetSteps;
use crate::together::{Brief, Row};

/// The table of stages of the rising load: from which factor to which, in what, and what is consistent as well.
pub(super) fn table(
    key: &str,
    what: &str,
    stages: impl Iterator<Item = (f64, f64, String, String)>,
) -> Markup {
    html! {
        table.numbers data-table=(key) {
            thead { tr { th.n { "from" } th.n { "to" } th { (what) } th { "Also consistent" } } }
            tbody {
                @for (from, to, what, also) in stages {
                    tr {
                        td.n { data value=(from) { (number(from)) } }
                        td.n { data value=(to) { (number(to)) } }
                        td { (what) }
                        td { (also) }
                    }
                }
            }
        }
    }
}

pub(super) fn steps(
    steps: &mut SheetSteps,
    assessed: &Assessed,
    components: &[Component],
    view: &AssessmentView,
) {
    let stages = assessed.path_up_to(view.up_to);
    steps.heading("Load path: the variable loads rise by a factor, the permanent ones stay");
    if !stages.is_empty() {
        let rows = stages.iter().map(|stage| {
            let mode = stage.verdict.map_or("none", Verdict::symbol).to_owned();
            (stage.from, stage.to, mode, stage.others().to_string())
        });
        let full = table("path", "Mode", rows);
        let row = Row {
            name: String::new(),
            key: "path".to_owned(),
            about: html! {},
            head: html! { "Mode from one load factor to another, and in parentheses what is consistent as well" },
            unit: html! {},
            cell: html! {
                div data-table="path" {
                    @for stage in &stages {
                        div {
                            data value=(stage.from) { (number(stage.from)) } " … "
                            data value=(stage.to) { (number(stage.to)) } ": "
                            (stage.verdict.map_or("none", Verdict::symbol))
                            @let others = stage.others().to_string();
                            @if !others.is_empty() { " (" (others) ")" }
                        }
                    }
                }
            },
        };
        steps.push(full, Brief::Rows(vec![row]));
    }
    for sentence in verdict::path(assessed) {
        // The verdict of the sheet has them of every situation.
        let words = html! { p.note { (sentence.replace('`', "'")) } };
        steps.push(words, Brief::Nothing);
    }
    if let Departure::At { factor, .. } = assessed.departure() {
        departure(steps, assessed, components, factor);
    }
}

/// A term of a condition of rest: its sign, its factor, its symbol, and its value with both.
pub(super) type Term = (bool, &'static str, &'static str, f64);

/// A condition of rest where it is crossed: (what of the permanent loads is left of it)/(what the variable ones take of it).
struct Condition {
    words: &'static str,
    permanent: [Term; 3],
    variable: [Term; 3],
}

/// Shows the departure from rest: the condition of rest that the rising load crosses there.
pub(super) fn departure(steps: &mut SheetSteps, assessed: &Assessed, components: &[Component], factor: f64) {
    const ABOUT: &str = "Load factor at which the body leaves rest";
    const NAME: &str = "λ_d";
    const KEY: &str = "load_factor";
    let [permanent, variable] = [true, false].map(|permanent| {
        let of = components.iter().filter(|component| component.load.permanent == permanent);
        of.fold(Wrench::ZERO, |sum, component| sum + component.wrench)
    });
    if opening::departure(steps, assessed, components, factor, [ABOUT, NAME, KEY]) {
        return;
    }
    let share = |wrench: fn(&Wrench) -> f64| wrench(&permanent) + factor * wrench(&variable);
    let conditions = conditions(assessed, &permanent, &variable, share(|wrench| wrench.x));
    // Of the conditions the one that gives the library's load factor; where none does the mode is decided in another way.
    let found = conditions.iter().find(|condition| {
        let at = value(&condition.permanent) / value(&condition.variable);
        (at - factor).abs() <= 1e-9 * factor
    });
    let of_ground = assessed.ground.as_ref().and_then(|ground| ground.load_factors).map(|found| found.given);
    if found.is_none() && of_ground.is_some_and(|given| (given - factor).abs() <= 1e-9 * factor) {
        let about = format!("{ABOUT}: the base does not bear more");
        return steps.add(&about, "", [NAME, "λ_R"], factor, FACTOR, KEY);
    }
    let Some(condition) = found else {
        let words = "the least λ at which a condition of rest is crossed";
        return steps.told(ABOUT, NAME, factor, FACTOR, words, KEY);
    };
    sums(steps, components, true, &condition.permanent, &permanent);
    sums(steps, components, false, &condition.variable, &variable);
    let about = format!("{ABOUT}: the least at which a condition of rest is crossed, {}", condition.words);
    let formula = format!("{}/{}", written(&condition.permanent), written(&condition.variable));
    steps.add(&about, "", [NAME, &formula], factor, FACTOR, KEY);
}

/// The conditions of rest with what the loads are to them; `along` is the force along the base where the body leaves rest.
fn conditions(assessed: &Assessed, permanent: &Wrench, variable: &Wrench, along: f64) -> [Condition; 3] {
    let situation = &assessed.situation;
    let body = situation.body();
    let (mu, y) = (situation.static_friction(), body.centroid_height());
    let (b_1, b_2) = (body.heel_distance(), body.toe_distance());
    let right = along > 0.0;
    let sign = |minus: bool, value: f64| if minus { -value } else { value };
    let sliding = |wrench: &Wrench, [v, x]: [&'static str; 2], flip: bool| -> [Term; 3] {
        let x_minus = right != flip;
        [
            (flip, "μ ", v, sign(flip, mu * wrench.p)),
            (x_minus, "", x, sign(x_minus, wrench.x)),
            (false, "", "", 0.0),
        ]
    };
    // μ V − X ≥ 0 or μ V + X ≥ 0; b_1 V + X y_C − M ≥ 0; b_2 V − X y_C + M ≥ 0: of each what is permanent over less what varies.
    let turning = |wrench: &Wrench, [v, x, m]: [&'static str; 3], toe: bool, flip: bool| -> [Term; 3] {
        let (arm, b) = if toe { ("b_2 ", b_2) } else { ("b_1 ", b_1) };
        [
            (flip, arm, v, sign(flip, b * wrench.p)),
            (toe != flip, "y_C ", x, sign(toe != flip, y * wrench.x)),
            (toe == flip, "", m, sign(toe == flip, wrench.m)),
        ]
    };
    const GIVEN: [&str; 3] = ["V_G", "X_G", "M_G"];
    const RISING: [&str; 3] = ["V_Q", "X_Q", "M_Q"];
    let of_turning = |words, toe| Condition {
        words,
        permanent: turning(permanent, GIVEN, toe, false),
        variable: turning(variable, RISING, toe, true),
    };
    [
        Condition {
            words: "that of sliding, `|X|` = `μ V`",
            permanent: sliding(permanent, ["V_G", "X_G"], false),
            variable: sliding(variable, ["V_Q", "X_Q"], true),
        },
        of_turning("that of turning about O, `b_1 V + y_C X` = `M`", false),
        of_turning("that of turning about O′, `b_2 V + M` = `y_C X`", true),
    ]
}

fn value(terms: &[Term; 3]) -> f64 {
    terms.iter().map(|(_, _, _, value)| value).sum()
}

/// The terms that are not zero as a formula.
fn written(terms: &[Term; 3]) -> String {
    let mut text = String::new();
    for (minus, factor, name, _) in terms.iter().filter(|(_, _, _, value)| *value != 0.0) {
        text += match (text.is_empty(), minus) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        text += &format!("{factor}{name}");
    }
    format!("({text})")
}

/// The sums that the terms name, of the loads that are permanent or not.
pub(super) fn sums(
    steps: &mut SheetSteps,
    components: &[Component],
    permanent: bool,
    terms: &[Term; 3],
    total: &Wrench,
) {
    let words = if permanent { "permanent" } else { "variable" };
    let mut about = format!("The {words} loads together");
    for (_, _, name, _) in terms.iter().filter(|(_, _, _, value)| *value != 0.0) {
        let (which, part, unit): (usize, fn(&Wrench) -> f64, _) = match name.chars().next() {
            Some('X') => (0, |wrench| wrench.x, KILONEWTON),
            Some('V') => (1, |wrench| wrench.p, KILONEWTON),
            _ => (2, |wrench| wrench.m, MOMENT),
        };
        let of = components.iter().enumerate().filter(|(_, component)| component.load.permanent == permanent);
        let formula = sum(of.map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench))));
        if let Some(formula) = formula {
            steps.add(&about, "", [name, &formula], part(total), unit, "");
            about.clear();
        }
    }
}
