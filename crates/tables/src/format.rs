//! The formats of tables.

use std::path::Path;

use crate::TableError;

/// The format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum TableFormat {
    /// Text with commas (.csv, .txt)
    Csv,
    /// Apache Parquet (.parquet, .pq)
    Parquet,
    /// Arrow IPC file, also called Feather (.arrow, .ipc, .feather)
    Arrow,
    /// Arrow IPC stream (.arrows)
    Arrows,
    /// Excel workbook (.xlsx)
    Xlsx,
}

impl TableFormat {
    /// The format of `path` by its extension; without one, and for `-`, CSV. `option` is the one that would tell it.
    ///
    /// # Errors
    /// If the extension is not known.
    pub fn of(path: &Path, option: &'static str) -> Result<TableFormat, TableError> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            None | Some("csv" | "txt") => Ok(TableFormat::Csv),
            Some("parquet" | "pq") => Ok(TableFormat::Parquet),
            Some("arrow" | "ipc" | "feather") => Ok(TableFormat::Arrow),
            Some("arrows") => Ok(TableFormat::Arrows),
            Some("xlsx") => Ok(TableFormat::Xlsx),
            Some(_) => Err(TableError::Format { name: path.display().to_string(), option }),
        }
    }

    /// True if this build can read and write it: CSV always, workbooks with the feature `xlsx`, the others with
    /// `columnar`.
    pub fn is_built_in(self) -> bool {
        match self {
            TableFormat::Csv => true,
            TableFormat::Parquet | TableFormat::Arrow | TableFormat::Arrows => cfg!(feature = "columnar"),
            TableFormat::Xlsx => cfg!(feature = "xlsx"),
        }
    }

    /// Name of the format in errors.
    pub fn name(self) -> &'static str {
        match self {
            TableFormat::Csv => "CSV",
            TableFormat::Parquet => "Parquet",
            TableFormat::Arrow => "Arrow IPC",
            TableFormat::Arrows => "Arrow IPC stream",
            TableFormat::Xlsx => "Excel",
        }
    }
}
