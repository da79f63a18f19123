//! The probabilities as a JSON document.

use std::collections::BTreeMap;

use serde::Serialize;
use standfast_probability::fit;
use standfast_probability::form::FormPoint;
use standfast_probability::sample::Estimate;
use standfast_probability::slopes::Slopes;

use super::{
    ChanceCriterion, Chances, Exceedance, Fit, Fragility, FragilityPoint, Happening, Overturning,
    PeakChances, Probability, Quantile, RandomNumber, Sliding,
};
use crate::json::SCHEMA;
use crate::json::number_or_word;
use crate::summary::Summary;

/// Every key is there in every answer, as docs/probability.schema.json has them: `null`, or an empty list, where there is no such
/// thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    case: &'a str,
    summary: Summary,
    seed: u64,
    random: Vec<RandomDocument<'a>>,
    /// The number that is integrated rather than drawn.
    integrated: &'a str,
    #[serde(flatten)]
    worst: ChancesDocument<'a>,
    /// The others, where the case has several sets of loads.
    others: Vec<ChancesDocument<'a>>,
    /// That any of several sets of loads moves the body.
    joined: Option<JoinedDocument>,
    /// That any of the bodies of a row moves.
    row: Option<RowDocument>,
    /// The criterion of `[criteria]` of which most is used.
    criterion: Option<CriterionDocument>,
    /// All of them, that one first.
    criteria: Vec<CriterionDocument>,
    /// Of a case with storms.
    sliding: Option<SlidingDocument>,
    /// Over the peak of a shaking, where that is asked for.
    overturning: Option<OverturningDocument<'a>>,
    /// Along a number, where that is asked for.
    fragility: Option<FragilityDocument<'a>>,
    /// The files of the figures that were written.
    figures: &'a [String],
}

#[derive(Serialize)]
struct FragilityDocument<'a> {
    name: &'a str,
    points: Vec<AlongDocument>,
    fit: Option<FitDocument>,
}

/// Bodies followed in time.
#[derive(Serialize)]
struct OverturningDocument<'a> {
    records: &'a [String],
    bodies: u64,
    not_a_body: u64,
    points: Vec<AtPeakDocument>,
    fit: Option<FitDocument>,
}

#[derive(Serialize)]
struct AtPeakDocument {
    /// m/s².
    peak: f64,
    moved: Interval,
    rocked: Interval,
    overturned: Interval,
}

impl OverturningDocument<'_> {
    fn of(overturning: &Overturning) -> OverturningDocument<'_> {
        let at = |at: &PeakChances| AtPeakDocument {
            peak: at.peak,
            moved: interval(at.moved),
            rocked: interval(at.rocked),
            overturned: interval(at.overturned),
        };
        let fit = overturning.fit.map(FitDocument::of);
        OverturningDocument {
            records: &overturning.records,
            bodies: overturning.bodies,
            not_a_body: overturning.not_a_body,
            points: overturning.points.iter().map(at).collect(),
            fit,
        }
    }
}

#[derive(Serialize)]
struct AlongDocument {
    value: f64,
    not_rest: Interval,
    modes: Vec<ModeDocument>,
    /// Of a case with criteria on a life or on slides.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    criteria: Vec<CriterionDocument>,
}

#[derive(Serialize)]
struct FitDocument {
    median: f64,
    dispersion: f64,
    misfit: f64,
}

impl FitDocument {
    fn of(Fit { median, dispersion, misfit }: Fit) -> FitDocument {
        FitDocument { median, dispersion, misfit }
    }
}

impl FragilityDocument<'_> {
    fn of(fragility: &Fragility) -> FragilityDocument<'_> {
        let along = |point: &FragilityPoint| AlongDocument {
            value: point.value,
            not_rest: interval(point.not_rest),
            modes: modes(&point.modes),
            criteria: point.criteria.iter().map(CriterionDocument::of).collect(),
        };
        let fit = fragility.fit.map(FitDocument::of);
        FragilityDocument { name: &fragility.name, points: fragility.points.iter().map(along).collect(), fit }
    }
}

#[derive(Serialize)]
struct JoinedDocument {
    count: usize,
    method: &'static str,
    not_rest: Interval,
}

/// The unsafe end of the interval counts.
#[derive(Serialize)]
struct CriterionDocument {
    name: &'static str,
    /// The slide that a probability is of, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    over: Option<f64>,
    required: f64,
    /// Infinite of an index where nothing ever moves.
    #[serde(serialize_with = "number_or_word")]
    value: f64,
    met: bool,
}

