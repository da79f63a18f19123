//! Impacts with a rebound: what a compression leaves is given back in part.
//!
//! *Poisson's hypothesis*, as inequalities (after Glocker and Pfeiffer). Compression is the impact without rebound, with impulses Λ^C at the corners
//! that touch. Expansion gives e Λ^C back at each, and more, P ≥ 0, where a corner would press into the base; friction's impulse is one for all,
//! within the cone of all normal impulses, against the slip that is left:
//!
//! ```text
//! Λ_n = e Λ^C + P     P ≥ 0, u_n ≥ 0, P u_n = 0     |Λ_t| ≤ μ Σ Λ_n
//! ```
//!
//! No energy is gained, whatever the body, and a solution there is for any friction.
//!
//! *Energy*, of an impact at one corner (Routh's path, Stronge's law): with the normal impulse for time the corner's velocities are straight lines,
//! until slip ends; compression lasts until the corner stops to approach, and expansion until e² of the work of compression is given back.

use standfast::Slip;
use standfast::contact::Block;

use crate::impact::{CORNERS, ImpactState, Law};
use crate::series::{Pose, lever, velocity};

/// Share of the velocities before an impact, and of the impulses given, below which a velocity counts as zero.
const ROUNDING: f64 = 1e-12;

/// Share of the velocity upwards below which a rotation counts as none.
const FLAT: f64 = 1e-14;

/// Impulses at O and O', upwards, that make what is after an impact with this friction of a pose: at these corners, which stand upright if they
/// are both.
fn impulses(block: &Block, before: &Pose, impact: &ImpactState, μ: f64, at: [bool; 2]) -> [f64; 2] {
    let after = &impact.pose;
    let all = block.m_y * (after.vy - before.vy);
    let tangential = match impact.slip {
        None => block.m_x * (after.vx - before.vx),
        // Beside a fast slip the difference of its velocities has lost its digits.
        Some(slip) => -slip.sign() * μ * all,
    };
    let normal = match at {
        [true, false] => [all, 0.0],
        [false, true] => [0.0, all],
        // Moments about C: −b₁Λ₁ + b₂Λ₂ + dΛ_t = ρ²Δω.
        _ => {
            let moment = block.rho2 * (after.ω - before.ω) - block.d * tangential;
            [
                (block.b2 * all - moment) / (block.b1 + block.b2),
                (block.b1 * all + moment) / (block.b1 + block.b2),
            ]
        }
    };
    normal.map(|one| one.max(0.0))
}

/// Expansion after a compression.
struct Expansion<'a> {
    block: &'a Block,
    /// After the compression.
    pose: &'a Pose,
    touching: [bool; 2],
    /// Impulses that are given back at the corners.
    given: [f64; 2],
    μ: f64,
    /// Velocity that counts as zero.
    tiny: f64,
}

/// Friction of an expansion.
#[derive(Clone, Copy, PartialEq)]
enum Friction {
    Sticks,
    Slips(Slip),
}

