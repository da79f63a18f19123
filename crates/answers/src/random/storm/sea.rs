//! The storm of a case: each wave by Goda's formulas, its mode by the contact problem.

use standfast::contact::{Block, rests_surely, solve};
use standfast::ground::Base;
use standfast::loads::LoadSource;
use standfast::wave::Goda;
use standfast::{Mode, Wrench};
use standfast_probability::life::Life;
use standfast_probability::sums::OtherEvent;
use standfast_watch::Portion;

use super::answer::{Sliding, SlidingError, sliding};
use super::pulse::slide_from;
use super::{Part, Pulse, Slide, Storm, StormPart, Storms, Tau0, Year, height, level, rotation};
use crate::case::{Acting, Case, GodaWaves, Trial};
use crate::random::answer::ChanceRequest;
use crate::random::mechanics::{Components, Mechanics};
use crate::random::problem::ChanceProblem;
use crate::random::quantity::{Bias, RandomInput};

/// The storms of a case with random numbers.
pub(in crate::random) struct SeaStorm<'a> {
    pub(in crate::random) problem: &'a ChanceProblem,
    pub(in crate::random) storm: &'a Storm,
    /// Factors of a combination on thrust and uplift.
    pub(in crate::random) factors: [f64; 2],
    /// True if waves that begin a rotation are followed in time.
    pub(in crate::random) follow: bool,
}

/// A wave by Goda's formulas.
pub(in crate::random) struct GodaWave {
    waves: GodaWaves,
    /// Everything that acts but the waves.
    still: Wrench,
    block: Block,
    base: Base,
    /// Factors of the combination on thrust and uplift.
    factors: [f64; 2],
    biases: [Option<f64>; Bias::ALL.len()],
    /// m g, N, and half the width, m.
    scale: (f64, f64),
    gravity: f64,
    tau0: Tau0,
    pulse: Pulse,
    /// The case, where waves that begin a rotation are followed in time.
    followed: Option<Box<Case>>,
}

/// Effect of a wave on the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Effect {
    Nothing,
    Slides,
    Turns,
}

impl GodaWave {
    fn of(
        storms: &SeaStorm<'_>,
        case: &Case,
        (components, mechanics): (Components, &Mechanics),
        values: &[f64],
    ) -> Option<GodaWave> {
        let SeaStorm { problem, storm, factors, .. } = *storms;
        let components = Components { thrust: Wrench::ZERO, uplift: Wrench::ZERO, ..components };
        let [permanent, variable] = components.wrenches(|bias| problem.bias(bias, values));
        let Mechanics { block, base, .. } = *mechanics;
        let weight = case.body.mass() * case.gravity;
        Some(GodaWave {
            waves: case.goda()?.clone(),
            still: permanent + variable,
            block,
            base,
            factors,
            biases: Bias::ALL.map(|bias| problem.bias(bias, values)),
            scale: (weight, case.body.width() / 2.0),
            gravity: case.gravity,
            tau0: storm.tau0,
            pulse: storm.pulse,
            followed: None,
        })
    }

    fn goda(&self, height: f64) -> Goda {
        let GodaWaves { sea, section, choices, goda, .. } = &self.waves;
        goda.under_wave(sea, section, choices, height)
    }

    /// All that acts under a wave.
    fn wrench(&self, goda: &Goda) -> Wrench {
        let [thrust, uplift] = Components::of_wave(goda, &self.block, self.scale);
        let of_wave = [thrust * self.factors[0], uplift * self.factors[1]];
        self.still + Components::waves(&self.block, of_wave, |bias| self.biases[bias as usize])
    }

    /// Duration of the wave's push, s.
    fn duration(&self, height: f64, goda: &Goda) -> f64 {
        match self.tau0 {
            Tau0::Given(tau0) => tau0,
            Tau0::Formula => {
                let standing =
                    (0.5 - height / (8.0 * self.waves.sea.water_depth)).max(0.4) * self.waves.sea.period;
                standing / (goda.alpha_star.powf(0.3) + 1.0).powi(2)
            }
        }
    }

    fn effect(&self, level: f64) -> Effect {
        let wrench = self.wrench(&self.goda(height(level, self.waves.goda.h_13)));
        let mode = if self.base == Base::Rigid {
            if rests_surely(&self.block, &wrench) {
                return Effect::Nothing;
            }
            solve(&self.block, &wrench).ok().and_then(|solution| solution.mode())
        } else {
            self.base.decide(&self.block, &wrench).ok().and_then(|found| found.verdict?.mode())
        };
        match mode {
            Some(Mode::Rest) => Effect::Nothing,
            Some(Mode::SlideLeft) => Effect::Slides,
            _ => Effect::Turns,
        }
    }
}

