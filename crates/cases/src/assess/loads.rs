//! The body and its loads one by one, for reading.

use standfast::loads::Load;
use standfast::{Plan, Wrench};

use super::{Assessed, Component, plan};
use crate::case::{Case, Waves, Weight};
use crate::layout::{columns, digits, paragraph, row};
use crate::summary::listed;
use crate::units::{Dimension, Extent};
use standfast_inputs::datum::Datum;

/// Note on the effect that added mass leaves out.
const ADDED_MASS: &str = "Added mass resists the horizontal acceleration of the centre of mass. Its own height, which couples sway and \
    rotation, is left out.";

/// Note on the water pressure in an earthquake, which is not counted where the added mass is given as such.
const SHAKEN_WATER: &str = "The water's pressure on the shaken wall is not among the loads: its height is not given. In \
    [added_mass], give sides in place of the mass, or add the pressure as a [[load]].";

/// Note on the motion that the answer to a cylinder leaves out.
const WOBBLE: &str = "The motion is computed in the plane of the loads. A cylinder that rocks rolls on its rim and wobbles out of that plane; it then \
    comes down later, and elsewhere. The moment at which it begins to move stays the same.";

/// Notes on the effects that the answer to a case leaves out, in sentences.
pub fn left_out(case: &Case) -> Vec<&'static str> {
    let mut notes = Vec::new();
    if case.body.plan() == Plan::Circle && case.plan.is_none() {
        notes.push(WOBBLE);
    }
    if case.added_mass.mass() > 0.0 {
        notes.push(ADDED_MASS);
        if case.earthquake.is_some() && case.added_mass.height().is_none() {
            notes.push(SHAKEN_WATER);
        }
    }
    notes
}

pub(super) fn body(case: &Case) -> String {
    let Case { body, extent, output, .. } = case;
    let across = if body.plan() == Plan::Circle { "diameter 2B" } else { "width 2B" };
    let mut rows =
        vec![row![across, output.length(body.width())], row!["height 2H", output.length(body.height())]];
    if let (Extent::Whole, Plan::Rectangle { length }) = (extent, body.plan()) {
        rows.push(row!["length out of the plane", output.length(length)]);
    }
    rows.push(row!["mass m", output.mass(body.mass())]);
    let gravity = format!("g = {} m/s²", digits(case.gravity));
    rows.push(row!["weight m g", format!("{} ({gravity})", output.force(body.mass() * case.gravity))]);
    if case.added_mass.mass() > 0.0 {
        let mass = format!("{}, moves with the body horizontally", output.mass(case.added_mass.mass()));
        rows.push(row!["added mass of water", mass]);
    }
    rows.extend(parts(case));
    rows.push(row!["slenderness γ = H/B", digits(body.slenderness())]);
    if case.floor_deg != 0.0 {
        rows.push(row!["floor", floor_words(case)]);
    }
    if !body.is_uniform() {
        let place = format!(
            "{} above the base, {} right of O, {} left of O'",
            output.length(body.centroid_height()),
            output.length(body.heel_distance()),
            output.length(body.toe_distance())
        );
        rows.push(row!["centre of mass", place]);
        let inertia = format!("{} about it", output.inertia(body.moment_of_inertia()));
        rows.push(row!["moment of inertia", inertia]);
    }
    if let Some(base) = plan::base(case) {
        rows.push(row!["base from above", base]);
    }
    if case.kinetic_friction == case.friction {
        rows.push(row!["friction μ", digits(case.friction)]);
    } else {
        let pair = format!("{} to stick, {} to slip", digits(case.friction), digits(case.kinetic_friction));
        rows.push(row!["friction μ", pair]);
    }
    if let Some(water) = &case.water {
        let levels = if water.left() == water.right() {
            output.length(water.left())
        } else {
            format!(
                "{} at the left, {} at the right",
                output.length(water.left()),
                output.length(water.right())
            )
        };
        rows.push(row!["still water", format!("{levels} above the base; {} kg/m³", digits(water.density()))]);
    }
    if let Some(datum) = case.inputs().datum() {
        rows.push(row!["levels", levels(case, &datum)]);
    }
    if case.water.is_some() || case.weight != Weight::Total {
        rows.push(row!["weight counted as", case.weight_words()]);
    }
    let glued = glued(case).map_or(String::new(), |words| paragraph(&words, 2));
    columns(&rows, 2, &[]) + &glued
}

