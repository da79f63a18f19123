//! Tables as Parquet files.
//!
//! From Parquet to Parquet the columns of a table are not decoded and encoded again: their bytes are copied, row group
//! by row group, and only the columns of the problem are read.

use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::sync::Arc;

use arrow_array::{ArrayRef, RecordBatch};
use arrow_schema::{ArrowError, Field, Schema, SchemaRef};
use bytes::Bytes;
use parquet::arrow::arrow_reader::{
    ArrowReaderMetadata, ArrowReaderOptions, ParquetRecordBatchReader, ParquetRecordBatchReaderBuilder,
};
use parquet::arrow::arrow_writer::{
    ArrowColumnChunk, ArrowColumnWriter, ArrowRowGroupWriterFactory, compute_leaves,
};
use parquet::arrow::{
    ARROW_SCHEMA_META_KEY, ArrowSchemaConverter, ProjectionMask, add_encoded_arrow_schema_to_metadata,
};
use parquet::basic::{Compression, Type as PhysicalType};
use parquet::bloom_filter::Sbbf;
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::Result;
use parquet::file::metadata::{PageIndexPolicy, ParquetMetaData, RowGroupMetaData};
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesBuilder};
use parquet::file::reader::{ChunkReader, Length};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type};

use crate::results::{FieldKind, ResultField};

/// Rows that are decoded at once.
const ROWS: usize = 1 << 16;

/// A larger row group is written as several.
const LARGEST_GROUP: u64 = 1 << 21;

/// A file read at any place by any thread.
#[derive(Clone)]
pub(crate) struct Shared {
    file: Arc<File>,
    length: u64,
}

/// A file from some place on.
pub(crate) struct Suffix {
    file: Shared,
    offset: u64,
}

impl Shared {
    fn read_at(&self, bytes: &mut [u8], offset: u64) -> io::Result<usize> {
        #[cfg(unix)]
        return std::os::unix::fs::FileExt::read_at(&*self.file, bytes, offset);
        #[cfg(windows)]
        return std::os::windows::fs::FileExt::seek_read(&*self.file, bytes, offset);
    }
}

impl Read for Suffix {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let read = self.file.read_at(bytes, self.offset)?;
        self.offset += read as u64;
        Ok(read)
    }
}

impl Length for Shared {
    fn len(&self) -> u64 {
        self.length
    }
}

impl ChunkReader for Shared {
    type T = BufReader<Suffix>;

    fn get_read(&self, start: u64) -> Result<BufReader<Suffix>> {
        Ok(BufReader::new(Suffix { file: self.clone(), offset: start }))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        if start.saturating_add(length as u64) > self.length {
            return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into());
        }
        let mut bytes = Vec::with_capacity(length);
        Suffix { file: self.clone(), offset: start }.take(length as u64).read_to_end(&mut bytes)?;
        if bytes.len() < length {
            return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into());
        }
        Ok(bytes.into())
    }
}

/// Reader of the same file in large pieces.
struct Bulk(Shared);

impl Length for Bulk {
    fn len(&self) -> u64 {
        self.0.length
    }
}

impl ChunkReader for Bulk {
    type T = BufReader<Suffix>;

    fn get_read(&self, start: u64) -> Result<BufReader<Suffix>> {
        Ok(BufReader::with_capacity(1 << 20, Suffix { file: self.0.clone(), offset: start }))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        self.0.get_bytes(start, length)
    }
}

/// A Parquet file to read from.
#[derive(Clone)]
pub(crate) struct Source {
    file: Shared,
    metadata: ArrowReaderMetadata,
}

/// A part of a file that is worked on as one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part {
    group: usize,
    /// Rows of the group before the part.
    offset: usize,
    pub(crate) rows: usize,
    /// The part is a whole row group, whose columns are to be copied.
    pub(crate) copied: bool,
    /// Rows of the file before the part.
    pub(crate) start: usize,
}

impl Source {
    pub(crate) fn open(file: File) -> Result<Source> {
        let length = file.metadata()?.len();
        let file = Shared { file: Arc::new(file), length };
        let options = ArrowReaderOptions::new().with_page_index_policy(PageIndexPolicy::Optional);
        let metadata = ArrowReaderMetadata::load(&file, options)?;
        Ok(Source { file, metadata })
    }

    pub(crate) fn schema(&self) -> SchemaRef {
        self.metadata.schema().clone()
    }

    fn parquet(&self) -> &ParquetMetaData {
        self.metadata.metadata()
    }

    /// The codec of the column at a place, if it is one that cannot be read.
    pub(crate) fn unreadable(&self, place: usize) -> Option<Compression> {
        let file = self.parquet();
        let leaf = (0..file.file_metadata().schema_descr().num_columns())
            .find(|&leaf| file.file_metadata().schema_descr().get_column_root_idx(leaf) == place)?;
        let codecs = file.row_groups().iter().map(|group| group.column(leaf).compression());
        codecs.into_iter().find(|codec| matches!(codec, Compression::BROTLI(_) | Compression::LZO))
    }

