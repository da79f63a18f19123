//! Impacts: impulses at the corners that meet the base, and the velocities after them.

use standfast::contact::Block;
use standfast::{Corner, Slip};

use crate::problem::Impact;
use crate::series::{Pose, lever, velocity};

/// The state just after an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ImpactState {
    pub pose: Pose,
    /// Corners that stay on the base: O, O'.
    pub closed: [bool; 2],
    /// The direction of slip of those; `None` if they stick.
    pub slip: Option<Slip>,
    /// True if another solution satisfied all conditions too.
    pub others: bool,
    /// True if the impulse acts within the base.
    pub on_base: bool,
    /// True if a measured ratio was more than the energy allows.
    pub reduced: bool,
}

pub(crate) const CORNERS: [Corner; 2] = [Corner::O, Corner::OPrime];

/// An impact law with what it needs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Law {
    pub law: Impact,
    /// Ratio of the rates of a law that has one.
    pub ratio: Option<f64>,
    /// Restitution.
    pub e: f64,
    /// μ_i.
    pub μ: f64,
}

/// K of a motion.
pub(crate) fn kinetic(block: &Block, pose: &Pose) -> f64 {
    0.5 * (block.m_x * pose.vx * pose.vx + block.m_y * pose.vy * pose.vy + block.rho2 * pose.ω * pose.ω)
}

/// ω after the corner with this lever sticks at once.
pub(crate) fn stuck(block: &Block, [c, h]: [f64; 2], pose: &Pose) -> Pose {
    let Block { rho2, m_x, m_y, .. } = *block;
    let ω = (rho2 * pose.ω - m_y * c * pose.vy - m_x * h * pose.vx) / (rho2 + m_y * c * c + m_x * h * h);
    Pose { ω, vx: -h * ω, vy: -c * ω, ..*pose }
}

impl Law {
    /// After `touching` corners met the base: the one that approaches it, or both. `None` if nothing satisfies the law.
    pub(crate) fn after(
        &self,
        block: &Block,
        pose: &Pose,
        touching: [bool; 2],
        landing: bool,
    ) -> Option<ImpactState> {
        match (self.law, self.ratio) {
            (Impact::Housner, _) if !landing => Some(housner(block, pose)),
            (_, Some(ratio)) if !landing => self.measured(block, pose, ratio),
            (Impact::Energetic, _) => self.energetic(block, pose, touching),
            _ => self.poisson(block, pose, touching),
        }
    }

    /// e = 0 at every corner that stays closed, Coulomb's law on the impulses with the slip after the impact.
    pub(crate) fn inelastic(&self, block: &Block, pose: &Pose, touching: [bool; 2]) -> Option<ImpactState> {
        let approaching = |corner: Corner| velocity(block, corner, pose)[1] < 0.0;
        let both = touching == [true, true];
        let mut found: Option<ImpactState> = None;
        let mut keep = |after: Option<ImpactState>| match (&mut found, after) {
            (Some(found), Some(_)) => found.others = true,
            (found @ None, after) => *found = after,
            _ => {}
        };
        // Stick before slip, one corner before both.
        for slip in [None, Some(Slip::Left), Some(Slip::Right)] {
            if slip == Some(Slip::Left) || slip.is_none() {
                for (i, corner) in CORNERS.into_iter().enumerate() {
                    if !(touching[i] && approaching(corner)) {
                        continue;
                    }
                    let slips: &[Option<Slip>] =
                        if slip.is_none() { &[None] } else { &[Some(Slip::Left), Some(Slip::Right)] };
                    for slip in slips {
                        keep(self.one(block, pose, corner, *slip, both));
                    }
                }
            }
            if both {
                keep(self.both(block, pose, slip));
            }
        }
        if found.is_none() && both {
            // With much friction an impulse at the corner that leaves the base may lift the one that comes down.
            for slip in [None, Some(Slip::Left), Some(Slip::Right)] {
                for corner in CORNERS.into_iter().filter(|corner| !approaching(*corner)) {
                    let after = self.one(block, pose, corner, slip, both);
                    found = found.or(after);
                }
            }
        }
        found
    }

    fn one(
        &self,
        block: &Block,
        pose: &Pose,
        corner: Corner,
        slip: Option<Slip>,
        both: bool,
    ) -> Option<ImpactState> {
        let Block { rho2, m_x, m_y, .. } = *block;
        let [c, h] = lever(block, corner, pose.θ);
        let after = match slip {
            None => {
                let after = stuck(block, [c, h], pose);
                let (normal, tangential) = (m_y * (after.vy - pose.vy), m_x * (after.vx - pose.vx));
                (normal >= 0.0 && tangential.abs() <= self.μ * normal).then_some(after)?
            }
            Some(slip) => {
                let s = slip.sign();
                let compliance = 1.0 / m_y + c * (c - s * self.μ * h) / rho2;
                let normal = -(pose.vy + c * pose.ω) / compliance;
                let tangential = -s * self.μ * normal;
                let after = Pose {
                    vx: pose.vx + tangential / m_x,
                    vy: pose.vy + normal / m_y,
                    ω: pose.ω + (c * normal + h * tangential) / rho2,
                    ..*pose
                };
                let after = Pose { vy: -c * after.ω, ..after };
                (normal >= 0.0 && s * (after.vx + h * after.ω) > 0.0).then_some(after)?
            }
        };
        if both {
            // The other corner must leave the base.
            let [_, up] = velocity(block, corner.opposite(), &after);
            if up <= 0.0 {
                return None;
            }
        }
        let closed = CORNERS.map(|other| other == corner);
        Some(ImpactState { pose: after, closed, slip, others: false, on_base: true, reduced: false })
    }

