//! The modes of response: how a body that was at rest begins to move.

use std::fmt;
use std::str::FromStr;

/// Bottom corner that a rocking body turns about.
///
/// ```text
///      ┌──────────┐
///      │    C     │ ◄── F
///      │          │
///      O──────────O'
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum Corner {
    /// O, bottom left: the heel under a force that points left.
    O,
    /// O', bottom right: the toe under a force that points left.
    OPrime,
}

impl Corner {
    /// Its letter: O, or O'.
    pub fn letter(self) -> &'static str {
        match self {
            Corner::O => "O",
            Corner::OPrime => "O'",
        }
    }

    /// The other corner.
    pub fn opposite(self) -> Corner {
        match self {
            Corner::O => Corner::OPrime,
            Corner::OPrime => Corner::O,
        }
    }
}

/// A direction of slip along the base.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum Slip {
    /// To the left (−x).
    Left,
    /// To the right (+x).
    Right,
}

impl Slip {
    /// The other direction.
    pub fn opposite(self) -> Slip {
        match self {
            Slip::Left => Slip::Right,
            Slip::Right => Slip::Left,
        }
    }

    /// −1 for left, +1 for right.
    pub fn sign(self) -> f64 {
        match self {
            Slip::Left => -1.0,
            Slip::Right => 1.0,
        }
    }
}

/// A mode of response at the moment a body at rest is loaded.
///
/// Under a force that points left, the report's problem, the first seven occur; the others are their mirror
/// images and free flight, and occur in the [general contact problem](crate::contact).
/// The discriminant is the mode code of [`batch`](crate::batch).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Mode {
    /// RE: the body stays at rest.
    Rest = 0,
    /// SL: both corners keep contact and slide to the left.
    SlideLeft = 1,
    /// RO: the body rocks about O, which does not slip.
    RockO = 2,
    /// SRO-: the body rocks about O while O slides to the left.
    SlideRockOLeft = 3,
    /// SRO+: the body rocks about O while O slides to the right, against the force.
    SlideRockORight = 4,
    /// SRO'-: the body rocks about O' while O' slides to the left.
    SlideRockOPrimeLeft = 5,
    /// RO': the body rocks about O', which does not slip.
    RockOPrime = 6,
    /// SL+: both corners keep contact and slide to the right.
    SlideRight = 7,
    /// SRO'+: the body rocks about O' while O' slides to the right.
    SlideRockOPrimeRight = 8,
    /// FL: both corners leave the base.
    Flight = 9,
}

impl Mode {
    /// All modes, in the order of their codes.
    pub const ALL: [Mode; 10] = [
        Mode::Rest,
        Mode::SlideLeft,
        Mode::RockO,
        Mode::SlideRockOLeft,
        Mode::SlideRockORight,
        Mode::SlideRockOPrimeLeft,
        Mode::RockOPrime,
        Mode::SlideRight,
        Mode::SlideRockOPrimeRight,
        Mode::Flight,
    ];

    /// Rocking about `corner` without slip.
    pub fn rock(corner: Corner) -> Mode {
        match corner {
            Corner::O => Mode::RockO,
            Corner::OPrime => Mode::RockOPrime,
        }
    }

    /// Rocking about `corner` while that corner slips.
    pub fn slide_rock(corner: Corner, slip: Slip) -> Mode {
        match (corner, slip) {
            (Corner::O, Slip::Left) => Mode::SlideRockOLeft,
            (Corner::O, Slip::Right) => Mode::SlideRockORight,
            (Corner::OPrime, Slip::Left) => Mode::SlideRockOPrimeLeft,
            (Corner::OPrime, Slip::Right) => Mode::SlideRockOPrimeRight,
        }
    }

    /// Sliding on both corners.
    pub fn slide(slip: Slip) -> Mode {
        match slip {
            Slip::Left => Mode::SlideLeft,
            Slip::Right => Mode::SlideRight,
        }
    }

    /// The corner the body turns about, if it turns about one.
    pub fn corner(self) -> Option<Corner> {
        match self {
            Mode::RockO | Mode::SlideRockOLeft | Mode::SlideRockORight => Some(Corner::O),
            Mode::RockOPrime | Mode::SlideRockOPrimeLeft | Mode::SlideRockOPrimeRight => Some(Corner::OPrime),
            Mode::Rest | Mode::SlideLeft | Mode::SlideRight | Mode::Flight => None,
        }
    }

    /// The direction in which the touching corners slip, if they do.
    pub fn slip(self) -> Option<Slip> {
        match self {
            Mode::SlideLeft | Mode::SlideRockOLeft | Mode::SlideRockOPrimeLeft => Some(Slip::Left),
            Mode::SlideRight | Mode::SlideRockORight | Mode::SlideRockOPrimeRight => Some(Slip::Right),
            Mode::Rest | Mode::RockO | Mode::RockOPrime | Mode::Flight => None,
        }
    }

    /// The mode seen in a mirror: O and O', left and right exchanged.
    ///
    /// ```
    /// use standfast::Mode;
    /// assert_eq!(Mode::SlideRockOLeft.mirrored(), Mode::SlideRockOPrimeRight);
    /// ```
    pub fn mirrored(self) -> Mode {
        match (self.corner(), self.slip()) {
            (Some(corner), Some(slip)) => Mode::slide_rock(corner.opposite(), slip.opposite()),
            (Some(corner), None) => Mode::rock(corner.opposite()),
            (None, Some(slip)) => Mode::slide(slip.opposite()),
            (None, None) => self,
        }
    }