impl Slide for GodaWave {
    fn slide(&self, level: f64) -> f64 {
        let height = height(level, self.waves.goda.h_13);
        let goda = self.goda(height);
        let (still, all) = (self.still, self.wrench(&goda));
        let (x, p) = (all.x - still.x, all.p - still.p);
        // To the left: F_S = −x − μp of the wave, and R = X + μP of everything else.
        let against = |μ: f64| (-x - μ * p, still.x + μ * still.p);
        let Block { mu_s, mu_k, m_x, .. } = self.block;
        let (thrust, resistance) = against(mu_k);
        let tau0 = self.duration(height, &goda);
        let slide = if mu_s == mu_k {
            self.pulse.slide(thrust / resistance)
        } else {
            let (thrust_sticking, sticks) = against(mu_s);
            slide_from(thrust / resistance, sticks / thrust_sticking)
        };
        resistance * self.gravity / m_x * tau0 * tau0 * slide
    }

    fn follows(&self) -> bool {
        self.followed.is_some()
    }

    fn turned(&self, level: f64) -> OtherEvent {
        let height = height(level, self.waves.goda.h_13);
        let goda = self.goda(height);
        let duration = self.duration(height, &goda);
        let Some(case) = &self.followed else { return OtherEvent::default() };
        let friction = [self.block.mu_s, self.block.mu_k];
        let bias = |bias: Bias| self.biases[bias as usize].unwrap_or(1.0);
        // What cannot be followed is counted, as it is without this.
        rotation::wave(case, &self.waves, goda, duration, friction, bias).unwrap_or_default()
    }
}

/// The slides of a case's storms, with the chances that they come to more than those of `over`.
pub(in crate::random) fn of_case(
    storm: &Storm,
    problems: &[ChanceProblem],
    request: &ChanceRequest,
    over: &[f64],
    portion: Portion<'_>,
) -> Result<Sliding, SlidingError> {
    let problem = problem_of(storm, problems)?;
    let Some((case, acting)) = problem.case() else { return Err(SlidingError::NoWaves) };
    let case = case.under(acting);
    if case.goda().is_none() {
        return Err(SlidingError::NoWaves);
    }
    if request.follow && case.gives_way() {
        return Err(SlidingError::Ground);
    }
    if storm.parts.iter().any(|part| part.rise != 0.0) {
        problem.can_rise()?;
    }
    let medians = problem.laws().values_of(&vec![0.0; problem.random().len()]);
    if let Some(part) = storm.parts.iter().position(|part| problem.case_in(&medians, part).is_none()) {
        return Err(SlidingError::Part { part: part + 1 });
    }
    let of_moment = [Bias::ThrustMoment, Bias::UpliftMoment];
    let biased = problem.random().iter().find(|input| of_moment.iter().any(|bias| bias.name() == input.name));
    if let Some(input) = biased.filter(|_| request.follow) {
        return Err(SlidingError::BiasOfMoment { name: input.name.clone() });
    }
    let (kinetic, friction) = (case.kinetic_friction, case.friction);
    let is_random = problem.random().iter().any(RandomInput::is_kinetic_friction);
    if storm.pulse == Pulse::Shimosako && (is_random || kinetic != friction) {
        return Err(SlidingError::TwoFrictions { kinetic, friction });
    }
    let plain = Life { years: 1.0, yearly: vec![false; problem.random().len()], events: None, clock: None };
    if problem.lifetime().survived.is_some() {
        return Err(SlidingError::Survived);
    }
    let life = problem.life().unwrap_or(plain);
    let factors = factors(case, acting).filter(|_| !request.follow || matches!(acting, Acting::All));
    let factors = factors.ok_or(SlidingError::Combination { name: storm.combination.clone() })?;
    let storms = SeaStorm { problem, storm, factors, follow: request.follow };
    sliding(storm, &storms, problem.laws(), &life, (request, over), portion)
}

