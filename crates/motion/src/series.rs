//! Power series in time of each state of motion: the equations of motion as recurrences for their coefficients.
//!
//! With c(θ) = r cosθ + d sinθ and h(θ) = d cosθ − r sinθ of the touching corner, c' = hω and h' = −cω, so that their
//! coefficients follow from those of ω without a sine. The corner stays on the base, y = h, so that ẏ = −cω and N = P + m_y ÿ; where
//! it also stays in its place, ẋ = −hω and T = m_x ẍ − X. Moments about C close the recurrence, ρ²α = cN + hT, which is linear in the
//! newest coefficient of α: one division by a number for each.

use standfast::Corner;
use standfast::contact::Block;

use crate::forcing::Channels;

/// The order of the series of θ.
pub(crate) const ORDER: usize = 12;
/// Room for a series.
pub(crate) const LEN: usize = ORDER + 3;
/// Coefficients, lowest power first.
pub(crate) type Series = [f64; LEN];

/// The derivative of a polynomial.
pub(crate) fn derivative(powers: &Series) -> Series {
    let mut derivative = [0.0; LEN];
    for k in 1..LEN {
        derivative[k - 1] = k as f64 * powers[k];
    }
    derivative
}

/// Position and velocity of the centre of mass, relative to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Pose {
    pub x: f64,
    pub y: f64,
    pub θ: f64,
    pub vx: f64,
    pub vy: f64,
    pub ω: f64,
}

/// r of a corner: where it is right of C.
#[inline]
pub(crate) fn arm(block: &Block, corner: Corner) -> f64 {
    match corner {
        Corner::O => -block.b1,
        Corner::OPrime => block.b2,
    }
}

/// c and h of a corner at a pose.
#[inline]
pub(crate) fn lever(block: &Block, corner: Corner, θ: f64) -> [f64; 2] {
    let (r, d, (sin, cos)) = (arm(block, corner), block.d, θ.sin_cos());
    [r * cos + d * sin, d * cos - r * sin]
}

/// u_x and u_y of a corner.
#[inline]
pub(crate) fn velocity(block: &Block, corner: Corner, pose: &Pose) -> [f64; 2] {
    let [c, h] = lever(block, corner, pose.θ);
    [pose.vx + h * pose.ω, pose.vy + c * pose.ω]
}

/// The series of a state over a step.
#[derive(Debug, Clone)]
pub(crate) struct Motion {
    /// θ and ω, to the order + 1 and to the order.
    pub θ: Series,
    pub ω: Series,
    /// x of the centre of mass.
    pub x: Series,
    pub vx: Series,
    pub y: Series,
    pub vy: Series,
    /// N and T of the touching corner or base, from the order − 2 down.
    pub normal: Series,
    pub tangential: Series,
    /// c and h.
    pub c: Series,
    pub h: Series,
    /// X, P, M.
    pub wrench: [Series; 3],
}

impl Motion {
    pub(crate) const EMPTY: Motion = Motion {
        θ: [0.0; LEN],
        ω: [0.0; LEN],
        x: [0.0; LEN],
        vx: [0.0; LEN],
        y: [0.0; LEN],
        vy: [0.0; LEN],
        normal: [0.0; LEN],
        tangential: [0.0; LEN],
        c: [0.0; LEN],
        h: [0.0; LEN],
        wrench: [[0.0; LEN]; 3],
    };
}

/// Σ_{j=from}^{to} a_j b_{k−j}.
#[inline(always)]
fn folded(a: &Series, b: &Series, k: usize, from: usize, to: usize) -> f64 {
    let mut sum = 0.0;
    for j in from..=to {
        sum += a[j] * b[k - j];
    }
    sum
}

/// The k-th coefficient of a product whose first factor has powers up to `degree`.
#[inline(always)]
fn product(a: &Series, degree: usize, b: &Series, k: usize) -> f64 {
    folded(a, b, k, 0, k.min(degree))
}

/// The wrench of loads that turn with the body or about it: their factors of cosθ and sinθ, added up.
struct Turning {
    cos: Series,
    sin: Series,
    r: f64,
    d: f64,
}

impl Turning {
    fn new(r: f64, d: f64) -> Turning {
        Turning { cos: [0.0; LEN], sin: [0.0; LEN], r, d }
    }

    /// From R² cosθ = r c + d h and R² sinθ = d c − r h, R² = r² + d².
    #[inline]
    fn put(&mut self, k: usize, c: f64, h: f64) {
        let square = self.r * self.r + self.d * self.d;
        self.cos[k] = (self.r * c + self.d * h) / square;
        self.sin[k] = (self.d * c - self.r * h) / square;
    }

    #[inline]
    fn wrench(&self, channels: &Channels, k: usize, wrench: &mut [Series; 3]) {
        for (total, [fixed, cos, sin]) in wrench.iter_mut().zip(&channels.series) {
            total[k] = fixed[k] + folded(cos, &self.cos, k, 0, k) + folded(sin, &self.sin, k, 0, k);
        }
    }
}

