//! Random numbers of a case as `standfast-probability` takes them: laws, and the modes as intervals along one of them.

use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

use standfast::contact::{Block, friction, path, solve};
use standfast::loads::{Earthquake, LoadSource};
use standfast::{Mode, Modes, Point, Situation, Wrench};
use standfast_probability::copula::{Copula, CopulaError, Correlation};
use standfast_probability::integrate::Life;
use standfast_probability::law::{Distribution, Law, LawError};
use standfast_probability::problem::{Inputs as Laws, Outcomes, Pieces};

use super::read::{Named, Parameter, Random, RandomProblem, Rate, Written, years};
use crate::case::{Acting, Case};
use crate::couple::{Variable, vary};
use crate::error::CaseError;
use crate::inputs::Inputs;
use crate::key::{Id, Key, Range};
use crate::layout::digits;
use crate::parse::CaseFile;
use crate::suggest::closest;

/// What a random number is.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A number of the case file, with what goes with it.
    Key(Variable),
    /// What loads are multiplied by.
    Bias(Bias),
    /// One of the four numbers of the report's problem.
    Point(Coordinate),
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
    line: Line,
}

/// What the numbers are of.
#[derive(Debug, Clone)]
enum Model {
    /// A case, the loads of it that act, and how the base is shaken.
    Case { inputs: Box<Inputs>, case: Box<Case>, acting: Acting, earthquake: Option<Earthquake> },
    /// A point of the report's plane: γ, k', k, μ.
    Point([f64; 4]),
}

/// Along which number the modes are known, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Line {
    /// Friction: its place.
    Friction(usize),
    /// A number in which the wrench is linear.
    Load(usize),
    /// Any other, scanned.
    Scan(usize),
}

/// The outcomes behind those of the modes, which have their codes: more than one mode is consistent.
pub(super) const NOT_UNIQUE: usize = 16;
/// Nothing presses the body on its base.
pub(super) const LIFTED: usize = 17;
/// The numbers do not go together.
pub(super) const NOT_A_BODY: usize = 18;
/// No mode is consistent.
pub(super) const NO_MODE: usize = 19;
const COUNT: usize = 20;

/// The outcomes that exclude each other and add up to one.
pub(super) fn exclusive() -> impl Iterator<Item = usize> {
    (0..16).filter(|code| Mode::from_code(*code as u8).is_some()).chain([NO_MODE, NOT_A_BODY])
}

/// Everything but rest: modes, and what is no body.
pub(super) fn not_rest() -> u64 {
    exclusive()
        .filter(|outcome| *outcome != usize::from(Mode::Rest.code()))
        .fold(0, |set, outcome| set | 1 << outcome)
}

