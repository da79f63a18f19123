//! Reasons why there is no design, in words.

use standfast_watch::Stopped;
use thiserror::Error;

use super::{Extreme, Spelling, Target};
use crate::couple::Unknown;
use crate::error::CaseError;
use crate::explained::Explained;

/// Reason why there is no design.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DesignError {
    /// The case file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// Whoever watches the work has stopped it.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The target asks for the motion of a case that has none.
    #[error("the target {name} asks for the motion in time, of which the case says nothing")]
    NotInTime {
        /// The target.
        name: &'static str,
    },
    /// A name that is not a number of the case.
    #[error("the case has no `{}` to vary", .0.name)]
    UnknownVariable(Unknown),
    /// An end of a range that is not a value of the quantity.
    #[error("{option} is \"{written}\": {fault}")]
    Bracket {
        /// The option.
        option: &'static str,
        /// Text that was given.
        written: String,
        /// Fault of the text.
        fault: String,
        /// Values that are expected.
        expected: String,
    },
    /// A range without inside.
    #[error("the range {range} is empty; give its ends with {} and {}", options[0], options[1])]
    EmptyBracket {
        /// The range, "from 5 m to 1 m".
        range: String,
        /// The options that give its ends.
        options: [&'static str; 2],
    },
    /// An end of a range that the quantity cannot have.
    #[error("{option} is \"{written}\"; expected {expected}, as {name} has to be")]
    Impossible {
        /// The option.
        option: &'static str,
        /// Text that was given.
        written: String,
        /// Quantity that was varied.
        name: String,
        /// Values that it may have.
        expected: &'static str,
    },
    /// The criteria are the target, and there are none.
    #[error("the target {target} asks for the criteria of the case, which has none")]
    NoCriteria {
        /// The target.
        target: Target,
    },
    /// The target is a probability, and nothing is random.
    #[error(
        "the target {target} asks for a probability, and the case has no [random] table, which says what is random"
    )]
    NothingRandom {
        /// The target.
        target: Target,
    },
    /// The target asks for a factor on loads that there are not.
    #[error(
        "the target {target} asks how far the variable loads may rise, and the case has none: nothing rises, and it would be met \
         by a body that just rests"
    )]
    NothingRises {
        /// The target.
        target: Target,
    },
    /// No value of the range makes a case.
    #[error("no {name} {range} makes a case; at {at}: {why}")]
    NoCase {
        /// Quantity that was varied.
        name: String,
        /// The range, "from 1 m to 5 m".
        range: String,
        /// A value of it.
        at: String,
        /// Reason why that makes no case.
        why: String,
        /// Spelling of the request.
        spelling: &'static Spelling,
    },
    /// The target does not depend on the quantity.
    #[error("{name} does not change how far the case is from {target}: whatever its value, {binding}")]
    NoInfluence {
        /// Quantity that was varied.
        name: String,
        /// The target.
        target: Target,
        /// Failure that stays, whatever the value.
        binding: String,
    },
    /// No value meets the target.
    #[error("no {name} {range} meets the target {target}; {best}")]
    Unmet {
        /// Quantity that was varied.
        name: String,
        /// The range, "from 1 m to 5 m".
        range: Box<str>,
        /// The target.
        target: Target,
        /// The best that was reached.
        best: Box<str>,
        /// Spelling of the request.
        spelling: &'static Spelling,
    },
    /// The target is met as far as the range reaches on the side where an end was wanted.
    #[error("there is no {extreme} {name} that meets the target {target}: it is met {met}")]
    NoEnd {
        /// Quantity that was varied.
        name: String,
        /// The end that was wanted.
        extreme: Extreme,
        /// The target.
        target: Target,
        /// Values at which it is met.
        met: Box<str>,
        /// Advice on the request to make instead.
        help: Box<str>,
    },
    /// Too many quantities for a least cost, or none.
    #[error("{found} quantities to vary; expected from one to {most}, each by {}", spelling.vary)]
    Quantities {
        /// Number of quantities given.
        found: usize,
        /// The most.
        most: usize,
        /// Spelling of the request.
        spelling: &'static Spelling,
    },
    /// One quantity among several twice.
    #[error("{name} is varied twice")]
    SameQuantity {
        /// The quantity.
        name: String,
    },
    /// More ends of ranges than quantities.
    #[error("{found} ends of ranges for {quantities} to vary; {} and {} go with the quantities in their order", spelling.from, spelling.to)]
    MoreEnds {
        /// Number of ends given.
        found: usize,
        /// Number of quantities.
        quantities: usize,
        /// Spelling of the request.
        spelling: &'static Spelling,
    },
    /// Quantities that do not change the cost.
    #[error("the {cost} does not change with {}", names.join(", "))]
    NoCost {
        /// The quantities.
        names: Vec<String>,
        /// What is to be least.
        cost: &'static str,
    },
    /// A probability is asked for at every point of a search that tries thousands.
    #[error(
        "the target {target} asks for a probability, which is not found at the thousands of points that a least cost takes"
    )]
    ChanceAtLeastCost {
        /// The target.
        target: Target,
    },
    /// No value meets the target, whatever other quantities are.
    #[error("whatever {others}, the target is not met; at {at}: {why}")]
    UnmetThroughout {
        /// The other quantities in their ranges, "height is from 1 m to 5 m".
        others: String,
        /// The values at which one was looked for.
        at: String,
        /// Reason why there is none there.
        why: String,
        /// Advice on the ranges.
        help: String,
    },
    /// Both quantities are the same.
    #[error("{} and {} name the same number, {name}", spelling.vary, spelling.and)]
    Twice {
        /// The number.
        name: String,
        /// Spelling of the request.
        spelling: &'static Spelling,
    },
}

