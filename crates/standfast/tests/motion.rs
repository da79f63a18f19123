//! The motion each mode begins with: the equations of motion, Coulomb's law and non-penetration to 1e-12, the
//! general problem's motion, rational arithmetic next to boundaries, and the report's worked points.

mod common;

use common::{Boundary, Random, tries};
use dashu_ratio::Relaxed as Rational;
use standfast::contact::{Block, solve};
use standfast::initiation::Bounds;
use standfast::{Corner, Mode, Motion, Point, Wrench};

/// The laws, term by term from their definition; `RELATIVE` to the largest term of each.
fn assert_lawful(point: &Point, mode: Mode) -> Motion {
    const RELATIVE: f64 = 1e-12;
    let motion = point.motion_in(mode).unwrap();
    let (γ, k_prime, k, μ) = (point.gamma(), point.k_prime(), point.k(), point.mu());
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } = motion;
    let balance = |terms: &[f64]| {
        let size = terms.iter().fold(1e-300, |size: f64, term| size.max(term.abs()));
        let sum: f64 = terms.iter().sum();
        assert!(sum.abs() <= RELATIVE * size, "{point:?} {mode}: {motion:?}: {terms:?} add up to {sum}");
    };
    balance(&[x_ddot, -f_x, k]); // (3.9)
    balance(&[y_ddot, -f_y, 1.0]); // (3.10)
    balance(&[(1.0 + γ * γ) / 3.0 * theta_ddot, -γ * f_x, -xi * f_y, -γ * k * k_prime]); // (3.11)
    balance(&[slip, -x_ddot, -γ * theta_ddot]);
    balance(&[lift_o, -y_ddot, theta_ddot]);
    balance(&[lift_o_prime, -y_ddot, -theta_ddot]);
    assert!(f_y > 0.0 && xi.abs() <= 1.0, "{point:?} {mode}: {motion:?}");
    assert!(lift_o >= 0.0 && lift_o_prime >= 0.0);
    // Signs, not tolerances: what vanishes on a boundary keeps its sign beside it.
    match mode.slip() {
        Some(direction) => {
            balance(&[f_x, direction.sign() * μ * f_y]);
            assert!(direction.sign() * slip > 0.0, "{point:?} {mode}: {motion:?}");
        }
        None => {
            assert_eq!(slip, 0.0);
            let size = k.max(μ * f_y);
            assert!(f_x.abs() <= μ * f_y + RELATIVE * size, "{point:?} {mode}: {motion:?}");
        }
    }
    // A rotation below the smallest f64, as next to k' = 0, is zero.
    let underflow = theta_ddot == 0.0 && k_prime.abs() < 1e-300;
    match mode.corner() {
        Some(Corner::O) => assert!(
            (theta_ddot > 0.0 || underflow) && xi == -1.0 && lift_o == 0.0,
            "{point:?} {mode}: {motion:?}"
        ),
        Some(Corner::OPrime) => {
            assert!(theta_ddot < 0.0 && xi == 1.0 && lift_o_prime == 0.0, "{point:?} {mode}: {motion:?}")
        }
        None => assert_eq!((theta_ddot, y_ddot), (0.0, 0.0)),
    }
    motion
}

fn check([gamma, k_prime, k, mu]: [f64; 4]) {
    let point = Point::new(gamma, k_prime, k, mu).unwrap();
    assert_lawful(&point, point.mode());
    for mode in point.others().iter() {
        assert_lawful(&point, mode);
    }
}

#[test]
fn every_motion_obeys_newton_coulomb_and_non_penetration() {
    let mut random = Random(21);
    (0..tries(500_000)).for_each(|_| check(random.point()));
}

#[test]
fn so_does_every_motion_within_three_ulps_of_a_boundary() {
    for boundary in Boundary::ALL {
        let mut random = Random(200 + boundary as u64);
        (0..tries(20_000)).for_each(|_| check(boundary.point(&mut random)));
    }
}

/// The general problem's quotients are the report's closed form wherever they lose nothing to cancellation.
#[test]
fn the_general_problem_has_the_same_motion() {
    let mut random = Random(22);
    let mut compared = 0;
    while compared < tries(100_000) {
        let [gamma, k_prime, k, mu] = [
            random.uniform(0.3, 5.0),
            random.uniform(-2.0, 2.0),
            random.uniform(0.0, 4.0),
            random.uniform(0.0, 3.0),
        ];
        let point = Point::new(gamma, k_prime, k, mu).unwrap();
        let answer =
            solve(&Block::uniform(gamma, mu), &Wrench { x: -k, p: 1.0, m: k * k_prime * gamma }).unwrap();
        for mode in answer.modes.iter() {
            // Rounding of ρ² and M can move a point across an edge; then there is nothing to compare.
            let (Some(closed), Some(general)) = (point.motion_in(mode), answer.motion(mode)) else {
                continue;
            };
            let size = 1.0 + k + general.theta_ddot.abs() * (1.0 + gamma);
            if size > 1e3 {
                continue; // next to Painlevé's bound
            }
            let pairs = [
                (closed.x_ddot, general.x_ddot),
                (closed.y_ddot, general.y_ddot),
                (closed.theta_ddot, general.theta_ddot),
                (closed.f_x, general.f_x),
                (closed.f_y, general.f_y),
                (closed.slip, general.slip),
                (closed.xi, general.xi),
            ];
            for (ours, theirs) in pairs {
                assert!(
                    (ours - theirs).abs() <= 1e-10 * size * (1.0 + gamma),
                    "{point:?} {mode}: {closed:?} {general:?}"
                );
            }
            compared += 1;
        }
    }
}

