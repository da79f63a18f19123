//! Ground that fails: bearing factors by the tables, resistance by hand, the plane, and the case of Goda's caisson.

mod common;

use common::{Random, tries};
use standfast::ground::bearing::{
    BearingBlock, BearingOutcome, BearingPlane, Ground, GroundLaw, GroundPath, Reaction, outcome,
};
use standfast::loads::{Action, Load, LoadKind, LoadSource, Uplift};
use standfast::{Body, Departure, Mode, Quantity, Situation, Verdict};

/// N_q, N_c and N_γ as textbooks have them for EN 1997-1 Annex D.
#[test]
fn factors_are_those_of_the_tables() {
    for (angle, n_q, n_c, n_gamma) in [
        (20.0, 6.40, 14.83, 3.93),
        (30.0, 18.40, 30.14, 20.09),
        (35.0, 33.30, 46.12, 45.23),
        (40.0, 64.20, 75.31, 106.05),
    ] {
        let ours = GroundLaw::Ec7.factors(angle);
        assert!((ours.n_q - n_q).abs() < 0.006 && (ours.n_c - n_c).abs() < 0.006, "{angle}: {ours:?}");
        assert!((ours.n_gamma - n_gamma).abs() < 0.006, "{angle}: {ours:?}");
        let hansen = GroundLaw::Hansen.factors(angle);
        assert!((hansen.n_gamma / ours.n_gamma - 0.75).abs() < 1e-15);
    }
    // 35° to 40°: 2.3 times.
    let [one, two] = [35.0, 40.0].map(|angle| GroundLaw::Ec7.factors(angle).n_gamma);
    assert!((two / one - 2.34).abs() < 0.01);
}

/// A strip by hand: φ = 30°, γ' = 10, q' = 18, c' = 5 kN/m², B = 2 m, e = 0.5 m, P = 300, X = 60 kN/m.
#[test]
fn a_strip_by_hand() {
    let reaction = Reaction::new(2.0, 300e3, 60e3, 0.5).unwrap();
    assert_eq!((reaction.effective_width(), reaction.effective_pressure()), (3.0, 100e3));
    let ground =
        |law| Ground::new(law, 30.0, 10e3).unwrap().with_surcharge(18e3).unwrap().with_cohesion(5e3).unwrap();
    // h = 60/(300 + 3·5·1.7321) = 0.18406
    let ec7: f64 =
        3.0 * (5.0 * 30.1396 * 0.64644 + 18.0 * 18.4011 * 0.66576 + 0.5 * 10.0 * 3.0 * 20.0931 * 0.54322);
    let ours = ground(GroundLaw::Ec7).resistance(&reaction) / 1e3;
    assert!((ours / ec7 - 1.0).abs() < 2e-4, "{ours} {ec7}");
    let i_q = (1.0f64 - 0.5 * 0.184056).powi(5);
    let i_c = i_q - (1.0 - i_q) / 17.4011;
    let hansen = 3.0
        * (5.0 * 30.1396 * i_c + 18.0 * 18.4011 * i_q + 15.0 * 15.0698 * (1.0f64 - 0.7 * 0.184056).powi(5));
    let ours = ground(GroundLaw::Hansen).resistance(&reaction) / 1e3;
    assert!((ours / hansen - 1.0).abs() < 2e-5, "{ours} {hansen}");
    assert_eq!(ground(GroundLaw::Ec7).factor(&Reaction::new(2.0, 300e3, 60e3, 2.0).unwrap()), 0.0);
}

