//! The batch kernels against the limit: a loop that only reads the same four columns and writes one byte a point,
//! compiled for the same instruction set. All run in turn, round by round; of times and of ratios within a round the medians are printed.
//! Columns of limit states are compared with a loop that reads the same and writes a number a point, and with `batch::onset`.
//! A column ω of zeros is compared in the same way with the rigid kernel: `batch::classify_on_base` with `batch::classify`.
//!
//! `cargo bench -p standfast --bench memory_limit`

#![allow(unsafe_code, reason = "calls loops compiled for a detected instruction set, as the library does")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;

use common::{Boundary, Random};
use standfast::batch::{self, Columns, InstructionSet, LimitColumn, OnsetColumns};
use standfast::initiation::LimitState;

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
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
fn limit_avx512(columns: Columns<'_>, codes: &mut [u8]) {
    read_and_write(columns, codes);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
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

/// Seconds that this thread has had of a processor; where that is not told, of the clock.
fn seconds() -> f64 {
    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    {
        unsafe extern "C" {
            fn clock_gettime(clock: i32, time: *mut [i64; 2]) -> i32;
        }
        const THREAD: i32 = 3;
        let mut time = [0; 2];
        // SAFETY: a timespec is two 64-bit numbers there, seconds and nanoseconds.
        let failed = unsafe { clock_gettime(THREAD, &raw mut time) };
        assert_eq!(failed, 0);
        time[0] as f64 + time[1] as f64 * 1e-9
    }
    #[cfg(not(all(target_os = "linux", target_pointer_width = "64")))]
    {
        use std::sync::LazyLock;
        static START: LazyLock<std::time::Instant> = LazyLock::new(std::time::Instant::now);
        START.elapsed().as_secs_f64()
    }
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Four columns of points.
struct Points([Vec<f64>; 4]);

impl Points {
    fn of(mut point: impl FnMut() -> [f64; 4]) -> Points {
        let mut columns = [const { Vec::new() }; 4];
        for _ in 0..POINTS {
            columns.iter_mut().zip(point()).for_each(|(column, value)| column.push(value));
        }
        Points(columns)
    }

    fn columns(&self) -> Columns<'_> {
        let [gamma, k_prime, k, mu] = &self.0;
        Columns { gamma, k_prime, k, mu }
    }
}

fn main() {
    let mut random = Random(1);
    let ordinary = Points::of(|| {
        [
            random.uniform(0.3, 4.0),
            random.uniform(-1.0, 1.0),
            random.uniform(0.0, 3.0),
            random.uniform(0.0, 2.0),
        ]
    });
    // What a search for a boundary asks for: too near for f32.
    let near = Points::of(|| {
        let mut point = random.pick(&Boundary::ALL[1..5]).point(&mut random);
        point[3] *= 1.0 + random.uniform(-1e-8, 1e-8);
        point
    });

    type Work<'a> = Box<dyn Fn(&mut [u8]) + 'a>;
    let (ordinary, near) = (ordinary.columns(), near.columns());
    let mut rows: Vec<(String, InstructionSet, Work)> = Vec::new();
    let mut best = InstructionSet::Baseline;
    for set in [InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512] {
        if !set.is_available() {
            println!("this processor has no {set:?}");
            continue;
        }
        best = set;
        for (name, columns) in [("", ordinary), (", near boundaries", near)] {
            let screen = move |codes: &mut [u8]| batch::screen_with(set, columns, codes);
            rows.push((format!("{set:?} kernel{name}"), set, Box::new(screen)));
        }
    }
    let classify = |codes: &mut [u8]| batch::classify(ordinary, codes).unwrap();
    rows.push(("batch::classify, exact".to_owned(), best, Box::new(classify)));

    let mut codes = vec![0; POINTS];
    let mut time = |work: &dyn Fn(&mut [u8])| {
        let start = seconds();
        work(black_box(&mut codes));
        (seconds() - start) * 1e9 / POINTS as f64
    };
    let mut times = vec![(Vec::new(), Vec::new(), Vec::new()); rows.len()];
    for _ in 0..ROUNDS {
        for ((_, set, work), (kernels, limits, ratios)) in rows.iter().zip(&mut times) {
            let kernel = time(work);
            let limit = time(&|codes| limit(*set, black_box(ordinary), codes));
            kernels.push(kernel);
            limits.push(limit);
            ratios.push(kernel / limit);
        }
    }
    // A base that gives nothing, by the kernel for bases that crush, beside the rigid one.
    let omega = vec![0.0; POINTS];
    let (mut on_base, mut rigid, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let one = time(&|codes| batch::classify_on_base(ordinary, black_box(&omega), codes).unwrap());
        let other = time(&|codes| batch::classify(black_box(ordinary), codes).unwrap());
        on_base.push(one);
        rigid.push(other);
        ratios.push(one / other);
    }
    println!("{POINTS} points, one thread, medians of {ROUNDS} rounds, ns of processor time a point");
    println!("{:<34}{:>8}{:>8}{:>8}", "", "kernel", "limit", "ratio");
    for ((name, ..), (kernels, limits, ratios)) in rows.iter().zip(times) {
        println!("{name:<34}{:>8.3}{:>8.3}{:>8.2}", median(kernels), median(limits), median(ratios));
    }
    println!("{:<34}{:>8}{:>8}{:>8}", "", "ω = 0", "rigid", "ratio");
    let [on_base, rigid, ratio] = [on_base, rigid, ratios].map(median);
    println!("{:<34}{on_base:>8.3}{rigid:>8.3}{ratio:>8.2}", "batch::classify_on_base");
    of_limit_states(ordinary);
}

/// Points that stay in the cache.
const FEW: usize = 4096;

fn part(Columns { gamma, k_prime, k, mu }: Columns<'_>, length: usize) -> Columns<'_> {
    Columns { gamma: &gamma[..length], k_prime: &k_prime[..length], k: &k[..length], mu: &mu[..length] }
}

/// Columns of numbers.
type Numbers = Vec<Vec<f64>>;

/// The columns of these limit states.
fn limit_columns<'a>(asked: &[LimitState], values: &'a mut Numbers, length: usize) -> Vec<LimitColumn<'a>> {
    let columns = asked.iter().zip(values);
    columns.map(|(state, values)| LimitColumn { state: *state, values: &mut values[..length] }).collect()
}

