//! Lints and documentation while the tests are compiled.
//!
//! `cargo clippy` and `cargo doc` take no dependency that has been compiled to be linked: each would compile all of them once
//! more. So the gate has cargo call this program in place of rustc for the crates of the workspace. It calls rustc, then clippy
//! and rustdoc with the same dependencies; cargo keeps what they say beside what is compiled, and says it again each time.

use std::ffi::OsString;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::LazyLock;
use std::{env, fs, io, process};

use serde_json::Value;

use crate::tally::{Tally, line, timed};
use crate::target;

/// Name of this program where it stands for rustc.
const NAME: &str = "rustc-with-lints";

/// Variable that names the program that cargo takes in place of rustc for the crates of the workspace.
const WRAPPER: &str = "RUSTC_WORKSPACE_WRAPPER";

/// Has `command`, which is cargo or starts it, compile with lints.
pub fn beside(command: &mut Command) -> &mut Command {
    // Before this program itself is compiled anew, and its file gone.
    static COPY: LazyLock<io::Result<PathBuf>> = LazyLock::new(copy);
    match &*COPY {
        Ok(copy) => command.env(WRAPPER, copy),
        Err(error) => {
            println!("── no lints: {error}");
            command
        }
    }
}

/// A copy of this program that stays while cargo compiles this program anew: the one that has been made for the whole gate, or a
/// new one. Cargo compiles all again if its path changes.
fn copy() -> io::Result<PathBuf> {
    let made = env::var_os(WRAPPER).map(PathBuf::from);
    if let Some(made) = made.filter(|made| made.file_stem().is_some_and(|stem| stem == NAME)) {
        return Ok(made);
    }
    let folder = target().join("gate");
    let copy = folder.join(format!("{NAME}{}", env::consts::EXE_SUFFIX));
    let own = fs::read(env::current_exe()?)?;
    if !fs::read(&copy).is_ok_and(|found| found == own) {
        fs::create_dir_all(&folder)?;
        let new = folder.join(format!("{NAME}-{}", process::id()));
        fs::copy(env::current_exe()?, &new)?;
        fs::rename(new, &copy)?;
    }
    Ok(copy)
}

/// Does the work of rustc, if this program is called as it.
pub fn wrapper(arguments: impl Iterator<Item = OsString>) -> Option<ExitCode> {
    let own = env::current_exe().ok()?;
    if own.file_stem()? != NAME {
        return None;
    }
    let arguments: Vec<OsString> = arguments.collect();
    let (rustc, arguments) = arguments.split_first()?;
    match compiled(Path::new(rustc), arguments, own.parent()?) {
        Ok(true) => Some(ExitCode::SUCCESS),
        Ok(false) => Some(ExitCode::FAILURE),
        Err(error) => {
            eprintln!("{error}");
            Some(ExitCode::FAILURE)
        }
    }
}

/// Compiles a crate, lints and documents it; whether all that succeeded, which it does also with warnings.
fn compiled(rustc: &Path, arguments: &[OsString], folder: &Path) -> Result<bool, String> {
    let succeeds = |command: &mut Command| match command.status() {
        Ok(status) => Ok(status.success()),
        Err(error) => Err(format!("{}: {error}", command.get_program().display())),
    };
    let mut compiler = Command::new(rustc);
    compiler.args(arguments);
    // Cargo also asks what rustc can do, of no crate or one of this name.
    let asks = !arguments.iter().any(|argument| argument == "--crate-name")
        || arguments.iter().any(|argument| argument == "___");
    if asks {
        return succeeds(&mut compiler);
    }
    // Clippy says what rustc would.
    if !succeeds(compiler.args(["--cap-lints", "allow"]))? {
        return Ok(false);
    }
    let mut clippy = Command::new(rustc.with_file_name("clippy-driver"));
    let linted = succeeds(clippy.arg(rustc).args(linted(arguments, folder)))?;
    if !is_documented(arguments) {
        return Ok(linted);
    }
    let mut rustdoc = Command::new(rustc.with_file_name("rustdoc"));
    Ok(succeeds(rustdoc.args(documented(arguments, folder)))? && linted)
}

/// True if the crate is to be documented. A library or program is compiled for its own tests and for others: the first will do.
/// The extension module has no tests of its own.
fn is_documented(arguments: &[OsString]) -> bool {
    let is_test = arguments.iter().any(|argument| argument == "--test");
    // Cargo sets this for tests and benchmarks outside of the crate they are of.
    let is_outside = env::var_os("CARGO_TARGET_TMPDIR").is_some();
    let of_python = env::var_os("CARGO_PKG_NAME").is_some_and(|name| name == "standfast-python");
    !is_outside && (is_test || of_python)
}

/// Arguments of clippy where rustc is called with `arguments`: it leaves its metadata in `folder`.
fn linted(arguments: &[OsString], folder: &Path) -> Vec<OsString> {
    let mut kept = Vec::new();
    for (flag, value) in flags(arguments) {
        match (flag.to_str().unwrap_or_default(), value) {
            ("--out-dir", _) => kept.extend(["--out-dir".into(), folder.join("lints").into()]),
            // Those of rustc.
            ("-C", Some(value)) if value.to_string_lossy().starts_with("incremental=") => {}
            (text, _) if text.starts_with("--emit=") => kept.push("--emit=metadata".into()),
            // Cargo would take its metadata for rustc's.
            (text, _) if text.starts_with("--json=") => kept.push("--json=diagnostic-rendered-ansi".into()),
            _ => kept.extend([flag].into_iter().chain(value).cloned()),
        }
    }
    kept
}

