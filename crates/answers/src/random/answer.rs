//! Probabilities of the modes: the request, and the answer.

use std::fmt;
use std::str::FromStr;

use standfast::Verdict;
use standfast_probability::fit::{Fit, FittedParameter};
use standfast_probability::form::{FormPoint, generalized};
use standfast_probability::method::Method;
use standfast_probability::sample::{Effort, Estimate};
use standfast_probability::slopes::Slopes;
use standfast_watch::Portion;

use super::chances::chances;
use super::criterion::{ChanceCriterion, Known, checked, slides_asked};
use super::design_values::DesignValues;
use super::error::ProbabilityError;
use super::fragility::Fragility;
use super::joined::{JoinedChance, joined};
use super::outcome::{NOT_A_BODY, PLAN_SLIDES, PLAN_TIPS, joint};
use super::overturn::Overturning;
use super::problem::ChanceProblem;
use super::quantity::RandomInput;
use super::row::{RowChances, row_of};
use super::storm::{self, Sliding};
use super::subject::{ChanceSubject, problems_of};
use crate::case::{BASE, called};
use crate::digits::digits;
use crate::error::Fault;
use crate::key::Key;
use crate::units::Dimension;
use standfast_inputs::random::{RandomProblem, Rate};
use standfast_model::{CaseFile, Criterion, Warning};

/// A method as it is asked for by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MethodAsked {
    /// One that finds probabilities.
    By(Method),
    /// FORM: the nearest point of every mode. It ranks and gives no probability, so that those beside it are found by the method
    /// that suits.
    Form,
}

impl FromStr for MethodAsked {
    type Err = String;

    fn from_str(text: &str) -> Result<MethodAsked, String> {
        const FORM: &str = "form";
        let method = Method::find(text).map(MethodAsked::By);
        method.or((text == FORM).then_some(MethodAsked::Form)).ok_or_else(|| {
            let names = Method::ALL.map(Method::name).join(", ");
            format!("no method is called `{text}`; expected one of {names}, {FORM}")
        })
    }
}

/// Request for probabilities.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ChanceRequest {
    /// The method; chosen where none is given.
    pub method: Option<Method>,
    /// Seed, precision, floor, points and threads.
    pub effort: Effort,
    /// The years of a life, before those of the file.
    pub years: Option<f64>,
    /// True if waves that begin a rotation are followed by the motion in time.
    pub follow: bool,
    /// True if the nearest point of every mode is looked for.
    pub form: bool,
}

impl ChanceRequest {
    /// Request with a method that is asked for.
    pub fn with(self, asked: MethodAsked) -> ChanceRequest {
        match asked {
            MethodAsked::By(method) => ChanceRequest { method: Some(method), ..self },
            MethodAsked::Form => ChanceRequest { form: true, ..self },
        }
    }
}

/// Probabilities of the modes under one set of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Chances {
    /// The set of loads, in words; none where the case leaves no choice.
    pub situation: Option<String>,
    /// The number along which the modes are integrated, and whether in closed form.
    pub line: (String, bool),
    /// The method that was taken.
    pub method: Method,
    /// True if an integration was begun, and given up for that method because it would have taken too long.
    pub given_up: bool,
    /// Number of points drawn; of an integration, number of times the modes were asked for.
    pub points: u64,
    /// True if every probability above the floor is as precise as asked.
    pub precise: bool,
    /// The modes and their probabilities, which add up to one.
    pub modes: Vec<(Happening, Estimate)>,
    /// That the body does not stay at rest.
    pub not_rest: Estimate,
    /// That more than one mode is consistent; `None` of bodies on joints, of which it is not asked.
    pub not_unique: Option<Estimate>,
    /// That nothing presses the body on its base: part of the modes.
    pub lifted: Estimate,
    /// Departure from rest that comes first as the variable loads rise.
    pub first_departure: FirstDeparture,
    /// The nearest point at which the body does not rest; none within reach.
    pub design_point: Option<FormPoint>,
    /// The nearest point of every mode that has one within reach, and of numbers that do not go together; none unless asked for.
    pub design_points: Option<Vec<(Happening, FormPoint)>>,
    /// The values of the numbers for the index that is asked for.
    pub design_values: Option<DesignValues>,
    /// How the probability of not resting changes with mean and deviation of each law, if it is asked; none of a law without a deviation.
    pub slopes: Option<Vec<Option<Slopes>>>,
    /// The probability of not resting if one number were known to have its median, for each.
    pub known: Vec<Estimate>,
    /// Over the years of a life.
    pub life: Option<LifeChances>,
    /// That the body does not rest, each time the points were doubled, with their number; empty where none were drawn.
    pub course: Vec<(u64, Estimate)>,
}

