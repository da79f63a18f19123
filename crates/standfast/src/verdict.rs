//! Verdicts on a body as a load is applied: a mode begins, or the ground fails.

use std::fmt;

use crate::mode::{Mode, Modes};

/// Verdict on a body under a load, on any base. On a rigid one a mode always begins; that nothing is consistent is the lack of a verdict.
///
/// ```
/// use standfast::{Mode, Verdict};
///
/// assert_eq!(Verdict::Begins(Mode::SlideLeft).symbol(), "SL");
/// assert_eq!(Verdict::BearingFailure.symbol(), "BF");
/// for code in 0..=Verdict::BEARING_FAILURE_CODE {
///     assert_eq!(Verdict::from_code(code).unwrap().code(), code);
/// }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// A mode begins; [`Mode::Rest`] is one.
    Begins(Mode),
    /// BF: the ground fails. No motion is given.
    BearingFailure,
}

impl Verdict {
    /// Rest.
    pub const REST: Verdict = Verdict::Begins(Mode::Rest);

    /// The code of BF in arrays; those of modes are below.
    pub const BEARING_FAILURE_CODE: u8 = Mode::ALL.len() as u8;

    /// The mode; `None` if the ground fails.
    pub fn mode(self) -> Option<Mode> {
        match self {
            Verdict::Begins(mode) => Some(mode),
            Verdict::BearingFailure => None,
        }
    }

    /// The mode's symbol, or `BF`.
    pub const fn symbol(self) -> &'static str {
        match self {
            Verdict::Begins(mode) => mode.symbol(),
            Verdict::BearingFailure => "BF",
        }
    }

    /// The words for it, as a predicate of "the body".
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Begins(mode) => mode.words(),
            Verdict::BearingFailure => "stands on ground that fails",
        }
    }

    /// The code in arrays: the mode's, or [`BEARING_FAILURE_CODE`](Verdict::BEARING_FAILURE_CODE).
    pub fn code(self) -> u8 {
        self.mode().map_or(Verdict::BEARING_FAILURE_CODE, Mode::code)
    }

    /// The verdict of a code.
    pub fn from_code(code: u8) -> Option<Verdict> {
        match Mode::from_code(code) {
            Some(mode) => Some(Verdict::Begins(mode)),
            None if code == Verdict::BEARING_FAILURE_CODE => Some(Verdict::BearingFailure),
            None => None,
        }
    }

    /// The verdict seen in a mirror.
    pub fn mirrored(self) -> Verdict {
        match self {
            Verdict::Begins(mode) => Verdict::Begins(mode.mirrored()),
            Verdict::BearingFailure => self,
        }
    }
}

/// Decision on a body under a load: the verdict reported, and all that is consistent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decision {
    /// The verdict reported. For μ_s = μ_k there always is one; for μ_s > μ_k that is not proven, and `None` would say so.
    pub verdict: Option<Verdict>,
    /// All consistent modes; none where the ground fails.
    pub modes: Modes,
}

impl Decision {
    /// The mode reported; `None` where the ground fails, too.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict.and_then(Verdict::mode)
    }
}

/// A verdict with no other mode beside it.
impl From<Option<Verdict>> for Decision {
    fn from(verdict: Option<Verdict>) -> Decision {
        Decision { verdict, modes: verdict.and_then(Verdict::mode).into_iter().collect() }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.symbol())
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Verdict {
    /// The symbol.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.symbol())
    }
}
