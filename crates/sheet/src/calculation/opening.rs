//! Water under a base that opens: the length that stays pressed, and what the water then lifts.

use standfast::contact::opening::{Drain, OpeningState};
use standfast::{BaseOpening, Body, OpeningRule, Wrench};
use standfast_cases::Assessed;
use standfast_cases::assess::Component;
use standfast_cases::assess::opening::{HELD, told};
use standfast_cases::units::Extent;

use super::loads::{grouped, parts, signed, sum};
use crate::measured::{
    FACTOR, FORCE_SQUARED, FORCE_SQUARED_OF_OBJECT, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE,
};
use crate::steps::SheetSteps;

/// True if a load is still water under a base of which it is told how it opens.
pub(super) fn is_followed(assessed: &Assessed, component: &Component) -> bool {
    component.load.is_water_under_base() && told(assessed).is_some()
}

/// Heads at the ends of a base, seen from the end of the lower one.
struct Heads<'a> {
    body: &'a Body,
    right_is_high: bool,
    /// Pa.
    low: f64,
    high: f64,
    /// Width of the base, m.
    base: f64,
    /// Length of the base out of the plane, m.
    length: f64,
}

impl Heads<'_> {
    fn of<'a>(assessed: &'a Assessed, opening: &BaseOpening) -> Heads<'a> {
        let body = assessed.situation.body();
        let right_is_high = opening.heads[1] >= opening.heads[0];
        let [low, high] = if right_is_high { opening.heads } else { [opening.heads[1], opening.heads[0]] };
        let length = body.plan().side(body.width());
        Heads { body, right_is_high, low, high, base: body.base_width(), length }
    }

    /// The length out of the plane behind a formula, where it is not one metre.
    fn long(&self) -> &'static str {
        if self.length == 1.0 { "" } else { " L_b" }
    }

    /// What the moment of loads is about.
    fn about(&self) -> String {
        let end = if self.right_is_high { "O" } else { "O′" };
        format!("Their moment about {end}, which holds the body down")
    }

    /// The moment of loads that holds the body down.
    fn holding(&self, Wrench { x, p, m }: &Wrench) -> f64 {
        let about_base = m - x * self.body.centroid_height();
        match self.right_is_high {
            true => p * self.body.heel_distance() - about_base,
            false => p * self.body.toe_distance() + about_base,
        }
    }

    /// The same as a formula, with the symbol of what acts down.
    fn moment(&self, sums: &Sums, down: Option<&str>) -> String {
        let arm = if self.right_is_high { "b_1" } else { "b_2" };
        let down = down.map(|down| (true, format!("{down} {arm}")));
        let turn = sums.turn.as_deref().map(|turn| (!self.right_is_high, grouped(turn)));
        let push = sums.push.as_deref().map(|push| (self.right_is_high, format!("{} y_C", grouped(push))));
        signed([down, turn, push].into_iter().flatten())
    }

    /// How far a drain lies from the end of the lower head.
    fn to_drain(&self, drain: &Drain) -> f64 {
        if self.right_is_high { drain.distance } else { self.base - drain.distance }
    }
}

/// The sum of loads, and its parts as formulas, each where it has any.
struct Sums {
    wrench: Wrench,
    down: Option<String>,
    turn: Option<String>,
    push: Option<String>,
}

impl Sums {
    fn of(components: &[Component], counts: impl Fn(&Component) -> bool) -> Sums {
        let counted: Vec<_> =
            components.iter().enumerate().filter(|(_, component)| counts(component)).collect();
        let of = |which: usize, part: fn(&Wrench) -> f64| {
            sum(counted.iter().map(|(i, component)| (parts(*i)[which].clone(), part(&component.wrench))))
        };
        let wrench = counted.iter().fold(Wrench::ZERO, |sum, (_, component)| sum + component.wrench);
        let [push, down, turn] =
            [of(0, |wrench| wrench.x), of(1, |wrench| wrench.p), of(2, |wrench| wrench.m)];
        Sums { wrench, down, turn, push }
    }

    /// What acts down, as a formula.
    fn down(&self) -> &str {
        self.down.as_deref().unwrap_or("0")
    }
}

