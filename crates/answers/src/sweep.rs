//! A case of which some numbers vary, answered over and over: the rows of a table, the draws of a sample.
//!
//! Each answer is that of [`Assessment`] for the case with these values, put in by the one [rule](crate::couple) for several keys,
//! and its results stand under the names of the one [list](crate::results), behind those of the case as a whole.
//!
//! ```
//! use standfast_answers::results::ResultValue;
//! use standfast_answers::sweep::{Factor, Sweep, SweepResult};
//! use standfast_model::CaseFile;
//!
//! let text = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n[[load]]\nforce = 1e6\nelevation = 8\n";
//! let file = CaseFile::parse("case.toml", text)?;
//! let sweep = Sweep::of(&file, vec![Factor::find("friction", None, file.inputs())?])?;
//! let mut scratch = sweep.scratch();
//! let mode = SweepResult::find("mode").expect("a result");
//! assert_eq!(sweep.answer(&mut scratch, &[0.6])?.get(mode), ResultValue::Word("RE"));
//! assert_eq!(sweep.answer(&mut scratch, &[0.2])?.get(mode), ResultValue::Word("SL"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod factor;

use std::sync::Arc;

use standfast::Mode;
use standfast::loads::Earthquake;

pub use factor::{Factor, NoFactor, PLAIN, heading};

use crate::assess::{Assessed, Assessment};
use crate::case::{Biases, Case, blamed};
use crate::couple::{STAYS, Variable, change, moved};
use crate::criteria::{Check, asked_for};
use crate::error::{CaseError, Fault, Problem};
use crate::inputs::{Inputs, Value};
use crate::key::{Id, Key, Table};
use crate::results::{ResultKind, ResultName, ResultValue, SeaResult, least_of_joints};
use standfast_model::{CaseFile, Criterion, Warning};

/// A case, and which of its numbers vary.
#[derive(Debug, Clone)]
pub struct Sweep {
    inputs: Inputs,
    case: Case,
    factors: Vec<Factor>,
    /// Numbers that go with those that vary, as they are in the case.
    moved: Vec<(Id, Value)>,
}

/// The inputs of one answer after the other: one for each thread.
#[derive(Debug, Clone)]
pub struct Scratch(Arc<Inputs>);

/// The answer for one set of values.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    assessment: Assessment,
    governing: usize,
    /// The governing criterion, and whether all are met.
    check: Option<(Check, bool)>,
}

/// A result of a case with varied numbers: of the case as a whole, or of the situation that governs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SweepResult {
    /// Name of the governing situation.
    Situation,
    /// The acceleration of the base that is the worst of those tried, to the right, m/s².
    EarthquakeHorizontal,
    /// The acceleration of the base that is the worst of those tried, upwards, m/s².
    EarthquakeVertical,
    /// True if all criteria are met.
    Met,
    /// Utilisation of the governing criterion.
    Utilisation,
    /// The governing criterion.
    Criterion,
    /// The names of the warnings about the case; see [`Answer::warnings`].
    Warnings,
    /// The joint at which the governing criterion is met worst.
    CriterionJoint,
    /// The least safety factor against sliding of all joints.
    LeastSliding,
    /// The least net safety factor against overturning of all joints.
    LeastOverturning,
    /// The modes of all joints from the base up.
    JointModes,
    /// The joints that leave rest first.
    DepartureJoints,
    /// The modes in which the joints leave rest.
    DepartureModes,
    /// Of the governing situation.
    Of(ResultName),
    /// Of the waves.
    Sea(SeaResult),
}

/// A factor on loads beyond which no number is taken.
const LARGEST_BIAS: f64 = 1e50;

/// The names of criteria, which are those of the keys that ask for them.
const CRITERIA: [&str; 23] = [
    "SF_sliding",
    "SF_overturning_net",
    "SF_overturning_gross",
    "SF_uplift",
    "tipping",
    "bearing_max",
    "contact_share",
    "eccentricity",
    "load_factor",
    "ground_factor",
    "effective_pressure_max",
    "rotation_max",
    "p_not_rest",
    "p_life",
    "p_any",
    "beta_life",
    "sliding_mean",
    "p_sliding_over",
    "slide",
    "max_theta",
    "overturned",
    "overturned_share",
    "modes_not",
];

