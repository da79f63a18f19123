//! The classical checks: actions, safety factors, bearing pressure at both edges of the base.

use standfast::loads::{LoadKind, LoadSource};
use standfast::{Bearing, ClassicalActions, Corner, Margins, Outcome, Plan, Stability, Wrench};
use standfast_cases::assess::{Component, checks};
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case};

use super::balance;
use super::holding::{self, HeldTerms};
use super::loads::{grouped, parts, sum};
use crate::measured::{FACTOR, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE};
use crate::steps::SheetSteps;

/// Value that common practice asks of both safety factors.
pub const TARGET: f64 = 1.2;

pub(super) fn steps(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    components: &[Component],
) -> HeldTerms {
    steps.heading("Classical checks");
    actions(steps, &assessed.outcome.actions, components);
    let held = holding::steps(steps, case, assessed);
    if assessed.outcome.held.is_some() {
        steps.heading("Factors, margins, pressure on the base");
    }
    factors(steps, case, assessed, components, &held);
    margins(steps, assessed, &held);
    pressure(steps, assessed, &held);
    held
}

/// The sum of a part of the loads of some kinds, as a formula.
fn sum_of(
    components: &[Component],
    kinds: &[LoadKind],
    which: usize,
    part: fn(&Wrench) -> f64,
) -> Option<String> {
    let parts = components
        .iter()
        .enumerate()
        .filter(|(_, component)| kinds.contains(&component.load.kind))
        .map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench)));
    sum(parts)
}

fn actions(steps: &mut SheetSteps, actions: &ClassicalActions, components: &[Component]) {
    use LoadKind::{Horizontal, Uplift, Weight};
    let ClassicalActions { heel, buoyant_weight, weight_arm, uplift, uplift_moment, force, force_moment } =
        *actions;
    let corner = heel.letter().replace('\'', "′");
    // The heel's distance from C, and the sign of a moment at C that turns the body about it.
    let (arm, sign, against) = if heel == Corner::O { ("b_1", "+", "−") } else { ("b_2", "−", "+") };
    let all = [Weight, Uplift, Horizontal];

    let about = "Weight less buoyancy, of all that counts as weight";
    match sum_of(components, &[Weight, Horizontal], 1, |wrench| wrench.p) {
        Some(formula) => steps.add(about, "", ["W'", &formula], buoyant_weight, KILONEWTON, "buoyant_weight"),
        None => steps.told(about, "W'", buoyant_weight, KILONEWTON, "none", "buoyant_weight"),
    }
    let about = format!("Its arm to the heel, {corner}");
    match sum_of(components, &[Weight], 2, |wrench| wrench.m) {
        _ if buoyant_weight == 0.0 => steps.told(&about, "t", 0.0, METRE, "no weight left", "weight_arm"),
        Some(moments) => {
            let formula = format!("{arm} {against} {}/W'", grouped(&moments));
            steps.add(&about, "", ["t", &formula], weight_arm, METRE, "weight_arm");
        }
        None => steps.add(&about, "", ["t", arm], weight_arm, METRE, "weight_arm"),
    }
    match sum_of(components, &[Uplift], 1, |wrench| wrench.p) {
        Some(formula) => {
            steps.add("Uplift", "", ["U", &format!("−{}", grouped(&formula))], uplift, KILONEWTON, "U");
            let moments = sum_of(components, &[Uplift], 2, |wrench| wrench.m);
            let moments = moments.map_or(String::new(), |moments| format!(" {sign} {}", grouped(&moments)));
            let formula = format!("U {arm}{moments}");
            steps.add("Its moment about the heel", "", ["M_U", &formula], uplift_moment, MOMENT, "M_U");
        }
        None => {
            steps.told("Uplift", "U", uplift, KILONEWTON, "no load counts as uplift", "U");
            steps.told("Its moment about the heel", "M_U", uplift_moment, MOMENT, "none", "M_U");
        }
    }
    let about = "Horizontal force";
    match sum_of(components, &all, 0, |wrench| wrench.x) {
        Some(formula) => steps.add(about, "", ["P", &format!("|{formula}|")], force, KILONEWTON, "P"),
        None => steps.told(about, "P", force, KILONEWTON, "none", "P"),
    }
    let about = "Its moment about the base, towards the heel";
    let moments = sum_of(components, &[Horizontal], 2, |wrench| wrench.m);
    let lever = (force != 0.0).then(|| "X y_C".to_owned());
    let formula = match (heel, moments, lever) {
        (Corner::O, Some(moments), Some(lever)) => format!("{moments} − {lever}"),
        (Corner::O, Some(moments), None) => moments,
        (Corner::O, None, Some(lever)) => format!("−{lever}"),
        (Corner::OPrime, Some(moments), Some(lever)) => format!("{lever} − {}", grouped(&moments)),
        (Corner::OPrime, Some(moments), None) => format!("−{}", grouped(&moments)),
        (Corner::OPrime, None, Some(lever)) => lever,
        (_, None, None) => return steps.told(about, "M_p", force_moment, MOMENT, "none", "M_p"),
    };
    steps.add(about, "", ["M_p", &formula], force_moment, MOMENT, "M_p");
}

