//! Tables of other programs' making, as whole columns, in any format.

use std::io;

use crate::TableFormat;

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum WrittenColumn {
    /// Numbers, where there are some.
    Numbers(Vec<Option<f64>>),
    /// Whole numbers, where there are some.
    Counts(Vec<Option<i64>>),
    /// Truth values, where they are known.
    Truths(Vec<Option<bool>>),
    /// Texts.
    Texts(Vec<String>),
}

impl WrittenColumn {
    fn cell(&self, row: usize) -> String {
        let text = |cell: Option<String>| cell.unwrap_or_default();
        match self {
            WrittenColumn::Numbers(values) => text(values[row].map(|value| value.to_string())),
            WrittenColumn::Counts(values) => text(values[row].map(|value| value.to_string())),
            WrittenColumn::Truths(values) => text(values[row].map(|value| value.to_string())),
            WrittenColumn::Texts(values) => values[row].clone(),
        }
    }

    fn len(&self) -> usize {
        match self {
            WrittenColumn::Numbers(values) => values.len(),
            WrittenColumn::Counts(values) => values.len(),
            WrittenColumn::Truths(values) => values.len(),
            WrittenColumn::Texts(values) => values.len(),
        }
    }
}

/// The bytes of a file with these columns, each under its name; all are of the same length.
///
/// # Errors
/// If the format is not built in, or the table does not fit into it.
pub fn written(format: TableFormat, columns: &[(String, WrittenColumn)]) -> io::Result<Vec<u8>> {
    if format == TableFormat::Csv {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record(columns.iter().map(|(name, _)| name))?;
        let rows = columns.iter().map(|(_, column)| column.len()).min().unwrap_or(0);
        for row in 0..rows {
            out.write_record(columns.iter().map(|(_, column)| column.cell(row)))?;
        }
        return out.into_inner().map_err(|error| io::Error::other(error.to_string()));
    }
    #[cfg(feature = "columnar")]
    return crate::columnar::written(format, columns);
    #[cfg(not(feature = "columnar"))]
    Err(io::Error::other(format!("this build leaves out {}", format.name())))
}
