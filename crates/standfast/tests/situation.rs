//! Loads in SI units, their reduction to the report's plane, and the way to the full load: the special cases that have
//! to come out of the one general problem.

mod common;

use common::{Random, tries};
use standfast::Verdict::Begins;
use standfast::contact::path::stages;
use standfast::contact::plane::regions;
use standfast::contact::{Block, solve};
use standfast::initiation::Chart;
use standfast::loads::LoadKind::{Horizontal, Uplift, Weight};
use standfast::loads::{
    Action, AddedMass, BodyPoint, Earthquake, HorizontalForce, Load, LoadKind, LoadSource, Pose, StillWater,
};
use standfast::{Body, ClassicalActions, Corner, Departure, Mode, Modes, Point, Situation, Slip, Wrench};

const G: f64 = 9.81;

fn permanent(kind: LoadKind, action: impl Into<Action>) -> Load {
    Load::permanent(LoadSource::Other, kind, action)
}

fn variable(kind: LoadKind, action: impl Into<Action>) -> Load {
    Load::variable(LoadSource::Other, kind, action)
}

/// A body under its weight.
fn standing(body: Body, friction: f64, gravity: f64) -> Situation {
    Situation::new(body, friction, gravity).unwrap().with_weight()
}

/// True if a point lies within rounding of a change of mode, where two ways to compute it may differ.
fn near_boundary(point: &Point) -> bool {
    let near = |at: f64, value: f64| (at - value).abs() <= 1e-9 * (at.abs() + value.abs());
    let (margins, chart) = (point.margins(), point.chart());
    // N begins where no mode changes.
    let curves = [chart.upper_line(), chart.lower_line(), chart.mu_star()];
    curves.iter().any(|curve| near(curve.at(point.k()), point.mu()))
        || near(chart.k_a(), point.k())
        || margins.along_k.iter().any(|crossing| near(crossing.at, point.k()))
        || margins.along_mu.iter().any(|crossing| near(crossing.at, point.mu()))
}

fn all_modes(point: &Point) -> Modes {
    let mut modes = point.others();
    modes.insert(point.mode());
    modes
}

/// Force in air: X = −k, P = 1, M = k k'γ.
#[test]
fn a_force_in_air_is_the_report_s_problem() {
    let mut random = Random(41);
    let mut compared = 0;
    while compared < tries(100_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        if near_boundary(&point) {
            continue;
        }
        let wrench = Wrench { x: -k, p: 1.0, m: k * k_prime * gamma };
        let answer = solve(&Block::uniform(gamma, mu), &wrench).unwrap();
        assert_eq!(answer.modes, all_modes(&point), "{point:?}");
        assert_eq!(answer.mode(), Some(point.mode()), "{point:?}");
        compared += 1;
    }
}

/// Any wrench on a uniform block with P > 0 is a point (k_eff, k'_eff), mirrored if X points right, with the motion
/// times P.
#[test]
fn any_wrench_on_a_uniform_block_is_a_point_of_the_report_s_plane() {
    let mut random = Random(42);
    let mut compared = 0;
    while compared < tries(100_000) {
        let (width, height) = (random.uniform(1.0, 20.0), random.uniform(1.0, 20.0));
        let body = Body::new(width, height, random.log(1e2, 1e6)).unwrap();
        let weight = body.mass() * G;
        let wrench = Wrench {
            x: random.uniform(-3.0, 3.0) * weight,
            p: random.uniform(0.01, 3.0) * weight,
            m: random.uniform(-3.0, 3.0) * weight * width,
        };
        let situation =
            Situation::new(body, random.log(0.05, 5.0), G).unwrap().with(permanent(Weight, wrench));
        let state = situation.at(0.0).unwrap();
        let reduced = state.effective.unwrap();
        if near_boundary(&reduced.point) {
            continue;
        }
        let wrench = situation.reduced_wrench(&wrench);
        let general = solve(&situation.reduced_block().0, &wrench).unwrap();
        assert_eq!(general.modes, state.modes, "{situation:?}");
        assert_eq!(general.mode(), state.mode(), "{situation:?}");
        let ours = state.motion.unwrap();
        let theirs = general.motion(state.mode().unwrap()).unwrap().scaled(G, width / 2.0, weight);
        let size = 1.0
            + theirs.theta_ddot.abs() * (width + height)
            + theirs.x_ddot.abs()
            + state.wrench.p / body.mass();
        if size < 1e4 {
            for (ours, theirs) in [
                (ours.x_ddot, theirs.x_ddot),
                (ours.y_ddot, theirs.y_ddot),
                (ours.theta_ddot * width, theirs.theta_ddot * width),
                (ours.f_x / body.mass(), theirs.f_x / body.mass()),
                (ours.f_y / body.mass(), theirs.f_y / body.mass()),
                (ours.slip, theirs.slip),
            ] {
                assert!((ours - theirs).abs() <= 1e-8 * size, "{situation:?}: {ours} {theirs}");
            }
        }
        compared += 1;
    }
}

