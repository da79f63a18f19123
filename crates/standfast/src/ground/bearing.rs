//! Ground that fails before the body slides or rocks: bearing failure, BF.
//!
//! ```text
//!        ┌──────────┐
//!        │     │    │◄── X
//!        │     ▼ P  │
//!        └──────────┘
//!   ▒▒╲  ▲▲▲▲▲        ▒▒▒      B' = 2(B − e), the width that bears
//!      ╲__╱ ╲_______╱
//! ```
//!
//! The ground bears P ≤ R(P, X, e) per metre run. With the width 2B of the base, ε = e/B the eccentricity of the reaction, η = |X|/P its
//! inclination, and V₀ what the whole base bears centric and upright, u = P/V₀:
//!
//! | law | rest needs | N_γ |
//! |---|---|---|
//! | [`GroundLaw::Ec7`]: EN 1997-1 Annex D, strip | u ≤ (1−ε)²(1−η)³ | 2(N_q − 1) tan φ |
//! | [`GroundLaw::Hansen`]: API RP 2GEO, Brinch Hansen | u ≤ (1−ε)²(1−0.7η)⁵ | 1.5(N_q − 1) tan φ |
//! | [`Ground::undrained`]: EN 1997-1 Annex D, clay that does not drain | P ≤ B' ((π+2) c_u i_c + q) | |
//! | [`Ground::envelope`]: Butterfield & Gottardi | (η/t_h)² + (ε/2t_m)² − Cηε/(t_h t_m) ≤ (1−u)² | |
//!
//! ```text
//! V₀ = 2B² γ' N_γ        N_q = e^(π tan φ) tan²(45° + φ/2)        N_c = (N_q − 1) cot φ
//! R  = B' [c'N_c i_c + q'N_q i_q + ½ γ'B'N_γ i_γ]                 with surcharge q' and cohesion c'
//! ec7     h = X/(P + B'c' cot φ):  i_q = (1−h)²       i_γ = (1−h)³       i_c = i_q − (1−i_q)/(N_c tan φ)
//! hansen                            i_q = (1−0.5h)⁵   i_γ = (1−0.7h)⁵   the same
//! ```
//!
//! Clay that does not drain bears R = B' [(π+2) c_u s_c i_c + q], i_c = ½ (1 + √(1 − |X|/(B' c_u))) and s_c = 1 + 0.2 r; beyond |X| = B' c_u it
//! slides within the clay, and nothing is borne.
//!
//! | symbol | identifier | unit |
//! |---|---|---|
//! | c_u, q | `undrained_strength`, `surcharge` | Pa; q beside the base, less the water where P is less buoyancy |
//! | φ, c' | `friction_angle_deg`, `cohesion` | degrees, Pa |
//! | γ' | `unit_weight` | N/m³, effective: under water less that of water |
//! | q' | `surcharge` | Pa, effective, beside the base |
//! | P, X, e | [`Reaction`] | N per metre run, m |
//!
//! In the k–μ plane of the report's block the ground is a corner of rest and a tongue of sliding; rocking never begins:
//!
//! ```text
//! RE   μ ≥ k, k ≤ k_BF        SL   μ < k, and R ≥ P under η = μ, ε = γ|μ + kk'|        BF   else
//! ```
//!
//! Of a base of a given length L ([`Ground::with_length`]) the terms have the shape factors of the law, with r the shorter of B' and L over the longer; in the
//! last term stands the shorter:
//!
//! ```text
//! ec7     s_γ = 1 − 0.3r       s_q = 1 + r sin φ       s_c = (s_q N_q − 1)/(N_q − 1)   i_q = (1−h)^m, i_γ = (1−h)^(m+1), m = (2 + B'/L)/(1 + B'/L)
//! hansen  s_γ = 1 − 0.4 i_γ r  s_q = 1 + i_q r sin φ   s_c = 1, on the safe side
//! ```
//!
//! Limits of the formulas: level, homogeneous ground. No shoulder of a berm, no layers, no pore pressure or
//! its growth under cycles, no seepage from uplift. The friction angle of a mound is uncertain, and R grows 2.3 times from 35° to 40°: a
//! factor is to be read beside those at φ ± 2° ([`LoadFactors`]). No partial factor is applied.
//!
//! Sources: EN 1997-1 Annex D for c' = q' = 0 and `hansen` with its terms of q' and γ' were read (the latter in the package groundhog
//! 0.15, against which `validation/peers` holds it). i_c, N_c of both, and the sense of C in the envelope, are recalled: a positive
//! C strengthens ground whose eccentricity lies where the force pushes.
//!
//! ```
//! use standfast::ground::bearing::{Ground, GroundLaw, Reaction};
//!
//! let sand = Ground::new(GroundLaw::Hansen, 35.0, 10e3)?;
//! let reaction = Reaction::new(7.5, 2e6, 0.6e6, 1.5)?;
//! assert!(sand.factor(&reaction) > 1.0);
//! # Ok::<(), standfast::InputError>(())
//! ```

