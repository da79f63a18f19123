//! A situation whose base is seen from above: rest under loads of any horizontal direction.
//!
//! The body keeps its section in the plane; what a load has out of it is its [`Across`]. All are carried over to the point of the base under the
//! centre of mass and decided on the [`Footprint`].

use crate::approx::Approx;
use crate::ball::{Ball, Scalar};
use crate::departure::Departure;
use crate::error::InputError;
use crate::exact::Real;
use crate::footprint::{BaseWrench, Footprint, PlanDeparture, Problem, Torsion};
use crate::loads::{Action, Load};
use crate::mode::Modes;
use crate::quantity::{Expected, Quantity};
use crate::stability::{Bearing, GrossOverturning, Margins, Stability, ratio};
use crate::verdict::Verdict;
use crate::wrench::Wrench;

use super::{Outcome, Response, SUMMED, Situation};

/// A base seen from above, under a body whose section lies in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanBase<T = f64> {
    /// Where the body bears, from the point under its centre of mass.
    pub footprint: Footprint<T>,
    /// The centre of mass, away from the middle of the length, m.
    pub centroid_z: T,
}

/// The answer of a base seen from above.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOutcome {
    /// The departure from rest as the variable loads rise, and whether the body rests under all.
    pub departure: PlanDeparture,
    /// All loads under the full load.
    pub full: BaseWrench,
    /// The edge with the least factor against overturning, from zero; `None` where nothing turns the body.
    pub edge: Option<usize>,
}

impl Response {
    /// Of a base seen from above: what begins there is not found.
    pub(super) fn unknown(wrench: Wrench) -> Response {
        let (verdict, modes) = (None, Modes::default());
        Response { wrench, verdict, modes, effective: None, motion: None, boundary: None }
    }
}

impl<T: Scalar> Situation<T> {
    /// Situation on a base seen from above, which takes loads of any horizontal direction. Its [outcome](Situation::outcome) has its rest; what
    /// begins beyond has no mode, no path and no region.
    pub fn with_plan(self, plan: PlanBase<T>) -> Situation<T> {
        Situation { plan: Some(plan), written: None, ..self }
    }

    /// Its base as seen from above, where that is described.
    pub fn plan(&self) -> Option<&PlanBase<T>> {
        self.plan.as_ref()
    }

    /// Forces and moments of a load at the point of the base under the centre of mass, the vertical ones apart.
    fn at_base(&self, plan: &PlanBase<T>, load: &Load<T>) -> [BaseWrench<T>; 2] {
        let (body, wrench) = (&self.body, self.wrench_of(load));
        let zero = || T::of(0.0);
        let z = load.across.as_ref().and_then(|across| across.z.clone());
        let z = z.map_or_else(zero, |z| z - plan.centroid_z.clone());
        let (x, y) = match &load.action {
            Action::Force { at, .. } => (at.x.clone() - body.centroid_offset(), at.y.clone()),
            _ => (zero(), body.centroid_height()),
        };
        let away = self.away(load);
        // Of the section's moment about C the push has d X, and what remains is the vertical part's.
        let push = BaseWrench::force_at([wrench.x.clone(), away], zero(), [x, y, z.clone()]);
        let of_weight = body.centroid_height() * wrench.x - wrench.m - push.q_x.clone();
        let vertical =
            BaseWrench { q_x: of_weight, q_z: z * wrench.p.clone(), p: wrench.p, ..BaseWrench::zero() };
        [push, vertical]
    }

    /// The forces and moments of a load at the point of the base under the centre of mass, those of its vertical forces behind; `None` without a plan.
    pub fn base_wrench_of(&self, load: &Load<T>) -> Option<[BaseWrench<T>; 2]> {
        Some(self.at_base(self.plan.as_ref()?, load))
    }

    /// The force of a load away from the viewer of the section, N.
    pub fn away(&self, load: &Load<T>) -> T {
        let away = load.across.as_ref().map_or_else(|| T::of(0.0), |across| across.away.clone());
        let away = match &load.action {
            Action::Inertia { .. } => T::of(0.0) - self.body.mass() * away,
            _ => away,
        };
        away * load.factor.clone()
    }

    /// The problem of rest on its base, with the sizes of what its sums are made of.
    fn on_plan(&self, plan: &PlanBase<T>) -> (Problem<T>, [BaseWrench; 2]) {
        let mut sums = [BaseWrench::zero(), BaseWrench::zero()];
        let mut sizes = [BaseWrench::zero(), BaseWrench::zero()];
        for load in &self.loads {
            let place = usize::from(!load.permanent);
            for part in self.at_base(plan, load) {
                sizes[place] = sizes[place].plus(part.map(|number| number.value().abs()));
                sums[place] = sums[place].clone().plus(part);
            }
        }
        let [permanent, variable] = sums;
        let friction = self.static_friction();
        (Problem { footprint: plan.footprint.clone(), friction, permanent, variable }, sizes)
    }

    /// The same, of numbers that decide.
    pub(super) fn problem_on_plan(&self) -> Option<Problem<T>> {
        self.plan.as_ref().map(|plan| self.on_plan(plan).0)
    }
}

