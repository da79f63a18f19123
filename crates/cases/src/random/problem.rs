//! Random numbers of a case as `standfast-probability` takes them: laws, and the modes as intervals along one of them.

use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

use standfast::contact::{Block, friction, path, solve};
use standfast::loads::Earthquake;
use standfast::wave::Heights;
use standfast::{Mode, Modes, Point, Wrench};
use standfast_probability::integrate::Life;
use standfast_probability::problem::{Inputs as Laws, Outcomes, Pieces};

use super::mechanics::{Components, Mechanics, Quick};
use super::read::{At, Random, Rate};
use super::resolve::{Names, Resolve};
use super::storm::StormField;
use crate::case::{Acting, Case};
use crate::couple::{Variable, vary};
use crate::error::CaseError;
use crate::inputs::Inputs;
use crate::key::{Id, Key, Range};
use crate::layout::digits;
use crate::parse::CaseFile;

/// What a random number is.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A number of the case file, with what goes with it.
    Key(Variable),
    /// What loads are multiplied by.
    Bias(Bias),
    /// One of the four numbers of the report's problem.
    Point(Coordinate),
    /// A number of a pure problem of sliding.
    Storm(StormField),
}

/// A number of the report's problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// γ, the slenderness.
    Gamma,
    /// k', the elevation of the force.
    KPrime,
    /// k, the force.
    K,
    /// μ, the friction.
    Mu,
}

impl Coordinate {
    /// All of them.
    pub const ALL: [Coordinate; 4] = [Coordinate::Gamma, Coordinate::KPrime, Coordinate::K, Coordinate::Mu];

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Coordinate::Gamma => "gamma",
            Coordinate::KPrime => "k_prime",
            Coordinate::K => "k",
            Coordinate::Mu => "mu",
        }
    }

    /// Which values it takes.
    pub fn range(self) -> Range {
        match self {
            Coordinate::Gamma => Range::Positive,
            Coordinate::KPrime => Range::Finite,
            Coordinate::K | Coordinate::Mu => Range::NotNegative,
        }
    }
}

/// A factor between what formulas give and what acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bias {
    /// On the horizontal wave force, and on its moment unless that has one of its own.
    Thrust,
    /// On the uplift of the wave, and on its moment unless that has one of its own.
    Uplift,
    /// On the moment of the horizontal wave force about the heel.
    ThrustMoment,
    /// On the moment of the uplift about the heel.
    UpliftMoment,
    /// On every force of `[[load]]`.
    Force,
}

impl Bias {
    /// All of them.
    pub const ALL: [Bias; 5] =
        [Bias::Thrust, Bias::Uplift, Bias::ThrustMoment, Bias::UpliftMoment, Bias::Force];

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Bias::Thrust => "bias.P",
            Bias::Uplift => "bias.U",
            Bias::ThrustMoment => "bias.M_p",
            Bias::UpliftMoment => "bias.M_U",
            Bias::Force => "bias.force",
        }
    }
}

/// A number that is random.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its name, as in the file.
    pub name: String,
    /// What it is.
    pub quantity: Quantity,
    /// How often it is drawn.
    pub every: Rate,
    /// What of its law was cut because no body has such values.
    pub cut: f64,
}

/// A case, its random numbers, and the loads that act.
#[derive(Debug, Clone)]
pub struct Problem {
    id: u64,
    model: Model,
    random: Vec<Input>,
    laws: Laws,
    years: Option<f64>,
    pub(super) line: Line,
}

/// What the numbers are of.
#[derive(Debug, Clone)]
enum Model {
    /// A case, the loads of it that act, and how the base is shaken.
    Case {
        inputs: Box<Inputs>,
        case: Box<Case>,
        acting: Acting,
        earthquake: Option<Earthquake>,
        /// Where of the case's numbers wave heights alone are random.
        quick: Option<Box<Quick>>,
    },
    /// A point of the report's plane: γ, k', k, μ.
    Point([f64; 4]),
}

/// Along which number the modes are known, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Line {
    /// Friction: its place.
    Friction(usize),
    /// A number in which the wrench is linear.
    Load(usize),
    /// Any other, scanned.
    Scan(usize),
}

/// An |α| below which a number hardly matters.
const NEGLIGIBLE: f64 = 0.02;

