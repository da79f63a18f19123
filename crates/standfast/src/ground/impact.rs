//! A short thrust on an elastic base: when a peak force is not a static one.
//!
//! ```text
//!      ┌──────────┐        f(t)
//!      │    C     │◄──       ╱╲
//!      │          │         ╱  ╲
//!      └──────────┘      ──┴────┴── t
//!       ╪╪╪╪╪╪╪╪╪  k_n, k_t (both per area), from rest
//! ```
//!
//! Until something slips, lifts or yields, the body on its springs is linear and has two natural frequencies, of sway and rocking together;
//! heave goes apart. With u the displacement of the base, K_x = 2Bk_t, K_θ = ⅔k_nB³, K_y = 2Bk_n and I = mρ²:
//!
//! ```text
//! m_x(ü − dθ̈) = X(t) − K_x u        I θ̈ = M(t) − d K_x u − K_θ θ        m_y ÿ = −P(t) − K_y y
//! m_xI ω⁴ − [K_x(I + m_xd²) + K_θm_x] ω² + K_xK_θ = 0
//! ```
//!
//! A load that is linear from moment to moment moves each mode by
//!
//! ```text
//! q(t)/q_static = Σ Δslope (t−tᵢ − sin ω(t−tᵢ)/ω) + Σ Δstep (1 − cos ω(t−tᵢ))
//! ```
//!
//! exactly. What the base bears, S = K_x u, N, and M_O = K_θθ about its middle, is sums of lines and sines, and so are the conditions
//!
//! | event | when |
//! |---|---|
//! | slip | \|S\| = μN |
//! | lift | \|M_O\| = N B/3: the edge is unloaded |
//! | yield | N/(2B) + 3\|M_O\|/(2B²) = q_u |
//!
//! The first zero of each is stepped up to with steps that cannot pass it; the largest values are refined to round-off.
//!
//! *Amplification*: D_shear = max|S|/max|X|, D_moment = max|M_O|/max|M − Xd|, of the loads that vary. The design point of the k–μ plane
//! moves to k → D_shear k, 1 + k' → (1 + k') D_moment/D_shear. One mode alone, with the longer period, is not safe: it gives up to 1.6 times
//! less of the moment, and is not given here.
//!
//! The maxima are those up to two of the longest periods after the load has stopped to change: without damping two modes come together
//! again later, which no real base does.
//!
//! Limits: no damping (on the safe side), no water moved along but what is in m_x, springs as linear as soil is not; b₁ = b₂.
//! Reference: any text on structural dynamics; the triangle and the sudden rise are its cases.
//!
//! ```
//! use standfast::ground::impact::ElasticBody;
//! use standfast::{History, Wrench};
//!
//! // 15 m by 10.5 m, 346 t/m, on 50 and 25 MN/m³.
//! let body = ElasticBody::new(7.5, 5.25, 346e3, 1062e4, 50e6, 25e6)?;
//! let triangle = History::triangle(1.0, 0.05, 0.1)?;
//! let push = Wrench { x: -9.4e5, p: 0.0, m: 0.0 };
//! let answer = body.response(&Wrench { x: 0.0, p: 2.3e6, m: 0.0 }, &[(push, triangle)], 0.6, None)?;
//! assert!(answer.periods[0] > answer.periods[1]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::f64::consts::TAU;

use crate::error::InputError;
use crate::history::{History, HistoryChange};
use crate::quantity::{Expected, Quantity};
use crate::wrench::Wrench;

/// a + bτ + Σ (c cos ωτ + s sin ωτ) from a moment on.
#[derive(Debug, Clone, Copy, Default)]
struct Wave {
    level: f64,
    slope: f64,
    cos: [f64; 3],
    sin: [f64; 3],
}

impl Wave {
    fn add(&mut self, other: &Wave, factor: f64) {
        self.level += factor * other.level;
        self.slope += factor * other.slope;
        for i in 0..3 {
            self.cos[i] += factor * other.cos[i];
            self.sin[i] += factor * other.sin[i];
        }
    }