/// The corner stays in its place: rocking, to the order `n`.
pub(crate) fn rocking(
    block: &Block,
    corner: Corner,
    pose: &Pose,
    channels: &Channels,
    n: usize,
    motion: &mut Motion,
) {
    let Block { d, rho2, m_x, m_y, .. } = *block;
    let r = arm(block, corner);
    let [c0, h0] = lever(block, corner, pose.θ);
    let mut turning = Turning::new(r, d);
    let degree = channels.degree(n);
    let equal = m_x == m_y;
    let about = if equal { rho2 + m_x * (r * r + d * d) } else { rho2 + m_y * c0 * c0 + m_x * h0 * h0 };
    let Motion { θ, ω, c, h, normal, tangential, wrench, .. } = motion;
    (c[0], h[0], θ[0], ω[0], θ[1]) = (c0, h0, pose.θ, pose.ω, pose.ω);
    channels.fixed(wrench);
    for k in 0..n {
        let next = (k + 1) as f64;
        c[k + 1] = folded(h, ω, k, 0, k) / next;
        h[k + 1] = -folded(c, ω, k, 0, k) / next;
        if channels.turn {
            turning.put(k, c[k], h[k]);
            turning.wrench(channels, k, wrench);
        }
        let [x, p, m] = &*wrench;
        let α = if equal {
            (product(p, degree, c, k) - product(x, degree, h, k) + m[k]) / about
        } else {
            // N and T but for what the newest coefficient of α adds.
            let up = p[k] - m_y * next * folded(c, ω, k + 1, 1, k + 1);
            let along = -x[k] - m_x * next * folded(h, ω, k + 1, 1, k + 1);
            let mut moment = m[k] + c0 * up + h0 * along;
            for j in 0..k {
                moment += normal[j] * c[k - j] + tangential[j] * h[k - j];
            }
            let α = moment / about;
            normal[k] = up - m_y * c0 * α;
            tangential[k] = along - m_x * h0 * α;
            α
        };
        ω[k + 1] = α / next;
        θ[k + 2] = ω[k + 1] / (next + 1.0);
    }
    let [x, p, _] = &*wrench;
    for k in 0..n - 1 {
        let twice = ((k + 1) * (k + 2)) as f64;
        normal[k] = p[k] + m_y * twice * h[k + 2];
        tangential[k] = -x[k] - m_x * twice * c[k + 2];
    }
    for k in 0..n {
        motion.vx[k] = -((k + 1) as f64) * motion.c[k + 1];
        motion.vy[k] = (k + 1) as f64 * motion.h[k + 1];
        (motion.x[k + 1], motion.y[k + 1]) = (-motion.c[k + 1], motion.h[k + 1]);
    }
    (motion.x[0], motion.y[0]) = (pose.x, h0);
    // One power less than ω has; nothing of an earlier state may stay.
    (motion.vx[n], motion.vy[n]) = (0.0, 0.0);
    motion.x[n + 1..].fill(0.0);
    motion.y[n + 1..].fill(0.0);
}

/// ĉ = c − sμ_k h and D = ρ² + m_y c ĉ, whose zero is Painlevé's, of a corner that slips.
pub(crate) fn slipping_inertia(block: &Block, corner: Corner, slip: f64, θ: f64) -> f64 {
    let [c, h] = lever(block, corner, θ);
    block.rho2 + block.m_y * c * (c - slip * block.mu_k * h)
}

/// The corner slips, `slip` = ±1: slide-rock, to the order `n`.
pub(crate) fn slipping(
    block: &Block,
    corner: Corner,
    slip: f64,
    pose: &Pose,
    channels: &Channels,
    n: usize,
    motion: &mut Motion,
) {
    let Block { d, rho2, m_x, m_y, mu_k, .. } = *block;
    let friction = slip * mu_k;
    let [c0, h0] = lever(block, corner, pose.θ);
    let mut turning = Turning::new(arm(block, corner), d);
    let Motion { θ, ω, c, h, x, vx, normal, tangential, wrench, .. } = motion;
    (c[0], h[0], θ[0], ω[0], θ[1]) = (c0, h0, pose.θ, pose.ω, pose.ω);
    (x[0], vx[0], x[1]) = (pose.x, pose.vx, pose.vx);
    channels.fixed(wrench);
    let mut hat = [0.0; LEN];
    hat[0] = c0 - friction * h0;
    let about = rho2 + m_y * c0 * hat[0];
    for k in 0..n {
        let next = (k + 1) as f64;
        c[k + 1] = folded(h, ω, k, 0, k) / next;
        h[k + 1] = -folded(c, ω, k, 0, k) / next;
        hat[k + 1] = c[k + 1] - friction * h[k + 1];
        if channels.turn {
            turning.put(k, c[k], h[k]);
            turning.wrench(channels, k, wrench);
        }
        let [x_force, p, m] = &*wrench;
        // N but for what the newest coefficient of α adds.
        let up = p[k] - m_y * next * folded(c, ω, k + 1, 1, k + 1);
        let mut moment = m[k] + hat[0] * up;
        for j in 0..k {
            moment += normal[j] * hat[k - j];
        }
        let α = moment / about;
        normal[k] = up - m_y * c0 * α;
        tangential[k] = -friction * normal[k];
        ω[k + 1] = α / next;
        θ[k + 2] = ω[k + 1] / (next + 1.0);
        vx[k + 1] = (x_force[k] + tangential[k]) / (m_x * next);
        x[k + 2] = vx[k + 1] / (next + 1.0);
    }
    for k in 0..n {
        motion.vy[k] = (k + 1) as f64 * motion.h[k + 1];
        motion.y[k + 1] = motion.h[k + 1];
    }
    motion.y[0] = h0;
    motion.vy[n] = 0.0;
    motion.x[n + 2..].fill(0.0);
    motion.y[n + 1..].fill(0.0);
}

