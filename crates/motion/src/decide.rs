//! States that can go on from a moment: those whose conditions hold just after it.
//!
//! A condition that holds with equality at the moment is decided by the first of its derivatives that is not zero, along the motion of
//! the state in question.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use standfast::contact::{Block, solve};
use standfast::{Corner, Mode, Modes, Slip, Wrench};

use crate::forcing::Channels;
use crate::impact::CORNERS;
use crate::series::{Motion, Pose, Series, flat, flying, gap_along, rocking, slipping, slipping_inertia};

/// The order of the series that decide: derivatives up to the third of a force.
pub(crate) const DECIDING: usize = 5;

/// Quantity that is exactly zero at the moment because a condition has just failed, whatever rounding makes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Zero {
    /// Friction's margin against slip in this direction.
    Friction(Slip),
    /// The reaction's distance from this corner.
    Reach(Corner),
    /// The reaction.
    Normal,
}

impl Zero {
    /// True if the slip of a state begins with no acceleration.
    pub(crate) fn of_slip(zero: Option<Zero>, block: &Block, slip: Option<Slip>) -> bool {
        block.mu_s == block.mu_k && slip.is_some_and(|slip| zero == Some(Zero::Friction(slip)))
    }

    /// True if the rotation of a state begins with no acceleration: it went on without one before.
    pub(crate) fn of_turn(zero: Option<Zero>, mode: Mode, failed: Option<Mode>) -> bool {
        let same = match failed {
            Some(Mode::Rest) => mode.slip().is_none(),
            Some(failed) => failed.corner().is_none() && failed.slip() == mode.slip(),
            None => false,
        };
        same && mode.corner().is_some_and(|corner| zero == Some(Zero::Reach(corner)))
    }
}

/// State of the contact at the moment.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    /// Corners that touch and do not move up: O, O'. Both: θ = θ̇ = 0.
    pub closed: [bool; 2],
    /// The direction in which they slip; `None` if u_x = 0.
    pub slip: Option<Slip>,
    /// The state that has just failed, and what is zero for that.
    pub failed: Option<Mode>,
    pub zero: Option<Zero>,
    /// True if a load jumps: then a body at rest begins as the contact problem says.
    pub jump: bool,
}

/// The states that satisfy all conditions, and the one that goes on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Decision {
    pub mode: Option<Mode>,
    pub modes: Modes,
}

/// Scales that tell a rounding error from a number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scales {
    /// √(B/g).
    pub time: f64,
    /// B, the larger of b₁ and b₂.
    pub length: f64,
    /// g.
    pub acceleration: f64,
}

/// A share of what a condition is made of below which it counts as zero.
pub(crate) const ROUNDING: f64 = 1e-12;

impl Scales {
    /// The sign just after the moment.
    pub(crate) fn sign(&self, powers: &[f64], size: f64) -> Ordering {
        let mut factor = 1.0;
        for a in powers {
            let scaled = a * factor;
            if scaled.abs() > ROUNDING * size {
                return if scaled > 0.0 { Greater } else { Less };
            }
            factor *= self.time;
        }
        Equal
    }
}

/// a·X + b·P + c·M and the like, for the first coefficients.
pub(crate) fn combined(parts: &[(f64, &Series)], n: usize) -> Series {
    let mut sum = [0.0; crate::series::LEN];
    for (factor, series) in parts {
        for k in 0..=n {
            sum[k] += factor * series[k];
        }
    }
    sum
}

/// b₁P + moment and b₂P − moment: how far the reaction is from both corners, for moment = Nξ.
pub(crate) fn on_base(block: &Block, p: &Series, moment: &Series, n: usize) -> [Series; 2] {
    [combined(&[(block.b1, p), (1.0, moment)], n), combined(&[(block.b2, p), (-1.0, moment)], n)]
}

/// Nξ of a base that rests (slip 0) or slides.
pub(crate) fn base_moment(block: &Block, slip: f64, wrench: &[Series; 3], n: usize) -> Series {
    let [x, p, m] = wrench;
    if slip == 0.0 {
        combined(&[(block.d, x), (-1.0, m)], n)
    } else {
        combined(&[(slip * block.mu_k * block.d, p), (-1.0, m)], n)
    }
}

