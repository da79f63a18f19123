//! One step: series, its length, the first condition that fails, and what is booked on the way.

use standfast::{Corner, Mode, Slip};

use super::*;

/// The share of ρ² below which D is about to vanish.
const NEAR: f64 = 0.1;

impl Machine<'_> {
    /// Follows the state to the end of the piece, or to the next event, or as far as one series reaches.
    pub(super) fn advance(&mut self, stop: f64) -> Option<End> {
        self.forcing.channels(self.segment, self.t, ORDER, &mut self.channels);
        let last = self.forcing.stop(self.segment) == f64::INFINITY;
        let limit = stop.min(self.t_max);
        let room = limit - self.t;
        let slip = self.mode.slip().map_or(0.0, Slip::sign);
        let corner = self.mode.corner();
        match corner {
            Some(corner) if slip == 0.0 => {
                rocking(self.block, corner, &self.pose, &self.channels, ORDER, &mut self.motion);
            }
            Some(corner) => {
                slipping(self.block, corner, slip, &self.pose, &self.channels, ORDER, &mut self.motion);
            }
            None if self.mode == Mode::Flight => {
                flying(self.block, &self.pose, &self.channels, ORDER, &mut self.motion);
            }
            None => flat(self.block, slip, &self.pose, &self.channels, ORDER, &mut self.motion),
        }
        let h = self.length(room);
        let failure = self.failure(h);
        if self.mode == Mode::Rest && last && failure.is_none() && h == room {
            self.keep_step(h, self.spent());
            if self.events.last().is_none_or(|event| event.why != Why::Rest) {
                self.say(Why::Rest, Modes::NONE);
                // It rests since the last event, not since the loads ended.
                let since = self.events.iter().rev().nth(1).map_or(self.t, |event| event.t);
                if let Some(event) = self.events.last_mut() {
                    event.t = since;
                }
            }
            return Some(End::AtRest);
        }
        let τ = failure.map_or(h, |(τ, _)| τ);
        let spent = self.spent();
        self.book(τ);
        self.keep_step(τ, spent);
        self.move_by(τ);
        if τ > 0.0 {
            (self.slip_begins, self.begins) = (false, (None, None));
            self.stuck_events = 0;
        }
        match failure {
            None => {
                self.t = if h == room { limit } else { self.t + h };
                None
            }
            Some((_, failure)) => {
                self.t += τ;
                self.stuck_events += 1;
                if self.stuck_events > 100 {
                    return Some(self.ended(Why::NoContinuation, End::NoContinuation));
                }
                self.handle(failure)
            }
        }
    }

    /// Time over which the series may be used.
    fn length(&self, room: f64) -> f64 {
        if self.mode.corner().is_none() && self.mode != Mode::Flight {
            // Polynomials, but for sines.
            return if self.channels.fastest == 0.0 { room } else { room.min(0.25 / self.channels.fastest) };
        }
        let motion = &self.motion;
        let mut h = room;
        let mut within = |size: f64, n: usize| {
            if size > 0.0 && size * h.powi(n as i32) > TOLERANCE {
                h = (TOLERANCE / size).powf(1.0 / n as f64);
            }
        };
        within(motion.θ[ORDER].abs(), ORDER);
        within(motion.θ[ORDER + 1].abs(), ORDER + 1);
        if let Some(slip) = self.mode.slip().filter(|_| self.singular && self.mode.corner().is_some()) {
            // Accelerations grow without bound as D vanishes, and angles say little of rates.
            let inertia = inertia_along(self.block, slip.sign(), 0, motion)[0];
            if inertia.abs() < NEAR * self.block.rho2 {
                within(motion.ω[ORDER].abs() * self.scales.time, ORDER);
            }
        }
        // Levers turn however evenly the body does.
        let lever = if self.mode == Mode::Flight { 1.0 } else { 1.0 / self.scales.length };
        within(lever * motion.c[ORDER].abs().max(motion.h[ORDER].abs()), ORDER);
        if self.mode.slip().is_some() || self.mode == Mode::Flight {
            for series in [&motion.x, &motion.y] {
                within(series[ORDER].abs() / self.scales.length, ORDER);
                within(series[ORDER - 1].abs() / self.scales.length, ORDER - 1);
            }
        }
        h
    }

    /// The first condition of the state that fails within h, and when.
    fn failure(&mut self, h: f64) -> Option<(f64, Failure)> {
        let (block, motion, scales) = (self.block, &self.motion, &self.scales);
        let mut first: Option<(f64, Failure)> = None;
        let mut reach = h;
        // Zeros at the beginning that are exact, so many, are divided out.
        let mut exact = |powers: &[f64], zeros: usize, failure: Failure| {
            if let Some(τ) = first_root(&powers[zeros..], reach) {
                (first, reach) = (Some((τ, failure)), τ);
            }
        };
        let slip = self.mode.slip().map_or(0.0, Slip::sign);
        const N: usize = ORDER;
        let (zero, failed) = self.begins;
        let slip_zeros = |zeros: usize, u: &mut [f64], size: f64| {
            if zeros == 0 {
                return 0;
            }
            let known = if Zero::of_slip(zero, block, self.mode.slip()) { 2 } else { 1 };
            u[..known].fill(0.0);
            known + leading(scales, &u[known..], scales.acceleration + size)
        };
        match (self.mode, self.mode.corner()) {
            (Mode::Flight, _) => {
                for corner in CORNERS {
                    let mut gap = self.gap_in_flight(corner);
                    let mut zeros = 0;
                    if gap[0] == 0.0 {
                        zeros = 1;
                        let made_of = [motion.y[1], block.d * motion.h[1], arm(block, corner) * motion.c[1]];
                        if gap[1].abs() <= 1e-12 * made_of.into_iter().map(f64::abs).sum::<f64>() {
                            // It left the base as its reaction went through zero.
                            let known = if zero == Some(Zero::Normal) { 3 } else { 2 };
                            zeros = known + leading(scales, &gap[known..], scales.acceleration);
                        }
                        gap[..zeros].fill(0.0);
                    }
                    exact(&gap[..=N], zeros, Failure::Meet(corner));
                }
                let quarter = |side: f64| quarter_left(&motion.θ, side);
                exact(&quarter(1.0), 0, Failure::Overturned);
                exact(&quarter(-1.0), 0, Failure::Overturned);
            }
            (mode, None) => {
                let degree = self.channels.degree_flat(N);
                let [x, p, _] = &motion.wrench;
                let size = scales.acceleration + x[0].abs() + p[0].abs();
                let mut margin = |series: &Series, size: f64, failure| {
                    if let Some(from) = after_zeros(scales, &series[..=degree], size) {
                        exact(&series[..=degree], from, failure);
                    }
                };
                if mode == Mode::Rest {
                    for slip in [Slip::Left, Slip::Right] {
                        let cone = combined(&[(block.mu_s, p), (-slip.sign(), x)], degree);
                        margin(&cone, size * (1.0 + block.mu_s), Failure::Rest(Some(Zero::Friction(slip))));
                    }
                }
                let width = size * (block.b1 + block.b2 + block.d);
                let bases = on_base(block, p, &base_moment(block, slip, &motion.wrench, degree), degree);
                for (corner, base) in CORNERS.into_iter().zip(bases) {
                    let rests = mode == Mode::Rest;
                    let reach = Failure::Rest(Some(Zero::Reach(corner)));
                    margin(&base, width, if rests { reach } else { Failure::Tip(corner) });
                }
                margin(p, size, if mode == Mode::Rest { Failure::Rest(None) } else { Failure::Unload });
                if slip != 0.0 {
                    let mut u = motion.vx.map(|v| slip * v);
                    let zeros = usize::from(self.slip_begins);
                    u[..zeros].fill(0.0);
                    // Of slip that begins the first coefficients may be zero but for rounding.
                    let zeros = slip_zeros(zeros, &mut u[..(degree + 2).min(LEN)], size);
                    exact(&u[..(degree + 2).min(LEN)], zeros, Failure::Stop);
                }
            }
            (_, Some(corner)) => {
                let side = turning(corner);
                let mut angle = motion.θ.map(|a| side * a);
                let zeros = match () {
                    () if angle[0] != 0.0 => 0,
                    () if angle[1] != 0.0 => 1,
                    () => {
                        let known = if Zero::of_turn(zero, self.mode, failed) { 3 } else { 2 };
                        known + leading(scales, &angle[known..], 1.0 / (scales.time * scales.time))
                    }
                };
                exact(&angle[..=N], zeros, Failure::Meet(corner.opposite()));
                angle.iter_mut().for_each(|a| *a = -*a);
                angle[0] += std::f64::consts::FRAC_PI_2;
                exact(&angle[..=N], 0, Failure::Overturned);
                let [x, p, m] = &motion.wrench;
                let size = scales.acceleration + x[0].abs() + p[0].abs() + m[0].abs() / scales.length;
                let mut margin = |series: &Series, size: f64, failure| {
                    if let Some(from) = after_zeros(scales, &series[..N - 1], size) {
                        exact(&series[..N - 1], from, failure);
                    }
                };
                margin(&motion.normal, size, Failure::Unload);
                if slip == 0.0 {
                    for slip in [Slip::Left, Slip::Right] {
                        // T against the slip that begins where it is exhausted.
                        let friction = (slip.sign(), &motion.tangential);
                        let cone = combined(&[(block.mu_s, &motion.normal), friction], N - 2);
                        margin(&cone, size * (1.0 + block.mu_s), Failure::Cone(slip));
                    }
                } else {
                    if self.singular {
                        let mut inertia = inertia_along(block, slip, N, motion);
                        // The singularity itself cannot be reached by a series.
                        let sign = inertia[0].signum();
                        inertia.iter_mut().for_each(|a| *a *= sign);
                        inertia[0] -= 1e-9 * block.rho2;
                        exact(&inertia[..=N], 0, Failure::Singular);
                    }
                    let mut u = slip_along(motion, slip);
                    let zeros = usize::from(self.slip_begins);
                    u[..zeros].fill(0.0);
                    let zeros = slip_zeros(zeros, &mut u[..N], size);
                    exact(&u[..N], zeros, Failure::Stop);
                }
            }
        }
        first
    }

    /// The gap of a corner over a step in flight, from the height that is kept of it.
    fn gap_in_flight(&self, corner: Corner) -> Series {
        let mut gap = gap_along(self.block, corner, ORDER, &self.motion);
        gap[0] = self.gaps[corner as usize];
        gap
    }

    /// Books work, losses, the largest rotation and slide over a step.
    pub(super) fn book(&mut self, τ: f64) {
        if self.mode == Mode::Rest || τ == 0.0 {
            return;
        }
        let motion = &self.motion;
        let flat = self.mode.corner().is_none() && self.mode != Mode::Flight;
        let turn = self.channels.turn && !flat;
        let degree = if turn { ORDER } else { self.channels.degree_flat(ORDER) };
        let velocity = if flat { (degree + 1).min(ORDER) } else { ORDER };
        let [x, p, m] = &motion.wrench;
        let mut work = integral(x, degree, &motion.vx, velocity, τ);
        if !flat {
            let mut lift = *p;
            lift[0] -= self.gravity;
            if lift[..=degree].iter().any(|a| *a != 0.0) {
                work -= integral(&lift, degree, &motion.vy, velocity, τ);
            }
            if m[..=degree].iter().any(|a| *a != 0.0) {
                work += integral(m, degree, &motion.ω, velocity, τ);
            }
        }
        self.work += work;
        if let Some(slip) = self.mode.slip() {
            let friction = if flat {
                integral(&motion.normal, degree, &motion.vx, velocity, τ)
            } else {
                integral(&motion.normal, ORDER - 2, &slip_along(motion, 1.0), ORDER - 1, τ)
            };
            self.friction_loss += slip.sign() * self.block.mu_k * friction;
        }
        if !flat {
            self.see_rotation(τ);
        }
        if self.mode == Mode::Flight {
            self.see_flight(τ);
            self.see_gap(τ);
        }
    }

    /// The largest gap of the lower corner within a step in flight: where a gap is largest, or both are as high, or at its end. A motion that
    /// begins in the air falls first, which is no bounce.
    fn see_gap(&mut self, τ: f64) {
        if self.impacts == 0 && self.events.first().is_some_and(|event| event.state == Mode::Flight) {
            return;
        }
        let gaps = CORNERS.map(|corner| gap_along(self.block, corner, ORDER, &self.motion));
        let bound = |gap: &Series| gap.iter().rev().fold(0.0, |bound, a| bound * τ + a.abs());
        if gaps.iter().map(bound).fold(f64::INFINITY, f64::min) <= self.max_gap[0] {
            return;
        }
        let mut see = |at: f64| {
            let [one, other] = gaps.each_ref().map(|gap| value(&gap[..=ORDER], at));
            if one.min(other) > self.max_gap[0] {
                self.max_gap = [one.min(other), self.t + at];
            }
        };
        see(τ);
        for gap in &gaps {
            at_zeros(&derivative(gap)[..ORDER], τ, &mut see);
        }
        at_zeros(&self.motion.θ[..=ORDER + 1], τ, &mut see);
    }

    /// The largest |slide| within a step in flight: where O turns back. In a state of slip it does not; the ends of states are seen apart.
    fn see_flight(&mut self, τ: f64) {
        let (block, motion) = (self.block, &self.motion);
        let r = arm(block, Corner::O);
        let [x, c] = self.feet[Corner::O as usize];
        let mut slide = [0.0; LEN];
        for k in 0..=ORDER {
            // `c` and `h` are sinθ and cosθ there.
            slide[k] = motion.x[k] + (r * motion.h[k] + block.d * motion.c[k]);
        }
        slide[0] = (motion.x[0] - x) + (r * motion.h[0] + block.d * motion.c[0] - c);
        let bound = slide.iter().rev().fold(0.0, |bound, a| bound * τ + a.abs());
        if bound <= self.max_slide[0] {
            return;
        }
        at_zeros(&derivative(&slide)[..ORDER], τ, |at| {
            let size = value(&slide[..=ORDER], at).abs();
            if size > self.max_slide[0] {
                self.max_slide = [size, self.t + at];
            }
        });
    }

    /// The largest |θ| of a step: at its ends, or where ω is zero.
    pub(super) fn see_rotation(&mut self, τ: f64) {
        let (θ, ω) = (&self.motion.θ, &self.motion.ω);
        let mut bound = 0.0;
        for a in θ.iter().rev() {
            bound = bound * τ + a.abs();
        }
        let beyond =
            |block: &Block, corner: Corner, θ: f64| turning(corner) * lever(block, corner, θ)[0] > 0.0;
        if bound <= self.max_theta[0] {
            return;
        }
        let mut see = |at: f64| {
            let size = value(&θ[..=ORDER + 1], at).abs();
            if size > self.max_theta[0] {
                self.max_theta = [size, self.t + at];
            }
        };
        see(τ);
        at_zeros(&ω[..=ORDER], τ, see);
        let [largest, t] = self.max_theta;
        if t >= self.t {
            let at = value(&self.motion.θ[..=ORDER + 1], t - self.t);
            let corner = if at > 0.0 { Corner::O } else { Corner::OPrime };
            self.past_balance |= beyond(self.block, corner, largest.copysign(at));
        }
    }

    /// Work, and what friction and impacts have taken so far.
    pub(super) fn spent(&self) -> [f64; 3] {
        [self.work, self.friction_loss, self.impact_loss]
    }

    pub(super) fn keep_step(&mut self, τ: f64, spent: [f64; 3]) {
        if self.keep.steps {
            let motion = &self.motion;
            self.steps.push(MotionStep {
                t: self.t,
                duration: τ,
                state: self.mode,
                θ: motion.θ,
                ω: motion.ω,
                x: motion.x,
                y: motion.y,
                wrench: motion.wrench,
                spent,
            });
        }
    }

    /// The pose at the end of a step; a corner that touches is put on the base, and in its place if it sticks.
    fn move_by(&mut self, τ: f64) {
        let motion = &self.motion;
        let at = |powers: &Series, n: usize| value(&powers[..=n], τ);
        match (self.mode, self.mode.corner()) {
            (Mode::Rest, _) => {}
            (Mode::Flight, _) => {
                self.gaps = CORNERS.map(|corner| at(&self.gap_in_flight(corner), ORDER).max(0.0));
                self.pose = Pose {
                    x: at(&motion.x, ORDER + 1),
                    y: at(&motion.y, ORDER + 1),
                    θ: at(&motion.θ, ORDER + 1),
                    vx: at(&motion.vx, ORDER),
                    vy: at(&motion.vy, ORDER),
                    ω: at(&motion.ω, ORDER),
                };
            }
            (_, None) => {
                (self.pose.x, self.pose.vx) = (at(&motion.x, LEN - 1), at(&motion.vx, LEN - 1));
            }
            (_, Some(corner)) => {
                let (θ, ω) = (at(&motion.θ, ORDER + 1), at(&motion.ω, ORDER));
                let ([c0, _], [c, h]) =
                    (lever(self.block, corner, self.pose.θ), lever(self.block, corner, θ));
                let (x, vx) = if self.mode.slip().is_some() {
                    (at(&motion.x, ORDER + 1), at(&motion.vx, ORDER))
                } else {
                    (self.pose.x + c0 - c, -h * ω)
                };
                self.pose = Pose { x, vx, θ, ω, y: h, vy: -c * ω };
            }
        }
    }

    fn handle(&mut self, failure: Failure) -> Option<End> {
        let (closed, slip) = self.contact();
        let failed = Some(self.mode);
        let (why, zero) = match failure {
            Failure::Rest(zero) => (Why::Load, zero),
            Failure::Tip(corner) => (Why::Tip, Some(Zero::Reach(corner))),
            Failure::Unload => (Why::Unload, Some(Zero::Normal)),
            Failure::Cone(slip) => (Why::Cone, Some(Zero::Friction(slip))),
            Failure::Singular => {
                self.see_slide();
                let decision = self.decide(Contact { closed, slip, failed, zero: None, jump: false });
                return self.go_on(Why::Grip, decision, slip, closed);
            }
            Failure::Stop => {
                self.pose.vx = match self.mode.corner() {
                    None => 0.0,
                    Some(corner) => -lever(self.block, corner, self.pose.θ)[1] * self.pose.ω,
                };
                self.see_slide();
                let decision = self.decide(Contact { closed, slip: None, failed, zero: None, jump: false });
                return self.go_on(Why::Stop, decision, None, closed);
            }
            Failure::Overturned => {
                self.see_slide();
                return Some(self.ended(Why::Overturned, End::Overturned));
            }
            Failure::Meet(corner) => return self.met(corner),
        };
        self.see_slide();
        let decision = self.decide(Contact { closed, slip, failed, zero, jump: false });
        self.go_on(why, decision, slip, closed)
    }

    /// A corner has met the base.
    fn met(&mut self, corner: Corner) -> Option<End> {
        self.see_slide();
        let landing = self.mode == Mode::Flight;
        let touching = if landing {
            // What rounding makes of a height over this flight.
            let flown = self.t - self.events.last().map_or(self.initial.time, |event| event.t);
            let tiny = 1e-13 * self.scales.length.min(self.scales.acceleration * flown * flown);
            CORNERS.map(|other| other == corner || self.gaps[other as usize] <= tiny)
        } else {
            self.pose.θ = 0.0;
            self.pose.y = self.block.d;
            [true, true]
        };
        let Some(after) = self.meet(touching, landing) else {
            return Some(self.ended(Why::NoContinuation, End::NoContinuation));
        };
        if touching == [true, true] {
            (self.pose.θ, self.pose.y) = (0.0, self.block.d);
        }
        self.bounces += usize::from(after.closed == [false, false]);
        let end = self.go_on_touching(Why::Impact, after.closed, after.slip, false);
        if end.is_some() {
            end
        } else if self.mode == Mode::Flight {
            self.come_down(touching, after.slip)
        } else {
            self.settle()
        }
    }
}