/// Base pressures p₁ at O and p₂ at O': P = 1 − (p₁+p₂)B/(mg), M = (p₂−p₁)B/(3mg), lengths in B.
#[test]
fn buoyancy_and_uplift_lower_p_and_turn() {
    let mut random = Random(43);
    for _ in 0..tries(100_000) {
        let body =
            Body::new(random.uniform(1.0, 20.0), random.uniform(1.0, 20.0), random.log(1e3, 1e6)).unwrap();
        let (half_width, weight) = (body.width() / 2.0, body.mass() * G);
        let [p1, p2] = [0, 1].map(|_| random.uniform(0.0, 1.0) * weight / half_width);
        let pressed = permanent(Uplift, Action::base_pressure(&body, p1, p2));
        let situation = standing(body, 0.6, G).with(pressed);
        let reduced = situation.reduced_wrench(&situation.wrench_at(1.0, Pose::UPRIGHT));
        let close = |one: f64, two: f64| (one - two).abs() <= 1e-12 * (1.0 + two.abs());
        assert!(close(reduced.p, 1.0 - (p1 + p2) * half_width / weight));
        assert!(close(reduced.m, (p2 - p1) * half_width / (3.0 * weight)));
        assert_eq!(reduced.x, 0.0);
    }
}

/// Base excitation, Shenton's problem: k' = 0, k = a_h/(1 + a_v), with the regions in closed form.
#[test]
fn base_excitation_has_its_regions() {
    let mut random = Random(44);
    let mut compared = 0;
    while compared < tries(100_000) {
        let body = Body::new(2.0, 2.0 * random.uniform(0.2, 6.0), random.log(1e2, 1e5)).unwrap();
        let γ = body.slenderness();
        let (a_h, a_v, μ) = (random.uniform(0.01, 3.0), random.uniform(-0.9, 1.0), random.uniform(0.0, 3.0));
        let shaken = variable(Horizontal, Action::Inertia { right: a_h * G, up: a_v * G });
        let situation = standing(body, μ, G).with(shaken);
        let state = situation.at(1.0).unwrap();
        let k = a_h / (1.0 + a_v);
        let μ_rock = ((4.0 + γ * γ) * k + 3.0 * γ) / (1.0 + 4.0 * γ * γ + 3.0 * γ * k);
        let gaps = [μ - k, γ * k - 1.0, γ * μ - 1.0, μ - μ_rock];
        if gaps.iter().any(|gap| gap.abs() < 1e-9) {
            continue;
        }
        let expected = if μ > k && k * γ < 1.0 {
            Mode::Rest
        } else if μ < k && μ * γ < 1.0 {
            Mode::SlideLeft
        } else if μ > μ_rock {
            Mode::RockO
        } else {
            Mode::SlideRockOLeft
        };
        assert_eq!(state.mode(), Some(expected), "γ {γ}, a_h {a_h}, a_v {a_v}, μ {μ}");
        let general = solve(&situation.reduced_block().0, &situation.reduced_wrench(&state.wrench)).unwrap();
        assert_eq!(general.mode(), Some(expected));
        assert!(state.is_unique());
        compared += 1;
    }
}

/// Added mass slows the slide, and rocking by its moment; it turns the same wrench into other modes.
#[test]
fn added_mass_enters_the_inertia() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let with = |friction, force| {
        let body_in_water = standing(body, friction, 10.0).with_added_mass(AddedMass::of(500.0).unwrap());
        body_in_water.with(variable(Horizontal, force))
    };
    let slide = with(0.2, Action::horizontal(-5000.0, 1.0)).at(1.0).unwrap();
    assert_eq!(slide.mode(), Some(Mode::SlideLeft));
    assert!(slide.effective.is_none());
    // (μ m g − F)/(m + M_a)
    assert!((slide.motion.unwrap().x_ddot - (2000.0 - 5000.0) / 1500.0).abs() < 1e-12);
    let rock = with(9.0, Action::horizontal(-15000.0, 2.0)).at(1.0).unwrap();
    assert_eq!(rock.mode(), Some(Mode::RockO));
    // (F·2H − m g B)/(I + (m + M_a)H² + m B²)
    let expected = (15000.0 * 2.0 - 10_000.0) / (1000.0 * 2.0 / 3.0 + 1500.0 + 1000.0);
    assert!((rock.motion.unwrap().theta_ddot - expected).abs() < 1e-12 * expected);
}