    fn both(&self, block: &Block, pose: &Pose, slip: Option<Slip>) -> Option<ImpactState> {
        let Block { b1, b2, d, rho2, m_x, m_y, .. } = *block;
        let normal = -m_y * pose.vy;
        if normal < 0.0 {
            return None;
        }
        let (tangential, vx) = match slip {
            None => (-m_x * pose.vx, 0.0),
            Some(slip) => {
                let tangential = -slip.sign() * self.μ * normal;
                (tangential, pose.vx + tangential / m_x)
            }
        };
        let holds = match slip {
            None => tangential.abs() <= self.μ * normal,
            Some(slip) => slip.sign() * vx > 0.0,
        };
        // −b₁Λ₁ + b₂Λ₂ + dΛ_t = −ρ²ω, Λ₁ + Λ₂ = Λ_n
        let moment = -rho2 * pose.ω - d * tangential;
        let on_base = (-b1 * normal..=b2 * normal).contains(&moment);
        (holds && on_base).then_some(ImpactState {
            pose: Pose { vx, vy: 0.0, ω: 0.0, ..*pose },
            closed: [true, true],
            slip,
            others: false,
            on_base: true,
            reduced: false,
        })
    }

    /// θ̇⁺ = r θ̇ about the new corner, which stays on the base; the friction that sticks, as far as there is. Where a body that slips would
    /// gain energy, the ratio is the largest below it at which it does not: without rotation it never does.
    fn measured(&self, block: &Block, pose: &Pose, ratio: f64) -> Option<ImpactState> {
        let before = kinetic(block, pose);
        let at = |ratio: f64| self.turned(block, pose, ratio);
        let gains = |after: &ImpactState| after.slip.is_some() && kinetic(block, &after.pose) > before;
        let after = at(ratio)?;
        if !gains(&after) {
            return Some(after);
        }
        let (mut low, mut high) = (0.0, ratio);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if gains(&at(middle)?) { high = middle } else { low = middle }
        }
        at(low).filter(|after| !gains(after)).map(|after| ImpactState { reduced: true, ..after })
    }

    fn turned(&self, block: &Block, pose: &Pose, ratio: f64) -> Option<ImpactState> {
        let Block { rho2, m_x, m_y, .. } = *block;
        let corner = if pose.ω < 0.0 { Corner::OPrime } else { Corner::O };
        let [c, h] = lever(block, corner, pose.θ);
        let ω = ratio * pose.ω;
        let vy = -c * ω;
        let normal = m_y * (vy - pose.vy);
        if normal < 0.0 {
            return None;
        }
        let sticking = m_x * (-h * ω - pose.vx);
        let limit = self.μ * normal;
        let (tangential, sticks) =
            if sticking.abs() <= limit { (sticking, true) } else { (limit.copysign(sticking), false) };
        let vx = if sticks { -h * ω } else { pose.vx + tangential / m_x };
        let after = Pose { vx, vy, ω, ..*pose };
        let u = vx + h * ω;
        let slip = if sticks { None } else { Some(if u < 0.0 { Slip::Left } else { Slip::Right }) };
        let closed = if ω == 0.0 { [true, true] } else { CORNERS.map(|other| other == corner) };
        // Λ_n acts at ξ and Λ_t at the base: their moment about C gives ξ.
        let at = rho2 * (ω - pose.ω) - h * tangential;
        let slack = 1e-12 * normal * block.b1.max(block.b2);
        let on_base = (-block.b1 * normal - slack..=block.b2 * normal + slack).contains(&at);
        Some(ImpactState { pose: after, closed, slip, others: false, on_base, reduced: false })
    }
}

/// The corner that meets the base sticks; if the body would turn back, it stands.
fn housner(block: &Block, pose: &Pose) -> ImpactState {
    let corner = if pose.ω < 0.0 { Corner::OPrime } else { Corner::O };
    let after = stuck(block, lever(block, corner, pose.θ), pose);
    let turns_on = after.ω * pose.ω > 0.0;
    let closed = if turns_on { CORNERS.map(|other| other == corner) } else { [true, true] };
    let pose = if turns_on { after } else { Pose { vx: 0.0, vy: 0.0, ω: 0.0, ..*pose } };
    ImpactState { pose, closed, slip: None, others: false, on_base: true, reduced: false }
}
