//! The closed form against the enumeration of all contact modes, and the enumeration against the laws it stands for.

mod common;

use common::{Boundary, Random, tries};
use standfast::contact::{Block, solve};
use standfast::initiation::enumerate;
use standfast::{Corner, InputError, Mode, Modes, Motion, Point, Slip, Wrench};

fn check([gamma, k_prime, k, mu]: [f64; 4]) {
    let point = Point::new(gamma, k_prime, k, mu).unwrap();
    let mut closed_form = point.others();
    assert!(!closed_form.contains(point.mode()));
    closed_form.insert(point.mode());
    assert_eq!(closed_form, enumerate(&point), "{point:?}");
}

#[test]
fn closed_form_is_the_enumeration_of_contact_modes() {
    let mut random = Random(1);
    (0..tries(300_000)).for_each(|_| check(random.point()));
}

#[test]
fn closed_form_is_the_enumeration_on_boundaries() {
    for boundary in Boundary::ALL {
        let mut random = Random(100 + boundary as u64);
        (0..tries(20_000)).for_each(|_| check(boundary.point(&mut random)));
    }
}

/// The indeterminate set is met often enough for the two tests above to mean something.
#[test]
fn all_modes_and_both_parts_of_n_occur() {
    let mut random = Random(2);
    let mut seen = Modes::NONE;
    let mut triples = Modes::NONE;
    for _ in 0..tries(200_000).max(5_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        seen.insert(point.mode());
        if point.others().len() == 2 {
            assert_eq!(point.others().to_string(), "RO SRO-");
            assert!(mu > 4.0 / 3.0);
            triples.insert(point.mode());
        }
    }
    assert_eq!(seen.to_string(), "RE SL RO SRO- SRO+ SRO'- RO'");
    assert_eq!(triples.to_string(), "SL SRO'-");
}

/// A random block, and a wrench that presses or lifts, with dyadic numbers so that edges are met exactly.
fn random_case(random: &mut Random) -> (Block, Wrench) {
    let coarse = random.coin();
    let mut positive = |high: f64| {
        let value = random.uniform(0.05, high);
        if coarse { (value * 8.0).ceil() / 8.0 } else { value }
    };
    let [b1, b2, d, rho2, m_x, m_y] =
        [positive(2.0), positive(2.0), positive(4.0), positive(3.0), positive(3.0), positive(3.0)];
    let mu_k = positive(4.0);
    let block = Block { b1, b2, d, rho2, m_x, m_y, mu_s: mu_k, mu_k };
    let mut any = |size: f64| {
        let value = random.uniform(-size, size);
        if coarse { (value * 8.0).round() / 8.0 } else { value }
    };
    (block, Wrench { x: any(4.0), p: any(2.0) + 1.0, m: any(4.0) })
}

/// Newton, Coulomb and non-penetration, from the definition, for a motion that `solve` returned.
fn assert_lawful(block: &Block, wrench: &Wrench, mode: Mode) {
    let Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k } = *block;
    let Wrench { x, p, m } = *wrench;
    let motion = solve(block, wrench).unwrap().motion(mode).unwrap();
    let close = |left: f64, right: f64, terms: &[f64]| {
        let size: f64 = terms.iter().map(|term| term.abs()).sum::<f64>() + 1e-300;
        assert!((left - right).abs() <= 1e-12 * size, "{block:?} {wrench:?} {mode}: {left} ≠ {right}");
    };
    let atol = 1e-9 * (1.0 + x.abs() + p.abs() + m.abs());
    close(m_x * motion.x_ddot, motion.f_x + x, &[motion.f_x, x]);
    close(m_y * motion.y_ddot, motion.f_y - p, &[motion.f_y, p]);
    let terms = [motion.f_x * d, motion.f_y * motion.xi, m, rho2 * motion.theta_ddot, p, x * d];
    // Near Painlevé's bound ρ² + m_y r c vanishes and α has lost as many digits as its inverse has gained.
    let amplification = 1.0 + motion.theta_ddot.abs();
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    let moment = motion.f_x * d + motion.f_y * motion.xi + m;
    assert!(
        (rho2 * motion.theta_ddot - moment).abs() <= 1e-12 * size * amplification,
        "{block:?} {wrench:?} {mode}"
    );
    assert!(motion.f_y >= -atol && -b1 - 1e-9 <= motion.xi && motion.xi <= b2 + 1e-9);
    close(motion.slip, motion.x_ddot + d * motion.theta_ddot, &[motion.x_ddot, d * motion.theta_ddot, x]);
    let size = motion.y_ddot.abs() + (b1 + b2) * motion.theta_ddot.abs();
    assert!(motion.lift_o >= -1e-12 * size && motion.lift_o_prime >= -1e-12 * size);
    match mode.slip() {
        Some(slip) => {
            close(motion.f_x, -slip.sign() * mu_k * motion.f_y, &[motion.f_x]);
            assert!(slip.sign() * motion.slip > -atol);
        }
        None if mode == Mode::Flight => assert_eq!((motion.f_x, motion.f_y), (0.0, 0.0)),
        None => {
            assert!(motion.f_x.abs() <= mu_s * motion.f_y + atol);
            assert_eq!(motion.slip, 0.0);
        }
    }
}

