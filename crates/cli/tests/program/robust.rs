//! Whatever a case file contains, it is answered or refused: no panic, and every refusal can be shown.

use proptest::prelude::*;
use standfast_cases::{Acting, Assessment, CaseFile, View, point};

const CASE: &str = include_str!("../../../../examples/caisson-in-air.toml");
const CASES: [&str; 4] = [
    include_str!("../../../../examples/goda-2000.toml"),
    include_str!("../../../../examples/goda-lower-berm.toml"),
    include_str!("../../../../examples/head-difference.toml"),
    include_str!("../../../../examples/monument.toml"),
];

/// A text with a piece cut out and something else put in its place.
fn mutated(text: &'static str) -> impl Strategy<Value = Vec<u8>> {
    let bytes = text.as_bytes();
    let values = prop_oneof![
        any::<f64>().prop_map(|x| x.to_string()),
        Just("inf".to_owned()),
        Just("-1e999 m".to_owned()),
        Just("[[load]]".to_owned()),
        Just("\"".to_owned()),
        Just("\r\n\t\u{feff}é🌊".to_owned()),
        "\\PC{0,12}",
    ];
    (0..=bytes.len(), 0..20_usize, values).prop_map(move |(start, length, value)| {
        let end = (start + length).min(bytes.len());
        [&bytes[..start], value.as_bytes(), &bytes[end..]].concat()
    })
}

/// Numbers of every size the mechanics takes, and some beyond.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => (1.0..10.0, -52..52).prop_map(|(x, n)| x * 10_f64.powi(n)), 1 => 0.0..3.0, 1 => Just(0.0)]
}

fn try_case(text: &str) {
    match CaseFile::parse("case.toml", text).and_then(|file| file.case()) {
        // Answered, or refused by the mechanics as out of range.
        Ok(case) => {
            if let Ok(assessment) = Assessment::of(&case) {
                assert!(!assessment.json(&View::default(), &[]).is_empty());
            }
        }
        Err(error) => assert!(!standfast_cases::report(&error).is_empty()),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_text_is_no_case(text in any::<String>()) {
        try_case(&text);
    }

    #[test]
    fn mutated_cases(bytes in mutated(CASE)) {
        try_case(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn mutated_cases_of_all_loads(bytes in prop_oneof![
        mutated(CASES[0]), mutated(CASES[1]), mutated(CASES[2]), mutated(CASES[3]),
    ]) {
        try_case(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn extreme_cases(
        width in number(), height in number(), mass in number(), friction in number(), force in number(),
        share in 0.0..=1.0,
    ) {
        let text = format!(
            "[body]\nwidth={width:e}\nheight={height:e}\nmass={mass:e}\nfriction={friction:e}\n\
             [[load]]\nforce={force:e}\nelevation={:e}\n", share * height,
        );
        try_case(&text);
        let case = CaseFile::parse("case.toml", &text).and_then(|file| file.case());
        let reduced = case.ok().and_then(|case| case.situation(Acting::Alone(0), None).ok()?.in_air());
        if let Some(reduced) = reduced {
            assert!(!point::text(&reduced, true).is_empty());
            assert!(!point::json(&reduced).is_empty());
        }
    }
}

/// A closed pipe in the place of standard error, as `2>&1 | head` leaves it: the exit code is what remains.
#[test]
fn an_error_that_nobody_reads_is_an_exit_code() {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let program = env!("CARGO_BIN_EXE_standfast");
    let status = std::process::Command::new(program).args(["assess", "none.toml"]).stderr(writer).status();
    assert_eq!(status.expect("the program starts").code(), Some(1));
}
