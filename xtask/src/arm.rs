//! Other processors and systems: the tests of exact signs on a 64-bit ARM, emulated, and the library compiled for Windows and macOS.

use std::path::Path;
use std::process::ExitCode;

use crate::checks::{ended, result_line};
use crate::programs::{found, needed};
use crate::tally::{Tally, cargo, in_ci};
use crate::targets;

const ARM: &str = "aarch64-unknown-linux-gnu";

/// Systems for which the library is checked without a linker or a system to run it on.
const ELSEWHERE: [&str; 3] = ["x86_64-pc-windows-msvc", "x86_64-apple-darwin", "aarch64-apple-darwin"];

/// The part of the gate by itself.
pub fn run() -> ExitCode {
    let mut tally = Tally::default();
    check(&mut tally);
    ended(&tally)
}

/// Tests the kernel and the single call on ARM, at a share of their random points, and checks the library for other systems.
pub fn check(tally: &mut Tally) {
    const NAME: &str = "exact signs on ARM";
    // Objects that a program is linked with and begins by come in a package of their own.
    const PACKAGES: [&str; 3] = ["qemu-user", "gcc-aarch64-linux-gnu", "libc6-dev-arm64-cross"];
    let programs = needed("an emulator and linker for 64-bit ARM", &PACKAGES, || {
        let links = Path::new("/usr/aarch64-linux-gnu/lib/crt1.o").is_file();
        found("qemu-aarch64").and(found("aarch64-linux-gnu-gcc")).filter(|_| links)
    });
    match (programs, target(ARM)) {
        (Err(missing), _) => tally.missing(NAME, missing),
        (_, Err(missing)) => tally.missing(NAME, missing),
        _ => {
            let mut tests =
                cargo(&["test", "--package", "standfast", "--test", "exactness", "--target", ARM]);
            tests
                .env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER", "aarch64-linux-gnu-gcc")
                .env(
                    "CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER",
                    "qemu-aarch64 -L /usr/aarch64-linux-gnu",
                )
                .env("STANDFAST_TRIES", "0.02");
            tally.count(NAME, &mut tests, result_line);
        }
    }
    for system in ELSEWHERE {
        let name = format!("the library for {system}");
        match target(system) {
            Ok(()) => {
                let check = ["check", "--quiet", "--package", "standfast", "--target", system];
                tally.record(&name, &mut cargo(&check));
            }
            Err(missing) => tally.missing(&name, missing),
        }
    }
}

/// Sees that Rust can compile for a target; in CI it is added.
fn target(name: &str) -> Result<(), String> {
    if in_ci() {
        targets::added(name)
    } else if targets::has(name) {
        Ok(())
    } else {
        Err(targets::missing(name))
    }
}
