//! A base that crushes: the decision against the enumeration, both against the laws they stand for, the rigid limit, rational
//! arithmetic on boundaries, the plane's curves, paths, and a base of fibres.

mod common;

use common::{Random, tries};
use dashu_ratio::RBig as Rational;
use standfast::Verdict::{self, BearingFailure, Begins};
use standfast::batch::{Columns, OnsetColumns, classify_on_base, onset_on_base};
use standfast::contact::{self, Block};
use standfast::ground::strength::{
    CrushChart, CrushMap, CrushMotion, CrushOutcome, CrushPoint, Stretch, outcome, rest_range, solve, stages,
};
use standfast::initiation::{Chart, PointName};
use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::{Body, Corner, Departure, Diagram, Mode, Modes, Motion, Point, Situation, Wrench};

/// ω over its range: ordinary, small, fractions that meet boundaries exactly, ½, and near 1.
fn random_omega(random: &mut Random) -> f64 {
    match random.bits() % 5 {
        0 => random.uniform(0.0, 0.5),
        1 => random.uniform(0.5, 1.0),
        2 => random.log(1e-12, 1e-1),
        3 => random.pick(&[0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875]),
        _ => 1.0 - random.log(1e-9, 1e-1),
    }
}

fn random_point(random: &mut Random) -> CrushPoint {
    let [gamma, k_prime, k, mu] = random.point();
    CrushPoint::new(gamma, k_prime, k, mu, random_omega(random)).unwrap()
}

/// The report's block as any block: lengths in B, forces in m g.
fn as_block(point: &CrushPoint) -> (Block, Wrench, f64) {
    let at = point.point();
    let block = Block::uniform(at.gamma(), at.mu());
    let wrench = Wrench { x: -at.k(), p: 1.0, m: at.k() * at.k_prime() * at.gamma() };
    (block, wrench, 0.5 / point.omega())
}

/// The enumeration holds the decision, is never empty, and has one mode below μ_P.
#[test]
fn the_enumeration_contains_the_decision() {
    let mut random = Random(801);
    let (mut seen, mut several) = (Modes::NONE, Modes::NONE);
    for _ in 0..tries(100_000).max(3_000) {
        let point = random_point(&mut random);
        let modes = point.enumerate();
        let mode = point.verdict().mode().unwrap();
        assert!(modes.contains(mode), "{point:?}: {mode} of {modes}");
        seen.insert(mode);
        if modes.len() > 1 {
            several.insert(mode);
            assert!(point.point().mu() > point.bound() * (1.0 - 1e-12), "{point:?}: {modes}");
        }
        assert_eq!(point.others(), modes.without(Some(mode)), "{point:?}");
    }
    assert_eq!(seen.to_string(), "RE SL RO SRO- SRO+ SRO'- RO'");
    assert!(several.len() >= 2, "{several}");
}

/// The report's order of decision is that of the general problem.
#[test]
fn the_general_problem_reports_the_same() {
    let mut random = Random(802);
    for _ in 0..tries(50_000).max(2_000) {
        let point = random_point(&mut random);
        let (block, wrench, strength) = as_block(&point);
        let general = solve(&block, &wrench, strength).unwrap();
        if general.verdict() == Some(point.verdict()) {
            continue;
        }
        // ρ², m and q of the general problem are rounded: only next to a boundary may it say something else.
        let nearby = (0..64).map(|i| {
            let at = point.point();
            let aside = |bit: i32, x: f64| x * (1.0 + if i >> bit & 1 == 0 { 1e-13 } else { -1e-13 });
            let [g, h, k, m] =
                [aside(0, at.gamma()), aside(1, at.k_prime()), aside(2, at.k()), aside(3, at.mu())];
            CrushPoint::new(g, h, k, m, aside(4, point.omega())).unwrap().verdict()
        });
        let found = general.verdict().unwrap();
        assert!(nearby.into_iter().any(|verdict| verdict == found), "{point:?}: {found}");
    }
}

/// ω = 0 and an infinite strength are the rigid base, in modes and motions; a small ω is near it.
#[test]
fn a_strong_base_is_the_rigid_one() {
    let mut random = Random(803);
    for _ in 0..tries(50_000).max(2_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let rigid = Point::new(gamma, k_prime, k, mu).unwrap();
        let point = CrushPoint::of(rigid, 0.0).unwrap();
        assert_eq!(point.verdict(), Begins(rigid.mode()));
        assert_eq!(point.motion().unwrap().motion, rigid.motion());
        let mut all = rigid.others();
        all.insert(rigid.mode());
        assert_eq!(point.enumerate(), all, "{point:?}");
        // On a strong base the same to round-off, as far from a boundary as the strength moves it.
        let strong = CrushPoint::of(rigid, 1e-15).unwrap();
        if strong.verdict() == Begins(rigid.mode()) {
            let (one, two) = (strong.motion().unwrap().motion, rigid.motion());
            let size = 1.0 + k + two.theta_ddot.abs() * (1.0 + gamma) + two.f_x.abs();
            // Next to Painlevé's bound the equation is level and α as uncertain as its slope is small.
            if mu < 0.9 * point.bound() || rigid.mode().slip().is_none() {
                assert!(difference(&one, &two) < 1e-12 * size * size, "{point:?}: {one:?} {two:?}");
            }
        }
    }
    // Any wrench.
    for _ in 0..tries(50_000).max(2_000) {
        let (block, wrench) = random_case(&mut random);
        let (ours, rigid) =
            (solve(&block, &wrench, f64::INFINITY).unwrap(), contact::solve(&block, &wrench).unwrap());
        if wrench.p > 0.0 {
            assert_eq!(ours.modes, rigid.modes, "{block:?} {wrench:?}");
        }
        for mode in ours.modes.iter().filter(|mode| rigid.modes.contains(*mode)) {
            let (one, two) = (ours.motion(mode).unwrap().motion, rigid.motion(mode).unwrap());
            let size = 1.0 + two.theta_ddot.abs();
            assert!(difference(&one, &two) < 1e-10 * size * size, "{block:?} {wrench:?} {mode}");
        }
    }
}