impl Problem {
    /// The problems of a case file with a `[random]` table: one for each set of loads that act together and each acceleration of
    /// the base that is tried.
    ///
    /// # Errors
    /// If the values of the case do not go together, or a name, a law or a correlation is wrong.
    pub fn of(file: &CaseFile, random: &Random, years: Option<f64>) -> Result<Vec<Problem>, CaseError> {
        let case = file.case()?;
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
                problems.push(Problem {
                    id: unique(),
                    model: Model::Case { inputs: inputs_of_case, case, acting, earthquake },
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

    /// Whether friction, or a load, is integrated in closed form; and the name of that number.
    pub(super) fn line_name(&self) -> (&str, bool) {
        let (place, exact) = match self.line {
            Line::Friction(place) | Line::Load(place) => (place, true),
            Line::Scan(place) => (place, false),
        };
        (&self.random[place].name, exact)
    }

    /// Block and wrench with these values, one for each random number; none if they do not go together.
    fn mechanics(&self, values: &[f64]) -> Option<(Block, Wrench)> {
        if let Model::Point(point) = &self.model {
            return self.at_point(*point, values);
        }
        let components = self.components(values)?;
        let mut block = components.block;
        if let Some(place) = self.random.iter().position(Input::is_friction) {
            let ratio = if block.mu_s > 0.0 { block.mu_k / block.mu_s } else { 1.0 };
            (block.mu_s, block.mu_k) = (values[place], values[place] * ratio);
        }
        Some((block, components.wrench(|bias| self.bias(bias, values))))
    }

    fn bias(&self, bias: Bias, values: &[f64]) -> Option<f64> {
        let place = self.random.iter().position(|input| input.quantity == Quantity::Bias(bias));
        place.map(|place| values[place])
    }

    /// Which of the waves' formulas apply.
    fn formulas(&self, values: &[f64]) -> u64 {
        self.components(values).map_or(0, |components| u64::from(components.formulas))
    }

    /// What acts, unbiased, with these values of all numbers but friction; those of the last call if they are the same.
    fn components(&self, values: &[f64]) -> Option<Components> {
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
        let Model::Case { inputs, case, acting, earthquake } = &self.model else { return None };
        let named: Vec<(&Variable, f64)> = self
            .random
            .iter()
            .zip(values)
            // A friction of zero would leave no ratio of slip to stick.
            .filter(|(input, _)| !input.is_friction())
            .filter_map(|(input, value)| Some((input.variable()?, *value)))
            .collect();
        let case = Case::of(&vary(inputs, case, &named)).ok()?;
        let formulas = case.wave.as_ref().map_or(0, |wave| wave.goda.formulas);
        Some(Components::of(&case.situation(*acting, *earthquake).ok()?, formulas))
    }

    /// The report's problem with these values: X = −k, M = k k' γ.
    fn at_point(&self, mut point: [f64; 4], values: &[f64]) -> Option<(Block, Wrench)> {
        for (input, value) in self.random.iter().zip(values) {
            if let Quantity::Point(coordinate) = input.quantity {
                point[coordinate as usize] = *value;
            }
        }
        let [gamma, k_prime, k, mu] = point;
        Point::new(gamma, k_prime, k, mu).ok()?;
        Some((Block::uniform(gamma, mu), Wrench { x: -k, p: 1.0, m: k * k_prime * gamma }))
    }

    /// The outcomes of a block under a wrench.
    fn outcomes(block: &Block, wrench: &Wrench) -> u64 {
        let lifted = u64::from(wrench.p <= 0.0) << LIFTED;
        match solve(block, wrench) {
            Ok(solution) => lifted | of_modes(solution.mode(), solution.modes),
            Err(_) => 1 << NOT_A_BODY,
        }
    }
}

/// What acts on a block, in its units: what each bias is on, and all else.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Components {
    block: Block,
    /// Which of the waves' formulas applied.
    formulas: u32,
    thrust: Wrench,
    uplift: Wrench,
    forces: Wrench,
    others: Wrench,
}

impl Components {
    fn of(situation: &Situation, formulas: u32) -> Components {
        let nothing = Wrench::ZERO;
        let block = situation.block();
        let mut all = Components {
            block,
            formulas,
            thrust: nothing,
            uplift: nothing,
            forces: nothing,
            others: nothing,
        };
        for load in situation.loads() {
            let part = match load.source {
                LoadSource::WavePressure => &mut all.thrust,
                LoadSource::WaveUplift => &mut all.uplift,
                LoadSource::Force => &mut all.forces,
                _ => &mut all.others,
            };
            *part = *part + situation.reduced_wrench(&situation.wrench_of(load));
        }
        all
    }

    /// Their sum, each times what it is biased by.
    fn wrench(&self, bias: impl Fn(Bias) -> Option<f64>) -> Wrench {
        let Block { b1, d, .. } = self.block;
        let times = |wrench: Wrench, force: Bias, moment: Option<Bias>| {
            let of_force = bias(force).unwrap_or(1.0);
            let of_moment = moment.and_then(&bias).unwrap_or(of_force);
            // About O, where engineers have M_p and M_U: C lies at (b₁, d) from it.
            let lever = |x: f64, p: f64| -b1 * p - d * x;
            let about_heel = (wrench.m + lever(wrench.x, wrench.p)) * of_moment;
            let (x, p) = (wrench.x * of_force, wrench.p * of_force);
            Wrench { x, p, m: about_heel - lever(x, p) }
        };
        self.others
            + times(self.thrust, Bias::Thrust, Some(Bias::ThrustMoment))
            + times(self.uplift, Bias::Uplift, Some(Bias::UpliftMoment))
            + times(self.forces, Bias::Force, None)
    }
}

thread_local! {
    /// What was assembled last, of which problem, with which values.
    static LAST: RefCell<Option<(u64, Vec<f64>, Option<Components>)>> = const { RefCell::new(None) };
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
                let Some((block, wrench)) = self.mechanics(&values) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                pieces.branch(self.formulas(&values));
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
                let (Some((block, start)), Some((_, end))) = (without, self.mechanics(&values)) else {
                    return everywhere(pieces, NOT_A_BODY);
                };
                pieces.branch(self.formulas(&values));
                let slope = end + start * -1.0;
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
            Some((block, wrench)) => Problem::outcomes(&block, &wrench),
            None => 1 << NOT_A_BODY,
        }
    }
}