/// A base of 6 m by hand, and one shorter than what bears of its width: φ = 30°, γ' = 10, q' = 18, c' = 5 kN/m², B = 2 m, e = 0.5 m, P = 300, X = 60 kN/m.
/// B'/L = 0.5: m = 5/3, s_q = 1.25, s_γ = 0.85, s_c = (1.25 · 18.4011 − 1)/17.4011 = 1.26437; h = 0.184056.
#[test]
fn a_base_that_is_not_long_by_hand() {
    let reaction = Reaction::new(2.0, 300e3, 60e3, 0.5).unwrap();
    let plain = Ground::new(GroundLaw::Ec7, 30.0, 10e3).unwrap();
    let ground = plain.with_surcharge(18e3).unwrap().with_cohesion(5e3).unwrap();
    let (h, n_q, n_c, n_gamma): (f64, f64, f64, f64) = (0.184056, 18.4011, 30.1396, 20.0931);
    let i_q = (1.0 - h).powf(5.0 / 3.0);
    let i_c = i_q - (1.0 - i_q) / (n_c * 0.577350);
    let by_hand = 3.0
        * (5.0 * n_c * 1.26437 * i_c
            + 18.0 * n_q * 1.25 * i_q
            + 15.0 * n_gamma * 0.85 * (1.0 - h).powf(8.0 / 3.0));
    let ours = ground.with_length(6.0).unwrap().resistance(&reaction) / 1e3;
    assert!((ours / by_hand - 1.0).abs() < 2e-5, "{ours} {by_hand}");
    // 1.5 m long, half of B': the shorter side is the length, and the push is along the longer, m = (2 + 2)/(1 + 2).
    let short = plain.with_length(1.5).unwrap().resistance(&reaction) / 1e3;
    let by_hand = 3.0 * 0.5 * 10.0 * 1.5 * n_gamma * 0.85 * (1.0f64 - 0.2).powf(7.0 / 3.0);
    assert!((short / by_hand - 1.0).abs() < 2e-5, "{short} {by_hand}");
    // Upright and in the middle, a square has seven tenths of the term of weight; one that is very long is a strip.
    let square = plain.with_length(4.0).unwrap().centric_resistance(2.0);
    assert!((square / plain.centric_resistance(2.0) - 0.7).abs() < 1e-12);
    let long = ground.with_length(1e12).unwrap().resistance(&reaction);
    assert!((long / ground.resistance(&reaction) - 1.0).abs() < 1e-9);
    assert_eq!((plain.length(), plain.with_length(4.0).unwrap().length()), (None, Some(4.0)));
    assert!(plain.with_length(0.0).is_err());
    // R falls with the eccentricity and with the inclination, as what asks for the least of several takes for granted.
    for law in [GroundLaw::Ec7, GroundLaw::Hansen] {
        for length in [0.5, 2.0, 3.0, 9.0] {
            let ground = Ground::new(law, 38.0, 10e3)
                .unwrap()
                .with_surcharge(9e3)
                .unwrap()
                .with_cohesion(4e3)
                .unwrap();
            let ground = ground.with_length(length).unwrap();
            let of =
                |e: f64, share: f64| ground.resistance(&Reaction::new(2.0, 300e3, share * 300e3, e).unwrap());
            for i in 0..40 {
                let (e, share) = (f64::from(i) * 0.045, f64::from(i) * 0.02);
                assert!(of(e, 0.2) >= of(e + 0.045, 0.2), "{law:?} {length} {e}");
                assert!(of(0.4, share) >= of(0.4, share + 0.02), "{law:?} {length} {share}");
            }
        }
    }
}

/// A base whose middle is not under the centre of mass, by hand: B = 5 m, C half a metre beside the middle and 3 m up, P = 1000 kN/m, and a
/// push of λ · 100 kN/m at 4 m, away from that side. The reaction lies λ · 0.4 m from under C, so |0.5 − 0.4λ| from the middle; on ground with
/// V₀ = P/[(1 − 0.14)²(1 − 0.21)⁵] it fails at λ = 3, where e is 0.7 m and η 0.3.
#[test]
fn the_middle_of_an_eccentric_base() {
    let unit = Ground::new(GroundLaw::Hansen, 30.0, 1.0).unwrap();
    let centric = 1e6 / (0.86f64.powi(2) * 0.79f64.powi(5));
    let ground = Ground::new(GroundLaw::Hansen, 30.0, centric / unit.centric_resistance(5.0)).unwrap();
    for side in [1.0, -1.0] {
        // Four metres of it.
        let body = Body::new(10.0, 8.0, 4e5).unwrap().with_length(4.0).unwrap();
        let body = body.with_centroid(0.5 * side, 3.0).unwrap();
        let push = Action::horizontal(-4e5 * side, 4.0);
        let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, push);
        let situation = Situation::new(body, 2.0, 10.0).unwrap().with_weight().with(push);
        let path = GroundPath::new(ground, &situation).unwrap();
        for (factor, e) in [(0.0, 0.5), (1.0, 0.1), (2.0, -0.3)] {
            // To the right of the middle.
            let reaction = path.reaction(factor).unwrap();
            assert!((reaction.e() - e * side).abs() < 1e-12, "{factor}: {reaction:?}");
            assert!((reaction.effective_width() - 2.0 * (5.0 - e.abs())).abs() < 1e-12);
        }
        assert!((path.load_factors().given - 3.0).abs() < 1e-9, "{:?}", path.load_factors());
        // The same of the block of a contact problem, in its own units.
        let on = BearingBlock::of(ground, &situation).unwrap();
        let [none, full] = [0.0, 1.0].map(|factor| {
            situation.reduced_wrench(&situation.wrench_at(factor, standfast::loads::Pose::UPRIGHT))
        });
        let fails = on.failure(&situation.reduced_block().0, &none, &(full + none * -1.0));
        assert!((fails - 3.0).abs() < 1e-9, "{fails}");
    }
}

