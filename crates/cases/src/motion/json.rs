//! The answer as JSON.

use super::{FollowedMotion, MotionWarning};
use crate::json::CheckEntry;
use serde::Serialize;
use standfast::Mode;
use standfast_answers::motion::{Copies, CopyQuantile, Extremes, PointAnswer, Spread, Strength};
use standfast_motion::End;
use standfast_motion::divergence::Divergence;
use standfast_motion::strength::{Change, VerdictStrength};
use standfast_probability::sample::Estimate;

use crate::summary::Summary;

/// Every key is there in every answer, as docs/simulate.schema.json has them: `null`, or an empty list, where there is no such thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    situation: Option<&'a str>,
    summary: Summary,
    end: &'static str,
    slide: f64,
    max_slide: f64,
    t_max_slide: f64,
    max_theta: f64,
    t_max_theta: f64,
    max_theta_of_balance: f64,
    theta: f64,
    overturned: bool,
    past_balance: bool,
    at_rest: bool,
    impact: ImpactEntry,
    impacts: usize,
    bounces: usize,
    max_gap: f64,
    t_max_gap: f64,
    t_rest: Option<f64>,
    t_rest_is_bound: bool,
    t_final: f64,
    loads_end: f64,
    work: f64,
    friction_loss: f64,
    impact_loss: f64,
    kinetic: f64,
    potential: f64,
    energy_residual: f64,
    unique: bool,
    divergence: Option<DivergenceEntry>,
    sensitivity: Option<f64>,
    strength: Option<StrengthEntry>,
    copies: Option<CopiesEntry>,
    points: Vec<PointEntry<'a>>,
    met: Option<bool>,
    criteria: Vec<CheckEntry>,
    events: Vec<EventEntry<'a>>,
    warnings: Vec<WarningEntry<'a>>,
    figures: &'a [String],
    others: Vec<Document<'a>>,
}

/// The law of impacts, its restitution, and the ratio used of a law that has one.
#[derive(Serialize)]
struct ImpactEntry {
    law: &'static str,
    e: f64,
    ratio: Option<f64>,
}

#[derive(Serialize)]
struct DivergenceEntry {
    value: f64,
    t: f64,
    of: &'static str,
}

impl From<Divergence> for DivergenceEntry {
    fn from(Divergence { value, t, of, .. }: Divergence) -> DivergenceEntry {
        DivergenceEntry { value, t, of: of.word() }
    }
}

/// Outcomes of copies with numbers a little other.
#[derive(Serialize)]
struct CopiesEntry {
    number: usize,
    spread: Option<f64>,
    spreads: Vec<f64>,
    seed: u64,
    names: Vec<String>,
    cut: usize,
    overturned: usize,
    no_continuation: usize,
    time_up: usize,
    share: ShareEntry,
    same_verdict: ShareEntry,
    max_theta: Vec<QuantileEntry>,
    slide: Vec<QuantileEntry>,
    max_slide: Vec<QuantileEntry>,
    differs: Option<DiffersEntry>,
}

/// Share of copies with its interval of 95 %.
#[derive(Serialize)]
struct ShareEntry {
    value: f64,
    low: f64,
    high: f64,
}

/// Quantile over copies; `null` where that copy has overturned, and of an interval where there are too few.
#[derive(Serialize)]
struct QuantileEntry {
    share: f64,
    value: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
}

/// Earliest events that differ from those of the case: the place in its list, and the time; the median over copies, and the least.
#[derive(Serialize)]
struct DiffersEntry {
    copies: usize,
    event: usize,
    least_event: usize,
    t: f64,
    least_t: f64,
}

