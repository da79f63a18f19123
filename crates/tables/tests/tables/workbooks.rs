//! Workbooks that are not as plain as what we write: dates, formulas, errors, several sheets, too many rows.

use std::fs;
use std::path::Path;

use calamine::{Data, Reader, Xlsx};
use rust_xlsxwriter::{ExcelDateTime, Format, Formula, Workbook};
use standfast_tables::{OnError, Summary, TableError, TableFormat, TableInput, TableOptions};
use tempfile::TempDir;

fn answer(folder: &TempDir, from: &str, to: &str, options: TableOptions) -> Result<Summary, TableError> {
    let format = |name: &str| TableFormat::of(Path::new(name), "");
    let options = TableOptions { from: format(from)?, to: format(to)?, ..options };
    let input = TableInput::File(fs::File::open(folder.path().join(from)).unwrap());
    let mut output = Vec::new();
    let summary = standfast_tables::answer(input, &mut output, &options, &())?;
    fs::write(folder.path().join(to), output).unwrap();
    Ok(summary)
}

fn cells(folder: &TempDir, name: &str) -> Vec<Vec<Data>> {
    let mut workbook: Xlsx<_> = calamine::open_workbook(folder.path().join(name)).unwrap();
    let range = workbook.worksheet_range_at(0).unwrap().unwrap();
    range.rows().map(<[Data]>::to_vec).collect()
}

/// A sheet of points below two empty rows, with all kinds of cells beside them; another sheet comes first.
fn workbook(folder: &TempDir) {
    let mut workbook = Workbook::new();
    workbook.add_worksheet().set_name("Notes").unwrap().write_string(0, 0, "not a table").unwrap();
    let sheet = workbook.add_worksheet().set_name("Points").unwrap();
    let header = ["gamma", "k_prime", "k", "mu", "day", "time", "done", "count", "mixed"];
    sheet.write_row(2, 1, header).unwrap();
    let day = Format::new().set_num_format("yyyy-mm-dd");
    let time = Format::new().set_num_format("yyyy-mm-dd hh:mm");
    for row in 0..3_u32 {
        let at = 3 + row;
        sheet.write_row(at, 1, [1.0, 1.0]).unwrap();
        // Results of formulas are what the workbook keeps.
        sheet.write_formula(at, 3, Formula::new("=1+1").set_result("2")).unwrap();
        sheet.write_number(at, 4, 5.0).unwrap();
        let date = ExcelDateTime::from_ymd(2026, 2, 27 + u8::try_from(row).unwrap() % 2).unwrap();
        sheet.write_with_format(at, 5, &date, &day).unwrap();
        let moment = ExcelDateTime::from_ymd(1987, 1, 31).unwrap().and_hms(13, 30, 0).unwrap();
        sheet.write_with_format(at, 6, &moment, &time).unwrap();
        sheet.write_boolean(at, 7, row == 1).unwrap();
        sheet.write_number(at, 8, f64::from(row)).unwrap();
    }
    sheet.write_string(3, 9, "a, \"b\"").unwrap();
    sheet.write_number(4, 9, 0.1).unwrap();
    workbook.save(folder.path().join("in.xlsx")).unwrap();
}

fn options() -> TableOptions {
    TableOptions { sheet: Some("Points".to_owned()), ..TableOptions::new("in.xlsx") }
}

#[test]
fn cells_keep_their_kind() {
    let folder = tempfile::tempdir().unwrap();
    workbook(&folder);
    answer(&folder, "in.xlsx", "out.csv", options()).unwrap();
    let text = fs::read_to_string(folder.path().join("out.csv")).unwrap();
    let lines: Vec<_> = text.lines().collect();
    let results = "RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0";
    assert_eq!(
        lines[1],
        format!("1,1,2,5,2026-02-27,1987-01-31T13:30:00,false,0,\"a, \"\"b\"\"\",{results}")
    );
    assert_eq!(lines[2], format!("1,1,2,5,2026-02-28,1987-01-31T13:30:00,true,1,0.1,{results}"));
    assert_eq!(lines[3], format!("1,1,2,5,2026-02-27,1987-01-31T13:30:00,false,2,,{results}"));

    answer(&folder, "in.xlsx", "out.xlsx", options()).unwrap();
    let rows = cells(&folder, "out.xlsx");
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[0][9], Data::String("mode".to_owned()));
    let Data::DateTime(day) = rows[2][4] else { panic!("{:?}", rows[2][4]) };
    assert_eq!(day.to_ymd_hms_milli(), (2026, 2, 28, 0, 0, 0, 0));
    let Data::DateTime(moment) = rows[1][5] else { panic!("{:?}", rows[1][5]) };
    assert_eq!(moment.to_ymd_hms_milli(), (1987, 1, 31, 13, 30, 0, 0));
    assert_eq!((&rows[2][6], &rows[3][7]), (&Data::Bool(true), &Data::Float(2.0)));
    assert_eq!((&rows[1][8], &rows[3][8]), (&Data::String("a, \"b\"".to_owned()), &Data::Empty));
    assert_eq!((&rows[1][9], &rows[1][10]), (&Data::String("RO".to_owned()), &Data::Bool(true)));
    assert_eq!(rows[1][12], Data::Float(-1.125));
}

