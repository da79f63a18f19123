//! Thrust and uplift of waves by other formulas than Goda's, whose numbers stand among the results of the sea.

use standfast::loads::{Action, Face, Load};
use standfast::wave::{CrownRatio, WavePhase};

use super::{MadeDiagram, MadeLoad, MadeRange};
use crate::case::{Case, CrownWall, WaveFormula, Waves};

/// What a public program has of Sainflou's formula.
const SAINFLOU: &str = "Sainflou, linear form, as coded in a public program";
const SAINFLOU_UPLIFT: &str = "Sainflou; the uplift's fall to nothing at the heel";
const PEDERSEN: &str = "Coastal Engineering Manual, table VI-5-61, as coded in an open toolbox";
const VAN_GENT: &str = "Van Gent and Van der Werf (2019), as coded in a public toolbox";

/// The thrust, and the uplift where there is one.
pub(super) fn made(case: &Case, wave: &Waves) -> Vec<MadeLoad> {
    let (formula, sources, elevation) = match &wave.formula {
        WaveFormula::Goda(_) => return Vec::new(),
        WaveFormula::Sainflou(waves) => {
            let formula = match waves.wave.phase {
                WavePhase::Crest => "sainflou-crest",
                WavePhase::Trough => "sainflou-trough",
            };
            let elevation = waves.wave.force_moment / waves.wave.force;
            (formula, [(SAINFLOU, true), (SAINFLOU_UPLIFT, false)], elevation)
        }
        WaveFormula::Crown(waves) => {
            let (formula, source) = match waves.wall {
                CrownWall::Pedersen(_) => ("pedersen", PEDERSEN),
                CrownWall::VanGent(_) => ("van-gent", VAN_GENT),
            };
            (formula, [(source, true); 2], waves.wave.elevation)
        }
    };
    let ranges: Vec<MadeRange> = match &wave.formula {
        WaveFormula::Crown(waves) => waves.wave.ratios.iter().map(range).collect(),
        _ => Vec::new(),
    };
    let body = case.body.rounded();
    let names = ["wave.thrust", "wave.uplift"].into_iter().zip(sources);
    let loads = wave.loads(&body).into_iter().zip(names);
    let made = loads.map(|(load, (name, (source, source_read)))| {
        let wrench = load.upright(&body, case.gravity);
        let is_thrust = name == "wave.thrust";
        MadeLoad {
            name: name.to_owned(),
            from: "wave".to_owned(),
            formula,
            source,
            source_read,
            coefficients: Vec::new(),
            diagrams: diagram(&load).into_iter().collect(),
            // Towards the body, as of soil: a trough pulls.
            force_h: 0.0 - wrench.x,
            force_v: wrench.p,
            elevation: if is_thrust { elevation } else { 0.0 },
            ranges: if is_thrust { ranges.clone() } else { Vec::new() },
        }
    });
    made.collect()
}

fn range(ratio: &CrownRatio) -> MadeRange {
    let CrownRatio { name, value, low, high } = *ratio;
    MadeRange { name, value, low, high, inside: ratio.is_inside() }
}

/// The diagram of a load; `None` of one force.
fn diagram(load: &Load) -> Option<MadeDiagram> {
    let Action::Pressure { face, diagram } = &load.action else { return None };
    let positions: Vec<f64> = diagram.points().iter().map(|point| point.position).collect();
    let pressure: Vec<f64> = diagram.points().iter().map(|point| point.pressure).collect();
    let zeros = vec![0.0; positions.len()];
    let (face, elevation, distance) = match face {
        Face::Base => ("base", Vec::new(), positions),
        _ => ("right", positions, Vec::new()),
    };
    Some(MadeDiagram { face, elevation, distance, pressure, tangential: zeros })
}
