//! Whatever a table of points holds, it is processed or refused with an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cli::batch::{OnError, Options, Problem, run};
use standfast_cli::report;

fuzz_target!(|bytes: &[u8]| {
    for problem in [Problem::Force, Problem::Wrench] {
        for on_error in [OnError::Stop, OnError::Null] {
            let options = Options { problem, on_error, ..Options::new("points.csv") };
            if let Err(error) = run(bytes, Vec::new(), &options) {
                assert!(!report(&error).is_empty());
            }
        }
    }
});