pub(super) fn steps(steps: &mut SheetSteps, assessed: &Assessed, components: &[Component]) {
    let Some(opening) = told(assessed) else { return };
    steps.heading("Water under a base that opens");
    steps.note(
        "Where the base opens, the higher head stands; from its end the pressure falls in a straight line to the lower one. No pull and a \
         straight pressure of the base over the contact give its length, `3 T_o/N_o`, with both as if the higher head stood under the whole base.",
    );
    let heads = Heads::of(assessed, &opening);
    let Heads { low, high, base, length, .. } = heads;
    let long = heads.long();
    let words = "ρ g times the level, with the factor of the combination";
    steps.told("Pressure under the end of the higher head", "p_H", high, KILOPASCAL, words, "");
    steps.told("Pressure under the end of the lower head", "p_N", low, KILOPASCAL, words, "");
    let counts = |component: &Component| {
        let fast = component.load.is_fast && !component.load.permanent && opening.rule == OpeningRule::Steady;
        !is_followed(assessed, component) && !fast
    };
    let sums = Sums::of(components, counts);
    if opening.is_held {
        steps.note(HELD);
    }
    steps.add(
        "Vertical force of all other loads that count",
        "",
        ["W_d", sums.down()],
        sums.wrench.p,
        KILONEWTON,
        "",
    );
    let holding = heads.holding(&sums.wrench);
    steps.add(&heads.about(), "", ["M_d", &heads.moment(&sums, Some("W_d"))], holding, MOMENT, "");
    let (n, t) = (sums.wrench.p - high * base * length, holding - high * base * base / 2.0 * length);
    steps.add(
        "With the higher head under all of the base",
        "",
        ["N_o", &format!("W_d − p_H B_c{long}")],
        n,
        KILONEWTON,
        "",
    );
    steps.add("and about that end", "", ["T_o", &format!("M_d − p_H B_c^2/2{long}")], t, MOMENT, "");
    let delta = high - low;
    let contact = opening.contact(base);
    let (mut force, mut squared) = (String::new(), String::new());
    if let Some(drain) = opening.drain {
        let distance = heads.to_drain(&drain);
        steps.told("Drains, from the end of the lower head", "x_d", distance, METRE, "drain", "");
        steps.told("Their efficiency", "E_d", drain.efficiency, NONE, "drain", "");
        let drained = drain.efficiency * delta * distance / 2.0 * length;
        steps.add(
            "What they take off the water",
            "",
            ["D_o", &format!("E_d (p_H − p_N) x_d/2{long}")],
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
    let formula = format!("p_H B_c{long} − (p_H − p_N)/2 c_o{long}{force}");
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
    let heads = Heads::of(assessed, &opening);
    let Heads { low, high, base, length: long, .. } = heads;
    let length = heads.long();
    let delta = (high - low) * long;
    let [still, risen] = [true, false].map(|permanent| {
        Sums::of(components, |component| {
            component.load.permanent == permanent && !component.load.is_water_under_base()
        })
    });
    let (n_g, t_g) =
        (still.wrench.p - high * long * base, heads.holding(&still.wrench) - high * long * base * base / 2.0);
    let (n_q, t_q) = (risen.wrench.p, heads.holding(&risen.wrench));
    let (x_g, x_q) = (still.wrench.x, risen.wrench.x);
    steps.told("Pressure under the end of the higher head", "p_H", high, KILOPASCAL, "as above", "");
    steps.told("Pressure under the end of the lower head", "p_N", low, KILOPASCAL, "as above", "");
    let mut added = |sums: &Sums, what: &str, names: [&str; 3], values: [f64; 3], water: [String; 2]| {
        let about = format!("The {what} loads together, the higher head under all of the base");
        let formula = format!("{}{}", sums.down(), water[0]);
        steps.add(&about, "", [names[0], &formula], values[0], KILONEWTON, "");
        let down = sums.down.as_deref().map(grouped);
        let formula = heads.moment(sums, down.as_deref()) + &water[1];
        steps.add(&heads.about(), "", [names[1], &formula], values[1], MOMENT, "");
        let push = sums.push.as_deref().unwrap_or("0");
        steps.add("Their horizontal force", "", [names[2], push], values[2], KILONEWTON, "");
    };
    let water = [format!(" − p_H B_c{length}"), format!(" − p_H B_c^2/2{length}")];
    added(&still, "permanent", ["N_G", "T_G", "X_G"], [n_g, t_g, x_g], water);
    added(&risen, "variable", ["N_Q", "T_Q", "X_Q"], [n_q, t_q, x_q], Default::default());
    let near = |found: f64| (found - factor).abs() <= 1e-9 * factor;
    if near(-t_g / t_q) {
        let about = format!("{about}: nothing is pressed any more, `T_G + λ_d T_Q` is zero");
        steps.add(&about, "", [name, "−T_G/T_Q"], factor, FACTOR, key);
        return true;
    }
    let μ = situation.static_friction();
    let (force, squared) = match opening.drain.filter(|_| drained) {
        Some(drain) => {
            let distance = heads.to_drain(&drain);
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