#[test]
fn what_is_wrong_is_said_with_its_place_in_the_sheet() {
    let folder = tempfile::tempdir().unwrap();
    workbook(&folder);
    let failed = |options| answer(&folder, "in.xlsx", "out.csv", options).unwrap_err().to_string();
    assert_eq!(
        failed(TableOptions { sheet: Some("Storms".to_owned()), ..options() }),
        "in.xlsx has no sheet \"Storms\""
    );
    assert!(failed(TableOptions { sheet: None, ..options() }).contains("in.xlsx has no column gamma"));

    let write = |cell: fn(&mut rust_xlsxwriter::Worksheet)| {
        let mut workbook = Workbook::new();
        let sheet = workbook.add_worksheet().set_name("Points").unwrap();
        sheet.write_row(2, 0, ["gamma", "k_prime", "k", "mu"]).unwrap();
        for row in 3..6 {
            sheet.write_row(row, 0, [1.0, 1.0, 2.0, 5.0]).unwrap();
        }
        cell(sheet);
        workbook.save(folder.path().join("in.xlsx")).unwrap();
    };
    write(|sheet| {
        sheet.write_formula(4, 3, Formula::new("=NA()").set_result("#N/A")).unwrap();
    });
    let said = "in.xlsx, row 5 of the sheet, column mu: \"#N/A\"; expected a number";
    assert_eq!(failed(options()), said);
    let null = TableOptions { on_error: OnError::Null, ..options() };
    let summary = answer(&folder, "in.xlsx", "out.csv", null).unwrap();
    assert_eq!((summary.rows, summary.bad), (3, 1));
    write(|sheet| {
        sheet.clear_cell(5, 2);
    });
    assert_eq!(failed(options()), "in.xlsx, row 6 of the sheet, column k: null; expected a number");
    write(|sheet| {
        sheet.write_string(4, 28, "beside").unwrap();
    });
    assert_eq!(failed(options()), "in.xlsx, cell AC5: there is a value, but no name of a column in row 3");
    fs::write(folder.path().join("in.xlsx"), "no workbook").unwrap();
    assert!(failed(options()).contains("not a whole Excel file, or damaged"));
    let csv = TableOptions { sheet: Some("Points".to_owned()), ..TableOptions::new("in.csv") };
    fs::write(folder.path().join("in.csv"), "gamma,k_prime,k,mu\n1,1,2,5\n").unwrap();
    let error = answer(&folder, "in.csv", "out.csv", csv).unwrap_err();
    assert_eq!(error.to_string(), "--sheet-name Points: in.csv is not a workbook, and has no sheets");
}

/// Numbers of a text are numbers in a sheet, names of digits are not.
#[test]
fn text_that_is_a_number_becomes_one() {
    let folder = tempfile::tempdir().unwrap();
    let table = "gamma,k_prime,k,mu,id,height,empty\n1,1,2,5,007,-0.25,\n1,1,2,5,1e3,12 m,x\n";
    fs::write(folder.path().join("in.csv"), table).unwrap();
    answer(&folder, "in.csv", "out.xlsx", TableOptions::new("in.csv")).unwrap();
    let rows = cells(&folder, "out.xlsx");
    let text = |text: &str| Data::String(text.to_owned());
    assert_eq!(rows[1][4..7], [text("007"), Data::Float(-0.25), Data::Empty]);
    assert_eq!(rows[2][4..7], [Data::Float(1000.0), text("12 m"), text("x")]);
}

/// Before anything is computed where the length is known, and else where the sheet is full.
#[test]
fn more_rows_than_a_sheet_has_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let table = "gamma,k_prime,k,mu\n".to_owned() + &"1,1,2,5\n".repeat(1 << 20);
    fs::write(folder.path().join("in.csv"), table).unwrap();
    let only = || TableOptions {
        columns: vec![standfast_tables::ResultColumn::Mode],
        threads: 2,
        ..TableOptions::new("in")
    };
    answer(&folder, "in.csv", "in.parquet", only()).unwrap();
    let renamed = TableOptions { columns: vec![standfast_tables::ResultColumn::Xi], ..only() };
    let error = answer(&folder, "in.parquet", "out.xlsx", renamed).unwrap_err();
    assert_eq!(
        error.to_string(),
        "1048576 rows do not fit into a sheet of an Excel workbook, which has room for 1048575"
    );
}

