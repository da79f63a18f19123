//! The rotation about an edge that crushes: its equation, the slip that goes with it, and its root.
//!
//! With a = σθ̈ > 0, q = `q[0]`/`q[1]`, Q = `q[0]` + `q[1]` m_y a and Z = `q[0]` b − `q[1]` P, everything multiplied out:
//!
//! ```text
//! F(a) = 2q₀ I₀ a Q² + m_y Z² a (Q + q₀) + 2q₀ f a Q − Δ Q²       I₀ = J (rock), ρ² (slide-rock)
//! Δ    = 2q₀ (σM_O − P b) + q₁P²                                  M_O = M − Xd (rock), M − sμ_k dP (slide-rock)
//! f    = σ s μ_k d m_y Z                                          0 (rock)
//! W(a) = s Q (X + σ m_x d a) − μ (P Q + m_y Z a)                  > 0: friction μ does not stop a slip s
//! ```
//!
//! F is (I₀a + R − σM_O ± …)·2q₀Q²: R(a) − R(0) = m_y z² a v(1+v)/2 and N(a) − P = m_y z a v with z = Z/q₀ = b − P/q, v = q₀/Q,
//! so that nothing cancels next to a = 0. On a rigid base q₁ = 0 and F is linear.

use super::Numbers;
use crate::exact::Real;
use crate::ground::roots::{real_roots, shifted};
use crate::mode::{Corner, Slip};

/// The polynomials of a turn, and the constants of its equation.
pub(super) struct Turn<T> {
    /// F from its constant on.
    pub(super) equation: Vec<T>,
    /// Δ: positive if the turn begins from a = 0.
    pub(super) surplus: T,
    /// Z.
    pub(super) lever: T,
    inertia: T,
    friction: T,
}

/// σ: 1 about O, where θ̈ > 0 lifts the other edge, −1 about O'.
pub(super) fn orientation(corner: Corner) -> f64 {
    match corner {
        Corner::O => 1.0,
        Corner::OPrime => -1.0,
    }
}

impl<T: Real> Turn<T> {
    /// The turn about `corner`, which sticks or slips.
    pub(super) fn about(n: &Numbers<T>, corner: Corner, slip: Option<Slip>) -> Turn<T> {
        let [q0, q1] = n.q.clone();
        let two = T::of(2.0);
        let σ = T::of(orientation(corner));
        let b = n.edge(corner);
        let lever = q0.clone() * b.clone() - q1.clone() * n.p.clone();
        let (inertia, moment, friction) = match slip {
            None => (
                n.rho2.clone() + n.m_x.clone() * n.d.clone() * n.d.clone(),
                n.m.clone() - n.x.clone() * n.d.clone(),
                T::of(0.0),
            ),
            Some(slip) => {
                let grip = T::of(slip.sign()) * n.mu_k.clone() * n.d.clone();
                let friction = σ.clone() * grip.clone() * n.m_y.clone() * lever.clone();
                (n.rho2.clone(), n.m.clone() - grip * n.p.clone(), friction)
            }
        };
        let surplus = two.clone() * q0.clone() * (σ * moment - n.p.clone() * b)
            + q1.clone() * n.p.clone() * n.p.clone();

        let grown = q1 * n.m_y.clone(); // Q = q₀ + grown·a
        let twice = two.clone() * q0.clone();
        let body = twice.clone() * inertia.clone();
        let crush = n.m_y.clone() * lever.clone() * lever.clone();
        let drag = twice.clone() * friction.clone();
        let square = q0.clone() * q0.clone();
        let equation = vec![
            -(surplus.clone() * square.clone()),
            body.clone() * square + crush.clone() * twice.clone() + drag.clone() * q0
                - surplus.clone() * twice.clone() * grown.clone(),
            (body.clone() * twice + crush + drag) * grown.clone()
                - surplus.clone() * grown.clone() * grown.clone(),
            body * grown.clone() * grown,
        ];
        Turn { equation, surplus, lever, inertia, friction }
    }

    /// W from its constant on: positive where friction `mu` does not stop a slip.
    pub(super) fn slipping(&self, n: &Numbers<T>, corner: Corner, slip: Slip, mu: &T) -> Vec<T> {
        let [q0, q1] = n.q.clone();
        let s = T::of(slip.sign());
        let pull = T::of(orientation(corner)) * n.m_x.clone() * n.d.clone();
        let grown = q1 * n.m_y.clone();
        let force = s.clone() * n.x.clone() - mu.clone() * n.p.clone();
        vec![
            q0.clone() * force.clone(),
            grown.clone() * force + s.clone() * q0 * pull.clone()
                - mu.clone() * n.m_y.clone() * self.lever.clone(),
            s * grown * pull,
        ]
    }

