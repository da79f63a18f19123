//! Two quantities at once: for round values of the one, which values of the other meet a target, and what binds at their ends?
//!
//! Each column is searched by itself, as for one quantity, and what is printed of it is proven as there. Where neighbouring columns
//! differ in how many stretches they have, or in what binds at their ends, further columns are searched between them.

use super::quantity::{Ends, Quantity};
use super::set::{Search, Stretch};
use super::subject::Subject;
use super::{DesignError, DesignRequest, Spelling, Target, Varied, answerable};
use crate::assess::Assessment;
use crate::rounded::{Decimal, Towards};
use standfast_model::CaseFile;
use standfast_watch::{Portion, Stopped};

/// Number of parts that the range of a column is cut into.
const PARTS: u32 = 200;

/// Number of parts where each value takes a probability.
const CHANCE_PARTS: u32 = 12;

/// No more columns than these, however often neighbours differ.
const MOST: usize = 400;

/// To how many digits a place is found where neighbours differ.
const DIGITS: usize = 4;

/// Request for a design with two quantities.
#[derive(Debug, Clone)]
pub struct BoundaryRequest {
    /// The quantity whose least or greatest values are wanted, and the target.
    pub design: DesignRequest,
    /// The other quantity.
    pub and: String,
    /// Lower end of its range, as the case file would have it; half the present value if not given.
    pub from: Option<String>,
    /// Upper end of its range; twice the present value if not given.
    pub to: Option<String>,
}

/// The boundary of the values of two quantities that meet a target.
pub struct DesignBoundary {
    subject: Subject,
    /// What was asked.
    pub request: DesignRequest,
    /// The quantity whose ends are wanted.
    pub up: Quantity,
    /// The other one.
    pub across: Quantity,
    /// The answer at the present values.
    pub present: Assessment,
    /// Columns by rising values of the other quantity.
    pub columns: Vec<Column>,
    /// A few round values among them, which stand for all in a text.
    pub round: Vec<f64>,
}

/// The values that meet the target at a value of the other quantity.
pub struct Column {
    /// The value of the other quantity.
    pub at: f64,
    /// The values that meet the target, from the least on.
    pub stretches: Vec<Stretch>,
    /// Failure that binds, in a word, where the target is nearest to be met, if it is nowhere.
    pub none: Option<&'static str>,
}

impl Column {
    /// Failures that bind at each end, in a word.
    pub fn binding(&self) -> Vec<[Option<&'static str>; 2]> {
        let by = |stretch: &Stretch| [stretch.least.beyond.by(), stretch.greatest.beyond.by()];
        self.stretches.iter().map(by).collect()
    }
}

impl DesignBoundary {
    /// Finds the boundary for the case of a file, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// If the case makes no sense or lacks a quantity, both are the same, or no values meet the target; if the work is stopped.
    pub fn of(
        file: &CaseFile,
        request: BoundaryRequest,
        portion: Portion<'_>,
    ) -> Result<DesignBoundary, DesignError> {
        let BoundaryRequest { design, and, from, to } = request;
        let subject = Subject::of(file)?;
        let follows = subject.follows(design.target)?;
        answerable(design.target, &subject)?;
        let up = design.quantity(&subject)?;
        let spelling = design.spelling;
        let options = [spelling.and_from, spelling.and_to];
        let ends = Ends { options, written: [from.as_deref(), to.as_deref()], spread: 2.0 };
        let across = Quantity::of(&and, &subject.numbers, &subject.case, &ends)?;
        if up.variable.id() == across.variable.id() {
            return Err(DesignError::Twice { name: up.variable.id().to_string(), spelling });
        }
        let present = Varied { subject: &subject, follows, held: &[] }.present(design.target)?;
        let grid = Grid { subject: &subject, follows, up: &up, across: &across, target: design.target };
        let (round, values) = columns(&across);
        if design.target.asks_for_rise()
            && !values.iter().any(|value| grid.at(*value, |search| search.rises()))
        {
            return Err(DesignError::NothingRises { target: design.target });
        }
        let [of_values, of_others] = portion.parts([1.0, 1.0]);
        let count = values.len();
        let column = |(place, value)| grid.column(value, of_values.part(place, count));
        let mut columns = values.into_iter().enumerate().map(column).collect::<Result<Vec<_>, _>>()?;
        grid.refine(&mut columns, of_others)?;
        portion.reached(1.0);
        if columns.iter().all(|column| column.stretches.is_empty()) {
            return Err(grid.unmet(spelling));
        }
        Ok(DesignBoundary { subject, request: design, up, across, present, columns, round })
    }

