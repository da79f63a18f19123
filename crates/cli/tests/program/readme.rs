//! The commands the README shows print what the README says they print.

use std::path::Path;
use std::process::Command;
use std::{fs, str};

/// Command line and output of every block that begins with `$ `.
fn transcripts(page: &str) -> Vec<(&str, &str)> {
    let blocks = page.split("```").skip(1).step_by(2);
    let bodies = blocks.filter_map(|block| block.split_once('\n').map(|(_, body)| body));
    bodies.filter_map(|body| body.strip_prefix("$ ")?.split_once('\n')).collect()
}

#[test]
fn transcripts_are_real() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("README.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let examples = folder.path().join("examples");
    fs::create_dir(&examples).unwrap();
    let files = fs::read_dir(root.join("examples")).unwrap().map(Result::unwrap);
    for entry in files.filter(|entry| entry.path().is_file()) {
        fs::copy(entry.path(), examples.join(entry.file_name())).unwrap();
    }

    let transcripts = transcripts(&page);
    assert!(!transcripts.is_empty());
    for (command, expected) in transcripts {
        let arguments =
            command.strip_prefix("cargo run --release -- ").expect("a command a new user can run");
        let output = Command::new(env!("CARGO_BIN_EXE_standfast"))
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(output.status.success(), "{command}: {}", str::from_utf8(&output.stderr).unwrap());
        assert_eq!(str::from_utf8(&output.stdout).unwrap(), expected, "{command}");
    }
    assert!(examples.join("caisson-in-air.svg").exists());
}
