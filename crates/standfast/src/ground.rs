//! What the base can bear: when the ground under a body changes its verdict.
//!
//! ```text
//!        rigid              strength             ground             stiffness
//!      ┌───────┐            ┌───────┐           ┌───────┐           ┌───────┐
//!      │       │            │       │           │       │           │       │
//!      └───────┘            └───────┘           └───────┘           └───────┘
//!    ▒▒▒▒▒▒▒▒▒▒▒▒▒        ▒▒▲▲▒▒▒▒▒▒▒▒▒       ╲▒▒▒▒▒▒▒▒▒╱▒▒         ╪ ╪ ╪ ╪ ╪
//!      the corner         q_u, neutral         ╲_______╱          k_n, k_t
//!                            point                BF
//! ```
//!
//! | question | start at |
//! |---|---|
//! | Which mode begins on a base that crushes at q_u? The k–μ plane of it? | [`strength`] |
//! | Does the ground fail before the body slides or rocks? | [`bearing`] |
//! | How far does an elastic base let the body turn, and when does it topple? | [`elastic`] |
//! | When is a short peak force not a static one? | [`impact`] |
//! | What begins at which load factor and friction? | [`load_plane`] |
//! | What begins for every friction under given loads? | [`strength::friction_spans`], [`bearing::BearingBlock`] |
//!
//! Everything else of this library stands on rigid ground. No partial factor is applied here.

pub mod bearing;
pub mod elastic;
pub mod impact;
pub mod load_plane;
mod roots;
pub mod strength;

use std::fmt;

use crate::mode::{Mode, Modes};

/// What a body on ground that can fail does.
///
/// ```
/// use standfast::Mode;
/// use standfast::ground::GroundVerdict;
///
/// assert_eq!(GroundVerdict::Begins(Mode::SlideLeft).symbol(), "SL");
/// assert_eq!(GroundVerdict::BearingFailure.symbol(), "BF");
/// for code in 0..=GroundVerdict::BEARING_FAILURE_CODE {
///     assert_eq!(GroundVerdict::from_code(code).unwrap().code(), code);
/// }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum GroundVerdict {
    /// A mode begins; [`Mode::Rest`] is one.
    Begins(Mode),
    /// BF: the ground fails. No motion is given.
    BearingFailure,
}

impl GroundVerdict {
    /// The code of BF in arrays; those of modes are below.
    pub const BEARING_FAILURE_CODE: u8 = Mode::ALL.len() as u8;

    /// The mode; `None` if the ground fails.
    pub fn mode(self) -> Option<Mode> {
        match self {
            GroundVerdict::Begins(mode) => Some(mode),
            GroundVerdict::BearingFailure => None,
        }
    }

    /// The mode's symbol, or `BF`.
    pub const fn symbol(self) -> &'static str {
        match self {
            GroundVerdict::Begins(mode) => mode.symbol(),
            GroundVerdict::BearingFailure => "BF",
        }
    }

    /// In words, as a predicate of "the body".
    pub fn words(self) -> &'static str {
        match self {
            GroundVerdict::Begins(mode) => mode.words(),
            GroundVerdict::BearingFailure => "stands on ground that fails",
        }
    }

    /// The code in arrays: the mode's, or [`BEARING_FAILURE_CODE`](GroundVerdict::BEARING_FAILURE_CODE).
    pub fn code(self) -> u8 {
        self.mode().map_or(GroundVerdict::BEARING_FAILURE_CODE, Mode::code)
    }

    /// What has this code.
    pub fn from_code(code: u8) -> Option<GroundVerdict> {
        match Mode::from_code(code) {
            Some(mode) => Some(GroundVerdict::Begins(mode)),
            None if code == GroundVerdict::BEARING_FAILURE_CODE => Some(GroundVerdict::BearingFailure),
            None => None,
        }
    }

    /// The verdict seen in a mirror.
    pub fn mirrored(self) -> GroundVerdict {
        match self {
            GroundVerdict::Begins(mode) => GroundVerdict::Begins(mode.mirrored()),
            GroundVerdict::BearingFailure => self,
        }
    }
}

impl fmt::Display for GroundVerdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.symbol())
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for GroundVerdict {
    /// The symbol.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.symbol())
    }
}

/// Where a body on ground that can fail leaves rest as its variable loads rise from nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GroundDeparture {
    /// For no load factor above zero.
    Never,
    /// It does not rest to begin with.
    AtOnce {
        /// What it does.
        verdict: Option<GroundVerdict>,
        /// Whether the permanent loads alone do it; otherwise any share of the variable loads does.
        permanent: bool,
    },
    /// At a load factor.
    At {
        /// λ > 0.
        factor: f64,
        /// What it leaves rest into.
        verdict: Option<GroundVerdict>,
    },
}

/// A stretch of load factors with the same modes, on ground that can fail.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GroundStage {
    /// The load factor at which it begins.
    pub from: f64,
    /// The load factor at which it ends; infinite for the last.
    pub to: f64,
    /// What is reported.
    pub verdict: Option<GroundVerdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
}

/// Frictions with the same modes, on ground that can fail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundSpan {
    /// The friction μ_s at which it begins; 0 for the first.
    pub from: f64,
    /// The friction at which it ends; infinite for the last.
    pub to: f64,
    /// What is reported.
    pub verdict: Option<GroundVerdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
    /// Which boundary is at `from`, by a number; 0 for the first span. As long as verdicts, modes and numbers stay the same, the ends of
    /// the spans are smooth functions of block and wrench.
    pub boundary: usize,
}

impl GroundSpan {
    /// Adds what holds from one friction to another, to the last span if it holds there too.
    fn push(self, spans: &mut Vec<GroundSpan>) {
        match spans.last_mut() {
            Some(last) if (last.verdict, last.modes) == (self.verdict, self.modes) => last.to = self.to,
            _ => spans.push(self),
        }
    }
}

impl GroundStage {
    /// The consistent modes beside the one reported.
    pub fn others(&self) -> Modes {
        self.modes.without(self.verdict.and_then(GroundVerdict::mode))
    }
}

impl GroundDeparture {
    /// Where a path that begins with `begin` first leaves rest.
    fn along(begin: Option<GroundVerdict>, path: &[GroundStage]) -> GroundDeparture {
        let rest = Some(GroundVerdict::Begins(Mode::Rest));
        if begin != rest {
            // As soon as anything is added, it may be another mode.
            let verdict =
                path.first().map_or(begin, |stage| stage.verdict).filter(|verdict| Some(*verdict) != rest);
            return GroundDeparture::AtOnce { verdict: verdict.or(begin), permanent: true };
        }
        match path.iter().find(|stage| stage.verdict != rest) {
            None => GroundDeparture::Never,
            Some(stage) if stage.from == 0.0 => {
                GroundDeparture::AtOnce { verdict: stage.verdict, permanent: false }
            }
            Some(stage) => GroundDeparture::At { factor: stage.from, verdict: stage.verdict },
        }
    }

    /// What the body leaves rest into.
    pub fn verdict(&self) -> Option<GroundVerdict> {
        match *self {
            GroundDeparture::Never => None,
            GroundDeparture::AtOnce { verdict, .. } | GroundDeparture::At { verdict, .. } => verdict,
        }
    }

    /// The load factor up to which the body rests: zero if it moves at once, infinite if it never does.
    pub fn load_factor(&self) -> f64 {
        match *self {
            GroundDeparture::Never => f64::INFINITY,
            GroundDeparture::AtOnce { .. } => 0.0,
            GroundDeparture::At { factor, .. } => factor,
        }
    }
}