impl Sweep {
    /// The case of a file, and the numbers of it that vary.
    ///
    /// # Errors
    /// If the file's own values do not go together.
    pub fn of(file: &CaseFile, factors: Vec<Factor>) -> Result<Sweep, CaseError> {
        if let Some(table) = in_time(file.inputs()) {
            return Err(file.error(Fault::new(Problem::TableInTime, table)));
        }
        let case = file.case()?;
        let is_of_chance = |factor: &Factor| factor.id().is_some_and(|id| Criterion::is_of_chance(id.key));
        if factors.iter().any(is_of_chance) || case.all_criteria().iter().any(Criterion::is_chance) {
            let why = "of the rows of a table none is found; `standfast probability` and `design` have it"
                .to_owned();
            return Err(file.no_chance(why));
        }
        let mut inputs = file.inputs().clone();
        // What is said of the case is not said again for every answer.
        [Key::Title, Key::Note].into_iter().for_each(|key| inputs.remove(key.into()));
        let variables: Vec<_> = factors.iter().filter_map(Factor::variable).collect();
        let moved = moved(&inputs, &case, &variables).into_iter();
        let gravity = factors.iter().any(|factor| factor.is(Key::Gravity));
        let factors =
            if gravity { factors.into_iter().map(Factor::under_any_gravity).collect() } else { factors };
        let moved = moved.filter_map(|id| Some((id, inputs.get(id)?.clone()))).collect();
        Ok(Sweep { inputs, case, factors, moved })
    }

    /// The case of the file.
    pub fn case(&self) -> &Case {
        &self.case
    }

    /// The numbers that vary, in the order of the values of an answer.
    pub fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// Notes on the numbers that go with those that vary, in sentences.
    pub fn notes(&self) -> Vec<String> {
        notes(&self.factors.iter().filter_map(Factor::variable).collect::<Vec<_>>(), &self.inputs, &self.case)
    }

    /// The names of the situations, by their places; none where there is only one.
    pub fn situations(&self) -> Vec<String> {
        let acting = self.case.acting();
        acting.into_iter().filter_map(|acting| self.case.acting_name(acting)).collect()
    }

    /// The results that the case has, in the order in which they are shown.
    pub fn results(&self) -> Vec<SweepResult> {
        let asked = |factor: &Factor| factor.id().is_some_and(|id| id.key.info().table == Table::Criteria);
        let has_criteria = !self.case.all_criteria().is_empty() || self.factors.iter().any(asked);
        SweepResult::all()
            .filter(|result| match result {
                SweepResult::Situation => !self.situations().is_empty(),
                SweepResult::EarthquakeHorizontal | SweepResult::EarthquakeVertical => {
                    self.case.earthquake.is_some()
                }
                SweepResult::Met | SweepResult::Utilisation | SweepResult::Criterion => has_criteria,
                SweepResult::Of(name) if name.is_of_ground() => self.case.ground.is_some(),
                SweepResult::Of(name) => !name.is_of_plan() || self.case.plan.is_some(),
                SweepResult::Sea(_) => self.case.goda().is_some(),
                SweepResult::Warnings => true,
                SweepResult::CriterionJoint => has_criteria && !self.case.joints.is_empty(),
                SweepResult::LeastSliding
                | SweepResult::LeastOverturning
                | SweepResult::JointModes
                | SweepResult::DepartureJoints
                | SweepResult::DepartureModes => !self.case.joints.is_empty(),
            })
            .collect()
    }

    /// Inputs to answer with.
    pub fn scratch(&self) -> Scratch {
        Scratch(Arc::new(self.inputs.clone()))
    }