#[test]
fn every_consistent_motion_of_the_general_problem_obeys_the_laws() {
    let mut random = Random(3);
    for _ in 0..tries(100_000) {
        let (mut block, wrench) = random_case(&mut random);
        if random.coin() {
            block.mu_s += random.uniform(0.0, 1.0);
        }
        for mode in solve(&block, &wrench).unwrap().modes.iter() {
            assert_lawful(&block, &wrench, mode);
        }
    }
}

/// The explanation of a mode: one relation for each of its conditions, between numbers of its motion, each of which holds.
#[test]
fn a_mode_is_explained_by_the_conditions_it_meets() {
    let mut random = Random(9);
    let mut seen = Modes::NONE;
    for _ in 0..tries(20_000).max(2_000) {
        let (mut block, wrench) = random_case(&mut random);
        if random.coin() {
            block.mu_s += random.uniform(0.0, 1.0);
        }
        let answer = solve(&block, &wrench).unwrap();
        for mode in Mode::ALL {
            let relations = answer.explain(mode);
            let Some(Motion { theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime, .. }) =
                answer.motion(mode)
            else {
                assert!(relations.is_empty(), "{mode}");
                continue;
            };
            seen.insert(mode);
            let pressed = ("f_y ≥ 0", f_y, 0.0);
            let friction = ("|f_x| ≤ μ_s f_y", f_x.abs(), block.mu_s * f_y);
            let base = [("ξ ≥ −b_1", xi, -block.b1), ("ξ ≤ b_2", xi, block.b2)];
            let slipping = match mode.slip() {
                Some(Slip::Left) => ("ẍ_O < 0", slip, 0.0),
                _ => ("ẍ_O > 0", slip, 0.0),
            };
            let turning = match mode.corner() {
                Some(Corner::O) => ("θ̈ > 0", theta_ddot, 0.0),
                _ => ("θ̈ < 0", theta_ddot, 0.0),
            };
            let expected = match mode {
                Mode::Rest => vec![friction, pressed, base[0], base[1]],
                Mode::SlideLeft | Mode::SlideRight => vec![slipping, pressed, base[0], base[1]],
                Mode::RockO | Mode::RockOPrime => vec![turning, pressed, friction],
                Mode::Flight => vec![("ÿ_O ≥ 0", lift_o, 0.0), ("ÿ_O' ≥ 0", lift_o_prime, 0.0)],
                _ => vec![turning, pressed, slipping],
            };
            let size = 1.0 + f_x.abs() + f_y.abs() + theta_ddot.abs();
            for (relation, &(statement, left, right)) in relations.iter().zip(&expected) {
                assert_eq!((&*relation.statement(), relation.left, relation.right), (statement, left, right));
                assert!(
                    relation.holds && relation.margin() >= -1e-9 * size,
                    "{block:?} {wrench:?}: {relation}"
                );
            }
            assert_eq!(relations.len(), expected.len());
        }
    }
    assert_eq!(seen.len(), 10);
}

/// Some mode always holds; more than one only at or beyond Painlevé's bound, or where two modes are one motion on a
/// shared edge.
#[test]
fn the_general_problem_has_an_answer_and_it_is_unique_below_painleves_bound() {
    let mut random = Random(4);
    for _ in 0..tries(200_000) {
        let (block, wrench) = random_case(&mut random);
        let answer = solve(&block, &wrench).unwrap();
        let reported = answer.mode().unwrap_or_else(|| panic!("no mode: {block:?} {wrench:?}"));
        let Block { b1, b2, d, rho2, m_y, mu_k, .. } = block;
        let bound = |r: f64| (rho2 / m_y + r * r) / (r * d);
        if mu_k < bound(b1).min(bound(b2)) * (1.0 - 1e-12) {
            let first = answer.motion(reported).unwrap();
            for other in answer.modes.iter() {
                let motion = answer.motion(other).unwrap();
                let same =
                    (motion.x_ddot - first.x_ddot).abs() + (motion.theta_ddot - first.theta_ddot).abs();
                assert!(same < 1e-9, "{block:?} {wrench:?}: {reported} and {other}");
            }
        }
    }
}