fn push_all(pieces: &mut Pieces, from: f64, to: f64, outcomes: u64) {
    (0..COUNT)
        .filter(|outcome| outcomes >> outcome & 1 == 1)
        .for_each(|outcome| pieces.push(from, to, outcome));
}

impl Input {
    fn variable(&self) -> Option<&Variable> {
        match &self.quantity {
            Quantity::Key(variable) => Some(variable),
            Quantity::Bias(_) | Quantity::Point(_) => None,
        }
    }

    fn is_friction(&self) -> bool {
        match &self.quantity {
            Quantity::Key(variable) => variable.id() == Id::from(Key::Friction),
            Quantity::Bias(_) => false,
            Quantity::Point(coordinate) => *coordinate == Coordinate::Mu,
        }
    }

    /// Whether the wrench is linear in it.
    fn is_linear(&self) -> bool {
        match &self.quantity {
            Quantity::Bias(_) | Quantity::Point(Coordinate::K) => true,
            Quantity::Point(_) => false,
            Quantity::Key(variable) => variable.id().key == Key::Force,
        }
    }
}

fn line(inputs: &[Input]) -> Line {
    let friction = inputs.iter().position(Input::is_friction).map(Line::Friction);
    let load = || inputs.iter().position(Input::is_linear).map(Line::Load);
    friction.or_else(load).unwrap_or(Line::Scan(0))
}

/// From names and laws as they are written to what they are.
struct Resolve<'a>(Names<'a>);

/// What names may stand for.
#[derive(Clone, Copy)]
enum Names<'a> {
    Case(&'a CaseFile, &'a Case),
    Point([f64; 4]),
}

type At<T> = super::read::At<T>;

