//! Random points, and points on boundaries, for all tests of the library.

#![allow(dead_code, reason = "each test binary uses its own part")]

use std::sync::LazyLock;

use standfast::contact::Block;
use standfast::initiation::{Chart, PointName};

/// The share of its random points that a test takes: all, or what `STANDFAST_TRIES` says (0.01: one in a hundred), for runs that
/// test the tests by breaking the library again and again.
static SHARE: LazyLock<f64> = LazyLock::new(|| {
    let share = std::env::var("STANDFAST_TRIES").map_or(1.0, |share| share.parse().unwrap());
    assert!(0.0 < share && share <= 1.0, "STANDFAST_TRIES is a share, above 0 and at most 1");
    share
});

/// Number of random points that a test takes of `full`.
pub fn tries(full: u32) -> u32 {
    (f64::from(full) * *SHARE).ceil() as u32
}

/// SplitMix64: a repeatable source of random numbers.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Log-uniform in [low, high).
    pub fn log(&mut self, low: f64, high: f64) -> f64 {
        self.uniform(low.ln(), high.ln()).exp()
    }

    pub fn coin(&mut self) -> bool {
        self.bits() < 1 << 63
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.bits() as usize % from.len()]
    }

    /// A block of any proportions with μ_s = 1, and so with μ_k its ratio of slip to stick.
    pub fn block(&mut self, ratio: f64) -> Block {
        Block {
            b1: 0.3 + self.uniform(0.0, 1.0),
            b2: 0.3 + self.uniform(0.0, 1.0),
            d: 0.2 + 3.0 * self.uniform(0.0, 1.0),
            rho2: 0.1 + self.uniform(0.0, 1.0),
            m_x: 1.0 + self.uniform(0.0, 1.0),
            m_y: 1.0,
            mu_s: 1.0,
            mu_k: ratio,
        }
    }

    /// γ, k', k, μ over the whole range the library is checked on: ordinary bodies, extreme ones, small fractions
    /// that meet boundaries exactly.
    pub fn point(&mut self) -> [f64; 4] {
        match self.bits() % 3 {
            0 => [
                self.uniform(0.3, 5.0),
                self.uniform(-1.0, 1.0),
                self.uniform(0.0, 4.0),
                self.uniform(0.0, 3.0),
            ],
            1 => {
                let sign = self.pick(&[-1.0, 1.0]);
                let k_prime = sign * self.log(1e-3, 200.0);
                [self.log(0.05, 20.0), k_prime, self.log(1e-3, 300.0), self.log(1e-3, 300.0)]
            }
            _ => {
                let mut fraction = |from: i64, to: i64| {
                    let steps = (to - from) as u64 * 8 + 1;
                    from as f64 + (self.bits() % steps) as f64 / 8.0
                };
                [fraction(0, 4) + 0.125, fraction(-2, 2), fraction(0, 6), fraction(0, 6)]
            }
        }
    }

    /// `x` moved by up to three ulps.
    pub fn nudge(&mut self, x: f64) -> f64 {
        let steps = (self.bits() % 7) as i64 - 3;
        (0..steps.abs()).fold(x, |x, _| if steps < 0 { x.next_down() } else { x.next_up() })
    }
}

/// A boundary of the k–μ plane, or a place where the formulas change their form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Boundary {
    Diagonal,
    VerticalAtA,
    UpperLine,
    LowerLine,
    MuStar,
    MuStarRising,
    MuStarStar,
    PointA,
    PointBPrime,
    PointCPrime,
    ForceAtCentre,
    ForceAtCrest,
    ForceAtBase,
    SlendernessRoot2,
    SlendernessRootHalf,
}

impl Boundary {
    pub const ALL: [Boundary; 15] = [
        Boundary::Diagonal,
        Boundary::VerticalAtA,
        Boundary::UpperLine,
        Boundary::LowerLine,
        Boundary::MuStar,
        Boundary::MuStarRising,
        Boundary::MuStarStar,
        Boundary::PointA,
        Boundary::PointBPrime,
        Boundary::PointCPrime,
        Boundary::ForceAtCentre,
        Boundary::ForceAtCrest,
        Boundary::ForceAtBase,
        Boundary::SlendernessRoot2,
        Boundary::SlendernessRootHalf,
    ];

    /// A point within three ulps of the boundary in one coordinate (A, B', C': in both).
    pub fn point(self, random: &mut Random) -> [f64; 4] {
        loop {
            if let Some(point) = self.attempt(random) {
                return point;
            }
        }
    }

    fn attempt(self, random: &mut Random) -> Option<[f64; 4]> {
        let [mut gamma, mut k_prime, mut k, mut mu] = random.point();
        match self {
            Boundary::ForceAtCentre => k_prime = random.nudge(0.0),
            Boundary::ForceAtCrest => k_prime = random.nudge(1.0),
            Boundary::ForceAtBase => k_prime = random.nudge(-1.0),
            Boundary::SlendernessRoot2 => gamma = random.nudge(2f64.sqrt()),
            Boundary::SlendernessRootHalf => gamma = random.nudge(0.5f64.sqrt()),
            Boundary::PointBPrime | Boundary::PointCPrime => k_prime = -random.uniform(0.0, 1.0),
            _ => {}
        }
        let chart = Chart::new(gamma, k_prime).unwrap();
        let named = |name| chart.point(name).map(|point| (point.k, point.mu));
        let on = |mu: f64| (mu.is_finite() && mu >= 0.0).then_some(mu);
        match self {
            Boundary::Diagonal => mu = random.nudge(k),
            Boundary::VerticalAtA => k = random.nudge(named(PointName::A)?.0),
            Boundary::UpperLine => mu = random.nudge(on(chart.upper_line().at(k))?),
            Boundary::LowerLine => mu = random.nudge(on(chart.lower_line().at(k))?),
            Boundary::MuStar => mu = random.nudge(on(chart.mu_star().at(k))?),
            Boundary::MuStarRising => mu = random.nudge(on(chart.mu_star_rising().at(k))?),
            Boundary::MuStarStar => mu = random.nudge(on(chart.mu_star_star().at(k))?),
            Boundary::PointA | Boundary::PointBPrime | Boundary::PointCPrime => {
                let name = match self {
                    Boundary::PointA => PointName::A,
                    Boundary::PointBPrime => PointName::BPrime,
                    _ => PointName::CPrime,
                };
                let (at_k, at_mu) = named(name)?;
                (k, mu) = (random.nudge(at_k), random.nudge(on(at_mu)?));
            }
            // Also on a boundary through a change of form, half the time.
            _ => {
                if random.coin() {
                    mu = random.nudge(on(chart.mu_star().at(k))?);
                }
            }
        }
        (k >= 0.0 && mu >= 0.0).then_some([gamma, k_prime, k, mu])
    }
}
