//! The joints above the base: of each all that is above it as one body, its loads, their sums and its four conditions of rest; the governing
//! one in full; all of them together.

use maud::{Markup, html};
use standfast::loads::{Action, Load, LoadSource};
use standfast::{Body, Departure, Wrench};
use standfast_cases::assess::joint_words::slashed;
use standfast_cases::assess::{Component, JointPlace, Joints, joints, share, verdict};
use standfast_cases::case::{CaseJoint, JointWater};
use standfast_cases::layout::percent;
use standfast_cases::units::Dimension;
use standfast_cases::{Assessed, AssessmentView, Case};

use super::loads::{parts, sum};
use super::{classical, path};
use crate::measured::{DENSITY, FACTOR, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE};
use crate::steps::SheetSteps;
use crate::together::Brief;

pub(super) fn steps(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    all: &Joints,
    components: &[Component],
    view: &AssessmentView,
) {
    let first = all.leaves.joints();
    let of = case.under(assessed.acting);
    for (place, above) in all.above.iter().enumerate() {
        steps.of_joint(place + 1, |steps| on_joint(steps, of, all, above, place));
    }
    if first.first() == Some(&0) {
        governing(steps, all, assessed, components, 0);
    }
    steps.heading("All joints");
    steps.push(table(assessed, all), Brief::Nothing);
    match assessed.departure() {
        Departure::At { factor, .. } if first.first() == Some(&0) => steps.know("λ_d", factor, FACTOR),
        Departure::At { factor, .. } => {
            let about = "Load factor at which the first joint leaves rest";
            steps.told(about, "λ_d", factor, FACTOR, "the least of all joints", "load_factor");
        }
        _ => {}
    }
    for sentence in verdict::full_load(assessed).into_iter().chain(verdict::path(assessed)) {
        steps.push(html! { p.note { (sentence) } }, Brief::Nothing);
    }
    if let Some(rows) = joints::motion_rows(assessed) {
        steps.push(onset(&rows), Brief::Nothing);
        steps.push(html! { p.note { (joints::motion_key(assessed)) } }, Brief::Nothing);
    }
    let stages = all.path(case, assessed, view.up_to);
    if !stages.is_empty() {
        let rows = stages.iter().map(|stage| {
            let others: Vec<String> = stage.others.iter().map(|modes| slashed(modes)).collect();
            (stage.from, stage.to, slashed(&stage.modes), others.join(", "))
        });
        let full = path::table("modes_path", "Modes from the base up", rows);
        steps.push(full, Brief::Nothing);
    }
}

/// What is above a joint, by its place among those above the base: its loads, its conditions of rest, and of the governing one all.
fn on_joint(steps: &mut SheetSteps, case: &Case, all: &Joints, above: &Assessed, place: usize) {
    let joint = place + 1;
    let title = format!(
        "{}, {} above the base: all that is above it as one body",
        standfast_cases::capital(&all.called(joint)),
        above.output.length(all.places[joint].elevation)
    );
    steps.heading(&title);
    steps.note("Symbols up to the next joint are of what is above this one.");
    let water = Water { case, joint: &case.joints[place], body: above.situation.body() };
    let mut components = above.components();
    for component in &mut components {
        if let Some(name) = water.name(&component.load) {
            component.name = name.to_owned();
        }
    }
    water.steps(steps);
    carried(steps, above, &components);
    conditions(steps, above);
    if all.leaves.joints().first() == Some(&joint) {
        classical::steps(steps, case, above, &components);
        governing(steps, all, above, &components, joint);
    }
}

/// Water in a joint and in the gaps beside it.
struct Water<'a> {
    case: &'a Case,
    joint: &'a CaseJoint,
    body: &'a Body,
}

