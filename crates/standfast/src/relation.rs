//! An inequality that a mode needs, with its numbers: what an explanation is made of.

use std::cmp::Ordering;

use crate::number::significant;

/// The sign of an inequality.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sign {
    /// <
    Less,
    /// ≤
    LessOrEqual,
    /// ≥
    GreaterOrEqual,
    /// >
    Greater,
}

impl Sign {
    /// True if the inequality holds, for a left side that stands to the right side as `ordering` says.
    pub(crate) fn holds(self, ordering: Ordering) -> bool {
        match self {
            Sign::Less => ordering.is_lt(),
            Sign::LessOrEqual => ordering.is_le(),
            Sign::GreaterOrEqual => ordering.is_ge(),
            Sign::Greater => ordering.is_gt(),
        }
    }
}

impl std::fmt::Display for Sign {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Sign::Less => "<",
            Sign::LessOrEqual => "≤",
            Sign::GreaterOrEqual => "≥",
            Sign::Greater => ">",
        })
    }
}

/// An inequality between a quantity and its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relation {
    /// The report's equation number, or the law that the inequality states.
    pub equation: &'static str,
    /// The symbol left of the sign, e.g. `μ`.
    pub quantity: &'static str,
    /// Its value.
    pub left: f64,
    /// The sign between them.
    pub sign: Sign,
    /// The bound in symbols, e.g. `1/γ − k k'`.
    pub bound: &'static str,
    /// Its value.
    pub right: f64,
    /// True if it holds, decided exactly.
    pub holds: bool,
}

impl Relation {
    /// The inequality in symbols, e.g. `μ ≥ k`.
    pub fn statement(&self) -> String {
        format!("{} {} {}", self.quantity, self.sign, self.bound)
    }

    /// Margin between `left` and `right`: negative where the inequality does not hold.
    pub fn margin(&self) -> f64 {
        match self.sign {
            Sign::Less | Sign::LessOrEqual => self.right - self.left,
            Sign::GreaterOrEqual | Sign::Greater => self.left - self.right,
        }
    }
}

impl std::fmt::Display for Relation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Relation { equation, left, sign, right, holds, .. } = *self;
        let statement = self.statement();
        let verb = if holds { "holds" } else { "fails" };
        let [left, right, margin] = [left, right, self.margin().abs()].map(|x| significant(x, 6));
        write!(f, "({equation}) {statement}: {left} {sign} {right}, {verb} by {margin}")
    }
}
