//! Every kernel, and the single call, against exact arithmetic: how many points, how many differences, how many that the kernels leave to
//! exact arithmetic. On all cores; a million points take a third of a second of one.
//!
//! `cargo bench -p standfast --bench agreement -- 1000000000`

#[path = "../tests/common/mod.rs"]
mod common;

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use common::{Boundary, Random};
use standfast::batch::{self, Columns, InstructionSet};

const CHUNK: usize = 1 << 15;

/// Where points are taken from.
type Source = (&'static str, fn(&mut Random) -> [f64; 4]);

const SOURCES: [Source; 5] = [
    ("γ 0.3 to 4, k' −1 to 1, k 0 to 3, μ 0 to 2, uniform", |random| {
        [
            random.uniform(0.3, 4.0),
            random.uniform(-1.0, 1.0),
            random.uniform(0.0, 3.0),
            random.uniform(0.0, 2.0),
        ]
    }),
    ("uniform, log-uniform, small fractions: those of the tests", Random::point),
    ("within three ulps of a boundary", |random| random.pick(&Boundary::ALL).point(random)),
    ("2⁻¹⁰ to 2⁻⁵⁰ of its size from a boundary", |random| {
        let mut point = random.pick(&Boundary::ALL).point(random);
        for _ in 0..2 {
            let distance = 2f64.powi(-10 - (random.bits() % 41) as i32);
            point[random.bits() as usize % 4] *= 1.0 + distance * random.uniform(-1.0, 1.0);
        }
        point
    }),
    ("log-uniform, γ 1e-50 to 1e50, others 1e-300 to 1e50", |random| {
        let k_prime = random.log(1e-300, 1e50) * random.pick(&[-1.0, 1.0]);
        [random.log(1e-50, 1e50), k_prime, random.log(1e-300, 1e50), random.log(1e-300, 1e50)]
    }),
];

#[derive(Default, Clone, Copy)]
struct Tally {
    points: u64,
    different: u64,
    unsure: u64,
}

/// Compares a chunk of points of one source.
fn compare(source: usize, random: &mut Random) -> Tally {
    let points: Vec<[f64; 4]> = (0..CHUNK).map(|_| SOURCES[source].1(random)).collect();
    let [gamma, k_prime, k, mu] =
        [0, 1, 2, 3].map(|i| points.iter().map(|point| point[i]).collect::<Vec<f64>>());
    let columns = Columns { gamma: &gamma, k_prime: &k_prime, k: &k, mu: &mu };
    let mut exact = vec![0; CHUNK];
    batch::exactly(columns, &mut exact);

    let single = |&[gamma, k_prime, k, mu]: &[f64; 4]| standfast::classify(gamma, k_prime, k, mu).unwrap();
    let differs = |index: &usize| single(&points[*index]).code() != exact[*index];
    let mut tally = Tally { points: CHUNK as u64, ..Tally::default() };
    tally.different += (0..CHUNK).filter(differs).count() as u64;
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let mut codes = vec![0; CHUNK];
        batch::screen_with(set, columns, &mut codes);
        let unsure = codes.iter().filter(|code| **code == u8::MAX).count() as u64;
        let differs = |(code, exact): &(&u8, &u8)| **code != u8::MAX && code != exact;
        tally.different += codes.iter().zip(&exact).filter(differs).count() as u64;
        tally.unsure = tally.unsure.max(unsure);
    }
    tally
}

fn main() {
    let count = std::env::args().skip(1).find_map(|argument| argument.parse::<u64>().ok());
    let chunks = count.unwrap_or(10_000_000).div_ceil(CHUNK as u64);
    let (next, tallies) = (AtomicU64::new(0), Mutex::new([Tally::default(); SOURCES.len()]));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let chunk = next.fetch_add(1, Ordering::Relaxed);
                    if chunk >= chunks {
                        break;
                    }
                    let source = chunk as usize % SOURCES.len();
                    let found = compare(source, &mut Random(chunk << 32));
                    let tally = &mut tallies.lock().unwrap()[source];
                    tally.points += found.points;
                    tally.different += found.different;
                    tally.unsure += found.unsure;
                }
            });
        }
    });

    let sets: Vec<_> = InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect();
    println!("the single call and the kernels {sets:?} against exact arithmetic");
    println!("{:>14}{:>12}{:>14}  points", "points", "different", "not sure");
    let tallies = tallies.into_inner().unwrap();
    for ((name, _), Tally { points, different, unsure }) in SOURCES.iter().zip(tallies) {
        println!("{points:>14}{different:>12}{unsure:>14}  {name}");
    }
    assert!(tallies.iter().all(|tally| tally.different == 0));
}