/// Probabilities that each mode is the first as the variable loads rise without end; the parts add up to one.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstDeparture {
    /// The modes.
    pub modes: Vec<(Happening, Estimate)>,
    /// That the body rests under any multiple of the loads.
    pub never: Estimate,
    /// That it moves under the permanent loads alone, or under any share of the others, however small.
    pub at_once: Estimate,
    /// True if every probability above the floor is as precise as asked.
    pub precise: bool,
}

/// Probability that something happens at least once over a life.
#[derive(Debug, Clone, PartialEq)]
pub struct LifeChances {
    /// The years.
    pub years: f64,
    /// Number of events a year on average, where they come by Poisson's law.
    pub events: Option<f64>,
    /// That the body ever leaves rest.
    pub not_rest: Estimate,
    /// The same of one that stayed at rest for years before.
    pub stood: Option<Stood>,
    /// Each mode, at least once.
    pub modes: Vec<(Happening, Estimate)>,
    /// Method by which it was found: years are integrated, or drawn.
    pub method: Method,
    /// True if every probability above the floor is as precise as asked.
    pub precise: bool,
}

impl LifeChances {
    /// That the body leaves rest in the years to come: of one that stayed at rest before, by what that says.
    pub fn ahead(&self) -> Estimate {
        self.stood.map_or(self.not_rest, |stood| stood.not_rest)
    }
}

/// What years at rest say of those that follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stood {
    /// The years through which it stayed at rest.
    pub years: f64,
    /// That it leaves rest in the years that follow.
    pub not_rest: Estimate,
}

/// Outcome of a draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Happening {
    /// A mode begins, or the ground fails.
    Decided(Verdict),
    /// Of bodies on joints, this one leaves rest first.
    First(FirstJoint),
    /// On a base seen from above, this ends rest as the loads rise: the body slides, or else it tips.
    OnPlan {
        /// True if it slides.
        slides: bool,
    },
    /// No mode is consistent.
    NoMode,
    /// The numbers drawn do not go together.
    NotABody,
}

/// Joint that leaves rest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FirstJoint {
    /// Its place from the base, which is zero.
    pub joint: usize,
    /// True if what is above it slides; else it turns about an end of the joint.
    pub slides: bool,
}

impl fmt::Display for FirstJoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "joint {} {}", self.joint + 1, self.does())
    }
}

impl FirstJoint {
    /// What is above the joint does, as a predicate of the joint.
    pub fn does(self) -> &'static str {
        if self.slides { "slides" } else { "rocks" }
    }
}

impl Happening {
    /// Rest.
    pub const REST: Happening = Happening::Decided(Verdict::REST);

