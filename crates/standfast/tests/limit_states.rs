//! Limit states: their signs decide the mode as the table of their module says, on boundaries too; their values are places of
//! reactions and reserves of friction of the motions.

mod common;

use common::{Boundary, Random, tries};
use standfast::batch::{BatchError, Columns, InstructionSet, LimitColumn, limit_states, limit_states_with};
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

/// Columns of points.
struct Table([Vec<f64>; 4]);

impl Table {
    fn of(points: &[[f64; 4]]) -> Table {
        Table(std::array::from_fn(|place| points.iter().map(|point| point[place]).collect()))
    }

    fn columns(&self) -> Columns<'_> {
        let [gamma, k_prime, k, mu] = &self.0;
        Columns { gamma, k_prime, k, mu }
    }

    /// These limit states on one instruction set.
    fn states(&self, set: InstructionSet, asked: &[LimitState]) -> Result<Vec<Vec<f64>>, BatchError> {
        let mut values = vec![vec![f64::NAN; self.0[0].len()]; asked.len()];
        let columns = asked.iter().zip(&mut values);
        let mut out: Vec<_> = columns.map(|(state, values)| LimitColumn { state: *state, values }).collect();
        limit_states_with(set, self.columns(), &mut out)?;
        Ok(values)
    }
}

/// Numbers at the ends of what a point may have, and zeros of both signs.
const EXTREMES: [&[f64]; 4] = [
    &[1e-50, 1.0, 1e50],
    &[-1e50, -1.0 - f64::EPSILON, -1.0, -0.0, 1e-300, 5e-324, 1e50],
    &[-0.0, 0.0, 5e-324, 1e-300, 1.0, 1e50],
    &[-0.0, 0.0, 5e-324, 1.0, 1e50],
];

fn extremes() -> Vec<[f64; 4]> {
    let mut points = vec![[0.0; 4]];
    for (place, values) in EXTREMES.into_iter().enumerate() {
        let with = |point: &[f64; 4], value| {
            let mut point = *point;
            point[place] = value;
            point
        };
        points = points.iter().flat_map(|point| values.iter().map(|value| with(point, *value))).collect();
    }
    points
}

/// Columns hold the very bits that a point by itself has: each limit state alone and beside others, on every instruction set, in blocks and
/// in what is left of one, far from boundaries and on them.
#[test]
fn columns_are_those_of_points() {
    let mut points = extremes();
    points.extend(
        self::points().map(|point| [point.gamma(), point.k_prime(), point.k(), point.mu()]).step_by(7),
    );
    // No whole number of blocks of any size.
    points.truncate(points.len() / 1024 * 1024 + 3);
    let expected: Vec<LimitStates> = points
        .iter()
        .map(|&[gamma, k_prime, k, mu]| Point::new(gamma, k_prime, k, mu).unwrap().limit_states())
        .collect();
    let table = Table::of(&points);
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let together = table.states(set, &LimitState::ALL).unwrap();
        for (state, column) in LimitState::ALL.into_iter().zip(&together) {
            let alone = table.states(set, &[state]).unwrap();
            for (i, states) in expected.iter().enumerate() {
                let found = [column[i], alone[0][i]].map(f64::to_bits);
                assert_eq!(found, [state.of(states).to_bits(); 2], "{set:?} {state:?} {:?}", points[i]);
            }
        }
    }
    for length in 0..200 {
        let few = Table::of(&points[..length]).states(InstructionSet::Baseline, &LimitState::ALL).unwrap();
        for (state, column) in LimitState::ALL.into_iter().zip(&few) {
            assert!(
                column.iter().zip(&expected).all(|(found, states)| *found == state.of(states)),
                "{length}"
            );
        }
    }
}

/// What a point refuses, columns refuse, with the same error and the place of the first.
#[test]
fn columns_refuse_what_points_do() {
    let wrong = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.1e50, -1.1e50, -5e-324, 0.0, 0.9e-50, -1.0];
    let mut refused = 0;
    for place in 0..4 {
        for value in wrong {
            for index in [0, 1, 63, 64, 129] {
                let mut points = [[1.0, 0.4, 0.5, 0.6]; 130];
                points[index][place] = value;
                points[129][place] = value;
                let [gamma, k_prime, k, mu] = points[index];
                let expected = Point::new(gamma, k_prime, k, mu).err();
                for set in InstructionSet::ALL {
                    match (Table::of(&points).states(set, &[LimitState::TurnO]), &expected) {
                        (Err(BatchError::Value { index: found, source }), Some(error)) => {
                            assert_eq!((found, source.to_string()), (index, error.to_string()));
                            refused += 1;
                        }
                        (Ok(_), None) => {}
                        (found, expected) => panic!("{:?}: {found:?}, {expected:?}", points[index]),
                    }
                }
            }
        }
    }
    assert!(refused > 300, "{refused}");
    let (mut short, one) = ([0.0; 1], [1.0; 2]);
    let columns = Columns { gamma: &one, k_prime: &one, k: &one, mu: &one };
    let out = LimitColumn { state: LimitState::SfSliding, values: &mut short };
    let error = limit_states(columns, &mut [out]).unwrap_err();
    assert_eq!(error.to_string(), "column SF_sliding has 1 values; expected 2, as many as the output");
}
