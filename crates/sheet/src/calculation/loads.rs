//! Each load as a wrench at the centre of mass, and their sum.

use maud::{Markup, html};
use standfast::loads::{Action, Earthquake, Face, Load, LoadSource, PressureAt, PressureDiagram};
use standfast::{Body, Plan, Wrench};
use standfast_cases::assess::{Component, left_out, share};
use standfast_cases::case::{FacePressure, WaveFormula, Weight, said_by};
use standfast_cases::key::Table;
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case, Key, Place};

use super::{opening, soil};
use crate::measured::{
    ACCELERATION, AREA, DENSITY, KILONEWTON, KILOPASCAL, MASS, METRE, MOMENT, Measured, NONE,
};
use crate::steps::{SheetStep, SheetSteps};
use crate::symbols::{numbered, point};
use crate::together::Brief;

/// The symbols of a component's parts: X, V and M with its number.
pub(super) fn parts(index: usize) -> [String; 3] {
    ["X", "V", "M"].map(|letter| format!("{letter}_{}", index + 1))
}

/// The sum of symbols as a formula, each where its value is not zero; `None` if all are.
pub(super) fn sum<'a>(components: impl Iterator<Item = (String, f64)> + 'a) -> Option<String> {
    let names: Vec<_> = components.filter(|(_, value)| *value != 0.0).map(|(name, _)| name).collect();
    (!names.is_empty()).then(|| names.join(" + "))
}

/// A sum of terms, each added or taken away; empty without any.
pub(super) fn signed(terms: impl IntoIterator<Item = (bool, String)>) -> String {
    terms.into_iter().fold(String::new(), |sum, (plus, term)| {
        let sign = match (sum.is_empty(), plus) {
            (true, true) => "",
            (true, false) => "−",
            (false, true) => " + ",
            (false, false) => " − ",
        };
        sum + sign + &term
    })
}

/// A formula as a factor: in parentheses if it is a sum.
pub(super) fn grouped(formula: &str) -> String {
    if formula.contains(' ') { format!("({formula})") } else { formula.to_owned() }
}

pub(super) fn steps(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, components: &[Component]) {
    steps.heading("Loads, at the centre of mass");
    steps.note(match case.floor_deg {
        0.0 => "`X` to the right, `V` downwards, `M` counter-clockwise about the centre of mass C. `V` is the net vertical force.",
        _ => {
            "`X` along the base to the right, `V` onto it, `M` counter-clockwise about the centre of mass C. Weight, forces and inertia keep \
             their directions in space; a level force without a distance acts at mid-width."
        }
    });
    added_mass(steps, case);
    for (i, component) in components.iter().enumerate() {
        one(steps, case, assessed, i, component);
    }
    let total = &assessed.outcome.full.wrench;
    let of = |part: fn(&Wrench) -> f64, which: usize| {
        sum(components
            .iter()
            .enumerate()
            .map(|(i, component)| (parts(i)[which].clone(), part(&component.wrench))))
    };
    let sums = [
        ("X", "to the right", total.x, KILONEWTON, of(|wrench| wrench.x, 0)),
        ("V", "downwards", total.p, KILONEWTON, of(|wrench| wrench.p, 1)),
        ("M", "moment at C", total.m, MOMENT, of(|wrench| wrench.m, 2)),
    ];
    table(steps, components, total);
    for (name, words, value, unit, formula) in sums {
        let about = format!("Sum under the full load, {words}");
        match formula {
            Some(formula) => steps.add(&about, "", [name, &formula], value, unit, ""),
            None => steps.told(&about, name, value, unit, "no load has such a part", ""),
        }
    }
    opening::steps(steps, assessed, components);
    for note in left_out(case) {
        steps.note(note);
    }
}

/// The loads one by one, in a table.
fn table(steps: &mut SheetSteps, components: &[Component], total: &Wrench) {
    let [force, moment] = [KILONEWTON, MOMENT].map(|unit| steps.measured(0.0, unit).unit.text);
    let full = html! {
        table.numbers data-table="components" {
            thead { tr { th { "Load" } th { "Share" } th.n { "X" br; (force) } th.n { "V" br; (force) } th.n { "M" br; (moment) } } }
            tbody {
                @for (i, Component { name, load, wrench }) in components.iter().enumerate() {
                    tr {
                        td { (i + 1) " " (name) }
                        td { (share(load)) }
                        (cells(steps, wrench))
                    }
                }
                tr.sum { td { "Sum" } td {} (cells(steps, total)) }
            }
        }
    };
    // Where situations stand together the steps of each load are rows.
    steps.push(full, Brief::Nothing);
}

