//! The gate: each step is a command; tests are counted one by one, every other step as one.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

use crate::{explorer, programs, python, root};

/// How many checks passed, failed and were skipped.
#[derive(Default)]
pub struct Tally {
    pub passed: usize,
    pub failed: usize,
    pub skipped: usize,
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
    pdf_programs(&mut tally);
    // The extension module has its tests in Python.
    let tests = ["test", "--workspace", "--exclude", "standfast-python", "--no-fail-fast"];
    tally.count("unit, integration and documentation tests", &mut cargo(&tests), result_line);
    python::run(&mut tally);
    explorer::check(&mut tally);

    println!("\ntotal: {} passed, {} failed, {} skipped", tally.passed, tally.failed, tally.skipped);
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Sees that the programs which print a calculation sheet and read it back are there. Without them the tests of the PDF do
/// nothing: counted as skipped, and in CI as failed.
fn pdf_programs(tally: &mut Tally) {
    println!("── programs for PDFs");
    match programs::for_pdfs() {
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

pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

fn step(tally: &mut Tally, name: &str, arguments: &[&str], environment: &[(&str, &str)]) {
    tally.record(name, cargo(arguments).envs(environment.iter().copied()));
}

/// A command as one would type it.
fn line(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or(command.get_program());
    let words = std::iter::once(program).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

impl Tally {
    /// Runs a command that passes or fails as a whole; says which.
    pub fn record(&mut self, name: &str, command: &mut Command) -> bool {
        println!("── {name}: {}", line(command));
        match command.status() {
            Ok(status) if status.success() => {
                self.passed += 1;
                true
            }
            outcome => {
                println!("── {name} failed: {outcome:?}");
                self.failed += 1;
                false
            }
        }
    }

    /// Runs a command that counts its tests: `counts` reads how many passed, failed and were skipped from a line.
    pub fn count(&mut self, name: &str, command: &mut Command, counts: impl Fn(&str) -> Option<[usize; 3]>) {
        println!("── {name}: {}", line(command));
        let mut child = match command.stdout(Stdio::piped()).spawn() {
            Ok(child) => child,
            Err(error) => {
                println!("── {name} failed: {error}");
                self.failed += 1;
                return;
            }
        };
        let mut all_failed = 0;
        let output = BufReader::new(child.stdout.take().expect("standard output is piped"));
        for line in output.lines().map_while(Result::ok) {
            println!("{line}");
            if let Some([passed, failed, skipped]) = counts(&line) {
                self.passed += passed;
                all_failed += failed;
                self.skipped += skipped;
            }
        }
        // A test that does not compile or a crash fails without a count.
        let success = child.wait().is_ok_and(|status| status.success());
        self.failed += if success { all_failed } else { all_failed.max(1) };
    }
}

/// Passed, failed and ignored in cargo's line for the tests of a target.
fn result_line(line: &str) -> Option<[usize; 3]> {
    let counts = line.strip_prefix("test result: ")?;
    Some(["passed", "failed", "ignored"].map(|what| count(counts, what)))
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