/// Random bodies with added mass: a body that slides or rocks obeys the equations of motion with m + M_a against ẍ.
#[test]
fn added_mass_obeys_the_equations_of_motion() {
    let mut random = Random(48);
    let mut seen = Modes::NONE;
    for _ in 0..tries(100_000) {
        let (width, height) = (random.uniform(1.0, 20.0), random.uniform(1.0, 20.0));
        let body = Body::new(width, height, random.log(1e3, 1e6)).unwrap();
        let (mass, weight) = (body.mass(), body.mass() * G);
        let added = mass * random.uniform(0.0, 2.0);
        let force = Action::horizontal(-random.uniform(0.0, 2.0) * weight, random.uniform(0.0, height));
        let situation = standing(body, random.log(0.05, 2.0), G)
            .with_added_mass(AddedMass::of(added).unwrap())
            .with(variable(Horizontal, force.clone()));
        let force = force.wrench(&body, G, Pose::UPRIGHT);
        let state = situation.at(1.0).unwrap();
        let motion = state.motion.unwrap();
        seen.insert(state.mode().unwrap());
        let size = weight * (1.0 + motion.theta_ddot.abs() * (width + height) / G);
        let balance = (mass + added) * motion.x_ddot - motion.f_x - force.x;
        assert!(balance.abs() <= 1e-9 * size, "{situation:?}");
        assert!((mass * motion.y_ddot - motion.f_y + weight).abs() <= 1e-9 * size, "{situation:?}");
        let moment = body.moment_of_inertia() * motion.theta_ddot
            - motion.f_x * body.centroid_height()
            - motion.f_y * motion.xi
            - force.m;
        assert!(moment.abs() <= 1e-9 * size * (width + height), "{situation:?}");
    }
    assert!(seen.len() >= 4, "{seen}");
}

/// Forces and pressures by their moments about O, for a body with an eccentric centre of mass and an unequal base.
#[test]
fn loads_have_their_moments() {
    let body =
        Body::new(10.0, 8.0, 1e5).unwrap().with_centroid(0.5, 3.0).unwrap().with_base(4.0, 5.0).unwrap();
    assert_eq!((body.heel_distance(), body.toe_distance(), body.base_width()), (4.5, 4.5, 9.0));
    assert!(!body.is_uniform());
    // Moments about O, counter-clockwise: M − P·(−b₁)… = M + X d·(−1)… from the wrench at C.
    let about_o =
        |wrench: Wrench| wrench.m - wrench.p * body.heel_distance() - wrench.x * body.centroid_height();
    let at_c = |action: Action| action.wrench(&body, 10.0, Pose::UPRIGHT);
    assert_eq!(about_o(at_c(Action::Weight)), -1e6 * 4.5);
    assert_eq!(about_o(at_c(Action::horizontal(-100.0, 6.0))), 600.0);
    assert_eq!(about_o(at_c(Action::vertical(&body, 100.0, 2.0))), -200.0);
    let pressure = at_c(Action::base_pressure(&body, 6.0, 12.0)); // 81 N/m at 5 m from O
    assert_eq!(pressure.p, -81.0);
    assert!((about_o(pressure) - 81.0 * 5.0).abs() < 1e-9);
    // 1000·10·(5² − 2²)/2 to the left; moments of both triangles, and of the base.
    let water = StillWater::new(&body, 2.0, 5.0, 1000.0).unwrap().loads(&body, 10.0);
    let sum = |source| {
        let loads = water.iter().filter(|load| load.source == source);
        loads.map(|load| load.action.wrench(&body, 10.0, Pose::UPRIGHT)).sum::<Wrench>()
    };
    let (sides, base) = (sum(LoadSource::StillWater), sum(LoadSource::Buoyancy));
    assert_eq!((sides.x, sides.p), (-105_000.0, 0.0));
    assert_eq!((base.x, base.p), (0.0, -(20_000.0 + 50_000.0) / 2.0 * 9.0));
    assert!((about_o(sides) - (125_000.0 * 5.0 / 3.0 - 20_000.0 * 2.0 / 3.0)).abs() < 1e-6);
    assert!((about_o(base) - (20_000.0 + 2.0 * 50_000.0) / 6.0 * 81.0).abs() < 1e-6);
}