/// D of a corner that slips, along a motion found before.
pub(crate) fn inertia_along(block: &Block, slip: f64, n: usize, motion: &Motion) -> Series {
    let mut inertia = [0.0; LEN];
    let mut hat = [0.0; LEN];
    for k in 0..=n {
        hat[k] = motion.c[k] - slip * block.mu_k * motion.h[k];
        inertia[k] = block.m_y * folded(&motion.c, &hat, k, 0, k);
    }
    inertia[0] += block.rho2;
    inertia
}

/// No corner touches, to the order `n`.
pub(crate) fn flying(block: &Block, pose: &Pose, channels: &Channels, n: usize, motion: &mut Motion) {
    let Block { rho2, m_x, m_y, .. } = *block;
    // As if about a corner right under C, so that c = sinθ and h = cosθ.
    let (sin, cos) = pose.θ.sin_cos();
    let mut turning = Turning::new(0.0, 1.0);
    let Motion { θ, ω, c, h, x, vx, y, vy, wrench, .. } = motion;
    (c[0], h[0], θ[0], ω[0], θ[1]) = (sin, cos, pose.θ, pose.ω, pose.ω);
    (x[0], vx[0], x[1], y[0], vy[0], y[1]) = (pose.x, pose.vx, pose.vx, pose.y, pose.vy, pose.vy);
    channels.fixed(wrench);
    for k in 0..n {
        let next = (k + 1) as f64;
        c[k + 1] = folded(h, ω, k, 0, k) / next;
        h[k + 1] = -folded(c, ω, k, 0, k) / next;
        if channels.turn {
            turning.put(k, c[k], h[k]);
            turning.wrench(channels, k, wrench);
        }
        let [x_force, p, m] = &*wrench;
        ω[k + 1] = m[k] / (rho2 * next);
        vx[k + 1] = x_force[k] / (m_x * next);
        vy[k + 1] = -p[k] / (m_y * next);
        (θ[k + 2], x[k + 2], y[k + 2]) =
            (ω[k + 1] / (next + 1.0), vx[k + 1] / (next + 1.0), vy[k + 1] / (next + 1.0));
    }
    motion.x[n + 2..].fill(0.0);
    motion.y[n + 2..].fill(0.0);
    motion.normal = [0.0; LEN];
    motion.tangential = [0.0; LEN];
}

/// The gap of a corner in flight, y − h(θ).
pub(crate) fn gap_along(block: &Block, corner: Corner, n: usize, motion: &Motion) -> Series {
    let r = arm(block, corner);
    let mut gap = [0.0; LEN];
    for k in 0..=n {
        // `c` and `h` are sinθ and cosθ there.
        gap[k] = motion.y[k] - (block.d * motion.h[k] - r * motion.c[k]);
    }
    gap
}

/// Both corners on the base: at rest (`slip` 0) or sliding.
pub(crate) fn flat(
    block: &Block,
    slip: f64,
    pose: &Pose,
    channels: &Channels,
    n: usize,
    motion: &mut Motion,
) {
    let degree = channels.degree_flat(n);
    channels.fixed(&mut motion.wrench);
    if channels.turn {
        for (total, [_, cos, _]) in motion.wrench.iter_mut().zip(&channels.series) {
            for k in 0..=degree {
                total[k] += cos[k];
            }
        }
    }
    let [x, p, _] = motion.wrench;
    for array in [&mut motion.θ, &mut motion.ω, &mut motion.vx, &mut motion.vy, &mut motion.x, &mut motion.y]
    {
        *array = [0.0; LEN];
    }
    (motion.x[0], motion.y[0], motion.vx[0]) = (pose.x, block.d, pose.vx);
    motion.normal = p;
    if slip == 0.0 {
        motion.tangential = x.map(|x| -x);
        motion.vx[0] = 0.0;
        return;
    }
    motion.x[1] = pose.vx;
    for k in 0..=degree {
        let next = (k + 1) as f64;
        motion.tangential[k] = -slip * block.mu_k * p[k];
        motion.vx[k + 1] = (x[k] + motion.tangential[k]) / (block.m_x * next);
        motion.x[k + 2] = motion.vx[k + 1] / (next + 1.0);
    }
    for k in degree + 1..LEN {
        motion.tangential[k] = 0.0;
    }
}
