//! Tally of the checks that passed, failed and were skipped, and the running of commands.

use std::fmt::Display;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::root;

/// Numbers of checks that passed, failed and were skipped.
#[derive(Default)]
pub struct Tally {
    pub passed: usize,
    pub failed: usize,
    pub skipped: usize,
}

/// True in CI: what is missing there is installed, and nothing is skipped.
pub fn in_ci() -> bool {
    std::env::var_os("CI").is_some_and(|ci| ci == "true")
}

/// The cargo that runs this.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    command
}

/// Seconds of processor time that ended commands have taken, where the system tells.
fn processor_time() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name, which may hold spaces: the 14th and 15th are those of waited-for children, in hundredths.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = |i: usize| fields.get(i)?.parse::<f64>().ok();
    Some((ticks(13)? + ticks(14)?) / 100.0)
}

/// Says how much processor time `work` took.
pub fn timed<T>(name: &str, work: impl FnOnce() -> T) -> T {
    let before = processor_time();
    let done = work();
    if let Some(seconds) = before.zip(processor_time()).map(|(before, after)| after - before) {
        println!("── {name}: {seconds:.0} s of processor time");
    }
    done
}

/// A command as one would type it.
pub fn line(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_name().unwrap_or(command.get_program());
    let words = std::iter::once(program).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

impl Tally {
    /// Adds how many checks passed, failed and were skipped elsewhere.
    pub fn add(&mut self, [passed, failed, skipped]: [usize; 3]) {
        self.passed += passed;
        self.failed += failed;
        self.skipped += skipped;
    }

    /// Runs a command that passes or fails as a whole; says which.
    pub fn record(&mut self, name: &str, command: &mut Command) -> bool {
        println!("── {name}: {}", line(command));
        match timed(name, || command.status()) {
            Ok(status) if status.success() => {
                self.passed += 1;
                true
            }
            outcome => {
                self.fail(name, format!("{outcome:?}"));
                false
            }
        }
    }

    /// Counts a check that is no command.
    pub fn outcome(&mut self, name: &str, outcome: Result<(), String>) {
        match outcome {
            Ok(()) => {
                println!("── {name}");
                self.passed += 1;
            }
            Err(reason) => self.fail(name, reason),
        }
    }

    /// Counts what did not work, and says why.
    pub fn fail(&mut self, name: &str, reason: impl Display) {
        println!("── {name} failed: {reason}");
        self.failed += 1;
    }

    /// Counts what cannot be checked because something is not there: skipped on a user's machine, failed in CI, where
    /// nothing may be skipped.
    pub fn missing(&mut self, name: &str, reason: impl Display) {
        if in_ci() {
            self.fail(name, reason);
        } else {
            println!("── {name} SKIPPED: {reason}");
            self.skipped += 1;
        }
    }

    /// Runs a command that counts its tests: `counts` reads how many passed, failed and were skipped from a line.
    pub fn count(&mut self, name: &str, command: &mut Command, counts: impl Fn(&str) -> Option<[usize; 3]>) {
        println!("── {name}: {}", line(command));
        timed(name, || self.counted(name, command, counts));
    }

    fn counted(&mut self, name: &str, command: &mut Command, counts: impl Fn(&str) -> Option<[usize; 3]>) {
        let mut child = match command.stdout(Stdio::piped()).spawn() {
            Ok(child) => child,
            Err(error) => {
                self.fail(name, error);
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