/// Finds the states that can go on.
pub(crate) struct Decider<'a> {
    pub block: &'a Block,
    pub scales: Scales,
    pub channels: &'a Channels,
    pub pose: Pose,
    pub contact: Contact,
    /// Room for the series of what is tried.
    pub motion: &'a mut Motion,
}

impl Decider<'_> {
    pub(crate) fn decide(&mut self) -> Decision {
        let Contact { closed, slip, failed, .. } = self.contact;
        let mut modes = Modes::NONE;
        for mode in self.tried() {
            if Some(mode) != failed && self.holds(mode) {
                modes.insert(mode);
            }
        }
        if slip.is_none() && self.block.mu_s > self.block.mu_k {
            // Slip at a corner counts only where that corner cannot stick.
            let stick = modes;
            for corner in CORNERS {
                if stick.contains(Mode::Rest) || stick.contains(Mode::rock(corner)) {
                    modes.remove(Mode::slide_rock(corner, Slip::Left));
                    modes.remove(Mode::slide_rock(corner, Slip::Right));
                }
                if stick.contains(Mode::rock(corner)) {
                    modes.remove(Mode::SlideLeft);
                    modes.remove(Mode::SlideRight);
                }
            }
        }
        let mut mode = self.first(modes);
        if self.contact.jump && closed == [true, true] && slip.is_none() && mode != Some(Mode::Rest) {
            let [x, p, m] = self.channels.wrench(0.0);
            // Exactly, for the numbers at this moment; what it calls rest may still be left at once.
            let exact = solve(self.block, &Wrench { x, p, m }).ok();
            if let Some(first) =
                exact.and_then(|solution| solution.mode()).filter(|mode| modes.contains(*mode))
            {
                mode = Some(first);
            }
        }
        Decision { mode, modes }
    }

    /// The states that fit the closed corners and the slip.
    fn tried(&self) -> Vec<Mode> {
        let Contact { closed, slip, .. } = self.contact;
        let slips: &[Slip] = match slip {
            None => &[Slip::Left, Slip::Right],
            Some(Slip::Left) => &[Slip::Left],
            Some(Slip::Right) => &[Slip::Right],
        };
        let mut tried = Vec::with_capacity(10);
        if closed == [true, true] {
            if slip.is_none() {
                tried.push(Mode::Rest);
            }
            tried.extend(slips.iter().map(|slip| Mode::slide(*slip)));
        }
        for (corner, _) in CORNERS.into_iter().zip(closed).filter(|(_, closed)| *closed) {
            if slip.is_none() {
                tried.push(Mode::rock(corner));
            }
            tried.extend(slips.iter().map(|slip| Mode::slide_rock(corner, *slip)));
        }
        tried.push(Mode::Flight);
        tried
    }

    /// The first in the order of the contact problem.
    fn first(&self, modes: Modes) -> Option<Mode> {
        let regular = |mode: Mode| match (mode.corner(), mode.slip()) {
            (Some(corner), Some(slip)) => {
                slipping_inertia(self.block, corner, slip.sign(), self.pose.θ) > 0.0
            }
            _ => false,
        };
        let rank = |mode: &Mode| match mode {
            Mode::Rest => 0,
            Mode::SlideLeft | Mode::SlideRight => 1,
            mode if mode.corner().is_some() && mode.slip().is_some() => {
                if regular(*mode) {
                    2
                } else {
                    4
                }
            }
            Mode::Flight => 5,
            _ => 3,
        };
        modes.iter().min_by_key(rank)
    }

    /// True if a state satisfies its conditions just after the moment.
    fn holds(&mut self, mode: Mode) -> bool {
        // Mostly the first of what may be zero is not.
        let mut is_open = false;
        let holds = self.holds_to(mode, 2, &mut is_open);
        if is_open { self.holds_to(mode, DECIDING, &mut is_open) } else { holds }
    }

    /// The same by the derivatives to an order; open where what they say is zero.
    fn holds_to(&mut self, mode: Mode, n: usize, is_open: &mut bool) -> bool {
        let (block, scales) = (self.block, &self.scales);
        let is_open = std::cell::Cell::from_mut(is_open);
        let sign = |powers: &[f64], size: f64| {
            let sign = scales.sign(powers, size);
            is_open.set(is_open.get() || sign == Equal);
            sign
        };
        let motion = &mut *self.motion;
        let at_rest = self.contact.slip.is_none();
        let flat_before = self.contact.closed == [true, true];
        let force = |powers: &Series, size: f64| sign(&powers[..=n - 2], size);
        let slip = mode.slip().map_or(0.0, Slip::sign);
        match (mode, mode.corner()) {
            (Mode::Flight, _) => {
                flying(block, &self.pose, self.channels, n, motion);
                CORNERS.into_iter().zip(self.contact.closed).filter(|(_, closed)| *closed).all(
                    |(corner, _)| {
                        let mut gap = gap_along(block, corner, n, motion);
                        // On the base, and not moving up.
                        let known = if self.contact.zero == Some(Zero::Normal) { 3 } else { 2 };
                        gap[..known].fill(0.0);
                        sign(&gap[..=n], scales.length) != Less
                    },
                )
            }
            (_, None) => {
                flat(block, slip, &self.pose, self.channels, n, motion);
                let [x, p, m] = &motion.wrench;
                let size = scales.acceleration + x[0].abs() + p[0].abs() + m[0].abs() / scales.length;
                let base = on_base(block, p, &base_moment(block, slip, &motion.wrench, n), n);
                let width = size * (block.b1 + block.b2 + block.d);
                let pressed =
                    force(p, size) != Less && base.iter().all(|margin| force(margin, width) != Less);
                let friction = |side: f64| {
                    force(&combined(&[(block.mu_s, p), (-side, x)], n), size * (1.0 + block.mu_s))
                };
                pressed
                    && match () {
                        () if mode == Mode::Rest => friction(1.0) != Less && friction(-1.0) != Less,
                        () if at_rest => {
                            let mut starts = combined(&[(slip, x), (-block.mu_k, p)], n);
                            if Zero::of_slip(self.contact.zero, block, mode.slip()) {
                                starts[0] = 0.0;
                            }
                            let sticks = self.contact.failed != Some(Mode::Rest) && friction(slip) != Less;
                            !sticks && force(&starts, size * (1.0 + block.mu_k)) == Greater
                        }
                        () => true,
                    }
            }
            (_, Some(corner)) => {
                if slip == 0.0 {
                    rocking(block, corner, &self.pose, self.channels, n, motion);
                } else {
                    slipping(block, corner, slip, &self.pose, self.channels, n, motion);
                }
                let [x, p, m] = &motion.wrench;
                let size = scales.acceleration + x[0].abs() + p[0].abs() + m[0].abs() / scales.length;
                if flat_before {
                    // θ and ω are zero, and it must turn so that the other corner leaves the base.
                    let mut angle = motion.θ;
                    (angle[0], angle[1]) = (0.0, 0.0);
                    if Zero::of_turn(self.contact.zero, mode, self.contact.failed) {
                        angle[2] = 0.0;
                    }
                    let side = turning(corner);
                    angle.iter_mut().for_each(|a| *a *= side * scales.length);
                    if sign(&angle[..=n], scales.length) != Greater {
                        return false;
                    }
                }
                if force(&motion.normal, size) == Less {
                    return false;
                }
                if slip == 0.0 {
                    let cone = |side: f64| {
                        let margin =
                            combined(&[(block.mu_s, &motion.normal), (-side, &motion.tangential)], n - 2);
                        force(&margin, size * (1.0 + block.mu_s)) != Less
                    };
                    cone(1.0) && cone(-1.0)
                } else if at_rest {
                    let mut u = [0.0; crate::series::LEN];
                    for k in 1..n {
                        u[k] = slip * (motion.vx[k] + (k + 1) as f64 * motion.c[k + 1]);
                    }
                    if Zero::of_slip(self.contact.zero, block, mode.slip()) {
                        u[1] = 0.0;
                    }
                    sign(&u[..n], scales.acceleration * scales.time * (1.0 + size / scales.acceleration))
                        == Greater
                } else {
                    true
                }
            }
        }
    }
}

/// σ: +1 if turning about the corner lifts the other one with θ > 0.
pub(crate) fn turning(corner: Corner) -> f64 {
    match corner {
        Corner::O => 1.0,
        Corner::OPrime => -1.0,
    }
}