impl CopiesEntry {
    fn of(copies: &Copies) -> CopiesEntry {
        let share = |Estimate { value, low, high }: Estimate| ShareEntry { value, low, high };
        let quantiles = |of: Vec<CopyQuantile>| {
            let finite = |value: f64| Some(value).filter(|value| value.is_finite());
            let entry = |one: CopyQuantile| QuantileEntry {
                share: one.share,
                value: finite(one.value),
                low: one.interval.and_then(|[low, _]| finite(low)),
                high: one.interval.and_then(|[_, high]| finite(high)),
            };
            of.into_iter().map(entry).collect()
        };
        CopiesEntry {
            number: copies.rows.len(),
            spread: match copies.asked.spread {
                Spread::Even(spread) => Some(spread),
                Spread::Named(_) => None,
            },
            spreads: copies.spreads.clone(),
            seed: copies.asked.seed,
            names: copies.names.clone(),
            cut: copies.cut,
            overturned: copies.overturning(),
            no_continuation: copies.ended(End::NoContinuation.word()),
            time_up: copies.ended(End::Time.word()),
            share: share(copies.overturned),
            same_verdict: share(copies.same_verdict),
            max_theta: quantiles(copies.max_theta()),
            slide: quantiles(copies.slide()),
            max_slide: quantiles(copies.max_slide()),
            differs: copies.differs.map(|differs| DiffersEntry {
                copies: differs.copies,
                event: differs.place[0],
                least_event: differs.place[1],
                t: differs.t[0],
                least_t: differs.t[1],
            }),
        }
    }
}

#[derive(Serialize)]
struct StrengthEntry {
    onset: Option<f64>,
    overturning: VerdictEntry,
    slide: Option<VerdictEntry>,
    max_theta: Option<VerdictEntry>,
    range: [f64; 2],
    tried: Vec<TriedEntry>,
}

/// A verdict over the factors that were tried; of a slide with the bound.
#[derive(Serialize)]
struct VerdictEntry {
    required: Option<f64>,
    verdict: bool,
    up: Option<ChangeEntry>,
    down: Option<ChangeEntry>,
    share: [f64; 3],
    windows: bool,
}

#[derive(Serialize)]
struct ChangeEntry {
    factor: f64,
    from: f64,
    to: f64,
}

#[derive(Serialize)]
struct TriedEntry {
    factor: f64,
    overturned: bool,
    max_theta: f64,
    slide: f64,
}

impl StrengthEntry {
    fn of(strength: &Strength) -> StrengthEntry {
        let tried = strength.tried.iter().map(|tried| TriedEntry {
            factor: tried.factor,
            overturned: tried.overturned,
            max_theta: tried.max_theta,
            slide: tried.slide,
        });
        let tried: Vec<TriedEntry> = tried.collect();
        let ends = [tried.first(), tried.last()].map(|end| end.map_or(1.0, |tried| tried.factor));
        StrengthEntry {
            onset: strength.onset,
            overturning: VerdictEntry::of(&strength.overturning, None),
            slide: strength.slide.as_ref().map(|(bound, verdict)| VerdictEntry::of(verdict, Some(*bound))),
            max_theta: strength
                .max_theta
                .as_ref()
                .map(|(bound, verdict)| VerdictEntry::of(verdict, Some(*bound))),
            range: ends,
            tried,
        }
    }
}

impl VerdictEntry {
    fn of(found: &VerdictStrength, required: Option<f64>) -> VerdictEntry {
        let change = |change: Option<Change>| {
            let rising = |change: Change| [change.factor.min(change.same), change.factor.max(change.same)];
            change.map(|change| {
                let [from, to] = rising(change);
                ChangeEntry { factor: change.factor, from, to }
            })
        };
        VerdictEntry {
            required,
            verdict: found.verdict,
            up: change(found.up),
            down: change(found.down),
            share: found.share,
            windows: found.windows,
        }
    }
}

/// A point of the body: extremes of its accelerations, between impacts.
#[derive(Serialize)]
struct PointEntry<'a> {
    name: &'a str,
    at: [f64; 2],
    a_x: ExtremesEntry,
    a_y: ExtremesEntry,
    f_along: ExtremesEntry,
    f_up: ExtremesEntry,
}

#[derive(Serialize)]
struct ExtremesEntry {
    least: f64,
    t_least: f64,
    largest: f64,
    t_largest: f64,
}

impl<'a> PointEntry<'a> {
    fn of(answer: &'a PointAnswer) -> PointEntry<'a> {
        let entry = |Extremes { least: [least, t_least], largest: [largest, t_largest] }: Extremes| {
            ExtremesEntry { least, t_least, largest, t_largest }
        };
        let [a_x, a_y, f_along, f_up] = answer.extremes.map(entry);
        PointEntry { name: &answer.point.name, at: answer.point.at, a_x, a_y, f_along, f_up }
    }
}

#[derive(Serialize)]
struct EventEntry<'a> {
    t: f64,
    why: &'static str,
    state: &'static str,
    also: Vec<&'static str>,
    jumps: Vec<JumpEntry<'a>>,
}

