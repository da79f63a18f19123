//! The gate: each step is a command; tests are counted one by one, every other step as one.

use std::fs::{self, File};
use std::io;
use std::path::PathBuf;
use std::process::{Child, Command, ExitCode};

use crate::tally::{Tally, cargo};
use crate::{arm, book, built, explorer, lints, manifests, programs, python, target};

/// All crates with all they can do. The steps select the same crates with the same features, and only by their kind what they need
/// of them: a dependency whose features differ from step to step would be compiled again and again.
const EVERYTHING: [&str; 3] = ["--workspace", "--features", "standfast-python/gate,standfast-cli/full"];

/// Runs all steps, also after one has failed, and ends with the count.
pub fn run() -> ExitCode {
    let mut tally = Tally::default();
    tally.record("format", &mut cargo(&["fmt", "--all", "--check"]));
    manifests::check(&mut tally);
    left_out(&mut tally);
    pdf_programs(&mut tally);
    lints::record(&mut tally, "programs and tests", &mut programs_and_tests());
    // Python's tests keep one core busy; those of a browser want both, because a page waits for nobody.
    let python = ParallelPart::start(Part::Python);
    let mut tests = cargo(&["test", "--no-fail-fast"]);
    lints::beside(tests.args(EVERYTHING));
    tally.count("unit, integration and documentation tests", &mut tests, result_line);
    arm::check(&mut tally);
    python.end(&mut tally);
    book::check(&mut tally);
    explorer::check(&mut tally);
    ended(&tally)
}

/// Part of the gate that can be run by itself.
#[derive(Clone, Copy)]
pub enum Part {
    Python,
    PythonVersions,
    Explorer,
}

impl Part {
    /// As on the command line.
    fn name(self) -> &'static str {
        match self {
            Part::Python => "python",
            Part::PythonVersions => "python-versions",
            Part::Explorer => "explorer",
        }
    }

    /// Builds what the part needs and runs its steps.
    pub fn run(self) -> ExitCode {
        let mut tally = Tally::default();
        tally.record("programs and tests", &mut programs_and_tests());
        match self {
            Part::Python => python::run(&mut tally),
            Part::PythonVersions => python::all_versions(&mut tally),
            Part::Explorer => explorer::check(&mut tally),
        }
        ended(&tally)
    }
}

/// A part that runs beside the gate's own steps, and says nothing before it is asked.
struct ParallelPart {
    part: Part,
    /// The process, and where it writes.
    running: io::Result<(Child, PathBuf)>,
}

impl ParallelPart {
    fn start(part: Part) -> ParallelPart {
        let start = || {
            let path = target().join(format!("gate-{}.txt", part.name()));
            let output = File::create(&path)?;
            let mut xtask = Command::new(built("xtask"));
            xtask.args(["test", part.name()]).stderr(output.try_clone()?).stdout(output);
            Ok((lints::beside(&mut xtask).spawn()?, path))
        };
        ParallelPart { part, running: start() }
    }

    /// Waits for its end, shows what it wrote and adds what it counted.
    fn end(self, tally: &mut Tally) {
        let name = self.part.name();
        let ended = self.running.and_then(|(mut process, path)| {
            process.wait()?;
            fs::read(path)
        });
        match ended {
            Ok(output) => {
                let output = String::from_utf8_lossy(&output);
                let (steps, total) = output.rsplit_once("\ntotal: ").unwrap_or((&output, ""));
                println!("{steps}");
                match ["passed", "failed", "skipped"].map(|what| count(&total.replace(',', ";"), what)) {
                    [0, 0, 0] => tally.fail(name, "it ended before its count"),
                    counts => tally.add(counts),
                }
            }
            Err(error) => tally.fail(name, error),
        }
    }
}

/// Checks what is compiled by other commands: the program as a first command compiles it, without libraries' features
/// that nobody has asked for, and what is fuzzed, without libFuzzer itself, which wants a C++ compiler. That these
/// compile is all there is to see; what they do is seen of the same sources where all is compiled.
fn left_out(tally: &mut Tally) {
    let check = ["check", "--quiet", "--target-dir"];
    let mut small = cargo(&check);
    tally.record("program without features", small.arg(target()).args(["--package", "standfast-cli"]));
    let mut fuzz = cargo(&check);
    fuzz.arg(target()).args([
        "--manifest-path",
        "fuzz/Cargo.toml",
        "--no-default-features",
        "--features",
        "gate",
    ]);
    tally.record("fuzz targets", &mut fuzz);
}

/// Compiles all that the tests run, and lints and documents it. The extension module is compiled by the step of its wheel, and has
/// its tests in Python.
fn programs_and_tests() -> Command {
    let mut build = cargo(&["build", "--quiet", "--bins", "--tests", "--benches"]);
    lints::beside(build.args(EVERYTHING));
    build
}

/// Ends with the count.
pub fn ended(tally: &Tally) -> ExitCode {
    println!("\ntotal: {} passed, {} failed, {} skipped", tally.passed, tally.failed, tally.skipped);
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Sees that the programs which print a calculation sheet and read it back are there. Without them the tests of the PDF do
/// nothing.
fn pdf_programs(tally: &mut Tally) {
    println!("── programs for PDFs");
    match programs::for_pdfs() {
        Ok(browser) => println!("{}", browser.display()),
        Err(missing) => tally.missing("tests of printed sheets", missing),
    }
}

/// Passed, failed and ignored in cargo's line for the tests of a target.
pub fn result_line(line: &str) -> Option<[usize; 3]> {
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
