//! The decision over columns of numbers, at the speed of memory, with the same exact answer as [`Point::mode`].
//!
//! The kernel evaluates [two polynomials and one error bound](crate::sign) a point, without branches, in 32-bit floating point; blocks
//! with points it is not sure of once more in 64-bit. The compiler vectorises it for the instruction set found at run time (AVX-512, AVX2,
//! or what every x86-64 and every other processor has). Points that are not sure then are decided one by one, in exact arithmetic.
//!
//! ```
//! use standfast::batch::{Columns, classify};
//! use standfast::Mode;
//!
//! let columns = Columns {
//!     gamma: &[1.0, 1.0],
//!     k_prime: &[0.4, 1.0],
//!     k: &[0.5, 2.0],
//!     mu: &[0.6, 5.0],
//! };
//! let mut codes = [0; 2];
//! classify(columns, &mut codes)?;
//! assert_eq!(codes.map(Mode::from_code), [Some(Mode::Rest), Some(Mode::RockO)]);
//! # Ok::<(), standfast::batch::BatchError>(())
//! ```

mod instructions;
mod kernel;
mod limits;

use crate::error::InputError;
use crate::ground::strength::CrushPoint;
use crate::initiation::Point;
use crate::mode::Mode;
use crate::motion::Motion;
use kernel::UNSURE;

#[doc(hidden)]
pub use instructions::InstructionSet;
#[doc(hidden)]
pub use kernel::{exactly, screen_with};
#[doc(hidden)]
pub use limits::limit_states_with;
pub use limits::{LimitColumn, limit_states};

/// Points whose motions are computed, or whose codes are looked at again, after their modes are known: few enough to be in the cache still.
const BLOCK: usize = 4096;

/// Four columns of equal length: γ, k', k and μ.
#[derive(Debug, Clone, Copy)]
pub struct Columns<'a> {
    /// γ = H/B.
    pub gamma: &'a [f64],
    /// k', the height of the force above the centre of mass in H.
    pub k_prime: &'a [f64],
    /// k = F/(m g).
    pub k: &'a [f64],
    /// μ.
    pub mu: &'a [f64],
}

/// Reason why a batch could not be classified.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BatchError {
    /// A column is longer or shorter than the output.
    #[error("column {column} has {found} values; expected {expected}, as many as the output")]
    Length {
        /// The column.
        column: &'static str,
        /// Its length.
        found: usize,
        /// The length of the output.
        expected: usize,
    },
    /// A value that no point can have.
    #[error("point {index}: {source}")]
    Value {
        /// The first point with such a value, counted from zero.
        index: usize,
        /// The value.
        source: InputError,
    },
}

impl BatchError {
    /// The error of points that come after `before` others.
    fn after(self, before: usize) -> BatchError {
        match self {
            BatchError::Value { index, source } => BatchError::Value { index: before + index, source },
            BatchError::Length { .. } => self,
        }
    }
}

impl<'a> Columns<'a> {
    fn check_lengths(&self, expected: usize) -> Result<(), BatchError> {
        let lengths = [
            ("gamma", self.gamma.len()),
            ("k_prime", self.k_prime.len()),
            ("k", self.k.len()),
            ("mu", self.mu.len()),
        ];
        match lengths.into_iter().find(|&(_, found)| found != expected) {
            Some((column, found)) => Err(BatchError::Length { column, found, expected }),
            None => Ok(()),
        }
    }

    /// The point at `index`.
    ///
    /// # Errors
    /// If its values are not valid; see [`Point::new`].
    ///
    /// # Panics
    /// If a column has no such index.
    pub fn point(&self, index: usize) -> Result<Point, InputError> {
        Point::new(self.gamma[index], self.k_prime[index], self.k[index], self.mu[index])
    }

    /// The point at `index` on a base of its ω.
    fn on_base(&self, omega: &[f64], index: usize) -> Result<CrushPoint, InputError> {
        CrushPoint::of(self.point(index)?, omega[index])
    }