mod block;
mod edges;
mod mechanism;
mod path;
mod plane;
mod situated;

pub use block::BearingBlock;
pub use mechanism::FailureShape;
pub use path::{GroundPath, LoadFactors};
pub use plane::{BearingPlane, BearingPoint};
pub use situated::{BearingOutcome, outcome};

pub(super) use edges::FailingEdges;

use self::path::Footing;
use crate::error::{InputError, LARGEST};
use crate::quantity::{Expected, Quantity};
use crate::situation::Situation;

/// A formula for the bearing resistance of drained ground with friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum GroundLaw {
    /// EN 1997-1 Annex D.
    Ec7,
    /// API RP 2GEO, after Brinch Hansen.
    Hansen,
}

/// Law by which the ground bears: soil, for V₀ and the inclination factors, or an envelope in their place.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// `length` is that of the base along the wall, m; infinite of a strip.
    Soil {
        law: GroundLaw,
        angle: Angle,
        unit_weight: f64,
        surcharge: f64,
        cohesion: f64,
        length: f64,
    },
    /// `strength` is c_u, Pa, and `length` as that of soil.
    Undrained {
        strength: f64,
        surcharge: f64,
        length: f64,
    },
    Envelope {
        centric: f64,
        horizontal: f64,
        moment: f64,
        coupling: f64,
    },
}

/// An angle of friction with what the laws make of it, once and not at every reaction.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Angle {
    degrees: f64,
    tan: f64,
    factors: BearingFactors,
}

impl Angle {
    fn new(law: GroundLaw, degrees: f64) -> Angle {
        Angle { degrees, tan: degrees.to_radians().tan(), factors: law.factors(degrees) }
    }
}

/// The ground under a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground {
    kind: Kind,
    /// γ_R, by which what it bears is divided.
    divisor: f64,
}

/// Reaction of a base on the ground, per metre run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction {
    half_width: f64,
    p: f64,
    x: f64,
    e: f64,
}

impl Reaction {
    /// P > 0 (N, down) and X (N, its size or with a sign) on a base of `half_width` B (m), e (m) from its middle. A positive product of X
    /// and e means: e lies on the side that X pushes to.
    ///
    /// # Errors
    /// If `half_width` or `p` is not above zero, or a number is not finite.
    pub fn new(half_width: f64, p: f64, x: f64, e: f64) -> Result<Reaction, InputError> {
        Ok(Reaction {
            half_width: InputError::positive(Quantity::HalfWidth, half_width)?,
            p: InputError::positive(Quantity::WrenchP, p)?,
            x: InputError::finite(Quantity::WrenchX, x)?,
            e: InputError::finite(Quantity::Eccentricity, e)?,
        })
    }

    /// Reaction of the body of a situation that rests under a load factor, per metre run; `None` if nothing presses.
    ///
    /// # Errors
    /// If the base is round.
    pub fn of(situation: &Situation, factor: f64) -> Result<Option<Reaction>, InputError> {
        Ok(Footing::of(situation)?.reaction(factor))
    }

    /// P, N per metre run.
    pub fn p(&self) -> f64 {
        self.p
    }

    /// X, N per metre run.
    pub fn x(&self) -> f64 {
        self.x
    }

    /// e, m: positive times X where it lies on the side that X pushes to.
    pub fn e(&self) -> f64 {
        self.e
    }

    /// B, m.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// η = |X|/P.
    pub fn inclination(&self) -> f64 {
        (self.x / self.p).abs()
    }