#[test]
fn static_friction_above_kinetic_leaves_no_gap() {
    let mut random = Random(5);
    for _ in 0..tries(200_000) {
        let (mut block, wrench) = random_case(&mut random);
        block.mu_s += random.uniform(0.0, 2.0);
        let answer = solve(&block, &wrench).unwrap();
        assert!(answer.mode().is_some(), "{block:?} {wrench:?}");
    }
}

#[test]
fn the_general_problem_is_symmetric() {
    let mut random = Random(6);
    for _ in 0..tries(50_000) {
        let (block, wrench) = random_case(&mut random);
        let mirror = Block { b1: block.b2, b2: block.b1, ..block };
        let here = solve(&block, &wrench).unwrap().modes;
        let there = solve(&mirror, &Wrench { x: -wrench.x, m: -wrench.m, ..wrench }).unwrap().modes;
        assert_eq!(here.iter().map(Mode::mirrored).collect::<Modes>(), there, "{block:?} {wrench:?}");
    }
}

/// Slip at a corner counts only where that corner cannot stick: two wrenches on which stick and slip both satisfy all
/// laws.
#[test]
fn slip_gives_way_to_stick_at_the_same_corner() {
    let modes = |block: Block, x, m| solve(&block, &Wrench { x, p: 1.0, m }).unwrap().modes.to_string();
    let block = Block { mu_s: 0.9, mu_k: 0.1, ..Block::uniform(1.0, 0.1) };
    assert_eq!(modes(block, -1.0, 0.5), "RO"); // not also SL
    let block = Block { b1: 1.0, b2: 1.0, d: 1.0, rho2: 0.625, m_x: 1.0, m_y: 1.0, mu_s: 0.875, mu_k: 0.375 };
    assert_eq!(modes(block, 0.5625, 1.4375), "RE"); // not also SRO+
}

#[test]
fn mu_s_above_mu_k_sticks_first() {
    // Pulled between the two frictions: rest holds, slip is not tried.
    let block = Block { mu_s: 0.8, mu_k: 0.5, ..Block::uniform(1.0, 0.5) };
    let pull = |x| solve(&block, &Wrench { x, p: 1.0, m: 0.0 }).unwrap();
    assert_eq!(pull(-0.7).modes.to_string(), "RE");
    let slides = pull(-0.9);
    assert_eq!(slides.modes.to_string(), "SL");
    assert!((slides.motion(Mode::SlideLeft).unwrap().x_ddot - -0.4).abs() < 1e-15);
}

#[test]
fn a_lifted_block_flies_and_a_weightless_one_floats() {
    let block = Block::uniform(1.0, 0.5);
    let modes = |x, p, m| solve(&block, &Wrench { x, p, m }).unwrap().modes.to_string();
    assert_eq!(modes(0.0, -1.0, 0.0), "FL");
    assert_eq!(modes(0.0, 0.0, 0.0), "RE"); // as flight: no motion
    assert_eq!(modes(0.3, 0.0, 0.0), "SL+"); // as flight: along the base
}

