//! Soil beside the body: from its friction to its pressure, point by point.

use standfast::Plan;
use standfast::loads::earth::{EarthPoint, EarthState, PoreWater, SoilLayer, SoilStretch, sums};
use standfast::loads::{Face, Load, LoadSource};
use standfast_cases::assess::soil::{formula, formula_of_increment, side};
use standfast_cases::case::{Made, SoilFill, soil_of};
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case};

use crate::measured::{DEGREE, DENSITY, KILONEWTON, KILOPASCAL, METRE, MOMENT, NONE, UNIT_WEIGHT};
use crate::steps::SheetSteps;
use crate::symbols::{numbered, of_soil};

/// The soils of a case at rest of the ground.
pub(super) fn steps(steps: &mut SheetSteps, case: &Case) {
    for index in 0..case.soils.len() {
        one(steps, case, index);
    }
}

/// A soil of a case, with the symbols of its quantities.
struct SoilSymbols<'a> {
    fill: &'a SoilFill,
    index: usize,
    count: usize,
}

impl SoilSymbols<'_> {
    fn of(case: &Case, index: usize) -> SoilSymbols<'_> {
        SoilSymbols { fill: &case.soils[index], index, count: case.soils.len() }
    }

    /// A symbol of the soil.
    fn own(&self, symbol: &str) -> String {
        numbered(symbol, self.index, self.count)
    }

    /// A symbol of one of several places of it.
    fn at(&self, symbol: &str, place: usize) -> String {
        of_soil(symbol, self.index, self.count, place)
    }

    /// A symbol of a layer.
    fn of_layer(&self, symbol: &str, layer: usize) -> String {
        if self.fill.soil.layers.len() == 1 { self.own(symbol) } else { self.at(symbol, layer) }
    }

    /// The angle that a pressure has to the level, as a formula.
    fn angle(&self, layer: usize) -> String {
        let δ = self.of_layer("δ_e", layer);
        if self.fill.soil.batter_deg == 0.0 { δ } else { format!("{} + {δ}", self.own("θ_e")) }
    }
}

fn one(steps: &mut SheetSteps, case: &Case, index: usize) {
    let symbols = SoilSymbols::of(case, index);
    let SoilFill { soil, water, pressure, name, .. } = symbols.fill;
    steps.heading(&format!("Soil: {}, at the {}", name.replace('`', "'"), side(soil.face)));
    steps.know(&symbols.own("H_e"), soil.top, METRE);
    steps.know(&symbols.own("β_e"), soil.slope_deg, DEGREE);
    steps.know(&symbols.own("θ_e"), soil.batter_deg, DEGREE);
    steps.know(&symbols.own("q_e"), soil.surcharge, KILOPASCAL);
    for (layer, SoilLayer { soil: of, .. }) in soil.layers.iter().enumerate() {
        let of_layer = |symbol: &str| symbols.of_layer(symbol, layer);
        steps.know(&of_layer("φ_e"), of.friction_angle_deg, DEGREE);
        steps.know(&of_layer("δ_e"), of.wall_friction_deg, DEGREE);
        steps.know(&of_layer("γ_e"), of.unit_weight, UNIT_WEIGHT);
        steps.know(&of_layer("γ_sat"), of.unit_weight_saturated.unwrap_or(of.unit_weight), UNIT_WEIGHT);
        steps.know(&of_layer("c_e"), of.cohesion, KILOPASCAL);
        steps.know(&of_layer("a_e"), of.adhesion, KILOPASCAL);
        steps.know(&of_layer("OCR"), of.ocr, NONE);
        let coefficients = pressure.coefficients[layer];
        let about = match soil.layers.len() {
            1 => "Coefficient of its pressure".to_owned(),
            _ => format!("Layer {} from the top: coefficient of its pressure", layer + 1),
        };
        let k = of_layer("K_e");
        steps.add(
            &about,
            formula(symbols.fill),
            [&k, &coefficient(&symbols, layer, None)],
            coefficients.k,
            NONE,
            "",
        );
        if of.cohesion > 0.0 && soil.state == EarthState::Active {
            let (c, a) = (of_layer("c_e"), of_layer("a_e"));
            let formula = format!("min(2 sqrt({k} (1 + {a}/{c})), 2.56 sqrt({k}))");
            let about = "The same of its cohesion";
            steps.add(about, "EN 1997-1, annex C", [&of_layer("K_c"), &formula], coefficients.k_c, NONE, "");
        }
        if of.cohesion > 0.0 && soil.state == EarthState::Passive {
            let about = "The same of its cohesion, which adds to the pressure";
            let formula = format!("−2 sqrt({k})");
            steps.add(about, "Rankine", [&of_layer("K_c"), &formula], coefficients.k_c, NONE, "");
        }
    }
    if let Some(water) = water.filter(|water| water.level > 0.0) {
        match &case.water {
            Some(of) => {
                steps.know("ρ_w", of.density(), DENSITY);
                steps.add(
                    "Unit weight of the water",
                    "",
                    ["γ_w", "ρ_w g"],
                    water.unit_weight,
                    UNIT_WEIGHT,
                    "",
                );
            }
            None => steps.told("Unit weight of the water", "γ_w", water.unit_weight, UNIT_WEIGHT, "ρ g", ""),
        }
    }
    let stretches = stresses(steps, &symbols);
    points(steps, &symbols, &stretches);
    if !pressure.surcharge.is_empty() {
        surcharge(steps, &symbols, &stretches);
    }
}

