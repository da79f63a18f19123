//! How likely each mode is: the method, the answer, and what matters.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use miette::Diagnostic;
use standfast::Mode;
use standfast_probability::form::{DesignPoint, design_point, generalized, local_design_points};
use standfast_probability::integrate::{
    Integrated, MOST_DIMENSIONS, integrate, integrate_above, integrate_known, integrate_life,
};
use standfast_probability::life::lives;
use standfast_probability::points::MOST_COORDINATES;
use standfast_probability::sample::{
    Effort, Estimate, Sampled, importance, monte_carlo, sampled_known, sobol,
};
use thiserror::Error;

use super::departure::{self, AT_ONCE, Departures, NEVER};
use super::over::Fragility;
use super::point;
use super::problem::{LIFTED, NO_MODE, NOT_A_BODY, NOT_UNIQUE, Problem, exclusive, not_rest};
use super::read::{Random, RandomProblem};
use super::storm::{self, Sliding, SlidingError};
use crate::error::CaseError;
use crate::parse::CaseFile;

/// How probabilities are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Integration between the kinks: all digits, three random numbers at most.
    Integrate,
    /// Scrambled Sobol' points.
    Sobol,
    /// The same about the design points.
    Importance,
    /// Everything drawn, nothing integrated.
    MonteCarlo,
}

impl Method {
    /// All of them.
    pub const ALL: [Method; 4] = [Method::Integrate, Method::Sobol, Method::Importance, Method::MonteCarlo];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Method::Integrate => "integrate",
            Method::Sobol => "sobol",
            Method::Importance => "importance",
            Method::MonteCarlo => "monte-carlo",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = String;

    fn from_str(text: &str) -> Result<Method, String> {
        let names = Method::ALL.map(Method::name).join(", ");
        Method::ALL
            .into_iter()
            .find(|method| method.name() == text)
            .ok_or_else(|| format!("no method is called `{text}`; expected one of {names}"))
    }
}

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Request {
    /// The method; chosen where none is given.
    pub method: Option<Method>,
    /// Seed, precision, floor, points and threads.
    pub effort: Effort,
    /// The years of a life, before those of the file.
    pub years: Option<f64>,
}

/// Why there is no answer.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum ProbabilityError {
    /// The case is not one, or a law is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// Nothing is random.
    #[error("the case file has no [random] table, which says what is random and by which law")]
    #[diagnostic(help("for example\n[random]\nfriction = {{ normal = {{ mean = 0.6, sd = 0.1 }} }}"))]
    NoRandom,
    /// A base that gives way.
    #[error("the case has a [ground], and probabilities are those of a body on a rigid base")]
    #[diagnostic(help("leave [ground] out"))]
    Ground,
    /// More numbers than the method takes.
    #[error("{method} takes {most} random numbers at most, and the case has {numbers}")]
    #[diagnostic(help("without a method one is chosen that does"))]
    TooMany {
        /// The method.
        method: Method,
        /// How many it takes.
        most: usize,
        /// How many there are.
        numbers: usize,
    },
    /// A life of no whole number of years, of which some would have to be drawn.
    #[error("a life of {years} years; expected a whole number, because its years are drawn one by one")]
    #[diagnostic(help("up to three random numbers are integrated, over any number of years"))]
    PartOfYear {
        /// The years.
        years: f64,
    },
    /// Which of several situations is meant is not said.
    #[error("{}; the case has {}", Asked(asked.as_deref()), known.join("; "))]
    #[diagnostic(help("name one of them"))]
    Situation {
        /// What was asked for.
        asked: Option<String>,
        /// Those there are.
        known: Vec<String>,
    },
    /// A number along which there are no probabilities.
    #[error("no probabilities along `{name}`: {what}")]
    Over {
        /// The number.
        name: String,
        /// What is wrong.
        what: String,
    },
    /// Storms that cannot be answered.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Sliding(#[from] SlidingError),
    /// A life in which nothing is drawn each year.
    #[error("a life of {years} years, and no random number is drawn yearly")]
    #[diagnostic(help(
        "say `every = \"year\"` of what is drawn anew each year, such as the sea's largest wave"
    ))]
    NothingYearly {
        /// The years.
        years: f64,
    },
}