/// A stretch of load factors in which the ground bears is found though it is as narrow as 0.004: about where the reaction is in the middle
/// of the base, or upright. By hand: C is 0.5 m right of the middle of 2B = 10 m, P = 1000 kN/m, φ = 30° and V₀ such that the best R/P = (1
/// − |e|/B)²(1 − 0.7η)⁵/u, at λ = 3.775, is 1.0001:
///
/// * a push at 40 m, so high that e = 0.5(1 − λ/3.775) says more than η = 0.0125 λ/3.775;
/// * one at the base, e = 0.5 and η = 0.05|1 − λ/3.775| with a permanent one against it;
/// * a body that slides with μ = 0.3 = η, pushed so low that e = −0.4(1 − λ/3.775).
#[test]
fn a_narrow_stretch_that_is_borne_is_found() {
    const BEST: f64 = 3.775;
    type Share = fn(f64) -> [f64; 2];
    let high: Share = |s| [0.5 * (1.0 - s), 0.0125 * s];
    let level: Share = |s| [0.5, 0.05 * (1.0 - s)];
    let slides: Share = |s| [-0.4 * (1.0 - s), 0.3];
    let body = Body::new(10.0, 8.0, 1e5).unwrap().with_centroid(0.5, 3.0).unwrap();
    let push = |permanent: bool, left: f64, elevation: f64| match permanent {
        true => {
            Load::permanent(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-left, elevation))
        }
        false => {
            Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-left, elevation))
        }
    };
    let on = |μ: f64| Situation::new(body, μ, 10.0).unwrap().with_weight();
    for (situation, share, symbol) in [
        (on(2.0).with(push(false, 0.0125e6 / BEST, 40.0)), high, "RE"),
        (on(2.0).with(push(true, 0.05e6, 0.0)).with(push(false, -0.05e6 / BEST, 0.0)), level, "RE"),
        (on(0.3).with(push(false, 1e5, 3.0 - 4.0 / BEST)), slides, "SL"),
    ] {
        let borne = |λ: f64| {
            let [e, η] = share(λ / BEST);
            (1.0 - e.abs() / 5.0).powi(2) * (1.0 - 0.7 * η.abs()).powi(5)
        };
        let u = borne(BEST) / 1.0001;
        let unit = Ground::new(GroundLaw::Hansen, 30.0, 1.0).unwrap();
        let weight = 1e6 / u / unit.centric_resistance(5.0);
        let ground = Ground::new(GroundLaw::Hansen, 30.0, weight).unwrap();
        let found = outcome(&situation, ground).unwrap().outcome;
        let stage = found.path.iter().find(|stage| stage.from < BEST && BEST < stage.to).unwrap();
        assert_eq!(stage.verdict.unwrap().symbol(), symbol, "{found:?}");
        for end in [stage.from, stage.to] {
            assert!((end - BEST).abs() < 0.005 && (borne(end) / u - 1.0).abs() < 1e-11, "{stage:?}");
        }
    }
}

/// Ground that bears the weight and not a newton more, V₀ = P, does not fail where uplift only takes from it.
#[test]
fn ground_that_just_bears_does_not_fail() {
    let body = Body::new(10.0, 8.0, 200e3).unwrap();
    let up = Load::variable(LoadSource::Uplift, LoadKind::Uplift, Action::vertical(&body, -1e6, 5.0));
    let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(up);
    let factor = |centric| {
        GroundPath::new(Ground::envelope(centric).unwrap(), &situation).unwrap().load_factors().given
    };
    assert_eq!(factor(2e6), f64::INFINITY);
    assert_eq!(factor(2e6 * (1.0 - 1e-12)), 0.0);
}

