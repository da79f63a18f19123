//! The section of a case: its body, levels and loads as the figure draws them.

mod plan;
mod under;

use standfast::loads::{Action, Face, Load, LoadId, LoadSource, PressureAt};
use standfast::section::{Part, Vertex, WaterTable};
use standfast::wave::WavePhase;
use standfast::{BaseEdges, Body, InputError, Situation, Slip, Wrench};
use standfast_figures::{
    Arrow, Backfill, Figure, Level, Material, Measure, Mound, Outline, Pressed, Section, Side,
};

use standfast_model::load_words;

use super::Assessment;
use super::plan::direction_words;
use super::{holding, joints};
use crate::case::{
    Acting, Case, Direction, GodaWaves, Limit, Made, PointForce, Resistance, SoilFill, StandingWaves, Trial,
    WaveFormula, Waves, soil_of,
};
use crate::layout::digits;
use standfast_inputs::OutputUnits;

const SCALES: &str = "Lengths are to one scale, pressures to another, arrows of forces to a third; the smallest of these are drawn \
    longer, to be seen. Values are those of the case, before any factor of a combination.";
const EQUAL: &str = "Water stands equally high on both sides: its pressures there cancel, and are no load.";
const WAVE: &str = "The wave is drawn to η*, where its pressure would end; its shape is a sketch. Pressures are those above still water.";
const STANDING_WAVE: &str = "Pressures of the wave are those beside still water.";
const SLOPES: &str = "How steep the mound is, the case does not say.";
const SOIL_BESIDE: &str = "Grains beside the body: soil, up to the ground.";
const FILLED: &str = "Grains beside the body: fill, drawn where a permanent pressure rises with depth.";
const WET: &str = "A part that takes up water has one density above it and another below.";
const SOIL: &str = "Grains under the base: ground that can fail, taken as one soil.";
const SHAKEN_WORST: &str = "The earthquake is drawn as it governs; the other directions are tried as well.";
const SHAKEN: &str = "The earthquake is drawn as it is given; the other directions are tried as well.";

/// The section of a case under all of its loads, with the reaction of the base in the worst of its situations where the case says what the
/// base bears.
pub(super) fn figure(assessment: &Assessment) -> Result<Figure, InputError> {
    with_section(assessment, Pressures::Along, |section, _| standfast_figures::section(section))
}

/// How pressures are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pressures {
    /// Along their faces.
    #[default]
    Along,
    /// Each as its resultant, where that lies on its face.
    Summed,
}

/// What the arrows of a section are of.
pub(super) struct Arrows {
    /// Their loads, in their order.
    pub loads: Vec<LoadId>,
    /// True if some are sums of pressures.
    pub has_sums: bool,
}

