//! Soil beside the body and the pressure that it makes, for reading.

use standfast::loads::earth::{EarthIncrement, EarthPoint, EarthState, PoreWater, SoilLayer, sums};
use standfast::loads::{Earthquake, Face};

use crate::case::{Case, SoilFill};
use crate::layout::{columns, digits, paragraph, row};
use crate::units::Dimension;
use standfast_inputs::OutputUnits;

/// The words of the formula of the coefficients of a soil, and where it is from.
pub fn formula(fill: &SoilFill) -> &'static str {
    match fill.soil.state {
        EarthState::Active => "Coulomb's wedge, as in UFC 3-220-20 (2025), chapter 4",
        EarthState::AtRest => "Jaky's formula, as in UFC 3-220-20 (2025), chapter 4",
        EarthState::Passive => {
            "Rankine, with friction on the wall a log spiral, as in UFC 3-220-20 (2025), equation 4-12"
        }
    }
}

/// The same of what an earthquake adds.
pub fn formula_of_increment(fill: &SoilFill) -> &'static str {
    match fill.soil.state {
        EarthState::AtRest => "Wood, of a wall that does not yield, as in UFC 3-220-20 (2025), equation 4-18",
        _ => "Mononobe and Okabe, as in UFC 3-220-20 (2025), equations 4-15 to 4-22",
    }
}

/// The side that a soil stands on.
pub fn side(face: Face) -> &'static str {
    if face == Face::Left { "left" } else { "right" }
}

/// The resultant of a pressure: what pushes, its height above the base, and what drags down; N and m.
pub fn resultant(points: &[EarthPoint]) -> [f64; 3] {
    let [push, moment] = sums(points, |point| point.normal);
    let [drag, _] = sums(points, |point| point.tangential);
    [push, if push == 0.0 { 0.0 } else { moment / push }, drag]
}

/// Every soil of a case.
pub(super) fn render(case: &Case) -> String {
    case.soils.iter().map(|fill| one(case, fill)).collect()
}

fn one(case: &Case, fill: &SoilFill) -> String {
    let SoilFill { soil, water, pressure, name, .. } = fill;
    let output = case.output;
    let state = match soil.state {
        EarthState::Active => "active",
        EarthState::AtRest => "at rest",
        EarthState::Passive => "passive",
    };
    let mut text = paragraph(&format!("Soil: {name}, at the {}, {state}", side(soil.face)), 0);
    let slope = if soil.slope_deg == 0.0 {
        "level".to_owned()
    } else {
        format!("rising at {}°", digits(soil.slope_deg))
    };
    let batter = if soil.batter_deg == 0.0 {
        String::new()
    } else {
        format!("; batter {}°", digits(soil.batter_deg))
    };
    let mut rows =
        vec![row!["ground", format!("{} above the base, {slope}{batter}", output.length(soil.top))]];
    match water.filter(|water| water.level > 0.0) {
        Some(water) => {
            rows.push(row!["water in it", format!("{} above the base", output.length(water.level))])
        }
        None => rows.push(row!["water in it", "none"]),
    }
    let layers = soil.layers.iter().zip(&pressure.coefficients).zip(soil.bounds());
    for ((layer, of), [upper, lower]) in layers {
        let heading = match soil.layers.len() {
            1 => "friction".to_owned(),
            _ => format!("{} to {}", output.value(Dimension::Length, upper), output.length(lower)),
        };
        rows.push(row![heading, layer_words(layer, of.k, output)]);
        if layer.soil.cohesion > 0.0 && !fill.is_passive() {
            let words = format!("c = {}, K_c = {}", output.pressure(layer.soil.cohesion), digits(of.k_c));
            rows.push(row!["", words]);
        }
    }
    let of = |points: &[EarthPoint]| acting(case, resultant(points));
    for (place, words) in diagram(&pressure.soil, output).into_iter().enumerate() {
        rows.push(row![if place == 0 { "pressure" } else { "" }, words]);
    }
    rows.push(row![if fill.is_passive() { "resists" } else { "pushes" }, of(&pressure.soil)]);
    if !pressure.surcharge.is_empty() {
        let words = format!("{} on the ground: {}", output.pressure(soil.surcharge), of(&pressure.surcharge));
        rows.push(row!["surcharge", words]);
    }
    text += &columns(&rows, 2, &[]);
    text += &paragraph(&format!("K by {}.", formula(fill)), 2);
    if soil.layers.iter().all(|layer| layer.soil.wall_friction_deg == 0.0) && soil.state == EarthState::Active
    {
        text += &paragraph("No friction between soil and body is counted: `wall_friction_deg` is 0.", 2);
    }
    text + "\n"
}

