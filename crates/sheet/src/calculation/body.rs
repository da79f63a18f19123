//! The body: what follows from its dimensions.

use standfast::section::PartMass;
use standfast::{BaseEdges, Body, Plan, Section};
use standfast_cases::assess::{floor_words, glued};
use standfast_cases::units::Extent;
use standfast_cases::{Case, Id, Inputs, Key};

use crate::measured::{
    ACCELERATION, AREA, DEGREE, DENSITY, INERTIA, KILONEWTON, MASS, METRE, NONE, UNIT_WEIGHT,
};
use crate::steps::SheetSteps;
use crate::symbols::numbered;

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, inputs: &Inputs) {
    let body = &case.body;
    steps.know("g", case.gravity, ACCELERATION);
    if case.section.is_some() {
        let words = "from the outlines of the parts";
        steps.told("Width of the body", "w", body.width(), METRE, words, "width");
        steps.told("Its height above the base", "h_body", body.height(), METRE, words, "height");
    } else {
        steps.know("w", body.width(), METRE);
        steps.know("h_body", body.height(), METRE);
    }
    if case.floor_deg != 0.0 {
        steps.know("ε_f", case.floor_deg, DEGREE);
        steps.note(&format!("The floor {}.", floor_words(case)));
    }
    steps.know("μ", case.friction, NONE);
    steps.know("μ_k", case.kinetic_friction, NONE);
    steps.add("Half width", "", ["B", "w/2"], body.width() / 2.0, METRE, "");
    steps.add("Half height", "", ["H", "h_body/2"], body.height() / 2.0, METRE, "");
    steps.add("Slenderness", "", ["γ", "H/B"], body.slenderness(), NONE, "slenderness");
    if let Some(length) = inputs.number(Key::Length) {
        steps.know("L_b", length, METRE);
    }
    if let Some(section) = &case.section {
        of_parts(steps, case, section);
        if let Some(words) = glued(case) {
            steps.note(&words);
        }
        return;
    }
    if let Some(density) = inputs.number(Key::Density) {
        steps.know("ρ_b", density, DENSITY);
        let (about, formula) = match (body.plan(), case.extent) {
            (Plan::Circle, _) => ("Mass", "ρ_b π w^2/4 h_body"),
            (_, Extent::Whole) => ("Mass", "ρ_b w h_body L_b"),
            (_, Extent::PerMetre) => ("Mass, per metre run", "ρ_b w h_body"),
        };
        steps.add(about, "", ["m", formula], body.mass(), MASS, "mass");
    } else {
        steps.know("m", body.mass(), MASS);
    }
    steps.add("Weight", "", ["G", "m g"], body.mass() * case.gravity, KILONEWTON, "weight");
    if body.is_uniform() {
        uniform(steps, body);
    } else {
        of_any_shape(steps, body);
    }
    if inputs.number(Key::MomentOfInertia).is_some() {
        steps.know("I", body.moment_of_inertia(), INERTIA);
    } else {
        let (about, formula) = match body.plan() {
            Plan::Circle => ("of a uniform cylinder", "m (3/4 w^2 + h_body^2)/12"),
            _ => ("of a uniform rectangle", "m (w^2 + h_body^2)/12"),
        };
        let about = &format!("Moment of inertia about the centre of mass, {about}");
        let formula = ["I", formula];
        steps.add(about, "", formula, body.moment_of_inertia(), INERTIA, "moment_of_inertia");
    }
}