/// The outcomes behind those of the modes, which have their codes: more than one mode is consistent.
pub(super) const NOT_UNIQUE: usize = 16;
/// Nothing presses the body on its base.
pub(super) const LIFTED: usize = 17;
/// The numbers do not go together.
pub(super) const NOT_A_BODY: usize = 18;
/// No mode is consistent.
pub(super) const NO_MODE: usize = 19;
pub(super) const COUNT: usize = 20;

/// The outcomes that exclude each other and add up to one.
pub(super) fn exclusive() -> impl Iterator<Item = usize> {
    modes().chain([NO_MODE, NOT_A_BODY])
}

/// The codes of all modes.
pub(super) fn modes() -> impl Iterator<Item = usize> {
    (0..16).filter(|code| Mode::from_code(*code as u8).is_some())
}

/// Everything but rest: modes, and what is no body.
pub(super) fn not_rest() -> u64 {
    exclusive()
        .filter(|outcome| *outcome != usize::from(Mode::Rest.code()))
        .fold(0, |set, outcome| set | 1 << outcome)
}

impl Problem {
    /// The problems of a case file, which is of this case, with a `[random]` table: one for each set of loads that act together and each acceleration of
    /// the base that is tried.
    ///
    /// # Errors
    /// If the values of the case do not go together, or a name, a law or a correlation is wrong.
    pub fn of(
        file: &CaseFile,
        case: Case,
        random: &Random,
        years: Option<f64>,
    ) -> Result<Vec<Problem>, CaseError> {
        let wrong = |(problem, span)| file.random_error(problem, span);
        let (inputs, laws) = Resolve(Names::Case(file, &case)).all(random).map_err(wrong)?;
        let line = line(&inputs);
        let mut unnamed = file.inputs().clone();
        [Key::Title, Key::Note].into_iter().for_each(|key| unnamed.remove(key.into()));
        let mut problems = Vec::new();
        for acting in case.acting() {
            let shaken = case.earthquakes(acting);
            let each: Vec<Option<Earthquake>> =
                if shaken.is_empty() { vec![None] } else { shaken.into_iter().map(Some).collect() };
            for earthquake in each {
                let (inputs_of_case, case) = (Box::new(unnamed.clone()), Box::new(case.clone()));
                let quick = only_heights(&inputs).then(|| Quick::of(&case, acting, earthquake)).flatten();
                let quick = quick.map(Box::new);
                problems.push(Problem {
                    id: unique(),
                    model: Model::Case { inputs: inputs_of_case, case, acting, earthquake, quick },
                    random: inputs.clone(),
                    laws: laws.clone(),
                    years: years.or(random.years),
                    line,
                });
            }
        }
        Ok(problems)
    }

    /// The problem of a point of the report's plane with random numbers.
    ///
    /// # Errors
    /// If a name, a law or a correlation is wrong.
    pub(super) fn of_point(point: [f64; 4], random: &Random, years: Option<f64>) -> At<Problem> {
        let (inputs, laws) = Resolve(Names::Point(point)).all(random)?;
        let (model, line) = (Model::Point(point), line(&inputs));
        Ok(Problem { id: unique(), model, random: inputs, laws, years: years.or(random.years), line })
    }

    /// What is random, in the order of the file.
    pub fn random(&self) -> &[Input] {
        &self.random
    }

    /// The case, if it is one, and the loads of it that act.
    pub(super) fn case(&self) -> Option<(&Case, Acting)> {
        match &self.model {
            Model::Case { case, acting, .. } => Some((case, *acting)),
            Model::Point(_) => None,
        }
    }

    /// The laws of the random numbers and how they are correlated.
    pub fn laws(&self) -> &Laws {
        &self.laws
    }

    /// Which loads act, and how the base is shaken, in words; none where the case leaves no choice.
    pub fn situation(&self) -> Option<String> {
        let Model::Case { case, acting, earthquake, .. } = &self.model else { return None };
        let name = case.acting_name(*acting);
        let turned = |earthquake: Earthquake| {
            format!(
                "base at {} m/s² to the right, {} upwards",
                digits(earthquake.horizontal()),
                digits(earthquake.vertical())
            )
        };
        match (name, earthquake.map(turned)) {
            (Some(name), Some(shaken)) => Some(format!("{name}, {shaken}")),
            (name, shaken) => name.or(shaken),
        }
    }