/// K of a layer as a formula; in an earthquake with the angle of that name.
fn coefficient(symbols: &SoilSymbols<'_>, layer: usize, turned: Option<&str>) -> String {
    let soil = &symbols.fill.soil;
    let of_layer = |symbol: &str| symbols.of_layer(symbol, layer);
    let (φ, δ) = (of_layer("φ_e"), of_layer("δ_e"));
    let has = |angle: f64, name: &str| if angle == 0.0 { None } else { Some(symbols.own(name)) };
    let (β, θ) = (has(soil.slope_deg, "β_e"), has(soil.batter_deg, "θ_e"));
    if soil.state == EarthState::Passive {
        let of_rankine = format!("((1 + sin({φ}))/(1 − sin({φ})))");
        return match soil.layers[layer].soil.wall_friction_deg {
            0.0 => of_rankine,
            _ => format!("{of_rankine}^(1 + 1.443 {δ}/{φ} sin({φ}))"),
        };
    }
    if soil.state == EarthState::AtRest {
        let slope = β.map_or(String::new(), |β| format!(" (1 + sin({β}))"));
        return format!("(1 − sin({φ})) {}^(sin({φ})){slope}", of_layer("OCR"));
    }
    let less = |angle: &str, others: &[Option<String>]| {
        others.iter().flatten().fold(angle.to_owned(), |sum, other| format!("{sum} − {other}"))
    };
    let ψ = turned.map(str::to_owned);
    let inclined =
        [θ.clone(), Some(δ.clone()), ψ.clone()].into_iter().flatten().collect::<Vec<_>>().join(" + ");
    let above = format!("cos({})^2", less(&φ, &[θ.clone(), ψ.clone()]));
    let steep = less(&φ, &[β.clone(), ψ.clone()]);
    let ground = match (&θ, &β) {
        (None, None) => String::new(),
        (Some(θ), Some(β)) => format!(" cos({θ} − {β})"),
        (Some(one), None) | (None, Some(one)) => format!(" cos({one})"),
    };
    let root = format!("sqrt(sin({φ} + {δ}) sin({steep})/(cos({inclined}){ground}))");
    let turned = ψ.map_or(String::new(), |ψ| format!("cos({ψ}) "));
    let leans = θ.map_or(String::new(), |θ| format!("cos({θ})^2 "));
    format!("{above}/({turned}{leans}cos({inclined}) (1 + {root})^2)")
}

