//! Sources of a case, and the errors of one that cannot be read or shown.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use super::batch::files;

const CASE: &str = include_str!("../../../../examples/goda-2000.toml");

/// The program in a folder, with a text on its standard input.
fn run(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_standfast"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // One that does not read it goes on without.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    child.wait_with_output().expect("the program ends")
}

fn words(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Read from a file or from standard input, a case has the same answer in every command.
#[test]
fn a_case_may_come_from_standard_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    fs::write(here.join("goda.toml"), CASE).expect("a file");
    // A file of that name is another matter.
    fs::write(here.join("-"), "[body]\n").expect("a file");
    let commands: [&[&str]; 3] = [
        &["assess", "CASE", "-o", "figures"],
        &["design", "CASE", "--vary", "width", "--target", "factor=1.2"],
        &["sheet", "CASE", "-o", "sheet.html"],
    ];
    for command in commands {
        let [of_file, of_input] = ["goda.toml", "-"].map(|case| {
            let arguments: Vec<_> =
                command.iter().map(|word| if *word == "CASE" { case } else { word }).collect();
            let output = run(here, &arguments, CASE.as_bytes());
            assert!(output.status.success(), "{arguments:?}: {}", words(&output.stderr));
            words(&output.stdout).replace("goda", "case")
        });
        assert_eq!(of_file, of_input);
    }
    let sheet = fs::read_to_string(here.join("sheet.html")).expect("a sheet");
    assert!(sheet.contains("<td>standard input</td>"));
    assert_eq!(
        files(&here.join("figures")),
        ["case-path.svg", "case-section.svg", "case.svg", "goda-path.svg", "goda-section.svg", "goda.svg"]
    );

    // Without a folder for them, the figures are here.
    assert!(run(here, &["assess", "-"], CASE.as_bytes()).status.success());
    assert_eq!(
        files(here),
        ["-", "case-path.svg", "case-section.svg", "case.svg", "figures", "goda.toml", "sheet.html"]
    );
}

#[test]
fn errors_of_a_case_from_standard_input_say_where_it_comes_from() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = |input: &[u8]| {
        let output = run(folder.path(), &["design", "-", "--vary", "width", "--target", "rest"], input);
        assert_eq!(output.status.code(), Some(1));
        words(&output.stderr)
    };
    assert!(said(b"").contains("standard input is empty"));
    assert!(said(b"[body]\nwidth = \"15 kg\"\n").contains("--> standard input:2:9\n"));
    assert!(said(b"[body]\n# \xff\n").contains("standard input is not UTF-8 text: line 2"));
    assert_eq!(files(folder.path()), [""; 0]);
}

#[test]
fn what_cannot_be_written_is_said_once() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("taken"), "").expect("a file");
    let output = run(folder.path(), &["assess", "-", "-o", "taken"], CASE.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    let said = words(&output.stderr);
    assert_eq!(said.matches("cannot write taken").count(), 1, "{said}");
    assert!(said.contains("-o DIR"), "{said}");
}

/// However long the line that is wrong, the error fits a screen and names the place.
#[test]
fn an_error_is_short_where_the_file_is_not() {
    let many = 20_000;
    let long = "x".repeat(many);
    let ahead = "title = \"{}\", ".len();
    for (text, place) in [
        ("[".repeat(many), ":1:"),
        (format!("a = {}", "[".repeat(many)), ":1:"),
        (format!("a = {}1", "{b = ".repeat(many)), ":1:"),
        (format!("{long} = 1\n"), ":1:1\n"),
        (format!("[body]\nwidth = \"1 {long}\"\n"), ":2:9\n"),
        (format!("body = {{ title = \"{long}\", width = 1 }}\n"), ":1:10\n"),
        (format!("load = {{ name = \"{long}\" }}\n"), ":1:8\n"),
        (format!("body = {{ width = {}1 }}\n", " ".repeat(many)), ":1:"),
        (format!("title = \"{long}\" x\n"), &format!(":1:{}\n", many + ahead - 2)),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let output = run(folder.path(), &["assess", "-"], text.as_bytes());
        assert_eq!(output.status.code(), Some(1), "{}", &text[..40]);
        let said = words(&output.stderr);
        assert!(said.len() < 2500, "{} bytes: {}…", said.len(), said.chars().take(2000).collect::<String>());
        assert!(said.contains(&format!("--> standard input{place}")), "{said}");
    }
}