/// What pushes, at which height, and what drags down, of a pressure per metre run.
fn acting(case: &Case, [push, elevation, drag]: [f64; 3]) -> String {
    let whole = |force: f64| case.output.force(force * along(case));
    let drags = if drag == 0.0 { String::new() } else { format!(", drags down {}", whole(drag)) };
    format!("{} at {}{drags}", whole(push), case.output.length(elevation))
}

/// How long the body is along the soil, m.
pub(super) fn along(case: &Case) -> f64 {
    case.body.plan().side(case.body.width())
}

fn layer_words(SoilLayer { soil, .. }: &SoilLayer, k: f64, output: OutputUnits) -> String {
    let weighs = |weight: f64| output.value(Dimension::UnitWeight, weight);
    let mut words = format!(
        "φ = {}°, δ = {}°: K = {}; {}",
        digits(soil.friction_angle_deg),
        digits(soil.wall_friction_deg),
        digits(k),
        weighs(soil.unit_weight)
    );
    if let Some(saturated) = soil.unit_weight_saturated {
        words += &format!(", under water {}", weighs(saturated));
    }
    words + " " + &output.symbol(Dimension::UnitWeight)
}

/// A pressure from the top down, in lines of a few points.
fn diagram(points: &[EarthPoint], output: OutputUnits) -> Vec<String> {
    /// Points in a line.
    const LINE: usize = 3;
    let mut words: Vec<String> = Vec::new();
    for point in points.iter().rev() {
        let at = if point.elevation == 0.0 { "the base".to_owned() } else { output.length(point.elevation) };
        let said = format!("{} at {at}", output.pressure(point.normal));
        if words.last() != Some(&said) {
            words.push(said);
        }
    }
    words.chunks(LINE).map(|line| line.join(", ")).collect()
}

/// What an earthquake adds to each soil that it drives against the body.
pub(super) fn increments(case: &Case, earthquake: &Earthquake) -> String {
    let mut text = String::new();
    for fill in &case.soils {
        let Some(increment) = fill.increment(earthquake, case.gravity) else { continue };
        let EarthIncrement { coefficients, force, drag, points, pore_water } = increment;
        let mut rows = Vec::new();
        for (place, both) in coefficients.iter().enumerate() {
            let layer = if coefficients.len() > 1 { format!("layer {}, ", place + 1) } else { String::new() };
            for (wet, found) in both.iter().enumerate() {
                let Some([k, ψ]) = found else { continue };
                let place = ["above water", "below water"][wet];
                rows.push(row![
                    format!("{layer}{place}"),
                    format!("ψ = {}°: K_E = {}", digits(*ψ), digits(*k))
                ]);
            }
        }
        let [_, elevation, _] = resultant(&points);
        rows.push(row!["adds", acting(case, [force, elevation, drag])]);
        if let Some([force, elevation]) = pore_water {
            rows.push(row!["pore water", acting(case, [force, elevation, 0.0])]);
        }
        text += &format!("\n{}", paragraph(&format!("{} in the earthquake", fill.name), 0));
        text += &columns(&rows, 2, &[]);
        let moves = match fill.soil.pore_water {
            PoreWater::Free => "water that moves freely",
            PoreWater::WithSoil => "water that moves with the soil",
        };
        text += &paragraph(&format!("By {}; {moves}.", formula_of_increment(fill)), 2);
    }
    text
}