    /// The columns from `start`, `length` points long.
    fn slice(&self, start: usize, length: usize) -> Columns<'a> {
        let cut = |column: &'a [f64]| &column[start..start + length];
        Columns { gamma: cut(self.gamma), k_prime: cut(self.k_prime), k: cut(self.k), mu: cut(self.mu) }
    }
}

/// Writes the [code](crate::Mode::code) of every point's mode into `codes`.
///
/// # Errors
/// If a column is not as long as `codes`, or at the first point with a value that is not valid; `codes` then holds
/// the modes of the points before it.
pub fn classify(columns: Columns<'_>, codes: &mut [u8]) -> Result<(), BatchError> {
    columns.check_lengths(codes.len())?;
    let set = InstructionSet::best();
    for (block, codes) in codes.chunks_mut(BLOCK).enumerate() {
        let start = block * BLOCK;
        let columns = columns.slice(start, codes.len());
        screen_with(set, columns, codes);
        if codes.contains(&UNSURE) {
            settle(columns, codes)
                .map_err(|(index, source)| BatchError::Value { index: start + index, source })?;
        }
    }
    Ok(())
}

/// Classifies points on bases that crush, each of its share ω, into the [codes](crate::Verdict::code) of verdicts, BF among them. Points on
/// a rigid base, ω = 0, are those of [`classify`], at its speed.
///
/// ```
/// use standfast::batch::{Columns, classify_on_base};
/// use standfast::Verdict;
///
/// let columns = Columns { gamma: &[0.8; 3], k_prime: &[0.9167; 3], k: &[0.61; 3], mu: &[0.6; 3] };
/// let mut codes = [0; 3];
/// classify_on_base(columns, &[0.0, 0.08, 1.0], &mut codes)?;
/// let symbols = codes.map(|code| Verdict::from_code(code).unwrap().symbol());
/// assert_eq!(symbols, ["SL", "RO", "BF"]);
/// # Ok::<(), standfast::batch::BatchError>(())
/// ```
///
/// # Errors
/// As [`classify`]; or at an ω that is negative or not finite.
pub fn classify_on_base(columns: Columns<'_>, omega: &[f64], codes: &mut [u8]) -> Result<(), BatchError> {
    columns.check_lengths(codes.len())?;
    check_omega(omega, codes.len())?;
    for (block, codes) in codes.chunks_mut(BLOCK).enumerate() {
        let start = block * BLOCK;
        let (columns, omega) = (columns.slice(start, codes.len()), &omega[start..start + codes.len()]);
        if omega.iter().all(|&omega| omega == 0.0) {
            classify(columns, codes).map_err(|error| error.after(start))?;
            continue;
        }
        for (index, code) in codes.iter_mut().enumerate() {
            *code = columns
                .on_base(omega, index)
                .map_err(|source| BatchError::Value { index: start + index, source })?
                .verdict()
                .code();
        }
    }
    Ok(())
}

fn check_omega(omega: &[f64], expected: usize) -> Result<(), BatchError> {
    let found = omega.len();
    if found == expected { Ok(()) } else { Err(BatchError::Length { column: "omega", found, expected }) }
}

/// Replaces the [codes](crate::Mode::code) of modes by those of their [mirror images](Mode::mirrored): the modes under a force that
/// points right. What is the code of no mode stays.
pub fn mirror(codes: &mut [u8]) {
    let images: [u8; 1 << u8::BITS] = std::array::from_fn(|code| {
        let code = code as u8;
        Mode::from_code(code).map_or(code, |mode| mode.mirrored().code())
    });
    codes.iter_mut().for_each(|code| *code = images[usize::from(*code)]);
}

/// Columns that [`onset`] writes: of equal length, in the units of [`Motion`]. A column that is `None` is not computed.
#[derive(Debug, Default)]
pub struct OnsetColumns<'a> {
    /// The [code](crate::Mode::code) of the mode.
    pub mode: Option<&'a mut [u8]>,
    /// True if no other mode is consistent.
    pub unique: Option<&'a mut [bool]>,
    /// The other consistent modes, as the [bits](crate::Modes::bits) of a set; zero where the answer is unique.
    pub others: Option<&'a mut [u16]>,
    /// The motion of the mode: [`MOTION`] names the columns.
    pub motion: [Option<&'a mut [f64]>; 9],
    /// True if the force points right, so that modes and motions are the mirror images of those under a force to the left.
    pub mirrored: bool,
}