    pub(crate) fn rows(&self) -> u64 {
        self.parquet().row_groups().iter().map(rows).sum()
    }

    /// The parts of the file: row groups to be copied, or pieces to be decoded of about `size` rows.
    pub(crate) fn parts(&self, copy: bool, size: usize) -> impl Iterator<Item = Part> + use<> {
        let columns = self.parquet().file_metadata().schema_descr().columns().iter();
        // Timestamps of the old kind can be read but not written.
        let must_copy = columns.into_iter().any(|column| column.physical_type() == PhysicalType::INT96);
        let groups: Vec<u64> = self.parquet().row_groups().iter().map(rows).collect();
        let mut start = 0;
        groups.into_iter().enumerate().flat_map(move |(group, rows)| {
            let copied = copy && (rows <= LARGEST_GROUP || must_copy);
            let before = start;
            let rows = usize::try_from(rows).unwrap_or(usize::MAX);
            start += rows;
            let size = if copied { rows.max(1) } else { size };
            (0..rows.div_ceil(size)).map(move |piece| {
                let offset = piece * size;
                Part { group, offset, rows: size.min(rows - offset), copied, start: before + offset }
            })
        })
    }

    fn reader(&self, part: Part) -> ParquetRecordBatchReaderBuilder<Shared> {
        let builder =
            ParquetRecordBatchReaderBuilder::new_with_metadata(self.file.clone(), self.metadata.clone());
        builder.with_row_groups(vec![part.group]).with_offset(part.offset).with_limit(part.rows)
    }

    /// All columns of a part.
    pub(crate) fn read(&self, part: Part) -> Result<ParquetRecordBatchReader> {
        self.reader(part).with_batch_size(part.rows.min(ROWS)).build()
    }

    /// The columns at `places`, in the order of the file, some thousand rows at a time.
    pub(crate) fn read_columns(&self, part: Part, places: &[usize]) -> Result<ParquetRecordBatchReader> {
        let mask =
            ProjectionMask::roots(self.parquet().file_metadata().schema_descr(), places.iter().copied());
        self.reader(part).with_projection(mask).with_batch_size(part.rows.min(ROWS)).build()
    }

    /// Properties of the results to be written: those of the file's own columns.
    fn properties(&self, schema: &Schema, results: &[ResultField]) -> WriterProperties {
        let file = self.parquet().file_metadata();
        let group = self.parquet().row_groups().first();
        let compression = group.and_then(|group| group.columns().first()).map(|column| column.compression());
        let compression =
            compression.filter(|codec| !matches!(codec, Compression::BROTLI(_) | Compression::LZO));
        let metadata = file.key_value_metadata().into_iter().flatten();
        let metadata = metadata.filter(|entry| entry.key != ARROW_SCHEMA_META_KEY).cloned().collect();
        let sorting = group.and_then(|group| group.sorting_columns()).cloned();
        let mut builder = properties(compression.unwrap_or(Compression::SNAPPY), results)
            .set_key_value_metadata(Some(metadata))
            .set_sorting_columns(sorting);
        // Either all columns have an index of their pages or none.
        if self.parquet().offset_index().is_none() {
            builder =
                builder.set_statistics_enabled(EnabledStatistics::Chunk).set_offset_index_disabled(true);
        }
        let mut properties = builder.build();
        add_encoded_arrow_schema_to_metadata(schema, &mut properties);
        properties
    }

    /// Appends the columns of a row group to `writer` as they are.
    fn copy<W: Write + Send>(
        &self,
        group: usize,
        writer: &mut parquet::file::writer::SerializedRowGroupWriter<'_, W>,
    ) -> Result<()> {
        let metadata = self.parquet();
        let column_index = metadata.column_index().and_then(|index| index.get(group));
        let offset_index = metadata.offset_index().and_then(|index| index.get(group));
        let group = metadata.row_group(group);
        for (i, column) in group.columns().iter().enumerate() {
            let close = ColumnCloseResult {
                bytes_written: column.compressed_size().cast_unsigned(),
                rows_written: rows(group),
                metadata: column.clone(),
                bloom_filter: Sbbf::read_from_column_chunk(column, &self.file).ok().flatten(),
                column_index: column_index.and_then(|row| row.get(i)).cloned(),
                offset_index: offset_index.and_then(|row| row.get(i)).cloned(),
            };
            writer.append_column(&Bulk(self.file.clone()), close)?;
        }
        Ok(())
    }
}

fn rows(group: &RowGroupMetaData) -> u64 {
    u64::try_from(group.num_rows()).unwrap_or_default()
}

