//! Limit states: how far is a point from each inequality that decides its mode?
//!
//! Each is one expression in γ, k', k and μ, without cases, so that reliability methods can follow its gradient, and negative where
//! what it is named for happens. Their signs are those of exact arithmetic. Together they decide the mode; the first line that
//! holds does:
//!
//! | mode | if |
//! |---|---|
//! | RE | `slide` ≥ 0, `rock_o` ≥ 0 and `rock_o_prime` ≥ 0 |
//! | SL | `slide` < 0, `turn_o` ≥ 0 and `turn_o_prime` ≥ 0 |
//! | RO' | `rock_o_prime` < 0 and `slip_o_prime_left` ≥ 0 |
//! | SRO'- | `turn_o_prime` < 0 |
//! | SRO- | `slip_o_left` < 0 |
//! | SRO+ | `slip_o_right` < 0 |
//! | RO | else |
//!
//! Of a force that points right, [`mirrored`](LimitStates::mirrored), the same holds with left and right, O and O' exchanged.

use super::Point;
use super::polynomials::Terms;
use crate::approx::Approx;
use crate::exact::{Exact, Real};
use crate::mode::Corner;

/// The limit states of a [`Point`]: negative where what they are named for happens.
///
/// λ = θ̈ of a rock without slip about O, 3(γk(1+k') − 1)/(4(1+γ²)), and λ' = −3(1 + γk(1+k'))/(4(1+γ²)), of one about O', clockwise
/// positive, give the reactions in which the four `slip_*` are written.
///
/// ```
/// use standfast::Point;
///
/// let states = Point::new(1.0, 0.4, 0.5, 0.6)?.limit_states();
/// assert!((states.slide - 0.1).abs() < 1e-12 && (states.rock_o - 0.3).abs() < 1e-12);
/// assert_eq!(states.load_factor, 1.2);
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitStates {
    /// The body slides: μ − k, in m g (3.4, 4.7).
    pub slide: f64,
    /// The body at rest overturns about O: 1 − γk(1+k'), the distance of the reaction from O in B (3.5, 4.10).
    pub rock_o: f64,
    /// It overturns about O': 1 + γk(1+k'), the distance of the reaction from O' in B (4.10 about O').
    pub rock_o_prime: f64,
    /// The sliding body turns about O: 1 − γ(μ + kk'), the distance of the reaction from O in B (after 3.8, 4.19).
    pub turn_o: f64,
    /// It turns about O': 1 + γ(μ + kk'), the distance of the reaction from O' in B (4.18, 4.92).
    pub turn_o_prime: f64,
    /// O slips to the left under the body that rocks about it: μf_y − f_x, in m g (3.24, 3.40; 4.40, 4.77).
    pub slip_o_left: f64,
    /// O slips to the right: μf_y + f_x of the same rock, in m g (3.24, 3.45).
    pub slip_o_right: f64,
    /// O' slips to the left under the body that rocks about it: μf_y − f_x, in m g (4.96).
    pub slip_o_prime_left: f64,
    /// O' slips to the right: μf_y + f_x of the same rock, in m g. A force to the left never decides by it.
    pub slip_o_prime_right: f64,
    /// The multiple of the force at which the body leaves rest, the lesser of both factors; infinite at k = 0.
    pub load_factor: f64,
    /// μ/k; infinite at k = 0.
    pub sf_sliding: f64,
    /// 1/(γk|1+k'|); infinite where the force has no moment about the corner it would tip the body over.
    pub sf_overturning: f64,
}

/// The name of one of the [`LimitStates`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "they are those of the fields")]
pub enum LimitState {
    Slide,
    RockO,
    RockOPrime,
    TurnO,
    TurnOPrime,
    SlipOLeft,
    SlipORight,
    SlipOPrimeLeft,
    SlipOPrimeRight,
    LoadFactor,
    SfSliding,
    SfOverturning,
}

