//! Spectra against single motions and closed forms.

use standfast_answers::motion::{
    Follow, FollowedMotion, Spectrum, SpectrumError, SpectrumKind, SpectrumPoints, SpectrumRequest,
    SpectrumSteps, SpectrumValues,
};
use standfast_model::{BlockCase, CaseFile};
use standfast_watch::Portion;

const BASE: &str = "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = 0.6, duration = 3 }\n";

fn case(text: &str) -> BlockCase {
    let file = CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    file.motions().unwrap_or_else(|error| panic!("{error}\n{text}")).remove(0)
}

fn block(b: f64, d: f64, mu: f64, rest: &str) -> String {
    format!(
        "[block]\nb1 = {b:?}\nb2 = {b:?}\nd = {d:?}\nrho2 = {:?}\nmu_s = {mu}\ngravity = 1\n{rest}",
        (b * b + d * d) / 3.0
    )
}

fn steps(from: f64, to: f64, count: usize) -> Option<SpectrumValues> {
    Some(SpectrumSteps { from, to, count }.into())
}

fn spectrum(case: &BlockCase, request: &SpectrumRequest) -> Result<Spectrum, SpectrumError> {
    Spectrum::of(case, request, Portion::UNSEEN)
}

#[test]
fn steps_end_where_they_are_to() {
    for (from, to, count) in [(0.3, 0.7, 4), (0.1, 0.9, 7), (0.7, 1.1, 2)] {
        let factors = SpectrumSteps { from, to, count }.factors();
        assert_eq!((factors.len(), factors[0], factors[count - 1]), (count, from, to));
        let ratio = (to / from).powf(1.0 / (count - 1) as f64);
        assert!(factors.windows(2).all(|pair| (pair[1] / pair[0] - ratio).abs() < 1e-12), "{factors:?}");
    }
    for (text, why) in [("2,2", "is the same as TO"), ("3,2", "is above TO")] {
        assert!(text.parse::<SpectrumSteps>().unwrap_err().contains(why), "{text}");
    }
    for wrong in ["1e50,2e50", "1,1e50", "0,1", "1,2,10000001"] {
        assert!(wrong.parse::<SpectrumSteps>().is_err(), "{wrong}");
    }
    let read = |text: &str| text.parse::<SpectrumSteps>();
    assert_eq!(read("0.2..0.6:41"), read("0.2,0.6,41"));
    assert_eq!(read("1 .. 2e1"), read("1,20"));
    for wrong in ["0.2..0.6:", "1..2..3", "..2", "2..1:3", "1..2:1"] {
        assert!(read(wrong).is_err(), "{wrong}");
    }
    assert!("1,2,10000000".parse::<SpectrumSteps>().is_ok());
}

#[test]
fn kinds_are_called_by_their_words() {
    for (word, kind) in [
        ("rocking", SpectrumKind::Rocking),
        ("newmark", SpectrumKind::Newmark),
        ("overturning", SpectrumKind::Overturning),
    ] {
        assert_eq!((kind.word(), word.parse()), (word, Ok(kind)));
    }
    assert!("newmrk".parse::<SpectrumKind>().unwrap_err().ends_with("did you mean newmark?"));
}

/// Uniform blocks of half diagonal R and slenderness γ are those with b = R/√(1 + γ²) and d = γ b, followed one by one.
#[test]
fn a_rocking_spectrum_is_of_single_blocks() {
    let case = case(&block(1.0, 3.0, 0.9, BASE));
    let request = SpectrumRequest {
        size: steps(1.0, 9.0, 3),
        slenderness: steps(2.0, 5.0, 4),
        ..SpectrumRequest::new(SpectrumKind::Rocking)
    };
    let found = spectrum(&case, &request).unwrap();
    assert_eq!((found.peak, found.gravity, found.si), (0.6, 1.0, false));
    let SpectrumPoints::Rocking { sizes, slendernesses, blocks } = &found.points else { panic!() };
    assert_eq!((&sizes[..], &slendernesses[..]), (&[1.0, 3.0, 9.0][..], &[2.0, 3.0, 4.0, 5.0][..]));
    let mut turned = 0;
    for (place, rocked) in blocks.iter().enumerate() {
        let (size, slender) = (sizes[place / 4], slendernesses[place % 4]);
        let b = size / (1.0 + slender * slender).sqrt();
        let one =
            FollowedMotion::of(self::case(&block(b, slender * b, 0.9, BASE)), &Follow::default()).unwrap();
        assert_eq!(rocked.overturned, one.outcome.overturned(), "{size} {slender}");
        assert!((rocked.max_theta - one.outcome.max_theta).abs() < 1e-9, "{size} {slender}");
        assert!((rocked.of_balance - one.of_balance()).abs() < 1e-9, "{size} {slender}");
        turned += usize::from(rocked.overturned);
    }
    assert!(turned > 0 && turned < 12, "{turned}");
    // As many threads, the same blocks in the same order.
    let threaded = spectrum(&case, &SpectrumRequest { threads: 4, ..request }).unwrap();
    assert_eq!(threaded.points, found.points);
}

