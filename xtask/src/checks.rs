//! The gate: each step is a command; cargo's tests are counted one by one, every other step as one.

use std::io::{BufRead, BufReader};
use std::process::{Command, ExitCode, Stdio};

use crate::{browser, root};

#[derive(Default)]
struct Tally {
    passed: usize,
    failed: usize,
    skipped: usize,
}

/// Runs all steps, also after one has failed, and ends with the count.
pub fn run() -> ExitCode {
    let mut tally = Tally::default();
    step(&mut tally, "format", &["fmt", "--all", "--check"], &[]);
    let clippy = ["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"];
    step(&mut tally, "lints", &clippy, &[]);
    let doc = ["doc", "--workspace", "--no-deps", "--quiet"];
    step(&mut tally, "documentation", &doc, &[("RUSTDOCFLAGS", "--deny warnings")]);
    // Without libFuzzer itself, which wants a C++ compiler: the targets are to keep compiling.
    let fuzz = [
        "check",
        "--manifest-path",
        "fuzz/Cargo.toml",
        "--no-default-features",
        "--target-dir",
        "target/fuzz",
        "--quiet",
    ];
    step(&mut tally, "fuzz targets", &fuzz, &[]);
    programs(&mut tally);
    tests(
        &mut tally,
        "unit, integration and documentation tests",
        &["test", "--workspace", "--no-fail-fast"],
    );

    println!("\ntotal: {} passed, {} failed, {} skipped", tally.passed, tally.failed, tally.skipped);
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Sees that the programs which print a calculation sheet and read it back are there. Without them the tests of the PDF do
/// nothing: counted as skipped, and in CI as failed.
fn programs(tally: &mut Tally) {
    println!("── programs for PDFs");
    match browser::for_pdfs() {
        Ok(browser) => println!("{}", browser.display()),
        Err(missing) => {
            println!("── {missing}: the tests of printed sheets are skipped");
            if std::env::var_os("CI").is_some_and(|ci| ci == "true") {
                tally.failed += 1;
            } else {
                tally.skipped += 1;
            }
        }
    }
}

fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

/// A command that passes or fails as a whole.
fn step(tally: &mut Tally, name: &str, arguments: &[&str], environment: &[(&str, &str)]) {
    println!("── {name}: cargo {}", arguments.join(" "));
    let status = cargo(arguments).envs(environment.iter().copied()).status();
    match status {
        Ok(status) if status.success() => tally.passed += 1,
        outcome => {
            println!("── {name} failed: {outcome:?}");
            tally.failed += 1;
        }
    }
}

/// `cargo test`, with its tests added to the tally.
fn tests(tally: &mut Tally, name: &str, arguments: &[&str]) {
    println!("── {name}: cargo {}", arguments.join(" "));
    let child = cargo(arguments).stdout(Stdio::piped()).spawn();
    let mut child = match child {
        Ok(child) => child,
        Err(error) => {
            println!("── {name} failed: {error}");
            tally.failed += 1;
            return;
        }
    };
    let mut failed = 0;
    let output = BufReader::new(child.stdout.take().expect("standard output is piped"));
    for line in output.lines().map_while(Result::ok) {
        println!("{line}");
        if let Some(counts) = line.strip_prefix("test result: ") {
            tally.passed += count(counts, "passed");
            failed += count(counts, "failed");
            tally.skipped += count(counts, "ignored");
        }
    }
    // A test that does not compile or a crash fails without a count.
    let success = child.wait().is_ok_and(|status| status.success());
    tally.failed += if success { failed } else { failed.max(1) };
}

/// The number before `what` in a line such as `ok. 12 passed; 0 failed; 1 ignored; …`.
fn count(line: &str, what: &str) -> usize {
    let words: Vec<&str> = line.split_whitespace().collect();
    let number = words.windows(2).find(|pair| pair[1].trim_end_matches(';') == what).map(|pair| pair[0]);
    number.and_then(|number| number.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::count;

    #[test]
    fn counts_are_read_from_the_result_line() {
        let line = "ok. 12 passed; 3 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.05s";
        assert_eq!(["passed", "failed", "ignored", "none"].map(|what| count(line, what)), [12, 3, 1, 0]);
    }
}