/// Arguments of rustdoc where rustc is called with `arguments`: it writes to `folder`.
fn documented(arguments: &[OsString], folder: &Path) -> Vec<OsString> {
    let mut kept = Vec::new();
    for (flag, value) in flags(arguments) {
        match flag.to_str().unwrap_or_default() {
            "--out-dir" => kept.extend(["--out-dir".into(), folder.join("doc").into()]),
            "-C" | "--test" => {}
            text if text.starts_with("--emit=") => {}
            text if text.starts_with("--json=") => kept.push("--json=diagnostic-rendered-ansi".into()),
            // Nothing of a program is public.
            text if text.ends_with("main.rs") => {
                kept.extend([flag.clone(), "--document-private-items".into()]);
            }
            _ => kept.extend([flag].into_iter().chain(value).cloned()),
        }
    }
    kept
}

/// Arguments of rustc, each with its value where that is an argument of its own.
fn flags(arguments: &[OsString]) -> impl Iterator<Item = (&OsString, Option<&OsString>)> {
    let mut rest = arguments.iter();
    std::iter::from_fn(move || {
        let flag = rest.next()?;
        let takes =
            ["-C", "-L", "--out-dir", "--crate-name", "--crate-type", "--cfg", "--check-cfg", "--extern"];
        let value = if takes.iter().any(|takes| flag == takes) { rest.next() } else { None };
        Some((flag, value))
    })
}

/// Compiles by `command`, a cargo, and counts lints and documentation apart.
pub fn record(tally: &mut Tally, name: &str, command: &mut Command) {
    println!("── {name}: {}", line(command));
    let outcome = timed(name, || said(command.args(["--message-format", "json-diagnostic-rendered-ansi"])));
    match outcome {
        Ok((found, compiled)) => {
            tally.outcome(name, if compiled { Ok(()) } else { Err("it does not compile".to_owned()) });
            let verdict = |count| if count == 0 { Ok(()) } else { Err(format!("{count} warnings")) };
            tally.outcome("lints", verdict(found.lints));
            tally.outcome("documentation", verdict(found.documentation));
        }
        Err(error) => tally.fail(name, error),
    }
}

/// Number of warnings and errors of clippy and of rustdoc.
#[derive(Debug, Default, PartialEq)]
struct Warnings {
    lints: usize,
    documentation: usize,
}

impl Warnings {
    /// Counts what a line of cargo's says; the text to show.
    fn read(&mut self, line: &str) -> Option<String> {
        let said: Value = serde_json::from_str(line).ok()?;
        if said["reason"] != "compiler-message" {
            return None;
        }
        let message = &said["message"];
        if ["warning", "error"].iter().any(|level| message["level"] == *level) {
            let code = message["code"]["code"].as_str().unwrap_or_default();
            *(if code.starts_with("rustdoc::") { &mut self.documentation } else { &mut self.lints }) += 1;
        }
        Some(message["rendered"].as_str()?.to_owned())
    }
}

/// Runs cargo; what was found, and whether it compiled.
fn said(command: &mut Command) -> Result<(Warnings, bool), String> {
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|error| error.to_string())?;
    let mut found = Warnings::default();
    let output = BufReader::new(child.stdout.take().expect("standard output is piped"));
    for line in output.lines().map_while(Result::ok) {
        if let Some(text) = found.read(&line) {
            print!("{text}");
        }
    }
    let status = child.wait().map_err(|error| error.to_string())?;
    Ok((found, status.success()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<OsString> {
        text.split_whitespace().map(OsString::from).collect()
    }

    const RUSTC: &str = "--crate-name a --edition=2024 src/main.rs --error-format=json --json=diagnostic-rendered-ansi,artifacts \
        --emit=dep-info,metadata,link -C opt-level=1 --warn=missing_docs -C incremental=/t/inc --test --cfg feature=\"x\" \
        --out-dir /t/deps -L dependency=/t/deps --extern b=/t/deps/libb.rlib";

    #[test]
    fn clippy_has_the_arguments_of_rustc_and_leaves_its_files_alone() {
        let expected = "--crate-name a --edition=2024 src/main.rs --error-format=json --json=diagnostic-rendered-ansi \
            --emit=metadata -C opt-level=1 --warn=missing_docs --test --cfg feature=\"x\" \
            --out-dir /gate/lints -L dependency=/t/deps --extern b=/t/deps/libb.rlib";
        assert_eq!(linted(&words(RUSTC), Path::new("/gate")), words(expected));
    }

    #[test]
    fn rustdoc_has_what_it_knows_of_the_arguments_of_rustc() {
        let expected = "--crate-name a --edition=2024 src/main.rs --document-private-items --error-format=json \
            --json=diagnostic-rendered-ansi --warn=missing_docs --cfg feature=\"x\" \
            --out-dir /gate/doc -L dependency=/t/deps --extern b=/t/deps/libb.rlib";
        assert_eq!(documented(&words(RUSTC), Path::new("/gate")), words(expected));
    }

    #[test]
    fn warnings_are_counted_by_who_gave_them() {
        let mut found = Warnings::default();
        let line = |level: &str, code: &str| {
            let message = serde_json::json!({"level": level, "code": {"code": code}, "rendered": "text"});
            serde_json::json!({"reason": "compiler-message", "message": message}).to_string()
        };
        assert_eq!(found.read(&line("warning", "clippy::eq_op")).as_deref(), Some("text"));
        found.read(&line("error", "E0308"));
        found.read(&line("warning", "rustdoc::broken_intra_doc_links"));
        found.read(&line("note", "clippy::eq_op"));
        assert_eq!(found.read(r#"{"reason": "compiler-artifact"}"#), None);
        assert_eq!(found.read("no JSON"), None);
        assert_eq!(found, Warnings { lints: 2, documentation: 1 });
    }
}
