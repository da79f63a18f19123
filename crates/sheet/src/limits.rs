//! What the calculation does not cover, and what leaves the range of its formulas.

use maud::{Markup, html};
use standfast_cases::Case;

pub fn words(case: &Case) -> Markup {
    let warnings = case.warnings();
    html! {
        @if warnings.is_empty() {
            p { "No warning: nothing leaves the ranges that the program checks." }
        } @else {
            p { "Outside the range of the formulas, or unusual:" }
            ul.warnings { @for warning in &warnings { li { (warning) " (" code { (warning.name()) } ")." } } }
        }
        p { "The following is not part of this calculation and has to be shown separately where it matters:" }
        ul {
            li { "bearing capacity and sliding within the rubble mound, the foundation or the soil beneath; settlement and tilt;" }
            li { "pore pressure in the foundation, built up or drained while the load acts;" }
            @if case.wave.is_some() {
                li { "overtopping, and the pressures that it relieves or adds; impulsive pressures beyond the formulas used;" }
                li {
                    "wave troughs, seaward loads, and waves of other heights, periods and water levels than those given"
                    @if !case.pressures.is_empty() { ", but for the pressures given under [[pressure]]" }
                    ";"
                }
            } @else {
                li {
                    "overtopping and wave loads"
                    @if !case.pressures.is_empty() { ", but for the pressures given under [[pressure]]" }
                    ";"
                }
            }
            li { "scour, loss of base area, stability of the armour;" }
            li { "strength of the body itself, and of its base where a corner alone carries it;" }
            li { "three-dimensional effects: oblique loads along the structure, corners, joints, neighbouring bodies;" }
            li { "duration: how far the body moves once it has left rest." }
        }
        p {
            "Friction between base and foundation is the least certain input. It enters the factor against sliding in proportion; \
             the modes on either side of the value used stand in the calculation and in the figures. Safety factors do not say how \
             probable a failure is. Nothing here replaces an engineer’s judgement."
        }
    }
}
