//! Water under a base that opens: the length that stays pressed, and what the water then lifts.

use standfast::OpeningRule;
use standfast::contact::opening::OpeningState;
use standfast::loads::{Action, Face, LoadSource};
use standfast_cases::Assessed;
use standfast_cases::assess::Component;
use standfast_cases::assess::opening::{HELD, told};
use standfast_cases::units::Extent;

use super::loads::{grouped, parts, sum};
use crate::measured::{
    FACTOR, FORCE_SQUARED, FORCE_SQUARED_OF_OBJECT, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE,
};
use crate::steps::SheetSteps;

/// True if a load is still water under a base of which it is told how it opens.
pub(super) fn is_followed(assessed: &Assessed, component: &Component) -> bool {
    is_under_base(component) && told(assessed).is_some()
}

pub(super) fn steps(steps: &mut SheetSteps, assessed: &Assessed, components: &[Component]) {
    let Some(opening) = told(assessed) else { return };
    steps.heading("Water under a base that opens");
    steps.note(
        "Where the base opens, the higher head stands; from its end the pressure falls in a straight line to the lower one. No pull and a \
         straight pressure of the base over the contact give its length, `3 T_o/N_o`, with both as if the higher head stood under the whole base.",
    );
    let right_is_high = opening.heads[1] >= opening.heads[0];
    let [low, high] = if right_is_high { opening.heads } else { [opening.heads[1], opening.heads[0]] };
    let (end, arm, sign) = if right_is_high { ("O", "b_1", "−") } else { ("O′", "b_2", "+") };
    let words = "ρ g times the level, with the factor of the combination";
    steps.told("Pressure under the end of the higher head", "p_H", high, KILOPASCAL, words, "");
    steps.told("Pressure under the end of the lower head", "p_N", low, KILOPASCAL, words, "");
    let counts = |component: &Component| {
        let fast = component.load.is_fast && !component.load.permanent && opening.rule == OpeningRule::Steady;
        !is_followed(assessed, component) && !fast
    };
    let of = |which: usize, part: fn(&standfast::Wrench) -> f64| {
        let counted = components.iter().enumerate().filter(|(_, component)| counts(component));
        let terms: Vec<(String, f64)> =
            counted.map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench))).collect();
        let value: f64 = terms.iter().map(|(_, value)| value).sum();
        (sum(terms.into_iter()), value)
    };
    let (down, p) = of(1, |wrench| wrench.p);
    let (turn, m) = of(2, |wrench| wrench.m);
    let (push, x) = of(0, |wrench| wrench.x);
    let body = assessed.situation.body();
    let centre = if right_is_high { body.heel_distance() } else { body.toe_distance() };
    let side = if right_is_high { 1.0 } else { -1.0 };
    if opening.is_held {
        steps.note(HELD);
    }
    steps.add(
        "Vertical force of all other loads that count",
        "",
        ["W_d", &down.unwrap_or_else(|| "0".to_owned())],
        p,
        KILONEWTON,
        "",
    );
    let about = format!("Their moment about {end}, which holds the body down");
    let mut formula = format!("W_d {arm}");
    if let Some(turn) = turn {
        formula += &format!(" {sign} {}", grouped(&turn));
    }
    if let Some(push) = push {
        let plus = if right_is_high { "+" } else { "−" };
        formula += &format!(" {plus} {} y_C", grouped(&push));
    }
    let holding = p * centre - side * (m - x * body.centroid_height());
    steps.add(&about, "", ["M_d", &formula], holding, MOMENT, "");
    let long = match body.plan() {
        standfast::Plan::Rectangle { length } if length != 1.0 => (" L_b", length),
        _ => ("", 1.0),
    };
    let base = body.base_width();
    let (n, t) = (p - high * base * long.1, holding - high * base * base / 2.0 * long.1);
    steps.add(
        "With the higher head under all of the base",
        "",
        ["N_o", &format!("W_d − p_H B_c{}", long.0)],
        n,
        KILONEWTON,
        "",
    );
    steps.add("and about that end", "", ["T_o", &format!("M_d − p_H B_c^2/2{}", long.0)], t, MOMENT, "");
    let delta = high - low;
    let contact = opening.contact(base);
    let (mut force, mut squared) = (String::new(), String::new());
    if let Some(drain) = opening.drain {
        let distance = if right_is_high { drain.distance } else { base - drain.distance };
        steps.told("Drains, from the end of the lower head", "x_d", distance, METRE, "drain", "");
        steps.told("Their efficiency", "E_d", drain.efficiency, NONE, "drain", "");
        let drained = drain.efficiency * delta * distance / 2.0 * long.1;
        steps.add(
            "What they take off the water",
            "",
            ["D_o", &format!("E_d (p_H − p_N) x_d/2{}", long.0)],
            drained,
            KILONEWTON,
            "",
        );
        if opening.drain_works() == Some(true) {
            (force, squared) = (" − D_o".to_owned(), " + D_o x_d".to_owned());
        } else {
            steps.note("The base has opened beyond the drains: they are lost.");
        }
    }
    match opening.state {
        OpeningState::Closed => {
            steps.told("No part of the base is pulled: pressed", "c_o", base, METRE, "the whole base", "");
        }
        OpeningState::Open { .. } => {
            let formula = match squared.as_str() {
                "" => "3 T_o/N_o".to_owned(),
                squared => format!("(3 T_o{squared})/N_o"),
            };
            steps.add("Length that stays pressed", "no tension", ["c_o", &formula], contact, METRE, "");
        }
        OpeningState::Through => {
            let words = "nothing holds the body down with the higher head under all of it";
            steps.told("Length that stays pressed", "c_o", 0.0, METRE, words, "");
        }
    }
    let formula = format!("p_H B_c{0} − (p_H − p_N)/2 c_o{0}{force}", long.0);
    steps.add("Uplift of the water", "", ["U_o", &formula], opening.uplift, KILONEWTON, "");
    if opening.state != OpeningState::Closed {
        steps.told("It would be", "U_c", opening.uplift_closed, KILONEWTON, "if nothing opened", "");
    }
}