#[test]
fn impossible_bodies_and_water_are_refused() {
    let body = Body::new(10.0, 8.0, 1e5).unwrap();
    assert_eq!(
        body.with_centroid(5.5, 4.0).unwrap_err().to_string(),
        "offset of the centre of mass is 5.5; expected one that lies between O and O'"
    );
    assert_eq!(
        body.with_base(-1.0, 0.5).unwrap_err().to_string(),
        "left half of the base is -1; expected a number above zero, from 1e-50 to 1e50"
    );
    assert!(body.with_moment_of_inertia(0.0).is_err());
    assert_eq!(
        StillWater::new(&body, 3.0, 8.5, 1e3).unwrap_err().to_string(),
        "water level is 8.5; expected no more than the height of the body: its crest has to stand above still water"
    );
}

/// P ≤ 0 is an answer: the body is lifted, and flies or is carried off.
#[test]
fn a_floating_body_is_an_answer() {
    let body = Body::new(10.0, 8.0, 5e4).unwrap();
    let water = StillWater::new(&body, 7.0, 7.0, 1025.0).unwrap();
    let situation = standing(body, 0.6, G).with_all(water.loads(&body, G));
    let state = situation.at(0.0).unwrap();
    assert!(state.is_lifted());
    assert_eq!(state.mode(), Some(Mode::Flight));
    assert!(state.effective.is_none());
}

/// One motion is not counted twice if nothing presses the body on its base: on a lattice full of coincidences, modes that are consistent
/// together are different motions, and one is always consistent.
#[test]
fn consistent_modes_are_different_motions() {
    let mut unpressed = 0;
    for i in 0..4_u32.pow(6) {
        let digit = |place: u32| f64::from(i / 4_u32.pow(place) % 4);
        let mu = digit(0) / 2.0;
        let block =
            Block { mu_s: mu, mu_k: mu, b2: 1.0 + digit(5) / 2.0, ..Block::uniform(1.0 + digit(1), mu) };
        let wrench = Wrench { x: digit(2) - 1.0, p: digit(3) - 2.0, m: digit(4) - 1.0 };
        let answer = solve(&block, &wrench).unwrap();
        assert!(answer.mode().is_some(), "{block:?} {wrench:?}");
        let motions: Vec<_> = answer.modes.iter().map(|mode| answer.motion(mode).unwrap()).collect();
        unpressed += u32::from(motions.iter().any(|motion| motion.f_y == 0.0 && wrench.p >= 0.0));
        for (i, one) in motions.iter().enumerate() {
            for two in &motions[..i] {
                let far = |a: f64, b: f64| (a - b).abs() > 1e-9;
                assert!(
                    far(one.x_ddot, two.x_ddot)
                        || far(one.y_ddot, two.y_ddot)
                        || far(one.theta_ddot, two.theta_ddot),
                    "{block:?} {wrench:?} {}",
                    answer.modes
                );
            }
        }
    }
    assert!(unpressed > 100);
}

/// About the toe by hand: a force far below turns the body over the other corner; uplift alone may turn it as well.
#[test]
fn overturning_has_a_factor_about_each_corner() {
    let body = Body::new(4.0, 2.0, 1e4).unwrap();
    let weight = body.mass() * G;
    let at = |situation: &Situation| situation.outcome().unwrap().stability;
    // A force to the left and a moment to the right about the base, 0.75 of what the weight resists.
    let twist = Wrench { x: -1e3, p: 0.0, m: -1e3 - 1.5 * weight };
    let twisted = at(&standing(body, 0.6, G).with(variable(Horizontal, twist)));
    assert_eq!(twisted.overturning_about_heel, f64::INFINITY);
    assert!((twisted.overturning_about_toe - 2.0 / 1.5).abs() < 1e-12);
    assert_eq!(twisted.overturning(), twisted.overturning_about_toe);
    // 0 to 40 kPa from O to O' turns it about O with 40e3·4/2·(8/3) N·m against 2 m g, and does not lift it.
    let uplifted = standing(body, 0.6, G).with(variable(Uplift, Action::base_pressure(&body, 0.0, 40e3)));
    assert!(40e3 * 2.0 * 8.0 / 3.0 > 2.0 * weight && 40e3 * 2.0 < weight);
    assert_eq!(at(&uplifted).overturning_about_heel, 0.0);
    assert!(uplifted.at(1.0).unwrap().mode() != Some(Mode::Rest));
    assert_eq!(at(&uplifted).overturning_about_toe, f64::INFINITY);
}

