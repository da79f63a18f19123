//! Limit states over columns: those that are asked for, each by its one expression, with the same numbers as [`Point::limit_states`].
//!
//! In blocks that stay in the cache: values and signs in tracked floating point, without branches, one loop for each limit state; then,
//! where a sign of the block is not certain, those points in exact arithmetic.

use super::instructions::{InstructionSet, Kernel};
use super::{BatchError, Columns};
use crate::approx::Approx;
use crate::error::{LARGEST, SMALLEST};
use crate::exact::Real;
use crate::initiation::{LimitState, Point, Terms};

/// Points of a block: a few of them make the loops long, many leave the first-level cache.
const LANES: usize = 64;

/// A column for one of the limit states.
#[derive(Debug)]
pub struct LimitColumn<'a> {
    /// The limit state.
    pub state: LimitState,
    /// Its values at the points.
    pub values: &'a mut [f64],
}

impl<'a> LimitColumn<'a> {
    /// The first `index` points, and the rest.
    ///
    /// # Panics
    /// If there are fewer points.
    pub fn split_at(self, index: usize) -> (LimitColumn<'a>, LimitColumn<'a>) {
        let (values, rest) = self.values.split_at_mut(index);
        (LimitColumn { state: self.state, values }, LimitColumn { state: self.state, values: rest })
    }
}

/// Writes limit states of every point, as [`Point::limit_states`] has them, each into its column.
///
/// ```
/// use standfast::batch::{Columns, LimitColumn, limit_states};
/// use standfast::initiation::LimitState;
///
/// let columns = Columns { gamma: &[1.0; 2], k_prime: &[1.0; 2], k: &[0.25, 1.0], mu: &[0.5; 2] };
/// let mut values = [0.0; 2];
/// limit_states(columns, &mut [LimitColumn { state: LimitState::RockO, values: &mut values }])?;
/// assert_eq!(values, [0.5, -1.0]);
/// # Ok::<(), standfast::batch::BatchError>(())
/// ```
///
/// # Errors
/// If the columns differ in length, or at the first point with a value that is not valid; the columns of `out` are then
/// written in part.
pub fn limit_states(columns: Columns<'_>, out: &mut [LimitColumn<'_>]) -> Result<(), BatchError> {
    limit_states_with(InstructionSet::best(), columns, out)
}

/// As [`limit_states`], on one instruction set; public for tests and benchmarks, which compare them.
#[doc(hidden)]
pub fn limit_states_with(
    set: InstructionSet,
    columns: Columns<'_>,
    out: &mut [LimitColumn<'_>],
) -> Result<(), BatchError> {
    let length = columns.gamma.len();
    columns.check_lengths(length)?;
    if let Some(wrong) = out.iter().find(|column| column.values.len() != length) {
        let (column, found) = (wrong.state.name(), wrong.values.len());
        return Err(BatchError::Length { column, found, expected: length });
    }
    match set.run(Limits { columns, out }) {
        None => Ok(()),
        // Looked at again; what was not valid in a block of which nothing was written is so still, or the next call sees it.
        Some(start) => {
            let wrong = (start..length).find_map(|index| Some((index, columns.point(index).err()?)));
            wrong.map_or(Ok(()), |(index, source)| Err(BatchError::Value { index, source }))
        }
    }
}

struct Limits<'a, 'b, 'c> {
    columns: Columns<'a>,
    out: &'b mut [LimitColumn<'c>],
}

impl Kernel for Limits<'_, '_, '_> {
    /// Start of the first block with a point that is not valid.
    type Output = Option<usize>;

    #[inline(always)]
    fn run(self) -> Option<usize> {
        let mut block = Block::AT_REST;
        let (mut moment, mut friction) = (false, false);
        for column in &*self.out {
            let needs = column.state.needs();
            (moment, friction) = (moment | needs.0, friction | needs.1);
        }
        let length = self.columns.gamma.len();
        let mut start = 0;
        while start < length {
            let count = if length - start < LANES { length - start } else { LANES };
            if !block.read(self.columns.slice(start, count)) {
                return Some(start);
            }
            if moment {
                block.form_moment();
            }
            if friction {
                block.form_friction();
            }
            for column in &mut *self.out {
                block.write(column.state, &mut column.values[start..start + count]);
            }
            start += count;
        }
        None
    }
}

/// Valid points, and what their polynomials are made of.
struct Block {
    gamma: Lane,
    k_prime: Lane,
    k: Lane,
    mu: Lane,
    moment: Tracked,
    surplus: Tracked,
    sum: Tracked,
    inertia: Tracked,
}

/// A number of each point.
type Lane = [f64; LANES];

/// Numbers with bounds on their rounding errors.
struct Tracked {
    value: Lane,
    error: Lane,
}

