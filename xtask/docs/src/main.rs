//! Writes the pages and figures of docs that come from the program itself; its tests hold all pages against the code. A crate of
//! its own, so that `cargo xtask` itself is compiled in a moment.

#![forbid(unsafe_code)]

mod chances;
mod gallery;
mod keys;
#[cfg(test)]
mod traceability;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    match gallery::write(&root()) {
        Ok(count) => {
            println!("{count} files written");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The repository.
fn root() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    root.expect("the crate lies in the folder xtask of the repository").to_owned()
}
