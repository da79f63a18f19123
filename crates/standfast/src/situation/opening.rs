//! Water under a base that opens, in the numbers of a situation.

use super::{Response, Situation};
use crate::contact::Block;
use crate::contact::opening::{BaseWater, Drain, OpeningLoads, OpeningSolution, OpeningState};
use crate::error::InputError;
use crate::loads::{Action, Face, PressureDiagram};
use crate::mode::Mode;
use crate::plan::Plan;
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// Loads that the water under a base has time to follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OpeningRule {
    /// The steady ones: fast loads meet the diagram that these leave.
    Steady,
    /// All.
    Always,
}

/// Water under a base that may open; SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Opening {
    rule: OpeningRule,
    /// Pa, m.
    water: BaseWater,
}

/// How far the base of a body at rest has opened under the full load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseOpening {
    /// Loads that the water follows.
    pub rule: OpeningRule,
    /// Pressure at O and at O', Pa.
    pub heads: [f64; 2],
    /// How far it has opened; lengths in m.
    pub state: OpeningState,
    /// Uplift of the water, N per metre run.
    pub uplift: f64,
    /// What it would be if nothing opened.
    pub uplift_closed: f64,
    /// The drain, where there is one.
    pub drain: Option<Drain>,
    /// Multiple of the variable loads at which the base begins to open; `None` where it never does, or has from the beginning.
    pub opens_at: Option<f64>,
    /// Multiple at which it would have opened from end to end; `None` where it never does, and where fast loads meet a held diagram.
    pub tips_at: Option<f64>,
    /// True if fast loads meet a diagram that is held.
    pub is_held: bool,
    /// True of a closed base that any opening would lift.
    pub would_run_through: bool,
}

impl BaseOpening {
    /// The length of the base that is pressed, of `width`, m.
    pub fn contact(&self, width: f64) -> f64 {
        self.state.contact(width)
    }

    /// Whether the drain works; `None` without one.
    pub fn drain_works(&self) -> Option<bool> {
        self.drain.map(|_| self.state.is_drained())
    }

    /// The higher of both pressures, Pa: that of what has opened.
    pub fn open_pressure(&self) -> f64 {
        self.heads[0].max(self.heads[1])
    }
}

impl Situation {
    /// Situation whose still water under the base follows an opening, of a rectangular base under different heads: its pressure under the
    /// full load at rest stands among the loads.
    pub fn with_opening(mut self, rule: OpeningRule, drain: Option<Drain>) -> Situation {
        let Some(heads) = self.heads() else { return self };
        let water = BaseWater { left: heads[0], right: heads[1], drain };
        let is_rectangle = matches!(self.body.plan(), Plan::Rectangle { .. });
        if !is_rectangle || !(water.has_head() || drain.is_some()) {
            return self;
        }
        self.opening = Some(Opening { rule, water });
        self.written = None;
        self.reopened()
    }

    /// Situation whose still water under the base is drained, and follows no opening.
    pub fn with_drain(self, drain: Drain) -> Situation {
        let drained = self.with_opening(OpeningRule::Steady, Some(drain));
        let Some(Opening { water, .. }) = drained.opening else { return drained };
        let points = water.diagram(&drained.block_in_metres(), OpeningState::Closed);
        Situation { opening: None, ..drained.under(&points) }
    }

    /// Situation with these pressures under its base, at distances from O.
    fn under(mut self, points: &[(f64, f64)]) -> Situation {
        for load in self.loads.iter_mut().filter(|load| load.is_water_under_base()) {
            let factor = load.factor;
            let points = points.iter().map(|(position, pressure)| (*position, pressure / factor));
            let diagram = PressureDiagram::through(points);
            load.action = Action::Pressure { face: Face::Base, diagram };
        }
        self
    }

    /// Situation with the water under its base as its loads open it at rest.
    pub(super) fn reopened(self) -> Situation {
        let Some(Opening { water, .. }) = self.opening else { return self };
        let state = self.opening_at(1.0);
        if state != OpeningState::Closed || water.drain.is_some() {
            let points = water.diagram(&self.block_in_metres(), state);
            return self.under(&points);
        }
        self
    }

    /// Pressures of still water at both ends of the base, times the factor of their load, Pa.
    fn heads(&self) -> Option<[f64; 2]> {
        let under = self.loads.iter().filter(|load| load.is_water_under_base());
        let ends = under.filter_map(|load| match &load.action {
            Action::Pressure { diagram, .. } => {
                let (first, last) = (diagram.points().first()?, diagram.points().last()?);
                Some([first.pressure * load.factor, last.pressure * load.factor])
            }
            _ => None,
        });
        ends.reduce(|sum, next| [sum[0] + next[0], sum[1] + next[1]])
    }

    fn block_in_metres(&self) -> Block {
        let body = &self.body;
        Block {
            b1: body.heel_distance(),
            b2: body.toe_distance(),
            d: body.centroid_height(),
            rho2: 1.0,
            m_x: 1.0,
            m_y: 1.0,
            mu_s: self.static_friction,
            mu_k: self.kinetic_friction,
        }
    }

    /// All loads but the water under the base, in SI units.
    fn loads_in_si(&self, rule: OpeningRule) -> OpeningLoads {
        let mut loads = OpeningLoads { permanent: Wrench::ZERO, steady: Wrench::ZERO, fast: Wrench::ZERO };
        for load in self.loads.iter().filter(|load| !load.is_water_under_base()) {
            let sum = match (load.permanent, load.is_fast && rule == OpeningRule::Steady) {
                (true, _) => &mut loads.permanent,
                (false, false) => &mut loads.steady,
                (false, true) => &mut loads.fast,
            };
            *sum = *sum + self.wrench_of(load);
        }
        loads
    }

