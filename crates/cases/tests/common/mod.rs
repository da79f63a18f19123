//! Cases from text, their answers and refusals, and numbers of them.
#![allow(dead_code)]

use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::{Assessed, Assessment, CaseFile, Explained};

pub fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

pub fn assess(text: &str) -> Assessment {
    let case = file(text).case().unwrap_or_else(|error| panic!("{error}: {text}"));
    Assessment::of(&case).unwrap()
}

pub fn refused(text: &str) -> String {
    let error = CaseFile::parse("case.toml", text).and_then(|file| file.case()).unwrap_err();
    format!("{error}; {}", error.help().unwrap_or_default())
}

pub fn number(assessed: &Assessed, result: ResultName) -> f64 {
    match result.of(assessed) {
        ResultValue::Number(number) => number,
        other => panic!("{} is {other:?}", result.name()),
    }
}

pub fn near(found: f64, expected: f64, by: f64) {
    let is_near = found == expected || (found - expected).abs() <= by * expected.abs();
    assert!(is_near, "{found}, expected {expected}");
}

/// To six digits.
pub fn six(found: f64, expected: f64) {
    near(found, expected, 5e-6);
}
