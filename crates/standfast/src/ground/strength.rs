//! A base that crushes: which mode begins where the ground, mortar or stone under the body bears no more than q, and with what
//! motion.
//!
//! ```text
//!            ▲ y                              α = θ̈ > 0
//!            │     M ⟲                    ┌──────────────┐
//!      ┌─────┼────┐                       │              │
//!   d  │     C────┼──► x               ───┴───┬──────────┘
//!      │     │    │                    ▒▒▒▒▒▒▒▲▒▒▒▒
//!      O─────▼────O'                   ◄──c──►neutral point
//!       b₁     b₂  P                   q ▲▲▲▲▲
//! ```
//!
//! The base bears a pressure 0 ≤ p ≤ q: p = q where it moves down, none where it lifts (rigid–plastic, no tension), and
//! Coulomb's friction on the sum. A body that turns no longer turns about its corner but about the *neutral point*, c from the
//! edge; its reaction N = q c acts at c/2.
//!
//! | symbol | identifier | meaning |
//! |---|---|---|
//! | q | `strength` | what the base bears per length; infinite for a rigid base |
//! | ω | `omega` | P/(q (b₁ + b₂)); for the report's block P/(2B q_u). From 1 on the base cannot carry P: BF |
//! | c | [`CrushMotion::pressed`] | crushed width |
//!
//! The other symbols are those of the [contact problem](crate::contact), of which this is the limit for q → ∞. With b = b₁ and
//! σ = 1 about O, b = b₂ and σ = −1 about O', a = σθ̈ > 0:
//!
//! | mode | motion | conditions |
//! |---|---|---|
//! | rest | none | \|X\| ≤ μ_s P, −b₁P + P²/2q ≤ Xd − M ≤ b₂P − P²/2q |
//! | slide s = ±1 | ẍ = (X − sμ_kP)/m_x | sX > μ_sP, −b₁P + P²/2q ≤ sμ_kdP − M ≤ b₂P − P²/2q |
//! | rock | (ρ² + m_xd²)a + R(a) = σ(M − Xd) | a > 0, \|X + m_xdθ̈\| ≤ μ_sN(a) |
//! | slide-rock s | ρ²a + R(a) = σ(M − sμ_kdN(a)) | a > 0, s(ẍ + dθ̈) > 0 |
//! | flight | as on a rigid base | P ≤ 0 |
//!
//! ```text
//! c = (P + m_y b a)/(q + m_y a)      N = q c      R = N (b − c/2)
//! ```
//!
//! The last are cubics in a. Rock has one root at most; slide-rock has one as long as the friction is below
//! [`CrushSolution::bound`], and so one mode only is consistent there. Where several are, the one reported is the first of rest;
//! slide; slide-rock that begins from a = 0, about an edge that does not stick; rock; any other slide-rock; flight. In the
//! report's problem that order is RE, SRO'-, SL, RO, SRO∓. For μ_s > μ_k stick is tried before slip, as on a rigid base; and a
//! body that crushes its edge may press less as it tips, so that it neither rests, nor sticks while it rocks, nor is pulled
//! by more than μ_sP: then it slides if sX > μ_kP. All conditions are decided exactly for the f64 given; those at
//! the root of a cubic by the sign of the cubic, not of its root.
//!
//! Limits: onset only; once its edge is crushed a body stands on another base. The strength is one number: a pressure that spreads, or
//! rises with the depth, is the [`bearing`](super::bearing) of the ground.
//!
//! Reference: derived here from equilibrium and the plastic law. Rest is Meyerhof's effective width; the moment
//! P(B − P/(2q_u)) is that of Gajan & Kutter's critical contact area.
//!
//! ```
//! use standfast::ground::strength::CrushPoint;
//!
//! // The README's caisson in air: γ = 0.8, k' = 0.9167, μ = 0.6. On rigid ground it slides first; on ω = 0.08 it rocks.
//! let at = |k: f64| CrushPoint::new(0.8, 0.9167, k, 0.6, 0.08).map(|point| point.verdict().symbol());
//! assert_eq!((at(0.5998)?, at(0.61)?), ("RE", "RO"));
//! # Ok::<(), standfast::InputError>(())
//! ```

