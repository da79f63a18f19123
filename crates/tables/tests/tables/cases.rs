//! Tables of cases in every format against assessments of the cases they vary.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::num::NonZeroU32;
use std::path::Path;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray};
use arrow_cast::cast;
use arrow_ipc::reader::{FileReader, StreamReader};
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::DataType;
use calamine::{Data, Reader as _, Xlsx};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use standfast_cases::couple::{Variable, vary};
use standfast_cases::results::{ResultKind, ResultName, ResultValue};
use standfast_cases::sweep::SweepResult;
use standfast_cases::units::Dimension;
use standfast_cases::{Assessment, Case, CaseFile};
use standfast_tables::{
    CaseTable, OnError, Summary, TableError, TableFormat, TableHead, TableInput, TableOptions, TableWarning,
    run,
};
use tempfile::TempDir;

const GODA: &str = include_str!("../../../../examples/goda-2000.toml");
const QUAY: &str = include_str!("../../../../examples/quay.toml");
const SHAKEN: &str = include_str!("../../../../examples/seismic-block.toml");

const EXTENSIONS: [&str; 5] = ["csv", "parquet", "arrow", "arrows", "xlsx"];

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Columns that vary a case, each between two values.
struct Table {
    columns: Vec<&'static str>,
    values: Vec<Vec<f64>>,
}