    /// Motion of the body, or failure of the ground, in words; none where there is no mode.
    pub fn words(self) -> Option<&'static str> {
        match self {
            Happening::Decided(verdict) => Some(verdict.words()),
            Happening::OnPlan { slides: true } => Some("leaves rest by sliding"),
            Happening::OnPlan { slides: false } => Some("leaves rest by tipping about an edge"),
            Happening::First(_) | Happening::NoMode | Happening::NotABody => None,
        }
    }

    /// A mode's symbol, that of ground that fails, or words.
    pub fn name(self) -> String {
        match self {
            Happening::Decided(verdict) => verdict.to_string(),
            Happening::First(first) => first.to_string(),
            Happening::OnPlan { slides } => if slides { "slides" } else { "tips" }.to_owned(),
            Happening::NoMode => "no mode".to_owned(),
            Happening::NotABody => "not a body".to_owned(),
        }
    }

    pub(super) fn of(outcome: usize) -> Happening {
        if let Some((joint, slides)) = joint(outcome) {
            return Happening::First(FirstJoint { joint, slides });
        }
        if let PLAN_SLIDES | PLAN_TIPS = outcome {
            return Happening::OnPlan { slides: outcome == PLAN_SLIDES };
        }
        match Verdict::from_code(outcome as u8) {
            Some(verdict) => Happening::Decided(verdict),
            None if outcome == NOT_A_BODY => Happening::NotABody,
            None => Happening::NoMode,
        }
    }
}

/// A number that is random.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomNumber {
    /// Its name, as in the file.
    pub name: String,
    /// Its meaning in a few words.
    pub words: String,
    /// Share of its law that was cut because no body has such values.
    pub cut: f64,
    /// The dimension of its values, where they have one.
    pub dimension: Option<Dimension>,
    /// True if it is drawn anew each year.
    pub yearly: bool,
    /// True if each body of a row draws it for itself.
    pub own: bool,
    /// True if it is the rise of the water, which goes with the time.
    pub is_rise: bool,
    /// Law that was fitted to values of it.
    pub fit: Option<Fit>,
}

impl RandomNumber {
    pub(super) fn of(input: &RandomInput) -> RandomNumber {
        let dimension = input.dimension();
        RandomNumber {
            name: input.name.clone(),
            words: input.words(),
            cut: input.cut,
            dimension,
            yearly: input.every == Rate::Year,
            own: input.own,
            is_rise: input.rise_of().is_some(),
            fit: input.fit.clone(),
        }
    }

    /// Law that was fitted, with its parameters and their standard errors: `gumbel, fitted to 30 values: mode 4.34 m ± 0.18 m, scale 0.54 m ± 26 %`.
    pub fn fit_words(&self) -> Option<String> {
        let fit = self.fit.as_ref()?;
        let parameter = |of: &FittedParameter| {
            let plain = |value: f64| if of.has_dimension { self.written(value) } else { digits(value) };
            let error = match of.is_positive {
                true => format!("{} %", digits(100.0 * of.deviation)),
                false => plain(of.deviation),
            };
            format!("{} {} ± {error}", of.name.replace('_', " "), plain(of.estimate))
        };
        let parameters: Vec<String> = fit.parameters.iter().map(parameter).collect();
        Some(format!("{}, fitted to {} values: {}", fit.family.name(), fit.count, parameters.join(", ")))
    }

    /// What goes with one unit of it, on paper.
    pub fn per_unit(&self, slope: f64) -> String {
        self.dimension.map_or_else(
            || digits(slope),
            |dimension| {
                let (unit, scale) = dimension.on_paper();
                format!("{} per {unit}", digits(slope * scale))
            },
        )
    }

    /// A value of it on paper: with its unit, of a dimension.
    pub fn written(&self, value: f64) -> String {
        self.dimension.map_or_else(|| digits(value), |dimension| dimension.written(value))
    }
}