impl Situation {
    /// The moment about the vertical through the centre of pressure that the loads have, where the base has no one answer to that.
    pub fn torsion(&self) -> Option<Torsion> {
        self.tracked_on_plan()?.departure(&|| self.exact_on_plan()).err()
    }

    /// The permanent and the variable loads at the point of the base under the centre of mass; `None` without a plan.
    pub fn base_wrenches(&self) -> Option<[BaseWrench; 2]> {
        self.problem_on_plan().map(|problem| [problem.permanent, problem.variable])
    }

    /// The numbers that decide where tracked rounding cannot: those that were written, or without any its own.
    fn exact_on_plan(&self) -> Problem<Ball> {
        let written = self.written.as_ref().and_then(|written| written.plan.clone());
        let own = || self.problem_on_plan().map(|problem| problem.map(|number| Ball::of(*number)));
        written.or_else(own).expect("it is on a plan")
    }

    /// The numbers with how far rounding may have moved them.
    fn tracked_on_plan(&self) -> Option<Problem<Approx>> {
        let (problem, sizes) = self.on_plan(self.plan.as_ref()?);
        let [permanent, variable] = sizes;
        let near = |wrench: &BaseWrench, size: &BaseWrench| {
            let part = |value: f64, size: f64| Approx::around(value, SUMMED * size);
            BaseWrench {
                x: part(wrench.x, size.x),
                z: part(wrench.z, size.z),
                p: part(wrench.p, size.p),
                q_x: part(wrench.q_x, size.q_x),
                q_z: part(wrench.q_z, size.q_z),
                t: part(wrench.t, size.t),
            }
        };
        let size = problem.footprint.size();
        let length = |length: &f64| Approx::around(*length, SUMMED * size);
        Some(Problem {
            footprint: problem.footprint.map(length),
            friction: Approx::around(problem.friction, f64::EPSILON * problem.friction),
            permanent: near(&problem.permanent, &permanent),
            variable: near(&problem.variable, &variable),
        })
    }

    /// True if rounding could put a body on a plan on the other side of a boundary.
    pub(super) fn is_near_on_plan(&self) -> Option<bool> {
        self.tracked_on_plan().map(|tracked| tracked.is_near())
    }

    /// The answer of its plan.
    ///
    /// # Errors
    /// If the loads turn the body about the vertical on a base that has no one answer to that.
    pub(super) fn outcome_on_plan(&self) -> Result<Option<Outcome>, InputError> {
        let (Some(plan), Some(tracked)) = (&self.plan, self.tracked_on_plan()) else { return Ok(None) };
        let departure = tracked.departure(&|| self.exact_on_plan()).map_err(|Torsion { moment }| {
            InputError::new(Quantity::TorsionalMoment, moment, Expected::NoneButOnDisc)
        })?;
        let sums = self.sums();
        let wrench = sums.permanent.plus(sums.variable);
        let actions = self.actions(&sums.by_kind);
        let parts = self.loads.iter().map(|load| self.at_base(plan, load));
        let [push, vertical] =
            parts.fold([BaseWrench::zero(); 2], |sum, part| [sum[0].plus(part[0]), sum[1].plus(part[1])]);
        let full = push.plus(vertical);
        let edges = plan.footprint.overturning(&push, &vertical);
        let least = edges.iter().enumerate().min_by(|(_, one), (_, two)| one.factor.total_cmp(&two.factor));
        let margin = edges.iter().map(|edge| edge.margin).fold(f64::INFINITY, f64::min);
        let factor = least.map_or(f64::INFINITY, |(_, edge)| edge.factor);
        let (grip, on_friction) = (self.static_friction * full.p, plan.footprint.on_friction(&full));
        let mut stability = Stability {
            sliding: ratio(grip, on_friction),
            overturning_about_heel: factor,
            overturning_about_toe: f64::INFINITY,
            resultant_arm: None,
            bearing: if full.p > 0.0 { Bearing::OnPlan } else { Bearing::Lifted },
        };
        let mut margins = Margins {
            sliding: grip - on_friction,
            overturning_about_heel: margin,
            overturning_about_toe: f64::INFINITY,
        };
        departure.settle(&mut stability, &mut margins);
        let gross = GrossOverturning {
            buoyancy: 0.0 - sums.buoyancy.p,
            buoyancy_moment: 0.0,
            about_heel: f64::INFINITY,
            about_toe: f64::INFINITY,
        };
        let leaves = match departure.at_once {
            true => Departure::AtOnce { verdict: None, permanent: true },
            false => Departure::from_rest(departure.load_factor, None),
        };
        let edge = least.filter(|(_, edge)| edge.factor < f64::INFINITY).map(|(place, _)| place);
        let verdict = departure.rests.then_some(Verdict::REST);
        let plan = PlanOutcome { departure, full, edge };
        Ok(Some(Outcome {
            full: Response { verdict, ..Response::unknown(wrench) },
            departure: leaves,
            path: Vec::new(),
            actions,
            stability,
            gross,
            margins,
            held: None,
            plan: Some(plan),
        }))
    }
}