    /// The answer for these values, one for each number that varies.
    ///
    /// # Errors
    /// If the case cannot have these values.
    pub fn answer(&self, Scratch(inputs): &mut Scratch, values: &[f64]) -> Result<Answer, Fault> {
        let shared = inputs;
        let inputs = Arc::make_mut(shared);
        for (id, value) in &self.moved {
            inputs.put(*id, value.clone());
        }
        let varied = || self.factors.iter().zip(values.iter().copied());
        let numbers = varied().filter_map(|(factor, value)| Some((factor.variable()?, value)));
        change(inputs, &self.inputs, &self.case, numbers);
        for (factor, value) in varied().filter(|(factor, _)| factor.counts_gravity()) {
            if let Some(id) = factor.id() {
                inputs.put(id, Value::InGravity(value));
            }
        }
        let case = Case::sharing(Arc::clone(shared))?.biased(biases(varied())?)?;
        let assessment = Assessment::owning(case).map_err(|error| blamed(shared, error))?;
        Ok(Answer::of(assessment))
    }

    /// Places of the varied numbers that a fault is about; none if it is about others.
    pub fn blamed(&self, fault: &Fault) -> Vec<usize> {
        let places = || std::iter::once(fault.at).chain(fault.and);
        let is_it = |factor: &Factor| match (factor.bias(), factor.id()) {
            (Some(bias), _) => matches!(fault.problem, Problem::Bias { name, .. } if name == bias.name()),
            (None, Some(id)) => places().any(|place| place == id.into()),
            (None, None) => false,
        };
        (0..self.factors.len()).filter(|place| is_it(&self.factors[*place])).collect()
    }
}

/// The factors on loads among values that vary.
fn biases<'a>(varied: impl Iterator<Item = (&'a Factor, f64)>) -> Result<Biases, Fault> {
    let mut biases = Biases::default();
    for (factor, value) in varied {
        let Some(bias) = factor.bias() else { continue };
        if !(0.0..=LARGEST_BIAS).contains(&value) {
            return Err(Fault::new(Problem::Bias { name: bias.name(), value }, bias.table()));
        }
        biases.set(bias, value);
    }
    Ok(biases)
}

/// The table that makes a case one in time, where it is so.
fn in_time(inputs: &Inputs) -> Option<Table> {
    let of_time = |table: &Table| {
        inputs.has(*table) && (table.is_of_motion() || table.is_history() || *table == Table::Block)
    };
    Table::ALL.into_iter().filter(|_| inputs.is_in_time()).find(of_time)
}

/// Notes on the numbers that go with variables of a case, in sentences.
pub(crate) fn notes(variables: &[&Variable], inputs: &Inputs, case: &Case) -> Vec<String> {
    let mut notes = Vec::new();
    let names: Vec<_> = moved(inputs, case, variables).into_iter().map(|id| id.to_string()).collect();
    if !names.is_empty() {
        notes.push(format!("{} with what varies: {}.", goes(names.len()), names.join(", ")));
    }
    if variables.iter().flat_map(|variable| variable.notes(inputs, case)).any(|note| note == STAYS) {
        notes.push(STAYS.to_owned());
    }
    notes
}

fn goes(count: usize) -> &'static str {
    if count == 1 { "Goes" } else { "Go" }
}

impl Answer {
    fn of(assessment: Assessment) -> Answer {
        let checks = assessment.checks();
        let check = checks.first().map(|first| (first.check, checks.iter().all(|check| check.check.met)));
        let governing = assessment.governing().index;
        Answer { assessment, governing, check }
    }

    /// Everything that is said about the case with these values.
    pub fn assessment(&self) -> &Assessment {
        &self.assessment
    }

    /// Warnings of the case with these values.
    pub fn warnings(&self) -> Vec<Warning> {
        self.assessment.case.warnings()
    }

    /// The situation that governs.
    pub fn governing(&self) -> &Assessed {
        &self.assessment.all[self.governing]
    }

    /// A result that is several names, with blanks between them; `None` without any, and of any other. `warnings` are [its
    /// own](Answer::warnings), which take a search.
    pub fn names(&self, result: SweepResult, warnings: &[Warning]) -> Option<String> {
        let joints = || self.governing().joints.as_ref();
        let joined = |names: Vec<String>| (!names.is_empty()).then(|| names.join(" "));
        let modes = |modes: &[Mode]| joined(modes.iter().map(|mode| mode.symbol().to_owned()).collect());
        match result {
            SweepResult::Warnings => {
                let mut names: Vec<String> = Vec::new();
                for warning in warnings {
                    if !names.iter().any(|name| name == warning.name()) {
                        names.push(warning.name().to_owned());
                    }
                }
                joined(names)
            }
            SweepResult::CriterionJoint => {
                let joint = self.check.and_then(|(check, _)| check.joint)?;
                joined(vec![(joint + 1).to_string()])
            }
            SweepResult::JointModes => modes(joints()?.modes()?),
            SweepResult::DepartureModes => modes(joints()?.departing()),
            SweepResult::DepartureJoints => {
                joined(joints()?.leaves.joints().iter().map(|joint| (joint + 1).to_string()).collect())
            }
            _ => None,
        }
    }