impl DesignError {
    /// True if the request is understood, and no value meets its target, or every one does.
    pub fn is_without_solution(&self) -> bool {
        use DesignError::{NoEnd, NoInfluence, Unmet, UnmetThroughout};
        matches!(self, Unmet { .. } | NoEnd { .. } | UnmetThroughout { .. } | NoInfluence { .. })
    }
}

impl Explained for DesignError {
    fn passed_on(&self) -> Option<&dyn Explained> {
        match self {
            DesignError::Case(error) => Some(error),
            _ => None,
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            DesignError::NotInTime { .. } => {
                "give each variable load a history, or the base a [motion.base]".into()
            }
            DesignError::UnknownVariable(it) => known(it),
            DesignError::Bracket { expected, .. } => expected.clone(),
            DesignError::NoCriteria { .. } => {
                "add for example\n[criteria]\nSF_sliding = 1.2\nSF_overturning_net = 1.2".into()
            }
            DesignError::NothingRandom { .. } => {
                "for example\n[random]\nfriction = { normal = { mean = 0.6, sd = 0.1 } }".into()
            }
            DesignError::NothingRises { .. } => {
                "SF_sliding, SF_overturning_net or factor say how safe a body is under permanent loads".into()
            }
            DesignError::NoCase { spelling, .. } => {
                format!("{} and {} give another range", spelling.from, spelling.to)
            }
            DesignError::NoInfluence { target, .. } => of_no_influence(target).into(),
            DesignError::Unmet { spelling, .. } => format!(
                "{} and {} widen the range; another quantity may help more: see the sensitivities of a \
                 target that can be met",
                spelling.from, spelling.to
            ),
            DesignError::NoEnd { help, .. } => help.to_string(),
            DesignError::UnmetThroughout { help, .. } => help.clone(),
            DesignError::Twice { spelling, .. } => {
                format!("{} takes another quantity of the case, as in {}", spelling.and, spelling.two)
            }
            DesignError::NoCost { cost, .. } => {
                format!("vary dimensions of the body or of its parts, or what else the {cost} hangs on")
            }
            DesignError::ChanceAtLeastCost { .. } => "give criteria on factors as the target".into(),
            _ => return None,
        };
        Some(help)
    }
}

fn known(Unknown { suggestion, names, unwritten, .. }: &Unknown) -> String {
    if let Some((table, line)) = unwritten {
        return format!(
            "the case does not give it; write it first under {}, for example {line}",
            table.header()
        );
    }
    let names = format!(
        "the quantities of this case: width, height, mass, friction, water_level, crest_height where it has them, or one of {}",
        names.join(", ")
    );
    match suggestion {
        Some(suggestion) => format!("did you mean `{suggestion}`? {names}"),
        None => names,
    }
}

/// Help where a quantity does not change how far a target is.
fn of_no_influence(target: &Target) -> &'static str {
    if matches!(target, Target::Criterion(asked) if asked.is_chance()) {
        "of a random quantity its law counts, which goes with the case's value where it has no mean of its own: leave `mean` out and give `cov`, or vary another quantity"
    } else {
        "another quantity helps: see the sensitivities of a target that can be met"
    }
}
