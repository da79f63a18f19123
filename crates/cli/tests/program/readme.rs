//! The commands the README shows print what the README says they print.

use std::path::Path;
use std::process::Command;
use std::{fs, str};

use crate::book::pages::{blocks, commands, stands_in};

/// Command line and output of every block of the console.
fn transcripts(page: &str) -> Vec<(&str, &str)> {
    blocks(page)
        .into_iter()
        .filter(|block| block.language == "console")
        .flat_map(|block| commands(block.text))
        .collect()
}

#[test]
fn transcripts_are_real() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("README.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_standfast"))
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(output.status.success(), "{arguments}: {}", str::from_utf8(&output.stderr).unwrap());
        String::from_utf8(output.stdout).unwrap()
    };
    run("new --examples");

    let transcripts = transcripts(&page);
    assert!(!transcripts.is_empty());
    for (command, expected) in transcripts {
        let arguments =
            command.strip_prefix("cargo run --release -- ").expect("a command a new user can run");
        let output = run(arguments);
        assert!(stands_in(&output, expected), "{command}: {output}");
        let first = expected.split("…\n").next().unwrap_or_default();
        assert!(output.starts_with(first) && expected.lines().count() > 6, "{command}");
    }
    assert!(folder.path().join("examples/block.svg").exists());

    // Every command in the text runs as it stands, with the examples beside it.
    let mut count = 0;
    for command in page.split('`').filter_map(|code| code.strip_prefix("standfast ")) {
        if !command.contains("--path") && !command.contains("CASE") && command.contains(' ') {
            run(command);
            count += 1;
        }
    }
    assert!(count > 6, "{count}");
}

/// The first case that a reader copies is complete, and the same on both pages.
#[test]
fn the_complete_case_is_answered() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let cases = ["README.md", "docs/reference/keys.md"].map(|page| {
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
    assert!(str::from_utf8(&output.stdout).unwrap().contains("(SRO-)"));
    // It is an example of that name.
    assert_eq!(fs::read_to_string(root.join("examples/block.toml")).unwrap(), cases[0]);
}
