//! What a design varies, and what has to go with it for the case to make sense.

use standfast::contact::Wrench;

use super::DesignError;
use crate::case::{Case, Number, NumberId, Replacement, Weight};
use crate::suggest::closest;
use crate::units::{Quantity, UnitError};

/// A quantity that is varied.
#[derive(Debug, Clone)]
pub(super) struct Variable {
    /// What it is called.
    pub(super) name: String,
    /// Its present value, SI.
    pub(super) present: f64,
    /// What it measures; `None` for a plain number.
    pub(super) quantity: Option<Quantity>,
    id: NumberId,
    kind: Kind,
}

/// What varies with a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// The body's width at constant density.
    Width,
    /// The body's height at constant density, and so its crest above the sea.
    Height,
    /// The body's mass.
    Mass,
    /// Friction to stick and to slip.
    Friction,
    /// The level of the sea.
    WaterLevel,
    /// The depth of the caisson's base under the sea, its crest staying where it is.
    BaseDepth,
    /// Nothing else.
    Alone,
}

const BODY: &str = "[body]";
const WATER: &str = "[water]";
const WAVE: &str = "[wave]";

/// Short names, and the numbers they may stand for, the first that a case has.
const SHORT_NAMES: [(&str, &[(&str, &str)]); 6] = [
    ("width", &[(BODY, "width")]),
    ("height", &[(BODY, "height")]),
    ("mass", &[(BODY, "mass"), (BODY, "density")]),
    ("friction", &[(BODY, "friction")]),
    ("water_level", &[(WATER, "level"), (WATER, "right"), (WAVE, "base_depth")]),
    ("crest_height", &[(WAVE, "crest_height")]),
];

impl Variable {
    /// The quantity of a case that is called `name`: a short name, or table and key as in `wave.period`.
    pub(super) fn find(name: &str, case: &Case) -> Result<Variable, DesignError> {
        let short = SHORT_NAMES.iter().find(|(short, _)| *short == name);
        let by_short = short.and_then(|(_, places)| {
            places.iter().find_map(|(table, key)| number(case, NumberId::of(table, key)))
        });
        let by_key = || case.numbers.iter().find(|number| full_name(number.id) == name).copied();
        if let Some(number) = by_short.or_else(by_key) {
            let variable = Variable { name: name.to_owned(), ..Variable::of(number) };
            return Ok(match name {
                "water_level" => Variable { kind: Kind::WaterLevel, ..variable },
                // Even where the density is given.
                "mass" => {
                    let quantity = Some(Quantity::Mass);
                    Variable { present: case.body.mass(), quantity, ..variable }
                }
                _ => variable,
            });
        }
        let names: Vec<_> = case.numbers.iter().map(|number| full_name(number.id)).collect();
        let candidates = SHORT_NAMES.iter().map(|(short, _)| *short).chain(names.iter().map(String::as_str));
        let suggestion = closest(name, candidates.filter(|candidate| *candidate != name)).map(str::to_owned);
        Err(DesignError::UnknownVariable { name: name.to_owned(), suggestion, names })
    }

    /// A number of a case and what goes with it.
    pub(super) fn of(Number { id, value, quantity }: Number) -> Variable {
        let kind = match (id.table, id.key) {
            (BODY, "width") | (WAVE, "caisson_width") => Kind::Width,
            (BODY, "height") | (WAVE, "crest_height") => Kind::Height,
            (BODY, "mass" | "density") => Kind::Mass,
            (BODY, "friction") => Kind::Friction,
            (WATER, "level" | "right") => Kind::WaterLevel,
            (WAVE, "base_depth") => Kind::BaseDepth,
            _ => Kind::Alone,
        };
        Variable { name: full_name(id), present: value, quantity, id, kind }
    }

    /// The value that a text says, with a unit or in SI.
    pub(super) fn parse(&self, text: &str) -> Result<f64, UnitError> {
        match (text.trim().parse::<f64>(), self.quantity) {
            (Ok(value), _) if value.is_finite() => Ok(value),
            (_, Some(quantity)) => quantity.parse(text),
            (_, None) => Err(UnitError::Number),
        }
    }