fn difference(one: &Motion, two: &Motion) -> f64 {
    let all = |m: &Motion| [m.x_ddot, m.y_ddot, m.theta_ddot, m.f_x, m.f_y, m.slip, m.lift_o_prime];
    all(one).into_iter().zip(all(two)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// A random block with a wrench that presses (now and then lifts), in dyadic numbers half the time.
fn random_case(random: &mut Random) -> (Block, Wrench) {
    let coarse = random.coin();
    let mut positive = |high: f64| {
        let value = random.uniform(0.05, high);
        if coarse { (value * 8.0).ceil() / 8.0 } else { value }
    };
    let [b1, b2, d, rho2, m_x, m_y] =
        [positive(2.0), positive(2.0), positive(4.0), positive(3.0), positive(3.0), positive(3.0)];
    let mu_k = positive(2.5);
    let block = Block { b1, b2, d, rho2, m_x, m_y, mu_s: mu_k, mu_k };
    let mut any = |size: f64| {
        let value = random.uniform(-size, size);
        if coarse { (value * 8.0).round() / 8.0 } else { value }
    };
    (block, Wrench { x: any(4.0), p: any(2.0) + 1.5, m: any(4.0) })
}

/// Newton, Coulomb and the plastic law from their definitions: pressure where the base goes down, none where it lifts.
fn assert_lawful(block: &Block, wrench: &Wrench, strength: f64, mode: Mode, found: &CrushMotion) {
    let Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k } = *block;
    let Wrench { x, p, m } = *wrench;
    let CrushMotion { motion, pressed: Stretch { from, to }, neutral } = *found;
    let context = || format!("{block:?} {wrench:?} {strength} {mode}: {found:?}");
    let size = 1.0 + x.abs() + p.abs() + m.abs() + motion.theta_ddot.abs() * (rho2 + d + b1 + b2 + m_y);
    let zero = |value: f64| assert!(value.abs() < 1e-11 * size * (1.0 + d), "{value}: {}", context());
    zero(m_x * motion.x_ddot - motion.f_x - x);
    zero(m_y * motion.y_ddot - motion.f_y + p);
    zero(rho2 * motion.theta_ddot - motion.f_x * d - motion.f_y * motion.xi - m);
    zero(motion.slip - motion.x_ddot - d * motion.theta_ddot);
    // What the pressed part bears.
    zero(motion.f_y - strength * (to - from));
    zero(motion.f_y * (motion.xi - (from + to) / 2.0));
    assert!(from >= -b1 - 1e-9 && to <= b2 + 1e-9, "{}", context());
    let down = |at: f64| motion.y_ddot + at * motion.theta_ddot;
    if let Some(neutral) = neutral {
        zero(down(neutral));
        assert!(down((from + to) / 2.0) <= 1e-12 * size, "{}", context());
        let (edge, far) = match mode.corner().unwrap() {
            Corner::O => (-b1, b2),
            Corner::OPrime => (b2, -b1),
        };
        assert!((edge == from || edge == to) && (neutral == from || neutral == to), "{}", context());
        assert!(down(far) > 0.0 && down(edge) <= 0.0, "{}", context());
    }
    match mode.slip() {
        Some(slip) => {
            zero(motion.f_x + slip.sign() * mu_k * motion.f_y);
            assert!(slip.sign() * motion.slip > -1e-9 * size, "{}", context());
        }
        None => {
            assert_eq!(motion.slip, 0.0);
            assert!(motion.f_x.abs() <= mu_s * motion.f_y + 1e-9 * size, "{}", context());
        }
    }
}

#[test]
fn every_motion_obeys_the_laws() {
    let mut random = Random(804);
    for _ in 0..tries(100_000).max(3_000) {
        let point = random_point(&mut random);
        let (block, wrench, strength) = as_block(&point);
        for mode in point.enumerate().iter() {
            if point.omega() < 1e-4 {
                continue; // the pressed width is rounding
            }
            assert_lawful(&block, &wrench, strength, mode, &point.motion_in(mode).unwrap());
        }
    }
    let mut lifted = 0;
    for _ in 0..tries(100_000).max(3_000) {
        let (mut block, wrench) = random_case(&mut random);
        if random.coin() {
            block.mu_s += random.uniform(0.0, 1.0);
        }
        let strength = random.log(0.3, 1e3);
        let answer = solve(&block, &wrench, strength).unwrap();
        if answer.verdict() == Some(BearingFailure) {
            assert!(answer.modes.is_empty() && answer.omega() > 1.0 - 1e-12);
            continue;
        }
        assert!(answer.omega() < 1.0 + 1e-12 && !answer.modes.is_empty(), "{block:?} {wrench:?} {strength}");
        for mode in answer.modes.iter().filter(|mode| *mode != Mode::Flight) {
            lifted += u32::from(wrench.p <= 0.0);
            assert_lawful(&block, &wrench, strength, mode, &answer.motion(mode).unwrap());
        }
    }
    assert!(lifted > 0);
}

/// Below the bound one mode only, and what is seen in a mirror is mirrored.
#[test]
fn any_wrench_has_one_mode_below_the_bound_and_a_mirror() {
    let mut random = Random(805);
    let mut several = 0;
    for _ in 0..tries(100_000).max(3_000) {
        let (block, wrench) = random_case(&mut random);
        let strength = random.log(0.3, 1e3);
        let answer = solve(&block, &wrench, strength).unwrap();
        let mirrored = solve(
            &Block { b1: block.b2, b2: block.b1, ..block },
            &Wrench { x: -wrench.x, p: wrench.p, m: -wrench.m },
            strength,
        )
        .unwrap();
        assert_eq!(mirrored.modes, answer.modes.mirrored());
        if answer.modes.len() == 1 {
            assert_eq!(mirrored.verdict(), answer.verdict().map(Verdict::mirrored));
        }
        if wrench.p > 0.0 && answer.modes.len() > 1 {
            several += 1;
            assert!(
                block.mu_k > answer.bound() * (1.0 - 1e-12),
                "{block:?} {wrench:?} {strength}: {}",
                answer.modes
            );
        }
        for mode in answer.modes.iter() {
            let (one, two) = (answer.motion(mode).unwrap(), mirrored.motion(mode.mirrored()).unwrap());
            let size = 1.0 + one.motion.theta_ddot.abs();
            assert!(difference(&one.motion, &two.mirrored().motion) < 1e-9 * size, "{block:?} {wrench:?}");
        }
    }
    assert!(several > 0);
}

fn rational(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// The decision in rational arithmetic, with quotients; rock's cubic by bisection of a rational bracket until the friction's sign
/// is certain. Shares nothing with the library.
fn oracle(point: &CrushPoint) -> Mode {
    let at = point.point();
    let [γ, h, k, μ, ω] = [at.gamma(), at.k_prime(), at.k(), at.mu(), point.omega()].map(rational);
    let [zero, one, two, three, four] = [0.0, 1.0, 2.0, 3.0, 4.0].map(rational);
    let room = &one - &ω;
    let beyond = h < -one.clone();
    let side = if beyond { -one.clone() } else { one.clone() };
    let tip = &side * &k * &γ * (&one + &h);
    if μ >= k && tip <= room {
        return Mode::Rest;
    }
    let slide = &γ * (&μ + &k * &h);
    if !beyond && slide < -room.clone() {
        return Mode::SlideRockOPrimeLeft;
    }
    if μ < k && slide <= room && slide >= -room.clone() {
        return Mode::SlideLeft;
    }
    if tip <= room {
        return Mode::SlideRockOPrimeLeft;
    }
    let inertia = (&one + &four * &γ * &γ) / &three;
    let normal = |a: &Rational| (&one + a) / (&one + &two * &ω * a);
    let excess = |a: &Rational| {
        let n = normal(a);
        &inertia * a + &n * (&one - &ω * &n) - &tip
    };
    let (mut low, mut high) = (zero.clone(), &tip / &inertia);
    assert!(excess(&low) < zero && excess(&high) >= zero);
    let at_k = |a: &Rational| &k - &side * &γ * a;
    for _ in 0..160 {
        // f_x is monotone in α, and so is N: between both ends they are between theirs.
        let (f, n) = ([at_k(&low), at_k(&high)], [normal(&low), normal(&high)]);
        let most = |x: &[Rational; 2]| if x[0] > x[1] { x[0].clone() } else { x[1].clone() };
        let least = |x: &[Rational; 2]| if x[0] < x[1] { x[0].clone() } else { x[1].clone() };
        let left = if beyond { Mode::SlideRockOPrimeLeft } else { Mode::SlideRockOLeft };
        if least(&f) > &μ * most(&n) {
            return left;
        }
        if -most(&f) > &μ * most(&n) {
            return Mode::SlideRockORight;
        }
        if most(&f) <= &μ * least(&n) && -least(&f) <= &μ * least(&n) {
            return if beyond { Mode::RockOPrime } else { Mode::RockO };
        }
        let middle = (&low + &high) / &two;
        // Exactly on the boundary at a rational root.
        if excess(&middle) == zero {
            (low, high) = (middle.clone(), middle);
            continue;
        }
        if excess(&middle) < zero { low = middle } else { high = middle }
    }
    // Closer than 2⁻¹⁶⁰ is on it: numbers of 53 bits come no nearer.
    if beyond { Mode::RockOPrime } else { Mode::RockO }
}

/// Random points, points within three ulps of every boundary whose condition is a polynomial, and next to RO|SRO.
#[test]
fn the_decision_is_that_of_rational_arithmetic() {
    let mut random = Random(806);
    let mut seen = Modes::NONE;
    for i in 0..tries(20_000).max(800) {
        let [mut gamma, k_prime, mut k, mut mu] = random.point();
        let mut omega = random_omega(&mut random);
        let Ok(chart) = CrushChart::new(gamma, k_prime, omega) else { continue };
        match i % 8 {
            0 => {}
            1 => mu = k,
            2 => k = chart.k_a(),
            3 => mu = chart.upper_line().at(k),
            4 => mu = chart.lower_line().at(k),
            5 => mu = chart.mu_star(k).unwrap_or(mu),
            6 => (k, mu) = (chart.k_a(), chart.k_a()),
            _ => {
                // ω, k, γ in eighths: α of rock is often rational, and the point on the boundary.
                omega = 0.5;
                gamma = random.pick(&[0.5, 1.0, 2.0]);
            }
        }
        let [k, mu] = [k, mu].map(|x| if i % 8 == 0 { x } else { random.nudge(x) });
        if !(0.0..1e6).contains(&k) || !(0.0..1e6).contains(&mu) {
            continue;
        }
        let point = CrushPoint::new(gamma, k_prime, k, mu, omega).unwrap();
        let expected = oracle(&point);
        assert_eq!(point.verdict(), Begins(expected), "{point:?}");
        assert!(point.enumerate().contains(expected), "{point:?}");
        seen.insert(expected);
    }
    assert_eq!(seen.to_string(), "RE SL RO SRO- SRO+ SRO'- RO'");
}

/// At ω = ½ N is 1, R is ½, and α = (kG₁ − ½)/J is rational: friction meets its bound exactly.
#[test]
fn a_point_on_the_curve_rocks() {
    // γ = 1, J = 5/3, k' = 1: α = (2k − ½)·3/5; at k = 4, α = 4.5 and f_x = −½.
    let at = |mu| CrushPoint::new(1.0, 1.0, 4.0, mu, 0.5).unwrap();
    assert_eq!(at(0.5).verdict(), Begins(Mode::RockO));
    assert_eq!(at(0.5f64.next_down()).verdict(), Begins(Mode::SlideRockORight));
    assert_eq!(at(0.5).enumerate().to_string(), "RO");
    let found = at(0.5).motion().unwrap();
    assert_eq!((found.motion.theta_ddot, found.motion.f_x, found.motion.f_y), (4.5, -0.5, 1.0));
    assert_eq!((found.neutral, found.motion.xi), (Some(0.0), -0.5));
}

/// μ_s would hold it upright, and is more than it can use as it tips over the edge that crushes: it slides, with μ_k.
#[test]
fn a_body_that_presses_less_as_it_tips_slides() {
    let block =
        Block { b1: 1.75, b2: 0.25, d: 0.25, rho2: 2.5, m_x: 3.0, m_y: 2.125, mu_s: 1.2728, mu_k: 0.5 };
    let wrench = Wrench { x: 3.0, p: 2.375, m: 0.875 };
    assert!(wrench.x < block.mu_s * wrench.p);
    let answer = solve(&block, &wrench, 2.568).unwrap();
    assert_eq!((answer.verdict(), answer.modes.len()), (Some(Begins(Mode::SlideRight)), 1));
    assert_lawful(&block, &wrench, 2.568, Mode::SlideRight, &answer.motion(Mode::SlideRight).unwrap());
}

#[test]
fn a_base_that_cannot_carry_its_load_fails() {
    for omega in [1.0, 1.5, 1e9] {
        let point = CrushPoint::new(1.0, 0.4, 0.1, 0.6, omega).unwrap();
        assert_eq!((point.verdict(), point.motion(), point.others()), (BearingFailure, None, Modes::NONE));
    }
    assert_eq!(CrushPoint::new(1.0, 0.4, 0.0, 0.6, 1f64.next_down()).unwrap().verdict(), Begins(Mode::Rest));
    let block = Block::uniform(1.0, 0.6);
    let wrench = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    assert_eq!(solve(&block, &wrench, 0.5).unwrap().verdict(), Some(BearingFailure));
    assert_eq!(solve(&block, &wrench, 0.5f64.next_up()).unwrap().verdict(), Some(Begins(Mode::Rest)));
}

#[test]
fn wrong_numbers_are_shown() {
    let message = |omega| CrushPoint::new(1.0, 0.4, 0.1, 0.6, omega).unwrap_err().to_string();
    assert_eq!(message(-0.1), "share ω of the base is -0.1; expected a number from 0 to 1e50");
    assert_eq!(message(f64::NAN), "share ω of the base is NaN; expected a number from 0 to 1e50");
    let wrench = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    for bad in [0.0, -1.0, f64::NAN] {
        let error = solve(&Block::uniform(1.0, 0.6), &wrench, bad).unwrap_err();
        assert_eq!(error.quantity, standfast::Quantity::Strength);
    }
    assert_eq!(
        CrushChart::new(1.0, 0.4, 1.0).unwrap_err().to_string(),
        "share ω of the base is 1; expected a number from 0 to below 1"
    );
}

/// Bodies, elevations and strengths of every kind of plane.
fn charts() -> Vec<CrushChart> {
    let mut charts = Vec::new();
    for gamma in [0.3, 0.5f64.sqrt(), 1.0, 2.0, 4.0, 10.0] {
        let percussion = (1.0 + gamma * gamma) / (3.0 * gamma * gamma);
        for k_prime in [-3.0, -1.2, -0.95, -0.6, -0.2, 0.0, 0.4, 0.8, 1.0, 1.7, percussion, 1.5 * percussion]
        {
            for omega in [0.01, 0.08, 0.2, 0.5, 0.8] {
                charts.push(CrushChart::new(gamma, k_prime, omega).unwrap());
            }
        }
    }
    charts
}

/// On the curve between rock and slide-rock the motions of both satisfy their equations: N, R and f_x from the pressed width and
/// the laws, not from the chart.
#[test]
fn every_point_of_the_curve_satisfies_both_modes() {
    let mut random = Random(811);
    for chart in charts() {
        let (γ, h, ω) = (chart.gamma(), chart.k_prime(), chart.omega());
        let side = if h < -1.0 { -1.0 } else { 1.0 };
        for _ in 0..40 {
            let at = chart.rock_at(random.log(1e-6, 1e3));
            // c from where the base does not move: (1 − c)·α = ÿ, and N = c/(2ω) = 1 + ÿ.
            let c = 2.0 * ω * (1.0 + at.alpha) / (1.0 + 2.0 * ω * at.alpha);
            let (n, r) = (c / (2.0 * ω), c / (2.0 * ω) * (1.0 - c / 2.0));
            let size = r + at.k * γ * (1.0 + h.abs()) + at.alpha * (1.0 + γ * γ);
            let close = |left: f64, right: f64| {
                assert!((left - right).abs() <= 1e-12 * size, "{chart:?} {at:?}: {left} {right}");
            };
            close(n - 1.0, (1.0 - c) * at.alpha);
            let f_x = at.k - side * γ * at.alpha;
            // RO: about C, with the reaction that keeps the edge where it is.
            close((1.0 + γ * γ) / 3.0 * at.alpha + r, side * (at.k * h * γ + γ * f_x));
            // SRO: the same with f_x = ±μN.
            close(f_x.abs() * γ, at.mu * n * γ);
            // Just above it rocks, just below it slide-rocks (where no other mode comes first).
            let verdict = |mu: f64| CrushPoint::new(γ, h, at.k, mu, ω).unwrap().enumerate();
            if at.mu > 1e-6 && at.mu < 1e3 && at.alpha > 1e-3 {
                let rock = if h < -1.0 { Mode::RockOPrime } else { Mode::RockO };
                let above = verdict(at.mu * (1.0 + 1e-9));
                let below = verdict(at.mu * (1.0 - 1e-9));
                assert!(above.contains(rock) && !below.contains(rock), "{chart:?} {at:?}: {below} {above}");
            }
        }
        assert!((chart.k_a() - chart.rock_at(0.0).k).abs() <= 1e-15 * chart.k_a());
    }
}

/// A, C, D, E on the curves that define them, moved inwards; near A the rotation of the specification.
#[test]
fn named_points_are_where_curves_meet() {
    for chart in charts() {
        let rigid = Chart::new(chart.gamma(), chart.k_prime()).unwrap();
        for point in chart.points() {
            let Some(there) = rigid.point(point.name) else {
                // On a base that crushes μ* falls to zero from k'_P on, not only for a < 0.
                assert_eq!(point.name, PointName::E, "{chart:?}");
                continue;
            };
            if point.name == PointName::E {
                continue;
            }
            let size = 1e-15 * (there.k + there.mu);
            assert!((point.k - there.k * (1.0 - chart.omega())).abs() <= size, "{chart:?}");
            assert!((point.mu - there.mu * (1.0 - chart.omega())).abs() <= size, "{chart:?}");
        }
        if (chart.k_prime() / chart.percussion() - 1.0).abs() < 1e-12 {
            continue; // E is at infinity, or as far as rounding has it
        }
        let k_e = chart.k_e();
        assert_eq!(
            k_e.is_finite(),
            chart.k_prime() > chart.percussion() && chart.k_prime() > -1.0,
            "{chart:?}"
        );
        if k_e.is_finite() {
            // There a body without friction rocks, exactly: what friction has to give changes its sign.
            let alpha = chart.rotation(k_e).unwrap();
            assert!((k_e - chart.gamma() * alpha).abs() < 1e-12 * k_e, "{chart:?}");
        }
        let (γ, ω) = (chart.gamma(), chart.omega());
        let inertia = (1.0 + 4.0 * γ * γ) / 3.0;
        let k = chart.k_a() * (1.0 + 1e-7);
        let first = (k * γ * (1.0 + chart.k_prime()).abs() - 1.0 + ω) / (inertia + (1.0 - 2.0 * ω).powi(2));
        assert!((chart.rotation(k).unwrap() / first - 1.0).abs() < 1e-5, "{chart:?}");
    }
    // The limit of μ* at the centre of percussion: 3γ/(2(1+4γ²))/ω... per α; far out, k − γα = R/(γ(1+k'))·… → R/G₁.
    for omega in [0.1, 0.3] {
        let γ = 2.0;
        let chart = CrushChart::new(γ, (1.0 + γ * γ) / (3.0 * γ * γ), omega).unwrap();
        let limit = 3.0 * γ / (2.0 * (1.0 + 4.0 * γ * γ));
        assert!((chart.mu_star(1e9).unwrap() / limit - 1.0).abs() < 1e-6);
    }
}

/// Regions fill the plane without overlap, and each holds its mode.
#[test]
fn every_point_lies_in_the_region_of_its_mode() {
    let mut random = Random(812);
    // A force through the base has no A.
    let through = [0.1, 0.5].map(|omega| CrushChart::new(1.3, -1.0, omega).unwrap());
    for chart in charts().into_iter().chain(through) {
        let map = CrushMap::of(chart);
        let unit = chart.points().iter().fold(1.0 / chart.gamma(), |m, p| m.max(p.k).max(p.mu)).min(1e3);
        for _ in 0..100 {
            let far = random.pick(&[0.3, 1.0, 5.0, 50.0]);
            let (k, mu) = (random.uniform(0.0, far * unit), random.uniform(0.0, far * unit));
            let point = CrushPoint::new(chart.gamma(), chart.k_prime(), k, mu, chart.omega()).unwrap();
            let holders: Modes = map
                .regions()
                .iter()
                .filter(|region| region.contains(k, mu))
                .map(|region| region.mode)
                .collect();
            let mode = point.verdict().mode().unwrap();
            assert_eq!(holders, [mode].into_iter().collect(), "{chart:?} at ({k}, {mu})");
        }
    }
    // On a strong base the rigid map.
    for (gamma, k_prime) in [(1.0, 0.4), (3.0, 0.8), (4.0, -0.55), (1.0, -0.6), (1.0, -2.0)] {
        let modes: Modes =
            CrushMap::new(gamma, k_prime, 1e-12).unwrap().regions().iter().map(|r| r.mode).collect();
        let rigid: Modes = Diagram::new(gamma, k_prime).unwrap().regions().iter().map(|r| r.mode).collect();
        for mode in rigid.iter() {
            assert!(modes.contains(mode), "{gamma} {k_prime}: {modes}, {rigid}");
        }
    }
}

/// Along a path: rest ends where the closed form says, every stage holds its verdict, at its ends the modes change.
#[test]
fn a_path_is_made_of_its_stages() {
    let mut random = Random(813);
    let (mut crossings, mut found) = (0, 0);
    for _ in 0..tries(500).max(40) {
        let (block, permanent) = random_case(&mut random);
        let (_, mut variable) = random_case(&mut random);
        variable.p -= 1.5;
        let strength = random.log(0.5, 1e2);
        let path = stages(&block, &permanent, &variable, strength).unwrap();
        let at = |λ: f64| solve(&block, &(permanent + variable * λ), strength).unwrap();
        assert_eq!((path[0].from, path[path.len() - 1].to), (0.0, f64::INFINITY));
        for pair in path.windows(2) {
            assert_eq!(pair[0].to, pair[1].from);
            crossings += 1;
        }
        for stage in &path {
            let to = if stage.to.is_finite() { stage.to } else { 4.0 * (stage.from + 1.0) };
            let inside = at(stage.from + random.uniform(0.01, 0.99) * (to - stage.from));
            let same = (inside.verdict(), inside.modes) == (stage.verdict, stage.modes);
            assert!(same, "{block:?} {permanent:?} {variable:?} {strength}: {stage:?}, {inside:?}");
            found += 1;
        }
        // Nothing is missed that a fine scan finds.
        let last = path[path.len() - 1].from;
        for i in 0..400 {
            let λ = 1.3 * last * (f64::from(i) + random.uniform(0.0, 1.0)) / 400.0;
            let there = path.iter().find(|stage| stage.from <= λ && λ < stage.to).unwrap();
            let inside = at(λ);
            let edge = (λ - there.from).min(there.to - λ) <= 1e-9 * λ;
            let same = (inside.verdict(), inside.modes) == (there.verdict, there.modes);
            assert!(
                same || edge,
                "{block:?} {permanent:?} {variable:?} {strength} at {λ}: {there:?}, {inside:?}"
            );
        }
        let rests = |λ: f64| at(λ).verdict() == Some(Begins(Mode::Rest));
        match rest_range(&block, &permanent, &variable, strength).unwrap() {
            None => assert!(
                (0..50).all(|i| !rests(f64::from(i) * 0.1 - 2.5)),
                "{block:?} {permanent:?} {variable:?}"
            ),
            Some(range) => {
                let (from, to) = (range.from.max(-1e6), range.to.min(1e6));
                for i in 1..20 {
                    let inside = from + (to - from) * f64::from(i) / 20.0;
                    assert!(
                        rests(inside),
                        "{block:?} {permanent:?} {variable:?} {strength} {range:?} {inside}"
                    );
                }
                let aside = 1e-9 * (1.0 + from.abs().max(to.abs()));
                assert!(range.to == f64::INFINITY || to == 1e6 || !rests(to + aside), "{range:?}");
                assert!(range.from == f64::NEG_INFINITY || from == -1e6 || !rests(from - aside), "{range:?}");
            }
        }
    }
    assert!(crossings > tries(400) && found > crossings);
}

/// `caisson-in-air` of the examples on 3 MPa: its first departure is no longer a slide but a rock, and so is the design force.
#[test]
fn the_caisson_in_air_rocks_on_weak_ground() {
    let weight: f64 = 2100.0 * 15.0 * 12.0 * 9.81;
    let omega = weight / (15.0 * 3e6);
    assert!((omega - 0.0824).abs() < 1e-4);
    let (gamma, k_prime) = (0.8, 5.5 / 6.0);
    let modes = |omega: f64| {
        let at = |force: f64| CrushPoint::new(gamma, k_prime, force / weight, 0.6, omega).unwrap().verdict();
        let first = (0..3000).map(|i| at(f64::from(i) * 1e3)).find(|verdict| *verdict != Begins(Mode::Rest));
        (first.unwrap().symbol(), at(2.7e6).symbol())
    };
    assert_eq!(modes(0.0), ("SL", "SRO-"));
    assert_eq!(modes(omega), ("RO", "RO"));
}

/// A situation in SI units is the problem without units: the caisson in air, a path that slides on the rigid base, motions, mirror, bad
/// input.
#[test]
fn a_situation_is_its_block_in_si_units() {
    let body = Body::new(15.0, 12.0, 378e3).unwrap();
    let push = |force: f64| {
        let action = Action::horizontal(force, 11.5);
        let load = Load::variable(LoadSource::Force, LoadKind::Horizontal, action);
        Situation::new(body, 0.6, 9.81).unwrap().with_weight().with(load)
    };
    let weight = 378e3 * 9.81;
    let CrushOutcome { outcome: found, omega, motion, .. } = outcome(&push(-2.7e6), 3e6).unwrap();
    let point = CrushPoint::new(0.8, 5.5 / 6.0, 2.7e6 / weight, 0.6, weight / (15.0 * 3e6)).unwrap();
    assert!((omega / point.omega() - 1.0).abs() < 1e-14);
    assert_eq!((found.full.verdict, found.full.modes), (Some(point.verdict()), point.enumerate()));
    let (ours, theirs) = (motion.unwrap(), point.motion().unwrap().scaled(9.81, 7.5, weight));
    assert!((ours.motion.theta_ddot / theirs.motion.theta_ddot - 1.0).abs() < 1e-9);
    assert!((ours.neutral.unwrap() / theirs.neutral.unwrap() - 1.0).abs() < 1e-9);
    // Rest ends where kG₁ = 1 − ω.
    let expected = (1.0 - point.omega()) * weight * 7.5 / (2.7e6 * 11.5);
    assert!((found.departure.load_factor() / expected - 1.0).abs() < 1e-12);
    assert_eq!(found.departure.verdict(), Some(Begins(Mode::RockO)));
    assert_eq!(found.full.motion, Some(ours.motion));
    let right = outcome(&push(2.7e6), 3e6).unwrap().outcome;
    assert_eq!(right.full.verdict, found.full.verdict.map(Verdict::mirrored));
    // On 1e15 Pa the rigid answer.
    let (strong, rigid) = (outcome(&push(-2.7e6), 1e15).unwrap().outcome, push(-2.7e6).outcome().unwrap());
    assert_eq!(strong.full.verdict, rigid.full.verdict);
    assert!((strong.departure.load_factor() / rigid.departure.load_factor() - 1.0).abs() < 1e-12);
    assert_eq!(strong.departure.verdict(), rigid.departure.verdict());
    // Too weak for the weight alone; without a load that varies; on a base that cannot be.
    let weak = outcome(&push(-2.7e6), weight / 15.0).unwrap().outcome;
    let at_once = Departure::AtOnce { verdict: Some(BearingFailure), permanent: true };
    assert_eq!((weak.full.verdict, weak.full.motion, weak.departure), (Some(BearingFailure), None, at_once));
    let still = Situation::new(body, 0.6, 9.81).unwrap().with_weight();
    assert_eq!(outcome(&still, 3e6).unwrap().outcome.departure, Departure::Never);
    assert!(outcome(&still, -1.0).is_err() && outcome(&still, f64::INFINITY).is_err());
    let drum = Situation::new(Body::cylinder(2.0, 3.0, 25e3).unwrap(), 0.6, 9.81).unwrap();
    assert!(outcome(&drum, 3e6).is_err());
}

/// The load factor of the base is where a body that friction holds leaves rest: above it never rests, below it does.
#[test]
fn the_base_s_own_load_factor() {
    let mut random = Random(861);
    let mut finite = 0;
    for _ in 0..tries(200).max(50) {
        let (b, γ) = (random.uniform(1.0, 8.0), random.uniform(0.4, 3.0));
        let body = Body::new(2.0 * b, 2.0 * γ * b, 1e5).unwrap();
        let body = body.with_centroid(random.uniform(-0.4, 0.4) * b, γ * b).unwrap();
        let push = Action::horizontal(-random.uniform(-1e6, 1e6), random.uniform(0.0, 2.0) * γ * b);
        let up = Action::vertical(&body, random.uniform(-5e5, 5e5), random.uniform(0.5, 1.5) * b);
        let situation = Situation::new(body, 1e6, 10.0)
            .unwrap()
            .with_weight()
            .with(Load::variable(LoadSource::Force, LoadKind::Horizontal, push))
            .with(Load::variable(LoadSource::Uplift, LoadKind::Uplift, up));
        let strength = random.uniform(0.9, 20.0) * 1e6 / (2.0 * b);
        let found = outcome(&situation, strength).unwrap();
        // With that friction the path leaves rest where the base does not bear it.
        let departure = found.outcome.departure.load_factor();
        let [one, two] = [found.load_factor, departure];
        assert!(one == two || (one / two - 1.0).abs() < 1e-9, "{one} {two}: {found:?}");
        finite += usize::from(one.is_finite() && one > 0.0);
    }
    assert!(finite > 20, "{finite}");
}

/// The steps are those of the decision, each inequality holds as its numbers say where they differ, and the changes of mode are where
/// the decision changes.
#[test]
fn an_explanation_is_the_decision() {
    let mut random = Random(807);
    for _ in 0..tries(4_000) {
        let [γ, h] = [random.uniform(0.3, 5.0), random.uniform(-1.8, 1.5)];
        let [k, mu] = [random.uniform(0.0, 4.0), random.uniform(0.0, 3.0)];
        let ω = if random.coin() { random.uniform(0.0, 0.99) } else { random.log(1e-12, 1.0) };
        let point = CrushPoint::new(γ, h, k, mu, ω).unwrap();
        let Some(trace) = point.explain() else {
            assert_eq!(point.verdict(), BearingFailure);
            continue;
        };
        let (last, tried) = trace.steps.split_last().unwrap();
        assert_eq!(Verdict::Begins(last.mode), point.verdict(), "{point:?}");
        assert!(last.holds && tried.iter().all(|step| !step.holds));
        for step in &trace.steps {
            let all = step.relations.iter().all(|relation| relation.holds);
            assert_eq!(all, step.holds, "{point:?}: {step:?}");
            for relation in &step.relations {
                let clear = (relation.left - relation.right).abs()
                    > 1e-9 * (relation.left.abs() + relation.right.abs());
                assert!(!clear || relation.holds == (relation.margin() > 0.0), "{point:?}: {relation}");
            }
        }
        let mode = |k: f64, mu: f64| CrushPoint::new(γ, h, k, mu, ω).unwrap().verdict().mode();
        let margins = point.margins();
        for crossing in &margins.along_k {
            let [before, after] = [1.0 - 1e-9, 1.0 + 1e-9].map(|by| mode(crossing.at * by, mu));
            assert_eq!((before, after), (Some(crossing.from), Some(crossing.to)), "{point:?}: {crossing:?}");
        }
        for crossing in &margins.along_mu {
            let [before, after] = [1.0 - 1e-9, 1.0 + 1e-9].map(|by| mode(k, crossing.at * by));
            assert_eq!((before, after), (Some(crossing.from), Some(crossing.to)), "{point:?}: {crossing:?}");
        }
        // Nothing changes in between.
        for (along, at) in [(&margins.along_k, true), (&margins.along_mu, false)] {
            let value = random.uniform(0.0, 3.0);
            let mut found = along.first().map_or(point.verdict().mode(), |first| Some(first.from));
            found = along
                .iter()
                .take_while(|crossing| crossing.at < value)
                .last()
                .map_or(found, |last| Some(last.to));
            assert_eq!(
                if at { mode(value, mu) } else { mode(k, value) },
                found,
                "{point:?}: {value} {along:?}"
            );
        }
    }
}

/// Columns of mixed ω give what points give one by one, motion and mirror included; a wrong ω is told with its place.
#[test]
fn columns_are_points() {
    let mut random = Random(808);
    let count = 10_000;
    let mut columns: [Vec<f64>; 5] = Default::default();
    for _ in 0..count {
        let [gamma, k_prime, k, mu] = random.point();
        // A third rigid, some that fail.
        let omega = match random.bits() % 6 {
            0 | 1 => 0.0,
            2 => random.uniform(0.9, 1.2),
            _ => random_omega(&mut random),
        };
        for (column, value) in columns.iter_mut().zip([gamma, k_prime, k, mu, omega]) {
            column.push(value);
        }
    }
    let [gamma, k_prime, k, mu, omega] = &columns;
    let given = Columns { gamma, k_prime, k, mu };
    let mut codes = vec![0; count];
    classify_on_base(given, omega, &mut codes).unwrap();
    for mirrored in [false, true] {
        let (mut modes, mut unique, mut others) = (vec![0; count], vec![false; count], vec![0; count]);
        let mut numbers: [Vec<f64>; 9] = std::array::from_fn(|_| vec![0.0; count]);
        let out = OnsetColumns {
            mode: Some(&mut modes),
            unique: Some(&mut unique),
            others: Some(&mut others),
            motion: numbers.each_mut().map(|column| Some(&mut column[..])),
            mirrored,
        };
        onset_on_base(given, omega, out).unwrap();
        let mut failed = 0;
        for i in 0..count {
            let point = CrushPoint::new(gamma[i], k_prime[i], k[i], mu[i], omega[i]).unwrap();
            let verdict = point.verdict();
            assert_eq!(codes[i], verdict.code());
            assert_eq!(modes[i], if mirrored { verdict.mirrored() } else { verdict }.code());
            assert_eq!(unique[i], point.is_unique());
            let beside = if mirrored { point.others().mirrored() } else { point.others() };
            assert_eq!(others[i], beside.bits());
            let motion = point.motion().map(|begun| begun.motion);
            match if mirrored { motion.map(|motion| motion.mirrored()) } else { motion } {
                Some(motion) => {
                    assert_eq!([numbers[0][i], numbers[5][i]], [motion.x_ddot, motion.xi], "{point:?}");
                    assert_eq!([numbers[2][i], numbers[8][i]], [motion.theta_ddot, motion.lift_o_prime]);
                }
                None => {
                    assert!(numbers.iter().all(|column| column[i].is_nan()) && verdict == BearingFailure);
                    failed += 1;
                }
            }
        }
        assert!(failed > 500);
    }
    let mut wrong = omega.clone();
    wrong[7_000] = -0.1;
    let error = classify_on_base(given, &wrong, &mut codes).unwrap_err();
    assert_eq!(
        error.to_string(),
        "point 7000: share ω of the base is -0.1; expected a number from 0 to 1e50"
    );
    let error = classify_on_base(given, &wrong[1..], &mut codes).unwrap_err();
    assert_eq!(error.to_string(), "column omega has 9999 values; expected 10000, as many as the output");
}
