//! Outcomes on a base seen from above: whether the body rests, and if not, what ends rest as the variable loads rise.

use standfast::footprint::{BaseWrench, Footprint, PlanDeparture, PlanLimit};
use standfast_probability::problem::Pieces;

use super::departure::{AT_ONCE, NEVER};
use super::outcome::{FLIGHT, LIFTED, NOT_A_BODY, PLAN_SLIDES, PLAN_TIPS, REST, nothing};
use super::problem::{ChanceProblem, Line};
use super::stack::{Asked, between};

/// A body on its base: where it bears, its friction, and its permanent and variable loads.
#[derive(Debug, Clone)]
struct OnPlan {
    footprint: Footprint,
    friction: f64,
    permanent: BaseWrench,
    variable: BaseWrench,
}

impl OnPlan {
    fn departure(&self, friction: f64) -> Option<PlanDeparture> {
        self.footprint.departure(friction, &self.permanent, &self.variable).ok()
    }

    fn at(&self, factor: f64) -> BaseWrench {
        self.permanent.plus(self.variable.times(factor))
    }

    /// The outcomes with a friction, a bit for each.
    fn outcomes(&self, friction: f64, asked: Asked) -> u64 {
        let Some(departure) = self.departure(friction) else { return 1 << NOT_A_BODY };
        let ended = departure.limits.first().map(|limit| match limit {
            PlanLimit::Slides | PlanLimit::Turns => PLAN_SLIDES,
            PlanLimit::Tips { .. } => PLAN_TIPS,
            PlanLimit::Lifts => FLIGHT,
        });
        match asked {
            Asked::Full => {
                let ended = if departure.rests { REST } else { ended.unwrap_or(PLAN_TIPS) };
                1 << ended | u64::from(self.at(1.0).p <= 0.0) << LIFTED
            }
            Asked::Departure if departure.at_once || departure.load_factor == 0.0 => 1 << AT_ONCE,
            Asked::Departure => 1 << ended.filter(|_| departure.load_factor.is_finite()).unwrap_or(NEVER),
        }
    }

    /// The outcomes along friction: what it takes to hold the body rises or falls with λ but has no greatest value between, so that it counts
    /// under no and under all variable loads, under endless ones, and where the body tips or is lifted.
    fn along_friction(&self, asked: Asked, pieces: &mut Pieces) {
        let held = self.footprint.departure_held(&self.permanent, &self.variable);
        let Ok(held) = held else { return nothing(pieces) };
        let needed = |wrench: &BaseWrench| self.footprint.on_friction(wrench) / wrench.p;
        let factors = [0.0, 1.0, held.load_factor];
        let at = factors.map(|factor| needed(&self.at(factor))).into_iter().chain([needed(&self.variable)]);
        between(at.collect(), pieces, |friction| self.outcomes(friction.max(0.0), asked));
    }
}

impl ChanceProblem {
    /// The body with these values of all numbers; none if they do not go together.
    fn plan_with(&self, values: &[f64]) -> Option<OnPlan> {
        let situation = self.situation_with(values)?;
        let [permanent, variable] = situation.base_wrenches()?;
        let apart = (0..values.len()).find(|place| self.is_apart(*place));
        let friction = apart.map_or(situation.static_friction(), |place| values[place]);
        Some(OnPlan { footprint: situation.plan()?.footprint.clone(), friction, permanent, variable })
    }

    /// The outcomes on a base seen from above with these values, a bit for each.
    pub(super) fn on_plan(&self, values: &[f64], asked: Asked) -> u64 {
        self.plan_with(values).map_or(1 << NOT_A_BODY, |plan| plan.outcomes(plan.friction, asked))
    }

    /// The outcomes on a base seen from above along the line.
    pub(super) fn plan_along(&self, values: &[f64], asked: Asked, pieces: &mut Pieces) {
        let at = |place: usize, value: f64| {
            let mut values = values.to_vec();
            values[place] = value;
            self.plan_with(&values)
        };
        match self.line {
            Line::Friction(place) => match at(place, 1.0) {
                Some(plan) => plan.along_friction(asked, pieces),
                None => nothing(pieces),
            },
            // Loads that are linear in a number are not assembled again for another value of it.
            Line::Load(place) => {
                let (Some(zero), Some(one)) = (at(place, 0.0), at(place, 1.0)) else {
                    return nothing(pieces);
                };
                let grown = |zero: BaseWrench, one: BaseWrench, value: f64| {
                    zero.plus(one.plus(zero.times(-1.0)).times(value))
                };
                self.scan(place, values, pieces, |values| {
                    let permanent = grown(zero.permanent, one.permanent, values[place]);
                    let variable = grown(zero.variable, one.variable, values[place]);
                    OnPlan { permanent, variable, ..zero.clone() }.outcomes(zero.friction, asked)
                });
            }
            Line::Scan(place) => self.scan(place, values, pieces, |values| self.on_plan(values, asked)),
        }
    }
}
