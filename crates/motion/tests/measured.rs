//! A cube slid and tossed, measured; the tables and their licence are in tests/data.

use standfast::contact::Block;
use standfast_motion::{End, Impact, Initial, Keep, MotionProblem, simulate};

/// Half the width, m; I/m in its square; friction at which the slides were fitted.
const HALF: f64 = 0.0524;
const RHO2: f64 = 0.797;

fn cube(friction: f64) -> MotionProblem {
    let block = Block {
        b1: HALF,
        b2: HALF,
        d: HALF,
        rho2: RHO2 * HALF * HALF,
        m_x: 1.0,
        m_y: 1.0,
        mu_s: friction,
        mu_k: friction,
    };
    MotionProblem::new(block, 9.81)
}

fn rows(table: &'static str) -> impl Iterator<Item = Vec<f64>> {
    let lines = table.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
}

/// 82 slides with one friction for all: 4 % in the median, 16 % each.
#[test]
fn slides_stop_where_measured() {
    let mut errors = Vec::new();
    for row in rows(include_str!("data/cube-slides.csv")) {
        let (speed, measured) = (row[1], row[2]);
        let mut problem = cube(0.22);
        problem.initial = Initial { vx: Some(speed), ..Initial::default() };
        let outcome = simulate(&problem, Keep::default()).unwrap();
        assert_eq!(outcome.end, End::AtRest);
        errors.push((outcome.slide / measured - 1.0).abs());
    }
    errors.sort_by(f64::total_cmp);
    assert_eq!(errors.len(), 82);
    assert!(errors[41] < 0.04, "{}", errors[41]);
    assert!(errors[81] < 0.16, "{}", errors[81]);
}

/// The face on which a tossed cube comes to rest, in quarter turns, how far it came and when it rested: each quarter turn that is over is a cube
/// again, on its next face.
fn tossed(row: &[f64], e: f64, mu_impact: f64) -> (i32, f64, f64) {
    let mut problem = cube(0.219);
    (problem.impact, problem.restitution) = (Impact::Poisson, e);
    problem.mu_impact = Some(mu_impact);
    let tilt = row[1];
    let lowest = HALF * (tilt.cos().abs() + tilt.sin().abs());
    let (mut turns, mut x, mut time) = (0, 0.0, 0.0);
    problem.initial = Initial {
        theta: tilt,
        omega: row[2],
        vx: Some(row[4]),
        vy: Some(row[5]),
        gap: (row[3] - lowest).max(0.0),
        ..Initial::default()
    };
    for _ in 0..20 {
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let at = outcome.at(f64::INFINITY).unwrap();
        x += at.x;
        time += outcome.events.last().unwrap().t;
        if outcome.end != End::Overturned {
            assert_eq!(outcome.end, End::AtRest);
            return (turns, x, time);
        }
        turns += outcome.theta.signum() as i32;
        let Initial { omega, vx, vy, gap, .. } = outcome.last;
        problem.initial = Initial { omega, vx, vy, gap, ..Initial::default() };
    }
    panic!("it rolls without end: {row:?}");
}

/// Faces right, the median share of the measured way, and the mean distance between both ways, mm.
fn all_tossed(e: f64, mu_impact: f64) -> (i32, f64, f64) {
    let (mut right, mut off, mut ratios) = (0, 0.0, Vec::new());
    let all: Vec<_> = rows(include_str!("data/cube-tosses.csv")).collect();
    for row in &all {
        let (turns, x, time) = tossed(row, e, mu_impact);
        right += i32::from(turns == row[8] as i32);
        ratios.push(x / row[7]);
        off += (x - row[7]).abs();
        assert!(time > 0.05 && time < 2.0, "{time}");
    }
    assert_eq!(all.len(), 36);
    ratios.sort_by(f64::total_cmp);
    (right, 0.5 * (ratios[17] + ratios[18]), 1e3 * off / 36.0)
}

/// 36 tosses with the friction of the slides: without rebound 35 faces are right, and the cube goes two thirds of the measured way. The restitution that
/// is reported, 0.125, changes that little; a larger one loses faces. Less friction at impacts than in slides brings it farther. None of these is fitted.
#[test]
fn tosses_end_on_the_face_measured() {
    for (e, mu_impact, faces, share, off) in [
        (0.0, 0.219, 35, 0.66, 88.0),
        (0.125, 0.219, 35, 0.66, 87.0),
        (0.55, 0.219, 32, 0.73, 72.0),
        (0.0, 0.12, 35, 0.85, 40.0),
        (0.125, 0.12, 34, 0.90, 28.0),
    ] {
        let (right, ratio, distance) = all_tossed(e, mu_impact);
        let told = format!("{e} {mu_impact}: {right} faces, {ratio} of the way, {distance} mm");
        assert_eq!(right, faces, "{told}");
        assert!((ratio - share).abs() < 0.005 && (distance - off).abs() < 0.5, "{told}");
    }
}