impl Expansion<'_> {
    /// Velocities after impulses.
    fn after(&self, normal: [f64; 2], tangential: f64) -> Pose {
        let Block { rho2, m_x, m_y, .. } = *self.block;
        let mut moment = 0.0;
        for (corner, impulse) in CORNERS.into_iter().zip(normal) {
            moment += lever(self.block, corner, self.pose.θ)[0] * impulse;
        }
        moment += self.height() * tangential;
        Pose {
            vx: self.pose.vx + tangential / m_x,
            vy: self.pose.vy + (normal[0] + normal[1]) / m_y,
            ω: self.pose.ω + moment / rho2,
            ..*self.pose
        }
    }

    /// h of the corners that touch: of both, upright, it is the same.
    fn height(&self) -> f64 {
        let corner = if self.touching[0] { CORNERS[0] } else { CORNERS[1] };
        lever(self.block, corner, self.pose.θ)[1]
    }

    /// The solution with more impulse at these corners and this friction, if it satisfies every condition.
    fn tried(&self, more: [bool; 2], friction: Friction) -> Option<ImpactState> {
        let Block { rho2, m_x, m_y, .. } = *self.block;
        let h = self.height();
        let c = CORNERS.map(|corner| lever(self.block, corner, self.pose.θ)[0]);
        let slides = 1.0 / m_x + h * h / rho2;
        // Normal velocity of one corner by an impulse at another, with the friction that goes with it.
        let by = |i: usize, j: usize| match friction {
            Friction::Sticks => 1.0 / m_y + c[i] * c[j] / rho2 - c[i] * c[j] * h * h / (rho2 * rho2 * slides),
            Friction::Slips(slip) => 1.0 / m_y + c[i] * c[j] / rho2 - slip.sign() * self.μ * c[i] * h / rho2,
        };
        let up = |i: usize| self.pose.vy + c[i] * self.pose.ω;
        let along = self.pose.vx + h * self.pose.ω;
        // What friction that sticks takes of the slip that is left of a compression.
        let of_slip = |i: usize| match friction {
            Friction::Sticks => -c[i] * h * along / (rho2 * slides),
            Friction::Slips(_) => 0.0,
        };
        let without = |i: usize| up(i) + of_slip(i) + (0..2).map(|j| by(i, j) * self.given[j]).sum::<f64>();
        let mut extra = [0.0; 2];
        match more {
            [false, false] => {}
            [true, true] => {
                let [[a, b], [p, q]] = [[by(0, 0), by(0, 1)], [by(1, 0), by(1, 1)]];
                let determinant = a * q - b * p;
                let (one, other) = (without(0), without(1));
                extra = [(b * other - q * one) / determinant, (p * one - a * other) / determinant];
            }
            _ => {
                let i = usize::from(more[1]);
                extra[i] = -without(i) / by(i, i);
            }
        }
        if extra.iter().any(|extra| extra.is_nan() || *extra < 0.0) {
            return None;
        }
        let normal = [self.given[0] + extra[0], self.given[1] + extra[1]];
        let all = normal[0] + normal[1];
        let tangential = match friction {
            Friction::Sticks => {
                let moment = c[0] * normal[0] + c[1] * normal[1];
                -(along + h * moment / rho2) / slides
            }
            Friction::Slips(slip) => -slip.sign() * self.μ * all,
        };
        let mut after = self.after(normal, tangential);
        let holds = match friction {
            Friction::Sticks => tangential.abs() <= self.μ * all * (1.0 + ROUNDING),
            Friction::Slips(slip) => slip.sign() * (after.vx + h * after.ω) > 0.0,
        };
        let rises = CORNERS.map(|corner| velocity(self.block, corner, &after)[1]);
        let into = |i: usize| self.touching[i] && !more[i] && rises[i] < -self.tiny;
        if !holds || into(0) || into(1) {
            return None;
        }
        let closed = [0, 1].map(|i| self.touching[i] && (more[i] || rises[i] <= self.tiny));
        match closed {
            [true, true] => (after.vy, after.ω) = (0.0, 0.0),
            // A body that bounces flat does not begin to turn by rounding.
            [false, false] if (after.ω * self.block.b1.max(self.block.b2)).abs() < FLAT * after.vy => {
                after.ω = 0.0;
            }
            [false, false] => {}
            _ => after.vy = -c[usize::from(closed[1])] * after.ω,
        }
        let slip = match friction {
            Friction::Sticks => None,
            Friction::Slips(slip) => Some(slip),
        };
        if slip.is_none() && closed != [false, false] {
            after.vx = -h * after.ω;
        }
        Some(ImpactState { pose: after, closed, slip, others: false, on_base: true, reduced: false })
    }
}