/// Sentence on parts between which a joint could be and is not.
pub fn glued(case: &Case) -> Option<String> {
    let levels: Vec<String> = case.glued_at().into_iter().map(|level| case.output.length(level)).collect();
    (!levels.is_empty()).then(|| {
        format!("Parts are taken as glued, at {}; [[joint]] asks whether they stay.", listed(&levels))
    })
}

/// How the floor lies, and in which directions forces are told.
pub fn floor_words(case: &Case) -> String {
    let way = if case.floor_deg > 0.0 { "right" } else { "left" };
    format!(
        "rises to the {way} at {}°; forces are told along and across the base",
        digits(case.floor_deg.abs())
    )
}

/// Levels of the base, the crest, the water and the ground.
fn levels(case: &Case, datum: &Datum<'_>) -> String {
    let mut named = vec![("base".to_owned(), 0.0), ("crest".to_owned(), case.body.height())];
    if let Some(water) = &case.water {
        match water.left() == water.right() {
            true => named.push(("still water".to_owned(), water.right())),
            false => {
                named.extend([("water left".to_owned(), water.left()), ("right".to_owned(), water.right())])
            }
        }
    } else if let Some(sea) = case.wave.as_ref().and_then(Waves::still_water) {
        named.push(("still water".to_owned(), sea));
    }
    named.extend(case.soils.iter().map(|fill| (fill.name.clone(), fill.soil.top)));
    let words = named.into_iter().map(|(name, elevation)| format!("{name} {}", datum.written(elevation)));
    words.collect::<Vec<_>>().join(", ")
}

/// The parts of the body: of each its density, dry and wet.
fn parts(case: &Case) -> Vec<Vec<String>> {
    let rows = case.parts().enumerate().map(|(index, (name, part))| {
        let name = name.map_or_else(|| format!("part {}", index + 1), str::to_owned);
        let (dry, wet) = (digits(part.density()), digits(part.density_below_water()));
        let density = match part.density() {
            0.0 if part.density_below_water() == 0.0 => "a cavity".to_owned(),
            _ if dry == wet => format!("{dry} kg/m³"),
            _ => format!("{dry} kg/m³ above still water, {wet} kg/m³ below"),
        };
        let area = digits(part.area());
        row![if index == 0 { "parts" } else { "" }, format!("{name}: {area} m², {density}")]
    });
    rows.collect()
}

/// Words on a load: permanent or variable, and its factor.
pub fn share(load: &Load) -> String {
    let share = if load.permanent { "permanent" } else { "variable" };
    if load.factor == 1.0 { share.to_owned() } else { format!("{share} × {}", digits(load.factor)) }
}

/// The loads one by one, and their sum under the full load.
pub(super) fn components(assessed: &Assessed) -> String {
    let output = assessed.output;
    if assessed.outcome.plan.is_some() {
        return plan::components(assessed);
    }
    let [force, moment] = [Dimension::Force, Dimension::Moment].map(|dimension| output.symbol(dimension));
    let mut rows =
        vec![row!["", "", "left", "down", "moment at C"], row!["load", "", force.as_str(), force, moment]];
    let numbers = |wrench: &Wrench| {
        // `0.0 −` rather than `−`, so that nothing becomes −0.
        [
            output.value(Dimension::Force, 0.0 - wrench.x),
            output.value(Dimension::Force, wrench.p),
            output.value(Dimension::Moment, wrench.m),
        ]
    };
    for Component { name, load, wrench } in assessed.components() {
        let share = share(&load);
        let [left, down, moment] = numbers(&wrench);
        rows.push(row![name, share, left, down, moment]);
    }
    let [left, down, moment] = numbers(&assessed.outcome.full.wrench);
    rows.push(row!["sum", "", left, down, moment]);
    columns(&rows, 2, &[2, 3, 4])
}