/// θ̈ of rocking is right to the last digits however close k is to k_A.
#[test]
fn the_rotation_keeps_its_digits_next_to_the_boundary() {
    let rational = |x: f64| Rational::try_from(x).unwrap();
    let mut random = Random(23);
    for _ in 0..tries(20_000) {
        let (gamma, k_prime) = (random.uniform(0.3, 5.0), random.uniform(-0.9, 1.0));
        let excess = random.log(1e-17, 1.0);
        let k = (1.0 + excess) / (gamma * (1.0 + k_prime));
        let point = Point::new(gamma, k_prime, k, 50.0).unwrap();
        if point.mode() != Mode::RockO {
            continue;
        }
        let [γ, h, k] = [gamma, k_prime, k].map(rational);
        let [one, three, four] = [1.0, 3.0, 4.0].map(rational);
        let exact = &three * (&k * &γ * (&one + &h) - &one) / (&four * (&one + &γ * &γ)); // (3.14)
        let ours = rational(point.motion().theta_ddot);
        let error = (&ours - &exact) / &exact;
        assert!(error < rational(1e-12) && error > rational(-1e-12), "{point:?}");
    }
}

/// Points worked by hand in the specification of the mathematics.
#[test]
fn worked_points() {
    let rocks = Point::new(1.0, 1.0, 2.0, 5.0).unwrap();
    let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. } = rocks.motion();
    assert_eq!(rocks.mode(), Mode::RockO);
    assert_eq!([theta_ddot, x_ddot, y_ddot, f_x, f_y, xi], [1.125, -1.125, 1.125, 0.875, 2.125, -1.0]);
    assert!(rocks.is_unique());

    let slides = Point::new(1.0, -0.5, 4.0, 3.0).unwrap();
    assert_eq!(slides.mode(), Mode::SlideLeft);
    assert!(!slides.is_unique() && slides.others().contains(Mode::RockO));
    assert_eq!(slides.motion().x_ddot, -1.0);
}

#[test]
fn a_force_through_the_centre_is_the_limit_of_both_chapters() {
    let mut random = Random(24);
    for _ in 0..tries(20_000) {
        // Reals, not fractions: on a boundary the limits are two.
        let [gamma, k, mu] = [random.uniform(0.3, 5.0), random.uniform(0.0, 4.0), random.uniform(0.0, 3.0)];
        let at = |k_prime: f64| Point::new(gamma, k_prime, k, mu).unwrap();
        let (below, centre, above) = (at(-1e-9), at(0.0), at(1e-9));
        assert_eq!(at(-0.0).motion(), centre.motion());
        let near = centre.margins();
        let Bounds { below: low, above: high } = near.mu_bounds();
        if [low, high].into_iter().flatten().any(|crossing| (crossing.at - mu).abs() < 1e-6) {
            continue;
        }
        for side in [below, above] {
            assert_eq!(side.mode(), centre.mode(), "{side:?}");
            assert!(side.is_unique());
            let (ours, limit) = (side.motion(), centre.motion());
            assert!((ours.f_x - limit.f_x).abs() < 1e-6 && (ours.theta_ddot - limit.theta_ddot).abs() < 1e-6);
        }
    }
}

#[test]
fn only_consistent_modes_have_a_motion() {
    let rests = Point::new(1.0, 0.4, 0.1, 0.6).unwrap();
    assert!(rests.motion_in(Mode::Rest).is_some());
    for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Rest) {
        assert!(rests.motion_in(mode).is_none(), "{mode}");
    }
}

/// Erratum 5: chance of rocking does not grow steadily with the elevation of the force.
#[test]
fn a_higher_force_can_end_rocking() {
    let mode = |k_prime| Point::new(4.0, k_prime, 100.0, 0.5).unwrap().mode();
    assert_eq!(mode(5.0 / 12.0), Mode::RockO);
    assert_eq!(mode(1.0), Mode::SlideRockORight);
}