/// Loads chosen so that the block, in flight, would not leave the base at one corner or at both: the motion is then that of a
/// mode which touches without pressing, and counts once, as that mode. The motion is chosen first and the wrench follows,
/// X = m_x ẍ, P = −m_y ÿ, M = ρ² α, in numbers that are exact.
#[test]
fn a_motion_without_reaction_counts_once_as_the_mode_that_touches() {
    let mut seen = Modes::NONE;
    // μ = 4 is beyond Painlevé's bound for all of these blocks, ¼ below it.
    for mu in [0.25, 4.0] {
        for (b1, b2, d, rho2) in
            [(1.0, 1.0, 1.0, 1.0), (0.5, 2.0, 1.5, 0.75), (2.0, 1.0, 2.0, 1.0), (1.0, 1.0, 4.0, 0.5)]
        {
            for (m_x, m_y) in [(1.0, 1.0), (1.5, 1.0), (2.0, 0.5)] {
                let block = Block { b1, b2, d, rho2, m_x, m_y, mu_s: mu, mu_k: mu };
                for turn in [-1.0, -0.5, 0.0, 0.5, 1.0] {
                    for slip in [-1.0, -0.25, 0.0, 0.25, 1.0] {
                        for lift in [0.0, 0.5] {
                            // The lower corner lifts off at `lift`.
                            let y_ddot = lift + if turn > 0.0 { b1 * turn } else { -b2 * turn };
                            let x_ddot = slip - d * turn;
                            let wrench = Wrench { x: m_x * x_ddot, p: -m_y * y_ddot, m: rho2 * turn };
                            let left = slip < 0.0;
                            let expected = match (lift > 0.0, turn, slip) {
                                (true, ..) => Mode::Flight,
                                (_, 0.0, 0.0) => Mode::Rest,
                                (_, 0.0, _) => {
                                    if left {
                                        Mode::SlideLeft
                                    } else {
                                        Mode::SlideRight
                                    }
                                }
                                (_, 0.0.., 0.0) => Mode::RockO,
                                (_, 0.0.., _) => {
                                    if left {
                                        Mode::SlideRockOLeft
                                    } else {
                                        Mode::SlideRockORight
                                    }
                                }
                                (.., 0.0) => Mode::RockOPrime,
                                _ => {
                                    if left {
                                        Mode::SlideRockOPrimeLeft
                                    } else {
                                        Mode::SlideRockOPrimeRight
                                    }
                                }
                            };
                            let answer = solve(&block, &wrench).unwrap();
                            let others = answer.modes.without(Some(expected));
                            assert!(
                                answer.modes.contains(expected),
                                "{block:?} {wrench:?}: {}",
                                answer.modes
                            );
                            assert!(!others.contains(Mode::Flight), "{block:?} {wrench:?}: {}", answer.modes);
                            if mu < 1.0 {
                                assert!(others.is_empty(), "{block:?} {wrench:?}: {}", answer.modes);
                            }
                            let motion = answer.motion(expected).unwrap();
                            assert_eq!((motion.x_ddot, motion.y_ddot), (x_ddot, y_ddot));
                            assert_eq!((motion.theta_ddot, motion.slip), (turn, slip));
                            assert_eq!((motion.f_x, motion.f_y, motion.xi), (0.0, 0.0, 0.0));
                            seen.insert(expected);
                        }
                    }
                }
            }
        }
    }
    assert_eq!(seen.len(), 10);
}

#[test]
fn bad_blocks_and_wrenches_are_refused() {
    let block = Block::uniform(1.0, 0.5);
    let wrench = Wrench { x: -1.0, p: 1.0, m: 0.0 };
    let message = |block: Block, wrench: Wrench| -> String {
        solve(&block, &wrench).map_err(|error: InputError| error.to_string()).unwrap_err()
    };
    assert_eq!(
        message(Block { b1: 0.0, ..block }, wrench),
        "distance b1 of O is 0; expected a number above zero, from 1e-50 to 1e50"
    );
    assert_eq!(
        message(Block { mu_s: 0.4, ..block }, wrench),
        "static friction mu_s is 0.4; expected no less than the kinetic friction mu_k"
    );
    assert_eq!(
        message(block, Wrench { m: f64::NAN, ..wrench }),
        "moment m is NaN; expected a number from -1e50 to 1e50"
    );
}

/// Next to the edge where rocking begins, the rotation has the sign the mode needs.
#[test]
fn a_rotation_next_to_its_edge_keeps_its_sign() {
    let mut random = Random(8);
    let mut rocked = 0;
    for _ in 0..tries(50_000) {
        let block = Block { mu_s: 5.0, mu_k: 5.0, b1: random.uniform(0.5, 2.0), ..Block::uniform(2.0, 5.0) };
        let x = random.uniform(-1.0, 0.0);
        let wrench = Wrench { x, p: 1.0, m: random.nudge(block.b1 + x * block.d) };
        let answer = solve(&block, &wrench).unwrap();
        if let Some(motion) = answer.motion(Mode::RockO) {
            assert!(motion.theta_ddot > 0.0, "{block:?} {wrench:?}");
            rocked += 1;
        }
    }
    assert!(rocked > tries(5_000));
}
