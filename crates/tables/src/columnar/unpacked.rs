//! Size of a workbook unpacked, before it is read: a megabyte may hold a part of gigabytes, or say that it does.

use std::fs::File;
use std::io::{BufReader, Read};

use memchr::{memchr_iter, memmem};
use zip::ZipArchive;

use crate::{TableError, TableOptions};

/// Largest sizes unpacked, bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Of one part. A full sheet of twenty columns has so many.
    pub(super) part: u64,
    /// Of all parts together.
    pub(super) all: u64,
    /// Between two marks of XML, as one text: what a reader of XML keeps as a whole.
    pub(super) text: u64,
}

pub(super) const LIMITS: Limits = Limits { part: 1 << 30, all: 1 << 31, text: 1 << 24 };

/// Bytes read at once.
const BUFFER: usize = 1 << 16;

/// Refuses a workbook that unpacks to more than `limits`, whatever sizes it claims. What is not a workbook is for its reader to tell.
pub(super) fn check(file: &File, options: &TableOptions, limits: Limits) -> Result<(), TableError> {
    let Ok(mut archive) = ZipArchive::new(BufReader::new(file)) else { return Ok(()) };
    let mut left = limits.all;
    for index in 0..archive.len() {
        let Ok(mut part) = archive.by_index(index) else { continue };
        let most = left.min(limits.part);
        let name = part.name().map(|name| name.into_owned()).unwrap_or_default();
        let unpacked = match part.size() {
            claimed if claimed > most => Err(Excess::Size(claimed)),
            _ => unpacked(&mut part, most, limits.text),
        };
        left -= unpacked.map_err(|wrong| match wrong {
            Excess::Size(found) => {
                let (name, part) = (options.name.clone(), format!("its part {name}"));
                TableError::TooLarge { name, part, found, what: "bytes unpacked", most }
            }
            Excess::Text => {
                options.damaged(format!("its part {name} has a text of more than {} bytes", limits.text))
            }
            Excess::Count(count) => options.damaged(format!("its part {name} claims {count} texts")),
        })?;
    }
    Ok(())
}

/// Fault that no workbook has.
enum Excess {
    /// More bytes than there may be: so many, or more.
    Size(u64),
    /// More of them without a mark of XML.
    Text,
    /// A number of texts for which there is no room in the part.
    Count(u64),
}

/// The bytes of a part, counted as they come.
fn unpacked(part: &mut impl Read, most: u64, text: u64) -> Result<u64, Excess> {
    // The end of what was read before is kept, for words that lie across.
    let mut buffer = vec![0; KEPT + BUFFER];
    let (mut size, mut run, mut claimed) = (0, 0, 0);
    // A part that cannot be unpacked is for the reader to tell, if it is read at all.
    while let Ok(count @ 1..) = part.read(&mut buffer[KEPT..]) {
        size += count as u64;
        if size > most {
            return Err(Excess::Size(size));
        }
        let (bytes, mut from) = (&buffer[KEPT..KEPT + count], 0);
        for at in memchr_iter(b'<', bytes) {
            if run + (at - from) as u64 > text {
                return Err(Excess::Text);
            }
            (run, from) = (0, at + 1);
        }
        run += (count - from) as u64;
        if run > text {
            return Err(Excess::Text);
        }
        claimed = count_claimed(&buffer[..KEPT + count]).max(claimed);
        buffer.copy_within(count..count + KEPT, 0);
    }
    // Each text has a mark of five bytes at least, <si/>.
    if claimed > size / 5 { Err(Excess::Count(claimed)) } else { Ok(size) }
}

const KEPT: usize = 64;

