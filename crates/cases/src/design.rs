//! Design: the least value of a quantity that meets a target, and what every number of a case does to its
//! safety.
//!
//! Nothing is linearised or scaled: for each value tried, everything that follows from it, waves and water included, is computed
//! anew from the typed inputs.

mod json;
mod search;
mod sensitivity;
mod target;
mod text;

pub use sensitivity::{Change, Sensitivity, sensitivities};
pub use target::{Target, TargetError};

use miette::Diagnostic;
use thiserror::Error;

use crate::assess::{Assessed, Assessment};
use crate::case::Case;
use crate::couple::{Unknown, Variable, vary};
use crate::error::{CaseError, Problem};
use crate::inputs::Inputs;
use crate::layout::digits;
use crate::parse::CaseFile;
use crate::units::{Dimension, UnitError};
use search::{Found, search};

/// Why there is no design.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum DesignError {
    /// The case file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// A name that is no number of the case.
    #[error("the case has no `{}` to vary", .0.name)]
    #[diagnostic(help("{}", known(.0)))]
    UnknownVariable(Unknown),
    /// An end of the bracket that is no value of the quantity.
    #[error("{option} is \"{written}\", and {error}")]
    #[diagnostic(help("expected a number in SI units{}", units(*dimension)))]
    Bracket {
        /// The option.
        option: &'static str,
        /// What was given.
        written: String,
        /// What it should measure; `None` for a plain number.
        dimension: Option<Dimension>,
        /// What is wrong with it.
        error: UnitError,
    },
    /// A bracket without inside.
    #[error("the bracket from {from} to {to} is empty; give its ends with --from and --to, in SI units")]
    EmptyBracket {
        /// Its lower end, SI.
        from: f64,
        /// Its upper end, SI.
        to: f64,
    },
    /// An end of the bracket that the quantity cannot have.
    #[error("{option} is \"{written}\"; expected {expected}, as {name} has to be")]
    Impossible {
        /// The option.
        option: &'static str,
        /// What was given.
        written: String,
        /// What was varied.
        name: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// The target does not depend on the quantity.
    #[error("{name} does not change how far the case is from {target}: whatever its value, {binding}")]
    #[diagnostic(help("another quantity helps: see the sensitivities of a target that can be met"))]
    NoInfluence {
        /// What was varied.
        name: String,
        /// The target.
        target: Target,
        /// What fails.
        binding: String,
    },
    /// No value meets the target.
    #[error("no {name} from {from} to {to} meets the target {target}; {best}")]
    #[diagnostic(help(
        "--from and --to widen the range; another quantity may help more: see the sensitivities of a \
        target that can be met"
    ))]
    Unmet {
        /// What was varied.
        name: String,
        /// The lower end of the bracket.
        from: String,
        /// Its upper end.
        to: String,
        /// The target.
        target: Target,
        /// The best that was reached.
        best: String,
    },
}

/// What to design.
#[derive(Debug, Clone)]
pub struct Request {
    /// The quantity to vary.
    pub vary: String,
    /// What it has to reach.
    pub target: Target,
    /// Where to begin, with a unit or in SI; a fifth of the present value if not given.
    pub from: Option<String>,
    /// Where to end; five times the present value if not given.
    pub to: Option<String>,
}

/// A case that is varied.
struct Varied<'a> {
    file: &'a CaseFile,
    case: &'a Case,
}

impl Varied<'_> {
    fn inputs(&self) -> &Inputs {
        self.file.inputs()
    }

    fn case_with(&self, variable: &Variable, value: f64) -> Result<Case, CaseError> {
        let inputs = vary(self.inputs(), self.case, &[(variable, value)]);
        Case::of(&inputs).map_err(|fault| self.file.error(fault))
    }

    fn answer(&self, variable: &Variable, value: f64) -> Result<Assessment, DesignError> {
        Ok(Assessment::of(&self.case_with(variable, value)?).map_err(|error| self.file.refused(error))?)
    }
}

/// SF_sliding of a situation.
fn sliding(assessed: &Assessed) -> f64 {
    assessed.outcome.stability.sliding
}

/// SF_overturning of a situation, about either corner.
fn overturning(assessed: &Assessed) -> f64 {
    assessed.outcome.stability.overturning()
}

