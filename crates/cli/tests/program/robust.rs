//! Whatever a case file contains, it is answered or refused: no panic, and every refusal can be shown.

use proptest::prelude::*;
use standfast_cases::case::Trial;
use standfast_cases::{Acting, Assessment, AssessmentView, CaseFile, Document, point};

use crate::mutated::{mutated, number};

/// Text that may stand where it should not.
const ODD: &[&str] = &["-1e999 m", "[[load]]"];

const CASE: &str = include_str!("../../../../examples/caisson-in-air.toml");
const CASES: [&str; 4] = [
    include_str!("../../../../examples/goda-2000.toml"),
    include_str!("../../../../examples/goda-lower-berm.toml"),
    include_str!("../../../../examples/head-difference.toml"),
    include_str!("../../../../examples/monument.toml"),
];

fn try_case(text: &str) {
    match CaseFile::parse("case.toml", text).and_then(|file| file.case()) {
        // Answered, or refused by the mechanics as out of range.
        Ok(case) => {
            if let Ok(assessment) = Assessment::of(&case) {
                assert!(!assessment.json(&AssessmentView::default(), &[]).is_empty());
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
    fn mutated_cases(bytes in mutated(CASE, ODD)) {
        try_case(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn mutated_cases_of_all_loads(bytes in prop_oneof![
        mutated(CASES[0], ODD), mutated(CASES[1], ODD), mutated(CASES[2], ODD), mutated(CASES[3], ODD),
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
        let reduced = case.ok().and_then(|case| case.situation(Acting::Alone(0), Trial::AS_GIVEN).ok()?.in_air());
        if let Some(reduced) = reduced {
            let reduced = point::PlacedPoint::new(reduced, 0.0).unwrap();
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