impl Law {
    /// Poisson's hypothesis: without rebound, and then what is given back.
    pub(crate) fn poisson(&self, block: &Block, pose: &Pose, touching: [bool; 2]) -> Option<ImpactState> {
        let compressed = self.inelastic(block, pose, touching)?;
        if self.e == 0.0 {
            return Some(compressed);
        }
        let at = if touching == [true, true] { compressed.closed } else { touching };
        let given = impulses(block, pose, &compressed, self.μ, at).map(|normal| self.e * normal);
        let speed = |pose: &Pose| {
            let turn = pose.ω * block.rho2.sqrt();
            pose.vx.abs().max(pose.vy.abs()).max(turn.abs())
        };
        let tiny = ROUNDING * (speed(pose) + (given[0] + given[1]) / block.m_y);
        let expansion = Expansion { block, pose: &compressed.pose, touching, given, μ: self.μ, tiny };
        let mut found: Option<ImpactState> = None;
        let slips = [Friction::Slips(Slip::Left), Friction::Slips(Slip::Right)];
        // Stick before slip, the fewest corners with more impulse first.
        for friction in [&[Friction::Sticks][..], &slips[..]] {
            for more in [[false, false], [true, false], [false, true], [true, true]] {
                if (0..2).any(|i| more[i] && !touching[i]) {
                    continue;
                }
                for friction in friction {
                    match (expansion.tried(more, *friction), &mut found) {
                        // Of the same velocities there are no two.
                        (Some(other), Some(found)) => found.others |= !is_same(&other, found, tiny),
                        (Some(first), None) => found = Some(first),
                        (None, _) => {}
                    }
                }
            }
        }
        found.map(|found| ImpactState { others: found.others || compressed.others, ..found })
    }

    /// By the energy that is given back, at the one corner that an impulse acts on; Poisson's hypothesis where there are two.
    pub(crate) fn energetic(&self, block: &Block, pose: &Pose, touching: [bool; 2]) -> Option<ImpactState> {
        let approaching = |i: usize| touching[i] && velocity(block, CORNERS[i], pose)[1] < 0.0;
        let one = match (approaching(0), approaching(1)) {
            (true, false) => 0,
            (false, true) => 1,
            _ => return self.poisson(block, pose, touching),
        };
        let after = routh(block, pose, one, self.μ, self.e)?;
        let rises = CORNERS.map(|corner| velocity(block, corner, &after.pose)[1]);
        // Where the other corner would be pressed into the base it has an impulse too.
        if touching[1 - one] && rises[1 - one] <= 0.0 {
            return self.poisson(block, pose, touching);
        }
        Some(after)
    }
}

/// True if two states after an impact are one.
fn is_same(one: &ImpactState, other: &ImpactState, tiny: f64) -> bool {
    let (a, b) = (&one.pose, &other.pose);
    let differ = (a.vx - b.vx).abs().max((a.vy - b.vy).abs()).max((a.ω - b.ω).abs());
    differ <= 1e3 * tiny
}

