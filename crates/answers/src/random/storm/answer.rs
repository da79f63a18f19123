//! Slides of the body over a life of storms.

use standfast_probability::life::Life;
use standfast_probability::problem::RandomVector;
use standfast_probability::sample::{Effort, Estimate};
use standfast_probability::sums::{LifeSums, Lives, expected, lives};
use standfast_watch::Portion;
use thiserror::Error;

use super::{Slides, Storm, Storms};
use crate::explained::Explained;
use crate::key::Key;
use crate::random::answer::ChanceRequest;

/// Slides over a life of storms, one a year; m.
#[derive(Debug, Clone, PartialEq)]
pub struct Sliding {
    /// The storm.
    pub storm: Storm,
    /// True if the base may crush, or the ground fail: waves under which it does are counted with those that begin a rotation.
    pub gives_way: bool,
    /// The years.
    pub years: f64,
    /// The mean over lives, integrated.
    pub mean: Estimate,
    /// True if the mean is as precise as it is asked to be.
    pub precise: bool,
    /// The chance that a wave of any storm slides the body, integrated.
    pub wave: Estimate,
    /// The mean number of waves of a life that do.
    pub waves: Estimate,
    /// Number of lives drawn.
    pub lives: u64,
    /// That any wave of a life slides the body.
    pub ever: Estimate,
    /// Slides that shares of all lives stay below.
    pub quantiles: Vec<Quantile>,
    /// The chance that the slide of a life exceeds a value.
    pub exceedance: Vec<Exceedance>,
    /// Chances of exceeding slides between the least and the greatest that can be told, by equal factors.
    pub course: Vec<Exceedance>,
    /// The share of the mean that comes of the worst twentieth of all lives.
    pub of_worst: f64,
    /// The mean over the lives drawn: not the answer, but a check of both.
    pub drawn: Estimate,
    /// Outcome of waves that begin a rotation, where they are followed in time.
    pub followed: Option<FollowedWaves>,
    /// Waves that begin a rotation, for which the slide of a pulse says nothing.
    pub rotating: RotatingWaves,
}

/// A slide that a share of all lives stays below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantile {
    /// The share.
    pub share: f64,
    /// The slide, m.
    pub slide: Estimate,
}

/// The chance that the slide of a life exceeds a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exceedance {
    /// The value, m.
    pub slide: f64,
    /// The chance.
    pub probability: Estimate,
}

/// Outcome of waves that begin a rotation, followed in time; of the lives drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedWaves {
    /// The mean slide that they add to a life, m.
    pub slide: Estimate,
    /// That a life ends by overturning.
    pub overturned: Estimate,
}

/// Waves that begin a rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotatingWaves {
    /// The chance that a wave of any storm is one.
    pub wave: Estimate,
    /// That a life has one.
    pub life: Estimate,
}

/// Reason why there are no slides.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SlidingError {
    /// No waves.
    #[error("the case has a [storm] and no [wave] by Goda's formulas")]
    NoWaves,
    /// Rotations followed on a base that gives way.
    #[error(
        "waves that begin a rotation cannot be followed in time on a [ground] that crushes or fails under them"
    )]
    Ground,
    /// More than one set of loads.
    #[error("the case has a [storm] and leaves a choice of loads{}", of_names(combinations))]
    Choice {
        /// Its combinations.
        combinations: Vec<String>,
    },
    /// Several accelerations of the base, or loads that act one by one.
    #[error("the case has a [storm] and leaves a choice of loads: an earthquake's, or loads that act alone")]
    Shaken,
    /// A combination that is not there.
    #[error(
        "`combination` of [storm] is \"{asked}\"{}",
        if combinations.is_empty() { ", and the case has none".to_owned() } else { of_names(combinations) }
    )]
    NoCombination {
        /// The name asked for.
        asked: String,
        /// Combinations that there are.
        combinations: Vec<String>,
    },
    /// A combination whose factors are not on the waves' forces alone.
    #[error(
        "storms cannot come under {}: its factors act on effects, or waves that begin a rotation would be followed without them",
        name.as_ref().map_or_else(|| "this combination".to_owned(), |name| format!("the combination \"{name}\""))
    )]
    Combination {
        /// Its name, where it is asked for.
        name: Option<String>,
    },
    /// Levels over a storm, beside one that a combination sets.
    #[error("[storm] has `level_rises`, and its combination sets `{name}`")]
    SetLevel {
        /// The key that it sets.
        name: String,
    },
    /// Levels over a storm, beside a random one that would not go along.
    #[error("[storm] has `level_rises`, and `{name}` is random: make `water_level` random in its place")]
    OtherLevel {
        /// The random number.
        name: String,
    },
    /// A part of a storm in which the numbers do not go together.
    #[error(
        "part {part} of [storm], with its height_factors and level_rises, makes no case at the medians of the random numbers"
    )]
    Part {
        /// Its number, from one.
        part: usize,
    },
    /// Levels over a storm, of a case without a level.
    #[error("[storm] has `level_rises`, and the case has no water level")]
    NoLevel,
    /// Two frictions.
    #[error(
        "friction to slip is {kinetic} and to stick {friction}: pulse = \"shimosako\" takes one friction"
    )]
    TwoFrictions {
        /// To slip.
        kinetic: f64,
        /// To stick.
        friction: f64,
    },
    /// A storm without a body that could turn.
    #[error("there is nothing to be followed in time: a [storm] without a [body] has no rotations")]
    NoTurns,
    /// A moment that no force of the wave has.
    #[error(
        "waves that begin a rotation cannot be followed in time with `{name}`, which gives a wave another moment than its pressures have"
    )]
    BiasOfMoment {
        /// The random number.
        name: String,
    },
    /// A row of bodies of a storm without a body.
    #[error("the file is of a [storm] without a [body], and `bodies` asks for any of several")]
    NoRow,
    /// Something of modes that is asked of a storm without a body.
    #[error("there is nothing that `{key}` is of: a [storm] without a [body] has no modes")]
    NoModes {
        /// Key of `[random]`.
        key: &'static str,
    },
    /// Years before the life.
    #[error("the case has a [storm] and `survived`: what years at rest say of slides is not found")]
    Survived,
    /// No whole number of years.
    #[error("storms over {years} years; expected a whole number, because they come once a year")]
    PartOfYear {
        /// The years.
        years: f64,
    },
}