/// A random body, friction and pair of wrenches.
fn random_path(random: &mut Random) -> (Block, Wrench, Wrench) {
    let mut block = Block::uniform(random.uniform(0.3, 4.0), random.log(0.1, 4.0));
    if random.coin() {
        block.b1 *= random.uniform(0.5, 1.5);
        block.m_x += random.uniform(0.0, 1.0);
        block.rho2 *= random.uniform(0.7, 1.4);
    }
    let mut wrench = |p: f64| Wrench { x: random.uniform(-1.0, 1.0), p, m: random.uniform(-1.0, 1.0) };
    (block, wrench(1.0), wrench(-0.3))
}

/// The stages of a rising load: constant between their ends, different across them.
#[test]
fn a_path_has_every_crossing() {
    let mut random = Random(45);
    for _ in 0..tries(5_000) {
        let (block, permanent, variable) = random_path(&mut random);
        let stages = stages(&block, &permanent, &variable).unwrap();
        assert_eq!((stages[0].from, stages.last().unwrap().to), (0.0, f64::INFINITY));
        for pair in stages.windows(2) {
            assert_eq!(pair[0].to, pair[1].from);
            assert_ne!((pair[0].mode(), pair[0].modes), (pair[1].mode(), pair[1].modes));
            // The boundary is there, to round-off.
            let at = |λ: f64| solve(&block, &(permanent + variable * λ)).unwrap().modes;
            let λ = pair[0].to;
            assert_eq!(at(λ - 1e-9 * λ.max(1e-3)), pair[0].modes, "{block:?} {permanent:?} {variable:?} {λ}");
            assert_eq!(at(λ + 1e-9 * λ.max(1e-3)), pair[1].modes, "{block:?} {permanent:?} {variable:?} {λ}");
        }
        for _ in 0..20 {
            let λ = random.uniform(0.0, 5.0);
            let stage = stages.iter().find(|stage| λ <= stage.to).unwrap();
            if (λ - stage.from).min(stage.to - λ) > 1e-9 {
                assert_eq!(solve(&block, &(permanent + variable * λ)).unwrap().modes, stage.modes);
            }
        }
    }
}

/// In air the path of a force through the report's plane has the report's crossings, in k.
#[test]
fn a_path_in_air_crosses_where_the_margins_say() {
    let mut random = Random(46);
    for _ in 0..tries(5_000) {
        let (gamma, k_prime, mu) =
            (random.uniform(0.3, 4.0), random.uniform(-1.5, 1.5), random.uniform(0.05, 2.0));
        let margins = Point::new(gamma, k_prime, 1.0, mu).unwrap().margins();
        let unit = Wrench { x: -1.0, p: 0.0, m: k_prime * gamma };
        let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let stages = stages(&Block::uniform(gamma, mu), &weight, &unit).unwrap();
        let changes: Vec<_> = stages.windows(2).filter(|pair| pair[0].mode() != pair[1].mode()).collect();
        let expected: Vec<_> = margins.along_k.iter().collect();
        assert_eq!(changes.len(), expected.len(), "{gamma} {k_prime} {mu}");
        for (pair, crossing) in changes.iter().zip(expected) {
            assert!((pair[0].to - crossing.at).abs() <= 1e-9 * crossing.at);
            assert_eq!((pair[0].mode(), pair[1].mode()), (Some(crossing.from), Some(crossing.to)));
        }
    }
}

/// Inside N a suddenly applied load and a rising one end in different modes: the body has begun to rock before.
#[test]
fn a_rising_load_enters_n_from_rocking() {
    // γ = 1, k' = −1/2, μ = 3: rest to k_A = 2, then RO up to AB (μ = 1 + k/2 at k = 4), where SL takes over.
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let situation = standing(body, 3.0, 10.0).with(variable(Horizontal, Action::horizontal(-10_000.0, 0.5)));
    let departure = situation.outcome().unwrap().departure;
    assert_eq!(departure, Departure::At { factor: 2.0, verdict: Some(Begins(Mode::RockO)) });
    let full = situation.at(5.0).unwrap();
    assert_eq!(full.mode(), Some(Mode::SlideLeft));
    assert_eq!(full.others().to_string(), "RO SRO-");
}