/// The names of the columns of [`OnsetColumns::motion`], which are the fields of [`Motion`].
pub const MOTION: [&str; 9] =
    ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi", "slip", "lift_o", "lift_o_prime"];

impl<'a> OnsetColumns<'a> {
    fn check_lengths(&self, expected: usize) -> Result<(), BatchError> {
        let fixed = [
            ("mode", self.mode.as_ref().map(|column| column.len())),
            ("unique", self.unique.as_ref().map(|column| column.len())),
            ("others", self.others.as_ref().map(|column| column.len())),
        ];
        let motion = self.motion.iter().map(|column| column.as_ref().map(|column| column.len()));
        let mut lengths = fixed.into_iter().chain(MOTION.into_iter().zip(motion));
        match lengths.find_map(|(name, found)| Some((name, found.filter(|&found| found != expected)?))) {
            Some((column, found)) => Err(BatchError::Length { column, found, expected }),
            None => Ok(()),
        }
    }

    /// Lends the same columns.
    pub fn reborrow(&mut self) -> OnsetColumns<'_> {
        OnsetColumns {
            mode: self.mode.as_deref_mut(),
            unique: self.unique.as_deref_mut(),
            others: self.others.as_deref_mut(),
            motion: self.motion.each_mut().map(Option::as_deref_mut),
            mirrored: self.mirrored,
        }
    }

    /// The first `index` points, and the rest.
    ///
    /// # Panics
    /// If there are fewer points.
    pub fn split_at(self, index: usize) -> (OnsetColumns<'a>, OnsetColumns<'a>) {
        fn cut<T>(column: Option<&mut [T]>, index: usize) -> (Option<&mut [T]>, Option<&mut [T]>) {
            column.map(|column| column.split_at_mut(index)).unzip()
        }
        let (mode, mode_rest) = cut(self.mode, index);
        let (unique, unique_rest) = cut(self.unique, index);
        let (others, others_rest) = cut(self.others, index);
        let (mut motion, mut motion_rest) = ([const { None }; 9], [const { None }; 9]);
        for ((column, head), tail) in self.motion.into_iter().zip(&mut motion).zip(&mut motion_rest) {
            (*head, *tail) = cut(column, index);
        }
        (
            OnsetColumns { mode, unique, others, motion, mirrored: self.mirrored },
            OnsetColumns {
                mode: mode_rest,
                unique: unique_rest,
                others: others_rest,
                motion: motion_rest,
                mirrored: self.mirrored,
            },
        )
    }
}

/// Writes every point's mode, the other consistent modes, and the motion it begins with: of these, the columns that `out`
/// has.
///
/// # Errors
/// If the columns differ in length, or at the first point with a value that is not valid; the columns of `out` are then
/// written in part.
pub fn onset(columns: Columns<'_>, out: OnsetColumns<'_>) -> Result<(), BatchError> {
    let length = columns.gamma.len();
    columns.check_lengths(length)?;
    out.check_lengths(length)?;
    let mut rest = out;
    let mut codes = [0; BLOCK];
    for start in (0..length).step_by(BLOCK) {
        let block = columns.slice(start, BLOCK.min(length - start));
        let codes = &mut codes[..block.gamma.len()];
        classify(block, codes).map_err(|error| error.after(start))?;
        let (out, tail) = rest.split_at(codes.len());
        rest = tail;
        onset_of(block, codes, out);
    }
    Ok(())
}

