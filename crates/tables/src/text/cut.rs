//! CSV text cut into pieces that begin and end with whole rows.

use std::io::{self, Read};

/// Place at which a text can be cut.
#[derive(Debug, PartialEq, Eq)]
struct Cut {
    /// The end of its last whole row.
    end: usize,
    /// True if a quotation mark after that is open.
    open: bool,
}

/// A text without quotation marks is cut at its last line feed, another by the rules of CSV: a field that begins with
/// a quotation mark ends with the next one that is not doubled.
fn cut(text: &[u8], separator: u8) -> Cut {
    if memchr::memchr(b'"', text).is_none() {
        let feed = memchr::memrchr(b'\n', text).or_else(|| memchr::memrchr(b'\r', text));
        return Cut { end: feed.map_or(0, |feed| feed + 1), open: false };
    }
    enum Field {
        Start,
        Plain,
        Quoted,
        QuoteInQuoted,
    }
    let mut end = 0;
    let mut place = Field::Start;
    for (i, &byte) in text.iter().enumerate() {
        place = match (place, byte) {
            (Field::Start | Field::QuoteInQuoted, b'"') => Field::Quoted,
            (Field::Quoted, b'"') => Field::QuoteInQuoted,
            (Field::Quoted, _) => Field::Quoted,
            (_, b'\n' | b'\r') => {
                end = i + 1;
                Field::Start
            }
            (_, byte) if byte == separator => Field::Start,
            _ => Field::Plain,
        };
    }
    Cut { end, open: matches!(place, Field::Quoted) }
}

/// Reason why there is no next piece.
#[derive(Debug)]
pub(crate) enum CutError {
    Read(io::Error),
    /// A quotation mark in the row that would be next is never closed.
    Quote,
}

/// The pieces of a text.
pub(crate) struct Pieces<R> {
    source: R,
    /// Size of a piece, about.
    size: usize,
    /// What stands between its columns.
    separator: u8,
    /// Read, and not yet part of a piece.
    rest: Vec<u8>,
    failed: Option<CutError>,
    ended: bool,
}

/// A row that is longer is taken for one with an open quotation mark.
const LONGEST_ROW: usize = 1 << 26;

impl<R: Read> Pieces<R> {
    pub(crate) fn new(source: R, size: usize) -> Pieces<R> {
        Pieces { source, size, separator: b',', rest: Vec::new(), failed: None, ended: false }
    }

    /// Parts columns by another byte than a comma, from the beginning of a piece on that was read before.
    pub(crate) fn part_by(&mut self, separator: u8, mut piece: Vec<u8>) {
        self.separator = separator;
        piece.append(&mut self.rest);
        self.rest = piece;
    }

    /// The next piece, of whole rows.
    pub(crate) fn next(&mut self) -> Result<Option<Vec<u8>>, CutError> {
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        let mut size = self.size;
        loop {
            self.fill(size)?;
            if self.ended {
                let Cut { end, open } = cut(&self.rest, self.separator);
                let piece = if open { self.rest[..end].to_vec() } else { std::mem::take(&mut self.rest) };
                if open {
                    self.rest.clear();
                    self.failed = Some(CutError::Quote);
                }
                return match piece.is_empty() {
                    false => Ok(Some(piece)),
                    true => self.failed.take().map_or(Ok(None), Err),
                };
            }
            let Cut { end, .. } = cut(&self.rest, self.separator);
            if end > 0 {
                let next = self.rest.split_off(end);
                return Ok(Some(std::mem::replace(&mut self.rest, next)));
            }
            if size > LONGEST_ROW {
                return Err(CutError::Quote);
            }
            size *= 2;
        }
    }

    /// Reads until there are `size` bytes, or no more.
    fn fill(&mut self, size: usize) -> Result<(), CutError> {
        let missing = size.saturating_sub(self.rest.len());
        self.rest.reserve(missing);
        let read =
            (&mut self.source).take(missing as u64).read_to_end(&mut self.rest).map_err(CutError::Read)?;
        self.ended = read < missing;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rows(text: &[u8]) -> Vec<csv::ByteRecord> {
        let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text);
        reader.byte_records().map(Result::unwrap).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]

        /// Whatever the text, its pieces have the rows that the whole has.
        #[test]
        fn pieces_have_the_rows_of_the_whole(
            text in prop::collection::vec(prop::sample::select(b"a\",\n\r;".to_vec()), 0..60),
            size in 1_usize..20,
        ) {
            let mut pieces = Pieces::new(&text[..], size);
            let mut found = Vec::new();
            loop {
                match pieces.next() {
                    Ok(Some(piece)) => found.extend(rows(&piece)),
                    Ok(None) => break,
                    Err(CutError::Read(error)) => panic!("{error}"),
                    Err(CutError::Quote) => {
                        let all = rows(&text);
                        prop_assert_eq!(&found[..], &all[..all.len() - 1]);
                        return Ok(());
                    }
                }
            }
            prop_assert_eq!(found, rows(&text));
        }
    }
}