fn cells(steps: &SheetSteps, wrench: &Wrench) -> Markup {
    html! {
        @for (value, unit) in [(wrench.x, KILONEWTON), (wrench.p, KILONEWTON), (wrench.m, MOMENT)] {
            td.n { (steps.measured(value, unit).number_html("")) }
        }
    }
}

fn added_mass(steps: &mut SheetSteps, case: &Case) {
    let (mass, height) = (case.added_mass.mass(), case.added_mass.height());
    if mass == 0.0 {
        return;
    }
    let from_water = match (&case.water, &case.wave) {
        (Some(water), _) => Some((water.density(), water.right(), water.left())),
        (None, Some(wave)) => wave.still_water().map(|level| (wave.water_density, level, level)),
        (None, None) => None,
    };
    let (Some(height), Some((density, right, left))) = (height, from_water) else {
        steps.told("Added mass of water", "m_a", mass, MASS, "as given in the case file", "added_mass");
        return;
    };
    steps.know("ρ_w", density, DENSITY);
    steps.know("h_r", right, METRE);
    steps.know("h_l", left, METRE);
    let of =
        |depth| standfast::wave::added_mass(1, density * case.body.plan().side(case.body.width()), depth);
    let one_side = [("h_r", right), ("h_l", left)].into_iter().find(|(_, depth)| of(*depth) == mass);
    // ζ(3) to the digits of a double; the coefficient is 0.54275.
    let coefficient = "14 1.2020569031595942/π^3 ρ_w";
    let long = along(&case.body, case.extent).side;
    let formula = match one_side {
        Some((depth, _)) => format!("{coefficient} {depth}^2{long}"),
        None => format!("{coefficient} (h_r^2 + h_l^2){long}"),
    };
    let about = "Added mass of water, 14ζ(3)/π³ `ρ_w h^2` a side";
    steps.add(about, "Westergaard's problem", ["m_a", &formula], mass, MASS, "added_mass");
    let depths = one_side.map_or("(h_r^3 + h_l^3)/(h_r^2 + h_l^2)", |(depth, _)| depth);
    // β(4) is Dirichlet's; the coefficient is 0.40142.
    let formula = format!("(1 − 16 0.9889445517411053/(7 π 1.2020569031595942)) {depths}");
    let about =
        "Height above the base at which it presses on a shaken wall, 1 − 16β(4)/(7πζ(3)) of the depth";
    steps.add(about, "same potential", ["z_a", &formula], height, METRE, "");
}

/// True if a factor stands in the formulas of its load: where it is not 1, and among combinations, so that their formulas are the same.
pub(super) fn shows_factor(case: &Case, factor: f64) -> bool {
    factor != 1.0 || case.combinations.len() > 1
}

/// The wrench of one load.
fn one(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, i: usize, component: &Component) {
    let Component { name, wrench, .. } = component;
    let [x, v, m] = parts(i);
    // Backticks would begin a formula.
    let mut about = format!("{}  {}", i + 1, name.replace('`', "'"));
    steps.subject(&about);
    given(steps, case, &component.load);
    // A factor of the combination stands before what it multiplies.
    let name_of_factor = format!("γ_F{}", i + 1);
    let factor = match shows_factor(case, component.load.factor) {
        true => format!("{name_of_factor} "),
        false => String::new(),
    };
    steps.know(&name_of_factor, component.load.factor, NONE);
    if opening::is_followed(assessed, component) {
        let words = "of the water that stands under a base that opens; see below";
        steps.told(&about, &v, wrench.p, KILONEWTON, words, "");
        return steps.told("", &m, wrench.m, MOMENT, "the same", "");
    }
    let sums = ["Q", "S"].map(|letter| format!("{letter}_{}", i + 1));
    if let Action::Pressure { face, diagram } = &component.load.action
        && component.load.source == LoadSource::Pressure
    {
        pressure(steps, case, &about, &sums, (&component.load, *face, diagram));
        about.clear();
    }
    if soil::load(steps, case, assessed, &about, &sums, &component.load) {
        about.clear();
    }
    let long = along(&case.body, case.extent);
    let of_soil = soil::formulas(case, &component.load, [&x, &v], &sums, &factor);
    let [fx, fv, fm] =
        of_soil.unwrap_or_else(|| formulas(case, assessed, component, [&x, &v], &sums, &factor, &long));
    let mut about = about.as_str();
    let parts = [(x, fx, wrench.x, KILONEWTON), (v, fv, wrench.p, KILONEWTON), (m, fm, wrench.m, MOMENT)];
    for (name, formula, value, unit) in parts {
        match formula {
            // A moment that is zero because the load acts at C needs no line.
            Some(formula) if value != 0.0 || unit != MOMENT => {
                let result = Measured::of(value, unit);
                steps.step(&SheetStep {
                    about,
                    reference: "",
                    name: &name,
                    formula: &formula,
                    result,
                    key: "",
                });
                about = "";
            }
            _ => steps.know(&name, value, unit),
        }
    }
}

