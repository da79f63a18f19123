//! Tables as Arrow IPC files and streams.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

use arrow_array::RecordBatch;
use arrow_buffer::Buffer;
use arrow_ipc::convert::fb_to_schema;
use arrow_ipc::reader::{FileDecoder, StreamReader, read_footer_length};
use arrow_ipc::{Block, root_as_footer};
use arrow_schema::{ArrowError, SchemaRef};
use std::sync::Arc;

/// The batches of a file, one after the other.
pub(crate) struct ArrowFile {
    file: File,
    length: u64,
    decoder: FileDecoder,
    blocks: std::vec::IntoIter<Block>,
    pub(crate) schema: SchemaRef,
}

/// Bytes at the beginning and end of a file.
const MAGIC: &[u8] = b"ARROW1";

impl ArrowFile {
    /// Reads the end of the file, where its batches are listed, and the dictionaries.
    pub(crate) fn open(mut file: File) -> Result<ArrowFile, ArrowError> {
        let broken = |what: &str| ArrowError::ParseError(what.to_owned());
        let length = file.seek(SeekFrom::End(0))?;
        if length < 20 || &read(&mut file, length, 0, 6)?[..] != MAGIC {
            return Err(broken("it does not begin with ARROW1"));
        }
        let trailer = read(&mut file, length, length - 10, 10)?;
        let trailer: [u8; 10] = trailer.as_slice().try_into().map_err(|_| broken("no trailer"))?;
        let footer_length = read_footer_length(trailer)? as u64;
        let start =
            (length - 10).checked_sub(footer_length).ok_or_else(|| broken("its footer is too long"))?;
        let bytes = read(&mut file, length, start, footer_length)?;
        let footer = root_as_footer(&bytes).map_err(|error| broken(&error.to_string()))?;
        let schema = Arc::new(fb_to_schema(footer.schema().ok_or_else(|| broken("it has no schema"))?));
        let mut decoder = FileDecoder::new(schema.clone(), footer.version());
        for block in footer.dictionaries().iter().flatten() {
            decoder.read_dictionary(block, &read_block(&mut file, length, block)?)?;
        }
        let blocks: Vec<Block> = footer.recordBatches().iter().flatten().copied().collect();
        Ok(ArrowFile { file, length, decoder, blocks: blocks.into_iter(), schema })
    }

    /// Number of batches left.
    pub(crate) fn left(&self) -> u64 {
        self.blocks.len() as u64
    }

    pub(crate) fn next(&mut self) -> Result<Option<RecordBatch>, ArrowError> {
        for block in self.blocks.by_ref() {
            let bytes = read_block(&mut self.file, self.length, &block)?;
            if let Some(batch) = self.decoder.read_record_batch(&block, &bytes)? {
                return Ok(Some(batch));
            }
        }
        Ok(None)
    }
}

fn read_block(file: &mut File, length: u64, block: &Block) -> Result<Buffer, ArrowError> {
    let part = |x: i64| u64::try_from(x).map_err(|_| ArrowError::ParseError("a negative length".to_owned()));
    let (offset, body) = (part(block.offset())?, part(block.bodyLength())?);
    let size = body.saturating_add(part(block.metaDataLength().into())?);
    Ok(read(file, length, offset, size)?.into())
}

/// `size` bytes of a file from `offset`. A damaged file may ask for more than there is.
fn read(file: &mut File, length: u64, offset: u64, size: u64) -> Result<Vec<u8>, ArrowError> {
    if offset.saturating_add(size) > length {
        return Err(ArrowError::ParseError("it is cut off".to_owned()));
    }
    file.seek(SeekFrom::Start(offset))?;
    let mut bytes = Vec::with_capacity(usize::try_from(size).unwrap_or_default());
    file.take(size).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == size {
        Ok(bytes)
    } else {
        Err(io::Error::from(io::ErrorKind::UnexpectedEof).into())
    }
}

/// The batches of a table.
pub(crate) enum Batches<'a> {
    File(Box<ArrowFile>),
    Stream(Box<StreamReader<Box<dyn Read + Send + 'a>>>),
    /// One that is in memory.
    #[cfg(feature = "xlsx")]
    Whole(Option<RecordBatch>, SchemaRef),
}

impl Batches<'_> {
    pub(crate) fn next(&mut self) -> Result<Option<RecordBatch>, ArrowError> {
        match self {
            Batches::File(file) => file.next(),
            Batches::Stream(stream) => stream.next().transpose(),
            #[cfg(feature = "xlsx")]
            Batches::Whole(batch, _) => Ok(batch.take()),
        }
    }

    pub(crate) fn schema(&self) -> SchemaRef {
        match self {
            Batches::File(file) => file.schema.clone(),
            Batches::Stream(stream) => stream.schema(),
            #[cfg(feature = "xlsx")]
            Batches::Whole(_, schema) => schema.clone(),
        }
    }
}