fn factors(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    components: &[Component],
    held: &HeldTerms,
) {
    if assessed.outcome.full.is_lifted() {
        return steps.note("Nothing presses the body on its base: safety factors mean nothing.");
    }
    let stability = &assessed.outcome.stability;
    let Stability { sliding, overturning_about_heel, overturning_about_toe, .. } = *stability;
    let ClassicalActions { force, force_moment, .. } = assessed.outcome.actions;
    let about = "Safety against sliding";
    let resists = match held.sliding.as_str() {
        "" => "μ (W' − U)".to_owned(),
        more => format!("(μ (W' − U){more})"),
    };
    if let Some(effects) = assessed.situation.effects() {
        effects_of(steps, case, assessed, components, "P_d", 0, effects.x.abs());
        steps.add(about, "", ["SF_sliding", &format!("{resists}/P_d")], sliding, FACTOR, "SF_sliding");
    } else if force > 0.0 {
        steps.add(about, "", ["SF_sliding", &format!("{resists}/P")], sliding, FACTOR, "SF_sliding");
    } else {
        steps.told(about, "SF_sliding", sliding, FACTOR, "no horizontal force acts", "SF_sliding");
    }
    let heel = ["SF_heel", &format!("(W' t − M_U{})/M_p", held.heel)];
    let about = "Safety against overturning, about the heel";
    overturning(steps, about, heel, overturning_about_heel, force_moment > 0.0, "SF_overturning_heel");
    let toe = ["SF_toe", &format!("(W' (B_c − t) − U B_c + M_U{})/(−M_p)", held.toe)];
    let about = "The same about the other corner, the toe";
    overturning(steps, about, toe, overturning_about_toe, force_moment < 0.0, "SF_overturning_toe");
    let about = "The lesser of both";
    let lesser = match (overturning_about_heel.is_finite(), overturning_about_toe.is_finite()) {
        (true, true) => "min(SF_heel, SF_toe)",
        (true, false) => "SF_heel",
        (false, true) => "SF_toe",
        (false, false) => "",
    };
    let key = "SF_overturning_net";
    match lesser {
        "" => {
            steps.told(about, key, stability.overturning(), FACTOR, "no force turns the body", key);
            if let Some(words) = checks::no_factor(assessed) {
                steps.note(words);
            }
        }
        formula => steps.add(about, "", [key, formula], stability.overturning(), FACTOR, key),
    }
    gross(steps, assessed, components, held);
    balance::steps(steps, case, assessed, components);
    // That is practice for breakwaters.
    if !case.criteria_of(assessed.acting).is_empty() || case.goda().is_none() {
        return;
    }
    let met = |factor: f64| if factor >= TARGET { "met" } else { "not met" };
    steps.note(&format!(
        "Common practice asks for {TARGET} at least: against sliding {}, against overturning {}.",
        met(sliding),
        met(stability.overturning())
    ));
}

/// Shows the sum of a part of the loads, each times the factor of the combination, where factors act on effects.
pub(super) fn effects_of(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    components: &[Component],
    name: &str,
    which: usize,
    value: f64,
) {
    let mut terms = Vec::new();
    for (i, component) in components.iter().enumerate() {
        let part = [component.wrench.x, component.wrench.p][which];
        let factor = case.factor_on(assessed.acting, assessed.trial, &component.load);
        if part == 0.0 || factor == 0.0 {
            continue;
        }
        let symbol = format!("γ_E{}", i + 1);
        steps.told(&format!("Factor on the effect of load {}", i + 1), &symbol, factor, NONE, "factors", "");
        terms.push(format!("{symbol} {}", parts(i)[which]));
    }
    let (about, formula) = match which {
        0 => ("Horizontal force, each effect times its factor", format!("|{}|", terms.join(" + "))),
        _ => ("Vertical force, each effect times its factor", terms.join(" + ")),
    };
    if terms.is_empty() {
        return steps.told(about, name, value, KILONEWTON, "none", "");
    }
    steps.add(about, "", [name, &formula], value, KILONEWTON, "");
}