impl Tracked {
    const ZERO: Tracked = Tracked { value: [0.0; LANES], error: [0.0; LANES] };

    #[inline(always)]
    fn set(&mut self, i: usize, number: Approx) {
        (self.value[i], self.error[i]) = (number.value(), number.error());
    }

    #[inline(always)]
    fn get(&self, i: usize) -> Approx {
        Approx::around(self.value[i], self.error[i])
    }
}

impl Block {
    /// Points that rest, so that no lane ever holds anything else than a valid point.
    const AT_REST: Block = Block {
        gamma: [1.0; LANES],
        k_prime: [0.0; LANES],
        k: [0.0; LANES],
        mu: [0.0; LANES],
        moment: Tracked::ZERO,
        surplus: Tracked::ZERO,
        sum: Tracked::ZERO,
        inertia: Tracked::ZERO,
    };

    /// Takes points, of which −0 becomes 0; false if one is not valid.
    #[inline(always)]
    fn read(&mut self, columns: Columns<'_>) -> bool {
        let count = columns.gamma.len();
        let Columns { gamma, k_prime, k, mu } = columns.slice(0, count);
        let mut wrong = 0;
        for i in 0..count {
            let point = [gamma[i] + 0.0, k_prime[i] + 0.0, k[i] + 0.0, mu[i] + 0.0];
            [self.gamma[i], self.k_prime[i], self.k[i], self.mu[i]] = point;
            wrong |= u64::from(!is_valid(point));
        }
        wrong == 0
    }

    /// Forms what all polynomials share.
    #[inline(always)]
    fn form_moment(&mut self) {
        for i in 0..LANES {
            self.moment.set(i, Terms::of(self.point(i).numbers()).moment);
        }
    }

    /// Forms what those of slip and of a turn in sliding share.
    #[inline(always)]
    fn form_friction(&mut self) {
        for i in 0..LANES {
            let Terms { surplus, sum, inertia, .. } = Terms::of(self.point(i).numbers());
            self.surplus.set(i, surplus);
            self.sum.set(i, sum);
            self.inertia.set(i, inertia);
        }
    }

    #[inline(always)]
    fn point(&self, i: usize) -> Point {
        Point::of_valid(self.gamma[i], self.k_prime[i], self.k[i], self.mu[i])
    }

    #[inline(always)]
    fn terms(&self, i: usize) -> Terms<Approx> {
        Terms {
            gamma: Approx::of(self.gamma[i]),
            mu: Approx::of(self.mu[i]),
            moment: self.moment.get(i),
            surplus: self.surplus.get(i),
            sum: self.sum.get(i),
            inertia: self.inertia.get(i),
        }
    }

    /// Writes a limit state of the points.
    #[inline(always)]
    fn write(&self, state: LimitState, values: &mut [f64]) {
        macro_rules! each {
            ($($state:ident)*) => {
                match state {
                    $(LimitState::$state => self.write_one::<{ LimitState::$state as usize }>(values),)*
                }
            };
        }
        each!(Slide RockO RockOPrime TurnO TurnOPrime SlipOLeft SlipORight SlipOPrimeLeft SlipOPrimeRight
            LoadFactor SfSliding SfOverturning);
    }

    /// Writes the limit state at this place among all, in a loop of its own.
    #[inline(always)]
    #[expect(clippy::needless_range_loop, reason = "an iterator's functions may be left for the baseline")]
    fn write_one<const STATE: usize>(&self, values: &mut [f64]) {
        let state = const { LimitState::ALL[STATE] };
        let mut whole = [0.0; LANES];
        let mut unsure = 0;
        for i in 0..LANES {
            let (value, is_told) = state.screened(&self.point(i), &self.terms(i));
            whole[i] = value;
            unsure |= u64::from(!is_told);
        }
        values.copy_from_slice(&whole[..values.len()]);
        if unsure != 0 {
            self.settle(state, values);
        }
    }

    /// Writes the limit state of the points again, by exact arithmetic where floating point cannot tell the sign.
    #[cold]
    #[inline(never)]
    fn settle(&self, state: LimitState, values: &mut [f64]) {
        for (i, value) in values.iter_mut().enumerate() {
            *value = state.at(&self.point(i));
        }
    }
}

/// True if a point can have these numbers, as [`Point::new`] has it.
#[inline(always)]
#[expect(clippy::manual_range_contains, reason = "without branches")]
fn is_valid([gamma, k_prime, k, mu]: [f64; 4]) -> bool {
    (gamma >= SMALLEST)
        & (gamma <= LARGEST)
        & (k_prime.abs() <= LARGEST)
        & (k >= 0.0)
        & (k <= LARGEST)
        & (mu >= 0.0)
        & (mu <= LARGEST)
}