mod chart;
mod conditions;
mod edges;
mod events;
mod friction;
mod path;
mod point;
mod situated;
mod trace;
mod turning;

pub use chart::{CrushChart, CrushEdge, CrushMap, CrushRegion, CrushStrip, RockEdgePoint};
pub use edges::reduced_strength;
pub use friction::{departure, departure_spans, friction_spans};
pub use path::{LoadRange, bearing_range, rest_range, stages};
pub use point::CrushPoint;
pub use situated::{CrushOutcome, outcome};
pub use trace::CrushMargins;

pub(super) use edges::CrushEdges;

use self::conditions::enumerate;
use self::turning::{Rate, Turn, orientation};
use crate::approx::Approx;
use crate::contact::Block;
use crate::error::InputError;
use crate::exact::{Exact, Real};
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::motion::Motion;
use crate::quantity::Quantity;
use crate::verdict::{Decision, Verdict};
use crate::wrench::Wrench;

/// Numbers of a problem. q = `q[0]`/`q[1]`, so that a rigid base and ω are numbers too.
#[derive(Debug, Clone)]
struct Numbers<T> {
    b: [T; 2],
    d: T,
    rho2: T,
    m_x: T,
    m_y: T,
    mu_s: T,
    mu_k: T,
    x: T,
    p: T,
    m: T,
    q: [T; 2],
}

impl<T: Real> Numbers<T> {
    /// b: the distance of an edge from C.
    fn edge(&self, corner: Corner) -> T {
        match corner {
            Corner::O => self.b[0].clone(),
            Corner::OPrime => self.b[1].clone(),
        }
    }
}

/// A problem whose numbers can be had in any arithmetic.
trait CrushProblem {
    fn numbers<T: Real>(&self) -> Numbers<T>;
}

/// Any wrench on any block.
#[derive(Debug, Clone, Copy, PartialEq)]
struct LoadedBlock {
    block: Block,
    wrench: Wrench,
    strength: f64,
}

impl CrushProblem for LoadedBlock {
    fn numbers<T: Real>(&self) -> Numbers<T> {
        let Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k } = self.block;
        let Wrench { x, p, m } = self.wrench;
        let [d, rho2, m_x, m_y, mu_s, mu_k] = [d, rho2, m_x, m_y, mu_s, mu_k].map(T::of);
        let [x, p, m] = [x, p, m].map(T::of);
        let q = if self.strength == f64::INFINITY { [1.0, 0.0] } else { [self.strength, 1.0] };
        Numbers { b: [b1, b2].map(T::of), d, rho2, m_x, m_y, mu_s, mu_k, x, p, m, q: q.map(T::of) }
    }
}

/// A part of the base, from the centre of mass to the right.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stretch {
    /// Its left end.
    pub from: f64,
    /// Its right end.
    pub to: f64,
}

impl Stretch {
    /// Width of the stretch.
    pub fn width(&self) -> f64 {
        self.to - self.from
    }
}

/// The motion a mode begins with on a base that crushes, and where the base bears; in the units of the input.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CrushMotion {
    /// Accelerations and reactions; ξ is where the reaction acts. Of a body that turns, the edge it turns about goes down.
    pub motion: Motion,
    /// Stretch on which the base bears with its strength. Of a body that turns, its crushed part; of one that does not, the least part that
    /// carries the reaction, Meyerhof's effective width when no more than P/q is needed. Of no width on a rigid base.
    pub pressed: Stretch,
    /// The neutral point about which the body turns, right of the centre of mass; `None` if it does not turn.
    pub neutral: Option<f64>,
}

impl CrushMotion {
    /// The motion in other units; see [`Motion::scaled`].
    pub fn scaled(&self, acceleration: f64, length: f64, force: f64) -> CrushMotion {
        let Stretch { from, to } = self.pressed;
        CrushMotion {
            motion: self.motion.scaled(acceleration, length, force),
            pressed: Stretch { from: from * length, to: to * length },
            neutral: self.neutral.map(|neutral| neutral * length),
        }
    }

