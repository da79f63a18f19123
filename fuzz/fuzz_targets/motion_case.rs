//! Whatever a case in time holds, it is followed to an end or refused with an error that can be shown.

#![no_main]

use libfuzzer_sys::fuzz_target;
use standfast_cases::motion::{Follow, FollowedMotion, MotionView};
use standfast_cases::{CaseFile, Document, report};

const RECORD: &str = "time_s,a_g\n0,0\n0.1,0.4\n0.2,-0.3\n0.3,0\n";

fuzz_target!(|text: &str| {
    let file = CaseFile::read("case.toml", text, &|_: &str| Ok(RECORD.to_owned()));
    match file.and_then(|file| FollowedMotion::of_file(&file, &Follow::default())) {
        Ok(answers) => {
            assert!(answers.iter().all(|followed| !followed.outcome.events.is_empty()));
            assert!(!answers.text(&MotionView::default()).is_empty());
        }
        Err(error) => assert!(!report(&error).is_empty()),
    }
});