/// The plane of load factor and friction: regions fill it, do not overlap, and hold their mode; for a force in air it is
/// the report's.
#[test]
fn the_plane_of_any_block_has_its_regions() {
    let mut random = Random(47);
    for case in 0..tries(60).max(6) {
        let (mut block, permanent, variable) = if case % 3 == 0 {
            let (gamma, k_prime) = (random.uniform(0.3, 4.0), random.uniform(-1.0, 1.0));
            let unit = Wrench { x: -1.0, p: 0.0, m: k_prime * gamma };
            (Block::uniform(gamma, 1.0), Wrench { x: 0.0, p: 1.0, m: 0.0 }, unit)
        } else {
            random_path(&mut random)
        };
        if random.coin() {
            block.mu_k *= random.uniform(0.3, 1.0);
        }
        let regions = regions(&block, &permanent, &variable, 4.0).unwrap();
        let mut missed = 0;
        for _ in 0..500 {
            let (λ, μ) = (random.uniform(0.0, 4.0), random.uniform(0.0, 4.0));
            let at = Block { mu_s: μ, mu_k: μ * (block.mu_k / block.mu_s), ..block };
            let mode = solve(&at, &(permanent + variable * λ)).unwrap().mode().unwrap();
            let holders: Vec<Mode> =
                regions.iter().filter(|region| region.contains(λ, μ)).map(|region| region.mode).collect();
            missed += usize::from(holders != [mode]);
        }
        assert!(missed == 0, "{missed} of 500: {block:?} {permanent:?} {variable:?}");
    }
}

/// In air, the plane's regions end where the report's do.
#[test]
fn in_air_the_plane_is_the_report_s_diagram() {
    let (gamma, k_prime) = (3.0, 0.8);
    let chart = Chart::new(gamma, k_prime).unwrap();
    let unit = Wrench { x: -1.0, p: 0.0, m: k_prime * gamma };
    let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    let regions = regions(&Block::uniform(gamma, 1.0), &weight, &unit, 4.0).unwrap();
    let rocks = regions.iter().find(|region| region.mode == Mode::RockO).unwrap();
    assert!((rocks.strips[0].from - chart.k_a()).abs() < 1e-12);
    for strip in &rocks.strips {
        let k = (strip.from + strip.to) / 2.0;
        assert!((strip.lower.at(k) - chart.mu_star().at(k).abs()).abs() < 1e-12);
        assert!(strip.upper.is_none());
    }
    let symbols: Modes = regions.iter().map(|region| region.mode).collect();
    assert_eq!(symbols.to_string(), "RE SL RO SRO- SRO+");
    assert_eq!(regions.len(), 5);
}

/// The classical actions, by hand, for loads towards either side; in air they give μ/k and 1/(kγ(1+k')).
#[test]
fn classical_actions_are_taken_about_the_heel() {
    let body = Body::new(4.0, 6.0, 1000.0).unwrap();
    for side in [-1.0, 1.0] {
        let (left, right) = if side < 0.0 { (0.0, 500.0) } else { (500.0, 0.0) };
        let push = variable(Horizontal, Action::horizontal(side * 2000.0, 4.0));
        let situation = standing(body, 0.5, 10.0)
            .with(variable(Uplift, Action::base_pressure(&body, left, right)))
            .with(push.clone());
        let outcome = situation.outcome().unwrap();
        let actions = outcome.actions;
        let expected = ClassicalActions {
            heel: if side < 0.0 { Corner::O } else { Corner::OPrime },
            buoyant_weight: 10_000.0,
            weight_arm: 2.0,
            uplift: 1000.0,
            uplift_moment: 1000.0 * 8.0 / 3.0,
            force: 2000.0,
            force_moment: 8000.0,
        };
        assert!((actions.uplift_moment - expected.uplift_moment).abs() < 1e-9);
        assert_eq!(ClassicalActions { uplift_moment: expected.uplift_moment, ..actions }, expected);
        let stability = outcome.stability;
        assert_eq!(stability.sliding, 0.5 * 9000.0 / 2000.0);
        assert!((stability.overturning() - (20_000.0 - expected.uplift_moment) / 8000.0).abs() < 1e-12);

        let in_air = standing(body, 0.5, 10.0).with(push);
        let point = in_air.at(1.0).unwrap().effective.unwrap().point;
        let stability = in_air.outcome().unwrap().stability;
        assert!((stability.sliding - point.safety_against_sliding()).abs() < 1e-12);
        assert!((stability.overturning() - point.safety_against_overturning()).abs() < 1e-12);
    }
}

