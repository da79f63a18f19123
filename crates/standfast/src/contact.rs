//! The general contact problem: every mode that a block at rest can begin with under any planar wrench.
//!
//! ```text
//!            ▲ y
//!            │     M ⟲
//!      ┌─────┼────┐
//!   d  │     C────┼──► x      X to the right
//!      │     │    │           P downwards, weight included
//!      O─────▼────O'
//!       b₁     b₂
//! ```
//!
//! | symbol | identifier | meaning |
//! |---|---|---|
//! | b₁, b₂ | `b1`, `b2` | distance of O to the left and of O' to the right of the centre of mass C |
//! | d | `d` | depth of the base below C |
//! | ρ² | `rho2` | I/m, square of the radius of gyration about C |
//! | m_x, m_y | `m_x`, `m_y` | inertia against ẍ and ÿ in units of m: 1 in air, more with added mass |
//! | μ_s, μ_k | `mu_s`, `mu_k` | friction to stick, and to slip |
//! | X, P, M | `x`, `p`, `m` | wrench at C: to the right, downwards with the weight, counter-clockwise |
//!
//! Non-dimensional by the mass, g and one length, whichever the caller chose. A mode is *consistent* if its motion
//! satisfies the equations of motion, Coulomb's law and non-penetration at both corners. With N and f_x the
//! reaction of the touching corner(s), α = θ̈, r = −b₁ at O and +b₂ at O', σ = −sign r:
//!
//! | mode | motion | conditions |
//! |---|---|---|
//! | rest | none | \|X\| ≤ μ_s P, −b₁P ≤ Xd − M ≤ b₂P |
//! | slide s = ±1 | ẍ = (X − sμ_kP)/m_x | sX > μ_sP, −b₁P ≤ sμ_kdP − M ≤ b₂P |
//! | rock about r | α = (Pr − Xd + M)/(ρ² + m_xd² + m_yr²), ẍ = −dα, ÿ = −rα | σα > 0, N = P − m_yrα ≥ 0, \|X + m_xdα\| ≤ μ_sN |
//! | slide-rock about r, s | c = r − sμ_kd, α = (Pc + M)/(ρ² + m_yrc), ẍ = (X − sμ_kN)/m_x | σα > 0, N ≥ 0, s(ẍ + dα) > 0 |
//! | flight | ẍ = X/m_x, ÿ = −P/m_y, α = M/ρ² | ÿ − b₁α ≥ 0, ÿ + b₂α ≥ 0 |
//!
//! From rest, stick is tried before slip: for μ_s > μ_k, slip at a corner counts only where that corner cannot stick.
//! So a slide-rock about a corner does not count where the body can rest, or rock about the same corner; nor a slide
//! where it can rock about either. The conditions are decided exactly for the f64 given, multiplied out so that
//! nothing is divided. Where a touching corner is not pressed at all, the motion is flight's; it counts once, as the mode that
//! touches. For μ_s = μ_k several modes are consistent only if the friction reaches Painlevé's bound
//! (ρ²/m_y + r²)/(|r| d) at a corner, where ρ² + m_y r c changes its sign; for μ_s > μ_k also where one corner could
//! stick and the other slip. The one [reported](Solution::mode) is then, as in the report's section IV.7, the first of
//! rest, slide, slide-rock (ρ² + m_y r c > 0), rock, slide-rock (ρ² + m_y r c < 0), flight.
//!
//! Limits: the base is flat and rigid, reactions act at the corners, the motion is that of the first instant.
//!
//! ```
//! use standfast::contact::{Block, solve};
//! use standfast::{Mode, Wrench};
//!
//! // The report's γ = 1, k' = −1/2, k = 4, μ = 3: X = −k, M = k k' γ.
//! let answer = solve(&Block::uniform(1.0, 3.0), &Wrench { x: -4.0, p: 1.0, m: -2.0 })?;
//! assert_eq!(answer.mode(), Some(Mode::SlideLeft));
//! assert!(answer.modes.contains(Mode::RockO)); // not unique
//! # Ok::<(), standfast::InputError>(())
//! ```

mod conditions;
mod explain;
mod polytope;

use conditions::Rotation;
pub(crate) use conditions::{Choice, Numbers, REST, conditions, rest, rests_alone};
pub(crate) use explain::relations;

pub mod departure;
pub mod friction;
pub mod holding;
pub mod opening;
pub mod path;
pub mod plane;
pub mod stack;

use std::cmp::Ordering;

use crate::approx::{Approx, Signed};
use crate::ball::{Ball, Scalar};
use crate::error::InputError;
use crate::exact::{Exact, Real};
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::motion::Motion;
use crate::quantity::{Expected, Quantity};
use crate::relation::Relation;
use crate::wrench::Wrench;

