//! A base seen from above: each load's forces and moments at the base, both safety factors, and where the body leaves rest.

use maud::{Markup, html};
use standfast::footprint::{BaseWrench, PlanLimit};
use standfast::loads::{Action, LoadSource};
use standfast::{Departure, PlanOutcome};
use standfast_cases::assess::{Component, plan, share};
use standfast_cases::case::CasePlan;
use standfast_cases::{Assessed, Case};

use super::loads::{force_symbols, shows_factor, sum};
use crate::measured::{ACCELERATION, DEGREE, FACTOR, KILONEWTON, METRE, MOMENT, NONE};
use crate::steps::SheetSteps;
use crate::together::Brief;

/// A load at the base.
struct OnBase<'a> {
    component: &'a Component,
    /// What its horizontal, and what its vertical forces are there.
    parts: [BaseWrench; 2],
}

impl OnBase<'_> {
    fn whole(&self) -> BaseWrench {
        self.parts[0].plus(self.parts[1])
    }
}

pub(super) fn steps(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    answer: &PlanOutcome,
    components: &[Component],
) {
    let Some(of_case) = &case.plan else { return };
    let loads: Vec<OnBase<'_>> = components
        .iter()
        .filter_map(|component| {
            Some(OnBase { component, parts: assessed.situation.base_wrench_of(&component.load)? })
        })
        .collect();
    steps.heading("Loads, at the base under the centre of mass");
    steps.note(
        "`X` to the right, `Z` away from the viewer of the section, `V` downwards; `Q_x` and `Q_z` are their moments that tip the body to the right \
         and away, about the point of the base under C.",
    );
    for (i, load) in loads.iter().enumerate() {
        one(steps, case, assessed, i, load);
    }
    table(steps, &loads, &answer.full);
    sums(steps, &loads, &answer.full);
    base(steps, of_case, answer);
    factors(steps, of_case, assessed, answer, &loads);
    leaves(steps, of_case, assessed, answer, &loads);
}

/// The symbols of a load's parts: X, Z, V, Q_x and Q_z with its number.
fn parts(index: usize) -> [String; 5] {
    ["X_", "Z_", "V_", "Q_x", "Q_z"].map(|letter| format!("{letter}{}", index + 1))
}

fn values(wrench: &BaseWrench) -> [f64; 5] {
    [wrench.x, wrench.z, wrench.p, wrench.q_x, wrench.q_z]
}

