//! A whole table, from any format to any: text that stays text here, all else by columns.

use std::io::Write;

use crate::guard::guarded;
use crate::pieces::{TableInput, answer_pieces};
use crate::text::Text;
use crate::{Progress, Summary, TableError, TableFormat, TableOptions};

/// Bytes of text read at once: as little as stays in the caches.
const TEXT: usize = 1 << 17;

/// Answers every row of a table, and tells `progress` how far it is.
///
/// # Errors
/// As [`run`](crate::run), and if this build leaves out one of the formats.
pub fn answer(
    input: TableInput<'_>,
    mut output: impl Write + Send,
    options: &TableOptions,
    progress: &dyn Progress,
) -> Result<Summary, TableError> {
    answer_into(input, &mut output, options, progress)
}

/// Answers into any output, so that what formats have of generic code is compiled here, once.
fn answer_into(
    input: TableInput<'_>,
    output: &mut (dyn Write + Send),
    options: &TableOptions,
    progress: &dyn Progress,
) -> Result<Summary, TableError> {
    if let Some(format) = [options.from, options.to].into_iter().find(|format| !format.is_built_in()) {
        return Err(TableError::LeftOut { name: options.name.clone(), format: format.name() });
    }
    if let Some(sheet) = options.sheet.as_ref().filter(|_| options.from != TableFormat::Xlsx) {
        return Err(TableError::NoSheets { name: options.name.clone(), sheet: sheet.clone() });
    }
    let head = [("--header-row", options.head.row.is_some()), ("--units-row", options.head.has_units)];
    let read_by_rows = matches!(options.from, TableFormat::Csv | TableFormat::Xlsx);
    if let Some((option, _)) = head.into_iter().find(|(_, is_said)| *is_said && !read_by_rows) {
        let (name, format) = (options.name.clone(), options.from.name());
        return Err(TableError::NoHead { option, name, format });
    }
    #[cfg(feature = "columnar")]
    if [options.from, options.to] != [TableFormat::Csv; 2] {
        return crate::columnar::answer(input, output, options, progress);
    }
    text(input, output, options, progress)
}

/// Text that stays text: its rows keep their bytes.
fn text(
    input: TableInput<'_>,
    output: &mut (dyn Write + Send),
    options: &TableOptions,
    progress: &dyn Progress,
) -> Result<Summary, TableError> {
    let (mut text, header) =
        guarded(|cause| options.damaged(cause), || Text::open(input.stream(), TEXT, options))?;
    output
        .write_all(&header.task.header(&header.bytes, header.separators, header.end))
        .map_err(TableError::Write)?;
    let work = |piece| {
        let answered = header.answer(piece);
        let rows = options.rows_to_write(answered.parsed.len(), answered.first_row());
        let bytes = answered.parsed.write(&header, &answered.results, rows);
        Ok(answered.done(bytes))
    };
    let write = |bytes: Vec<u8>| output.write_all(&bytes).map_err(TableError::Write);
    let summary = answer_pieces(options, None, progress, || text.next(), work, write)?;
    output.flush().map_err(TableError::Write)?;
    Ok(Summary { varied: header.task.varied(), ..summary })
}
