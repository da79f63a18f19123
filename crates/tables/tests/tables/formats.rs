//! Tables in every format against scalar calls of the library, and files that are not what they should be.

use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, Int32Type};
use arrow_array::{
    ArrayRef, BooleanArray, DictionaryArray, Float32Array, Float64Array, Int32Array, Int64Array,
    LargeStringArray, RecordBatch, StringArray, StringViewArray,
};
use arrow_cast::cast;
use arrow_ipc::reader::{FileReader, StreamReader};
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::{DataType, Schema};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::{Compression, ZstdLevel};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use standfast::Point;
use standfast_tables::{
    Mapping, OnError, ResultColumn, Summary, TableError, TableFormat, TableInput, TableOptions, run,
};
use tempfile::TempDir;

const EXTENSIONS: [&str; 4] = ["csv", "parquet", "arrow", "arrows"];

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Columns γ, k', k and μ of random points, in which all modes occur.
fn columns(rows: usize) -> [Vec<f64>; 4] {
    let mut random = random();
    let mut columns: [Vec<f64>; 4] = Default::default();
    for _ in 0..rows {
        columns[0].push(10_f64.powf(2.0 * random() - 1.0));
        columns[1].push(3.0 * random() - 1.8);
        columns[2].push(6.0 * random());
        columns[3].push(4.0 * random());
    }
    columns
}

fn table<const N: usize>(columns: [(&str, ArrayRef); N]) -> RecordBatch {
    RecordBatch::try_from_iter_with_nullable(columns.map(|(name, column)| (name, column, true)))
        .expect("a table")
}

fn points(rows: usize) -> RecordBatch {
    let [gamma, k_prime, k, mu] =
        columns(rows).map(|column| Arc::new(Float64Array::from(column)) as ArrayRef);
    let names = Arc::new(StringArray::from_iter_values((0..rows).map(|row| format!("row {row}, \"so\""))));
    table([("name", names), ("mu", mu), ("k_prime", k_prime), ("gamma", gamma), ("k", k)])
}

/// Writes a table in the format of the extension; Parquet and Arrow in pieces of 700 rows.
fn write(path: &Path, table: &RecordBatch) {
    let file = File::create(path).expect("a file");
    let pieces: Vec<RecordBatch> = (0..table.num_rows().div_ceil(700))
        .map(|piece| table.slice(piece * 700, 700.min(table.num_rows() - piece * 700)))
        .collect();
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("parquet") => {
            let properties =
                WriterProperties::builder().set_compression(Compression::ZSTD(ZstdLevel::default()));
            let mut writer =
                ArrowWriter::try_new(file, table.schema(), Some(properties.build())).expect("a writer");
            for piece in pieces {
                writer.write(&piece).expect("written");
                writer.flush().expect("a row group");
            }
            writer.append_key_value_metadata(KeyValue::new("origin".to_owned(), "a test".to_owned()));
            writer.close().expect("written");
        }
        Some("arrow") => {
            let mut writer = FileWriter::try_new(file, &table.schema()).expect("a writer");
            pieces.iter().for_each(|piece| writer.write(piece).expect("written"));
            writer.finish().expect("written");
        }
        Some("arrows") => {
            let mut writer = StreamWriter::try_new(file, &table.schema()).expect("a writer");
            pieces.iter().for_each(|piece| writer.write(piece).expect("written"));
            writer.finish().expect("written");
        }
        _ => {
            let mut writer = csv::Writer::from_writer(file);
            writer.write_record(table.schema().fields().iter().map(|field| field.name())).expect("written");
            let texts: Vec<ArrayRef> =
                table.columns().iter().map(|column| cast(column, &DataType::Utf8).expect("text")).collect();
            for row in 0..table.num_rows() {
                writer
                    .write_record(texts.iter().map(|text| text.as_string::<i32>().value(row)))
                    .expect("written");
            }
        }
    }
}