    /// Value and slope at τ.
    fn at(&self, ω: &[f64; 3], τ: f64) -> [f64; 2] {
        let mut all = [self.level + self.slope * τ, self.slope];
        for ((ω, c), s) in ω.iter().zip(self.cos).zip(self.sin) {
            let (sin, cos) = (ω * τ).sin_cos();
            all[0] += c * cos + s * sin;
            all[1] += ω * (s * cos - c * sin);
        }
        all
    }

    /// A bound of the curvature.
    fn curvature(&self, ω: &[f64; 3]) -> f64 {
        (0..3).map(|i| ω[i] * ω[i] * self.cos[i].hypot(self.sin[i])).sum()
    }
}

/// A function of lines and sines over the time that is looked at: waves, each from a moment to the next.
struct Signal<'a> {
    ω: &'a [f64; 3],
    pieces: Vec<(f64, f64, Wave)>,
}

impl Signal<'_> {
    /// The first moment at which it is not positive; `None` if it stays positive.
    fn first_zero(&self) -> Option<f64> {
        for (from, to, wave) in &self.pieces {
            let (mut τ, most) = (0.0, wave.curvature(self.ω));
            loop {
                let [value, slope] = wave.at(self.ω, τ);
                if value <= 0.0 {
                    return Some(from + τ);
                }
                // value + slope·s − most s²/2 is below it: no zero before that is zero.
                let step = 2.0 * value / ((slope * slope + 2.0 * most * value).sqrt() - slope);
                if step.is_nan() || step < 0.0 || τ + step >= to - from {
                    break;
                }
                if step <= 4.0 * f64::EPSILON * (from + τ) {
                    return Some(from + τ);
                }
                τ += step;
            }
        }
        None
    }

    /// Its largest value and when.
    fn largest(&self) -> (f64, f64) {
        let mut best = (f64::NEG_INFINITY, 0.0);
        let mut keep = |value: f64, at: f64| {
            if value > best.0 {
                best = (value, at);
            }
        };
        let fastest = self.ω.iter().fold(0.0, |m: f64, ω| m.max(*ω));
        for (from, to, wave) in &self.pieces {
            let count = ((to - from) * fastest / TAU * 24.0).ceil().max(1.0);
            let step = (to - from) / count;
            for i in 0..=count as usize {
                let at = step * i as f64;
                keep(wave.at(self.ω, at)[0], from + at);
                // The slope falls through zero in the step: the summit, by bisection.
                let (mut low, mut high) = (at, (at + step).min(to - from));
                if wave.at(self.ω, low)[1] > 0.0 && wave.at(self.ω, high)[1] < 0.0 {
                    for _ in 0..60 {
                        let middle = (low + high) / 2.0;
                        if wave.at(self.ω, middle)[1] > 0.0 { low = middle } else { high = middle }
                    }
                    keep(wave.at(self.ω, low)[0], from + low);
                }
            }
        }
        best
    }
}

/// End of the linear response.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
pub enum ImpactEvent {
    /// The base slips.
    Slip,
    /// An edge is unloaded.
    Lift,
    /// An edge reaches the strength.
    Yield,
}

/// One of the events.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EventFound {
    /// Event that is looked for.
    pub event: ImpactEvent,
    /// Time at which it first happens, s; `None` if it does not.
    pub time: Option<f64>,
    /// λ, by which the loads that vary have to be multiplied for it to happen at all: infinite if no factor makes it, zero if the
    /// permanent loads do it.
    pub load_factor: f64,
}

/// The linear response to a short load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ImpactResponse {
    /// Both natural periods of sway and rocking, s, the longer first.
    pub periods: [f64; 2],
    /// The natural period of heave, s.
    pub heave_period: f64,
    /// D_shear; `None` if no horizontal load varies.
    pub d_shear: Option<f64>,
    /// D_moment, of the moment about the middle of the base; `None` if none varies.
    pub d_moment: Option<f64>,
    /// Times at which the largest shear and the largest moment are borne, s; zero where there is none.
    pub largest_at: [f64; 2],
    /// Slip, lift, and yield if the base has a strength.
    pub events: Vec<EventFound>,
    /// Time over which the response was followed, s.
    pub until: f64,
}

