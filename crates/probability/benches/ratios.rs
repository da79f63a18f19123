//! Time of plain Monte Carlo beside drawing its numbers alone, and of an integral beside as many digits of points:
//! ratios of one run.
//!
//!     cargo bench -p standfast-probability

use std::hint::black_box;
use std::time::Instant;

use standfast_probability::integrate::{Within, integrate};
use standfast_probability::law::Law;
use standfast_probability::problem::{Outcomes, Pieces, RandomVector};
use standfast_probability::sample::{Effort, draws, monte_carlo, sobol};

/// The first number is below the second.
struct Less;

impl Outcomes for Less {
    fn count(&self) -> usize {
        1
    }
    fn line(&self) -> usize {
        0
    }
    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        pieces.push(f64::NEG_INFINITY, values[1], 0);
    }
    fn at(&self, values: &[f64]) -> u64 {
        u64::from(values[0] < values[1])
    }
}

/// The least of several runs, s.
fn least(times: usize, mut work: impl FnMut()) -> f64 {
    let run = |_| {
        let begin = Instant::now();
        work();
        begin.elapsed().as_secs_f64()
    };
    (0..times).map(run).fold(f64::INFINITY, f64::min)
}

fn main() {
    let inputs = RandomVector::independent(vec![
        Law::normal(0.6, 0.1).expect("a law").into(),
        Law::normal(0.45, 0.12).expect("a law").into(),
    ]);
    let count = 1u64 << 22;
    let effort = Effort { threads: 1, precision: 1e-9, floor: 0.0, points: count, ..Effort::default() };
    let alone = least(5, || {
        let mut sum = 0.0;
        draws(&inputs, 1, count, |values| sum += values[0] + values[1]);
        black_box(sum);
    });
    let mut taken = 0;
    let counted = least(5, || taken = black_box(monte_carlo(&inputs, &Less, &[1], &effort)).points);
    let each = |seconds: f64, n: u64| 1e9 * seconds / n as f64;
    println!("two normals drawn alone      {:8.1} ns a sample", each(alone, count));
    println!("plain Monte Carlo            {:8.1} ns a sample", each(counted, taken));
    println!("    over drawing alone       {:8.2}", each(counted, taken) / each(alone, count));
    let integral = least(50, || drop(black_box(integrate(&inputs, &Less, &[1], Within::ALL_DIGITS))));
    println!("integral to all digits       {:8.1} µs", 1e6 * integral);
    let points = Effort { points: 1 << 16, ..effort };
    let mut used = 0;
    let sampled = least(5, || used = black_box(sobol(&inputs, &Less, &[1], &points)).points);
    println!("Sobol' points                {:8.1} ns a point", each(sampled, used));
}
