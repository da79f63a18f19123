//! Unpacks the explorer's library in the browser, which knows gzip alone: by LZMA the page is a quarter smaller.

#![forbid(unsafe_code)]

use std::io::Read;

use lzma_rust2::LzmaReader;
use wasm_bindgen::prelude::wasm_bindgen;

/// Most bytes that are unpacked: what is not packed says any number.
const MOST: u32 = 64 << 20;
/// Most memory that is taken for it, in KiB: the largest dictionary of the packer's presets, and what goes with it.
const MEMORY: u32 = 72 << 10;

/// The bytes that are packed by LZMA behind its header; none of what is not so packed.
#[wasm_bindgen]
pub fn unpack(packed: &[u8]) -> Option<Vec<u8>> {
    // The header ends with the number of bytes.
    let count = packed.get(5..13)?.try_into().map(u64::from_le_bytes).ok()?;
    let count = u32::try_from(count).ok().filter(|count| *count <= MOST)?;
    let mut bytes = vec![0; usize::try_from(count).ok()?];
    let mut reader = LzmaReader::new_mem_limit(packed, MEMORY, None).ok()?;
    reader.read_exact(&mut bytes).ok()?;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use lzma_rust2::{LzmaOptions, LzmaWriter};

    use super::unpack;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let options = LzmaOptions::with_preset(9);
        let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64)).unwrap();
        writer.write_all(bytes).unwrap();
        writer.finish().unwrap()
    }

    #[test]
    fn what_was_packed_comes_back() {
        for count in [0, 1, 1000, 300_000usize] {
            let bytes: Vec<u8> = (0..count).map(|i| (i * i / 7) as u8).collect();
            assert_eq!(unpack(&packed(&bytes)), Some(bytes));
        }
    }

    #[test]
    fn what_was_not_packed_or_is_cut_off_is_none() {
        let whole = packed(&[7; 5000]);
        for bytes in [&[][..], &whole[..5], &whole[..whole.len() - 9], b"<!doctype html> and so on"] {
            assert_eq!(unpack(bytes), None);
        }
    }
}