/// Formulas of CSV, as a spreadsheet would take them, are texts in a workbook, and nothing is put before them in
/// either.
#[test]
fn a_text_is_no_formula() {
    let folder = tempfile::tempdir().unwrap();
    let rows = "=1+1,1,1,2,5\n+1+1,1,1,2,5\n@SUM(1),1,1,2,5\n-1+1,1,1,2,5\n";
    fs::write(folder.path().join("in.csv"), format!("name,gamma,k_prime,k,mu\n{rows}")).unwrap();
    answer(&folder, "in.csv", "out.xlsx", TableOptions::new("in.csv")).unwrap();
    let mut workbook: Xlsx<_> = calamine::open_workbook(folder.path().join("out.xlsx")).unwrap();
    assert!(workbook.worksheet_formula("Sheet1").unwrap().is_empty());
    answer(&folder, "in.csv", "out.csv", TableOptions::new("in.csv")).unwrap();
    let text = fs::read_to_string(folder.path().join("out.csv")).unwrap();
    for (row, name) in ["=1+1", "+1+1", "@SUM(1)", "-1+1"].into_iter().enumerate() {
        assert_eq!(cells(&folder, "out.xlsx")[row + 1][0], Data::String(name.to_owned()));
        assert!(text.lines().nth(row + 1).unwrap().starts_with(&format!("{name},")));
    }
}

/// A workbook of points with another text in place of a cell.
fn packed(folder: &TempDir, cell: &str) {
    use std::io::{Read, Write};
    workbook(folder);
    let path = folder.path().join("in.xlsx");
    let mut archive = zip::ZipArchive::new(fs::File::open(&path).unwrap()).unwrap();
    let mut packed = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let mut part = archive.by_index(index).unwrap();
        let name = part.name().unwrap().into_owned();
        let mut text = String::new();
        part.read_to_string(&mut text).unwrap();
        if name.ends_with("sheet2.xml") {
            assert_eq!(text.matches("<c r=\"E4\"><v>5</v></c>").count(), 1, "{text}");
            let cell = format!("<c r=\"E4\" t=\"inlineStr\"><is><t>{cell}</t></is></c>");
            text = text.replace("<c r=\"E4\"><v>5</v></c>", &cell);
        }
        packed.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        packed.write_all(text.as_bytes()).unwrap();
    }
    fs::write(path, packed.finish().unwrap().into_inner()).unwrap();
}

/// A small file may hold cells and parts that no memory does: they are refused by their size, before they are read.
#[test]
fn what_unpacks_to_too_much_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let failed = || answer(&folder, "in.xlsx", "out.csv", options()).unwrap_err().to_string();
    packed(&folder, &"5".repeat(32_767));
    assert!(failed().contains("row 4 of the sheet, column mu: \"555"));
    packed(&folder, &"ü".repeat(32_768));
    assert_eq!(failed(), "in.xlsx: cell E4 has 32768 characters or more; expected 32767 at most");
    packed(&folder, &"5".repeat((1 << 24) + 1));
    assert!(fs::metadata(folder.path().join("in.xlsx")).unwrap().len() < 100_000);
    assert_eq!(
        failed(),
        "cannot read in.xlsx: not a whole Excel file, or damaged (its part xl/worksheets/sheet2.xml has a text of more than 16777216 bytes)"
    );
}

/// Names over all columns, and one cell in the last row: columns that would be filled up with cells that are not there.
#[test]
fn columns_are_not_filled_up_without_end() {
    let folder = tempfile::tempdir().unwrap();
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.write_row(0, 0, ["gamma", "k_prime", "k", "mu"]).unwrap();
    for column in 4..100 {
        sheet.write_string(0, column, format!("c{column}")).unwrap();
    }
    sheet.write_row(1, 0, [1.0, 1.0, 2.0, 5.0]).unwrap();
    sheet.write_number((1 << 20) - 1, 99, 1.0).unwrap();
    workbook.save(folder.path().join("in.xlsx")).unwrap();
    let error = answer(&folder, "in.xlsx", "out.csv", TableOptions::new("in.xlsx")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "in.xlsx: sheet Sheet1 has 104857500 cells or more; expected 67108864 at most"
    );
}