    /// The life that is asked for, where one is.
    pub(super) fn life(&self) -> Option<Life> {
        let yearly = self.random.iter().map(|input| input.every == Rate::Year).collect();
        self.years.map(|years| Life { years, yearly })
    }

    /// The same along a number that is drawn yearly, as a life needs it; none if there is no such number.
    pub(super) fn along_yearly(&self) -> Option<Problem> {
        let yearly = |place: &usize| self.random[*place].every == Rate::Year;
        let linear = |place: &usize| self.random[*place].is_linear();
        let friction = self.random.iter().position(Input::is_friction).filter(yearly).map(Line::Friction);
        let load = || (0..self.random.len()).find(|place| yearly(place) && linear(place)).map(Line::Load);
        let scan = || (0..self.random.len()).find(yearly).map(Line::Scan);
        let line = friction.or_else(load).or_else(scan)?;
        Some(Problem { line, ..self.clone() })
    }

    /// The same along the number that matters more, by the nearest point at which the body does not rest (α of each number): where friction
    /// hardly matters, or is certain, that number of those in which the wrench is linear that has the largest |α|. None if it is the
    /// number already.
    pub(super) fn along_what_matters(&self, alpha: &[f64]) -> Option<Problem> {
        let own = match self.line {
            Line::Friction(place) | Line::Load(place) if alpha[place].abs() < NEGLIGIBLE => {
                alpha[place].abs()
            }
            Line::Friction(_) | Line::Scan(_) => return None,
            Line::Load(place) => alpha[place].abs(),
        };
        let linear = (0..self.random.len()).filter(|place| self.random[*place].is_linear());
        let best = linear.max_by(|a, b| alpha[*a].abs().total_cmp(&alpha[*b].abs()).then(b.cmp(a)))?;
        let line = Line::Load(best);
        (line != self.line && alpha[best].abs() > own).then(|| Problem { line, id: unique(), ..self.clone() })
    }

    /// Whether the number along which modes are known has to be scanned.
    pub(super) fn is_scanned(&self) -> bool {
        matches!(self.line, Line::Scan(_))
    }

    /// Whether friction, or a load, is integrated in closed form; and the name of that number.
    pub(super) fn line_name(&self) -> (&str, bool) {
        let (place, exact) = match self.line {
            Line::Friction(place) | Line::Load(place) => (place, true),
            Line::Scan(place) => (place, false),
        };
        (&self.random[place].name, exact)
    }

    /// The contact problem with these values, one for each random number; none if they do not go together.
    pub(super) fn mechanics(&self, values: &[f64]) -> Option<Mechanics> {
        if let Model::Point(point) = &self.model {
            return self.at_point(*point, values);
        }
        let components = self.components(values)?;
        let mut block = components.block;
        if let Some(place) = self.random.iter().position(Input::is_friction) {
            let ratio = if block.mu_s > 0.0 { block.mu_k / block.mu_s } else { 1.0 };
            (block.mu_s, block.mu_k) = (values[place], values[place] * ratio);
        }
        let [permanent, variable] = components.wrenches(|bias| self.bias(bias, values));
        Some(Mechanics { block, permanent, variable, formulas: components.formulas })
    }

    /// The same on the way to the full load: of the report's force, at any size, only the elevation counts.
    pub(super) fn departing(&self, values: &[f64]) -> Option<Mechanics> {
        let mut mechanics = self.mechanics(values)?;
        if let Model::Point(point) = &self.model {
            let with = |coordinate: Coordinate| {
                let place = self.random.iter().position(|i| i.quantity == Quantity::Point(coordinate));
                place.map_or(point[coordinate as usize], |place| values[place])
            };
            if with(Coordinate::K) > 0.0 {
                let m = with(Coordinate::KPrime) * with(Coordinate::Gamma);
                mechanics.variable = Wrench { x: -1.0, p: 0.0, m };
            }
        }
        Some(mechanics)
    }

    /// A number that no other problem has.
    pub(super) fn id(&self) -> u64 {
        self.id
    }

    pub(super) fn bias(&self, bias: Bias, values: &[f64]) -> Option<f64> {
        let place = self.random.iter().position(|input| input.quantity == Quantity::Bias(bias));
        place.map(|place| values[place])
    }

