//! Cost of a table of cases beside the mechanics it asks for, in one run: `cargo bench -p standfast-tables --bench
//! cases`.
//!
//! Goda's caisson under random waves and with random friction. Each round answers the same rows in turn: by Goda's formulas and the
//! contact problem called from a loop, which is the limit; by [`Sweep`] with all results; by [`Assessment`] of varied inputs, row by
//! row; and as a table, from CSV text to CSV text with all results. One thread; times are those it has had a processor. A number after
//! `--` sets the rows.

use std::fs;
use std::hint::black_box;
use std::time::Instant;

use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::wave::{CaissonSection, Choices, Heights, Sea, goda};
use standfast::{Body, Outcome, Situation};
use standfast_cases::couple::{Variable, vary};
use standfast_cases::results::ResultName;
use standfast_cases::sweep::{Factor, Sweep};
use standfast_cases::{Assessment, Case, CaseFile};
use standfast_tables::{CaseTable, TableOptions, run};

const ROUNDS: usize = 15;

const NAMES: [&str; 4] = ["wave.H13", "wave.Hmax", "wave.period", "body.friction"];

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Wave heights, a period and friction.
fn rows(count: usize) -> Vec<[f64; 4]> {
    let mut random = random();
    let row = |_| {
        let h_13 = 2.0 + 5.0 * random();
        [h_13, h_13 * (1.4 + 0.4 * random()), 6.0 + 10.0 * random(), 0.4 + 0.4 * random()]
    };
    (0..count).map(row).collect()
}

/// Answers the caisson by its formulas, called as one would from a program.
fn direct([h_13, h_max, period, friction]: [f64; 4]) -> Outcome {
    let body = Body::new(15.0, 10.5, 346_050.0).expect("a body");
    let sea = Sea {
        water_depth: 10.1,
        sea_bottom_slope: 0.01,
        period,
        angle_deg: 15.0,
        water_density: 1030.0,
        gravity: 9.81,
    };
    let section = CaissonSection {
        base_depth: 7.1,
        depth_above_berm: 5.6,
        crest_height: 3.4,
        berm_width: 8.0,
        caisson_width: 15.0,
    };
    let heights = Heights::Local { significant: h_13, maximum: h_max };
    let goda = goda(&sea, &heights, &section, &Choices::default()).expect("waves");
    let buoyancy = Action::vertical(&body, -1_076_110.5, 7.5);
    Situation::new(body, friction, 9.81)
        .expect("a situation")
        .with_weight()
        .with(Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, buoyancy))
        .with_all(goda.loads(&body, section.base_depth))
        .outcome()
        .expect("an outcome")
}

/// Seconds this thread has had a processor, or else of the clock: what other programs take does not count.
fn processor(start: Instant) -> f64 {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let time = text.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    time.map_or_else(|| start.elapsed().as_secs_f64(), |nanoseconds| nanoseconds / 1e9)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let count = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(20_000);
    let text = include_str!("../../../examples/goda-2000.toml");
    let text = text.replace("deep_water_height = \"6.3 m\"", "H13 = 5.8\nHmax = 8.05");
    let file = CaseFile::parse("goda.toml", &text).expect("a case file");
    let case = file.case().expect("a case");
    let rows = rows(count);
    let variables = NAMES.map(|name| Variable::find(name, file.inputs()).expect("a number of the case"));
    let factors = NAMES.map(|name| Factor::find(name, None, file.inputs()).expect("a number of the case"));
    let sweep = Sweep::of(&file, factors.into()).expect("a case");
    let results = sweep.results();

    let by_sweep = || {
        let mut scratch = sweep.scratch();
        for row in &rows {
            let answer = sweep.answer(&mut scratch, row).expect("an answer");
            for result in &results {
                black_box(answer.get(*result));
            }
        }
    };
    let by_assessment = || {
        for row in &rows {
            let changes: Vec<_> = variables.iter().zip(row.iter().copied()).collect();
            let case = Case::of(&vary(file.inputs(), &case, &changes)).expect("a case");
            let assessment = Assessment::of(&case).expect("an answer");
            for result in ResultName::ALL {
                black_box(result.of(assessment.governing()));
            }
        }
    };
    let by_formulas = || rows.iter().for_each(|row| drop(black_box(direct(*row))));
    let table: String =
        rows.iter().fold(NAMES.join(",") + "\n", |table, [a, b, c, d]| table + &format!("{a},{b},{c},{d}\n"));
    let options = TableOptions {
        case: Some(CaseTable::of(file.clone()).expect("a case").into()),
        ..TableOptions::new("rows.csv")
    };
    let by_table = || {
        let mut answers = Vec::new();
        run(table.as_bytes(), &mut answers, &options).expect("answers");
        black_box(answers);
    };
    // Rows by all ways have equal outcomes, or the comparison is none.
    for row in &rows[..count.min(1000)] {
        let answer = sweep.answer(&mut sweep.scratch(), row).expect("an answer");
        assert_eq!(answer.governing().outcome, direct(*row));
    }

    let work: [(&str, &dyn Fn()); 4] = [
        ("formulas in a loop", &by_formulas),
        ("sweep, all results", &by_sweep),
        ("assessments", &by_assessment),
        ("table, CSV to CSV", &by_table),
    ];
    let mut times = [const { Vec::new() }; 4];
    for round in 0..ROUNDS {
        for i in (0..work.len()).map(|i| (i + round) % work.len()) {
            let start = Instant::now();
            let before = processor(start);
            work[i].1();
            times[i].push((processor(start) - before) / count as f64);
        }
    }
    println!(
        "{count} rows; µs of processor time a row, median (least) of {ROUNDS} rounds; ratio, median of the rounds"
    );
    for ((name, _), of_work) in work.iter().zip(&times) {
        let ratio = median(of_work.iter().zip(&times[0]).map(|(time, limit)| time / limit).collect());
        let least = of_work.iter().copied().fold(f64::INFINITY, f64::min);
        println!("  {name:<20} {:6.2} ({:.2})  {ratio:.2}", median(of_work.clone()) * 1e6, least * 1e6);
    }
}