/// Limit states on every instruction set, of points that stay in the cache, so that nothing but the kernel counts; then of all points,
/// beside loops that read and write as much, and all of them beside all columns of an onset.
fn of_limit_states(columns: Columns<'_>) {
    let mut values = vec![vec![0.0; POINTS]; LimitState::ALL.len()];
    let since = |start: f64, points: usize| (seconds() - start) * 1e9 / points as f64;
    let sets: Vec<_> = InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect();
    println!("limit states of points in the cache, on {sets:?}");
    let all = LimitState::ALL.to_vec();
    for asked in LimitState::ALL.map(|state| vec![state]).iter().chain([&all]) {
        let times = sets.iter().map(|set| {
            let rounds = (0..ROUNDS).map(|_| {
                let start = seconds();
                for _ in 0..200 {
                    let mut out = limit_columns(asked, &mut values, FEW);
                    batch::limit_states_with(*set, black_box(part(columns, FEW)), &mut out).unwrap();
                }
                since(start, 200 * FEW)
            });
            format!("{:>8.2}", median(rounds.collect()))
        });
        let name = if asked.len() == 1 { asked[0].name() } else { "all" };
        println!("{name:<34}{}", times.collect::<String>());
    }

    println!("{:<34}{:>8}{:>8}{:>8}", "", "kernel", "limit", "ratio");
    for asked in [vec![LimitState::Slide], vec![LimitState::SlipOLeft], all.clone()] {
        let (mut kernels, mut limits, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            let start = seconds();
            batch::limit_states(black_box(columns), &mut limit_columns(&asked, &mut values, POINTS)).unwrap();
            let kernel = since(start, POINTS);
            let start = seconds();
            for block in (0..POINTS).step_by(FEW) {
                let end = POINTS.min(block + FEW);
                for values in &mut values[..asked.len()] {
                    let Columns { gamma, k_prime, k, mu } = black_box(columns);
                    for i in block..end {
                        values[i] = gamma[i] + k_prime[i] + k[i] + mu[i];
                    }
                }
            }
            let limit = since(start, POINTS);
            kernels.push(kernel);
            limits.push(limit);
            ratios.push(kernel / limit);
        }
        let name = if asked.len() == 1 { asked[0].name() } else { "all limit states" };
        println!("{name:<34}{:>8.2}{:>8.2}{:>8.2}", median(kernels), median(limits), median(ratios));
    }

    let (mut limits, mut onsets, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    let (mut modes, mut unique, mut others) = (vec![0; POINTS], vec![false; POINTS], vec![0; POINTS]);
    for _ in 0..ROUNDS {
        let start = seconds();
        batch::limit_states(black_box(columns), &mut limit_columns(&all, &mut values, POINTS)).unwrap();
        let limit = since(start, POINTS);
        let start = seconds();
        let mut motion = values.iter_mut().map(|column| Some(&mut column[..]));
        let out = OnsetColumns {
            mode: Some(&mut modes),
            unique: Some(&mut unique),
            others: Some(&mut others),
            motion: std::array::from_fn(|_| {
                motion.next().expect("more limit states than numbers of a motion")
            }),
            mirrored: false,
        };
        batch::onset(black_box(columns), out).unwrap();
        let onset = since(start, POINTS);
        limits.push(limit);
        onsets.push(onset);
        ratios.push(limit / onset);
    }
    let [limit, onset, ratio] = [limits, onsets, ratios].map(median);
    println!("all limit states {limit:.1}, all of an onset {onset:.1}, ratio {ratio:.2}");
}
