//! Impacts that follow each other ever faster: an infinite number of them in a finite time, whose end is known in closed form.

use standfast::Mode;

use super::*;

/// A sequence whose remaining time is longer than this share of √(B/g) is followed impact by impact.
const SHORT: f64 = 1e-5;

/// A tail of motion whose energy is less than this share of what its supports can take is left.
const LITTLE: f64 = 1e-10;

/// Below this share of g B the energy of a rotation is that of rounding errors.
const NOTHING: f64 = 1e-26;

/// One flight of a sequence between two impacts.
#[derive(Clone, Copy)]
struct Bounce {
    corner: Corner,
    /// θ̇ at its beginning.
    rate: f64,
    /// θ̈, towards the base.
    α: f64,
}

impl Bounce {
    fn duration(&self) -> f64 {
        2.0 * (self.rate / self.α).abs()
    }
}

impl Machine<'_> {
    /// After an impact: ends the sequence that has begun, if its end is near.
    pub(super) fn settle(&mut self) -> Option<End> {
        let corner = self.mode.corner()?;
        if self.pose.θ != 0.0 || self.pose.ω == 0.0 {
            return None;
        }
        match self.remaining(corner) {
            Some(τ) if τ < SHORT * self.scales.time => self.close(τ),
            Some(_) => None,
            None if self.left_to_rest() => None,
            None if self.is_over() => self.close(0.0),
            None => None,
        }
    }

    /// The time a sequence of impacts still takes; `None` if it is none that ends.
    fn remaining(&self, corner: Corner) -> Option<f64> {
        let slip = self.mode.slip();
        if slip.is_some() && self.law.μ != self.block.mu_k {
            return None;
        }
        let first = self.bounce(corner, self.pose.ω)?;
        let second = self.next(&first)?;
        let third = self.next(&second)?;
        let q = (third.rate / first.rate).abs();
        (q < 1.0).then(|| (first.duration() + second.duration()) / (1.0 - q))
    }

    /// A small turn about a corner under the loads of this moment, if it leads back to the base.
    fn bounce(&self, corner: Corner, rate: f64) -> Option<Bounce> {
        let Block { d, rho2, m_x, m_y, mu_s, mu_k, .. } = *self.block;
        let (r, [x, p, m]) = (arm(self.block, corner), self.channels.wrench(0.0));
        let (α, holds) = match self.mode.slip() {
            None => {
                let α = (p * r - x * d + m) / (rho2 + m_x * d * d + m_y * r * r);
                let (normal, tangential) = (p - m_y * r * α, -x - m_x * d * α);
                (α, normal >= 0.0 && tangential.abs() <= mu_s * normal)
            }
            Some(slip) => {
                let c = r - slip.sign() * mu_k * d;
                let inertia = rho2 + m_y * r * c;
                let α = (p * c + m) / inertia;
                (α, inertia > 0.0 && p - m_y * r * α >= 0.0)
            }
        };
        (holds && α * rate < 0.0).then_some(Bounce { corner, rate, α })
    }

    /// The turn after the impact that ends one.
    fn next(&self, bounce: &Bounce) -> Option<Bounce> {
        let slip = self.mode.slip();
        let r = arm(self.block, bounce.corner);
        let u = if slip.is_some() { self.pose.vx + self.block.d * self.pose.ω } else { 0.0 };
        let ω = -bounce.rate;
        let before = Pose { θ: 0.0, ω, vx: u - self.block.d * ω, vy: -r * ω, ..self.pose };
        let after = self.law.after(self.block, &before, [true, true], false)?;
        let corner = bounce.corner.opposite();
        let about =
            after.closed == CORNERS.map(|other| other == corner) && after.slip == slip && after.pose.ω != 0.0;
        if about { self.bounce(corner, after.pose.ω) } else { None }
    }

    /// Jumps to the end of the sequence.
    fn close(&mut self, τ: f64) -> Option<End> {
        let [x, p, _] = self.channels.wrench(0.0);
        let Block { d, m_x, m_y, mu_k, .. } = *self.block;
        let before = kinetic(self.block, &self.pose);
        let mut τ = τ;
        let slip = self.mode.slip();
        let mut along = None;
        match slip {
            None => self.pose.vx = 0.0,
            Some(slip) => {
                let s = slip.sign();
                let u = self.pose.vx + d * self.pose.ω;
                let end = self.pose.vx + (x * τ - s * mu_k * (p * τ - m_y * self.pose.vy)) / m_x;
                let (end, share) = if s * end > 0.0 { (end, 1.0) } else { (0.0, u / (u - end)) };
                τ *= share;
                let mean = 0.5 * (u + end);
                self.pose.x += mean * τ;
                self.friction_loss += s * mu_k * (p * τ - m_y * self.pose.vy) * mean;
                self.work += x * mean * τ;
                self.impact_loss += (x * τ - s * mu_k * (p * τ - m_y * self.pose.vy)) * mean;
                self.pose.vx = end;
                along = (end != 0.0).then_some(slip);
            }
        }
        (self.pose.ω, self.pose.vy) = (0.0, 0.0);
        // The rest of the energy goes into the impacts; the work of friction and loads on the way is booked above.
        self.impact_loss += before - kinetic(self.block, &self.pose);
        self.t += τ;
        while self.t >= self.forcing.stop(self.segment) {
            self.segment += 1;
        }
        let decision =
            self.decide(Contact { closed: [true, true], slip: along, failed: None, zero: None, jump: true });
        self.go_on(Why::Settle, decision, along, [true, true])
    }

    /// Chatter within chatter has no closed form. Where so little motion is left that the supports could stop it a hundred times over, it
    /// is left.
    fn left_to_rest(&mut self) -> bool {
        let [x, p, m] = self.channels.wrench(0.0);
        let Block { b1, b2, d, mu_k, .. } = *self.block;
        let b = self.scales.length;
        let margins = [mu_k * p - x.abs(), (b1 * p + x * d - m) / b, (b2 * p - x * d + m) / b];
        let margin = margins.into_iter().fold(f64::INFINITY, f64::min);
        let energy = kinetic(self.block, &self.pose);
        if !(margin > 0.0 && energy < LITTLE * margin * b) {
            return false;
        }
        self.impact_loss += energy;
        self.pose = Pose { vx: 0.0, vy: 0.0, ω: 0.0, ..self.pose };
        self.t_rest_is_bound = true;
        self.take(Mode::Rest, false);
        self.say(Why::Settle, Modes::NONE);
        true
    }

    /// True if so little rotation is left that it is rounding.
    fn is_over(&self) -> bool {
        let Block { rho2, m_y, .. } = *self.block;
        let energy = m_y * self.pose.vy * self.pose.vy + rho2 * self.pose.ω * self.pose.ω;
        energy < NOTHING * self.scales.acceleration * self.scales.length
    }
}
