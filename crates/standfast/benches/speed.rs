//! Time of one classification, one motion, one diagram, and a batch of 10⁷ points.
//!
//! `cargo bench -p standfast --bench speed`

#[path = "../tests/common/mod.rs"]
mod common;

use common::Random;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use standfast::batch::{self, Columns};
use standfast::contact::Block;
use standfast::contact::stack::{Joint, Shaking, Stack, StackBody};
use standfast::ground::strength::{CrushPoint, stages};
use standfast::{Diagram, Point, Wrench};

fn main() {
    divan::main();
}

fn points(count: usize) -> Vec<[f64; 4]> {
    let mut random = Random(1);
    (0..count)
        .map(|_| {
            [
                random.uniform(0.3, 4.0),
                random.uniform(-1.0, 1.0),
                random.uniform(0.0, 3.0),
                random.uniform(0.0, 2.0),
            ]
        })
        .collect()
}

/// Of 1000 points, one by one.
#[divan::bench]
fn classify_1000_points(bencher: Bencher) {
    let points = points(1000);
    bencher.counter(ItemsCount::new(points.len())).bench(|| {
        for &[gamma, k_prime, k, mu] in black_box(&points) {
            black_box(standfast::classify(gamma, k_prime, k, mu).unwrap());
        }
    });
}

/// Mode, other modes and motion of 1000 points, one by one.
#[divan::bench]
fn motion_of_1000_points(bencher: Bencher) {
    let points = points(1000);
    bencher.counter(ItemsCount::new(points.len())).bench(|| {
        for &[gamma, k_prime, k, mu] in black_box(&points) {
            let point = Point::new(gamma, k_prime, k, mu).unwrap();
            black_box((point.motion(), point.others()));
        }
    });
}

/// Of 1000 points on a base that crushes at ω = 0.2, one by one: the verdict.
#[divan::bench]
fn crush_1000_points(bencher: Bencher) {
    let points = points(1000);
    bencher.counter(ItemsCount::new(points.len())).bench(|| {
        for &[gamma, k_prime, k, mu] in black_box(&points) {
            black_box(CrushPoint::new(gamma, k_prime, k, mu, 0.2).unwrap().verdict());
        }
    });
}

/// Verdict, other modes and motion of the same.
#[divan::bench]
fn crush_motion_of_1000_points(bencher: Bencher) {
    let points = points(1000);
    bencher.counter(ItemsCount::new(points.len())).bench(|| {
        for &[gamma, k_prime, k, mu] in black_box(&points) {
            let point = CrushPoint::new(gamma, k_prime, k, mu, 0.2).unwrap();
            black_box((point.motion(), point.others()));
        }
    });
}

/// Bricks on each other under a push and some uplift, none of it in round numbers.
fn stack(count: usize) -> Stack {
    let bodies = (0..count).map(|place| {
        let (width, at) = (3.0 - 0.3 * place as f64, place as f64);
        StackBody {
            x: 0.013 * at,
            y: at + 0.51,
            permanent: Wrench { x: 0.01, p: width, m: 0.013 },
            variable: Wrench { x: -1.37 - 0.1 * at, p: 0.1, m: 0.2 },
            ..StackBody::of(width, width * (width * width + 1.0) / 12.0)
        }
    });
    let joints = (0..count).map(|place| {
        let (half, friction) = (1.5 - 0.15 * place as f64, 0.61 + 0.01 * place as f64);
        Joint { h: place as f64, l: 0.011 - half, r: half, mu_s: friction, mu_k: friction }
    });
    Stack { bodies: bodies.collect(), joints: joints.collect(), shaking: Shaking::default() }
}

/// All combinations of a stack under the full load: ten a joint.
#[divan::bench(args = [1, 2, 3, 4, 5, 6])]
fn combinations_of_a_stack(bencher: Bencher, count: usize) {
    let stack = stack(count);
    bencher
        .counter(ItemsCount::new(10_usize.pow(count as u32)))
        .bench(|| black_box(&stack).answer(1.0).unwrap());
}

/// Where a stack leaves rest, and all combinations just beyond.
#[divan::bench(args = [1, 2, 3, 4, 5, 6])]
fn departure_of_a_stack(bencher: Bencher, count: usize) {
    let stack = stack(count);
    bencher.bench(|| black_box(&stack).departure().unwrap());
}

/// The load path of a caisson on 3 MPa.
#[divan::bench]
fn crush_path(bencher: Bencher) {
    let block = Block::uniform(0.8, 0.6);
    let (weight, push) = (Wrench { x: 0.0, p: 1.0, m: 0.0 }, Wrench { x: -0.728, p: 0.0, m: 0.534 });
    bencher.bench(|| stages(black_box(&block), &weight, &push, 6.07).unwrap());
}

/// Next to boundaries, where the filter fails and exact arithmetic decides.
#[divan::bench]
fn classify_1000_points_on_boundaries(bencher: Bencher) {
    let mut random = Random(2);
    let points: Vec<_> = (0..1000).map(|_| common::Boundary::PointA.point(&mut random)).collect();
    bencher.counter(ItemsCount::new(points.len())).bench(|| {
        for &[gamma, k_prime, k, mu] in black_box(&points) {
            black_box(standfast::classify(gamma, k_prime, k, mu).unwrap());
        }
    });
}

#[divan::bench]
fn batch_of_ten_million(bencher: Bencher) {
    let points = points(10_000_000);
    let column = |i: usize| points.iter().map(|point| point[i]).collect::<Vec<f64>>();
    let [slenderness, elevation, force, friction] = [0, 1, 2, 3].map(column);
    let columns = Columns { gamma: &slenderness, k_prime: &elevation, k: &force, mu: &friction };
    let mut codes = vec![0; points.len()];
    bencher
        .counter(ItemsCount::new(points.len()))
        .bench_local(|| batch::classify(black_box(columns), black_box(&mut codes)).unwrap());
}

#[divan::bench(args = [(1.0, 0.4), (3.0, 0.8), (4.0, -0.55), (1.0, -1.7)])]
fn diagram((slenderness, elevation): (f64, f64)) -> Diagram {
    Diagram::new(black_box(slenderness), black_box(elevation)).unwrap()
}