    /// Pressures per length of the base out of the plane, as a block in metres has them.
    fn along(&self, water: &BaseWater) -> BaseWater {
        let length = self.body.plan().side(self.body.width());
        BaseWater { left: water.left * length, right: water.right * length, ..*water }
    }

    /// State of the base at rest under a multiple of the variable loads; closed where no water follows an opening.
    pub fn opening_at(&self, factor: f64) -> OpeningState {
        let Some(Opening { rule, water }) = &self.opening else { return OpeningState::Closed };
        let loads = self.loads_in_si(*rule);
        self.along(water).state(&self.block_in_metres(), &(loads.permanent + loads.steady * factor))
    }

    /// The water and the loads in the units of the [reduced block](Situation::reduced_block).
    fn reduced_opening(&self) -> Option<(BaseWater, OpeningLoads)> {
        let Opening { rule, water } = self.opening.as_ref()?;
        let half_width = self.body.width() / 2.0;
        let per_length = half_width / (self.body.mass() * self.gravity);
        let BaseWater { left, right, drain } = self.along(water);
        let drain = drain.map(|drain| Drain { distance: drain.distance / half_width, ..drain });
        let water = BaseWater { left: left * per_length, right: right * per_length, drain };
        let loads = self.loads_in_si(*rule);
        let [permanent, steady, fast] =
            [loads.permanent, loads.steady, loads.fast].map(|wrench| self.reduced_wrench(&wrench));
        Some((water, OpeningLoads { permanent, steady, fast }))
    }

    /// The answer under a load factor where water follows an opening; `None` where nothing opens, and the loads as they are decide.
    pub(super) fn followed(&self, factor: f64) -> Result<Option<OpeningSolution>, InputError> {
        let Some((water, loads)) = self.reduced_opening() else { return Ok(None) };
        let found = water.solve_at(&self.reduced_block().0, &loads, factor)?;
        Ok(found.follows.then_some(found))
    }

    /// All loads under a load factor with the water of the body at rest, N and N·m per metre run.
    pub(super) fn total_at(&self, factor: f64) -> Wrench {
        let state = self.opening_at(factor);
        match &self.opening {
            Some(Opening { rule, water }) if state != self.opening_at(1.0) => {
                let loads = self.loads_in_si(*rule);
                let block = self.block_in_metres();
                loads.permanent
                    + (loads.steady + loads.fast) * factor
                    + self.along(water).wrench(&block, state)
            }
            _ => {
                let sums = self.sums();
                sums.permanent.plus(sums.variable * factor)
            }
        }
    }

    /// The response where water follows an opening.
    pub(super) fn response_as_it_opens(
        &self,
        factor: f64,
        wrench: Wrench,
    ) -> Result<Option<Response>, InputError> {
        let Some(found) = self.followed(factor)? else { return Ok(None) };
        let (weight, half_width) = (self.body.mass() * self.gravity, self.body.width() / 2.0);
        // Where it moves, the water is another than at rest, whose point in the report's plane says nothing of it.
        let effective = self.effective(&wrench).filter(|_| found.mode == Some(Mode::Rest));
        Ok(Some(Response {
            wrench,
            verdict: found.mode.map(Verdict::Begins),
            modes: found.modes,
            effective,
            motion: found.motion.map(|motion| motion.scaled(self.gravity, half_width, weight)),
            boundary: None,
        }))
    }

    /// The stages of the rising loads where water follows an opening somewhere on the way; `None` where it never does.
    pub(super) fn path_as_it_opens(&self) -> Result<Option<Vec<Stage>>, InputError> {
        let Some((water, loads)) = self.reduced_opening() else { return Ok(None) };
        let block = self.reduced_block().0;
        let stages = water.stages(&block, &loads)?;
        for stage in &stages {
            let inside =
                if stage.to.is_finite() { (stage.from + stage.to) / 2.0 } else { 2.0 * stage.from + 1.0 };
            // In the last stage the base may open far beyond.
            if water.solve_at(&block, &loads, inside)?.follows || self.opens_within(stage) {
                return Ok(Some(stages));
            }
        }
        Ok(None)
    }

    fn opens_within(&self, stage: &Stage) -> bool {
        let opens = self.base_opening().and_then(|opening| opening.opens_at);
        opens.is_some_and(|factor| stage.from <= factor && factor < stage.to)
    }

    /// True if the base opens for some load factor up to a limit, so that water under it is not the same for all.
    pub fn opens_up_to(&self, factor: f64) -> bool {
        let Some(opening) = self.base_opening() else { return false };
        opening.state != OpeningState::Closed || opening.opens_at.is_some_and(|opens| opens < factor)
    }

    /// How far the base has opened at rest under the full load; `None` where no still water stands under it with different heads, or nothing
    /// is to follow it.
    pub fn base_opening(&self) -> Option<BaseOpening> {
        let Opening { rule, water } = self.opening.as_ref()?;
        let (block, along) = (self.block_in_metres(), self.along(water));
        let loads = self.loads_in_si(*rule);
        let state = self.opening_at(1.0);
        let is_held = loads.fast != Wrench::ZERO;
        let steady = OpeningLoads { fast: Wrench::ZERO, ..loads };
        let [opens_at, tips_at] = along.opens_at(&block, &steady);
        let net = loads.permanent.p + loads.steady.p - along.left.max(along.right) * (block.b1 + block.b2);
        Some(BaseOpening {
            rule: *rule,
            heads: [water.left, water.right],
            state,
            uplift: 0.0 - along.wrench(&block, state).p,
            uplift_closed: 0.0 - along.closed(&block).p,
            drain: water.drain,
            opens_at,
            tips_at: tips_at.filter(|_| !is_held),
            is_held,
            would_run_through: state == OpeningState::Closed && net < 0.0,
        })
    }
}