/// The numbers of the problem in the order of tables: what each is called there, and which quantity it is.
pub const INPUTS: [(&str, Quantity); 11] = [
    ("b1", Quantity::B1),
    ("b2", Quantity::B2),
    ("d", Quantity::D),
    ("rho2", Quantity::Rho2),
    ("m_x", Quantity::InertiaX),
    ("m_y", Quantity::InertiaY),
    ("x", Quantity::WrenchX),
    ("p", Quantity::WrenchP),
    ("m", Quantity::WrenchM),
    ("mu_s", Quantity::MuS),
    ("mu_k", Quantity::MuK),
];

/// Every mode that the block can begin with whose numbers are in the order of [`INPUTS`].
///
/// # Errors
/// As [`solve`].
pub fn solve_row(row: [f64; INPUTS.len()]) -> Result<Solution, InputError> {
    let [b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s, mu_k] = row;
    solve(&Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k }, &Wrench { x, p, m })
}

/// A block on its base; symbols and units in the [module's table](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// b₁ > 0: distance of O left of C.
    pub b1: f64,
    /// b₂ > 0: distance of O' right of C.
    pub b2: f64,
    /// d > 0: depth of the base below C.
    pub d: f64,
    /// ρ² > 0: square of the radius of gyration about C.
    pub rho2: f64,
    /// m_x > 0: inertia against ẍ, in units of the mass.
    pub m_x: f64,
    /// m_y > 0: inertia against ÿ, in units of the mass.
    pub m_y: f64,
    /// μ_s ≥ μ_k: friction to stick.
    pub mu_s: f64,
    /// μ_k ≥ 0: friction to slip.
    pub mu_k: f64,
}

impl Block {
    /// The report's uniform rectangle with H/B = `slenderness`, lengths in B.
    pub fn uniform(slenderness: f64, friction: f64) -> Block {
        Block {
            b1: 1.0,
            b2: 1.0,
            d: slenderness,
            rho2: (1.0 + slenderness * slenderness) / 3.0,
            m_x: 1.0,
            m_y: 1.0,
            mu_s: friction,
            mu_k: friction,
        }
    }

    fn check(&self) -> Result<(), InputError> {
        InputError::positive(Quantity::B1, self.b1)?;
        InputError::positive(Quantity::B2, self.b2)?;
        InputError::positive(Quantity::D, self.d)?;
        InputError::positive(Quantity::Rho2, self.rho2)?;
        InputError::positive(Quantity::InertiaX, self.m_x)?;
        InputError::positive(Quantity::InertiaY, self.m_y)?;
        InputError::not_negative(Quantity::MuK, self.mu_k)?;
        InputError::finite(Quantity::MuS, self.mu_s)?;
        if self.mu_s < self.mu_k {
            return Err(InputError::new(Quantity::MuS, self.mu_s, Expected::NotBelowKineticFriction));
        }
        Ok(())
    }
}

/// The consistent modes of a block under a wrench.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Every consistent mode.
    pub modes: Modes,
    mode: Option<Mode>,
    block: Block,
    wrench: Wrench,
}

impl Solution {
    /// The mode reported; see the [module](self) for the order. For μ_s = μ_k some mode is always consistent; for
    /// μ_s > μ_k that is not proven, and `None` would say so.
    pub fn mode(&self) -> Option<Mode> {
        self.mode
    }

    /// The motion of a consistent mode, in the units of the input; `None` for a mode that is not consistent.
    pub fn motion(&self, mode: Mode) -> Option<Motion> {
        self.modes.contains(mode).then(|| {
            let numbers = numbers(&self.block, &self.wrench);
            motion(&numbers, mode, |corner, slip| rotation(numbers, corner, slip))
        })
    }

    /// The conditions of a consistent mode with the numbers of its motion; empty for a mode that is not consistent. That
    /// they hold was decided exactly; their numbers are rounded.
    ///
    /// ```
    /// use standfast::contact::{Block, solve};
    /// use standfast::{Mode, Wrench};
    ///
    /// let answer = solve(&Block::uniform(1.0, 0.6), &Wrench { x: -0.5, p: 1.0, m: 0.2 })?;
    /// let conditions: Vec<_> = answer.explain(Mode::Rest).iter().map(ToString::to_string).collect();
    /// assert_eq!(conditions[0], "(friction) |f_x| ≤ μ_s f_y: 0.5 ≤ 0.6, holds by 0.1");
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    pub fn explain(&self, mode: Mode) -> Vec<Relation> {
        self.motion(mode).map_or_else(Vec::new, |motion| relations(&self.block, mode, &motion, 0.0))
    }
}

/// Every mode the block can begin with.
///
/// # Errors
/// If a number is not finite, a length, ρ², m_x or m_y is not above zero, or not μ_s ≥ μ_k ≥ 0.
pub fn solve(block: &Block, wrench: &Wrench) -> Result<Solution, InputError> {
    check(block, wrench)?;
    let numbers = numbers(block, wrench);
    let choice = decide(|| numbers.map(Approx::of), || numbers.map(Exact::of));
    Ok(Solution { modes: choice.modes, mode: choice.mode, block: *block, wrench: *wrench })
}