/// How a situation was asked for.
struct Asked<'a>(Option<&'a str>);

impl fmt::Display for Asked<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => f.write_str("several sets of loads act one by one"),
            Some(asked) => write!(f, "no situation is called \"{asked}\""),
        }
    }
}

/// How likely each mode is under one set of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Chances {
    /// The set of loads, in words; none where the case leaves no choice.
    pub situation: Option<String>,
    /// The number along which the modes are integrated, and whether in closed form.
    pub line: (String, bool),
    /// The method that was taken.
    pub method: Method,
    /// How many points were drawn; of an integration, how often the modes were asked for.
    pub points: u64,
    /// Whether every probability above the floor is as precise as asked.
    pub precise: bool,
    /// The modes and their probabilities, which add up to one.
    pub modes: Vec<(Happening, Estimate)>,
    /// That the body does not stay at rest.
    pub not_rest: Estimate,
    /// That more than one mode is consistent.
    pub not_unique: Estimate,
    /// That nothing presses the body on its base: part of the modes.
    pub lifted: Estimate,
    /// Where it first leaves rest as the variable loads rise.
    pub first_departure: FirstDeparture,
    /// The nearest point at which the body does not rest; none within reach.
    pub design_point: Option<DesignPoint>,
    /// The probability of not resting if one number were known to have its median, for each.
    pub known: Vec<Estimate>,
    /// Over the years of a life.
    pub life: Option<LifeChances>,
    /// That the body does not rest, each time the points were doubled, with their number; empty where none were drawn.
    pub course: Vec<(u64, Estimate)>,
}

/// How likely each mode is to be the first as the variable loads rise without end; the parts add up to one.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstDeparture {
    /// The modes.
    pub modes: Vec<(Happening, Estimate)>,
    /// That the body rests under any multiple of the loads.
    pub never: Estimate,
    /// That it moves under the permanent loads alone, or under any share of the others, however small.
    pub at_once: Estimate,
    /// Whether every probability above the floor is as precise as asked.
    pub precise: bool,
}

/// How likely it is over a life that something happens at least once.
#[derive(Debug, Clone, PartialEq)]
pub struct LifeChances {
    /// The years.
    pub years: f64,
    /// That the body ever leaves rest.
    pub not_rest: Estimate,
    /// Each mode, at least once.
    pub modes: Vec<(Happening, Estimate)>,
    /// How it was found: years are integrated, or drawn.
    pub method: Method,
    /// Whether every probability above the floor is as precise as asked.
    pub precise: bool,
}

/// What may come of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Happening {
    /// A mode.
    Mode(Mode),
    /// No mode is consistent.
    NoMode,
    /// The numbers drawn do not go together.
    NotABody,
}

impl Happening {
    /// A mode's symbol, or words.
    pub fn name(self) -> String {
        match self {
            Happening::Mode(mode) => mode.to_string(),
            Happening::NoMode => "no mode".to_owned(),
            Happening::NotABody => "not a body".to_owned(),
        }
    }

    pub(super) fn of(outcome: usize) -> Happening {
        match Mode::from_code(outcome as u8) {
            _ if outcome == NOT_A_BODY => Happening::NotABody,
            Some(mode) if outcome != NO_MODE => Happening::Mode(mode),
            _ => Happening::NoMode,
        }
    }
}

/// The answer to a case with random numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Probability {
    /// The file's name.
    pub(super) case: String,
    /// What was asked for.
    pub request: Request,
    /// What is random: names, and what was cut of each law because no body has such values.
    pub random: Vec<(String, f64)>,
    /// The number along which the modes are integrated, and whether in closed form.
    pub line: (String, bool),
    /// Under each set of loads that act together and each acceleration of the base, the least safe first.
    /// None of a storm without a body.
    pub situations: Vec<Chances>,
    /// How far storms slide the body.
    pub sliding: Option<Sliding>,
    /// The probabilities along a number, if they were asked for.
    pub fragility: Option<Fragility>,
}

/// Above this index probabilities are looked for about the design points.
const FAR: f64 = 2.5;