impl CriterionDocument {
    fn of(check: &ChanceCriterion) -> CriterionDocument {
        CriterionDocument {
            name: check.criterion.name(),
            over: check.criterion.over,
            required: check.required(),
            value: check.counted,
            met: check.is_met(),
        }
    }
}

/// Slides over a life of storms, m.
#[derive(Serialize)]
struct SlidingDocument {
    years: f64,
    /// Of each year's storm.
    waves: u64,
    /// Equal parts of a storm.
    parts: usize,
    /// The combination under which its waves come.
    combination: Option<String>,
    pulse: &'static str,
    lives: u64,
    mean: f64,
    mean_low: f64,
    mean_high: f64,
    precise: bool,
    /// Waves of a life that slide the body, on average.
    sliding_waves: f64,
    ever: Interval,
    quantiles: Vec<QuantileDocument>,
    exceedance: Vec<ExceededDocument>,
    /// The share of the mean that comes of the worst twentieth of all lives.
    of_worst_twentieth: f64,
    rotating: RotatingDocument,
    /// Outcome of the waves that begin a rotation, where they are followed in time.
    followed: Option<FollowedDocument>,
}

/// Of the lives drawn.
#[derive(Serialize)]
struct FollowedDocument {
    /// The mean slide that they add to a life, m.
    slide: f64,
    slide_low: f64,
    slide_high: f64,
    /// That a life ends by overturning.
    overturned: Interval,
}

#[derive(Serialize)]
struct QuantileDocument {
    share: f64,
    slide: f64,
    low: f64,
    high: f64,
}

#[derive(Serialize)]
struct ExceededDocument {
    slide: f64,
    #[serde(flatten)]
    interval: Interval,
}

/// Waves that begin a rotation, which the slides leave out: the chance of any wave, and that a life has one.
#[derive(Serialize)]
struct RotatingDocument {
    wave: Interval,
    life: Interval,
}

#[derive(Serialize)]
struct RandomDocument<'a> {
    name: &'a str,
    /// The share of its law that no body has, which was cut away.
    cut: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    fit: Option<FittedLawDocument>,
}

/// Law that was fitted to values.
#[derive(Serialize)]
struct FittedLawDocument {
    law: &'static str,
    number: usize,
    parameters: Vec<FittedParameterDocument>,
}

#[derive(Serialize)]
struct FittedParameterDocument {
    name: &'static str,
    estimate: f64,
    /// Of the logarithm, where that is said to be normal.
    standard_error: f64,
    of_logarithm: bool,
}

impl FittedLawDocument {
    fn of(fit: &fit::Fit) -> FittedLawDocument {
        let parameter = |of: &fit::FittedParameter| FittedParameterDocument {
            name: of.name,
            estimate: of.estimate,
            standard_error: of.deviation,
            of_logarithm: of.is_positive,
        };
        let parameters = fit.parameters.iter().map(parameter).collect();
        FittedLawDocument { law: fit.family.name(), number: fit.count, parameters }
    }
}

#[derive(Serialize)]
struct ChancesDocument<'a> {
    situation: Option<&'a str>,
    method: &'static str,
    integration_given_up: bool,
    points: u64,
    precise: bool,
    modes: Vec<ModeDocument>,
    not_rest: Interval,
    /// `null` of bodies on joints, of which it is not asked.
    not_unique: Option<Interval>,
    lifted: Interval,
    first_departure: DepartureDocument,
    /// The distance of the nearest point at which the body does not rest, in standard normals; `null` where none is within reach.
    beta: Option<f64>,
    /// −Φ⁻¹ of the probability; `null` where that is 0 or 1.
    beta_generalized: Option<f64>,
    design_point: Option<BTreeMap<&'a str, f64>>,
    at_change_of_formula: Option<bool>,
    importance: Vec<ImportanceDocument<'a>>,
    /// `null` unless they are asked for.
    design_points: Option<Vec<DesignPointDocument<'a>>>,
    /// `null` unless they are asked for.
    design_values: Option<DesignValuesDocument<'a>>,
    sensitivities: Option<Vec<SlopesDocument<'a>>>,
    life: Option<LifeDocument>,
}

/// Values of the numbers for a target index.
#[derive(Serialize)]
struct DesignValuesDocument<'a> {
    beta: f64,
    numbers: Vec<DesignValueDocument<'a>>,
}