/// The answer to a case with random numbers.
#[derive(Debug, Clone)]
pub struct Probability {
    /// The file's name.
    pub case: String,
    /// The title in the file, where it has one.
    pub title: Option<String>,
    /// The problem under the least safe set of loads; none of a storm without a body.
    pub problem: Option<Box<ChanceProblem>>,
    /// Share of all draws in which the sea is steeper than waves in deep water can be.
    pub steep_seas: f64,
    /// Request that was answered.
    pub request: ChanceRequest,
    /// Random numbers.
    pub random: Vec<RandomNumber>,
    /// The number along which the modes are integrated, and whether in closed form.
    pub line: (String, bool),
    /// Under each set of loads that act together and each acceleration of the base, the least safe first.
    /// None of a storm without a body.
    pub situations: Vec<Chances>,
    /// That any of several situations moves the body; none where there is only one.
    pub joined: Option<JoinedChance>,
    /// That any of the bodies of a row moves, under any of the situations; none of a body that stands in no row.
    pub row: Option<RowChances>,
    /// Criteria that `[criteria]` sets for it, the one of which most is used first.
    pub criteria: Vec<ChanceCriterion>,
    /// Slides of the body in storms.
    pub sliding: Option<Sliding>,
    /// Overturning over the peak of a shaking, if it was asked for.
    pub overturning: Option<Overturning>,
    /// The probabilities along a number, if they were asked for.
    pub fragility: Option<Fragility>,
    /// That a case in time is answered at its first instant, in a sentence without its stop.
    pub note: Option<String>,
}

impl Probability {
    /// Unusual numbers of the case at its present values.
    pub fn warnings(&self) -> Vec<Warning> {
        let case = self.problem.as_ref().and_then(|problem| problem.case());
        let mut warnings = case.map_or(Vec::new(), |(case, _)| case.warnings());
        let share = self.steep_seas;
        warnings.extend((share > 0.0).then_some(Warning::SteepSeas { share }));
        // Fewer are told beside the slides alone.
        const MANY: f64 = 0.01;
        let sliding = self.sliding.as_ref().filter(|sliding| sliding.followed.is_none());
        warnings.extend(sliding.filter(|sliding| sliding.rotating.life.value > MANY).map(|sliding| {
            Warning::WavesLeftOut { share: sliding.rotating.life.value, gives_way: sliding.gives_way }
        }));
        warnings
    }

    /// True if the body stands on joints of its own, of which it is answered which leaves rest first.
    pub fn has_joints(&self) -> bool {
        self.problem.as_ref().is_some_and(|problem| problem.has_joints())
    }

    /// True if the base is seen from above, of which it is found whether the body rests and what ends rest.
    pub fn is_on_plan(&self) -> bool {
        self.problem.as_ref().is_some_and(|problem| problem.is_on_plan())
    }

    /// What leaves rest first, in a clause: `joint 3 (cap) slides first`.
    pub fn first_words(&self, first: FirstJoint) -> String {
        format!("{} {} first", self.joint_called(first.joint), first.does())
    }

    /// Joint by its number and name, from its place from the base, which is zero: `joint 3 (cap)`.
    fn joint_called(&self, joint: usize) -> String {
        let case = self.problem.as_ref().and_then(|problem| problem.case());
        let name = match (joint, case) {
            (0, _) => Some(BASE),
            (above, Some((case, _))) => case.joints.get(above - 1).and_then(|joint| joint.name.as_deref()),
            (_, None) => None,
        };
        called(joint, name)
    }

    /// The answer to a file with a `[random]` table: a case, one in time at its first instant, a `[point]` of the report's plane, or
    /// a `[storm]` without a body.
    ///
    /// # Errors
    /// If the case or its random numbers are wrong, or the method asked for does not take as many.
    pub fn of(file: &CaseFile, request: ChanceRequest) -> Result<Probability, ProbabilityError> {
        Probability::watched(file, request, Portion::UNSEEN)
    }

    /// As [`of`](Probability::of), as a portion of work that somebody may watch. What goes along a number has no part in it, and whoever does not
    /// ask for that does not carry it along.
    ///
    /// # Errors
    /// As [`of`](Probability::of); if the work is stopped.
    pub fn watched(
        file: &CaseFile,
        request: ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        let mut asked = ChanceSubject::of(file, request.years)?;
        if let ChanceSubject::Case { note: Some(_), moving, .. } = &mut asked {
            *moving = None;
        }
        let answer = Probability::of_asked(file.name(), &asked, request, portion)?;
        Ok(Probability { title: file.inputs().text(Key::Title).map(str::to_owned), ..answer })
    }