/// Shows the margins of the inequalities of rest.
fn margins(steps: &mut SheetSteps, assessed: &Assessed, held: &HeldTerms) {
    let margins = assessed.outcome.margins;
    let Margins { sliding, overturning_about_heel: heel, overturning_about_toe: toe } = margins;
    let about = "What friction leaves of the horizontal force; rest needs 0 or more, as of the next two";
    let against = if assessed.situation.effects().is_some() { "P_d" } else { "P" };
    let formula = format!("μ (W' − U){} − {against}", held.sliding);
    steps.add(about, "", ["Z_sliding", &formula], sliding, KILONEWTON, "margin_sliding");
    let about = "Moment that presses the body on its base, about the heel";
    steps.add(
        about,
        "",
        ["Z_heel", &format!("W' t − M_U − M_p{}", held.heel)],
        heel,
        MOMENT,
        "margin_overturning_heel",
    );
    let formula = ["Z_toe", &format!("W' (B_c − t) − U B_c + M_U + M_p{}", held.toe)];
    steps.add("The same about the toe", "", formula, toe, MOMENT, "margin_overturning_toe");
    let formula = ["Z_overturning", "min(Z_heel, Z_toe)"];
    steps.add("The lesser of both", "", formula, margins.overturning(), MOMENT, "margin_overturning");
}

/// The factor by gross moments, where water presses under the base.
fn gross(steps: &mut SheetSteps, assessed: &Assessed, components: &[Component], held: &HeldTerms) {
    let Outcome { actions, gross, .. } = &assessed.outcome;
    let key = "SF_overturning_gross";
    let about = "Safety against overturning by gross moments";
    if gross.buoyancy == 0.0 && actions.uplift == 0.0 && actions.uplift_moment == 0.0 {
        let words = "the same: nothing presses under the base";
        return steps.told(about, key, gross.overturning(), FACTOR, words, key);
    }
    steps.note(
        "The net factor takes the moments of buoyancy and uplift off that of the weight. By gross moments the weight resists in \
         full, and all water under the base turns the body. Both factors are 1 where the resultant passes the corner.",
    );
    let (arm, sign) = if actions.heel == Corner::O { ("b_1", "+") } else { ("b_2", "−") };
    let of = |which: usize, part: fn(&Wrench) -> f64| {
        let buoyancy =
            components.iter().enumerate().filter(|(_, part)| part.load.source == LoadSource::Buoyancy);
        sum(buoyancy.map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench))))
    };
    if let Some(formula) = of(1, |wrench| wrench.p) {
        let force = format!("−{}", grouped(&formula));
        steps.add("Buoyancy, which W′ is less by", "", ["U_s", &force], gross.buoyancy, KILONEWTON, "");
        let moments = of(2, |wrench| wrench.m).map_or(String::new(), |m| format!(" {sign} {}", grouped(&m)));
        let formula = format!("U_s {arm}{moments}");
        steps.add("Its moment about the heel", "", ["M_s", &formula], gross.buoyancy_moment, MOMENT, "");
    }
    if gross.overturning() == 0.0 {
        let words = "uplift or eccentric weight turn the body without any horizontal force";
        return steps.told(about, key, 0.0, FACTOR, words, key);
    }
    if !gross.overturning().is_finite() {
        return steps.told(about, key, gross.overturning(), FACTOR, "nothing turns the body", key);
    }
    let corner = if gross.is_about_heel() { "heel" } else { "toe" };
    let about = format!("{about}, about the {corner}");
    let more = if gross.is_about_heel() { held.heel } else { held.toe };
    let formula = checks::gross_formula(gross, actions.uplift, more);
    steps.add(&about, "", [key, &formula], gross.overturning(), FACTOR, key);
}

/// A factor against overturning about a corner; `pushed` says whether a force turns the body about it.
fn overturning(
    steps: &mut SheetSteps,
    about: &str,
    formula: [&str; 2],
    factor: f64,
    pushed: bool,
    key: &str,
) {
    let words = match factor {
        // As well where a force pushes on, and the formula gives less than nothing.
        0.0 => "uplift or eccentric weight turn the body without any horizontal force",
        _ if pushed => return steps.add(about, "", formula, factor, FACTOR, key),
        _ => "no force turns the body that way",
    };
    steps.told(about, formula[0], factor, FACTOR, words, key);
}

