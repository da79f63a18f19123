//! Whatever a case file holds, it is a case or an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cases::{CaseFile, report};

fuzz_target!(|text: &str| {
    if let Err(error) = CaseFile::parse("case.toml", text).and_then(|file| file.case()) {
        assert!(!report(&error).is_empty());
    }
});