/// The set of loads under which the waves of a storm come.
fn problem_of<'a>(storm: &Storm, problems: &'a [ChanceProblem]) -> Result<&'a ChanceProblem, SlidingError> {
    let name = |problem: &ChanceProblem| {
        let (case, acting) = problem.case()?;
        let Acting::Combination(index) = acting else { return None };
        case.combinations[index].name.clone()
    };
    match (&storm.combination, problems) {
        (None, [problem]) => Ok(problem),
        (None, _) => {
            let mut combinations: Vec<String> = problems.iter().filter_map(name).collect();
            let count = combinations.len();
            combinations.dedup();
            // Of several accelerations of the base under one combination none can be named.
            let is_shaken = combinations.len() < count || combinations.is_empty();
            Err(if is_shaken { SlidingError::Shaken } else { SlidingError::Choice { combinations } })
        }
        (Some(asked), _) => {
            let mut found = problems.iter().filter(|problem| name(problem).as_ref() == Some(asked));
            match (found.next(), found.next()) {
                (Some(problem), None) => Ok(problem),
                (None, _) => Err(SlidingError::NoCombination {
                    asked: asked.clone(),
                    combinations: problems.iter().filter_map(name).collect(),
                }),
                // The same under several accelerations of the base.
                (Some(_), Some(_)) => Err(SlidingError::Shaken),
            }
        }
    }
}

/// The factors of a set of loads on the thrust and the uplift of a wave; `None` where they act on effects.
fn factors(case: &Case, acting: Acting) -> Option<[f64; 2]> {
    if let Acting::Combination(index) = acting
        && case.combinations[index].effects
    {
        return None;
    }
    let situation = case.situation(acting, Trial::AS_GIVEN).ok()?;
    let of = |source: LoadSource| {
        let load = situation.loads().iter().find(|load| load.source == source);
        load.map_or(0.0, |load| case.factor_on(acting, Trial::AS_GIVEN, load))
    };
    Some([of(LoadSource::WavePressure), of(LoadSource::WaveUplift)])
}

/// Into how many steps the heights up to the cut are parted in search of changes of mode.
const SCAN: u32 = 16;

impl Storms for SeaStorm<'_> {
    type Wave = GodaWave;

    fn storm(&self, values: &[f64]) -> Option<Year<GodaWave>> {
        let parts = &self.storm.parts;
        Year::of(parts.iter().filter_map(|part| self.part(values, part)).collect(), parts.len())
    }

    fn gives_way(&self) -> bool {
        self.problem.gives_way()
    }
}

impl SeaStorm<'_> {
    /// A part of the storm with these values; none if no wave of it moves the body.
    fn part(&self, values: &[f64], part: &StormPart) -> Option<Part<GodaWave>> {
        let problem = self.problem;
        let case = if *part == StormPart::PEAK { None } else { Some(problem.case_in(values, part)?) };
        let components = match &case {
            None => problem.components(values)?,
            Some(case) => problem.components_of(case)?,
        };
        let mechanics = problem.mechanics_of(&components, values);
        // The case has its largest wave, at which heights are cut: most years end here.
        let is_calm = self.storm.is_cut && mechanics.base == Base::Rigid;
        if is_calm && rests_surely(&mechanics.block, &mechanics.wrench()) {
            return None;
        }
        let case = case.or_else(|| problem.case_with(values))?;
        let (_, acting) = problem.case()?;
        let mut wave = GodaWave::of(self, case.under(acting), (components, &mechanics), values)?;
        wave.followed = self.follow.then(|| Box::new(case));
        let goda = &wave.waves.goda;
        // No wave is drawn beyond e⁻⁴⁰.
        let cut = if self.storm.is_cut { level(goda.h_max, goda.h_13) } else { f64::INFINITY };
        let last = cut.min(40.0);
        if wave.effect(last) == Effect::Nothing {
            return None;
        }
        let mut part = Part { slides: Vec::new(), turns: Vec::new(), cut, wave };
        let end = last.sqrt();
        let (mut from, mut here) = (0.0, part.wave.effect(0.0));
        for step in 1..=SCAN {
            let root = |part: f64| end * (f64::from(step - 1) + part) / f64::from(SCAN);
            let (mut low, then) = (0.0, part.wave.effect(root(1.0).powi(2)));
            while here != then {
                // The first change, by height: what follows it may change again before the step ends.
                let (mut high, mut beyond) = (1.0, then);
                while high - low > 1e-10 {
                    let middle = 0.5 * (low + high);
                    let there = part.wave.effect(root(middle).powi(2));
                    if there == here { low = middle } else { (high, beyond) = (middle, there) }
                }
                let to = root(high).powi(2);
                part.add(here, from, to);
                (from, low, here) = (to, high, beyond);
            }
        }
        let to = if self.storm.is_cut { cut } else { f64::INFINITY };
        part.add(here, from, to);
        Some(part)
    }
}

impl Part<GodaWave> {
    fn add(&mut self, effect: Effect, from: f64, to: f64) {
        match effect {
            Effect::Slides => self.slides.push((from, to)),
            Effect::Turns => self.turns.push((from, to)),
            Effect::Nothing => {}
        }
    }
}