#[derive(Serialize)]
struct DesignValueDocument<'a> {
    name: &'a str,
    alpha: f64,
    value: f64,
    fractile: f64,
    characteristic: f64,
    factor: Option<f64>,
}

#[derive(Serialize)]
struct Interval {
    probability: f64,
    low: f64,
    high: f64,
}

/// Into which mode it first leaves rest as the variable loads rise; the parts add up to one.
#[derive(Serialize)]
struct DepartureDocument {
    modes: Vec<ModeDocument>,
    never: Interval,
    at_once: Interval,
    precise: bool,
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
    /// Its interval; of one that was never met the bound above.
    if_known_low: Option<f64>,
    if_known_high: Option<f64>,
}

/// Point at which a mode is nearest to the medians, by FORM.
#[derive(Serialize)]
struct DesignPointDocument<'a> {
    mode: String,
    beta: f64,
    /// Φ(−β), which is not a probability of the mode.
    first_order: f64,
    point: BTreeMap<&'a str, f64>,
    alpha: BTreeMap<&'a str, f64>,
    at_change_of_formula: bool,
    /// Number of starts that led there, of how many.
    agreeing: usize,
    starts: usize,
}

#[derive(Serialize)]
struct LifeDocument {
    years: f64,
    events_per_year: Option<f64>,
    stood: Option<StoodDocument>,
    method: &'static str,
    precise: bool,
    not_rest: Interval,
    modes: Vec<ModeDocument>,
}

/// What mean and deviation of a number do.
#[derive(Serialize)]
struct SlopesDocument<'a> {
    name: &'a str,
    mean: Option<f64>,
    sd: Option<f64>,
    by_mean: Option<f64>,
    by_sd: Option<f64>,
}

