//! Colours told apart by readers who are colour-blind and in grey print, worked out from what is published on colour: sRGB
//! (IEC 61966-2-1), CIELAB of 1976, contrast as in WCAG 2.1, and the matrices of Machado, Oliveira and Fernandes (2009) for whole
//! blindness to red, green and blue.

use super::*;

type Colour = [f64; 3];

const SEEN_WHOLE: [Colour; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const WITHOUT_RED: [Colour; 3] =
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]];
const WITHOUT_GREEN: [Colour; 3] =
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]];
const WITHOUT_BLUE: [Colour; 3] =
    [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]];

/// Intensities of red, green and blue light.
fn light(colour: &str) -> Colour {
    [1, 3, 5].map(|i| {
        let share = f64::from(u8::from_str_radix(&colour[i..i + 2], 16).expect("a colour")) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    })
}

fn times(matrix: &[Colour; 3], of: Colour) -> Colour {
    matrix.map(|row| row.iter().zip(of).map(|(one, other)| one * other).sum())
}

const TO_XYZ: [Colour; 3] =
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]];

fn lab(seen: Colour) -> Colour {
    let white = times(&TO_XYZ, [1.0; 3]);
    let xyz = times(&TO_XYZ, seen.map(|share| share.clamp(0.0, 1.0)));
    let f = |i: usize| {
        let share: f64 = xyz[i] / white[i];
        if share > 216.0 / 24389.0 { share.cbrt() } else { (24389.0 / 27.0 * share + 16.0) / 116.0 }
    };
    [116.0 * f(1) - 16.0, 500.0 * (f(0) - f(1)), 200.0 * (f(1) - f(2))]
}

fn difference(vision: &[Colour; 3], one: &str, other: &str) -> f64 {
    let [one, other] = [one, other].map(|colour| lab(times(vision, light(colour))));
    one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn contrast(one: &str, other: &str) -> f64 {
    let luminance = |colour: &str| times(&TO_XYZ, light(colour))[1] + 0.05;
    let (one, other) = (luminance(one), luminance(other));
    one.max(other) / one.min(other)
}

/// The verdicts with their tints in a theme.
fn tints(dark: bool) -> Vec<(Verdict, &'static str)> {
    let verdicts = Mode::ALL.into_iter().map(Verdict::Begins).chain([Verdict::BearingFailure]);
    verdicts.map(|verdict| (verdict, shown(verdict_tint(verdict), dark))).collect()
}

fn shown(light: &'static str, dark: bool) -> &'static str {
    let paint = PAINTS.iter().find(|paint| paint.light == light).expect("a colour of the palette");
    if dark { paint.dark } else { paint.light }
}

/// White and black are as far apart as L* goes; a blue and a yellow that differ for all stay apart without green.
#[test]
fn differences_are_those_of_cielab() {
    assert!((difference(&SEEN_WHOLE, "#ffffff", "#000000") - 100.0).abs() < 1e-3);
    assert!((contrast("#ffffff", "#000000") - 21.0).abs() < 1e-5);
    // Red of sRGB: L* 53.24, a* 80.09, b* 67.20 (Lindbloom).
    let red = lab(light("#ff0000"));
    assert!((red[0] - 53.24).abs() < 0.01 && (red[1] - 80.09).abs() < 0.01 && (red[2] - 67.20).abs() < 0.01);
    // Red and green of one lightness are one colour without green cones, and two with them.
    assert!(
        difference(&SEEN_WHOLE, "#d07070", "#909050")
            > 2.0 * difference(&WITHOUT_GREEN, "#d07070", "#909050")
    );
}

/// Two verdicts differ in their textures, or in their tints for every reader; where one has dots, half of that.
#[test]
fn verdicts_are_told_apart_by_every_reader() {
    for dark in [false, true] {
        let tints = tints(dark);
        for (i, (one, tint)) in tints.iter().enumerate() {
            for (other, beside) in &tints[i + 1..] {
                let textures = [*one, *other].map(verdict_texture);
                if tint == beside {
                    assert_ne!(textures[0], textures[1], "{one:?} and {other:?}");
                    continue;
                }
                let share = if textures.contains(&Texture::Dots) { 0.6 } else { 1.0 };
                let visions = [
                    (&SEEN_WHOLE, 15.0),
                    (&WITHOUT_RED, 15.0),
                    (&WITHOUT_GREEN, 15.0),
                    (&WITHOUT_BLUE, 11.0),
                ];
                for (vision, least) in visions {
                    let apart = difference(vision, tint, beside);
                    assert!(apart >= share * least, "{one:?} and {other:?}, dark {dark}: {apart:.1}");
                }
            }
        }
    }
}

/// Text, marks and textures are read on every tint; modes that meet at the corner A differ in lightness, as grey print needs.
#[test]
fn marks_are_seen_on_every_tint_and_tints_in_grey() {
    for dark in [false, true] {
        for (verdict, tint) in tints(dark) {
            for (mark, least) in [(INK, 4.5), (MARK, 3.0), (FAINT, 2.0)] {
                let seen = contrast(tint, shown(mark, dark));
                assert!(seen >= least, "{mark} on {verdict:?}, dark {dark}: {seen:.2}");
            }
        }
        for (one, other) in [(REST, SLIDE), (REST, ROCK), (SLIDE, SLIDE_ROCK_LEFT), (ROCK, SLIDE_ROCK_LEFT)] {
            let apart = contrast(shown(one, dark), shown(other, dark));
            assert!(apart >= 1.16, "{one} and {other}, dark {dark}: {apart:.2}");
        }
        let [beyond, fallen] = [BEYOND, FALLEN].map(|colour| shown(colour, dark));
        assert!(contrast(beyond, fallen) >= 1.4, "{:.2}", contrast(beyond, fallen));
    }
}

/// Each colour stands once, so that it has one property and one dark counterpart.
#[test]
fn every_colour_is_one_paint() {
    for (i, paint) in PAINTS.iter().enumerate() {
        let is_same = |other: &Paint| other.light == paint.light || other.property == paint.property;
        assert!(!PAINTS[i + 1..].iter().any(is_same), "{}", paint.property);
    }
}