/// Shows mass and centre of each part, then those of all.
fn of_parts(steps: &mut SheetSteps, case: &Case, section: &Section) {
    let body = &case.body;
    let masses = section.masses(case.water_table);
    let long = if case.extent == Extent::Whole { " L_b" } else { "" };
    steps.note(
        "Of each part the area, its centre and its own moment of inertia are those of its outline (Green’s theorem); a part with another density under \
         still water is parted there. `x` counts from the middle of the body’s width.",
    );
    for (i, ((name, part), PartMass { dry, wet, mass, centre, moment_of_inertia })) in
        case.parts().zip(&masses).enumerate()
    {
        let n = i + 1;
        let of = |letter: &str| format!("{letter}_{n}");
        let [dry_density, wet_density] =
            [Key::PartDensity, Key::PartDensityBelow].map(|key| numbered(key.info().symbol, i, masses.len()));
        let about = format!(
            "Part {n}{}: area{}",
            name.map_or(String::new(), |name| format!(", {}", name.replace('`', "'"))),
            if *wet == 0.0 { "" } else { " above still water" },
        );
        steps.told(&about, &of("A"), *dry, AREA, "of its outline", "");
        match case.inputs().number(Id::new(Key::PartUnitWeight, i)) {
            Some(weight) => {
                let symbol = numbered(Key::PartUnitWeight.info().symbol, i, masses.len());
                steps.know_input(&symbol, weight, UNIT_WEIGHT);
                let formula = [dry_density.as_str(), &format!("{symbol}/g")];
                steps.add("Its density", "", formula, part.density(), DENSITY, "");
            }
            None => steps.know(&dry_density, part.density(), DENSITY),
        }
        let formula = if *wet == 0.0 {
            format!("{dry_density} A_{n}{long}")
        } else {
            steps.told("Its area below", &format!("A'_{n}"), *wet, AREA, "of its outline", "");
            steps.know(&wet_density, part.density_below_water(), DENSITY);
            match long {
                "" => format!("{dry_density} A_{n} + {wet_density} A'_{n}"),
                long => format!("({dry_density} A_{n} + {wet_density} A'_{n}){long}"),
            }
        };
        let times = case.body.plan().side(body.width());
        steps.add("Its mass", "", [&of("m"), &formula], mass * times, MASS, "");
        steps.told("Its centre, right of mid-width", &of("x"), centre.x, METRE, "of its outline", "");
        steps.told("above the base", &of("y"), centre.y, METRE, "of its outline", "");
        let words = "of its outline, about its own centre";
        steps.told("Its moment of inertia", &of("I"), moment_of_inertia * times, INERTIA, words, "");
    }
    let sum = |term: &dyn Fn(usize) -> String| (1..=masses.len()).map(term).collect::<Vec<_>>().join(" + ");
    steps.add("Mass", "", ["m", &sum(&|n| format!("m_{n}"))], body.mass(), MASS, "mass");
    steps.add("Weight", "", ["G", "m g"], body.mass() * case.gravity, KILONEWTON, "weight");
    let x = format!("({})/m", sum(&|n| format!("m_{n} x_{n}")));
    steps.add("Centre of mass, right of mid-width", "", ["x_C", &x], body.centroid_offset(), METRE, "");
    let y = format!("({})/m", sum(&|n| format!("m_{n} y_{n}")));
    steps.add("above the base", "", ["y_C", &y], body.centroid_height(), METRE, "centroid_height");
    let BaseEdges { left, right } = body.base_edges();
    let words = "from the outlines of the parts that stand on the base";
    steps.told("Edge of the base left of mid-width", "e_l", left, METRE, words, "");
    steps.told("right of it", "e_r", right, METRE, words, "");
    base(steps, body);
    let inertia = sum(&|n| format!("I_{n} + m_{n} ((x_{n} − x_C)^2 + (y_{n} − y_C)^2)"));
    let about = "Moment of inertia about the centre of mass";
    steps.add(about, "", ["I", &inertia], body.moment_of_inertia(), INERTIA, "moment_of_inertia");
}

const CORNERS: &str = "Centre of mass from the corners O (left) and O′ (right)";

/// Base and centre of mass of a uniform rectangle.
fn uniform(steps: &mut SheetSteps, body: &Body) {
    steps.add("Width of the base", "", ["B_c", "w"], body.base_width(), METRE, "");
    let about = "Centre of mass above the base";
    steps.add(about, "", ["y_C", "H"], body.centroid_height(), METRE, "centroid_height");
    steps.add(CORNERS, "", ["b_1", "w/2"], body.heel_distance(), METRE, "heel_distance");
    steps.add("", "", ["b_2", "w/2"], body.toe_distance(), METRE, "toe_distance");
}

/// Base and centre of mass where the file says where they are.
fn of_any_shape(steps: &mut SheetSteps, body: &Body) {
    let BaseEdges { left, right } = body.base_edges();
    steps.know("e_l", left, METRE);
    steps.know("e_r", right, METRE);
    steps.know("x_C", body.centroid_offset(), METRE);
    steps.know("y_C", body.centroid_height(), METRE);
    base(steps, body);
}

/// The width of the base, and its corners, from its edges.
fn base(steps: &mut SheetSteps, body: &Body) {
    let about = "Width of the base, from its edges left and right of mid-width";
    steps.add(about, "", ["B_c", "e_l + e_r"], body.base_width(), METRE, "");
    steps.add(CORNERS, "", ["b_1", "e_l + x_C"], body.heel_distance(), METRE, "heel_distance");
    steps.add("", "", ["b_2", "e_r − x_C"], body.toe_distance(), METRE, "toe_distance");
}
