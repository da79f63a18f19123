//! The body: what follows from its dimensions.

use standfast::Body;
use standfast_cases::Case;

use crate::quantity::{ACCELERATION, DENSITY, INERTIA, KILONEWTON, METRE, NONE, TONNE};
use crate::steps::Steps;

pub(super) fn steps(steps: &mut Steps, case: &Case) {
    let body = &case.body;
    steps.know("g", case.gravity, ACCELERATION);
    steps.know("w", body.width(), METRE);
    steps.know("h_w", body.height(), METRE);
    steps.know("μ", case.friction, NONE);
    steps.know("μ_s", case.friction, NONE);
    steps.know("μ_k", case.kinetic_friction, NONE);
    steps.add("Half width", "", ["B", "w/2"], body.width() / 2.0, METRE, "");
    steps.add("Half height", "", ["H", "h_w/2"], body.height() / 2.0, METRE, "");
    steps.add("Slenderness", "", ["γ", "H/B"], body.slenderness(), NONE, "gamma");
    if let Some(density) = given(case, "density") {
        steps.know("ρ_b", density, DENSITY);
        steps.add("Mass, per metre run", "", ["m", "ρ_b w h_w"], body.mass(), TONNE, "mass");
    } else {
        steps.know("m", body.mass(), TONNE);
    }
    steps.add("Weight", "", ["G", "m g"], body.mass() * case.gravity, KILONEWTON, "weight");
    if body.is_uniform() {
        steps.know("b_1", body.heel_distance(), METRE);
        steps.know("b_2", body.toe_distance(), METRE);
        steps.know("y_C", body.centroid_height(), METRE);
        steps.know("B_c", body.base_width(), METRE);
        if case.is_plain() {
            return;
        }
        uniform(steps, body);
    } else {
        of_any_shape(steps, case);
    }
    if given(case, "moment_of_inertia").is_some() {
        steps.know("I", body.moment_of_inertia(), INERTIA);
    } else {
        let about = "Moment of inertia about the centre of mass, of a uniform rectangle";
        let formula = ["I", "m (w^2 + h_w^2)/12"];
        steps.add(about, "", formula, body.moment_of_inertia(), INERTIA, "moment_of_inertia");
    }
}

/// A number of the file's table `[body]`.
fn given(case: &Case, key: &str) -> Option<f64> {
    let mut numbers = case.numbers.iter();
    let found = numbers.find(|number| number.id.table == "[body]" && number.id.key == key);
    found.map(|number| number.value)
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
fn of_any_shape(steps: &mut Steps, case: &Case) {
    let body = &case.body;
    let (left, right) = body.base_edges();
    steps.know("e_l", left, METRE);
    steps.know("e_r", right, METRE);
    steps.know("x_C", given(case, "centroid_offset").unwrap_or(0.0), METRE);
    steps.know("y_C", body.centroid_height(), METRE);
    let about = "Width of the base, from its edges left and right of mid-width";
    steps.add(about, "", ["B_c", "e_l + e_r"], body.base_width(), METRE, "");
    steps.add(CORNERS, "", ["b_1", "e_l + x_C"], body.heel_distance(), METRE, "heel_distance");
    steps.add("", "", ["b_2", "e_r − x_C"], body.toe_distance(), METRE, "toe_distance");
}
