//! What the CSV reader does not tell: on which line a row stands, and whether a quotation mark is left open.

use std::io::{self, Read};

use csv::{ByteRecord, Reader};

/// A source that counts quotation marks and remembers what it gave last.
pub(super) struct Watched<R> {
    source: R,
    quotes: usize,
    end: u64,
    last: Vec<u8>,
}

impl<R: Read> Watched<R> {
    pub(super) fn new(source: R) -> Watched<R> {
        Watched { source, quotes: 0, end: 0, last: Vec::new() }
    }

    /// The byte before `offset`, if it was among those given last.
    fn before(&self, offset: u64) -> Option<u8> {
        let back = usize::try_from(self.end.checked_sub(offset)?).ok()?;
        self.last.iter().rev().nth(back).copied()
    }
}

impl<R: Read> Read for Watched<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let length = self.source.read(buffer)?;
        if length > 0 {
            self.last.clear();
            self.last.extend_from_slice(&buffer[..length]);
            self.quotes += self.last.iter().filter(|&&byte| byte == b'"').count();
            self.end += length as u64;
        }
        Ok(length)
    }
}

/// The line on which the row just read begins, counted from one.
///
/// The reader's own number is that of the blank lines before the row, and one too small after a CR LF, of which it
/// takes the LF only with the next row. So the line is counted back from where the row ended.
pub(super) fn line<R: Read>(reader: &Reader<Watched<R>>, record: &ByteRecord) -> u64 {
    let end = reader.position();
    let ended_by_line_feed = reader.get_ref().before(end.byte()) == Some(b'\n');
    end.line().saturating_sub(line_feeds(record) + u64::from(ended_by_line_feed)).max(1)
}

/// The line of the row just read, if it has a quotation mark that was never closed, so that the rest of the table
/// was taken for part of one field.
///
/// Where a row ends together with the bytes read so far, it and all rows before it have an even number of them.
pub(super) fn left_open<R: Read>(reader: &Reader<Watched<R>>, record: &ByteRecord) -> Option<u64> {
    let Watched { quotes, end, .. } = reader.get_ref();
    let odd = quotes % 2 == 1 && reader.position().byte() == *end;
    let open = odd && record.iter().next_back().is_some_and(|field| field.contains(&b'\n'));
    open.then(|| reader.position().line().saturating_sub(line_feeds(record)))
}

fn line_feeds(record: &ByteRecord) -> u64 {
    record.as_slice().iter().filter(|&&byte| byte == b'\n').count() as u64
}