    /// A result; which situation governs, by its place among them.
    pub fn get(&self, result: SweepResult) -> ResultValue {
        let shaken = |of: fn(&Earthquake) -> f64| {
            self.governing()
                .earthquake
                .as_ref()
                .map_or(ResultValue::Nothing, |earthquake| ResultValue::Number(of(earthquake)))
        };
        match result {
            SweepResult::Situation => ResultValue::Number(self.governing as f64),
            SweepResult::EarthquakeHorizontal => shaken(Earthquake::horizontal),
            SweepResult::EarthquakeVertical => shaken(Earthquake::vertical),
            SweepResult::Met => self.check.map_or(ResultValue::Nothing, |(_, met)| ResultValue::Truth(met)),
            SweepResult::Utilisation => {
                let used = self.check.and_then(|(check, _)| check.utilisation);
                used.map_or(ResultValue::Nothing, ResultValue::Number)
            }
            // They are more than one value.
            SweepResult::Warnings
            | SweepResult::CriterionJoint
            | SweepResult::JointModes
            | SweepResult::DepartureJoints
            | SweepResult::DepartureModes => ResultValue::Nothing,
            SweepResult::LeastSliding => least_of_joints(self.governing(), Assessed::least_sliding),
            SweepResult::LeastOverturning => least_of_joints(self.governing(), Assessed::least_overturning),
            SweepResult::Criterion => {
                let name = self.check.map(|(check, _)| check.criterion.name());
                name.map_or(ResultValue::Nothing, ResultValue::Word)
            }
            SweepResult::Of(name) => name.of(self.governing()),
            SweepResult::Sea(name) => {
                let waves = self.assessment.case_of(self.governing()).goda();
                waves.map_or(ResultValue::Nothing, |waves| ResultValue::Number(name.of(&waves.goda)))
            }
        }
    }
}

impl SweepResult {
    /// All of them, in the order in which they are shown.
    pub fn all() -> impl Iterator<Item = SweepResult> {
        let of_case = [
            SweepResult::Situation,
            SweepResult::EarthquakeHorizontal,
            SweepResult::EarthquakeVertical,
            SweepResult::Met,
            SweepResult::Utilisation,
            SweepResult::Criterion,
            SweepResult::Warnings,
            SweepResult::CriterionJoint,
            SweepResult::LeastSliding,
            SweepResult::LeastOverturning,
            SweepResult::JointModes,
            SweepResult::DepartureJoints,
            SweepResult::DepartureModes,
        ];
        let of_situation = ResultName::ALL.iter().copied().map(SweepResult::Of);
        of_case.into_iter().chain(of_situation).chain(SeaResult::ALL.iter().copied().map(SweepResult::Sea))
    }

    /// True if it is given of a case with these criteria only where it is asked for by its name: tables have columns of the names of the
    /// sea themselves.
    pub fn is_by_name(self, criteria: &[Criterion]) -> bool {
        match self {
            SweepResult::Sea(_) => true,
            SweepResult::Of(result) => !result.is_told(criteria),
            _ => false,
        }
    }

    /// True if a table of a case with these criteria has it where no columns are asked for: what happens, how near another answer is, and
    /// what is asked.
    pub fn matters(self, criteria: &[Criterion]) -> bool {
        match self {
            SweepResult::EarthquakeHorizontal | SweepResult::EarthquakeVertical | SweepResult::Sea(_) => {
                false
            }
            SweepResult::Of(result) => {
                const MATTER: [ResultName; 9] = [
                    ResultName::Mode,
                    ResultName::Also,
                    ResultName::LoadFactor,
                    ResultName::DepartureMode,
                    ResultName::SfSliding,
                    ResultName::SfOverturningNet,
                    ResultName::BearingMax,
                    ResultName::ContactShare,
                    ResultName::GroundFactor,
                ];
                let is_asked = |criterion: &Criterion| asked_for(*criterion) == Some(result);
                MATTER.contains(&result) || criteria.iter().any(is_asked)
            }
            _ => true,
        }
    }

