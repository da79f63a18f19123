//! The motion and reactions at onset, and the equations of motion with these numbers. Of what does not move there are no
//! accelerations, and its equation gives the reaction.

use maud::{Markup, PreEscaped, html};
use standfast::{Corner, Motion};
use standfast_cases::describe::{MOTION, MotionPart, RELATIVE};
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case};

use crate::fault::SheetFault;
use crate::mathml::{prose, symbol};
use crate::measured::{ACCELERATION, INERTIA, KILONEWTON, MASS, METRE, ROTATION, SheetUnit};
use crate::steps::SheetSteps;
use crate::together::Row;

/// The motion of the body, without what is zero: as a table, and as rows.
fn table(steps: &SheetSteps, motion: &Motion) -> Result<(Markup, Vec<Row>), SheetFault> {
    let measured =
        |part: &MotionPart| steps.measured((part.of)(motion), part.dimension.map_or(ROTATION, SheetUnit::of));
    let mut rows = Vec::new();
    for part in MOTION.iter().filter(|part| (part.of)(motion) != 0.0) {
        let value = measured(part);
        rows.push(Row {
            name: part.symbol.to_owned(),
            key: format!("motion.{}", part.key),
            about: html! {},
            head: html! {
                (PreEscaped(symbol(part.symbol))) ", " (prose(&part.words.replace("f_y", "`f_y`"))?)
            },
            unit: html! { span.unit { (value.unit.text) } },
            cell: value.number_html(&format!("motion.{}", part.key)),
        });
    }
    let full = html! {
        table.numbers data-table="motion" {
            thead { tr { th {} th { "Quantity" } th.n { "of this body" } th {} } }
            tbody {
                @for part in MOTION.iter().filter(|part| (part.of)(motion) != 0.0) {
                    @let value = measured(part);
                    tr {
                        td { (PreEscaped(symbol(part.symbol))) }
                        td { (prose(&part.words.replace("f_y", "`f_y`"))?) }
                        td.n { (value.number_html(&format!("motion.{}", part.key))) }
                        td { (value.unit.text) }
                    }
                }
            }
        }
    };
    Ok((full, rows))
}

/// The motion under the full load.
pub(super) fn steps(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, held: [&str; 3]) {
    let Some(motion) = assessed.motion() else { return };
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. } = *motion;
    let rests = [x_ddot, y_ddot, theta_ddot] == [0.0; 3];
    steps.heading(match rests {
        true => "Reactions under the full load; the body rests, and nothing accelerates",
        false => "Motion and reactions at onset, full load applied at once",
    });
    if !rests || f_x != 0.0 || f_y != 0.0 {
        steps.quantities(table(steps, motion));
    }
    if assessed.earthquake.is_some() {
        steps.note(RELATIVE);
    }
    steps.note(match rests {
        true => "Equilibrium with these numbers:",
        false => "The equations of motion with these numbers:",
    });
    steps.know_all([
        ("m", case.body.mass(), MASS),
        ("I", case.body.moment_of_inertia(), INERTIA),
        ("f_x", f_x, KILONEWTON),
        ("f_y", f_y, KILONEWTON),
        ("ξ", xi, METRE),
    ]);
    let [x, v, m] = held;
    vertical(steps, motion, v);
    horizontal(steps, case, assessed, motion, x);
    rotation(steps, assessed, motion, m);
}

/// Shows the reaction along the base: from friction if the body slips, from balance if it does not accelerate.
fn horizontal(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, motion: &Motion, held: &str) {
    let Motion { x_ddot, f_x, .. } = *motion;
    let about = "Along the base";
    match assessed.mode().and_then(|mode| mode.slip()) {
        Some(slip) if f_x != 0.0 => {
            let friction = if case.kinetic_friction == case.friction { "μ" } else { "μ_k" };
            let sign = if slip.sign() < 0.0 { "" } else { "−" };
            let formula = format!("{sign}{friction} f_y");
            steps.add("Coulomb friction, against the slip", "", ["f_x", &formula], f_x, KILONEWTON, "");
        }
        _ if x_ddot == 0.0 && f_x != 0.0 => {
            let formula = if held.is_empty() { "−X".to_owned() } else { format!("−(X{held})") };
            steps.add(about, "", ["f_x", &formula], f_x, KILONEWTON, "");
        }
        _ => {}
    }
    if x_ddot != 0.0 {
        let force = match (f_x != 0.0, held.is_empty()) {
            (true, _) => format!("(X{held} + f_x)"),
            (false, true) => "X".to_owned(),
            (false, false) => format!("(X{held})"),
        };
        let mass = if case.added_mass.mass() > 0.0 { "(m + m_a)" } else { "m" };
        steps.add(about, "", ["ẍ", &format!("{force}/{mass}")], x_ddot, ACCELERATION, "");
    }
}

fn vertical(steps: &mut SheetSteps, motion: &Motion, held: &str) {
    let Motion { y_ddot, f_y, .. } = *motion;
    if y_ddot != 0.0 {
        let load = if held.is_empty() { "V".to_owned() } else { format!("(V{held})") };
        let formula = if f_y != 0.0 { format!("(f_y − {load})/m") } else { format!("−{load}/m") };
        steps.add("Upwards", "", ["ÿ", &formula], y_ddot, ACCELERATION, "");
    } else if f_y != 0.0 {
        steps.add("Upwards", "", ["f_y", &format!("V{held}")], f_y, KILONEWTON, "");
    }
}

fn rotation(steps: &mut SheetSteps, assessed: &Assessed, motion: &Motion, held: &str) {
    let Motion { theta_ddot, f_x, f_y, xi, .. } = *motion;
    let lever = if f_x != 0.0 { " + y_C f_x" } else { "" };
    if f_y != 0.0 {
        match assessed.mode().and_then(|mode| mode.corner()) {
            Some(corner) if assessed.is_on_ground() => {
                let long = if assessed.extent == Extent::Whole { " L_b" } else { "" };
                let (formula, about) = match corner {
                    Corner::O => (
                        format!("−b_1 + f_y/(2 q_u{long})"),
                        "The reaction acts in the middle of what is crushed at O",
                    ),
                    Corner::OPrime => (
                        format!("b_2 − f_y/(2 q_u{long})"),
                        "The reaction acts in the middle of what is crushed at O′",
                    ),
                };
                steps.add(about, "", ["ξ", &formula], xi, METRE, "");
            }
            Some(corner) => {
                let (formula, about) = match corner {
                    Corner::O => ("−b_1", "The reaction acts at the corner O"),
                    Corner::OPrime => ("b_2", "The reaction acts at the corner O′"),
                };
                steps.add(about, "", ["ξ", formula], xi, METRE, "");
            }
            None if theta_ddot == 0.0 && xi != 0.0 => {
                let formula = format!("−(M{held}{lever})/f_y");
                steps.add("Moments about the centre of mass", "", ["ξ", &formula], xi, METRE, "");
            }
            None => {}
        }
    }
    if theta_ddot != 0.0 {
        let reaction = if f_y != 0.0 { " + ξ f_y" } else { "" };
        let formula = format!("(M{held}{lever}{reaction})/I");
        let about = "Moments about the centre of mass";
        steps.add(about, "", ["θ\u{308}", &formula], theta_ddot, ROTATION, "");
    }
}