fn one(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, i: usize, load: &OnBase<'_>) {
    let Component { name, load: of, .. } = load.component;
    let mut about = format!("{}  {}", i + 1, name.replace('`', "'"));
    let names = parts(i);
    let name_of_factor = format!("γ_F{}", i + 1);
    let factor = if shows_factor(case, of.factor) { format!("{name_of_factor} ") } else { String::new() };
    steps.know(&name_of_factor, of.factor, NONE);
    // Its height above the base, where its horizontal forces act.
    let mut height = "y_C".to_owned();
    let mut formulas: [Option<String>; 3] = [None, None, None];
    match (of.source, &of.action) {
        (LoadSource::Weight, Action::Weight) => formulas[2] = Some(format!("{factor}G")),
        (LoadSource::HorizontalInertia | LoadSource::VerticalInertia, _) => {
            if let Some(earthquake) = &assessed.earthquake {
                let all = [
                    ("a_xg", "to the right", earthquake.horizontal()),
                    ("a_zg", "away", earthquake.away()),
                    ("a_yg", "upwards", earthquake.vertical()),
                ];
                let is_first = !steps.known().contains_key("a_xg");
                for (name, words, value) in all.into_iter().filter(|_| is_first) {
                    let words = format!("{words}, of those that are tried that which is reported");
                    steps.told("Acceleration of the base", name, value, ACCELERATION, &words, "");
                }
            }
            formulas = match of.source {
                LoadSource::VerticalInertia => [None, None, Some(format!("{factor}m a_yg"))],
                _ => [Some(format!("−{factor}m a_xg")), Some(format!("−{factor}m a_zg")), None],
            };
        }
        (LoadSource::Force, Action::Force { at, right, up }) => {
            let away = of.across.as_ref().map_or(0.0, |across| across.away);
            let [force, elevation, _] = force_symbols(case, of);
            steps.know_input(&force, right.hypot(*up).hypot(away), KILONEWTON);
            steps.know_input(&elevation, at.y, METRE);
            height = elevation;
            formulas = match (away, *up) {
                (0.0, 0.0) if *right < 0.0 => [Some(format!("−{factor}{force}")), None, None],
                (0.0, 0.0) => [Some(format!("{factor}{force}")), None, None],
                (_, 0.0) => {
                    let angle = format!("φ_F{}", i + 1);
                    let degrees = standfast::footprint::degrees([*right, away]);
                    let words = "from left over away to right, as the case file gives it";
                    steps.told("Direction of the force", &angle, degrees, DEGREE, words, "");
                    [
                        Some(format!("−{factor}{force} cos({angle})")),
                        Some(format!("{factor}{force} sin({angle})")),
                        None,
                    ]
                }
                (_, up) if up > 0.0 => [None, None, Some(format!("−{factor}{force}"))],
                _ => [None, None, Some(format!("{factor}{force}"))],
            };
        }
        _ => {}
    }
    let whole = values(&load.whole());
    let [push, vertical] = load.parts;
    let moments = [(&names[0], push.q_x, vertical.q_x), (&names[1], push.q_z, vertical.q_z)];
    let moments = moments.map(|(force, of_push, of_vertical)| {
        (of_vertical == 0.0 && of_push != 0.0).then(|| format!("{force} {height}"))
    });
    let formulas = formulas.into_iter().chain(moments);
    for (((name, value), formula), place) in names.iter().zip(whole).zip(formulas).zip(0..) {
        let unit = if place < 3 { KILONEWTON } else { MOMENT };
        match formula {
            _ if value == 0.0 => steps.know(name, value, unit),
            Some(formula) => {
                steps.add(&about, "", [name, &formula], value, unit, "");
                about.clear();
            }
            None => {
                let words =
                    if place < 3 { "of the case file's numbers" } else { "its force times its place" };
                steps.told(&about, name, value, unit, words, "");
                about.clear();
            }
        }
    }
}