/// A stretch with the symbols of the elevations and stresses at its ends, the upper first; no stress at the ground.
struct NamedStretch<'a> {
    stretch: SoilStretch<'a>,
    elevations: [String; 2],
    stresses: [Option<String>; 2],
}

/// Effective stresses from the top down.
fn stresses<'a>(steps: &mut SheetSteps, symbols: &'a SoilSymbols<'_>) -> Vec<NamedStretch<'a>> {
    let SoilFill { soil, water, .. } = symbols.fill;
    let mut named: Vec<NamedStretch<'a>> = Vec::new();
    let mut upper = (symbols.own("H_e"), None);
    for (place, stretch) in soil.stretches(*water).into_iter().enumerate() {
        let SoilStretch { layer, ends, stress, wet, .. } = stretch;
        let elevation = symbols.at("y_e", place);
        steps.know(&elevation, ends[1], METRE);
        let name = symbols.at("σ_e", place);
        let weight = match wet {
            true => format!("({} − γ_w)", symbols.of_layer("γ_sat", layer)),
            false => symbols.of_layer("γ_e", layer),
        };
        let before = upper.1.as_ref().map_or(String::new(), |stress| format!("{stress} + "));
        let formula = format!("{before}{weight} ({} − {elevation})", upper.0);
        let about = if place == 0 { "Effective stress in the soil, downwards" } else { "" };
        steps.add(about, "", [&name, &formula], stress[1], KILOPASCAL, "");
        let elevations = [upper.0, elevation.clone()];
        named.push(NamedStretch { stretch, elevations, stresses: [upper.1, Some(name.clone())] });
        upper = (elevation, Some(name));
    }
    named
}

/// The stretch that each point of a diagram belongs to, from the base up.
fn stretch_of(points: &[EarthPoint], stretches: &[NamedStretch<'_>]) -> Vec<usize> {
    let mut at = stretches.len().saturating_sub(1);
    let mut places = Vec::new();
    for (place, point) in points.iter().enumerate() {
        let is_step = place > 0 && points[place - 1].elevation == point.elevation;
        // Above the upper end of a stretch, or on it once more, the next one begins.
        while at > 0
            && (point.elevation > stretches[at].stretch.ends[0]
                || is_step && point.elevation == stretches[at].stretch.ends[0])
        {
            at -= 1;
        }
        places.push(at);
    }
    places
}

/// The pressure of the soil, from the base up: against the upright, and down the body.
fn points(steps: &mut SheetSteps, symbols: &SoilSymbols<'_>, stretches: &[NamedStretch<'_>]) {
    let SoilFill { soil, pressure, .. } = symbols.fill;
    steps.note(
        "Pressures of the soil against the upright, and down the body per metre of its height, from the base up; linear between.",
    );
    let places = stretch_of(&pressure.soil, stretches);
    for (place, (point, at)) in pressure.soil.iter().zip(places).enumerate() {
        let NamedStretch { stretch, elevations, stresses } = &stretches[at];
        let layer = stretch.layer;
        let (z, p, t) = (symbols.at("z_e", place), symbols.at("p_e", place), symbols.at("t_e", place));
        elevation(steps, stretch, point, &z);
        let end = stretch.ends.iter().position(|end| *end == point.elevation);
        let held = soil.layers[layer].soil.cohesion * pressure.coefficients[layer].k_c;
        let at = end.map_or_else(|| z.clone(), |end| elevations[end].clone());
        let about = format!("`{at}` above the base");
        let angle = symbols.angle(layer);
        match end.and_then(|end| stresses[end].as_ref()).filter(|_| point.normal != 0.0) {
            Some(stress) => {
                let k = symbols.of_layer("K_e", layer);
                let less = match held {
                    0.0 => format!("{k} {stress}"),
                    _ => format!(
                        "({k} {stress} − {} {})",
                        symbols.of_layer("c_e", layer),
                        symbols.of_layer("K_c", layer)
                    ),
                };
                steps.add(&about, "", [&p, &format!("{less} cos({angle})")], point.normal, KILOPASCAL, "");
                if point.tangential != 0.0 {
                    let formula = format!("{p} tan({angle})");
                    steps.add("", "", [&t, &formula], point.tangential, KILOPASCAL, "");
                } else {
                    steps.know(&t, 0.0, KILOPASCAL);
                }
            }
            None => {
                let words = if stretch.stress[0] == 0.0 && end == Some(0) {
                    "at the ground"
                } else {
                    "cohesion holds the soil"
                };
                steps.told(&about, &p, point.normal, KILOPASCAL, words, "");
                steps.know(&t, point.tangential, KILOPASCAL);
            }
        }
    }
}