/// True if each condition of rest holds by more than rounding can matter: then [`solve`] has the block at rest. False says nothing.
pub fn rests_surely(block: &Block, wrench: &Wrench) -> bool {
    let [left, right, at_o, at_o_prime] =
        rest(&numbers(block, wrench).map(Approx::of)).map(|quantity| quantity.sign());
    [left, right] == [Some(Ordering::Less); 2] && [at_o, at_o_prime] == [Some(Ordering::Greater); 2]
}

/// Refuses what no block and no wrench can be.
pub(crate) fn check(block: &Block, wrench: &Wrench) -> Result<(), InputError> {
    block.check()?;
    InputError::finite(Quantity::WrenchX, wrench.x)?;
    InputError::finite(Quantity::WrenchP, wrench.p)?;
    InputError::finite(Quantity::WrenchM, wrench.m)?;
    Ok(())
}

/// The block on another friction to stick, that to slip in proportion.
pub(crate) fn with_friction(block: &Block, μ: f64) -> Block {
    let ratio = if block.mu_s > 0.0 { block.mu_k / block.mu_s } else { 1.0 };
    Block { mu_s: μ, mu_k: μ * ratio, ..*block }
}

/// b₁, b₂, d, ρ², m_x, m_y, μ_s, μ_k, X, P, M.
pub(crate) fn numbers(block: &Block, wrench: &Wrench) -> Numbers<f64> {
    let Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k } = *block;
    let Wrench { x, p, m } = *wrench;
    [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k, x, p, m]
}

/// The choice by tracked floating point, or by exact arithmetic where that cannot tell.
pub(crate) fn decide(approx: impl Fn() -> Numbers<Approx>, exact: impl Fn() -> Numbers<Exact>) -> Choice {
    let choice = Choice::of(conditions(&approx())).or_else(|| Choice::of(conditions(&exact())));
    choice.expect("exact signs are always known")
}

/// α of a mode that turns about a corner, with its sign and digits right however much cancels.
fn rotation(numbers: Numbers<f64>, corner: Corner, slip: Option<Slip>) -> f64 {
    let Rotation { moment, inertia } = Rotation::of(&numbers.map(Approx::of), corner, slip);
    match (moment.precise(), inertia.precise()) {
        (Some(moment), Some(inertia)) => moment / inertia,
        _ => {
            let Rotation { moment, inertia } = Rotation::of(&numbers.map(Exact::of), corner, slip);
            moment.to_f64() / inertia.to_f64()
        }
    }
}

/// The motion of a consistent mode by numbers in decimals.
pub(crate) fn motion_in_decimals(numbers: &Numbers<Ball>, mode: Mode) -> Motion {
    motion(numbers, mode, |corner, slip| {
        let Rotation { moment, inertia } = Rotation::of(numbers, corner, slip);
        moment / inertia
    })
}

/// The motion of a consistent mode, whose α about a corner is worked out by `rotation`.
fn motion<T: Scalar>(
    numbers: &Numbers<T>,
    mode: Mode,
    rotation: impl FnOnce(Corner, Option<Slip>) -> T,
) -> Motion {
    let [b1, b2, d, rho2, m_x, m_y, _, mu_k, x, p, m] = numbers.clone();
    let zero = || T::of(0.0);
    let s = mode.slip().map_or(0.0, Slip::sign);
    let (x_ddot, y_ddot, α, f_x, f_y, xi) = match (mode, mode.corner()) {
        (Mode::Rest, _) => (zero(), zero(), zero(), -x.clone(), p.clone(), (x * d.clone() - m) / p),
        (Mode::Flight, _) => (x / m_x, -p / m_y, m / rho2, zero(), zero(), zero()),
        (_, None) => {
            let f_x = T::of(-s) * mu_k * p.clone();
            let xi = -(f_x.clone() * d.clone() + m) / p.clone();
            ((x + f_x.clone()) / m_x, zero(), zero(), f_x, p, xi)
        }
        (_, Some(corner)) => {
            let r = if corner == Corner::O { -b1.clone() } else { b2.clone() };
            let α = rotation(corner, mode.slip());
            let n = p - m_y * r.clone() * α.clone();
            let up = -r.clone() * α.clone();
            if mode.slip().is_some() {
                let f_x = T::of(-s) * mu_k * n.clone();
                ((x + f_x.clone()) / m_x, up, α, f_x, n, r)
            } else {
                let f_x = -x - m_x * d.clone() * α.clone();
                (-d.clone() * α.clone(), up, α, f_x, n, r)
            }
        }
    };
    let rocks = matches!(mode, Mode::RockO | Mode::RockOPrime);
    let slip = if rocks { zero() } else { x_ddot.clone() + d * α.clone() };
    Motion {
        slip: slip.value(),
        lift_o: (y_ddot.clone() - b1 * α.clone()).value(),
        lift_o_prime: (y_ddot.clone() + b2 * α.clone()).value(),
        x_ddot: x_ddot.value(),
        y_ddot: y_ddot.value(),
        theta_ddot: α.value(),
        f_x: f_x.value(),
        f_y: f_y.value(),
        xi: if f_y.value() == 0.0 { 0.0 } else { xi.value() },
    }
}
