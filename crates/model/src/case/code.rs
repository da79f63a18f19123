//! Named sets of partial factors: what a code fills in of a combination that the file does not write.
//!
//! Values are recommended ones: EN 1997-1, annex A, as digitised in two open packages; PIANC WG 28, sub-group A, appendix B, table B1;
//! UFC 3-220-20. National annexes change them, and psi factors are the user's.

use crate::criteria::Criterion;
use crate::error::{Fault, Place, Problem};
use crate::inputs::{Inputs, LoadFactor, Value};
use crate::key::{Id, Key, Table};

use super::combination::{ChangeBy, InputChange};

/// Kind of a load to a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CodeLoad {
    /// Of the structure, there all the time.
    Permanent,
    /// Of soil and what stands in it, there all the time.
    Ground,
    /// Still water.
    Water,
    /// Of the structure, variable.
    Variable,
    /// Variable, and acting through the soil.
    ThroughGround,
}

/// A load of a case that a code names.
pub(super) struct NamedLoad {
    pub(super) name: String,
    pub(super) kind: CodeLoad,
}

/// A code: a set that the program has, or an office's file.
#[derive(Debug, Clone, PartialEq)]
pub enum Code {
    /// The set of this name, with recommended values.
    Set(&'static str),
    /// The file of this name.
    File(String),
}

impl Code {
    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Code::Set(name) => name,
            Code::File(name) => name,
        }
    }
}

/// What a code fills in.
pub(super) struct Filled {
    pub(super) code: Code,
    pub(super) factors: Vec<(String, LoadFactor)>,
    /// Scales, and divisors of strengths.
    pub(super) changes: Vec<InputChange>,
    pub(super) sliding: Option<f64>,
    pub(super) bearing: Option<f64>,
    /// Of passive soils, and of other forces with a limit.
    pub(super) passive: Option<f64>,
    pub(super) ties: Option<f64>,
    /// Of forces with a limit by their names.
    pub(super) holds: Vec<(String, f64)>,
    pub(super) criteria: Vec<Criterion>,
}

use LoadFactor::{One, Pair};

/// A set of factors.
struct Set {
    permanent: LoadFactor,
    variable: LoadFactor,
    /// The same of soil and what acts through it, where they are others.
    ground: Option<[LoadFactor; 2]>,
    /// On tan φ, c and friction, and on strengths that are not drained.
    materials: [f64; 2],
    /// Sliding, bearing, passive soil, ties.
    resist: [Option<f64>; 4],
    criteria: &'static [(Key, f64)],
}

const SAFE: &[(Key, f64)] = &[(Key::LeastSliding, 1.0), (Key::LeastGround, 1.0)];

const PLAIN: Set = Set {
    permanent: One(1.0),
    variable: One(1.0),
    ground: None,
    materials: [1.0; 2],
    resist: [None; 4],
    criteria: &[],
};

/// Partial factors of materials of set M2.
const M2: [f64; 2] = [1.25, 1.4];

fn set(code: &str) -> Set {
    match code {
        "EN1997-DA1-1" => {
            Set { permanent: Pair([1.35, 1.0]), variable: Pair([1.5, 0.0]), criteria: SAFE, ..PLAIN }
        }
        "EN1997-DA1-2" => Set { variable: Pair([1.3, 0.0]), materials: M2, criteria: SAFE, ..PLAIN },
        "EN1997-DA2" => Set {
            permanent: Pair([1.35, 1.0]),
            variable: Pair([1.5, 0.0]),
            resist: [Some(1.1), Some(1.4), Some(1.4), None],
            criteria: SAFE,
            ..PLAIN
        },
        "EN1997-DA3" => Set {
            permanent: Pair([1.35, 1.0]),
            variable: Pair([1.5, 0.0]),
            ground: Some([One(1.0), Pair([1.3, 0.0])]),
            materials: M2,
            criteria: SAFE,
            ..PLAIN
        },
        "EN1997-EQU" => Set {
            permanent: Pair([1.1, 0.9]),
            variable: Pair([1.5, 0.0]),
            materials: M2,
            criteria: &[(Key::GreatestTipping, 1.0)],
            ..PLAIN
        },
        "EN1997-UPL" => Set {
            permanent: Pair([1.0, 0.9]),
            variable: Pair([1.5, 0.0]),
            materials: M2,
            resist: [None, None, None, Some(1.4)],
            criteria: &[(Key::LeastUplift, 1.0)],
            ..PLAIN
        },
        // Numbers only: no check against heave is built.
        "EN1997-HYD" => Set { permanent: Pair([1.35, 0.9]), variable: Pair([1.5, 0.0]), ..PLAIN },
        "PIANC28-sliding" => Set { criteria: &[(Key::LeastSliding, 1.0)], ..PLAIN },
        _ => Set { criteria: &[(Key::LeastSliding, 1.5), (Key::LeastOverturningGross, 1.5)], ..PLAIN },
    }
}