impl ImpactResponse {
    /// The event that comes first.
    pub fn first_event(&self) -> Option<&EventFound> {
        let key = |event: &&EventFound| event.time.unwrap_or(f64::INFINITY);
        let first = self.events.iter().min_by(|one, two| key(one).total_cmp(&key(two)));
        first.filter(|event| event.time.is_some())
    }

    /// Point to which the design point k, k' of the report's plane moves: D_shear k and (1 + k') D_moment/D_shear − 1.
    pub fn moved(&self, k: f64, k_prime: f64) -> Option<[f64; 2]> {
        let (shear, moment) = (self.d_shear?, self.d_moment?);
        Some([shear * k, (1.0 + k_prime) * moment / shear - 1.0])
    }
}

/// A body on springs; SI units, per metre run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticBody {
    half_width: f64,
    depth: f64,
    inertia: [f64; 3],
    springs: [f64; 3],
}

impl ElasticBody {
    /// A body on a base of `half_width` B (m), its centre of mass `depth` d above the base and in its middle, of `mass` (kg) and
    /// `moment_of_inertia` about C (kg m²), on springs of `stiffness` k_n and `tangential_stiffness` k_t (N/m³).
    ///
    /// # Errors
    /// If one of them is not above zero.
    pub fn new(
        half_width: f64,
        depth: f64,
        mass: f64,
        moment_of_inertia: f64,
        stiffness: f64,
        tangential_stiffness: f64,
    ) -> Result<ElasticBody, InputError> {
        let b = InputError::positive(Quantity::HalfWidth, half_width)?;
        let mass = InputError::positive(Quantity::Mass, mass)?;
        let inertia = InputError::positive(Quantity::MomentOfInertia, moment_of_inertia)?;
        let k_n = InputError::positive(Quantity::Stiffness, stiffness)?;
        let k_t = InputError::positive(Quantity::TangentialStiffness, tangential_stiffness)?;
        Ok(ElasticBody {
            half_width: b,
            depth: InputError::positive(Quantity::D, depth)?,
            inertia: [mass, mass, inertia],
            springs: [2.0 * b * k_t, 2.0 * b * k_n, 2.0 / 3.0 * k_n * b * b * b],
        })
    }

    /// Body with water that a horizontal motion carries along (kg).
    ///
    /// # Errors
    /// If it is negative or not finite.
    pub fn with_added_mass(mut self, mass: f64) -> Result<ElasticBody, InputError> {
        self.inertia[0] += InputError::not_negative(Quantity::AddedMass, mass)?;
        Ok(self)
    }

    /// Both frequencies of sway and rocking, the lower first, and that of heave, rad/s.
    pub fn frequencies(&self) -> [f64; 3] {
        let ([m_x, m_y, i], [k_x, k_y, k_θ], d) = (self.inertia, self.springs, self.depth);
        // a ω⁴ − b ω² + c = 0; the discriminant as a sum, so that nothing cancels where both are near.
        let (a, b, c) = (m_x * i, k_x * (i + m_x * d * d) + k_θ * m_x, k_x * k_θ);
        let apart = k_x * (i + m_x * d * d) - k_θ * m_x;
        let root = (apart * apart + 4.0 * k_x * k_θ * m_x * m_x * d * d).sqrt();
        let high = (b + root) / (2.0 * a);
        [(c / (a * high)).sqrt(), high.sqrt(), (k_y / m_y).sqrt()]
    }

