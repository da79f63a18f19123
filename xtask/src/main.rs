//! Everything CI does, runnable by hand: `cargo xtask test`, `cargo xtask gallery`, `cargo xtask explorer`.

#![forbid(unsafe_code)]

mod arm;
mod book;
mod checks;
mod dist;
mod explorer;
mod lints;
mod manifests;
mod programs;
mod python;
mod pythons;
mod sea_states;
mod tally;
mod targets;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const HELP: &str = "\
Usage: cargo xtask COMMAND

  test      format, lints, documentation, all tests: everything CI does; `test python` and `test explorer` run
            these parts alone
  deny      licences, advisories, sources and duplicates of all dependencies, by cargo-deny
  arm       the tests of exact signs on an emulated 64-bit ARM, and the library checked for Windows and macOS
  gallery   write docs/reference/gallery.md with its figures and the example of a calculation sheet
  python-versions  all tests of the Python package with every Python it promises to run under, as far as they are found
  dist      build what is handed on into target/dist: programs, packages, wheels, the explorer, with their sums; about an
            hour. --only NAME builds one of them, and may be given again; --try runs the first lines of people who have
            what was built and none of our tools
  book      build the book of docs into target/book, and as one file; --open opens it in the browser
  explorer  build the explorer, one HTML file, and serve it on this machine; --open opens it in the browser
  sea-states N  print a table of N synthetic sea states for examples/goda-2000.toml, whose first 100 are examples/sea-states.csv
  help      this text
";

fn main() -> ExitCode {
    if let Some(ended) = lints::wrapper(std::env::args_os().skip(1)) {
        return ended;
    }
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test"] => checks::run(),
        ["test", "python"] => checks::Part::Python.run(),
        ["test", "explorer"] => checks::Part::Explorer.run(),
        ["python-versions"] => checks::Part::PythonVersions.run(),
        ["arm"] => arm::run(),
        ["dist", "--try"] => ended(dist::try_first_lines()),
        ["dist", ref options @ ..] => ended(only(options).and_then(|names| dist::run(&names))),
        ["deny"] => ended(manifests::deny()),
        ["gallery"] => ended(ran(&mut tally::cargo(&["run", "--quiet", "--package", "xtask-docs"]))),
        ["book"] => ended(book::build(false).map(drop)),
        ["book", "--open"] => ended(book::build(true).map(drop)),
        ["explorer"] => ended(explorer::serve(false)),
        ["explorer", "--open"] => ended(explorer::serve(true)),
        ["sea-states", count] => ended(
            count
                .parse()
                .map(|count| print!("{}", sea_states::table(count)))
                .map_err(|_| format!("cargo xtask sea-states {count}: expected how many")),
        ),
        ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        _ => {
            eprint!("cargo xtask: unknown command: {arguments:?}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

/// The names of `--only`.
fn only<'a>(options: &[&'a str]) -> Result<Vec<&'a str>, String> {
    let pair = |pair: &[&'a str]| match pair {
        ["--only", name] => Ok(*name),
        _ => Err(format!("cargo xtask dist: expected --only NAME, not {}", pair.join(" "))),
    };
    options.chunks(2).map(pair).collect()
}

fn ended(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Runs a command to its end.
fn ran(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{command:?}: {status}")),
        Err(error) => Err(format!("{command:?}: {error}")),
    }
}

/// The repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the repository").to_owned()
}

/// Folder into which cargo builds.
fn target() -> PathBuf {
    root().join(std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// A program of the workspace, as an earlier step has built it.
fn built(name: &str) -> PathBuf {
    target().join("debug").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}
