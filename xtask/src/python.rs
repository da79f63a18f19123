//! The Python package: its wheel built in a clean environment, installed, its types checked, its tests run.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use crate::pythons::{self, OLDEST, Python};
use crate::tally::{Tally, cargo, line, timed};
use crate::{built, lints, root, target};

/// Options of pip, to print no more than is wanted.
const PIP: [&str; 4] = ["-m", "pip", "--quiet", "--disable-pip-version-check"];

/// Runs all steps, or says why not.
pub fn run(tally: &mut Tally) {
    let Some(python) = Python::of_path() else {
        tally.missing("Python package", "no Python 3.10 or later with pip and venv; PYTHON names one");
        return;
    };
    let Some((own, wheel)) = built_wheel(tally, &python) else { return };
    if !install(tally, &own, &wheel) {
        return;
    }
    let checks: [(&str, &[&str]); 3] = [
        ("types of the Python package", &["-m", "mypy", "--strict", "python/python/standfast"]),
        ("types of its use", &["-m", "mypy", "--strict", "python/tests/typing"]),
        ("stubs of the native module", &["-m", "mypy.stubtest", "standfast._standfast"]),
    ];
    for (name, arguments) in checks {
        // The oldest Python has libraries of its time, whose types are others.
        if python.version > OLDEST {
            tally.record(name, Command::new(&own).args(arguments).current_dir(root()));
        }
    }
    let doctest = ["-m", "pytest", "--quiet", "--doctest-modules", "--pyargs", "standfast"];
    tests(tally, "examples in docstrings", &own, &doctest);
    tests(tally, "tests of the Python package", &own, &["-m", "pytest", "--quiet", "python/tests"]);
    smoke(tally, &python, &wheel);
}

/// All tests with every Python that is promised, the oldest with the oldest libraries.
pub fn all_versions(tally: &mut Tally) {
    let Some(main) = Python::of_path() else {
        tally.missing("Python package", "no Python 3.10 or later with pip and venv; PYTHON names one");
        return;
    };
    let Some((_, wheel)) = built_wheel(tally, &main) else { return };
    for version in pythons::promised() {
        let name = format!("Python {}.{}", version.0, version.1);
        let Some(python) = Python::of_version(version) else {
            tally.missing(&name, "not found, on the path or in pyenv");
            continue;
        };
        let Some(own) = environment(tally, &python, main.version) else { continue };
        if install(tally, &own, &wheel) {
            tests(tally, &name, &own, &["-m", "pytest", "--quiet", "python/tests"]);
        }
    }
}

/// With numpy alone, under the oldest and the newest Python there is beside the one of all other tests.
fn smoke(tally: &mut Tally, main: &Python, wheel: &Path) {
    let mut others: Vec<Python> = pythons::promised().filter_map(Python::of_version).collect();
    others.retain(|python| python.version != main.version);
    if others.is_empty() {
        println!("── no other Python to try the wheel with");
    }
    // The oldest and the newest.
    let between = 1..others.len().saturating_sub(1).max(1);
    others.drain(between);
    for python in others {
        let (major, minor) = python.version;
        let folder = place().join(format!("smoke-{major}.{minor}"));
        let pins = root().join(requirements(python.version));
        let pins = ["--constraint".into(), pins.into_os_string(), "numpy".into(), "pytest".into()];
        let name = format!("numpy alone, Python {major}.{minor}");
        let Some(own) = made(tally, &python, &folder, &pins) else { continue };
        if install(tally, &own, wheel) {
            let smoke = ["-m", "pytest", "--quiet", "--noconftest", "python/tests/test_smoke.py"];
            tests(tally, &name, &own, &smoke);
        }
    }
}

/// Folder of environments and wheels.
fn place() -> PathBuf {
    target().join("python")
}

/// Requirements of the tests: pinned versions, those of the oldest libraries for the oldest Python.
fn requirements(version: (u32, u32)) -> &'static str {
    if version == OLDEST { "python/requirements-oldest.txt" } else { "python/requirements-test.txt" }
}

/// The Python of the main environment, and the wheel that it has built.
fn built_wheel(tally: &mut Tally, python: &Python) -> Option<(PathBuf, PathBuf)> {
    let own = environment(tally, python, python.version)?;
    let wheel = wheel(tally, &own, &place())?;
    Some((own, wheel))
}

fn install(tally: &mut Tally, python: &Path, wheel: &Path) -> bool {
    let mut pip = Command::new(python);
    pip.args(PIP).args(["install", "--force-reinstall", "--no-deps"]).arg(wheel);
    tally.record("wheel installed", &mut pip)
}

fn tests(tally: &mut Tally, name: &str, python: &Path, arguments: &[&str]) {
    let mut pytest = Command::new(python);
    pytest.args(arguments).current_dir(root()).env("STANDFAST", built("standfast"));
    tally.count(name, &mut pytest, counts);
}

/// The Python of an environment with what the tests need, and nothing else.
fn environment(tally: &mut Tally, python: &Python, main: (u32, u32)) -> Option<PathBuf> {
    let (major, minor) = python.version;
    let other = format!("environment-{major}.{minor}");
    let folder = place().join(if python.version == main { "environment" } else { &other });
    let file = root().join(requirements(python.version));
    made(tally, python, &folder, &["--requirement".into(), file.into_os_string()])
}