impl Table {
    fn random<const N: usize>(rows: usize, columns: [(&'static str, f64, f64); N]) -> Table {
        let mut random = random();
        let row = |_| columns.iter().map(|(_, from, to)| from + (to - from) * random()).collect();
        Table { values: (0..rows).map(row).collect(), columns: columns.map(|(name, ..)| name).to_vec() }
    }

    fn batch(&self) -> RecordBatch {
        let names = (0..self.values.len()).map(|row| format!("row {row}, \"so\""));
        let names: ArrayRef = Arc::new(StringArray::from_iter_values(names));
        let column = |place: usize| -> ArrayRef {
            Arc::new(self.values.iter().map(|row| Some(row[place])).collect::<Float64Array>())
        };
        let columns = (0..self.columns.len()).map(|place| (self.columns[place], column(place), true));
        RecordBatch::try_from_iter_with_nullable([("name", names, true)].into_iter().chain(columns)).unwrap()
    }

    /// Writes the table in the format of the extension.
    fn write(&self, path: &Path) {
        let batch = self.batch();
        let file = File::create(path).unwrap();
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("parquet") => {
                let mut writer = ArrowWriter::try_new(file, batch.schema(), None).unwrap();
                writer.write(&batch).unwrap();
                writer.close().unwrap();
            }
            Some("arrow") => {
                let mut writer = FileWriter::try_new(file, &batch.schema()).unwrap();
                writer.write(&batch).unwrap();
                writer.finish().unwrap();
            }
            Some("arrows") => {
                let mut writer = StreamWriter::try_new(file, &batch.schema()).unwrap();
                writer.write(&batch).unwrap();
                writer.finish().unwrap();
            }
            Some("xlsx") => {
                let mut workbook = rust_xlsxwriter::Workbook::new();
                let sheet = workbook.add_worksheet();
                sheet
                    .write_row(0, 0, batch.schema().fields().iter().map(|field| field.name().clone()))
                    .unwrap();
                for (row, values) in (1..).zip(&self.values) {
                    sheet
                        .write_string(row, 0, batch.column(0).as_string::<i32>().value(row as usize - 1))
                        .unwrap();
                    sheet.write_row(row, 1, values.iter().copied()).unwrap();
                }
                workbook.save(path).unwrap();
            }
            _ => {
                let mut writer = csv::Writer::from_writer(file);
                writer.write_record(batch.schema().fields().iter().map(|field| field.name())).unwrap();
                for (row, values) in self.values.iter().enumerate() {
                    let name = batch.column(0).as_string::<i32>().value(row).to_owned();
                    let numbers = values.iter().map(|value| format!("{value:?}"));
                    writer.write_record([name].into_iter().chain(numbers)).unwrap();
                }
            }
        }
    }

    /// The answers by [`Assessment`], result by result.
    fn expected(&self, file: &CaseFile) -> Vec<Assessment> {
        let case = file.case().unwrap();
        let variables: Vec<_> =
            self.columns.iter().map(|name| Variable::find(name, file.inputs()).unwrap()).collect();
        let answer = |row: &Vec<f64>| {
            let changes: Vec<_> = variables.iter().zip(row.iter().copied()).collect();
            Assessment::of(&Case::of(&vary(file.inputs(), &case, &changes)).unwrap()).unwrap()
        };
        self.values.iter().map(answer).collect()
    }
}

fn number(x: f64) -> String {
    ryu::Buffer::new().format(x).to_owned()
}

/// A result as it stands in a table.
fn words(value: ResultValue) -> String {
    match value {
        ResultValue::Number(x) => number(x),
        ResultValue::Word(word) => word.to_owned(),
        ResultValue::Truth(truth) => truth.to_string(),
        ResultValue::Modes(modes) => modes.to_string(),
        _ => String::new(),
    }
}

/// A result as it stands in a file of an extension: in CSV and Excel in kN, kPa and mrad.
fn in_file(result: ResultName, value: ResultValue, extension: &str) -> String {
    let flat = matches!(extension, "csv" | "xlsx");
    let dimension = match result.info().kind {
        ResultKind::Number(dimension) => dimension.filter(|_| flat),
        _ => None,
    };
    match (value, dimension) {
        (ResultValue::Number(x), Some(Dimension::Force | Dimension::Moment | Dimension::Pressure)) => {
            number(x / 1e3)
        }
        (ResultValue::Number(x), Some(Dimension::Angle)) => number(x * 1e3),
        (value, _) => words(value),
    }
}

/// True of the heading of a column: its name, which may have a unit behind it.
fn heads(name: &str, column: &str) -> bool {
    name == column || name.strip_prefix(column).is_some_and(|rest| rest.starts_with(" ["))
}

/// A column of a file in any format, as text; nulls are empty.
fn read(path: &Path, column: &str) -> Vec<String> {
    let file = File::open(path).unwrap();
    let batches: Vec<RecordBatch> = match path.extension().and_then(|extension| extension.to_str()) {
        Some("parquet") => {
            let reader = ParquetRecordBatchReaderBuilder::try_new(file).unwrap().build().unwrap();
            reader.collect::<Result<_, _>>().unwrap()
        }
        Some("arrow") => FileReader::try_new(file, None).unwrap().collect::<Result<_, _>>().unwrap(),
        Some("arrows") => StreamReader::try_new(file, None).unwrap().collect::<Result<_, _>>().unwrap(),
        Some("xlsx") => return read_sheet(path, column),
        _ => {
            let mut reader = csv::Reader::from_reader(file);
            let place = reader.headers().unwrap().iter().position(|name| heads(name, column));
            let place = place.unwrap_or_else(|| panic!("no column {column}"));
            return reader.records().map(|record| record.unwrap()[place].to_owned()).collect();
        }
    };
    let texts = batches.iter().flat_map(|batch| {
        let column = batch.column_by_name(column).unwrap_or_else(|| panic!("no column {column}"));
        if let Some(numbers) = column.as_primitive_opt::<Float64Type>() {
            return numbers.iter().map(|x| x.map_or(String::new(), number)).collect();
        }
        let text = cast(column, &DataType::Utf8).unwrap();
        text.as_string::<i32>().iter().map(|text| text.unwrap_or_default().to_owned()).collect::<Vec<_>>()
    });
    texts.collect()
}

fn read_sheet(path: &Path, column: &str) -> Vec<String> {
    let mut workbook: Xlsx<_> = calamine::open_workbook(path).unwrap();
    let range = workbook.worksheet_range_at(0).unwrap().unwrap();
    let mut rows = range.rows();
    let place = rows.next().unwrap().iter().position(|name| heads(&name.to_string(), column));
    let place = place.unwrap_or_else(|| panic!("no column {column}"));
    let text = |cell: &Data| match cell {
        Data::Float(x) => number(*x),
        other => other.to_string(),
    };
    rows.map(|row| text(&row[place])).collect()
}

fn of_case(text: &str) -> Option<Arc<CaseTable>> {
    Some(CaseTable::of(CaseFile::parse("case.toml", text).unwrap()).unwrap().into())
}

fn answer(folder: &TempDir, from: &str, to: &str, options: &TableOptions) -> Result<Summary, TableError> {
    let format = |name: &str| TableFormat::of(Path::new(name), "");
    let options = TableOptions { from: format(from)?, to: format(to)?, ..options.clone() };
    let input = TableInput::File(File::open(folder.path().join(from)).unwrap());
    let mut output = Vec::new();
    let summary = standfast_tables::answer(input, &mut output, &options, &())?;
    fs::write(folder.path().join(to), output).unwrap();
    Ok(summary)
}

/// A case with water and waves, one with combinations and criteria, one that is shaken: whatever the formats of input and output.
#[test]
fn every_row_is_the_assessment_of_its_case() {
    let folder = tempfile::tempdir().unwrap();
    let goda = [
        ("wave.deep_water_height", 3.0, 8.0),
        ("water_level", 6.5, 8.0),
        ("friction", 0.4, 0.8),
        ("width", 10.0, 20.0),
        ("wave.period", 6.0, 16.0),
    ];
    let quay = [("load[1].force", 0.0, 9e5), ("body.friction", 0.2, 0.7), ("load[2].distance", 0.0, 9.0)];
    let shaken = [("body.friction", 0.05, 0.9), ("body.height", 2.0, 30.0), ("body.density", 1e3, 4e3)];
    let tables = [
        (GODA, Table::random(40, goda)),
        (QUAY, Table::random(40, quay)),
        (SHAKEN, Table::random(40, shaken)),
    ];
    for (text, table) in tables {
        let file = CaseFile::parse("case.toml", text).unwrap();
        let expected = table.expected(&file);
        for from in EXTENSIONS {
            let input = format!("in.{from}");
            table.write(&folder.path().join(&input));
            for to in EXTENSIONS {
                let output = format!("out-{from}.{to}");
                let options = TableOptions { case: of_case(text), threads: 2, ..TableOptions::new(&input) };
                let summary = answer(&folder, &input, &output, &options).unwrap();
                assert_eq!((summary.rows, summary.bad), (40, 0), "{output}");
                let read = |column: &str| read(&folder.path().join(&output), column);
                // Those of the ground are there if the case has some.
                let has_ground = file.case().unwrap().ground.is_some();
                let on_plan = file.case().unwrap().plan.is_some();
                for result in ResultName::ALL
                    .iter()
                    .filter(|result| result.asked_by().is_none() && (has_ground || !result.is_of_ground()))
                    .filter(|result| on_plan || !result.is_of_plan())
                {
                    let of_all =
                        expected.iter().map(|answer| in_file(*result, result.of(answer.governing()), to));
                    assert_eq!(read(result.name()), of_all.collect::<Vec<_>>(), "{output} {}", result.name());
                }
                if !file.case().unwrap().criteria.is_empty() {
                    let met = expected.iter().map(|answer| answer.met().unwrap().to_string());
                    assert_eq!(read("met"), met.collect::<Vec<_>>(), "{output}");
                    let check = |answer: &Assessment| answer.checks()[0].check;
                    let names = expected.iter().map(|answer| check(answer).criterion.name().to_owned());
                    assert_eq!(read("criterion"), names.collect::<Vec<_>>(), "{output}");
                    let used = expected.iter().map(|answer| number(check(answer).utilisation.unwrap()));
                    assert_eq!(read("utilisation"), used.collect::<Vec<_>>(), "{output}");
                    let names = expected.iter().map(|answer| answer.name(answer.governing()).unwrap());
                    assert_eq!(read("situation"), names.collect::<Vec<_>>(), "{output}");
                }
                if file.case().unwrap().earthquake.is_some() {
                    let shaken = expected.iter().map(|answer| answer.governing().earthquake.unwrap());
                    let shaken = shaken.map(|earthquake| number(earthquake.horizontal()));
                    assert_eq!(read("earthquake_horizontal"), shaken.collect::<Vec<_>>(), "{output}");
                }
                // Varied columns are carried over as they are.
                for (place, column) in table.columns.iter().enumerate() {
                    let values = read(column).iter().map(|text| text.parse().unwrap()).collect::<Vec<f64>>();
                    assert_eq!(values, table.values.iter().map(|row| row[place]).collect::<Vec<_>>());
                }
                assert_eq!(read("name")[7], "row 7, \"so\"");
            }
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let table = Table::random(9000, [("friction", 0.2, 0.9), ("mass", 300e3, 400e3)]);
    // More rows than a piece of either has.
    for (from, to) in [("csv", &EXTENSIONS[..]), ("parquet", &["csv", "parquet"])] {
        let input = format!("in.{from}");
        table.write(&folder.path().join(&input));
        for to in to {
            let output = |threads| {
                let columns =
                    ["mode", "SF_sliding", "load_factor"].map(|name| SweepResult::find(name).unwrap());
                let file = CaseFile::parse("case.toml", GODA).unwrap();
                let case = CaseTable::of(file).unwrap().with_results(columns.to_vec());
                let options = TableOptions { case: Some(case.into()), threads, ..TableOptions::new(&input) };
                answer(&folder, &input, &format!("out.{to}"), &options).unwrap();
                fs::read(folder.path().join(format!("out.{to}"))).unwrap()
            };
            let one = output(1);
            assert!(one == output(5) && (*to != "csv" || one == output(2)), "{from} to {to}");
        }
    }
}

fn text(
    table: &str,
    case: &str,
    options: impl FnOnce(TableOptions) -> TableOptions,
) -> (String, Result<Summary, TableError>) {
    let mut output = Vec::new();
    let options = options(TableOptions { case: of_case(case), ..TableOptions::new("t.csv") });
    let summary = run(table.as_bytes(), &mut output, &options);
    (String::from_utf8(output).unwrap(), summary)
}

fn error(table: &str) -> String {
    text(table, GODA, |options| options).1.unwrap_err().to_string()
}

#[test]
fn what_is_wrong_with_a_row_is_said_with_its_values() {
    let table = "wave.period,body.height,friction\n11.4,10.5,0.6\n-1,10.5,0.6\n9,10.5,high\n9,10.5,0.6\n";
    assert_eq!(
        error(table),
        "t.csv, line 3, column wave.period: \"-1\": `period` is -1; expected a finite number above zero"
    );
    let null = |options| TableOptions { on_error: OnError::Null, ..options };
    let (answers, summary) = text(table, GODA, null);
    let summary = summary.unwrap();
    assert_eq!((summary.rows, summary.bad), (4, 2));
    let lines: Vec<_> = answers.lines().collect();
    assert!(
        lines[0].ends_with(",problem")
            && lines[1].starts_with("11.4,10.5,0.6,impulsive-breaking,RE,")
            && lines[1].ends_with(',')
    );
    assert!(lines[2].contains(",,,,") && lines[2].ends_with("expected a finite number above zero\""));
    assert!(
        lines[3]
            .ends_with("column friction: \"\"high\"\": it does not begin with a number; expected a number\"")
    );
    // Two numbers that do not go together are both named.
    let apart = "wave.depth_above_berm,wave.period,wave.water_depth\n5,11.4,4\n";
    let said = error(apart);
    assert!(said.starts_with("t.csv, line 2, column wave.depth_above_berm: \"5\""), "{said}");
    assert_eq!(
        error("friction,body.friction\n0.5,0.6\n"),
        "t.csv: the columns friction and body.friction both vary body.friction; expected one of them"
    );
    assert!(error("wave.perod\n9\n").contains("the case has no number `wave.perod`"));
    assert!(error("a,b\n9,1\n").contains("no column that varies the case; its columns are a, b"));
    assert!(error("friction,SF_sliding\n0.5,1\n").contains("already has a column SF_sliding"));
    assert!(
        error("wave.period [m]\n9\n").contains("`wave.period` in `m`: the unit does not fit; expected s")
    );
}

/// Of two numbers that are said to be in one column, none is left out silently; by whichever name the column is called.
#[test]
fn a_column_is_mapped_once() {
    for [table, one, two] in
        [["mu,b\n0.5,15\n", "mu", "mu"], ["mu [-],b\n0.5,15\n", "mu [-]", "mu"], ["b,mu\n15,0.5\n", "b", "b"]]
    {
        let map =
            [format!("friction={one}"), format!("width={two}")].map(|text| text.parse().unwrap()).to_vec();
        let error = text(table, GODA, |options| TableOptions { map, ..options }).1.unwrap_err().to_string();
        let expected = format!(
            "friction and width are both mapped to column {one} of t.csv; expected a column for each"
        );
        assert_eq!(error, expected);
    }
    let map = vec!["friction=mu".parse().unwrap(), "width=b".parse().unwrap()];
    assert_eq!(text("mu,b\n0.5,15\n", GODA, |options| TableOptions { map, ..options }).1.unwrap().rows, 1);
}

/// A unit in the name of a column counts for its plain numbers, and they stay as they are written.
#[test]
fn units_are_those_of_case_files() {
    let folder = tempfile::tempdir().unwrap();
    let table = "wave.deep_water_height [cm],width,period\n633.3,1500 cm,11.4\n6.3 m,15 m,11.4\n";
    fs::write(folder.path().join("in.csv"), table).unwrap();
    let map = vec!["wave.period=period".parse().unwrap()];
    let options = TableOptions { case: of_case(GODA), map, ..TableOptions::new("in.csv") };
    let summary = answer(&folder, "in.csv", "out.parquet", &options).unwrap();
    let varied = summary.varied.unwrap();
    let keys: Vec<_> = varied.columns.iter().map(|column| column.key.as_str()).collect();
    assert_eq!(keys, ["wave.deep_water_height", "body.width", "wave.period"]);
    assert_eq!(varied.notes.len(), 1);
    let read = |column: &str| read(&folder.path().join("out.parquet"), column);
    assert_eq!(read("wave.deep_water_height [cm]"), ["633.3", "630.0"]);
    assert_eq!(read("width"), ["15.0", "15.0"]);
    let columns = vec!["wave.deep_water_height", "width", "wave.period"];
    let values = vec![vec![633.3 / 100.0, 15.0, 11.4], vec![6.3, 15.0, 11.4]];
    let expected = Table { columns, values }.expected(&CaseFile::parse("case.toml", GODA).unwrap());
    let sliding = expected.iter().map(|answer| words(ResultName::SfSliding.of(answer.governing())));
    assert_eq!(read("SF_sliding"), sliding.collect::<Vec<_>>());
    // Units of results stand in the metadata.
    let file = File::open(folder.path().join("out.parquet")).unwrap();
    let schema = ParquetRecordBatchReaderBuilder::try_new(file).unwrap().schema().clone();
    let unit = |column: &str| schema.field_with_name(column).unwrap().metadata().get("unit").cloned();
    assert_eq!((unit("bearing_max").as_deref(), unit("SF_sliding")), (Some("Pa"), None));
}

/// A peak period beside the file's own varies nothing.
#[test]
fn a_column_by_another_name_is_warned_about() {
    for (column, key) in [("Tp", "wave.period"), ("h0", "wave.deep_water_height")] {
        let (_, summary) = text(&format!("friction,{column}\n0.5,6\n"), GODA, |options| options);
        let warnings = summary.unwrap().varied.unwrap().warnings;
        let [warning @ TableWarning::ColumnLikeKey { .. }] = &warnings[..] else { panic!("{warnings:?}") };
        assert!(warning.to_string().contains(&format!("--map \"{key}={column}\"")), "{warning}");
    }
    let (_, summary) = text("friction,Hs\n0.5,4\n", GODA, |options| options);
    let warnings = summary.unwrap().varied.unwrap().warnings;
    let [TableWarning::ColumnLikeAbsentKey { key, .. }] = &warnings[..] else { panic!("{warnings:?}") };
    assert_eq!(key, "wave.H13");
}

#[test]
fn a_column_that_may_be_meant_is_warned_about() {
    let (_, summary) = text("friction,deep_water_height,id\n0.5,6,1\n", GODA, |options| options);
    let warnings = summary.unwrap().varied.unwrap().warnings;
    let [warning @ TableWarning::ColumnLikeKey { .. }] = &warnings[..] else { panic!("{warnings:?}") };
    assert_eq!(warning.name(), "column-like-key");
    assert!(warning.to_string().contains("--map \"wave.deep_water_height=deep_water_height\""));
}

/// Cells as an office with decimal commas writes them.
#[test]
fn a_decimal_comma_is_read_and_one_of_thousands_is_not() {
    let points = "name,body.width [m],wave.period\nall,15.25,\"12.5 s\"\n";
    let commas = "name,body.width [m],wave.period\nall,\"15,25\",\"12,5 s\"\n";
    let answer = |table: &str| text(table, GODA, |options| options);
    let results = |table: &str| {
        let (found, summary) = answer(table);
        assert_eq!(summary.unwrap().rows, 1);
        found.split_once(" s\"").or(found.split_once(" s,")).unwrap().1.trim_start_matches(',').to_owned()
    };
    assert_eq!(results(commas), results(points));
    // Three digits after a comma may be thousands.
    let error = answer(&commas.replace("15,25", "15,250")).1.unwrap_err().to_string();
    assert!(error.contains("15.25") && error.contains("15250"), "{error}");
}

/// A table as an office makes it: titles with quotation marks of their own, the names, their units.
#[test]
fn titles_stand_above_and_units_below_the_names() {
    let head = |row: Option<u32>, has_units| TableHead { row: row.and_then(NonZeroU32::new), has_units };
    let plain = "name,body.width [cm],body.friction,wave.period [s]\na,1500,0.6,11\nb,1600,0.5,\"12.5\"\n";
    let office = "Harbour of X, pipe 5\" wide\r\n\r\nname,body.width,body.friction,wave.period\r\n,cm,-,(s)\r\na,1500,0.6,11\r\nb,1600,0.5,\"12.5\"\r\n";
    let answer = |table: &str, head| text(table, GODA, |options| TableOptions { head, ..options });
    let (expected, summary) = answer(plain, TableHead::default());
    summary.unwrap();
    let (found, summary) = answer(office, head(Some(3), true));
    assert_eq!(summary.unwrap().rows, 2);
    assert_eq!(found.replace("\r\n", "\n"), expected);
    // A row that makes no sense is told by the line it stands on.
    let wrong = office.replace("1600", "wide");
    let error = answer(&wrong, head(Some(3), true)).1.unwrap_err().to_string();
    assert!(error.contains("line 6") && error.contains("\"wide\""), "{error}");
    // Where nothing is said the first line has the names.
    let (found, summary) = answer(plain, head(Some(1), false));
    summary.unwrap();
    assert_eq!(found, expected);
    assert!(answer(office, TableHead::default()).1.is_err());
    for (table, head, words) in [
        (plain, head(Some(9), false), "has no row 9 with the names"),
        ("body.width\n", head(None, true), "has no row of units"),
        ("body.width [mm]\nm\n15\n", head(None, true), "the column body.width [mm] has m below its name"),
    ] {
        let error = answer(table, head).1.unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
    // A unit that does not fit is named with its column.
    let error = answer(&office.replace(",cm,", ",kPa,"), head(Some(3), true)).1.unwrap_err().to_string();
    assert!(error.contains("body.width") && error.contains("kPa"), "{error}");
}

/// The same table in a sheet, which may begin anywhere.
#[test]
fn a_sheet_has_titles_and_units() {
    let folder = tempfile::tempdir().unwrap();
    let mut workbook = rust_xlsxwriter::Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.write_string(0, 0, "Harbour of X").unwrap();
    sheet.write_string(1, 4, "drawn by N. N.").unwrap();
    sheet.write_row(3, 1, ["body.width", "body.friction", "wave.period"]).unwrap();
    sheet.write_row(4, 1, ["cm", "-", "s"]).unwrap();
    sheet.write_row(5, 1, [1500.0, 0.6, 11.0]).unwrap();
    sheet.write_row(6, 1, [1600.0, 0.5, 12.5]).unwrap();
    workbook.save(folder.path().join("in.xlsx")).unwrap();
    let head = TableHead { row: NonZeroU32::new(4), has_units: true };
    let options = TableOptions { case: of_case(GODA), head, ..TableOptions::new("in.xlsx") };
    answer(&folder, "in.xlsx", "out.csv", &options).unwrap();
    let plain = "body.width [cm],body.friction,wave.period [s]\n1500,0.6,11\n1600,0.5,12.5\n";
    fs::write(folder.path().join("in.csv"), plain).unwrap();
    let options = TableOptions { head: TableHead::default(), ..options };
    answer(&folder, "in.csv", "expected.csv", &options).unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let cells = |text: &str| {
        text.lines().map(|line| line.split(',').skip(3).collect::<Vec<_>>().join(",")).collect::<Vec<_>>()
    };
    assert_eq!(cells(&read("out.csv")), cells(&read("expected.csv")));
    assert!(read("out.csv").starts_with("body.width [cm],body.friction,wave.period [s],"));
    let empty =
        TableOptions { head: TableHead { row: NonZeroU32::new(3), has_units: false }, ..options.clone() };
    let error = answer(&folder, "in.xlsx", "out.csv", &empty).unwrap_err().to_string();
    assert!(error.contains("row 3"), "{error}");
    answer(&folder, "in.csv", "in.parquet", &options).unwrap();
    let options = TableOptions { head: TableHead { row: NonZeroU32::new(4), has_units: false }, ..options };
    let error = answer(&folder, "in.parquet", "out.csv", &options).unwrap_err().to_string();
    assert!(error.starts_with("--header-row: "), "{error}");
}

/// In CSV and Excel a heading has the unit, that of [output] where there is one; what programs read stays SI.
#[test]
fn headings_have_the_units_of_the_answers() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("in.csv"), "body.width [m]\n15\n14\n").unwrap();
    let header = |case: &str, to: &str| {
        let options = TableOptions { case: of_case(case), ..TableOptions::new("in.csv") };
        answer(&folder, "in.csv", to, &options).unwrap();
        fs::read_to_string(folder.path().join(to)).unwrap_or_default()
    };
    let plain = header(GODA, "out.csv");
    for heading in ["bearing_max [kPa]", "P [kN/m]", "M_p [kN m/m]", "eccentricity [m]", "SF_sliding", "mode"]
    {
        assert!(plain.lines().next().unwrap().split(',').any(|name| name == heading), "{heading}: {plain}");
    }
    let other = header(
        &format!("{GODA}\n[output]\nforce = \"kip/ft\"\npressure = \"ksf\"\nlength = \"ft\"\n"),
        "out.csv",
    );
    let column = |table: &str, heading: &str| -> Vec<f64> {
        let mut lines = table.lines();
        let place = lines.next().unwrap().split(',').position(|name| name == heading).unwrap();
        lines.map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect()
    };
    for (metric, feet, size) in [
        ("P [kN/m]", "P [kip/ft]", 14.593_902_937_206_36),
        ("M_p [kN m/m]", "M_p [kip ft/ft]", 4.448_221_615_260_5),
        ("bearing_max [kPa]", "bearing_max [ksf]", 47.880_258_980_336),
        ("eccentricity [m]", "eccentricity [ft]", 0.3048),
    ] {
        for (one, two) in column(&plain, metric).iter().zip(column(&other, feet)) {
            assert!((one / two / size - 1.0).abs() < 1e-12, "{metric}: {one} {two}");
        }
    }
    // A table that was answered has its columns.
    fs::write(folder.path().join("in.csv"), &plain).unwrap();
    let options = TableOptions { case: of_case(GODA), ..TableOptions::new("in.csv") };
    let error = answer(&folder, "in.csv", "out.csv", &options).unwrap_err().to_string();
    assert!(error.contains("warnings") || error.contains("mode"), "{error}");
}

/// Without columns asked for the program writes what matters.
#[test]
fn what_matters_is_what_happens_and_what_is_asked() {
    let file = CaseFile::parse("case.toml", QUAY).unwrap();
    let case = CaseTable::of(file).unwrap().with_what_matters();
    let options = TableOptions { case: Some(case.into()), ..TableOptions::new("in.csv") };
    let mut output = Vec::new();
    run("body.friction\n0.5\n".as_bytes(), &mut output, &options).unwrap();
    let text = String::from_utf8(output).unwrap();
    let names: Vec<_> = text.lines().next().unwrap().split(',').skip(1).collect();
    assert!(names.len() < 20 && names.contains(&"mode") && names.contains(&"SF_sliding"), "{names:?}");
    assert!(names.contains(&"met") && !names.iter().any(|name| name.starts_with("margin_")), "{names:?}");
}

/// The worst row of each criterion, found again one row after the other; however the table is cut into pieces.
#[test]
fn the_worst_row_of_each_criterion_is_told() {
    let table = Table::random(300, [("body.friction", 0.2, 0.7), ("load[1].force", 0.0, 9e5)]);
    let file = CaseFile::parse("case.toml", QUAY).unwrap();
    let answers = table.expected(&file);
    let folder = tempfile::tempdir().unwrap();
    table.write(&folder.path().join("in.parquet"));
    for (to, threads) in [("out.csv", 1), ("out.parquet", 3), ("out.xlsx", 2)] {
        let options = TableOptions { case: of_case(QUAY), threads, ..TableOptions::new("in.parquet") };
        let summary = answer(&folder, "in.parquet", to, &options).unwrap();
        assert!(!summary.worst.is_empty());
        for worst in &summary.worst {
            let of_row = |answer: &Assessment| {
                let checks = answer.checks().into_iter().map(|check| check.check);
                checks
                    .filter(|check| check.criterion.name() == worst.criterion)
                    .map(|check| (check.urgency(), check.met))
                    .fold((f64::NEG_INFINITY, true), |(urgency, met), (more, is_met)| {
                        (urgency.max(more), met && is_met)
                    })
            };
            let rows: Vec<_> = answers.iter().map(of_row).collect();
            let greatest = rows.iter().map(|row| row.0).fold(f64::NEG_INFINITY, f64::max);
            let place = rows.iter().position(|row| row.0 == greatest).unwrap();
            assert_eq!((worst.row, worst.rows), (place as u64, 300), "{worst:?}");
            assert_eq!(worst.unmet, rows.iter().filter(|row| !row.1).count() as u64, "{worst:?}");
        }
    }
}

/// Behind the table a workbook has the worst rows and what it was answered with; numbers are shown in a few digits.
#[test]
fn a_workbook_says_what_it_was_answered_with() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("in.csv"), "body.friction\n0.5\n0.3\n").unwrap();
    let program = Some("standfast 9.9.9".to_owned());
    let options = TableOptions { case: of_case(QUAY), program, ..TableOptions::new("in.csv") };
    let summary = answer(&folder, "in.csv", "out.xlsx", &options).unwrap();
    let mut workbook: Xlsx<_> = calamine::open_workbook(folder.path().join("out.xlsx")).unwrap();
    let names = calamine::Reader::sheet_names(&workbook);
    assert_eq!(names[1..], ["summary", "inputs"]);
    let mut sheet = |name: &str| -> Vec<Vec<String>> {
        let range = calamine::Reader::worksheet_range(&mut workbook, name).unwrap();
        range.rows().map(|row| row.iter().map(ToString::to_string).collect()).collect()
    };
    let worst = sheet("summary");
    assert_eq!(worst.len(), 1 + summary.worst.len());
    for (row, told) in worst[1..].iter().zip(&summary.worst) {
        // Rows of the sheet: the first is the header.
        assert_eq!(
            [&row[0], &row[1], &row[6]],
            [told.criterion, &told.required, &(told.row + 2).to_string()]
        );
    }
    let inputs = sheet("inputs");
    assert!(inputs.iter().any(|row| row[1] == "standfast 9.9.9"));
    for line in QUAY.lines().filter(|line| !line.trim().is_empty()) {
        assert!(inputs.iter().any(|row| row[1] == line), "{line}");
    }
    // The table is read again as a table.
    let again = TableOptions { case: of_case(QUAY), ..TableOptions::new("out.xlsx") };
    assert!(
        answer(&folder, "out.xlsx", "again.csv", &again).unwrap_err().to_string().contains("has a column")
    );
}