    /// The motion seen in a mirror.
    pub fn mirrored(&self) -> CrushMotion {
        let Stretch { from, to } = self.pressed;
        CrushMotion {
            motion: self.motion.mirrored(),
            pressed: Stretch { from: 0.0 - to, to: 0.0 - from },
            neutral: self.neutral.map(|neutral| 0.0 - neutral),
        }
    }
}

/// The consistent modes of a block under a wrench, on a base that crushes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrushSolution {
    /// Every consistent mode; none where the base cannot carry P.
    pub modes: Modes,
    verdict: Option<Verdict>,
    given: LoadedBlock,
}

impl CrushSolution {
    /// Verdict reported; see the [module](self) for the order. For μ_s = μ_k and P > 0 there always is one; for μ_s > μ_k that is not
    /// proven, and `None` would say so.
    pub fn verdict(&self) -> Option<Verdict> {
        self.verdict
    }

    /// The motion of a consistent mode, in the units of the input; `None` for a mode that is not consistent.
    pub fn motion(&self, mode: Mode) -> Option<CrushMotion> {
        self.modes.contains(mode).then(|| motion(&self.given, mode))
    }

    /// P/(q (b₁ + b₂)): the share of the base that P needs; zero on a rigid base.
    pub fn omega(&self) -> f64 {
        let LoadedBlock { block, wrench, strength } = self.given;
        wrench.p / strength / (block.b1 + block.b2)
    }

    /// The friction to slip up to which one mode only is consistent (μ_s = μ_k):
    /// (z + ρ²/(m_y z))/d with z = |b − P/q|, or 1.5 (2ρ²z/m_y)^⅓/d where 2ρ² < m_y z²; the lesser of both edges. At z = 0 there is
    /// no bound: it is infinite.
    pub fn bound(&self) -> f64 {
        let LoadedBlock { block, wrench, strength } = self.given;
        let Block { b1, b2, d, rho2, m_y, .. } = block;
        let gyration = rho2 / m_y;
        let at = |b: f64| bound((b - wrench.p / strength).abs(), d, gyration, strength == f64::INFINITY);
        at(b1).min(at(b2))
    }
}

/// The friction below which a slide-rock's equation has one root; see [`CrushSolution::bound`].
fn bound(z: f64, d: f64, gyration: f64, rigid: bool) -> f64 {
    match z {
        0.0 => f64::INFINITY,
        _ if rigid || 2.0 * gyration >= z * z => (z + gyration / z) / d,
        _ => 1.5 * (2.0 * gyration * z).cbrt() / d,
    }
}

/// Every mode the block can begin with on a base that bears `strength` per length, in units of force per length of the input;
/// infinite for a rigid base.
///
/// # Errors
/// As the [contact problem's](crate::contact::solve); or if `strength` is neither above zero nor infinite.
pub fn solve(block: &Block, wrench: &Wrench, strength: f64) -> Result<CrushSolution, InputError> {
    check(block, wrench, strength)?;
    let given = LoadedBlock { block: *block, wrench: *wrench, strength };
    let Decision { modes, verdict } = enumerate(&given);
    Ok(CrushSolution { modes, verdict, given })
}

/// Refuses what no block, no wrench and no strength can be.
fn check(block: &Block, wrench: &Wrench, strength: f64) -> Result<(), InputError> {
    crate::contact::check(block, wrench)?;
    if strength != f64::INFINITY {
        InputError::positive(Quantity::Strength, strength)?;
    }
    Ok(())
}

