//! Impacts that follow each other ever faster: an infinite number of them in a finite time, whose end is known in closed form.

use standfast::{Corner, Mode, Slip};

use super::*;
use crate::problem::Impact;

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
        self.go_on_touching(Why::Settle, [true, true], along, true)
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

/// A sequence of bounces whose remaining time is longer than this share of √(B/g) is followed bounce by bounce.
const BRIEF: f64 = 1e-6;
/// An angle, or a slip in B over √(B/g), that is next to none; and a slip that is none.
const NEARLY: f64 = 1e-6;
const NONE: f64 = 1e-12;
/// Below this share of g B the energy of what bounces at both corners is left.
const CHATTER: f64 = 1e-15;
/// The same of a body that slips with a friction of impacts which is not that of slip: how they share the impulse is not known.
const MIXED_CHATTER: f64 = 1e-18;
/// Below this share of g B it is left whatever goes on.
const ENDED: f64 = 1e-24;

/// A corner that lands within this share of √(B/g) after the other does so as good as with it, and a velocity in B over √(B/g) below which that is of
/// no account.
const AT_ONCE: f64 = 1e-3;

impl Machine<'_> {
    /// Counts impacts with a rebound of which only stiffness decides what becomes of them.
    pub(super) fn see_rebound(
        &mut self,
        before: &Pose,
        after: &ImpactState,
        touching: [bool; 2],
        landing: bool,
    ) {
        let is_given = matches!(self.law.law, Impact::Poisson | Impact::Energetic) || landing;
        if self.law.e == 0.0 || !is_given {
            return;
        }
        let up = CORNERS.map(|corner| velocity(self.block, corner, before)[1]);
        let speed = AT_ONCE * self.scales.length / self.scales.time;
        let is_fast = (0..2).any(|i| touching[i] && up[i] < -speed);
        let both = touching == [true, true];
        // Rocking onto a corner that lifts the other one is an impact at that corner alone.
        let lifts = || {
            let Block { d, rho2, m_x, m_y, .. } = *self.block;
            let [one, other] =
                if up[0] < up[1] { [Corner::O, Corner::OPrime] } else { [Corner::OPrime, Corner::O] };
            let (c, across) = (arm(self.block, one), arm(self.block, other));
            let by = 1.0 / m_y + c * across / rho2;
            match after.slip {
                None => by - c * across * d * d / (rho2 * rho2 * (1.0 / m_x + d * d / rho2)) > 0.0,
                Some(slip) => by - slip.sign() * self.law.μ * across * d / rho2 > 0.0,
            }
        };
        let follows = |corner: Corner| {
            self.landing.is_some_and(|(t, first)| first != corner && self.t - t < AT_ONCE * self.scales.time)
        };
        let corner = if touching[0] { Corner::O } else { Corner::OPrime };
        let is_one = if both { landing || !lifts() } else { follows(corner) };
        if is_fast && is_one {
            if self.undetermined.0 == 0 {
                self.undetermined.1 = self.t;
            }
            self.undetermined.0 += 1;
        }
        if is_fast && !both {
            self.landing = Some((self.t, corner));
        }
    }

    /// After an impact that ends in flight: ends the sequence of bounces that has begun, if its end is near. `slip` is that of the impact.
    pub(super) fn come_down(&mut self, touching: [bool; 2], slip: Option<Slip>) -> Option<End> {
        if self.law.e >= 1.0 {
            return None;
        }
        let is_flat = self.bounces_flat(touching);
        if !is_flat && let Some(flat) = self.flat() {
            return self.flatten(flat);
        }
        let τ = self.bouncing(touching, slip)?;
        self.landed(τ, touching, slip)
    }

    /// The time that a sequence of bounces on these corners still takes, if it is short; `None` of one that is followed on.
    fn bouncing(&self, touching: [bool; 2], slip: Option<Slip>) -> Option<f64> {
        let Block { m_y, rho2, .. } = *self.block;
        let [_, p, m] = self.channels.wrench(self.pose.θ);
        let is_flat = self.bounces_flat(touching);
        let falls = |corner: Corner| {
            let [c, h] = lever(self.block, corner, self.pose.θ);
            p / m_y - c * m / rho2 - h * self.pose.ω * self.pose.ω
        };
        let rises = |corner: Corner| velocity(self.block, corner, &self.pose)[1];
        let one = self.bouncing_of(touching);
        let (u, a) = if is_flat { (self.pose.vy, p / m_y) } else { (rises(one), falls(one)) };
        let τ = 2.0 * u / (a * (1.0 - self.law.e));
        let is_short = a > 0.0 && u > 0.0 && τ < BRIEF * self.scales.time;
        if !is_short || self.t + τ >= self.forcing.stop(self.segment).min(self.t_max) {
            return None;
        }
        if !is_flat {
            let other = one.opposite();
            let gap = self.gaps[other as usize];
            let (up, down) = (rises(other), falls(other).abs());
            let stays_open = if up > 0.0 { up > down * τ } else { gap + 2.0 * τ * (up - down * τ) > 0.0 };
            if !stays_open {
                return None;
            }
        }
        // The next bounce slips as this one did, or sticks as it did; so do all that follow.
        let before = self.fallen(2.0 * u / a)?;
        let on = if is_flat { touching } else { CORNERS.map(|corner| corner == one) };
        let next = self.law.after(self.block, &before, on, true)?;
        (next.slip == slip && next.closed == [false, false]).then_some(τ)
    }

    /// True if the body bounces on both corners at once, upright.
    fn bounces_flat(&self, touching: [bool; 2]) -> bool {
        touching == [true, true] && self.pose.θ == 0.0 && self.pose.ω == 0.0
    }

    /// Of corners that touch the one that bounces.
    fn bouncing_of(&self, touching: [bool; 2]) -> Corner {
        let rises = CORNERS.map(|corner| velocity(self.block, corner, &self.pose)[1]);
        match touching {
            [true, true] if rises[0] < rises[1] => Corner::O,
            [true, true] => Corner::OPrime,
            [first, _] => CORNERS[usize::from(!first)],
        }
    }

    /// The pose after a free flight, which is short.
    fn fallen(&self, τ: f64) -> Option<Pose> {
        let mut channels = Channels::EMPTY;
        self.forcing.channels(self.segment, self.t, ORDER, &mut channels);
        let mut motion = Motion::EMPTY;
        flying(self.block, &self.pose, &channels, ORDER, &mut motion);
        let at = |powers: &Series, n: usize| value(&powers[..=n], τ);
        let pose = Pose {
            x: at(&motion.x, ORDER),
            y: at(&motion.y, ORDER),
            θ: at(&motion.θ, ORDER),
            vx: at(&motion.vx, ORDER - 1),
            vy: at(&motion.vy, ORDER - 1),
            ω: at(&motion.ω, ORDER - 1),
        };
        pose.y.is_finite().then_some(pose)
    }

    /// Jumps to the end of a sequence of bounces: free flight over its time, and one impact without rebound.
    fn landed(&mut self, τ: f64, touching: [bool; 2], slip: Option<Slip>) -> Option<End> {
        let is_flat = self.bounces_flat(touching);
        let one = self.bouncing_of(touching);
        let on = if is_flat { touching } else { CORNERS.map(|corner| corner == one) };
        let mut before = self.fallen(τ)?;
        if is_flat {
            (before.θ, before.ω, before.y) = (0.0, 0.0, self.block.d);
        }
        // What slipped all the way slips on, and what stuck sticks.
        let after = self.law.inelastic(self.block, &before, on);
        let after = after.filter(|after| after.slip == slip && after.closed == on)?;
        // The impulses came one by one, e/(1 + e) of the time before the end in the mean.
        let ahead = τ * self.law.e / (1.0 + self.law.e);
        let mut settled = after.pose;
        settled.x += (settled.vx - before.vx) * ahead;
        if !is_flat {
            settled.θ += (settled.ω - before.ω) * ahead;
            settled.y = lever(self.block, one, settled.θ)[1];
        }
        let (block, gravity) = (self.block, self.gravity);
        let energy = |pose: &Pose| kinetic(block, pose) + gravity * pose.y;
        let had = energy(&self.pose);
        self.forcing.channels(self.segment, self.t, ORDER, &mut self.channels);
        flying(block, &self.pose, &self.channels, ORDER, &mut self.motion);
        let work = self.work;
        self.book(τ);
        self.impact_loss += had + (self.work - work) - energy(&settled);
        self.pose = settled;
        self.t += τ;
        self.go_on_touching(Why::Settle, after.closed, after.slip, false)
    }

    /// The slip with which a body goes on flat of which next to nothing bounces, at both corners in no order that has a closed form; `None` of
    /// one that is followed on.
    fn flat(&self) -> Option<Option<Slip>> {
        let [x, p, m] = self.channels.wrench(0.0);
        let Block { b1, b2, d, rho2, m_y, mu_s, mu_k, .. } = *self.block;
        let Pose { vx, vy, θ, ω, .. } = self.pose;
        let Scales { time, length, acceleration } = self.scales;
        let height = (b2 * self.gaps[0] + b1 * self.gaps[1]) / (b1 + b2);
        let energy = 0.5 * m_y * vy * vy + 0.5 * rho2 * ω * ω + p * height;
        let is_below = |share: f64| energy < share * acceleration * length;
        if !(p > 0.0 && is_below(CHATTER) && θ.abs() < NEARLY) {
            return None;
        }
        let (along, speed) = (vx + d * ω, length / time);
        let inside = |moment: f64| b1 * p + moment > 0.0 && b2 * p - moment > 0.0;
        let is_slow = along.abs() < NEARLY * speed;
        let is_over = is_below(ENDED);
        let rests = is_slow && mu_s.min(mu_k) * p > x.abs() && inside(x * d - m);
        if rests || (is_over && along.abs() < NONE * speed) {
            return Some(None);
        }
        let slip = if along > 0.0 { Slip::Right } else { Slip::Left };
        let is_known = self.law.μ == mu_k || is_below(MIXED_CHATTER);
        let slides = !is_slow && is_known && inside(slip.sign() * mu_k * d * p - m);
        (slides || is_over).then_some(Some(slip))
    }

    /// Puts the body flat, to rest or to slide on.
    fn flatten(&mut self, slip: Option<Slip>) -> Option<End> {
        let Block { d, m_x, m_y, mu_k, .. } = *self.block;
        let had = kinetic(self.block, &self.pose) + self.gravity * self.pose.y;
        let vx = match slip {
            None => 0.0,
            // Friction's impulse up to any later time, whatever the impacts do.
            Some(slip) => self.pose.vx + slip.sign() * mu_k * m_y / m_x * self.pose.vy,
        };
        let slip = slip.filter(|slip| slip.sign() * vx > 0.0);
        let vx = if slip.is_some() { vx } else { 0.0 };
        self.t_rest_is_bound = true;
        self.pose = Pose { θ: 0.0, ω: 0.0, y: d, vx, vy: 0.0, ..self.pose };
        self.impact_loss += had - kinetic(self.block, &self.pose) - self.gravity * d;
        self.go_on_touching(Why::Settle, [true, true], slip, true)
    }
}