    /// The share of each mode in S and M_O under a static X and moment about the base's middle of 1: `[mode][S, M_O][X, M − Xd]`.
    fn shares(&self, ω: &[f64; 3]) -> [[[f64; 2]; 2]; 2] {
        let ([m_x, _, i], [k_x, _, k_θ], d) = (self.inertia, self.springs, self.depth);
        // Mode shapes (u, θ) from the first equation, (K_x − ω²m_x) u + ω² m_x d θ = 0, or from the second, whichever is larger.
        [ω[0] * ω[0], ω[1] * ω[1]].map(|square| {
            let one = [-square * m_x * d, k_x - square * m_x];
            let two = [k_θ - square * (i + m_x * d * d), -square * m_x * d];
            let size = |shape: [f64; 2]| k_x * shape[0] * shape[0] + k_θ * shape[1] * shape[1];
            let [u, θ] = if size(one) > size(two) { one } else { two };
            // Of the static displacement Kᵀ⁻¹F the part along the shape: (shape·F)/(shape·K shape).
            let norm = size([u, θ]);
            [[k_x * u * u / norm, k_x * u * θ / norm], [k_θ * θ * u / norm, k_θ * θ * θ / norm]]
        })
    }

    /// The response to `permanent` (in equilibrium when the loads begin) and `loads` with their histories: on a base with friction `mu`,
    /// that yields at `strength` (Pa), if at all. Wrenches are at C.
    ///
    /// # Errors
    /// If a number is not finite, the permanent loads do not press, `mu` or `strength` is negative, or a history has sines; if the
    /// time to be followed is more than 100,000 of the shortest period, as where the other period or a history is out of proportion
    /// to it.
    pub fn response(
        &self,
        permanent: &Wrench,
        loads: &[(Wrench, History)],
        mu: f64,
        strength: Option<f64>,
    ) -> Result<ImpactResponse, InputError> {
        let mu = InputError::not_negative(Quantity::Friction, mu)?;
        let strength = strength.map(|q| InputError::positive(Quantity::Strength, q)).transpose()?;
        InputError::positive(Quantity::WrenchP, permanent.p)?;
        for wrench in loads.iter().map(|(wrench, _)| wrench).chain([permanent]) {
            InputError::finite(Quantity::WrenchX, wrench.x)?;
            InputError::finite(Quantity::WrenchP, wrench.p)?;
            InputError::finite(Quantity::WrenchM, wrench.m)?;
        }
        let ω = self.frequencies();
        let mut changes: Vec<(Wrench, HistoryChange)> = Vec::new();
        for (wrench, history) in loads {
            let lines = history.changes();
            let lines = lines
                .ok_or_else(|| InputError::new(Quantity::LoadShare, f64::NAN, Expected::StraightLines))?;
            for change in lines {
                InputError::not_negative(Quantity::LoadTime, change.at)?;
                changes.push((*wrench, change));
            }
        }
        let end = changes.iter().map(|(_, change)| change.at).fold(0.0, f64::max);
        let until = end + 2.0 * TAU / ω[0];
        let periods = (until * ω.iter().fold(0.0, |most: f64, ω| most.max(*ω)) / TAU).ceil();
        if periods.is_nan() || periods > PERIODS_AT_MOST {
            return Err(InputError::new(Quantity::PeriodsFollowed, periods, Expected::PeriodsAtMost));
        }
        let borne = self.borne(&ω, &changes, until);
        let applied = |of: &dyn Fn(&Wrench) -> f64| {
            let at = |t: f64| loads.iter().map(|(w, history)| of(w) * history.at(t)).sum::<f64>().abs();
            let before = |t: f64| at(t).max(at(t.next_down()));
            changes.iter().map(|(_, change)| before(change.at)).fold(0.0, f64::max)
        };
        let d = self.depth;
        let about = |w: &Wrench| w.m - w.x * d;
        let rest = [permanent.x, permanent.p, about(permanent)];
        // c₀ + c·[S, N, M_O] ≥ 0, for the permanent loads and for those that vary.
        let signal = |c: [f64; 3], level: f64| Signal {
            ω: &ω,
            pieces: borne
                .iter()
                .map(|(from, to, waves)| {
                    let mut sum = Wave { level, ..Wave::default() };
                    waves.iter().zip(c).for_each(|(wave, c)| sum.add(wave, c));
                    (*from, *to, sum)
                })
                .collect(),
        };
        let amplified = |c: [f64; 3], most: f64| {
            let [one, other] = [c, c.map(|c| -c)].map(|c| signal(c, 0.0).largest());
            let (value, at) = if other.0 > one.0 { other } else { one };
            if most > 0.0 { (Some(value / most), at) } else { (None, 0.0) }
        };
        let (d_shear, shear_at) = amplified([1.0, 0.0, 0.0], applied(&|w| w.x));
        let (d_moment, moment_at) = amplified([0.0, 0.0, 1.0], applied(&about));
        let b = self.half_width;
        let found = |event: ImpactEvent, level: f64, sides: [[f64; 3]; 2]| {
            let mut found = EventFound { event, time: None, load_factor: f64::INFINITY };
            for c in sides {
                let rest = level + c.iter().zip(rest).map(|(c, w)| c * w).sum::<f64>();
                let time = signal(c, rest).first_zero();
                found.time = [found.time, time].into_iter().flatten().reduce(f64::min);
                let most = signal(c.map(|c| -c), 0.0).largest().0;
                let factor = match () {
                    () if rest <= 0.0 => 0.0,
                    () if most > 0.0 => rest / most,
                    () => f64::INFINITY,
                };
                found.load_factor = found.load_factor.min(factor);
            }
            found
        };
        let mut events = vec![
            found(ImpactEvent::Slip, 0.0, [[1.0, mu, 0.0], [-1.0, mu, 0.0]]),
            found(ImpactEvent::Lift, 0.0, [[0.0, b / 3.0, 1.0], [0.0, b / 3.0, -1.0]]),
        ];
        if let Some(strength) = strength {
            let (n, m) = (-0.5 / b, 1.5 / (b * b));
            events.push(found(ImpactEvent::Yield, strength, [[0.0, n, m], [0.0, n, -m]]));
        }
        Ok(ImpactResponse {
            periods: [TAU / ω[0], TAU / ω[1]],
            heave_period: TAU / ω[2],
            d_shear,
            d_moment,
            largest_at: [shear_at, moment_at],
            events,
            until,
        })
    }