/// The numbers that the formulas of a load's parts need.
fn given(steps: &mut SheetSteps, case: &Case, load: &Load) {
    match load.source {
        LoadSource::Buoyancy | LoadSource::StillWater => {
            if let Weight::Buoyant { force, arm } = case.weight {
                steps.know("W_g", force, KILONEWTON);
                steps.know("t_g", arm, METRE);
            }
            if let Some(water) = &case.water {
                steps.know("h_l", water.left(), METRE);
                steps.know("h_r", water.right(), METRE);
                steps.know("ρ_w", water.density(), DENSITY);
            }
        }
        LoadSource::WaterOnLeft | LoadSource::WaterOnRight => {
            if let (Some(water), Action::Force { at, up, .. }) = (&case.water, &load.action) {
                let unit_weight = water.density() * case.gravity * case.body.plan().side(case.body.width());
                let [area, place] = water_symbols(load);
                let words = "between the outline of the parts and the upright through the corner of the base";
                let about = if *up > 0.0 {
                    "Area of the overhang under water"
                } else {
                    "Area of the water on the side"
                };
                steps.told(about, area, up.abs() / unit_weight, AREA, words, "");
                let arm = at.x + case.body.base_edges().left;
                steps.told("Its centre, to the right of O", place, arm, METRE, "of that area", "");
                steps.know("ρ_w", water.density(), DENSITY);
            }
        }
        LoadSource::Uplift => {
            if let Some(uplift) = &case.uplift {
                steps.know("p_l", uplift.left(), KILOPASCAL);
                steps.know("p_r", uplift.right(), KILOPASCAL);
            }
        }
        LoadSource::HorizontalInertia | LoadSource::VerticalInertia | LoadSource::ShakenWater => {
            if let Some(earthquake) = &case.earthquake {
                steps.know("a_h", earthquake.horizontal(), ACCELERATION);
                steps.know("a_v", earthquake.vertical(), ACCELERATION);
            }
        }
        LoadSource::Couple => {
            let size = case_couple(load).abs();
            steps.know_input(&couple_symbol(case, load), size, MOMENT);
        }
        LoadSource::Force => {
            if let Action::Force { at, right, up } = load.action {
                let [force, elevation, distance] = force_symbols(case, load);
                // Of one component alone on a level floor, whose size is that of the force.
                steps.know_input(&force, right.hypot(up), KILONEWTON);
                steps.know_input(&elevation, at.y, METRE);
                steps.know_input(&distance, at.x + case.body.base_edges().left, METRE);
            }
        }
        _ => {}
    }
}

/// The symbols of the area of water on a side, or of an overhang, and of its centre.
fn water_symbols(load: &Load) -> [&'static str; 2] {
    let lifts = matches!(load.action, Action::Force { up, .. } if up > 0.0);
    match (load.source, lifts) {
        (LoadSource::WaterOnLeft, false) => ["A_wl", "x_wl"],
        (LoadSource::WaterOnLeft, true) => ["A_ol", "x_ol"],
        (_, false) => ["A_wr", "x_wr"],
        (_, true) => ["A_or", "x_or"],
    }
}

/// Factor of a pressure for the body's extent out of the plane.
struct PlanFactor {
    /// Behind the formula of a pressure on a side, or on a rectangular base.
    side: &'static str,
    /// True if the base is a circle.
    circle: bool,
}

fn along(body: &Body, extent: Extent) -> PlanFactor {
    match (body.plan(), extent) {
        (Plan::Circle, _) => PlanFactor { side: " w", circle: true },
        (_, Extent::Whole) => PlanFactor { side: " L_b", circle: false },
        (_, Extent::PerMetre) => PlanFactor { side: "", circle: false },
    }
}

