//! Design: the least value of a quantity that meets a target, and what every number of a case does to its
//! safety.
//!
//! Nothing is linearised or scaled: for each value tried, the case file is read again with that value in place of its own,
//! and everything that follows from it, waves and water included, is computed anew.

mod json;
mod outcome;
mod search;
mod sensitivity;
mod target;
mod text;
mod vary;

pub use sensitivity::{Sensitivity, sensitivities};
pub use target::{Target, TargetError};

use miette::Diagnostic;
use standfast::InputError;
use thiserror::Error;

use crate::case::{Case, CaseError, Problem, Replacement};
use crate::layout::digits;
use crate::units::{Quantity, UnitError};
use outcome::Outcome;
use search::{Found, search};
use vary::Variable;

/// Why there is no design.
#[derive(Debug, Error, Diagnostic)]
pub enum DesignError {
    /// The case file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// The case cannot be computed.
    #[error(transparent)]
    Mechanics(#[from] InputError),
    /// A name that is no number of the case.
    #[error("the case has no `{name}` to vary")]
    #[diagnostic(help("{}", known(suggestion.as_deref(), names)))]
    UnknownVariable {
        /// The name.
        name: String,
        /// The one it resembles.
        suggestion: Option<String>,
        /// The numbers of the case.
        names: Vec<String>,
    },
    /// An end of the bracket that is no value of the quantity.
    #[error("{option} is \"{written}\", and {error}")]
    #[diagnostic(help("expected a number in SI units{}", units(*quantity)))]
    Bracket {
        /// The option.
        option: &'static str,
        /// What was given.
        written: String,
        /// What it should measure; `None` for a plain number.
        quantity: Option<Quantity>,
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

/// A case file that is read again and again.
struct Chain<'a> {
    name: &'a str,
    text: &'a str,
}

impl Chain<'_> {
    fn case(&self, replaced: &[Replacement]) -> Result<Case, CaseError> {
        Case::parse_with(self.name, self.text, replaced)
    }

    fn outcome(&self, replaced: &[Replacement]) -> Result<Outcome, DesignError> {
        Ok(Outcome::of(&self.case(replaced)?)?)
    }
}

/// The least value that meets a target, with what it rests on.
pub struct Design {
    case: Case,
    request: Request,
    variable: Variable,
    bracket: [f64; 2],
    present: Outcome,
    found: Found,
    sensitivities: Vec<Sensitivity>,
}

impl Design {
    /// Designs the case whose file is `text`; `name` is what errors call it.
    ///
    /// # Errors
    /// If the case makes no sense or lacks the quantity, or the target cannot be met.
    pub fn of(name: &str, text: &str, request: Request) -> Result<Design, DesignError> {
        let chain = Chain { name, text };
        let case = chain.case(&[])?;
        let variable = Variable::find(&request.vary, &case)?;
        let bracket = bracket(&request, &variable)?;
        possible(&chain, &case, &request, &variable, bracket)?;
        let present = chain.outcome(&[])?;
        let found = search(&chain, &case, &variable, request.target, bracket)?;
        let sensitivities = sensitivity::all(&chain, &case);
        Ok(Design { case, request, variable, bracket, present, found, sensitivities })
    }

    /// What is unusual about the case with the value found, and is not at present.
    fn new_warnings(&self) -> impl Iterator<Item = &str> {
        let new =
            self.found.outcome.warnings.iter().filter(|warning| !self.present.warnings.contains(warning));
        new.map(String::as_str)
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

fn bracket(request: &Request, variable: &Variable) -> Result<[f64; 2], DesignError> {
    let end = |option, written: &Option<String>, default: f64| match written {
        None => Ok(default),
        Some(written) => variable.parse(written).map_err(|error| {
            let quantity = variable.quantity;
            DesignError::Bracket { option, written: written.clone(), quantity, error }
        }),
    };
    let [low, high] = [variable.present / 5.0, variable.present * 5.0];
    let from = end("--from", &request.from, low.min(high))?;
    let to = end("--to", &request.to, low.max(high))?;
    if from < to { Ok([from, to]) } else { Err(DesignError::EmptyBracket { from, to }) }
}

/// Refuses ends, where given, with a sign that the quantity cannot have.
fn possible(
    chain: &Chain<'_>,
    case: &Case,
    request: &Request,
    variable: &Variable,
    [from, to]: [f64; 2],
) -> Result<(), DesignError> {
    for (option, written, value) in [("--from", &request.from, from), ("--to", &request.to, to)] {
        let Some(written) = written.clone().filter(|_| value < 0.0) else { continue };
        if let Err(error) = chain.case(&variable.replacements(case, value))
            && let Problem::OutOfRange { key, expected, .. } = *error.problem()
            && variable.is_under(key)
        {
            return Err(DesignError::Impossible { option, written, name: variable.name.clone(), expected });
        }
    }
    Ok(())
}

fn units(quantity: Option<Quantity>) -> String {
    let units = quantity.map(|quantity| format!(", or with a unit: {}", quantity.understood()));
    units.unwrap_or_default()
}

fn known(suggestion: Option<&str>, names: &[String]) -> String {
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
    match variable.quantity {
        Some(quantity) => format!("{} {}", digits(value), quantity.si()),
        None => digits(value),
    }
}
