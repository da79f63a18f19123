//! Whatever a table of points holds, it is processed or refused with an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cases::report;
use standfast_tables::{OnError, TableOptions, TableProblem, run};

fuzz_target!(|bytes: &[u8]| {
    for problem in [TableProblem::Force, TableProblem::Wrench] {
        for on_error in [OnError::Stop, OnError::Null] {
            let options = TableOptions { problem, on_error, ..TableOptions::new("points.csv") };
            if let Err(error) = run(bytes, Vec::new(), &options) {
                assert!(!report(&error).is_empty());
            }
        }
    }
});
