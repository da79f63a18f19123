//! The motion and reactions at onset, and the equations of motion with these numbers.

use maud::{Markup, PreEscaped, html};
use standfast::Motion;
use standfast_cases::describe::{MOTION, RELATIVE};
use standfast_cases::{Assessed, Case};

use crate::fault::Fault;
use crate::mathml::{prose, symbol};
use crate::measured::{ACCELERATION, INERTIA, KILONEWTON, METRE, ROTATION, TONNE, number};
use crate::steps::Steps;

/// The motion of the body.
fn table(case: &Case, motion: &Motion) -> Result<Markup, Fault> {
    Ok(html! {
        table.numbers data-table="motion" {
            thead { tr { th {} th { "Quantity" } th.n { "of this body" } th {} } }
            tbody {
                @for part in MOTION {
                    @let value = (part.of)(motion) / part.si_units + 0.0;
                    tr {
                        td { (PreEscaped(symbol(part.symbol))) }
                        td { (prose(&part.words.replace("f_y", "`f_y`"))?) }
                        td.n { data value=(value) data-quantity={ "motion." (part.key) } { (number(value)) } }
                        td { (part.unit_in(case.extent)) }
                    }
                }
            }
        }
    })
}

/// The motion under the full load.
pub(super) fn steps(steps: &mut Steps, case: &Case, assessed: &Assessed) {
    let Some(motion) = &assessed.outcome.full.motion else { return };
    steps.heading("Motion and reactions at onset, full load applied at once");
    steps.write(table(case, motion));
    if assessed.earthquake.is_some() {
        steps.note(RELATIVE);
    }
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. } = *motion;
    let body = &case.body;
    steps.know("f_x", f_x, KILONEWTON);
    steps.know("f_y", f_y, KILONEWTON);
    steps.know("ξ", xi, METRE);
    steps.know("m", body.mass(), TONNE);
    steps.know("I", body.moment_of_inertia(), INERTIA);
    let along = if case.added_mass.mass() > 0.0 { "(X + f_x)/(m + M_a)" } else { "(X + f_x)/m" };
    steps.add("The equations of motion with these numbers", "", ["ẍ", along], x_ddot, ACCELERATION, "");
    steps.add("", "", ["ÿ", "(f_y − V)/m"], y_ddot, ACCELERATION, "");
    let formula = ["θ\u{308}", "(M + y_C f_x + ξ f_y)/I"];
    steps.add("", "", formula, theta_ddot, ROTATION, "");
}