    /// The result of a name.
    pub fn find(name: &str) -> Option<SweepResult> {
        SweepResult::all().find(|result| result.name() == name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            SweepResult::Situation => "situation",
            SweepResult::EarthquakeHorizontal => "earthquake_horizontal",
            SweepResult::EarthquakeVertical => "earthquake_vertical",
            SweepResult::Met => "met",
            SweepResult::Utilisation => "utilisation",
            SweepResult::Criterion => "criterion",
            SweepResult::Warnings => "warnings",
            SweepResult::CriterionJoint => "criterion_joint",
            SweepResult::LeastSliding => "SF_sliding_joints",
            SweepResult::LeastOverturning => "SF_overturning_net_joints",
            SweepResult::JointModes => "modes",
            SweepResult::DepartureJoints => "departure_joints",
            SweepResult::DepartureModes => "departure_modes",
            SweepResult::Of(name) => name.name(),
            SweepResult::Sea(name) => name.name(),
        }
    }

    /// Kind of its values; for the situation, which is one of the [names](Sweep::situations) of the case, a number that is its
    /// place among them.
    pub fn kind(self) -> ResultKind {
        use crate::units::Dimension::Acceleration;
        match self {
            SweepResult::Situation
            | SweepResult::Utilisation
            | SweepResult::LeastSliding
            | SweepResult::LeastOverturning => ResultKind::Number(None),
            SweepResult::EarthquakeHorizontal | SweepResult::EarthquakeVertical => {
                ResultKind::Number(Some(Acceleration))
            }
            SweepResult::Met => ResultKind::Truth,
            SweepResult::Criterion => ResultKind::Word(&CRITERIA),
            SweepResult::Warnings
            | SweepResult::CriterionJoint
            | SweepResult::JointModes
            | SweepResult::DepartureJoints
            | SweepResult::DepartureModes => ResultKind::Names,
            SweepResult::Of(name) => name.info().kind,
            SweepResult::Sea(name) => ResultKind::Number(name.info().dimension),
        }
    }

    /// Its meaning, in words.
    pub fn words(self) -> &'static str {
        match self {
            SweepResult::Situation => {
                "the situation that governs, whose results these are: the force that acts alone, or the combination"
            }
            SweepResult::EarthquakeHorizontal => {
                "the acceleration of the base that is the worst of those tried, to the right"
            }
            SweepResult::EarthquakeVertical => "the same upwards",
            SweepResult::Met => "whether all criteria are met",
            SweepResult::Utilisation => {
                "what is used of the governing criterion, met up to 1; none for `modes_not`"
            }
            SweepResult::Criterion => "the governing criterion",
            SweepResult::Warnings => "the names of the warnings about the case, which may be slips",
            SweepResult::CriterionJoint => {
                "the joint at which the governing criterion is met worst, from the base, which is 1"
            }
            SweepResult::LeastSliding => {
                "the least safety factor against sliding of all joints, the base among them"
            }
            SweepResult::LeastOverturning => {
                "the least safety factor against overturning, net, of all joints, the base among them"
            }
            SweepResult::JointModes => {
                "the mode of each joint from the base up under the full load, applied at once, where that is known"
            }
            SweepResult::DepartureJoints => "the joints that leave rest first, from the base, which is 1",
            SweepResult::DepartureModes => "the mode of each joint from the base up as the first leaves rest",
            SweepResult::Of(name) => name.info().words,
            SweepResult::Sea(name) => name.info().words,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_criteria_those_of_the_keys() {
        for result in SweepResult::all() {
            assert_eq!(SweepResult::find(result.name()), Some(result));
        }
        assert_eq!(CRITERIA.to_vec(), Table::Criteria.keys().map(Key::name).collect::<Vec<_>>());
    }
}