/// The loads one by one, in a table.
fn table(steps: &mut SheetSteps, loads: &[OnBase<'_>], full: &BaseWrench) {
    let [force, moment] = [KILONEWTON, MOMENT].map(|unit| steps.measured(0.0, unit).unit.text);
    let cells = |steps: &SheetSteps, wrench: &BaseWrench| {
        let units = [KILONEWTON, KILONEWTON, KILONEWTON, MOMENT, MOMENT];
        let cells = values(wrench).into_iter().zip(units);
        html! { @for (value, unit) in cells { td.n { (steps.measured(value, unit).number_html("")) } } }
    };
    let full = html! {
        table.numbers data-table="plan-loads" {
            thead { tr {
                th { "Load" } th { "Share" }
                @for (name, unit) in [("X", force), ("Z", force), ("V", force), ("Q", moment), ("Q", moment)].into_iter().zip(0..).map(|((name, unit), place)| {
                    let below = match place { 3 => "x", 4 => "z", _ => "" };
                    (html! { (name) @if !below.is_empty() { sub { (below) } } }, unit)
                }) {
                    th.n { (name) br; (unit) }
                }
            } }
            tbody {
                @for (i, load) in loads.iter().enumerate() {
                    tr { td { (i + 1) " " (load.component.name) } td { (share(&load.component.load)) } (cells(steps, &load.whole())) }
                }
                tr.sum { td { "Sum" } td {} (cells(steps, full)) }
            }
        }
    };
    steps.push(full, Brief::Nothing);
}

fn sums(steps: &mut SheetSteps, loads: &[OnBase<'_>], full: &BaseWrench) {
    let names = ["X", "Z", "V", "Q_x", "Q_z"];
    let words = ["to the right", "away", "downwards", "moment to the right", "moment away"];
    for (place, value) in values(full).into_iter().enumerate() {
        let about = format!("Sum under the full load, {}", words[place]);
        let unit = if place < 3 { KILONEWTON } else { MOMENT };
        let of_loads = loads.iter().enumerate();
        let formula = sum(of_loads.map(|(i, load)| (parts(i)[place].clone(), values(&load.whole())[place])));
        match formula {
            Some(formula) => steps.add(&about, "", [names[place], &formula], value, unit, ""),
            None => steps.told(&about, names[place], value, unit, "no load has such a part", ""),
        }
    }
}

/// Where the body bears.
fn base(steps: &mut SheetSteps, of_case: &CasePlan, answer: &PlanOutcome) {
    let footprint = &of_case.base.footprint;
    steps.heading("Base, seen from above");
    steps.note("Directions are those of a force on the body: 0° to the left, 90° away from the viewer, 180° to the right.");
    let rows: Vec<(String, f64, f64)> = footprint
        .distances()
        .into_iter()
        .zip(footprint.normals())
        .enumerate()
        .map(|(edge, (distance, normal))| {
            let words = plan::edge_words(of_case, edge);
            (words, standfast::footprint::degrees(normal), distance)
        })
        .collect();
    let length = steps.measured(0.0, METRE).unit.text;
    let full: Markup = html! {
        table.numbers data-table="edges" {
            thead { tr { th { "Edge" } th.n { "outwards" br; "°" } th.n { "from below C" br; (length) } } }
            tbody {
                @for (i, (words, outwards, distance)) in rows.iter().enumerate() {
                    tr {
                        td { (i + 1) " " (words) @if answer.edge == Some(i) { ", which governs" } }
                        td.n { (standfast_cases::layout::significant(*outwards, 5)) }
                        td.n { (steps.measured(*distance, METRE).number_html("")) }
                    }
                }
            }
        }
    };
    steps.push(full, Brief::Nothing);
}

fn factors(
    steps: &mut SheetSteps,
    of_case: &CasePlan,
    assessed: &Assessed,
    answer: &PlanOutcome,
    loads: &[OnBase<'_>],
) {
    steps.heading("Classical checks");
    let PlanOutcome { full, edge, .. } = answer;
    let footprint = &of_case.base.footprint;
    let size = full.horizontal();
    steps.add("Horizontal force", "", ["P", "sqrt(X^2 + Z^2)"], size, KILONEWTON, "P");
    let Some([c_x, c_z]) = full.centre_of_pressure() else {
        return steps.note("Nothing presses the body on its base: safety factors mean nothing.");
    };
    let about = "Centre of pressure, from below C: to the right, and away";
    steps.add(about, "", ["c_x", "Q_x/V"], c_x, METRE, "");
    steps.add("", "", ["c_z", "Q_z/V"], c_z, METRE, "");
    let stability = &assessed.outcome.stability;
    let on_friction = footprint.on_friction(full);
    let about = "Safety against sliding";
    match (size > 0.0, on_friction > size) {
        (false, false) => {
            steps.told(about, "SF_sliding", stability.sliding, FACTOR, "no horizontal force", "SF_sliding")
        }
        (_, false) => steps.add(about, "", ["SF_sliding", "μ V/P"], stability.sliding, FACTOR, "SF_sliding"),
        (_, true) => {
            let ([x, z], radius) = footprint.disc().unwrap_or_default();
            let words = "of all loads about the vertical through the centre of pressure";
            steps.told("Moment that turns the body", "T_c", full.torsion(), MOMENT, words, "");
            steps.told("Radius of the disc", "R_b", radius, METRE, "of the case file's numbers", "");
            let words = "distance of the centre of pressure from its centre";
            steps.told("", "r_c", (c_x - x).hypot(c_z - z), METRE, words, "");
            let formula = "sqrt(P^2 + T_c^2/(R_b^2 − r_c^2))";
            steps.add("Force that friction has to hold", "", ["P_T", formula], on_friction, KILONEWTON, "");
            steps.add(about, "", ["SF_sliding", "μ V/P_T"], stability.sliding, FACTOR, "SF_sliding");
        }
    }
    let about = "Safety against overturning";
    let (name, factor) = ("SF_overturning_net", stability.overturning());
    let Some(edge) = *edge else {
        steps.told(about, name, factor, FACTOR, "no horizontal force turns the body", name);
        return margins(steps, assessed, full);
    };
    let about = format!("{about}, about {}", plan::edge_words(of_case, edge));
    if footprint.disc().is_some() {
        let words = "so many times the horizontal forces bring the centre of pressure to the rim";
        steps.told(&about, name, factor, FACTOR, words, name);
        return margins(steps, assessed, full);
    }
    of_edge(steps, of_case, edge, ["n_x", "n_z", "h_e"]);
    let [n_x, n_z] = footprint.normals()[edge];
    let push = loads.iter().fold(BaseWrench::zero(), |sum, load| sum.plus(load.parts[0]));
    let is_all = push.q_x == full.q_x && push.q_z == full.q_z;
    let (moment, held) = match is_all {
        true => ("Q_x n_x + Q_z n_z", "h_e V/N_e"),
        false => {
            let words = "of the horizontal forces alone";
            steps.told("Moments of the horizontal forces", "Q_px", push.q_x, MOMENT, words, "");
            steps.told("", "Q_pz", push.q_z, MOMENT, words, "");
            ("Q_px n_x + Q_pz n_z", "(h_e V − (Q_x − Q_px) n_x − (Q_z − Q_pz) n_z)/N_e")
        }
    };
    let tips = push.q_x * n_x + push.q_z * n_z;
    let about_edge = "Moment of the horizontal forces about that edge";
    steps.add(about_edge, "", ["N_e", moment], tips, MOMENT, "");
    steps.add(&about, "", [name, held], factor, FACTOR, name);
    margins(steps, assessed, full);
}

/// The direction out of an edge, and its distance from below C, under these names.
fn of_edge(steps: &mut SheetSteps, of_case: &CasePlan, edge: usize, [x, z, h]: [&str; 3]) {
    let footprint = &of_case.base.footprint;
    let ([n_x, n_z], distance) = (footprint.normals()[edge], footprint.distances()[edge]);
    let about = format!("Direction out of {}: to the right, and away", plan::edge_words(of_case, edge));
    let words = "square to it, of length one";
    steps.told(&about, x, n_x, NONE, words, "");
    steps.told("", z, n_z, NONE, words, "");
    steps.told("Its distance from below C", h, distance, METRE, "of the case file's numbers", "");
}

/// What friction and the edges leave.
fn margins(steps: &mut SheetSteps, assessed: &Assessed, full: &BaseWrench) {
    let margins = &assessed.outcome.margins;
    let on_friction = match steps.known().contains_key("P_T") {
        true => "P_T",
        false => "P",
    };
    let formula = format!("μ V − {on_friction}");
    steps.add("What friction leaves", "", ["R_s", &formula], margins.sliding, KILONEWTON, "margin_sliding");
    let words = "the least over the edges of `h V` less the moment about the edge";
    let about = "What the edges leave";
    steps.told(about, "R_o", margins.overturning(), MOMENT, &words.replace('`', ""), "margin_overturning");
    let weight = assessed.outcome.actions.buoyant_weight;
    let words = if weight == full.p { "all that presses" } else { "of all that counts as weight" };
    steps.told("Weight less buoyancy", "W'", weight, KILONEWTON, words, "buoyant_weight");
}

fn leaves(
    steps: &mut SheetSteps,
    of_case: &CasePlan,
    assessed: &Assessed,
    answer: &PlanOutcome,
    loads: &[OnBase<'_>],
) {
    steps.heading("Load path: the variable loads rise by a factor, the permanent ones stay");
    if let Departure::At { factor, .. } = assessed.departure() {
        let friction = assessed.situation.static_friction();
        departure(steps, of_case, answer, loads, [factor, friction]);
    }
    for sentence in plan::sentences(of_case, assessed, answer) {
        steps.push(html! { p.note { (sentence) } }, Brief::Nothing);
    }
}

/// The load factor at which the body leaves rest, by the limit that it reaches there.
fn departure(
    steps: &mut SheetSteps,
    of_case: &CasePlan,
    answer: &PlanOutcome,
    loads: &[OnBase<'_>],
    [factor, friction]: [f64; 2],
) {
    const KEY: &str = "load_factor";
    let name = "λ_d";
    let about = format!("Load factor at which it {}", plan::leaves(of_case, &answer.departure));
    let [permanent, variable] = [true, false].map(|permanent| {
        let of = loads.iter().filter(|load| load.component.load.permanent == permanent);
        of.fold(BaseWrench::zero(), |sum, load| sum.plus(load.whole()))
    });
    let mut share = |is_permanent: bool, place: usize, symbol: &str, value: f64| {
        let of = loads.iter().enumerate().filter(|(_, load)| load.component.load.permanent == is_permanent);
        let formula = sum(of.map(|(i, load)| (parts(i)[place].clone(), values(&load.whole())[place])));
        let of = if is_permanent { "permanent" } else { "variable" };
        let unit = if place < 3 { KILONEWTON } else { MOMENT };
        match formula {
            Some(formula) => {
                steps.add(&format!("Part of the {of} loads"), "", [symbol, &formula], value, unit, "")
            }
            None => steps.know(symbol, value, unit),
        }
    };
    share(true, 2, "V_P", permanent.p);
    share(false, 2, "V_V", variable.p);
    let limit = answer.departure.limits.first();
    let disc = of_case.base.footprint.disc();
    let [across, along] = match (limit, disc) {
        (Some(PlanLimit::Tips { .. }), None) => [3, 4],
        (Some(PlanLimit::Tips { .. }), Some((centre, _))) if centre == [0.0; 2] => [3, 4],
        (Some(PlanLimit::Slides), _) => [0, 1],
        _ => {
            let words = "the least at which a condition of rest is crossed";
            return steps.told(&about, name, factor, FACTOR, words, KEY);
        }
    };
    let [p, v] = [values(&permanent), values(&variable)];
    share(true, across, "U_xP", p[across]);
    share(true, along, "U_zP", p[along]);
    share(false, across, "U_xV", v[across]);
    share(false, along, "U_zV", v[along]);
    if let (Some(PlanLimit::Tips { edge }), None) = (limit, disc) {
        of_edge(steps, of_case, *edge, ["n_xt", "n_zt", "h_t"]);
        let formula = "(h_t V_P − U_xP n_xt − U_zP n_zt)/(U_xV n_xt + U_zV n_zt − h_t V_V)";
        return steps.add(&about, "", [name, formula], factor, FACTOR, KEY);
    }
    // |U_P + λ U_V| = L (V_P + λ V_V), a quadratic in λ.
    let (symbol, most) = match disc {
        Some((_, radius)) if across == 3 => {
            steps.told("Radius of the disc", "R_b", radius, METRE, "of the case file's numbers", "");
            ("R_b", radius)
        }
        _ => ("μ", friction),
    };
    let [whole, grown] = [most * permanent.p, most * variable.p];
    let square = |x: f64, z: f64| x * x + z * z;
    let [u, w] = [[p[across], p[along]], [v[across], v[along]]];
    let a = (square(w[0], w[1]) - grown * grown) / (whole * whole);
    let b = (u[0] * w[0] + u[1] * w[1] - whole * grown) / (whole * whole);
    let c = square(u[0], u[1]) / (whole * whole) - 1.0;
    let of = format!("({symbol} V_P)^2");
    let words = "Quadratic in λ of the condition of rest: of its square, of twice it, alone";
    let formulas = [
        format!("(U_xV^2 + U_zV^2 − ({symbol} V_V)^2)/{of}"),
        format!("(U_xP U_xV + U_zP U_zV − {symbol} V_P {symbol} V_V)/{of}"),
        format!("(U_xP^2 + U_zP^2)/{of} − 1"),
    ];
    steps.add(words, "", ["A_λ", &formulas[0]], a, NONE, "");
    steps.add("", "", ["B_λ", &formulas[1]], b, NONE, "");
    steps.add("", "", ["C_λ", &formulas[2]], c, NONE, "");
    let formula = if a == 0.0 { "−C_λ/(2 B_λ)" } else { "(sqrt(B_λ^2 − A_λ C_λ) − B_λ)/A_λ" };
    steps.add(&about, "", [name, formula], factor, FACTOR, KEY);
}