impl Water<'_> {
    /// What a load of water in the joint is called; `None` of any other.
    fn name(&self, load: &Load) -> Option<&'static str> {
        let names = match load.source {
            LoadSource::Buoyancy => [
                ["water in the joint, from the left", "water in the joint, from the right"],
                ["water in the gap at the left", "water in the gap at the right"],
            ],
            LoadSource::WaveUplift => [
                ["wave in the joint", "wave in the joint"],
                ["wave in the gap at the left", "wave in the gap at the right"],
            ],
            _ => return None,
        };
        let (is_gap, side) = match &load.action {
            Action::Force { at, .. } => (1, usize::from(at.x > 0.0)),
            Action::Pressure { diagram, .. } => {
                let first = diagram.points().first().map_or(0.0, |point| point.pressure);
                (0, usize::from(first == 0.0))
            }
            _ => return None,
        };
        Some(names[is_gap][side])
    }

    /// The pressures of still water in an open joint, and what they lift.
    fn steps(&self, steps: &mut SheetSteps) {
        let Some(water) = &self.case.water else { return };
        if self.joint.water != JointWater::Open {
            return;
        }
        let (level, length) = (self.joint.level(), self.body.plan().side(self.body.width()));
        let unit_weight = water.density() * self.case.gravity;
        steps.know_all([("ρ_w", water.density(), DENSITY), ("y_j", level, METRE)]);
        let sides = [("left", "h_l", "p_jl", water.left()), ("right", "h_r", "p_jr", water.right())];
        for (side, depth, name, surface) in sides {
            if surface <= level {
                continue;
            }
            steps.know(depth, surface, METRE);
            let about = format!("Pressure of still water at the joint, {side}");
            let formula = format!("ρ_w g ({depth} − y_j)");
            steps.add(&about, "", [name, &formula], unit_weight * (surface - level), KILOPASCAL, "");
        }
        let out_of_plane = if length == 1.0 { "" } else { ", times the length out of the plane" };
        steps.note(&format!(
            "In the open joint each goes straight to nothing at the other end, and lifts half of it times the length of the contact{out_of_plane}."
        ));
    }
}

/// The joints from the top with their motion and their reactions.
fn onset(rows: &[Vec<String>]) -> Markup {
    let [names, units, joints @ ..] = rows else { return html! {} };
    html! {
        table.numbers data-table="joints-onset" {
            thead {
                tr {
                    th { "Joint" } th { "Mode" }
                    @for (name, unit) in names.iter().zip(units).skip(2) { th.n { (name) br; (unit) } }
                }
            }
            tbody {
                @for joint in joints {
                    tr {
                        td { (joint[0]) } td { (joint[1]) }
                        @for value in &joint[2..] { td.n { (value.replace('-', "−")) } }
                    }
                }
            }
        }
    }
}

/// The body above a joint, the loads on it in a table, and their sums.
fn carried(steps: &mut SheetSteps, above: &Assessed, components: &[Component]) {
    let body = above.situation.body();
    steps.told(
        "Friction in the joint",
        "μ",
        above.situation.static_friction(),
        NONE,
        "as given in the case file",
        "",
    );
    let (left, right, up) = (body.heel_distance(), body.toe_distance(), body.centroid_height());
    steps.told(
        "Centre of mass of what is above, right of O",
        "b_1",
        left,
        METRE,
        "by cutting the section at the joint",
        "",
    );
    steps.told("Left of O′", "b_2", right, METRE, "by cutting the section at the joint", "");
    steps.told("Above the joint", "y_C", up, METRE, "by cutting the section at the joint", "");
    steps.add(
        "Length of the contact of what is above and below",
        "",
        ["B_c", "b_1 + b_2"],
        body.base_width(),
        METRE,
        "",
    );
    for (i, Component { wrench, .. }) in components.iter().enumerate() {
        let [x, v, m] = parts(i);
        steps.know_all([
            (x.as_str(), wrench.x, KILONEWTON),
            (v.as_str(), wrench.p, KILONEWTON),
            (m.as_str(), wrench.m, MOMENT),
        ]);
    }
    let total = above.outcome.full.wrench;
    let [force, moment] = [KILONEWTON, MOMENT].map(|unit| steps.measured(0.0, unit).unit.text);
    let cells = |steps: &SheetSteps, [x, p, m]: [f64; 3]| {
        html! {
            @for (value, unit) in [(x, KILONEWTON), (p, KILONEWTON), (m, MOMENT)] {
                td.n { (steps.measured(value, unit).number_html("")) }
            }
        }
    };
    let full = html! {
        table.numbers data-table="components" {
            thead { tr { th { "Load above the joint" } th { "Share" } th.n { "X" br; (force) } th.n { "V" br; (force) } th.n { "M" br; (moment) } } }
            tbody {
                @for (i, Component { name, load, wrench }) in components.iter().enumerate() {
                    tr { td { (i + 1) " " (name) } td { (share(load)) } (cells(steps, [wrench.x, wrench.p, wrench.m])) }
                }
                tr.sum { td { "Sum" } td {} (cells(steps, [total.x, total.p, total.m])) }
            }
        }
    };
    steps.push(full, Brief::Nothing);
    let sums = [
        ("X", "to the right", total.x, KILONEWTON, 0),
        ("V", "downwards, less water in the joint", total.p, KILONEWTON, 1),
        ("M", "moment at the centre of mass of what is above", total.m, MOMENT, 2),
    ];
    for (name, words, value, unit, which) in sums {
        let about = format!("Sum above the joint, {words}");
        let part =
            |component: &Component| [component.wrench.x, component.wrench.p, component.wrench.m][which];
        let terms = components.iter().enumerate();
        match sum(terms.map(|(i, component)| (parts(i)[which].clone(), part(component)))) {
            Some(formula) => steps.add(&about, "", [name, &formula], value, unit, ""),
            None => steps.told(&about, name, value, unit, "no load has such a part", ""),
        }
    }
}