    /// Notes on the numbers that go with each of both quantities.
    pub fn notes(&self) -> Vec<String> {
        self.subject.notes([&self.up.variable, &self.across.variable], &self.present.case)
    }
}

/// A few round values of a quantity, and all that are searched: more round ones, both ends of its range, the present one.
fn columns(across: &Quantity) -> (Vec<f64>, Vec<f64>) {
    let [from, to] = across.range;
    let (rough, fine) = Decimal::steps(from, to);
    let mut values: Vec<f64> = fine.into_iter().map(Decimal::value).chain([from, to]).collect();
    let mut round: Vec<f64> = rough.into_iter().map(Decimal::value).chain([from, to]).collect();
    if (from..=to).contains(&across.present) {
        values.push(across.present);
        round.push(across.present);
    }
    for values in [&mut values, &mut round] {
        values.sort_by(f64::total_cmp);
        values.dedup();
    }
    (round, values)
}

/// Grid on which both quantities are searched.
struct Grid<'a> {
    subject: &'a Subject,
    follows: bool,
    up: &'a Quantity,
    across: &'a Quantity,
    target: Target,
}

impl Grid<'_> {
    /// Asks the search at a value of the quantity across.
    fn at<T>(&self, value: f64, ask: impl FnOnce(&Search<'_>) -> T) -> T {
        let held = [(&self.across.variable, value)];
        let varied = Varied { subject: self.subject, follows: self.follows, held: &held };
        ask(&Search { varied: &varied, quantity: self.up, target: self.target, parts: self.parts() })
    }

    fn parts(&self) -> u32 {
        if self.target.asks_for_chance(&self.subject.case) { CHANCE_PARTS } else { PARTS }
    }

    fn column(&self, at: f64, portion: Portion<'_>) -> Result<Column, Stopped> {
        self.at(at, |search| {
            let stretches = search.stretches(portion)?;
            let none = if stretches.is_empty() { search.nearest() } else { None };
            Ok(Column { at, stretches, none })
        })
    }

    /// Searches between neighbours of which other stretches are met, or at whose ends something else binds, until they are
    /// neighbours to a few digits.
    fn refine(&self, columns: &mut Vec<Column>, portion: Portion<'_>) -> Result<(), Stopped> {
        let mut place = 1;
        while place < columns.len() && columns.len() < MOST {
            portion.check()?;
            let [left, right] = [&columns[place - 1], &columns[place]];
            let middle = Decimal::of((left.at + right.at) / 2.0, DIGITS, Towards::Less).value();
            if left.binding() == right.binding() || middle <= left.at || right.at <= middle {
                place += 1;
                portion.reached(place as f64 / columns.len() as f64);
            } else {
                // The pair with the new column is looked at next. Where it lies is no share of what is left.
                let within = portion.part(place - 1, columns.len()).parts([0.0, 1.0])[0];
                columns.insert(place, self.column(middle, within)?);
            }
        }
        Ok(())
    }

    /// Reason why no values meet the target.
    fn unmet(&self, spelling: &'static Spelling) -> DesignError {
        let [from, to] = self.across.range;
        let value = self.across.present.clamp(from, to);
        let why = self.at(value, |search| search.unmet(spelling)).to_string();
        let others = self.across.in_range_words();
        let Spelling { from, to, and_from, and_to, .. } = spelling;
        let help = format!("{from}, {to}, {and_from} and {and_to} widen the ranges");
        DesignError::UnmetThroughout { others, at: self.across.shown(value), why, help }
    }
}