/// Without surcharge and cohesion R/V₀ is (1−ε)² i(η); the envelope is one where it says.
#[test]
fn laws_are_one_family() {
    let mut random = Random(841);
    for _ in 0..tries(10_000).max(1_000) {
        let (b, p) = (random.uniform(1.0, 10.0), random.log(1e4, 1e7));
        let (η, ε) = (random.uniform(0.0, 0.9), random.uniform(-0.99, 0.99));
        let reaction = Reaction::new(b, p, η * p, ε * b).unwrap();
        let angle = random.uniform(20.0, 50.0);
        for (law, share, n) in [(GroundLaw::Ec7, 1.0, 3), (GroundLaw::Hansen, 0.7, 5)] {
            let ground = Ground::new(law, angle, 11e3).unwrap();
            let expected = (1.0 - ε.abs()).powi(2) * (1.0 - share * η).powi(n);
            let ours = ground.resistance(&reaction) / ground.centric_resistance(b);
            assert!((ours - expected).abs() < 1e-12, "{law:?} {η} {ε}");
        }
        // P = R on the envelope; e on the side of the push strengthens.
        let ground = Ground::envelope(3e6).unwrap();
        let u = ground.resistance(&reaction) / 3e6;
        let left = (η / 0.52).powi(2) + (ε / 0.7).powi(2) - 0.22 * η * ε / (0.52 * 0.35);
        if u > 0.0 {
            assert!((left - (1.0 - u).powi(2)).abs() < 1e-12);
        }
        let mirrored = Reaction::new(b, p, -η * p, -ε * b).unwrap();
        assert_eq!(ground.resistance(&mirrored), ground.resistance(&reaction));
    }
}

/// The corner of rest and the tongue of sliding: k_BF by its formula, k(μ) by its formula, through (k_BF, k_BF).
#[test]
fn the_plane_is_a_corner_and_a_tongue() {
    let mut random = Random(842);
    for _ in 0..tries(5_000).max(500) {
        let (γ, h) = (random.uniform(0.5, 2.5), random.uniform(-0.8, 1.2));
        let angle = random.uniform(25.0, 45.0);
        let ground = Ground::new(GroundLaw::Ec7, angle, 10e3).unwrap();
        let u = random.uniform(0.01, 0.9);
        let p = u * ground.centric_resistance(5.0);
        let plane = BearingPlane::new(ground, γ, h, 5.0, p).unwrap();
        let k = plane.k_bf();
        let left = (1.0 - k * γ * (1.0 + h)).powi(2) * (1.0 - k).powi(3);
        assert!((left - u).abs() < 1e-12, "{γ} {h} {u}: {k} {left}");
        assert!(k < 1.0 / (γ * (1.0 + h)));
        let verdict = |k: f64, mu: f64| plane.at(k, mu).unwrap().verdict.symbol();
        assert_eq!((verdict(k * 0.999, 1.0), verdict(k * 1.001, 2.0)), ("RE", "BF"));
        let own = plane.slide_limit(k);
        assert!(own.is_none_or(|own| h < 0.0 || (own - k).abs() < 1e-9 * k), "{own:?} {k}");
        let mu = k * random.uniform(0.1, 0.99);
        if h > 0.05 {
            let expected = ((1.0 - (u / (1.0 - mu).powi(3)).sqrt()) / γ - mu) / h;
            let limit = plane.slide_limit(mu).unwrap();
            assert!((limit - expected).abs() < 1e-9 * (1.0 + expected), "{limit} {expected}");
            assert_eq!((verdict(limit * 0.999, mu), verdict(limit * 1.001, mu)), ("SL", "BF"));
        }
    }
    let envelope = Ground::envelope(4e6).unwrap();
    let plane = BearingPlane::new(envelope, 0.7, 0.3, 7.5, 2e6).unwrap();
    let lever = 0.7 * 1.3;
    let below: f64 = 1.0 / 0.52f64.powi(2) + (lever / 0.7f64).powi(2) - 0.22 * lever / (0.52 * 0.35);
    assert!((plane.k_bf() - 0.5 / below.sqrt()).abs() < 1e-12);
    assert_eq!(BearingPlane::new(envelope, 0.7, 0.3, 7.5, 5e6).unwrap().k_bf(), 0.0);
}

