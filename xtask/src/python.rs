//! The Python package: its wheel built in a clean environment, installed, its types checked, its tests run.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

use crate::tally::Tally;
use crate::{built, root, target};

/// The oldest Python for which the versions in requirements-test.txt exist.
const OLDEST: (u32, u32) = (3, 11);

/// Runs all steps, or says why not.
pub fn run(tally: &mut Tally) {
    let python = env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
    if let Err(reason) = usable(&python) {
        tally.missing("Python package", reason);
        return;
    }
    let place = target().join("python");
    let Some(python) = environment(tally, &python, &place) else { return };
    let Some(wheel) = wheel(tally, &python, &place) else { return };
    let pip =
        ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps"];
    if !tally.record("wheel installed", Command::new(&python).args(pip).arg(wheel)) {
        return;
    }
    let checks: [(&str, &[&str]); 3] = [
        ("types of the Python package", &["-m", "mypy", "--strict", "python/python/standfast"]),
        ("types of its use", &["-m", "mypy", "--strict", "python/tests/typing"]),
        ("stubs of the native module", &["-m", "mypy.stubtest", "standfast._standfast"]),
    ];
    for (name, arguments) in checks {
        tally.record(name, Command::new(&python).args(arguments).current_dir(root()));
    }
    let tests: [(&str, &[&str]); 2] = [
        (
            "examples in docstrings",
            &["-m", "pytest", "--quiet", "--doctest-modules", "--pyargs", "standfast"],
        ),
        ("tests of the Python package", &["-m", "pytest", "--quiet", "python/tests"]),
    ];
    for (name, arguments) in tests {
        let mut pytest = Command::new(&python);
        pytest.args(arguments).current_dir(root()).env("STANDFAST", built("standfast"));
        tally.count(name, &mut pytest, counts);
    }
}

/// Whether this Python can make an environment for the tests.
fn usable(python: &OsStr) -> Result<(), String> {
    let name = python.to_string_lossy();
    let probe = "import sys, venv, ensurepip; print(*sys.version_info[:2])";
    let output = Command::new(python).args(["-c", probe]).output().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => format!("{name} not found"),
        _ => format!("{name}: {error}"),
    })?;
    if !output.status.success() {
        let reason = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{name} has no pip or venv: {}", reason.lines().last().unwrap_or_default()));
    }
    let version = String::from_utf8_lossy(&output.stdout);
    match version.split_whitespace().map(str::parse).collect::<Result<Vec<u32>, _>>().as_deref() {
        Ok(&[major, minor]) if (major, minor) >= OLDEST => Ok(()),
        Ok(&[major, minor]) => {
            Err(format!("{name} is {major}.{minor}; the tests need {}.{} or later", OLDEST.0, OLDEST.1))
        }
        _ => Err(format!("{name} does not say its version")),
    }
}

/// The Python of an environment with what the tests need, and nothing else.
fn environment(tally: &mut Tally, python: &OsStr, place: &Path) -> Option<PathBuf> {
    let requirements = root().join("python/requirements-test.txt");
    let wanted = fs::read(&requirements).expect("the requirements are in the repository");
    let (folder, stamp) = (place.join("environment"), place.join("requirements-installed.txt"));
    let own = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if own.exists() && fs::read(&stamp).is_ok_and(|found| found == wanted) {
        return Some(own);
    }
    let made = tally
        .record("Python environment", Command::new(python).args(["-m", "venv", "--clear"]).arg(&folder))
        && tally.record(
            "Python requirements",
            Command::new(&own)
                .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement"])
                .arg(&requirements),
        );
    if made && let Err(error) = fs::write(&stamp, wanted) {
        println!("cannot write {}: {error}", stamp.display());
    }
    made.then_some(own)
}

/// Builds the wheel as `pip install ./python` does, in an environment that pip makes for it, but with the profile whose
/// crates the other steps have already built.
fn wheel(tally: &mut Tally, python: &Path, place: &Path) -> Option<PathBuf> {
    let wheels = place.join("wheels");
    // An older wheel is not to be taken for the new one.
    match fs::remove_dir_all(&wheels) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            println!("cannot empty {}: {error}", wheels.display())
        }
        _ => {}
    }
    let arguments =
        ["-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps", "--wheel-dir"];
    let mut build = Command::new(python);
    build.args(arguments).arg(&wheels).arg(root().join("python"));
    build.env("CARGO_TARGET_DIR", target()).env("MATURIN_PEP517_ARGS", "--profile dev");
    if !tally.record("wheel", &mut build) {
        return None;
    }
    let built = fs::read_dir(&wheels).ok()?.filter_map(Result::ok).map(|entry| entry.path());
    built.into_iter().find(|path| path.extension().is_some_and(|extension| extension == "whl"))
}

/// Passed, failed and skipped in pytest's last line, such as `2 failed, 71 passed, 1 skipped in 3.21s`.
fn counts(line: &str) -> Option<[usize; 3]> {
    let line = line.trim_matches(|c| c == '=' || c == ' ');
    let (counts, seconds) = line.rsplit_once(" in ")?;
    if !seconds.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let of = |kinds: &[&str]| {
        let found = counts.split(", ").filter_map(|part| part.split_once(' '));
        found
            .filter(|(_, kind)| kinds.contains(kind))
            .filter_map(|(count, _)| count.parse::<usize>().ok())
            .sum()
    };
    let found: [usize; 3] =
        [of(&["passed", "xfailed"]), of(&["failed", "error", "errors"]), of(&["skipped"])];
    (found != [0; 3]).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::counts;

    #[test]
    fn counts_are_read_from_pytests_last_line() {
        assert_eq!(counts("2 failed, 71 passed, 1 skipped, 3 warnings in 3.21s"), Some([71, 2, 1]));
        assert_eq!(counts("==== 9 passed in 0.52s ===="), Some([9, 0, 0]));
        assert_eq!(counts("1 error in 0.52s (0:01:02)"), Some([0, 1, 0]));
        assert_eq!(counts("written in 3 files"), None);
        assert_eq!(counts("no tests ran in 0.01s"), None);
    }
}
