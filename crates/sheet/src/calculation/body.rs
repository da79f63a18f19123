//! The body: what follows from its dimensions.

use standfast::{BaseEdges, Body};
use standfast_cases::{Case, Inputs, Key};

use crate::measured::{ACCELERATION, DENSITY, INERTIA, KILONEWTON, METRE, NONE, TONNE};
use crate::steps::Steps;

pub(super) fn steps(steps: &mut Steps, case: &Case, inputs: &Inputs) {
    let body = &case.body;
    steps.know("g", case.gravity, ACCELERATION);
    steps.know("w", body.width(), METRE);
    steps.know("h_body", body.height(), METRE);
    steps.know("μ", case.friction, NONE);
    steps.know("μ_k", case.kinetic_friction, NONE);
    steps.add("Half width", "", ["B", "w/2"], body.width() / 2.0, METRE, "");
    steps.add("Half height", "", ["H", "h_body/2"], body.height() / 2.0, METRE, "");
    steps.add("Slenderness", "", ["γ", "H/B"], body.slenderness(), NONE, "slenderness");
    if let Some(density) = inputs.number(Key::Density) {
        steps.know("ρ_b", density, DENSITY);
        steps.add("Mass, per metre run", "", ["m", "ρ_b w h_body"], body.mass(), TONNE, "mass");
    } else {
        steps.know("m", body.mass(), TONNE);
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
        let about = "Moment of inertia about the centre of mass, of a uniform rectangle";
        let formula = ["I", "m (w^2 + h_body^2)/12"];
        steps.add(about, "", formula, body.moment_of_inertia(), INERTIA, "moment_of_inertia");
    }
}

const CORNERS: &str = "Centre of mass from the corners O (left) and O′ (right)";

/// Base and centre of mass of a uniform rectangle.
fn uniform(steps: &mut Steps, body: &Body) {
    steps.add("Width of the base", "", ["B_c", "w"], body.base_width(), METRE, "");
    let about = "Centre of mass above the base";
    steps.add(about, "", ["y_C", "H"], body.centroid_height(), METRE, "centroid_height");
    steps.add(CORNERS, "", ["b_1", "w/2"], body.heel_distance(), METRE, "heel_distance");
    steps.add("", "", ["b_2", "w/2"], body.toe_distance(), METRE, "toe_distance");
}

/// Base and centre of mass where the file says where they are.
fn of_any_shape(steps: &mut Steps, body: &Body) {
    let BaseEdges { left, right } = body.base_edges();
    steps.know("e_l", left, METRE);
    steps.know("e_r", right, METRE);
    steps.know("x_C", body.centroid_offset(), METRE);
    steps.know("y_C", body.centroid_height(), METRE);
    let about = "Width of the base, from its edges left and right of mid-width";
    steps.add(about, "", ["B_c", "e_l + e_r"], body.base_width(), METRE, "");
    steps.add(CORNERS, "", ["b_1", "e_l + x_C"], body.heel_distance(), METRE, "heel_distance");
    steps.add("", "", ["b_2", "e_r − x_C"], body.toe_distance(), METRE, "toe_distance");
}