/// Goda's caisson, with P, M_p and p_u as published with it: 2318.64 kN/m buoyant.
fn goda() -> Situation {
    let body = Body::new(15.0, 10.5, 346.05e3).unwrap();
    let weight =
        Action::Force { at: standfast::loads::BodyPoint { x: 0.0, y: 0.0 }, right: 0.0, up: -2318.64e3 };
    let weight = Load::permanent(LoadSource::Other, LoadKind::Weight, weight);
    let push = Action::horizontal(-940.61e3, 4849.6 / 940.68);
    Situation::new(body, 0.6, 9.81)
        .unwrap()
        .with(weight)
        .with(Load::variable(LoadSource::WavePressure, LoadKind::Horizontal, push))
        .with(Uplift::new(0.0, 65.739e3, true).unwrap().load(&body))
}

/// The ground fails before the caisson slides on 35°, and about when it slides on 40°.
#[test]
fn goda_s_caisson_on_sand() {
    let situation = goda();
    let rigid = situation.outcome().unwrap().departure;
    assert!((rigid.load_factor() - 1.125).abs() < 5e-4, "{rigid:?}");
    let sand = |angle| Ground::new(GroundLaw::Ec7, angle, 10e3).unwrap();
    let path = |angle| GroundPath::new(sand(angle), &situation).unwrap();
    for (angle, factor) in [(35.0, 0.997), (40.0, 1.126), (42.0, 1.172)] {
        let found = path(angle).load_factors();
        assert!((found.given - factor).abs() < 6e-4, "{angle}: {found:?}");
        // There R = P.
        assert!((path(angle).factor(found.given).unwrap() - 1.0).abs() < 1e-9);
        assert!(found.less.unwrap() < found.given && found.given < found.more.unwrap());
    }
    assert_eq!(path(40.0).load_factors().more, Some(path(42.0).load_factors().given));
    for (angle, verdict) in [(35.0, Verdict::BearingFailure), (40.0, Verdict::Begins(Mode::SlideLeft))] {
        let departure = outcome(&situation, sand(angle)).unwrap().outcome.departure;
        let factor = rigid.load_factor().min(path(angle).load_factors().given);
        assert_eq!(departure, Departure::At { factor, verdict: Some(verdict) });
    }
    // P/B' of the full load: 219 kPa.
    let reaction = path(35.0).reaction(1.0).unwrap();
    assert!((reaction.effective_pressure() / 219e3 - 1.0).abs() < 3e-3, "{}", reaction.effective_pressure());
}

/// A situation on its ground says what the plane does: by its verdict under the full load, at every stage of the rising load, and where it leaves
/// rest. The plane is written in k and μ, the situation in metres and newtons.
#[test]
fn a_situation_is_a_point_of_the_plane() {
    let mut random = Random(843);
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..tries(2_000).max(300) {
        let (γ, h, k, mu) = (
            random.uniform(0.5, 2.5),
            random.uniform(-0.9, 1.0),
            random.uniform(0.02, 1.2),
            random.uniform(0.1, 1.2),
        );
        let (b, mass) = (random.uniform(1.0, 8.0), random.log(1e4, 1e6));
        let p = mass * 9.81;
        let ground = match random.uniform(0.0, 1.0) < 0.5 {
            true => Ground::envelope(p / random.uniform(0.05, 1.05)).unwrap(),
            false => {
                Ground::new(GroundLaw::Hansen, random.uniform(20.0, 50.0), random.log(1e3, 1e5)).unwrap()
            }
        };
        let body = Body::new(2.0 * b, 2.0 * γ * b, mass).unwrap();
        let push = Action::horizontal(-k * p, (1.0 + h) * γ * b);
        let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, push);
        let situation = Situation::new(body, mu, 9.81).unwrap().with_weight().with(push);
        let BearingOutcome { outcome: found, load_factors, .. } = outcome(&situation, ground).unwrap();
        let plane = BearingPlane::new(ground, γ, h, b, p).unwrap();
        let expected = |λ: f64| plane.at(λ * k, mu).unwrap().verdict;
        assert_eq!(found.full.verdict, Some(expected(1.0)), "{γ} {h} {k} {mu}");
        seen.insert(found.full.verdict.unwrap().symbol());
        for stage in &found.path {
            let end = if stage.to.is_finite() { stage.to } else { 3.0 * stage.from + 1.0 };
            for share in [1e-6, 0.3, 0.9, 1.0 - 1e-6] {
                let λ = stage.from + share * (end - stage.from);
                assert_eq!(stage.verdict, Some(expected(λ)), "{γ} {h} {k} {mu} at {λ}: {stage:?}");
            }
        }
        // The departure said without the path: that of rigid ground, or failure before it.
        let rigid = situation.outcome().unwrap().departure;
        assert_eq!(load_factors, GroundPath::new(ground, &situation).unwrap().load_factors());
        let first = rigid.load_factor() <= load_factors.given;
        let verdict = if first { rigid.verdict() } else { Some(Verdict::BearingFailure) };
        assert_eq!(found.departure.verdict(), verdict);
        let [one, two] = [found.departure.load_factor(), rigid.load_factor().min(load_factors.given)];
        assert!(one == two || (one / two - 1.0).abs() < 1e-12, "{one} {two}");
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), ["BF", "RE", "SL"]);
}

