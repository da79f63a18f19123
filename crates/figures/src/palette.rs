//! One colour for each mode, the same in every figure.
//!
//! The tints keep their order in grey print (lightness falls from rest to slide-rock) and differ in blue against
//! yellow, which colour-blind readers see. A mode that the report's force cannot start has the tint of its mirror image.

use standfast::{Mode, Verdict};

/// Curves, axes and text.
pub(crate) const INK: &str = "#16202b";
/// Drop lines, leaders and hatching.
pub(crate) const FAINT: &str = "#5d6873";
/// Colour of lines behind, for comparison.
pub(crate) const BEHIND: &str = "#7d8791";
/// Design points.
pub(crate) const MARK: &str = "#a3123f";
/// The page.
pub(crate) const PAPER: &str = "#ffffff";

/// Values that meet a target.
pub(crate) const FEASIBLE: &str = "#dcebd3";

/// Reactions of the base.
pub(crate) const PUSH: &str = "#1d5f99";

/// Of a section: a part that holds itself, one that is held, what the body stands on, water, and pressures that push and pull.
pub(crate) const CONCRETE: &str = "#e3e5e8";
pub(crate) const FILL: &str = "#efe3c2";
pub(crate) const MOUND: &str = "#ece5d6";
pub(crate) const WATER: &str = "#e8f2f9";
pub(crate) const WET: &str = "#c3dcef";
pub(crate) const PULL: &str = "#f2cfcf";

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

/// The tint of ground that fails: the darkest in grey print.
const FAILED: &str = "#c9ae98";

/// The tint of what a body does on ground that can fail.
pub(crate) fn verdict_tint(verdict: Verdict) -> &'static str {
    verdict.mode().map_or(FAILED, tint)
}

/// The symbol of the same in markup.
pub(crate) fn verdict_symbol(verdict: Verdict) -> &'static str {
    verdict.mode().map_or(r"$\up{BF}$", symbol)
}

/// A colour of this palette as a custom property that a page may set, with the colour itself where it does not.
pub(crate) fn themed(colour: &str) -> &str {
    match colour {
        INK => "var(--ink,#16202b)",
        FAINT => "var(--faint,#5d6873)",
        MARK => "var(--mark,#a3123f)",
        PAPER => "var(--paper,#ffffff)",
        PUSH => "var(--push,#1d5f99)",
        "#f1f4f7" => "var(--rest,#f1f4f7)",
        "#f7de8b" => "var(--slide,#f7de8b)",
        "#aad2f0" => "var(--rock,#aad2f0)",
        "#b3b4e6" => "var(--rock-toe,#b3b4e6)",
        "#f0ab6b" => "var(--slide-rock-left,#f0ab6b)",
        "#6cb7a2" => "var(--slide-rock-toe,#6cb7a2)",
        "#c5799f" => "var(--slide-rock-right,#c5799f)",
        "#dcd6cb" => "var(--flight,#dcd6cb)",
        FAILED => "var(--bearing-failure,#c9ae98)",
        BEHIND => "var(--behind,#7d8791)",
        other => other,
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