/// The number of texts for which a reader makes room in advance: that of `uniqueCount = "…"`.
fn count_claimed(bytes: &[u8]) -> u64 {
    const NAME: &[u8] = b"uniqueCount";
    let of = |at: usize| {
        let mut after = bytes[at + NAME.len()..].iter().filter(|byte| !byte.is_ascii_whitespace());
        let is_given = after.next() == Some(&b'=') && after.next().is_some();
        let digits = after.take_while(|byte| byte.is_ascii_digit() && is_given);
        digits.fold(0_u64, |number, digit| number.saturating_mul(10).saturating_add(u64::from(digit - b'0')))
    };
    memmem::find_iter(bytes, NAME).map(of).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use std::io::{Seek, Write};

    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    use super::*;

    const SMALL: Limits = Limits { part: 100_000, all: 150_000, text: 1000 };

    /// A file of parts, each of its bytes so many times.
    fn packed(parts: &[(&str, &[u8], usize)]) -> File {
        let mut zip = ZipWriter::new(tempfile::tempfile().unwrap());
        for (name, bytes, times) in parts {
            zip.start_file(*name, SimpleFileOptions::default()).unwrap();
            (0..*times).for_each(|_| zip.write_all(bytes).unwrap());
        }
        let mut file = zip.finish().unwrap();
        file.rewind().unwrap();
        file
    }

    fn said(parts: &[(&str, &[u8], usize)]) -> Option<String> {
        let options = TableOptions { from: crate::TableFormat::Xlsx, ..TableOptions::new("in.xlsx") };
        check(&packed(parts), &options, SMALL).err().map(|error| error.to_string())
    }

    #[test]
    fn what_unpacks_to_too_much_is_refused() {
        assert_eq!(said(&[("a.xml", b"<a/>", 20_000), ("b.xml", b"<b/>", 15_000)]), None);
        let large = said(&[("a.xml", b"<a/>", 10), ("b.xml", b"<b/>", 25_001)]).unwrap();
        assert_eq!(
            large,
            "in.xlsx: its part b.xml has 100004 bytes unpacked or more; expected 100000 at most"
        );
        let all = said(&[("a.xml", b"<a/>", 20_000), ("b.xml", b"<b/>", 20_000)]).unwrap();
        assert_eq!(all, "in.xlsx: its part b.xml has 80000 bytes unpacked or more; expected 70000 at most");
    }

    /// Bytes that come are counted, whatever size is claimed: a part without end is not read to its end.
    #[test]
    fn sizes_are_not_believed() {
        let found = unpacked(&mut std::io::repeat(b'<'), SMALL.part, SMALL.text);
        assert!(matches!(found, Err(Excess::Size(131_072))));
        let (mut lying, mut file) = (Vec::new(), packed(&[("a.xml", b"<a/>", 50_000)]));
        file.read_to_end(&mut lying).unwrap();
        let places: Vec<_> = memmem::find_iter(&lying, &200_000_u32.to_le_bytes()).collect();
        assert_eq!(places.len(), 2);
        places.into_iter().for_each(|at| lying[at..at + 4].copy_from_slice(&12_u32.to_le_bytes()));
        let mut archive = ZipArchive::new(std::io::Cursor::new(lying)).unwrap();
        let mut bytes = Vec::new();
        assert!(archive.by_index(0).unwrap().read_to_end(&mut bytes).is_err());
    }

    #[test]
    fn a_text_without_end_and_a_count_without_texts_are_refused() {
        let said = |bytes: &[u8], times| said(&[("a.xml", bytes, times)]);
        assert_eq!(said(b"<t>0123456789</t>", 1000), None);
        assert!(
            said(b"0123456789", 101).unwrap().contains("its part a.xml has a text of more than 1000 bytes")
        );
        assert_eq!(said(b"<sst uniqueCount=\"1\"><si/>", 1), None);
        for text in ["<sst uniqueCount=\"99999999999\"><si/>", "<sst a='' uniqueCount = '30' />"] {
            assert!(said(text.as_bytes(), 1).unwrap().contains("its part a.xml claims "), "{text}");
        }
        // Across what is read at once.
        let filled = "<a/>".repeat(BUFFER / 4 - 5) + "<sst uniqueCount=\"99999999999\"><si/>";
        assert!(said(filled.as_bytes(), 1).unwrap().contains("claims 99999999999 texts"));
    }
}