    /// The numbers to be replaced for the quantity to be `value`.
    pub(super) fn replacements(&self, case: &Case, value: f64) -> Vec<Replacement> {
        let mut changes = Changes { case, list: Vec::new() };
        if self.kind != Kind::Mass {
            changes.list.push(Replacement { id: self.id, value });
        }
        let ratio = value / self.present;
        let by = value - self.present;
        match self.kind {
            Kind::Alone => {}
            Kind::Width => {
                for key in ["width", "base_left", "base_right", "centroid_offset", "weight_arm"] {
                    changes.scale(BODY, key, ratio);
                }
                for key in ["mass", "buoyant_weight", "moment_of_inertia"] {
                    changes.scale(BODY, key, ratio);
                }
                changes.scale(WAVE, "caisson_width", ratio);
            }
            Kind::Height => {
                changes.add(WAVE, "crest_height", by);
                changes.heighten(by);
            }
            Kind::Mass => {
                changes.scale(BODY, "mass", ratio);
                changes.scale(BODY, "density", ratio);
                changes.scale(BODY, "moment_of_inertia", ratio);
                changes.weigh(case.body.mass() * (ratio - 1.0) * case.gravity);
            }
            Kind::Friction => changes.scale(BODY, "kinetic_friction", ratio),
            Kind::WaterLevel => {
                for key in ["level", "right", "left"] {
                    // Both sides stand in the same water, unless one side alone is varied.
                    if key != "left" || self.name == "water_level" {
                        changes.add(WATER, key, by);
                    }
                }
                for key in ["base_depth", "water_depth", "depth_above_berm"] {
                    changes.add(WAVE, key, by);
                }
                changes.add(WAVE, "crest_height", -by);
                changes.drown(by);
            }
            Kind::BaseDepth => {
                changes.add(WATER, "level", by);
                changes.add(WATER, "right", by);
                changes.heighten(by);
                changes.drown(by);
            }
        }
        changes.list
    }

    /// What goes with the quantity, in sentences.
    pub(super) fn notes(&self, case: &Case) -> Vec<String> {
        let has = |key| number(case, NumberId::of(BODY, key)).is_some();
        let mut notes = Vec::new();
        let buoyant = matches!(case.weight, Weight::Buoyant { .. });
        match self.kind {
            Kind::Width => {
                if has("mass") {
                    notes.push("The mass goes with the width: the density is kept.".to_owned());
                }
                if buoyant {
                    notes.push("The buoyant weight goes with the width, and its arm as well.".to_owned());
                }
            }
            Kind::Height | Kind::BaseDepth => {
                if has("mass") {
                    notes.push("The mass goes with the height: the mean density is kept.".to_owned());
                }
                if buoyant {
                    notes.push("The buoyant weight takes up the weight added or taken away.".to_owned());
                }
            }
            Kind::Mass if buoyant => {
                notes.push("The buoyant weight takes up the weight added or taken away.".to_owned());
            }
            Kind::WaterLevel if case.wave.is_some() => notes.push(
                "The sea rises or falls: depths change with the level, the crest stays where it is."
                    .to_owned(),
            ),
            _ => {}
        }
        if has("moment_of_inertia") && matches!(self.kind, Kind::Width | Kind::Height | Kind::Mass) {
            notes
                .push("The moment of inertia goes with the mass: the radius of gyration is kept.".to_owned());
        }
        notes
    }
}

/// The replacements of a variation.
struct Changes<'a> {
    case: &'a Case,
    list: Vec<Replacement>,
}

impl Changes<'_> {
    /// Changes a number that the case has, what was said of it before included.
    fn change(&mut self, table: &'static str, key: &'static str, change: impl Fn(f64) -> f64, again: bool) {
        let id = NumberId::of(table, key);
        match self.list.iter_mut().find(|replacement| replacement.id == id) {
            Some(replacement) if again => replacement.value = change(replacement.value),
            Some(_) => {}
            None => {
                if let Some(number) = number(self.case, id) {
                    self.list.push(Replacement { id, value: change(number.value) });
                }
            }
        }
    }

    fn scale(&mut self, table: &'static str, key: &'static str, ratio: f64) {
        self.change(table, key, |value| value * ratio, false);
    }

    fn add(&mut self, table: &'static str, key: &'static str, by: f64) {
        self.change(table, key, |value| value + by, false);
    }

    /// Adds to a given buoyant weight.
    fn weigh(&mut self, weight: f64) {
        self.change(BODY, "buoyant_weight", |value| value + weight, true);
    }

    /// Makes the body higher, at its density.
    fn heighten(&mut self, by: f64) {
        let body = &self.case.body;
        let ratio = (body.height() + by) / body.height();
        self.add(BODY, "height", by);
        for key in ["mass", "centroid_height", "moment_of_inertia"] {
            self.scale(BODY, key, ratio);
        }
        self.weigh(body.mass() * (ratio - 1.0) * self.case.gravity);
    }

    /// Takes the buoyancy of more water off a given buoyant weight.
    fn drown(&mut self, by: f64) {
        let Some(wave) = &self.case.wave else { return };
        let unit_weight = wave.sea.water_density * self.case.gravity;
        let Wrench { p, .. } = self.case.body.base_pressure(unit_weight * by, unit_weight * by);
        self.weigh(p);
    }
}

fn number(case: &Case, id: NumberId) -> Option<Number> {
    case.numbers.iter().find(|number| number.id == id).copied()
}

/// Table and key without brackets: `wave.period`, `load[2].force`, `gravity`.
fn full_name(id: NumberId) -> String {
    let table = id.table.trim_matches(['[', ']']);
    match (table, id.index) {
        _ if !id.table.starts_with('[') => id.key.to_owned(),
        (_, _) if id.table.starts_with("[[") => format!("{table}[{}].{}", id.index + 1, id.key),
        _ => format!("{table}.{}", id.key),
    }
}
