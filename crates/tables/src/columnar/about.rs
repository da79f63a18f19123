//! What stands beside the table in a workbook: what it was answered with, and the worst row of each criterion.

use rust_xlsxwriter::{Format, Workbook, XlsxError};

use crate::results::ResultField;
use crate::{Summary, TableOptions, Varied};

/// Writes the sheets beside the table: on its criteria, where there are some, and on its inputs.
pub(super) fn write(
    workbook: &mut Workbook,
    options: &TableOptions,
    results: &[ResultField],
    summary: &Summary,
    header: u64,
) -> Result<(), XlsxError> {
    if !summary.worst.is_empty() {
        worst(workbook, summary, header)?;
    }
    let sheet = workbook.add_worksheet().set_name("inputs")?;
    let bold = Format::new().set_bold();
    let mut row = 0;
    let mut line = |name: &str, words: &str| -> Result<(), XlsxError> {
        sheet.write_string_with_format(row, 0, name, &bold)?.write_string(row, 1, words)?;
        row += 1;
        Ok(())
    };
    if let Some(program) = &options.program {
        line("program", program)?;
    }
    line("table", &options.name)?;
    if let Some(sheet) = &options.sheet {
        line("sheet", sheet)?;
    }
    if let Some(Varied { columns, notes, warnings }) = &summary.varied {
        for column in columns {
            line("varied", &format!("{} by the column {}", column.key, column.column))?;
        }
        for note in notes {
            line("with them", note)?;
        }
        for warning in warnings {
            line("warning", &warning.to_string())?;
        }
    }
    for warning in &summary.minded {
        line("warning", &format!("{warning} ({})", warning.name))?;
    }
    for field in results {
        if let Some(said) = field.said {
            line(&field.heading(), said.words)?;
        }
    }
    if let Some(case) = &options.case {
        let file = case.file();
        line("case file", file.name())?;
        for words in file.text().lines() {
            line("", words)?;
        }
    }
    sheet.set_column_width(0, 24)?.set_column_width(1, 100)?;
    Ok(())
}

/// The worst row of each criterion; rows are those of the sheet of the table, whose header is in the first.
fn worst(workbook: &mut Workbook, summary: &Summary, header: u64) -> Result<(), XlsxError> {
    let sheet = workbook.add_worksheet().set_name("summary")?;
    let bold = Format::new().set_bold();
    let heads = [
        "criterion",
        "required",
        "worst value",
        "utilisation",
        "met",
        "in",
        "row of the first sheet",
        "rows not met",
        "of rows",
    ];
    for (column, head) in (0..).zip(heads) {
        sheet.write_string_with_format(0, column, head, &bold)?;
        sheet.set_column_width(column, 16)?;
    }
    for (row, worst) in (1..).zip(&summary.worst) {
        let met = if worst.is_met { "met" } else { "not met" };
        let situation = worst.situation.as_deref().unwrap_or_default();
        let words = [worst.criterion, &worst.required, &worst.value, &worst.utilisation, met, situation];
        for (column, words) in (0..).zip(words) {
            sheet.write_string(row, column, words)?;
        }
        let counts = [worst.number() + header, worst.unmet, worst.rows];
        for (column, count) in (6..).zip(counts) {
            sheet.write_number(row, column, count as f64)?;
        }
    }
    Ok(())
}