/// Writes modes and motions of points on bases that crush, each of its share ω; see [`classify_on_base`]. Of BF there is no motion: its
/// numbers are NaN, and no other mode is consistent.
///
/// # Errors
/// As [`onset`]; or at an ω that is negative or not finite.
pub fn onset_on_base(columns: Columns<'_>, omega: &[f64], out: OnsetColumns<'_>) -> Result<(), BatchError> {
    let length = columns.gamma.len();
    columns.check_lengths(length)?;
    check_omega(omega, length)?;
    out.check_lengths(length)?;
    let mut rest = out;
    for start in (0..length).step_by(BLOCK) {
        let (block, omega) =
            (columns.slice(start, BLOCK.min(length - start)), &omega[start..length.min(start + BLOCK)]);
        let (out, tail) = rest.split_at(omega.len());
        rest = tail;
        if omega.iter().all(|&omega| omega == 0.0) {
            onset(block, out).map_err(|error| error.after(start))?;
        } else {
            onset_of_base(block, omega, out)
                .map_err(|(index, source)| BatchError::Value { index: start + index, source })?;
        }
    }
    Ok(())
}

/// Fills the columns of `out` for points on bases that crush, one by one.
fn onset_of_base(
    columns: Columns<'_>,
    omega: &[f64],
    out: OnsetColumns<'_>,
) -> Result<(), (usize, InputError)> {
    let OnsetColumns { mut mode, mut unique, mut others, mut motion, mirrored } = out;
    let moves = motion.iter().any(Option::is_some);
    for index in 0..omega.len() {
        let point = columns.on_base(omega, index).map_err(|error| (index, error))?;
        if let Some(mode) = &mut mode {
            let verdict = point.verdict();
            mode[index] = if mirrored { verdict.mirrored() } else { verdict }.code();
        }
        if unique.is_some() || others.is_some() {
            let found = point.others();
            if let Some(unique) = &mut unique {
                unique[index] = found.is_empty();
            }
            if let Some(others) = &mut others {
                others[index] = if mirrored { found.mirrored() } else { found }.bits();
            }
        }
        if moves {
            let begun = point.motion().map(|begun| begun.motion);
            let begun = if mirrored { begun.map(|motion| motion.mirrored()) } else { begun };
            let values = begun.map_or([f64::NAN; 9], numbers);
            for (column, value) in motion.iter_mut().zip(values) {
                if let Some(column) = column {
                    column[index] = value;
                }
            }
        }
    }
    Ok(())
}

/// The numbers of a motion, in the order of [`MOTION`].
fn numbers(motion: Motion) -> [f64; 9] {
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } = motion;
    [x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime]
}

/// Fills the columns of `out` for valid points whose modes are known.
fn onset_of(columns: Columns<'_>, codes: &[u8], out: OnsetColumns<'_>) {
    let modes = || codes.iter().map(|&code| Mode::from_code(code).expect("a point has a mode")).enumerate();
    let point = |index: usize| {
        let [gamma, k_prime] = [columns.gamma[index], columns.k_prime[index]];
        Point::of_valid(gamma, k_prime, columns.k[index], columns.mu[index])
    };
    let OnsetColumns { mode, mut unique, mut others, mut motion, mirrored } = out;
    if let Some(mode) = mode {
        mode.copy_from_slice(codes);
        if mirrored {
            mirror(mode);
        }
    }
    if unique.is_some() || others.is_some() {
        for (index, mode) in modes() {
            let found = point(index).others_beside(mode);
            if let Some(unique) = &mut unique {
                unique[index] = found.is_empty();
            }
            if let Some(others) = &mut others {
                others[index] = if mirrored { found.mirrored() } else { found }.bits();
            }
        }
    }
    if motion.iter().any(Option::is_some) {
        for (index, mode) in modes() {
            let motion_of = point(index).motion_of(mode);
            let motion_of = if mirrored { motion_of.mirrored() } else { motion_of };
            for (column, value) in motion.iter_mut().zip(numbers(motion_of)) {
                if let Some(column) = column {
                    column[index] = value;
                }
            }
        }
    }
}

/// Decides exactly what the kernel left open.
#[cold]
fn settle(columns: Columns<'_>, codes: &mut [u8]) -> Result<(), (usize, InputError)> {
    for (index, code) in codes.iter_mut().enumerate().filter(|(_, code)| **code == UNSURE) {
        *code = columns.point(index).map_err(|error| (index, error))?.mode().code();
    }
    Ok(())
}