/// A column of a file in any format, as text; nulls are empty.
fn read(path: &Path, column: &str) -> Vec<String> {
    let file = File::open(path).expect("a file");
    let batches: Vec<RecordBatch> = match path.extension().and_then(|extension| extension.to_str()) {
        Some("parquet") => {
            let reader =
                ParquetRecordBatchReaderBuilder::try_new(file).expect("Parquet").build().expect("Parquet");
            reader.collect::<Result<_, _>>().expect("Parquet")
        }
        Some("arrow") => {
            FileReader::try_new(file, None).expect("Arrow").collect::<Result<_, _>>().expect("Arrow")
        }
        Some("arrows") => {
            StreamReader::try_new(file, None).expect("Arrow").collect::<Result<_, _>>().expect("Arrow")
        }
        _ => {
            let mut reader = csv::Reader::from_reader(file);
            let place = reader.headers().expect("a header").iter().position(|name| name == column);
            let place = place.unwrap_or_else(|| panic!("no column {column}"));
            return reader.records().map(|record| record.expect("a row")[place].to_owned()).collect();
        }
    };
    let texts = batches.iter().flat_map(|batch| {
        let column = batch.column_by_name(column).unwrap_or_else(|| panic!("no column {column}"));
        if let Some(numbers) = column.as_primitive_opt::<Float64Type>() {
            return numbers
                .iter()
                .map(|x| x.map_or(String::new(), |x| ryu::Buffer::new().format(x).to_owned()))
                .collect();
        }
        let text = cast(column, &DataType::Utf8).expect("text");
        text.as_string::<i32>().iter().map(|text| text.unwrap_or_default().to_owned()).collect::<Vec<_>>()
    });
    texts.collect()
}

fn options(name: &str) -> TableOptions {
    TableOptions { threads: 3, ..TableOptions::new(name) }
}

fn answer(folder: &TempDir, from: &str, to: &str, options: &TableOptions) -> Result<Summary, TableError> {
    let format = |name: &str| TableFormat::of(Path::new(name), "");
    let options = TableOptions { from: format(from)?, to: format(to)?, ..options.clone() };
    let input = TableInput::File(File::open(folder.path().join(from)).expect("a file"));
    let mut output = Vec::new();
    let summary = standfast_tables::answer(input, &mut output, &options, &())?;
    fs::write(folder.path().join(to), output).expect("written");
    Ok(summary)
}

#[test]
fn every_format_gives_the_answers_of_scalar_calls() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = 3000;
    let table = points(rows);
    let [gamma, k_prime, k, mu] = columns(rows);
    let point = |i: usize| Point::new(gamma[i], k_prime[i], k[i], mu[i]).expect("a point");
    let expected = |value: fn(Point) -> String| (0..rows).map(|i| value(point(i))).collect::<Vec<_>>();
    let number = |x: f64| ryu::Buffer::new().format(x).to_owned();
    let (modes, unique) = (expected(|p| p.mode().to_string()), expected(|p| p.is_unique().to_string()));
    let also = expected(|p| p.others().to_string());
    let numbers: [(&str, Vec<String>); 6] = [
        ("x_ddot", (0..rows).map(|i| number(point(i).motion().x_ddot)).collect()),
        ("y_ddot", (0..rows).map(|i| number(point(i).motion().y_ddot)).collect()),
        ("theta_ddot", (0..rows).map(|i| number(point(i).motion().theta_ddot)).collect()),
        ("f_x", (0..rows).map(|i| number(point(i).motion().f_x)).collect()),
        ("f_y", (0..rows).map(|i| number(point(i).motion().f_y)).collect()),
        ("xi", (0..rows).map(|i| number(point(i).motion().xi)).collect()),
    ];
    assert!(also.iter().any(|also| also.contains(' ')));
    for from in EXTENSIONS {
        let input = format!("points.{from}");
        write(&folder.path().join(&input), &table);
        for to in EXTENSIONS {
            let output = format!("from-{from}.{to}");
            let summary = answer(&folder, &input, &output, &options(&input)).expect("answered");
            assert_eq!((summary.rows, summary.bad), (rows as u64, 0), "{output}");
            let read = |column: &str| read(&folder.path().join(&output), column);
            assert_eq!(read("mode"), modes, "{output}");
            assert_eq!(read("unique"), unique, "{output}");
            assert_eq!(read("also"), also, "{output}");
            for (column, expected) in &numbers {
                assert_eq!(read(column), *expected, "{output}: {column}");
            }
            assert_eq!(read("name"), texts(&table, "name"), "{output}");
            let gamma: Vec<f64> = read("gamma").iter().map(|text| text.parse().expect("a number")).collect();
            assert_eq!(gamma, columns(rows)[0], "{output}");
        }
    }
}