    /// ε = |e|/B: at 1 the reaction is at an edge.
    pub fn eccentricity_share(&self) -> f64 {
        (self.e / self.half_width).abs()
    }

    /// B' = 2(B − |e|), m: Meyerhof's effective width; zero where the reaction misses the base.
    pub fn effective_width(&self) -> f64 {
        2.0 * (self.half_width - self.e.abs()).max(0.0)
    }

    /// P/B', Pa; infinite where the reaction misses the base.
    pub fn effective_pressure(&self) -> f64 {
        self.p / self.effective_width()
    }
}

/// N_q, N_c and N_γ of a friction angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFactors {
    /// N_q.
    pub n_q: f64,
    /// N_c.
    pub n_c: f64,
    /// N_γ.
    pub n_gamma: f64,
}

impl GroundLaw {
    /// The bearing capacity factors at an angle of friction in degrees.
    pub fn factors(self, friction_angle_deg: f64) -> BearingFactors {
        let tan = friction_angle_deg.to_radians().tan();
        let n_q =
            (std::f64::consts::PI * tan).exp() * (45.0 + friction_angle_deg / 2.0).to_radians().tan().powi(2);
        let slope = match self {
            GroundLaw::Ec7 => 2.0,
            GroundLaw::Hansen => 1.5,
        };
        BearingFactors { n_q, n_c: (n_q - 1.0) / tan, n_gamma: slope * (n_q - 1.0) * tan }
    }

    /// i_q and i_γ under the inclination h, of a base whose width that bears is this share of its length; zero where the formula ends.
    fn inclined(self, h: f64, of_length: f64) -> [f64; 2] {
        let power = |share: f64, n: i32| (1.0 - share * h).max(0.0).powi(n);
        match self {
            GroundLaw::Ec7 if of_length == 0.0 => [power(1.0, 2), power(1.0, 3)],
            GroundLaw::Ec7 => {
                let m = inclination_exponent(of_length);
                [m, m + 1.0].map(|n| (1.0 - h).max(0.0).powf(n))
            }
            GroundLaw::Hansen => [power(0.5, 5), power(0.7, 5)],
        }
    }

    /// s_c, s_q and s_γ of a base that is not long.
    fn shape(self, angle: &Angle, of_length: f64, [i_q, i_gamma]: [f64; 2]) -> [f64; 3] {
        // The shorter side over the longer.
        let share = of_length.min(of_length.recip());
        let sin = angle.degrees.to_radians().sin();
        match self {
            GroundLaw::Ec7 => {
                let (n_q, s_q) = (angle.factors.n_q, 1.0 + share * sin);
                [(s_q * n_q - 1.0) / (n_q - 1.0), s_q, 1.0 - 0.3 * share]
            }
            GroundLaw::Hansen => [1.0, 1.0 + i_q * share * sin, 1.0 - 0.4 * i_gamma * share],
        }
    }
}

/// m_B of EN 1997-1 Annex D, where the push is across a base whose width that bears is this share of its length.
pub fn inclination_exponent(of_length: f64) -> f64 {
    (2.0 + of_length) / (1.0 + of_length)
}

/// N_c of clay that does not drain, π + 2.
const N_C_UNDRAINED: f64 = std::f64::consts::PI + 2.0;

/// The least and the largest angle of friction taken, degrees.
const ANGLES: [f64; 2] = [20.0, 50.0];

impl Ground {
    fn undivided(kind: Kind) -> Ground {
        Ground { kind, divisor: 1.0 }
    }

    /// The same ground with what it bears, R, divided by a partial factor γ_R once more.
    pub fn divided(&self, by: f64) -> Ground {
        Ground { divisor: self.divisor * by, ..*self }
    }

    /// γ_R, the partial factor by which R is divided; 1 if nothing was said.
    pub fn divisor(&self) -> f64 {
        self.divisor
    }

