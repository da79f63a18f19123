//! The motion and reactions at onset, and the equations of motion with these numbers.

use maud::{Markup, PreEscaped, html};
use standfast::{Motion, Reduced};
use standfast_cases::describe::{QUANTITIES, Scale};
use standfast_cases::{Assessed, Case};

use crate::fault::Fault;
use crate::mathml::{prose, symbol};
use crate::quantity::{ACCELERATION, INERTIA, KILONEWTON, METRE, NONE, ROTATION, TONNE, number};
use crate::steps::Steps;

/// The keys of the motion in the program's JSON, in the order of [`QUANTITIES`].
const KEYS: [&str; 9] =
    ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi", "slip", "lift_o", "lift_o_prime"];

/// The motion of the real body, in SI units, beside the non-dimensional one if there is one.
fn table(reduced: Option<&Motion>, si: &Motion) -> Result<Markup, Fault> {
    Ok(html! {
        table.numbers data-table="motion" {
            thead {
                tr {
                    th {}
                    th { "Quantity" }
                    @if reduced.is_some() { th.n { "in" } th {} }
                    th.n { "of this body" }
                    th {}
                }
            }
            tbody {
                @for (quantity, key) in QUANTITIES.iter().zip(KEYS) {
                    @let real = (quantity.of)(si) / quantity.si_units + 0.0;
                    tr {
                        td { (PreEscaped(symbol(quantity.symbol))) }
                        td { (prose(&quantity.words.replace("f_y", "`f_y`"))?) }
                        @if let Some(reduced) = reduced {
                            @let value = (quantity.of)(reduced);
                            td.n { data value=(value) data-quantity={ "motion." (key) } { (number(value)) } }
                            td { (quantity.unit) }
                        }
                        td.n { data value=(real) data-quantity={ "motion_si." (key) } { (number(real)) } }
                        td { (quantity.si_unit) }
                    }
                }
            }
        }
    })
}

/// The motion of a point of the report's plane, non-dimensional and of the real body.
pub(super) fn reduced(steps: &mut Steps, reduced: &Reduced, scale: &Scale) {
    let motion = reduced.motion();
    let si = scale.si(&motion);
    steps.heading("Motion and reactions at onset");
    steps.write(table(Some(&motion), &si));
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. } = motion;
    steps.know("f_x", f_x, NONE);
    steps.know("f_y", f_y, NONE);
    steps.know("ξ", xi, NONE);
    // The force points right where the point is the mirror image.
    let [along, about] = if reduced.mirrored { ["f_x + k", "−"] } else { ["f_x − k", "+"] };
    let numbers =
        if reduced.point.k_prime() >= 0.0 { ["3.9", "3.10", "3.11"] } else { ["4.24", "4.25", "4.26"] };
    steps.add("The equations of motion with these numbers", numbers[0], ["ẍ", along], x_ddot, NONE, "");
    steps.add("", numbers[1], ["ÿ", "f_y − 1"], y_ddot, NONE, "");
    let formula = format!("3 (γ f_x + ξ f_y {about} γ k k')/(1 + γ^2)");
    steps.add("", numbers[2], ["θ\u{308}", &formula], theta_ddot, NONE, "");
}

/// The motion of the body under loads that act together.
pub(super) fn together(steps: &mut Steps, case: &Case, assessed: &Assessed) {
    let Some(motion) = &assessed.full.motion else { return };
    steps.heading("Motion and reactions at onset, full load applied at once");
    steps.write(table(None, motion));
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. } = *motion;
    let body = &case.body;
    steps.know("f_x", f_x, KILONEWTON);
    steps.know("f_y", f_y, KILONEWTON);
    steps.know("ξ", xi, METRE);
    steps.know("m", body.mass(), TONNE);
    steps.know("I", body.moment_of_inertia(), INERTIA);
    let along = if case.added_mass.mass > 0.0 { "(X + f_x)/(m + M_a)" } else { "(X + f_x)/m" };
    steps.add("The equations of motion with these numbers", "", ["ẍ", along], x_ddot, ACCELERATION, "");
    steps.add("", "", ["ÿ", "(f_y − V)/m"], y_ddot, ACCELERATION, "");
    let formula = ["θ\u{308}", "(M + y_C f_x + ξ f_y)/I"];
    steps.add("", "", formula, theta_ddot, ROTATION, "");
}