fn texts(table: &RecordBatch, column: &str) -> Vec<String> {
    let column = table.column_by_name(column).expect("a column").as_string::<i32>();
    column.iter().map(|text| text.unwrap_or_default().to_owned()).collect()
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    // Several pieces, also of text.
    let rows = 20_000;
    let some = [ResultColumn::Mode, ResultColumn::XDdot, ResultColumn::Also];
    for from in EXTENSIONS {
        let input = format!("points.{from}");
        write(&folder.path().join(&input), &points(rows));
        for to in EXTENSIONS {
            let output = |threads: usize| {
                let options = TableOptions { threads, columns: some.to_vec(), ..TableOptions::new(&input) };
                let output = format!("answer.{to}");
                answer(&folder, &input, &output, &options).expect("answered");
                fs::read(folder.path().join(output)).expect("a file")
            };
            let one = output(1);
            assert!(output(2) == one && output(7) == one, "{from} to {to}");
        }
    }
}

#[test]
fn numbers_of_any_kind_are_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let dictionary: DictionaryArray<Int8Type> =
        DictionaryArray::new(vec![0_i8, 1, 0].into(), Arc::new(Float64Array::from(vec![0.5, 5.0])));
    let labels: DictionaryArray<Int32Type> = ["a", "b", "a"].into_iter().collect();
    let kinds: [ArrayRef; 4] = [
        Arc::new(Int32Array::from(vec![2, 2, 2])),
        Arc::new(Int64Array::from(vec![2, 2, 2])),
        Arc::new(Float32Array::from(vec![2.0, 2.0, 2.0])),
        Arc::new(LargeStringArray::from(vec![" 2", "2.0", "2e0"])),
    ];
    for (i, k) in kinds.into_iter().enumerate() {
        let table = table([
            ("gamma", Arc::new(Int32Array::from(vec![1, 1, 1]))),
            ("k_prime", Arc::new(Float32Array::from(vec![1.0, 1.0, 1.0]))),
            ("k", k),
            ("mu", Arc::new(dictionary.clone())),
            ("label", Arc::new(labels.clone())),
            ("long", Arc::new(LargeStringArray::from(vec!["x", "y", "z"]))),
            ("view", Arc::new(StringViewArray::from(vec!["1", "a text of more than twelve bytes", "3"]))),
        ]);
        for from in ["parquet", "arrow", "arrows"] {
            let input = format!("kinds-{i}.{from}");
            write(&folder.path().join(&input), &table);
            for to in EXTENSIONS {
                let output = format!("answer.{to}");
                answer(&folder, &input, &output, &options(&input))
                    .unwrap_or_else(|error| panic!("{input}: {error}"));
                let read = |column: &str| read(&folder.path().join(&output), column);
                let expected =
                    [0.5, 5.0, 0.5].map(|mu| Point::new(1.0, 1.0, 2.0, mu).unwrap().mode().to_string());
                assert_eq!(read("mode"), expected, "{input} to {to}");
                assert_eq!(read("label"), ["a", "b", "a"], "{input} to {to}");
                assert_eq!(read("view")[1], "a text of more than twelve bytes");
            }
        }
    }
}