/// The elevation of a point, which is told where it lies within a stretch.
fn elevation(steps: &mut SheetSteps, stretch: &SoilStretch<'_>, point: &EarthPoint, name: &str) {
    if stretch.ends.contains(&point.elevation) {
        return steps.know(name, point.elevation, METRE);
    }
    let words = "up to there cohesion holds the soil";
    steps.told("Where its pressure begins", name, point.elevation, METRE, words, "");
}

/// What a surcharge adds at each point.
fn surcharge(steps: &mut SheetSteps, symbols: &SoilSymbols<'_>, stretches: &[NamedStretch<'_>]) {
    let SoilFill { soil, pressure, .. } = symbols.fill;
    let q = symbols.own("q_e");
    let (β, θ) = (symbols.own("β_e"), symbols.own("θ_e"));
    let weighed = match soil.state {
        EarthState::Active if soil.slope_deg != 0.0 || soil.batter_deg != 0.0 => {
            let name = symbols.own("q_w");
            let formula = format!("{q} cos({θ}) cos({β})/cos({θ} − {β})");
            let about = "Surcharge as the wedge of soil has it";
            steps.add(about, "", [&name, &formula], soil.weighed_surcharge(), KILOPASCAL, "");
            name
        }
        _ => q,
    };
    let with_cohesion = soil.layers.iter().any(|layer| layer.soil.cohesion > 0.0);
    let places = stretch_of(&pressure.surcharge, stretches);
    for (place, (point, at)) in pressure.surcharge.iter().zip(places).enumerate() {
        let stretch = &stretches[at].stretch;
        let layer = stretch.layer;
        let (z, p, t) = (symbols.at("z_q", place), symbols.at("p_q", place), symbols.at("t_q", place));
        elevation(steps, stretch, point, &z);
        let about = if place == 0 { "What the surcharge adds, from the base up" } else { "" };
        let angle = symbols.angle(layer);
        let whole = pressure.coefficients[layer].k * soil.weighed_surcharge() * {
            (soil.batter_deg + soil.layers[layer].soil.wall_friction_deg).to_radians().cos()
        };
        if with_cohesion && (point.normal - whole).abs() > 1e-9 * whole {
            steps.told(about, &p, point.normal, KILOPASCAL, "what cohesion leaves of it", "");
        } else {
            let formula = format!("{} {weighed} cos({angle})", symbols.of_layer("K_e", layer));
            steps.add(about, "", [&p, &formula], point.normal, KILOPASCAL, "");
        }
        match point.tangential != 0.0 {
            true => steps.add("", "", [&t, &format!("{p} tan({angle})")], point.tangential, KILOPASCAL, ""),
            false => steps.know(&t, 0.0, KILOPASCAL),
        }
    }
}