/// The symbols of a force, its elevation and its distance from O.
pub(super) fn force_symbols(case: &Case, load: &Load) -> [String; 3] {
    let Place::Table(_, index) = said_by(load.id) else { return Default::default() };
    let count = case.inputs().count(Table::Load);
    [Key::Force, Key::Elevation, Key::LoadDistance].map(|key| numbered(key.info().symbol, index, count))
}

/// The moment of a couple, counter-clockwise, before any factor.
fn case_couple(load: &Load) -> f64 {
    match load.action {
        Action::Resultant(Wrench { m, .. }) => m,
        _ => 0.0,
    }
}

/// The symbol of a couple.
pub(super) fn couple_symbol(case: &Case, load: &Load) -> String {
    let Place::Table(_, index) = said_by(load.id) else { return String::new() };
    numbered(Key::Couple.info().symbol, index, case.inputs().count(Table::Moment))
}

/// The width of a crown wall that waves press under.
fn wall_base(case: &Case) -> Option<f64> {
    match &case.wave.as_ref()?.formula {
        WaveFormula::Crown(waves) => Some(waves.wave.uplift_width),
        _ => None,
    }
}

/// X, V and M of a load as formulas; a part that it does not have is none.
fn formulas(
    case: &Case,
    assessed: &Assessed,
    component: &Component,
    [x, v]: [&str; 2],
    [sum, lever]: &[String; 2],
    factor: &str,
    long: &PlanFactor,
) -> [Option<String>; 3] {
    // The elevation of a force turns it into a moment, its distance from O as well.
    let moment_of_x = |arm: &str| format!("−{x} ({arm} − y_C)");
    let moment_of_v = |arm: &str| format!("−{v} ({arm} − b_1)");
    let PlanFactor { side, circle } = *long;
    let pressure = |left: &str, right: &str, of: &str| match circle {
        false => {
            let force = format!("−{factor}{of}({left} + {right})/2 B_c{side}");
            let moment = format!("{factor}{of}({left} + 2 {right})/6 B_c^2{side} + {v} b_1");
            [None, Some(force), Some(moment)]
        }
        true => {
            let force = format!("−{factor}{of}({left} + {right})/2 π B_c^2/4");
            let turned = format!("π B_c^3/16 (({left} + {right}) + ({right} − {left})/4)");
            [None, Some(force), Some(format!("{factor}{of}{turned} + {v} b_1"))]
        }
    };
    let some = |text: &str| Some(format!("{factor}{text}"));
    let less = |text: &str| Some(format!("−{factor}{text}"));
    // Of the accelerations that are tried the one at work may be the other way round than the one given.
    let turned = |of: fn(&Earthquake) -> f64| {
        let [given, tried] = [&case.earthquake, &assessed.earthquake];
        given.as_ref().zip(tried.as_ref()).is_some_and(|(given, tried)| of(given) * of(tried) < 0.0)
    };
    let way = |turned: bool, text: &str| if turned { less(text) } else { some(text) };
    if case.floor_deg != 0.0
        && let Some(formulas) = on_slope(case, assessed, component, [x, v], factor, way, turned)
    {
        return formulas;
    }
    let [force, elevation, distance] = force_symbols(case, &component.load);
    match component.load.source {
        LoadSource::Weight => match case.parts_weighed(assessed.acting, &component.load) {
            Some(parts) => {
                let sum = |term: &dyn Fn(usize) -> String| {
                    parts.iter().map(|part| term(part + 1)).collect::<Vec<_>>().join(" + ")
                };
                let mass = sum(&|n| format!("m_{n}"));
                let moment = sum(&|n| format!("m_{n} (x_{n} − x_C)"));
                [None, some(&format!("({mass}) g")), less(&format!("({moment}) g"))]
            }
            None => [None, some("m g"), None],
        },
        LoadSource::Buoyancy if matches!(case.weight, Weight::Buoyant { .. }) => {
            [None, less("(m g − W_g)"), some("W_g (b_1 − t_g)")]
        }
        LoadSource::Buoyancy => pressure("h_l", "h_r", "ρ_w g "),
        LoadSource::StillWater => {
            let moment = format!("ρ_w g (h_r^2/2 (h_r/3 − y_C) − h_l^2/2 (h_l/3 − y_C)){side}");
            [some(&format!("ρ_w g (h_l^2 − h_r^2)/2{side}")), None, some(&moment)]
        }
        LoadSource::WaterOnLeft | LoadSource::WaterOnRight => {
            let [area, place] = water_symbols(&component.load);
            let force = format!("ρ_w g {area}{side}");
            let force = if component.wrench.p < 0.0 { less(&force) } else { some(&force) };
            [None, force, Some(moment_of_v(place))]
        }
        LoadSource::Uplift => pressure("p_l", "p_r", ""),
        LoadSource::HorizontalInertia => [way(!turned(Earthquake::horizontal), "m a_h"), None, None],
        LoadSource::VerticalInertia => [None, way(turned(Earthquake::vertical), "m a_v"), None],
        LoadSource::ShakenWater => {
            [way(!turned(Earthquake::horizontal), "m_a a_h"), None, Some(moment_of_x("z_a"))]
        }
        LoadSource::WavePressure => [less("P_w"), None, some("(M_w − P_w y_C)")],
        // Under a crown wall that is narrower than the base, from the seaward edge.
        LoadSource::WaveUplift if wall_base(case).is_some() => {
            let moment = format!("{factor}p_u/2 B_w (B_c − B_w/3) + {v} b_1");
            [None, less("p_u/2 B_w"), Some(moment)]
        }
        LoadSource::WaveUplift => [None, less("p_u/2 B_c"), Some(format!("{factor}p_u/3 B_c^2 + {v} b_1"))],
        LoadSource::Couple => {
            [None, None, way(component.wrench.m < 0.0, &couple_symbol(case, &component.load))]
        }
        LoadSource::Force => match component.load.action {
            Action::Force { up, .. } if up != 0.0 => {
                [None, way(up > 0.0, &force), Some(moment_of_v(&distance))]
            }
            _ => {
                let left = component.wrench.x.is_sign_negative();
                [way(left, &force), None, Some(moment_of_x(&elevation))]
            }
        },
        LoadSource::Pressure => match component.load.action {
            Action::Pressure { face: Face::Left, .. } => {
                [some(sum), None, Some(format!("{x} y_C − {factor}{lever}"))]
            }
            Action::Pressure { face: Face::Right, .. } => {
                [less(sum), None, Some(format!("{factor}{lever} + {x} y_C"))]
            }
            Action::Pressure { face: Face::Base, .. } => {
                [None, less(sum), Some(format!("{factor}{lever} + {v} b_1"))]
            }
            _ => [None, some(sum), Some(format!("{v} b_1 − {factor}{lever}"))],
        },
        _ => [None, None, None],
    }
}