#[test]
fn a_row_without_sense_is_named_with_its_value() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = 2000;
    let [gamma, k_prime, k, mu] = columns(rows);
    let broken = |value: Option<f64>| {
        let mut mu: Vec<Option<f64>> = mu.iter().copied().map(Some).collect();
        (mu[1500], mu[1700]) = (value, value);
        let column = |values: &[f64]| -> ArrayRef { Arc::new(Float64Array::from(values.to_vec())) };
        let mu = Arc::new(Float64Array::from(mu));
        table([("gamma", column(&gamma)), ("k_prime", column(&k_prime)), ("k", column(&k)), ("friction", mu)])
    };
    let map = vec!["mu=friction".parse::<Mapping>().expect("a mapping")];
    let wrong = [
        (Some(-0.5), "row 1501, column friction: \"-0.5\"; expected a number from 0 to 1e50"),
        (None, "row 1501, column friction: null; expected a number"),
        (Some(f64::NAN), "row 1501, column friction: \"NaN\"; expected a number from 0 to 1e50"),
    ];
    for (value, problem) in wrong {
        for from in ["parquet", "arrow", "arrows"] {
            let input = format!("points.{from}");
            write(&folder.path().join(&input), &broken(value));
            for columns in [vec![], vec![ResultColumn::Mode]] {
                let options = TableOptions { map: map.clone(), columns, ..options(&input) };
                for to in EXTENSIONS {
                    let output = format!("answer.{to}");
                    let error = answer(&folder, &input, &output, &options).expect_err("a wrong row");
                    assert_eq!(error.to_string(), format!("{input}, {problem}"));
                    assert!(!folder.path().join(&output).exists());

                    let options = TableOptions { on_error: OnError::Null, ..options.clone() };
                    let summary = answer(&folder, &input, &output, &options).expect("answered");
                    assert_eq!((summary.rows, summary.bad), (rows as u64, 2));
                    assert_eq!(summary.first.expect("a row").to_string(), format!("{input}, {problem}"));
                    let modes = read(&folder.path().join(&output), "mode");
                    for (row, mode) in modes.iter().enumerate() {
                        let point = Point::new(gamma[row], k_prime[row], k[row], mu[row]).expect("a point");
                        let expected = if [1500, 1700].contains(&row) { "" } else { point.mode().symbol() };
                        assert_eq!(mode, expected, "{output}, row {row}");
                    }
                    fs::remove_file(folder.path().join(&output)).expect("removed");
                }
            }
        }
    }
}

#[test]
fn from_parquet_to_parquet_the_columns_stay_as_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    write(&folder.path().join("in.parquet"), &points(2000));
    answer(&folder, "in.parquet", "out.parquet", &options("in.parquet")).expect("answered");
    let open = |name: &str| {
        ParquetRecordBatchReaderBuilder::try_new(File::open(folder.path().join(name)).expect("a file"))
            .expect("Parquet")
    };
    let (input, output) = (open("in.parquet"), open("out.parquet"));
    let groups = |file: &ParquetRecordBatchReaderBuilder<File>| file.metadata().row_groups().to_vec();
    assert_eq!(groups(&output).iter().map(|group| group.num_rows()).collect::<Vec<_>>(), [700, 700, 600]);
    let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a file");
    let (in_bytes, out_bytes) = (bytes("in.parquet"), bytes("out.parquet"));
    for (before, after) in groups(&input).iter().zip(groups(&output)) {
        assert_eq!(after.num_columns(), 5 + 9);
        for (before, after) in before.columns().iter().zip(after.columns()) {
            let part = |(start, length): (u64, u64)| start as usize..(start + length) as usize;
            assert!(in_bytes[part(before.byte_range())] == out_bytes[part(after.byte_range())]);
            assert_eq!(before.statistics(), after.statistics());
            assert_eq!(before.compression(), after.compression());
        }
        // Results are compressed as the table is.
        assert_eq!(after.column(5).compression(), before.column(0).compression());
    }
    let metadata = output.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default();
    assert!(metadata.contains(&KeyValue::new("origin".to_owned(), "a test".to_owned())));
    assert_eq!(metadata.iter().filter(|entry| entry.key == "ARROW:schema").count(), 1);
}