/// What the acceleration of a situation adds to each soil that it drives against the body.
pub(super) fn increments(steps: &mut SheetSteps, case: &Case, assessed: &Assessed) {
    let Some(earthquake) = &assessed.earthquake else { return };
    for index in 0..case.soils.len() {
        let symbols = SoilSymbols::of(case, index);
        let SoilFill { soil, pressure, name, .. } = symbols.fill;
        let Some(increment) = symbols.fill.increment(earthquake, case.gravity) else { continue };
        steps.heading(&format!("Soil in the earthquake: {}", name.replace('`', "'")));
        let [k_h, k_v] = [earthquake.horizontal().abs(), earthquake.vertical()].map(|a| a / case.gravity);
        steps.told("Shares of gravity, k_h", "k_h", k_h, NONE, "|a_h|/g", "");
        steps.told("and 1 − k_v", "k_g", 1.0 + k_v, NONE, "1 + a_v/g", "");
        let source = formula_of_increment(symbols.fill);
        for (layer, both) in increment.coefficients.iter().enumerate() {
            for (wet, found) in both.iter().enumerate() {
                let Some([k, ψ]) = found else { continue };
                let place = 2 * layer + wet;
                let (angle, name) = (symbols.at("ψ_E", place), symbols.at("K_E", place));
                let words = match (wet, soil.pore_water) {
                    (0, _) => "arctan(k_h/(1 − k_v)), above water",
                    (_, PoreWater::Free) => "arctan(γ_dry k_h/((γ_sat − γ_w)(1 − k_v))), below water",
                    _ => "arctan(γ_sat k_h/((γ_sat − γ_w)(1 − k_v))), below water",
                };
                steps.told("Angle by which gravity is turned", &angle, *ψ, DEGREE, words, "");
                let formula = coefficient(&symbols, layer, Some(&angle));
                steps.add("Coefficient of the pressure with it", source, [&name, &formula], *k, NONE, "");
            }
        }
        let (force, drag) = (symbols.own("ΔP_e"), symbols.own("ΔT_e"));
        let about = "What it adds, against the upright";
        match soil.state {
            // What resists stays what it is.
            EarthState::Passive => return,
            EarthState::AtRest => {
                let words = "k_h γ H², γ the mean over the height, saturated below water";
                steps.told(about, &force, increment.force, KILONEWTON, words, "");
                steps.know(&drag, 0.0, KILONEWTON);
            }
            EarthState::Active => {
                let still = [&pressure.soil, &pressure.surcharge];
                for (letter, whole, part, of, sine) in [
                    ("P", increment.force, "p", (|point| point.normal) as fn(&EarthPoint) -> f64, "cos"),
                    ("T", increment.drag, "t", |point| point.tangential, "sin"),
                ] {
                    if letter == "T" && whole == 0.0 {
                        steps.know(&drag, 0.0, KILONEWTON);
                        continue;
                    }
                    let name = |of: &str| symbols.own(&format!("{letter}_{of}"));
                    let (shaken, at_rest) = (name("E"), name("S"));
                    let before: f64 = still.iter().map(|points| sums(points, of)[0]).sum();
                    let about = if letter == "P" { "Pressure with it" } else { "The same down the body" };
                    steps.add(
                        about,
                        source,
                        [&shaken, &shaken_sum(&symbols, sine)],
                        whole + before,
                        KILONEWTON,
                        "",
                    );
                    let terms = [
                        strips(&symbols, &pressure.soil, &format!("{part}_e"), "z_e", of),
                        strips(&symbols, &pressure.surcharge, &format!("{part}_q"), "z_q", of),
                    ];
                    let terms: Vec<String> = terms.into_iter().flatten().map(|[sum, _]| sum).collect();
                    steps.add("Without it", "", [&at_rest, &terms.join(" + ")], before, KILONEWTON, "");
                    let (about, name) = if letter == "P" {
                        ("What it adds, against the upright", &force)
                    } else {
                        ("Down the body", &drag)
                    };
                    steps.add(about, "", [name, &format!("{shaken} − {at_rest}")], whole, KILONEWTON, "");
                }
            }
        }
        steps.know(
            &symbols.own("η_e"),
            if soil.state == EarthState::AtRest { 0.6 } else { soil.increment_at },
            NONE,
        );
        let (η, h) = (symbols.own("η_e"), symbols.own("H_e"));
        for (place, share) in [format!("(4 − 6 {η})"), format!("(6 {η} − 2)")].into_iter().enumerate() {
            let point = increment.points[place];
            let (z, p, t) = (symbols.at("z_E", place), symbols.at("p_E", place), symbols.at("t_E", place));
            steps.know(&z, point.elevation, METRE);
            let about = ["Its straight diagram, at the foot", "at the ground"][place];
            steps.add(about, "", [&p, &format!("{force} {share}/{h}")], point.normal, KILOPASCAL, "");
            match point.tangential != 0.0 {
                true => {
                    steps.add("", "", [&t, &format!("{drag} {share}/{h}")], point.tangential, KILOPASCAL, "")
                }
                false => steps.know(&t, 0.0, KILOPASCAL),
            }
        }
        if let Some([force, elevation]) = increment.pore_water {
            let words = "7/12 k_h γ_w H_w²";
            steps.told(
                "Free water in the soil presses with",
                &symbols.own("P_pw"),
                force,
                KILONEWTON,
                words,
                "",
            );
            steps.told("at", &symbols.own("z_pw"), elevation, METRE, "0.4 H_w", "");
        }
    }
}