    /// What acts, unbiased, with these values of all numbers but friction; those of the last call if they are the same.
    pub(super) fn components(&self, values: &[f64]) -> Option<Components> {
        let slow = |input: &&Input| input.variable().is_some() && !input.is_friction();
        let keys: Vec<f64> = self
            .random
            .iter()
            .zip(values)
            .filter(|(input, _)| slow(input))
            .map(|(_, value)| *value)
            .collect();
        LAST.with_borrow_mut(|last| match last {
            Some((id, of, components)) if *id == self.id && *of == keys => *components,
            last => {
                let components = self.assembled(values);
                *last = Some((self.id, keys, components));
                components
            }
        })
    }

    fn assembled(&self, values: &[f64]) -> Option<Components> {
        let Model::Case { acting, earthquake, quick, .. } = &self.model else { return None };
        if let Some(quick) = quick {
            return quick.components(self.heights(values)?);
        }
        let case = self.case_with(values)?;
        let formulas = case.wave.as_ref().map_or(0, |wave| wave.goda.formulas);
        Some(Components::of(&case.situation(*acting, *earthquake).ok()?, formulas))
    }

    /// The case with these values of all numbers but friction; none if they do not go together.
    pub(super) fn case_with(&self, values: &[f64]) -> Option<Case> {
        let Model::Case { inputs, case, quick, .. } = &self.model else { return None };
        if let Some(quick) = quick {
            return quick.case(case, self.heights(values)?);
        }
        let named: Vec<(&Variable, f64)> = self
            .random
            .iter()
            .zip(values)
            // A friction of zero would leave no ratio of slip to stick.
            .filter(|(input, _)| !input.is_friction())
            .filter_map(|(input, value)| Some((input.variable()?, *value)))
            .collect();
        Case::of(&vary(inputs, case, &named)).ok()
    }

    /// The wave heights of the case, with these values of those that are random.
    fn heights(&self, values: &[f64]) -> Option<Heights> {
        let Model::Case { case, .. } = &self.model else { return None };
        let mut heights = case.wave.as_ref()?.heights;
        for (input, value) in self.random.iter().zip(values) {
            let key = input.variable().map(|variable| variable.id().key);
            match (&mut heights, key) {
                (Heights::DeepWater(height), Some(Key::DeepWaterHeight)) => *height = *value,
                (Heights::Local { significant, .. }, Some(Key::H13)) => *significant = *value,
                (Heights::Local { maximum, .. }, Some(Key::Hmax)) => *maximum = *value,
                _ => {}
            }
        }
        Some(heights)
    }

    /// The report's problem with these values: X = −k, M = k k' γ.
    fn at_point(&self, mut point: [f64; 4], values: &[f64]) -> Option<Mechanics> {
        for (input, value) in self.random.iter().zip(values) {
            if let Quantity::Point(coordinate) = input.quantity {
                point[coordinate as usize] = *value;
            }
        }
        let [gamma, k_prime, k, mu] = point;
        Point::new(gamma, k_prime, k, mu).ok()?;
        let permanent = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let variable = Wrench { x: -k, p: 0.0, m: k * k_prime * gamma };
        Some(Mechanics { block: Block::uniform(gamma, mu), permanent, variable, formulas: 0 })
    }

    /// The outcomes of a block under a wrench.
    pub(super) fn outcomes(block: &Block, wrench: &Wrench) -> u64 {
        let lifted = u64::from(wrench.p <= 0.0) << LIFTED;
        match solve(block, wrench) {
            Ok(solution) => lifted | of_modes(solution.mode(), solution.modes),
            Err(_) => 1 << NOT_A_BODY,
        }
    }
}

/// A problem's number, the values, and what was assembled; none if they do not go together.
type Assembled = (u64, Vec<f64>, Option<Components>);

thread_local! {
    /// What was assembled last, of which problem, with which values.
    static LAST: RefCell<Option<Assembled>> = const { RefCell::new(None) };
}

/// A number that no other problem has.
fn unique() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// A mode's outcome, and whether it is the only one.
fn of_modes(mode: Option<Mode>, modes: Modes) -> u64 {
    let reported = mode.map_or(NO_MODE, |mode| usize::from(mode.code()));
    1 << reported | u64::from(modes.len() > 1) << NOT_UNIQUE
}

impl Outcomes for Problem {
    fn count(&self) -> usize {
        COUNT
    }

    fn line(&self) -> usize {
        match self.line {
            Line::Friction(place) | Line::Load(place) | Line::Scan(place) => place,
        }
    }