/// As pandas writes it.
#[test]
fn a_parquet_file_may_have_no_page_index() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = points(1000);
    let properties = WriterProperties::builder()
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_max_row_group_row_count(Some(400));
    let file = File::create(folder.path().join("in.parquet")).expect("a file");
    let mut writer = ArrowWriter::try_new(file, table.schema(), Some(properties.build())).expect("a writer");
    writer.write(&table).expect("written");
    writer.close().expect("written");
    answer(&folder, "in.parquet", "out.parquet", &options("in.parquet")).expect("answered");
    write(&folder.path().join("in.csv"), &table);
    answer(&folder, "in.csv", "out.csv", &options("in.csv")).expect("answered");
    for column in ["mode", "also", "xi", "name"] {
        let read = |name: &str| read(&folder.path().join(name), column);
        assert_eq!(read("out.parquet"), read("out.csv"), "{column}");
    }
}

#[test]
fn a_huge_row_group_is_divided() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = (1 << 21) + 1;
    let columns = columns(1000).map(|column| -> ArrayRef {
        Arc::new(Float64Array::from_iter_values(column.iter().copied().cycle().take(rows)))
    });
    let [gamma, k_prime, k, mu] = columns;
    let table = table([("gamma", gamma), ("k_prime", k_prime), ("k", k), ("mu", mu)]);
    let properties = WriterProperties::builder().set_max_row_group_row_count(Some(rows)).build();
    let file = File::create(folder.path().join("in.parquet")).expect("a file");
    let mut writer = ArrowWriter::try_new(file, table.schema(), Some(properties)).expect("a writer");
    writer.write(&table).expect("written");
    writer.close().expect("written");
    let options = TableOptions { columns: vec![ResultColumn::Mode], ..options("in.parquet") };
    answer(&folder, "in.parquet", "out.parquet", &options).expect("answered");
    let file = File::open(folder.path().join("out.parquet")).expect("a file");
    let output = ParquetRecordBatchReaderBuilder::try_new(file).expect("Parquet");
    assert_eq!(output.metadata().num_row_groups(), 17);
    let modes = read(&folder.path().join("out.parquet"), "mode");
    assert_eq!(modes.len(), rows);
    assert!(modes.chunks(1000).all(|chunk| chunk == &modes[..chunk.len()]));
}

#[test]
fn tables_without_rows_or_columns() {
    let folder = tempfile::tempdir().expect("a folder");
    for from in EXTENSIONS {
        let input = format!("empty.{from}");
        write(&folder.path().join(&input), &points(0));
        for to in EXTENSIONS {
            let output = format!("answer.{to}");
            assert_eq!(answer(&folder, &input, &output, &options(&input)).expect("answered").rows, 0);
            assert!(read(&folder.path().join(&output), "xi").is_empty());
        }
        if from != "csv" {
            write(&folder.path().join(&input), &RecordBatch::new_empty(Arc::new(Schema::empty())));
            let error = answer(&folder, &input, "answer.csv", &options(&input)).expect_err("no columns");
            assert_eq!(error.to_string(), format!("{input} has no column gamma; it has no columns"));
        }
    }
}

#[test]
fn columns_of_another_type_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let one = || -> ArrayRef { Arc::new(Float64Array::from(vec![1.0])) };
    let flag = Arc::new(BooleanArray::from(vec![true]));
    write(
        &folder.path().join("flag.parquet"),
        &table([("gamma", one()), ("k_prime", one()), ("k", one()), ("mu", flag)]),
    );
    let error = answer(&folder, "flag.parquet", "out.csv", &options("flag.parquet")).expect_err("refused");
    assert_eq!(error.to_string(), "flag.parquet, column mu: holds true and false; expected numbers");

    let list: ArrayRef =
        Arc::new(arrow_array::ListArray::from_iter_primitive::<Float64Type, _, _>([Some([Some(1.0)])]));
    let table = table([("gamma", one()), ("k_prime", one()), ("k", one()), ("mu", one()), ("waves", list)]);
    write(&folder.path().join("list.parquet"), &table);
    let error = answer(&folder, "list.parquet", "out.csv", &options("list.parquet")).expect_err("refused");
    assert_eq!(error.to_string(), "list.parquet, column waves: holds lists, for which CSV has no place");
    answer(&folder, "list.parquet", "out.parquet", &options("list.parquet")).expect("Parquet has a place");
}