/// The strips of a pressure whose points have these symbols, as formulas: each with its moment about the base.
fn strips(
    symbols: &SoilSymbols<'_>,
    points: &[EarthPoint],
    value: &str,
    height: &str,
    of: fn(&EarthPoint) -> f64,
) -> Vec<[String; 2]> {
    let mut strips = Vec::new();
    for (place, pair) in points.windows(2).enumerate() {
        if pair[0].elevation == pair[1].elevation || (of(&pair[0]), of(&pair[1])) == (0.0, 0.0) {
            continue;
        }
        let [z1, z2] = [place, place + 1].map(|place| symbols.at(height, place));
        let [q1, q2] = [place, place + 1].map(|place| symbols.at(value, place));
        let moment = format!("({z2} − {z1})/6 ({q1} (2 {z1} + {z2}) + {q2} ({z1} + 2 {z2}))");
        strips.push([format!("({q1} + {q2})/2 ({z2} − {z1})"), moment]);
    }
    strips
}

/// The pressure with an earthquake over all stretches, as a formula.
fn shaken_sum(symbols: &SoilSymbols<'_>, sine: &str) -> String {
    let soil = &symbols.fill.soil;
    let q = match (soil.surcharge, soil.slope_deg == 0.0 && soil.batter_deg == 0.0) {
        (0.0, _) => String::new(),
        (_, true) => format!(" + {}", symbols.own("q_e")),
        (_, false) => format!(" + {}", symbols.own("q_w")),
    };
    let mut upper = (symbols.own("H_e"), None);
    let mut terms = Vec::new();
    for (place, stretch) in soil.stretches(symbols.fill.water).into_iter().enumerate() {
        let (elevation, stress) = (symbols.at("y_e", place), symbols.at("σ_e", place));
        let k = symbols.at("K_E", 2 * stretch.layer + usize::from(stretch.wet));
        let before = upper.1.map_or(String::new(), |before: String| format!("{before} + "));
        let angle = symbols.angle(stretch.layer);
        terms.push(format!("{k} k_g (({before}{stress})/2{q}) ({} − {elevation}) {sine}({angle})", upper.0));
        upper = (elevation, Some(stress));
    }
    terms.join(" + ")
}