/// The probabilities of failure that PIANC has factors for.
const P_F: [f64; 5] = [0.01, 0.05, 0.10, 0.20, 0.40];

/// γ_H and γ_Z at σ' = 0.05, then 0.2, for each of these probabilities: deep water without and with model tests, shallow water without and
/// with.
const PIANC: [[[[f64; 2]; 5]; 2]; 4] = [
    [
        [[1.4, 1.7], [1.3, 1.4], [1.3, 1.2], [1.2, 1.2], [1.1, 1.0]],
        [[1.5, 1.7], [1.4, 1.4], [1.4, 1.3], [1.3, 1.2], [1.1, 1.1]],
    ],
    [
        [[1.3, 1.5], [1.2, 1.4], [1.2, 1.2], [1.1, 1.2], [1.0, 1.2]],
        [[1.4, 1.5], [1.3, 1.4], [1.3, 1.2], [1.2, 1.2], [1.1, 1.0]],
    ],
    [
        [[1.3, 1.9], [1.2, 1.6], [1.2, 1.4], [1.1, 1.3], [1.0, 1.2]],
        [[1.4, 1.9], [1.3, 1.6], [1.3, 1.4], [1.2, 1.3], [1.0, 1.2]],
    ],
    [
        [[1.2, 1.6], [1.1, 1.5], [1.1, 1.3], [1.1, 1.2], [1.0, 1.1]],
        [[1.3, 1.6], [1.2, 1.5], [1.2, 1.3], [1.1, 1.2], [1.0, 1.1]],
    ],
];

/// PIANC's biases of Goda's thrust and uplift.
const BIASES: [(&str, f64); 2] = [("wave.thrust", 0.90), ("wave.uplift", 0.77)];

/// The options of a combination, each once.
struct Options<'a> {
    given: &'a [(String, String)],
    at: Id,
}

impl Options<'_> {
    fn fault(&self, name: &'static str, expected: &'static str) -> Fault {
        let place = self.given.iter().position(|(known, _)| known == name);
        let found = place.map(|place| self.given[place].1.clone());
        let problem = Problem::CodeOption { name, found, expected };
        match place {
            Some(place) => Fault::new(problem, Place::Element(self.at, place)),
            None => Fault::new(problem, Place::Table(Table::Combination, self.at.index)),
        }
    }

    fn word(&self, name: &str) -> Option<&str> {
        let (_, text) = self.given.iter().find(|(known, _)| known == name)?;
        Some(text.trim_matches(['"', '\'']))
    }

    /// The place of an option among words.
    fn one_of(&self, name: &'static str, words: &[&str], expected: &'static str) -> Result<usize, Fault> {
        let found = self.word(name).and_then(|word| words.iter().position(|known| *known == word));
        found.ok_or_else(|| self.fault(name, expected))
    }

    /// The place of an option among numbers.
    fn number(&self, name: &'static str, numbers: &[f64], expected: &'static str) -> Result<usize, Fault> {
        let found = self.word(name).and_then(|word| word.parse::<f64>().ok());
        let found = found.and_then(|number| numbers.iter().position(|known| *known == number));
        found.ok_or_else(|| self.fault(name, expected))
    }

    /// Refuses options that a code does not have.
    fn only(&self, names: &[&'static str]) -> Result<(), Fault> {
        match self.given.iter().position(|(name, _)| !names.contains(&name.as_str())) {
            None => Ok(()),
            Some(place) => {
                let names = names.iter().map(|name| (*name).to_owned()).collect();
                let problem = Problem::NoCodeOption { name: self.given[place].0.clone(), names };
                Err(Fault::new(problem, Place::Element(self.at, place)))
            }
        }
    }
}

/// γ_H and γ_Z of PIANC.
fn of_pianc(options: &Options<'_>) -> Result<[f64; 2], Fault> {
    options.only(&["p_f", "water", "model_tests", "sigma"])?;
    let p_f = options.number("p_f", &P_F, "0.01, 0.05, 0.10, 0.20 or 0.40")?;
    let shallow = options.one_of("water", &["deep", "shallow"], "\"deep\" or \"shallow\"")?;
    let tests = options.one_of("model_tests", &["false", "true"], "true or false")?;
    let sigma = options.number("sigma", &[0.05, 0.2], "0.05 or 0.2")?;
    Ok(PIANC[2 * shallow + tests][sigma][p_f])
}

