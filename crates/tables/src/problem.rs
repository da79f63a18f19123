//! Problems that a table asks: the report's problem, or the general contact problem.

use standfast::contact::{self, INPUTS};
use standfast::ground::strength::CrushPoint;
use standfast::{InputError, Modes, Motion, Point, Quantity, Verdict};

use crate::results::{FieldKind, SYMBOLS};
use ResultColumn::{
    Also, FX, FY, Mode as ModeColumn, Modes as ModesColumn, ThetaDdot, Unique, XDdot, Xi, YDdot,
};

/// Problem that the rows are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum TableProblem {
    /// The report's: gamma, k_prime, k and mu; with a column omega, on bases that crush, each of its share ω
    #[default]
    Force,
    /// Any wrench on any block: b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s and mu_k
    Wrench,
}

/// A column that a table has to have.
pub(crate) struct Column {
    pub(crate) name: &'static str,
    /// Quantity of the library.
    quantity: Quantity,
}

const fn column(name: &'static str, quantity: Quantity) -> Column {
    Column { name, quantity }
}

const FORCE: [Column; 4] = [
    column("gamma", Quantity::Slenderness),
    column("k_prime", Quantity::KPrime),
    column("k", Quantity::K),
    column("mu", Quantity::Friction),
];

/// Optional column of a table: the share of a base that crushes, which is rigid without.
const FORCE_OPTIONAL: [Column; 1] = [column("omega", Quantity::Omega)];

const WRENCH: [Column; INPUTS.len()] = {
    let mut columns = [const { column("", Quantity::B1) }; INPUTS.len()];
    let mut place = 0;
    while place < columns.len() {
        let (name, quantity) = INPUTS[place];
        columns[place] = column(name, quantity);
        place += 1;
    }
    columns
};

/// The most columns a problem has.
pub(crate) const MOST: usize = WRENCH.len();

/// A column that can be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "clap", value(rename_all = "snake_case"))]
pub enum ResultColumn {
    /// All consistent modes (--problem wrench)
    Modes,
    /// The mode that begins
    Mode,
    /// Whether no other mode is consistent (--problem force)
    Unique,
    /// The other consistent modes (--problem force)
    Also,
    /// Acceleration of the centre of mass, to the right
    XDdot,
    /// The same, upwards
    YDdot,
    /// Angular acceleration, counter-clockwise
    ThetaDdot,
    /// Reaction on the body, to the right
    #[cfg_attr(feature = "clap", value(name = "f_x"))]
    FX,
    /// The same, upwards
    #[cfg_attr(feature = "clap", value(name = "f_y"))]
    FY,
    /// Where f_y acts, right of the centre of mass
    Xi,
}

const FORCE_RESULTS: [ResultColumn; 9] = [ModeColumn, Unique, Also, XDdot, YDdot, ThetaDdot, FX, FY, Xi];
const WRENCH_RESULTS: [ResultColumn; 8] = [ModesColumn, ModeColumn, XDdot, YDdot, ThetaDdot, FX, FY, Xi];

impl ResultColumn {
    /// The name of the column.
    pub fn name(self) -> &'static str {
        match self {
            ModesColumn => "modes",
            ModeColumn => "mode",
            Unique => "unique",
            Also => "also",
            XDdot => "x_ddot",
            YDdot => "y_ddot",
            ThetaDdot => "theta_ddot",
            FX => "f_x",
            FY => "f_y",
            Xi => "xi",
        }
    }

    /// Kind of the column's values.
    pub(crate) fn kind(self) -> FieldKind {
        match self {
            // One byte a row in memory, and three or four bits in Parquet.
            ModeColumn => FieldKind::Word(&SYMBOLS),
            ModesColumn | Also => FieldKind::Modes,
            Unique => FieldKind::Flag,
            XDdot | YDdot | ThetaDdot | FX | FY | Xi => FieldKind::Number,
        }
    }

    /// The number of a motion that the column holds, if it holds numbers.
    pub(crate) fn number(self) -> Option<fn(&Motion) -> f64> {
        match self {
            ModesColumn | ModeColumn | Unique | Also => None,
            XDdot => Some(|motion| motion.x_ddot),
            YDdot => Some(|motion| motion.y_ddot),
            ThetaDdot => Some(|motion| motion.theta_ddot),
            FX => Some(|motion| motion.f_x),
            FY => Some(|motion| motion.f_y),
            Xi => Some(|motion| motion.xi),
        }
    }
}

/// The answer to a row.
pub(crate) enum Answer {
    Force(Point),
    Crushing(CrushPoint),
    Wrench(contact::Solution),
}

impl TableProblem {
    /// The columns needed.
    pub(crate) fn columns(self) -> &'static [Column] {
        match self {
            TableProblem::Force => &FORCE,
            TableProblem::Wrench => &WRENCH,
        }
    }

    /// The columns taken where a table has them; they stand behind those needed.
    pub(crate) fn optional(self) -> &'static [Column] {
        match self {
            TableProblem::Force => &FORCE_OPTIONAL,
            TableProblem::Wrench => &[],
        }
    }

    /// The columns appended, unless others are asked for.
    pub fn results(self) -> &'static [ResultColumn] {
        match self {
            TableProblem::Force => &FORCE_RESULTS,
            TableProblem::Wrench => &WRENCH_RESULTS,
        }
    }

    /// The names of the columns needed, in words.
    pub(crate) fn needed(self) -> String {
        in_words(self.columns().iter().map(|column| column.name))
    }

    /// The answer to the values of the columns; what the problem does not have is ignored, and what a table does not have is zero.
    pub(crate) fn solve(self, values: [f64; MOST]) -> Result<Answer, InputError> {
        match self {
            TableProblem::Force => {
                let [gamma, k_prime, k, mu, omega, ..] = values;
                let point = Point::new(gamma, k_prime, k, mu)?;
                if omega == 0.0 {
                    return Ok(Answer::Force(point));
                }
                CrushPoint::of(point, omega).map(Answer::Crushing)
            }
            TableProblem::Wrench => contact::solve_row(values).map(Answer::Wrench),
        }
    }

    /// The place among the columns of the one at fault.
    pub(crate) fn blame(self, error: &InputError) -> usize {
        let culprit =
            self.columns().iter().chain(self.optional()).position(|column| column.quantity == error.quantity);
        culprit.unwrap_or_default()
    }
}

impl Answer {
    /// Verdict that is reached, if any is.
    pub(crate) fn verdict(&self) -> Option<Verdict> {
        match self {
            Answer::Force(point) => Some(Verdict::Begins(point.mode())),
            Answer::Crushing(point) => Some(point.verdict()),
            Answer::Wrench(answer) => answer.mode().map(Verdict::Begins),
        }
    }

    /// The consistent modes: those beside the one reported for a force, all of them for a wrench.
    pub(crate) fn modes(&self) -> Modes {
        match self {
            Answer::Force(point) => point.others(),
            Answer::Crushing(point) => point.others(),
            Answer::Wrench(answer) => answer.modes,
        }
    }

    pub(crate) fn motion(&self) -> Option<Motion> {
        match self {
            Answer::Force(point) => Some(point.motion()),
            Answer::Crushing(point) => point.motion().map(|begun| begun.motion),
            Answer::Wrench(answer) => answer.mode().and_then(|mode| answer.motion(mode)),
        }
    }
}

/// `a, b and c`.
pub(crate) fn in_words(names: impl IntoIterator<Item = &'static str>) -> String {
    let names: Vec<_> = names.into_iter().collect();
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.concat(),
    }
}
