//! Pythons that are there: the one that `PYTHON` or the path names, and those of each version that the package promises.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

/// The oldest Python that the package promises to run under; its tests have requirements of their own.
pub const OLDEST: (u32, u32) = (3, 10);
/// The newest.
const NEWEST: (u32, u32) = (3, 13);

/// An interpreter that can make an environment.
#[derive(Debug)]
pub struct Python {
    pub program: OsString,
    pub version: (u32, u32),
}

/// All versions that the package promises to run under.
pub fn promised() -> impl Iterator<Item = (u32, u32)> {
    (OLDEST.1..=NEWEST.1).map(|minor| (OLDEST.0, minor))
}

impl Python {
    /// The one that `PYTHON` names, or else the path's.
    pub fn of_path() -> Option<Python> {
        let program = env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
        let version = version(&program).filter(|&version| version >= OLDEST)?;
        Some(Python { program, version })
    }

    /// One of a version: from the path, or of those that pyenv has installed.
    pub fn of_version(wanted: (u32, u32)) -> Option<Python> {
        let on_path = OsString::from(format!("python{}.{}", wanted.0, wanted.1));
        let candidates = std::iter::once(on_path).chain(of_pyenv(wanted));
        let mut found = candidates.filter(|program| version(program) == Some(wanted));
        found.next().map(|program| Python { program, version: wanted })
    }
}

/// Those that pyenv has installed, the latest first.
fn of_pyenv((major, minor): (u32, u32)) -> impl Iterator<Item = OsString> {
    let home = || env::var_os("HOME").map(|home| PathBuf::from(home).join(".pyenv"));
    let root = env::var_os("PYENV_ROOT").map(PathBuf::from).or_else(home);
    let installed = root.and_then(|root| fs::read_dir(root.join("versions")).ok()).into_iter().flatten();
    let prefix = format!("{major}.{minor}.");
    let mut found: Vec<(u32, PathBuf)> = installed
        .filter_map(Result::ok)
        .filter_map(|entry| {
            let patch = entry.file_name().to_str()?.strip_prefix(&prefix)?.parse().ok()?;
            Some((patch, entry.path().join("bin/python")))
        })
        .collect();
    found.sort();
    found.into_iter().rev().map(|(_, path)| path.into_os_string())
}

/// Major and minor version of an interpreter with pip and venv.
fn version(program: &OsStr) -> Option<(u32, u32)> {
    let probe = "import sys, venv, ensurepip; print(*sys.version_info[:2])";
    let output = Command::new(program).args(["-c", probe]).output().ok()?;
    let said = String::from_utf8(output.stdout).ok().filter(|_| output.status.success())?;
    match said.split_whitespace().map(str::parse).collect::<Result<Vec<u32>, _>>().as_deref() {
        Ok(&[major, minor]) => Some((major, minor)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::promised;
    use crate::root;

    #[test]
    fn the_package_promises_the_versions_that_are_tested() {
        let manifest = root().join("python/pyproject.toml");
        let manifest = std::fs::read_to_string(manifest).expect("the manifest of the package");
        let named: BTreeSet<(u32, u32)> = manifest
            .lines()
            .filter_map(|line| {
                let version = line.split_once("Python :: 3.")?.1.split('"').next()?;
                Some((3, version.parse().ok()?))
            })
            .collect();
        assert_eq!(named, promised().collect());
        assert!(manifest.contains("requires-python = \">=3.10\""));
    }
}