impl Probability {
    /// The answer to a case file with a `[random]` table.
    ///
    /// # Errors
    /// If the case or its random numbers are wrong, or the method asked for does not take as many.
    pub fn of(file: &CaseFile, request: Request) -> Result<Probability, ProbabilityError> {
        let problems = problems_of(file, request.years)?;
        let sliding = match file.storm() {
            Some(storm) => Some(storm::of_case(storm, &problems, &request)?),
            None => None,
        };
        Probability::of_problems(file.name(), problems, sliding, request)
    }

    /// The answer to a file with a `[random]` table: a case, a `[point]` of the report's plane, or a `[storm]` without a body.
    ///
    /// # Errors
    /// As [`of`](Probability::of); or if the text is no such file.
    pub fn of_text(name: &str, text: &str, request: Request) -> Result<Probability, ProbabilityError> {
        if let Some((point, random)) = point::read_file(name, text)? {
            let problem = problem_of_point(name, text, point, &random, request.years)?;
            return Probability::of_problems(name, vec![problem], None, request);
        }
        if let Some(pure) = storm::read_file(name, text, request.years)? {
            return pure.answer(name, request);
        }
        Probability::of(&CaseFile::parse(name, text)?, request)
    }

    fn of_problems(
        name: &str,
        problems: Vec<Problem>,
        sliding: Option<Sliding>,
        request: Request,
    ) -> Result<Probability, ProbabilityError> {
        let mut situations: Vec<Chances> =
            problems.iter().map(|problem| chances(problem, &request)).collect::<Result<_, _>>()?;
        situations.sort_by(|a, b| b.not_rest.value.total_cmp(&a.not_rest.value));
        let first = &problems[0];
        let line = match situations.first() {
            Some(worst) => worst.line.clone(),
            None => (first.line_name().0.to_owned(), first.line_name().1),
        };
        Ok(Probability {
            case: name.to_owned(),
            request,
            random: first.random().iter().map(|input| (input.name.clone(), input.cut)).collect(),
            line,
            situations,
            sliding,
            fragility: None,
        })
    }
}

/// The problem of a `[point]`.
pub(super) fn problem_of_point(
    name: &str,
    text: &str,
    point: [f64; 4],
    random: &Random,
    years: Option<f64>,
) -> Result<Problem, ProbabilityError> {
    let wrong = |(problem, span): (RandomProblem, _)| CaseError::new(name, text, problem.into(), vec![span]);
    Ok(Problem::of_point(point, random, years).map_err(wrong)?)
}

/// The problems of a file: a case, or a `[point]`, with a `[random]` table.
pub(super) fn problems(name: &str, text: &str, years: Option<f64>) -> Result<Vec<Problem>, ProbabilityError> {
    match point::read_file(name, text)? {
        Some((point, random)) => Ok(vec![problem_of_point(name, text, point, &random, years)?]),
        None => problems_of(&CaseFile::parse(name, text)?, years),
    }
}

/// The problems of a case file with a `[random]` table.
pub(super) fn problems_of(file: &CaseFile, years: Option<f64>) -> Result<Vec<Problem>, ProbabilityError> {
    let random = file.random().ok_or(ProbabilityError::NoRandom)?;
    let case = file.case()?;
    if case.ground.is_some() {
        return Err(ProbabilityError::Ground);
    }
    Ok(Problem::of(file, case, random, years)?)
}

/// The sets asked for: what excludes each other, and then the others.
fn sets() -> Vec<u64> {
    exclusive().map(|outcome| 1 << outcome).chain([not_rest(), 1 << NOT_UNIQUE, 1 << LIFTED]).collect()
}

/// The modes of an event and that the body does not rest, and nothing else.
pub(super) fn event(
    problem: &Problem,
    request: &Request,
) -> Result<(Vec<(Happening, Estimate)>, Estimate), ProbabilityError> {
    let (problem, points) = placed(problem);
    let (_, sampled) = sampled(&problem, &points, request)?;
    let count = exclusive().count();
    let modes = exclusive().map(Happening::of).zip(sampled.estimates.iter().copied()).collect();
    Ok((modes, sampled.estimates[count]))
}