/// Semicolons and decimal commas, as spreadsheets of many countries write them: the same numbers, written the same way.
#[test]
fn semicolons_and_decimal_commas_are_read_and_written() {
    let points = "note,body.width [m],wave.period\n\"a;b\",15.5,11.25\n\"two\nlines\",14,\"12.5 s\"\n";
    let commas = "note;body.width [m];wave.period\n\"a;b\";15,5;11,25\n\"two\nlines\";14;\"12,5 s\"\n";
    let tabs = points.replace(',', "\t");
    let [plain, other, tabbed] = [points, commas, &tabs].map(|table| {
        let (text, summary) = text(table, GODA, |options| options);
        assert_eq!(summary.unwrap().rows, 2, "{text}");
        text
    });
    let cells = |text: &str, delimiter: u8| -> Vec<Vec<String>> {
        let mut reader =
            csv::ReaderBuilder::new().delimiter(delimiter).has_headers(false).from_reader(text.as_bytes());
        reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
    };
    let [plain, other, tabbed] = [cells(&plain, b','), cells(&other, b';'), cells(&tabbed, b'\t')];
    assert_eq!(plain, tabbed);
    for (row, other) in plain.iter().zip(&other).skip(1) {
        for (cell, other) in row.iter().zip(other).skip(3) {
            let is_number = cell.parse::<f64>().is_ok();
            assert_eq!(if is_number { cell.replace('.', ",") } else { cell.clone() }, *other);
        }
    }
    // A decimal point beside semicolons stays one.
    let (written, _) = text("body.width [m];wave.period\n15.5;11\n", GODA, |options| options);
    assert!(
        written.lines().nth(1).unwrap().contains(';') && !written.lines().nth(1).unwrap().contains(','),
        "{written}"
    );
    // Three digits behind a comma may be thousands.
    let error =
        text("body.width [m];wave.period\n15,250;11\n", GODA, |options| options).1.unwrap_err().to_string();
    assert!(error.contains("15.25") && error.contains("15250"), "{error}");
}