/// Draws the section of a case; what its arrows are of comes with it.
pub(super) fn with_section<T>(
    assessment: &Assessment,
    drawn: Pressures,
    draw: impl FnOnce(&Section<'_>, &Arrows) -> T,
) -> Result<T, InputError> {
    let case = &assessment.case;
    let worst = assessment.governing();
    let reaction = worst.ground.as_ref().and_then(|ground| under::reaction(case, worst, ground));
    // The line of thrust is that of the accelerations that govern.
    // So is the force seen from above.
    let is_of_worst = worst.joints.is_some() || worst.outcome.plan.is_some();
    let trial = if is_of_worst { worst.trial } else { Trial::AS_GIVEN };
    let situation = case.situation(Acting::All, trial)?;
    let output = case.output;
    let look = Look { output, slope: case.floor_deg.to_radians() };
    let BaseEdges { left, right } = case.body.base_edges();
    let (widths, heights) = dimensions(case);
    let sketched = sketched_fills(situation.loads());
    let has_sketch = !sketched.is_empty();
    let backfills: Vec<Backfill> = case.soils.iter().map(backfill).chain(sketched).collect();
    let is_on_soil = matches!(worst.ground.as_ref().and_then(|ground| ground.limit), Some(Limit::Ground(_)));
    let mut notes = notes(case);
    notes.extend((case.floor_deg != 0.0).then(|| on_slope(case)));
    notes.extend((!case.soils.is_empty()).then(|| SOIL_BESIDE.to_owned()));
    notes.extend(has_sketch.then(|| FILLED.to_owned()));
    notes.extend(is_on_soil.then(|| SOIL.to_owned()));
    notes.extend(worst.ground.as_ref().map(|_| under::reaction_words(assessment, worst, reaction.as_ref())));
    notes.extend(worst.joints.as_ref().map(|joints| joints::thrust_words(assessment, worst, joints)));
    notes.extend(plan::words(case, worst));
    let failure = reaction.as_ref().and_then(|reaction| reaction.failure.as_ref());
    notes.extend(failure.zip(worst.ground.as_ref()).map(|(_, ground)| under::failure_words(ground)));
    let (mut pressures, mut arrows, mut of) =
        (Vec::new(), Vec::new(), Arrows { loads: Vec::new(), has_sums: false });
    for load in situation.loads() {
        let sum = (drawn == Pressures::Summed || is_beside_soil(load))
            .then(|| resultant(look, &situation, load))
            .flatten();
        of.has_sums |= sum.is_some() && drawn == Pressures::Summed;
        if let Some(arrow) = sum.or_else(|| arrow(look, &situation, load)) {
            arrows.push(arrow);
            of.loads.push(load.id);
        } else {
            pressures.extend(pressed(look, &situation, load));
        }
    }
    // Behind the loads, of which each arrow is one.
    arrows.extend(case.resistances.iter().map(|resistance| held(output, &case.body, resistance)));
    notes.extend(case.forces.iter().filter_map(|force| couple(output, force)));
    notes.extend(situation.loads().iter().filter_map(|load| across(output, &situation, load)));
    let section = Section {
        title: case.title.as_deref().unwrap_or_default(),
        parts: &parts(case),
        joints: joints::lines(worst),
        base: (-left, right),
        centroid: (case.body.centroid_offset(), case.body.centroid_height()),
        levels: levels(case),
        pressures,
        arrows,
        widths,
        heights,
        mound: case.goda().and_then(mound),
        wave_crest: case.wave.as_ref().and_then(Waves::surface),
        is_on_soil,
        backfills,
        reaction,
        friction: Some(under::friction(case)),
        ground: under::ground(case),
        plan: plan::view(assessment, worst),
        notes,
    };
    Ok(draw(&section, &of))
}

/// The outlines of the body, or of its parts.
fn parts(case: &Case) -> Vec<Outline> {
    let Some(section) = &case.section else {
        let (half, height) = (case.body.width() / 2.0, case.body.height());
        let vertices = vec![(-half, 0.0), (half, 0.0), (half, height), (-half, height)];
        return vec![Outline { vertices, material: Material::Solid, label: String::new() }];
    };
    let [left, right] = section.ends();
    let middle = (left + right) / 2.0;
    let several = section.parts().len() > 1;
    let outlines = case.parts().flat_map(|(name, part)| {
        let pieces = pieces(case.water_table, part).into_iter().filter(|piece| piece.corners.len() > 2);
        pieces.map(move |Piece { corners, material, density }| Outline {
            vertices: corners.iter().map(|corner| (corner.x - middle, corner.y)).collect(),
            material,
            // A body of one part has its name in the title.
            label: name
                .filter(|_| several)
                .into_iter()
                .map(str::to_owned)
                .chain(density)
                .collect::<Vec<_>>()
                .join(", "),
        })
    });
    outlines.collect()
}

/// What of a part is of one material, with its density in words.
struct Piece {
    corners: Vec<Vertex>,
    material: Material,
    density: Option<String>,
}

/// The pieces of a part: one that takes up water is another material below it.
fn pieces(water: Option<WaterTable>, part: &Part) -> Vec<Piece> {
    let (dry, wet) = (part.density(), part.density_below_water());
    let piece = |corners, material, density| Piece { corners, material, density };
    let whole = part.outline().to_vec();
    match water {
        _ if (dry, wet) == (0.0, 0.0) => vec![piece(whole, Material::Cavity, None)],
        Some(water) if dry != wet && water.left == water.right => {
            let [above, below] = part.cut_at(water.left);
            vec![
                piece(above, material(dry), Some(kilograms(dry))),
                piece(below, Material::Fill, Some(kilograms(wet))),
            ]
        }
        Some(_) if dry != wet => {
            let both = format!("{}, {} in water", kilograms(dry), kilograms(wet));
            vec![piece(whole, Material::Fill, Some(both))]
        }
        _ => vec![piece(whole, material(dry), Some(kilograms(dry)))],
    }
}

/// The look of a dry material: what is lighter than this is loose, as sand and rock that are filled in are.
fn material(density: f64) -> Material {
    const LOOSE: f64 = 2000.0;
    if density < LOOSE { Material::Fill } else { Material::Solid }
}

fn kilograms(density: f64) -> String {
    format!("{} kg/m³", digits(density))
}

/// The side of a face that is upright.
fn side_of(face: Face) -> Side {
    if face == Face::Left { Side::Left } else { Side::Right }
}

/// Soil beside the body.
fn backfill(fill: &SoilFill) -> Backfill {
    Backfill {
        side: side_of(fill.soil.face),
        top: fill.soil.top,
        slope: fill.soil.slope_deg.to_radians().tan(),
    }
}

/// Fill beside the body: permanent pressures on a side, as they are given, that rise with depth, up to where they begin.
fn sketched_fills(loads: &[Load]) -> Vec<Backfill> {
    let mut fills: Vec<Backfill> = Vec::new();
    for load in loads.iter().filter(|load| load.permanent && load.source == LoadSource::Pressure) {
        let Action::Pressure { face, diagram } = &load.action else { continue };
        let side = match face {
            Face::Left => Side::Left,
            Face::Right => Side::Right,
            Face::Base | Face::Top => continue,
        };
        let (Some(low), Some(high)) = (diagram.points().first(), diagram.points().last()) else { continue };
        let falls = |pair: &[PressureAt]| pair[1].pressure < pair[0].pressure;
        if low.pressure > 0.0 && diagram.points().windows(2).all(falls) {
            match fills.iter_mut().find(|fill| fill.side == side) {
                Some(fill) => fill.top = fill.top.max(high.position),
                None => fills.push(Backfill { side, top: high.position, slope: 0.0 }),
            }
        }
    }
    fills
}

/// Widths in rows, and heights in columns.
fn dimensions(case: &Case) -> (Vec<Vec<Measure>>, Vec<Vec<Measure>>) {
    let body = &case.body;
    let (half, BaseEdges { left, right }) = (body.width() / 2.0, body.base_edges());
    let measure = |from: f64, to: f64, name: &str| {
        let label = format!("{name}{}", case.output.length(to - from));
        Measure { ends: (from, to), label }
    };
    let mut widths = vec![vec![measure(-half, half, "")]];
    let mut heights = vec![vec![measure(0.0, body.height(), "")]];
    if (left, right) != (half, half) {
        widths.insert(0, vec![measure(-left, right, "base ")]);
    }
    let (x, y) = (body.centroid_offset(), body.centroid_height());
    if x != 0.0 || left != right {
        widths.insert(0, vec![measure(-left, x, "O–C "), measure(x, right, "C–O′ ")]);
    }
    if y != body.height() / 2.0 {
        heights.insert(0, vec![measure(0.0, y, "C ")]);
    }
    (widths, heights)
}

fn levels(case: &Case) -> Vec<Level> {
    let level = |side, elevation: f64, name: &str, is_water| {
        let sign = match elevation {
            0.0 => "±",
            up if up > 0.0 => "+",
            _ => "−",
        };
        let datum =
            case.inputs().datum().map_or(String::new(), |datum| format!(", {}", datum.written(elevation)));
        let label = format!("{name} {sign}{}{datum}", case.output.length(elevation.abs()));
        Level { side, elevation, label, is_water }
    };
    let mut levels =
        vec![level(Side::Left, case.body.height(), "crest", false), level(Side::Left, 0.0, "base", false)];
    if let Some(water) = &case.water {
        let sides = [(Side::Left, water.left()), (Side::Right, water.right())];
        let wet = sides.into_iter().filter(|(_, elevation)| *elevation > 0.0);
        levels.extend(wet.map(|(side, elevation)| level(side, elevation, "water", true)));
    }
    for fill in &case.soils {
        let side = side_of(fill.soil.face);
        levels.push(level(side, fill.soil.top, "ground", false));
        let bounds = fill.soil.bounds().into_iter().map(|[_, lower]| lower);
        levels.extend(bounds.filter(|lower| *lower > 0.0).map(|lower| level(side, lower, "layer", false)));
    }
    if let Some((waves, still)) = case.wave.as_ref().and_then(|waves| Some((waves, waves.still_water()?))) {
        levels.retain(|level| !level.is_water);
        // The pressures of waves are those above still water, which stands in the harbour as well.
        levels.extend([Side::Left, Side::Right].map(|side| level(side, still, "still water", true)));
        let at_sea = |elevation: f64, name| level(Side::Right, still + elevation, name, false);
        match &waves.formula {
            WaveFormula::Goda(GodaWaves { section, goda, sea, .. }) => levels.extend([
                at_sea(goda.eta_star, "η*"),
                at_sea(-section.depth_above_berm, "berm"),
                at_sea(-sea.water_depth, "sea bed"),
            ]),
            WaveFormula::Sainflou(StandingWaves { wave, sea, .. }) => {
                let name = if wave.phase == WavePhase::Crest { "wave crest" } else { "wave trough" };
                levels.extend([at_sea(wave.surface, name), at_sea(-sea.water_depth, "sea bed")]);
            }
            WaveFormula::Crown(_) => {}
        }
    }
    levels
}

/// The mound, unless the base is no higher than the bed.
fn mound(wave: &GodaWaves) -> Option<Mound> {
    let still = wave.section.base_depth;
    let bed = still - wave.sea.water_depth;
    let berm = still - wave.section.depth_above_berm;
    (bed <= 0.0).then_some(Mound { bed, berm, berm_width: wave.section.berm_width })
}

/// The name of a load in a figure, where that of what is made of soil reads as words.
fn drawn_words(load: &Load) -> String {
    let words = match soil_of(load) {
        Some((soil, Some(Made::Surcharge))) => format!("surcharge on {soil}"),
        Some((soil, Some(Made::Earthquake))) => format!("{soil} in the earthquake"),
        _ => return load_words(load),
    };
    if load.source == LoadSource::EarthDrag { format!("{words}, drag") } else { words }
}

/// True of what a soil makes beside its own pressure, which is drawn as its resultant.
fn is_beside_soil(load: &Load) -> bool {
    load.source == LoadSource::EarthPressure && !load.permanent
}

/// How loads are drawn and told.
#[derive(Clone, Copy)]
struct Look {
    output: OutputUnits,
    /// Rise of the floor to the right, radians.
    slope: f64,
}

impl Look {
    /// The forces of a load as they are in space: of one that presses on a face, along and across the base.
    fn in_space(self, load: &Load, wrench: Wrench) -> Wrench {
        if self.slope == 0.0 || matches!(load.action, Action::Pressure { .. }) {
            return wrench;
        }
        let (sin, cos) = self.slope.sin_cos();
        // What is left of a number that is zero.
        let clean = |x: f64| if x.abs() <= 1e-12 * wrench.x.hypot(wrench.p) { 0.0 } else { x };
        let Wrench { x, p, m } = wrench;
        Wrench { x: clean(x * cos + p * sin), p: clean(p * cos - x * sin), m }
    }
}

/// Name, size and direction of a load, in words.
fn words(look: Look, situation: &Situation, load: &Load, sideways: bool) -> String {
    let wrench = look.in_space(load, situation.wrench_of(load));
    let (size, way) = match sideways {
        true => (wrench.x, if wrench.x < 0.0 { "to the left" } else { "to the right" }),
        false => (wrench.p, if wrench.p < 0.0 { "upwards" } else { "downwards" }),
    };
    format!("{}, {} {way}", drawn_words(load), look.output.force(size.abs()))
}

fn pressed(look: Look, situation: &Situation, load: &Load) -> Option<Pressed> {
    let Action::Pressure { face, diagram } = &load.action else { return None };
    let point = |point: &PressureAt| {
        (point.position, point.pressure, look.output.pressure(point.pressure).replace('-', "−"))
    };
    let points: Vec<_> = diagram.points().iter().map(point).collect();
    let acts = points.iter().any(|(_, pressure, _)| *pressure != 0.0);
    let sideways = matches!(face, Face::Left | Face::Right);
    acts.then(|| Pressed { face: *face, points, words: words(look, situation, load, sideways) })
}

fn arrow(look: Look, situation: &Situation, load: &Load) -> Option<Arrow> {
    let body = situation.body();
    let centre = (body.centroid_offset(), body.centroid_height());
    let (at, is_inside) = match &load.action {
        Action::Pressure { .. } => return None,
        Action::Drag { .. } => {
            let force = load.forces(body, situation.gravity()).into_iter().next()?;
            ((centre.0 + force.at[0], centre.1 + force.at[1]), false)
        }
        Action::Force { at, .. } => {
            ((at.x, at.y), matches!(load.source, LoadSource::Buoyancy | LoadSource::Weight))
        }
        Action::Resultant(_) if load.source == LoadSource::Couple => return None,
        _ => (centre, true),
    };
    placed(look, situation, load, at, is_inside)
}

/// A pressure as one arrow; `None` of one whose resultant does not lie on its face, as of pressures that cancel.
fn resultant(look: Look, situation: &Situation, load: &Load) -> Option<Arrow> {
    let Action::Pressure { face, diagram } = &load.action else { return None };
    let body = situation.body();
    let (force, moment) = diagram.resultant_on(body, *face);
    let (place, half) = (moment / force, body.width() / 2.0);
    let on_base = place - body.base_edges().left;
    let (at, end) = match face {
        Face::Left => ((-half, place), body.height()),
        Face::Right => ((half, place), body.height()),
        Face::Base => ((on_base, 0.0), body.base_width()),
        Face::Top => ((on_base, body.height()), body.base_width()),
    };
    // What presses from below is drawn into the body, where it has room.
    let is_inside = *face == Face::Base;
    (0.0..=end).contains(&place).then(|| placed(look, situation, load, at, is_inside)).flatten()
}

/// A force at a place of the body, or on its mass.
fn placed(look: Look, situation: &Situation, load: &Load, at: (f64, f64), is_inside: bool) -> Option<Arrow> {
    let body = situation.body();
    let wrench = look.in_space(load, situation.wrench_of(load));
    let sideways = wrench.x.abs() > wrench.p.abs();
    let (size, towards) = match sideways {
        true => (wrench.x, (wrench.x.signum(), 0.0)),
        false => (wrench.p, (0.0, -wrench.p.signum())),
    };
    let towards = match is_inside && !matches!(load.action, Action::Pressure { .. }) {
        // Beside the body an arrow tells where a force acts, along or across a face.
        false => towards,
        true => {
            let (sin, cos) = look.slope.sin_cos();
            (towards.0 * cos + towards.1 * sin, towards.1 * cos - towards.0 * sin)
        }
    };
    let mut words = words(look, situation, load, sideways);
    if !is_inside || matches!(load.action, Action::Pressure { .. }) {
        let place = match sideways {
            true => format!(", {} above the base", look.output.length(at.1)),
            false => format!(", {} right of O", look.output.length(at.0 + body.base_edges().left)),
        };
        words += &place.replace(" -", " −");
    }
    let away = situation.away(load);
    if away != 0.0 {
        let whole = standfast::footprint::degrees([wrench.x, away]);
        let (force, towards) = (look.output.force(wrench.x.hypot(away)), direction_words(whole));
        words += &format!(", the part in the section of {force} {towards}");
    }
    (size != 0.0).then(|| Arrow {
        at,
        towards,
        is_inside,
        size: size.abs(),
        label: look.output.force(size.abs()),
        words,
    })
}

/// A force with a limit, as much as it holds.
fn held(output: OutputUnits, body: &Body, resistance: &Resistance) -> Arrow {
    let size = resistance.counted();
    let left = body.base_edges().left;
    let (towards, x) = match resistance.direction {
        Direction::Sideways(side) => {
            ((side.sign(), 0.0), resistance.distance.map_or(0.0, |distance| distance - left))
        }
        _ => ((0.0, -1.0), resistance.distance.unwrap_or(left) - left),
    };
    let most = output.force(size);
    Arrow {
        at: (x, resistance.elevation),
        towards,
        is_inside: false,
        size,
        label: format!("≤ {most}"),
        words: format!("{}, holds up to {most} {}", resistance.name, holding::place(resistance, output)),
    }
}

/// A force square to the section in words, which is not drawn there.
fn across(output: OutputUnits, situation: &Situation, load: &Load) -> Option<String> {
    let (wrench, away) = (situation.wrench_of(load), situation.away(load));
    let towards = direction_words(standfast::footprint::degrees([0.0, away]));
    (wrench.x == 0.0 && away != 0.0).then(|| {
        format!("Not drawn in the section: {}, {} {towards}.", load_words(load), output.force(away.abs()))
    })
}

/// A couple in words, which is not drawn.
fn couple(output: OutputUnits, force: &PointForce) -> Option<String> {
    let Direction::Turning(side) = force.direction else { return None };
    let name = force.name.as_deref().unwrap_or("couple");
    let way = if side == Slip::Left { "counter-clockwise" } else { "clockwise" };
    Some(format!("Not drawn: {name}, a couple of {} {way}.", output.moment(force.magnitude)))
}

/// Note on a tilted floor.
fn on_slope(case: &Case) -> String {
    let way = if case.floor_deg > 0.0 { "right" } else { "left" };
    format!(
        "The floor rises to the {way} at {}°: the section is drawn on its base, and the weight leans. Arrows beside the body tell where forces act, not how they lean.",
        digits(case.floor_deg.abs())
    )
}

fn notes(case: &Case) -> Vec<String> {
    let mut notes = vec![SCALES];
    if case.water.as_ref().is_some_and(|water| water.left() == water.right()) {
        notes.push(EQUAL);
    }
    let takes_up = |part: &Part| part.density() != part.density_below_water();
    if case.water_table.is_some() && case.parts().any(|(_, part)| takes_up(part)) {
        notes.push(WET);
    }
    match case.wave.as_ref().map(|wave| &wave.formula) {
        Some(WaveFormula::Goda(_)) => notes.push(WAVE),
        Some(WaveFormula::Sainflou(_)) => notes.push(STANDING_WAVE),
        _ => {}
    }
    if case.goda().and_then(mound).is_some() {
        notes.push(SLOPES);
    }
    if case.earthquake.is_some() && (case.both_sides || case.both_ways) {
        let is_given = case.joints.is_empty() && case.plan.is_none();
        notes.push(if is_given { SHAKEN } else { SHAKEN_WORST });
    }
    notes.into_iter().map(str::to_owned).collect()
}