/// The departure of a body whose base has opened by then under loads that water follows: tipping, where nothing is pressed any more, or
/// sliding, by a quadratic. False where another condition tells.
pub(super) fn departure(
    steps: &mut SheetSteps,
    assessed: &Assessed,
    components: &[Component],
    factor: f64,
    [about, name, key]: [&str; 3],
) -> bool {
    let situation = &assessed.situation;
    let Some(opening) = situation.base_opening().filter(|opening| !opening.is_held) else { return false };
    let below = situation.opening_at(factor * (1.0 - 1e-9));
    let OpeningState::Open { drained, .. } = below else { return false };
    let body = situation.body();
    let right_is_high = opening.heads[1] >= opening.heads[0];
    let [low, high] = if right_is_high { opening.heads } else { [opening.heads[1], opening.heads[0]] };
    let (arm, centre, side) = match right_is_high {
        true => ("b_1", body.heel_distance(), 1.0),
        false => ("b_2", body.toe_distance(), -1.0),
    };
    let base = body.base_width();
    let long = match body.plan() {
        standfast::Plan::Rectangle { length } => length,
        _ => 1.0,
    };
    let delta = (high - low) * long;
    let [[w_g, m_g, x_g], [n_q, t_q, x_q]] = [true, false].map(|permanent| {
        let of = components
            .iter()
            .filter(|component| component.load.permanent == permanent && !is_under_base(component));
        let sum = of.fold(standfast::Wrench::ZERO, |sum, component| sum + component.wrench);
        [sum.p, sum.p * centre - side * (sum.m - sum.x * body.centroid_height()), sum.x]
    });
    let (n_g, t_g) = (w_g - high * long * base, m_g - high * long * base * base / 2.0);
    let what = |permanent: bool| if permanent { "permanent" } else { "variable" };
    let end = if right_is_high { "O" } else { "O′" };
    steps.told("Pressure under the end of the higher head", "p_H", high, KILOPASCAL, "as above", "");
    steps.told("Pressure under the end of the lower head", "p_N", low, KILOPASCAL, "as above", "");
    let mut sums = |permanent: bool, names: [&str; 3], values: [f64; 3]| {
        let of = |which: usize, part: fn(&standfast::Wrench) -> f64| {
            let counted = components
                .iter()
                .enumerate()
                .filter(|(_, component)| component.load.permanent == permanent && !is_under_base(component));
            sum(counted.map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench))))
        };
        let zero = || "0".to_owned();
        let (down, turn, push) =
            (of(1, |wrench| wrench.p), of(2, |wrench| wrench.m), of(0, |wrench| wrench.x));
        let water = if permanent { [" − p_H B_c", " − p_H B_c^2/2"] } else { ["", ""] };
        let length = if long == 1.0 || !permanent { "" } else { " L_b" };
        let down = down.unwrap_or_else(zero);
        let about = format!("The {} loads together, the higher head under all of the base", what(permanent));
        let formula = format!("{down}{}{length}", water[0]);
        steps.add(&about, "", [names[0], &formula], values[0], KILONEWTON, "");
        let mut formula = if down == "0" { String::new() } else { format!("{} {arm}", grouped(&down)) };
        let mut add = |plus: bool, term: &str| {
            formula += match (formula.is_empty(), plus) {
                (true, true) => "",
                (true, false) => "−",
                (false, true) => " + ",
                (false, false) => " − ",
            };
            formula += term;
        };
        if let Some(turn) = turn {
            add(!right_is_high, &grouped(&turn));
        }
        if let Some(push) = &push {
            add(right_is_high, &format!("{} y_C", grouped(push)));
        }
        let about = format!("Their moment about {end}, which holds the body down");
        let formula = format!("{formula}{}{length}", water[1]);
        steps.add(&about, "", [names[1], &formula], values[1], MOMENT, "");
        let about = "Their horizontal force";
        steps.add(about, "", [names[2], &push.unwrap_or_else(zero)], values[2], KILONEWTON, "");
    };
    sums(true, ["N_G", "T_G", "X_G"], [n_g, t_g, x_g]);
    sums(false, ["N_Q", "T_Q", "X_Q"], [n_q, t_q, x_q]);
    let near = |found: f64| (found - factor).abs() <= 1e-9 * factor;
    if near(-t_g / t_q) {
        let about = format!("{about}: nothing is pressed any more, `T_G + λ_d T_Q` is zero");
        steps.add(&about, "", [name, "−T_G/T_Q"], factor, FACTOR, key);
        return true;
    }
    let μ = situation.static_friction();
    let (force, squared) = match opening.drain.filter(|_| drained) {
        Some(drain) => {
            let distance = if right_is_high { drain.distance } else { base - drain.distance };
            let force = drain.efficiency * delta * distance / 2.0;
            (force, force * distance)
        }
        None => (0.0, 0.0),
    };
    let σ = if x_g + factor * x_q > 0.0 { 1.0 } else { -1.0 };
    let a = σ * x_q * n_q - μ * n_q * n_q;
    let b = σ * (x_g * n_q + x_q * n_g) - μ * (2.0 * n_g * n_q + 1.5 * delta * t_q + force * n_q);
    let c = σ * x_g * n_g - μ * (n_g * n_g + 1.5 * delta * t_g + 0.5 * delta * squared + force * n_g);
    let sign = if σ > 0.0 { "" } else { "−" };
    let length = if long == 1.0 { "" } else { " L_b" };
    let (of_drain_b, of_drain_c) = match force {
        0.0 => (String::new(), String::new()),
        _ => (" + D_o N_Q".to_owned(), format!(" + (p_H − p_N){length} D_o x_d/2 + D_o N_G")),
    };
    if force != 0.0 {
        steps.told(
            "What the drains take off the water",
            "D_o",
            force,
            KILONEWTON,
            "E_d (p_H − p_N) x_d/2",
            "",
        );
    }
    let group = |terms: &str| if sign.is_empty() { format!("({terms})") } else { format!("−({terms})") };
    let quadratic = match assessed.extent {
        Extent::PerMetre => FORCE_SQUARED,
        Extent::Whole => FORCE_SQUARED_OF_OBJECT,
    };
    steps.note("Sliding of a base that has opened, `|X| N` against `μ (N^2 + 1.5 (p_H − p_N) T)`: a quadratic in the load factor, with the coefficients");
    let formula = if n_q == 0.0 { "0".to_owned() } else { format!("{} − μ N_Q^2", group("X_Q N_Q")) };
    steps.add("", "", ["a_λ", &formula], a, quadratic, "");
    let formula =
        format!("{} − μ (2 N_G N_Q + 1.5 (p_H − p_N){length} T_Q{of_drain_b})", group("X_G N_Q + X_Q N_G"));
    steps.add("", "", ["b_λ", &formula], b, quadratic, "");
    let formula = format!("{} − μ (N_G^2 + 1.5 (p_H − p_N){length} T_G{of_drain_c})", group("X_G N_G"));
    steps.add("", "", ["c_λ", &formula], c, quadratic, "");
    let about = format!("{about}: the least at which a condition of rest is crossed, that of sliding");
    let root = (b * b - 4.0 * a * c).sqrt();
    let formula = match a {
        0.0 => "−c_λ/b_λ",
        _ if near((-b + root) / (2.0 * a)) => "(−b_λ + sqrt(b_λ^2 − 4 a_λ c_λ))/(2 a_λ)",
        _ if near((-b - root) / (2.0 * a)) => "(−b_λ − sqrt(b_λ^2 − 4 a_λ c_λ))/(2 a_λ)",
        _ => "",
    };
    match formula {
        "" => steps.told(
            &about,
            name,
            factor,
            FACTOR,
            "the least λ at which a condition of rest is crossed",
            key,
        ),
        formula => steps.add(&about, "", [name, formula], factor, FACTOR, key),
    }
    true
}

/// True of still water under the base.
fn is_under_base(component: &Component) -> bool {
    let under = matches!(component.load.action, Action::Pressure { face: Face::Base, .. });
    component.load.source == LoadSource::Buoyancy && under
}