/// A formula whose value no program has kept is told as such, and not as an empty cell.
#[test]
fn a_formula_without_its_value_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut workbook = rust_xlsxwriter::Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.write_row(0, 0, ["body.width", "body.friction"]).unwrap();
    sheet.write_row(1, 0, [15.0, 0.5]).unwrap();
    sheet.write_number(2, 1, 0.5).unwrap();
    sheet.write_formula(2, 0, rust_xlsxwriter::Formula::new("=A2+1").set_result("16")).unwrap();
    let kept = workbook.save_to_buffer().unwrap();
    // The same workbook as a program writes it that does not calculate: the formula, and no value.
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(&kept)).unwrap();
    let mut written = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).unwrap();
        let mut text = String::new();
        file.read_to_string(&mut text).unwrap();
        written
            .start_file(file.name().unwrap().to_string(), zip::write::SimpleFileOptions::default())
            .unwrap();
        written.write_all(text.replace("<v>16</v>", "").as_bytes()).unwrap();
    }
    fs::write(folder.path().join("in.xlsx"), written.finish().unwrap().into_inner()).unwrap();
    fs::write(folder.path().join("kept.xlsx"), &kept).unwrap();
    let options = TableOptions { case: of_case(GODA), ..TableOptions::new("in.xlsx") };
    let error = answer(&folder, "in.xlsx", "out.csv", &options).unwrap_err().to_string();
    assert!(error.contains("row 3") && error.contains("a formula without its value"), "{error}");
    assert_eq!(answer(&folder, "kept.xlsx", "out.csv", &options).unwrap().rows, 2);
}
