//! Limit states: their signs decide the mode as the table of their module says, on boundaries too; their values are places of
//! reactions and reserves of friction of the motions.

mod common;

use common::{Boundary, Random, tries};
use standfast::initiation::{LimitState, LimitStates};
use standfast::{Mode, Point};

/// The first line of the table that holds, for a force to the left.
fn by_signs(states: &LimitStates) -> Mode {
    let LimitStates { slide, rock_o, rock_o_prime, turn_o, turn_o_prime, .. } = *states;
    if slide >= 0.0 && rock_o >= 0.0 && rock_o_prime >= 0.0 {
        Mode::Rest
    } else if slide < 0.0 && turn_o >= 0.0 && turn_o_prime >= 0.0 {
        Mode::SlideLeft
    } else if rock_o_prime < 0.0 && states.slip_o_prime_left >= 0.0 {
        Mode::RockOPrime
    } else if turn_o_prime < 0.0 {
        Mode::SlideRockOPrimeLeft
    } else if states.slip_o_left < 0.0 {
        Mode::SlideRockOLeft
    } else if states.slip_o_right < 0.0 {
        Mode::SlideRockORight
    } else {
        Mode::RockO
    }
}

fn points() -> impl Iterator<Item = Point> {
    let mut random = Random(12);
    let anywhere = (0..tries(1_000_000)).map(|_| 0);
    let near = Boundary::ALL.into_iter().flat_map(|_| (0..tries(10_000)).map(|_| 1));
    anywhere.chain(near).enumerate().map(move |(i, kind)| {
        let [gamma, k_prime, k, mu] = match kind {
            0 => random.point(),
            _ => Boundary::ALL[i % Boundary::ALL.len()].point(&mut random),
        };
        Point::new(gamma, k_prime, k, mu).unwrap()
    })
}

#[test]
fn signs_decide_the_mode() {
    let mut seen = [0; Mode::ALL.len()];
    for point in points() {
        let mode = by_signs(&point.limit_states());
        assert_eq!(mode, point.mode(), "{point:?} {:?}", point.limit_states());
        seen[usize::from(mode.code())] += 1;
    }
    assert!(seen[..=usize::from(Mode::RockOPrime.code())].iter().all(|count| *count > 0), "{seen:?}");
}

#[test]
fn values_are_those_of_motions() {
    let mut random = Random(13);
    let mut compared = 0;
    for _ in 0..tries(100_000) {
        let [gamma, k_prime, k, mu] = [
            random.uniform(0.3, 3.0),
            random.uniform(-2.0, 2.0),
            random.uniform(0.0, 3.0),
            random.uniform(0.0, 3.0),
        ];
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let (states, mode, motion) = (point.limit_states(), point.mode(), point.motion());
        let [left, right] = [mu * motion.f_y - motion.f_x, mu * motion.f_y + motion.f_x];
        let expected = match mode {
            Mode::Rest => {
                vec![
                    (states.rock_o, 1.0 + motion.xi),
                    (states.rock_o_prime, 1.0 - motion.xi),
                    (states.slide, mu - motion.f_x),
                ]
            }
            Mode::SlideLeft => vec![(states.turn_o, 1.0 + motion.xi), (states.turn_o_prime, 1.0 - motion.xi)],
            Mode::RockO => vec![(states.slip_o_left, left), (states.slip_o_right, right)],
            Mode::RockOPrime => vec![(states.slip_o_prime_left, left), (states.slip_o_prime_right, right)],
            _ => Vec::new(),
        };
        for (found, expected) in expected {
            assert!(
                (found - expected).abs() < 1e-12 * (1.0 + mu) * (1.0 + k),
                "{point:?}: {found} {expected}"
            );
            compared += 1;
        }
    }
    assert!(compared > tries(50_000));
}

#[test]
fn the_load_factor_is_where_the_body_leaves_rest() {
    let mut random = Random(14);
    for _ in 0..tries(20_000) {
        let [gamma, k_prime, k, mu] = random.point();
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let found = point.limit_states().load_factor;
        match point.margins().leaves_rest() {
            _ if k == 0.0 => assert_eq!(found, f64::INFINITY),
            Some(crossing) => {
                assert!((found * k / crossing.at - 1.0).abs() < 1e-12 || mu == 0.0, "{point:?}")
            }
            None => assert!(mu == 0.0 && found == 0.0, "{point:?} {found}"),
        }
    }
}

#[test]
fn names_are_those_of_the_fields() {
    let states = Point::new(0.7, -0.3, 1.9, 0.8).unwrap().limit_states();
    for state in LimitState::ALL {
        let field = format!("{}: {:?}", state.name().to_lowercase(), state.of(&states));
        assert!(format!("{states:?}").contains(&field), "{field}");
    }
    let swapped = states.mirrored();
    assert_eq!(swapped.mirrored(), states);
    assert_eq!((swapped.slide, swapped.load_factor), (states.slide, states.load_factor));
}
