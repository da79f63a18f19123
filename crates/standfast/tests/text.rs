//! Modes and numbers as text, and back.

use standfast::number::{exact, significant};
use standfast::{Corner, Mode, Modes, Slip};

mod common;

use common::{Random, tries};

#[test]
fn every_mode_is_read_back_from_its_symbol() {
    for mode in Mode::ALL {
        assert_eq!(mode.symbol().parse(), Ok(mode));
        assert_eq!(mode.to_string().parse(), Ok(mode));
        let typeset = format!(" {} ", mode.symbol().replace('-', "−").replace('\'', "′"));
        assert_eq!(typeset.parse(), Ok(mode), "{typeset}");
        assert_eq!(format!("{mode:>6}").trim_start(), mode.symbol());
        for wrong in [mode.symbol().to_lowercase(), format!("{mode}x"), format!("x{mode}"), String::new()] {
            let error = wrong.parse::<Mode>().unwrap_err().to_string();
            assert!(error.starts_with(&format!("\"{wrong}\" is not a mode; expected one of")), "{error}");
        }
    }
    let error = "".parse::<Mode>().unwrap_err().to_string();
    let listed = error.split("one of ").nth(1).unwrap().split(", ");
    assert_eq!(listed.collect::<Vec<_>>(), Mode::ALL.map(Mode::symbol));
}

/// A mode in words says whether and where the body slides, and whether and about which corner it rocks.
#[test]
fn a_mode_in_words_says_what_moves() {
    for mode in Mode::ALL {
        let words = mode.words();
        assert_eq!(words.contains("slides"), mode.slip().is_some(), "{words}");
        assert_eq!(words.contains("rocks"), mode.corner().is_some(), "{words}");
        assert_eq!(words.ends_with("to the left"), mode.slip() == Some(Slip::Left), "{words}");
        assert_eq!(words.ends_with("to the right"), mode.slip() == Some(Slip::Right), "{words}");
        assert_eq!(words.contains("about O, the bottom left"), mode.corner() == Some(Corner::O), "{words}");
        assert_eq!(
            words.contains("about O', the bottom right"),
            mode.corner() == Some(Corner::OPrime),
            "{words}"
        );
        let same: Vec<Mode> = Mode::ALL.into_iter().filter(|other| other.words() == words).collect();
        assert_eq!(same, [mode], "{words}");
        assert!(words.len() > 8);
    }
}

/// In the mirror a set of modes has the mirror images of its modes, and no other.
#[test]
fn a_set_of_modes_has_a_mirror_image() {
    for set in 0..1u32 << Mode::ALL.len() {
        let modes: Modes =
            (0..).zip(Mode::ALL).filter(|(i, _)| set >> i & 1 == 1).map(|(_, mode)| mode).collect();
        for mode in Mode::ALL {
            assert_eq!(modes.mirrored().contains(mode.mirrored()), modes.contains(mode), "{modes} {mode}");
        }
    }
}

/// Read back, the text is the number rounded as Rust rounds it; it is as short as can be, and has a power of ten below 10⁻⁴ and
/// from 10⁷ on only.
#[test]
fn a_rounded_number_reads_back() {
    let mut random = Random(71);
    for _ in 0..tries(20_000) {
        let size = if random.coin() { random.log(1e-300, 1e300) } else { random.log(1e-6, 1e9) };
        let x = size * random.pick(&[-1.0, 1.0]);
        let count = random.pick(&[1, 2, 3, 4, 6, 9, 17]);
        let expected: f64 = format!("{x:.*e}", count - 1).parse().unwrap();
        let text = significant(x, count).to_string();
        assert_eq!(text.parse(), Ok(expected), "{x:e} {count}: {text}");
        let (mantissa, exponent) = text.split_once('e').map_or((&*text, None), |(m, e)| (m, Some(e)));
        assert!(!mantissa.contains('.') || !mantissa.ends_with(['0', '.']), "{text}");
        assert_eq!(exponent.is_none(), (1e-4..1e7).contains(&expected.abs()), "{text}");
        if exponent.is_some() {
            assert!(mantissa.trim_start_matches('-').find('.').is_none_or(|at| at == 1), "{text}");
        }
    }
    assert_eq!(significant(f64::MAX, 17).to_string(), "1.7976931348623157e308");
    assert_eq!(significant(f64::MAX, 4).to_string(), "1.798e308");
    assert_eq!(significant(5e-324, 4).to_string(), "4.941e-324");
    assert_eq!(significant(1234.5, 0).to_string(), "1000");
}

/// With all its digits a number reads back as itself, and is no longer than a person would write it.
#[test]
fn a_number_with_all_its_digits_reads_back() {
    let mut random = Random(72);
    for _ in 0..tries(5_000) {
        let size = if random.coin() { random.log(1e-300, 1e300) } else { random.log(1e-7, 1e16) };
        let x = size * random.pick(&[-1.0, 1.0]);
        let text = exact(x);
        assert_eq!(text.parse(), Ok(x), "{text}");
        assert_eq!(text.contains('e'), !(1e-6..1e15).contains(&size), "{text}");
    }
    for (x, text) in [(0.0, "0"), (1e300, "1e300"), (f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf")] {
        assert_eq!(exact(x), text);
    }
}