    /// Drained ground: its angle of friction in degrees, from 20 to 50, and its effective unit weight (N/m³).
    ///
    /// # Errors
    /// If `friction_angle_deg` is outside 20° to 50°, or `unit_weight` not above zero.
    pub fn new(law: GroundLaw, friction_angle_deg: f64, unit_weight: f64) -> Result<Ground, InputError> {
        let [least, most] = ANGLES;
        let angle_deg = InputError::within(
            Quantity::GroundFrictionAngle,
            friction_angle_deg,
            least,
            most,
            Expected::GroundAngle,
        )?;
        let unit_weight = InputError::positive(Quantity::UnitWeight, unit_weight)?;
        let angle = Angle::new(law, angle_deg);
        let (surcharge, cohesion, length) = (0.0, 0.0, f64::INFINITY);
        Ok(Ground::undivided(Kind::Soil { law, angle, unit_weight, surcharge, cohesion, length }))
    }

    /// Clay that does not drain, by its undrained shear strength c_u (Pa): EN 1997-1 Annex D.
    ///
    /// # Errors
    /// If it is not above zero.
    ///
    /// ```
    /// use standfast::ground::bearing::{Ground, Reaction};
    ///
    /// let clay = Ground::undrained(60e3)?;
    /// let upright = Reaction::new(5.0, 1e6, 0.0, 0.0)?;
    /// assert!((clay.resistance(&upright) - 10.0 * 5.14159 * 60e3).abs() < 10.0);
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    pub fn undrained(strength: f64) -> Result<Ground, InputError> {
        let strength = InputError::positive(Quantity::UndrainedStrength, strength)?;
        Ok(Ground::undivided(Kind::Undrained { strength, surcharge: 0.0, length: f64::INFINITY }))
    }

    /// Ground known by what it bears centric and upright, V₀ (N per metre run), and by Butterfield & Gottardi's envelope with their
    /// t_h = 0.52, t_m = 0.35, C = 0.22.
    ///
    /// # Errors
    /// If `centric_resistance` is not above zero.
    pub fn envelope(centric_resistance: f64) -> Result<Ground, InputError> {
        Ground::envelope_with(centric_resistance, 0.52, 0.35, 0.22)
    }

    /// Ground with other slopes of the envelope at no load, and another coupling.
    ///
    /// # Errors
    /// If V₀, t_h or t_m is not above zero, or C is not from −1 to 1.
    pub fn envelope_with(
        centric_resistance: f64,
        horizontal: f64,
        moment: f64,
        coupling: f64,
    ) -> Result<Ground, InputError> {
        let expected = Expected::CouplingBelowOne;
        Ok(Ground::undivided(Kind::Envelope {
            centric: InputError::positive(Quantity::CentricResistance, centric_resistance)?,
            horizontal: InputError::positive(Quantity::EnvelopeSlope, horizontal)?,
            moment: InputError::positive(Quantity::EnvelopeSlope, moment)?,
            coupling: InputError::within(Quantity::EnvelopeCoupling, coupling, -1.0, 1.0, expected)?,
        }))
    }

    /// Ground with an effective pressure of ground beside the base, q' (Pa). It means nothing to an envelope, which is returned as it is.
    ///
    /// # Errors
    /// If it is negative or not finite.
    pub fn with_surcharge(mut self, pressure: f64) -> Result<Ground, InputError> {
        let pressure = InputError::not_negative(Quantity::Surcharge, pressure)?;
        if let Kind::Soil { surcharge, .. } | Kind::Undrained { surcharge, .. } = &mut self.kind {
            *surcharge = pressure;
        }
        Ok(self)
    }

    /// Ground with effective cohesion c' (Pa). It means nothing to clay that does not drain and to an envelope, which are returned as they are.
    ///
    /// # Errors
    /// If it is negative or not finite.
    pub fn with_cohesion(mut self, stress: f64) -> Result<Ground, InputError> {
        let stress = InputError::not_negative(Quantity::Cohesion, stress)?;
        if let Kind::Soil { cohesion, .. } = &mut self.kind {
            *cohesion = stress;
        }
        Ok(self)
    }

    /// Ground under a base of this length (m), with the shape factors of its law; forces stay those per metre run. It means nothing to an
    /// envelope, which is returned as it is.
    ///
    /// # Errors
    /// If it is not above zero.
    pub fn with_length(mut self, base: f64) -> Result<Ground, InputError> {
        let base = InputError::positive(Quantity::Length, base)?;
        if let Kind::Soil { length, .. } | Kind::Undrained { length, .. } = &mut self.kind {
            *length = base;
        }
        Ok(self)
    }