    /// S, N and M_O of the loads that vary: waves between moments at which a load changes.
    fn borne(
        &self,
        ω: &[f64; 3],
        changes: &[(Wrench, HistoryChange)],
        until: f64,
    ) -> Vec<(f64, f64, [Wave; 3])> {
        let shares = self.shares(ω);
        let mut moments: Vec<f64> = changes.iter().map(|(_, change)| change.at).chain([0.0, until]).collect();
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        let pairs = moments.windows(2);
        let at = |from: f64| {
            let mut waves = [Wave::default(); 3];
            for (w, change) in changes.iter().filter(|(_, change)| change.at <= from) {
                let load = [w.x, w.m - w.x * self.depth];
                for (mode, share) in shares.iter().enumerate() {
                    let wave = moved(ω, mode, change, from);
                    for (result, row) in [0, 2].into_iter().zip(share) {
                        waves[result].add(&wave, row[0] * load[0] + row[1] * load[1]);
                    }
                }
                waves[1].add(&moved(ω, 2, change, from), w.p);
            }
            waves
        };
        pairs.map(|pair| (pair[0], pair[1], at(pair[0]))).collect()
    }
}

/// So many of its shortest periods is a body followed at most: a second of work.
const PERIODS_AT_MOST: f64 = 1e5;

/// Motion of a mode that a change of a load adds, in shares of its static displacement, from a moment on.
fn moved(ω: &[f64; 3], mode: usize, change: &HistoryChange, from: f64) -> Wave {
    let past = from - change.at;
    let (sin, cos) = (ω[mode] * past).sin_cos();
    let mut wave = Wave { level: change.step + change.slope * past, slope: change.slope, ..Wave::default() };
    // −step cos ω(past+τ) − slope/ω sin ω(past+τ)
    let slope = change.slope / ω[mode];
    wave.cos[mode] = -change.step * cos - slope * sin;
    wave.sin[mode] = change.step * sin - slope * cos;
    wave
}