/// Without more said, sizes are from a quarter to eight times the half diagonal of the case's own block, slendernesses from 2 to 8.
#[test]
fn a_rocking_spectrum_is_about_the_block_of_the_case() {
    let case = case(&block(3.0, 4.0, 0.9, BASE));
    let request = SpectrumRequest { size: steps(1.0, 2.0, 2), ..SpectrumRequest::new(SpectrumKind::Rocking) };
    let found = spectrum(&case, &request).unwrap();
    let SpectrumPoints::Rocking { slendernesses, .. } = &found.points else { panic!() };
    assert_eq!((slendernesses.len(), slendernesses[0], slendernesses[30]), (31, 2.0, 8.0));
    let request =
        SpectrumRequest { slenderness: steps(2.0, 3.0, 2), ..SpectrumRequest::new(SpectrumKind::Rocking) };
    let found = spectrum(&case, &request).unwrap();
    let SpectrumPoints::Rocking { sizes, .. } = &found.points else { panic!() };
    // b = 3 and d = 4: the half diagonal is 5.
    assert_eq!((sizes.len(), sizes[0], sizes[40]), (41, 1.25, 40.0));
}

#[test]
fn what_has_no_such_spectrum_is_refused() {
    let load = "[[block.load]]\ndirection = [-0.1, 0]\nhistory = { shape = \"rect\", duration = 1 }\n";
    let rocking = SpectrumRequest::new(SpectrumKind::Rocking);
    let refused = |text: &str, request: &SpectrumRequest| spectrum(&case(text), request).unwrap_err();
    assert!(matches!(
        refused(&block(1.0, 3.0, 0.9, &format!("{load}{BASE}")), &rocking),
        SpectrumError::Loads
    ));
    let leaning = format!("{BASE}[motion.initial]\ntheta = 0.01\n");
    assert!(matches!(refused(&block(1.0, 3.0, 0.9, &leaning), &rocking), SpectrumError::Initial));
    assert!(matches!(refused(&block(1.0, 3.0, 0.9, load), &rocking), SpectrumError::NoShaking));
    let many =
        SpectrumRequest { size: steps(1.0, 2.0, 10_000), slenderness: steps(2.0, 3.0, 1_001), ..rocking };
    assert!(matches!(refused(&block(1.0, 3.0, 0.9, BASE), &many), SpectrumError::Many { count: 10_010_000 }));
}

/// Under a rectangle of acceleration a and duration T a block of yield ratio r slides by (1 − r) a T²/(2r) to the side to which it is left
/// behind, and to the other not.
#[test]
fn a_newmark_spectrum_is_the_closed_form() {
    let base = "[motion.base]\nhorizontal = { shape = \"rect\", peak = 0.8, duration = 1.5 }\n";
    let request =
        SpectrumRequest { ratio: steps(0.2, 0.8, 4), ..SpectrumRequest::new(SpectrumKind::Newmark) };
    let found = spectrum(&case(&block(1.0, 0.5, 0.4, base)), &request).unwrap();
    let SpectrumPoints::Newmark { ratios, slides } = &found.points else { panic!() };
    for (ratio, slid) in ratios.iter().zip(slides) {
        let expected = (1.0 - ratio) * 0.8 * 1.5 * 1.5 / (2.0 * ratio);
        assert!(
            (slid.left.max(slid.right) - expected).abs() < 1e-9 * expected,
            "{ratio}: {slid:?} {expected}"
        );
        assert!(slid.left.min(slid.right).abs() < 1e-12);
    }
    assert_eq!(ratios.len(), 4);
}

/// The stretches of factors at which a body overturns, each end halved down to by single motions of the scaled shaking.
#[test]
fn an_overturning_curve_is_of_scaled_shakings() {
    let scaled = |scale: f64| {
        let base = format!(
            "[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = {:?}, duration = 3 }}\n",
            0.6 * scale
        );
        let followed = FollowedMotion::of(case(&block(1.0, 3.0, 5.0, &base)), &Follow::default()).unwrap();
        followed.outcome.overturned()
    };
    let request =
        SpectrumRequest { scale: steps(0.2, 2.0, 19), ..SpectrumRequest::new(SpectrumKind::Overturning) };
    let found = spectrum(&case(&block(1.0, 3.0, 5.0, BASE)), &request).unwrap();
    let SpectrumPoints::Overturning { scales, bodies, stretches } = &found.points else { panic!() };
    for (scale, body) in scales.iter().zip(bodies) {
        assert_eq!(body.overturned, scaled(*scale), "{scale}");
    }
    assert!(!stretches.is_empty());
    for [from, to] in stretches {
        for (end, inwards) in [(from, 1.0), (to, -1.0)] {
            let at_the_edge = *end == 0.2 || *end == 2.0;
            assert!(scaled(end + inwards * 1e-6), "{end}");
            assert!(at_the_edge || !scaled(end - inwards * 1e-6), "{end}");
        }
    }
}
