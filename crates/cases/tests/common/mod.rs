//! Cases from text, their answers and refusals, and numbers of them.
#![allow(dead_code)]

use standfast_cases::random::{ChanceRequest, Effort, Probability, ProbabilityError};
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

/// At γ = 0.5 pushed at its middle a block slides where k exceeds μ; it does not rock below k = 2. Behind it stand random numbers.
pub const POINT: &str = "[point]\ngamma = 0.5\nk_prime = 0\nmu = 0.5\nk = 0.3\n[random]\n";

/// The probabilities of a text to a precision, or why there are none.
pub fn try_chances(text: &str, precision: f64) -> Result<Probability, ProbabilityError> {
    let effort = Effort { precision, ..Effort::default() };
    let file = CaseFile::parse("case.toml", text)?;
    Probability::of(&file, ChanceRequest { effort, ..ChanceRequest::default() })
}

/// Those of the block with these random numbers.
pub fn chances_at_point(random: &str, precision: f64) -> Probability {
    try_chances(&format!("{POINT}{random}"), precision)
        .unwrap_or_else(|error| panic!("{random}\n{}", standfast_cases::report(&error)))
}

/// ∫ φ(z) f(z) dz by the trapezoidal rule.
pub fn mean(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1.0 / 128.0;
    let density = |z: f64| (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
    (-1152..=1152).map(|i| f64::from(i) * h).map(|z| h * density(z) * f(z)).sum()
}