/// The path of an impact at one corner, by the normal impulse.
fn routh(block: &Block, pose: &Pose, corner: usize, μ: f64, e: f64) -> Option<ImpactState> {
    let Block { rho2, m_x, m_y, .. } = *block;
    let [c, h] = lever(block, CORNERS[corner], pose.θ);
    let [mut along, mut up] = velocity(block, CORNERS[corner], pose);
    let (slides, rises, coupling) = (1.0 / m_x + h * h / rho2, 1.0 / m_y + c * c / rho2, c * h / rho2);
    let (mut normal, mut tangential) = (0.0, 0.0);
    // Work of the compression, and what is still to be given back once it has ended.
    let (mut work, mut left) = (0.0, None);
    let sticks = coupling.abs() <= μ * slides;
    for _ in 0..8 {
        // Friction for each unit of normal impulse.
        let slip = if along != 0.0 {
            along.signum()
        } else if sticks {
            0.0
        } else {
            coupling.signum()
        };
        let friction = if along == 0.0 && sticks { -coupling / slides } else { -slip * μ };
        let (of_up, of_along) = (rises + friction * coupling, coupling + friction * slides);
        if left.is_none() && of_up <= 0.0 && along == 0.0 {
            return None;
        }
        // To the end of slip, or of the phase, whichever comes first.
        let to_stop = if slip != 0.0 && along != 0.0 && slip * of_along < 0.0 {
            -along / of_along
        } else {
            f64::INFINITY
        };
        let to_end = match left {
            None => {
                if of_up > 0.0 {
                    -up / of_up
                } else {
                    f64::INFINITY
                }
            }
            // up p + of_up p²/2 = what is left.
            Some(left) => {
                let square: f64 = up * up + 2.0 * of_up * left;
                if square < 0.0 { f64::INFINITY } else { 2.0 * left / (up + square.sqrt()) }
            }
        };
        let p = to_stop.min(to_end);
        if !p.is_finite() {
            return None;
        }
        let done = p * (up + 0.5 * of_up * p);
        (normal, tangential) = (normal + p, tangential + friction * p);
        (up, along) = (up + of_up * p, along + of_along * p);
        if p == to_stop {
            along = 0.0;
        }
        match &mut left {
            None => work -= done,
            Some(left) => *left -= done,
        }
        if p == to_end {
            if left.is_some() {
                break;
            }
            (up, left) = (0.0, Some(e * e * work));
            if e == 0.0 {
                break;
            }
        }
    }
    let after = Pose {
        vx: pose.vx + tangential / m_x,
        vy: pose.vy + normal / m_y,
        ω: pose.ω + (c * normal + h * tangential) / rho2,
        ..*pose
    };
    let stays = e == 0.0;
    let after = if stays { Pose { vy: -c * after.ω, ..after } } else { after };
    let slip = match along {
        u if u > 0.0 => Some(Slip::Right),
        u if u < 0.0 => Some(Slip::Left),
        _ => None,
    };
    let closed = [0, 1].map(|i| stays && i == corner);
    Some(ImpactState { pose: after, closed, slip, others: false, on_base: true, reduced: false })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impact::kinetic;
    use crate::problem::Impact;

    struct Random(u64);

    impl Random {
        fn between(&mut self, low: f64, high: f64) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
        }
    }

    fn law(law: Impact, e: f64, μ: f64) -> Law {
        Law { law, ratio: None, e, μ }
    }

    /// A body and how it meets the base: with one corner at any angle, or with both.
    fn impact(random: &mut Random, corners: usize) -> (Block, Pose, [bool; 2]) {
        let (b1, b2, d) = (random.between(0.3, 1.5), random.between(0.3, 1.5), random.between(0.2, 4.0));
        let square = (b1 + b2) * (b1 + b2) / 4.0 + d * d;
        let block = Block {
            b1,
            b2,
            d,
            rho2: square * random.between(0.1, 1.0),
            m_x: random.between(1.0, 1.8),
            m_y: random.between(1.0, 1.3),
            mu_s: 1.0,
            mu_k: 1.0,
        };
        let touching = [[true, false], [false, true], [true, true]][corners % 3];
        let θ = match corners % 3 {
            0 => random.between(0.0, 0.5),
            1 => -random.between(0.0, 0.5),
            _ => 0.0,
        };
        let mut pose = Pose { θ, ..Pose::default() };
        loop {
            pose.vx = random.between(-1.0, 1.0);
            pose.vy = random.between(-1.0, 0.3);
            pose.ω = random.between(-1.0, 1.0);
            let up = CORNERS.map(|corner| velocity(&block, corner, &pose)[1]);
            if (0..2).any(|i| touching[i] && up[i] < 0.0) {
                return (block, pose, touching);
            }
        }
    }

    fn mirrored((block, pose, [one, other]): (Block, Pose, [bool; 2])) -> (Block, Pose, [bool; 2]) {
        let block = Block { b1: block.b2, b2: block.b1, ..block };
        (block, Pose { θ: -pose.θ, vx: -pose.vx, ω: -pose.ω, ..pose }, [other, one])
    }

    /// No impact gains energy, each has a solution, no corner goes into the base, and a mirror shows the mirrored impact.
    #[test]
    fn impacts_gain_nothing_and_have_an_outcome() {
        let mut random = Random(0x1234_5678_9abc_def1);
        let (mut several, mut lifted) = (0, 0);
        for seed in 0..100_000usize {
            let given = impact(&mut random, seed);
            let (block, pose, touching) = given;
            let (μ, e) = (random.between(0.0, 1.2), random.between(0.0, 1.0));
            for kind in [Impact::Poisson, Impact::Energetic] {
                let law = law(kind, e, μ);
                let after = law.after(&block, &pose, touching, true).unwrap_or_else(|| {
                    panic!("{seed} {kind:?}: no outcome of {block:?} {pose:?} {touching:?} {μ} {e}")
                });
                let had = kinetic(&block, &pose);
                let gain = kinetic(&block, &after.pose) - had;
                assert!(gain <= 4e-14 * had, "{seed} {kind:?}: {gain} of {had}");
                for (corner, touches) in CORNERS.into_iter().zip(touching) {
                    let up = velocity(&block, corner, &after.pose)[1];
                    assert!(!touches || up > -1e-10, "{seed} {kind:?}: {up}");
                }
                several += usize::from(after.others);
                lifted += usize::from(after.closed == [false, false]);
                let (block, pose, touching) = mirrored(given);
                let other = law.after(&block, &pose, touching, true).unwrap();
                let Pose { vx, vy, ω, .. } = other.pose;
                if !after.others {
                    assert_eq!(
                        (-vx, vy, -ω),
                        (after.pose.vx, after.pose.vy, after.pose.ω),
                        "{seed} {kind:?}"
                    );
                }
            }
        }
        assert!(several < 40 && lifted > 150_000, "{several} {lifted}");
    }

    /// At one corner: a stiff spring that gives back e² of its work, under Coulomb's friction, by small steps of time.
    #[test]
    fn the_path_is_that_of_a_stiff_spring() {
        let mut random = Random(0x0fed_cba9_8765_4321);
        let mut parted = 0;
        for seed in 0..60usize {
            let (block, pose, touching) = impact(&mut random, seed % 2);
            let (μ, e) = (random.between(0.05, 1.0), random.between(0.2, 1.0));
            let corner = CORNERS[usize::from(!touching[0])];
            let [c, h] = lever(&block, corner, pose.θ);
            let [mut along, mut up] = velocity(&block, corner, &pose);
            let (slides, rises, coupling) = (
                1.0 / block.m_x + h * h / block.rho2,
                1.0 / block.m_y + c * c / block.rho2,
                c * h / block.rho2,
            );
            // k = 1, and time as it comes; the deepest point parts loading from unloading.
            let (mut depth, mut deepest, mut normal, mut tangential) = (0.0f64, 0.0f64, 0.0, 0.0);
            let dt = 1e-5;
            loop {
                // Unloading, the spring is stiffer by 1/e² and slack before the base is reached.
                let force =
                    if up < 0.0 && depth >= deepest { depth } else { deepest - (deepest - depth) / (e * e) };
                if force <= 0.0 && up > 0.0 {
                    break;
                }
                let p = force.max(0.0) * dt;
                let sticking = -(along + coupling * p) / slides;
                let friction = if sticking.abs() <= μ * p { sticking } else { sticking.signum() * μ * p };
                up += rises * p + coupling * friction;
                along += coupling * p + slides * friction;
                (normal, tangential) = (normal + p, tangential + friction);
                depth -= up * dt;
                deepest = deepest.max(depth);
            }
            let after = law(Impact::Energetic, e, μ).after(&block, &pose, touching, true).unwrap();
            let stepped = Pose {
                vx: pose.vx + tangential / block.m_x,
                vy: pose.vy + normal / block.m_y,
                ω: pose.ω + (c * normal + h * tangential) / block.rho2,
                ..pose
            };
            let off = |a: f64, b: f64| (a - b).abs();
            let worst = off(after.pose.vx, stepped.vx)
                .max(off(after.pose.vy, stepped.vy))
                .max(off(after.pose.ω, stepped.ω));
            assert!(worst < 1e-3, "{seed}: {worst} {:?} {stepped:?}", after.pose);
            // Where slip does not end within the impact both hypotheses agree.
            let poisson = law(Impact::Poisson, e, μ).after(&block, &pose, touching, true).unwrap();
            parted += usize::from(off(poisson.pose.ω, after.pose.ω) > 1e-9);
        }
        assert!((10..55).contains(&parted), "{parted}");
    }
}
