//! Spectra against single motions and closed forms.

use standfast_answers::motion::{
    Follow, FollowedMotion, RockingDistance, Spectrum, SpectrumError, SpectrumKind, SpectrumPoints,
    SpectrumRequest, SpectrumSteps, SpectrumValues,
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

/// A motion that is left at 1 s of a shaking that goes on has no verdict; Newmark's slides are those of the whole shaking.
#[test]
fn a_motion_that_is_cut_off_has_no_overturning_spectrum() {
    let cut = block(1.0, 3.0, 0.9, BASE).replace("[motion.base]", "[motion]\nt_max = 0.1\n[motion.base]");
    let cut = case(&cut);
    let refused = spectrum(&cut, &SpectrumRequest::new(SpectrumKind::Overturning)).unwrap_err();
    assert!(matches!(refused, SpectrumError::CutShort { t_max: 0.1, end } if end > 0.1), "{refused}");
    let ratio = steps(0.2, 0.4, 2);
    let request = SpectrumRequest { ratio, ..SpectrumRequest::new(SpectrumKind::Newmark) };
    let [whole, part] =
        [&case(&block(1.0, 3.0, 0.9, BASE)), &cut].map(|case| spectrum(case, &request).unwrap().points);
    assert_eq!(format!("{whole:?}"), format!("{part:?}"));
}

/// Uniform blocks of half diagonal R and slenderness γ are those with b = R/√(1 + γ²) and d = γ b, followed one by one.
#[test]
fn a_rocking_spectrum_is_of_single_blocks() {
    let case = case(&block(1.0, 3.0, 0.9, BASE));
    let request = SpectrumRequest {
        size: steps(1.0, 9.0, 3),
        slenderness: steps(2.0, 5.0, 4),
        edges: false,
        ..SpectrumRequest::new(SpectrumKind::Rocking)
    };
    let found = spectrum(&case, &request).unwrap();
    assert_eq!((found.peak, found.gravity, found.si), (0.6, 1.0, false));
    let SpectrumPoints::Rocking { sizes, slendernesses, blocks, .. } = &found.points else { panic!() };
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

/// Blocks at random places, away from the edges by more than they are located to, do what their area says, followed one by one; and edges
/// take no more motions than half the blocks of the grid. Where nothing jumps edges are where they are between the blocks, to a fifth.
#[test]
fn areas_of_a_rocking_spectrum_are_of_single_blocks() {
    let case = case(&block(1.0, 3.0, 0.9, BASE));
    let request = SpectrumRequest {
        size: steps(1.0, 40.0, 41),
        slenderness: steps(2.0, 8.0, 31),
        ..SpectrumRequest::new(SpectrumKind::Rocking)
    };
    let found = spectrum(&case, &request).unwrap();
    let SpectrumPoints::Rocking { blocks, edges: Some(edges), .. } = &found.points else { panic!() };
    assert!(2 * edges.motions <= blocks.len(), "{} of {}", edges.motions, blocks.len());
    let (near, cell) = (edges.overturning, RockingDistance { factor: 40f64.powf(1.0 / 40.0), step: 0.2 });
    assert!(near.factor.ln() < 0.3 * cell.factor.ln() && near.step < 0.3 * cell.step, "{near:?}");
    assert!(edges.others.factor < 1.001 * cell.factor && edges.others.step < 1.001 * cell.step);
    let far = RockingDistance { factor: cell.factor.powf(0.2), step: 0.2 * cell.step };
    // Distances in units of what edges are located to.
    let apart = |(x, y): (f64, f64), from: (f64, f64), to: (f64, f64), unit: RockingDistance| {
        let scaled = |(x, y): (f64, f64)| (x.ln() / unit.factor.ln(), y / unit.step);
        let [p, a, b] = [(x, y), from, to].map(scaled);
        let (along, length) = ((b.0 - a.0, b.1 - a.1), (b.0 - a.0).hypot(b.1 - a.1));
        let share = ((p.0 - a.0) * along.0 + (p.1 - a.1) * along.1) / (length * length).max(1e-30);
        let share = share.clamp(0.0, 1.0);
        (p.0 - a.0 - share * along.0).hypot(p.1 - a.1 - share * along.1)
    };
    let mut seed = 7u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut classes = [0; 7];
    for _ in 0..1500 {
        let (size, slender) = (40f64.powf(random()), 2.0 + 6.0 * random());
        let sides = |level: usize| {
            edges.above[level].iter().flat_map(|each| each.iter().zip(each.iter().cycle().skip(1)))
        };
        let is_near = (0..6).any(|level| {
            let unit = if level == 5 { near } else { far };
            sides(level).any(|(a, b)| apart((size, slender), *a, *b, unit) <= 1.0)
        });
        if is_near {
            continue;
        }
        // The area has the place if a ray from it crosses its outline an odd number of times.
        let above = (0..6).filter(|level| {
            let crosses = |(a, b): &(&(f64, f64), &(f64, f64))| {
                (a.1 > slender) != (b.1 > slender)
                    && size.ln() < a.0.ln() + (slender - a.1) / (b.1 - a.1) * (b.0.ln() - a.0.ln())
            };
            sides(*level).filter(crosses).count() % 2 == 1
        });
        let drawn = above.count();
        let b = size / (1.0 + slender * slender).sqrt();
        let one =
            FollowedMotion::of(self::case(&block(b, slender * b, 0.9, BASE)), &Follow::default()).unwrap();
        let share = one.of_balance();
        let followed = match one.outcome.overturned() {
            true => 6,
            false => [0.0, 0.1, 0.25, 0.5, 1.0].iter().filter(|level| share > **level).count(),
        };
        assert_eq!(drawn, followed, "R = {size}, {slender}: {share}");
        classes[drawn] += 1;
    }
    assert!(classes[1..5].iter().chain(&classes[6..]).all(|count| *count >= 20), "{classes:?}");
    // No edges, if they are not asked for; and any number of threads finds the same.
    let points = |edges, threads| {
        spectrum(&case, &SpectrumRequest { edges, threads, ..request.clone() }).unwrap().points
    };
    assert!(matches!(points(false, 1), SpectrumPoints::Rocking { edges: None, .. }));
    assert_eq!(points(true, 3), found.points);
}

/// Between two factors that both overturn a body one may not: where nobody says at which factors, they lie within half a percent of each
/// other there, so that the window is found. Inside it, and on both sides, single motions tell.
#[test]
fn a_window_between_coarse_factors_is_found() {
    let text = include_str!("../../../examples/motion/server-rack-earthquake.toml");
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/motion/");
    let read =
        |name: &str| std::fs::read_to_string(format!("{folder}{name}")).map_err(|error| error.to_string());
    let rack = CaseFile::read("case.toml", text, &read).unwrap().motions().unwrap().remove(0);
    let found = spectrum(&rack, &SpectrumRequest::new(SpectrumKind::Overturning)).unwrap();
    let SpectrumPoints::Overturning { scales, bodies, stretches } = found.points else { panic!("{found:?}") };
    let over = |i: usize| bodies[i].overturned || bodies[i + 1].overturned;
    let near = |i: usize| scales[i + 1] / scales[i] < 1.0051;
    assert!((0..scales.len() - 1).all(|i| !over(i) || near(i)), "{scales:?}");
    let alone = |factor: f64| {
        let mut case = rack.clone();
        for history in
            [&mut case.problem.base.horizontal, &mut case.problem.base.vertical].into_iter().flatten()
        {
            *history = history.clone().times_factor(factor);
        }
        FollowedMotion::of(case, &Follow::default()).unwrap().outcome.overturned()
    };
    let is_over = |factor: f64| stretches.iter().any(|[from, to]| (*from..=*to).contains(&factor));
    for factor in [1.0, 1.022, 1.036, 1.08, 1.15] {
        assert_eq!(is_over(factor), alone(factor), "{factor}: {stretches:?}");
    }
    assert!(is_over(1.022) && !is_over(1.036) && is_over(1.08), "{stretches:?}");
}