/// Uplift that grows: the ground fails, and bears again once little is left of the weight and friction holds nothing more; nothing but flight is left
/// of a body that is lifted.
#[test]
fn ground_under_uplift() {
    let body = Body::new(10.0, 8.0, 200e3).unwrap();
    let up = Load::variable(LoadSource::Uplift, LoadKind::Uplift, Action::vertical(&body, -2.5e6, 5.0));
    let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(up);
    // 2000 kN/m on ground of 1500: fails until a quarter of it is lifted, at λ = 0.2; off at 0.8.
    let BearingOutcome { outcome: found, load_factors, .. } =
        outcome(&situation, Ground::envelope(1.5e6).unwrap()).unwrap();
    let stages: Vec<_> =
        found.path.iter().map(|stage| (stage.verdict.unwrap().symbol(), stage.from)).collect();
    assert_eq!(stages.iter().map(|(symbol, _)| *symbol).collect::<Vec<_>>(), ["BF", "RE", "FL"]);
    assert!((stages[1].1 - 0.2).abs() < 1e-12 && (stages[2].1 - 0.8).abs() < 1e-12, "{stages:?}");
    assert!(matches!(found.departure, Departure::AtOnce { permanent: true, .. }));
    assert_eq!(load_factors.given, 0.0);
    assert_eq!((found.full.verdict.unwrap().symbol(), found.full.modes.len()), ("FL", 1));
}

/// No failure is passed over: the load factor is the first of a fine walk at which R < P, though uplift takes all of P off soon after, or
/// a permanent force points the other way.
#[test]
fn the_ground_s_load_factor_is_the_first() {
    let mut random = Random(811);
    let mut found = [0; 3];
    let count = tries(150).max(30);
    for i in 0..count {
        let [width, height] = [random.uniform(5.0, 20.0), random.uniform(3.0, 15.0)];
        let body = Body::new(width, height, width * height * 2000.0).unwrap();
        let weight = body.mass() * 9.81;
        let push = |share: f64, elevation: f64| Action::horizontal(share * weight, elevation * height);
        let load = |permanent: bool, action| match permanent {
            true => Load::permanent(LoadSource::Force, LoadKind::Horizontal, action),
            false => Load::variable(LoadSource::Force, LoadKind::Horizontal, action),
        };
        let back = push(random.uniform(0.0, 0.15), random.uniform(0.0, 1.0));
        let forth = push(-random.log(0.03, 3.0), random.uniform(0.0, 1.2));
        let mut situation = Situation::new(body, 0.6, 9.81).unwrap().with_weight();
        situation = situation.with(load(true, back)).with(load(false, forth));
        if random.coin() {
            let uplift = random.uniform(0.0, 3.0) * weight / width;
            situation = situation.with(Uplift::new(0.3 * uplift, uplift, true).unwrap().load(&body));
        }
        let angle = random.uniform(25.0, 45.0);
        let soil = |law| Ground::new(law, angle, 10e3).unwrap();
        let share = random.uniform(0.1, 0.6);
        let ground = match i % 4 {
            0 => soil(GroundLaw::Ec7),
            1 => soil(GroundLaw::Hansen).with_surcharge(random.uniform(0.0, 50e3)).unwrap(),
            2 => soil(GroundLaw::Ec7).with_cohesion(random.uniform(0.0, 20e3)).unwrap(),
            _ => Ground::envelope(weight / share).unwrap(),
        };
        let path = GroundPath::new(ground, &situation).unwrap();
        let factor = path.load_factors().given;
        let fails = |λ: f64| path.factor(λ).is_some_and(|factor| factor < 1.0);
        let walk = (0..4000).map(|i| 0.0025 * f64::from(i)).find(|λ| fails(*λ));
        match walk {
            Some(0.0) => assert_eq!(factor, 0.0),
            Some(first) => {
                assert!(factor <= first && factor > first - 0.0025 * 1.001, "{factor} {first}: {path:?}");
                assert!((path.factor(factor).unwrap() - 1.0).abs() < 1e-6, "{factor}: {path:?}");
            }
            // The walk may step over what the search finds.
            None => assert!(factor >= 9.99 || path.factor(factor).is_some_and(|r| (r - 1.0).abs() < 1e-6)),
        }
        found[match walk {
            Some(0.0) => 0,
            Some(_) => 1,
            None => 2,
        }] += 1;
    }
    assert!(found[1] > count / 3, "{found:?}");
}