fn pressure(steps: &mut SheetSteps, assessed: &Assessed, held: &HeldTerms) {
    let stability = &assessed.outcome.stability;
    let Stability { resultant_arm, bearing, .. } = *stability;
    let base = assessed.situation.body().base_width();
    if let Some(arm) = resultant_arm {
        let formula = format!("(W' t − M_U − M_p{})/(W' − U{})", held.resultant, held.pressing);
        let formula = ["t_e", formula.as_str()];
        steps.add("Resultant of all loads, from the heel", "", formula, arm, METRE, "resultant_arm");
    }
    let Bearing::Pressed { heel, toe, contact, share } = bearing else {
        let words = checks::no_bearing(bearing).unwrap_or_default();
        return steps.note(&format!("Bearing pressure: none; {words}."));
    };
    if let Some(eccentricity) = stability.eccentricity(base) {
        let formula = ["ε", "|B_c/2 − t_e|"];
        steps.add(
            "Its distance from the middle of the base",
            "",
            formula,
            eccentricity,
            METRE,
            "eccentricity",
        );
    }
    let whole = contact == base;
    let plan = assessed.situation.body().plan();
    let BearingFormulas { about, heel: of_heel, toe: of_toe, contact: of_contact, share: of_share } =
        match plan {
            Plan::Circle => circle(steps, (heel, toe), whole, resultant_arm.unwrap_or_default(), base),
            _ => {
                let long = if assessed.extent == Extent::Whole { " L_b" } else { "" };
                rectangle((heel, toe), whole, &format!("(W' − U{})", held.pressing), long)
            }
        };
    let about = format!("Bearing pressure at the heel, {about}");
    steps.add(&about, "", ["p_heel", &of_heel], heel, KILOPASCAL, "heel_pressure");
    steps.add("At the toe", "", ["p_toe", &of_toe], toe, KILOPASCAL, "toe_pressure");
    let largest = bearing.largest().unwrap_or(0.0);
    let equal = (heel - toe).abs() <= 1e-9 * largest;
    let larger = if heel > toe { "The larger, at the heel" } else { "The larger, at the toe" };
    let larger = if equal { "The larger; they are equal" } else { larger };
    steps.add(larger, "", ["p_max", "max(p_heel, p_toe)"], largest, KILOPASCAL, "bearing_max");
    steps.add("Length of the contact", "", ["l_c", &of_contact], contact, METRE, "contact_length");
    steps.add("Share of the base that is pressed", "", ["ψ", of_share], share, NONE, "contact_share");
}

/// Formulas of the pressure on the base and its contact from the resultant.
struct BearingFormulas {
    /// Words for the case that holds.
    about: &'static str,
    heel: String,
    toe: String,
    contact: String,
    share: &'static str,
}

/// On a rectangle, under what presses, `long` behind its width where it has a length.
fn rectangle((heel, toe): (f64, f64), whole: bool, pressing: &str, long: &str) -> BearingFormulas {
    let near = |arm: &str| (format!("2 {pressing}/(3 {arm}{long})"), format!("3 {arm}"));
    let share = "l_c/B_c";
    if toe == 0.0 && !whole {
        let (heel, contact) = near("t_e");
        let about = "for `t_e` < `B_c÷3`: pressed near the heel only";
        return BearingFormulas { about, heel, toe: "0".to_owned(), contact, share };
    }
    if heel == 0.0 && !whole {
        let (toe, contact) = near("(B_c − t_e)");
        let about = "for `t_e` > `2 B_c÷3`: pressed near the toe only";
        return BearingFormulas { about, heel: "0".to_owned(), toe, contact, share };
    }
    let mean = if long.is_empty() { format!("{pressing}/B_c") } else { format!("{pressing}/(B_c{long})") };
    BearingFormulas {
        about: "for `t_e` from `B_c÷3` to `2 B_c÷3`: the whole base is pressed",
        heel: format!("{mean} (4 − 6 t_e/B_c)"),
        toe: format!("{mean} (6 t_e/B_c − 2)"),
        contact: "B_c".to_owned(),
        share,
    }
}

/// On a circle; where part of it is pressed, the angle at which the contact ends is known to later steps.
fn circle(
    steps: &mut SheetSteps,
    (heel, toe): (f64, f64),
    whole: bool,
    arm: f64,
    base: f64,
) -> BearingFormulas {
    if whole {
        return BearingFormulas {
            about: "for `ε` up to `B_c÷8`: the whole circle is pressed",
            heel: "(W' − U)/(π B_c^2/4) (5 − 8 t_e/B_c)".to_owned(),
            toe: "(W' − U)/(π B_c^2/4) (8 t_e/B_c − 3)".to_owned(),
            contact: "B_c".to_owned(),
            share: "1",
        };
    }
    let angle = standfast::plan::contact_angle((arm - base / 2.0).abs() / (base / 2.0));
    let words = "in radians, from the equilibrium of moments of a pressure linear from there to the edge";
    steps.told("Angle at which the contact of the circle ends, from the edge", "α_c", angle, NONE, words, "");
    let sin = "sqrt(1 − cos(α_c)^2)";
    let most = format!("4 (W' − U) (1 − cos(α_c))/(B_c^2 (2/3 {sin}^3 − cos(α_c) (α_c − {sin} cos(α_c))))");
    let [of_heel, of_toe] = if heel > toe { [most, "0".to_owned()] } else { ["0".to_owned(), most] };
    BearingFormulas {
        about: "for `ε` > `B_c÷8`: part of the circle is pressed",
        heel: of_heel,
        toe: of_toe,
        contact: "B_c/2 (1 − cos(α_c))".to_owned(),
        share: "(α_c − sqrt(1 − cos(α_c)^2) cos(α_c))/π",
    }
}
