//! One colour for each mode, the same in every figure, on paper and in a dark page.
//!
//! The tints are told apart by readers who are blind to red, green or blue, and mostly by their lightness alone, as a test works out.
//! A mode and its mirror image share a tint where a plane of the report never shows both; the mirror image carries stripes. Ground that
//! fails carries dots.

use std::borrow::Cow;

use standfast::{Mode, Verdict};

use crate::texture::Texture;

/// A colour, the one that takes its place in a dark page, and the property by which a page may set it.
struct Paint {
    property: &'static str,
    light: &'static str,
    dark: &'static str,
}

macro_rules! paints {
    ($($(#[$words:meta])* $name:ident $property:literal $light:literal $dark:literal)*) => {
        $($(#[$words])* pub(crate) const $name: &str = $light;)*
        const PAINTS: &[Paint] = &[$(Paint { property: $property, light: $light, dark: $dark }),*];
    };
}

paints! {
    /// Curves, axes and text.
    INK "ink" "#16202b" "#e4e8eb"
    /// Drop lines, leaders and hatching.
    FAINT "faint" "#5d6873" "#9aa6b2"
    /// Lines behind, for comparison.
    BEHIND "behind" "#7d8791" "#7d8994"
    /// Design points.
    MARK "mark" "#a3123f" "#ff86a6"
    /// The page.
    PAPER "paper" "#ffffff" "#12161b"
    /// Reactions of the base.
    PUSH "push" "#1d5f99" "#7dbcf2"

    /// Rest.
    REST "rest" "#f1f4f7" "#1c232a"
    SLIDE "slide" "#f8dd80" "#695902"
    ROCK "rock" "#b3d7f5" "#425489"
    SLIDE_ROCK_LEFT "slide-rock-left" "#e7a565" "#632504"
    SLIDE_ROCK_TOE "slide-rock-toe" "#4dccc1" "#186456"
    SLIDE_ROCK_RIGHT "slide-rock-right" "#e986a0" "#5b2a58"
    FLIGHT "flight" "#d7d0b0" "#382719"
    /// Ground that fails.
    FAILED "bearing-failure" "#c6a992" "#54473d"

    /// Values that meet a target.
    FEASIBLE "feasible" "#dcebd3" "#24402a"
    /// A part of a section that holds itself.
    CONCRETE "concrete" "#e3e5e8" "#2f363d"
    /// A part that is held.
    FILL "fill" "#efe3c2" "#4a4228"
    /// What the body stands on.
    MOUND "mound" "#ece5d6" "#3b3529"
    WATER "water" "#e8f2f9" "#16283a"
    /// Pressure that pushes.
    WET "wet" "#c3dcef" "#2c4d69"
    /// Pressure that pulls.
    PULL "pull" "#f2cfcf" "#5e2f38"

    /// The interval of an answer, and of a mode.
    BAND "band" "#dfe3e8" "#333d47"
    BAND_OF_MODE "band-of-mode" "#f1f2f4" "#252c33"
    /// A probability that knowing a number lowers, or raises.
    LOWERS "lowers" "#8fb4d6" "#3f6f99"
    RAISES "raises" "#e2a5b5" "#8a4358"
    /// Factors on a shaking that overturns.
    OVERTURNS "overturns" "#f3d5dc" "#4a2531"

    /// Rotations of a rocking spectrum that rise to the angle of balance; beyond it and back; and overturned.
    RAMP_1 "ramp-1" "#dcebf7" "#1f3346"
    RAMP_2 "ramp-2" "#b5d4ec" "#294d6d"
    RAMP_3 "ramp-3" "#82b4da" "#346b96"
    RAMP_4 "ramp-4" "#4c8cbf" "#4a8ec2"
    BEYOND "beyond" "#f4b942" "#c98a16"
    FALLEN "fallen" "#7c0f31" "#f7a8bd"
}

/// Classes of a rocking spectrum: does not rock, four of rotations up to the angle of balance, beyond it and back, overturns.
pub(crate) const ROCKING: [&str; 7] = [REST, RAMP_1, RAMP_2, RAMP_3, RAMP_4, BEYOND, FALLEN];

/// The tint of a mode's region.
pub(crate) fn tint(mode: Mode) -> &'static str {
    match mode {
        Mode::Rest => REST,
        Mode::SlideLeft | Mode::SlideRight => SLIDE,
        Mode::RockO | Mode::RockOPrime => ROCK,
        Mode::SlideRockOLeft | Mode::SlideRockOPrimeRight => SLIDE_ROCK_LEFT,
        Mode::SlideRockOPrimeLeft => SLIDE_ROCK_TOE,
        Mode::SlideRockORight => SLIDE_ROCK_RIGHT,
        Mode::Flight => FLIGHT,
    }
}

/// What tells a mode from the one of the same tint.
pub(crate) fn texture(mode: Mode) -> Texture {
    match mode {
        Mode::SlideRight | Mode::RockOPrime | Mode::SlideRockOPrimeRight => Texture::Stripes,
        _ => Texture::Plain,
    }
}

/// What tells a verdict from others beside its tint.
pub(crate) fn verdict_texture(verdict: Verdict) -> Texture {
    verdict.mode().map_or(Texture::Dots, texture)
}

/// The tint of what a body does on ground that can fail.
pub(crate) fn verdict_tint(verdict: Verdict) -> &'static str {
    verdict.mode().map_or(FAILED, tint)
}

/// The symbol of the same in markup.
pub(crate) fn verdict_symbol(verdict: Verdict) -> &'static str {
    verdict.mode().map_or(r"$\up{BF}$", symbol)
}

/// A colour of this palette as a custom property that a page may set, with the colour itself where it does not.
pub(crate) fn themed(colour: &str) -> Cow<'_, str> {
    match PAINTS.iter().find(|paint| paint.light == colour) {
        Some(Paint { property, light, .. }) => Cow::Owned(format!("var(--{property},{light})")),
        None => Cow::Borrowed(colour),
    }
}

/// Every colour of the figures: the custom property by which a page may set it, the colour on paper and that in a dark page.
pub fn colours() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    PAINTS.iter().map(|paint| (paint.property, paint.light, paint.dark))
}

/// Style that gives a drawing its dark colours in a dark page; renderers that know no such pages leave it out.
pub(crate) fn dark_style(body: &str) -> String {
    let mut style = String::from("@media (prefers-color-scheme:dark){");
    for Paint { light, dark, .. } in PAINTS {
        for attribute in ["fill", "stroke"] {
            let painted = format!("{attribute}=\"{light}\"");
            if body.contains(&painted) {
                style += &format!("svg.standfast [{painted}]{{{attribute}:{dark}}}");
            }
        }
    }
    style + "}"
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

#[cfg(test)]
mod tests;