    /// The report's symbol in plain characters: `RE`, `SL`, `RO`, `SRO-`, `SRO+`, `SRO'-`; `RO'`, and `SL+`,
    /// `SRO'+`, `FL` for modes that the report's force cannot start.
    pub const fn symbol(self) -> &'static str {
        match self {
            Mode::Rest => "RE",
            Mode::SlideLeft => "SL",
            Mode::RockO => "RO",
            Mode::SlideRockOLeft => "SRO-",
            Mode::SlideRockORight => "SRO+",
            Mode::SlideRockOPrimeLeft => "SRO'-",
            Mode::RockOPrime => "RO'",
            Mode::SlideRight => "SL+",
            Mode::SlideRockOPrimeRight => "SRO'+",
            Mode::Flight => "FL",
        }
    }

    /// The mode in words, as a predicate of "the body".
    pub fn words(self) -> &'static str {
        match self {
            Mode::Rest => "stays at rest",
            Mode::SlideLeft => "slides to the left",
            Mode::RockO => "rocks about O, the bottom left corner",
            Mode::SlideRockOLeft => {
                "slides and rocks about O, the bottom left corner, which moves to the left"
            }
            Mode::SlideRockORight => {
                "slides and rocks about O, the bottom left corner, which moves to the right"
            }
            Mode::SlideRockOPrimeLeft => {
                "slides and rocks about O', the bottom right corner, which moves to the left"
            }
            Mode::RockOPrime => "rocks about O', the bottom right corner",
            Mode::SlideRight => "slides to the right",
            Mode::SlideRockOPrimeRight => {
                "slides and rocks about O', the bottom right corner, which moves to the right"
            }
            Mode::Flight => "leaves the base",
        }
    }

    /// The mode with this code in a column written by [`batch`](crate::batch).
    pub fn from_code(code: u8) -> Option<Mode> {
        Mode::ALL.get(usize::from(code)).copied()
    }

    /// The mode's code, its place in [`Mode::ALL`].
    pub fn code(self) -> u8 {
        self as u8
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.symbol())
    }
}

/// A text that is not a mode's symbol.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is not a mode; expected one of RE, SL, RO, SRO-, SRO+, SRO'-, RO', SL+, SRO'+, FL")]
pub struct ParseModeError(String);

impl FromStr for Mode {
    type Err = ParseModeError;

    /// The mode of a [symbol](Mode::symbol); a true minus sign or prime is as good.
    ///
    /// ```
    /// use standfast::Mode;
    /// assert_eq!("SRO'-".parse(), Ok(Mode::SlideRockOPrimeLeft));
    /// assert_eq!("SRO′−".parse(), Ok(Mode::SlideRockOPrimeLeft));
    /// assert!("sliding".parse::<Mode>().is_err());
    /// ```
    fn from_str(text: &str) -> Result<Mode, ParseModeError> {
        let plain = text.trim().replace('−', "-").replace('′', "'");
        let found = Mode::ALL.into_iter().find(|mode| mode.symbol() == plain);
        found.ok_or_else(|| ParseModeError(text.to_owned()))
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Mode {
    /// The symbol.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.symbol())
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Mode {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Mode, D::Error> {
        let symbol = <std::borrow::Cow<'de, str>>::deserialize(deserializer)?;
        symbol.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Modes {
    /// The symbols in a list.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Modes {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Modes, D::Error> {
        Ok(Vec::<Mode>::deserialize(deserializer)?.into_iter().collect())
    }
}

/// A set of modes: those that satisfy all conditions at once.
///
/// ```
/// use standfast::{Mode, Modes};
/// let modes: Modes = [Mode::RockO, Mode::SlideLeft].into_iter().collect();
/// assert_eq!(modes.to_string(), "SL RO");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Modes(u16);

impl Modes {
    /// No mode.
    pub const NONE: Modes = Modes(0);

    /// The set as bits: bit `n` is set if the mode with [code](Mode::code) `n` is in it.
    ///
    /// ```
    /// use standfast::{Mode, Modes};
    /// let modes: Modes = [Mode::SlideLeft, Mode::SlideRockOLeft].into_iter().collect();
    /// assert_eq!(modes.bits(), 0b1010);
    /// ```
    pub fn bits(self) -> u16 {
        self.0
    }

    /// Adds a mode.
    pub fn insert(&mut self, mode: Mode) {
        self.0 |= 1 << mode.code();
    }

    /// Takes a mode out.
    pub fn remove(&mut self, mode: Mode) {
        self.0 &= !(1 << mode.code());
    }

    /// True if a mode is in the set.
    pub fn contains(self, mode: Mode) -> bool {
        self.0 & (1 << mode.code()) != 0
    }

    /// True if the set has no mode.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Number of modes in the set.
    pub fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The set without a mode; without any if there is none.
    pub fn without(mut self, mode: Option<Mode>) -> Modes {
        if let Some(mode) = mode {
            self.remove(mode);
        }
        self
    }

    /// The modes seen in a mirror.
    pub fn mirrored(self) -> Modes {
        self.iter().map(Mode::mirrored).collect()
    }

    /// The modes in the order of their codes.
    pub fn iter(self) -> impl Iterator<Item = Mode> {
        Mode::ALL.into_iter().filter(move |&mode| self.contains(mode))
    }
}

impl FromIterator<Mode> for Modes {
    fn from_iter<I: IntoIterator<Item = Mode>>(modes: I) -> Modes {
        let mut set = Modes::NONE;
        modes.into_iter().for_each(|mode| set.insert(mode));
        set
    }
}

impl fmt::Display for Modes {
    /// The symbols, with spaces between.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, mode) in self.iter().enumerate() {
            write!(f, "{}{mode}", if i == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}