impl SlidingError {
    /// Key of `[storm]` that is to blame.
    pub(in crate::random) fn key(&self) -> Option<Key> {
        match self {
            SlidingError::NoCombination { .. } | SlidingError::Combination { name: Some(_) } => {
                Some(Key::StormCombination)
            }
            SlidingError::NoLevel | SlidingError::SetLevel { .. } | SlidingError::OtherLevel { .. } => {
                Some(Key::StormRises)
            }
            _ => None,
        }
    }
}

impl Explained for SlidingError {
    fn help(&self) -> Option<String> {
        let help = match self {
            SlidingError::NoWaves => {
                "leave [body] out for a storm whose thrust is in proportion to the wave's height".into()
            }
            SlidingError::Choice { combinations } => {
                let name = combinations.first().map_or("…", String::as_str);
                format!("say under which its waves come: combination = \"{name}\" in [storm]")
            }
            SlidingError::Shaken => {
                "storms are answered for loads that all act together, or for one combination".into()
            }
            SlidingError::BiasOfMoment { .. } => "leave it out, or have rotations counted".into(),
            SlidingError::Ground => "leave `--rotations simulate` out: they are counted then".into(),
            _ => return None,
        };
        Some(help)
    }
}

/// Words for the combinations that there are.
fn of_names(names: &[String]) -> String {
    match names {
        [] => String::new(),
        names => format!("; its combinations are {}", names.join(", ")),
    }
}

impl Sliding {
    /// Words for the storm: its waves, its parts, and the combination under which they come.
    pub fn storm_words(&self) -> String {
        let Storm { waves, parts, combination, .. } = &self.storm;
        let mut words = format!("a storm of {waves} waves each");
        if parts.len() > 1 {
            words += &format!(", in {} equal parts", parts.len());
        }
        if let Some(name) = combination {
            words += &format!(", under {name}");
        }
        words
    }

    /// Words for waves that are left out of the slides.
    pub fn left_out_words(&self) -> &'static str {
        if self.gives_way {
            "Waves that begin a rotation, or under which the base gives way,"
        } else {
            "Waves that begin a rotation"
        }
    }
}

/// The shares of lives whose slides are told.
const SHARES: [f64; 6] = [0.05, 0.25, 0.5, 0.75, 0.95, 0.99];
/// The slides whose exceedance is told, m: practice speaks of 0.10 and 0.30.
const EXCEEDED: [f64; 2] = [0.10, 0.30];
/// Share of all lives that counts as the worst.
const WORST: f64 = 0.05;
/// The mean is a smooth integral, and quick to have to this.
const PRECISION: f64 = 2e-3;

/// A tenth of a millimetre is not a slide that anybody sees.
const LEAST: f64 = 1e-4;
/// Number of slides in a decade in the course of the exceedance.
const EACH_DECADE: f64 = 16.0;