/// The Python of an environment with what pip installs by these arguments, made anew only when a file they name has changed.
fn made(tally: &mut Tally, python: &Python, folder: &Path, arguments: &[OsString]) -> Option<PathBuf> {
    let files = arguments.iter().filter_map(|argument| fs::read(argument).ok());
    let mut wanted = python.program.clone().into_encoded_bytes();
    files.for_each(|file| wanted.extend(file));
    let stamp = folder.join("requirements-installed.txt");
    let own = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if own.exists() && fs::read(&stamp).is_ok_and(|found| found == wanted) {
        return Some(own);
    }
    let venv = ["-m", "venv", "--clear"];
    let made = tally.record("Python environment", Command::new(&python.program).args(venv).arg(folder))
        && tally.record("Python requirements", Command::new(&own).args(PIP).arg("install").args(arguments));
    if made && let Err(error) = fs::write(&stamp, wanted) {
        println!("cannot write {}: {error}", stamp.display());
    }
    made.then_some(own)
}

/// Builds the wheel as `pip install ./python` does, in an environment that pip makes for it, but with the profile and the features
/// whose crates the other steps have already built.
fn wheel(tally: &mut Tally, python: &Path, place: &Path) -> Option<PathBuf> {
    let wheels = place.join("wheels");
    // An older wheel is not to be taken for the new one.
    match fs::remove_dir_all(&wheels) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            println!("cannot empty {}: {error}", wheels.display())
        }
        _ => {}
    }
    let mut build = Command::new(python);
    // With what cargo says.
    build.args(PIP.iter().filter(|argument| **argument != "--quiet"));
    build.args(["--verbose", "wheel", "--no-deps", "--wheel-dir"]).arg(&wheels).arg(root().join("python"));
    build.env("CARGO_TARGET_DIR", target()).env("MATURIN_PEP517_ARGS", "--profile dev --features gate");
    build.env("CARGO_TERM_COLOR", "never");
    println!("── wheel: {}", line(&build));
    let said = match timed("wheel", || lints::beside(&mut build).output()) {
        Ok(output) if output.status.success() => {
            tally.passed += 1;
            [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat()
        }
        Ok(output) => {
            print!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            tally.fail("wheel", output.status);
            return None;
        }
        Err(error) => {
            tally.fail("wheel", error);
            return None;
        }
    };
    tally.outcome("lints of the extension module", no_warnings(&said));
    tally.outcome("nothing compiled again for the wheel", compiled_once(&said));
    let built = fs::read_dir(&wheels).ok()?.filter_map(Result::ok).map(|entry| entry.path());
    built.into_iter().find(|path| path.extension().is_some_and(|extension| extension == "whl"))
}

/// Fails with what cargo `said` if it warned of a crate.
fn no_warnings(said: &str) -> Result<(), String> {
    let warns = said.lines().any(|line| line.trim_start().starts_with("warning: `standfast"));
    if warns { Err(format!("\n{said}")) } else { Ok(()) }
}

/// Fails if cargo `said` that it compiles what it has compiled for the tests: a dependency has other features there.
fn compiled_once(said: &str) -> Result<(), String> {
    let mut tree = cargo(&["tree", "--prefix", "none", "--edges", "normal,build,dev", "--format", "{p}"]);
    tree.args(["--workspace", "--exclude", "standfast-python", "--features", "standfast-cli/full"]);
    let output = tree.output().map_err(|error| format!("cargo tree: {error}"))?;
    let again = twice(&String::from_utf8_lossy(&output.stdout), said);
    if again.is_empty() {
        return Ok(());
    }
    Err(format!(
        "{}: the feature `gate` in python/Cargo.toml is to give them the features they have",
        again.join(", ")
    ))
}

/// The crates of a registry in cargo's `tree` that it `said` it compiles.
fn twice<'a>(tree: &str, said: &'a str) -> Vec<&'a str> {
    let crates: BTreeSet<&str> =
        tree.lines().map(|line| line.trim_end_matches(" (*)").trim_end_matches(" (proc-macro)")).collect();
    let compiles = said.lines().filter_map(|line| line.trim_start().strip_prefix("Compiling "));
    compiles.map(str::trim_end).filter(|name| !name.contains('(') && crates.contains(name)).collect()
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
    use super::{counts, no_warnings, twice};

    #[test]
    fn what_the_wheel_compiles_again_is_named() {
        let tree = "standfast v0.1.0 (/s)\nserde v1.0.2 (*)\nsyn v2.0.1 (proc-macro) (*)\nmemchr v2.8.3\n";
        let said = "  Compiling syn v2.0.1\n   Compiling pyo3 v0.30.0\n Compiling serde v1.0.20\n Compiling memchr v2.8.3\n\
                    \x20  Compiling standfast v0.1.0 (/s)\n";
        assert_eq!(twice(tree, said), ["syn v2.0.1", "memchr v2.8.3"]);
        assert!(twice(tree, "Compiling pyo3 v0.30.0").is_empty());
    }

    #[test]
    fn a_warning_of_the_extension_module_is_seen() {
        assert!(no_warnings("  warning: `standfast-python` (lib) generated 1 warning\n").is_err());
        assert_eq!(no_warnings("  Compiling standfast-python v0.1.0\n  Finished `dev` profile\n"), Ok(()));
    }

    #[test]
    fn counts_are_read_from_pytests_last_line() {
        assert_eq!(counts("2 failed, 71 passed, 1 skipped, 3 warnings in 3.21s"), Some([71, 2, 1]));
        assert_eq!(counts("==== 9 passed in 0.52s ===="), Some([9, 0, 0]));
        assert_eq!(counts("1 error in 0.52s (0:01:02)"), Some([0, 1, 0]));
        assert_eq!(counts("written in 3 files"), None);
        assert_eq!(counts("no tests ran in 0.01s"), None);
    }
}