    fn is_quick(&self, input: usize) -> bool {
        // Formulas of waves and bodies are not worked out again.
        self.random[input].variable().is_none() || self.random[input].is_friction()
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        let mut values = values.to_vec();
        let everywhere =
            |pieces: &mut Pieces, outcome| pieces.push(f64::NEG_INFINITY, f64::INFINITY, outcome);
        match self.line {
            Line::Friction(place) => {
                values[place] = 1.0;
                let Some(mechanics) = self.mechanics(&values) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                let (block, wrench) = (mechanics.block, mechanics.wrench());
                pieces.branch(u64::from(mechanics.formulas));
                if wrench.p <= 0.0 {
                    everywhere(pieces, LIFTED);
                }
                let Ok(spans) = friction::spans(&block, &wrench) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                for span in spans {
                    pieces.branch(span.condition as u64);
                    push_all(pieces, span.from, span.to, of_modes(span.mode, span.modes));
                }
            }
            Line::Load(place) => {
                values[place] = 0.0;
                let without = self.mechanics(&values);
                values[place] = 1.0;
                let (Some(without), Some(with)) = (without, self.mechanics(&values)) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                pieces.branch(u64::from(with.formulas));
                let (block, start) = (with.block, without.wrench());
                let slope = with.wrench() + start * -1.0;
                let level = -start.p / slope.p;
                match (start.p > 0.0, level > 0.0) {
                    (true, true) => pieces.push(level, f64::INFINITY, LIFTED),
                    (false, true) => pieces.push(f64::NEG_INFINITY, level, LIFTED),
                    (false, false) => everywhere(pieces, LIFTED),
                    (true, false) => {}
                }
                let Ok(stages) = path::stages(&block, &start, &slope) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                for stage in stages {
                    push_all(pieces, stage.from, stage.to, of_modes(stage.mode, stage.modes));
                }
            }
            Line::Scan(place) => {
                let values = RefCell::new(values);
                pieces.scan(&self.laws.laws()[place], |x| {
                    let mut values = values.borrow_mut();
                    values[place] = x;
                    self.at(&values)
                });
            }
        }
    }

    fn at(&self, values: &[f64]) -> u64 {
        match self.mechanics(values) {
            Some(mechanics) => Problem::outcomes(&mechanics.block, &mechanics.wrench()),
            None => 1 << NOT_A_BODY,
        }
    }
}

pub(super) fn push_all(pieces: &mut Pieces, from: f64, to: f64, outcomes: u64) {
    (0..COUNT)
        .filter(|outcome| outcomes >> outcome & 1 == 1)
        .for_each(|outcome| pieces.push(from, to, outcome));
}

impl Input {
    pub(super) fn variable(&self) -> Option<&Variable> {
        match &self.quantity {
            Quantity::Key(variable) => Some(variable),
            Quantity::Bias(_) | Quantity::Point(_) | Quantity::Storm(_) => None,
        }
    }

    /// Whether it is this number of the case.
    pub(super) fn is_of(&self, variable: &Variable) -> bool {
        self.variable().is_some_and(|own| own.id() == variable.id())
    }

    pub(super) fn is_friction(&self) -> bool {
        match &self.quantity {
            Quantity::Key(variable) => variable.id() == Id::from(Key::Friction),
            Quantity::Bias(_) | Quantity::Storm(_) => false,
            Quantity::Point(coordinate) => *coordinate == Coordinate::Mu,
        }
    }

    /// Whether the wrench is linear in it.
    fn is_linear(&self) -> bool {
        match &self.quantity {
            Quantity::Bias(_) | Quantity::Point(Coordinate::K) => true,
            Quantity::Point(_) | Quantity::Storm(_) => false,
            Quantity::Key(variable) => variable.id().key == Key::Force,
        }
    }
}

/// Whether of a case's numbers, beside friction, only heights of waves are random.
fn only_heights(inputs: &[Input]) -> bool {
    let heights = [Key::DeepWaterHeight, Key::H13, Key::Hmax];
    let of_case = inputs.iter().filter(|input| !input.is_friction()).filter_map(Input::variable);
    of_case.into_iter().all(|variable| heights.contains(&variable.id().key))
}

fn line(inputs: &[Input]) -> Line {
    let friction = inputs.iter().position(Input::is_friction).map(Line::Friction);
    let load = || inputs.iter().position(Input::is_linear).map(Line::Load);
    friction.or_else(load).unwrap_or(Line::Scan(0))
}
