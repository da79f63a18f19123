//! One colour for each mode, the same in every figure.
//!
//! The tints keep their order in grey print (lightness falls from rest to slide-rock) and differ in blue against
//! yellow, which colour-blind readers see. A mode that the report's force cannot start has the tint of its mirror image.

use standfast::Mode;

/// Curves, axes and text.
pub(crate) const INK: &str = "#16202b";
/// Drop lines, leaders and hatching.
pub(crate) const FAINT: &str = "#5d6873";
/// Design points.
pub(crate) const MARK: &str = "#a3123f";
/// The page.
pub(crate) const PAPER: &str = "#ffffff";

/// The tint of a mode's region.
pub(crate) fn tint(mode: Mode) -> &'static str {
    match mode {
        Mode::Rest => "#f1f4f7",
        Mode::SlideLeft | Mode::SlideRight => "#f7de8b",
        Mode::RockO => "#aad2f0",
        Mode::RockOPrime => "#b3b4e6",
        Mode::SlideRockOLeft | Mode::SlideRockOPrimeRight => "#f0ab6b",
        Mode::SlideRockOPrimeLeft => "#6cb7a2",
        Mode::SlideRockORight => "#c5799f",
        Mode::Flight => "#dcd6cb",
    }
}

/// The symbol of a mode in markup.
pub(crate) fn symbol(mode: Mode) -> &'static str {
    match mode {
        Mode::Rest => r"$\up{RE}$",
        Mode::SlideLeft => r"$\up{SL}$",
        Mode::RockO => r"$\up{RO}$",
        Mode::SlideRockOLeft => r"$\up{SRO}_−$",
        Mode::SlideRockORight => r"$\up{SRO}_+$",
        Mode::SlideRockOPrimeLeft => r"$\up{SRO}′_−$",
        Mode::RockOPrime => r"$\up{RO}′$",
        Mode::SlideRight => r"$\up{SL}_+$",
        Mode::SlideRockOPrimeRight => r"$\up{SRO}′_+$",
        Mode::Flight => r"$\up{FL}$",
    }
}
