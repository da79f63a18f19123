//! A body that rocks, or rests, over a whole piece in which nothing happens: a series as short as the piece is, and one bound that tells that no event is near.
//!
//! Under a record a body rocks over thousands of pieces of 5 ms, of each of which the series converges within half a dozen terms. With δ the rotation
//! over the piece, c and h turn with it, c(θ + δ) = c cosδ + h sinδ, so that no sine of θ is needed. Where a bound does not tell that the state goes on,
//! the general step is taken, with all its terms: so the numbers of a piece hang on the body and the piece alone.
//!
//! ```text
//! θ̈ = (P c − X h + M)/(ρ² + m_x (r² + d²))      c' = h θ̇      h' = −c θ̇      X, P, M lines
//! N = P + m_y ḧ      T = −X − m_x c̈
//! ```

use standfast::Corner;

use super::{CORNERS, Machine, TOLERANCE};
use crate::decide::turning;
use crate::forcing::Lines;
use crate::series::{LEN, Pose, arm, lever};

/// The most powers of the angle that a short series has.
pub(super) const SHORT: usize = 11;

/// A share of each condition that has to be left, so that what a short series leaves out decides nothing.
const CLEAR: f64 = 1e-6;

/// The largest rotation over a piece, rad.
const LITTLE: f64 = 0.06;

/// 1/k.
const INVERSE: [f64; SHORT + 2] = {
    let mut inverse = [0.0; SHORT + 2];
    let mut k = 1;
    while k < SHORT + 2 {
        inverse[k] = 1.0 / k as f64;
        k += 1;
    }
    inverse
};

/// What a body that rocks about a corner is, as far as a short series needs it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rocker {
    /// 1/(ρ² + m (r² + d²)).
    inverse: f64,
    mass: f64,
    friction: f64,
    gravity: f64,
    /// 1/B.
    per_length: f64,
    side: f64,
}

/// Where it is: θ, ω, c, h.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tilt {
    pub θ: f64,
    pub ω: f64,
    pub c: f64,
    pub h: f64,
}

/// A piece over which it has rocked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Glided {
    pub after: Tilt,
    pub work: f64,
    /// A bound on |θ| over the piece.
    pub bound: f64,
    /// Powers of θ from 0 on, of ω, c and h; zero above the last that is needed.
    pub series: [[f64; SHORT + 2]; 4],
}