/// A damaged file is refused in words, or read; nothing panics.
#[test]
fn damaged_files_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = random();
    for from in ["parquet", "arrow", "arrows"] {
        let path = folder.path().join(format!("points.{from}"));
        write(&path, &points(1500));
        let whole = fs::read(&path).expect("a file");
        let format = match from {
            "parquet" => TableFormat::Parquet,
            "arrow" => TableFormat::Arrow,
            _ => TableFormat::Arrows,
        };
        let attempt = |bytes: &[u8]| {
            let options = TableOptions { from: format, ..options("points") };
            run(bytes, std::io::sink(), &options).map_err(|error| standfast_cases::report(&error))
        };
        for i in 0..40 {
            let cut = attempt(&whole[..whole.len() * i / 40]);
            // A stream that ends between two batches is whole.
            if from != "arrows" {
                let words = cut.expect_err("cut off");
                assert!(words.contains("cannot read points: not a whole"), "{words}");
            }
        }
        for _ in 0..200 {
            let mut bytes = whole.clone();
            let place = (random() * bytes.len() as f64) as usize;
            bytes[place] ^= 1 << (random() * 8.0) as u32;
            if let Err(words) = attempt(&bytes) {
                assert!(words.contains("points"), "{words}");
            }
        }
    }
}

/// Variable by which the memory test tells the process that answers a table where it lies.
const TABLES: &str = "STANDFAST_TEST_TABLES";

/// Three times the rows need no more memory.
#[cfg(target_os = "linux")]
#[test]
fn memory_does_not_grow_with_the_table() {
    if let Some(folder) = std::env::var_os(TABLES) {
        let file = |name: &str| Path::new(&folder).join(name);
        let (from, to) = (TableFormat::Parquet, TableFormat::Parquet);
        let options = TableOptions { from, to, threads: 2, ..TableOptions::new("in.parquet") };
        let input = TableInput::File(File::open(file("in.parquet")).expect("a file"));
        let output = BufWriter::new(File::create(file("out.parquet")).expect("a file"));
        standfast_tables::answer(input, output, &options, &()).expect("answered");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let peak = |rows: usize| {
        let file = File::create(folder.path().join("in.parquet")).expect("a file");
        let table = points(100_000);
        let mut writer = ArrowWriter::try_new(file, table.schema(), None).expect("a writer");
        for _ in 0..rows / 100_000 {
            writer.write(&table).expect("written");
            writer.flush().expect("a row group");
        }
        writer.close().expect("written");
        // This test again, as a process of its own whose memory can be measured.
        let mut child = Command::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "formats::memory_does_not_grow_with_the_table", "--quiet"])
            .env(TABLES, folder.path())
            .stdout(Stdio::null())
            .spawn()
            .expect("this program starts");
        let mut peak = 0;
        while child.try_wait().expect("a child").is_none() {
            let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
            let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse().ok());
            peak = peak.max(kilobytes.unwrap_or(0));
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        assert!(child.wait().expect("an end").success());
        let output = File::open(folder.path().join("out.parquet")).expect("a file");
        let output = ParquetRecordBatchReaderBuilder::try_new(output).expect("Parquet");
        assert_eq!(output.metadata().file_metadata().num_rows(), rows as i64);
        peak
    };
    // All results of 600 000 rows are 34 MB, and their copies as much again.
    let (small, large): (u64, u64) = (peak(200_000), peak(800_000));
    assert!(small > 10_000 && large < small + 25_000, "{small} kB, then {large} kB");
}