    /// A polynomial in a as one that begins where the edge begins to be pressed: at a = 0 for P > 0, else at P + m_y b a = 0.
    pub(super) fn from_pressed(f: Vec<T>, n: &Numbers<T>, corner: Corner, lifted: bool) -> Vec<T> {
        if lifted { shifted(&f, &n.p, &(n.m_y.clone() * n.edge(corner))) } else { f }
    }
}

/// The equation of a turn in floating point: I₀a + m_y z² a v(1+v)/2 + φ a v = δ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rate {
    /// I₀.
    pub(super) inertia: f64,
    /// m_y z².
    pub(super) crush: f64,
    /// φ = σ s μ_k d m_y z.
    pub(super) friction: f64,
    /// κ = m_y/q, by which v = 1/(1 + κa).
    pub(super) softness: f64,
    /// δ = Δ/2q₀: the moment left over at a = 0.
    pub(super) surplus: f64,
    /// Least angular acceleration a, at which the edge begins to be pressed: 0 for P > 0.
    pub(super) least: f64,
}

impl Rate {
    pub(super) fn of(n: &Numbers<f64>, corner: Corner, slip: Option<Slip>, surplus: f64) -> Rate {
        let turn = Turn::about(n, corner, slip);
        let [q0, q1] = n.q;
        Rate {
            inertia: turn.inertia,
            crush: n.m_y * (turn.lever / q0) * (turn.lever / q0),
            friction: turn.friction / q0,
            softness: n.m_y * q1 / q0,
            surplus: surplus / (2.0 * q0),
            least: if n.p > 0.0 { 0.0 } else { -n.p / (n.m_y * n.edge(corner)) },
        }
    }

    /// Left side less right.
    fn excess(&self, a: f64) -> f64 {
        let v = self.share(a);
        a * (self.inertia + self.crush * v * (1.0 + v) / 2.0 + self.friction * v) - self.surplus
    }

    fn slope(&self, a: f64) -> f64 {
        let v = self.share(a);
        self.inertia + self.crush * v * v * v + self.friction * v * v
    }

    /// v = Q(0)/Q(a).
    pub(super) fn share(&self, a: f64) -> f64 {
        1.0 / (1.0 + self.softness * a)
    }

    /// True if the left side rises with a for certain, whatever the rounding: the equation has one root at most.
    pub(super) fn is_monotone(&self) -> bool {
        if self.friction >= 0.0 {
            return true;
        }
        // I₀/v² + m_y z² v has its least value over 0 < v ≤ 1 at v³ = 2I₀/(m_y z²).
        let least = if 2.0 * self.inertia >= self.crush || self.softness == 0.0 {
            self.inertia + self.crush
        } else {
            1.5 * (2.0 * self.inertia * self.crush * self.crush).cbrt()
        };
        -self.friction < 0.999_999 * least
    }

    /// The root above `least` of an equation that is [monotone](Rate::is_monotone); `None` if it has none.
    pub(super) fn root(&self) -> Option<f64> {
        if self.excess(self.least) >= 0.0 {
            return None;
        }
        let (mut low, mut high) = (self.least, f64::INFINITY);
        // Newton's steps as long as they stay between what is known; they come from 0, where the slope is near its mean.
        let mut a = low - self.excess(low) / self.slope(low);
        for _ in 0..200 {
            if !(a > low && a < high) {
                a = if high.is_finite() { low + (high - low) / 2.0 } else { 2.0 * low + self.surplus.abs() };
            }
            let excess = self.excess(a);
            if excess > 0.0 {
                high = a;
            } else {
                low = a;
            }
            let next = a - excess / self.slope(a);
            if (next - a).abs() <= 2.0 * f64::EPSILON * a.abs() {
                return Some(next);
            }
            a = next;
        }
        Some(a)
    }

    /// All roots above `least`, ascending: one or none if the equation is monotone.
    pub(super) fn roots(&self) -> Vec<f64> {
        if self.is_monotone() {
            return self.root().into_iter().collect();
        }
        if self.softness == 0.0 {
            let root = self.surplus / self.slope(0.0);
            return if root > self.least { vec![root] } else { Vec::new() };
        }
        // The slope is a cubic in v; beyond its last zero the left side rises without end.
        let turns = real_roots(&[self.inertia, 0.0, self.friction, self.crush], 0.0, self.share(self.least));
        let mut ends: Vec<f64> = turns.into_iter().rev().map(|v| (1.0 / v - 1.0) / self.softness).collect();
        ends.retain(|end| *end > self.least);
        ends.insert(0, self.least);
        let mut far = ends[ends.len() - 1].max(self.surplus.abs() / self.inertia);
        while self.excess(far) <= 0.0 {
            far = 2.0 * far + f64::MIN_POSITIVE;
        }
        ends.push(far);
        let pairs = ends.windows(2);
        pairs.filter_map(|pair| crate::ground::roots::between(|a| self.excess(a), pair[0], pair[1])).collect()
    }
}