/// Jump of a point's velocity at an impact.
#[derive(Serialize)]
struct JumpEntry<'a> {
    point: &'a str,
    jump_vx: f64,
    jump_vy: f64,
}

#[derive(Serialize)]
pub(super) struct WarningEntry<'a> {
    name: &'a str,
    message: &'a str,
}

impl<'a> From<&'a MotionWarning> for WarningEntry<'a> {
    fn from(warning: &'a MotionWarning) -> WarningEntry<'a> {
        WarningEntry { name: warning.name, message: &warning.words }
    }
}

fn document<'a>(followed: &'a FollowedMotion) -> Document<'a> {
    let (case, outcome) = (&followed.case, &followed.outcome);
    let jumps = |event: usize| {
        let of = |answer: &'a PointAnswer| {
            let (_, [jump_vx, jump_vy]) = *answer.jumps.iter().find(|(place, _)| *place == event)?;
            Some(JumpEntry { point: &answer.point.name, jump_vx, jump_vy })
        };
        followed.points.iter().filter_map(of).collect()
    };
    let events = outcome.events.iter().enumerate().map(|(place, event)| EventEntry {
        t: event.t,
        why: event.why.word(),
        state: event.state.symbol(),
        also: event.consistent.without(Some(event.state)).iter().map(Mode::symbol).collect(),
        jumps: jumps(place),
    });
    let warnings = followed.warnings.iter();
    Document {
        schema: 1,
        title: case.title.as_deref(),
        situation: case.situation.as_deref(),
        summary: super::summary::of(followed, 1),
        end: outcome.end.word(),
        slide: outcome.slide,
        max_slide: outcome.max_slide,
        t_max_slide: outcome.t_max_slide,
        max_theta: outcome.max_theta,
        t_max_theta: outcome.t_max_theta,
        max_theta_of_balance: followed.of_balance(),
        theta: outcome.theta,
        overturned: outcome.overturned(),
        past_balance: outcome.past_balance,
        at_rest: outcome.at_rest(),
        impact: ImpactEntry {
            law: case.problem.impact.word(),
            e: case.problem.restitution,
            ratio: case.problem.ratio(),
        },
        impacts: outcome.impacts,
        bounces: outcome.bounces,
        max_gap: outcome.max_gap,
        t_max_gap: outcome.t_max_gap,
        t_rest: outcome.t_rest,
        t_rest_is_bound: outcome.t_rest_is_bound,
        t_final: outcome.t_final,
        loads_end: outcome.loads_end,
        work: outcome.work,
        friction_loss: outcome.friction_loss,
        impact_loss: outcome.impact_loss,
        kinetic: outcome.kinetic,
        potential: outcome.potential,
        energy_residual: outcome.energy_residual(),
        unique: outcome.unique,
        divergence: followed.divergence.map(DivergenceEntry::from),
        // A name of before, with the number of now.
        sensitivity: followed.divergence.map(|divergence| divergence.value),
        strength: followed.strength.as_ref().map(StrengthEntry::of),
        copies: followed.copies.as_ref().map(CopiesEntry::of),
        points: followed.points.iter().map(PointEntry::of).collect(),
        met: followed.met(),
        criteria: followed.checks().iter().map(CheckEntry::of_motion).collect(),
        events: events.collect(),
        warnings: warnings.map(WarningEntry::from).collect(),
        figures: &[],
        others: Vec::new(),
    }
}

/// The answers to a case's situations as one JSON document: that of the first, with the `others` in it, and the files of its figures.
pub(super) fn render(answers: &[FollowedMotion], figures: &[String]) -> String {
    let mut documents = answers.iter().map(document);
    let Some(mut first) = documents.next() else { return crate::json::written(&Vec::<()>::new()) };
    first.others = documents.collect();
    first.figures = figures;
    crate::json::written(&first)
}
