//! Cost of computing beside reading and writing a table, in one run: `cargo bench -p standfast-tables --features
//! columnar --bench files`.
//!
//! Ten million random points in Parquet, as pandas writes it (Snappy, row groups of 2²⁰ rows). Each round runs, in turn,
//! what `standfast batch --columns mode` runs; the same with the modes given, so that the same bytes are read and written and
//! nothing is computed; and, for comparison, the table read and written again by the Parquet library alone. A number after
//! `--` sets the rows.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use standfast::batch::{Columns, classify};
use standfast_tables::{ResultColumn, TableFormat, TableInput, TableOptions, answer};

const ROUNDS: usize = 9;

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn properties() -> Option<WriterProperties> {
    Some(WriterProperties::builder().set_compression(Compression::SNAPPY).build())
}

/// Writes a table of random points, and gives their modes.
fn prepare(path: &Path, rows: usize) -> Arc<[u8]> {
    let mut random = random();
    let mut codes = Vec::with_capacity(rows);
    let mut writer = None;
    while codes.len() < rows {
        let length = (rows - codes.len()).min(1 << 20);
        let [mut gamma, mut k_prime, mut k, mut mu]: [Vec<f64>; 4] = Default::default();
        for _ in 0..length {
            gamma.push(10_f64.powf(2.0 * random() - 1.0));
            k_prime.push(2.0 * random() - 1.0);
            k.push(3.0 * random());
            mu.push(2.0 * random());
        }
        let start = codes.len();
        codes.resize(start + length, 0);
        let columns = Columns { gamma: &gamma, k_prime: &k_prime, k: &k, mu: &mu };
        classify(columns, &mut codes[start..]).expect("points");
        let columns = [("gamma", gamma), ("k_prime", k_prime), ("k", k), ("mu", mu)];
        let columns = columns.map(|(name, column)| (name, Arc::new(Float64Array::from(column)) as ArrayRef));
        let batch = RecordBatch::try_from_iter(columns).expect("a batch");
        let writer = writer.get_or_insert_with(|| {
            let file = File::create(path).expect("a file");
            ArrowWriter::try_new(file, batch.schema(), properties()).expect("a writer")
        });
        writer.write(&batch).expect("written");
    }
    writer.expect("there are rows").close().expect("written");
    codes.into()
}

/// Reads all columns and writes them again.
fn rewrite(input: &Path, output: &Path) {
    let reader =
        ParquetRecordBatchReaderBuilder::try_new(File::open(input).expect("a file")).expect("Parquet");
    let reader = reader.with_batch_size(1 << 16).build().expect("Parquet");
    let file = File::create(output).expect("a file");
    let mut writer =
        ArrowWriter::try_new(file, arrow_array::RecordBatchReader::schema(&reader), properties())
            .expect("a writer");
    for batch in reader {
        writer.write(&batch.expect("a batch")).expect("written");
    }
    writer.close().expect("written");
}

/// Seconds this thread has had a processor, where the system tells: what other programs take does not count.
fn processor() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split_whitespace().next()?.parse::<f64>().ok()? / 1e9)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let rows = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(10_000_000);
    let folder = tempfile::tempdir().expect("a folder");
    let (input, output) = (folder.path().join("in.parquet"), folder.path().join("out.parquet"));
    let modes = prepare(&input, rows);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    println!(
        "{rows} rows, {} MB; median (least) of {ROUNDS} rounds in s",
        fs::metadata(&input).expect("a file").len() / 1_000_000
    );
    for threads in [1, cores] {
        let options = TableOptions {
            from: TableFormat::Parquet,
            to: TableFormat::Parquet,
            columns: vec![ResultColumn::Mode],
            threads,
            ..TableOptions::new("in.parquet")
        };
        let without = TableOptions { known_modes: Some(modes.clone()), ..options.clone() };
        let run = |options: &TableOptions| {
            let table = TableInput::File(File::open(&input).expect("a file"));
            let output = BufWriter::with_capacity(1 << 18, File::create(&output).expect("a file"));
            answer(table, output, options, &()).expect("answered");
        };
        let work: [(&str, &dyn Fn()); 3] = [
            ("mode", &|| run(&options)),
            ("the same without computing", &|| run(&without)),
            ("the library reads and writes all", &|| rewrite(&input, &output)),
        ];
        // Both ways write equal bytes, or the comparison is none.
        let written = [0, 1].map(|i| {
            work[i].1();
            fs::read(&output).expect("a file")
        });
        assert!(written[0] == written[1]);
        let mut times = [const { Vec::new() }; 3];
        let mut worked = [const { Vec::new() }; 3];
        for round in 0..ROUNDS {
            // Each comes first as often as the others, and none has to remove what another wrote.
            for i in (0..work.len()).map(|i| (i + round) % work.len()) {
                fs::remove_file(&output).expect("removed");
                let (_, work) = work[i];
                let (start, before) = (Instant::now(), processor());
                work();
                times[i].push(start.elapsed().as_secs_f64());
                worked[i].extend(before.zip(processor()).map(|(before, after)| after - before));
            }
        }
        let pairs = times[0].iter().zip(&times[1]).map(|(with, without)| with / without);
        let ratio = median(pairs.collect());
        println!("\n{threads} threads");
        for ((name, _), times) in work.iter().zip(times) {
            let least = times.iter().copied().fold(f64::INFINITY, f64::min);
            println!("  {name:<34} {:6.3} ({least:.3})", median(times));
        }
        println!("  ratio with to without computing, median of the rounds: {ratio:.3}");
        if threads == 1 && !worked[0].is_empty() {
            let worked = worked.map(median);
            println!(
                "  processor time: {:.3}, {:.3}, {:.3}; ratio {:.3}",
                worked[0],
                worked[1],
                worked[2],
                worked[0] / worked[1]
            );
        }
    }
}