/// Up to which multiple of its variable loads a situation leaves the body at rest.
fn load_factor(assessed: &Assessed) -> f64 {
    assessed.departure().load_factor()
}

/// The least of a number over all situations.
fn least(assessment: &Assessment, of: fn(&Assessed) -> f64) -> f64 {
    of(assessment.least(of))
}

/// The least value that meets a target, with what it rests on.
pub struct Design<'a> {
    file: &'a CaseFile,
    request: Request,
    variable: Variable,
    value: f64,
    bracket: [f64; 2],
    present: Assessment,
    found: Found,
    sensitivities: Vec<Sensitivity>,
}

impl<'a> Design<'a> {
    /// Designs the case of a file.
    ///
    /// # Errors
    /// If the case makes no sense or lacks the quantity, or the target cannot be met.
    pub fn of(file: &'a CaseFile, request: Request) -> Result<Design<'a>, DesignError> {
        let case = file.case()?;
        let varied = Varied { file, case: &case };
        let variable = Variable::find(&request.vary, file.inputs()).map_err(DesignError::UnknownVariable)?;
        let value = variable.value(file.inputs(), &case);
        let bracket = bracket(&request, &variable, value)?;
        possible(&varied, &request, &variable, bracket)?;
        let present = Assessment::of(&case).map_err(|error| file.refused(error))?;
        let found = search(&varied, &variable, request.target, bracket)?;
        let sensitivities = sensitivity::all(&varied, Some(&present));
        Ok(Design { file, request, variable, value, bracket, present, found, sensitivities })
    }

    /// What is unusual about the case with the value found, and is not at present.
    fn new_warnings(&self) -> Vec<crate::Warning> {
        let present = self.present.case.warnings();
        let mut warnings = self.found.answer.case.warnings();
        warnings.retain(|warning| !present.contains(warning));
        warnings
    }

    fn notes(&self) -> Vec<String> {
        self.variable.notes(self.file.inputs(), &self.present.case)
    }

    /// The design for reading.
    pub fn text(&self) -> String {
        text::render(self)
    }

    /// The design as one JSON document, at full precision.
    pub fn json(&self) -> String {
        json::render(self)
    }
}

fn bracket(request: &Request, variable: &Variable, present: f64) -> Result<[f64; 2], DesignError> {
    let end = |option, written: &Option<String>, default: f64| match written {
        None => Ok(default),
        Some(written) => variable.parse(written).map_err(|error| {
            let dimension = variable.dimension();
            DesignError::Bracket { option, written: written.clone(), dimension, error }
        }),
    };
    let [low, high] = [present / 5.0, present * 5.0];
    let from = end("--from", &request.from, low.min(high))?;
    let to = end("--to", &request.to, low.max(high))?;
    if from < to { Ok([from, to]) } else { Err(DesignError::EmptyBracket { from, to }) }
}

/// Refuses ends, where given, with a sign that the quantity cannot have.
fn possible(
    varied: &Varied<'_>,
    request: &Request,
    variable: &Variable,
    [from, to]: [f64; 2],
) -> Result<(), DesignError> {
    for (option, written, value) in [("--from", &request.from, from), ("--to", &request.to, to)] {
        let Some(written) = written.clone().filter(|_| value < 0.0) else { continue };
        if let Err(error) = varied.case_with(variable, value)
            && let Problem::OutOfRange { key, expected, .. } = *error.problem()
            && variable.id().key == key
        {
            return Err(DesignError::Impossible {
                option,
                written,
                name: variable.name().to_owned(),
                expected,
            });
        }
    }
    Ok(())
}

fn units(dimension: Option<Dimension>) -> String {
    let units = dimension.map(|dimension| format!(", or with a unit: {}", dimension.understood()));
    units.unwrap_or_default()
}

fn known(Unknown { suggestion, names, .. }: &Unknown) -> String {
    let names = format!(
        "the quantities of this case: width, height, mass, friction, water_level, crest_height where it has them, or one of {}",
        names.join(", ")
    );
    match suggestion {
        Some(suggestion) => format!("did you mean `{suggestion}`? {names}"),
        None => names,
    }
}

/// A number with the unit of plain numbers.
fn with_unit(value: f64, variable: &Variable) -> String {
    match variable.dimension() {
        Some(dimension) => format!("{} {}", digits(value), dimension.si()),
        None => digits(value),
    }
}
