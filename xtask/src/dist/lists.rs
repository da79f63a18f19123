//! Lists of what is handed on: what it is and what was seen of it, its sums, the licences and names of what it is made of.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use super::toolchain::Toolchain;
use super::{System, output, script, version};
use crate::root;
use crate::tally::cargo;

const STATES: &str = "STATES.txt";
const SUMS: &str = "SHA256SUMS";

/// Notes what was seen of a file, beside what is known of the others.
pub fn note(folder: &Path, file: &Path, state: &str) -> Result<(), String> {
    let path = folder.join(STATES);
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let text = fs::read_to_string(&path).unwrap_or_default();
    let mut states: BTreeMap<String, String> = text
        .lines()
        .filter_map(|line| line.split_once(": "))
        .map(|(name, state)| (name.to_owned(), state.to_owned()))
        .filter(|(name, _)| folder.join(name).is_file())
        .collect();
    states.insert(name, state.to_owned());
    let text: String = states.iter().map(|(name, state)| format!("{name}: {state}\n")).collect();
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// Writes the sums of all files.
pub fn sums(folder: &Path) -> Result<(), String> {
    let found = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> = found
        .filter_map(Result::ok)
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| ![STATES, SUMS].contains(&name.as_str()))
        .collect();
    names.sort();
    let sums = output(Command::new("sha256sum").args(&names).current_dir(folder))?;
    let path = folder.join(SUMS);
    fs::write(&path, sums).map_err(|error| format!("{}: {error}", path.display()))
}

/// Writes the licences of what a program is made of, and its bill of materials, into a folder.
pub fn materials(toolchain: &Toolchain, system: &System, folder: &Path) -> Result<(), String> {
    let package =
        ["--package", "standfast-cli", "--features", "full", "--edges", "normal", "--prefix", "none"];
    let tree = output(cargo(&["tree", "--target", system.triple]).args(package))?;
    // `name v1.2.3 (proc-macro)`, and of this repository a path behind it.
    let crates: String = tree
        .lines()
        .filter_map(|line| {
            let mut words = line.split_whitespace();
            Some(format!("{} {}\n", words.next()?, words.next()?.strip_prefix('v')?))
        })
        .collect();
    let list = folder.join("crates.txt");
    fs::write(&list, crates).map_err(|error| format!("{}: {error}", list.display()))?;
    let metadata = output(&mut cargo(&["metadata", "--format-version", "1", "--locked"]))?;
    let mut python = script(toolchain, "third_party.py");
    python.args(["standfast", version()]).arg(&list);
    python.arg(folder.join("THIRD-PARTY.txt")).arg(folder.join("standfast.cdx.json"));
    let mut child =
        python.current_dir(root()).stdin(Stdio::piped()).spawn().map_err(|error| error.to_string())?;
    let mut input = child.stdin.take().ok_or("no pipe")?;
    input.write_all(metadata.as_bytes()).map_err(|error| error.to_string())?;
    drop(input);
    let status = child.wait().map_err(|error| error.to_string())?;
    fs::remove_file(&list).map_err(|error| error.to_string())?;
    if status.success() { Ok(()) } else { Err(format!("licences: {status}")) }
}
