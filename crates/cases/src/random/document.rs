//! The probabilities as a JSON document.

use std::collections::BTreeMap;

use serde::Serialize;
use standfast_probability::sample::Estimate;

use super::answer::{Chances, Happening, LifeChances, Probability};
use crate::assess::SCHEMA;

/// Every key is there in every answer, as docs/probability.schema.json has them: `null`, or an empty list, where there is no such
/// thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    case: &'a str,
    seed: u64,
    random: Vec<RandomDocument<'a>>,
    /// The number that is integrated rather than drawn.
    integrated: &'a str,
    #[serde(flatten)]
    worst: ChancesDocument<'a>,
    /// The others, where the case has several sets of loads.
    others: Vec<ChancesDocument<'a>>,
}

#[derive(Serialize)]
struct RandomDocument<'a> {
    name: &'a str,
    /// The share of its law that no body has, which was cut away.
    cut: f64,
}

#[derive(Serialize)]
struct ChancesDocument<'a> {
    situation: Option<&'a str>,
    method: &'static str,
    points: u64,
    precise: bool,
    modes: Vec<ModeDocument>,
    not_rest: Interval,
    not_unique: Interval,
    lifted: Interval,
    /// The distance of the nearest point at which the body does not rest, in standard normals; `null` where none is within reach.
    beta: Option<f64>,
    /// −Φ⁻¹ of the probability; `null` where that is 0 or 1.
    beta_generalized: Option<f64>,
    design_point: Option<BTreeMap<&'a str, f64>>,
    at_change_of_formula: Option<bool>,
    importance: Vec<ImportanceDocument<'a>>,
    life: Option<LifeDocument>,
}

#[derive(Serialize)]
struct Interval {
    probability: f64,
    low: f64,
    high: f64,
}

#[derive(Serialize)]
struct ModeDocument {
    mode: String,
    #[serde(flatten)]
    interval: Interval,
}

#[derive(Serialize)]
struct ImportanceDocument<'a> {
    name: &'a str,
    /// `null` where there is no design point.
    alpha: Option<f64>,
    alpha2: Option<f64>,
    omission: Option<f64>,
    /// `null` where it is the only random number.
    probability_if_known: Option<f64>,
}

#[derive(Serialize)]
struct LifeDocument {
    years: f64,
    not_rest: Interval,
    modes: Vec<ModeDocument>,
}

impl Probability {
    /// The answer as a JSON document, at full precision: of the least safe set of loads, and behind it of the others.
    pub fn json(&self) -> String {
        let [worst, others @ ..] = &self.situations[..] else { unreachable!("a case has loads") };
        crate::json(&Document {
            schema: SCHEMA,
            case: &self.case,
            seed: self.request.effort.seed,
            random: self.random.iter().map(|(name, cut)| RandomDocument { name, cut: *cut }).collect(),
            integrated: &self.line.0,
            worst: self.document(worst),
            others: others.iter().map(|chances| self.document(chances)).collect(),
        })
    }

    fn document<'a>(&'a self, chances: &'a Chances) -> ChancesDocument<'a> {
        let point = chances.design_point.as_ref();
        let names = || self.random.iter().map(|(name, _)| name.as_str());
        let importance = names().enumerate().map(|(place, name)| {
            let alpha = point.map(|point| point.alpha[place]);
            ImportanceDocument {
                name,
                alpha,
                alpha2: alpha.map(|alpha| alpha * alpha),
                omission: point.map(|point| point.omission(place)).filter(|omission| omission.is_finite()),
                probability_if_known: chances.known.get(place).map(|estimate| estimate.value),
            }
        });
        ChancesDocument {
            situation: chances.situation.as_deref(),
            method: chances.method.name(),
            points: chances.points,
            precise: chances.precise,
            modes: modes(&chances.modes),
            not_rest: interval(chances.not_rest),
            not_unique: interval(chances.not_unique),
            lifted: interval(chances.lifted),
            beta: point.map(|point| point.beta),
            beta_generalized: chances.generalized(),
            design_point: point.map(|point| names().zip(point.values.iter().copied()).collect()),
            at_change_of_formula: point.map(|point| point.at_change),
            importance: importance.collect(),
            life: chances.life.as_ref().map(|LifeChances { years, not_rest, modes: of_life }| LifeDocument {
                years: *years,
                not_rest: interval(*not_rest),
                modes: modes(of_life),
            }),
        }
    }
}

fn modes(modes: &[(Happening, Estimate)]) -> Vec<ModeDocument> {
    modes.iter().map(|(mode, e)| ModeDocument { mode: mode.name(), interval: interval(*e) }).collect()
}

fn interval(Estimate { value, low, high }: Estimate) -> Interval {
    Interval { probability: value, low, high }
}