impl LimitState {
    /// All, in the order of the fields.
    pub const ALL: [LimitState; 12] = [
        LimitState::Slide,
        LimitState::RockO,
        LimitState::RockOPrime,
        LimitState::TurnO,
        LimitState::TurnOPrime,
        LimitState::SlipOLeft,
        LimitState::SlipORight,
        LimitState::SlipOPrimeLeft,
        LimitState::SlipOPrimeRight,
        LimitState::LoadFactor,
        LimitState::SfSliding,
        LimitState::SfOverturning,
    ];

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            LimitState::Slide => "slide",
            LimitState::RockO => "rock_O",
            LimitState::RockOPrime => "rock_O_prime",
            LimitState::TurnO => "turn_O",
            LimitState::TurnOPrime => "turn_O_prime",
            LimitState::SlipOLeft => "slip_O_left",
            LimitState::SlipORight => "slip_O_right",
            LimitState::SlipOPrimeLeft => "slip_O_prime_left",
            LimitState::SlipOPrimeRight => "slip_O_prime_right",
            LimitState::LoadFactor => "load_factor",
            LimitState::SfSliding => "SF_sliding",
            LimitState::SfOverturning => "SF_overturning",
        }
    }

    /// Its value of those of a point.
    pub fn of(self, states: &LimitStates) -> f64 {
        match self {
            LimitState::Slide => states.slide,
            LimitState::RockO => states.rock_o,
            LimitState::RockOPrime => states.rock_o_prime,
            LimitState::TurnO => states.turn_o,
            LimitState::TurnOPrime => states.turn_o_prime,
            LimitState::SlipOLeft => states.slip_o_left,
            LimitState::SlipORight => states.slip_o_right,
            LimitState::SlipOPrimeLeft => states.slip_o_prime_left,
            LimitState::SlipOPrimeRight => states.slip_o_prime_right,
            LimitState::LoadFactor => states.load_factor,
            LimitState::SfSliding => states.sf_sliding,
            LimitState::SfOverturning => states.sf_overturning,
        }
    }

    /// Its value at a point, without those of the others.
    #[inline]
    pub fn at(self, point: &Point) -> f64 {
        self.of_terms(point, &Terms::of(point.numbers()))
    }

    /// Its value at a point of these terms.
    #[inline]
    fn of_terms(self, point: &Point, terms: &Terms<Approx>) -> f64 {
        let (value, is_told) = self.screened(point, terms);
        if is_told { value } else { self.exactly(point, terms) }
    }

    /// Its value by floating point, and whether its sign is certain. No branches: columns of it vectorise.
    #[inline(always)]
    pub(crate) fn screened(self, point: &Point, terms: &Terms<Approx>) -> (f64, bool) {
        match self.polynomial(terms) {
            Some(polynomial) => (self.by(point, terms, polynomial.value()), polynomial.is_told()),
            None => (self.by(point, terms, 0.0), true),
        }
    }

    /// Its value where floating point cannot tell the sign: by the exact polynomial, rounded once.
    #[cold]
    fn exactly(self, point: &Point, terms: &Terms<Approx>) -> f64 {
        let polynomial = self.polynomial(&Terms::<Exact>::of(point.numbers()));
        self.by(point, terms, polynomial.map_or(0.0, |polynomial| polynomial.to_f64()))
    }

    /// Whether it is made of the force's moment, and whether of D, M or G beside it.
    #[inline(always)]
    pub(crate) fn needs(self) -> (bool, bool) {
        match self {
            LimitState::Slide
            | LimitState::LoadFactor
            | LimitState::SfSliding
            | LimitState::SfOverturning => (false, false),
            LimitState::RockO | LimitState::RockOPrime => (true, false),
            _ => (true, true),
        }
    }

    /// The polynomial that it is made of, if it is.
    #[inline(always)]
    fn polynomial<T: Real>(self, terms: &Terms<T>) -> Option<T> {
        Some(match self {
            LimitState::RockO => terms.tip(Corner::O),
            LimitState::RockOPrime => terms.tip(Corner::OPrime),
            LimitState::TurnO => terms.turn(Corner::O),
            LimitState::TurnOPrime => terms.turn(Corner::OPrime),
            LimitState::SlipOLeft => terms.slip_left(Corner::O),
            LimitState::SlipORight => terms.slip_right(Corner::O),
            LimitState::SlipOPrimeLeft => terms.slip_left(Corner::OPrime),
            LimitState::SlipOPrimeRight => terms.slip_right(Corner::OPrime),
            LimitState::Slide
            | LimitState::LoadFactor
            | LimitState::SfSliding
            | LimitState::SfOverturning => return None,
        })
    }

    /// Its value, by that of its polynomial.
    #[inline(always)]
    fn by(self, point: &Point, terms: &Terms<Approx>, polynomial: f64) -> f64 {
        match self {
            LimitState::Slide => point.mu - point.k,
            // `0.0 − x` rather than `−x`, so that nothing becomes −0.
            LimitState::RockO | LimitState::RockOPrime | LimitState::TurnO | LimitState::TurnOPrime => {
                0.0 - polynomial
            }
            // What the polynomials of slip are multiplied out by: μf_y ∓ f_x of the rock is theirs over 4(1+γ²).
            LimitState::SlipOLeft
            | LimitState::SlipORight
            | LimitState::SlipOPrimeLeft
            | LimitState::SlipOPrimeRight => polynomial / terms.inertia.value(),
            LimitState::LoadFactor => point.safety_against_sliding().min(point.safety_against_overturning()),
            LimitState::SfSliding => point.safety_against_sliding(),
            LimitState::SfOverturning => point.safety_against_overturning(),
        }
    }

    /// That of the mirror image, which has its value under a force that points right.
    pub fn mirrored(self) -> LimitState {
        match self {
            LimitState::RockO => LimitState::RockOPrime,
            LimitState::RockOPrime => LimitState::RockO,
            LimitState::TurnO => LimitState::TurnOPrime,
            LimitState::TurnOPrime => LimitState::TurnO,
            LimitState::SlipOLeft => LimitState::SlipOPrimeRight,
            LimitState::SlipORight => LimitState::SlipOPrimeLeft,
            LimitState::SlipOPrimeLeft => LimitState::SlipORight,
            LimitState::SlipOPrimeRight => LimitState::SlipOLeft,
            other => other,
        }
    }
}