/// A batch under a force to the right is the contact problem of that force.
#[test]
fn mirrored_columns_are_those_of_a_force_to_the_right() {
    use standfast::batch::{self, Columns, OnsetColumns};

    let mut random = Random(29);
    let uniform = |random: &mut Random| [0.2, -2.0, 0.05, 0.05].map(|least| least + random.uniform(0.0, 3.0));
    let points: Vec<[f64; 4]> = (0..tries(10_000)).map(|_| uniform(&mut random)).collect();
    let count = points.len();
    let column = |i: usize| points.iter().map(|point| point[i]).collect::<Vec<f64>>();
    let [gamma, k_prime, k, mu] = [0, 1, 2, 3].map(column);
    let columns = Columns { gamma: &gamma, k_prime: &k_prime, k: &k, mu: &mu };
    let (mut mode, mut others) = (vec![0; count], vec![0; count]);
    let mut motion = [(); 9].map(|()| vec![0.0; count]);
    let out = OnsetColumns {
        mode: Some(&mut mode),
        others: Some(&mut others),
        motion: motion.each_mut().map(|column| Some(column.as_mut_slice())),
        mirrored: true,
        ..OnsetColumns::default()
    };
    batch::onset(columns, out).unwrap();
    let mut codes = vec![0; count];
    batch::classify(columns, &mut codes).unwrap();
    batch::mirror(&mut codes);
    assert_eq!(codes, mode);

    for (i, &[gamma, k_prime, k, mu]) in points.iter().enumerate() {
        let right = Wrench { x: k, p: 1.0, m: -k * k_prime * gamma };
        let found = solve(&Block::uniform(gamma, mu), &right).unwrap();
        let code = |mode: Mode| u16::from(mode.code());
        let expected = found.mode().unwrap();
        assert_eq!(Mode::from_code(mode[i]), Some(expected), "{:?}", points[i]);
        let bits = Mode::ALL.into_iter().filter(|&mode| found.modes.contains(mode) && mode != expected);
        assert_eq!(others[i], bits.map(|mode| 1 << code(mode)).sum::<u16>());
        let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } =
            found.motion(expected).unwrap();
        let expected = [x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime];
        for (column, expected) in motion.iter().zip(expected) {
            let size = 1.0 + gamma.max(1.0) * (k + mu);
            assert!(
                (column[i] - expected).abs() <= 1e-9 * size * size,
                "{:?}: {} {expected}",
                points[i],
                column[i]
            );
        }
    }
}

/// The columns of a batch are the values of the single calls, bit for bit.
#[test]
fn onset_columns_agree_with_the_single_call() {
    use standfast::batch::{self, BatchError, Columns, OnsetColumns};

    let mut random = Random(23);
    let mut points: Vec<[f64; 4]> = (0..tries(3_000)).map(|_| random.point()).collect();
    for boundary in Boundary::ALL {
        points.extend((0..100).map(|_| boundary.point(&mut random)));
    }
    points.push([1.0, -0.5, 4.0, 3.0]); // three consistent modes
    let count = points.len();
    let column = |i: usize| points.iter().map(|point| point[i]).collect::<Vec<f64>>();
    let [slenderness, elevation, force, friction] = [0, 1, 2, 3].map(column);
    let columns = Columns { gamma: &slenderness, k_prime: &elevation, k: &force, mu: &friction };

    let (mut mode, mut unique, mut others) = (vec![0; count], vec![false; count], vec![0; count]);
    let mut motion = [(); 9].map(|()| vec![0.0; count]);
    let mut out = OnsetColumns {
        mode: Some(&mut mode),
        unique: Some(&mut unique),
        others: Some(&mut others),
        motion: motion.each_mut().map(|column| Some(column.as_mut_slice())),
        mirrored: false,
    };
    batch::onset(columns, out.reborrow()).unwrap();
    for (i, &[g, h, k, m]) in points.iter().enumerate() {
        let point = Point::new(g, h, k, m).unwrap();
        assert_eq!(Mode::from_code(mode[i]), Some(point.mode()));
        let bits = Mode::ALL.into_iter().filter(|&mode| others[i] >> mode.code() & 1 == 1).collect();
        assert_eq!((point.others(), point.is_unique()), (bits, unique[i]));
        let Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime } = point.motion();
        let expected = [x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, slip, lift_o, lift_o_prime];
        assert_eq!(motion.each_ref().map(|column| column[i]), expected);
    }
    assert!(others.iter().any(|bits| bits.count_ones() == 2));

    // Each column alone is the one among all.
    let mut alone = vec![7.0; count];
    for (i, column) in motion.iter().enumerate() {
        let mut out = OnsetColumns::default();
        out.motion[i] = Some(&mut alone);
        batch::onset(columns, out).unwrap();
        assert_eq!(alone, *column);
    }
    let mut alone = vec![false; count];
    batch::onset(columns, OnsetColumns { unique: Some(&mut alone), ..OnsetColumns::default() }).unwrap();
    assert_eq!(alone, unique);

    let mut short = vec![0.0; count - 1];
    let mut out = OnsetColumns { mode: Some(&mut mode), ..OnsetColumns::default() };
    out.motion[5] = Some(&mut short);
    let error = batch::onset(columns, out);
    assert_eq!(error, Err(BatchError::Length { column: "xi", found: count - 1, expected: count }));

    // The first wrong value is named wherever it stands.
    for place in [0, 1, count / 2, count - 1] {
        let mut friction = friction.clone();
        friction[place] = -1.0;
        let out = OnsetColumns { mode: Some(&mut mode), ..OnsetColumns::default() };
        let error = batch::onset(Columns { mu: &friction, ..columns }, out).unwrap_err();
        assert!(matches!(error, BatchError::Value { index, .. } if index == place), "{error}");
    }
}