    pub(super) fn of_asked(
        name: &str,
        asked: &ChanceSubject,
        request: ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        match asked {
            ChanceSubject::Case { file, note, moving } => {
                Probability::of_case(file, note.clone(), moving.as_deref(), request, portion)
            }
            ChanceSubject::Point(of) => {
                let problem = of.problem(of.point, request.years)?;
                Probability::of_problems(name, &[problem], None, request, portion)
            }
            ChanceSubject::Storm(pure) => pure.answer(name, request, portion),
        }
    }

    fn of_case(
        file: &CaseFile,
        note: Option<String>,
        moving: Option<&CaseFile>,
        request: ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        let problems = problems_of(file, request.years, moving)?;
        let storm = storm::storm(file.inputs()).map_err(|fault| file.error(fault))?;
        let asked: Vec<Criterion> = file.case()?.all_criteria();
        let asked: Vec<Criterion> = asked.into_iter().filter(Criterion::is_chance).collect();
        let of_criteria = if asked.is_empty() { 0.0 } else { 1.0 };
        let weights = [if storm.is_some() { 40.0 } else { 0.0 }, 2.0, of_criteria];
        let [of_storm, of_problems, of_criteria] = portion.parts(weights);
        let over = slides_asked(&asked);
        let sliding = match storm {
            Some(storm) => {
                let found = storm::of_case(&storm, &problems, &request, &over, of_storm);
                Some(found.map_err(|error| match error.key() {
                    Some(key) => {
                        let problem = RandomProblem::Other(error.to_string());
                        ProbabilityError::from(file.error(Fault::new(problem.into(), key)))
                    }
                    None => error.into(),
                })?)
            }
            None => None,
        };
        let answer = Probability::of_problems(file.name(), &problems, sliding, request, of_problems)?;
        let known = Known {
            situations: &answer.situations,
            sliding: answer.sliding.as_ref(),
            row: answer.row.as_ref(),
        };
        let criteria = checked(&asked, &problems, &known, &request, of_criteria)?;
        Ok(Probability { criteria, note, ..answer })
    }

    fn of_problems(
        name: &str,
        problems: &[ChanceProblem],
        sliding: Option<Sliding>,
        request: ChanceRequest,
        portion: Portion<'_>,
    ) -> Result<Probability, ProbabilityError> {
        let several = if problems.len() > 1 { 1.0 } else { 0.0 };
        let in_row = if problems[0].row().is_some() { 2.0 } else { 0.0 };
        let [each, of_joined, of_row] = portion.parts([5.0, several, in_row]);
        let all: Vec<&ChanceProblem> = problems.iter().collect();
        let of = |(place, problem)| chances(problem, &request, each.part(place, problems.len()));
        let mut situations: Vec<Chances> = problems.iter().enumerate().map(of).collect::<Result<_, _>>()?;
        standfast::order::by_number(&mut situations, |one| -one.not_rest.value);
        let first = &problems[0];
        let worst = situations.first().and_then(|worst| {
            problems.iter().find(|problem| problem.situation() == worst.situation).cloned().map(Box::new)
        });
        let line = match situations.first() {
            Some(worst) => worst.line.clone(),
            None => (first.line_name().0.to_owned(), first.line_name().1),
        };
        Ok(Probability {
            case: name.to_owned(),
            title: None,
            steep_seas: first.share_of_steep_seas(),
            problem: worst,
            request,
            random: first.random().iter().map(RandomNumber::of).collect(),
            line,
            situations,
            joined: joined(&all, &request, of_joined)?,
            row: row_of(&all, &request.effort, of_row)?,
            sliding,
            criteria: Vec::new(),
            overturning: None,
            fragility: None,
            note: None,
        })
    }
}
impl Chances {
    /// −Φ⁻¹ of the probability that the body does not rest; none where that is 0 or 1.
    pub fn generalized(&self) -> Option<f64> {
        Some(generalized(self.not_rest.value)).filter(|beta| beta.is_finite())
    }
}