/// The plane does not depend on what the load is measured in, and reaches the end of its range.
#[test]
fn the_plane_is_free_of_scale() {
    let block = Block::uniform(1.5, 1.0);
    let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    for size in [1e-7, 1.0, 1e6] {
        let variable = Wrench { x: size, p: 0.0, m: -0.3 * size };
        let up_to = 4.0 / size;
        let regions = regions(&block, &weight, &variable, up_to).unwrap();
        let symbols: Modes = regions.iter().map(|region| region.mode).collect();
        assert_eq!(symbols.to_string(), "RE RO' SL+ SRO'+", "{size}");
        assert!(regions.iter().any(|region| region.contains(up_to, 0.1)));
    }
}

/// Both parts of a load count, its own kind's and the other's: an earthquake that lifts while it pushes.
#[test]
fn both_parts_of_an_earthquake_count() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let shaken = variable(Horizontal, Action::Inertia { right: 4.0, up: -5.0 });
    let situation = standing(body, 0.6, 10.0).with(shaken);
    let outcome = situation.outcome().unwrap();
    assert_eq!((outcome.actions.buoyant_weight, outcome.actions.force), (5000.0, 4000.0));
    assert_eq!(outcome.stability.sliding, 0.75);
    assert_eq!(situation.at(1.0).unwrap().mode(), Some(Mode::SlideLeft));
}

#[test]
fn numbers_that_no_situation_has_are_refused() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    for gravity in [0.0, -9.81, f64::NAN] {
        assert!(Situation::new(body, 0.6, gravity).is_err());
    }
    assert!(Situation::new(body, -0.1, G).is_err());
    // −0 is 0, and stays so in what comes of it.
    let point = Point::new(1.0, -0.0, -0.0, -0.0).unwrap();
    assert!([point.k_prime(), point.k(), point.mu()].iter().all(|zero| zero.is_sign_positive()));
    let standing = standing(body, 0.6, G);
    assert_eq!(
        standing.clone().with_kinetic_friction(0.7).unwrap_err().to_string(),
        "kinetic friction is 0.7; expected no more than the friction to stick"
    );
    assert!(!standing.clone().with_kinetic_friction(0.7).unwrap_err().is_about_size());
    assert!(standing.clone().with_kinetic_friction(-0.1).unwrap_err().is_about_size());
    assert!(AddedMass::of(-1.0).unwrap_err().is_about_size());
    assert!(standing.at(f64::NAN).is_err() && standing.plane(0.0).is_err());
}