/// The four conditions of rest, with their numbers; none is negative at rest.
fn conditions(steps: &mut SheetSteps, above: &Assessed) {
    let (situation, Wrench { x, p: v, m }) = (&above.situation, above.outcome.full.wrench);
    let (body, μ) = (situation.body(), situation.static_friction());
    let (b1, b2, y) = (body.heel_distance(), body.toe_distance(), body.centroid_height());
    let all = [
        (
            "Rest needs 0 or more of each of four: against a slide to the left",
            "Z_left",
            "μ V + X",
            μ * v + x,
            KILONEWTON,
        ),
        ("Against a slide to the right", "Z_right", "μ V − X", μ * v - x, KILONEWTON),
        ("About O, the left end of the joint", "Z_O", "b_1 V + y_C X − M", b1 * v + y * x - m, MOMENT),
        ("About O′, the right end", "Z_O′", "b_2 V − y_C X + M", b2 * v - y * x + m, MOMENT),
    ];
    for (about, name, formula, value, unit) in all {
        steps.add(about, "", [name, formula], value, unit, "");
    }
}

/// Where the governing joint leaves rest.
fn governing(steps: &mut SheetSteps, all: &Joints, on: &Assessed, components: &[Component], joint: usize) {
    steps.heading(&format!("{} governs: where it leaves rest", standfast_cases::capital(&all.called(joint))));
    if let Departure::At { factor, .. } = on.outcome.departure {
        path::departure(steps, on, components, factor);
    }
}

/// The joints from the top, with all that is above each under the full load.
fn table(assessed: &Assessed, all: &Joints) -> Markup {
    let output = assessed.output;
    let first = all.leaves.joints();
    let rows: Vec<(usize, &JointPlace, &Assessed)> = all
        .places
        .iter()
        .zip(assessed.on_joints())
        .enumerate()
        .map(|(joint, (place, on))| (joint, place, on))
        .collect();
    let force = output.symbol(Dimension::Force);
    html! {
        table.numbers data-table="joints" {
            thead {
                tr {
                    th { "Joint" } th.n { "at" br; (output.symbol(Dimension::Length)) }
                    th.n { "X to the right" br; (force) } th.n { "V" br; (force) }
                    th.n { "SF slide" } th.n { "SF about O" } th.n { "SF about O′" }
                    th.n { "Pressed, %" } th.n { "Leaves rest at, %" }
                }
            }
            tbody {
                @for (joint, place, on) in rows.iter().rev() {
                    @let full = &on.outcome.full;
                    @let [about_o, about_o_prime] = joints::about_ends(on);
                    @let factor = |factor: f64| if full.is_lifted() { "none".to_owned() } else { output.factor(factor) };
                    tr {
                        td.name {
                            @if first.contains(joint) { strong { (all.called(*joint)) ", governs" } } @else { (all.called(*joint)) }
                        }
                        td.n { (output.value(Dimension::Length, place.elevation)) }
                        @for value in [full.wrench.x, full.wrench.p] { td.n { (output.value(Dimension::Force, value).replace('-', "−")) } }
                        td.n { (factor(on.outcome.stability.sliding)) }
                        td.n { (factor(about_o)) }
                        td.n { (factor(about_o_prime)) }
                        td.n { (joints::pressed(on).map_or("–".to_owned(), |share| percent(share).trim_end_matches(" %").to_owned())) }
                        td.n { (joints::leaves_at(all, *joint, on).trim_end_matches(" %")) }
                    }
                }
            }
        }
    }
}