/// The motion of a consistent mode.
fn motion(given: &impl CrushProblem, mode: Mode) -> CrushMotion {
    let n = given.numbers::<f64>();
    let s = mode.slip().map_or(0.0, Slip::sign);
    let Some(corner) = mode.corner() else { return upright(&n, mode, s) };
    let (σ, b) = (orientation(corner), n.edge(corner));
    let [q0, q1] = n.q;
    let z = b - n.p * q1 / q0;
    let (rate, a) = rate(given, &n, corner, mode.slip());
    // N − P = m_y z a v, without the difference.
    let rise = z * a * rate.share(a);
    let normal = (n.p + n.m_y * rise).max(0.0);
    let crushed = normal * q1 / q0;
    let α = σ * a;
    let (f_x, x_ddot) = match mode.slip() {
        None => (0.0 - n.x - n.m_x * n.d * α, 0.0 - n.d * α),
        Some(_) => {
            let f_x = 0.0 - s * n.mu_k * normal;
            (f_x, (n.x + f_x) / n.m_x)
        }
    };
    let [outer, inner] = [0.0 - σ * b, 0.0 - σ * (b - crushed)];
    let motion = Motion {
        x_ddot,
        y_ddot: rise,
        theta_ddot: α,
        f_x,
        f_y: normal,
        xi: if normal == 0.0 { 0.0 } else { 0.0 - σ * (b - crushed / 2.0) },
        slip: if mode.slip().is_none() { 0.0 } else { x_ddot + n.d * α },
        lift_o: rise - n.b[0] * α,
        lift_o_prime: rise + n.b[1] * α,
    };
    let pressed = Stretch { from: outer.min(inner), to: outer.max(inner) };
    CrushMotion { motion, pressed, neutral: Some(inner) }
}

/// The motion of a mode without rotation, and of flight.
fn upright(n: &Numbers<f64>, mode: Mode, s: f64) -> CrushMotion {
    let [q0, q1] = n.q;
    let half = n.p * q1 / (2.0 * q0);
    let (x_ddot, y_ddot, α, f_x, f_y, about) = match mode {
        Mode::Flight => (n.x / n.m_x, 0.0 - n.p / n.m_y, n.m / n.rho2, 0.0, 0.0, 0.0),
        Mode::Rest => (0.0, 0.0, 0.0, 0.0 - n.x, n.p, n.x * n.d - n.m),
        _ => {
            let f_x = 0.0 - s * n.mu_k * n.p;
            ((n.x + f_x) / n.m_x, 0.0, 0.0, f_x, n.p, 0.0 - f_x * n.d - n.m)
        }
    };
    // Rounding is not to push the reaction off where the base bears it.
    let (from, to) = (half - n.b[0], n.b[1] - half);
    let xi = if f_y == 0.0 { 0.0 } else { (about / n.p).max(from).min(to.max(from)) };
    let motion = Motion {
        x_ddot,
        y_ddot,
        theta_ddot: α,
        f_x,
        f_y,
        xi,
        slip: x_ddot + n.d * α,
        lift_o: y_ddot - n.b[0] * α,
        lift_o_prime: y_ddot + n.b[1] * α,
    };
    CrushMotion { motion, pressed: Stretch { from: xi - half, to: xi + half }, neutral: None }
}

/// The equation of a consistent turn and its root: that which friction does not stop, nearest to a = 0.
fn rate(given: &impl CrushProblem, n: &Numbers<f64>, corner: Corner, slip: Option<Slip>) -> (Rate, f64) {
    // Δ vanishes where the turn begins: its digits there are those of exact arithmetic.
    let surplus = Turn::about(&given.numbers::<Approx>(), corner, slip).surplus.precise();
    let exactly = || Turn::about(&given.numbers::<Exact>(), corner, slip).surplus.to_f64();
    let rate = Rate::of(n, corner, slip, surplus.unwrap_or_else(exactly));
    let roots = rate.roots();
    let Some(slip) = slip else { return (rate, roots.first().copied().unwrap_or(rate.least)) };
    let w = Turn::about(n, corner, Some(slip)).slipping(n, corner, slip, &n.mu_k);
    let freedom = |a: &f64| crate::polynomial::value(&w, a);
    let slips = roots.iter().find(|a| freedom(a) > 0.0);
    let nearest = slips.or_else(|| roots.iter().max_by(|a, b| freedom(a).total_cmp(&freedom(b))));
    (rate, nearest.copied().unwrap_or(rate.least))
}
