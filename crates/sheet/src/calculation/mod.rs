//! The calculation, step by step; every result is the library's.

mod body;
mod classical;
mod contact;
mod loads;
mod mode;
mod motion;
mod path;
mod waves;

use maud::Markup;
use standfast::Slip;
use standfast_cases::describe::Scale;
use standfast_cases::{Assessed, Case, load_name};

pub use classical::TARGET;

use crate::SheetError;
use crate::fault::Fault;
use crate::quantity::{KILONEWTON, METRE, NONE};
use crate::steps::Steps;

/// The calculation of a case whose forces are each the report's problem.
pub fn plain(case: &Case) -> Result<Markup, Fault> {
    let mut steps = Steps::new("Body");
    body::steps(&mut steps, case);
    let several = case.loads.len() > 1;
    let scale = Scale::of(&case.body, case.gravity);
    for (i, load) in case.loads.iter().enumerate() {
        let title = match several {
            true => format!("Load {}: {}", i + 1, load_name(case, i)),
            false => format!("Load: {}", load_name(case, i)),
        };
        steps.part(&title, Some(i));
        let point = &load.reduced.point;
        let towards = match load.force.direction() {
            Slip::Left => "left",
            Slip::Right => "right",
        };
        steps.know("F", load.force.magnitude(), KILONEWTON);
        steps.know("e", load.force.elevation(), METRE);
        steps.know("μ", point.mu(), NONE);
        steps.heading("Reduction to the report's plane");
        let about = format!("Force, to the {towards}, in weights of the body");
        steps.add(&about, "", ["k", "F/(m g)"], point.k(), NONE, "k");
        let about = "Height of the force above the centre of mass, in half-heights";
        steps.add(about, "", ["k'", "(e − H)/H"], point.k_prime(), NONE, "k_prime");
        mode::safety_factors(&mut steps, point);
        mode::decision(&mut steps, &load.reduced);
        motion::reduced(&mut steps, &load.reduced, &scale);
        mode::changes(&mut steps, &load.reduced, Some(&scale));
    }
    steps.finish()
}

/// The calculation of a case whose loads act together.
pub fn together(case: &Case, all: &[Assessed]) -> Result<Markup, SheetError> {
    let mut steps = Steps::new("Body");
    body::steps(&mut steps, case);
    if let Some(wave) = &case.wave {
        steps.part("Waves and pressures (Goda, Takahashi)", None);
        waves::steps(&mut steps, case, wave);
    }
    let several = all.len() > 1;
    for assessed in all {
        let title = match assessed.loaded.load.filter(|_| several) {
            Some(load) => format!("With load {}: {}", load + 1, load_name(case, load)),
            None => "Loads and response".to_owned(),
        };
        steps.part(&title, Some(assessed.loaded.load.unwrap_or(0)));
        loads::steps(&mut steps, case, assessed);
        classical::steps(&mut steps, assessed);
        match &assessed.full.effective {
            Some(reduced) => {
                mode::effective(&mut steps, reduced);
                mode::decision(&mut steps, reduced);
            }
            None => contact::steps(&mut steps, &assessed.loaded.situation, &assessed.full.wrench)?,
        }
        motion::together(&mut steps, case, assessed);
        path::steps(&mut steps, assessed);
    }
    Ok(steps.finish()?)
}