    /// The length of the base along the wall, m; `None` of a strip, and of an envelope.
    pub fn length(&self) -> Option<f64> {
        match self.kind {
            Kind::Soil { length, .. } | Kind::Undrained { length, .. } => {
                Some(length).filter(|length| length.is_finite())
            }
            Kind::Envelope { .. } => None,
        }
    }

    /// Ground at another angle of friction, `by` degrees more; `None` of ground that has none. It may leave 20° to 50° by that.
    pub fn turned(&self, by: f64) -> Option<Ground> {
        match self.kind {
            Kind::Soil { law, angle, unit_weight, surcharge, cohesion, length } => {
                let angle = Angle::new(law, angle.degrees + by);
                let kind = Kind::Soil { law, angle, unit_weight, surcharge, cohesion, length };
                Some(Ground { kind, ..*self })
            }
            Kind::Undrained { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// The formula of drained ground; `None` of other ground.
    pub fn law(&self) -> Option<GroundLaw> {
        match self.kind {
            Kind::Soil { law, .. } => Some(law),
            Kind::Undrained { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// The angle of friction in degrees; `None` of ground without one.
    pub fn friction_angle_deg(&self) -> Option<f64> {
        match self.kind {
            Kind::Soil { angle, .. } => Some(angle.degrees),
            Kind::Undrained { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// The effective unit weight, N/m³, where R depends on it.
    pub fn unit_weight(&self) -> Option<f64> {
        match self.kind {
            Kind::Soil { unit_weight, .. } => Some(unit_weight),
            Kind::Undrained { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// c_u, Pa, of clay that does not drain; `None` of other ground.
    pub fn undrained_strength(&self) -> Option<f64> {
        match self.kind {
            Kind::Undrained { strength, .. } => Some(strength),
            Kind::Soil { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// True if a given resistance of the whole base is shared out by an envelope.
    pub fn is_envelope(&self) -> bool {
        matches!(self.kind, Kind::Envelope { .. })
    }

    /// N_q, N_c, N_γ; `None` of ground without an angle of friction.
    pub fn factors(&self) -> Option<BearingFactors> {
        match self.kind {
            Kind::Soil { angle, .. } => Some(angle.factors),
            Kind::Undrained { .. } | Kind::Envelope { .. } => None,
        }
    }

    /// V₀, N per metre run: what a base of `half_width` B (m) bears centric and upright.
    pub fn centric_resistance(&self, half_width: f64) -> f64 {
        let whole = match self.kind {
            Kind::Envelope { centric, .. } => centric,
            Kind::Undrained { length, .. } | Kind::Soil { length, .. } if length.is_finite() => {
                return self.resistance(&Reaction { half_width, p: 1.0, x: 0.0, e: 0.0 });
            }
            Kind::Soil { angle, unit_weight, surcharge, cohesion, .. } => {
                let BearingFactors { n_q, n_c, n_gamma } = angle.factors;
                2.0 * half_width * (cohesion * n_c + surcharge * n_q + unit_weight * half_width * n_gamma)
            }
            Kind::Undrained { strength, surcharge, .. } => {
                2.0 * half_width * (N_C_UNDRAINED * strength + surcharge)
            }
        };
        whole / self.divisor
    }

    /// R, N per metre run: the vertical load that the ground bears at the reaction's inclination and eccentricity; zero where the reaction
    /// misses the base.
    pub fn resistance(&self, reaction: &Reaction) -> f64 {
        let Reaction { half_width, p, x, e } = *reaction;
        let whole = match self.kind {
            Kind::Soil { law, angle, unit_weight, surcharge, cohesion, length } => {
                let width = reaction.effective_width();
                let of_length = width / length;
                let Angle { tan, factors: BearingFactors { n_q, n_c, n_gamma }, .. } = angle;
                let inclined = law.inclined(x.abs() / (p + width * cohesion / tan), of_length);
                let [i_q, i_gamma] = inclined;
                let i_c = (i_q - (1.0 - i_q) / (n_c * tan)).max(0.0);
                let [s_c, s_q, s_gamma] =
                    if of_length > 0.0 { law.shape(&angle, of_length, inclined) } else { [1.0; 3] };
                width
                    * (cohesion * n_c * s_c * i_c
                        + surcharge * n_q * s_q * i_q
                        + unit_weight * width.min(length) / 2.0 * n_gamma * s_gamma * i_gamma)
            }
            Kind::Undrained { strength, surcharge, length } => {
                let width = reaction.effective_width();
                let adheres = width * strength;
                if x.abs() > adheres || width == 0.0 {
                    return 0.0;
                }
                let i_c = 0.5 * (1.0 + (1.0 - x.abs() / adheres).sqrt());
                let of_length = width / length;
                let s_c = if of_length > 0.0 { 1.0 + 0.2 * of_length.min(of_length.recip()) } else { 1.0 };
                width * (N_C_UNDRAINED * strength * s_c * i_c + surcharge)
            }
            Kind::Envelope { centric, horizontal, moment, coupling } => {
                let (η, ε) = ((x / p).abs(), e / half_width * (x * e).signum() * e.signum());
                let radius = (η / horizontal).powi(2) + (ε / (2.0 * moment)).powi(2)
                    - coupling * η * ε / (horizontal * moment);
                if ε.abs() >= 1.0 { 0.0 } else { centric * (1.0 - radius.max(0.0).sqrt()).max(0.0) }
            }
        };
        whole / self.divisor
    }

    /// No more than R of any reaction between two, whose P and X are between theirs and whose e and inclination are so too.
    fn least_resistance(&self, one: &Reaction, other: &Reaction) -> f64 {
        let half_width = one.half_width;
        let e = one.e.abs().max(other.e.abs());
        match self.kind {
            // R falls with the eccentricity and the inclination, and under one inclination with P where there is cohesion, or no drainage.
            Kind::Soil { .. } | Kind::Undrained { .. } => {
                let p = one.p.max(other.p);
                let x = one.inclination().max(other.inclination()) * p;
                self.resistance(&Reaction { half_width, p, x, e })
            }
            Kind::Envelope { centric, horizontal, moment, coupling } => {
                // η and ε on the side that X pushes to, each with its least and largest value.
                let inclinations = [one, other].map(|at| at.x / at.p);
                let shares = [one, other].map(|at| at.e / half_width);
                let turns = inclinations[0].is_sign_negative() != inclinations[1].is_sign_negative();
                let η = inclinations.map(f64::abs);
                let η = [if turns { 0.0 } else { η[0].min(η[1]) }, η[0].max(η[1])];
                let ε = if turns {
                    [-e / half_width, e / half_width]
                } else {
                    shares.map(|share| share * inclinations[0].signum())
                };
                let coupled = η.iter().flat_map(|η| ε.map(|ε| -coupling * η * ε)).fold(f64::MIN, f64::max);
                let radius = (η[1] / horizontal).powi(2)
                    + (e / half_width / (2.0 * moment)).powi(2)
                    + coupled / (horizontal * moment);
                let whole =
                    if e >= half_width { 0.0 } else { centric * (1.0 - radius.max(0.0).sqrt()).max(0.0) };
                whole / self.divisor
            }
        }
    }

    /// The eccentricity, as a share of B and on the side that X pushes to, at which the ground bears most under the inclination η.
    fn best_eccentricity(&self, inclination: f64) -> f64 {
        match self.kind {
            Kind::Soil { .. } | Kind::Undrained { .. } => 0.0,
            Kind::Envelope { horizontal, moment, coupling, .. } => {
                (2.0 * coupling * inclination * moment / horizontal).clamp(-0.999, 0.999)
            }
        }
    }

    /// The law by name: `ec7`, `hansen`, `undrained` or `envelope`.
    pub fn law_name(&self) -> &'static str {
        match self.kind {
            Kind::Soil { law: GroundLaw::Ec7, .. } => "ec7",
            Kind::Soil { law: GroundLaw::Hansen, .. } => "hansen",
            Kind::Undrained { .. } => "undrained",
            Kind::Envelope { .. } => "envelope",
        }
    }

    /// R/P.
    pub fn factor(&self, reaction: &Reaction) -> f64 {
        self.resistance(reaction) / reaction.p
    }

    /// True if the ground bears the reaction: R ≥ P.
    pub fn bears(&self, reaction: &Reaction) -> bool {
        self.resistance(reaction) >= reaction.p && reaction.p < LARGEST
    }
}