/// u_x of the touching corner times a sign: the order − 1 is its last power.
fn slip_along(motion: &Motion, slip: f64) -> Series {
    let mut u = [0.0; LEN];
    for k in 0..ORDER {
        u[k] = slip * (motion.vx[k] + (k + 1) as f64 * motion.c[k + 1]);
    }
    u
}

/// π/2 − side θ.
fn quarter_left(θ: &Series, side: f64) -> Series {
    let mut left = θ.map(|a| -side * a);
    left[0] += std::f64::consts::FRAC_PI_2;
    left
}

/// Number of first coefficients that are zero up to rounding.
fn leading(scales: &Scales, powers: &[f64], size: f64) -> usize {
    let mut factor = 1.0;
    for (k, a) in powers.iter().enumerate() {
        if (a * factor).abs() > crate::decide::ROUNDING * size {
            return k;
        }
        factor *= scales.time;
    }
    powers.len()
}

/// Power from which the roots of a margin that may begin at zero are to be sought, `None` if it is zero throughout.
fn after_zeros(scales: &Scales, powers: &[f64], size: f64) -> Option<usize> {
    if powers[0] > crate::decide::ROUNDING * size {
        return Some(0);
    }
    match leading(scales, powers, size) {
        all if all == powers.len() => None,
        k => Some(k),
    }
}