fn properties(compression: Compression, results: &[ResultField]) -> WriterPropertiesBuilder {
    let mut builder = WriterProperties::builder().set_compression(compression);
    for result in results {
        let path = ColumnPath::from(result.name);
        // Least and greatest symbols say nothing, and numbers hardly ever repeat.
        if matches!(result.kind, FieldKind::Number) {
            builder = builder
                .set_column_dictionary_enabled(path.clone(), false)
                .set_column_statistics_enabled(path, EnabledStatistics::Chunk);
        } else {
            builder = builder.set_column_statistics_enabled(path, EnabledStatistics::None);
        }
    }
    builder
}

/// Encoder of columns, on any thread.
pub(crate) struct Encoder {
    /// For whole rows.
    rows: ArrowRowGroupWriterFactory,
    schema: SchemaRef,
    /// For the results alone.
    results: ArrowRowGroupWriterFactory,
    fields: Vec<Field>,
}

/// A row group that is ready to be written.
pub(crate) struct Group {
    /// The part of the source whose columns come first, as they are.
    pub(crate) copied: Option<Part>,
    pub(crate) columns: Vec<ArrowColumnChunk>,
}

/// A Parquet file to write to.
pub(crate) struct Sink<W: Write + Send> {
    writer: SerializedFileWriter<W>,
}

/// Begins a file with the columns of `schema`, of which the last are `results`. From Parquet, the types and metadata of
/// the `source` stay as they are.
pub(crate) fn create<W: Write + Send>(
    output: W,
    schema: &SchemaRef,
    results: &[ResultField],
    source: Option<&Source>,
) -> Result<(Sink<W>, Encoder)> {
    let added = schema.fields().len() - results.len();
    let fields: Vec<Field> = schema.fields()[added..].iter().map(|field| field.as_ref().clone()).collect();
    let only_results = Arc::new(Schema::new(fields.clone()));
    let result_types = ArrowSchemaConverter::new().convert(&only_results)?.root_schema_ptr();
    let (types, properties) = match source {
        Some(source) => {
            let root = source.parquet().file_metadata().schema();
            let types = root.get_fields().iter().chain(result_types.get_fields()).cloned().collect();
            let root = Type::group_type_builder(root.name()).with_fields(types).build()?;
            (Arc::new(root), source.properties(schema, results))
        }
        None => {
            let mut properties = properties(Compression::SNAPPY, results).build();
            add_encoded_arrow_schema_to_metadata(schema, &mut properties);
            (ArrowSchemaConverter::new().convert(schema)?.root_schema_ptr(), properties)
        }
    };
    let properties = Arc::new(properties);
    let writer = SerializedFileWriter::new(output, types, properties.clone())?;
    let alone = SerializedFileWriter::new(io::sink(), result_types, properties)?;
    let encoder = Encoder {
        rows: ArrowRowGroupWriterFactory::new(&writer, schema.clone()),
        schema: schema.clone(),
        results: ArrowRowGroupWriterFactory::new(&alone, only_results),
        fields,
    };
    Ok((Sink { writer }, encoder))
}

impl Encoder {
    /// The row group of these rows.
    pub(crate) fn rows(&self, batches: &[RecordBatch]) -> Result<Group> {
        let mut writers = self.rows.create_column_writers(0)?;
        for batch in batches {
            let columns = self.schema.fields().iter().map(AsRef::as_ref).zip(batch.columns());
            write(&mut writers, columns)?;
        }
        Ok(Group { copied: None, columns: close(writers)? })
    }

    /// Begins the columns of results of a row group.
    pub(crate) fn results(&self) -> Result<Vec<ArrowColumnWriter>> {
        self.results.create_column_writers(0)
    }

    /// Appends results to such columns.
    pub(crate) fn write(&self, writers: &mut [ArrowColumnWriter], results: &[ArrayRef]) -> Result<()> {
        write(writers, self.fields.iter().zip(results))
    }
}

fn write<'a>(
    writers: &mut [ArrowColumnWriter],
    columns: impl Iterator<Item = (&'a Field, &'a ArrayRef)>,
) -> Result<()> {
    let mut writers = writers.iter_mut();
    for (field, column) in columns {
        for leaf in compute_leaves(field, column)? {
            let writer =
                writers.next().ok_or_else(|| ArrowError::SchemaError("too many columns".to_owned()))?;
            writer.write(&leaf)?;
        }
    }
    Ok(())
}

/// Ends the columns of a row group.
pub(crate) fn close(writers: Vec<ArrowColumnWriter>) -> Result<Vec<ArrowColumnChunk>> {
    writers.into_iter().map(ArrowColumnWriter::close).collect()
}

impl<W: Write + Send> Sink<W> {
    pub(crate) fn write(&mut self, group: Group, source: Option<&Source>) -> Result<()> {
        let mut writer = self.writer.next_row_group()?;
        if let (Some(part), Some(source)) = (group.copied, source) {
            source.copy(part.group, &mut writer)?;
        }
        for column in group.columns {
            column.append_to_row_group(&mut writer)?;
        }
        writer.close()?;
        Ok(())
    }

    pub(crate) fn finish(self) -> Result<W> {
        self.writer.into_inner()
    }
}