impl LimitStates {
    pub(super) fn of(point: &Point) -> LimitStates {
        let terms = Terms::of(point.numbers());
        let at = |state: LimitState| state.of_terms(point, &terms);
        LimitStates {
            slide: at(LimitState::Slide),
            rock_o: at(LimitState::RockO),
            rock_o_prime: at(LimitState::RockOPrime),
            turn_o: at(LimitState::TurnO),
            turn_o_prime: at(LimitState::TurnOPrime),
            slip_o_left: at(LimitState::SlipOLeft),
            slip_o_right: at(LimitState::SlipORight),
            slip_o_prime_left: at(LimitState::SlipOPrimeLeft),
            slip_o_prime_right: at(LimitState::SlipOPrimeRight),
            load_factor: at(LimitState::LoadFactor),
            sf_sliding: at(LimitState::SfSliding),
            sf_overturning: at(LimitState::SfOverturning),
        }
    }

    /// Those of the mirror image: a force that points right.
    pub fn mirrored(self) -> LimitStates {
        LimitStates {
            rock_o: self.rock_o_prime,
            rock_o_prime: self.rock_o,
            turn_o: self.turn_o_prime,
            turn_o_prime: self.turn_o,
            slip_o_left: self.slip_o_prime_right,
            slip_o_right: self.slip_o_prime_left,
            slip_o_prime_left: self.slip_o_right,
            slip_o_prime_right: self.slip_o_left,
            ..self
        }
    }
}