impl Rocker {
    /// Rocks over a piece of the duration τ; `None` where an event may be near, or the series is too long.
    #[inline]
    pub(super) fn glide(&self, before: Tilt, [x, p, m]: Lines, τ: f64) -> Option<Glided> {
        let [mut θ, mut ω, mut c, mut h] = [[0.0; SHORT + 2]; 4];
        (θ[0], θ[1], ω[0], c[0], h[0]) = (before.θ, before.ω, before.ω, before.c, before.h);
        // The sizes of what comes after the first terms: of θ, and of N and T over the masses.
        let (mut turn, mut lift, mut push) = ((before.ω * τ).abs(), 0.0, 0.0);
        let (mut power, mut last) = (1.0, 0);
        for k in 0..SHORT - 1 {
            let (mut next_c, mut next_h) = (0.0, 0.0);
            for j in 0..=k {
                next_c += h[j] * ω[k - j];
                next_h -= c[j] * ω[k - j];
            }
            (c[k + 1], h[k + 1]) = (next_c * INVERSE[k + 1], next_h * INVERSE[k + 1]);
            let mut α = p[0] * c[k] - x[0] * h[k];
            match k {
                0 => α += m[0],
                1 => α += m[1] + p[1] * c[0] - x[1] * h[0],
                _ => α += p[1] * c[k - 1] - x[1] * h[k - 1],
            }
            ω[k + 1] = α * self.inverse * INVERSE[k + 1];
            θ[k + 2] = ω[k + 1] * INVERSE[k + 2];
            // `power` is τ^k.
            let term = (θ[k + 2] * (power * τ * τ)).abs();
            turn += term;
            let before = (θ[k + 1] * (power * τ)).abs();
            power *= τ;
            let levers = (c[k + 1].abs() + h[k + 1].abs()) * power * self.per_length;
            if k >= 2 && term <= TOLERANCE && before <= TOLERANCE && levers <= TOLERANCE {
                last = k + 1;
                break;
            }
        }
        // `last` is the last power of ω, c and h.
        if last == 0 || turn > LITTLE {
            return None;
        }
        let mut power = 1.0;
        for k in 1..last - 1 {
            power *= τ;
            let twice = ((k + 1) * (k + 2)) as f64 * power;
            (lift, push) = (lift + (h[k + 2] * twice).abs(), push + (c[k + 2] * twice).abs());
        }
        let [normal, tangential] = [p[0] + self.mass * 2.0 * h[2], -x[0] - self.mass * 2.0 * c[2]];
        let least = normal - (p[1] * τ).abs() - self.mass * lift;
        let most = tangential.abs() + (x[1] * τ).abs() + self.mass * push;
        let size = CLEAR * (self.gravity + x[0].abs() + p[0].abs());
        let bound = before.θ.abs() + turn;
        let upright = self.side * before.θ - turn;
        if !(least > size && self.friction * least - most > size && upright > CLEAR && bound < 1.5) {
            return None;
        }
        // ∫ X ẋ − (P − g) ẏ + M θ̇, with x = −c and y = h of a corner that stays.
        let (mut along, mut up, mut around) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        for k in (1..=last).rev() {
            let share = k as f64 * INVERSE[k + 1];
            along = [along[0] * τ + c[k], along[1] * τ + share * c[k]];
            up = [up[0] * τ + h[k], up[1] * τ + share * h[k]];
            around = [around[0] * τ + θ[k], around[1] * τ + share * θ[k]];
        }
        let of = |[whole, share]: [f64; 2], value: f64, slope: f64| τ * (value * whole + slope * τ * share);
        let work = of(around, m[0], m[1]) - of(along, x[0], x[1]) - of(up, p[0] - self.gravity, p[1]);
        let rate = ω[..=last].iter().rev().fold(0.0, |sum, a| sum * τ + a);
        let δ = τ * θ[1..=last + 1].iter().rev().fold(0.0, |sum, a| sum * τ + a);
        let square = δ * δ;
        let sin =
            δ * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))));
        let versine = square / 2.0
            * (1.0 - square / 12.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0 * (1.0 - square / 90.0))));
        let after = Tilt {
            θ: before.θ + δ,
            ω: rate,
            c: before.c + (before.h * sin - before.c * versine),
            h: before.h - (before.c * sin + before.h * versine),
        };
        Some(Glided { after, work, bound, series: [θ, ω, c, h] })
    }
}

