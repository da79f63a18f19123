//! Whatever a case file holds, it is a case or an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cases::{Case, report};

fuzz_target!(|text: &str| {
    if let Err(error) = Case::parse("case.toml", text) {
        assert!(!report(&error).is_empty());
    }
});