/// Formulas of a load that keeps its direction in space, along and across a floor that rises to the right; `None` of what presses on a
/// face, or turns alone.
fn on_slope(
    case: &Case,
    assessed: &Assessed,
    component: &Component,
    [x, v]: [&str; 2],
    factor: &str,
    way: impl Fn(bool, &str) -> Option<String>,
    turned: impl Fn(fn(&Earthquake) -> f64) -> bool,
) -> Option<[Option<String>; 3]> {
    let both = |[x, v]: [(bool, &str); 2], m: Option<String>| Some([way(x.0, x.1), way(v.0, v.1), m]);
    match component.load.source {
        LoadSource::Weight => match case.parts_weighed(assessed.acting, &component.load) {
            None => both([(true, "m g sin(ε_f)"), (false, "m g cos(ε_f)")], None),
            Some(parts) => {
                let sum = |term: &dyn Fn(usize) -> String| {
                    parts.iter().map(|part| term(part + 1)).collect::<Vec<_>>().join(" + ")
                };
                let mass = sum(&|n| format!("m_{n}"));
                let across = sum(&|n| format!("m_{n} (x_{n} − x_C)"));
                let along = sum(&|n| format!("m_{n} (y_{n} − y_C)"));
                let moment = format!("{factor}(({along}) sin(ε_f) − ({across}) cos(ε_f)) g");
                let [x, v] = ["sin", "cos"].map(|function| format!("({mass}) g {function}(ε_f)"));
                both([(true, &x), (false, &v)], Some(moment))
            }
        },
        LoadSource::HorizontalInertia => {
            let turned = turned(Earthquake::horizontal);
            both([(!turned, "m a_h cos(ε_f)"), (!turned, "m a_h sin(ε_f)")], None)
        }
        LoadSource::VerticalInertia => {
            let turned = turned(Earthquake::vertical);
            both([(!turned, "m a_v sin(ε_f)"), (turned, "m a_v cos(ε_f)")], None)
        }
        LoadSource::Force => {
            let [force, elevation, distance] = force_symbols(case, &component.load);
            let (sin, cos) = case.floor_deg.to_radians().sin_cos();
            let Wrench { x: along, p, .. } = component.wrench;
            // Back in space: to the right, and down.
            let (right, down) = (along * cos + p * sin, p * cos - along * sin);
            let moment = format!("−{x} ({elevation} − y_C) − {v} ({distance} − b_1)");
            let [of_sin, of_cos] = ["sin", "cos"].map(|function| format!("{force} {function}(ε_f)"));
            let parts = match right.abs() > down.abs() {
                true => [(right < 0.0, of_cos), (right < 0.0, of_sin)],
                false => [(down > 0.0, of_sin), (down < 0.0, of_cos)],
            };
            both(parts.each_ref().map(|(less, text)| (*less, text.as_str())), Some(moment))
        }
        _ => None,
    }
}