/// Of a body that its permanent loads lift nothing presses under any load factor; that is found without a search.
#[test]
fn nothing_fails_under_a_body_that_is_lifted() {
    let body = Body::new(10.0, 8.0, 200e3).unwrap();
    let lift = Load::permanent(LoadSource::Uplift, LoadKind::Uplift, Action::vertical(&body, -2.1e6, 5.0));
    let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-1e4, 4.0));
    let situation = Situation::new(body, 0.6, 10.0).unwrap().with_weight().with(lift).with(push);
    let ground = Ground::new(GroundLaw::Hansen, 40.0, 1e4).unwrap();
    let found = GroundPath::new(ground, &situation).unwrap().load_factors();
    assert_eq!([Some(found.given), found.less, found.more], [Some(f64::INFINITY); 3]);
}

#[test]
fn wrong_numbers_are_shown() {
    let message = |angle, weight| Ground::new(GroundLaw::Ec7, angle, weight).unwrap_err().to_string();
    assert_eq!(
        message(19.9, 1e4),
        "angle of friction of the ground is 19.9; expected an angle from 20 to 50 degrees"
    );
    assert_eq!(
        message(f64::NAN, 1e4),
        "angle of friction of the ground is NaN; expected an angle from 20 to 50 degrees"
    );
    assert!(message(30.0, -1e4).starts_with("effective unit weight of the ground is -10000"));
    let sand = Ground::new(GroundLaw::Ec7, 20.0, 1e4).unwrap();
    assert_eq!(sand.with_cohesion(-1.0).unwrap_err().quantity, Quantity::Cohesion);
    assert_eq!(sand.with_surcharge(-1.0).unwrap_err().quantity, Quantity::Surcharge);
    assert_eq!(Ground::envelope_with(1e6, 0.5, 0.3, 2.0).unwrap_err().value, 2.0);
    // φ − 2° leaves the range without an error.
    assert_eq!(sand.turned(-2.0).unwrap().friction_angle_deg(), Some(18.0));
    let drum = Situation::new(Body::cylinder(2.0, 3.0, 25e3).unwrap(), 0.6, 9.81).unwrap();
    assert_eq!(
        GroundPath::new(sand, &drum).unwrap_err().to_string(),
        "width is 2; expected none for a round base: the formulas are those of a strip"
    );
}

/// groundhog's numbers for the same formula, as `validation/peers/bearing.py` writes them.
#[test]
fn groundhog_bears_the_same() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/peers/bearing.csv");
    let table = std::fs::read_to_string(path).unwrap();
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [angle, weight, surcharge, width, inclination, resistance, length] = numbers[..] else {
            panic!("{line}")
        };
        let ground = Ground::new(GroundLaw::Hansen, angle, weight * 1e3).unwrap();
        let ground = ground.with_surcharge(surcharge * 1e3).unwrap().with_length(length).unwrap();
        let reaction = Reaction::new(width / 2.0, 1e6, inclination * 1e6, 0.0).unwrap();
        let ours = ground.resistance(&reaction) / 1e3;
        assert!((ours / resistance - 1.0).abs() < 1e-8, "{line}: {ours}");
        rows += 1;
    }
    assert_eq!(rows, 336);
}