impl<'a> SlopesDocument<'a> {
    fn of(name: &'a str, slopes: Option<&Slopes>) -> SlopesDocument<'a> {
        SlopesDocument {
            name,
            mean: slopes.map(|slopes| slopes.moments.mean),
            sd: slopes.map(|slopes| slopes.moments.sd),
            by_mean: slopes.and_then(|slopes| slopes.by_mean),
            by_sd: slopes.and_then(|slopes| slopes.by_sd),
        }
    }
}

/// That any of the bodies of a row moves.
#[derive(Serialize)]
struct RowDocument {
    bodies: u64,
    precise: bool,
    not_rest: Interval,
    life: Option<Interval>,
}

/// What years at rest say of those that follow.
#[derive(Serialize)]
struct StoodDocument {
    years: f64,
    not_rest: Interval,
}

/// Document with the files of figures that were written.
pub(super) fn json(answer: &Probability, figures: &[String]) -> String {
    let [worst, others @ ..] = &answer.situations[..] else { unreachable!("a case has loads") };
    crate::json::written(&Document {
        schema: SCHEMA,
        case: &answer.case,
        summary: super::summary::summary(answer),
        seed: answer.request.effort.seed,
        random: answer
            .random
            .iter()
            .map(|RandomNumber { name, cut, fit, .. }| RandomDocument {
                name,
                cut: *cut,
                fit: fit.as_ref().map(FittedLawDocument::of),
            })
            .collect(),
        integrated: &answer.line.0,
        worst: document(answer, worst),
        others: others.iter().map(|chances| document(answer, chances)).collect(),
        joined: answer.joined.map(|joined| JoinedDocument {
            count: joined.count,
            method: joined.method.name(),
            not_rest: interval(joined.not_rest),
        }),
        row: answer.row.map(|row| RowDocument {
            bodies: row.bodies,
            precise: row.precise,
            not_rest: interval(row.not_rest),
            life: row.life.map(interval),
        }),
        criterion: answer.criteria.first().map(CriterionDocument::of),
        criteria: answer.criteria.iter().map(CriterionDocument::of).collect(),
        sliding: answer.sliding.as_ref().map(SlidingDocument::of),
        overturning: answer.overturning.as_ref().map(OverturningDocument::of),
        fragility: answer.fragility.as_ref().map(FragilityDocument::of),
        figures,
    })
}

fn document<'a>(answer: &'a Probability, chances: &'a Chances) -> ChancesDocument<'a> {
    let point = chances.design_point.as_ref();
    let names = || answer.random.iter().map(|number| number.name.as_str());
    let importance = names().enumerate().map(|(place, name)| {
        let alpha = point.map(|point| point.alpha[place]);
        ImportanceDocument {
            name,
            alpha,
            alpha2: alpha.map(|alpha| alpha * alpha),
            omission: point.map(|point| point.omission(place)).filter(|omission| omission.is_finite()),
            probability_if_known: chances.known.get(place).map(|estimate| estimate.value),
            if_known_low: chances.known.get(place).map(|estimate| estimate.low),
            if_known_high: chances.known.get(place).map(|estimate| estimate.high),
        }
    });
    let named = |of: &[f64]| -> BTreeMap<&'a str, f64> { names().zip(of.iter().copied()).collect() };
    let of_mode = |(happening, point): &(Happening, FormPoint)| DesignPointDocument {
        mode: happening.name(),
        beta: point.beta,
        first_order: point.first_order(),
        point: named(&point.values),
        alpha: named(&point.alpha),
        at_change_of_formula: point.at_change,
        agreeing: point.agreeing,
        starts: point.starts,
    };
    ChancesDocument {
        situation: chances.situation.as_deref(),
        method: chances.method.name(),
        integration_given_up: chances.given_up,
        points: chances.points,
        precise: chances.precise,
        modes: modes(&chances.modes),
        not_rest: interval(chances.not_rest),
        not_unique: chances.not_unique.map(interval),
        lifted: interval(chances.lifted),
        first_departure: DepartureDocument {
            modes: modes(&chances.first_departure.modes),
            never: interval(chances.first_departure.never),
            at_once: interval(chances.first_departure.at_once),
            precise: chances.first_departure.precise,
        },
        beta: point.map(|point| point.beta),
        beta_generalized: chances.generalized(),
        design_point: point.map(|point| named(&point.values)),
        at_change_of_formula: point.map(|point| point.at_change),
        importance: importance.collect(),
        design_points: chances.design_points.as_ref().map(|points| points.iter().map(of_mode).collect()),
        design_values: chances.design_values.as_ref().map(|asked| DesignValuesDocument {
            beta: asked.beta,
            numbers: answer
                .random
                .iter()
                .zip(&asked.numbers)
                .map(|(number, design)| DesignValueDocument {
                    name: &number.name,
                    alpha: design.alpha,
                    value: design.value,
                    fractile: design.fractile,
                    characteristic: design.characteristic,
                    factor: design.factor,
                })
                .collect(),
        }),
        sensitivities: chances.slopes.as_ref().map(|slopes| {
            names().zip(slopes).map(|(name, slopes)| SlopesDocument::of(name, slopes.as_ref())).collect()
        }),
        life: chances.life.as_ref().map(|life| LifeDocument {
            years: life.years,
            events_per_year: life.events,
            stood: life
                .stood
                .map(|stood| StoodDocument { years: stood.years, not_rest: interval(stood.not_rest) }),
            method: life.method.name(),
            precise: life.precise,
            not_rest: interval(life.not_rest),
            modes: modes(&life.modes),
        }),
    }
}

impl SlidingDocument {
    fn of(sliding: &Sliding) -> SlidingDocument {
        let quantile = |quantile: &Quantile| {
            let Estimate { value, low, high } = quantile.slide;
            QuantileDocument { share: quantile.share, slide: value, low, high }
        };
        let exceeded = |exceeded: &Exceedance| ExceededDocument {
            slide: exceeded.slide,
            interval: interval(exceeded.probability),
        };
        SlidingDocument {
            years: sliding.years,
            waves: sliding.storm.waves,
            parts: sliding.storm.parts.len(),
            combination: sliding.storm.combination.clone(),
            pulse: sliding.storm.pulse.name(),
            lives: sliding.lives,
            mean: sliding.mean.value,
            mean_low: sliding.mean.low,
            mean_high: sliding.mean.high,
            precise: sliding.precise,
            sliding_waves: sliding.waves.value,
            ever: interval(sliding.ever),
            quantiles: sliding.quantiles.iter().map(quantile).collect(),
            exceedance: sliding.exceedance.iter().map(exceeded).collect(),
            of_worst_twentieth: sliding.of_worst,
            rotating: RotatingDocument {
                wave: interval(sliding.rotating.wave),
                life: interval(sliding.rotating.life),
            },
            followed: sliding.followed.map(|followed| FollowedDocument {
                slide: followed.slide.value,
                slide_low: followed.slide.low,
                slide_high: followed.slide.high,
                overturned: interval(followed.overturned),
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
