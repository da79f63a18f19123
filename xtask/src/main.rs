//! Everything CI does, runnable by hand: `cargo xtask test`, `cargo xtask gallery`.

#![forbid(unsafe_code)]

mod browser;
mod checks;
mod gallery;
#[cfg(test)]
mod traceability;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const HELP: &str = "\
Usage: cargo xtask COMMAND

  test      format, lints, documentation, all tests: everything CI does
  gallery   write docs/gallery.md with its figures and the example of a calculation sheet
  help      this text
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["test"] => checks::run(),
        ["gallery"] => match gallery::write(&root()) {
            Ok(count) => {
                println!("{count} files written");
                ExitCode::SUCCESS
            }
            Err(error) => {
                eprintln!("{error}");
                ExitCode::FAILURE
            }
        },
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

/// The repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the repository").to_owned()
}
