//! Every block of the book does what the page says: commands print what stands below them, cases are read, keys exist.

#[path = "../../../../xtask/docs/src/pages.rs"]
#[allow(dead_code, reason = "the crate that makes the book uses the rest")]
pub mod pages;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use pages::{Block, Files, Toml, blocks, commands, stands_in};
use standfast_cases::CaseFile;

/// What an error says of a part that is wrong, and not only a part.
const PARTS_ARE_NOT: [&str; 3] = ["not valid TOML", "has no key", "expected"];

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

/// Words of a command, with what stands between quotes as one.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for letter in command.chars() {
        match (quote, letter) {
            (None, '"' | '\'') => quote = Some(letter),
            (Some(open), letter) if letter == open => quote = None,
            (None, ' ') => words.push(String::new()),
            _ => words.last_mut().expect("one word").push(letter),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Runs a command of a page in its reader's folder. One that fails is one of which the page shows the error.
fn run(folder: &Path, command: &str, expected: &str) -> Result<String, String> {
    let mut words = words(command);
    if words.first().map(String::as_str) != Some("standfast") {
        return Err(format!("{command}: a block of the console runs `standfast`"));
    }
    let output =
        Command::new(env!("CARGO_BIN_EXE_standfast")).args(words.drain(1..)).current_dir(folder).output();
    let output = output.map_err(|error| error.to_string())?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let shown = text(&output.stdout) + &text(&output.stderr);
    let is_right = output.status.success() || expected.contains("error") || command.contains("--check");
    if is_right { Ok(shown) } else { Err(format!("{command}: {shown}")) }
}

/// A page read by somebody who types all of it; everything on which he stumbles.
fn follow(page: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mut files = Files::default();
    let mut faults = Vec::new();
    for Block { line, language, text } in blocks(page) {
        let mut fault = |words: String| faults.push(format!("line {line}: {words}"));
        match language {
            "console" => {
                for (command, expected) in commands(text) {
                    match run(folder, command, expected) {
                        Ok(output) if stands_in(&output, expected) => {}
                        Ok(output) => fault(format!("`{command}` prints\n{output}")),
                        Err(error) => fault(error),
                    }
                }
            }
            "toml" => {
                // What a command wrote is changed as it stands.
                if let Toml::Change(name, _) = Toml::of(text)
                    && let Ok(written) = fs::read_to_string(folder.join(name))
                {
                    files.add(name, written);
                }
                match files.take(text) {
                    Ok(Some(name)) => fs::write(folder.join(name), files.text(name).unwrap()).unwrap(),
                    // A part lacks what a whole has; what it has, a case knows.
                    Ok(None) => match CaseFile::parse("a part", text).and_then(|file| file.case()) {
                        Err(error) if PARTS_ARE_NOT.iter().any(|is| error.to_string().contains(is)) => {
                            fault(error.to_string());
                        }
                        _ => {}
                    },
                    Err(error) => fault(error),
                }
            }
            // Tests of the crates, of the package and of the builder of the book have these.
            "rust" | "python" | "formula" => {}
            "text" | "json" | "sh" | "html" => {}
            other => fault(format!(
                "a block of `{other}`: expected console, toml, rust, python, formula, text, json, sh or html"
            )),
        }
    }
    faults
}

#[test]
fn every_block_of_the_book_does_what_the_page_says() {
    let pages = pages::all(&docs()).unwrap();
    assert!(pages.len() > 35, "{}", pages.len());
    let mut commands = 0;
    let mut faults = Vec::new();
    for path in pages {
        let page = fs::read_to_string(&path).unwrap();
        commands += blocks(&page).iter().filter(|block| block.language == "console").count();
        let name = path.strip_prefix(docs()).unwrap().display().to_string();
        faults.extend(follow(&page).into_iter().map(|fault| format!("docs/{name}, {fault}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(commands > 20, "{commands}");
}

#[test]
fn a_reader_stumbles_where_a_page_is_wrong() {
    let right = "```toml\n# a.toml\n[body]\nwidth = 3\nheight = 2\nmass = 12e3\nfriction = 0.6\n[[load]]\nforce = 1e3\nelevation = 1\n```\n\
        ```console\n$ standfast assess a.toml --no-figures\n…\n```\n";
    let shown = follow(right);
    assert_eq!(shown, Vec::<String>::new());
    for (from, to) in [
        ("friction = 0.6", "friktion = 0.6"),
        ("…\n", "The body flies.\n"),
        ("standfast assess", "rm"),
        ("```toml", "```tomato"),
    ] {
        assert!(!follow(&right.replace(from, to)).is_empty(), "{to}");
    } // A part of a file is no whole, but its keys are there.
    for (part, stumbles) in
        [("width = 3", false), ("witdh = 3", true), ("width 3", true), ("width = \"3 kg\"", true)]
    {
        assert_eq!(!follow(&format!("```toml\n[body]\n{part}\n```\n")).is_empty(), stumbles, "{part}");
    }
}