/// The nearest points at which the body does not rest, and the problem along the number that matters there.
fn placed(problem: &Problem) -> (Cow<'_, Problem>, Vec<DesignPoint>) {
    let points = local_design_points(problem.laws(), problem, not_rest());
    let along = points.first().and_then(|point| problem.along_what_matters(&point.alpha));
    (along.map_or(Cow::Borrowed(problem), Cow::Owned), points)
}

/// The method, and the probabilities of all sets.
fn sampled(
    problem: &Problem,
    points: &[DesignPoint],
    request: &Request,
) -> Result<(Method, Sampled), ProbabilityError> {
    let laws = problem.laws();
    let numbers = laws.laws().len();
    let few = numbers <= MOST_DIMENSIONS + 1;
    let too_many = |method, most| Err(ProbabilityError::TooMany { method, most, numbers });
    let far = points.first().is_none_or(|point| point.beta > FAR);
    let method = request.method.unwrap_or(match (few, far && !points.is_empty()) {
        (true, _) => Method::Integrate,
        (false, true) => Method::Importance,
        (false, false) => Method::Sobol,
    });
    match method {
        Method::Integrate if !few => return too_many(method, MOST_DIMENSIONS + 1),
        Method::Sobol | Method::Importance if numbers > MOST_COORDINATES => {
            return too_many(method, MOST_COORDINATES);
        }
        _ => {}
    }
    let sets = sets();
    let effort = &request.effort;
    let mut sampled = match method {
        Method::Integrate => estimates(&integrate(laws, problem, &sets)),
        Method::Sobol => sobol(laws, problem, &sets, effort),
        Method::Importance => {
            // About the nearest point of every mode, so that none of them is missed.
            let moved = exclusive().map(|outcome| 1u64 << outcome).filter(|set| set & not_rest() != 0);
            let of_modes = moved.filter_map(|set| design_point(laws, problem, set)).map(|point| point.u);
            let about: Vec<Vec<f64>> = points.iter().map(|point| point.u.clone()).chain(of_modes).collect();
            importance(laws, problem, &sets, &about, effort)
        }
        Method::MonteCarlo => monte_carlo(laws, problem, &sets, effort),
    };
    if method == Method::Importance {
        // Points that are weighed do not add up to one where nothing is looked for: rest is what is left.
        let of_moved = sampled.estimates[exclusive().count()];
        if let Some(place) = exclusive().position(|outcome| outcome == usize::from(Mode::Rest.code())) {
            let Estimate { value, low, high } = of_moved;
            sampled.estimates[place] = Estimate { value: 1.0 - value, low: 1.0 - high, high: 1.0 - low };
        }
    }
    Ok((method, sampled))
}

fn chances(problem: &Problem, request: &Request) -> Result<Chances, ProbabilityError> {
    let (problem, points) = placed(problem);
    let problem = &*problem;
    let laws = problem.laws();
    let numbers = laws.laws().len();
    let few = numbers <= MOST_DIMENSIONS + 1;
    let effort = &request.effort;
    let (method, sampled) = sampled(problem, &points, request)?;
    // Rare events are looked for about the points found, whatever else is known.
    let about: Vec<Vec<f64>> = match method {
        Method::Importance => points.iter().map(|point| point.u.clone()).collect(),
        _ => Vec::new(),
    };
    let known = (0..numbers).map(|number| {
        let set = [not_rest()];
        let found = if few {
            estimates(&integrate_known(laws, problem, &set, number))
        } else {
            sampled_known(laws, problem, &set, number, &about, effort)
        };
        found.estimates[0]
    });
    let [modes @ .., not_rest, not_unique, lifted] = &sampled.estimates[..] else {
        unreachable!("as many as sets")
    };
    let (line, exact) = problem.line_name();
    Ok(Chances {
        situation: problem.situation(),
        line: (line.to_owned(), exact),
        method,
        points: sampled.points,
        precise: sampled.precise,
        modes: exclusive().map(Happening::of).zip(modes.iter().copied()).collect(),
        not_rest: *not_rest,
        not_unique: *not_unique,
        lifted: *lifted,
        known: if numbers > 1 { known.collect() } else { Vec::new() },
        first_departure: first_departure(problem, method, effort, sampled.points),
        design_point: points.into_iter().next(),
        life: life(problem, effort)?,
        course: sampled.course.iter().map(|(points, e)| (*points, e[exclusive().count()])).collect(),
    })
}

