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

/// The first case that a reader copies is complete, and the same on both pages.
#[test]
fn the_complete_case_is_answered() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let cases = ["README.md", "docs/case-file.md"].map(|page| {
        let page = fs::read_to_string(root.join(page)).unwrap();
        let blocks: Vec<&str> =
            page.split("```toml\n").skip(1).filter_map(|block| block.split("```").next()).collect();
        let complete = |block: &&&str| block.contains("[body]") && block.contains("[[load]]");
        (*blocks.iter().find(complete).expect("a body with a load")).to_owned()
    });
    assert_eq!(cases[0], cases[1]);
    assert_eq!(cases[0].lines().count(), 9);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("my.toml"), &cases[0]).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_standfast"))
        .args(["assess", "my.toml"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", str::from_utf8(&output.stderr).unwrap());
    // The same body and load as in the transcript, entered by mass.
    assert!(str::from_utf8(&output.stdout).unwrap().contains("(SRO-)"));
}