/// Never, at once by the permanent loads, at once by any share of the variable ones, at a load factor: by hand.
#[test]
fn a_departure_is_one_of_four() {
    let body = Body::new(2.0, 2.0, 1000.0).unwrap();
    let push = |force, elevation| Action::horizontal(force, elevation);
    let of = |situation: Situation| situation.outcome().unwrap().departure;
    // Sliding at μ m g = 6 kN.
    assert_eq!(
        of(standing(body, 0.6, 10.0).with(variable(Horizontal, push(-5000.0, 1.0)))),
        Departure::At { factor: 1.2, verdict: Some(Begins(Mode::SlideLeft)) }
    );
    // Far beyond any window.
    let Departure::At { factor, .. } =
        of(standing(body, 0.6, 10.0).with(variable(Horizontal, push(-1e-9, 1.0))))
    else {
        panic!()
    };
    assert!((factor / 6e12 - 1.0).abs() < 1e-12);
    // Pressed onto its base without end; no load; a force through the base against as much friction has k' = −1, and slides.
    assert_eq!(
        of(standing(body, 0.6, 10.0).with(variable(Weight, Action::vertical(&body, 1e4, 1.0)))),
        Departure::Never
    );
    assert_eq!(of(standing(body, 0.0, 10.0).with(variable(Horizontal, push(0.0, 1.0)))), Departure::Never);
    assert_eq!(of(standing(body, 0.6, 10.0)), Departure::Never);
    // Without friction.
    assert_eq!(
        of(standing(body, 0.0, 10.0).with(variable(Horizontal, push(-1.0, 1.0)))),
        Departure::AtOnce { verdict: Some(Begins(Mode::SlideLeft)), permanent: false }
    );
    // 7 kN are there all the time.
    let pushed = standing(body, 0.6, 10.0).with(permanent(Horizontal, push(-7000.0, 1.0)));
    let at_once = Departure::AtOnce { verdict: Some(Begins(Mode::SlideLeft)), permanent: true };
    assert_eq!(of(pushed.clone()), at_once);
    assert_eq!(of(pushed.clone().with(variable(Horizontal, push(7000.0, 1.0)))), at_once);
    assert_eq!((at_once.load_factor(), Departure::Never.load_factor()), (0.0, f64::INFINITY));
    // At rest at μ m g exactly, and beyond with any more.
    let poised = standing(body, 0.6, 10.0).with(permanent(Horizontal, push(-6000.0, 1.0)));
    assert_eq!(of(poised.clone()), Departure::Never);
    assert_eq!(
        of(poised.with(variable(Horizontal, push(-1.0, 1.0)))),
        Departure::AtOnce { verdict: Some(Begins(Mode::SlideLeft)), permanent: false }
    );
}

/// One horizontal force beside the weight has the report's numbers to the last bit, with either sign; anything else its
/// effective ones, which agree to rounding.
#[test]
fn a_force_in_air_keeps_its_numbers() {
    let mut random = Random(49);
    for _ in 0..tries(20_000) {
        let body =
            Body::new(random.uniform(1.0, 20.0), random.uniform(1.0, 20.0), random.log(1e3, 1e6)).unwrap();
        let elevation = random.uniform(0.0, body.height());
        let force = random.log(1e2, 1e7) * if random.coin() { 1.0 } else { -1.0 };
        let situation = standing(body, random.uniform(0.1, 2.0), G)
            .with(variable(Horizontal, Action::horizontal(force, elevation)));
        let full = situation.outcome().unwrap().full;
        let reduced = full.effective.unwrap();
        let half_height = body.height() / 2.0;
        assert_eq!(reduced.point.k_prime(), (elevation - half_height) / half_height);
        assert_eq!(reduced.point.k(), force.abs() / (body.mass() * G));
        assert_eq!(reduced.mirrored, force > 0.0);
        let by_wrench = situation.effective(&full.wrench).unwrap().point;
        assert!((by_wrench.k_prime() - reduced.point.k_prime()).abs() < 1e-12);
        // The same force by its magnitude and direction, and times a factor.
        let direction = if force > 0.0 { Slip::Right } else { Slip::Left };
        let horizontal = HorizontalForce::new(force.abs(), elevation, direction).unwrap();
        let alone = standing(body, situation.static_friction(), G).with(horizontal.load());
        assert_eq!(alone.in_air(), Some(reduced));
        let twice = standing(body, situation.static_friction(), G).with(horizontal.load().times(2.0));
        assert_eq!(twice.in_air().unwrap().point.k(), 2.0 * reduced.point.k());
    }
}

/// A load keeps its name and its factor, a force counts by its direction, and an earthquake turns.
#[test]
fn loads_are_named_and_multiplied() {
    let at = BodyPoint { x: 1.0, y: 2.0 };
    let body = Body::new(4.0, 6.0, 1e4).unwrap();
    let push = Load::force(at, 3.0, 0.0).named("push").times(2.0).times(1.5);
    assert_eq!((push.name.as_deref(), push.factor, push.kind), (Some("push"), 3.0, LoadKind::Horizontal));
    assert_eq!(push.wrench(&body, G, Pose::UPRIGHT), Wrench { x: 9.0, p: 0.0, m: 9.0 });
    assert_eq!(Load::force(at, 0.0, 5.0).kind, LoadKind::Weight);
    let earthquake = Earthquake::new(2.0, -0.5).unwrap();
    let turned = earthquake.turned([-1.0, 1.0, 1.0]);
    assert_eq!((turned.horizontal(), turned.vertical()), (-2.0, -0.5));
    let turned = earthquake.turned([3.0, -2.0, 1.0]);
    assert_eq!((turned.horizontal(), turned.vertical()), (6.0, 1.0));
}