/// Departures that are less likely than this are rounding in the answer, not in the body.
const UNLIKELY: f64 = 1e-9;
/// How many points at least may be taken for departures, however few the modes need.
const OF_DEPARTURES: u64 = 1 << 17;

fn first_departure(problem: &Problem, method: Method, effort: &Effort, points: u64) -> FirstDeparture {
    let (laws, departures) = (problem.laws(), Departures(problem));
    let codes: Vec<usize> = departure::exclusive().collect();
    let sets: Vec<u64> = codes.iter().map(|outcome| 1 << outcome).collect();
    // A mode that is next to never the first is not worth more points than all that is asked of the full load.
    let effort = &Effort { points: points.max(OF_DEPARTURES).min(effort.points), ..*effort };
    let found = match method {
        Method::Integrate => estimates(&integrate_above(laws, &departures, &sets, UNLIKELY)),
        // Which mode is first is seldom a rare event, and lies about no one point.
        Method::Sobol | Method::Importance => sobol(laws, &departures, &sets, effort),
        Method::MonteCarlo => monte_carlo(laws, &departures, &sets, effort),
    };
    let precise = found.precise;
    let of = |outcome: usize| {
        let place = codes.iter().position(|code| *code == outcome);
        found.estimates[place.expect("one of the outcomes")]
    };
    let modes = codes.iter().filter(|code| ![NEVER, AT_ONCE].contains(code));
    let modes = modes.map(|code| (Happening::of(*code), of(*code))).collect();
    FirstDeparture { modes, never: of(NEVER), at_once: of(AT_ONCE), precise }
}

fn life(problem: &Problem, effort: &Effort) -> Result<Option<LifeChances>, ProbabilityError> {
    let Some(life) = problem.life() else { return Ok(None) };
    let numbers = problem.random().len();
    let sets: Vec<u64> = exclusive().map(|outcome| 1 << outcome).chain([not_rest()]).collect();
    let yearly = problem.along_yearly();
    let (found, method) = match yearly {
        None => return Err(ProbabilityError::NothingYearly { years: life.years }),
        // A scan for each pair of the others would take minutes.
        Some(problem) if numbers <= MOST_DIMENSIONS + usize::from(!problem.is_scanned()) => {
            let integrated = integrate_life(problem.laws(), &problem, &sets, &life);
            (estimates(&integrated), Method::Integrate)
        }
        Some(_) if life.years.fract() != 0.0 => {
            return Err(ProbabilityError::PartOfYear { years: life.years });
        }
        Some(_) => (lives(problem.laws(), problem, &sets, &life, effort), Method::Sobol),
    };
    let [modes @ .., not_rest] = &found.estimates[..] else { unreachable!("as many as sets") };
    let modes = exclusive().map(Happening::of).zip(modes.iter().copied()).collect();
    let (years, precise) = (life.years, found.precise);
    Ok(Some(LifeChances { years, not_rest: *not_rest, modes, method, precise }))
}

/// Integrals with their errors as intervals.
fn estimates(integrated: &Integrated) -> Sampled {
    let with = |(value, error): (&f64, &f64)| {
        let value = value.clamp(0.0, 1.0);
        Estimate { value, low: (value - error).max(0.0), high: (value + error).min(1.0) }
    };
    Sampled {
        estimates: integrated.probabilities.iter().zip(&integrated.errors).map(with).collect(),
        points: integrated.evaluations,
        precise: true,
        course: Vec::new(),
    }
}

impl Chances {
    /// −Φ⁻¹ of the probability that the body does not rest; none where that is 0 or 1.
    pub fn generalized(&self) -> Option<f64> {
        Some(generalized(self.not_rest.value)).filter(|beta| beta.is_finite())
    }
}