/// The sum of a pressure along its face, and its moment about where positions begin.
fn pressure(
    steps: &mut SheetSteps,
    case: &Case,
    name: &str,
    [sum_name, lever_name]: &[String; 2],
    (load, face, diagram): (&Load, Face, &PressureDiagram),
) {
    /// Largest number of points that a sum is written out for.
    const WRITTEN: usize = 6;
    let given = &case.pressures;
    let is_it = |pressure: &FacePressure| {
        pressure.face == face && pressure.name == load.name && pressure.diagram == *diagram
    };
    let index = given.iter().position(is_it).unwrap_or_default();
    let scale = given.get(index).map_or(1.0, |pressure| pressure.scale);
    let points = diagram.points();
    let (force, moment) = diagram.resultant_on(&case.body, face);
    let PlanFactor { side, circle } = along(&case.body, case.extent);
    let on_circle = circle && matches!(face, Face::Base | Face::Top);
    let sum = &format!("{name}: sum of the pressure along the face");
    let lever = match face {
        Face::Left | Face::Right => "Its moment about the base",
        Face::Base | Face::Top => "Its moment about the corner O",
    };
    if points.len() > WRITTEN || on_circle {
        let over = if on_circle { ", across the circle of the base" } else { "" };
        let words = format!("added up over {} points{over}", points.len());
        steps.told(sum, sum_name, force, KILONEWTON, &words, "");
        steps.told(lever, lever_name, moment, MOMENT, &words, "");
        return;
    }
    for (i, PressureAt { position, pressure }) in points.iter().enumerate() {
        let [s, q] = ["s", "q"].map(|letter| point(letter, index, given.len(), i));
        steps.know(&s, *position, METRE);
        // As the file has it; one that is scaled to nothing has no other numbers.
        let unscaled = if scale == 0.0 { 0.0 } else { pressure / scale };
        steps.know(&q, unscaled, KILOPASCAL);
    }
    let factor = numbered(Key::PressureFactor.info().symbol, index, given.len());
    steps.know(&factor, scale, NONE);
    let over = |piece: fn([&str; 4]) -> String| {
        let symbol = |letter: &str, i: usize| point(letter, index, given.len(), i);
        let pieces = (1..points.len()).map(|i| {
            let symbols = [symbol("s", i - 1), symbol("s", i), symbol("q", i - 1), symbol("q", i)];
            piece(symbols.each_ref().map(String::as_str))
        });
        let sum = pieces.collect::<Vec<_>>().join(" + ");
        match (scale == 1.0, side) {
            (true, "") => sum,
            (true, side) => format!("({sum}){side}"),
            (false, side) => format!("{factor} ({sum}){side}"),
        }
    };
    let formula = over(|[s_1, s_2, q_1, q_2]| format!("({q_1} + {q_2})/2 ({s_2} − {s_1})"));
    steps.add(sum, "", [sum_name, &formula], force, KILONEWTON, "");
    let formula = over(|[s_1, s_2, q_1, q_2]| {
        format!("({s_2} − {s_1})/6 ({q_1} (2 {s_1} + {s_2}) + {q_2} ({s_1} + 2 {s_2}))")
    });
    steps.add(lever, "", [lever_name, &formula], moment, MOMENT, "");
}