/// A load of a soil: its sum along the face, and its moment about the base; `None` of another load.
pub(super) fn load(
    steps: &mut SheetSteps,
    case: &Case,
    assessed: &Assessed,
    name: &str,
    [sum_name, lever_name]: &[String; 2],
    load: &Load,
) -> bool {
    let Some((index, made)) = made_by(case, load) else { return false };
    let symbols = SoilSymbols::of(case, index);
    let is_drag = load.source == LoadSource::EarthDrag;
    let increment =
        assessed.earthquake.as_ref().and_then(|shaken| symbols.fill.increment(shaken, case.gravity));
    let (points, letter) = match made {
        None => (symbols.fill.pressure.soil.clone(), "e"),
        Some(Made::Surcharge) => (symbols.fill.pressure.surcharge.clone(), "q"),
        Some(Made::Earthquake) => (increment.map(|increment| increment.points).unwrap_or_default(), "E"),
    };
    let along = case.body.plan().side(case.body.width());
    let (value, of): (_, fn(&EarthPoint) -> f64) =
        if is_drag { ("t", |point| point.tangential) } else { ("p", |point| point.normal) };
    let [sum, lever] = sums(&points, of);
    let strips = strips(&symbols, &points, &format!("{value}_{letter}"), &format!("z_{letter}"), of);
    let (of_sum, of_lever): (Vec<String>, Vec<String>) =
        strips.into_iter().map(|[sum, lever]| (sum, lever)).unzip();
    let times = match (case.body.plan(), case.extent) {
        (Plan::Circle, _) => " w",
        (_, Extent::Whole) => " L_b",
        _ => "",
    };
    let whole = |terms: &[String]| match times {
        "" => terms.join(" + "),
        times => format!("({}){times}", terms.join(" + ")),
    };
    let about = format!("{name}: sum along the face");
    steps.add(&about, "", [sum_name, &whole(&of_sum)], sum * along, KILONEWTON, "");
    let about = "Its moment about the base";
    steps.add(about, "", [lever_name, &whole(&of_lever)], lever * along, MOMENT, "");
    true
}

/// X, V and M of a load of a soil as formulas; `None` of another load.
pub(super) fn formulas(
    case: &Case,
    load: &Load,
    [x, v]: [&str; 2],
    [sum, lever]: &[String; 2],
    factor: &str,
) -> Option<[Option<String>; 3]> {
    if load.source == LoadSource::PoreWater {
        let index = case.soils.iter().position(|fill| load.name == Some(fill.pore_water()))?;
        let symbols = SoilSymbols::of(case, index);
        let (force, elevation) = (symbols.own("P_pw"), symbols.own("z_pw"));
        let long = if case.extent == Extent::Whole { " L_b" } else { "" };
        let sign = if symbols.fill.soil.face == Face::Left { "" } else { "−" };
        return Some([
            Some(format!("{sign}{factor}{force}{long}")),
            None,
            Some(format!("−{x} ({elevation} − y_C)")),
        ]);
    }
    let (index, _) = made_by(case, load)?;
    let symbols = SoilSymbols::of(case, index);
    let soil = &symbols.fill.soil;
    let left = soil.face == Face::Left;
    Some(match load.source {
        LoadSource::EarthDrag => {
            // At the face, which leans towards the body.
            let lean = match soil.batter_deg {
                0.0 => String::new(),
                _ => format!("{factor}{lever} tan({})", symbols.own("θ_e")),
            };
            let moment = match (left, lean.is_empty()) {
                (true, true) => format!("{v} b_1"),
                (true, false) => format!("{v} b_1 − {lean}"),
                (false, true) => format!("−{v} b_2"),
                (false, false) => format!("{lean} − {v} b_2"),
            };
            [None, Some(format!("{factor}{sum}")), Some(moment)]
        }
        _ if left => [Some(format!("{factor}{sum}")), None, Some(format!("{x} y_C − {factor}{lever}"))],
        _ => [Some(format!("−{factor}{sum}")), None, Some(format!("{factor}{lever} + {x} y_C"))],
    })
}

/// The soil that a load is of, by its place, and what of it.
fn made_by(case: &Case, load: &Load) -> Option<(usize, Option<Made>)> {
    let (name, made) = soil_of(load)?;
    Some((case.soils.iter().position(|fill| fill.name == name)?, made))
}