/// Clay that does not drain, by hand: c_u = 60, q = 20 kN/m², B = 2 m, e = 0.5 m, X = 72 kN/m. B' = 3 m: i_c = ½ (1 + √(1 − 72/180)), and R = 3 [5.14159 · 60 i_c + 20].
/// At X = B' c_u half of the strength is left; beyond it the body slides within the clay, and nothing is.
#[test]
fn clay_by_hand() {
    let clay = Ground::undrained(60e3).unwrap().with_surcharge(20e3).unwrap();
    let of =
        |ground: &Ground, x: f64, e: f64| ground.resistance(&Reaction::new(2.0, 300e3, x, e).unwrap()) / 1e3;
    let by_hand = 3.0 * (5.141_592_654 * 60.0 * 0.887_298_335 + 20.0);
    for (x, e) in [(72e3, 0.5), (-72e3, 0.5), (72e3, -0.5)] {
        assert!((of(&clay, x, e) / by_hand - 1.0).abs() < 1e-9, "{} {by_hand}", of(&clay, x, e));
    }
    assert!((of(&clay, 180e3, 0.5) / (3.0 * (2.570_796_327 * 60.0 + 20.0)) - 1.0).abs() < 1e-9);
    assert_eq!(of(&clay, 180.1e3, 0.5), 0.0);
    assert_eq!(of(&clay, 0.0, 2.0), 0.0);
    assert!((clay.centric_resistance(2.0) / 4e3 - (5.141_592_654 * 60.0 + 20.0)).abs() < 1e-5);
    // A square of 4 m: s_c = 1.2. A base of 6 m under B' = 3 m: 1.1.
    let square = clay.with_length(4.0).unwrap();
    assert!((square.centric_resistance(2.0) / 4e3 - (1.2 * 5.141_592_654 * 60.0 + 20.0)).abs() < 1e-5);
    let base = clay.with_length(6.0).unwrap();
    let by_hand = 3.0 * (1.1 * 5.141_592_654 * 60.0 * 0.887_298_335 + 20.0);
    assert!((of(&base, 72e3, 0.5) / by_hand - 1.0).abs() < 1e-9);
    assert_eq!((clay.law(), clay.law_name(), clay.undrained_strength()), (None, "undrained", Some(60e3)));
    assert_eq!((clay.turned(2.0), clay.factors(), clay.is_envelope()), (None, None, false));
    assert!(Ground::undrained(0.0).is_err());
    // Divided by γ_R, and in units of B and P.
    assert!((of(&clay.divided(1.4), 72e3, 0.5) * 1.4 / of(&clay, 72e3, 0.5) - 1.0).abs() < 1e-12);
    let metres = BearingPlane::new(clay, 0.7, 0.4, 7.5, 2e6).unwrap();
    let pure = BearingPlane::of_share(clay, 0.7, 0.4, metres.share()).unwrap();
    assert!((metres.k_bf() - pure.k_bf()).abs() < 1e-12);
}

/// A wall on clay under a force that grows: λ_ground is where R falls to P, found here by bisection of the formula written out, and where the force exceeds
/// what adheres before that, there.
#[test]
fn clay_under_a_load_that_rises() {
    let mut random = Random(7);
    for _ in 0..tries(2000) {
        let mut within = |from: f64, to: f64| random.uniform(from, to);
        let (width, height, mass) = (within(4.0, 12.0), within(3.0, 9.0), within(4e4, 3e5));
        let (c_u, q, elevation) = (within(20e3, 200e3), within(0.0, 40e3), within(0.0, 9.0));
        let push = within(5e4, 3e5);
        let clay = Ground::undrained(c_u).unwrap().with_surcharge(q).unwrap();
        let body = Body::new(width, height, mass).unwrap();
        let load = Load::variable(
            LoadSource::Force,
            LoadKind::Horizontal,
            Action::horizontal(-push, elevation.min(height)),
        );
        let situation = Situation::new(body, 0.9, 9.81).unwrap().with_weight().with(load);
        let found = GroundPath::new(clay, &situation).unwrap().load_factors();
        let p = mass * 9.81;
        let bears = |factor: f64| {
            let (x, e) = (factor * push, factor * push * elevation.min(height) / p);
            let effective = width - 2.0 * e;
            if effective <= 0.0 || x > effective * c_u {
                return false;
            }
            let i_c = 0.5 * (1.0 + (1.0 - x / (effective * c_u)).sqrt());
            effective * ((std::f64::consts::PI + 2.0) * c_u * i_c + q) >= p
        };
        if !bears(0.0) {
            assert_eq!(found.given, 0.0);
            continue;
        }
        let (mut low, mut high) = (0.0, 1e4);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if bears(middle) { low = middle } else { high = middle }
        }
        assert!((found.given / low - 1.0).abs() < 1e-9, "{found:?} {low}");
        assert_eq!((found.less, found.more), (None, None));
    }
}
