//! Systems that Rust compiles for: whether their standard library is there, and rustup, which adds it.

use std::fs;
use std::process::{Command, Stdio};

use crate::root;

/// True if rustc has the standard library of a system.
pub fn has(system: &str) -> bool {
    let mut rustc = Command::new("rustc");
    rustc.args(["--print", "target-libdir", "--target", system]).current_dir(root());
    rustc.output().is_ok_and(|output| {
        let folder = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        fs::read_dir(folder).is_ok_and(|mut files| files.next().is_some())
    })
}

/// Adds the standard library of a system by rustup, unless it is there.
///
/// # Errors
/// If it is not there afterwards.
pub fn added(system: &str) -> Result<(), String> {
    if has(system) {
        return Ok(());
    }
    println!("── rustup target add {system}");
    let mut rustup = Command::new("rustup");
    let status = rustup.args(["target", "add", system]).current_dir(root()).stdin(Stdio::null()).status();
    if status.is_ok_and(|status| status.success()) && has(system) { Ok(()) } else { Err(missing(system)) }
}

/// Says what adds the standard library of a system.
pub fn missing(system: &str) -> String {
    format!("there is no compiler for {system}; `rustup target add {system}` adds it")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_system_of_this_machine_is_there_and_one_that_rust_does_not_know_is_not() {
        let rustc = Command::new("rustc").arg("-vV").output().expect("rustc");
        let said = String::from_utf8(rustc.stdout).expect("text");
        let host = said.lines().find_map(|line| line.strip_prefix("host: ")).expect("its system");
        assert!(has(host) && !has("m68k-commodore-amigaos"));
    }
}
