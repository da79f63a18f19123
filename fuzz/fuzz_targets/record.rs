//! Whatever a record file holds, CSV, AT2 or SMC, it is a record or an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cases::motion::Record;

fuzz_target!(|text: &str| {
    for name in ["record.csv", "record.AT2", "record.smc"] {
        match Record::parse(name, text, None, None) {
            Ok(record) => {
                // Its times rise and its numbers are finite, so that it is a history, or too short for one.
                assert!(record.values.iter().all(|value| value.is_finite()));
                let _ = record.history(1.0);
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
});