/// The chance that the slide of a life exceeds slides by equal factors, up to the greatest that was drawn.
fn course(drawn: &Lives) -> Vec<Exceedance> {
    let greatest = drawn.groups.iter().flatten().map(|life| life.sum + life.other_sum).fold(0.0, f64::max);
    if greatest <= LEAST {
        return Vec::new();
    }
    let count = (EACH_DECADE * (greatest / LEAST).log10()).ceil();
    let slide = |i: usize| LEAST * (greatest / LEAST).powf(i as f64 / count);
    let exceeded = |slide: f64| Exceedance {
        slide,
        probability: drawn.chance(|life| life.ended || life.sum + life.other_sum > slide),
    };
    // Nothing exceeds the greatest.
    (0..count as usize).map(slide).map(exceeded).collect()
}

/// That it slides at all may be so much less precise: how far is what counts.
const AT_ALL: f64 = 4.0;

/// True if a chance is met, or so unlikely that more lives would tell little.
fn is_told(chance: &Estimate) -> bool {
    const UNLIKELY: f64 = 1e-3;
    chance.value > 0.0 || chance.high <= UNLIKELY
}

/// At most about so many waves are followed in time.
const MOST_FOLLOWED: f64 = 1e5;

/// The slides of storms with these laws.
pub(in crate::random) fn sliding<S: Storms>(
    storm: &Storm,
    storms: &S,
    laws: &RandomVector,
    life: &Life,
    (request, over): (&ChanceRequest, &[f64]),
    portion: Portion<'_>,
) -> Result<Sliding, SlidingError> {
    let mut told: Vec<f64> = EXCEEDED.iter().chain(over).copied().collect();
    told.sort_by(f64::total_cmp);
    told.dedup();
    let effort = &request.effort;
    let years = life.years;
    if years.fract() != 0.0 && life.events.is_none() {
        return Err(SlidingError::PartOfYear { years });
    }
    let slides = Slides(storms);
    let smooth = Effort { precision: effort.precision.min(PRECISION), ..*effort };
    let [of_mean, of_lives] = portion.parts([1.0, 9.0]);
    let means = expected(laws, &slides, storm.waves as f64, smooth.within(of_mean));
    let [mean, moving, turning] = means.estimates[..] else { unreachable!("three means") };
    let times = |e: Estimate, by: f64| Estimate { value: e.value * by, low: e.low * by, high: e.high * by };
    // As many lives as leave so many waves to be followed in time.
    let to_follow = turning.value * storm.waves as f64 * effort.points as f64;
    let fewer = if request.follow { (to_follow / MOST_FOLLOWED).max(1.0) } else { 1.0 };
    let drawn_effort = Effort { points: (effort.points as f64 / fewer) as u64, ..*effort };
    // A body that lies on its side has slid too far.
    let slid_in = |drawn: &Lives, more: f64| {
        drawn.chance(|life: &LifeSums| life.ended || life.sum + life.other_sum > more)
    };
    let are_enough = |drawn: &Lives| {
        let precise = |more: f64, precision: f64| {
            let chance = slid_in(drawn, more);
            chance.is_precise(precision, effort.floor) && is_told(&chance)
        };
        told.iter().all(|more| precise(*more, effort.precision)) && precise(0.0, AT_ALL * effort.precision)
    };
    let drawn = lives(laws, &slides, storm.waves, life, drawn_effort.within(of_lives), are_enough);
    let slid = |more: f64| slid_in(&drawn, more);
    Ok(Sliding {
        storm: storm.clone(),
        gives_way: storms.gives_way(),
        years,
        // Where nothing was met the bound is one of a chance, and no slide follows from it.
        mean: if mean.value == 0.0 { Estimate { high: 0.0, ..mean } } else { times(mean, life.times()) },
        precise: means.precise,
        wave: Estimate { high: moving.high.min(1.0), ..moving },
        waves: times(moving, life.times() * storm.waves as f64),
        lives: drawn.count() as u64,
        ever: slid(0.0),
        quantiles: SHARES.map(|share| Quantile { share, slide: drawn.quantile(share) }).to_vec(),
        exceedance: told.iter().map(|&slide| Exceedance { slide, probability: slid(slide) }).collect(),
        course: course(&drawn),
        of_worst: drawn.of_worst(WORST),
        drawn: drawn.mean(|life| life.sum),
        followed: request.follow.then(|| FollowedWaves {
            slide: drawn.mean(|life| life.other_sum),
            overturned: drawn.chance(|life| life.ended),
        }),
        rotating: RotatingWaves {
            wave: Estimate { high: turning.high.min(1.0), ..turning },
            life: drawn.chance(|life| life.others > 0),
        },
    })
}
