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
fn tossed(row: &[f64]) -> (i32, f64, f64) {
    let mut problem = cube(0.219);
    problem.impact = Impact::Inelastic;
    let tilt = row[1];
    let lowest = HALF * (tilt.cos().abs() + tilt.sin().abs());
    let (mut turns, mut x, mut time) = (0, 0.0, 0.0);
    problem.initial = Initial {
        theta: tilt,
        omega: row[2],
        vx: Some(row[4]),
        vy: Some(row[5]),
        gap: (row[3] - lowest).max(0.0),
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
        problem.initial = Initial { theta: 0.0, ..outcome.last };
    }
    panic!("it rolls without end: {row:?}");
}

/// 36 tosses: at least 34 faces right. They travel about a quarter less than measured, for the cube bounces a little.
#[test]
fn tosses_end_on_the_face_measured() {
    let (mut right, mut ratios) = (0, Vec::new());
    let all: Vec<_> = rows(include_str!("data/cube-tosses.csv")).collect();
    for row in &all {
        let (turns, x, time) = tossed(row);
        right += i32::from(turns == row[8] as i32);
        ratios.push(x / row[7]);
        assert!(time > 0.05 && time < 2.0, "{time}");
    }
    assert_eq!(all.len(), 36);
    assert!(right >= 34, "{right} of 36");
    ratios.sort_by(f64::total_cmp);
    assert!((0.6..0.95).contains(&ratios[18]), "{}", ratios[18]);
}