/// ∫₀^τ a b dt.
fn integral(a: &Series, degree: usize, b: &Series, other: usize, τ: f64) -> f64 {
    let mut product = [0.0; 2 * LEN];
    for i in 0..=degree {
        for j in 0..=other {
            product[i + j] += a[i] * b[j];
        }
    }
    let top = degree + other;
    let mut sum = 0.0;
    for k in (0..=top).rev() {
        sum = sum * τ + product[k] / (k + 1) as f64;
    }
    sum * τ
}

/// Sees the moments of a step at which a rate is zero: all in turn, each divided out of what follows.
fn at_zeros(rate: &[f64], τ: f64, mut see: impl FnMut(f64)) {
    let mut from = 0.0;
    let mut shifted = rate.to_vec();
    for _ in 0..rate.len() {
        let zeros = usize::from(shifted[0] == 0.0);
        let rest = &mut shifted[zeros..];
        if rest[0] < 0.0 {
            rest.iter_mut().for_each(|a| *a = -*a);
        }
        let Some(root) = first_root(rest, τ - from) else { break };
        see(from + root);
        from += root;
        if from >= τ {
            break;
        }
        shifted = moved(rate, from);
        shifted[0] = 0.0;
    }
}

/// The polynomial about another moment.
fn moved(powers: &[f64], by: f64) -> Vec<f64> {
    let mut about = powers.to_vec();
    for i in 0..about.len() {
        for k in (i..about.len() - 1).rev() {
            about[k] += by * about[k + 1];
        }
    }
    about
}