impl Resolve<'_> {
    fn all(&self, random: &Random) -> At<(Vec<Input>, Laws)> {
        let mut inputs: Vec<Input> = Vec::new();
        let mut laws = Vec::new();
        for named in &random.named {
            let quantity = self.quantity(named)?;
            if let Some(other) = inputs.iter().find(|input| same(&input.quantity, &quantity)) {
                let (name, other) = (named.name.clone(), other.name.clone());
                return Err((RandomProblem::Twice { name, other }, named.span.clone()));
            }
            let (law, cut) = self.law(named, &quantity)?;
            inputs.push(Input { name: named.name.clone(), quantity, every: named.every, cut });
            laws.push(law);
        }
        let correlations: Vec<Correlation> = random
            .correlations
            .iter()
            .map(|&(first, second, measure)| Correlation { first, second, measure })
            .collect();
        let copula = Copula::new(&laws, &correlations).map_err(|error| {
            let at = |first: usize, second: usize| {
                let place = random.correlations.iter().rposition(|(a, b, _)| (*a, *b) == (first, second));
                place.map_or(random.span.clone(), |place| random.correlation_spans[place].clone())
            };
            match error {
                CopulaError::Unattainable { first, second, value, from, to, beside_others } => {
                    let name = |place: usize| inputs[place].name.clone();
                    let problem = RandomProblem::Correlation {
                        first: name(first),
                        second: name(second),
                        value: digits(value),
                        from: digits(from),
                        to: digits(to),
                        beside_others,
                    };
                    (problem, at(first, second))
                }
                CopulaError::Twice { first, second } => {
                    let names = format!("`{}` and `{}`", inputs[first].name, inputs[second].name);
                    let message = format!("the correlation of {names} is given twice");
                    (RandomProblem::Other(message), at(first, second))
                }
                CopulaError::Pair { first, .. } => {
                    let message = format!("`{}` is correlated with itself", inputs[first].name);
                    (RandomProblem::Other(message), at(first, first))
                }
                other => (RandomProblem::Other(other.to_string()), random.span.clone()),
            }
        })?;
        Ok((inputs, Laws::new(laws, copula)))
    }

    /// What a name stands for.
    fn quantity(&self, named: &Named) -> At<Quantity> {
        let (file, case) = match self.0 {
            Names::Case(file, case) => (file, case),
            Names::Point(_) => {
                let found = Coordinate::ALL.into_iter().find(|coordinate| coordinate.name() == named.name);
                return found.map(Quantity::Point).ok_or_else(|| {
                    let (what, name) = ("[random] of a [point]".to_owned(), named.name.clone());
                    let allowed = Coordinate::ALL.map(|coordinate| coordinate.name().to_owned()).to_vec();
                    (RandomProblem::Name { what, name, allowed }, named.span.clone())
                });
            }
        };
        if let Some(bias) = Bias::ALL.into_iter().find(|bias| bias.name() == named.name) {
            let waves = case.wave.is_some();
            let there = if bias == Bias::Force { !case.forces.is_empty() } else { waves };
            if there {
                return Ok(Quantity::Bias(bias));
            }
            let known =
                if bias == Bias::Force { "the case has no [[load]]" } else { "the case has no waves" };
            let (name, known) = (named.name.clone(), known.to_owned());
            return Err((RandomProblem::NoNumber { name, suggestion: None, known }, named.span.clone()));
        }
        // A load by its name.
        let by_name = named.name.strip_prefix("load.").and_then(|rest| rest.rsplit_once('.'));
        let spelled = by_name.and_then(|(load, key)| {
            let place = case.forces.iter().position(|force| force.name.as_deref() == Some(load))?;
            Some(format!("load[{}].{key}", place + 1))
        });
        let name = spelled.as_deref().unwrap_or(&named.name);
        match Variable::find(name, file.inputs()) {
            Ok(variable) => Ok(Quantity::Key(variable)),
            Err(unknown) => {
                let biases = Bias::ALL.map(Bias::name);
                let suggestion = unknown.suggestion.or_else(|| closest(name, biases).map(str::to_owned));
                let known =
                    format!("its numbers are {}, and {}", unknown.names.join(", "), biases.join(", "));
                let name = named.name.clone();
                Err((RandomProblem::NoNumber { name, suggestion, known }, named.span.clone()))
            }
        }
    }

    /// The law of a random number, and what was cut of it because no body has such values.
    fn law(&self, named: &Named, quantity: &Quantity) -> At<(Distribution, f64)> {
        let law = self.plain_law(named, quantity)?;
        let bound = |parameter: &Option<Parameter>, none: f64| match parameter {
            Some(parameter) => self.value(named, quantity, parameter),
            None => Ok(none),
        };
        let (lower, upper) = (bound(&named.lower, f64::NEG_INFINITY)?, bound(&named.upper, f64::INFINITY)?);
        let refused = |error: LawError| {
            (
                RandomProblem::Value {
                    what: format!("the range of `{}`", named.name),
                    written: format!("{} to {}", digits(lower), digits(upper)),
                    expected: format!("a range in which its law has values; {error}"),
                },
                named.span.clone(),
            )
        };
        let (physical, limit) = match quantity {
            quantity => match range(quantity) {
                Range::Finite => (f64::NEG_INFINITY, ""),
                Range::NotNegative => (0.0, "it is negative"),
                Range::Positive | Range::Share => (0.0, "it is zero or less"),
            },
        };
        let asked = Distribution::truncated(law.clone(), lower, upper).map_err(refused)?;
        if lower >= physical {
            return Ok((asked, 0.0));
        }
        let cut = asked.tails(physical).below;
        if cut > 1e-3 {
            let (name, share, limit) = (named.name.clone(), digits(cut), limit.to_owned());
            return Err((RandomProblem::Unphysical { name, share, limit }, named.span.clone()));
        }
        let whole = Distribution::truncated(law, lower.max(physical), upper).map_err(refused)?;
        Ok((whole, cut))
    }

    /// The law before truncation.
    fn plain_law(&self, named: &Named, quantity: &Quantity) -> At<Law> {
        let find = |name: &str| named.parameters.iter().find(|parameter| parameter.name == name);
        let measured =
            |name: &str| find(name).map(|parameter| self.value(named, quantity, parameter)).transpose();
        let plain = |name: &str| find(name).map(|parameter| self.plain(named, parameter)).transpose();
        let lacks = |needed| {
            let (law, name) = (named.law, named.name.clone());
            (RandomProblem::Lacks { law, name, needed }, named.span.clone())
        };
        let need = |name: &'static str| measured(name).and_then(|value| value.ok_or_else(|| lacks(name)));
        let need_plain = |name: &'static str| plain(name).and_then(|value| value.ok_or_else(|| lacks(name)));
        // Mean and deviation; the mean is the case's value where none is given, and 1 of a bias.
        let moments = || -> At<(f64, f64)> {
            let own = match (quantity, self.0) {
                (Quantity::Key(variable), Names::Case(file, case)) => variable.value(file.inputs(), case),
                (Quantity::Point(coordinate), Names::Point(point)) => point[*coordinate as usize],
                _ => 1.0,
            };
            let mean = measured("mean")?.unwrap_or(own);
            match (measured("sd")?, plain("cov")?) {
                (Some(_), Some(_)) => {
                    let found = "both `sd` and `cov`".to_owned();
                    let message = format!(
                        "the law {} of `{}` has {found}; expected one of them",
                        named.law, named.name
                    );
                    Err((RandomProblem::Other(message), named.span.clone()))
                }
                (Some(sd), None) => Ok((mean, sd)),
                (None, Some(cov)) => Ok((mean, cov * mean.abs())),
                (None, None) => Err(lacks("`sd`, a standard deviation, or `cov`, its share of the mean")),
            }
        };
        let law = match named.law {
            "normal" => moments().map(|(mean, sd)| Law::normal(mean, sd))?,
            "lognormal" => moments().map(|(mean, sd)| Law::lognormal(mean, sd))?,
            "gumbel" => {
                let returns: Vec<&Parameter> =
                    named.parameters.iter().filter(|parameter| years(&parameter.name).is_some()).collect();
                match (&returns[..], find("mode").or(find("scale"))) {
                    ([], None) => moments().map(|(mean, sd)| Law::gumbel_of_mean(mean, sd))?,
                    ([], Some(_)) => Law::gumbel(need("mode")?, need("scale")?),
                    ([one, two], None) => {
                        let of = |parameter: &&Parameter| -> At<(f64, f64)> {
                            let value = self.value(named, quantity, parameter)?;
                            Ok((years(&parameter.name).unwrap_or(f64::NAN), value))
                        };
                        Law::gumbel_of_returns(of(one)?, of(two)?)
                    }
                    _ => return Err(lacks("either mean and sd, mode and scale, or two return values")),
                }
            }
            "weibull" => {
                Law::weibull(need("scale")?, need_plain("shape")?, measured("location")?.unwrap_or(0.0))
            }
            "gev" => Law::gev(need("location")?, need("scale")?, need_plain("shape")?),
            "uniform" => Law::uniform(need("from")?, need("to")?),
            "triangular" => Law::triangular(need("from")?, need("mode")?, need("to")?),
            _ => {
                let inner = named.of.as_ref().ok_or_else(|| lacks("a law of which it is the largest"))?;
                let (of, _) = (self.plain_law(inner, quantity)?, ());
                Law::max_of(of.into(), need_plain("count")?)
            }
        };
        law.map_err(|error| match error {
            LawError::Parameter { parameter, value, expected, .. } => {
                let at = find(parameter).map_or(named.span.clone(), |parameter| parameter.span.clone());
                let what = format!("`{parameter}` of the law {} of `{}`", named.law, named.name);
                (RandomProblem::Value { what, written: digits(value), expected: expected.to_owned() }, at)
            }
            other => (RandomProblem::Other(other.to_string()), named.span.clone()),
        })
    }

    /// A parameter in SI units of the random number; deviations and scales too.
    fn value(&self, named: &Named, quantity: &Quantity, parameter: &Parameter) -> At<f64> {
        match (&parameter.value, quantity, self.0) {
            (Written::Text(text), Quantity::Key(variable), Names::Case(file, _)) => {
                variable.read(text, file.inputs()).map_err(|_| {
                    let expected = match variable.dimension() {
                        Some(dimension) => {
                            format!("a number, or {} in {}", dimension.words(), dimension.understood())
                        }
                        None => "a number without unit or quotes".to_owned(),
                    };
                    let what = format!("`{}` of `{}`", parameter.name, named.name);
                    (
                        RandomProblem::Value { what, written: format!("\"{text}\""), expected },
                        parameter.span.clone(),
                    )
                })
            }
            _ => self.plain(named, parameter),
        }
    }

    fn plain(&self, named: &Named, parameter: &Parameter) -> At<f64> {
        match &parameter.value {
            Written::Number(number) if number.is_finite() => Ok(*number),
            written => {
                let written = match written {
                    Written::Number(number) => number.to_string(),
                    Written::Text(text) => format!("\"{text}\""),
                };
                let what = format!("`{}` of `{}`", parameter.name, named.name);
                let expected = "a number without unit or quotes".to_owned();
                Err((RandomProblem::Value { what, written, expected }, parameter.span.clone()))
            }
        }
    }
}

/// Which values a random number can have.
fn range(quantity: &Quantity) -> Range {
    match quantity {
        Quantity::Key(variable) => variable.range(),
        Quantity::Bias(_) => Range::NotNegative,
        Quantity::Point(coordinate) => coordinate.range(),
    }
}

/// Whether two names are one number.
fn same(one: &Quantity, other: &Quantity) -> bool {
    match (one, other) {
        (Quantity::Key(one), Quantity::Key(other)) => one.id() == other.id(),
        (one, other) => one == other,
    }
}