/// What a code fills in of a combination, by its place, of a case with these loads on a base so wide, that a passive soil may hold.
pub(super) fn filled(
    inputs: &Inputs,
    code: &'static str,
    index: usize,
    loads: Vec<NamedLoad>,
    base: f64,
    passive: bool,
) -> Result<Filled, Fault> {
    let at = Id::new(Key::CombinationOptions, index);
    let options = Options { given: inputs.settings(at).unwrap_or_default(), at };
    let set = set(code);
    let water_is_set = inputs.settings(Id::new(Key::CombinationSet, index)).unwrap_or_default();
    let water_is_set = water_is_set.iter().any(|(name, _)| {
        name.starts_with("water") || name == "wave.base_depth" || name == "wave.still_water"
    });
    let mut factors: Vec<(String, LoadFactor)> = Vec::new();
    for NamedLoad { name, kind } in loads {
        let [ground, through] = set.ground.unwrap_or([set.permanent, set.variable]);
        let factor = match kind {
            CodeLoad::Permanent => set.permanent,
            CodeLoad::Water if water_is_set => One(1.0),
            CodeLoad::Ground | CodeLoad::Water => ground,
            CodeLoad::Variable => set.variable,
            CodeLoad::ThroughGround => through,
        };
        factors.push((name, factor));
    }
    let change = |id: Id, by| InputChange { id, name: id.to_string(), by };
    let mut changes: Vec<InputChange> = Vec::new();
    let mut criteria: Vec<Criterion> = Vec::new();
    let mut friction = set.materials[0];
    match code {
        "PIANC28-sliding" => {
            let [of_heights, of_friction] = of_pianc(&options)?;
            friction = of_friction;
            // The biases are those of Goda's formulas.
            if inputs.choice(Key::WaveFormula).is_none_or(|formula| formula == "goda") {
                factors.retain(|(name, _)| name != "wave");
                if inputs.has(Table::Wave) {
                    factors.extend(BIASES.map(|(name, factor)| (name.to_owned(), One(factor))));
                }
            }
            // The heights at the wall, as they are found: the depth does not limit them again.
            let deep = inputs.number(Key::DeepWaterHeight).is_some();
            let heights = [Key::H13, Key::Hmax, Key::WaveHeight].map(Id::from);
            let at_wall = |id: &Id| deep && id.key != Key::WaveHeight || inputs.number(*id).is_some();
            changes.extend(
                heights.into_iter().filter(at_wall).map(|id| change(id, ChangeBy::Scale(of_heights))),
            );
        }
        "UFC-3-220-20" => {
            options.only(&["ground"])?;
            let rock = match options.word("ground") {
                None => 0,
                Some(_) => options.one_of("ground", &["soil", "rock"], "\"soil\" or \"rock\"")?,
            };
            let most = base / if rock == 1 { 4.0 } else { 6.0 };
            criteria.extend(Criterion::of(Key::GreatestEccentricity, &Value::Number(most), inputs.output()));
            // A passive soil asks for more.
            if passive {
                criteria.extend(Criterion::of(Key::LeastSliding, &Value::Number(2.0), inputs.output()));
            }
        }
        _ => options.only(&[])?,
    }
    let of = |id: &Id| inputs.number(*id).is_some();
    let divided = |id: Id, by: f64| (by != 1.0).then(|| change(id, ChangeBy::Material(by)));
    changes.extend(divided(Key::Friction.into(), friction));
    changes.extend(Some(Id::from(Key::Adhesion)).filter(of).and_then(|id| divided(id, set.materials[0])));
    let soils = (0..inputs.count(Table::Backfill)).flat_map(|soil| {
        let keys = [Key::SoilFriction, Key::SoilCohesion, Key::SoilAdhesion];
        keys.map(move |key| Id::of(Table::Backfill, soil, key))
    });
    // Of a soil in layers the name means all of them.
    let has = |id: &Id| super::backfill::of_all_layers(inputs, *id).iter().any(of);
    let drained = soils.chain([Key::GroundAngle, Key::Cohesion].map(Id::from)).filter(has);
    changes.extend(drained.filter_map(|id| divided(id, set.materials[0])));
    let strengths = [Key::Strength, Key::UndrainedStrength].map(Id::from).into_iter().filter(of);
    changes.extend(strengths.filter_map(|id| divided(id, set.materials[1])));
    let of_set = set
        .criteria
        .iter()
        .filter_map(|(key, bound)| Criterion::of(*key, &Value::Number(*bound), inputs.output()));
    let of_set = of_set.filter(|criterion| criteria.iter().all(|other| other.key != criterion.key));
    criteria.extend(of_set.collect::<Vec<_>>());
    let [sliding, bearing, passive, ties] = set.resist;
    let code = Code::Set(code);
    Ok(Filled { code, factors, changes, sliding, bearing, passive, ties, holds: Vec::new(), criteria })
}
