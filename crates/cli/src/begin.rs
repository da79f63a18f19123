//! `standfast new`: a case to begin from, or all examples.

use std::path::{Path, PathBuf};

use standfast_cases::beginnings::Beginning;

use crate::args::NewArgs;
use crate::error::{CommandError, Result};
use crate::files_read::FilesRead;
use crate::write::{make_directory, write_file};

macro_rules! examples {
    ($($path:literal)*) => {
        [$(($path, include_bytes!(concat!("../../../examples/", $path)).as_slice())),*]
    };
}

/// The examples: where each lies in their folder, and what it holds.
pub const EXAMPLES: [(&str, &[u8]); 37] = examples! {
    "block-two-loads.toml"
    "block.toml"
    "breaking-wave.toml"
    "caisson-in-air.toml"
    "caisson-of-parts.toml"
    "caisson-on-stone.toml"
    "crown-wall.toml"
    "eccentric-caisson.toml"
    "goda-2000-random.toml"
    "goda-2000-storm.toml"
    "goda-2000.toml"
    "goda-lower-berm.toml"
    "goda-on-sand.toml"
    "head-difference.toml"
    "marble-drum.toml"
    "monument-on-mortar.toml"
    "monument.toml"
    "motion/block-base-pulse.toml"
    "motion/block-under-a-record.toml"
    "motion/caisson-breaking-wave.toml"
    "motion/caisson-church-roof.toml"
    "motion/marble-column-earthquake.toml"
    "motion/server-rack-earthquake.toml"
    "motion/statue-earthquake.toml"
    "points.csv"
    "probability/column-records.toml"
    "probability/plane-random.toml"
    "quay.toml"
    "records/README.md"
    "records/np01002p_4225a_a.smc"
    "records/np01002p_4225b_a.smc"
    "records/np01002p_4225c_a.smc"
    "sea-states.csv"
    "seismic-block.toml"
    "server-rack.toml"
    "statue-random.toml"
    "trough.toml"
};

/// Does what `standfast new` was asked, and gives back what it prints.
///
/// # Errors
/// If a file is there already, or cannot be written.
pub fn begin(args: &NewArgs) -> Result<String> {
    match (args.kind, &args.output) {
        (Some(kind), None) => Ok(kind.text.to_owned()),
        (Some(kind), Some(path)) => {
            write_new(path, kind)?;
            Ok(format!("{} written to {}\n", kind.title, path.display()))
        }
        (None, _) => examples(args.examples.as_deref().unwrap_or(Path::new("examples"))),
    }
}

/// Writes a case to a file that is not there yet.
fn write_new(path: &Path, kind: &Beginning) -> Result<()> {
    refuse_existing(path)?;
    write_file(path, kind.text.as_bytes(), &FilesRead::default())
}

/// Writes all examples into a folder in which none of them is yet.
fn examples(folder: &Path) -> Result<String> {
    let files: Vec<(PathBuf, &[u8])> =
        EXAMPLES.iter().map(|(path, bytes)| (folder.join(path), *bytes)).collect();
    for (path, _) in &files {
        refuse_existing(path)?;
    }
    for (path, bytes) in &files {
        make_directory(path.parent().unwrap_or(folder))?;
        write_file(path, bytes, &FilesRead::default())?;
    }
    Ok(format!("{} examples written to {}\n", files.len(), folder.display()))
}

/// Someone may have worked in a file that is there.
fn refuse_existing(path: &Path) -> Result<()> {
    match path.try_exists() {
        Ok(false) => Ok(()),
        Ok(true) => Err(CommandError::Exists { path: path.to_owned() }),
        Err(cause) => Err(CommandError::Write { path: path.to_owned(), cause }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The program has every example that the repository has.
    #[test]
    fn no_example_is_left_out() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let mut found = Vec::new();
        let mut folders = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_none_or(|extension| extension != "svg") {
                    let path = path.strip_prefix(&root).unwrap();
                    found.push(path.to_str().unwrap().replace('\\', "/"));
                }
            }
        }
        found.sort();
        let own: Vec<_> = EXAMPLES.iter().map(|(path, _)| (*path).to_owned()).collect();
        assert_eq!(own, found);
    }
}