impl Machine<'_> {
    /// Rocks over a whole piece, if nothing happens in it that could be missed; false if the general step is to be taken.
    pub(super) fn glide(&mut self, corner: Corner, stop: f64) -> bool {
        let begins = self.slip_begins || self.begins != (None, None);
        let heavier = self.block.m_x != self.block.m_y;
        if begins || heavier || self.mode.slip().is_some() || stop > self.t_max {
            return false;
        }
        let Some(lines) = self.forcing.lines(self.segment, self.t) else { return false };
        let Pose { x, θ, ω, .. } = self.pose;
        let [c, h] = self.levers(corner);
        let rocker = self.rockers[corner as usize];
        let τ = stop - self.t;
        let Some(glided) = rocker.glide(Tilt { θ, ω, c, h }, lines, τ) else { return false };
        let Glided { after, work, bound, .. } = glided;
        if self.keep.steps || bound > self.max_theta[0] {
            self.put(corner, lines, &glided);
            let spent = self.spent();
            if bound > self.max_theta[0] {
                self.see_rotation(τ);
            }
            self.keep_step(τ, spent);
        }
        self.work += work;
        let Tilt { θ, ω, c: lever, h } = after;
        self.pose = Pose { x: x + c - lever, vx: -h * ω, θ, ω, y: h, vy: -lever * ω };
        self.known_levers = Some((corner, θ, [lever, h]));
        self.t = stop;
        self.stuck_events = 0;
        true
    }

    /// Rests over a whole piece, if all that rest needs is clearly there at both of its ends, and so between them; false if the general step is to be
    /// taken.
    pub(super) fn rests(&mut self, stop: f64) -> bool {
        if self.keep.steps || stop > self.t_max || stop == f64::INFINITY {
            return false;
        }
        let Some([x, p, m]) = self.forcing.lines(self.segment, self.t) else { return false };
        let block = self.block;
        let τ = stop - self.t;
        let clear = |x: f64, p: f64, m: f64| {
            let size = CLEAR * (self.gravity + x.abs() + p.abs() + m.abs() * self.rockers[0].per_length);
            let moment = block.d * x - m;
            let width = size * (block.b1 + block.b2 + block.d);
            p > size
                && block.mu_s * p - x.abs() > size * (1.0 + block.mu_s)
                && block.b1 * p + moment > width
                && block.b2 * p - moment > width
        };
        let rests = clear(x[0], p[0], m[0]) && clear(x[0] + x[1] * τ, p[0] + p[1] * τ, m[0] + m[1] * τ);
        if rests {
            (self.t, self.stuck_events) = (stop, 0);
            (self.slip_begins, self.begins) = (false, (None, None));
        }
        rests
    }

    /// c and h of the corner at the pose, as the last piece has left them or from its angle.
    pub(super) fn levers(&self, corner: Corner) -> [f64; 2] {
        match self.known_levers {
            Some((of, at, levers)) if of == corner && at == self.pose.θ => levers,
            _ => lever(self.block, corner, self.pose.θ),
        }
    }

    /// Puts a short series in the place of the general one.
    fn put(&mut self, corner: Corner, [x, p, m]: Lines, glided: &Glided) {
        let block = self.block;
        let motion = &mut self.motion;
        let [θ, ω, c, h] = &glided.series;
        let long = |short: &[f64; SHORT + 2]| {
            let mut long = [0.0; LEN];
            long[..SHORT + 2].copy_from_slice(short);
            long
        };
        (motion.θ, motion.ω, motion.c, motion.h) = (long(θ), long(ω), long(c), long(h));
        for (wrench, line) in motion.wrench.iter_mut().zip([x, p, m]) {
            *wrench = [0.0; LEN];
            wrench[..2].copy_from_slice(&line);
        }
        (motion.x, motion.y) = (motion.c.map(|a| -a), motion.h);
        motion.x[0] = self.pose.x;
        debug_assert!((motion.y[0] - self.pose.y).abs() < 1e-9 * arm(block, corner).abs().max(block.d));
        for k in 0..LEN - 1 {
            (motion.vx[k], motion.vy[k]) =
                ((k + 1) as f64 * motion.x[k + 1], (k + 1) as f64 * motion.y[k + 1]);
        }
        (motion.vx[LEN - 1], motion.vy[LEN - 1]) = (0.0, 0.0);
    }

    /// What a short series needs of the body, of each corner.
    pub(super) fn rockers(block: &standfast::contact::Block, gravity: f64) -> [Rocker; 2] {
        CORNERS.map(|corner| {
            let r = arm(block, corner);
            Rocker {
                inverse: 1.0 / (block.rho2 + block.m_x * (r * r + block.d * block.d)),
                mass: block.m_x,
                friction: block.mu_s,
                gravity,
                per_length: 1.0 / block.b1.max(block.b2),
                side: turning(corner),
            }
        })
    }
}
