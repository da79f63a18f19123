//! The calculation, step by step; every result is the library's.

mod body;
mod classical;
mod contact;
mod loads;
mod mode;
mod motion;
mod path;
mod waves;

use maud::{Markup, html};
use standfast::Slip;
use standfast_cases::describe::Scale;
use standfast_cases::{Assessed, Case, load_name};

pub use classical::TARGET;

use crate::quantity::{KILONEWTON, METRE, NONE};
use crate::steps::Steps;

/// The calculation of a case whose forces are each the report's problem.
pub fn plain(case: &Case) -> Markup {
    let mut steps = Steps::default();
    body::steps(&mut steps, case);
    let body = steps.cut();
    let several = case.loads.len() > 1;
    let scale = Scale::of(&case.body, case.gravity);
    let loads = case.loads.iter().enumerate().map(|(i, load)| {
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
        let title = match several {
            true => format!("Load {}: {}", i + 1, load_name(case, i)),
            false => format!("Load: {}", load_name(case, i)),
        };
        (title, steps.cut())
    });
    let loads: Vec<_> = loads.collect();
    html! {
        section.part { h3.part { "Body" } (body) }
        @for (i, (title, steps)) in loads.into_iter().enumerate() {
            section.part data-load=(i) { h3.part { (title) } (steps) }
        }
    }
}

/// The calculation of a case whose loads act together.
pub fn together(case: &Case, all: &[Assessed]) -> Markup {
    let mut steps = Steps::default();
    body::steps(&mut steps, case);
    let body = steps.cut();
    let waves = case.wave.as_ref().map(|wave| {
        waves::steps(&mut steps, case, wave);
        steps.cut()
    });
    let several = all.len() > 1;
    let situations: Vec<_> = all
        .iter()
        .map(|assessed| {
            let title = match assessed.loaded.load.filter(|_| several) {
                Some(load) => format!("With load {}: {}", load + 1, load_name(case, load)),
                None => "Loads and response".to_owned(),
            };
            loads::steps(&mut steps, case, assessed);
            classical::steps(&mut steps, assessed);
            match &assessed.full.effective {
                Some(reduced) => {
                    mode::effective(&mut steps, reduced);
                    mode::decision(&mut steps, reduced);
                }
                None => contact::steps(&mut steps, assessed),
            }
            motion::together(&mut steps, case, assessed);
            path::steps(&mut steps, assessed);
            (assessed.loaded.load, title, steps.cut())
        })
        .collect();
    html! {
        section.part { h3.part { "Body" } (body) }
        @if let Some(waves) = waves { section.part { h3.part { "Waves and pressures (Goda, Takahashi)" } (waves) } }
        @for (load, title, steps) in situations {
            section.part data-load=(load.unwrap_or(0)) { h3.part { (title) } (steps) }
        }
    }
}
