//! The batch kernel against the limit: a loop that only reads the same four columns and writes one byte a point,
//! compiled for the same instruction set. Both run in turn; the ratio of their medians is printed.
//!
//! `cargo bench -p standfast --bench memory_limit`

#![allow(unsafe_code, reason = "calls loops compiled for a detected instruction set, as the library does")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::Instant;

use common::Random;
use standfast::batch::{self, Columns, InstructionSet};

const POINTS: usize = 10_000_000;
const ROUNDS: usize = 15;

#[inline(always)]
fn read_and_write(columns: Columns<'_>, codes: &mut [u8]) {
    let Columns { gamma, k_prime, k, mu } = columns;
    let points = gamma.iter().zip(k_prime).zip(k).zip(mu);
    for (code, (((a, b), c), d)) in codes.iter_mut().zip(points) {
        *code = u8::from(a + b + c + d > 3.0);
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,fma")]
fn limit_avx512(columns: Columns<'_>, codes: &mut [u8]) {
    read_and_write(columns, codes);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn limit_avx2(columns: Columns<'_>, codes: &mut [u8]) {
    read_and_write(columns, codes);
}

/// The limit loop for `set`, which has to be available.
fn limit(set: InstructionSet, columns: Columns<'_>, codes: &mut [u8]) {
    match set {
        // SAFETY: the caller has checked that the processor has the set.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 => unsafe { limit_avx512(columns, codes) },
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 => unsafe { limit_avx2(columns, codes) },
        _ => read_and_write(columns, codes),
    }
}

/// Nanoseconds a point.
fn time(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9 / POINTS as f64
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let mut random = Random(1);
    let mut column = |low, high| (0..POINTS).map(|_| random.uniform(low, high)).collect::<Vec<f64>>();
    let (slenderness, elevation) = (column(0.3, 4.0), column(-1.0, 1.0));
    let (force, friction) = (column(0.0, 3.0), column(0.0, 2.0));
    let columns = Columns { gamma: &slenderness, k_prime: &elevation, k: &force, mu: &friction };
    let mut codes = vec![0; POINTS];

    println!("{POINTS} points, one thread, medians of {ROUNDS} rounds, ns a point");
    println!("{:<34}{:>8}{:>8}{:>8}", "", "kernel", "limit", "ratio");
    let mut row = |name: &str, limit_set: InstructionSet, kernel: &dyn Fn(&mut [u8])| {
        let mut times = [Vec::new(), Vec::new()];
        for _ in 0..ROUNDS {
            times[0].push(time(|| kernel(black_box(&mut codes))));
            times[1].push(time(|| limit(limit_set, black_box(columns), black_box(&mut codes))));
        }
        let [kernel, limit] = times.map(median);
        println!("{name:<34}{kernel:>8.3}{limit:>8.3}{:>8.2}", kernel / limit);
    };
    let mut best = InstructionSet::Baseline;
    for set in [InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512] {
        if !set.is_available() {
            println!("{:<34} not on this processor", format!("{set:?} kernel"));
            continue;
        }
        best = set;
        row(&format!("{set:?} kernel"), set, &|codes| {
            batch::screen_with(set, columns, codes);
        });
    }
    row("batch::classify, exact", best, &|codes| batch::classify(columns, codes).unwrap());
}
